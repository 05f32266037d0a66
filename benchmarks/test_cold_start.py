"""From a cold shell: a fresh interpreter each time, beside one that loads the large libraries at once."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

LEGS = "ab af cb cd ed ef"
LIBRARIES = "import sympy, networkx, numpy, yaml, lark"
OCTAHEDRAL = str(Path(__file__).resolve().parent.parent / "examples" / "octahedral.yaml")


def command(*words: str) -> str:
    """A program that does what the command does."""
    return f"import sys; sys.argv = ['gcrules', *{words!r}]; from gcrules.apps.main import main; main()"


def python(code: str) -> Callable[[], str]:
    """A function that runs the code in a fresh interpreter and returns what it prints."""

    def run() -> str:
        return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout

    return run


@pytest.mark.parametrize(
    ("code", "within"),
    [
        pytest.param("import gcrules", 0.1, id="import"),
        pytest.param(command("analyze", LEGS), 0.3, id="analyze"),
        pytest.param(command("pose", OCTAHEDRAL), 0.4, id="pose"),
        pytest.param(command("pose", OCTAHEDRAL, "--no-nearest"), 0.4, id="pose without the nearest"),
        pytest.param(command("catalog", "check"), 2.5, id="catalog check"),
    ],
)
def test_cold(ratio: Callable[..., Any], code: str, within: float) -> None:
    others = {"everything imported first": python(f"{LIBRARIES}; {code}"), "an empty program": python("pass")}
    ratio(python(code), others, within=within, rounds=5)
