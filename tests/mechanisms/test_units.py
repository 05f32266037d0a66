"""The unit of a robot file: answers bear it, lengths that are given may, and others are refused."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest
from commands import invoke
from places import ROOT

import gcrules as gc
from gcrules.core.errors import FileError, GcrulesError, InputError
from gcrules.mechanisms.description.as_platform import as_platform
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.models.of_robot import model_of

DELTA = (ROOT / "plugins" / "delta" / "robot.yaml").read_text(encoding="utf-8")
IN_CM = DELTA.replace("mobility:", "units: cm\nmobility:")


@pytest.fixture(name="delta")
def in_cm(tmp_path: Path) -> str:
    path = tmp_path / "delta.yaml"
    path.write_text(IN_CM, encoding="utf-8")
    return str(path)


def test_the_unit_is_part_of_the_robot() -> None:
    assert parse_robot(IN_CM).units == "cm"
    assert parse_robot(DELTA).units == ""
    with pytest.raises(FileError, match="cmm"):
        parse_robot(IN_CM.replace("units: cm", "units: cmm"))
    with pytest.raises(FileError) as fault:
        parse_robot(IN_CM.replace("[0,", "[0 cm,", 1))
    assert fault.value.hint == "write 0; the unit is given once in the file, as  units: cm"


def test_lengths_bear_it_and_no_other_one(delta: str) -> None:
    named, plain = gc.pose(delta, "x=0.1cm, y=0, z=0"), gc.pose("delta", "x=0.1, y=0, z=0")
    assert (named.unit, plain.unit) == ("cm", "")
    assert named.margin == plain.margin
    for text in ("x=1mm, y=0, z=0", "1 0 0 mm"):
        with pytest.raises(InputError, match="mixed units: mm here, but the robot is given in cm"):
            gc.pose(delta, text)
    with pytest.raises(InputError, match="mixed units"):
        gc.certify(delta, ["x -1..1 mm"])
    with pytest.raises(GcrulesError, match="mixed units"):
        gc.locus(delta, at="z=1mm")


@pytest.mark.parametrize(
    ("command", "shown"),
    [
        ("pose {} --at 'x=0.1,y=0,z=0'", ("x 0.1 cm,", "cm/rad")),
        ("path {} --poses {poses}", ("cm/rad",)),
        ("path {} --poses {poses} --json", ('"unit": "cm"',)),
        ("map {} --over 'x -0.1:0.1:3' --over 'y -0.1:0.1:3 cm'", ("x from -0.1 to 0.1 cm",)),
        ("plan {} --from 'x=0,y=0,z=0' --to 'x=0.1cm,y=0,z=0'", ("cm",)),
        ("export {} --language c", ("(in cm)",)),
    ],
)
def test_answers_bear_it(command: str, shown: tuple[str, ...], delta: str, tmp_path: Path) -> None:
    poses = tmp_path / "poses.csv"
    poses.write_text("x [cm],y [cm],z [cm]\n0,0,0\n0.1,0,0\n", encoding="utf-8")
    found = invoke(*shlex.split(command.replace("{}", delta).replace("{poses}", str(poses))))
    assert found.exit_code == 0, found.stderr
    for text in shown:
        assert text in found.stdout


def test_tables_bear_it_and_are_read_back(delta: str, tmp_path: Path) -> None:
    found = gc.plan(delta, "x=0, y=0, z=0", "x=0.1, y=0, z=0")
    assert found.csv().splitlines()[0] == "x [cm],y [cm],z [cm]"
    path = tmp_path / "way.csv"
    path.write_text(found.csv(), encoding="utf-8")
    assert gc.path(delta, str(path)).csv().startswith("parameter,x [cm],")
    with pytest.raises(InputError, match="mixed units: cm here"):
        gc.path("delta", str(path))


def test_models_are_in_metres() -> None:
    robot, centimetres = parse_robot(DELTA), parse_robot(IN_CM)
    places = [[j.at for j in model_of(r).joints] for r in (robot, centimetres)]
    assert places[1] == [pytest.approx([c / 100 for c in at]) for at in places[0]]
    with pytest.raises(InputError, match="the file's unit is cm"):
        model_of(centimetres, "mm")


def test_a_platform_on_six_legs_keeps_it() -> None:
    text = (ROOT / "plugins" / "octahedral" / "robot.yaml").read_text(encoding="utf-8")
    assert as_platform(parse_robot(text.replace("mobility:", "units: in\nmobility:"))).units == "in"
