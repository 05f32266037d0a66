r"""The map of whole boxes of poses as a task of tiles: each tile is one box, with the tree of its parts.

The ranges of the coordinates are cut into equal tiles. A tile knows nothing of the others, so that they can be computed
anywhere (`gcrules.poses.tiles`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap, HoldsArrays
from gcrules.core.version import __version__
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.poses.boxes.deciding import Boxes, Decider
from gcrules.poses.boxes.forms import box_forms
from gcrules.poses.boxes.question import Question, question
from gcrules.poses.boxes.trees import LEAF, NEGATIVE, Leaves, grown, leaves_of
from gcrules.poses.maps.axes import parse_axis
from gcrules.poses.maps.cells import CROSSED, FREE, OUTSIDE, UNDECIDED
from gcrules.poses.methods import legs_within
from gcrules.poses.recipe import recipe_of, robot_of
from gcrules.poses.tiles.task import Coordinate, Tile, TiledArray, number_of, tile_at

__all__ = ["KIND", "MODES", "SHARES", "BoxTask", "box_task", "decided_part", "shares_of", "task_again", "within_boxes"]

Floats = NDArray[np.float64]

KIND = "map of boxes"
SHARES = ("free", "free with the other sign", "outside", "crossed", "undecided")
"""What parts of a tile are: free of singular poses, with the sign of the determinant that it has at home (where home is
singular the positive one; or without one, with more wrenches than freedoms), or with the other one; reached nowhere
within the limits; boxes that hold a singular pose; neither proved."""


MODES = {
    False: "a pose has one configuration",
    True: "home's: of two solutions of a limb, or of the platform, the one that is home's",
}
"""Which configurations are meant, by whether there are several."""

MOST_BOXES = 1_000_000
_TILES = (64, 16, 8, 2, 2, 2)
"""Tiles along each coordinate, by the number of coordinates, of a map of a number of boxes in all."""
_BOXES = 4_095
"""Boxes in each tile at most, where no number is given."""


@dataclass(frozen=True, eq=False)
class BoxTask(HoldsArrays):
    """A `TileTask`: of a mechanism the boxes of a question, each tile cut into so many `boxes` at most; with a `margin`
    above 0 poses have to keep it.
    """

    mechanism: Mechanism
    question: Question
    margin: float
    boxes: int
    recipe: Mapping[str, Any]

    stage = None

    def __getstate__(self) -> dict[str, Any]:
        return {f.name: getattr(self, f.name) for f in fields(self)}  # programs are made anew

    @property
    def grid(self) -> tuple[int, ...]:
        return tuple(a.number - 1 for a in self.question.axes)

    @property
    def manifest(self) -> dict[str, Any]:
        q = self.question
        return {
            "kind": KIND,
            "version": __version__,
            "robot": self.recipe["robot"],
            "about": self.recipe["about"],
            "over": [a.text for a in q.axes],
            "rest": dict(zip(q.names, q.values, strict=True)),
            "limits": q.limits.to_json() if q.limits else None,
            "margin": self.margin,
            "boxes": self.boxes,
        }

    @property
    def asked(self) -> dict[str, Any]:
        """What is asked as certificates have it, without what limits joints."""
        q = self.question
        return {
            "robot": self.recipe["robot"],
            "about": self.recipe["about"],
            "over": [{"coordinate": a.name, "low": str(a.start), "high": str(a.stop), "unit": a.unit} for a in q.axes],
            "rest": q.others,
            "limits": q.limits.to_json() if q.limits else None,
            "margin": self.margin,
        }

    @property
    def arrays(self) -> tuple[TiledArray, ...]:
        dims, one, n = tuple(a.name for a in self.question.axes), (1,) * len(self.grid), len(self.grid)

        def array(name: str, kind: str, more: tuple[tuple[str, int], ...] = (), **attrs: Any) -> TiledArray:
            names, sizes = tuple(d for d, _ in more), tuple(k for _, k in more)
            return TiledArray(name, (*dims, *names), (*self.grid, *sizes), (*one, *sizes), kind, FrozenMap(attrs))

        return (
            array("tree", "uint8", (("box", self.boxes),), long_name="boxes of a tile, level by level", comment=_TREE),
            array("share", "float64", (("status", len(SHARES)),), long_name="share of the tile", units="1"),
            array("margin", "float64", long_name="least margin sigma in the middle of a free box", units="1"),
            array("place", "float64", (("coordinate", n),), long_name="where that is, in the units of the coordinates"),
            array("bound", "float64", long_name="proved: sigma is at least this in all free boxes", units="1"),
        )

    @property
    def coordinates(self) -> tuple[Coordinate, ...]:
        found = [
            Coordinate("status", ("status",), np.array(SHARES), FrozenMap({"long_name": "what is proved of a part"})),
            Coordinate("coordinate", ("coordinate",), np.array([a.name for a in self.question.axes])),
        ]
        for a in self.question.axes:
            about = {"units": a.unit or "1", "long_name": a.meaning, "bounds": f"{a.name}_bounds"}
            middles, ends = (a.nodes[:-1] + a.nodes[1:]) / 2, np.stack([a.nodes[:-1], a.nodes[1:]], axis=1)
            found.append(Coordinate(a.name, (a.name,), middles, FrozenMap(about)))
            found.append(Coordinate(f"{a.name}_bounds", (a.name, "side"), ends))
        return tuple(found)

    @property
    def attrs(self) -> dict[str, Any]:
        q = self.question
        return {
            "Conventions": "CF-1.11",
            "title": f"Boxes of poses of {self.mechanism.title}",
            "source": f"gcrules {__version__}",
            "condition": q.sentence,
            "mode": MODES[q.chosen],
            "coordinates_of_the_rest": q.rest,
            "limits": q.limits.text if q.limits else "",
            "least_margin_asked_for": self.margin,
        }

    @cached_property
    def decider(self) -> Decider:
        """What decides boxes, in radians and the file's unit. Raises InputError for what has no closed form."""
        q = self.question
        forms = box_forms(self.mechanism, q.names)
        if q.limits is not None and forms.forms.actuators is None:
            raise InputError(
                "what the actuators do has no closed form that is known here: limits cannot be proved over boxes",
                hint="leave them out (--limits none), or map nodes: give each range a number",
            )
        return Decider(forms, q.values, q.free, q.weights, q.limits, self.margin)

    @cached_property
    def home(self) -> int:
        """The sign of the determinant at home; 1 where there is none."""
        return self.decider.sign_at(np.zeros(len(self.question.names))) or 1

    def check(self) -> None:
        """Raises InputError where the mechanism, or its limits, have no closed form."""
        _ = self.decider

    def compute(self, tile: int) -> Tile:
        """All arrays of a tile."""
        found = grown(self.decider, self.box(tile), self.boxes, self.home)
        one = (1,) * len(self.grid)
        return {
            "tree": self.padded(found.codes),
            "share": shares_of(self.leaves(found.codes, tile)).reshape(*one, -1),
            "margin": np.full(one, found.margin),
            "place": (found.place / self.units).reshape(*one, -1),
            "bound": np.full(one, found.bound),
        }

    def padded(self, codes: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """The tree of a tile with zeros at its end, as it is kept."""
        found = np.zeros((*(1,) * len(self.grid), self.boxes), np.uint8)
        some = codes[codes > 0]
        found[..., : len(some)] = some
        return found

    def box(self, tile: int) -> Boxes:
        """The box of a tile, in radians and the file's unit."""
        at = tile_at(self.grid, tile)
        places = zip(self.question.axes, at, strict=True)
        ends = np.array([[float(a.start + (k + side) * a.step) for side in (0, 1)] for a, k in places])
        low, high = (ends * self.units[:, None]).T
        return Boxes((low + high)[None] / 2, (high - low)[None] / 2)

    def leaves(self, codes: NDArray[np.uint8], tile: int) -> Leaves:
        """The boxes of a tile that are not cut, in radians and the file's unit."""
        return leaves_of(codes.ravel(), self.box(tile))

    @property
    def number(self) -> int:
        """How many tiles there are."""
        return number_of(self)

    @property
    def units(self) -> Floats:
        """What a unit of each axis is in radians, or in the file's unit."""
        return np.array([a.scale for a in self.question.axes])


_TREE = (
    f"a box that is cut has 1 + the number of the coordinate across which it is cut, its halves stand on the next "
    f"level, the lower one first; others have {LEAF} + {FREE} free, {CROSSED} crossed, {UNDECIDED} undecided, "
    f"{OUTSIDE} outside, + {NEGATIVE} where the determinant has not the sign that it has at home; 0 at the end is "
    "nothing"
)


def shares_of(leaves: Leaves) -> Floats:
    """The shares of a tile, in the order of `SHARES`."""
    free, size = leaves.status == FREE, leaves.shares
    parts = (
        free & ~leaves.negative,
        free & leaves.negative,
        *(leaves.status == s for s in (OUTSIDE, CROSSED, UNDECIDED)),
    )
    return np.array([size[p].sum() for p in parts])


def decided_part(shares: Sequence[float]) -> float:
    """What of a range is proved to be free, or to be outside, of its shares in the order of `SHARES`."""
    return min(sum(shares[:3]), 1.0)


def within_boxes(number: int, boxes: int) -> tuple[int, int]:
    """The tiles along each of a `number` of coordinates, and the boxes in each, of a map of so many boxes in all.

    >>> within_boxes(2, 16_384), within_boxes(6, 16_384)
    ((16, 63), (2, 255))
    """
    tiles = _TILES[min(max(number, 1), len(_TILES)) - 1]
    return tiles, min(max(boxes // tiles**number - 1, 1), MOST_BOXES)


def box_task(
    m: Mechanism,
    over: Any,
    at: Any = None,
    limits: str | None = None,
    margin: float = 0.0,
    tiles: int | None = None,
    boxes: int | None = None,
) -> BoxTask:
    """The task of a map of whole boxes; of a robot whose limbs are six legs by its platform. Raises InputError for what
    makes no sense.
    """
    if not 0 <= margin < 1:
        raise InputError(f"the margin {margin} is not from 0 to 1")
    if boxes is not None and not 1 <= boxes <= MOST_BOXES:
        raise InputError(f"{boxes} boxes in each tile, expected 1 to {MOST_BOXES:,}")
    kind = legs_within(m, limits) or m
    asked = question(kind, over, at, limits, tiles)
    recipe = recipe_of(KIND, m, asked.axes, at, limits, margin=margin, boxes=boxes or _BOXES)
    return BoxTask(kind, asked, margin, boxes or _BOXES, FrozenMap(recipe))


def task_again(recipe: Mapping[str, Any]) -> BoxTask:
    """The task of a recipe. Raises GcrulesError and KeyError for what is none."""
    found = mechanism(robot_of(recipe["robot"]), about=recipe["about"])
    over = [parse_axis(text, found.unit) for text in recipe["over"]]
    return box_task(found, over, recipe["at"], recipe["limits"], recipe["margin"], None, recipe["boxes"])
