"""The checker of certificates: what it proves, and that certificates that were changed are refused."""

from __future__ import annotations

import copy
import importlib.util
import json
import math
import random
import re
import sys
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from map_certificates import FALSE_JOINTS, with_false_joints
from places import ROOT

import gcrules as gc

QUESTIONS: dict[str, tuple[str, list[str], dict[str, Any]]] = {
    "6-pus": ("6-pus", ["x -0.2:0.2", "roll -5:5 deg"], {"limits": "actuators -2..2"}),
    "six legs": (str(ROOT / "examples" / "octahedral.yaml"), ["x -50:50", "roll -5:5 deg"], {"cone": "60 deg"}),
    "6-rus": ("6-rus", ["z -0.05:0.05", "yaw -3:3 deg"], {"limits": "actuators -30..30 deg", "tilt": "5 deg"}),
    "singular": ("reachy-mini-head", ["yaw 0:95 deg"], {}),
}
JOINTS: dict[str, tuple[str, list[str], dict[str, Any]]] = {
    "3-rps": ("3-rps", ["z -0.1:0.1", "roll -5:5 deg", "pitch -5:5 deg"], {"tilt": "6 deg"}),
    "delta": ("delta", ["x -0.3:0.3", "y -0.3:0.3"], {"limits": "actuators -20..20 deg"}),
    "3-rrr-spherical": ("3-rrr-spherical", ["roll -5:5 deg", "yaw -5:5 deg"], {}),
    "agile-eye": ("agile-eye", ["roll -5:5 deg", "pitch -3:3 deg"], {}),
    "3-rpr": ("3-rpr", ["x -0.1:0.1", "yaw -5:5 deg"], {"limits": "actuators -2..2"}),
    "singular 3-rpr": ("3-rpr", ["x -0.05:0.05", "yaw 20:80 deg"], {}),
}
"""Robots whose closed forms are compared with their joints."""


@cache
def checker() -> Any:
    sys.path.insert(0, str(ROOT / "checkers"))
    spec = importlib.util.spec_from_file_location("check_certificate", ROOT / "checkers" / "check_certificate.py")
    assert spec is not None
    assert spec.loader is not None
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


@cache
def loaded(source: str) -> Any:
    return gc.load(source)


@cache
def certificate(name: str) -> str:
    source, over, more = (QUESTIONS | JOINTS)[name]
    return json.dumps(gc.certify(source, over, boxes=4000, **more).to_json())


@pytest.mark.parametrize("name", QUESTIONS | JOINTS)
def test_what_is_claimed_is_proved_again(name: str) -> None:
    assert "proved" in checker().checked(json.loads(certificate(name)))


@pytest.mark.parametrize("name", QUESTIONS)
def test_boxes_hold_what_their_poses_have(name: str) -> None:
    """Forces and margins at places of boxes that shrink, those of gcrules among them."""
    c, data, rng = checker(), json.loads(certificate(name)), random.Random(3)
    robot, over = c.robot_of(data), data["question"]["over"]
    units = [math.pi / 180 if r["unit"] == "deg" else 1.0 for r in over]
    low, high = ([float(Fraction(r[end])) * u for r, u in zip(over, units, strict=True)] for end in ("low", "high"))
    proved = 0
    for k in range(12, 36):
        middle = [rng.uniform(a, b) for a, b in zip(low, high, strict=True)]
        half = [(b - a) * 0.5 ** (k / 6 - 1) for a, b in zip(low, high, strict=True)]
        box = c.Box(*([m + s * h for m, h in zip(middle, half, strict=True)] for s in (-1, 1)))
        _, _, forces = robot.look(box)
        for _ in range(8):
            place = [
                rng.uniform(max(a, m - h), min(b, m + h)) for a, b, m, h in zip(low, high, middle, half, strict=True)
            ]
            outside, _, there = robot.look(c.Box(place, place))
            assert not outside
            assert there is not None
            if forces is None:
                continue
            for wide, force in zip(forces, there, strict=True):
                assert all(v.ends()[0] <= x.c <= v.ends()[1] for v, x in zip(wide, force, strict=True))
            _, _, rows = robot.holds(there, 1e-9)
            margin = float(np.linalg.svd(np.array(rows), compute_uv=False)[-1])
            if robot.holds(forces, margin * 1.001)[0]:
                pytest.fail("a box has more than one of its poses has")
            proved += robot.holds(forces, margin / 2)[0]
        if k % 12 == 11:
            assert margin == pytest.approx(_margin(name, data, place), abs=1e-9)
    assert proved > 20


def _margin(name: str, data: dict[str, Any], place: list[float]) -> float:
    """That of `gcrules pose`."""
    at = dict(zip([r["coordinate"] for r in data["question"]["over"]], place, strict=True))
    turns = {n: math.degrees(at.get(n, 0.0)) for n in ("yaw", "pitch", "roll")}
    if name == "six legs":
        text = " ".join(str(at.get(n, 0.0)) for n in "xyz") + "; euler zyx {yaw} {pitch} {roll} deg".format(**turns)
    else:
        text = ", ".join(f"{n}={turns[n]}deg" if n in turns else f"{n}={v}" for n, v in at.items())
    return float(gc.pose(loaded(QUESTIONS[name][0]), text, nearest=False).margin)


def fits(value: Any, schema: dict[str, Any]) -> bool:
    """Whether a value is as a schema says: the words of JSON schema that the one of certificates uses."""
    kinds = {"object": dict, "array": list, "string": str, "number": (int, float), "null": type(None)}
    match value:
        case dict():
            known = schema.get("properties", {})
            more = schema.get("additionalProperties", {})
            inner = set(schema.get("required", ())) <= set(value) and all(
                fits(v, known[k]) if k in known else more is not False and fits(v, more) for k, v in value.items()
            )
        case list():
            size = schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value))
            inner = size and all(fits(v, schema.get("items", {})) for v in value)
        case str():
            inner = re.search(schema.get("pattern", ""), value) is not None
        case _:
            inner = True
    return (
        inner
        and isinstance(value, kinds.get(schema.get("type", ""), object))
        and value in schema.get("enum", [value])
        and value == schema.get("const", value)
        and ("anyOf" not in schema or any(fits(value, s) for s in schema["anyOf"]))
    )


def test_certificates_are_as_the_published_schema_says() -> None:
    schema = json.loads((ROOT / "docs" / "assets" / "certificate.schema.json").read_text())
    for name in QUESTIONS | JOINTS:
        data = json.loads(certificate(name))
        assert fits(data, schema)
        for key in data:
            assert not fits({k: v for k, v in data.items() if k != key}, schema)
        assert not fits({**data, "tree": "f?"}, schema)


def test_the_checker_imports_nothing_of_gcrules() -> None:
    files = sorted((ROOT / "checkers").glob("*certificate*.py"))
    assert len(files) == 7
    for file in files:
        text = file.read_text(encoding="utf-8")
        assert "import gcrules" not in text
        assert "from gcrules" not in text
        assert len(text.splitlines()) <= 400


def changed(data: dict[str, Any], rng: random.Random) -> dict[str, Any]:
    """A certificate that says what is not so."""
    new = copy.deepcopy(data)
    match rng.randrange(6):
        case 0:
            new["tree"] = new["tree"][: rng.randrange(len(new["tree"]))]
        case 1:
            new["tree"] += "f"
        case 2:
            new["claim"]["margin at least"] = new["claim"]["smallest margin seen"] * 1.2
            new["bounds"] = [1.0] * len(new["bounds"])
        case 3:
            new["claim"]["shares"]["outside"] += 0.1
        case 4:
            places = [k for k, sign in enumerate(new["tree"]) if sign == "f"]
            k = rng.choice(places)
            new["tree"] = new["tree"][:k] + "o" + new["tree"][k + 1 :]
        case _:
            new["geometry"]["rods"] = new["geometry"]["rods"][:5]
    return new


@pytest.mark.parametrize("name", ["6-pus", "six legs"])
def test_what_was_changed_is_refused(name: str) -> None:
    rng, data = random.Random(7), json.loads(certificate(name))
    for _ in range(8):
        with pytest.raises((checker().Refused, KeyError, IndexError)):
            checker().checked(changed(data, rng))


def _other_legs(data: dict[str, Any]) -> None:
    """Rods between the robot's points that are none of its legs."""
    rods = data["geometry"]["rods"]
    one, other = rods[0], rods[4]
    for key in ("names", "ends"):
        one[key][1], other[key][1] = other[key][1], one[key][1]
    data["question"]["cones"] = []


def _far_away(data: dict[str, Any]) -> None:
    """Base points whose distances are no floats, so that nothing is above or below anything."""
    data["claim"]["margin at least"] = data["claim"]["smallest margin seen"] = 0.9
    data["bounds"] = [0.9] * len(data["bounds"])
    data["question"]["cones"] = []
    for rod in data["geometry"]["rods"]:
        rod["ends"][0][1] *= 1e200
        data["question"]["robot"]["points"][rod["names"][0]] = [str(Fraction(c)) for c in rod["ends"][0]]


LEGS: dict[str, tuple[Callable[[dict[str, Any]], Any], str]] = {
    "other legs": (_other_legs, "not the robot's legs"),
    "another drive": (
        lambda data: data["geometry"]["rods"][0].update(drive="slide", axis=[0.0, 0.0, 1.0]),
        "not the robot's legs",
    ),
    "endless lengths": (_far_away, "not proved"),
    "lengths in degrees": (lambda data: data["question"]["robot"].update(units="deg"), "another unit"),
    "words in place of a drive": (
        lambda data: data["geometry"]["rods"][0].update(drive="leg\nproved: all"),
        r"leg\\nproved",
    ),
}


@pytest.mark.parametrize(("change", "says"), LEGS.values(), ids=LEGS)
def test_six_legs_that_were_changed_are_refused(change: Callable[[dict[str, Any]], Any], says: str) -> None:
    data = json.loads(certificate("six legs"))
    change(data)
    with pytest.raises(checker().Refused, match=says):
        checker().checked(data)


@pytest.mark.parametrize("change", [lambda rod: rod["ends"][1].__setitem__(0, 1.1), lambda rod: rod["names"].pop()])
def test_rods_are_between_the_points_of_home(change: Callable[[dict[str, Any]], Any]) -> None:
    data = json.loads(certificate("6-pus"))
    change(data["geometry"]["rods"][0])
    with pytest.raises(checker().Refused, match="that of the robot's points"):
        checker().checked(data)


def test_numbers_are_printed_as_they_are_proved() -> None:
    """A part that is left undecided, however small, is not rounded away, nor is a margin rounded up."""
    data = json.loads(certificate("6-pus"))
    tree, least = data["tree"], min(data["bounds"]) - 1.5e-9
    first = tree.index("f")
    data["tree"] = f"{tree[:first]}{'0' * 40}u{'f' * 40}{tree[first + 1 :]}"
    data["bounds"] = [least] * data["tree"].count("f")
    tiny = 0.5 ** (40 + 1)
    assert data["claim"]["shares"]["undecided"] == 0
    data["claim"].update({"verdict": "undecided", "margin at least": least})
    data["claim"]["shares"]["undecided"] = tiny
    found = checker().checked(data)
    assert "in 99.999999 % of the range" in found
    assert f"at least {least} (" in found


def test_what_is_proved_is_printed_with_what_it_is_proved_of() -> None:
    found = checker().checked(json.loads(certificate("six legs")))
    for line in (
        "of six rods: leg ['a', 'b'], leg ['a', 'f'], leg ['c', 'b'],",
        "turned about [16.666666666666668, -33.333333333333336, 366.6666666666667]",
        "over x -50..50 mm, roll -5..5 deg",
        "at y 0.0, z 0.0, pitch 0.0, yaw 0.0",
        "limits: base cone of ['a', 'b'] 1.047",
    ):
        assert f"\n  {line}" in found
    assert "agree with the joints at 108 poses, which does not prove them" in checker().checked(
        json.loads(certificate("delta"))
    )


def test_a_singular_pose_needs_both_signs_within_the_range() -> None:
    data = json.loads(certificate("singular"))
    bad = data["singular pose"]
    for ends in ([bad["opposite signs at"][0]] * 2, [[9.0], [0.0]]):
        with pytest.raises(checker().Refused):
            checker().checked({**data, "singular pose": {**bad, "opposite signs at": ends}})


@pytest.mark.parametrize(
    ("source", "over", "margin"), [("reachy-mini-head", "yaw 0:60 deg", 0.2), ("delta", "x 0:0.3", 0.274)]
)
def test_a_margin_that_is_not_kept_is_seen_again(source: str, over: str, margin: float) -> None:
    data = json.loads(json.dumps(gc.certify(source, [over], margin=margin, boxes=400).to_json()))
    assert data["claim"]["verdict"] == "below"
    assert f"below {margin}" in checker().checked(data)
    bad = data["singular pose"]
    for place in ([0.0], [-1.0]):
        with pytest.raises(checker().Refused):
            checker().checked({**data, "singular pose": {**bad, "place": place}})


def test_robots_without_a_checker_are_told() -> None:
    with pytest.raises(checker().Refused, match="no independent checker yet"):
        checker().checked({**json.loads(certificate("delta")), "geometry": None})


@pytest.mark.parametrize("name", JOINTS)
def test_margins_of_joints_are_those_of_their_poses(name: str) -> None:
    """At places of the range as `gcrules pose` has them; and boxes around them hold less than their middles."""
    c, data, rng = checker(), json.loads(certificate(name)), random.Random(5)
    robot, over = c.robot_of(data), data["question"]["over"]
    units = [math.pi / 180 if r["unit"] == "deg" else 1.0 for r in over]
    low, high = ([float(Fraction(r[end])) * u for r, u in zip(over, units, strict=True)] for end in ("low", "high"))
    for _ in range(4):
        place = [rng.uniform(a, b) for a, b in zip(low, high, strict=True)]
        _, _, lines = robot.look(c.Box(place, place))
        assert lines is not None
        margin = float(np.linalg.svd(np.array(robot.holds(lines, 0.0)[2]), compute_uv=False)[-1])
        here = dict(zip([r["coordinate"] for r in over], place, strict=True)) | data["question"]["rest"]
        text = ", ".join(f"{n}={v}{'rad' if n in ('roll', 'pitch', 'yaw') else ''}" for n, v in here.items())
        assert min(margin, 1.0) == pytest.approx(gc.pose(loaded(JOINTS[name][0]), text, nearest=False).margin, abs=1e-9)
        assert robot.holds(lines, margin * 0.999)[0] or margin < 1e-3
        for half in (0.02, 0.005, 0.001):
            _, _, wide = robot.look(c.Box([x - half for x in place], [x + half for x in place]))
            if wide is not None:
                assert not robot.holds(wide, margin * 1.001)[0]


def _constant(data: dict[str, Any], program: str, place: int) -> None:
    lines = [line for line in data["geometry"][program]["lines"] if line[0] == "scale"]
    lines[place % len(lines)][-1] = str(Fraction(lines[place % len(lines)][-1]) + Fraction(1, 7))


def _screw(data: dict[str, Any], limb: int) -> None:
    data["geometry"]["limbs"][limb]["screws"][1][4] += 0.1


def _elsewhere(data: dict[str, Any]) -> None:
    """The first wrench has another sign in one entry where x > 1/5: by the root of a square, which is no line there."""
    program = data["geometry"]["wrenches"]
    lines, n = program["lines"], len(program["lines"])
    lines += [["input", 0], ["shift", n, "-1/5"], ["mul", n + 1, n + 1], ["sqrt", n + 2], ["inv", n + 1]]
    lines += [["mul", n + 3, n + 4], ["scale", n + 5, "-1"], ["mul", program["results"][0], n + 6]]
    program["results"][0] = n + 7


def _nowhere(data: dict[str, Any], *, needed: bool) -> None:
    """A root that exists where x < 1/5 alone, so that poses beyond seem to be reached nowhere."""
    program = data["geometry"]["wrenches"]
    lines, n = program["lines"], len(program["lines"])
    lines += [["input", 0], ["scale", n, "-1"], ["shift", n + 1, "1/5"], ["sqrt", n + 2], ["scale", n + 3, "0"]]
    if needed:
        lines.append(["add", program["results"][0], n + 4])
        program["results"][0] = n + 5


def _nearly_dependent(data: dict[str, Any]) -> None:
    """The second wrench is the first one and a little of the second one, so little that what is added of another limb's
    seems to have no power.
    """
    program = data["geometry"]["wrenches"]
    lines, results = program["lines"], program["results"]

    def line(*parts: Any) -> int:
        lines.append([*parts])
        return len(lines) - 1

    zero = line("scale", next(r for r in results if isinstance(r, int)), "0")
    first, second, other = (
        [r if isinstance(r, int) else line("shift", zero, r) for r in results[k : k + 6]] for k in (0, 6, 18)
    )
    for k, (a, b, c) in enumerate(zip(first, second, other, strict=True)):
        little = line("add", line("scale", b, "1/100000"), line("scale", c, "1/1000000000"))
        results[6 + k] = line("add", a, little)


def test_of_wrenches_that_nearly_depend_none_has_power_on_the_joints() -> None:
    data = json.loads(certificate("delta"))
    _nearly_dependent(data)
    with pytest.raises(checker().Refused, match="power on the undriven joints"):
        checker().checked(data)


CHANGES: dict[str, Callable[[dict[str, Any]], Any]] = {
    "a wrench": lambda data: _constant(data, "wrenches", 2),
    "another wrench": lambda data: _constant(data, "wrenches", 5),
    "an actuator": lambda data: _constant(data, "amounts", 1),
    "a joint": lambda data: _screw(data, 1),
    "how many wrenches": lambda data: data["geometry"]["limbs"][0].update(wrenches=1),
    "what is driven": lambda data: data["geometry"]["actuators"].pop(),
    "the margin": lambda data: (data["claim"].update({"margin at least": 0.9}), data.update(bounds=[0.9])),
    "a wrench far from home": _elsewhere,
    "a root that nothing needs": lambda data: _nowhere(data, needed=False),
    "a root that is needed": lambda data: _nowhere(data, needed=True),
    "an operation": lambda data: data["geometry"]["wrenches"]["lines"][3].__setitem__(0, "tan"),
}


@pytest.mark.parametrize("change", CHANGES)
def test_joints_that_were_changed_are_refused(change: str) -> None:
    data = json.loads(certificate("delta"))
    CHANGES[change](data)
    with pytest.raises((checker().Refused, KeyError, IndexError)):
        checker().checked(data)


@pytest.mark.parametrize("name", FALSE_JOINTS)
def test_joints_that_the_closed_forms_do_not_hold_are_refused(name: str) -> None:
    with pytest.raises(checker().Refused, match=FALSE_JOINTS[name][1]):
        checker().checked(with_false_joints(json.loads(certificate("3-rpr")), name))


def test_closed_forms_hold_no_closer_than_they_are_known() -> None:
    """Forces that are parallel but for less than closed forms may differ from the joints prove nothing."""
    robot = checker().robot_of(json.loads(certificate("3-rpr")))
    _, _, lines = robot.look(checker().Box([0.0, 0.0], [0.0, 0.0]))
    for far, fine in ((1e-9, False), (1e-3, True)):
        near = [[a * (1 - far) + b * far for a, b in zip(lines[0], line, strict=True)] for line in lines]
        assert robot.holds(near, 0.0)[0] == fine


def test_lengths_are_in_the_unit_of_a_file_of_joints(tmp_path: Path) -> None:
    file = tmp_path / "robot.yaml"
    file.write_text(f"units: mm\n{(ROOT / 'plugins' / '6-rus' / 'robot.yaml').read_text('utf-8')}", "utf-8")
    found = json.loads(json.dumps(gc.certify(file, ["z -0.05..0.05 mm"], boxes=100).to_json()))
    assert found["question"]["over"][0]["unit"] == "mm"
    assert "100 %" in checker().checked(found)
    found["question"]["over"][0]["unit"] = "m"
    with pytest.raises(checker().Refused, match="another unit"):
        checker().checked(found)
