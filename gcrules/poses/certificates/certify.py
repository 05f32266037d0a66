r"""Is a robot free of singularities in its whole range? Proved, or a singular pose of it, or what is undecided.

>>> found = certify("3-rpr", ["x -0.1:0.1", "yaw -5:5 deg"], time=5)
>>> found.verdict, found.bound > 0.2, found.bound <= found.least
('free', True, True)
"""

from __future__ import annotations

from collections.abc import Sequence
from os import PathLike, fspath
from time import monotonic
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.boxes.deciding import Boxes
from gcrules.poses.boxes.ties import upwards
from gcrules.poses.certificates.asked import Asked, asked, share_of
from gcrules.poses.certificates.certificate import Bad, Certificate, parts_of, read_certificate, restored
from gcrules.poses.certificates.search import OTHER, Search
from gcrules.poses.maps.axes import GridAxis
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED
from gcrules.poses.pose import pose
from gcrules.poses.recipe import robot_of

__all__ = ["certified", "certify"]

Floats = NDArray[np.float64]

_MOST = 4_000_000
"""Boxes of a tree, some hundreds of bytes each."""
_TIME = 60.0  # s
_HALVINGS = 48
_AGAIN = 6
"""Times the boxes that the search looked at, for a better bound of the margin."""
_FEW = 256
"""Boxes that take no time."""


def certify(
    source: Source,
    over: Sequence[str | GridAxis],
    at: Any = None,
    *,
    about: str | Sequence[Any] = "centroid",
    limits: str | None = None,
    cone: str | None = None,
    tilt: str | None = None,
    margin: float = 0.0,
    time: float | None = None,
    boxes: int | None = None,
    target: str | float = 1.0,
    resume: str | PathLike[str] | None = None,
) -> Certificate:
    """Whether a robot is free of singular poses in its whole range, not at samples (a `Certificate`).

    `source`, `over`, `at`, `about`, `limits` and `margin` are those of `box_map`. Joints at the ends of rods keep to a
    `cone` around their direction at home, as the body there carries it: "40 deg" for all, "base 30 deg, platform 40
    deg", "C1 35 deg". The platform's third axis keeps to a `tilt`, "40 deg" in any direction. Boxes are cut for so much
    `time` in seconds (60, without end where a number of boxes is given), until there are so many `boxes`, or until the
    `target` share is decided. Where no margin is asked for, the boxes with the lowest bounds are cut further, for
    a better one. `resume` is the file of an earlier certificate of the same question, from which it goes on until the
    time is up, or the bound is known well.

    Raises InputError for what makes no sense, and where something has no closed form; FileError for another file.
    """
    seconds, most = _ends(time, boxes)
    share = share_of(target)
    found = asked(mechanism(source, about=about), over, at, limits, cone, tilt, margin)
    return certified(found, seconds, most, share, resume)


def _ends(time: float | None, boxes: int | None) -> tuple[float, int]:
    """How long the search goes on, and how many boxes it has at most. Raises InputError for what makes no sense."""
    if time is None:
        time = _TIME if boxes is None else np.inf
    elif not 0 <= time < np.inf:
        raise InputError(f"a time of {time} s", hint="a number of seconds, 0 or more")
    if boxes is not None and boxes < 1:
        raise InputError(f"{boxes} boxes", hint="a number of boxes, 1 or more")
    return time, _MOST if boxes is None else min(boxes, _MOST)


def certified(
    found: Asked, time: float, boxes: int, target: float = 1.0, resume: str | PathLike[str] | None = None
) -> Certificate:
    """The answer to a question, with so many boxes at most, after so many seconds; raises FileError for a file of
    another one.
    """
    search = Search(found.decider, found.task.box(0), found.task.home, found.task.margin)
    if resume is not None:
        _resumed(search, found, resume)
    until = monotonic() + time
    search.run(until, target, boxes)
    if search.crossed is None and not found.task.margin:
        search.raise_bound(until, boxes, np.inf if resume is not None else _AGAIN * max(search.looked, _FEW))
    return _certificate(found, search, target)


def _resumed(search: Search, found: Asked, path: str | PathLike[str]) -> None:
    kept = read_certificate(path)
    restored(search, kept, found.to_json(), fspath(path))
    free = np.flatnonzero(np.isin(search.status, (FREE, OTHER)))
    if len(free):
        search.see(free[upwards(search.bounds[free])])


def _certificate(found: Asked, search: Search, target: float) -> Certificate:
    shares = tuple(search.share(s) for s in (FREE, OTHER, OUTSIDE, CROSSED, UNDECIDED))
    free, other, _, crossed, undecided = shares
    bad = None if search.crossed is None else _bad(found, search, search.crossed)
    verdict = "undecided"
    if bad is not None:
        verdict = "singular" if bad.ends else "below"
    elif not (crossed or undecided):
        verdict = "free" if free or other else "outside"
    seen = bool(np.isfinite(search.least))
    tree, bounds = parts_of(search)
    return Certificate(
        found,
        verdict,
        target,
        shares,
        min(bounds) if bounds else None,
        search.least if seen else None,
        tuple((search.place / found.task.units).tolist()) if seen else None,
        len(search.status),
        bad,
        tree,
        bounds,
    )


def _bad(found: Asked, search: Search, k: int) -> Bad:
    """A pose of a crossed box: where the determinant changes its sign between two places of it, or else its middle."""
    decider, middle, half = found.decider, search.middles[k], search.halves[k]
    box = tuple(zip((middle - half).tolist(), (middle + half).tolist(), strict=True))

    def sign(place: Floats) -> int:
        return decider.sign_at(decider.inputs(place[None])[0])

    steps = np.array(np.meshgrid(*[(-1.0, 1.0)] * len(middle), indexing="ij")).reshape(len(middle), -1).T
    tried = decider.tried(Boxes(middle[None], half[None]))[0][:, 0]
    places = [*tried, *(middle + step * half for step in steps)]
    signs = [sign(p) for p in places]
    place = middle
    ends: tuple[tuple[float, ...], ...] = ()
    if {1, -1} <= set(signs):
        low, high = places[signs.index(1)], places[signs.index(-1)]
        ends = (tuple(low.tolist()), tuple(high.tolist()))
        for _ in range(_HALVINGS):
            place = (low + high) / 2
            match sign(place):
                case 1:
                    low = place
                case -1:
                    high = place
                case _:
                    break
    at = found.pose_text(place.tolist())
    margin = float(decider.margins_at(place[None])[0])
    return Bad(tuple((place / found.task.units).tolist()), at, margin, _causes(found, at), box, ends)


def _causes(found: Asked, at: str) -> tuple[str, ...]:
    """What the analysis says of the pose, as `pose` tells it."""
    recipe = found.task.recipe
    try:
        here: Any = pose(robot_of(recipe["robot"]), at, about=recipe["about"], nearest=False)
    except GcrulesError as fault:
        return (f"what it is geometrically is not known: {fault.message}",)
    return tuple(here.causes) or (here.reason,)
