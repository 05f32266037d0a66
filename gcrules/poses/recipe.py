"""From what a map is planned anew, by another process or later: as JSON, and back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import Methods, method
from gcrules.screws.pose import Pose

__all__ = ["described", "recipe_of", "robot_of"]


def recipe_of(kind: str, found: Mechanism, over: Any, at: Any, limits: str | None, **more: Any) -> dict[str, Any]:
    """From what a task of this kind is made anew, as JSON: the robot with its coordinates, and the options as they were
    given; with the limits of the file, if there are any, which a mode may have left out.
    """
    return {
        "kind": kind,
        **described(found),
        "over": [axis if isinstance(axis, str) else axis.text for axis in over],
        "at": at.text() if isinstance(at, Pose) else _plain(at),
        "limits": limits,
        **more,
    }


def described(found: Mechanism) -> dict[str, Any]:
    """The robot, with the limits of its file if there are any, and about what its platform turns."""
    own = {"limits": found.limits} if found.limits else {}
    return {
        "robot": {**method(_DESCRIBED, found, "a map")(), **own},
        "about": _plain(getattr(found, "about", "centroid")),
    }


def _of_legs(m: SixLegs) -> dict[str, Any]:
    """A platform by its legs and points."""
    p = m.platform
    return {"legs": _plain(p.legs), "points": _plain(p.points), "title": p.title, "units": p.units}


def _of_limbs(m: Limbs) -> dict[str, Any]:
    """A robot of joints by the text of its file, the unit in that, and its home, which a mode may have changed."""
    unit = {"units": m.unit} if m.unit else {}
    return {"id": m.robot.id, "text": m.robot.text, "home": _plain(m.robot.home), **unit}


_DESCRIBED: Methods[dict[str, Any]] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""


def robot_of(given: Mapping[str, Any]) -> Source:
    """The robot of a recipe, as `load` takes it."""
    if "text" not in given:
        return {name: value for name, value in given.items() if value}
    robot = replace(parse_robot(given["text"], name=given["id"]), limits=given.get("limits", ""))
    home = given["home"]
    if home is None:
        return robot
    places = {n: (Fraction(x), Fraction(y), Fraction(z)) for n, (x, y, z) in home.items()}
    return robot if places == robot.home else replace(robot, home=places, drawing=None)


def _plain(value: Any) -> Any:
    """A value as JSON has it, exact numbers as text."""
    if isinstance(value, Mapping):
        return {str(k): _plain(v) for k, v in value.items()}
    if value is None or isinstance(value, (str, int, float)):
        return value
    if isinstance(value, Fraction):
        return str(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    return [_plain(v) for v in value] if isinstance(value, (list, tuple)) else str(value)
