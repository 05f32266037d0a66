r"""Pictures of whole boxes of poses: the boxes themselves over two coordinates, over more what is left over each pair.

Colours are those of maps, told apart by colour-blind readers and in grey.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import PolyCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.boxes.trees import Leaves
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED
from gcrules.views.drawing.palette import LIGHT
from gcrules.views.plots.saving import saved

__all__ = ["figure", "picture"]

Floats = NDArray[np.float64]

_WIDTH = 6.3  # inches
_CELLS = 8  # of a raster, for each tile
_MANY = 1_500  # boxes are drawn as pixels
_FREE, _OTHER, _OUTSIDE = "#D8E6F2", "#7FB2D8", "#ECECEC"
_AMBER = "#E69F00"
_CROSSED = LIGHT["entity2"]
_LEFT = LinearSegmentedColormap.from_list("left", ["#F4F8FC", "#F6D9A0", _AMBER, _CROSSED])


def picture(m: BoxMap, kind: str) -> bytes:
    """The bytes of a picture: svg, pdf or png."""
    return saved(lambda: figure(m), f"Boxes of poses of {m.task.mechanism.title}", kind)[0]


def figure(m: BoxMap) -> Figure:
    """The picture as a figure of matplotlib."""
    return _pairs(m) if len(m.axes) > 2 else _flat(m)


def _flat(m: BoxMap) -> Figure:
    """The boxes over one coordinate or two."""
    two = len(m.axes) == 2
    made = Figure(figsize=(_WIDTH, 4.9 if two else 1.6), layout="constrained")
    FigureCanvasAgg(made)
    axes = made.add_subplot()
    drawn: dict[str, Any] = {}
    for name, colour, low, high in _coloured(m):
        if not two:
            low, high = (np.stack([c[:, 0], np.full(len(c), y)], axis=1) for c, y in ((low, 0.0), (high, 1.0)))
        corners = np.stack(
            [low, np.stack([high[:, 0], low[:, 1]], axis=1), high, np.stack([low[:, 0], high[:, 1]], axis=1)], axis=1
        )
        fine = name in ("crossed", "undecided")  # thin ones are seen, too
        style: Any = {"edgecolor": colour, "lw": 0.8, "zorder": 3} if fine else {"edgecolor": "white", "lw": 0.35}
        axes.add_collection(
            PolyCollection(list(corners), facecolor=colour, rasterized=len(corners) > _MANY, **{"zorder": 2, **style})
        )
        drawn.setdefault(name, Patch(facecolor=colour, edgecolor="#999999", lw=0.4, label=_label(m, name)))
    first = m.axes[0]
    axes.set(xlabel=first.label, xlim=(float(first.start), float(first.stop)))
    if two:
        second = m.axes[1]
        axes.set(ylabel=second.label, ylim=(float(second.start), float(second.stop)))
        if first.unit == second.unit and first.kind == second.kind:
            axes.set_aspect("equal")
    else:
        axes.set(ylim=(0, 1), yticks=[])
    axes.set_title(m.task.mechanism.title, fontsize=11)
    axes.tick_params(direction="out", length=3, width=0.7)
    made.legend(handles=list(drawn.values()), loc="outside lower center", ncols=3, frameon=False, fontsize=9)
    return made


_WORDS = {
    "free": "free, proved",
    "other": "free, other sign",
    "outside": "not reached",
    "crossed": "holds a singular pose",
    "undecided": "undecided",
}


def _label(m: BoxMap, name: str) -> str:
    return "holds a pose below the margin" if name == "crossed" and m.task.margin else _WORDS[name]


def _coloured(m: BoxMap) -> Any:
    """The boxes of each kind: its name and colour, and lower and upper ends in the units of the axes."""
    parts: dict[str, list[tuple[Floats, Floats]]] = {name: [] for name in _WORDS}
    for tile in range(m.task.number):
        leaves = m.leaves(tile)
        for name, some in _kinds(leaves).items():
            low = (leaves.boxes.middles[some] - leaves.boxes.halves[some]) / m.task.units
            high = (leaves.boxes.middles[some] + leaves.boxes.halves[some]) / m.task.units
            parts[name].append((low, high))
    colours = dict(zip(_WORDS, (_FREE, _OTHER, _OUTSIDE, _CROSSED, _AMBER), strict=True))
    for name, found in parts.items():
        low, high = (np.concatenate([p[k] for p in found]) for k in (0, 1))
        if len(low):
            yield name, colours[name], low, high


def _kinds(leaves: Leaves) -> dict[str, NDArray[np.bool_]]:
    free = leaves.status == FREE
    return {
        "free": free & ~leaves.negative,
        "other": free & leaves.negative,
        "outside": leaves.status == OUTSIDE,
        "crossed": leaves.status == CROSSED,
        "undecided": leaves.status == UNDECIDED,
    }


def _pairs(m: BoxMap) -> Figure:
    """For each pair of coordinates which part of what is reached is not proved free, over all others."""
    n = len(m.axes)
    made = Figure(figsize=(_WIDTH, _WIDTH), layout="constrained")
    FigureCanvasAgg(made)
    grid = made.add_gridspec(n - 1, n - 1)
    left = _rasters(m)
    top = max(max(float(np.nanmax(r, initial=0.0)) for r in left.values()), 1e-9)
    image = None
    for i, j in left:
        axes = made.add_subplot(grid[j - 1, i])
        first, second = m.axes[i], m.axes[j]
        extent = (float(first.start), float(first.stop), float(second.start), float(second.stop))
        axes.set_facecolor(_OUTSIDE)
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
        axes.tick_params(direction="out", length=2.5, width=0.6, labelsize=7)
        axes.set(xlabel=first.label if j == n - 1 else "", ylabel=second.label if i == 0 else "")
        if j < n - 1:
            axes.set_xticklabels([])
        if i > 0:
            axes.set_yticklabels([])
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
