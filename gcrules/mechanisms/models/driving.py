"""Which joints of a model are driven, and which follow others."""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.core.english import counted
from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.mechanisms.models.graph import Graph
from gcrules.mechanisms.models.merging import Ratios
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.motions import Motion

__all__ = ["check_driven", "driven_of", "ratios_of"]


def ratios_of(model: Model, names: frozenset[str]) -> Ratios:
    """Of the joints that follow others their leaders and ratios."""
    found = {}
    for c in model.couplings:
        if c.joint in names or c.leader in names:
            outside = next((n for n in (c.joint, c.leader) if n not in names), None)
            if outside and c.joint in names:
                raise InputError(
                    f"joint {c.joint} follows joint {outside}, which is in no limb of the platform",
                    hint="a robot file couples joints of one limb",
                )
            if not outside:
                found[c.joint] = (c.leader, c.ratio)
    return found


def driven_of(graph: Graph, names: frozenset[str], ratios: Ratios, asked: tuple[str, ...]) -> tuple[str, ...]:
    known = [j.name for j in graph.model.joints]
    for name in asked:
        if name not in known:
            raise InputError(f"there is no joint {name[:40]!r} to be driven", hint=near(name, known))
        if name not in names:
            raise InputError(f"joint {name} is in no limb of the platform, and cannot be an actuator of it")
    chosen = [n for n in asked or graph.model.actuated if n in names]
    return tuple(dict.fromkeys(ratios[n][0] if n in ratios else n for n in chosen))


def check_driven(
    platform: str, motions: Sequence[Motion], driven: Sequence[str], ratios: Ratios, mobility: int
) -> None:
    """Raises InputError where fewer joints are driven than the platform has freedoms, with joints that could be."""
    if len(driven) >= mobility:
        return
    said = f"{', '.join(driven)} only" if driven else "none"
    number = f"{counted(len(driven), 'joint')} {'is' if len(driven) == 1 else 'are'}"
    able = [m.joint for m in motions if m.kind in "RPHC" and m.joint not in ratios]
    raise InputError(
        f"the platform {platform} has mobility {mobility}, and {number} driven in the model ({said})",
        hint=f"name what is driven: --actuators {','.join(_guess(motions, mobility) or able[:mobility])}",
    )


def _guess(motions: Sequence[Motion], mobility: int) -> list[str]:
    """Joints that could be driven: the slides, or else the first turns from the base, if these are as many."""
    slides = [m.joint for m in motions if m.kind == "P"]
    base = motions[0].start
    turns = [m.joint for m in motions if m.kind == "R" and base in (m.start, m.end)]
    return next((own for own in (slides, turns) if len(own) == mobility), [])
