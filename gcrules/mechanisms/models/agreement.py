"""Whether a robot file says of the platform what the joints of the model say: an independent computation in numbers."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np

from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.model import ModelCoupling
from gcrules.mechanisms.models.motions import Motion
from gcrules.mechanisms.models.moving import Moving, span
from gcrules.mechanisms.robot import Robot
from gcrules.screws import FLOATS, RESIDUES

__all__ = ["deviation", "generic"]

_SPREAD = 30  # how many times the tolerance products of wrenches and twists may be


def deviation(
    robot: Robot,
    limbs: Sequence[Sequence[Motion]],
    couplings: Sequence[ModelCoupling],
    ends: tuple[str, str],
    size: float,
    tolerance: float,
) -> float:
    """The largest power of a wrench of the robot file at home on a twist that the joints of the model allow the
    platform, both of length 1 with lengths in parts of the size: of each limb, with its actuators free and locked.

    The twists come from the joints of the model as it was read, by a kernel of its loops in floats; the wrenches from
    the joints of the file. Raises InputError where there are not as many of them as there have to be, or where the
    power is more than rounding within the tolerance makes it.
    """
    values = {name: [float(c) for c in v] for name, v in robot.values_at().items()}
    most = 0.0
    allowed = _SPREAD * max(tolerance, 1e-9)
    for spec, motions in zip(robot.limbs, limbs, strict=True):
        limb = spec.at({n: FLOATS.vector(v) for n, v in values.items()}, FLOATS)
        moving = Moving(motions, ends[0], couplings, size)
        driven = {m.joint for m in motions if m.driven}
        for held, wrenches in (((), limb.constraints(FLOATS)), (sorted(driven), limb.locked(FLOATS))):
            twists = moving.twists(ends[1], moving.home, held, allowed)
            own = span(np.asarray(wrenches).reshape(-1, 6) * [1, 1, 1, *[1 / size] * 3], 1e-9)
            power = np.abs(own[:, :3] @ twists[:, 3:].T + own[:, 3:] @ twists[:, :3].T)
            most = max(most, float(power.max(initial=0.0)))
            if len(own) + len(twists) != 6 or most > allowed:
                what = "with its actuators locked" if held else "with its actuators free"
                more = f"; largest power of one on the other {most:.2g}" if most > allowed else ""
                raise InputError(
                    f"{spec.name} {what} does not come out as the model has it: its joints allow {len(twists)} twists,"
                    f" the robot file has {len(own)} wrenches{more}",
                    hint="the model may be singular at its home, or its decimals too coarse: try another --tolerance",
                )
    return most


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
