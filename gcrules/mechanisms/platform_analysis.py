"""The analysis of six legs, with or without coordinates; with them, the numbers in the pose of the file too."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from os import PathLike

from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.language.text import SHORT_NAME, Names, split_names
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.analysis import analyze as analyze_legs
from gcrules.conditions.pose_value import pose_value
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.rules.factorization import SECONDS
from gcrules.rules.strategy import Strategy

__all__ = ["analyze"]


Legs = str | Iterable[str | Sequence[str]] | Structure


def analyze(
    legs: Legs | Platform,
    *,
    order: str | Sequence[int | str] | None = None,
    points: Names = (),
    ideal: Names = (),
    given: str | Iterable[str] = (),
    rank: int = 4,
    catalogs: Iterable[str | PathLike[str]] = (),
    recheck: bool = False,
    strategy: Strategy | None = None,
    search: float = SECONDS,
) -> Analysis:
    """Analyse six legs: when is the platform singular, and why.

    `legs` is text ("ab af cb cd ed ef") or pairs of names, a leg written with one body's joint first throughout, or a
    platform with coordinates (`load_platform`), for which the numbers in its pose are given too. A line that is no pair
    of joints is built from points: "abc /\\ def". `order` keeps the user's own order of legs instead of the shortest
    one; `points` declares long names, `ideal` the points at infinity, `given` what is assumed of points (as
    `gcrules.prove` takes it), and `rank` another space, in which there are n (n − 1) / 2 lines.

    `catalogs` adds files of the user's own; `strategy` says which rules run. With `recheck` readings that are instances
    of catalog identities are proved from scratch. Where no rule finds a condition, a factorization is sought for
    `search` seconds. Raises InputError for the wrong number of lines, for what is no line, and for assumptions that are
    not resolved.
    """
    if not isinstance(legs, Platform):
        return analyze_legs(
            legs,
            order=order,
            points=points,
            ideal=ideal,
            given=given,
            rank=rank,
            catalogs=catalogs,
            recheck=recheck,
            strategy=strategy,
            search=search,
        )
    if given or rank != 4:
        raise InputError(f"{legs.filename} gives coordinates: assumptions and other ranks are for legs without")
    structure = _structure(legs, split_names(points), split_names(ideal))
    analysis = analyze_legs(
        structure, order=order, catalogs=catalogs, recheck=recheck, strategy=strategy, search=search
    )
    return _in_pose(analysis, legs)


def _structure(platform: Platform, points: tuple[str, ...], ideal: tuple[str, ...]) -> Structure:
    """The legs of a platform without their coordinates."""
    if ideal:
        raise InputError(f"{', '.join(ideal)} cannot lie at infinity: {platform.filename} gives finite coordinates")
    long_names = (n for n in platform.points if not SHORT_NAME.fullmatch(n))
    try:
        return read_legs(platform.legs, points=tuple(dict.fromkeys((*points, *long_names))))
    except InputError as fault:
        fault.filename = platform.filename
        raise


def _in_pose(analysis: Analysis, platform: Platform) -> Analysis:
    """With the numbers in the pose of the file."""
    try:
        pose = pose_value(analysis.structure, analysis.condition, platform.homogeneous(), unit=platform.units)
    except InputError as fault:  # the condition holds all the same
        why = f"{platform.filename}: there are no numbers for the pose of the file: {fault.message}"
        return replace(analysis, platform=replace(platform, warnings=(*platform.warnings, why)))
    return replace(analysis, platform=platform, pose=pose)
