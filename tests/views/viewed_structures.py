"""Structures whose scenes are looked at."""

from __future__ import annotations

from places import ROOT

import gcrules as gc
from gcrules.mechanisms.description.platform_file import load_platform

__all__ = ["OCTAHEDRAL", "STRUCTURES"]

EXAMPLES = ROOT / "examples"
OCTAHEDRAL = gc.analyze(load_platform(EXAMPLES / "octahedral.yaml"))
STRUCTURES = {
    "octahedral": OCTAHEDRAL,
    "octahedral-singular": gc.analyze(load_platform(EXAMPLES / "octahedral-singular.yaml")),
    "6-6": gc.analyze(load_platform(EXAMPLES / "platform-6-6.yaml")),
    "6-4": gc.analyze(load_platform(EXAMPLES / "platform-6-4.yaml")),
    "four-dof": gc.analyze(load_platform(EXAMPLES / "four-dof.yaml")),
    "turned round": gc.analyze("ba af cb cd ed ef"),
}
