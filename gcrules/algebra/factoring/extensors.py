r"""All extensors that joins and meets make of the points, by multidegree, as vectors modulo a prime at three positions.

An extensor of n letters in rank d has the step n mod d (n counts a point as often as it is used, and a given extensor
as so many points). Those of n letters are the joins and meets of those of fewer letters, and no scalar occurs on the
way.

Extensors that agree up to ONE constant at all positions are kept once, the simplest form of them; whatever is tested
at these positions only cannot tell them apart. Extensors that vanish at a position are dropped.

Two points that hang on one join make the whole expression vanish where they coincide. So two points whose coincidence
leaves the polynomial different from 0 are *apart*: no join holds both, in whatever form that is kept or not.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from functools import cached_property, reduce
from math import comb
from operator import or_
from typing import Any

import numpy as np

from gcrules.algebra.evaluate import Evaluator, Table, join_table, meet_table
from gcrules.algebra.factoring.limits import Effort
from gcrules.algebra.factoring.modular import Ints
from gcrules.algebra.factoring.residues import Floats, PrimeField, random_positions, residues
from gcrules.algebra.factoring.tree_letters import Letters, Tree, extensor
from gcrules.core.dataclass import dataclass

__all__ = [
    "CHUNK",
    "POSITIONS",
    "Extensors",
    "Level",
    "scalar",
    "spread",
    "wedge",
]

CHUNK = 1 << 16
POSITIONS = 3

_LETTER, _JOIN, _MEET = 0, 1, 2
_NAMES = {_JOIN: "join", _MEET: "meet"}

_Bits = tuple[Ints, Ints]


@dataclass(frozen=True)
class Level:
    """The extensors of one number of letters, ordered by multidegree (`code`).

    `vectors` has shape (coordinates, positions, number), 32 bits wide. `left` and `right` are places in the levels of
    `first` letters and of the rest; `cost` is the number of joins and meets, those of many arguments counted once.
    `twins` holds (place of the form kept, top, first, left, right) of the forms that were not kept. `joined` are the
    points, as bits, that the outermost join of every form joins, `barred` those that are apart from one of these.
    """

    step: int
    code: Ints
    vectors: np.ndarray[Any, np.dtype[np.int32]]
    top: Ints
    cost: Ints
    first: Ints
    left: Ints
    right: Ints
    twins: Ints
    joined: Ints
    barred: Ints

    def at(self, places: Ints | slice) -> Floats:
        """The vectors at some places, for computing."""
        return self.vectors[:, :, places].astype(np.float64)

    @cached_property
    def groups(self) -> tuple[Ints, Ints, Ints]:
        """The multidegrees that occur, where each begins, and how many extensors it has."""
        found, start, count = np.unique(self.code, return_index=True, return_counts=True)
        return found, start.astype(np.int64), count.astype(np.int64)

    def __len__(self) -> int:
        return len(self.code)


class Extensors:
    """The levels, built when asked for. `positions` has shape (3, points, rank); `apart` are pairs of points, by their
    places, that no join may hold together.
    """

    def __init__(
        self,
        letters: Letters,
        *,
        ideal: int = 0,
        seed: int = 0,
        effort: Effort | None = None,
        apart: Collection[tuple[int, int]] = (),
    ) -> None:
        self.letters = letters
        self.rank = letters.rank
        self.field: PrimeField = residues(letters.rank)
        self.effort = effort or Effort()
        self.positions = random_positions(
            POSITIONS, len(letters.names), letters.rank, self.field.p, ideal=ideal, seed=seed
        )
        self.levels: dict[int, Level] = {}
        self.bars = [0] * len(letters.names)
        for a, b in apart:
            self.bars[a] |= 1 << b
            self.bars[b] |= 1 << a

    def level(self, letters: int) -> Level:
        """The extensors of so many letters; the number must not be a multiple of the rank."""
        if letters not in self.levels:
            self.levels[letters] = self._level(letters)
        return self.levels[letters]

    def tree(self, letters: int, place: int) -> Tree:
        """The simplest form of an extensor."""
        level = self.levels[letters]
        top, first, left, right = (int(x[place]) for x in (level.top, level.first, level.left, level.right))
        return self._letter(left) if top == _LETTER else self._form(letters, top, first, left, right)

    def _letter(self, number: int) -> Tree:
        names = self.letters.names
        return names[number] if number < len(names) else self.letters.given[number - len(names)].tree

    def _form(self, letters: int, top: int, first: int, left: int, right: int) -> Tree:
        return _NAMES[top], self.tree(first, left), self.tree(letters - first, right)

    def forms(self, letters: int, place: int) -> Iterator[Tree]:
        """All forms that agree with an extensor at the positions, the one that is kept first."""
        yield self.tree(letters, place)
        level = self.levels[letters]
        if level.top[place] == _LETTER:
            return
        kept = [int(x[place]) for x in (level.top, level.first, level.left, level.right)]
        for top, first, left, right in [kept, *level.twins[level.twins[:, 0] == place, 1:].tolist()]:
            for a in self.forms(first, left):
                for b in self.forms(letters - first, right):
                    yield _NAMES[top], a, b

    def _given(self, letters: int) -> tuple[np.ndarray[Any, np.dtype[np.int32]], list[tuple[Ints, ...]]]:
        """The points, if asked for one letter, and the extensors given of so many: vectors, and the columns of a level
        (multidegree, top, cost, first, left, right, joined, barred).
        """
        names = self.letters.names
        places = [len(names) + i for i, given in enumerate(self.letters.given) if given.step == letters]
        if letters == 1:
            places = [*range(len(names)), *places]
        vectors = np.zeros((comb(self.rank, letters % self.rank), POSITIONS, len(places)))
        for k, position in enumerate(self.positions):
            at = Evaluator({n: x.tolist() for n, x in zip(names, position, strict=True)}, self.rank, self.field.p)
            for n, place in enumerate(places):
                vectors[:, k, n] = at.value(extensor(self._letter(place), self.rank))
        nonzero = vectors.any(axis=0).all(axis=0)
        vectors, places = vectors[:, :, nonzero], [places[i] for i in np.flatnonzero(nonzero)]
        none = np.zeros(len(places), dtype=np.int64)
        code = np.array([self.letters.units[i] for i in places], dtype=np.int64)
        points = [self._joined(place) for place in places]
        joined = np.array([sum(1 << i for i in some) for some in points], dtype=np.int64)
        barred = np.array([reduce(or_, (self.bars[i] for i in some), 0) for some in points], dtype=np.int64)
        columns = (code, none, none, none, np.array(places, dtype=np.int64), none, joined, barred)
        return self._normalised(self.field.reduced(vectors)), [columns] if places else []

    def _joined(self, place: int) -> tuple[int, ...]:
        """The points that a letter joins, by their places; none of a given extensor that is more than their join."""
        names = self.letters.names
        if place < len(names):
            return (place,)
        return tuple(map(names.index, self.letters.given[place - len(names)].points))

    def _level(self, letters: int) -> Level:
        """All extensors of so many letters: the joins and meets of two smaller ones, each once, that do not vanish."""
        first_vectors, found = self._given(letters)
        vectors = [first_vectors]
        for second in range(1, letters // 2 + 1):
            first = letters - second
            if first % self.rank == 0 or second % self.rank == 0:
                continue
            a, b = self.level(first), self.level(second)
            top = _JOIN if a.step + b.step < self.rank else _MEET
            table = wedge(self.rank, a.step, b.step)
            for i, j in self.pairs(a, b, same=first == second):
                # A join of two joins occurs as a join with one point after the other; likewise for meets.
                new = (a.top[i] != top) | (b.top[j] != top)
                if top == _JOIN:
                    new &= ((a.joined[i] & b.barred[j]) | (a.barred[i] & b.joined[j])) == 0
                i, j = i[new], j[new]
                self.effort.hold(len(i))
                v = self.product(table, a.at(i), b.at(j))
                nonzero = v.any(axis=0).all(axis=0)
                kept = int(np.count_nonzero(nonzero))
                self.effort.release(len(i) - kept)
                i, j = i[nonzero], j[nonzero]
                cost = a.cost[i] + b.cost[j] + ((a.top[i] != top) & (b.top[j] != top))
                joined, barred = _nothing(kept)
                if top == _JOIN:
                    joined, barred = a.joined[i] | b.joined[j], a.barred[i] | b.barred[j]
                found.append(
                    (a.code[i] + b.code[j], np.full(kept, top), cost, np.full(kept, first), i, j, joined, barred)
                )
                vectors.append(self._normalised(v[:, :, nonzero]))
        step = letters % self.rank
        if not found:
            none = np.zeros(0, dtype=np.int64)
            twins = np.zeros((0, 5), dtype=np.int64)
            empty = np.zeros((comb(self.rank, step), POSITIONS, 0), dtype=np.int32)
            return Level(step, none, empty, none, none, none, none, none, twins, none, none)
        columns = [np.concatenate(c) for c in zip(*found, strict=True)]
        found.clear()
        whole = np.concatenate(vectors, axis=2)
        vectors.clear()
        level = self._distinct(step, whole, *columns)
        self.effort.release(whole.shape[2] - len(level))
        return level

    def _distinct(self, step: int, v: Any, code: Ints, *rest: Ints) -> Level:
        """One extensor for all whose normalised vectors are equal."""
        flat = v.reshape(v.shape[0] * v.shape[1], v.shape[2])
        key = code.astype(np.uint64) * np.uint64(0x9E3779B97F4A7C15)
        for n, row in enumerate(flat, 1):
            key += row.astype(np.int64).view(np.uint64) * np.uint64((0xBF58476D1CE4E5B9 * (2 * n + 1)) % 2**64)
        order = np.lexsort((rest[1], key))
        start = np.ones(len(order), dtype=bool)
        start[1:] = key[order][1:] != key[order][:-1]
        kept = order[start]
        model = np.empty(len(order), dtype=np.int64)
        model[order] = kept[np.cumsum(start) - 1]
        # Two that share a key by chance are both kept: nothing is dropped but what is equal.
        equal = (flat == flat[:, model]).all(axis=0) & (code == code[model])
        equal[kept] = False
        model[~equal] = np.flatnonzero(~equal)
        chosen = np.flatnonzero(~equal)
        chosen = chosen[np.argsort(code[chosen], kind="stable")]
        place = np.empty(len(order), dtype=np.int64)
        place[chosen] = np.arange(len(chosen))
        others = np.flatnonzero(equal)
        top, _, first, left, right, joined, barred = rest
        homes = place[model[others]]
        twins = np.stack([homes, top[others], first[others], left[others], right[others]], axis=1)
        top, cost, first, left, right = (x[chosen] for x in rest[:5])
        of_all = []
        for bits in (joined, barred):  # what holds for every form
            kept_bits = bits[chosen]
            np.bitwise_and.at(kept_bits, homes, bits[others])
            of_all.append(kept_bits)
        vectors = np.ascontiguousarray(v[:, :, chosen])
        return Level(step, code[chosen], vectors, top, cost, first, left, right, twins, *of_all)

    def _normalised(self, v: Floats) -> Any:
        """Multiplied, at all positions alike, so that the first coordinate that is not 0 at the first becomes 1; then
        extensors that are proportional with one and the same constant at all positions are equal.
        """
        leading = (v[:, 0, :] != 0).argmax(axis=0)
        scale = self.field.inverse(v[leading, 0, np.arange(v.shape[2])])
        return self.field.reduced(v * scale).astype(np.int32)

    def product(self, table: Table, a: Floats, b: Floats) -> Floats:
        """Joins or meets of extensors, elementwise, by their table of coordinates."""
        out = np.empty((len(table), *np.broadcast_shapes(a.shape[1:], b.shape[1:])))
        for row, value in zip(table, out, strict=True):
            value[...] = 0
            for i, j, sign in row:
                value += a[i] * b[j] if sign > 0 else -(a[i] * b[j])
        return self.field.reduced(out)

    def pairs(self, a: Level, b: Level, *, same: bool) -> Iterator[tuple[Ints, Ints]]:
        """Places of all pairs whose multidegrees together fit, each pair once if the levels are the same."""
        codes_a, start_a, count_a = a.groups
        codes_b, start_b, count_b = b.groups
        for low in range(0, len(codes_a), CHUNK // max(1, len(codes_b)) + 1):
            high = low + CHUNK // max(1, len(codes_b)) + 1
            g, h = np.nonzero(self.letters.fit(codes_a[low:high, None] + codes_b[None, :]))
            g += low
            if same:
                g, h = g[g <= h], h[g <= h]
            for i, j in spread(start_a[g], count_a[g], start_b[h], count_b[h]):
                yield (i[i < j], j[i < j]) if same else (i, j)


def spread(start_a: Ints, count_a: Ints, start_b: Ints, count_b: Ints) -> Iterator[tuple[Ints, Ints]]:
    """All pairs of places of pairs of groups, in portions of about CHUNK pairs (or one pair of groups)."""
    sizes = count_a * count_b
    ends = np.cumsum(sizes)
    low = 0
    while low < len(sizes):
        done = int(ends[low - 1]) if low else 0
        high = max(low + 1, int(np.searchsorted(ends, done + CHUNK, side="right")))
        n = sizes[low:high]
        within = np.arange(int(n.sum())) - np.repeat(np.cumsum(n) - n, n)
        width = np.repeat(count_b[low:high], n)
        yield np.repeat(start_a[low:high], n) + within // width, np.repeat(start_b[low:high], n) + within % width
        low = high


def _nothing(number: int) -> _Bits:
    """No points joined, none barred."""
    none = np.zeros(number, dtype=np.int64)
    return none, none


def wedge(rank: int, k: int, h: int) -> Table:
    """The table of the join of steps k and h if it is no scalar, else of their meet."""
    return join_table(rank, k, h) if k + h < rank else meet_table(rank, k, h)


def scalar(rank: int, k: int) -> Sequence[tuple[int, int, int]]:
    """The (i, j, sign) whose products add up to the join of steps k and rank − k, a scalar."""
    return join_table(rank, k, rank - k)[0]
