"""What checks the certificate of an answer again, in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.plans.report import Plan
from gcrules.poses.regions.report import FreeRegion

__all__ = ["certified", "check_of", "kind_of"]

_CHECKERS: Mapping[type, tuple[str, str, str]] = {
    Plan: ("plan", "check_plan.py", "computes the signs again that no way can change"),
    SingularMap: ("map", "check_map.py", "decides every cell anew"),
    FreeRegion: ("free", "check_free.py", "proves the region anew, box by box"),
    BoxMap: ("boxes", "check_boxes.py", "proves the boxes anew, one by one"),
}
"""What its file is called by, the program that checks it, and what this does."""


def certified(answer: Any) -> bool:
    """Whether it is of a kind that has certificates: of plans the answer that there is none."""
    return type(answer) in _CHECKERS and not (isinstance(answer, Plan) and answer.outcome != "none")


def kind_of(answer: Any) -> str:
    """One word for the name of the file."""
    return _CHECKERS[type(answer)][0]


def check_of(answer: Any) -> str:
    """How its certificate is checked again; commands stand between backquotes."""
    _, program, does = _CHECKERS[type(answer)]
    return f"`python checkers/{program} FILE` {does}; `gcrules checkers` writes the program."
