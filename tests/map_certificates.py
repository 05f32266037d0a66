"""Certificates that were changed, and signed anew, for the tests of what recomputes them."""

from __future__ import annotations

import copy
import hashlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from places import checker

JUNK: list[Any] = [None, True, -1, 10**30, 1.5, "", "nan", "1/0", "9" * 500, [], {}, [[]], "x" * 7, ["1", "2", "3"]]


def signed(file: dict[str, Any]) -> dict[str, Any]:
    """With the digest of what it says."""
    rest = {k: v for k, v in file.items() if k != "digest"}
    words = json.dumps(rest, sort_keys=True, separators=(",", ":"))
    return {**rest, "digest": hashlib.sha256(words.encode()).hexdigest()}


def run(
    file: str | bytes,
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    name: str = "cells.json",
    *,
    program: str = "check_map",
    more: tuple[str, ...] = (),
) -> int:
    """The exit code of a program for a file."""
    path = folder / name
    path.write_bytes(file.encode() if isinstance(file, str) else file)
    monkeypatch.setattr("sys.argv", [f"{program}.py", str(path), *more])
    return int(checker(program).main())


def leaves(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where something stands in a file, whole objects too."""
    yield path
    for key in value if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ():
        yield from leaves(value[key], (*path, key))


def put(file: dict[str, Any], path: tuple[Any, ...], value: Any) -> dict[str, Any]:
    """The file with another value in a place."""
    new = copy.deepcopy(file)
    inner: Any = new
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    return new
