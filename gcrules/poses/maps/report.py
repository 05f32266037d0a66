r"""The answer for a map: arrays over the grid, singular curves or surfaces, which cells are proved free, a summary."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.arguments import FILE, TEXT, checked, each
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, InputError, LimitReached
from gcrules.core.frozen import FrozenMap, HoldsArrays
from gcrules.core.shown import Shown
from gcrules.mechanisms.description.limits import LengthLimits
from gcrules.poses.certificate_files import write_certificate
from gcrules.poses.maps.cell_certificate import cell_certificate
from gcrules.poses.maps.mesh import Mesh
from gcrules.poses.maps.slices import SliceFactor
from gcrules.poses.maps.summary import MapSummary
from gcrules.poses.maps.surface import Sheet, of_factor, sheet
from gcrules.poses.maps.task import Chunk, MapTask, Slice, width_of
from gcrules.poses.maps.variables import about
from gcrules.poses.tiles.keeping import Store
from gcrules.screws.threshold import Threshold, margin_of

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["Curve", "SingularMap"]

Floats = NDArray[np.float64]

MAX_IN_MEMORY = 40_000_000
"""Numbers of one array that are put together in memory."""


@dataclass(frozen=True, eq=False)
class Curve(HoldsArrays):
    """Singular poses along a curve: `points` (K, 2) in the axes' coordinates, the first again at the end if it is
    closed. `factor` is the number of the factor that is 0 there (None where the slice is no polynomial); `allowed`
    (K,) says where the limits of leg lengths are kept.
    """

    points: Floats
    factor: int | None
    allowed: NDArray[np.bool_]

    @property
    def closed(self) -> bool:
        return len(self.points) > 2 and bool((self.points[0] == self.points[-1]).all())

    def to_json(self) -> dict[str, Any]:
        return {
            "factor": self.factor,
            "closed": self.closed,
            "points": self.points.tolist(),
            "allowed": self.allowed.tolist(),
        }


@dataclass(frozen=True, eq=False)
class SingularMap(HoldsArrays, Shown):
    """A robot over two or three coordinates of its poses.

    `values(name)` are arrays over the grid, in the order of the axes (`arrays` are their names); `curves` are the
    singular curves of a map over two coordinates, `mesh` is the surface of one over three. `factors` are those of the
    superbracket where it is a polynomial on the slice (None otherwise), `everywhere` says that it is 0 throughout.
    `sentence` is the robot's condition in words, `wording` that with its source apart; from the `recipe` it is planned
    anew.
    """

    task: MapTask
    sentence: str
    wording: Mapping[str, str | None]
    threshold: Threshold
    store: Store
    summary: MapSummary
    curves: tuple[Curve, ...] = ()
    notes: tuple[str, ...] = ()
    recipe: Mapping[str, Any] = FrozenMap()

    @property
    def grid(self) -> Slice:
        return self.task.grid

    @property
    def limits(self) -> LengthLimits | None:
        return self.task.limits

    @property
    def factors(self) -> tuple[SliceFactor, ...] | None:
        return self.task.factors

    @property
    def everywhere(self) -> bool:
        return self.task.everywhere

    @property
    def arrays(self) -> tuple[str, ...]:
        """Of platforms superbracket, and as asked for margin, leg_length, allowed; of robots of joints margin (not a
        number where they are not reached), the sign of the determinant, actuator and allowed. cell_status has an entry
        for each cell.
        """
        return self.task.names

    @property
    def level(self) -> Floats:
        """What changes its sign at singular poses, at the nodes; not a number where it is not known."""
        return np.concatenate([self.task.level(chunk) for _, chunk in self.chunks()])

    @property
    def sigma(self) -> float:
        """The margin that the threshold stands for."""
        assert self.threshold.angle is not None
        return margin_of(self.threshold.angle)

    def chunks(self) -> Iterator[tuple[int, Chunk]]:
        """The first layer of each chunk, and its arrays."""
        for n in range(self.task.number):
            yield self.task.span(n)[0], self.chunk(n)

    def chunk(self, n: int) -> Chunk:
        """The arrays of one chunk."""
        chunk = self.store.get(n)
        if chunk is None:
            raise EngineFault(f"chunk {n} of the map is gone")
        return chunk

    @checked("map.values", name=TEXT)
    def values(self, name: str) -> NDArray[Any]:
        """One array over the whole grid. Raises LimitReached where it is too large to be in memory."""
        if name not in self.arrays:
            raise InputError(f"the map has no {name!r}", hint=f"it has {', '.join(self.arrays)}")
        if self.grid.size * width_of(self.task, name) > MAX_IN_MEMORY:
            raise LimitReached(f"{name} is too large to be in memory", hint="write a NetCDF file, or use chunks()")
        return np.concatenate([chunk[name] for _, chunk in self.chunks()])

    @cached_property
    def mesh(self) -> Mesh:
        """The singular surface of a map over three coordinates. Raises InputError for two, and without the extra."""
        if len(self.grid.axes) != 3:
            raise InputError("a map over two coordinates has curves, no surface", hint="give a third coordinate")
        return self.surface()

    def surface(self) -> Mesh:
        """The mesh anew."""
        task, g = self.task, self.grid
        if task.factors is not None:
            sheets: list[Sheet] = []
            for f in task.factors:
                sheets.append(sheet(*of_factor(f, g.shape), g.shape, before=sum(len(s[2]) for s in sheets)))
        else:
            sheets = [] if self.everywhere else [sheet(task.value, self._layers, g.shape)]
        steps = np.array([float(a.step) for a in g.axes])
        places = np.concatenate([s[0] for s in sheets]) if sheets else np.zeros((0, 3))
        slopes = (np.concatenate([s[1] for s in sheets]) if sheets else np.zeros((0, 3))) / steps
        size = np.linalg.norm(slopes, axis=1, keepdims=True)
        starts = np.cumsum([0, *(len(s[0]) for s in sheets)])
        faces = [s[2] + start for s, start in zip(sheets, starts[:-1], strict=True)]
        where = g.coordinates(places) if len(places) else np.zeros((0, 3))
        normals = np.where(size > 0, slopes / np.where(size > 0, size, 1), [0.0, 0.0, 1.0])
        listed = np.concatenate([np.zeros((0, 3)), *faces]).astype(np.int32)
        return Mesh(
            vertices=where,
            normals=normals,
            faces=listed,
            sheet=np.repeat(np.arange(len(sheets)), np.diff(starts)).astype(np.uint8),
            allowed=self.allows(where),
            accurate=np.concatenate([np.zeros(0, dtype=bool), *(s[3] for s in sheets)]),
            names=tuple(a.name for a in g.axes),
            units=tuple(a.unit for a in g.axes),
            about={k: v for k, v in self.about.items() if k != "Conventions"},
        )

    def _layers(self, first: int, last: int) -> Floats:
        """The level at layers from `first` to the one before `last`, from the chunks."""
        found = []
        for n in range(first // self.task.layers, -(-last // self.task.layers)):
            start, stop = self.task.span(n)
            found.append(self.task.level(self.chunk(n))[max(first - start, 0) : min(last, stop) - start])
        return np.concatenate(found)

    def allows(self, coordinates: Floats) -> NDArray[np.bool_]:
        """Which poses at coordinates (N, axes) keep to the limits."""
        return np.asarray(self.task.spare(coordinates) >= 0)

    @property
    def about(self) -> Mapping[str, str]:
        """What the map is, for the attributes of files; no dates, so that equal maps are equal files."""
        return {**about(self.task, self.sentence), "guarantee": self.guarantee}

    @property
    def guarantee(self) -> str:
        """What is proved, in one sentence."""
        return self.task.guarantee(self.summary)

    def to_json(self) -> dict[str, Any]:
        """One JSON object, with the curves but without the arrays."""
        return {
            "schema": 1,
            **self.task.subject(),
            **self.grid.to_json(),
            **self.wording,
            "measure": self.task.measure,
            "limits": self.limits.to_json() if self.limits else None,
            "threshold": {"angle": self.threshold.angle},
            "factors": None if self.factors is None else [f.to_json() for f in self.factors],
            "everywhere": self.everywhere,
            "summary": self.summary.to_json(),
            "guarantee": self.guarantee,
            "curves": [c.to_json() for c in self.curves],
            "notes": list(self.notes),
        }

    def to_xarray(self) -> Dataset:
        """An xarray Dataset with coordinates, units and metadata. Raises InputError where xarray is missing."""
        data: Dataset = self._show("xarray")
        return data

    @checked("map.save", paths=each(FILE))
    def save(self, *paths: str) -> None:
        """Write files; the suffix says of what kind: .nc, .zarr, .svg, .pdf, .png, .ply, .glb, .json."""
        self._show("save", paths=paths)

    def certificate(self) -> dict[str, Any]:
        """The status of each cell with all that another program needs to recompute it, as JSON: see `save_certificate`.

        Raises InputError where nothing is proved, LimitReached for robots of joints without closed forms of their
        limbs, over actuators for those whose loops no checker closes, and for too many cells.
        """
        return cell_certificate(self)

    @checked("map.save_certificate", path=FILE)
    def save_certificate(self, path: str) -> None:
        """Write the status of each cell, .json or .json.gz, for the program check_map.py, which recomputes it.

        Raises as `certificate`, and FileError.
        """
        write_certificate(self, path)

    def __repr__(self) -> str:
        shape = " x ".join(map(str, self.grid.shape))
        over = ", ".join(a.name for a in self.grid.axes)
        found = f", {len(self.curves)} curves" if len(self.grid.axes) == 2 else ""
        return f"<SingularMap over {over}, {shape} poses{found}>"
