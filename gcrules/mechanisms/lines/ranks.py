r"""Ranks of a robot's wrenches and twists at a member of its family, and the types of singularity that they tell.

All rates of the joints with which the loops stay closed form a space. Where U_i are the twists of limb i with all its
joints, P_i those of its passive joints, f_i and p_i how many joints (freedoms) these are,

    t = dim ⋂ U_i = 6 − rank of all constraints      twists of the platform
    g = dim ⋂ P_i = 6 − rank of all wrenches         of these, those with the actuators locked
    s = Σ (f_i − dim U_i)                            rates with the platform at rest
    r = Σ (p_i − dim P_i)                            of these, those of passive joints alone

so the whole space has dimension t + s, and the rates of the actuators in it t + s − g − r. In a limb with loops of its
own f_i − dim U_i counts the rates with which its loops stay closed too: dim U_i is then the rank of its twists as the
platform and its loops together have them (`Limb.rank`), and likewise dim P_i. Compared with the same
numbers elsewhere in the family they are the six types of Zlatanov, Fenton and Benhabib. The formulas are derived here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import Values
from gcrules.mechanisms.lines.wrenches import PLANAR
from gcrules.screws import RESIDUES, Field

__all__ = ["TYPES", "Ranks", "ranks", "types_of"]

TYPES: Mapping[str, str] = FrozenMap(
    {
        "RO": "redundant output",
        "II": "impossible input",
        "RI": "redundant input",
        "IO": "impossible output",
        "RPM": "redundant passive motion",
        "IIM": "increased instantaneous mobility",
    }
)
"""The six types: with the actuators locked the platform moves (RO), the actuators cannot take all rates (II), an
actuator moves with the platform at rest (RI), the platform has fewer twists than elsewhere (IO), passive joints move
with all else at rest (RPM), all joints together have more freedoms than elsewhere (IIM). Idle freedoms, which are there
everywhere, do not count. The names are those of Zlatanov, Fenton and Benhabib.
"""


@dataclass(frozen=True)
class Ranks:
    """At one member: rank of the constraints, of all wrenches, and of each limb's twists, passive ones apart; `applied`
    are the dimensions of each limb's constraints and of its wrenches.
    """

    constraints: int
    wrenches: int
    limbs: tuple[tuple[int, int], ...]
    applied: tuple[tuple[int, int], ...] = ()


def ranks(family: Family, limbs: Sequence[LimbSpec], values: Values, field: Field = RESIDUES) -> Ranks:
    """The ranks at a member in this field, from the joint screws alone. Raises InputError where a joint is none."""
    trivial = [field.read(PLANAR)] if family.plane else []
    held, locked = list(trivial), list(trivial)
    dimensions, applied = [], []
    for text in limbs:
        limb = text.at(values, field)
        own, rank = limb.applied(field, locked=False)
        every, passive = limb.applied(field, locked=True) if limb.actuated else (own, rank)
        held.append(own)
        locked.append(every)
        applied.append((field.height(own), field.height(every)))
        dimensions.append((rank, passive))
    constraints, wrenches = (field.rank(field.comparable(field.joined(parts))) for parts in (held, locked))
    known = len(PLANAR) if family.plane else 0
    return Ranks(constraints - known, wrenches - known, tuple(dimensions), tuple(applied))


def types_of(here: Ranks, elsewhere: Ranks) -> tuple[str, ...]:
    """The types of singularity at a member, in the order of `TYPES`, by its ranks and those elsewhere in the family."""
    outputs = (
        elsewhere.constraints - here.constraints
    )  # more twists of the platform than elsewhere, likewise the others
    gained = elsewhere.wrenches - here.wrenches
    at_rest, passive = (sum(b[k] - a[k] for a, b in zip(here.limbs, elsewhere.limbs, strict=True)) for k in (0, 1))
    inputs = outputs + at_rest - gained - passive
    seen = {
        "RO": gained > 0,
        "II": inputs < 0,
        "RI": at_rest > passive,
        "IO": outputs < 0,
        "RPM": passive > 0,
        "IIM": outputs + at_rest > 0,
    }
    return tuple(name for name in TYPES if seen[name])
