r"""A call of gcrules, written as a line for the shell and as lines of Python.

>>> call = Call("path", "path", (Option("--at", "poses", ("0 0 0", "0 0 -100")), Option("--samples", "samples", 50)))
>>> call.shell("robot.yaml")
'gcrules path robot.yaml --at "0 0 0" --at "0 0 -100" --samples 50'
>>> print(call.python("robot.yaml"))
import gcrules as gc
<BLANKLINE>
robot = gc.load("robot.yaml")
print(gc.path(robot, poses=["0 0 0", "0 0 -100"], samples=50))
"""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Iterator, Sequence

from gcrules.core.dataclass import dataclass

__all__ = ["Call", "Option", "quoted"]

_BARE = re.compile(r"[\w.,:/=+-]+")
_KEPT = re.compile(r'[^"$`!\\]|\\[^"$`\\]')  # what double quotes leave as it is, in every shell


def quoted(word: str) -> str:
    r"""A word as shells take it.

    >>> print(quoted("3-rps"), quoted("z=1, x=2"), quoted(r"ab /\ cd"), quoted("a$b"), quoted("-"))
    3-rps "z=1, x=2" "ab /\ cd" 'a$b' -
    """
    if _BARE.fullmatch(word):
        return word
    return f'"{word}"' if re.fullmatch(f"(?:{_KEPT.pattern})*", word) else shlex.quote(word)


@dataclass(frozen=True)
class Option:
    """A flag of the command, and what the function calls it, "" where it does not need it; a tuple repeats the flag,
    True and False need no value.
    """

    flag: str
    keyword: str
    value: str | float | tuple[str, ...] | bool

    def words(self) -> Iterator[str]:
        if isinstance(self.value, bool):
            yield self.flag
            return
        for value in self.value if isinstance(self.value, tuple) else (self.value,):
            word = quoted(str(value))
            yield f"{self.flag}={word}" if word.startswith("-") else f"{self.flag} {word}"

    def argument(self) -> str:
        value = list(self.value) if isinstance(self.value, tuple) else self.value
        return f"{self.keyword}={value if isinstance(value, bool) else json.dumps(value, ensure_ascii=False)}"


@dataclass(frozen=True)
class Call:
    """`command` of the shell and `function` of Python do the same; of its result Python shows these `parts`, or all."""

    command: str
    function: str
    options: tuple[Option, ...] = ()
    parts: tuple[str, ...] = ()

    def shell(self, word: str, mode: str | None = None) -> str:
        modes = [f"--mode={quoted(mode)}"] if mode else []
        return " ".join(["gcrules", self.command, quoted(word), *modes, *(w for o in self.options for w in o.words())])

    def direct(self, word: str, *more: str, before: Sequence[str] = ()) -> str:
        """The same where the function takes a text itself, with `more` arguments behind it and lines `before` it;
        nothing where no function does it.
        """
        if not self.function:
            return ""
        arguments = ", ".join([json.dumps(word, ensure_ascii=False), *more, *(o.argument() for o in self.options)])
        call = f"print(gc.{self.function}({arguments}))"
        return "\n".join(["import gcrules as gc", "", *before, call])

    def python(self, word: str, mode: str | None = None) -> str:
        """Nothing where no function does it."""
        if not self.function:
            return ""
        loaded = ", ".join([json.dumps(word, ensure_ascii=False), *([f"mode={json.dumps(mode)}"] if mode else [])])
        arguments = ", ".join(["robot", *(o.argument() for o in self.options if o.keyword)])
        lines = [f"robot = gc.load({loaded})"]
        if self.parts:
            lines += [f"found = gc.{self.function}({arguments})", *(f"print(found.{part})" for part in self.parts)]
        else:
            lines.append(f"print(gc.{self.function}({arguments}))")
        return "\n".join(["import gcrules as gc", "", *lines])
