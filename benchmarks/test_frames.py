"""Theorems in coordinates with respect to their own points, beside brackets and beside Singular."""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from time import process_time
from typing import Any

import pytest
from ideals import Emitted

from gcrules.algebra.assumptions.assumed import kinds
from gcrules.algebra.assumptions.frame import Frame, frame_of
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.statements import Claim, parse_script
from gcrules.algebra.prove import difference_of

THEOREMS = Path(__file__).resolve().parent.parent / "examples" / "theorems"
TICKS = 1_000  # of Singular's clock, each second; it moves a hundred times a second
TIMES = 20  # as often is a theorem computed there


def by_singular(frame: Frame) -> float | None:
    """The seconds of processor time in which Singular computes the same; None where it is not installed."""
    if shutil.which("Singular") is None:
        return None
    lines: list[str] = []
    entries: list[Any] = [1] * frame.numbers
    for place, i in enumerate(frame.variables):
        entries[i] = Emitted(f"x({place})", lines, "poly ")
    found = [c for c in frame.value(entries) if isinstance(c, Emitted)]
    ring = f"ring r=0,(x(0..{max(0, len(frame.variables) - 1)})),dp;"
    zero = " and ".join(f"{c.text}==0" for c in found) or "1"
    text = [ring, f'system("--ticks-per-sec",{TICKS});', "proc once() {", *lines, f"return({zero});", "}"]
    text += ["int i; int zero=1; int began=timer;", f"for(i=1;i<={TIMES};i++) {{ zero=zero and once(); }}"]
    text += ["print(timer-began);", "print(zero);", "quit;"]
    done = subprocess.run(
        ["Singular", "-q", "--no-rc"], input="\n".join(text), capture_output=True, text=True, check=True, timeout=120
    )
    ticks, zero = done.stdout.split()[-2:]
    assert zero == "1", done.stdout[-500:]
    return max(int(ticks), 1) / TICKS / TIMES


@pytest.mark.parametrize(
    ("name", "number"),
    [("double-six", 3), ("miquel", 2), ("five-lines", 0), ("gallucci", 0), ("radical-axes", 0), ("simson", 0)],
)
def test_a_theorem(timed: Callable[..., Any], name: str, number: int) -> None:
    """The expansion alone: the construction is the same for all."""
    script = parse_script((THEOREMS / f"{name}.gca").read_text(encoding="utf-8"), name)
    claim = [s for s in script.statements if isinstance(s, Claim)][number]
    ((left, right),) = claim.claimed.equations
    difference = difference_of(left, right, claim.context.rank)
    (kind,) = kinds(claim.context, points_of(difference), (difference,))
    frame = frame_of(kind.construction, difference)
    assert frame is not None
    ours = []
    for _ in range(3):
        began = process_time()
        assert frame.is_zero()
        ours.append(process_time() - began)
    began = process_time()
    assert kind.construction.is_zero(difference)
    brackets = process_time() - began
    timed(min(ours), {"brackets": brackets, "Singular": by_singular(frame)}, within=1)
