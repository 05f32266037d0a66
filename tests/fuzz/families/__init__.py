"""All families of inputs."""

from __future__ import annotations

from .calls import CALLS
from .expressions import EXPRESSIONS
from .family import Family
from .files import CATALOGS, GEOMETRY, ROBOTS, TABLES, WORKSPACES
from .identities import IDENTITIES
from .interrupts import INTERRUPTS, KILLS
from .options import OPTIONS
from .scripts import MANUAL, PROMPT, RULES, SCRIPTS
from .structures import STRUCTURES
from .studio import STUDIO

__all__ = ["FAMILIES", "Family"]

_ALL = (
    EXPRESSIONS,
    IDENTITIES,
    STRUCTURES,
    SCRIPTS,
    RULES,
    PROMPT,
    MANUAL,
    GEOMETRY,
    ROBOTS,
    CATALOGS,
    TABLES,
    WORKSPACES,
    OPTIONS,
    CALLS,
    STUDIO,
    INTERRUPTS,
    KILLS,
)

FAMILIES = {family.name: family for family in _ALL}
