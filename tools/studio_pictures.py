"""The pictures of docs/studio.md; `python tools/studio_pictures.py [NAME …]` writes them, or some, into docs/assets
(needs Chromium).
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from typing import Any

from PIL import Image
from playwright.sync_api import ViewportSize

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from browsing import chromium  # noqa: E402
from studio_page import Desk, studio  # noqa: E402

SLOW = 600_000  # milliseconds that an answer may take
SIZE: ViewportSize = {"width": 1280, "height": 800}

PICTURES: dict[str, dict[str, Any]] = {
    "studio-condition.png": {
        "scheme": "light",
        "open": ("class", "3-3.3"),
        "stage": "condition",
        "sliders": {"rz": 14},
    },
    "studio-singular.png": {
        "scheme": "light",
        "open": ("example", "octahedral"),
        "stage": "statement",
        "nearest": True,
    },
    "studio-robot.png": {"scheme": "dark", "open": ("robot", "gallardo-4dof"), "stage": "equivalent"},
    "studio-map.png": {
        "scheme": "light",
        "open": ("robot", "3-rps"),
        "map": [{"name": "z", "low": -0.7, "high": 0.7}, {"name": "roll", "low": -70, "high": 70}],
        "place": (0.62, 0.22),
    },
    "studio-surface.png": {
        "scheme": "light",
        "open": ("example", "octahedral"),
        "sliders": {"rx": 20},
        "surface": 25,
    },
    "studio-where.png": {"scheme": "light", "open": ("example", "octahedral"), "mode": 2},
    "studio-certificate.png": {
        "scheme": "dark",
        "open": ("robot", "reachy-mini-head"),
        "certify": {"yaw": {"name": "yaw", "low": 0, "high": 95}},
    },
}
"""Name: colours of the page, what is opened, the step, map, surface, assembly mode or certificate, how the platform is
moved.
"""


def take(desk: Desk, wanted: dict[str, Any]) -> bytes:
    """One view of the page as a PNG."""
    kind, name = wanted["open"]
    desk.visit().open(kind, name, wanted.get("stage"))
    for name, value in wanted.get("sliders", {}).items():
        desk.slide(name, value)
    if wanted.get("nearest"):
        desk.one("nearest-rotation").click()
        desk.verdict("singular", timeout=30_000)
        desk.one("view-fit").click()
    if "map" in wanted:
        desk.one("panel-motion").click()
        desk.run("over => gcrules.touring.change({over, nodes: 61})", wanted["map"])
        desk.one("map-go").click()
        finest = "() => gcrules.touring.map.shown.value?.result.margin.length === 61"
        desk.page.wait_for_function(finest, timeout=SLOW)
        desk.page.locator(".motion .map").evaluate("map => map.scrollIntoView()")
        box = desk.one("map-plot").bounding_box()
        x, y = wanted["place"]
        desk.one("map-plot").click(position={"x": x * box["width"], "y": y * box["height"]})
        desk.page.wait_for_function("() => gcrules.touring.place.now.value.state === 'found'", timeout=SLOW)
        desk.one("map-readout").evaluate("words => words.scrollIntoView({block: 'end'})")
        desk.page.wait_for_timeout(3000)  # until the robot has gone there
    if "surface" in wanted:
        desk.one("panel-motion").click()
        desk.one("surface-go").click()
        levels = "n => gcrules.touring.surface.shown.value?.result.nodes[0] === n"
        desk.page.wait_for_function(levels, arg=wanted["surface"], timeout=SLOW)
        desk.one("surface-nearest").click()
        desk.verdict("singular", timeout=30_000)
        desk.page.locator(".motion .surface").evaluate("section => section.scrollIntoView()")
    if "mode" in wanted:
        desk.one("panel-where").click()
        for name, last in (("aspects", "aspect"), ("assemblies", "assembly")):
            desk.one(f"{name}-go").click()
            desk.page.get_by_test_id(last).last.wait_for(timeout=SLOW)
        desk.page.get_by_test_id("assembly").nth(wanted["mode"]).click()
        desk.page.wait_for_timeout(3000)
    if "certify" in wanted:
        desk.one("panel-where").click()
        asked = {"kind": "certificate", "ranges": wanted["certify"]}
        desk.run("asked => { const w = gcrules.roaming.whole$; w.value = {...w.value, ...asked} }", asked)
        desk.one("boxes-go").click()
        desk.one("certify-go").click(timeout=SLOW)
        desk.page.wait_for_timeout(3000)
        desk.one("view-fit").click()
        desk.one("certify-verdict").evaluate("verdict => verdict.scrollIntoView()")
    desk.answered()
    desk.page.mouse.move(2, 2)
    desk.page.evaluate("document.activeElement?.blur()")
    desk.page.wait_for_timeout(900)
    return bytes(desk.page.screenshot())


def main(names: Sequence[str]) -> None:
    with tempfile.TemporaryDirectory() as state, studio(Path(state)) as server, chromium() as browser:
        for name, wanted in PICTURES.items():
            if names and name not in names:
                continue
            context = browser.new_context(viewport=SIZE, color_scheme=wanted["scheme"], reduced_motion="reduce")
            picture = Image.open(BytesIO(take(Desk(context.new_page(), server), wanted))).convert("RGB")
            small = picture.quantize(256, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
            small.save(ROOT / "docs" / "assets" / name, optimize=True)
            context.close()


if __name__ == "__main__":
    main(sys.argv[1:])
