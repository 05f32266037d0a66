"""Messages say what to type: one table for each family of mistakes."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import click
import pytest
from click.testing import CliRunner, Result
from commands import assert_refused
from places import ROOT

from gcrules.apps.cli import cli
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.core.errors import GcrulesError, LimitReached
from gcrules.core.hints import files_like, number_with_unit, run_together
from gcrules.core.yaml_file import Document
from gcrules.mechanisms.robot import Robot

PLATFORM = str(ROOT / "examples" / "octahedral.yaml")
LEGS = "ab af cb cd ed ef"


def run(*arguments: str) -> Result:
    return CliRunner().invoke(cli, arguments, prog_name="gcrules")


# --- functions of other notations -----------------------------------------------------------------------------------

CALLS = {
    "meet(ab, cde)": r"the meet is an operator between its parts: ab /\ cde",
    "Meet(ab, cde)": r"ab /\ cde",
    "[a, b, c, meet(de, fgh)]": r"de /\ fgh",
    "wedge(ab, cde)": r"ab /\ cde",
    "intersection(abc, def, ghi)": r"abc /\ def /\ ghi",
    r"meet(ab \/ c, de)": r"(ab \/ c) /\ de",
    "join(a, b)": r"the join is an operator between its parts: a \/ b",
    "2 * join(a, b) /\\ cde": r"a \/ b",
    "det(a, b, c, d)": "a bracket is written [a, b, c, d]",
    "det(abcd)": "a bracket is written [abcd]",
    "bracket(a,b,c,d)": "[a, b, c, d]",
    "superbracket(ab,cd,ef,gh,ij,kl)": "the superbracket is written [[ab, cd, ef, gh, ij, kl]]",
    "meet(ab, )": "the meet is an operator between its parts: A /\\ B",
    "wedge(ab)": r"A /\ B",
    "join()": r"A \/ B",
}
COMMANDS = [("expand", ""), ("straighten", ""), ("factor", ""), ("shorten", ""), ("prove", " == 0")]


@pytest.mark.parametrize(("text", "hint"), CALLS.items(), ids=CALLS)
@pytest.mark.parametrize(("command", "more"), COMMANDS, ids=[c for c, _ in COMMANDS])
def test_functions_are_written_as_operators(command: str, more: str, text: str, hint: str) -> None:
    done = run(command, text + more)
    assert done.exit_code == 2
    assert hint in done.stderr


def test_functions_in_scripts(tmp_path: Path) -> None:
    (tmp_path / "a.gca").write_text("claim meet(ab, cd) == [abcd]\n", encoding="utf-8")
    done = run("run", str(tmp_path / "a.gca"))
    assert done.exit_code == 2
    assert "ab /\\ cd" in done.stderr


@pytest.mark.parametrize("text", ["[abcd", "(ab /\\ cde", "ab, cd", "colinear(a, b)", "[ab, cd) meet(ab, cd)"])
def test_other_faults_keep_their_advice(text: str) -> None:
    assert "operator between" not in run("expand", text).stderr


# --- files ----------------------------------------------------------------------------------------------------------

MISSING = {
    "analyze": ("analyze", "{}"),
    "report": ("report", "{}"),
    "pose": ("pose", "{}"),
    "path": ("path", "{}", "--at", "0 0 0", "--at", "1 0 0"),
    "locus": ("locus", "{}", "--over", "x"),
    "map": ("map", "{}", "--over", "x -1:1:3", "--over", "y -1:1:3"),
    "robot analyze": ("robot", "analyze", "{}"),
    "robot check": ("robot", "check", "{}"),
    "modes": ("modes", "{}"),
    "robot pose": ("robot", "pose", "{}"),
    "robot show": ("robot", "show", "{}"),
    "a catalog": ("analyze", LEGS, "--catalog", "{}"),
    "catalog check": ("catalog", "check", "--catalog", "{}"),
}


@pytest.mark.parametrize("arguments", MISSING.values(), ids=MISSING)
def test_missing_files_have_neighbours(arguments: tuple[str, ...], tmp_path: Path) -> None:
    (tmp_path / "octahedral.yaml").write_text("legs: []\n", encoding="utf-8")
    missing = str(tmp_path / "octahedrl.yaml")
    done = run(*(a.format(missing) for a in arguments))
    assert done.exit_code == 2
    assert f"{missing}: there is no such file" in done.stderr
    assert f"did you mean {tmp_path / 'octahedral.yaml'}?" in done.stderr


OTHER_FILES = {
    "script": ("run", "thorems.gca", "theorems.gca"),
    "rules": ("rules check", "thorems.gca", "theorems.gca"),
    "poses": (f"path {PLATFORM} --poses", "pats.csv", "path.csv"),
}


@pytest.mark.parametrize(("command", "name", "near"), OTHER_FILES.values(), ids=OTHER_FILES)
def test_other_missing_files(command: str, name: str, near: str, tmp_path: Path) -> None:
    (tmp_path / near).write_text("", encoding="utf-8")
    done = run(*command.split(), str(tmp_path / name))
    assert done.exit_code == 2
    assert "there is no such file" in done.stderr
    assert f"did you mean {tmp_path / near}?" in done.stderr


def test_files_like(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "examples" / "octahedral.yaml").mkdir(parents=True)
    (tmp_path / "examples" / "octahedral-2.yaml").write_text("", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert files_like("octahedral-3.yaml") == f"did you mean {Path('examples', 'octahedral-2.yaml')}?"
    assert files_like("nothing-like-it.gca") is None
    assert files_like(str(Path("nowhere", "a.yaml"))) == "there is no folder nowhere"
    assert files_like("") is None
    assert files_like("examples") is None


# --- names that are nearly right ------------------------------------------------------------------------------------

NEAR = {
    "command": (("analyse", LEGS), "analyze"),
    "command of robots": (("robot", "chek"), "check"),
    "command of the catalog": (("catalog", "shw"), "show"),
    "option": (("expand", "ab", "--rnk", "3"), "--rank"),
    "robot": (("pose", "octahedrall"), "octahedral"),
    "robot to analyze": (("robot", "analyze", "3-rsp"), "3-rps"),
    "robot as legs": (("analyze", "octahedrall"), "octahedral"),
    "class": (("catalog", "show", "6-33"), "6-3.2 or 6-3.1"),
    "rule": (("rules", "show", "exansion"), "expansion"),
    "export": (("locus", PLATFORM, "--over", "z", "--export", "mapel"), "maple"),
    "command of the prompt": (("repl", "-e", ":expnd ab"), ":expand"),
}


@pytest.mark.parametrize(("arguments", "near"), NEAR.values(), ids=NEAR)
def test_close_names(arguments: tuple[str, ...], near: str) -> None:
    done = run(*arguments)
    assert done.exit_code == 2
    assert "did you mean" in (done.stderr + done.stdout).lower()
    assert near in done.stderr + done.stdout


@pytest.mark.parametrize(
    ("command", "option", "others"),
    [("analyze", "--at", ("pose", "path")), ("pose", "--given", ("analyze",)), ("expand", "--over", ("locus", "map"))],
)
def test_options_of_other_commands(command: str, option: str, others: tuple[str, ...]) -> None:
    done = run(command, "3-rps", option, "x=0.1")
    assert done.exit_code == 2
    assert f"{option} is an option of " in done.stderr
    assert all(other in done.stderr for other in others)


# --- coordinates ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("number", ["650 mm", "650mm", "-1.5 m", "1e3 in", "1/3 cm"])
def test_numbers_with_units(number: str, tmp_path: Path) -> None:
    text = Path(PLATFORM).read_text(encoding="utf-8").replace("a: [0, -300, 0]", f"a: [0, -300, {number}]")
    (tmp_path / "a.yaml").write_text(text, encoding="utf-8")
    parts = number_with_unit(number)
    assert parts is not None
    assert_refused(run("analyze", str(tmp_path / "a.yaml")), 2, f"hint: write {parts[0]}; the unit is given once")
    assert f"units: {parts[1]}" in run("analyze", str(tmp_path / "a.yaml")).stderr


def test_numbers_with_units_in_robots(tmp_path: Path) -> None:
    text = (ROOT / "plugins" / "3-rps" / "robot.yaml").read_text(encoding="utf-8").replace("[2, 0, 0]", "[2 m, 0, 0]")
    (tmp_path / "robot.yaml").write_text(text, encoding="utf-8")
    assert_refused(
        run("robot", "analyze", str(tmp_path / "robot.yaml")), 2, "write 2; the unit is given once in the file"
    )


@pytest.mark.parametrize("text", ["abc", "1,5", "mm", "--1", "1 2"])
def test_other_numbers(text: str) -> None:
    document = Document.parse(f"a: '{text}'\n")
    assert document.root.mapping({"a"})["a"].rational() is None
    with pytest.raises(GcrulesError) as fault:
        document.check()
    assert fault.value.hint == "numbers are written 3, -0.25, 1e-3 or 1/3"


OVER = {
    "locus": (("locus", PLATFORM, "--over", "xy"), 'separate them: "x, y"; the variables are x, y, z'),
    "locus, three": (("locus", PLATFORM, "--over", "xyz"), 'separate them: "x, y, z"'),
    "locus, turns": (("locus", PLATFORM, "--over", "e0e1e2"), 'separate them: "e0, e1, e2"'),
    "locus, unknown": (("locus", PLATFORM, "--over", "w"), "x, y, z"),
    "map": (("map", PLATFORM, "--over", "xy"), "one --over for each of x and y; the coordinates are x, y, z; roll"),
    "map, no range": (("map", PLATFORM, "--over", "x"), "the coordinates are x, y, z; roll, pitch, yaw; rx, ry, rz"),
    "map, two in one": (("map", PLATFORM, "--over", "x -1:1:3, y -1:1:3"), '"x -200:200:201"'),
}


@pytest.mark.parametrize(("arguments", "hint"), OVER.values(), ids=OVER)
def test_coordinates_that_are_run_together(arguments: tuple[str, ...], hint: str) -> None:
    done = run(*arguments)
    assert done.exit_code == 2
    assert hint in done.stderr


@pytest.mark.parametrize(
    ("word", "found"),
    [("xy", ("x", "y")), ("rxx", ("rx", "x")), ("xx", None), ("x", None), ("", None), ("yawx", ("yaw", "x"))],
)
def test_run_together(word: str, found: tuple[str, ...] | None) -> None:
    assert run_together(word, ("x", "y", "z", "rx", "yaw")) == found


AT = {
    "too few": ("3-rps", "x=0.1", 'give 3; the others follow from them: "z=0, roll=0deg, pitch=0deg"'),
    "too few, but some": ("3-rps", "pitch=2deg", '"pitch=2deg, z=0, roll=0deg"'),
    "too few, in the plane": ("3-rrr", "yaw=1deg", '"yaw=1deg, x=0, y=0"'),
    "too few, a rotation vector": ("gallardo-4dof", "rx=1deg", '"rx=1deg, y=0, z=0, ry=0deg"'),
    "too many": ("3-rps", "x=0.1, y=0, z=0, yaw=4deg", '"z=0, roll=0deg, pitch=0deg"'),
    "too many, of the first": ("delta", "x=0.1, y=0, z=0, yaw=4deg", '"x=0.1, y=0, z=0"'),
    "no commas": ("3-rps", "x=0.1 y=0 z=0", "two values without a comma"),
    "a name that no platform has": (PLATFORM, "x=0.1, rol=2deg", "did you mean roll?"),
    "a unit that the platform has not": (PLATFORM, "x=0.1 cm", "give lengths in mm"),
}


@pytest.mark.parametrize(("robot", "at", "hint"), AT.values(), ids=AT)
def test_poses(robot: str, at: str, hint: str) -> None:
    done = run("pose", robot, "--at", at)
    assert done.exit_code == 2
    assert hint in done.stderr


@pytest.mark.parametrize(
    "wanted", ["x=0", "yaw=0deg", "rx=0deg", "z=0, x=0, y=0, roll=0deg, pitch=0deg, yaw=0deg, rx=0deg"]
)
@pytest.mark.parametrize("robot", ["3-rps", "3-rrr-spherical", "delta", "exechon", "gough-stewart", "tricept"])
def test_the_coordinates_of_the_hint_do(robot: str, wanted: str) -> None:
    refused = run("pose", robot, "--no-nearest", "--at", wanted)
    if refused.exit_code == 0:
        return
    proposed = re.search(r'follow from them: "(.*)"', refused.stderr)
    if proposed is None:
        assert "roll, pitch, yaw and rx, ry, rz" in refused.stderr
        return
    assert run("pose", robot, "--no-nearest", "--at", proposed[1]).exit_code == 0


RELATIONS = ("collinear(a, b, c)", "[abcd] + coplanar(a, b, c, d)", "concurrent(ab, cd, ef)", "2 incident (a, bc)")


@pytest.mark.parametrize("text", RELATIONS)
@pytest.mark.parametrize(("command", "more"), COMMANDS)
def test_relations_are_no_expressions(command: str, more: str, text: str) -> None:
    done = run(command, text + more)
    assert done.exit_code == 2
    assert "is a relation, not an expression" in done.stderr
    assert "not closed" not in done.stderr


NEED_COORDINATES = {
    "pose": ("pose", LEGS),
    "path": ("path", LEGS, "--at", "0 0 0", "--at", "1 0 0"),
    "locus": ("locus", LEGS, "--over", "x"),
    "map": ("map", LEGS, "--over", "x -1:1:3", "--over", "y -1:1:3"),
}


@pytest.mark.parametrize("arguments", NEED_COORDINATES.values(), ids=NEED_COORDINATES)
def test_legs_without_coordinates(arguments: tuple[str, ...]) -> None:
    assert_refused(run(*arguments), 2, "legs alone have no coordinates")
    said = run(*arguments).stderr
    assert all(word in said for word in ("examples/octahedral.yaml", "gcrules studio", "gcrules analyze"))


# --- robots ---------------------------------------------------------------------------------------------------------


def test_a_check_that_runs_out_of_time_says_where_it_stopped() -> None:
    done = run("robot", "check", "delta", "3-rps", "--seconds", "0")
    assert done.exit_code == 3
    assert done.stderr.startswith("error: this takes more than 0 seconds: 2 of 2 robots are not checked\nhint: ")
    assert "--seconds" in done.stderr


def test_a_robot_that_is_not_decided_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def slow(robot: Robot) -> None:
        raise LimitReached("this takes more than 1 second")

    monkeypatch.setattr("gcrules.apps.cli.robot.analyze_robot", slow)
    done = run("robot", "check", "delta", "3-rps")
    assert done.exit_code == 3
    assert done.stderr.splitlines() == [f"error: {name}: this takes more than 1 second" for name in ("delta", "3-rps")]


# --- the prompt -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("word", ["help", "?", " Help ", "help()"])
def test_help_without_a_colon(word: str) -> None:
    told = [a.text for a in Interpreter().feed(word)]
    assert told == [a.text for a in Interpreter().feed(":help")]


@pytest.mark.parametrize("word", ["quit", "exit", "QUIT", "exit()", "quit;", "bye"])
def test_leaving_without_a_colon(word: str) -> None:
    repl = Interpreter()
    assert not list(repl.feed(f"{word}\nab"))
    assert repl.over


@pytest.mark.parametrize("declared", ["let help = ab", "points help x", "ideal help"])
def test_declared_names_stay_names(declared: str) -> None:
    repl = Interpreter()
    *_, answer = repl.feed(f"{declared}\nhelp")
    assert answer.text in ("ab", "help")


@pytest.mark.parametrize("word", ["(help)", "help + a", "helps"])
def test_expressions_stay_expressions(word: str) -> None:
    assert [a.text for a in Interpreter().feed(word)] != [a.text for a in Interpreter().feed(":help")]


SPOKEN = [
    "help prove", "Help  meet ", "prove [abcd] == -[abdc]", "factor [abcd][abce]", "expand ab /\\ cde", "latex ab",
    "analyze ab af cb cd ed ef", "straighten [adcb]", "context", "limit 3 4", "load nowhere.gca", "prove ab",
]  # fmt: skip


@pytest.mark.parametrize("text", SPOKEN)
def test_a_command_is_understood_without_its_colon(text: str) -> None:
    """The answers are the same, and faults stand where they are."""
    (bare,), (answer,) = Interpreter().feed(text), Interpreter().feed(f":{text.strip().lower()}".replace("  ", " "))
    assert (bare.fault is None) == (answer.fault is None)
    assert bare.text.splitlines()[0].split(": ")[-1] == answer.text.splitlines()[0].split(": ")[-1]


def test_a_word_that_can_be_read_is_no_command() -> None:
    *_, answer = Interpreter().feed("let factor = ab\nfactor /\\ cde")
    assert answer.text == "[acde] · b − [bcde] · a"
    *_, answer = Interpreter().feed("rank 6\nrules x")
    assert answer.text == "elrsux"


def test_help_with_a_word_may_be_points() -> None:
    *_, answer = Interpreter().feed("rank 6\nhelp o")
    assert answer.fault is None


# --- commands that messages name ------------------------------------------------------------------------------------


def test_messages_name_commands_that_exist() -> None:
    """Of a group the command of the group too."""
    named = set()
    for path in sorted((ROOT / "gcrules").rglob("*.py")):
        for constant in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(constant, ast.Constant) and isinstance(constant.value, str):
                named |= set(re.findall(r'[`"]gcrules ([a-z]+)(?: ([a-z]+))?', constant.value))
    assert len(named) > 20
    for first, second in sorted(named):
        command = cli.get_command(click.Context(cli), first)
        assert command is not None, first
        if isinstance(command, click.Group) and second and not command.invoke_without_command:
            assert command.get_command(click.Context(command), second) is not None, (first, second)
