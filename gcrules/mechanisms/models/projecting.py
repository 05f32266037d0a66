"""Places and directions moved as little as possible, so that relations between them hold exactly: by Gauss and Newton's
steps, damped, from where they nearly hold.

Lengths are parts of the model's size. Each relation is a few equations between places p, q and directions a, b:

    dot       (q − p) · a = 0                   parallel vectors   (q₁ − p₁) − (q₂ − p₂) = 0
    cross     (q − p) × a = 0                   across an axis     ((q₁ − p₁) − (q₂ − p₂)) × a = 0
    coplanar  (q − p) · (a × b) = 0             lengths            |q₁ − p₁| = |q₂ − p₂|
    right     a · b = 0                         across axes        |(q₁ − p₁) × a| = |(q₂ − p₂) × b|
    images    q = M p + t, (q − M p − t) × a = 0, a = ± M b
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats

__all__ = ["Relation", "Shape", "projected"]

_STEPS = 30
_DONE = 1e-13
_EXACT = 1e-11
_DAMPING = 1e-8  # of what hardly changes a relation no use is made


@dataclass(frozen=True, eq=False)
class Shape:
    """Places (n, 3), in parts of the size, and directions (m, 3) of length 1, of which the first three, those of the
    frame, stay.
    """

    places: Floats
    directions: Floats

    def moved(self, step: Floats) -> Shape:
        own = step.reshape(-1, 3)
        n = len(self.places)
        return Shape(self.places + own[:n], self.directions + own[n:])


@dataclass(frozen=True, eq=False)
class Relation:
    """Of one of the kinds above, between places and directions by their numbers; `motion` is M and t of images, and the
    sign."""

    kind: str
    places: tuple[int, ...]
    directions: tuple[int, ...] = ()
    motion: tuple[Floats, Floats, float] | None = None

    def residual(self, at: Shape) -> Floats:
        """How far it is from holding: one number or three."""
        return _RESIDUALS[self.kind](self, at)[0]

    def off(self, at: Shape) -> float:
        return float(np.linalg.norm(self.residual(at)))

    def rows(self, at: Shape) -> tuple[Floats, list[tuple[bool, int, Floats]]]:
        """Its residual, and how that changes (k, 3) with a direction (True) or place (False) of a number."""
        return _RESIDUALS[self.kind](self, at)


_Rates = list[tuple[bool, int, Floats]]


def _skew(v: Floats) -> Floats:
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _between(r: Relation, at: Shape) -> Floats:
    found: Floats = at.places[r.places[1]] - at.places[r.places[0]]
    return found


def _dot(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    (p, q), (a,) = r.places, r.directions
    v, axis = _between(r, at), at.directions[a]
    return np.array([v @ axis]), [(False, q, axis[None]), (False, p, -axis[None]), (True, a, v[None])]


def _cross(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    (p, q), (a,) = r.places, r.directions
    v, axis = _between(r, at), at.directions[a]
    turn = _skew(axis)
    return np.cross(v, axis), [(False, q, -turn), (False, p, turn), (True, a, _skew(v))]


def _coplanar(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    (p, q), (a, b) = r.places, r.directions
    v, one, two = _between(r, at), at.directions[a], at.directions[b]
    normal = np.cross(one, two)
    rates = [(False, q, normal[None]), (False, p, -normal[None])]
    return np.array([v @ normal]), [*rates, (True, a, np.cross(two, v)[None]), (True, b, np.cross(v, one)[None])]


def _right(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    a, b = r.directions
    one, two = at.directions[a], at.directions[b]
    return np.array([one @ two]), [(True, a, two[None]), (True, b, one[None])]


def _unit(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    (a,) = r.directions
    axis = at.directions[a]
    return np.array([(axis @ axis - 1) / 2]), [(True, a, axis[None])]


def _vectors(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    """Two vectors are equal, or are so across an axis."""
    p, q, s, t = r.places
    apart = at.places[q] - at.places[p] - at.places[t] + at.places[s]
    signs = ((q, 1.0), (p, -1.0), (t, -1.0), (s, 1.0))
    if not r.directions:
        return apart, [(False, k, sign * np.eye(3)) for k, sign in signs]
    turn = _skew(at.directions[r.directions[0]])
    rates: _Rates = [(False, k, -sign * turn) for k, sign in signs]
    return -turn @ apart, [*rates, (True, r.directions[0], _skew(apart))]


def _lengths(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    """Two distances are equal, of places or of a place from an axis through the other one."""
    found, signs = 0.0, (1.0, -1.0)
    rates: _Rates = []
    for sign, (p, q), a in zip(signs, (r.places[:2], r.places[2:]), r.directions or (-1, -1), strict=True):
        v = at.places[q] - at.places[p]
        across = v if a < 0 else np.cross(v, at.directions[a])
        size = float(np.linalg.norm(across))
        unit = sign * across / size
        found += sign * size
        along = unit if a < 0 else np.cross(at.directions[a], unit)
        rates += [(False, q, along[None]), (False, p, -along[None])]
        if a >= 0:
            rates.append((True, a, np.cross(unit, v)[None]))
    return np.array([found]), rates


def _image(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    """A place is the image of another one, or lies on an axis through it."""
    assert r.motion is not None
    turn, shift, _ = r.motion
    p, q = r.places
    apart = at.places[q] - turn @ at.places[p] - shift
    if not r.directions:
        return apart, [(False, q, np.eye(3)), (False, p, -turn)]
    own = _skew(at.directions[r.directions[0]])
    return -own @ apart, [(False, q, -own), (False, p, own @ turn), (True, r.directions[0], _skew(apart))]


def _turned(r: Relation, at: Shape) -> tuple[Floats, _Rates]:
    """A direction is the image of another one, but for its sense."""
    assert r.motion is not None
    turn, _, sign = r.motion
    a, b = r.directions
    return at.directions[a] - sign * turn @ at.directions[b], [(True, a, np.eye(3)), (True, b, -sign * turn)]


_RESIDUALS = {
    "dot": _dot,
    "cross": _cross,
    "coplanar": _coplanar,
    "right": _right,
    "unit": _unit,
    "vectors": _vectors,
    "lengths": _lengths,
    "image": _image,
    "turned": _turned,
}


def projected(start: Shape, relations: Sequence[Relation], most: float) -> Shape | None:
    """A shape near by of which all relations hold, no place or direction being moved by more than `most`; None where
    there is none, or none was found.
    """
    units = [Relation("unit", (), (k,)) for k in range(3, len(start.directions))]
    every = [*relations, *units]
    at = start
    for _ in range(_STEPS):
        checkpoint()
        residual, rates = _system(every, at)
        if float(np.abs(residual).max(initial=0.0)) < _DONE:
            break
        normal = rates.T @ rates
        normal[np.diag_indices_from(normal)] += _DAMPING
        at = at.moved(np.asarray(np.linalg.solve(normal, -rates.T @ residual), dtype=np.float64))
        if _farthest(start, at) > most:
            return None
    else:
        if max((r.off(at) for r in every), default=0.0) > _EXACT:
            return None
    return at


def _farthest(one: Shape, other: Shape) -> float:
    steps = np.concatenate([one.places - other.places, one.directions - other.directions])
    return float(np.linalg.norm(steps, axis=1).max(initial=0.0))


def _system(relations: Sequence[Relation], at: Shape) -> tuple[Floats, Floats]:
    """All residuals, and how they change with all places and directions; those of the frame stay."""
    n = len(at.places)
    every = [r.rows(at) for r in relations]
    residual = np.concatenate([own for own, _ in every]) if every else np.zeros(0)
    found = np.zeros((len(residual), 3 * (n + len(at.directions))))
    row = 0
    for own, rates in every:
        for is_direction, k, block in rates:
            if not is_direction or k > 2:
                column = 3 * (k + n if is_direction else k)
                found[row : row + len(own), column : column + 3] += block
        row += len(own)
    return residual, found
