"""The language: what texts mean, what rendering gives back, and what faults say."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st
from places import DATA
from strategies import LONG_NAMES, RANKS, SHORT_NAMES, expressions

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra import scalars
from gcrules.algebra.expr import (
    Bracket,
    Dotted,
    Expr,
    Join,
    Meet,
    Number,
    Point,
    Power,
    Product,
    Sum,
    Superbracket,
    points_of,
)
from gcrules.algebra.language.statements import Claim, Show, parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.language.text import text
from gcrules.core import errors
from gcrules.core.errors import GcrulesError, InputError, StepError, SyntaxFault
from gcrules.views.formulas.latex import latex


def pts(names: str) -> tuple[Point, ...]:
    return tuple(map(Point, names.split()))


def join(names: str) -> Expr:
    return ex.join(*pts(names))


def bracket(names: str) -> Expr:
    return scalars.bracket(*pts(names))


AB, CDE, CD = join("a b"), join("c d e"), join("c d")
ABCD = bracket("a b c d")


# --- what texts mean -----------------------------------------------------------------------------------------------

SPELLINGS = [
    ("join ascii", r"ab \/ c", join("a b c")),
    ("join unicode", "ab ∨ c", join("a b c")),
    ("join tex", r"ab \vee c", join("a b c")),
    ("join tex, no space before a bracket", r"(a+b)\vee(c)", ex.join(ex.add(*pts("a b")), Point("c"))),
    ("juxtaposition", "abc", join("a b c")),
    ("juxtaposition, spaced", "a b c", join("a b c")),
    ("juxtaposition of parts", r"(ab /\ cde) f", ex.join(ex.meet(AB, CDE), Point("f"))),
    ("meet ascii", r"ab /\ cde", ex.meet(AB, CDE)),
    ("meet unicode", "ab ∧ cde", ex.meet(AB, CDE)),
    ("meet caret", "ab ^ cde", ex.meet(AB, CDE)),
    ("meet tex", r"ab \wedge cde", ex.meet(AB, CDE)),
    ("meet, no spaces", r"ab/\cde", ex.meet(AB, CDE)),
    ("product star", "2 * [abcd]", ex.mul(Number(2), ABCD)),
    ("product dot", "2 · [abcd]", ex.mul(Number(2), ABCD)),
    ("product cross", "2 × [abcd]", ex.mul(Number(2), ABCD)),
    ("product tex", r"2 \cdot [abcd] \times [abce]", ex.mul(Number(2), ABCD, bracket("a b c e"))),
    ("product by a space", "2 [abcd] [abce]", ex.mul(Number(2), ABCD, bracket("a b c e"))),
    ("product side by side", "2[abcd][abce]", ex.mul(Number(2), ABCD, bracket("a b c e"))),
    ("minus ascii", "a - b", ex.sub(Point("a"), Point("b"))),
    ("minus unicode", "a − b", ex.sub(Point("a"), Point("b"))),
    ("signs", "- + - -a", ex.neg(Point("a"))),
    ("sign after a product sign", "2 * -a", ex.mul(Number(-2), Point("a"))),
    ("fraction", "3/4 [abcd]", ex.mul(Number(Fraction(3, 4)), ABCD)),
    ("whole fraction", "4/2", Number(2)),
    ("power", "[abcd]**2", Power(ABCD, 2)),
    ("power of one", "[abcd]**1", ABCD),
    ("power of zero", "[abcd]**0", Number(1)),
    ("power of a number", "(2/3)**3", Number(Fraction(8, 27))),
    ("bracket with commas", "[a, b, c, d]", ABCD),
    ("bracket, mixed", "[ab, c d]", ABCD),
    ("bracket of extensors", r"[ab /\ cde, f, g, h]", Bracket((ex.meet(AB, CDE), *pts("f g h")))),
    (
        "superbracket",
        "[[ab, cd, ef, gh, ij, kl]]",
        Superbracket(tuple(map(join, ["a b", "c d", "e f", "g h", "i j", "k l"]))),
    ),
    ("bracket that begins with a bracket", "[ [abcd] a, bcd]", Bracket((ex.mul(ABCD, Point("a")), *pts("b c d")))),
    ("point with digits", "S1", Point("S1")),
    ("point with an underscore", "S_2", Point("S_2")),
    ("point with primes", "A''", Point("A''")),
    ("points with digits", "S1A1B1", join("S1 A1 B1")),
    ("digits belong to the letter before", "a12b", join("a12 b")),
    ("zero", "0", Number(0)),
    ("zero times an extensor", "0 abc", Number(0)),
    ("a scalar meet times a point", r"(ab /\ cd) a", ex.mul(ex.meet(AB, CD), Point("a"))),
    ("comment", "ab # and so on", AB),
    ("lines", "ab\n\t\\/ c", join("a b c")),
]


@pytest.mark.parametrize(("source", "expected"), [s[1:] for s in SPELLINGS], ids=[s[0] for s in SPELLINGS])
def test_spelling(source: str, expected: Expr) -> None:
    assert parse(source) == expected


PRECEDENCE = [
    ("juxtaposition before join", r"ab \/ cd", r"(ab) \/ (cd)"),
    ("join before meet", r"a \/ b /\ cde", r"(a \/ b) /\ cde"),
    ("juxtaposition before meet", r"ab /\ cde f", r"ab /\ ((cde) f)"),
    ("meet before product", r"2 * ab /\ cde", r"2 * (ab /\ cde)"),
    ("meet before product on the left", r"ab /\ cd * 2", r"(ab /\ cd) * 2"),
    ("meet before sign", r"-ab /\ cde", r"-(ab /\ cde)"),
    ("product before sum", "a + 2 * b", "a + (2 * b)"),
    ("sign before sum", "-a + b", "(-a) + b"),
    ("sums from the left", "a - b - c", "(a - b) - c"),
    ("minus before a sum in parentheses", "a - (b - c)", "a + -1 * (b - c)"),
    ("power before juxtaposition", "[abcd]**2 [abce]", "([abcd]**2) * [abce]"),
    ("power before meet", r"[abcd]**2 a /\ bcd", r"([abcd]**2 a) /\ bcd"),
    ("meet is associative", r"abc /\ def /\ ghi", r"(abc /\ def) /\ ghi"),
    ("meet is associative, right", r"abc /\ def /\ ghi", r"abc /\ (def /\ ghi)"),
    ("join is associative", r"a \/ b \/ c", r"a \/ (b \/ c)"),
    ("product is associative", "2 * [abcd] * [abce]", "2 * ([abcd] * [abce])"),
]


@pytest.mark.parametrize(("loose", "strict"), [p[1:] for p in PRECEDENCE], ids=[p[0] for p in PRECEDENCE])
def test_precedence(loose: str, strict: str) -> None:
    assert parse(loose) == parse(strict)


def test_precedence_against_juxtaposition_is_not_grouping() -> None:
    assert parse(r"ab /\ cde f") != parse(r"(ab /\ cde) f")
    assert parse(r"ab /\ cde f").step == 2
    assert isinstance(parse(r"(ab /\ cde) f"), Join)


DOTTED = Dotted(
    (
        (("a", True), ("d", False), ("e", False), ("f", False)),
        (("b", True), ("g", False), ("h", False), ("i", False)),
        (("c", True), ("j", False), ("k", False), ("l", False)),
    )
)
DOTTED_SPELLINGS = [
    ("full stops", "[.a d e f][.b g h i][.c j k l]"),
    ("full stops, tight", "[.adef][.bghi][.cjkl]"),
    ("full stops with commas", "[.a, d, e, f][.b, g, h, i][.c, j, k, l]"),
    ("combining dots", "[a\u0307def][b\u0307ghi][c\u0307jkl]"),
    ("precomposed dots", "[ȧdef][ḃghi][ċjkl]"),
    ("precomposed and combining", "[ȧdef][.bghi][c\u0307jkl]"),
]


@pytest.mark.parametrize("source", [s[1] for s in DOTTED_SPELLINGS], ids=[s[0] for s in DOTTED_SPELLINGS])
def test_dotted_notation(source: str) -> None:
    assert parse(source) == DOTTED


def test_dot_goes_before_the_digits_or_after_the_letter() -> None:
    expected = Dotted(((("S1", True), ("a", False), ("b", False), ("c'", True)),))
    assert parse("[.S1 a b .c']") == expected
    assert parse("[S\u03071abc\u0307']") == expected
    assert parse("[Ṡ1abċ']") == expected


def test_plain_brackets_stand_beside_dotted_ones() -> None:
    e = parse("2[abcd][.a e f g][.b h i j]")
    assert isinstance(e, Product)
    assert [type(f) for f in e.factors] == [Number, Bracket, Dotted]


LONG = [
    ("spaced", "[left right top base]", ("left", "right", "top", "base"), "left right top base"),
    ("run together", "[leftrighttopbase]", ("left", "right", "top", "base"), "left right top base"),
    ("longest first", "[armarm1bc]", ("arm", "arm1"), "arm arm1 b c"),
    ("beside short names", "[a left b c]", ("left",), "a left b c"),
    ("a long name made of short ones", "[ab c d e]", ("ab",), "ab c d e"),
    ("declared short names change nothing", "[abcd]", ("d", "c"), "a b c d"),
]


@pytest.mark.parametrize(("source", "declared", "names"), [x[1:] for x in LONG], ids=[x[0] for x in LONG])
def test_long_names(source: str, declared: tuple[str, ...], names: str) -> None:
    assert parse(source, points=declared) == Bracket(pts(names))


def test_undeclared_letters_are_juxtaposed() -> None:
    assert parse("base") == join("b a s e")
    assert points_of(parse("left", rank=8)) == ("l", "e", "f", "t")


# --- rendering and back --------------------------------------------------------------------------------------------


@given(st.data(), RANKS, st.booleans())
@settings(max_examples=300)
def test_round_trip(data: st.DataObject, rank: int, unicode: bool) -> None:
    e = data.draw(expressions(rank))
    assert parse(text(e, unicode=unicode), rank=rank) == e


@given(st.data(), RANKS, st.booleans())
def test_round_trip_with_long_names(data: st.DataObject, rank: int, unicode: bool) -> None:
    names = data.draw(st.permutations(LONG_NAMES + SHORT_NAMES[:4]).map(lambda p: tuple(p[:6])))
    e = data.draw(expressions(rank, names=names, depth=2))
    assert parse(text(e, unicode=unicode, names=names), rank=rank, points=names) == e


@given(st.data(), RANKS)
def test_other_forms_do_not_fail(data: st.DataObject, rank: int) -> None:
    e = data.draw(expressions(rank))
    assert str(e) == text(e)
    assert text(e).isascii()
    assert latex(e)
    assert e._repr_latex_().startswith("$")
    assert hash(e) == hash(parse(text(e), rank=rank))


def test_every_kind_of_node_is_generated() -> None:
    """The strategy is worth nothing if it never makes some kind of expression."""
    seen: set[type[Expr]] = set()

    @settings(max_examples=300, database=None, derandomize=True)
    @given(st.data(), RANKS)
    def collect(data: st.DataObject, rank: int) -> None:
        seen.update(map(type, ex.subexpressions(data.draw(expressions(rank)))))

    collect()
    assert seen == {Number, Point, Join, Meet, Bracket, Dotted, Superbracket, Sum, Product, Power}


TEXTS = [
    ("minus one times a sum", ex.mul(Number(-1), ex.add(*pts("a b"))), "-(a + b)"),
    ("a sum minus a sum", ex.Sum((Point("c"), ex.mul(Number(-1), ex.add(*pts("a b"))))), "c - (a + b)"),
    ("minus", ex.sub(Point("a"), Point("b")), "a - b"),
    ("fraction", ex.mul(Number(Fraction(-1, 2)), ABCD), "-1/2[abcd]"),
    ("bracket in a bracket", Bracket((ex.mul(ABCD, Point("a")), *pts("b c d"))), "[ [abcd] * a, b, c, d]"),
    ("dotted", DOTTED, "[.a d e f][.b g h i][.c j k l]"),
]


@pytest.mark.parametrize(("e", "expected"), [t[1:] for t in TEXTS], ids=[t[0] for t in TEXTS])
def test_text(e: Expr, expected: str) -> None:
    assert text(e) == expected
    assert parse(expected) == e


# --- faults --------------------------------------------------------------------------------------------------------

# Texts with the faults they have; the guide shows the same table with the whole messages.
CASES = yaml.safe_load((DATA / "faults.yaml").read_text(encoding="utf-8"))


def source_of(case: dict[str, Any]) -> str:
    source = case["source"]
    return source if isinstance(source, str) else source.get("before", "") + source["repeat"] * source["times"]


# (id, source, place, class, words of the message, words of the hint)
FAULTS: list[tuple[str, str, str, type[GcrulesError], str, str]] = [
    (c["id"], source_of(c), c["place"], getattr(errors, c["kind"]), c["message"], c.get("hint", ""))
    for c in CASES["expressions"]
]
SCRIPT_FAULTS = [(c["id"], source_of(c), c["place"], c["message"]) for c in CASES["scripts"]]


@pytest.mark.parametrize(
    ("source", "place", "kind", "message", "hint"), [f[1:] for f in FAULTS], ids=[f[0] for f in FAULTS]
)
def test_fault(source: str, place: str, kind: type[GcrulesError], message: str, hint: str) -> None:
    with pytest.raises(kind) as caught:
        parse(source)
    fault = caught.value
    assert fault.place == f"<input>:{place}"
    assert message in fault.message
    assert hint in (fault.hint or "")
    assert fault.exit_code == 2
    assert len(fault.render()) < 1000


def test_superbracket_of_another_rank() -> None:
    with pytest.raises(StepError, match="a superbracket of 6 lines, expected 3 in rank 3"):
        parse("[[ab, cd, ef, gh, ij, kl]]", rank=3)


def test_caret_points_at_the_fault() -> None:
    with pytest.raises(StepError) as caught:
        parse("[abcd]\n + [abc]")
    assert caught.value.render().splitlines() == [
        "error: <input>:2:4: a bracket of 3 points, expected 4 in rank 4",
        "   + [abc]",
        "     ^^^^^",
        "hint: for another rank say so: `rank 3` in a file, --rank 3 in the shell",
    ]


def test_caret_of_a_long_line_shows_a_window() -> None:
    with pytest.raises(SyntaxFault) as caught:
        parse("+".join(["[abcd]"] * 500) + "+ * " + "[abcd]" * 500)
    _, line, caret, *_ = caught.value.render().splitlines()
    assert len(line) < 120
    assert line[caret.index("^")] == "*"


@pytest.mark.parametrize("rank", [-1, 0, 1, 9, 100])
def test_rank_outside_the_supported_ones(rank: int) -> None:
    with pytest.raises(InputError, match="outside the supported ranks 2 to 8"):
        parse("a", rank=rank)


@pytest.mark.parametrize("name", ["", "1a", "a b", "a-b", "é", "ȧb", "a'b", "'", "_a"])
def test_names_that_cannot_be_declared(name: str) -> None:
    with pytest.raises(InputError, match="cannot name a point"):
        Context(points=(name,))
    with pytest.raises(InputError, match="cannot name a point"):
        Context(ideal=(name,))


def test_equations() -> None:
    assert parse_equation(r"ab /\ cd == [abcd]") == (ex.meet(AB, CD), ABCD)
    assert parse_equation("ab == 0") == (AB, Number(0))
    with pytest.raises(StepError, match="a line \\(step 2\\) cannot equal a point") as caught:
        parse_equation("ab == c")
    assert caught.value.place == "<input>:1:1"
    with pytest.raises(SyntaxFault, match="expected"):
        parse_equation("ab")
    with pytest.raises(SyntaxFault, match="unexpected '=='"):
        parse_equation("a == b == c")


# --- scripts -------------------------------------------------------------------------------------------------------

SCRIPT = r"""# Plane geometry
rank 3
points left, right top   # declared
ideal u v

let p = ab /\ cd         # a point
let q = pe
claim "incidence": p \/ ab == 0
claim [left
  right top] == 0
show q
"""


def test_script() -> None:
    script = parse_script(SCRIPT)
    first, second, shown = script.statements
    assert isinstance(first, Claim)
    assert isinstance(second, Claim)
    assert isinstance(shown, Show)
    assert (first.line, first.label) == (8, "incidence")
    assert (second.line, second.label) == (9, "[left right top] == 0")
    assert (shown.line, shown.label) == (11, "q")
    p = ex.meet(AB, CD, rank=3)
    assert first.claimed.equations[0][0] == ex.join(p, AB, rank=3)
    assert second.claimed.equations[0][0] == Bracket(pts("left right top"))
    assert shown.expr == ex.join(p, Point("e"), rank=3)
    assert script.context.rank == 3
    assert script.context.points == ("left", "right", "top")
    assert script.context.ideal == ("u", "v")
    assert dict(script.context.bound) == {"p": p, "q": shown.expr}


def test_script_of_nothing() -> None:
    assert parse_script("").statements == ()
    assert parse_script("# only a comment\n").statements == ()


def test_a_bound_name_stands_for_its_value_in_words() -> None:
    (shown,) = parse_script("let p = ab /\\ cde  show pf").statements
    assert isinstance(shown, Show)
    assert shown.expr == parse(r"(ab /\ cde) f")


def test_the_context_is_that_of_the_statement() -> None:
    before, after = parse_script("show abc\npoints c b a\nshow abc").statements
    assert before.context.points == ()
    assert after.context.points == ("c", "b", "a")


@pytest.mark.parametrize(
    ("source", "place", "message"), [f[1:] for f in SCRIPT_FAULTS], ids=[f[0] for f in SCRIPT_FAULTS]
)
def test_script_fault(source: str, place: str, message: str) -> None:
    with pytest.raises(InputError) as caught:
        parse_script(source, "x.gca")
    assert caught.value.place == f"x.gca:{place}"
    assert message in caught.value.message


@pytest.mark.parametrize(
    ("source", "hint"),
    [
        ("colinear(a, b, c)", "did you mean collinear(…)?"),
        ("collinear(a, b, c), Concurent ((ab), cd, ef)", "did you mean concurrent(…)?"),
        (r"coplaner((ab) /\ (cd), b, c, d)", "did you mean coplanar(…)?"),
        (
            "touching(ab, cd)",
            "touching(…) is not a relation; the relations are collinear, coplanar, concurrent, incident, parallel, "
            "perpendicular, concyclic, cospherical, equidistant, equal_distance, on_conic, on_quadric and touches",
        ),
        ("(a, b)", "a parenthesis is not closed"),
        ("a, b", None),
        (f"{'collinear' * 50}(a, b)", "a parenthesis is not closed"),
    ],
)
def test_misspelt_relation(source: str, hint: str | None) -> None:
    with pytest.raises(SyntaxFault) as caught:
        parse_assumption(source, Context(rank=3))
    assert caught.value.hint == hint


def test_relations_are_not_suggested_in_expressions() -> None:
    with pytest.raises(SyntaxFault) as caught:
        parse("colinear(a, b, c)")
    assert caught.value.hint == "a parenthesis is not closed"


@pytest.mark.parametrize(
    ("source", "found"),
    [
        ("collinear(a)", "1 point is"),
        ("coplanar(a, b)", "2 points are"),
        ("collinear(a, a, a)", "1 point is"),
        ("collinear(a, b, b)", "2 points are"),
        ("coplanar(a, b, c, a, b, c)", "3 points are"),
    ],
)
def test_too_few_points_are_counted(source: str, found: str) -> None:
    with pytest.raises(InputError, match=f": {found} always so; at least"):
        parse_assumption(source, Context())


def test_labels_do_not_count_as_nesting() -> None:
    (claim,) = parse_script('claim "' + "(" * 150 + '# still the label": a == a').statements
    assert claim.label.endswith("# still the label")


def test_words_of_statements_are_points_where_no_statement_can_stand() -> None:
    assert parse("[rank]") == bracket("r a n k")
    assert parse("[let x]") == bracket("l e t x")


NESTED = [
    (2, "[[ab] c, d]", "[ab][cd]"),
    (2, "[c, [ab] d]", "[ab][cd]"),
    (2, "[[ab] c d]", "[ab][cd]"),
    (2, "[[ab][cd] e, f]", "[ab][cd][ef]"),
    (2, "[[[ab] c, d] e, f]", "[ab][cd][ef]"),
    (2, "[[ab] * c, [cd] * d]", "[ab][cd]**2"),
    (2, "[[ab]]", "[ab]"),
    (2, "[[ab]] [cd]", "[ab][cd]"),
    (2, "[[[ab] cd]]", "[ab][cd]"),
    (2, "[[ab]**2 c, d]", "[ab]**2 [cd]"),
    (3, "[[abc] d, ef]", "[abc][def]"),
    (3, "[[abc] de, f]", "[abc][def]"),
    (3, "[[[ab, cd, ef]] a, b, c]", r"(ab /\ cd /\ ef) [abc]"),
    (4, "[[abcd] ef, gh]", "[abcd][efgh]"),
    (4, "[[abcd] a - [abce] b, c, d, e]", "[abcd][acde] - [abce][bcde]"),
    (5, "[[abcde] ab, cd, f]", "[abcde][abcdf]"),
    (6, "[[abcdef] a, bcdef]", "[abcdef]**2"),
]


@pytest.mark.parametrize(("rank", "nested", "product"), NESTED)
def test_a_bracket_may_begin_with_a_bracket(rank: int, nested: str, product: str) -> None:
    """[[…]] is a superbracket only where the outer bracket holds nothing but the inner one."""
    proof = gc.prove(f"{nested} == {product}", rank=rank)
    assert proof.proved, proof.text()
    e = parse(nested, rank=rank)
    assert parse(text(e), rank=rank) == e


@pytest.mark.parametrize("source", ["[ [ab] ]", "[([ab])]", "[[ab], c]", "[[ab] c]", "[[ab]", "[[ab] c, d"])
def test_brackets_inside_brackets_that_are_none(source: str) -> None:
    with pytest.raises((SyntaxFault, StepError)):
        parse(source, rank=2)
