"""A section for a paper: its files, figures and works, and what is said as proved."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest
from commands import invoke
from places import EXAMPLES, ROOT

import gcrules as gc
from gcrules.algebra.language.syntax import parse
from gcrules.core.errors import FileError
from gcrules.core.version import __version__
from gcrules.views.drawing.drawing import Circle, Drawing, Polygon, Run, Stroke, Text
from gcrules.views.paper.bibliography import cited_in, own_entry, references
from gcrules.views.paper.formulas import MACROS, displayed, equation
from gcrules.views.paper.paper import files_of, save
from gcrules.views.paper.tikz import tikz, trimmed

OCTAHEDRAL = EXAMPLES / "octahedral.yaml"
FILES = {"section.tex", "figure.tex", "references.bib", "main.tex"}
KINDS = {
    "planes": ("ab af cb cd ed ef", r"\begin{theorem}", "is proved: both sides have the same normal form"),
    "no incidence": ("Aa Bb Cc Dd Ee Ff", r"\begin{theorem}", "lie in one hyperplane"),
    "cofactor": ("Aa Ab Ba Cc Dd Ee", r"\begin{theorem}", "there the identity decides nothing"),
    "always singular": ("Aa Ab Ac Ad Be Cf", r"\begin{theorem}", "the normal form of the superbracket is 0"),
    "the plane": ("ab cd ef", r"\begin{theorem}", "the three lines are linearly"),
}


@pytest.mark.parametrize(("legs", "kind", "words"), KINDS.values(), ids=KINDS)
def test_theorems_of_legs(legs: str, kind: str, words: str) -> None:
    rank = 3 if len(legs.split()) == 3 else 4
    section = files_of(gc.analyze(legs, rank=rank))["section.tex"]
    assert kind in section
    assert words in " ".join(section.split())


def test_what_is_seen_at_members_of_a_family_is_told_apart_from_the_proof() -> None:
    section = " ".join(files_of(gc.analyze("3-rps"))["section.tex"].split())
    assert "[Proof of the identity, and how sure the rest is]" in section
    assert "exact random members of the family" in section
    assert "Suppose that the limbs apply the wrenches above." in section


def test_files_of_a_command(tmp_path: Path) -> None:
    folder = tmp_path / "paper"
    run = invoke("paper", str(OCTAHEDRAL), "-o", str(folder))
    assert run.exit_code == 0, run.output
    assert {p.name for p in folder.iterdir()} == FILES
    assert sorted(run.stdout.split()) == sorted(str(folder / name) for name in FILES)
    again = invoke("paper", str(OCTAHEDRAL), "-o", str(folder), "--full")
    assert again.exit_code == 0, again.output
    assert {p.name for p in folder.iterdir()} == {*FILES, "appendix.tex"}


def test_files_of_others_are_kept(tmp_path: Path) -> None:
    (tmp_path / "main.tex").write_text("mine", encoding="utf-8")
    with pytest.raises(gc.GcrulesError, match="gcrules did not write"):
        save(gc.analyze("ab af cb cd ed ef"), tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == ["main.tex"]
    run = invoke("paper", "delta", "-o", str(tmp_path / "main.tex"))
    assert run.exit_code == 2
    assert "expected a directory" in run.stderr


def test_what_an_author_changed_is_kept(tmp_path: Path) -> None:
    analysis = gc.analyze("ab af cb cd ed ef")
    save(analysis, tmp_path)
    save(analysis, tmp_path)  # what nobody has changed is written anew
    section = tmp_path / "section.tex"
    section.write_bytes(section.read_bytes().replace(b"singular", b"degenerate", 1))
    (tmp_path / "main.tex").write_bytes(b"% mine\n" + (tmp_path / "main.tex").read_bytes())
    others = {p: p.read_bytes() for p in tmp_path.iterdir()}
    run = invoke("paper", "ab af cb cd ed ef", "-o", str(tmp_path))
    assert run.exit_code == 2
    assert f"{section}: this file is not as gcrules wrote it, and main.tex likewise" in run.stderr
    assert "--force" in run.stderr
    assert {p: p.read_bytes() for p in tmp_path.iterdir()} == others
    assert invoke("paper", "ab af cb cd ed ef", "-o", str(tmp_path), "--force").exit_code == 0
    written = {p.name: p.read_text("utf-8") for p in tmp_path.iterdir()}
    assert written == files_of(analysis)
    section.write_bytes(b"mine")
    gc.paper("ab af cb cd ed ef", tmp_path, force=True)
    assert {p.name: p.read_text("utf-8") for p in tmp_path.iterdir()} == written


def test_bad_input_is_refused(tmp_path: Path) -> None:
    run = invoke("paper", "no-such-robot", "-o", str(tmp_path / "new"))
    assert run.exit_code == 2
    assert not (tmp_path / "new").exists()


def test_a_report_is_no_pdf(tmp_path: Path) -> None:
    run = invoke("report", "ab af cb cd ed ef", "-o", str(tmp_path / "x.pdf"))
    assert run.exit_code == 2
    assert not list(tmp_path.iterdir())


def test_the_digest_is_that_of_the_analysis() -> None:
    one, other = (files_of(gc.analyze(legs))["section.tex"] for legs in ("ab af cb cd ed ef", "ab af cb cd ed eg"))
    digest = re.compile(r"sha256 of the analysis ([0-9a-f]{64})")
    found = [digest.search(text) for text in (one, other)]
    assert all(found)
    digests = [m[1] for m in found if m]
    assert digests[0] != digests[1]
    assert digests[0][:16] in one.split("Reproducibility")[1]


# --- dimensions -----------------------------------------------------------------------------------------------------


def test_dimensions_are_tables_with_units_in_their_head() -> None:
    section = files_of(gc.analyze(gc.load(OCTAHEDRAL)))["section.tex"]
    joints = section.partition(r"\label{tab:octahedral-platform-3-3-joints}")[2].partition(r"\end{table}")[0]
    assert r"point & $x$ (mm) & $y$ (mm) & $z$ (mm) \\" in joints
    assert r"$a$ & $0$ & $-300$ & $0$ \\" in joints
    assert "Not every pose is singular: an exact pose is known in which the legs are independent." in section
    assert "certificate: " not in section


def test_directions_have_no_unit_and_facts_have_signs() -> None:
    section = files_of(gc.analyze(gc.load(EXAMPLES / "tutorial" / "tripod.yaml")))["section.tex"]
    assert r"$S_{2}$ & $-60$ & $90$ & $300$ \\" in section
    assert r"direction & $x$ & $y$ & $z$ \\" in section
    assert "the axes $A_{1}r_{1}$, $A_{2}r_{2}$ and $A_{3}r_{3}$ are in one plane" in section
    facts = files_of(gc.analyze("delta"))["section.tex"]
    assert r"links & \gccell $|O_{2}A_{2}| = |O_{3}A_{3}|$" in facts
    assert "what holds of the bodies, exactly, in every pose" in facts


def test_what_holds_nearly_is_told_with_its_deviation() -> None:
    section = " ".join(files_of(gc.analyze("reachy-mini-head"))["section.tex"].split())
    assert r"body & what holds & deviation \\" in section
    assert re.search(r"\|A_\{1\}B_\{1\}\| \\approx .* & \$\\leq \d\.\d \\cdot 10\^\{-1\d\}\$ \\\\", section)
    assert "Of the 3 mirrors that take the base to itself and the platform too it names one." in section


def test_lines_that_points_share_are_assumed_once() -> None:
    section = " ".join(files_of(gc.analyze("h4"))["section.tex"].split())
    assumed = section.partition(r"\begin{theorem}")[2].partition("The identity")[0].partition("Suppose that ")[2]
    assert assumed.strip() == (
        "$z$, $p_{1}$ and $p_{1}'$ lie on a line; $z$, $p_{2}$ and $p_{2}'$ lie on a line;"
        " the points $z$ and $p_{1}$ differ; and the points $z$ and $p_{2}$ differ."
    )


def test_what_holds_of_several_limbs_is_said_once() -> None:
    section = files_of(gc.analyze("8-cables"))["section.tex"]
    assert r"cable 5, cable 6, cable 7 and cable 8: none found" in section
    assert section.count("zero where they belong to one linear complex") == 1
    assert "--full" not in section
    assert "-{}-full" not in section


def test_robots_have_a_home_pose_and_platforms_one_of_their_file() -> None:
    robot, platform = (files_of(gc.analyze(gc.load(source)))["section.tex"] for source in ("delta", OCTAHEDRAL))
    assert "lists the numbers in the home pose;" in robot
    assert "of the file" not in robot
    assert "lists the numbers in the pose of the file;" in platform


# --- works ----------------------------------------------------------------------------------------------------------


def test_how_to_cite() -> None:
    entry = invoke("cite").stdout
    assert entry.strip() == own_entry()
    assert f"Version {__version__}" in entry
    title = re.search(r'^title: "(.*)"$', (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    assert title
    assert re.sub(r"[{}]", "", entry).replace("--", "-").count(title[1]) == 1


def test_works_have_what_they_need() -> None:
    found = references(["SinguLab2008", "White1983", "no-such-key"])
    assert re.findall(r"^@\w+\{(\w+),", found, re.MULTILINE) == ["SinguLab2008", "White1983", "gcrules"]
    assert "read in full" not in found
    assert "arXiv:0809.3182" in found
    assert cited_in("Liu2006 (abstract read)") == ("Liu2006",)


@pytest.mark.parametrize("source", ["ab af cb cd ed ef", "delta", "4-upu", str(OCTAHEDRAL)])
def test_all_that_is_cited_is_listed(source: str) -> None:
    files = files_of(gc.analyze(gc.load(source)))
    cited = {key for keys in re.findall(r"\\cite\{([^}]*)\}", files["section.tex"]) for key in keys.split(",")}
    assert cited == set(re.findall(r"^@\w+\{(\w+),", files["references.bib"], re.MULTILINE))


# --- figures --------------------------------------------------------------------------------------------------------


def test_shapes_in_tikz() -> None:
    runs = (Run("a_1", "italic"), Run("2", "subscript"))
    shapes = (
        Polygon(((0, 0), (10, 0), (5, 5)), "entity1", "ink", fill_opacity=0.5),
        Stroke((0, 0), (1, 2), dash=(3, 2)),
        Circle((1, 1), 2),
        Text((3, 4), runs, 10, "end", halo=True),
    )
    lines = tikz(Drawing(20, 10, shapes)).splitlines()
    assert r"\definecolor{gcentity1}{HTML}{0072B2}" in lines
    assert "fill opacity=0.5" in lines[-5]
    assert "dash pattern=on 3bp off 2bp" in lines[-4]
    assert "circle[radius=2bp]" in lines[-3]
    assert r"\textit{a\_1}\textsubscript{2}" in lines[-2]


def test_margins_are_cut() -> None:
    cut = trimmed(Drawing(200, 100, (Circle((100, 50), 10),)))
    assert (cut.width, cut.height) == (28, 28)


# --- formulas -------------------------------------------------------------------------------------------------------

LONG = r"[abcd](aef /\ bgh /\ ck) + 2[abce][dfgh]([abcd][efgh][ijkl] + [abce][dfgh][ijkl] - [abde][cfgh][ijkl])[aghi]"
TERMS = " + ".join(f"[abc{x}][def{y}][ghi{z}]" for x, y, z in ("def", "efd", "fde", "dfe", "fed", "edf"))


def _lines(formulas: Sequence[str], layout: str, folder: Path) -> list[str]:
    """The lines in which LaTeX sets formulas, without the numbers of equations."""
    body = [
        written for f in formulas for written in (displayed("", parse(f)), equation(parse("[abcd]"), parse(f), "x"))
    ]
    head = [rf"\documentclass[{layout}]{{article}}", r"\usepackage{amsmath}", r"\begin{document}\pagestyle{empty}"]
    (folder / "f.tex").write_text("\n".join([*head, MACROS, *body, r"\end{document}"]), encoding="utf-8")
    for command in (["pdflatex", "-interaction=batchmode", "f"], ["pdftotext", "-layout", "f.pdf"]):
        subprocess.run(command, cwd=folder, capture_output=True, timeout=300, check=False)
    assert "Overfull" not in (folder / "f.log").read_text("latin-1")
    lines = (folder / "f.txt").read_text("utf-8").split("\n")
    return [line for line in (re.sub(r"\s|\(\d\)\s*$", "", line) for line in lines) if line]


@pytest.mark.needs("pdflatex", "pdftotext")
@pytest.mark.parametrize("layout", ["10pt", "10pt,twocolumn"])
def test_formulas_break_before_a_sign(layout: str, tmp_path: Path) -> None:
    """A line begins with a sign, a product that goes on with a dot; brackets stay whole."""
    lines = _lines([LONG, TERMS], layout, tmp_path)
    assert sum(line[0] not in "=+−·∧" for line in lines) == 4  # the beginnings of the formulas
    assert all(line.count("[") == line.count("]") for line in lines)
    assert any(line[0] in "+−" for line in lines)
    assert any(line[0] == "·" for line in lines)
    assert not any(line[0] == "·" for line in _lines([TERMS], layout, tmp_path))  # its terms fit


# --- set by LaTeX ---------------------------------------------------------------------------------------------------


@pytest.mark.needs("pdflatex", "bibtex")
@pytest.mark.parametrize("source", ["Aa Ab Ba Cc Dd Ee", "3-rps"])
def test_the_files_set_themselves(source: str, tmp_path: Path) -> None:
    save(gc.analyze(gc.load(source)), tmp_path, full=True)
    latex = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "main"]
    for run in (latex, ["bibtex", "main"], latex, latex):
        done = subprocess.run(run, cwd=tmp_path, capture_output=True, timeout=300, check=False)
        assert done.returncode == 0, done.stdout[-2000:]
    log = (tmp_path / "main.log").read_text(encoding="latin-1")
    assert "undefined" not in log
    assert "Warning--" not in (tmp_path / "main.blg").read_text(encoding="latin-1")


def test_from_python(tmp_path: Path) -> None:
    """The files of `gcrules paper`, word for word; wrong folders are refused before anything is written."""
    written = gc.paper("3-rps", tmp_path / "python", full=True)
    assert invoke("paper", "3-rps", "-o", str(tmp_path / "shell"), "--full").exit_code == 0
    for path in map(Path, written):
        assert path.read_text("utf-8") == (tmp_path / "shell" / path.name).read_text("utf-8")
    (tmp_path / "file").write_text("mine", "utf-8")
    with pytest.raises(FileError, match="expected a directory"):
        gc.paper("3-rps", tmp_path / "file")


def test_a_theorem_under_assumptions_names_them(tmp_path: Path) -> None:
    given = "coplanar(A, B, C, D), coplanar(A, B, C, E)"
    assert invoke("paper", "Aa Bb Cc Dd Ee Ff", "--given", given, "-o", str(tmp_path)).exit_code == 0
    section = (tmp_path / "section.tex").read_text(encoding="utf-8")
    theorem = section.partition(r"\begin{theorem}")[2].partition(r"\end{theorem}")[0]
    assert "Suppose that $A$, $B$, $C$ and $D$ lie in a plane;" in theorem
    assert "and A, B and C are not on a line." in theorem
