"""Colours by role. The first entities take colours of Okabe and Ito, which colour-blind readers can tell apart;
the later ones, mostly those of thin lines, are stronger.

Each role has a value for light and for dark surroundings; an SVG switches between them by itself, and a page that holds
it may set `--gc-ink`, `--gc-paper`, … to values of its own.
"""

from __future__ import annotations

__all__ = ["ENTITY_ROLES", "LIGHT", "ROLES", "entity_role"]

ROLES: dict[str, tuple[str, str]] = {
    "paper": ("#FFFFFF", "#15181C"),
    "ink": ("#1A1D21", "#ECEEF0"),
    "leg": ("#3A4048", "#C3CAD2"),
    "muted": ("#6A727C", "#98A1AC"),
    "base": ("#8B94A0", "#7C8793"),
    "platform": ("#8B94A0", "#A7B1BD"),
    "mark": ("#B00020", "#FF6B7A"),
    "drive": ("#F5B400", "#FFC93C"),
    "entity1": ("#0072B2", "#56B4E9"),
    "entity2": ("#D55E00", "#F0803C"),
    "entity3": ("#009E73", "#2FC49B"),
    "entity4": ("#A3327E", "#D65DB1"),
    "entity5": ("#8F5B00", "#F0E442"),
    "entity6": ("#6A3FB5", "#B79CF2"),
}
"""Role: (light, dark)."""

LIGHT: dict[str, str] = {role: light for role, (light, _) in ROLES.items()}
"""The colours on paper, used for PDF."""

ENTITY_ROLES = tuple(role for role in ROLES if role.startswith("entity"))


def entity_role(index: int) -> str:
    """The role of the entity with this index, counted from 0; after six they repeat."""
    return ENTITY_ROLES[index % len(ENTITY_ROLES)]
