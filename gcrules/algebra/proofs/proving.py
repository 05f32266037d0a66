r"""Claims with the proofs that a file has of them: by points that are placed, and in cases.

>>> from gcrules.algebra.language.syntax import parse_equation
>>> found = theorem("a line meets a plane", *parse_equation("ab /\\ cde == cde /\\ ab"))
>>> found.to_json()["claim"]
[['meet', ['join', 'a', 'b'], ['join', 'c', 'd', 'e']], ['meet', ['join', 'c', 'd', 'e'], ['join', 'a', 'b']]]
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from gcrules.algebra.assumptions.assumed import kinds
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import Expr, common_rank, points_of
from gcrules.algebra.proofs.cases import by_cases
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.algebra.prove import difference_of
from gcrules.algebra.space import Assumption, Space
from gcrules.core.errors import InputError

__all__ = ["theorem", "theorems"]


def theorem(
    name: str,
    left: Expr,
    right: Expr,
    *,
    ideal: Iterable[str] = (),
    rank: int | None = None,
    given: Iterable[Assumption] = (),
    limit: int = MAX_TERMS,
) -> Theorem:
    """The proof that two expressions are equal, under assumptions where there are any.

    Raises EngineFault where they are not equal, InputError where the proof cannot be written down yet, LimitReached
    where it is too long.
    """
    return next(theorems(name, left, right, ideal=ideal, rank=rank, given=given, limit=limit))


def theorems(
    name: str,
    left: Expr,
    right: Expr,
    *,
    ideal: Iterable[str] = (),
    rank: int | None = None,
    given: Iterable[Assumption] = (),
    limit: int = MAX_TERMS,
    in_cases: bool = True,
) -> Iterator[Theorem]:
    """The same, and one more theorem for each further kind of positions that comes of a symmetry of the assumptions:
    there other extensors must not vanish. Without `in_cases` no assumption is taken apart. Raises as `theorem` does.
    """
    assumptions, at_infinity = tuple(given), tuple(ideal)
    rank = common_rank(rank, left, right, *(e for a in assumptions for e in a.args))
    difference = difference_of(left, right, rank)
    found = kinds(Space(rank, (), at_infinity, assumptions), points_of(left, right), (difference,))
    own = [kind for kind in found if not kind.image]
    if len(own) > 1 and not in_cases:
        raise InputError(f"the assumptions allow {len(own)} kinds of positions")
    yield by_cases(name, left, right, own, limit, apart=in_cases)
    for kind in found:
        if kind.image:
            there = f"{name}, where {' and '.join(f'{e} == 0' for e in kind.where)}"
            c = replace(kind.construction, equations=own[0].construction.equations)
            yield by_cases(there, left, right, [replace(kind, construction=c)], limit, apart=in_cases)
