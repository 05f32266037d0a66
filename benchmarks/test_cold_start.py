"""From a cold shell: a fresh interpreter each time, beside one that loads NumPy alone, and one that loads the large
libraries at once.
"""

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
    ("code", "within", "imports"),
    [
        pytest.param("import gcrules", 0.1, 0.5, id="import"),
        pytest.param(command("analyze", LEGS), 0.3, 3.5, id="analyze"),
        pytest.param(command("prove", "ab /\\ cd == [abcd]"), 0.3, 2.5, id="prove"),
        pytest.param(command("pose", OCTAHEDRAL), 0.4, 7, id="pose"),
        pytest.param(command("pose", OCTAHEDRAL, "--no-nearest"), 0.4, 5, id="pose without the nearest"),
        *(
            pytest.param(command("robot", "analyze", name), 0.8, 12, id=f"robot analyze {name}")
            for name in ("3-rps", "tricept", "omni-wrist-iii", "par4", "h4")
        ),
        pytest.param(command("catalog", "check"), 2.5, 35, id="catalog check"),
    ],
)
def test_cold(ratio: Callable[..., Any], code: str, within: float, imports: float) -> None:
    """`imports` is how many times as long as importing NumPy it may take."""
    others = {
        "NumPy alone": python("import numpy"),
        "everything imported first": python(f"{LIBRARIES}; {code}"),
        "an empty program": python("pass"),
    }
    ratio(python(code), others, within=within, at_least={"NumPy alone": 1 / imports}, rounds=5)


def classes(module: str) -> str:
    """A program that makes a hundred frozen dataclasses and values of a third of them."""
    body = "@dataclass(frozen=True)\nclass C:\n    'A class.'\n    x: int\n    y: str = ''\n    z: tuple[int, ...] = ()"
    loop = "for n in range(100):\n    exec(body)\n    n % 3 or C(n)"
    return f"from {module} import dataclass\nbody = compile({body!r}, 'body', 'exec')\n{loop}"


def test_dataclasses(ratio: Callable[..., Any]) -> None:
    ours, others = python(classes("gcrules.core.dataclass")), {"dataclasses": python(classes("dataclasses"))}
    ratio(ours, others, at_least={"dataclasses": 1.2}, rounds=5)
