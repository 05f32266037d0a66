"""The words of the studio: every term of the glossary says what it means, to mouse, keyboard and touch."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

from studio_page import TIMEOUT, Desk

pytestmark = pytest.mark.browser


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down().visit()


def word(desk: Desk, term: str) -> Any:
    return desk.page.locator(f"[data-term='{term}']").first


@pytest.mark.parametrize(("kind", "name"), [("example", "octahedral"), ("robot", "delta")])
def test_words_by_mouse_and_keyboard(desk: Desk, kind: str, name: str) -> None:
    desk.open(kind, name, "superbracket")
    tip = desk.one("term-tip")
    word(desk, "superbracket").hover()
    tip.wait_for()
    assert "determinant of six lines" in tip.inner_text()
    assert "In the guide: Superbracket" in tip.inner_text()
    tip.hover()  # it stays while it is read
    desk.page.wait_for_timeout(400)
    assert tip.is_visible()
    desk.page.mouse.move(2, 400)
    tip.wait_for(state="detached")
    word(desk, "margin").focus()
    desk.page.keyboard.press("Shift+Tab")
    desk.page.keyboard.press("Tab")
    tip.wait_for()
    assert word(desk, "margin").get_attribute("aria-describedby") == "term-tip"
    desk.page.keyboard.press("Escape")
    tip.wait_for(state="detached")
    word(desk, "value").click()
    assert "divided by its scale" in tip.inner_text()
    box, size = tip.bounding_box(), desk.page.viewport_size
    assert 0 <= box["x"] <= size["width"] - box["width"]
    assert 0 <= box["y"] <= size["height"] - box["height"]
    desk.one("term-more").click()
    wanted = desk.page.locator("[data-wanted=true] dt")
    assert wanted.inner_text() == "value"
    desk.page.locator("[data-testid=entry-value] button.term").first.click()
    desk.page.wait_for_function("() => document.querySelector('[data-wanted=true] dt').innerText === 'superbracket'")
    desk.one("glossary-search").fill("elbows")
    assert desk.page.locator(".glossary dt").all_inner_texts() == ["working mode"]
    desk.one("glossary-close").click()
    assert desk.faults == []


REACHED = """() => { const terms = [...document.querySelectorAll("button.term")];
  const selectors = rules => [...rules].flatMap(rule => rule.selectorText?.split(/,(?![^(]*\\))/)
    ?? selectors(rule.cssRules ?? []));
  return [...document.styleSheets].flatMap(sheet => selectors(sheet.cssRules)).map(one => one.trim())
    .filter(one => / button/.test(one) && !one.includes(".term") && terms.some(term => term.matches(one))); }"""
"""Rules for the buttons of some place that reach words too."""


def test_a_word_is_set_like_its_sentence(desk: Desk) -> None:
    """In lists that have buttons too; and the sign after it stays in its line."""
    desk.open("example", "octahedral")
    desk.slide("z", -400)
    desk.let_go("z")
    desk.page.locator(".crossings button.term").first.wait_for()
    assert (
        desk.run(
            """[...document.querySelectorAll('button.term')].filter(word => {
            const own = getComputedStyle(word), around = getComputedStyle(word.parentElement);
            return own.fontSize !== around.fontSize || own.padding !== '0px' || own.color !== around.color;
        }).map(word => word.textContent)"""
        )
        == []
    )
    for stage in ("structure", "condition", "statement", "check"):
        desk.step(stage)
        assert desk.run(REACHED) == []
    desk.open("robot", "3-rps", "limbs")
    assert desk.run(REACHED) == []
    signs = desk.page.locator(".stage .term-and-sign", has_text="wrenches")
    assert signs.first.inner_text() == "wrenches."
    for width in range(380, 460, 8):
        desk.page.set_viewport_size({"width": width, "height": 740})
        assert len(signs.first.evaluate("one => [...new Set([...one.getClientRects()].map(r => r.bottom))]")) == 1


def test_words_by_touch(desk: Desk) -> None:
    context = desk.page.context.browser.new_context(
        viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True, reduced_motion="reduce"
    )
    try:
        phone = Desk(context.new_page(), desk.server).visit().open("robot", "delta", "limbs")
        phone.page.set_default_timeout(TIMEOUT)
        phone.page.locator("[data-term]").first.tap()
        tip = phone.one("term-tip")
        tip.wait_for()
        box = tip.bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= 390
        phone.page.touchscreen.tap(200, 20)
        tip.wait_for(state="detached")
    finally:
        context.close()


@pytest.mark.parametrize("touch", [False, True])
def test_the_page_of_the_guide_is_a_link_where_the_guide_is_there(desk: Desk, touch: bool) -> None:
    context = desk.page.context.browser.new_context(has_touch=touch, reduced_motion="reduce")
    try:
        phone = Desk(context.new_page(), desk.server).visit().open("example", "octahedral", "superbracket")
        link = phone.one("guide-link")
        for there in (False, True):
            phone.run("there => gcrules.front.guide.value = there", there)
            term = word(phone, "superbracket")
            term.tap() if touch else term.click()
            phone.one("term-tip").wait_for()
            assert link.count() == there
            assert "In the guide: Superbracket" in phone.one("term-tip").inner_text()
            phone.page.keyboard.press("Escape")
            phone.one("term-tip").wait_for(state="detached")
        term.tap() if touch else term.click()
        assert link.get_attribute("href") == "guide/course/superbracket.html"
        with context.expect_page() as opened:
            link.tap() if touch else link.click()
        assert opened.value.url.endswith("/guide/course/superbracket.html")
    finally:
        context.close()


def test_an_entity_is_named_as_in_its_condition(sit_down: Callable[..., Desk]) -> None:
    """Stars stand in the steps that find it, where one point stands in several brackets."""
    desk = sit_down().visit().open("example", "octahedral", "condition")
    desk.painted()
    page, names = desk.page, ["abc", "bdf", "cde", "aef"]
    assert page.locator("#content .chip .math").all_inner_texts() == names
    assert page.locator(".legend .chip .math").all_inner_texts() == names
    assert "*" not in desk.text("viewer")
    assert "*" in "".join(desk.step("planes").locator(".chip .math").all_inner_texts())
    desk.painted()
    assert page.locator(".legend .chip .math").all_inner_texts() == names[:3]
    assert "*" not in desk.text("viewer")
