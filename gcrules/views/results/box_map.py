r"""A map of whole boxes of poses as text, as LaTeX and as a picture: how much is free, outside, undecided, and why."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.core.deferred import deferred
from gcrules.core.english import listed
from gcrules.core.floats import rounded_down
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.boxes.task import MODES
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.results.box_shares import (
    PROOF,
    Share,
    latex_ranges,
    latex_shares,
    named_rows,
    parted,
    parts_of,
    percent,
    place_words,
    share_rows,
)
from gcrules.views.results.result_account import Facts, ResultAccount
from gcrules.views.text_tables import ASCII, wrapped

__all__ = [
    "account",
    "as_latex",
    "as_text",
    "decided",
    "leaves_nothing",
    "parts",
    "picture_of",
    "seen",
    "verdict",
]

picture = deferred("gcrules.views.plots.box_plot:picture")  # matplotlib, an extra of the installation


def as_text(m: BoxMap, *, unicode: bool = False) -> str:
    """The whole answer; without `unicode` in ASCII."""
    found = "\n".join(_lines(m))
    return found if unicode else found.translate(ASCII)


def _lines(m: BoxMap) -> Iterator[str]:
    yield from wrapped(verdict(m))
    yield ""
    yield from named_rows(_rows(m))


def account(m: BoxMap) -> ResultAccount:
    """What there is to say of it."""
    return ResultAccount(verdict(m), (Facts(tuple(_rows(m))),))


def _rows(m: BoxMap) -> list[tuple[str, str]]:
    return [*_asked(m), *_shares(m), *_proof(m)]


def verdict(m: BoxMap) -> str:
    """The answer in one sentence."""
    *_, outside, crossed, undecided = m.summary.shares
    q = m.task.question
    reached = "reached within the limits" if q.limits else "reached"
    pose = "pose of this range" + (f" that is {reached}" if outside or q.limits else "")
    least = f", and the margin is {m.task.margin:g} at least" if m.task.margin else ""
    beside = "" if q.always_reached else f", or poses that are not {reached}"
    apart = parted(m.summary.shares, f"passes a singular pose{beside}")
    match m.verdict:
        case "outside":
            return f"Proved: no pose of this range is {reached}."
        case "free":
            return f"Proved: no {pose} is singular{least}{_seen(m)}.{apart}"
        case "undecided":
            return f"No singular pose was found, but {percent(undecided)} of the range is undecided.{apart}"
    if not crossed:
        return f"This range is not free: there is a singular pose in what is undecided.{apart}"
    return f"This range is not free: boxes of {percent(crossed)} of it hold {_bad(m)}.{apart}"


def _seen(m: BoxMap) -> str:
    """The least margin that was seen, where none was asked for and none is proved."""
    least = m.summary.margin
    return (
        ""
        if m.task.margin or least is None
        else f"; the least margin seen, in the middles of boxes, is σ = {least:.4g}"
    )


def _asked(m: BoxMap) -> Iterator[tuple[str, str]]:
    q = m.task.question
    yield "map", f"whole boxes of poses of {m.task.mechanism.title or 'the robot'}"
    for a in m.axes:
        span = f"{a.name} from {float(a.start):g} to {float(a.stop):g} {a.unit}".rstrip()
        yield "over", f"{span}: {a.meaning}"
    if q.rest:
        yield "rest", q.rest
    if q.limits:
        yield "limits", q.limits.text
    if q.chosen:
        yield "mode", MODES[q.chosen]


def _shares(m: BoxMap) -> Iterator[tuple[str, str]]:
    s = m.summary
    yield from share_rows(s.shares, m.task.question.limits is not None, _bad(m))
    if s.margin is not None and s.place is not None:
        at = place_words(m.axes, s.place)
        yield "least", f"margin σ = {s.margin:.4g} in the middle of a free box, at {at}"
    if s.bound is not None:
        yield "", f"σ ≥ {rounded_down(s.bound)} in all free boxes, proved"


def _bad(m: BoxMap) -> str:
    """What a crossed box holds."""
    below = f", or has a margin below {m.task.margin:g}" if m.task.margin else ""
    return f"a pose that is singular{below}"


def _proof(m: BoxMap) -> Iterator[tuple[str, str]]:
    tiles = " × ".join(str(n) for n in m.task.grid)
    yield "boxes", f"{m.summary.boxes:,} in {tiles} tiles, at most {m.task.boxes:,} in each"
    yield "proof", f"{PROOF}."
    if m.task.question.chosen:
        yield "check", "the closed forms of the wrenches agree with the joints at poses at random"


def as_latex(m: BoxMap) -> str:
    """A tabular of the ranges and of the shares; needs no package."""
    rows = [*latex_ranges(m.axes), *latex_shares(m.summary.shares)]
    if m.summary.margin is not None:
        rows.append(("least margin $\\sigma$ in a middle", latex_quantity(m.summary.margin)))
    return latex_table(rows)


def picture_of(m: BoxMap) -> str | None:
    """The shares over each pair of coordinates as SVG; None where matplotlib is missing."""
    try:
        svg: bytes = picture(m, "svg")
    except ImportError:
        return None
    return svg.decode()


def leaves_nothing(m: BoxMap) -> bool:
    """Whether the picture would show what is left, and nothing is."""
    *_, crossed, undecided = m.summary.shares
    return len(m.axes) > 2 and not (crossed or undecided)


def decided(m: BoxMap) -> str:
    """How much is decided, in one sentence."""
    reached = "or not to be reached" + (" within the limits" if m.task.question.limits else "")
    less = f"to be free, {reached}" if not m.task.question.always_reached else "to be free"
    return f"{percent(m.summary.decided)} of the volume is decided: proved {less}."


def parts(m: BoxMap) -> Iterator[Share]:
    """Each kind of boxes that occurs."""
    return parts_of(m.summary.shares, _bad(m))


def seen(m: BoxMap) -> str:
    """What the picture shows, in words for those who do not see it."""
    names, title = listed([a.name for a in m.axes]), m.task.mechanism.title or "the robot"
    shares = [words for _, _, words in parts(m)]
    if len(m.axes) <= 2:
        return f"Boxes of poses of {title} over {names}: {listed(shares)}."
    return (
        f"For each pair of {names} which part of what is reached is not proved free, as a mean over all other "
        f"coordinates of {title}; of the whole range {listed(shares)}."
    )
