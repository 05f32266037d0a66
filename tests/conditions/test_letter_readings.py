"""Every reading of legs that are letters, compared with the determinant of the lines' coordinates modulo a prime."""

from __future__ import annotations

from fractions import Fraction
from random import Random
from typing import Any

import pytest

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.plain_letters import in_plain_letters
from gcrules.core.errors import GcrulesError
from gcrules.core.linear_algebra import determinant

Points = dict[str, tuple[int, ...]]

CASES = [
    ("Aa Ab Bc Bd K L", "line K L", ()),
    ("Aa Bb G Ba Ca K", "line G K", ("incident(C, K)",)),
    ("Aa Ab Bc K L M", "line K L M", ()),
    ("Ba G Bb Ca Ab H", "line G H", ()),
    ("Bd Df H Cf L G", "line G H L", ("[G H] == 0",)),
    ("H N Bc M L G", "line G H L M N", ("incident(B, L)", "incident(c, N)", "[G H] == 0")),
]


def _position(rng: Random, letters: str, given: tuple[str, ...]) -> Points:
    """Random points of the prime field; a letter through a point, or one that meets another, is bent to that."""

    def mixed(*points: tuple[int, ...]) -> tuple[int, ...]:
        weights = [rng.randrange(PRIME) for _ in points]
        return tuple(sum(w * x for w, x in zip(weights, xs, strict=True)) % PRIME for xs in zip(*points, strict=True))

    names = [*"ABCDabcdf", *(f"{k}{i}" for k in letters.split()[1:] for i in "12")]
    at = {n: tuple(rng.randrange(PRIME) for _ in range(4)) for n in names}
    for one in given:
        if one.startswith("incident"):
            point, line = one[9:-1].split(", ")
            at[f"{line}2"] = mixed(at[f"{line}1"], at[point])
        else:
            first, second = one[1:4].split()
            at[f"{second}2"] = mixed(at[f"{first}1"], at[f"{first}2"], at[f"{second}1"])
    return at


def _values(data: dict[str, Any], at: Points, texts: list[str]) -> list[tuple[int, ...]]:
    """The values of texts of the data, read with what `letters` says."""
    space = parse_script("\n".join(f"let {name} = {e}" for name, e in data["letters"].items())).context
    return [tuple(Evaluator(at, 4, PRIME).value(parse(t, context=space))) for t in texts]


@pytest.mark.parametrize(("legs", "letters", "given"), CASES)
def test_readings_have_the_value_of_the_determinant(legs: str, letters: str, given: tuple[str, ...]) -> None:
    whole = gc.analyze(legs, letters=letters, given=given, search=0).to_json()
    turns = gc.transversals(legs, letters=letters, given=given, every=True).to_json()
    compared = [(whole, r) for r in (whole["condition"], *whole["readings"])]
    compared += [(turns, r) for r in turns["readings"]]
    rng = Random(legs)
    for data, r in compared:
        at = _position(rng, letters, given)
        expression, cofactor, *rows = _values(data, at, [r["expression"], r["cofactor"], *legs.split()])
        coefficient = Fraction(r["coefficient"])
        left = cofactor[0] * determinant(rows, PRIME) * coefficient.denominator
        assert cofactor[0] % PRIME
        assert (left - coefficient.numerator * expression[0]) % PRIME == 0, r


@pytest.mark.parametrize(("legs", "letters", "given"), CASES[:2])
def test_the_two_lines_cross_the_other_four(legs: str, letters: str, given: tuple[str, ...]) -> None:
    data = gc.transversals(legs, letters=letters, given=given, every=True).to_json()
    names = {tuple(e.split(" \\/ ")): name for name, e in data["letters"].items()}
    for r in data["readings"]:
        single = {names.get(tuple(g), "".join(g)) for g in r["single"]}
        others = [leg for leg in legs.split() if leg not in single and leg[::-1] not in single]
        assert len(others) == 4
        at = _position(Random(legs), letters, given)
        for line in r["lines"].values():
            crossings = [f"({line['expression']}) /\\ ({leg})" for leg in others]
            assert all(v[0] % PRIME == 0 for v in _values(data, at, crossings)), line


def test_letters_are_declared_by_themselves_or_among_what_is_given() -> None:
    one, other = (gc.analyze("Aa Ab Bc Bd K L", **{key: "line K L"}) for key in ("letters", "given"))
    assert one.to_json()["condition"] == other.to_json()["condition"]
    assert gc.superbracket("Aa Ab Bc Bd K L", letters="line K L") == one.typed
    with pytest.raises(GcrulesError, match="coordinates: letters for lines are for legs without"):
        gc.analyze("octahedral-singular", letters="line L")


def test_a_name_that_is_taken_gets_a_prime() -> None:
    found = in_plain_letters({"legs": [["L₁", "L₂"]], "class": None}, ["L₁", "L₂", "L1"])
    assert found == {"legs": [["L1'", "L2"]], "class": None, "letters": {"L": "L1' \\/ L2"}}
    assert in_plain_letters({"points": ["a"]}, ["a"]) == {"points": ["a"]}


def test_data_without_letters_have_no_such_key() -> None:
    assert "letters" not in gc.analyze("ab af cb cd ed ef").to_json()
