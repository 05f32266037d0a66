r"""Working modes: a choice for each limb among its solutions of the inverse kinematics, by name, and the robot in one.

Of a robot whose limbs have at most two solutions each a mode is named by signs, one for each limb, + being home's:
"+-+". Else it is named by the numbers of the solutions, from home's 1 on: "1.4.2". Where there is only one it is called
home, as that of home may be in any case.

The robot in a mode is the same one with another home: the platform is where it was, the limbs' joints stand otherwise.
Where the new places have short rational coordinates these are exact, which is checked by the lengths and angles in each
link; else they are rounded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement, product
from math import prod
from typing import Any

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.kinematics.assembled import configuration_at
from gcrules.mechanisms.kinematics.attachments import Values
from gcrules.mechanisms.kinematics.failure_reasons import NotClosed
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage, linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.modes.limb_solutions import LimbSolutions, amounts_at, limb_solutions
from gcrules.mechanisms.robot import Robot
from gcrules.screws import RATIONALS

__all__ = ["LimbChoices", "at_places", "choices_of", "in_working_mode", "reached_at"]

_SIGNS = "+-"
_NAME = re.compile(r"home|[+\-−]+|\d+(\.\d+)*")
_WORDS = re.compile(r"working(?: mode)?\s+")
_DENOMINATORS = 10**6  # of coordinates that are tried to be exact
_SHOWN = 8  # names in a hint
_UNLIMITED = "the limits of its file count from another home, and are left out"

Numbers = tuple[int, ...]


@dataclass(frozen=True, eq=False)
class LimbChoices:
    """The solutions of each limb of a robot with its platform at home; a mode is a number, from 0 on, for each."""

    linkage: Linkage
    limbs: tuple[LimbSolutions, ...]

    def __len__(self) -> int:
        """How many modes there are."""
        return prod(len(limb) for limb in self.limbs)

    def modes(self) -> Iterator[Numbers]:
        """All modes, home's first."""
        return product(*(range(len(limb)) for limb in self.limbs))

    @cached_property
    def signed(self) -> bool:
        """Whether signs name them."""
        return len(self) > 1 and max(len(limb) for limb in self.limbs) == 2

    def name(self, mode: Sequence[int]) -> str:
        """Its name in signs or numbers; "home" where there is no other one."""
        if len(self) == 1:
            return "home"
        return "".join(_SIGNS[k] for k in mode) if self.signed else ".".join(str(k + 1) for k in mode)

    def mode(self, name: str) -> Numbers:
        """The mode of this name, in signs or in numbers. Raises InputError for what is none."""
        robot, text = self.linkage.robot, _WORDS.sub("", name.strip()).replace("−", "-")
        if _NAME.fullmatch(text) is None:
            raise InputError(
                f"{name[:40]!r} names no mode",
                hint='write "assembly 2" (gcrules modes), "operation 2" (gcrules modes --operation) or a working mode:'
                f" {self._examples()}",
            )
        if text == "home":
            return (0,) * len(self.limbs)
        parts = [_SIGNS.index(c) for c in text] if text[0] in _SIGNS else [int(n) - 1 for n in text.split(".")]
        if len(parts) != len(self.limbs):
            raise InputError(
                f"the mode {text} has {len(parts)} part{'s' * (len(parts) > 1)}, and {robot.id} has"
                f" {len(self.limbs)} limbs: one for each, {listed([limb.name for limb in robot.limbs])}",
                hint=f'did you mean "assembly {text}"?' if text.isdigit() else self._examples(),
            )
        for part, own, limb in zip(parts, self.limbs, robot.limbs, strict=True):
            if own.moving and part:
                raise InputError(f"{limb.name} can move with the platform at rest: it has no solutions to choose from")
            if not 0 <= part < len(own):
                ways = "only this one way" if len(own) == 1 else f"{len(own)} ways"
                raise InputError(
                    f"{text} is not a working mode of {robot.id}: at home {ways} of {limb.name} to hold the platform"
                    f" {'was' if len(own) == 1 else 'were'} found",
                    hint=self._examples(),
                )
        return tuple(parts)

    def _examples(self) -> str:
        if len(self) == 1:
            return f"{self.linkage.robot.id} has one working mode, that of home"
        every = [self.name(mode) for mode, _ in zip(self.modes(), range(_SHOWN), strict=False)]
        rest = f" …, {len(self):,} in all (gcrules modes --working lists them)" if len(self) > _SHOWN else ""
        return f"its modes are {', '.join(every)}{rest}"

    def configuration(self, mode: Sequence[int]) -> Configuration:
        """The robot in a mode, the platform at home. Raises NotClosed where it leaves its family: where limbs share
        what they are named by, one of them cannot stand otherwise alone.
        """
        amounts = [limb.amounts[k] for limb, k in zip(self.limbs, mode, strict=True)]
        return configuration_at(self.linkage, amounts)


def choices_of(robot: Robot) -> LimbChoices:
    """The solutions of all limbs. Raises InputError where the robot has no joints or no home."""
    m = linkage(robot)
    return LimbChoices(m, tuple(limb_solutions(m, place) for place in range(len(robot.limbs))))


def in_working_mode(choices: LimbChoices, mode: Sequence[int]) -> Robot:
    """The robot with its home in a working mode; itself for that of home. Raises InputError where it leaves its family
    there.
    """
    robot = choices.linkage.robot
    if not any(mode):
        return robot
    name = choices.name(mode)
    try:
        here = choices.configuration(mode)
    except NotClosed as fault:
        raise InputError(
            f"{robot.id} is not a member of its family in the mode {name}: {fault}", hint=fault.hint
        ) from None
    return at_places(choices.linkage, here.values, f"working mode {name}", driven=True)


def reached_at(m: Linkage, platform: Floats) -> Configuration:
    """A configuration of the robot whose platform went by a motion (4, 4) from home, each limb in that of the solutions
    found from random starts which is nearest to home. Raises InputError where a limb does not reach it, or the robot
    leaves its family there.
    """
    amounts = []
    for place, limb in enumerate(m.robot.limbs):
        every = amounts_at(m, place, platform)
        if not len(every):
            raise InputError(
                f"{limb.name} of {m.robot.id} does not reach that pose",
                hint="it may be a limit of poses that are reached: give the file another home in that mode",
            )
        units = np.where(m.home.chains[place].turns, 1.0, m.size)
        amounts.append(every[np.linalg.norm(every / units, axis=1).argmin()])
    try:
        return configuration_at(m, amounts)
    except NotClosed as fault:
        raise InputError(f"{m.robot.id} is not a member of its family in that pose: {fault}", hint=fault.hint) from None


def at_places(m: Linkage, places: Values, words: str, *, driven: bool = False) -> Robot:
    """The robot with its points and directions in these `places` (those of a configuration of it) for its home, and
    with what that is in words beside its title. Where actuators are `driven` to get there the limits of its file, which
    count from its own home, are left out.
    """
    robot = m.robot
    before = home_values(robot)
    given = [d.name for d in robot.family.definitions if d.parameters or d.name in (robot.home or {})]
    sorts = robot.family.sorts
    shift = {n: m.origin if sorts[n] == "point" else (0, 0, 0) for n in given}
    rounded = {
        n: _added([Fraction(float(c)) for c in places[n]], shift[n])
        if np.abs(places[n] - m.home.values[n]).max() > 1e-12 * m.size
        else before[n]
        for n in given
    }
    short = {n: tuple(c.limit_denominator(_DENOMINATORS) for c in v) for n, v in rounded.items()}
    home = short if _is_same_robot(robot, m, before, short) else rounded
    if driven and robot.limits:
        robot = replace(robot, limits="", note="; ".join(filter(None, [robot.note, _UNLIMITED])))
    return replace(robot, home=home, drawing=None, title=f"{robot.title}, {words}")


def _added(v: Sequence[Any], shift: Sequence[Any]) -> tuple[Any, ...]:
    return tuple(a + b for a, b in zip(v, shift, strict=True))


def _is_same_robot(robot: Robot, m: Linkage, before: Any, home: Any) -> bool:
    """Whether all relations hold, and whether the points and directions of each link have the same distances and angles
    as before, exactly.
    """
    after = replace(robot, home=home).values_at()
    sorts = robot.family.sorts
    for d in robot.family.definitions:
        if any(d.relation.residual(d.sort, RATIONALS, after, after[d.name])):
            return False
    links: dict[tuple[int, int], list[str]] = {}
    for name, own in m.attachments.items():
        for a in own:
            links.setdefault((a.limb, a.link), []).append(name)
    for names in links.values():
        points = [n for n in names if sorts.get(n) == "point"]
        one, other = (_arms(values, names, points) for values in (before, after))
        for j, k in combinations_with_replacement(range(len(one)), 2):
            if RATIONALS.dot(one[j], one[k]) != RATIONALS.dot(other[j], other[k]):
                return False
    return True


def _arms(values: Any, names: Sequence[str], points: Sequence[str]) -> list[Any]:
    """The vectors of a link: from its first point to the others, and its directions."""
    start = values[points[0]] if points else (0, 0, 0)
    arms = [tuple(a - b for a, b in zip(values[n], start, strict=True)) for n in points[1:]]
    return [*arms, *(values[n] for n in names if n not in points)]
