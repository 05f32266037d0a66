"""The words that maps of whole boxes and certificates share: how much of a range is free or not, and why."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from gcrules.poses.maps.axes import GridAxis
from gcrules.views.formulas.latex_text import latex_quantity, latex_words
from gcrules.views.text_tables import table

__all__ = [
    "PROOF",
    "Share",
    "latex_ranges",
    "latex_shares",
    "named_rows",
    "parted",
    "parts_of",
    "percent",
    "place_words",
    "share_rows",
]

PROOF = (
    "in a free box the wrenches hold the platform at all poses, by Taylor models of second order with bounds of all "
    "that they leave out and of rounding"
)
"""Why a box is free."""


def percent(share: float) -> str:
    """A share in percent; what is not all, and not nothing, is not shown as if it were."""
    shown = f"{100 * share:.3g}"
    if shown == "100" and share < 1:
        shown = f"{min(100 * share, 99.9999):.6g}"
    return f"{shown} %"


def share_rows(shares: Sequence[float], limited: bool, bad: str) -> Iterator[tuple[str, str]]:
    """Rows of the shares of free, free with the other sign, outside, crossed (boxes that hold `bad`) and undecided
    boxes, in this order; `limited` where more than the range limits poses.
    """
    free, other, outside, crossed, undecided = shares
    yield "free", f"{percent(free)} of the volume" + (f", and {percent(other)} with the other sign" if other else "")
    if outside:
        yield "outside", f"{percent(outside)}: poses that are not reached" + (" within the limits" if limited else "")
    if crossed:
        yield "crossed", f"{percent(crossed)}: boxes that hold {bad}"
    if undecided:
        yield "undecided", percent(undecided)


Share = tuple[str, float, str]
"""Of a kind of boxes its name, its share of the volume, and both in words."""


def parts_of(shares: Sequence[float], bad: str) -> Iterator[Share]:
    """Each kind of boxes that occurs; crossed ones hold `bad`."""
    kinds = ("free", "free with the other sign", "not reached", f"in boxes that hold {bad}", "undecided")
    names = ("free", "other", "outside", "crossed", "undecided")
    for name, kind, share in zip(names, kinds, shares, strict=True):
        if share:
            yield name, share, f"{percent(share)} {kind}"


def parted(shares: Sequence[float], meets: str) -> str:
    """What both signs of the determinant say of ways between free boxes: " … every way from one to the other `meets`."
    Empty where only one occurs.
    """
    free, other, *_ = shares
    if not (free and other):
        return ""
    return (
        f" Both signs of the determinant occur ({percent(free)} and {percent(other)}): every way from one to the other "
        f"{meets}."
    )


def place_words(axes: Sequence[GridAxis], place: Sequence[float]) -> str:
    """A place in the units of the axes."""
    return ", ".join(f"{a.name} = {value:.5g}" for a, value in zip(axes, place, strict=True))


def named_rows(rows: Iterable[tuple[str, str]]) -> list[str]:
    """Lines of a table, in which a name that repeats the one above is left out."""
    rows = list(rows)
    before = ["", *(name for name, _ in rows)]
    return list(
        table([("" if name == last else name, value) for (name, value), last in zip(rows, before, strict=False)])
    )


def latex_ranges(axes: Iterable[GridAxis]) -> Iterator[tuple[str, str]]:
    """Rows of the coordinates and their ends."""
    for a in axes:
        ends = (latex_quantity(float(x), a.unit) for x in (a.start, a.stop))
        yield latex_words(a.name), " to ".join(ends)


def latex_shares(shares: Sequence[float]) -> Iterator[tuple[str, str]]:
    """Rows of the shares."""
    free, other, outside, crossed, undecided = shares
    for name, share in (("free", free + other), ("outside", outside), ("crossed", crossed), ("undecided", undecided)):
        yield name, latex_words(percent(share))
