"""The public functions about poses; each loads what it needs when it is first asked for."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from gcrules.api.signatures import public
from gcrules.core.deferred import deferred, resolved
from gcrules.mechanisms.load import Source

if TYPE_CHECKING:
    from gcrules.poses.aspects.aspects import aspects
    from gcrules.poses.boxes.box_map import box_map
    from gcrules.poses.certificates.certify import certify
    from gcrules.poses.compiling.compiled import compiled
    from gcrules.poses.length_regions.length_regions import length_regions
    from gcrules.poses.loci.locus import locus
    from gcrules.poses.maps.maps import singular_map
    from gcrules.poses.modes.modes import assembly_modes
    from gcrules.poses.modes.working import working_modes
    from gcrules.poses.operation_modes.operation_modes import operation_modes
    from gcrules.poses.path_report import path
    from gcrules.poses.plans.plan import plan
    from gcrules.poses.pose import pose, singular
    from gcrules.poses.regions.free_region import free_region
    from gcrules.poses.stored_maps.refining import refine_map
    from gcrules.poses.stored_maps.verifying import verify_map
    from gcrules.poses.tiles.merging import merge_maps
    from gcrules.poses.tiles.status import map_status

__all__ = [
    "aspects",
    "assembly_modes",
    "box_map",
    "certify",
    "compiled",
    "export",
    "export_model",
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

_MODULES = {
    "aspects": "gcrules.poses.aspects.aspects",
    "assembly_modes": "gcrules.poses.modes.modes",
    "box_map": "gcrules.poses.boxes.box_map",
    "certify": "gcrules.poses.certificates.certify",
    "compiled": "gcrules.poses.compiling.compiled",
    "free_region": "gcrules.poses.regions.free_region",
    "length_regions": "gcrules.poses.length_regions.length_regions",
    "locus": "gcrules.poses.loci.locus",
    "map_status": "gcrules.poses.tiles.status",
    "merge_maps": "gcrules.poses.tiles.merging",
    "operation_modes": "gcrules.poses.operation_modes.operation_modes",
    "path": "gcrules.poses.path_report",
    "plan": "gcrules.poses.plans.plan",
    "pose": "gcrules.poses.pose",
    "refine_map": "gcrules.poses.stored_maps.refining",
    "singular": "gcrules.poses.pose",
    "singular_map": "gcrules.poses.maps.maps",
    "verify_map": "gcrules.poses.stored_maps.verifying",
    "working_modes": "gcrules.poses.modes.working",
}
_controller = deferred("gcrules.poses.compiling.controller:controller")
_model_text = deferred("gcrules.views.models.model_text:model_text")
_source_code = deferred("gcrules.views.code.source_code:source_code")


def __getattr__(name: str) -> Callable[..., Any]:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    function: Callable[..., Any] = public(resolved(f"{_MODULES[name]}:{name}"))
    globals()[name] = function
    return function


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
    code: str = _source_code(_controller(source, coordinates=coordinates, about=about), language)
    return code


@public
def export_model(source: Source, format: str = "mjcf", *, unit: str = "") -> str:
    """A robot with dimensions as the text of a model file of links and joints: "mjcf" (MuJoCo), "urdf", or "closures",
    the file beside one in URDF that closes its loops and says what is driven.

    `source` is what `load` takes; its lengths are in `unit` ("m", "mm", "in" …), by default in that of its file or else
    in metres. The model is at home; joints with several freedoms are several joints. Raises InputError for other
    formats and units, for robots without joints or dimensions, and for cables.
    """
    text: str = _model_text(source, format, unit=unit)
    return text
