"""Every theorem of examples/theorems with its assumptions, beside Gröbner bases of Singular and Macaulay2."""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from time import perf_counter
from typing import Any

import pytest
from ideals import SYSTEMS, ideals_of, run
from measurement import Over

from gcrules.algebra.language.statements import Claim, parse_script

THEOREMS = Path(__file__).resolve().parent.parent / "examples" / "theorems"
FIRST = THEOREMS / "quadrangle.gca"
LIMIT = 20  # seconds for one claim, with the start
OURS_AT_MOST = 600

OURS = """\
import os
from pathlib import Path
from time import perf_counter
from gcrules.algebra.language.statements import Claim, parse_script
from gcrules.algebra.decide import decide

def claims(path):
    return [s for s in parse_script(Path(path).read_text(encoding="utf-8")).statements if isinstance(s, Claim)]

def decided(some):
    return all([decide(c.claimed, c.context).proved for c in some])

decided(claims({first!r}))  # now all is loaded
some = claims({path!r})
spent, times, true = 0.0, 0, True
while spent < 0.2:
    read, write = os.pipe()
    if not os.fork():  # a process that remembers nothing of this theorem
        began = perf_counter()
        found = decided(some)
        os.write(write, f"{{int(found)}} {{perf_counter() - began}}".encode())
        os._exit(0)
    os.wait()
    found, seconds = os.read(read, 100).split()
    os.close(read), os.close(write)
    spent, times, true = spent + float(seconds), times + 1, true and found == b"1"
print("answer", int(true), spent / times)
"""
STARTED = "import gcrules.algebra.decide; print('answer 1 0')"
STARTS = {"Singular": 'print("answer 1 0"); quit;', "Macaulay2": 'print "answer 1 0"; exit 0'}


def claims(path: Path) -> list[Claim]:
    found = parse_script(path.read_text(encoding="utf-8"), path.name).statements
    return [s for s in found if isinstance(s, Claim)]


@pytest.mark.parametrize("name", sorted(path.stem for path in THEOREMS.glob("*.gca") if claims(path)))
def test_a_theorem(timed: Callable[..., Any], name: str) -> None:
    """All claims of a file, each by itself; a system that is stopped with one of them does not get the others.

    Each form is a process that runs already, and decides the claims again and again, each time as if for the first
    time. What does not vanish is told to the systems, and found by gcrules.
    """
    path = THEOREMS / f"{name}.gca"
    ideals = [ideal for claim in claims(path) for ideal in ideals_of(claim)]
    ours = run([sys.executable, "-"], OURS.format(path=str(path), first=str(FIRST)), OURS_AT_MOST)
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


def test_the_start(timed: Callable[..., Any]) -> None:
    """Of a process that decides nothing: what comes on top of each time of a theorem where no process runs yet."""

    def started(command: Sequence[str], program: str) -> tuple[float, float]:
        found = []
        for _ in range(3):
            began = perf_counter()
            answer = run(command, program, LIMIT)
            assert answer is not None
            found.append((perf_counter() - began, answer.megabytes))
        return min(found)

    seconds, megabytes = started([sys.executable, "-"], STARTED)
    others = {s.name: started(s.command, STARTS[s.name]) for s in SYSTEMS if s.present}
    timed(
        seconds,
        {s.name: others[s.name][0] if s.present else None for s in SYSTEMS},
        megabytes={"": megabytes} | {name: most for name, (_, most) in others.items()},
    )
