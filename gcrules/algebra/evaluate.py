r"""The exact oracle: the value of an expression at given points, computed from coordinates alone.

It shares no code with expansion or straightening, so that it can refute them. An extensor of step k in rank d is
the list of its C(d, k) Plücker coordinates, indexed by the k-subsets of the rows in lexicographic order (for lines in
rank 4: 12, 13, 14, 23, 24, 34); the bracket is the determinant with the points as columns.

    >>> corner = {"a": (0, 0, 0, 1), "b": (1, 0, 0, 1), "c": (0, 1, 0, 1), "d": (0, 0, 1, 1)}
    >>> from gcrules.algebra.language.syntax import parse
    >>> evaluate(parse("[abcd]"), corner)       # minus six times the oriented volume
    -1
    >>> evaluate(parse("ab"), corner)
    (0, 0, -1, 0, 0, 0)
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import cache, cached_property, reduce
from itertools import chain, combinations
from typing import Any

from gcrules.algebra import claims
from gcrules.algebra.expr import (
    Bracket,
    Dotted,
    Expr,
    Join,
    Meet,
    Number,
    Point,
    Power,
    Product,
    Sum,
    Superbracket,
    points_of,
    rank_of,
)
from gcrules.algebra.scalars import written_out
from gcrules.core.budget import checkpoint
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.linear_algebra import determinant, permutation_sign
from gcrules.core.seeds import DRAWN, PRIME, drawn

__all__ = [
    "PRIME",
    "Evaluator",
    "Table",
    "evaluate",
    "join_table",
    "meet_table",
    "plucker",
    "random_points",
    "random_rational_points",
    "vanishes",
]

MAX_BITS = 10_000_000  # of an exact value
_ARRAYS = 1 << 31  # arrays of int64 hold residues modulo smaller numbers only

_Values = list[Any]  # Plücker coordinates: numbers of any ring, or arrays of them (one entry for each sample)
_Reduce = Callable[[Any], Any]


def evaluate(e: Expr, points: Mapping[str, Any], *, modulus: int | None = None) -> Any:
    """The value of an expression: a number for a scalar, a tuple of Plücker coordinates for an extensor.

    `points` gives each point's homogeneous coordinates as its last axis of length d: a sequence of integers or
    Fractions (exact), an array of floats of shape (…, d) (vectorised over the leading axes), or, with `modulus`,
    residues modulo that prime (for arrays of int64 it must be below 2³¹, so that products fit). Numbers come back in
    the same kind. Raises InputError for a point without coordinates or of unequal length.
    """
    missing = [n for n in points_of(e) if n not in points]
    if missing:
        raise InputError(f"no coordinates given for {', '.join(missing)}")
    ranks = {_length(points[n]) for n in points_of(e)}
    if len(ranks) > 1:
        raise InputError(f"points with different numbers of coordinates: {sorted(ranks)}")
    written = rank_of(e)
    rank = ranks.pop() if ranks else written or 4
    if written is not None and written != rank:
        raise InputError(f"points with {rank} coordinates, but the expression is written in rank {written}")
    values = Evaluator(points, rank, modulus).value(e)
    return tuple(values) if e.step else values[0]


def plucker(e: Expr, points: Mapping[str, Any]) -> tuple[Any, ...]:
    """The Plücker coordinates of an extensor of step 1 or more, in lexicographic order of rows."""
    if e.step == 0:
        raise InputError("a scalar has no Plücker coordinates")
    return tuple(evaluate(e, points))


def _coordinates(value: Any) -> _Values:
    shape = getattr(value, "shape", None)
    if shape is not None and len(shape) > 1:
        return [value[..., i] for i in range(shape[-1])]
    return list(value)


def _length(value: Any) -> int:
    return int(value.shape[-1]) if hasattr(value, "shape") else len(value)


class Evaluator:
    """Values of expressions at fixed points; parts that occur again are computed once.

    Arguments as for `evaluate`; `value` returns the list of Plücker coordinates (of length 1 for a scalar).
    """

    def __init__(self, points: Mapping[str, Any], rank: int = 4, modulus: int | None = None) -> None:
        self.points = points
        self.rank = rank
        self.reduced: _Reduce = (lambda x: x % modulus) if modulus else (lambda x: x)
        self.modulus = modulus
        self.known: dict[Expr, _Values] = {}

    def value(self, e: Expr) -> _Values:
        if e not in self.known:
            checkpoint()
            self.known[e] = self._value(e)
        return self.known[e]

    def _value(self, e: Expr) -> _Values:
        match e:
            case Number(value=value):
                return [self._number(value)]
            case Point(name=name):
                return [self.reduced(c) for c in _coordinates(self.points[name])]
            case Join(args=args) | Bracket(args=args):
                return self._joined(args, self.rank)
            case Meet(args=args):
                return self._met(args)
            case Superbracket(lines=lines):
                return [self._determinant([self.value(line) for line in lines])]
            case Sum(terms=terms):
                return [self.reduced(sum(cs[1:], cs[0])) for cs in zip(*map(self.value, terms), strict=True)]
            case Product(factors=factors):
                scalar: Any = 1
                rest: _Values = [1]
                for f, n in Counter(factors).items():
                    if f.step:
                        rest = self.value(f)
                    else:
                        scalar = self.reduced(scalar * self._power(self.value(f)[0], n))
                        _check_size(scalar)
                return [self.reduced(scalar * c) for c in rest]
            case Power(base=base, exponent=n):
                return [self._power(self.value(base)[0], n)]
            case Dotted():
                return self.value(written_out(e))
        raise TypeError(f"not an expression: {e!r}")

    @cached_property
    def _floating(self) -> bool:
        """Whether coordinates are arrays of floats."""
        return any(getattr(getattr(p, "dtype", None), "kind", "") == "f" for p in self.points.values())

    def _power(self, base: Any, exponent: int) -> Any:
        """By squaring, for any kind of numbers."""
        _check_size(base, exponent)
        found: Any = None
        while True:
            if exponent & 1:
                found = base if found is None else self.reduced(found * base)
            exponent >>= 1
            if not exponent:
                return found
            base = self.reduced(base * base)

    def _number(self, value: int | Fraction) -> int | float | Fraction:
        if not self.modulus:
            return float(value) if self._floating else value
        if value.denominator % self.modulus == 0:
            raise LimitReached(f"a denominator is a multiple of the modulus {self.modulus}")
        return value.numerator * pow(value.denominator, -1, self.modulus) % self.modulus

    def _joined(self, args: Sequence[Expr], rank: int) -> _Values:
        values, step = self.value(args[0]), args[0].step
        for a in args[1:]:
            values = self.joined(values, step, self.value(a), a.step, rank)
            step += a.step
        return values

    def joined(self, a: _Values, k: int, b: _Values, h: int, rank: int | None = None) -> _Values:
        """The Plücker coordinates of the join of extensors of steps k and h that have these."""
        return self._combine(a, b, join_table(rank or self.rank, k, h))

    def _determinant(self, rows: list[_Values]) -> Any:
        """By Laplace expansion, or elimination modulo `PRIME`; larger matrices by elimination if they are of floats,
        else without any division.
        """
        n = len(rows)
        if self.modulus == PRIME and {type(x) for row in rows for x in row} == {int}:
            return determinant(rows, PRIME)
        if n <= 6:
            return reduce(lambda a, i: self.joined(a, i, rows[i], 1, n), range(1, n), rows[0])[0]
        if any(map(_is_float, chain.from_iterable(rows))):
            return _float_determinant(rows)
        # Sums over closed walks that return to their smallest row only at the end: f holds those of growing length.
        f = rows
        for _ in range(n - 1):
            ended = [0] * n
            for i in range(n - 2, -1, -1):
                ended[i] = self.reduced(ended[i + 1] - f[i + 1][i + 1])
            f = [
                [
                    self.reduced(
                        sum(self.reduced(f[i][k] * rows[k][j]) for k in range(i + 1, n)) + ended[i] * rows[i][j]
                    )
                    for j in range(n)
                ]
                for i in range(n)
            ]
        return f[0][0] if n % 2 else self.reduced(-f[0][0])

    def _met(self, args: Sequence[Expr]) -> _Values:
        values, step = self.value(args[0]), args[0].step
        for a in args[1:]:
            values = self._combine(values, self.value(a), meet_table(self.rank, step, a.step))
            step += a.step - self.rank
        return values

    def _combine(self, a: _Values, b: _Values, table: Table) -> _Values:
        """Nearly all time is spent here; by a small modulus each product is reduced, so that arrays hold the sum."""
        m = self.modulus
        if m and m < _ARRAYS:
            return [sum([s * (a[i] * b[j] % m) for i, j, s in row]) % m for row in table]
        return [self.reduced(sum([a[i] * b[j] if s > 0 else -a[i] * b[j] for i, j, s in row])) for row in table]


def _check_size(value: Any, exponent: int = 1) -> None:
    """Raises LimitReached for an exact number whose power would be too large to go on with."""
    if isinstance(value, int | Fraction):
        bits = max(value.numerator.bit_length(), value.denominator.bit_length()) - 1
        if bits * exponent > MAX_BITS:
            raise LimitReached(f"a value has more than {MAX_BITS:,} bits")


def _is_float(value: Any) -> bool:
    return isinstance(value, float) or getattr(getattr(value, "dtype", None), "kind", "") == "f"


def _float_determinant(rows: list[_Values]) -> Any:
    import numpy as np

    entries = np.stack(np.broadcast_arrays(*chain.from_iterable(rows)), axis=-1).astype(float)
    found = np.linalg.det(entries.reshape(*entries.shape[:-1], len(rows), len(rows)))
    return found if np.ndim(found) else float(found)


Table = tuple[tuple[tuple[int, int, int], ...], ...]


@cache
def join_table(rank: int, k: int, h: int) -> Table:
    """For each coordinate of a join of steps k and h: the (i, j, sign) whose products add up to it."""
    left, right = _index(rank, k), _index(rank, h)
    return tuple(
        tuple(
            (left[i], right[j], permutation_sign(i + j))
            for i in combinations(rows, k)
            for j in [tuple(r for r in rows if r not in i)]
        )
        for rows in combinations(range(rank), k + h)
    )


@cache
def meet_table(rank: int, k: int, h: int) -> Table:
    """The same for a meet: e_I ∧ e_J = Σ over shuffles (I1, I2) of I of sgn · [e_I1 e_J] e_I2, nonzero for one I1."""
    left, right = _index(rank, k), _index(rank, h)
    table: dict[tuple[int, ...], list[tuple[int, int, int]]] = {r: [] for r in combinations(range(rank), k + h - rank)}
    for i in left:
        for j in right:
            only_i = tuple(r for r in i if r not in j)
            both = tuple(r for r in i if r in j)
            if len(only_i) == rank - h:
                sign = permutation_sign(only_i + both) * permutation_sign(only_i + j)
                table[both].append((left[i], right[j], sign))
    return tuple(map(tuple, table.values()))


@cache
def _index(rank: int, step: int) -> dict[tuple[int, ...], int]:
    return {rows: n for n, rows in enumerate(combinations(range(rank), step))}


def random_points(
    names: Iterable[str], *, rank: int = 4, ideal: Iterable[str] = (), seed: object = 0
) -> dict[str, tuple[int, ...]]:
    """Random homogeneous coordinates to be taken modulo `PRIME`; points in `ideal` have last coordinate 0.

    The same in one run for the same `seed` (a number, or texts and numbers that say what is claimed), and such that
    nobody can foresee them: what holds there may decide (see `seeds`).
    """
    wanted = tuple(names)
    if not wanted:
        return {}
    rng = drawn("points", seed)
    at_infinity = set(ideal)
    return {
        name: (*(rng.randrange(DRAWN) for _ in range(rank - 1)), 0 if name in at_infinity else rng.randrange(DRAWN))
        for name in wanted
    }


def random_rational_points(
    names: Iterable[str], *, rank: int = 4, ideal: Iterable[str] = (), seed: int = 0, size: int = 9
) -> dict[str, tuple[int, ...]]:
    """Small random whole coordinates, finite points with last coordinate 1, ideal points with 0, and none zero.

    The same in every run for the same seed, thus to search and to show; what holds there proves nothing.
    """
    rng = random.Random(seed)
    at_infinity = set(ideal)
    found = {}
    for name in names:
        last = 0 if name in at_infinity else 1
        value: tuple[int, ...] = (0,) * rank
        while not any(value):
            value = (*(rng.randint(-size, size) for _ in range(rank - 1)), last)
        found[name] = value
    return found


def vanishes(e: Expr, *, rank: int = 4, ideal: Iterable[str] = (), samples: int = 2, seed: object = 0) -> bool:
    """Whether an expression is zero at random points modulo `PRIME`, which depend on the expression and on `seed`.

    False is certain. True is wrong with the probability `claims.error_below`, whoever wrote the expression.
    """
    names, at_infinity, claim = points_of(e), tuple(ideal), claims.digest(e)
    for n in range(samples):
        points = random_points(names, rank=rank, ideal=at_infinity, seed=(claim, seed, n))
        if any(Evaluator(points, rank, PRIME).value(e)):
            return False
    return True
