"""The catalog's pages: complete, linked, true at their worked poses, and kept up to date by the command."""

from __future__ import annotations

import json
import re
import xml.etree.ElementTree as ET
from fractions import Fraction
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from gcrules.algebra.evaluate import evaluate
from gcrules.analysis import analyze
from gcrules.catalog import Catalog, Entry
from gcrules.catalog_file import load
from gcrules.cli import cli
from gcrules.render import catalog_pages as renderer
from gcrules.render.catalog_pages import HEAD, bibliography, catalog_pages, neighbours

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

    def quick(catalog: Catalog, sources: dict[str, str]) -> Pages:
        own = Catalog(tuple(e for e in catalog.entries if e.id not in shipped), catalog.statements)
        return pages | (catalog_pages(own, sources) if own.entries else {})

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
    (tmp_path / "notes.md").write_text("by hand", encoding="utf-8")
    before = contents(tmp_path)
    result = run("--check", "--out", str(tmp_path))
    assert result.exit_code == 1
    assert result.stdout.splitlines()[:-1] == [
        "6-6.md is stale",
        "6-5-graph.svg is missing",
        "7-7.md is no longer generated",
        "7-7-robot.svg is no longer generated",
    ]
    assert contents(tmp_path) == before
    assert "2 written, 2 removed" in run("--out", str(tmp_path)).stdout
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
    assert (result.exit_code, "cannot be made" in result.stderr) == (2, True)


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
    assert found.keys() == pages.keys() | {"mine.md", "mine-graph.svg", "mine-robot.svg"}
    assert found["mine.md"].startswith(f"{HEAD}\n# Class mine: my robot\n")
    assert "[mine](mine.md)" in found["README.md"]


# --- the pages -----------------------------------------------------------------------------------------------------


def test_every_class_has_a_page_and_figures(pages: Pages) -> None:
    files = {f"{e.id}{end}" for e in ENTRIES for end in (".md", "-graph.svg", "-robot.svg")}
    assert pages.keys() == {"README.md", *files}


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
    assert f"**{analyze(entry.structure).condition.statement}**" in page
    assert not re.search(r"\{\w+\}", page)
    sources = page.partition("## Sources\n")[2]
    assert not [key for key in entry.sources if f"* {key}" in sources]  # spelt out, not named by their keys
    assert sources.count("\n* ") == len(entry.sources)
    for kind in ("graph", "robot"):
        ET.fromstring(pages[f"{entry.id}-{kind}.svg"])


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


def test_neighbours_are_mutual() -> None:
    found = neighbours(load())
    links = {(entry, other): what for entry, pairs in found.items() for what, other in pairs}
    assert len(links) > len(ENTRIES)
    assert not [link for link in links if link[::-1] not in links]
    joints = {e.id: len(e.structure.names) for e in ENTRIES}
    for (entry, other), what in links.items():
        assert joints[entry] - joints[other] == (1 if what.startswith("merge") else -1)
