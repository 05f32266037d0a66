"""The examples in the documents are true: commands print what stands there, Python answers what stands there.

`python tests/test_documents.py` writes the output of every command and Python example into the documents.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest

ROOT = Path(__file__).resolve().parent.parent
# The pages of the catalog and of the robots are generated, and compared as a whole by tools/check_docs.py.
LEFT_OUT = ("catalog", "robots", "assets")
DOCUMENTS = (
    "README.md",
    *sorted(
        p.relative_to(ROOT).as_posix()
        for p in (ROOT / "docs").rglob("*.md")
        if p.relative_to(ROOT / "docs").parts[0] not in LEFT_OUT
    ),
)

# Blocks that no test runs, by document and first line, with the reason.
NOT_RUN = {
    ("README.md", "make demo     # makes .venv, installs, analyses the octahedral platform and writes its report"): (
        "targets of make; .ci/run goes through make test and make check"
    ),
    ("docs/rules.md", '[project.entry-points."gcrules.plugins"]'): "tests/outside is a package with such a table",
    ("docs/index.md", "make demo     # makes .venv, installs, analyses a platform and writes its report"): (
        "a target of make"
    ),
}


class Block(NamedTuple):
    """A fenced block of a document."""

    document: str
    line: int
    language: str
    text: str
    title: str = ""

    @property
    def name(self) -> str:
        return f"{self.document}:{self.line}"

    @property
    def first(self) -> str:
        return self.text.partition("\n")[0]


# A block with a title is a copy of the file of that name.
FENCE = re.compile(
    r"^(`{3,}|~{3,})[ ]*([\w-]*)(?:[ ]title=\"([^\"\n]*)\")?[^\n]*\n(.*?)^\1[ \t]*$", re.MULTILINE | re.DOTALL
)


def fenced(document: str) -> list[Block]:
    text = (ROOT / document).read_text(encoding="utf-8")
    return [Block(document, text.count("\n", 0, m.start()) + 1, m[2], m[4], m[3] or "") for m in FENCE.finditer(text)]


BLOCKS = [block for document in DOCUMENTS for block in fenced(document)]


def of(language: str) -> list[Block]:
    return [b for b in BLOCKS if b.language == language and not b.title]


# --- nothing is left out --------------------------------------------------------------------------------------------

RUN = ("console", "python", "gca", "yaml")


@pytest.mark.parametrize("block", [b for b in BLOCKS if b.title], ids=lambda b: b.title)
def test_copies_of_files_are_true(block: Block) -> None:
    assert block.text == (ROOT / block.title).read_text(encoding="utf-8")


@pytest.mark.parametrize("block", [b for b in BLOCKS if b.language not in RUN], ids=lambda b: b.name)
def test_other_blocks_are_known(block: Block) -> None:
    assert (block.document, block.first) in NOT_RUN, (
        f"{block.name}: a block in {block.language!r} is tested by nothing; "
        f"write it in one of {', '.join(RUN)}, or give the reason in NOT_RUN"
    )


def test_the_table_of_other_blocks_is_up_to_date() -> None:
    assert set(NOT_RUN) == {(b.document, b.first) for b in BLOCKS if b.language not in RUN}


DURATION = re.compile(r"\b([0-9.,]+) ?(?:[mµn]?s|sec|seconds?|minutes?)\b")


@pytest.mark.parametrize("block", of("console") + of("python"), ids=lambda b: b.name)
def test_no_output_depends_on_the_speed_of_a_machine(block: Block) -> None:
    """Times differ from run to run: an output that is compared must not tell any but the limit that was asked for."""
    lines = block.text.splitlines()
    typed = [line for line in lines if line.startswith(("$ ", ">>> ", "... "))]
    asked = set(re.findall(r"\bseconds[= ]([0-9.]+)", "\n".join(typed)))
    told = ((line, DURATION.findall(line)) for line in lines if line not in typed)
    assert not [line for line, times in told if not asked.issuperset(times)]


def test_there_is_something_to_run() -> None:
    assert all(len(of(language)) > 1 for language in RUN)
    assert len(DOCUMENTS) > 10


# A block inside a list or a fence that is not closed would not be found, and so not be tested.
@pytest.mark.parametrize("document", DOCUMENTS)
def test_every_fence_is_found(document: str) -> None:
    text = (ROOT / document).read_text(encoding="utf-8")
    assert len(re.findall(r"^[ \t>]*(?:```|~~~)", text, re.MULTILINE)) == 2 * len(fenced(document))


# --- console --------------------------------------------------------------------------------------------------------


def session(block: str) -> Iterator[tuple[str, str]]:
    """The commands of a console block with the output that follows each."""
    for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]:
        command, _, output = part.partition("\n")
        yield command, output


def run(command: str, folder: Path) -> str:
    words = shlex.split(command)
    if "-o" in words:
        at = words.index("-o") + 1
        words[at] = str(folder / words[at])
    path = os.environ.get("PATH", "")
    if "|" in words:  # a pipe, with `gcrules` as a command of its own
        tool = folder / "gcrules"
        tool.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m gcrules "$@"\n', encoding="utf-8")
        tool.chmod(0o755)
        path = f"{folder}{os.pathsep}{path}"
        words = ["sh", "-c", command]
    else:
        assert words[0] == "gcrules", command
        words = [sys.executable, "-m", "gcrules", *words[1:]]
    environment = {**os.environ, "PYTHONIOENCODING": "utf-8", "NO_COLOR": "1", "PATH": path}
    done = subprocess.run(
        words,
        cwd=ROOT,
        env=environment,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        check=False,
    )
    return done.stdout.replace(str(folder) + os.sep, "")


COMMANDS = [(b.document, c, out) for b in of("console") for c, out in session(b.text)]


@pytest.mark.parametrize(("document", "command", "output"), COMMANDS, ids=[f"{d}: {c}" for d, c, _ in COMMANDS])
def test_command_prints_what_the_document_says(document: str, command: str, output: str, tmp_path: Path) -> None:
    assert run(command, tmp_path).rstrip("\n") == output.rstrip("\n")


@pytest.mark.parametrize("block", of("console"), ids=lambda b: b.name)
def test_console_blocks_have_commands(block: Block) -> None:
    assert block.text.startswith("$ ")


# --- Python: the blocks of a document are one session ---------------------------------------------------------------

SESSIONS = {d: [b for b in of("python") if b.document == d] for d in dict.fromkeys(b.document for b in of("python"))}


@pytest.mark.parametrize("document", SESSIONS)
def test_python_answers_what_the_document_says(document: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(ROOT)
    names: dict[str, Any] = {}
    for block in SESSIONS[document]:
        test = doctest.DocTestParser().get_doctest(block.text, names, block.name, document, block.line)
        test.globs = names  # doctest copies what it is given
        runner = doctest.DocTestRunner()
        runner.run(test, clear_globs=False)
        assert runner.tries, block.name
        assert not runner.failures, block.name


# --- scripts and files ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("block", of("gca"), ids=lambda b: b.name)
def test_scripts_say_what_is_true(block: Block) -> None:
    from gcrules.algebra.language.statements import parse_script
    from gcrules.rules.script import run_script

    result = run_script(parse_script(block.text, block.name))
    assert result.results or "rule" in block.text.split()
    assert result.verdict == "proved", result.text()


@pytest.mark.parametrize("block", of("yaml"), ids=[f"{b.name}: {b.text.split(':')[0]}" for b in of("yaml")])
def test_files_are_what_the_document_says(block: Block, tmp_path: Path) -> None:
    import gcrules as gc
    from gcrules.conditions.catalog_check import check_entry
    from gcrules.rules.catalog.file import load_file

    path = tmp_path / "file.yaml"
    path.write_text(block.text, encoding="utf-8")
    if "limbs:" in block.text:
        assert gc.Robot.load(path).analyze().condition is not None
    elif "points:" in block.text:
        assert gc.analyze(gc.load_platform(path)).pose is not None
    else:
        checked = [check_entry(e) for e in load_file(path).entries]
        assert checked
        assert all(c.ok for c in checked), checked


# --- writing the outputs --------------------------------------------------------------------------------------------


def answered(text: str, names: dict[str, Any]) -> str:
    """A Python block with the output of each example as it is now."""
    parts: list[str] = []
    for example in doctest.DocTestParser().get_examples(text):
        first, *rest = example.source.rstrip("\n").split("\n")
        parts += [f">>> {first}", *(f"... {line}".rstrip() for line in rest)]
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown):
            exec(compile(example.source, "<example>", "single"), names)
        if shown.getvalue():
            parts += [line or "<BLANKLINE>" for line in shown.getvalue().rstrip("\n").split("\n")]
    return "\n".join([*parts, "", ""])


def rewrite(document: str) -> None:
    path = ROOT / document
    names: dict[str, Any] = {}

    def fresh(match: re.Match[str]) -> str:
        import tempfile

        fence, language, title, text = match[1], match[2], match[3], match[4]
        if title:
            copy = (ROOT / title).read_text(encoding="utf-8")
            return f'{fence}{language} title="{title}"\n{copy}{fence}'
        if language == "console":
            with tempfile.TemporaryDirectory() as folder:
                parts = [f"$ {c}\n{run(c, Path(folder)).rstrip()}".rstrip() + "\n" for c, _ in session(text)]
            return f"{fence}console\n{''.join(parts)}{fence}"
        if language == "python":
            return f"{fence}python\n{answered(text, names)}{fence}"
        return match[0]

    path.write_text(FENCE.sub(fresh, path.read_text(encoding="utf-8")), encoding="utf-8")


if __name__ == "__main__":
    os.chdir(ROOT)
    for name in sys.argv[1:] or DOCUMENTS:
        rewrite(name)
