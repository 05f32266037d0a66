"""Wrong types and shapes in Python: whatever a function is given, the fault is gcrules' own and says what it takes."""

from __future__ import annotations

import inspect
import math
import operator
import os
import traceback
import types
import warnings
from collections.abc import Callable, Iterator
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from places import ROOT

import gcrules as gc
from gcrules.api.signatures import SIGNATURES
from gcrules.core.arguments import described
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.load import read_robot

PLATFORM = load_platform(ROOT / "examples" / "octahedral.yaml")
ANALYSIS = gc.analyze(PLATFORM)
ROBOT = read_robot("3-rps")
ANALYZED = gc.analyze(ROBOT)
LEGS = "ab af cb cd ed ef"


class Hostile:
    """An object whose every question is answered by a fault of its own kind."""

    def __repr__(self) -> str:
        raise RuntimeError("repr")

    __str__ = __repr__


def generator() -> Iterator[Any]:
    yield from (1, "a", None)


NASTY: dict[str, Callable[[], Any]] = {
    "None": lambda: None,
    "True": lambda: True,
    "0": lambda: 0,
    "-1": lambda: -1,
    "10**400": lambda: 10**400,
    "1.5": lambda: 1.5,
    "nan": lambda: math.nan,
    "inf": lambda: -math.inf,
    "1e308": lambda: 1e308,
    "complex": lambda: 1j,
    "Fraction": lambda: Fraction(1, 10**400),
    "Decimal": lambda: Decimal("1e999"),
    "empty text": lambda: "",
    "text": lambda: "no such thing",
    "nul": lambda: "\0",
    "surrogate": lambda: "\ud800",
    "bytes": lambda: b"ab",
    "bytearray": lambda: bytearray(b"ab"),
    "path": lambda: Path("/nowhere/at/all"),
    "bytes path": lambda: memoryview(b"ab"),
    "empty list": list,
    "empty tuple": tuple,
    "list": lambda: [1, 2, 3],
    "Nones": lambda: [None] * 3,
    "nested": lambda: [[1, 2, 3], [1, 2]],
    "texts": lambda: ["a", "b", "c"],
    "huge numbers": lambda: [1e200] * 4,
    "three huge numbers": lambda: (1e300,) * 3,
    "tiny numbers": lambda: [1e-320] * 3,
    "nans": lambda: [math.nan] * 3,
    "dict": lambda: {"a": 1},
    "dict of lists": lambda: {"x": [1], 2: None},
    "set": lambda: {1, 2, 3},
    "generator": generator,
    "range": lambda: range(3),
    "slice": lambda: slice(3),
    "function": lambda: len,
    "class": lambda: int,
    "list, the class": lambda: list,
    "module": lambda: gc,
    "object": object,
    "hostile": Hostile,
    "hostile ones": lambda: [Hostile()] * 3,
    "array": lambda: np.ones(3),
    "array of rows": lambda: np.zeros((2, 3)),
    "array of nothing": lambda: np.zeros((0, 3)),
    "array of objects": lambda: np.array([None, "a", 1], dtype=object),
    "array of texts": lambda: np.array(["a", "b", "c"]),
    "array of truths": lambda: np.array([True, False, True]),
    "complex array": lambda: np.ones(3) * 1j,
    "array without dimensions": lambda: np.array(3.0),
    "deep array": lambda: np.zeros((1, 2, 3)),
    "masked array": lambda: np.ma.array([0, 0, 0], mask=True),
    "numpy truth": lambda: np.bool_(True),
    "numpy number": lambda: np.float32(2.5),
    "numpy whole number": lambda: np.int64(3),
    "platform": lambda: PLATFORM,
    "analysis": lambda: ANALYSIS,
    "robot": lambda: ROBOT,
    "expression": lambda: gc.parse("[abcd]"),
    "polynomial": lambda: gc.expand("[abcd]"),
    "library": gc.load_rules,
    "simple namespace": types.SimpleNamespace,
}

PACKAGE = f"{Path(gc.__file__).parent}{os.sep}"

# What is right, so that one argument at a time is wrong. Searches are short.
RIGHT: dict[str, dict[str, Any]] = {
    "analyze": {"source": LEGS, "search": 0.0},
    "assembly_modes": {"source": PLATFORM},
    "box_map": {"source": PLATFORM, "over": ["x -1:1"], "tiles": 1, "boxes": 1},
    "certify": {"source": PLATFORM, "over": ["x -1:1"], "boxes": 1},
    "compiled": {"source": PLATFORM, "engine": "numpy"},
    "discover": {"script": "rank 3", "seconds": 0.0},
    "evaluate": {"e": "[ab]", "points": {"a": (1, 0), "b": (0, 1)}, "rank": 2},
    "expand": {"e": "[abcd]"},
    "export": {"source": PLATFORM},
    "export_model": {"source": PLATFORM},
    "factor": {"e": "[abcd]", "seconds": 1.0},
    "factors": {"e": "[abcd]", "seconds": 1.0},
    "load": {"source": ROOT / "examples" / "octahedral.yaml"},
    "load_rules": {"identities": False},
    "locus": {"source": PLATFORM, "over": "z"},
    "operation_modes": {"source": "delta"},
    "paper": {"source": ANALYSIS, "folder": "paper"},
    "parse": {"text": "[abcd]"},
    "path": {"source": PLATFORM, "poses": ["0 0 0", "0 0 1"], "samples": 2},
    "aspects": {"source": PLATFORM, "poses": 1, "modes": False},
    "free_region": {"source": PLATFORM, "over": "x"},
    "length_regions": {"source": "3-rpr", "over": "q2 1..2, q3 1..2"},
    "plan": {"source": PLATFORM, "start": "0 0 0", "goal": "0 0 1", "states": 2},
    "pose": {"source": PLATFORM, "at": "0 0 0", "nearest": False},
    "proof_file": {"answer": ANALYSIS},
    "prove": {"claim": "[abcd] == [abcd]"},
    "refine_map": {"store": "no.zarr", "output": "none.zarr"},
    "report": {"source": ANALYSIS, "interactive": False, "path": ["0 0 0", "0 0 1"], "modes": True},
    "rewrite": {"e": "[aabc]", "rules": ["vanishing"]},
    "shorten": {"e": "[abcd]", "seconds": 1.0},
    "shortest": {"legs": LEGS},
    "map_status": {"store": "no.zarr"},
    "verify_map": {"store": "no.zarr", "tiles": 1},
    "merge_maps": {"stores": ["no.zarr"], "output": "none.zarr"},
    "singular_map": {"source": PLATFORM, "over": ["x -1:1:2", "y -1:1:2"], "measure": "value"},
    "working_modes": {"source": "5r"},
    "singular": {"source": ANALYZED, "towards": "z=0.1, roll=0deg, pitch=0deg"},
    "straighten": {"e": "[abcd]"},
    "studio": {"source": PLATFORM, "browser": False},
    "superbracket": {"legs": LEGS},
    "transversals": {"legs": LEGS},
    "view": {"source": PLATFORM},
    "seeded": {"seed": 7},
    "within": {"seconds": 60},
}
COMPILED = gc.compiled(PLATFORM, engine="numpy")
COMPILED_ROBOT = gc.compiled(ANALYZED)
FREE = gc.free_region(PLATFORM, over="x")
PLAN = gc.plan(PLATFORM, "home", "0 0 -490")
MAP = gc.singular_map(PLATFORM, ["x -1:1:2", "y -1:1:2"], measure="value")
LIBRARY = gc.load_rules()
METHODS: dict[str, tuple[Callable[..., Any], tuple[str, ...]]] = {
    "load plugins": (lambda plugins: gc.load("3-rps", plugins=plugins), ("plugins",)),
    "load data": (
        lambda **data: gc.load(dict({"legs": "ab"}, **data)),
        ("legs", "points", "units", "limbs"),
    ),
    "pose of a robot": (
        lambda **given: gc.pose(ANALYZED, **{"nearest": False, **given}),
        ("at", "actuators", "quaternion", "euler", "degrees", "about", "threshold", "accuracy", "nearest"),
    ),
    "pose by coordinates": (
        lambda **at: gc.pose(ANALYZED, {"z": 0, "roll": 0, "pitch": 0, **at}, nearest=False),
        ("x", "z", "roll"),
    ),
    "platform by coordinates": (lambda **at: gc.pose(ANALYSIS, at, nearest=False), ("x", "z", "roll", "rx")),
    "CompiledCondition": (COMPILED, ("translations", "rotations", "quaternions", "out")),
    "CompiledCondition.at_joints": (COMPILED.at_joints, ("points",)),
    "compiled of a robot": (
        lambda **given: gc.compiled(ANALYZED, **given),
        ("expression", "coordinates", "about", "engine"),
    ),
    "CompiledLimbs": (COMPILED_ROBOT, ("poses",)),
    "CompiledLimbs.numbers": (
        lambda **given: COMPILED_ROBOT.numbers(**{"poses": [0, 0, 0], **given}),
        ("poses", "asked"),
    ),
    "SingularMap.values": (MAP.values, ("name",)),
    "SingularMap.save": (lambda path: MAP.save(path), ("path",)),
    "SingularMap.save_certificate": (MAP.save_certificate, ("path",)),
    "FreeRegion.save_certificate": (FREE.save_certificate, ("path",)),
    "Plan.save_certificate": (PLAN.save_certificate, ("path",)),
    "Library[]": (LIBRARY.__getitem__, ("rule_id",)),
    "Library.strategy": (LIBRARY.strategy, ("ids", "without")),
    "Library.plus": (LIBRARY.plus, ("rules",)),
    "Library": (gc.Library, ("rules",)),
    "Strategy": (gc.Strategy, ("rules",)),
    "Structure": (
        lambda **given: gc.Structure(**{"legs": PLATFORM.legs, **given}),
        ("legs", "points", "ideal", "given", "rank", "stand_ins"),
    ),
    "Plugin": (gc.Plugin, ("rules", "rule_files", "robots", "catalogs", "owner")),
    "Platform": (
        lambda **given: gc.Platform(**{"legs": PLATFORM.legs, "points": PLATFORM.points, **given}),
        ("legs", "points", "title", "units"),
    ),
}
POSITIONAL = {"Library[]"}


def calls() -> Iterator[Any]:
    for name, right in RIGHT.items():
        for argument in SIGNATURES[name]:
            yield pytest.param(getattr(gc, name), right, argument, id=f"{name}-{argument}")
    for name, (method, arguments) in METHODS.items():
        for argument in arguments:
            yield pytest.param(method, {}, argument, id=f"{name}-{argument}")


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@pytest.mark.usefixtures("elsewhere")
@pytest.mark.parametrize(("function", "right", "argument"), list(calls()))
def test_a_wrong_argument(function: Callable[..., Any], right: dict[str, Any], argument: str) -> None:
    """An answer, or a fault of gcrules' own with a message; numpy has nothing to warn of."""
    wrong = {}
    for name, make in NASTY.items():
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            try:
                answer = function(make()) if argument == "rule_id" else function(**{**right, argument: make()})
                getattr(answer, "close", lambda: None)()  # a window of the studio
            except GcrulesError as fault:
                if not 0 < len(fault.render()) < 4_000 or fault.exit_code not in (2, 3):
                    wrong[name] = f"{fault.render()[:80]}…"
            except Exception as fault:
                wrong[name] = f"{type(fault).__name__}: {fault}"
    assert not wrong


def test_every_public_function_is_in_the_table() -> None:
    functions = {n for n in gc.__all__ if inspect.isfunction(getattr(gc, n))}
    assert functions == SIGNATURES.keys() == RIGHT.keys()
    for name in functions:
        assert inspect.signature(getattr(gc, name)).parameters.keys() == SIGNATURES[name].keys(), name


@pytest.mark.parametrize("name", SIGNATURES)
def test_a_wrong_keyword_is_pythons(name: str) -> None:
    with pytest.raises(TypeError, match="unexpected keyword argument 'nonsense'"):
        getattr(gc, name)(**RIGHT[name], nonsense=1)


@pytest.mark.parametrize(
    ("call", "message", "hint"),
    [
        (lambda: gc.path(gc, []), "gc.path: `source` must be a source: legs, .* got a module", None),
        (lambda: gc.path(ROBOT, []), "a path needs two poses or more, found 0", None),
        (lambda: gc.locus("3-rpr", at=3), "takes coordinates by their names", "yaw=30deg"),
        (lambda: gc.locus("tricept", "z"), "tricept has no locus as a polynomial over", "gcrules map"),
        (lambda: gc.pose(LEGS), "legs alone have no coordinates", "give a geometry file"),
        (lambda: gc.analyze(ROBOT, order="2 1 3 4 5 6"), "the robot 3-rps takes no options order", None),
        (lambda: gc.analyze(ANALYSIS, recheck=True), "what was analysed before takes no options recheck", None),
        (lambda: gc.expand(b"[abcd]"), "`e` must be text or an expression, got b'", None),
        (lambda: gc.expand("[abcd]", limit=True), "`limit` must be a whole number, 1 or more, got True", None),
        (lambda: gc.factor("[abcd]", seconds=math.nan), "number of seconds, 0 or more, got nan", None),
        (lambda: gc.pose(PLATFORM, quaternion=[1e200] * 4), "the quaternion has length inf", None),
        (lambda: gc.pose(PLATFORM, [True, 0, 0]), "`at` must be a pose, or several", None),
        (
            lambda: gc.expand("[abcd]", points={"a", "b"}),
            "names of points as text or as a sequence.* got a set of 2",
            None,
        ),
        (lambda: gc.pose(ROBOT, **{"z": 1}), "", None),
    ],
)
def test_messages(call: Callable[[], Any], message: str, hint: str | None) -> None:
    if not message:
        with pytest.raises(TypeError, match="keyword"):
            call()
        return
    with pytest.raises(InputError, match=message) as caught:
        call()
    assert hint is None or hint.replace("\\", "") in (caught.value.hint or "")


@pytest.mark.parametrize(
    "call",
    [
        lambda: gc.expand("[abcd]", limit=np.int64(10)),
        lambda: gc.expand("[abcd]", points=(n for n in "abcd")),
        lambda: gc.factor("[abcd]", seconds=np.float32(2), all=np.bool_(False)),
        lambda: gc.pose(PLATFORM, np.array([0, 0, 1]), nearest=np.bool_(False)),
        lambda: gc.pose(PLATFORM, (np.float32(c) for c in (0, 0, 1)), nearest=False),
        lambda: gc.pose(PLATFORM, (t for t in ("0 0 0", "0 0 1")), nearest=False),
        lambda: gc.pose(ROOT / "examples" / "octahedral.yaml", [0, Fraction(1, 3), Decimal("0.5")], nearest=False),
        lambda: gc.path(PLATFORM, (p for p in ("0 0 0", (0, 0, np.int32(1)))), samples=np.int16(2)),
        lambda: gc.analyze([["a", "b"], ("a", "f"), "cb", "cd", "ed", "ef"], order=np.array([1, 0, 2, 3, 4, 5])),
        lambda: gc.pose(ANALYZED, {"z": np.float64(0.1), "roll": np.int64(0), "pitch": 0}, nearest=False),
        lambda: gc.load({"legs": ["ab"], "points": {"a": np.zeros(3), "b": (Fraction(1, 3), "1/2", np.float64(1))}}),
        lambda: gc.load_rules(identities=np.bool_(False)),
    ],
)
def test_sensible_values_are_taken(call: Callable[[], Any]) -> None:
    call()


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (None, "None"),
        (10**60, "a whole number of 200 bits"),
        ("x" * 100, f"'{'x' * 40}'…"),
        (int, "the class int"),
        (np.zeros((2, 3)), "an array of shape (2, 3)"),
        ([1, 2], "a list of 2"),
        (Hostile(), "a Hostile"),
    ],
    ids=lambda v: "" if isinstance(v, Hostile) else str(v)[:20],
)
def test_a_value_in_words(value: Any, words: str) -> None:
    assert described(value) == words


@pytest.mark.parametrize("wrong", ["a", None, [1e200] * 4, b"1"], ids=["text", "None", "a list", "bytes"])
def test_each_named_coordinate_is_judged_by_itself(wrong: Any) -> None:
    robot = gc.analyze("delta")
    with pytest.raises(InputError, match=r"\by\b.* (must be|expected) a number"):
        gc.pose(robot, {"x": 0, "y": wrong, "z": 0.5})


@pytest.mark.parametrize("symbol", ["add", "sub", "mul", "or_", "and_"])
@pytest.mark.parametrize("name", ["scalar", "extensor", "polynomial"])
def test_an_operand_of_another_kind_is_pythons_type_error(name: str, symbol: str) -> None:
    """From both sides: operators take what is theirs, fail as gcrules' own functions do, or leave it to Python."""
    own = {"scalar": gc.parse("[abcd]"), "extensor": gc.parse("ab"), "polynomial": gc.expand("[abcd]")}[name]
    wrong = {}
    for key, value in NASTY.items():
        other = value()
        for left, right in ((own, other), (other, own)):
            try:
                str(getattr(operator, symbol)(left, right))
            except GcrulesError:
                continue
            except Exception as fault:
                inside = [f.name for f in traceback.extract_tb(fault.__traceback__) if f.filename.startswith(PACKAGE)]
                if inside or not isinstance(fault, TypeError):
                    wrong[key] = f"{type(fault).__name__}: {fault} in {inside}"
    assert not wrong
