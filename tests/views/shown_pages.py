"""Pages with the 3D viewer, shown by Chromium."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from console import is_fault

__all__ = ["Open", "Shown", "open_from_file"]


@dataclass
class Shown:
    """A page with a viewer; `requests` are those that it made after itself."""

    page: Any
    requests: list[str]
    faults: list[str]

    def run(self, script: str) -> Any:
        return self.page.evaluate(script)

    def place(self, name: str) -> tuple[float, float]:
        x, y = self.run(f"viewer.toScreen('{name}')")
        return x, y

    def settled(self) -> None:
        """Two frames later."""
        from browsing import two_frames

        two_frames(self.page)


Open = Callable[..., Shown]


def open_from_file(chromium: Any, path: Path, text: str, **options: Any) -> Shown:
    """The text of a page opened from a file, with reduced motion, so that nothing is under way."""
    page = chromium.new_context(viewport={"width": 900, "height": 640}, reduced_motion="reduce", **options).new_page()
    page.set_default_timeout(60_000)
    path.write_text(text, encoding="utf-8")
    shown = Shown(page, [], [])
    page.on("request", lambda request: shown.requests.append(request.url))
    page.on("pageerror", lambda fault: shown.faults.append(str(fault)))
    page.on("console", lambda said: shown.faults.append(said.text) if is_fault(said) else None)
    page.goto(path.as_uri())
    shown.requests.remove(path.as_uri())
    return shown
