r"""Proof of everything the catalog says, from scratch, and the derivation of the list of classes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from importlib.resources import files
from itertools import combinations
from pathlib import Path
from typing import Any

from gcrules.algebra.certificate import Certificate
from gcrules.algebra.evaluate import PRIME, random_points, vanishes
from gcrules.algebra.expr import ZERO
from gcrules.algebra.language.legs_text import Leg, Structure
from gcrules.algebra.prove import prove
from gcrules.algebra.shortening.shorten import shorten
from gcrules.algebra.superbrackets.shortest import counts
from gcrules.conditions.analysis import analyze
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.files import write_file
from gcrules.core.linear_algebra import determinant
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import SHIPPED, CatalogIdentity, Entry
from gcrules.rules.catalog.proof_status import DIGESTS, counterexample, digests
from gcrules.rules.condition import Condition
from gcrules.rules.condition_rule import INCIDENCES
from gcrules.rules.recognition_state import extensor

__all__ = [
    "CheckResult",
    "check_digests",
    "check_entry",
    "enumerate_classes",
    "factors",
    "false_identities",
    "source_keys",
    "write_digests",
]

LEGS = 6
MOST_AT_A_JOINT = 3
FOUND = {rule.id for rule in INCIDENCES}
"""Kinds of condition that the rules of the engine find by themselves."""


_CLAIM = Certificate("none", "to be proved")


@dataclass(frozen=True)
class CheckResult:
    """What was found for one entry: `faults` is empty where everything holds; `proved` counts proved identities."""

    id: str
    place: str
    proved: int
    faults: tuple[str, ...]

    @property
    def ok(self) -> bool:
        return not self.faults

    def to_json(self) -> dict[str, Any]:
        return {"id": self.id, "place": self.place, "proved": self.proved, "faults": list(self.faults)}


def check_entry(entry: Entry) -> CheckResult:
    """Compute and prove what an entry says: degrees, numbers of terms, the shortest form, factors, group, status,
    sources, condition and readings (by normal forms), and that the rules of the engine arrive at a condition of the
    same kind.
    """
    structure = entry.structure
    found = analyze(structure)
    faults = [*_facts(entry, structure, regular=found.condition.kind != "always-singular")]
    proved = 0
    for reading in (entry.condition, *entry.readings):
        checkpoint()
        fault = _proved(reading, structure)
        faults += fault
        proved += not fault
    if found.group != entry.group and "group" not in entry.left_out:
        faults.append(f"group {entry.group or 'none'}, but the rules find {found.group or 'none'}")
    if entry.condition.kind in FOUND and entry.condition.kind != found.condition.kind:
        faults.append(f"a condition of kind {entry.condition.kind}, but the rules find {found.condition.kind}")
    return CheckResult(entry.id, entry.place, proved, tuple(faults))


def check_digests(shipped: Catalog) -> tuple[CheckResult, ...]:
    """What is wrong with the digests of the shipped catalog; nothing where they are those of what it says."""
    try:
        known = _digest_file().read_text(encoding="utf-8")
    except OSError as fault:
        known = str(fault)
    if known == digests(shipped.statements, shipped.entries):
        return ()
    lines = sorted(set(digests(shipped.statements, shipped.entries).splitlines()) ^ set(known.splitlines()))
    what = ", ".join(dict.fromkeys(line.partition("  ")[2] for line in lines[:_SHOWN])) or "in another sequence"
    why = (
        f"the digests are not those of {SHIPPED} ({what}); once everything is proved, run `gcrules catalog"
        " check --write`"
    )
    return (CheckResult("digests", f"gcrules/{DIGESTS}", 0, (why,)),)


def write_digests(shipped: Catalog) -> None:
    """Write the digests of the shipped catalog, of which everything was proved."""
    write_file(str(_digest_file()), digests(shipped.statements, shipped.entries))


def _digest_file() -> Path:
    return Path(str(files("gcrules").joinpath(DIGESTS)))


_SHOWN = 6


def false_identities(entry: Entry) -> list[str]:
    """What is wrong with the identities of an entry; nothing where all are proved."""
    return [fault for reading in (entry.condition, *entry.readings) for fault in _proved(reading, entry.structure)]


def _facts(entry: Entry, structure: Structure, *, regular: bool) -> Iterator[str]:
    if structure.degrees != entry.degrees:
        yield f"degrees {_lists(entry.degrees)}, computed {_lists(structure.degrees)}"
    terms = {form: min(n) for form, n in counts(structure.legs).items()}
    if terms != dict(entry.terms):
        yield f"terms {dict(entry.terms)}, computed {terms}"
    if entry.shortest is not None:
        found = shorten(structure.superbracket)
        if not found.minimal or found.terms != entry.shortest:
            least = found.terms if found.minimal else f"{found.lower} to {found.terms}"
            yield f"shortest {entry.shortest}, computed {least}"
    if regular == (entry.status == "always-singular"):
        yield f"status {entry.status}, but the superbracket is {'not ' * regular}identically zero"
    brackets = sorted(factors(structure)) if regular else []
    if brackets != sorted(tuple(sorted(f)) for f in entry.factors) and "factors" not in entry.left_out:
        yield f"factors {_brackets(entry.factors)}, computed {_brackets(brackets)}"
    for key in entry.sources if entry.owner == SHIPPED else ():
        if key not in source_keys():
            yield f"the source {key} is not in references.bib"


def _lists(degrees: Iterable[Iterable[int]]) -> str:
    return str([list(side) for side in degrees])


def _brackets(factors: Iterable[Iterable[str]]) -> str:
    return f"[{', '.join(str(extensor(tuple(f))) for f in factors)}]"


def factors(structure: Structure) -> Iterator[tuple[str, ...]]:
    """Brackets that divide the superbracket: those on whose zeros (a point moved into the plane of the other three,
    at exact random points) it vanishes too.
    """
    drawn = random_points(structure.names, seed=("factors", structure.text()))
    weights = [w for w, *_ in random_points("abc", seed=("weights", structure.text())).values()]
    fixed = [((a, b), _line(drawn[a], drawn[b])) for a, b in structure.legs]
    for *three, last in combinations(structure.names, 4):
        checkpoint()
        rows = zip(*(drawn[n] for n in three), strict=True)
        moved = tuple(sum(w * c for w, c in zip(weights, row, strict=True)) % PRIME for row in rows)
        at = {**drawn, last: moved}
        lines = (_line(at[a], at[b]) if last in (a, b) else line for (a, b), line in fixed)
        if not determinant(lines, PRIME):
            yield tuple(sorted((*three, last)))


def _line(a: Sequence[int], b: Sequence[int]) -> list[int]:
    return [(a[i] * b[j] - a[j] * b[i]) % PRIME for i, j in combinations(range(4), 2)]


def _proved(reading: CatalogIdentity, structure: Structure) -> list[str]:
    if vanishes(reading.cofactor):
        return [f"the cofactor {reading.cofactor_text} is identically zero, so the identity says nothing"]
    r = reading
    condition = Condition(r.kind, r.expression, r.meaning, _CLAIM, r.cofactor, r.coefficient)
    answer = prove(condition.identity(structure.superbracket), ZERO)
    if answer.proved:
        return []
    at = counterexample(answer)
    return [
        f"{answer.verdict}: {reading.cofactor_text} * superbracket = {reading.coefficient} * {reading.expression_text}"
        + (f" fails at {at}" if at else f" ({answer.reason})")
    ]


def source_keys() -> frozenset[str]:
    """The keys of the bibliography."""
    source = files("gcrules").joinpath("references.bib").read_text(encoding="utf-8")
    return frozenset(re.findall(r"^@\w+\{([^,]+),", source, flags=re.MULTILINE))


def enumerate_classes() -> tuple[tuple[Leg, ...], ...]:
    """All bipartite graphs of six legs, no two alike and at most three at a joint, up to exchanging the bodies.

    Grown leg by leg, keeping one of each kind (networkx decides which are alike). Base joints are A, B, …, platform
    joints a, b, …; the body with more joints is the base.
    """
    kinds: list[frozenset[tuple[int, int]]] = [frozenset()]
    for _ in range(LEGS):
        grown: list[frozenset[tuple[int, int]]] = []
        buckets: dict[Any, list[Any]] = {}
        for legs in kinds:
            checkpoint()
            for leg in _additions(legs):
                new = legs | {leg}
                graph = _graph(new)
                bucket = buckets.setdefault(_signature(new), [])
                if not any(_alike(graph, other) for other in bucket):
                    bucket.append(graph)
                    grown.append(new)
        kinds = grown
    return tuple(sorted((_lettered(legs) for legs in kinds), key=_sort_key))


def _additions(legs: frozenset[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    base, platform = ({leg[side] for leg in legs} for side in (0, 1))
    for b in range(len(base) + 1):
        for p in range(len(platform) + 1):
            full = any(sum(leg[side] == n for leg in legs) >= MOST_AT_A_JOINT for side, n in ((0, b), (1, p)))
            if (b, p) not in legs and not full:
                yield b, p


def _degrees(legs: frozenset[tuple[int, int]], side: int) -> tuple[int, ...]:
    joints = {leg[side] for leg in legs}
    return tuple(sorted((sum(leg[side] == n for leg in legs) for n in joints), reverse=True))


def _signature(legs: frozenset[tuple[int, int]]) -> tuple[tuple[int, ...], ...]:
    return tuple(sorted((_degrees(legs, 0), _degrees(legs, 1))))


def _graph(legs: frozenset[tuple[int, int]]) -> Any:
    from networkx import Graph

    graph: Any = Graph()
    for b, p in legs:
        graph.add_node(("base", b), side="base")
        graph.add_node(("platform", p), side="platform")
        graph.add_edge(("base", b), ("platform", p))
    return graph


def _alike(a: Any, b: Any) -> bool:
    from networkx import is_isomorphic

    same = is_isomorphic(a, b, node_match=lambda x, y: x["side"] == y["side"])
    return same or is_isomorphic(a, b, node_match=lambda x, y: x["side"] != y["side"])


def _lettered(legs: frozenset[tuple[int, int]]) -> tuple[Leg, ...]:
    """Letters for the joints, those with most legs first; the body with more joints is the base."""
    keys = [(-len(_degrees(legs, side)), _degrees(legs, side)) for side in (0, 1)]
    sides = (0, 1) if keys[0] <= keys[1] else (1, 0)
    pairs = {(leg[sides[0]], leg[sides[1]]) for leg in legs}
    upper, lower = (
        {n: chr(ord(first) + i) for i, n in enumerate(_by_degree(pairs, side))} for side, first in ((0, "A"), (1, "a"))
    )
    return tuple(sorted((upper[b], lower[p]) for b, p in pairs))


def _by_degree(pairs: set[tuple[int, int]], side: int) -> list[int]:
    joints = {leg[side] for leg in pairs}
    return sorted(joints, key=lambda n: (-sum(leg[side] == n for leg in pairs), n))


def _sort_key(legs: tuple[Leg, ...]) -> tuple[int, int, tuple[Leg, ...]]:
    base, platform = ({leg[side] for leg in legs} for side in (0, 1))
    return (-len(base), -len(platform), legs)
