r"""The parts of a scene that come from the condition: entities, and what is constructed from the joints."""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.algebra.expr import Expr, Join, Meet, Point
from gcrules.algebra.language.notation import Row
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import factors
from gcrules.core.dataclass import dataclass
from gcrules.rules.condition import Entity
from gcrules.views.drawing.figures import free_name, named_lines
from gcrules.views.scene_data import Construction, EntityView

__all__ = ["DrawnIncidence", "entity_data", "entity_label", "incidences", "nested"]


@dataclass(frozen=True)
class DrawnIncidence:
    """Planes, lines and points that a factor of the condition meets, with the name of what they have in common."""

    name: str
    parts: tuple[Expr, ...]
    entities: tuple[str, ...]


def entity_label(names: Sequence[str]) -> str:
    """The points of an entity side by side, words set apart, as in sentences."""
    return (" " if Row(tuple(n.rstrip("*") for n in names)).words else "").join(names)


def entity_data(e: Entity, colour: int) -> EntityView:
    """An entity for the viewer: its number is that of its colour."""
    return {
        "id": f"e{colour}",
        "kind": e.kind,
        "points": list(e.points),
        "label": entity_label(e.points),
        "starred": entity_label(e.starred),
        "colour": colour,
    }


def incidences(a: Analysis, shown: Sequence[Entity]) -> list[DrawnIncidence]:
    """What the factors of the condition meet; `shown` are the entities in the sequence of their numbers."""
    ids = {(e.kind == "tetrahedron", frozenset(e.points)): f"e{i}" for i, e in enumerate(shown)}
    taken = [*a.structure.names, *(name for name, _ in named_lines(a))]
    found = []
    for factor in factors(a.condition.expression):
        if isinstance(factor, Meet) and factor.step == 0:
            parts = tuple(factor.children)
            own = (ids.get((False, frozenset(map(str, p.children)))) for p in parts if isinstance(p, Join))
            found.append(DrawnIncidence(free_name("MNOXYZ", taken), parts, tuple(i for i in own if i)))
            taken.append(found[-1].name)
    return found


def nested(e: Expr) -> Construction | None:
    """An expression of joins and meets as nested lists; None for one that holds anything else (a sum)."""
    if isinstance(e, Point):
        return str(e)
    if not isinstance(e, (Join, Meet)):
        return None
    parts = [part for c in e.children if (part := nested(c)) is not None]
    return ["join" if isinstance(e, Join) else "meet", *parts] if len(parts) == len(e.children) else None
