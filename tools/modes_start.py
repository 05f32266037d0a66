r"""Make gcrules/poses/modes/start.json: six generic linear conditions on motions, and all their 40 common zeros.

One zero is chosen, conditions are made that it satisfies, and loops in the space of conditions lead from zeros to
further ones (monodromy) until none is new. That there are no more is seen by the test of the trace: as one condition
moves in a pencil, the sum of all zeros, in coordinates of an affine chart, moves evenly; no part of them does that.

    python tools/modes_start.py            # write the file anew
    python tools/modes_start.py --check    # test the one that is there
"""

from __future__ import annotations

import argparse
import json
import sys
from itertools import pairwise

import numpy as np

from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.modes.conditions import COORDINATES, FORMS, Complexes, motions, quadrics
from gcrules.poses.modes.start import PATHS, START, start
from gcrules.poses.modes.tracking import Accuracy, follow, residuals
from gcrules.screws.study import study

__all__ = ["all_zeros", "main", "trace_defect"]

_ACCURATE = Accuracy(1e-5, 1e-10, 1e-7)
_SAME = 1e-8
_QUIET = 8  # loops without a new zero


def _random(rng: np.random.Generator, *shape: int) -> Complexes:
    return np.asarray(rng.normal(size=shape) + 1j * rng.normal(size=shape))


def coordinates(x: Complexes) -> Complexes:
    """The seventeen coordinates (N, 17) of Study parameters (N, 8)."""
    return np.asarray(np.einsum("nij,ki,kj->kn", FORMS, x, x))


def all_zeros(seed: int) -> tuple[Complexes, Complexes]:
    """Generic forms (6, 17) and their zeros (N, 8), found by monodromy."""
    rng = np.random.default_rng(seed)
    turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    motion = np.eye(4)
    motion[:3, :3], motion[:3, 3] = turn * np.linalg.det(turn), rng.normal(size=3)
    assert np.allclose(motions(study(motion)[None])[0], motion)
    zeros = (study(motion) / np.linalg.norm(study(motion)))[None].astype(complex)
    value = coordinates(zeros)[0]
    forms = _random(rng, 6, COORDINATES)
    forms -= np.outer(forms @ value, value.conj()) / np.vdot(value, value).real
    forms = np.linalg.qr(forms.T)[0].T
    quiet = 0
    while quiet < _QUIET:
        stops = [quadrics(f) for f in (forms, _random(rng, 6, COORDINATES), _random(rng, 6, COORDINATES), forms)]
        x, ended = zeros.copy(), np.ones(len(zeros), dtype=bool)
        for a, b in pairwise(stops):
            ends = follow(a, b, x, _ACCURATE)
            x, ended = ends.x, ended & (ends.t == 0)
        before = len(zeros)
        for one in x[ended]:
            if (np.abs(zeros.conj() @ one) < 1 - _SAME).all():
                zeros = np.concatenate([zeros, one[None]])
        quiet = quiet + 1 if len(zeros) == before else 0
    return forms, zeros


def trace_defect(forms: Complexes, zeros: Complexes, seed: int = 5) -> float:
    """How unevenly the sum of the zeros moves as the first form moves in a pencil, in parts of how far it moves."""
    rng = np.random.default_rng(seed)
    chart, shift = _random(rng, COORDINATES), _random(rng, COORDINATES)
    sums = []
    for part in (0.0, 0.5, 1.0):
        moved = forms.copy()
        moved[0] = moved[0] + part * chart  # in the chart, the form moves by a constant
        there = follow(quadrics(forms), quadrics(moved), zeros.copy(), _ACCURATE)
        assert (there.t == 0).all()
        values = coordinates(there.x)
        sums.append(((values @ shift) / (values @ chart)).sum())
    return float(abs(sums[0] - 2 * sums[1] + sums[2]) / abs(sums[2] - sums[0]))


def _pairs(values: Complexes) -> list[list[list[float]]]:
    parts: Floats = np.stack([values.real, values.imag], axis=-1)
    return [[[float(c) for c in pair] for pair in row] for row in parts]


def main() -> int:
    """Write or check the file."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--seed", type=int, default=1998)
    chosen = parser.parse_args()
    if chosen.check:
        forms, zeros = start()
    else:
        forms, zeros = all_zeros(chosen.seed)
    off = float(np.abs(residuals(quadrics(forms), zeros)).max())
    all_, part = trace_defect(forms, zeros), trace_defect(forms, zeros[:-1])
    print(f"{len(zeros)} zeros, residual {off:.1e}, trace off by {all_:.1e} (without one of them by {part:.1e})")
    if len(zeros) != PATHS or off > 1e-12 or all_ > 1e-6 or part < 1e-3:
        return 1
    if not chosen.check:
        text = json.dumps({"made by": "tools/modes_start.py", "forms": _pairs(forms), "zeros": _pairs(zeros)})
        START.write_text(text.replace("]], [[", "]],\n [[") + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
