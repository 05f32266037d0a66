"""What MkDocs does beyond its plugins when it builds the guide (`hooks` in mkdocs.yml).

* `<!-- drawing: NAME | caption -->` becomes a drawing of site_drawings.py, `<!-- generated: NAME -->` a part of
  site_grammar.py. Both are comments, so that the pages read well where they are not built.
* Figures of gcrules that a page shows as images are put into the page, so that they follow its light and dark colours.
* The pages of the catalog and of the robots come into the navigation by themselves.
* What the theme's scripts would load in cases that do not occur here is taken out, with its source maps.
* A link to a file of the repository outside docs/ leads to a page that shows the file.
* With the engine of site_engine.py, the folder that GCRULES_SITE_ENGINE names, examples run in their pages.
"""

from __future__ import annotations

import logging
import os
import posixpath
import re
import shutil
from html import escape, unescape
from pathlib import Path

import pygments.lexers
import site_drawings
import site_grammar
import site_lexer
import site_runs
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

from gcrules.views.drawing.palette import ROLES

ROOT = Path(__file__).resolve().parent.parent
ENGINE = os.environ.get("GCRULES_SITE_ENGINE")
LOG = logging.getLogger("mkdocs.hooks.gcrules")

OVERVIEWS = ("catalog/README.md", "robots/index.md")
DRAWING = re.compile(r"^<!-- drawing: ([\w-]+)(?: \| (.*?))?\s*-->$", re.MULTILINE | re.DOTALL)
GENERATED = re.compile(r"^<!-- generated: ([\w-]+) -->$", re.MULTILINE)
SESSION = re.compile(r"^```python\n>>> ", re.MULTILINE)
LINK = re.compile(r"(\]\()((?:\.\./)+[^)#\s]+)((?:#[^)\s]*)?\))")
IMAGE = re.compile(r'<img alt="([^"]*)" src="([^":]+\.svg)"[^>]*>')
LANGUAGES = {".gca": "gca", ".lark": "text", ".yaml": "yaml", ".py": "python", ".toml": "toml", ".md": "markdown"}


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    pygments.lexers.LEXERS["GcaLexer"] = (site_lexer.__name__, "gcrules script", ("gca",), ("*.gca",), ())
    if ENGINE:
        config.extra_css.append("assets/try/try.css")
        config.extra_javascript.append("assets/try/try.js")
    for section in config.nav or ():
        for title, target in section.items():
            if target in OVERVIEWS:
                section[title] = [target, *_listed(Path(config.docs_dir), target)]
    return config


def _listed(docs: Path, overview: str) -> list[dict[str, list[dict[str, str]]]]:
    """The pages beside an overview, under its headings, each where it is listed first."""
    path = docs / overview
    folder = path.parent
    left = {p.stem for p in folder.glob("*.md")} - {path.stem}
    groups: dict[str, list[str]] = {}
    for section in re.split(r"^## ", path.read_text(encoding="utf-8"), flags=re.MULTILINE)[1:]:
        title, _, body = section.partition("\n")
        names = [n for n in dict.fromkeys(re.findall(r"\]\(([^)/]+)\.md\)", body)) if n in left]
        left -= set(names)
        groups[unescape(title)] = names
    groups["Others"] = sorted(left)
    return [{title: [{n: f"{folder.name}/{n}.md"} for n in names]} for title, names in groups.items() if names]


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """A page for each file of the repository that a page of the guide links to."""
    shown: dict[str, Path] = {}
    for file in files.documentation_pages():
        for match in LINK.finditer(file.content_string):
            target = posixpath.normpath(posixpath.join("docs", posixpath.dirname(file.src_uri), match[2]))
            if not target.startswith("docs/") and (ROOT / target).is_file():
                shown[target] = ROOT / target
    for target, path in sorted(shown.items()):
        language = LANGUAGES.get(path.suffix, "text")
        body = f"# {target}\n\n`````{language}\n{path.read_text(encoding='utf-8').rstrip()}\n`````\n"
        files.append(File.generated(config, f"source/{target}.md", content=body))
    files.append(File.generated(config, "assets/figures.css", content=_colours()))
    return files


def _colours() -> str:
    """The colours of figures as variables, so that they follow the scheme that the reader has chosen."""
    schemes = (
        (scheme, "".join(f"--gc-{role}:{values[i]};" for role, values in ROLES.items() if role != "paper"))
        for i, scheme in enumerate(("default", "slate"))
    )
    return "".join(f'[data-md-color-scheme="{scheme}"]{{{rules}}}\n' for scheme, rules in schemes)


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    folder = posixpath.dirname(page.file.src_uri)

    def inside(match: re.Match[str]) -> str:
        target = posixpath.normpath(posixpath.join("docs", folder, match[2]))
        shown = f"source/{target}.md"
        if target.startswith("docs/") or files.get_file_from_path(shown) is None:
            return match[0]
        return f"{match[1]}{posixpath.relpath(shown, folder or '.')}{match[3]}"

    def drawing(match: re.Match[str]) -> str:
        name, caption = match[1], match[2]
        if name not in site_drawings.DRAWINGS:
            LOG.warning(
                "%s asks for the drawing %r, which tools/site_drawings.py does not make", page.file.src_uri, name
            )
            return ""
        words = f"\n<figcaption markdown>{' '.join(caption.split())}</figcaption>" if caption else ""
        return f'<figure class="gc-drawing" markdown>\n{PLACE.format(name)}{words}\n</figure>'

    def generated(match: re.Match[str]) -> str:
        if match[1] not in site_grammar.PARTS:
            LOG.warning(
                "%s asks for the part %r, which tools/site_grammar.py does not make", page.file.src_uri, match[1]
            )
            return ""
        return f'<div class="gc-part">{PLACE.format(match[1])}</div>'

    if page.parent is None:  # there is nothing beside it to navigate to
        page.meta.setdefault("hide", []).append("navigation")
    markdown = SESSION.sub("```pycon\n>>> ", LINK.sub(inside, markdown))
    made = GENERATED.sub(generated, DRAWING.sub(drawing, markdown))
    for left in re.findall(r"<!-- (?:drawing|generated):.*", made):
        LOG.warning("%s: not a line of its own, or not of the form that is read: %s", page.file.src_uri, left)
    return made


# Where a drawing or a part will stand, through the conversion of Markdown.
PLACE = "@@gcrules:{}@@"
PLACES = re.compile(r"@@gcrules:([\w-]+)@@")


def on_page_content(html: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    def made(match: re.Match[str]) -> str:
        name = match[1]
        return site_drawings.DRAWINGS[name]().svg() if name in site_drawings.DRAWINGS else site_grammar.PARTS[name]()

    def figure(match: re.Match[str]) -> str:
        path = Path(config.docs_dir, posixpath.dirname(page.file.src_uri), unescape(match[2]))
        svg = path.read_text(encoding="utf-8") if path.is_file() else ""
        if 'class="gc-figure"' not in svg:
            return match[0]
        if "<title>" not in svg:
            svg = svg.replace('role="img">', f'role="img" aria-label="{escape(unescape(match[1]))}">', 1)
        return svg.strip()

    html = PLACES.sub(made, IMAGE.sub(figure, html))
    return site_runs.marked(html) if ENGINE else html


def on_post_build(config: MkDocsConfig) -> None:
    """Scripts without the theme's fallbacks for other pages and browsers: diagrams, old browsers, repository facts."""
    scripts = Path(config.site_dir) / "assets" / "javascripts"
    for surplus in (*scripts.rglob("*.map"), *scripts.glob("lunr/**/*.js")):
        surplus.unlink()
    for script in scripts.rglob("*.js"):
        text = script.read_text(encoding="utf-8")
        text = re.sub(r"""(["'`])https://(?:unpkg\.com|api\.github\.com|\$\{e\})[^"'`]*\1""", '"about:blank"', text)
        script.write_text(re.sub(r"\n//# sourceMappingURL=.*\s*$", "\n", text), encoding="utf-8")
    if ENGINE:
        shutil.copytree(ROOT / ENGINE, Path(config.site_dir) / "assets" / "engine")
