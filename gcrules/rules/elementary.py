r"""The elementary steps: the computations that derivations are made of, as rules.

>>> from gcrules.algebra.language.syntax import parse
>>> expansion = next(rule for rule in ELEMENTARY if rule.id == "expansion")
>>> print(expansion.rewrite(parse(r"ab /\ cde"), Space()))
[acde] * b - [bcde] * a
"""

from __future__ import annotations

from functools import partial

from gcrules.algebra import expr as ex
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.expr import Expr, Point, Sum
from gcrules.algebra.factoring.result import Factorization
from gcrules.algebra.parts import first_part
from gcrules.algebra.scalars import superbracket
from gcrules.algebra.space import Space
from gcrules.algebra.steps import (
    common_factors,
    expanded_meets,
    in_order,
    lines_in_order,
    multiplied_out,
    superbracket_terms,
    syzygy,
    without_dots,
    without_zeros,
)
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.superbrackets.shortest import shortest_forms
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError, LimitReached
from gcrules.rules.instance import of_the_catalog, structure_of
from gcrules.rules.rule import Elementary

__all__ = ["ELEMENTARY"]

factor = deferred("gcrules.algebra.factoring.factorize:factor")


def _shortest(e: Expr, space: Space) -> Expr | None:
    def at(part: Expr) -> Expr | None:
        structure = structure_of(part, space)
        if structure is None:
            return None
        form = shortest_forms(structure.neutral, points=structure.points, ideal=structure.ideal)[0]
        lines = (ex.join(*map(Point, structure.neutral[i])) for i in form.order)
        after = ex.mul(ex.Number(form.sign * structure.sign), superbracket(*lines))
        return None if after == part else after

    return first_part(e, at, space.rank)


def _straightened(e: Expr, space: Space) -> Expr | None:
    if e.step:
        return None
    found = straighten(e, points=space.points, ideal=space.ideal, rank=space.rank)
    assert isinstance(found, BracketPolynomial)
    after = found.to_expr()
    return None if after == e else after


def _factored(e: Expr, space: Space) -> Expr | None:
    """A sum as coefficient · Π brackets · one expression, if there is one."""
    if not isinstance(e, Sum) or e.step:
        return None
    if not straighten(e, points=space.points, ideal=space.ideal, rank=space.rank):
        return None
    try:
        answer: Factorization = factor(e, points=space.points, ideal=space.ideal, rank=space.rank, seconds=_SECONDS)
    except InputError:  # not homogeneous in the points
        return None
    if answer.exists is None:
        raise LimitReached(answer.certificate.detail)
    return answer.to_expr()


_SECONDS = 5.0
_SINGULAB = "SinguLab2008"

ELEMENTARY = (
    Elementary(
        id="catalog",
        sentence="The condition of a class of the catalog, whose identity `gcrules catalog check` proves.",
        fires=("[[ab, af, cb, cd, ed, ef]]", r"(ABc /\ ACd /\ ab) [[Aa, Ab, Bc, Cd, De, Ef]]"),
        silent=("[[Aa, Bb, Cc, Dd, Ee, Ef]] [abcd]", "[[ab, ac, ad, bc, bd, cd]]", "[abcd]"),
        apply=of_the_catalog,
    ),
    Elementary(
        id="shortest-form",
        sentence="The lines of a superbracket in the order and turned so that the fewest terms are left.",
        source=_SINGULAB,
        fires=("[[Aa, Ab, Bc, Bd, Ce, Cf]]",),
        silent=("[[Aa, Ab, Ac, Bd, Be, Cf]]", "[abcd]"),
        apply=_shortest,
    ),
    Elementary(
        id="reordering",
        sentence="Exchanging two lines of a superbracket, or the two points of a line, changes the sign.",
        fires=("[[ba, cd, ef, gh, ij, kl]]", "2 [[cd, ab, ef, gh, ij, kl]] - [abcd][efgh][ijkl]"),
        silent=("[[ab, cd, ef, gh, ij, kl]]", r"[[abm /\ cde, dc, ef, gh, ij, kl]]"),
        apply=lines_in_order,
    ),
    Elementary(
        id="superbracket",
        sentence="The superbracket of six lines by its 24 terms.",
        source=_SINGULAB,
        fires=("[[ab, cd, ef, gh, ij, kl]]", "-[[ab, af, cb, cd, ed, ef]]"),
        silent=("[abcd]", r"[[abm /\ cde, cd, ef, gh, ij, kl]]"),
        apply=superbracket_terms,
    ),
    Elementary(
        id="superbracket-16",
        sentence="The superbracket of six lines by 16 terms.",
        fires=("[[ab, cd, ef, gh, ij, kl]]",),
        silent=("[abcd]", r"[[abm /\ cde, cd, ef, gh, ij, kl]]"),
        apply=partial(superbracket_terms, form=16),
    ),
    Elementary(
        id="vanishing",
        sentence="A bracket with a repeated point is 0, and so is one with points at infinity only.",
        source=_SINGULAB,
        fires=("[abca][defg] + [abcd][aefg]", r"aab \/ c"),
        silent=("[abcd][abce]", r"ab /\ abc"),
        apply=without_zeros,
    ),
    Elementary(
        id="dots",
        sentence="Dotted points are shared out among their places in all ways, with the sign of the rearrangement.",
        fires=("[.a b c d][.e f g h]", "[abcd] * [.a b .c d][.e f g h]"),
        silent=("[abcd][efgh]",),
        apply=without_dots,
    ),
    Elementary(
        id="sorting",
        sentence="Points and brackets in tableau order, with the sign of the exchanges; like terms are collected.",
        fires=("[bacd]", "[efgh][abcd] + [abcd][efgh]", "[abcd]([fegh] - [efhg])", "[abcd] ba"),
        silent=("[abcd][efgh]", "[abcd]([efgh] - [efgi])", r"[bacd] (ab /\ cd)"),
        apply=in_order,
    ),
    Elementary(
        id="multiplying-out",
        sentence="Products, joins, meets and brackets of sums are multiplied out; scalars go in front.",
        fires=("[abcd]([efgh] + [efgi])", r"([acde] b - [bcde] a) /\ fgh", "([abcd] - [abce])**2"),
        silent=("[abcd][efgh] + [abce][dfgh]", r"ab /\ cde"),
        apply=multiplied_out,
    ),
    Elementary(
        id="factoring-out",
        sentence="A bracket that all terms share goes in front of them.",
        source=_SINGULAB,
        fires=("[abcd][efgh] - [abcd][efgi]",),
        silent=("[abcd][efgh] - [abce][efgi]", "[abcd]"),
        apply=common_factors,
    ),
    Elementary(
        id="factorization",
        sentence="A polynomial that is a product of brackets and one expression of joins and meets, as that product.",
        fires=("[abfc][acde][bdef] + [abfd][acbe][cdef]", "[acde][bfgh] - [bcde][afgh]"),
        silent=("[abcd][efgh] + [abce][dfgh] + [abcf][degh]", "[abcd] - [abce]", r"ab /\ cd"),
        apply=_factored,
    ),
    Elementary(
        id="expansion",
        sentence="A meet of joins of points is a sum over shuffles: the points of one go into the bracket or stay.",
        fires=(r"ab /\ cde", r"abc /\ def /\ ghi", r"[ab /\ cde, f, g, h]"),
        silent=(r"(ab + cd) /\ efg", "[abcd]", "abc"),
        apply=expanded_meets,
    ),
    Elementary(
        id="van-der-waerden",
        sentence="A van der Waerden syzygy replaces the largest product of brackets that is not a standard tableau.",
        fires=("[abch][defg]", "[abcd][abef] + [abch][defg]"),
        silent=("[abcd][abef]", "[bach][defg]", r"ab /\ cd"),
        apply=syzygy,
    ),
    Elementary(
        id="straightening",
        sentence="The normal form: standard tableaux only.",
        fires=("[abch][defg]", r"ab /\ cd", "[[ab, bc, ca, de, ef, fd]] - [abcd]"),
        silent=("[abcd][abef]",),
        apply=_straightened,
    ),
)
"""Written out. Of the longer steps, shortest-form and straightening unfold into the others."""
