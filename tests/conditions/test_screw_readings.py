"""Every reading of legs of which some are screws, compared with the determinant of six free coordinates each."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from functools import cache
from itertools import combinations
from pathlib import Path
from random import Random
from typing import Any

import pytest

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.core.errors import GcrulesError
from gcrules.core.linear_algebra import determinant
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.screw_readings import of_screws

Numbers = dict[str, tuple[int, ...]]

CASES = [
    ("Aa Ab Bc Bd S T", "screw S T", ()),
    ("Aa Ab Ac Bd Be S", "screw S", ()),
    ("Aa Ab Ac S T U", "screw S T U", ()),
    ("Aa Ab S T Cc Dd", "screw S T", ()),
    ("Aa Ab Bc S Dd Ee", "screw S", ()),
    ("Aa Ab Ba Cc Dd S", "screw S", ()),
    ("Aa Ab Bb Bc Cc S", "screw S", ()),
    ("Aa Ab Bc Bd L S", "screw S, line L", ()),
    ("Aa Ab Ac Bd S T", "screw S T", ("coplanar(A, B, a, d)",)),
    ("ab ac bc de S T", "screw S T", ()),
    ("Ai Bi Ca Cb S T", "screw S T", ("ideal i",)),
    ("ab cd ef gh S T", "screw S T", ()),
    ("S T U V W X", "screw S T U V W X", ()),
]
IDS = [legs for legs, *_ in CASES]


def position(seed: str, given: tuple[str, ...]) -> Numbers:
    rng = Random(seed)
    names = [*"ABCDEabcdefghi", *(f"{k}{i}" for k in "STUVWXL" for i in "1234")]
    at = {n: tuple(rng.randrange(PRIME) for _ in range(4)) for n in names}
    for one in given:
        if one == "ideal i":
            at["i"] = (*at["i"][:3], 0)
        else:
            weights = [rng.randrange(PRIME) for _ in range(3)]
            at["d"] = tuple(sum(w * at[n][k] for w, n in zip(weights, "ABa", strict=True)) % PRIME for k in range(4))
    return at


@cache
def answers(legs: str, letters: str, given: tuple[str, ...]) -> tuple[Analysis, gc.Transversals]:
    whole = analyze(legs, letters=letters, given=given, search=0)
    return whole, gc.transversals(legs, letters=letters, given=given, every=True)


def read(data: dict[str, Any], text: str) -> Expr:
    """A text of the data, read with what `letters` says."""
    space = parse_script("\n".join(f"let {name} = {e}" for name, e in data["letters"].items())).context
    return parse(text, context=space)


def coordinates(at: Numbers, word: str) -> list[int]:
    """The Plücker coordinates of a leg, from those of its points alone."""
    pairs = [(f"{word}1", f"{word}2")] if len(word) == 1 else [(word[0], word[1])]
    pairs += [(f"{word}3", f"{word}4")] if word in "STUVWX" else []
    rows = [[at[p][i] * at[q][j] - at[p][j] * at[q][i] for i, j in combinations(range(4), 2)] for p, q in pairs]
    return [sum(column) % PRIME for column in zip(*rows, strict=True)]


@pytest.mark.parametrize(("legs", "letters", "given"), CASES, ids=IDS)
def test_readings_have_the_value_of_the_determinant(legs: str, letters: str, given: tuple[str, ...]) -> None:
    whole, turns = (found.to_json() for found in answers(legs, letters, given))
    compared = [(whole, r) for r in (whole["condition"], *whole["readings"])] + [(turns, r) for r in turns["readings"]]
    at = position(legs, given)
    value = determinant([coordinates(at, word) for word in legs.split()], PRIME)
    assert value
    for data, r in compared:
        texts = [read(data, r[key]) for key in ("expression", "cofactor")]
        (expression,), (cofactor,) = map(Evaluator(at, 4, PRIME).value, texts)
        coefficient = Fraction(r["coefficient"])
        assert cofactor % PRIME
        assert (cofactor * value * coefficient.denominator - coefficient.numerator * expression) % PRIME == 0, r
        assert "proved" in r["certificate"]["detail"] or r["kind"] == "linear-complex"


@pytest.mark.parametrize(("legs", "letters", "given"), CASES, ids=IDS)
def test_nothing_is_said_of_a_screw_that_holds_of_lines_only(legs: str, letters: str, given: tuple[str, ...]) -> None:
    found, turns = answers(legs, letters, given)
    said = [c.statement for c in (found.condition, *found.readings)]
    said += [r.condition.statement for r in turns.readings]
    said += [line.words for r in turns.readings for line in r.lines]
    screws = letters.partition(",")[0].removeprefix("screw ").replace(" ", "|")
    of = rf"\(?({screws})\b(?!')"
    for text in said:
        plain = re.sub(r"reciprocal to (the screw )?\w+( and \w+)?", "", text)
        assert not re.search(rf"(lines?|planes?|points?|through|in|cross|crosses|meets?|pierces?) {of}", plain), text
        assert not re.search(rf"{of} (and \w+ )?(meets?|cross|crosses|lies|lie|is flat|then|pierces?)", plain), text


@pytest.mark.parametrize(("legs", "letters", "given"), CASES[:8], ids=IDS[:8])
def test_the_two_lines_are_lines_and_reciprocal_to_the_other_four(
    legs: str, letters: str, given: tuple[str, ...]
) -> None:
    data = answers(legs, letters, given)[1].to_json()
    at = position(legs, given)
    for r in data["readings"]:
        for line in r["lines"].values():
            p = [v % PRIME for v in Evaluator(at, 4, PRIME).value(read(data, line["expression"]))]
            assert any(p)
            assert (p[0] * p[5] - p[1] * p[4] + p[2] * p[3]) % PRIME == 0
            moments = [
                sum(s * x * y for s, x, y in zip((1, -1, 1, 1, -1, 1), p, reversed(coordinates(at, word)), strict=True))
                for word in legs.split()
            ]
            assert sum(m % PRIME == 0 for m in moments) >= 4, line


def test_the_sentences_of_screws() -> None:
    found = gc.analyze("Aa Ab Ac Bd Be S", letters="screw S")
    assert found.condition.statement == (
        "The robot is singular exactly when one of the tetrahedra ABde and Aabc is flat (its four points lie in one "
        "plane), or the screw S is reciprocal to the line AB."
    )
    assert r"letters      S = Sᵃ \/ Sᵇ + Sᶜ \/ Sᵈ, whichever points these are" in found.text()
    general = gc.analyze("ab cd ef gh S T", letters="screw S T").condition.statement
    assert "six legs are linearly dependent screws" in general
    assert "where h is its pitch, r the distance from its axis to gh" in general
    assert "pitch" not in gc.analyze("S T U V W X", letters="screw S T U V W X").condition.statement


def test_platforms_with_screws_that_are_singular_everywhere_say_why() -> None:
    one = gc.analyze("Aa Ab Ac Ad S T", letters="screw S T").condition.statement
    assert "all six legs are reciprocal to the line through A that is reciprocal to S and T" in one
    other = gc.analyze("Aa Bb Cc Dd S S", letters="screw S").condition.statement
    assert other == (
        "The robot is singular in every pose: the 2 legs S, S are dependent for all positions of their joints."
    )


def test_what_needs_the_quadratic_relation_of_lines_is_no_reading_of_screws() -> None:
    """With S ∧ S added to the cofactor the identity holds for lines only."""
    found = analyze("Aa Ab Bc Bd S T", letters="screw S T")
    c, s, factor = found.condition, found.structure.lines[4], gc.parse("[Aabc]")
    of_lines = replace(c, cofactor=factor + (s & s), expression=c.expression * factor)
    assert of_screws(of_lines, found.structure, RandomWitness(found.structure)) is None
    assert of_screws(replace(of_lines, cofactor=factor), found.structure, RandomWitness(found.structure)) is not None


def test_the_superbracket_and_the_shortest_form_take_screws() -> None:
    at = position("forms", ())
    value = determinant([coordinates(at, word) for word in ["Aa", "Ab", "Bc", "Bd", "S", "T"]], PRIME)
    for form, sign in (
        (gc.superbracket("Aa Ab Bc Bd S T", letters="screw S T"), 1),
        (gc.superbracket("Aa Ab Bc Bd S T", letters="screw S T", order="S T Aa Ab Bc Bd"), 1),
        (gc.shortest("Aa Ab Bc Bd S T", letters="screw S T"), 0),
    ):
        data = {"letters": {k: f"{k}1 \\/ {k}2 + {k}3 \\/ {k}4" for k in "ST"}}
        found = Evaluator(at, 4, PRIME).value(read(data, str(form.polynomial)))[0] % PRIME
        assert found == value if sign else found in (value, -value % PRIME)


def test_reports_and_papers_say_which_legs_are_screws(tmp_path: Path) -> None:
    page = gc.report("Aa Ab Bc Bd S T", letters="screw S T", interactive=False)
    assert "Six legs: lines, each through two joints or built from points, and screws." in page
    assert "two rigid bodies joined by six bars" not in page
    gc.paper("Aa Ab Bc Bd S T", tmp_path / "paper", letters="screw S T")
    section = (tmp_path / "paper" / "section.tex").read_text(encoding="utf-8")
    assert "they are the lines $Aa$, $Ab$, $Bc$ and $Bd$ and the screws $S$ and $T$." in section
    assert "S_{1}" not in section


def test_what_is_loaded_has_letters() -> None:
    found = gc.load("Aa Ab Ac Bd Be S", letters="screw S")
    assert gc.analyze(found).condition == gc.analyze("Aa Ab Ac Bd Be S", letters="screw S").condition
    with pytest.raises(GcrulesError, match="letters are for legs without coordinates"):
        gc.load("octahedral-singular", letters="screw S")
