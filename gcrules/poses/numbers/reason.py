"""The verdict at a pose with its reason in a sentence."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.screws.guarantees import Guarantees
from gcrules.screws.margin import LegJacobians
from gcrules.screws.threshold import Threshold, margin_of, safe, turn_of
from gcrules.screws.verdict import CLOSE, decide

__all__ = ["verdict"]


def verdict(
    j: LegJacobians,
    bounds: Guarantees,
    value: Fraction,
    floor: float,
    spread: float,
    threshold: Threshold,
    found: Sequence[NearestPose],
    unit: str,
) -> tuple[str, str]:
    """The verdict and the reason, at the one pose of `j`.

    `value` is the superbracket, `floor` what rounding may do to σ and `spread` what the accuracy of the joints may;
    `found` holds the nearest singular pose in translation first, if the threshold is a length.
    """
    sigma, turn = float(j.sigma[0]), float(bounds.turn[0])
    if value == 0:
        return "singular", "The superbracket is exactly 0: the legs do not control the platform."
    close = CLOSE if threshold.angle is None else margin_of(threshold.angle)
    word = decide(sigma, floor, spread, close)
    if word == "singular":
        return word, f"σ = {sigma:.2g} is 0 within rounding (to 1e-12 of the robot's size)."
    if sigma <= spread:
        return "close", f"σ = {sigma:.2g}, but the accuracy of the joints leaves σ uncertain by {spread:.2g}."
    if threshold.length is not None:
        near = found[0]
        far = near.lower >= threshold.length
        length = safe(near.lower, unit, 4)
        if near.never:
            return "regular", "At this orientation there is no singular pose at all."
        words = f"t this orientation no singular pose is nearer than {length} (threshold {threshold.text})."
        return ("regular", f"A{words}") if far else ("close", f"Singular poses may be near: a{words}")
    safe_turn = turn_of(sigma - spread)
    least = safe(min(turn, safe_turn))
    words = f"no pose is singular while every leg turns by less than {least} relative to the platform"
    if word == "regular":
        return word, f"N{words[1:]} (threshold {threshold.text})."
    return word, f"It is only certain that {words}; the threshold is {threshold.text}."
