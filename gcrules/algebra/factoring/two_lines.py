r"""Forms of two terms that compare the turns about two lines: c · P = (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g), in space.

g and h are joins of two points or line letters, p and q lines that joins and meets make of the other letters of P. If
one of the four lines is 0, so is the form: so g and h are pairs of points whose coincidence makes P vanish, and no join
in p or q holds two points that are apart. As for single expressions, what fails at a pair of positions modulo a prime
is refuted.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import combinations
from typing import Any

import numpy as np

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.brackets import vanishing_pairs
from gcrules.algebra.factoring.extensors import Extensors, Level, scalar, spread, wedge
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.matches import Oracle, constant_below, with_whole_letters
from gcrules.algebra.factoring.modular import Ints
from gcrules.algebra.factoring.residues import Floats, values
from gcrules.algebra.factoring.tree_letters import Letters, extensor
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import grouped, letter_of
from gcrules.core.budget import checkpoint
from gcrules.core.errors import LimitReached

__all__ = ["compared", "two_lines"]

_RANK = 4
_LINE = 2
_SEEDS = 20
_Pair = tuple[int, int]


def compared(p: Expr, q: Expr, g: Expr, h: Expr) -> Expr:
    """(p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g)."""
    return ex.sub(ex.mul(ex.meet(p, g), ex.meet(q, h)), ex.mul(ex.meet(p, h), ex.meet(q, g)))


def two_lines(poly: BracketPolynomial, effort: Effort) -> Expr | None:
    """The shortest of the expressions (p ∧ g)(q ∧ h) − (p ∧ h)(q ∧ g) that are multiples of a polynomial of space; None
    if there is none. Each holds at the test's positions and at two of the oracle's.

    Raises LimitReached, also where it is not excluded.
    """
    degrees = Counter(poly.degrees() or {})
    names = tuple(n for n in poly.points if n in degrees)
    own = poly.over(names)
    lines = sorted((a, b) for a, b in vanishing_pairs(own))
    apart = set(combinations(range(len(names)), 2)) - set(lines)
    lines = [(a, b) for a, b in lines if _line((names[a], names[b]))]
    oracle, found = Oracle(own), list[Expr]()
    for g, h in combinations(lines, 2):
        left = Counter(degrees)
        left.subtract(names[i] for i in (*g, *h))
        if min(left.values()) >= 0 and left.total() >= 2 * _LINE:
            letters = with_whole_letters(names, left, _RANK)
            found += [e for e in _for_single(own, letters, (g, h), effort.renewed(), apart) if oracle.confirms(e)]
    if not found and not constant_below(degrees.values(), _RANK):
        raise LimitReached("the constant between a form and the polynomial might be a multiple of the test's prime")
    return min(found, key=lambda e: (len(text(e, names=names)), text(e, names=names)), default=None)


def _line(ends: tuple[str, str]) -> bool:
    """Whether two points are a line that may stand alone: none belongs to a letter, or both are all points of one."""
    return not any(map(letter_of, ends)) or len(grouped(ends)) == 1


def _for_single(
    poly: BracketPolynomial, letters: Letters, single: tuple[_Pair, _Pair], effort: Effort, apart: set[_Pair]
) -> Iterator[Expr]:
    """The candidates for two lines g and h."""
    for seed in range(_SEEDS):
        extensors = Extensors(letters, seed=seed, effort=effort, apart=apart)
        at = values(poly, extensors.positions, extensors.field.p)
        if at.all():
            break
    else:
        raise LimitReached(f"the polynomial vanishes at {_SEEDS} random positions modulo {extensors.field.p}")
    g, h = (_join_of(extensors, line) for line in single)
    named = [extensor(("join", letters.names[a], letters.names[b]), _RANK) for a, b in single]
    for number in range(_LINE, letters.number // 2 + 1, _RANK):
        other = letters.number - number
        first, second = extensors.level(number), extensors.level(other)
        sides = [_met(extensors, level, line) for level in (first, second) for line in (g, h)]
        for i, j in _complementary(extensors, first, second, same=number == other):
            effort.multiply(len(i))
            for n in _multiples(extensors, sides, at, i, j):
                p, q = (extensor(extensors.tree(k, int(m[n])), _RANK) for k, m in ((number, i), (other, j)))
                yield compared(p, q, *named)


def _join_of(extensors: Extensors, line: _Pair) -> Floats:
    """A line through two points at all positions, of shape (coordinates, positions, 1)."""
    a, b = (np.moveaxis(extensors.positions[:, [i], :].astype(np.float64), 2, 0) for i in line)
    field = extensors.field
    return extensors.product(wedge(_RANK, 1, 1), field.reduced(a), field.reduced(b))


def _met(extensors: Extensors, level: Level, line: Floats) -> Floats:
    """The lines of a level met with a line, of shape (positions, number)."""
    v = level.at(slice(None))
    total = np.zeros(v.shape[1:])
    for i, j, sign in scalar(_RANK, _LINE):
        total += v[i] * line[j] * sign
    return extensors.field.reduced(total)


def _complementary(extensors: Extensors, a: Level, b: Level, *, same: bool) -> Iterator[tuple[Ints, Ints]]:
    """Places of all pairs that together have all letters."""
    codes, start, count = a.groups
    others, other_start, other_count = b.groups
    wanted = extensors.letters.all - codes
    place = np.searchsorted(others, wanted)
    there = np.flatnonzero(np.isin(wanted, others))
    k = place[there]
    for i, j in spread(start[there], count[there], other_start[k], other_count[k]):
        yield (i[i < j], j[i < j]) if same else (i, j)


def _multiples(extensors: Extensors, sides: list[Floats], at: Any, i: Ints, j: Ints) -> list[int]:
    """Which pairs compare the turns in the ratios of the polynomial's values."""
    checkpoint()
    field = extensors.field
    p_g, p_h, q_g, q_h = (side[:, m] for side, m in zip(sides, (i, i, j, j), strict=True))
    form = field.reduced(field.reduced(p_g * q_h) - field.reduced(p_h * q_g))
    known = [float(v) for v in at]
    alike = (form != 0).all(axis=0)
    for n in range(1, len(form)):
        difference = field.reduced(form[0] * known[n]) - field.reduced(form[n] * known[0])
        alike &= field.reduced(difference) == 0
    return [int(n) for n in np.flatnonzero(alike)]
