"""Build the guide: ``python tools/build_site.py build/site``, or of another repository that is named after the site.

site_pages.py writes the pages into a folder beside the site, Zensical makes HTML of them, and what its scripts would
load from elsewhere is taken out. With the engine of site_engine.py, the folder that GCRULES_SITE_ENGINE names, examples
run in their pages (site_runs.py), and the studio beside them answers without a server. Anything that is wrong is
printed, and is an error (exit code 1).
"""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import sys
from pathlib import Path

import site_engine
import site_runs
import yaml
import zensical
from site_pages import Guide

ROOT = Path(__file__).resolve().parent.parent


def build(root: Path, site: Path, engine: Path | None = None) -> list[str]:
    """What is wrong with the guide of a repository; Zensical prints its warnings as they come."""
    guide, folder = Guide(root), site.resolve().parent / "guide"
    config = guide.write(folder, yaml.safe_load((root / "mkdocs.yml").read_text(encoding="utf-8")))
    config |= {"docs_dir": "docs", "site_dir": "site"}
    config["markdown_extensions"].append({"site_parts": {"parts": str(folder / "parts")}})
    if engine:
        config["extra_css"].append("assets/try/try.css")
        config["extra_javascript"].append("assets/try/try.js")
    for plugin in config["plugins"]:
        if "mkdocstrings" in plugin:  # its places are those of the repository
            python = plugin["mkdocstrings"]["handlers"]["python"]
            python["paths"] = [str(root / path) for path in python["paths"]]
            python["options"]["extensions"] = [str(root / path) for path in python["options"]["extensions"]]
    (folder / "mkdocs.yml").write_text(yaml.safe_dump(config, allow_unicode=True, sort_keys=False), encoding="utf-8")
    try:
        zensical.build(str(folder / "mkdocs.yml"), {"strict": True, "clean": True})
    except RuntimeError as error:
        return [*guide.faults, str(error)]
    _keep_at_home(folder / "site")
    _scripts_apart(folder / "site")
    if engine:
        try:
            _mark(folder / "site", engine)
        except (OSError, ValueError) as fault:
            return [*guide.faults, str(fault)]
        shutil.copytree(engine, folder / "site" / "assets" / "engine")
        site_engine.write_studio(folder / "site" / "studio", "../assets/try/worker.mjs")
    shutil.rmtree(site, ignore_errors=True)
    shutil.move(folder / "site", site)
    return guide.faults


def _mark(site: Path, engine: Path) -> None:
    """Say of the examples of all pages how they run."""
    pages = {page: page.read_text(encoding="utf-8") for page in sorted(site.rglob("*.html"))}
    tried = site_engine.tried(engine, [site_runs.sessions(html) for html in pages.values()])
    for (page, html), answers in zip(pages.items(), tried, strict=True):
        reasons = [site_runs.why_not_session(code, printed) for code, printed in answers]
        page.write_text(site_runs.marked(html, reasons), encoding="utf-8")


_SCRIPT = re.compile(r"<script>(.*?)</script>", re.DOTALL)


def _scripts_apart(site: Path) -> None:
    """Scripts in pages as files beside them, so that a server may forbid all scripts that stand in pages.

    Reports keep theirs: from a folder, a frame without access to the page around it may load no file.
    """
    folder = site / "assets" / "javascripts" / "of-pages"
    folder.mkdir(parents=True)
    for page in {*site.rglob("*.html")} - {*(site / "assets" / "reports").glob("*.html")}:

        def apart(match: re.Match[str], page: Path = page) -> str:
            name = f"{hashlib.sha256(match[1].encode()).hexdigest()[:16]}.js"
            (folder / name).write_text(match[1], encoding="utf-8")
            return f'<script src="{Path(os.path.relpath(folder / name, page.parent)).as_posix()}"></script>'

        page.write_text(_SCRIPT.sub(apart, page.read_text(encoding="utf-8")), encoding="utf-8")


def _keep_at_home(site: Path) -> None:
    """Scripts without the theme's fallbacks for other pages and browsers: diagrams, old browsers, repository facts."""
    scripts = site / "assets" / "javascripts"
    for surplus in scripts.rglob("*.map"):
        surplus.unlink()
    for script in scripts.rglob("*.js"):
        text = script.read_text(encoding="utf-8")
        text = re.sub(
            r"""(["'`])https://(?:unpkg\.com|cdn\.jsdelivr\.net|api\.github\.com|\$\{e\})[^"'`]*\1""",
            '"about:blank"',
            text,
        )
        script.write_text(re.sub(r"\n//# sourceMappingURL=.*\s*$", "\n", text), encoding="utf-8")


def main(arguments: list[str]) -> int:
    engine = os.environ.get("GCRULES_SITE_ENGINE")
    found = build(Path(arguments[1]) if arguments[1:] else ROOT, Path(arguments[0]), Path(engine) if engine else None)
    print(*found, sep="\n", end="\n" if found else "")
    return int(bool(found))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
