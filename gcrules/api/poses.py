"""The public functions about poses; they load NumPy, so they stand apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

from gcrules.algebra.expr import Expr
from gcrules.api.signatures import public
from gcrules.mechanisms.load import Folders, Source
from gcrules.poses.compiling.compiled import CompiledCondition
from gcrules.poses.compiling.compiled import compiled as of_condition
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.loci.locus import locus as computed
from gcrules.poses.loci.report import Locus
from gcrules.poses.maps.maps import singular_map as made
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.numbers.many import PoseNumbers
from gcrules.poses.numbers.report import PoseReport
from gcrules.poses.path_report import path as along
from gcrules.poses.paths.report import PathReport
from gcrules.poses.pose import pose as posed
from gcrules.poses.pose import singular as first_singular

__all__ = ["compiled", "locus", "path", "pose", "singular", "singular_map"]


@public
def pose(
    source: Source,
    at: Any = None,
    *,
    actuators: Any = None,
    quaternion: Any = None,
    rotation_vector: Any = None,
    euler: tuple[str, Any] | None = None,
    degrees: bool = False,
    about: str | Sequence[Any] = "centroid",
    threshold: Any = "0.5 deg",
    accuracy: str | float | None = None,
    nearest: bool | None = None,
    plugins: Folders = (),
) -> PoseReport | PoseNumbers | RobotPose | tuple[RobotPose, ...]:
    """How close a mechanism is to a singularity at one pose, or at N poses.

    `source` is what `load` takes, with coordinates; the answer for a platform is a `PoseReport` or, at N poses,
    `PoseNumbers` (arrays), for a robot of joints a `RobotPose` or a tuple of them. `at` is text as for `gcrules pose
    --at` ("z=5, roll=10deg", "0 0 5; euler zyx 20 0 10 deg"), a mapping from coordinates to numbers, a translation of
    three numbers, or N of these: a list or an array (N, 3). The turn beside it is one of `quaternion` (w, x, y, z),
    `rotation_vector`, `euler` = ("zyx", angles), each one row or N rows. Angles that are numbers are in radians unless
    `degrees`. All are from the pose of the file; the platform turns `about` the "centroid" of its joints, the file's
    "origin", or a point. A platform with fewer than six freedoms takes as many coordinates as it has; or its
    `actuators`: text as "q1=0.1, q2=5deg", a mapping, or all of them in the order of the file.

    `threshold` is an angle or, for platforms, a length ("2 deg", "5 mm"), `accuracy` a length up to which the joints'
    places are known. The search for the `nearest` singular poses, which takes a second or two, is for platforms and
    left out with False; with True, or an accuracy, a robot whose limbs are six legs is taken as a platform.

    Raises InputError for what is no pose, for degenerate robots, and where the robot does not assemble.
    """
    return posed(
        source,
        at,
        actuators=actuators,
        quaternion=quaternion,
        rotation_vector=rotation_vector,
        euler=euler,
        degrees=degrees,
        about=about,
        threshold=threshold,
        accuracy=accuracy,
        nearest=nearest,
        plugins=plugins,
    )


@public
def singular(
    source: Source,
    towards: Any = None,
    *,
    actuators: Any = None,
    degrees: bool = False,
    about: str | Sequence[Any] = "centroid",
    threshold: Any = "0.5 deg",
    plugins: Folders = (),
) -> PoseReport | RobotPose | None:
    """The first singular pose on the straight way from the pose of the file `towards` another, or None.

    Arguments and errors as for `pose`. For a platform none is missed: the superbracket along the way is an exact
    polynomial. For a robot of joints it is a search at samples, and what it does not find may be there all the same.
    """
    return first_singular(
        source, towards, actuators=actuators, degrees=degrees, about=about, threshold=threshold, plugins=plugins
    )


@public
def path(
    source: Source,
    poses: str | PathLike[str] | Sequence[Any],
    *,
    samples: int = 200,
    about: str | Sequence[Any] = "centroid",
    threshold: str = "0.5 deg",
) -> PathReport | RobotPath:
    """Every singular pose on a path through given poses, proved complete, and numbers along it (a `PathReport`, for a
    robot of joints a `RobotPath`).

    `source` and `about` are those of `pose`. `poses` is the name of a table as for `gcrules path --poses`, or two poses
    or more, each as for `pose`. Between two of them the centre moves on a straight line and the platform turns about
    one axis, the shorter way. `samples` is the number of places at which values are given; singular poses are found
    between them, too. `threshold` is an angle.

    For a robot of joints a pose may be "home", and all others name the same coordinates, which grow evenly between two
    of them; stretches in which nothing is proved are listed. Raises InputError for what is no path and for degenerate
    robots.
    """
    return along(source, poses, samples=samples, about=about, threshold=threshold)


@public
def locus(
    source: Source,
    over: str | Sequence[str] | None = None,
    *,
    fix: str | Mapping[str, Any] | None = None,
    at: Any = None,
    rotation: str = "quaternion",
    about: str | Sequence[Any] = "centroid",
    limit: int = 300,
) -> Locus:
    """The polynomial whose zeros are the robot's singular poses, exact, with degrees and factors (a `Locus`).

    `source` and `about` are those of `pose`, for platforms on six legs. The variables are x, y, z, the translation, and
    those of the `rotation`: "quaternion" (e0, e1, e2, e3, of any length), "rodrigues" (c1, c2, c3 = e1/e0, e2/e0,
    e3/e0), or a sequence of Euler angles such as "zyx" (t1, t2, t3, tangents of the half angles). `over` names those
    that stay free ("x, y", or "translation", "rotation", "all"), `fix` gives values to others ("x=0, e1=1/2", or a
    mapping), and the rest is taken from the pose `at`, text or a `Pose`; without `over` all that is not fixed is free.
    Polynomials of up to `limit` terms are searched for factors where no proof decides. Raises InputError for unknown
    variables, where nothing is free, and for degenerate robots.
    """
    return computed(source, over, fix=fix, at=at, rotation=rotation, about=about, limit=limit)


@public
def compiled(
    source: Source,
    expression: str | Expr | None = None,
    *,
    about: str | Sequence[Any] = "centroid",
    engine: str | None = None,
) -> CompiledCondition:
    """A condition compiled for many poses (a `CompiledCondition`): call it with arrays, it gives an array of values.

    `source` is what `load` takes, for platforms on six legs; for legs without coordinates the joints themselves are the
    arguments. The value is the superbracket of the legs as typed, or
    `expression`, any scalar of the robot's joints (a condition, a cofactor). Poses turn `about` the same centre as in
    `pose`. `engine` is "numba" or "numpy", with equal values; numba where it is installed if it is not given. Raises
    InputError for other expressions, for joints at infinity and for degenerate robots.
    """
    return of_condition(source, expression, about=about, engine=engine)


@public
def singular_map(
    source: Source,
    over: Sequence[Any],
    at: Any = None,
    *,
    about: str | Sequence[Any] = "centroid",
    limits: str | None = None,
    threshold: str = "0.5 deg",
    measure: str = "margin",
    work: str | PathLike[str] | None = None,
    restart: bool = False,
) -> SingularMap:
    """The singular poses over two or three coordinates (a `SingularMap`): arrays, curves or a surface, and what is
    proved free of them.

    `source`, `at` (one pose, for the other coordinates) and `about` are those of `pose`, for platforms on six legs.
    `over` lists coordinates with start:stop:number, as for `gcrules map --over`: ["x -2:2:201", "rz -90:90:181 deg"].
    `limits` is text such as "leg lengths 1..3"; `threshold` is an angle. `measure` is "margin", or "value" for the
    superbracket alone, which is quick. `work` names a folder for the chunks of a large map: a run that was interrupted
    goes on from there, unless `restart` throws them away; `.store.close()` removes it. Raises InputError for what makes
    no sense and for degenerate robots, LimitReached for maps that are too large.
    """
    return made(
        source,
        over,
        at,
        about=about,
        limits=limits,
        threshold=threshold,
        measure=measure,
        work=work,
        restart=restart,
    )
