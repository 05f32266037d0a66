"""Dimensions made exact: decimals of a model give the robot that was meant, by how much joints were moved is told, and
what contradicts itself is left.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from mechanisms.models.hand_made import delta, perturbed

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.models.exact import Wish, fitted
from gcrules.mechanisms.models.importing import import_model
from gcrules.mechanisms.models.of_robot import model_of
from gcrules.mechanisms.models.projecting import Relation, Shape, projected

AMOUNT = 1e-5
LEFT = ("8-cables", "omni-wrist-iii")  # cables; axes that meet in two places, of which one is looked at
SHIPPED = tuple(one.id for one in robots() if one.id not in LEFT)


@pytest.mark.parametrize("name", SHIPPED)
def test_shipped_robots_come_back_from_decimals(name: str) -> None:
    """The family is that of the exact model, and all joints are within the tolerance of those that were read."""
    own = model_of(read_robot(name))
    noisy, exact = import_model(perturbed(own, AMOUNT)), import_model(own)
    if name != "par4":  # whose arms stand in a square, which is more than it needs
        assert noisy.robot.family == exact.robot.family
    assert noisy.robot.chain == exact.robot.chain
    assert noisy.robot.mobility == exact.robot.mobility
    distance, angle = noisy.farthest
    assert distance + angle > 0
    assert distance < 1e-4 * noisy.size
    assert angle < 1e-4
    assert not exact.exact


@pytest.mark.parametrize("elbow", ["ball", "cross", "turns"])
def test_rods_of_a_delta_are_parallel_again(elbow: str) -> None:
    found = import_model(delta(1e-5, elbow))
    assert found.robot.chain == "3-R*4S"
    assert "3 pairs of equal bars" in found.exact
    assert elbow != "ball" or "symmetry: turns by 120° about z" in found.exact
    assert "symmetry: a mirror perpendicular to y" in found.exact
    assert any(note.startswith("4S are bars that stay parallel, as they do in the 4 ") for note in found.notes)
    assert "C%: on line B% along r%" in found.yaml
    home = {n: np.array([float(c) for c in v]) for n, v in found.robot.values_at().items()}
    arms = [np.linalg.norm(np.cross(home[f"B{k}"] - home[f"A{k}"], home[f"r{k}"])) for k in (1, 2, 3)]
    rods = [np.linalg.norm(home[f"d{k}"]) for k in (1, 2, 3)]
    assert np.allclose(rods, np.hypot(0.34, 0.5), atol=1e-4)
    assert np.ptp(arms) < 1e-10
    assert np.ptp(rods) < 1e-10


@pytest.mark.parametrize("amount", [0.0, 1e-5])
def test_rods_with_crosses_are_a_parallelogram_between_hinges(amount: float) -> None:
    found = import_model(delta(amount, "crosses"))
    assert found.robot.chain == "3-R*RPaR"
    assert found.robot.mobility == 3
    assert "n%: perpendicular to r%, B% C%" in found.yaml
    assert ("3 pairs of equal bars" in found.exact) == (amount > 0)
    assert any(note.startswith("Pa are bars that stay parallel") for note in found.notes)


def test_crosses_that_do_not_turn_together_stay_crosses() -> None:
    """Those of one arm stand off one line, so that it is no parallelogram between hinges."""
    own = delta(0.0, "crosses")
    up = {"elbow01_e0", "wrist01"}
    joints = [replace(j, at=(j.at[0], j.at[1], j.at[2] + 0.02)) if j.name in up else j for j in own.joints]
    found = import_model(replace(own, joints=tuple(joints)), actuators=("motor0", "motor1", "motor2"))
    assert "UU | UU" in found.robot.chain


@pytest.mark.parametrize("elbow", ["ball", "crosses"])
def test_a_delta_with_decimals_has_a_certificate(elbow: str) -> None:
    """As one has that comes with gcrules."""
    found = import_model(delta(1e-5, elbow))
    sure = gc.certify(found.robot, over=["x -0.01..0.01", "y -0.01..0.01"], boxes=64)
    assert sure.verdict == "free"
    assert sure.bound is not None
    assert sure.bound > 0.1


def test_rods_of_two_lengths_stay_two_rods() -> None:
    """Each of its length, beyond the tolerance."""
    own = delta()
    joints = [replace(j, at=(j.at[0], j.at[1], j.at[2] + 0.01)) if j.name == "wrist01" else j for j in own.joints]
    found = import_model(replace(own, joints=tuple(joints)))
    assert "SS | SS" in found.robot.chain
    assert not any("bars" in said for said in found.exact)


def test_the_tolerance_is_that_of_the_caller() -> None:
    coarse = delta(1e-4)
    assert "SS | SS" in import_model(coarse, tolerance=1e-6).robot.chain
    assert import_model(coarse, tolerance=1e-3).robot.chain == "3-R*4S"


def test_lengths_of_rods_are_equal_again() -> None:
    """Of a head whose horns and rods are of 40 and 85 mm."""
    found = import_model(perturbed(model_of(read_robot("reachy-mini-head")), AMOUNT))
    assert any(said.endswith("lengths equal to others") for said in found.exact)
    home = {n: np.array([float(c) for c in v]) for n, v in found.robot.values_at().items()}
    for one, other in ("AB", "BC"):
        lengths = [np.linalg.norm(home[f"{other}{k}"] - home[f"{one}{k}"]) for k in range(1, 7)]
        assert np.ptp(lengths) < 1e-9 * found.size


# --- relations -------------------------------------------------------------------------------------------------------

TURN = (np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]), np.array([0.1, 0.2, 0.0]), -1.0)
KINDS = {
    "dot": Relation("dot", (0, 1), (3,)),
    "cross": Relation("cross", (0, 1), (3,)),
    "coplanar": Relation("coplanar", (0, 1), (3, 4)),
    "right": Relation("right", (), (3, 4)),
    "unit": Relation("unit", (), (3,)),
    "equal vectors": Relation("vectors", (0, 1, 2, 3)),
    "equal vectors across an axis": Relation("vectors", (0, 1, 2, 3), (3,)),
    "equal lengths": Relation("lengths", (0, 1, 2, 3)),
    "equal lengths across axes": Relation("lengths", (0, 1, 2, 3), (3, 4)),
    "image": Relation("image", (0, 1), (), TURN),
    "image on an axis": Relation("image", (0, 1), (3,), TURN),
    "turned": Relation("turned", (), (3, 4), TURN),
}


def shape(seed: int = 0) -> Shape:
    rng = np.random.default_rng(seed)
    axes = rng.normal(size=(2, 3))
    return Shape(rng.normal(size=(4, 3)), np.array([*np.eye(3), *(a / np.linalg.norm(a) for a in axes)]))


@pytest.mark.parametrize("relation", KINDS.values(), ids=KINDS)
def test_rates_are_those_of_differences(relation: Relation) -> None:
    at, step = shape(), 1e-6
    residual, rates = relation.rows(at)
    size = at.places.size + at.directions.size
    rows = np.zeros((len(residual), size))
    for is_direction, k, block in rates:
        start = 3 * (k + 4 * is_direction)
        rows[:, start : start + 3] += block
    for k, unit in enumerate(np.eye(size)):
        change = (relation.residual(at.moved(step * unit)) - relation.residual(at.moved(-step * unit))) / (2 * step)
        assert np.allclose(change, rows[:, k], atol=1e-8)


@pytest.mark.parametrize("relation", KINDS.values(), ids=KINDS)
def test_a_relation_is_made_to_hold(relation: Relation) -> None:
    found = projected(shape(), [relation], 3.0)
    assert found is not None
    assert relation.off(found) < 1e-11
    assert np.allclose(np.linalg.norm(found.directions, axis=1), 1)
    assert (found.directions[:3] == np.eye(3)).all()


def test_what_contradicts_itself_is_not_made() -> None:
    """One place cannot be two; what goes with the rest is made nevertheless."""
    other = (np.eye(3), np.array([0.0, 0.0, 1e-4]), 1.0)
    here = Relation("image", (0, 1), (), (np.eye(3), np.zeros(3), 1.0))
    there, third = Relation("image", (0, 1), (), other), Relation("image", (1, 2), (), other)
    at = Shape(np.zeros((3, 3)), np.eye(3))
    assert projected(at, [here, there], 1e-3) is None
    wishes = [Wish("relation", (there,)), Wish("length", (third,))]
    taken, found = fitted(at, [here], wishes, 1e-3)
    assert taken == [wishes[1]]
    assert np.allclose(found.places[2] - found.places[0], [0, 0, 1e-4])


def test_nothing_is_moved_beyond_the_tolerance() -> None:
    far = Relation("image", (0, 1), (), (np.eye(3), np.array([1.0, 0.0, 0.0]), 1.0))
    assert projected(Shape(np.zeros((2, 3)), np.eye(3)), [far], 0.1) is None


def test_joints_in_one_place_have_no_size() -> None:
    """A spherical robot whose joints all stand in the middle, but for decimals."""
    found = import_model(perturbed(model_of(read_robot("3-rrr-spherical")), 1e-6))
    assert found.robot.chain == "3-R*U"
    with pytest.raises(InputError, match="cannot move"):
        import_model(perturbed(model_of(read_robot("3-rrr-spherical")), 0.05))
