"""Loci as polynomials, beside the determinant of the symbolic 6×6 matrix that one writes with sympy.

Translations at a fixed turn are the largest case in which the determinant by sympy ends within seconds. With all seven
variables it does not end in two minutes (DomainMatrix.det in the ring of polynomials), so there is a goal in seconds
instead. The factors count, too; caches are emptied, for sympy's would answer the second time.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import sympy
from sympy.core.cache import clear_cache

import gcrules as gc
from gcrules.mechanisms.analyze import analyze_legs
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.poses.loci.expansion import expansion
from gcrules.poses.loci.locus import locus

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
ROBOTS = ("octahedral", "platform-6-6")


def naive(analysis: gc.Analysis) -> Any:
    """The superbracket of the translated platform, expanded."""
    assert analysis.platform is not None
    clear_cache()
    shift = sympy.Matrix(sympy.symbols("x y z"))
    rows = []
    for leg in analysis.structure.legs:
        p, q = (
            sympy.Matrix([sympy.Rational(*c.as_integer_ratio()) for c in analysis.platform.points[n]])
            + (shift if analysis.structure.sides[n] == "platform" else sympy.zeros(3, 1))
            for n in leg
        )
        rows.append([*(q - p), *p.cross(q)])
    return sympy.expand(-sympy.Matrix(rows).det(method="berkowitz"))


def afresh(analysis: gc.Analysis, *arguments: str) -> Any:
    expansion.cache_clear()
    clear_cache()
    found = locus(analysis, *arguments)
    return found, found.factors


@pytest.mark.parametrize("robot", ROBOTS)
def test_translations(ratio: Callable[..., Any], robot: str) -> None:
    analysis = analyze_legs(load_platform(EXAMPLES / f"{robot}.yaml"))

    def agree(mine: Any, other: Any) -> bool:
        scale = sympy.Rational(*mine[0].coefficient.as_integer_ratio())
        return bool(sympy.expand(scale * mine[0].to_sympy() - other) == 0)

    ratio(
        lambda: afresh(analysis, "translation"),
        {"Matrix.det and expand": lambda: naive(analysis)},
        agree=agree,
        at_least={"Matrix.det and expand": 20},
        rounds=3,
    )


@pytest.mark.parametrize("robot", ROBOTS)
def test_all_poses(ratio: Callable[..., Any], robot: str) -> None:
    analysis = analyze_legs(load_platform(EXAMPLES / f"{robot}.yaml"))
    ratio(lambda: afresh(analysis), {}, within=2, rounds=3)
