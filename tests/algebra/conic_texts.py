"""Texts about a conic K of the plane, evaluated by its matrix modulo a prime; of the engine only the parser is used."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import combinations
from random import Random
from typing import Any

from algebra.quadric_figures import Vector, combined, determinant, dot

from gcrules.algebra.evaluate import PRIME
from gcrules.algebra.language.parse_tree import read

__all__ = ["Plane", "Value", "drawn_frame", "drawn_line", "drawn_point", "placed"]

Value = tuple[int, tuple[int, ...]]
"""A step, and coordinates: one of a scalar, three of a point or a line."""

Matrix = Sequence[Sequence[int]]


def cross(p: Sequence[int], q: Sequence[int]) -> Vector:
    return tuple((p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2]) % PRIME for i in range(3))


def adjugate(m: Matrix) -> Matrix:
    return list(zip(*(cross(m[i - 2], m[i - 1]) for i in range(3)), strict=True))


def product(m: Matrix, n: Matrix) -> Matrix:
    return [[dot(row, column) for column in zip(*n, strict=True)] for row in m]


def _pair(one: Value, other: Value, flat: int) -> Value:
    """The join of two points or the meet of two lines, which are of the step `flat`; of others their product."""
    (k, p), (h, q) = one, other
    if 0 in (k, h):
        (c,), v = (p, q) if k == 0 else (q, p)
        return max(k, h), tuple(c * x % PRIME for x in v)
    if k != h:
        return 0, (dot(p, q),)
    assert k == flat
    return 3 - flat, cross(p, q)


def _join(*parts: Value) -> Value:
    return reduce(lambda a, b: _pair(a, b, 1), parts)


def _meet(*parts: Value) -> Value:
    return reduce(lambda a, b: _pair(a, b, 2), parts)


def _sum(*terms: Value) -> Value:
    return max(k for k, _ in terms), tuple(sum(c) % PRIME for c in zip(*(v for _, v in terms), strict=True))


@dataclass(frozen=True)
class Plane:
    """A conic by its matrix, and points and lines by names of one letter."""

    matrix: Matrix
    values: Mapping[str, Value]

    def dual(self) -> Plane:
        """Points and lines with their coordinates exchanged, and the conic of the tangents."""
        return Plane(adjugate(self.matrix), {n: (3 - k, v) for n, (k, v) in self.values.items()})

    def polar(self, p: Value) -> Value:
        step, v = p
        return 3 - step, tuple(dot(row, v) for row in (self.matrix if step == 1 else adjugate(self.matrix)))

    def form(self, p: Value) -> Value:
        return 0, (_join(p, self.polar(p))[1][0] * pow(2, -1, PRIME) % PRIME,)

    def second(self, p: Value, a: Value) -> Value:
        return 1, combined(_join(p, self.polar(a))[1][0], p[1], -self.form(p)[1][0], a[1])

    def holds(self, text: str) -> bool:
        """Whether a claim holds."""
        return read(text, "claimed", "<input>", lambda tree: self._claimed(tree.children[0]))

    def scalar(self, text: str) -> int:
        """The value of a scalar."""
        step, (value,) = read(text, "expression", "<input>", lambda tree: self._value(tree.children[0]))
        assert step == 0
        return value

    def _claimed(self, tree: Any) -> bool:
        if tree.data == "equation":
            left, right = (self._value(t)[1] for t in tree.children)
            return left == right or not any((*left, *right))
        kind, *parts = tree.children
        if str(parts[-1].children[0]) == "K":
            flats = [self._value(t) for t in parts[:-1]]
            return all(not any(_pair(f, self.polar(f), 0)[1]) for f in flats)
        values = [self._value(t) for t in parts]
        if kind == "incident":
            one, other = values
            return not any(_pair(one, other, one[0])[1])
        assert {k for k, _ in values} == {1 if kind == "collinear" else 2}
        return all(not determinant([v for _, v in three]) for three in combinations(values, 3))

    def _value(self, tree: Any) -> Value:
        found: Value = _NODES[tree.data](self, tree)
        return found

    def _word(self, tree: Any) -> Value:
        return _join(*(self.values[n] for n in str(tree.children[0])))

    def _signed(self, tree: Any) -> Value:
        *signs, operand = tree.children
        return _pair((0, ((-1) ** sum(s.type == "MINUS" for s in signs),)), self._value(operand), 0)

    def _sum(self, tree: Any) -> Value:
        first, *rest = tree.children
        signed = zip(rest[::2], rest[1::2], strict=True)
        terms = [_pair((0, (-1 if s.type == "MINUS" else 1,)), self._value(t), 0) for s, t in signed]
        return _sum(self._value(first), *terms)

    def _number(self, tree: Any) -> Value:
        top, _, bottom = str(tree.children[0]).partition("/")
        return 0, (int(top) * pow(int(bottom or 1), -1, PRIME) % PRIME,)

    def _construction(self, tree: Any) -> Value:
        word, *parts, _ = tree.children
        return _WORDS[str(word)](self, *map(self._value, parts))


def _folded(fold: Callable[..., Value]) -> Callable[[Plane, Any], Value]:
    return lambda at, tree: fold(*map(at._value, tree.children))


_NODES: Mapping[str, Callable[[Plane, Any], Value]] = {
    "word": Plane._word,
    "signed": Plane._signed,
    "sum": Plane._sum,
    "number": Plane._number,
    "construction": Plane._construction,
    "product": _folded(_join),
    "join": _folded(_join),
    "juxtaposition": _folded(_join),
    "bracket": _folded(_join),
    "meet": _folded(_meet),
    "power": lambda at, tree: (0, (pow(at._value(tree.children[0])[1][0], int(tree.children[1]), PRIME),)),
}
_WORDS: Mapping[str, Callable[..., Value]] = {
    "polar": Plane.polar,
    "pole": Plane.polar,
    "tangent": Plane.polar,
    "conic": Plane.form,
    "second_on_conic": Plane.second,
}


def drawn_frame(rng: Random) -> Matrix:
    """What takes the conic x z = y y to another one."""
    return [[rng.randrange(PRIME) for _ in range(3)] for _ in range(3)]


def placed(where: Mapping[str, str], rng: Random, frame: Matrix) -> Plane:
    """A conic with points and lines: "on" it, "tangent" to it, a "point" or a "line" anywhere, or on the line of two
    points ("ab").
    """
    own = adjugate(frame)
    matrix = product(product(list(zip(*own, strict=True)), [[0, 0, 1], [0, -2, 0], [1, 0, 0]]), own)  # 2 x z = 2 y y
    at = Plane(matrix, {})
    values: dict[str, Value] = {}
    for name, how in where.items():
        t = rng.randrange(PRIME)
        on = 1, tuple(dot(row, (1, t, t * t)) for row in frame)
        anywhere = tuple(rng.randrange(PRIME) for _ in range(3))
        if how in _PLACES:
            values[name] = _PLACES[how](at, on, anywhere)
        else:
            (step, p), (_, q) = (values[n] for n in how)
            values[name] = step, combined(t, p, 1, q)
    return Plane(matrix, values)


_PLACES: Mapping[str, Callable[[Plane, Value, Vector], Value]] = {
    "on": lambda _, on, __: on,
    "tangent": lambda at, on, _: at.polar(on),
    "point": lambda _, __, p: (1, p),
    "line": lambda _, __, p: (2, p),
}


def drawn_point(rng: Random, names: str, on: str, depth: int) -> str:
    """The text of a point."""
    kind = rng.randrange(4) if depth else 0
    if kind == 1:
        return f"pole({drawn_line(rng, names, on, depth - 1)}, K)"
    if kind == 2:
        return f"({drawn_line(rng, names, on, depth - 1)} /\\ {drawn_line(rng, names, on, depth - 1)})"
    if kind == 3 and on:
        return f"second_on_conic({drawn_point(rng, names, on, depth - 1)}, {rng.choice(on)}, K)"
    return rng.choice(names)


def drawn_line(rng: Random, names: str, on: str, depth: int) -> str:
    """The text of a line."""
    kind = rng.randrange(3)
    if kind == 0 and on:
        return f"tangent({rng.choice(on)}, K)"
    if kind == 1:
        return f"polar({drawn_point(rng, names, on, depth)}, K)"
    a, b = rng.sample(names, 2)
    return f"({a} \\/ {b})"
