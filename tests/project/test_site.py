"""The guide: it builds strictly and works from a folder, without a network; its drawings and generated parts."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
import yaml
from browsing import chromium
from places import ROOT, tool

from gcrules.views.glossary import GLOSSARY, anchor, markdown

PAGES = sorted(p for p in (ROOT / "docs").rglob("*.md") if "assets" not in p.parts)


def build(site: Path, *repository: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, str(ROOT / "tools" / "build_site.py"), str(site), *map(str, repository)],
        capture_output=True,
        encoding="utf-8",
        check=False,
    )


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("guide") / "site"
    done = build(folder)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "No issues found" in done.stdout + done.stderr
    return folder


ASKING = {
    "a page": ("[broken](nowhere.md)", "page does not exist"),
    "a heading": ("[broken](#nowhere)", "anchor does not exist"),
    "a part": ("<!-- generated: nothing -->", "no such part in tools/site_grammar.py: nothing"),
    "a form": ("See <!-- generated: rules -->", "not a line of its own"),
}


def repository(folder: Path, text: str, nav: str = "[{Start: index.md}]") -> Path:
    (folder / "docs").mkdir()
    (folder / "docs" / "index.md").write_text(f"# A page\n\n{text}\n", encoding="utf-8")
    settings = f"site_name: a\nnav: {nav}\nplugins: []\nmarkdown_extensions: [md_in_html]\n"
    (folder / "mkdocs.yml").write_text(settings, encoding="utf-8")
    return folder


@pytest.mark.parametrize(("text", "fault"), ASKING.values(), ids=ASKING)
def test_what_is_asked_for_in_vain_is_shown_and_fails(text: str, fault: str, tmp_path: Path) -> None:
    done = build(tmp_path / "site", repository(tmp_path, text))
    assert done.returncode == 1
    assert fault in re.sub(r"\x1b\[[\d;]*m", "", done.stdout + done.stderr)


def test_a_page_is_in_the_navigation(tmp_path: Path) -> None:
    guide = tool("site_pages").Guide(repository(tmp_path, "Text."))
    guide.navigation([{"Start": "gone.md"}])
    assert guide.faults == ["mkdocs.yml: no such page: gone.md", "mkdocs.yml: not in the navigation: index.md"]


# --- the whole site -------------------------------------------------------------------------------------------------


def test_nothing_is_loaded_from_elsewhere(site: Path) -> None:
    assert list(tool("check_site").faults(site)) == []


def test_every_page_is_there(site: Path) -> None:
    for page in PAGES:
        name = page.relative_to(ROOT / "docs").with_suffix(".html")
        built = site / (name.with_name("index.html") if page.stem == "README" else name)
        assert built.is_file(), page


@pytest.mark.browser
def test_a_report_stands_in_a_page_by_the_line_that_the_studio_gives(site: Path) -> None:
    line = re.search("<iframe.*</iframe>", (ROOT / "docs" / "report.md").read_text(encoding="utf-8"))
    assert line
    given = (ROOT / "studio-ui" / "src" / "page" / "panels" / "take-away" / "embed.tsx").read_text(encoding="utf-8")
    assert re.sub('(src|title)="[^"]*"', r'\1="…"', line[0]) in re.sub(r'(src|title)="\$[^"]*"', r'\1="…"', given)
    with chromium() as browser:
        page = browser.new_page()
        page.goto((site / "report.html").as_uri())
        page.locator("article iframe").scroll_into_view_if_needed()
        page.frame_locator("article iframe").locator(".gcrules-viewer").first.wait_for()


def test_no_place_of_this_machine(site: Path) -> None:
    for path in site.rglob("*.html"):
        assert str(ROOT) not in path.read_text(encoding="utf-8"), path


def test_no_marker_is_left(site: Path) -> None:
    for path in site.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        assert "@@gcrules" not in text, path
        assert "<!-- generated:" not in text, path


@pytest.mark.browser
def test_formulas_and_search_from_a_folder(site: Path) -> None:
    with chromium() as browser:
        page = browser.new_page()
        asked: list[str] = []
        page.on("request", lambda request: asked.append(request.url))
        page.goto((site / "course" / "superbracket.html").as_uri())
        page.wait_for_function("() => document.querySelectorAll('.katex-display').length === 1")
        assert page.locator(".katex-error").count() == 0
        page.locator(".md-search__button").click()
        page.get_by_role("combobox", name="Search").or_(page.get_by_role("textbox", name="Search")).fill(
            "straightening"
        )
        page.get_by_role("option", name="Syzygies and straightening").click()
        page.wait_for_url("**/course/straightening.html*")
    assert [url for url in asked if not url.startswith(("file:", "blob:", "data:"))] == []


# --- terms of the glossary -------------------------------------------------------------------------------------------

TERM = re.compile(r'<a class="?gc-term"? href="([^"]*)" title="[^"]+">([^<]*)</a>')


def test_each_page_leads_to_the_glossary_once_for_a_term(site: Path) -> None:
    entries = set(re.findall(r'<a id="([\w-]+)">', (site / "glossary.html").read_text(encoding="utf-8")))
    assert len(entries) == len(GLOSSARY)
    count = 0
    reports = {*(site / "assets" / "reports").glob("*.html")}  # which explain their own terms
    for path in {*site.rglob("*.html")} - reports:
        text = path.read_text(encoding="utf-8")
        links = [m[1] for m in TERM.finditer(text)]
        assert len(links) == text.count("gc-term"), path
        assert len(links) == len(set(links)), path
        for place, _, entry in (link.partition("#") for link in links):
            assert (path.parent / place).resolve() == (site / "glossary.html").resolve(), path
            assert entry in entries
        outside = re.sub(r"<(h\d|code|pre|summary)\b.*?</\1>", "", text, flags=re.DOTALL)
        assert outside.count("gc-term") == len(links), path
        count += len(links)
    assert count > 500


def test_terms_that_are_linked() -> None:
    link = tool("site_glossary").link

    def terms(text: str) -> list[str]:
        return re.findall(r"\[([^\]]+)\]\(\.\./glossary\.md#", link(text, "course/page.md"))

    assert terms("Superbrackets and brackets, a bracket again.") == ["Superbrackets", "brackets"]
    assert terms("Two singular\nposes are no singular pose's.") == ["singular\nposes"]
    assert terms("An operation mode and its limb-like limbs; Σ is no σ.") == ["operation mode", "limbs", "σ"]
    assert terms("Planes meet in a point; the *meet* does, as **joins** do.") == ["meet", "joins"]
    assert terms("| bracket |\n|---|\n| bracket |") == ["bracket"]
    for other in (
        "# Brackets",
        "`a bracket` and ``b ` bracket``",
        "```\nbracket\n```",
        "* x\n\n  ```console\n  bracket\n  ```",
        "Text:\n\n    a bracket\n    a limb\n",
        "[the bracket](x.md) ![a bracket [ab]](x.svg) [bracket][x] <a id='x'>limb</a>",
        "[x]: bracket.md",
        "<details>\n<summary>The bracket</summary>",
        "<!-- drawing: x | a bracket\nwith limbs -->",
        r"$$ bracket $$ \(bracket\) \[bracket\] $bracket$",
        "::: gcrules.bracket\n    options:\n      bracket: limb",
    ):
        assert terms(other + "\n") == [], other
    assert link("A bracket.", "glossary.md") == "A bracket."


def test_the_glossary_has_a_place_for_each_term() -> None:
    assert set(re.findall(r'<a id="([\w-]+)">', markdown())) == {anchor(e["term"]) for e in GLOSSARY}


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
    for name in re.findall(
        r"^!\[.*\]\(\S*assets/drawings/([\w-]+)\.svg\)$", page.read_text(encoding="utf-8"), re.MULTILINE
    )
]


def test_drawings_that_are_shown_are_those_that_are_made() -> None:
    """That the files are up to date is part of `tools/check_docs.py`."""
    assert {name for _, name in ASKED} == set(DRAWINGS)
    assert {path.stem for path in (ROOT / "docs" / "assets" / "drawings").iterdir()} == set(DRAWINGS)


def test_an_image_with_its_caption_is_a_figure_in_the_colours_of_the_page(tmp_path: Path) -> None:
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "a.svg").write_text('<svg class="gc-figure" role="img"></svg>', encoding="utf-8")
    text = "![A [ab]](a.svg)\n\n![B](a.svg)\n\n*Two\nlines.*\n\n![C](b.png)\n\n*Not all* of it.\n"
    (tmp_path / "docs" / "index.md").write_text(text, encoding="utf-8")
    guide = tool("site_pages").Guide(tmp_path)
    alone, figure, *rest = guide.page("index.md").split("\n\n")
    assert re.fullmatch(r"@@gcrules:\w+@@", alone)
    assert figure.startswith('<figure class="gc-drawing" markdown>\n@@gcrules:')
    assert figure.endswith("\n<figcaption markdown>Two lines.</figcaption>\n</figure>")
    assert rest == ["![C](b.png)", "*Not all* of it.\n"]
    assert {re.search(r'aria-label="(.*?)"', part)[1] for part in guide.parts.values()} == {"A [ab]", "B"}


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


# --- Python -----------------------------------------------------------------------------------------------------------


def test_the_page_on_python_reads_as_a_list_and_says_what_docstrings_say() -> None:
    """`python tools/site_api.py` writes it."""
    api = tool("site_api")
    page = (ROOT / "docs" / api.PAGE).read_text(encoding="utf-8")
    assert page == api.listed(page)
    assert not re.search(r"^:::", page, re.MULTILINE)
    paths = re.findall(r"<!-- ::: (\S+) -->", page)
    built = tool("site_pages").Guide().page(api.PAGE)
    assert re.findall(r"^::: (\S+)$", built, re.MULTILINE) == paths
    assert "* `gc." not in built


# --- pictures of answers ---------------------------------------------------------------------------------------------

PICTURES = tool("answer_pictures").PICTURES


@pytest.mark.parametrize("name", PICTURES)
def test_the_command_of_a_picture_stands_on_its_page(name: str) -> None:
    (page,) = (text for text in (p.read_text(encoding="utf-8") for p in PAGES) if f"assets/{name})" in text)
    assert (ROOT / "docs" / "assets" / name).is_file()
    assert f"gcrules {PICTURES[name][0]}" in " ".join(page.split())


@pytest.mark.parametrize("name", [n for n in PICTURES if n not in tool("answer_pictures").LONG])
def test_the_picture_of_an_answer_is_what_is_drawn(name: str) -> None:
    """Those that take long are compared by `make docs`."""
    assert tool("answer_pictures").stale([name]) == []


def test_pictures_are_compared_up_to_rounding(tmp_path: Path) -> None:
    pictures = tool("answer_pictures")
    svg = '<svg><path id="p12" d="M 1.25 2.5" fill="#aa3344"/><use href="#p12"/><text>margin</text></svg>'
    changes = {
        "as it is": (svg, True),
        "rounded": (svg.replace("1.25", "1.2"), True),
        "other names": (svg.replace("p12", "q34"), True),
        "moved": (svg.replace("1.25", "3.25"), False),
        "other words": (svg.replace("margin", "value"), False),
        "another colour": (svg.replace("aa3344", "0072b2"), False),
        "one shape more": (svg.replace("<text>", "<use/><text>"), False),
    }
    (tmp_path / "one.svg").write_text(svg, encoding="utf-8")
    for what, (text, alike) in changes.items():
        (tmp_path / "other.svg").write_text(text, encoding="utf-8")
        assert pictures.same(tmp_path / "one.svg", tmp_path / "other.svg") is alike, what


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
    index = json.loads((site / "search.json").read_text(encoding="utf-8"))
    places = {item["location"].partition("#")[0] for item in index["items"]}
    assert {"course/meet.html", "procedure/four-dof.html", "grammar.html", "catalog/3-3.3.html"} <= places
