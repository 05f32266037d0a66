"""The report of a robot as it stands in the studio: one page that loads nothing, and says what the library says."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Callable
from html import escape, unescape
from html.parser import HTMLParser
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from places import EXAMPLES

import gcrules as gc

if TYPE_CHECKING:
    from apps.studio_client import Page
    from studio_page import Desk

from gcrules.views.numerals import in_prose

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

OCTAHEDRAL = {"kind": "example", "name": "octahedral"}
ROBOT_OF_LEGS = {"kind": "robot", "id": "octahedral"}
THREE_RPS = {"kind": "robot", "id": "3-rps"}
FOUR_DOF = {"kind": "robot", "id": "gallardo-4dof"}
SHAPE = {"kind": "class", "id": "3-3.3"}
HOME = {"translation": [0, 0, 0], "quaternion": [1, 0, 0, 0]}
MOVED = {"translation": [12.5, 0, -30], "quaternion": [1, 0, 0, 0]}
LOW = {"translation": [0, 0, -490], "quaternion": [1, 0, 0, 0]}
LINK = "http://127.0.0.1:8747/#s=eyJwYW5lbCI6ImJlbmNoIn0"
PIXEL = "data:image/png;base64," + b64encode(b"\x89PNG\r\n\x1a\n").decode()
TITLES = {"path": "The way", "map": "The map", "surface": "The surface", "locus": "The formula"}
HOSTILE = "</style></script><img src=x onerror=alert(1)><b>&"


def driven(*amounts: float) -> dict[str, Any]:
    return HOME | {"coordinates": list(amounts)}


def state(*answers: tuple[str, dict[str, Any]], **more: Any) -> dict[str, Any]:
    asked = [{"title": TITLES.get(what, what), "what": what, "args": args} for what, args in answers]
    return {"answers": asked, "picture": "", "notes": [], "link": ""} | more


def saved(page: Page, source: Any, pose: Any, *answers: tuple[str, dict[str, Any]], **more: Any) -> str:
    """The page; what is wrong with every report is asserted here."""
    found = str(page.ask("save", source=source, pose=pose, what="html", state=state(*answers, **more))["data"])
    assert_stands_alone(found)
    return found


class Loads(HTMLParser):
    """Whatever an element of a page could load, and where it leads to."""

    def __init__(self) -> None:
        super().__init__()
        self.loads: list[str] = []
        self.leads: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            assert not name.startswith("on"), (tag, name)
            if name == "href" and tag == "a":
                self.leads.append(value or "")
            elif name in ("src", "href", "srcset", "data", "action") and not (value or "").startswith(("data:", "#")):
                self.loads.append(f"{tag} {name}={value}")
        assert tag not in ("link", "iframe", "object", "embed", "base", "form")


def assert_stands_alone(html: str) -> None:
    assert re.search(r'http-equiv="Content-Security-Policy" content="default-src \'none\';', html)
    reader = Loads()
    reader.feed(html)
    assert reader.loads == []
    assert all(lead.startswith(("data:", "#", "http://127.0.0.1:")) for lead in reader.leads)


def text_of(html: str) -> str:
    """What is read, without elements; spaces run together."""
    body = re.sub(r"<(script|style|svg)\b.*?</\1>", " ", html, flags=re.DOTALL)
    return re.sub(r"\s+", " ", unescape(re.sub(r"<[^>]*>", " ", body)))


def test_a_platform_with_the_answers_of_its_panels(page: Page) -> None:
    over, box = ["x -200:200:9", "y -200:200:9"], ["x -200:200:5", "y -200:200:5", "z -300:300:5"]
    html = saved(
        page, OCTAHEDRAL, MOVED,
        ("path", {"start": HOME, "through": [], "goal": LOW}),
        ("map", {"over": over, "pose": MOVED}),
        ("surface", {"over": box, "pose": MOVED}),
        ("locus", {"pose": MOVED}),
        ("actuators", {"pose": MOVED}),
        picture=PIXEL, link=LINK, notes=[{"title": "Rig 2", "text": "bolted\nsince May"}],
    )  # fmt: skip
    words = text_of(html)
    robot = gc.load(EXAMPLES / "octahedral.yaml")
    here = gc.pose(robot, "12.5 0 -30", nearest=False)
    assert f"σ = {here.margin:.4g} " in words
    assert here.reason in words
    for leg, length in here.actuator_values.items():
        assert f" {leg} {length:.4g} mm " in words
    assert all(f"{r.value:.4g}" in words for r in here.readings if r.value)

    way = gc.path(robot, ["0 0 0", "0 0 -490"])
    assert words.count("The way ") >= 1
    assert len(way.zeros) == 3
    assert all(f"{z.parameter:.6g}" in words for z in way.zeros)
    assert gc.singular_map(robot, over, at="12.5 0 -30").guarantee[1:] in words
    assert "Map over x, y and z" in words
    assert str(gc.locus(robot, "translation", at="12.5 0 -30").form) in words

    assert f'<a href="{LINK}">' in html
    assert f'src="{PIXEL}"' in html
    assert "Rig 2 bolted since May" in words
    repeat = page.ask("repeat", source=OCTAHEDRAL, what="map", args={"source": OCTAHEDRAL, "over": over, "pose": MOVED})
    assert repeat["shell"] in words
    assert repeat["python"].split("\n")[-1] in words
    assert repeat["files"][0]["name"] in words


def test_a_robot_of_joints(page: Page) -> None:
    pose, goal = driven(0.05, 0.1, -0.02), driven(0.3, 0.1, 0.2)
    over = ["z -0.3:0.3:7", "roll -30:30:7 deg"]
    html = saved(
        page, THREE_RPS, pose,
        ("path", {"goal": goal, "way": "around"}),
        ("map", {"over": over, "pose": HOME}),
        ("locus", {"pose": HOME, "over": ["z"]}),
    )  # fmt: skip
    words = text_of(html)
    here = gc.pose("3-rps", actuators="q1=0.05, q2=0.1, q3=-0.02", nearest=False)
    assert f"σ = {here.margin:.4g} " in words
    assert all(in_prose(f" {name} {value:.4g} ") in words for name, value in here.actuator_values.items())
    assert all(in_prose(f" {f.value:.4g} ") in words for f in here.factors)
    assert "The straight way is free of singular poses, proved" in words
    assert gc.singular_map("3-rps", over).guarantee[1:] in words
    assert all(str(part.form) in words for part in gc.locus("3-rps", "z").parts)
    assert '"start":{"drive":[0.05,0.1,-0.02]}' in html


def test_where_a_robot_cannot_be_set_the_report_says_so(page: Page) -> None:
    with pytest.raises(gc.InputError, match="was not followed"):
        gc.pose("3-rps", actuators="q1=0.1, q2=-0.5, q3=0.2", nearest=False)
    words = text_of(saved(page, THREE_RPS, driven(0.1, -0.5, 0.2)))
    part = words.partition("In this pose")[2][:200]
    assert part.startswith(" No numbers")
    assert "was not followed" in part


@pytest.mark.parametrize(("source", "pose"), [(ROBOT_OF_LEGS, HOME), (FOUR_DOF, HOME), (SHAPE, HOME)], ids=str)
def test_it_is_that_of_the_command_in_another_pose(page: Page, source: Any, pose: Any) -> None:
    """The same steps; legs whose joints have a shape that was made up have their numbers too."""
    words = text_of(saved(page, source, pose))
    report = text_of(gc.report(gc.load(source["id"])))
    steps = report[report.index("Step by step") : report.rindex("gcrules")]
    assert steps in words
    assert re.search(r"σ = [0-9.]+ |Numbers", words) or source is FOUR_DOF


def test_what_is_found_where_is_a_section_too(page: Page) -> None:
    ranges = {"over": ["x -20:20", "y -20:20"], "pose": HOME, "boxes": 200}
    html = saved(
        page, OCTAHEDRAL, HOME,
        ("assemblies", {"pose": HOME}),
        ("free", {"pose": HOME, "shape": "box"}),
        ("boxes", ranges),
        ("certify", ranges),
        ("manual", {"commands": ["plane a b c"]}),
        ("bench", {"text": "ab /\\ cde"}),
    )  # fmt: skip
    words = text_of(html)
    for heading in (
        "Assembly modes",
        "A box free of singular poses",
        "Whole ranges of x and y",
        "A certificate over x",
    ):
        assert heading in words
    assert '--propose "plane a b c"' in words
    assert "ab /\\ cde" in words


def test_the_bench_is_there_with_its_answers(page: Page) -> None:
    """As the bench gives them, in both kinds of report."""
    text = "# mine 𝑥\nlet p = ab /\\ cde\n[abcd] == [bacd]\nrewrite ab /\\ cd\n# last\n"
    rules = [{"name": "mine.gca", "text": 'rule turn "two lines": ab /\\ cd => [abcd]', "off": []}]
    for source in (OCTAHEDRAL, THREE_RPS):
        results = page.ask("bench", text=text, rules=rules, source=source, pose=HOME)["results"]
        words = text_of(saved(page, source, HOME, ("bench", {"text": text, "rules": rules})))
        there = words.partition(" On the bench ")[2].partition(" Repeat it ")[0]
        assert there.startswith("# mine 𝑥 let p = ab /\\ cde ")
        assert there.rstrip().endswith("# last")
        assert [r["verdict"] for r in results] == ["value", "refuted", "value"]
        for result in results:
            assert " ".join(result["text"].split()[:12]) in there
        assert there.count("Refuted") == 1
        assert there.index("Refuted") > there.index("[abcd] == [bacd]")
    words = text_of(saved(page, OCTAHEDRAL, HOME, ("bench", {"text": "[abcd] == -[bacd]\n[abc <b>"})))
    assert "[abcd] == -[bacd] Proved" in words
    assert "[abc <b> At fault line 2:" in words
    assert "On the bench" not in text_of(saved(page, OCTAHEDRAL, HOME))


def test_hostile_names_do_nothing(page: Page) -> None:
    text = (EXAMPLES / "octahedral.yaml").read_text(encoding="utf-8")
    text = re.sub("^title:.*$", f"title: '{HOSTILE}'", text, flags=re.MULTILINE)
    source = {"kind": "file", "text": text, "name": f"{HOSTILE}.yaml"}
    asked = {"title": HOSTILE, "what": "path", "args": {"start": HOME, "goal": LOW}}
    html = saved(page, source, HOME, answers=[asked], notes=[{"title": HOSTILE, "text": HOSTILE}], picture=PIXEL)
    assert "<img src=x" not in html
    assert html.count(escape(HOSTILE)) >= 4


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ({"link": "javascript:alert(1)"}, "not an address of a state"),
        ({"link": 'http://127.0.0.1/#s=a"onclick=x'}, "not an address of a state"),
        ({"picture": "https://example.org/a.png"}, "not a picture"),
        ({"picture": "data:text/html;base64,AAAA"}, "not a picture"),
        ({"picture": f"data:image/png;base64,{b64encode(b'x' * 400_000).decode()}"}, "400,000"),
        ({"answers": [{"title": "t", "what": "open", "args": 3}]}, "not an object"),
        ({"answers": [{"title": "t", "what": "map", "args": {"over": ["x"]}}]}, "args of map"),
        ({"answers": [{"title": "t", "what": "rm", "args": {}}]}, "expected one of"),
    ],
)
def test_states_at_fault(page: Page, fields: dict[str, Any], words: str) -> None:
    fault = page.fault("save", source=OCTAHEDRAL, pose=HOME, what="html", state=state(**fields))
    assert fault["kind"] == "input"
    assert words in fault["message"]


@pytest.fixture
def desk(sit_down: Callable[..., Desk]) -> Desk:
    return sit_down(accept_downloads=True).visit()


def taken(desk: Desk, folder: Path) -> Path:
    with desk.page.expect_download() as begun:
        desk.one("take-html").click()
    path = folder / "report.html"
    begun.value.save_as(path)
    return path


@pytest.mark.browser
def test_the_page_takes_away_what_it_shows(desk: Desk, tmp_path: Path) -> None:
    desk.open("robot", "3-rps")
    desk.run("gcrules.projecting.change({title: 'Rig <i>2</i>', note: 'bolted'})")
    for amounts in ([0.1, 0.05, 0], [0.3, 0.2, 0.1]):
        desk.run(
            "coordinates => gcrules.edit({pose: {...gcrules.pose$.value, coordinates}}, String(coordinates))", amounts
        )
        desk.answered()
    desk.page.wait_for_function("() => gcrules.timeline.proof.value !== null")
    desk.one("panel-motion").click()
    desk.run("gcrules.touring.change({nodes: 11})")
    desk.one("map-go").click()
    desk.page.wait_for_function("() => gcrules.touring.map.shown.value?.result.margin.length === 11")
    desk.one("panel-take-away").click()
    path = taken(desk, tmp_path)
    html = path.read_text(encoding="utf-8")
    assert_stands_alone(html)
    words = text_of(html)
    assert f"σ = {desk.numbers['margin']:.4g} " in words
    assert "Rig <i>2</i> bolted" in words
    assert desk.run("gcrules.timeline.proof.value.reason") in words
    assert desk.run("gcrules.touring.map.shown.value.result.guarantee") in words
    assert "data:image/svg+xml;base64," in html

    page = desk.page.context.new_page()
    requests: list[str] = []
    page.on("request", lambda request: requests.append(request.url))
    page.on("pageerror", lambda fault: desk.faults.append(str(fault)))
    page.goto(path.as_uri())
    page.wait_for_function("() => document.querySelector('.gcx-view canvas, .gcx-view svg')")
    assert [url for url in requests if not url.startswith(("file:", "data:", "blob:"))] == []
    amounts = page.evaluate("[...document.querySelectorAll('.gcx-side input[type=number]')].map(i => Number(i.value))")
    assert amounts[:3] == [0.3, 0.2, 0.1]
    link = page.get_attribute("text=Open it in the studio", "href")
    desk.page.goto(link)
    desk.page.wait_for_function(
        "() => gcrules.pose$.value.coordinates?.[0] === 0.3 && gcrules.panel$.value === 'take-away'"
    )


@pytest.mark.browser
def test_printed_it_shows_drawings_not_controls(desk: Desk, tmp_path: Path) -> None:
    desk.open("example", "octahedral").slide("z", -30)
    desk.answered()
    desk.one("panel-take-away").click()
    path = taken(desk, tmp_path)
    page = desk.page.context.new_page()
    page.goto(path.as_uri())
    page.wait_for_function("() => document.querySelector('.gcx-view canvas, .gcx-view svg')")
    page.emulate_media(media="print")
    shown = "s => [...document.querySelectorAll(s)].some(e => e.offsetParent !== null)"
    assert page.evaluate(shown, ".still svg, .view img")
    for hidden in (".gcx-view", ".lead", ".latex"):
        assert not page.evaluate(shown, hidden)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
