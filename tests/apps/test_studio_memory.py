"""What the page holds in memory does not grow with use."""

from __future__ import annotations

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs Playwright")

from studio_page import Desk
from studio_use import SOURCES, Held, held, use

pytestmark = pytest.mark.browser


def test_equal_rounds_of_use_hold_the_same(desk: Desk) -> None:
    """The first round loads what is used; nothing that a later one opens, moves or undoes stays behind: no nodes that
    are detached, no listeners, no values of structures that are closed.
    """

    def held_after_a_round() -> Held:
        assert use(desk.page, 12, SOURCES[:2]) > 50
        return held(desk.page)

    held_after_a_round()
    first, second, third, last = (held_after_a_round() for _ in range(4))
    # when exactly the page is looked at differs
    for what, more in {"nodes": 1.1, "listeners": 1.1, "heap": 1.25}.items():
        before = max(getattr(first, what), getattr(second, what))
        assert min(getattr(third, what), getattr(last, what)) <= more * before, what
