"""The studio from Python: both move the same robot."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.studio.protocol.requests import HOME, PoseJson
from gcrules.apps.studio.shared_pose import SharedPose
from gcrules.apps.studio.sources import source_of
from gcrules.apps.studio.subject import read_subject
from gcrules.core.errors import InputError
from gcrules.poses.modes.choose import in_mode
from gcrules.screws.pose import Pose

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

PLATFORM = EXAMPLES / "octahedral.yaml"
SOON = 20.0  # seconds for what comes at once


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path))


def shifted(z: float) -> PoseJson:
    return {"translation": [0.0, 0.0, z], "quaternion": [1.0, 0.0, 0.0, 0.0]}


# --- what is shared ------------------------------------------------------------------------------------------------


def test_a_page_hears_of_others_and_not_of_itself() -> None:
    shared = SharedPose(HOME)

    async def hear() -> list[tuple[int, float, str]]:
        first = await shared.follow(0, "one")
        mine = asyncio.ensure_future(shared.follow(first.version, "one"))
        shared.show(shifted(1), "one")
        await asyncio.sleep(0.05)
        assert not mine.done()
        threading.Thread(target=shared.show, args=(shifted(2),)).start()
        theirs = await asyncio.wait_for(shared.follow(first.version, "two"), SOON)
        later = await asyncio.wait_for(mine, SOON)
        assert theirs.version in (2, 3)
        return [(s.version, s.pose["translation"][2], s.by) for s in (first, later)]

    assert asyncio.run(hear()) == [(1, 0, ""), (3, 2, "")]


def test_python_waits_for_pages_only() -> None:
    shared = SharedPose(HOME)
    shared.show(shifted(1))
    assert shared.wait(0, 0.01) is None
    shared.show(shifted(2), "a page")
    found = shared.wait(0, SOON)
    assert found is not None
    assert found.pose == shifted(2)
    assert shared.wait(found.version, 0.01) is None


def test_a_pose_of_another_robot_is_refused() -> None:
    with pytest.raises(InputError, match="2 actuators, and the robot has 3"):
        SharedPose(HOME, 3).show({**HOME, "coordinates": [0.0, 0.0]}, "a page")


# --- sources -------------------------------------------------------------------------------------------------------

SAME: dict[str, Any] = {
    "a path": PLATFORM,
    "the name of a file": str(PLATFORM),
    "its text": PLATFORM.read_text(encoding="utf-8"),
    "a platform": lambda: gc.load(PLATFORM),
    "its analysis": lambda: gc.analyze(PLATFORM),
}


@pytest.mark.parametrize("source", SAME.values(), ids=SAME)
def test_whatever_names_a_platform_opens_it(source: Any) -> None:
    subject = read_subject(source_of(source() if callable(source) else source))
    expected: Any = gc.load(PLATFORM)
    assert subject.legs is not None
    assert subject.legs.platform.points == expected.points
    assert subject.legs.platform.legs == expected.legs


@pytest.mark.parametrize("make", [lambda: "3-rps", lambda: gc.load("3-rps"), lambda: gc.analyze("3-rps")])
def test_whatever_names_a_robot_opens_it(make: Any) -> None:
    subject = read_subject(source_of(make()))
    assert subject.robot is not None
    robot, expected = subject.robot.robot, gc.load("3-rps")
    assert isinstance(expected, gc.Robot)
    assert (robot.limbs, robot.family, robot.home) == (expected.limbs, expected.family, expected.home)


def test_legs_and_classes_open_with_a_sample_shape() -> None:
    assert source_of("3-3.3") == {"kind": "class", "id": "3-3.3"}
    found = read_subject(source_of(gc.load("ab af cb cd ed ef")))
    assert found.invented
    assert found.structure is not None
    assert found.structure.text() == "ab af cb cd ed ef"


def test_a_robot_in_another_home_than_its_file_is_refused() -> None:
    other = in_mode(gc.load("3-rps"), "assembly 2")
    with pytest.raises(InputError, match="not as in a file of its own"):
        source_of(other)
    assert source_of("3-rps", "assembly 2") == {"kind": "robot", "id": "3-rps", "mode": "assembly 2"}


def test_modes_are_for_robots() -> None:
    with pytest.raises(InputError, match="modes are for robots"):
        source_of("3-3.3", "assembly 2")


# --- the window ----------------------------------------------------------------------------------------------------


def test_a_platform_is_moved_in_all_forms_of_a_pose() -> None:
    with gc.studio(PLATFORM, pose="z=5, roll=10deg", browser=False) as window:
        assert isinstance(window.pose, Pose)
        there = gc.pose(PLATFORM, "z=5, roll=10deg", nearest=False)
        assert isinstance(there, type(window.numbers(nearest=False)))
        assert window.numbers(nearest=False).margin == pytest.approx(there.margin, rel=1e-12)
        for at in ("1 2 3", {"x": 1, "y": 2, "z": 3}, (1, 2, 3), Pose((1, 2, 3))):
            window.pose = at
            assert window.pose == Pose((1, 2, 3))
        with pytest.raises(InputError, match="moves by its pose"):
            _ = window.actuators
        with pytest.raises(InputError):
            window.pose = "z=cat"
        assert window.running
    assert not window.running
    assert "closed" in repr(window)
    assert "closed" in window._repr_html_()


def test_a_robot_of_joints_is_moved_by_its_platform_and_its_actuators() -> None:
    with gc.studio("3-rps", browser=False) as window:
        window.pose = "z=0.2, roll=5deg, pitch=0deg"
        there: Any = gc.pose("3-rps", "z=0.2, roll=5deg, pitch=0deg", nearest=False)
        assert window.pose == pytest.approx({"z": 0.2, "roll": np.radians(5), "pitch": 0}, abs=1e-9)
        here: Any = window.numbers(nearest=False)
        assert here.margin == pytest.approx(there.margin, abs=1e-9)
        assert window.actuators == pytest.approx(dict(here.actuator_values), abs=1e-9)
        wanted = {name: 0.01 * i for i, name in enumerate(window.actuators)}
        window.actuators = wanted
        assert window.actuators == pytest.approx(wanted, abs=1e-12)
        again: Any = gc.pose("3-rps", actuators=wanted, nearest=False)
        assert window.numbers(nearest=False).margin == pytest.approx(again.margin, abs=1e-9)
        before = window.pose
        with pytest.raises(InputError):
            window.pose = "z=50"
        assert window.pose == before


def test_numbers_of_a_sample_shape_are_refused() -> None:
    with gc.studio("ab af cb cd ed ef", browser=False) as window, pytest.raises(InputError, match="sample shape"):
        window.numbers()


def test_a_link_in_a_notebook_lets_in_once_and_holds_no_token(tmp_path: Path) -> None:
    import urllib.error
    import urllib.request

    with gc.studio("3-rps", browser=False) as window:
        link = window._repr_html_().split('href="')[1].split('"')[0]
        token = (tmp_path / "gcrules" / "studio-token").read_text(encoding="ascii").strip()
        assert token not in link
        assert link.startswith("http://127.0.0.1:")

        class Stay(urllib.request.HTTPRedirectHandler):
            def redirect_request(self, *_: Any) -> None:
                return None

        def status() -> int:
            with pytest.raises(urllib.error.HTTPError) as answer:
                urllib.request.build_opener(Stay, urllib.request.ProxyHandler({})).open(link, timeout=SOON)
            answer.value.close()
            return answer.value.code

        assert (status(), status()) == (303, 403)


# --- its page ------------------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def chrome() -> Iterator[Any]:
    pytest.importorskip("playwright", reason="the browser tests need playwright")
    from browsing import chromium

    with chromium() as browser:
        yield browser


POSE = "() => window.gcrules.doc.peek().pose"
SHOWS = "z => window.gcrules && Math.abs(window.gcrules.doc.peek().pose.translation[2] - z) < 1e-9"
OFTEN = 50  # milliseconds: a page behind another one is not drawn, so frames are nothing to wait for
DRIVEN = "q => window.gcrules && Math.abs((window.gcrules.doc.peek().pose.coordinates ?? [0])[0] - q) < 1e-9"


@pytest.mark.browser
def test_the_page_and_python_move_the_same_platform(chrome: Any) -> None:
    with gc.studio(PLATFORM, pose="z=5", browser=False) as window:
        context = chrome.new_context(reduced_motion="reduce")
        page = context.new_page()
        page.set_default_timeout(60_000)
        page.goto(window.link())
        page.get_by_test_id("shared").wait_for()
        page.wait_for_function(SHOWS, arg=5, polling=OFTEN)  # not the home of a page that has just come
        heard: list[Any] = []
        called = threading.Event()
        window.observe(lambda pose: (heard.append(pose), called.set()))
        window.pose = "z=7"
        page.wait_for_function(SHOWS, arg=7, polling=OFTEN)
        assert window.wait(0.1) is None  # what Python has sent does not come back
        page.evaluate("() => window.gcrules.edit({pose: {translation: [1, 0, 0], quaternion: [1, 0, 0, 0]}})")
        assert window.wait(SOON) == Pose((1, 0, 0))
        assert called.wait(SOON)
        assert heard[-1] == window.pose
        other = context.new_page()  # a second page follows the first
        other.goto(window.address)
        other.wait_for_function("() => window.gcrules?.doc.peek().pose.translation[0] === 1", polling=OFTEN)
        page.evaluate("() => window.gcrules.edit({pose: {translation: [0, 0, 3], quaternion: [1, 0, 0, 0]}})")
        other.wait_for_function(SHOWS, arg=3, polling=OFTEN)
        page.reload()
        page.wait_for_function(SHOWS, arg=3, polling=OFTEN)
        page.evaluate("() => window.gcrules.open({kind: 'robot', id: 'delta'})")
        page.get_by_test_id("shared").wait_for(state="detached")
        seen = window.pose
        page.evaluate("() => window.gcrules.edit({pose: {translation: [0, 0, 9], quaternion: [1, 0, 0, 0]}})")
        assert window.wait(0.2) is None or window.pose == seen  # another robot's pose is its own
        context.close()


@pytest.mark.browser
def test_the_page_and_python_move_the_same_robot_of_joints(chrome: Any) -> None:
    with gc.studio("3-rps", browser=False) as window:
        page = chrome.new_context(reduced_motion="reduce").new_page()
        page.goto(window.link())
        page.get_by_test_id("shared").wait_for()
        first = next(iter(window.actuators))
        window.actuators = {**window.actuators, first: 0.05}
        page.wait_for_function(DRIVEN, arg=0.05)
        page.evaluate(
            "() => window.gcrules.edit({pose: {...window.gcrules.doc.peek().pose, coordinates: [0.02, 0, 0]}})"
        )
        assert window.wait(SOON) is not None
        assert window.actuators[first] == pytest.approx(0.02)
        page.context.close()
