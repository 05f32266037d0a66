r"""A plan as text and as LaTeX: the answer, the way, what excludes one, and how it was sought."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.core.floats import rounded_down
from gcrules.mechanisms.kinematics.targets import written
from gcrules.poses.paths.report import PathReport
from gcrules.poses.plans.report import Plan, Waypoint
from gcrules.screws.pose import Pose
from gcrules.views.formulas.latex_text import latex_quantity, latex_table, latex_words
from gcrules.views.results.path import written_pose
from gcrules.views.results.result_account import Facts, ResultAccount, Sentences
from gcrules.views.text_tables import ASCII, wrapped

__all__ = ["account", "as_latex", "as_text", "waypoint_margins", "waypoint_text"]


def as_text(p: Plan, *, unicode: bool = False) -> str:
    """The whole plan; without `unicode` in ASCII."""
    found = "\n".join(_lines(p))
    return found if unicode else found.translate(ASCII)


def account(p: Plan) -> ResultAccount:
    """What there is to say of it."""
    return ResultAccount(p.reason, (*_lists(p), Facts(tuple(_facts(p)))))


def _lists(p: Plan) -> Iterator[Sentences]:
    if p.poses:
        yield Sentences(tuple(map(waypoint_text, p.poses)), "Way, straight from pose to pose", numbered=True)
    if p.opposed:
        signs = (f"{o.expression}: {o.start:.4g} and {o.goal:.4g}" for o in p.opposed)
        yield Sentences(tuple(signs), "Opposite signs at start and goal")


def _lines(p: Plan) -> Iterator[str]:
    yield from wrapped(p.reason)
    yield ""
    for block in _lists(p):
        yield block.title
        for k, words in enumerate(block.lines):
            yield from wrapped(
                f"{k}. {words}" if block.numbered else words, "  ", "     " if block.numbered else "    "
            )
        yield ""
    for name, words in _facts(p):
        yield from wrapped(words, f"{name:<9}", " " * 9)


def _facts(p: Plan) -> Iterator[tuple[str, str]]:
    if not p.poses:
        yield "start", waypoint_text(p.start)
        if p.goal is not None:
            yield "goal", waypoint_text(p.goal)
    sure = "proved everywhere" if p.proved else "at the samples of the path"
    if p.poses:
        end = "" if p.end_margin is None else f"; {p.end_margin:.4g} at its end"
        yield "margin", f"σ ≥ {rounded_down(p.least)}, {sure}{end}; asked for: {p.asked:.4g}"
        yield (
            "length",
            f"{p.length:.4g}, the straight way {p.straight:.4g} (angles in rad, lengths divided by the robot's size"
            f" {p.size:.4g})",
        )
    elif p.outcome == "undecided":
        yield "margin", f"σ ≥ {p.asked:.4g} asked for"
    if p.search is not None:
        yield "sought", f"{p.search.states:,} states, seed {p.search.seed}, in {p.search.region}"
        if p.search.limits:
            sure = ", proved everywhere" if p.limits_proved else ", at the samples of the path"
            yield "limits", f"{p.search.limits}{sure if p.poses else ''}"
    yield "proof", _proof(p)
    for note in p.notes:
        yield "note", note


def _proof(p: Plan) -> str:
    if p.poses:
        but = "" if p.outcome == "way" else ", but for the margin between its samples"
        return f"that of `gcrules path` through these poses{but}"
    if p.outcome == "none":
        return "a continuous number that is 0 in singular poses only has opposite signs at start and goal"
    return "none; more states, another seed or a smaller margin may decide it"


def waypoint_text(pose: Waypoint) -> str:
    """A pose as it is written for a command."""
    return written_pose(pose) if isinstance(pose, Pose) else written(pose).strip('"')


def waypoint_margins(p: Plan) -> list[float]:
    """The margin at each pose of the way."""
    if p.path is None:
        return []
    margins = p.path.numbers.margin if isinstance(p.path, PathReport) else p.path.margins
    places = p.path.parameters.searchsorted(range(len(p.poses)))
    return [float(margins[k]) for k in places]


def as_latex(p: Plan) -> str:
    """A tabular: the outcome, and the way or what excludes one; needs no package."""
    rows = [("outcome", p.outcome)]
    if p.poses:
        sure = "proved" if p.proved else "of the samples"
        rows.append((f"least margin $\\sigma$, {sure}", latex_quantity(float(rounded_down(p.least)))))
        rows += [(f"pose {k}", latex_words(waypoint_text(pose))) for k, pose in enumerate(p.poses)]
    rows += [("impossible without", latex_words(o.statement)) for o in p.opposed]
    return latex_table(rows)
