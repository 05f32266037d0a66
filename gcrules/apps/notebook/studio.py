"""The studio from Python: its page and Python move the same robot."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gcrules.api.signatures import public
from gcrules.apps.studio.needs import of_studio
from gcrules.mechanisms.load import Folders, Source

if TYPE_CHECKING:
    from gcrules.apps.studio.window import StudioWindow

__all__ = ["studio"]


@public
def studio(
    source: Source, *, pose: Any = None, mode: str | None = None, browser: bool = True, plugins: Folders = ()
) -> StudioWindow:
    """Open the studio beside Python, with a robot that both move.

    `source` is what `gcrules.load` takes; legs get a sample shape. `pose` is where the platform begins, in all forms
    that `gcrules.pose` takes; `mode` is a working or an assembly mode as for `gcrules studio --mode`. The page opens in
    the `browser`, else where `link()` is opened. Setting the window's `pose` (of robots described by their joints
    `actuators` too) moves the page; read, it is what the page shows; `wait` and `observe` hear of its moves,
    `numbers()` is the full report there. It serves 127.0.0.1 only, until it is closed or Python ends.

    Raises InputError where the optional dependencies are missing, for poses that the robot does not reach, and for a
    robot whose home is another one than that of its file.
    """
    source_of, window = of_studio("sources:source_of"), of_studio("window:StudioWindow")
    shown: StudioWindow = window(source_of(source, mode, plugins), pose, browser=browser)
    return shown
