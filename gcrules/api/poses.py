"""The public functions about poses; they load NumPy, so they stand apart."""

from __future__ import annotations

from gcrules.api.signatures import public
from gcrules.poses.compiling.compiled import compiled as _compiled
from gcrules.poses.loci.locus import locus as _locus
from gcrules.poses.maps.maps import singular_map as _singular_map
from gcrules.poses.path_report import path as _path
from gcrules.poses.pose import pose as _pose
from gcrules.poses.pose import singular as _singular

__all__ = ["compiled", "locus", "path", "pose", "singular", "singular_map"]

compiled = public(_compiled)
locus = public(_locus)
path = public(_path)
pose = public(_pose)
singular = public(_singular)
singular_map = public(_singular_map)
