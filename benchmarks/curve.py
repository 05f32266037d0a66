"""The curve of docs/speed.md: time against points, one panel for each rank, from the numbers of results/scale.json."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import log10
from typing import Any

from gcrules.render.drawing import XY, Circle, Drawing, Line, Polygon, Run, Shape, Text, text_width

__all__ = ["curve"]

_WIDTH, _HEIGHT, _GAP = 300.0, 260.0, 28.0
_LEFT, _TOP, _FOOT = 62.0, 34.0, 74.0
_DECADES = (-4, 3)  # of seconds, at the foot and at the top
_TICKS = {-4: "0.1 ms", -3: "1 ms", -2: "10 ms", -1: "0.1 s", 0: "1 s", 1: "10 s", 2: "100 s", 3: "1000 s"}
_RADIUS = 3.6


@dataclass(frozen=True)
class _Series:
    """A line of the picture; those that belong to one program have one colour, and each has its own mark."""

    name: str
    role: str
    mark: str
    dash: tuple[float, float] | None = None

    def value(self, run: Mapping[str, Any]) -> float | None:
        peer = run.get("macaulay2")
        if self.mark == "disc":
            return float(run["gcrules"])
        if not peer:
            return None
        return float(peer["forms"] if self.mark == "triangle" else peer["basis"] + peer["forms"])


_SERIES = (
    _Series("gcrules", "entity1", "disc"),
    _Series("Macaulay2, its Gröbner basis included", "entity2", "square"),
    _Series("Macaulay2, the basis at hand", "entity2", "triangle", (5, 4)),
)


def curve(results: Mapping[str, Any]) -> Drawing:
    """The drawing: points to the right, seconds upwards on a logarithmic scale."""
    ranks = sorted({run["rank"] for run in results["runs"]})
    width = _LEFT + len(ranks) * _WIDTH + (len(ranks) - 1) * _GAP + 12
    shapes: list[Shape] = []
    for number, rank in enumerate(ranks):
        runs = [run for run in results["runs"] if run["rank"] == rank]
        panel = _Panel(_LEFT + number * (_WIDTH + _GAP), runs[0]["points"], runs[-1]["points"])
        shapes += panel.frame(f"rank {rank}", named=number == 0)
        for series in reversed(_SERIES):
            shapes += panel.line(series, runs)
        shapes += panel.stopped(runs, results["limit"])
    shapes += _legend()
    title = f"Time for {results['forms']} normal forms against the number of points, beside Macaulay2"
    return Drawing(width, _TOP + _HEIGHT + _FOOT, tuple(shapes), title)


@dataclass(frozen=True)
class _Panel:
    left: float
    first: int
    last: int

    def at(self, points: float, seconds: float) -> XY:
        low, high = _DECADES
        x = self.left + _WIDTH * (points - self.first + 0.5) / (self.last - self.first + 1)
        return x, _TOP + _HEIGHT * (high - log10(seconds)) / (high - low)

    def frame(self, title: str, named: bool) -> Iterator[Shape]:
        low, high = _DECADES
        right = self.left + _WIDTH
        for decade in range(low, high + 1):
            y = self.at(self.first, 10.0**decade)[1]
            yield Line((self.left, y), (right, y), "muted", 0.6, opacity=0.35)
            if named:
                yield _words((self.left - 8, y + 4), _TICKS[decade], 12, "end", "muted")
        foot = _TOP + _HEIGHT
        yield Line((self.left, foot), (right, foot), "ink", 1.0)
        for points in range(self.first, self.last + 1):
            x = self.at(points, 1)[0]
            yield Line((x, foot), (x, foot + 4), "ink", 1.0)
            yield _words((x, foot + 18), str(points), 12, "middle", "muted")
        yield _words((self.left + _WIDTH / 2, _TOP - 14), title, 14, "middle")
        yield _words((self.left + _WIDTH / 2, foot + 36), "points", 12, "middle", "muted")

    def line(self, series: _Series, runs: Sequence[Mapping[str, Any]]) -> Iterator[Shape]:
        found = [(run["points"], series.value(run)) for run in runs]
        places = [self.at(points, max(value, 1e-4)) for points, value in found if value is not None]
        for a, b in pairwise(places):
            yield Line(a, b, series.role, 2.0, dash=series.dash)
        for place in places:
            yield _mark(series, place)

    def stopped(self, runs: Sequence[Mapping[str, Any]], limit: float) -> Iterator[Shape]:
        """An open square where Macaulay2 was stopped."""
        for run in runs:
            if run.get("macaulay2", 0) is None:
                x, y = self.at(run["points"], limit)
                r = _RADIUS
                yield Polygon(_square((x, y), r), "paper", "entity2", width=1.6)
                yield _words((x - 9, y - 8), f"stopped after {limit:g} s", 12, "end", "entity2")


def _mark(series: _Series, place: XY) -> Shape:
    x, y = place
    match series.mark:
        case "disc":
            return Circle(place, _RADIUS, series.role, "paper", 1.0)
        case "square":
            return Polygon(_square(place, _RADIUS), series.role, "paper", width=1.0)
    up = 1.3 * _RADIUS
    return Polygon(((x, y - up), (x + up, y + 0.8 * up), (x - up, y + 0.8 * up)), series.role, "paper", width=1.0)


def _square(place: XY, r: float) -> tuple[XY, ...]:
    x, y = place
    return (x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)


def _legend() -> Iterator[Shape]:
    x, y = _LEFT, _TOP + _HEIGHT + 60
    for series in _SERIES:
        yield Line((x, y), (x + 26, y), series.role, 2.0, dash=series.dash)
        yield _mark(series, (x + 13, y))
        name = _words((x + 33, y + 4), series.name, 12)
        yield name
        x += 33 + text_width(name) + 18


def _words(at: XY, words: str, size: float, anchor: Any = "start", fill: str = "ink") -> Text:
    return Text(at, (Run(words),), size, anchor, fill)
