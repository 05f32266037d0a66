"""What comes of the import of a model: a robot file, and an account of how it was made."""

from __future__ import annotations

from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.mechanisms.models.snapping import Moved
from gcrules.mechanisms.robot import Robot

__all__ = ["Imported", "ImportedLimb"]


@dataclass(frozen=True)
class ImportedLimb:
    """A limb of the robot file: its name there, its joints in short, and for each of them the joints of the model."""

    name: str
    chain: str
    joints: tuple[tuple[str, tuple[str, ...]], ...]

    @property
    def merged(self) -> tuple[tuple[str, tuple[str, ...]], ...]:
        """The joints that several of the model have become."""
        return tuple((kind, names) for kind, names in self.joints if len(names) > 1)


@dataclass(frozen=True, repr=False)
class Imported(Shown):
    """A robot file made from a model, its text `yaml` and what it says, with an account of how it was made.

    `why` says how the platform was chosen; `limits` are those of the driven joints, from home, in metres and radians;
    `left_out` are joints that hold nothing between base and platform; `moved` says by how much joints were moved to
    make them exact, `exact` what was made to hold beyond common points and axes, in words, `size` being that of the
    model in metres; `deviation` how well the wrenches at home agree with the
    joints of the model as they were read (power of unit wrenches on unit twists, lengths in parts of the size);
    `relations` how far relations had to be sought.
    """

    robot: Robot
    yaml: str
    filename: str
    format: str
    base: str
    platform: str
    why: str
    limbs: tuple[ImportedLimb, ...]
    actuated: tuple[str, ...]
    limits: tuple[tuple[str, float, float], ...]
    left_out: tuple[str, ...]
    moved: tuple[Moved, ...]
    exact: tuple[str, ...]
    tolerance: float
    deviation: float
    size: float
    relations: str
    notes: tuple[str, ...] = ()

    @property
    def farthest(self) -> tuple[float, float]:
        """The largest distance, in metres, and the largest angle by which a joint was moved."""
        return max((m.distance for m in self.moved), default=0.0), max((m.angle for m in self.moved), default=0.0)

    @property
    def drives(self) -> tuple[tuple[str, str], ...]:
        """The actuators of the robot file, "q1", with the joints of the model that they are."""
        starred = [names for limb in self.limbs for kind, names in limb.joints if "*" in kind]
        return tuple((f"q{n}", " = ".join(names)) for n, names in enumerate(starred, 1))

    def to_json(self) -> dict[str, Any]:
        return {
            "robot": self.robot.id,
            "file": self.filename,
            "format": self.format,
            "base": self.base,
            "platform": self.platform,
            "chosen": self.why,
            "chain": self.robot.chain,
            "mobility": self.robot.mobility,
            "limbs": [
                {"name": limb.name, "chain": limb.chain, "joints": [{"kind": k, "of": [*n]} for k, n in limb.joints]}
                for limb in self.limbs
            ],
            "actuated": [*self.actuated],
            "drives": dict(self.drives),
            "limits": {name: [low, high] for name, low, high in self.limits},
            "left_out": [*self.left_out],
            "moved": [{"joint": m.joint, "distance": m.distance, "angle": m.angle} for m in self.moved],
            "exact": [*self.exact],
            "tolerance": self.tolerance,
            "size": self.size,
            "deviation": self.deviation,
            "relations": self.relations,
            "notes": [*self.notes],
            "yaml": self.yaml,
        }
