"""What is looked for, and how far unless the user says otherwise."""

from __future__ import annotations

__all__ = ["MAX_CANDIDATES", "RELATIONS", "SECONDS"]

RELATIONS = (
    *("collinear", "incident", "equal", "concurrent", "coplanar", "on_conic"),
    *("on_quadric", "touches", "polar", "conjugate"),  # of letters for conics and quadrics, as on_conic may be
)
"""In the order in which they are looked for: what comes later often follows from what comes before."""

MAX_CANDIDATES = 200_000
"""Sets of points and lines to look at."""

SECONDS = 10.0
"""How long positions are looked for at which what was found fails."""
