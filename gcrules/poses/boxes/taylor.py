r"""Values of a program over whole boxes: Taylor models of second order, many boxes at once.

In a box a coordinate is m + h e with e from −1 to 1. A model of a value f says that in all of the box

    |f − (c + Σ gᵢ eᵢ + Σ_{i≤j} qᵢⱼ eᵢ eⱼ)| ≤ r.

Sums and products are those of polynomials; what is of higher order goes to r, and so does what floats round off, with
more room left than that. Of a root, a quotient, a cosine or a sine the Taylor polynomial at c is taken, with Lagrange's
remainder over the range of its argument. Source: Makino and Berz, Taylor models and other validated functional
inclusion methods, Int. J. Pure Appl. Math. 4 (2003); the remainders are derived here.

>>> from gcrules.poses.compiling.scalars import Graph
>>> from gcrules.poses.compiling.tape import lower
>>> graph = Graph(2)
>>> x, y = graph.inputs
>>> program = lower(graph, (x + y) * x, (x - 4).root())
>>> found = models(program, np.array([[1.0, 2.0]]), np.array([[0.1, 0.2]]), (0, 1))
>>> [[round(float(c), 9) for c in bounds[:, 0]] for bounds in found.ranges()]  # of x² + xy
[[2.38, nan], [3.63, nan]]
>>> bool(found.unreached[0])  # the root's argument is negative in all of the box
True
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.poses.compiling.tape import Program

__all__ = ["Models", "models", "pairs"]

Floats = NDArray[np.float64]
Truths = NDArray[np.bool_]
Places = NDArray[np.intp]

_ROUNDING = 1e-14
"""Of the sum of all absolute terms: dozens of times what an operation, or a constant, is rounded by."""


@cache
def pairs(n: int) -> tuple[Places, Places]:
    """The coordinates i ≤ j of all terms of second order, in their order: squares first."""
    i, j = np.triu_indices(n, 1)
    return np.concatenate([np.arange(n), i]), np.concatenate([np.arange(n), j])


@dataclass(frozen=True, eq=False)
class Models:
    """Models of R values over N boxes with n coordinates: `terms` (R, 1 + n + n (n + 1) / 2, N) are c, then g, then q
    in the order of `pairs`; `rest` is r (R, N). They are no numbers where a root or a quotient that is needed may not
    exist in the box.

    `unreached` (N,): a root's argument is negative in all of the box. `exists` (N,): all roots and quotients exist in
    all of it. `influence` (n, N): by how much the coordinates change arguments that may be 0, in parts of these.
    """

    terms: Floats
    rest: Floats
    unreached: Truths
    exists: Truths
    influence: Floats

    @property
    def known(self) -> Truths:
        """Where (N,) all of them are numbers."""
        return np.asarray(self.exists & np.isfinite(self.rest).all(axis=0) & np.isfinite(self.terms).all(axis=(0, 1)))

    @cached_property
    def centres(self) -> Floats:
        """The middles (R, N) of the ranges: squares are from 0 to 1, and so 1/2 ± 1/2."""
        n = len(self.influence)
        return np.asarray(self.terms[:, 0] + self.terms[:, 1 + n : 1 + 2 * n].sum(axis=1) / 2)

    @cached_property
    def changes(self) -> Floats:
        """What each term adds to the middles at most, with its sign: (R, T − 1, N)."""
        n = len(self.influence)
        found = self.terms[:, 1:].copy()
        found[:, n : 2 * n] /= 2
        return found

    @cached_property
    def radii(self) -> Floats:
        """How far (R, N) the values are from the middles at most."""
        return np.asarray(np.abs(self.changes).sum(axis=1) + self.rest)

    def ranges(self) -> tuple[Floats, Floats]:
        """Bounds (R, N) of the values."""
        return self.centres - self.radii, self.centres + self.radii


@dataclass(frozen=True, eq=False, slots=True)
class _Model:
    """One value: `terms` (T, N), `rest` (N,), and no less than the sum of their sizes (N,)."""

    terms: Floats
    rest: Floats
    size: Floats


def models(program: Program, middles: Floats, halves: Floats, free: Sequence[int]) -> Models:
    """The values over boxes with these middles (N, inputs), reaching so far (N, inputs) both ways in the inputs that
    are `free`, and not at all in the others.
    """
    return _Evaluation(program, middles, halves, tuple(free)).all()


class _Evaluation:
    def __init__(self, program: Program, middles: Floats, halves: Floats, free: tuple[int, ...]) -> None:
        self.program, self.middles, self.halves, self.free = program, middles, halves, free
        self.number, self.n = len(middles), len(free)
        self.first, self.second = pairs(self.n)
        self.linear, self.quadratic = slice(1, 1 + self.n), slice(1 + self.n, None)
        self.unreached = np.zeros(self.number, dtype=bool)
        self.exists = np.ones(self.number, dtype=bool)
        self.influence = np.zeros((self.n, self.number))

    def all(self) -> Models:
        lines, results = self.program.lines, self.program.results
        last = {m: n for n, line in enumerate(lines) for m in line.operands}
        kept = {r for r in results if isinstance(r, int)}
        values: list[_Model | None] = []
        with np.errstate(all="ignore"):  # what does not exist is no number, and said to be none
            for n, line in enumerate(lines):
                if line.op == "input":
                    values.append(self._input(line.args[0]))
                    continue
                operands = [values[m] for m in line.args]
                values.append(self._value(line.op, operands, float(line.constant)))  # type: ignore[arg-type]
                for m in line.args:
                    if last[m] == n and m not in kept:
                        values[m] = None
        terms = np.zeros((len(results), 1 + self.n + len(self.first), self.number))
        rest = np.zeros((len(results), self.number))
        for k, r in enumerate(results):
            if isinstance(r, int):
                found = values[r]
                assert found is not None
                terms[k], rest[k] = found.terms, found.rest
            else:
                terms[k, 0] = float(r)
        return Models(terms, rest, self.unreached, self.exists, self.influence)

    def _input(self, k: int) -> _Model:
        terms = np.zeros((1 + self.n + len(self.first), self.number))
        terms[0] = self.middles[:, k]
        size = np.abs(terms[0])
        if k in self.free:
            terms[1 + self.free.index(k)] = self.halves[:, k]
            size = size + self.halves[:, k]
        return _Model(terms, _ROUNDING * size, size)

    def _value(self, op: str, operands: Sequence[_Model], constant: float) -> _Model:
        a = operands[0]
        match op:
            case "add" | "sub":
                b = operands[1]
                size = a.size + b.size
                terms = a.terms + b.terms if op == "add" else a.terms - b.terms
                return _Model(terms, a.rest + b.rest + _ROUNDING * size, size)
            case "shift":
                terms = a.terms.copy()
                terms[0] += constant
                size = a.size + abs(constant)
                return _Model(terms, a.rest + _ROUNDING * size, size)
            case "scale":
                size = a.size * abs(constant)
                return _Model(a.terms * constant, a.rest * abs(constant) + _ROUNDING * size, size)
            case "mul":
                return self._product(a, operands[1])
        return self._applied(op, a)

    def _product(self, a: _Model, b: _Model) -> _Model:
        one, other = a.terms, b.terms
        terms = one[0] * other
        terms[1:] += other[0] * one[1:]
        terms[self.quadratic] += self._square(one[self.linear], other[self.linear])
        (g, q), (h, p) = self._sizes(a), self._sizes(b)
        rest = g * p + q * h + q * p
        rest += (np.abs(one[0]) + g + q) * b.rest + (np.abs(other[0]) + h + p) * a.rest + a.rest * b.rest
        size = a.size * b.size
        return _Model(terms, rest + _ROUNDING * size, size)

    def _square(self, g: Floats, h: Floats) -> Floats:
        """The terms of second order of Σ gᵢ eᵢ Σ hᵢ eᵢ."""
        found = g[self.first] * h[self.second]
        found[self.n :] += g[self.second[self.n :]] * h[self.first[self.n :]]
        return np.asarray(found)

    def _sizes(self, a: _Model) -> tuple[Floats, Floats]:
        """How large the terms of first and of second order are at most."""
        return np.abs(a.terms[self.linear]).sum(axis=0), np.abs(a.terms[self.quadratic]).sum(axis=0)

    def _applied(self, op: str, a: _Model) -> _Model:
        g, q = self._sizes(a)
        far, c = g + q + a.rest, a.terms[0]
        if op in ("sqrt", "inv"):
            c = self._checked(op, a, far)
        value, slope, bend, third = _DERIVATIVES[op](c, far)
        terms = slope * a.terms
        terms[0] = value
        terms[self.quadratic] += bend / 2 * self._square(a.terms[self.linear], a.terms[self.linear])
        rest = np.abs(slope) * a.rest + third / 6 * far**3
        rest += np.abs(bend) / 2 * ((2 * g + q) * q + (2 * (g + q) + a.rest) * a.rest)
        size = np.abs(value) + np.abs(slope) * far + np.abs(bend) / 2 * far**2
        return _Model(terms, rest + _ROUNDING * (size + np.abs(slope) * a.size), size)

    def _checked(self, op: str, a: _Model, far: Floats) -> Floats:
        """The values in the middle, no numbers where the argument may be 0, of a root also where it is negative."""
        c = a.terms[0]
        room = far + _ROUNDING * a.size
        known = np.isfinite(c) & np.isfinite(room)
        fine = known & (c > room if op == "sqrt" else np.abs(c) > room)
        if op == "sqrt":
            self.unreached |= known & (c < -room)
        self.exists &= fine
        doubtful = known & ~fine
        if doubtful.any():
            changed = np.abs(a.terms[self.linear])
            share = changed / np.maximum(changed.sum(axis=0), 1e-300)
            self.influence[:, doubtful] += share[:, doubtful]
        return np.where(fine, c, np.nan)


def _root(c: Floats, far: Floats) -> tuple[Floats, ...]:
    s, low = np.sqrt(c), c - far
    return s, 0.5 / s, -0.25 / (c * s), 0.375 / (low * low * np.sqrt(low))


def _inverse(c: Floats, far: Floats) -> tuple[Floats, ...]:
    v = 1 / c
    return v, -v * v, 2 * v**3, 6 / (np.abs(c) - far) ** 4


def _cosine(c: Floats, far: Floats) -> tuple[Floats, ...]:
    s, v = np.sin(c), np.cos(c)
    return v, -s, -v, np.minimum(np.abs(s) + far, 1.0)


def _sine(c: Floats, far: Floats) -> tuple[Floats, ...]:
    s, v = np.sin(c), np.cos(c)
    return s, v, -s, np.minimum(np.abs(v) + far, 1.0)


_DERIVATIVES: dict[str, Callable[[Floats, Floats], tuple[Floats, ...]]] = {
    "sqrt": _root,
    "inv": _inverse,
    "cos": _cosine,
    "sin": _sine,
}
"""For each function its value and first and second derivative at c, and a bound of the third within `far` of c."""
