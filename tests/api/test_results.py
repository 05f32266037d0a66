"""What all results have in common: frozen values that can be hashed, copied, pickled, printed and written as JSON."""

from __future__ import annotations

import copy
import importlib
import inspect
import json
import os
import pickle
import pkgutil
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import FrozenInstanceError, fields
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.straightening.straighten import straighten_steps
from gcrules.api import discovery, factors, functions, poses, proofs, rewriting
from gcrules.conditions.catalog_check import check_entry
from gcrules.conditions.example_poses import singular_pose
from gcrules.conditions.pose_value import pose_value
from gcrules.core.errors import FileError, InputError, LimitReached, Span, StepError, SyntaxFault, join_faults
from gcrules.core.frozen import FrozenMap
from gcrules.mechanisms.conditions.analyze_robot import analyze_robot
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.load import read_robot
from gcrules.poses.stored_maps.verifying import BadTile, MapVerified
from gcrules.poses.tiles.status import MapStatus
from gcrules.rules.catalog.file import load
from gcrules.rules.script import run_script

OCTAHEDRON = "ab af cb cd ed ef"
PLATFORM = EXAMPLES / "octahedral.yaml"


def polynomial(text: str) -> BracketPolynomial:
    found = gc.expand(text)
    assert isinstance(found, BracketPolynomial)
    return found


def pose() -> Any:
    a, platform = gc.analyze(OCTAHEDRON), load_platform(PLATFORM)
    return pose_value(a.structure, a.condition, platform.homogeneous())


MANY_TERMS = "([abcd] + [aefg])**9 ([aceg] + [bdfh])**9"
SCRIPT = "claim a == a   claim a == b   show ab /\\ cde"

RESULTS: dict[str, Callable[[], Any]] = {
    "bracket polynomial": lambda: gc.expand("[abcd][efgh] - 1/2 [abce][dfgh]"),
    "zero": lambda: gc.expand("[abcd] - [abcd]"),
    "polynomial with long names": lambda: gc.expand("[left right a b]", points="left right"),
    "extensor polynomial": lambda: gc.expand(r"ab /\ cde"),
    "proof": lambda: gc.prove(r"ab /\ cd == [abcd]"),
    "refuted": lambda: gc.prove(r"ab /\ cd == ac /\ bd"),
    "refuted, of extensors": lambda: gc.prove("ab == ba"),
    "undecided": lambda: gc.prove(f"{MANY_TERMS} == {MANY_TERMS}", limit=9),
    "superbracket": lambda: gc.superbracket(OCTAHEDRON, order="2 1 3 4 5 6", form=16),
    "shortest form": lambda: gc.shortest(OCTAHEDRON),
    "analysis": lambda: gc.analyze(OCTAHEDRON),
    "analysis with the catalog's readings": lambda: gc.analyze("Aa Ab Bc Cd De Ef"),
    "analysis, always singular": lambda: gc.analyze("Aa Ba Ca Ab Bb Cb"),
    "analysis outside the catalog": lambda: gc.analyze("ab bc ca de ef fd"),
    "condition": lambda: gc.analyze(OCTAHEDRON).condition,
    "condition with a cofactor": lambda: gc.analyze("Aa Ab Bc Cd De Ef").condition,
    "certificate": lambda: gc.analyze("Aa Ab Bc Cd De Ef").condition.certificate,
    "entity": lambda: gc.analyze(OCTAHEDRON).entities[0],
    "step": lambda: gc.analyze(OCTAHEDRON).derivation.steps[0],
    "script": lambda: run_script(parse_script(SCRIPT)),
    "claim": lambda: run_script(parse_script(SCRIPT)).results[1],
    "show": lambda: run_script(parse_script(SCRIPT)).results[2],
    "show beyond the limit": lambda: run_script(parse_script(f"show {MANY_TERMS}"), limit=9).results[0],
    "numbers in a pose": pose,
    "catalog entry": lambda: load()["6-5"],
    "check of an entry": lambda: check_entry(load()["6-3.1"]),
}
OTHER_VALUES: dict[str, Callable[[], Any]] = {
    "expression": lambda: gc.parse(r"[.a b c d][.e f g h] (ab /\ cde) \/ f"),
    "derivation": lambda: gc.analyze(OCTAHEDRON).derivation,
    "structure": lambda: gc.analyze(OCTAHEDRON).structure,
    "match": lambda: gc.analyze(OCTAHEDRON).match,
    "catalog": load,
    "platform": lambda: load_platform(PLATFORM),
    "worked pose": lambda: singular_pose(gc.analyze(OCTAHEDRON).structure),
    "parsed script": lambda: parse_script(f"let x = ab {SCRIPT}"),
    "straightening": lambda: straighten_steps(polynomial("[afgl][behk][cdij]"))[1][0],
}
FLAT = ["x -100:100:4", "y -100:100:3"]
DEEP = [*FLAT, "z -500:0:3"]
NUMBERS: dict[str, Callable[[], Any]] = {
    "one pose": lambda: gc.pose(PLATFORM, "0 0 10"),
    "a singular pose": lambda: gc.pose(PLATFORM, "0 0 -400", nearest=False),
    "poses": lambda: gc.pose(PLATFORM, [[0, 0, 0], [0, 0, -400], [1, 2, 3]]),
    "reading": lambda: gc.pose(PLATFORM, [[0, 0, 0]] * 2).readings[0],
    "path": lambda: gc.path(PLATFORM, ["0 0 0", "0 0 -600"], samples=5),
    "map": lambda: gc.singular_map(PLATFORM, FLAT, limits="leg lengths 100..900"),
    "map of boxes": lambda: gc.box_map(PLATFORM, ["x -100:100", "z -400:0"], tiles=2, boxes=31),
    "map of boxes of a robot": lambda: gc.box_map("3-rpr", ["x -0.1:0.1", "yaw -5:5 deg"], tiles=1, boxes=31),
    "certificate of a range": lambda: gc.certify(PLATFORM, ["x -100:100", "z -400:0"], boxes=200),
    "map that turns": lambda: gc.singular_map(PLATFORM, ["rx -90:90:4 deg", "rz -90:90:4 deg"], measure="value"),
    "map in space": lambda: gc.singular_map(PLATFORM, DEEP),
    "map status": lambda: MapStatus("map.zarr", 200, 50, 0.5, 3.0),
    "verified map": lambda: MapVerified("map.zarr", 20, 20, (1, 7), 0, (BadTile(7, "it is damaged"),)),
    "mesh": lambda: gc.singular_map(PLATFORM, DEEP).mesh,
    "curve": lambda: gc.singular_map(PLATFORM, ["x -100:100:5", "z -600:100:5"]).curves[0],
    "modes": lambda: gc.assembly_modes(PLATFORM),
    "modes of a robot": lambda: gc.assembly_modes("3-rpr"),
    "locus": lambda: gc.locus(PLATFORM, "x, y"),
    "locus of a robot": lambda: gc.locus("3-rps", "z"),
    "operation modes": lambda: gc.operation_modes("delta"),
    "compiled condition": lambda: gc.compiled(PLATFORM, engine="numpy"),
    "compiled robot": lambda: gc.compiled("3-rps"),
    "robot": lambda: read_robot("3-rps"),
    "analysis of a robot": lambda: analyze_robot(read_robot("3-rps")),
    "pose of a robot": lambda: gc.pose("3-rps", "z=0.1, roll=5deg, pitch=0deg"),
    "aspects": lambda: gc.aspects(PLATFORM, poses=2, modes=False),
    "free_region": lambda: gc.free_region(PLATFORM, over="x, y"),
    "length regions": lambda: gc.length_regions("3-rpr", over="q2 1..2, q3 1..2"),
    "plan": lambda: gc.plan(PLATFORM, "0 0 0", "0 0 1"),
    "no plan": lambda: gc.plan("3-rpr", "home", "x=0, y=0, yaw=60deg"),
    "path of a robot": lambda: gc.path("3-rpr", ["home", "x=0, y=0, yaw=60deg"], samples=2),
    "singular pose of a robot": lambda: gc.pose("3-rps", "z=-1.1, roll=0deg, pitch=0deg"),
    "working modes": lambda: gc.working_modes("5r"),
    "factorization": lambda: gc.factor("[abcd][abef] + [abce][abdf]"),
    "discoveries": lambda: gc.discover("rank 3 given collinear(a, b, c), collinear(a, b, d)", seconds=0),
    "factors": lambda: gc.factors("[abcd][efgh] + 2[abce][dfgh]"),
    "shortening": lambda: gc.shorten("[abcd][abef] - [abce][abdf]"),
    "proof file": lambda: gc.proof_file(gc.prove(r"ab /\ cd == [abcd]")),
    "rewriting": lambda: gc.rewrite(r"(ab /\ cde) \/ f", ["expansion"]),
    "transversals": lambda: gc.transversals("Aa Ab Bc Bd Ce Df"),
    "rules": gc.load_rules,
}

EVERY = {**RESULTS, **OTHER_VALUES, **NUMBERS}
HERE = str(Path(__file__).resolve().parent)


@cache
def value_of(name: str) -> Any:
    """The value of this name, made once."""
    return EVERY[name]()


def has(value: Any, method: str) -> bool:
    return hasattr(type(value), method)


@pytest.mark.parametrize("name", EVERY)
def test_is_a_frozen_value(name: str) -> None:
    value, again = value_of(name), EVERY[name]()
    assert value == again
    assert hash(value) == hash(again)
    assert {value: 1}[again] == 1
    for field in fields(value):
        with pytest.raises((FrozenInstanceError, TypeError)):
            setattr(value, field.name, None)
    assert repr(value) == repr(again)


@pytest.mark.parametrize("name", EVERY)
def test_can_be_copied_and_pickled(name: str) -> None:
    value = value_of(name)
    for other in (pickle.loads(pickle.dumps(value)), copy.deepcopy(value), copy.copy(value)):
        assert type(other) is type(value)
        assert other == value
        assert hash(other) == hash(value)
        assert repr(other) == repr(value)
        if has(value, "to_json"):
            assert other.to_json() == value.to_json()


ELSEWHERE = """
import pickle, sys
import test_results

values = pickle.load(sys.stdin.buffer)
for name, value in values.items():
    again = test_results.EVERY[name]()
    assert value == again, name
    assert hash(value) == hash(again), name
sys.stdout.buffer.write(pickle.dumps(values))
"""


@pytest.mark.parametrize("seed", ["1"])
def test_another_process_finds_the_same_values(seed: str) -> None:
    """Pickled here, made anew and compared there where hashes of texts are others, pickled there, compared here."""
    values = {name: value_of(name) for name in EVERY}
    done = subprocess.run(
        [sys.executable, "-c", ELSEWHERE],
        input=pickle.dumps(values),
        capture_output=True,
        check=False,
        env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": os.pathsep.join((HERE, *sys.path))},
    )
    assert done.returncode == 0, done.stderr.decode()
    for name, other in pickle.loads(done.stdout).items():
        assert other == values[name], name
        assert hash(other) == hash(values[name]), name


def _answers() -> Iterator[type]:
    """All classes of gcrules that write themselves as JSON."""
    for module in pkgutil.walk_packages(gc.__path__, "gcrules."):
        if not module.name.startswith(("gcrules._", "gcrules.apps.cli")):
            classes = filter(inspect.isclass, vars(importlib.import_module(module.name)).values())
            own = (c for c in classes if c.__module__ == module.name and not inspect.isabstract(c))
            yield from (c for c in own if "to_json" in vars(c) and not getattr(c, "_is_protocol", False))


ANSWERS = list(_answers())


def test_answers_are_found() -> None:
    assert len(ANSWERS) > 50
    assert {"PoseNumbers", "PathReport", "SingularMap", "RobotPose", "Analysis"} <= {c.__name__ for c in ANSWERS}


@pytest.mark.parametrize("answer", ANSWERS, ids=lambda c: f"{c.__module__.removeprefix('gcrules.')}.{c.__name__}")
def test_answers_are_compared_by_what_they_hold(answer: type) -> None:
    assert answer.__eq__ is not object.__eq__
    assert answer.__hash__ not in (None, object.__hash__)


IN_APPS = ("studio", "view")
"""These show a robot in an app, and give back what is no result."""


def test_what_the_public_functions_return_is_in_the_tables() -> None:
    listed = {type(value_of(name)).__name__ for name in EVERY}
    surrounding = ("within", "seeded")  # these give context managers
    functions = [f for n in gc.__all__ if inspect.isfunction(f := getattr(gc, n)) and n not in (*surrounding, *IN_APPS)]
    assert len(functions) > 15
    returned = {name for f in functions for name in str(inspect.signature(f).return_annotation).split(" | ")}
    assert returned - listed == {
        "Expr",
        "Any",
        "str",
        "None",  # no singular pose on the way
        "tuple[RobotPose, ...]",
        "tuple[str, ...]",  # names of files
    }  # a sum of one class of expressions, and no values


def test_arrays_in_results_cannot_be_written_to() -> None:
    for value in (poses := gc.pose(PLATFORM, [[0, 0, 0]] * 2), pickle.loads(pickle.dumps(poses))):
        with pytest.raises(ValueError, match="read-only"):
            value.margin[0] = 1.0


@pytest.mark.parametrize("name", RESULTS)
def test_to_json(name: str) -> None:
    found = value_of(name).to_json()
    assert isinstance(found, dict)
    assert json.loads(json.dumps(found)) == found


TEXTS = [name for name in RESULTS if has(value_of(name), "text")]


def test_most_results_have_texts() -> None:
    assert set(TEXTS) >= {"bracket polynomial", "proof", "shortest form", "condition", "analysis", "script"}


@pytest.mark.parametrize("name", TEXTS)
def test_text(name: str) -> None:
    value = value_of(name)
    plain, pretty = value.text(), value.text(unicode=True)
    assert plain.strip()
    assert plain.isascii()
    assert str(value) in (plain, pretty)


@pytest.mark.parametrize("name", [name for name in RESULTS if has(value_of(name), "latex")])
def test_latex(name: str) -> None:
    value = value_of(name)
    assert value.latex().isascii()
    shown = value._repr_latex_()
    assert shown.startswith("$")
    assert shown.endswith("$")


@pytest.mark.parametrize(
    ("name", "latex"),
    [
        ("proof", r"ab \wedge cd = [abcd]"),
        ("refuted", r"ab \wedge cd \neq ac \wedge bd"),
        ("zero", "0"),
    ],
)
def test_latex_says_what_is_known(name: str, latex: str) -> None:
    assert value_of(name).latex() == latex


@pytest.mark.parametrize("name", ["bracket polynomial", "extensor polynomial", "refuted", "shortest form", "analysis"])
def test_unicode_is_mathematics(name: str) -> None:
    plain, pretty = (value_of(name).text(unicode=u) for u in (False, True))
    assert plain.isascii()
    assert any(sign in pretty for sign in "−∧·")
    assert not any(sign in pretty for sign in (" - ", "/\\", " * "))


def test_undecided_is_no_equation() -> None:
    assert r"\stackrel{?}{=}" in value_of("undecided").latex()


@pytest.mark.parametrize(("name", "proved"), [("proof", True), ("refuted", False), ("undecided", False)])
def test_proved(name: str, proved: bool) -> None:
    assert value_of(name).proved is proved


def test_text_of_a_form_counts_lines_from_one() -> None:
    assert gc.superbracket(OCTAHEDRON, order="2 1 3 4 5 6").text().splitlines()[0] == (
        "24-term form, lines in the order 2 1 3 4 5 6, 2 terms:"
    )


def test_text_of_a_condition_is_its_identity() -> None:
    text = value_of("condition with a cofactor").text()
    assert text.startswith(r"transversals: (ABc /\ ACd /\ ab) * superbracket = ")
    assert len(text.splitlines()) == 2
    latex = value_of("condition").latex()
    assert latex.startswith(r"\mathit{superbracket} = ")
    assert latex.count(r"\wedge") == 3


# --- arithmetic of polynomials -------------------------------------------------------------------------------------


def test_polynomials_of_unlike_ranks_do_not_mix() -> None:
    plane, space = gc.expand("[abc]", rank=3), gc.expand("[abcd]")
    combined: tuple[Callable[[], object], ...] = (lambda: plane + space, lambda: plane - space, lambda: space * plane)
    for combine in combined:
        with pytest.raises(StepError, match=r"rank \d and of rank \d"):
            combine()


def test_a_polynomial_is_written_over_the_points_that_occur() -> None:
    p = polynomial("[abcd] + [abce] - [abce]")
    assert p.points == ("a", "b", "c", "d", "e")
    assert str(p.over(("d", "c", "b", "a"))) == "[dcba]"
    with pytest.raises(InputError, match="missing: a, d"):
        p.over(("b", "c", "e"))


@pytest.mark.parametrize("form", [0, 20, 23, "24"])
def test_no_such_form(form: Any) -> None:
    with pytest.raises(InputError, match=r"-term form|`form` must be a whole number"):
        gc.superbracket(OCTAHEDRON, form=form)


# --- frozen mappings -----------------------------------------------------------------------------------------------


def test_frozen_map() -> None:
    found = FrozenMap({"a": 1, "b": Fraction(1, 2)})
    assert found == {"b": Fraction(1, 2), "a": 1} == found
    assert found != {"a": 1}
    assert found == FrozenMap(found)
    assert hash(found) == hash(FrozenMap(reversed(list(found.items()))))
    assert (found["a"], found.get("c"), "b" in found, "c" in found, len(found)) == (1, None, True, False, 2)
    assert list(found) == list(found.keys()) == ["a", "b"]
    assert {**found, "c": 3} == dict(found) | {"c": 3}
    assert repr(found) == "{'a': 1, 'b': Fraction(1, 2)}"
    assert not FrozenMap()
    with pytest.raises(TypeError):
        found["a"] = 2
    with pytest.raises(TypeError):
        hash(FrozenMap({"a": []}))
    source = {"a": 1}
    kept = FrozenMap(source)
    source["a"] = 2
    assert kept["a"] == 1


# --- faults --------------------------------------------------------------------------------------------------------

FAULTS = [
    InputError("no", hint="yes"),
    SyntaxFault("here", span=Span(1, 2), source="a\nb", filename="x.gca"),
    StepError("step"),
    LimitReached("too long"),
    join_faults([FileError("one", filename="x.yaml"), FileError("two", filename="x.yaml", hint="why")]),
]


@pytest.mark.parametrize("fault", FAULTS, ids=lambda f: type(f).__name__)
def test_faults_can_be_pickled(fault: gc.GcrulesError) -> None:
    other = pickle.loads(pickle.dumps(fault))
    assert type(other) is type(fault)
    assert (str(other), other.render(), other.exit_code) == (str(fault), fault.render(), fault.exit_code)


def test_the_public_names_are_those_of_the_api() -> None:
    every = {n: module for module in (discovery, factors, functions, poses, proofs, rewriting) for n in module.__all__}
    assert set(gc.__all__) == {*every, *IN_APPS, "__version__"}
    assert all(getattr(gc, name) is getattr(module, name) for name, module in every.items())


@pytest.mark.parametrize(("command", "name"), [("map", "singular_map"), ("free", "free_region")])
def test_functions_that_bear_other_names_than_commands_are_named(command: str, name: str) -> None:
    with pytest.raises(AttributeError, match=f"the command `gcrules {command}` is gcrules.{name} in Python"):
        getattr(gc, command)
