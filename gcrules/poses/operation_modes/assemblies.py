"""Random assemblies of a robot's limbs, closed numerically: a road to its modes by the screws of its joints in floats,
which shares nothing with the equations of the limbs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.linkage import Linkage
from gcrules.mechanisms.kinematics.rigid_motions import Floats, cross_matrix
from gcrules.poses.operation_modes.orientations import Form
from gcrules.poses.operation_modes.strata import PoseBundle
from gcrules.screws.study import study

__all__ = ["STARTS", "Membership", "random_assemblies"]

STARTS = 48
"""So many random starts are tried."""

_STEPS = 60
_CLOSED = 1e-11
_DAMPED = 0.3
_DEPENDENT = 1e-6
_SPREADS = (0.02, 0.3, 0.6, 1.0)  # parts of a turn, and of the robot's size, within which starts are drawn


def random_assemblies(m: Linkage, seed: int = 0) -> Iterator[tuple[float, ...]]:
    """Poses of the platform that all limbs reach, in Study parameters with x of length 1; as many as starts
    close. Starts are drawn the same in every run.
    """
    random = np.random.default_rng(seed)
    locked = {(place, own) for place, own, _ in m.locked}
    for start in range(STARTS):
        checkpoint()
        spread = _SPREADS[start % len(_SPREADS)]
        amounts = [
            np.array(
                [
                    0.0
                    if (place, n) in locked
                    else random.uniform(-np.pi, np.pi) * spread * (1 if turns else m.size / 2)
                    for n, turns in enumerate(c.turns)
                ]
            )
            for place, c in enumerate(m.home.chains)
        ]
        closed = _close(m, amounts, locked)
        if closed is not None:
            yield tuple(study(_from_the_origin(closed, np.array(m.origin, dtype=float))).tolist())


def _close(m: Linkage, amounts: list[Floats], locked: set[tuple[int, int]]) -> Floats | None:
    """Levenberg and Marquardt's method: all limbs take the platform to the place to which the first does. It is damped
    in step with the gap, for beside a mode whose closure conditions depend on each other they hardly do not.
    """
    chains = m.home.chains
    ends = np.cumsum([0, *(len(a) for a in amounts)])
    free = [
        k
        for place, a in enumerate(amounts)
        for k in range(ends[place], ends[place + 1])
        if (place, k - ends[place]) not in locked
    ]
    for _ in range(_STEPS):
        places, slopes = zip(*(_moved(c, a) for c, a in zip(chains, amounts, strict=True)), strict=True)
        gaps, rows = [], []
        for n in range(1, len(chains)):
            gap = places[n] - places[0]
            gap[:3, 3] /= m.size
            gaps.append(gap[:3].ravel())
            row = np.zeros((12, ends[-1]))
            row[:, ends[n] : ends[n + 1]] = _scaled(slopes[n], m.size)
            row[:, : ends[1]] = -_scaled(slopes[0], m.size)
            rows.append(row)
        gap = np.concatenate(gaps) if gaps else np.zeros(1)
        if np.abs(gap).max() < _CLOSED:
            return np.asarray(places[0])
        step = np.zeros(ends[-1])
        slopes_of_free = np.concatenate(
            [np.concatenate(rows)[:, free], _DAMPED * np.abs(gap).max() * np.eye(len(free))]
        )
        step[free] = np.linalg.lstsq(slopes_of_free, np.concatenate([-gap, np.zeros(len(free))]), rcond=None)[0]
        step *= min(1.0, 1.0 / max(1e-300, float(np.abs(step).max()) / max(1.0, m.size)))
        amounts = [a + step[ends[n] : ends[n + 1]] for n, a in enumerate(amounts)]
    return None


def _moved(chain: Chain, amounts: Floats) -> tuple[Floats, Floats]:
    """The platform's place and its derivatives by the amounts, (n, 4, 4)."""
    links = chain.links(amounts)
    twists = chain.twists(links).T
    rates = np.zeros((len(twists), 4, 4))
    rates[:, :3, :3] = cross_matrix(twists[:, :3])
    rates[:, :3, 3] = twists[:, 3:]
    return links[-1], rates @ links[-1]


def _scaled(slopes: Floats, size: float) -> Floats:
    found = slopes[:, :3].copy()
    found[:, :, 3] /= size
    return np.asarray(found.reshape(len(slopes), 12).T)


def _from_the_origin(place: Floats, origin: Floats) -> Floats:
    """The motion of a place whose coordinates count from an origin, in those of the file."""
    found = place.copy()
    found[:3, 3] += origin - place[:3, :3] @ origin
    return found


class Membership:
    """Whether poses in floats are in the closure of a stratum, as `rational_poses.inside` decides for exact ones."""

    def __init__(self, one: PoseBundle) -> None:
        self._rank = len(one.stratum.rows)
        self._forms = [_terms([f])[0] for f in one.stratum.orientations.basis]
        self._rows = [_terms(row) for row in one.rows]

    def __call__(self, pose: Sequence[float], accuracy: float) -> bool | None:
        """True, False, or None where the equations of the stratum hold but depend on each other."""
        x, y = np.array(pose[:4]), np.array([*pose[4:], 1.0])
        if any(abs(_value(f, x)) > accuracy for f in self._forms):
            return False
        rows = np.array([[_value(f, x) for f in row] for row in self._rows])
        if np.abs(rows @ y).max(initial=0.0) > accuracy * max(1.0, float(np.abs(y).max())):
            return False
        sizes = np.linalg.svd(rows[:, :4], compute_uv=False)
        return True if (sizes > _DEPENDENT).sum() >= self._rank else None


_Terms = tuple[NDArray[np.intp], Floats]
"""Exponents and coefficients of a form."""


def _terms(forms: Sequence[Form]) -> list[_Terms]:
    """Forms in floats, divided by the largest of their coefficients."""
    every = [[(m, float(c)) for m, c in f.terms()] or [((0, 0, 0, 0), 0.0)] for f in forms]
    largest = max(abs(c) for terms in every for _, c in terms)
    return [(np.array([m for m, _ in terms]), np.array([c / largest for _, c in terms])) for terms in every]


def _value(terms: _Terms, x: Floats) -> float:
    powers, coefficients = terms
    return float(coefficients @ np.prod(x**powers, axis=-1))
