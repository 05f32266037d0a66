"""Where all points of a subject are in a pose, points at infinity among them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gcrules.apps.studio.moving import values_at
from gcrules.apps.studio.numbers import numbers
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import Subject
from gcrules.views.robots.limb_views import all_places, directions

__all__ = ["homogeneous_at"]


def homogeneous_at(subject: Subject, pose: PoseJson) -> dict[str, NDArray[np.float64]]:
    """Homogeneous coordinates (1, 4) of all points, of a robot's directions too. Raises InputError for a pose that
    cannot be.
    """
    if subject.limbs:
        robot = subject.limbs.analysis
        places = all_places(robot, values_at(subject, pose))
        far = directions(robot)
        return {n: np.array([[*v, float(n not in far)]]) for n, v in places.items()}
    return {n: np.array([[*p, 1.0]]) for n, p in numbers(subject, pose)["points"].items()}
