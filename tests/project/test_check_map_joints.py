"""`checkers/map_joints.py` recomputes the cells of maps of robots of joints, and confirms nothing false."""

from __future__ import annotations

import copy
import itertools
import json
import math
import random
from collections.abc import Callable
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import invoke
from map_certificates import FALSE_JOINTS, Maps, leaves, put, run, signed, stored, with_false_joints, with_junk
from places import ROOT, checker

import gcrules as gc

CHECK, JOINTS = checker("check_map"), checker("map_joints")
MAPS: Maps = {
    "3-rpr": ("3-rpr", ["x -0.5:0.5:4", "yaw 0:60:5 deg"], {"at": "y=0.01"}),
    "in space": ("3-rpr", ["x -0.2:0.2:3", "y -0.2:0.2:3", "yaw -5:55:4 deg"], {}),
    "3-rps": ("3-rps", ["roll -60:-20:5 deg", "pitch -30:0:4 deg"], {}),
    "delta": ("delta", ["x -2.4:0.8:9", "y -0.2:0.2:2"], {}),
    "3-rrr": ("3-rrr", ["x -0.04:0.04:5", "yaw -8:4:4 deg"], {}),
    "6-rus": ("6-rus", ["yaw -12:12:4 deg", "z -0.1:0.1:3"], {}),
    "3-rrr-spherical": ("3-rrr-spherical", ["roll -20:10:4 deg", "yaw -10:10:3 deg"], {}),
}


text, data = stored(MAPS)


@cache
def seen(name: str) -> Any:
    """What the program sees of a slice."""
    return JOINTS.Cells(JOINTS.JointSlice(data(name)))


def with_letters(file: dict[str, Any], cells: Any) -> dict[str, Any]:
    """With other cells, counted and signed anew."""
    new = {**copy.deepcopy(file), "cells": cells}
    letters = "".join(itertools.chain.from_iterable(flat(cells)))
    new["claim"] = {w: letters.count(c) for c, w in JOINTS.WORDS.items()}
    return signed(new)


def flat(cells: Any) -> list[str]:
    return [cells] if isinstance(cells, str) else [row for part in cells for row in flat(part)]


def changed(cells: Any, place: tuple[int, ...], letter: str) -> Any:
    k, *rest = place
    if isinstance(cells, str):
        return cells[:k] + letter + cells[k + 1 :]
    return [changed(row, tuple(rest), letter) if n == k else row for n, row in enumerate(cells)]


def cells_of(file: dict[str, Any]) -> list[tuple[tuple[int, ...], str]]:
    shape = [r["number"] - 1 for r in file["question"]["over"]]
    return list(checker("map_cells").listed_cells(file["cells"], shape, JOINTS.WORDS))


@pytest.mark.parametrize("name", MAPS)
def test_cells_are_recomputed(name: str) -> None:
    words, left = CHECK.checked(data(name))
    claim = data(name)["claim"]
    assert left == claim["undecided"], words
    assert words.startswith(
        f"recomputed: {claim['free']} cells free, {claim['crossed']} crossed, {claim['outside']} outside, undecided: "
    )
    assert "recomputed, not proved in Coq" in words
    assert "NOT decided" not in words


def test_all_kinds_of_cells_are_there() -> None:
    letters = "".join(itertools.chain.from_iterable(flat(data(name)["cells"]) for name in MAPS))
    assert {*letters} == {*"fxuo"}
    assert all(letters.count(c) > 3 for c in "fxo"), letters


@pytest.mark.parametrize("name", MAPS)
def test_what_is_seen_of_cells_is_what_poses_have(name: str) -> None:
    """By Newton's method at places at random: in free cells the determinant has one sign and the margin is not 0; the
    ends of an edge on which it changes have both; no pose is found at a node that is not reached.
    """
    source, _, _ = MAPS[name]
    s, c, rng = seen(name).s, seen(name), np.random.default_rng(3)
    value = gc.compiled(source, coordinates=", ".join(s.pose([0.0] * len(s.axes))))

    def numbers(places: Any) -> dict[str, Any]:
        rows = [list(s.pose(place).values()) for place in places]
        return dict(value.numbers(rows, "margins, signs, proved"))

    compared = 0
    for cell, letter in cells_of(data(name)):
        what = c.seen(cell, "f")
        box = s.box(cell, [k + 1 for k in cell])
        if what == "f":
            found = numbers(rng.uniform(box.low, box.high, (6, len(cell))))
            signs = found["signs"][found["proved"]]
            assert (found["margins"][found["proved"]] > 0).all()
            assert len({*signs.tolist()} - {0}) < 2
            compared += len(signs)
        elif what == "x":
            ends = [[s.at(k, n) for k, n in enumerate(node)] for node in c.corners(cell)]
            found = numbers(ends)
            assert not found["proved"].all() or {-1, 1} <= {*found["signs"].tolist()}
        elif letter == "o":
            nodes = [n for n in c.corners(cell) if c.node(n) == "o"]
            found = numbers([[s.at(k, n) for k, n in enumerate(node)] for node in nodes])
            assert not found["proved"].any()
    assert compared > 5


def test_the_command_writes_what_the_program_reads(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    over = [part for axis in MAPS["6-rus"][1] for part in ("--over", axis)]
    done = invoke("map", "6-rus", *over, "--certificate", str(tmp_path / "a.json"))
    assert done.exit_code == 0, done.stderr
    assert json.loads((tmp_path / "a.json").read_text()) == data("6-rus")
    left = data("6-rus")["claim"]["undecided"]
    assert run((tmp_path / "a.json").read_bytes(), tmp_path, monkeypatch) == (3 if left else 0)
    said = capsys.readouterr().out
    assert "of six rods: turn ['B1', 'C1']" in said
    assert "over yaw -12..12 deg in 3 cells, z -1/10..1/10 in 2 cells" in said


@pytest.mark.parametrize(
    ("source", "over", "says"),
    [
        ("delta", ["q1 -5:5:3 deg", "q2 -5:5:3 deg"], "its loops have 12 equations for 9 undriven amounts"),
        ("h4", ["x -0.1:0.1:3", "y -0.1:0.1:3"], "has loops inside its limbs"),
        ("agile-eye", ["roll -5:5:3 deg", "yaw -5:5:3 deg"], "no closed forms of all its limbs are known"),
    ],
)
def test_robots_without_a_certificate_are_told_before_anything_is_computed(
    source: str, over: list[str], says: str, tmp_path: Path
) -> None:
    ranges = [part for axis in over for part in ("--over", axis)]
    done = invoke("map", source, *ranges, "--certificate", str(tmp_path / "a.json"))
    assert (done.exit_code, says in done.stderr) == (3, True), done.stderr
    assert not [*tmp_path.iterdir()]


# --- forged files --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", MAPS)
def test_another_status_of_a_cell_is_never_confirmed(name: str) -> None:
    """Each kind of cell called each other kind: refused, or told to be not decided."""
    file, rng = data(name), random.Random(5)
    for old in "fxou":
        places = [place for place, letter in cells_of(file) if letter == old]
        for place in rng.sample(places, min(2, len(places))):
            for new in "fxo":
                what = seen(name).seen(place, new)
                if new == old or what == new:
                    continue
                forged = with_letters(file, changed(file["cells"], place, new))
                if old != "u":
                    assert what != "u", (place, old, new)
                if what != "u":
                    with pytest.raises(CHECK.Refused, match="is called"):
                        checked_by(name, forged)
                else:
                    words, left = checked_by(name, forged)
                    assert left == file["claim"]["undecided"]
                    assert "NOT decided here: 1 cells" in words


def checked_by(name: str, file: dict[str, Any]) -> Any:
    """The verdict, with what is seen of a slice and a robot that were not changed."""
    known = seen(name)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(JOINTS, "JointSlice", lambda _: known.s)
        patch.setattr(JOINTS, "Cells", lambda *_: known)
        patch.setattr(JOINTS, "samples", lambda *_: None)
        return CHECK.checked(file)


def all_called(file: dict[str, Any], letter: str) -> dict[str, Any]:
    cells = file["cells"]
    for place, _ in cells_of(file):
        cells = changed(cells, place, letter)
    return with_letters(file, cells)


@pytest.mark.parametrize(
    ("name", "letter"), [("delta", "o"), ("delta", "x"), *itertools.product(["3-rps", "3-rrr", "3-rpr"], "fox")]
)
def test_a_whole_map_of_one_kind_is_refused(name: str, letter: str) -> None:
    with pytest.raises(CHECK.Refused, match="is called"):
        checked_by(name, all_called(data(name), letter))


def test_cells_that_are_missing_or_twice_are_refused() -> None:
    file = data("6-rus")
    for new in (
        put(file, ("cells",), file["cells"][:-1]),
        put(file, ("cells",), [*file["cells"], file["cells"][0]]),
        put(file, ("cells", 1), file["cells"][1] * 2),
        put(file, ("cells", 1), "?" * len(file["cells"][1])),
        put(file, ("question", "over", 0, "number"), 3),
        put(file, ("question", "over", 0, "number"), True),
        put(file, ("question", "over", 1), file["question"]["over"][0]),
        put(file, ("question", "over"), file["question"]["over"][:1]),
        put(file, ("question", "over", 0, "coordinate"), "rx"),
        put(file, ("question", "over", 0, "coordinate"), "x"),
        put(file, ("question", "over", 0, "unit"), "m"),
        put(file, ("question", "rest", "x"), "0"),
        put(file, ("question", "rest", "x"), math.inf),
        put(file, ("question", "rest"), {}),
        put(file, ("question", "limits"), {"q1": [0, 1]}),
        put(file, ("question", "tilt"), 0.1),
        put(file, ("geometry",), None),
        put(file, ("claim", "free"), file["claim"]["free"] + 1),
    ):
        with pytest.raises(CHECK.Refused):
            CHECK.checked(signed(new))


def test_rods_are_those_of_the_robot() -> None:
    file = data("6-rus")
    file["geometry"]["rods"][0]["ends"][1][0] += 0.1
    with pytest.raises(CHECK.Refused, match="that of the robot's points"):
        CHECK.checked(signed(file))


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("3-rps", lambda q: q["rest"].update(z=-1.5)),
        ("3-rps", lambda q: q["over"][0].update(low="-1", high="1")),
        ("3-rpr", lambda q: q["over"][1].update(low="-20", high="10")),
        ("3-rrr", lambda q: q["over"][0].update(low="0", high="4/100")),
    ],
)
def test_cells_of_another_slice_are_refused(name: str, change: Callable[[dict[str, Any]], Any]) -> None:
    file = data(name)
    change(file["question"])
    with pytest.raises(CHECK.Refused, match="is called"):
        CHECK.checked(signed(file))


def test_the_slice_need_not_hold_home_but_a_way_leads_to_it() -> None:
    file = json.loads(json.dumps(gc.singular_map("3-rpr", ["x 0.1:0.2:3", "y 0.1:0.2:3"], "yaw=5deg").certificate()))
    assert file["claim"]["free"] == 4
    assert CHECK.checked(file)[1] == 0
    file["question"]["rest"]["yaw"] = 10.0  # beyond singular poses, more than a turn away: no root ends there
    with pytest.raises(CHECK.Refused):
        CHECK.checked(signed({**file, "cells": ["xx", "xx"]}))


def _with_root(file: dict[str, Any], constant: str) -> None:
    """One more root, of the first coordinate and a number."""
    lines, results = file["geometry"]["roots"]["lines"], file["geometry"]["roots"]["results"]
    n = len(lines)
    first = file["geometry"]["names"].index(file["question"]["over"][0]["coordinate"])
    lines += [["input", first], ["shift", n, constant], ["sqrt", n + 1]]
    results.append(n + 2)


def test_a_root_that_no_limb_has_makes_no_hole() -> None:
    """The loops close at corners that are called outside."""
    file = data("3-rpr")
    _with_root(file, "1/4")  # none where x < -1/4
    cells = ["o" * len(row) if k == 0 else row for k, row in enumerate(file["cells"])]
    with pytest.raises(CHECK.Refused, match="does not exist where the joints are closed"):
        CHECK.checked(with_letters(file, cells))


def _kink(file: dict[str, Any]) -> None:
    """The first wrench's first entry with another sign where the first coordinate is above 1/20, by the root of a
    square: near home it is what the joints make.
    """
    program = file["geometry"]["wrenches"]
    lines, n = program["lines"], len(program["lines"])
    first = file["geometry"]["names"].index(file["question"]["over"][0]["coordinate"])
    lines += [["input", first], ["shift", n, "-1/4"], ["mul", n + 1, n + 1], ["sqrt", n + 2], ["inv", n + 3]]
    lines += [["mul", n + 4, n + 1], ["scale", n + 5, "-1"]]
    k = next(k for k, r in enumerate(program["results"]) if type(r) is int)
    lines.append(["mul", n + 6, program["results"][k]])
    program["results"][k] = n + 7


def test_closed_forms_that_are_others_beyond_a_root_confirm_nothing_there() -> None:
    file = json.loads(json.dumps(gc.singular_map("3-rpr", ["x -0.4:0.4:5", "yaw -5:5:2 deg"]).certificate()))
    assert file["cells"] == ["f"] * 4
    _kink(file)
    try:
        words, left = CHECK.checked(signed(file))
    except CHECK.Refused:
        return
    assert left >= 1
    assert "NOT decided here" in words


def test_another_branch_of_a_limb_is_refused() -> None:
    file = data("3-rrr")
    lines = file["geometry"]["wrenches"]["lines"]
    n = next(k for k, line in enumerate(lines) if line[0] == "sqrt")
    lines.append(["scale", n, "-1"])
    for line in lines[n + 1 : -1]:
        line[1:] = [len(lines) - 1 if c == n else c for c in line[1:]]
    moved = lines.pop()
    lines.insert(n + 1, moved)
    for line in lines[n + 2 :]:
        line[1:] = [
            n + 1 if c == len(lines) - 1 else c + 1 if type(c) is int and c > n and line[0] != "input" else c
            for c in line[1:]
        ]
    results = file["geometry"]["wrenches"]["results"]
    results[:] = [r + 1 if type(r) is int and r > n else r for r in results]
    with pytest.raises(CHECK.Refused):
        CHECK.checked(signed(file))


def test_roots_that_are_left_out_make_no_free_cells() -> None:
    """Without the roots of its limbs a robot would reach all poses: its wrenches and joints say otherwise."""
    file = data("3-rrr")
    file["geometry"]["roots"] = {"lines": [], "results": []}
    with pytest.raises(CHECK.Refused):
        CHECK.checked(all_called(file, "f"))


def test_in_a_size_that_is_none_of_the_robot_nothing_looks_small() -> None:
    """Beside it the velocities of all joints, and the gaps of loops, would be nothing."""
    file = data("3-rpr")
    for size in (1e15, 1e-9, -1.0, math.inf):
        file["geometry"]["size"] = size
        with pytest.raises((CHECK.Refused, JOINTS.Malformed)):
            CHECK.checked(all_called(file, "f"))


@pytest.mark.parametrize("name", ["3-rpr", "delta"])
def test_joints_that_move_the_platform_are_not_held(name: str) -> None:
    """Else all poses that are compared would be home."""
    file = data(name)
    for limb in file["geometry"]["limbs"]:
        limb["held"] = list(range(1, max(limb["coordinates"]) + 1))
    with pytest.raises(CHECK.Refused, match="not held do not move"):
        CHECK.checked(all_called(file, "o"))


@pytest.mark.parametrize("name", FALSE_JOINTS)
def test_joints_that_the_closed_forms_do_not_hold_are_refused(name: str) -> None:
    with pytest.raises(CHECK.Refused, match=FALSE_JOINTS[name][1]):
        CHECK.checked(with_false_joints(data("3-rpr"), name))


def test_the_words_say_what_is_driven() -> None:
    file = data("delta")
    words = list(JOINTS.joint_words(seen("delta").s.robot))
    for a in file["geometry"]["actuators"]:
        assert f"driven: {a['name']!r}" in words[a["limb"]]
    assert words[-1] == f"lengths in parts of {file['geometry']['size']:.6g}"


UNREAD = {"robot", "about", "actuators", "actuator", "end"}
"""What cells do not depend on: the words by which robots are known, drives without limits, how high limbs of a planar
robot end.
"""


@pytest.mark.parametrize("name", ["6-rus", "3-rpr"])
def test_files_that_were_changed_are_refused_or_say_the_same(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With the old digest every change is seen; with a new one nothing ends in a trace."""
    for path, code in with_junk(data(name), 12, tmp_path, monkeypatch):
        assert "Traceback" not in capsys.readouterr().out
        assert code in (1, 2) or UNREAD & {*path}, path


def test_numbers_that_were_changed_a_little_are_refused() -> None:
    """Screws, ends and constants: the closed forms are not what other joints make."""
    file, rng = data("3-rps"), random.Random(2)
    numbers = [p for p in leaves(file["geometry"]) if p and p[0] == "limbs" and p[2:3] == ("screws",) and len(p) == 5]
    for path in rng.sample(numbers, 4):
        new = copy.deepcopy(file)
        new["geometry"]["limbs"][path[1]]["screws"][path[3]][path[4]] += 0.05
        with pytest.raises(CHECK.Refused):
            CHECK.checked(signed(new))
    lines = file["geometry"]["wrenches"]["lines"]
    for k in rng.sample([k for k, line in enumerate(lines) if line[0] in ("scale", "shift")], 3):
        new = copy.deepcopy(file)
        new["geometry"]["wrenches"]["lines"][k][-1] = str(Fraction(lines[k][-1]) + Fraction(1, 7))
        with pytest.raises(CHECK.Refused):
            CHECK.checked(signed(new))


def test_numbers_that_are_none_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for old, new in (('"number": 4', '"number": 4.0'), ('"x": 0.0', '"x": 1e999'), ('"x": 0.0', '"x": NaN')):
        assert old in text("6-rus")
        assert run(text("6-rus").replace(old, new, 1), tmp_path, monkeypatch) == 2


def test_files_have_the_fields_of_the_published_schema() -> None:
    schema = json.loads((ROOT / "docs" / "assets" / "map-certificate-joints.schema.json").read_text(encoding="utf-8"))
    for name in MAPS:
        file = data(name)
        for value, one in [(file, schema), *((file[k], schema["properties"][k]) for k in ("question", "claim"))]:
            assert {*one["required"]} <= value.keys() == one["properties"].keys()
        axis = schema["properties"]["question"]["properties"]["over"]["items"]
        assert all(part.keys() == axis["properties"].keys() for part in file["question"]["over"])
        assert file["geometry"].keys() <= schema["properties"]["geometry"]["properties"].keys()
