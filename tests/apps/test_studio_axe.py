"""The page under axe: no findings in any panel, in both themes, wide and on a phone."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytestmark = pytest.mark.browser

WIDTHS = {"wide": {"width": 1280, "height": 800}, "phone": {"width": 390, "height": 844}}
PANELS = ("manual", "motion", "where", "bench", "draw", "take-away", "project")
TABS = ("tab-way", "tab-readings", "tab-actuators")
WINDOWS = ("Control+k", "?")


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    from browsing import chromium
    from studio_page import CALM, WIDE, Desk, studio

    with chromium() as browser, studio(Path(tmp_path_factory.mktemp("studio"))) as server:
        yield Desk(browser.new_page(viewport=WIDE, **CALM), server).visit()


def findings(desk: Any, where: str) -> list[str]:
    from axe_playwright_python.sync_playwright import Axe

    desk.painted()
    found = Axe().run(desk.page).response["violations"]
    return [f"{where}: {v['id']}, {[n['target'] for n in v['nodes']][:3]}" for v in found]


OCTAHEDRAL, DELTA = ("example", "octahedral"), ("robot", "delta")


@pytest.mark.parametrize(
    ("theme", "width", "robots"),
    [("light", "wide", (OCTAHEDRAL, DELTA)), ("dark", "wide", (DELTA,)), ("light", "phone", (OCTAHEDRAL,))],
)
def test_axe_finds_nothing(desk: Any, theme: str, width: str, robots: tuple[tuple[str, str], ...]) -> None:
    desk.page.set_viewport_size(WIDTHS[width])
    desk.run("theme => void (gcrules.taste.chosen.value = theme)", theme)
    desk.run("gcrules.go({panel: 'start'})")
    found = findings(desk, "start")
    for kind, name in robots:
        desk.open(kind, name, "check")
        for tab in TABS:
            desk.one(tab).click()
            found += findings(desk, f"{name}, {tab}")
        for panel in PANELS:
            desk.run("panel => gcrules.go({panel})", panel)
            desk.page.wait_for_function("panel => gcrules.panel$.value === panel", arg=panel)
            found += findings(desk, f"{name}, {panel}")
        for keys in WINDOWS:
            desk.page.keyboard.press(keys)
            desk.page.locator("dialog[open]").wait_for()
            found += findings(desk, f"{name}, {keys}")
            desk.page.keyboard.press("Escape")
            desk.page.locator("dialog[open]").wait_for(state="detached")
    assert found == []


RULES = "rule pierce: ab /\\ cde => [acde] b - [bcde] a\nrule wrong: ab /\\ cd => [abdc]\n"
BENCH = "let p = ab /\\ cde\nrewrite p\n[abcd] == [bacd]\n:analyze Aa Ab Ac Ba Bd Ce"


@pytest.mark.parametrize(("theme", "width"), [("light", "wide"), ("dark", "phone")])
def test_axe_finds_nothing_on_a_full_bench(desk: Any, theme: str, width: str) -> None:
    desk.page.set_viewport_size(WIDTHS[width])
    desk.run("theme => void (gcrules.taste.chosen.value = theme)", theme)
    desk.open(*OCTAHEDRAL)
    rules = [{"name": "mine.gca", "text": RULES, "off": []}]
    desk.run("([bench, rules]) => gcrules.edit({panel: 'bench', bench, rules})", [BENCH, rules])
    desk.one("bench-applied").nth(1).wait_for()
    desk.one("bench-repeat").nth(1).click()
    desk.one("bench-more").last.click()
    if desk.one("bench-rules").get_attribute("open") is None:
        desk.one("bench-rules-open").click()
    desk.one("plugin-legs-meet").wait_for()
    desk.one("rule-wrong").locator("mark").wait_for()
    assert findings(desk, f"bench, {theme}, {width}") == []
    assert desk.run("document.documentElement.scrollWidth") <= WIDTHS[width]["width"]
