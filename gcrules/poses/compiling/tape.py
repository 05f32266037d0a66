r"""Traced polynomials as a straight-line program, and the registers that it needs.

>>> from gcrules.poses.compiling.scalars import Graph
>>> graph = Graph(3)
>>> x, y, z = graph.inputs
>>> program = lower(graph, 2 * (x - y) * (y - x) + z)
>>> print(program)
v0 = input 2
v1 = input 0
v2 = input 1
v3 = v1 - v2
v4 = 2 * v3
v5 = v3 * v4
v6 = v0 - v5
>>> program.exact([1, 3, 10])
(Fraction(2, 1),)
>>> lower(graph, x + y, 7, (x + y) * z).exact([1, 3, 10])
(4, Fraction(7, 1), 40)
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from types import MappingProxyType
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.poses.compiling.scalars import Graph, Ring, Scalar

__all__ = ["BINARY", "OPERATIONS", "Operation", "Program", "allocated", "lower"]


@dataclass(frozen=True, slots=True)
class Operation:
    """One operation; `args` are numbers of earlier lines, of `input` that of the input."""

    op: str
    args: tuple[int, ...]
    constant: Fraction = Fraction(0)

    @property
    def operands(self) -> tuple[int, ...]:
        """The lines whose values are needed."""
        return () if self.op == "input" else self.args


OPERATIONS: Mapping[str, Callable[[Any, Any], Any]] = MappingProxyType(
    {
        "add": operator.add,
        "sub": operator.sub,
        "mul": operator.mul,
        "shift": operator.add,
        "scale": operator.mul,
        "inv": lambda x, _: 1 / x,
        "sqrt": lambda x, _: math.sqrt(x),
        "cos": lambda x, _: math.cos(x),
        "sin": lambda x, _: math.sin(x),
    }
)
"""What a line computes from its operand and another one, or the constant."""

BINARY = ("add", "sub", "mul")

_TEXTS = {
    "input": "input {0}",
    "add": "v{0} + v{1}",
    "sub": "v{0} - v{1}",
    "mul": "v{0} * v{1}",
    "shift": "v{0} + {c}",
    "scale": "{c} * v{0}",
    "inv": "1 / v{0}",
    "sqrt": "√v{0}",
    "cos": "cos v{0}",
    "sin": "sin v{0}",
}


@dataclass(frozen=True)
class Program:
    """Lines, and the `results`: numbers of lines, or Fractions where a value is constant, whatever the inputs."""

    inputs: int
    lines: tuple[Operation, ...]
    results: tuple[int | Fraction, ...]

    @property
    def operations(self) -> int:
        """How many additions, multiplications and divisions are done for each pose."""
        return sum(line.op != "input" for line in self.lines)

    @property
    def unused(self) -> tuple[int, ...]:
        """The inputs on which no value depends."""
        read = {line.args[0] for line in self.lines if line.op == "input"}
        return tuple(k for k in range(self.inputs) if k not in read)

    def exact(self, inputs: Sequence[Any]) -> tuple[Any, ...]:
        """The values for one set of inputs of any ring: exact for integers and Fractions, but for square roots."""
        values: list[Any] = []
        for line in self.lines:
            if line.op == "input":
                values.append(inputs[line.args[0]])
            else:
                a, *b = (values[n] for n in line.args)
                values.append(OPERATIONS[line.op](a, b[0] if b else line.constant))
        return tuple(values[r] if isinstance(r, int) else r for r in self.results)

    def __str__(self) -> str:
        rows = [f"v{n} = {_TEXTS[i.op].format(*i.args, c=i.constant)}" for n, i in enumerate(self.lines)]
        if self.results != (len(rows) - 1,):
            rows.append(", ".join(f"v{r}" if isinstance(r, int) else str(r) for r in self.results))
        return "\n".join(rows)


def lower(graph: Graph, *values: Ring) -> Program:
    """The lines that the values need, each operand shortly before it is used first."""
    number: dict[int, int] = {}
    lines: list[Operation] = []
    results: list[int | Fraction] = []
    for value in values:
        if not isinstance(value, Scalar):
            results.append(Fraction(value))
            continue
        root = value.node if value.sign > 0 else _negated(graph, value.node)
        stack = [(root, False)]
        while stack:
            n, ready = stack.pop()
            op, a, b = graph.nodes[n]
            operands = () if op == "input" else (a, int(b)) if op in BINARY else (a,)
            if ready and n not in number:
                number[n] = len(lines)
                if op == "input":
                    lines.append(Operation(op, (a,)))
                else:
                    constant = Fraction(0) if op in BINARY else Fraction(b)
                    lines.append(Operation(op, tuple(number[m] for m in operands), constant))
            elif n not in number:
                stack.append((n, True))
                stack += [(m, False) for m in reversed(operands)]
        results.append(number[root])
    return Program(len(graph.inputs), tuple(lines), tuple(results))


def _negated(graph: Graph, n: int) -> int:
    op, a, b = graph.nodes[n]
    return graph.node("sub", int(b), a) if op == "sub" else graph.node("scale", n, -1)


def allocated(program: Program) -> tuple[tuple[int, ...], int]:
    """A register for the value of each line, and how many there are. None is written by a line that reads it, and
    those of results are kept.
    """
    lines = program.lines
    last = {m: n for n, line in enumerate(lines) for m in line.operands}
    last |= {r: len(lines) for r in program.results if isinstance(r, int)}
    free: list[int] = []
    held: list[int] = []
    count = 0
    for n, line in enumerate(lines):
        if not free:
            free, count = [count], count + 1
        held.append(free.pop())
        free += [held[m] for m in dict.fromkeys(line.operands) if last[m] == n]
    return tuple(held), count
