"""A robot with limbs led by its platform: the actuators follow, by sliders, handles and keys."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gcrules as gc
from gcrules.apps.studio.moving import actuator_axes, displaced, displacement, freedom_axes
from gcrules.apps.studio.numbers import numbers
from gcrules.apps.studio.protocol.requests import FARTHEST, HOME, RobotSource
from gcrules.apps.studio.subject import Subject, read_subject
from gcrules.apps.studio.whereabouts import moved_view, solved_at
from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

from apps.studio_client import Page

FREEDOMS: dict[str, tuple[str, ...]] = {
    "delta": ("x", "y", "z"),
    "3-rps": ("z", "roll", "pitch"),
    "4-ruu": ("x", "y", "z", "yaw"),
    "agile-eye": ("roll", "pitch", "yaw"),
    "capaman": ("x", "y", "pitch"),
    "3-rpr": ("x", "y", "yaw"),
    "6-rus": ("x", "y", "z", "roll", "pitch", "yaw"),
    "h4": ("x", "y", "z", "yaw"),
}


def opened(robot: str) -> tuple[Subject, Limbs]:
    source: RobotSource = {"kind": "robot", "id": robot}
    subject = read_subject(source)
    assert subject.limbs is not None
    return subject, subject.limbs


@pytest.mark.parametrize(("robot", "names"), FREEDOMS.items(), ids=FREEDOMS)
def test_the_actuators_follow_the_platform(robot: str, names: tuple[str, ...]) -> None:
    """Step by step as a hand moves; `gc.pose` closes the loops from home to the same coordinates."""
    subject, limbs = opened(robot)
    assert tuple(a["name"] for a in freedom_axes(limbs, subject.size)) == names
    goal = [4.0 if n in ("roll", "pitch", "yaw") else 0.04 * limbs.linkage.size for n in names]
    pose = HOME
    for part in (0.4, 0.7, 1.0):
        pose = moved_view(subject, pose, [part * v for v in goal], None)["pose"]
    found = numbers(subject, pose)
    assert found["freedoms"] == pytest.approx(goal, abs=1e-6)
    at = {n: np.radians(v) if n in ("roll", "pitch", "yaw") else v for n, v in zip(names, goal, strict=True)}
    assert found["margin"] == pytest.approx(gc.pose(robot, at, nearest=False).margin, abs=1e-8)


@pytest.mark.parametrize("robot", ["delta", "3-rps", "6-rus", "agile-eye"])
def test_the_platform_is_where_it_says(robot: str) -> None:
    """A displacement leads back to itself, and what a robot has no freedom for is left out."""
    subject, limbs = opened(robot)
    m = limbs.linkage
    pose = moved_view(subject, HOME, [0.05] * m.robot.mobility, None)["pose"]
    there = numbers(subject, pose)["platform"]
    assert there is not None
    here = solved_at(limbs, pose)
    assert np.abs(displaced(m, there, subject.about) - here.platform).max() < 1e-9
    assert displacement(m, here.platform, subject.about) == there
    again = moved_view(subject, HOME, None, there)["pose"]["coordinates"]
    assert again == pytest.approx(pose["coordinates"], abs=1e-9)


def test_where_a_platform_cannot_be_led() -> None:
    subject, _ = opened("delta")
    with pytest.raises(InputError, match="was not followed"):
        moved_view(subject, HOME, [9.0, 0.0, 0.0], None)
    with pytest.raises(InputError, match="3 freedoms: x, y, z"):
        moved_view(subject, HOME, [1.0], None)
    with pytest.raises(InputError, match="either coordinates or a pose"):
        moved_view(subject, HOME, None, None)
    legs = read_subject({"kind": "example", "name": "octahedral"})
    with pytest.raises(InputError, match="six legs"):
        moved_view(legs, HOME, [0.0], None)


def test_the_page_asks_for_it(page: Page) -> None:
    source = {"kind": "robot", "id": "delta"}
    study = page.ask("open", source=source)
    assert [a["name"] for a in study["freedoms"]] == ["x", "y", "z"]
    pose = page.ask("move", source=source, pose=HOME, at=[0.2, 0.0, 0.0])["pose"]
    found = page.ask("pose", source=source, pose=pose)
    assert found["freedoms"] == pytest.approx([0.2, 0.0, 0.0], abs=1e-9)
    assert page.fault("move", source=source, pose=HOME, at=[])["kind"] == "input"
    assert page.ask("open", source={"kind": "example", "name": "octahedral"})["freedoms"] == []


# --- actuators at a pose ---------------------------------------------------------------------------------------------


def test_legs_with_their_lengths_limits_and_what_they_make(root: Path) -> None:
    text = (root / "examples" / "octahedral.yaml").read_text("utf-8") + "\nlimits: ab 350..420, af ..500\n"
    subject = read_subject({"kind": "file", "text": text, "name": "octahedral.yaml"})
    found = numbers(subject, HOME | {"translation": [10.0, 20.0, 30.0]})
    same = gc.pose(gc.load(text), "10 20 30", nearest=False).jacobian
    legs = subject.points
    moved = {n: np.add(legs[n], [10, 20, 30]) for n in "bdf"}
    for a in found["actuators"]:
        base, end = sorted(a["name"], key=lambda n: n in moved)
        assert a["value"] == pytest.approx(np.linalg.norm(moved[end] - np.array(legs[base], dtype=float)))
    by = {a["name"]: a for a in found["actuators"]}
    assert [(by[n]["low"], by[n]["high"]) for n in ("ab", "af", "cb")] == [(350, 420), (0, 500), (0, None)]
    assert f"{same.amplification.speeds[0]:.4g}" in by["ab"]["speed"]
    assert f"condition number {same.condition_number:.4g}" in found["jacobian"][0]["value"]


def test_actuators_with_their_amounts_and_limits(root: Path) -> None:
    text = (root / "plugins" / "delta" / "robot.yaml").read_text("utf-8") + "\nlimits: q1 -20..35 deg\n"
    subject = read_subject({"kind": "file", "text": text, "name": "robot.yaml"})
    assert subject.limbs is not None
    first, second, _ = actuator_axes(subject.limbs, subject.size)
    assert (first["low"], first["high"]) == pytest.approx((-20, 35))
    assert (second["low"], second["high"]) == (-30, 30)
    found = numbers(subject, HOME | {"coordinates": [5.0, -3.0, 2.0]})["actuators"]
    assert [a["value"] for a in found] == pytest.approx([5, -3, 2])
    assert [a["unit"] for a in found] == ["deg"] * 3
    assert (found[0]["low"], found[0]["high"], found[1]["low"]) == (pytest.approx(-20), pytest.approx(35), None)


# --- in the browser --------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    from browsing import chromium
    from studio_page import CALM, WIDE, Desk, studio

    with chromium() as browser, studio(Path(tmp_path_factory.mktemp("studio"))) as server:
        yield Desk(browser.new_page(viewport=WIDE, **CALM), server).visit()


def wait_for(desk: Any, index: int, value: float) -> None:
    there = f"(gcrules.posing.numbers.value?.freedoms ?? [])[{index}]"
    desk.page.wait_for_function(f"() => Math.abs({there} - {value}) < 1e-6")


@pytest.mark.browser
def test_sliders_of_the_platform(desk: Any) -> None:
    desk.open("robot", "3-rps", "check")
    desk.one("led").select_option("platform")
    desk.slide("roll", 5)
    wait_for(desk, 1, 5)
    desk.slide("z", 0.1)
    wait_for(desk, 0, 0.1)
    desk.let_go("z")
    assert desk.numbers["freedoms"] == pytest.approx([0.1, 5, 0], abs=1e-6)
    assert len(desk.pose["coordinates"]) == 3
    assert any(desk.pose["coordinates"])
    assert desk.faults == []


@pytest.mark.browser
def test_a_platform_that_cannot_be_led_stays(desk: Any) -> None:
    desk.open("robot", "delta", "check")
    desk.one("led").select_option("platform")
    desk.slide("y", 0.1)
    wait_for(desk, 1, 0.1)
    desk.one("slider-x-number").fill("9")
    desk.one("slider-x-number").press("Enter")
    desk.one("fault").wait_for()
    assert "was not followed" in desk.text("fault")
    assert desk.numbers["freedoms"] == pytest.approx([0, 0.1, 0], abs=1e-6)
    desk.slide("y", 0.05)
    wait_for(desk, 1, 0.05)
    desk.one("fault").wait_for(state="detached")
    assert desk.faults == []


@pytest.mark.browser
def test_handles_and_keys_move_a_robot_with_limbs(desk: Any) -> None:
    desk.open("robot", "delta", "check")
    desk.one("led").select_option("platform")
    desk.one("mode-translate").click()
    step = desk.study["size"] / 100
    desk.page.locator("[data-testid=viewer] [tabindex]").first.focus()
    desk.page.keyboard.press("ArrowRight")
    wait_for(desk, 0, step)
    desk.page.keyboard.press("PageDown")
    wait_for(desk, 2, -step)
    desk.run("gcrules.undo()")  # before the key counts as at rest, too
    wait_for(desk, 2, 0)
    desk.page.wait_for_timeout(400)
    assert desk.numbers["freedoms"][2] == pytest.approx(0, abs=1e-6)
    desk.one("mode-orbit").click()
    assert desk.faults == []


@pytest.mark.browser
def test_an_answer_that_comes_after_undo_is_not_wanted(desk: Any) -> None:
    desk.open("robot", "3-rps", "check")
    desk.one("led").select_option("platform")
    desk.slide("z", 0.1)
    wait_for(desk, 0, 0.1)
    desk.let_go("z")
    desk.run("() => { gcrules.leading.set(0, 0.2); gcrules.undo(); }")
    wait_for(desk, 0, 0)
    desk.slide("roll", 2)  # its answer comes after that of the move that was undone
    wait_for(desk, 1, 2)
    assert desk.numbers["freedoms"] == pytest.approx([0, 2, 0], abs=1e-6)
    assert desk.faults == []


@pytest.mark.browser
def test_the_table_of_actuators(desk: Any, root: Path) -> None:
    text = (root / "examples" / "octahedral.yaml").read_text("utf-8") + "\nlimits: ab 350..420\n"
    desk.run("text => gcrules.open({kind: 'file', text, name: 'octahedral.yaml'})", text)
    desk.page.wait_for_function("() => gcrules.loaded.value.state === 'ready'")
    desk.answered()
    desk.step("check")
    desk.one("tab-actuators").click()
    assert desk.text("reach") == "Beyond the limits of the file: ab by 10.12 mm."
    assert desk.page.locator("[data-testid=actuators] tbody tr").count() == 6
    assert desk.page.locator("[data-testid=actuators] tr.beyond th").all_inner_texts() == ["ab"]
    desk.slide("z", -30)
    desk.answered()
    desk.page.wait_for_function("() => document.querySelector('[data-testid=reach]').innerText.startsWith('All legs')")
    desk.open("robot", "delta", "check")
    desk.one("tab-actuators").click()
    assert desk.text("reach") == "The file says nothing about what actuators reach."
    assert desk.faults == []


@pytest.mark.browser
def test_a_number_beyond_all_poses_is_refused_at_its_field(desk: Any) -> None:
    """The field keeps the number that it had and says why; it takes the next one."""
    desk.open("example", "octahedral")
    field = desk.one("slider-x-number")
    assert desk.run("gcrules.pose$.value.translation") == [0, 0, 0]
    for typed in ("1e300", "-1e15"):
        field.fill(typed)
        field.press("Enter")
        assert float(field.input_value()) == 0
        assert "too large" in field.evaluate("e => e.validationMessage")
    assert f"{FARTHEST:,.0f}".replace(",", " ") in field.evaluate("e => e.validationMessage")
    assert desk.run("gcrules.pose$.value.translation") == [0, 0, 0]
    field.fill("9")
    field.press("Enter")
    desk.page.wait_for_function("() => gcrules.pose$.value.translation[0] === 9")
    assert field.evaluate("e => e.validationMessage") == ""
