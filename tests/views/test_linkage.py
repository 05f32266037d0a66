"""A robot of joints in the viewer, beside the engine: where its names are, its margin and verdict."""

from __future__ import annotations

import json
import math
import subprocess
from typing import Any

import numpy as np
import pytest
from places import ROOT

import gcrules as gc
from gcrules.mechanisms.analyze import analyze
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.limbs import Limbs
from gcrules.views.report.robot_report import robot_report, robot_scene
from gcrules.views.robots.limb_views import limb_views
from gcrules.views.robots.linkage_view import linkage_view

VIEWER = ROOT / "gcrules" / "views" / "static" / "viewer.js"
PROGRAM = """
const viewer = new Function(require("fs").readFileSync(process.argv[1], "utf8") + "; return GcrulesViewer")();
const { linkage: m, scene, wanted } = JSON.parse(require("fs").readFileSync(0, "utf8"));
let at = viewer.home(m);
const found = wanted.map((goal) => {
  const next = viewer.driveTo(m, at, goal);
  at = next.at;
  return { reached: next.reached, driven: viewer.driven(m, at), places: viewer.named(m, at),
    ...viewer.limbNumbers(m, at, ""), drawn: scene && viewer.moved(scene, m, at) };
});
console.log(JSON.stringify(found));
"""
ROBOTS: dict[str, Any] = {
    "delta": [[0, 0, 0], [0.1, 0.2, -0.1], [0.3, -0.2, 0.2], [-0.1, 0, 0.1]],
    "3-rps": [[0, 0, 0], [0.1, 0.2, -0.1], [0.3, 0.2, 0.1]],
    "orthoglide": [[0, 0, 0], [0.1, 0.05, -0.1], [-0.2, 0.1, 0.1]],
    "3-upu": [[0, 0, 0], [0.1, 0.2, -0.1], [0.2, 0.1, 0.2]],
    "6-rus": [[0] * 6, [0.02, 0.01, -0.02, 0.01, 0, 0.02]],
    "gough-stewart": [[0] * 6, [0.1, 0, 0.05, -0.1, 0.1, 0]],
    "3-rpr": [[0, 0, 0], [0.1, 0.2, -0.1]],
    "3-ups-s": [[0, 0, 0], [0.1, -0.05, 0.1]],
    "4-rpr": [[0, 0, 0], [0.1, 0.2, -0.05]],
    "h4": [[0, 0, 0, 0], [0.1, 0.05, -0.05, 0.1]],
    "par4": [[0, 0, 0, 0], [0.1, 0.05, -0.05, 0.1]],
    "gantry-tau": [[0, 0, 0], [0.1, 0.05, -0.05]],
    "8-cables": [[0] * 6, [0.1, 0, 0.05, -0.1, 0.1, 0]],
}


def viewed(data: dict[str, Any]) -> Any:
    done = subprocess.run(
        ["node", "-e", PROGRAM, str(VIEWER)],
        input=json.dumps(data),
        capture_output=True,
        text=True,
        check=True,
        timeout=120,
    )
    return json.loads(done.stdout)


@pytest.mark.needs("node")
@pytest.mark.parametrize("name", ROBOTS)
def test_the_viewer_closes_loops_as_the_engine_does(name: str) -> None:
    robot = Limbs.of(analyze(name))
    view, m = linkage_view(robot), robot.linkage
    amounts: list[list[float]] = ROBOTS[name]
    wanted = [[v if a.angle else v * m.size for v, a in zip(row, leading(m), strict=True)] for row in amounts]
    for goal, found in zip(wanted, viewed({"linkage": view, "wanted": wanted}), strict=True):
        there = gc.pose(name, actuators=goal, nearest=False)
        assert found["reached"]
        assert found["margin"] == pytest.approx(there.margin, abs=1e-6)
        assert found["verdict"] == there.verdict
        for n, place in there.points.items():
            assert found["places"][n] == pytest.approx(place, abs=1e-6 * m.size), (n, goal)


@pytest.mark.needs("node")
@pytest.mark.parametrize("name", ["delta", "3-rps", "orthoglide"])
def test_what_is_drawn_follows_the_links(name: str) -> None:
    a = analyze(name)
    goal = [0.1, 0.2, -0.1]
    [found] = viewed({"linkage": linkage_view(Limbs.of(a)), "scene": robot_scene(a), "wanted": [goal]})
    values = {**AXES, **gc.pose(name, actuators=goal, nearest=False).points}
    drawn: Any = limb_views(a, values)
    for mine, its in zip(drawn, found["drawn"]["limbs"], strict=True):
        for kind in ("joints", "lines"):
            for one, other in zip(mine[kind], its[kind], strict=True):
                for key in {"point", "axes", "direction"} & set(one):
                    assert (one[key] is None) == (other[key] is None)
                    if one[key]:
                        assert np.allclose(one[key], other[key], atol=1e-6)


@pytest.mark.needs("node")
def test_a_robot_stops_where_it_does_not_assemble() -> None:
    view = linkage_view(Limbs.of(analyze("3-rps")))
    [found] = viewed({"linkage": view, "wanted": [[-100.0, 0, 0]]})
    assert not found["reached"]
    assert -100 < found["driven"][0] < 0
    assert math.isfinite(found["margin"])


def test_scenes_carry_the_linkage_of_robots_of_joints() -> None:
    assert {d["name"] for d in robot_scene(analyze("delta"))["linkage"]["drives"]} == {"q1", "q2", "q3"}
    assert "linkage" not in robot_scene(analyze("gough-stewart"))  # moves by its pose
    assert "linkage" not in robot_scene(analyze("gallardo-4dof"))  # relations make three of its points


def test_the_report_has_numbers_at_home() -> None:
    page = robot_report(analyze("delta"), live=False)
    assert "Numbers at home" in page
    assert f"{gc.pose('delta', nearest=False).margin:.4g}" in page
