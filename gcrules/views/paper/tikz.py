r"""Drawings as TikZ: as wide as a column of the paper, in the colours for paper, labels in the font of the paper.

>>> from gcrules.views.drawing.drawing import Circle
>>> print(tikz(Drawing(100, 50, (Circle((10, 20), 3),))).splitlines()[-2])
\draw[fill=gcpaper, draw=gcink, line width=1bp] (10,20) circle[radius=3bp];
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from gcrules.views.drawing.drawing import (
    XY,
    Circle,
    Drawing,
    Polygon,
    Run,
    Shape,
    Stroke,
    Text,
    leader_stroke,
    mapped,
    text_width,
)
from gcrules.views.drawing.palette import LIGHT
from gcrules.views.formulas.latex_text import latex_words

__all__ = ["at_column_width", "tikz", "trimmed"]

_LARGER = 1.12  # labels, as the whole picture is made smaller for a column
_ANCHORS = {"start": "base west", "middle": "base", "end": "base east"}
_MARGIN = 4.0


def at_column_width(picture: str, width: float, height: float) -> str:
    r"""A picture of these points, or what inputs it, made smaller where the column, or the page, has less room."""
    by_height = f"{_n(_OF_PAGE * width / height)}\\textheight"
    size = rf"\dimen0=\ifdim{_n(width)}bp<\columnwidth{_n(width)}bp\else\columnwidth\fi\relax"
    size += rf"\ifdim\dimen0>{by_height}\dimen0={by_height}\relax\fi"
    return rf"{size}\resizebox{{\dimen0}}{{!}}{{{picture}}}"


_OF_PAGE = 0.8  # of the height of a page, so that there is room for the caption


def trimmed(drawing: Drawing) -> Drawing:
    """The drawing without empty margins."""
    places = [p for s in drawing.shapes for p in _extent(s)] or [(0.0, 0.0), (drawing.width, drawing.height)]
    (left, right), (top, bottom) = ((min(c) - _MARGIN, max(c) + _MARGIN) for c in zip(*places, strict=True))
    moved = tuple(mapped(s, 1.0, (-left, -top)) for s in drawing.shapes)
    return Drawing(right - left, bottom - top, moved, drawing.title)


def tikz(drawing: Drawing) -> str:
    """A `tikzpicture` of the drawing's size; it needs the package tikz."""
    body = [_shape(s) for s in drawing.shapes]
    used = [role for role in LIGHT if re.search(rf"\bgc{role}\b", "\n".join(body))]
    colours = [rf"\definecolor{{gc{role}}}{{HTML}}{{{LIGHT[role].removeprefix('#')}}}" for role in used]
    begin = r"\begin{tikzpicture}[x=1bp, y=-1bp, line join=round, inner sep=0.6bp, outer sep=0pt]"
    box = rf"\useasboundingbox (0,0) rectangle {_xy((drawing.width, drawing.height))};"
    return "\n".join([begin, *colours, box, *body, r"\end{tikzpicture}"])


def _shape(shape: Shape) -> str:
    match shape:
        case Polygon():
            corners = " -- ".join(map(_xy, shape.points))
            paint = [f"fill=gc{shape.fill}"] if shape.fill else []
            paint += [f"draw=gc{shape.stroke}", _width(shape.width)] if shape.stroke else []
            paint += [f"fill opacity={_n(shape.fill_opacity)}"] if shape.fill and shape.fill_opacity < 1 else []
            paint += [f"draw opacity={_n(shape.stroke_opacity)}"] if shape.stroke and shape.stroke_opacity < 1 else []
            return rf"\path[{', '.join(paint)}] {corners} -- cycle;"
        case Stroke():
            paint = [f"draw=gc{shape.stroke}", _width(shape.width)]
            paint += [f"draw opacity={_n(shape.opacity)}"] if shape.opacity < 1 else []
            if shape.dash:
                paint.append(f"dash pattern=on {_n(shape.dash[0])}bp off {_n(shape.dash[1])}bp")
            elif shape.round_ends:
                paint.append("line cap=round")
            return rf"\path[{', '.join(paint)}] {_xy(shape.start)} -- {_xy(shape.end)};"
        case Circle():
            paint = [f"fill=gc{shape.fill}", f"draw=gc{shape.stroke}", _width(shape.width)]
            return rf"\draw[{', '.join(paint)}] {_xy(shape.center)} circle[radius={_n(shape.radius)}bp];"
    return _text(shape)


def _text(text: Text) -> str:
    size = _LARGER * text.size
    font = rf"font=\fontsize{{{_n(size)}}}{{{_n(1.2 * size)}}}\selectfont"
    style = [f"anchor={_ANCHORS[text.anchor]}", f"text=gc{text.fill}", font]
    style += ["fill=gcpaper", "fill opacity=0.75", "text opacity=1"] if text.halo else []
    line = leader_stroke(text)
    led = f"{_shape(line)}\n" if line else ""
    return led + rf"\node[{', '.join(style)}] at {_xy(text.at)} {{{''.join(map(_run, text.runs))}}};"


def _run(run: Run) -> str:
    words = latex_words(run.text)
    match run.style:
        case "italic":
            return rf"\textit{{{words}}}"
        case "subscript":
            return rf"\textsubscript{{{words}}}"
    return words


def _extent(shape: Shape) -> Iterator[XY]:
    """The places between which a shape lies."""
    match shape:
        case Polygon():
            yield from shape.points
        case Stroke():
            yield from (shape.start, shape.end)
        case Circle(center=(x, y), radius=r):
            yield from ((x - r, y - r), (x + r, y + r))
        case Text(at=(x, y), size=size):
            width = text_width(shape)
            left = x - width * {"start": 0.0, "middle": 0.5, "end": 1.0}[shape.anchor]
            yield from ((left, y - size), (left + width, y + 0.3 * size))


def _xy(p: XY) -> str:
    return f"({_n(p[0])},{_n(p[1])})"


def _width(width: float) -> str:
    return f"line width={_n(width)}bp"


def _n(value: float) -> str:
    out = f"{value + 1e-6:.2f}".rstrip("0").rstrip(".")
    return "0" if out == "-0" else out
