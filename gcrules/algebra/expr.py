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

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import chain, combinations, repeat
from math import comb, factorial, isqrt, prod
from numbers import Integral, Rational

from gcrules.core.budget import watched
from gcrules.core.errors import InputError, LimitReached, StepError
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
    "bracket",
    "common_rank",
    "dotted",
    "exact_number",
    "join",
    "meet",
    "mul",
    "neg",
    "number",
    "permutation_sign",
    "point_key",
    "points_of",
    "power",
    "rank_of",
    "signed",
    "step_name",
    "sub",
    "subexpressions",
    "substitute",
    "superbracket",
    "too_many_bits",
]

MAX_DEPTH = 150
MAX_EXPONENT = 64
MAX_COEFFICIENT_BITS = 10_000
MAX_DOTTED_TERMS = 50_000


@dataclass(frozen=True, slots=True)
class Expr(Shown):
    """Base of all expressions; `step` is the step of the value (0 for scalars), `depth` that of the nesting."""

    step: int = field(init=False, repr=False, compare=False)
    depth: int = field(init=False, repr=False, compare=False)

    @property
    def children(self) -> tuple[Expr, ...]:
        return ()

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


def exact_number(value: object) -> int | Fraction | None:
    """A rational number as Python's own; None for what is none, floats among them, which are not exact."""
    if isinstance(value, Integral):
        return int(value)
    return Fraction(value) if isinstance(value, Rational) else None


def _measure(e: Expr, step: int) -> None:
    """Fill in the derived fields of a new expression."""
    depth = 1 + max((c.depth for c in e.children), default=0)
    if depth > MAX_DEPTH:
        raise LimitReached(f"an expression of more than {MAX_DEPTH} operations inside each other")
    object.__setattr__(e, "step", step)
    object.__setattr__(e, "depth", depth)


@dataclass(frozen=True, slots=True)
class Number(Expr):
    """A rational constant. Zero counts as an extensor of every step."""

    value: int | Fraction

    def __post_init__(self) -> None:
        value = self.value
        if isinstance(value, Fraction) and value.denominator == 1:
            object.__setattr__(self, "value", value.numerator)
        _measure(self, 0)
        if max(abs(value.numerator), value.denominator).bit_length() > MAX_COEFFICIENT_BITS:
            raise too_many_bits()


@dataclass(frozen=True, slots=True)
class Point(Expr):
    """A point (extensor of step 1) given by its name."""

    name: str

    def __post_init__(self) -> None:
        _measure(self, 1)


@dataclass(frozen=True, slots=True)
class Join(Expr):
    """A join of at least two extensors of positive step, none of them a join. Build with `join`."""

    args: tuple[Expr, ...]

    def __post_init__(self) -> None:
        _measure(self, sum(a.step for a in self.args))

    @property
    def children(self) -> tuple[Expr, ...]:
        return self.args


@dataclass(frozen=True, slots=True)
class Meet(Expr):
    """A meet in a space of the given rank, none of its arguments a meet. Build with `meet`."""

    args: tuple[Expr, ...]
    rank: int

    def __post_init__(self) -> None:
        _measure(self, sum(a.step for a in self.args) - self.rank * (len(self.args) - 1))

    @property
    def children(self) -> tuple[Expr, ...]:
        return self.args


@dataclass(frozen=True, slots=True)
class Bracket(Expr):
    """The bracket [A B …] = determinant of extensors whose steps add up to the rank. Build with `bracket`."""

    args: tuple[Expr, ...]

    def __post_init__(self) -> None:
        _measure(self, 0)

    @property
    def children(self) -> tuple[Expr, ...]:
        return self.args


@dataclass(frozen=True, slots=True)
class Dotted(Expr):
    """A product of brackets with dotted points: the signed sum over all ways to share the dotted points out among
    the dotted places, counting rearrangements within one bracket once. Entries: (name, dotted?). Build with `dotted`.
    """

    brackets: tuple[tuple[tuple[str, bool], ...], ...]

    def __post_init__(self) -> None:
        _measure(self, 0)

    def written_out(self) -> Expr:
        """The sum that the dots stand for."""
        names = [n for entries in self.brackets for n, d in entries if d]
        sizes = [sum(d for _, d in entries) for entries in self.brackets]
        if factorial(len(names)) // prod(map(factorial, sizes)) > MAX_DOTTED_TERMS:
            raise LimitReached(f"dotted brackets that stand for more than {MAX_DOTTED_TERMS:,} terms")
        terms = []
        for order in _deals(tuple(range(len(names))), sizes):
            moved = iter(names[i] for i in order)
            factors = [Bracket(tuple(Point(next(moved) if d else n) for n, d in entries)) for entries in self.brackets]
            terms.append(mul(Number(permutation_sign(order)), *factors))
        return add(*terms, rank=len(self.brackets[0]))


def _deals(cards: tuple[int, ...], sizes: Sequence[int]) -> Iterator[tuple[int, ...]]:
    """All ways to deal the cards out into hands of these sizes, each hand in increasing order."""
    if not sizes:
        yield ()
        return
    for hand in combinations(cards, sizes[0]):
        for others in _deals(tuple(c for c in cards if c not in hand), sizes[1:]):
            yield (*hand, *others)


@dataclass(frozen=True, slots=True)
class Superbracket(Expr):
    """The determinant of the matrix whose rows are the Plücker coordinates of n(n − 1)/2 lines in rank n: in rank 4
    the 6×6 determinant of six lines. Build with `superbracket`.
    """

    lines: tuple[Expr, ...]

    def __post_init__(self) -> None:
        _measure(self, 0)

    @property
    def rank(self) -> int:
        return (1 + isqrt(1 + 8 * len(self.lines))) // 2

    @property
    def children(self) -> tuple[Expr, ...]:
        return self.lines


@dataclass(frozen=True, slots=True)
class Sum(Expr):
    """A sum of at least two expressions of equal step. Build with `add`."""

    terms: tuple[Expr, ...]

    def __post_init__(self) -> None:
        _measure(self, self.terms[0].step)

    @property
    def children(self) -> tuple[Expr, ...]:
        return self.terms


@dataclass(frozen=True, slots=True)
class Product(Expr):
    """A product of scalars and at most one extensor; a number, if any, comes first. Build with `mul`."""

    factors: tuple[Expr, ...]

    def __post_init__(self) -> None:
        _measure(self, max(f.step for f in self.factors))

    @property
    def children(self) -> tuple[Expr, ...]:
        return self.factors


@dataclass(frozen=True, slots=True)
class Power(Expr):
    """A power of a scalar with exponent 2 or more. Build with `power`."""

    base: Expr
    exponent: int

    def __post_init__(self) -> None:
        _measure(self, 0)

    @property
    def children(self) -> tuple[Expr, ...]:
        return (self.base,)


ZERO = Number(0)
ONE = Number(1)


def too_many_bits() -> InputError:
    """What is raised for a number that is too large."""
    return InputError(f"a coefficient has more than {MAX_COEFFICIENT_BITS} bits")


def permutation_sign(order: Sequence[int]) -> int:
    """+1 for an even arrangement of distinct numbers, −1 for an odd one."""
    inversions = sum(order[i] > order[j] for i in range(len(order)) for j in range(i + 1, len(order)))
    return -1 if inversions % 2 else 1


_STEP_NAMES = {1: "a point", 2: "a line", 3: "a plane"}


def step_name(step: int, rank: int = 4) -> str:
    """What an extensor of this step is called: "a scalar", "a line (step 2)", …

    >>> step_name(2), step_name(3, rank=3)
    ('a line (step 2)', 'the whole space (step 3)')
    """
    if step == 0:
        return "a scalar (step 0)"
    if step == rank:
        return f"the whole space (step {step})"
    return f"{_STEP_NAMES.get(step, 'an extensor')} (step {step})"


def number(value: int | Fraction | str) -> Number:
    """A rational constant from an integer, a fraction or text such as "-3/4"."""
    return Number(Fraction(value) if isinstance(value, str) else value)


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


def bracket(*args: Expr, rank: int = 4) -> Expr:
    """The bracket [A B …] of extensors whose steps add up to the rank. Raises StepError for any other size."""
    if any(a == ZERO for a in args):
        return ZERO
    flat = tuple(chain.from_iterable(a.args if isinstance(a, Join) else (a,) for a in args))
    total = sum(a.step for a in flat)
    if total != rank or any(a.step == 0 for a in flat):
        what = (
            f"{total} point{'' if total == 1 else 's'}" if all(isinstance(a, Point) for a in flat) else f"step {total}"
        )
        raise StepError(
            f"a bracket of {what}, expected {rank} in rank {rank}",
            hint=None
            if total == rank or not 2 <= total <= 8
            else f"for another rank say so: `rank {total}` in a file, --rank {total} in the shell",
        )
    return Bracket(flat)


def dotted(*brackets: Sequence[tuple[str, bool]], rank: int = 4) -> Expr:
    """A product of brackets of points, each (name, dotted?). Without any dot this is the plain product."""
    for entries in brackets:
        if len(entries) != rank:
            raise StepError(f"a bracket of {len(entries)} points, expected {rank} in rank {rank}")
    plain = [b for b in brackets if not any(d for _, d in b)]
    with_dots = tuple(tuple(b) for b in brackets if any(d for _, d in b))
    factors = [bracket(*(Point(n) for n, _ in entries), rank=rank) for entries in plain]
    return mul(*factors, Dotted(with_dots)) if with_dots else mul(*factors)


def superbracket(*lines: Expr, rank: int = 4) -> Expr:
    """The superbracket of n(n − 1)/2 lines in rank n: [[ab]], [[ab, cd, ef]], [[ab, cd, ef, gh, ij, kl]], …

    Raises StepError for any other number of lines, and for an entry that is no line.
    """
    found, expected = len(lines), comb(rank, 2)
    if found != expected:
        raise StepError(
            f"a superbracket of {found} line{'' if found == 1 else 's'}, expected {expected} in rank {rank}",
            hint=_rank_of_lines(found),
        )
    if any(a == ZERO for a in lines):
        return ZERO
    for i, a in enumerate(lines, 1):
        if a.step != 2:
            raise StepError(f"entry {i} of the superbracket is {step_name(a.step, rank)}, expected a line (step 2)")
    return Superbracket(tuple(lines))


def _rank_of_lines(number: int) -> str:
    """What to do with so many lines in a superbracket."""
    for rank in range(2, 9):
        if comb(rank, 2) == number:
            count = "1 line makes" if number == 1 else f"{number} lines make"
            return f"{count} a superbracket in rank {rank}: `rank {rank}` in a file, --rank {rank} in the shell"
    return "rank n takes n(n - 1)/2 lines: 3 in rank 3, 6 in rank 4, 10 in rank 5"


def add(*terms: Expr, rank: int = 4) -> Expr:
    """The sum of expressions of equal step. Raises StepError for unlike steps."""
    flat = list(chain.from_iterable(t.terms if isinstance(t, Sum) else (t,) for t in terms))
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
    return add(*map(neg, e.terms)) if sign == -1 and isinstance(e, Sum) else mul(Number(sign), e)


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


def power(base: Expr, exponent: int, rank: int = 4) -> Expr:
    """base ** exponent for a scalar and a non-negative integer exponent of at most 64."""
    if base.step != 0:
        raise StepError(f"a power of {step_name(base.step, rank)}; only scalars have powers")
    if exponent > MAX_EXPONENT:
        raise LimitReached(f"exponent {exponent} is above the limit {MAX_EXPONENT}")
    if exponent == 0:
        return Number(1)
    if exponent == 1:
        return base
    if isinstance(base, Number):
        return Number(base.value**exponent)
    return Power(base, exponent)


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


def substitute(e: Expr, names: dict[str, Expr], rank: int = 4) -> Expr:
    """Replace points by expressions (usually other points). Raises StepError where the steps do not fit."""

    def walk(x: Expr) -> Expr:
        match x:
            case Point(name=name):
                return names.get(name, x)
            case Number():
                return x
            case Join(args=args):
                return join(*map(walk, args), rank=rank)
            case Meet(args=args, rank=r):
                return meet(*map(walk, args), rank=r)
            case Bracket(args=args):
                return bracket(*map(walk, args), rank=rank)
            case Superbracket(lines=lines):
                return superbracket(*map(walk, lines), rank=x.rank)
            case Sum(terms=terms):
                return add(*map(walk, terms), rank=rank)
            case Product(factors=factors):
                return mul(*map(walk, factors))
            case Power(base=base, exponent=n):
                return power(walk(base), n)
            case Dotted(brackets=brackets):
                return dotted(*([(_name_of(names, n), d) for n, d in entries] for entries in brackets), rank=rank)
        raise TypeError(f"not an expression: {x!r}")

    return walk(e)


def _name_of(names: dict[str, Expr], name: str) -> str:
    target = names.get(name, Point(name))
    if not isinstance(target, Point):
        raise InputError(f"a dotted bracket can only hold points; {name} stands for something else")
    return target.name


def point_key(name: str) -> tuple[str, int, int]:
    """Sort key of point names: letters first, then the numeric suffix, then primes.

    >>> sorted(["p10", "p2", "a'", "B", "a"], key=point_key)
    ['B', 'a', "a'", 'p2', 'p10']
    """
    stem = name.rstrip("'")
    letters = stem.rstrip("0123456789")
    digits = stem[len(letters) :]
    return letters.rstrip("_"), int(digits) if digits else -1, len(name) - len(stem)
