"""Transversal conditions: what is found for every class and for six lines of no class, checked at exact random points
by a determinant of its own; the same answer for legs in any order and direction.
"""

from __future__ import annotations

import json
import random
import subprocess
import sys
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from platform_classes import CLASSES

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, evaluate
from gcrules.algebra.expr import Expr, meet, points_of
from gcrules.algebra.language.legs_text import Structure, legs_text, read_legs
from gcrules.algebra.language.syntax import parse
from gcrules.core.errors import InputError
from gcrules.rules.common_lines import FourLegs
from gcrules.rules.condition import Condition
from gcrules.rules.line_cofactors import balance
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import extensor
from gcrules.rules.transversals import TRANSVERSALS, find, readings

REGULAR = {c["id"]: c for c in CLASSES if c["regular"]}
SINGULAR = {c["id"]: c for c in CLASSES if not c["regular"]}

# The simplest cofactor and the lines p and q; other classes have the cofactor 1 and lines that are not told here.
EXPECTED = {
    "6-5": ("ABc /\\ ACd /\\ ab", "ABc /\\ ACd", "(Bc /\\ Aab) \\/ (Cd /\\ Aab)"),
    "5-5.1": ("[ACac]", "ABa /\\ ACc", "Aab /\\ Cac"),
    "6-4.2": ("1", "AB", "Aab /\\ Bcd"),
    "5-5.2": ("1", "Ac", "Aab /\\ BCc"),
    "5-4.3": ("1", "AB", "Aab /\\ Bac"),
    "5-4.4": ("1", "AB", "Aab /\\ Bcd"),
    "4-4.5": ("1", "AB", "Aab /\\ Bac"),
    "4-4.7": ("1", "AB", "Aab /\\ Bcd"),
    "4-4.4": ("1", "AB", "ab"),
    "6-3.2": ("1", "AB", "Aab /\\ Bcd"),
    "3-3.3": ("1", "AB", "Aab /\\ Bac"),
}

# Six lines of no class: triangles, a line in the plane of others, chains and cycles, joints of four legs, couples.
OTHERS = {
    "triangle": ("ab bc ca de fg hi", ""),
    "triangle-pencil": ("ab bc ca ad de fg", ""),
    "triangle-chain": ("ab bc ca de ef gh", ""),
    "chain": ("ab bc cd de ef fg", ""),
    "cycle-5": ("ab bc cd de ea fg", ""),
    "cycle-6": ("ab bc cd de ef fa", ""),
    "tetrahedron-edges": ("ab ac ad bc bd ce", ""),
    "one-shared-joint": ("ab ac de fg hi jk", ""),
    "long-names": ("left top, left back, right top, front low, S1 S2, S3 S4", ""),
    "parallel-legs": ("Ai Bi Cj Dk Ee Ff", "i j k"),
    "couple": ("Aa Ab Bc Cd De ij", "i j"),
    "pencil-and-couple": ("Ai Aj Bk Cl ij De", "i j k l"),
}


def determinant(rows: list[list[int]]) -> int:
    """Modulo the oracle's prime, by elimination."""
    value = 1
    rows = [[x % PRIME for x in row] for row in rows]
    for i in range(len(rows)):
        pivot = next((k for k in range(i, len(rows)) if rows[k][i]), None)
        if pivot is None:
            return 0
        if pivot != i:
            rows[i], rows[pivot], value = rows[pivot], rows[i], -value
        value = value * rows[i][i] % PRIME
        inverse = pow(rows[i][i], -1, PRIME)
        for k in range(i + 1, len(rows)):
            factor = rows[k][i] * inverse % PRIME
            rows[k] = [(x - factor * y) % PRIME for x, y in zip(rows[k], rows[i], strict=True)]
    return value % PRIME


def superbracket(structure: Structure, at: dict[str, list[int]]) -> int:
    """The determinant of the legs' Plücker coordinates 12, 13, 14, 23, 24, 34, computed here."""
    rows = []
    for one, other in structure.legs:
        a, b = at[one], at[other]
        rows.append([a[i] * b[j] - a[j] * b[i] for i in range(4) for j in range(i + 1, 4)])
    return determinant(rows)


def holds(structure: Structure, condition: Condition, seed: int = 0) -> bool:
    """cofactor · superbracket = coefficient · expression, with both sides not 0, at an exact random position."""
    rng = random.Random(seed)
    at = {
        n: [*(rng.randrange(1, PRIME) for _ in range(3)), 0 if n in structure.ideal else rng.randrange(1, PRIME)]
        for n in structure.names
    }

    def value(e: Expr) -> int:
        return int(evaluate(e, at, modulus=PRIME)) if points_of(e) else int(str(e))

    left = value(condition.cofactor) * superbracket(structure, at) % PRIME
    return left != 0 and (left - condition.coefficient * value(condition.expression)) % PRIME == 0


def simplest(legs: str, **space: Any) -> Condition:
    condition = gc.transversals(legs, **space).condition
    assert condition is not None
    return condition


def text_of(legs: list[str]) -> str:
    return " ".join(legs)


@pytest.mark.parametrize("class_id", list(REGULAR))
def test_classes(class_id: str) -> None:
    """33 of the 34 classes have a reading, all but two of them with the cofactor 1; each is right and proved."""
    found = gc.transversals(text_of(REGULAR[class_id]["legs"]))
    if class_id == "6-6":
        assert not found.exists
        assert found.definite
        assert "square root" in found.reason
        return
    condition = found.condition
    assert condition is not None
    assert condition.certificate.method == "normal-form"
    assert abs(condition.coefficient) == 1
    assert all(holds(found.structure, condition, seed) for seed in range(2))
    cofactor, *lines = EXPECTED.get(class_id, ("1",))
    assert str(condition.cofactor) == cofactor
    if lines:
        assert [str(line) for _, line in condition.lines] == lines


@pytest.mark.parametrize("class_id", list(SINGULAR))
def test_always_singular(class_id: str) -> None:
    found = gc.transversals(text_of(SINGULAR[class_id]["legs"]), every=True)
    assert not found.exists
    assert "singular in every pose" in found.text()


@pytest.mark.parametrize("class_id", ["6-5", "5-5.1", "6-4.1", "4-4.4", "3-3.1", "4-3.5"])
def test_every_reading(class_id: str) -> None:
    """All are right and proved; p and q meet four legs; the smallest cofactor comes first."""
    found = gc.transversals(text_of(REGULAR[class_id]["legs"]), every=True)
    oracle = RandomWitness(found.structure)
    assert len(found.readings) > 5
    assert found.more == 0
    cofactors = []
    for r in found.readings:
        assert holds(found.structure, r.condition)
        assert r.condition.certificate.method == "normal-form"
        others = [leg for leg in found.structure.neutral if leg not in r.single]
        assert len(others) == 4
        assert all(oracle.zero(meet(line.expression, extensor(leg))) for line in r.lines for leg in others)
        cofactors.append(len(points_of(r.condition.cofactor)))
    assert cofactors == sorted(cofactors)
    texts = [str(r.condition.expression) for r in found.readings]
    assert len(set(texts)) == len(texts)


@pytest.mark.parametrize("name", list(OTHERS))
def test_six_lines_of_no_class(name: str) -> None:
    legs, ideal = OTHERS[name]
    points = "left top back right front low" if name == "long-names" else ""
    found = gc.transversals(legs, ideal=ideal, points=points)
    condition = found.condition
    assert condition is not None
    assert holds(found.structure, condition)
    assert condition.certificate.method == "normal-form"


def test_known_conditions() -> None:
    """Three legs in a plane leave one incidence: the cofactor goes away."""
    assert str(simplest("ab bc ca de fg hi").expression) == "((de /\\ abc) \\/ (fg /\\ abc)) /\\ hi"
    bundle = simplest("Aa Ab Ac Bd Ce Df")
    assert str(bundle.expression) == "[Aabc](ABd /\\ ACe /\\ Df)"
    assert bundle.statement == (
        "Without the legs Aa and Df the platform can turn, to first order, about p, the line through A that crosses Bd "
        "and Ce, and about q, the line in the plane Abc that crosses Bd and Ce. Aa crosses p in every pose; the robot "
        "is singular exactly when the tetrahedron Aabc is flat (its four points lie in one plane), or Df crosses p too."
    )


@pytest.mark.parametrize(
    ("legs", "words"),
    [
        ("Aa Ab Bc Bd Ce Df", "Each of Ce and Df allows these two turns in one ratio only; the robot is singular"),
        ("Aa Ab Ba Cc Dd Ee", "(the legs Aa and Cc then lie in one plane)"),
        ("Aa Ab Bc Cd De Ef", "(p then lies in the plane Aab, or is not determined)"),
        ("Aa Ab Bc Cd De Ef", "q, the line in the plane Aab that crosses Bc and Cd"),
        ("ab bc cd de ef fg", "the line"),
    ],
)
def test_sentences(legs: str, words: str) -> None:
    assert words in simplest(legs).statement


@settings(max_examples=12)
@given(st.sampled_from(list(REGULAR)), st.randoms(use_true_random=False))
def test_neither_order_nor_direction_matters(class_id: str, rng: random.Random) -> None:
    """The same readings for legs in any order, each written from either end; only signs change."""
    legs = [tuple(leg) for leg in REGULAR[class_id]["legs"]]
    other = [leg if rng.random() < 0.5 else leg[::-1] for leg in rng.sample(legs, 6)]
    one, two = (Structure(tuple((a, b) for a, b in written)) for written in (legs, other))
    first, second = (find(s, RandomWitness(s)) for s in (one, two))
    assert [(str(c.expression), str(c.cofactor)) for c in first] == [
        (str(c.expression), str(c.cofactor)) for c in second
    ]
    for c in second[:2]:
        assert holds(two, c)


@settings(max_examples=8)
@given(st.sampled_from(list(REGULAR)), st.randoms(use_true_random=False))
def test_labels_do_not_matter(class_id: str, rng: random.Random) -> None:
    """New labels, in another sequence too: as many readings, with cofactors of the same degrees."""
    legs = REGULAR[class_id]["legs"]
    names = sorted(set("".join(legs)))
    new = dict(zip(names, rng.sample("ABCDEFabcdefPQRSpqrs", len(names)), strict=True))
    found = []
    for written in (legs, [new[a] + new[b] for a, b in legs]):
        structure = read_legs(" ".join(written))
        found.append(sorted(len(str(r.condition.cofactor)) for r in readings(structure, RandomWitness(structure))))
    assert found[0] == found[1]


@settings(max_examples=20)
@given(st.integers(5, 12), st.randoms(use_true_random=False))
def test_some_reading_wherever_two_legs_share_a_joint(number: int, rng: random.Random) -> None:
    pairs = [(a, b) for a in "abcdefghijkl"[:number] for b in "abcdefghijkl"[:number] if a < b]
    structure = Structure(tuple(rng.sample(pairs, 6)))
    oracle = RandomWitness(structure)
    found = find(structure, oracle)
    if oracle.zero(structure.superbracket):
        assert not found
        return
    shared = len({n for leg in structure.legs for n in leg}) < 12
    assert bool(found) == shared
    assert all(holds(structure, c) for c in found[:2])


@pytest.mark.parametrize(
    ("legs", "cofactor", "tetrahedra"),
    [
        ("Aa Ab Bc Bd", [], []),
        ("Aa Ab Ba Bb", [], ["[ABab]"]),
        ("Aa Ab Ac Bd", [], ["[Aabc]"]),
        ("Aa Ab Ba Cc", ["[ACac]"], []),
        ("Aa Ab Bc Cd", ["ABc /\\ ACd /\\ ab"], []),
        ("ab bc ca de", ["[abde]"], []),
        ("ab bc ca ad", [], ["[abcd]"]),
    ],
)
def test_four_legs(legs: str, cofactor: list[str], tetrahedra: list[str]) -> None:
    """The factors depend on the four legs only."""
    four = FourLegs(tuple((leg[0], leg[1]) for leg in legs.split()))
    p, q, *_ = four.lines
    found = balance(four, p, q)
    assert found is not None
    assert [str(f) for f in found.cofactor] == cofactor
    assert [str(t) for t in found.tetrahedra] == tetrahedra


def test_four_legs_without_a_common_joint() -> None:
    assert FourLegs((("A", "a"), ("B", "b"), ("C", "c"), ("D", "d"))).lines == ()


def test_lines_and_assumptions() -> None:
    """A leg may be a meet of planes; under assumptions a leg may cross p in every pose."""
    built = simplest("Aa, Ab, abc /\\ def, Cd, De, Ef")
    assert "(abc /\\ def)" in built.statement
    special = simplest("Aa Ab Bc Bd Ce Df", given="collinear(A, B, C)")
    assert str(special.expression) == "(AB /\\ Df)(Aab /\\ Bcd /\\ Ce)"
    assert "Ce crosses p in every pose" in special.statement
    couples = gc.transversals("Aa Bb Cc Dd ij kl", ideal="i j k l")
    assert not couples.exists
    assert not couples.definite
    assert not gc.transversals(read_legs("ab cd ef", rank=3)).exists


def test_words_for_points_at_infinity() -> None:
    lines = {r.lines[0].words for r in gc.transversals("Ai Aj Bi Bj Ce Df", ideal="i j", every=True).readings}
    lines |= {r.lines[1].words for r in gc.transversals("Ai Aj Bi Bj Ce Df", ideal="i j", every=True).readings}
    assert "the line at infinity ij" in lines
    assert "the line through A in the plane ijA that crosses Ce" not in lines
    assert any(words.startswith("the line in the direction i") for words in lines)


def test_rule() -> None:
    for case in TRANSVERSALS.fires:
        structure = read_legs(case)
        assert TRANSVERSALS.find(structure, RandomWitness(structure))
    for case in TRANSVERSALS.silent:
        structure = read_legs(case)
        assert not TRANSVERSALS.find(structure, RandomWitness(structure))
    assert TRANSVERSALS.id == "transversals"


def test_values_show_themselves() -> None:
    found = gc.transversals("Aa Ab Ba Cc Dd Ee")
    (reading,) = found.to_json()["readings"]
    assert reading["kind"] == "transversals"
    assert reading["single"] == [["D", "d"], ["E", "e"]]
    assert reading["lines"]["p"] == {
        "expression": "ABa /\\ ACc",
        "words": "the line through A that crosses Ba and Cc",
    }
    structure = read_legs(legs_text([tuple(leg) for leg in found.to_json()["legs"]]))
    expression, cofactor = (parse(reading[key]) for key in ("expression", "cofactor"))
    again = Condition("", expression, "", found.readings[0].condition.certificate, cofactor, reading["coefficient"])
    assert holds(structure, again)
    assert found.more == found.to_json()["more"] > 5
    assert "∧" in str(found)
    assert found._repr_latex_().startswith("$")
    assert gc.transversals("Aa Ab Ba Cc Dd Ee", every=True).latex().startswith("\\begin{aligned}")
    assert gc.transversals("Aa Bb Cc Dd Ee Ff").latex().startswith("\\text")
    with pytest.raises(AttributeError):
        found.more = 2
    with pytest.raises(InputError):
        gc.transversals("Aa Bb")


@pytest.mark.parametrize(
    ("arguments", "code", "words"),
    [
        (["Aa", "Ab", "Bc", "Cd", "De", "Ef", "--json"], 0, '"cofactor": "ABc /\\\\ ACd /\\\\ ab"'),
        (["Aa Bb Cc Dd Ee Ff"], 1, "square root"),
        (["Aa Bb Cc"], 2, "3 legs"),
        (["Aa Bb Cc Dd ij kl", "--ideal", "i j k l"], 3, "none"),
    ],
)
def test_command(arguments: list[str], code: int, words: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "gcrules", "transversals", *arguments],
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
    )
    assert done.returncode == code, done.stderr
    assert words in done.stdout + done.stderr
    if "--json" in arguments:
        json.loads(done.stdout)


def test_the_plane_at_infinity_is_called_so() -> None:
    """A plane of three directions is no plane of the robot."""
    condition = gc.transversals("zx zy Aa Bb Cc Dd", ideal="x y z").condition
    assert condition is not None
    assert "the line at infinity that crosses Aa and Bb" in condition.statement
    assert "plane" not in condition.statement
