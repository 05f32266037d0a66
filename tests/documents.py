"""The blocks of README.md and the guide, and what their commands print."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from commands import invoke
from places import ROOT

__all__ = ["BLOCKS", "DOCUMENTS", "FENCE", "Block", "fenced", "invoked", "of", "run", "session"]

# The pages of the catalog and of the robots are generated, and compared as a whole by tools/check_docs.py.
LEFT_OUT = ("catalog", "robots", "assets")
DOCUMENTS = (
    "README.md",
    *sorted(
        p.relative_to(ROOT).as_posix()
        for p in (ROOT / "docs").rglob("*.md")
        if p.relative_to(ROOT / "docs").parts[0] not in LEFT_OUT
    ),
)


class Block(NamedTuple):
    """A fenced block of a document."""

    document: str
    line: int
    language: str
    text: str
    title: str = ""

    @property
    def name(self) -> str:
        return f"{self.document}:{self.line}"

    @property
    def first(self) -> str:
        return self.text.partition("\n")[0]


# A block with a title is a copy of the file of that name.
FENCE = re.compile(
    r"^(`{3,}|~{3,})[ ]*([\w-]*)(?:[ ]title=\"([^\"\n]*)\")?[^\n]*\n(.*?)^\1[ \t]*$", re.MULTILINE | re.DOTALL
)


def fenced(document: str) -> list[Block]:
    text = (ROOT / document).read_text(encoding="utf-8")
    return [Block(document, text.count("\n", 0, m.start()) + 1, m[2], m[4], m[3] or "") for m in FENCE.finditer(text)]


BLOCKS = [block for document in DOCUMENTS for block in fenced(document)]


def of(language: str) -> list[Block]:
    return [b for b in BLOCKS if b.language == language and not b.title]


def session(block: str) -> Iterator[tuple[str, str]]:
    """The commands of a console block with the output that follows each."""
    for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, output = part.partition("\n")
        yield command, output


def _words(command: str, folder: Path) -> list[str]:
    """The words of a command; files that it writes go into the folder."""
    words = shlex.split(command)
    if "-o" in words:
        at = words.index("-o") + 1
        words[at] = str(folder / words[at])
    assert "|" in words or words[0] == "gcrules", command
    return words


def run(command: str, folder: Path) -> str:
    """What a command prints in a process of its own, on both streams."""
    words = _words(command, folder)
    path = os.environ.get("PATH", "")
    if "|" in words:  # a pipe, with `gcrules` as a command of its own
        tool = folder / "gcrules"
        tool.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m gcrules "$@"\n', encoding="utf-8")
        tool.chmod(0o755)
        path = f"{folder}{os.pathsep}{path}"
        words = ["sh", "-c", re.sub(r" -o (\S+)", lambda m: f" -o {shlex.quote(str(folder / m[1]))}", command)]
    else:
        words = [sys.executable, "-m", "gcrules", *words[1:]]
    environment = {**os.environ, "PYTHONIOENCODING": "utf-8", "NO_COLOR": "1", "PATH": path}
    done = subprocess.run(
        words,
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        check=False,
    )
    return done.stdout.replace(str(folder) + os.sep, "")


def invoked(command: str, folder: Path) -> str:
    """The same in this process, at the root of the checkout, as most commands take less time than a process to start;
    but for pipes, and for help, whose lines are longer where no terminal is.
    """
    words = _words(command, folder)
    if "|" in words or "--help" in words:
        return run(command, folder)
    return invoke(*words[1:]).output.replace(str(folder) + os.sep, "")
