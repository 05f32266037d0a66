r"""Rules that find the entities of a bracket form: tetrahedra, planes, lines, and lines among the left-over points.

Each rule takes a state and yields the states it may lead to, most telling first; the procedure is that of Ben-Horin
et al. (2008), with the choices they leave to the user tried in turn.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

from gcrules.algebra.bracket import Row
from gcrules.rules.state import State

__all__ = ["left_over_lines", "lines", "planes", "tetrahedra"]


def tetrahedra(state: State) -> State:
    """Brackets common to all monomials are tetrahedra: the polynomial is their product times the rest."""
    monomials = list(state.rest.terms)
    common = Counter(monomials[0])
    for m in monomials[1:]:
        common &= Counter(m)
    found = tuple(sorted(common.elements()))
    terms = {}
    for m, c in state.rest.terms.items():
        remaining = list(m)
        for row in found:
            remaining.remove(row)
        terms[tuple(remaining)] = c
    rest = state.rest.with_terms(terms)
    return replace(state, rest=rest, tetrahedra=found, homes=((),) * len(rest))


def planes(state: State, number: int) -> Iterator[State]:
    """Triples that stay together in one bracket of every monomial, `number` of them in brackets of their own."""
    yield from _entities(state, _together(state, 3), number)


def lines(state: State, number: int) -> Iterator[State]:
    """Pairs that stay together in one bracket of every monomial, `number` of them in brackets of their own."""
    yield from _entities(state, _together(state, 2), number)


def _together(state: State, size: int) -> list[Row]:
    """The sets of points that some free bracket of every monomial holds."""
    common: set[Row] | None = None
    for monomial, taken in zip(state.rest.terms, state.homes, strict=True):
        here = {s for i, row in enumerate(monomial) if i not in taken for s in combinations(row, size)}
        common = here if common is None else common & here
    return sorted(common or ())


def _entities(state: State, candidates: list[Row], number: int) -> Iterator[State]:
    if number == 0:
        yield state
        return
    for n, row in enumerate(candidates):
        for grown in state.with_entity(row):
            yield from _entities(grown, candidates[n:], number - 1)


def left_over_lines(state: State) -> Iterator[tuple[Row, Row]]:
    """Four left-over points as two lines; pairs with P(x, y) + P(y, x) = 0 come first.

    The test decides when no point is repeated; a repeated point can hide a vanished monomial, so that every pairing
    stays a candidate (a claim made from it is proved or dropped).
    """
    found = []
    a, *others = state.left
    for b in others:
        rest = list(state.left)
        rest.remove(a)
        rest.remove(b)
        pairs = ((a, b), (rest[0], rest[1]))
        if a != b and rest[0] != rest[1]:
            found.append((-sum(state.swapped_sum(*p) for p in pairs), pairs))
    yield from (pairs for _, pairs in sorted(set(found)))
