"""A drawing becomes a platform file."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from gcrules.algebra.language.legs_text import Structure
from gcrules.apps.studio.protocol.answer_views import Composed
from gcrules.mechanisms.description.platform_file import parse_platform

__all__ = ["composed", "platform_text"]


def composed(drawing: Mapping[str, Any]) -> Composed:
    """The text of the file. Raises GcrulesError with the faults of a drawing that is no platform."""
    legs = [tuple(leg) for leg in drawing["legs"]]
    text = platform_text(drawing["title"], "drawn in the studio", "", legs, drawing["points"])
    given = parse_platform(text, "drawing")
    Structure(given.legs)
    return {"text": text}


def platform_text(title: str, note: str, unit: str, legs: Any, points: Mapping[str, Any], limits: str = "") -> str:
    """A platform file; points that no leg names are left out."""
    used = dict.fromkeys(n for leg in legs for n in leg)
    lines = [f"title: {_quoted(title)}"]
    lines += [f"note: {_quoted(note)}"] if note else []
    lines += [f"units: {unit}"] if unit else []
    lines += [f"limits: {_quoted(limits)}"] if limits else []
    written = {n: ", ".join(map(_number, points[n])) for n in used if n in points}
    lines += ["legs:" if legs else "legs: []", *(f"  - [{_quoted(a)}, {_quoted(b)}]" for a, b in legs)]
    lines += ["points:" if written else "points: {}", *(f"  {_quoted(n)}: [{c}]" for n, c in written.items())]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    """A text as YAML reads it back, whatever it holds."""
    return json.dumps(text, ensure_ascii=False)


def _number(c: Any) -> str:
    """A number as the file format reads it: decimals as they are, fractions as quotients."""
    if isinstance(c, float):
        return f"{c:.12g}" if 1e-4 <= abs(c) < 1e15 or not c else f"{c:.15f}".rstrip("0").rstrip(".")
    return str(c)
