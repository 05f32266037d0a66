"""Whether a robot file says of the platform what the joints of the model say: an independent computation in numbers."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NoReturn

import numpy as np

from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.model import ModelCoupling
from gcrules.mechanisms.models.motions import Motion
from gcrules.mechanisms.models.moving import Moving, span
from gcrules.mechanisms.robot import Robot
from gcrules.screws import FLOATS, RESIDUES

__all__ = ["deviation", "generic"]

_RANK = 1e-7
_SAME = 1e-6  # the power of wrenches on twists of the same joints
_SPREAD = 30  # how many times what joints were moved by a rank may be off
_MOST = 0.05  # a power with which wrenches do not fit, whatever joints were moved by


def deviation(
    robot: Robot,
    limbs: Sequence[Sequence[Motion]],
    read: Sequence[Sequence[Motion]],
    couplings: Sequence[ModelCoupling],
    ends: tuple[str, str],
    size: float,
    moved: float,
) -> float:
    """The largest power of a wrench of the robot file at home on a twist that the joints of the model as it was read
    allow the platform, both of length 1 with lengths in parts of the size: of each limb, with its actuators free and
    locked. `moved` is the most by which a joint was moved to make it exact, in parts of the size and radians.

    The twists come from the joints of the model, by a kernel of its loops in floats; the wrenches from the joints of
    the file. Raises InputError where there are not as many of them as there have to be, where they do work on twists of
    the exact joints, or more on those that were read than moving these can explain.
    """
    values = {name: [float(c) for c in v] for name, v in robot.values_at().items()}
    most = 0.0
    for spec, exact, before in zip(robot.limbs, limbs, read, strict=True):
        limb = spec.at({n: FLOATS.vector(v) for n, v in values.items()}, FLOATS)
        driven = sorted({m.joint for m in exact if m.driven})
        for held, wrenches in (((), limb.constraints(FLOATS)), (driven, limb.locked(FLOATS))):
            own = span(np.asarray(wrenches).reshape(-1, 6) * [1, 1, 1, *[1 / size] * 3], 1e-9)
            for motions, rank, allowed in ((exact, _RANK, _SAME), (before, _SPREAD * max(moved, 1e-9), _MOST)):
                moving = Moving(motions, ends[0], couplings, size)
                twists = moving.twists(ends[1], moving.home, held, rank)
                power = np.abs(own[:, :3] @ twists[:, 3:].T + own[:, 3:] @ twists[:, :3].T).max(initial=0.0)
                if len(own) + len(twists) != 6 or power > allowed:
                    _refuse(spec.name, bool(held), len(twists), len(own), float(power) if power > allowed else 0.0)
                if motions is before:
                    most = max(most, float(power))
    return most


def _refuse(name: str, held: bool, twists: int, wrenches: int, power: float) -> NoReturn:
    what = "with its actuators locked" if held else "with its actuators free"
    more = f"; largest power of one on the other {power:.2g}" if power else ""
    raise InputError(
        f"{name} {what} does not agree with the model: its joints allow {twists} twists,"
        f" the robot file has {wrenches} wrenches{more}",
        hint="the model may be singular at its home, or its decimals too coarse: try another --tolerance",
    )


def generic(
    robot: Robot,
    limbs: Sequence[Sequence[Motion]],
    couplings: Sequence[ModelCoupling],
    values: Sequence[Floats],
    ends: tuple[str, str],
    size: float,
) -> str:
    """In what a random member of the family differs from the model some way from home, in the numbers of wrenches of
    each limb; "" if in nothing.
    """
    member = robot.family.member("import")
    for spec, motions, own in zip(robot.limbs, limbs, values, strict=True):
        limb = spec.at(member, RESIDUES)
        moving = Moving(motions, ends[0], couplings, size)
        driven: Collection[str] = sorted({m.joint for m in motions if m.driven})
        for held, wrenches in (((), limb.constraints(RESIDUES)), (driven, limb.locked(RESIDUES))):
            count = 6 - len(moving.twists(ends[1], own, tuple(held)))
            if count != len(wrenches):
                return f"{spec.name} has {len(wrenches)} wrenches in the family, and {count} in the model"
    return ""
