r"""Where a robot can go without a singularity: a search for a way, and its proof; or the proof that there is none.

The search draws poses at random and looks at ways between them at samples (`roadmap`); the way that is found is made
shorter and smoother, and then proved by `gcrules.poses.path_report`. Pieces that are not proved to be free of singular
poses, or to have the margin asked for everywhere, are left out, and the search goes on. Where in the end only the
margin of a way is not proved, that way is told, with its margin at samples: as the answer, or if the margin was named
as the best that was found.

>>> found = plan("3-rpr", "home", "x=0.1, y=0, yaw=10deg")
>>> found.outcome, len(found.poses), found.path.verdict
('way', 2, 'regular')
>>> there = plan("3-rpr", "home", "x=0, y=0, yaw=60deg")
>>> there.outcome, there.opposed[0].expression
('none', 'A1B1 /\\ A2B2 /\\ A3B3')
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.budget import report as report_progress
from gcrules.core.errors import GcrulesError, InputError
from gcrules.core.floats import rounded_down
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import Methods, method
from gcrules.poses.paths.least import CLOSEST
from gcrules.poses.plans.domain import Proved, search_in
from gcrules.poses.plans.drafts import drafts
from gcrules.poses.plans.leg_problem import leg_problem
from gcrules.poses.plans.limb_problem import limb_problem
from gcrules.poses.plans.problem import Problem
from gcrules.poses.plans.report import OpposedSign, Plan, Search, Waypoint
from gcrules.poses.plans.roadmap import SPREADS, Roadmap
from gcrules.poses.plans.way_out import nearest_with_margin
from gcrules.poses.signs.of_limbs import DETERMINANT
from gcrules.poses.signs.sign import SEEN, ConditionSign
from gcrules.screws.pose import exact_float
from gcrules.screws.verdict import CLOSE, SOLVED

__all__ = ["STATES", "asked_margin", "check_search", "plan", "plan_of"]

STATES = 3000
_MOST = 200_000
_FIRST, _LATER = 32, 256  # poses that are drawn at once
_TRIES = 40  # poses that are drawn for each state
_SAME = 1e-12
_KEPT = 0.9  # of the margin at the start, on a way out
_SPARE = 1.005  # times the margin that a way out leads to: room for rounding
_NO_WAY_OUT = "Not decided: no straight way was found to a pose with the margin asked for."
_ATTEMPTS = 8  # ways that are tried to be proved


def plan(
    source: Source,
    start: Any,
    goal: Any = None,
    *,
    margin: float | None = None,
    limits: str | None = None,
    within: str | None = None,
    states: int = STATES,
    seed: int = 0,
    about: str | Sequence[Any] = "centroid",
    plugins: Folders = (),
) -> Plan:
    """A way of a robot from one pose to another without a singularity, proved; or the proof that there is none. Without
    a goal the way out: the shortest one that is found to a pose with the `margin`.

    `source` and `about` are those of `pose`; `start` and `goal` are poses as for `path`, "home" among them. Everywhere
    on the way the margin σ is at least `margin`, by default that from which on a pose counts as regular: where that is
    not proved of any way, the plan is undecided if `margin` is given, else a way with its margin at samples. `limits`
    are ranges of the legs' lengths or the actuators' amounts as for `map`, `within` ranges of the platform's
    coordinates from home: x, y, z and turn of a platform on six legs ("z -100..50, turn ..40 deg"), else those that
    name its poses. The search ends at so many `states`; it is the same one for the same `seed`.

    On a way out the margin is never less than nine tenths of that at the start.

    Raises InputError where start or goal do not keep to what is asked for, and for what is no pose.
    """
    found = mechanism(source, about=about, plugins=plugins)
    return plan_of(found, start, goal, margin, limits, within, states, seed)


def plan_of(
    found: Mechanism,
    start: Any,
    goal: Any,
    margin: float | None = None,
    limits: str | None = None,
    within: str | None = None,
    states: int = STATES,
    seed: int = 0,
) -> Plan:
    """The plan of a mechanism; arguments and errors as for `plan`."""
    asked = asked_margin(margin)
    check_search(states, seed)
    of_kind = method(_PROBLEM, found, "a plan")

    def problem(goal: Any, asked: float) -> Problem:
        try:
            return of_kind(start, goal, asked, limits, within)
        except GcrulesError as fault:  # poses are read as those of --at are
            texts = {end: option for end, option in ((goal, "--to"), (start, "--from")) if isinstance(end, str)}
            if fault.filename == "--at" and fault.source in texts:
                fault.filename = texts[fault.source]
            raise

    if goal is None:
        return _way_out(problem, start, asked, states, seed)
    return _solved(problem(goal, asked), asked, states, seed, named=margin is not None)


def _way_out(problem: Callable[[Any, float], Problem], start: Any, asked: float, states: int, seed: int) -> Plan:
    """To a pose with the margin asked for, from one that has less."""
    p = problem(start, 0.0)
    sigma = float(p.domain.space.margins(p.roots[:1])[0])
    if sigma <= SOLVED:
        raise InputError("the start is singular", hint="a way out begins in a pose that is regular, however close")
    if sigma >= asked:
        raise InputError(
            f"at the start the margin is {sigma:.4g}, not less than the {asked:.4g} asked for",
            hint="a way out leads to a larger margin: ask for more by --margin, or name a goal",
        )
    kept = _KEPT * sigma
    p = problem(start, kept)
    end = nearest_with_margin(p.domain.space, p.roots[0], asked * _SPARE, np.random.default_rng(seed))
    if end is None:
        return replace(_plan(p, asked, "undecided", _NO_WAY_OUT), goal=None)
    found: Plan | None = None
    for rounded in (True, False):
        there = problem(p.domain.waypoint(end, rounded=rounded), kept)
        margin = float(there.domain.space.margins(there.roots[-1:])[0])
        if len(there.roots) > 1 and margin >= asked:
            found = replace(_solved(there, kept, states, seed, named=False), asked=asked, end_margin=margin)
            if found.outcome == "way":
                reason = f"{found.reason} It ends at a margin of {margin:.4g}, and is the shortest that was found."
                return replace(found, reason=reason)
    return found or replace(_plan(p, asked, "undecided", _NO_WAY_OUT), goal=None)


def asked_margin(margin: float | None) -> float:
    """The least margin that is asked for, or that of regular poses. Raises InputError."""
    asked = CLOSE if margin is None else exact_float(margin, "the margin")
    if not 0 < asked < 1:
        raise InputError(
            f"the margin {asked:g} does not lie between 0 and 1",
            hint="0 is singular, 1 as far from singular as possible",
        )
    return asked


def check_search(states: int, seed: int) -> None:
    """Raises InputError for a search with no states or too many, and for no seed."""
    if not 1 <= states <= _MOST:
        raise InputError(f"{states} states, expected 1 to {_MOST:,}")
    if seed < 0:
        raise InputError(f"the seed {seed} is negative")


def _solved(p: Problem, asked: float, states: int, seed: int, *, named: bool) -> Plan:
    """The answer. A margin that is `named` is proved, or nothing is decided."""
    if pairs := p.opposed():
        opposed = _named(pairs)
        found = _plan(p, asked, "none", _no_way(p, opposed), opposed=opposed)
        return found if any(a.proved for a, _ in pairs) else replace(found, notes=(*found.notes, SEEN))
    road = Roadmap(p.domain.space, p.roots)
    random = np.random.default_rng(seed)
    first: Proved | None = None
    best: tuple[Proved, list[Waypoint]] | None = None  # but for the proof of its margin
    close = float(p.domain.space.margins(p.roots).min()) * (1 - CLOSEST) < asked  # no proof up to there
    for _ in range(_ATTEMPTS):
        reached = None if close and best else _grown(p, road, random, states)
        if reached is None:
            break
        nodes = road.way(0, reached)
        for way in drafts(p.domain, p.start, p.goal, road.rows[nodes]):
            proved = p.domain.prove(way)
            if not proved.failures and not proved.doubts:
                search = search_in(p.domain, len(road.rows), seed)
                return _plan(p, asked, "way", _found(proved, way), way=way, proved=proved, search=search)
            if not proved.failures and (best is None or proved.least > best[0].least):
                best = proved, way
            first = first or proved
        road.forget((nodes[k], nodes[k + 1]) for k in {*proved.failures, *proved.doubts})
    search = search_in(p.domain, len(road.rows), seed)
    if best is None:
        return _plan(p, asked, "undecided", _undecided(road, first), search=search)
    proved, way = best
    outcome, reason = (
        ("undecided", _doubted(proved, way, asked, close=close)) if named else ("way", _found(proved, way))
    )
    return _plan(p, asked, outcome, reason, way=way, proved=proved, search=search)


def _named(pairs: Sequence[tuple[ConditionSign, ConditionSign]]) -> tuple[OpposedSign, ...]:
    """What has opposite signs; the determinant only where nothing else has."""
    named = [(a, b) for a, b in pairs if a.expression != DETERMINANT] or pairs
    return tuple(OpposedSign(a.expression, a.value, b.value, a.statement) for a, b in named)


def _grown(p: Problem, road: Roadmap, random: Any, states: int) -> int | None:
    """The state at the goal, once ways lead there; None where there are too many states before."""
    drawn = 0
    while True:
        reached = _at_goal(p, road)
        if reached is not None or len(road.rows) >= states or drawn > _TRIES * states:
            return reached
        checkpoint()
        report_progress(f"{len(road.rows):,} states, {drawn:,} poses drawn")
        number = _FIRST if drawn < _LATER else _LATER
        spread = SPREADS[min(drawn // (4 * _LATER), len(SPREADS) - 1)]
        goals = p.domain.space.drawn(random, number, np.stack([p.roots[0], p.end]), spread)
        if len(p.roots) < 2:
            goals = np.concatenate([goals, p.end[None]])
        if len(goals):
            road.grow(goals)
        drawn += number


def _at_goal(p: Problem, road: Roadmap) -> int | None:
    if len(p.roots) > 1:
        return 1 if road.joined(0, 1) else None
    apart = p.domain.space.lengths(road.rows, np.repeat(p.end[None], len(road.rows), axis=0))
    return next((int(n) for n in np.flatnonzero(apart <= _SAME) if road.joined(0, int(n))), None)


def _plan(
    p: Problem,
    asked: float,
    outcome: str,
    reason: str,
    *,
    way: Sequence[Waypoint] = (),
    proved: Proved | None = None,
    opposed: tuple[OpposedSign, ...] = (),
    search: Search | None = None,
) -> Plan:
    return Plan(
        title=p.domain.m.title,
        unit=p.domain.m.unit,
        outcome=outcome,
        reason=reason,
        asked=asked,
        start=p.start,
        goal=p.goal,
        poses=tuple(way),
        path=proved.path if proved else None,
        least=proved.least if proved else 0.0,
        proved=proved.margin_proved if proved else False,
        limits_proved=proved.limits_proved if proved else False,
        length=p.domain.length(way) if way else 0.0,
        straight=p.domain.length([p.start, p.goal]),
        size=p.domain.size,
        opposed=opposed,
        search=search,
        mechanism=p.domain.m,
        notes=p.notes,
    )


def _found(proved: Proved, way: Sequence[Waypoint]) -> str:
    pieces = len(way) - 1
    words = "The straight way is free" if pieces == 1 else f"A way of {pieces} straight pieces is free"
    sure = "everywhere on it" if proved.margin_proved else "at all samples of it"
    return f"{words} of singular poses, proved; the margin σ is at least {rounded_down(proved.least)} {sure}."


def _doubted(proved: Proved, way: Sequence[Waypoint], asked: float, *, close: bool) -> str:
    why = ", since the start or the goal has hardly more" if close else ""
    return (
        f"Not decided: for no way that was found is a margin of {asked:.4g} proved everywhere{why}. The best one:"
        f" {_found(proved, way)}"
    )


def _no_way(p: Problem, opposed: Sequence[OpposedSign]) -> str:
    words = ", and through one in which ".join(o.statement.rstrip(".") for o in opposed)
    return f"There is none, proved: every way to {p.whereto} passes through a pose in which {words}."


def _undecided(road: Roadmap, first: Proved | None) -> str:
    if first is not None:
        return f"Not decided: the ways that were found are not proved. {first.path.reason}"
    return (
        f"Not decided: of the {len(road.rows):,} states that were reached none joins start and goal, and no sign shows"
        " that there is no way."
    )


_PROBLEM: Methods[Problem] = {SixLegs: leg_problem, Limbs: limb_problem}
"""The method for each kind of mechanism."""
