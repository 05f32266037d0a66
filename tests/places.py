"""Where the files are that tests read."""

from __future__ import annotations

from pathlib import Path

__all__ = ["DATA", "EXAMPLES", "ROOT"]

ROOT = Path(__file__).resolve().parent.parent
"""The checkout."""
DATA = ROOT / "tests" / "data"
EXAMPLES = ROOT / "examples"
