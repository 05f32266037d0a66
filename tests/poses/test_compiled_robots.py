"""Robots of joints at arrays of poses, beside `gc.pose` one pose at a time."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from places import DATA

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.kinematics.coordinates import principal
from gcrules.mechanisms.kinematics.rigid_motions import rotations
from gcrules.poses.compiling.compiled import CompiledCondition
from gcrules.poses.compiling.compiled_limbs import CompiledLimbs

IDS = [one.id for one in robots()]
OF_FILES = ("2rps-2ups",)
SIX = ("gough-stewart", "gough-stewart-63", "octahedral")
WHOLE = "x, y, z, roll, pitch, yaw"


@cache
def of(name: str, coordinates: str | None = None) -> CompiledLimbs:
    source = DATA / "robots" / f"{name}.yaml" if name in OF_FILES else name
    found = gc.compiled(source, coordinates=coordinates or (WHOLE if name in SIX else None))
    assert isinstance(found, CompiledLimbs)
    return found


def drawn(value: CompiledLimbs, number: int, reach: float = 0.25, seed: int = 5) -> Any:
    """Poses within a part of the robot's size and as many radians from home."""
    rng, size = np.random.default_rng(seed), value.mechanism.linkage.size
    return rng.uniform(-reach, reach, (number, len(value.coordinates))) * [
        size if n in ("x", "y", "z") else 1.0 for n in value.coordinates
    ]


def one_by_one(value: CompiledLimbs, pose: Any) -> Any:
    """What gc.pose finds there; None where it says that the robot does not assemble."""
    at = dict(zip(value.coordinates, map(float, pose), strict=True))
    try:
        return gc.pose(value.mechanism.analysis, at, nearest=False)
    except InputError:
        return None


@pytest.mark.parametrize("name", [*IDS, *OF_FILES])
def test_numbers_are_those_of_pose(name: str) -> None:
    value = of(name)
    poses = drawn(value, 3)
    asked = "factors, margins, limb_margins, actuators, coordinates, proved"
    found = value.numbers(poses, asked)
    reached = 0
    for k, pose in enumerate(poses):
        expected: Any = one_by_one(value, pose)
        if expected is None:
            assert np.isnan(found["margins"][k])
            assert np.isnan(found["factors"][k]).all()
            assert not found["proved"][k]
            continue
        reached += 1
        live = [f for f in expected.factors if f.live]
        assert value.factors == tuple(f.expression for f in live)
        assert value.kinds == tuple(f.kind for f in live)
        assert found["factors"][k] == pytest.approx([f.value for f in live], abs=1e-10)
        assert found["margins"][k] == pytest.approx(expected.margin, abs=1e-10)
        assert found["limb_margins"][k] == pytest.approx([limb.margin for limb in expected.limbs], abs=1e-10)
        amounts = [amount for _, amount in expected.actuators]
        assert found["actuators"][k] == pytest.approx(amounts, abs=1e-9 * value.mechanism.linkage.size)
        assert found["coordinates"][k] == pytest.approx(list(expected.coordinates.values()), abs=1e-8)
        assert found["proved"][k] <= (expected.assembly.doubt is None)
    assert reached or name in ("3-rrr-spherical", "agile-eye")


def test_the_agile_eye_has_no_singular_surface() -> None:
    """With a, b and c the cosines between u and w of its legs the factor is 1 + 2abc - a² - b² - c² but for sines: of a
    turned triad this is 0 only where one of them is 1 or -1, that is where a leg is folded. Derived here; Bonev2007
    finds six curves."""
    value = of("agile-eye")
    poses = np.random.default_rng(3).uniform(-1, 1, (200, 3)) * [3, 1.5, 3]
    found = value.numbers(poses, "factors, proved")
    x, y, z = (rotations(poses[:, [k]] * np.eye(3)[k]) for k in range(3))
    home = value.mechanism.linkage.home.values
    u, w = (np.array([home[f"{letter}{k}"] for k in "123"], float) for letter in "uw")
    a, b, c = cosines = np.einsum("kd,nde,ke->kn", u, z @ y @ x, w)
    expected = (1 + 2 * a * b * c - a**2 - b**2 - c**2) / np.sqrt(1 - cosines**2).prod(axis=0)
    assert (expected > 0).all()
    assert found["proved"].mean() > 0.9
    factor = found["factors"][found["proved"].astype(bool), 0]
    assert np.abs(factor) == pytest.approx(expected[found["proved"].astype(bool)], abs=1e-8)
    assert len(set(np.sign(factor))) == 1


@pytest.mark.parametrize("name", ["delta", "3-rps", "3-prs", "exechon"])
def test_back_from_actuators(name: str) -> None:
    """The numbers over the actuators, at the amounts that poses have: two roads to one configuration."""
    value = of(name)
    poses = drawn(value, 5, reach=0.03)
    there = value.numbers(poses, "actuators, coordinates, margins, factors")
    names = [a.name for a in value.actuators]
    driven = of(name, ", ".join(names))
    back = driven.numbers(there["actuators"], "actuators, coordinates, margins, factors")
    assert np.isfinite(there["margins"]).all()
    for n, array in there.items():
        assert back[n] == pytest.approx(array, abs=1e-8), n
    turned = of(name, ", ".join(reversed(names)))  # in the order in which they are named
    assert turned.margins(there["actuators"][:, ::-1]) == pytest.approx(there["margins"], abs=1e-10)
    assert turned.actuator_values(there["actuators"][:, ::-1]) == pytest.approx(there["actuators"], abs=1e-8)


OPEN = {
    *(
        "2-upr-rpu",
        "3-pprs",
        "4-ups-sp",
        "5-rpur",
        "5r",
        "capaman",
        "exechon",
        "gallardo-4dof",
        "tricept",
        "trivariant",
    ),
    *("gantry-tau", "h4", "omni-wrist-iii", "par4"),
}
"""The robots of which nothing has a closed form of the kinds that are known."""
WITHOUT_ACTUATORS = {"3-uru", "3-crr", "3-cpu"}
"""Those of which the actuators have none."""


@pytest.mark.parametrize("name", [*IDS, *OF_FILES])
def test_closed_forms_are_what_joints_give(name: str) -> None:
    """Two roads: programs, and Newton's method; where the second one leads somewhere, far from home too."""
    value = of(name)
    programs = (value.programs.factors, value.programs.wrenches, value.programs.actuators)
    assert [p is None for p in programs] == [name in OPEN, name in OPEN, name in OPEN | WITHOUT_ACTUATORS]
    if programs[-1] is None:
        return
    poses = np.concatenate([drawn(value, 20), drawn(value, 20, reach=0.03, seed=6)])
    solved = value.numbers(poses, "factors, margins, actuators, proved")
    kept = solved["proved"]
    assert kept.sum() > 10
    turns = np.array([a.angle for a in value.actuators])
    fast = replace(value, engine="numpy")
    assert fast(poses)[kept] == pytest.approx(solved["factors"][kept], abs=1e-10)
    assert fast.margins(poses)[kept] == pytest.approx(solved["margins"][kept], abs=1e-10)
    off = fast.actuator_values(poses)[kept] - solved["actuators"][kept]
    off = np.where(turns, principal(off), off / value.mechanism.linkage.size)
    assert np.abs(off).max() < 1e-10


@pytest.mark.parametrize("name", ["delta", "3-rps", "6-rus"])
def test_engines_give_equal_values(name: str) -> None:
    pytest.importorskip("numba")
    value = of(name)
    poses = drawn(value, 3000, reach=1.0)
    for of_poses in (CompiledLimbs.__call__, CompiledLimbs.margins, CompiledLimbs.actuator_values):
        one, other = (of_poses(replace(value, engine=engine), poses) for engine in ("numpy", "numba"))
        assert np.array_equal(one, other, equal_nan=True)
        assert np.isfinite(one).any()


def test_turns_beyond_half_a_turn() -> None:
    """The same poses, whatever turns are added to their angles."""
    value = of("3-rrr-spherical")
    poses = drawn(value, 10, reach=0.05)
    assert value(poses + np.array([2 * np.pi, 0, -4 * np.pi])) == pytest.approx(value(poses), abs=1e-12)
    with pytest.raises(InputError, match="pitch"):
        value(poses + np.array([0, 2 * np.pi, 0]))


def test_signs_change_where_a_path_crosses() -> None:
    value = of("3-rpr")
    path: Any = gc.path("3-rpr", ["home", "x=0, y=0, yaw=60deg"], samples=4)
    (crossing,) = path.crossings
    yaw = np.radians(60) * (crossing.parameter + np.array([-0.05, -0.001, 0.001, 0.05]))
    poses = np.stack([0 * yaw, 0 * yaw, yaw], axis=1)
    assert value.signs(poses).tolist() == [1, 1, -1, -1]
    assert (np.sign(value(poses)[:, 0]) * np.sign(value([0, 0, 0])[0, 0])).tolist() == [1, 1, -1, -1]
    assert value.margins(poses)[1:3].max() < 2e-3


def test_many_are_as_one_by_one() -> None:
    """Blocks, poses that are not reached among others, single rows, none."""
    value = of("3-rrr")
    poses = drawn(value, 600, reach=0.35)
    every = value.numbers(poses, "factors, margins, signs")
    lost = np.isnan(every["margins"])
    assert 0 < lost.sum() < 600
    assert (every["signs"][lost] == 0).all()
    for k in (0, 255, 256, 599, int(np.argmax(lost))):
        assert value(poses[k]) == pytest.approx(every["factors"][k : k + 1], nan_ok=True, abs=1e-12)
        assert value.margins(poses[k : k + 1]) == pytest.approx(every["margins"][k : k + 1], nan_ok=True, abs=1e-12)
    assert value(np.empty((0, 3))).shape == (0, 1)
    assert value.margins(np.empty((0, 3))).shape == (0,)


def test_near_a_boundary_steps_are_halved() -> None:
    """Just inside the reach of an arm, which is found by halving, there is a solution; just outside none."""
    value = of("delta")
    inside, outside = 0.0, 40.0
    while outside - inside > 1e-3:
        middle = (inside + outside) / 2
        solved = np.isfinite(value.margins([[middle, 0, 0]])[0])
        inside, outside = (middle, outside) if solved else (inside, middle)
    assert one_by_one(value, (inside - 1e-2, 0, 0)) is not None
    assert one_by_one(value, (outside + 1e-2, 0, 0)) is None


@pytest.mark.parametrize("name", SIX)
def test_six_legs_are_compiled_as_such(name: str) -> None:
    """Unless coordinates are named; both vanish together."""
    legs = gc.compiled(name, engine="numpy")
    assert isinstance(legs, CompiledCondition)
    value = of(name)
    poses = drawn(value, 40)
    poses[:, 3:] = 0
    ratio = legs(poses[:, :3]) / value(poses)[:, 0]
    assert (np.sign(ratio) == np.sign(ratio[0])).all()


def test_what_it_shows() -> None:
    value = of("delta")
    words = "[d1d2d3A1] (actuation), r2d2A2 /\\ r3d3A3 /\\ r1d1 (constraint); 268 operations a pose, by numpy"
    assert repr(replace(value, engine="numpy")) == f"<CompiledLimbs delta over x, y, z: {words}>"
    assert repr(of("exechon")).endswith("(actuation); by closing the loops>")
    assert value.mode.startswith("home's: of two solutions")
    assert of("exechon").mode.startswith("home's: at each pose the solution to which the straight way")
    assert [a.name for a in value.actuators] == ["q1", "q2", "q3"]
    assert gc.compiled("delta", coordinates=["x", "y", "z"]) == value


@pytest.mark.parametrize(
    ("arguments", "says", "hint"),
    [
        ({"coordinates": "x, y"}, "too few coordinates: 2", "z=0"),
        ({"coordinates": "x, y, roll"}, "do not determine the pose of delta near home", "x, y and z"),
        ({"coordinates": "x, y, w"}, "w", ""),
        ({"coordinates": "x, y, x"}, "named twice", ""),
        ({"coordinates": "q1, q2"}, "only q1 and q2 of the actuators", "q1, q2, q3"),
        ({"coordinates": "q1, q2, z"}, "z", ""),
        ({"expression": "[abcd]"}, "an expression is compiled for platforms on six legs only", "leave it out"),
        ({"engine": "fortran"}, "there is no engine", "numpy"),
    ],
)
def test_what_cannot_be_compiled(arguments: dict[str, Any], says: str, hint: str) -> None:
    with pytest.raises(InputError, match=says) as fault:
        gc.compiled("delta", **arguments)
    assert hint in (fault.value.hint or "")


def test_coordinates_are_for_robots_of_joints() -> None:
    with pytest.raises(InputError, match="coordinates are named for robots of joints only"):
        gc.compiled("platform-6-6", coordinates="x, y, z")
    with pytest.raises(InputError, match="legs alone have no coordinates"):
        gc.compiled("ab bc ca de ef fd", coordinates="x, y, z")


@pytest.mark.parametrize(
    ("poses", "says"),
    [
        ([[0, 0]], r"poses \(x, y, z\) of shape"),
        ([[0, 0, 0], [0, np.nan, 0]], "row 1 is not finite"),
        ([[0, 0, 1e9]], "pose 0 is over 200 times the robot's size"),
        ("x=1", "not numbers"),
    ],
)
def test_what_are_no_poses(poses: Any, says: str) -> None:
    with pytest.raises(InputError, match=says):
        of("delta")(poses)


def test_turns_that_no_pose_has() -> None:
    with pytest.raises(InputError, match="pitch has to lie between"):
        of("3-rps")([[0, 0, 2.0]])
    assert np.isfinite(of("3-rps").margins([[0, 0.1, 0.1]])).all()


def test_numbers_that_there_are_not() -> None:
    with pytest.raises(InputError, match="there are no numbers") as fault:
        of("delta").numbers([[0, 0, 0]], "margins, colours")
    assert "factors, margins" in (fault.value.hint or "")
