"""The catalog's pages: complete, linked, and true at their worked poses."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import pytest

import gcrules
from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Point, join
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.language.text import text as formula
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import free_motions
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.catalog.file import load
from gcrules.views.drawing.drawing import Circle, Drawing, Polygon, Stroke, Text
from gcrules.views.drawing.figures import graph_figure, named_lines, robot_figure, shown_entities, thumbnail
from gcrules.views.drawing.labels import label_box, overlap
from gcrules.views.pages.catalog_pages import FIGURES, HEAD, bibliography, catalog_pages, neighbours
from gcrules.views.pages.markdown import inline

ENTRIES = load().entries
REGULAR = [e for e in ENTRIES if e.status != "always-singular"]

LINK = re.compile(r"\]\(([^\s()]+\.\w+)\)")

Pages = dict[str, str]


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
    a = analyze_legs(entry.structure)
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
    a = analyze_legs(entry.structure)
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
    assert lines["McMillanWhite1991"].startswith(
        "McMillan, Timothy and White, Neil L. The dotted straightening algorithm. Journal"
    )
    assert lines["White1991"].startswith("White, Neil L. Multilinear Cayley factorization. Journal of Symbolic")
    assert lines["Gallardo2006"].startswith("Gallardo-Alvarado, J. et al. Kinematics and singularity analysis")


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
    a = analyze_legs(entry.structure)
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
    a = analyze_legs(entry.structure)
    poses = worked(pages[f"{entry.id}.md"]) if entry in REGULAR else {}
    at = {kind: {n: c[:3] for n, c in pose.items()} for kind, (pose, _) in poses.items()}
    found = {"graph": graph_figure(a), "robot": robot_figure(a, at.get("regular"))}
    found |= {"singular": robot_figure(a, at["singular"])} if "singular" in at else {}
    return found | {"small": thumbnail(a, at.get("regular"))}


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.id)
def test_drawings(pages: Pages, entry: Entry) -> None:
    """Labels keep clear of each other and stay inside; every entity of the condition and the legend is to be seen."""
    a = analyze_legs(entry.structure)
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
            case Stroke() if s.start[0] < edge - 30:
                roles.add(s.stroke)
            case Circle() if s.center[0] < edge - 30:
                roles |= {s.fill, s.stroke}
    return {r for r in roles if r and (r.startswith("entity") or r == "mark")}


@pytest.mark.parametrize("entry", REGULAR, ids=lambda e: e.id)
def test_the_singular_pose_shows_why(pages: Pages, entry: Entry) -> None:
    """The sentence below the figure is true in the pose of the table."""
    page = pages[f"{entry.id}.md"]
    a = analyze_legs(entry.structure)
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
    shown = {path.rpartition(".")[2] for path in re.findall(r"^  <!-- ::: (\S+) -->$", page, re.MULTILINE)}
    shown |= set(re.findall(r"`gc\.(\w+)`", page))
    assert set(gcrules.__all__) - {"factor", "Factorization"} <= shown
