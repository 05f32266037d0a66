"""Types of singularity in words: what each is, and the motion or the relation of rates that shows it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from gcrules.core.english import listed
from gcrules.mechanisms.lines.ranks import TYPES
from gcrules.poses.limbs.singularity_types import SingularityType

__all__ = ["in_words"]


def in_words(t: SingularityType) -> str:
    """The name of the type and what shows it."""
    name = TYPES[t.symbol]
    match t.symbol:
        case "RO":
            ways = "; or ".join(motion.text() for motion in t.motions)
            return f"{name}: with the actuators locked the platform can {ways}"
        case "II":
            return f"{name}: {_related('the rates of the actuators', t.relations)}"
        case "IO" if t.relations:
            return f"{name}: {_related('the rates of the platform', t.relations)}"
        case "IO":
            return f"{name}: the platform has fewer twists than elsewhere"
        case "RI":
            return f"{name}: {listed(t.names)} can move with the platform at rest"
        case "RPM":
            return f"{name}: passive joints of {listed(t.names)} can move with all else at rest"
    here, elsewhere = t.freedoms
    return f"{name}: all joints together have {here} freedoms to first order, and elsewhere {elsewhere}"


def _related(what: str, relations: Sequence[Mapping[str, float]]) -> str:
    """Relations of rates in words."""
    still = [next(iter(r)) for r in relations if len(r) == 1]
    sums = [" ".join(_terms(r)) + " = 0" for r in relations if len(r) > 1]
    parts = [f"{listed(still)} cannot move"] if still else []
    parts += [f"{what} have to satisfy {listed(sums)}"] if sums else []
    return "; ".join(parts)


def _terms(r: Mapping[str, float]) -> Iterator[str]:
    for place, (name, c) in enumerate(r.items()):
        size = "" if abs(abs(c) - 1) < 5e-5 else f"{abs(c):.4g} "
        sign = "-" if c < 0 else "+"
        yield f"{sign} {size}{name}" if place else f"{'-' if c < 0 else ''}{size}{name}"
