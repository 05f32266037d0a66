"""`checkers/check_plan.py` sees again that there is no way, and nothing false."""

from __future__ import annotations

import copy
import gzip
import json
import random
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import invoke
from map_certificates import JUNK, leaves, put, signed
from map_certificates import run as run_program
from places import EXAMPLES, ROOT, checker

import gcrules as gc
from gcrules.core.errors import InputError, LimitReached
from gcrules.screws.rotations import rotation

CHECK = checker("check_plan")
OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
ENDS: dict[str, tuple[str, Any, Any]] = {
    "shifted": (OCTAHEDRAL, "home", "0 0 -490"),
    "turned": (OCTAHEDRAL, "0 0 -490; rotvec 10 20 30 deg", "5 0 10; euler zyx 40 10 0 deg"),
    "6-6": (str(EXAMPLES / "platform-6-6.yaml"), "home", "0 0 -3"),
}
TETRAHEDRA = {
    "legs": "Aa Ab Ac Bd Be Cf",
    "points": {
        **{"a": (0, 0, 0), "b": (4, 0, 0), "c": (0, 4, 0), "d": (6, 1, 0), "e": (6, 5, 1), "f": (-5, 3, 1)},
        **{"A": (1, 1, 5), "B": (3, 2, 5), "C": (1, 4, 6)},
    },
}
"""Its condition has three factors."""


@cache
def text(name: str) -> str:
    source, start, goal = ENDS[name]
    return json.dumps(gc.plan(source, start, goal).certificate())


def data(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(text(name))
    return found


def run(file: str | bytes, folder: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    return run_program(file, folder, monkeypatch, "plan.json", program="check_plan")


def determinant(file: dict[str, Any], end: str) -> float:
    """Of the legs at an end, in floats, moments about the base's origin, each row of length 1."""
    points = {n: np.array([float(Fraction(c)) for c in p]) for n, p in file["points"].items()}
    centre, shift = (
        np.array([float(Fraction(c)) for c in v]) for v in (file["centre"], file["poses"][end]["translation"])
    )
    w, x, y, z = (Fraction(c) for c in file["poses"][end]["quaternion"])
    turn = np.array(rotation((w, x, y, z)), dtype=float)
    rows = []
    for a, b in file["legs"]:
        force = turn @ (points[b] - centre) + centre + shift - points[a]
        rows.append(np.concatenate([force, np.cross(points[a], force)]))
    return float(np.linalg.det(np.array([row / np.linalg.norm(row) for row in rows])))


def is_true(file: dict[str, Any]) -> bool:
    signs = [np.sign(determinant(file, end)) for end in ("start", "goal")]
    return signs == [file["signs"]["start"], file["signs"]["goal"]] and signs[0] == -signs[1] != 0


@pytest.mark.parametrize("name", ENDS)
def test_signs_are_computed_again(name: str) -> None:
    words, left = CHECK.checked(data(name))
    assert not left
    assert words.startswith("proved: every way from the start to the goal passes a singular pose")
    assert is_true(data(name))


def test_the_guide_has_what_is_printed() -> None:
    words, _, digest = CHECK.checked(data("shifted"))[0].partition("digest ")
    assert f"{words}digest " in (ROOT / "docs" / "plan.md").read_text(encoding="utf-8")
    assert len(digest) == 64


def test_a_way_there_crosses_a_singular_pose() -> None:
    """Whatever is said, the straight ways between these poses do."""
    for source, start, goal in ENDS.values():
        assert gc.path(source, [start, goal]).zeros


def test_the_command_writes_what_the_program_reads(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "plan.json.gz"
    done = invoke("plan", OCTAHEDRAL, "--from", "home", "--to", "0 0 -490", "--certificate", str(file))
    assert done.exit_code == 1
    assert json.loads(gzip.decompress(file.read_bytes())) == data("shifted")
    assert run(file.read_bytes(), tmp_path, monkeypatch) == 0
    way = tmp_path / "way.json"
    done = invoke("plan", OCTAHEDRAL, "--from", "home", "--to", "0 0 10", "--certificate", str(way))
    assert (done.exit_code, way.exists()) == (0, False)
    assert "is not written, since it is not proved that there is no way" in done.stderr


def test_what_has_no_certificate_is_refused_plainly(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="this plan has no certificate"):
        gc.plan(OCTAHEDRAL, "home", "0 0 10").certificate()
    file = tmp_path / "plan.json"
    ends = ["--from", "home", "--to", "x=0, y=0, yaw=60deg"]
    done = invoke("plan", "3-rpr", *ends, "--certificate", str(file))
    assert (done.exit_code, file.exists()) == (3, False)
    assert "has no certificate: its signs are computed in floats" in done.stderr


def test_two_factors_that_change_their_signs_have_no_certificate() -> None:
    """The determinant is their product, and does not change its own."""
    found = gc.plan(TETRAHEDRA, "home", "0 0 0; rotvec 0 90 0 deg", margin=0.001)
    assert found.outcome == "none"
    assert len(found.opposed) == 2
    with pytest.raises(LimitReached, match="their product has not"):
        found.certificate()


def test_robots_whose_limbs_are_six_legs_have_one() -> None:
    found = gc.plan("gough-stewart", "home", "0 0 -7").certificate()
    assert CHECK.checked(json.loads(json.dumps(found)))[1] == 0


# --- attacks -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ENDS)
def test_files_that_were_changed_prove_nothing_false(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    file, rng = data(name), random.Random(3)
    for path in [p for p in leaves(file) if p]:
        for junk in rng.sample(JUNK, 5):
            new = put(file, path, junk)
            if new == file:
                continue
            assert run(json.dumps(new), tmp_path, monkeypatch) in (1, 2)
            code = run(json.dumps(signed(new)), tmp_path, monkeypatch)
            assert "Traceback" not in capsys.readouterr().out
            assert code in (1, 2) or is_true(new), path


def test_numbers_that_were_changed_prove_nothing_false() -> None:
    file, rng, accepted = data("turned"), random.Random(5), 0
    for path in [p for p in leaves(file) if p and p[0] in ("points", "centre", "poses", "legs")]:
        value: Any = file
        for key in path:
            value = value[key]
        if not isinstance(value, str):
            continue
        for _ in range(4):
            new = put(file, path, rng.choice("abcdef"))
            if path[0] != "legs":
                new = put(file, path, str(Fraction(value) + rng.choice([1, -1, 400, -250, Fraction(1, 7)])))
            try:
                CHECK.checked(signed(new))
            except CHECK.Refused:
                assert path[0] == "legs" or not is_true(new), path
                continue
            accepted += 1
            assert is_true(new), path
    assert accepted > 20


def test_signs_that_are_not_opposite_are_refused() -> None:
    file = data("shifted")
    swapped = copy.deepcopy(file)
    swapped["poses"] = {"start": file["poses"]["goal"], "goal": file["poses"]["start"]}
    same = copy.deepcopy(file)
    same["poses"]["goal"], same["signs"]["goal"] = file["poses"]["start"], file["signs"]["start"]
    for new, words in (
        (swapped, "is not what the file says"),
        (same, "the same sign"),
        (put(file, ("signs", "goal"), file["signs"]["start"]), "is not what the file says"),
        (put(file, ("signs", "goal"), 0), "a sign is 1 or -1"),
        (put(file, ("signs", "goal"), True), "a sign is 1 or -1"),
        (put(file, ("poses", "goal", "translation"), ["0", "0", "-350"]), "is 0 at the goal"),
        (put(file, ("poses", "goal", "quaternion"), ["0"] * 4), "a quaternion that is 0"),
        ({**file, "way": []}, "no certificate"),
        ({**file, "unit": "mm, and more"}, "no unit"),
    ):
        with pytest.raises(CHECK.Refused, match=words):
            CHECK.checked(signed(new))


def test_a_leg_without_a_length_has_no_sign() -> None:
    file = data("shifted")
    file["points"]["b"] = file["points"]["a"]
    with pytest.raises(CHECK.Refused, match="is 0 at the start"):
        CHECK.checked(signed(file))


def test_what_is_no_certificate_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for words in ('{"format":', "[]", "null", "NaN", "1" * 5000, text("shifted").replace(": 1,", ": 1.0,", 1)):
        assert run(words, tmp_path, monkeypatch) == 2
    twice = text("shifted").replace('"signs"', '"signs": {"start": 1, "goal": -1}, "signs"', 1)
    assert run(twice, tmp_path, monkeypatch) == 2


def test_files_have_the_fields_of_the_published_schema() -> None:
    schema = json.loads((ROOT / "docs" / "assets" / "plan-certificate.schema.json").read_text(encoding="utf-8"))
    for name in ENDS:
        file = data(name)
        assert {*schema["required"]} == file.keys() == schema["properties"].keys()
        for part in ("poses", "signs"):
            assert file[part].keys() == schema["properties"][part]["properties"].keys()
