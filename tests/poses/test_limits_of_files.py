"""Limits of a file hold where none are given, others replace them, and "none" leaves them out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from commands import assert_refused, invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.robot import Robot

LEGS, JOINTS = "legs 120..560", "actuators -0.3..0.3"
OTHERS = {LEGS: "legs 100..600", JOINTS: "actuators -0.1..0.2"}
OF_FILE = " (of the file)"


def source(limits: str) -> Platform | Robot:
    found = gc.load(str(EXAMPLES / "octahedral.yaml") if limits == LEGS else "3-rpr")
    assert isinstance(found, Platform | Robot)
    return replace(found, limits=limits)


def ranges(kind: str, nodes: str = "") -> list[str]:
    """Two coordinates."""
    if kind == LEGS:
        return [f"x -200:200{nodes}", f"z -100:50{nodes}"]
    return [f"x -0.4:0.4{nodes}", f"y -0.4:0.4{nodes}"]


def mapped(given: Any, kind: str, **options: Any) -> tuple[str, Any]:
    found = gc.singular_map(given, ranges(kind, ":9"), **options)
    return found.limits.text if found.limits else "", found.summary.allowed


def boxed(given: Any, kind: str, **options: Any) -> tuple[str, Any]:
    found = gc.box_map(given, ranges(kind), tiles=2, boxes=31, **options)
    text = found.task.question.limits
    return text.text if text else "", found.to_json()["limits"]


def certified(given: Any, kind: str, **options: Any) -> tuple[str, Any]:
    found = gc.certify(given, ranges(kind), time=1, **options)
    text = found.asked.task.question.limits
    return text.text if text else "", found.asked.limited


def planned(given: Any, kind: str, **options: Any) -> tuple[str, Any]:
    found = gc.plan(given, "home", "0 0 -10" if kind == LEGS else "x=0.05, y=0, yaw=0deg", **options)
    return found.search.limits if found.search else "", found.outcome


def parted(given: Any, kind: str, **options: Any) -> tuple[str, Any]:
    found = gc.aspects(given, modes=False, poses=4, **options)
    return found.search.limits, 0


ASKED: list[tuple[Callable[..., tuple[str, Any]], str]] = [
    *((ask, limits) for limits in (LEGS, JOINTS) for ask in (mapped, boxed, certified, planned)),
    (parted, LEGS),
]


@pytest.mark.parametrize(("ask", "limits"), ASKED, ids=lambda one: one if isinstance(one, str) else one.__name__)
def test_whose_limits_hold(ask: Callable[..., tuple[str, Any]], limits: str) -> None:
    """Those of the file are as good as the same ones given; others, and none, as if the file had none."""
    limited, free = source(limits), replace(source(limits), limits="")
    text, found = ask(limited, limits)
    assert text.endswith(OF_FILE)
    assert (text.removesuffix(OF_FILE), found) == ask(free, limits, limits=limits)
    other = ask(limited, limits, limits=OTHERS[limits])
    assert OF_FILE not in other[0]
    assert other == ask(free, limits, limits=OTHERS[limits])
    assert ask(limited, limits, limits="none") == ask(free, limits)


def test_limits_of_the_file_refuse_a_start() -> None:
    found = replace(source(LEGS), limits="legs 1..2")
    with pytest.raises(InputError, match=r"is not within the limits: 1 ≤ every leg ≤ 2 mm \(of the file\)"):
        gc.plan(found, "home", "0 0 -10")
    assert gc.plan(found, "home", "0 0 -10", limits="none").outcome == "way"


def test_six_legs_of_joints() -> None:
    """Amounts of slides along legs are lengths of these; where slides go elsewhere the joints are moved."""
    robot = gc.load("gough-stewart")
    assert isinstance(robot, Robot)
    along = gc.singular_map(replace(robot, limits="actuators -0.5..0.5"), ["x -1:1:9", "z -1:1:9"])
    kept = gc.singular_map(robot, ["x -1:1:9", "z -1:1:9"])
    assert along.limits is not None
    assert along.limits.names[0] == "A1B1"
    assert 0 < along.summary.allowed < kept.summary.allowed


def test_tiles_are_planned_anew(tmp_path: Any) -> None:
    """A store knows the limits of the file."""
    limited = source(LEGS)
    kept = gc.singular_map(limited, ranges(LEGS, ":9"), work=str(tmp_path / "map.zarr"))
    assert gc.verify_map(str(tmp_path / "map.zarr")).bad == ()
    assert kept.limits is not None
    assert kept.limits.text.endswith(OF_FILE)


def test_the_command_says_whose_they_are(tmp_path: Any) -> None:
    path = tmp_path / "limited.yaml"
    path.write_text((EXAMPLES / "octahedral.yaml").read_text("utf-8") + f"limits: {LEGS}\n", "utf-8")
    words = ["map", str(path), "--over", "x -200:200:9", "--over", "z -100:50:9"]
    assert "120 ≤ every leg ≤ 560 mm (of the file)" in invoke(*words).output
    assert "limits" not in invoke(*words, "--limits", "none").output
    path.write_text(path.read_text("utf-8").replace("legs 120", "legs 620"), "utf-8")
    assert_refused(invoke(*words), 2, "reversed")
