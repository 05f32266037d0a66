r"""All real solutions of the direct kinematics of a mechanism, by the method for its kind.

>>> found = assembly_modes("3-rps")
>>> len(found), found.completeness.complete, [mode.certificate.proved for mode in found.modes].count(True)
(8, True, 8)
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.methods import Methods, method
from gcrules.poses.modes.of_legs import modes_of_legs
from gcrules.poses.modes.of_limbs import modes_of_limbs
from gcrules.poses.modes.report import AssemblyModes
from gcrules.poses.numbers.pose_arguments import one_pose
from gcrules.screws.threshold import DEFAULT, Threshold, angle_threshold, threshold_of

__all__ = ["assembly_modes", "modes_of"]


def assembly_modes(
    source: Source,
    at: Any = None,
    *,
    actuators: Any = None,
    degrees: bool = False,
    about: str | Sequence[Any] = "centroid",
    threshold: str | Threshold = DEFAULT.text,
    plugins: Folders = (),
) -> AssemblyModes:
    """All real poses that a mechanism can take with its actuators held: each with what is proved of it, its margin and
    verdict, and the signs of the condition's factors; and whether they are all.

    `source` is what `load` takes, with coordinates. The actuators are held where they are at the pose `at`, which is
    given as for `gc.pose`, or in the file; or at values: `actuators` as text ("q1=0.1, q2=5deg", for a platform six
    lengths or some by the names of their legs, "ab=1.2"), a mapping, or all of them in order. Angles that are numbers
    are in radians unless `degrees`. Poses are from that of the file, `about` the same centre as in `gc.pose`.

    Six legs, and limbs whose conditions on the pose are linear in the coordinates of the group of motions (a distance,
    a point in a plane, directions at an angle: most that are known), have at most 40 isolated solutions, complex ones
    and those at infinity counted; all are followed from a system that is solved. For other robots configurations are
    sought from random joints, and `completeness` says so. Curves of solutions are listed as `curves`.

    Raises InputError for what is no pose and no value, for degenerate robots, and where a robot does not assemble at
    the pose.
    """
    if at is not None and actuators is not None:
        raise InputError("a pose and actuators at once", hint="give one of them; the other one follows")
    return modes_of(mechanism(source, about=about, plugins=plugins), at, actuators, degrees, threshold)


def modes_of(
    found: Mechanism,
    at: Any = None,
    actuators: Any = None,
    degrees: bool = False,
    threshold: str | Threshold = DEFAULT.text,
) -> AssemblyModes:
    """The assembly modes of a mechanism; arguments and errors as for `assembly_modes`."""
    return method(_MODES, found, "the direct kinematics")(at, actuators, degrees, threshold)


def _of_legs(m: SixLegs, at: Any, actuators: Any, degrees: bool, threshold: str | Threshold) -> AssemblyModes:
    pose = None if at is None else one_pose(at, {}, degrees, m.unit)
    if at is not None and pose is None:
        raise InputError("many poses at once", hint="ask for one pose")
    return modes_of_legs(m, pose, actuators, threshold_of(threshold, m.unit))


def _of_limbs(m: Limbs, at: Any, actuators: Any, degrees: bool, threshold: str | Threshold) -> AssemblyModes:
    return modes_of_limbs(m, at, actuators, degrees, angle_threshold(threshold, "for robots described by joints"))


_MODES: Methods[AssemblyModes] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
