"""Maps: coordinates, limits, slices, what is proved of cells, numbers."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from places import EXAMPLES
from poses.platforms import PLATFORMS
from poses.small_maps import TURNING, exact_value, ranges, rig_of

import gcrules as gc
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.description.limits import parse_limits
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.maps import tracing
from gcrules.poses.maps.axes import parse_axis, read_axes
from gcrules.poses.maps.bernstein import coefficients, corners, halves, tolerance
from gcrules.poses.maps.cells import CROSSED, FREE, UNDECIDED, certified
from gcrules.poses.maps.grid import Grid, grid
from gcrules.poses.maps.joining import joined
from gcrules.poses.maps.maps import singular_map
from gcrules.poses.maps.slices import SliceFactor, factors, middle, slice_polynomial
from gcrules.poses.maps.tracing import traced
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose

F = Fraction


def grid_of(a: Analysis, over: list[str], at: Any = None) -> Grid:
    moving = rig_of(a)
    return grid(moving, read_axes(over, moving.unit), at)


# --- coordinates and limits -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "kind", "place", "unit"),
    [
        ("x -2:2:5", "translation", 0, "mm"),
        ("z -2:2:5 mm", "translation", 2, "mm"),
        ("y -.5...5:3", "translation", 1, "mm"),
        ("ry -1/3:0.5:2 rad", "vector", 1, "rad"),
        ("rz -90:90:181°", "vector", 2, "deg"),
        ("zyx1 0:1e1:3 deg", "zyx", 0, "deg"),
        ("ZXZ3 0:10:3 degrees", "ZXZ", 2, "deg"),
        ("torsion 0:10:3 deg", "tilt", 2, "deg"),
    ],
    ids=str,
)
def test_coordinates(text: str, kind: str, place: int, unit: str) -> None:
    axis = parse_axis(text, "mm")
    assert (axis.kind, axis.place, axis.unit) == (kind, place, unit)
    assert len(axis.nodes) == axis.number
    assert axis.nodes[[0, -1]].tolist() == [float(axis.start), float(axis.stop)]
    assert parse_axis(axis.text, "mm") == axis


def test_turns_are_those_of_poses() -> None:
    """Roll, pitch and yaw in a map, and in the text of a pose, are one turn."""
    robot = EXAMPLES / "octahedral.yaml"
    for over, at in ((("roll", "yaw"), "roll=30deg, yaw=40deg"), (("pitch", "yaw"), "pitch=30deg, yaw=40deg")):
        found = gc.singular_map(robot, [f"{over[0]} 0:30:2 deg", f"{over[1]} 0:40:2 deg"])
        assert found.values("margin")[1, 1] == pytest.approx(gc.pose(robot, at).margin, abs=1e-6)


@pytest.mark.parametrize(
    ("over", "says"),
    [
        ([], "found 0"),
        (["x 0:1:2"], "found 1"),
        (["x 0:1:2", "y 0:1:2", "z 0:1:2", "rx 0:1:2 deg"], "found 4"),
        (["x 0:1:2", "x 0:2:2"], "x is given twice"),
        (["x 0:1:2", "u 0:1:2"], "'u' is not a coordinate"),
        (["x 0:1:2", "zzx1 0:1:2 deg"], "not a sequence"),
        (["x 0:1:2", "y"], "not a coordinate with its range"),
        (["x 0:1:2", "y 0:1"], "not a range"),
        (["x 0:1:2", "y 0:nan:3"], "expected a finite number"),
        (["x 0:1:2", "y -inf:0:3"], "expected a finite number"),
        (["x 0:1:2", "y 1:1:3"], "empty"),
        (["x 0:1:2", "y 1:0:3"], "reversed"),
        (["x 0:1:2", "y 0:1:1"], "1 node on an axis"),
        (["x 0:1:2", "y 0:1:0"], "0 nodes"),
        (["x 0:1:2", "y 0:1:2.5"], "not a number of nodes"),
        (["x 0:1:2", "y 0:1:-3"], "not a number of nodes"),
        (["x 0:1:2", "y 0:1:3 m"], "mixed units"),
        (["x 0:1:2", "y 0:1:3 deg"], "a unit of angles"),
        (["x 0:1:2", "rx 0:1:3"], "without a unit"),
        (["x 0:1:2", "rx 0:1:3 mm"], "without a unit"),
        (["rx 0:1:2 deg", "ry 0:1:3 rad"], "mixed units"),
        (["rx 0:1:2 deg", "zyx1 0:1:3 deg"], "several kinds of turns"),
        (["zyx1 0:1:2 deg", "zxz2 0:1:3 deg"], "several kinds of turns"),
    ],
    ids=str,
)
def test_coordinates_at_fault(over: list[str], says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_axes(over, "mm")


@pytest.mark.parametrize("over", [["x 0:1:200000", "y 0:1:2"], ["x 0:1:5000", "y 0:1:5000"]], ids=str)
def test_maps_that_are_too_large(robots: dict[str, Analysis], over: list[str]) -> None:
    with pytest.raises(LimitReached, match="more than"):
        singular_map(robots["octahedral"], over)
    with pytest.raises(LimitReached, match="not kept in memory"):
        singular_map(robots["octahedral"], ["x 0:1:300", "y 0:1:300", "z 0:1:300"])


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [
        ("leg lengths 1..3", (1, 1), (3, 3)),
        ("1..3 mm", (1, 1), (3, 3)),
        ("legs ..2.5", (0, 0), (2.5, 2.5)),
        ("ab 1..3, cd 2..", (1, 2), (3, math.inf)),
        ("legs 1..9, cd 1/2..3", (1, 0.5), (9, 3)),
    ],
    ids=str,
)
def test_limits(text: str, low: tuple[float, ...], high: tuple[float, ...]) -> None:
    found = parse_limits(text, ("ab", "cd"), "mm")
    assert (found.low, found.high) == (low, high)
    assert found.allow(np.array([[2.0, 2.5]])).tolist() == [True]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "no limits"),
        ("legs", "not a range of lengths"),
        ("ax 1..2", "not a leg"),
        ("legs 3..1", "reversed"),
        ("legs 1..1", "empty"),
        ("legs -1..2", "not negative"),
        ("legs ..", "without bounds"),
        ("legs 1..nan", "finite"),
        ("legs 1..2 m", "mixed units"),
    ],
    ids=str,
)
def test_limits_at_fault(text: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        parse_limits(text, ("ab", "cd"), "mm")


# --- slices ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "over",
    [
        ["x -1:1:3", "z -1:2:4"],
        ["rx -50:60:3 deg", "rz -1:20:4 deg"],
        ["rx -1:1:3 rad", "y -1:20:4"],
        ["zyx1 -50:60:3 deg", "zyx3 -90:90:5 deg"],
        ["ZXZ2 10:60:3 deg", "ZXZ3 -90:90:5 deg"],
        ["azimuth -50:60:3 deg", "tilt 0:60:4 deg"],
        ["torsion -50:60:3 deg", "tilt 0:60:4 deg", "x 0:1:2"],
    ],
    ids=str,
)
@pytest.mark.parametrize("at", [None, "1 2 3; euler xyz 10 20 30 deg"])
def test_poses_of_a_slice(robots: dict[str, Analysis], over: list[str], at: str | None) -> None:
    """Arrays and exact poses agree, and the coordinates of the pose of the rest lead back to it."""
    g = grid_of(robots["octahedral"], over, at)
    nodes = np.stack(np.meshgrid(*[np.arange(n) for n in g.shape], indexing="ij"), axis=-1).reshape(-1, len(g.axes))
    ends = g.ends(g.coordinates(nodes))
    for node, found in zip(nodes.tolist(), ends, strict=True):
        points = g.rig.exact(g.pose([a.start + k * a.step for a, k in zip(g.axes, node, strict=True)]))
        assert np.allclose([[float(c) for c in points[b][:3]] for _, b in g.rig.legs], found, atol=1e-9)
    home = g.ends(np.array([g.home]))[0]
    points = g.rig.exact(g.at)
    assert np.allclose([[float(c) for c in points[b][:3]] for _, b in g.rig.legs], home, atol=1e-4)


def test_angles_stay_as_they_were_typed(robots: dict[str, Analysis]) -> None:
    g = grid_of(robots["octahedral"], ["zyx1 0:1:2 deg", "x 0:1:2"], "0 0 0; euler zyx 10 120 200 deg")
    assert g.angles == (10, 120, 200)
    h = grid_of(robots["octahedral"], ["zyx1 0:1:2 deg", "x 0:1:2"], parse_pose("0 0 0; euler zyx 10 120 200 deg"))
    assert np.allclose(g.ends(np.array([g.home])), h.ends(np.array([h.home])))
    backwards, named = "0 0 0; euler xyz 200 120 10 deg", "yaw=10deg, pitch=120deg, roll=200deg"
    for same in ("0 0 0; euler ZYX 10 120 200 deg", backwards, named):
        k = grid_of(robots["octahedral"], ["yaw 0:1:2 deg", "x 0:1:2"], same)
        assert k.angles == (10, 120, 200)
        assert k.pose([F(10), F(0)]).quaternion == parse_pose(same).quaternion
    vector = grid_of(robots["octahedral"], ["rx 0:1:2 deg", "x 0:1:2"], "rx=10deg, rz=20deg")
    assert vector.angles == (10, 0, 20)
    locked = grid_of(robots["octahedral"], ["xyz2 0:1:2 deg", "x 0:1:2"], "0 0 0; euler zyx 20 90 0 deg")
    assert len(locked.notes) <= 1


fractions = st.integers(-6, 6).map(lambda c: F(c, 5))
turns = st.tuples(*[st.integers(-3, 3).map(F)] * 4).filter(any)


@settings(max_examples=20, deadline=None)
@given(
    name=st.sampled_from(PLATFORMS), shift=st.tuples(*[fractions] * 3), turn=turns, place=st.tuples(*[fractions] * 3)
)
@pytest.mark.parametrize("names", ["x z", "y x", "z x y"])
def test_the_polynomial_of_a_slice(
    robots: dict[str, Analysis], names: str, name: str, shift: Any, turn: Any, place: Any
) -> None:
    g = grid_of(robots[name], [f"{n} -1:2:7" for n in names.split()], Pose(shift, turn))
    p = slice_polynomial(g)
    at = place[: len(g.axes)]
    value = sum((c * math.prod(w**e for w, e in zip(at, k, strict=True)) for k, c in p.items()), F(0))
    assert value == exact_value(g, at)
    if p:
        w = tuple((c - a.start) / a.step - m for c, a, m in zip(at, g.axes, middle(g.shape), strict=True))
        product = math.prod(f.exact(w) ** f.multiplicity for f in factors(g))
        assert (product == 0) == (value == 0)


def test_a_polynomial_beside_poses_with_legs_of_no_length() -> None:
    """It does not depend on the pose from which it is found: four legs have no length in the first four tried."""
    ends = [(1, 0, 0), (0, 1, 2), (3, -1, 1), (-2, 2, 5), (4, 1, -3), (0, -5, 1)]
    starts = [(x + 143 * n + 1, y + 91 * n, z + 77 * n) for n, (x, y, z) in enumerate(ends[:4])]
    starts += [(1001, 3, 8), (-7, 200, 31)]
    points = [
        f"{'ABCDEF'[n]}: {list(a)}, {'abcdef'[n]}: {list(b)}" for n, (a, b) in enumerate(zip(starts, ends, strict=True))
    ]
    robot = analyze_legs(parse_platform(f"legs: [Aa, Bb, Cc, Dd, Ee, Ff]\npoints: {{{', '.join(points)}}}"))
    g = grid_of(robot, ["x -1:2:7", "z -1:2:7"], "1 0 0")
    value = sum(c * F(2) ** k[0] * F(-3) ** k[1] for k, c in slice_polynomial(g).items())
    assert value == exact_value(g, (2, -3)) != 0


cubics = st.dictionaries(
    st.tuples(*[st.integers(0, 3)] * 3).filter(lambda e: sum(e) <= 3), st.integers(-9, 9).filter(bool), min_size=1
)


@settings(max_examples=40, deadline=None)
@given(
    p=cubics,
    corner=st.tuples(*[st.integers(-20, 20)] * 3),
    inside=st.tuples(*[st.fractions(0, 1, max_denominator=9)] * 3),
    axis=st.integers(0, 2),
)
def test_bernstein_coefficients(p: Any, corner: Any, inside: Any, axis: int) -> None:
    f = SliceFactor({k: F(c) for k, c in p.items()}, 1, PolynomialForm((), ()))
    scale = float(max(map(abs, f.polynomial.values())))
    error = tolerance(f.tensor, (21, 21, 21))
    b = coefficients(f.tensor, np.array([corner]))
    assert abs(float(f.exact(corner)) / scale - b[0, 0, 0, 0]) <= error
    value = float(f.exact(tuple(c + t for c, t in zip(corner, inside, strict=True)))) / scale
    assert b.min() - error <= value <= b.max() + error
    half = [F(c) for c in corner]
    half[axis] += F(1, 2)
    assert abs(float(f.exact(tuple(half))) / scale - corners(halves(b, axis)[1])[0, 0]) <= error


# --- what is proved -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("names", ["x z", "y x", "x y z"])
@pytest.mark.parametrize("name", PLATFORMS)
def test_free_cells_hold_no_singular_pose(robots: dict[str, Analysis], name: str, names: str) -> None:
    """At exact random poses of free cells the superbracket has the sign that it has at the cell's corner, never 0."""
    m = singular_map(robots[name], ranges(robots[name], names, 9), "0 0 0; euler zyx 20 10 5 deg", measure="value")
    rng = np.random.default_rng(1)
    status = m.values("cell_status")
    free = np.argwhere(status == FREE)
    assert len(free) > status.size / 2
    assert (status != UNDECIDED).all()
    for cell in free[rng.integers(0, len(free), 25)].tolist():
        places = [
            [a.start + (k + F(int(r), 64)) * a.step for k, a, r in zip(cell, m.grid.axes, row, strict=True)]
            for row in rng.integers(0, 65, (3, len(cell)))
        ]
        signs = {np.sign(float(exact_value(m.grid, p))) for p in places}
        assert len(signs) == 1
        assert 0 not in signs
    by_sign = m.values("superbracket")
    for axis in range(by_sign.ndim):  # a change of sign along an edge is in no free cell
        change = np.argwhere(np.diff(np.sign(by_sign), axis=axis) != 0)
        inside = change[(change < status.shape).all(axis=1)]
        assert (status[tuple(inside.T)] == CROSSED).all()


def factor_of(p: dict[tuple[int, int], Any]) -> SliceFactor:
    return SliceFactor({k: F(c) for k, c in p.items()}, 1, PolynomialForm((), ()))


CIRCLE = {(2, 0): 1, (0, 2): 1, (1, 0): F(-3, 5), (0, 1): F(-4, 5), (0, 0): F(1, 4) - F(1, 100)}  # radius 0.1, one cell
POINT = {(2, 0): 1, (0, 2): 1, (1, 0): F(-2, 3), (0, 1): F(-2, 3), (0, 0): F(2, 9)}  # (1/3, 1/3) only
NEARLY = {**CIRCLE, (0, 0): F(1, 4) + F(1, 10**6)}  # no zero, but nearly one
NODE = {(0, 2): 1, (3, 0): -1, (2, 0): -4, (1, 0): F(0)}  # crosses itself at the node 0, 0: a loop and two branches
LINE = {(1, 0): 1}  # along a line of the grid
DIAGONAL = {(1, 0): 1, (0, 1): -1}  # through nodes


@pytest.mark.parametrize(
    ("polynomial", "crossed", "undecided", "curves"),
    [
        (CIRCLE, 1, 0, [True]),
        (POINT, 0, 1, None),
        (NEARLY, 0, 0, []),
        (NODE, None, 0, None),
        (LINE, 16, 0, [False]),
        (DIAGONAL, 22, 0, [False]),
    ],
    ids=["circle", "point", "nearly", "node", "line", "diagonal"],
)
def test_shapes_between_nodes(polynomial: Any, crossed: int | None, undecided: int, curves: Any) -> None:
    """Over nine nodes each way: what is smaller than a cell is found, what runs through nodes is met once."""
    f = factor_of({k: c for k, c in polynomial.items() if c})
    status = certified([f], (-4, -4), (8, 8), (4, 4))
    if crossed is not None:
        assert (status == CROSSED).sum() == crossed
    assert (status == UNDECIDED).sum() == undecided
    arcs = traced(f, (9, 9), (4, 4))
    lines = [tracing.polished(f, line, (4, 4)) for line in joined(arcs)]
    if curves is not None:
        assert [bool((line[0] == line[-1]).all()) for line in lines] == curves
    for line in lines:
        for u, v in line.tolist():
            assert abs(float(f.exact((F(u) - 4, F(v) - 4)))) < 1e-6 * (1 + 8 * len(f.polynomial))


def test_a_curve_that_crosses_itself() -> None:
    """y² = x³ + 4x²: a loop between −4 and 0 and two branches; every place of the loop is there."""
    places = np.concatenate(joined(traced(factor_of({k: c for k, c in NODE.items() if c}), (9, 9), (4, 4)))) - 4
    for x in np.linspace(-3.9, 1.2, 60):
        y = math.sqrt(x**3 + 4 * x**2)
        if y < 4:
            for sign in (-1, 1):
                assert np.hypot(places[:, 0] - x, places[:, 1] - sign * y).min() < 0.6


@pytest.mark.parametrize(("name", "over", "at"), TURNING, ids=str)
def test_regular_cells(robots: dict[str, Analysis], name: str, over: list[str], at: Any) -> None:
    """The superbracket has one sign at random places of each cell that is proved to be free."""
    m = singular_map(robots[name], over, at)
    status = m.values("cell_status")
    free = np.argwhere(status == FREE)
    assert len(free) > 0
    rng = np.random.default_rng(2)
    sign = np.sign(m.values("superbracket"))
    for _ in range(40):
        places = free + rng.random(free.shape)
        assert (np.sign(m.task.value(places)) == sign[tuple(free.T)]).all()
    assert "by bounds of the legs' coordinates" in m.guarantee


@pytest.mark.parametrize(
    ("name", "over", "least"),
    [
        ("platform-6-3", ["x -1:1:11", "z -1:1:11", "rz -60:60:11 deg"], 700),
        ("platform-6-6", ["x -1:1:11", "z -1:1:11", "rz -60:60:11 deg"], 700),
        ("octahedral", ["x -300:300:11", "z -300:300:11", "rz -180:180:11 deg"], 700),
        ("platform-6-6", ["x -1:1:7", "rx -60:60:9 deg", "ry -60:60:9 deg"], 130),
    ],
    ids=str,
)
def test_most_cells_of_three_coordinates_are_proved(
    robots: dict[str, Analysis], name: str, over: list[str], least: int
) -> None:
    """Free cells with a sign of their own: Jacobians at random places within, and at all corners, have it too."""
    m = singular_map(robots[name], over)
    free = np.argwhere(m.values("cell_status") == FREE)
    assert len(free) >= least
    corners = np.array(list(np.ndindex(2, 2, 2)), dtype=float)
    rng = np.random.default_rng(4)
    sign = np.sign(m.task.value(free + 0.5))
    for shift in [*corners, *rng.random((20, 3))]:
        assert (np.sign(m.task.value(free + shift)) == sign).all()


# --- numbers --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "over", "at"), [*TURNING, ("platform-6-3", ["x -1:1:5", "y -1:1:6", "z 0:1:4"], None)], ids=str
)
def test_values_are_those_of_a_pose(robots: dict[str, Analysis], name: str, over: list[str], at: Any) -> None:
    m = singular_map(robots[name], over, at, limits="leg lengths 0.2..500")
    assert isinstance(m.grid, Grid)
    rng = np.random.default_rng(3)
    for _ in range(6):
        node = tuple(int(rng.integers(n)) for n in m.grid.shape)
        pose = m.grid.pose([a.start + k * a.step for a, k in zip(m.grid.axes, node, strict=True)])
        one = gc.pose(robots[name], pose, nearest=False)
        assert m.values("superbracket")[node] == pytest.approx(float(one.superbracket), rel=1e-9, abs=1e-12)
        assert m.values("margin")[node] == pytest.approx(one.margin, rel=1e-6, abs=1e-7)
        points = m.grid.rig.exact(pose)
        lengths = [math.dist(*(map(float, points[n][:3]) for n in leg)) for leg in m.grid.rig.legs]
        assert m.values("leg_length")[node].tolist() == pytest.approx(lengths, rel=1e-6)
        assert m.values("allowed")[node] == all(0.2 <= length <= 500 for length in lengths)
    assert m.summary.poses == m.grid.size
    assert sum(m.summary.cells) == m.values("cell_status").size
    inside = m.values("allowed").astype(bool)
    if inside.any():
        assert m.summary.margin == pytest.approx(float(m.values("margin")[inside].min()))


def test_a_leg_of_no_length(robots: dict[str, Analysis]) -> None:
    m = singular_map(robots["octahedral"], ["x -300:0:3", "y -400:0:3"], "0 0 -350", about="origin")  # b comes to a
    assert m.values("margin")[1, 1] == m.values("superbracket")[1, 1] == 0
    assert np.isfinite(m.values("margin")).all()
