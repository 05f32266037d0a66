r"""Scalar expressions of joins and meets as unrooted trees, and the simplest way to write each.

Up to its sign a scalar A ∨ B depends on the tree only that arises when the trees of A and B are tied together at their
tops: its leaves are points, its nodes are brackets of extensors (steps that add up to d) and meets of extensors (steps
d − s that add up to d). Neighbouring nodes of one kind are one node. Any node may be written outermost.

    >>> from gcrules.algebra.factoring.tree_letters import Tree
    >>> line = lambda a, b: ("join", a, b)
    >>> pair = ("meet", ("join", line("a", "b"), "c"), ("join", line("d", "e"), "f")), line("g", "h")
    >>> print(simplest(*pair, rank=4))
    abc /\ def /\ gh
"""

from __future__ import annotations

from functools import cached_property

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.tree_letters import Tree
from gcrules.algebra.language.text import text
from gcrules.algebra.names import point_key
from gcrules.algebra.scalars import bracket
from gcrules.core.dataclass import dataclass

__all__ = ["Written", "simplest"]


@dataclass(frozen=True)
class Written:
    """A way to write a scalar expression, ordered by simplicity: nodes of the tree, depth, unlike branches, text."""

    expression: Expr
    nodes: int
    names: tuple[str, ...]

    @cached_property
    def key(self) -> tuple[int, int, int, int, str]:
        branches = {_shape(c) for c in self.expression.children}
        shown = text(self.expression, names=self.names)
        return self.nodes, self.expression.depth, len(branches), len(shown), shown

    def __str__(self) -> str:
        return self.key[-1]


class _Node:
    def __init__(self, kind: str) -> None:
        self.kind = kind
        self.points: list[str] = []
        self.ties: list[_Node] = []


def simplest(a: Tree, b: Tree, *, rank: int, order: tuple[str, ...] = ()) -> Written:
    """The simplest way to write the scalar A ∨ B (or A ∧ B: the same up to sign); points in this order, else sorted.

    Equal trees give equal values, whichever pair of complementary extensors they are cut into.
    """
    nodes: list[_Node] = []
    root = _grow(a, nodes)
    if isinstance(root, str):
        nodes.append(_Node("join"))
        root = _tie(nodes[0], root, nodes)
    _tie(root, _grow(b, nodes), nodes)
    rankings = {name: i for i, name in enumerate(order)}
    return min((_Writer(rank, rankings, order).rooted(node, len(nodes)) for node in nodes), key=lambda w: w.key)


def _grow(tree: Tree, nodes: list[_Node]) -> _Node | str:
    """Make nodes of a tree, and tie them; what is returned stands for the whole tree."""
    if isinstance(tree, str):
        return tree
    kind, *parts = tree
    node = _Node(kind)
    nodes.append(node)
    for part in parts:
        node = _tie(node, _grow(part, nodes), nodes)
    return node


def _tie(node: _Node, other: _Node | str, nodes: list[_Node]) -> _Node:
    """Make `other` a neighbour of `node`, or one with it if both are of a kind."""
    if isinstance(other, str):
        node.points.append(other)
    elif other.kind != node.kind:
        node.ties.append(other)
        other.ties.append(node)
    else:
        nodes.remove(other)
        node.points += other.points
        for tie in other.ties:
            tie.ties[tie.ties.index(other)] = node
            node.ties.append(tie)
    return node


@dataclass(frozen=True)
class _Writer:
    rank: int
    place: dict[str, int]
    names: tuple[str, ...]

    def rooted(self, node: _Node, nodes: int) -> Written:
        parts = self._parts(node, None)
        e = bracket(*parts, rank=self.rank) if node.kind == "join" else ex.meet(*parts, rank=self.rank)
        return Written(e, nodes, self.names)

    def _parts(self, node: _Node, source: _Node | None) -> list[Expr]:
        points = sorted(node.points, key=lambda n: (self.place.get(n, 0), point_key(n)))
        branches = list(node.ties)
        if source is not None:
            branches.remove(source)
        others = [self._extensor(b, node) for b in branches]
        others.sort(key=lambda e: (-e.step, e.depth, text(e, names=self.names)))
        return [*others, *map(ex.Point, points)]

    def _extensor(self, node: _Node, source: _Node) -> Expr:
        parts = self._parts(node, source)
        return ex.join(*parts, rank=self.rank) if node.kind == "join" else ex.meet(*parts, rank=self.rank)


def _shape(e: Expr) -> str:
    """The expression with all points alike."""
    return "." if isinstance(e, ex.Point) else f"{type(e).__name__}({' '.join(sorted(map(_shape, e.children)))})"
