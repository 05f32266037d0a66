"""What checks the certificate of an answer again, in words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

__all__ = ["certified", "check_of", "kind_of"]

_CHECKERS: Mapping[str, tuple[str, str, str]] = {
    "gcrules.poses.plans.report.Plan": ("plan", "check_plan.py", "computes the signs again that no way can change"),
    "gcrules.poses.maps.report.SingularMap": ("map", "check_map.py", "decides every cell anew"),
    "gcrules.poses.regions.report.FreeRegion": ("free", "check_free.py", "proves the region anew, box by box"),
    "gcrules.poses.boxes.report.BoxMap": ("boxes", "check_boxes.py", "proves the boxes anew, one by one"),
}
"""What the file of an answer is called by, the program that checks it, and what this does; by names of classes, since
these load much.
"""


def _name(answer: Any) -> str:
    return f"{type(answer).__module__}.{type(answer).__qualname__}"


def certified(answer: Any) -> bool:
    """Whether it is of a kind that has certificates: of plans the answer that there is none."""
    return _name(answer) in _CHECKERS and not (kind_of(answer) == "plan" and answer.outcome != "none")


def kind_of(answer: Any) -> str:
    """One word for the name of the file."""
    return _CHECKERS[_name(answer)][0]


def check_of(answer: Any) -> str:
    """How its certificate is checked again; commands stand between backquotes."""
    _, program, does = _CHECKERS[_name(answer)]
    return f"`python checkers/{program} FILE` {does}; `gcrules checkers` writes the program."
