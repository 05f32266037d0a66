"""What the zeros of factors are: standard forms, moved by random exact maps, are recognised; and where it is told."""

from __future__ import annotations

import json
import random
from fractions import Fraction

import pytest
import sympy
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.zero_set import zero_set
from gcrules.views.detail import everything
from gcrules.views.results.polynomials import zeros_text

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
QUARTER = ("--over", "translation", "--at", "0 0 0; euler zyx 90 0 0 deg")

STANDARD = {
    ("x**2 + y**2 + z**2 + 1", 3): "empty",
    ("x**2 + y**2 + z**2 - 1", 3): "ellipsoid",
    ("x**2 + y**2 + z**2", 3): "point",
    ("x**2 + y**2 - z**2 - 1", 3): "hyperboloid of one sheet",
    ("x**2 + y**2 - z**2 + 1", 3): "hyperboloid of two sheets",
    ("x**2 + y**2 - z**2", 3): "cone",
    ("x**2 + y**2 - z", 3): "elliptic paraboloid",
    ("x**2 - y**2 - z", 3): "hyperbolic paraboloid",
    ("x**2 + y**2 + 1", 3): "empty",
    ("x**2 + y**2 - 1", 3): "elliptic cylinder",
    ("x**2 + y**2", 3): "line",
    ("x**2 - y**2 - 1", 3): "hyperbolic cylinder",
    ("x**2 - 2*y**2", 3): "pair of planes that cross",
    ("x*y", 3): "pair of planes that cross",
    ("x**2 - y", 3): "parabolic cylinder",
    ("x**2 + 1", 3): "empty",
    ("x**2 - 2", 3): "pair of parallel planes",
    ("x**2", 3): "double plane",
    ("x**2 + y**2 + 1", 2): "empty",
    ("x**2 + y**2 - 1", 2): "ellipse",
    ("x**2 + y**2", 2): "point",
    ("x**2 - y**2 - 1", 2): "hyperbola",
    ("x*y - 1", 2): "hyperbola",
    ("x**2 - 2*y**2", 2): "pair of lines that cross",
    ("x**2 - y", 2): "parabola",
    ("x**2 + 1", 2): "empty",
    ("x**2 - 2", 2): "pair of parallel lines",
    ("x**2", 2): "double line",
}  # fmt: skip


def form_of(text: str, number: int, moved: random.Random | None = None) -> PolynomialForm:
    """The polynomial, of the places that a random affine map with an inverse brings here."""
    names = sympy.symbols("x, y, z")[:number]
    p = sympy.sympify(text)
    if moved is not None:
        while True:
            rows = [[Fraction(moved.randint(-9, 9), moved.randint(1, 5)) for _ in names] for _ in names]
            matrix = sympy.Matrix([[sympy.Rational(c.numerator, c.denominator) for c in row] for row in rows])
            if matrix.det():
                break
        shift = sympy.Matrix([moved.randint(-(10**6), 10**6) for _ in names])
        p = p.subs(dict(zip(names, matrix * sympy.Matrix(names) + shift, strict=True)), simultaneous=True)
        p *= moved.choice([-3, 7])
    q = sympy.Poly(p, *names).clear_denoms(convert=True)[1]
    return PolynomialForm.ordered(tuple(map(str, names)), ((e, int(c)) for e, c in q.terms()))


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize(("standard", "kind"), STANDARD.items())
def test_moved_standard_forms(standard: tuple[str, int], kind: str, seed: int) -> None:
    found = zero_set(form_of(*standard, random.Random(seed)))
    assert found is not None
    assert {"circle": "ellipse", "sphere": "ellipsoid"}.get(found.kind, found.kind) == kind


@pytest.mark.parametrize(
    ("text", "number", "kind", "normal"),
    [
        ("3*x**2 + 3*y**2 + 3*z**2 - 5*x - 1", 3, "sphere", ()),
        ("x**2 + y**2 + 2*z**2 - 1", 3, "ellipsoid", ()),
        ("x**2 + x*y + y**2 - 1", 2, "ellipse", ()),
        ("2*x**2 + 2*y**2 - x", 2, "circle", ()),
        ("4*x - 6*z + 3", 3, "plane", (2, 0, -3)),
        ("y", 2, "line", (0, 1)),
    ],
)
def test_round_and_flat_ones(text: str, number: int, kind: str, normal: tuple[int, ...]) -> None:
    found = zero_set(form_of(text, number))
    assert found is not None
    assert (found.kind, found.normal) == (kind, normal)


@pytest.mark.parametrize(
    "form",
    [
        PolynomialForm(("x",), (((1,), 1),)),
        PolynomialForm(("x", "t1"), (((1, 0), 1),)),
        PolynomialForm(("t1", "t2"), (((2, 0), 1), ((0, 2), 1))),
        PolynomialForm(("x", "y"), (((3, 0), 1), ((0, 0), 1))),
        PolynomialForm(("x", "y"), ()),
    ],
)
def test_others_have_no_name(form: PolynomialForm) -> None:
    assert zero_set(form) is None


def test_a_platform_in_a_quarter_turn() -> None:
    shown = invoke("locus", OCTAHEDRAL, *QUARTER).stdout
    assert "z + 350: a plane with the normal (0, 0, 1)\n" in shown
    assert "39072500: a hyperbolic paraboloid" in " ".join(shown.split())
    plane, quadric = json.loads(invoke("locus", OCTAHEDRAL, *QUARTER, "--json").stdout)["factors"]
    assert (plane["zero_set"], plane["normal"]) == ("plane", ["0", "0", "1"])
    assert (quadric["zero_set"], quadric["normal"]) == ("hyperbolic paraboloid", None)


def test_a_normal_with_long_numbers_is_rounded() -> None:
    form = PolynomialForm(("x", "y"), (((1, 0), 10**30), ((0, 1), -3 * 10**29 - 1), ((0, 0), 5)))
    assert zeros_text(form) == "a line with the normal (1, -0.3)"
    with everything():
        assert zeros_text(form) == f"a line with the normal ({10**30}, {-3 * 10**29 - 1})"


def test_a_robot_of_joints() -> None:
    assert "none: P, an ellipse, is irreducible" in gc.locus("3-rpr", "x, y", at="yaw=90deg").text()


def test_maps_say_the_same() -> None:
    over = ("--over", "x -300:300:7", "--over", "z -500:100:7")
    locus = invoke("locus", OCTAHEDRAL, "--over", "x,z", "--digits", "4").stdout
    of_map = invoke("map", OCTAHEDRAL, *over, "--digits", "4").stdout
    factors = [line.removeprefix("factors").strip() for line in locus.splitlines() if ", up to a factor: " in line]
    assert len(factors) == 2
    assert all(f in of_map for f in factors)
    assert "Decimals are rounded" in of_map


def test_long_factors_of_maps_are_printed() -> None:
    over = ("--over", "x -300:300:5", "--over", "y -300:300:5", "--at", "0 0 50; euler zyx 20 15 10 deg")
    shown = " ".join(invoke("map", OCTAHEDRAL, *over).stdout.split())
    assert "+ 1, up to a factor: a hyperbola" in shown
    exact = " ".join(invoke("map", OCTAHEDRAL, *over, "--full").stdout.split())
    (factor,) = json.loads(invoke("map", OCTAHEDRAL, *over, "--json").stdout)["factors"]
    assert f"1. {factor['polynomial']}: a hyperbola" in exact
