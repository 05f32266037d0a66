"""What a checker of certificates needs of a robot's geometry, without the means that made it.

Of six legs or rods these are points and axes, from which the checker makes all else. Of other robots of joints they are
the screws of the joints at home, with the closed forms of wrenches and actuators, which it compares with the joints.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from gcrules.core.errors import LimitReached
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Actuator
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.limb_amounts import amounts
from gcrules.poses.compiling.limb_programs import limb_places
from gcrules.poses.compiling.limb_reach import placing_roots, reach_is_seen
from gcrules.poses.compiling.limb_wrenches import limb_lines
from gcrules.poses.compiling.roots import NoForm
from gcrules.poses.compiling.tape import Program, lower
from gcrules.poses.compiling.turns import turned_by
from gcrules.poses.methods import Methods, method

__all__ = ["checkable", "geometry", "led", "placing_program", "program_lines"]


def geometry(m: Mechanism, names: tuple[str, ...]) -> dict[str, Any] | None:
    """Six legs or rods at home: of each its two `ends`, the point on the platform last, and its drive, a leg that
    stretches, a turn about an axis or a slide along a direction; the `centre` about which the platform turns. Of other
    robots the screws of each limb's joints and its end, the actuators, and programs of the wrenches and of the amounts
    of the actuators. None for robots of which the checker knows nothing.
    """
    found: dict[str, Any] | None = method(_GEOMETRY, m, "a certificate")(names)
    return found


def checkable(m: Limbs, names: tuple[str, ...], what: str, *, driven: bool = False) -> tuple[dict[str, Any], Program]:
    """The geometry of a robot whose limbs have closed forms, and the roots that all exist just where home's solutions
    of the limbs do, which stand in the geometry of other robots than those on six rods. Raises LimitReached for robots
    without them: `what` of them has no certificate; and where actuators are the coordinates.
    """
    if driven:
        raise LimitReached(
            f"a {what} over actuators has no certificate: no closed form tells the pose by them",
            hint=f"take a {what} over coordinates of the platform",
        )
    hint = _hint(what)
    _check_loops(m, what, hint)
    found, roots = geometry(m, names), placing_program(m, names)
    if found is None or roots is None:
        raise LimitReached(
            f"a {what} of {m.robot.id} has no certificate: no closed forms of all its limbs are known", hint=hint
        )
    return found if "rods" in found else {**found, "roots": program_lines(roots)}, roots


def led(m: Limbs, what: str) -> dict[str, Any]:
    """The geometry of a robot that is led by its actuators: six rods, or the screws of its joints at home and the
    actuators that lead. Raises LimitReached where a checker cannot close its loops: for loops inside limbs, and where
    there are not as many undriven amounts as equations.
    """
    hint, k = _hint(what), m.linkage
    _check_loops(m, what, hint)
    if found := _rods(m):
        return found
    limbs, known = _limbs(m), leading(k)
    free = sum(1 + max(limb["coordinates"]) - len(limb["held"]) for limb in limbs) - len(known)
    wanted = (3 if m.robot.family.plane else 6) * (len(limbs) - 1)
    if free != wanted or any(c.runs for c in k.home.chains):
        raise LimitReached(
            f"a {what} over actuators of {m.robot.id} has no certificate: its loops have {wanted} equations for {free} "
            "undriven amounts",
            hint=hint,
        )
    return {
        "centre": _plain(k.centre),
        "size": float(k.size),
        "plane": bool(m.robot.family.plane),
        "limbs": limbs,
        "actuators": _actuators(known),
    }


def _hint(what: str) -> str:
    return f"gcrules {what.split()[0]} gives its proof all the same; the file is for programs that recompute it"


def _check_loops(m: Limbs, what: str, hint: str) -> None:
    if m.linkage.looped:
        raise LimitReached(
            f"a {what} of {m.robot.id} has no certificate: it has loops inside its limbs, which no checker closes",
            hint=hint,
        )


def placing_program(m: Limbs, names: tuple[str, ...]) -> Program | None:
    """The roots over the coordinates `names` that all exist at a pose just where home's solutions of all limbs do; None
    where the roots that are known do not show whether each limb reaches a pose.
    """
    places = limb_places(m, Target(names, np.zeros(len(names)), text="home"), turned_by)
    if places is None:
        return None
    roots = placing_roots(m, places)
    return lower(places.graph, *roots) if reach_is_seen(m, places) else None


def _of_legs(m: SixLegs, _: tuple[str, ...]) -> dict[str, Any]:
    points = {n: [float(c) for c in p] for n, p in m.rig.points.items()}
    rods = [{"names": [a, b], "ends": [points[a], points[b]], "drive": "leg"} for a, b in m.rig.legs]
    return {"centre": _plain(m.rig.centre), "rods": rods}


def _of_limbs(m: Limbs, names: tuple[str, ...]) -> dict[str, Any] | None:
    return _rods(m) or _joints(m, names)


def _rods(m: Limbs) -> dict[str, Any] | None:
    k, rods = m.linkage, []
    driven = {a.place: a for a in k.actuators if a.coordinate == 0}
    for limb, structure in enumerate(m.analysis.structure.limbs):
        if structure.lines is None or len(structure.lines) != 1 or limb not in driven or not k.ball_ended[limb]:
            return None
        names = tuple(structure.lines[0].ends)
        if any(n not in k.home.values or m.robot.family.sorts.get(n) != "point" for n in names):
            return None
        far = [n for n in names if np.array_equal(k.home.values[n], k.ends[limb])]
        if len(far) != 1:
            return None
        start = names[0] if far[0] == names[1] else names[1]
        links = {a.link for a in k.attachments.get(start, ()) if a.limb == limb}
        screw = k.home.chains[limb].screws[0]
        if 1 not in links:
            return None
        found = {"names": [start, far[0]], "ends": [_plain(k.home.values[start]), _plain(k.ends[limb])]}
        if driven[limb].angle:
            axis = screw[:3]
            rods.append({**found, "drive": "turn", "axis": _plain(axis), "through": _plain(np.cross(axis, screw[3:]))})
        else:
            rods.append({**found, "drive": "slide", "axis": _plain(screw[3:])})
        rods[-1]["actuator"] = driven[limb].name
    return {"centre": _plain(k.centre), "rods": rods} if len(rods) == 6 else None


def _joints(m: Limbs, names: tuple[str, ...]) -> dict[str, Any] | None:
    k = m.linkage
    if k.looped or any(c.runs for c in k.home.chains):
        return None
    places = limb_places(m, Target(names, np.zeros(len(names)), text="home"), turned_by)
    if places is None:
        return None
    try:
        lines, counts = limb_lines(m, places)
    except NoForm:
        return None
    try:
        driven = program_lines(lower(places.graph, *amounts(places)))
    except NoForm:
        driven = None
    limbs = [
        {**limb, "ball": bool(ball), "wrenches": count}
        for limb, ball, count in zip(_limbs(m), k.ball_ended, counts, strict=True)
    ]
    return {
        "centre": _plain(k.centre),
        "names": list(names),
        "size": float(k.size),
        "plane": bool(m.robot.family.plane),
        "limbs": limbs,
        "actuators": _actuators(k.actuators),
        "wrenches": program_lines(lines),
        "amounts": driven,
    }


def _limbs(m: Limbs) -> list[dict[str, Any]]:
    """The joints of each limb at home, from the base to the platform."""
    k = m.linkage
    return [
        {
            "screws": [_plain(s) for s in chain.screws],
            "coordinates": list(chain.uses),
            "signs": _plain(chain.signs),
            "held": [at for limb, at, *_ in k.locked if limb == n],
            "end": _plain(k.ends[n]),
        }
        for n, chain in enumerate(k.home.chains)
    ]


def _actuators(known: Sequence[Actuator]) -> list[dict[str, Any]]:
    return [{"name": a.name, "limb": a.place, "coordinate": a.coordinate, "turns": bool(a.angle)} for a in known]


def program_lines(program: Program) -> dict[str, Any]:
    """Lines as [operation, operands …, constant], and the results: numbers of lines, or constants as text."""
    lines: list[list[Any]] = []
    for line in program.lines:
        constant = [str(line.constant)] if line.op in ("shift", "scale") else []
        lines.append([line.op, *line.args, *constant])
    return {"lines": lines, "results": [str(r) if isinstance(r, Fraction) else r for r in program.results]}


def _plain(v: Any) -> list[float]:
    return [float(c) for c in v]


_GEOMETRY: Methods[dict[str, Any] | None] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
