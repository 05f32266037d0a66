"""The catalog's pages: complete, linked, true at their worked poses, and kept up to date by the command."""

from __future__ import annotations

import json
import os
import random
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

import gcrules
from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Point, join
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.language.text import text as formula
from gcrules.apps.cli import cli
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import free_motions
from gcrules.core.budget import within
from gcrules.mechanisms.platform_analysis import analyze
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.catalog.file import load
from gcrules.rules.strategy import Strategy
from gcrules.views.drawing import bsp, graph, labels, legend, sample, scene, solids
from gcrules.views.drawing import viewpoint as view
from gcrules.views.drawing.drawing import Circle, Drawing, Line, Polygon, Text
from gcrules.views.drawing.figures import graph_figure, named_lines, robot_figure, shown_entities, thumbnail
from gcrules.views.drawing.labels import label_box, overlap
from gcrules.views.pages import catalog_pages as renderer
from gcrules.views.pages.catalog_pages import FIGURES, HEAD, bibliography, catalog_pages, neighbours
from gcrules.views.pages.markdown import inline, reference
from gcrules.views.pages.page_names import page_names
from gcrules.views.report import telling_poses as poses

ENTRIES = load().entries
REGULAR = [e for e in ENTRIES if e.status != "always-singular"]

LINK = re.compile(r"\]\(([^\s()]+\.\w+)\)")

Pages = dict[str, str]


@pytest.fixture(scope="module")
def pages() -> Pages:
    """What the shipped catalog gives, computed once."""
    return catalog_pages(load(), bibliography())


@pytest.fixture
def known(pages: Pages, monkeypatch: pytest.MonkeyPatch) -> None:
    """The command takes the pages of shipped classes from the fixture and computes the others."""
    shipped = {e.id for e in ENTRIES}

    def quick(
        catalog: Catalog,
        sources: dict[str, str],
        catalogs: Sequence[str] = (),
        strategy: Strategy | None = None,
    ) -> Pages:
        own = Catalog(tuple(e for e in catalog.entries if e.id not in shipped), catalog.statements)
        return pages | (catalog_pages(own, sources, catalogs, strategy) if own.entries else {})

    monkeypatch.setattr(renderer, "catalog_pages", quick)


def run(*arguments: str) -> Result:
    result = CliRunner().invoke(cli, ["catalog", "docs", *arguments], prog_name="gcrules")
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


def contents(folder: Path) -> Pages:
    return {p.name: p.read_text(encoding="utf-8") for p in folder.iterdir()}


# --- the command ---------------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("known")
def test_the_committed_pages_are_up_to_date(root: Path) -> None:
    result = run("--check", "--out", str(root / "docs" / "catalog"))
    assert result.exit_code == 0, result.stdout


@pytest.mark.usefixtures("known")
def test_written_pages_are_what_is_checked(tmp_path: Path, pages: Pages) -> None:
    folder = tmp_path / "some" / "where"
    assert run("--out", str(folder)).exit_code == 0
    assert contents(folder) == pages
    assert run("--check", "--out", str(folder)).exit_code == 0
    again = run("--out", str(folder))
    assert "0 written, 0 removed" in again.stdout


@pytest.mark.usefixtures("known")
def test_stale_missing_and_left_over_pages(tmp_path: Path, pages: Pages) -> None:
    assert run("--out", str(tmp_path)).exit_code == 0
    (tmp_path / "6-6.md").write_text("edited", encoding="utf-8")
    (tmp_path / "6-5-graph.svg").unlink()
    (tmp_path / "7-7.md").write_text(HEAD, encoding="utf-8")
    (tmp_path / "7-7-robot.svg").write_text("", encoding="utf-8")
    (tmp_path / "6-2-singular.svg").write_text("", encoding="utf-8")
    (tmp_path / "notes.md").write_text("by hand", encoding="utf-8")
    before = contents(tmp_path)
    result = run("--check", "--out", str(tmp_path))
    assert result.exit_code == 1
    assert result.stdout.splitlines()[:-1] == [
        "6-6.md is stale",
        "6-5-graph.svg is missing",
        "6-2-singular.svg is no longer generated",
        "7-7.md is no longer generated",
        "7-7-robot.svg is no longer generated",
    ]
    assert contents(tmp_path) == before
    assert "2 written, 3 removed" in run("--out", str(tmp_path)).stdout
    assert contents(tmp_path) == pages | {"notes.md": "by hand"}


@pytest.mark.usefixtures("known")
def test_a_folder_that_is_not_there(tmp_path: Path, pages: Pages) -> None:
    result = run("--check", "--out", str(tmp_path / "none"))
    assert result.exit_code == 1
    assert result.stdout.count(" is missing\n") == len(pages)
    assert not (tmp_path / "none").exists()


@pytest.mark.usefixtures("known")
def test_a_file_in_place_of_the_folder(tmp_path: Path) -> None:
    path = tmp_path / "file"
    path.write_text("x", encoding="utf-8")
    result = run("--out", str(path))
    assert (result.exit_code, "cannot be written" in result.stderr) == (2, True)


@pytest.mark.usefixtures("known")
def test_a_catalog_of_the_users_own_adds_a_page(tmp_path: Path, pages: Pages) -> None:
    entry = load()["3-3.3"].to_json()
    own = {key: entry[key] for key in ("degrees", "terms", "factors", "group", "status", "sources")}
    own |= {"id": "mine", "name": "my robot", "legs": " ".join(map("".join, entry["legs"]))}
    own["condition"] = {key: entry["condition"][key] for key in ("kind", "expression", "coefficient")}
    path = tmp_path / "own.yaml"
    path.write_text(json.dumps({"classes": [own]}), encoding="utf-8")
    assert run("--out", str(tmp_path / "pages"), "--catalog", str(path)).exit_code == 0
    found = contents(tmp_path / "pages")
    assert found.keys() == pages.keys() | {"mine.md", *(f"mine-{kind}.svg" for kind in FIGURES)}
    assert found["mine.md"].startswith(f"{HEAD}\n# Class mine: my robot\n")
    assert "[mine](mine.md)" in found["README.md"]


@pytest.mark.usefixtures("known")
def test_summary_for_programs(tmp_path: Path, pages: Pages) -> None:
    first = json.loads(run("--json", "--out", str(tmp_path)).stdout)
    assert first == {"folder": str(tmp_path), "files": [*pages], "written": [*pages], "removed": [], "stale": []}
    (tmp_path / "6-6.md").unlink()
    (tmp_path / "7-7.md").write_text(HEAD, encoding="utf-8")
    checked = run("--json", "--check", "--out", str(tmp_path))
    stale = [{"file": "6-6.md", "state": "missing"}, {"file": "7-7.md", "state": "no longer generated"}]
    assert (checked.exit_code, json.loads(checked.stdout)) == (1, first | {"written": [], "stale": stale})
    again = json.loads(run("--json", "--out", str(tmp_path)).stdout)
    assert again == first | {"written": ["6-6.md"], "removed": ["7-7.md"]}


OWN = """
classes:
  - id: '../x'
    name: '<b> [x](javascript:y) | `z` $w$ {: .c }'
    note: "# no heading"
    legs: ab bc ca Dd Ee Ff
    sources: ['https://example.org/a_b', '<img src=x>', SinguLab2008]
    condition:
      kind: one-incidence
      coefficient: -1
      expression: '((Dd /\\ abc) \\/ (Ee /\\ abc)) /\\ Ff'
      statement: '<i>{Dd}</i>, {Ee} and {Ff} pierce the plane {abc} in points of one line.'
  - id: Mine
    legs: S1A1 S1B1 S2A2 S2B2 S3A3 S3B3
    condition: {kind: four-planes, coefficient: -1, expression: 'S1A1B1 /\\ S2A2B2 /\\ S3A3B3 /\\ S1S2S3'}
  - id: mine
    legs: Aa Ba Ca Db Eb Fb
    condition: {kind: always-singular, expression: '0'}
  - id: edges
    legs: ab ac ad bc bd cd
    condition: {kind: three-tetrahedra, expression: '[abcd][abcd][abcd]', coefficient: 1}
  - id: README
    legs: Aa Bb Cc Dd Ee Ff
    condition: {kind: linear-complex, expression: '[[Aa, Bb, Cc, Dd, Ee, Ff]]'}
  - id: unnamed lines
    legs: Aa Ab Bc Cd De Ef
    condition:
      kind: transversals
      cofactor: '(A \\/ Bc) /\\ (A \\/ Cd) /\\ ab'
      coefficient: -1
      expression: >-
        ((A \\/ Bc) /\\ (A \\/ Cd) /\\ De) * (((Bc /\\ Aab) \\/ (Cd /\\ Aab)) /\\ Ef)
        - ((A \\/ Bc) /\\ (A \\/ Cd) /\\ Ef) * (((Bc /\\ Aab) \\/ (Cd /\\ Aab)) /\\ De)
      statement: Something.
"""


@pytest.mark.usefixtures("known")
def test_odd_catalogs(tmp_path: Path, pages: Pages) -> None:
    path = tmp_path / "own.yaml"
    path.write_text(OWN, encoding="utf-8")
    folder = tmp_path / "pages"
    result = run("--out", str(folder), "--catalog", str(path))
    assert result.exit_code == 0, result.stderr
    assert sorted(p.name for p in tmp_path.iterdir()) == ["own.yaml", "pages"]
    found = contents(folder)
    own = {name.removesuffix(".md") for name in found if name.endswith(".md")} - {n.removesuffix(".md") for n in pages}
    assert own == {"x", "Mine", "mine-2", "edges", "README-2", "unnamed-lines"}
    text = "".join(found[f"{name}.md"] for name in own)
    assert not re.search(r"<(?!!-- Generated|https://example)|\]\(javascript|\{:|^# no", text, re.MULTILINE)
    assert "&#60;i&#62;Dd&#60;/i&#62;, Ee and Ff pierce" in found["x.md"]
    assert "the line Ff and" in found["x.md"] or "the lines r and Ff meet in the point M" in found["x.md"]
    assert "* <https://example.org/a_b>\n* &#60;img src=x&#62;\n* Ben-Horin" in found["x.md"]
    assert "planes A1B1S1, A2B2S2, S1S2S3 and A3B3S3 meet in the point M = (" in found["Mine.md"]
    assert "No singular pose with small numbers was found." in found["edges.md"]
    assert found["edges-robot.svg"].count("</text>") == 5  # a to d, and one tetrahedron in the legend
    for name in own:
        assert not [t for t in LINK.findall(found[f"{name}.md"]) if t not in found]
        for kind in FIGURES:
            if f"{name}-{kind}.svg" in found:
                ET.fromstring(found[f"{name}-{kind}.svg"])
    assert run("--check", "--out", str(folder), "--catalog", str(path)).exit_code == 0


def own_catalog(legs: str, expression: str, more: str = "") -> str:
    """A catalog of one class whose condition has no sentence of its own."""
    return (
        f"classes:\n  - id: mine\n    legs: {legs}\n"
        f"    condition: {{kind: three-tetrahedra, expression: '{expression}'{more}}}\n"
    )


def own_pages(path: Path) -> Pages:
    """The pages of a catalog's own classes."""
    catalog = load([path])
    own = Catalog(tuple(e for e in catalog.entries if e.owner == str(path)), catalog.statements)
    return catalog_pages(own, bibliography(), [path])


NO_TWO_BODIES = {
    "nowhere": ("ab bc ca ad be cf", "[abcd][abce][abcf]", ", coefficient: -1", "a 3, b 3, c 3, d 1, e 1, f 1", "6"),
    "in a part": ("ab bc ca de ef fg", "[abce][abcf][defg]", ", coefficient: -1", "a 2, b 2, c 2, d 1, e 2, f 2", "7"),
}


@pytest.mark.parametrize(("legs", "expression", "more", "degrees", "joints"), NO_TWO_BODIES.values(), ids=NO_TWO_BODIES)
def test_classes_without_two_bodies(
    legs: str, expression: str, more: str, degrees: str, joints: str, tmp_path: Path
) -> None:
    path = tmp_path / "own.yaml"
    path.write_text(own_catalog(legs, expression, more), encoding="utf-8")
    found = own_pages(path)
    assert f"* Legs at the joints {degrees}" in found["mine.md"]
    assert "close a ring of odd length" in found["mine.md"]
    assert f"| {joints} joints | [mine](mine.md) |" in found["README.md"]
    shown = CliRunner().invoke(cli, ["catalog", "show", "mine", "--catalog", str(path)]).stdout
    assert f"degrees    joints {degrees}" in shown


SENTENCES = {
    "the same in another order": ("[cbad][bace][abcf]", ", coefficient: -1", 0),
    "with a meet": ("[abcd][abce](ab /\\ cf)", ", coefficient: -1", 1),
    "a sum": ("[abcd][abce][abcf] + [abcd][abce][abfc] + [abcd][abce][abcf]", ", coefficient: -1", 1),
}


@pytest.mark.parametrize(("expression", "more", "added"), SENTENCES.values(), ids=SENTENCES)
def test_every_reading_has_a_sentence(expression: str, more: str, added: int, tmp_path: Path) -> None:
    path = tmp_path / "own.yaml"
    path.write_text(own_catalog("ab bc ca ad be cf", expression.replace("\\\\", "\\"), more), encoding="utf-8")
    readings = own_pages(path)["mine.md"].partition("## Other readings\n")[2].partition("\n## ")[0]
    parts = re.split(r"^Certificate: .*$", readings.strip(), flags=re.MULTILINE)[:-1]
    assert len(parts) == 1 + added
    assert all(part.strip().startswith("The robot is singular exactly when") for part in parts)


def test_false_entries_are_refused_before_pages_are_computed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object, **__: object) -> Pages:
        raise AssertionError("no page may be computed")

    monkeypatch.setattr(renderer, "catalog_pages", never)
    path = tmp_path / "my own.yaml"
    path.write_text(own_catalog("ab bc ca ad be cf", "[abcd][abce][abcf]"), encoding="utf-8")
    result = run("--out", str(tmp_path / "pages"), "--catalog", str(path))
    assert result.exit_code == 2
    assert "refuted: 1 * superbracket = 1 * [abcd][abce][abcf] fails at" in result.stderr
    assert f"`gcrules catalog check --catalog '{path}'`" in result.stderr
    assert not (tmp_path / "pages").exists()


@pytest.mark.usefixtures("known")
def test_the_command_that_renews_has_the_options(tmp_path: Path) -> None:
    path = tmp_path / "own.yaml"
    path.write_text(own_catalog("ab bc ca ad be cf", "[abcd][abce][abcf]", ", coefficient: -1"), encoding="utf-8")
    folder = tmp_path / "pages"
    said = run("--check", "--out", str(folder), "--catalog", str(path)).stdout
    assert f"`gcrules catalog docs --catalog {path} --out {folder}`" in said


def test_progress(tmp_path: Path) -> None:
    path = tmp_path / "own.yaml"
    path.write_text(own_catalog("ab bc ca ad be cf", "[abcd][abce][abcf]", ", coefficient: -1"), encoding="utf-8")
    catalog = load([path])
    own = Catalog(tuple(e for e in catalog.entries if e.id in ("mine", "4-4.s")), catalog.statements)
    told: list[str] = []
    with within(progress=told.append):
        catalog_pages(own, bibliography(), [path])
    assert told == ["4-4.s, 1 of 2", "mine, 2 of 2"]


@pytest.mark.parametrize(
    ("ids", "names"),
    [
        (["6-6", "4-4.s", "a_b"], ["6-6", "4-4.s", "a_b"]),
        (["../x", "..", "/etc/passwd", "a\\b", "a b"], ["x", "class", "etc-passwd", "a-b", "a-b-2"]),
        (["X", "x", "x-2"], ["X", "x-3", "x-2"]),
        (["readme", "Index", "con", "nul.x"], ["readme-2", "Index-2", "con-2", "nul-x-2"]),
        (["Würfel", "日本", "a" * 300, ".hidden", "-o", "x."], ["Wurfel", "class", "a" * 60, "hidden", "o", "x"]),
        (["x y", "x-y"], ["x-y-2", "x-y"]),
    ],
    ids=["good", "paths", "case", "reserved", "letters", "good names stay"],
)
def test_names_of_pages(ids: list[str], names: list[str]) -> None:
    assert page_names(ids) == dict(zip(ids, names, strict=True))


@pytest.mark.parametrize(
    ("text", "markdown"),
    [
        ("plain (text), S1 – 'A'", "plain (text), S1 – 'A'"),
        ("a\nb  c", "a b c"),
        ("", ""),
        ("*a* _b_ `c` ~d~", "&#42;a&#42; &#95;b&#95; &#96;c&#96; &#126;d&#126;"),
        ("# a", "&#35; a"),
        ("1. a", "&#49;. a"),
        ("!!! note", "&#33;!! note"),
        ("&lt;", "&#38;lt;"),
    ],
)
def test_text_as_markdown(text: str, markdown: str) -> None:
    assert inline(text) == markdown


def test_addresses_as_markdown() -> None:
    assert reference("https://example.org/a_b") == "<https://example.org/a_b>"
    assert reference("https://example.org/<b>") == "https://example.org/&#60;b&#62;"
    assert reference("javascript:alert(1)") == "javascript:alert(1)"


def test_pages_are_the_same_in_every_process(root: Path) -> None:
    """Whatever the seed of Python's hashes, which is another one here, and without a UTF-8 locale."""
    command = [sys.executable, "-m", "gcrules", "catalog", "docs", "--check"]
    environment = {**os.environ, "LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONHASHSEED": "1"}
    child = subprocess.run(command, cwd=root, env=environment, capture_output=True, text=True, check=False)
    assert child.returncode == 0, child.stdout + child.stderr


def test_pages_do_not_depend_on_the_last_bit(pages: Pages, monkeypatch: pytest.MonkeyPatch) -> None:
    """Sines, roots and sums may differ in their last bit between machines and versions of Python; pages may not."""
    rng = random.Random(1)

    def shaken(function: Callable[..., float]) -> Callable[..., float]:
        return lambda *given: function(*given) * (1 + rng.choice((-2.3e-16, 0, 2.3e-16)))

    names = ("cos", "sin", "atan2", "hypot", "dist", "sqrt", "dot")
    for module in (bsp, graph, labels, legend, poses, sample, scene, solids, view):
        for name in set(names) & vars(module).keys():
            monkeypatch.setattr(module, name, shaken(getattr(module, name)))
    some = ("6-5", "6-2", "5-5.1", "4-4.2", "4-3.3", "3-3.3")
    shipped = load()
    found = catalog_pages(
        Catalog(tuple(e for e in shipped.entries if e.id in some), shipped.statements), bibliography()
    )
    assert [n for n, svg in found.items() if n.endswith(".svg") and svg != pages[n]] == []


# --- the pages -----------------------------------------------------------------------------------------------------


def test_every_class_has_a_page_and_figures(pages: Pages) -> None:
    files = {f"{e.id}{end}" for e in ENTRIES for end in (".md", "-graph.svg", "-robot.svg", "-small.svg")}
    singular = {f"{e.id}-singular.svg" for e in REGULAR}
    assert pages.keys() == {"README.md", *files, *singular}


def test_links_lead_to_pages(pages: Pages) -> None:
    links = [(name, target) for name, text in pages.items() for target in LINK.findall(text)]
    assert len(links) > 4 * len(ENTRIES)
    assert not [link for link in links if link[1] not in pages]
    assert {target for name, target in links if name == "README.md"} >= {f"{e.id}.md" for e in ENTRIES}
    assert all("README.md" in LINK.findall(pages[f"{e.id}.md"]) for e in ENTRIES)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.id)
def test_page(pages: Pages, entry: Entry) -> None:
    page = pages[f"{entry.id}.md"]
    assert page.startswith(HEAD)
    a = analyze(entry.structure)
    assert f"**{inline(a.condition.statement)}**" in page
    assert not re.search(r"\{\w+\}", page)
    headings = ["Superbracket", "Shortest form", "Derivation", "Condition", "Sources"]
    assert [h for h in re.findall(r"^## (.*)", page, re.MULTILINE) if h in headings] == headings
    assert [int(n) for n in re.findall(r"^\*\*(\d+)\. ", page, re.MULTILINE)] == [
        *range(1, 1 + len(tuple(a.derivation)))
    ]
    sources = page.partition("## Sources\n")[2]
    assert not [key for key in entry.sources if f"* {key}" in sources]  # spelt out, not named by their keys
    assert sources.count("\n* ") == len(entry.sources)
    shown = {target for target in LINK.findall(page) if target.endswith(".svg")}
    kinds = set(FIGURES) - {"small"} - ({"singular"} if entry not in REGULAR else set())
    assert shown == {f"{entry.id}-{kind}.svg" for kind in kinds}
    for target in shown:
        ET.fromstring(pages[target])


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.id)
def test_formulas_are_whole_and_fit_the_page(pages: Pages, entry: Entry) -> None:
    blocks = re.findall(r"^```text\n(.*?)^```$", pages[f"{entry.id}.md"], re.MULTILINE | re.DOTALL)
    assert max(len(line) for block in blocks for line in block.splitlines()) <= 92
    a = analyze(entry.structure)
    shown = [" ".join(block.split()) for block in blocks]
    for e in (a.shortest.polynomial.to_expr(), *(step.after for step in a.derivation)):
        assert formula(e, unicode=True, names=a.structure.names) in shown or len(tuple(a.derivation)) == 1


def test_an_identity_of_the_catalog_is_proved_on_its_page(pages: Pages) -> None:
    page = pages["6-5.md"]
    assert "instance of an identity" not in "".join(pages.values())
    assert "**1. transversals**: this identity is proved from scratch: both sides have the same normal form" in page
    derivation = page.partition("## Derivation")[2].partition("## Condition")[0]
    assert "```text\n(ABc ∧ ACd ∧ ab)[[Aa, Ab, Bc, Cd, De, Ef]]\n=\n" in derivation


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.id)
def test_the_shortest_form_of_any_kind(pages: Pages, entry: Entry) -> None:
    """The catalog's number stands in the index, and the page says that no bracket polynomial is shorter."""
    assert entry.shortest == min(entry.terms.values())
    told = "No bracket polynomial with fewer terms equals the superbracket (proved by `gcrules shorten`)."
    assert (told in pages[f"{entry.id}.md"]) == (entry in REGULAR)
    (row,) = [line for line in pages["README.md"].splitlines() if f"[{entry.id}]({entry.id}.md) | [!" in line]
    assert f"| {entry.terms[24]} / {entry.terms[16]} / {entry.shortest} |" in row


def test_the_shortest_form_of_a_class_that_does_not_say() -> None:
    entry = next(e for e in ENTRIES if e.id == "4-4.5")
    own = catalog_pages(Catalog((replace(entry, shortest=None),), load().statements), bibliography())
    assert "No bracket polynomial with fewer terms" in own["4-4.5.md"]
    assert "| 3 / 3 / – |" in own["README.md"]


def test_bibliography() -> None:
    lines = bibliography()
    assert lines["McMillanWhite1991"].startswith("McMillan, Timothy and White, Neil L. 1991. *(")
    assert lines["White1991"].startswith("White, Neil L. Multilinear Cayley factorization. Journal of Symbolic")
    assert lines["Downing2002"].startswith("Downing, David M. et al. 2002. *(")


def worked(page: str) -> dict[str, tuple[dict[str, tuple[Fraction, ...]], Fraction]]:
    """The table of worked poses: coordinates of the joints and the superbracket's value."""
    rows = [
        [cell.strip() for cell in line.strip("|").split("|")]
        for line in page.partition("## Worked poses")[2].partition("\n## ")[0].splitlines()
        if line.startswith("|") and not line.startswith("|---")
    ]
    names = rows[0][1:-1]
    return {
        kind: (
            {n: (*map(Fraction, c.strip("()").split(",")), Fraction(1)) for n, c in zip(names, cells, strict=True)},
            Fraction(value),
        )
        for kind, *cells, value in rows[1:]
    }


@pytest.mark.parametrize("entry", REGULAR, ids=lambda e: e.id)
def test_worked_poses_are_what_they_say(pages: Pages, entry: Entry) -> None:
    a = analyze(entry.structure)
    found = worked(pages[f"{entry.id}.md"])
    assert found.keys() == {"regular", "singular"}
    for kind, (pose, value) in found.items():
        assert pose.keys() == set(a.structure.names)
        assert len(set(pose.values())) == len(pose)
        assert evaluate(a.structure.superbracket, pose) == value
        assert (value == 0) == (kind == "singular")
        assert (evaluate(a.condition.expression, pose) == 0) == (kind == "singular")
        assert evaluate(a.condition.cofactor, pose) != 0


@pytest.mark.parametrize("entry", [e for e in ENTRIES if e not in REGULAR], ids=lambda e: e.id)
def test_what_is_always_singular_has_no_worked_poses(pages: Pages, entry: Entry) -> None:
    assert "Worked poses" not in pages[f"{entry.id}.md"]


def figures(pages: Pages, entry: Entry) -> dict[str, Drawing]:
    """The drawings of a class as the pages hold them."""
    a = analyze(entry.structure)
    poses = worked(pages[f"{entry.id}.md"]) if entry in REGULAR else {}
    at = {kind: {n: c[:3] for n, c in pose.items()} for kind, (pose, _) in poses.items()}
    found = {"graph": graph_figure(a), "robot": robot_figure(a, at.get("regular"))}
    found |= {"singular": robot_figure(a, at["singular"])} if "singular" in at else {}
    return found | {"small": thumbnail(a, at.get("regular"))}


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.id)
def test_drawings(pages: Pages, entry: Entry) -> None:
    """Labels keep clear of each other and stay inside; every entity of the condition and the legend is to be seen."""
    a = analyze(entry.structure)
    for kind, drawing in figures(pages, entry).items():
        assert pages[f"{entry.id}-{kind}.svg"] == drawing.svg()
        texts = [s for s in drawing.shapes if isinstance(s, Text)]
        boxes = [label_box(t) for t in texts]
        assert not [1 for p, q in combinations(boxes, 2) if overlap(p, q) > 0], kind
        assert all(min(x, y) >= 0 and u <= drawing.width and v <= drawing.height for x, y, u, v in boxes), kind
        words = [("".join(run.text for run in t.runs), t.fill) for t in texts]
        if kind == "small":
            assert not texts
            assert drawing.width <= 260
            assert drawing.height <= 100
            continue
        legend = [word for word, _ in words if " " in word and not word.endswith(" joint")]
        expected = [f"{e.kind} {''.join(e.points)}" for e in shown_entities(a.condition)]
        assert {w.removesuffix(", flat") for w in legend} >= set(expected) - {f"line {x}" for x in named(a)}, kind
        if kind != "graph":
            assert {n for n, _ in named_lines(a)} <= {w.rpartition(" ")[2] for w in legend}, kind
            points = [w.rpartition(" ")[2] for w in legend if "point" in w or "axis" in w]
            assert points == [word for word, fill in words if fill == "mark" and " " not in word]
        assert len(legend) <= len(painted_outside_legend(drawing)), kind


def named(a: Analysis) -> set[str]:
    """The lines of joints that have a name of their own."""
    return {str(e) for _, e in a.condition.lines}


def painted_outside_legend(drawing: Drawing) -> set[str]:
    """The roles of entities and marks in the picture itself, left of the legend."""
    edge = min(
        (t.at[0] for t in drawing.shapes if isinstance(t, Text) and t.anchor == "start" and t.at[0] > 100), default=1e9
    )
    roles: set[str | None] = set()
    for s in drawing.shapes:
        match s:
            case Polygon() if s.points[0][0] < edge - 30:
                roles.add(s.fill)
            case Line() if s.start[0] < edge - 30:
                roles.add(s.stroke)
            case Circle() if s.center[0] < edge - 30:
                roles |= {s.fill, s.stroke}
    return {r for r in roles if r and (r.startswith("entity") or r == "mark")}


@pytest.mark.parametrize("entry", REGULAR, ids=lambda e: e.id)
def test_the_singular_pose_shows_why(pages: Pages, entry: Entry) -> None:
    """The sentence below the figure is true in the pose of the table."""
    page = pages[f"{entry.id}.md"]
    a = analyze(entry.structure)
    pose, _ = worked(page)["singular"]
    sentence = next(line for line in page.splitlines() if line.startswith("In the singular pose"))
    meeting = re.search(r"meet in the point M = \((.*)\)\.", sentence)
    flat = re.search(r"tetrahedron (\w+) is flat", sentence)
    if meeting:
        at = (*map(Fraction, meeting[1].split(",")), Fraction(1))
        for e in a.condition.entities:
            if e.kind in ("plane", "line"):
                joined = join(Point("M'"), *map(Point, e.points))
                value = evaluate(joined, pose | {"M'": at})
                assert not any(value if isinstance(value, tuple) else (value,))
    elif flat:
        assert evaluate(parse(f"[{flat[1]}]"), pose) == 0
    else:
        assert "screw motion about the axis s with pitch" in sentence
        assert len(free_motions(a.structure.legs, pose)) == 1


def test_filters_of_the_index(pages: Pages) -> None:
    index = pages["README.md"]
    anchors = [re.sub(r"[^\w -]", "", h).lower().replace(" ", "-") for h in re.findall("^## (.*)", index, re.MULTILINE)]
    assert re.findall(r"\]\(#([^)]*)\)", index) == anchors
    assert re.search(r"\[Four planes \(group c\)\]\(#four-planes-group-c\) \(6\)", index)


def test_neighbours_are_mutual() -> None:
    found = neighbours(load())
    links = {(entry, other): what for entry, pairs in found.items() for what, other in pairs}
    assert len(links) > len(ENTRIES)
    assert not [link for link in links if link[::-1] not in links]
    joints = {e.id: len(e.structure.names) for e in ENTRIES}
    for (entry, other), what in links.items():
        assert joints[entry] - joints[other] == (1 if what.startswith("merge") else -1)


# --- beside the catalog --------------------------------------------------------------------------------------------


def test_every_public_name_is_on_the_page_for_python(root: Path) -> None:
    page = (root / "docs" / "api.md").read_text(encoding="utf-8")
    shown = {path.rpartition(".")[2] for path in re.findall(r"^::: (\S+)$", page, re.MULTILINE)}
    shown |= {name for names in re.findall(r"members:\s*\[([^\]]*)\]", page) for name in re.split(r",\s*", names)}
    shown |= set(re.findall(r"`gc\.(\w+)`", page))
    assert set(gcrules.__all__) - {"factor", "Factorization"} <= shown
