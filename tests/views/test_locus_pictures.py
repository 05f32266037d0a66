"""Pictures of loci: zeros over one variable, curves over two, and what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.views.drawing.drawing import Circle, Drawing, Polygon, Stroke, Text
from gcrules.views.plots.locus_plot import picture

OCTAHEDRAL = EXAMPLES / "octahedral.yaml"
COLOURS = {"entity1", "entity2", "entity3"}


def words(drawn: Drawing) -> list[str]:
    return ["".join(run.text for run in s.runs) for s in drawn.shapes if isinstance(s, Text)]


def marks(drawn: Drawing) -> list[float]:
    """Where full diamonds are, the key's left out."""
    found = [np.mean([x for x, _ in s.points]) for s in drawn.shapes if isinstance(s, Polygon) and s.fill == "mark"]
    return [float(x) for x in found[:-1]]


def test_zeros_over_one_variable() -> None:
    found = gc.locus(OCTAHEDRAL, over="z")
    drawn = picture(found)
    assert {"z (mm)", "−408.99", "−353.76", "−350", "fixed: x = 0, y = 0, no turn"} <= set(words(drawn))
    assert marks(drawn) == sorted(marks(drawn))
    assert len(marks(drawn)) == 3
    assert any(said.startswith("singular, P changes its sign") for said in words(drawn))
    assert "pose of the file" in words(drawn)


def test_a_zero_that_is_no_change_of_sign_is_another_mark() -> None:
    """The product over the working modes of 3-rps has a double zero; what is a zero need not be singular there."""
    drawn = picture(gc.locus("3-rps", over="z", at="roll=0deg, pitch=-90deg"))
    assert "singular in some working mode, where its root is real, P keeps its sign" in words(drawn)
    assert "−1.5" in words(drawn)
    assert any(isinstance(s, Circle) and s.stroke == "mark" for s in drawn.shapes)
    assert "pose of the file" not in words(drawn)


def test_angles_are_drawn_instead_of_tangents() -> None:
    drawn = picture(gc.locus(EXAMPLES / "platform-6-6.yaml", over="t1", rotation="zyx"))
    said = words(drawn)
    assert {"first Euler angle of zyx (deg)", "87.667°"} <= set(said)
    assert any(one.startswith("−92.96") for one in said)


@pytest.mark.parametrize("over", ["x,z", "y,z"])
def test_curves_are_zeros_of_their_factors(over: str) -> None:
    """Read back from the paper, through the ticks of the axes, they are zeros to a part of a place."""
    found = gc.locus(OCTAHEDRAL, over=over)
    drawn = picture(found)
    frame = next(s for s in drawn.shapes if isinstance(s, Polygon) and s.stroke == "ink")
    (left, bottom), (right, top) = frame.points[0], frame.points[2]
    reach = 2.0 * found.rig.size
    strokes = [s for s in drawn.shapes if isinstance(s, Stroke) and s.stroke in COLOURS and s.width == 2.0]
    curves = [s for s in strokes if left <= s.start[0] <= right and top <= s.start[1] <= bottom]
    assert len(curves) > 20
    for s in curves:
        first = -reach + 2 * reach * (s.start[0] - left) / (right - left)
        second = -reach + 2 * reach * (s.start[1] - bottom) / (top - bottom)
        form = found.factors[int(s.stroke[-1]) - 1].form
        slope = max(abs(form((first, second + d)) - form((first, second))) for d in (-1.0, 1.0))
        assert abs(form((first, second))) <= 1e-6 * slope


def test_brackets_are_named_and_what_is_not_there_is_told() -> None:
    said = words(picture(gc.locus(EXAMPLES / "four-dof.yaml", over="t1,t2", rotation="zyx")))
    assert "bracket [A1 B1 C1 S1] = 0 (no change of sign seen here)" in said
    assert "bracket [A2 S1 S2 S3] = 0" in said


def test_translations_reach_as_far_as_a_curve_is() -> None:
    found = gc.locus(EXAMPLES / "platform-6-6.yaml", over="x,y")
    assert not any("no change of sign" in said for said in words(picture(found)))


@pytest.mark.parametrize(
    ("source", "over", "more", "why"),
    [
        (OCTAHEDRAL, "translation", {}, "one or two variables, not of 3"),
        ("6-pus", "x", {"at": "y=1/2", "product": False}, "roots are variables"),
        (EXAMPLES / "octahedral.yaml", "x,y", {"at": "0 0 -350"}, "each of these poses is singular"),
    ],
    ids=["three", "roots", "all singular"],
)
def test_what_cannot_be_drawn(source: object, over: str, more: dict[str, object], why: str) -> None:
    with pytest.raises(InputError, match=why):
        gc.locus(source, over=over, **more).picture()


def test_the_command_writes_it(tmp_path: Path) -> None:
    file = tmp_path / "locus.svg"
    run = invoke("locus", str(OCTAHEDRAL), "--over", "z", "--picture", str(file))
    assert run.exit_code == 0, run.output
    assert file.read_text(encoding="utf-8") == gc.locus(OCTAHEDRAL, over="z").picture().svg()
    refused = invoke("locus", str(OCTAHEDRAL), "--picture", str(tmp_path / "other.svg"))
    assert refused.exit_code == 2
    assert "--over x,y" in refused.stderr
    assert not (tmp_path / "other.svg").exists()
