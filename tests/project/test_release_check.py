"""What is checked before a release: that tag, version, citation and changelog agree, and what is told of the trials."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from places import ROOT, tool

import gcrules

release_check = tool("release_check")


def tree(folder: Path, version: str, citation: str, changelog: str) -> Path:
    (folder / "gcrules" / "core").mkdir(parents=True)
    (folder / "gcrules" / "core" / "version.py").write_text(f'__version__ = "{version}"\n', encoding="utf-8")
    (folder / "CITATION.cff").write_text(citation, encoding="utf-8")
    (folder / "CHANGELOG.md").write_text(changelog, encoding="utf-8")
    return folder


def test_this_tree_agrees() -> None:
    assert release_check.version_of(ROOT) == gcrules.__version__
    assert list(release_check.disagreements(ROOT, None)) == []


CITED = "title: x\nversion: 1.2.0\ndate-released: 2026-01-31\n"
CHANGES = "# Changelog\n\n## [Unreleased]\n\n## [1.2.0] - 2026-01-31\n"


@pytest.mark.parametrize(
    ("tag", "citation", "changelog", "wrong"),
    [
        ("v1.2.0", CITED, CHANGES, []),
        (None, CITED, CHANGES, []),
        (None, CITED, "## [Unreleased]\n\nBecomes 1.2.0.\n", []),
        ("v1.3.0", CITED, CHANGES, ["the tag is v1.3.0, the version 1.2.0"]),
        ("v1.2.0", CITED.replace("1.2.0", "1.1.0"), CHANGES, ["CITATION.cff does not name the version 1.2.0"]),
        ("v1.2.0", "title: x\nversion: 1.2.0\n", CHANGES, ["CITATION.cff has no date-released"]),
        ("v1.2.0", CITED, "## [Unreleased]\n\nBecomes 1.2.0.\n", ["CHANGELOG.md has no section of 1.2.0"]),
        (None, CITED, "## [Unreleased]\n", ["CHANGELOG.md has no section of 1.2.0"]),
    ],
)
def test_what_does_not_agree(tag: str | None, citation: str, changelog: str, wrong: list[str], tmp_path: Path) -> None:
    assert list(release_check.disagreements(tree(tmp_path, "1.2.0", citation, changelog), tag)) == wrong


def test_a_tree_without_git_has_no_tag(tmp_path: Path) -> None:
    assert release_check.tag_of(tmp_path) is None


def test_what_was_tried_on_no_python_is_no_success() -> None:
    def seen(*faults: str | None) -> list[Any]:
        return [
            release_check.Trial("Python", fault, what=what)
            for fault, what in zip(faults, release_check.RESOLUTIONS, strict=True)
        ]

    assert release_check.untried_in(seen("", "")) == []
    assert release_check.untried_in(seen("wrong", "")) == []
    assert release_check.untried_in(seen(None, "")) == ["lowest"]
    assert release_check.untried_in(seen(None, None)) == ["lowest", "newest"]
    assert release_check.untried_in([*seen(None, None), *seen("", "")]) == []


def test_trials_are_told() -> None:
    trial = release_check.Trial
    assert trial("Python 3.11", "", "numpy 2.0").line.endswith("ok        numpy 2.0")
    assert "failed    wrong" in trial("Python 3.11", "wrong").line
    assert "left out  there is no such Python" in trial("Python 3.14", None, "there is no such Python").line
