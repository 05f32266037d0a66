"""Calls of the Python API: any function with any values, most of them of a wrong type or shape.

A value that comes back can be shown, goes through JSON, and is equal to itself after pickling. What is raised is an
error of gcrules, or a TypeError of the signature itself.
"""

from __future__ import annotations

import inspect
import json
import pickle
import traceback
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from random import Random
from typing import Any

from ..case import Case
from ..corpus import ROOT, corpus
from ..jail import Jail
from ..running import Outcome, run_call
from .family import Family

__all__ = ["CALLS"]


@cache
def _numpy() -> Any:
    import numpy

    return numpy


@cache
def _robot() -> Any:
    import gcrules as gc

    return gc.analyze("3-rpr")


@cache
def _platform() -> Any:
    from gcrules.mechanisms.description.platform_file import parse_platform

    return parse_platform(corpus("platforms")[0])


@cache
def _analysis(of_platform: bool) -> Any:
    import gcrules as gc

    return gc.analyze(_platform() if of_platform else "ab af cb cd ed ef", search=0)


@cache
def _compiled() -> Any:
    import gcrules as gc

    return gc.compiled(_platform(), engine="numpy")


VALUES: Mapping[str, Callable[[], Any]] = {
    "None": lambda: None,
    "True": lambda: True,
    "0": lambda: 0,
    "1": lambda: 1,
    "-1": lambda: -1,
    "10**400": lambda: 10**400,
    "0.5": lambda: 0.5,
    "nan": lambda: float("nan"),
    "inf": lambda: float("inf"),
    "1e308": lambda: 1e308,
    "complex": lambda: 1j,
    "Fraction": lambda: __import__("fractions").Fraction(1, 3),
    "Decimal": lambda: __import__("decimal").Decimal("0.1"),
    "bytes": lambda: b"ab",
    "bytearray": lambda: bytearray(b"ab /\\ cde"),
    "empty": lambda: "",
    "x": lambda: "x",
    "[abcd]": lambda: "[abcd]",
    "ab /\\ cde": lambda: "ab /\\ cde",
    "claim": lambda: "ab /\\ cd == [abcd]",
    "legs": lambda: "ab af cb cd ed ef",
    "pairs": lambda: [("a", "b"), ("a", "f"), ("c", "b"), ("c", "d"), ("e", "d"), ("e", "f")],
    "pose": lambda: "0 0 10; euler zyx 10 0 0 deg",
    "range": lambda: "x -1:1:3",
    "ranges": lambda: ["x -1:1:3", "y -1:1:3"],
    "origin": lambda: "origin",
    "centroid": lambda: "centroid",
    "angle": lambda: "1 deg",
    "zyx": lambda: "zyx",
    "surrogate": lambda: "\ud800",
    "nul": lambda: "a\0b",
    "[]": list,
    "()": tuple,
    "{}": dict,
    "set": lambda: {"a", "b"},
    "[None]": lambda: [None],
    "[[]]": lambda: [[]],
    "3 numbers": lambda: [0, 0, 1],
    "3 nan": lambda: [float("nan")] * 3,
    "3 texts": lambda: ["a", "b", "c"],
    "2 poses": lambda: [[0, 0, 0], [0, 0, 10]],
    "4 numbers": lambda: (1, 0, 0, 0),
    "4 zeros": lambda: [0.0] * 4,
    "4 x 1e200": lambda: [1e200] * 4,
    "tuple of tuples": lambda: ((1, 2), (3,)),
    "generator": lambda: (x for x in "ab"),
    "range object": lambda: range(3),
    "dict": lambda: {"a": (0, 0, 0, 1), "b": (1, 0, 0, 1)},
    "points": lambda: {n: (i, i * i, 1 - i, 1) for i, n in enumerate("abcdef")},
    "array 3": lambda: _numpy().array([0.0, 0.0, 1.0]),
    "array 2x3": lambda: _numpy().zeros((2, 3)),
    "array 0x3": lambda: _numpy().zeros((0, 3)),
    "array 2x2x2": lambda: _numpy().zeros((2, 2, 2)),
    "array of objects": lambda: _numpy().array([None, "a"], dtype=object),
    "array of texts": lambda: _numpy().array(["a", "b"]),
    "numpy float": lambda: _numpy().float64(0.5),
    "numpy int": lambda: _numpy().int64(4),
    "numpy 0-d": lambda: _numpy().array(2.0),
    "euler": lambda: ("zyx", [0.1, 0.2, 0.3]),
    "module": lambda: json,
    "type": lambda: int,
    "function": lambda: len,
    "object": object,
    "path": lambda: Path("g.yaml"),
    "path of nothing": lambda: Path("nothing.yaml"),
    "g.yaml": lambda: "g.yaml",
    "3-rpr": lambda: "3-rpr",
    "robot": lambda: _robot().robot,
    "analysis of robot": _robot,
    "platform": _platform,
    "analysis": lambda: _analysis(False),
    "analysis of platform": lambda: _analysis(True),
    "expression": lambda: __import__("gcrules").parse("[abcd]"),
    "extensor": lambda: __import__("gcrules").parse("ab"),
    "polynomial": lambda: __import__("gcrules").expand("[abcd][aefg]"),
    "expansion": lambda: "expansion",
    "exception": lambda: ValueError("x"),
}

_EXPRESSIONS = ("[abcd]", "ab /\\ cde", "expression", "extensor", "polynomial")
_ROBOTS = ("platform", "platform", "analysis of platform", "g.yaml", "path", "robot", "analysis", "3-rpr")
_USUAL: Mapping[str, tuple[str, ...]] = {
    "e": _EXPRESSIONS,
    "claim": ("claim", "expression"),
    "legs": ("legs", "pairs"),
    "source": (*_ROBOTS, "legs", "pairs"),
    "at": ("pose", "3 numbers", "array 3", "array 2x3", "None"),
    "towards": ("pose", "3 numbers"),
    "poses": ("2 poses", "array 2x3"),
    "over": ("ranges",),
    "rules": ("expansion", "3 texts"),
    "points": ("points", "dict", "3 texts"),
    "quaternion": ("4 numbers", "4 x 1e200"),
    "euler": ("euler",),
    "about": ("origin", "centroid", "3 numbers"),
    "threshold": ("angle",),
}
"""Values that a parameter of this name may be meant to have."""


def _functions() -> Mapping[str, Callable[..., Any]]:
    import gcrules as gc

    names = (
        "analyze",
        "assembly_modes",
        "compiled",
        "evaluate",
        "expand",
        "factor",
        "load",
        "load_rules",
        "locus",
        "operation_modes",
        "parse",
        "path",
    )
    more = (
        "pose",
        "prove",
        "report",
        "rewrite",
        "shorten",
        "shortest",
        "singular",
        "singular_map",
        "straighten",
        "superbracket",
        "transversals",
        "view",
    )
    methods = {f"{n} of a robot": partial(getattr(gc, n), _robot()) for n in ("pose", "singular", "compiled")}
    types = {n: getattr(gc, n) for n in ("Platform", "Plugin", "Strategy", "Structure")}
    return (
        {n: getattr(gc, n) for n in (*names, *more)}
        | methods
        | types
        | {
            "compiled()": _compiled(),
        }
    )


_COSTLY = {
    "pose": {"nearest": "False"},
    "factor": {"seconds": "0"},
    "shorten": {"seconds": "0"},
    "analyze": {"search": "0"},
    "report": {},
}
_RARE = (
    "assembly_modes",
    "singular of a robot",
    "singular_map",
    "report",
    "view",
    "locus",
    "operation_modes",
    "load_rules",
    "path",
    "pose of a robot",
    "singular",
)


def call(rng: Random) -> Case:
    functions = _functions()
    name = rng.choices(list(functions), [0.2 if n in _RARE else 1.0 for n in functions])[0]
    try:
        known = [p for p in inspect.signature(functions[name]).parameters.values() if p.kind.name != "VAR_KEYWORD"]
    except (TypeError, ValueError):
        known = []
    args: list[str] = []
    kwargs: dict[str, str] = {}
    wrong = rng.choices((0, 1, 2, 9), (1, 6, 2, 1))[0]
    for p in known:
        if p.kind.name == "KEYWORD_ONLY" or (args and rng.random() < 0.2):
            if rng.random() < 0.25:
                kwargs[p.name] = _value(rng, p.name, wrong > 0 and rng.random() < 0.6)
        elif not kwargs and (p.default is p.empty or rng.random() < 0.5):
            args.append(_value(rng, p.name, wrong > 0 and rng.random() < 0.5))
    for key, value in _COSTLY.get(name, {}).items():
        kwargs.setdefault(key, value)
    if rng.random() < 0.02:
        kwargs[rng.choice(("x", "limit", "seconds"))] = "1"
    return Case(
        "calls",
        files={"g.yaml": corpus("platforms")[0]},
        seconds=20.0,
        data={"call": name, "args": args, "kwargs": kwargs},
    )


def _value(rng: Random, parameter: str, wrong: bool) -> str:
    usual = _USUAL.get(parameter)
    return rng.choice(list(VALUES)) if wrong or not usual else rng.choice(usual)


def _made(name: str) -> Any:
    return False if name == "False" else VALUES[name]()


def run(case: Case, jail: Jail) -> Outcome:
    data = case.data
    function = _functions()[data["call"]]
    args = [_made(a) for a in data["args"]]
    kwargs = {k: _made(v) for k, v in data["kwargs"].items()}

    def called() -> list[str]:
        try:
            found = function(*args, **kwargs)
        except TypeError as fault:
            if _of_signature(fault):
                raise SystemExit(2) from None
            raise
        return [f"{words}: {data['call']}" for words in _shown(found)]

    found = run_call(case, jail, called)
    asked = f"{kwargs['work']}/" if isinstance(kwargs.get("work"), (str, Path)) else None  # the folder for what is done
    return replace(found, left=tuple(n for n in found.left if asked is None or not n.startswith(asked)))


def _of_signature(fault: TypeError) -> bool:
    """Whether no function of gcrules had begun yet, but for the one that binds arguments: the call does not fit."""
    frames = (frame.f_code for frame, _ in traceback.walk_tb(fault.__traceback__))
    ours = [code for code in frames if code.co_filename.startswith(str(ROOT / "gcrules"))]
    return all(code.co_filename.endswith("arguments.py") and code.co_name == "call" for code in ours)


def _shown(found: Any) -> Iterator[str]:
    """What is wrong with a value that came back."""
    str(found), repr(found)
    if hasattr(found, "to_json"):
        try:
            json.dumps(found.to_json(), allow_nan=False)
        except ValueError as wrong:
            yield f"no JSON ({wrong})"
    if type(found).__module__.startswith("gcrules.") and getattr(type(found), "__hash__", None) and not _live(found):
        again = pickle.loads(pickle.dumps(found))
        if again != found or hash(again) != hash(found):
            yield "not equal after pickling"


def _live(found: Any) -> bool:
    return type(found).__name__ in ("CompiledCondition", "RobotWidget", "Library", "Strategy", "Plugin", "SingularMap")


CALLS = Family("calls", "calls of the Python API with values of any type", call, run, share=1.5)
