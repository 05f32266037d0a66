"""Maps: curves and surfaces lie on the zero set, cells that are called free are free, runs resume, files read back."""

from __future__ import annotations

import errno
import io
import itertools
import json
import math
import os
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from click.testing import CliRunner
from commands import assert_refused
from hypothesis import given, settings
from hypothesis import strategies as st

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import GcrulesError, InputError, LimitReached
from gcrules.mechanisms.description.platform_file import load_platform, parse_platform
from gcrules.mechanisms.moving_platform import Rig, rig
from gcrules.mechanisms.platform_analysis import analyze
from gcrules.poses.compiling.compiled import compiled
from gcrules.poses.maps import maps, report, store, surface, tracing, values
from gcrules.poses.maps.axes import parse_axis, read_axes
from gcrules.poses.maps.bernstein import coefficients, corners, halves, tolerance
from gcrules.poses.maps.cells import CROSSED, FREE, UNDECIDED, certified
from gcrules.poses.maps.grid import Grid, grid
from gcrules.poses.maps.joining import joined
from gcrules.poses.maps.limits import parse_limits
from gcrules.poses.maps.maps import singular_map
from gcrules.poses.maps.mesh import Mesh
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.maps.slices import Factor, factors, middle, slice_polynomial
from gcrules.poses.maps.tracing import traced
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose
from gcrules.views.plots import map_files as outputs
from gcrules.views.plots.map_meshes import glb, ply

F = Fraction
EXAMPLES = ("octahedral", "platform-6-3", "platform-6-4", "platform-6-6", "four-dof")
FLAT = {  # planes in which all joints lie in one plane and stay there: always singular
    "legs": "[Aa, Bb, Cc, Dd, Ee, Ff]",
    "points": "{A: [0, 0, 0], B: [4, 0, 0], C: [0, 5, 0], D: [3, 3, 0], E: [-1, 2, 0], F: [2, -2, 0],"
    " a: [1, 1, 0], b: [2, 1, 0], c: [1, 2, 0], d: [5, 5, 0], e: [-2, -2, 0], f: [3, -3, 0]}",
}


@pytest.fixture(scope="module")
def robots(root: Any) -> dict[str, Analysis]:
    return {n: analyze(load_platform(root / "examples" / f"{n}.yaml")) for n in (*EXAMPLES, "octahedral-singular")}


@pytest.fixture(scope="module", autouse=True)
def compiled_once() -> Iterator[None]:
    """Conditions are compiled once for each robot and centre, which is what most small maps wait for."""
    known: dict[Any, Any] = {}

    def made(a: Analysis, *, about: Any) -> Any:
        key = a.structure.legs, a.platform and a.platform.points, about
        return known.setdefault(key, known.get(key) or compiled(a, about=about, engine="numpy"))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(maps, "compiled", made)
        yield


def rig_of(a: Analysis) -> Rig:
    assert a.platform is not None
    return rig(a.structure, a.platform)


def grid_of(a: Analysis, over: list[str], at: Any = None) -> Grid:
    moving = rig_of(a)
    return grid(moving, read_axes(over, moving.unit), at)


def exact_value(g: Grid, coordinates: Any) -> Fraction:
    try:
        return superbracket_at(g.rig.structure.legs, g.rig.exact(g.pose([F(c) for c in coordinates])))
    except InputError:  # a leg of no length
        return F(0)


def ranges(a: Analysis, names: str, number: int, size: float = 1.2) -> list[str]:
    far = F(str(round(rig_of(a).size * size, 2)))
    return [f"{n} {-far}:{far}:{number + k}" for k, n in enumerate(names.split())]


# --- coordinates and limits -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "kind", "place", "unit"),
    [
        ("x -2:2:5", "translation", 0, "mm"),
        ("z -2:2:5 mm", "translation", 2, "mm"),
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


@pytest.mark.parametrize(
    ("over", "says"),
    [
        ([], "found 0"),
        (["x 0:1:2"], "found 1"),
        (["x 0:1:2", "y 0:1:2", "z 0:1:2", "rx 0:1:2 deg"], "found 4"),
        (["x 0:1:2", "x 0:2:2"], "x is given twice"),
        (["x 0:1:2", "u 0:1:2"], "'u' is no coordinate"),
        (["x 0:1:2", "zzx1 0:1:2 deg"], "no sequence"),
        (["x 0:1:2", "y"], "no coordinate with its range"),
        (["x 0:1:2", "y 0:1"], "no range"),
        (["x 0:1:2", "y 0:nan:3"], "expected a finite number"),
        (["x 0:1:2", "y -inf:0:3"], "expected a finite number"),
        (["x 0:1:2", "y 1:1:3"], "empty"),
        (["x 0:1:2", "y 1:0:3"], "reversed"),
        (["x 0:1:2", "y 0:1:1"], "1 node on an axis"),
        (["x 0:1:2", "y 0:1:0"], "0 nodes"),
        (["x 0:1:2", "y 0:1:2.5"], "no number of nodes"),
        (["x 0:1:2", "y 0:1:-3"], "no number of nodes"),
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
        ("legs", "no range of lengths"),
        ("ax 1..2", "no leg"),
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
    assert g.rest == (10, 120, 200)
    h = grid_of(robots["octahedral"], ["zyx1 0:1:2 deg", "x 0:1:2"], parse_pose("0 0 0; euler zyx 10 120 200 deg"))
    assert np.allclose(g.ends(np.array([g.home])), h.ends(np.array([h.home])))
    locked = grid_of(robots["octahedral"], ["xyz2 0:1:2 deg", "x 0:1:2"], "0 0 0; euler zyx 20 90 0 deg")
    assert len(locked.notes) <= 1


fractions = st.integers(-6, 6).map(lambda c: F(c, 5))
turns = st.tuples(*[st.integers(-3, 3).map(F)] * 4).filter(any)


@settings(max_examples=20, deadline=None)
@given(name=st.sampled_from(EXAMPLES), shift=st.tuples(*[fractions] * 3), turn=turns, place=st.tuples(*[fractions] * 3))
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
        w = tuple((c - a.start) / a.step - m for c, a, m in zip(at, g.axes, middle(g), strict=True))
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
    robot = analyze(parse_platform(f"legs: [Aa, Bb, Cc, Dd, Ee, Ff]\npoints: {{{', '.join(points)}}}"))
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
    f = Factor({k: F(c) for k, c in p.items()}, 1)
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
@pytest.mark.parametrize("name", EXAMPLES)
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


def factor_of(p: dict[tuple[int, int], Any]) -> Factor:
    return Factor({k: F(c) for k, c in p.items()}, 1)


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


TURNING = [
    ("octahedral", ["rx -60:60:21 deg", "rz -120:120:23 deg"], "0 0 -100"),
    ("octahedral", ["x -300:300:15", "zyx1 -100:100:17 deg"], None),
    ("platform-6-6", ["azimuth -180:180:19 deg", "tilt 1:60:17 deg"], "0.1 0 -0.2"),
    ("platform-6-4", ["XYZ2 -1:1:17 rad", "z -1/2:1/2:11"], "0 0 0; euler XYZ 0.1 0 0.2 rad"),
]


@pytest.mark.parametrize(("name", "over", "at"), TURNING, ids=str)
def test_cells_that_closeness_guards(robots: dict[str, Analysis], name: str, over: list[str], at: Any) -> None:
    m = singular_map(robots[name], over, at)
    status = m.values("cell_status")
    free = np.argwhere(status == FREE)
    assert len(free) > 0
    rng = np.random.default_rng(2)
    sign = np.sign(m.values("superbracket"))
    for _ in range(40):
        places = free + rng.random(free.shape)
        assert (np.sign(m.task.value(places)) == sign[tuple(free.T)]).all()
    assert "closeness" in m.guarantee


# --- numbers --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "over", "at"), [*TURNING, ("platform-6-3", ["x -1:1:5", "y -1:1:6", "z 0:1:4"], None)], ids=str
)
def test_values_are_those_of_a_pose(robots: dict[str, Analysis], name: str, over: list[str], at: Any) -> None:
    m = singular_map(robots[name], over, at, limits="leg lengths 0.2..500")
    rng = np.random.default_rng(3)
    for _ in range(6):
        node = tuple(int(rng.integers(n)) for n in m.grid.shape)
        pose = m.grid.pose([a.start + k * a.step for a, k in zip(m.grid.axes, node, strict=True)])
        one = gc.pose(robots[name], pose, nearest=False)
        assert m.values("superbracket")[node] == pytest.approx(float(one.superbracket), rel=1e-9, abs=1e-12)
        assert m.values("closeness")[node] == pytest.approx(one.closeness, rel=1e-6, abs=1e-7)
        points = m.grid.rig.exact(pose)
        lengths = [math.dist(*(map(float, points[n][:3]) for n in leg)) for leg in m.grid.rig.legs]
        assert m.values("leg_length")[node].tolist() == pytest.approx(lengths, rel=1e-6)
        assert m.values("allowed")[node] == all(0.2 <= length <= 500 for length in lengths)
    assert m.summary.poses == m.grid.size
    assert sum(m.summary.cells) == m.values("cell_status").size
    inside = m.values("allowed").astype(bool)
    if inside.any():
        assert m.summary.closeness == pytest.approx(float(m.values("closeness")[inside].min()))


def test_a_leg_of_no_length(robots: dict[str, Analysis]) -> None:
    m = singular_map(robots["octahedral"], ["x -300:0:3", "y -400:0:3"], "0 0 -350", about="origin")  # b comes to a
    assert m.values("closeness")[1, 1] == m.values("superbracket")[1, 1] == 0
    assert np.isfinite(m.values("closeness")).all()


# --- curves ---------------------------------------------------------------------------------------------------------


def slope(m: SingularMap, place: Any) -> float:
    """How fast the superbracket changes per node, about."""
    steps = [np.eye(len(place))[k] * 1e-3 for k in range(len(place))]
    at = np.array(place)
    return float(
        np.linalg.norm(
            [(m.task.value(np.array([at + s]))[0] - m.task.value(np.array([at - s]))[0]) / 2e-3 for s in steps]
        )
    )


CURVED = [(n, None, "0 0 0; euler zyx 20 10 5 deg") for n in EXAMPLES] + TURNING


@pytest.mark.parametrize(("name", "over", "at"), CURVED, ids=str)
def test_points_of_curves_are_singular(robots: dict[str, Analysis], name: str, over: Any, at: Any) -> None:
    m = singular_map(robots[name], over or ranges(robots[name], "x z", 30), at, measure="value")
    rng = np.random.default_rng(4)
    assert m.curves
    points = np.concatenate([c.points for c in m.curves])
    steps = np.array([float(a.step) for a in m.grid.axes])
    starts = np.array([float(a.start) for a in m.grid.axes])
    crossed = 0
    for point in points[rng.integers(0, len(points), 20)]:
        place = (point - starts) / steps
        size = slope(m, place)
        assert abs(float(exact_value(m.grid, point))) <= 1e-6 * size + 1e-12  # a millionth of a cell away
        around = [place + 0.02 * np.array([math.cos(t), math.sin(t)]) for t in np.linspace(0, 2 * math.pi, 12)]
        crossed += len(set(np.sign(m.task.value(np.array(around))))) > 1
    assert crossed == 20


@pytest.mark.parametrize("name", EXAMPLES)
def test_no_change_of_sign_without_a_curve(robots: dict[str, Analysis], name: str) -> None:
    """Each edge of the grid with a change of sign has a point of a curve on it."""
    m = singular_map(robots[name], ranges(robots[name], "x y", 12), "0 0 -0.11; euler zyx 20 10 5 deg", measure="value")
    points = np.concatenate([np.zeros((0, 2)), *(c.points for c in m.curves)])
    places = (points - [float(a.start) for a in m.grid.axes]) / [float(a.step) for a in m.grid.axes]
    sign = m.values("superbracket") > 0
    for axis in range(2):
        for node in np.argwhere(np.diff(sign, axis=axis)):
            offset = places - node
            on = (np.abs(offset[:, 1 - axis]) < 1e-6) & (offset[:, axis] > -1e-6) & (offset[:, axis] < 1 + 1e-6)
            assert on.any()


HUNT = """
title: symmetric octahedral platform
units: m
legs: [ab, af, cb, cd, ed, ef]
points:
  a: [1, 0, 0]
  c: [-0.5, 0.8660254037844386, 0]
  e: [-0.5, -0.8660254037844386, 0]
  b: [0.25, 0.4330127018922193, 1]
  d: [-0.5, 0, 1]
  f: [0.25, -0.4330127018922193, 1]
"""


def test_a_quarter_turn_is_singular_everywhere() -> None:
    """The well-known singularity of the symmetric platform: ±90° about its axis, whatever the translation."""
    m = singular_map(parse_platform(HUNT), ["x -0.7:0.8:13", "rz -120:120:50 deg"], "0.1 0.2 0.3", measure="value")
    for quarter in (-90, 90):
        (line,) = [c.points for c in m.curves if np.abs(c.points[:, 1] - quarter).max() < 1e-6]
        assert (line[:, 0].min(), line[:, 0].max()) == pytest.approx((-0.7, 0.8))


def test_slices_that_are_singular_throughout(robots: dict[str, Analysis]) -> None:
    m = singular_map(robots["octahedral"], ["x -9:9:4", "y -9:9:5"], "0 0 -350")
    assert m.everywhere
    assert (m.values("cell_status") == CROSSED).all()
    assert "every pose is singular" in m.text()
    flat = parse_platform("\n".join(f"{k}: {v}" for k, v in FLAT.items()))
    assert singular_map(flat, ["x -1:1:4", "y -1:1:5", "rz 0:30:3 deg"]).values("superbracket").max() == 0


# --- surfaces -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "over"),
    [
        ("octahedral", ["x -300:300:12", "y -300:300:13", "z -500:100:14"]),
        ("platform-6-6", ["x -2:2:14", "y -2:2:13", "z -2:2:12"]),
        ("octahedral", ["x -300:300:9", "z -300:200:9", "zyx1 -120:120:12 deg"]),
    ],
    ids=str,
)
def test_vertices_of_surfaces_are_singular(robots: dict[str, Analysis], name: str, over: list[str]) -> None:
    pytest.importorskip("skimage")
    m = singular_map(robots[name], over, limits="leg lengths 0.5..400")
    mesh = m.mesh
    assert len(mesh.faces) > 100
    assert mesh.accurate.all()
    assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1)
    rng = np.random.default_rng(5)
    starts, steps = (np.array([float(getattr(a, k)) for a in m.grid.axes]) for k in ("start", "step"))
    places = (mesh.vertices - starts) / steps
    slopes = [slope(m, p) for p in places[rng.integers(0, len(places), 60)]]
    for n in rng.integers(0, len(places), 25):
        size = max(slope(m, places[n]), 1e-3 * float(np.median(slopes)))
        assert abs(float(exact_value(m.grid, mesh.vertices[n]))) <= 1e-6 * size
    assert (mesh.allowed == m.allows(mesh.vertices)).all()


def test_slabs_make_one_surface(robots: dict[str, Analysis], monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("skimage")
    over = ["x -2:2:14", "y -2:2:13", "z -2:2:12"]
    one = singular_map(robots["platform-6-6"], over, measure="value").mesh
    monkeypatch.setattr(surface, "_SLAB", 3 * 13 * 12)
    other = singular_map(robots["platform-6-6"], over, measure="value").mesh
    assert len(one.vertices) == len(other.vertices)
    assert len(one.faces) == len(other.faces)
    assert np.allclose(np.sort(one.vertices, axis=0), np.sort(other.vertices, axis=0))
    monkeypatch.setattr(surface, "MAX_TRIANGLES", 10)
    with pytest.raises(LimitReached, match="triangles"):
        singular_map(robots["platform-6-6"], over, measure="value").surface()


def test_files_of_surfaces_know_the_axes(robots: dict[str, Analysis]) -> None:
    pytest.importorskip("skimage")
    trimesh = pytest.importorskip("trimesh")
    spans = {"x": "x -300:300:12", "y": "y -200:300:9", "z": "z -400:50:10"}
    expected = None
    for order in itertools.permutations("xyz"):
        mesh = singular_map(robots["octahedral"], [spans[n] for n in order], measure="value").mesh
        found = trimesh.load(io.BytesIO(ply(mesh)), file_type="ply", process=False)
        bounds = [found.bounds, trimesh.load(io.BytesIO(glb(mesh)), file_type="glb").bounds]
        expected = expected or bounds
        assert np.allclose(bounds[0], expected[0])
        assert np.allclose(bounds[1], expected[1])
        normals = np.stack([mesh.normals[:, mesh.names.index(n)] for n in "xyz"], axis=1)
        assert (found.face_normals * normals[found.faces[:, 0]]).sum(axis=1).mean() > 0.8


ALWAYS = """
legs: [au, bv, cw, dx, ey, fz]
points: {a: [4, 0, 0], b: [2, 6, 0], c: [-4, 4, 0], d: [-6, -2, 0], e: [0, -6, 0], f: [6, -4, 0],
         u: [2, 0, 5], v: [1, 3, 5], w: [-2, 2, 5], x: [-3, -1, 5], y: [0, -3, 5], z: [3, -2, 5]}
"""


@pytest.mark.parametrize(
    ("over", "everywhere"),
    [
        (["rx -40:40:7 deg", "ry -40:40:7 deg"], True),  # no part of the quaternion along z, which is a factor
        (["azimuth -40:40:7 deg", "tilt 0:40:7 deg"], True),
        (["rx -1:1:4 rad", "ry -1:1:4 rad", "x 0:1:3"], True),
        (["rx -40:40:7 deg", "rz 10:40:7 deg"], False),
    ],
    ids=lambda v: " ".join(v) if isinstance(v, list) else str(v),
)
def test_turns_that_are_singular_throughout(over: list[str], everywhere: bool) -> None:
    """Similar hexagons at one height: rounding gives the superbracket signs, of which no curves are made."""
    m = singular_map(parse_platform(ALWAYS), over)
    assert m.everywhere == everywhere
    if everywhere:
        assert not m.curves
        assert m.summary.cells[0] == m.summary.cells[2] == 0
        assert m.guarantee.startswith("every pose is singular")
        assert len(over) == 2 or len(m.mesh.faces) == 0


def test_meshes_are_read_back(robots: dict[str, Analysis]) -> None:
    trimesh = pytest.importorskip("trimesh")
    m = singular_map(robots["octahedral"], ["x -300:300:12", "y -300:300:13", "z -500:100:14"], measure="value")
    mesh = m.mesh
    assert mesh.sheets == 2
    found = trimesh.load(io.BytesIO(ply(mesh)), file_type="ply", process=False)
    assert np.array_equal(found.vertices, mesh.vertices)
    assert np.array_equal(found.faces, mesh.faces)
    assert found.is_winding_consistent
    assert (found.face_normals * mesh.normals[mesh.faces[:, 0]]).sum(axis=1).mean() > 0.9
    scene = trimesh.load(io.BytesIO(glb(mesh)), file_type="glb")
    assert len(scene.geometry) == 2
    low, high = scene.bounds  # metres, y up
    assert np.allclose(
        low[[0, 2, 1]] * [1, -1, 1] * 1000,
        [mesh.vertices[:, 0].min(), mesh.vertices[:, 1].max(), mesh.vertices[:, 2].min()],
        atol=0.1,
    )
    assert high[1] * 1000 == pytest.approx(mesh.vertices[:, 2].max(), abs=0.1)
    data = glb(mesh)
    assert int.from_bytes(data[8:12], "little") == len(data)
    described = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
    assert described["scenes"][0]["extras"] == {"axes": ["x", "y", "z"], "units": ["mm", "mm", "mm"]}
    assert described["asset"]["extras"]["unit_of_length"] == "mm"


def test_an_empty_surface(robots: dict[str, Analysis]) -> None:
    pytest.importorskip("skimage")
    m = singular_map(robots["octahedral"], ["x 0:1:3", "y 0:1:3", "z 0:1:3"], measure="value")
    assert isinstance(m.mesh, Mesh)
    assert len(m.mesh.faces) == 0
    assert ply(m.mesh).startswith(b"ply")
    assert glb(m.mesh).startswith(b"glTF")


# --- files ----------------------------------------------------------------------------------------------------------

SMALL = ["x -300:300:15", "z -500:100:16"]


def test_data_are_read_back(robots: dict[str, Analysis], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    xarray = pytest.importorskip("xarray")
    monkeypatch.setattr(values, "_POSES", 40)
    m = singular_map(robots["octahedral"], SMALL, limits="leg lengths 100..500")
    assert m.task.number > 3
    path = tmp_path / "map.nc"
    m.save(str(path))
    with xarray.open_dataset(path, engine="h5netcdf", decode_timedelta=False) as found:
        assert found.identical(m.to_xarray())
        assert found.x.units == "mm"
        assert found.superbracket.units == "mm9"
        assert found.closeness.dims == ("x", "z")
        assert found.leg_length.sel(leg="af").shape == (15, 16)
        assert found.cell_status.attrs["flag_meanings"] == "free crossed undecided"
        assert found.attrs["Conventions"].startswith("CF")
        assert set(found.data_vars) >= set(m.arrays)
        assert float(found.closeness.sel(x=0, z=-20, method="nearest")) == m.values("closeness")[7, 12]
        assert len(found.curve_x) == sum(len(c.points) for c in m.curves)
    turned = singular_map(robots["octahedral"], ["rx -9:9:3 deg", "ry -9:9:4 deg", "z 0:1:2"]).to_xarray()
    assert turned.rx.units == "degree"


@pytest.mark.parametrize(
    ("over", "options"),
    [
        (SMALL, {"limits": "leg lengths 100..500"}),
        (SMALL, {"measure": "value"}),
        (["rx -60:60:9 deg", "rz -100:100:9 deg"], {}),
        (["x -3:3:5", "y -3:3:4"], {"at": "0 0 -350"}),
        (["x -300:300:7", "y -300:300:7", "z -500:100:7"], {"limits": "leg lengths 100..500"}),
    ],
    ids=str,
)
def test_pictures(
    robots: dict[str, Analysis], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, over: list[str], options: Any
) -> None:
    map_surface = pytest.importorskip("gcrules.views.plots.map_surface")
    pytest.importorskip("skimage")
    monkeypatch.setattr(map_surface, "_PIXELS", 150)
    names = [str(tmp_path / f"map.{kind}") for kind in ("svg", "png")]
    m = singular_map(robots["octahedral"], over, **options)
    m.save(*names)
    ElementTree.parse(names[0])
    assert Path(names[1]).read_bytes().startswith(b"\x89PNG")
    again = str(tmp_path / "again.svg")
    m.save(again)
    assert Path(again).read_bytes() == Path(names[0]).read_bytes()
    assert {p.name for p in tmp_path.iterdir()} == {"map.svg", "map.png", "again.svg"}


def test_the_json_object(robots: dict[str, Analysis]) -> None:
    m = singular_map(robots["octahedral"], SMALL, limits="ab 100..500")
    found = json.loads(json.dumps(m.to_json(), allow_nan=False))
    assert found["factors"][0] == {"degree": 1, "multiplicity": 1, "polynomial": "z + 350"}
    assert found["axes"][1] == {"name": "z", "unit": "mm", "start": -500, "stop": 100, "number": 16}
    assert found["summary"]["cells"]["free"] == int((m.values("cell_status") == FREE).sum())
    assert len(found["curves"]) == len(m.curves)
    assert "σ" in m.text(unicode=True)
    assert m.text().isascii()
    assert m._repr_html_().startswith("<pre>")
    pytest.importorskip("matplotlib")
    ElementTree.fromstring(m._repr_svg_() or "")


# --- long runs ------------------------------------------------------------------------------------------------------


@pytest.fixture
def counted(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The chunks that are computed; they are small."""
    monkeypatch.setattr(values, "_POSES", 40)
    found: list[int] = []
    compute = values.Task.compute

    def count(self: values.Task, chunk: int) -> Any:
        if -1 in found and len(found) > 3:
            found.remove(-1)
            raise KeyboardInterrupt
        found.append(chunk)
        return compute(self, chunk)

    monkeypatch.setattr(values.Task, "compute", count)
    return found


def test_an_interrupted_run_goes_on(robots: dict[str, Analysis], tmp_path: Path, counted: list[int]) -> None:
    work = tmp_path / "map.part"
    counted.append(-1)
    with pytest.raises(KeyboardInterrupt):
        singular_map(robots["octahedral"], SMALL, work=work)
    assert sorted(p.name for p in work.iterdir()) == [
        *(f"chunk-{n:06d}.npz" for n in range(3)),
        "lock",
        "manifest.json",
    ]
    (work / "chunk-000001.npz").write_bytes((work / "chunk-000001.npz").read_bytes()[:-50])  # damaged
    counted.clear()
    m = singular_map(robots["octahedral"], SMALL, work=work)
    assert counted.pop() in (0, 2)  # one of those that were kept, looked at again
    assert counted == [1, *range(3, m.task.number)]
    direct = singular_map(robots["octahedral"], SMALL)
    for name in m.arrays:
        assert np.array_equal(m.values(name), direct.values(name))
    assert m.summary == direct.summary
    m.store.close()
    assert not work.exists()


@pytest.mark.parametrize(
    "change", [{"at": "1 0 0"}, {"measure": "value"}, {"limits": "legs 1.."}, {"about": "origin"}], ids=str
)
def test_a_changed_map_is_noticed(robots: dict[str, Analysis], tmp_path: Path, counted: list[int], change: Any) -> None:
    work = tmp_path / "map.part"
    singular_map(robots["octahedral"], SMALL, work=work)
    with pytest.raises(InputError, match="of another map") as fault:
        singular_map(robots["octahedral"], SMALL, work=work, **change)
    assert "--restart" in fault.value.render()
    singular_map(robots["octahedral"], SMALL, work=work, restart=True, **change).store.close()
    assert not work.exists()


def test_two_runs_at_a_time(robots: dict[str, Analysis], tmp_path: Path, counted: list[int]) -> None:
    pytest.importorskip("fcntl")
    work = tmp_path / "map.part"
    m = singular_map(robots["octahedral"], SMALL, work=work)
    lock = f"import fcntl; f = open({str(work / 'lock')!r}, 'ab'); fcntl.lockf(f, fcntl.LOCK_EX | fcntl.LOCK_NB)"
    other = subprocess.run([sys.executable, "-c", lock], capture_output=True, text=True, check=False)
    assert "BlockingIOError" in other.stderr
    m.store.close()
    holder = subprocess.Popen(
        [sys.executable, "-c", f"import os; os.mkdir({str(work)!r}); {lock}; print(1, flush=True); input()"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
    )
    with holder:
        assert holder.stdout is not None
        holder.stdout.readline()
        with pytest.raises(InputError, match="another run is at work"):
            singular_map(robots["octahedral"], SMALL, work=work)
        holder.kill()
    singular_map(robots["octahedral"], SMALL, work=work).store.close()  # a killed run holds nothing
    assert not work.exists()


@pytest.mark.parametrize("seed", range(3))
def test_damaged_chunks_are_computed_again(
    robots: dict[str, Analysis], tmp_path: Path, counted: list[int], seed: int
) -> None:
    m = singular_map(robots["octahedral"], SMALL, work=tmp_path / "map.part")
    chunk = tmp_path / "map.part" / "chunk-000000.npz"
    whole, expected = chunk.read_bytes(), m.store.get(0)
    assert expected is not None
    rng = np.random.default_rng(seed)
    for _ in range(60):
        data = bytearray(whole)
        at = int(rng.integers(len(data)))
        data[at : at + int(rng.integers(1, 9))] = bytes(rng.integers(0, 256, int(rng.integers(1, 9))).tolist())
        chunk.write_bytes(data[: int(rng.integers(len(data)))] if rng.random() < 0.3 else data)
        found = m.store.get(0)
        assert found is None or all(np.array_equal(found[n], expected[n]) for n in m.arrays)
    m.store.close()


def test_other_files_are_left_alone(robots: dict[str, Analysis], tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").touch()
    with pytest.raises(InputError, match="holds other files"):
        singular_map(robots["octahedral"], SMALL, work=tmp_path, restart=True)
    with pytest.raises(InputError, match="a file is in the way"):
        singular_map(robots["octahedral"], SMALL, work=tmp_path / "thesis.tex")
    assert [p.name for p in tmp_path.iterdir()] == ["thesis.tex"]


def run(*arguments: str, text: str | None = None) -> Any:
    return CliRunner().invoke(cli, ["map", *arguments], input=text)


@pytest.fixture(scope="module")
def robot(root: Any) -> str:
    return str(root / "examples" / "octahedral.yaml")


OVER = ("--over", SMALL[0], "--over", SMALL[1])
SOLID = ("--over", "x 0:9:5", "--over", "y 0:9:5", "--over", "z -400:-300:6")


def test_an_interrupted_command(robot: str, tmp_path: Path, counted: list[int]) -> None:
    pytest.importorskip("h5netcdf")
    out = tmp_path / "map.nc"
    counted.append(-1)
    done = run(robot, *OVER, "-o", str(out))
    assert done.exit_code == 130
    assert "map.nc.part: run the same command again" in done.stderr
    assert [p.name for p in tmp_path.iterdir()] == ["map.nc.part"]
    done = run(robot, *OVER, "-o", str(out), "--limits", "legs 1..")
    assert done.exit_code == 2
    assert "--restart" in done.stderr
    counted.clear()
    assert run(robot, *OVER, "-o", str(out)).exit_code == 0
    assert counted[0] == 3
    assert [p.name for p in tmp_path.iterdir()] == ["map.nc"]


def full(*_: Any, **__: Any) -> Any:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.parametrize("where", ["chunk", "file", "replace"])
def test_a_full_disk(
    robot: str, tmp_path: Path, counted: list[int], monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    pytest.importorskip("h5netcdf")
    if where == "chunk":
        monkeypatch.setattr(store.np, "savez", full)
    elif where == "file":
        monkeypatch.setattr(outputs, "netcdf", full)
    else:
        full_at = "gcrules.core.files.os.replace"
        monkeypatch.setattr(full_at, lambda a, b: full() if str(b).endswith(".nc") else os.rename(a, b))
    done = run(robot, *OVER, "-o", str(tmp_path / "map.nc"))
    assert done.exit_code == 2
    assert "No space left on device" in done.stderr
    assert "make room" in done.stderr
    assert {p.name for p in tmp_path.iterdir()} == {"map.nc.part"}
    assert not [p for p in (tmp_path / "map.nc.part").iterdir() if p.name.startswith(".")]
    monkeypatch.undo()
    monkeypatch.setattr(values, "_POSES", 40)
    assert run(robot, *OVER, "-o", str(tmp_path / "map.nc")).exit_code == 0
    assert {p.name for p in tmp_path.iterdir()} == {"map.nc"}


def test_room_is_looked_for_first(tmp_path: Path) -> None:
    class Left:
        free = 1000

    with pytest.raises(InputError, match="are needed"):
        store.check_room(str(tmp_path / "map.nc"), 10**9, free=lambda _: Left)


LARGE = """
import sys
from click.testing import CliRunner
from gcrules.apps.cli import cli
done = CliRunner().invoke(cli, ["map", *sys.argv[1:]])
status = open("/proc/self/status").read()  # unlike getrusage, it knows nothing of the process that started this one
print(done.exit_code, status.split("VmHWM:")[1].split()[0])
"""


def test_memory_stays_small(root: Path, tmp_path: Path) -> None:
    """Two million poses, in seventeen chunks."""
    if not Path("/proc/self/status").exists():
        pytest.skip("needs /proc")
    pytest.importorskip("h5netcdf")
    out = tmp_path / "map.nc"
    over = ("--over", "x -2:2:200", "--over", "y -2:2:200", "--over", "z -0.2:0.3:50")
    words = [sys.executable, "-c", LARGE, str(root / "examples" / "platform-6-6.yaml"), *over, "--measure", "value"]
    done = subprocess.run([*words, "-o", str(out)], capture_output=True, text=True, check=True)
    code, most = map(int, done.stdout.split())
    assert code == 0
    assert out.stat().st_size > 16_000_000
    assert most < 600_000  # kilobytes, most of them libraries


# --- the command ----------------------------------------------------------------------------------------------------


def test_the_command(robot: str, tmp_path: Path) -> None:
    done = run(robot, *OVER, "--ascii")
    assert done.exit_code == 0, done.output
    assert done.stdout.isascii()
    assert "1. degree 1: z + 350 = 0" in done.stdout
    with open(robot, encoding="utf-8") as file:
        assert run("-", *OVER, "--ascii", text=file.read()).stdout == done.stdout
    answer = json.loads(run(robot, *OVER, "--json", "-o", str(tmp_path / "map.json")).stdout)
    assert answer == json.loads((tmp_path / "map.json").read_text())


@pytest.mark.parametrize(
    ("arguments", "code", "says"),
    [
        ((), 2, "two or three coordinates"),
        (OVER[:2], 2, "found 1"),
        ((*OVER, "--over", SMALL[0]), 2, "given twice"),
        ((*OVER, "-o", "map.xyz"), 2, "outputs end in .nc"),
        ((*OVER, "-o", "map"), 2, "outputs end in .nc"),
        ((*OVER, "-o", "map.ply"), 2, "three coordinates"),
        ((*OVER, "-o", "no/such/dir/map.json"), 2, "no such directory"),
        ((*OVER, "-o", "map.json", "-o", "map.json"), 2, "are one file"),
        ((*OVER, "--restart"), 2, "--restart without -o"),
        ((*OVER, "--at", "0 0 1 m"), 2, "mixed units"),
        ((*OVER, "--at", "0 0 nan"), 2, "--at:1:1"),
        ((*OVER, "--about", "middle"), 2, "no centre"),
        ((*OVER, "--limits", "legs 3..1"), 2, "--limits:1"),
        ((*OVER, "--threshold", "2 mm"), 2, "the threshold is an angle"),
        ((*OVER, "--measure", "beauty"), 2, "not one of"),
        (("--over", "x 0:1:2", "--over", "y 0:0:2"), 2, "--over:1:1"),
        (("--over", "x 0:1e30:2", "--over", "y 0:1:2"), 2, "times the robot's size away"),
        (("--over", "x 0:1:90000", "--over", "y 0:1:90000"), 3, "coarser grid"),
    ],
    ids=str,
)
def test_the_command_tells_faults(robot: str, arguments: tuple[str, ...], code: int, says: str) -> None:
    assert_refused(run(robot, *arguments), code, says)


@pytest.mark.parametrize(
    ("module", "suffix", "over"),
    [
        ("skimage", ".ply", SOLID),
        ("trimesh", ".glb", SOLID),
        ("skimage", ".png", SOLID),
        ("matplotlib", ".svg", OVER),
        ("h5netcdf", ".nc", OVER),
    ],
    ids=str,
)
def test_missing_libraries(
    robot: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, module: str, suffix: str, over: tuple[str, ...]
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    done = run(robot, *over, "-o", str(tmp_path / f"map{suffix}"))
    assert done.exit_code == 2
    assert 'pip install "gcrules[maps]"' in done.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("limbs: []\n", "there are no limbs"),
        (
            HUNT.replace("[0.25, 0.4330127018922193, 1]", "[-0.5, 1, 1]").replace(
                "[0.25, -0.4330127018922193, 1]", "[-0.5, 2, 1]"
            ),
            "degenerate robot",
        ),
    ],
    ids=["limbs", "on one line"],
)
def test_robots_that_are_refused(text: str, says: str) -> None:
    done = run("-", *OVER, text=text)
    assert done.exit_code == 2
    assert says in done.stderr


def test_python_tells_faults(robots: dict[str, Analysis], monkeypatch: pytest.MonkeyPatch) -> None:
    a = robots["octahedral"]
    for options, says in (
        ({"measure": "beauty"}, "no measure"),
        ({"threshold": 2}, "has no unit"),
        ({"at": [[0, 0, 0], [1, 1, 1]]}, "around one pose"),
        ({"about": (1, 2)}, "the centre has 3 numbers, found 2"),
    ):
        with pytest.raises(InputError, match=says):
            gc.singular_map(a, SMALL, **options)
    with pytest.raises(InputError, match="legs alone have no coordinates"):
        gc.singular_map(gc.analyze("ab af cb cd ed ef"), SMALL)
    m = gc.singular_map(a, SMALL)
    with pytest.raises(InputError, match="has no 'beauty'"):
        m.values("beauty")
    with pytest.raises(GcrulesError, match="no surface"):
        _ = m.mesh
    monkeypatch.setattr(report, "MAX_IN_MEMORY", 10)
    with pytest.raises(LimitReached, match="too large to be in memory"):
        m.values("closeness")
