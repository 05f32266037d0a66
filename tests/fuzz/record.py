"""The record of what was tried: a table in RECORD.md, a row for each family and seed."""

from __future__ import annotations

import subprocess
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .campaign import Result

__all__ = ["RECORD", "commit_now", "recorded"]

RECORD = Path(__file__).parent / "RECORD.md"

_HEAD = """\
# What was tried

Each row is one campaign. At its commit (`-dirty`: something else was changed too) the same inputs run again with
`python -m tests.fuzz --family NAME --seed N --count INPUTS --record`, which writes the row, and with `--start K` where
it says `from K`; how many reach a limit of time (exit code 3) is up to the machine. What counts as wrong stands in
[judging.py](judging.py); what was found stands, made small, in [cases/](cases), and is tried by every run of the tests.

| family | seed | inputs | commit | date | exit codes | slowest | outcome |
|---|---|---|---|---|---|---|---|
"""


def recorded(result: Result, commit: str, start: int = 0) -> None:
    """Put a row for this result, of this commit, in place of the one for the same family, seed and first input."""
    head = f"| {result.family} | {result.seed}{f' from {start:,}' if start else ''} |"
    rows = [r for r in _rows() if not r.startswith(head)]
    codes = ", ".join(f"{c}: {n:,}" for c, n in sorted(result.codes.items(), key=lambda pair: str(pair[0])))
    outcome = "nothing wrong" if not result.found else "; ".join(f"{result.times[n]:,} × {n}" for n in result.found)
    cells = (
        f"{result.inputs:,}",
        commit,
        f"{datetime.now(UTC):%Y-%m-%d}",
        codes,
        f"{result.slowest[0]:.1f} s",
        outcome,
    )
    row = f"{head} {' | '.join(cells)} |"
    RECORD.write_text(_HEAD + "\n".join(sorted([*rows, row])) + "\n", encoding="utf-8")


def _rows() -> list[str]:
    if not RECORD.exists():
        return []
    lines = RECORD.read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line.startswith("| ") and not line.startswith("| family")]


def commit_now() -> str:
    """The commit that is checked out: ask before the inputs run, which take long."""

    def asked(*words: str) -> str:
        done = subprocess.run(["git", *words], capture_output=True, text=True, cwd=RECORD.parent)
        return done.stdout.strip()

    changed = asked("status", "--porcelain", "--untracked-files=no", "--", ":/", f":!{RECORD.name}")
    return (asked("describe", "--always") or "unknown") + ("-dirty" if changed else "")
