r"""Platform files, written, and with other dimensions: the text of a file changes in its numbers only.

>>> text = "legs: [[A, a], [A, b], [B, b], [B, c], [C, c], [C, a]]\npoints:\n  a: [1, 0, 5]  # measured\n" + "".join(
...     f"  {n}: {p}\n" for n, p in zip("bcABC", ([0, 1, 5], [-1, 0, 5], [3, 0, 0], [0, 3, 0], [-3, 0, 0])))
>>> print(with_dimensions(text, "robot.yaml", {"a": ("1.5", "", "16/3")}).splitlines()[2])
  a: [1.5, 0, 16/3]  # measured
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

from gcrules.core.errors import InputError, Span
from gcrules.core.hints import near
from gcrules.core.yaml_file import Document, Node
from gcrules.mechanisms.description.platform_file import parse_platform

__all__ = ["platform_text", "with_dimensions"]

_PLAIN = re.compile(r"[-+]?[\d./eE+-]+")


def platform_text(title: str, note: str, unit: str, legs: Any, points: Mapping[str, Any], limits: str = "") -> str:
    """A platform file; points that no leg names are left out."""
    used = dict.fromkeys(n for leg in legs for n in leg)
    lines = [f"title: {_quoted(title)}"]
    lines += [f"note: {_quoted(note)}"] if note else []
    lines += [f"units: {unit}"] if unit else []
    lines += [f"limits: {_quoted(limits)}"] if limits else []
    written = {n: ", ".join(map(_number, points[n])) for n in used if n in points}
    lines += ["legs:" if legs else "legs: []", *(f"  - [{_quoted(a)}, {_quoted(b)}]" for a, b in legs)]
    lines += ["points:" if written else "points: {}", *(f"  {_quoted(n)}: [{c}]" for n, c in written.items())]
    return "\n".join(lines) + "\n"


def with_dimensions(text: str, filename: str, points: Mapping[str, Sequence[str]], limits: str | None = None) -> str:
    """The text of a platform file in which points have other coordinates, as they are written ("" keeps one), and legs
    other `limits` ("" for none, None keeps them). Comments and all else stay.

    Raises InputError for a point that is not there, FileError with the faults of the text that comes of it.
    """
    root = Document.parse(text, filename).root
    places = {key.text: value for key, value in _values(root)["points"].entries()}
    changes: list[tuple[Span, str]] = []
    for name, coordinates in points.items():
        if name not in places:
            raise InputError(f"there is no point {name!r}", hint=near(name, places))
        items = places[name].sequence(length=3)
        changes += [(item.span, _coordinate(c)) for item, c in zip(items, coordinates, strict=True) if c]
    if limits is not None:
        changes += _limits(root, text, limits)
    for span, new in sorted(changes, key=lambda change: change[0].start, reverse=True):
        text = text[: span.start] + new + text[span.end :]
    parse_platform(text, filename)
    return text


def _values(root: Node) -> dict[str, Node]:
    return {key.text: value for key, value in root.entries()}


def _limits(root: Node, text: str, limits: str) -> list[tuple[Span, str]]:
    """The change of the key, or a line of its own before the others; no line where there are none any more."""
    keys = {key.text: (key, value) for key, value in root.entries()}
    if "limits" not in keys:
        first = root.children[0].span.start
        flow = text[root.span.start : root.span.start + 1] == "{"
        line = f'"limits": {_quoted(limits)}, ' if flow else f"limits: {_quoted(limits)}\n"
        return [(Span(first, first), line)] if limits else []
    key, value = keys["limits"]
    if limits:
        return [(value.span, _quoted(limits))]
    rest = re.compile(r"[ \t]*(, ?|(#[^\n]*)?(\n|$))?").match(text, value.span.end)
    return [(Span(key.span.start, rest.end() if rest else value.span.end), "")]


def _coordinate(text: str) -> str:
    return text if _PLAIN.fullmatch(text) else _quoted(text)


def _quoted(text: str) -> str:
    """A text as YAML reads it back, whatever it holds."""
    return json.dumps(text, ensure_ascii=False)


def _number(c: Any) -> str:
    """A number as the file format reads it: decimals as they are, fractions as quotients."""
    if isinstance(c, float):
        return f"{c:.12g}" if 1e-4 <= abs(c) < 1e15 or not c else f"{c:.15f}".rstrip("0").rstrip(".")
    return str(c)
