r"""The part of a robot's page that shows its singular configurations, with what was found there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from gcrules.core.english import listed
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.conditions.factor_causes import KINDS, FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.lines.ranks import TYPES, types_of
from gcrules.poses.limbs.exact_values import Vector
from gcrules.poses.limbs.meeting import exact_meeting
from gcrules.poses.limbs.singular_members import SingularPose
from gcrules.screws import RATIONALS
from gcrules.views.pages.markdown import inline

__all__ = ["singular_section"]

_MEMBER = (
    "Each is an exact member of the robot's family: its points and directions satisfy all relations of the file, but"
    " its dimensions may differ from those at home."
)


def singular_section(
    a: RobotAnalysis, name: str, poses: Sequence[tuple[FactorCause, SingularPose | None]]
) -> Iterator[str]:
    """Lines of Markdown: for each factor a figure, ranks, the gained motion and what is not as at home."""
    yield "## Singular configurations"
    yield ""
    yield from (_MEMBER, "")
    for n, (part, pose) in enumerate(poses, 1):
        if len(poses) > 1:
            yield f"### {part.kind.capitalize()} singularity {n}"
            yield ""
        if part.statement:
            yield f"Where {inline(part.statement)}{f': {part.remark}' * part.of_design}."
            yield ""
        if pose is None:
            yield "No exact member with small numbers was found near home."
            yield ""
            continue
        yield f"![{inline(a.robot.title)} in a singular configuration]({name}-singular-{n}.svg)"
        yield ""
        yield " ".join(_told(a, pose))
        yield ""
        yield from _moved(a, pose)


def _told(a: RobotAnalysis, pose: SingularPose) -> Iterator[str]:
    if point := exact_meeting(a, pose.part, pose.values):
        yield f"{_what(a, pose)} of the factor meet {_place(point)}."
    before, here = pose.before, pose.ranks
    if here.constraints < before.constraints:
        yield (
            f"The constraints, computed from the joint screws, have rank {here.constraints} instead of"
            f" {before.constraints}, and all wrenches rank {here.wrenches} instead of {before.wrenches}."
        )
    else:
        yield (
            f"The wrenches, computed from the joint screws, have rank {here.wrenches} instead of {before.wrenches}"
            + (f"; the constraints keep rank {here.constraints}." if here.constraints else ".")
        )
    yield f"So {KINDS[_kind(pose)]}: {_motion(pose)}."
    yield f"Types of singularity: {listed([f'{TYPES[t]} ({t})' for t in types_of(here, before)])}."


def _what(a: RobotAnalysis, pose: SingularPose) -> str:
    """What meets in the common point of a factor."""
    if a.robot.family.plane:
        return "The lines"
    steps = {c.step for c in pose.part.expression.children}
    return "The planes" if steps == {3} else "The planes and lines"


def _kind(pose: SingularPose) -> str:
    """What the ranks say of the kind of a singular configuration."""
    return "constraint" if pose.ranks.constraints < pose.before.constraints else "actuation"


def _place(point: Sequence[Fraction]) -> str:
    x, y, z, w = point
    if not w:
        return f"at infinity, in the direction {_vector(RATIONALS.simplest((x, y, z)))}"
    return f"in the point {_vector((x / w, y / w, z / w))}"


def _motion(pose: SingularPose) -> str:
    """The motion that the platform gains, in words."""
    if pose.motion is None:
        return "in more than one way"
    w, v = (RATIONALS.vector(half) for half in (pose.motion[:3], pose.motion[3:]))
    if not any(w):
        return f"a shift in the direction {_vector(RATIONALS.simplest(v))}"
    square = sum(c * c for c in w)
    foot = tuple(c / square for c in RATIONALS.cross(w, v))
    pitch = sum(p * q for p, q in zip(w, v, strict=True)) / square
    about = f"about the line through {_vector(foot)} in the direction {_vector(RATIONALS.simplest(w))}"
    if not pitch:
        return f"a turn {about}"
    return f"a screw motion {about} with pitch {str(pitch).replace('-', '−')} (length for each radian)"


def _vector(v: Sequence[object]) -> str:
    return "(" + ", ".join(str(c).replace("-", "−") for c in v) + ")"


def _moved(a: RobotAnalysis, pose: SingularPose) -> Iterator[str]:
    """What is not as at home: the names that were moved, and those that followed."""
    home = home_values(a.robot)
    yield "| | at home | here |"
    yield "|---|---|---|"
    followed = [d.name for d in a.robot.family.definitions if _differs(a, d.name, home[d.name], pose.values[d.name])]
    for n in (*pose.moved, *(n for n in followed if n not in pose.moved)):
        yield f"| {inline(n)} | {_vector(home[n])} | {_vector(pose.values[n])} |"
    yield ""
    yield "All other points and directions are as at home."
    yield ""


def _differs(a: RobotAnalysis, name: str, one: Vector, other: Vector) -> bool:
    if a.robot.family.sorts[name] == "direction":
        return any(RATIONALS.cross(one, other))
    return one != other
