"""The pose that Python and the pages of its studio share: whoever moves the robot, the others hear of it.

>>> shared = SharedPose({"translation": [0.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0]})
>>> shared.show({"translation": [1.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}, "a page")
>>> shared.now.version, shared.now.pose["translation"], shared.now.by
(2, [1.0, 0.0, 0.0], 'a page')
"""

from __future__ import annotations

import asyncio
import threading

from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = ["PYTHON", "SharedPose", "ShownPose"]

PYTHON = ""
"""Who shows a pose, where it is no page."""


@dataclass(frozen=True)
class ShownPose:
    """The pose on show, how many there have been, and which page (`PYTHON`: none) has brought it."""

    version: int
    pose: PoseJson
    by: str


class SharedPose:
    """Of a robot with so many `actuators` (a platform on six legs: none). May be used from any thread; pages are told
    in their own.
    """

    def __init__(self, pose: PoseJson, actuators: int = 0) -> None:
        self.actuators = actuators
        self._now = ShownPose(1, pose, PYTHON)
        self._changed = threading.Condition()
        self._pages: set[tuple[asyncio.AbstractEventLoop, asyncio.Event]] = set()

    @property
    def now(self) -> ShownPose:
        return self._now

    def show(self, pose: PoseJson, by: str = PYTHON) -> None:
        """Let all others move there. Raises InputError for a pose of another kind of mechanism."""
        given = len(pose.get("coordinates", ()))
        if given not in (0, self.actuators):
            raise InputError(f"{given} actuators, and the robot has {self.actuators}")
        with self._changed:
            self._now = ShownPose(self._now.version + 1, pose, by)
            self._changed.notify_all()
            for loop, event in self._pages:
                loop.call_soon_threadsafe(event.set)

    def wait(self, after: int, seconds: float | None = None) -> ShownPose | None:
        """The latest pose that a page has brought since a version; None where none comes in time."""

        def come() -> ShownPose | None:
            now = self._now
            return now if now.version > after and now.by != PYTHON else None

        with self._changed:
            return self._changed.wait_for(come, seconds)

    async def follow(self, after: int, page: str) -> ShownPose:
        """The latest pose since a version that this page has not brought itself, as soon as there is one."""
        event = asyncio.Event()
        waiting = (asyncio.get_running_loop(), event)
        with self._changed:
            self._pages.add(waiting)
        try:
            while True:
                event.clear()
                now = self._now
                if now.version > after and now.by != page:
                    return now
                await event.wait()
        finally:
            with self._changed:
                self._pages.discard(waiting)
