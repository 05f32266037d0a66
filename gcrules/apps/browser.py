"""The command line in a web page: under Pyodide, a page of the guide asks one line after the other.

The page keeps one interpreter; its working folder holds the examples under the name by which the guide calls them.
"""

from __future__ import annotations

import os
import shlex
import shutil
import sys
from pathlib import Path

from gcrules.apps.cli import answered
from gcrules.core.errors import InputError

__all__ = ["answer", "prepare", "run_script", "written"]

_SCRIPT = "script.gca"
_LARGEST = 10_000_000  # bytes of a file that the page offers

_seen: dict[str, float] = {}


def prepare(folder: str) -> None:
    """Make `folder` the working folder, with the examples inside."""
    Path(folder).mkdir(parents=True, exist_ok=True)
    os.chdir(folder)
    shutil.copytree(Path(__file__).parent.parent / "_examples", "examples", dirs_exist_ok=True)
    written()


def answer(line: str) -> int:
    """The exit code of a line as a shell reads it, "gcrules prove …" or without the first word; its answer is printed.

    >>> answer('prove "ab /\\\\ cd == [abcd]"')
    proved: ab /\\ cd == [abcd]
      both sides have the same normal form of standard tableaux
    0
    """
    try:
        words = shlex.split(line.removeprefix("$ "))
    except ValueError as fault:
        error = InputError(f"the line is not complete: {fault}", hint="close the quotation mark that was opened")
        print(error.render(), file=sys.stderr)
        return error.exit_code
    before = sys.argv
    sys.argv = ["gcrules", *words[words[:1] == ["gcrules"] :]]
    try:
        return answered()
    finally:
        sys.argv = before


def run_script(text: str) -> int:
    """The exit code of a script of statements."""
    Path(_SCRIPT).write_text(text, encoding="utf-8")
    written()
    return answer(f"run {_SCRIPT}")


def written() -> list[str]:
    """The files of the working folder, examples aside, that are new or have changed since this was last asked."""
    found = {}
    for path in sorted(p for p in Path().rglob("*") if p.parts[0] != "examples" and p.is_file()):
        if path.stat().st_size <= _LARGEST:
            found[path.as_posix()] = path.stat().st_mtime_ns
    new = [name for name, changed in found.items() if _seen.get(name) != changed]
    _seen.update(found)
    return new
