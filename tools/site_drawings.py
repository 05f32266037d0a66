"""The drawings of the guide, by name; `python tools/check_docs.py --write` writes them into docs/assets/drawings.

Everything is drawn by gcrules itself (`gcrules.views`), so the bytes are the same everywhere, and the colours follow
the page from light to dark.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from drawing_kit import BLUE, GREEN, ORANGE, Look, Space, between, caption, side_by_side, times
from site_theorems import THEOREMS

import gcrules as gc
from gcrules.mechanisms.analyze import analyze_legs
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.views.drawing.bsp import XYZ, CutPolygon
from gcrules.views.drawing.drawing import Drawing, Polygon, Run, Shape, Stroke, Text, name_runs, text_width
from gcrules.views.drawing.figures import graph_figure, robot_figure
from gcrules.views.drawing.solids import stretched

ROOT = Path(__file__).resolve().parent.parent


# --- the course ----------------------------------------------------------------------------------------------------


def extensors() -> Drawing:
    size = (180.0, 150.0)
    one = Space()
    one.point(a=(0.0, 0.0, 0.0))
    two = Space()
    two.point(a=(0.0, -0.75, -0.2), b=(0.0, 0.75, 0.35))
    two.line("a", "b", beyond=0.3)
    two.head("a", between(two.at("a"), two.at("b"), 0.55))
    three = Space()
    three.point(a=(0.8, -0.7, 0.0), b=(0.5, 0.8, 0.05), c=(-0.9, 0.1, 0.3))
    three.plane("a", "b", "c", margin=0.22)
    three.turn("a", "b", "c", radius=0.3)
    four = Space()
    four.point(a=(0.7, -0.7, 0.0), b=(0.6, 0.75, 0.0), c=(-0.9, -0.2, 0.0), d=(0.0, 0.1, 1.15))
    four.tetrahedron("a", "b", "c", "d")
    view = (25.0, 26.0)
    return side_by_side(
        "A point, a line through two points, a plane through three and a tetrahedron of four",
        one.draw("", view=view, size=size, scale=90, caption=caption("a", "point, step 1")),
        two.draw("", view=view, size=size, caption=caption("ab", "line, step 2")),
        three.draw("", view=view, size=size, caption=caption("abc", "plane, step 3")),
        four.draw("", view=view, size=size, caption=caption("abcd", "space, step 4")),
        gap=4,
    )


def join() -> Drawing:
    left = Space()
    left.point(a=(0.9, -0.9, 0.0), b=(0.6, 0.9, 0.1), c=(-0.9, 0.1, 0.25))
    left.plane("a", "b", "c", margin=0.25)
    left.line("a", "b", ORANGE, beyond=0.3)
    right = Space()
    right.point(a=(1.0, -0.2, 0.0), b=(-0.7, 0.75, 0.0), c=(0.9, 0.0, 1.2), d=(-0.9, 0.4, 0.8))
    right.tetrahedron("a", "b", "c", "d", role="muted")
    right.line("a", "b", ORANGE, beyond=0.25)
    right.line("c", "d", BLUE, beyond=0.25)
    return side_by_side(
        "The join of a line and a point is a plane; two skew lines span all of space",
        left.draw(
            "",
            view=(25.0, 30.0),
            size=(300.0, 190.0),
            caption=(*name_runs("ab"), Run(" ∨ "), *name_runs("c"), Run("  is the plane "), *name_runs("abc")),
        ),
        right.draw(
            "",
            view=(30.0, 18.0),
            size=(300.0, 190.0),
            caption=(
                *name_runs("ab"),
                Run(" ∨ "),
                *name_runs("cd"),
                Run("  is "),
                *name_runs("abcd"),
                Run(", all of space"),
            ),
        ),
    )


def _pierce(a: XYZ, b: XYZ, c: XYZ, d: XYZ, e: XYZ) -> XYZ:
    """Where the line ab pierces the plane cde, by the formula of the page: [acde] b − [bcde] a."""
    at = {n: (*p, 1.0) for n, p in zip("abcde", (a, b, c, d, e), strict=True)}
    x, y, z, w = gc.evaluate(r"ab /\ cde", at)
    return float(x / w), float(y / w), float(z / w)


def meet() -> Drawing:
    left = Space()
    left.point(
        a=(0.35, -0.35, 1.0), b=(-0.15, 0.3, -0.8), c=(1.0, -0.85, 0.0), d=(0.75, 0.95, 0.05), e=(-1.0, 0.1, 0.1)
    )
    x = _pierce(*(left.at(n) for n in "abcde"))
    left.plane("c", "d", "e", margin=0.25)
    left.line("a", "b", ORANGE, beyond=0.2)
    left.points["x"] = (x, "mark")
    right = Space()
    right.point(
        a=(0.9, -0.9, 0.0),
        b=(0.9, 0.75, 0.0),
        c=(-0.9, -0.1, 0.0),
        d=(0.55, -0.55, 0.85),
        e=(-0.45, 0.55, 0.85),
        f=(0.3, -0.1, -0.75),
    )
    p = _pierce(right.at("d"), right.at("f"), right.at("a"), right.at("b"), right.at("c"))
    q = _pierce(right.at("e"), right.at("f"), right.at("a"), right.at("b"), right.at("c"))
    right.plane("a", "b", "c", margin=0.25)
    right.plane("d", "e", "f", role=ORANGE, margin=0.22)
    right.line(p, q, "mark", beyond=0.35, width=3.0)
    return side_by_side(
        "A line pierces a plane in a point; two planes meet in a line",
        left.draw(
            "",
            view=(28.0, 22.0),
            size=(300.0, 215.0),
            caption=(*name_runs("ab"), Run(" ∧ "), *name_runs("cde"), Run("  is the point "), *name_runs("x")),
        ),
        right.draw(
            "",
            view=(52.0, 20.0),
            size=(300.0, 215.0),
            caption=(*name_runs("abc"), Run(" ∧ "), *name_runs("def"), Run("  is a line")),
        ),
    )


def bracket() -> Drawing:
    size = (205.0, 190.0)
    base: dict[str, Any] = {"a": (0.9, -0.8, 0.0), "b": (0.5, 0.9, 0.0), "c": (-0.9, -0.3, 0.0)}
    view = (25.0, 24.0)

    def one(d: XYZ, words: tuple[Run, ...], role: str, scale: float) -> Drawing:
        s = Space()
        s.point(**base)
        s.point(d=d)
        if abs(d[2]) < 1e-9:
            s.plane("a", "b", "c", "d", role=role, margin=0.2)
        else:
            s.tetrahedron("a", "b", "c", "d", role=role)
        s.turn("a", "b", "c", role=role, radius=0.27)
        return s.draw("", view=view, size=size, caption=words, scale=scale)

    name = (Run("[ "), *name_runs("abcd"), Run(" ]"))
    return side_by_side(
        "The bracket of four points changes its sign as the fourth goes through the plane of the others",
        one((0.1, 0.05, 1.15), (*name, Run(" < 0")), BLUE, 84.0),
        one((0.72, -0.22, 0.0), (*name, Run(" = 0, one plane")), "mark", 84.0),
        one((0.1, 0.05, -1.15), (*name, Run(" > 0")), ORANGE, 84.0),
        gap=4,
    )


HUNT = {
    "a": (6, -8, 0),
    "c": (-9, 1, 0),
    "e": (6, 8, 0),
    "b": (1, -7, 10),
    "d": (2, 8, 8),
    "f": (-1, 1, 14),
}
"""An octahedral platform whose platform plane bdf holds the edge ae of the base: x = 6 − z/2. Example, invented."""


def crossing_legs() -> Drawing:
    """Six legs that all cross one line: the platform can turn about it."""
    at = {n: times(p, 0.1) for n, p in HUNT.items()}
    s = Space()
    for name, p in at.items():
        s.point("ink" if name in "ace" else "leg", **{name: p})
    s.pieces.append(CutPolygon(tuple(at[n] for n in "ace"), Look("base", fill=0.2, edge=0.9, width=1.3)))
    s.pieces.append(CutPolygon(tuple(at[n] for n in "bdf"), Look("platform", fill=0.3, edge=0.9, width=1.3)))
    for leg in ("ab", "af", "cb", "cd", "ed", "ef"):
        role = BLUE if "f" in leg else "leg"
        s.line(leg[0], leg[1], role, width=3.2)
    ends = stretched((at["b"], at["d"]), 0.5)
    s.line(*ends, "mark", width=2.4, dashed=True)
    s.name("p", ends[1], (1.0, -0.4), "mark")
    return s.draw("An octahedral platform whose six legs all cross the line p", view=(-28.0, 17.0), size=(430.0, 330.0))


def tableaux() -> Drawing:
    """Straightening of the page's example, the tableaux with their signs."""
    found = gc.straighten("[p1p4p5][p1p5p6][p2p3p4]", rank=3)
    start = ("145", "156", "234")
    signed: list[tuple[str, tuple[str, ...]]] = []
    for factors, coefficient in _terms(found):
        signed.append(("+" if coefficient > 0 else "−", factors))
    cell, gap, top = 34.0, 46.0, 40.0
    shapes: list[Shape] = []

    def tableau(x: float, rows: Sequence[str], bad: frozenset[tuple[int, int]]) -> None:
        for i, row in enumerate(rows):
            for j, letter in enumerate(row):
                left, up = x + j * cell, top + i * cell
                corners = ((left, up), (left + cell, up), (left + cell, up + cell), (left, up + cell))
                hit = (i, j) in bad
                shapes.append(Polygon(corners, "mark" if hit else BLUE, "muted", 0.28 if hit else 0.1, 1.0, 1.1))
                shapes.append(
                    Text(
                        (left + cell / 2, up + cell / 2 + 5),
                        name_runs(f"p{letter}"),
                        16,
                        "middle",
                        "mark" if hit else "ink",
                    )
                )

    tableau(14, start, frozenset({(1, 1), (2, 1), (1, 2), (2, 2)}))
    x = 14 + 3 * cell
    for i, (sign, rows) in enumerate(signed):
        word = "=" if i == 0 else sign
        if i == 0 and sign == "−":
            word = "= −"
        shapes.append(Text((x + gap / 2, top + 1.5 * cell + 6), (Run(word),), 20, "middle"))
        tableau(x + gap, rows, frozenset())
        x += gap + 3 * cell
    shapes.append(Text((14 + 1.5 * cell, 26), (Run("not standard"),), 14, "middle", "mark"))
    middle = (14 + 3 * cell + gap + x) / 2
    shapes.append(Text((middle, 26), (Run("standard: no column falls"),), 14, "middle", "muted"))
    return Drawing(
        x + 14, top + 3 * cell + 14, tuple(shapes), "A tableau with falling columns as a sum of standard ones"
    )


def _terms(p: object) -> list[tuple[tuple[str, ...], int]]:
    """Rows and coefficient of each term, read from the text of a polynomial in the points p1 … p6."""
    out = []
    text = str(p).replace(" - ", " + -")
    for term in text.split(" + "):
        rows = tuple(
            part.replace("p", "").replace(" ", "") for part in term.strip("-").strip("]").lstrip("[").split("][")
        )
        out.append((rows, -1 if term.startswith("-") else 1))
    return out


# --- the procedure -------------------------------------------------------------------------------------------------


def _analysis(name: str) -> gc.Analysis:
    return analyze_legs(load_platform(ROOT / "examples" / f"{name}.yaml"))


def octahedral_graph() -> Drawing:
    return graph_figure(_analysis("octahedral"))


def octahedral() -> Drawing:
    return robot_figure(_analysis("octahedral"))


def octahedral_singular() -> Drawing:
    return robot_figure(_analysis("octahedral-singular"))


def four_dof() -> Drawing:
    return robot_figure(_analysis("four-dof"))


def four_dof_limbs() -> Drawing:
    """The lines along which each limb of the robot can push."""
    platform = load_platform(ROOT / "examples" / "four-dof.yaml")
    at: dict[str, Any] = {n: tuple(map(float, c)) for n, c in platform.points.items()}
    s = Space()
    s.point("ink", **{n: p for n, p in at.items() if n[0] != "S"})
    s.point("leg", **{n: p for n, p in at.items() if n[0] == "S"})
    s.pieces.append(
        CutPolygon(tuple(at[n] for n in ("S1", "S2", "S3")), Look("platform", fill=0.25, edge=0.9, width=1.3))
    )
    for end in ("A1", "B1", "C1"):
        s.line(end, "S1", BLUE, width=3.0)
    s.line("A2", "S2", GREEN, width=3.0)
    s.plane("A3", "B3", "S3", role=ORANGE, margin=0.07)
    s.line("A3", "B3", "muted", width=1.4, dashed=True, beyond=0.12)
    for end in ("A3", "B3"):
        s.line(end, "S3", ORANGE, width=3.0)
    d = s.draw("The forces that the three limbs can apply", view=(-52.0, 20.0), size=(430.0, 300.0))
    rows = (
        (BLUE, "limb 1: any force through S", "1"),
        (GREEN, "limb 2: a force along the leg", ""),
        (ORANGE, "limb 3: forces through S", "3"),
    )
    shapes = list(d.shapes)
    for i, (role, words, index) in enumerate(rows):
        y = 20.0 + 22 * i
        runs = (Run(words[:-1]), Run("S", "italic"), Run(index, "subscript")) if index else (Run(words),)
        shapes += [Stroke((438, y), (460, y), role, 3.0), Text((468, y + 4.5), runs, 14)]
    shapes.append(Text((468, 20.0 + 22 * 2 + 22.5), (Run("in the plane with its axis"),), 14))
    width = 468 + max(text_width(Text((0, 0), (Run(words),), 14)) for _, words, _ in rows)
    return Drawing(width, d.height, tuple(shapes), d.title)


DRAWINGS: dict[str, Callable[[], Drawing]] = {
    "extensors": extensors,
    "join": join,
    "meet": meet,
    "bracket": bracket,
    "crossing-legs": crossing_legs,
    "tableaux": tableaux,
    "octahedral-graph": octahedral_graph,
    "octahedral": octahedral,
    "octahedral-singular": octahedral_singular,
    "four-dof": four_dof,
    "four-dof-limbs": four_dof_limbs,
    **THEOREMS,
}
"""Name in the pages: function that makes the drawing."""
