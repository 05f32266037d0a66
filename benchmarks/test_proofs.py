"""Proof files: written beside the proof by normal forms, and checked beside both sides expanded at exact points."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from typing import Any

import pytest

import gcrules as gc
from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import Number, mul, sub
from gcrules.algebra.proofs.theorem import theorem
from gcrules.rules.catalog.file import load

CHECKER = Path(__file__).resolve().parent.parent / "tools" / "check_proof.py"
READINGS = {"four planes": ("3-3.3", 0), "one incidence": ("5-5.1", 1), "the screw of five legs": ("6-6", 1)}


def sides(name: str) -> tuple[Any, Any]:
    class_id, number = READINGS[name]
    entry = load()[class_id]
    reading = (entry.condition, *entry.readings)[number]
    return mul(reading.cofactor, entry.structure.superbracket), mul(Number(reading.coefficient), reading.expression)


def checker() -> Any:
    spec = importlib.util.spec_from_file_location("check_proof", CHECKER)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.superbracket_terms()  # compared with the determinant once
    return module


@pytest.mark.parametrize("name", READINGS)
@pytest.mark.parametrize("how", ["written", "normal form"])
def test_writing(benchmark: Any, name: str, how: str) -> None:
    left, right = sides(name)
    benchmark.group = f"a proof written: {name}"
    if how == "written":
        benchmark(theorem, name, left, right)
    else:
        benchmark(gc.prove, left, right)


@pytest.mark.parametrize("name", READINGS)
@pytest.mark.parametrize("how", ["checked", "exact points"])
def test_checking(benchmark: Any, name: str, how: str) -> None:
    left, right = sides(name)
    benchmark.group = f"a proof checked: {name}"
    if how == "checked":
        data = json.loads(json.dumps(theorem(name, left, right).to_json()))
        benchmark(checker().check, data)
    else:
        benchmark(vanishes, sub(left, right))
