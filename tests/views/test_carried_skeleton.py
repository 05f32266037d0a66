"""Skeletons of robots as their links carry them, beside those that are drawn anew in each configuration."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pytest
from views.test_linkage import viewed

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze
from gcrules.mechanisms.description.discovery import RobotFile, robots
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.solve import beside
from gcrules.mechanisms.kinematics.targets import actuators_target
from gcrules.mechanisms.limbs import Limbs
from gcrules.views.report.robot_report import robot_scene
from gcrules.views.robots.carried_skeleton import carried_skeleton
from gcrules.views.robots.linkage_view import linkage_view
from gcrules.views.robots.skeleton import skeleton, unit_at

STAND = {"4-ups-sp", "gallardo-4dof", "omni-wrist-iii"}
"""Relations make some of their points, which no link carries."""
BARS = {"capaman"}
"""The bars of its parallelograms, which turn, are drawn as rails."""
GOALS: dict[str, Sequence[float]] = {
    "delta": [0.1, 0.2, -0.1],
    "3-rps": [0.1, 0.2, -0.1],
    "3-rrr-spherical": [0.1, -0.2, 0.1],
    "capaman": [0.1, -0.05, 0.08],
    "tricept": [0.1, 0.2, -0.1],
    "3-rrr": [0.02, 0.01, -0.02],
    "6-rus": [0.02, 0.01, -0.02, 0.01, 0, 0.02],
}
SLOW = 3e-6  # the page closes loops to 1e-11, of values that it gets with as many digits


def linkage_of(name: str) -> Linkage:
    return Limbs.of(analyze(name)).linkage


def shown(place: Mapping[str, Any], links: Sequence[Any]) -> Any:
    """Where the links take it."""
    parts = zip(place["links"], place["shares"], place["at"], strict=True)
    return sum(share * (links[i][k] @ [*at, 1.0])[:3] for (i, k), share, at in parts)


def agree(mine: Mapping[str, Any], other: Mapping[str, Any], accuracy: float, *, bars: bool = False) -> None:
    """That two skeletons are one, apart from the turn of `bars` that are drawn as rails."""
    for one, its in zip(mine["strokes"], other["strokes"], strict=True):
        assert one["look"] == its["look"]
        bar = bars and one["look"] == "rail"
        assert bar or np.allclose(one["ends"], its["ends"], rtol=0, atol=accuracy)
    for one, its in zip(mine["signs"], other["signs"], strict=True):
        assert (one["kind"], one["actuated"]) == (its["kind"], its["actuated"])
        carriage = bars and one["kind"] == "carriage"
        assert carriage or np.allclose(one["at"], its["at"], rtol=0, atol=accuracy)
        assert all(
            np.allclose(u / np.linalg.norm(u), v, rtol=0, atol=1e-5)
            for u, v in zip(one["axes"], its["axes"], strict=True)
        )
    assert np.allclose(mine["platform"], other["platform"], rtol=0, atol=accuracy)


@pytest.mark.parametrize("one", robots(), ids=lambda one: str(one.id))
def test_links_carry_what_is_drawn(one: RobotFile) -> None:
    """Of every robot, where its actuators bring it by other amounts than those that found the links."""
    if one.id in STAND:
        with pytest.raises(InputError, match="no link carries"):
            linkage_view(Limbs.of(analyze(one.id)))
        return
    m = linkage_of(one.id)
    found = carried_skeleton(m)
    assert found is not None
    amounts = [(0.02 - 0.005 * i) * (1.0 if a.angle else m.size) for i, a in enumerate(leading(m))]
    unit = unit_at(m.robot, {n: v.tolist() for n, v in m.home.values.items()})
    for there in (m.home, beside(m, actuators_target(m, amounts), m.home)):
        drawn = skeleton(m.robot, {n: v.tolist() for n, v in there.values.items()}, unit)
        mine = {
            "strokes": [{**s, "ends": [shown(p, there.links) for p in s["ends"]]} for s in found["strokes"]],
            "signs": [
                {**s, "at": shown(s["at"], there.links), "axes": [shown(a, there.links) for a in s["axes"]]}
                for s in found["signs"]
            ],
            "platform": [shown(p, there.links) for p in found["platform"]],
        }
        agree(mine, drawn, 1e-6 * unit.radius, bars=one.id in BARS)


@pytest.mark.needs("node")
@pytest.mark.parametrize("name", GOALS)
def test_the_page_draws_the_robot_as_the_engine_does(name: str) -> None:
    a, goal = analyze(name), GOALS[name]
    view = linkage_view(Limbs.of(a))
    [found] = viewed({"linkage": view, "scene": robot_scene(a), "wanted": [goal]})
    values = {**AXES, **gc.pose(name, actuators=goal, nearest=False).points}
    unit = unit_at(a.robot, {n: [float(c) for c in v] for n, v in a.robot.values_at().items()})
    plain = {n: [float(c) for c in v] for n, v in values.items()}
    agree(found["drawn"]["skeleton"], skeleton(a.robot, plain, unit), SLOW * unit.radius, bars=name in BARS)
    assert not found["drawn"].get("bars")  # these are what is drawn without a skeleton


@pytest.mark.parametrize("one", robots(), ids=lambda one: str(one.id))
def test_reports_show_robots_in_a_size_of_their_own(one: RobotFile) -> None:
    """The spherical robots have all points in one place."""
    scene = robot_scene(analyze(one.id))
    assert scene["size"] > 0
    assert scene.get("skeleton") or scene.get("recipe")


def test_rails_do_not_change_sides_while_the_robot_moves() -> None:
    """The feet of 3-PPRS lie beside its rails: they move as far as the joints on them do."""
    robot = analyze("3-pprs").robot
    home = {n: [float(c) for c in v] for n, v in robot.values_at().items()}
    unit = unit_at(robot, home)
    before = np.array([s["ends"] for s in skeleton(robot, home, unit)["strokes"] if s["look"] == "rail"])
    for shift in ([-0.5, 0.5], [-1.2, 1.2], [-2.5, 2.5], [-4.0, 0.0]):
        by = np.array([*shift, 0.0])
        there = {n: (np.array(at) + by).tolist() if n == "A1" else at for n, at in home.items()}  # S1 stays
        after = np.array([s["ends"] for s in skeleton(robot, there, unit)["strokes"] if s["look"] == "rail"])
        assert np.allclose(after[:2], before[:2] + by, rtol=0, atol=1e-9)
        assert np.allclose(after[2:], before[2:], rtol=0, atol=1e-9)
