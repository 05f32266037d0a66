"""What counts as close to singular: the threshold that a page sends, and the margin below which it warns."""

from __future__ import annotations

from gcrules.screws.threshold import DEFAULT, Threshold, margin_of, parse_threshold

__all__ = ["close_margin", "threshold_of"]


def threshold_of(text: str | None, unit: str) -> Threshold:
    """What counts as close. Raises InputError."""
    return DEFAULT if text is None else parse_threshold(text, unit)


def close_margin(limit: Threshold) -> float | None:
    """The singularity margin below which a pose is close; None for a length, which no margin stands for."""
    return None if limit.angle is None else margin_of(limit.angle)
