"""The answer to whether a robot is free of singularities in its whole range, with the boxes that prove it."""

from __future__ import annotations

import gzip
import json
from collections.abc import Sequence
from functools import cached_property
from os import PathLike, fspath
from typing import Any

import numpy as np

from gcrules.core.arguments import FILE, checked
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, InputError
from gcrules.core.files import write_file
from gcrules.core.floats import rounded_down
from gcrules.core.frozen import HoldsArrays
from gcrules.core.shown import Shown
from gcrules.core.version import __version__
from gcrules.poses.boxes.deciding import Boxes
from gcrules.poses.boxes.task import SHARES, BoxTask, decided_part
from gcrules.poses.boxes.trees import Leaves
from gcrules.poses.certificates.asked import Asked
from gcrules.poses.certificates.search import OTHER, Search
from gcrules.poses.compiling.checking import geometry
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED

__all__ = ["FORMAT", "PICTURES", "Bad", "Certificate", "check_suffix", "read_certificate", "restored"]

FORMAT = "gcrules certificate 1"
PICTURES = ("svg", "pdf", "png")
"""Kinds of pictures."""
_LETTERS = {FREE: "f", OTHER: "g", OUTSIDE: "o", CROSSED: "x", UNDECIDED: "u"}
_STATUS = {letter: status for status, letter in _LETTERS.items()}


@dataclass(frozen=True)
class Bad:
    """A pose in the range that is singular, or below the margin: its coordinates in the units of the axes, as text for
    `gcrules pose`, its margin, its cause in words; the box around it, all within the limits, and two places in it where
    the determinant has opposite signs (none where the margin is below the one asked for), in rad and the file's unit.
    """

    place: tuple[float, ...]
    at: str
    margin: float
    causes: tuple[str, ...]
    box: tuple[tuple[float, float], ...]
    ends: tuple[tuple[float, ...], ...]


@dataclass(frozen=True, eq=False)
class Certificate(HoldsArrays, Shown):
    """What is proved of a whole range. `verdict` is free (no pose of it that is reached within the limits is singular,
    or has a margin below the one asked for), outside (none is reached), singular or below (one is), undecided; `shares`
    are of its volume in coordinates: free, free with the other sign of the determinant than at home, outside, crossed,
    undecided. In free boxes the margin σ is at least `bound`, proved and rounded down to four digits; `least` is the
    smallest that was seen at a pose within the limits, at `place` in the units of the axes. `bad` is a pose that is not
    free. `target` is the share that was asked for. `tree` and `bounds` are what proves it: see `to_json`.
    """

    asked: Asked
    verdict: str
    target: float
    shares: tuple[float, ...]
    bound: float | None
    least: float | None
    place: tuple[float, ...] | None
    boxes: int
    bad: Bad | None
    tree: str
    bounds: tuple[float, ...]

    @property
    def axes(self) -> tuple[GridAxis, ...]:
        """The coordinates; the two nodes of each are its ends."""
        return self.asked.axes

    @property
    def task(self) -> BoxTask:
        """The range as a map of whole boxes has it, of one tile."""
        return self.asked.task

    @property
    def decided(self) -> float:
        """The share that is proved to be free, or to be outside."""
        return decided_part(self.shares)

    @property
    def holds(self) -> bool | None:
        """True where the range is free as far as was asked for, False where it is not, None where it is not known."""
        if self.verdict in ("singular", "below"):
            return False
        return True if self.verdict in ("free", "outside") or self.decided >= self.target < 1 else None

    @cached_property
    def geometry(self) -> dict[str, Any] | None:
        """What a checker needs of the robot; None for one of which it knows nothing."""
        return geometry(self.asked.mechanism, self.asked.task.question.names)

    def coordinates(self, place: Sequence[float]) -> dict[str, float]:
        """All coordinates of the pose at a place in the units of the axes, in radians and the file's unit."""
        return self.asked.coordinates([float(c) for c in np.array(place) * self.task.units])

    def leaves(self, tile: int = 0) -> Leaves:
        """The boxes that are not cut, in radians and the file's unit; there is one tile."""
        return self._leaves

    @cached_property
    def _leaves(self) -> Leaves:
        whole = self.task.box(0)
        waiting = [(whole.middles[0], whole.halves[0], 0)]
        middles, halves, depths, status = [], [], [], []
        for sign in self.tree:
            middle, half, depth = waiting.pop()
            if sign in _STATUS:
                middles.append(middle)
                halves.append(half)
                depths.append(depth)
                status.append(_STATUS[sign])
                continue
            step = np.zeros_like(half)
            step[int(sign)] = half[int(sign)] / 2
            waiting += [(middle + step, half - step, depth + 1), (middle - step, half - step, depth + 1)]
        every = np.array(status)
        boxes = Boxes(np.array(middles), np.array(halves))
        return Leaves(boxes, np.array(depths), np.where(every == OTHER, FREE, every).astype(np.uint8), every == OTHER)

    def to_bytes(self, *, packed: bool) -> bytes:
        """The file that the checker reads, `packed` with gzip."""
        found = json.dumps(self.to_json(), separators=(",", ":")).encode() + b"\n"
        return gzip.compress(found, mtime=0) if packed else found

    def to_json(self) -> dict[str, Any]:
        """The certificate as its file has it. `tree` has a sign for each box, a box that is cut before its lower half,
        that before the upper one: a digit is the coordinate of `over` across which it is cut in the middle; f free, g
        free with the other sign of the determinant than at home, o outside, x crossed, u undecided. `bounds` are what
        the margin is at least in each free box, in their order.
        """
        return {
            "format": FORMAT,
            "made by": f"gcrules {__version__}",
            "title": self.asked.mechanism.title,
            "question": self.asked.to_json(),
            "geometry": self.geometry,
            "claim": {
                "verdict": self.verdict,
                "margin at least": self.bound,
                "smallest margin seen": self.least,
                "at": None if self.place is None else list(self.place),
                "shares": dict(zip(SHARES, self.shares, strict=True)),
                "target": self.target,
            },
            "singular pose": None
            if self.bad is None
            else {
                "place": list(self.bad.place),
                "at": self.bad.at,
                "margin": self.bad.margin,
                "causes": list(self.bad.causes),
                "box": [list(ends) for ends in self.bad.box],
                "opposite signs at": [list(end) for end in self.bad.ends],
            },
            "tree": self.tree,
            "bounds": list(self.bounds),
        }

    @checked("certificate.save", path=FILE)
    def save(self, path: str) -> None:
        """Write the file that the checker reads, .json, or .json.gz for less room; or a picture of the boxes: .svg,
        .pdf, .png. Raises FileError.
        """
        kind = check_suffix(path)
        data = self._show("picture", kind=kind) if kind in PICTURES else self.to_bytes(packed=kind == "gz")
        write_file(path, data, at_once=True)

    def __repr__(self) -> str:
        over = ", ".join(a.name for a in self.asked.axes)
        return f"<Certificate over {over}: {self.verdict}, {100 * self.decided:.4g} % decided>"


def check_suffix(path: str) -> str:
    """The kind of a file by its name. Raises FileError for a name of something else."""
    kind = path.lower().rpartition(".")[2]
    if kind in PICTURES or path.lower().endswith((".json", ".json.gz")):
        return kind
    raise FileError(
        "not a name for a certificate",
        filename=path,
        hint=f"certificates end in .json or .json.gz, pictures of them in {', '.join(f'.{p}' for p in PICTURES)}",
    )


def parts_of(search: Search) -> tuple[str, tuple[float, ...]]:
    """The tree of boxes as text, and the bounds of free ones, rounded down."""
    letters, bounds = [], []
    for k in search.preorder():
        side = search.side_of(k)
        letters.append(str(side) if side is not None else _LETTERS[int(search.status[k])])
        if letters[-1] in "fg":
            bounds.append(float(rounded_down(float(search.bounds[k]))))
    return "".join(letters), tuple(bounds)


def read_certificate(path: str | PathLike[str]) -> dict[str, Any]:
    """The contents of a file that `Certificate.save` wrote. Raises FileError for what is none."""
    name = fspath(path)
    try:
        with open(name, "rb") as file:
            data = file.read()
        found = json.loads(gzip.decompress(data) if data[:2] == b"\x1f\x8b" else data)
    except OSError as fault:
        raise FileError(f"cannot be read: {fault.strerror or fault}", filename=name) from None
    except (ValueError, EOFError, RecursionError) as fault:
        raise FileError("not a certificate: not JSON", filename=name) from fault
    if not isinstance(found, dict) or found.get("format") != FORMAT:
        raise FileError("not a certificate in a known format", filename=name, hint="gcrules certify … -o FILE.json")
    return found


def restored(search: Search, kept: dict[str, Any], question: dict[str, Any], name: str) -> None:
    """Take over what a certificate has of the same question. Raises FileError where it is of another one."""
    if kept.get("question") != json.loads(json.dumps(question)):
        raise FileError("a certificate of another question", filename=name, hint="ask for the same range and limits")
    try:
        bounds = iter([float(c) for c in kept["bounds"]])
        waiting = [0]
        for sign in kept["tree"]:
            k = waiting.pop()
            if sign in _STATUS:
                status = _STATUS[sign]
                search.status[k] = UNDECIDED if status == CROSSED else status
                if status in (FREE, OTHER):
                    search.bounds[k] = next(bounds)
                continue
            first = search.cut(np.array([k]), np.array([_side(sign, search)]))
            waiting += [int(first[1]), int(first[0])]
        if waiting:
            raise InputError("it ends too soon")
    except (KeyError, TypeError, ValueError, IndexError, StopIteration, InputError) as fault:
        raise FileError("not a certificate: its tree of boxes is not complete", filename=name) from fault


def _side(sign: str, search: Search) -> int:
    side = int(sign)
    if side >= search.middles.shape[1]:
        raise ValueError(sign)
    return side
