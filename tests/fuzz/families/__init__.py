"""All families of inputs."""

from __future__ import annotations

from .expressions import EXPRESSIONS
from .family import Family
from .files import CATALOGS, GEOMETRY, ROBOTS, TABLES
from .options import OPTIONS
from .scripts import MANUAL, PROMPT, RULES, SCRIPTS

__all__ = ["FAMILIES", "Family"]

_ALL = (EXPRESSIONS, SCRIPTS, RULES, PROMPT, MANUAL, GEOMETRY, ROBOTS, CATALOGS, TABLES, OPTIONS)

FAMILIES = {family.name: family for family in _ALL}
