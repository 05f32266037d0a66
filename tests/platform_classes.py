"""The 39 classes of platforms as they were given: legs, superbracket, counts of terms, group of entities."""

from __future__ import annotations

from typing import Any

import yaml
from places import DATA

__all__ = ["CLASSES", "REGULAR"]

CLASSES: list[dict[str, Any]] = yaml.safe_load((DATA / "gsp_classes.yaml").read_text(encoding="utf-8"))["classes"]
REGULAR = [c for c in CLASSES if c["regular"]]
"""Those that are not singular in every pose."""
