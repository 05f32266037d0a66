"""The command line: exit codes, JSON, faults, arguments, files, and what a shell sees."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result
from commands import assert_refused

from gcrules.algebra.language.syntax import parse
from gcrules.apps.cli import COMMANDS, cli
from gcrules.apps.cli.catalog import COMMANDS as CATALOG_COMMANDS

OCTAHEDRON = "ab af cb cd ed ef"
Run = Callable[..., Result]


@pytest.fixture
def run() -> Run:
    """`run(*arguments, input=…)` in this process; anything but a proper exit fails the test."""

    def invoke(*arguments: str, input: str | bytes | None = None) -> Result:
        result = CliRunner().invoke(cli, arguments, input=input, prog_name="gcrules")
        if result.exception is not None and not isinstance(result.exception, SystemExit):
            raise result.exception
        return result

    return invoke


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


@pytest.fixture
def script(tmp_path: Path) -> Callable[[str], str]:
    """`script(text)`: the name of a file with this text."""

    def write(text: str) -> str:
        path = tmp_path / "x.gca"
        path.write_text(text, encoding="utf-8")
        return str(path)

    return write


# --- exit codes ----------------------------------------------------------------------------------------------------

MANY_TERMS = "([abcd] + [aefg])**30 ([aceg] + [bdfh])**30"

EXIT_CODES: list[tuple[str, tuple[str, ...], int]] = [
    ("help", ("--help",), 0),
    ("version", ("--version",), 0),
    ("proved", ("prove", r"ab /\ cd == [abcd]"), 0),
    ("refuted", ("prove", "[abcd] == [bacd]"), 1),
    ("undecided", ("prove", f"{MANY_TERMS} == {MANY_TERMS}", "--limit", "100"), 3),
    ("expanded", ("expand", r"ab /\ cde"), 0),
    ("too many terms", ("expand", MANY_TERMS, "--limit", "100"), 3),
    ("too many dots", ("expand", "[.a.b.c.d][.e.f.g.h][.i.j.k.l][.m.n.o.p]"), 3),
    ("straightened", ("straighten", "[afgl][behk][cdij]"), 0),
    ("analysed", ("analyze", OCTAHEDRON), 0),
    ("always singular", ("analyze", "Aa Ba Ca Ab Bb Cb"), 0),
    ("outside the catalog", ("analyze", "ab bc ca de ef fd"), 0),
    ("listed", ("catalog", "list"), 0),
    ("shown", ("catalog", "show", "6-3.2"), 0),
    ("syntax", ("expand", "[abcd"), 2),
    ("steps", ("expand", "[abc]"), 2),
    ("nested too deeply", ("expand", "(" * 20_000), 2),
    ("too large", ("expand", "a" * 1_000_000), 2),
    ("five legs", ("analyze", "ab af cb cd ed"), 2),
    ("a leg from a point to itself", ("analyze", "aa af cb cd ed ef"), 2),
    ("unlike steps", ("prove", "ab == c"), 2),
    ("no equation", ("prove", "ab"), 2),
    ("rank", ("expand", "a", "--rank", "9"), 2),
    ("names", ("expand", "a", "--points", "left-right"), 2),
    ("steps of an extensor", ("straighten", "ab", "--steps"), 2),
    ("no such class", ("catalog", "show", "7-7"), 2),
    ("no such file", ("analyze", "missing.yaml"), 2),
    ("no such script", ("run", "missing.gca"), 2),
    ("no such catalog", ("catalog", "list", "--catalog", "missing.yaml"), 2),
    ("no such command", ("analyse", OCTAHEDRON), 2),
    ("no such option", ("expand", "a", "--jsn"), 2),
    ("no argument", ("expand",), 2),
    ("two arguments", ("expand", "a", "b"), 2),
    ("two forms", ("expand", "a", "--json", "--latex"), 2),
    ("a wrong number", ("expand", "a", "--limit", "none"), 2),
    ("an order of five legs", ("analyze", OCTAHEDRON, "--order", "1 2 3 4 5"), 2),
    ("no directory", ("expand", "a", "-o", "missing/x.txt"), 2),
    ("figure of another kind", ("analyze", OCTAHEDRON, "--figure", "x.bmp"), 2),
]


@pytest.mark.parametrize(("arguments", "code"), [e[1:] for e in EXIT_CODES], ids=[e[0] for e in EXIT_CODES])
def test_exit_code(run: Run, arguments: tuple[str, ...], code: int) -> None:
    result = run(*arguments)
    assert result.exit_code == code, result.output
    if code == 2:
        assert result.stdout == ""
        assert result.stderr
        assert len(result.stderr) < 2_000
    else:
        assert result.stdout or code == 3


@pytest.mark.parametrize(
    "arguments",
    [
        ("expand", "[abc]", "--json"),
        ("prove", "ab == c", "--json"),
        ("analyze", "ab", "--json"),
        ("catalog", "show", "7", "--json"),
    ],
    ids=lambda a: a[0],
)
def test_faults_go_to_stderr_with_json_too(run: Run, arguments: tuple[str, ...]) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert result.stdout == ""
    assert result.stderr.startswith("error: ")


def test_fault_shows_place_caret_and_hint(run: Run) -> None:
    assert run("expand", "[abc] [abcd]").stderr.splitlines() == [
        "error: <input>:1:1: a bracket of 3 points, expected 4 in rank 4",
        "  [abc] [abcd]",
        "  ^^^^^",
        "hint: for another rank say so: `rank 3` in a file, --rank 3 in the shell",
    ]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("analyse", OCTAHEDRON), "Did you mean analyze"),
        (("straigthen", "a"), "Did you mean straighten?"),
        (("catalog", "lst"), "Did you mean list?"),
        (("xyzzy",), "There are analyze, pose, path, "),
        (("expand", "a", "--jsno"), "--json"),
        (("catalog", "show", "6-3"), "did you mean 6-3.2 or 6-3.1?"),
    ],
)
def test_suggestions(run: Run, arguments: tuple[str, ...], words: str) -> None:
    result = run(*arguments)
    assert result.exit_code == 2
    assert words in result.stderr


# --- arguments -----------------------------------------------------------------------------------------------------

MINUS = [
    ("bracket", ("expand", "-[abcd][efgh]"), "-[abcd][efgh]"),
    ("letters", ("expand", "-abc"), "-abc"),
    ("one letter", ("expand", "-a"), "-a"),
    ("a letter that is an option", ("expand", "-of"), "fo"),
    ("two signs", ("expand", "--[abcd]"), "[abcd]"),
    ("two signs and a letter", ("expand", "--a"), "a"),
    ("parenthesis", ("expand", "-(ab)"), "-ab"),
    ("digit", ("expand", "-2a"), "-2 * a"),
    ("option after it", ("expand", "-[abc]", "--rank", "3"), "-[abc]"),
    ("option before it", ("expand", "--rank=3", "-[abc]"), "-[abc]"),
    ("an option's value like an option", ("expand", "--points", "c b a", "-[abcd]"), "[cbad]"),
    ("after two dashes", ("expand", "--ascii", "--", "-o"), "-o"),
]


@pytest.mark.parametrize(("arguments", "expected"), [m[1:] for m in MINUS], ids=[m[0] for m in MINUS])
def test_arguments_that_begin_with_a_minus_sign(run: Run, arguments: tuple[str, ...], expected: str) -> None:
    command, *rest = arguments
    result = run(command, *(() if "--ascii" in rest else ("--ascii",)), *rest)
    assert (result.exit_code, result.stdout) == (0, expected + "\n"), result.stderr


def test_claims_that_begin_with_a_minus_sign(run: Run) -> None:
    assert run("prove", r"-ab /\ cd == 0").exit_code == 1
    assert run("prove", r"-ab /\ cd == -[abcd]").exit_code == 0
    assert run("straighten", "-[abcd]", "--json").exit_code == 0


def test_points_and_ideal(run: Run) -> None:
    names = ("--points", "left, right top base")
    assert run("expand", "[left right top base]", *names, "--ascii").stdout == "[left right top base]\n"
    assert run("expand", "[baseleftrighttop]", *names, "--ascii").stdout == "-[left right top base]\n"
    assert run("expand", "[ijkl]", "--ideal", "i j k l").stdout == "0\n"
    assert run("prove", "[ijkl] == 0", "--ideal", "i,j,k,l").exit_code == 0
    assert run("prove", "[ijkl] == 0").exit_code == 1
    assert "declared twice" in run("expand", "a", "--points", "a b a").stderr


def test_legs_need_no_quotes(run: Run) -> None:
    one = run("analyze", OCTAHEDRON, "--json")
    assert run("analyze", *OCTAHEDRON.split(), "--json").stdout == one.stdout
    assert run("analyze", "left top", "--json").exit_code == 2
    long = "left top, left base, right top, right front, back front, back base"
    answer = json.loads(run("analyze", long, "--points", "left right back top base front", "--json").stdout)
    assert answer["class"] == "3-3.3"
    assert answer["legs"][0] == ["left", "top"]


@pytest.mark.parametrize("command", ["expand", "straighten"])
def test_standard_input(run: Run, command: str) -> None:
    assert run(command, "-", "--ascii", input="[abcd]\n - 2[abce]\n").stdout == "[abcd] - 2[abce]\n"


def test_standard_input_of_other_commands(run: Run, root: Path) -> None:
    assert run("prove", "-", input="[abcd]\n==\n[bacd]").exit_code == 1
    assert run("run", "-", input="claim a == a").exit_code == 0
    legs = json.loads(run("analyze", "-", "--json", input=OCTAHEDRON + "\n").stdout)
    file = (root / "examples" / "octahedral.yaml").read_text(encoding="utf-8")
    assert json.loads(run("analyze", "-", "--json", input=file).stdout) | {"pose": None} == legs


@pytest.mark.parametrize(
    "data", [b"\xff\xfe\x00", bytes(range(256)), b"[abcd]" * 10**6], ids=["utf-16", "bytes", "6 MB"]
)
def test_standard_input_that_is_no_text(run: Run, data: bytes) -> None:
    for command in ("expand", "prove", "run", "analyze"):
        result = run(command, "-", input=data)
        assert result.exit_code == 2
        assert result.stderr.startswith("error: <stdin>")


def test_fault_in_standard_input_names_the_place(run: Run) -> None:
    assert "<stdin>:2:6: " in run("run", "-", input="rank 3\nshow [abcd]").stderr


# --- forms of output -----------------------------------------------------------------------------------------------


def answer(result: Result) -> Any:
    assert result.exit_code in (0, 1, 3), result.stderr
    assert result.stdout.isascii()
    return json.loads(result.stdout)


def test_json_of_expand_and_straighten(run: Run) -> None:
    found = answer(run("expand", r"ab /\ cde", "--json"))
    assert found.keys() >= {"polynomial", "terms", "step"}
    assert (found["terms"], found["step"]) == (2, 1)
    assert parse(found["polynomial"]).step == 1
    found = answer(run("straighten", "[afgl][behk][cdij]", "--json"))
    assert found["step"] == 0
    assert found["terms"] == len(parse(found["polynomial"]).children)


def test_json_of_steps(run: Run) -> None:
    found = answer(run("straighten", "[p1p4p5][p1p5p6][p2p3p4]", "--rank", "3", "--steps", "--json"))
    assert found["terms"] == 3
    assert found["steps"]
    for step in found["steps"]:
        assert run("prove", f"{step['before']} == {step['after']}", "--rank", "3").exit_code == 0


def test_json_of_prove(run: Run) -> None:
    proved = answer(run("prove", r"ab /\ cd == [abcd]", "--json"))
    assert proved.keys() >= {"verdict", "counterexample", "assumed"}
    assert (proved["verdict"], proved["counterexample"]) == ("proved", None)
    refuted = answer(run("prove", "[abcd] == [bacd]", "--json"))
    assert refuted["verdict"] == "refuted"
    assert refuted["counterexample"].keys() == set("abcd")
    assert all(len(c) == 4 for c in refuted["counterexample"].values())
    undecided = answer(run("prove", f"{MANY_TERMS} == {MANY_TERMS}", "--limit", "100", "--json"))
    assert undecided["verdict"] == "undecided"
    assert "2,000 products of terms" in undecided["reason"]


ANALYSIS_KEYS = {
    "schema", "legs", "class", "points", "superbracket", "shortest", "entities", "group", "condition", "readings",
    "certificate", "derivation",
}  # fmt: skip
CONDITION_KEYS = {"kind", "expression", "cofactor", "coefficient", "statement"}


@pytest.mark.parametrize(
    "legs", [OCTAHEDRON, "Aa Ab Ac Bd Ce Df", "Aa Bb Cc Dd Ee Ff", "Aa Ba Ca Ab Bb Cb", "ab bc ca de ef fd"]
)
def test_json_of_analyze(run: Run, legs: str) -> None:
    found = answer(run("analyze", legs, "--json"))
    assert found.keys() >= ANALYSIS_KEYS
    assert found["schema"] == 1
    assert found["legs"] == [list(leg) for leg in legs.split()]
    assert found["superbracket"].keys() >= {"order", "terms", "polynomial"}
    assert found["shortest"].keys() >= {"form", "order", "terms", "polynomial"}
    assert found["shortest"]["form"] in (24, 16)
    for entity in found["entities"]:
        assert entity.keys() >= {"kind", "points", "starred"}
    for reading in (found["condition"], *found["readings"]):
        assert reading.keys() >= CONDITION_KEYS
    assert "method" in found["certificate"]
    for step in found["derivation"]:
        assert step.keys() >= {"rule", "before", "after", "why"}


@pytest.mark.parametrize("legs", [OCTAHEDRON, "Aa Ab Ac Bd Ce Df", "Aa Ab Bc Cd De Ef", "aA Ab Bc Bd Ce Df"])
def test_the_identity_of_the_condition_holds_as_printed(run: Run, legs: str) -> None:
    found = answer(run("analyze", legs, "--json"))
    superbracket = "[[" + ", ".join(legs.split()) + "]]"
    for reading in (found["condition"], *found["readings"]):
        left = f"({reading['cofactor']}) * {superbracket}"
        assert run("prove", f"{left} == {reading['coefficient']} * ({reading['expression']})").exit_code == 0


def test_json_of_run(run: Run, script: Callable[[str], str]) -> None:
    path = script('let p = ab /\\ cde\nclaim "x": p == 0\n\nclaim a == a\nshow p\n')
    result = run("run", path, "--json")
    found = answer(result)
    assert result.exit_code == 1
    assert found["verdict"] == "refuted"
    assert [(r["kind"], r["line"], r["label"]) for r in found["results"]] == [
        ("claim", 2, "x"),
        ("claim", 4, "a == a"),
        ("show", 5, "p"),
    ]
    assert [r.get("verdict") for r in found["results"]] == ["refuted", "proved", None]
    assert found["results"][2]["terms"] == 2


def test_json_of_the_catalog(run: Run) -> None:
    classes = answer(run("catalog", "list", "--json"))["classes"]
    assert len(classes) == 39
    entry = answer(run("catalog", "show", "3-3.3", "--json"))
    assert entry in classes


def test_legs_in_json_are_pairs_everywhere(run: Run) -> None:
    legs = answer(run("catalog", "show", "3-3.3", "--json"))["legs"]
    assert legs == [["A", "a"], ["A", "b"], ["B", "a"], ["B", "c"], ["C", "b"], ["C", "c"]]
    spelt = " ".join(map("".join, legs))
    assert answer(run("analyze", spelt, "--json"))["legs"] == legs
    assert all(len(leg) == 2 for c in answer(run("catalog", "enumerate", "--json"))["classes"] for leg in c["legs"])


def test_every_class_is_shown_with_sentences(run: Run) -> None:
    for found in answer(run("catalog", "list", "--json"))["classes"]:
        sentences = [r["statement"] for r in (found["condition"], *found["readings"])]
        assert all(s.endswith(".") and "{" not in s for s in sentences), found["id"]


@pytest.mark.parametrize("class_id", ["6-5", "6-3.2", "5-4.4", "3-2"])
def test_catalog_show(run: Run, class_id: str) -> None:
    lines = run("catalog", "show", class_id, "--ascii").stdout.splitlines()
    found = answer(run("catalog", "show", class_id, "--json"))
    for reading in (found["condition"], *found["readings"]):
        assert f"{'':11}{reading['statement']}" in lines
    identities = [line for line in lines if " superbracket = " in line]
    assert len(identities) == 1 + len(found["readings"])
    assert identities[0].startswith(f"condition  {found['condition']['kind']}: ")
    assert not any("{" in line for line in lines)


def test_latex(run: Run) -> None:
    assert run("expand", r"ab /\ cde", "--latex").stdout == "[acde]\\,b - [bcde]\\,a\n"
    assert r"\wedge" in run("prove", r"ab /\ cd == [abcd]", "--latex").stdout
    assert r"\neq" in run("prove", "[abcd] == [bacd]", "--latex").stdout
    assert r"\begin{document}" in run("analyze", OCTAHEDRON, "--latex").stdout


def test_unicode_and_ascii(run: Run) -> None:
    e = r"-[abcd] (ab /\ cde)"
    assert run("expand", e, "--unicode").stdout.startswith("−")
    for flag in ("--ascii", "--plain"):
        assert run("expand", e, flag).stdout.isascii()
        assert run("prove", r"ab /\ cd == [bacd]", flag).stdout.isascii()
    plain, pretty = (run("expand", e, flag).stdout for flag in ("--ascii", "--unicode"))
    assert parse(plain) == parse(pretty)


def test_what_is_printed_can_be_read_again(run: Run) -> None:
    printed = run("expand", r"(ab /\ cde) \/ fg - 3/2 [abcd] efg").stdout
    assert run("expand", printed).stdout == printed


def test_text_of_prove_shows_the_counterexample(run: Run) -> None:
    lines = run("prove", "[abcd] == 0").stdout.splitlines()
    assert lines[0] == "refuted: [abcd] == 0"
    assert sum(line.startswith(f"  {n} = (") for line in lines for n in "abcd") == 4


# --- scripts -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "code", "last"),
    [
        ("", 0, "0 claims"),
        ("claim a == a", 0, "1 claim: 1 proved"),
        ("claim a == a\nclaim a == b", 1, "2 claims: 1 proved, 1 refuted"),
        (f"claim {MANY_TERMS} == {MANY_TERMS}", 3, "1 claim: 1 undecided"),
        (f"claim {MANY_TERMS} == {MANY_TERMS}\nclaim a == b", 1, "2 claims: 1 refuted, 1 undecided"),
        (f"show {MANY_TERMS}", 3, "0 claims"),
    ],
    ids=["nothing", "proved", "refuted", "undecided", "refuted and undecided", "show too large"],
)
def test_run(run: Run, script: Callable[[str], str], text: str, code: int, last: str) -> None:
    result = run("run", script(text), "--limit", "100")
    assert result.exit_code == code, result.stderr
    assert result.stdout.splitlines()[-1] == last


def test_run_shows_lines_labels_and_counterexamples(run: Run, script: Callable[[str], str]) -> None:
    lines = run("run", script('# x\nclaim "one": a == a\nclaim a == b\nshow ab /\\ cd')).stdout.splitlines()
    assert lines[0] == "line 2: proved: one"
    assert lines[1] == "line 3: refuted: a == b"
    assert any(line.startswith("    a = (") for line in lines)
    assert r"line 4: ab /\ cd = [abcd]" in lines


def test_run_names_the_file_in_faults(run: Run, script: Callable[[str], str]) -> None:
    path = script("rank 3\nclaim [abcd] == 0")
    result = run("run", path)
    assert result.exit_code == 2
    assert f"{path}:2:7: a bracket of 4 points, expected 3 in rank 3" in result.stderr


# --- files ---------------------------------------------------------------------------------------------------------


def test_output_file(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.write_text("old")
    result = run("analyze", OCTAHEDRON, "--json", "-o", str(path))
    assert (result.exit_code, result.stdout) == (0, "")
    assert json.loads(path.read_text(encoding="utf-8"))["class"] == "3-3.3"
    assert [p.name for p in tmp_path.iterdir()] == ["x.json"]


def test_output_file_is_left_alone_by_a_fault(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "x.txt"
    path.write_text("old")
    assert run("expand", "[abc]", "-o", str(path)).exit_code == 2
    assert path.read_text() == "old"


def test_output_through_a_link_keeps_the_link(run: Run, tmp_path: Path) -> None:
    target, link = tmp_path / "target.txt", tmp_path / "link.txt"
    link.symlink_to(target)
    assert run("expand", "a", "-o", str(link)).exit_code == 0
    assert link.is_symlink()
    assert target.read_text() == "a\n"


def test_output_to_a_device_does_not_replace_it(run: Run) -> None:
    assert run("expand", "a", "-o", os.devnull).exit_code == 0
    assert not os.path.isfile(os.devnull)


@pytest.mark.parametrize("command", ["expand", "report"])
def test_output_that_cannot_be_written(run: Run, tmp_path: Path, command: str) -> None:
    argument = "a" if command == "expand" else OCTAHEDRON
    missing = run(command, argument, "-o", str(tmp_path / "none" / "x.html"))
    assert (missing.exit_code, "no such directory" in missing.stderr) == (2, True)
    directory = run(command, argument, "-o", str(tmp_path))
    assert (directory.exit_code, "this is a directory" in directory.stderr) == (2, True)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_output_without_permission(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "x.txt"
    path.write_text("old")
    path.chmod(0o444)
    result = run("expand", "a", "-o", str(path))
    assert (result.exit_code, "write-protected" in result.stderr) == (2, True)


def test_geometry_file(run: Run, root: Path, tmp_path: Path) -> None:
    figure = tmp_path / "robot.svg"
    path = str(root / "examples" / "octahedral.yaml")
    result = run("analyze", path, "--json", "--figure", str(figure))
    assert json.loads(result.stdout)["class"] == "3-3.3"
    assert figure.read_text(encoding="utf-8").startswith("<svg")


def test_faulty_geometry_file(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "x.yaml"
    path.write_text("legs: [ab, cd]\npoint: {a: [0, 0, 0]}\n")
    result = run("analyze", str(path))
    assert result.exit_code == 2
    assert f"{path}:2:1" in result.stderr


def test_report(run: Run, root: Path, tmp_path: Path) -> None:
    path = tmp_path / "x.html"
    assert run("report", str(root / "examples" / "octahedral.yaml"), "-o", str(path)).exit_code == 0
    page = path.read_text(encoding="utf-8")
    assert page.startswith("<!DOCTYPE html>")
    assert "<math" in page
    assert run("report", OCTAHEDRON).stdout.startswith("<!DOCTYPE html>")


@pytest.mark.parametrize("ending", ["pdf", "PDF", "svg", "png", "json", "tex", "md", "txt", "yaml", "docx", "csv"])
def test_reports_are_pages(run: Run, tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"a.{ending}"
    done = run("report", OCTAHEDRON, "-o", str(path))
    assert_refused(done, 2, "a report is a page in HTML")
    assert f"write {tmp_path / 'a.html'}" in done.stderr
    assert not path.exists()


@pytest.mark.parametrize("name", ["a.html", "a.htm", "a.xhtml", "a", "a.report", "3-rps.v2"])
def test_other_names_of_reports(run: Run, tmp_path: Path, name: str) -> None:
    assert run("report", OCTAHEDRON, "--no-3d", "-o", str(tmp_path / name)).exit_code == 0
    assert (tmp_path / name).read_text(encoding="utf-8").startswith("<!DOCTYPE html>")


def test_catalog_of_the_users_own(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "own.yaml"
    path.write_text("classes: [{id: x}]\n")
    result = run("catalog", "check", "--catalog", str(path))
    assert result.exit_code == 2
    assert f"{path}:1:" in result.stderr


def test_catalog_check_refutes(run: Run, tmp_path: Path) -> None:
    """The shipped entry of one class under another id, with a wrong sign."""
    entry = json.loads(run("catalog", "show", "3-3.3", "--json").stdout)
    condition = {k: v for k, v in entry["condition"].items() if v is not None}
    condition["coefficient"] = -condition["coefficient"]
    keys = ("legs", "degrees", "terms", "factors", "group", "status", "sources")
    own = {"id": "mine", **{k: entry[k] for k in keys}, "condition": condition}
    own["legs"] = " ".join(map("".join, own["legs"]))
    own["group"] = own["group"] or "none"
    path = tmp_path / "own.yaml"
    path.write_text(json.dumps({"classes": [own]}))
    result = run("catalog", "check", "--catalog", str(path), "--json")
    assert result.exit_code == 1, result.stderr
    wrong = [c for c in json.loads(result.stdout)["classes"] if c["faults"]]
    assert [c["id"] for c in wrong] == ["mine"]


def test_catalog_enumerate(run: Run) -> None:
    found = answer(run("catalog", "enumerate", "--json"))
    assert found["count"] == len(found["classes"]) == 39
    assert len({c["class"] for c in found["classes"]}) == 39


# --- help and completion -------------------------------------------------------------------------------------------

ALL_COMMANDS = [*((name,) for name in COMMANDS), *(("catalog", name) for name in CATALOG_COMMANDS)]


@pytest.mark.parametrize("command", ALL_COMMANDS, ids=" ".join)
def test_help(run: Run, command: tuple[str, ...]) -> None:
    result = run(*command, "--help")
    assert result.exit_code == 0
    assert "\b" not in result.stdout
    assert "\\b" not in result.stdout
    if command != ("catalog",):
        assert f"gcrules {' '.join(command)}" in result.stdout.partition("\n\n")[2]
    assert run(*command, "-h").stdout == result.stdout


@pytest.mark.parametrize("name", COMMANDS)
def test_the_list_of_commands_says_what_each_is_called(run: Run, name: str) -> None:
    assert f"\n  {name} " in run("--help").stdout
    loaded = cli.get_command(None, name)  # type: ignore[arg-type]
    assert loaded is not None
    assert loaded.name == name


@pytest.mark.parametrize("kind", ["bash", "zsh", "fish"])
def test_completion_script(run: Run, kind: str) -> None:
    result = run("completion", kind)
    assert result.exit_code == 0
    assert "_GCRULES_COMPLETE" in result.stdout


@pytest.mark.parametrize(
    ("words", "expected"),
    [("gcrules str", {"straighten"}), ("gcrules catalog e", {"enumerate"}), ("gcrules expand -ab --j", {"--json"})],
)
def test_completion(words: str, expected: set[str]) -> None:
    env = {"_GCRULES_COMPLETE": "bash_complete", "COMP_WORDS": words, "COMP_CWORD": str(len(words.split()) - 1)}
    assert set(shell(env=env).stdout.split()) == {f"plain,{word}" for word in expected}


# --- a real shell --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("prove", "[abcd] == -[bacd]"), 0),
        (("prove", "-[abcd] == [abcd]"), 1),
        (("expand", "[abc]"), 2),
        (("expand", MANY_TERMS, "--limit", "9"), 3),
        (("expnd", "a"), 2),
        (("--version",), 0),
    ],
    ids=["proved", "refuted", "input", "undecided", "usage", "version"],
)
def test_exit_codes_of_the_process(arguments: tuple[str, ...], code: int) -> None:
    done = shell(*arguments)
    assert done.returncode == code
    assert "Traceback" not in done.stderr


def test_output_encoding_decides_about_unicode() -> None:
    assert shell("expand", "-a").stdout == "−a\n"
    for encoding in ("ascii", "latin-1"):
        assert shell("expand", "-a", env={"PYTHONIOENCODING": encoding}).stdout == "-a\n"
    done = shell("analyze", OCTAHEDRON, env={"PYTHONIOENCODING": "ascii"})
    assert done.returncode == 0
    assert done.stdout.isascii()


def test_no_colour_in_a_pipe() -> None:
    assert "\x1b" not in shell("prove", "[abcd] == 0").stdout
    assert "\x1b" not in shell("expand", "[abc]").stderr


def in_terminal(*arguments: str, env: dict[str, str]) -> str:
    """What the command writes to a terminal."""
    import pty

    child, terminal = pty.fork()
    if child == 0:  # pragma: no cover
        code = "from gcrules.apps.main import main; main()"
        os.execve(sys.executable, [sys.executable, "-c", code, *arguments], os.environ | env)
    chunks = []
    while True:
        try:
            chunk = os.read(terminal, 65536)
        except OSError:
            break
        if not chunk:
            break
        chunks.append(chunk)
    os.waitpid(child, 0)
    os.close(terminal)
    return b"".join(chunks).decode("utf-8")


def test_colour_on_a_terminal_unless_told_otherwise() -> None:
    plain = {"NO_COLOR": "", "TERM": "xterm"}
    assert "\x1b[" in in_terminal("prove", "[abcd] == 0", env=plain)
    assert "\x1b[" in in_terminal("expand", "[abc]", env=plain)
    assert "\x1b" not in in_terminal("prove", "[abcd] == 0", env=plain | {"NO_COLOR": "1"})
    assert "\x1b" not in in_terminal("expand", "[abc]", env=plain | {"NO_COLOR": "1"})


def test_broken_pipe_is_quiet() -> None:
    code = "from gcrules.apps.main import main; main()"
    with subprocess.Popen(
        [sys.executable, "-c", code, "straighten", "[afgl][behk][cdij]", "--steps"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        process.stdout.close()
        assert process.stderr.read() == b""
    assert process.returncode == 141


def test_interrupt_is_quiet() -> None:
    """The expansion takes minutes; the interrupt comes when it has begun."""
    started = (
        "import sys, gcrules.apps.cli.algebra; print('ready', flush=True); from gcrules.apps.main import main; main()"
    )
    long = "*".join(["(abc /\\ def /\\ ghi /\\ jkl)"] * 40)
    with subprocess.Popen(
        [sys.executable, "-c", started, "expand", long, "--limit", "1000000000"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        assert process.stdout.readline() == b"ready\n"
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        try:
            assert process.communicate(timeout=60) == (b"", b"")
        finally:
            process.kill()
    assert process.returncode == 130


def test_internal_faults_are_not_hidden() -> None:
    code = (
        "import gcrules.apps.cli.algebra as a; from gcrules.apps.main import main\n"
        "def broken(*args, **options): raise RuntimeError('broken')\n"
        "a.expanded = broken; main()"
    )
    done = subprocess.run([sys.executable, "-c", code, "expand", "a"], capture_output=True, text=True)
    assert done.returncode == 70
    assert "RuntimeError: broken" in done.stderr
    assert "a fault of gcrules" in done.stderr


def test_starting_loads_nothing_heavy() -> None:
    code = "import sys, gcrules.apps.cli; print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"numpy", "networkx", "sympy", "matplotlib", "lark", "yaml", "gcrules.conditions.analysis"} & set(loaded)


@pytest.mark.parametrize(
    "words", [["expand", "ab"], ["straighten", "[abcd]"], ["prove", "ab /\\ cd == [abcd]"]], ids=" ".join
)
def test_small_answers_load_nothing_heavy(words: list[str]) -> None:
    code = f"import sys; from gcrules.apps.cli import cli; cli({words!r}, standalone_mode=False); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "gcrules.apps.cli.algebra" in loaded
    assert not {"numpy", "networkx", "sympy", "matplotlib", "gcrules.conditions.analysis"} & set(loaded)
