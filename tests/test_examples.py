"""Every script in examples/ is proved, and each of its claims with one side doubled is refuted."""

from __future__ import annotations

from pathlib import Path

import pytest

from gcrules.algebra.expr import Number, mul
from gcrules.algebra.prove import prove
from gcrules.algebra.statements import Claim, parse_script
from gcrules.script import run_script

SCRIPTS = sorted((Path(__file__).resolve().parent.parent / "examples").glob("*.gca"))


def test_there_are_scripts() -> None:
    assert len(SCRIPTS) > 1


@pytest.mark.parametrize("path", SCRIPTS, ids=[p.stem for p in SCRIPTS])
def test_claims(path: Path) -> None:
    script = parse_script(path.read_text(encoding="utf-8"), str(path))
    claims = [s for s in script.statements if isinstance(s, Claim)]
    assert len(claims) > 3
    assert run_script(script).to_json()["verdict"] == "proved"
    for claim in claims:
        left, right = (claim.left, claim.right) if claim.right != Number(0) else (claim.left, mul(Number(1)))
        false = prove(left, mul(Number(2), right), rank=claim.context.rank)
        assert false.verdict == "refuted", claim.label


# --- theorems -------------------------------------------------------------------------------------------------------

THEOREMS = sorted((SCRIPTS[0].parent / "theorems").glob("*.gca"))


def read(path: Path) -> list[Claim]:
    script = parse_script(path.read_text(encoding="utf-8"), str(path))
    return [s for s in script.statements if isinstance(s, Claim)]


def test_there_are_theorems_and_false_siblings() -> None:
    assert len(THEOREMS) >= 14
    assert [p.name for p in THEOREMS] == sorted(p.name for p in THEOREMS[0].parent.glob("false/*.gca"))


@pytest.mark.parametrize("path", THEOREMS, ids=[p.stem for p in THEOREMS])
def test_theorem(path: Path) -> None:
    """The theorem is proved; its sibling, under the same assumptions, is refuted by points that satisfy them."""
    assert read(path)
    assert run_script(parse_script(path.read_text(encoding="utf-8"))).verdict == "proved"
    sibling = path.parent / "false" / path.name
    assert [c.context.given for c in read(sibling)[:1]] == [c.context.given for c in read(path)[:1]]
    results = run_script(parse_script(sibling.read_text(encoding="utf-8"))).claims
    assert [r.verdict for r in results] == ["refuted"] * len(results)
    for result in results:
        assert result.proof is not None
        assert result.proof.counterexample
