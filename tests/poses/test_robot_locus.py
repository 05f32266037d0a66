"""Loci of robots of joints: the polynomials against paths that close the loops by numbers, and exact determinants."""

from __future__ import annotations

import itertools
import json
import math
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
import sympy
from click.testing import CliRunner
from commands import assert_refused
from mechanisms.shipped_robots import analysis
from mpmath import mpf, sqrt

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.loci.limb_report import RobotLocus

CROSSED: dict[str, tuple[dict[str, float], str, tuple[float, float]]] = {
    "3-rpr": ({"y": 0.9, "yaw": 0.0}, "x", (0.5, 1.4)),
    "3-rps": ({"roll": 0.1, "pitch": 0.15}, "z", (-1.9, -0.5)),
    "3-rrr": ({"y": -0.067, "yaw": -0.35}, "x", (0.1, 0.15)),
    "3-ups-s": ({"roll": -0.04, "pitch": -0.051}, "yaw", (-1.3, -0.8)),
    "orthoglide": ({"x": 1.6, "y": 1.65}, "z", (1.4, 1.8)),
    "3-prps": ({"x": 0.068, "y": 0.141, "roll": 0.587, "pitch": -0.279, "yaw": 0.003}, "z", (-0.5, 0.0)),
    "3-rrr-spherical": ({"pitch": -0.73, "yaw": -0.503}, "roll", (-0.6, -0.4)),
}
"""Coordinates that are fixed, the one that is not, and between which values of it the robot becomes singular."""


def written(at: dict[str, float]) -> str:
    return ", ".join(f"{n}={v}{'rad' if n in ('roll', 'pitch', 'yaw') else ''}" for n, v in at.items())


def signs(found: RobotLocus, x: float) -> list[int]:
    """Those of all polynomials at a value of the only variable, exact; angles as half-tangents."""
    value = Fraction(math.tan(x / 2) if found.variables[0].startswith("t_") else x).limit_denominator(10**9)
    values = [p.form([value]) for p in found.parts]
    return [(v > 0) - (v < 0) for v in values]


@pytest.mark.parametrize("name", CROSSED)
def test_places_where_paths_are_singular_are_zeros(name: str) -> None:
    """The second road closes the loops by Newton's method, and takes the determinant of the joints' wrenches."""
    fixed, free, ends = CROSSED[name]
    a = analysis(name)
    found = gc.locus(a, over=free, at=written(fixed))
    assert isinstance(found, RobotLocus)
    path = gc.path(a, ["home", *(written({**fixed, free: end}) for end in ends)], samples=10)
    at = [c.coordinates[path.names.index(free)] for c in path.crossings if c.parameter > 1]
    assert at
    assert all(signs(found, x - 1e-5) != signs(found, x + 1e-5) for x in at)


def test_the_planar_robot_of_sliding_legs_is_a_conic() -> None:
    """For a fixed orientation the locus of 3-RPR is a conic; and its value is the determinant of the three lines."""
    found = gc.locus(analysis("3-rpr"), over="x, y", at="yaw=90deg")
    (part,) = found.parts
    assert part.form.degree == 2
    assert not found.roots
    home = analysis("3-rpr").robot.values_at()
    cx, cy = (sum(home[f"B{k}"][i] for k in "123") / 3 for i in (0, 1))
    for x, y in ((0, 0), (1, 2), (Fraction(1, 3), -5), (7, Fraction(2, 9))):
        rows = []
        for k in "123":
            bx, by = home[f"B{k}"][0] - cx, home[f"B{k}"][1] - cy
            a, b = home[f"A{k}"], (cx + x - by, cy + y + bx)
            rows.append((a[1] - b[1], b[0] - a[0], a[0] * b[1] - a[1] * b[0]))
        (a, b, c), (d, e, f), (g, h, i) = rows
        determinant = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
        assert abs(part.coefficient * part.form([Fraction(x), Fraction(y)])) == abs(determinant)


@pytest.mark.parametrize("name", ["3-rps", "3-rpr", "orthoglide", "delta", "3-puu", "3-prs"])
def test_regular_poses_are_no_zeros(name: str) -> None:
    """Where `gc.pose` finds regular poses no polynomial is 0."""
    a = analysis(name)
    names = gc.compiled(a).coordinates
    fixed = {n: 0.05 * (k + 1) for k, n in enumerate(names[1:])}
    found = gc.locus(a, over=names[0], at=written(fixed))
    for x in (-0.1, 0.0, 0.1):
        assert gc.pose(a, {**fixed, names[0]: x}, nearest=False).verdict == "regular"
        assert all(signs(found, x))


def test_what_is_seen_at_zeros() -> None:
    """Of 3-RPS: yaw has two places for each pose; at zeros that are met the robot is singular in the mode told."""
    found = gc.locus(analysis("3-rps"), over="z", at="roll=0.1rad, pitch=0.15rad")
    (root,) = found.roots
    assert root.places == "yaw"
    (part,) = found.parts
    assert {m for f in part.factors for m in f.seen.modes} == {"+", "-"}
    product: Any = 1
    for f in part.factors:
        product = product * f.form.poly.as_expr() ** f.multiplicity
    ratio = (product / part.form.poly.as_expr()).simplify()
    assert ratio.is_number


@pytest.mark.parametrize(
    ("name", "at", "text"),
    [
        # far from home: half a turn of yaw, all three planes of the legs and that of the platform meet in a point
        (
            "3-rps",
            "roll=0deg, pitch=-90deg",
            "8*z + 57; at its one real zero the robot is singular, in the working mode -",
        ),
        # a slide at right angles to its bar: all bars are along z there, and a root is 0
        ("orthoglide", "x=0, y=0", "z - 4, to the power 2; at its one real zero the robot is singular"),
        ("orthoglide", "x=1, y=0", "z^2 - 15, to the power 2; at all of its 2 real zeros the robot is singular"),
        ("delta", "x=0, y=0", "13*z^4 - 312*z^3 + 4104*z^2 - 26784*z + 80720, to the power 2; it has no real zeros"),
        ("4-ruu", "x=0, y=0", "z - 6, to the power 16; at its one real zero the robot is not assembled"),
    ],
)
def test_all_real_zeros_in_one_variable_are_looked_at(name: str, at: str, text: str) -> None:
    found = gc.locus(analysis(name), over="z", at=at)
    assert all(f.seen.every for part in found.parts for f in part.factors)
    assert text in " ".join(str(found).split())


@pytest.mark.parametrize("name", ["tricept", "exechon", "gallardo-4dof", "3-pprs"])
def test_robots_without_a_locus_say_why_and_what_to_use(name: str) -> None:
    with pytest.raises(InputError, match=f"{name} has no locus as a polynomial") as fault:
        gc.locus(analysis(name))
    assert "gcrules map" in (fault.value.hint or "")


@pytest.mark.parametrize("name", ["6-rus", "6-pus"])
def test_products_over_too_many_working_modes_are_refused(name: str) -> None:
    with pytest.raises(LimitReached, match="64 working modes") as fault:
        gc.locus(analysis(name), over="x", at="y=0.1", product=True)
    assert "product=False" in (fault.value.hint or "")


def in_mode(found: RobotLocus, at: dict[str, float], signs: str) -> list[Any]:
    """The polynomials where roots are kept, by their radicands; of robots whose roots are + in home's mode."""
    known = {n: mpf(x) for n, x in at.items()}
    for root, sign in zip(found.roots, signs, strict=True):
        assert not root.sign
        radicand = root.radicand([known[n] for n in root.radicand.variables])
        known[root.name] = mpf(f"{sign}1") * sqrt(radicand)
    return [part.form([known[n] for n in part.form.variables]) for part in found.parts]


KEPT: dict[str, tuple[dict[str, float], str, tuple[float, float]]] = {
    **{name: CROSSED[name] for name in ("3-rrr", "orthoglide", "3-rps", "3-rrr-spherical")},
    "6-rus": ({"x": 0.01, "y": -0.44, "roll": -0.35, "pitch": 0.54, "yaw": -0.02}, "z", (0.0, -0.8)),
}


@pytest.mark.parametrize("name", KEPT)
def test_with_roots_the_sign_changes_where_paths_are_singular(name: str) -> None:
    """The same second road; now the mode is told apart, so that the sign changes in home's."""
    fixed, free, ends = KEPT[name]
    a = analysis(name)
    found = gc.locus(a, over=free, at=written(fixed), product=False)
    assert not found.multiplied
    path = gc.path(a, ["home", *(written({**fixed, free: end}) for end in ends)], samples=10)
    at = [c.coordinates[path.names.index(free)] for c in path.crossings if c.parameter > 1]
    assert at
    (variable,) = found.question.free
    home, turns = "+" * len(found.roots), free in ("roll", "pitch", "yaw")
    for x in at:
        near = (math.tan(y / 2) if turns else y for y in (x - 1e-5, x + 1e-5))
        below, above = (in_mode(found, {variable: y}, home) for y in near)
        assert any(v * w < 0 for v, w in zip(below, above, strict=True))


@pytest.mark.parametrize(("name", "over", "at"), [("delta", "x", "y=0.2, z=0.1"), ("3-rps", "z", "roll=0.1rad")])
def test_the_product_is_that_of_all_modes(name: str, over: str, at: str) -> None:
    kept, multiplied = (gc.locus(analysis(name), over=over, at=at, product=p) for p in (False, True))
    assert [r.name for r in kept.roots] == [r.name for r in multiplied.roots]
    modes = ["".join(signs) for signs in itertools.product("+-", repeat=len(kept.roots))]
    for x in (0.03, -0.11):
        every = [in_mode(kept, {over: x}, signs) for signs in modes]
        for k, (one, other) in enumerate(zip(kept.parts, multiplied.parts, strict=True)):
            left = math.prod(
                float(one.coefficient) * values[k] / math.prod(p([x]) ** n for p, n in one.below) for values in every
            )
            right = float(other.coefficient) * other.form([x]) / math.prod(p([x]) ** n for p, n in other.below)
            assert len(other.roots) == len(kept.roots)
            assert left == pytest.approx(right, rel=1e-6)


@pytest.mark.parametrize("name", ["delta", "3-prs", "3-rrr", "6-rus"])
def test_long_products_are_left_out(name: str) -> None:
    """All coordinates of the translation are free, of robots whose product would have degrees of hundreds."""
    found = gc.locus(analysis(name), over="x" if name == "6-rus" else None)
    assert not found.multiplied
    assert set(found.variables) == {*found.question.free, *(r.name for r in found.roots)}
    assert found.degrees["total"] < 60
    answer = found.to_json()
    assert (answer["multiplied"], answer["variables"]) == (False, list(found.variables))
    assert "a sign for each root" in str(found)


def test_a_home_far_away_has_the_same_locus() -> None:
    r = analysis("3-rpr").robot
    assert r.home is not None
    shift = 10**9
    home = {n: tuple(c + shift * (k == 0) for k, c in enumerate(v)) for n, v in r.home.items()}
    near, far = (gc.locus(robot, over="x, y", at="yaw=90deg") for robot in (r, replace(r, home=home)))
    assert near.parts[0].form == far.parts[0].form
    assert [b - a for a, b in zip(near.centre, far.centre, strict=True)] == [shift, 0, 0]


def test_commands() -> None:
    run = CliRunner().invoke
    done = run(cli, ["locus", "3-rpr", "--over", "x,y", "--at", "yaw=90deg"])
    assert done.exit_code == 0
    assert "P = 450*x^2" in done.stdout
    assert "exactly where one of them is 0, unless a limb is singular by itself." in " ".join(done.stdout.split())
    answer = json.loads(run(cli, ["locus", "delta", "--over", "x", "--at", "y=0.2, z=0.1", "--json"]).stdout)
    assert [part["kind"] for part in answer["parts"]] == ["actuation", "constraint"]
    assert len(answer["roots"]) == 3
    for option in (["--latex"], ["--export", "sympy"], ["--export", "maple"], ["--export", "singular"]):
        assert run(cli, ["locus", "orthoglide", "--over", "x,y", "--at", "z=0.1", *option]).exit_code == 0
    assert_refused(run(cli, ["locus", "3-rpr", "--over", "q1"]), 2, "q1")


def test_squares_of_roots_are_exported_with_the_polynomial() -> None:
    found = gc.locus("3-rrr", over="x", product=False)
    polynomial, zeros = sympy.sympify(found.written("sympy"))
    assert sympy.expand(polynomial - found.to_sympy()) == 0
    for root, zero in zip(found.roots, zeros, strict=True):
        assert sympy.expand(sympy.Symbol(root.name) ** 2 - zero - root.radicand.poly.as_expr()) == 0
    assert found.written("maple").splitlines()[1].startswith("roots := [s_B1^2 - (")
    ring, poly, ideal = found.written("singular").splitlines()
    assert ring == "ring R = 0, (x, s_B1, s_B2, s_B3), dp;"
    assert poly.startswith("poly P = ")
    assert ideal.startswith("ideal roots = s_B1^2 - (")
    assert gc.locus("3-rpr", over="x").written("maple").count(":=") == 1


def test_results_are_values() -> None:
    one, other = (gc.locus(analysis("3-rps"), over="z") for _ in range(2))
    assert one == other
    assert hash(one) == hash(other)
    assert one.verdict == "regular"


def test_joints_with_equal_radicands_have_signs_of_their_own() -> None:
    """Arms 2 and 3 of Delta mirror each other over x = y = 0: singular in a mode in which one of their elbows is out
    and the other one in, at a z that was found by intersecting circles, without any of this.
    """
    found = gc.locus("delta", over="z")
    assert len(found.roots) == 3
    near = [
        abs(float(part.form([Fraction(round(z * 10**12), 10**12)]))) for part in found.parts for z in (1.1223498052,)
    ]
    away = [abs(float(part.form([Fraction(11, 10)]))) for part in found.parts]
    assert min(a / b for a, b in zip(near, away, strict=True)) < 1e-6


def test_a_mode_that_is_singular_in_every_pose_is_no_locus() -> None:
    """Two carriages on one rail: where both rods lean to one side they are parallel, wherever the platform is."""
    text = """
title: linear Delta with two carriages on one rail
copies: 3
points:
  A%: free
  B%: free
directions:
  d%: free
  u%: free
  v%: perpendicular to u%, A% B%
limbs:
  - name: leg %
    joints: P*(d%) U(A%, u%, v%) U(B%, v%, u%)
mobility: 3
home:
  A1: [-3, 0, 0]
  A2: [3, 0, 0]
  A3: [2, 3, 0]
  B1: [-1, 0, 2]
  B2: [1, 0, 2]
  B3: [0, 1, 2]
  d1: [1, 0, 0]
  d2: [1, 0, 0]
  d3: [1, 0, 0]
  u1: [0, 1, 0]
  u2: [0, 1, 1]
  u3: [1, 0, 1]
"""
    with pytest.raises(gc.InputError, match="in one of the working modes every pose is singular"):
        gc.locus(gc.load(text))


@pytest.mark.parametrize("name", ["3-crr", "3-cpu"])
@pytest.mark.parametrize("multiplied", [None, True, False])
def test_a_factor_that_does_not_depend_on_the_pose(name: str, multiplied: bool | None) -> None:
    found: Any = gc.locus(name, over="x", product=multiplied)
    assert found.parts
    assert all(part.form.degree == 0 and not part.found for part in found.parts)
    assert "it vanishes nowhere" in found.text()


@pytest.mark.parametrize("about", ["origin", (20, 0, 0), (0, 0, -30)])
def test_the_centre_of_turns_may_be_far_away(about: Any) -> None:
    """Another centre is a substitution: where nothing turns it makes no difference."""
    (far,) = gc.locus("3-rrr", over="y", about=about).parts
    (near,) = gc.locus("3-rrr", over="y").parts
    for y in (Fraction(1, 7), Fraction(-3, 5)):
        assert far.form([y]) * near.form([Fraction(2, 3)]) == near.form([y]) * far.form([Fraction(2, 3)])


def test_the_signs_of_roots_that_a_factor_does_not_have_are_told() -> None:
    found: Any = gc.locus("3-puu", over="y", fix="x=-1/4, z=1/2", product=True)
    words = " ".join(found.text().split())
    assert words.count("signs of s_A2 and s_A3, home's are +; s_A1 as at home") == 2
    assert "over all signs of its roots" in words
    assert words.count("product of the factor over the 4 choices of signs") == 2


def test_a_factor_that_is_known_up_to_a_cofactor_says_so() -> None:
    """4-UPU, whose platform only shifts at yaw 0: the expressions at shifted points, beside the polynomial."""
    (part,) = gc.locus("4-upu").parts
    home = {
        "A": [(4, 0, 1), (0, 4, 0), (-4, 0, 0), (0, -4, 2)],
        "B": [(-1, 1, 2), (-1, 2, 3), (-2, 2, 2), (1, -1, 3)],
    }
    directions = {n: tuple(int(n == m) for m in "xyz") for n in "xyz"}
    points = [*directions, *(f"{body}{k}" for body in home for k in range(1, 5))]
    ratios = set()
    for shift in [(0, 0, 0), (1, 2, 3), (2, -1, 5), (-3, 7, 1)]:
        at = {n: (*d, 0) for n, d in directions.items()}
        at |= {f"A{k}": (*c, 1) for k, c in enumerate(home["A"], 1)}
        at |= {f"B{k}": (*(a + b for a, b in zip(c, shift, strict=True)), 1) for k, c in enumerate(home["B"], 1)}
        above, below = (gc.evaluate(gc.parse(e, points=points), at) for e in (part.expression, part.cofactor))
        wanted = part.form([*shift, 0])
        ratios.add((above == below * wanted * part.coefficient, below == 0))
    assert {same for same, _ in ratios} == {True}
    assert (True, False) in ratios
    shown = str(gc.locus("4-upu"))
    assert f"cofactor  {part.cofactor}" in shown
    assert "factor / cofactor = " in shown
