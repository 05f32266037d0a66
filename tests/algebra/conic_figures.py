"""Conics by symmetric matrices modulo a prime; a pole by the adjugate of the matrix."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from algebra.quadric_figures import SymmetricMatrix, Vector, dot

from gcrules.algebra.evaluate import PRIME

__all__ = ["Figure", "cross"]


def cross(p: Sequence[int], q: Sequence[int]) -> Vector:
    return tuple((p[i - 2] * q[i - 1] - p[i - 1] * q[i - 2]) % PRIME for i in range(3))


@dataclass
class Figure(SymmetricMatrix):
    """A conic and points; `on` are those on the conic, `conjugate` those on the polar of another one."""

    on: tuple[str, ...] = ()
    conjugate: dict[str, str] = field(default_factory=dict)
    size = 3

    def __post_init__(self) -> None:
        a, s = self.random(), [self.random() for _ in range(3)]
        m = [[(s[i][j] + s[j][i]) % PRIME for j in range(3)] for i in range(3)]
        i = next(i for i in range(3) if a[i])
        rest = dot(a, [dot(row, a) for row in m]) - m[i][i] * a[i] ** 2
        m[i][i] = -rest * pow(a[i] ** 2, -1, PRIME) % PRIME  # a is a point of the conic
        self.matrix = m
        self.points: dict[str, Vector] = {}
        for name in "abcdef":
            if name in self.on:
                self.points[name] = self.second(self.random(), a)
            elif name in self.conjugate:
                self.points[name] = cross(self.polar(self.points[self.conjugate[name]]), self.random())
            else:
                self.points[name] = self.random()

    def pole(self, line: Sequence[int]) -> Vector:
        """By the adjugate of the matrix, whose rows are cross products of the others."""
        m = self.matrix
        return tuple(dot(row, line) for row in (cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])))
