r"""Limbs: joints from the base to the platform, their twists, and the wrenches that they apply to the platform.

>>> from gcrules.screws.joints import joint
>>> A, B = (0, 0, 0), (1, 2, 3)
>>> x, y = (1, 0, 0), (0, 1, 0)
>>> leg = limb(
...     joint("U", point=A, first=x, second=y),
...     joint("P", direction=B, actuated=True),
...     joint("S", point=B),
... )
>>> print(leg, leg.freedoms, len(leg.constraints()), [list(map(str, force)) for force in leg.actuations()])
UP̲S 6 0 [['1/14', '1/7', '3/14', '0', '0', '0']]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.screws.fields import Field, Matrix, field_of
from gcrules.screws.joints import Joint
from gcrules.screws.systems import ScrewSystem, Shares, actuation, reciprocal, reciprocal_and_rank

__all__ = ["Limb", "limb"]


@dataclass(frozen=True)
class Limb:
    """Joints from the base to the platform: a chain, or with `shares` a limb that has bodies and loops of its own. With
    floats everything works for many configurations at once.

    `shares` tells of each joint with which sign it counts in the platform's twist, and then in each of the loops.
    `couplings` are joints that another one takes along, as by gears or a belt, as (joint, leader, ratio): places of
    joints with one freedom each, and how much the joint moves for each unit of its leader, which follows none itself.
    Both make one freedom, at the leader's place. Each method takes the field to compute in; that of the joints' own
    numbers if there is none.
    """

    joints: tuple[Joint, ...]
    name: str = ""
    shares: tuple[tuple[int, ...], ...] = ()
    couplings: tuple[tuple[int, int, Any], ...] = ()

    @cached_property
    def field(self) -> Field:
        """Floats if any number of the joints is a float, else fractions."""
        ratios = (ratio for _, _, ratio in self.couplings)
        return field_of(*(value for j in self.joints for value in j.geometry.values()), *ratios)

    @cached_property
    def leading(self) -> tuple[int, ...]:
        """The places of the joints that follow no other."""
        led = {joint for joint, _, _ in self.couplings}
        return tuple(k for k in range(len(self.joints)) if k not in led)

    @property
    def freedoms(self) -> int:
        """The number of twists, actuated or not."""
        return sum(self.joints[k].freedoms for k in self.leading)

    @cached_property
    def actuated(self) -> tuple[int, ...]:
        """The places of the actuated freedoms among all twists."""
        found, start = [], 0
        for j in (self.joints[k] for k in self.leading):
            found += [start + place for place in j.actuated]
            start += j.freedoms
        return tuple(found)

    @cached_property
    def passive(self) -> tuple[int, ...]:
        """The places of the others."""
        return tuple(k for k in range(self.freedoms) if k not in self.actuated)

    def twists(self, field: Field | None = None) -> Matrix:
        """One row (ω; v) for each freedom, from the base to the platform; for floats (..., freedoms, 6)."""
        field = field or self.field
        if field not in self._known_twists:
            self._known_twists[field] = self._twists(field)
        return self._known_twists[field]

    def _twists(self, field: Field) -> Matrix:
        rows = [j.twists(field) for j in self.joints]
        for joint, leader, ratio in self.couplings:
            times = field.number(ratio, "the ratio of a coupling")
            (led,), (own,) = rows[joint], rows[leader]
            rows[leader] = (tuple(field.reduced(a + times * b) for a, b in zip(own, led, strict=True)),)
        return field.matrix([row for k in self.leading for row in rows[k]])

    @cached_property
    def _known_twists(self) -> dict[Field, Matrix]:
        """Those that were computed before, which several ranks and systems take; none of them writes into them."""
        return {}

    def rows(self, field: Field | None = None) -> Matrix:
        """The twists as the platform and, side by side, each loop of the limb's own have them."""
        field = field or self.field
        twists = self.twists(field)
        return field.spread(twists, self._shares(range(self.freedoms))) if self.shares else twists

    def rank(self, field: Field | None = None) -> Any:
        """The number of independent twists. Where it is smaller than in other configurations of the same limb, the
        limb itself is singular (serial singularity): it has more constraint wrenches there.
        """
        return self.rank_of(range(self.freedoms), field)

    def passive_rank(self, field: Field | None = None) -> Any:
        """The same of the passive twists."""
        return self.rank_of(self.passive, field)

    def rank_of(self, places: Sequence[int], field: Field | None = None) -> Any:
        """The same of the twists at these places."""
        field = field or self.field
        rows = field.comparable(field.chosen(self.twists(field), places))
        return field.rank(field.spread(rows, self._shares(places)) if self.shares else rows)

    def constraints(self, field: Field | None = None) -> Matrix:
        """A basis of the wrenches reciprocal to all twists: those that the limb applies without its actuators."""
        return self._applied(range(self.freedoms), field or self.field)

    def locked(self, field: Field | None = None) -> Matrix:
        """A basis of the wrenches that the limb applies with locked actuators: reciprocal to the passive twists."""
        return self._applied(self.passive, field or self.field)

    def applied(self, field: Field, *, locked: bool) -> tuple[Matrix, int]:
        """`locked` or `constraints`, and the rank of the passive twists or of all."""
        places = self.passive if locked else range(self.freedoms)
        if field.floating and self.shares:  # a rank of floats is that of the twists themselves
            return self._applied(places, field), self.rank_of(places, field)
        return reciprocal_and_rank(field.chosen(self.twists(field), places), field, self._shares(places))

    def locked_by(self, actuator: int, field: Field | None = None) -> Matrix:
        """A basis of the wrenches that it applies with only this one of its `actuated` freedoms locked."""
        place = self.actuated[actuator]
        return self._applied([k for k in range(self.freedoms) if k != place], field or self.field)

    def _applied(self, places: Sequence[int], field: Field) -> Matrix:
        return reciprocal(field.chosen(self.twists(field), places), field, self._shares(places))

    def _shares(self, places: Iterable[int]) -> Shares:
        """Those of twists at these places; none of a chain."""
        if not self.shares:
            return ()
        every = [self.shares[k] for k in self.leading for _ in range(self.joints[k].freedoms)]
        return [every[k] for k in places]

    def actuations(self, field: Field | None = None) -> Matrix:
        """One wrench for each actuator: reciprocal to all other twists, with product 1 with its own twist.

        It is determined up to constraint wrenches; of those the one is taken that is orthogonal to all constraint
        wrenches, moments divided by the field's `length`: the shortest. The product with a twist of the platform is
        the rate of that actuator. Raises InputError (floats: gives nan) where that twist depends on the others.
        """
        field = field or self.field
        rows = self.twists(field)
        shares = self._shares(range(self.freedoms))
        found = [actuation(rows, place, field, shares) for place in self.actuated]
        if not field.floating and None in found:
            place = self.actuated[found.index(None)]
            raise InputError(
                f"freedom {place} of the limb {self} depends on the others here: its actuator applies no wrench",
                hint="the limb is singular in this configuration, or the freedom is idle in all",
            )
        return field.matrix([row for row in found if row is not None]) if found else field.chosen(rows, ())

    def system(self, field: Field | None = None) -> ScrewSystem:
        """The platform's twists, of one configuration."""
        field = field or self.field
        if self.shares:
            return self.constraint_system(field).reciprocal()
        return ScrewSystem.span(self.twists(field), field)

    def constraint_system(self, field: Field | None = None) -> ScrewSystem:
        """The span of `constraints`."""
        return ScrewSystem.span(self.constraints(field), field or self.field)

    def locked_system(self, field: Field | None = None) -> ScrewSystem:
        """The span of `locked`."""
        return ScrewSystem.span(self.locked(field), field or self.field)

    def __str__(self) -> str:
        """Symbols of the joints, those with an actuator underlined."""
        line = "\u0332"
        return "".join(c + line * bool(j.actuated) for j in self.joints for c in j.kind.symbol)


def limb(*joints: Joint, name: str = "", couplings: Iterable[tuple[int, int, Any]] = ()) -> Limb:
    """A limb of these joints, from the base to the platform. Of `couplings` see `Limb`; rates are measured in the
    directions as they are given, so these have to be of one length. Raises InputError for no joints, for something
    else, and for couplings that name no two joints with one freedom each, or more than one leader.

    >>> from gcrules.screws.joints import joint
    >>> up, geared = (0, 0, 1), [(1, 0, -1)]
    >>> pair = limb(joint("R", point=(0, 0, 0), axis=up), joint("R", point=(1, 0, 0), axis=up), couplings=geared)
    >>> [list(map(int, row)) for row in pair.twists()]  # a slide along y
    [[0, 0, 0, 0, 1, 0]]
    """
    for j in joints:
        if not isinstance(j, Joint):
            raise InputError(f"{j!r} is not a joint", hint='write joint("R", point=…, axis=…)')
    if not joints:
        raise InputError("a limb needs joints: without one the platform is fixed")
    pairs = tuple(couplings)
    places = range(len(joints))
    for led, leader, _ in pairs:
        if led == leader or led not in places or leader not in places:
            raise InputError(f"a coupling of joints {led!r} and {leader!r}", hint="name two places of joints, from 0")
        if joints[led].freedoms != 1 or joints[leader].freedoms != 1:
            raise InputError("coupled joints have one freedom each", hint="write the joint as several of kind R and P")
        if joints[led].actuated:
            raise InputError(f"joint {led} follows joint {leader}, and is actuated", hint="let it lead")
    followers = [led for led, _, _ in pairs]
    if len(set(followers)) < len(followers) or any(leader in followers for _, leader, _ in pairs):
        raise InputError("a joint that follows has one leader, which follows none")
    return Limb(tuple(joints), name, (), pairs)
