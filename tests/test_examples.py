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
