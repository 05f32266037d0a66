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

__all__ = ["Desk"]

_SCRIPT = "script.gca"
_LARGEST = 10_000_000  # bytes of a file that the page offers


class Desk:
    """A working folder, with the examples in it, and what has been written there so far."""

    def __init__(self, folder: str) -> None:
        Path(folder).mkdir(parents=True, exist_ok=True)
        os.chdir(folder)
        examples = Path(__file__).parent.parent / "_examples"
        if examples.is_dir():
            shutil.copytree(examples, "examples", dirs_exist_ok=True)
        self._seen: dict[str, int] = {}
        self.new_files()

    def answer(self, line: str) -> int:
        """The exit code of a line as a shell reads it, "gcrules prove …" or without the first word; its answer is
        printed.
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

    def run_script(self, text: str) -> int:
        """The exit code of a script of statements."""
        Path(_SCRIPT).write_text(text, encoding="utf-8")
        self.new_files()
        return self.answer(f"run {_SCRIPT}")

    def new_files(self) -> list[str]:
        """The files of the working folder, examples aside, that are new or have changed since this was last asked."""
        files = (p for p in sorted(Path().rglob("*")) if p.parts[0] != "examples" and p.is_file())
        found = {p.as_posix(): p.stat().st_mtime_ns for p in files if p.stat().st_size <= _LARGEST}
        new = [name for name, changed in found.items() if self._seen.get(name) != changed]
        self._seen.update(found)
        return new
