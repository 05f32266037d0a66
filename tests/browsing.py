"""Chromium driven by Playwright, for tests marked ``browser``."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from itertools import combinations, permutations
from typing import Any

from conftest import find_browser
from playwright.sync_api import Browser, sync_playwright

ARGS = (
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--no-first-run",
)
"""Nothing that calls home. Without a graphics card pages are drawn as Chromium chooses: only the 3D view by the card
that software imitates, which takes longer."""

SIDES = (("x", "width"), ("y", "height"))
"""Where a box begins, and how far it goes on from there."""


@contextmanager
def chromium() -> Iterator[Browser]:
    """The system's Chromium, headless."""
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_browser(), args=list(ARGS))
        yield browser
        browser.close()


def two_frames(page: Any) -> None:
    """Wait until the page has been drawn twice, no longer than the page's own timeout."""
    drawn = "requestAnimationFrame(() => requestAnimationFrame(() => { window.drawn = true; }))"
    page.evaluate(f"() => {{ window.drawn = false; {drawn}; }}")
    page.wait_for_function("() => window.drawn", polling=16)


def touching(boxes: list[dict[str, float]]) -> list[tuple[int, int]]:
    """The pairs of boxes that have more in common than their edges."""
    parted = [
        {(i, j) for (i, a), (j, b) in permutations(enumerate(boxes), 2) if a[at] + a[size] <= b[at] + 1}
        for at, size in SIDES
    ]
    apart = parted[0] | parted[1]
    return [(i, j) for i, j in combinations(range(len(boxes)), 2) if not {(i, j), (j, i)} & apart]
