"""What answers requests: the table of methods, the subjects that are known, the workers."""

from __future__ import annotations

import asyncio
import gc
import secrets
from collections import deque
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from importlib import import_module
from typing import TYPE_CHECKING, Any, cast

from gcrules.apps.studio.parts import given_to
from gcrules.apps.studio.pool import Pool
from gcrules.apps.studio.protocol.answer_views import Followed, Shown
from gcrules.apps.studio.protocol.messages import Part
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.apps.studio.protocol.requests import FollowArgs, ShowArgs, SourceJson
from gcrules.apps.studio.protocol.study_views import Hello
from gcrules.apps.studio.shared_pose import SharedPose
from gcrules.apps.studio.wire import Tell, key_of
from gcrules.core.budget import Budget, within
from gcrules.core.errors import InputError
from gcrules.core.version import __version__

if TYPE_CHECKING:
    from gcrules.apps.studio.subject import Subject

__all__ = ["Service"]

_KEPT = 24
_ENGINE = "gcrules.apps.studio.answers"  # loaded beside the first page, not before it


def _numbers(
    name: str, subject: Subject, args: Mapping[str, Any], running: list[Budget], give: Callable[[Any], None]
) -> Any:
    with within(METHODS[name].seconds) as budget, given_to(give):
        running.append(budget)
        return import_module(_ENGINE).answer(name, subject, args)


def _load(alone: bool) -> None:
    """Load the engine. In a process that does nothing else what it consists of stays: the garbage collector, which
    would stop sliders for 30 ms to look through all of it, leaves it out.
    """
    deque(import_module(_ENGINE).loading(), maxlen=0)
    if alone:
        gc.freeze()


class Service:
    """Answers for all pages; `opened` is the source that the command, or Python, was given, `shared` its pose where
    Python follows it, `folders` those of plugins; `guide` says whether the guide is served beside the page.
    """

    def __init__(
        self,
        opened: SourceJson | None = None,
        shared: SharedPose | None = None,
        folders: tuple[str, ...] = (),
        *,
        guide: bool = False,
    ) -> None:
        self.opened = opened
        self.guide = guide
        self.shared = shared
        self.folders = folders
        self.instance = secrets.token_hex(8)
        self.pool = Pool()
        self.numbers = ThreadPoolExecutor(2, "numbers")
        self.subjects: dict[str, Subject] = {}
        self.gallery: asyncio.Task[Any] | None = None

    def hello(self) -> Hello:
        return {
            "version": __version__,
            "instance": self.instance,
            "opened": self.opened,
            "shared": self.shared is not None,
            "guide": self.guide,
        }

    async def follow(self, args: FollowArgs) -> Followed:
        if self.shared is None:
            raise InputError("nobody shares a pose with this studio", hint="gcrules.studio opens one that does")
        found = await self.shared.follow(args["after"], args["page"])
        return {"after": found.version, "pose": found.pose}

    def show(self, args: ShowArgs) -> Shown:
        ours = self.shared is not None and self.opened is not None and key_of(args["source"]) == key_of(self.opened)
        if ours and self.shared is not None:
            self.shared.show(args["pose"], args["page"])
        return {"shared": ours}

    async def answer(self, name: str, args: Mapping[str, Any], tell: Tell) -> Any:
        """The result of a method whose arguments were checked. Raises GcrulesError; cancelling it ends its worker."""
        if name == "hello":
            return self.hello()
        if name == "follow":
            return await self.follow(cast("FollowArgs", args))
        if name == "show":
            return self.show(cast("ShowArgs", args))
        if name == "gallery":
            return await self._gallery()
        method = METHODS[name]
        if method.folders:
            args = {**args, "folders": self.folders}
        source = args.get("source")
        known = self._known(source)
        if method.where == "numbers":
            if known is None:
                _, known = await self.pool.run(("subject", {"source": source}, None), METHODS["open"].seconds, tell)
                self._keep(source, known)
            loop = asyncio.get_running_loop()
            running: list[Budget] = []

            def give(part: Any) -> None:
                loop.call_soon_threadsafe(tell, Part(part))

            try:
                return await loop.run_in_executor(self.numbers, _numbers, name, known, args, running, give)
            except asyncio.CancelledError:
                for budget in running:
                    budget.cancel()
                raise
        result, subject = await self.pool.run((name, args, known), method.seconds, tell)
        self._keep(source, subject)
        return result

    async def _gallery(self) -> Any:
        """It is one for all pages, so that none that leaves ends the work on it; after a fault it is tried again."""
        if self.gallery is None or (self.gallery.done() and self.gallery.exception() is not None):
            self.gallery = self._made_gallery()
        return await asyncio.shield(self.gallery)

    def _made_gallery(self) -> asyncio.Task[Any]:
        async def made() -> Any:
            found, _ = await self.pool.run(("gallery", {}, None), METHODS["gallery"].seconds, lambda _: None)
            return found

        return asyncio.ensure_future(made())

    def _known(self, source: SourceJson | None) -> Subject | None:
        if source is None:
            return None
        key = key_of(source)
        found = self.subjects.pop(key, None)
        if found is not None:
            self.subjects[key] = found  # the latest stand last
        return found

    def _keep(self, source: SourceJson | None, subject: Subject | None) -> None:
        if source is not None and subject is not None:
            self.subjects[key_of(source)] = subject
            while len(self.subjects) > _KEPT:
                self.subjects.pop(next(iter(self.subjects)))

    async def start(self) -> None:
        """Have the gallery made for the first page while the browser opens, and the engine loaded after that."""
        self.gallery = self._made_gallery()
        self.gallery.add_done_callback(self._go_on)

    def _go_on(self, made: asyncio.Task[Any]) -> None:
        if not made.cancelled():
            made.exception()  # a fault is told to the page that asks
            asyncio.get_running_loop().run_in_executor(self.numbers, _load, self.shared is None)

    async def close(self) -> None:
        if self.gallery is not None:
            self.gallery.cancel()
        self.numbers.shutdown(wait=False, cancel_futures=True)
        await self.pool.close()
