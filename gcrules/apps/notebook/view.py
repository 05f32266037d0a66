"""A robot in a notebook cell: the 3D viewer as a widget, with the pose in both worlds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gcrules.api.signatures import public
from gcrules.core.deferred import resolved
from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze
from gcrules.mechanisms.load import Folders, Source

if TYPE_CHECKING:
    from gcrules.apps.notebook.widget import RobotWidget

__all__ = ["view"]


@public
def view(source: Source, *, pose: Any = None, plugins: Folders = ()) -> RobotWidget:
    """A widget that shows a robot in 3D and moves its platform, for Jupyter and other notebooks.

    `source` is what `gcrules.load` takes; legs get a sample shape, and a robot described by its joints moves by its
    actuators unless it is a platform on six legs. `pose` is where the platform begins: text as for `gcrules pose`, a
    `Pose`, or a mapping with `translation` and `quaternion`; turns are about the centroid of the platform's joints.
    The widget's traits `pose`, `margin` and `verdict` follow the platform, and setting `pose` moves it; `numbers()` is
    the full report there.

    Raises InputError where the optional dependency is missing, and for lines that are no legs between finite joints.
    """
    try:
        widget = resolved("gcrules.apps.notebook.widget:RobotWidget")
    except ImportError as fault:
        raise InputError(
            f"a widget needs the package {fault.name}, which is not installed",
            hint='pip install "gcrules[widget]"',
        ) from fault
    shown: RobotWidget = widget(analyze(source, plugins=plugins), pose)
    return shown
