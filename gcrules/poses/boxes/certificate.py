r"""What a map of whole boxes says, with all that another program needs to prove it again: `check_boxes.py` reads this.

>>> from gcrules.poses.boxes.box_map import box_map
>>> found = box_certificate(box_map("3-rpr", ["x -0.1:0.1", "yaw -5:5 deg"], tiles=1, boxes=15))
>>> found["trees"], found["shares"]["free"]
(['f'], 1.0)
"""

from __future__ import annotations

from typing import Any, Protocol

from gcrules.core.errors import LimitReached
from gcrules.mechanisms.limbs import Limbs
from gcrules.poses.boxes.task import SHARES, BoxTask
from gcrules.poses.boxes.trees import LEAF, NEGATIVE, Codes
from gcrules.poses.certificate_files import signed
from gcrules.poses.compiling.checking import geometry, placing_program, program_lines
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED

__all__ = ["FORMAT", "box_certificate", "check_boxes"]

FORMAT = "gcrules boxes certificate 1"
MAX_BOXES = 4_000_000
_LETTERS = {FREE: "f", FREE + NEGATIVE: "g", OUTSIDE: "o", CROSSED: "x", UNDECIDED: "u"}


class _Map(Protocol):
    """A `BoxMap`, as far as it is needed here."""

    @property
    def task(self) -> BoxTask: ...
    @property
    def shares(self) -> Any: ...

    def tile(self, tile: int) -> Any: ...


def check_boxes(task: BoxTask) -> dict[str, Any]:
    """The geometry of the robot, as certificates of ranges have it, with the roots that show which poses are reached,
    where these are known. Raises LimitReached for robots of which no checker knows it, and for too many boxes.
    """
    if task.number * task.boxes > MAX_BOXES:
        raise LimitReached(
            f"a certificate has at most {MAX_BOXES:,} boxes", hint="take fewer --tiles or --boxes, or several maps"
        )
    found = geometry(task.mechanism, task.question.names)
    if found is None:
        raise LimitReached(
            f"a map of whole boxes of {task.mechanism.title} has no certificate: it has loops inside its limbs, or no"
            " closed forms of all its limbs are known",
            hint="gcrules map boxes gives its proof all the same; the file is for programs that recompute it",
        )
    m = task.mechanism
    roots = placing_program(m, task.question.names) if isinstance(m, Limbs) and "rods" not in found else None
    return found if roots is None else {**found, "roots": program_lines(roots)}


def box_certificate(m: _Map) -> dict[str, Any]:
    """The robot, what was asked, and the tree of each tile, the last coordinate's tiles one after the other. A tree has
    a sign for each box, a box that is cut before its lower half, that before the upper one: a digit is the coordinate
    of `over` across which it is cut in the middle; f free, g free with the other sign of the determinant than at home,
    o outside, x crossed, u undecided. Raises LimitReached as `check_boxes`.
    """
    task = m.task
    found, shares = check_boxes(task), m.shares.reshape(-1, len(SHARES)).mean(axis=0).tolist()
    over = [{**r, "tiles": n} for r, n in zip(task.asked["over"], task.grid, strict=True)]
    return signed(
        FORMAT,
        task.mechanism.title,
        question={**task.asked, "over": over, "cones": [], "tilt": None},
        geometry=found,
        trees=[_preorder(m.tile(k)["tree"].ravel()) for k in range(task.number)],
        shares=dict(zip(SHARES, shares, strict=True)),
    )


def _preorder(codes: Codes) -> str:
    """A tree that is kept level by level, each box before its halves."""
    levels, start, count = [], 0, 1
    while count:
        level = codes[start : start + count].tolist()
        levels.append(iter(level))
        start, count = start + count, 2 * sum(c < LEAF for c in level)
    letters, waiting = [], [0]
    while waiting:
        depth = waiting.pop()
        code = next(levels[depth])
        letters.append(_LETTERS[code - LEAF] if code >= LEAF else str(code - 1))
        if code < LEAF:
            waiting += [depth + 1, depth + 1]
    return "".join(letters)
