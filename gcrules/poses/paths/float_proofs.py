r"""What floats prove of the superbracket along many segments: that it has no zero, and of what degree it is.

In 1 − s and s the motions and the number 1 are (1 − s) q₀ + s q₁, (1 − s) t₀ + s t₁ and (1 − s) + s. So n³ D is
Σ c_k (1 − s)^(9 − k) s^k, and has no zero in [0, 1] if all c_k are above 0, or all below. In s the motions are
q₀ + s (q₁ − q₀) and so on, and the highest power with a coefficient other than 0 is the degree.

Rounding: a term of a coefficient is the product of three coefficients of `Forms`, which are rounded once, of 6
components of quaternions, off by 16 units of 2⁻⁵³ of themselves at most (`Segments.motions`), and of 3 of translations,
rounded once. From there on it is rounded fewer than 60 times in each of three forms (sums of 40 products) and fewer
than 60 times when these are multiplied and summed, whatever the order. So a coefficient is off by fewer than 350 times
2⁻⁵³ of the sum of the absolute values of its terms, which is found in the same way, and as exactly; `_RELATIVE` is five
times as large. `_ABSOLUTE` is far above what is lost where numbers are too small for floats, 2⁻¹⁰⁷⁴ in each of fewer
than 10⁶ operations, times what they are multiplied by: `_LARGE` numbers prove nothing.

Differences are off by δ. A polynomial changes from x to x + δ by no more than the sum of the absolute values of its
terms grows from |x| to |x| + |δ|. Derived here.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.numbers.arrays import Floats
from gcrules.poses.paths.forms import Forms, superbracket
from gcrules.poses.paths.motions import Motions

__all__ = ["FloatProofs"]

Truths = NDArray[np.bool_]
Integers = NDArray[np.int64]

_PIECE = 100  # segments at once: of more, BLAS shares small products among threads, which takes several times as long
_RELATIVE = 2e-13
_ABSOLUTE = 1e-180
_LARGE = 1e13
_DIFFERENCE = 20 * 2.0**-53  # how much a difference is off at most, beside what it is a difference of


@dataclass(frozen=True, eq=False)
class FloatProofs:
    """Of N `motions`: `turns` (N,) says whether the quaternion changes and `shifts` (N, 3) which coordinates do,
    exactly.
    """

    forms: Forms
    motions: Motions
    turns: Truths
    shifts: Truths

    def without_zero(self) -> Truths:
        """Where it is proved that the superbracket is not 0 anywhere in [0, 1], (N,)."""
        found = []
        for values, errors in self.coefficients(np.arange(len(self.turns)), powers=False):
            found.append((np.abs(values) > errors).all(axis=0) & (np.sign(values) == np.sign(values[0])).all(axis=0))
        return np.concatenate(found)

    def degrees(self, chosen: Integers) -> Integers:
        """Of the chosen segments the highest powers with coefficients that are proved to be other than 0; −1 without
        any.
        """
        found = [np.zeros(0, np.int64)]
        for values, errors in self.coefficients(chosen, powers=True):
            found.append(np.where(np.abs(values) > errors, np.arange(len(values))[:, None], -1).max(axis=0))
        return np.concatenate(found)

    def coefficients(self, chosen: Integers, *, powers: bool) -> Iterator[tuple[Floats, Floats]]:
        """The coefficients in powers of s, or in those of 1 − s and s, and by how much they are off at most, infinite
        where that is not known: (10, M) each, of some chosen segments after the other. Lengths are in the unit of the
        forms, quaternions divided by a power of 2, so that they are near the length 1.
        """
        for p in self._pieces(chosen):
            if not powers:
                one = np.ones((1, 2, len(p.numbers)))
                yield self._bounded(np.stack([p.q0, p.q1], 1), np.concatenate([one, np.stack([p.t0, p.t1], 1)]))
                continue
            q, q_off = _differences(p.q0, p.q1, self.turns[p.numbers])
            t, t_off = _differences(p.t0, p.t1, self.shifts[p.numbers].T)
            one = np.zeros((1, 2, len(p.numbers)))
            t_off = np.concatenate([one, t_off])
            one[:, 0] = 1
            yield self._bounded(q, np.concatenate([one, t]), (q_off, t_off))

    def _pieces(self, chosen: Integers) -> Iterator[_Piece]:
        m, unit = self.motions, float(self.forms.unit)
        for i in range(0, len(chosen), _PIECE):
            checkpoint()
            k = chosen[i : i + _PIECE]
            most = np.abs(m.q0[k]).max(axis=1)
            size = np.where((most > 1 / _LARGE) & (most < _LARGE), 2.0 ** np.frexp(most)[1], np.nan)
            yield _Piece(k, m.q0[k].T / size, m.q1[k].T / size, m.t0[k].T / unit, m.t1[k].T / unit)

    def _bounded(
        self, turns: Floats, shifts: Floats, off: tuple[Floats, Floats] | None = None
    ) -> tuple[Floats, Floats]:
        """The coefficients and by how much they are off, for arguments as of `superbracket`, which may be off too."""
        c = self.forms.floats
        with np.errstate(all="ignore"):  # what is no number proves nothing
            values = superbracket(c, turns, shifts)
            sizes = superbracket(c, np.abs(turns), np.abs(shifts), absolute=True)
            errors = _RELATIVE * sizes + _ABSOLUTE
            if off is not None:
                wider = superbracket(c, np.abs(turns) + off[0], np.abs(shifts) + off[1], absolute=True)
                errors += (1 + _RELATIVE) * wider - sizes
            small = (np.abs(shifts).max(axis=(0, 1)) < _LARGE) & (np.abs(c).max() < _LARGE)
            return values, np.where(small & np.isfinite(errors), errors, np.inf)


@dataclass(frozen=True, eq=False)
class _Piece:
    """Some segments by their `numbers` (N,): quaternions (4, N) near the length 1, translations (3, N) in the unit."""

    numbers: Integers
    q0: Floats
    q1: Floats
    t0: Floats
    t1: Floats


def _differences(start: Floats, end: Floats, changes: Truths) -> tuple[Floats, Floats]:
    """The start and the end less the start, and by how much they are off at most beside rounding: (k, 2, N) each. A
    difference is exactly 0 where nothing changes.
    """
    off = np.where(changes, _DIFFERENCE * (np.abs(start) + np.abs(end)), 0.0)
    return np.stack([start, np.where(changes, end - start, 0.0)], 1), np.stack([np.zeros_like(off), off], 1)
