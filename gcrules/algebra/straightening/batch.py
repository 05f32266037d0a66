r"""Straightening of many monomials at a time, by arrays.

The same rewriting as in `straighten`: two rows that are not comparable are replaced by their standard form. A row is
a number (its place in the colexicographic order, which extends the order of rows column by column), a monomial the
number whose digits are its rows. If rows r and s are not comparable, every pair in their standard form lies farther
apart than r and s do (its first row is at most min(r, s), its second at least max(r, s), column by column), so the sum
over the rows of (sum of the points)² grows. Monomials are therefore taken up in the order of this number, their
*level*: when the lowest level is taken, nothing is left that could add to it. (Small levels are taken together; a
monomial that comes up in one of them once more is taken once more.)
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from heapq import heappop, heappush
from math import comb
from typing import Any

import numpy as np

from gcrules.algebra.bracket import Monomial, Row, Terms
from gcrules.algebra.straightening.syzygies import two_row_pattern
from gcrules.algebra.straightening.work import Work
from gcrules.core.budget import watched

__all__ = ["straighten_levels"]

_BATCH = 4_096  # monomials that are rewritten at a time, if there are so many
_SAFE = 2**62  # numbers up to here may be added once more without an overflow
_WORD = 2**63
_CHUNKS = 64  # parts of the result that are kept before they are put together

_Array = np.ndarray[Any, Any]
_Chunk = tuple[_Array, _Array]  # keys of shape (n, words), coefficients


def straighten_levels(terms: Mapping[Monomial, Any], ideal: int, work: Work) -> Terms:
    """The normal form of raw terms, none of whose rows lies within the first `ideal` points.

    Raises LimitReached where the work is too much, or a budget around the caller used up.
    """
    normal: Terms = {}
    for rows in sorted({len(m) for m in terms}):
        some = {m: c for m, c in terms.items() if len(m) == rows}
        normal |= _Levels(some, ideal, work).normal_form() if rows > 1 else some
    return normal


class _Levels:
    """Monomials of equally many rows, waiting in their levels."""

    def __init__(self, terms: Mapping[Monomial, Any], ideal: int, work: Work) -> None:
        self.letters = sorted({i for m in terms for row in m for i in row})
        self.ideal = sum(i < ideal for i in self.letters)
        self.work = work
        example = next(iter(terms))
        self.rows, rank = len(example), len(example[0])
        self.pairs = _Pairs(len(self.letters), rank, work)
        self.row = self.pairs.row
        total = self.row.sum(axis=1, dtype=np.int64)
        self.square = total * total
        self.radix = len(self.row)
        self.digits = max(n for n in range(1, 64) if self.radix**n < _WORD)
        self.waiting: dict[int, list[_Chunk]] = {}
        self.order: list[int] = []
        self.count = 0
        place = {x: i for i, x in enumerate(self.letters)}
        index = [[sum(comb(place[x], j + 1) for j, x in enumerate(row)) for row in m] for m in watched(terms)]
        self._put(np.sort(np.array(index, dtype=np.int64), axis=1), _numbers(terms.values()))

    def normal_form(self) -> Terms:
        done: list[_Chunk] = []
        finished = 0
        while self.order:
            keys, coefficients = self._lowest()
            ids = self._ids(keys)
            at = self._offences(ids)
            standard = at < 0
            done.append((keys[standard], coefficients[standard]))
            finished += len(done[-1][1])
            if len(done) > _CHUNKS:
                done = [_merged(done)]
            self._replace(ids[~standard], at[~standard], coefficients[~standard])
            if self.count + finished > self.work.terms.most:
                self._compact()
                done = [_merged(done)]
                finished = len(done[0][1])
                self.work.terms.check(self.count + finished)
        return self._terms(*_merged(done))

    def _compact(self) -> None:
        """Brings equal monomials that wait together."""
        self.waiting = {level: [_merged(chunks)] for level, chunks in self.waiting.items()}
        self.count = sum(len(c) for ((_, c),) in self.waiting.values())

    def _replace(self, ids: _Array, at: _Array, coefficients: _Array) -> None:
        """Puts the standard form of rows `at` and `at + 1` of each monomial in its place."""
        if not len(ids):
            return
        n = np.arange(len(ids))
        starts, counts, first, second, signs = self.pairs.standard(ids[n, at], ids[n, at + 1])
        self.work.replacements.spend(int(counts.sum()))
        which = np.repeat(n, counts)
        term = np.arange(len(which)) + np.repeat(starts - np.cumsum(counts) + counts, counts)
        new = ids[which]
        m = np.arange(len(which))
        new[m, at[which]] = first[term]
        new[m, at[which] + 1] = second[term]
        keep = self.row[first[term], -1] >= self.ideal
        factor = signs[term]
        if coefficients.dtype != object and float(np.abs(coefficients).max()) * float(np.abs(factor).max()) > _SAFE:
            coefficients = coefficients.astype(object)
        new, products = new[keep], (coefficients[which] * factor)[keep]
        new.sort(axis=1)
        self._put(new, products)

    def _put(self, ids: _Array, coefficients: _Array) -> None:
        """Adds monomials, given by increasing rows, to their levels."""
        if not len(ids):
            return
        levels = self.square[ids].sum(axis=1)
        order = np.argsort(levels, kind="stable")
        levels = levels[order]
        keys, coefficients = self._keys(ids[order]), coefficients[order]
        cuts = np.flatnonzero(np.diff(levels)) + 1
        for i, j in zip((0, *cuts.tolist()), (*cuts.tolist(), len(levels)), strict=True):
            level = int(levels[i])
            if level not in self.waiting:
                self.waiting[level] = []
                heappush(self.order, level)
            self.waiting[level].append((keys[i:j], coefficients[i:j]))
        self.count += len(levels)

    def _lowest(self) -> _Chunk:
        """Takes the lowest levels, as many as make a batch."""
        taken: list[_Chunk] = []
        size = 0
        while self.order and size < _BATCH:
            found = self.waiting.pop(heappop(self.order))
            size += sum(len(c) for _, c in found)
            taken += found
        self.count -= size
        return _merged(taken)

    def _keys(self, ids: _Array) -> _Array:
        words = []
        for start in range(0, self.rows, self.digits):
            word = np.zeros(len(ids), dtype=np.int64)
            for column in range(start, min(start + self.digits, self.rows)):
                word = word * self.radix + ids[:, column]
            words.append(word)
        return np.stack(words, axis=1)

    def _ids(self, keys: _Array) -> _Array:
        ids = np.empty((len(keys), self.rows), dtype=np.int64)
        for w, start in enumerate(range(0, self.rows, self.digits)):
            word = keys[:, w]
            for column in range(min(start + self.digits, self.rows) - 1, start - 1, -1):
                word, ids[:, column] = np.divmod(word, self.radix)
        return ids

    def _offences(self, ids: _Array) -> _Array:
        """The first row of each monomial that is larger than the next in some column; −1 for standard tableaux."""
        at = np.full(len(ids), -1)
        for i in range(self.rows - 2, -1, -1):
            bad = (self.row[ids[:, i]] > self.row[ids[:, i + 1]]).any(axis=1)
            at[bad] = i
        return at

    def _terms(self, keys: _Array, coefficients: _Array) -> Terms:
        names = [tuple(self.letters[i] for i in row) for row in self.row.tolist()]
        rows = self._ids(keys).tolist()
        found = zip(rows, coefficients.tolist(), strict=True)
        return {tuple(sorted(names[i] for i in m)): c for m, c in watched(found)}


class _Pairs:
    """Standard forms of products of two rows over `letters` points, found for many pairs at a time."""

    def __init__(self, letters: int, rank: int, work: Work) -> None:
        self.rank = rank
        self.work = work
        self.binomial = np.array([[comb(x, j + 1) for j in range(rank)] for x in range(letters)], dtype=np.int64)
        self.row = _colexicographic(letters, rank)
        self.known: dict[int, int] = {}
        self.start: list[int] = []
        self.length: list[int] = []
        self.places: list[tuple[int, ...]] = []
        self.signs: list[int] = []

    def standard(self, one: _Array, other: _Array) -> tuple[_Array, _Array, _Array, _Array, _Array]:
        """Where the terms of each pair start, how many they are; and the terms: both rows and the coefficient."""
        size = len(self.row)
        pairs, which = np.unique(one * size + other, return_inverse=True)
        r, s = np.divmod(pairs, size)
        union, codes = self._patterns(self.row[r], self.row[s])
        kinds, first, kind = np.unique(codes, return_index=True, return_inverse=True)
        known = np.array([self._known(int(c), r[i], s[i]) for c, i in zip(kinds, first, strict=True)])
        start, length = np.array(self.start)[known][kind], np.array(self.length)[known][kind]
        ends = np.cumsum(length)
        pair = np.repeat(np.arange(len(pairs)), length)
        term = np.arange(len(pair)) + np.repeat(start - ends + length, length)
        places = np.array(self.places, dtype=np.int64)[term]
        letters = union[pair[:, None], places]
        index = [sum(self.binomial[letters[:, half + j], j] for j in range(self.rank)) for half in (0, self.rank)]
        signs = np.array(self.signs, dtype=np.int64)[term]
        return (ends - length)[which], length[which], index[0], index[1], signs

    def _patterns(self, one: _Array, other: _Array) -> tuple[_Array, _Array]:
        """The points of both rows in order, and a code for the way in which the rows share them out."""
        both = np.concatenate((2 * one.astype(np.int64), 2 * other.astype(np.int64) + 1), axis=1)
        both.sort(axis=1)
        letters, code = both >> 1, np.zeros(len(both), dtype=np.int64)
        new = np.ones(both.shape, dtype=np.int64)
        new[:, 1:] = letters[:, 1:] != letters[:, :-1]
        for j in range(both.shape[1]):
            code = code * 4 + 2 * (both[:, j] & 1) + new[:, j]
        union = np.zeros_like(letters)
        np.put_along_axis(union, np.cumsum(new, axis=1) - 1, letters, axis=1)
        return union, code

    def _known(self, code: int, one: int, other: int) -> int:
        """The number of a pattern of which these two rows are an example."""
        if code not in self.known:
            rows = self.row[one].tolist(), self.row[other].tolist()
            place = {x: i for i, x in enumerate(sorted({*rows[0], *rows[1]}))}
            found, work = two_row_pattern(*(tuple(place[x] for x in row) for row in rows))
            self.work.syzygies(work)
            self.known[code] = len(self.start)
            self.start.append(len(self.signs))
            self.length.append(len(found))
            for sign, first, second in found:
                self.places.append(first + second)
                self.signs.append(sign)
        return self.known[code]


def _colexicographic(letters: int, rank: int) -> _Array:
    """All rows, in colexicographic order."""
    rows: list[Row] = []

    def grow(tail: Row, below: int) -> None:
        if len(tail) == rank:
            rows.append(tail)
            return
        for x in range(rank - len(tail) - 1, below):
            grow((x, *tail), x)

    grow((), letters)
    return np.array(rows, dtype=np.int16)


def _numbers(values: Iterable[Any]) -> _Array:
    found = list(values)
    if all(isinstance(c, int) and abs(c) < _SAFE for c in found):
        return np.array(found, dtype=np.int64)
    out = np.empty(len(found), dtype=object)
    out[:] = found
    return out


def _merged(chunks: list[_Chunk]) -> _Chunk:
    """Equal keys brought together, sums that are 0 left out."""
    keys = np.concatenate([k for k, _ in chunks])
    values = np.concatenate([c for _, c in chunks])
    if not len(values):
        return keys, values
    if values.dtype != object and float(np.abs(values).astype(float).sum()) > _SAFE:
        values = values.astype(object)
    order = np.argsort(keys[:, 0]) if keys.shape[1] == 1 else np.lexsort(keys.T)
    keys, values = keys[order], values[order]
    starts = np.flatnonzero(np.concatenate(([True], (keys[1:] != keys[:-1]).any(axis=1))))
    sums = np.add.reduceat(values, starts)
    keep = sums != 0
    return keys[starts][keep], sums[keep]
