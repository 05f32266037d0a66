"""Figures as lists of plane shapes, written as SVG or PDF.

Coordinates are in points (1/72 inch), x to the right and y downwards; shapes are drawn in order. Nothing depends on
installed fonts or on the time: equal drawings give equal bytes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from html import escape
from math import floor
from typing import Literal
from unicodedata import east_asian_width

from gcrules.algebra.language.notation import split_name
from gcrules.core.dataclass import dataclass
from gcrules.views.drawing.palette import ROLES

__all__ = [
    "XY",
    "Circle",
    "Drawing",
    "Polygon",
    "Run",
    "Shape",
    "Stroke",
    "Text",
    "below",
    "beside",
    "extent",
    "leader_stroke",
    "mapped",
    "name_runs",
    "scaled",
    "text_width",
    "without_text",
]

XY = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Polygon:
    """A closed area, filled and/or outlined; colours are roles of `palette.ROLES`."""

    points: tuple[XY, ...]
    fill: str | None = None
    stroke: str | None = None
    fill_opacity: float = 1.0
    stroke_opacity: float = 1.0
    width: float = 1.0


@dataclass(frozen=True, slots=True)
class Stroke:
    """A straight stroke; `dash` gives the lengths of stroke and gap."""

    start: XY
    end: XY
    stroke: str = "ink"
    width: float = 1.0
    opacity: float = 1.0
    dash: tuple[float, float] | None = None
    round_ends: bool = True


@dataclass(frozen=True, slots=True)
class Circle:
    center: XY
    radius: float
    fill: str = "paper"
    stroke: str = "ink"
    width: float = 1.0


@dataclass(frozen=True, slots=True)
class Run:
    """A piece of text in one style: upright words, italic names, subscripts."""

    text: str
    style: Literal["upright", "italic", "subscript"] = "upright"


@dataclass(frozen=True, slots=True)
class Text:
    """Text whose baseline starts, is centred or ends at `at`; `halo` sets it off against what lies below, `leader` are
    the ends of a thin line from what it names to it.
    """

    at: XY
    runs: tuple[Run, ...]
    size: float = 13.0
    anchor: Literal["start", "middle", "end"] = "start"
    fill: str = "ink"
    halo: bool = False
    leader: tuple[XY, XY] | None = None


Shape = Polygon | Stroke | Circle | Text


@dataclass(frozen=True, slots=True)
class Drawing:
    """A figure of the given size in points; `title` is what a screen reader says."""

    width: float
    height: float
    shapes: tuple[Shape, ...]
    title: str = ""

    def svg(self) -> str:
        """The figure as an SVG document that can also stand inside an HTML page.

        Colours are attributes for programs that know nothing else, and CSS rules for light and dark surroundings.
        """
        size = f"{_n(self.width)} {_n(self.height)}"
        paper = Polygon(((0, 0), (self.width, 0), (self.width, self.height), (0, self.height)), fill="paper")
        body = [_svg_shape(shape) for shape in (paper, *self.shapes)]
        return "\n".join(
            [
                f'<svg xmlns="http://www.w3.org/2000/svg" class="gc-figure" viewBox="0 0 {size}" '
                f'width="{_n(self.width)}" height="{_n(self.height)}" role="img">',
                *([f"<title>{escape(self.title)}</title>"] if self.title else []),
                f"<style>{_style(''.join(body))}</style>",
                *body,
                "</svg>\n",
            ]
        )

    def _repr_svg_(self) -> str:
        return self.svg()


def scaled(drawing: Drawing, factor: float) -> Drawing:
    """The whole drawing, strokes included, larger or smaller."""
    shapes = tuple(mapped(s, factor, (0.0, 0.0)) for s in drawing.shapes)
    return Drawing(drawing.width * factor, drawing.height * factor, shapes, drawing.title)


def beside(drawings: Sequence[Drawing], gap: float = 8.0, title: str = "") -> Drawing:
    """Drawings in one row, centred, as one."""
    height = max(d.height for d in drawings)
    shapes: list[Shape] = []
    left = 0.0
    for d in drawings:
        shapes += [mapped(s, 1.0, (left, (height - d.height) / 2)) for s in d.shapes]
        left += d.width + gap
    return Drawing(left - gap, height, tuple(shapes), title)


def below(drawings: Sequence[Drawing], gap: float = 8.0, title: str = "") -> Drawing:
    """Drawings one below the other, their left sides in line, as one."""
    shapes: list[Shape] = []
    top = 0.0
    for d in drawings:
        shapes += [mapped(s, 1.0, (0.0, top)) for s in d.shapes]
        top += d.height + gap
    return Drawing(max(d.width for d in drawings), top - gap, tuple(shapes), title)


def without_text(drawing: Drawing) -> Drawing:
    """The drawing without its words, cut to what is left."""
    shapes = tuple(s for s in drawing.shapes if not isinstance(s, Text))
    places = [p for s in shapes for p in extent(s)] or [(0.0, 0.0), (drawing.width, drawing.height)]
    (left, right), (top, bottom) = ((min(c) - 3, max(c) + 3) for c in zip(*places, strict=True))
    moved = tuple(mapped(s, 1.0, (-left, -top)) for s in shapes)
    return Drawing(right - left, bottom - top, moved, drawing.title)


def extent(shape: Shape) -> tuple[XY, ...]:
    """The places between which a shape (not a text) lies."""
    match shape:
        case Polygon():
            return shape.points
        case Stroke():
            return shape.start, shape.end
        case Circle(center=(x, y), radius=r):
            return (x - r, y - r), (x + r, y + r)
    return (shape.at,)


def mapped(shape: Shape, factor: float, shift: XY) -> Shape:
    """A shape larger or smaller by a factor, then shifted."""

    def at(p: XY) -> XY:
        return p[0] * factor + shift[0], p[1] * factor + shift[1]

    match shape:
        case Polygon():
            return replace(shape, points=tuple(map(at, shape.points)), width=shape.width * factor)
        case Stroke():
            dash = (shape.dash[0] * factor, shape.dash[1] * factor) if shape.dash else None
            return replace(shape, start=at(shape.start), end=at(shape.end), width=shape.width * factor, dash=dash)
        case Circle():
            return replace(shape, center=at(shape.center), radius=shape.radius * factor, width=shape.width * factor)
    leader = (at(shape.leader[0]), at(shape.leader[1])) if shape.leader else None
    return replace(shape, at=at(shape.at), size=shape.size * factor, leader=leader)


def leader_stroke(text: Text) -> Stroke | None:
    """The line from what a text names to it, where it stands away from it."""
    return Stroke(*text.leader, text.fill, 0.045 * text.size, 0.8) if text.leader else None


def name_runs(*names: str) -> tuple[Run, ...]:
    """Names of points side by side, as they are set in formulas: S1 is an italic S with a subscript.

    >>> [run.text for run in name_runs("A", "S12'")]
    ['A', 'S', '12', '′']
    """
    runs: list[Run] = []
    for i, name in enumerate(names):
        stem, digits, primes = split_name(name)
        if i and len(stem) > 1:
            runs.append(Run(" "))
        pieces = (Run(stem, "italic"), Run(digits, "subscript"), Run("′" * len(primes)))
        runs += [run for run in pieces if run.text]
    return tuple(runs)


def text_width(text: Text) -> float:
    """The width of a text in points, from a constant estimate for each letter that is on the safe side in all fonts."""
    return sum(_letter_width(c) * _WIDTHS[run.style] for run in text.runs for c in run.text) * text.size


_WIDTHS = {"upright": 0.6, "italic": 0.62, "subscript": 0.45}


def _letter_width(c: str) -> float:
    return 1.6 if c in "MWmw@%—" or east_asian_width(c) in "FW" else 0.6 if c in "ijl.,:;'′|! " else 1.0


# --- SVG -----------------------------------------------------------------------------------------------------------

_FONT = "font-family:'STIX Two Text','Latin Modern Roman','Times New Roman',Times,serif"
_SUBSCRIPT_SIZE = 0.72
_SUBSCRIPT_DROP = 0.22


def _style(body: str) -> str:
    """Rules for the roles that occur, with the dark values under the media query."""
    used = [role for role in ROLES if f"gc-f-{role}" in body or f"gc-s-{role}" in body]

    def rules(which: int) -> Iterator[str]:
        for role in used:
            value = f"var(--gc-{role},{ROLES[role][which]})"
            for letter, name in (("f", "fill"), ("s", "stroke")):
                if f"gc-{letter}-{role}" in body:
                    yield f".gc-{letter}-{role}{{{name}:{value}}}"

    dark = f"@media (prefers-color-scheme:dark){{{''.join(rules(1))}}}"
    return f".gc-figure text{{{_FONT}}}{''.join(rules(0))}{dark}"


def _n(value: float) -> str:
    """A number with at most two decimals. Numbers half way between two are common (positions are half widths and the
    like), so the limit lies a little beside it: otherwise the last bit, which is not the same everywhere, would decide.
    """
    out = f"{floor(value * 100 + 0.5001) / 100:.2f}".rstrip("0").rstrip(".")
    return "0" if out == "-0" else out


def _svg_shape(shape: Shape) -> str:
    match shape:
        case Polygon():
            points = " ".join(f"{_n(x)},{_n(y)}" for x, y in shape.points)
            extra = _opacity("fill", shape.fill_opacity) + _opacity("stroke", shape.stroke_opacity)
            width = f' stroke-width="{_n(shape.width)}" stroke-linejoin="round"' if shape.stroke else ""
            return f'<polygon points="{points}"{_paint(shape.fill, shape.stroke)}{width}{extra}/>'
        case Stroke():
            (x1, y1), (x2, y2) = shape.start, shape.end
            dash = f' stroke-dasharray="{_n(shape.dash[0])} {_n(shape.dash[1])}"' if shape.dash else ""
            cap = ' stroke-linecap="round"' if shape.round_ends and not shape.dash else ""
            return (
                f'<line x1="{_n(x1)}" y1="{_n(y1)}" x2="{_n(x2)}" y2="{_n(y2)}"{_paint(None, shape.stroke)}'
                f' stroke-width="{_n(shape.width)}"{cap}{dash}{_opacity("stroke", shape.opacity)}/>'
            )
        case Circle():
            x, y = shape.center
            return (
                f'<circle cx="{_n(x)}" cy="{_n(y)}" r="{_n(shape.radius)}"{_paint(shape.fill, shape.stroke)}'
                f' stroke-width="{_n(shape.width)}"/>'
            )
        case Text():
            return _svg_text(shape)


def _svg_text(text: Text) -> str:
    x, y = text.at
    halo = ' stroke-width="3" stroke-linejoin="round" paint-order="stroke"' if text.halo else ""
    paint = _paint(text.fill, "paper" if text.halo else None)
    anchor = "" if text.anchor == "start" else f' text-anchor="{text.anchor}"'
    pieces = []
    dropped = False
    for run in text.runs:
        attributes = ' font-style="italic"' if run.style == "italic" else ""
        drop = _SUBSCRIPT_DROP * text.size
        if run.style == "subscript":
            attributes += f' font-size="{_n(_SUBSCRIPT_SIZE * text.size)}"'
        if (run.style == "subscript") != dropped:
            attributes += f' dy="{_n(-drop if dropped else drop)}"'
            dropped = not dropped
        pieces.append(f"<tspan{attributes}>{escape(run.text)}</tspan>" if attributes else escape(run.text))
    content = "".join(pieces)
    line = leader_stroke(text)
    return (
        f"{_svg_shape(line) if line else ''}"
        f'<text x="{_n(x)}" y="{_n(y)}" font-size="{_n(text.size)}"{anchor}{paint}{halo} '
        f'xml:space="preserve">{content}</text>'
    )


def _paint(fill: str | None, stroke: str | None) -> str:
    classes = [f"gc-f-{fill}"] if fill else []
    classes += [f"gc-s-{stroke}"] if stroke else []
    fill_value = ROLES[fill][0] if fill else "none"
    stroke_value = f' stroke="{ROLES[stroke][0]}"' if stroke else ""
    return f' class="{" ".join(classes)}" fill="{fill_value}"{stroke_value}'


def _opacity(which: str, value: float) -> str:
    return f' {which}-opacity="{_n(value)}"' if value < 1 else ""
