r"""The determinant of the wrenches of all limbs along a way, with frames that turn continuously, and its sign.

Each limb's wrenches with the actuators locked have a frame: first an orthonormal basis of its constraints, then of what
is left of its wrenches. From one configuration to the next the frames keep their orientation where the determinants of
their overlaps are positive; then the sign of the determinant of all wrenches means the same in both. In an
over-constrained robot one basis of the constraints of all limbs together stands for theirs. The determinant is 0 where
the robot is singular, so a change of its sign is a crossing, whether the robot has a condition or not. Derived here.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.margin import limb_twists
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Frames", "frames", "has_sign", "relative_sign"]

_SPACE, _PLANE = (0, 1, 2, 3, 4, 5), (2, 3, 4)
"""Of twists (ω; v)."""

_RANK = 1e-9
_OVERLAP = 0.5  # the least cosine between frames that are compared
_ZERO = 1e-8  # of a determinant of unit wrenches: below it has no sign


@dataclass(frozen=True, eq=False)
class Frames:
    """Orthonormal rows: constraints and then what actuators add, of each limb or of all; and the determinant of all
    rows together, None where the ranks are not those of the family.
    """

    systems: tuple[Floats, ...]
    determinant: float | None


def frames(m: Linkage, here: Configuration, centre: Floats) -> Frames:
    """The frames of a configuration, with moments about a fixed centre."""
    keep = list(_PLANE if m.robot.family.plane else _SPACE)
    constraints: list[Floats] = []
    added: list[Floats] = []
    whole = True
    for place in range(len(here.chains)):
        twists, free = limb_twists(m, place, here, centre)
        own = _reciprocal(twists[:, keep])
        locked = _reciprocal(twists[free][:, keep])
        constraints.append(own)
        rest = locked - locked @ own.T @ own
        added.append(_span(rest, len(locked) - len(own)))
        expected = len(keep) - m.ranks[place], len(keep) - m.passive_ranks[place]
        whole = whole and (len(own), len(locked)) == expected
    mobility = m.robot.mobility
    together = np.concatenate(constraints)
    if len(together) > len(keep) - mobility:
        _, sizes, right = np.linalg.svd(together)
        constraints = [right[: len(keep) - mobility]]
        whole = whole and int((sizes > _RANK).sum()) == len(keep) - mobility
    rows = np.concatenate([*constraints, *added])
    square = rows.shape[0] == rows.shape[1]
    return Frames((*constraints, *added), float(np.linalg.det(rows)) if whole and square else None)


def _reciprocal(twists: Floats) -> Floats:
    """An orthonormal basis of what is orthogonal to the twists."""
    if not len(twists):
        return np.eye(twists.shape[1])
    _, sizes, right = np.linalg.svd(twists)
    return np.asarray(right[int((sizes > _RANK * max(sizes[0], 1.0)).sum()) :])


def _span(rows: Floats, rank: int) -> Floats:
    return np.asarray(np.linalg.svd(rows)[2][:rank]) if rank else np.zeros((0, rows.shape[1]))


def has_sign(a: Frames) -> bool:
    """Whether the determinant is known and not 0 within rounding."""
    return a.determinant is not None and abs(a.determinant) > _ZERO


def relative_sign(a: Frames, b: Frames) -> int | None:
    """1 where the determinant has one sign in both, −1 where it changes, None where frames turn too far to be compared,
    a rank drops, or a determinant is 0 within rounding.
    """
    if not (has_sign(a) and has_sign(b)) or a.determinant is None or b.determinant is None:
        return None
    sign = np.sign(a.determinant * b.determinant)
    for one, other in zip(a.systems, b.systems, strict=True):
        if one.shape != other.shape:
            return None
        overlap = one @ other.T
        if len(overlap) and np.linalg.svd(overlap, compute_uv=False)[-1] < _OVERLAP:
            return None
        sign *= np.sign(np.linalg.det(overlap)) if len(overlap) else 1
    return int(sign) or None
