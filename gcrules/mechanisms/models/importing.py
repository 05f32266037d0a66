"""From a model of links and joints to a robot file: the whole way, with an account of it."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace
from os import PathLike, fspath
from os.path import isfile
from pathlib import PurePath
from typing import Any, NoReturn

import numpy as np

from gcrules.core.errors import FileError, GcrulesError, InputError
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.agreement import deviation, generic
from gcrules.mechanisms.models.chains_between import Bars, Chain, Poses, limbs_between
from gcrules.mechanisms.models.driving import check_driven, driven_of, ratios_of
from gcrules.mechanisms.models.exact import exact
from gcrules.mechanisms.models.family_found import LEVELS, Naming
from gcrules.mechanisms.models.graph import Ends, Graph, graph_of
from gcrules.mechanisms.models.imported import Imported, ImportedLimb
from gcrules.mechanisms.models.merging import Ratios, apart, parts_of
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.motions import Motion, motions_of
from gcrules.mechanisms.models.moving import Moving
from gcrules.mechanisms.models.planes import as_hinges, balls_in_plane, normal_of, turn_to_z
from gcrules.mechanisms.models.reading import parse_model, read_model
from gcrules.mechanisms.models.robot_text import Drawn, robot_text
from gcrules.mechanisms.models.snapping import TOLERANCE, moved_between, size_of, snapped
from gcrules.mechanisms.robot import Robot
from gcrules.screws import JOINTS

__all__ = ["import_file", "import_model", "import_text", "robot_of_file", "robot_of_text"]

_SEEDS = (1, 2, 3)
_MOST = 400  # joints between base and platform


def robot_of_file(
    path: str | PathLike[str],
    closures: str | PathLike[str] | None = None,
    *,
    base: str | None = None,
    platform: str | None = None,
    actuators: Iterable[str] = (),
    tolerance: float = TOLERANCE,
) -> Robot:
    """The robot that a model file shows; see `import_file`."""
    return import_file(path, closures, base=base, platform=platform, actuators=actuators, tolerance=tolerance).robot


def robot_of_text(text: str, filename: str = "<input>") -> Robot:
    """The robot that the text of a model shows; see `import_text`."""
    return import_text(text, filename).robot


def import_text(text: str, filename: str = "<input>") -> Imported:
    """Read the text of a model, which includes no other files. Raises FileError as `import_file`."""
    return _imported(parse_model(text, filename))


def import_file(
    path: str | PathLike[str],
    closures: str | PathLike[str] | None = None,
    *,
    base: str | None = None,
    platform: str | None = None,
    actuators: Iterable[str] = (),
    tolerance: float = TOLERANCE,
) -> Imported:
    """Read a model file (URDF with a file of closures, SDF, MJCF) as a robot file. Beside robot.urdf the closures are
    those of robot-closures.yaml, if there is such a file and no other is named. Raises FileError with its place for a
    file at fault, else as `import_model` does.
    """
    beside = PurePath(fspath(path))
    own = beside.with_name(f"{beside.stem}-closures.yaml")
    if closures is None and beside.suffix.lower() == ".urdf" and isfile(own):
        closures = own
    model = read_model(path, closures)
    return _imported(model, base=base, platform=platform, actuators=actuators, tolerance=tolerance)


def _imported(model: Model, **options: Any) -> Imported:
    """`import_model`, with faults as those of the file."""
    try:
        return import_model(model, **options)
    except FileError:
        raise
    except InputError as fault:
        hint = fault.hint
        if model.format == "urdf" and not any(j.closing for j in model.joints):
            hint = f"{hint + '; ' if hint else ''}loops of a model in URDF are closed by a second file: --closures FILE"
        raise FileError(fault.message, filename=model.filename, hint=hint) from fault


def import_model(
    model: Model,
    *,
    base: str | None = None,
    platform: str | None = None,
    actuators: Iterable[str] = (),
    tolerance: float = TOLERANCE,
) -> Imported:
    """A model as a robot file. Places and axes that coincide, meet, or are parallel or perpendicular within the
    tolerance (parts of its size, radians) are made so.

    Raises InputError, with what can be done, where there is no platform with limbs, where it is in doubt, for joints
    that have no meaning in a robot file, and where the wrenches of the file do not agree with the joints of the model.
    """
    if not 0 < tolerance <= 0.01:
        raise InputError(f"the tolerance {tolerance:g} is not above 0 and at most 0.01")
    graph = graph_of(model)
    ends = graph.ends(base, platform)
    names = graph.between(ends.base, ends.platform)
    if len(names) > _MOST:
        raise InputError(
            f"{len(names)} joints are between {ends.base} and {ends.platform}; more than {_MOST} are not read"
        )
    ratios = ratios_of(model, names)
    driven = driven_of(graph, names, ratios, tuple(actuators))
    return _Import(graph, ends, names, ratios, driven, tolerance).found()


class _Import:
    def __init__(
        self, graph: Graph, ends: Ends, names: frozenset[str], ratios: Ratios, driven: tuple[str, ...], tolerance: float
    ) -> None:
        self.graph = graph
        self.model = graph.model
        self.ends = ends
        self.ratios = ratios
        self.driven = driven
        self.tolerance = tolerance
        self.read = motions_of(graph, names, driven)
        self.notes = [*graph.notes, *getattr(graph.model, "notes", ())]
        self.couplings = [c for c in graph.model.couplings if c.joint in ratios]
        self.pair = (ends.base, ends.platform)
        self.motions = snapped(self.read, self.pair, tolerance)
        if balls := balls_in_plane(self.motions):
            self.read = as_hinges(self.read, balls)
            self.motions = snapped(self.read, self.pair, tolerance)
            self.notes.append(balls.text)
        self.plane = self._plane()
        self.motions, self.exact = exact(self.motions, self.pair, size_of(self.motions), tolerance)
        self.moved = moved_between(self.read, self.motions)
        self.size = size_of(self.motions)

    def _plane(self) -> bool:
        """Whether all motions are in one plane; its normal is turned to z, and the plane is z = 0."""
        normal = normal_of(self.motions)
        if normal is None:
            return False
        if abs(normal[2]) < 1:
            turn = turn_to_z(normal)
            self.read = tuple(replace(m, at=turn @ m.at, axis=turn @ m.axis) for m in self.read)
            self.motions = snapped(self.read, self.pair, self.tolerance)
            self.notes.append("the plane of its motion was turned to that of x and y")
        self.motions = tuple(replace(m, at=m.at * [1, 1, 0]) for m in self.motions)
        return True

    def found(self) -> Imported:
        moving = Moving(self.motions, self.ends.base, self.couplings, self.size)
        values = [v for v in (moving.near_home(seed) for seed in _SEEDS) if v is not None]
        if not values:
            raise InputError(
                f"{self.ends.platform} cannot move: no other configuration was found in which all loops are closed",
                hint="a loop may be held together by a joint that the file leaves out",
            )
        poses = [_lengths(moving.poses(v), self.size) for v in (moving.home, *values)]
        mobility = min(len(moving.twists(self.ends.platform, v)) for v in values)
        at_home = len(moving.twists(self.ends.platform, moving.home))
        if at_home > mobility:
            self.notes.append(f"at home the platform has {at_home} freedoms, elsewhere {mobility}: home is singular")
        if mobility == 0:
            raise InputError(f"{self.ends.platform} does not move: its limbs hold it with their joints free")
        check_driven(self.ends.platform, self.motions, self.driven, self.ratios, mobility)
        limbs = limbs_between(self.motions, *self.pair, poses)
        drawn = self._drawn(limbs, poses)
        own = [_motions_in(chains) for chains in limbs]
        for joint, (leader, _) in self.ratios.items():
            if not any({joint, leader} <= {m.joint for m in motions} for motions in own):
                raise InputError(
                    f"joint {joint} follows joint {leader} of another limb, which a robot file cannot express",
                    hint="each limb is distinguished only by what it does to the platform",
                )
        return self._written(drawn, own, moving, values, mobility)

    def _drawn(self, limbs: Sequence[Sequence[Chain]], poses: Poses) -> list[Drawn]:
        every = [[parts_of(c, poses, self.ratios) for c in chains] for chains in limbs]
        flat = iter(apart([parts for own in every for parts in own], self.size))
        return [Drawn(tuple((c, tuple(next(flat))) for c in chains)) for chains in limbs]

    def _written(
        self,
        drawn: Sequence[Drawn],
        motions: Sequence[Sequence[Motion]],
        moving: Moving,
        values: Sequence[Floats],
        mobility: int,
    ) -> Imported:
        """With the fewest relations with which the family moves as the model does."""
        faults: list[GcrulesError] = []
        limits = dict(self._amounts(drawn, motions))
        for level in LEVELS:
            naming = Naming([d.parts for d in drawn], self.size, level, plane=self.plane)
            text, order = robot_text(
                drawn,
                naming,
                self.ratios,
                self.pair,
                title=_title(self.model),
                note=self._note(limits),
                mobility=mobility,
                limits=limits,
            )
            try:
                robot = parse_robot(text, self.model.filename, _id(self.model))
            except GcrulesError as wrong:
                faults.append(wrong)
                continue
            sorted_motions = [motions[k] for k in order]
            at = [_values_of(moving, own, values[0]) for own in sorted_motions]
            if differs := generic(robot, sorted_motions, self.couplings, at, self.pair, self.size):
                faults.append(InputError(differs))
                continue
            read = {(m.joint, m.place): m for m in self.read}
            before = [
                [replace(m, at=read[m.joint, m.place].at, axis=read[m.joint, m.place].axis) for m in own]
                for own in sorted_motions
            ]
            moved = max((max(m.distance / self.size, m.angle) for m in self.moved), default=0.0)
            most = deviation(robot, sorted_motions, before, self.couplings, self.pair, self.size, moved)
            return self._account(robot, text, [drawn[k] for k in order], most, level.words)
        self._refuse(faults)

    def _refuse(self, faults: Sequence[GcrulesError]) -> NoReturn:
        """With the reason that the fewest faults have, the first of them."""
        several = min(([*getattr(f, "faults", (f,))] for f in faults), key=len)
        raise InputError(
            f"no robot file was found that moves as the model does: {several[0].message}",
            hint="robot files have limbs of up to 12 joints with one relation for each point and direction; "
            "write this one by hand, or name another --platform",
        ) from faults[0]

    def _account(self, robot: Robot, text: str, drawn: Sequence[Drawn], most: float, words: str) -> Imported:
        used = {m.joint for m in self.motions}
        bars = [p for d in drawn for p in d.parts if JOINTS[p.kind].has_bars and len(p.joints) > 2]
        if bars:
            kinds, count = " and ".join(sorted({p.kind for p in bars})), len(bars[0].slots[0].values)
            self.notes.append(
                f"{kinds} are bars that stay parallel, as they do in the {count} configurations that were computed;"
                " what is said about the robot holds while they do"
            )
        limbs = tuple(
            ImportedLimb(spec.name, spec.chain, tuple((p.kind + p.driven, p.joints) for p in d.parts))
            for spec, d in zip(robot.limbs, drawn, strict=True)
        )
        return Imported(
            robot,
            text,
            self.model.filename,
            self.model.format,
            *self.pair,
            self.ends.why,
            limbs,
            self.driven,
            tuple((n, *limits) for n, limits in self._limits()),
            tuple(j.name for j in self.graph.joints if j.name not in used),
            self.moved,
            self.exact,
            self.tolerance,
            most,
            self.size,
            words,
            tuple(self.notes),
        )

    def _limits(self) -> Iterator[tuple[str, tuple[float, float]]]:
        for j in self.model.joints:
            if j.name in self.driven and j.limits is not None:
                yield j.name, j.limits

    def _amounts(
        self, drawn: Sequence[Drawn], motions: Sequence[Sequence[Motion]]
    ) -> Iterator[tuple[str, tuple[float, float]]]:
        """Limits of joints by themselves, along the axes of the model, as seen from the base."""
        starts = {(m.joint, m.place): m.start for m in self.motions}
        known = dict(self._limits())
        for d, own in zip(drawn, motions, strict=True):
            alone = {p.joints[0] for p in d.parts if not p.merged}
            for m in own:
                if m.driven and m.joint in alone and m.joint in known and known[m.joint][0] < known[m.joint][1]:
                    low, high = known[m.joint]
                    yield m.joint, (low, high) if m.start == starts[m.joint, m.place] else (-high, -low)

    def _note(self, written: Collection[str]) -> str:
        """With the limits that are not written as such: of joints that have become one with others, and of no width."""
        own = [f"{n} from {low:.6g} to {high:.6g}" for n, (low, high) in self._limits() if n not in written]
        limits = f"; limits of the model from home, in metres and radians: {', '.join(own)}" if own else ""
        name = PurePath(self.model.filename).name
        return f"imported from {name}, with {self.ends.platform} as the platform{limits}"


def _lengths(poses: dict[str, Floats], size: float) -> dict[str, Floats]:
    """Poses with lengths in metres again."""
    scale = np.ones((4, 4))
    scale[:3, 3] = size
    return {body: pose * scale for body, pose in poses.items()}


def _values_of(moving: Moving, motions: Sequence[Motion], values: Floats) -> Floats:
    places = {(m.joint, m.place): own for m, own in zip(moving.motions, moving.own, strict=True)}
    starts = {(m.joint, m.place): m.start for m in moving.motions}
    found = []
    for m in motions:
        own = values[places[m.joint, m.place]]
        found.append(own if m.start == starts[m.joint, m.place] else -own)
    return np.concatenate(found)


def _motions_in(chains: Sequence[Chain]) -> list[Motion]:
    found: list[Motion] = []
    for chain in chains:
        for item in chain.items:
            found += item.inner if isinstance(item, Bars) else (item,)
    return found


def _title(model: Model) -> str:
    return model.name.replace("%", " ").strip() or PurePath(model.filename).stem


def _id(model: Model) -> str:
    return PurePath(model.filename).stem or "robot"
