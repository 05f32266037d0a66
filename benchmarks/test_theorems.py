"""Every theorem of examples/theorems with its assumptions, beside Gröbner bases of Singular and Macaulay2."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from ideals import SYSTEMS, ideals_of, run
from measurement import Over

from gcrules.algebra.language.statements import Claim, parse_script

THEOREMS = Path(__file__).resolve().parent.parent / "examples" / "theorems"
LIMIT = 20  # seconds of processor time for one claim

OURS = """\
import sys
from pathlib import Path
from time import process_time
from gcrules.algebra.language.statements import Claim, parse_script
from gcrules.algebra.decide import decide
claims = [s for s in parse_script(Path({path!r}).read_text(encoding="utf-8")).statements if isinstance(s, Claim)]
began = process_time()
true = True
for c in claims:
    true = decide(c.claimed, c.context).proved and true
print("answer", int(true), process_time() - began)
"""


def claims(path: Path) -> list[Claim]:
    found = parse_script(path.read_text(encoding="utf-8"), path.name).statements
    return [s for s in found if isinstance(s, Claim)]


@pytest.mark.parametrize("name", sorted(path.stem for path in THEOREMS.glob("*.gca") if claims(path)))
def test_a_theorem(timed: Callable[..., Any], name: str) -> None:
    """All claims of a file, each by itself; a system that is stopped with one of them does not get the others."""
    path = THEOREMS / f"{name}.gca"
    ideals = [ideal for claim in claims(path) for ideal in ideals_of(claim)]
    ours = run([sys.executable, "-"], OURS.format(path=str(path)), 600)
    assert ours is not None
    assert ours.true
    others: dict[str, float | None] = {}
    megabytes = {"": ours.megabytes}
    for system in SYSTEMS:
        others[system.name] = None
        if not system.present:
            continue
        seconds = 0.0
        for ideal in ideals:
            answer = system.decide(ideal, LIMIT)
            if answer is None:
                seconds = Over(LIMIT)
                break
            assert answer.true, f"{system.name} finds a claim of {name} false"
            seconds += answer.seconds
            megabytes[system.name] = max(megabytes.get(system.name, 0), answer.megabytes)
        others[system.name] = seconds
    timed(ours.seconds, others, megabytes=megabytes)
