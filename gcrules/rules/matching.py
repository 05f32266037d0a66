r"""Matching: where the left side of an identity stands in a bracket polynomial or in an expression.

Brackets and joins are alternating, products commute, meets commute up to sign; all this is taken into account. A point
of the pattern may stand for any point (in expressions: for anything of step 1), two of them for the same one. A letter
for a line, a plane or a hyperplane stands for any extensor of its step, or for several parts of a join.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations, permutations

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.linear import is_extensor
from gcrules.algebra.bracket import Monomial, Row, sorted_row
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Number, Point, Power, Product, Sum, Superbracket
from gcrules.algebra.letters import named_letter, split_letters, wholes
from gcrules.core.budget import Count
from gcrules.core.linear_algebra import permutation_sign

__all__ = ["MAX_TRIALS", "match_monomial", "matches", "trials"]

MAX_TRIALS = 200_000

Binding = dict[str, int]
Values = Mapping[str, Expr]


def trials(most: int = MAX_TRIALS) -> Count:
    """Counts trials, so that matching ends."""
    return Count(most, "matching a rule takes", "trials")


# --- bracket monomials ---------------------------------------------------------------------------------------------


def match_monomial(
    pattern: Sequence[tuple[str, ...]], monomial: Monomial, run_of: Mapping[str, str], count: Count
) -> Iterator[tuple[Binding, int, tuple[int, ...]]]:
    """Bindings of names to points under which each row of the pattern is a bracket of its own of the monomial.

    Yields the binding, the sign of the brackets found against those of the pattern, and which brackets they are.
    `run_of` tells which run a name belongs to: the points of a run can be bound in one sequence only.
    """

    def walk(
        rows: Sequence[tuple[str, ...]], binding: Binding, sign: int, used: tuple[int, ...]
    ) -> Iterator[tuple[Binding, int, tuple[int, ...]]]:
        if not rows:
            yield binding, sign, used
            return
        seen: set[Row] = set()
        for i, row in enumerate(monomial):
            if i in used or row in seen:
                continue
            seen.add(row)
            for found in _bindings(rows[0], row, binding, run_of, count):
                s, _ = sorted_row(found[n] for n in rows[0])
                yield from walk(rows[1:], found, sign * s, (*used, i))

    yield from walk(pattern, {}, 1, ())


def _bindings(
    names: tuple[str, ...], row: Row, binding: Binding, run_of: Mapping[str, str], count: Count
) -> Iterator[Binding]:
    """Extensions of a binding that take the names of a pattern's row onto the points of a bracket."""
    known = [binding[n] for n in names if n in binding]
    if len(set(known)) < len(known) or not set(known) <= set(row):
        return
    open_points = [p for p in row if p not in known]
    singles = [n for n in names if n not in binding and n not in run_of]
    runs: dict[str, list[str]] = {}
    for n in names:
        if n not in binding and n in run_of:
            runs.setdefault(run_of[n], []).append(n)
    for chosen in permutations(open_points, len(singles)):
        count.spend()
        rest = [p for p in open_points if p not in chosen]
        for shared in _shared(list(runs.values()), rest):
            yield {**binding, **dict(zip(singles, chosen, strict=True)), **shared}


def _shared(runs: list[list[str]], points: list[int]) -> Iterator[Binding]:
    if not runs:
        yield {}
        return
    for chosen in combinations(points, len(runs[0])):
        rest = [p for p in points if p not in chosen]
        for more in _shared(runs[1:], rest):
            yield {**dict(zip(runs[0], chosen, strict=True)), **more}


# --- expressions ---------------------------------------------------------------------------------------------------


def matches(pattern: Expr, target: Expr, rank: int, count: Count) -> Iterator[tuple[Values, int, tuple[Expr, ...]]]:
    """Ways to see the pattern in the top of an expression.

    Yields what its points stand for, the sign s, and the parts of a join, meet or product that are left over (behind
    what was matched): target = s · pattern · rest.
    """
    yield from _match(pattern, target, {}, rank, count, whole=False)


_Found = tuple[Values, int, tuple[Expr, ...]]


def _match(pattern: Expr, target: Expr, known: Values, rank: int, count: Count, *, whole: bool) -> Iterator[_Found]:
    count.spend()
    letter = named_letter(pattern)
    if letter is not None:
        if target.step == pattern.step and is_extensor(target, rank) and known.get(letter, target) == target:
            yield {**known, letter: target}, 1, ()
        return
    match pattern, target:
        case Point(name=name), _:
            if target.step == 1 and known.get(name, target) == target:
                yield {**known, name: target}, 1, ()
        case Number(), Number():
            if pattern == target:
                yield known, 1, ()
        case Join(args=a), Join(args=b):
            yield from _parts(wholes(a), b, known, rank, count, whole, lambda x: x.step, joins=True)
        case Meet(args=a), Meet(args=b):
            yield from _parts(a, b, known, rank, count, whole, lambda x: rank - x.step)
        case Bracket(args=a), Bracket(args=b):
            yield from _parts(wholes(a), b, known, rank, count, True, lambda x: x.step, joins=True)
        case Product(factors=a), Product(factors=b):
            yield from _parts(a, b, known, rank, count, whole, lambda x: 0)
        case Sum(terms=a), Sum(terms=b):
            yield from _sums(a, b, known, rank, count)
        case Superbracket(lines=a), Superbracket(lines=b):
            yield from _in_sequence(a, b, known, rank, count)
        case Power(base=a, exponent=n), Power(base=b, exponent=m):
            if n == m:
                yield from (f for f in _match(a, b, known, rank, count, whole=True) if f[1] == 1)


def _parts(
    pattern: tuple[Expr, ...],
    target: tuple[Expr, ...],
    known: Values,
    rank: int,
    count: Count,
    whole: bool,
    grade: Callable[[Expr], int],
    *,
    joins: bool = False,
) -> Iterator[_Found]:
    """Distinct parts of the target for the parts of the pattern, in any sequence; moving them costs a sign. Where the
    target `joins` its parts, several of them may be what a letter stands for.
    """
    lettered = joins and any(named_letter(part) is not None for part in pattern)
    if len(pattern) > len(target) or (whole and not lettered and len(pattern) != len(target)):
        return

    def walk(done: int, chosen: tuple[int, ...], known: Values, sign: int) -> Iterator[_Found]:
        if done == len(pattern):
            rest = tuple(i for i in range(len(target)) if i not in chosen)
            if whole and rest:
                return
            odd = [i for i in (*chosen, *rest) if grade(target[i]) % 2]
            yield known, sign * permutation_sign(odd), tuple(target[i] for i in rest)
            return
        for i, part in enumerate(target):
            if i not in chosen:
                for found, s, _ in _match(pattern[done], part, known, rank, count, whole=True):
                    yield from walk(done + 1, (*chosen, i), found, sign * s)
        if lettered and named_letter(pattern[done]) is not None:
            for several in _several(target, chosen, pattern[done].step):
                joined = ex.join(*(target[i] for i in several), rank=rank)
                for found, s, _ in _match(pattern[done], joined, known, rank, count, whole=True):
                    yield from walk(done + 1, (*chosen, *several), found, sign * s)

    yield from walk(0, (), known, 1)


def _several(target: Sequence[Expr], taken: Sequence[int], step: int) -> Iterator[tuple[int, ...]]:
    """Parts of a join that are of a step together, in one order wherever they stand, with all points of a letter or
    none.
    """
    left = sorted((i for i in range(len(target)) if i not in taken), key=lambda i: str(target[i]))
    for number in range(2, step + 1):
        for some in combinations(left, number):
            row = [a.name for i in some if isinstance(a := target[i], Point)]
            if sum(target[i].step for i in some) == step and not any(split_letters([row])):
                yield some


def _sums(
    pattern: tuple[Expr, ...], target: tuple[Expr, ...], known: Values, rank: int, count: Count
) -> Iterator[_Found]:
    """All terms of the target for those of the pattern, in any sequence, all of them with the same sign."""
    if len(pattern) != len(target):
        return

    def walk(chosen: tuple[int, ...], known: Values, sign: int) -> Iterator[_Found]:
        if len(chosen) == len(pattern):
            yield known, sign, ()
            return
        for i, part in enumerate(target):
            if i not in chosen:
                for found, s, _ in _match(pattern[len(chosen)], part, known, rank, count, whole=True):
                    if not chosen or s == sign:
                        yield from walk((*chosen, i), found, s)

    yield from walk((), known, 1)


def _in_sequence(
    pattern: tuple[Expr, ...], target: tuple[Expr, ...], known: Values, rank: int, count: Count
) -> Iterator[_Found]:
    if not pattern:
        yield known, 1, ()
        return
    for found, s, _ in _match(pattern[0], target[0], known, rank, count, whole=True):
        for more, t, _ in _in_sequence(pattern[1:], target[1:], found, rank, count):
            yield more, s * t, ()
