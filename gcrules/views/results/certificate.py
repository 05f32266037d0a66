r"""A certificate as text, as LaTeX and as a picture: whether the whole range is free, how much of it is proved, and by
what.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gcrules.core.deferred import deferred
from gcrules.core.english import listed
from gcrules.poses.boxes.task import MODES
from gcrules.poses.certificates.certificate import Certificate
from gcrules.views.detail import naming_options
from gcrules.views.formulas.latex_text import latex_quantity, latex_table, latex_words
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
from gcrules.views.results.certificate_place import shown_place
from gcrules.views.results.result_account import Facts, ResultAccount
from gcrules.views.text_tables import ASCII, wrapped

__all__ = [
    "account",
    "as_latex",
    "as_text",
    "captioned",
    "check",
    "decided",
    "parts",
    "picture_of",
    "place_text",
    "seen",
    "verdict",
]

picture = deferred("gcrules.views.plots.certificate_plot:picture")  # matplotlib, an extra of the installation


def as_text(c: Certificate, *, unicode: bool = False) -> str:
    """The whole answer; without `unicode` in ASCII."""
    found = "\n".join([*wrapped(verdict(c)), "", *named_rows([*_question(c), *_answer(c)])])
    return found if unicode else found.translate(ASCII)


def account(c: Certificate) -> ResultAccount:
    """What there is to say of it."""
    asked, proved = Facts(tuple(_question(c)), "What was asked"), Facts(tuple(_answer(c)), "What is proved")
    return ResultAccount(verdict(c), (asked, proved))


def verdict(c: Certificate) -> str:
    """The answer in one sentence."""
    asked = c.asked.task.margin
    reached = "that is reached within the limits" if c.asked.limited else "that is reached"
    inside = f" {reached}" if c.shares[2] or c.asked.limited else ""
    match c.verdict:
        case "free":
            return f"No singular pose in range{inside} (proved; {_between(c)}).{_parted(c)}"
        case "outside":
            return f"No pose of this range is {reached.removeprefix('that is ')} (proved)."
        case "singular":
            assert c.bad is not None
            at = place_text(c, c.bad.place)
            return f"There is a singular pose in range{inside} (proved by the sign of the determinant): {at}."
        case "below":
            assert c.bad is not None
            at = place_text(c, c.bad.place)
            return f"There is a pose in range{inside} whose margin is below {asked:g}, σ = {c.bad.margin:.3g}: {at}."
    proved, left = percent(c.decided), percent(c.shares[4])
    if c.holds:
        return f"No singular pose in {proved} of the range (proved); the rest, {left}, is undecided."
    return f"Not decided: {proved} of the range is proved, {left} of it is undecided; no singular pose was found."


_SUCH = "such a pose"


def _parted(c: Certificate) -> str:
    return parted(c.shares, "leaves the range, or what is reached within the limits")


def _between(c: Certificate) -> str:
    return f"smallest margin σ ≥ {c.bound or 0.0:.4g}"


def place_text(c: Certificate, place: Sequence[float]) -> str:
    """A place in the units of the axes, with them."""
    return ", ".join(f"{a.name} = {value:.6g} {a.unit}".rstrip() for a, value in zip(c.axes, place, strict=True))


def _answer(c: Certificate) -> Iterator[tuple[str, str]]:
    *_, crossed, undecided = c.shares
    yield from share_rows(c.shares, c.asked.limited, _SUCH)
    if c.bad is not None:
        yield "pose", f"{c.bad.at}{naming_options(' (as gcrules pose --at takes it)')}"
        yield "", f"margin σ = {c.bad.margin:.3g} there"
        for cause in c.bad.causes:
            yield "cause", cause
    if c.bound is not None:
        what = "in all boxes that are free" if undecided or crossed else "in all of it"
        yield "margin", f"σ ≥ {c.bound:.4g} {what}, proved"
    if c.least is not None and c.place is not None:
        at = place_words(c.asked.axes, c.place)
        yield "margin", f"σ = {c.least:.4g} at {at}: the smallest that was seen"
    yield "boxes", f"{c.boxes:,}"
    yield "proof", f"{PROOF}; free boxes, and those outside, fill what is proved."


def _question(c: Certificate) -> Iterator[tuple[str, str]]:
    a, q = c.asked, c.asked.task.question
    yield "range", f"poses of {a.mechanism.title or 'the robot'}"
    for axis in a.axes:
        yield "over", f"{axis.name} from {float(axis.start):g} to {float(axis.stop):g} {axis.unit}".rstrip()
    if q.rest:
        yield "rest", q.rest
    if a.tilt is not None:
        yield "limits", f"tilt ≤ {math.degrees(a.tilt):.6g} deg in any direction"
    if q.limits:
        yield "limits", q.limits.text
    if a.cones is not None:
        yield "limits", f"joints of rods within cones around their directions at home: {a.cones.text}"
    if a.task.margin:
        yield "asked", f"a margin of {a.task.margin:g} at least"
    yield "mode", MODES[q.chosen] + ("" if q.chosen else ": whatever assembly mode it belongs to")


def as_latex(c: Certificate) -> str:
    """A tabular of the ranges and of the answer; needs no package."""
    rows = [*latex_ranges(c.asked.axes), ("answer", latex_words(c.verdict)), *latex_shares(c.shares)]
    if c.bound is not None:
        rows.append(("margin $\\sigma$, at least", latex_quantity(c.bound)))
    return latex_table(rows)


def picture_of(c: Certificate) -> str | None:
    """The boxes, or slices through them, as SVG; None where matplotlib is missing."""
    try:
        svg: bytes = picture(c, "svg")
    except ImportError:
        return None
    return svg.decode()


def parts(c: Certificate) -> Iterator[Share]:
    """Each kind of boxes that occurs."""
    return parts_of(c.shares, _SUCH)


def decided(c: Certificate) -> str:
    """How much is decided, in one sentence."""
    return f"{percent(c.decided)} of the volume is proved, with {c.boxes:,} boxes."


def seen(c: Certificate) -> str:
    """What the picture shows, in words."""
    title = c.asked.mechanism.title or "the robot"
    over, shares = listed([a.name for a in c.axes]), listed([words for _, _, words in parts(c)])
    if len(c.axes) < 3:
        return f"Boxes of poses of {title} over {over}: {shares}."
    return f"{_slices(c)} Boxes of poses of {title}; of the whole range {shares}."


def captioned(c: Certificate) -> str:
    """What the picture shows, in short."""
    return f"{'Boxes of poses.' if len(c.axes) < 3 else _slices(c)} What is proved stands above."


def _slices(c: Certificate) -> str:
    at = shown_place(c)
    over = listed([a.name for a in c.axes])
    return f"Slices over each pair of {over} through {at.words}: {place_words(c.axes, at.place)}."


def check(c: Certificate) -> str:
    """How the certificate can be checked again, by what covers its robot and its verdict."""
    known = c.geometry
    of_joints = known is not None and "rods" not in known
    if known is None or (of_joints and c.asked.cones is not None):
        robot = "this robot with cones" if known else "this robot"
        return f"There is no independent checker for {robot} yet: what is proved of boxes is proved by gcrules alone."
    own = "with bounds of its own: it needs Python alone and shares no code with gcrules"
    if of_joints:
        own = f"{own}; the closed forms of the wrenches it compares with the joints at random places"
    again = f"`python checkers/check_certificate.py FILE` proves anew what the file says, box by box, {own}"
    return f"{again}; `gcrules checkers` writes the program."
