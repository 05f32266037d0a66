"""The guide: it builds strictly and works from a folder, without a network; its drawings and generated parts."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from xml.etree import ElementTree

import pytest
import yaml
from places import ROOT

PAGES = sorted(p for p in (ROOT / "docs").rglob("*.md") if "assets" not in p.parts)


def tool(name: str) -> ModuleType:
    """A module of tools/."""
    import importlib

    sys.path.insert(0, str(ROOT / "tools"))
    try:
        return importlib.import_module(name)
    finally:
        sys.path.remove(str(ROOT / "tools"))


def build(folder: Path, site: Path) -> subprocess.CompletedProcess[str]:
    """Build the guide of a folder with the options that the Makefile gives."""
    options = re.search(r"-m mkdocs (build .*) --site-dir", (ROOT / "Makefile").read_text(encoding="utf-8"))
    assert options is not None
    return subprocess.run(
        [sys.executable, "-m", "mkdocs", *options[1].split(), "--site-dir", str(site)],
        cwd=folder,
        env={**os.environ, "NO_MKDOCS_2_WARNING": "1"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("site")
    done = build(ROOT, folder)
    assert done.returncode == 0, done.stderr
    assert not [line for line in done.stderr.splitlines() if not line.startswith("INFO ")]
    return folder


def test_warnings_are_shown_and_fail(tmp_path: Path) -> None:
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "index.md").write_text("# A page\n\n[broken](nowhere.md)\n", encoding="utf-8")
    (tmp_path / "mkdocs.yml").write_text("site_name: a\nplugins: []\n", encoding="utf-8")
    done = build(tmp_path, tmp_path / "site")
    assert done.returncode != 0
    assert "nowhere.md" in done.stderr


# --- the whole site -------------------------------------------------------------------------------------------------


def test_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    assert list(tool("check_site").faults(site)) == []


def test_every_page_is_there(site: Path) -> None:
    for page in PAGES:
        name = page.relative_to(ROOT / "docs").with_suffix(".html")
        built = site / (name.with_name("index.html") if page.stem == "README" else name)
        assert built.is_file(), page


def test_no_place_of_this_machine(site: Path) -> None:
    for path in site.rglob("*.html"):
        assert str(ROOT) not in path.read_text(encoding="utf-8"), path


def test_no_marker_is_left(site: Path) -> None:
    for path in site.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        assert "@@gcrules" not in text, path
        assert not re.search(r"<!-- (drawing|generated):", text), path


@pytest.mark.browser
def test_formulas_and_search_in_a_browser(site: Path, run_browser: Callable[..., str], tmp_path: Path) -> None:
    log = tmp_path / "net.json"
    address = (site / "course" / "superbracket.html").as_uri() + "?q=straightening"
    page = run_browser(address, "--dump-dom", f"--log-net-log={log}", "--disable-background-networking")
    assert page.count('class="katex-display"') == 1
    assert "\\begin{pmatrix}" not in re.sub(r"<annotation.*?</annotation>", "", page, flags=re.DOTALL)
    assert page.count("md-search-result__item") > 3
    hosts = set(re.findall(r'"url":"(?:https?|wss?)://([^"/:]+)', log.read_text(encoding="utf-8")))
    # The browser itself asks its maker for news whatever the page is.
    own = re.compile(r"(?!fonts\.|ajax\.)[\w-]+\.(?:google|googleapis|gvt1|gstatic)\.com")
    assert {host for host in hosts if not own.fullmatch(host)} == set()


# --- the check itself ------------------------------------------------------------------------------------------------

LEAVING = {
    "script": ("a.html", '<script src="https://cdn.example/x.js"></script>'),
    "style sheet": ("a.html", '<link rel="stylesheet" href="//cdn.example/x.css">'),
    "preconnect": ("a.html", '<link href="https://fonts.example" rel="preconnect">'),
    "image": ("a.html", '<img src="http://example/x.png">'),
    "set of images": ("a.html", '<img srcset="here.png 1x, https://example/x.png 2x">'),
    "style": ("a.html", '<p style="background: url(https://example/x.png)">'),
    "style element": ("a.html", "<style>@import 'https://example/x.css';</style>"),
    "script element": ("a.html", '<script>fetch("https://example/x.json")</script>'),
    "svg": ("a.svg", '<svg><image href="https://example/x.png"/></svg>'),
    "font": ("a.css", "@font-face { src: url(https://example/x.woff2) }"),
    "worker": ("a.js", "new Worker(`//example/x.js`)"),
}


@pytest.mark.parametrize(("name", "text"), LEAVING.values(), ids=LEAVING)
def test_loads_that_leave_the_site(name: str, text: str, tmp_path: Path) -> None:
    (tmp_path / "here.png").touch()
    (tmp_path / name).write_text(text, encoding="utf-8")
    (fault,) = tool("check_site").faults(tmp_path)
    assert fault.startswith(f"{name}:1: leaves the site: ")


def test_loads_that_fail(tmp_path: Path) -> None:
    text = '<img src="gone.png">\n<img src="/root.png">\n<a href="https://example.org">free</a>\n<img src="data:,x">'
    (tmp_path / "a.html").write_text(text, encoding="utf-8")
    assert list(tool("check_site").faults(tmp_path)) == [
        "a.html:1: no such file: gone.png",
        "a.html:2: does not work from a folder: /root.png",
    ]


# --- drawings --------------------------------------------------------------------------------------------------------

DRAWINGS = tool("site_drawings").DRAWINGS
ASKED = [
    (page.relative_to(ROOT).as_posix(), name)
    for page in PAGES
    for name in re.findall(r"^<!-- drawing: ([\w-]+)", page.read_text(encoding="utf-8"), re.MULTILINE)
]


def test_drawings_that_are_asked_for_are_those_that_are_made() -> None:
    assert {name for _, name in ASKED} == set(DRAWINGS)


@pytest.mark.parametrize("name", DRAWINGS)
def test_drawing(name: str) -> None:
    drawing = DRAWINGS[name]()
    text = drawing.svg()
    assert text == DRAWINGS[name]().svg()
    picture = ElementTree.fromstring(text)
    assert picture.findtext("{http://www.w3.org/2000/svg}title")
    numbers = [float(n) for n in re.findall(r' (?:x|y|cx|cy|[xy][12])="(-?[\d.]+)"', text)]
    assert numbers
    assert all(-1 <= n <= max(drawing.width, drawing.height) + 1 for n in numbers)


def test_the_tableaux_are_those_of_the_engine() -> None:
    text = "".join(ElementTree.fromstring(DRAWINGS["tableaux"]().svg()).itertext())
    assert text.count("p") >= 36


def test_the_crossing_legs_are_singular() -> None:
    import gcrules as gc

    at = {name: (*p, 1) for name, p in tool("site_drawings").HUNT.items()}
    page = (ROOT / "docs" / "course" / "superbracket.md").read_text(encoding="utf-8")
    assert all(f'"{name}": {p}' in page for name, p in at.items())
    assert gc.evaluate("[[ab, af, cb, cd, ed, ef]]", at) == 0


# --- grammar and messages --------------------------------------------------------------------------------------------


def test_every_rule_of_the_grammar_is_shown() -> None:
    grammar = (ROOT / "gcrules" / "grammar.lark").read_text(encoding="utf-8")
    rules = {name.lstrip("_?!") for name in re.findall(r"^([?!_]*[a-z_]+)\s*:", grammar, re.MULTILINE)}
    terminals = {name.lstrip("_") for name in re.findall(r"^(_?[A-Z_]+)(?:\.\d+)?\s*:", grammar, re.MULTILINE)}
    shown = tool("site_grammar").rules_html() + tool("site_grammar").terminals_html()
    assert {name for name in rules if f'id="rule-{name.replace("_", "-")}"' not in shown} == set()
    assert {name for name in terminals if f'id="terminal-{name.lower().replace("_", "-")}"' not in shown} == set()
    linked = set(re.findall(r'href="#([\w-]+)"', shown))
    assert linked <= set(re.findall(r'id="([\w-]+)"', shown))
    for literal in re.findall(r'"([a-z]+)"', grammar):
        assert f">{literal}</text>" in shown


@pytest.mark.parametrize("part", ["expressions", "scripts"])
def test_every_fault_is_shown(part: str) -> None:
    cases = yaml.safe_load((ROOT / "tests" / "data" / "faults.yaml").read_text(encoding="utf-8"))[part]
    shown = tool("site_grammar").faults_html(part)
    assert len(cases) > 10
    assert shown.count("<tr>") == len(cases) + 1
    assert shown.count("error: ") == len(cases)


def test_search_index_holds_the_pages(site: Path) -> None:
    index = json.loads((site / "search" / "search_index.json").read_text(encoding="utf-8"))
    places = {doc["location"].partition("#")[0] for doc in index["docs"]}
    assert {"course/meet.html", "procedure/four-dof.html", "grammar.html", "catalog/3-3.3.html"} <= places
