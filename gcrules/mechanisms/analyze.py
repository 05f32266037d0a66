r"""When and why any mechanism is singular: the analysis of whatever `load` reads.

>>> analyze("ab af cb cd ed ef")
<Analysis 3-3.3: four-planes, abc /\ aef /\ bdf /\ cde>
>>> analyze("3-rps")
<RobotAnalysis 3-rps: four-planes>
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.text import Names
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.dimensions.facts import TOLERANCE
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.seeds import remembered
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.load import Folders, Source, load
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.mechanisms.robot import Robot
from gcrules.rules.catalog.file import Own
from gcrules.rules.factorization import SECONDS
from gcrules.rules.strategy import Strategy

__all__ = ["analyze", "analyze_legs", "analyze_robot"]

_of_joints = deferred("gcrules.mechanisms.conditions.analyze_robot:analyze_robot")
_dimensions = deferred("gcrules.mechanisms.dimensions.robot_dimensions:dimensions_of_robot")


def analyze(
    source: Source,
    *,
    order: str | Sequence[int | str] | None = None,
    points: Names = (),
    ideal: Names = (),
    given: str | Iterable[str] = (),
    letters: str = "",
    rank: int = 4,
    catalogs: Iterable[Own] = (),
    recheck: bool = False,
    strategy: Strategy | None = None,
    search: float = SECONDS,
    plugins: Folders = (),
    facts: bool = True,
    tolerance: float = TOLERANCE,
) -> Analysis | RobotAnalysis:
    """The condition of legs or of a platform (an `Analysis`), or of a robot of joints (a `RobotAnalysis`).

    `source` is what `gcrules.load` takes, with `plugins`; what was analysed before is given back. A line that is no
    pair of joints is built from points: "abc /\\ def". `order` keeps the user's own order of legs instead of the
    shortest one; `points` declares long names, `ideal` the points at infinity, `given` what is assumed of points (as
    `gcrules.prove` takes it), `letters` which stand for lines or planes
    ("line L M"), and `rank` another space, in which there are n (n − 1) / 2 lines.

    `catalogs` adds files of the user's own, `plugins` folders whose rules and catalogs take part; `strategy` says which
    rules run, then those of `plugins` too where it names them. With `recheck` readings that are instances of catalog
    identities are proved from scratch. Where no rule finds a condition, a factorization is sought for `search` seconds.
    Of a platform with coordinates, and of a robot with a home, the `facts` of the dimensions are told, those too that
    are missed by up to the `tolerance` as a part of its size; `given` must hold of the coordinates. Raises InputError
    for the wrong number of lines, for what is no line, for assumptions that are not resolved or that coordinates
    contradict, and for options that the source does not take: robots of joints take `search`, `plugins`, `facts` and
    `tolerance` only.
    """
    loaded = load(source, plugins=plugins, points=points, ideal=ideal, given=given, letters=letters, rank=rank)
    options: dict[str, Any] = {
        "order": order,
        "points": points,
        "ideal": ideal,
        "given": given,
        "letters": letters,
        "rank": None if rank == 4 else rank,
        "catalogs": catalogs,
        "recheck": recheck,
        "strategy": strategy,
    }
    chosen = {name: value for name, value in options.items() if value}
    if isinstance(loaded, Structure) and loaded is not source:  # read with them just now
        read_with = ("points", "ideal", "given", "letters", "rank")
        chosen = {name: value for name, value in chosen.items() if name not in read_with}
    if isinstance(loaded, (Robot, Analysis, RobotAnalysis)) and chosen:
        what = f"the robot {loaded.id}" if isinstance(loaded, Robot) else "what was analysed before"
        hint = "they are for legs and platforms" if isinstance(loaded, Robot) else "analyze its structure again"
        raise InputError(f"{what} takes no options {', '.join(chosen)}", hint=hint)
    if isinstance(loaded, (Analysis, RobotAnalysis)):
        return loaded
    if isinstance(loaded, Robot):
        return analyze_robot(loaded, search=search, facts=facts, tolerance=tolerance)
    return analyze_legs(loaded, search=search, plugins=plugins, facts=facts, tolerance=tolerance, **chosen)


def analyze_robot(
    robot: Robot, *, search: float = SECONDS, facts: bool = False, tolerance: float = TOLERANCE
) -> RobotAnalysis:
    """The analysis of a robot of joints, made once, with the `facts` of its dimensions at home if they are asked for.
    Raises InputError for six lines that are no legs, and for a tolerance that is none.
    """
    return _with_facts(robot, search, tolerance) if facts else _analyzed(robot, search)


# Poses, paths and maps that are asked for one after the other are of the same few robots.
@remembered(64)
def _analyzed(robot: Robot, search: float) -> RobotAnalysis:
    found: RobotAnalysis = _of_joints(robot, search=search)
    return found


@remembered(64)
def _with_facts(robot: Robot, search: float, tolerance: float) -> RobotAnalysis:
    found = _analyzed(robot, search)
    return replace(found, dimensions=_dimensions(robot, found.parts, tolerance))
