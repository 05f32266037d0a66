"""The command line and Python in a web page: under Pyodide, a page of the guide asks one line, script or example after
the other.

The page keeps one interpreter; its working folder holds the examples under the name by which the guide calls them.
"""

from __future__ import annotations

import code
import contextlib
import io
import json
import os
import re
import shlex
import shutil
import sys
import traceback
from itertools import takewhile
from pathlib import Path
from typing import Any

from gcrules.apps.cli import answered
from gcrules.core.errors import InputError, absent

__all__ = ["Desk"]

_SCRIPT = "script.gca"
_LARGEST = 10_000_000  # bytes of a file that the page offers
_BROUGHT = ("examples", "plugins")


class _Prompt(code.InteractiveInterpreter):
    """The prompt of Python, which tells whether what it was given raised, and of a fault no more than what it is."""

    raised = False

    def showtraceback(self) -> None:
        self.raised = True
        fault = sys.exc_info()[1]
        if isinstance(fault, ModuleNotFoundError) and not (fault.name or "").startswith("gcrules."):
            print(absent(fault).render(), file=sys.stderr)
        else:
            traceback.print_exception(fault, limit=0)

    def showsyntaxerror(self, filename: str | None = None, **more: Any) -> None:
        self.raised = True
        super().showsyntaxerror(filename, **more)


class Desk:
    """A working folder, with the examples and plugins in it, and what has been written there so far."""

    def __init__(self, folder: str) -> None:
        Path(folder).mkdir(parents=True, exist_ok=True)
        os.chdir(folder)
        for name in _BROUGHT:
            brought = Path(__file__).parent.parent / f"_{name}"
            if brought.is_dir():
                shutil.copytree(brought, name, dirs_exist_ok=True)
        self._seen: dict[str, int] = {}
        self._done: list[str] = []
        self._prompt = _Prompt()
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

    def run_session(self, text: str) -> int:
        """The exit code of the last of some examples of Python, 2 if it raises; it is shown with what it prints, as at
        the prompt of Python. The text is a JSON list of the examples of a page up to that one, which are one session:
        those before it run too, as far as they do here, unless they have already.
        """
        *before, last = json.loads(text)
        if self._done[: len(before)] != before or len(self._done) > len(before):
            self._done, self._prompt = [], _Prompt({"__name__": "__main__"})
        for example in before[len(self._done) :]:
            with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                self._run(example)
        self._done = [*before, last]
        return 0 if self._run(last) else InputError.exit_code

    def _run(self, example: str) -> bool:
        """Whether an example runs to its end; what raises ends it."""
        for lines in (part.splitlines() for part in re.split(r"^>>> ", example, flags=re.MULTILINE)[1:]):
            further = list(takewhile(lambda line: line.startswith("..."), lines[1:]))
            source = "\n".join([lines[0], *(line[4:] for line in further)]) + "\n"
            print(f">>> {lines[0]}", *further, sep="\n")
            self._prompt.raised = False
            self._prompt.runsource(source, "<example>")
            if self._prompt.raised:
                return False
        return True

    def new_files(self) -> list[str]:
        """The files of the working folder, but for those that it came with, that are new or have changed since this was
        last asked.
        """
        files = (p for p in sorted(Path().rglob("*")) if p.parts[0] not in _BROUGHT and p.is_file())
        found = {p.as_posix(): p.stat().st_mtime_ns for p in files if p.stat().st_size <= _LARGEST}
        new = [name for name, changed in found.items() if self._seen.get(name) != changed]
        self._seen.update(found)
        return new
