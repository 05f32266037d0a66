r"""Which method computes something for a mechanism; what cannot be had yet is said here, with what there is instead.

Much is computed for platforms on six legs only, by the exact road of their superbracket. A robot of joints whose limbs
are six legs takes this road too where its own kind has no method.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import TypeVar

from gcrules.core.errors import InputError
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs

__all__ = ["Methods", "as_six_legs", "has_six_legs", "legs_within", "method", "on_six_legs"]

Answer = TypeVar("Answer")
Methods = Mapping[type[Mechanism], Callable[..., Answer]]


def method(methods: Methods[Answer], found: Mechanism, what: str) -> Callable[..., Answer]:
    """The method of its kind for the mechanism, or that for six legs. Raises InputError where it has neither."""
    own = methods.get(type(found))
    return partial(methods[SixLegs], on_six_legs(found, what)) if own is None else partial(own, found)


def on_six_legs(found: Mechanism, what: str) -> SixLegs:
    """The mechanism as a platform on six legs. Raises InputError where it is none: `what` has no method for it."""
    try:
        return found.six_legs()
    except InputError as fault:
        raise InputError(f"{what} is for platforms on six legs; {fault.message}", hint=fault.hint) from None


def as_six_legs(found: Mechanism) -> SixLegs | None:
    """The mechanism as a platform on six legs, which a robot is whose limbs are six legs; None if it is none."""
    try:
        return found.six_legs()
    except InputError:
        return None


def legs_within(found: Mechanism, limits: str | None) -> SixLegs | None:
    """The same for what keeps to limits, those of the file where None are given. None, too, where these are of slides
    that do not go along the legs, so that lengths of legs do not say them.
    """
    legs = as_six_legs(found)
    untold = legs is not None and limits is None and found.limits and not legs.limits
    return None if untold else legs


def has_six_legs(found: Mechanism) -> bool:
    """Whether the mechanism is a platform on six legs, or a robot whose limbs are six legs."""
    return as_six_legs(found) is not None
