"""Every script in examples/ is proved, and each of its claims with one side doubled is refuted."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import pytest
from places import EXAMPLES

from gcrules.algebra.assumptions.assumed import equations
from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import Number, mul, points_of
from gcrules.algebra.language.statements import Claim, parse_script
from gcrules.algebra.prove import prove
from gcrules.rules.script import run_script

SCRIPTS = sorted(EXAMPLES.glob("*.gca"))


def test_there_are_scripts() -> None:
    assert len(SCRIPTS) > 1


@pytest.mark.parametrize("path", SCRIPTS, ids=[p.stem for p in SCRIPTS])
def test_claims(path: Path) -> None:
    script = parse_script(path.read_text(encoding="utf-8"), str(path))
    claims = [s for s in script.statements if isinstance(s, Claim)]
    assert len(claims) > 3
    assert run_script(script).to_json()["verdict"] == "proved"
    for claim in claims:
        ((left, right),) = claim.claimed.equations
        right = mul(Number(1)) if right == Number(0) else right
        false = prove(left, mul(Number(2), right), rank=claim.context.rank)
        assert false.verdict == "refuted", claim.label


# --- theorems -------------------------------------------------------------------------------------------------------

THEOREMS = sorted((SCRIPTS[0].parent / "theorems").glob("*.gca"))


def read(path: Path) -> list[Claim]:
    script = parse_script(path.read_text(encoding="utf-8"), str(path))
    return [s for s in script.statements if isinstance(s, Claim)]


def test_there_are_theorems_and_false_siblings() -> None:
    assert len(THEOREMS) >= 23
    assert [p.name for p in THEOREMS] == sorted(p.name for p in THEOREMS[0].parent.glob("false/*.gca"))


@pytest.mark.parametrize("path", THEOREMS, ids=[p.stem for p in THEOREMS])
def test_theorem(path: Path) -> None:
    """The theorem is proved; its sibling is refuted by points that satisfy the sibling's assumptions."""
    lines = path.read_text(encoding="utf-8").splitlines()
    assert [line[:2] for line in lines[:2]] == ["# ", "# "], "a title, then the theorem in words"
    assert read(path)
    assert run_script(parse_script(path.read_text(encoding="utf-8"))).verdict == "proved"


@pytest.mark.parametrize("path", THEOREMS, ids=[p.stem for p in THEOREMS])
def test_false_sibling(path: Path) -> None:
    sibling = path.parent / "false" / path.name
    text = sibling.read_text(encoding="utf-8")
    assert text.startswith("# False: ")
    claims = read(sibling)
    for claim, result in zip(claims, run_script(parse_script(text)).claims, strict=True):
        assert result.verdict == "refuted"
        assert result.proof is not None
        points = result.proof.counterexample
        assert points
        rank = claim.context.rank
        for e in (e for a in claim.context.given for e in equations(a, rank)):
            # An equation may speak of any point, which then has no coordinates: it is zero for each of a basis.
            open_points = [n for n in points_of(e) if n not in points]
            basis = [tuple(int(i == j) for j in range(rank)) for i in range(rank)]
            for chosen in combinations(basis, len(open_points)):
                at = {**points, **dict(zip(open_points, chosen, strict=True))}
                assert not any(Evaluator(at, rank).value(e))
        values = [[Evaluator(points, rank).value(side) for side in equation] for equation in claim.claimed.equations]
        assert any(left != right and any((*left, *right)) for left, right in values)
