"""A robot as the text of a model file, of whatever format.

>>> print(model_text("3-rps", "mjcf").splitlines()[0])
<mujoco model="3-rps">
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.load import Source, load
from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.of_robot import model_of
from gcrules.mechanisms.robot import Robot
from gcrules.views.models.mjcf import mjcf_text
from gcrules.views.models.urdf import urdf_files

__all__ = ["MODEL_FORMATS", "model_text"]

MODEL_FORMATS: Mapping[str, Callable[[Model], str]] = FrozenMap(
    {
        "mjcf": mjcf_text,
        "urdf": lambda model: urdf_files(model).urdf,
        "closures": lambda model: urdf_files(model).closures,
    }
)


def model_text(source: Source, format: str = "mjcf", *, unit: str = "") -> str:
    """A robot with dimensions as the text of a model file: "mjcf", "urdf", or "closures", the file beside one in URDF
    that closes its loops and says what is driven.

    `source` is what `load` takes; its lengths are in `unit` (m, mm, in …), by default in that of its file or else in
    metres. Raises InputError for other formats, for robots without dimensions or joints, and for cables.
    """
    if format not in MODEL_FORMATS:
        raise InputError(f"models are not written in {format[:40]!r}", hint=f"one of {', '.join(MODEL_FORMATS)}")
    loaded = load(source)
    if isinstance(loaded, RobotAnalysis):
        loaded = loaded.robot
    if not isinstance(loaded, Robot | Platform):
        raise InputError(
            "legs without coordinates have no dimensions that a model could hold",
            hint="give a robot of joints, or a geometry file",
        )
    return MODEL_FORMATS[format](model_of(loaded, unit))
