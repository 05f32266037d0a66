"""The studio without a server: under Pyodide, its page asks the interpreter beside it, one message after the other.

What is answered is what exact algebra answers: there is no NumPy in a page.
"""

from __future__ import annotations

import secrets
from collections.abc import Callable
from typing import Any

from gcrules.apps.studio.faults import fault_view
from gcrules.apps.studio.gallery import classes_and_theorems
from gcrules.apps.studio.protocol.messages import (
    Misread,
    Request,
    fault_message,
    message_text,
    read_request,
    result_message,
    told_message,
)
from gcrules.apps.studio.protocol.study_views import FaultView, Hello
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.wire import Tell
from gcrules.apps.studio.worker import done
from gcrules.core.errors import InputError
from gcrules.core.version import __version__

__all__ = ["ANSWERED", "Answering"]

ANSWERED = ("hello", "gallery", "open", "bench", "complete", "script")
"""The methods that need no NumPy, at least of legs without dimensions."""
_OPENED = ("class", "legs")
_NEEDS = "Poses, margins, maps and robots with dimensions are computed with NumPy, which a web page does not have."
_HINT = 'pip install "gcrules[studio]", then gcrules studio: the same page with everything'


class Answering:
    """Answers for one page, with the subjects that it knows."""

    def __init__(self) -> None:
        self.instance = secrets.token_hex(8)
        self.subjects: dict[str, Subject] = {}

    def answer(self, message: str, send: Callable[[str], None]) -> str:
        """The reply to a message of `protocol.requests`; `send` takes the messages that go before it."""
        try:
            request = read_request(message)
        except Misread as misread:
            return message_text(fault_message(misread.id, fault_view(misread.fault)))
        kind, found = self._done(request, lambda what: send(message_text(told_message(request.id, what))))
        written = result_message(request, found) if kind == "done" else fault_message(request.id, found)
        return message_text(written)

    def _done(self, request: Request, tell: Tell) -> tuple[str, Any]:
        if request.do == "hello":
            return "done", self.hello()
        if request.do == "gallery":
            return "done", classes_and_theorems()
        source = request.args.get("source")
        if request.do not in ANSWERED or (source is not None and source["kind"] not in _OPENED):
            return "fault", needs_installation()
        kind, found, _ = done((request.do, request.args, None), self.subjects, tell)
        return kind, found

    def hello(self) -> Hello:
        return {"version": __version__, "instance": self.instance, "opened": None, "shared": False, "guide": False}


def needs_installation() -> FaultView:
    """What is said of everything else."""
    return fault_view(InputError(_NEEDS, hint=_HINT))
