"""What the numbers of a platform say beyond the names of its joints, as values; singular in every pose, or not."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.rules.condition import Condition

__all__ = ["KINDS", "TOLERANCE", "Architecture", "Dimensions", "Fact", "OwnCondition", "check_tolerance"]

TOLERANCE = 1e-5
"""How far a fact may be from exact, as a part of the size of the body of which it is said."""

KINDS: Mapping[str, str] = {
    "coincident": "{members} of the {body} coincide",
    "collinear": "{members} of the {body} are on one line",
    "coplanar": "{members} of the {body} are in one plane",
    "circle": "{members} of the {body} are on one circle",
    "conic": "{members} of the {body} are on one conic",
    "similar": "base and platform are similar, with corresponding joints {members}",
    "mirrored": "base and platform are similar, as mirror images, with corresponding joints {members}",
    "affine": "an affine map takes the base to the platform, with corresponding joints {members}",
    "projective": "a projective map takes the base to the platform, with corresponding joints {members}",
    "rotation": "a turn of order {order} takes the base to itself, and one takes the platform to itself, with the"
    " legs in the cycles {members}",
    "mirror": (
        "a mirror takes the base to itself, and one takes the platform to itself, with the legs in the cycles {members}"
    ),
    "parallel": "the directions {members} of the {body} are parallel",
    "perpendicular": "the directions {members} of the {body} are perpendicular to each other",
    "level": "the directions {members} of the {body} are parallel to one plane",
    "same axis": "the axes {members} of the {body} coincide",
    "meet": "the axes {members} of the {body} meet in one point",
    "flat axes": "the axes {members} of the {body} are in one plane",
    "lengths": "within {body} the lengths {members} are equal",
}
"""The kinds of facts, each as a sentence."""

_EITHER = "of the size, or rad"  # the larger one of a distance and an angle

_UNITS: Mapping[str, str] = {
    **dict.fromkeys(("parallel", "perpendicular", "level"), "rad"),
    **dict.fromkeys(("same axis", "flat axes", "rotation", "mirror"), _EITHER),
    "lengths": "of the first",
}
"""What deviations are parts of, of the body's size where nothing is written here; of angles it is the sine."""


def check_tolerance(tolerance: float) -> None:
    """Raises InputError for a tolerance that is none."""
    if not 0 <= tolerance < 0.1:
        raise InputError(
            f"the tolerance {tolerance:g} is not between 0 and 0.1", hint="it is a fraction of the robot's size"
        )


@dataclass(frozen=True)
class Fact:
    """Something that holds of the bodies and so in every pose. `body` is base, platform, links, or "" where it is of
    base and platform; `members` are joints, directions or axes, pairs of joints (Aa), or cycles of legs. `deviation`
    is the most by which the numbers miss it: a distance as a part of the size of the bodies (of lengths of the first of
    them), or the sine of an angle between directions; 0 where it holds exactly, and nowhere else; `order` is that of a
    turn.
    """

    kind: str
    members: tuple[str, ...]
    body: str = ""
    deviation: float = 0.0
    order: int = 0

    @property
    def exact(self) -> bool:
        """Whether it holds without any tolerance, in rational numbers."""
        return not self.deviation

    @property
    def sentence(self) -> str:
        """The fact in words, and how exact it is."""
        between = listed if self.body else ", ".join
        said = KINDS[self.kind].format(members=between(self.members), body=self.body, order=self.order)
        unit = _UNITS.get(self.kind, "of the size")
        return f"{said} ({'exactly' if self.exact else f'nearly: up to {self.deviation:.2g} {unit}'})"

    def to_json(self) -> dict[str, Any]:
        return {
            "kind": self.kind,
            "body": self.body,
            "members": list(self.members),
            "deviation": self.deviation,
            "exact": self.exact,
            "order": self.order or None,
            "sentence": self.sentence,
        }


@dataclass(frozen=True)
class Architecture:
    """Whether a robot is singular in every pose: `verdict` is singular (proved), regular (a regular pose is known),
    nearly singular (the margin is within the tolerance in each of some random poses), seems singular (it is 0 up to
    rounding there, and exactly so in one), or open (too few poses were reached). `reason` says why, `sure` how that is
    known; `stress` are the forces in the legs that balance in every pose, where they are the same in all.
    """

    verdict: str
    sure: str
    reason: str = ""
    stress: tuple[tuple[str, str], ...] = ()

    @property
    def singular(self) -> bool:
        return self.verdict == "singular"

    def beside(self, condition: str) -> str:
        """The condition of the structure, as it stands beside a verdict of these dimensions.

        >>> Architecture("singular", "proved").beside("The robot is singular exactly when A, B and C are in line.")
        'Whatever its dimensions, the robot is singular exactly when A, B and C are in line.'
        """
        if not (self.singular or self.verdict == "seems singular"):
            return condition
        return f"Whatever its dimensions, {condition[:1].lower()}{condition[1:]}"

    @property
    def sentence(self) -> str:
        """The verdict as a sentence; "" for a regular architecture, and where it is open."""
        if self.verdict in ("regular", "open"):
            return ""
        why = f": {self.reason}" if self.reason else ""
        if self.singular:
            return f"Architecturally singular: this robot is singular in every pose{why}."
        if self.verdict == "seems singular":
            return f"It seems to be architecturally singular: {self.sure}."
        return f"Nearly architecturally singular: {self.sure}{why}."

    def to_json(self) -> dict[str, Any]:
        return {
            "verdict": self.verdict,
            "reason": self.reason,
            "sure": self.sure,
            "sentence": self.sentence,
            "stress": dict(self.stress),
        }


@dataclass(frozen=True)
class OwnCondition:
    """The condition of this robot: an identity of its legs, with joints that coincide under one name (`names` tells
    which), with what was `given` in words of the language. `fixed` are the factors of its expression that keep a value
    other than 0 in every pose, `free` the others. It was compared with the determinant of the legs at so many exact
    random `poses`.
    """

    condition: Condition
    legs: str
    names: tuple[tuple[str, str], ...]
    given: tuple[str, ...]
    free: tuple[str, ...]
    fixed: tuple[str, ...]
    poses: int

    def to_json(self, names: tuple[str, ...]) -> dict[str, Any]:
        return {
            "legs": self.legs,
            "names": dict(self.names),
            "given": list(self.given),
            "condition": self.condition.to_json(names),
            "free_factors": list(self.free),
            "fixed_factors": list(self.fixed),
            "poses": self.poses,
        }


@dataclass(frozen=True)
class Dimensions:
    """All that was looked at. `own` is the condition under the facts where it is another than that of the legs in
    general; `note` says what was tried else.
    """

    tolerance: float
    facts: tuple[Fact, ...]
    architecture: Architecture
    own: OwnCondition | None = None
    note: str = ""

    def to_json(self, names: tuple[str, ...]) -> dict[str, Any]:
        return {
            "tolerance": self.tolerance,
            "facts": [fact.to_json() for fact in self.facts],
            "architecture": self.architecture.to_json(),
            "own_condition": None if self.own is None else self.own.to_json(names),
            "note": self.note,
        }
