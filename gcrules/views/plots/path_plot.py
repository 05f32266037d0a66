r"""The plot of a path: two quantities over the parameter, singular places marked by shape and colour."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.numbers.many import scaled_superbracket
from gcrules.poses.paths.report import PathReport
from gcrules.poses.plans.report import Plan
from gcrules.screws.margin import jacobian
from gcrules.screws.threshold import Threshold, margin_of
from gcrules.views.drawing.axis import Axis
from gcrules.views.drawing.drawing import Drawing, Polygon, Run, Shape, Stroke, Text, text_width
from gcrules.views.plots.plot_parts import marker, signed, words_at

__all__ = ["FRAME", "plot", "plot_of_plan", "plot_of_robot", "svg", "svg_of_plan", "svg_of_robot"]

Floats = NDArray[np.float64]

WIDTH, LEFT, RIGHT = 560.0, 62.0, 18.0
_TOP, _UPPER, _GAP, _LOWER, _BOTTOM = 34.0, 170.0, 40.0, 110.0, 74.0
_FLOOR = _TOP + _UPPER + _GAP + _LOWER
FRAME = LEFT / WIDTH, 1 - RIGHT / WIDTH, _TOP / (_FLOOR + _BOTTOM), _FLOOR / (_FLOOR + _BOTTOM)
"""Where the axes are in the plot: left and right as parts of its width, top and bottom of its height."""
_MOST = 600  # points of a curve; of more, the least and the largest of every group are drawn
_SIZE = 11.0
_ASKED = "entity3"  # the colour of the margin that was asked for


@dataclass(frozen=True)
class _Plot:
    """What is drawn: above the margin σ with the threshold, below another quantity; `zeros` are places with their kind,
    `blocks` stretches with what they mean, `asked` the margin of a plan, 0 for none.
    """

    title: str
    end: float
    places: Floats
    margins: Floats
    other: tuple[str, Floats]
    zeros: tuple[tuple[float, str], ...]
    blocks: tuple[tuple[float, float], ...]
    meaning: str
    threshold: Threshold
    asked: float


def plot(r: PathReport, asked: float = 0.0) -> Drawing:
    """Above the margin σ with the threshold, below the superbracket; the x axis is the parameter of the path."""
    return _drawn(
        _Plot(
            f"{r.rig.title}: margin and superbracket along a path through {len(r.poses)} poses, {r.verdict}",
            len(r.poses) - 1,
            r.parameters,
            r.numbers.margin,
            ("superbracket / (leg lengths · ρ³) (no unit)", _determinant(r)),
            tuple((z.parameter, z.kind) for z in r.zeros),
            tuple((s.start, s.end) for s in r.stretches),
            "singular throughout",
            r.threshold,
            asked,
        )
    )


def plot_of_robot(r: RobotPath, asked: float = 0.0) -> Drawing:
    """Above the margin σ with the threshold, below the least margin of the limbs by themselves."""
    return _drawn(
        _Plot(
            f"{r.title}: margin and the limbs' own margins along a path through {len(r.texts)} poses, {r.verdict}",
            len(r.texts) - 1,
            r.parameters,
            r.margins,
            ("least margin of the limbs by themselves (no unit; 0 is singular)", r.limb_margins),
            tuple((c.parameter, "crosses") for c in r.crossings),
            r.undecided,
            "not decided",
            r.threshold,
            asked,
        )
    )


def plot_of_plan(p: Plan) -> Drawing:
    """The plot of its way, with the margin that was asked for. Raises InputError where there is no way."""
    if p.path is None:
        raise InputError("there is no way to be drawn", hint="a plan whose `outcome` is way has one")
    asked = p.asked if p.end_margin is None else 0.0
    return plot(p.path, asked) if isinstance(p.path, PathReport) else plot_of_robot(p.path, asked)


def _drawn(p: _Plot) -> Drawing:
    x = Axis(0, p.end, LEFT, WIDTH - RIGHT)
    sigma = Axis(0, _up(max(float(p.margins.max(initial=0)), 1e-9)), _TOP + _UPPER, _TOP)
    label, value = p.other
    low, high = (math.copysign(_up(abs(v)), v) if v else 0.0 for v in (value.min(initial=0), value.max(initial=0)))
    other = Axis(low, high, _FLOOR, _FLOOR - _LOWER) if low < high else Axis(-1, 1, _FLOOR, _FLOOR - _LOWER)
    shapes: list[Shape] = []
    for start, end in p.blocks:
        for axis in (sigma, other):
            corners = ((x(start), axis.start), (x(end), axis.start), (x(end), axis.end), (x(start), axis.end))
            shapes.append(Polygon(corners, fill="mark", fill_opacity=0.16))
    shapes += _frame(x, sigma, "margin σ (no unit; 0 is singular)", last=False)
    shapes += _frame(x, other, label, last=True)
    assert p.threshold.angle is not None
    limit = margin_of(p.threshold.angle)
    if limit < sigma.high:
        shapes.append(Stroke((x.start, sigma(limit)), (x.end, sigma(limit)), "muted", 1.0, dash=(5, 3)))
    if other.low < 0 < other.high:
        shapes.append(Stroke((x.start, other(0)), (x.end, other(0)), "muted", 0.8))
    if _asked(p, limit):
        shapes.append(Stroke((x.start, sigma(p.asked)), (x.end, sigma(p.asked)), _ASKED, 1.2, dash=(5, 3)))
    for pose in range(1, round(p.end)):
        for axis in (sigma, other):
            shapes.append(Stroke((x(pose), axis.end), (x(pose), axis.start), "muted", 0.5, 0.35))
    for place, _ in p.zeros:
        for axis in (sigma, other):
            shapes.append(Stroke((x(place), axis.end), (x(place), axis.start), "mark", 0.8, 0.6, dash=(2, 3)))
    shapes += _curve(x, sigma, p.places, p.margins, "entity1")
    shapes += _curve(x, other, p.places, value, "entity2")
    for place, kind in p.zeros:
        height = float(np.interp(place, p.places, value))
        shapes += [marker(kind, (x(place), sigma(0))), marker(kind, (x(place), other(height)))]
    shapes += _numbers([place for place, _ in p.zeros], x, sigma.end - 6)
    shapes += _legend(p, _FLOOR + 58)
    return Drawing(WIDTH, _FLOOR + _BOTTOM, tuple(shapes), p.title)


def _asked(p: _Plot, limit: float) -> bool:
    """Whether the margin that was asked for is another one than that of the threshold."""
    return p.asked > 0 and abs(p.asked - limit) > 1e-9


def _determinant(r: PathReport) -> Floats:
    """The superbracket over the lengths of the legs and the cube of the characteristic length ρ."""
    j = jacobian(r.rig.base, r.rig.ends(r.translations, matrices(r.quaternions)))
    found: Floats = np.where(r.numbers.margin == 0, 0.0, scaled_superbracket(r.rig, j))
    return found


def _up(value: float) -> float:
    """A round number not below a positive one."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(m * power for m in (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10) if m * power >= value * (1 - 1e-12))


def _frame(x: Axis, y: Axis, label: str, *, last: bool) -> Iterator[Shape]:
    for tick in y.ticks(4):
        yield Stroke((x.start, y(tick)), (x.end, y(tick)), "muted", 0.5, 0.35)
        yield words_at((x.start - 6, y(tick) + 4), signed(f"{tick:.4g}"), "end")
    yield Stroke((x.start, y.start), (x.end, y.start), "ink", 1.0)
    yield Stroke((x.start, y.start), (x.start, y.end), "ink", 1.0)
    yield words_at((x.start - 44, y.end - 12), label)
    for tick in x.ticks(8, whole=x.high >= 3):
        yield Stroke((x(tick), y.start), (x(tick), y.start + 4), "ink", 1.0)
        if last:
            yield words_at((x(tick), y.start + 17), f"{tick:.4g}", "middle")
    if last:
        yield words_at(((x.start + x.end) / 2, y.start + 34), "parameter of the path (0 is the first pose)", "middle")


def _curve(x: Axis, y: Axis, places: Floats, values: Floats, colour: str) -> Iterator[Shape]:
    chosen = list(range(len(places)))
    if len(places) > _MOST:
        groups = np.array_split(np.arange(len(places)), _MOST // 2)
        chosen = sorted({int(g[f(values[g])]) for g in groups for f in (np.argmin, np.argmax)})
    points = [(x(float(places[i])), y(float(values[i]))) for i in chosen]
    for start, end in pairwise(points):
        yield Stroke(start, end, colour, 1.6)


def _numbers(zeros: Sequence[float], x: Axis, height: float) -> Iterator[Shape]:
    """The numbers that the zeros have in the text; those that are too near each other share a place: 2–5."""
    groups: list[list[int]] = []
    for n in range(len(zeros)):
        if groups and x(zeros[n]) - x(zeros[groups[-1][-1]]) < 15:
            groups[-1].append(n)
        else:
            groups.append([n])
    for group in groups:
        first, last = group[0], group[-1]
        words = f"{first + 1}" if first == last else f"{first + 1}–{last + 1}"
        place = (x(zeros[first]) + x(zeros[last])) / 2
        yield Text((place, height), (Run(words),), _SIZE, "middle", "mark", halo=True)


def _legend(p: _Plot, height: float) -> Iterator[Shape]:
    """What the marks mean that occur."""
    entries: list[tuple[Callable[[float], Shape], str]]
    entries = [(partial(_dashes, "muted", height), f"threshold {p.threshold.text}")]
    assert p.threshold.angle is not None
    if _asked(p, margin_of(p.threshold.angle)):
        entries.append((partial(_dashes, _ASKED, height), f"margin asked for, {p.asked:.4g}"))
    meaning = {"crosses": "crosses", "touches": "touches", "starts": "starts or ends", "ends": "starts or ends"}
    occurring = {kind for _, kind in p.zeros}
    shown = {words: kind for kind, words in meaning.items() if kind in occurring}
    for words, kind in shown.items():
        entries.append((partial(_sign, kind, height), words))
    if p.blocks:
        entries.append((partial(_block, height), p.meaning))
    u = LEFT + 8
    for draw, words in entries:
        text = words_at((u + 14, height), words)
        yield draw(u)
        yield text
        u += 36 + text_width(text) * 0.9


def _dashes(colour: str, height: float, u: float) -> Shape:
    return Stroke((u - 8, height - 4), (u + 8, height - 4), colour, 1.2, dash=(5, 3))


def _sign(kind: str, height: float, u: float) -> Shape:
    return marker(kind, (u, height - 4))


def _block(height: float, u: float) -> Shape:
    corners = ((u - 8, height - 9), (u + 8, height - 9), (u + 8, height + 1), (u - 8, height + 1))
    return Polygon(corners, fill="mark", fill_opacity=0.16)


def svg(r: PathReport) -> str:
    """The plot as SVG."""
    return plot(r).svg()


def svg_of_robot(r: RobotPath) -> str:
    """The plot as SVG."""
    return plot_of_robot(r).svg()


def svg_of_plan(p: Plan) -> str | None:
    """The plot of its way as SVG; nothing where there is no way."""
    return None if p.path is None else plot_of_plan(p).svg()
