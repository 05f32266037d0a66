r"""All incidences of a construction that hold and are not trivial, each proved or left undecided.

They are found at random positions modulo a prime, whole lines, planes and conics at a time; what follows at once from
what is given, from what names mean or from what was proved before is left out; the rest is proved by normal forms.

>>> from gcrules.algebra.language.statements import parse_script
>>> script = parse_script(r"rank 3  let x = bc' /\ b'c  let y = ca' /\ c'a  let z = ab' /\ a'b"
...                       "  given collinear(a, b, c), collinear(a', b', c')")
>>> for found in discover(script.context).found:
...     print(found.verdict, found.claim)
proved collinear(x, y, z)
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from gcrules.algebra.assumptions.assumed import PositionKind
from gcrules.algebra.assumptions.building import coinciding
from gcrules.algebra.assumptions.frame import zero_by
from gcrules.algebra.assumptions.nondegeneracy import chosen
from gcrules.algebra.decide import decide
from gcrules.algebra.discovery.exceptions import failing
from gcrules.algebra.discovery.figure import Figure, figure_of
from gcrules.algebra.discovery.holding import candidates, incidences
from gcrules.algebra.discovery.incidences import Incidence
from gcrules.algebra.discovery.known import Known, learn, unknown
from gcrules.algebra.discovery.limits import MAX_CANDIDATES, RELATIONS, SECONDS
from gcrules.algebra.discovery.placement import Placement, placement
from gcrules.algebra.discovery.result import Discoveries, Discovery, KindOfPositions
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import ZERO, Expr
from gcrules.algebra.language.relations import Claimed
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.letters import marked, marks_in
from gcrules.core.budget import report
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.hints import near

__all__ = ["asked", "discover"]

_SAMPLES = 3
_UNSAID = "it holds where something does not vanish that cannot be said in the points of the script"


def asked(relations: str | Iterable[str]) -> tuple[str, ...]:
    """The relations that are named, as one text or several; all if none is. Raises InputError for what is none."""
    named = tuple(relations.replace(",", " ").split() if isinstance(relations, str) else relations)
    for name in named:
        if name not in RELATIONS:
            hint = near(name, RELATIONS) or f"relations are {', '.join(RELATIONS)}"
            raise InputError(f"{name!r} is not a relation that is looked for", hint=hint)
    return named or RELATIONS


def discover(
    at: Context,
    *,
    relations: Sequence[str] = RELATIONS,
    limit: int = MAX_TERMS,
    most: int = MAX_CANDIDATES,
    seconds: float = SECONDS,
) -> Discoveries:
    """The incidences of the points that a script declares, assumes something of or defines by `let`, of the lines and
    planes that it defines or declares as letters, and of conics or quadrics that are letters.

    A proof that takes more than `limit` terms leaves an incidence undecided. For `seconds` positions are looked for at
    which what was found fails. Raises InputError in ranks other than 3 and 4, and for assumptions that are not
    resolved, as `prove` does; LimitReached for more than `most` candidates.
    """
    if at.rank not in (3, 4):
        hint = "they are looked for in the plane (rank 3) and in space (rank 4)"
        raise InputError(f"incidences are not looked for in rank {at.rank}", hint=hint)
    figure = figure_of(at)
    number = candidates(len(figure.points), len(figure.flats), at.rank, len(at.conics))
    if number > most:
        raise LimitReached(
            f"{len(figure.points)} points and {len(figure.flats)} named lines and planes give {number:,}"
            f" candidates, more than {most:,}",
            hint="raise the limit with --candidates (in Python candidates=...), or leave points out",
        )
    search = _Search(figure, limit)
    search.run()
    return search.answer([r for r in RELATIONS if r in relations], number, seconds)


class _Kind:
    """A kind of positions with the figure at some of its positions, and what is known of it.

    `told` is what is assumed not to vanish, in words with their meanings; None where that cannot be said, or not of
    this kind alone: then each incidence is decided as a claim.
    """

    def __init__(self, kind: PositionKind, placed: Placement, limit: int, alone: bool) -> None:
        self.construction = replace(
            kind.construction, nonzero=chosen(kind.construction.nonzero, kind.construction.rank)
        )
        self.kind, self.limit = replace(kind, construction=self.construction), limit
        self.placed, figure = placed, placed.figure
        self.where = tuple(map(placed.condition, kind.where)) if alone else ()
        self.spoken = {e: said for e in self.construction.nonzero if (said := placed.seated.spoken(e)) is not None}
        told = placed.seated.assumed(dict(self.spoken.values())) if alone else None
        self.told = None if told is None or any(map(marks_in, told)) else dict(told)
        self.claimed: dict[str, str] = {}
        seed = ("discover", *map(str, figure.bound.values()), *map(str, kind.where))
        drawn = (kind.construction.random_points((*seed, k)) for k in range(_SAMPLES))
        self.position, *self.others = map(placed.position, drawn)
        self.known = Known(self.position)
        self.known.begin(figure.space.given, map(placed.written, kind.where))
        self.found: dict[Incidence, _Verdict] = {}
        self.trivial = 0

    def look(self) -> None:
        """Find what holds at all these positions, and is not trivial."""
        for relation in RELATIONS:
            for whole in incidences(self.position, relation):
                i = unknown(whole, self.known)
                if i is None:
                    self.trivial += 1
                    continue
                report(i.text(self.position))
                verdict = self.verdict(i)
                if verdict.word == "proved":
                    learn(i, self.known)
                if verdict.word != "refuted":
                    self.found[i] = verdict

    def verdict(self, i: Incidence) -> _Verdict:
        """Whether an incidence holds at all positions of this kind."""
        if i not in self.found:
            self.found[i] = self._decided(i.equations(self.position))
        return self.found[i]

    def _decided(self, equations: Sequence[Expr]) -> _Verdict:
        if not all(p.zero(e) for p in (self.position, *self.others) for e in equations):
            return _Verdict("refuted")
        if self.told is None:
            return self._as_claim(equations)
        for e in map(self.placed.put, equations):
            try:
                zero = zero_by(self.construction, e, partial(self._in_brackets, e), self.limit)
            except LimitReached as limited:
                return _Verdict("undecided", limited.message)
            if not zero:
                return _Verdict("refuted")
        return _Verdict("proved")

    def _in_brackets(self, e: Expr, most: int) -> bool:
        return self.construction.is_zero(e, limit=most)

    def _as_claim(self, equations: Sequence[Expr]) -> _Verdict:
        proof = decide(Claimed(tuple((e, ZERO) for e in equations)), self.position.figure.space, limit=self.limit)
        if not proof.proved:
            return _Verdict(proof.verdict, proof.reason)
        if any(map(marks_in, proof.assumed)):
            return _Verdict("undecided", _UNSAID)
        self.claimed |= dict(zip(proof.assumed, proof.meanings or [""] * len(proof.assumed), strict=True))
        return _Verdict("proved")

    @property
    def tried(self) -> Mapping[Expr, str]:
        """What is assumed not to vanish of what the construction divides by, each with its text."""
        return {e: said for e, (said, _) in self.spoken.items() if said in (self.told or {})}

    def shown(self, tried: Iterable[Expr], shown: Collection[Incidence]) -> KindOfPositions:
        figure = self.position.figure
        assumed = dict(self.claimed if self.told is None else self.told)
        together = coinciding(self.construction, self.placed.seated.space.given)
        involved = {n for i in shown for n in i.involved}
        assumed |= figure.required(involved, {n for i in shown for n in i.on_circle(figure)})
        return KindOfPositions(
            self.where,
            tuple(assumed),
            tuple(assumed.values()),
            tuple(self.tried[e] for e in tried),
            tuple(pair for pair in together if not any(map(marked, pair))),
            tuple(n for n in (*figure.points, *figure.flats) if n in self.position.vanishing),
        )


@dataclass(frozen=True)
class _Verdict:
    word: str
    reason: str = ""


class _Search:
    """The search in one figure."""

    def __init__(self, figure: Figure, limit: int) -> None:
        self.figure = figure
        self.placed = placement(figure)
        found = self.placed.kinds()
        alone = len(found) == 1 or (
            self.placed.seated.alone is None
            and not any(marks_in(self.placed.condition(e)) for k in found for e in k.where)
        )
        self.kinds = [_Kind(k, self.placed, limit, alone) for k in (found if alone else found[:1])]

    def run(self) -> None:
        for kind in self.kinds:
            kind.look()

    def answer(self, relations: Sequence[str], number: int, seconds: float) -> Discoveries:
        at = self.figure.space
        seen = dict.fromkeys(i for k in self.kinds for i in k.found if i.relation in relations)
        of_each = {i: [k.verdict(i) for k in self.kinds] for i in seen}
        verdicts = {i: some for i, some in of_each.items() if any(v.word != "refuted" for v in some)}
        told = tuple(verdicts)
        fails: dict[Incidence, dict[str, None]] = {i: {} for i in told}
        shown = []
        for k in self.kinds:
            proved = [i for i in told if k.verdict(i).word == "proved"]
            claims = [tuple(map(self.placed.put, i.equations(k.position))) for i in proved]
            space, extensors = self.placed.seated.space, tuple(k.tried)
            tried, failed = failing(space, k.kind, extensors, self.placed.nonzero, claims, seconds / len(self.kinds))
            shown.append(k.shown(tried, told))
            for i, es in zip(proved, failed, strict=True):
                fails[i].update(dict.fromkeys(k.tried[e] for e in es))
        found = [self.discovery(i, verdicts[i], tuple(fails[i])) for i in told]
        return Discoveries(
            found=tuple(sorted(found, key=_order)),
            kinds=tuple(shown),
            points=self.figure.points,
            flats=self.figure.flats,
            conics=at.conics,
            relations=tuple(relations),
            candidates=number,
            trivial=sum(k.trivial for k in self.kinds),
            samples=_SAMPLES,
            rank=at.rank,
            ideal=at.ideal,
            given=at.given,
        )

    def discovery(self, i: Incidence, verdicts: Sequence[_Verdict], fails: tuple[str, ...]) -> Discovery:
        position = next(k.position for k, v in zip(self.kinds, verdicts, strict=True) if v.word != "refuted")
        named = (*self.figure.points, *self.figure.flats, *self.figure.space.conics)
        names = tuple(n for n in named if n in i.involved)
        return Discovery(
            relation=i.relation,
            claim=i.text(position),
            names=names,
            defined=sum(n in self.figure.bound for n in names),
            equations=i.expressions(position),
            verdicts=tuple(v.word for v in verdicts),
            fails=fails,
            reason=next((v.reason for v in verdicts if v.reason), ""),
        )


def _order(d: Discovery) -> tuple[Any, ...]:
    return -d.defined, len(d.names), RELATIONS.index(d.relation), d.claim
