r"""The answer to how the lengths of legs fall into regions, in each of which the number of assembly modes is one."""

from __future__ import annotations

from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown

__all__ = ["LengthRange", "LengthRegion", "LengthRegions", "Strip"]

Point = tuple[float, ...]


@dataclass(frozen=True)
class LengthRange:
    """The lengths of one leg that are looked at, by the name of its actuator, between both ends."""

    name: str
    low: float
    high: float

    def to_json(self) -> dict[str, Any]:
        return {"name": self.name, "low": self.low, "high": self.high}


@dataclass(frozen=True)
class LengthRegion:
    """Lengths that are connected without a singular one between, with this many assembly `modes` each.

    `lengths` are those of all legs at a witness, `actuators` the amounts from home that give them. Across the singular
    lengths around it lie the regions that are named as its `neighbours`.
    """

    name: str
    modes: int
    lengths: Point
    actuators: Point
    neighbours: tuple[str, ...]

    def to_json(self) -> dict[str, Any]:
        return {
            "name": self.name,
            "modes": self.modes,
            "lengths": list(self.lengths),
            "actuators": list(self.actuators),
            "neighbours": list(self.neighbours),
        }


@dataclass(frozen=True)
class Strip:
    """The part of the plane of two lengths between two critical lines, as it is drawn.

    For each first length in `at` there are as many `heights` of the singular curve and of the edges of the box, from
    below; the regions between them are named in `regions`, "" outside of the box; `edges` says which heights are edges.
    """

    at: Point
    heights: tuple[Point, ...]
    regions: tuple[str, ...]
    edges: tuple[bool, ...]


@dataclass(frozen=True)
class LengthRegions(Shown):
    """The regions of the lengths of two or three legs, the others held, in each of which the number of assembly modes
    is the same and lengths are joined without a singular one.

    Of two lengths the answer is exact: there are no other regions in the box, and if `least` is their number they are
    all apart. Of three lengths the regions are those that slices at some first lengths meet: lengths of one region are
    joined, proved; others may be joined, too, there are `least` at least, and no region between the slices is counted.

    `cusps` and `crossings` of the singular curve are pairs of lengths in the box. `home` names the region of the
    lengths at home, "" where they are singular or are not in the box.
    """

    title: str
    names: tuple[str, ...]
    over: tuple[LengthRange, ...]
    held: tuple[tuple[str, float], ...]
    regions: tuple[LengthRegion, ...]
    least: int
    cusps: tuple[Point, ...] = ()
    crossings: tuple[Point, ...] = ()
    slices: Point = ()
    home: str = ""
    strips: tuple[Strip, ...] = ()

    @property
    def most(self) -> int:
        """How many regions there are at most among those that were met."""
        return len(self.regions)

    @property
    def decided(self) -> bool:
        """Whether the number of regions is known."""
        return not self.slices and self.least == self.most

    @property
    def counts(self) -> dict[int, int]:
        """How many regions have so many modes."""
        every = sorted({r.modes for r in self.regions})
        return {n: sum(r.modes == n for r in self.regions) for n in every}

    def __len__(self) -> int:
        return len(self.regions)

    def region(self, name: str) -> LengthRegion:
        """The region of this name. Raises KeyError."""
        for r in self.regions:
            if r.name == name:
                return r
        raise KeyError(name)

    def picture(self) -> Any:
        """The plane of two lengths, coloured by the number of modes: a drawing with `svg()`. Raises InputError for
        three lengths.
        """
        return self._show("picture")

    def to_json(self) -> dict[str, Any]:
        """One JSON object, without what only the picture takes."""
        return {
            "schema": 1,
            "title": self.title,
            "names": list(self.names),
            "over": [a.to_json() for a in self.over],
            "held": dict(self.held),
            "least": self.least,
            "most": self.most,
            "decided": self.decided,
            "regions": [r.to_json() for r in self.regions],
            "cusps": [list(p) for p in self.cusps],
            "crossings": [list(p) for p in self.crossings],
            "slices": list(self.slices),
            "home": self.home,
        }

    def csv(self) -> str:
        """A table of the regions: the lengths of a witness, the amounts of the actuators from home, and the number of
        modes.
        """
        header = ["region", "modes", *(f"length of {n}" for n in self.names), *self.names, "beside"]
        lines = [header]
        for r in self.regions:
            numbers = [repr(x + 0.0).removesuffix(".0") for x in (*r.lengths, *r.actuators)]
            lines.append([r.name, str(r.modes), *numbers, " ".join(r.neighbours)])
        return "".join(f"{','.join(line)}\n" for line in lines)

    def __repr__(self) -> str:
        number = str(self.least) if self.decided else f"{self.least} to {self.most}"
        return f"<LengthRegions: {number} over {' and '.join(a.name for a in self.over)}>"
