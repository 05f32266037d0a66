"""A drawing as PDF, through matplotlib; imported only when a PDF is asked for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from io import BytesIO
from threading import Lock
from typing import Any

import matplotlib
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle as CirclePatch
from matplotlib.patches import Polygon as PolygonPatch
from matplotlib.patheffects import withStroke
from matplotlib.text import Text as TextArtist

from gcrules.views.drawing.drawing import Circle, Drawing, Polygon, Run, Shape, Stroke, Text, leader_stroke
from gcrules.views.drawing.palette import LIGHT

__all__ = ["artists", "pdf"]

_SETTINGS: Any = {
    "pdf.fonttype": 42,
    "mathtext.fontset": "stix",
    "font.family": "STIXGeneral",
    "text.usetex": False,
    "path.simplify": False,
}
_SETTING = Lock()  # the settings of matplotlib are global


def pdf(drawing: Drawing) -> bytes:
    """The bytes of a one-page PDF of the drawing's size, without a date, in the colours for paper."""
    out = BytesIO()
    with _SETTING, matplotlib.rc_context(_SETTINGS):
        figure = Figure(figsize=(drawing.width / 72, drawing.height / 72))
        FigureCanvasPdf(figure)
        axes = figure.add_axes((0, 0, 1, 1))
        axes.set_xlim(0, drawing.width)
        axes.set_ylim(drawing.height, 0)
        axes.set_axis_off()
        for artist in artists(drawing):
            axes.add_artist(artist)
        figure.savefig(out, format="pdf", metadata={"CreationDate": None, "Title": drawing.title or None})
    return out.getvalue()


def artists(drawing: Drawing) -> Iterator[Any]:
    """The artists of matplotlib for all shapes, one above the other, in points of the drawing."""
    for layer, shape in enumerate(_with_leaders(drawing.shapes)):
        artist = _artist(shape)
        artist.set_zorder(layer + 1)
        yield artist


def _with_leaders(shapes: Sequence[Shape]) -> Iterator[Shape]:
    for shape in shapes:
        line = leader_stroke(shape) if isinstance(shape, Text) else None
        yield from (line, shape) if line else (shape,)


def _artist(shape: Shape) -> Any:
    match shape:
        case Polygon():
            return PolygonPatch(
                shape.points,
                closed=True,
                facecolor=(LIGHT[shape.fill], shape.fill_opacity) if shape.fill else "none",
                edgecolor=(LIGHT[shape.stroke], shape.stroke_opacity) if shape.stroke else "none",
                linewidth=shape.width if shape.stroke else 0,
                joinstyle="round",
            )
        case Stroke():
            (x1, y1), (x2, y2) = shape.start, shape.end
            dash: Any = (0, tuple(d / shape.width for d in shape.dash)) if shape.dash else "solid"
            return Line2D(
                (x1, x2),
                (y1, y2),
                color=LIGHT[shape.stroke],
                alpha=shape.opacity,
                linewidth=shape.width,
                linestyle=dash,
                solid_capstyle="round" if shape.round_ends else "butt",
                dash_capstyle="butt",
            )
        case Circle():
            return CirclePatch(
                shape.center,
                shape.radius,
                facecolor=LIGHT[shape.fill],
                edgecolor=LIGHT[shape.stroke],
                linewidth=shape.width,
            )
        case Text():
            return _text(shape)


def _text(text: Text) -> Any:
    effects = [withStroke(linewidth=3, foreground=LIGHT["paper"])] if text.halo else None
    align: Any = {"start": "left", "middle": "center", "end": "right"}[text.anchor]
    return TextArtist(
        *text.at,
        "".join(map(_mathtext, text.runs)),
        fontsize=text.size,
        color=LIGHT[text.fill],
        horizontalalignment=align,
        verticalalignment="baseline",
        path_effects=effects,
    )


def _mathtext(run: Run) -> str:
    plain = run.text.replace("\\", r"\backslash").replace("$", r"\$").replace("_", r"\_").replace("%", r"\%")
    match run.style:
        case "italic":
            return rf"$\mathit{{{plain}}}$"
        case "subscript":
            return rf"$_{{\mathrm{{{plain}}}}}$"
        case "upright":
            return run.text.replace("$", r"\$")
