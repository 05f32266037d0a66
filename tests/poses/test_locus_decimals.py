"""Loci with decimals: they are the exact ones up to a factor, and stand where nobody reads the exact ones."""

from __future__ import annotations

import re

import pytest
import sympy
from click.testing import CliRunner
from commands import assert_refused
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.cli import cli

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
