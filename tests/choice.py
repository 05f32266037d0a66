"""Which tests are chosen: `--spread` for `make test`, `--fast` for `make test-fast`. Without either all of them run.

`data/costs.txt` holds the processor time of one case, of each test with cases of more than 0.3 s, of more than 1 s
together, or with more than 20 of them; `make costs` measures it again.

`--spread` tries of a test as many cases as take 1 s, at least two, evenly from the first to the last. What it leaves
out are more robots, classes, documents or numbers for a claim that is tried with others of them; `make test-all`, to be
run before a release and after a change of what all of them go through, tries them all.

`--fast` is what finds most in a second. Left out are
* tests marked `browser` and `needs`,
* the tests of the table whose cases take more than 0.3 s: most start processes, draw pages or go through many robots,
* of a test with many cases all but the first, the middle and the last.
Properties try 10 examples where they don't say another number.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from statistics import median

import pytest
from places import DATA

__all__ = ["COSTS", "chosen", "fast", "processor_seconds", "spread", "table"]

_CASE, _TEST, _CASES = 0.3, 1.0, 20
"""Processor seconds of a slow case and of all cases of a test that are tried; as many cases where none are known."""

_TABLE = (DATA / "costs.txt").read_text(encoding="utf-8").splitlines()
COSTS = {name: float(seconds) for line in _TABLE if line[:1] != "#" for seconds, name in [line.split(maxsplit=1)]}
"""Of `room/file.py::test`, the processor seconds of one case."""


_Choice = Callable[[str, list[pytest.Item]], list[pytest.Item]]


def chosen(items: Sequence[pytest.Item], choose: _Choice) -> list[pytest.Item]:
    """The cases that `choose` keeps of each test, given its name and all of them, in their order."""
    tests: defaultdict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        tests[name_of(item.nodeid)].append(item)
    kept = {item for name, cases in tests.items() for item in choose(name, cases)}
    return [item for item in items if item in kept]


def name_of(nodeid: str) -> str:
    """`room/file.py::test` of any of its cases."""
    return nodeid.partition("[")[0].removeprefix("tests/")


def spread(name: str, cases: list[pytest.Item]) -> list[pytest.Item]:
    """As many as take the time that a test has."""
    return _evenly(cases, max(int(_TEST / COSTS[name]), 2) if name in COSTS else _CASES)


def fast(name: str, cases: list[pytest.Item]) -> list[pytest.Item]:
    """Three cases, unless they are slow or need other programs."""
    other = cases[0].get_closest_marker("browser") or cases[0].get_closest_marker("needs")
    return [] if other or COSTS.get(name, 0) > _CASE else _evenly(cases, 3)


def _evenly(cases: list[pytest.Item], number: int) -> list[pytest.Item]:
    if len(cases) <= number:
        return cases
    return [cases[round(k * (len(cases) - 1) / (number - 1))] for k in range(number)]


# --- the table -----------------------------------------------------------------------------------------------------


def processor_seconds() -> float:
    """What this process and those that it waited for have used."""
    import resource  # which not all systems have

    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in used)


def table(measured: Iterable[tuple[str, float]]) -> str:
    """The table for what cases of tests took, each with its name in pytest. Doctests have no cases.

    What one case makes that others of its file use as well, as fixtures do, is not part of the median.
    """
    tests: defaultdict[str, list[float]] = defaultdict(list)
    for nodeid, seconds in measured:
        if nodeid.startswith("tests/"):
            tests[name_of(nodeid)].append(seconds)
    rows = [
        f"{max(median(cases), 0.001):7.3f} {name}"
        for name, cases in sorted(tests.items())
        if median(cases) > _CASE or median(cases) * len(cases) > _TEST or len(cases) > _CASES
    ]
    head = (
        "# Processor seconds of one case, of tests that cost much (tests/choice.py); `make costs` measures them again."
    )
    return "\n".join([head, *rows, ""])
