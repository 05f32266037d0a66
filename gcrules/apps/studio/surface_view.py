"""The singular surface over x, y and z around a pose of the page: triangles for its scene, and what is proved."""

from __future__ import annotations

from collections.abc import Sequence

from gcrules.apps.studio.items import fact
from gcrules.apps.studio.kept import kept
from gcrules.apps.studio.map_view import planned_map
from gcrules.apps.studio.protocol.motion_views import SurfaceAnswer
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.core.english import as_sentence, listed
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.poses.maps.axes import TRANSLATION
from gcrules.poses.maps.limb_grid import LimbsGrid
from gcrules.poses.maps.maps import done
from gcrules.poses.maps.report import SingularMap
from gcrules.screws.threshold import DEFAULT
from gcrules.views.results.map import account

__all__ = ["surface_of", "surface_view"]

MAX_NODES = 42**3
"""Poses of a surface in the page."""


def surface_view(found: SingularMap) -> SurfaceAnswer:
    """A surface over x, y and z as the page is told."""
    order = [found.mesh.names.index(n) for n in TRANSLATION]
    return {
        "vertices": [round(float(c), 9) for c in found.mesh.vertices[:, order].ravel()],
        "faces": found.mesh.faces.ravel().tolist(),
        "reached": found.mesh.allowed.tolist(),
        "nodes": list(found.grid.shape),
        "free": found.summary.cells[0],
        "cells": sum(found.summary.cells) + found.summary.outside,
        "guarantee": as_sentence(found.guarantee),
        "resolution": _resolution(found),
        "facts": [fact(name, value) for name, value in account(found)],
        "held": _held(found),
    }


@kept
def surface_of(subject: Subject, over: Sequence[str], pose: PoseJson) -> SingularMap:
    """The surface over x, y and z, the other coordinates as they are at the pose. Raises InputError where there is
    none, LimitReached for more than `MAX_NODES` poses.
    """
    _check(subject.mechanism, [words.split()[0] for words in over])
    plan = planned_map(subject, over, pose, DEFAULT, "margin")
    if plan.task.grid.size > MAX_NODES:
        raise LimitReached(
            f"{plan.task.grid.size:,} poses: more than {MAX_NODES:,} in a surface of the page",
            hint="use fewer poses along each coordinate",
        )
    return done(plan)


def _check(m: Mechanism, names: Sequence[str]) -> None:
    """Raises InputError for other coordinates than x, y and z, and where these tell nothing of the robot's poses."""
    if sorted(names) != sorted(TRANSLATION):
        raise InputError(f"the scene shows a surface over x, y and z, not over {listed(names)}")
    if not isinstance(m, Limbs):
        return
    free = free_coordinates(m.linkage)
    if set(TRANSLATION) <= set(free_coordinates(m.linkage, list(TRANSLATION))):
        return
    instead = f"map two of its freedoms {listed(free)}, or two actuators" if len(free) > 1 else "drive it along a path"
    raise InputError(
        f"the place of the platform of {m.robot.id} is not free in x, y and z: there is no surface in the scene",
        hint=f"{instead} instead",
    )


def _resolution(m: SingularMap) -> str:
    """How fine the triangles are, and how close their corners are to singular poses."""
    mesh, unit = m.mesh, m.grid.unit
    steps = sorted({float(f"{float(a.step):.3g}") for a in m.grid.axes})
    apart = f"{' to '.join(f'{s:g}' for s in (*steps[:1], *steps[1:][-1:]))} {unit}".rstrip()
    if not len(mesh.faces):
        return f"There is nothing to draw: between poses {apart} apart no sign changes."
    drawn = f"{len(mesh.faces):,} triangles between poses {apart} apart"
    if m.factors is None:
        return f"{drawn}: {m.task.accuracy}."
    exact = int(mesh.accurate.sum())
    on = "all" if exact == len(mesh.accurate) else f"{exact:,}"
    return f"{drawn}: of their {len(mesh.vertices):,} corners {on} are singular poses up to rounding."


def _held(m: SingularMap) -> dict[str, float]:
    """The freedoms of a robot with limbs that are no axes, in radians or in its unit."""
    g = m.grid
    if not isinstance(g, LimbsGrid):
        return {}
    return {n: v for n, v in zip(g.names, g.values, strict=True) if n not in TRANSLATION}
