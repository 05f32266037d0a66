"""The page on speed shows the numbers that were measured, and measuring compares with the peer term by term."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from gcrules.algebra.straightening.straighten import straighten_terms


@pytest.fixture(scope="module")
def scale(root: Path) -> Iterator[ModuleType]:
    """benchmarks/scale.py, which finds its siblings beside it."""
    sys.path.insert(0, str(root / "benchmarks"))
    try:
        import scale

        yield scale
    finally:
        sys.path.remove(str(root / "benchmarks"))


@pytest.fixture(scope="module")
def results(scale: ModuleType) -> Any:
    return json.loads(scale.RESULTS.read_text(encoding="utf-8"))


def test_the_picture_shows_the_results(scale: ModuleType, results: Any) -> None:
    assert scale.CURVE.read_text(encoding="utf-8") == scale.curve(results).svg(), "run python benchmarks/scale.py"
    drawn = scale.factoring_curve(results["factoring"]).svg()
    assert scale.FACTORING_CURVE.read_text(encoding="utf-8") == drawn, "run python benchmarks/scale.py"


def test_the_table_shows_the_results(scale: ModuleType, results: Any) -> None:
    text = scale.PAGE.read_text(encoding="utf-8")
    assert scale.page(text, results) == text, "run python benchmarks/scale.py"
    assert scale.table(results) in text
    assert scale.factoring_table(results) in text


def test_what_the_page_says_of_the_results(scale: ModuleType, results: Any) -> None:
    """All sizes were measured; gcrules needs less than a second, and never more than the peer with its basis."""
    assert [(r["rank"], r["points"]) for r in results["runs"]] == [(d, n) for d, s in scale.SIZES.items() for n in s]
    for run in results["runs"]:
        assert run["gcrules"] < 1
        if run.get("macaulay2"):
            assert run["gcrules"] < run["macaulay2"]["basis"] + run["macaulay2"]["forms"]


@pytest.mark.parametrize(("rank", "points"), [(3, 7), (4, 9)])
def test_the_worker_finds_the_normal_forms(scale: ModuleType, rank: int, points: int) -> None:
    monomials = scale.products(rank, points, 4)
    assert all({i for row in m for i in row} == set(range(points)) for m in monomials)
    seconds, forms = scale.by_gcrules(monomials)
    assert seconds >= 0
    assert forms == [straighten_terms({m: 1}) for m in monomials]


def test_what_the_page_says_of_factoring(scale: ModuleType, results: Any) -> None:
    """All sizes were measured; gcrules needs a few seconds at most, and always less than sympy where that ended."""
    factoring = scale.factoring
    runs = results["factoring"]["runs"]
    products = [(run["rank"], run["points"]) for run in runs if run["kind"] == "products"]
    assert products == [(rank, n) for rank, sizes in factoring.SIZES.items() for n in sizes]
    assert [(run["rank"], run["expression"]) for run in runs if run["kind"] == "expression"] == factoring.PLANTED
    for run in runs:
        assert run["gcrules"] < 3
        assert not run.get("sympy") or 5 * run["gcrules"] < run["sympy"]


@pytest.mark.parametrize(("rank", "points"), [(3, 7), (4, 6)])
def test_the_worker_factors_products(scale: ModuleType, rank: int, points: int) -> None:
    expressions = scale.factoring.bracketed(rank, points, 2)
    seconds, terms, found = scale.factoring.by_gcrules(rank, expressions)
    assert seconds >= 0
    assert terms >= 1
    assert found == [True, True]


def test_sympy_factors_the_same_products(scale: ModuleType) -> None:
    pytest.importorskip("sympy")
    found = scale.factoring.by_sympy(3, ["[abc][def]"])
    assert found is not None
    assert found[1:] == [36, [2]]


PRINTED = "{.105, .00065}\n{{1, {{{0, 2}, 1}, {{1, 3}, 2}}}, {-2, {{{0, 1}, 3}}}}\n{}\n"


@pytest.mark.parametrize(("code", "found"), [(0, True), (-9, False), (-24, False)])
def test_what_macaulay2_prints_is_read(
    monkeypatch: pytest.MonkeyPatch, scale: ModuleType, tmp_path: Path, code: int, found: bool
) -> None:
    """Also when it is not there. A run that was stopped (SIGKILL, SIGXCPU) has no result."""
    monkeypatch.setattr(scale, "SCRIPTS", tmp_path)
    monkeypatch.setattr(
        scale.subprocess, "run", lambda *args, **_: subprocess.CompletedProcess(args, code, stdout=PRINTED, stderr="")
    )
    forms = [{((0, 2), (1, 3), (1, 3)): 1, ((0, 1), (0, 1), (0, 1)): -2}, {}]
    read = scale.by_macaulay2(2, [((0, 2), (1, 3))])
    assert read == ((0.105, 0.00065, forms) if found else None)
    assert "Grassmannian(2 - 1, 4 - 1" in next(tmp_path.iterdir()).read_text(encoding="utf-8")


def test_a_failure_of_macaulay2_is_not_silent(
    monkeypatch: pytest.MonkeyPatch, scale: ModuleType, tmp_path: Path
) -> None:
    monkeypatch.setattr(scale, "SCRIPTS", tmp_path)
    failed = subprocess.CompletedProcess((), 1, stdout="", stderr="")
    monkeypatch.setattr(scale.subprocess, "run", lambda *_, **__: failed)
    with pytest.raises(subprocess.CalledProcessError):
        scale.by_macaulay2(2, [((0, 2), (1, 3))])
