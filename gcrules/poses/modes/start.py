"""Six generic linear conditions on motions, which are solved: where all paths begin. Made by `tools/modes_start.py`."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np

from gcrules.poses.modes.conditions import Complexes

__all__ = ["PATHS", "START", "start"]

PATHS = 40
"""How many common zeros six generic linear conditions on motions have."""

START = Path(__file__).with_name("start.json")


@cache
def start() -> tuple[Complexes, Complexes]:
    """The forms (6, 17), orthogonal and of length 1, and the Study parameters (40, 8) of their zeros."""
    stored = json.loads(START.read_text(encoding="utf-8"))
    forms, zeros = (np.array(stored[name]) for name in ("forms", "zeros"))
    return forms[..., 0] + 1j * forms[..., 1], zeros[..., 0] + 1j * zeros[..., 1]
