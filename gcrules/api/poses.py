"""The public functions about poses; they load NumPy, so they stand apart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gcrules.api.signatures import public
from gcrules.mechanisms.load import Source
from gcrules.poses.aspects.aspects import aspects as _aspects
from gcrules.poses.boxes.box_map import box_map as _box_map
from gcrules.poses.compiling.compiled import compiled as _compiled
from gcrules.poses.compiling.controller import controller as _controller
from gcrules.poses.length_regions.length_regions import length_regions as _length_regions
from gcrules.poses.loci.locus import locus as _locus
from gcrules.poses.maps.maps import singular_map as _singular_map
from gcrules.poses.modes.modes import assembly_modes as _assembly_modes
from gcrules.poses.modes.working import working_modes as _working_modes
from gcrules.poses.operation_modes.operation_modes import operation_modes as _operation_modes
from gcrules.poses.path_report import path as _path
from gcrules.poses.plans.plan import plan as _plan
from gcrules.poses.pose import pose as _pose
from gcrules.poses.pose import singular as _singular
from gcrules.poses.regions.free_region import free_region as _free_region
from gcrules.poses.stored_maps.refining import refine_map as _refine_map
from gcrules.poses.stored_maps.verifying import verify_map as _verify_map
from gcrules.poses.tiles.merging import merge_maps as _merge_maps
from gcrules.poses.tiles.status import map_status as _map_status
from gcrules.views.code.source_code import source_code as _source_code

__all__ = [
    "aspects",
    "assembly_modes",
    "box_map",
    "compiled",
    "export",
    "free_region",
    "length_regions",
    "locus",
    "map_status",
    "merge_maps",
    "operation_modes",
    "path",
    "plan",
    "pose",
    "refine_map",
    "singular",
    "singular_map",
    "verify_map",
    "working_modes",
]

aspects = public(_aspects)
assembly_modes = public(_assembly_modes)
box_map = public(_box_map)
compiled = public(_compiled)
free_region = public(_free_region)
length_regions = public(_length_regions)
locus = public(_locus)
map_status = public(_map_status)
merge_maps = public(_merge_maps)
operation_modes = public(_operation_modes)
path = public(_path)
plan = public(_plan)
pose = public(_pose)
refine_map = public(_refine_map)
singular = public(_singular)
singular_map = public(_singular_map)
verify_map = public(_verify_map)
working_modes = public(_working_modes)


@public
def export(
    source: Source,
    language: str = "c",
    *,
    coordinates: str | Sequence[str] | None = None,
    about: str | Sequence[Any] = "centroid",
) -> str:
    """The condition's factors, the margin and the inverse kinematics of a robot as source code in "c", "cpp", "python"
    or "rust", which needs nothing else and holds a test.

    `source` is what `load` takes. Its functions take poses by the `coordinates` of the platform that are named, or
    those that are free near home: lengths in the file's unit, angles in rad, 0 at home. Poses turn `about` the same
    centre as in `pose`. Raises InputError for other languages, and for robots without loops.
    """
    return _source_code(_controller(source, coordinates=coordinates, about=about), language)
