r"""The pages of the robots: a gallery and a page for each robot as Markdown, with drawings as SVG.

Everything is computed from the robot files and their analyses, so that the pages are the same on every machine and can
be compared.
"""

from __future__ import annotations

import posixpath
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Superbracket
from gcrules.algebra.language.text import text
from gcrules.core.budget import report
from gcrules.core.english import in_parts
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.factor_causes import FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.lines.wrenches import LimbWrenches, WrenchLine
from gcrules.mechanisms.robot import Robot
from gcrules.poses.limbs.singular_members import SingularPose, live_parts, singular_pose
from gcrules.rules.plugin import ROBOT_FILE, shipped_folder
from gcrules.screws import RATIONALS
from gcrules.views.formulas.latex import latex_lines
from gcrules.views.pages.catalog_pages import bibliography
from gcrules.views.pages.markdown import inline, reference
from gcrules.views.pages.page_names import page_names
from gcrules.views.pages.robot_index import FIGURES, HEAD, MOST_POSES, gallery
from gcrules.views.pages.robot_pages_singular import singular_section
from gcrules.views.results.robot import CONDITION, FACTORS, LIMBS, LINES, OF_LIMBS, sections
from gcrules.views.robots.robot_drawing import draw_robot, draw_singular, robot_thumbnail

__all__ = ["FIGURES", "HEAD", "robot_pages"]

_WIDTH = 72
_SEED = 11
_ALONE = "The robot {where}, with those wrenches of its limbs that are lines of its points.{chosen}"
_CAPTION = (
    "On the left, the robot {where}, with the wrenches that its limbs apply when the actuators are locked;"
    " on the right, the lines that stand for them. Both are seen from the same viewpoint, and what belongs to a limb"
    " has its colour.{chosen}"
)
_CHOSEN = " That configuration is not home, and its dimensions may differ from those of home. {verdict}."


def robot_pages(robots: Sequence[Robot], only: Collection[str] = ()) -> dict[str, str]:
    """File names (relative to the folder of the pages) and contents. With ids in `only`, the pages of these robots
    alone, without the gallery.
    """
    names = page_names(r.id for r in robots)
    pages: dict[str, str] = {}
    found: list[RobotAnalysis] = []
    chosen = [r for r in robots if not only or r.id in only]
    for number, robot in enumerate(chosen, 1):
        report(f"{robot.id}, {number} of {len(chosen)}")
        a = analyze_robot(robot)
        found.append(a)
        name = names[robot.id]
        poses: list[tuple[FactorCause, SingularPose | None]] = []
        if robot.home is not None and robot.limbs:
            pages[f"{name}-robot.svg"] = draw_robot(a).svg()
            pages[f"{name}-small.svg"] = robot_thumbnail(a).svg()
            poses = [(part, singular_pose(a, part)) for part in live_parts(a)[:MOST_POSES]]
        for n, (_, pose) in enumerate(poses, 1):
            if pose:
                pages[f"{name}-singular-{n}.svg"] = draw_singular(a, pose).svg()
        pages[f"{name}.md"] = "\n".join(_page(a, name, poses, f"{name}-robot.svg" in pages))
    if not only:
        drawn = {r.id for r in robots if f"{names[r.id]}-small.svg" in pages}
        pages["index.md"] = gallery(found, names, drawn)
    return pages


def _page(
    a: RobotAnalysis, name: str, poses: Sequence[tuple[FactorCause, SingularPose | None]], drawn: bool
) -> Iterator[str]:
    robot = a.robot
    title = inline(robot.title)
    parts = [f"**{inline(part)}**" for part in in_parts(a.statement)]
    yield from (HEAD, f"# {title}", "", *(parts if len(parts) == 1 else (f"* {part}" for part in parts)), "")
    if drawn:
        yield from (f"![{title}: joints, wrenches and equivalent structure]({name}-robot.svg)", "")
        yield from (_caption(a), "")
    yield from _facts(a)
    for heading, lines in sections(a, True):
        yield from (f"## {_HEADINGS.get(heading, heading)}", "")
        if heading == LIMBS:
            yield from _limbs(a.structure.limbs)
        elif heading == LINES:
            yield from (*(_sentence(line[0].upper() + line[1:]) for line in lines), "", *_superbracket(a))
        elif heading == CONDITION and a.condition is not None and a.lines is not None:
            left = ex.mul(a.condition.cofactor, a.lines.structure.superbracket)
            yield from _formula(left, a.condition.right_side)
        else:
            yield from (_OF_LIMBS, "") if heading == OF_LIMBS else ()
            yield from (*(f"* {_sentence(line)}" for line in lines), "")
        if heading == FACTORS and poses:
            yield from singular_section(a, name, poses)
    yield from _file(robot)
    yield "[All robots](index.md) · [How a robot is described](../robots.md)"
    yield ""


def _caption(a: RobotAnalysis) -> str:
    """What the drawing shows, and where the robot stands in it, as sure as exact ranks are."""
    words, robot = _CAPTION if a.structure.lines else _ALONE, a.robot
    if robot.drawing is None:
        return words.format(where="at home", chosen="")
    here = ranks(robot.family, robot.limbs, robot.values_at(robot.drawing), RATIONALS)
    elsewhere = ranks(robot.family, robot.limbs, robot.family.member(_SEED))
    full = here.wrenches == elsewhere.wrenches
    verdict = "The wrenches have full rank in it" if full else "It is singular: the wrenches lose rank in it"
    return words.format(where="in a configuration chosen for the drawing", chosen=_CHOSEN.format(verdict=verdict))


_BY_THEMSELVES = "Singularities of the limbs by themselves"
_HEADINGS: Mapping[str, str] = {LIMBS: "Limbs", FACTORS: "Factors for this robot", OF_LIMBS: _BY_THEMSELVES}
_OF_LIMBS = "Only those of codimension one are looked for."


def _sentence(line: str) -> str:
    """A line of the report as a sentence of its own."""
    words = inline(line)
    return words if words.endswith((".", "?")) else f"{words}."


def _facts(a: RobotAnalysis) -> Iterator[str]:
    robot, s = a.robot, a.structure
    if robot.limbs:
        yield f"* Limbs: {inline(robot.chain)} (a star marks what is driven)"
        more = f", actuators beyond the freedoms {s.redundant}" if s.redundant else ""
        numbers = f"overconstraints {s.overconstraints}, idle freedoms in limbs {s.idle}{more}"
        yield f"* Mobility of the platform {s.mobility}, {numbers}"
    if robot.source:
        yield f"* Source: {_source(robot.source)}"
    if robot.note:
        yield f"* Note: {inline(robot.note)}"
    yield ""


def _source(words: str) -> str:
    """A source, the entry of the bibliography in place of its key."""
    key, _, rest = words.partition(" ")
    entry = bibliography().get(key)
    return " ".join(part for part in (entry or reference(key), inline(rest)) if part)


def _limbs(limbs: Sequence[LimbWrenches]) -> Iterator[str]:
    yield "| limb | joints, from base to platform | with the actuators locked it applies | lines |"
    yield "|---|---|---|---|"
    for limb in limbs:
        joints = "; ".join(limb.limb.lines)
        lines = ", ".join(map(_wrench, limb.lines)) if limb.lines is not None else "none of the robot's points"
        yield f"| {inline(limb.limb.name)} | {inline(joints)} | {inline(limb.kind)} | {inline(lines)} |"
    yield ""


def _wrench(line: WrenchLine) -> str:
    kind = "couple" if line.couple else "force"
    return f"{kind} {''.join(line.ends)}{' (constraint)' if line.role == 'constraint' else ''}"


def _superbracket(a: RobotAnalysis) -> Iterator[str]:
    if a.lines is None:
        return
    polynomial = a.lines.typed.polynomial
    shown = polynomial.to_expr() if polynomial else None
    if shown is not None:
        yield f"Their superbracket has {len(polynomial)} term{'s' * (len(polynomial) > 1)}:"
        yield ""
        yield from _formula(a.lines.structure.superbracket, shown)


def _formula(left: Expr | None, right: Expr) -> list[str]:
    """An equation, or an expression, as a displayed formula; long sums over several lines."""
    if isinstance(right, Superbracket) and left == right:
        left = None
    lines = [*([f"{line} =" for line in latex_lines(left, _WIDTH)] if left else []), *latex_lines(right, _WIDTH)]
    if len(lines) == 1:
        return [f"$${lines[0].removeprefix('&')}$$", ""]
    if left is not None and len(lines) == 2 and len(text(left)) + len(text(right)) < 64:
        return [f"$${lines[0].removeprefix('&')} {lines[1].removeprefix('&')}$$", ""]
    body = [line + (r" \\" if k < len(lines) - 1 else "") for k, line in enumerate(lines)]
    return ["$$", r"\begin{aligned}", *body, r"\end{aligned}", "$$", ""]


def _file(robot: Robot) -> Iterator[str]:
    yield "## The file to start from"
    yield ""
    path, shipped = Path(robot.filename), shipped_folder()
    if shipped and path.parent.parent.resolve() == shipped.resolve():
        target = posixpath.join("..", "..", "plugins", path.parent.name, ROBOT_FILE)
        yield f"[`plugins/{path.parent.name}/{ROBOT_FILE}`]({target}) describes this robot; copy it and change it."
    else:
        yield f"`{ROBOT_FILE}` in the folder `{inline(path.parent.name)}`."
    yield f"`gcrules robot analyze {robot.id}` prints the analysis, `gcrules robot new` writes a file to begin with."
    yield ""
