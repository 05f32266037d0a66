"""Every kind of LaTeX that is written, set by pdflatex: all examples, classes and robots, with units and long names.

The documents are set in a few runs, one after the other in one file; each fault that LaTeX finds is told of the
document in which it stands.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st
from places import ROOT

import gcrules as gc
from gcrules.algebra.language.syntax import parse
from gcrules.apps.cli import cli
from gcrules.apps.studio.export import saved
from gcrules.apps.studio.protocol.requests import PoseJson
from gcrules.apps.studio.subject import read_subject
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.editing.platform_text import platform_text
from gcrules.mechanisms.load import read_robot
from gcrules.rules.catalog.file import load
from gcrules.screws.pose import UNITS
from gcrules.views.formulas.latex import latex, latex_name
from gcrules.views.formulas.latex_text import latex_document, latex_quantity, latex_words

PLATFORMS = sorted((ROOT / "examples").glob("*.yaml"))
ROBOTS = [one.id for one in robots(())]
MOVED: PoseJson = {"translation": [0.5, -1.25, 3], "quaternion": [0.9, 0.1, 0, 0.2]}


SAMPLE_OF_SIGNS = [*range(0x20, 0x500), *range(0x1E00, 0x2400), *range(0xD7F0, 0xD810), *range(0xFB00, 0xFB10)]
HARD_TITLE = "50 % of A & B_1 #{x} ~ ^ \\ ü ° mm¹² ẋ Σσ 中 $ [y]"


# --- what is written ------------------------------------------------------------------------------------------------


def command(*arguments: str) -> str:
    """What a command prints."""
    done = CliRunner().invoke(cli, arguments, prog_name="gcrules")
    assert done.exit_code in (0, 1), done.output
    return done.stdout


def formula(code: str) -> str:
    """A document of one formula, or of the rows of several."""
    return latex_document([f"\\begin{{gather*}}\n{code.rstrip()}\n\\end{{gather*}}"])


def studio(source: dict[str, str], pose: PoseJson = MOVED) -> str:
    """The TeX that the studio saves."""
    subject = read_subject(source)
    return saved(subject, pose, "latex", None)["data"]


def long_name(name: str) -> str:
    """A name of many letters with underscores, digits and primes."""
    return f"upper_joint_{name}_{ord(name[0])}''"


def long_legs(legs: Iterable[tuple[str, str]]) -> tuple[tuple[str, str], ...]:
    return tuple((long_name(a), long_name(b)) for a, b in legs)


def long_platform(path: Path, folder: Path) -> str:
    """A platform file whose points have long names, with units, and a title that LaTeX cannot take as it is."""
    p = load_platform(path)
    points = {long_name(n): xyz for n, xyz in p.points.items()}
    found = folder / path.name
    found.write_text(platform_text(HARD_TITLE, HARD_TITLE, "um", long_legs(p.legs), points), encoding="utf-8")
    return str(found)


ALL_CLASSES = {e.id: e.legs for e in load().entries}

PAPERS: Mapping[str, Callable[[Path], str]] = {
    **{f"example {p.stem}": lambda _, p=p: command("analyze", str(p), "--latex", "--full") for p in PLATFORMS},
    **{f"long {p.stem}": lambda t, p=p: command("analyze", long_platform(p, t), "--latex") for p in PLATFORMS},
    **{f"studio {p.stem}": lambda _, p=p: studio({"kind": "example", "name": p.stem}) for p in PLATFORMS},
    **{f"class {c}": lambda _, c=c: gc.analyze(ALL_CLASSES[c]).latex() for c in ALL_CLASSES},
    **{f"long class {c}": lambda _, c=c: gc.analyze(long_legs(ALL_CLASSES[c])).latex() for c in ALL_CLASSES},
    **{f"robot {r}": lambda _, r=r: analyze_robot(read_robot(r)).latex() for r in ROBOTS},
    "studio delta": lambda _: studio({"kind": "robot", "id": "delta"}),
}

FORMULAS = {
    "expand": ("expand", "[[left_1 b, left_1 f, c b, c d, e_2' d, e_2' f]]", "--points", "left_1, e_2'"),
    "expand, an extensor": ("expand", r"1/2 (S1A' /\ cde) \/ f"),
    "straighten": ("straighten", "[afgl][behk][cdij]"),
    "straighten, in steps": ("straighten", "[p1p4p5][p1p5p6][p2p3p4]", "--rank", "3", "--steps"),
    "factor": ("factor", "[abcd][efgh] - [abce][dfgh]"),
    "factor, with cofactors": ("factor", "[abc][ade][cde] + [acd][ade][bce]", "--rank", "3", "--cofactor"),
    "factor, none": ("factor", "[abcd][efgh] + [abef][cdgh]"),
    "shorten": ("shorten", "[abcd][efgh] - [abce][dfgh]"),
    "prove": ("prove", "[abc][def] == 0", "--rank", "3", "--given", "collinear(a, b, c)"),
    "prove, refuted": ("prove", r"ab /\ cd == ac /\ bd"),
    "rewrite": ("rewrite", r"S_1 b /\ cde", "--rules", "expansion"),
    "transversals": ("transversals", "Aa Ab Bc Bd Ce Df", "--full"),
    "transversals, none": ("transversals", "Aa Bb Cc Dd Ee Ff"),
    "locus": ("locus", str(ROOT / "examples" / "octahedral.yaml"), "--over", "z"),
    "locus, long": ("locus", str(ROOT / "examples" / "octahedral.yaml"), "--over", "x, y, z"),
}
TABLES = {
    **{f"pose {p.stem}": ("pose", str(p), "--no-nearest") for p in PLATFORMS},
    "nearest poses": ("pose", str(PLATFORMS[0])),
    "modes": ("modes", str(PLATFORMS[0])),
    **{f"pose {r}": ("robot", "pose", r) for r in ("3-rps", "4-ruu", "delta", "exechon", "tricept")},
}

OUTPUTS: dict[str, Callable[[Path], str]] = {
    **{name: lambda _, a=a: formula(command(*a, "--latex")) for name, a in FORMULAS.items()},
    "words": lambda _: latex_document([rf"\section*{{{latex_words(HARD_TITLE)}}}"]),
    "every sign": lambda _: latex_document(rf"{latex_words(chr(c))}\par" for c in SAMPLE_OF_SIGNS),
    "units": lambda _: latex_document(latex_quantity(-3e-7, u, 9) for u in (*UNITS, "deg", "rad")),
    **{name: lambda _, a=a: latex_document([command(*a, "--latex")]) for name, a in TABLES.items()},
}


# --- set by LaTeX ---------------------------------------------------------------------------------------------------


ONE, TWO = "[10pt]{article}", "[10pt,twocolumn]{article}"
WORKS = re.compile(r"\\begin\{filecontents\}.*?\\end\{filecontents\}\n", re.DOTALL)


def faults(
    documents: Mapping[str, str], folder: Path, engine: str = "pdflatex", columns: str = ONE, *, wide: bool = False
) -> dict[str, str]:
    """What LaTeX finds at fault, for each document; they stand in one file, so they must begin alike. Only formulas
    that stand alone may be as `wide` as they like.
    """
    begin, end = "\\begin{document}", "\\end{document}"
    heads = {WORKS.sub("", d.partition(begin)[0]) for d in documents.values()}
    assert len(heads) == 1
    lines = [heads.pop().replace(ONE, columns) + begin]
    for n, document in enumerate(documents.values()):
        body, closed, rest = document.partition(begin)[2].rpartition(end)
        assert closed
        assert not rest.strip()
        lines += [f"\\typeout{{document {n}.}}\\setcounter{{section}}{{0}}{{%", body, "}\\clearpage"]
    (folder / "all.tex").write_text("\n".join([*lines, end]), encoding="utf-8")
    run = [engine, "-draftmode", "-interaction=nonstopmode", "all.tex"]
    subprocess.run(run, cwd=folder, capture_output=True, timeout=300, check=False)
    log = (folder / "all.log").read_text(encoding="latin-1")
    _, *parts = re.split(r"^document \d+\.$", log, flags=re.MULTILINE)
    assert len(parts) == len(documents), log[-2000:]
    found = {}
    for name, part in zip(documents, parts, strict=True):
        at = re.search(r"^(! .*|Missing character: .*)", part, re.MULTILINE)
        if not at and not wide:
            at = too_wide(part, LONG_NAMES if name.startswith("long ") else A_POINT)
        if at:
            found[name] = part[at.start() : at.start() + 400]
    return found


LONG_NAMES, A_POINT = 60, 1  # points by which lines with names of a dozen letters may be too wide, and all others


def too_wide(log: str, most: int) -> re.Match[str] | None:
    """The first line that stands out into the margin by more than this."""
    boxes = re.finditer(r"^Overfull \\hbox \((\d+\.\d*)pt too wide\).*\n.*", log, re.MULTILINE)
    return next((m for m in boxes if float(m[1]) > most), None)


@pytest.fixture(scope="module")
def papers(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """Every paper, as one document each."""
    folder = tmp_path_factory.mktemp("papers")
    return {name: make(folder) for name, make in PAPERS.items()}


def test_what_has_a_number_is_referred_to(papers: dict[str, str]) -> None:
    """Figures, tables and equations, in each paper."""
    assert len(papers) > 100
    for name, paper in papers.items():
        numbered = set(re.findall(r"\\label\{((?:fig|tab|eq):[^}]*)\}", paper))
        assert numbered <= set(re.findall(r"\\(?:eq)?ref\{([^}]*)\}", paper)), name


def test_nothing_is_said_twice(papers: dict[str, str]) -> None:
    """Neither a sentence, nor what an item of a list says of something, in any paper up to its appendix."""
    for name, paper in papers.items():
        section = paper.partition(r"\section")[2].partition(r"\appendix")[0]
        said = re.sub(r"\\begin\{(table|figure)\}.*?\\end\{\1\}", "", section, flags=re.DOTALL)
        sentences = re.split(r"(?<=[.:])\s+|\n\s*\n|\\item ", said)
        items = re.findall(r"^\\item [^:\n]*: (.*)$", said, re.MULTILINE)
        for found in ([s.strip() for s in sentences if len(s.split()) > 3], items):
            assert [s for s in set(found) if found.count(s) > 1] == [], name


@pytest.mark.needs("pdflatex", "tikz.sty")
@pytest.mark.parametrize("columns", [ONE, TWO], ids=["one column", "two columns"])
def test_papers_compile(papers: dict[str, str], columns: str, tmp_path: Path) -> None:
    assert faults(papers, tmp_path, columns=columns) == {}


@pytest.mark.needs("lualatex", "luaotfload.sty", "tikz.sty")
def test_papers_compile_with_lualatex(papers: dict[str, str], tmp_path: Path) -> None:
    assert faults(papers, tmp_path, "lualatex", TWO) == {}


@pytest.mark.needs("pdflatex", "tikz.sty")
def test_outputs_compile(tmp_path: Path) -> None:
    assert faults({name: make(tmp_path) for name, make in OUTPUTS.items()}, tmp_path, wide=True) == {}


@pytest.mark.needs("pdflatex", "tikz.sty")
def test_faults_are_found(tmp_path: Path) -> None:
    documents = {"good": latex_document(["a"]), "sign": latex_document(["mm⁹"]), "command": latex_document(["a_1"])}
    assert faults(documents, tmp_path).keys() == {"sign", "command"}


def test_there_is_something_to_compile() -> None:
    assert len(PLATFORMS) > 3
    assert len(ROBOTS) > 15
    assert len(ALL_CLASSES) == 39
    assert any(load_platform(p).units for p in PLATFORMS)


# --- words and quantities -------------------------------------------------------------------------------------------

WORDS = {
    "power of a unit": ("3 mm⁹", "3 mm$^{9}$"),
    "exponent of two signs": ("10⁻¹²", "10$^{-12}$"),
    "subscript": ("a₀ᵢ", "a$_{0i}$"),
    "commands": (r"50% of {a_1} & #$~^\ ", r"50\% of \{a\_1\} \& \#\$\~{}\^{}\textbackslash{} "),
    "accents": ("Plücker, ẋ, Ł, ß", r"Pl\"{u}cker, \.{x}, \L{}, \ss{}"),
    "signs": ("σ ≤ 1°, a → b, A ∧ B", r"$\sigma$ $\leq$ 1$^{\circ}$, a $\to$ b, A $\wedge$ B"),
    "capital Greek": ("ΣΑ", r"$\Sigma$A"),
    "no sign for it": ("中", "[U+4E2D]"),
    "no ligatures": ("--full, A''", "-{}-full, A'{}'"),
    "lines": ("a\n\nb\tc", "a  b c"),
}


@pytest.mark.parametrize(("words", "expected"), WORDS.values(), ids=WORDS)
def test_words(words: str, expected: str) -> None:
    assert latex_words(words) == expected


@given(st.text())
def test_any_text_becomes_one_line_of_ascii(words: str) -> None:
    found = latex_words(words)
    assert found.isascii()
    assert not found or found.isprintable()


@pytest.mark.parametrize(
    ("x", "unit", "power", "expected"),
    [
        (-3.08392e23, "mm", 9, r"$-3.084 \cdot 10^{23}\,\mathrm{mm}^{9}$"),
        (2, "", 1, "$2$"),
        (3e-7, "deg", 1, r"$3 \cdot 10^{-7}{}^{\circ}$"),
        (0.5, "rad", 1, r"$0.5\,\mathrm{rad}$"),
        (float("inf"), "mm", 1, r"$\infty$"),
        (float("nan"), "mm", 1, "not defined"),
    ],
)
def test_quantities(x: float, unit: str, power: int, expected: str) -> None:
    assert latex_quantity(x, unit, power) == expected


def test_rules_with_underscores_leave_the_mathematics_alone() -> None:
    assert r"S_{1}" in gc.rewrite(r"S1 b /\ cde", ["expansion"]).latex()


@pytest.mark.parametrize("name", ["alpha", "S_1'", "upper_joint_a_97''", "A''"])
def test_names_are_one_group(name: str) -> None:
    """A name that a letter follows is set apart from it, and an index stays with its name."""
    assert latex(parse(f"[{name}, b, c, d]", points=[name])).startswith(f"[{latex_name(name)}")
