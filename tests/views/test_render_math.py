"""LaTeX and MathML of every kind of expression."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import RANKS, expressions

from gcrules.algebra.expr import Expr, Sum
from gcrules.algebra.language.syntax import parse
from gcrules.views.formulas.latex import latex, latex_lines, latex_name, latex_parts
from gcrules.views.formulas.mathml import mathml, mathml_terms

CASES = {
    "point": ("a", "a"),
    "subscript": ("S1", "S_{1}"),
    "underscore": ("S_2", "S_{2}"),
    "prime": ("A'", "A'"),
    "number": ("-3/4", r"-\frac{3}{4}"),
    "line": ("S1A'", "S_{1}A'"),
    "join": (r"(ab /\ cde) \/ f", r"(ab \wedge cde) \vee f"),
    "join of meets": (r"(ab /\ cde) \/ (fg /\ hij)", r"(ab \wedge cde) \vee (fg \wedge hij)"),
    "meet": (r"ace /\ abf /\ cbd /\ edf", r"ace \wedge abf \wedge cbd \wedge edf"),
    "meet of a sum": (r"(ab + cd) /\ ef", r"(ab + cd) \wedge ef"),
    "bracket": ("[abcd]", "[abcd]"),
    "bracket of extensors": (r"[ab /\ cde, f, g, h]", r"[ab \wedge cde,\, f,\, g,\, h]"),
    "dotted": ("[.a b c d][e .f1 g h']", r"[\dot{a}bcd][e\dot{f}_{1}gh']"),
    "superbracket": ("[[ab,cd,ef,gh,ij,kl]]", r"[\![ab,\, cd,\, ef,\, gh,\, ij,\, kl]\!]"),
    "sum": ("-[abcd] + 2[abce] - 1/2[abcf]", r"-[abcd] + 2[abce] - \frac{1}{2}[abcf]"),
    "product": ("2[abcd][efgh]", "2[abcd][efgh]"),
    "product with a sum": ("([abcd] - [abce])[efgh]", "([abcd] - [abce])[efgh]"),
    "minus a product": ("-[abcd]([abcd] - [abce])", "-[abcd]([abcd] - [abce])"),
    "product with an extensor": ("3[abcd] * ef", r"3[abcd]\,ef"),
    "power": ("[abcd]**2", "{[abcd]}^{2}"),
    "power of a sum": ("([abcd] + 1)**3", "{([abcd] + 1)}^{3}"),
}


@pytest.mark.parametrize(("text", "expected"), CASES.values(), ids=CASES)
def test_latex(text: str, expected: str) -> None:
    e = parse(text)
    assert latex(e) == expected
    assert e._repr_latex_() == f"$\\displaystyle {expected}$"


def without_spaces(tex: str) -> str:
    return re.sub(r"\\,|\{\}|\s", "", tex)


@given(st.data())
def test_the_pieces_are_the_whole(data: st.DataObject) -> None:
    e = data.draw(RANKS.flatmap(expressions))
    assert without_spaces("".join(tex for tex, _ in latex_parts(e))) == without_spaces(latex(e))


def test_what_is_constructed_comes_piece_by_piece() -> None:
    """Each plane and line of it is a piece, which a page can colour."""
    found = list(latex_parts(parse(r"xyz /\ ((xyz /\ ab) \/ cd) /\ ef")))
    assert [str(e) for _, e in found] == ["xyz", "xyz", "ab", "cd", "ef"]
    assert [tex for tex, _ in found][2:4] == [r"{}\wedge ab)", r"{}\vee cd)"]


def test_a_sum_that_is_taken_away_stays_in_parentheses_piece_by_piece() -> None:
    e = parse("[abcd]**2 - ([abce] - [abcf])")
    assert [tex for tex, _ in latex_parts(e)] == ["{[abcd]}^{2}", "{}-([abce] - [abcf])"]


@pytest.mark.parametrize(
    ("name", "dotted", "expected"),
    [
        ("left", False, r"\mathit{left}"),
        ("arm_1", True, r"\dot{\mathit{arm}}_{1}"),
        ("top_left", False, r"\mathit{top\_left}"),
    ],
)
def test_long_names(name: str, dotted: bool, expected: str) -> None:
    assert latex_name(name, dotted) == expected


def test_long_names_are_set_apart() -> None:
    assert latex(parse("[left, right, a, b]", points=["left", "right"])) == r"[\mathit{left}\,\mathit{right}\,a\,b]"


TAGS = {
    "dotted": ("[.a b c d][.e f g h]", {"mover": 2, "mi": 8}),
    "subscripts": ("S1A2", {"msub": 2, "mn": 2}),
    "primes": ("A'B1'", {"msup": 1, "msubsup": 1}),
    "fraction": ("1/2[abcd]", {"mfrac": 1}),
    "power": ("[abcd]**2", {"msup": 1}),
    "meet": (r"ab /\ cde", {"mo": 1, "mi": 5}),
}


@pytest.mark.parametrize(("text", "counts"), TAGS.values(), ids=TAGS)
def test_mathml(text: str, counts: dict[str, int]) -> None:
    root = ET.fromstring(mathml(parse(text)))
    assert {tag: len(list(root.iter(tag))) for tag in counts} == counts


def test_display() -> None:
    assert ET.fromstring(mathml(parse("a"), display=True)).attrib == {"display": "block"}
    assert ET.fromstring(mathml(parse("a"))).attrib == {}


def _shown(root: ET.Element) -> str:
    return "".join(root.itertext())


@given(st.data())
def test_every_expression(data: st.DataObject) -> None:
    e = data.draw(expressions(data.draw(RANKS), names=("a", "b", "S1", "A'", "left")))
    code = latex(e)
    assert _balanced(code)
    assert not set(code) & set("∨∧−·")
    root = ET.fromstring(mathml(e))
    pieces = mathml_terms(e)
    assert len(pieces) == (len(e.terms) if isinstance(e, Sum) else 1)
    assert "".join(_shown(ET.fromstring(p)) for p in pieces) == _shown(root)


@given(st.data(), st.integers(1, 80))
def test_lines_hold_every_term_once(data: st.DataObject, width: int) -> None:
    e: Expr = data.draw(expressions(4, 0))
    lines = latex_lines(e, width)
    assert all(line.startswith("&") and _balanced(line) for line in lines)
    assert _bare("".join(line[1:].removeprefix("{}").removeprefix("\\quad{}") for line in lines)) == _bare(latex(e))


def test_lines_are_filled_to_the_width() -> None:
    e = parse("[abcd][efgh] - [abce][dfgh] + [abcf][degh]")
    assert [len(latex_lines(e, width)) for width in (1, 15, 30, 45)] == [3, 3, 2, 1]
    assert latex_lines(e, 30)[1] == "&{}+ [abcf][degh]"


def _bare(code: str) -> str:
    return code.replace(" ", "")


def _balanced(code: str) -> bool:
    depth = 0
    for brace in re.findall(r"(?<!\\)[{}]", code):
        depth += 1 if brace == "{" else -1
        if depth < 0:
            return False
    return depth == 0
