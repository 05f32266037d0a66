"""What tests of several commands ask of an answer."""

from __future__ import annotations

from typing import Any

__all__ = ["assert_refused"]


def assert_refused(done: Any, code: int, says: str) -> None:
    """A fault is told on standard error, by its exit code, and nothing is printed."""
    assert done.exit_code == code, done.output
    assert says in done.stderr, done.stderr
    assert not done.stdout, done.stdout
