"""Check the built guide: nothing that a page loads lies outside it, and every file it loads is there.

``python tools/check_site.py build/site`` prints what it finds and fails (exit code 1). Links that a reader may follow
(``<a href>``) are free to lead anywhere.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

# Attributes from which a browser loads; `link` does so for all relations but those that only state something.
LOADING = {
    ("script", "src"),
    ("img", "src"),
    ("img", "srcset"),
    ("iframe", "src"),
    ("source", "src"),
    ("source", "srcset"),
    ("video", "src"),
    ("video", "poster"),
    ("audio", "src"),
    ("track", "src"),
    ("embed", "src"),
    ("object", "data"),
    ("input", "src"),
    ("image", "href"),
    ("image", "xlink:href"),
    ("use", "href"),
    ("use", "xlink:href"),
    ("form", "action"),
    ("body", "background"),
}
STATING = {"canonical", "alternate", "author", "license", "next", "prev", "search"}
NAMESPACES = ("http://www.w3.org/",)
OWN_HOST = "ws://${location.host}/"  # of the studio, where a server has sent its page
IN_CSS = re.compile(r"url\(\s*[\"']?([^\"')]+)|@import\s+[\"']([^\"']+)")
IN_JS = re.compile(r"[\"'`]((?:https?:|wss?:)?//[^\"'`\s]+)")


class _Loads(HTMLParser):
    """Collects what a page loads, with the line where it says so."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[int, str]] = []
        self.inside = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        line = self.getpos()[0]
        for name, value in given.items():
            if (tag, name) in LOADING:
                places = [part.split()[0] for part in value.split(",") if part.split()] if name == "srcset" else [value]
                self.found += [(line, place) for place in places]
            elif name == "style":
                self.found += [(line, m[1] or m[2]) for m in IN_CSS.finditer(value)]
        if tag == "link" and not set(given.get("rel", "").lower().split()) <= STATING:
            self.found.append((line, given.get("href", "")))
        if tag == "meta" and given.get("http-equiv", "").lower() == "refresh":
            self.found.append((line, given.get("content", "").partition("url=")[2]))
        self.inside = tag if tag in ("script", "style") else ""

    def handle_endtag(self, tag: str) -> None:
        self.inside = ""

    def handle_data(self, data: str) -> None:
        line = self.getpos()[0]
        if self.inside == "style":
            self.found += [(line, m[1] or m[2]) for m in IN_CSS.finditer(data)]
        elif self.inside == "script":
            self.found += [(line, m[1]) for m in IN_JS.finditer(data)]


def loads(path: Path) -> Iterator[tuple[int, str]]:
    """Line and target of everything that a file of the site makes a browser load."""
    text = path.read_text(encoding="utf-8")
    if path.suffix in (".html", ".svg"):
        parser = _Loads()
        parser.feed(text)
        yield from parser.found
        return
    pattern = IN_CSS if path.suffix == ".css" else IN_JS
    for match in pattern.finditer(text):
        yield text.count("\n", 0, match.start()) + 1, next(filter(None, match.groups()))


def faults(site: Path) -> Iterator[str]:
    """One message for each load that leaves the site or leads to nothing."""
    for path in sorted(p for p in site.rglob("*") if p.suffix in (".html", ".svg", ".css", ".js")):
        if path == site / "search.js":  # texts of the pages
            continue
        for line, target in loads(path):
            where = f"{path.relative_to(site)}:{line}"
            if target.startswith((*NAMESPACES, OWN_HOST)) or target.startswith(
                ("data:", "#", "about:blank", "javascript:")
            ):
                continue
            if re.match(r"(?:[a-z][a-z0-9+.-]*:)?//|[a-z][a-z0-9+.-]*:", target, re.IGNORECASE):
                yield f"{where}: leaves the site: {target}"
            elif target.startswith("/"):
                # 404.html is for servers, at the root of which the site would lie.
                if path.name != "404.html":
                    yield f"{where}: does not work from a folder: {target}"
            elif path.suffix != ".js" and target:
                name = unquote(re.split(r"[?#]", target)[0])
                if name and not (path.parent / name).exists():
                    yield f"{where}: no such file: {target}"


def main(arguments: list[str]) -> int:
    site = Path(arguments[0])
    found = list(faults(site))
    pages = sum(1 for _ in site.rglob("*.html"))
    print(*found, sep="\n", end="\n" if found else "")
    print(f"site: {pages} pages, {len(found)} loads that fail without a network")
    return int(bool(found) or not pages)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
