r"""Pictures of certificates: the boxes over one coordinate or two; over more slices along each pair of coordinates.

A slice shows the boxes that the plane of two coordinates passes through where all others are those of one pose.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from gcrules.poses.certificates.certificate import Certificate
from gcrules.views.drawing.palette import LIGHT
from gcrules.views.plots.box_drawing import Parts, add_key, boxes_of, draw_boxes, frame, label_pair, words_of
from gcrules.views.plots.box_plot import WIDTH, flat
from gcrules.views.plots.saving import saved
from gcrules.views.results.certificate_place import ShownPlace, shown_place

__all__ = ["figure", "picture"]

_MARK: Any = {"ls": "", "marker": "o", "ms": 6, "mfc": "none", "mec": LIGHT["ink"], "mew": 1.3}
_ASIDE = 1e-9  # of a range; boxes are larger


def picture(c: Certificate, kind: str) -> bytes:
    """The bytes of a picture: svg, pdf or png."""
    return saved(lambda: figure(c), f"Boxes of poses of {c.task.mechanism.title}", kind)


def figure(c: Certificate) -> Figure:
    """The picture as a figure of matplotlib."""
    at = shown_place(c)
    made, parts = _flat(c, at) if len(c.axes) < 3 else _slices(c, at)
    words = _words(c)
    mark = [Line2D([], [], **_MARK, label=at.words)] if at.marked else []
    add_key(made, {name: words[name] for name in parts}, *mark)
    return made


def _words(c: Certificate) -> dict[str, str]:
    """What the key says of each kind of boxes."""
    least = {"free": f"free, σ ≥ {c.bound:.4g}"} if c.bound else {}
    outside = {"outside": "not reached within the limits"} if c.asked.limited else {}
    return {**words_of(c), **least, **outside}


def _flat(c: Certificate, at: ShownPlace) -> tuple[Figure, Parts]:
    made, axes, parts = flat(c)
    _mark(axes, at, 0, 1 if len(c.axes) == 2 else None)
    return made, parts


def _mark(axes: Axes, at: ShownPlace, first: int, second: int | None) -> None:
    if at.marked:
        axes.plot(at.place[first], 0.5 if second is None else at.place[second], zorder=4, clip_on=False, **_MARK)


def _slices(c: Certificate, at: ShownPlace) -> tuple[Figure, Parts]:
    """For each pair of coordinates a slice; and all kinds of boxes that one of them shows."""
    n, every, place = len(c.axes), boxes_of(c), _within(c, at.place)
    made = Figure(figsize=(WIDTH, WIDTH), layout="constrained")
    FigureCanvasAgg(made)
    grid = made.add_gridspec(n - 1, n - 1)
    drawn: set[str] = set()
    for i in range(n):
        for j in range(i + 1, n):
            axes = made.add_subplot(grid[j - 1, i])
            first, second = c.axes[i], c.axes[j]
            parts = _through(every, place, [k for k in range(n) if k not in (i, j)])
            draw_boxes(axes, parts, i, j)
            _mark(axes, at, i, j)
            drawn |= set(parts)
            frame(axes, first, second)
            axes.set_aspect("auto")
            label_pair(axes, first, second, (i, j), n - 1)
    made.suptitle(c.task.mechanism.title, fontsize=11)
    return made, {name: ends for name, ends in every.items() if name in drawn}


def _through(parts: Parts, at: NDArray[np.float64], others: list[int]) -> Parts:
    """The boxes that hold the other coordinates of a place."""
    found = {}
    for name, (low, high) in parts.items():
        some = ((low[:, others] <= at[others]) & (at[others] < high[:, others])).all(axis=1)
        if some.any():
            found[name] = (low[some], high[some])
    return found


def _within(c: Certificate, place: tuple[float, ...]) -> NDArray[np.float64]:
    """A place on a border of boxes a little above it, where the range goes on."""
    start, stop = (np.array([float(getattr(a, end)) for a in c.axes]) for end in ("start", "stop"))
    return np.asarray(np.minimum(np.array(place) + _ASIDE * (stop - start), stop - _ASIDE * (stop - start)))
