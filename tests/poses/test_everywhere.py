"""A platform that is singular in every pose: each question for a regular pose is answered by that, with exit code 1."""

from __future__ import annotations

from pathlib import Path

import pytest
from commands import invoke

import gcrules as gc
from gcrules.core.errors import SingularEverywhere

BASE = {"A": (2, 0, 0), "B": ("6/5", "8/5", 0), "C": ("-6/5", "8/5", 0)}
BASE |= {"D": (-2, 0, 0), "E": ("-6/5", "-8/5", 0), "F": ("6/5", "-8/5", 0)}
TOP = {"a": (1, 0, 1), "b": ("3/5", "4/5", 1), "c": ("-3/5", "4/5", 1)}
TOP |= {"d": (-1, 0, 1), "e": ("-3/5", "-4/5", 1), "f": ("3/5", "-4/5", 1)}
HEXAGONS = {"legs": "Aa Bb Cc Dd Ee Ff", "points": BASE | TOP}
TEXT = "legs: [Aa, Bb, Cc, Dd, Ee, Ff]\npoints:\n" + "".join(
    f"  {name}: [{', '.join(map(str, place))}]\n" for name, place in (BASE | TOP).items()
)


@pytest.mark.parametrize(
    "ask",
    [
        lambda r: gc.plan(r, "0 0 0", "0 0 1"),
        lambda r: gc.plan(r, "0 0 0"),
        lambda r: gc.aspects(r, poses=2),
        lambda r: gc.free_region(r),
        lambda r: gc.box_map(r, ["z 0:1"]),
        lambda r: gc.certify(r, ["z 0:1"]),
    ],
    ids=["plan", "way out", "aspects", "free", "boxes", "certify"],
)
def test_functions(ask) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(SingularEverywhere, match="singular in every pose: forces along the six legs balance"):
        ask(gc.load(HEXAGONS))


@pytest.mark.parametrize(
    "words", [("certify", "--over", "z 0:1"), ("plan", "--from", "0 0 0", "--to", "0 0 1"), ("free",)], ids=" ".join
)
def test_commands(words: tuple[str, ...], tmp_path: Path) -> None:
    path = tmp_path / "hexagons.yaml"
    path.write_text(TEXT, encoding="utf-8")
    done = invoke(words[0], str(path), *words[1:])
    assert done.exit_code == 1
    assert "Architecturally singular" in done.stderr


def test_a_report_goes_without_what_has_no_answer() -> None:
    asked = {"aspects": True, "free": "box", "plan": ["home"], "over": ["z 0:1"], "certify": ["z 0:1"]}
    page = gc.report(gc.load(HEXAGONS), interactive=False, **asked)
    for heading in ("Whole ranges", "A certificate", "Aspects", "A way without a singularity", "A free region"):
        assert f'<h2>{heading}</h2><p class="why">Architecturally singular' in page
