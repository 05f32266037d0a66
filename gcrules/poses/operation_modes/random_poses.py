"""Random poses of a stratum modulo the prime, on which equations, kinds of motion and inclusions are seen."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

from gcrules.core.errors import LimitReached
from gcrules.core.linear_algebra import echelon, rank
from gcrules.core.seeds import DRAWN, PRIME
from gcrules.poses.operation_modes.limb_constraints import residue
from gcrules.poses.operation_modes.orientations import Form, fraction
from gcrules.poses.operation_modes.strata import PoseBundle, Stratum

__all__ = ["at_residues", "holds", "random_pose", "solved"]

_ATTEMPTS = 200


def at_residues(f: Form, x: Sequence[int]) -> int:
    """A form at residues."""
    total = 0
    for m, c in f.terms():
        term = residue(fraction(c))
        for base, n in zip(x, m, strict=True):
            term = term * pow(base, n, PRIME) % PRIME
        total += term
    return total % PRIME


def random_pose(one: Stratum, random: Random) -> tuple[int, ...]:
    """A random pose of a stratum. Raises LimitReached where its orientations are given by several forms that are not
    linear.
    """
    for _ in range(_ATTEMPTS):
        x = _orientation(one, random)
        if x is None or any(not at_residues(f, x) for f in one.nonzero):
            continue
        y = solved([[at_residues(f, x) for f in row] for row in one.rows], PRIME, random)
        if y is not None:
            return (*x, *y)
    raise LimitReached(f"no random poses of the orientations {one.orientations.text} were found")


def _orientation(one: Stratum, random: Random) -> tuple[int, ...] | None:
    basis = [[residue(c) for c in v] for v in one.orientations.subspace()]

    def drawn() -> list[int]:
        amounts = [random.randrange(DRAWN) for _ in basis]
        return [sum(a * v[n] for a, v in zip(amounts, basis, strict=True)) % PRIME for n in range(4)]

    curved = [f for f in one.orientations.basis if sum(f.LM) > 1]
    x = drawn()
    if not curved:
        return tuple(x)
    if len(curved) > 1:
        raise LimitReached(f"the orientations {one.orientations.text} are not decomposed further")
    step = drawn()
    t = _root(_on_line(curved[0], x, step))
    return None if t is None else tuple((a + t * b) % PRIME for a, b in zip(x, step, strict=True))


def _on_line(f: Form, x: Sequence[int], step: Sequence[int]) -> list[int]:
    """The coefficients, the highest first, of the polynomial that a form is on a line."""
    degree = sum(f.LM)
    rows = []
    for t in range(degree + 1):
        at = [(a + t * b) % PRIME for a, b in zip(x, step, strict=True)]
        rows.append([*(pow(t, degree - k, PRIME) for k in range(degree + 1)), at_residues(f, at)])
    return [row[-1] for row in echelon(rows, PRIME)[0]]


def _root(coefficients: list[int]) -> int | None:
    from sympy import ZZ
    from sympy.polys.galoistools import gf_factor, gf_strip

    if len(gf_strip(list(coefficients))) < 2:
        return None
    factors = gf_factor([ZZ(c) for c in gf_strip(list(coefficients))], ZZ(PRIME), ZZ)[1]
    return next((int(-g[1] % PRIME) for g, _ in factors if len(g) == 2), None)


def solved(
    rows: Sequence[Sequence[Any]], modulus: int | None = None, random: Random | None = None
) -> tuple[Any, ...] | None:
    """y0 … y3 that solve rows (a0, …, a3, c), what is free being random, or 0 without `random`; None where there are
    none.
    """
    found, pivots = echelon(rows, modulus)
    if 4 in pivots:
        return None
    y = [0 if n in pivots or random is None else random.randrange(DRAWN) for n in range(4)]
    for row, column in zip(found, pivots, strict=True):
        y[column] = -row[4] - sum(row[n] * y[n] for n in range(4) if n not in pivots)
    return tuple(c if modulus is None else c % modulus for c in y)


def holds(one: PoseBundle, pose: Sequence[int]) -> bool:
    """Whether a pose in residues is seen to be in the closure of a stratum, as by `rational_poses.inside`."""
    x, y = pose[:4], (*pose[4:], 1)
    if any(at_residues(f, x) for f in one.stratum.orientations.basis):
        return False
    rows = [[at_residues(f, x) for f in row] for row in one.rows]
    if any(sum(a * b for a, b in zip(row, y, strict=True)) % PRIME for row in rows):
        return False
    return rank([row[:4] for row in rows], PRIME) == len(one.stratum.rows)
