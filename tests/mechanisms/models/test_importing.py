"""Models as robot files: the robots that come with gcrules by way of models, models made by hand, and refusals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from mechanisms.models.hand_made import X, Y, Z, around, chain_of, delta, hexapod, model

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.load import read_robot
from gcrules.mechanisms.models.graph import graph_of
from gcrules.mechanisms.models.importing import import_model
from gcrules.mechanisms.models.model import Model, ModelCoupling, ModelJoint
from gcrules.mechanisms.models.motions import motions_of
from gcrules.mechanisms.models.moving import Moving, span
from gcrules.mechanisms.models.of_robot import model_of
from gcrules.mechanisms.robot import Robot


@pytest.mark.parametrize("name", ["3-rps", "3-upu", "3-rrr", "delta", "orthoglide"])
def test_the_condition_is_that_of_the_robot(name: str) -> None:
    """Kinds of factors, and what they say but for names."""
    robot = read_robot(name)
    found = import_model(model_of(robot)).robot
    one, other = (analyze_robot(r) for r in (robot, found))
    assert [p.kind for p in one.parts] == [p.kind for p in other.parts]
    assert other.structure.mobility == one.structure.mobility
    assert other.structure.over == one.structure.over


# --- by hand ---------------------------------------------------------------------------------------------------------


def test_a_delta_by_hand() -> None:
    found = import_model(delta())
    assert (found.base, found.platform, found.why) == ("base", "plate", "the link with the most limbs")
    assert found.robot.chain == "3-R*4S"
    assert found.robot.mobility == 3
    assert found.limits == tuple((f"motor{k}", -1.0, 0.5) for k in range(3))
    assert "copies: 3" in found.yaml
    assert found.robot.limits == "actuators -1..0.5 rad"


@pytest.mark.parametrize("kinds", ["three turns", "balls"])
def test_turns_whose_axes_meet_are_one_joint(kinds: str) -> None:
    found = import_model(hexapod(kinds))
    assert found.robot.chain == "6-R*US"
    merged = {kind for limb in found.limbs for kind, _ in limb.merged}
    assert merged == ({"S"} if kinds == "three turns" else set())


def planar(closing: str = "revolute", kept: int = 1) -> Model:
    """Three arms in the plane of x and z; all but `kept` of them end in a joint of this kind that closes a loop."""
    joints = []
    for k, (foot, elbow, tip) in enumerate(
        [((0, 0), (1, 3), (4, 3)), ((10, 0), (9, 3), (6, 3)), ((5, 9), (7, 8), (5, 5))]
    ):
        places = [(float(a), 2.0 + 0.1 * n, float(b)) for n, (a, b) in enumerate((foot, elbow, tip))]
        own = chain_of([(f"j{n}", "revolute", at, (Y,)) for n, at in enumerate(places)], ("base", "plate"), f"leg{k}")
        if k >= kept:
            own[-1] = replace(own[-1], kind=closing, axes=own[-1].axes if closing == "revolute" else (), closing=True)
        joints += own
    return model(joints, tuple(f"leg{k}_j0" for k in range(3)))


def test_a_planar_robot_in_another_plane() -> None:
    """The plane of x and z; robot files have that of x and y."""
    found = import_model(planar())
    assert found.robot.family.plane
    assert found.robot.chain == "3-R*RR"
    assert any("turned" in note for note in found.notes)


def test_balls_that_close_loops_in_a_plane_are_hinges() -> None:
    """The platform has the twists that it has with hinges, as the joints of the model say."""
    with_hinges, with_balls = planar(), planar("ball")
    found = import_model(with_balls)
    assert found.robot.family == import_model(with_hinges).robot.family
    assert found.robot.chain == "3-R*RR"
    assert "2 ball joints are taken as hinges: the other joints hold all bodies in one plane" in found.notes
    twists = []
    for own in (with_hinges, with_balls):
        graph = graph_of(own)
        moving = Moving(motions_of(graph, {j.name for j in own.joints}, ()), "base", size=10.0)
        twists.append(moving.twists("plate", moving.home))
    assert len(twists[0]) == len(twists[1]) == len(span(np.concatenate(twists), 1e-9)) == 3


def test_balls_that_hold_the_plane_themselves_are_no_hinges() -> None:
    """At all three corners of the platform they are what keeps it from tilting."""
    found = import_model(planar("ball", kept=0))
    assert found.robot.chain == "3-R*RS"
    assert not any("hinge" in note for note in found.notes)


def four_bar() -> list[ModelJoint]:
    places = [(0.0, 0.0, 0.0), (0.0, 0.2, 0.0), (0.5, 0.4, 0.0), (0.4, 0.0, 0.0)]
    links = ["base", "crank", "coupler", "rocker", "base"]
    return [ModelJoint(f"j{k}", "revolute", links[k], links[k + 1], at, (Z,)) for k, at in enumerate(places)]


def test_a_four_bar_linkage_asks_for_its_platform() -> None:
    with pytest.raises(InputError, match="which link is the platform") as fault:
        import_model(model(four_bar(), ("j0",)))
    assert "--platform" in (fault.value.hint or "")
    found = import_model(model(four_bar(), ("j0",)), platform="coupler")
    assert found.robot.mobility == 1
    assert found.robot.chain in ("R*R + RR", "RR + R*R")


def humanoid() -> Model:
    """A hip, and two feet, each on a cross and two rods that cranks drive."""
    joints = [ModelJoint("float", "free", "base", "pelvis", (0.0, 0.0, 1.0))]
    for side, y in (("left", 0.1), ("right", -0.1)):
        joints += [
            ModelJoint(f"{side}_hip", "revolute", "pelvis", f"{side}_thigh", (0.0, y, 0.9), (Y,)),
            ModelJoint(f"{side}_knee", "revolute", f"{side}_thigh", f"{side}_shank", (0.0, y, 0.5), (Y,)),
            ModelJoint(f"{side}_ankle", "universal", f"{side}_shank", f"{side}_foot", (0.0, y, 0.1), (X, Y)),
        ]
        for k, off in enumerate((-0.04, 0.04)):
            crank, rod, foot = f"{side}_crank{k}", f"{side}_rod{k}", f"{side}_foot"
            motor, top, heel = (0.0, y + off, 0.35), (-0.06, y + off, 0.35), (-0.06, y + off, 0.08)
            joints += [
                ModelJoint(f"{side}_motor{k}", "revolute", f"{side}_shank", crank, motor, (Y,)),
                ModelJoint(f"{side}_top{k}", "universal", crank, rod, top, (X, Y)),
                ModelJoint(f"{side}_heel{k}", "ball", rod, foot, heel, closing=True),
            ]
    driven = tuple(j.name for j in joints if any(w in j.name for w in ("hip", "knee", "motor")))
    return model(joints, driven)


def test_the_feet_of_a_humanoid_are_offered() -> None:
    with pytest.raises(InputError, match="no platform with limbs") as fault:
        import_model(humanoid())
    assert "--platform left_foot (base left_shank, 3 limbs)" in (fault.value.hint or "")
    found = import_model(humanoid(), platform="left_foot")
    assert (found.base, found.robot.mobility) == ("left_shank", 2)
    assert found.robot.chain == "2-R*US + U"
    assert found.actuated == ("left_motor0", "left_motor1")
    assert "right_hip" in found.left_out


def test_what_hangs_on_a_robot_is_left_out() -> None:
    own = delta()
    gripper = [
        ModelJoint("finger", "revolute", "plate", "finger_link", (0.0, 0.0, -0.5), (X,)),
        ModelJoint("glue", "fixed", "plate", "tool", (0.0, 0.0, -0.6)),
    ]
    holding = replace(own, links=(*own.links, "finger_link", "tool"), joints=(*own.joints, *gripper))
    found = import_model(holding)
    assert found.robot.chain == "3-R*4S"
    assert found.left_out == ("finger",)
    assert import_model(holding, platform="tool").platform == "plate"


def test_decimals_are_made_exact_within_the_tolerance() -> None:
    """Axes and ball joints of a file with five digits; the answer is that of the exact robot."""
    noisy = import_model(hexapod_rounded(5))
    exact = import_model(hexapod())
    assert noisy.robot.family == exact.robot.family
    distance, angle = noisy.farthest
    assert 0 < distance + angle < 1e-4
    assert noisy.deviation < 1e-3
    with pytest.raises(InputError, match="the tolerance"):
        import_model(hexapod(), tolerance=0.5)


def hexapod_rounded(digits: int) -> Model:
    """With errors in the last digit."""
    rng = np.random.default_rng(3)

    def rounded(v: tuple[float, float, float]) -> tuple[float, float, float]:
        x, y, z = (round(float(c + 10.0**-digits * rng.integers(-1, 2)), digits) for c in v)
        return x, y, z

    own = hexapod()
    joints = tuple(replace(j, at=rounded(j.at), axes=tuple(rounded(a) for a in j.axes)) for j in own.joints)
    return replace(own, joints=joints)


def test_screws_and_gears() -> None:
    """A turn and a slide that follows it are H; turns that go against each other are a parallelogram."""
    joints, couplings, driven = [], [], []
    for k in range(3):
        foot, tip = around(k, 0.3, 0.0), around(k, 0.2, 0.4)
        axis = around(k, 1.0, 0.0, turn=np.pi / 2)
        joints += chain_of(
            [("turn", "revolute", foot, (Z,)), ("rise", "prismatic", foot, (Z,)),
             ("hinge", "revolute", foot, (axis,)), ("ball", "ball", tip, ())],
            ("base", "plate"), f"leg{k}",
        )  # fmt: skip
        couplings.append(ModelCoupling(f"leg{k}_rise", f"leg{k}_turn", 0.005))
        driven.append(f"leg{k}_turn")
    found = import_model(model(joints, tuple(driven), couplings=tuple(couplings)))
    assert found.robot.chain == "3-H*RS"
    assert "1/200)" in found.yaml


TREE = [
    ModelJoint("a", "revolute", "base", "one", (0.0, 0.0, 0.0), (Z,)),
    ModelJoint("b", "revolute", "one", "two", (1.0, 0.0, 0.0), (Z,)),
]
BRANCHED = [*TREE, ModelJoint("c", "revolute", "one", "three", (1.0, 1.0, 0.0), (Z,))]


def long_chains() -> Model:
    """Two chains of 201 hinges."""
    ends = ("base", "plate")
    places = [[(float(k), float(n), 0.0) for k in range(201)] for n in (0, 1)]
    joints = [
        j
        for n, own in enumerate(places)
        for j in chain_of([(f"j{k}", "revolute", at, (Z,)) for k, at in enumerate(own)], ends, f"leg{n}")
    ]
    return model(joints)


@pytest.mark.parametrize(
    ("made", "options", "message"),
    [
        (long_chains, {"platform": "plate"}, "402 joints are between base and plate; more than 400 are not read"),
        (lambda: model(TREE, ("a", "b")), {}, "the links are one open chain"),
        (lambda: model(BRANCHED), {}, "a tree with 2 ends"),
        (lambda: model(TREE), {"platform": "two"}, "the model has no loops"),
        (delta, {"platform": "plat"}, "there is no link 'plat' to be the platform"),
        (delta, {"base": "floor"}, "there is no link 'floor' to be the base"),
        (delta, {"platform": "base"}, "is the base itself"),
        (delta, {"actuators": ("moto0",)}, "there is no joint 'moto0' to be driven"),
        (delta, {"actuators": ("motor0",)}, "the platform plate has mobility 3, and 1 joint is driven in the model"),
        (delta, {"actuators": ("elbow00_e0",)}, "is a ball joint, and cannot be driven"),
        (lambda: replace(delta(), actuated=()), {}, r"0 joints are driven in the model \(none\)"),
        (
            lambda: replace(delta(), couplings=(ModelCoupling("motor0", "motor1", 1.0),)),
            {"actuators": ("motor0", "motor1", "motor2")},
            "of another limb",
        ),
    ],
)  # fmt: skip
def test_refusals(made: object, options: dict[str, object], message: str) -> None:
    with pytest.raises(gc.GcrulesError, match=message):
        import_model(made(), **options)


def test_what_is_asked_for_is_named() -> None:
    with pytest.raises(InputError) as fault:
        import_model(replace(delta(), actuated=()))
    assert fault.value.hint == "name what is driven: --actuators motor0,motor1,motor2"


def test_an_import_is_a_value() -> None:
    one, other = import_model(delta()), import_model(delta())
    assert one == other
    assert hash(one) == hash(other)
    assert isinstance(one.robot, Robot)
    assert one.to_json()["platform"] == "plate"
    assert "3-R*4S" not in one.latex()
    assert "plate, the link with the most limbs; mobility 3" in one.text()
