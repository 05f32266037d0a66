"""The singular surface as the studio's server tells it: where it is, how sure, and what to do where there is none."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from gcrules.apps.studio.map_view import place_view
from gcrules.apps.studio.numbers import numbers
from gcrules.apps.studio.protocol.requests import HOME, PoseJson
from gcrules.apps.studio.repeating import repeated
from gcrules.apps.studio.subject import Subject, read_subject
from gcrules.apps.studio.surface_view import surface_of, surface_view
from gcrules.core.errors import InputError, LimitReached

pytest.importorskip("skimage", reason="needs the extra gcrules[maps]")

OVER = ["x -490:490:9", "y -490:490:9", "z -490:490:9"]
TURNED: PoseJson = {"translation": [10.0, 20.0, 30.0], "quaternion": [0.9, 0.1, 0.2, 0.3]}


def shown(*asked: Any) -> Any:
    return surface_view(surface_of(*asked))


def example(name: str = "octahedral") -> Subject:
    return read_subject({"kind": "example", "name": name})


def robot(name: str) -> Subject:
    return read_subject({"kind": "robot", "id": name})


def corners(answer: Any) -> Any:
    return np.array(answer["vertices"]).reshape(-1, 3)


@pytest.mark.parametrize("pose", [HOME, TURNED], ids=["home", "turned"])
def test_corners_are_singular_poses_of_a_platform(pose: PoseJson) -> None:
    """Each is one by the margin, by another road than the polynomial of the surface."""
    subject = example()
    found = shown(subject, OVER, pose)
    places = corners(found)
    assert len(places) > 50
    assert max(found["faces"]) == len(places) - 1
    for place in places[:: len(places) // 8].tolist():
        at = place_view(subject, OVER, pose, place)["pose"]
        assert at["translation"] == pytest.approx(place, abs=1e-6)
        assert at["quaternion"] == pytest.approx(pose["quaternion"] / np.linalg.norm(pose["quaternion"]), abs=1e-9)
        assert numbers(subject, at, None)["margin"] < 1e-6


def test_how_sure_it_is() -> None:
    found = shown(example(), OVER, HOME)
    assert found["cells"] == 8**3
    assert 0 < found["free"] < found["cells"]
    assert f"{found['free']:,} cells are proved free" in found["guarantee"]
    assert found["guarantee"].lower().startswith("every singular pose of the volume lies in ")
    assert "singular poses up to rounding" in found["resolution"]
    assert "122 mm apart" in found["resolution"]
    assert found["held"] == {}


def test_axes_may_come_in_any_sequence() -> None:
    first, other = (shown(example(), over, HOME) for over in (OVER, OVER[::-1]))
    a, b = corners(first), corners(other)
    assert len(a) == len(b)
    assert a[np.lexsort(a.T)] == pytest.approx(b[np.lexsort(b.T)], abs=1e-6)


def test_a_robot_with_limbs() -> None:
    over = ["x 0:2:3", "y 0:2:3", "z 0:2:3"]
    found = shown(robot("orthoglide"), over, HOME)
    assert found["faces"]
    assert "drawn between the nodes" in found["resolution"]
    assert "4 cells are proved free" in found["guarantee"]
    assert found["held"] == {}


@pytest.mark.parametrize(("name", "freedoms"), [("3-rps", "z, roll and pitch"), ("3-ups-s", "roll, pitch and yaw")])
def test_what_to_use_with_other_freedoms(name: str, freedoms: str) -> None:
    with pytest.raises(InputError) as refused:
        shown(robot(name), ["x -1:1:5", "y -1:1:5", "z -1:1:5"], HOME)
    assert "not free in x, y and z" in str(refused.value)
    assert freedoms in (refused.value.hint or "")


def test_what_is_refused() -> None:
    with pytest.raises(InputError, match="over x, y and z, not over x, y and rz"):
        shown(example(), [*OVER[:2], "rz -10:10:5 deg"], HOME)
    with pytest.raises(InputError, match="a place of 2 numbers in a map over 3 coordinates"):
        place_view(example(), OVER, HOME, [0.0, 0.0])
    with pytest.raises(LimitReached, match="1,030,301 poses"):
        shown(example(), [f"{n} -1:1:101" for n in "xyz"], HOME)


def test_the_lines_that_repeat_it() -> None:
    args = {"source": {"kind": "example", "name": "octahedral"}, "over": OVER, "pose": HOME}
    lines = repeated(example(), "surface", args)
    assert "gcrules map" in lines["shell"]
    assert "z -490:490:9" in lines["python"]
