"""`checkers/map_actuators.py` recomputes the cells of maps over actuators, and confirms nothing false."""

from __future__ import annotations

import copy
import itertools
import json
import random
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import invoke
from map_certificates import Maps, run, signed, stored, with_junk
from places import ROOT, checker

import gcrules as gc

CHECK, DRIVEN = checker("check_map"), checker("map_actuators")
LOOPS, ENDS = checker("certificate_driven"), checker("certificate_ends")
MAPS: Maps = {
    "6-pus": ("6-pus", ["q1 -0.1:0.1:4", "q2 -0.1:0.1:4"], {}),
    "6-rus": ("6-rus", ["q1 -2:2:4 deg", "q3 -1:3:4 deg"], {"at": "q2=0.5deg"}),
    "3-rpr": ("3-rpr", ["q1 -0.1:0.3:5", "q2 -0.1:0.3:5"], {}),
    "in space": ("3-rpr", ["q1 0.1:0.2:3", "q2 -0.1:0:3", "q3 0:0.1:3"], {}),
    "3-rps": ("3-rps", ["q1 0:0.2:3", "q2 0:0.2:3"], {}),
    "4-rpr": ("4-rpr", ["q1 -0.1:0.1:3", "q2 -0.1:0.1:3"], {}),
    "5r": ("5r", ["q1 -40:-20:3 deg", "q2 -20:0:3 deg"], {}),
    "tricept": ("tricept", ["q1 -0.1:0.1:3", "q2 -0.1:0.1:3"], {}),
}


text, data = stored(MAPS)


@cache
def verdict(name: str) -> tuple[str, int]:
    found: tuple[str, int] = CHECK.checked(data(name))
    return found


def cells_of(file: dict[str, Any]) -> dict[tuple[int, ...], str]:
    shape = [r["number"] - 1 for r in file["question"]["over"]]
    return dict(checker("map_cells").listed_cells(file["cells"], shape, DRIVEN.WORDS))


def all_called(file: dict[str, Any], letter: str) -> dict[str, Any]:
    """With another letter for all cells, counted and signed anew."""

    def changed(cells: Any) -> Any:
        return letter * len(cells) if isinstance(cells, str) else [changed(row) for row in cells]

    new = {**copy.deepcopy(file), "cells": changed(file["cells"])}
    new["claim"] = {w: len(cells_of(file)) if c == letter else 0 for c, w in DRIVEN.WORDS.items()}
    return signed(new)


@pytest.mark.parametrize("name", MAPS)
def test_cells_are_recomputed(name: str) -> None:
    claim = data(name)["claim"]
    assert claim["free"] > 0
    words, left = verdict(name)
    assert left == claim["undecided"], words
    assert words.startswith(f"recomputed: {claim['free']} cells free, 0 crossed, undecided: ")
    assert "recomputed, not proved in Coq" in words
    assert "NOT decided" not in words


def test_the_command_writes_what_the_program_reads(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    over = [part for axis in MAPS["6-pus"][1] for part in ("--over", axis)]
    done = invoke("map", "6-pus", *over, "--certificate", str(tmp_path / "a.json"))
    assert done.exit_code == 0, done.stderr
    assert json.loads((tmp_path / "a.json").read_text()) == data("6-pus")
    assert run((tmp_path / "a.json").read_bytes(), tmp_path, monkeypatch) == 0
    said = capsys.readouterr().out
    assert "recomputed: 9 cells free, 0 crossed, undecided: none" in said
    assert "of six rods: slide ['B1', 'C1']" in said
    assert "over q1 -1/10..1/10 in 3 cells, q2 -1/10..1/10 in 3 cells" in said


def test_robots_whose_loops_no_program_closes_have_no_certificate() -> None:
    for source, says in (
        ("h4", "has loops inside its limbs"),
        ("3-rrr-spherical", "has no certificate: its loops have 12 equations for 6 undriven amounts"),
    ):
        found = gc.singular_map(source, ["q1 -5:5:2 deg", "q2 -5:5:2 deg"])
        with pytest.raises(gc.LimitReached, match=says):
            found.certificate()


# --- another road ---------------------------------------------------------------------------------------------------


class Rpr:
    """The planar 3-RPR robot by the lengths of its legs, which Newton's method holds in short steps from home."""

    base = np.array([[0.0, 0.0], [6.0, 0.0], [3.0, 5.0]])
    ends = np.array([[1.5, 2.0], [4.0, 1.0], [3.0, 3.0]])

    def lines(self, pose: Any) -> tuple[Any, Any]:
        c, s = np.cos(pose[2]), np.sin(pose[2])
        arms = self.ends @ np.array([[c, s], [-s, c]])
        return arms + pose[:2] - self.base, arms

    def jacobian(self, pose: Any) -> Any:
        lines, arms = self.lines(pose)
        units = lines / np.linalg.norm(lines, axis=1)[:, None]
        return np.column_stack([units, arms[:, 0] * units[:, 1] - arms[:, 1] * units[:, 0]])

    def signs(self, way: Any) -> set[float]:
        """Those of the determinant along a way of amounts."""
        pose, home = np.zeros(3), np.linalg.norm(self.ends - self.base, axis=1)
        found = set()
        for amounts in way:
            for _ in range(20):
                rest = np.linalg.norm(self.lines(pose)[0], axis=1) - home - amounts
                pose = pose - np.linalg.solve(self.jacobian(pose), rest)
            assert np.abs(np.linalg.norm(self.lines(pose)[0], axis=1) - home - amounts).max() < 1e-12
            found.add(float(np.sign(np.linalg.det(self.jacobian(pose)))))
        return found


def test_in_free_cells_the_determinant_keeps_the_sign_of_home() -> None:
    file, rng = data("3-rpr"), np.random.default_rng(3)
    robot = Rpr()
    home = robot.signs(np.zeros((1, 3)))
    places = [
        np.array([-0.1 + 0.1 * (cell[0] + u), -0.1 + 0.1 * (cell[1] + v), 0.0])
        for cell, letter in cells_of(file).items()
        if letter == "f"
        for u, v in rng.uniform(size=(4, 2))
    ]
    assert len(places) > 20
    for place in places:
        corner = np.array([0.2, 0.2, 0.0])
        way = [*np.linspace(np.zeros(3), corner, 20), *np.linspace(corner, place, 60)]
        assert robot.signs(way) == home


def test_where_a_branch_ends_lies_a_singular_pose() -> None:
    """In steps that become shorter the legs of 3-RPR are led until Newton's method ends, where the determinant is 0."""
    known = DRIVEN.ActuatorSlice(data("3-rpr")).robot
    home, robot = known.place([0.0] * 3, [0.0] * 6), Rpr()
    start = np.linalg.norm(robot.ends - robot.base, axis=1)
    for goal, end in (((-0.8, 0.0, 0.0), 0.2974), ((0.0, -0.8, 0.0), 0.3408)):
        assert ENDS.turns_back(known, home, list(goal))
        short = [c * (end - 0.005) for c in goal]
        assert not ENDS.turns_back(known, home, short)
        robot.signs(np.linspace(np.zeros(3), short, 100))
        z = np.array([0.0, 0.0, 0.0, end])
        for t in np.linspace(0, end - 0.002, 200):
            for _ in range(20):
                rest = np.linalg.norm(robot.lines(z[:3])[0], axis=1) - start - t * np.array(goal)
                z[:3] -= np.linalg.solve(robot.jacobian(z[:3]), rest)

        def gaps(z: Any, goal: Any = goal) -> Any:
            legs = np.linalg.norm(robot.lines(z[:3])[0], axis=1) - start - z[3] * np.array(goal)
            return np.array([*legs, np.linalg.det(robot.jacobian(z[:3]))])

        for _ in range(30):
            slopes = np.array([(gaps(z + h) - gaps(z - h)) / 2e-6 for h in 1e-6 * np.eye(4)]).T
            z = z - np.linalg.solve(slopes, gaps(z))
        assert np.abs(gaps(z)).max() < 1e-9
        assert z[3] == pytest.approx(end, abs=1e-3)


def test_crossed_cells_are_confirmed_only_where_the_branch_ends() -> None:
    """A slice over the end of home's branch: cells on it are seen to be crossed, those beyond it by nobody."""
    file = data("3-rpr")
    file["question"]["over"][0].update(low="-2/5", high="0")
    file["question"]["over"][1].update(low="-1/20", high="1/20", number=2)
    file["cells"] = ["u"] * 4
    words, left = CHECK.checked(all_called(file, "u"))
    assert "undecided: 4 (of which 0 are free and 1 crossed, as is seen here)" in words, words
    assert left == 4
    new = {**file, "cells": ["x", "x", "u", "u"], "claim": claimed(crossed=2, undecided=2)}
    words, left = CHECK.checked(signed(new))
    assert left == 3
    assert "recomputed: 0 cells free, 1 crossed, undecided: 2" in words
    assert "NOT decided here: 1 cells that are called crossed" in words
    words, left = CHECK.checked(all_called(file, "f"))
    assert "NOT decided here" in words
    assert "0 crossed" in words
    assert left in (2, 3)


def claimed(**more: int) -> dict[str, int]:
    return {**dict.fromkeys(DRIVEN.WORDS.values(), 0), **more}


def test_a_way_that_ends_nowhere_has_no_end() -> None:
    robot = DRIVEN.ActuatorSlice(data("6-pus")).robot
    home = robot.place([0.0] * 6, [0.0] * 6)
    assert not ENDS.turns_back(robot, home, [0.1, 0.0, 0.0, 0.0, 0.0, 0.0])
    assert ENDS.turns_back(robot, home, [3.0, 0.0, 0.0, 0.0, 0.0, 0.0])


@pytest.mark.parametrize("name", ["6-pus", "6-rus", "3-rpr", "3-rps", "5r"])
def test_boxes_enclose_what_happens_in_them(name: str) -> None:
    """The equations and their derivatives at places of a box; derivatives are those of differences."""
    robot = DRIVEN.ActuatorSlice(data(name)).robot
    rng, n, m = np.random.default_rng(1), len(robot.names), len(robot.unknown)
    q, x = rng.uniform(-0.05, 0.05, n).tolist(), rng.uniform(-0.1, 0.1, m).tolist()
    none, still = [0.0] * n, [0.0] * m
    ways = [[0.02 * (k == j) for k in range(n)] for j in range(2)]
    slopes, reach = rng.uniform(-0.03, 0.03, (2, m)).tolist(), [0.002] * m
    box = robot.look(q, ways, none, x, slopes, reach)
    for _ in range(10):
        t = rng.uniform(-1, 1, 2)
        place = (np.array(q) + t @ np.array(ways)).tolist()
        near = (np.array(x) + t @ np.array(slopes) + rng.uniform(-0.002, 0.002, m)).tolist()
        found = robot.look(place, [], none, near, [], still)
        pairs = [(found[0], box[0]), *(pair for k in (0, 1) for pair in zip(found[1][k], box[1][k], strict=True))]
        for one, other in pairs:
            for v, w in zip(one, other, strict=True):
                assert abs(v.c - w.c - sum(w.a * t)) <= w.e
        for k, where in ((0, near), (1, place)):
            for j in range(len(where)):
                ends = []
                for step in (1e-6, -1e-6):
                    moved = [c + step * (i == j) for i, c in enumerate(where)]
                    at, beside = (place, moved) if k == 0 else (moved, near)
                    ends.append(robot.look(at, [], none, beside, [], still))
                for one, other, row in zip(ends[0][0], ends[1][0], found[1][k], strict=True):
                    assert row[j].c == pytest.approx((one.c - other.c) / 2e-6, abs=1e-8)


def turned(axis: Any, angle: float) -> Any:
    """The turn about an axis."""
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew


@pytest.mark.parametrize("name", ["6-pus", "6-rus"])
def test_rods_keep_their_lengths(name: str) -> None:
    """At poses that are found the ends of all rods, as their drives and the platform carry them, are as far apart as at
    home, and the rods' wrenches are not singular.
    """
    file = data(name)
    robot, rng = DRIVEN.ActuatorSlice(file).robot, np.random.default_rng(2)
    for _ in range(5):
        q = rng.uniform(-0.1, 0.1, 6).tolist()
        place = robot.place(q, [0.0] * 6)
        *shift, roll, pitch, yaw = place.x
        turn = turned([0, 0, 1], yaw) @ turned([0, 1, 0], pitch) @ turned([1, 0, 0], roll)
        centre, wrenches = np.array(file["geometry"]["centre"]), []
        for rod in file["geometry"]["rods"]:
            start, end = map(np.array, rod["ends"])
            amount = q[robot.names.index(rod["actuator"])]
            if rod["drive"] == "turn":
                through = np.array(rod["through"])
                carried = turned(rod["axis"], amount) @ (start - through) + through
            else:
                carried = start + amount * np.array(rod["axis"]) / np.linalg.norm(rod["axis"])
            far = turn @ (end - centre) + centre + shift
            assert np.linalg.norm(far - carried) == pytest.approx(np.linalg.norm(end - start), abs=1e-10)
            wrenches.append([*(far - carried), *np.cross(far, far - carried)])
        assert np.linalg.matrix_rank(wrenches) == 6


def test_two_branches_are_not_taken_for_one() -> None:
    """Legs of 3-RPR that hold the platform in several poses: no box has the solutions of another one."""
    robot = DRIVEN.ActuatorSlice(data("3-rpr")).robot
    rng, found = random.Random(4), []
    home = robot.place([0.0] * 3, [0.0] * 6)
    for _ in range(200):
        place = robot.place([0.0] * 3, [rng.uniform(-2, 2) for _ in range(6)])
        if place is not None and max(abs(a - b) for a, b in zip(place.x, home.x, strict=True)) > 1e-3:
            found.append(place)
    assert found
    box = robot.known([0.0] * 3, [[0.01, 0.0, 0.0], [0.0, 0.01, 0.0]], home.x)
    assert box.holds(home)
    assert not any(box.holds(place) for place in found)
    assert not box.holds(robot.place([0.02, 0.0, 0.0], home.x))
    assert robot.known([0.0] * 3, [[2.0, 0.0, 0.0]], home.x) is None


# --- forged files ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["6-pus", "3-rpr"])
def test_a_free_cell_that_is_called_crossed_is_refused(name: str) -> None:
    with pytest.raises(CHECK.Refused, match="is called crossed, and it is free"):
        CHECK.checked(all_called(data(name), "x"))


def test_cells_beyond_singular_poses_are_never_confirmed() -> None:
    """Where 3-RPR's legs are too short to hold the platform, or home's branch has ended, no cell is free."""
    file = data("3-rpr")
    file["question"]["over"][0].update(low="-3/2", high="-4/5")
    words, left = CHECK.checked(all_called(file, "f"))
    assert left > 6
    assert "NOT decided here" in words
    file["question"]["over"][0].update(low="-21/10", high="-3/2")
    for letter in "fx":
        words, left = CHECK.checked(all_called(file, letter))
        assert left == 16
        assert "recomputed: 0 cells free, 0 crossed" in words


def _other(change: Callable[[dict[str, Any]], Any], name: str = "3-rpr") -> dict[str, Any]:
    file = data(name)
    change(file)
    return signed(file)


@pytest.mark.parametrize(
    ("name", "change", "says"),
    [
        ("3-rpr", lambda f: f["geometry"]["limbs"][0]["held"].append(2), "as many unknown amounts"),
        ("3-rpr", lambda f: f["geometry"]["limbs"][0]["held"].append(1), "without a joint"),
        ("3-rpr", lambda f: f["geometry"]["actuators"][1].update(f["geometry"]["actuators"][0], name="q2"), "a joint"),
        ("3-rpr", lambda f: f["geometry"]["actuators"][1].update(turns=True), "angle without a unit"),
        ("3-rps", lambda f: f["geometry"]["actuators"][2].update(turns=True), "is said to slide"),
        ("3-rpr", lambda f: f["geometry"]["actuators"].pop(), "other coordinates"),
        ("3-rpr", lambda f: f["geometry"].update(plane=False), "as many unknown amounts"),
        ("3-rps", lambda f: f["geometry"].update(plane=True), "leaves the plane"),
        ("3-rps", lambda f: f["geometry"].update(size=1e9), "not the robot's"),
        ("3-rpr", lambda f: f["geometry"]["limbs"][0]["screws"].__setitem__(2, [0, 0, 1e-9, 2e-9, 0, 0]), "length 1"),
        ("6-pus", lambda f: f["geometry"]["rods"][0]["ends"][1].__setitem__(0, 9.0), "that of the robot's points"),
        ("6-pus", lambda f: f["geometry"]["rods"][0].update(actuator="q7"), "an unknown actuator"),
        ("6-pus", lambda f: f["geometry"]["rods"].pop(0), "an unknown actuator"),
        ("6-pus", lambda f: f["geometry"]["rods"][5].update(drive="leg"), "not those of six rods"),
        ("6-pus", lambda f: f["question"]["rest"].pop("q4"), "other coordinates"),
        ("6-pus", lambda f: f["question"].update(limits={"q1": [0, 1]}), "limits"),
        ("6-pus", lambda f: f.update(cells=f["cells"][:-1]), "cells are missing"),
        ("6-pus", lambda f: f.update(cells=["ooo", *f["cells"][1:]]), "a cell that is none of"),
        ("6-pus", lambda f: f["claim"].update(free=8), "claimed"),
        ("6-pus", lambda f: f["claim"].update(outside=0), "no claim"),
    ],
)
def test_other_robots_and_other_slices_are_refused(name: str, change: Any, says: str) -> None:
    with pytest.raises(CHECK.Refused, match=says):
        CHECK.checked(_other(change, name))


def test_a_robot_with_a_joint_more_is_another_one() -> None:
    """Its loops are not closed by as many equations as there are amounts."""

    def change(file: dict[str, Any]) -> None:
        limb = file["geometry"]["limbs"][0]
        limb["screws"].append([0, 0, 1, 0, 0, 0])
        limb["coordinates"].append(3)
        limb["signs"].append(1.0)

    with pytest.raises(CHECK.Refused, match="as many unknown amounts"):
        CHECK.checked(_other(change))


def test_home_that_is_singular_confirms_nothing() -> None:
    """Slides in place of the hinges at the platform's end: it can turn nowhere, and slides freely."""

    def change(file: dict[str, Any]) -> None:
        for limb in file["geometry"]["limbs"]:
            limb["screws"][2] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0]

    words, left = CHECK.checked(_other(change))
    assert left == len(cells_of(data("3-rpr")))
    assert words.startswith("recomputed: 0 cells free")


def test_half_a_turn_does_not_close_a_loop() -> None:
    """There the equations of the turns hold too, and the program says nothing."""
    robot = DRIVEN.ActuatorSlice(data("3-rps")).robot
    x = [3.141592653589793 if at == (1, 0) else 0.0 for at in robot.unknown]
    assert robot.look([0.0] * 3, [], [0.0] * 3, x, [], [0.0] * len(x)) is None


UNREAD = {"robot", "about", "actuators", "actuator", "end", "names"}
"""What cells do not depend on: the words by which robots are known, and the ends of limbs."""


@pytest.mark.parametrize("name", ["6-pus", "4-rpr"])
def test_files_that_were_changed_are_refused_or_say_the_same(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With the old digest every change is seen; with a new one nothing ends in a trace."""
    for path, code in with_junk(data(name), 30, tmp_path, monkeypatch):
        assert "Traceback" not in capsys.readouterr().out
        assert code in (1, 2, 3) or UNREAD & {*path}, path


def test_files_have_the_fields_of_the_published_schema() -> None:
    schema = json.loads((ROOT / "docs" / "assets" / "map-certificate-joints.schema.json").read_text(encoding="utf-8"))
    for name in MAPS:
        file = data(name)
        assert file["format"] in schema["properties"]["format"]["enum"]
        for value, one in [(file, schema), *((file[k], schema["properties"][k]) for k in ("question", "claim"))]:
            assert {*one["required"]} <= value.keys() <= one["properties"].keys()
        axis = schema["properties"]["question"]["properties"]["over"]["items"]
        assert all(part.keys() == axis["properties"].keys() for part in file["question"]["over"])
        assert file["geometry"].keys() <= schema["properties"]["geometry"]["properties"].keys()


def test_programs_do_not_load_gcrules() -> None:
    for module in (DRIVEN, LOOPS, ENDS):
        words = Path(module.__file__).read_text(encoding="utf-8").split("\n")
        assert not any(line.startswith(("import", "from")) and "gcrules" in line for line in words)
    assert {*itertools.chain.from_iterable(cells_of(data(name)).values() for name in MAPS)} <= {*"fu"}
