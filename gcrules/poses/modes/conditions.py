r"""What limbs ask of the platform's pose, as linear forms in the seventeen coordinates of the group of motions.

A motion p ↦ R p + t has Study parameters (a; b): a quaternion a with R, and b = t a / 2, so that a·b = 0. The products

    h = |a|²,   h R (nine),   h t (three),   h Rᵀ t (three),   h |t|² = 4 |b|²

are quadratic in (a; b) and embed the group into projective space of dimension 16. What a leg of length l from A to B
asks, |R B + t − A|² = l², is a linear form in them, and so is that a point of one body stays in a plane of the other,
that directions keep their angle, that a point stays where it is. The closure of the group has dimension 6 and degree
40, so six linear forms have 40 common zeros, or fewer that are isolated; those with h = 0 are no motions, they lie "at
infinity". Source: the degree and the start system are computed here (`tools/modes_start.py`), and checked by the test
of the trace; the forms are derived here.

`forms_of_limb` finds all linear forms that vanish on the motions that a chain of joints can make: at many random
amounts of its joints these are vectors whose common kernel is read off their singular values.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gcrules.mechanisms.kinematics.chains import Chain
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.screws.study import quaternion_product

__all__ = [
    "COORDINATES",
    "FORMS",
    "STUDY",
    "about_centre",
    "forms_of_limb",
    "forms_of_pairs",
    "image",
    "motions",
    "quadrics",
]

Complexes = NDArray[np.complex128]

COORDINATES = 17
_SAMPLES = 60  # of the motions of a limb, more than there are coordinates
_NONE = 1e-10  # singular values below it, in parts of the largest, are 0: amounts are random, so gaps are wide


_UNITS = np.eye(4).tolist()
_T = np.array([[quaternion_product(a, b) for b in _UNITS] for a in _UNITS]).transpose(2, 0, 1)
"""_T[k, i, j]: the part of e_k in the product e_i e_j of quaternions."""
_CONJUGATE = np.diag([1.0, -1.0, -1.0, -1.0])


def _forms() -> Floats:
    """The symmetric matrices (17, 8, 8) of the coordinates h, h R, h t, h Rᵀ t, h |t|² as quadratic forms in (a; b)."""
    found = np.zeros((COORDINATES, 8, 8))
    found[0, :4, :4] = np.eye(4)
    for i in range(3):
        for j in range(3):  # part i of a e_j a*
            turned = np.einsum("ml,ms,lt->st", _T[i + 1], _T[:, :, j + 1], _CONJUGATE)
            found[1 + 3 * i + j, :4, :4] = (turned + turned.T) / 2
        shift = 2 * _T[i + 1] @ _CONJUGATE  # of b and a, part i of 2 b a*
        found[10 + i, 4:, :4], found[10 + i, :4, 4:] = shift / 2, shift.T / 2
        back = 2 * _CONJUGATE.T @ _T[i + 1]  # of a and b, part i of 2 a* b
        found[13 + i, :4, 4:], found[13 + i, 4:, :4] = back / 2, back.T / 2
    found[16, 4:, 4:] = 4 * np.eye(4)
    return found


FORMS = _forms()
STUDY = np.zeros((8, 8))
"""The matrix of the quadric a·b = 0."""
STUDY[:4, 4:] = STUDY[4:, :4] = np.eye(4) / 2


def quadrics(forms: NDArray[np.generic]) -> Complexes:
    """Six linear forms (6, 17) as quadratic ones (7, 8, 8) in (a; b), Study's quadric the last."""
    own = np.tensordot(forms.astype(complex), FORMS, axes=1)
    return np.concatenate([own, STUDY[None].astype(complex)])


def image(motions: Floats) -> Floats:
    """The coordinates (..., 17) of motions (..., 4, 4), h = 1."""
    r, t = motions[..., :3, :3], motions[..., :3, 3]
    back = (np.swapaxes(r, -1, -2) @ t[..., None])[..., 0]
    ones, squares = np.ones((*t.shape[:-1], 1)), (t * t).sum(axis=-1, keepdims=True)
    return np.concatenate([ones, r.reshape(*r.shape[:-2], 9), t, back, squares], axis=-1)


def motions(x: Floats) -> Floats:
    """The motions (N, 4, 4) of real Study parameters (N, 8), any length of them."""
    every = np.einsum("nij,ki,kj->kn", FORMS, x, x)
    every = every / every[:, :1]
    found = np.zeros((len(x), 4, 4))
    found[:, :3, :3] = every[:, 1:10].reshape(-1, 3, 3)
    found[:, :3, 3] = every[:, 10:13]
    found[:, 3, 3] = 1.0
    return found


def forms_of_pairs(base: Floats, arms: Floats, lengths: Floats) -> tuple[Floats, Floats]:
    """The forms (N, 17) of legs from A (N, 3) to B (N, 3) with lengths (N,); and the sizes (N, 17) of the terms that
    their coefficients are sums of, to which they are known but for rounding.
    """
    found = np.zeros((len(base), COORDINATES))
    squares = (base * base).sum(axis=1), (arms * arms).sum(axis=1), lengths * lengths
    found[:, 0] = squares[0] + squares[1] - squares[2]
    found[:, 1:10] = -2 * np.einsum("ki,kj->kij", base, arms).reshape(-1, 9)
    found[:, 10:13], found[:, 13:16], found[:, 16] = -2 * base, 2 * arms, 1.0
    sizes = np.abs(found)
    sizes[:, 0] = sum(squares)
    return found, sizes


def forms_of_limb(chain: Chain, amounts: Floats, free: Sequence[int], about: Floats, size: float) -> Floats:
    """All linear forms (k, 17), of length 1 and orthogonal, that vanish on the motions of a chain whose coordinates
    have these amounts but for the `free` ones, which take any. Motions count from where the chain is, shifts are those
    of the centre `about` in parts of `size`.
    """
    rng = np.random.default_rng(17)
    every = np.tile(amounts, (_SAMPLES, 1))
    scale = np.where(np.array(chain.turns)[list(free)], np.pi, 2 * size)
    every[:, list(free)] += rng.uniform(-1, 1, (_SAMPLES, len(free))) * scale
    ends = about_centre(chain.links(every)[:, -1], about, size)
    _, s, v = np.linalg.svd(image(ends))
    return np.asarray(v[int((s > _NONE * s[0]).sum()) :])


def about_centre(ends: Floats, about: Floats, size: float) -> Floats:
    """Motions (..., 4, 4) with the shift of a centre in place of that of the origin, lengths in parts of `size`."""
    found = ends.copy()
    found[..., :3, 3] = (ends[..., :3, :3] @ about + ends[..., :3, 3] - about) / size
    return found
