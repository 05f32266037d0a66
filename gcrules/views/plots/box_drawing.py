r"""How boxes of poses are drawn over one coordinate or two: colours, words of the key, patches.

Colours are those of maps, told apart by colour-blind readers and in grey.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Protocol

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from gcrules.poses.boxes.task import BoxTask
from gcrules.poses.boxes.trees import Leaves
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED
from gcrules.views.drawing.palette import LIGHT

__all__ = ["COLOURS", "Boxed", "Parts", "add_key", "boxes_of", "draw_boxes", "frame", "label_pair", "words_of"]

Floats = NDArray[np.float64]
Parts = Mapping[str, tuple[Floats, Floats]]
"""Of each kind of boxes that occurs lower and upper ends (N, n) in the units of the axes."""

COLOURS: Mapping[str, str] = {
    "free": "#B5D3EC",
    "other": "#5A98C8",
    "outside": "#ECECEC",
    "crossed": LIGHT["entity2"],
    "undecided": "#E69F00",
}
"""By the kinds of boxes, in the sequence in which they are drawn."""
_THIN = ("crossed", "undecided")  # small ones are seen, too
_MANY = 1_500  # boxes are drawn as pixels


class Boxed(Protocol):
    """A map of whole boxes, or a certificate."""

    @property
    def task(self) -> BoxTask: ...

    @property
    def axes(self) -> tuple[GridAxis, ...]: ...

    def leaves(self, tile: int) -> Leaves: ...


def boxes_of(m: Boxed) -> Parts:
    """All boxes that are not cut, by their kinds."""
    parts: dict[str, list[tuple[Floats, Floats]]] = {name: [] for name in COLOURS}
    units = m.task.units
    for tile in range(m.task.number):
        leaves = m.leaves(tile)
        for name, some in _kinds(leaves).items():
            middles, halves = leaves.boxes.middles[some], leaves.boxes.halves[some]
            parts[name].append(((middles - halves) / units, (middles + halves) / units))
    found = {n: (np.concatenate([p[0] for p in own]), np.concatenate([p[1] for p in own])) for n, own in parts.items()}
    return {name: ends for name, ends in found.items() if len(ends[0])}


def _kinds(leaves: Leaves) -> dict[str, NDArray[np.bool_]]:
    free = leaves.status == FREE
    return {
        "free": free & ~leaves.negative,
        "other": free & leaves.negative,
        "outside": leaves.status == OUTSIDE,
        "crossed": leaves.status == CROSSED,
        "undecided": leaves.status == UNDECIDED,
    }


def words_of(m: Boxed) -> Mapping[str, str]:
    """What the key says of each kind."""
    return {
        "free": "free, proved",
        "other": "free, other sign",
        "outside": "not reached",
        "crossed": f"holds a {'pose below the margin' if m.task.margin else 'singular pose'}",
        "undecided": "undecided",
    }


def draw_boxes(axes: Axes, parts: Parts, first: int, second: int | None) -> None:
    """Boxes over two of their coordinates, by their places; over one as stripes."""
    for name, (low, high) in parts.items():
        left, right, bottom, top = low[:, first], high[:, first], *_across(low, high, second)
        corners = np.stack(
            [np.stack(c, axis=1) for c in ((left, bottom), (right, bottom), (right, top), (left, top))], axis=1
        )
        style: Any = {"edgecolor": "white", "lw": 0.35, "zorder": 2}
        if name in _THIN:
            style = {"edgecolor": COLOURS[name], "lw": 0.8, "zorder": 3}
        axes.add_collection(
            PolyCollection(list(corners), facecolor=COLOURS[name], rasterized=len(corners) > _MANY, **style)
        )


def _across(low: Floats, high: Floats, second: int | None) -> Iterator[Floats]:
    if second is None:
        yield np.zeros(len(low))
        yield np.ones(len(low))
    else:
        yield low[:, second]
        yield high[:, second]


def frame(axes: Axes, first: GridAxis, second: GridAxis | None) -> None:
    """The ends of the coordinates; equal scales where they are of one kind."""
    axes.set(xlim=(float(first.start), float(first.stop)))
    if second is None:
        axes.set(ylim=(0, 1), yticks=[])
        return
    axes.set(ylim=(float(second.start), float(second.stop)))
    if first.unit == second.unit and first.kind == second.kind:
        axes.set_aspect("equal")


def label_pair(axes: Axes, first: GridAxis, second: GridAxis, at: tuple[int, int], last: int) -> None:
    """The names and numbers of a pair of coordinates, one of all pairs up to the `last` coordinate: at the outer ones,
    below and on the left.
    """
    i, j = at
    axes.tick_params(direction="out", length=2.5, width=0.6, labelsize=7)
    axes.set(xlabel=first.label if j == last else "", ylabel=second.label if i == 0 else "")
    if j < last:
        axes.set_xticklabels([])
    if i > 0:
        axes.set_yticklabels([])


def add_key(made: Figure, words: Mapping[str, str], *more: Any) -> None:
    """The key of what is drawn, below it: kinds of boxes with what is said of them, and `more` that is drawn."""
    patches = [Patch(facecolor=COLOURS[n], edgecolor="#999999", lw=0.4, label=said) for n, said in words.items()]
    made.legend(handles=[*patches, *more], loc="outside lower center", ncols=3, frameon=False, fontsize=9)
