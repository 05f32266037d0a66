"""The studio in Firefox: the same page, looked at where the browsers differ most."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

if TYPE_CHECKING:
    from firefox import Tab

pytestmark = pytest.mark.needs("firefox-esr")

ANSWERED = "gcrules.posing.numbers.value && gcrules.study.value"
HARMLESS = ("WEBGL_debug_renderer_info", "GPU stall", "WebGL warning")


@pytest.fixture(scope="module")
def tab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tab]:
    from firefox import firefox
    from studio_page import studio

    folder = tmp_path_factory.mktemp("firefox")
    with studio(folder / "state") as server, firefox(folder / "profile") as page:
        page.visit(server.address)
        page.wait("document.querySelector('[data-testid=line][data-line=open]') !== null")
        yield page
        assert [fault for fault in page.faults if not any(words in fault for words in HARMLESS)] == []


def opened(tab: Tab, kind: str, name: str) -> None:
    key = "name" if kind == "example" else "id"
    tab.run(f"(gcrules.open({{kind: '{kind}', {key}: '{name}'}}), 0)")
    tab.wait("gcrules.loaded.value.state === 'ready'")
    tab.wait(f"!!({ANSWERED})")


def test_a_singularity_on_the_way_is_found(tab: Tab) -> None:
    opened(tab, "example", "octahedral")
    assert tab.run("document.querySelector('[data-testid=verdict]').dataset.verdict") == "regular"
    slide = """(slider => { slider.value = '-490'; slider.dispatchEvent(new Event('input', {bubbles: true}));
        slider.dispatchEvent(new PointerEvent('pointerup', {bubbles: true})); })"""
    tab.run(f"({slide}(document.querySelector('[data-testid=slider-z]')), 0)")
    tab.wait("gcrules.timeline.proof.value?.places.length === 3")
    tab.wait("document.querySelector('[data-testid=way][data-proved=true]') !== null")


def test_the_picture_is_drawn_and_a_joint_is_dragged(tab: Tab, tmp_path: Path) -> None:
    opened(tab, "robot", "3-rps")
    tab.click("panel-dimensions")
    tab.wait("document.querySelector('[data-testid=plan]') !== null")
    x, y = tab.wait("gcrules.space.viewer.value?.gripAt('joint S1')")
    corner = "(box => [box.left, box.top])(document.querySelector('[data-testid=viewer]').getBoundingClientRect())"
    left, top = tab.run(corner)
    tab.drag((left + x, top + y), 16, -30)
    assert tab.wait("gcrules.study.value.points.S1[2] > 2 && gcrules.study.value.points.S1")[1] == 0
    tab.picture(tmp_path / "firefox.png")
    assert (tmp_path / "firefox.png").stat().st_size > 20_000


def test_a_map_is_drawn_and_the_bench_answers(tab: Tab) -> None:
    opened(tab, "example", "octahedral")
    tab.click("panel-motion")
    tab.click("map-go")
    tab.wait("document.querySelector('[data-testid=map-picture] canvas')?.width > 20")
    tab.wait("document.querySelector('[data-testid=map-guarantee]') !== null")
    tab.click("panel-bench")
    tab.run("(gcrules.edit({bench: 'prove [abcd] == -[abdc]'}), 0)")
    tab.wait("document.querySelector('[data-testid=bench-result][data-verdict=proved]') !== null")
