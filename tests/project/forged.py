"""Proof files that are written by hand, for the checker that should refuse them, and theorems that they are made of."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

from places import ROOT

__all__ = [
    "Changes",
    "assumed",
    "bracket",
    "flat",
    "join",
    "meet",
    "number",
    "on_line",
    "placed",
    "points",
    "refused",
    "run",
    "theorem",
    "twice_c",
]

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
