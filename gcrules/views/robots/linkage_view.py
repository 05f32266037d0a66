"""A robot's linkage as plain data, with which a page without a server moves it by its actuators."""

from __future__ import annotations

from typing import Any

from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.limb_file import BASE, PLATFORM, JointSpec, LimbSpec
from gcrules.mechanisms.description.relations import AXES, Term
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.limbs import Limbs
from gcrules.screws import JOINTS
from gcrules.screws.verdict import CLOSE, SOLVED
from gcrules.views.robots.carried_skeleton import carried_skeleton
from gcrules.views.robots.limb_views import drawn_parts
from gcrules.views.scene_data import ChainView, DrawnJoint, LinkageView, Terms, Vec3

__all__ = ["linkage_view"]


def linkage_view(robot: Limbs) -> LinkageView:
    """The linkage at home. Raises InputError for a robot without joints or without home, and where a name
    rides on no link.
    """
    m, structure = robot.linkage, robot.analysis.structure
    made = [d.name for d in m.robot.family.definitions if d.name not in m.attachments and not d.parameters]
    if made:
        raise InputError(f"no link carries {listed(made)}: relations make them in each configuration")
    lines = structure.drawn
    limbs = {limb.limb.name for limb in structure.limbs}
    rest = [list(one.ends) for one in lines if one.limb not in limbs]
    parts = list(drawn_parts(m.robot.limbs))
    drawn = [[list(one.ends) for one in lines if last and one.limb == limb.name] for limb, _, _, last in parts]
    return {
        "chains": [_chain(m, place) for place in range(len(m.home.chains))],
        "drives": [
            {"name": a.name, "text": f"{a.limb}: {a.joint}", "limb": a.place, "coordinate": a.coordinate}
            for a in leading(m)
        ],
        "follows": [[a.place, a.coordinate] for a in m.actuators if a not in leading(m)],
        "rides": {
            name: [[ride.limb, ride.link] for ride in rides]
            for name, rides in m.attachments.items()
            if name not in AXES
        },
        "points": _places(m, "point"),
        "directions": _places(m, "direction"),
        "derived": [{"name": d.name, "args": [_terms(term) for term in d.args]} for d in structure.derived],
        "joints": [[_joint(j) for j in joints] for _, _, joints, _ in parts],
        "ends": [m.robot.limbs.index(limb) if part.end == PLATFORM else None for limb, part, _, _ in parts],
        "rods": [rod for limb in m.robot.limbs for rod in _rods(limb)],
        "lines": [*drawn, rest] if rest else drawn,
        "bars": [[bar for j in joints for bar in _bars(j)] for _, _, joints, _ in parts],
        "spans": [
            {"limb": s.limb, "free": list(s.free), "rank": s.passive_rank, "start": s.start, "end": s.end}
            for s in (m.spans if m.looped else ())
        ],
        "skeleton": carried_skeleton(m),
        "locked": [[place, coordinate] for place, coordinate, _ in m.locked],
        "plane": m.robot.family.plane,
        "centre": _vec(m.centre),
        "size": m.size,
        "close": CLOSE,
        "floor": SOLVED,
    }


def _places(m: Linkage, sort: str) -> dict[str, Vec3]:
    return {n: _vec(m.home.values[n]) for n, own in m.robot.family.sorts.items() if own == sort}


def _chain(m: Linkage, place: int) -> ChainView:
    chain = m.home.chains[place]
    return {
        "screws": [[float(c) for c in row] for row in chain.screws],
        "uses": list(chain.uses),
        "signs": [float(s) for s in chain.signs],
        "turns": list(chain.turns),
        "end": _vec(m.ends[place]),
        "ball": m.ball_ended[place],
        "rank": m.ranks[place],
        "passive": m.passive_ranks[place],
        "applied": m.elsewhere.applied[place][1],
        "runs": [[run.first, run.stop, run.base, run.reached] for run in chain.runs],
        "platform": chain.platform,
        "shares": [[1] if chain.shares is None else [int(s) for s in chain.shares[k]] for k in range(len(chain.turns))],
    }


def _rods(limb: LimbSpec) -> list[list[Terms]]:
    """The bodies of a limb between its chains: from the middle of their joints to each, or between two of them."""
    found: list[list[Terms]] = []
    for body in dict.fromkeys(part.start for part, _ in limb.parts if part.start != BASE):
        places = [_far_end(joints[-1]) for part, joints in limb.parts if part.end == body]
        places += [_joint(joints[0])["point"] for part, joints in limb.parts if part.start == body]
        places = [p for p in places if p]
        found += [places] if len(places) == 2 else [[_mean(places), p] for p in places]
    return found


def _far_end(joint: JointSpec) -> Terms:
    """Where the last joint of a chain stands."""
    if joint.kind != "4S":
        return _joint(joint)["point"]
    first, second, bars = (arg for arg in joint.args if isinstance(arg, tuple))
    return _mean([_terms((*first, *bars)), _terms((*second, *bars))])


def _joint(joint: JointSpec) -> DrawnJoint:
    """Of what names the place and the axes of a joint are made that is drawn, as in `limb_views`."""
    forms = JOINTS[joint.kind].parts.values()
    given = [(form, arg) for form, arg in zip(forms, joint.args, strict=True) if isinstance(arg, tuple)]
    points = [_terms(arg) for form, arg in given if form == "point"]
    if not points and len(joint.names) == 2 and joint.kind == "P":
        points = [{n: 1.0} for n in joint.names]
    return {"point": _mean(points), "axes": [_terms(arg) for form, arg in given if form == "direction"]}


def _bars(joint: JointSpec) -> list[list[Terms]]:
    """Two parallel bars with ball ends and the rods that join these; the bar between two points of a parallelogram."""
    if joint.kind == "4S":
        first, second, bars = (arg for arg in joint.args if isinstance(arg, tuple))
        ends = [(_terms(one), _terms((*one, *bars))) for one in (first, second)]
        (a, c), (b, d) = ends
        return [[a, c], [b, d], [a, b], [c, d]]
    pair = joint.args[0] if joint.kind == "Pa" else ()
    if isinstance(pair, tuple) and len(pair) == 2:
        return [[{pair[1][1]: 1.0}, {pair[0][1]: 1.0}]]
    return []


def _mean(points: list[Terms]) -> Terms:
    found: Terms = {}
    for one in points:
        for name, c in one.items():
            found[name] = found.get(name, 0.0) + c / len(points)
    return found


def _terms(term: Term) -> Terms:
    found: Terms = {}
    for c, name in term:
        found[name] = found.get(name, 0.0) + float(c)
    return found


def _vec(v: Any) -> Vec3:
    return [float(c) for c in v]
