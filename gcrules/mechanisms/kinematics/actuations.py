r"""What actuators do in many configurations at once: their wrenches, and the constraints of all limbs.

Of a limb with locked actuators let S be a basis of the wrenches, orthonormal at the limb's end with moments in parts of
the robot's size, and P the products of its rows with the unit twists of the actuators. The rows of P⁺ S are the least
wrenches of the limb that have product 1 with the twist of one actuator each, and 0 with those of the others: what could
be added lies in the limb's constraints, and does no work. In a limb with loops of its own they are the wrenches on the
platform and in its loops together.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.kinematics.amplification import Amplifications, Drives, amplifications
from gcrules.mechanisms.kinematics.attachments import Values, moved
from gcrules.mechanisms.kinematics.chains import geometry_of
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.margin import balanced, kept_axes, limb_twists, on_platform
from gcrules.mechanisms.kinematics.rigid_motions import Floats, crossed
from gcrules.mechanisms.kinematics.transmission import Transmissions, of_constraints, shaken, transmitted

__all__ = ["Actuations", "actuations", "amplified", "drives"]

_RANK = 1e-9


def drives(m: Linkage) -> Drives:
    """What the robot's actuators drive."""
    freedoms, every = m.robot.mobility, sum(own for own, _ in m.applied)
    independent = every == 6 - freedoms and not m.robot.family.plane
    return Drives(
        tuple(a.angle for a in m.actuators), freedoms, m.pulls, plain=not m.looped, constraints=every * independent
    )


def amplified(m: Linkage, here: Configurations) -> Amplifications:
    """What the actuators make of their rates, about the moved centre, with the robot's size as characteristic
    length.
    """
    own, known = actuations(m, here), drives(m)
    found = amplifications(own.driven, np.concatenate(own.held, axis=1), known, m.size)
    return replace(found, transmissions=_passing(m, here, own, found)) if known.plain else found


def _passing(m: Linkage, here: Configurations, own: Actuations, found: Amplifications) -> Transmissions:
    known, places, limbs = found.drives, [a.place for a in m.actuators], m.robot.limbs
    amounts = zip(m.home.chains, here.joint_values, strict=True)
    values = moved(m.robot, m.attachments, m.home.values, tuple(chain.links(own) for chain, own in amounts))
    following = np.stack([_following(limbs[a.place], a.coordinate, values, own, a.place) for a in m.actuators], axis=1)
    inputs = transmitted(own.driven, own.joints, following - own.centre[:, None])
    outputs = transmitted(own.driven, found.twists, own.arms[:, places])
    if known.redundant:
        outputs = np.full_like(outputs, np.nan)
    constraints = np.zeros((len(here), 0))
    if known.constraints and not known.redundant:
        constraints = of_constraints(own.driven, own.held, list(np.moveaxis(own.arms, 1, 0)), m.size)
    forces = [list(_forces(limb, w, values, own.centre)) for limb, w in zip(limbs, own.locked, strict=True)]
    return Transmissions(inputs, outputs, constraints, *shaken(own.locked, forces, kept_axes(m), m.size))


def _following(limb: LimbSpec, coordinate: int, values: Values, own: Actuations, place: int) -> Floats:
    """The place (N, 3) of the first joint with a place after the one that has a coordinate; else the limb's end."""
    behind = False
    for k, (joint, places) in enumerate(zip(limb.joints, limb.coordinates, strict=True)):
        if behind and (found := _place(geometry_of(joint, values))) is not None:
            return np.broadcast_to(found, own.centre.shape)
        behind |= coordinate in places and k not in limb.ratios
    return np.asarray(own.centre + own.arms[:, place])


def _place(geometry: Mapping[str, Any]) -> Floats | None:
    """Where a joint is, None of one without a place, such as a slide; of bars where they begin."""
    if {"first", "second", "bars"} <= set(geometry):
        return np.asarray((geometry["first"] + geometry["second"]) / 2)
    return next((geometry[part] for part in ("point", "near") if part in geometry), None)


def _forces(limb: LimbSpec, wrenches: Floats, values: Values, centre: Floats) -> Iterator[tuple[int, Floats]]:
    """What wrenches (N, k, 6) about the centre are at the joints of a chain: forces (N, k, 3), and at how many joints;
    of a cable, none. A wrench that passes through two bars is two forces along them.
    """
    if limb.cable:
        return
    hinged = sum(2 if j.kind == "Pa" else 1 for j in limb.joints if j.kind != "4S")
    yield hinged, wrenches[..., :3]
    for joint in limb.joints:
        if joint.kind == "4S":
            g = geometry_of(joint, values)
            bars = np.broadcast_to(g["bars"] / np.linalg.norm(g["bars"], axis=-1, keepdims=True), centre.shape)
            along = [np.concatenate([bars, crossed(g[end] - centre, bars)], axis=1) for end in ("first", "second")]
            parts = wrenches @ np.linalg.pinv(np.stack(along, axis=1))
            yield from ((2, parts[..., n : n + 1] * bars[:, None]) for n in (0, 1))


@dataclass(frozen=True, eq=False)
class Actuations:
    """In N configurations, about the moved `centre` (N, 3): the wrenches (f; m) of the actuators, `driven`
    (N, actuators, 6), in their order, for rates of 1 rad or a unit of length, not numbers where an actuator applies
    none; their own twists (v; ω) at such rates, `joints` (N, actuators, 6); of each limb its constraints, `held`
    (N, k, 6), and its wrenches with locked actuators; and the `arms` (N, limbs, 3) to the limbs' ends.
    """

    centre: Floats
    arms: Floats
    driven: Floats
    joints: Floats
    held: tuple[Floats, ...]
    locked: tuple[Floats, ...]


def _centre(m: Linkage, here: Configurations) -> Floats:
    return np.asarray(m.centre @ np.swapaxes(here.platform[:, :3, :3], 1, 2) + here.platform[:, :3, 3])


def actuations(m: Linkage, here: Configurations) -> Actuations:
    """What the actuators and the constraints apply."""
    centre = _centre(m, here)
    arms = m.ends @ np.swapaxes(here.platform[:, :3, :3], 1, 2) + here.platform[:, None, :3, 3] - centre[:, None]
    driven: list[Floats] = [np.zeros(0)] * len(m.actuators)
    joints = list(driven)
    held, locked = [], []
    for place, chain in enumerate(here.chains):
        arm = arms[:, place]
        twists, free = limb_twists(m, place, here, centre + arm)
        every = balanced(twists[:, free], m.passive_ranks[place])
        of_held, of_all = m.elsewhere.applied[place]
        held.append(_about_centre(on_platform(balanced(twists, m.ranks[place]), of_held), arm, m.size))
        locked.append(_about_centre(on_platform(every, of_all), arm, m.size))
        own = [k for k, a in enumerate(m.actuators) if a.place == place]
        if not own:
            continue
        coordinates = [m.actuators[k].coordinate for k in own]
        units = np.where(np.array(chain.turns)[coordinates], m.size, 1.0)
        rates = units[:, None] * twists[:, coordinates]  # (ρ ω; v) for unit rates
        products = rates @ np.swapaxes(every, 1, 2)
        none = np.linalg.svd(products, compute_uv=False)[:, -1] <= _RANK * m.size
        rows = _about_centre(np.swapaxes(np.linalg.pinv(products), 1, 2) @ every, arm, m.size)
        rows[none] = np.nan
        turns = rates[..., :3] / m.size
        shifts = rates[..., 3:6] - crossed(turns, arm[:, None])
        for n, k in enumerate(own):
            driven[k] = rows[:, n]
            joints[k] = np.concatenate([shifts[:, n], turns[:, n]], axis=1)
    return Actuations(centre, arms, np.stack(driven, axis=1), np.stack(joints, axis=1), tuple(held), tuple(locked))


def _about_centre(wrenches: Floats, arm: Floats, size: float) -> Floats:
    """Wrenches (m/ρ; f) at an arm (N, 3) from the centre as (f; m) about the centre."""
    f = wrenches[..., 3:6]
    return np.concatenate([f, size * wrenches[..., :3] + crossed(arm[:, None], f)], axis=-1)
