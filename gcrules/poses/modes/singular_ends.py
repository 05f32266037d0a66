r"""What paths end at where solutions are not regular: multiple solutions, and curves of solutions."""

from __future__ import annotations

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.conditions import Complexes
from gcrules.poses.modes.curves import curve_through, project, sharpened

__all__ = ["MultipleSolution", "SelfMotion", "curves_of", "grouped"]

_TOGETHER = 1e-5  # of 1 − |cos|: singular ends are known to about the root of the last t
_REAL, _PERHAPS = 1e-3, 0.03  # imaginary parts of ends that are real, and of those that are looked at: threefold ones
_FARTHER = 5  # a real solution may be so much farther from the real part of an end than its imaginary part is large
_SAME = 1e-9  # of 1 − |cos|
_SEARCHES = 40


@dataclass(frozen=True, eq=False)
class MultipleSolution:
    """A real solution x (8,) at which several `paths` end."""

    x: Floats
    paths: int


@dataclass(frozen=True, eq=False)
class SelfMotion:
    """Points x (N, 8) of a curve, one after the other."""

    x: Floats
    closed: bool

    def near(self, x: Floats) -> bool:
        """Whether a point, of any length, is no farther from one of them than they are from each other."""
        x = x / np.linalg.norm(x)
        apart = np.linalg.norm(np.diff(self.x, axis=0), axis=1).max()
        away = min(np.linalg.norm(self.x - x, axis=1).min(), np.linalg.norm(self.x + x, axis=1).min())
        return bool(away <= apart)


def grouped(forms: Floats, ends: Complexes) -> tuple[list[MultipleSolution], list[SelfMotion], int]:
    """Singular ends (N, 8) of paths: real multiple solutions, the curves that such lie on, and how many ends look real
    and are near no solution that could be found. Ends that are not real are in none of them.
    """
    several: list[MultipleSolution] = []
    curves: list[SelfMotion] = []
    unclear = 0
    for x, paths in _clusters(ends):
        largest = x[int(np.argmax(np.abs(x)))]
        turned = x * (np.abs(largest) / largest)
        off = float(np.abs(turned.imag).max())
        if off > _PERHAPS:
            continue
        at = project(forms, turned.real)
        if at is None or np.linalg.norm(at - turned.real) > _FARTHER * off + _REAL:
            unclear += paths * (off <= _REAL)
            continue
        if any(c.near(at) for c in curves):
            continue
        curve = curve_through(forms, at)
        if curve is not None:
            curves.append(SelfMotion(*curve))
            continue
        at = sharpened(forms, at)
        same = next((k for k, one in enumerate(several) if abs(one.x @ at) > 1 - _SAME), None)
        if same is None:
            several.append(MultipleSolution(at, paths))
        else:
            several[same] = MultipleSolution(several[same].x, several[same].paths + paths)
    return several, curves, unclear


def _clusters(ends: Complexes) -> list[tuple[Complexes, int]]:
    left = list(range(len(ends)))
    found = []
    while left:
        near = [k for k in left if abs(np.vdot(ends[left[0]], ends[k])) > 1 - _TOGETHER]
        found.append((ends[near[0]], len(near)))
        left = [k for k in left if k not in near]
    return found


def curves_of(forms: Floats, given: Floats | None) -> list[SelfMotion]:
    """Curves of real solutions of forms that depend on each other: the one through a `given` solution (8,), and those
    that a search from random motions meets.
    """
    rng = np.random.default_rng(40)
    found: list[SelfMotion] = []
    starts = [given] if given is not None else []
    starts += list(rng.normal(size=(_SEARCHES, 8)))
    for start in starts:
        checkpoint()
        at = project(forms, start)
        if at is None or any(c.near(at) for c in found):
            continue
        curve = curve_through(forms, at)
        if curve is not None:
            found.append(SelfMotion(*curve))
    return found
