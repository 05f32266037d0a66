"""Certificates: what is proved of whole ranges, against samples of poses and joints that had no part in the proof."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from certificate_trees import sign_at
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import FileError, InputError
from gcrules.poses.certificates.certificate import Certificate

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
HEAD = ["roll -40:40 deg", "pitch -40:40 deg", "yaw -65:65 deg"]
MOTORS = "actuators -83.898..44.102 deg, q2 -105.898..44.102 deg, q5 -105.898..44.102 deg"


@cache
def head() -> Certificate:
    return gc.certify("reachy-mini-head", HEAD, limits=MOTORS, cone="40 deg", boxes=8000)


def test_the_head_of_the_reachy_mini_is_free_of_singular_poses() -> None:
    found = head()
    assert (found.verdict, found.holds) == ("free", True)
    assert found.bound is not None
    assert found.least is not None
    assert 0.03 < found.bound <= found.least < 0.15
    assert found.shares[1] == found.shares[3] == found.shares[4] == 0
    assert "home's" in found.text()


def test_poses_within_the_limits_have_the_margin_that_is_proved() -> None:
    """Joints solved by Newton's method: their amounts, and the angles at the rods' ends, from their own motions."""
    found, m = head(), gc.load("reachy-mini-head")
    limits = {f"q{k}": (-105.898 if k in (2, 5) else -83.898, 44.102) for k in range(1, 7)}
    rng = np.random.default_rng(5)
    inside, home = 0, gc.pose(m, nearest=False).points
    for roll, pitch, yaw in rng.uniform(-1, 1, (12, 3)) * (40, 40, 65):
        try:
            here = gc.pose(m, f"roll={roll}deg, pitch={pitch}deg, yaw={yaw}deg", nearest=False)
        except gc.GcrulesError:
            continue
        p = here.points
        turn = _turn(roll, pitch, yaw)
        tilted = []
        for k in range(1, 7):
            rod, before = (np.subtract(q[f"C{k}"], q[f"B{k}"]) for q in (p, home))
            tilted.append(_angle(rod, turn @ before))
            axis = np.array(_axis(k))
            tilted.append(_angle(rod, _about(axis, here.actuator_values[f"q{k}"]) @ before))
        kept = all(a <= math.degrees(here.actuator_values[q]) <= b for q, (a, b) in limits.items())
        status = sign_at(found, (roll, pitch, yaw))
        if kept and max(tilted) <= 40:
            inside += 1
            assert status in "fg"
            assert here.margin >= found.bound
    assert inside >= 2


def _axis(k: int) -> tuple[float, float, float]:
    angle = math.radians({1: -120, 2: -120, 3: 0, 4: 0, 5: 120, 6: 120}[k])
    sign = 1 if k % 2 else -1
    return (sign * math.cos(angle), sign * math.sin(angle), 0.0)


def _about(axis: np.ndarray, angle: float) -> np.ndarray:
    x, y, z = axis
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


def _turn(roll: float, pitch: float, yaw: float) -> np.ndarray:
    x, y, z = np.eye(3)
    r, p, w = np.radians([roll, pitch, yaw])
    return _about(z, w) @ _about(y, p) @ _about(x, r)


def _angle(a: np.ndarray, b: np.ndarray) -> float:
    return math.degrees(math.acos(min(1.0, float(a @ b / np.linalg.norm(a) / np.linalg.norm(b)))))


def test_a_singular_pose_is_found_with_its_cause() -> None:
    found = gc.certify("reachy-mini-head", ["yaw 0:95 deg"], boxes=1000)
    assert (found.verdict, found.holds) == ("singular", False)
    assert found.bad is not None
    assert 90 < found.bad.place[0] < 95
    assert "linear complex" in found.bad.causes[0]
    assert gc.pose("reachy-mini-head", found.bad.at, nearest=False).verdict == "singular"


def test_of_six_legs_a_pose_is_told_as_pose_takes_it() -> None:
    found = gc.certify(OCTAHEDRAL, ["x -100:100", "z -400:0", "roll -5:5 deg"], boxes=1000)
    assert found.verdict == "singular"
    assert found.bad is not None
    here = gc.pose(OCTAHEDRAL, found.bad.at, nearest=False)
    assert here.verdict == "singular"
    assert here.causes == found.bad.causes


@pytest.mark.parametrize(
    ("name", "over", "more"),
    [
        (OCTAHEDRAL, ["x -50:50", "roll -10:10 deg"], {"cone": "60 deg", "tilt": "8 deg"}),
        ("6-rus", ["z -0.1:0.1", "yaw -5:5 deg"], {"limits": "actuators -30..30 deg"}),
        ("6-pus", ["x -0.3:0.3", "roll -5:5 deg"], {"limits": "actuators -2..2"}),
        ("3-rps", ["z -0.2:0.2", "pitch -10:10 deg"], {}),
        ("delta", ["x -0.3:0.3", "z -0.2:0.2"], {}),
        ("agile-eye", ["roll -10:10 deg", "pitch -10:10 deg"], {}),
        ("3-rrr-spherical", ["yaw -5:5 deg"], {}),
    ],
)
def test_small_ranges_are_free(name: str, over: list[str], more: dict[str, str]) -> None:
    found = gc.certify(name, over, boxes=1000, **more)
    assert found.verdict == "free"
    assert found.bound is not None
    assert found.least is not None
    assert 0 < found.bound <= found.least


def test_a_margin_that_is_not_kept_is_found() -> None:
    found = gc.certify(OCTAHEDRAL, ["z -300:0"], margin=0.35, boxes=1000)
    assert (found.verdict, found.holds) == ("below", False)
    assert found.bad is not None
    assert found.bad.margin < 0.35
    assert not found.bad.ends


def test_what_is_left_is_resumed(tmp_path: Path) -> None:
    path = str(tmp_path / "head.json.gz")
    first = gc.certify("reachy-mini-head", HEAD, limits=MOTORS, cone="40 deg", boxes=1)
    assert (first.verdict, first.holds) == ("undecided", None)
    first.save(path)
    again = gc.certify("reachy-mini-head", HEAD, limits=MOTORS, cone="40 deg", boxes=2000, resume=path)
    assert again.decided > 0.5
    again.save(path)
    last = gc.certify("reachy-mini-head", HEAD, limits=MOTORS, cone="40 deg", boxes=2000, resume=path)
    assert last.tree[: len(again.tree)] == again.tree
    with pytest.raises(FileError, match="another question"):
        gc.certify("reachy-mini-head", HEAD, cone="41 deg", boxes=1, resume=path)


def test_a_target_ends_the_search() -> None:
    found = gc.certify("reachy-mini-head", HEAD, limits=MOTORS, target="60%", boxes=100_000)
    assert found.decided >= 0.6
    assert found.holds is (found.verdict in ("undecided", "free"))


def test_a_tilt_is_a_cone_in_any_direction() -> None:
    found = gc.certify(OCTAHEDRAL, ["roll -50:50 deg", "pitch -50:50 deg"], tilt="20 deg", boxes=2000)
    assert math.pi * 20**2 / 100**2 < sum(found.shares[:2]) < 0.5  # boxes on the cone's border are free too
    for place in np.radians(np.random.default_rng(2).uniform(-50, 50, (500, 2))):
        if np.cos(place).prod() > math.cos(math.radians(20)):
            assert sign_at(found, np.degrees(place)) == "f"
    assert sign_at(found, (29.0, 29.0)) == "o"


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"cone": "40"}, "is not a cone"),
        ({"cone": "Z 40 deg"}, "not a ball or universal joint"),
        ({"cone": "0 deg"}, "a cone of 0 deg"),
        ({"tilt": "40"}, "not an angle"),
        ({"target": "0%"}, "target"),
        ({"time": -1.0}, "time"),
        ({"boxes": 0}, "boxes"),
        ({"limits": "q9 1..2"}, "not an actuator"),
    ],
)
def test_what_makes_no_sense_is_refused(options: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        gc.certify("6-pus", ["x -0.1:0.1"], **{"boxes": 1, **options})


def test_files_that_are_no_certificates(tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    for text in ("{}", "[", '{"format": "gcrules certificate 1"}'):
        path.write_text(text)
        with pytest.raises(FileError):
            gc.certify("6-pus", ["x -0.1:0.1"], time=0, resume=str(path))
    with pytest.raises(FileError, match="not a name for a certificate"):
        head().save(str(tmp_path / "x.txt"))
    with pytest.raises(FileError, match="not a name for a certificate"):
        head().save(str(tmp_path / "x.gz"))


def test_pictures_of_certificates(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    start = {"svg": b"<?xml", "pdf": b"%PDF-", "png": b"\x89PNG"}
    outputs = [word for kind in start for word in ("-o", str(tmp_path / f"range.{kind}"))]
    done = invoke("certify", "6-pus", "--over", "x -0.1..0.1", "--over", "yaw -5..5 deg", "--boxes", "100", *outputs)
    assert done.exit_code == 0, done.output
    for kind, head_of_file in start.items():
        assert (tmp_path / f"range.{kind}").read_bytes().startswith(head_of_file)


def test_the_command_tells_by_its_exit_code(tmp_path: Path) -> None:
    path = tmp_path / "c.json"
    free = ["certify", "6-pus", "--over", "x -0.1..0.1", "--boxes", "100", "-o", str(path)]
    assert invoke(*free).exit_code == 0
    assert json.loads(path.read_text())["claim"]["verdict"] == "free"
    assert invoke("certify", "reachy-mini-head", "--over", "yaw 0..95 deg", "--boxes", "1000").exit_code == 1
    left = invoke("certify", "reachy-mini-head", "--over", "roll -40..40 deg", "--boxes", "1", "-o", str(path))
    assert left.exit_code == 3
    assert json.loads(path.read_text())["claim"]["verdict"] == "undecided"
    assert invoke("certify", "6-pus", "--over", "x 1..0").exit_code == 2


def test_the_singular_pose_is_singular_as_it_is_written() -> None:
    """Several turns at once: their sequence is that of `gcrules pose`."""
    over = ["yaw 20..30 deg", "pitch 10..20 deg", "roll -40..-10 deg", "z -600..0"]
    found = gc.certify(OCTAHEDRAL, over, boxes=4000)
    assert found.bad is not None
    assert gc.pose(OCTAHEDRAL, found.bad.at, nearest=False).margin < 1e-9
