r"""What is proved of boxes of poses: that all are regular, that none is reached within the limits, or neither.

The wrenches in a box are W = W₀ + Σ eᵢ Wᵢ + …, a matrix of Taylor models. With a left inverse B of its middle,
|1 − B W| is in all entries at most a matrix A; where the spectral radius of A is below 1, every W of the box has full
rank. The radius is at most max (A v)ᵢ / vᵢ for each positive v (Collatz and Wielandt).

Where W is balanced, so that its least singular value is the margin σ, let W + D have a kernel, x in it, and |D| ≤ m.
Then x = (1 − B W) x − B D x, so that |x| ≤ A |x| + m |x| ℓ with the lengths ℓ of B's rows. With v = (1 − A)⁻¹ ℓ,
positive, and t the least with |x| ≤ t v, some vᵢ ≤ (A v)ᵢ + m |v| ℓᵢ: so σ ≥ 1/|v|. In small boxes σ₀ − |R| is better,
σ₀ in the middle, R the sizes of W − W₀ and |R| ≤ √(|R|₁ |R|_∞). Derived here.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.boxes.forms import BoxForms
from gcrules.poses.boxes.taylor import Models, models, pairs
from gcrules.poses.compiling.closed_forms import run
from gcrules.poses.compiling.tape import Program
from gcrules.poses.limits import LengthLimits

__all__ = ["Boxes", "Decided", "Decider"]

Floats = NDArray[np.float64]
Truths = NDArray[np.bool_]
Places = NDArray[np.intp]

_BLOCK = 512
_POWERS = 4  # of a matrix: they bring a vector near to the one by which its radius is bounded best
_ROUNDING = 1e-12  # of an inverse and of products with it, in parts of their terms
_APART = 1e-6  # of the lengths of a limb's wrenches: nearer to dependent ones no bound is told
_CERTAIN = 1e-9  # of the product of the rows' lengths: smaller determinants have no sign
_WIDE = 1e12  # of amounts that have no bound


@dataclass(frozen=True, eq=False)
class Boxes:
    """N boxes of coordinates: their `middles` (N, n), reaching `halves` (N, n) both ways."""

    middles: Floats
    halves: Floats

    def __len__(self) -> int:
        return len(self.middles)

    def __getitem__(self, chosen: NDArray[np.generic]) -> Boxes:
        """Those of an array of places, or a mask."""
        return Boxes(self.middles[chosen], self.halves[chosen])

    def cut(self, sides: Places) -> Boxes:
        """Both halves of each, across the coordinates `sides` (N,): the lower one, then the upper one."""
        number = np.arange(len(self))
        halves = self.halves.copy()
        halves[number, sides] /= 2
        step = np.zeros_like(halves)
        step[number, sides] = halves[number, sides]
        middles = np.stack([self.middles - step, self.middles + step], axis=1)
        return Boxes(middles.reshape(-1, middles.shape[-1]), np.repeat(halves, 2, axis=0))


@dataclass(frozen=True, eq=False)
class Decided:
    """Of N boxes: which are `free` of singular poses (and of a margin below the one asked for), in which no pose is
    reached within the limits, `outside`, and in which all are, `inside`; the sign of the determinant in the middle of
    free ones, 0 where there is none; the margin σ in the middle, not a number where it is not known, and what σ is at
    least in free ones; across which coordinate a box is best cut.
    """

    free: Truths
    outside: Truths
    inside: Truths
    signs: NDArray[np.int8]
    margins: Floats
    bounds: Floats
    sides: Places


@dataclass(frozen=True)
class Decider:
    """Boxes of those coordinates of `forms` that are `free`, the others have the values of `centre`; `weights` are by
    how much the free ones change where others change by theirs; `limits` are those of the actuators; with a `margin`
    above 0 poses have to keep it.
    """

    forms: BoxForms
    centre: tuple[float, ...]
    free: tuple[int, ...]
    weights: tuple[float, ...]
    limits: LengthLimits | None = None
    margin: float = 0.0

    def decided(self, boxes: Boxes) -> Decided:
        """What is proved of them."""
        parts = []
        for start in range(0, len(boxes), _BLOCK):
            checkpoint()
            parts.append(self._block(boxes[np.arange(start, min(start + _BLOCK, len(boxes)))]))
        return Decided(*(np.concatenate([getattr(p, f) for p in parts]) for f in Decided.__dataclass_fields__))

    def _block(self, boxes: Boxes) -> Decided:
        found = self._models(self.forms.wrenches, boxes)
        outside, inside = self._kept(found, boxes)
        free, signs, influence = self._regular(found, outside)
        margins, bounds = np.full(len(boxes), np.nan), np.full(len(boxes), np.nan)
        if (some := np.flatnonzero(free)).size:
            margins[some], bounds[some], more = self._margins(boxes[some])
            if self.margin > 0:
                enough = bounds[some] >= self.margin
                free[some] = enough
                influence[:, some] = np.where(enough, influence[:, some], more)
        counts = np.nan_to_num(influence)
        idle = ~(counts.max(axis=0) > 0)
        sides = np.where(idle, np.argmax(boxes.halves / self.weights, axis=1), np.argmax(counts, axis=0))
        return Decided(free, outside, inside, signs, margins, bounds, sides)

    def crossed(self, boxes: Boxes) -> Truths:
        """In which boxes (N,), all of whose poses are reached within the limits, there certainly is a singular pose:
        the wrenches are continuous in all of them, and their determinant has both signs; or, with a margin asked for,
        where the middle does not keep it.
        """
        found = np.zeros(len(boxes), dtype=bool)
        for start in range(0, len(boxes), _BLOCK):
            checkpoint()
            some = np.arange(start, min(start + _BLOCK, len(boxes)))
            m = self._models(self.forms.wrenches, boxes[some])
            some = some[self._kept(m, boxes[some])[1] & np.isfinite(m.terms).all(axis=(0, 1))]
            if len(some) and self.forms.entries == self.forms.columns**2:
                found[some] = self._changes(boxes[some])
            if len(some) and self.margin > 0:
                margins = np.nan_to_num(self._margins_at(boxes.middles[some]), nan=1.0)
                found[some] |= margins < self.margin * (1 - _CERTAIN)
        return found

    def sign_at(self, coordinates: Floats) -> int:
        """The sign of the determinant at one place (n,) of all coordinates of the forms; 0 where it is not known."""
        place = Boxes(coordinates[None, :1], np.zeros((1, 1)))
        decider = replace(self, centre=tuple(coordinates.tolist()), free=(0,), weights=(1.0,), limits=None, margin=0.0)
        found = decider._models(self.forms.wrenches, place)
        return int(decider._regular(found, np.zeros(1, dtype=bool))[1][0])

    def _inputs(self, middles: Floats) -> Floats:
        found = np.tile(np.array(self.centre), (len(middles), 1))
        found[:, list(self.free)] = middles
        return found

    def _models(self, program: Program | None, boxes: Boxes) -> Models:
        assert program is not None
        halves = np.zeros((len(boxes), len(self.centre)))
        halves[:, list(self.free)] = boxes.halves
        return models(program, self._inputs(boxes.middles), halves, self.free)

    def _rows(self, values: Floats) -> Floats:
        """Matrices (N, rows, columns) of values (rows × columns, N) and what follows them."""
        entries = values[: self.forms.entries]
        return np.ascontiguousarray(entries.T).reshape(values.shape[1], -1, self.forms.columns)

    def _regular(self, found: Models, aside: Truths) -> tuple[Truths, NDArray[np.int8], Floats]:
        """Where all wrenches of a box have full rank, the sign of the determinant there, and by how much each
        coordinate (n, N) keeps from a proof.
        """
        n, number = len(found.influence), found.terms.shape[2]
        free, signs = np.zeros(number, dtype=bool), np.zeros(number, dtype=np.int8)
        influence = found.influence.copy()
        known = found.exists & ~aside & np.isfinite(found.rest).all(axis=0) & np.isfinite(found.terms).all(axis=(0, 1))
        if not known.any():
            return free, signs, influence
        whole = _Matrices.of(found, known, self.forms.entries, self.forms.columns)
        radius, influence[:, known] = whole.radius(n)
        free[known] = radius < 1
        if whole.middles.shape[1] == whole.middles.shape[2]:  # the proof has room for what the middle is rounded by
            signs[known] = np.where(radius < 1, np.linalg.slogdet(whole.middles)[0], 0)
        return free, signs, influence

    def _margins(self, boxes: Boxes) -> tuple[Floats, Floats, Floats]:
        """The margin in the middle, what it is at least, and how much each coordinate (n, N) lowers it."""
        margins = self._margins_at(boxes.middles)
        bounds = np.zeros(len(boxes))
        if not self.margin > 0:
            return margins, bounds, np.zeros((boxes.middles.shape[1], len(boxes)))
        rows, products = (self._models(p, boxes) for p in (self.forms.lines.rows, self.forms.lines.products))
        influence = rows.influence.copy()
        known = rows.exists & np.isfinite(rows.rest).all(axis=0) & np.isfinite(margins)
        known &= np.isfinite(rows.terms).all(axis=(0, 1)) & np.isfinite(products.rest).all(axis=0)
        if known.any():
            whole = _Matrices.of(rows, known, self.forms.entries, self.forms.columns)
            lengths, longer = self._lengths(
                products.terms[:, 0, known], products.radii[:, known], products.centres[:, known]
            )
            found, influence[:, known] = whole.scaled(lengths).bounds(len(influence))
            bounds[known] = found / longer
        return margins, bounds, influence

    def _margins_at(self, middles: Floats) -> Floats:
        """The margins (N,), not numbers where the wrenches have no closed form there."""
        lines, inputs = self.forms.lines, self._inputs(middles)
        rows = self._rows(run(lines.rows, "numpy", inputs))
        products = run(lines.products, "numpy", inputs)
        found = np.full(len(middles), np.nan)
        fine = np.isfinite(rows).all(axis=(1, 2)) & np.isfinite(products).all(axis=0)
        if fine.any():
            lengths, _ = self._lengths(products[:, fine], np.zeros((len(products), int(fine.sum()))), products[:, fine])
            balanced = lengths @ rows[fine]
            found[fine] = np.minimum(np.linalg.svd(balanced, compute_uv=False)[:, self.forms.columns - 1], 1.0)
        return found

    def _lengths(self, products: Floats, radii: Floats, centres: Floats) -> tuple[Floats, Floats]:
        """What makes the wrenches of each limb orthonormal in the middle, (N, rows, rows), and by what factor others in
        the box are longer at most, (N,); infinite where they depend on each other.

        With the products G of a limb's wrenches, G₀ = K Kᵀ in the middle, K⁻¹ makes them orthonormal there, and in the
        box the largest eigenvalue of K⁻¹ G K⁻ᵀ, at most its largest sum of a row, is the square of that factor.
        """
        number, total = products.shape[1], sum(self.forms.lines.groups)
        found, longest = np.zeros((number, total, total)), np.ones(number)
        at = row = 0
        for k in self.forms.lines.groups:
            middle, far, centre = (
                np.moveaxis(c[at : at + k * k].reshape(k, k, number), -1, 0) for c in (products, radii, centres)
            )
            fine = np.linalg.eigvalsh(middle)[:, 0] > _APART * np.trace(middle, axis1=1, axis2=2)
            back = np.linalg.inv(np.linalg.cholesky(np.where(fine[:, None, None], middle, np.eye(k))))
            changed = np.abs(back @ centre @ np.swapaxes(back, 1, 2)) + np.abs(back) @ far @ np.abs(
                np.swapaxes(back, 1, 2)
            )
            longest = np.where(fine, np.maximum(longest, changed.sum(axis=2).max(axis=1)), np.inf)
            found[:, row : row + k, row : row + k] = back
            at, row = at + k * k, row + k
        return found, np.sqrt(longest) * (1 + _CERTAIN)

    def _kept(self, found: Models, boxes: Boxes) -> tuple[Truths, Truths]:
        """Where no pose is reached within the limits, and where all are; by the models of the wrenches."""
        outside, inside = found.unreached.copy(), found.exists & self.forms.reached
        limits = self.limits
        if limits is None:
            return outside, inside & ~outside
        driven = self._models(self.forms.actuators, boxes)
        outside |= driven.unreached
        low, high = driven.ranges()
        row = 0
        for k, turns in enumerate(self.forms.turns):
            least, most = limits.low[k], limits.high[k]
            if np.isfinite(least) or np.isfinite(most):
                if turns:
                    away, within = _turned(driven, row, least, most)
                else:
                    away = (high[row] < least) | (low[row] > most)
                    within = (low[row] >= least) & (high[row] <= most)
                outside |= away
                inside &= within
            row += 1 + turns
        return outside, inside & ~outside

    def _changes(self, boxes: Boxes) -> Truths:
        """Whether the determinant has both signs at two places of each box."""
        here = self._inputs(boxes.middles)
        rows = self._rows(run(self.forms.wrenches, "numpy", here))
        signs = _signs(rows)
        step = np.zeros_like(boxes.middles)
        for k, at in enumerate(self.free):  # the direction in which the determinant changes most
            there = here.copy()
            there[:, at] += boxes.halves[:, k] * 1e-3
            step[:, k] = np.linalg.det(self._rows(run(self.forms.wrenches, "numpy", there))) - np.linalg.det(rows)
        found = np.zeros(len(boxes), dtype=bool)
        ends = []
        for way in (-1, 1):
            places = self._inputs(boxes.middles + way * np.sign(step) * boxes.halves)
            ends.append(_signs(self._rows(run(self.forms.wrenches, "numpy", places))))
        for one, other in ((signs, ends[0]), (signs, ends[1]), (ends[0], ends[1])):
            found |= one * other < 0
        return found


@dataclass(frozen=True, eq=False)
class _Matrices:
    """Matrices over N boxes: in the `middles` (N, r, c), what each term adds (N, T, r, c), and what is left out."""

    middles: Floats
    terms: Floats
    rest: Floats

    @classmethod
    def of(cls, found: Models, known: Truths, entries: int, columns: int) -> _Matrices:
        """The first models of some boxes as matrices with so many columns, of which squares are from −1/2 to 1/2."""
        n, number = len(found.influence), int(known.sum())
        count = found.terms.shape[1]
        terms = np.ascontiguousarray(found.terms[:entries, :, known].transpose(2, 1, 0)).reshape(
            number, count, -1, columns
        )
        rest = np.ascontiguousarray(found.rest[:entries, known].T).reshape(number, -1, columns)
        changes = terms[:, 1:]
        changes[:, n : 2 * n] /= 2
        return cls(terms[:, 0] + changes[:, n : 2 * n].sum(axis=1), changes, rest)

    def scaled(self, by: Floats) -> _Matrices:
        """Products of matrices (N, r, r) and these."""
        return _Matrices(by @ self.middles, by[:, None] @ self.terms, np.abs(by) @ self.rest)

    def radius(self, n: int) -> tuple[Floats, Floats]:
        """A bound (N,) of the spectral radius of A, infinite where the middle has no inverse, and the parts (n, N) that
        the coordinates have in it.
        """
        whole, sizes = self._changes(_left_inverses(self.middles))
        v = np.ones((*whole.shape[:2], 1))
        for _ in range(_POWERS):
            v = whole @ v + v / 8
            v /= v.max(axis=1, keepdims=True)
        found = (whole @ v / v).max(axis=(1, 2))
        parts = (sizes @ v[:, None] / v[:, None]).max(axis=(2, 3))
        return np.where(np.isfinite(found), found, np.inf), _shared(parts, n)

    def bounds(self, n: int) -> tuple[Floats, Floats]:
        """What the least singular value is at least in a box, and the parts of the coordinates."""
        back = _left_inverses(self.middles)
        whole, sizes = self._changes(back)
        lengths = np.linalg.norm(back, axis=2)[..., None]
        small = np.isfinite(whole).all(axis=(1, 2)) & np.isfinite(lengths).all(axis=(1, 2))
        left = np.eye(whole.shape[1]) - np.where(small[:, None, None], whole, 0.0)
        small &= np.abs(np.linalg.det(left)) > _ROUNDING
        left[~small] = np.eye(whole.shape[1])
        v = np.linalg.solve(left, np.where(small[:, None, None], lengths, 1.0))
        good = small & (v > 0).all(axis=(1, 2))
        spare = ((v - whole @ v) / lengths).min(axis=(1, 2))  # is 1 but for rounding
        by_inverse = np.where(good, spare / np.linalg.norm(v, axis=(1, 2)), 0.0)
        far = np.abs(self.terms).sum(axis=1) + self.rest + _ROUNDING
        by_size = np.linalg.svd(self.middles, compute_uv=False)[:, -1] - _norm(far)
        found = np.nan_to_num(np.maximum(by_inverse, by_size) - _ROUNDING)
        parts = (sizes @ np.where(good[:, None, None], np.abs(v), 1.0)[:, None] / lengths[:, None]).max(axis=(2, 3))
        return np.maximum(found, 0.0), _shared(np.nan_to_num(parts), n)

    def _changes(self, back: Floats) -> tuple[Floats, Floats]:
        """A (N, c, c) for left inverses, and what each term (N, T, c, c) has in it."""
        number, count, rows, columns = self.terms.shape
        flat = self.terms.transpose(0, 2, 1, 3).reshape(number, rows, count * columns)
        sizes = np.abs((back @ flat).reshape(number, columns, count, columns)).transpose(0, 2, 1, 3)
        most = np.abs(self.middles) + np.abs(self.terms).sum(axis=1) + self.rest
        off = np.abs(np.eye(columns) - back @ self.middles) + np.abs(back) @ (self.rest + _ROUNDING * most)
        return sizes.sum(axis=1) + off, sizes


def _left_inverses(matrices: Floats) -> Floats:
    """Left inverses; not numbers where there is none."""
    if matrices.shape[1] == matrices.shape[2]:
        fine = np.linalg.det(matrices) != 0
        found = np.full(matrices.shape, np.nan)
        found[fine] = np.linalg.inv(matrices[fine])
        return found
    return np.asarray(np.linalg.pinv(matrices))


def _norm(sizes: Floats) -> Floats:
    """Bounds of the largest singular values of matrices with entries of at most these sizes."""
    return np.asarray(np.sqrt(sizes.sum(axis=1).max(axis=1) * sizes.sum(axis=2).max(axis=1)))


def _shared(parts: Floats, n: int) -> Floats:
    """What each coordinate (n, N) has in parts (N, T) of terms: of those of two coordinates each a half."""
    first, second = pairs(n)
    found = parts[:, :n].copy()
    for k in range(n):
        found[:, k] += (parts[:, n:][:, first == k].sum(axis=1) + parts[:, n:][:, second == k].sum(axis=1)) / 2
    return found.T


def _signs(matrices: Floats) -> NDArray[np.int8]:
    """The signs of determinants, 0 where they are 0 within rounding."""
    values = np.linalg.det(matrices)
    sizes = np.prod(np.linalg.norm(matrices, axis=2), axis=1)
    return np.where(np.abs(values) > _CERTAIN * sizes, np.sign(values), 0).astype(np.int8)


def _turned(found: Models, row: int, least: float, most: float) -> tuple[Truths, Truths]:
    """Where a turn is nowhere between two angles, and where it is everywhere; its cosine and its sine are the models
    `row` and `row + 1`.
    """
    number = found.terms.shape[2]
    c, s = found.centres[row], found.centres[row + 1]
    length = np.hypot(c, s)
    c, s = c / length, s / length
    across = found.terms[row + 1] * c - found.terms[row] * s  # the sine of the turn from the middle
    n = len(found.influence)
    sizes = np.abs(across[1:])
    sizes[n : 2 * n] /= 2
    middle = across[0] + across[1 + n : 1 + 2 * n].sum(axis=0) / 2
    far = np.abs(middle) + sizes.sum(axis=0) + found.rest[row] * np.abs(s) + found.rest[row + 1] * np.abs(c)
    along = found.radii[row] + found.radii[row + 1]
    known = np.isfinite(far) & (far < 1) & (length > along)  # else it may have turned round
    half = np.where(known, np.arcsin(np.minimum(np.nan_to_num(far), 1.0)), _WIDE)
    angle = np.arctan2(s, c)
    away, within = np.ones(number, dtype=bool), np.zeros(number, dtype=bool)
    for turn in (-2 * np.pi, 0.0, 2 * np.pi):
        low, high = angle + turn - half, angle + turn + half
        away &= (high < least) | (low > most)
        within |= (low >= least) & (high <= most)
    return away & known, within & known
