"""At a singular pose: line varieties, causes, gained motions; floats beside exact arithmetic."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.conditions.analysis import Analysis
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.poses.numbers.arrays import from_poses
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.poses.numbers.motion import dependence, exact_dependence
from gcrules.poses.numbers.variety import signature, variety
from gcrules.screws.margin import jacobian

F = Fraction
small = st.integers(-6, 6)
seeds = st.integers(0, 2**32 - 1)


LEGS = tuple(zip("ABCDEF", "abcdef", strict=True))


# --- at a singular pose --------------------------------------------------------------------------------------------


def line(p: tuple[int, ...], q: tuple[int, ...]) -> tuple[Fraction, ...]:
    u = [F(b - a) for a, b in zip(p, q, strict=True)]
    return (*u, *(F(int(c)) for c in np.cross(p, q)))


O3 = (0, 0, 0)
RULING = [line((t, 0, 0), (t, 1, t)) for t in (1, 2, -1, 3)]  # of z = xy
MEETING = [
    line((s, 0, 0), (0, t, 1)) for s, t in ((1, 1), (2, -1), (3, 5), (-1, 2), (4, 3))
]  # y = z = 0 and x = 0, z = 1
TURNED = [  # of the elliptic congruence spanned by rulings of hyperboloids about the z axis
    line((r, 0, 0), (r, r, 1)) for r in (1, 2)
] + [line((0, r, 0), (-r, r, 1)) for r in (1, 3)]


@pytest.mark.parametrize(
    ("lines", "name"),
    [
        pytest.param([line(O3, (1, 2, 3))], "a single line", id="line"),
        pytest.param([line(O3, (1, 0, 0)), line((0, 0, 1), (0, 1, 1))], "two skew lines", id="skew"),
        pytest.param([line(O3, (1, 0, 0)), line(O3, (0, 1, 0))], "a planar pencil", id="pencil"),
        pytest.param([line(O3, (1, 0, 0)), line((0, 1, 0), (1, 1, 0))], "a planar pencil", id="parallel"),
        pytest.param([line(O3, e) for e in ((1, 0, 0), (0, 1, 0), (1, 1, 1))], "a bundle", id="bundle"),
        pytest.param([line(p, (*p[:2], 1)) for p in (O3, (1, 0, 0), (0, 1, 0))], "a bundle", id="parallel bundle"),
        pytest.param(
            [line(O3, (1, 0, 0)), line(O3, (0, 1, 0)), line((1, 0, 0), (0, 1, 0))], "a plane field", id="plane"
        ),
        pytest.param(RULING[:3], "a regulus", id="regulus"),
        pytest.param(
            [line(O3, (1, 0, 0)), line(O3, (0, 1, 0)), line((1, 0, 0), (1, 0, 1))],
            "two planar pencils with a common line",
            id="two pencils",
        ),
        pytest.param(MEETING[:4], "a hyperbolic linear congruence", id="hyperbolic"),
        pytest.param(TURNED, "an elliptic linear congruence", id="elliptic"),
        pytest.param(
            [line(O3, (1, 0, 0)), line(O3, (0, 1, 0)), line(O3, (0, 0, 1)), line((1, 0, 0), (0, 1, 0))],
            "a degenerate linear congruence",
            id="bundle and plane",
        ),
        pytest.param(
            [line((0, 0, 0), (1, 0, 0)), *(line((x, 0, 0), (x, 1, x)) for x in (1, 2, 3))],
            "a parabolic linear congruence",
            id="parabolic",
        ),
        pytest.param(
            [
                line((0, 0, z), p)
                for z, p in ((0, (1, 0, 0)), (1, (0, 1, 0)), (2, (1, 1, 0)), (3, (1, 5, 2)), (5, (2, 0, 1)))
            ],
            "a special linear complex (all lines that meet one line)",
            id="special",
        ),
        pytest.param(
            [line((0, x, z), (y, 1, z)) for x, y, z in ((0, 1, 0), (1, 3, 1), (4, 2, 2), (2, 7, 3), (5, 1, 5))],
            "a special linear complex (all lines parallel to one plane)",
            id="parallel to a plane",
        ),
        pytest.param([*TURNED, line((1, 0, 0), (5, 3, 2))], "a general linear complex", id="general"),
        pytest.param(
            [line(O3, e) for e in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
            + [line((1, 0, 0), (0, 1, 0)), line((0, 1, 0), (0, 0, 1)), line((1, 0, 0), (0, 0, 1))],
            "no variety",
            id="tetrahedron",
        ),
    ],
)
def test_line_varieties(lines: list[tuple[Fraction, ...]], name: str) -> None:
    assert variety(lines).name.startswith(name)
    # the same in floats, from an orthonormal basis of the span
    rows = np.array(lines, float)
    basis = np.linalg.svd(rows)[2][: len(rows)]
    assert variety([tuple(r) for r in basis], 1e-9).name.startswith(name)


@given(st.lists(st.lists(small, min_size=4, max_size=4), min_size=4, max_size=4))
def test_signatures(rows: list[list[int]]) -> None:
    m = np.array(rows)
    form = m + m.T
    values = np.linalg.eigvalsh(form.astype(float))
    expected = ((values > 1e-9).sum(), (values < -1e-9).sum(), (abs(values) <= 1e-9).sum())
    assert signature([[F(int(c)) for c in row] for row in form]) == expected


def test_causes_motion_and_legs(robots: dict[str, Analysis]) -> None:
    found = gc.pose(robots["octahedral-singular"])
    assert found.verdict == "singular"
    assert found.value == found.margin == found.turn == 0
    assert found.causes[0] == "The planes abc, aef, bdf and cde meet in a point: (453.488, -9.30233, 418.605) mm."
    assert all(n.distance == 0 and n.exact for n in found.nearest)
    d = found.dependence
    (motion,) = d.motions
    assert d.exact
    assert d.within.name == "a general linear complex"
    assert motion.kind == "screw motion"
    points = {n: np.array([float(c) for c in p]) for n, p in found.rig.points.items()}
    for a, b in found.rig.legs:  # the motion moves each joint across its leg
        velocity = np.cross(motion.axis, points[b] - motion.point) + motion.pitch * np.array(motion.axis)
        assert velocity @ (points[b] - points[a]) == pytest.approx(0, abs=1e-6)
    forces = np.array(
        [
            s * (points[b] - points[a]) / np.linalg.norm(points[b] - points[a])
            for s, (a, b) in zip(d.stress, found.rig.legs, strict=True)
        ]
    )
    moments = np.cross([points[a] for a, _ in found.rig.legs], forces)
    assert np.allclose(forces.sum(axis=0), 0)
    assert np.allclose(moments.sum(axis=0), 0, atol=1e-9)


PENCIL = """
legs: [Aa, Ab, Bc, Cd, De, Ef]
points: {A: [0, 0, 0], B: [3, 0, 0], C: [0, 3, 0], D: [-3, 1, 0], E: [1, -3, 0],
         a: [1, 0, 2], b: [2, 0, 4], c: [3, 1, 3], d: [1, 3, 3], e: [-3, 2, 3], f: [2, -3, 3]}
"""


FOUR_LEGS_MEET = """
legs: [Aa, Ab, Ac, Ad, Be, Cf]
points: {A: [0, 0, 0], B: [3, 0, 0], C: [0, 3, 0],
         a: [1, 0, 2], b: [0, 1, 2], c: [-1, 0, 2], d: [0, -1, 3], e: [2, 1, 2], f: [1, 2, 2]}
"""


def test_two_legs_in_one_line() -> None:
    found = gc.pose(parse_platform(PENCIL), nearest=False)
    assert found.verdict == "singular"
    assert found.dependence.legs == ("Aa", "Ab")
    assert found.dependence.within.name == "a single line"
    assert found.dependence.stress == (1, -1, 0, 0, 0, 0)


@pytest.mark.parametrize("angle", [90, -90, 270])
def test_turned_by_a_right_angle(angle: int) -> None:
    """Similar hexagons, one turned by 90°: singular wherever the platform is, found exactly."""
    octahedron = """
legs: [ab, af, cb, cd, ed, ef]
points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}
"""
    found = gc.pose(parse_platform(octahedron), f"0 0 0; euler zyx {angle} 0 0 deg", nearest=False)
    assert found.superbracket == 0
    assert found.verdict == "singular"
    near = gc.pose(parse_platform(octahedron), f"0 0 0; euler zyx {angle + 0.001} 0 0 deg", nearest=False)
    assert near.verdict == "close"
    assert near.superbracket != 0


def test_nearly_incident(robots: dict[str, Analysis]) -> None:
    found = gc.pose(robots["four-dof"], "0 0 -0.699999999", nearest=False)
    assert found.verdict == "close"
    assert found.causes == ("Nearly: the tetrahedron A1 B1 C1 S1 is flat: its four points lie in one plane.",)
    assert found.dependence is None
    assert [name for name, s in zip(found.rig.names, found.stress, strict=True) if abs(s) > 1e-3] == [
        "A1S1",
        "B1S1",
        "C1S1",
    ]
    below = gc.pose(robots["four-dof"], "0 0 -7/10", nearest=False)
    assert below.verdict == "singular"
    assert below.causes == ("The tetrahedron A1 B1 C1 S1 is flat: its four points lie in one plane.",)
    assert below.dependence.within.name == "a planar pencil"


def test_always_singular() -> None:
    found = gc.pose(parse_platform(FOUR_LEGS_MEET), nearest=False)
    assert found.verdict == "singular"
    assert found.causes[0].startswith("The robot is singular in every pose: four legs meet in the joint A")
    assert found.dependence.legs == ("Aa", "Ab", "Ac", "Ad")
    assert found.dependence.within.name.startswith("a bundle")


def test_singular_in_floats_only(robots: dict[str, Analysis]) -> None:
    """A singular pose rounded to floats is recognised, with the same motion as the exact one beside it."""
    a = robots["octahedral"]
    best = gc.pose(a, "0 0 0; euler zyx 10 20 30 deg").nearest[0]
    assert best.pose is not None
    found = gc.pose(a, best.pose, nearest=False)
    assert found.superbracket != 0
    assert found.verdict == "singular"
    assert not found.dependence.exact
    assert found.dependence.within.name == "a general linear complex"
    j = jacobian(found.rig.base, found.rig.ends(*from_poses([best.pose])))
    (motion,) = found.dependence.motions
    velocity = np.cross(motion.axis, j.arms[0] + j.centroid[0] - motion.point) + motion.pitch * np.array(motion.axis)
    assert np.abs((velocity * j.directions[0]).sum(axis=1)).max() <= 1e-9 * np.abs(velocity).max()


@pytest.mark.parametrize("kind", ["bundle", "pencil", "plane", "axis"])
@settings(max_examples=10, deadline=None)
@given(seed=seeds)
def test_floats_and_exact_arithmetic_agree_on_dependence(kind: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    places = {n: tuple(map(int, rng.integers(-4, 5, size=3))) for n in "ABCDEFabcdef"}
    match kind:
        case "bundle":
            places |= dict.fromkeys("BCD", places["A"])
        case "pencil":
            places |= dict.fromkeys("ABC", (0, 0, 0)) | {n: (*places[n][:2], 0) for n in "abc"}
        case "plane":
            places |= {n: (*places[n][:2], 0) for n in "ABCDabcd"}
        case "axis":
            places |= {n: (0, 0, places[n][2]) for n in "ABCDE"} | {"F": (0, 0, 5)}
    assume(all(places[a] != places[b] for a, b in LEGS))
    points = {n: (*map(F, p), F(1)) for n, p in places.items()}
    ends = np.array([[float(c) for c in places[b]] for _, b in LEGS])
    assume(np.linalg.matrix_rank(ends - ends[0], tol=1e-9) >= 2)
    base = np.array([[float(c) for c in places[a]] for a, _ in LEGS])
    j = jacobian(base, ends[None])
    names = [a + b for a, b in LEGS]
    assert superbracket_at(LEGS, points) == 0
    one, other = exact_dependence(LEGS, names, points, j.centroid[0]), dependence(j, names)
    assert one.legs == other.legs
    assert one.within == other.within
    assert one.all_legs == other.all_legs
    assert len(one.motions) == len(other.motions)
