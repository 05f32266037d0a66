"""What Chromium's console says of a page."""

from __future__ import annotations

from typing import Any

HARMLESS = ("GPU stall due to ReadPixels", "GroupMarkerNotSet")
"""What it says of software rendering."""


def is_fault(said: Any) -> bool:
    """Whether a message of the console is a fault of the page."""
    return said.type in ("error", "warning") and not any(words in said.text for words in HARMLESS)
