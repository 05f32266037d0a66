"""Check the documentation: generated pages are up to date, links between files lead somewhere.

``python tools/check_docs.py`` fails (exit code 1) when a page is stale or a link is broken;
``python tools/check_docs.py --write`` writes the generated pages first.
"""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from site_drawings import DRAWINGS

from gcrules.views.glossary import markdown

ROOT = Path(__file__).resolve().parent.parent

# The gcrules commands that write pages under docs/; each takes --check.
GENERATORS: tuple[tuple[str, ...], ...] = (("catalog", "docs"), ("robot", "docs"))

CODE = re.compile(r"^(```|~~~).*?^\1[ \t]*$|`[^`\n]+`", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)|^\[[^\]]+\]:\s*(\S+)", re.MULTILINE)
HEADING = re.compile(r"^#{1,6}[ \t]+(.+?)[ \t]*#*$", re.MULTILINE)
ANCHOR = re.compile(r"<a\s+(?:id|name)=\"([^\"]+)\"")


def pages() -> list[Path]:
    """The Markdown files that git tracks or would add; without git, all of them."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", "*.md"]
    try:
        listing = subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout.decode()
        found = [ROOT / name for name in listing.split("\0") if name]
    except (FileNotFoundError, subprocess.CalledProcessError):
        found = [p for p in ROOT.rglob("*.md") if not any(part.startswith(".") for part in p.relative_to(ROOT).parts)]
    return sorted(p for p in found if p.is_file())


def blank(match: re.Match[str]) -> str:
    """White space in place of code, so that line numbers stay."""
    return re.sub(r"[^\n]", " ", match.group())


def anchors(page: Path) -> set[str]:
    """The anchors of a page: its headings as hosting sites derive them, numbered when repeated, and explicit ones."""
    text = page.read_text(encoding="utf-8")
    found: set[str] = set(ANCHOR.findall(text))
    seen: dict[str, int] = {}
    fences = re.compile(r"^(```|~~~).*?^\1[ \t]*$", re.MULTILINE | re.DOTALL)
    for heading in HEADING.findall(fences.sub(blank, text)):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", plain.strip().lower()).replace(" ", "-")
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        found.add(f"{slug}-{count}" if count else slug)
    return found


def broken_links(page: Path) -> Iterator[str]:
    """One message for each link of the page to a file or heading of this repository that is not there."""
    text = CODE.sub(blank, page.read_text(encoding="utf-8"))
    for match in LINK.finditer(text):
        target = match.group(1) or match.group(2)
        if re.match(r"[a-z][a-z0-9+.-]*:", target, re.IGNORECASE):
            continue
        name, _, anchor = unquote(target).partition("#")
        path = (page.parent / name) if name else page
        line = text.count("\n", 0, match.start()) + 1
        if not path.exists():
            yield f"{page.relative_to(ROOT)}:{line}: no such file: {target}"
        elif anchor and path.suffix == ".md" and anchor not in anchors(path):
            yield f"{page.relative_to(ROOT)}:{line}: no such heading: {target}"


def generated() -> Iterator[tuple[Path, str]]:
    """The files of docs/ that no command of gcrules writes: the glossary and the drawings."""
    yield ROOT / "docs" / "glossary.md", markdown()
    for name, drawing in DRAWINGS.items():
        yield ROOT / "docs" / "assets" / "drawings" / f"{name}.svg", drawing().svg()


def stale_files(*, write: bool) -> Iterator[Path]:
    """Those that are not as they would be made; they are written first if asked for."""
    for path, text in generated():
        if write:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            yield path


def main(arguments: list[str]) -> int:
    """Run the generators (with ``--check`` unless asked to write), then follow every link."""
    write = "--write" in arguments
    stale = False
    for generator in GENERATORS:
        command = [str(Path(sys.executable).parent / "gcrules"), *generator, *(() if write else ("--check",))]
        stale |= subprocess.run(command, cwd=ROOT).returncode != 0
    for path in stale_files(write=write):
        print(f"{path.relative_to(ROOT)} is stale (python tools/check_docs.py --write)")
        stale = True
    checked = pages()
    broken = [message for page in checked for message in broken_links(page)]
    print(*broken, sep="\n", end="\n" if broken else "")
    print(f"documentation: {len(checked)} pages, {len(GENERATORS)} generators, {len(broken)} broken links")
    if not checked:
        print("documentation: no page found to check")
    return int(stale or bool(broken) or not checked)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
