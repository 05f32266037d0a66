r"""Numbers that change continuously with the pose and are 0 in singular poses only.

Between two poses in which such a number has opposite signs every way is singular somewhere.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isfinite
from typing import Any

from gcrules.core.dataclass import dataclass

__all__ = ["SEEN", "ConditionSign", "FactorSign", "opposite", "signs_of"]


@dataclass(frozen=True)
class FactorSign:
    """A factor of the condition in a pose."""

    expression: str
    value: float
    sign: int

    def to_json(self) -> dict[str, Any]:
        return {
            "expression": self.expression,
            "value": self.value if isfinite(self.value) else None,
            "sign": self.sign,
        }


@dataclass(frozen=True)
class ConditionSign(FactorSign):
    """One that is 0 in singular poses only; `statement` says in words what is singular where it is 0. That it is 0 only
    there is `proved`, or seen at exact random members of a robot's family.
    """

    statement: str
    proved: bool = True


SEEN = (
    "that these factors are 0 in singular configurations only is seen at exact random members of the family, as for the"
    " robot's condition"
)
"""How sure it is what signs tell that are not proved."""


def signs_of(numbers: Iterable[FactorSign]) -> str:
    """Their signs, such as "+-+"; 0 where one vanishes."""
    return "".join("-0+"[n.sign + 1] for n in numbers)


def opposite(
    one: Sequence[ConditionSign], other: Sequence[ConditionSign]
) -> tuple[tuple[ConditionSign, ConditionSign], ...]:
    """The numbers, those of two poses of one mechanism, that have opposite signs in these."""
    return tuple((a, b) for a, b in zip(one, other, strict=True) if a.sign * b.sign < 0)
