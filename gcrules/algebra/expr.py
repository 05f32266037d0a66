r"""Expressions of Grassmann–Cayley algebra as frozen values, built by functions that check the steps.

The *step* (grade) of an extensor is the number of points whose join it is; scalars have step 0. In rank d the join of
steps k and h has step k + h (at most d), their meet k + h − d (at least 0). Building an expression normalises it:
joins, meets, sums and products are flat, a join with a scalar is a product, numbers are folded together. So two texts
with the same structure give equal values, and `parse(str(e)) == e`.

    >>> a, b, c, d, e = (Point(n) for n in "abcde")
    >>> line, plane = join(a, b), join(c, d, e)
    >>> meet(line, plane).step
    1
    >>> print(join(meet(line, plane), a))
    (ab /\ cde) \/ a
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field
from fractions import Fraction
from itertools import chain, repeat
from math import isqrt
from typing import Any

from gcrules.algebra.names import step_name
from gcrules.core.budget import watched
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached, StepError
from gcrules.core.floats import exact_number
from gcrules.core.hashed import Hashed
from gcrules.core.shown import Shown

__all__ = [
    "ONE",
    "ZERO",
    "Bracket",
    "Dotted",
    "Expr",
    "Join",
    "Meet",
    "Number",
    "Point",
    "Power",
    "Product",
    "Sum",
    "Superbracket",
    "add",
    "common_rank",
    "join",
    "measure",
    "meet",
    "mul",
    "neg",
    "points_of",
    "rank_of",
    "signed",
    "sub",
    "subexpressions",
    "too_many_bits",
]

MAX_DEPTH = 150
MAX_COEFFICIENT_BITS = 10_000


@dataclass(frozen=True, slots=True)
class Expr(Hashed, Shown):
    """Base of all expressions: the `step` of the value (0 for scalars), the `depth` of nesting, parts as `children`."""

    step: int = field(init=False, repr=False, compare=False)
    depth: int = field(init=False, repr=False, compare=False)
    children: tuple[Expr, ...] = field(init=False, repr=False, compare=False)

    def to_json(self) -> dict[str, Any]:
        """`{expression, step}`; the expression is text of the language, which parses back."""
        return {"expression": str(self), "step": self.step}

    def __or__(self, other: Expr) -> Expr:
        """The join, in the rank that the operands are written in (4 if they do not say)."""
        if not isinstance(other, Expr):
            return NotImplemented
        return join(self, other, rank=common_rank(None, self, other))

    def __and__(self, other: Expr) -> Expr:
        """The meet, in the rank that the operands are written in (4 if they do not say)."""
        if not isinstance(other, Expr):
            return NotImplemented
        return meet(self, other, rank=common_rank(None, self, other))

    def __add__(self, other: Expr) -> Expr:
        if not isinstance(other, Expr):
            return NotImplemented
        return add(self, other)

    def __sub__(self, other: Expr) -> Expr:
        if not isinstance(other, Expr):
            return NotImplemented
        return sub(self, other)

    def __neg__(self) -> Expr:
        return neg(self)

    def __mul__(self, other: Expr | int | Fraction) -> Expr:
        if isinstance(other, Expr):
            return mul(self, other)
        number = exact_number(other)
        return NotImplemented if number is None else mul(self, Number(number))

    def __rmul__(self, other: int | Fraction) -> Expr:
        number = exact_number(other)
        return NotImplemented if number is None else mul(Number(number), self)

    __array_ufunc__ = None  # arrays take no expressions apart


def measure(e: Expr, step: int, children: tuple[Expr, ...] = ()) -> None:
    """Fill in the derived fields of a new expression, for classes of expressions."""
    depth = 1 + max((c.depth for c in children), default=0)
    if depth > MAX_DEPTH:
        raise LimitReached(f"an expression of more than {MAX_DEPTH} operations inside each other")
    object.__setattr__(e, "step", step)
    object.__setattr__(e, "depth", depth)
    object.__setattr__(e, "children", children)


@dataclass(frozen=True, slots=True)
class Number(Expr):
    """A rational constant. Zero counts as an extensor of every step."""

    value: int | Fraction

    def __post_init__(self) -> None:
        value = self.value
        if isinstance(value, Fraction) and value.denominator == 1:
            object.__setattr__(self, "value", value.numerator)
        measure(self, 0)
        if max(abs(value.numerator), value.denominator).bit_length() > MAX_COEFFICIENT_BITS:
            raise too_many_bits()


@dataclass(frozen=True, slots=True)
class Point(Expr):
    """A point (extensor of step 1) given by its name."""

    name: str

    def __post_init__(self) -> None:
        measure(self, 1)


@dataclass(frozen=True, slots=True)
class Join(Expr):
    """A join of at least two extensors of positive step, none of them a join. Build with `join`."""

    args: tuple[Expr, ...]

    def __post_init__(self) -> None:
        measure(self, sum(a.step for a in self.args), self.args)


@dataclass(frozen=True, slots=True)
class Meet(Expr):
    """A meet in a space of the given rank, none of its arguments a meet. Build with `meet`."""

    args: tuple[Expr, ...]
    rank: int

    def __post_init__(self) -> None:
        measure(self, sum(a.step for a in self.args) - self.rank * (len(self.args) - 1), self.args)


@dataclass(frozen=True, slots=True)
class Bracket(Expr):
    """The bracket [A B …] = determinant of extensors whose steps add up to the rank. Build with `bracket`."""

    args: tuple[Expr, ...]

    def __post_init__(self) -> None:
        measure(self, 0, self.args)


@dataclass(frozen=True, slots=True)
class Dotted(Expr):
    """A product of brackets with dotted points: the signed sum over all ways to share the dotted points out among
    the dotted places, counting rearrangements within one bracket once. Entries: (name, dotted?). Build with `dotted`.
    """

    brackets: tuple[tuple[tuple[str, bool], ...], ...]

    def __post_init__(self) -> None:
        measure(self, 0)


@dataclass(frozen=True, slots=True)
class Superbracket(Expr):
    """The determinant of the matrix whose rows are the Plücker coordinates of n(n − 1)/2 lines in rank n: in rank 4
    the 6×6 determinant of six lines. Build with `superbracket`.
    """

    lines: tuple[Expr, ...]

    def __post_init__(self) -> None:
        measure(self, 0, self.lines)

    @property
    def rank(self) -> int:
        return (1 + isqrt(1 + 8 * len(self.lines))) // 2


@dataclass(frozen=True, slots=True)
class Sum(Expr):
    """A sum of at least two expressions of equal step. Build with `add`."""

    terms: tuple[Expr, ...]

    def __post_init__(self) -> None:
        measure(self, self.terms[0].step, self.terms)


@dataclass(frozen=True, slots=True)
class Product(Expr):
    """A product of scalars and at most one extensor; a number, if any, comes first. Build with `mul`."""

    factors: tuple[Expr, ...]

    def __post_init__(self) -> None:
        measure(self, max(f.step for f in self.factors), self.factors)


@dataclass(frozen=True, slots=True)
class Power(Expr):
    """A power of a scalar with exponent 2 or more. Build with `power`."""

    base: Expr
    exponent: int

    def __post_init__(self) -> None:
        measure(self, 0, (self.base,))


ZERO = Number(0)
ONE = Number(1)


def too_many_bits() -> InputError:
    """What is raised for a number that is too large."""
    return InputError(f"a coefficient has more than {MAX_COEFFICIENT_BITS} bits")


def join(*args: Expr, rank: int = 4) -> Expr:
    """The join A ∨ B ∨ …; scalars among the arguments multiply. Raises StepError beyond the rank."""
    if any(a == ZERO for a in args):
        return ZERO
    scalars = [a for a in args if a.step == 0]
    flat = list(chain.from_iterable(a.args if isinstance(a, Join) else (a,) for a in args if a.step))
    total = sum(a.step for a in flat)
    if total > rank:
        steps = [str(a.step) for a in args if a.step]
        found = " and ".join([*steps[:6], *(["…"] if len(steps) > 6 else [])])
        raise StepError(
            f"this join has step {total}, beyond the rank {rank} (steps found: {found})",
            hint=f"a join of more than {rank} points is always zero in rank {rank}; did you mean a meet /\\ ?",
        )
    if not flat:
        return mul(*scalars)
    joined = flat[0] if len(flat) == 1 else Join(tuple(flat))
    return mul(*scalars, joined) if scalars else joined


def meet(*args: Expr, rank: int = 4) -> Expr:
    """The meet A ∧ B ∧ … in the given rank. Raises StepError where two steps add up to less than the rank."""
    if any(a == ZERO for a in args):
        return ZERO
    flat = list(chain.from_iterable(a.args if isinstance(a, Meet) else (a,) for a in args))
    step = flat[0].step
    for a in flat[1:]:
        if isinstance(a, Number):
            raise StepError(
                "a meet with a number; `^` is the meet here", hint="write powers with **, for example [abcd]**2"
            )
        if step + a.step < rank and 0 in (step, a.step):
            raise StepError("a meet with a scalar (step 0)", hint="multiply scalars with * or a space")
        if step + a.step < rank:
            raise StepError(
                f"{step_name(step, rank)} and {step_name(a.step, rank)} are too small to meet in rank {rank}: "
                f"their steps add up to {step + a.step}, expected at least {rank}",
                hint="did you mean a join \\/ ?",
            )
        step += a.step - rank
    return flat[0] if len(flat) == 1 else Meet(tuple(flat), rank)


def add(*terms: Expr, rank: int = 4) -> Expr:
    """The sum of expressions of equal step. Raises StepError for unlike steps."""
    flat = list(chain.from_iterable(t.terms if type(t) is Sum else (t,) for t in terms))
    rest = [t for t in flat if not isinstance(t, Number)]
    constant = Number(sum((t.value for t in flat if isinstance(t, Number)), 0))
    if constant != ZERO:
        rest.append(constant)
    for t in rest[1:]:
        if t.step != rest[0].step:
            raise StepError(f"cannot add {step_name(t.step, rank)} to {step_name(rest[0].step, rank)}")
    if not rest:
        return ZERO
    return rest[0] if len(rest) == 1 else Sum(tuple(rest))


def neg(e: Expr) -> Expr:
    """−e."""
    return mul(Number(-1), e)


def signed(sign: int, e: Expr) -> Expr:
    """sign · e, a minus sign written into the terms of a sum."""
    return add(*map(neg, e.terms)) if sign == -1 and type(e) is Sum else mul(Number(sign), e)


def sub(a: Expr, b: Expr, rank: int = 4) -> Expr:
    """a − b."""
    return add(a, neg(b), rank=rank)


def mul(*factors: Expr) -> Expr:
    """The product of scalars and at most one extensor. Raises StepError for two extensors."""
    flat = list(chain.from_iterable(f.factors if isinstance(f, Product) else (f,) for f in factors))
    if sum(f.step > 0 for f in flat) > 1:
        raise StepError(
            "a product of two extensors", hint="write their join as A \\/ B (or side by side), their meet as A /\\ B"
        )
    coefficient: int | Fraction = 1
    rest = []
    for f in flat:
        if isinstance(f, Number):
            coefficient = Number(coefficient * f.value).value
        else:
            rest.append(f)
    if coefficient == 0:
        return ZERO
    if coefficient != 1 or not rest:
        rest.insert(0, Number(coefficient))
    return rest[0] if len(rest) == 1 else Product(tuple(rest))


def subexpressions(e: Expr) -> Iterator[Expr]:
    """The expression and all its parts, parents first."""
    stack = [e]
    for _ in watched(repeat(None), every=1_000):  # shared parts come again and again
        if not stack:
            return
        top = stack.pop()
        yield top
        stack.extend(reversed(top.children))


def points_of(*exprs: Expr) -> tuple[str, ...]:
    """The names of all points that occur, in the order of first occurrence."""
    names: dict[str, None] = {}
    for e in exprs:
        for part in subexpressions(e):
            if isinstance(part, Point):
                names[part.name] = None
            elif isinstance(part, Dotted):
                names.update((n, None) for entries in part.brackets for n, _ in entries)
    return tuple(names)


def rank_of(*exprs: Expr) -> int | None:
    """The rank that the brackets and meets of expressions are written in; None if they hold neither.

    Raises StepError where they are written in different ranks.
    """
    found = {r for e in exprs for part in subexpressions(e) if (r := _own_rank(part)) is not None}
    if len(found) > 1:
        raise StepError(f"expressions of different ranks cannot be combined: {', '.join(map(str, sorted(found)))}")
    return found.pop() if found else None


def _own_rank(e: Expr) -> int | None:
    match e:
        case Meet(rank=rank):
            return rank
        case Bracket(args=args):
            return sum(a.step for a in args)
        case Superbracket():
            return e.rank
        case Dotted(brackets=brackets):
            return len(brackets[0])
    return None


def common_rank(rank: int | None, *exprs: Expr) -> int:
    """The rank to work in: the one asked for or else the one the expressions are written in, 4 where both are silent.

    Raises StepError where they contradict each other.
    """
    found = rank_of(*exprs)
    if rank is not None and found is not None and rank != found:
        raise StepError(f"the expression is written in rank {found}, not in rank {rank}")
    return rank or found or 4
