"""A drawing becomes a platform file."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gcrules.algebra.language.legs_text import Structure
from gcrules.apps.studio.protocol.answer_views import Composed
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.mechanisms.editing.platform_text import platform_text

__all__ = ["composed"]


def composed(drawing: Mapping[str, Any]) -> Composed:
    """The text of the file. Raises GcrulesError with the faults of a drawing that is no platform."""
    legs = [tuple(leg) for leg in drawing["legs"]]
    text = platform_text(drawing["title"], "drawn in the studio", "", legs, drawing["points"])
    given = parse_platform(text, "drawing")
    Structure(given.legs)
    return {"text": text}
