"""Maps of robots of joints: what is said to be proved, against solving every pose by itself and the condition."""

from __future__ import annotations

import copy
import json
import pickle
from functools import cache
from math import prod
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from places import DATA, ROOT

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.solve import Solution, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.limbs import lattice as lattice_module
from gcrules.poses.limbs.factors import factors
from gcrules.poses.limbs.straight import number_of_steps
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED
from gcrules.poses.maps.limb_task import LimbsTask, limbs_task
from gcrules.poses.maps.maps import singular_map
from gcrules.poses.maps.surface import sheet
from gcrules.screws.threshold import margin_of

CASES = {
    "3-rpr": ("x -0.4:0.4:13", "yaw -20:60:33 deg"),
    "3-rps": ("roll -40:40:13 deg", "pitch -50:50:13 deg"),
    "3-rrr": ("x -0.2:0.2:9", "y -0.2:0.2:9"),
    "delta": ("x -1:1:9", "z -0.4:0.6:9"),
    "3-upu": ("x -0.3:0.3:9", "z -0.2:0.3:9"),
    "orthoglide": ("x -0.3:0.3:9", "y -0.3:0.3:9"),
    "tricept": ("x -0.3:0.3:9", "y -0.3:0.3:9"),
    "3-prs": ("roll -30:30:9 deg", "z -0.2:0.2:9"),
    "exechon": ("x -0.2:0.2:9", "y -0.2:0.2:9"),
    "6-rus": ("x -0.2:0.2:9", "yaw -30:30:9 deg"),
}
DRIVEN = {"3-rpr": ("q1 -0.3:0.3:9", "q2 -0.3:0.3:9"), "3-rrr": ("q1 -30:20:9 deg", "q2 -30:30:9 deg")}


@cache
def robot(name: str) -> Limbs:
    found = mechanism(name)
    assert isinstance(found, Limbs)
    return found


@cache
def task(name: str, driven: bool = False) -> LimbsTask:
    return limbs_task(robot(name), (DRIVEN if driven else CASES)[name])


@cache
def arrays(name: str, driven: bool = False) -> Any:
    return task(name, driven).compute(0)


def by_itself(name: str, place: Any, driven: bool = False) -> Solution | None:
    """The pose at a place counted in nodes, solved from home alone; None where its branch is not proved."""
    t = task(name, driven)
    origin, steps = t.grid.linear
    try:
        found = solve(t.linkage, Target(t.grid.names, origin + np.array(place) @ steps, driven))
    except InputError:
        return None
    return found if found.doubt is None else None


def sign(name: str, solution: Solution) -> float:
    """That of the condition's factors, which is none of the determinant's frames."""
    live = [f.value for f in factors(robot(name).analysis, solution.configuration.values) if f.live]
    return float(np.sign(prod(live))) if live else 0.0


REFUSED = {"3-upu-snu": "is not proved"}  # singular at home
PAIRS = [(n, False) for n in CASES] + [(n, True) for n in DRIVEN]


@pytest.mark.parametrize(("name", "driven"), PAIRS)
def test_nodes_are_the_poses_solved_by_themselves(name: str, driven: bool) -> None:
    """Margins and amounts of actuators agree, and the determinant's sign with that of the condition but for one
    choice."""
    t, found = task(name, driven), arrays(name, driven)
    rng = np.random.default_rng(4)
    relative = set()
    compared = 0
    for node in rng.choice(np.argwhere(found["allowed"] == 1), size=8).tolist():
        alone = by_itself(name, node, driven)
        if alone is None:
            continue
        compared += 1
        c, k = alone.configuration, tuple(node)
        assert found["margin"][k] == pytest.approx(margin(t.linkage, c).sigma, abs=1e-6)
        amounts = [c.joint_values[a.place][a.coordinate] for a in t.linkage.actuators]
        assert found["actuator"][k] == pytest.approx(amounts, abs=1e-5)
        if found["margin"][k] > 1e-4 and sign(name, alone):
            relative.add(sign(name, alone) * found["sign"][k])
    assert compared >= 4
    assert len(relative) <= 1


@pytest.mark.parametrize(("name", "driven"), PAIRS)
def test_nothing_is_singular_in_free_cells(name: str, driven: bool) -> None:
    """At random places in them the pose solved by itself from home has a margin, and the sign of the corners."""
    t, found = task(name, driven), arrays(name, driven)
    cells = np.argwhere(found["cell_status"] == FREE)
    rng = np.random.default_rng(5)
    for cell in cells[rng.permutation(len(cells))[:12]].tolist():
        corners = found["sign"][cell[0] : cell[0] + 2, cell[1] : cell[1] + 2]
        assert len(set(corners.ravel().tolist())) == 1
        place = np.array(cell) + rng.uniform(size=2)
        alone = by_itself(name, place, driven)
        if alone is not None:
            sigma = margin(t.linkage, alone.configuration).sigma
            assert sigma > 1e-6
            assert t.value(place[None])[0] == pytest.approx(sigma * corners[0, 0], abs=1e-6)


@pytest.mark.parametrize("name", CASES)
def test_crossed_cells_hold_a_singular_pose(name: str) -> None:
    """The least margin on the way between two corners of different signs, by fine steps from cell to cell."""
    t, found = task(name), arrays(name)
    for i, j in np.argwhere(found["cell_status"] == CROSSED)[:3].tolist():
        corners = [(i + a, j + b) for a in (0, 1) for b in (0, 1)]
        plus = next(c for c in corners if found["sign"][c] > 0)
        minus = next(c for c in corners if found["sign"][c] < 0)
        low, high = 0.0, 1.0
        for _ in range(40):
            middle = (low + high) / 2
            value = float(t.value((np.array(plus) + middle * (np.array(minus) - np.array(plus)))[None])[0])
            low, high = (middle, high) if value > 0 else (low, middle)
        place = np.array(plus) + low * (np.array(minus) - np.array(plus))
        assert abs(float(t.value(place[None])[0])) < 1e-6


def test_legs_that_are_joints_against_the_exact_polynomial() -> None:
    """The octahedral platform by both roads: where one proves cells free, the other does not see them crossed."""
    near = ["x -1:1:9", "z -3.6:0.4:9"]
    exact, found = singular_map("octahedral", near), limbs_task(robot("octahedral"), near).compute(0)
    assert exact.factors is not None
    status = exact.values("cell_status")
    assert not ((found["cell_status"] == FREE) & (status == CROSSED)).any()
    assert not ((found["cell_status"] == CROSSED) & (status == FREE)).any()
    assert (found["cell_status"] == FREE).mean() >= 0.5
    assert found["margin"] == pytest.approx(exact.values("margin"), abs=1e-5)


def test_a_curve_goes_through_a_singular_node() -> None:
    found = singular_map("3-rpr", ["x 0.5:1.75:6", "y -0.5:0.5:5"])  # singular at the node x = 1.5, y = 0
    (curve,) = found.curves
    assert np.abs(curve.points - [1.5, 0]).max(axis=1).min() < 1e-3
    steps = np.linalg.norm(np.diff(curve.points, axis=0), axis=1)
    assert steps.max() < 0.6  # no gap of cells


def test_curves_lie_on_the_zeros_of_the_condition() -> None:
    m = gc.singular_map(robot("3-rpr").analysis, CASES["3-rpr"])
    assert len(m.curves) == 1
    t = task("3-rpr")
    for point in m.curves[0].points[::4]:
        place = t.grid.places(point[None])[0]
        alone = by_itself("3-rpr", place)
        assert alone is not None
        assert min(abs(f.value) for f in factors(robot("3-rpr").analysis, alone.configuration.values)) < 1e-4


@pytest.mark.parametrize(
    "name", ["3-upu-snu", "4-ruu-opposite", "5-rpur", "agile-eye", "3-prr-singular", "4-upu-singular"]
)
def test_robots_of_files(name: str) -> None:
    """Also those that have no condition: a map, or the reason why there is none."""
    path = DATA / "moved" / f"{name}.yaml"
    found = mechanism(str(path) if path.exists() else name)
    assert isinstance(found, Limbs)
    turning = name == "agile-eye"
    over = ["roll -20:20:5 deg", "pitch -20:20:5 deg"] if turning else ["x -0.1:0.1:5", "y -0.1:0.1:5"]
    if name in REFUSED:
        with pytest.raises(InputError, match=REFUSED[name]) as fault:
            gc.singular_map(found.analysis, over)
        assert fault.value.hint
        return
    m = gc.singular_map(found.analysis, over)
    assert sum(m.summary.cells) + m.summary.outside == 16
    assert m.values("margin").shape == (5, 5)


def test_what_is_reached_and_what_limits_allow() -> None:
    m = gc.singular_map("3-rrr", DRIVEN["3-rrr"])
    assert m.summary.outside > 0
    assert np.isnan(m.values("margin")).any()
    assert (m.values("allowed")[np.isnan(m.values("margin"))] == 0).all()
    narrow = gc.singular_map("3-rrr", CASES["3-rrr"], limits="q1 -5..5 deg, q2 -10.. deg")
    amounts = np.degrees(narrow.values("actuator"))
    inside = (np.abs(amounts[..., 0]) <= 5) & (amounts[..., 1] >= -10)
    assert (narrow.values("allowed").astype(bool) == inside).all()
    assert narrow.limits is not None
    assert narrow.limits.text == "-5 ≤ q1 ≤ 5 deg, -10 ≤ q2 deg"
    assert 0 < narrow.summary.allowed < narrow.summary.poses


def test_other_coordinates() -> None:
    plain, given = (gc.singular_map("delta", ["x -0.2:0.2:3", "y -0.2:0.2:3"], at) for at in (None, "z=0.3"))
    assert (plain.grid.rest, given.grid.rest) == ("z = 0", "z = 0.3")
    assert plain.summary.margin != given.summary.margin
    as_mapping = gc.singular_map("delta", ["x -0.2:0.2:3", "y -0.2:0.2:3"], {"z": 0.3})
    assert as_mapping.to_json() == given.to_json()
    three = gc.singular_map("delta", ["x -0.2:0.2:3", "y -0.2:0.2:3", "z -0.1:0.1:3"])
    assert three.values("margin")[:, :, 1] == pytest.approx(plain.values("margin"), abs=1e-6)
    assert three.summary.cells == (8, 0, 0)


def test_a_surface(tmp_path: Path) -> None:
    pytest.importorskip("skimage")
    m = gc.singular_map("3-rpr", ["x -0.3:0.3:5", "y -0.3:0.3:5", "yaw -20:60:17 deg"])
    assert len(m.mesh.faces) > 20
    t = m.task
    assert np.abs(t.value((m.mesh.vertices - [-0.3, -0.3, -20]) / [0.15, 0.15, 5])).max() < 1e-3
    for name in ("a.ply", "a.svg", "a.json"):
        m.save(str(tmp_path / name))
    assert json.loads((tmp_path / "a.json").read_text())["robot"] == "3-rpr"


def test_a_surface_ends_where_the_robot_does_not_get() -> None:
    """A ball's, of which some nodes are not known: no triangle has one at its cell's corners."""
    pytest.importorskip("skimage")
    nodes = np.stack(np.meshgrid(*(np.arange(9.0),) * 3, indexing="ij"), axis=-1)
    unknown = np.abs(nodes.sum(axis=-1) - 12) > 4

    def value(places: Any) -> Any:
        return np.linalg.norm(places - 4.1, axis=-1) - 3.3

    whole, part = (
        sheet(value, lambda first, last, lost=lost: np.where(lost, np.nan, value(nodes))[first:last], (9, 9, 9))
        for lost in (np.zeros_like(unknown), unknown)
    )
    assert 200 < len(part[2]) < len(whole[2])
    assert np.abs(value(part[0])).max() < 1e-6
    assert part[2].max() == len(part[0]) - 1
    low = np.floor(part[0][part[2]].mean(axis=1)).astype(int)
    assert not any(unknown[tuple((low + corner).T)].any() for corner in np.ndindex(2, 2, 2))


def test_results_are_values(tmp_path: Path) -> None:
    m = gc.singular_map("3-rpr", CASES["3-rpr"])
    for other in (pickle.loads(pickle.dumps(m)), copy.deepcopy(m)):
        assert other == m
        assert hash(other) == hash(m)
        assert other.to_json() == m.to_json()
    json.dumps(m.to_json())
    assert "one configuration near those of the nodes" in " ".join(m.text().split())
    assert "latex" not in m.latex().lower()


def test_data_sets() -> None:
    pytest.importorskip("xarray")
    found = gc.singular_map("3-rpr", CASES["3-rpr"]).to_xarray()
    assert found.actuator.dims == ("x", "yaw", "driven")
    assert set(np.unique(found.sign)) == {-1, 1}
    assert found.margin.attrs["threshold"] == pytest.approx(margin_of(np.radians(0.5)))


@pytest.mark.parametrize(
    ("name", "over", "at", "more", "message"),
    [
        ("delta", ["x -1:1:3", "yaw -1:1:3 deg"], None, {}, "yaw says nothing about the pose of delta"),
        ("delta", ["x -1:1:3", "rz -1:1:3 deg"], None, {}, "not mapped by rz"),
        ("delta", ["x -1:1:3", "q1 -1:1:3 deg"], None, {}, "others are coordinates of the pose"),
        ("delta", ["q1 -1:1:3", "q2 -1:1:3"], None, {}, "angle without a unit"),
        ("delta", ["q1 -1:1:3 deg", "q7 -1:1:3 deg"], None, {}, "no actuator q7"),
        ("delta", ["x -1:1:3", "x -1:1:3"], None, {}, "twice"),
        ("delta", ["x -1:1:3", "y -1:1:3"], "x=0.1", {}, "an axis of the map, and is given as well"),
        ("delta", ["x -1:1:3", "y -1:1:3"], "z=0.1, yaw=0.2deg", {}, "4 coordinates are named"),
        ("delta", ["x -1:1:3", "y -1:1:3"], "0 0 1", {}, "gives no value to a name"),
        ("delta", ["x 50:60:3", "y 0:1:3"], None, {}, "was not followed|cannot move"),
        ("3-rpr", ["x -1:1:3", "yaw 0:400:3 deg"], None, {}, "round more than once"),
        ("delta", ["x -1:1:3", "y -1:1:3"], None, {"measure": "value"}, "no superbracket of its legs"),
        ("delta", ["x -1:1:3", "y -1:1:3"], None, {"limits": "q1 -1..1"}, "angle without a unit"),
        ("delta", ["x -1:1:3", "y -1:1:3"], None, {"limits": "q9 -1..1 deg"}, "not an actuator"),
        ("delta", ["x -1:1:3", "y -1:1:3"], None, {"limits": "q1 2..1 deg"}, "reversed"),
        ("3-rps", ["x -1:1:3", "y -1:1:3"], None, {}, "says nothing about"),
        ("delta", ["x -1:1:2000", "y -1:1:2000"], None, {}, "more than 1,000,000"),
        ("octahedral", ["q1 -1:1:3", "q2 -1:1:3"], None, {}, "no actuator q1"),
    ],
)
def test_faults(name: str, over: list[str], at: str | None, more: dict[str, str], message: str) -> None:
    with pytest.raises((InputError, gc.LimitReached), match=message) as fault:
        gc.singular_map(name, over, at, **more)
    assert fault.value.hint


def test_only_angles_end_after_a_turn(tmp_path: Path) -> None:
    file = tmp_path / "robot.yaml"
    file.write_text(f"units: mm\n{(ROOT / 'plugins' / '3-rpr' / 'robot.yaml').read_text('utf-8')}", "utf-8")
    task = limbs_task(Limbs.of(gc.load(file)), ["x -20:20:3 mm", "yaw -180:180:3 deg"], "y=0.1")
    assert task.grid.shape == (3, 3)
    assert task.grid.rest == "y = 0.1 mm"


def test_actuators_that_are_given_bear_their_unit() -> None:
    task = limbs_task(robot("3-rrr"), ["q1 -2:2:3 deg", "q2 -10:10:3 deg"], "q3=5deg")
    assert task.grid.rest == "q3 = 5°"


def test_the_command(tmp_path: Path) -> None:
    path = tmp_path / "m.svg"
    done = CliRunner().invoke(
        cli, ["map", "3-rpr", "--over", "x -0.4:0.4:9", "--over", "yaw -20:60:9 deg", "-o", str(path), "--json"]
    )
    assert done.exit_code == 0, done.stderr
    found = json.loads(done.stdout)
    assert found["robot"] == "3-rpr"
    assert found["at"] == {"y": 0.0}
    assert sum(found["summary"]["cells"].values()) == 64
    assert path.read_text(encoding="utf-8").startswith("<?xml")
    assert not list(tmp_path.glob("*.part"))


def test_statuses_are_all_there() -> None:
    found = {int(s) for name in CASES for s in np.unique(arrays(name)["cell_status"])}
    found |= {int(s) for name in DRIVEN for s in np.unique(arrays(name, True)["cell_status"])}
    assert found == {FREE, CROSSED, UNDECIDED, OUTSIDE}


def test_only_steps_that_are_too_long_for_their_proof_are_halved(monkeypatch: pytest.MonkeyPatch) -> None:
    """All steps are proved at once; what fails is halved by itself, and what fails to the last is not reached."""
    t = limbs_task(robot("delta"), ("x -2:2:5", "y -2:2:5"))
    lattice, node = t._start
    before, place = lattice.places(np.array([node])), lattice.places(np.array([node])) + np.array([[0.0, 1.0]])
    parts = int(number_of_steps(lattice.course, lattice.steps[1:]).max())
    tried: list[list[float]] = []
    wrong = 1

    def follow(m: Any, target: Any, steps: Any) -> Any:
        tried.append(np.abs(steps.grown).max(axis=1).tolist())
        return np.arange(len(steps.here)) < len(steps.here) - (len(tried) <= wrong)  # the last one is not proved

    monkeypatch.setattr(lattice_module, "follow_branch", follow)
    found = lattice.solved(np.zeros((1, len(lattice.units))), before, place, halvings=3)
    whole = float(np.abs(lattice.steps[1]).max()) / parts
    assert parts > 1
    assert [len(steps) for steps in tried] == [parts, 2]
    assert tried[0] + tried[1] == pytest.approx([whole] * parts + [whole / 2] * 2)
    wrong, tried = 9, []
    assert np.isnan(lattice.solved(np.zeros((1, len(lattice.units))), before, place, halvings=3)).all()
    assert [steps[0] / whole for steps in tried] == pytest.approx([1, 0.5, 0.25, 0.125])
    alone = solve(t.linkage, Target(t.grid.names, (lattice.origin + place @ lattice.steps)[0]))
    assert lattice.at(found).platform[0] == pytest.approx(alone.configuration.platform, abs=1e-9)


def test_home_beside_a_singularity_of_a_limb_is_left() -> None:
    """A leg of this robot is almost stretched at home, so that only short steps from there are proved; what is reached
    by them has the margins that it has by itself.
    """
    found = gc.singular_map("3-rrr", over=["x -0.3:0.3:9", "y -0.3:0.3:9"])
    margins = found.values("margin")
    reached = np.argwhere(np.isfinite(margins))
    assert len(reached) > 30
    for i, j in reached[:: len(reached) // 8]:
        x, y = (-0.3 + 0.6 * int(k) / 8 for k in (i, j))
        alone = gc.pose("3-rrr", f"x={x!r}, y={y!r}, yaw=0deg", nearest=False)
        assert float(margins[i, j]) == pytest.approx(alone.margin, rel=1e-6)
    free, crossed, undecided = found.summary.cells
    assert (free, crossed) == (0, 0)
    assert (
        found.guarantee
        == f"No cell is proved free: {undecided} undecided, {found.summary.outside} not followed to a corner"
    )
    assert "0 crossed" not in gc.singular_map("delta", over=["x -2:2:9", "y -2:2:9"], at="z=0").guarantee
