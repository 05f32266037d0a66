r"""What paths end at where solutions are not regular: multiple solutions, and curves of solutions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.conditions import Complexes
from gcrules.poses.modes.curves import curve_through, project, sharpened

__all__ = ["Curve", "MultipleSolution", "curves_of", "grouped"]

_TOGETHER = 1e-5  # of 1 − |cos|: singular ends are known to about the root of the last t
_REAL = 1e-3
_SEARCHES = 40


@dataclass(frozen=True, eq=False)
class MultipleSolution:
    """A real solution x (8,) at which several `paths` end."""

    x: Floats
    paths: int


@dataclass(frozen=True, eq=False)
class Curve:
    """Points x (N, 8) of a curve, one after the other."""

    x: Floats
    closed: bool

    def near(self, x: Floats) -> bool:
        """Whether a point is no farther from one of them than they are from each other."""
        apart = np.linalg.norm(np.diff(self.x, axis=0), axis=1).max()
        away = min(np.linalg.norm(self.x - x, axis=1).min(), np.linalg.norm(self.x + x, axis=1).min())
        return bool(away <= apart)


def grouped(forms: Floats, ends: Complexes) -> tuple[list[MultipleSolution], list[Curve]]:
    """Singular ends (N, 8) of paths: real multiple solutions, and the curves that such lie on. Ends that are not real
    and near no real solution are in none of them.
    """
    several: list[MultipleSolution] = []
    curves: list[Curve] = []
    for x, paths in _clusters(ends):
        largest = x[int(np.argmax(np.abs(x)))]
        turned = x * (np.abs(largest) / largest)
        if np.abs(turned.imag).max() > _REAL:
            continue
        at = project(forms, turned.real)
        if at is None or any(c.near(at) for c in curves):
            continue
        curve = curve_through(forms, at)
        if curve is None:
            several.append(MultipleSolution(sharpened(forms, at), paths))
        else:
            curves.append(Curve(*curve))
    return several, curves


def _clusters(ends: Complexes) -> list[tuple[Complexes, int]]:
    left = list(range(len(ends)))
    found = []
    while left:
        near = [k for k in left if abs(np.vdot(ends[left[0]], ends[k])) > 1 - _TOGETHER]
        found.append((ends[near[0]], len(near)))
        left = [k for k in left if k not in near]
    return found


def curves_of(forms: Floats, given: Floats | None) -> list[Curve]:
    """Curves of real solutions of forms that depend on each other: the one through a `given` solution (8,), and those
    that a search from random motions meets.
    """
    rng = np.random.default_rng(40)
    found: list[Curve] = []
    starts = [given] if given is not None else []
    starts += list(rng.normal(size=(_SEARCHES, 8)))
    for start in starts:
        checkpoint()
        at = project(forms, start)
        if at is None or any(c.near(at) for c in found):
            continue
        curve = curve_through(forms, at)
        if curve is not None:
            found.append(Curve(*curve))
    return found
