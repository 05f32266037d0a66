"""Any lines, any rank: identities checked on coordinates made here, statements on poses that fulfil them."""

from __future__ import annotations

import json
import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.language.syntax import parse
from gcrules.apps.cli import cli
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.rules.plugins import load_rules

Points = dict[str, tuple[Fraction, ...]]


# --- an independent road: coordinates, Plücker rows and determinants -------------------------------------------------


def det(rows: Sequence[Sequence[Fraction]]) -> Fraction:
    rows = [list(map(Fraction, row)) for row in rows]
    value = Fraction(1)
    for i in range(len(rows)):
        pivot = next((j for j in range(i, len(rows)) if rows[j][i]), None)
        if pivot is None:
            return Fraction(0)
        if pivot != i:
            rows[i], rows[pivot] = rows[pivot], rows[i]
            value = -value
        value *= rows[i][i]
        for j in range(i + 1, len(rows)):
            f = rows[j][i] / rows[i][i]
            rows[j] = [x - f * y for x, y in zip(rows[j], rows[i], strict=True)]
    return value


def plucker(a: Sequence[Fraction], b: Sequence[Fraction]) -> list[Fraction]:
    return [a[i] * b[j] - a[j] * b[i] for i, j in combinations(range(len(a)), 2)]


def row(line: str, points: Points) -> list[Fraction]:
    """The coordinates of "ab", or of the meet "abc^def" = [adef] bc − [bdef] ac + [cdef] ab."""
    if "^" not in line:
        return plucker(*(points[n] for n in line))
    (a, b, c), other = (tuple(points[n] for n in plane) for plane in line.split("^"))
    terms = ((det([a, *other]), b, c), (-det([b, *other]), a, c), (det([c, *other]), a, b))
    return [
        sum((k * p for k, p in zip((t[0] for t in terms), ps, strict=True)), Fraction(0))
        for ps in zip(*(plucker(p, q) for _, p, q in terms), strict=True)
    ]


def superbracket(lines: Sequence[str], points: Points) -> Fraction:
    return det([row(line, points) for line in lines])


def positions(names: Sequence[str], case: Case, seed: int) -> Points:
    """Random points; those of `on` are combinations of the points named, in the order given."""
    rng = random.Random(seed)

    def number() -> Fraction:
        return Fraction(rng.randint(-9, 9) or 5)

    points: Points = {}
    for n in sorted(names):
        if n not in case.on:
            last = Fraction(0) if n in case.ideal else Fraction(1)
            points[n] = (*(number() for _ in range(case.rank - 1)), last)
    for n, others in case.on.items():
        factors = [number() for _ in others]
        points[n] = tuple(
            sum((k * points[o][i] for k, o in zip(factors, others, strict=True)), Fraction(0)) for i in range(case.rank)
        )
    return points


@dataclass(frozen=True)
class Case:
    """`lines` with what is assumed; `on` says how this module fulfils it: each point a combination of others."""

    lines: str
    kind: str
    says: tuple[str, ...]
    given: str = ""
    on: Mapping[str, str] = field(default_factory=dict)
    ideal: str = ""
    rank: int = 4
    points: str = ""

    def __str__(self) -> str:
        return " | ".join(filter(None, (self.lines, self.given, self.ideal)))

    def analysis(self, **more: Any) -> Analysis:
        return analyze_legs(
            self.lines, given=self.given or (), ideal=list(self.ideal), rank=self.rank, points=list(self.points), **more
        )


CASES = [
    # odd cycles, points shared freely
    Case("ab bc ca de fg hi", "transversals", ("hi crosses q too",)),
    Case("ab ac bd ce de fg", "two-planes-three-lines", ("the two ratios agree",)),
    Case("ab bc ca ad be cf", "three-tetrahedra", ("abcd, abce and abcf",)),
    Case("ab bc ca de ef fd", "always-singular", ("the common line of the planes abc and def",)),
    Case("ab ac ad ae bc de", "always-singular", ("in every pose",)),
    # special position
    Case("Aa Ab Bc Bd Ce Cf", "three-tetrahedra", ("ABcd, ACab and BCef",), "coplanar(A,B,a,b)", {"b": "ABa"}),
    Case("Aa Ab Ac Bd Ce Df", "always-singular", ("Aa, Ab and Ac meet in A",), "coplanar(A,a,b,c)", {"c": "Aab"}),
    Case("Aa Ab Ac Bd Ce Df", "tetrahedron-planes-line", ("Aabc is flat",), "collinear(B,C,D)", {"D": "BC"}),
    Case("Aa Bb Cc Dd Ee Ff", "linear-complex", ("one linear complex",), "coplanar(A,B,C,D,E,F)",
         {"D": "ABC", "E": "ABC", "F": "ABC"}),
    Case("Aa Bb Cc Dd Ee Ff", "always-singular", ("lie in one plane, of which at most three",),
         "coplanar(A,a,B,b,C,c,D,d)", dict.fromkeys("bCcDd", "AaB")),
    Case("Aa Ab Bc Cd De Ef", "transversals", ("the two ratios agree",), "collinear(A,C,D)", {"D": "AC"}),
    Case("Aa Ab Ba Cc Dd Ee", "transversals", ("the two ratios agree",), "coplanar(A,B,a,c)", {"c": "ABa"}),
    Case("Aa Bb Cc Dd Ee Ff", "linear-complex", ("one linear complex",), "incident(p, Aa), incident(p, Bb)",
         {"p": "Aa", "b": "Bp"}, points="p"),
    # points at infinity
    Case("Aa Bb Cc ij jk ki", "forces-and-couples", ("lines Aa, Bb and Cc are parallel to one plane",), ideal="ijk"),
    Case("Aa Bb Cc ij ik lm", "forces-and-couples", ("directions i, l and m",), ideal="ijklm"),
    Case("Aa Bb Cc ij kl mn", "forces-and-couples", ("ij, kl and mn meet in a point",), ideal="ijklmn"),
    Case("Aa Ab Bc ij jk ki", "tetrahedron-planes-line", ("are parallel",), ideal="ijk"),
    Case("Aa Ab Ac ij jk ki", "three-tetrahedra", ("tetrahedron Aabc", "i, j and k are parallel"), ideal="ijk"),
    Case("Ai Bi Cj Dj Ek Fk", "four-planes", ("are parallel to one line",), ideal="ijk"),
    Case("Aa Ab Bc Bd Ce Df", "two-planes-three-lines", ("at right angles to the directions in it",), ideal="AB"),
    Case("Aa Bb ij jk ki il", "always-singular", ("in every pose",), ideal="ijkl"),
    Case("Aa Bb Cc ij jk ki", "forces-and-couples", ("parallel",), "coplanar(A,B,C,a)", {"a": "ABC"}, "ijk"),
    # lines that are meets of planes
    Case("ab cd ef ag ch bdf^egh", "two-planes-three-lines", (r"Without the legs ef and (bdf /\ egh)",)),
    Case("ab ac ad be cf abc^def", "tetrahedron-planes-line", (r"the line (abc /\ def) meet in a point",)),
    Case("ac ae be df ab bdf^ceg", "tetrahedron-planes-line", (r"planes",)),
    Case("ab cd ef gh ij abc^def", "linear-complex", ("one linear complex",)),
    Case("abc^def ab ac ad be cf", "tetrahedron-planes-line", (r"line (abc /\ def)",), "coplanar(b,c,e,f)",
         {"f": "bce"}),
    Case("ab ac ad be cf agh^ijk", "tetrahedron-planes-line", (r"line (agh /\ ijk)",), "collinear(i,j,g)",
         {"j": "gi"}),
    Case("ab ac ad be cf agh^ijk", "tetrahedron-planes-line", (r"agh /\ ijk",), ideal="gi"),
    # other ranks
    Case("ab cd ef", "factorization", ("the three lines ab, cd and ef meet in a point or are parallel",), rank=3),
    Case("ab ac de", "factorization", ("a, b and c are on a line, or the points a, d and e are on a line",), rank=3),
    Case("ab ac ad", "always-singular", ("dependent",), rank=3),
    Case("ab bc ca", "factorization", ("the points a, b and c are on a line",), rank=3),
    Case("ab cd ef", "factorization", ("the three lines",), rank=3, ideal="bd"),
    Case("ab ac de", "always-singular", ("legs 1 and 2 lie on one line",), "collinear(a,b,c)", {"c": "ab"}, rank=3),
    Case("ab ac ad ae bc bd be cd ce de", "factorization", ("lie in one hyperplane",), rank=5),
    Case("ab ac ad ae bc bd be cd ce df", "factorization", ("a, b, c, d and e",), rank=5),
    Case("bg cd bd ag ae cf fg dg ad bh", "factorization", ("the hyperplanes adeg and bdgh and the line cf",), rank=5),
]  # fmt: skip
ALL = pytest.mark.parametrize("case", CASES, ids=map(str, CASES))
REGULAR = pytest.mark.parametrize(
    "case",
    [c for c in CASES if c.kind != "always-singular"],
    ids=[str(c) for c in CASES if c.kind != "always-singular"],
)


_SECONDS = {"linear-complex": 0.1, "transversals": 0.1}  # for cases of which nothing more is found


@ALL
def test_identities_and_statements(case: Case) -> None:
    a = case.analysis(search=_SECONDS.get(case.kind, 1.0))
    assert a.condition.kind == case.kind
    for words in case.says:
        assert words in a.condition.statement
    lines = case.lines.split()
    names = {*points_of(*a.structure.lines), *case.points, *case.on}
    values = []
    for seed in range(3):
        points = positions(sorted(names), case, seed)
        value = superbracket(lines, points)
        values.append(value)
        for r in (a.condition, *a.readings):
            cofactor, right = (gc.evaluate(e, points, rank=case.rank) for e in (r.cofactor, r.expression))
            assert cofactor * value == r.coefficient * right
            assert a.condition.kind == "always-singular" or value == 0 or right
    assert (not any(values)) == (case.kind == "always-singular")
    assert a.condition.certificate.method in ("normal-form", "catalog-instance")
    assert a.derivation.check()


@ALL
def test_json(case: Case) -> None:
    found = json.loads(json.dumps(case.analysis(search=0).to_json()))
    assert found["rank"] == case.rank
    assert found["ideal"] == sorted(case.ideal)
    assert bool(found["given"]) == bool(case.given)
    assert len(found["lines"]) == len(found["legs"]) == len(case.lines.split())
    for pair, line, word in zip(found["legs"], found["lines"], case.lines.split(), strict=True):
        assert pair == (word.split("^") if "^" in word else list(word))
        assert gc.parse(line) == gc.parse(word)
    texts = [found["superbracket"]["polynomial"], found["shortest"]["polynomial"]]
    texts += [r[key] for r in (found["condition"], *found["readings"]) for key in ("expression", "cofactor")]
    for text in (*texts, *found["assumed"]):
        e = parse(text, rank=case.rank)
        assert set(points_of(e)) <= {*found["points"], *case.points}
    assert found["shortest"]["form"] in ((24, 16) if case.rank == 4 else (None,))


@REGULAR
def test_every_view(case: Case) -> None:
    a = case.analysis(search=0)
    assert a.condition.statement.split()[0] in a.text(full=True)
    assert a.text().isascii()
    assert "\\begin{document}" in a.latex()
    assert "<svg" in a._repr_html_()
    assert "<svg" in gc.report(a)


@REGULAR
def test_order_and_direction_of_the_legs_do_not_matter(case: Case) -> None:
    lines = case.lines.split()
    plain = case.analysis(search=_SECONDS.get(case.kind, 1.0))
    rng = random.Random(str(case))
    for _ in range(2):
        mixed = [line if "^" in line or rng.random() < 0.5 else line[::-1] for line in rng.sample(lines, len(lines))]
        a = Case(" ".join(mixed), case.kind, (), case.given, case.on, case.ideal, case.rank, case.points).analysis(
            search=_SECONDS.get(case.kind, 1.0)
        )
        assert a.condition.kind == plain.condition.kind
        points = positions(sorted({*points_of(*a.structure.lines), *case.points, *case.on}), case, 1)
        for one, other in (
            (a.condition.expression, plain.condition.expression),
            (a.condition.cofactor, plain.condition.cofactor),
        ):
            assert abs(gc.evaluate(one, points)) == abs(gc.evaluate(other, points))


# --- statements on poses that fulfil them ----------------------------------------------------------------------------


def solved(target: Sequence[str], case: Case, singular: Mapping[str, str], seed: int) -> Fraction:
    """The superbracket where some more points are put on others."""
    more = Case(case.lines, case.kind, (), case.given, {**case.on, **singular}, case.ideal, case.rank)
    names = {n for line in target for n in line if n != "^"}
    return superbracket(target, positions(sorted(names | set(more.on)), more, seed))


@pytest.mark.parametrize(
    ("number", "singular"),
    [
        pytest.param(0, {"P": "abc", "e": "dP", "Q": "abc", "g": "fQ", "i": "PQh"}, id="P, Q, h, i coplanar"),
        pytest.param(13, {"x": "ijk", "y": "ijk", "a": "Ax", "b": "By", "z": "xy", "c": "Cz"}, id="parallel"),
        pytest.param(18, {"B": "Aix", "D": "Cjx", "F": "Ekx"}, id="planes parallel to a line"),
        pytest.param(29, {"p": "ab", "d": "cp", "f": "ep"}, id="three lines through a point"),
        pytest.param(30, {"e": "ad"}, id="a on de"),
    ],
)  # fmt: skip
def test_poses_that_fulfil_the_statement_are_singular(number: int, singular: Mapping[str, str]) -> None:
    case = CASES[number]
    ideal = case.ideal + "x" * ("x" in "".join(singular.values()))
    for seed in range(3):
        more = Case(case.lines, case.kind, (), case.given, {**case.on, **singular}, ideal, case.rank)
        names = {*case.lines.replace(" ", "").replace("^", ""), *"".join(singular.values()), *singular}
        points = positions(sorted(names), more, seed)
        assert superbracket(case.lines.split(), points) == 0


def test_parallel_lines_of_the_plane() -> None:
    """Three parallel legs of a plane mechanism: they meet at infinity."""
    points: Points = {n: (Fraction(x), Fraction(y), Fraction(1)) for n, x, y in
              (("a", 0, 0), ("b", 1, 2), ("c", 3, 0), ("d", 5, 4), ("e", 7, 1), ("f", 8, 3))}  # fmt: skip
    a = analyze_legs("ab cd ef", rank=3)
    assert superbracket(["ab", "cd", "ef"], points) == 0
    assert gc.evaluate(a.condition.expression, points) == 0


# --- any graph -------------------------------------------------------------------------------------------------------

edges = st.integers(4, 9).flatmap(
    lambda n: st.lists(
        st.lists(st.sampled_from("abcdefghi"[:n]), min_size=2, max_size=2, unique=True).map("".join),
        min_size=6,
        max_size=6,
    )
)


@settings(max_examples=40, deadline=None)
@given(legs=edges, seed=st.integers(0, 10**6))
@example(legs=["ab", "bc", "ca", "de", "fg", "hi"], seed=0)
@example(legs=["ab", "ba", "cd", "de", "ef", "fg"], seed=0)
def test_any_six_legs(legs: list[str], seed: int) -> None:
    a = analyze_legs(" ".join(legs))
    case = Case(" ".join(legs), "", ())
    values = [superbracket(legs, positions(a.structure.names, case, seed + n)) for n in range(4)]
    if a.condition.kind == "always-singular":
        assert not any(values)
    else:
        assert any(values)
        points = positions(a.structure.names, case, seed)
        for r in (a.condition, *a.readings):
            left = gc.evaluate(r.cofactor, points) * values[0]
            assert left == r.coefficient * gc.evaluate(r.expression, points)
    assert a.condition.certificate.method in ("normal-form", "catalog-instance")


@settings(max_examples=25, deadline=None)
@given(legs=edges, at_infinity=st.sets(st.sampled_from("abcdefghi"), min_size=1, max_size=5), seed=st.integers(0, 999))
def test_any_six_legs_with_points_at_infinity(legs: list[str], at_infinity: set[str], seed: int) -> None:
    ideal = "".join(sorted(at_infinity & set("".join(legs))))
    a = analyze_legs(" ".join(legs), ideal=list(ideal), search=0.5)
    case = Case(" ".join(legs), "", (), ideal=ideal)
    values = [superbracket(legs, positions(a.structure.names, case, seed + n)) for n in range(4)]
    assert (a.condition.kind == "always-singular") == (not any(values))
    points = positions(a.structure.names, case, seed)
    for r in (a.condition, *a.readings) if any(values) else ():
        assert gc.evaluate(r.cofactor, points) * values[0] == r.coefficient * gc.evaluate(r.expression, points)


@settings(max_examples=20, deadline=None)
@given(legs=edges, pick=st.permutations("abcdefghi"), kind=st.sampled_from(["collinear", "coplanar"]))
def test_any_six_legs_under_an_assumption(legs: list[str], pick: list[str], kind: str) -> None:
    names = [n for n in pick if n in "".join(legs)][: 3 if kind == "collinear" else 4]
    assume(len(names) == (3 if kind == "collinear" else 4))
    last = names[-1]
    a = analyze_legs(" ".join(legs), given=f"{kind}({', '.join(names)})", search=0.2)
    case = Case(" ".join(legs), "", (), on={last: "".join(names[:-1])})
    values = [superbracket(legs, positions(a.structure.names, case, n)) for n in range(4)]
    assert (a.condition.kind == "always-singular") == (not any(values))
    points = positions(a.structure.names, case, 0)
    for r in (a.condition, *a.readings) if any(values) else ():
        assert gc.evaluate(r.cofactor, points) * values[0] == r.coefficient * gc.evaluate(r.expression, points)


# --- bad input -------------------------------------------------------------------------------------------------------

SIX = "Aa Bb Cc Dd Ee Ff"


@pytest.mark.parametrize(
    ("lines", "options", "message", "hint"),
    [
        ("ab cd ef", {}, "3 legs, expected six", "--rank 3"),
        ("ab ac ad ae bc bd be cd ce de", {}, "10 legs, expected six", "10 lines are rank 5: --rank 5"),
        (SIX, {"rank": 3}, "6 legs, expected three", "six lines in space are rank 4"),
        ("ab cd", {"rank": 3}, "2 legs, expected three", "rank 3 has 3 lines"),
        (SIX, {"rank": 9}, "outside the supported ranks", None),
        (SIX, {"given": "collinear(A, B, Z)"}, "Z is not an end of a leg", "--points"),
        (SIX, {"given": "A == a"}, "the leg Aa is not a line", None),
        (SIX, {"given": "collinear(A, B"}, "", None),
        (SIX, {"given": "collinear(A, B)"}, "at least 3", None),
        (SIX, {"given": "collinear(A, B, C), [ABCa]*[ABCb] == 1"}, "", None),
        (SIX, {"ideal": "Z"}, "Z is not an end of a leg", None),
        ("ab cd ef gh ij abc^abc", {}, r"the leg abc /\ abc is not a line", None),
        ("ab cd ef gh ij abc^d", {}, "expected a line, found a scalar", "built from points"),
        ("ab, cd, ef, gh, ij, abc ^ def + ab", {}, "need not be a line", None),
        ("ab, cd, ef, gh, ij, abc ^", {}, "is not a leg", None),
        ("ab cd ef", {"rank": 3, "order": "1 2 3"}, "an order of the legs", None),
    ],
)
def test_faults(lines: str, options: dict[str, Any], message: str, hint: str | None) -> None:
    with pytest.raises(InputError) as caught:
        analyze_legs(lines, **options)
    assert message in caught.value.message
    assert hint is None or hint in (caught.value.hint or "")
    assert caught.value.exit_code == 2


@pytest.mark.parametrize("legs", [["ab", "cd", "ef", "gh", "ij", 5], [("a", "b", "c")] * 6, [("a", 1)] * 6])
def test_what_is_no_leg(legs: list[Any]) -> None:
    with pytest.raises(InputError, match="is not a leg"):
        analyze_legs(legs)


def test_faults_in_assumptions_bear_their_place() -> None:
    with pytest.raises(InputError) as caught:
        analyze_legs(SIX, given="collinear(A, B, C), collinear(A, B, Z)")
    assert caught.value.place == "<input>:1:21"
    with pytest.raises(InputError) as caught:
        analyze_legs("ab cd ef gh ij abc^d")
    assert caught.value.place == "<input>:1:16"


def test_lines_that_are_built_from_points_are_for_analyze() -> None:
    with pytest.raises(InputError, match="expected two points"):
        read_legs("ab cd ef gh ij abc^def")
    with pytest.raises(InputError, match="expected two points"):
        gc.shortest("ab cd ef gh ij abc^def")


def test_a_structure_has_its_own_assumptions() -> None:
    structure = read_legs(SIX, given="coplanar(A, B, C, D)")
    assert analyze_legs(structure, search=0).structure.given
    with pytest.raises(InputError, match="its own"):
        analyze_legs(structure, given="collinear(A, B, C)")


def test_factorization_where_no_rule_finds_a_condition() -> None:
    """A triangle and three single legs: de and fg pierce the plane of the triangle in points coplanar with hi."""
    strategy = load_rules().strategy(without=["catalog", "transversals"])
    a = analyze_legs("ab bc ca de fg hi", strategy=strategy)
    assert a.condition.kind == "factorization"
    assert str(a.condition.right_side) == r"-[abc /\ de, abc /\ fg, h, i]"
    assert "the point where the line de meets the plane abc" in a.condition.statement
    assert [step.rule for step in a.derivation][-1] == "factorization"
    without = analyze_legs("ab bc ca de fg hi", strategy=strategy.without(["factorization"]))
    assert without.condition.kind == "linear-complex"


def test_brackets_that_divide_are_told_where_nothing_is_found_for_the_rest() -> None:
    strategy = load_rules().strategy(without=["catalog", "transversals", "tetrahedron-four-lines"])
    a = analyze_legs("Aa Ab Ba Bb Cc Dd", ideal="C", strategy=strategy)
    assert a.condition.kind == "bracket-factors"
    assert "ABab is flat" in a.condition.statement
    assert str(a.condition.expression).startswith("[ABab]([")
    assert any("nor was one found with a cofactor" in note for note in a.notes)


@pytest.mark.parametrize(
    ("assumed", "points", "words"),
    [
        ("incident(p, Aa), incident(p, Bb)", "p", "p lies on Aa and Bb"),
        ("collinear(A, B, a)", "", "B lies on Aa"),
        ("A == B", "", "A and B are one point"),
    ],
)
def test_names_that_would_show_more_are_noted(assumed: str, points: str, words: str) -> None:
    a = analyze_legs(SIX, given=assumed, points=points, search=0)
    assert a.condition.kind == "linear-complex"
    assert any(words in note for note in a.notes)


def test_a_reading_whose_cofactor_vanishes_is_dropped_and_named() -> None:
    a = analyze_legs("Aa Ab Ba Cc Dd Ee", given="coplanar(A, C, a, c)", search=0.5)
    assert a.condition.kind == "transversals"
    assert any("[ACac]" in note for note in a.notes)
    assert all("[ACac]" not in str(r.cofactor) for r in (a.condition, *a.readings))


# --- the shell -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["Aa Ab Bc Bd Ce Cf", "--given", "coplanar(A, B, a, b)"], "given        coplanar(A, B, a, b)"),
        (["Aa Ab Bc Bd Ce Cf", "--given", "coplanar(A, B, a, b)"], "Under the assumptions [ABab] vanishes."),
        (["Aa Ab Bb Bc Cd Ce", "--given", "incident(p, Aa), incident(p, Bc)", "--points", "p"], "not to vanish: pB"),
        (["Aa Bb Cc ij jk ki", "--ideal", "i j k"], "couples      ij, jk, ki (lines at infinity"),
        ([r"ab, cd, ef, ag, ch, bdf /\ egh"], r"legs         ab, cd, ef, ag, ch, bdf /\ egh"),
        (["ab", "cd", "ef", "--rank", "3"], "pure condition of two rigid bodies joined by three bars"),
        (["ab cd ef gh ij abc^def", "--search", "0"], "no factorization was found in 0 seconds"),
    ],
)
def test_shell(arguments: list[str], words: str) -> None:
    result = CliRunner().invoke(cli, ["analyze", *arguments, "--ascii"])
    assert result.exit_code == 0, result.stderr
    assert words in " ".join(result.stdout.split()) or words in result.stdout


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["ab cd ef"], "--rank 3"),
        ([SIX, "--given", "collinear(A, B, Z)"], "<input>:1:1: "),
        ([SIX, "--given", "collinear(A, B, C)", "--manual"], "Manual mode"),
        ([SIX, "--rank", "x"], "Invalid value"),
    ],
)
def test_shell_faults(arguments: list[str], words: str) -> None:
    result = CliRunner().invoke(cli, ["analyze", *arguments])
    assert result.exit_code == 2
    assert words in result.stderr


def test_prompt() -> None:
    """`:analyze` at the prompt heeds what was assumed there, as far as it is about the joints."""
    lines = ["given coplanar(A, B, a, b), collinear(x, y, z)", ":analyze Aa Ab Bc Bd Ce Cf", ":quit", ""]
    assert "ABcd, ACab and BCef" in CliRunner().invoke(cli, ["repl"], input="\n".join(lines)).stdout


def test_without_a_leg_between_joints_there_is_no_graph(tmp_path: Path) -> None:
    lines, page = "abc^def abd^cef abe^cdf acd^bef ace^bdf adf^bce", tmp_path / "r.html"
    a = analyze_legs(lines)
    assert "abcd" in a.condition.statement
    assert "<svg" not in a._repr_html_()
    assert CliRunner().invoke(cli, ["report", lines, "-o", str(page)]).exit_code == 0
    result = CliRunner().invoke(cli, ["analyze", lines, "--figure", str(tmp_path / "r.svg")])
    assert result.exit_code == 2
    assert "no graph" in result.stderr


def test_report_and_figure(tmp_path: Path) -> None:
    page, figure = tmp_path / "r.html", tmp_path / "r.svg"
    options = ["Aa Bb Cc ij jk ki", "--ideal", "i j k"]
    assert CliRunner().invoke(cli, ["report", *options, "-o", str(page)]).exit_code == 0
    assert "parallel to one plane" in page.read_text(encoding="utf-8")
    assert CliRunner().invoke(cli, ["analyze", "ab cd ef", "--rank", "3", "--figure", str(figure)]).exit_code == 0
    assert "<svg" in figure.read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("lines", "condition"),
    [
        (r"abc /\ def, ab, bc, de, ef, gh", r"(be /\ abc /\ def)(abc /\ def /\ gh)"),
        (r"abc /\ abd, ac, ad, bc, bd, ef", r"[abcd](ab /\ ef)(cd /\ abc /\ abd)"),
    ],
)
def test_what_vanishes_for_these_lines_is_left_out(lines: str, condition: str) -> None:
    """Two of the lines meet in every pose, so there are no two ratios to compare."""
    a = analyze_legs(lines)
    assert str(a.condition.expression).lstrip("-") == condition
    assert "ratio" not in a.condition.statement
    assert gc.prove(a.condition.identity(a.structure.superbracket), gc.parse("0")).proved
