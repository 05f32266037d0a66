"""The stages of an analysis, those of a robot's limbs first, by the names that no wording changes."""

from __future__ import annotations

__all__ = ["STAGE_IDS"]

STAGE_IDS = (
    *("limbs", "equivalent"),
    *("structure", "superbracket", "shortest", "tetrahedra", "planes", "lines", "left-over"),
    *("condition", "statement", "check"),
)
