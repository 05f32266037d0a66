"""Robot files as sheets: read and written back, and what changes make of them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.robot_file import parse_draft, parse_robot
from gcrules.mechanisms.description.skeleton import skeleton
from gcrules.mechanisms.editing.edits import EDITS, Edit, edited
from gcrules.mechanisms.editing.home import fitted, size_of, vector_of
from gcrules.mechanisms.editing.reading import read_sheet
from gcrules.mechanisms.editing.sheet import FIRST as FIRST_LIMBS
from gcrules.mechanisms.editing.writing import rewritten, sheet_text
from gcrules.mechanisms.lines.equivalent import equivalent
from gcrules.mechanisms.robot import Robot
from gcrules.screws import FLOATS

FIRST = FIRST_LIMBS[False]
FILES = {one.id: Path(one.path).read_text(encoding="utf-8") for one in robots()}


def changed(text: str, *edits: Edit) -> str:
    for edit in edits:
        placed = read_sheet(text)
        text = rewritten(text, placed, edited(placed.sheet, edit))
    return text


def described(text: str) -> Robot:
    robot = parse_draft(text).robot
    assert robot is not None, [fault.message for fault in parse_draft(text).faults]
    return robot


def mobility(robot: Robot) -> int:
    return equivalent(robot.family, robot.limbs).mobility


@pytest.mark.parametrize("name", FILES)
def test_a_sheet_says_what_its_file_says(name: str) -> None:
    """Unchanged, a file stays as it is; written anew, it is the same robot."""
    text = FILES[name]
    placed = read_sheet(text)
    assert rewritten(text, placed, placed.sheet) == text
    anew = sheet_text(placed.sheet)
    assert read_sheet(anew).sheet == placed.sheet
    before, after = parse_robot(text), parse_robot(anew)
    assert (before.limbs, before.family, before.home) == (after.limbs, after.family, after.home)
    assert (before.platform, before.mobility, before.note) == (after.platform, after.mobility, after.note)


def test_a_change_leaves_the_rest_of_a_commented_file() -> None:
    text = skeleton("my-robot")
    new = changed(text, Edit("joint drive", joint=0, text="*"))
    gone, come = set(text.splitlines()) - set(new.splitlines()), set(new.splitlines()) - set(text.splitlines())
    assert gone == {"    joints: R(A%, r%) P*(A% S%) S(S%)"}
    assert come == {"    joints: R*(A%, r%) P*(A% S%) S(S%)"}
    other = changed(text, Edit("name add", name="Q%", text="point"))
    assert [line for line in text.splitlines() if line not in other.splitlines()] == []
    assert "  Q%: free" in other


def test_data_in_braces_is_written_anew() -> None:
    text = '{"title": "T", "points": {"A1": "free"}, "limbs": [{"joints": "S(A1)"}], "mobility": 3}'
    assert changed(text, Edit("title", text="U")).startswith("title: U\npoints:\n  A1: free\n")


def test_limbs_around_z_are_the_robot_that_copies_make() -> None:
    text = changed(FIRST, Edit("limb around", to=3), Edit("mobility", to=3))
    robot = parse_robot(text)
    shipped = parse_robot(FILES["3-rps"])
    assert (robot.chain, robot.mobility, mobility(robot)) == (shipped.chain, 3, 3)
    assert [j.text for limb in robot.limbs for j in limb.joints] == [
        j.text for limb in shipped.limbs for j in limb.joints
    ]
    assert robot.platform == ("S1", "S2", "S3")


@pytest.mark.parametrize(
    "edits",
    [
        (Edit("limb around", to=3), Edit("limb single")),
        (Edit("limb duplicate", degrees=120), Edit("limb duplicate", degrees=240)),
    ],
    ids=["single", "duplicates"],
)
def test_single_limbs_are_the_same_robot_as_copies(edits: Sequence[Edit]) -> None:
    alike = parse_robot(changed(FIRST, Edit("limb around", to=3), Edit("mobility", to=3)))
    one_by_one = parse_robot(changed(FIRST, *edits, Edit("mobility", to=3)))
    assert "copies" not in one_by_one.text
    assert mobility(one_by_one) == mobility(alike)
    assert alike.home is not None
    assert one_by_one.home is not None
    there = {n: tuple(map(float, v)) for n, v in one_by_one.home.items()}
    assert there == {n: pytest.approx(tuple(map(float, v)), abs=1e-8) for n, v in alike.home.items()}


def test_what_lies_on_the_axis_is_shared_and_the_frame_is_turned() -> None:
    text = changed(
        """
title: T
points: {A1: free, O: free}
limbs: [{name: leg 1, joints: "P*(x) R(A1, z) S(O)"}]
mobility: 6
home: {A1: [1, 0, 0], O: [0, 0, 2]}
""",
        Edit("limb around", to=4),
    )
    robot = described(text)
    assert [limb.joints[2].text for limb in robot.limbs] == ["S(O)"] * 4
    assert [limb.joints[1].text for limb in robot.limbs] == [f"R(A{k}, z)" for k in range(1, 5)]
    home = {n: tuple(map(float, v)) for n, v in (robot.home or {}).items()}
    ways = [limb.joints[0].names[0] for limb in robot.limbs]
    assert [home[n] for n in ways] == [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)]


def test_a_limb_whose_copies_are_of_another_number_is_duplicated() -> None:
    """The file has three copies already: two more limbs are written one by one."""
    central, legs = 0, 1
    text = changed(FILES["tricept"], Edit("limb single", limb=legs), Edit("limb around", limb=legs, to=3))
    sheet = read_sheet(text).sheet
    assert sheet.limbs[central].name == "the central leg"
    assert len(sheet.every_limb) == 6
    assert len(described(text).limbs) == 6
    with pytest.raises(InputError, match="already stands for 3 limbs"):
        changed(FILES["3-rps"], Edit("limb around", to=3))


@pytest.mark.parametrize("count", [2, 4, 6])
def test_another_number_of_copies(count: int) -> None:
    sheet = read_sheet(changed(FILES["3-rps"], Edit("copies", to=count))).sheet
    assert sheet.copies == len(sheet.every_limb) == count
    assert vector_of(sheet.home[f"A{count}"])[2] == vector_of(sheet.home["A1"])[2]


@pytest.mark.parametrize("kind", ["R", "P", "H", "C", "U", "S", "E", "Pa", "4S"])
def test_every_kind_of_joint_can_be_put_in_and_taken_out(kind: str) -> None:
    """With names and places of its own, which go with it."""
    text = changed(FIRST, Edit("joint add", joint=1, text=kind))
    robot = described(text)
    assert [j.kind for j in robot.limbs[0].joints] == ["R", kind, "P", "S"]
    assert robot.values_at()
    assert read_sheet(changed(text, Edit("joint remove", joint=1))).sheet == read_sheet(FIRST).sheet
    other = described(changed(FIRST, Edit("joint kind", joint=0, text=kind)))
    assert other.limbs[0].joints[0].kind == kind


def test_joints_and_limbs_are_moved() -> None:
    moved = read_sheet(changed(FIRST, Edit("joint move", joint=2, to=0))).sheet
    assert moved.limbs[0].chains[0].text == "S(S1) R(A1, r1) P*(A1 S1)"
    limbs = read_sheet(changed(FILES["h4"], Edit("limb move", limb=0, to=1))).sheet.limbs
    assert [limb.name for limb in limbs] == ["right half", "left half"]
    assert read_sheet(changed(FIRST, Edit("limb add"), Edit("limb remove", limb=1))).sheet == read_sheet(FIRST).sheet


EMPTY = "title: T\npoints: {}\nlimbs: []\nmobility: 0\n"


@pytest.mark.parametrize("chain", ["RP*S", "UP*S", "P*RS", "R*US", "UP*U", "R*UU", "R*4S", "R*RRS", "H*PS", "S", "CPU"])
def test_limbs_are_added_as_they_are_written(chain: str) -> None:
    """Three of them around z move as the count for general limbs says, and home fits them."""
    text = changed(EMPTY, Edit("limb add", text=chain))
    (limb,) = described(text).limbs
    assert limb.chain == chain
    alike = described(changed(text, Edit("limb around", to=3)))
    assert mobility(alike) == max(0, 6 - 3 * (6 - limb.freedoms))
    faults = parse_draft(changed(alike.text, Edit("mobility", to=mobility(alike)))).faults
    assert {f.message[:13] for f in faults} <= {"no joint is a", "too few actua"}


@pytest.mark.parametrize("chain", ["UP*S", "R*US", "P*US"])
def test_twice_three_limbs_of_six_freedoms_hold_the_platform(chain: str) -> None:
    edits = [Edit("limb add", text=chain), Edit("limb around", limb=0, to=3)]
    edits += [Edit("limb add", text=chain), Edit("limb around", limb=1, to=3), Edit("mobility", to=6)]
    robot = parse_robot(changed(EMPTY, *edits))
    assert len(robot.limbs) == len({limb.name for limb in robot.limbs}) == 6
    found = equivalent(robot.family, robot.limbs, robot.values_at())
    lines = [row for limb in robot.limbs for row in limb.at(robot.values_at(), FLOATS).locked(FLOATS)]
    assert found.rank == 6
    assert np.linalg.svd(np.array(lines, dtype=float), compute_uv=False)[-1] > 0.01


def test_limbs_of_a_planar_robot_turn_about_z() -> None:
    text = changed(FILES["3-rrr"], Edit("limb add"))
    assert "name: leg 4\n    joints: R*(A4, z) R(B4, z) R(C4, z)\n" in text
    assert set(FILES["3-rrr"].splitlines()) - set(text.splitlines()) == {"platform: C%"}  # home as it was
    robot = parse_robot(text)
    assert mobility(robot) == 3
    slide = described(changed(FILES["3-rrr"], Edit("limb add", text="P*RR")))
    assert slide.limbs[3].chain == "P*RR"
    assert mobility(slide) == 3


def test_cables_are_added_and_their_ends_changed() -> None:
    """Four cables and four more hold a platform, as they do in the robot on eight cables."""
    text = changed(EMPTY, Edit("limb add", text="cable"), Edit("limb around", to=4))
    robot = described(changed(text, Edit("limb add", text="cable"), Edit("limb around", limb=1, to=4)))
    shipped = parse_robot(FILES["8-cables"])
    assert {limb.chain for limb in (*robot.limbs, *shipped.limbs)} == {"cable"}
    assert (len(robot.limbs), mobility(robot)) == (len(shipped.limbs), mobility(shipped)) == (8, 6)
    assert len(robot.platform) == 8
    other = changed(text, Edit("limb cable", part=1, text="A%"))
    assert "cable: A% A%" in other
    with pytest.raises(InputError, match="is not an end of a cable"):
        changed(text, Edit("limb cable", part=1, text="A% B%"))


def test_the_first_limb_of_the_plane_and_its_unit() -> None:
    first = FIRST_LIMBS[True]
    edits = [Edit("limb around", to=3), Edit("unit", text="mm"), Edit("title", text="Mine")]
    robot = parse_robot(changed(first, *edits))
    assert (robot.chain, robot.units, mobility(robot)) == (parse_robot(FILES["3-rrr"]).chain, "mm", 3)
    assert changed(changed(first, Edit("unit", text="mm")), Edit("unit", text="")) == first


def test_another_name_stands_everywhere() -> None:
    robot = parse_robot(changed(FILES["3-rps"], Edit("name rename", name="S%", text="B%")))
    assert robot.platform == ("B1", "B2", "B3")
    assert [j.text for j in robot.limbs[1].joints] == ["R(A2, r2)", "P*(A2 B2)", "S(B2)"]
    shipped = parse_robot(FILES["3-rps"])
    assert robot.home is not None
    assert shipped.home is not None
    assert robot.home["B2"] == shipped.home["S2"]
    condition = changed(FILES["gallardo-4dof"], Edit("name rename", name="S3", text="Q3"))
    assert "Q3" in condition


def test_home_goes_to_the_nearest_place_that_relations_allow() -> None:
    """A point pulled off its plane is projected to it, along the normal."""
    text = changed(FIRST, Edit("home", name="S1", texts=("1", "0.5", "2")))
    robot = described(text)
    found = fitted(robot, read_sheet(text).sheet.home, 2.0)
    assert vector_of(found["S1"]) == pytest.approx((1, 0, 2))
    assert found["A1"] == ("2", "0", "0")
    placed = read_sheet(text)
    sheet = read_sheet(rewritten(text, placed, edited(placed.sheet, Edit("mobility", to=5)))).sheet
    assert size_of(sheet) == 2


@pytest.mark.parametrize(
    "edit",
    [
        Edit("title", text=" "),
        Edit("limb around", to=99),
        Edit("limb around", limb=7, to=3),
        Edit("limb name", text="a: b"),
        Edit("limb name", text=""),
        Edit("limb add", text="RP*X"),
        Edit("limb add", text="U-S"),
        Edit("limb add", text="R" * 13),
        Edit("joint add", text="X"),
        Edit("joint add", chain=3, text="R"),
        Edit("joint remove", joint=9),
        Edit("joint drive", text="**"),
        Edit("joint part", text="A1) S(B1"),
        Edit("joint part", text="A1, r1"),
        Edit("joint part", part=5, text="A1"),
        Edit("name add", name="x", text="point"),
        Edit("name add", name="A1", text="point"),
        Edit("name add", name="a b", text="point"),
        Edit("name add", name="B1", text="plane"),
        Edit("name rename", name="A1", text="S1"),
        Edit("name rename", name="A1", text="A%"),
        Edit("name relation", name="A1", text="free # x"),
        Edit("home", name="A1", texts=("1", "2", "1/0")),
        Edit("home", name="A1", texts=("1", "2", "nan")),
        Edit("home", name="A%", texts=("1", "2", "3")),
        Edit("home", name="Q1", texts=("1", "2", "3")),
        Edit("copies", to=1),
        Edit("unit", text="furlong"),
    ],
    ids=lambda edit: f"{edit.do} {edit.text or edit.name or edit.to}",
)
def test_changes_that_cannot_be_are_refused(edit: Edit) -> None:
    with pytest.raises(InputError) as refused:
        changed(FIRST, edit)
    assert refused.value.message


def test_every_change_is_tried() -> None:
    """What is left of a file after any change can be read again."""
    for do in EDITS:
        for text in (FIRST, FILES["h4"], FILES["3-rps"]):
            try:
                new = changed(text, Edit(do, to=2, name="A1", text="R", texts=("1", "2", "3"), degrees=60))
            except InputError:
                continue
            assert read_sheet(new).sheet.limbs or do == "limb remove", do


@pytest.mark.parametrize("text", ["", "- a", "title: T", "title: T\nlines: A1B1", "limbs: 3", "limbs: [{joints: R(}]"])
def test_what_is_no_table_is_refused_with_its_place(text: str) -> None:
    with pytest.raises(GcrulesError):
        read_sheet(text)
