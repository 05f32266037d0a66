"""The curves of docs/speed.md: time against points, one panel for each rank, from the numbers of results/scale.json."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import log10
from typing import Any

from gcrules.views.drawing.drawing import XY, Circle, Drawing, Polygon, Run, Shape, Stroke, Text, text_width

__all__ = ["curve", "factoring_curve"]

_WIDTH, _HEIGHT, _GAP = 300.0, 260.0, 28.0
_LEFT, _TOP, _FOOT = 62.0, 34.0, 74.0
_DECADES = (-4, 3)  # of seconds, at the foot and at the top
_TICKS = {-4: "0.1 ms", -3: "1 ms", -2: "10 ms", -1: "0.1 s", 0: "1 s", 1: "10 s", 2: "100 s", 3: "1000 s"}
_RADIUS = 3.6


_Measured = Mapping[str, Any]


@dataclass(frozen=True)
class _Series:
    """A line of the picture; those that belong to one program have one colour, and each has its own mark."""

    name: str
    role: str
    mark: str
    value: Callable[[_Measured], float | None]
    dash: tuple[float, float] | None = None
    program: str = ""  # the key of the program that may have been stopped: its value is None there
    kind: str | None = None  # of the runs that belong to it; all, if None

    def of(self, runs: Sequence[_Measured]) -> list[_Measured]:
        return [run for run in runs if run.get("kind") == self.kind]


def _forms(run: _Measured) -> float | None:
    return run["macaulay2"]["forms"] if run.get("macaulay2") else None


def _with_basis(run: _Measured) -> float | None:
    return run["macaulay2"]["basis"] + run["macaulay2"]["forms"] if run.get("macaulay2") else None


def _of(program: str) -> Callable[[_Measured], float | None]:
    return lambda run: run.get(program)


_FORMS = (
    _Series("gcrules", "entity1", "disc", _of("gcrules")),
    _Series("Macaulay2, its Gröbner basis included", "entity2", "square", _with_basis, program="macaulay2"),
    _Series("Macaulay2, the basis at hand", "entity2", "triangle", _forms, (5, 4)),
)
_FACTORING = (
    _Series("gcrules, products", "entity1", "disc", _of("gcrules"), kind="products"),
    _Series("gcrules, expression", "entity1", "ring", _of("gcrules"), (5, 4), kind="expression"),
    _Series("sympy, products", "entity2", "square", _of("sympy"), None, "sympy", "products"),
    _Series("sympy, expression", "entity2", "triangle", _of("sympy"), (5, 4), "sympy", "expression"),
)


def curve(results: _Measured) -> Drawing:
    """Normal forms: points to the right, seconds upwards on a logarithmic scale."""
    title = f"Time for {results['forms']} normal forms against the number of points, beside Macaulay2"
    return _drawn(results, _FORMS, title)


def factoring_curve(results: _Measured) -> Drawing:
    """Factoring, in the same way."""
    title = "Time to factor products of brackets and planted expressions against the number of points, beside sympy"
    return _drawn(results, _FACTORING, title)


def _drawn(results: _Measured, kinds: Sequence[_Series], title: str) -> Drawing:
    ranks = sorted({run["rank"] for run in results["runs"]})
    width = _LEFT + len(ranks) * _WIDTH + (len(ranks) - 1) * _GAP + 12
    shapes: list[Shape] = []
    for number, rank in enumerate(ranks):
        runs = [run for run in results["runs"] if run["rank"] == rank]
        points = [run["points"] for run in runs]
        panel = _Panel(_LEFT + number * (_WIDTH + _GAP), min(points), max(points))
        shapes += panel.frame(f"rank {rank}", named=number == 0)
        for series in reversed(kinds):
            shapes += panel.line(series, series.of(runs))
        shapes += panel.stopped(kinds, runs, results["limit"])
    shapes += _legend(kinds)
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
            yield Stroke((self.left, y), (right, y), "muted", 0.6, opacity=0.35)
            if named:
                yield _words((self.left - 8, y + 4), _TICKS[decade], 12, "end", "muted")
        foot = _TOP + _HEIGHT
        yield Stroke((self.left, foot), (right, foot), "ink", 1.0)
        for points in range(self.first, self.last + 1):
            x = self.at(points, 1)[0]
            yield Stroke((x, foot), (x, foot + 4), "ink", 1.0)
            yield _words((x, foot + 18), str(points), 12, "middle", "muted")
        yield _words((self.left + _WIDTH / 2, _TOP - 14), title, 14, "middle")
        yield _words((self.left + _WIDTH / 2, foot + 36), "points", 12, "middle", "muted")

    def line(self, series: _Series, runs: Sequence[_Measured]) -> Iterator[Shape]:
        found = [(run["points"], series.value(run)) for run in runs]
        places = [self.at(points, max(value, 1e-4)) for points, value in found if value is not None]
        for a, b in pairwise(places):
            yield Stroke(a, b, series.role, 2.0, dash=series.dash)
        for place in places:
            yield _mark(series, place)

    def stopped(self, kinds: Sequence[_Series], runs: Sequence[_Measured], limit: float) -> Iterator[Shape]:
        """An open mark where a program was stopped; the words once."""
        places = [
            (series, self.at(run["points"], limit))
            for series in kinds
            if series.program
            for run in series.of(runs)
            if run.get(series.program, 0) is None
        ]
        for series, place in places:
            yield _mark(series, place, "paper", series.role, 1.6)
        for series, (x, y) in places[:1]:
            words = _words((x - 9, y - 8), f"stopped after {limit:g} s", 12, "end", series.role)
            fits = x - 9 - text_width(words) >= self.left
            yield words if fits else replace(words, at=(x, y - 12), anchor="middle")


def _mark(series: _Series, place: XY, fill: str = "", edge: str = "paper", width: float = 1.0) -> Shape:
    x, y = place
    fill = fill or series.role
    match series.mark:
        case "disc":
            return Circle(place, _RADIUS, fill, edge, width)
        case "ring":
            return Circle(place, _RADIUS, "paper", series.role, 1.6)
        case "square":
            return Polygon(_square(place, _RADIUS), fill, edge, width=width)
    up = 1.3 * _RADIUS
    return Polygon(((x, y - up), (x + up, y + 0.8 * up), (x - up, y + 0.8 * up)), fill, edge, width=width)


def _square(place: XY, r: float) -> tuple[XY, ...]:
    x, y = place
    return (x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)


def _legend(kinds: Sequence[_Series]) -> Iterator[Shape]:
    x, y = _LEFT, _TOP + _HEIGHT + 60
    for series in kinds:
        yield Stroke((x, y), (x + 26, y), series.role, 2.0, dash=series.dash)
        yield _mark(series, (x + 13, y))
        name = _words((x + 33, y + 4), series.name, 12)
        yield name
        x += 33 + text_width(name) + 18


def _words(at: XY, words: str, size: float, anchor: Any = "start", fill: str = "ink") -> Text:
    return Text(at, (Run(words),), size, anchor, fill)
