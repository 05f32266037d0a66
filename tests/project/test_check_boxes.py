"""`checkers/check_boxes.py` proves the boxes of maps of whole ranges again, and nothing false."""

from __future__ import annotations

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
from gcrules.core.errors import LimitReached
from gcrules.poses.boxes import certificate

CHECK = checker("check_boxes")
OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
MAPS: dict[str, tuple[str, list[str], dict[str, Any]]] = {
    "shifts": (OCTAHEDRAL, ["x -100:100", "z -500:-100"], {"tiles": 3, "boxes": 63}),
    "limits": (OCTAHEDRAL, ["z -100:100", "yaw -20:20 deg"], {"tiles": 2, "boxes": 31, "limits": "legs 250..450"}),
    "margin": (OCTAHEDRAL, ["z -340:0", "roll -15:15 deg"], {"tiles": 1, "boxes": 127, "margin": 0.05}),
    "3-rpr": ("3-rpr", ["x -0.5:0.5", "yaw -60:80 deg"], {"tiles": 2, "boxes": 63, "limits": "actuators -0.6..0.6"}),
    "6-rus": ("6-rus", ["z -0.2:0.2"], {"tiles": 5, "boxes": 15}),
}


@cache
def text(name: str) -> str:
    source, over, more = MAPS[name]
    return json.dumps(gc.box_map(source, over, **more).certificate())


def data(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(text(name))
    return found


def run(file: str | bytes, folder: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    return run_program(file, folder, monkeypatch, "boxes.json", program="check_boxes")


def resigned(file: dict[str, Any]) -> dict[str, Any]:
    """With the shares of its trees, and signed anew."""
    share = dict.fromkeys("fgoxu", Fraction(0))
    for tree, tile in zip(file["trees"], CHECK.Tiles(file["question"]), strict=True):
        list(CHECK.leaves_of(tree, tile, share))
    shares = {CHECK.SHARES[k]: float(part / len(file["trees"])) for k, part in share.items()}
    return signed({**file, "shares": shares})


def with_letter(file: dict[str, Any], old: str, new: str, rng: random.Random) -> dict[str, Any]:
    """With another letter for one of the boxes that are called so."""
    places = [(k, n) for k, tree in enumerate(file["trees"]) for n, letter in enumerate(tree) if letter == old]
    k, n = rng.choice(places)
    trees = list(file["trees"])
    trees[k] = f"{trees[k][:n]}{new}{trees[k][n + 1 :]}"
    return resigned({**file, "trees": trees})


@pytest.mark.parametrize("name", MAPS)
def test_boxes_are_proved_again(name: str) -> None:
    words, left = CHECK.checked(data(name))
    letters = "".join(data(name)["trees"])
    assert words.startswith("proved again: ")
    assert "recomputed, not proved in Coq" in words
    assert left <= letters.count("u") + letters.count("x") // 4


def test_the_guide_has_what_is_printed() -> None:
    words, _, digest = CHECK.checked(data("3-rpr"))[0].partition("digest ")
    assert f"{words}digest " in (ROOT / "docs" / "boxes.md").read_text(encoding="utf-8")
    assert len(digest) == 64


def test_all_kinds_of_boxes_are_there() -> None:
    assert {*"fgoxu"} <= {*"".join(letter for name in MAPS for letter in "".join(data(name)["trees"]))}


@pytest.mark.parametrize("name", MAPS)
def test_trees_are_those_of_the_map(name: str) -> None:
    """At places at random the file says what the map says."""
    source, over, more = MAPS[name]
    found, rng = gc.box_map(source, over, **more), np.random.default_rng(2)
    tiles = CHECK.Tiles(data(name)["question"])
    leaves_found = [
        (low, high, letter)
        for tree, tile in zip(data(name)["trees"], tiles, strict=True)
        for _, letter, low, high in CHECK.leaves_of(tree, tile, dict.fromkeys("fgoxu", 0))
    ]
    names = {"f": "free", "g": "free", "o": "outside", "x": "crossed", "u": "undecided"}
    for place in rng.uniform(
        [float(a.start) for a in found.axes], [float(a.stop) for a in found.axes], (60, len(over))
    ):
        at = place * found.task.units
        letters = [
            letter
            for low, high, letter in leaves_found
            if all(a <= c <= b for a, c, b in zip(low, at, high, strict=True))
        ]
        assert [names[letter] for letter in letters] == [found.status(place.tolist())]


@pytest.mark.parametrize("name", FALSE_JOINTS)
def test_joints_that_the_closed_forms_do_not_hold_are_refused(name: str) -> None:
    with pytest.raises(CHECK.Refused, match=FALSE_JOINTS[name][1]):
        CHECK.checked(with_false_joints(data("3-rpr"), name))


def determinants(places: Any) -> Any:
    """Of the octahedral platform shifted by x and z, at places (N, 2), by arithmetic of our own."""
    file = gc.load(OCTAHEDRAL)
    points = {n: np.array([float(c) for c in p]) for n, p in file.points.items()}
    legs = [(a, b) if a in "ace" else (b, a) for a, b in file.legs]
    base, end = (np.array([points[leg[k]] for leg in legs]) for k in (0, 1))
    force = end + (places @ np.array([[1, 0, 0], [0, 0, 1]]))[:, None] - base
    return np.linalg.det(np.concatenate([force, np.cross(base[None], force)], axis=2))


def test_free_boxes_have_one_sign_and_crossed_ones_both() -> None:
    seen, rng = {"f": 0, "x": 0}, np.random.default_rng(1)
    robot = CHECK.robot_of(data("shifts"))
    for tree, tile in zip(data("shifts")["trees"], CHECK.Tiles(data("shifts")["question"]), strict=True):
        for _, letter, low, high in CHECK.leaves_of(tree, tile, dict.fromkeys("fgoxu", 0)):
            corners = np.array([[x, z] for x in (low[0], high[0]) for z in (low[1], high[1])])
            signs = {*np.sign(determinants(rng.uniform(low, high, (200, 2)))).tolist()}
            if letter in "fg":
                assert len(signs) == 1
                seen["f"] += 1
            elif letter == "x" and seen["x"] < 20:
                signs |= {*np.sign(determinants(corners)).tolist()}
                assert len(signs) == 2 or not CHECK.crossed(robot, CHECK.Box(low, high), 0)
                seen["x"] += len(signs) == 2
    assert min(seen.values()) > 3


# --- attacks -------------------------------------------------------------------------------------------------------


CHANGES = "shifts x f", "shifts f x", "limits o x", "3-rpr x f", "3-rpr f o", "3-rpr g x"


@pytest.mark.parametrize(("name", "old", "new"), [change.split() for change in CHANGES], ids=CHANGES)
def test_another_letter_of_a_box_is_never_confirmed(name: str, old: str, new: str) -> None:
    """What is not proved is counted: then the exit code is not 0, whatever else is proved."""
    file, rng = data(name), random.Random(1)
    before = CHECK.checked(file)[1]
    words, left = CHECK.checked(with_letter(file, old, new, rng))
    assert left == before + 1
    assert f"boxes that are called {CHECK.SHARES[new]}; nothing speaks against it" in words


def test_boxes_are_crossed_only_where_poses_are_seen_to_be_reached() -> None:
    file = data("3-rpr")
    before, crossed = CHECK.checked(file)[1], "".join(file["trees"]).count("x")
    del file["geometry"]["roots"]
    assert CHECK.checked(signed(file))[1] == before + crossed > before


def test_a_margin_that_is_not_kept_is_not_confirmed() -> None:
    file = data("shifts")
    before, (words, left) = CHECK.checked(file)[1], CHECK.checked(signed(put(file, ("question", "margin"), 0.9)))
    assert left > before
    assert "NOT decided here" in words


def test_trees_that_are_missing_or_longer_are_refused() -> None:
    file = data("shifts")
    for new in (
        put(file, ("trees",), file["trees"][:-1]),
        put(file, ("trees",), [*file["trees"], "f"]),
        put(file, ("trees", 0), file["trees"][0] + "f"),
        put(file, ("trees", 0), "0f"),
        put(file, ("trees", 0), "5ff"),
        put(file, ("trees", 0), "q"),
        put(file, ("trees", 0), ""),
        put(file, ("question", "over", 0, "tiles"), 4),
        put(file, ("question", "over", 0, "tiles"), True),
        put(file, ("question", "over", 0, "high"), "-100"),
        put(file, ("question", "over", 1, "unit"), "deg"),
        put(file, ("question", "over"), []),
        put(file, ("shares", "free"), file["shares"]["free"] + 0.01),
        put(file, ("question", "margin"), -1),
        put(file, ("question", "tilt"), 0.1),
        put(file, ("geometry",), None),
        {**file, "more": 1},
    ):
        with pytest.raises(CHECK.Refused):
            CHECK.checked(signed(new))


@pytest.mark.parametrize("name", ["limits", "6-rus"])
def test_files_that_were_changed_are_refused_or_say_the_same(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file, rng = data(name), random.Random(6)
    others = {"made by", "title", "digest", "actuator", "robot", "about", "rest"}  # unread, or another range
    places = [p for p in leaves(file) if p]
    for path in rng.sample(places, min(len(places), 25)):
        new = put(file, path, rng.choice(JUNK))
        if new == file:
            continue
        assert run(json.dumps(new), tmp_path, monkeypatch) in (1, 2)
        code = run(json.dumps(signed(new)), tmp_path, monkeypatch)
        said = capsys.readouterr().out
        assert "Traceback" not in said
        assert code in (1, 2, 3) or others & {*map(str, path)}, path


def test_numbers_that_are_none_and_names_that_are_twice_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for old, new in (
        ('"tiles": 5', '"tiles": NaN'),
        ('"tiles": 5', '"tiles": 5, "tiles": 5'),
        ('"tiles": 5', '"tiles": 1e999'),
    ):
        assert old in text("6-rus")
        assert run(text("6-rus").replace(old, new, 1), tmp_path, monkeypatch) == 2


def test_a_spectral_radius_is_bounded_from_above() -> None:
    bounds, rng = checker("certificate_bounds"), np.random.default_rng(4)
    for _ in range(100):
        even = rng.random((6, 6))
        for a in (even, even ** rng.integers(1, 9) * 10.0 ** rng.integers(-3, 3, (6, 1))):
            true = float(np.abs(np.linalg.eigvals(a)).max())
            assert true * (1 - 1e-9) <= bounds.radius(a.tolist()) < (true * 1.3 if a is even else np.inf)
    for bad in (np.nan, np.inf, -1.0):
        a = np.zeros((6, 6))
        a[3, 2] = bad
        assert bounds.radius(a.tolist()) == np.inf


# --- the command ---------------------------------------------------------------------------------------------------


def test_the_command_writes_what_the_program_reads(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "a.json"
    over = ["--over", "z -0.2:0.2", "--tiles", "5", "--boxes", "15", "--certificate", str(file)]
    assert invoke("map", "boxes", "6-rus", *over).exit_code == 0
    assert json.loads(file.read_text()) == data("6-rus")
    assert run(file.read_bytes(), tmp_path, monkeypatch) in (0, 3)
    found = gc.box_map("6-rus", ["z -0.2:0.2"], tiles=5, boxes=15)
    found.save_certificate(str(tmp_path / "b.json.gz"))
    assert run((tmp_path / "b.json.gz").read_bytes(), tmp_path, monkeypatch) in (0, 3)


def test_what_has_no_certificate_is_refused_plainly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    over = ["--over", "z -0.2:0.2", "--certificate", str(tmp_path / "a.json")]
    done = invoke("map", "boxes", "6-rus", *over, "-o", str(tmp_path / "a.zarr"), "--part", "1/2")
    assert (done.exit_code, "--certificate is of a whole map" in done.stderr) == (2, True)
    found = gc.box_map("6-rus", ["z -0.2:0.2"], tiles=5, boxes=15)
    monkeypatch.setattr(certificate, "MAX_BOXES", 70)
    with pytest.raises(LimitReached, match="at most 70 boxes"):
        found.certificate()
    monkeypatch.setattr(certificate, "geometry", lambda m, names: None)
    monkeypatch.setattr(certificate, "MAX_BOXES", 75)
    with pytest.raises(LimitReached, match="loops inside its limbs, or no closed forms"):
        found.certificate()


def test_files_have_the_fields_of_the_published_schema() -> None:
    schema = json.loads((ROOT / "docs" / "assets" / "boxes-certificate.schema.json").read_text(encoding="utf-8"))
    for name in MAPS:
        file = data(name)
        for value, one in [(file, schema), *((file[k], schema["properties"][k]) for k in ("question", "shares"))]:
            assert {*one["required"]} == value.keys() == one["properties"].keys()
        for axis in file["question"]["over"]:
            assert axis.keys() == schema["properties"]["question"]["properties"]["over"]["items"]["properties"].keys()


def test_the_program_is_short_and_stands_alone() -> None:
    beside = {path.stem for path in (ROOT / "checkers").glob("*.py")}
    words = (ROOT / "checkers" / "check_boxes.py").read_text(encoding="utf-8")
    assert len(words.splitlines()) <= 400
    assert {*re.findall(r"^(?:from|import) (\w+)", words, re.MULTILINE)} - beside <= sys.stdlib_module_names
