r"""Singular surfaces seen from several sides: shaded with a depth buffer, in a box with the axes' ranges."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from gcrules.poses.maps.mesh import Mesh
from gcrules.poses.maps.report import SingularMap
from gcrules.views.drawing.palette import LIGHT
from gcrules.views.plots.map_head import HEAD, add_head
from gcrules.views.plots.map_meshes import SHEETS, sheet_colours

__all__ = ["views"]

Floats = NDArray[np.float64]
Bytes = NDArray[np.uint8]

VIEWS = ((-62.0, 25.0), (28.0, 25.0))
"""Azimuth and elevation of the eye, in degrees."""

_PIXELS = 760
_AT_ONCE = 1_500_000
_LIGHT = np.array([-0.35, 0.75, 0.65])  # right, up, towards the eye
_GREY = "#5C636B"


def views(m: SingularMap) -> Figure:
    """The surface from each of `VIEWS`; triangles that the legs do not reach are paler."""
    mesh = m.mesh
    handles = _legend(m, mesh)
    foot = 0.3 if handles else 0.0  # inches
    tall = 3.6 + foot + HEAD
    made = Figure(figsize=(7.2, tall))
    FigureCanvasAgg(made)
    low = np.array([float(a.start) for a in m.grid.axes])
    high = np.array([float(a.stop) for a in m.grid.axes])
    size = _proportions(m, high - low)
    margin = _margin(m, mesh)
    width = 1 / len(VIEWS)
    half = max(_half(_frame(*view), size) for view in VIEWS)
    for k, view in enumerate(VIEWS):
        axes = made.add_axes((k * width, foot / tall, width, 3.6 / tall))
        axes.set(xlim=(-half, half), ylim=(-half, half), aspect="equal")
        axes.set_axis_off()
        frame = _frame(*view)
        scaled = ((mesh.vertices - low) / (high - low) - 0.5) * size
        normals = mesh.normals * (high - low) / size  # a gradient scales the other way round than places
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        _box(axes, frame, size, front=False)
        image = _rendered(mesh, scaled @ frame.T, normals @ frame.T, margin, half)
        axes.imshow(image, extent=(-half, half, -half, half), origin="lower", zorder=2, interpolation="antialiased")
        _box(axes, frame, size, front=True)
        _ranges(axes, m, frame, size)
    add_head(made, m)
    if handles:
        made.legend(handles=handles, loc="lower center", ncols=min(4, len(handles)), frameon=False, fontsize=9)
    return made


def _proportions(m: SingularMap, span: Floats) -> Floats:
    """The sides of the box, the longest of length 1; true to scale for lengths that do not differ too much."""
    alike = len({(a.kind, a.unit) for a in m.grid.axes}) == 1 and span.max() < 4 * span.min()
    found: Floats = span / span.max() if alike else np.ones(3)
    return found


def _frame(azimuth: float, elevation: float) -> Floats:
    """Rows: right, up, towards the eye."""
    a, e = np.radians([azimuth, elevation])
    right = [-np.sin(a), np.cos(a), 0.0]
    up = [-np.sin(e) * np.cos(a), -np.sin(e) * np.sin(a), np.cos(e)]
    return np.array([right, up, [np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)]])


def _half(frame: Floats, size: Floats) -> float:
    """Half the side of the picture: the box and its labels fit."""
    corners = np.array(list(product((-0.5, 0.5), repeat=3))) * size
    return float(np.abs(corners @ frame[:2].T).max()) + 0.2


def _margin(m: SingularMap, mesh: Mesh) -> Floats:
    """By how much each vertex keeps to the limits (below 0: not)."""
    return m.task.spare(mesh.vertices)


def _rendered(mesh: Mesh, places: Floats, normals: Floats, margin: Floats, half: float) -> Bytes:
    """An image (rows upwards) with transparency; places and normals are in the frame of the eye."""
    number = _PIXELS * _PIXELS
    depth = np.full(number, -np.inf)
    colour = np.zeros((number, 3))
    base = sheet_colours().astype(np.float64)
    light = _LIGHT / np.linalg.norm(_LIGHT)
    pixels = (places[:, :2] / (2 * half) + 0.5) * _PIXELS
    corners = pixels[mesh.faces]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1, initial=0)
    pieces = np.ceil(1.15 ** np.ceil(np.log(np.maximum(1.3 * longest, 1)) / np.log(1.15))).astype(int)
    for n in np.unique(pieces):
        weights = np.array([(i, j, n - i - j) for i in range(n + 1) for j in range(n + 1 - i)]) / n
        listed = np.flatnonzero(pieces == n)
        step = max(1, _AT_ONCE // len(weights))
        for start in range(0, len(listed), step):
            faces = mesh.faces[listed[start : start + step]]

            def spread(values: Floats, faces: Any = faces, weights: Floats = weights) -> Floats:
                found: Floats = np.einsum("wk,fkc->fwc", weights, values[faces])
                return found.reshape(-1, values.shape[1])

            at = spread(np.concatenate([pixels, places[:, 2:], margin[:, None]], axis=1))
            column, row = at[:, 0].astype(int), at[:, 1].astype(int)
            inside = (column >= 0) & (column < _PIXELS) & (row >= 0) & (row < _PIXELS)
            index = np.where(inside, row * _PIXELS + column, 0)
            order = np.flatnonzero(inside & (at[:, 2] > depth[index]))
            order = order[np.argsort(at[order, 2], kind="stable")]  # the nearest of each pixel comes last
            normal = spread(normals)[order]
            normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-300)
            facing = normal @ light * np.sign(normal[:, 2] + 1e-12)
            shade = 0.55 + 0.5 * np.clip(facing, 0, 1)
            gloss = 0.2 * np.clip(facing, 0, 1) ** 30
            sheet = np.repeat(mesh.sheet[faces[:, 0]] % len(SHEETS), len(weights))[order]
            plain = np.where(at[order, 3:] >= 0, base[sheet], 0.3 * base[sheet] + 0.7 * 240)
            seen = plain * shade[:, None] + 255 * gloss[:, None]
            depth[index[order]] = at[order, 2]
            colour[index[order]] = seen
    return _outlined(depth.reshape(_PIXELS, _PIXELS), colour.reshape(_PIXELS, _PIXELS, 3))


def _outlined(depth: Floats, colour: Floats) -> Bytes:
    """Darker where something lies far behind, so that folds and borders show."""
    seen = np.isfinite(depth)
    solid = np.where(seen, depth, -9.0)
    jump = np.zeros_like(depth)
    for axis, step in product((0, 1), (-1, 1)):
        jump = np.maximum(jump, solid - np.roll(solid, step, axis=axis))
    edge = np.clip((jump - 0.02) / 0.03, 0, 1)[..., None]
    mixed = colour * (1 - 0.45 * edge)
    return np.concatenate([np.clip(mixed, 0, 255), 255.0 * seen[..., None]], axis=2).astype(np.uint8)


def _box(axes: Any, frame: Floats, size: Floats, *, front: bool) -> None:
    """The edges of the box: nine behind the surface, the three at the nearest corner before it."""
    nearest = np.sign(frame[2])
    for axis in range(3):
        others = [k for k in range(3) if k != axis]
        for signs in product((-1, 1), repeat=2):
            near = all(s == nearest[k] for k, s in zip(others, signs, strict=True))
            if near != front:
                continue
            ends = np.zeros((2, 3))
            ends[:, axis] = [-1, 1]
            ends[:, others] = signs
            line = ends * size / 2 @ frame.T
            axes.plot(
                line[:, 0], line[:, 1], color=_GREY, lw=0.6, alpha=0.55 if front else 0.9, zorder=4 if front else 1
            )


def _ranges(axes: Any, m: SingularMap, frame: Floats, size: Floats) -> None:
    """Names and ends of the axes: two along the lower edges towards the eye, one up the leftmost edge."""
    near = np.sign(frame[2])
    left = min(((a, b) for a in (-1, 1) for b in (-1, 1)), key=lambda s: frame[0] @ (np.array([*s, 0]) * size))
    spots = {0: (0.0, near[1], -1.0), 1: (near[0], 0.0, -1.0), 2: (left[0], left[1], 0.0)}
    for k, axis in enumerate(m.grid.axes):
        middle = np.array(spots[k])
        outwards = middle * size * [1.0, 1.0, 0.0]  # away from the box, level
        out = (frame @ outwards)[:2] + np.array([0.0, -0.35 if k < 2 else 0.0])
        out /= np.linalg.norm(out)
        for place, text, far in ((-0.88, axis.start, 0.07), (0.88, axis.stop, 0.07), (0.0, None, 0.15)):
            end = middle.copy()
            end[k] = place
            at = (frame @ (end * size / 2))[:2] + far * out
            words = axis.label if text is None else f"{float(text):g}".replace("-", "−")
            style: Any = {"fontsize": 10, "color": LIGHT["ink"]} if text is None else {"fontsize": 8.5, "color": _GREY}
            turned = 90 if text is None and k == 2 else 0
            axes.text(*at, words, ha="center", va="center", rotation=turned, zorder=6, **style)


def _legend(m: SingularMap, mesh: Mesh) -> list[Any]:
    found = []
    if m.factors is not None and len(m.factors) > 1:
        for k, f in enumerate(m.factors):
            found.append(Patch(color=LIGHT[SHEETS[k % len(SHEETS)]], label=f"factor {k + 1}, degree {f.degree}"))
    if not mesh.allowed.all():
        found.append(Patch(color="#DDDDDD", label=f"pale: {m.task.beyond}"))
    return found
