"""Figures: well-formed, the same every time, legible for every class of platforms."""

from __future__ import annotations

import os
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from fractions import Fraction
from itertools import combinations
from math import dist
from pathlib import Path
from typing import Any, NamedTuple

import pytest

import gcrules as gc
from gcrules.algebra.certificate import Certificate
from gcrules.algebra.language.legs_text import legs_text
from gcrules.algebra.language.syntax import parse
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import common_point, factors, free_motions
from gcrules.core.errors import FileError, InputError
from gcrules.mechanisms.description.platform_file import Platform, load_platform
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.rules.catalog.file import load
from gcrules.rules.condition import Condition
from gcrules.views.drawing.drawing import Circle, Drawing, Polygon, Run, Stroke, Text, name_runs, text_width
from gcrules.views.drawing.drawing_files import save
from gcrules.views.drawing.figures import graph_figure, incidence_in_words, robot_figure, shown_entities, thumbnail
from gcrules.views.drawing.graph import count_crossings, draw_graph, layered_order
from gcrules.views.drawing.labels import Label, label_box, overlap, place_labels
from gcrules.views.drawing.legend import rounded
from gcrules.views.drawing.palette import ROLES
from gcrules.views.drawing.scene import draw_platform, sample_coordinates

CLASSES = {e.id: legs_text(e.legs) for e in load().entries}


class Entity(NamedTuple):
    kind: str
    points: tuple[str, ...]


class Robot(NamedTuple):
    legs: list[tuple[str, str]]
    base: str
    platform: str
    entities: list[Entity]


def robot(text: str) -> Robot:
    """The legs of a class, with the planes of legs that meet in a base joint and the other legs as lines."""
    legs = [(leg[0], leg[1]) for leg in text.split()]
    base, platform = ("".join(dict.fromkeys(leg[i] for leg in legs)) for i in (0, 1))
    pairs = [(p, q) for p, q in combinations(legs, 2) if p[0] == q[0]][:2]
    planes = [Entity("plane", (p[0], p[1], q[1])) for p, q in pairs]
    alone = [leg for leg in legs if not any(leg in pair for pair in pairs)][:2]
    return Robot(legs, base, platform, [*planes, *(Entity("line", leg) for leg in alone)])


def scene(r: Robot, lines: bool = False) -> Drawing:
    at = sample_coordinates(r.legs, r.base, r.platform)
    named = [(at[r.base[0]], at[r.base[1]], "p"), (at[r.platform[0]], at[r.platform[1]], "q")] if lines else []
    return draw_platform(r.legs, at, r.base, r.platform, r.entities, named)


def all_texts(drawing: Drawing) -> list[Text]:
    return [shape for shape in drawing.shapes if isinstance(shape, Text)]


every_class = pytest.mark.parametrize("name", CLASSES)


@every_class
@pytest.mark.parametrize("kind", ["graph", "scene", "scene with lines"])
def test_labels_keep_clear(name: str, kind: str) -> None:
    r = robot(CLASSES[name])
    graph = kind == "graph"
    drawing = draw_graph(r.legs, r.base, r.platform, r.entities) if graph else scene(r, lines=kind != "scene")
    boxes = [label_box(t) for t in all_texts(drawing)]
    assert len(boxes) >= len(r.base) + len(r.platform) + len(r.entities)
    assert not [1 for a, b in combinations(boxes, 2) if overlap(a, b) > 0]
    for left, top, right, bottom in boxes:
        assert 0 <= left < right <= drawing.width
        assert 0 <= top < bottom <= drawing.height
    joints = [s for s in drawing.shapes if isinstance(s, Circle)]
    for x, y, r2 in ((*c.center, c.radius) for c in joints):
        assert not [1 for box in boxes if overlap(box, (x - r2, y - r2, x + r2, y + r2)) > 4]


@every_class
def test_joints_of_a_scene_stand_apart(name: str) -> None:
    r = robot(CLASSES[name])
    at = [s.center for s in scene(r).shapes if isinstance(s, Circle)][: len(r.base) + len(r.platform)]
    assert min(dist(p, q) for p, q in combinations(at, 2)) > 12


@every_class
def test_svg_is_xml(name: str) -> None:
    r = robot(CLASSES[name])
    for drawing in (draw_graph(r.legs, r.base, r.platform, r.entities), scene(r)):
        svg = drawing.svg()
        assert ET.fromstring(svg).tag == "{http://www.w3.org/2000/svg}svg"
        assert "nan" not in svg
        assert "inf" not in svg
        assert "prefers-color-scheme:dark" in svg


def test_figures_are_the_same_in_every_process() -> None:
    """Whatever the seed of Python's hashes, on which the sequence of a set depends."""
    code = (
        "from gcrules.conditions.analysis import analyze; from gcrules.rules.catalog.file import load\n"
        "from gcrules.views.drawing.figures import graph_figure, robot_figure\n"
        "for e in load().entries[::4]:\n"
        "    a = analyze(e.structure)\n"
        "    print(e.id, graph_figure(a).svg(), robot_figure(a).svg())"
    )
    children = [
        subprocess.Popen(
            [sys.executable, "-c", code], env={**os.environ, "PYTHONHASHSEED": seed}, stdout=subprocess.PIPE
        )
        for seed in ("0", "1", "2")
    ]
    found = {child.communicate()[0] for child in children}
    assert not any(child.returncode for child in children)
    assert len(found) == 1
    assert found.pop().count(b"</svg>") == 20


@every_class
def test_sample_coordinates_make_distinct_points(name: str) -> None:
    r = robot(CLASSES[name])
    at = sample_coordinates(r.legs, r.base, r.platform)
    assert set(at) == set(r.base + r.platform)
    assert at == sample_coordinates(r.legs, r.base, r.platform)
    assert min(dist(p, q) for p, q in combinations(at.values(), 2)) > 0.2
    assert max(at[p][2] for p in r.base) < min(at[p][2] for p in r.platform)


@pytest.mark.parametrize(
    ("legs", "crossings"),
    [("Aa Bb Cc Dd Ee Ff", 0), ("Aa Ab Bc Bd Ce Df", 0), ("Af Bd Ca De Eb Fc", 0), ("ab af cb cd ed ef", 2)],
)
def test_order_of_the_rows(legs: str, crossings: int) -> None:
    r = robot(legs)
    assert count_crossings(r.legs, *layered_order(r.legs, r.base, r.platform)) == crossings
    assert count_crossings(r.legs, *layered_order(r.legs, r.platform, r.base)) == crossings


@pytest.mark.parametrize("length", [1, 4, 15, 40])
def test_names_of_a_graph_stay_apart_and_inside(length: int) -> None:
    """Long names are drawn without their middle."""
    base, platform = ([f"{side}{'x' * (length - 1)}" for side in row] for row in ("abc", "ABC"))
    drawn = draw_graph(
        [(base[i], platform[k]) for i, k in ((0, 0), (0, 1), (1, 0), (1, 2), (2, 1), (2, 2))], base, platform
    )
    boxes = [label_box(s) for s in drawn.shapes if isinstance(s, Text) and s.size == 15]
    assert len(boxes) == 6
    assert all(not overlap(a, b) for a, b in combinations(boxes, 2))
    assert all(left >= 0 and right <= drawn.width for left, _, right, _ in boxes)


def test_lines_that_stand_for_limbs_are_of_no_bodies() -> None:
    """Points such as S1 and r1 of a pencil belong to neither the base nor the platform."""
    lines, legs = gc.analyze("3-rps").lines, gc.analyze("ab af cb cd ed ef")
    shapes = graph_figure(lines, bodies=False).shapes
    assert not _words(shapes) & {"platform", "base"}
    assert len({s.fill for s in shapes if isinstance(s, Circle)}) == 1
    assert {"platform", "base"} <= _words(graph_figure(legs).shapes)


@pytest.mark.parametrize("name", ["orthoglide", "3-upu", "3-uru", "3-puu"])
def test_lines_that_are_joined_with_constructions_are_entities(name: str) -> None:
    """Of ((xyz ∧ A1B1) ∨ A2B2) ∧ A3B3 all three lines are drawn, in the order in which they are written."""
    condition = gc.analyze(name).lines.condition
    found = [e.points for e in shown_entities(condition) if e.kind == "line"]
    legs = [p for p in found if p[0].startswith("A")]
    assert [p[0] for p in legs] == ["A1", "A2", "A3"]
    assert all(f"{a}{b}" in str(condition.expression) for a, b in found)


def _words(shapes: Iterable[Any]) -> set[str]:
    return {"".join(run.text for run in s.runs) for s in shapes if isinstance(s, Text)}


@pytest.mark.parametrize("sides", [("", ""), ("abc", "def")], ids=["unknown", "legs within a body"])
def test_a_graph_without_two_sides_is_a_circle(sides: tuple[str, str]) -> None:
    legs = [("a", "b"), ("b", "c"), ("c", "a"), ("d", "e"), ("e", "f"), ("f", "d")]
    joints = [s.center for s in draw_graph(legs, *sides).shapes if isinstance(s, Circle)]
    middle = (sum(x for x, _ in joints) / 6, sum(y for _, y in joints) / 6)
    assert len(joints) == 6
    assert max(dist(p, middle) for p in joints) == pytest.approx(min(dist(p, middle) for p in joints))
    draw_platform(legs, sample_coordinates(legs, *sides), *sides).svg()


def octahedral(root: Path, name: str = "octahedral") -> Platform:
    return load_platform(root / "examples" / f"{name}.yaml")


FACES = [Entity("plane", tuple(t)) for t in ("ace", "abf", "cbd", "edf")]


def test_planes_reach_the_point_where_they_meet(root: Path) -> None:
    platform = octahedral(root, "octahedral-singular")
    meeting = (400, -500, 0)
    with_point = draw_platform(platform.legs, platform.points, "ace", "bdf", FACES, marks=[(meeting, "Z")])
    dot = next(s for s in with_point.shapes if isinstance(s, Circle) and s.fill == "mark")
    inside = {s.fill for s in with_point.shapes if isinstance(s, Polygon) and _contains(s.points, dot.center)}
    assert inside >= {"entity1", "entity2", "entity3", "entity4"}


def _contains(polygon: tuple[tuple[float, float], ...], p: tuple[float, float]) -> bool:
    turns = [
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
        for a, b in zip(polygon, (*polygon[1:], polygon[0]), strict=True)
    ]
    return all(t >= -1e-6 for t in turns) or all(t <= 1e-6 for t in turns)


def test_what_is_in_front_is_drawn_later(root: Path) -> None:
    """Of two parallel planes seen from one side the nearer one covers the other; seen from the other side as well."""
    legs = [("a", "d"), ("b", "e"), ("c", "f")]
    at = {"a": (0, 0, 0), "b": (9, 0, 0), "c": (0, 9, 0), "d": (0, 0, 5), "e": (9, 0, 5), "f": (0, 9, 5)}
    planes = [Entity("plane", ("d", "e", "f")), Entity("plane", ("a", "b", "c"))]
    for entities in (planes, planes[::-1]):
        drawn = [s.fill for s in draw_platform(legs, at, entities=entities).shapes if isinstance(s, Polygon)]
        top = f"entity{1 + entities.index(planes[0])}"  # seen from above, so the upper plane is in front
        below = f"entity{1 + entities.index(planes[1])}"
        assert drawn.index(below) < drawn.index(top)


@pytest.mark.parametrize(
    ("legs", "at", "words"),
    [
        ([], {}, "no legs"),
        ([("a", "b")], {"a": (0, 0, 0)}, "no coordinates given for b"),
        ([("a", "b")], {"a": (0, 0, 0), "b": (0, 0, 0)}, "length zero"),
        ([("a", "b")], {"a": (0, 0, float("nan")), "b": (1, 0, 0)}, "finite"),
        ([("a", "b")], {"a": (0, 0), "b": (1, 0, 0)}, "three"),
    ],
)
def test_faults_of_a_scene(legs: list[tuple[str, str]], at: dict[str, tuple[float, ...]], words: str) -> None:
    with pytest.raises(InputError, match=words):
        draw_platform(legs, at)


DEGENERATE = {
    "flat": {"a": (0, 0, 0), "b": (1, 0, 0), "c": (0, 1, 0), "d": (1, 1, 0)},
    "in one line": {"a": (0, 0, 0), "b": (1, 0, 0), "c": (2, 0, 0), "d": (3, 0, 0)},
    "upright line": {"a": (0, 0, 0), "b": (0, 0, 1), "c": (0, 0, 2), "d": (0, 0, 4)},
    "joints coincide": {"a": (0, 0, 0), "b": (1, 0, 0), "c": (0, 0, 0), "d": (1, 0, 0)},
    "huge": {"a": (0, 0, 0), "b": (1e12, 0, 0), "c": (0, 1e12, 0), "d": (0, 0, 1e12)},
    "tiny": {"a": (0, 0, 0), "b": (1e-9, 0, 0), "c": (0, 1e-9, 0), "d": (0, 0, 1e-9)},
    "far away": {"a": (1e6, 0, 0), "b": (1e6, 1, 0), "c": (1e6, 0, 1), "d": (1e6 + 1, 0, 0)},
}


@pytest.mark.parametrize("name", DEGENERATE)
def test_degenerate_poses_are_drawn(name: str) -> None:
    at = DEGENERATE[name]
    entities = [
        Entity("tetrahedron", tuple("abcd")),
        Entity("plane", tuple("abc")),
        Entity("line", tuple("ac")),
        Entity("point", ("a",)),
    ]
    legs = [("a", "b"), ("c", "d")]
    drawing = draw_platform(legs, at, "ac", "bd", entities, [(at["a"], at["d"], "p"), (at["a"], at["a"], "q")])
    svg = drawing.svg()
    ET.fromstring(svg)
    assert "nan" not in svg


def test_names_are_set_as_in_formulas() -> None:
    assert name_runs("S_12'") == (Run("S", "italic"), Run("12", "subscript"), Run("′"))
    assert text_width(Text((0, 0), name_runs("Aa"))) < text_width(Text((0, 0), name_runs("Aab")))


def test_titles_keep_names_of_several_letters_apart() -> None:
    legs = [("left", "top"), ("right", "top"), ("right", "cap")]
    at = sample_coordinates(legs, ("left", "right"), ("top", "cap"))
    for drawing in (draw_graph(legs, (), ()), draw_platform(legs, at)):
        assert drawing.title.endswith(" left top, right top, right cap")
    assert draw_graph([("S1", "A'"), ("b", "c")], (), ()).title == "Leg graph: S1A' bc"


def test_text_is_escaped() -> None:
    svg = Drawing(10, 10, (Text((0, 0), (Run("<&>"),)),), title="a < b").svg()
    assert [t.text for t in ET.fromstring(svg).iter("{http://www.w3.org/2000/svg}text")] == ["<&>"]


def test_crowded_labels_find_places() -> None:
    labels = [Label(name_runs(n), (100 + 9 * i, 100)) for i, n in enumerate("abcdef")]
    boxes = [label_box(t) for t in place_labels(labels, discs=[(label.at, 5) for label in labels])]
    assert not [1 for a, b in combinations(boxes, 2) if overlap(a, b) > 0]


@pytest.mark.parametrize("points", [[(0, 0)], [(0, 0), (5, 0)], [(0, 0), (5, 0), (9, 0)], [(0, 0), (5, 0), (0, 5)]])
def test_rounded_outlines_keep_their_distance(points: list[tuple[float, float]]) -> None:
    outline = rounded(points, 2.0)
    assert all(min(dist(p, q) for q in points) >= 2 - 1e-9 for p in outline)
    assert all(min(dist(p, q) for q in points) <= 2 + 1e-9 for p in outline)


def test_colours_have_both_values() -> None:
    assert all(value.startswith("#") and len(value) == 7 for pair in ROLES.values() for value in pair)


# --- figures of an analysis ----------------------------------------------------------------------------------------

SQUARE: dict[str, tuple[int, ...]] = {
    "o": (0, 0, 0, 1), "x": (1, 0, 0, 1), "y": (0, 1, 0, 1), "z": (0, 0, 1, 1), "u": (1, 1, 0, 1), "v": (1, 1, 1, 1),
}  # fmt: skip


@pytest.mark.parametrize(
    ("expression", "point"),
    [
        ("oxy /\\ oxz /\\ oyz /\\ ouv", (0, 0, 0)),
        ("oxy /\\ oyz /\\ ov", (0, 0, 0)),
        ("oxy /\\ x", (1, 0, 0)),
        ("ou /\\ xy", (Fraction(1, 2), Fraction(1, 2), 0)),
        ("(oxy /\\ oxz) /\\ yu", None),
        ("((ov /\\ oxy) \\/ x) /\\ ozv /\\ oyz", (0, 0, 0)),
        ("oxy /\\ oxu /\\ ov", (0, 0, 0)),
        ("oxy /\\ oxy /\\ oyz /\\ oyz", None),
        ("[oxyu]", None),
        ("oxy /\\ zv", None),
    ],
    ids=[
        "planes",
        "planes and line",
        "plane and point",
        "lines",
        "at infinity",
        "constructed",
        "twice",
        "line",
        "bracket",
        "line at infinity",
    ],
)
def test_common_points(expression: str, point: tuple[int | Fraction, ...] | None) -> None:
    found = common_point(parse(expression), SQUARE)
    assert (tuple(c / found[3] for c in found[:3]) if found and found[3] else None) == point
    assert (found is not None and found[3] == 0) == (expression in ("(oxy /\\ oxz) /\\ yu", "oxy /\\ zv"))


@pytest.mark.parametrize(
    ("expression", "parts"),
    [
        ("2 * [abcd] * (ab /\\ cd)**2", ["[abcd]", "ab /\\ cd"]),
        ("-[abcd][abce][abcd]", ["[abcd]", "[abce]"]),
        ("[abcd] + [abce]", ["[abcd] + [abce]"]),
        ("0", []),
    ],
)
def test_factors(expression: str, parts: list[str]) -> None:
    assert list(map(str, factors(parse(expression)))) == parts


def test_free_motions() -> None:
    """Five legs that meet a line leave the turn about it; three parallel legs two shifts and a turn."""
    at = {n: (i, i * i, 0, 1) for i, n in enumerate("ABCDE")}
    at |= {"p": (1, 2, 5, 1), "q": (4, 1, 5, 1), "r": (0, 0, 7, 1)}
    legs = [("A", "p"), ("B", "p"), ("C", "p"), ("D", "q"), ("E", "q")]
    (turn,) = free_motions(legs, at)
    x, y, z = turn.axis
    assert turn.pitch == 0
    assert (x, z) == (-3 * y, 0)
    assert turn.foot is not None
    assert turn.foot[2] == 5
    assert not free_motions([*legs, ("E", "r")], at)
    upright = {n: (x, y, 0, 1) for n, x, y in (("a", 0, 0), ("b", 1, 0), ("c", 0, 1))}
    upright |= {n.upper(): (x, y, 1, 1) for n, (x, y, *_) in upright.items()}
    motions = free_motions([("a", "A"), ("b", "B"), ("c", "C")], upright)
    assert [m.foot is None for m in motions] == [True, True, False]


def analysis(kind: str, expression: str, legs: str = "Aa Ab Bc Bd Ce Cf", **more: Any) -> Analysis:
    """An analysis whose condition no rule has found."""
    condition = Condition(kind, parse(expression), "words", Certificate("none", "not proved"), **more)
    return replace(analyze_legs(legs), condition=condition)


POSE = {"A": (0, 0, 0), "B": (6, 0, 0), "C": (0, 6, 0), "a": (0, 1, 5), "b": (1, 0, 6), "c": (4, 1, 5), "d": (5, 2, 6),
        "e": (1, 4, 5), "f": (2, 5, 7)}  # fmt: skip


@pytest.mark.parametrize(
    ("expression", "legend"),
    [
        ("Aab /\\ Bcd /\\ Cef /\\ ABC", "plane Aab, plane Bcd, plane Cef, plane ABC"),
        ("[Aabc](ABd /\\ ACe /\\ Bf)", "tetrahedron Aabc, plane ABd, plane ACe, line Bf"),
        ("(AB /\\ Ce)(Aab /\\ Bcd /\\ Cf)", "plane Aab, plane Bcd, line AB, line Ce, line Cf"),
        ("((Aa /\\ Bcd) \\/ (Ab /\\ Bcd)) /\\ Ce", "plane Bcd, line Aa, line Ab, line Ce, line r"),
        ("(Aab /\\ Bcd) /\\ (C \\/ (Ab /\\ Bef)) /\\ (A \\/ B)", None),
        ("0", ""),
        ("[[Aa, Ab, Bc, Bd, Ce, Cf]]", ""),
        ("[ABab][Ccde] - [ABac][Cdef]", "tetrahedron ABab, tetrahedron Ccde, tetrahedron ABac, tetrahedron Cdef"),
        ("[ABab]**2 * 3", "tetrahedron ABab"),
    ],
)
def test_a_kind_that_is_known_only_from_a_catalog_is_drawn(expression: str, legend: str | None) -> None:
    if legend is None:
        with pytest.raises(InputError):
            parse(expression)
        return
    a = analysis("a kind of its own", expression)
    for drawing in (robot_figure(a), robot_figure(a, POSE)):
        words = ["".join(run.text for run in t.runs) for t in all_texts(drawing)]
        found = [w for w in words if w.split()[0] in ("tetrahedron", "plane", "line")]
        assert ", ".join(found).replace(", outside", "").replace(", flat", "") == legend
        ET.fromstring(drawing.svg())
    ET.fromstring(graph_figure(a).svg())
    assert not all_texts(thumbnail(a, POSE))
    assert incidence_in_words(a, POSE)


def test_the_common_point_is_found_without_the_kind() -> None:
    pose = {**POSE, "M": (0, 0, 0)}
    a = analysis("something new", "AB /\\ AC", legs="AB AC Aa Ba Cb Cc")
    words = incidence_in_words(a, pose)
    assert words == "the lines AB and AC meet in the point M = (0, 0, 0)."
    marks = [s for s in robot_figure(a, pose).shapes if isinstance(s, Circle) and s.fill == "mark"]
    assert len(marks) == 2  # in the picture and in the legend


def test_what_lies_outside_the_picture_is_said_to() -> None:
    at = {"a": (0, 0, 0), "b": (1, 0, 0), "c": (0, 1, 0), "d": (0, 0, 1)}
    far = ((9, 9, 9), (9, 9, 10), "p")
    drawing = draw_platform([("a", "b"), ("c", "d")], at, lines=[far], marks=[((9, 9, 9), "common point M")])
    words = ["".join(run.text for run in t.runs) for t in all_texts(drawing)]
    assert words[-2:] == ["line p, outside", "common point M, outside"]


def test_numbers_beside_a_tie_are_rounded_alike() -> None:
    values = [k / 8 for k in range(-40, 40)]
    for value in values:
        texts = {Drawing(v, 1, ()).svg() for v in (value, value * (1 + 2e-16), value * (1 - 2e-16))}
        assert len(texts) == 1


# --- files ---------------------------------------------------------------------------------------------------------

SMALL = Drawing(
    60,
    40,
    (
        Polygon(((5, 5), (50, 5), (30, 30)), "entity1", "ink", 0.3),
        Stroke((0, 0), (60, 40), dash=(4, 2)),
        Circle((20, 20), 5),
        Text((10, 30), name_runs("S1'", "a"), halo=True),
    ),
    "all shapes",
)


@pytest.mark.parametrize("suffix", [".svg", ".pdf", ".SVG"])
def test_saved_files_are_the_same_twice(tmp_path: Path, suffix: str) -> None:
    first, second = tmp_path / f"one{suffix}", tmp_path / f"two{suffix}"
    save(SMALL, first)
    save(SMALL, str(second))
    save(SMALL, second)
    assert first.read_bytes() == second.read_bytes()
    assert first.read_bytes().startswith(b"%PDF" if suffix == ".pdf" else b"<svg")
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted([first.name, second.name])


@pytest.mark.parametrize(
    ("name", "error", "words"),
    [
        ("x.png", InputError, "'.png' is not a figure format"),
        ("x", InputError, "without suffix"),
        ("missing/x.svg", FileError, "cannot be written"),
    ],
)
def test_faults_of_save(tmp_path: Path, name: str, error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words):
        save(SMALL, tmp_path / name)
    assert not list(tmp_path.iterdir())


def test_pdfs_can_be_made_in_several_threads() -> None:
    from gcrules.views.drawing.pdf import pdf  # needs matplotlib

    with ThreadPoolExecutor(4) as pool:
        assert len(set(pool.map(pdf, [SMALL] * 12))) == 1


def test_pdf_without_matplotlib(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(InputError, match="matplotlib") as found:
        save(SMALL, tmp_path / "x.pdf")
    assert found.value.hint == 'pip install "gcrules[figures]"'


def test_svg_needs_no_library() -> None:
    code = (
        "import sys; from gcrules.views.drawing.scene import draw_platform, sample_coordinates as at; "
        "legs = [('a', 'b'), ('c', 'b')]; draw_platform(legs, at(legs, 'ac', 'b'), 'ac', 'b').svg(); "
        "sys.exit(bool({'matplotlib', 'numpy', 'networkx', 'yaml', 'sympy'} & set(sys.modules)))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.needs("rsvg-convert")
def test_a_program_without_css_variables_draws_the_figure(tmp_path: Path, root: Path) -> None:
    platform = octahedral(root)
    save(draw_platform(platform.legs, platform.points, "ace", "bdf", FACES), tmp_path / "x.svg")
    subprocess.run(["rsvg-convert", "x.svg", "-o", "x.png"], cwd=tmp_path, check=True)
    assert (tmp_path / "x.png").stat().st_size > 5000
