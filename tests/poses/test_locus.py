"""The locus as a polynomial: equal to the superbracket at exact poses, with the degrees and factors that are proved."""

from __future__ import annotations

import json
import pickle
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy
from click.testing import CliRunner
from commands import assert_refused, invoke
from hypothesis import given, settings
from hypothesis import strategies as st
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import EngineFault, InputError, LimitReached
from gcrules.mechanisms.description.platform_file import Platform, load_platform, parse_platform
from gcrules.mechanisms.moving_platform import rig
from gcrules.poses.loci import locus as module
from gcrules.poses.loci.expansion import expansion
from gcrules.poses.loci.factors import PossibleFactor, factored, primitive
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import rational_ring, whole_ring
from gcrules.poses.loci.locus import locus
from gcrules.poses.loci.variables import question
from gcrules.poses.numbers.cubic import superbracket_at, translation_polynomial
from gcrules.rules.catalog.file import load
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose
from gcrules.screws.rotations import from_vector
from gcrules.views.results.locus import form_latex

F = Fraction
ALL = ("x", "y", "z", "e0", "e1", "e2", "e3")


@pytest.fixture(scope="module")
def robots() -> dict[str, Any]:
    names = ("octahedral", "platform-6-6", "platform-6-4", "platform-6-3", "four-dof")
    return {n: gc.analyze(load_platform(EXAMPLES / f"{n}.yaml")) for n in names}


def robot(legs: str, seed: int = 1, flat: str = "") -> Platform:
    """Legs between joints with small random coordinates; upper case letters are the base, `flat` bodies have z = 0."""
    rng = random.Random(seed)
    points = {n: [F(rng.randint(-9, 9)) for _ in range(3)] for n in dict.fromkeys(legs.replace(" ", ""))}
    for n, p in points.items():
        if ("base" in flat and n.isupper()) or ("platform" in flat and n.islower()):
            p[2] = F(0)
    return Platform(tuple((w[0], w[1]) for w in legs.split()), {n: tuple(p) for n, p in points.items()})


GENERAL = "Aa Bb Cc Dd Ee Ff"
rationals = st.fractions(-5, 5, max_denominator=7)


# --- two roads: the superbracket at exact poses ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "about"), [("octahedral", "origin"), ("platform-6-6", "centroid"), ("four-dof", (1, "2.5", -3))]
)
def test_it_is_the_superbracket(robots: dict[str, Any], name: str, about: Any) -> None:
    found = locus(robots[name], about=about)
    moving = found.rig

    @settings(max_examples=8, deadline=None)
    @given(st.tuples(*[rationals] * 7).filter(lambda v: any(v[3:])))
    def same(v: Any) -> None:
        pose = Pose(v[:3], v[3:])
        expected = superbracket_at(moving.structure.legs, moving.exact(pose)) * sum(c * c for c in v[3:]) ** 3
        assert found.coefficient * found.form(v) == expected

    same()


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ({"over": "x,y,z", "at": "1 2 3; quaternion 0.8 0 0.6 0"}, "{x} {y} {z}; quaternion 0.8 0 0.6 0"),
        ({"over": "x", "at": "0 1/2 3; euler zyx 90 0 0 deg"}, "{x} 1/2 3; euler zyx 90 0 0 deg"),
        ({"over": "rotation", "at": "1 2 -3"}, "1 2 -3; {e0} {e1} {e2} {e3}"),
        ({"over": "e0 e3", "at": "1 2 -3"}, "1 2 -3; {e0} 0 0 {e3}"),
        ({"fix": "x=1, e1=1/2"}, "1 {y} {z}; {e0} 1/2 {e2} {e3}"),
        ({"rotation": "rodrigues"}, "{x} {y} {z}; 1 {c1} {c2} {c3}"),
        ({"rotation": "rodrigues", "over": "y c2", "at": "1 0 0; quaternion 0.6 0 0 0.8"}, "1 {y} 0; 1 0 {c2} 4/3"),
        ({"over": "z", "rotation": "rodrigues", "at": "1 0 0; quaternion 0 0 0 1"}, "1 0 {z}; 0 0 0 1"),
        ({"over": "translation", "fix": {"e0": 2, "e1": 0, "e2": 0, "e3": F(1, 3)}}, "{x} {y} {z}; 2 0 0 1/3"),
    ],
)
def test_slices(robots: dict[str, Any], arguments: dict[str, Any], text: str) -> None:
    found = locus(robots["platform-6-4"], **arguments)
    moving = rig(robots["platform-6-4"].structure, robots["platform-6-4"].platform)
    for k in range(1, 4):
        values = {n: F(3 * i - 7, k + i) for i, n in enumerate(found.variables)}
        first, turn = text.format(**values).split(";")
        q = turn.split()
        if len(q) == 4:
            pose = Pose(tuple(map(F, first.split())), tuple(map(F, q)))
        else:
            pose = parse_pose(f"{first};{turn}")
        norm = F(1)
        for n in found.norms:
            norm *= n([values[v] for v in n.variables])
        expected = superbracket_at(moving.structure.legs, moving.exact(pose)) * norm**3
        assert found.coefficient * found(**values) == expected


@pytest.mark.parametrize("sequence", ["zyx", "ZYX", "xyz", "ZXZ"])
def test_tangents_are_those_of_the_half_angles(robots: dict[str, Any], sequence: str) -> None:
    found = locus(robots["octahedral"], rotation=sequence, fix="x=10, y=0, z=-5")
    for angles in ((90, 0, 0), (0, 90, 0), (0, 0, 90), (90, -90, 90)):  # tangents of 45°, exact
        text = f"10 0 -5; euler {sequence} {' '.join(map(str, angles))} deg"
        values = dict(zip(("t1", "t2", "t3"), (a // 90 for a in angles), strict=True))
        norm = F(2) ** sum(map(bool, angles))
        assert (
            found.coefficient * found(**values)
            == norm**3 * gc.pose(robots["octahedral"], text, nearest=False).superbracket
        )


def test_the_same_cubic_as_by_interpolation(robots: dict[str, Any]) -> None:
    a = robots["platform-6-6"]
    found = locus(a, "translation", at="0 0 0; quaternion 0.8 0 0.6 0")
    moving = rig(a.structure, a.platform)
    points = moving.exact(parse_pose("0 0 0; quaternion 0.8 0 0.6 0"))
    cubic = translation_polynomial(a.structure.legs, points, a.structure.platform, F(1))
    assert {e: found.coefficient * c for e, c in found.form.terms} == dict(cubic.coefficients)


def test_against_the_determinant_of_sympy(robots: dict[str, Any]) -> None:
    """The naive road, for one plane of translations."""
    a = robots["octahedral"]
    x, z = sympy.symbols("x z")
    rows = []
    for leg in a.structure.legs:
        p, q = (
            sympy.Matrix([sympy.Rational(c.numerator, c.denominator) for c in a.platform.points[n]])
            + (sympy.Matrix([x, 0, z]) if a.structure.sides[n] == "platform" else sympy.zeros(3, 1))
            for n in leg
        )
        rows.append([*(q - p), *p.cross(q)])
    naive = -sympy.Matrix(rows).det(method="berkowitz")
    found = locus(a, "x z")
    assert sympy.expand(naive - sympy.Rational(*found.coefficient.as_integer_ratio()) * found.to_sympy()) == 0


def test_a_wrong_polynomial_is_noticed(robots: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    def wrong(moving: Any) -> Any:
        return {e: c + (sum(e) == 6) for e, c in expansion(moving).items()}

    monkeypatch.setattr(module, "expansion", wrong)
    with pytest.raises(EngineFault, match="disagrees"):
        locus(robots["octahedral"])


# --- degrees -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("flat", "each", "terms"),
    [
        ("", [3, 3, 3, 6, 6, 6, 6], 1668),
        ("base", [2, 2, 3, 6, 6, 6, 6], 1304),
        ("platform", [3, 3, 3, 6, 6, 6, 6], 1468),
        ("base and platform", [2, 2, 3, 6, 6, 6, 6], 396),
    ],
    ids=["general", "flat base", "flat platform", "both flat"],
)
def test_degrees_of_the_general_platform(flat: str, each: list[int], terms: int) -> None:
    """3 in the translation and 6 in the quaternion; a flat base in the plane z = 0 lowers those in x and y."""
    found = locus(robot(GENERAL, flat=flat), about="origin")
    assert found.degrees == {**dict(zip(ALL, each, strict=True)), "translation": 3, "rotation": 6, "total": 9}
    assert len(found.form.terms) == terms
    assert all(sum(e[3:]) == 6 for e, _ in found.form.terms)  # homogeneous in the quaternion
    assert [(f.kind, f.multiplicity) for f in found.factors] == [("condition", 1)]


def test_degrees_of_slices_of_the_general_platform() -> None:
    general = robot(GENERAL)
    assert locus(general, "translation", at="0 0 0; quaternion 0.8 0 0.6 0").degrees["total"] == 3
    assert locus(general, "rotation", at="1 2 3").degrees["total"] == 6
    rodrigues = locus(general, "rotation", at="1 2 3", rotation="rodrigues").degrees
    assert rodrigues == {"c1": 6, "c2": 6, "c3": 6, "rotation": 6, "total": 6}
    tangents = locus(general, "rotation", at="1 2 3", rotation="zyx").degrees
    assert tangents == {"t1": 6, "t2": 6, "t3": 6, "rotation": 18, "total": 18}


def test_flat_bodies_in_parallel_planes_lower_the_degree() -> None:
    """Without tilt: z³ |e|⁴ (a (e0² − e3²) + b e0 e3), so singular at two angles, whatever the place."""
    flat = robot(GENERAL, flat="base and platform")
    assert locus(flat, "translation").degrees == {"x": 0, "y": 0, "z": 3, "translation": 3, "total": 3}
    norm, height, angles = locus(flat, fix="e1=0, e2=0").factors
    assert (norm.kind, str(norm.form), norm.multiplicity) == ("norm", "e0^2 + e3^2", 2)
    assert (str(height.form), height.multiplicity) == ("z", 3)
    quadratic = dict(angles.form.terms)
    assert quadratic[0, 0, 0, 2, 0] == -quadratic[0, 0, 0, 0, 2]
    assert set(quadratic) == {(0, 0, 0, 2, 0), (0, 0, 0, 1, 1), (0, 0, 0, 0, 2)}


def test_every_class_has_the_factors_of_its_condition() -> None:
    """The brackets of the catalog divide, and what is left is irreducible."""
    seen = 0
    for k, entry in enumerate(load().entries):
        legs = " ".join(f"{a}{b}" for a, b in entry.legs)
        if entry.condition.kind == "always-singular":
            continue
        if k % 7:  # a seventh of them will do
            continue
        found = locus(robot(legs, seed=k))
        brackets = [f for f in found.factors if f.kind == "bracket"]
        named = [f.name.replace(" ", "")[1:-1] for f in brackets]
        assert sorted(named) == sorted("".join(sorted(b)) for b in entry.factors)
        assert sum(f.form.degree * f.multiplicity for f in found.factors) == found.form.degree == 9
        seen += 1
    assert seen >= 5


def test_the_product_of_the_factors_is_the_polynomial(robots: dict[str, Any]) -> None:
    for arguments in ({"fix": "e1=0, e2=0"}, {"over": "translation"}, {"over": "rotation"}):
        found = locus(robots["four-dof"], **arguments)
        product = sympy.Poly(1, *found.polynomial.gens)
        for f in found.factors:
            product *= f.form.poly**f.multiplicity
        assert product in (found.polynomial, -found.polynomial)
        assert len(found.factors) > 1


# --- what is known of some robots -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "pose", ["0 0 -350", "10 -20 -350", "0 0 -350; euler zyx 40 0 0 deg", "5 0 -350; rotation-vector 0 0 90 deg"]
)
def test_singular_poses_of_the_octahedral_platform_lie_on_it(robots: dict[str, Any], pose: str) -> None:
    at = parse_pose(pose)
    singular = gc.pose(robots["octahedral"], pose, nearest=False).superbracket == 0
    found = locus(robots["octahedral"])
    assert (found.form([*at.translation, *at.quaternion]) == 0) is singular
    assert singular


def test_the_locus_of_the_octahedral_platform_turned_by_a_quarter(robots: dict[str, Any]) -> None:
    found = locus(robots["octahedral"], "translation", at="0 0 0; euler zyx 90 0 0 deg")
    assert sorted(f.form.degree for f in found.factors) == [1, 2]
    assert "z + 350" in [str(f.form) for f in found.factors]


def test_three_tetrahedra(robots: dict[str, Any]) -> None:
    factors = locus(robots["four-dof"]).factors
    assert [(f.kind, f.name) for f in factors] == [
        ("bracket", "[A1 B1 C1 S1]"),
        ("bracket", "[A2 S1 S2 S3]"),
        ("bracket", "[A3 B3 S1 S3]"),
    ]


SIMILAR = """
legs: [Aa, Bb, Cc, Dd, Ee, Ff]
points:
  {A: [2, 0, 0], B: [1, 2, 0], C: [-1, 2, 0], D: [-3, 0, 0], E: [-1, -2, 0], F: [1, -3, 0],
   a: [1, 0, 3], b: [1/2, 1, 3], c: [-1/2, 1, 3], d: [-3/2, 0, 3], e: [-1/2, -1, 3], f: [1/2, -3/2, 3]}
"""


def test_flat_similar_platforms_are_singular_in_parallel() -> None:
    """Parallel similar hexagons: each translation is singular, and yet not every pose."""
    similar = parse_platform(SIMILAR)
    found = locus(similar, "translation")
    assert (found.vanishes, found.verdict, found.coefficient, found.factors) == (True, "singular", 0, ())
    assert gc.pose(similar, "3 1 2", nearest=False).superbracket == 0
    whole = locus(similar)
    assert [str(f.form) for f in whole.factors][:3] == ["e0", "e3", "e1^2 + e2^2"]  # turns of certain kinds
    each = dict(zip(ALL, (1, 1, 1, 3, 4, 4, 3), strict=True))
    assert whole.degrees == {**each, "translation": 1, "rotation": 6, "total": 7}
    for turn, singular in (("1 0 0 0", True), ("0.6 0 0 0.8", True), ("0.8 0 0.6 0", True), ("0.5 0.5 0.5 0.5", False)):
        there = gc.pose(similar, f"1 2 1; quaternion {turn}", nearest=False)
        assert (there.superbracket == 0) is singular


def test_a_brief_answer_has_the_degree_and_the_zeros() -> None:
    """The zeros of the singular poses along z that `gcrules path` finds too."""
    name = str(EXAMPLES / "octahedral.yaml")
    along = invoke("locus", name, "--over", "z", "--brief").stdout
    assert " ".join(along.split()).endswith("of degree 3 in z, is 0: at z = -408.9884, -353.7579 and -350 mm, rounded.")
    way = gc.path(gc.load(name), ["z=0", "z=-490"]).zeros
    assert [f"{-490 * float(zero.parameter):.7g}" for zero in way] == ["-350", "-353.7579", "-408.9884"]
    assert "degree 2 in x and y" in invoke("locus", name, "--over", "x,y", "--brief").stdout
    assert PolynomialForm(("x",), (((2,), 1), ((0,), 1))).real_zeros == ()
    assert PolynomialForm(("x",), (((3,), 4), ((2,), -4), ((1,), 1))).real_zeros == (0, 0.5)


def test_architecturally_singular() -> None:
    conic = "legs: [Aa, Bb, Cc, Dd, Ee, Ff]\npoints:\n  {" + ", ".join(
        f"{n}: [{F(1 - t * t, 1 + t * t)}, {F(2 * t, 1 + t * t)}, 0], {n.lower()}: [{F(1 - t * t, 1 + t * t) * 2}, "
        f"{F(2 * t, 1 + t * t) * 2}, 5]"
        for n, t in zip("ABCDEF", (0, 1, 2, -1, -2, 3), strict=True)
    )
    found = locus(parse_platform(conic + "}"))  # circles in projective correspondence
    assert found.verdict == "architecturally singular"
    assert found.degrees["total"] == -1
    assert "architecturally singular" in " ".join(found.text().split())
    assert repr(found).startswith("<Locus 0 in x, y, z, e0")
    assert found.to_json()["polynomial"] == {"exponents": [], "coefficients": []}
    always = locus(robot("Aa Ab Ac Ad Be Cf", seed=3))
    assert always.vanishes


def test_powers_of_the_norm_are_told_apart(robots: dict[str, Any]) -> None:
    found = locus(robots["platform-6-6"], fix="e1=0, e2=0")
    assert next((f.kind, str(f.form)) for f in found.factors) == ("norm", "e0^2 + e3^2")
    assert [f.kind for f in found.factors] == ["norm", "condition"]
    alone = locus(robots["platform-6-6"], "e0", at="1 2 3; quaternion 1 0 0 0")
    assert [(f.kind, str(f.form), f.multiplicity) for f in alone.factors] == [("norm", "e0", 6)]


# --- factors -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "factors"),
    [
        ("x**2 - y**2", [("x + y", 1), ("x - y", 1)]),
        ("4*x**2*y - 8*x**2", [("x", 2), ("y - 2", 1)]),
        ("x**2 + 2*y**2", [("x^2 + 2*y^2", 1)]),
        ("(x*y + 1)**2 * (x + 3)", [("x*y + 1", 2), ("x + 3", 1)]),
    ],
)
def test_factors(text: str, factors: list[tuple[str, int]]) -> None:
    ring = rational_ring(["x", "y"])
    p = primitive(ring.from_expr(sympy.sympify(text)))[1]
    assert sorted((str(PolynomialForm.of(f)), n) for _, _, f, n in factored(p, [])) == sorted(factors)


def test_search_has_a_limit() -> None:
    ring = whole_ring(["x", "y"])
    x, y = ring.gens
    p = (x**2 + 3 * y + 1) * (x * y - 7)
    with pytest.raises(LimitReached, match=r"degrees 2, 2") as fault:
        factored(p, [], limit=5)
    assert "--limit 6" in str(fault.value.hint)
    assert len(factored(p, [PossibleFactor("bracket", "[a b c d]", x * y - 7)], limit=5)) == 2


def test_primitive() -> None:
    ring = rational_ring(["x"])
    (x,) = ring.gens
    c, q = primitive(ring.domain(2, 3) * (2 - 4 * x) / 5)
    assert (str(c), str(PolynomialForm.of(q))) == ("-4/15", "2*x - 1")


# --- the value -----------------------------------------------------------------------------------------------------


def test_forms_are_read_back(robots: dict[str, Any]) -> None:
    found = locus(robots["octahedral"], "translation", at="0 0 0; euler zyx 90 0 0 deg", about="origin")
    assert sympy.sympify(found.written("sympy")) == found.to_sympy()
    assert sympy.Poly(found.to_sympy()) == found.polynomial
    maple = found.written("maple")
    assert maple.startswith("P := 15*x*y*z + ")
    assert maple.endswith(":")
    assert found.written("singular").splitlines()[0] == "ring R = 0, (x, y, z), dp;"
    listed = found.to_json()["polynomial"]
    again = {tuple(e): int(c) for e, c in zip(listed["exponents"], listed["coefficients"], strict=True)}
    assert sympy.Poly.from_dict(again, *found.polynomial.gens) == found.polynomial
    assert r"15\,x y z + 20\,x z^{2}" in found.latex()
    assert found._repr_latex_().startswith("$")


@pytest.mark.parametrize(
    ("terms", "text", "latex"),
    [
        ((((2, 1), -3), ((0, 0), 1)), "-3*x^2*e0 + 1", r"-3\,x^{2} e_{0} + 1"),
        ((((1, 0), 1), ((0, 1), -1)), "x - e0", "x - e_{0}"),
        ((), "0", "0"),
        ((((0, 0), -1),), "-1", "-1"),
    ],
)
def test_texts(terms: Any, text: str, latex: str) -> None:
    form = PolynomialForm(("x", "e0"), terms)
    assert (str(form), form_latex(form)) == (text, latex)
    assert sympy.sympify(form.written("sympy")) == form.poly.as_expr()


def test_it_is_a_frozen_value(robots: dict[str, Any]) -> None:
    found = locus(robots["octahedral"], "z")
    assert found == gc.locus(robots["octahedral"].platform, "z")
    assert hash(found) == hash(locus(robots["octahedral"], "z"))
    assert pickle.loads(pickle.dumps(found)) == found
    assert repr(found) == "<Locus of degree 3 in z: 4 terms>"
    assert str(found) == found.text(unicode=True)


# --- questions and faults ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"over": "x,w"}, "'w' is not a variable"),
        ({"over": "e4"}, "did you mean"),
        ({"over": "traslation"}, "did you mean translation"),
        ({"over": "x x"}, "named twice"),
        ({"over": ""}, "no variable is left free"),
        ({"over": "t1"}, "'t1' is not a variable"),
        ({"over": "x", "fix": "x=0"}, "x cannot be free and fixed"),
        ({"fix": "x=0, x=1"}, "fixed twice"),
        ({"fix": "x"}, "fixes nothing"),
        ({"fix": "x=nan"}, "finite"),
        ({"fix": {"x": float("inf")}}, "finite"),
        ({"fix": "x=1e999"}, "too long"),
        ({"fix": "e0=0,e1=0,e2=0,e3=0"}, "not a turn"),
        ({"fix": "x=0,y=0,z=0,e0=1,e1=0,e2=0,e3=0"}, "no variable is left free"),
        ({"at": "1 2 3"}, "nothing is taken from the pose"),
        ({"over": "x", "at": "1 2"}, "3 numbers"),
        ({"over": "x", "at": "1 2 3; quaternion 2 0 0 0"}, "length 2"),
        ({"over": "x", "at": "1 2 3 cm"}, "mixed units"),
        ({"rotation": "quaternions"}, "did you mean quaternion"),
        ({"rotation": "xxy"}, "no rotation"),
        ({"over": "c1", "rotation": "rodrigues", "at": "0 0 0; quaternion 0 1 0 0"}, "half turn"),
        ({"over": "t1", "rotation": "zyx", "at": "0 0 0; quaternion 0.8 0 0 0.6"}, "--fix"),
        ({"about": "the moon"}, "not a centre"),
    ],
)
def test_faults(robots: dict[str, Any], arguments: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError) as fault:
        locus(robots["octahedral"], **arguments)
    assert says in fault.value.render()


def test_degenerate_robots_are_refused(robots: dict[str, Any]) -> None:
    with pytest.raises(InputError, match="legs alone have no coordinates"):
        locus(gc.analyze("ab af cb cd ed ef"))
    with pytest.raises(InputError, match="lie on one line"):
        locus(
            parse_platform(
                "legs: [Aa, Ba, Cb, Db, Ec, Fc]\npoints: {A: [0, 0, 0], B: [1, 0, 0], C: [2, 0, 0], "
                "D: [3, 0, 0], E: [4, 0, 0], F: [5, 0, 0], a: [0, 1, 2], b: [3, 1, 2], c: [1, 5, 2]}"
            )
        )


def test_questions() -> None:
    asked = question("z, rotation", {"x": 0.1}, "0 5 0", "quaternion", "")
    assert asked.free == ("z", "e0", "e1", "e2", "e3")
    assert dict(asked.fixed) == {"x": F(1, 10), "y": 5}
    turned = question("x", None, Pose(quaternion=from_vector((0, 0, 90), degrees=True)), "zyx", "")
    assert turned.turn == (1, 0, 0, 1)
    assert not turned.whole
    assert question(None, None, None, "rodrigues", "").whole


# --- the command line ----------------------------------------------------------------------------------------------


def run(*arguments: str, text: str | None = None) -> Any:
    return CliRunner().invoke(cli, ["locus", *arguments], input=text)


def test_the_command(tmp_path: Path) -> None:
    file = str(EXAMPLES / "octahedral.yaml")
    found = json.loads(run(file, "--over", "z", "--json").stdout)
    assert (found["schema"], found["variables"], found["degrees"]["total"], found["terms"]) == (1, ["z"], 3, 4)
    assert found["identity"] == {"norm": [], "power": 3, "coefficient": "-15000000000000"}
    assert [f["kind"] for f in found["factors"]] == ["condition", "condition"]
    assert "P = 406*z^3 + " in run(file, "--over", "z").stdout
    target = tmp_path / "locus.txt"
    assert run(file, "--over", "z", "--export", "sympy", "-o", str(target)).exit_code == 0
    assert sympy.sympify(target.read_text()) == sympy.sympify("406*z**3 + 451775*z**2 + 167127500*z + 20559437500")
    assert run("-", "--over", "z", "--latex", text=Path(file).read_text()).stdout.startswith("406\\,z^{3}")
    assert "irreducible" in run(file).stdout


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("--over", "w"), "is not a variable"),
        (("--export", "mapel"), "did you mean maple"),
        (("--export", "maple", "--json"), "excludes"),
        (("--fix", "x=-", "--over", "z"), "expected a number"),
        (("--limit", "0"), "limit"),
        (("-o", "/nowhere/at/all"), "no such directory"),
    ],
)
def test_faults_of_the_command(arguments: tuple[str, ...], says: str) -> None:
    assert_refused(run(str(EXAMPLES / "octahedral.yaml"), *arguments), 2, says)


def test_undecided_factors_are_said() -> None:
    file = str(EXAMPLES / "octahedral.yaml")
    slice_of = ("--over", "translation", "--at", "0 0 0; euler zyx 90 0 0 deg", "--limit", "1")
    assert "not decided" in run(file, *slice_of).stdout.replace("\n           ", " ")
    found = json.loads(run(file, *slice_of, "--json").stdout)
    assert found["factors"] is None
    assert "may be reducible" in found["factors_undecided"]
