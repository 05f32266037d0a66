r"""Pictures of maps through matplotlib: margin with singular curves, or singular surfaces from several sides.

Colours are told apart by colour-blind readers and in grey: margin from dark blue (near a singularity) to nearly
white, curves in vermilion with a white rim.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import BoundaryNorm, LinearSegmentedColormap, ListedColormap
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.poses.maps.cells import CROSSED, UNDECIDED
from gcrules.poses.maps.report import SingularMap
from gcrules.views.drawing.palette import LIGHT
from gcrules.views.plots.map_head import HEAD, add_head
from gcrules.views.plots.map_surface import views
from gcrules.views.plots.saving import saved

__all__ = ["figure", "picture"]

Floats = NDArray[np.float64]

_CURVE, _INK, _YELLOW, _AMBER = LIGHT["entity2"], LIGHT["ink"], "#F0E442", "#E69F00"
_SIGMA = LinearSegmentedColormap.from_list("margin", ["#08306B", "#2F74B5", "#7FB2D8", "#C6DCEE", "#F4F8FC"])
_BELOW, _ABOVE = "#F6E3D3", "#D8E6F2"
_WIDTH = 6.3  # inches
_MOST = 500  # nodes of each axis that are drawn
_FINE = 240  # places of each axis between which the margin is drawn
_FAR = 8.0


def picture(m: SingularMap, kind: str) -> bytes:
    """The bytes of a picture: svg, pdf or png."""
    return saved(lambda: figure(m), m.about["title"], kind)


def figure(m: SingularMap) -> Figure:
    """The picture as a figure of matplotlib."""
    return views(m) if len(m.grid.axes) == 3 else _flat(m)


def _flat(m: SingularMap) -> Figure:
    first, second = m.grid.axes
    span = [float(a.stop - a.start) for a in m.grid.axes]
    same = first.unit == second.unit and first.kind == second.kind
    tall = 0.78 * (min(max(span[1] / span[0], 0.55), 1.25) if same else 0.8)
    size = (_WIDTH, 0.75 + HEAD + tall * 5.0)
    made = Figure(figsize=size, layout=ConstrainedLayoutEngine(rect=(0, 0, 1, 1 - HEAD / size[1])))
    FigureCanvasAgg(made)
    axes = made.add_subplot()
    x, y, step = _places(m)
    extent = (float(first.start), float(first.stop), float(second.start), float(second.stop))
    handles: list[Any] = []
    if m.task.measure in INDICES:
        _index(m, made, axes, x, y, m.values(m.task.measure)[:: step[0], :: step[1]].astype(np.float64))
    elif "margin" in m.arrays:
        _margin(m, made, axes, x, y, _signed(m)[:: step[0], :: step[1]], handles)
    else:
        values = m.values("superbracket")[:: step[0], :: step[1]]
        axes.pcolormesh(
            x,
            y,
            (values >= 0).T,
            cmap=ListedColormap([_BELOW, _ABOVE]),
            vmin=0,
            vmax=1,
            shading="nearest",
            rasterized=True,
        )
        handles += [Patch(facecolor=c, edgecolor="#999999", lw=0.4, label=w) for c, w in _sign_words()]
    _undecided(m, axes, handles)
    for curve in m.curves:
        axes.plot(
            *curve.points.T,
            color=_CURVE,
            lw=1.8,
            solid_capstyle="round",
            solid_joinstyle="round",
            path_effects=[withStroke(linewidth=3.4, foreground="white")],
            zorder=4,
        )
    if m.curves:
        handles.insert(0, Line2D([], [], color=_CURVE, lw=1.8, label="singular"))
    if m.everywhere:
        axes.text(0.5, 0.5, "every pose is singular", transform=axes.transAxes, ha="center", fontsize=13)
    _limits(m, axes, handles)
    home = m.grid.home
    if extent[0] <= home[0] <= extent[1] and extent[2] <= home[1] <= extent[3]:
        style: Any = {"marker": "P", "ms": 8.5, "mfc": "white", "mec": _INK, "mew": 1.1, "ls": "none"}
        axes.plot(*home, **style, zorder=7, clip_on=False)
        handles.append(Line2D([], [], **style, label="given pose" if m.grid.moved else "home pose"))
    axes.set(xlabel=first.caption, ylabel=second.caption, xlim=extent[:2], ylim=extent[2:])
    add_head(made, m)
    axes.tick_params(direction="out", length=3, width=0.7)
    if same:
        axes.set_aspect("equal", adjustable="box" if 0.4 < span[1] / span[0] < 2.5 else "datalim")
        if not 0.4 < span[1] / span[0] < 2.5:
            axes.set_aspect("auto")
    if handles:
        style = {"columnspacing": 1.2, "handlelength": 1.7, "fontsize": 9}
        made.legend(handles=handles, loc="outside lower center", ncols=min(len(handles), 5), frameon=False, **style)
    return made


def _sign_words() -> list[tuple[str, str]]:
    return [(_ABOVE, "superbracket > 0"), (_BELOW, "superbracket < 0")]


def _places(m: SingularMap) -> tuple[Floats, Floats, list[int]]:
    step = [max(1, -(-a.number // _MOST)) for a in m.grid.axes]
    x, y = (a.nodes[::k] for a, k in zip(m.grid.axes, step, strict=True))
    return x, y, step


def _signed(m: SingularMap) -> Floats:
    """The margin at the nodes, below 0 where the determinant is: so it goes straight through 0 between nodes."""
    margin = m.values("margin").astype(np.float64)
    return np.where(m.level < 0, -margin, margin)


def _finer(nodes: Floats, values: Floats) -> tuple[Floats, Floats]:
    """Nodes between those of the first axis, and the values there, each between its two neighbours."""
    parts = max(1, -(-_FINE // (len(nodes) - 1)))
    places = np.arange(parts * (len(nodes) - 1) + 1) / parts
    low = np.minimum(places.astype(int), len(nodes) - 2)
    weight = (places - low)[:, None]
    between = np.where(weight > 0, (1 - weight) * values[low] + weight * values[low + 1], values[low])
    between = np.where(weight < 1, between, values[low + 1])
    return np.interp(places, np.arange(len(nodes)), nodes), between


def _margin(m: SingularMap, made: Figure, axes: Any, x: Floats, y: Floats, signed: Floats, handles: list[Any]) -> None:
    """Colours and threshold from what changes its sign at singular poses; from the margin itself they would be beads
    where the threshold is nearer to a curve than the nodes are.
    """
    top = float(np.nanmax(np.abs(signed), initial=0.0))
    x, values = _finer(x, signed)
    y, turned = _finer(y, values.T)
    values = turned.T
    _field(made, axes, x, y, np.abs(values), _bounds(top), _SIGMA, "margin σ (0 is singular)")
    if float(np.nanmin(np.abs(values), initial=1.0)) < m.sigma < top:
        rim: Any = {"path_effects": [withStroke(linewidth=2.0, foreground=_INK)]}
        style: Any = {"colors": [_YELLOW], "linewidths": 1.0, "linestyles": "solid", "zorder": 3}
        axes.contour(x, y, values.T, levels=[-m.sigma, m.sigma], **style).set(**rim)
        handles.append(Line2D([], [], color=_YELLOW, lw=1.0, label=f"threshold {m.threshold.text}", **rim))


def _index(m: SingularMap, made: Figure, axes: Any, x: Floats, y: Floats, values: Floats) -> None:
    """An index of the actuators, dark where it is bad; values beyond the bands have the colour of the last one."""
    index = INDICES[m.task.measure]
    shown = np.where(np.isfinite(values), values, np.nan)
    low, high = np.nanpercentile(shown, [2, 98]) if np.isfinite(values).any() else (0.0, 1.0)
    bounds = _bands(float(low), float(high))
    unit = index.unit(m.grid.unit, m.grid.angles_driven)
    label = f"{m.task.measure.replace('_', ' ')}{f' ({unit})' if unit else ''}"
    colours = _SIGMA if index.small else _SIGMA.reversed()
    beyond = 2 * bounds[-1] if not index.small else bounds[0] / 2
    _field(made, axes, x, y, np.where(np.isinf(values), beyond, values), bounds, colours, label)


def _bands(low: float, high: float) -> list[float]:
    """Round values around these two: ten bands or so, or 1, 2, 5, 10 … where they are far apart."""
    if low > 0 and high > _FAR * low:
        steps = [
            k * 10.0**p
            for p in range(*(int(np.floor(np.log10(x))) + n for x, n in ((low, 0), (high, 2))))
            for k in (1, 2, 5)
        ]
        first, last = sum(s <= low for s in steps) - 1, sum(s < high for s in steps)
        return steps[first : last + 1]
    width = max(high - low, 1e-9 * max(abs(low), abs(high)), 1e-300) / 8
    power = 10.0 ** np.floor(np.log10(width))
    step = next(float(k * power) for k in (1, 2, 5, 10) if k * power >= width)
    first, last = int(np.floor(low / step)), int(np.ceil(high / step))
    return [k * step for k in range(first, max(last, first + 1) + 1)]


def _field(
    made: Figure,
    axes: Any,
    x: Floats,
    y: Floats,
    values: Floats,
    bounds: list[float],
    colours: LinearSegmentedColormap,
    label: str,
) -> None:
    """Bands of colour between the bounds, with the bar that says what they are."""
    norm = BoundaryNorm(bounds, colours.N)
    dx, dy = (x[1] - x[0]) / 2, (y[1] - y[0]) / 2
    image = axes.imshow(
        values.T,
        origin="lower",
        extent=(x[0] - dx, x[-1] + dx, y[0] - dy, y[-1] + dy),
        cmap=colours,
        norm=norm,
        interpolation="bilinear",
        interpolation_stage="data",
        aspect="auto",
        zorder=1,
    )
    axes.contour(x, y, values.T, levels=bounds[1:-1] or bounds, colors="white", linewidths=0.35, alpha=0.7, zorder=2)
    bar = made.colorbar(image, ax=axes, pad=0.02, fraction=0.05, aspect=28, ticks=bounds, format="%g")
    bar.set_label(label)
    bar.outline.set_linewidth(0.6)
    bar.ax.tick_params(length=2.5, width=0.6)


def _bounds(top: float) -> list[float]:
    """From 0 to a round value not below the largest one, finer towards 0, ten bands or so."""
    steps = [s * 10.0**p for p in range(-7, -1) for s in (1, 2, 5)] + [k / 10 for k in range(1, 11)]
    stop = next((k for k, s in enumerate(steps) if s >= top), len(steps) - 1)
    return [0.0, *steps[max(stop - 8, 0) : stop + 1]]


def _undecided(m: SingularMap, axes: Any, handles: list[Any]) -> None:
    """Cells that are not proved free, but for seams of them that lie beside a curve and nowhere else."""
    if m.factors is None and m.task.measure == "value":
        return
    status = m.values("cell_status")
    undecided = status == UNDECIDED
    cells = undecided & ~_grown(status == CROSSED)
    for _ in range(sum(status.shape)):  # with all cells that are connected with these
        cells, before = undecided & _grown(cells), cells
        if (cells == before).all():
            break
    if not cells.any():
        return
    u, v = (a.nodes for a in m.grid.axes)
    shown = np.ma.masked_where(~cells.T, np.ones(cells.T.shape))
    axes.pcolormesh(u, v, shown, cmap=ListedColormap([_AMBER]), alpha=0.55, lw=0, rasterized=True, zorder=2.5)
    handles.append(Patch(facecolor=_AMBER, alpha=0.55, label="not proved free"))


def _grown(cells: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """The cells and their eight neighbours."""
    wide = np.pad(cells, 1)
    rows, columns = cells.shape
    return np.asarray(np.any([wide[i : i + rows, j : j + columns] for i in range(3) for j in range(3)], axis=0))


def _limits(m: SingularMap, axes: Any, handles: list[Any]) -> None:
    """What is beyond the limits, or was not followed to, hatched."""
    x, y = (np.linspace(float(a.start), float(a.stop), min(300, 2 * a.number)) for a in m.grid.axes)
    places = np.stack(np.meshgrid(x, y, indexing="ij"), axis=-1).reshape(-1, 2)
    margin = m.task.spare(places).reshape(len(x), len(y)).T
    if margin.min() >= 0:
        return
    low = [float(margin.min()) - 1, 0.0]
    axes.contourf(x, y, margin, levels=low, colors=["white"], alpha=0.62, zorder=5)
    hatch = axes.contourf(x, y, margin, levels=low, colors="none", hatches=["////"], zorder=5.5)
    hatch.set_edgecolor("#8A929B")
    hatch.set_linewidth(0)
    if margin.max() > 0:
        axes.contour(x, y, margin, levels=[0], colors=[_INK], linewidths=1.1, zorder=6)
    handles.append(Patch(facecolor="white", edgecolor="#8A929B", hatch="////", lw=0.4, label=m.task.beyond))
