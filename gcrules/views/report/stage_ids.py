"""The stages of an analysis: ids that no wording changes, and the headings that they have everywhere."""

from __future__ import annotations

from collections.abc import Mapping

__all__ = ["STAGE_IDS", "TITLES"]

STAGE_IDS = (
    *("limbs", "equivalent"),
    *("structure", "superbracket", "shortest", "tetrahedra", "planes", "lines", "left-over"),
    *("condition", "statement", "check"),
)
"""Those that the studio leads through, in sequence; a robot of joints begins with the first two."""

TITLES: Mapping[str, str] = {
    "limbs": "Limbs",
    "equivalent": "Equivalent structure",
    "structure": "Structure",
    "superbracket": "Superbracket",
    "shortest": "Shortest form",
    "entities": "Entities",
    "tetrahedra": "Tetrahedra",
    "planes": "Planes",
    "lines": "Lines",
    "left-over": "Left-over points",
    "condition": "Condition",
    "statement": "Statement",
    "check": "Check",
    "certificate": "Certificate",
    "dimensions": "Dimensions",
    "pose": "In this pose",
    "readings": "Other readings",
}
