r"""A polynomial in brackets that is zero, written as a combination of exchange relations.

The exchange relation of two brackets says that [S][T] is the sum of the products in which the first k points of S
change places with k points of T, in every way (Grassmann–Plücker; see `syzygies`). Straightening applies nothing else,
so what it reduces to nothing is Σ multiplier · relation, which anyone can multiply out.

>>> from gcrules.algebra.expand import expand
>>> from gcrules.algebra.language.syntax import parse
>>> found = relations(expand(parse("[abc][def] - [dbc][aef] - [adc][bef] - [abd][cef]", rank=3)).terms)
>>> [(r.first, r.second, r.number, dict(r.multiplier)) for r in found]
[((0, 4, 5), (1, 2, 3), 1, {(): -1})]
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from heapq import heapify, heappop, heappush
from math import comb
from typing import Any

from gcrules.algebra.bracket import Coefficient, Monomial, Row, Terms, by_parameters
from gcrules.algebra.proofs.written import number
from gcrules.algebra.straightening.order import divided
from gcrules.algebra.straightening.straighten import Last, offence
from gcrules.algebra.straightening.syzygies import exchange
from gcrules.core.budget import Count, checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap

__all__ = ["MAX_RELATIONS", "Relation", "relations"]

MAX_RELATIONS = 200_000


@dataclass(frozen=True)
class Relation:
    """`multiplier` · ([first][second] − the sum of the products in which the first `number` points of `first` change
    places with points of `second`), which is zero.
    """

    first: Row
    second: Row
    number: int
    multiplier: Mapping[Monomial, Coefficient]

    def to_json(self, numbers: Sequence[int] = ()) -> list[Any]:
        """The relation as `proof.schema.json` describes it, with other numbers for the points of its rows if given."""

        def row(points: Row) -> list[int]:
            return [numbers[i] for i in points] if numbers and len(points) > 1 else list(points)

        return [
            row(self.first),
            row(self.second),
            self.number,
            [[number(c), *map(row, m)] for m, c in self.multiplier.items()],
        ]


def relations(
    terms: Mapping[Monomial, Coefficient], ideal: int = 0, limit: int = MAX_RELATIONS
) -> tuple[Relation, ...] | None:
    """Relations whose sum is a polynomial (`terms`); None where it is not zero.

    Rows whose points all come before `ideal` are zero; those of one entry are parameters. Raises LimitReached where
    more than `limit` products of brackets are exchanged.
    """
    found: dict[tuple[Row, Row, int], Terms] = defaultdict(dict)
    done = Count(limit, "the proof takes", "exchanges")
    kept = {m: c for m, c in terms.items() if c and not any(len(row) > 1 and row[-1] < ideal for row in m)}
    for parameters, brackets in by_parameters(kept).items():
        common, left = divided(brackets)
        if not _reduced(dict(left), common, parameters, ideal, found, done):
            return None
    return tuple(Relation(*key, FrozenMap(multiplier)) for key, multiplier in found.items())


def _reduced(
    pending: Terms,
    common: Monomial,
    parameters: Monomial,
    ideal: int,
    found: dict[tuple[Row, Row, int], Terms],
    done: Count,
) -> bool:
    """Whether a polynomial is reduced to nothing by relations, which, times what all terms have in common, are added to
    those `found`.
    """
    heap = [Last(m) for m in pending]
    heapify(heap)
    while heap:
        checkpoint()
        monomial = heappop(heap).monomial
        coefficient = pending.pop(monomial)
        if not coefficient:
            continue
        at = offence(monomial)
        if at is None:
            return False
        done.spend(1)
        one, other = monomial[at], monomial[at + 1]
        number = min(
            (j for j, (x, y) in enumerate(zip(one, other, strict=True)) if x > y), key=lambda j: comb(len(one), j)
        )
        rest = (*monomial[:at], *monomial[at + 2 :])
        multiplier = found[one, other, number]
        key = (*sorted(rest + common), *parameters)
        multiplier[key] = multiplier.get(key, 0) + coefficient
        for sign, (a, b) in exchange(one, other, number):
            if a[-1] < ideal:
                continue
            new = tuple(sorted((*rest, a, b)))
            if new in pending:
                pending[new] += sign * coefficient
            else:
                pending[new] = sign * coefficient
                heappush(heap, Last(new))
    return True
