r"""Whether the lines of limbs that have loops of their own stand for their wrenches also where a limb loses wrenches.

A chain never applies fewer wrenches than elsewhere: where its twists depend on each other it applies more. A limb with
loops may: where they hold its bodies less than elsewhere, the platform moves with them while all actuators are locked.
Then the robot may be singular, and its lines have to show it. Such members are looked for along random paths, as
exact roots of the determinant of the twists that the loops see, mixed at random (Schwartz and Zippel). Where the lines
hide one, others are chosen that depend on each other at all of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

from gcrules.core.errors import GcrulesError
from gcrules.core.seeds import drawn
from gcrules.mechanisms.conditions.factor_causes import ENOUGH, paths
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import Values
from gcrules.mechanisms.lines.equivalent import Equivalent, equivalent
from gcrules.mechanisms.lines.ranks import ranks
from gcrules.mechanisms.lines.singular import Mixing, interpolated, roots
from gcrules.mechanisms.lines.wrenches import PLANAR
from gcrules.screws import RESIDUES
from gcrules.screws.field import Row

__all__ = ["lines_that_hold"]

_PATHS = 24


def lines_that_hold(family: Family, structure: Equivalent, home: Mapping[str, Any] | None) -> Equivalent:
    """The structure, with other lines for limbs whose lines hide a singular member where the limb loses wrenches; with
    none where there are no others.
    """
    limbs = [limb.limb for limb in structure.limbs]
    lost = {limb.name: tuple(_members(family, limb)) for limb in limbs if limb.subchains}
    for others in (False, True):
        hidden = {n for n, own in lost.items() if not all(_seen(family, limbs, structure, v) for v in own)}
        if structure.lines is None or not hidden:
            return structure
        if not others:
            structure = equivalent(family, limbs, home, lost={n: lost[n] for n in hidden})
    kept = tuple(replace(one, lines=None) if one.limb.name in hidden else one for one in structure.limbs)
    return replace(structure, limbs=kept, lines=None, ideal=(), given=(), derived=())


def _seen(family: Family, limbs: list[LimbSpec], structure: Equivalent, values: Values) -> bool:
    """Whether the lines depend on each other at a member, if the robot is singular there."""
    if structure.lines is None:
        return True
    points = structure.points(family, values)
    rows = [line.row(points) for line in structure.lines]
    known = PLANAR if family.plane else ()
    full = 6 - len(known)
    return RESIDUES.rank([*known, *rows]) < 6 or ranks(family, limbs, values).wrenches == full


def _members(family: Family, limb: LimbSpec) -> Iterator[Values]:
    """Members at which a limb's loops hold its bodies less than elsewhere, with its actuators locked."""

    def seen(values: Values) -> tuple[Row, ...]:
        own = limb.at(values, RESIDUES)
        return tuple(row[6:] for k, row in enumerate(own.rows(RESIDUES)) if k in own.passive)

    usual = RESIDUES.rank(seen(family.member("loops")))
    mixing = Mixing(drawn("loops"), seen(family.member("loops")), usual)

    met = 0
    names = tuple(dict.fromkeys(n for j in limb.joints for n in j.names))
    for _, path in zip(range(_PATHS), paths(family, names, "loops"), strict=False):
        try:
            polynomial = interpolated(mixing.along(lambda t, path=path: seen(path.member(t))))  # type: ignore[misc]
        except GcrulesError:  # a joint is none on the way
            continue
        for t in roots(polynomial or []):
            values = path.member(t)
            with suppress(GcrulesError):
                ranks(family, [limb], values)
                if RESIDUES.rank(seen(values)) < usual:
                    met += 1
                    yield values
        if met >= ENOUGH * 2:
            return
