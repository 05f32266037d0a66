"""The command that writes the catalog's pages: it keeps them up to date and takes catalogs of the user's own."""

from __future__ import annotations

import json
import os
import random
import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from commands import invoke

from gcrules.apps.cli import catalog_docs, cli
from gcrules.core.budget import within
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.file import load
from gcrules.rules.strategy import Strategy
from gcrules.views.drawing import bsp, graph, labels, legend, sample, scene, solids
from gcrules.views.drawing import viewpoint as view
from gcrules.views.pages.catalog_pages import FIGURES, HEAD, bibliography, catalog_pages
from gcrules.views.pages.markdown import inline, reference
from gcrules.views.pages.page_names import page_names
from gcrules.views.report import telling_poses as poses

ENTRIES = load().entries

SOME = ("6-5", "6-2", "5-5.1", "4-4.2", "4-3.3", "3-3.3")
"""Classes of several groups, for what need not be tried with all."""

LINK = re.compile(r"\]\(([^\s()]+\.\w+)\)")

Pages = dict[str, str]


@pytest.fixture
def known(pages: Pages, monkeypatch: pytest.MonkeyPatch) -> None:
    """The command takes the pages of shipped classes from the fixture and computes the others."""
    shipped = {e.id for e in ENTRIES}

    def quick(
        catalog: Catalog,
        sources: dict[str, str],
        catalogs: Sequence[str] = (),
        strategy: Strategy | None = None,
        plugins: Sequence[str] = (),
        only: Sequence[str] = (),
    ) -> Pages:
        if only:
            return catalog_pages(catalog, sources, catalogs, strategy, plugins, only)
        own = Catalog(tuple(e for e in catalog.entries if e.id not in shipped), catalog.statements)
        return pages | (catalog_pages(own, sources, catalogs, strategy, plugins) if own.entries else {})

    monkeypatch.setattr(catalog_docs, "catalog_pages", quick)


def run(*arguments: str) -> Result:
    return invoke("catalog", "docs", *arguments)


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
def test_only_the_pages_of_some_classes(tmp_path: Path, pages: Pages) -> None:
    assert run("--out", str(tmp_path)).exit_code == 0
    for name in ("6-6.md", "6-5.md", "README.md"):
        (tmp_path / name).write_text("edited", encoding="utf-8")
    (tmp_path / "7-7.md").write_text(HEAD, encoding="utf-8")
    (tmp_path / "6-2-singular.svg").write_text("", encoding="utf-8")
    only = ("--only", "6-5", "--only", "6-2", "--out", str(tmp_path))
    stale = run("--check", *only)
    assert stale.exit_code == 1
    assert stale.stdout.splitlines()[:-1] == ["6-5.md is stale", "6-2-singular.svg is no longer generated"]
    assert f"`gcrules catalog docs --only 6-5 --only 6-2 --out {tmp_path}`" in stale.stdout
    assert "1 written, 1 removed" in run(*only).stdout
    assert contents(tmp_path) == pages | {"6-6.md": "edited", "README.md": "edited", "7-7.md": HEAD}


def test_only_a_class_that_is_not_there(tmp_path: Path) -> None:
    result = run("--only", "6-5", "--only", "6-55", "--out", str(tmp_path / "pages"))
    assert result.exit_code == 2
    assert "'6-55'" in result.stderr
    assert "6-5?" in result.stderr
    assert not (tmp_path / "pages").exists()


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

    monkeypatch.setattr(catalog_docs, "catalog_pages", never)
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
    only = [word for name in SOME for word in ("--only", name)]
    command = [sys.executable, "-m", "gcrules", "catalog", "docs", "--check", *only]
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
    shipped = load()
    found = catalog_pages(
        Catalog(tuple(e for e in shipped.entries if e.id in SOME), shipped.statements), bibliography()
    )
    assert [n for n, svg in found.items() if n.endswith(".svg") and svg != pages[n]] == []
