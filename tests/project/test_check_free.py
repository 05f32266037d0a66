"""`checkers/check_free.py` proves free regions again, and no region that holds a singular pose."""

from __future__ import annotations

import copy
import json
import random
import re
import sys
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import invoke
from map_certificates import FALSE_JOINTS, JUNK, leaves, put, signed, with_false_joints
from map_certificates import run as run_program
from places import EXAMPLES, ROOT, checker

import gcrules as gc
from gcrules.core.errors import FileError, LimitReached

CHECK = checker("check_free")
OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
REGIONS: dict[str, tuple[str, dict[str, Any]]] = {
    "shifts": (OCTAHEDRAL, {"over": "x, z"}),
    "turns": (OCTAHEDRAL, {"over": "rx, ry", "ball": True, "at": "0 0 50; rotvec 10 20 30 deg"}),
    "both": (OCTAHEDRAL, {"over": "x 3, z, rz 60 deg", "at": "10 0 -30"}),
    "3-rpr": ("3-rpr", {"over": "x, yaw", "boxes": 100, "at": "x=0.05, y=0.01, yaw=3deg"}),
    "delta": ("delta", {"ball": True, "boxes": 100}),
    "6-rus": ("6-rus", {"over": "z, yaw", "boxes": 100}),
}
LEGS = ("shifts", "turns", "both")
JOINTS = ("3-rpr", "delta", "6-rus")


@cache
def text(name: str) -> str:
    source, more = REGIONS[name]
    return json.dumps(gc.free_region(source, **more).certificate())


def data(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(text(name))
    return found


def run(file: str | bytes, folder: Path, monkeypatch: pytest.MonkeyPatch, *more: str) -> int:
    return run_program(file, folder, monkeypatch, "region.json", program="check_free", more=more)


def over(file: dict[str, Any]) -> list[dict[str, str]]:
    found: list[dict[str, str]] = file["over"] if "over" in file else file["question"]["over"]
    return found


def widened(file: dict[str, Any], by: float) -> dict[str, Any]:
    """With ranges so many times as long."""
    new = copy.deepcopy(file)
    for axis in over(new):
        low, high = Fraction(axis["low"]), Fraction(axis["high"])
        middle, half = (low + high) / 2, (high - low) / 2 * Fraction(by)
        axis["low"], axis["high"] = str(middle - half), str(middle + half)
    return signed(new)


def places_in(file: dict[str, Any], number: int) -> Any:
    """Places of the region at random, from -1 to 1, many of them on its border."""
    rng = np.random.default_rng(5)
    parts = np.clip(rng.uniform(-1.7, 1.7, (number, len(file["over"]))), -1, 1)
    if file["shape"] == "ball":
        parts /= np.maximum(np.linalg.norm(parts, axis=1, keepdims=True), 1.0)
    return parts


def determinants(file: dict[str, Any], number: int = 3000) -> Any:
    """Of the legs at places of the region, by arithmetic of our own."""
    parts = places_in(file, number)
    points = {n: np.array([float(Fraction(c)) for c in p]) for n, p in file["points"].items()}
    centre = np.array([float(Fraction(c)) for c in file["centre"]])
    shift, turn = (np.zeros((number, 3)) for _ in range(2))
    for part, axis in zip(parts.T, file["over"], strict=True):
        low, high = (float(Fraction(axis[end])) for end in ("low", "high"))
        values = (low + high) / 2 + part * (high - low) / 2
        name = axis["coordinate"]
        if name in ("rx", "ry", "rz"):
            turn[:, ("rx", "ry", "rz").index(name)] = np.radians(values) if axis["unit"] == "deg" else values
        else:
            shift[:, "xyz".index(name)] = values
    w, *v = (float(Fraction(c)) for c in file["pose"]["quaternion"])
    first = matrices(np.array([v]), np.array([w]))[0] / (w * w + np.dot(v, v))
    angle = np.linalg.norm(turn, axis=1) / 2
    further = matrices(turn * (np.sinc(angle / np.pi) / 2)[:, None], np.cos(angle))
    ends = np.einsum("nij,jk,lk->nli", further, first, np.array([points[b] - centre for _, b in file["legs"]]))
    ends += centre + shift[:, None] + np.array([float(Fraction(c)) for c in file["pose"]["translation"]])
    base = np.array([points[a] for a, _ in file["legs"]])
    return np.linalg.det(np.concatenate([ends - base, np.cross(base[None], ends - base)], axis=2))


def matrices(v: Any, w: Any) -> Any:
    """The matrices of quaternions (w, v), times the squares of their lengths."""
    x, y, z = v.T
    zero = np.zeros(len(v))
    cross = np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]).transpose(2, 0, 1)
    square = (w * w - (v * v).sum(axis=1))[:, None, None]
    return square * np.eye(3) + 2 * w[:, None, None] * cross + 2 * v[:, :, None] * v[:, None, :]


@pytest.mark.parametrize("name", REGIONS)
def test_regions_are_proved_again(name: str) -> None:
    words, left = CHECK.checked(data(name))
    assert not left
    assert words.startswith(f"proved: no pose of this {data(name)['shape']} is singular (")
    assert "recomputed, not proved in Coq" in words
    if name in LEGS:
        assert len({*np.sign(determinants(data(name))).tolist()}) == 1


@pytest.mark.parametrize("name", LEGS)
def test_matrices_are_those_of_the_poses(name: str) -> None:
    """Up to one number the program's determinants are ours, around the pose and turned further from there."""
    file, region = data(name), CHECK.Legs(data(name))
    ratio = []
    for part, value in zip(places_in(file, 40), determinants(file, 40), strict=True):
        place = [Fraction(float(c)) / 2 + Fraction(1, 2) for c in part]
        rows = region.turned._rows(place, [Fraction(0)] * len(place))
        ratio.append(value / np.linalg.det(np.array([[v.c for v in row] for row in rows])))
    assert np.ptp(ratio) < 1e-9 * abs(ratio[0])


@pytest.mark.parametrize("name", REGIONS)
def test_the_file_has_no_more_than_the_answer(name: str) -> None:
    """Its ranges are rounded to the inside, and as long but for that."""
    source, more = REGIONS[name]
    ranges = gc.free_region(source, **more).ranges
    for axis in over(data(name)):
        by = np.pi / 180 if axis["unit"] == "deg" else 1.0
        low, high = ranges[axis["coordinate"]]
        assert low <= float(Fraction(axis["low"])) * by < float(Fraction(axis["high"])) * by <= high
        assert (high - low) * 0.9999 < float(Fraction(axis["high"]) - Fraction(axis["low"])) * by


@pytest.mark.parametrize("name", REGIONS)
def test_larger_regions_are_not_proved(name: str) -> None:
    """Where the determinant has both signs at corners, or a limb does not reach a part, it is known that they are not
    free.
    """
    file = widened(data(name), {"delta": 200, "3-rpr": 40, "6-rus": 40}.get(name, 3))
    try:
        words, left = CHECK.checked(file, None, 3000)
    except CHECK.Refused:
        return
    assert left
    assert words.startswith("NOT decided here: ")


def test_a_singular_pose_in_a_region_is_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """z from 0 to -350 is free, and -350 is singular."""
    file = json.loads(json.dumps(gc.free_region(OCTAHEDRAL, over="z").certificate()))
    for low, code in (("-350", 3), ("-3499/10", 0), ("-3501/10", 1)):
        new = put(file, ("over", 0, "low"), low)
        assert run(json.dumps(signed(new)), tmp_path, monkeypatch, "--most", "400") == code


def test_the_guide_has_what_is_printed_and_a_box_around_a_ball_is_not_the_ball() -> None:
    found = gc.free_region(OCTAHEDRAL, over="rx, ry, rz", ball=True).certificate()
    words, _, digest = CHECK.checked(found)[0].partition("digest ")
    assert f"{words}digest " in (ROOT / "docs" / "free.md").read_text(encoding="utf-8")
    assert len(digest) == 64
    file = signed({**json.loads(json.dumps(found)), "shape": "box"})
    assert len({*np.sign(determinants(file)).tolist()}) == 2
    try:
        _, left = CHECK.checked(file, None, 2000)
    except CHECK.Refused:
        left = True
    assert left


def test_the_middle_is_on_the_branch_of_home(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(CHECK, "way_exists", lambda robot, pose: False)
    words, left = CHECK.checked(data("3-rpr"))
    assert left
    assert words.startswith("NOT decided here: no way from home to the middle is proved")


def test_the_loops_close_in_the_region(monkeypatch: pytest.MonkeyPatch) -> None:
    reaches = checker("certificate_joints").Joints.reaches
    calls = []

    def found(robot: Any, pose: dict[str, float]) -> bool:
        calls.append(pose)
        return bool(reaches(robot, pose)) and len(calls) < 20

    monkeypatch.setattr(checker("certificate_joints").Joints, "reaches", found)
    with pytest.raises(CHECK.Refused, match="the loops do not close at a place of the region"):
        CHECK.checked(data("3-rpr"))
    assert {*calls[0]} == {"x", "y", "yaw"}


# --- there is no gap -----------------------------------------------------------------------------------------------


class Probe:
    """A region of which a box is proved that is small, and elsewhere by chance."""

    def __init__(self, n: int, seed: int) -> None:
        self.boxes: list[tuple[Any, Any]] = []
        self.axes, self.rng = [None] * n, random.Random(seed)

    def look(self, low: Any, width: Any) -> Any:
        fine = max(width) < Fraction(1, 5) or self.rng.random() < 0.3
        if fine:
            self.boxes.append((low, width))
        return fine, [self.rng.random() for _ in width] if self.rng.random() < 0.5 else None


@pytest.mark.parametrize("ball", [False, True])
@pytest.mark.parametrize("n", [1, 2, 3])
def test_boxes_cover_the_region(n: int, ball: bool) -> None:
    rng = random.Random(n)
    for seed in range(6):
        probe = Probe(n, seed)
        count, place = CHECK.covered(probe, ball, 10_000, None)
        assert place is None
        assert count >= len(probe.boxes)
        for _ in range(200):
            p = [Fraction(rng.randrange(0, 257), 256) for _ in range(n)]
            if ball and sum((c - Fraction(1, 2)) ** 2 for c in p) > Fraction(1, 4):
                continue
            assert any(
                all(a <= c <= a + w for a, w, c in zip(low, width, p, strict=True)) for low, width in probe.boxes
            )


def test_what_is_not_proved_is_told() -> None:
    class Bad(Probe):
        def look(self, low: Any, width: Any) -> Any:
            hole = all(a <= Fraction(1, 3) <= a + w for a, w in zip(low, width, strict=True))
            return not hole, None

    for most, least in ((20, 20), (10_000, 50)):
        count, place = CHECK.covered(Bad(2, 1), False, most, None)
        assert count >= least
        assert place is not None
        assert all(abs(c - Fraction(1, 3)) < Fraction(1, 2) for c in place)


# --- attacks -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["both", "turns", "3-rpr"])
def test_files_that_were_changed_prove_nothing_false(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file, rng = data(name), random.Random(4)
    places = [p for p in leaves(file) if p and p[:2] not in (("question", "robot"), ("question", "about"))]
    for path in rng.sample(places, min(len(places), 50)):
        for junk in rng.sample(JUNK, 3):
            new = put(file, path, junk)
            if new == file:
                continue
            assert run(json.dumps(new), tmp_path, monkeypatch) in (1, 2)
            code = run(json.dumps(signed(new)), tmp_path, monkeypatch, "--most", "500")
            assert "Traceback" not in capsys.readouterr().out
            harmless = path[0] in ("made by", "title", "digest")
            assert code or harmless or is_true(new), path


def is_true(file: dict[str, Any]) -> bool:
    """Whether the determinant has one sign in a region of legs; of joints whether the coordinates are in order."""
    if "legs" in file:
        return len({*np.sign(determinants(file, 500)).tolist()}) == 1
    return all(Fraction(a["low"]) < Fraction(a["high"]) for a in over(file)) and len(over(file)) == 2


def test_numbers_that_were_changed_a_little_prove_nothing_false() -> None:
    """Points, the pose, ranges and legs: what is still proved agrees with determinants at random places."""
    file, rng, accepted = data("both"), random.Random(2), 0
    places = [p for p in leaves(file) if p and p[0] in ("points", "over", "pose", "centre", "legs")]
    for path in rng.sample(places, 24):
        value: Any = file
        for key in path:
            value = value[key]
        if not isinstance(value, str) or path[-1] in ("coordinate", "unit"):
            continue
        new = put(file, path, rng.choice("abcdef"))
        if path[0] != "legs":
            new = put(file, path, str(Fraction(value) + rng.choice([1, -1, 40, -250, Fraction(1, 7)])))
        try:
            _, left = CHECK.checked(signed(new), None, 1000)
        except CHECK.Refused:
            continue
        accepted += not left
        assert left or is_true(new), path
    assert accepted > 3


def test_coordinates_that_are_none_are_refused() -> None:
    file = data("both")
    one = file["over"][0]
    for new in (
        {**file, "over": []},
        {**file, "over": [one, one]},
        {**file, "over": [one] * 7},
        {**file, "over": [{**one, "unit": "deg"}]},
        {**file, "over": [{**one, "high": one["low"]}]},
        {**file, "over": [{**one, "coordinate": "yaw", "unit": "deg"}]},
        {**file, "over": [{**one, "number": 2}]},
        {**file, "over": [{**one, "coordinate": "rx", "unit": "deg", "high": "1000"}]},
        {**file, "shape": "sphere"},
        {**file, "pose": {**file["pose"], "quaternion": ["0"] * 4}},
        {**file, "legs": [*file["legs"][:5], file["legs"][0][::-1]]},
        {k: v for k, v in file.items() if k != "shape"},
    ):
        with pytest.raises(CHECK.Refused):
            CHECK.checked(signed(new))


def test_joints_that_are_others_are_refused() -> None:
    file = data("3-rpr")
    held = copy.deepcopy(file)
    held["geometry"]["limbs"][0]["screws"][1][3] += 0.01
    roots = copy.deepcopy(file)
    roots["geometry"]["roots"] = {"lines": [], "results": []}
    limits = put(file, ("question", "limits"), {"q1": [-1, 1]})
    for new in (held, limits, put(file, ("question", "rest", "y"), None), put(file, ("geometry",), None)):
        with pytest.raises((CHECK.Refused, *checker("map_files").BROKEN)):
            CHECK.checked(signed(new))


@pytest.mark.parametrize("name", FALSE_JOINTS)
def test_joints_that_the_closed_forms_do_not_hold_are_refused(name: str) -> None:
    with pytest.raises(CHECK.Refused, match=FALSE_JOINTS[name][1]):
        CHECK.checked(with_false_joints(data("3-rpr"), name))


# --- the command ---------------------------------------------------------------------------------------------------


def test_the_command_writes_what_the_program_reads(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "a.json"
    done = invoke("free", OCTAHEDRAL, "--over", "x, z", "--certificate", str(file))
    assert done.exit_code == 0
    assert json.loads(file.read_text()) == data("shifts")
    assert run(file.read_bytes(), tmp_path, monkeypatch) == 0
    found = gc.free_region(OCTAHEDRAL, over="x, z")
    found.save_certificate(str(tmp_path / "b.json.gz"))
    assert run((tmp_path / "b.json.gz").read_bytes(), tmp_path, monkeypatch) == 0
    with pytest.raises(FileError, match="not a name for a certificate"):
        found.save_certificate(str(tmp_path / "b.txt"))


def test_robots_by_their_six_legs_have_the_certificate_of_the_platform() -> None:
    found = gc.free_region("gough-stewart", over="x, z").certificate()
    assert found["format"] == CHECK.FORMAT
    assert CHECK.checked(json.loads(json.dumps(found)))[1] == 0


def test_what_has_no_certificate_is_refused_plainly(tmp_path: Path) -> None:
    for robot, words in (
        (("3-rpr", "--over", "actuators"), "a free region over actuators has no certificate"),
        (("par4", "--over", "x"), "a free region of par4 has no certificate: it has loops inside its limbs"),
    ):
        done = invoke("free", *robot, "--boxes", "60", "--certificate", str(tmp_path / "a.json"))
        assert (done.exit_code, words in done.stderr) == (3, True)
        assert not (tmp_path / "a.json").exists()
    with pytest.raises(LimitReached, match="no closed forms of all its limbs are known"):
        gc.free_region("tricept", boxes=60).certificate()


def test_files_have_the_fields_of_the_published_schema() -> None:
    schema = json.loads((ROOT / "docs" / "assets" / "free-certificate.schema.json").read_text(encoding="utf-8"))
    for name in REGIONS:
        legs, joints = schema["oneOf"]
        file, one = data(name), legs if name in LEGS else joints
        assert {*one["required"]} == file.keys() == one["properties"].keys()
        assert file["format"] == one["properties"]["format"]["const"]
        ranges = one["properties"]["over"] if name in LEGS else one["properties"]["question"]["properties"]["over"]
        for axis in over(file):
            assert axis.keys() == ranges["items"]["properties"].keys()
        if name in JOINTS:
            assert file["question"].keys() == one["properties"]["question"]["properties"].keys()


def test_the_programs_are_short_and_stand_alone() -> None:
    beside = {path.stem for path in (ROOT / "checkers").glob("*.py")}
    for name in ("check_free", "check_plan", "map_files"):
        words = (ROOT / "checkers" / f"{name}.py").read_text(encoding="utf-8")
        assert len(words.splitlines()) <= 400
        assert {*re.findall(r"^(?:from|import) (\w+)", words, re.MULTILINE)} - beside <= sys.stdlib_module_names
