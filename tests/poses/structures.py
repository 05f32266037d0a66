"""Structures of six legs, analysed, and an octahedral platform of whole numbers."""

from __future__ import annotations

from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.mechanisms.platform_analysis import analyze_legs

__all__ = ["ANALYSES", "OCTAHEDRON", "STRUCTURES"]


STRUCTURES = ["ab af cb cd ed ef", "Aa Ab Ac Bd Be Cf", "Aa Ab Ac Bd Ce Df", "Aa Ab Ba Bb Cc Dd", "Aa Ab Bc Cd De Ef"]
ANALYSES = {legs: analyze_legs(legs) for legs in STRUCTURES}


OCTAHEDRON = parse_platform(
    "legs: [ab, af, cb, cd, ed, ef]\nunits: mm\n"
    "points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}"
)
