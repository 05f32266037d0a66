"""Paths and maps in the studio: they say what `gc.path` and `gc.singular_map` say, of every kind of mechanism."""

from __future__ import annotations

import json
import re
from contextlib import suppress
from itertools import pairwise
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

import gcrules as gc
from gcrules.apps.studio.moving import posed
from gcrules.apps.studio.whereabouts import all_reached, reached, solved_at
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.kinematics.coordinates import coordinates
from gcrules.mechanisms.kinematics.leading import leading
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import read_robot
from gcrules.poses.limbs.many import Solved
from gcrules.poses.maps.cells import MEANINGS
from gcrules.poses.signs.of_limbs import DETERMINANT, signs_of_limbs
from gcrules.views.plots.path_plot import FRAME

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import HOME, Page

from gcrules.mechanisms.kinematics.amplification import INDICES

DELTA = {"kind": "robot", "id": "delta"}
RPS = {"kind": "robot", "id": "3-rps"}
OCTAHEDRAL = {"kind": "example", "name": "octahedral"}
SVG = "{http://www.w3.org/2000/svg}"


def opened(root: Path, source: dict[str, str]) -> str:
    """What `gc.path` takes for a source of the page; a robot and an example may have one name."""
    return source["id"] if source["kind"] == "robot" else str(root / "examples" / f"{source['name']}.yaml")


class Asked:
    """Asks each thing once: several tests look at the same answers."""

    def __init__(self) -> None:
        self.answers: dict[str, Any] = {}

    def __call__(self, page: Page, do: str, **args: Any) -> Any:
        key = json.dumps([do, args])
        if key not in self.answers:
            self.answers[key] = page.ask(do, **args)
        return self.answers[key]


@pytest.fixture(scope="module")
def asked() -> Asked:
    return Asked()


# --- paths ---------------------------------------------------------------------------------------------------------

PATHS: dict[str, tuple[dict[str, str], str]] = {
    "platform, crossing": (OCTAHEDRAL, "x=20, yaw=120deg"),
    "platform, free": (OCTAHEDRAL, "z=30"),
    "Delta": (DELTA, "x=1, y=0, z=-0.5"),
    "3-RPS, crossing": (RPS, "z=0.1, roll=110deg, pitch=0deg"),
}


@pytest.mark.parametrize(("source", "to"), PATHS.values(), ids=PATHS)
def test_a_path_is_that_of_gc_path(root: Path, asked: Asked, page: Page, source: dict[str, str], to: str) -> None:
    found = asked(page, "path", source=source, goal=HOME, to=to)
    same = gc.path(opened(root, source), ["home", to])
    assert (found["verdict"], found["reason"]) == (same.verdict, same.reason)
    crossings = same.crossings if hasattr(same, "crossings") else same.zeros
    assert [p["parameter"] for p in found["places"]] == [c.parameter for c in crossings]
    margins = same.margins if hasattr(same, "margins") else same.numbers.margin
    known = dict(zip(same.parameters.tolist(), margins.tolist(), strict=True))
    assert found["end"] == max(known)
    for sample in found["samples"]:
        assert sample["margin"] == known[sample["parameter"]]


@pytest.mark.parametrize(("source", "to"), PATHS.values(), ids=PATHS)
def test_the_robot_is_where_a_sample_says(asked: Asked, page: Page, source: dict[str, str], to: str) -> None:
    """Closing the loops for the sliders, from home, gives the margin that was found along the path."""
    found = asked(page, "path", source=source, goal=HOME, to=to)
    some = found["samples"][:: len(found["samples"]) // 5]
    some += [s for s in found["samples"] if s["parameter"] in [p["parameter"] for p in found["places"]]]
    assert any(s["pose"] for s in some)
    for sample in some:
        if sample["pose"]:
            there = page.ask("pose", source=source, pose=sample["pose"])
            at_a_place = sample["parameter"] in [p["parameter"] for p in found["places"]]  # which has its bound below
            assert there["margin"] == pytest.approx(sample["margin"], abs=1e-5 if at_a_place else 1e-6)
    for place in found["places"]:
        there = page.ask("pose", source=source, pose=place["pose"])
        assert there["verdict"] != "regular"
        assert there["margin"] < 1e-5


@pytest.mark.parametrize("robot", ["delta", "3-rps", "3-rpr", "capaman", "4-rpr"])
def test_poses_of_many_samples_are_those_that_are_found_one_after_the_other(robot: str) -> None:
    """On random ways, on some of which the actuators do not lead to where the platform is."""
    m = Limbs.of(read_robot(robot))
    leads, rng = leading(m.linkage), np.random.default_rng(1)
    amounts = rng.uniform(-0.5, 0.5, (8, len(leads))) * [1.0 if a.angle else 0.4 * m.linkage.size for a in leads]
    names = free_coordinates(m.linkage)
    wanted = np.full((8, len(names)), np.nan)
    for k, given in enumerate(amounts):
        with suppress(InputError):
            wanted[k] = coordinates(names, solved_at(m, posed(m, given)).platform, m.linkage.centre)
    wanted[3] += 0.1
    assert np.isfinite(wanted[:, 0]).sum() >= 3
    known = np.isfinite(wanted[:, 0])
    about = [0.3, -0.2, 0.1]
    found = all_reached(m, amounts[known], names, wanted[known], about)
    single = [reached(m, a, names, w, about) for a, w in zip(amounts[known], wanted[known], strict=True)]
    assert any(found)
    assert [one and one.pose for one in found] == [one and one.pose for one in single]
    for one, other in zip(found, single, strict=True):
        if one and other:
            for part in ("translation", "quaternion"):
                assert one.platform[part] == pytest.approx(other.platform[part], abs=1e-6)
    assert all_reached(m, amounts, names, np.full(wanted.shape, 9.0), about) == [None] * 8


@pytest.mark.parametrize("source", [OCTAHEDRAL, DELTA], ids=["platform", "robot"])
def test_the_way_back_from_the_pose_on_show_goes_through_the_same_poses(page: Page, source: dict[str, str]) -> None:
    axes = page.ask("open", source=source)["axes"]
    away: dict[str, Any] = {"translation": [20.0, 0.0, 10.0], "quaternion": [0.96, 0.0, 0.0, 0.28]}
    if source is DELTA:
        away = HOME | {"coordinates": [6.0, -4.0, 2.0][: len(axes)]}
    out = page.ask("path", source=source, goal=away)
    back = page.ask("path", source=source, start=away, goal=HOME)
    typed = page.ask("path", source=source, start=away, goal=away, to="home")
    forth = {round(1 - s["parameter"], 9): s["margin"] for s in out["samples"]}
    for other in (back, typed):
        both = {round(s["parameter"], 9): s["margin"] for s in other["samples"]}
        both = {p: margin for p, margin in both.items() if p in forth}
        assert len(both) >= 40
        assert both == pytest.approx({p: forth[p] for p in both}, rel=1e-9)
    there = page.ask("pose", source=source, pose=away)
    assert out["samples"][-1]["margin"] == pytest.approx(there["margin"], rel=1e-9)


DETOURS: dict[str, tuple[dict[str, str], str]] = {
    "platform, none": (OCTAHEDRAL, "0 0 -490"),
    "platform, free": (OCTAHEDRAL, "z=30"),
    "3-RPS, none": (RPS, "z=-0.3, roll=0deg, pitch=60deg"),
    "3-RPS, free": (RPS, "z=0.2, roll=20deg, pitch=10deg"),
}


@pytest.mark.parametrize(("source", "to"), DETOURS.values(), ids=DETOURS)
def test_a_way_around_is_that_of_gc_plan(root: Path, page: Page, source: dict[str, str], to: str) -> None:
    found = page.ask("path", source=source, goal=HOME, to=to, way="around")
    same = gc.plan(opened(root, source), "home", to)
    assert (found["detour"]["outcome"], found["detour"]["words"]) == (same.outcome, same.reason)
    assert len(found["detour"]["poses"]) == len(same.poses)
    if same.path is None:
        assert found["places"]
    else:
        assert (found["verdict"], found["reason"]) == (same.path.verdict, same.path.reason)
        assert found["end"] == len(same.poses) - 1


STOPS = {
    "platform": (OCTAHEDRAL, [HOME, {**HOME, "translation": [0, 0, -490]}, {**HOME, "translation": [50, 0, 0]}]),
    "3-RPS": (RPS, [{**HOME, "coordinates": c} for c in ([0, 0, 0], [0.1, 0, 0], [0.1, 0.2, -0.1])]),
}


@pytest.mark.parametrize(("source", "stops"), STOPS.values(), ids=STOPS)
def test_a_way_through_poses_is_that_of_its_table(
    root: Path, tmp_path: Path, page: Page, source: dict[str, str], stops: list[dict[str, Any]]
) -> None:
    """Through the poses as they are, and by the command from the table that is saved; the table leads back to them."""
    start, *through, goal = stops
    found = page.ask("path", source=source, start=start, through=through, goal=goal)
    saved = page.ask("waypoints", source=source, poses=stops)
    table = tmp_path / "way.csv"
    table.write_text(saved["table"], encoding="utf-8")
    same = gc.path(opened(root, source), table)
    assert found["end"] == len(stops) - 1
    assert found["verdict"] == same.verdict
    zeros = same.crossings if hasattr(same, "crossings") else same.zeros
    assert [p["parameter"] for p in found["places"]] == pytest.approx([z.parameter for z in zeros], abs=1e-9)
    back = page.ask("waypoints", source=source, table=saved["table"])
    assert len(back["poses"]) == len(stops)
    for one, other in zip(back["poses"], stops, strict=True):
        for key in ("translation", "quaternion", "coordinates"):
            assert one.get(key, []) == pytest.approx(other.get(key, []), abs=1e-9)


@pytest.mark.parametrize(
    ("source", "args", "message"),
    [
        (OCTAHEDRAL, {"table": "x, y\n1, 2\n"}, "z"),
        (OCTAHEDRAL, {"table": "x, y, z\n1, 2, oops\n"}, "oops"),
        (OCTAHEDRAL, {}, "neither"),
        (OCTAHEDRAL, {"table": "x, y, z\n" + "0, 0, 0\n" * 201}, "201 poses"),
        (RPS, {"table": "x, y, z\n0, 0, 9\n"}, "whole poses"),
    ],
    ids=["columns", "number", "nothing", "too many", "whole poses"],
)
def test_what_is_no_table_of_poses(page: Page, source: dict[str, str], args: dict[str, Any], message: str) -> None:
    assert message in page.fault("waypoints", source=source, **args)["message"]


def test_signs_change_where_the_path_crosses(page: Page) -> None:
    """Between two neighbouring zeros of the path the sign is one, beyond each the other."""
    found = page.ask("path", source=OCTAHEDRAL, goal={**HOME, "translation": [0, 0, -490]})
    cuts = [0, *(p["parameter"] for p in found["places"]), 1]
    signs = []
    for a, b in pairwise(cuts):
        pose = {**HOME, "translation": [0, 0, -490 * (a + b) / 2]}
        signs.append([s["sign"] for s in page.ask("pose", source=OCTAHEDRAL, pose=pose)["signs"]])
    assert signs == [signs[0], [-s for s in signs[0]], signs[0], [-s for s in signs[0]]]


@pytest.mark.parametrize("robot", ["3-rps", "capaman", "4-ups-sp", "tricept", "4-ruu"])
def test_signs_of_robots_of_joints_are_those_that_change_at_singular_poses_only(page: Page, robot: str) -> None:
    """Those of plans and aspects: none of a factor with a cofactor, or with lines that were chosen for a limb."""
    m = Limbs.of(read_robot(robot))
    home = Solved.of(m, np.concatenate(m.linkage.home.joint_values)[None])
    expected = [(s.expression, s.sign) for s in signs_of_limbs(m, home)]
    found = page.ask("pose", source={"kind": "robot", "id": robot}, pose=HOME)["signs"]
    assert [(s["expression"], s["sign"]) for s in found] == expected
    assert all(s["sign"] for s in found)
    assert [s["statement"] == "" for s in found] == [s["expression"] == DETERMINANT for s in found]


def test_a_path_that_is_singular_throughout_says_so(page: Page) -> None:
    found = page.ask("path", source={"kind": "class", "id": "4-4.2"}, goal=HOME, to="z=1")
    always = found["stretches"] and all(s["singular"] for s in found["stretches"])
    assert always or found["places"] or found["verdict"] != "singular"


# --- maps ----------------------------------------------------------------------------------------------------------

MAPS: dict[str, tuple[dict[str, str], list[str]]] = {
    "platform, shifts": (OCTAHEDRAL, ["x -300:300:9", "y -300:300:7"]),
    "platform, a turn": (OCTAHEDRAL, ["x -300:300:7", "rz -120:120:9 deg"]),
    "Delta": (DELTA, ["x -2:2:7", "z -1:1:5"]),
    "Delta, actuators": (DELTA, ["q1 -30:30:5 deg", "q2 -20:20:5 deg"]),
    "3-RPS": (RPS, ["z -0.2:0.2:3", "roll -80:80:9 deg"]),
}


@pytest.mark.parametrize(("source", "over"), MAPS.values(), ids=MAPS)
def test_a_map_is_that_of_gc_singular_map(
    root: Path, asked: Asked, page: Page, source: dict[str, str], over: list[str]
) -> None:
    found = asked(page, "map", source=source, over=over, pose=HOME)
    same = gc.singular_map(opened(root, source), over)
    assert found["guarantee"].lower() == f"{same.guarantee}.".lower()
    assert found["status"] == [[MEANINGS[s] for s in row] for row in same.values("cell_status").tolist()]
    margins = np.array(found["margin"], dtype=float)
    np.testing.assert_allclose(margins, same.values("margin"), rtol=1e-3)
    assert [(a["name"], a["low"], a["high"]) for a in found["axes"]] == [
        (a.name, float(a.start), float(a.stop)) for a in same.grid.axes
    ]


@pytest.mark.parametrize(("source", "over"), MAPS.values(), ids=MAPS)
def test_the_robot_gets_to_places_of_a_map(asked: Asked, page: Page, source: dict[str, str], over: list[str]) -> None:
    """At nodes of the map the numbers of the pose, another road, have its margin."""
    found = asked(page, "map", source=source, over=over, pose=HOME)
    first, second = found["axes"]
    rows, columns = len(found["margin"]), len(found["margin"][0])
    for i, j in ((rows // 2 + 1, 1), (rows // 2, columns // 2 + 1), (rows // 2 - 1, columns // 2)):
        place = [first["low"] + i * first["step"], second["low"] + j * second["step"]]
        answer = page.answer(page.send("place", source=source, over=over, pose=HOME, place=place))
        if answer["ok"]:
            there = page.ask("pose", source=source, pose=answer["result"]["pose"])
            here = page.ask("here", source=source, over=over, pose=answer["result"]["pose"])
            assert here["at"] == pytest.approx(place, abs=1e-6)
            assert here["fixed"] == found["fixed"]
            assert there["margin"] == pytest.approx(found["margin"][i][j], rel=1e-3)
        else:
            assert abs(place[1]) > 30, "only far turns lie behind singular configurations"
            assert answer["error"]["hint"]


def test_a_map_keeps_what_is_no_axis_as_the_pose_has_it(page: Page) -> None:
    pose = HOME | {"coordinates": [4.0, -3.0, 8.0]}
    found = page.ask("map", source=DELTA, over=["q1 0:4:3 deg", "q2 -3:3:3 deg"], pose=pose)
    assert found["margin"][2][0] == pytest.approx(page.ask("pose", source=DELTA, pose=pose)["margin"], rel=1e-3)
    lifted = {"translation": [10.0, 20.0, 30.0], "quaternion": [0.96, 0.0, 0.28, 0.0]}
    over = ["x 10:20:3", "y 20:30:3"]
    found = page.ask("map", source=OCTAHEDRAL, over=over, pose=lifted)
    assert found["margin"][0][0] == pytest.approx(page.ask("pose", source=OCTAHEDRAL, pose=lifted)["margin"], rel=1e-3)
    placed = page.ask("place", source=OCTAHEDRAL, over=over, pose=lifted, place=[10, 20])["pose"]
    assert placed["translation"] == pytest.approx(lifted["translation"])
    assert placed["quaternion"] == pytest.approx(lifted["quaternion"])


# --- pictures ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("source", "over"), MAPS.values(), ids=MAPS)
def test_curves_of_a_map_are_those_of_gc_singular_map(
    root: Path, asked: Asked, page: Page, source: dict[str, str], over: list[str]
) -> None:
    found = asked(page, "map", source=source, over=over, pose=HOME)["curves"]
    same = [c.points for c in gc.singular_map(opened(root, source), over).curves]
    assert all(c["reached"] for c in found), "without limits all is reached"
    np.testing.assert_allclose([p for c in found for p in c["points"]], [p for c in same for p in c], rtol=1e-5)


def test_curves_of_a_map_are_cut_at_the_limits(root: Path, page: Page) -> None:
    """On both sides of a cut stand stretches of the same curve, which share a point."""
    text = (root / "examples" / "octahedral.yaml").read_text(encoding="utf-8")
    text = re.sub(r"(?m)^limits:.*\n", "", text) + "\nlimits: leg lengths 100..640\n"
    source = {"kind": "file", "text": text, "name": "limited.yaml"}
    found = page.ask("map", source=source, over=["x -300:300:9", "z -500:0:9"], pose=HOME)["curves"]
    assert {c["reached"] for c in found} == {True, False}
    assert any(a["points"][-1] == b["points"][0] and a["reached"] != b["reached"] for a, b in pairwise(found))


@pytest.mark.parametrize("measure", ["isotropy", "shift_error"])
def test_a_map_of_what_actuators_do(page: Page, measure: str) -> None:
    study = page.ask("open", source=DELTA)
    assert [m["name"] for m in study["measures"]] == ["margin", *(n for n in INDICES if n != "closure")]
    over = ["x -0.2:0.2:3", "y -0.1:0.1:3"]
    found = page.ask("map", source=DELTA, over=over, pose=HOME, measure=measure)
    expected = gc.singular_map("delta", over, measure=measure)
    assert found["index"] == [[pytest.approx(v, rel=1e-3) for v in row] for row in expected.values(measure).tolist()]
    assert any(INDICES[measure].meaning in item["value"] for item in found["facts"])
    assert page.ask("map", source=DELTA, over=over, pose=HOME)["index"] == []
    assert "is not a measure" in page.fault("map", source=DELTA, over=over, pose=HOME, measure="beauty")["message"]


def test_axes_are_where_the_frame_of_a_path_says(page: Page) -> None:
    """The numbers 0 and 1 of the parameter stand below the ends of the frame."""
    found = page.ask("path", source=OCTAHEDRAL, goal=HOME, to="z=30")
    assert [found["frame"][side] for side in ("left", "right", "top", "bottom")] == list(FRAME)
    root = ElementTree.fromstring(found["svg"])
    *_, width, height = map(float, root.attrib["viewBox"].split())
    lines = [e for e in root.iter() if e.tag in (f"{SVG}line", f"{SVG}polyline", f"{SVG}path")]
    places = [float(x) for e in lines for x in re.findall(r"-?\d+(?:\.\d+)?", " ".join(e.attrib.values()))]
    for place in (FRAME[0] * width, FRAME[1] * width, FRAME[2] * height, FRAME[3] * height):
        assert min(abs(p - place) for p in places) < 0.06


# --- what there is none of -----------------------------------------------------------------------------------------

NO_PATH: dict[str, tuple[dict[str, str], dict[str, Any], str, str]] = {
    "missing coordinates": (DELTA, {"goal": HOME, "to": "x=0.1"}, "too few coordinates", "give 3"),
    "too many": (DELTA, {"goal": HOME, "to": "x=0, y=0, z=1, yaw=3deg"}, "too many coordinates", "give 3"),
    "NaN": (DELTA, {"goal": HOME, "to": "x=nan, y=0, z=0"}, "finite number", ""),
    "NaN of a platform": (OCTAHEDRAL, {"goal": HOME, "to": "x=nan"}, "finite number", ""),
    "no pose": (OCTAHEDRAL, {"goal": HOME, "to": "up a bit"}, "not a part of a pose", ""),
    "out of reach": (DELTA, {"goal": HOME, "to": "x=9, y=0, z=0"}, "was not followed", "ask for less"),
    "unit": (DELTA, {"goal": HOME, "to": "x=1deg, y=0, z=0"}, "x", ""),
    "another number of actuators": (DELTA, {"goal": HOME | {"coordinates": [1.0]}}, "3 actuators", ""),
    "empty": (DELTA, {"goal": HOME, "to": ""}, "empty", ""),
}


@pytest.mark.parametrize(("source", "args", "message", "hint"), NO_PATH.values(), ids=NO_PATH)
def test_what_is_no_path(page: Page, source: dict[str, str], args: dict[str, Any], message: str, hint: str) -> None:
    fault = page.fault("path", source=source, **args)
    assert fault["kind"] == "input", fault
    assert message in fault["message"]
    assert hint in fault.get("hint", "")


NO_MAP: dict[str, tuple[dict[str, str], list[str], str, str]] = {
    "swapped limits": (DELTA, ["x 2:-2:5", "y -2:2:5"], "reversed", "-2:2:5"),
    "empty range": (OCTAHEDRAL, ["x 2:2:5", "y -2:2:5"], "x", ""),
    "twice": (OCTAHEDRAL, ["x -1:1:5", "x -2:2:5"], "twice", "different coordinate"),
    "two kinds": (DELTA, ["x -1:1:5", "q1 -2:2:5 deg"], "q1 is an actuator", "one kind"),
    "NaN": (DELTA, ["x nan:1:5", "y -2:2:5"], "finite number", ""),
    "infinite": (OCTAHEDRAL, ["x -inf:1:5", "y -2:2:5"], "finite number", ""),
    "no such coordinate": (OCTAHEDRAL, ["w -1:1:5", "y -2:2:5"], "w", ""),
    "actuator of a platform": (OCTAHEDRAL, ["q1 -1:1:5", "q2 -2:2:5"], "q1", ""),
    "no such actuator": (DELTA, ["q1 -1:1:5 deg", "q9 -2:2:5 deg"], "q9", ""),
    "one node": (DELTA, ["x -1:1:1", "y -2:2:5"], "", ""),
    "no unit": (DELTA, ["roll -1:1:3", "y -2:2:5"], "", ""),
    "code": (OCTAHEDRAL, ["__import__('os')", "y -2:2:5"], "", ""),
}


@pytest.mark.parametrize(("source", "over", "message", "hint"), NO_MAP.values(), ids=NO_MAP)
def test_what_is_no_map(page: Page, source: dict[str, str], over: list[str], message: str, hint: str) -> None:
    for do, more in (("map", {}), ("place", {"place": [0, 0]})):
        fault = page.fault(do, source=source, over=over, pose=HOME, **more)
        assert fault["kind"] == "input", fault
        assert message in fault["message"]
        assert hint in fault.get("hint", "")


def test_the_threshold_of_a_map_is_an_angle(page: Page) -> None:
    over = ["x -1:1:5", "y -1:1:5"]
    fault = page.fault("map", source=OCTAHEDRAL, over=over, pose=HOME, threshold="20 mm")
    assert fault["message"] == "in a map the threshold is an angle, not 20 mm"
    assert "2deg" in fault["hint"]


def test_maps_of_too_many_cells_are_refused_at_once(page: Page) -> None:
    for source in (DELTA, OCTAHEDRAL):
        fault = page.fault("map", source=source, over=["x -1:1:500", "y -1:1:500"], pose=HOME)
        assert fault["kind"] == "limit"
        assert "250,000 poses" in fault["message"]
        assert "coarser" in fault["hint"]


def test_a_map_needs_two_coordinates(page: Page) -> None:
    for over in ([], ["x -1:1:5"], ["x -1:1:5", "y -1:1:5", "z -1:1:5"], "x -1:1:5", [1, 2]):
        assert page.fault("map", source=DELTA, over=over, pose=HOME)["kind"] == "input"
    assert page.fault("place", source=DELTA, over=["x -1:1:5", "y -1:1:5"], pose=HOME, place=[1])["kind"] == "input"


def test_a_robot_without_a_home_has_neither(root: Path, page: Page) -> None:
    text = (root / "plugins" / "3-rps" / "robot.yaml").read_text(encoding="utf-8")
    source = {"kind": "file", "text": text.partition("\nhome:")[0] + "\n", "name": "r.yaml"}
    study = page.ask("open", source=source)
    assert study["axes"] == study["ranges"] == []
    for do, args in (
        ("path", {"goal": HOME, "to": "z=1"}),
        ("map", {"pose": HOME, "over": ["z 0:1:3", "roll 0:1:3 deg"]}),
    ):
        fault = page.fault(do, source=source, **args)
        assert fault["kind"] == "input"
        assert "home" in fault["message"] + fault.get("hint", "")


def test_a_degenerate_platform_has_neither(page: Page) -> None:
    source = {"kind": "legs", "legs": "Aa Ab Ac Ad Ae Af"}
    assert page.ask("open", source=source)["ranges"] == []
    assert "singular in every pose" in page.fault("path", source=source, goal=HOME, to="z=1")["message"]
    assert (
        "singular in every pose" in page.fault("map", source=source, pose=HOME, over=["x 0:1:3", "y 0:1:3"])["message"]
    )


def test_a_map_is_cancelled_and_asked_for_again(page: Page) -> None:
    args = {"source": DELTA, "pose": HOME}
    slow = page.send("map", channel="map", over=["x -2:2:81", "y -2:2:81"], **args)
    assert page.ask("cancel", target=slow) == {"cancelled": True}
    assert page.answer(slow)["error"]["kind"] == "cancelled"
    first = page.send("map", channel="map", over=["x -2:2:71", "y -2:2:71"], **args)
    second = page.send("map", channel="map", over=["x -2:2:3", "y -2:2:3"], **args)
    assert len(page.answer(second)["result"]["margin"]) == 3
    assert page.answer(first)["error"]["kind"] == "superseded"


# --- every robot ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("robot", [r.id for r in robots()])
def test_every_robot_has_ranges_of_which_the_first_two_make_a_map(page: Page, robot: str) -> None:
    source = {"kind": "robot", "id": robot}
    ranges = page.ask("open", source=source)["ranges"]
    assert len(ranges) >= 4
    over = [f"{r['name']} {r['low'] / 8}:{r['high'] / 8}:3{' deg' * (r['unit'] == 'deg')}" for r in ranges[:2]]
    found = page.ask("map", source=source, over=over, pose=HOME)
    home = page.ask("pose", source=source, pose=HOME)
    assert found["margin"][1][1] == pytest.approx(home["margin"], rel=1e-3)


# --- working modes -------------------------------------------------------------------------------------------------


def test_modes_are_those_of_gc_working_modes(page: Page) -> None:
    found = page.ask("modes", source=DELTA)
    same = gc.working_modes("delta")
    assert [(m["name"], m["verdict"], m["margin"]) for m in found["modes"]] == [
        (m.name, m.pose.verdict, m.pose.margin) for m in same.modes if m.pose
    ]
    assert (found["number"], found["ways"]) == (8, ["arm 1, arm 2 and arm 3: 2 ways each"])
    assert page.ask("modes", source=DELTA | {"mode": "-+-"}) == found
    assert all(bool(m["svg"]) == (m["verdict"] is not None) for m in found["modes"])
    pictures = [m["svg"] for m in found["modes"] if m["svg"]]
    assert len(set(pictures)) == len(pictures) > 2


def test_a_robot_is_opened_in_a_mode(root: Path, page: Page) -> None:
    text = (root / "plugins" / "delta" / "robot.yaml").read_text(encoding="utf-8")
    for source in (DELTA, {"kind": "file", "text": text, "name": "robot.yaml"}):
        study = page.ask("open", source=source | {"mode": "-+-"})
        assert study["title"] == "Delta robot with rods, working mode -+-"
        there = page.ask("pose", source=source | {"mode": "-+-"}, pose=HOME)
        assert there["margin"] == pytest.approx(gc.pose(gc.load("delta", mode="-+-"), nearest=False).margin, abs=1e-9)


@pytest.mark.parametrize("source", [DELTA | {"mode": "++"}, OCTAHEDRAL], ids=["no mode", "a platform"])
def test_what_has_no_such_mode_is_refused(page: Page, source: dict[str, str]) -> None:
    fault = page.fault("modes" if source is OCTAHEDRAL else "open", source=source)
    assert fault["kind"] == "input"
