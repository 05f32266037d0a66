"""The examples in the documents are true: commands print what stands there, Python answers what stands there.

`python tests/test_documents.py` writes the output of every command into the documents.
"""

from __future__ import annotations

import doctest
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
DOCUMENTS = ("README.md", "docs/language.md", "docs/conventions.md", "docs/files.md")
CONSOLE = re.compile(r"^```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PYTHON = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def session(block: str) -> Iterator[tuple[str, str]]:
    """The commands of a console block with the output that follows each."""
    for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, output = part.partition("\n")
        yield command, output


def run(command: str, folder: Path) -> str:
    words = shlex.split(command)
    assert words[0] == "gcrules", command
    if "-o" in words:
        at = words.index("-o") + 1
        words[at] = str(folder / words[at])
    environment = {**os.environ, "PYTHONIOENCODING": "utf-8", "NO_COLOR": "1"}
    done = subprocess.run(
        [sys.executable, "-m", "gcrules", *words[1:]],
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        check=False,
    )
    return done.stdout.replace(str(folder) + os.sep, "")


def blocks(pattern: re.Pattern[str]) -> list[tuple[str, str]]:
    return [(name, m[1]) for name in DOCUMENTS for m in pattern.finditer((ROOT / name).read_text(encoding="utf-8"))]


COMMANDS = [(name, c, out) for name, block in blocks(CONSOLE) for c, out in session(block)]


@pytest.mark.parametrize(("document", "command", "output"), COMMANDS, ids=[f"{d}: {c}" for d, c, _ in COMMANDS])
def test_command_prints_what_the_document_says(document: str, command: str, output: str, tmp_path: Path) -> None:
    assert run(command, tmp_path).rstrip("\n") == output.rstrip("\n")


def test_there_are_commands() -> None:
    assert len(COMMANDS) > 5


@pytest.mark.parametrize(("document", "block"), blocks(PYTHON), ids=[name for name, _ in blocks(PYTHON)])
def test_python_answers_what_the_document_says(document: str, block: str) -> None:
    test = doctest.DocTestParser().get_doctest(block, {}, document, document, 0)
    runner = doctest.DocTestRunner()
    runner.run(test)
    assert runner.tries
    assert not runner.failures


FILES = blocks(re.compile(r"^```yaml\n(.*?)^```$", re.MULTILINE | re.DOTALL))


@pytest.mark.parametrize("block", [b for _, b in FILES], ids=[b.split(":")[0] for _, b in FILES])
def test_files_are_what_the_document_says(block: str, tmp_path: Path) -> None:
    import gcrules as gc
    from gcrules.catalog_check import check_entry
    from gcrules.catalog_file import load_file

    path = tmp_path / "file.yaml"
    path.write_text(block, encoding="utf-8")
    if "points:" in block:
        assert gc.analyze(gc.load_platform(path)).pose is not None
    else:
        checked = [check_entry(e) for e in load_file(path).entries]
        assert checked
        assert all(c.ok for c in checked), checked


def rewrite(document: str) -> None:
    path = ROOT / document

    def fresh(match: re.Match[str]) -> str:
        import tempfile

        with tempfile.TemporaryDirectory() as folder:
            parts = [f"$ {c}\n{run(c, Path(folder)).rstrip()}".rstrip() + "\n" for c, _ in session(match[1])]
        return "```console\n" + "".join(parts) + "```"

    path.write_text(CONSOLE.sub(fresh, path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    for name in DOCUMENTS:
        rewrite(name)
