"""Every drawing that is shipped: its labels neither cover each other nor leave the picture; lines lead to far ones."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from itertools import combinations
from pathlib import Path
from typing import Any, Literal

import pytest
from places import EXAMPLES, ROOT

import gcrules as gc
from gcrules.mechanisms.description.discovery import robots
from gcrules.views.drawing.drawing import Drawing, Run, Text, mapped, name_runs, without_text
from gcrules.views.drawing.labels import Box, Label, label_box, overlap, place_labels
from gcrules.views.drawing.pdf import pdf
from gcrules.views.figure import figure
from gcrules.views.paper.tikz import tikz
from gcrules.views.robots import picture
from gcrules.views.robots.robot_drawing import draw_robot

SVG = "{http://www.w3.org/2000/svg}"


def committed(folder: str) -> list[Path]:
    """The drawings of a folder that the program writes."""
    files = sorted((ROOT / "docs" / folder).glob("*.svg"))
    return [f for f in files if not f.stem.endswith("-small")]


def texts_of(svg: str) -> Iterator[Text]:
    for one in ET.fromstring(svg).iter(f"{SVG}text"):
        pieces: list[tuple[ET.Element | None, str]] = [(None, one.text or ""), *((t, t.text or "") for t in one)]
        runs = tuple(Run(words, _style(piece)) for piece, words in pieces if words)
        place = (float(one.attrib["x"]), float(one.attrib["y"]))
        anchor = one.get("text-anchor", "start")
        yield Text(place, runs, float(one.attrib["font-size"]), anchor)


def _style(piece: ET.Element | None) -> Literal["upright", "italic", "subscript"]:
    if piece is None:
        return "upright"
    return "italic" if piece.get("font-style") else "subscript" if piece.get("font-size") else "upright"


def faults(svg: str) -> list[str]:
    """Labels of a drawing that cover each other or leave it."""
    width, height = map(float, re.findall(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', svg)[0])
    boxes = [("".join(run.text for run in t.runs), label_box(t)) for t in texts_of(svg)]
    covered = [f"{n} covers {m}" for (n, p), (m, q) in combinations(boxes, 2) if overlap(p, q) > 0.05]
    return [*covered, *(f"{n} is outside" for n, b in boxes if not _inside(b, width, height))]


def _inside(box: Box, width: float, height: float) -> bool:
    return box[0] >= -0.05 and box[1] >= -0.05 and box[2] <= width + 0.05 and box[3] <= height + 0.05


@pytest.mark.parametrize(("folder", "least"), [("robots", 70), ("catalog", 100)])
def test_labels_of_the_shipped_drawings(folder: str, least: int) -> None:
    files = committed(folder)
    assert len(files) > least
    read = {f.name: f.read_text(encoding="utf-8") for f in files}
    assert all(any(texts_of(svg)) for svg in read.values())
    assert {name: found for name, svg in read.items() if (found := faults(svg))} == {}


@pytest.mark.parametrize("name", sorted(f.name for f in EXAMPLES.glob("*.yaml")))
def test_labels_of_the_examples(name: str) -> None:
    assert faults(figure(gc.analyze(EXAMPLES / name)).svg()) == []


@pytest.mark.parametrize("robot", [one.id for one in robots(())])
def test_labels_of_robots_stand_on_no_joint(robot: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """No label covers the sign of a joint, or another label."""
    seen: list[tuple[Sequence[Box], list[Text]]] = []

    def spy(labels: Sequence[Label], *, taken: Sequence[Box] = (), **more: Any) -> list[Text]:
        seen.append((taken, place_labels(labels, taken=taken, **more)))
        return seen[-1][1]

    monkeypatch.setattr(picture, "place_labels", spy)
    a = gc.analyze(robot)
    draw_robot(a)
    ((signs, texts),) = seen
    boxes = [("".join(run.text for run in t.runs), label_box(t)) for t in texts]
    assert [n for n, box in boxes for sign in signs if overlap(box, sign) > 0.5] == []
    assert [f"{n} {m}" for (n, p), (m, q) in combinations(boxes, 2) if overlap(p, q) > 0.05] == []


def test_the_reader_of_these_tests_sees_what_collides() -> None:
    words = (Text((20, 20), name_runs("A1")), Text((24, 20), name_runs("B")), Text((98, 20), name_runs("C")))
    assert faults(Drawing(100, 40, words).svg()) == ["A1 covers B", "C is outside"]
    assert [text_of.runs for text_of in texts_of(Drawing(100, 40, words).svg())] == [w.runs for w in words]


def crowd() -> list[Label]:
    """So many labels at one place that some of them stand far from it."""
    return [Label(name_runs(f"A{n}"), (100, 100)) for n in range(12)]


def test_a_line_leads_to_a_label_that_is_far() -> None:
    texts = place_labels(crowd(), discs=[((100, 100), 5)])
    assert not [1 for a, b in combinations(map(label_box, texts), 2) if overlap(a, b) > 0]
    led = [t for t in texts if t.leader]
    assert 0 < len(led) < len(texts)
    for t in led:
        assert t.leader is not None
        (x, y), (u, v) = t.leader
        left, top, right, bottom = label_box(t)
        assert ((x - 100) ** 2 + (y - 100) ** 2) ** 0.5 == pytest.approx(5)
        assert left <= u <= right
        assert top <= v <= bottom


def test_every_writer_draws_the_lines_and_none_without_words() -> None:
    texts = place_labels(crowd(), discs=[((100, 100), 5)])
    led = sum(t.leader is not None for t in texts)
    drawing = Drawing(200, 200, tuple(texts))
    assert drawing.svg().count("<line") == led
    assert tikz(drawing).count(r"\path[draw") == led
    assert len(pdf(drawing)) > len(pdf(Drawing(200, 200, tuple(Text(t.at, t.runs) for t in texts))))
    assert without_text(drawing).shapes == ()
    moved = [mapped(t, 2.0, (1.0, 0.0)) for t in texts if t.leader]
    first = next(t for t in texts if t.leader)
    assert isinstance(moved[0], Text)
    assert moved[0].leader == tuple((2 * x + 1, 2 * y) for x, y in first.leader or ())
