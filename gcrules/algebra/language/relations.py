r"""Relations of points, lines and planes: collinear(a, b, c), incident(p, X), concyclic(a, b, c, d) …

They are assumed by `given` and claimed by `claim`, and so are equations LHS == RHS.

>>> found = parse_claim("collinear(a, b, c)", Context(rank=3))
>>> [(str(left), str(right)) for left, right in found.equations], found.relation
([('[abc]', '0')], 'collinear(a, b, c)')
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import islice

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.incidences import MAX_CONDITIONS, equations
from gcrules.algebra.duality import Dual, dual_of
from gcrules.algebra.expr import ZERO, Expr, Point, points_of
from gcrules.algebra.language.conic_words import conic_behind
from gcrules.algebra.language.letter_words import RELATIONS_OF_LETTERS
from gcrules.algebra.language.parse_tree import Node, read, span_of
from gcrules.algebra.language.relation_words import INCIDENCES, RELATIONS
from gcrules.algebra.language.syntax import Builder, Context
from gcrules.algebra.language.with_polars import WithPolars
from gcrules.algebra.language.words import SEGMENT, Relation, Requirement, ends
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conics_of, named_letter
from gcrules.algebra.names import primed
from gcrules.algebra.space import Assumption, SourcePlace, Space, Written
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError

__all__ = [
    "Claimed",
    "parse_claim",
    "parse_sides",
    "read_assumptions",
    "read_claim",
]


@dataclass(frozen=True, slots=True)
class Claimed:
    """Equations that are claimed together; `relation` is how they were written if that was one word, of `args`.

    The claim is about positions at which nothing `required` vanishes, which is told, nor the expressions of `nonzero`.
    `kind` is the name of a relation of incidence; `written` is what was read, where letters for conics or quadrics are
    declared. With a `dual` what is claimed is that; the equations are those of which it is the dual, which hold exactly
    where it does.
    """

    equations: tuple[tuple[Expr, Expr], ...]
    relation: str = ""
    required: tuple[Requirement, ...] = ()
    nonzero: tuple[Expr, ...] = ()
    args: tuple[Expr, ...] = ()
    kind: str = ""
    dual: Dual | None = None
    written: tuple[Written, ...] = ()

    def says(self) -> tuple[Written, ...]:
        """What was read, or else the relation or the equations."""
        if self.written or not self.kind:
            return self.written or tuple(Written("equal", pair) for pair in self.equations)
        return (Written(self.kind, self.args),)


def parse_claim(text: str, context: Context | None = None, filename: str = "<input>") -> Claimed:
    """Read `LHS == RHS` or a relation. Raises SyntaxFault, StepError and InputError with line and column."""
    builder, shown = Builder(context or Context()), " ".join(text.split())

    def claimed(tree: Node) -> Claimed:
        try:
            return read_claim(tree.children[0], builder, shown)
        except GcrulesError as fault:
            fault.span = fault.span or span_of(tree)
            raise

    return read(text, "claimed", filename, claimed)


def parse_sides(left: str | Expr, right: str | Expr, context: Context | None = None) -> Claimed:
    """The claim that two expressions are equal, each of them made or as text. Raises what `parse_claim` does."""
    builder = Builder(context or Context())

    def side(e: str | Expr) -> Expr:
        if isinstance(e, Expr):
            return e
        return read(e, "expression", "<input>", lambda tree: builder.value(tree.children[0]))

    sides = side(left), side(right)
    return Claimed((sides,), "", builder.requirements(), _apart(builder))


def read_claim(tree: Node, builder: Builder, text: str) -> Claimed:
    """The claim of a parse tree; `text` is how it was written."""
    if tree.data == "dual":
        return _dual(tree, builder, text)
    if tree.data == "equation":
        sides = builder.equation(tree)
        said = text if conics_of(points_of(*sides)) else ""
        return Claimed((sides,), said, builder.requirements(), _apart(builder), written=_written(tree, builder.context))
    kind, args, letter = _arguments(tree, builder)
    if letter:
        own = FORMS[builder.rank].own(letter)
        found = tuple(RELATIONS_OF_LETTERS[builder.rank][kind].whole(builder.rank, own, *args))
        kind = ""
    elif kind in INCIDENCES:
        found = equations(Assumption(kind, args, text, role="claim"), builder.rank)
    else:
        found = tuple(_expanded(RELATIONS[kind], args, builder.context)[0])
    claimed: tuple[tuple[Expr, Expr], ...] = tuple((e, ZERO) for e in found) or ((ZERO, ZERO),)
    lines = tuple(a for a in args if a.step > 1)
    return Claimed(
        claimed,
        text,
        builder.requirements(),
        (*_apart(builder), *lines),
        args,
        kind if kind in INCIDENCES else "",
        written=_written(tree, builder.context),
    )


def _dual(tree: Node, builder: Builder, text: str) -> Claimed:
    """The dual of a claim, under the duals of what is given."""
    (inner,) = tree.children
    at = builder.context
    if inner.data == "dual":
        raise InputError("the dual of a dual is the claim itself", span=span_of(inner), hint="leave out both")
    if at.ideal:
        what = f"a dual is projective, and {at.ideal[0]} is a point at infinity, a word without a dual"
        raise InputError(what, hint="claim it without points at infinity")
    found = read_claim(inner, builder, text)
    if any(not r.letter for some in (*at.required.values(), found.required) for r in some):
        raise InputError("the dual of a construction has no word", hint="write out its joins and meets")
    return replace(found, relation=text, dual=dual_of(found.says(), at.given, builder.rank))


def _written(tree: Node, at: Context) -> tuple[Written, ...]:
    """What a parse tree says with polars as such, where letters for conics or quadrics are declared."""
    if not at.conics:
        return ()
    builder = WithPolars(at)
    if tree.data in ("equation", "equal"):
        return (builder.said(*builder.equation(tree if tree.data == "equation" else tree.children[0])),)
    kind, args, letter = _arguments(tree, builder)
    if letter and kind == "touches":
        return (Written(kind, args, letter),)
    if letter:
        return tuple(Written("on", (p,), letter) for p in args)
    if kind in INCIDENCES:
        return (Written(kind, args),)
    return tuple(Written("zero", (e,)) for e in _expanded(RELATIONS[kind], args, at)[0])


def read_assumptions(
    tree: Node, builder: Builder, text: str, place: SourcePlace | None = None
) -> tuple[Assumption, ...]:
    """The assumptions of a parse tree: several where a relation is more than one equation.

    `text` is how it was written, `place` where. Raises StepError, InputError.
    """
    if tree.data == "equal":
        left, right = builder.equation(tree.children[0])
        zero = left if right == ZERO else right if left == ZERO else ex.sub(left, right, rank=builder.rank)
        return (
            Assumption(
                "zero", (zero,), text, place, exists=_existing(builder), written=_written(tree, builder.context)
            ),
        )
    kind, args, letter = _arguments(tree, builder)
    written = _written(tree, builder.context)
    if letter:
        own, word = FORMS[builder.rank].own(letter), RELATIONS_OF_LETTERS[builder.rank][kind]
        exists = _existing(builder)
        if word.at_point is None:
            whole = word.whole(builder.rank, own, *args)
            return tuple(Assumption("zero", (e,), text, place, exists=exists, written=written) for e in whole)
        t = _further_point(args[0], letter, builder.context)
        found, exists = word.at_point(builder.rank, own, t, *args), (*exists, *args)
        return tuple(Assumption(k, some, text, place, exists=exists, written=written) for k, some in found)
    if kind in INCIDENCES:
        return (Assumption(kind, args, text, place, exists=_existing(builder), written=written),)
    whole, chain = _expanded(RELATIONS[kind], args, builder.context)
    exists = (*_existing(builder), *(a for a in args if a.step > 1))
    also = tuple(e for e in whole if e not in chain)
    return tuple(Assumption("zero", (e,), text, place, also=also, exists=exists, written=written) for e in chain)


def _further_point(flat: Expr, conic: str, at: Context) -> Point:
    """The point in which a line or a plane touches a conic or a quadric, by a name that is not taken: t_PQ."""
    letter, made_of = named_letter(flat), flat.args if isinstance(flat, ex.Join) else ()
    if letter is None and not all(isinstance(a, Point) for a in made_of or (flat,)):
        hint = f"say where: `given incident(a, {conic})`, and its tangent at a touches there"
        raise InputError("that something touches is assumed of letters and of joins of points", hint=hint)
    name = re.sub(r"\W", "", "".join([letter or "".join(points_of(flat)), conic]))
    taken = {*at.points, *points_of(flat, *(e for a in at.given for e in a.args))}
    return Point(primed(f"t_{name}", taken.__contains__))


def _apart(builder: Builder) -> tuple[Expr, ...]:
    """What is not zero wherever what was read means something."""
    infinity = builder.context.infinity
    return (*((infinity.flat,) if infinity else ()), *builder.lettered.values())


def _existing(builder: Builder) -> tuple[Expr, ...]:
    return (*_apart(builder), *(r.expr for r in builder.requirements()))


def _arguments(tree: Node, builder: Builder) -> tuple[str, tuple[Expr, ...], str]:
    """The name of a relation, its arguments, which it takes, and the letter behind them that stands for a conic or a
    quadric, "" where there is none.
    """
    token, *parts = tree.children
    kind, rank, others = str(token), builder.rank, (*INCIDENCES, *RELATIONS)
    of_letters = RELATIONS_OF_LETTERS.get(rank, {})
    parts, conic = conic_behind(kind, of_letters, others, parts, builder.context.conics, rank)
    args = tuple(map(builder.value, parts))
    if conic:
        builder.check(of_letters[kind], args, parts)
    elif kind in INCIDENCES:
        INCIDENCES[kind](args, parts, rank)
    else:
        word = RELATIONS[kind]
        builder.check(word, args, parts)
    return kind, args, conic


def _expanded(word: Relation, args: Sequence[Expr], at: Space) -> tuple[list[Expr], list[Expr]]:
    """All equations of a relation, and those of its chain."""
    given = [ends(a) if kind == SEGMENT else a for a, kind in zip(args, word.kinds(len(args)), strict=True)]
    where = (at.infinity,) if word.metric else ()
    whole = list(islice(word.whole(*where, *given), MAX_CONDITIONS + 1))
    if len(whole) > MAX_CONDITIONS:
        raise InputError(f"{len(args)} arguments are more than {word.usage} can take", hint="say it of fewer at a time")
    return whole, list(word.chain(*where, *given)) if word.chain else whole
