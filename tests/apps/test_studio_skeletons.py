"""What the studio draws of robots of joints: their skeletons, and the points that planes go through."""

from __future__ import annotations

import math
from itertools import combinations

import pytest

import gcrules as gc
from gcrules.mechanisms.description.discovery import RobotFile, robots
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.exact_values import lines_at
from gcrules.views.robots.skeleton import skeleton

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import HOME, Page


def sides(corners: list[list[float]]) -> list[float]:
    return [math.dist(p, q) for p, q in combinations(corners, 2)]


def test_rods_and_platform_of_a_robot_keep_their_lengths(page: Page) -> None:
    """What is drawn of the Delta robot is rigid: its loops are closed elsewhere."""
    source = {"kind": "robot", "id": "delta"}
    home, there = (
        page.ask("pose", source=source, pose={**HOME, "coordinates": c})["skeleton"] for c in ([0, 0, 0], [20, -10, 5])
    )
    bars = [[math.dist(*s["ends"]) for s in one["strokes"] if s["look"] == "bar"] for one in (home, there)]
    assert len(bars[0]) == 6
    assert bars[0] == pytest.approx(bars[1])
    assert len(home["platform"]) == len(home["base"]) == 3
    assert sides(home["platform"]) == pytest.approx(sides(there["platform"]))
    assert home["base"] == [pytest.approx(p) for p in there["base"]]
    assert math.dist(home["platform"][0], there["platform"][0]) > 0.01


def test_directions_turn_with_the_links(page: Page) -> None:
    """Those of the base stay, that of a rod is along the rod."""
    source = {"kind": "robot", "id": "delta"}
    home, there = (page.ask("pose", source=source, pose={**HOME, "coordinates": c}) for c in ([0, 0, 0], [20, -10, 5]))
    for name in ("r1", "r2", "r3"):
        assert home["directions"][name] == pytest.approx(there["directions"][name])
    rods = [s["ends"] for s in there["skeleton"]["strokes"] if s["look"] == "bar"]
    for k, name in enumerate(("d1", "d2", "d3")):
        (p, q), u = rods[2 * k], there["directions"][name]
        assert abs(sum((b - a) * c for a, b, c in zip(p, q, u, strict=True))) == pytest.approx(math.dist(p, q))


@pytest.mark.parametrize("one", robots(), ids=lambda one: str(one.id))
def test_every_robot_has_a_skeleton(one: RobotFile) -> None:
    robot = read_robot(one.path)
    found = skeleton(robot, {n: [float(c) for c in v] for n, v in robot.values_at().items()})
    assert found["strokes"]
    assert found["platform"]
    places = [p for s in found["strokes"] for p in s["ends"]]
    places += [place for sign in found["signs"] for place in (sign["at"], *sign["axes"])]
    assert all(math.isfinite(c) for p in (*places, *found["platform"], *found["base"]) for c in p)
    driven = sum(bool(joint.actuated) for limb in robot.limbs for _, joints in limb.parts for joint in joints)
    assert sum(sign["actuated"] for sign in found["signs"]) >= driven > 0, "a driven joint has no sign"


def test_the_signs_of_joints_are_where_paper_has_them(page: Page) -> None:
    """A first slide on a rail at the joint that it carries, a hinge of a spherical chain on its sphere."""
    sliding = page.ask("pose", source={"kind": "robot", "id": "orthoglide"}, pose={**HOME, "coordinates": [0.2, 0, 0]})
    carriages = [sign["at"] for sign in sliding["skeleton"]["signs"] if sign["kind"] == "carriage"]
    assert carriages == [pytest.approx(sliding["points"][name]) for name in ("A1", "A2", "A3")]
    turning = page.ask("pose", source={"kind": "robot", "id": "3-rrr-spherical"}, pose=HOME)
    signs = turning["skeleton"]["signs"]
    assert len(signs) == 9
    for sign in signs:
        arm = [a - b for a, b in zip(sign["at"], turning["points"]["O"], strict=True)]
        reach = math.hypot(*arm)
        assert reach > 0.3
        assert abs(sum(a * c for a, c in zip(arm, sign["axes"][0], strict=True))) == pytest.approx(reach)


def test_points_that_the_lines_derive_have_places(page: Page) -> None:
    """Those of H4 through which planes of its condition go; in exact numbers they are the same."""
    source = {"kind": "robot", "id": "h4"}
    opened = page.ask("open", source=source)
    found = page.ask("pose", source=source, pose=HOME)
    named = {name for entity in opened["entities"] for name in entity["points"]}
    assert {"p1", "p2"} <= named
    assert named <= found["points"].keys() | found["directions"].keys()
    robot = gc.load("h4")
    structure = gc.analyze("h4").structure
    exact = lines_at(robot.family, structure, robot.values_at())
    for name in named & found["points"].keys():
        *place, weight = exact[name]
        assert found["points"][name] == pytest.approx([float(c / weight) for c in place])
