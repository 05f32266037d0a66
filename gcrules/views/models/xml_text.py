"""XML as text: elements with their attributes, numbers as they are read again.

>>> print(Tag("body", name="arm", pos=(0, 0.5, -0.0)).add(Tag("joint", name='a"b')).text())
<body name="arm" pos="0 0.5 0">
  <joint name="a&quot;b"/>
</body>
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

__all__ = ["Tag", "number", "numbers"]

_Value = str | float | Sequence[float]


def number(value: float) -> str:
    """The shortest decimal with at most 12 digits that count."""
    text = f"{value:.12g}"
    return "0" if text == "-0" else text


def numbers(values: Iterable[float]) -> str:
    return " ".join(number(v) for v in values)


class Tag:
    """An element; an attribute whose name is a word of Python has _ behind it."""

    def __init__(self, tag: str, text: str = "", /, **attributes: _Value | None) -> None:
        self.tag = tag
        self.inside = text
        self.attributes = {name.rstrip("_"): value for name, value in attributes.items() if value is not None}
        self.children: list[Tag] = []

    def add(self, *children: Tag) -> Tag:
        self.children += children
        return self

    def lines(self, indent: str = "") -> Iterable[str]:
        said = "".join(f' {name}="{_written(value)}"' for name, value in self.attributes.items())
        if not self.children:
            end = f">{escape(self.inside)}</{self.tag}>" if self.inside else "/>"
            yield f"{indent}<{self.tag}{said}{end}"
            return
        yield f"{indent}<{self.tag}{said}>"
        for child in self.children:
            yield from child.lines(indent + "  ")
        yield f"{indent}</{self.tag}>"

    def text(self) -> str:
        return "\n".join(self.lines())


def _written(value: _Value) -> str:
    if isinstance(value, str):
        return escape(value, quote=True)
    return number(value) if isinstance(value, int | float) else numbers(value)
