"""Discovering the theorems of a construction, beside the proof of every candidate line by itself."""

from __future__ import annotations

from collections.abc import Callable
from itertools import combinations
from pathlib import Path
from time import process_time
from typing import Any

import pytest

from gcrules.algebra.discovery.discover import discover
from gcrules.algebra.discovery.figure import figure_of
from gcrules.algebra.expr import ZERO
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.prove import prove

THEOREMS = Path(__file__).resolve().parent.parent / "examples" / "theorems"


@pytest.mark.parametrize("name", ["pappus", "desargues", "newton-gauss"])
def test_a_construction(timed: Callable[..., Any], name: str) -> None:
    """All relations here, lines alone there."""
    at = parse_script((THEOREMS / f"{name}.gca").read_text(encoding="utf-8"), name).context
    figure = figure_of(at)
    ours = []
    for _ in range(3):
        began = process_time()
        found = discover(at, seconds=0)
        ours.append(process_time() - began)
    told = {three for d in found.found if d.relation == "collinear" for three in combinations(d.names, 3)}
    assert told
    began = process_time()
    lines = {
        three
        for three in combinations(figure.points, 3)
        if prove(figure.joined(three), ZERO, rank=at.rank, ideal=at.ideal, given=at.given).proved
    }
    assert told <= lines
    timed(min(ours), {"every three points": process_time() - began}, within=1)
