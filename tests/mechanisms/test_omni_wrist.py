"""Omni-Wrist III: a platform that mirrors its base, against reflections and differences."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest

import gcrules as gc
from gcrules.mechanisms.description.relations import relation
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.linkage import linkage
from gcrules.mechanisms.kinematics.margin import margins
from gcrules.mechanisms.kinematics.solve import solve
from gcrules.mechanisms.kinematics.targets import read_pose
from gcrules.screws import RATIONALS, RESIDUES, jacobian


def wrist() -> gc.Robot:
    found = gc.load("omni-wrist-iii")
    assert isinstance(found, gc.Robot)
    return found


def mirror(n: np.ndarray) -> np.ndarray:
    return np.eye(3) - 2 * np.outer(n, n) / (n @ n)


def test_a_mirrored_direction_is_exact() -> None:
    mirrored = relation("direction", "mirror of u in plane normal to A B")
    values = {"u": (1, 2, 3), "A": (0, 0, 0), "B": (1, 1, 0)}
    found = mirrored.value("direction", RATIONALS, values, ())
    assert found == (-4, -2, 6)
    assert not any(mirrored.residual("direction", RATIONALS, values, (-2, -1, 3)))
    assert any(mirrored.residual("direction", RATIONALS, values, (2, 1, 3)))


@pytest.mark.parametrize("pose", ["roll=20deg, pitch=10deg", "roll=-35deg, pitch=15deg", "roll=5deg, pitch=-40deg"])
def test_the_platform_mirrors_the_base(pose: str) -> None:
    """In each pose the platform is at home, seen in the mirror of home and then in that of now."""
    m = linkage(wrist())
    there = solve(m, read_pose(m, pose)).configuration
    at = there.values
    now, home = at["O'"] - at["O"], np.array([0, 0, 2.0])
    assert np.linalg.norm(now) == pytest.approx(2)
    assert there.platform[:3, :3] == pytest.approx(mirror(now) @ mirror(home), abs=1e-9)
    for k in "1234":
        assert np.linalg.norm(at[f"B{k}"]) == pytest.approx(np.sqrt(10 if k in "13" else 17))
        assert (at[f"B{k}"] - now / 2) @ now == pytest.approx(0, abs=1e-9)
        turned = mirror(now) @ at[f"u{k}"]
        assert np.cross(turned, at[f"v{k}"]) == pytest.approx(np.zeros(3), abs=1e-9)


def test_its_motions_are_turns_about_lines_through_the_middle_in_the_mirror() -> None:
    """So at equal speed: what is left by all constraints are turns about lines of the mirror through M."""
    for seed in range(4):
        robot = wrist()
        values = robot.family.member(("wrist", seed))
        rows = [w for one in robot.limbs for w in one.at(values, RESIDUES).constraints(RESIDUES)]
        assert RESIDUES.rank(rows) == 4
        n = tuple(b - a for a, b in zip(values["O"], values["O'"], strict=True))
        for other in ((1, 2, 3), (3, -1, 1)):
            axis = RESIDUES.cross(n, other)
            moment = RESIDUES.cross(values["M"], axis)
            turn = (*moment, *axis)  # f · v + m · ω
            assert all(RESIDUES.dot(w, turn) == 0 for w in rows)


def test_it_is_singular_where_two_driven_legs_lie_in_one_plane() -> None:
    """By ranks of the joint screws, and by the margin near by."""
    robot = wrist()
    near = {**(robot.home or {}), "B2": (-4, 0, 1)}
    values = {n: RESIDUES.vector(v) for n, v in robot.values_at(near).items()}
    rows = [w for one in robot.limbs for w in one.at(values, RESIDUES).locked(RESIDUES)]
    assert RESIDUES.rank(rows) == 5
    assert jacobian(robot.limbs_at()).rank() == 6
    sigma = {}
    for high in (Fraction(1, 10), Fraction(1, 100)):
        m = linkage(replace(robot, home={**(robot.home or {}), "B2": (Fraction(-4), high, Fraction(1))}))
        sigma[high] = margins(m, Configurations.of([m.home])).sigma[0]
    first, second = sigma.values()
    assert 0 < second < 0.002
    assert first / second == pytest.approx(10, rel=0.05)


def test_the_constraints_may_lose_rank_and_the_sentence_says_so() -> None:
    """In the working mode ++-- all wrenches have rank 5 at home, and the factor of the condition is not 0."""
    found = gc.analyze("omni-wrist-iii")
    assert "where the constraints of all limbs together lose rank" in found.statement
    here = gc.pose(gc.load("omni-wrist-iii", mode="++--"), nearest=False)
    assert here.verdict == "singular"
    assert all(abs(f.value) > 0.1 for f in here.factors if f.live)


@pytest.mark.parametrize("name", ["agile-eye", "3-rrr-spherical", "delta", "3-rps"])
def test_where_constraints_cannot_lose_rank_nothing_is_added(name: str) -> None:
    """Each limb alone has all constraints, or none is there twice."""
    assert "lose rank" not in gc.analyze(name).statement
