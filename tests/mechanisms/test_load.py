"""One load for all: every kind of source, in every function that takes one, from Python, the shell and the studio."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from places import EXAMPLES, ROOT

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.apps.studio.sources import source_of_word
from gcrules.apps.studio.subject import read_subject
from gcrules.core.errors import FileError, InputError
from gcrules.core.yaml_file import read_text as text_of
from gcrules.mechanisms.load import kind_of
from gcrules.mechanisms.mechanism import Mechanism, mechanism

LEGS = "ab af cb cd ed ef"
FILE = EXAMPLES / "octahedral.yaml"
ROBOT = ROOT / "plugins" / "octahedral" / "robot.yaml"
JOINTS = ROOT / "plugins" / "3-rps" / "robot.yaml"
DATA = {
    "legs": ["ab", "af", "cb", "cd", "ed", "ef"],
    "points": {"a": [0, -3, 0], "c": [3, 2, 0], "e": [-3, 2, 0], "b": [1, -1, 4], "d": [0, 1, 4], "f": [-1, -1, "4"]},
}

LEGS_ALONE, PLATFORM, SIX_LIMBS, JOINTED = "legs alone", "a platform", "six limbs", "joints"

SOURCES: dict[str, tuple[Callable[[], Any], str]] = {
    "legs as text": (lambda: LEGS, LEGS_ALONE),
    "legs as pairs": (lambda: [("a", "b"), "af", ["c", "b"], "cd", "ed", "ef"], LEGS_ALONE),
    "a structure": (lambda: gc.load(LEGS), LEGS_ALONE),
    "an analysis of legs": (lambda: gc.analyze(LEGS), LEGS_ALONE),
    "a class": (lambda: "3-3.3", LEGS_ALONE),
    "a geometry file": (lambda: str(FILE), PLATFORM),
    "a geometry file as a path": (lambda: FILE, PLATFORM),
    "the text of a geometry file": (lambda: text_of(FILE), PLATFORM),
    "an example": (lambda: "platform-6-3", PLATFORM),
    "data": (lambda: DATA, PLATFORM),
    "a platform": (lambda: gc.load(FILE), PLATFORM),
    "an analysis of a platform": (lambda: gc.analyze(FILE), PLATFORM),
    "the id of a robot on six legs": (lambda: "octahedral", SIX_LIMBS),
    "a robot file": (lambda: str(ROBOT), SIX_LIMBS),
    "the text of a robot file": (lambda: text_of(ROBOT), SIX_LIMBS),
    "the id of a robot": (lambda: "3-rps", JOINTED),
    "the file of a robot": (lambda: JOINTS, JOINTED),
    "a robot": (lambda: gc.load("3-rps"), JOINTED),
    "an analysis of a robot": (lambda: gc.analyze("3-rps"), JOINTED),
}

FUNCTIONS: dict[str, Callable[[Any], Any]] = {
    "load": gc.load,
    "analyze": lambda source: gc.analyze(source, **({} if hasattr(source, "condition") else {"search": 0})),
    "report": lambda source: gc.report(source, interactive=False),
    "pose": lambda source: gc.pose(source, nearest=False),
    "singular": lambda source: gc.singular(source, "z=0.01, roll=0deg, pitch=0deg"),
    "path": lambda source: gc.path(source, ["home", "z=0.1, roll=0deg, pitch=0deg"], samples=1),
    "assembly_modes": gc.assembly_modes,
    "locus": lambda source: gc.locus(source, over="z"),
    "export": lambda source: gc.export(source, "python"),
    "compiled": lambda source: gc.compiled(source, engine="numpy"),
    "singular_map": lambda source: gc.singular_map(source, ["z -0.1:0.1:2", "roll -5:5:2 deg"]),
    "view": gc.view,
}
NEED_COORDINATES = ("pose", "singular", "path", "assembly_modes", "locus", "export", "singular_map")


@cache
def source(name: str) -> Any:
    return SOURCES[name][0]()


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize("name", SOURCES)
def test_every_function_takes_every_source(name: str, function: str) -> None:
    """Or says, each time in the same words, what the source lacks."""
    if function == "view":
        pytest.importorskip("anywidget")
    kind = SOURCES[name][1]
    if kind == LEGS_ALONE and function in NEED_COORDINATES:
        with pytest.raises(InputError, match="legs alone have no coordinates"):
            FUNCTIONS[function](source(name))
    else:
        assert FUNCTIONS[function](source(name)) is not None or function == "singular"


def test_what_was_loaded_is_given_back() -> None:
    for name in ("a structure", "a platform", "a robot", "an analysis of legs", "an analysis of a robot"):
        assert gc.load(source(name)) is source(name)
    assert gc.analyze(source("an analysis of a robot")) is source("an analysis of a robot")


@pytest.mark.parametrize("name", [n for n, (_, kind) in SOURCES.items() if kind != LEGS_ALONE])
def test_they_are_one_kind_of_thing(name: str) -> None:
    """What the protocol asks of a mechanism, platforms and robots answer alike."""
    found: Mechanism = mechanism(source(name))
    base, platform = (found.bodies[body] for body in ("base", "platform"))
    assert base
    assert platform
    assert not set(base) & set(platform)
    assert found.title
    assert len(found.wrenches().centre) == 3
    assert len(found.actuators) == found.mobility
    assert found.analysis.condition is not None
    wrenches = found.wrenches()
    assert wrenches.rows.shape == (6, 6)
    assert wrenches.smallest_singular_value == pytest.approx(
        gc.pose(found.analysis, nearest=False).to_json()["jacobian"]["smallest_singular_value"], abs=1e-9
    )


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("legs as text", "legs as pairs"),
        ("a geometry file", "the text of a geometry file"),
        ("a robot file", "the id of a robot on six legs"),
        ("the file of a robot", "the id of a robot"),
    ],
)
def test_two_ways_to_one_condition(one: str, other: str) -> None:
    found = [gc.analyze(source(n)).condition for n in (one, other)]
    assert str(found[0].expression) == str(found[1].expression)


WORDS: dict[str, str] = {
    LEGS: "legs",
    "S1-A1, S1-B1": "legs",
    "abc /\\ def, ab": "legs",
    "ab": "legs",
    "3-rps": "robot",
    "octahedral": "robot",
    "3-3.3": "class",
    "octahedral-singular": "example",
    "no-such-file.yaml": "file",
    "folder/name": "file",
    "legs: [ab]\npoints: {a: [0, 0, 0]}": "text",
    '{"legs": ["ab"]}': "text",
}


@pytest.mark.parametrize("word", WORDS)
def test_what_a_text_is(word: str) -> None:
    assert kind_of(word) == WORDS[word]


@pytest.mark.parametrize(
    ("wrong", "error", "says", "hint"),
    [
        ("3-rsp", InputError, "is neither a file, nor the id of a robot, a class or an example, nor legs", "3-rps"),
        ("octahedral-singlar", InputError, "nor the id", "octahedral-singular"),
        ("platfrom", InputError, "nor the id", "platform"),
        ("xyzzyx", InputError, "nor the id", "gcrules robot list"),
        ("", InputError, "0 legs|no legs|empty", None),
        ("examples/octahedrl.yaml", FileError, "no such file", "octahedral.yaml"),
        ({"legs": ["ab"]}, FileError, "'points' is missing", None),
        ({"legs": object()}, InputError, "data cannot hold", None),
        ([("a", "b", "c")], InputError, "legs|leg", None),
    ],
    ids=["robot", "example", "word", "letters", "nothing", "file", "no points", "an object", "no leg"],
)
def test_faults_say_what_was_expected(wrong: Any, error: type[Exception], says: str, hint: str | None) -> None:
    with pytest.raises(error, match=says) as fault:
        gc.load(wrong)
    assert hint is None or hint in str(getattr(fault.value, "hint", "") or fault.value)


def test_an_id_of_a_plugin(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "robot.yaml").write_text(text_of(JOINTS), encoding="utf-8")
    for function in (gc.load, gc.analyze, gc.pose):
        assert "mine" in repr(function("mine", plugins=[tmp_path]))
    with pytest.raises(InputError, match="nor the id of a robot"):
        gc.load("mine")


# --- the shell and the studio --------------------------------------------------------------------------------------

SHELL = {
    "legs": (LEGS, LEGS_ALONE),
    "a class": ("3-3.3", LEGS_ALONE),
    "a geometry file": (str(FILE), PLATFORM),
    "an example": ("octahedral-singular", PLATFORM),
    "a robot": ("octahedral", SIX_LIMBS),
    "a robot file": (str(ROBOT), SIX_LIMBS),
}
COMMANDS: dict[str, list[str]] = {
    "analyze": ["--json"],
    "report": ["--no-3d"],
    "pose": ["--no-nearest", "--json"],
    "path": ["--at", "0 0 0", "--at", "z=0.1", "--samples", "1", "--json"],
    "modes": ["--json"],
    "locus": ["--over", "z", "--json"],
    "map": ["--over", "x -0.1:0.1:2", "--over", "z -0.1:0.1:2", "--measure", "value", "--json"],
}


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("name", SHELL)
def test_every_command_takes_every_source(name: str, command: str) -> None:
    word, kind = SHELL[name]
    done = CliRunner().invoke(cli, [command, word, *COMMANDS[command]])
    needs = kind == LEGS_ALONE and command in ("pose", "path", "modes", "locus", "map")
    assert done.exit_code == (2 if needs else 0), done.stderr
    assert ("legs alone have no coordinates" in done.stderr) == needs


@pytest.mark.parametrize("text", [LEGS, text_of(FILE), text_of(JOINTS)], ids=["legs", "geometry", "joints"])
def test_standard_input_is_told_alike(text: str) -> None:
    done = CliRunner().invoke(cli, ["analyze", "-", "--json"], input=text)
    assert done.exit_code == 0, done.stderr
    opened = source_of_word("-", stdin=lambda: text)
    assert read_subject(opened).title


@pytest.mark.parametrize("name", SHELL)
def test_the_studio_opens_every_source(name: str) -> None:
    word, kind = SHELL[name]
    subject = read_subject(source_of_word(word))
    assert subject.invented == (kind == LEGS_ALONE)
    assert subject.moving is not None
