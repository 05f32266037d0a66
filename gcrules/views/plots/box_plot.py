r"""Pictures of whole boxes of poses: the boxes over one coordinate or two, over more what is left over each pair."""

from __future__ import annotations

from itertools import product

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.maps.cells import FREE, OUTSIDE
from gcrules.views.plots.box_drawing import (
    COLOURS,
    Boxed,
    Parts,
    add_key,
    boxes_of,
    draw_boxes,
    frame,
    label_pair,
    words_of,
)
from gcrules.views.plots.saving import saved

__all__ = ["WIDTH", "figure", "flat", "picture"]

Floats = NDArray[np.float64]

WIDTH = 6.3  # inches
_CELLS = 8  # of a raster, for each tile
_LEFT = LinearSegmentedColormap.from_list("left", ["#F4F8FC", "#F6D9A0", COLOURS["undecided"], COLOURS["crossed"]])


def picture(m: BoxMap, kind: str) -> bytes:
    """The bytes of a picture: svg, pdf or png."""
    return saved(lambda: figure(m), f"Boxes of poses of {m.task.mechanism.title}", kind)


def figure(m: BoxMap) -> Figure:
    """The picture as a figure of matplotlib."""
    return _pairs(m) if len(m.axes) > 2 else _flat(m)


def _flat(m: BoxMap) -> Figure:
    """The boxes over one coordinate or two."""
    made, _, parts = flat(m)
    words = words_of(m)
    add_key(made, {name: words[name] for name in parts})
    return made


def flat(m: Boxed) -> tuple[Figure, Axes, Parts]:
    """The boxes over one coordinate or two, and what was drawn."""
    first, second = m.axes[0], m.axes[1] if len(m.axes) == 2 else None
    made = Figure(figsize=(WIDTH, 1.6 if second is None else 4.9), layout="constrained")
    FigureCanvasAgg(made)
    axes, parts = made.add_subplot(), boxes_of(m)
    draw_boxes(axes, parts, 0, None if second is None else 1)
    frame(axes, first, second)
    axes.set(xlabel=first.label, ylabel=second.label if second else "")
    axes.set_title(m.task.mechanism.title, fontsize=11)
    axes.tick_params(direction="out", length=3, width=0.7)
    return made, axes, parts


def _pairs(m: BoxMap) -> Figure:
    """For each pair of coordinates which part of what is reached is not proved free, over all others."""
    n = len(m.axes)
    made = Figure(figsize=(WIDTH, WIDTH), layout="constrained")
    FigureCanvasAgg(made)
    grid = made.add_gridspec(n - 1, n - 1)
    left = _rasters(m)
    top = max(max(float(np.nanmax(r, initial=0.0)) for r in left.values()), 1e-9)
    image = None
    for i, j in left:
        axes = made.add_subplot(grid[j - 1, i])
        first, second = m.axes[i], m.axes[j]
        extent = (float(first.start), float(first.stop), float(second.start), float(second.stop))
        axes.set_facecolor(COLOURS["outside"])
        image = axes.imshow(
            left[i, j].T,
            origin="lower",
            extent=extent,
            aspect="auto",
            cmap=_LEFT,
            vmin=0,
            vmax=top,
            interpolation="nearest",
        )
        label_pair(axes, first, second, (i, j), n - 1)
    assert image is not None
    bar = made.colorbar(
        image, ax=made.axes, location="top", shrink=0.5, aspect=40, pad=0.02, format=lambda v, _: f"{100 * v:.3g} %"
    )
    bar.set_label("not proved free, of what is reached: mean over all other coordinates")
    bar.ax.tick_params(length=2.5, width=0.6, labelsize=8)
    made.suptitle(m.task.mechanism.title, fontsize=11)
    return made


def _rasters(m: BoxMap) -> dict[tuple[int, int], Floats]:
    """For each pair i < j the part of the volume that is neither free nor outside, of what is not outside; not a number
    where all is outside.
    """
    n = len(m.axes)
    sides = [_CELLS * k for k in m.task.grid]
    left = {(i, j): np.zeros((sides[i], sides[j])) for i in range(n) for j in range(i + 1, n)}
    reached = {pair: np.zeros(r.shape) for pair, r in left.items()}
    start = np.array([float(a.start) for a in m.axes])
    step = np.array([float(a.step) for a in m.axes]) / _CELLS
    for tile in range(m.task.number):
        leaves = m.leaves(tile)
        some = leaves.status != OUTSIDE
        middles, halves = leaves.boxes.middles[some] / m.task.units, leaves.boxes.halves[some] / m.task.units
        low = np.floor((middles - halves - start) / step + 1e-6).astype(int)
        wide = np.maximum(np.rint(2 * halves / step), 1).astype(int)
        open_ = leaves.status[some] != FREE
        share = leaves.shares[some]
        for i, j in left:
            size = wide[:, [i, j]]
            for shape in np.unique(size, axis=0):
                same = (size == shape).all(axis=1)
                part = share[same] / shape.prod()
                for off in product(range(shape[0]), range(shape[1])):
                    at = (low[same, i] + off[0], low[same, j] + off[1])
                    np.add.at(reached[i, j], at, part)
                    np.add.at(left[i, j], at, part * open_[same])
    with np.errstate(invalid="ignore"):
        return {pair: np.where(reached[pair] > 0, r / reached[pair], np.nan) for pair, r in left.items()}
