"""Proof files: written beside the proof by normal forms, and checked beside both sides' values at exact points."""

from __future__ import annotations

import importlib
import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import Expr, sub
from gcrules.algebra.proofs.proving import theorem
from gcrules.algebra.prove import prove
from gcrules.rules.catalog.file import load

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "checkers"))
check_proof = importlib.import_module("check_proof")

READINGS = {"four planes": ("3-3.3", 0), "one incidence": ("5-5.1", 1), "the screw of five legs": ("6-6", 1)}


def sides(name: str) -> tuple[Expr, Expr]:
    class_id, number = READINGS[name]
    entry = load()[class_id]
    return entry.sides((entry.condition, *entry.readings)[number])


@pytest.mark.parametrize("name", READINGS)
def test_writing(ratio: Callable[..., Any], name: str) -> None:
    left, right = sides(name)
    ratio(lambda: theorem(name, left, right), {"normal form": lambda: prove(left, right)})


@pytest.mark.parametrize("name", READINGS)
def test_checking(ratio: Callable[..., Any], name: str) -> None:
    left, right = sides(name)
    data = json.loads(json.dumps(theorem(name, left, right).to_json()))
    difference = sub(left, right)
    ratio(lambda: check_proof.check(data), {"exact points": lambda: vanishes(difference)})
