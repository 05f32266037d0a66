"""An independent road for any robot: unknown are the twists of all its bodies and the rates of all its joints, and each
chain between two bodies says that their twists differ by the sum of its rates.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import gcrules as gc
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import Values
from gcrules.screws import Field, Limb

__all__ = ["chains", "equations"]


def chains(
    robot: gc.Robot, values: Values, field: Field, limbs: Sequence[LimbSpec] | None = None
) -> Iterator[tuple[str, str, Limb]]:
    """Each chain between two bodies, with their names; of all limbs, or of some."""
    for limb in robot.limbs if limbs is None else limbs:
        for (part, _), own in zip(limb.parts, limb.chains_at(values, field), strict=True):
            start, end = (_body(limb, n) for n in (part.start, part.end))
            yield start, end, own


def _body(limb: LimbSpec, name: str) -> str:
    return name if name in ("base", "platform") else f"{limb.name}, {name}"


def equations(robot: gc.Robot, values: Values, field: Field) -> tuple[list[list[Any]], list[int], list[int]]:
    """Six rows for each chain; the columns are six for each body, those of the platform first, then one for each
    freedom. Also the columns of the freedoms with an actuator, and of the others.
    """
    every = list(chains(robot, values, field))
    places = {"platform": 0}
    for start, end, _ in every:
        for name in (start, end):
            if name != "base":
                places.setdefault(name, 6 * len(places))
    size = 6 * len(places) + sum(chain.freedoms for *_, chain in every)
    rows: list[list[Any]] = []
    driven: list[int] = []
    passive: list[int] = []
    first = 6 * len(places)
    for start, end, chain in every:
        twists = chain.twists(field)
        for c in range(6):
            row: list[Any] = [0] * size
            for name, sign in ((start, -1), (end, 1)):
                if name != "base":
                    row[places[name] + c] = sign
            row[first : first + len(twists)] = [-t[c] for t in twists]
            rows.append(row)
        driven += [first + k for k in chain.actuated]
        passive += [first + k for k in chain.passive]
        first += len(twists)
    return rows, driven, passive
