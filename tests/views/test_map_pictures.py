"""Pictures of maps: whose coordinates the axes are, what is fixed, the mechanism, thresholds without beads."""

from __future__ import annotations

from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.poses.maps.axes import parse_axis
from gcrules.poses.maps.report import SingularMap

pytest.importorskip("matplotlib")
from matplotlib.collections import Collection
from matplotlib.figure import Figure

from gcrules.views.plots.map_head import HEAD, mechanism_drawing
from gcrules.views.plots.map_plot import figure

YELLOW = (0.941, 0.894, 0.259)
OCTAHEDRAL = EXAMPLES / "octahedral.yaml"


def mapped(source: Any, over: list[str], **options: Any) -> SingularMap:
    return gc.singular_map(source, over, **options)


@pytest.mark.parametrize(
    ("text", "caption"),
    [
        ("x -1:1:5", "translation x of the platform (mm)"),
        ("rx -60:60:9 deg", "rotation vector rx of the platform (deg)"),
        ("tilt 0:60:9 deg", "tilt of the platform (deg)"),
        ("roll 0:60:9 deg", "roll of the platform (deg)"),
        ("zyx1 0:60:9 deg", "Euler angle zyx1 of the platform (deg)"),
    ],
)
def test_captions_say_whose_coordinate_it_is(text: str, caption: str) -> None:
    assert parse_axis(text, "mm").caption == caption


def test_captions_of_actuators() -> None:
    assert parse_axis("q1 0:1:3", "", {"q1": False}).caption == "actuator q1, from home"


@pytest.mark.parametrize(
    ("over", "at", "fixed"),
    [
        (["x -9:9:3", "z -9:9:3"], None, "y = 0, no rotation"),
        (["x -9:9:3", "z -9:9:3"], "0 7 0", "y = 7 mm, no rotation"),
        (["x -9:9:3", "y -9:9:3", "z -9:9:3"], "0 0 0; rotation-vector 0 0 30 deg", "turned by 30° about (0, 0, 1)"),
        (["rx -6:6:3 deg", "rz -6:6:3 deg"], "0 0 -100", "x = 0, y = 0, z = -100 mm, ry = 0°"),
        (["roll -6:6:3 deg", "z -6:6:3"], "0 0 -100; euler ZYX 10 20 0 deg", "x = 0, y = 0, yaw = 10°, pitch = 20°"),
        (["azimuth -6:6:3 deg", "tilt 1:6:3 deg"], None, "x = 0, y = 0, z = 0, torsion = 0°"),
    ],
)
def test_what_is_fixed(over: list[str], at: str | None, fixed: str) -> None:
    assert mapped(OCTAHEDRAL, over, at=at, measure="value").grid.fixed == fixed


def test_what_is_fixed_of_a_robot_of_joints() -> None:
    assert mapped("3-rpr", ["x -0.1:0.1:3", "yaw 10:20:3 deg"]).grid.fixed == "y = 0"
    whole = mapped("5r", ["x -0.1:0.1:3", "y -0.1:0.1:3"]).grid
    assert (whole.fixed, whole.rest) == ("", "none: the axes are all that the robot has")


def words(made: Figure) -> list[str]:
    return [t.get_text() for t in made.texts]


@pytest.mark.parametrize(
    ("source", "over", "at", "shown"),
    [
        (OCTAHEDRAL, ["x -300:300:9", "z -500:100:9"], None, ["fixed: y = 0, no rotation", "drawn at home"]),
        (
            OCTAHEDRAL,
            ["x -300:300:9", "z -500:100:9"],
            "0 -7 0",
            ["fixed: y = −7 mm, no rotation", "drawn at the given pose"],
        ),
        ("3-rpr", ["x -0.1:0.1:5", "yaw 10:20:5 deg"], None, ["fixed: y = 0", "drawn at home"]),
    ],
)
def test_the_head_of_a_map(source: Any, over: list[str], at: str | None, shown: list[str]) -> None:
    """The name, what is fixed, and the mechanism stand over the field and beside each other."""
    m = mapped(source, over, at=at)
    made = figure(m)
    assert words(made)[1:] == shown
    assert words(made)[0] == m.grid.title
    made.draw_without_rendering()
    height = made.bbox.height
    field = max(a.get_tightbbox().y1 for a in made.axes)
    low = height - HEAD * made.dpi
    assert field <= low + 1
    texts = [t.get_window_extent() for t in made.texts]
    assert all(low <= t.y0 < t.y1 <= height and t.x1 <= made.bbox.width for t in texts)
    drawn = [a.get_window_extent() for a in made.artists]
    assert len(drawn) > 6
    assert all(low <= b.y0 and b.y1 <= height and b.x1 < min(t.x0 for t in texts) for b in drawn)
    (first, second) = m.grid.axes
    assert (made.axes[0].get_xlabel(), made.axes[0].get_ylabel()) == (first.caption, second.caption)


def test_a_mechanism_that_cannot_be_drawn_is_left_out() -> None:
    """A leg has no length at the given pose."""
    legs = gc.analyze(OCTAHEDRAL).platform
    assert legs is not None
    base, top = legs.legs[0]
    shift = [p - q for p, q in zip(legs.points[base], legs.points[top], strict=True)]
    m = mapped(OCTAHEDRAL, ["x -300:300:5", "z -500:100:5"], at=" ".join(map(str, shift)), measure="value")
    assert mechanism_drawing(m) is None
    assert words(figure(m))[-1].startswith("fixed: y = ")


def threshold_lines(made: Figure) -> list[Any]:
    """The stretches of the threshold, as they are drawn."""
    yellow = [c for c in made.axes[0].collections if isinstance(c, Collection) and _is_yellow(c)]
    assert len(yellow) == 1
    return [part for path in yellow[0].get_paths() for part in path.to_polygons(closed_only=False)]


def _is_yellow(c: Collection) -> bool:
    colours = c.get_edgecolor()
    return len(colours) > 0 and colours[0][:3] == pytest.approx(YELLOW, abs=0.01)


@pytest.mark.parametrize("nodes", [21, 33])
def test_thresholds_are_no_beads(nodes: int) -> None:
    """Nodes are farther from each other than the threshold is from the curve: still two lines run along it."""
    m = mapped(OCTAHEDRAL, [f"rx -60:60:{nodes} deg", f"rz -180:180:{nodes} deg"], at="0 0 -100", threshold="0.1 deg")
    assert len(m.curves) == 1
    lines = threshold_lines(figure(m))
    assert len(lines) == 2
    assert all(len(line) > nodes for line in lines)
