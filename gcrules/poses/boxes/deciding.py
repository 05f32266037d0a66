r"""What is proved of boxes of poses: that all are regular, that none is reached within the limits, or neither.

A box is regular where its wrenches, Taylor models of a matrix, have full rank in all of it (`matrices`): then they hold
the platform in each pose that is reached. It is reached within the limits where the roots that place the links exist,
and the amounts of the actuators keep to them.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.poses.boxes.forms import BoxForms
from gcrules.poses.boxes.matrices import Matrices, Products, signs
from gcrules.poses.boxes.taylor import Models, models
from gcrules.poses.boxes.ties import LOWER, highest
from gcrules.poses.compiling.closed_forms import run
from gcrules.poses.compiling.tape import Program

__all__ = ["Boxes", "Decided", "Decider"]

Floats = NDArray[np.float64]
Truths = NDArray[np.bool_]
Places = NDArray[np.intp]

_BLOCK = 512
_ROUNDED = 1e-12  # of a cosine and a sine
_NOISE = 1e-12  # of the product of the rows' lengths: smaller changes of a determinant have no direction
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
    reached within the limits, `outside`; the sign of the determinant in the middle of free ones, 0 where there is none;
    the margin σ in the middle, not a number where it is not known, and what σ is at least in free ones; across which
    coordinate a box is best cut.
    """

    free: Truths
    outside: Truths
    signs: NDArray[np.int8]
    margins: Floats
    bounds: Floats
    sides: Places


@dataclass(frozen=True)
class Decider:
    """Boxes of those coordinates of `forms` that are `free`, the others have the values of `centre`; `weights` are by
    how much the free ones change where others change by theirs; `limits` are those of the actuators; with a `margin`
    above 0 poses have to keep it. Poses are kept to where all values of `kept` are at least 0, too.
    """

    forms: BoxForms
    centre: tuple[float, ...]
    free: tuple[int, ...]
    weights: tuple[float, ...]
    limits: LengthLimits | None = None
    margin: float = 0.0
    kept: Program | None = None

    def decided(self, boxes: Boxes) -> Decided:
        """What is proved of them."""
        parts = []
        for start in range(0, len(boxes), _BLOCK):
            checkpoint()
            parts.append(self._block(boxes[np.arange(start, min(start + _BLOCK, len(boxes)))]))
        return Decided(*(np.concatenate([getattr(p, f) for p in parts]) for f in Decided.__dataclass_fields__))

    def _block(self, boxes: Boxes) -> Decided:
        found = self._models(self.forms.wrenches, boxes)
        outside, _ = self.reached(boxes, found)
        free, determinants, influence = self._regular(found, outside)
        margins, bounds = np.full(len(boxes), np.nan), np.full(len(boxes), np.nan)
        if (some := np.flatnonzero(free)).size:
            margins[some], bounds[some], more = self._margins(boxes[some])
            if self.margin > 0:
                enough = bounds[some] >= self.margin
                free[some] = enough
                influence[:, some] = np.where(enough, influence[:, some], more)
        counts = np.nan_to_num(influence)
        idle = ~(counts.max(axis=0) > 0)
        sides = np.where(idle, highest((boxes.halves / self.weights).T), highest(counts))
        return Decided(free, outside, determinants, margins, bounds, sides)

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
            some = some[self.reached(boxes[some], m)[1] & m.known]
            if len(some) and self.forms.entries == self.forms.columns**2:
                found[some] = self._changes(boxes[some])
            if len(some) and self.margin > 0:
                margins = np.nan_to_num(self.margins_at(boxes.middles[some]), nan=1.0)
                found[some] |= margins < self.margin * LOWER
        return found

    def sign_at(self, coordinates: Floats) -> int:
        """The sign of the determinant at one place (n,) of all coordinates of the forms; 0 where it is not known."""
        place = Boxes(coordinates[None, :1], np.zeros((1, 1)))
        decider = replace(
            self, centre=tuple(coordinates.tolist()), free=(0,), weights=(1.0,), limits=None, margin=0.0, kept=None
        )
        found = decider._models(self.forms.wrenches, place)
        return int(decider._regular(found, np.zeros(1, dtype=bool))[1][0])

    def inputs(self, middles: Floats) -> Floats:
        """All coordinates of the forms (N, all) at places (N, n) of the free ones."""
        found = np.tile(np.array(self.centre), (len(middles), 1))
        found[:, list(self.free)] = middles
        return found

    def _models(self, program: Program | None, boxes: Boxes) -> Models:
        assert program is not None
        halves = np.zeros((len(boxes), len(self.centre)))
        halves[:, list(self.free)] = boxes.halves
        return models(program, self.inputs(boxes.middles), halves, self.free)

    def _rows(self, values: Floats) -> Floats:
        """Matrices (N, rows, columns) of values (rows × columns, N) and what follows them."""
        entries = values[: self.forms.entries]
        return np.ascontiguousarray(entries.T).reshape(values.shape[1], -1, self.forms.columns)

    def _regular(self, found: Models, aside: Truths) -> tuple[Truths, NDArray[np.int8], Floats]:
        """Where all wrenches of a box have full rank, the sign of the determinant there, and by how much each
        coordinate (n, N) keeps from a proof.
        """
        n, number = len(found.influence), found.terms.shape[2]
        free, determinants = np.zeros(number, dtype=bool), np.zeros(number, dtype=np.int8)
        influence = found.influence.copy()
        known = found.known & ~aside
        if not known.any():
            return free, determinants, influence
        whole = Matrices.of(found, known, self.forms.entries, self.forms.columns)
        radius, influence[:, known] = whole.radius(n)
        free[known] = radius < 1
        if whole.middles.shape[1] == whole.middles.shape[2]:  # the proof has room for what the middle is rounded by
            determinants[known] = np.where(radius < 1, np.linalg.slogdet(whole.middles)[0], 0)
        return free, determinants, influence

    def _margins(self, boxes: Boxes) -> tuple[Floats, Floats, Floats]:
        """The margin in the middle, what it is at least, and how much each coordinate (n, N) lowers it."""
        margins, bounds = self.margins_at(boxes.middles), np.zeros(len(boxes))
        influence = np.zeros((boxes.middles.shape[1], len(boxes)))
        if not self.margin > 0:
            return margins, bounds, influence
        rows, products = (self._models(p, boxes) for p in (self.forms.lines.rows, self.forms.lines.products))
        some = rows.known & products.known
        influence += rows.influence
        if some.any():
            number, count = int(some.sum()), sum(self.forms.lines.groups)
            back, longest, at = np.zeros((number, count, count)), np.ones(number), 0
            for limb in Products.several(products, some, self.forms.lines.groups):
                own, longer = limb.orthonormal()
                end = at + own.shape[1]
                back[:, at:end, at:end], longest, at = own, np.maximum(longest, longer), end
            whole = Matrices.of(rows, some, self.forms.entries, self.forms.columns).scaled(back)
            found, influence[:, some] = whole.bounds(len(influence))
            bounds[some] = found / np.sqrt(longest)
        return margins, bounds, influence

    def margins_at(self, middles: Floats) -> Floats:
        """The margins (N,), not numbers where the wrenches have no closed form there."""
        return self.forms.forms.margins("numpy", self.inputs(middles))

    def reached(self, boxes: Boxes, found: Models | None = None) -> tuple[Truths, Truths]:
        """Where (N,) no pose is reached within the limits, and where all are; `found` models the wrenches."""
        found = found or self._models(self.forms.wrenches, boxes)
        outside, inside = found.unreached.copy(), found.exists & self.forms.reached
        if self.kept is not None:
            held = self._models(self.kept, boxes)
            low, high = held.ranges()
            outside |= held.unreached | (high < 0).any(axis=0)
            inside &= (low >= 0).all(axis=0)
        limits = self.limits
        if limits is None:
            return outside, inside & ~outside
        driven = self._models(self.forms.forms.actuators, boxes)
        outside |= driven.unreached
        low, high = driven.ranges()
        row = 0
        for k, turns in enumerate(self.forms.forms.turns):
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
        """Whether the determinant has both signs among the places of each box."""
        every = self.tried(boxes)[1]
        return np.asarray(every.min(axis=0) * every.max(axis=0) < 0)

    def tried(self, boxes: Boxes) -> tuple[Floats, NDArray[np.int8]]:
        """Places (4, N, n) of boxes and the signs (4, N) of the determinant there: the middle, two corners towards
        which it changes most, and between these where it is extreme, which is between two sheets near each other.
        """
        here = self.inputs(boxes.middles)
        rows = self._rows(run(self.forms.wrenches, "numpy", here))
        step = np.zeros_like(boxes.middles)
        noise = _NOISE * np.prod(np.linalg.norm(rows, axis=2), axis=1)
        for k, at in enumerate(self.free):  # the direction in which the determinant changes most
            there = here.copy()
            there[:, at] += boxes.halves[:, k] * 1e-3
            change = np.linalg.det(self._rows(run(self.forms.wrenches, "numpy", there))) - np.linalg.det(rows)
            step[:, k] = np.where(np.abs(change) > noise, np.sign(change), 0.0)
        step *= boxes.halves
        places, every = [boxes.middles, boxes.middles - step, boxes.middles + step], [rows]
        every += [self._rows(run(self.forms.wrenches, "numpy", self.inputs(p))) for p in places[1:]]
        middle, low, high = (np.linalg.det(m) for m in every)
        bent = low + high - 2 * middle  # of the parabola through the three values
        extreme = np.clip(np.divide(low - high, 2 * bent, out=np.zeros_like(bent), where=bent != 0), -1, 1)
        places.append(boxes.middles + extreme[:, None] * step)
        every.append(self._rows(run(self.forms.wrenches, "numpy", self.inputs(places[-1]))))
        return np.stack(places), np.stack([signs(m) for m in every])


def _turned(found: Models, row: int, least: float, most: float) -> tuple[Truths, Truths]:
    """Where a turn is nowhere between two angles, and where it is everywhere; its cosine and its sine are the models
    `row` and `row + 1`.
    """
    number = found.terms.shape[2]
    c, s = found.centres[row], found.centres[row + 1]
    length = np.hypot(c, s)
    c, s = c / length, s / length
    across = (
        found.changes[row + 1] * c - found.changes[row] * s
    )  # the sine of the turn from the middle, which is there 0
    far = np.abs(across).sum(axis=0) + found.rest[row] * np.abs(s) + found.rest[row + 1] * np.abs(c) + _ROUNDED
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
