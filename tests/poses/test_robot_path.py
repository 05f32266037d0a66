"""Paths of robots of joints: what is said to be proved, against factors of the condition and dense samples."""

import contextlib
import csv
import io
import itertools
import json
import random
from functools import cache

import numpy as np
import pytest

import gcrules as gc
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.limbs.path_report import RobotPath
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import ANGLES

KNOWN = {
    # from home along one coordinate: the parameter of the first singular place, found by `gc.singular`
    "3-rpr": ("x=0, y=0, yaw=60deg", 1),
    "3-rps": ("z=-0.3, roll=0deg, pitch=60deg", 1),
}
RANDOM = ("3-prs", "3-prps", "3-rpr", "3-rps", "3-ups-s", "3-upu", "delta", "orthoglide", "tricept")
STEPS = 80


@cache
def robot(name: str) -> Limbs:
    found = mechanism(name)
    assert isinstance(found, Limbs)
    return found


def along(name: str, *poses: object, samples: int = 20) -> RobotPath:
    found = gc.path(robot(name).analysis, ["home", *poses], samples=samples)
    assert isinstance(found, RobotPath)
    return found


def some_pose(name: str, rng: random.Random) -> dict[str, float]:
    m = robot(name).linkage
    return {n: rng.uniform(-1, 1) * (0.8 if n in ANGLES else 0.4 * m.size) for n in free_coordinates(m)}


@pytest.mark.parametrize("name", KNOWN)
def test_the_first_crossing_is_that_of_the_search(name: str) -> None:
    text, number = KNOWN[name]
    found = along(name, text)
    assert len(found.crossings) == number
    first = gc.singular(robot(name).analysis, text)
    assert first is not None
    crossing = found.crossings[0]
    assert crossing.lower <= crossing.parameter <= crossing.upper
    assert crossing.first <= crossing.lower
    assert crossing.upper <= crossing.last
    for n, value in zip(found.names, crossing.coordinates, strict=True):
        assert value == pytest.approx(first.coordinates[n], abs=1e-6)
    assert set(crossing.causes) == {c.partition(" (")[0][:1].lower() + c[1:].rpartition(" (")[0] for c in first.causes}


@pytest.mark.parametrize(("name", "seed"), [*itertools.product(RANDOM, range(2))])
def test_crossings_are_the_changes_of_sign_of_the_condition(name: str, seed: int) -> None:
    """Two roads: the determinant of the joint screws' wrenches, and the factors of the condition in points."""
    rng = random.Random(f"{name} {seed}")
    found = None
    while found is None:  # until one assembles
        with contextlib.suppress(InputError):
            found = along(name, some_pose(name, rng), samples=STEPS)
    live = [k for k, p in enumerate(robot(name).analysis.parts) if p.kind not in ("never", "choice", "limb")]
    signs = np.sign(np.prod(found.factor_values[:, live], axis=1))
    assert found.undecided == ()
    assert found.branch_doubt is None
    changes = []
    kept = [k for k in range(len(signs)) if found.verdicts[k] != "singular"]
    for a, b in itertools.pairwise(kept):
        inside = [c for c in found.crossings if found.parameters[a] < c.parameter < found.parameters[b]]
        assert (signs[a] != signs[b]) == (len(inside) % 2 == 1)
        changes += inside
    assert changes == list(found.crossings)
    assert found.verdict == ("singular" if changes else "regular") or not changes
    apart = [min([abs(p - c.parameter) for c in changes], default=1.0) for p in found.parameters.tolist()]
    assert all(m > 0 for m, d in zip(found.margins, apart, strict=True) if d > 1e-9)


def test_a_path_through_whole_poses_and_home() -> None:
    way = along("6-rus", "0 0 0.05; euler zyx 4 3 0 deg", Pose((0.02, 0.0, 0.05)))
    assert way.branch_doubt is None
    assert way.names == ("x", "y", "z", "rx", "ry", "rz")
    assert np.abs(way.coordinates[0]).max() < 1e-12
    assert way.coordinates[-1] == pytest.approx([0.02, 0, 0.05, 0, 0, 0], abs=1e-9)
    here = gc.pose("6-rus", Pose((0.02, 0.0, 0.05)), nearest=False)
    assert way.actuator_values[-1] == pytest.approx(list(here.actuator_values.values()), abs=1e-9)


def test_there_and_back_ends_where_it_began() -> None:
    way = along("3-rps", "z=0.1, roll=10deg, pitch=-5deg", "pitch=0deg, roll=0deg, z=0")
    assert way.actuator_values[-1] == pytest.approx(way.actuator_values[0], abs=1e-9)
    assert way.verdict == "regular"


def test_six_legs_take_the_exact_road() -> None:
    """A robot of joints whose limbs are six legs has its superbracket as a polynomial."""
    assert not isinstance(gc.path("gough-stewart", ["0 0 0", "0 0 0.1"], samples=2), RobotPath)


FAULTS = {
    "one pose": (["home"], "two poses or more"),
    "other coordinates": (["z=0.1, roll=0deg, pitch=0deg", "x=0.1, roll=0deg, pitch=0deg"], "pose 1 gives x"),
    "too few": (["home", "z=0.1"], "too few coordinates"),
    "no pose": (["home", "z=a"], "expected a number"),
    "no number of samples": (["home", "z=0.1, roll=0deg, pitch=0deg"], "samples"),
}


@pytest.mark.parametrize(("poses", "words"), FAULTS.values(), ids=FAULTS)
def test_faults(poses: list[str], words: str) -> None:
    with pytest.raises(InputError, match=words):
        gc.path("3-rps", poses, samples=0 if words == "samples" else 10)


def test_out_of_reach() -> None:
    with pytest.raises(InputError, match="between pose 0 and pose 1: delta was not followed from home to"):
        gc.path("delta", ["home", "x=0.1, y=0, z=0", "x=9, y=0, z=0"][::2])


def test_too_many_samples() -> None:
    with pytest.raises(LimitReached, match="samples"):
        gc.path("3-rps", ["home", "z=0.1, roll=0deg, pitch=0deg"], samples=1_000_000)


def test_forms() -> None:
    found = along("3-rpr", KNOWN["3-rpr"][0])
    assert "crosses a singular configuration at parameter 0.295" in found.text()
    assert found.text().isascii()
    assert "A1B1, A2B2 and A3B3 meet" in found.text()
    assert r"\begin{tabular}" in found.latex()
    answer = json.loads(json.dumps(found.to_json()))
    assert answer["verdict"] == "singular"
    assert answer["crossings"][0]["parameter"] == found.crossings[0].parameter
    rows = list(csv.reader(io.StringIO(found.csv())))
    assert len(rows) == len(found) + 1
    assert {len(row) for row in rows} == {len(rows[0])}
    assert [row[-1] for row in rows].count("singular") == 1
    drawn = found.plot().svg()
    assert "least margin of the limbs" in drawn
    assert "crosses" in drawn


def test_two_crossings_of_one_unproved_stretch_are_told_apart() -> None:
    """Zeros of the determinant at 1.162075, 1.454425 and 1.953735, by 200,000 samples of a determinant of one's own."""
    r = gc.path("3-rpr", ["home", "x=-0.413, y=0.755, yaw=0.46rad", "x=-1.056, y=1.495, yaw=1.171rad"], samples=100)
    assert isinstance(r, RobotPath)
    for zero in (1.162075, 1.454425, 1.953735):
        told = [c for c in r.crossings if c.first <= zero <= c.last + 1e-5]
        assert told or any(a <= zero <= b for a, b in r.undecided)
    for c in r.crossings:
        assert sum(c.first <= other.parameter <= c.last for other in r.crossings) == 1
    assert "nowhere else" not in r.reason or not r.undecided
