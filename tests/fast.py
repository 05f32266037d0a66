"""What `make test-fast` runs: of all tests those that find most in a second.

Left out are
* tests marked `browser` and `needs`,
* the tests of SLOW, whole files or single functions: on one idle core each takes more than half a second with the cases
  that are left, most because it starts processes, draws pages or goes through all robots, classes or documents,
* of a test with many cases all but the first, the middle and the last.

Properties try 10 examples where they don't say another number. `pytest --fast --durations=30` shows what to add.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable

import pytest

__all__ = ["SLOW", "chosen"]

SLOW: dict[str, tuple[str, ...]] = {
    "algebra/test_hostile.py": (),
    "apps/test_same_everywhere.py": (),
    "apps/test_shell.py": (),
    "apps/test_studio_command.py": (),
    "core/test_interrupts.py": (),
    "fuzz/test_cases.py": (),
    "mechanisms/test_hostile_files.py": (),
    "mechanisms/test_joint_screws.py": (),
    "poses/test_map_files.py": (),
    "project/test_documents.py": (),
    "project/test_site.py": (),
    "views/test_catalog_docs.py": (),
    "views/test_catalog_pages.py": (),
    "views/test_latex_documents.py": (),
    "views/test_robot_pages.py": (),
}
"""Files under tests/, each with its slow tests; () is the whole file."""


def chosen(items: Iterable[pytest.Item]) -> list[pytest.Item]:
    """The fast ones, in their order."""
    tests: defaultdict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        if not _left_out(item):
            tests[item.nodeid.partition("[")[0]].append(item)
    kept = {item for cases in tests.values() for item in (cases[0], cases[len(cases) // 2], cases[-1])}
    return [item for item in items if item in kept]


def _left_out(item: pytest.Item) -> bool:
    if item.get_closest_marker("browser") or item.get_closest_marker("needs"):
        return True
    file, _, name = item.nodeid.partition("[")[0].partition("::")
    slow = SLOW.get(file.removeprefix("tests/"))
    return slow is not None and (not slow or name in slow)
