r"""Conditions compiled for many poses: a frozen value that is called with arrays and gives the values.

>>> from gcrules.mechanisms.description.platform_file import parse_platform
>>> robot = parse_platform('''
... legs: [ab, af, cb, cd, ed, ef]
... points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}
... ''')
>>> value = compiled(robot, engine="numpy")
>>> value([[0, 0, 0], [0, 0, -4], [1, 0, 0]]).tolist()
[-168960.0, 0.0, -168960.0]
>>> value
<CompiledCondition [[ab, af, cb, cd, ed, ef]]: 66 operations a pose, by numpy>
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress
from functools import lru_cache
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.expr import Expr, points_of, rank_of
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.language.text import text as as_text
from gcrules.conditions.analysis import Analysis
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.analyze import analyze_legs
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Source, load
from gcrules.mechanisms.mechanism import mechanism
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.batches import Batch, joint_batch, output, pose_batch
from gcrules.poses.compiling.compiled_limbs import CompiledLimbs, compiled_limbs
from gcrules.poses.compiling.engines import STEP, engine_named, runner
from gcrules.poses.compiling.roads import as_written, check_finite, joints_of, roads_of
from gcrules.poses.compiling.tape import Program
from gcrules.poses.compiling.tracing import trace
from gcrules.poses.methods import Methods, method

__all__ = ["CompiledCondition", "compiled", "compiled_motions"]

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class CompiledCondition:
    """The values of `expression` at poses: call it with arrays of poses, or `at_joints` with coordinates.

    `joints` are those that move; `unit` is that of lengths (the superbracket is a length⁹, a bracket a length³).
    `programs` are the operations for poses given by matrices, by quaternions and by joints, `roads` say what each was
    derived from; `engine` runs them: numpy or numba, with equal values.
    """

    expression: str
    joints: tuple[str, ...]
    unit: str
    engine: str
    programs: Mapping[str, Program]
    roads: Mapping[str, str]

    def __post_init__(self) -> None:
        object.__setattr__(self, "programs", FrozenMap(self.programs))
        object.__setattr__(self, "roads", FrozenMap(self.roads))

    def __call__(
        self, translations: Any = None, rotations: Any = None, *, quaternions: Any = None, out: Floats | None = None
    ) -> Floats:
        """The values at N poses, shape (N,), written to `out` if it is given.

        `translations` (N, 3) and `rotations` (N, 3, 3) or `quaternions` (N, 4), (w, x, y, z), are those of `gc.pose`;
        one row stands for all, none for no translation or no turn. Matrices are taken to be rotations as they are,
        quaternions of length 1 within 0.001 are normalised. Raises InputError for wrong shapes, NaN and infinity, and
        where a value is beyond floats; `out` may then hold a part of the values.
        """
        if "matrices" not in self.programs:
            raise InputError("these legs have no coordinates, so there are no poses", hint="use at_joints")
        if rotations is not None and quaternions is not None:
            raise InputError("rotations and quaternions", hint="give one of them")
        kind = "matrices" if quaternions is None else "quaternions"
        return self._run(kind, pose_batch(translations, rotations, quaternions), out)

    def at_joints(self, points: Any, *, out: Floats | None = None) -> Floats:
        """The values for coordinates of the joints that move: (N, 3) for each name, or (N, J, 3) as in `joints`."""
        return self._run("joints", joint_batch(points, self.joints), out)

    def _run(self, kind: str, batch: Batch, out: Floats | None) -> Floats:
        program = self.programs[kind]
        values = output(batch, out)
        run = runner(program, self.engine)
        for start in range(0, batch.number, STEP):
            stop = min(start + STEP, batch.number)
            first, second = batch.columns(start, stop)
            part = values[start:stop]
            run(first, second, part[None])
            batch.check(start, first, second, part, program.unused)
        return values

    def __repr__(self) -> str:
        count = next(iter(self.programs.values())).operations
        return f"<CompiledCondition {self.expression}: {count} operations a pose, by {self.engine}>"


@overload
def compiled(
    source: Structure | Platform | Analysis,
    expression: str | Expr | None = None,
    *,
    coordinates: str | Sequence[str] | None = None,
    about: str | Sequence[Any] = "centroid",
    engine: str | None = None,
) -> CompiledCondition: ...


@overload
def compiled(
    source: Source,
    expression: str | Expr | None = None,
    *,
    coordinates: str | Sequence[str] | None = None,
    about: str | Sequence[Any] = "centroid",
    engine: str | None = None,
) -> CompiledCondition | CompiledLimbs: ...


def compiled(
    source: Source,
    expression: str | Expr | None = None,
    *,
    coordinates: str | Sequence[str] | None = None,
    about: str | Sequence[Any] = "centroid",
    engine: str | None = None,
) -> CompiledCondition | CompiledLimbs:
    """A condition compiled for many poses: call it with arrays, it gives an array of values.

    `source` is what `load` takes. For platforms and robots on six legs it is a `CompiledCondition`; for legs without
    coordinates the joints themselves are the arguments. The value is the superbracket of the legs as typed, or
    `expression`, any scalar of the robot's joints (a condition, a cofactor). `engine` is "numba" or "numpy", with equal
    values; numba where it is installed if it is not given.

    For other robots of joints, and for all whose `coordinates` are named, it is a `CompiledLimbs`: the values of the
    condition's factors over these coordinates of the platform ("x, y, z"), or over all actuators ("q1, q2, q3"); by
    default over those that are free near home.

    Poses turn `about` the same centre as in `pose`. Raises InputError for other expressions, for coordinates that do
    not determine the pose, for joints at infinity and for degenerate robots.
    """
    chosen = engine_named(engine)
    loaded = load(source)
    if isinstance(loaded, Structure) or (isinstance(loaded, Analysis) and loaded.platform is None):
        if coordinates is not None:
            raise InputError(
                "legs alone have no coordinates of a pose", hint="leave coordinates out, and use at_joints"
            )
        return _condition(
            loaded if isinstance(loaded, Analysis) else analyze_legs(loaded, facts=False), None, expression, chosen
        )
    return method(_COMPILED, mechanism(loaded, about=about), "a compiled condition")(expression, coordinates, chosen)


def _of_legs(
    m: SixLegs, expression: str | Expr | None, coordinates: str | Sequence[str] | None, engine: str
) -> CompiledCondition:
    if coordinates is not None:
        raise InputError(
            "coordinates are named for robots of joints only",
            hint="poses of a platform on six legs are translations (N, 3) and rotations (N, 3, 3)",
        )
    return _condition(m.analysis, m.rig, expression, engine)


@lru_cache(maxsize=8)  # a map of a robot is followed by others of it
def compiled_motions(m: SixLegs, engine: str) -> CompiledCondition:
    """The superbracket at poses given by matrices, and by nothing else, which is traced in a third of the time."""
    return _condition(m.analysis, m.rig, None, engine, ("matrices",))


def _of_limbs(
    m: Limbs, expression: str | Expr | None, coordinates: str | Sequence[str] | None, engine: str
) -> CompiledCondition | CompiledLimbs:
    """By the superbracket of the legs where the limbs are six legs and no coordinates are named."""
    if coordinates is None:
        with suppress(InputError):
            return _of_legs(m.six_legs(), expression, None, engine)
    if expression is not None:
        raise InputError(
            "an expression is compiled for platforms on six legs only",
            hint="leave it out: for a robot of joints the factors of its condition are compiled",
        )
    return compiled_limbs(m, coordinates, engine)


_COMPILED: Methods[CompiledCondition | CompiledLimbs] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""


def _condition(
    analysis: Analysis,
    moving: MovingPlatform | None,
    expression: str | Expr | None,
    engine: str,
    kinds: Collection[str] | None = None,
) -> CompiledCondition:
    """With the programs of these kinds, of all for None."""
    structure = analysis.structure
    check_finite(structure)
    asked = structure.superbracket if expression is None else _scalar(expression, structure.names)
    roads = roads_of(analysis) if asked == structure.superbracket else [as_written(asked)]
    joints = joints_of(analysis, moving)
    found = {kind: trace(joints, kind, roads, asked) for kind in joints.kinds if kinds is None or kind in kinds}
    return CompiledCondition(
        expression=as_text(asked, names=structure.names),
        joints=joints.moving,
        unit=moving.unit if moving else "",
        engine=engine,
        programs={kind: program for kind, (_, program) in found.items()},
        roads={kind: name for kind, (name, _) in found.items()},
    )


def _scalar(expression: str | Expr, names: tuple[str, ...]) -> Expr:
    e = expression if isinstance(expression, Expr) else parse(expression, context=Context(4, names, ()))
    if e.step or rank_of(e) not in (None, 4):
        raise InputError("only scalars in space are compiled", hint="an expression of step 0 in rank 4")
    unknown = [n for n in points_of(e) if n not in names]
    if unknown:
        raise InputError(f"{', '.join(unknown)} are not joints of the robot", hint=f"its joints are {', '.join(names)}")
    return e
