"""How many places of a path numbers are given at."""

from __future__ import annotations

from typing import Any

from gcrules.core.errors import InputError, LimitReached

__all__ = ["SAMPLES", "per_segment"]

SAMPLES = 200


def per_segment(samples: Any, segments: int, most: int) -> int:
    """So many in each segment that they are `samples` together, or some more. Raises InputError for what is no number
    of samples, LimitReached for more than `most`.
    """
    if isinstance(samples, bool) or not isinstance(samples, int) or samples < 1:
        raise InputError(f"the number of samples is {samples!r}, expected a whole number, 1 or more")
    found = -(-samples // segments)
    if found * segments > most:
        raise LimitReached(
            f"{found * segments:,} samples are more than {most:,}",
            hint="singular places are found between samples, too",
        )
    return found
