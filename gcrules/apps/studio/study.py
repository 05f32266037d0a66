"""The view of a subject that does not change with the pose: the structure, its stages, the condition."""

from __future__ import annotations

from math import log10
from typing import TYPE_CHECKING

from gcrules.algebra import expr as ex
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.text import text
from gcrules.apps.studio.accounts import account_view
from gcrules.apps.studio.drawings import schematic
from gcrules.apps.studio.formulas import pieces
from gcrules.apps.studio.limbs import robot_view
from gcrules.apps.studio.moving import actuator_axes, coordinate_axes, freedom_axes
from gcrules.apps.studio.protocol.study_views import Axis, ConditionView, EntryView, MeasureView, ModelView, Study
from gcrules.apps.studio.shape_view import shape_view
from gcrules.apps.studio.stages import stage_views
from gcrules.apps.studio.subject import Subject
from gcrules.conditions.analysis import Analysis
from gcrules.core.budget import report
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.mechanisms.kinematics.leg_amplification import LEGS
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.loci.slices import slices, why_no_locus
from gcrules.poses.maps.axes import TRANSLATION, TURNS
from gcrules.poses.methods import Methods, method
from gcrules.rules.condition import Condition
from gcrules.views.drawing.figures import distinct_entities
from gcrules.views.report.scene_json import entity_data
from gcrules.views.results.imported import limits_of
from gcrules.views.scene_data import EntityView

if TYPE_CHECKING:
    from gcrules.mechanisms.models.imported import Imported

__all__ = ["condition_view", "entity_views", "study"]

_TURN = 20.0  # degrees both ways, in a map of whole boxes to begin with
_PART = 0.2  # of a shift


def study(subject: Subject) -> Study:
    """Everything about the structure, for the page."""
    a, bodies, scenery = subject.analysis, subject.mechanism.bodies, subject.scenery
    report("stages")
    ranges = method(_RANGES, subject.mechanism, "a map")(subject)
    return {
        "title": subject.title,
        "note": subject.note,
        "kind": "robot" if subject.limbs else "platform",
        "legs": [list(leg) for leg in a.structure.joined if set(leg) <= set(subject.points)] if a else [],
        "base": list(bodies["base"]),
        "platform": list(bodies["platform"]),
        "points": {n: [float(c) for c in p] for n, p in subject.points.items()},
        "unit": subject.unit,
        "shape": shape_view(subject),
        "limits": subject.mechanism.limits,
        "invented": subject.invented,
        "about": subject.about,
        "size": subject.size,
        "axes": _axes(subject),
        "freedoms": freedom_axes(subject.limbs, subject.size) if subject.limbs else [],
        "ranges": ranges,
        "wholes": method(_WHOLES, subject.mechanism, "a map of whole boxes")(subject) if ranges else [],
        "measures": _measures(subject) if ranges else [],
        "loci": [list(pair) for pair in slices(subject.mechanism)] if ranges else [],
        "no_locus": why_no_locus(subject.mechanism) if ranges else "",
        "entry": _entry(a) if a else None,
        "schematic": schematic(a.structure) if a and a.structure.joined and a.structure.rank == 4 else "",
        "stages": stage_views(subject),
        "entities": entity_views(a) if a else [],
        "recipe": scenery.recipe if subject.moving and scenery and scenery.movable else None,
        "condition": condition_view(a.structure, a.condition) if a else _none(subject),
        "readings": [condition_view(a.structure, r) for r in a.readings] if a else [],
        "robot": robot_view(subject.robot, subject.mechanism.mobility, subject.home) if subject.robot else None,
        "model": _model(subject.model) if subject.model else None,
    }


def _model(found: Imported) -> ModelView:
    """What was read, and which joint of the model each actuator is."""
    limits = limits_of(found)
    return {
        **account_view(found),
        "drives": [
            {"name": q, "joint": joint, "limits": next((limits[n] for n in joint.split(" = ") if n in limits), "")}
            for q, joint in found.drives
        ],
    }


def _axes(subject: Subject) -> list[Axis]:
    """Three shifts and three turns of a platform; the actuators of a robot with limbs."""
    if subject.limbs:
        return actuator_axes(subject.limbs, subject.size)
    if not subject.mechanism.bodies["platform"]:
        return []
    reach, unit = 1.5 * subject.size, subject.unit
    step = 10.0 ** round(log10(subject.size) - 2.7)
    shifts: list[Axis] = [{"name": n, "unit": unit, "low": -reach, "high": reach, "step": step} for n in "xyz"]
    turns: list[Axis] = [{"name": f"r{n}", "unit": "deg", "low": -90.0, "high": 90.0, "step": 0.1} for n in "xyz"]
    return shifts + turns


def _ranges_of_legs(m: SixLegs, subject: Subject) -> list[Axis]:
    """Three shifts and three turns; none where the platform has no numbers."""
    return _axes(subject) if subject.moving else []


_RANGES: Methods[list[Axis]] = {
    SixLegs: _ranges_of_legs,
    Limbs: lambda m, subject: coordinate_axes(m, subject.size),
}


def _wholes_of_legs(m: SixLegs, subject: Subject) -> list[Axis]:
    """The six coordinates of a pose, its turns as roll, pitch and yaw."""
    shifts = [axis for axis in _axes(subject) if axis["name"] in TRANSLATION]
    turns: list[Axis] = [{"name": n, "unit": "deg", "low": -90.0, "high": 90.0, "step": 0.1} for n in TURNS]
    return [_narrowed(axis) for axis in shifts + turns]


def _wholes_of_limbs(m: Limbs, subject: Subject) -> list[Axis]:
    """Its coordinates without its actuators."""
    return [_narrowed(a) for a in coordinate_axes(m, subject.size) if a["name"] in (*TRANSLATION, *TURNS)]


def _narrowed(axis: Axis) -> Axis:
    """A range that a robot may well be free in."""
    part = _TURN / axis["high"] if axis["name"] in TURNS else _PART
    return {**axis, "low": part * axis["low"], "high": part * axis["high"]}


_WHOLES: Methods[list[Axis]] = {SixLegs: _wholes_of_legs, Limbs: _wholes_of_limbs}


def _measures(subject: Subject) -> list[MeasureView]:
    """The margin, and what actuators of these kinds have."""
    limbs = subject.limbs
    own = limbs.drives if limbs else LEGS
    units = {name: INDICES[name].unit(subject.unit, own.angles) for name in own.indices}
    margin: MeasureView = {"name": "margin", "meaning": "margin σ, 0 where singular", "unit": ""}
    others: list[MeasureView] = [{"name": n, "meaning": INDICES[n].meaning, "unit": u} for n, u in units.items()]
    return [margin, *others]


def _entry(a: Analysis) -> EntryView | None:
    return {"id": a.match.entry.id, "name": a.match.entry.name or ""} if a.match else None


def entity_views(a: Analysis) -> list[EntityView]:
    """The entities that the figures show, in the same colours."""
    if a.structure.rank != 4:
        return []
    return [entity_data(e, i) for i, e in enumerate(distinct_entities(a))]


def condition_view(s: Structure, c: Condition) -> ConditionView:
    """An identity in pieces: cofactor · superbracket = coefficient · expression."""
    names = s.names
    return {
        "kind": c.kind,
        "left": pieces(ex.mul(c.cofactor, s.superbracket)),
        "right": pieces(c.right_side),
        "text": text(c.right_side, unicode=True, names=names),
        "cofactor": text(c.cofactor, unicode=True, names=names),
        "statement": c.sentence,
        "certificate": {"method": c.certificate.method, "detail": c.certificate.detail},
    }


def _none(subject: Subject) -> ConditionView:
    """Of a robot whose wrenches are no lines there is a sentence only."""
    assert subject.robot is not None
    return {
        "kind": "none",
        "left": [],
        "right": [],
        "text": "",
        "cofactor": "1",
        "statement": subject.robot.statement,
        "certificate": {"method": "random-points", "detail": subject.robot.certificate},
    }
