"""Of what proof files are made that say something false."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from places import ROOT

CHECKER = ROOT / "checkers" / "check_proof.py"

Changes = dict[str, Any]


def points(text: str) -> list[str]:
    return text.split()


def join(*parts: Any) -> list[Any]:
    return ["join", *parts]


def meet(*parts: Any) -> list[Any]:
    return ["meet", *parts]


def bracket(*parts: Any) -> list[Any]:
    return ["bracket", *parts]


def number(value: Any) -> list[Any]:
    return ["number", value]


def twice_c(first: str, second: str) -> list[Any]:
    return ["sum", ["product", bracket(*first), "c"], ["product", bracket(*second), "c"]]


def flat(extensor: Any, *because: list[Any], room: Any = None) -> Changes:
    return {"flat": extensor, "room": room, "because": list(because)}


def placed(name: str, on: Any, *flats: Changes, fresh: str = "") -> Changes:
    return {"name": name, "on": on, "fresh": [*fresh], "flats": list(flats)}


def on_line(name: str, index: int = 0, on: Any = ("join", "a", "b"), **more: Any) -> Changes:
    """A point on a line, of which the assumption with this index speaks."""
    return placed(name, list(on), flat(list(on), [index, 1]), **more)


def theorem(names: str, *claim: Any, rank: int = 3, **more: Any) -> Changes:
    two = claim if len(claim) == 2 else (*claim, number(0))
    plain = {"name": "attack", "rank": rank, "points": points(names), "ideal": 0, "definitions": [], "relations": []}
    return {**plain, "claim": list(two), **more}


def assumed(names: str, *claim: Any, given: list[Any], placed: list[Changes], **more: Any) -> Changes:
    return theorem(names, *claim, **{"any": [], "given": given, "nonzero": [], "placed": placed, **more})


def run(tmp_path: Path, *theorems: Any, **head: Any) -> subprocess.CompletedProcess[str]:
    file = tmp_path / "proofs.json"
    data = {"format": "gcrules proof", "version": 1, "theorems": list(theorems), **head}
    file.write_text(json.dumps(data), encoding="utf-8")
    return subprocess.run([sys.executable, str(CHECKER), str(file)], capture_output=True, text=True, check=False)


def refused(tmp_path: Path, attack: Changes, reason: str, **head: Any) -> None:
    """Sees that the checker proves nothing of a file, for this reason."""
    done = run(tmp_path, attack, **head)
    assert done.returncode in (1, 2), done.stdout
    assert "proved, called" not in done.stdout.replace("NOT PROVED, called", "")
    assert reason in done.stdout + done.stderr


def proved(tmp_path: Path, true: Changes, printed: str) -> None:
    """Sees that the checker proves a theorem, and that it prints the whole of it."""
    claim, end = run(tmp_path, true).stdout.replace(":\n  ", ": ").splitlines()
    assert claim == f"proved, called {printed}"
    assert end.startswith("theorems proved: 1, digest ")


ABX, ABY, ADX, ADY = (bracket(*names) for names in ("abx", "aby", "adx", "ady"))
X_ON_AB = on_line("x")
Y_ON_AB = on_line("y", 1)
TWO_ON_AB: Changes = {"given": [ABX, ABY], "placed": [X_ON_AB, Y_ON_AB]}
BC, PLANES = join("b", "c"), meet(join("a", "b", "c"), join("a", "d", "e"))
PLANE = meet(join("a", "b", "c"))
ON_BOTH = [flat(join("a", "b", "c"), [0, 1]), flat(join("a", "d", "e"), [1, 1])]
CROSSED = meet(join("b", "c"), join("d", "e"))
ALMOST = [
    "sum",
    ["product", bracket("b", "d", "e"), bracket("a", "c", "x")],
    ["product", number(f"-{2**60 + 1}/{2**60}"), bracket("c", "d", "e"), bracket("a", "b", "x")],
]
NAN = float("nan")
AB = join("a", "b")
M_ON_AB = placed("m", AB, flat(AB, []))
M_AND_X = placed("x", join("m", "c"), flat(join("m", "c"), []))

FACTORS = ["product", ABX, ABY]  # that ABX vanishes does not follow


def in_cases(*cases: Changes, claim: Any = ABX, given: Any = FACTORS, **more: Any) -> Changes:
    return assumed("a b x y", claim, given=[given], placed=[], cases=list(cases), **more)


def case(claim: Any = ABX, *given: Any, names: str = "a b y", place: Any = X_ON_AB, **more: Any) -> Changes:
    """That something vanishes by the first of what is given, since one point is placed by it."""
    return assumed(names, claim, given=[*given], placed=[place], **more)


def lemma(left: Any, right: Any, given: Any = (), placed: Any = (), names: str = "a b x y", **more: Any) -> Changes:
    return assumed(names, left, right, given=[*given], placed=[*placed], **more)


OF_FACTORS = lemma(FACTORS, FACTORS)
WHERE_X = case(ABX, ABX, FACTORS)
WHERE_Y = case(ABX, ABX, ABY, FACTORS)
ZERO_TIMES = ["product", number(0), ABX]
SQUARE = ["product", ABX, *FACTORS[1:]]
