"""What `make test-fast` runs: of all tests those that find most in a second.

Left out are
* tests marked `browser` and `needs`,
* the files and functions of `data/slow.txt`: each has a case of more than 0.3 s of processor time, most of them because
  they start processes, draw pages or go through all robots, classes or documents,
* of a test with many cases all but the first, the middle and the last.

Properties try 10 examples where they don't say another number. `pytest --fast --durations=30` shows what to add.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence

import pytest
from places import DATA

__all__ = ["SLOW", "chosen"]

SLOW = tuple(line for line in (DATA / "slow.txt").read_text(encoding="utf-8").splitlines() if line[:1] != "#")
"""`room/file.py` for all of its tests, else `room/file.py::function`."""


def chosen(items: Sequence[pytest.Item]) -> list[pytest.Item]:
    """The fast ones, in their order."""
    slow = set(SLOW)
    tests: defaultdict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        test = item.nodeid.partition("[")[0].removeprefix("tests/")
        other = item.get_closest_marker("browser") or item.get_closest_marker("needs")
        if not other and slow.isdisjoint((test, test.partition("::")[0])):
            tests[test].append(item)
    kept = {item for cases in tests.values() for item in (cases[0], cases[len(cases) // 2], cases[-1])}
    return [item for item in items if item in kept]
