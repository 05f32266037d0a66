"""Maps: curves and surfaces lie on the zero set, and none is missed."""

from __future__ import annotations

import io
import itertools
import json
import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from poses.platforms import PLATFORMS
from poses.small_maps import HUNT, TURNING, exact_value, ranges

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import LimitReached
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.poses.maps import surface
from gcrules.poses.maps.cells import CROSSED
from gcrules.poses.maps.maps import singular_map
from gcrules.poses.maps.mesh import Mesh
from gcrules.poses.maps.report import SingularMap
from gcrules.views.plots.map_meshes import glb, ply

F = Fraction
FLAT = {  # planes in which all joints lie in one plane and stay there: always singular
    "legs": "[Aa, Bb, Cc, Dd, Ee, Ff]",
    "points": "{A: [0, 0, 0], B: [4, 0, 0], C: [0, 5, 0], D: [3, 3, 0], E: [-1, 2, 0], F: [2, -2, 0],"
    " a: [1, 1, 0], b: [2, 1, 0], c: [1, 2, 0], d: [5, 5, 0], e: [-2, -2, 0], f: [3, -3, 0]}",
}


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


CURVED = [(n, None, "0 0 0; euler zyx 20 10 5 deg") for n in PLATFORMS] + TURNING


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


@pytest.mark.parametrize("name", PLATFORMS)
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
