r"""The letters of which expressions are made, points and given extensors, and trees of joins and meets of them.

A *multidegree* is one whole number: a field of bits for each letter, the highest bit of each field kept free so that
fields can be compared all at once.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

import numpy as np

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.modular import Ints
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached

__all__ = ["Given", "Letters", "Tree", "extensor", "joined", "leaves"]

_FIELDS = 62  # bits of a multidegree

Tree = str | tuple[str, "Tree", "Tree"]
"""A point, or ("join" | "meet", tree, tree)."""


def leaves(tree: Tree) -> Iterator[str]:
    """The points of a tree, each as often as it is used."""
    if isinstance(tree, str):
        yield tree
    else:
        for part in tree[1:]:
            yield from leaves(part)


def joined(*points: str) -> Tree:
    """The join of points as a tree."""
    *first, last = points
    return ("join", joined(*first), last) if first else last


def extensor(tree: Tree, rank: int) -> Expr:
    """A tree of joins and meets as an expression."""
    if isinstance(tree, str):
        return ex.Point(tree)
    kind, *parts = tree
    args = [extensor(part, rank) for part in parts]
    return ex.join(*args, rank=rank) if kind == "join" else ex.meet(*args, rank=rank)


@dataclass(frozen=True)
class Given:
    """An extensor of this step that is to be used as often as `times` says, as if it were a join of so many points."""

    tree: Tree
    step: int
    times: int = 1

    @cached_property
    def points(self) -> tuple[str, ...]:
        """Those that it is the join of, if it is one of points."""
        found = tuple(leaves(self.tree))
        return found if len(found) == self.step else ()


@dataclass(frozen=True)
class Letters:
    """The points, with the degree in which each is to be used, and the encoding of multidegrees.

    `given` are extensors that stand beside the points; the points in them do not count.
    """

    names: tuple[str, ...]
    degrees: tuple[int, ...]
    rank: int
    given: tuple[Given, ...] = ()

    def __post_init__(self) -> None:
        if sum(self.widths) > _FIELDS:
            raise LimitReached(
                f"the search over expressions is limited to fewer points: {len(self.names)} points of total degree "
                f"{self.number} take {sum(self.widths)} bits, it has {_FIELDS}"
            )

    @cached_property
    def widths(self) -> tuple[int, ...]:
        return tuple(d.bit_length() + 1 for d in self._all_degrees)

    @cached_property
    def _all_degrees(self) -> tuple[int, ...]:
        return (*self.degrees, *(g.times for g in self.given))

    @cached_property
    def number(self) -> int:
        """How many letters an expression has."""
        return sum(self.degrees) + sum(g.step * g.times for g in self.given)

    @cached_property
    def units(self) -> tuple[int, ...]:
        """The multidegree of each point, then of each given extensor."""
        return tuple(1 << sum(self.widths[:i]) for i in range(len(self.widths)))

    @cached_property
    def all(self) -> int:
        """The whole multidegree."""
        return sum(d * u for d, u in zip(self._all_degrees, self.units, strict=True))

    @cached_property
    def guard(self) -> int:
        return sum(u << (w - 1) for u, w in zip(self.units, self.widths, strict=True))

    def fit(self, sums: Ints) -> np.ndarray:
        """Whether multidegrees, each a sum of two that fit, lie within the whole one."""
        fits: np.ndarray = (((self.all | self.guard) - sums) & self.guard) == self.guard
        return fits
