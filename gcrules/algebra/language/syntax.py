r"""From text to expressions; every fault carries its place.

>>> parse(r"(ab /\ cde) f").step
2
>>> parse("[.a d e f][.b g h i]") == parse("[ȧdef][ḃghi]")
True
>>> parse("[abc]")
Traceback (most recent call last):
gcrules.core.errors.StepError: <input>:1:1: a bracket of 3 points, expected 4 in rank 4
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction

from gcrules.algebra import expr as ex
from gcrules.algebra import scalars
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.conic_words import called, conic_behind, known_on, refuse_conic
from gcrules.algebra.language.dotted_letters import beside_dots
from gcrules.algebra.language.letter_words import CONSTRUCTIONS_OF_LETTERS
from gcrules.algebra.language.parse_tree import Node, digits, read, run_name, span_of, whole
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.algebra.language.words import (
    CONSTRUCTIONS,
    POINT,
    SEGMENT,
    Requirement,
    Word,
    constructed,
    ends,
)
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import letter
from gcrules.algebra.names import step_name
from gcrules.algebra.scalars import MAX_EXPONENT, superbracket
from gcrules.algebra.space import Space, shortened
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, StepError, SyntaxFault
from gcrules.core.frozen import FrozenMap

__all__ = ["Builder", "Context", "parse", "parse_equation"]

MAX_DEPTH = 100
MAX_NODES = 50_000
MAX_WORD = 1_000


@dataclass(frozen=True, slots=True)
class Context(Space):
    """What names mean: a space, and the names bound by `let`, each with what its words require not to vanish; which of
    what these made is `finite` then. `letters`, each with its step, stand for lines, planes and hyperplanes, or are
    `screws`; `conics` for conics, in space quadrics, whose forms in `on_conics` are zero, as words made points of them;
    what was bound since then is in `with_polars` too, with polars as such.
    """

    bound: Mapping[str, Expr] = FrozenMap()
    required: Mapping[str, tuple[Requirement, ...]] = FrozenMap()
    finite: frozenset[Expr] = frozenset()
    letters: Mapping[str, int] = FrozenMap()
    screws: tuple[str, ...] = ()
    conics: tuple[str, ...] = ()
    with_polars: Mapping[str, Expr] = FrozenMap()
    on_conics: frozenset[Expr] = frozenset()

    def __post_init__(self) -> None:
        for key in ("bound", "required", "letters", "with_polars"):
            object.__setattr__(self, key, FrozenMap(getattr(self, key)))
        Space.__post_init__(self)

    def declared(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys((*self.points, *self.ideal, *self.letters, *self.conics, *self.bound)))


def parse(text: str, *, rank: int = 4, points: Iterable[str] = (), context: Context | None = None) -> Expr:
    """Read one expression.

    `points` declares names of several letters (and the tableau order). Raises SyntaxFault or StepError
    with line, column and caret.
    """
    context = context or Context(rank, tuple(points))
    return read(text, "expression", "<input>", lambda tree: Builder(context).value(tree.children[0]))


def parse_equation(
    text: str, *, rank: int = 4, points: Iterable[str] = (), context: Context | None = None
) -> tuple[Expr, Expr]:
    """Read `LHS == RHS`."""
    context = context or Context(rank, tuple(points))
    return read(text, "equation", "<input>", lambda tree: Builder(context).equation(tree))


# --- from the tree to values ---------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _DottedRun:
    """Points written side by side, at least one of them dotted; has a meaning only directly inside a bracket."""

    points: tuple[tuple[str, bool], ...]


@dataclass(frozen=True, slots=True)
class _DottedBracket:
    points: tuple[tuple[str, bool], ...]


_KINDS = {1: "the point", 2: "the line", 3: "the plane"}
_Value = Expr | _DottedRun | _DottedBracket


class Builder:
    """Turns a parse tree into an expression: one short method for each rule of the grammar.

    `runs` gives the points that a run (`R...`) stands for; outside rules there are none.
    """

    def __init__(self, context: Context, runs: Mapping[str, tuple[str, ...]] | None = None) -> None:
        self.context = context
        self.runs = runs
        self.rank = context.rank
        self.level = 0
        self.made: dict[Expr, str] = {}  # what words make, as it is called
        self.finite = set(context.finite)  # those of it that are, if what they are made of is
        self.on_conics = set(context.on_conics)
        self.required: dict[Expr, Requirement] = {}  # what must not vanish so that it exists
        self.lettered: dict[str, Expr] = {}  # the letters that were read, none of which is zero
        self.parts = 0  # size of the names bound by `let` that were written out
        self.sizes: dict[str, tuple[int, int]] = {}
        self.long_names = sorted(
            (n for n in context.declared() if not SHORT_NAME.fullmatch(n)), key=lambda n: (-len(n), n)
        )

    def value(self, tree: Node) -> Expr:
        """The expression of a subtree; dots that are not inside a bracket of points are faults here."""
        return self._plain(self.any(tree), tree)

    def _plain(self, found: _Value, tree: Node) -> Expr:
        if isinstance(found, _DottedBracket):
            return scalars.dotted(found.points, rank=self.rank)
        if isinstance(found, _DottedRun):
            raise SyntaxFault(
                "a dot outside a bracket", span=span_of(tree), hint="dots mark points of brackets: [.a b c d]"
            )
        return found

    def any(self, tree: Node) -> _Value:
        self.level += 1
        checkpoint()
        try:
            if self.level > MAX_DEPTH:
                raise SyntaxFault(f"more than {MAX_DEPTH} operations inside each other")
            found: _Value = getattr(self, tree.data)(tree)
            return found
        except GcrulesError as fault:
            fault.span = fault.span or span_of(tree)
            raise
        finally:
            self.level -= 1

    def equation(self, tree: Node) -> tuple[Expr, Expr]:
        left, right = map(self.value, tree.children)
        if left.step != right.step and ex.ZERO not in (left, right):
            names = (step_name(left.step, self.rank), step_name(right.step, self.rank))
            raise StepError(f"{names[0]} cannot equal {names[1]}", span=span_of(tree))
        return left, right

    def sum(self, tree: Node) -> Expr:
        first, *rest = tree.children
        terms = [self.value(first)]
        for sign, term in zip(rest[::2], rest[1::2], strict=True):
            terms.append(ex.neg(self.value(term)) if sign.type == "MINUS" else self.value(term))
            if terms[-1].step != terms[0].step and ex.ZERO not in (terms[-1], terms[0]):
                names = (step_name(terms[-1].step, self.rank), step_name(terms[0].step, self.rank))
                raise StepError(
                    f"cannot add {names[0]} to {names[1]}",
                    span=span_of(term),
                    hint="terms of a sum must have equal steps",
                )
        return ex.add(*terms, rank=self.rank)

    def signed(self, tree: Node) -> Expr:
        *signs, operand = tree.children
        negative = sum(s.type == "MINUS" for s in signs) % 2
        return ex.neg(self.value(operand)) if negative else self.value(operand)

    def product(self, tree: Node) -> Expr:
        return ex.mul(*map(self.value, tree.children))

    def meet(self, tree: Node) -> Expr:
        return ex.meet(*map(self.value, tree.children), rank=self.rank)

    def join(self, tree: Node) -> Expr:
        parts: list[Expr] = []
        for part in tree.children:
            parts.append(self.value(part))
            if sum(p.step for p in parts[-self.rank - 1 :]) > self.rank:
                break  # a fault, whatever follows
        return ex.join(*parts, rank=self.rank)

    def juxtaposition(self, tree: Node) -> _Value:
        trees = self._present(tree.children)
        parts = [self.any(t) for t in trees]
        if any(isinstance(p, _DottedRun) for p in parts):
            return _DottedRun(tuple(entry for p, t in zip(parts, trees, strict=True) for entry in self._entries(p, t)))
        dotted = [p.points for p in parts if isinstance(p, _DottedBracket)]
        plain = [p for p in parts if isinstance(p, Expr)]
        return ex.join(*plain, *([scalars.dotted(*dotted, rank=self.rank)] if dotted else []), rank=self.rank)

    def _entries(self, part: _Value, tree: Node) -> tuple[tuple[str, bool], ...]:
        match part:
            case _DottedRun(points=points):
                return points
            case ex.Point(name=name):
                return ((name, False),)
            case ex.Join(args=args) if all(isinstance(a, ex.Point) for a in args):
                return tuple((str(a), False) for a in args)
        raise SyntaxFault("a dotted bracket can only hold points", span=span_of(tree))

    def construction(self, tree: Node) -> Expr:
        token, *parts = tree.children
        if str(token) in self.context.declared():
            hint = f"write a space behind the name: {token} (…)"
            raise InputError(f"{token} is declared here, and a word of the language", span=span_of(token), hint=hint)
        of_letters, letters = CONSTRUCTIONS_OF_LETTERS.get(self.rank, {}), self.context.conics
        parts, conic = conic_behind(str(token), of_letters, CONSTRUCTIONS, parts, letters, self.rank)
        word, args = (of_letters if conic else CONSTRUCTIONS)[str(token)], tuple(map(self.value, parts))
        self.check(word, args, parts)
        own = FORMS[self.rank].own(conic) if conic else ()
        if word.on is not None:
            known_on(args[word.on], conic, self._called, self.context, self.on_conics, parts[word.on])
        made, may_vanish = constructed(word, args, self.context, own)
        if word.on == 1:
            self.on_conics.add(FORMS[self.rank].value(made, *own))
        self._count(made, word.name)
        self.made[made] = f"{word.name}({', '.join((*map(self._called, args), *filter(None, [conic])))})"
        if may_vanish:
            self.required[made] = Requirement(made, self.made[made], f"{_KINDS.get(made.step, 'it')} exists", conic)
        else:
            self.finite.add(made)
        return made

    def check(self, word: Word, args: tuple[Expr, ...], trees: list[Node]) -> None:
        """That a word can be said of its arguments; its points are finite then. Raises InputError, StepError."""
        word.check(args, [span_of(t) for t in trees], self.context)
        if not word.metric or self.context.infinity is None:
            return
        for arg, kind in zip(args, word.kinds(len(args)), strict=True):
            for p in (arg,) if kind == POINT else ends(arg) if kind == SEGMENT else ():
                if isinstance(p, ex.Point) or p in self.finite:
                    continue
                name, weight = self._called(p), self.context.infinity.weight(p)
                self.required.pop(p, None)
                written = f"[{', '.join((name, *self.context.infinity.points))}]"
                self.required[weight] = Requirement(weight, written, f"{name} is finite")

    def _called(self, e: Expr) -> str:
        """The text of an argument: its name, or the words that made it."""
        named = next((name for name, value in self.context.bound.items() if value == e), None)
        return named or called(e, {v: n for n, v in self.context.bound.items()} | self.made, self.context.declared())

    def requirements(self) -> tuple[Requirement, ...]:
        """What must not vanish, by the words that were read."""
        return tuple(self.required.values())

    def power(self, tree: Node) -> Expr:
        base, exponent = tree.children
        n = whole(exponent, "an exponent")
        if n > MAX_EXPONENT:
            raise SyntaxFault(f"an exponent above the limit {MAX_EXPONENT}", span=span_of(exponent))
        return scalars.power(self.value(base), n, rank=self.rank)

    def word(self, tree: Node) -> _Value:
        entries = self.split(tree.children[0])
        if any(d for _, d in entries):
            return self._dotted(entries, tree)
        return ex.join(*(self.named(n) for n, _ in entries), rank=self.rank)

    def dotted_word(self, tree: Node) -> _DottedRun:
        (first, _), *rest = self.split(tree.children[0])
        return self._dotted([(first, True), *rest], tree)

    def _dotted(self, entries: Sequence[tuple[str, bool]], tree: Node) -> _DottedRun:
        """Points of which some are dotted, with those of letters among them, which are not."""
        found: list[tuple[str, bool]] = []
        for name, dot in entries:
            at = self.context
            if name in at.letters or name in at.conics:
                self.named(name)
            found += beside_dots(name, dot, at.letters, at.screws, span_of(tree))
        return _DottedRun(tuple(found))

    def run(self, tree: Node) -> _Value:
        if self.runs is None:
            raise SyntaxFault("a run of points occurs only in rules", span=span_of(tree), hint="write the points")
        points = self.runs[run_name(tree)]
        if not points:
            raise SyntaxFault("this run is empty here, and can only stand beside other points", span=span_of(tree))
        return ex.join(*map(ex.Point, points), rank=self.rank)

    def _present(self, trees: list[Node]) -> list[Node]:
        """Without runs that are empty in this rank."""
        return [t for t in trees if t.data != "run" or not self.runs or self.runs[run_name(t)]]

    def number(self, tree: Node) -> Expr:
        token = tree.children[0]
        try:
            return ex.Number(Fraction(digits(token)))
        except ZeroDivisionError:
            raise SyntaxFault("division by zero", span=span_of(token)) from None

    def bracket(self, tree: Node) -> _Value:
        first = tree.children[0]
        if len(tree.children) == 1 and first.data == "bracket" and span_of(first).start == span_of(tree).start + 1:
            return superbracket(*map(self.value, first.children), rank=self.rank)
        sizes = [self._size(t) for t in tree.children]
        if None not in sizes and sum(n or 0 for n in sizes) > self.rank:
            scalars.bracket(*[ex.Point("a")] * sum(n or 0 for n in sizes), rank=self.rank)  # raises, naming the bracket
        trees = self._present(tree.children)
        parts = [self.any(t) for t in trees]
        if any(isinstance(p, _DottedRun) for p in parts):
            entries = [e for p, t in zip(parts, trees, strict=True) for e in self._entries(p, t)]
            if len(entries) != self.rank:
                raise StepError(f"a bracket of {len(entries)} points, expected {self.rank} in rank {self.rank}")
            return _DottedBracket(tuple(entries))
        return scalars.bracket(*map(self._plain, parts, trees), rank=self.rank)

    def _size(self, tree: Node) -> int | None:
        """The number of points if there are only points side by side."""
        words = tree.children if tree.data == "juxtaposition" else [tree]
        if any(w.data != "word" for w in words):
            return None
        names = [n for w in words for n, _ in self.split(w.children[0])]
        others = (self.context.bound, self.context.letters)
        return None if any(n in some for n in names for some in others) else len(names)

    def named(self, name: str) -> Expr:
        """What a name stands for, counted among the parts of the expression."""
        bound = self.context.bound.get(name)
        refuse_conic(name, self.context.conics, self.rank)
        if name in self.context.letters:
            self.lettered[name] = letter(name, self.context.letters[name], self.context.screws)
            return self.lettered[name]
        if bound is None:
            return ex.Point(name)
        self._count(bound, name)
        self.required.update({r.expr: r for r in self.context.required.get(name, ())})
        return bound

    def _count(self, e: Expr, name: str) -> None:
        """Count the parts of what a name or a word stands for."""
        if name not in self.sizes or name in CONSTRUCTIONS:
            self.sizes[name] = _measure(e)
        size, depth = self.sizes[name]
        self.parts += size
        if self.parts > MAX_NODES:
            raise SyntaxFault(f"names bound by `let`, and words, stand for more than {MAX_NODES:,} parts here")
        if self.level + depth > MAX_DEPTH:
            raise SyntaxFault(f"with {shortened(name)} written out this is more than {MAX_DEPTH} operations deep")

    def split(self, token: Node) -> list[tuple[str, bool]]:
        """Points of a word: a declared name, else declared long names and short names from left to right."""
        if len(token) > MAX_WORD:
            raise SyntaxFault(f"a word of {len(token):,} characters; the limit is {MAX_WORD:,}", span=span_of(token))
        if str(token) in self.long_names:
            return [(str(token), False)]
        word = unicodedata.normalize("NFD", token)
        entries, at = [], 0
        while at < len(word):
            name = next((n for n in self.long_names if word.startswith(n, at)), None)
            match = SHORT_NAME.match(word, at)
            if name is None and match is None:
                hint = "points are a letter with digits or primes: a, S1, S_2, A'"
                raise SyntaxFault(f"{shortened(token)!r} is not made of point names", span=span_of(token), hint=hint)
            name = name or (match[0] if match else "")
            at += len(name)
            dotted = word[at : at + 1] == "\u0307"
            if dotted:
                suffix = re.compile(r"(?:_?[0-9]+)?'*").match(word, at + 1)
                name += suffix[0] if suffix else ""
                at += 1 + (len(suffix[0]) if suffix else 0)
            entries.append((name, dotted))
        return entries


def _measure(e: Expr) -> tuple[int, int]:
    """Number of parts (shared ones counted each time they occur) and depth of an expression."""
    known: dict[int, tuple[int, int]] = {}

    def walk(x: Expr) -> tuple[int, int]:
        if id(x) not in known:
            parts = [walk(c) for c in x.children]
            known[id(x)] = (1 + sum(s for s, _ in parts), 1 + max((d for _, d in parts), default=0))
        return known[id(x)]

    return walk(e)
