r"""The superbracket of joins of two points in any rank, read off its determinant.

In rank n the superbracket of N = n(n − 1)/2 lines is the determinant whose rows are the lines' Plücker coordinates
p_ij = a_i b_j − a_j b_i in the order 12, 13, …; it has 2N = n(n − 1) points in n − 1 brackets.

* A point a of more than n − 1 lines makes it zero. With exactly n − 1 lines ax, ay, … it is
  [[ax, ay, …, L, M, …]] = [axy…] · [[L, M, …]], the second factor in the quotient by a, of rank n − 1, where the
  bracket of y, z, … is [ayz…] (choose a as the first basis vector: the determinant is then block triangular).
* What is left is written in standard tableaux: a bracket polynomial is known from its coefficients at the diagonal
  monomials of the standard tableaux (see `diagonal`), which form a unitriangular system of integers. A coefficient of
  the determinant is a signed count of the ways to give every line a pair of coordinates of its own; a coefficient of a
  tableau that of the ways to rearrange its rows. Points are dealt with one after another, like partial results added.

The points are taken in an order that keeps few lines open, so the result is not the normal form in the order of the
tableaux; it is usually shorter. Derived here.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Sequence
from functools import cache
from heapq import heapify, heappop, heappush
from itertools import combinations

from gcrules.algebra.bracket import Monomial, Row, Terms, sorted_row
from gcrules.core.linear_algebra import permutation_sign

__all__ = ["Pair", "determinant_terms"]

Pair = tuple[int, int]
Worked = Callable[[int], None]

_FIELD = 4  # bits of a number below 16: a power of a coordinate, or the height of a column (both below the rank)
_COLUMN = (1 << _FIELD) - 1
_KEPT = 4  # what a partial result that is kept counts for, since it takes memory too


def determinant_terms(lines: Sequence[Pair], rank: int, worked: Worked = lambda states: None) -> Terms:
    """The superbracket of n(n − 1)/2 lines, each the join of two points given by their numbers, in rank n.

    `worked` is told the number of partial results as they are made; it may raise to stop.

    >>> sorted(determinant_terms([(0, 1), (2, 3), (4, 5)], 3).items())
    [(((0, 1, 2), (3, 4, 5)), -1), (((0, 1, 3), (2, 4, 5)), 1)]
    """
    if not lines:
        return {(): 1}
    if any(a == b for a, b in lines) or len({frozenset(line) for line in lines}) < len(lines):
        return {}
    degree, most = Counter(p for line in lines for p in line).most_common(1)[0][::-1]
    if degree > rank - 1:
        return {}
    if degree == rank - 1:
        return _peeled(lines, rank, most, worked)
    order = _sequence(lines)
    place = {p: i for i, p in enumerate(order)}
    sign, terms = 1, {}
    renamed = []
    for a, b in lines:
        sign *= 1 if place[a] < place[b] else -1
        renamed.append((min(place[a], place[b]), max(place[a], place[b])))
    for tableau, c in _standard(renamed, rank, worked).items():
        s, monomial = _renamed(tableau, order)
        terms[monomial] = s * sign * c
    return terms


def _peeled(lines: Sequence[Pair], rank: int, point: int, worked: Worked) -> Terms:
    """The bracket of the lines through a point of rank − 1 lines, times the superbracket in the quotient by it."""
    through = [i for i, line in enumerate(lines) if point in line]
    others = [i for i, line in enumerate(lines) if point not in line]
    sign = permutation_sign(through + others)
    ends = []
    for i in through:
        a, b = lines[i]
        sign *= 1 if a == point else -1
        ends.append(b if a == point else a)
    s, first = sorted_row((point, *ends))
    sign *= s
    terms: Terms = {}
    for m, c in determinant_terms([lines[i] for i in others], rank - 1, worked).items():
        lifted = [sorted_row((point, *row)) for row in m]
        outer = sign
        for s, _ in lifted:
            outer *= s
        terms[tuple(sorted((first, *(row for _, row in lifted))))] = outer * c
    return terms


def _renamed(tableau: Monomial, names: Sequence[int]) -> tuple[int, Monomial]:
    sign, rows = 1, []
    for row in tableau:
        s, r = sorted_row(names[i] for i in row)
        sign *= s
        rows.append(r)
    return sign, tuple(sorted(rows))


def _sequence(lines: Sequence[Pair]) -> tuple[int, ...]:
    """An order of the points in which few lines have one point behind and one ahead, the best of one greedy walk from
    each point.
    """
    near: dict[int, list[int]] = defaultdict(list)
    for a, b in lines:
        near[a].append(b)
        near[b].append(a)

    def walk(first: int) -> tuple[list[int], tuple[int, ...]]:
        gone: dict[int, int] = {}
        opened, sizes = 0, []
        while len(gone) < len(near):

            def change(p: int) -> tuple[int, int, int]:
                closed = [gone[q] for q in near[p] if q in gone]
                return len(near[p]) - 2 * len(closed), min(closed, default=len(gone)), p

            p = min((q for q in near if q not in gone), key=change) if gone else first
            opened += change(p)[0]
            gone[p] = len(gone)
            sizes.append(opened)
        return sorted(sizes, reverse=True), tuple(gone)

    return min(map(walk, sorted(near)))[1]


# --- the triangular system -----------------------------------------------------------------------------------------


def _standard(lines: Sequence[Pair], rank: int, worked: Worked) -> Terms:
    """The combination of standard tableaux that has the determinant's coefficients, largest monomial first."""
    letters = 1 + max(b for _, b in lines)
    wanted = _of_determinant(lines, rank, letters, worked)
    heap = [-code for code in wanted]
    heapify(heap)
    found: Terms = {}
    while heap:
        code = -heappop(heap)
        c = wanted.pop(code)
        if not c:
            continue
        tableau = _tableau(code, rank, letters)
        found[tableau] = c
        for other, k in _of_tableau(tableau, rank, letters, worked).items():
            if other == code:
                continue
            if other not in wanted:
                wanted[other] = 0
                heappush(heap, -other)
            wanted[other] -= c * k
    return found


@cache
def _units(rank: int, letters: int) -> tuple[Row, ...]:
    """Codes of the coordinates x[p, c]: codes of monomials compare as these do in the lexicographic order."""
    last = letters * rank - 1
    return tuple(tuple(1 << _FIELD * (last - p * rank - c) for c in range(rank)) for p in range(letters))


def _tableau(code: int, rank: int, letters: int) -> Monomial:
    columns: list[list[int]] = [[] for _ in range(rank)]
    at = _FIELD * letters * rank
    for p in range(letters):
        for column in columns:
            at -= _FIELD
            column += [p] * (code >> at & _COLUMN)
    return tuple(zip(*columns, strict=True))


def _room(heights: int, rank: int) -> int:
    """How often one point can be put on each column, so that the rows keep increasing strictly: the height of the
    column before (rank − 1 at most) minus its own, in all fields at once.
    """
    return ((heights << _FIELD) + rank - 1 - heights) & (1 << _FIELD * rank) - 1


@cache
def _free(row: int, rank: int) -> tuple[tuple[int, int, bool], ...]:
    """The places of a row that are not taken: column, height of one there, whether it stands behind an odd number."""
    return tuple((j, 1 << _FIELD * j, bool((row >> j).bit_count() & 1)) for j in range(rank) if not row >> j & 1)


_Way = tuple[int, int, "_State"]  # what is added to the code, the sign, and the state then
_State = tuple[int, Row]  # the pairs of coordinates used; the coordinates of the first points of the open lines


def _of_determinant(lines: Sequence[Pair], rank: int, letters: int, worked: Worked) -> dict[int, int]:
    """The coefficients of the superbracket at the monomials of standard tableaux."""
    start: _State = (0, ())
    ways = _ways(lines, rank, letters, start, worked)
    order = sorted(range(len(lines)), key=lambda k: lines[k][::-1])  # as they are closed
    known: dict[_State, dict[int, int]] = {start: {0: permutation_sign(order)}}
    for level in ways:
        new: dict[_State, dict[int, int]] = {}
        made = 0
        for state, codes in known.items():
            for added, sign, after in level.get(state, ()):
                into = new.setdefault(after, {})
                for code, c in codes.items():
                    into[code + added] = into.get(code + added, 0) + sign * c
                made += len(codes)
        worked(_KEPT * made)
        known = new
    return {code: c for codes in known.values() for code, c in codes.items() if c}


def _ways(
    lines: Sequence[Pair], rank: int, letters: int, start: _State, worked: Worked
) -> list[dict[_State, list[_Way]]]:
    """For each point the ways to give it coordinates, from each state that can be reached and that leads to the end."""
    units, columns = _units(rank, letters), _free(0, rank)
    number = {p: q for q, (i, j) in enumerate(combinations(range(rank), 2)) for p in ((i, j), (j, i))}
    levels: list[dict[_State, list[_Way]]] = []
    states, opened = {start: 0}, list[Pair]()  # with the heights of the columns; the lines that are open there
    for p in range(letters):
        unit, level, after = units[p], dict[_State, list[_Way]](), dict[_State, int]()
        closing = sorted((k for k, line in enumerate(opened) if line[1] == p), key=opened.__getitem__)
        kept = [k for k in range(len(opened)) if k not in closing]
        starting = [line for line in lines if line[0] == p]
        opened = [opened[k] for k in kept] + starting
        for (used, first), heights in states.items():
            found = [(0, 1, used, heights, _room(heights, rank))]
            for k in closing:
                i, further = first[k], []
                for code, sign, used1, heights1, room in found:
                    for j, one, _ in columns:
                        if j != i and room & one * _COLUMN and not used1 >> (q := number[i, j]) & 1:
                            odd = (i > j) ^ (used1 >> q).bit_count() & 1
                            further.append(
                                (code + unit[j], -sign if odd else sign, used1 | 1 << q, heights1 + one, room - one)
                            )
                found = further
            rest = tuple(first[k] for k in kept)
            ends = [(*way, rest) for way in found]
            for _ in starting:
                ends = [
                    (code + unit[j], sign, used1, heights1 + one, room - one, (*behind, j))
                    for code, sign, used1, heights1, room, behind in ends
                    for j, one, _ in columns
                    if room & one * _COLUMN
                ]
            level[used, first] = [(code, sign, (used1, behind)) for code, sign, used1, _, _, behind in ends]
            after |= {(used1, behind): heights1 for _, _, used1, heights1, _, behind in ends}
            worked(_KEPT * len(ends))
        levels.append(level)
        states = after
    alive = set(states)
    for level in reversed(levels):
        for state in list(level):
            level[state] = [way for way in level[state] if way[2] in alive]
            if not level[state]:
                del level[state]
        alive = set(level)
    return levels


def _of_tableau(tableau: Monomial, rank: int, letters: int, worked: Worked) -> dict[int, int]:
    """The coefficients of a tableau at the monomials of standard tableaux: its rows rearranged, with signs.

    A state holds the places taken (row r, column c: bit r · rank + c) and the heights of the columns.
    """
    units, full = _units(rank, letters), (1 << rank) - 1
    rows_of = [[r * rank for r, row in enumerate(tableau) if p in row] for p in range(letters)]
    known: dict[Pair, dict[int, int]] = {(0, 0): {0: 1}}
    for unit, rows in zip(units, rows_of, strict=True):
        new: dict[Pair, dict[int, int]] = {}
        made = 0
        for (taken, heights), codes in known.items():
            ways = [(0, 1, taken, heights, _room(heights, rank))]
            for r in rows:
                ways = [
                    (added + unit[j], -sign if odd else sign, taken1 | 1 << r + j, heights1 + one, room - one)
                    for added, sign, taken1, heights1, room in ways
                    for j, one, odd in _free(taken1 >> r & full, rank)
                    if room & one * _COLUMN
                ]
            for added, sign, taken1, heights1, _ in ways:
                into = new.setdefault((taken1, heights1), {})
                for code, c in codes.items():
                    into[code + added] = into.get(code + added, 0) + sign * c
            made += len(ways) * len(codes)
        worked(made)
        known = new
    return {code: c for codes in known.values() for code, c in codes.items() if c}
