"""Manual mode: wrong proposals are refused, for the right reason and with evidence."""

from __future__ import annotations

import json
import re
from fractions import Fraction
from itertools import combinations
from typing import Any

import pytest
from conditions.by_hand import EACH, fits, legs_of, played
from platform_classes import REGULAR

import gcrules as gc
from gcrules.algebra.evaluate import evaluate, vanishes
from gcrules.algebra.expr import mul
from gcrules.conditions.manual import REASONS, ManualSession
from gcrules.conditions.manual.evidence import bracket_divides, dividing_brackets, relation
from gcrules.core.errors import InputError

OCTAHEDRON = "ab af cb cd ed ef"
LINES = "Aa Ab Ba Bb Cc Dd"


# --- wrong proposals -----------------------------------------------------------------------------------------------


@EACH
def test_refused_proposals_name_the_first_term_that_breaks_them(facts: dict[str, Any]) -> None:
    session = ManualSession.start(legs_of(facts)).shortest()
    entity = next((r.command for r in session.auto().history if r.command.split()[0] in ("plane", "line")), None)
    for start in (session, session.do(entity)) if entity else (session,):
        for size, verb in ((2, "line"), (3, "plane")):
            for names in list(combinations(start.structure.names, size))[::7]:
                check_entity(start, verb, names)


def check_entity(start: ManualSession, verb: str, names: tuple[str, ...]) -> None:
    row = start.board.row(names)
    if row in start.board.entities:
        return
    after = start.do(f"{verb} {' '.join(names)}")
    rows = [set(r) for r in (*start.board.entities, row)]
    terms = [[set(b) for b in monomial] for monomial, _ in start.board.terms]
    wrong = next((n for n, brackets in enumerate(terms, 1) if not fits(brackets, rows)), None)
    outcome = after.outcome
    assert outcome is not None
    assert outcome.confirmed == (wrong is None)
    if wrong is not None:
        assert outcome.data["term"] == wrong
        assert f"term {wrong}, " in outcome.words[0]
        holds = any(set(row) <= b for b in terms[wrong - 1])
        assert outcome.reason == ("bracket-taken" if holds else "apart")
        assert after.board == start.board
        assert sorted(outcome.data["proposed"]) == sorted(names)


@EACH
def test_tetrahedra_are_the_factors(facts: dict[str, Any]) -> None:
    """All factors of the table can be proposed, visible or not; what is refused is no factor, shown by exact points."""
    session = ManualSession.start(legs_of(facts))
    structure = session.structure
    factors = {tuple(sorted(f)) for f in facts["factors"]}
    assert {tuple(sorted(n)) for n in dividing_brackets(structure)} == factors
    for names in list(combinations(structure.names, 4))[:: 1 + len(structure.names) // 3]:
        outcome = session.tetrahedron(names).outcome
        assert outcome is not None
        is_factor = tuple(sorted(names)) in factors
        assert bracket_divides(structure, names) == is_factor
        assert outcome.reason in (("common", "hidden-factor") if is_factor else ("no-factor",))
        if outcome.reason == "no-factor":
            value = evaluate(structure.superbracket, outcome.data["points"])
            assert value == outcome.data["superbracket"] != 0
            assert evaluate(gc.parse(f"[{''.join(names)}]"), outcome.data["points"]) == 0
            assert [tuple(sorted(n)) for n in outcome.data["dividing"]] == sorted(factors)


REFUSALS = [
    (
        "plane apart",
        OCTAHEDRON,
        (),
        "plane abd",
        "apart",
        "term 2, -[abcf][acde][bdef], has no bracket with a, b and d",
    ),
    (
        "plane taken",
        OCTAHEDRON,
        ("plane abc",),
        "plane ace",
        "bracket-taken",
        "only [abce] holds a, c and e, and plane abc has taken it",
    ),
    ("line apart", LINES, ("shortest",), "line AC", "apart", "has no bracket with A and C"),
    (
        "no free bracket",
        OCTAHEDRON,
        ("plane abc", "plane bdf", "plane cde"),
        "line ab",
        "bracket-taken",
        "each of its brackets already has an entity",
    ),
    ("no tetrahedron", OCTAHEDRON, (), "tetrahedron abce", "no-factor", "term 2, -[abcf][acde][bdef], has no [abce]"),
    ("hidden", LINES, ("form 16",), "tetrahedron ABab", "hidden-factor", "term 2, -[ABDb][ACab][Bacd], has no [ABab]"),
    (
        "not left over",
        OCTAHEDRON,
        ("plane abc", "plane bdf", "plane cde"),
        "plane acf",
        "apart",
        "has no bracket with a, c and f",
    ),
    (
        "pair",
        LINES,
        ("shortest", "tetrahedron ABab", "line AB", "line ab"),
        "pair C D",
        "not-swapped",
        "P(C,D) + P(D,C) is not zero",
    ),
    (
        "lines",
        LINES,
        ("shortest", "tetrahedron ABab", "line AB", "line ab"),
        "lines CD cd",
        "not-swapped",
        "P(C,D) + P(D,C) is not zero",
    ),
    (
        "pair taken",
        LINES,
        ("shortest", "tetrahedron ABab", "line AB", "line ab", "pair C c"),
        "pair C D",
        "points-taken",
        "C: not among the left-over points (D, d)",
    ),
    ("missing", OCTAHEDRON, ("plane abc",), "condition", "missing", "entities are missing"),
    ("degree", OCTAHEDRON, (), r"condition abc /\ aef /\ bdf /\ cdf", "degrees", "not a constant times"),
    ("factor", LINES, (), r"condition (AB /\ Cc)(ab /\ Dd) - (AB /\ Dd)(ab /\ Cc)", "degrees", "not a constant times"),
    (
        "a sign inside",
        LINES,
        (),
        r"condition [ABab]((AB /\ Cc)(ab /\ Dd) + (AB /\ Dd)(ab /\ Cc))",
        "different",
        "not a constant times",
    ),
    (
        "another sign",
        OCTAHEDRON,
        (),
        "condition [abce][abdf][cdef] + [abcf][acde][bdef]",
        "different",
        "not a constant times",
    ),
    ("no cofactor", OCTAHEDRON, (), r"condition [abcd](abc /\ aef /\ bdf /\ cde)", "degrees", "not a constant times"),
    ("zero", OCTAHEDRON, (), "condition [abcd][abef] - [abef][abcd]", "zero", "the expression is zero"),
    (
        "zero by a syzygy",
        OCTAHEDRON,
        (),
        "condition [abcd][abef] - [abce][abdf] + [abcf][abde]",
        "zero",
        "the expression is zero",
    ),
    ("cofactor zero", OCTAHEDRON, (), "condition [abcd] cofactor [abcd] - [abcd]", "zero", "the cofactor is zero"),
]


@pytest.mark.parametrize(
    ("legs", "before", "command", "reason", "words"), [r[1:] for r in REFUSALS], ids=[r[0] for r in REFUSALS]
)
def test_refusals(legs: str, before: tuple[str, ...], command: str, reason: str, words: str) -> None:
    start = played(legs, *before)
    assert all(r.outcome.confirmed for r in start.history)
    after = start.do(command)
    outcome = after.outcome
    assert outcome is not None
    assert (outcome.answer, outcome.reason) == ("refused", reason)
    assert words in "\n".join(outcome.words)
    assert after.board == start.board
    assert after.history[:-1] == start.history
    assert outcome.reason in REASONS
    if "evidence" in outcome.data:
        check_evidence(start, command, outcome.data)


def check_evidence(session: ManualSession, command: str, data: Any) -> None:
    """The values are right, by the oracle, and tell the two apart."""
    expression = command.removeprefix("condition ").partition(" cofactor ")[0]
    values = [
        Fraction(evaluate(gc.parse(e), data["points"])) for e in (str(session.structure.superbracket), expression)
    ]
    assert values == [data["superbracket"], data["expression"]]
    if data["evidence"] == "singular":
        assert values[0] == 0 != values[1]
    elif data["evidence"] == "regular":
        assert values[0] != 0 == values[1]


SUMS = [c["id"] for c in REGULAR if c["group"] in ("b", "e")] + ["6-5", "5-5.1"]
CHANGES = [(c, how) for c in REGULAR for how in ("sign", "points", "factor") if how != "sign" or c["id"] in SUMS]


@pytest.mark.parametrize(("facts", "change"), CHANGES, ids=[f"{c['id']}-{how}" for c, how in CHANGES])
def test_wrong_conditions_are_refused_with_points(facts: dict[str, Any], change: str) -> None:
    """The condition with one term's sign turned, with two points exchanged, with a factor more."""
    session = ManualSession.start(legs_of(facts))
    condition = gc.analyze(legs_of(facts)).condition
    text = str(condition.expression)
    if change == "sign":
        text, number = re.subn(r"\)\) - \(|\) - \(", lambda m: m[0].replace("-", "+"), text, count=1)
        assert number == 1
    elif change == "points":
        a, b = session.structure.names[0], session.structure.names[-1]
        text = text.translate(str.maketrans(a + b, b + a))
    else:
        text = f"[{''.join(session.structure.names[:4])}]({text})"
    after = session.condition(text, condition.cofactor)
    outcome = after.outcome
    assert outcome is not None
    if change == "points" and outcome.confirmed:
        identity = f"({condition.cofactor}) {session.structure.superbracket} - {outcome.data['coefficient']}({text})"
        assert vanishes(gc.parse(identity))
        return
    assert outcome.refused
    assert after.confirmed is None
    check_evidence(session, f"condition {text}", outcome.data)
    if change == "factor":
        assert outcome.data["relation"] == "multiple"


CONSTANTS = ["1", "-1", "2", "-3", "1/2", "7/3"]


@EACH
@pytest.mark.parametrize("constant", CONSTANTS)
def test_constants_do_not_matter(facts: dict[str, Any], constant: str) -> None:
    session = ManualSession.start(legs_of(facts))
    condition = gc.analyze(legs_of(facts)).condition
    e = mul(gc.parse(f"({constant})"), condition.expression)
    after = session.condition(e, condition.cofactor)
    assert after.outcome is not None
    assert after.outcome.confirmed
    assert after.outcome.data["coefficient"] == condition.coefficient / Fraction(constant)
    found = after.confirmed
    assert found is not None
    assert (found.kind, found.statement, found.group) == (condition.kind, condition.statement, condition.group)
    assert vanishes(found.identity(session.structure.superbracket), seed=3)
    assert isinstance(found.coefficient, int)
    json.dumps(after.to_json())


def test_every_reading_is_confirmed_with_its_kind() -> None:
    for facts in REGULAR:
        analysis = gc.analyze(legs_of(facts))
        for reading in (analysis.condition, *analysis.readings):
            found = ManualSession.start(legs_of(facts)).condition(reading.expression, reading.cofactor).confirmed
            assert found is not None
            assert (found.kind, found.statement) == (reading.kind, reading.statement)


def test_kinds_by_shape() -> None:
    session = ManualSession.start("Aa Ab Ac Bd Be Cf").condition("[ABCf]([ABde] [Aabc])")
    assert session.confirmed is not None
    assert session.confirmed.kind == "three-tetrahedra"
    cube = ManualSession.start("ab ac ad bc bd cd").condition("[abcd]**3")
    assert (
        cube.statement
        == "The robot is singular exactly when the tetrahedron abcd is flat (its four points lie in one plane)."
    )
    other = ManualSession.start(OCTAHEDRON).condition("[abce][abdf][cdef] - [abcf][acde][bdef]")
    assert other.confirmed is not None
    assert other.confirmed.kind == "expression"
    assert other.statement.startswith("The robot is singular exactly when [abce][abdf][cdef] - ")


def test_a_tetrahedron_as_often_as_it_occurs() -> None:
    session = played("ab ac ad bc bd cd", *["tetrahedron abcd"] * 3)
    assert len(session.board.entities) == 3
    assert session.condition().confirmed is not None
    with pytest.raises(InputError, match="already confirmed"):
        session.tetrahedron("abcd")


def test_how_one_divides_the_other() -> None:
    structure = ManualSession.start(LINES).structure
    one = gc.parse("1")
    cases = {
        "[ABab]": ("factor", 4),
        r"[ABab]((AB /\ Cc)(ab /\ Dd) + (AB /\ Dd)(ab /\ Cc))": ("shares", 12),
        f"{structure.superbracket} [ABab]": ("multiple", 16),
        "[ABCD]": ("none", 4),
        f"3 {structure.superbracket}": ("factor", 12),
    }
    for text, (how, degree) in cases.items():
        assert relation(structure, gc.parse(text), one, degree) == how, text


def refusal(legs: str, command: str) -> tuple[str, dict[str, Any]]:
    outcome = ManualSession.start(legs).do(command).outcome
    assert outcome is not None
    assert outcome.refused
    return "\n".join(outcome.words), dict(outcome.data)


K4 = "ab ac ad bc bd cd"


@pytest.mark.parametrize("expression", ["[abcd]", "-2/3[abcd]", "[abdc]", r"abc /\ d"])
def test_a_divisor_with_the_same_zeros(expression: str) -> None:
    """The superbracket is a cube: the refusal says so, and what it proposes is confirmed."""
    words, data = refusal(K4, f"condition {expression}")
    assert data["relation"] == "factor"
    assert "a constant times its cube: the robot is singular exactly when it is zero" in words
    proposed = words.partition("propose: ")[2].partition("\n")[0]
    found = ManualSession.start(K4).do(proposed)
    assert found.confirmed is not None, proposed
    assert data["evidence"] == "ratio"  # no singular pose and no zero tells them apart


@pytest.mark.parametrize(("legs", "e"), [(K4, "[abcd]**2"), (LINES, "[ABab]")])
def test_a_divisor_is_not_said_to_have_fewer_zeros(legs: str, e: str) -> None:
    words, data = refusal(legs, f"condition {e}")
    assert data["relation"] == "factor"
    assert "wherever it is zero the robot is singular; the other factors may vanish elsewhere" in words
    assert "not the other way round" not in words
    assert "exactly when" not in words


@pytest.mark.parametrize(
    ("expression", "cofactor", "how", "said"),
    [
        ("[abcd]", "[abcd]", "factor", "it divides cofactor times superbracket"),
        ("[abcd][abce]", "[abcd]", "shares", "it has a factor in common with cofactor times superbracket"),
        (
            "[abcd]**2([abce][abdf][cdef] - [abcf][acde][bdef])",
            "[abcd]",
            "multiple",
            "cofactor times superbracket divides it",
        ),
    ],
)
def test_with_a_cofactor_only_the_product_is_compared(expression: str, cofactor: str, how: str, said: str) -> None:
    words, data = refusal(OCTAHEDRON, f"condition {expression} cofactor {cofactor}")
    assert data["relation"] == how
    assert said in words
    assert "wherever it is zero" not in words
    assert "with the superbracket" not in words


NOTHING = "[abcd][abef] - [abce][abdf] + [abcf][abde]"  # zero by the Plücker relation


def test_degrees_are_those_of_the_normal_form() -> None:
    words, data = refusal(OCTAHEDRON, f"condition [abce][abdf][cdef] + {NOTHING}")
    assert "degree" not in words
    assert "degrees" not in data
    right = "[abce][abdf][cdef] - [abcf][acde][bdef]"
    assert ManualSession.start(OCTAHEDRON).condition(f"{right} + {NOTHING}").confirmed is not None
    words, _ = refusal(OCTAHEDRON, "condition [abce][abdf][cdef] + [abcd][abef]")
    assert "its terms have different degrees in the points" in words
    words, data = refusal(OCTAHEDRON, f"condition [abcd] cofactor [abcd] + {NOTHING}")
    assert data["relation"] == "factor"
    words, data = refusal(OCTAHEDRON, f"condition {right} cofactor [abcd] + 1")
    assert "the cofactor's terms have different degrees in the points" in words
    assert "relation" not in data
    words, data = refusal(OCTAHEDRON, f"condition {NOTHING} + 5")
    assert data["relation"] == "factor"
    assert "zero the robot" not in words


def test_points_at_infinity() -> None:
    session = ManualSession.start("ij ik ab cd ef gh", ideal="i")
    refused = session.tetrahedron("iabc").outcome
    assert refused is not None
    assert refused.data["points"]["i"][3] == 0
    refused = session.condition("[ijab][kcde][ifgh]").outcome
    assert refused is not None
    assert refused.data["points"]["i"][3] == 0
    check_evidence(session, "condition [ijab][kcde][ifgh]", refused.data)
