r"""All common zeros of linear conditions on motions: 40 paths from a system that is solved, and where they end."""

from __future__ import annotations

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.certificates import Boxes, boxes
from gcrules.poses.modes.conditions import FORMS, Complexes, quadrics
from gcrules.poses.modes.start import start
from gcrules.poses.modes.tracking import Accuracy, PathEnds, follow, jacobians

__all__ = ["NEEDED", "Zeros", "rank_of", "zeros_of"]

NEEDED = 6
"""How many independent linear conditions leave isolated motions."""

_TRIALS = (Accuracy(), Accuracy(2e-5, 1e-9, 1e-6), Accuracy(5e-6, 1e-9, 1e-7), Accuracy(2e-5, 1e-8, 1e-6))
_MIXED = 40  # the start's forms, in every run in the same way, so that answers are the same
_DEPENDENT = 1e-10  # of forms of length 1
_SINGULAR = 1e-9  # least singular value of the derivatives in parts of the largest, below which an end is singular
_AT_INFINITY = 1e-7  # |h| of Study parameters of length 1
_SHRINKS, _PLUNGES = 0.05, 4.5  # exponents of |h|: a path that only passes near h = 0 has larger ones
_SMALL = 1e-6  # t at which an end is singular, of paths that go on no more
_LOW = 0.02  # |h| where it shrinks, at last
_SAME = 1e-7
_SATISFIED = 1e-8


@dataclass(frozen=True, eq=False)
class Zeros:
    """The zeros found. `boxes` are around the regular ones that satisfy all conditions, real or not; `singular` (k, 8)
    are ends where the derivatives are, one for each path. Of the paths so many ended `at_infinity`, `beside` at zeros
    of the six chosen conditions that violate another one; `lost` ones ended nowhere that is known.
    """

    boxes: Boxes
    singular: Complexes
    at_infinity: int
    beside: int
    lost: int
    steps: int

    @property
    def paths(self) -> int:
        return len(self.boxes.y) + len(self.singular) + self.at_infinity + self.beside + self.lost


def rank_of(forms: Floats) -> int:
    """How many of the forms (N, 17), scaled to length 1, are independent."""
    if not len(forms):
        return 0
    s = np.linalg.svd(forms / np.linalg.norm(forms, axis=1, keepdims=True), compute_uv=False)
    return int((s > _DEPENDENT).sum())


def zeros_of(forms: Floats, sizes: Floats) -> Zeros:
    """The common zeros of N ≥ 6 independent real forms (N, 17), which are known up to rounding of terms of these sizes
    (N, 17). Of more than six, six mixtures are solved, and what violates the others is left out.
    """
    length = np.linalg.norm(forms, axis=1, keepdims=True)
    forms, sizes = forms / length, sizes / length
    rng = np.random.default_rng(_MIXED)
    six, known = forms, sizes
    if len(forms) > NEEDED:
        mixture = np.linalg.qr(rng.normal(size=(len(forms), NEEDED)))[0].T
        six, known = mixture @ forms, np.abs(mixture) @ sizes
    best: tuple[int, PathEnds, Floats] | None = None
    for accuracy in _TRIALS:
        ends = _tracked(six, rng, accuracy)
        kinds = _kinds(quadrics(six), ends)
        lost = int((kinds == _LOST).sum())
        if best is None or lost < best[0]:
            best = lost, ends, kinds
        if not lost:
            break
    assert best is not None
    lost, ends, kinds = best
    regular = ends.x[kinds == _REGULAR]
    fits = _fits(forms, regular)
    found = boxes(quadrics(six).real, _known(known), regular[fits])
    finite = found.finite
    if not finite.all():
        found = boxes(quadrics(six).real, _known(known), regular[fits][finite])
    return Zeros(
        found,
        ends.x[kinds == _ENDS_SINGULAR],
        int((kinds == _INFINITE).sum() + (~finite).sum()),
        int((~fits).sum()),
        lost,
        ends.steps,
    )


_REGULAR, _ENDS_SINGULAR, _INFINITE, _LOST = range(4)
_ROUNDING = 32 * float(np.finfo(float).eps)


def _known(sizes: Floats) -> Floats:
    """To what the coefficients of the quadrics (7, 8, 8) are known."""
    own = _ROUNDING * np.tensordot(sizes, np.abs(FORMS), axes=1)
    return np.concatenate([own, np.zeros((1, 8, 8))])


def _fits(forms: Floats, x: Complexes) -> np.ndarray[tuple[int], np.dtype[np.bool_]]:
    values = np.einsum("nij,ki,kj->kn", FORMS, x, x) @ forms.T
    return np.asarray((np.abs(values) <= _SATISFIED).all(axis=1))


def _tracked(six: Floats, rng: np.random.Generator, accuracy: Accuracy) -> PathEnds:
    forms, known = start()
    mixed = np.linalg.qr(rng.normal(size=(NEEDED, NEEDED)) + 1j * rng.normal(size=(NEEDED, NEEDED)))[0] @ forms
    basis = np.linalg.qr(six.T)[0].T
    return follow(quadrics(mixed), quadrics(basis), known.copy(), accuracy)


def _kinds(system: Complexes, ends: PathEnds) -> Floats:
    """What each path ended at. Two that end at one regular zero are both lost: a path went over to another one."""
    x = ends.x
    height = np.abs((x[:, :4] ** 2).sum(axis=1))
    sizes = np.linalg.svd(jacobians(system, x, x.conj()), compute_uv=False)
    singular = sizes[:, -1] <= _SINGULAR * sizes[:, 0]
    ended = ends.t == 0
    kinds = np.full(len(x), float(_LOST))
    shrinks = (ends.exponents > _SHRINKS) & (ends.exponents < _PLUNGES)
    away = np.where(ended, singular & (height <= _AT_INFINITY), shrinks & (height < _LOW))
    kinds[away] = _INFINITE
    stays = np.where(ended, singular, (np.abs(ends.exponents) <= _SHRINKS) & (ends.t < _SMALL)) & ~away
    kinds[stays] = _ENDS_SINGULAR
    kinds[ended & ~singular & ~away] = _REGULAR
    regular = np.flatnonzero(kinds == _REGULAR)
    near = np.abs(x[regular].conj() @ x[regular].T) > 1 - _SAME
    kinds[regular[near.sum(axis=1) > 1]] = _LOST
    return kinds
