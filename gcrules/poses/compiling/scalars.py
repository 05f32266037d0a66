r"""Polynomials as graphs in which nothing is computed twice: what a compiled condition is traced with.

A `Scalar` is a node of a `Graph` with a sign; numbers (int, Fraction) stand beside scalars and are folded exactly, so
that 0 and 1 leave no trace. Equal sums and products become the same node (hash-consing), up to sign.

>>> graph = Graph(2)
>>> x, y = graph.inputs
>>> x * y - y * x, 2 * x - x * 2, (y - x) == -(x - y)
(0, 0, True)
>>> graph.cost
3
"""

from __future__ import annotations

from fractions import Fraction
from typing import Union

from gcrules.core.dataclass import dataclass

__all__ = ["Graph", "Number", "Ring", "Scalar"]

Number = int | Fraction
Node = tuple[str, int, int | Fraction]
"""An operation and its operands: numbers of nodes, the second of `shift` and `scale` a constant."""


class Graph:
    """The nodes that a trace has made, operands before their use; the first ones are the inputs.

    add, sub, mul have two operands, shift adds a constant, scale multiplies by a positive one, inv is 1/x, sqrt √x, cos
    and sin take angles in rad; machine code knows neither of these two.
    """

    def __init__(self, inputs: int) -> None:
        self.nodes: list[Node] = [("input", k, 0) for k in range(inputs)]
        self.known: dict[Node, int] = {}
        self.inputs = tuple(Scalar(self, 1, k) for k in range(inputs))

    def node(self, op: str, a: int, b: int | Fraction = 0) -> int:
        """The number of this node, a new one only where there is none yet."""
        key: Node = (op, a, b)
        if key not in self.known:
            self.known[key] = len(self.nodes)
            self.nodes.append(key)
        return self.known[key]

    @property
    def cost(self) -> int:
        """How many operations have been made, those that no result needs included."""
        return len(self.nodes) - len(self.inputs)


@dataclass(frozen=True, slots=True)
class Scalar:
    """sign · node. Sums and products with scalars of the same graph, and with numbers, are of the same kind."""

    graph: Graph
    sign: int
    node: int

    def __neg__(self) -> Scalar:
        return Scalar(self.graph, -self.sign, self.node)

    def __add__(self, other: Ring) -> Ring:
        if not isinstance(other, Scalar):
            return self._shifted(Fraction(other))
        a, b = sorted((self, other), key=lambda s: s.node)
        if a.sign == b.sign:
            return a * 2 if a.node == b.node else Scalar(self.graph, a.sign, self.graph.node("add", a.node, b.node))
        return 0 if a.node == b.node else Scalar(self.graph, a.sign, self.graph.node("sub", a.node, b.node))

    def __radd__(self, other: Number) -> Ring:
        return self + other

    def __sub__(self, other: Ring) -> Ring:
        return self + (-other)

    def __rsub__(self, other: Number) -> Ring:
        return -self + other

    def __mul__(self, other: Ring) -> Ring:
        if not isinstance(other, Scalar):
            return self._scaled(Fraction(other))
        a, b = sorted((self.node, other.node))
        return Scalar(self.graph, self.sign * other.sign, self.graph.node("mul", a, b))

    def __rmul__(self, other: Number) -> Ring:
        return self * other

    def inverse(self) -> Scalar:
        """1 / self."""
        return Scalar(self.graph, self.sign, self.graph.node("inv", self.node))

    def root(self) -> Scalar:
        """√self, not a number where self is negative."""
        node = self.node if self.sign > 0 else self.graph.node("scale", self.node, -1)
        return Scalar(self.graph, 1, self.graph.node("sqrt", node))

    def cosine_and_sine(self) -> tuple[Scalar, Scalar]:
        """Those of self in rad, as nodes of their own; `roots.cosine_and_sine` makes them of products and sums."""
        cosine, sine = (self.graph.node(op, self.node) for op in ("cos", "sin"))
        return Scalar(self.graph, 1, cosine), Scalar(self.graph, self.sign, sine)

    def _shifted(self, by: Fraction) -> Scalar:
        node, by = self.node, by * self.sign
        op, a, c = self.graph.nodes[node]
        if op == "shift":  # (x + c) + d = x + (c + d), so that differences of fixed points meet again
            node, by = a, by + c
        return Scalar(self.graph, self.sign, self.graph.node("shift", node, by) if by else node)

    def _scaled(self, by: Fraction) -> Ring:
        sign = self.sign if by > 0 else -self.sign
        if abs(by) == 1:
            return Scalar(self.graph, sign, self.node)
        return Scalar(self.graph, sign, self.graph.node("scale", self.node, abs(by))) if by else 0


Ring = Union[Scalar, int, Fraction]  # noqa: UP007  the name is used above, before Scalar exists
