"""The command line: JSON and the other forms of answers, scripts, files."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from click.testing import Result
from commands import Run, assert_refused

from gcrules.algebra.language.syntax import parse

MANY_TERMS = "([abcd] + [aefg])**30 ([aceg] + [bdfh])**30"

OCTAHEDRON = "ab af cb cd ed ef"


@pytest.fixture
def script(tmp_path: Path) -> Callable[[str], str]:
    """`script(text)`: the name of a file with this text."""

    def write(text: str) -> str:
        path = tmp_path / "x.gca"
        path.write_text(text, encoding="utf-8")
        return str(path)

    return write


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
