"""The analysis of six legs, with or without coordinates; with them, the numbers in the pose of the file too."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.language.text import SHORT_NAME, split_names
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.conditions.dimensions.facts import TOLERANCE
from gcrules.conditions.pose_value import pose_value
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform

__all__ = ["analyze_legs", "legs_of", "with_dimensions", "with_platform"]

check_given = deferred("gcrules.conditions.dimensions.given:check_given")
dimensions_of = deferred("gcrules.conditions.dimensions.dimensions:dimensions_of")
with_own_condition = deferred("gcrules.conditions.dimensions.dimensions:with_own_condition")

Legs = str | Iterable[str | Sequence[str]] | Structure


def analyze_legs(
    legs: Legs | Platform, *, facts: bool = True, tolerance: float = TOLERANCE, **options: Any
) -> Analysis:
    """`gcrules.conditions.analysis.analyze`, with its options, for platforms with coordinates too: their analysis has
    the numbers in the pose of the file and, with `facts`, what the dimensions say of the bodies up to the `tolerance`,
    a part of their size. Raises InputError for other ranks, letters and points at infinity beside coordinates, and for
    assumptions that these contradict.
    """
    if not isinstance(legs, Platform):
        return analyze(legs, **options)
    if options.pop("rank", 4) != 4:
        raise InputError(f"{legs.filename} gives coordinates: other ranks are for legs without")
    if options.pop("letters", ""):
        raise InputError(f"{legs.filename} gives coordinates: letters for lines are for legs without")
    declared, ideal = split_names(options.pop("points", ())), split_names(options.pop("ideal", ()))
    structure = legs_of(legs, declared, ideal, options.pop("given", ()))
    if structure.given:
        check_given(structure, legs.points, legs.units)
    found = with_platform(analyze(structure, **options), legs)
    return with_dimensions(found, legs, tolerance) if facts else found


def legs_of(
    platform: Platform, points: tuple[str, ...] = (), ideal: tuple[str, ...] = (), given: str | Iterable[str] = ()
) -> Structure:
    """The legs of a platform without their coordinates. Raises InputError for points at infinity."""
    if ideal:
        raise InputError(f"{', '.join(ideal)} cannot lie at infinity: {platform.filename} gives finite coordinates")
    long_names = (n for n in platform.points if not SHORT_NAME.fullmatch(n))
    try:
        return read_legs(platform.legs, points=tuple(dict.fromkeys((*points, *long_names))), given=given)
    except InputError as fault:
        if not given:
            fault.filename = platform.filename
        raise


def with_platform(analysis: Analysis, platform: Platform) -> Analysis:
    """The analysis of its legs with the platform, and the numbers in the pose of the file."""
    try:
        pose = pose_value(analysis.structure, analysis.condition, platform.homogeneous(), unit=platform.units)
    except InputError as fault:  # the condition holds all the same
        why = f"{platform.filename}: there are no numbers for the pose of the file: {fault.message}"
        return replace(analysis, platform=replace(platform, warnings=(*platform.warnings, why)))
    return replace(analysis, platform=platform, pose=pose)


def with_dimensions(analysis: Analysis, platform: Platform, tolerance: float = TOLERANCE) -> Analysis:
    """The analysis with what the dimensions of the platform say beyond its legs; as it is where legs do not tell base
    from platform. Raises InputError for a tolerance that is none.
    """
    found = dimensions_of(analysis.structure, platform.points, tolerance)
    if found is None:
        return analysis
    return replace(analysis, dimensions=with_own_condition(analysis, found, platform.points))
