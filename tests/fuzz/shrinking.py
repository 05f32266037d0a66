"""Making an input small that shows a fault: what can be left out is left out."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from time import monotonic
from typing import Any

from .case import Case

__all__ = ["shrunk"]

_WORD = re.compile(r"\w+|\s+|[^\w\s]")


def shrunk(case: Case, shows: Callable[[Case], bool], *, seconds: float = 20.0) -> Case:
    """The smallest input reached in this time by leaving out options, files, lines, words and characters."""
    until = monotonic() + seconds
    progress = True
    while progress and monotonic() < until:
        progress = False
        for smaller in _smaller(case):
            if monotonic() > until:
                break
            if shows(smaller):
                case, progress = smaller, True
                break
    return case


def _smaller(case: Case) -> Iterator[Case]:
    argv = case.argv
    for i in range(1, len(argv)):
        if argv[i].startswith("-") and i + 1 < len(argv):
            yield replace(case, argv=(*argv[:i], *argv[i + 2 :]))
        yield replace(case, argv=(*argv[:i], *argv[i + 1 :]))
    for smaller_data in _values(case.data):
        yield replace(case, data=smaller_data)
    for name in case.files:
        yield replace(case, files={n: t for n, t in case.files.items() if n != name})
    for name, text in case.files.items():
        for smaller in _texts(text):
            yield replace(case, files={**case.files, name: smaller})
    for smaller in _texts(case.stdin):
        yield replace(case, stdin=smaller)
    for i in range(1, len(argv)):
        for smaller in _texts(argv[i]):
            if smaller:
                yield replace(case, argv=(*argv[:i], smaller, *argv[i + 1 :]))


def _values(data: Any) -> Iterator[Any]:
    """The same with an entry less in a list, or in the options of a call."""
    for key in ("kwargs", "args", "messages", "requests"):
        held = data.get(key, ()) if isinstance(data, dict) else ()
        if isinstance(held, dict):
            yield from ({**data, key: {k: v for k, v in held.items() if k != name}} for name in held)
        else:
            yield from ({**data, key: [*held[:i], *held[i + 1 :]]} for i in range(len(held)))


def _texts(text: str) -> Iterator[str]:
    """Texts with less in them: large pieces are left out first."""
    seen = {text}
    for parts in (text.splitlines(keepends=True), _WORD.findall(text), list(text) if len(text) <= 60 else []):
        for fewer in _fewer(parts):
            found = "".join(fewer)
            if found not in seen:
                seen.add(found)
                yield found


def _fewer(parts: Sequence[str]) -> Iterator[Sequence[str]]:
    size = len(parts)
    while size:
        for at in range(0, len(parts), size):
            yield [*parts[:at], *parts[at + size :]]
        size //= 2
