r"""The determinant of the wrenches of all limbs along a way, with frames that turn continuously, and its sign.

Each limb's wrenches with the actuators locked have a frame: first an orthonormal basis of its constraints, then of what
is left of its wrenches. Of a limb that has bodies of its own each chain between two of them has one, and the wrenches
act on all bodies: such a limb may lose wrenches on the platform, a chain does not. From one configuration to the next
the frames keep their orientation where the determinants of their overlaps are positive; then the sign of the
determinant of all wrenches means the same in both. In an over-constrained robot one basis of the constraints of all
limbs together stands for theirs. The determinant is 0 where the robot is singular, so a change of its sign is a
crossing, whether the robot has a condition or not. A robot with more actuators than freedoms has no such determinant.
Derived here.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import Linkage, Span
from gcrules.mechanisms.kinematics.margin import span_twists
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Frames", "frames", "relative_orientation", "relative_sign"]

_SPACE, _PLANE = (0, 1, 2, 3, 4, 5), (2, 3, 4)
"""Of twists (ω; v)."""

_RANK = 1e-9
_OVERLAP = 0.5  # the least cosine between frames that are compared
_ZERO = 1e-8  # of a determinant of unit wrenches: below it has no sign


@dataclass(frozen=True, eq=False)
class Frames:
    """Orthonormal rows (N, rank, columns): constraints and then what actuators add, of each limb or of all; and the
    determinant of all rows together, (N,), not a number where the ranks are not those of the family, or where there are
    more rows than six (in the plane three).
    """

    systems: tuple[Floats, ...]
    determinant: Floats

    @classmethod
    def together(cls, parts: Sequence[Frames]) -> Frames:
        """Frames of several stacks as one."""
        systems = tuple(np.concatenate(several) for several in zip(*(p.systems for p in parts), strict=True))
        return cls(systems, np.concatenate([p.determinant for p in parts]))

    def __getitem__(self, chosen: Any) -> Frames:
        """Those of an array of places, or a mask."""
        return Frames(tuple(s[chosen] for s in self.systems), self.determinant[chosen])

    def replaced(self, places: NDArray[np.intp], others: Frames) -> Frames:
        """With others at some places."""
        order = np.arange(len(self.determinant))
        order[places] = len(order) + np.arange(len(others.determinant))
        return Frames.together([self, others])[order]

    @property
    def whole(self) -> NDArray[np.bool_]:
        """Where there is a determinant: ranks are those of the family, and rows are as many as freedoms."""
        return np.asarray(~np.isnan(self.determinant))

    @property
    def signed(self) -> NDArray[np.bool_]:
        """Where the determinant is known and not 0 within rounding."""
        return np.asarray(np.abs(self.determinant) > _ZERO)

    @property
    def sign(self) -> NDArray[np.int8]:
        """That of the determinant, 0 where it has none."""
        return np.where(self.signed, np.sign(np.nan_to_num(self.determinant)), 0).astype(np.int8)


def frames(m: Linkage, here: Configurations, centre: Floats) -> Frames:
    """The frames of configurations, with moments about a fixed centre."""
    keep = list(_PLANE if m.robot.family.plane else _SPACE)
    constraints: list[Floats] = []
    added: list[Floats] = []
    whole = np.ones(len(here), dtype=bool)
    for span in m.spans:
        twists = span_twists(m, span, here, centre)[..., keep]
        own, sound = _reciprocal(twists, span.rank)
        locked, steady = _reciprocal(twists[:, [span.every.index(k) for k in span.free]], span.passive_rank)
        rest = locked - locked @ np.swapaxes(own, 1, 2) @ own
        constraints.append(_on_bodies(m, span, own))
        added.append(_on_bodies(m, span, _span(rest, locked.shape[1] - own.shape[1])))
        whole &= sound & steady
    bound = m.bodies * len(keep) - m.body_freedoms
    together = np.concatenate(constraints, axis=1)
    if together.shape[1] > bound:
        _, sizes, right = np.linalg.svd(together)
        constraints = [right[:, :bound]]
        whole &= (sizes > _RANK).sum(axis=1) == bound
    rows = np.concatenate([*constraints, *added], axis=1)
    square = rows.shape[1] == rows.shape[2]
    return Frames((*constraints, *added), np.where(whole, np.linalg.det(rows) if square else np.nan, np.nan))


def _on_bodies(m: Linkage, span: Span, rows: Floats) -> Floats:
    """Wrenches of a chain on the bodies at its ends, one after the other; unit ones as before."""
    width = rows.shape[2]
    found = np.zeros((*rows.shape[:2], m.bodies * width))
    for body, sign in span.signs:
        found[..., body * width : (body + 1) * width] = sign * rows / np.sqrt(len(span.signs))
    return found


def _reciprocal(twists: Floats, rank: int) -> tuple[Floats, NDArray[np.bool_]]:
    """Orthonormal bases of what is orthogonal to twists of this rank, and where they have it."""
    if not twists.shape[1]:
        everything = np.broadcast_to(np.eye(twists.shape[2]), (len(twists), twists.shape[2], twists.shape[2]))
        return everything, np.ones(len(twists), dtype=bool)
    _, sizes, right = np.linalg.svd(twists)
    sound = (sizes > _RANK * np.maximum(sizes[:, :1], 1.0)).sum(axis=1) == rank
    return np.asarray(right[:, rank:]), sound


def _span(rows: Floats, rank: int) -> Floats:
    return np.asarray(np.linalg.svd(rows)[2][:, :rank]) if rank else np.zeros((len(rows), 0, rows.shape[2]))


def relative_sign(a: Frames, b: Frames) -> NDArray[np.int8]:
    """For each pair of configurations 1 where the determinant has one sign in both, −1 where it changes, 0 where frames
    turn too far to be compared, a rank drops, or a determinant is 0 within rounding.
    """
    return a.sign * b.sign * relative_orientation(a, b)


def relative_orientation(a: Frames, b: Frames) -> NDArray[np.int8]:
    """For each pair of configurations 1 where the frames of all wrenches have one orientation, −1 where it is the other
    one, 0 where they turn too far to be compared or a rank drops. Determinants may be 0.
    """
    sign = np.where(a.whole & b.whole, 1.0, 0.0)
    for one, other in zip(a.systems, b.systems, strict=True):
        if not one.shape[1]:
            continue
        overlap = one @ np.swapaxes(other, 1, 2)
        close = np.linalg.svd(overlap, compute_uv=False)[:, -1] >= _OVERLAP
        sign = np.where(close, sign * np.sign(np.linalg.det(overlap)), 0.0)
    return sign.astype(np.int8)
