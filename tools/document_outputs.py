"""The outputs in README.md and docs/ as they are now: `python tools/document_outputs.py [PAGE]...` writes them."""

from __future__ import annotations

import contextlib
import doctest
import io
import os
import re
import sys
import tempfile
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from documents import DOCUMENTS, FENCE, run, session  # noqa: E402


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
