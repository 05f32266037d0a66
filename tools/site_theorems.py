"""Drawings of theorems of the plane: points that are given, meets that follow, lines, areas and a conic."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import pairwise
from math import cos, dist, radians, sin

from drawing_kit import BLUE, DOT, GREEN, ORANGE

import gcrules as gc
from gcrules.views.drawing.drawing import XY, Circle, Drawing, Polygon, Shape, Stroke, name_runs
from gcrules.views.drawing.labels import Label, place_labels

__all__ = ["THEOREMS"]

DASHED = (5.0, 4.0)


class Plane:
    """Points by their names, the y axis down, and what is drawn of them."""

    def __init__(self, **points: XY) -> None:
        self.at = {name.replace("_", "'"): point for name, point in points.items()}
        self.lines: list[tuple[list[str], str, float, tuple[float, float] | None]] = []
        self.areas: list[tuple[list[str], str]] = []
        self.curve: list[XY] = []
        self.marked: set[str] = set()

    def meet(self, name: str, first: str, second: str) -> None:
        """The point of two lines, each named by two points of it."""
        ends = [self.at[n] for n in (*first.split(), *second.split())]
        x, y, w = gc.evaluate(r"ab /\ cd", {n: (*p, 1.0) for n, p in zip("abcd", ends, strict=True)}, rank=3)
        self.at[name] = (float(x / w), float(y / w))

    def line(
        self, *lines: str, role: str = "muted", width: float = 1.2, dash: tuple[float, float] | None = None
    ) -> None:
        """Lines through two points or more, each."""
        self.lines += [(names.split(), role, width, dash) for names in lines]

    def area(self, names: str, role: str) -> None:
        self.areas.append((names.split(), role))

    def draw(self, title: str, width: float = 560.0, height: float = 330.0, hidden: Iterable[str] = ()) -> Drawing:
        (x0, x1), (y0, y1) = ((min(c), max(c)) for c in zip(*self.at.values(), *self.curve, strict=True))
        factor = min((width - 70) / (x1 - x0), (height - 60) / (y1 - y0))
        width, height = (x1 - x0) * factor + 70, (y1 - y0) * factor + 60

        def place(p: XY) -> XY:
            return (p[0] - x0) * factor + 35, (p[1] - y0) * factor + 30

        at = {name: place(p) for name, p in self.at.items()}
        curve = [place(p) for p in self.curve]
        shapes: list[Shape] = [Stroke(p, q, GREEN, 1.8) for p, q in pairwise(curve)]
        strokes: list[tuple[XY, XY]] = []
        for names, role, thick, dash in self.lines:
            strokes.append(_long([at[n] for n in names]))
            shapes.append(Stroke(*strokes[-1], role, thick, dash=dash))
        for names, role in self.areas:
            shapes.append(Polygon(tuple(at[n] for n in names), role, role, 0.18, 1.0, 2.0))
        shown = {name: p for name, p in at.items() if name not in set(hidden)}
        roles = {name: "mark" if name in self.marked else "ink" for name in shown}
        shapes += [Circle(p, DOT, roles[name], "paper", 1.4) for name, p in shown.items()]
        x, y = (sum(c) / len(shown) for c in zip(*shown.values(), strict=True))
        labels = [Label(name_runs(name), p, (p[0] - x, p[1] - y), DOT, 16.0, roles[name]) for name, p in shown.items()]
        discs = [(p, DOT) for p in shown.values()]
        shapes += place_labels(labels, discs=discs, strokes=strokes, bounds=(2, 2, width - 2, height - 2))
        return Drawing(width, height, tuple(shapes), title)


def _long(points: list[XY], beyond: float = 14.0) -> tuple[XY, XY]:
    a, b = min(points), max(points)
    u = tuple((q - p) / dist(a, b) * beyond for p, q in zip(a, b, strict=True))
    return (a[0] - u[0], a[1] - u[1]), (b[0] + u[0], b[1] + u[1])


def pappus() -> Drawing:
    p = Plane(a=(0, 60), b=(120, 38.4), c=(290, 7.8), a_=(20, 201.2), b_=(150, 216.8), c_=(320, 237.2))
    p.line("a b c", "a' b' c'", role="ink", width=1.8)
    for name, first, second in (("x", "b c'", "b' c"), ("y", "c a'", "c' a"), ("z", "a b'", "a' b")):
        p.meet(name, first, second)
        p.line(first, role=BLUE, dash=DASHED)
        p.line(second, role=ORANGE, dash=DASHED)
    p.line("x y z", role="mark", width=2.2)
    p.marked = set("xyz")
    return p.draw("Pappus' theorem: the meets x, y and z of the cross joins lie on one line")


def desargues() -> Drawing:
    o, rays = (40.0, 150.0), ((1.0, -0.336), (1.0, 0.055), (1.0, 0.323))
    p = Plane(o=o)
    for name, (u, v), t in zip(
        ("a", "b", "c", "a'", "b'", "c'"), rays * 2, (116.5, 183.9, 161.4, 256.0, 298.4, 218.4), strict=True
    ):
        p.at[name] = (o[0] + t * u, o[1] + t * v)
    p.line("o a a'", "o b b'", "o c c'")
    for name, i, j in (("x", "b", "c"), ("y", "c", "a"), ("z", "a", "b")):
        p.meet(name, f"{i} {j}", f"{i}' {j}'")
        p.line(f"{i} {j} {name}", role=BLUE, dash=DASHED)
        p.line(f"{i}' {j}' {name}", role=ORANGE, dash=DASHED)
    p.area("a b c", BLUE)
    p.area("a' b' c'", ORANGE)
    p.line("x y z", role="mark", width=2.2)
    p.marked = set("xyz")
    return p.draw("Desargues' theorem: two triangles in perspective from a point, and the axis")


def ceva() -> Drawing:
    p = Plane(a=(150, 0), b=(0, 220), c=(360, 220), o=(165, 130))
    for name, corner, side in (("d", "a", "b c"), ("e", "b", "c a"), ("f", "c", "a b")):
        p.meet(name, f"{corner} o", side)
        p.line(f"{corner} {name}", role=ORANGE)
    p.area("a b c", BLUE)
    p.marked = {"o"}
    return p.draw("Ceva's theorem: the lines from the vertices of a triangle meet in a point", 430, 280)


def menelaus() -> Drawing:
    p = Plane(a=(150, 0), b=(0, 220), c=(300, 220), f=(50, 146.667), d=(480, 220))
    p.meet("e", "f d", "c a")
    p.line("b c d", "a b", "c a")
    p.line("f e d", role="mark", width=2.2)
    p.area("a b c", BLUE)
    p.marked = set("def")
    return p.draw("Menelaus' theorem: a line meets the sides of a triangle in d, e and f", 520, 280)


def harmonic() -> Drawing:
    p = Plane(p=(0, 60), q=(400, 0), a=(242, 205.2), b=(335, 261), c=(385.057, 60))
    p.meet("d", "p c", "q a")
    p.meet("x", "a c", "p q")
    p.meet("y", "b d", "p q")
    p.line("p a b", "p d c", "q d a", "q c b", role=BLUE)
    p.line("a c x", "b d y", role=ORANGE, dash=DASHED)
    p.line("p q x y", role="mark", width=2.2)
    p.marked = set("pqxy")
    return p.draw("A quadrangle abcd with its diagonal points p and q, and the meets of its diagonals with pq")


def _conic(degrees: float) -> XY:
    return 190 * cos(radians(degrees)), -100 * sin(radians(degrees))


def pascal() -> Drawing:
    p = Plane(**{n: _conic(t) for n, t in zip("acedfb", (152, 100, 35, 205, 262, 322), strict=True)})
    p.curve = [_conic(t) for t in range(0, 361, 3)]
    for name, first, second in (("x", "a b", "d e"), ("y", "b c", "e f"), ("z", "c d", "f a")):
        p.meet(name, first, second)
        p.line(first, role=BLUE)
        p.line(second, role=ORANGE)
    p.line("x y z", role="mark", width=2.2)
    p.marked = set("xyz")
    return p.draw("Pascal's theorem: the opposite sides of a hexagon in a conic meet in points of one line", 480)


def brianchon() -> Drawing:
    turns = (100, 160, 215, 262, 310, 395)
    p = Plane(**{name: _conic(t) for name, t in zip("ABCDEF", turns, strict=True)})
    p.curve = [_conic(t) for t in range(0, 361, 3)]
    corners = []
    for i, (s, t) in enumerate(zip(turns, (*turns[1:], turns[0] + 360), strict=True)):
        x, y = _conic((s + t) / 2)
        corners.append(f"corner{i}")
        p.at[corners[-1]] = (x / cos(radians((t - s) / 2)), y / cos(radians((t - s) / 2)))
    for i in range(6):
        p.line(f"{corners[i - 1]} {corners[i]}", role=BLUE, width=1.6)
    for i in range(3):
        p.line(f"{corners[i]} {corners[i + 3]}", role="mark", width=1.8)
    return p.draw("Brianchon's theorem: the diagonals of a hexagon around a conic meet in a point", 480, hidden=corners)


def _perpendicular(p: Plane, name: str, foot_of: str, side: str) -> None:
    """The foot of the perpendicular from a point on a line through two points."""
    (x, y), (ax, ay), (bx, by) = (p.at[n] for n in (foot_of, *side.split()))
    u, v = bx - ax, by - ay
    t = ((x - ax) * u + (y - ay) * v) / (u * u + v * v)
    p.at[name] = (ax + t * u, ay + t * v)


def _middle(p: Plane, name: str, ends: str) -> None:
    (ax, ay), (bx, by) = (p.at[n] for n in ends.split())
    p.at[name] = ((ax + bx) / 2, (ay + by) / 2)


def _circle(centre: XY, radius: float) -> list[XY]:
    return [(centre[0] + radius * cos(radians(t)), centre[1] + radius * sin(radians(t))) for t in range(0, 361, 3)]


def euler_line() -> Drawing:
    p = Plane(a=(150, 0), b=(0, 260), c=(430, 260))
    for foot, middle, corner, side in (("d", "p", "a", "b c"), ("e", "q", "b", "c a"), ("f", "r", "c", "a b")):
        _perpendicular(p, foot, corner, side)
        _middle(p, middle, side)
        p.line(f"{corner} {foot}", role=ORANGE, dash=DASHED)
        p.line(f"{corner} {middle}", role=BLUE, dash=DASHED)
    p.meet("h", "a d", "b e")
    p.meet("g", "a p", "b q")
    p.at["o"] = tuple((3 * g - h) / 2 for g, h in zip(p.at["g"], p.at["h"], strict=True))  # type: ignore[assignment]
    _middle(p, "n", "o h")
    p.curve = _circle(p.at["n"], dist(p.at["n"], p.at["p"]))
    p.area("a b c", BLUE)
    p.line("o g h", role="mark", width=2.2)
    p.marked = set("ogh")
    return p.draw("The line of Euler and the circle of nine points of a triangle abc", 560, 380, hidden=["n"])


def simson() -> Drawing:
    def at(degrees: float) -> XY:
        return 150 * cos(radians(degrees)), -150 * sin(radians(degrees))

    p = Plane(a=at(105), b=at(205), c=at(335), d=at(42))
    p.curve = _circle((0, 0), 150)
    for foot, side in (("x", "b c"), ("y", "c a"), ("z", "a b")):
        _perpendicular(p, foot, "d", side)
        p.line(f"{side} {foot}", role=BLUE)
        p.line(f"d {foot}", role=ORANGE, dash=DASHED)
    p.line("x y z", role="mark", width=2.2)
    p.marked = set("xyz")
    return p.draw("Simson's line: the feet of the perpendiculars from a point d of the circumcircle", 480, 380)


def butterfly() -> Drawing:
    p = Plane(a=_conic(125), c=_conic(38))
    p.curve = [_conic(t) for t in range(0, 361, 3)]
    p.at["p"], p.at["q"] = _conic(168), _conic(12)
    _middle(p, "m", "p q")
    for name, first in (("b", "a"), ("d", "c")):
        p.at[name] = _again(p.at[first], p.at["m"])
        p.line(f"{first} {name}", role=BLUE, width=1.6)
    p.meet("x", "a d", "p q")
    p.meet("y", "b c", "p q")
    p.line("a d", "b c", role=ORANGE, width=1.6)
    p.line("p q", role="mark", width=2.0)
    p.marked = set("mxy")
    return p.draw("The butterfly theorem: m is the midpoint of pq, and of xy too", 480)


def _again(a: XY, m: XY) -> XY:
    """Where the line from a point of the conic of `_conic` through m meets it again."""
    (x, y), (u, v) = ((c[0] / 190, c[1] / 100) for c in (a, (m[0] - a[0], m[1] - a[1])))
    t = -2 * (x * u + y * v) / (u * u + v * v)
    return 190 * (x + t * u), 100 * (y + t * v)


THEOREMS: dict[str, Callable[[], Drawing]] = {
    "pappus": pappus,
    "desargues": desargues,
    "ceva": ceva,
    "menelaus": menelaus,
    "harmonic": harmonic,
    "pascal": pascal,
    "brianchon": brianchon,
    "butterfly": butterfly,
    "euler-line": euler_line,
    "simson": simson,
}
"""Name in the pages: function that makes the drawing."""
