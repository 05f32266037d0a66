"""Singular values of small matrices, by rotations that make their columns orthogonal, a pair at a time (Jacobi)."""

import math

from .ndarray import float64, ndarray

_SWEEPS = 60
_EPSILON = 2.0**-52


def __getattr__(name):
    if name.startswith("__"):
        raise AttributeError(name)
    raise ModuleNotFoundError(
        f"numpy.linalg.{name} is not among what the engine in the guide's pages has", name="numpy"
    )


def svd(a, full_matrices=True, compute_uv=True):
    """The singular values of one matrix, the largest first."""
    if compute_uv or a.ndim != 2:
        raise ModuleNotFoundError("the engine in the guide's pages has singular values only", name="numpy")
    short = a if a.shape[0] < a.shape[1] else a.T
    columns = [list(map(float, row)) for row in short.tolist()]
    for _ in range(_SWEEPS):
        turned = [_rotate(columns, i, j) for j in range(len(columns)) for i in range(j)]
        if not any(turned):
            break
    sizes = sorted((math.hypot(*column) for column in columns), reverse=True)
    return ndarray(sizes, (len(sizes),), float64)


def _rotate(columns, i, j):
    """Turn two columns until they are orthogonal; whether they were not."""
    p, q = columns[i], columns[j]
    pp, qq, pq = (math.fsum(map(float.__mul__, x, y)) for x, y in ((p, p), (q, q), (p, q)))
    if abs(pq) <= _EPSILON * math.sqrt(pp * qq):
        return False
    zeta = (qq - pp) / (2 * pq)
    t = math.copysign(1, zeta) / (abs(zeta) + math.hypot(1, zeta))
    c = 1 / math.hypot(1, t)
    columns[i] = [c * (x - t * y) for x, y in zip(p, q, strict=True)]
    columns[j] = [c * (t * x + y) for x, y in zip(p, q, strict=True)]
    return True
