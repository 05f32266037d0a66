"""Where the files are that tests read, and the modules of checkers/ and tools/."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path
from types import ModuleType

__all__ = ["DATA", "EXAMPLES", "ROOT", "checker", "tool"]

ROOT = Path(__file__).resolve().parent.parent
"""The checkout."""
DATA = ROOT / "tests" / "data"
EXAMPLES = ROOT / "examples"


def tool(name: str) -> ModuleType:
    """A module of tools/."""
    return _module(ROOT / "tools", name)


def checker(name: str) -> ModuleType:
    """A module of checkers/."""
    return _module(ROOT / "checkers", name)


def _module(folder: Path, name: str) -> ModuleType:
    sys.path.insert(0, str(folder))
    try:
        return importlib.import_module(name)
    finally:
        sys.path.remove(str(folder))
