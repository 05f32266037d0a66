"""The pages of the guide as the site is built from them: docs/ with what its Markdown only asks for.

* `<!-- generated: NAME -->` becomes a part of site_grammar.py.
* An image and the paragraph after it become a figure with its caption if all of the paragraph is emphasised.
* Figures of gcrules that a page shows as images are put into the page, so that they follow its light and dark colours.
* The first use of each term of the glossary leads there (site_glossary.py).
* The lines of the page on Python become what docstrings say (site_api.py).
* A link to a file of the repository outside docs/ leads to a page that shows the file.
* A report of an example that a page shows in a frame is made: assets/reports/NAME.html, of examples/NAME.yaml.
* The pages of the catalog and of the robots come into the navigation by themselves.
"""

from __future__ import annotations

import hashlib
import posixpath
import re
import shutil
from collections.abc import Iterator, Mapping
from html import escape, unescape
from pathlib import Path
from typing import Any

import site_api
import site_glossary
import site_grammar
from site_parts import PLACE

import gcrules as gc
from gcrules.views.drawing.palette import ROLES

__all__ = ["Guide"]

ROOT = Path(__file__).resolve().parent.parent

OVERVIEWS = ("catalog/README.md", "robots/index.md")
CAPTIONED = re.compile(r"^(!\[[^\n]*\]\([^)\s]+\))\n\n\*([^*\n](?:[^*\n]|\n(?!\n))*)\*$(?=\n\n|\s*\Z)", re.MULTILINE)
GENERATED = re.compile(r"^<!-- generated: ([\w-]+) -->$", re.MULTILINE)
SESSION = re.compile(r"^```python\n>>> ", re.MULTILINE)
LINK = re.compile(r"(\]\()((?:\.\./)+[^)#\s]+)((?:#[^)\s]*)?\))")
IMAGE = re.compile(r"!\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^):\s]+\.svg)\)")
REPORT = re.compile(r'<iframe src="(?:\.\./)*assets/reports/([a-z0-9-]+)\.html"')
LANGUAGES = {".gca": "gca", ".lark": "text", ".yaml": "yaml", ".py": "python", ".toml": "toml", ".md": "markdown"}


class Guide:
    """The guide of a repository. What its pages ask for in vain is in `faults` once they are written."""

    def __init__(self, root: Path = ROOT) -> None:
        self.root, self.docs = root, root / "docs"
        found = sorted(self.docs.rglob("*.md"))
        self.pages = {
            path.relative_to(self.docs).as_posix(): path.read_text(encoding="utf-8")
            for path in found
            if self.docs / "assets" not in path.parents
        }
        self.sources = dict(sorted(self._sources()))
        self.parts: dict[str, str] = {}
        self.faults: list[str] = []

    def _sources(self) -> Iterator[tuple[str, Path]]:
        """The files outside docs/ that a page links to, by the places of the pages that show them."""
        for page, text in self.pages.items():
            for match in LINK.finditer(text):
                shown = self._shown(page, match[2])
                if shown is not None:
                    yield shown, self.root / shown.removeprefix("source/").removesuffix(".md")

    def _shown(self, page: str, target: str) -> str | None:
        inside = posixpath.normpath(posixpath.join("docs", posixpath.dirname(page), target))
        if inside.startswith("docs/") or not (self.root / inside).is_file():
            return None
        return f"source/{inside}.md"

    # --- navigation --------------------------------------------------------------------------------------------------

    def navigation(self, nav: list[Any], apart: str = "") -> list[Any]:
        """That of mkdocs.yml with the pages of the overviews. A page that is neither in it nor in a folder that stands
        apart (`not_in_nav`) is a fault.
        """
        whole = [
            {title: [target, *self._listed(target)] if target in OVERVIEWS else target for title, target in e.items()}
            for e in nav
        ]
        listed, there = set(_targets(whole)), set(self.pages)
        self.faults += [f"mkdocs.yml: no such page: {page}" for page in sorted(listed - there)]
        folders = tuple(line.lstrip("/") for line in apart.split())
        left = {page for page in there - listed if not page.startswith(folders)}
        self.faults += [f"mkdocs.yml: not in the navigation: {page}" for page in sorted(left)]
        return whole

    def _listed(self, overview: str) -> list[dict[str, list[dict[str, str]]]]:
        """The pages beside an overview, under its headings, each where it is listed first."""
        folder = posixpath.dirname(overview)
        left = {
            page.removeprefix(f"{folder}/").removesuffix(".md") for page in self.pages if page.startswith(folder + "/")
        }
        left.discard(posixpath.basename(overview).removesuffix(".md"))
        groups: dict[str, list[str]] = {}
        for section in re.split(r"^## ", self.pages[overview], flags=re.MULTILINE)[1:]:
            title, _, body = section.partition("\n")
            names = [n for n in dict.fromkeys(re.findall(r"\]\(([^)/]+)\.md\)", body)) if n in left]
            left -= set(names)
            groups[unescape(title)] = names
        groups["Others"] = sorted(left)
        return [{title: [{n: f"{folder}/{n}.md"} for n in names]} for title, names in groups.items() if names]

    # --- pages -------------------------------------------------------------------------------------------------------

    def page(self, name: str) -> str:
        """The Markdown of a page."""
        folder = posixpath.dirname(name)

        def inside(match: re.Match[str]) -> str:
            shown = self._shown(name, match[2])
            return match[0] if shown is None else f"{match[1]}{posixpath.relpath(shown, folder or '.')}{match[3]}"

        def captioned(match: re.Match[str]) -> str:
            image, caption = match.groups()
            words = f"<figcaption markdown>{' '.join(caption.split())}</figcaption>"
            return f'<figure class="gc-drawing" markdown>\n{image}\n{words}\n</figure>'

        def generated(match: re.Match[str]) -> str:
            if match[1] not in site_grammar.PARTS:
                self.faults.append(f"{name}: no such part in tools/site_grammar.py: {match[1]}")
                return ""
            return f'<div class="gc-part">{self._place(site_grammar.PARTS[match[1]]())}</div>'

        def figure(match: re.Match[str]) -> str:
            path = self.docs / folder / match[2]
            svg = path.read_text(encoding="utf-8") if path.is_file() else ""
            if 'class="gc-figure"' not in svg:
                return match[0]
            if "<title>" not in svg:
                svg = svg.replace('role="img">', f'role="img" aria-label="{escape(unescape(match[1]))}">', 1)
            return self._place(svg.strip())

        text = site_api.directives(self.pages[name]) if name == site_api.PAGE else self.pages[name]
        text = site_glossary.link(text, name)
        text = SESSION.sub("```pycon\n>>> ", LINK.sub(inside, text))
        text = GENERATED.sub(generated, IMAGE.sub(figure, CAPTIONED.sub(captioned, text)))
        for left in re.findall(r"<!-- generated:.*", text):
            self.faults.append(f"{name}: not a line of its own, or not of the form that is read: {left}")
        return text

    def source(self, name: str) -> str:
        """The Markdown of the page that shows a file."""
        path = self.sources[name]
        title, text = path.relative_to(self.root).as_posix(), path.read_text(encoding="utf-8").rstrip()
        return f"# {title}\n\n`````{LANGUAGES.get(path.suffix, 'text')}\n{text}\n`````\n"

    def _place(self, part: str) -> str:
        """Where a part will stand, which is named for what it holds."""
        name = hashlib.sha256(part.encode()).hexdigest()[:16]
        self.parts[name] = part
        return PLACE.format(name)

    # --- everything --------------------------------------------------------------------------------------------------

    def write(self, folder: Path, config: Mapping[str, Any]) -> dict[str, Any]:
        """Write the pages, what they load and their parts into a new folder; what mkdocs.yml has to say of them."""
        nav = self.navigation(config["nav"], config.get("not_in_nav", ""))
        beside = {
            page for entry in nav for target in entry.values() if isinstance(target, list) for page in _targets(target)
        }
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.docs, folder / "docs")
        texts = {name: self.page(name) for name in self.pages} | {name: self.source(name) for name in self.sources}
        for name, text in texts.items():
            # A page with no other ones beside it has nothing to navigate to.
            _write(folder / "docs" / name, text if name in beside else f"---\nhide: [navigation]\n---\n\n{text}")
        _write(folder / "docs" / "assets" / "figures.css", _colours())
        for name in {name for text in texts.values() for name in REPORT.findall(text)}:
            report = gc.report(str(self.root / "examples" / f"{name}.yaml"))
            _write(folder / "docs" / "assets" / "reports" / f"{name}.html", report)
        for name, part in self.parts.items():
            _write(folder / "parts" / name, part)
        return {**config, "nav": nav}


def _targets(nav: Any) -> Iterator[str]:
    if isinstance(nav, str):
        yield nav
    for part in nav.values() if isinstance(nav, dict) else nav if isinstance(nav, list) else ():
        yield from _targets(part)


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def _colours() -> str:
    """The colours of figures as variables, so that they follow the scheme that the reader has chosen."""
    schemes = (
        (scheme, "".join(f"--gc-{role}:{values[i]};" for role, values in ROLES.items() if role != "paper"))
        for i, scheme in enumerate(("default", "slate"))
    )
    return "".join(f'[data-md-color-scheme="{scheme}"]{{{rules}}}\n' for scheme, rules in schemes)
