"""What tests of several commands ask of an answer."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from click.testing import CliRunner, Result

from gcrules.apps.cli import cli

__all__ = ["Run", "assert_refused", "invoke", "refuse_report", "shell"]

Run = Callable[..., Result]


def invoke(*arguments: str, input: str | bytes | None = None) -> Result:
    """The program in this process; anything but a proper exit fails the test."""
    result = CliRunner().invoke(cli, arguments, input=input, prog_name="gcrules")
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


def refuse_report(source: str, options: Iterable[str], message: str, out: Path) -> None:
    """`gcrules report` with these options says this, and writes nothing."""
    done = invoke("report", source, "--no-3d", *options, "-o", str(out))
    assert done.exit_code == 2
    assert message in " ".join(done.stderr.split())
    assert not out.exists()


def shell(
    *arguments: str, input: str = "", env: dict[str, str] | None = None, timeout: float = 60
) -> subprocess.CompletedProcess[str]:
    """A process of its own, as a shell would start it."""
    return subprocess.run(
        [sys.executable, "-c", "from gcrules.apps.main import main; main()", *arguments],
        input=input,
        capture_output=True,
        encoding="utf-8",
        env=os.environ | {"PYTHONIOENCODING": "utf-8"} | (env or {}),
        timeout=timeout,
    )


def assert_refused(done: Any, code: int, says: str) -> None:
    """A fault is told on standard error, by its exit code, and nothing is printed."""
    assert done.exit_code == code, done.output
    assert says in done.stderr, done.stderr
    assert not done.stdout, done.stdout
