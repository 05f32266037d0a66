"""Certificates that were changed, and signed anew, for the tests of what recomputes them."""

from __future__ import annotations

import copy
import hashlib
import json
import random
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from places import checker

import gcrules as gc

JUNK: list[Any] = [None, True, -1, 10**30, 1.5, "", "nan", "1/0", "9" * 500, [], {}, [[]], "x" * 7, ["1", "2", "3"]]


Maps = dict[str, tuple[str, list[str], dict[str, Any]]]
"""Of maps by names: the robot, the axes, and more of the question."""


def stored(maps: Maps) -> tuple[Callable[[str], str], Callable[[str], dict[str, Any]]]:
    """The certificate of a map by its name, computed once: as text, and as a new object each time."""

    @cache
    def text(name: str) -> str:
        source, over, more = maps[name]
        return json.dumps(gc.singular_map(source, over, **more).certificate())

    def data(name: str) -> dict[str, Any]:
        found: dict[str, Any] = json.loads(text(name))
        return found

    return text, data


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


def with_junk(
    file: dict[str, Any], number: int, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> Iterator[tuple[tuple[Any, ...], int]]:
    """Places in which junk is put, each with the exit code where the file is signed anew; with the old digest all of
    them are seen.
    """
    rng = random.Random(1)
    places = [p for p in leaves(file) if p and p[0] not in ("made by", "title", "digest")]
    for path in rng.sample(places, number):
        new = put(file, path, rng.choice(JUNK))
        if new != file:
            assert run(json.dumps(new), folder, monkeypatch) in (1, 2)
            yield path, run(json.dumps(signed(new)), folder, monkeypatch)


def _joint(number: int, screw: list[float]) -> Callable[[dict[str, Any]], Any]:
    """Another joint in the first limb."""
    return lambda file: file["geometry"]["limbs"][0]["screws"].__setitem__(number, screw)


def _more(screw: list[float], *, limbs: int = 1, like_last: float = 0.0) -> Callable[[dict[str, Any]], Any]:
    """One more joint at the end of limbs, with an amount of its own or so many times that of the last one."""

    def change(file: dict[str, Any]) -> None:
        for limb in file["geometry"]["limbs"][:limbs]:
            limb["screws"].append(screw)
            limb["coordinates"].append(limb["coordinates"][-1] + (not like_last))
            limb["signs"].append(like_last or 1.0)

    return change


def _against_itself(file: dict[str, Any]) -> None:
    """A slide across the leg, and one back that is a little shorter, in place of the last hinge."""
    _joint(2, [0.0, 0.0, 0.0, -0.8, 0.6, 0.0])(file)
    _more([0.0, 0.0, 0.0, -0.8, 0.6, 0.0], like_last=-1.0 + 1e-9)(file)


FALSE_JOINTS: dict[str, tuple[Callable[[dict[str, Any]], Any], str]] = {
    "a slide so short that nothing has power on it": (_joint(2, [0, 0, 0, -4e-10, 9e-10, 0]), "length 1"),
    "a hinge that hardly turns": (_joint(2, [0, 0, 1e-9, 2e-9, -1.5e-9, 0]), "length 1"),
    "a hinge elsewhere that hardly turns": (_joint(2, [0, 0, 1e-9, 5e-10, 0, 0]), "length 1"),
    "an axis so short that its square is 0": (_joint(2, [0, 0, 1e-170, -0.8, 0.6, 0]), "length 1"),
    "an amount that hardly moves a joint": (
        lambda file: file["geometry"]["limbs"][0]["signs"].__setitem__(2, 1e-9),
        "hardly moves",
    ),
    "slides that hardly move together": (_against_itself, "power on the undriven joints"),
    "two hinges that are nearly one": (_more([0, 0, 1, 2 + 1e-9, -1.5, 0]), "nearly depend on each other"),
    "slides out of the plane": (_more([0, 0, 0, 0, 0, 1], limbs=3), "leaves the plane"),
    "a slide that is nearly in the plane": (_more([0, 0, 0, 1, 0, 1e-10]), "leaves the plane"),
    "a screw in place of a hinge": (_joint(2, [0, 0, 1, 2, -1.5, 0.1]), "leaves the plane"),
    "a hinge that is tilted": (_joint(2, [0, 0.6, 0.8, 1.6, -1.2, 0.9]), "leaves the plane"),
    "an amount without a joint": (
        lambda file: file["geometry"]["limbs"][0].update(coordinates=[0, 1, 3]),
        "amounts without a joint",
    ),
    "a plane that is a number": (lambda file: file["geometry"].update(plane=1), "the plane z = 0"),
}
"""What makes other robots of that of a file of 3-rpr, whose closed forms seem to hold them."""


def with_false_joints(file: dict[str, Any], name: str) -> dict[str, Any]:
    new = copy.deepcopy(file)
    FALSE_JOINTS[name][0](new)
    return signed(new)
