r"""The catalog of six-legged platforms as values: matching a structure to its class, instances of its identities.

`file` reads it; `conditions.catalog_check` proves what it says.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import replace

from gcrules.algebra.certificate import Certificate
from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.parts import substitute
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, FileError
from gcrules.core.frozen import FrozenMap
from gcrules.core.linear_algebra import permutation_sign
from gcrules.rules.catalog.entries import SHIPPED, CatalogIdentity, Entry
from gcrules.rules.catalog.isomorphism import isomorphism
from gcrules.rules.catalog.proof_status import ProofStatus, is_shipped, proof_status
from gcrules.rules.claims import certify
from gcrules.rules.condition import Condition
from gcrules.rules.random_witness import SAMPLES, RandomWitness

__all__ = ["FIVE_LEG_SCREW", "FROM_CATALOG", "LABELS", "Catalog", "Match"]


@dataclass(frozen=True)
class Match:
    """A structure found in the catalog; `mapping` takes the class's labels to the structure's."""

    entry: Entry
    mapping: Mapping[str, str]

    def sign(self, structure: Structure) -> int:
        """superbracket(structure) = sign · superbracket(class) with the labels mapped."""
        position = {frozenset(leg): i for i, leg in enumerate(structure.legs)}
        order, turned = [], 0
        for a, b in self.entry.legs:
            image = (self.mapping[a], self.mapping[b])
            order.append(position[frozenset(image)])
            turned += structure.legs[order[-1]] != image
        return -permutation_sign(order) if turned % 2 else permutation_sign(order)


@dataclass(frozen=True)
class Catalog:
    """Entries of one or several files, and the templates of statements by kind of condition; `statement_sources` names
    the files of those that are not gcrules' own.
    """

    entries: tuple[Entry, ...]
    statements: Mapping[str, str]
    statement_sources: Mapping[str, str] = FrozenMap()

    def __getitem__(self, class_id: str) -> Entry:
        """Raises KeyError for an id that is not there."""
        return next((e for e in self.entries if e.id == class_id), None) or _missing(class_id)

    def matches(self, structure: Structure) -> Iterator[Match]:
        """The entries whose graph is isomorphic to the structure's, sides kept or exchanged as wholes."""
        if structure.rank != 4 or len({frozenset(leg) for leg in structure.legs}) < len(structure.legs):
            return
        degrees = _degrees(structure)
        for entry in self.entries:
            if _degrees(entry.structure) == degrees:
                mapping = isomorphism(entry.structure, structure)
                if mapping:
                    yield Match(entry, FrozenMap(mapping))

    def match(self, structure: Structure) -> Match | None:
        """The first of the `matches`; shipped classes come before the user's own."""
        return next(self.matches(structure), None)

    def dropped(self, structure: Structure, match: Match, oracle: RandomWitness) -> list[Expr]:
        """The cofactors of the class's identities that are zero wherever the points of a special position may be."""
        if not structure.special:
            return []
        names: dict[str, Expr] = {a: Point(b) for a, b in match.mapping.items()}
        cofactors = (substitute(r.cofactor, names) for r in (match.entry.condition, *match.entry.readings))
        return [e for e in dict.fromkeys(cofactors) if oracle.zero(e)]

    def readings(
        self, structure: Structure, match: Match, oracle: RandomWitness, *, recheck: bool = False
    ) -> list[Condition]:
        """The identities of the matched class in the structure's labels, each proved and checked afresh at exact random
        points (proved from scratch with `recheck`). The condition itself comes first unless a rule of the engine finds
        it. Left out are those whose cofactor is zero wherever the points of a special position may be.

        Raises FileError where an identity of a catalog is false.
        """
        entry, sign = match.entry, match.sign(structure)
        names: dict[str, Expr] = {a: Point(b) for a, b in match.mapping.items()}

        def relabelled(e: Expr) -> Expr:
            return substitute(e, names)

        own = entry.condition
        found = []
        use_own = own.kind in FROM_CATALOG or entry.owner != SHIPPED
        for reading in ([own] if use_own else []) + list(entry.readings):
            known = proof_status(entry, reading)
            expression, cofactor = map(relabelled, (reading.expression, reading.cofactor))
            condition = Condition(
                kind=reading.kind,
                expression=expression,
                cofactor=cofactor,
                coefficient=sign * reading.coefficient,
                meaning=reading.meaning.with_flats(lambda e: substitute(e, names, rank=8)),
                statement_source="" if is_shipped(entry, reading) else f"{entry.owner}, class {entry.id}",
                certificate=_UNPROVED,
                lines=tuple((name, relabelled(e)) for name, e in reading.lines),
            )
            if structure.special and oracle.zero(cofactor):
                continue
            if structure.ideal and reading.kind == FIVE_LEG_SCREW:  # speaks of lengths and turns
                continue
            if oracle.zero(cofactor) or not oracle.zero(condition.identity(structure.superbracket)):
                raise _false(condition, known, reading, entry)
            if recheck:
                found.append(certify(condition, structure, claimed_by=condition.statement_source))
            else:
                found.append(replace(condition, certificate=_certificate(condition, known, reading, match, structure)))
        return found


def _certificate(
    condition: Condition, known: ProofStatus, reading: CatalogIdentity, match: Match, structure: Structure
) -> Certificate:
    """How sure an instance of an identity is, which holds at the points of the oracle."""
    entry, construction = match.entry, structure.construction
    data = {"class": entry.id, "mapping": match.mapping, "digest": known.digest}
    whose = entry.id if known.verdict == "shipped" else f"{entry.id} of {entry.owner}"
    identity = condition.identity(structure.superbracket)
    if known.verdict != "unproved":
        sure = f"holds at {SAMPLES} exact random points, {construction.error_below(identity, SAMPLES)}"
        detail = f"instance of an identity of class {whose}, {known.detail}; {sure}"
        return Certificate("catalog-instance", detail, data | {"points": SAMPLES})
    if not construction.vanishes(identity, samples=_FURTHER):
        raise _false(condition, known, reading, entry)
    sure = f"holds at {_FURTHER} exact random points, {construction.error_below(identity, _FURTHER)}"
    detail = f"claimed by {entry.owner}, class {entry.id}; unproved; {sure}; no proof: {known.detail}"
    return Certificate("random-points", detail, data | {"points": _FURTHER})


def _false(condition: Condition, known: ProofStatus, reading: CatalogIdentity, entry: Entry) -> Exception:
    """The fault of an identity that does not hold at exact random points: of the catalog, unless it was proved."""
    if known.verdict != "unproved":
        return EngineFault(f"the identity of class {entry.id} does not hold for its instance {condition}")
    why = (
        f"the reading {reading.expression_text} of class {entry.id} is not an identity: it fails at exact random points"
    )
    return FileError(why, filename=reading.place or entry.place)


FIVE_LEG_SCREW = "five-leg-screw"
"""The kind that tells what five legs leave free, and stands beside a condition; it is none by itself."""

FROM_CATALOG = ("transversals", "one-incidence", FIVE_LEG_SCREW)  # kinds of which the catalog has identities of its own
_FURTHER = 3  # points for what has no proof
_UNPROVED = Certificate("none", "claimed by a catalog")


def _missing(class_id: str) -> Entry:
    raise KeyError(class_id)


LABELS = r"\{([\w']+)\}"


def _degrees(structure: Structure) -> list[int]:
    return sorted(Counter(n for leg in structure.legs for n in leg).values())
