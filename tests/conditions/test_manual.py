"""Manual mode: proposals are confirmed or refused for the right reason, undone, saved, replayed, and scripted."""

from __future__ import annotations

import json
import os
import re
import select
import subprocess
import sys
import time
from collections.abc import Callable
from fractions import Fraction
from itertools import combinations, permutations
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result
from hypothesis import given, settings
from hypothesis import strategies as st
from platform_classes import REGULAR

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, Evaluator, evaluate, random_points, vanishes
from gcrules.algebra.expr import mul
from gcrules.apps.cli import cli
from gcrules.conditions.manual import MOVES, REASONS, Session, analysis_of, load_session, save_session
from gcrules.conditions.manual.board import Board
from gcrules.conditions.manual.evidence import bracket_divides, dividing_brackets, relation
from gcrules.conditions.manual.file import parse_session, session_yaml
from gcrules.core.errors import FileError, InputError, LimitReached

EACH = pytest.mark.parametrize("facts", REGULAR, ids=[c["id"] for c in REGULAR])
OCTAHEDRON = "ab af cb cd ed ef"
LINES = "Aa Ab Ba Bb Cc Dd"
PYRAMID = "Aa Ab Ac Bd Ce Df"


def legs_of(facts: dict[str, Any]) -> str:
    return " ".join(facts["legs"])


def played(legs: str, *commands: str, **options: Any) -> Session:
    session = Session.start(legs, **options)
    for command in commands:
        session = session.do(command)
    return session


def reached(session: Session) -> Session:
    """The session after following the hints one by one to their end."""
    for _ in range(20):
        hint = session.hint()
        if hint.command is None:
            return session
        session = session.do(hint.command)
        assert session.outcome is not None
        assert session.outcome.confirmed, session.outcome
    raise AssertionError("the hints do not end")


# --- hints lead where the automatic mode leads ---------------------------------------------------------------------


@EACH
def test_hints_lead_to_the_condition_of_the_automatic_mode(facts: dict[str, Any]) -> None:
    session = reached(Session.start(legs_of(facts)))
    expected = gc.analyze(legs_of(facts)).condition
    found = session.confirmed
    assert found is not None
    for field in ("kind", "expression", "cofactor", "coefficient", "statement", "entities"):
        assert getattr(found, field) == getattr(expected, field), field
    assert session.statement == expected.statement
    assert found.certificate.method == "normal-form"


@EACH
def test_what_is_confirmed_holds_on_the_oracle(facts: dict[str, Any]) -> None:
    session = reached(Session.start(legs_of(facts)))
    structure = session.structure
    assert session.confirmed is not None
    assert vanishes(session.confirmed.identity(structure.superbracket), seed=77)
    assert not vanishes(session.confirmed.cofactor, seed=77)
    for record in session.history:
        board = record.board
        assert vanishes(gc.parse(f"{structure.superbracket} - ({board.polynomial})"), seed=5)
        if board.collected() is not None:
            assert vanishes(gc.parse(f"{structure.superbracket} - ({board.collected()})"), seed=6)
        for row in board.of_size(4):
            assert zero_where_flat(structure.superbracket, board.named(row), structure.names)
    analysis = analysis_of(session)
    assert analysis.derivation.check()
    assert analysis.condition == session.confirmed
    assert session.confirmed.statement.split()[0] in analysis.text()


def zero_where_flat(e: gc.Expr, flat: tuple[str, ...], names: tuple[str, ...]) -> bool:
    points: dict[str, Any] = dict(random_points(names, seed=9))
    a, b, c, d = flat
    points[d] = tuple((2 * x + 3 * y + 5 * z) % PRIME for x, y, z in zip(points[a], points[b], points[c], strict=True))
    return not Evaluator(points, 4, PRIME).value(e)[0]


@EACH
def test_auto_finishes_from_anywhere_on_the_way(facts: dict[str, Any]) -> None:
    whole = Session.start(legs_of(facts)).auto()
    commands = [r.command for r in whole.history]
    for n in range(len(commands)):
        assert played(legs_of(facts), *commands[:n]).auto() == whole


@pytest.mark.parametrize("legs", [OCTAHEDRON, LINES, "Aa Ab Bc Bd Ce Df", PYRAMID])
def test_entities_may_be_proposed_in_any_order(legs: str) -> None:
    commands = [r.command for r in Session.start(legs).auto().history]
    first = [c for c in commands if c == "shortest"]
    entities = [c for c in commands if c.split()[0] in ("tetrahedron", "plane", "line")]
    left_over = [c for c in commands if c not in first and c not in entities]
    if left_over[0].startswith("plane"):  # the left-over plane stands among the planes
        entities.remove(left_over.pop(0))
    expected = Session.start(legs).auto().confirmed
    plane_last = [entities.pop()] if legs == OCTAHEDRON else []
    for order in permutations(entities):
        session = played(legs, *first, *order, *plane_last, *left_over)
        assert all(r.outcome.confirmed for r in session.history)
        assert session.confirmed == expected


@EACH
def test_the_sequence_of_two_proposals_does_not_matter(facts: dict[str, Any]) -> None:
    start = Session.start(legs_of(facts)).shortest().board
    names = start.structure.names
    rows = [row for n in (2, 3) for row in combinations(range(len(names)), n) if start.broken(row) is None]
    for one, other in combinations(rows[:25], 2):
        sets = [fits_all(start, pair) for pair in ((one, other), (other, one))]
        boards = [
            Board(start.structure, start.form, True, pair[:1]).broken(pair[1]) for pair in ((one, other), (other, one))
        ]
        assert (boards[0] is None) == (boards[1] is None) == sets[0] == sets[1]


def fits_all(board: Board, rows: tuple[tuple[int, ...], ...]) -> bool:
    return all(fits([set(b) for b in monomial], [set(r) for r in rows]) for monomial, _ in board.terms)


def fits(brackets: list[set[int]], rows: list[set[int]]) -> bool:
    """Whether each row can have a bracket of its own, by trying all."""
    if not rows:
        return True
    return any(
        rows[0] <= b and fits([x for j, x in enumerate(brackets) if j != i], rows[1:]) for i, b in enumerate(brackets)
    )


def test_an_earlier_entity_moves_to_another_bracket() -> None:
    """A line that both of two brackets hold does not stand in the way of a plane that only one of them holds."""
    found = 0
    for facts in REGULAR:
        board = Session.start(legs_of(facts)).shortest().board
        for size in (2, 3):
            for row in combinations(range(len(board.structure.names)), size):
                homes = [[b for b in m if set(row) <= set(b)] for m, _ in board.terms]
                if not all(homes) or max(map(len, homes)) < 2:
                    continue
                for plane in combinations(range(len(board.structure.names)), 3):
                    greedy = all(
                        any(set(plane) <= set(b) for b in without(m, h[0]))
                        for (m, _), h in zip(board.terms, homes, strict=True)
                    )
                    held = Board(board.structure, board.form, True, (row,)).broken(plane) is None
                    assert held or not greedy
                    found += held and not greedy
    assert found > 3


def without(monomial: tuple[Any, ...], bracket: Any) -> list[Any]:
    left = list(monomial)
    left.remove(bracket)
    return left


# --- wrong proposals -----------------------------------------------------------------------------------------------


@EACH
def test_refused_proposals_name_the_first_term_that_breaks_them(facts: dict[str, Any]) -> None:
    session = Session.start(legs_of(facts)).shortest()
    entity = next((r.command for r in session.auto().history if r.command.split()[0] in ("plane", "line")), None)
    for start in (session, session.do(entity)) if entity else (session,):
        for size, verb in ((2, "line"), (3, "plane")):
            for names in list(combinations(start.structure.names, size))[::7]:
                check_entity(start, verb, names)


def check_entity(start: Session, verb: str, names: tuple[str, ...]) -> None:
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
    session = Session.start(legs_of(facts))
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
        "each of its brackets has an entity already",
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
    ("degree", OCTAHEDRON, (), r"condition abc /\ aef /\ bdf /\ cdf", "degrees", "no constant times"),
    ("factor", LINES, (), r"condition (AB /\ Cc)(ab /\ Dd) - (AB /\ Dd)(ab /\ Cc)", "degrees", "no constant times"),
    (
        "a sign inside",
        LINES,
        (),
        r"condition [ABab]((AB /\ Cc)(ab /\ Dd) + (AB /\ Dd)(ab /\ Cc))",
        "different",
        "no constant times",
    ),
    (
        "another sign",
        OCTAHEDRON,
        (),
        "condition [abce][abdf][cdef] + [abcf][acde][bdef]",
        "different",
        "no constant times",
    ),
    ("no cofactor", OCTAHEDRON, (), r"condition [abcd](abc /\ aef /\ bdf /\ cde)", "degrees", "no constant times"),
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


def check_evidence(session: Session, command: str, data: Any) -> None:
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
    session = Session.start(legs_of(facts))
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
    session = Session.start(legs_of(facts))
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
            found = Session.start(legs_of(facts)).condition(reading.expression, reading.cofactor).confirmed
            assert found is not None
            assert (found.kind, found.statement) == (reading.kind, reading.statement)


def test_kinds_by_shape() -> None:
    session = Session.start("Aa Ab Ac Bd Be Cf").condition("[ABCf]([ABde] [Aabc])")
    assert session.confirmed is not None
    assert session.confirmed.kind == "three-tetrahedra"
    cube = Session.start("ab ac ad bc bd cd").condition("[abcd]**3")
    assert (
        cube.statement
        == "The robot is singular exactly when the tetrahedron abcd is flat (its four points lie in one plane)."
    )
    other = Session.start(OCTAHEDRON).condition("[abce][abdf][cdef] - [abcf][acde][bdef]")
    assert other.confirmed is not None
    assert other.confirmed.kind == "expression"
    assert other.statement.startswith("The robot is singular exactly when [abce][abdf][cdef] - ")


def test_a_tetrahedron_as_often_as_it_occurs() -> None:
    session = played("ab ac ad bc bd cd", *["tetrahedron abcd"] * 3)
    assert len(session.board.entities) == 3
    assert session.condition().confirmed is not None
    with pytest.raises(InputError, match="confirmed already"):
        session.tetrahedron("abcd")


def test_how_one_divides_the_other() -> None:
    structure = Session.start(LINES).structure
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
    outcome = Session.start(legs).do(command).outcome
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
    found = Session.start(K4).do(proposed)
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
    assert Session.start(OCTAHEDRON).condition(f"{right} + {NOTHING}").confirmed is not None
    words, _ = refusal(OCTAHEDRON, "condition [abce][abdf][cdef] + [abcd][abef]")
    assert "its terms have unlike degrees in the points" in words
    words, data = refusal(OCTAHEDRON, f"condition [abcd] cofactor [abcd] + {NOTHING}")
    assert data["relation"] == "factor"
    words, data = refusal(OCTAHEDRON, f"condition {right} cofactor [abcd] + 1")
    assert "the cofactor's terms have unlike degrees in the points" in words
    assert "relation" not in data
    words, data = refusal(OCTAHEDRON, f"condition {NOTHING} + 5")
    assert data["relation"] == "factor"
    assert "zero the robot" not in words


def test_points_at_infinity() -> None:
    session = Session.start("ij ik ab cd ef gh", ideal="i")
    refused = session.tetrahedron("iabc").outcome
    assert refused is not None
    assert refused.data["points"]["i"][3] == 0
    refused = session.condition("[ijab][kcde][ifgh]").outcome
    assert refused is not None
    assert refused.data["points"]["i"][3] == 0
    check_evidence(session, "condition [ijab][kcde][ifgh]", refused.data)


# --- what makes no sense -------------------------------------------------------------------------------------------

FAULTS = [
    ("unknown command", (), "plan abc", 0, "there is no command plan", "did you mean plane?"),
    ("no command", (), "   ", 0, "a command is missing", None),
    ("unknown point", (), "plane abx", 8, "x is not a point of the legs", "the points are a b c d e f"),
    ("too few", (), "plane ab", 6, "a plane has three points, found two points", None),
    ("too many", (), "line abc", 5, "a line has two points, found three points", None),
    ("nine", (), "plane abcdefabc", 6, "a plane has three points, found more", None),
    ("none", (), "tetrahedron", 11, "a tetrahedron needs four points", None),
    ("twice", (), "tetrahedron aabc", 12, "a tetrahedron has different points, but a occurs twice", None),
    ("no points", (), "plane 12", 6, "expected points", None),
    ("syntax", (), "plane (ab", 9, "the input ends too early", None),
    ("repeated", ("plane abc",), "plane cab", 6, "plane abc is confirmed already", None),
    ("order", (), "order 1 2 3", 6, "an order names each of the six legs once", None),
    ("no order", (), "order", 5, "which order?", None),
    ("form", (), "form 8", 5, "there is no form 8", "form 24 or form 16"),
    ("argument", (), "shortest now", 9, "shortest takes no argument", None),
    ("argument of undo", (), "undo 3", 5, "undo takes no argument", None),
    ("expression", (), "condition (abc", 14, "the input ends too early", None),
    ("unknown point in it", (), "condition [abcx][abcd]", 14, "x is not a point of the legs", None),
    ("step", (), r"condition abc /\ aef", 10, "the expression has step 2, expected a scalar", None),
    ("number", (), "condition 5", 10, "the expression is a number", None),
    ("cofactor missing", (), "condition [abcd] cofactor", 25, "the cofactor is missing", None),
    ("after the condition", ("auto",), "plane abc", 0, "the condition is confirmed already", "undo takes it back"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("before", "command", "column", "message", "hint"), [f[1:] for f in FAULTS], ids=[f[0] for f in FAULTS]
)
def test_faults(before: tuple[str, ...], command: str, column: int, message: str, hint: str | None) -> None:
    session = played(OCTAHEDRON, *before)
    with pytest.raises(InputError) as caught:
        session.do(command)
    fault = caught.value
    assert message in fault.message
    assert fault.source == command
    assert fault.span is not None
    assert min(fault.span.start, len(command)) == min(column, len(command))
    assert hint is None or fault.hint == hint
    assert fault.render().startswith("error: <input>:1:")


def test_long_names() -> None:
    legs = "left top, left base, right top, right front, back front, back base"
    session = Session.start(legs, points="left right back top base front")
    with pytest.raises(InputError) as caught:
        session.plane("left topp base")
    assert caught.value.hint == "did you mean top?"
    done = session.plane(["left", "top", "base"]).auto()
    assert done.confirmed is not None
    assert parse_session(session_yaml(done)) == done


def test_always_singular() -> None:
    session = Session.start("Aa Ba Ca Ab Bb Cb")
    assert "singular in every pose" in session.statement
    assert session.hint().command is None
    with pytest.raises(InputError, match="nothing can be proposed"):
        session.plane("Aab")
    assert analysis_of(session).condition.kind == "always-singular"
    assert "always-singular" in session.text()


def test_by_trial() -> None:
    """5-4.4: a repeated point hides a term, so the test fails as it stands although the incidence holds."""
    session = played("Aa Ab Bc Bd Ca De", "shortest", "plane Aab", "plane Bcd", "line AB")
    pair = session.pair("C a").outcome
    assert pair is not None
    assert not pair.refused
    both = session.lines("Ca De")
    assert both.outcome is not None
    assert "trial" in {pair.reason, both.outcome.reason}
    assert both.condition().confirmed is not None


def test_what_is_not_decided_is_possible(run: Run, tmp_path: Path) -> None:
    """A line whose test fails where a repeated point can hide a term: kept, neither confirmed nor refused."""
    session = played(OCTAHEDRON, "plane abc", "pair a c")
    outcome = session.outcome
    assert outcome is not None
    assert (outcome.answer, outcome.confirmed, outcome.possible, outcome.refused) == ("possible", False, True, False)
    words = "line ac: P(a,c) + P(c,a) is not zero, but a repeated point can hide a vanished term"
    assert outcome.text() == f"possible: {words}; a condition made of it is proved or refused"
    assert session.to_json()["history"][-1]["answer"] == "possible"
    assert [e.points for e in session.board.starred] == [("a", "b", "c"), ("a", "c")]
    with pytest.raises(InputError, match="line ac is on the board already"):
        session.pair("a c")
    assert session.undo().board == played(OCTAHEDRON, "plane abc").board
    assert session.undo().redo() == session
    assert "answer: possible, reason: trial" in session_yaml(session)
    for kept in (session, session.undo(), session.plane("abd")):
        path = tmp_path / "session.yaml"
        save_session(kept, path)
        assert load_session(path) == kept
    with pytest.raises(FileError, match="is possible now"):
        parse_session(session_yaml(session).replace("answer: possible", "answer: confirmed"))
    result = run("analyze", OCTAHEDRON, "--manual", *proposals("plane abc", "pair a c", "history"))
    assert result.exit_code == 0
    assert f"possible: {words}" in result.output
    assert "2  possible   pair a c" in result.output


def test_changing_the_form_gives_entities_up() -> None:
    session = played(OCTAHEDRON, "plane abc", "form 16")
    assert session.board.entities == ()
    assert session.outcome is not None
    assert "undo brings them back" in session.outcome.words[-1]
    assert session.undo().board.starred[0].points == ("a", "b", "c")


def test_numbers_of_terms_over_all_orders() -> None:
    session = Session.start(OCTAHEDRON)
    fewest = {24: 2, 16: 2}
    for form, table in session.orders().items():
        assert sum(table.values()) == 720
        assert min(table) == fewest[form]
    shortest = session.shortest()
    assert shortest.outcome is not None
    assert shortest.outcome.data["orders"] == session.orders()
    assert len(shortest.board.polynomial) == 2
    order = session.order("2 1 3 4 6 5").board
    assert order.form.order == (1, 0, 2, 3, 5, 4)
    assert session.order("af ab cb cd ef ed").board == order
    assert session.order([1, 0, 2, 3, 5, 4]).board == order


def test_stars_tell_repeated_points_apart() -> None:
    session = played(OCTAHEDRON, "plane abc", "plane b*df")
    assert [e.starred for e in session.board.starred] == [("a", "b", "c"), ("b*", "d", "f")]
    assert "plane abc, plane b*df" in session.text()


# --- undo, redo, files ---------------------------------------------------------------------------------------------

COMMANDS = [
    "plane abc", "plane abd", "plane bdf", "plane cde", "plane aef", "plane ace", "line ab", "line cd", "pair a e",
    "pair a c",
    "tetrahedron abce", "condition", r"condition abc /\ aef /\ bdf /\ cde", "condition [abcd][abef][cdef]", "shortest",
    "form 16", "order 6 5 4 3 2 1", "undo", "undo", "redo", "auto", "nonsense", "plane xyz",
]  # fmt: skip


def tried(session: Session, command: str) -> Session:
    try:
        return session.do(command)
    except InputError:
        return session


@settings(max_examples=60)
@given(st.lists(st.sampled_from(COMMANDS), max_size=12))
def test_undo_redo_and_files(commands: list[str]) -> None:
    session = Session.start(OCTAHEDRON)
    for command in commands:
        before, session = session, tried(session, command)
        if command not in MOVES and session != before:
            assert session.history[:-1] == before.history
            assert (session.board == before.board) or session.outcome is None or not session.outcome.refused
    steps = sum(not r.outcome.refused for r in session.history)
    back = session
    for _ in range(steps):
        assert back.undo().redo() == back
        back = back.undo()
    assert back.board == Session.start(OCTAHEDRON).board
    with pytest.raises(InputError, match="nothing to undo"):
        back.undo()
    for _ in range(steps):
        back = back.redo()
    assert back == session
    assert parse_session(session_yaml(session)) == session
    json.dumps(session.to_json())


def test_a_refusal_keeps_what_can_be_redone_and_a_proposal_ends_it() -> None:
    session = played(OCTAHEDRON, "plane abc", "plane bdf", "undo")
    assert session.plane("abd").redo().board == played(OCTAHEDRON, "plane abc", "plane bdf").board
    with pytest.raises(InputError, match="nothing to redo"):
        session.plane("cde").redo()


def test_save_and_load(tmp_path: Path) -> None:
    path = tmp_path / "session.yaml"
    session = played(OCTAHEDRON, "plane abc", "plane abd", "plane bdf")
    save_session(session, path)
    assert load_session(path) == session
    assert [p.name for p in tmp_path.iterdir()] == ["session.yaml"]
    assert load_session(path).auto().confirmed == Session.start(OCTAHEDRON).auto().confirmed
    with pytest.raises(FileError, match="there is no such file"):
        load_session(tmp_path / "missing.yaml")
    with pytest.raises(FileError, match="no such directory"):
        save_session(session, tmp_path / "missing" / "x.yaml")


def test_sessions_with_order_form_and_points_at_infinity(tmp_path: Path) -> None:
    for session in (
        Session.start("ij ik ab cd ef gh", ideal="i", order="6 5 4 3 2 1"),
        Session.start(OCTAHEDRON, form=16).plane("abc"),
        Session.start("A'a A'b B'c B'd Ce Cf").auto(),
    ):
        assert parse_session(session_yaml(session)) == session


TAMPERED = [
    ("answer", "answer: confirmed, reason: together", "answer: refused, reason: together", 8, "is confirmed now"),
    ("reason", "reason: together", "reason: common", 8, "the reason for 'plane abc' is together now"),
    ("command", "'plane abc'", "'plane abd'", 8, "is refused now: term 2"),
    ("nonsense", "'plane abc'", "'plane xyz'", 8, "makes no sense here: x is not a point"),
    ("legs", "[a, b]", "[a, d]", 8, "is refused now"),
    ("five legs", "[a, b], ", "", 4, "5 legs, expected six"),
    ("no name", "[a, b]", "[a, '!']", 4, "cannot name a point"),
    ("order", "order: [1, 2", "order: [2, 2", 5, "an order names each of the six legs once"),
    ("form", "form: 24", "form: 8", 6, "there is no 8-term form"),
    ("version", "version: 1", "version: 2", 3, "this is version 2 of the format"),
    ("another file", "gcrules: session", "gcrules: catalog", 2, "'catalog' is not one of session"),
    ("key", "form: 24", "from: 24", 6, "unknown key 'from'"),
    ("unknown reason", "reason: together", "reason: magic", 8, "'magic' is not one of"),
    ("a view", "'plane abc'", "'show'", 8, "show is not recorded in sessions"),
    ("tag", "'plane abc'", "!!python/name:os.system 'plane abc'", 8, "tags"),
    (
        "undone",
        "undone: []",
        "undone:\n  - {do: 'plane ade', answer: refused, reason: apart}",
        12,
        "begins with a confirmed",
    ),
]


@pytest.mark.parametrize(("old", "new", "line", "message"), [t[1:] for t in TAMPERED], ids=[t[0] for t in TAMPERED])
def test_tampered_files(tmp_path: Path, old: str, new: str, line: int, message: str) -> None:
    path = tmp_path / "session.yaml"
    source = session_yaml(played(OCTAHEDRON, "plane abc", "plane abd", "plane bdf"))
    assert old in source
    path.write_text(source.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(FileError) as caught:
        load_session(path)
    assert f"session.yaml:{line}:" in str(caught.value)
    assert message in str(caught.value)


def test_all_faults_of_a_file_at_once(tmp_path: Path) -> None:
    source = session_yaml(played(OCTAHEDRON, "plane abc"))
    source = (
        source.replace("form: 24", "form: many").replace("confirmed", "perhaps").replace("version: 1", "version: x")
    )
    with pytest.raises(FileError) as caught:
        parse_session(source)
    assert caught.value.render().count("error: ") == 3


# --- the command line ----------------------------------------------------------------------------------------------

Run = Callable[..., Result]


@pytest.fixture
def run() -> Run:
    def invoke(*arguments: str, input: str = "") -> Result:
        result = CliRunner().invoke(cli, arguments, input=input, prog_name="gcrules")
        if result.exception is not None and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result

    return invoke


def proposals(*commands: str) -> tuple[str, ...]:
    return tuple(word for command in commands for word in ("--propose", command))


CLI = [
    ("confirmed", ("plane abc",), 0, "confirmed: plane abc"),
    ("refused", ("plane abc", "plane abd"), 1, "refused: term 2"),
    ("finished", ("auto", "statement"), 0, "The robot is singular exactly when the four planes"),
    ("malformed", ("plane abc", "plane abx"), 2, "error: <input>:1:9: x is not a point of the legs"),
    ("misspelt", ("tetraheron abcd",), 2, "did you mean tetrahedron?"),
    ("quit", ("quit", "nonsense"), 0, "left over"),
    ("views", ("show", "left", "hint", "suggest", "orders", "history", "help"), 0, "nothing was proposed yet"),
    ("statement too early", ("statement",), 2, "no condition is confirmed yet"),
]  # fmt: skip


@pytest.mark.parametrize(("commands", "code", "words"), [c[1:] for c in CLI], ids=[c[0] for c in CLI])
def test_cli(run: Run, commands: tuple[str, ...], code: int, words: str) -> None:
    result = run("analyze", OCTAHEDRON, "--manual", *proposals(*commands))
    assert result.exit_code == code, result.output
    assert words in result.output
    script = run("analyze", OCTAHEDRON, "--manual", input="# a script\n\n" + "\n".join(commands) + "\n")
    assert script.exit_code == code
    assert words.replace("<input>:1", f"<stdin>:{len(commands) + 2}") in script.output


def test_limits(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What cannot be decided is neither confirmed nor refused, and what was confirmed before stays saved."""

    def limited(*_: Any, **__: Any) -> None:
        raise LimitReached("more than 0 terms", hint="raise the limit")

    monkeypatch.setattr("gcrules.conditions.manual.conditions.straighten", limited)
    path = str(tmp_path / "session.yaml")
    result = run(
        "analyze", OCTAHEDRON, "--session", path, *proposals("plane abc", r"condition abc /\ aef /\ bdf /\ cde")
    )
    assert result.exit_code == 3
    assert "more than 0 terms" in result.stderr
    assert [r.command for r in load_session(path).history] == ["plane abc"]


def test_cli_json(run: Run) -> None:
    result = run(
        "analyze",
        OCTAHEDRON,
        "--manual",
        "--json",
        *proposals("plane abc", "show", "plane abd", "undo", "auto", "undo"),
    )
    assert result.exit_code == 1
    assert result.stdout.isascii()
    found = json.loads(result.stdout)
    assert found["schema"] == 1
    assert found["legs"] == [list(leg) for leg in OCTAHEDRON.split()]
    assert [h["answer"] for h in found["history"]] == ["confirmed"] * 4
    assert found["undone"] == ["condition"]
    assert found["hint"] == {"command": "condition", "why": "all entities are there"}
    assert found["condition"] is None
    assert [e["kind"] for e in found["entities"]] == ["plane"] * 4
    fault = run("analyze", OCTAHEDRON, "--manual", "--json", *proposals("plane xyz"))
    assert (fault.exit_code, fault.stdout) == (2, "")


def test_cli_sessions(run: Run, tmp_path: Path) -> None:
    path = str(tmp_path / "session.yaml")
    assert (
        run("analyze", OCTAHEDRON, "--session", path, input="plane abc\nplane abd\nplane bdf\nplane abx\n").exit_code
        == 2
    )
    assert [r.command for r in load_session(path).history] == ["plane abc", "plane abd", "plane bdf"]
    assert run("analyze", "--session", path, *proposals("auto")).exit_code == 0
    assert load_session(path).confirmed is not None
    assert run("analyze", OCTAHEDRON, "--session", path, *proposals("undo")).exit_code == 0
    assert load_session(path).confirmed is None
    other = run("analyze", LINES, "--session", path, *proposals("undo"))
    assert other.exit_code == 2
    assert "about other legs" in other.stderr
    assert run("analyze", "--session", path, "--order", "6 5 4 3 2 1", *proposals("undo")).exit_code == 2
    copy = str(tmp_path / "copy.yaml")
    assert run("analyze", "--session", path, *proposals(f"save {copy}")).exit_code == 0
    assert load_session(copy) == load_session(path)


USAGE = [
    ("no legs", ("analyze",), "Missing argument"),
    ("no session", ("analyze", "--session", "missing.yaml", "--propose", "show"), "there is no such session file"),
    ("no legs for manual", ("analyze", "--manual", "--propose", "show"), "legs are missing"),
    ("latex", ("analyze", OCTAHEDRON, "--manual", "--latex"), "Manual mode goes with"),
    ("recheck", ("analyze", OCTAHEDRON, "--manual", "--recheck"), "Manual mode goes with"),
    ("legs from standard input", ("analyze", "-", "--manual"), "standard input holds the commands"),
    ("output", ("analyze", OCTAHEDRON, "--manual", "-o", "x.txt"), "--output goes with --json"),
    ("no directory", ("analyze", OCTAHEDRON, "--session", "missing/x.yaml", "--propose", "show"), "no such directory"),
]  # fmt: skip


@pytest.mark.parametrize(("arguments", "words"), [u[1:] for u in USAGE], ids=[u[0] for u in USAGE])
def test_usage(run: Run, arguments: tuple[str, ...], words: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert words in result.stderr


def test_geometry_files_give_legs(run: Run, root: Path) -> None:
    result = run("analyze", str(root / "examples" / "octahedral.yaml"), *proposals("auto"))
    assert result.exit_code == 0
    assert "four planes" in result.output


def test_ascii(run: Run) -> None:
    result = run("analyze", OCTAHEDRON, "--manual", "--ascii", *proposals("auto", "show"))
    assert result.stdout.isascii()


def test_prompt(tmp_path: Path) -> None:
    """On a terminal: an answer, a fault, Ctrl-C in the middle of a line, Ctrl-D; all without a traceback."""
    path = tmp_path / "session.yaml"
    master, slave = pytest.importorskip("pty").openpty()
    code = "from gcrules.apps.main import main; main()"
    process = subprocess.Popen(
        [sys.executable, "-c", code, "analyze", OCTAHEDRON, "--manual", "--session", str(path)],
        stdin=slave, stdout=slave, stderr=slave, start_new_session=True, preexec_fn=_controlling,
    )  # fmt: skip
    os.close(slave)
    seen = ""
    for text, answer in (
        (b"", r"Ctrl-D ends\s+> $"),
        (b"plane abc\n", "confirmed: plane abc.*> $"),
        (b"plane abx\n", "not a point.*> $"),
        (b"plane a\x03", "interrupted.*> $"),
        (b"\x04", "the session is in"),
    ):
        seen = _until(master, text, answer)
    while _read(master):
        pass
    os.close(master)
    assert process.wait(timeout=30) == 0
    assert "Traceback" not in seen
    assert [r.command for r in load_session(path).history] == ["plane abc"]


def _controlling() -> None:
    """Make standard input the terminal from which Ctrl-C comes."""
    import fcntl
    import termios

    fcntl.ioctl(0, termios.TIOCSCTTY, 0)


def _read(master: int) -> str:
    try:
        return os.read(master, 4096).decode(errors="replace")
    except OSError:
        return ""


def _until(master: int, text: bytes, words: str) -> str:
    """What the program answers until this pattern is there; Ctrl-C is pressed again if nothing happens, as one that
    comes just before the program begins to read is only seen by the next.
    """
    os.write(master, text)
    seen, end = "", time.monotonic() + 30
    while not re.search(words, seen, re.DOTALL):
        assert time.monotonic() < end, seen
        if select.select([master], [], [], 2)[0]:
            seen += _read(master)
        elif text.endswith(b"\x03"):
            os.write(master, b"\x03")
    assert "Traceback" not in seen
    return seen
