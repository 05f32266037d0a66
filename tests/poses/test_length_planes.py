"""Planes cut by curves that everyone knows: the cells, and what is connected."""

from __future__ import annotations

from fractions import Fraction
from math import isclose, sqrt

import pytest

from gcrules.poses.length_regions.curve import SingularCurve
from gcrules.poses.length_regions.slabs import Plane, plane

Box = tuple[int, int, int, int]

CIRCLE = ((-1, 0, 1), (0,), (1,))
CUSP = ((0, 0, 0, -1), (0,), (1,))  # y² = x³
NODE = ((0, 0, -1, -1), (0,), (1,))  # y² = x² + x³
POINT = ((0, 0, 1, -1), (0,), (1,))  # y² = x³ − x²: an isolated point, and a branch
LINES = ((0, 0, -25, 0, 1), (0, 0, 10), (25, 0, -2), (-10,), (1,))  # (y² − x²)((y − 5)² − x²)


def cut(columns: tuple[tuple[int, ...], ...], box: Box) -> Plane:
    a, b, c, d = map(Fraction, box)
    found = plane(SingularCurve(columns), ((a, b), (c, d)))
    assert found is not None
    return found


CASES: dict[str, tuple[tuple[tuple[int, ...], ...], Box, int]] = {
    "circle": (CIRCLE, (-2, 2, -2, 2), 2),
    "circle, beside the middle": (CIRCLE, (0, 2, -2, 2), 2),
    "circle, in a box as high": (CIRCLE, (-2, 2, -1, 1), 3),
    "circle, that stands on the edge": (CIRCLE, (-2, 2, -1, 3), 2),
    "circle, below the box": (CIRCLE, (-2, 2, 1, 3), 1),
    "circle, cut by an edge": (CIRCLE, (-2, 2, 0, 2), 2),
    "circle, inside of it": (CIRCLE, (-2, 2, -3, -2), 1),
    "circle, larger than the box": (CIRCLE, (-1, 1, -2, 2), 3),
    "cusp": (CUSP, (-1, 3, -2, 2), 2),
    "loop": (NODE, (-2, 1, -3, 3), 3),
    "loop, its node on the edge": (NODE, (-2, 1, 0, 3), 3),
    "isolated point": (POINT, (-1, 3, -9, 9), 2),
}


@pytest.mark.parametrize(("columns", "box", "number"), CASES.values(), ids=CASES)
def test_how_many(columns: tuple[tuple[int, ...], ...], box: Box, number: int) -> None:
    found = cut(columns, box)
    least, most = (len(found.parts(unsure=unsure)) for unsure in (True, False))
    assert least <= number <= most
    if not found.unsure:
        assert least == most == number


def test_all_are_sure_but_where_an_edge_meets_a_double_point() -> None:
    found = [name for name, (columns, box, _) in CASES.items() if cut(columns, box).unsure]
    assert found == ["circle, cut by an edge", "loop, its node on the edge"]


def test_two_crossings_on_one_line_are_left_open() -> None:
    found = cut(LINES, (-1, 1, -9, 9))
    assert len(found.parts(unsure=False)) == 7
    assert len(found.parts(unsure=True)) < 7


def test_double_points() -> None:
    kinds = {}
    for columns in (CUSP, NODE, POINT):
        (point,) = [p for p in cut(columns, (-3, 3, -9, 9)).double if p.ends != (2, 0)][-1:]
        kinds[columns] = point.ends
        assert isclose(float(point.middle), 0, abs_tol=1e-9)
    assert kinds[CUSP] == (0, 2)
    assert kinds[NODE] == (2, 2)


def test_cells_have_their_places() -> None:
    found = cut(CIRCLE, (-2, 2, -2, 2))
    inside = found.cell_at(Fraction(0), Fraction(0))
    assert inside is not None
    outside = found.cell_at(Fraction(0), Fraction(3, 2))
    assert outside is not None
    assert inside != outside
    assert found.cell_at(Fraction(0), Fraction(1)) is None
    assert isclose(float(found.branches(Fraction(1, 2))[2][0]), sqrt(3) / 2, rel_tol=1e-9)
