r"""What stands over the picture of a map: the mechanism, small, its name, and the coordinates that no axis shows."""

from __future__ import annotations

from collections.abc import Callable
from textwrap import wrap
from typing import Any

from matplotlib.figure import Figure
from matplotlib.transforms import Affine2D

from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.poses.maps.limb_task import LimbsTask
from gcrules.poses.maps.report import SingularMap
from gcrules.poses.maps.values import LegsTask
from gcrules.views.drawing.drawing import Drawing, scaled, without_text
from gcrules.views.drawing.pdf import artists
from gcrules.views.drawing.scene import draw_platform
from gcrules.views.robots.robot_drawing import robot_thumbnail

__all__ = ["HEAD", "add_head", "mechanism_drawing"]

HEAD = 0.95
"""The height of the head, in inches."""

_ROOM = (104.0, 62.0)  # points for the mechanism
_EDGE = 5.0
_LINE = 78  # letters


def add_head(made: Figure, m: SingularMap) -> None:
    """Draw the head into the uppermost `HEAD` inches of a figure, which are left free."""
    width, height = (72 * side for side in made.get_size_inches())
    drawn, where = mechanism_drawing(m), ""
    left = _EDGE + 8
    if drawn:
        factor = min(_ROOM[0] / drawn.width, _ROOM[1] / drawn.height)
        small = scaled(drawn, factor)
        top = height - _EDGE - (_ROOM[1] - small.height) / 2
        place = Affine2D().scale(1 / 72, -1 / 72).translate((_EDGE + (_ROOM[0] - small.width) / 2) / 72, top / 72)
        for artist in artists(small):
            artist.set_transform(place + made.dpi_scale_trans)
            made.add_artist(artist)
        left += _ROOM[0]
        where = f"drawn at {'home' if isinstance(m.task, LimbsTask) or not m.grid.moved else 'the given pose'}"
    fixed = f"fixed: {m.grid.fixed}".replace("-", "−") if m.grid.fixed else ""
    notes = [part for part in (fixed, where) if part]
    words = [line for part in notes for line in wrap(part, _LINE)]
    top = height - 0.5 * 72 * HEAD + 6.5 * len(words)
    made.text(left / width, top / height, m.grid.title, fontsize=12, ha="left", va="center")
    for k, line in enumerate(words, 1):
        made.text(left / width, (top - 3 - 12 * k) / height, line, fontsize=9, color="#5C636B", ha="left", va="center")


def mechanism_drawing(m: SingularMap) -> Drawing | None:
    """The mechanism without words, at the given pose of a platform, at home of a robot of joints; None where it cannot
    be drawn there.
    """
    try:
        return _DRAWN[type(m.task)](m.task)
    except InputError:
        return None


def _platform(task: LegsTask) -> Drawing:
    rig = task.grid.rig
    joints = {n: p[:3] for n, p in rig.exact(task.grid.at).items()}
    return without_text(
        draw_platform(rig.structure.oriented, joints, rig.structure.base, rig.structure.platform, key=False)
    )


def _robot(task: LimbsTask) -> Drawing:
    a = task.mechanism.analysis
    return robot_thumbnail(a, a.robot.values_at())


_Draw = Callable[[Any], Drawing]
_PAIRS: tuple[tuple[type, _Draw], ...] = ((LegsTask, _platform), (LimbsTask, _robot))
_DRAWN = FrozenMap(_PAIRS)
