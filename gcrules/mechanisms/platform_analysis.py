"""The analysis of six legs, with or without coordinates; with them, the numbers in the pose of the file too."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.language.text import SHORT_NAME, split_names
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.conditions.pose_value import pose_value
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform

__all__ = ["analyze_legs", "legs_of", "with_platform"]


Legs = str | Iterable[str | Sequence[str]] | Structure


def analyze_legs(legs: Legs | Platform, **options: Any) -> Analysis:
    """`gcrules.conditions.analysis.analyze`, with its options, for platforms with coordinates too: their analysis has
    the numbers in the pose of the file. Raises InputError for assumptions, other ranks and points at infinity beside
    coordinates.
    """
    if not isinstance(legs, Platform):
        return analyze(legs, **options)
    if options.pop("given", ()) or options.pop("rank", 4) != 4:
        raise InputError(f"{legs.filename} gives coordinates: assumptions and other ranks are for legs without")
    structure = legs_of(legs, split_names(options.pop("points", ())), split_names(options.pop("ideal", ())))
    return with_platform(analyze(structure, **options), legs)


def legs_of(platform: Platform, points: tuple[str, ...] = (), ideal: tuple[str, ...] = ()) -> Structure:
    """The legs of a platform without their coordinates. Raises InputError for points at infinity."""
    if ideal:
        raise InputError(f"{', '.join(ideal)} cannot lie at infinity: {platform.filename} gives finite coordinates")
    long_names = (n for n in platform.points if not SHORT_NAME.fullmatch(n))
    try:
        return read_legs(platform.legs, points=tuple(dict.fromkeys((*points, *long_names))))
    except InputError as fault:
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
