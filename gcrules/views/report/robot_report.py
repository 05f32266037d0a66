r"""The report of a robot that is described by its joints: limbs, equivalent lines, condition, factors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from html import escape
from math import dist
from typing import Any

from gcrules.algebra import expr as ex
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.factor_causes import KINDS, FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.limbs.exact_values import lines_at
from gcrules.poses.limbs.pose_report import report_of_limbs
from gcrules.poses.limbs.singular_members import live_parts
from gcrules.views.drawing.bsp import XYZ
from gcrules.views.drawing.figures import graph_figure
from gcrules.views.drawing.scene_parts import entity_label
from gcrules.views.drawing.solids import flat_normal
from gcrules.views.formulas.terms import formula_html
from gcrules.views.report.items import Formula
from gcrules.views.report.parts import answer_html
from gcrules.views.report.pose_section import pose_html
from gcrules.views.report.proof_section import proof_html
from gcrules.views.report.report_page import footer, page, robot_figure_html
from gcrules.views.report.scene_json import scene
from gcrules.views.report.standing import Standing
from gcrules.views.report.standing_sections import (
    bench_html,
    notes_html,
    numbers_here_html,
    repeating_html,
    started,
    view_html,
)
from gcrules.views.results.robot import CONDITION, FACTORS, factor_kind, leading_sentences, sections
from gcrules.views.robots.drawn_limb import unit_vector
from gcrules.views.robots.entities import DrawnFlat, entities
from gcrules.views.robots.limb_views import limb_views
from gcrules.views.robots.linkage_view import linkage_view
from gcrules.views.robots.robot_drawing import draw_robot
from gcrules.views.robots.skeleton import skeleton, unit_at
from gcrules.views.scene_data import LinkageView, PlaneView, SceneData

__all__ = ["moves", "robot_report", "robot_scene"]


def moves(a: RobotAnalysis) -> bool:
    """Whether the robot can be shown in 3D: it has a home, and does not stay in a plane."""
    return a.robot.home is not None and bool(a.robot.limbs) and not a.robot.family.plane


def robot_report(
    a: RobotAnalysis, *, live: bool = True, more: Sequence[str] = (), standing: Standing | None = None
) -> str:
    """The HTML page of a robot; drawn at home, if the file gives a home configuration, or as it is `standing`, and in
    3D in a page that is `live`. `more` are sections of what else was computed.
    """
    home = a.robot.home is not None and bool(a.robot.limbs)
    parts = [
        _header(a),
        f'<section class="answer">{_answer(a)}<p class="sure">{escape(a.certificate)}</p></section>',
        view_html(standing, a.robot.title),
        _figures(a, standing, home=home, live=live),
        numbers_here_html(standing) if standing else _at_home(Limbs.of(a)) if home else "",
        notes_html(standing),
        *more,
        "<h2>Step by step</h2>",
        '<ol class="stages">',
        *(f"<li><h3>{escape(title)}</h3>{body}</li>" for title, body in _stages(a)),
        "</ol>",
        proof_html(a),
        bench_html(standing),
        repeating_html(standing),
        footer(),
    ]
    return page(a.robot.title, parts, started(robot_scene(a) if live else None, standing))


def _at_home(m: Limbs) -> str:
    return pose_html(report_of_limbs(m), m, "Numbers at home")


def _answer(a: RobotAnalysis) -> str:
    return answer_html(leading_sentences(a))


def robot_scene(a: RobotAnalysis) -> SceneData:
    """The robot at home as the 3D viewer takes it: limbs with joints and wrenches, and the equivalent lines between
    finite points. A platform on six legs moves by its pose, other robots by their actuators (`linkage`).
    """
    robot = Limbs.of(a)
    try:
        return scene(robot.six_legs().analysis)
    except InputError:  # it has other limbs
        bodies = robot.bodies
    moving: LinkageView | None = None
    with suppress(InputError):  # then it stays at home
        moving = linkage_view(robot)
    values = {n: [float(c) for c in v] for n, v in a.robot.values_at().items()}
    sorts = a.robot.family.sorts
    legs = [list(leg) for leg in a.structure.legs if all(sorts.get(n) == "point" for n in leg)]
    shown = dict.fromkeys([*bodies["base"], *bodies["platform"], *(n for leg in legs for n in leg)])
    middle = [sum(values[n][i] for n in shown) / len(shown) for i in range(3)]
    found = entities(a, live_parts(a)) if a.lines else ()
    size = max(dist(values[n], middle) for n in shown) or unit_at(a.robot, values).radius  # all in one point
    shown_at_home: SceneData = {
        "points": {n: values[n] for n in values if sorts.get(n) == "point"},
        "base": list(bodies["base"]),
        "platform": list(bodies["platform"]),
        "legs": legs,
        "about": middle,
        "size": size,
        "unit": "",
        "entities": [
            {
                "id": f"e{i}",
                "kind": e.kind,
                "points": list(e.points),
                "label": entity_label(e.points),
                "starred": entity_label(e.points),
                "colour": _colour(a, e, i),
            }
            for i, e in enumerate(found)
            if all(sorts.get(n) == "point" for n in e.points)
        ],
        "limbs": limb_views(a, values),
        "skeleton": skeleton(a.robot, values),
        "planes": [p for i, e in enumerate(found) if (p := _far_plane(a, e, _colour(a, e, i), size))],
    }
    return shown_at_home if moving is None else {**shown_at_home, "linkage": moving}


def _colour(a: RobotAnalysis, e: DrawnFlat, number: int) -> int:
    """That of the limb whose line lies in the entity, or all whose points are a limb's; else one of its own."""
    names = set(e.points)
    place = {limb.limb.name: i for i, limb in enumerate(a.structure.limbs)}
    own = [place[line.limb] for line in a.structure.lines or () if names.issuperset(line.ends) and line.limb in place]
    ends = [{n for line in limb.lines or () for n in line.ends} for limb in a.structure.limbs]
    own += [i for i, all_ends in enumerate(ends) if names <= all_ends]
    return own[0] if own else len(place) + number


def _far_plane(a: RobotAnalysis, e: DrawnFlat, colour: int, size: float) -> PlaneView | None:
    """A plane through finite points along directions, which are points at infinity; None for other entities."""
    places = lines_at(a.robot.family, a.structure, a.robot.values_at())
    finite = [[float(c / places[n][3]) for c in places[n][:3]] for n in e.points if places[n][3]]
    along = [unit_vector(_xyz(places[n])) for n in e.points if not places[n][3]]
    if e.kind != "plane" or not along or not finite:
        return None
    corners = [*finite]
    for u in along:
        corners += [[c + s * size * k for c, k in zip(p, u, strict=True)] for p in finite for s in (-0.35, 0.35)]
    normal = flat_normal([_xyz(c) for c in corners])
    if normal is None:
        return None
    offset = sum(n * c for n, c in zip(normal, finite[0], strict=True))
    return {
        "label": entity_label(e.points),
        "normal": list(normal),
        "offset": offset,
        "through": corners,
        "colour": colour,
        "points": list(e.points),
    }


def _xyz(p: Sequence[Any]) -> XYZ:
    x, y, z = (float(c) for c in p[:3])
    return x, y, z


def _header(a: RobotAnalysis) -> str:
    words = [a.robot.id, a.robot.chain]
    if a.structure.limbs:
        words.append(f"mobility of the platform {a.structure.mobility}")
        words += [f"overconstraints {a.structure.overconstraints}"] if a.structure.overconstraints else []
        words += [f"actuators beyond the freedoms {a.structure.redundant}"] if a.structure.redundant else []
        words += [f"idle freedoms {a.structure.idle}"] if a.structure.idle else []
    sub = f'<p class="sub">{escape(" · ".join(filter(None, words)))}</p>'
    notes = [a.robot.note, f"Source: {a.robot.source}" if a.robot.source else ""]
    note = "".join(f'<p class="note">{escape(one)}</p>' for one in notes if one)
    return f"<header><h1>{escape(a.robot.title)}</h1>{sub}{note}</header>"


def _figures(a: RobotAnalysis, standing: Standing | None, *, home: bool, live: bool) -> str:
    graph = ""
    if a.lines is not None and a.lines.structure.joined and a.lines.structure.rank == 4:
        drawing = graph_figure(a.lines, key=False, bodies=False).svg()
        graph = f"<figure>{drawing}<figcaption>The equivalent lines as a graph</figcaption></figure>"
    robot = ""
    if home:
        here = standing.drawing if standing else ""
        where = "as it stands" if here else "at home"
        words = f"The robot {where} with the wrenches of its limbs, and the lines that stand for them"
        if here and standing and isinstance(standing.mechanism, SixLegs):
            words = "The six legs as they stand, with the entities of the condition"
        robot = robot_figure_html(here or draw_robot(a, a.robot.values_at()).svg(), words)
    if live:
        hint = "Drag to turn the view; the sliders move the robot."
        robot = robot_figure_html("", "The same in 3D", live=True, hint=hint) + robot
    return f'<div class="figures">{robot}{graph}</div>' if robot or graph else ""


def _stages(a: RobotAnalysis) -> Iterator[tuple[str, str]]:
    for title, lines in sections(a, True):
        if title == CONDITION and a.condition is not None and a.lines is not None:
            left = ex.mul(a.condition.cofactor, a.lines.structure.superbracket)
            yield title, formula_html(Formula(left, a.condition.right_side))
        elif title == FACTORS and a.parts:
            told = "".join(formula_html(Formula(None, p.expression)) + f"<p>{escape(_told(p))}</p>" for p in a.parts)
            yield title, told + "".join(f"<p>{escape(line)}</p>" for line in lines[len(a.parts) :])
        else:
            yield title, "".join(f"<p>{escape(line)}</p>" for line in lines)


def _told(p: FactorCause) -> str:
    """The kind of a factor, and where it vanishes."""
    said = f"zero where {p.statement}" if p.statement else ""
    return f"{factor_kind(p)}: {'; '.join(filter(None, [said, p.reason, p.remark])) or KINDS[p.kind]}."
