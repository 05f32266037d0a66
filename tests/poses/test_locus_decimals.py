"""Loci with decimals: they are the exact ones up to a factor, and stand where nobody reads the exact ones."""

from __future__ import annotations

import math
import re

import pytest
import sympy
from click.testing import CliRunner
from commands import assert_refused
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.screws.pose_text import parse_pose

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
TURNED = ("--over", "translation", "--at", "0 0 0; euler zyx 10 20 30 deg")


def printed(*words: str) -> str:
    done = CliRunner().invoke(cli, ["locus", *words])
    assert done.exit_code == 0, done.output
    return done.stdout


def shown(text: str) -> tuple[float, sympy.Poly]:
    """What P is divided by, and the polynomial that stands there."""
    found = re.search(r"^P / (\S+) = (.*?)\n\n", text, re.MULTILINE | re.DOTALL)
    assert found
    names = sympy.symbols("x, y, z")
    return float(found[1]), sympy.Poly(sympy.sympify(found[2].replace("^", "**")), *names)


def test_long_coefficients_are_rounded() -> None:
    text = printed(OCTAHEDRAL, *TURNED)
    assert max(map(len, re.findall(r"\d+", text.partition("P / ")[2]))) < 12
    assert "have the exact numbers" in text
    largest, rounded = shown(text)
    exact = gc.locus(OCTAHEDRAL, over="translation", at="0 0 0; euler zyx 10 20 30 deg").polynomial
    size = max(map(abs, exact.coeffs()))
    assert largest == pytest.approx(float(size), rel=1e-4)
    assert {m: float(c) for m, c in rounded.terms()} == pytest.approx(
        {m: float(sympy.Rational(c, size)) for m, c in exact.terms()}, rel=1e-5
    )


@pytest.mark.parametrize("digits", [2, 9, 15])
def test_digits_that_are_asked_for(digits: int) -> None:
    _, rounded = shown(printed(OCTAHEDRAL, "--over", "translation", "--digits", str(digits)))
    exact = gc.locus(OCTAHEDRAL, over="translation").polynomial
    size = max(map(abs, exact.coeffs()))
    for monomial, c in exact.terms():
        assert float(rounded.coeff_monomial(monomial)) == pytest.approx(
            float(sympy.Rational(c, size)), rel=10.0 ** (1 - digits)
        )


def test_short_ones_are_exact() -> None:
    assert "P = 406*z^3 + 451775*z^2 + 167127500*z + 20559437500" in printed(OCTAHEDRAL, "--over", "z")


def test_robots_of_joints() -> None:
    text = printed("3-rpr", "--over", "x,y", "--at", "yaw=90deg", "--digits", "3")
    assert re.search(r"^P / \S+ = ", text, re.MULTILINE)
    assert "P = " in printed("3-rpr", "--over", "x,y", "--at", "yaw=90deg")


@pytest.mark.parametrize("option", [["--json"], ["--latex"], ["--export", "sympy"]])
def test_exact_forms_have_no_decimals(option: list[str]) -> None:
    assert_refused(
        CliRunner().invoke(cli, ["locus", OCTAHEDRAL, "--digits", "4", *option]), 2, "--digits is for the summary"
    )


# --- turns as they are given ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("at", "shown"),
    [
        ("0 0 0; euler zyx 90 0 0 deg", "euler zyx 90 0 0 deg (quaternion 1 0 0 1)"),
        (TURNED[-1], "euler zyx 10 20 30 deg (quaternion 0.943714 0.268536 0.144878 0.127679, rounded)"),
        ("x=1, roll=5deg", "roll=5deg (quaternion 0.999048 0.0436194 0 0, rounded)"),
        ("0 0 0; rotation-vector 0 0 180 deg", "rotation-vector 0 0 180 deg (quaternion 0 0 0 1)"),
        ("0 0 0; quaternion 0.8 0.6 0 0", "quaternion 4/5 3/5 0 0"),
        ("0 0 0; euler zyx 0 0 0 deg", "no turn"),
        ("1 2 3", "no turn"),
    ],
)
def test_a_turn_is_shown_as_it_was_given(at: str, shown: str) -> None:
    assert f"\nfixed      {shown}\n" in printed(OCTAHEDRAL, "--over", "translation", "--at", at)


def test_long_numbers_of_the_turn_are_there_on_demand() -> None:
    exact = parse_pose(TURNED[-1]).quaternion
    shown = " ".join(printed(OCTAHEDRAL, *TURNED, "--full").split())
    assert f"(quaternion {' '.join(map(str, exact))})" in shown


def test_the_identity_is_that_of_what_is_shown() -> None:
    text = printed(OCTAHEDRAL, "--over", "z", "--digits", "3")
    found = gc.locus(OCTAHEDRAL, over="z")
    times = re.search(r"superbracket = \(about (\S+)\) . \(P / (\S+)\)", text)
    assert times
    size = max(abs(int(c)) for c in found.polynomial.coeffs())
    assert float(times[1]) == pytest.approx(float(found.coefficient) * size, rel=1e-4)
    assert float(times[2]) == pytest.approx(size, rel=1e-4)


@pytest.mark.parametrize(
    ("rotation", "over", "at", "fix"),
    [
        ("zyx", "t1", "0 0 0; euler zyx 30 90 -90 deg", "x=0, y=0, z=0, t2=1, t3=-1"),
        ("XYZ", "t3", "0 0 0; euler zyx 30 90 -90 deg", "x=0, y=0, z=0, t1=-1, t2=1"),
        ("xyz", "t2", "yaw=90deg", "x=0, y=0, z=0, t1=0, t3=1"),
        ("zyx", "x, t1", "1 2 3; euler zyx 0 450 0 rad", None),
    ],
)
def test_half_angle_tangents_of_the_angles_in_a_pose(rotation: str, over: str, at: str, fix: str | None) -> None:
    found = gc.locus(OCTAHEDRAL, over, at=at, rotation=rotation)
    if fix is not None:
        assert found.form == gc.locus(OCTAHEDRAL, fix=fix, rotation=rotation).form
        assert not found.question.rounded
    else:
        assert found.question.rounded == ("t2",)
        assert float(found.question.fixed["t2"]) == pytest.approx(math.tan(225), rel=1e-9)


def test_rounded_tangents_are_named() -> None:
    at = ("--over", "t1", "--rotation", "zyx", "--at", "0 0 0; euler zyx 0 20 90 deg")
    shown = " ".join(printed(OCTAHEDRAL, *at).split())
    assert "t2 = 170453/966687, t3 = 1; from euler zyx 0 20 90 deg, t2 rounded" in shown


@pytest.mark.parametrize(
    ("at", "message"),
    [
        (
            "0 0 0; euler zyz 0 20 90 deg",
            "half-angle tangents of zyx are not taken from a turn that is given otherwise",
        ),
        (
            "0 0 0; quaternion 0.8 0 0 0.6",
            "half-angle tangents of zyx are not taken from a turn that is given otherwise",
        ),
        ("0 0 0; euler zyx 0 180 0 deg", "half a turn has no half-angle tangent t2"),
    ],
)
def test_turns_without_half_angle_tangents(at: str, message: str) -> None:
    words = ["locus", OCTAHEDRAL, "--over", "t1", "--rotation", "zyx", "--at", at]
    assert_refused(CliRunner().invoke(cli, words), 2, message)
