"""Scalars built from extensors: brackets, dotted brackets, superbrackets and powers, with their sizes checked."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain, combinations
from math import comb, factorial, prod

from gcrules.algebra.expr import ZERO, Bracket, Dotted, Expr, Join, Number, Point, Power, Superbracket, add, mul
from gcrules.algebra.names import step_name
from gcrules.core.errors import LimitReached, StepError
from gcrules.core.linear_algebra import permutation_sign

__all__ = ["bracket", "dotted", "power", "superbracket", "written_out"]

MAX_EXPONENT = 64
MAX_DOTTED_TERMS = 50_000


def bracket(*args: Expr, rank: int = 4) -> Expr:
    """The bracket [A B …] of extensors whose steps add up to the rank. Raises StepError for any other size."""
    if any(a == ZERO for a in args):
        return ZERO
    flat = tuple(chain.from_iterable(a.args if isinstance(a, Join) else (a,) for a in args))
    total = sum(a.step for a in flat)
    if total != rank or any(a.step == 0 for a in flat):
        what = (
            f"{total} point{'' if total == 1 else 's'}" if all(isinstance(a, Point) for a in flat) else f"step {total}"
        )
        raise StepError(
            f"a bracket of {what}, expected {rank} in rank {rank}",
            hint=None
            if total == rank or not 2 <= total <= 8
            else f"for another rank say so: `rank {total}` in a file, --rank {total} in the shell",
        )
    return Bracket(flat)


def dotted(*brackets: Sequence[tuple[str, bool]], rank: int = 4) -> Expr:
    """A product of brackets of points, each (name, dotted?). Without any dot this is the plain product."""
    for entries in brackets:
        if len(entries) != rank:
            raise StepError(f"a bracket of {len(entries)} points, expected {rank} in rank {rank}")
    plain = [b for b in brackets if not any(d for _, d in b)]
    with_dots = tuple(tuple(b) for b in brackets if any(d for _, d in b))
    factors = [bracket(*(Point(n) for n, _ in entries), rank=rank) for entries in plain]
    return mul(*factors, Dotted(with_dots)) if with_dots else mul(*factors)


def superbracket(*lines: Expr, rank: int = 4) -> Expr:
    """The superbracket of n(n − 1)/2 lines in rank n: [[ab]], [[ab, cd, ef]], [[ab, cd, ef, gh, ij, kl]], …

    Raises StepError for any other number of lines, and for an entry that is no line.
    """
    found, expected = len(lines), comb(rank, 2)
    if found != expected:
        raise StepError(
            f"a superbracket of {found} line{'' if found == 1 else 's'}, expected {expected} in rank {rank}",
            hint=_rank_of_lines(found),
        )
    if any(a == ZERO for a in lines):
        return ZERO
    for i, a in enumerate(lines, 1):
        if a.step != 2:
            raise StepError(f"entry {i} of the superbracket is {step_name(a.step, rank)}, expected a line (step 2)")
    return Superbracket(tuple(lines))


def _rank_of_lines(number: int) -> str:
    """What to do with so many lines in a superbracket."""
    for rank in range(2, 9):
        if comb(rank, 2) == number:
            count = "1 line makes" if number == 1 else f"{number} lines make"
            return f"{count} a superbracket in rank {rank}: `rank {rank}` in a file, --rank {rank} in the shell"
    return "rank n takes n(n - 1)/2 lines: 3 in rank 3, 6 in rank 4, 10 in rank 5"


def power(base: Expr, exponent: int, rank: int = 4) -> Expr:
    """base ** exponent for a scalar and a non-negative integer exponent of at most 64."""
    if base.step != 0:
        raise StepError(f"a power of {step_name(base.step, rank)}; only scalars have powers")
    if exponent > MAX_EXPONENT:
        raise LimitReached(f"exponent {exponent} is above the limit {MAX_EXPONENT}")
    if exponent == 0:
        return Number(1)
    if exponent == 1:
        return base
    if isinstance(base, Number):
        return Number(base.value**exponent)
    return Power(base, exponent)


def written_out(e: Dotted) -> Expr:
    """The sum that the dots stand for. Raises LimitReached where it has too many terms."""
    names = [n for entries in e.brackets for n, d in entries if d]
    sizes = [sum(d for _, d in entries) for entries in e.brackets]
    if factorial(len(names)) // prod(map(factorial, sizes)) > MAX_DOTTED_TERMS:
        raise LimitReached(f"dotted brackets that stand for more than {MAX_DOTTED_TERMS:,} terms")
    terms = []
    for order in _deals(tuple(range(len(names))), sizes):
        moved = iter(names[i] for i in order)
        factors = [Bracket(tuple(Point(next(moved) if d else n) for n, d in entries)) for entries in e.brackets]
        terms.append(mul(Number(permutation_sign(order)), *factors))
    return add(*terms, rank=len(e.brackets[0]))


def _deals(cards: tuple[int, ...], sizes: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """All ways to deal the cards out into hands of these sizes, each hand in increasing order."""
    if not sizes:
        yield ()
        return
    for hand in combinations(cards, sizes[0]):
        for others in _deals(tuple(c for c in cards if c not in hand), sizes[1:]):
            yield (*hand, *others)
