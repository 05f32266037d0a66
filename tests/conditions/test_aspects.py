"""How many aspects a class has at least: signs of determinants of random platforms, far away."""

from __future__ import annotations

import re

import numpy as np
import pytest
from places import ROOT

import gcrules as gc
from gcrules.algebra.evaluate import evaluate
from gcrules.conditions.aspects import least_aspects
from gcrules.rules.catalog.file import load as load_catalog

CLASSES = [
    ("6-3.1", (1, 1, 1), 8),
    ("4-4.3", (1, 1, 1), 8),
    ("3-3.1", (1, 1, 1), 8),
    ("6-4.1", (1, 2), 4),
    ("4-4.4", (1, 2), 4),
    ("4-3.6", (1, 2), 4),
    ("6-6", (3,), 2),
    ("6-5", (3,), 2),
    ("3-3.3", (3,), 2),
]


@pytest.mark.parametrize(("name", "degrees", "number"), CLASSES)
def test_degrees_and_numbers(name: str, degrees: tuple[int, ...], number: int) -> None:
    found = least_aspects(gc.analyze(name))
    assert found is not None
    assert (tuple(sorted(found.degrees)), found.number) == (degrees, number)


@pytest.mark.parametrize("name", [c[0] for c in CLASSES])
def test_so_many_patterns_occur_far_away(name: str) -> None:
    """A random platform in one orientation, translated in random directions."""
    a = gc.analyze(name)
    found = least_aspects(a)
    assert found is not None
    random = np.random.default_rng(5)
    names = a.structure.names
    at = {n: random.integers(-20, 20, 3) for n in names}
    patterns = set()
    for direction in random.integers(-(10**6), 10**6, (300, 3)):
        points = {n: (*map(int, p + (direction if n in a.structure.platform else 0)), 1) for n, p in at.items()}
        patterns.add(tuple(np.sign(evaluate(f, points)) for f in found.factors))
    assert len({p for p in patterns if 0 not in p}) >= found.number


def test_always_singular_legs_have_none() -> None:
    assert least_aspects(gc.analyze("6-2")) is None


def test_the_guide_lists_all_regular_classes_by_their_number() -> None:
    rows = re.findall(r"^\| .* \| (\d) \| (.*) \|$", (ROOT / "docs" / "aspects.md").read_text("utf-8"), re.MULTILINE)
    listed = {name: int(number) for number, names in rows for name in re.findall(r"\[([^\]]+)\]", names)}
    found = {e.id: least_aspects(gc.analyze(e.id)) for e in load_catalog().entries}
    numbers = {name: least.number for name, least in found.items() if least is not None}
    assert len(numbers) == 34
    assert listed == {name: number for name, number in numbers.items() if number > 2}
    assert f"the other {len(numbers) - len(listed)} regular classes" in rows[-1][1]
