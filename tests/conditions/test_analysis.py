"""The analysis of six legs: identities in any labelling, and statements checked on poses made to fulfil them."""

from __future__ import annotations

import json
import random
import re
from collections import Counter
from collections.abc import Sequence
from itertools import combinations, permutations
from typing import Any

import numpy as np
import pytest
from platform_classes import CLASSES

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, evaluate, random_points, vanishes
from gcrules.algebra.expr import ZERO, Join, Point, join, meet, mul, points_of
from gcrules.algebra.prove import prove
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError, LimitReached
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.rules.condition_rule import INCIDENCES
from gcrules.rules.plugins import load_rules

LEGS = {c["id"]: " ".join(c["legs"]) for c in CLASSES}
REGULAR = [c["id"] for c in CLASSES if c["regular"]]
ALL = pytest.mark.parametrize("facts", CLASSES, ids=[c["id"] for c in CLASSES])
LABELS = [f"{x}{s}" for x in "abcdefghijkABCDEFGH" for s in ("", "1", "12", "_3", "'")]
VARIANTS = ["exchanged", "turned", "ordered"]
Points = dict[str, tuple[int, ...]]


def scrambled(facts: dict[str, Any], variant: str, seed: int = 0) -> list[tuple[str, str]]:
    """The class under random labels and in random order; bodies exchanged or single legs turned round."""
    rng = random.Random(f"{facts['id']} {variant} {seed}")
    joints = sorted(set("".join(facts["legs"])))
    label = dict(zip(joints, rng.sample(LABELS, len(joints)), strict=True))
    legs = [(label[a], label[b]) for a, b in facts["legs"]]
    rng.shuffle(legs)
    if variant == "exchanged":
        return [(b, a) for a, b in legs]
    if variant == "turned":  # fewer than half of the legs of each connected part, so that sides can be found
        turned = rng.choice(legs)
        part = {turned[0], turned[1]}
        for _ in legs:
            part |= {n for leg in legs for n in leg if part & set(leg)}
        if sum(leg[0] in part for leg in legs) > 2:
            return [(b, a) if (a, b) == turned else (a, b) for a, b in legs]
    return legs


@ALL
@pytest.mark.parametrize("variant", VARIANTS)
def test_every_class_in_any_labelling(facts: dict[str, Any], variant: str) -> None:
    legs = scrambled(facts, variant)
    a = analyze_legs(legs)
    assert a.structure.legs == tuple(legs)
    assert a.match is not None
    assert (a.match.entry.id, a.group) == (facts["id"], facts["group"])
    assert a.derivation.check()
    assert (a.condition.kind == "always-singular") == (not facts["regular"])
    readings = (a.condition, *a.readings)
    for n, reading in enumerate(readings):
        left = mul(reading.cofactor, a.structure.superbracket)
        right = mul(gc.parse(str(reading.coefficient)), reading.expression)
        assert vanishes(reading.identity(a.structure.superbracket), seed=31)
        assert not vanishes(reading.cofactor)
        if variant == "turned" or n == 0:
            assert prove(left, right).verdict == "proved"
    assert len({str(r.expression) for r in readings}) == len(readings)


def test_every_rule_certifies_what_it_found() -> None:
    methods = Counter(analyze_legs(LEGS[i]).condition.certificate.method for i in REGULAR)
    assert methods == {"normal-form": 34}
    looked_up = {"strategy": load_rules().strategy(without=["transversals"])}
    assert analyze_legs(LEGS["5-5.1"], **looked_up).condition.certificate.method == "catalog-instance"
    assert analyze_legs(LEGS["5-5.1"], recheck=True, **looked_up).condition.certificate.method == "normal-form"


@pytest.mark.parametrize("class_id", ["5-5.1", "6-5"])
def test_transversals_are_found_and_not_looked_up(class_id: str) -> None:
    """The rule's condition comes first; the catalog's, which compares turns about the same lines, is not repeated."""
    a = analyze_legs(LEGS[class_id])
    assert (a.condition.kind, a.condition.certificate.data["rule"]) == ("transversals", "transversals")
    assert all(r.certificate.method == "normal-form" for r in a.readings if r.kind == "transversals")
    assert any(r.kind == "one-incidence" for r in a.readings)


@ALL
def test_json(facts: dict[str, Any]) -> None:
    """The contract: keys, text that parses back, only the user's labels, no stars, no powers, whole coefficients."""
    legs = scrambled(facts, "exchanged", seed=1)
    a = analyze_legs(legs)
    found = json.loads(json.dumps(a.to_json()))
    assert found["schema"] == 1
    assert found["legs"] == [list(leg) for leg in legs]
    assert found["class"] == facts["id"]
    assert set(found["points"]) == {n for leg in legs for n in leg}
    assert set(found["superbracket"]) >= {"order", "terms", "polynomial"}
    assert set(found["shortest"]) >= {"form", "order", "terms", "polynomial"}
    assert found["superbracket"]["order"] == list(range(6))
    assert found["shortest"]["terms"] == min(facts["terms24"], facts["terms16"])
    assert found["shortest"]["form"] == (24 if facts["terms24"] <= facts["terms16"] else 16)
    assert found["group"] == facts["group"]
    assert {"method", "detail"} <= set(found["certificate"])
    for e in found["entities"]:
        assert e["kind"] in ("tetrahedron", "plane", "line", "point")
        assert [n.rstrip("*") for n in e["starred"]] == e["points"]
    texts = [found["superbracket"]["polynomial"], found["shortest"]["polynomial"]]
    for r in (found["condition"], *found["readings"]):
        assert {"kind", "expression", "cofactor", "coefficient", "statement"} <= set(r)
        assert isinstance(r["coefficient"], int)
        assert r["coefficient"] != 0
        assert r["statement"].endswith(".")
        assert not re.search(r"[{}]", r["statement"])
        texts += [r["expression"], r["cofactor"]]
    for step in found["derivation"]:
        assert set(step) >= {"rule", "before", "after", "why"}
        texts += [step["before"], step["after"]]
    for text in texts:
        assert text.isascii()
        assert "**" not in text
        assert set(points_of(gc.parse(text))) <= set(found["points"])
    signed = gc.parse(found["superbracket"]["polynomial"])
    assert prove(signed, a.structure.superbracket).proved
    if not facts["regular"]:
        assert (found["condition"]["expression"], found["readings"]) == ("0", [])
    if facts["group"] is None and facts["regular"]:
        assert "linear-complex" in {r["kind"] for r in (found["condition"], *found["readings"])}


@ALL
def test_the_shortest_form_is_written_with_its_sign(facts: dict[str, Any]) -> None:
    """sign of the order times `shortest` is the superbracket of the legs as typed, single legs turned or not."""
    a = analyze_legs(scrambled(facts, "turned", seed=2))
    points = random_points(a.structure.names, seed=8)
    typed = evaluate(a.structure.superbracket, points, modulus=PRIME)
    assert evaluate(a.shortest.polynomial.to_expr(), points, modulus=PRIME) == a.shortest.sign * typed % PRIME


@ALL
def test_sides_left_open_do_not_change_the_condition(facts: dict[str, Any]) -> None:
    """Whole connected parts written the other way round: the condition stays true, its kind and group the same."""
    legs = [(a, b) for a, b in facts["legs"]]
    plain = analyze_legs(legs)
    for leg in legs:
        turned = [(y, x) if {x, y} & set(leg) else (x, y) for x, y in legs]
        a = analyze_legs(turned)
        assert (a.condition.kind == "always-singular") == (not facts["regular"])
        assert vanishes(a.condition.identity(a.structure.superbracket))
        if facts["group"]:
            assert a.group == plain.group


# --- always singular -----------------------------------------------------------------------------------------------

SINGULAR = [
    *(LEGS[c["id"]] for c in CLASSES if not c["regular"]),
    "Aa Ab Ac Ad Be Cf",
    "Aa Ab Ac Ad Ae Bf",
    "Aa Aa Bb Cc Dd Ee",
    "ab ba cd ce cf de",
    "ab bc cd de ef fa",
    "ab bc ca de ef fd",
    "ab ac ad ae af ag",
]


@pytest.mark.parametrize("legs", SINGULAR)
@pytest.mark.parametrize("order", [None, "1 2 3 4 5 6", "3 1 6 2 5 4"])
def test_always_singular(legs: str, order: str | None) -> None:
    a = analyze_legs(legs, order=order)
    zero = vanishes(a.structure.superbracket)
    assert zero == (a.condition.kind == "always-singular")
    assert a.derivation.check()
    if zero:
        assert a.condition.expression == ZERO
        assert a.degeneracy is not None
        assert str(a.degeneracy.reason) in a.condition.statement
        assert a.degeneracy.legs
        line = a.degeneracy.line
        if line is not None:
            points = random_points(a.structure.names, seed=6)
            assert any(evaluate(line, points, modulus=PRIME))
            for leg in a.structure.legs:
                assert evaluate(meet(line, join(*map(Point, leg))), points, modulus=PRIME) == 0


@pytest.mark.parametrize("class_id", [c["id"] for c in CLASSES if not c["regular"]])
def test_the_line_that_all_legs_meet_is_named(class_id: str) -> None:
    a = analyze_legs(LEGS[class_id])
    assert a.degeneracy is not None
    assert isinstance(a.degeneracy.line, Join)
    triple = {n for n, k in Counter(LEGS[class_id].replace(" ", "")).items() if k == 3}
    assert {str(p) for p in a.degeneracy.line.args} == triple


@pytest.mark.parametrize("legs", ["ab cd ba ac ef ba", "ab ab ac cd de fg", "ca ba cd ge ba ef", "ab gh dc ec ba cf"])
@pytest.mark.parametrize("order", [None, "1 2 3 4 5 6", "3 1 6 2 5 4", "6 5 4 3 2 1"])
def test_a_form_of_zero_with_terms_left_is_zero(legs: str, order: str | None) -> None:
    """In some orders the form of a superbracket that is identically zero has terms, equal to 0 by syzygies alone."""
    assert analyze_legs(legs, order=order).condition.kind == "always-singular"


def graphs_of_few_joints() -> list[tuple[tuple[str, str], ...]]:
    """All simple graphs of six edges on four and five joints (odd cycles, shared bodies), one of each kind."""
    found: dict[tuple[tuple[str, str], ...], None] = {}
    for joints in ("abcd", "abcde"):
        for edges in combinations(combinations(joints, 2), 6):
            kind = min(
                tuple(sorted(tuple(sorted((m[a], m[b]))) for a, b in edges))
                for p in permutations(joints)
                for m in [dict(zip(joints, p, strict=True))]
            )
            found[kind] = None
    return list(found)


@pytest.mark.parametrize("legs", graphs_of_few_joints(), ids=lambda legs: " ".join(map("".join, legs)))
def test_outside_the_catalog(legs: tuple[tuple[str, str], ...]) -> None:
    a = analyze_legs(legs)
    assert a.match is None or a.structure.base
    assert (a.condition.kind == "always-singular") == vanishes(a.structure.superbracket)
    for r in (a.condition, *a.readings):
        right = mul(gc.parse(str(r.coefficient)), r.expression)
        assert prove(mul(r.cofactor, a.structure.superbracket), right).proved
    assert a.derivation.check()
    a.to_json()


def test_edges_of_a_tetrahedron() -> None:
    a = analyze_legs("ab ac ad bc bd cd")
    assert a.match is None
    assert str(a.condition.expression) == "[abcd][abcd][abcd]"
    assert "the tetrahedron abcd is flat" in a.condition.statement


def test_long_names() -> None:
    names = {"A": "left", "B": "right", "C": "front", "D": "rear", "E": "top", "a": "arm_1", "b": "cap"}
    for class_id in ("6-5", "3-3.3", "4-4.4", "4-2", "5-5.1"):
        legs = [(names.get(a, a), names.get(b, b)) for a, b in LEGS[class_id].split()]
        a = analyze_legs(legs)
        assert a.match is not None
        assert a.match.entry.id == class_id
        found = a.to_json()
        for r in (found["condition"], *found["readings"]):
            e = gc.parse(r["expression"], points=a.structure.names)
            assert set(points_of(e)) <= set(a.structure.names)
            assert r["expression"] == "0" or prove(e, gc.parse(r["expression"], points=a.structure.names)).proved
            assert not re.search(r"leftarm|leftright|arm_1left|capleft|leftcap", json.dumps(r))


def test_ideal_points() -> None:
    """Base joints at infinity: the identity holds there too, and legs that all lie at infinity are dependent."""
    a = analyze_legs("Aa Ab Bc Bd Ce Cf", ideal=list("ABC"))
    assert a.match is not None
    assert a.match.entry.id == "6-3.2"
    assert not vanishes(a.structure.superbracket, ideal="ABC")
    assert vanishes(a.condition.identity(a.structure.superbracket), ideal="ABC")
    assert a.derivation.check()
    assert analyze_legs("Aa Ab Bc Bd Ca Cb", ideal=list("ABCab")).condition.kind == "always-singular"


@pytest.mark.parametrize("class_id", REGULAR)
@pytest.mark.parametrize("order", ["2 1 3 4 5 6", "6 4 2 1 3 5", "reversed"])
def test_own_order(class_id: str, order: str) -> None:
    legs = LEGS[class_id].split()
    a = analyze_legs(legs, order=" ".join(reversed(legs)) if order == "reversed" else order)
    assert a.condition.kind != "always-singular"
    assert a.derivation.check()
    for r in (a.condition, *a.readings):
        assert vanishes(r.identity(a.structure.superbracket))
        assert not vanishes(r.expression)


# --- the statements, on poses made to fulfil them ------------------------------------------------------------------

SEEDS = pytest.mark.parametrize("seed", range(3))
OF_KIND: dict[str, list[str]] = {}
for _facts in CLASSES:
    OF_KIND.setdefault(_facts["group"] or "none", []).append(_facts["id"])


def superbracket_at(a: Analysis, points: Points) -> int:
    return int(evaluate(a.structure.superbracket, points, modulus=PRIME))


def combination(rng: random.Random, *points: Sequence[int]) -> tuple[int, ...]:
    weights = [rng.randrange(1, PRIME) for _ in points]
    return tuple(sum(w * c for w, c in zip(weights, cs, strict=True)) % PRIME for cs in zip(*points, strict=True))


def at(text: Any, points: Points) -> Any:
    return evaluate(gc.parse(text) if isinstance(text, str) else text, points, modulus=PRIME)


@SEEDS
@pytest.mark.parametrize("class_id", OF_KIND["c"])
def test_four_planes_through_a_point(class_id: str, seed: int) -> None:
    """One joint moved so that its plane passes through the common point of the three others."""
    a = analyze_legs(LEGS[class_id])
    planes = [e.points for e in a.entities]
    assert [e.kind for e in a.entities] == ["plane"] * 4
    rng = random.Random(seed)
    tried = 0
    for n, plane in enumerate(planes):
        others = [p for p in planes if p != plane]
        for joint in plane:
            if any(joint in p for p in others) or len(others) != 3:
                continue
            points = random_points(a.structure.names, seed=100 * seed + n)
            assert superbracket_at(a, points) != 0
            common = at(meet(*(join(*map(Point, p)) for p in others)), points)
            u, v = (points[m] for m in plane if m != joint)
            points[joint] = combination(rng, common, u, v)
            assert superbracket_at(a, points) == 0
            tried += 1
    if not tried:  # every joint is in two planes: let all four pass through one point
        points = random_points([*a.structure.names, "O"], seed=seed)
        points = concurrent(planes, points, seed)
        assert superbracket_at(a, points) == 0


def concurrent(planes: Sequence[tuple[str, ...]], points: Points, seed: int) -> Points:
    """Joints chosen one after the other in the planes through O that already have two other joints."""
    rng = random.Random(seed)
    placed: Points = {}
    for joint in sorted({n for p in planes for n in p}):
        bound = [[placed[m] for m in p if m != joint and m in placed] for p in planes if joint in p]
        full = [b for b in bound if len(b) == 2]
        if not full:
            placed[joint] = points[joint]
        elif len(full) == 1:
            placed[joint] = combination(rng, points["O"], *full[0])
        else:  # on the common line of two planes through O
            (a, b), (c, d) = full
            plane = random_points("efg", seed=seed + 70)
            value = {"O": points["O"], "a": a, "b": b, "c": c, "d": d} | plane
            placed[joint] = at(r"Oab /\ Ocd /\ efg", value)
    return placed


@SEEDS
@pytest.mark.parametrize("class_id", OF_KIND["g"] + OF_KIND["d"] + OF_KIND["e"])
def test_flat_tetrahedra(class_id: str, seed: int) -> None:
    a = analyze_legs(LEGS[class_id])
    flat = [e.points for e in a.entities if e.kind == "tetrahedron"]
    assert len(flat) == (3 if class_id in OF_KIND["g"] else 1)
    rng = random.Random(seed)
    for tetrahedron in flat:
        assert "".join(sorted(tetrahedron)) in a.condition.statement
        points = random_points(a.structure.names, seed=seed)
        assert superbracket_at(a, points) != 0
        joint = rng.choice(tetrahedron)
        points[joint] = combination(rng, *(points[n] for n in tetrahedron if n != joint))
        assert superbracket_at(a, points) == 0


@SEEDS
@pytest.mark.parametrize("class_id", OF_KIND["d"])
def test_two_planes_and_a_line_through_a_point(class_id: str, seed: int) -> None:
    a = analyze_legs(LEGS[class_id])
    (one, two), (line,) = ([e.points for e in a.entities if e.kind == kind] for kind in ("plane", "line"))
    rng = random.Random(seed)
    free = [n for n in (*one, *two, *line) if [n in x for x in (one, two, line)].count(True) == 1]
    assert free
    for joint in free:
        points = random_points(a.structure.names, seed=seed)
        entity = next(x for x in (one, two, line) if joint in x)
        others = [x for x in (one, two, line) if x is not entity]
        rest = [points[n] for n in entity if n != joint]
        crossing = at(meet(*(join(*map(Point, x)) for x in others)), points)
        if len(others[0]) + len(others[1]) == 6:  # two planes share a line: any point of it will do
            value = {n: points[n] for n in (*one, *two)} | {
                "x1": points[line[0]],
                "x2": (1, 2, 3, 4),
                "x3": (2, 7, 1, 9),
            }
            crossing = at(meet(*(join(*map(Point, x)) for x in others), gc.parse("x1x2x3")), value)
        points[joint] = combination(rng, crossing, *rest)
        assert superbracket_at(a, points) == 0


@SEEDS
@pytest.mark.parametrize("class_id", [*OF_KIND["b"], *OF_KIND["e"], "6-5", "5-5.1"])
def test_turning_about_p_and_q(class_id: str, seed: int) -> None:
    """p and q meet the four other legs; where the ratios of g and h agree the determinant vanishes, else not."""
    a = analyze_legs(LEGS[class_id])
    assert [name for name, _ in a.condition.lines] == ["p", "q"]
    p, q = (line for _, line in a.condition.lines)
    points = random_points(a.structure.names, seed=seed)
    legs = {leg: join(*map(Point, leg)) for leg in a.structure.legs}
    meets = {leg: (at(meet(p, e), points), at(meet(q, e), points)) for leg, e in legs.items()}
    assert sum(m == (0, 0) for m in meets.values()) == 4
    g, h = (leg for leg, m in meets.items() if m != (0, 0))
    assert all("".join(leg) in a.condition.statement for leg in (g, h))
    assert superbracket_at(a, points) != 0
    # The ratio is linear in the last joint of h (if that is in no other leg), so three poses on a line fix the root.
    tried = 0
    for leg, other in ((g, h), (h, g)):
        for joint in leg:
            if sum(joint in x for x in legs) > 1:
                continue
            end = next(n for n in leg if n != joint)
            u, v = meets[other]
            start, step = points[joint], random_points(["x"], seed=seed + 50)["x"]
            moments = []
            for place in (start, step):
                moved = points | {joint: place}
                e = join(Point(end), Point(joint))
                moments.append((at(meet(p, e), moved) * v - at(meet(q, e), moved) * u) % PRIME)
            root = tuple((moments[1] * x - moments[0] * y) % PRIME for x, y in zip(start, step, strict=True))
            assert any(root)
            assert superbracket_at(a, points | {joint: root}) == 0
            tried += 1
    assert tried or class_id in ("4-4.7",)


@SEEDS
@pytest.mark.parametrize("class_id", ["6-6", "6-5", "5-5.1"])
def test_one_linear_complex(class_id: str, seed: int) -> None:
    """Each leg's end moved into the plane that a random complex assigns to the other end."""
    a = analyze_legs(LEGS[class_id])
    rng = random.Random(seed)
    form = [[0] * 4 for _ in range(4)]
    for i, j in combinations(range(4), 2):
        form[i][j] = rng.randrange(PRIME)
        form[j][i] = -form[i][j]
    points = random_points(a.structure.names, seed=seed)
    placed: Points = {}
    for joint in points:
        known = [placed[n] for leg in a.structure.legs if joint in leg for n in leg if n in placed]
        rows = [[sum(form[i][j] * k[i] for i in range(4)) % PRIME for j in range(4)] for k in known]
        placed[joint] = solution(rows, points[joint])
    assert superbracket_at(a, placed) == 0
    assert superbracket_at(a, points) != 0


@SEEDS
def test_the_last_leg_against_the_screw_of_the_other_five(seed: int) -> None:
    """The superbracket is (h cos w - r sin w) times the length of the last leg and what the other five make of it; the
    screw is found as a null vector, and pitch, distance and angle by elementary geometry.
    """
    a = analyze_legs(LEGS["6-6"])
    assert "h cos w = r sin w" in a.condition.sentence
    *five, _ = a.structure.legs
    rng = np.random.default_rng(seed)
    places = {n: rng.normal(size=3) for n in a.structure.names}

    def line(p: Any, q: Any) -> Any:
        return np.concatenate([q - p, np.cross(p, q - p)])

    lines = np.array([line(places[p], places[q]) for p, q in five])
    _, _, rows = np.linalg.svd(np.hstack([lines[:, 3:], lines[:, :3]]))
    turn, shift = rows[-1][:3], rows[-1][3:]  # no leg does work on this motion of the platform
    assert np.abs(lines[:, :3] @ shift + lines[:, 3:] @ turn).max() < 1e-12
    axis, pitch = turn / np.linalg.norm(turn), turn @ shift / (turn @ turn)
    foot = np.cross(turn, shift) / (turn @ turn)
    ratios = []
    for _ in range(5):
        p, q = rng.normal(size=(2, 3))
        along = (q - p) / np.linalg.norm(q - p)
        common = np.cross(axis, along)
        common /= np.linalg.norm(common)
        distance = (p - foot) @ common
        if distance < 0:  # from the axis to the leg
            common, distance = -common, -distance
        angle = np.arctan2(np.cross(axis, along) @ common, axis @ along)
        value = np.linalg.det(np.vstack([lines, line(p, q)]))
        moment = pitch * np.cos(angle) - distance * np.sin(angle)
        ratios.append(value / (np.linalg.norm(q - p) * moment))
    assert np.allclose(ratios, ratios[0], rtol=1e-9)


def solution(rows: list[list[int]], start: tuple[int, ...]) -> tuple[int, ...]:
    """A point on the planes with these coordinates, near nothing in particular."""
    if not rows:
        return start
    free = random.Random(start[0])
    points = [tuple(free.randrange(PRIME) for _ in range(4)) for _ in range(len(rows) + 1)]
    for row in rows:
        values = [sum(r * c for r, c in zip(row, p, strict=True)) % PRIME for p in points]
        points = [
            tuple((values[0] * c - values[i] * b) % PRIME for c, b in zip(points[i], points[0], strict=True))
            for i in range(1, len(points))
        ]
    return points[0]


# --- errors --------------------------------------------------------------------------------------------------------

FAULTS = [
    pytest.param("ab af cb cd ed ee", "<input>:1:16: 'ee' is not a leg: both ends are e", None, id="to itself"),
    pytest.param("ab af cb cd ed", "<input>:1:1: 5 legs, expected six", "two points written together", id="five"),
    pytest.param("ab af cb cd ed ef gh", "<input>:1:1: 7 legs, expected six", "two points", id="seven"),
    pytest.param("Aa Bb Cc", "<input>:1:1: 3 legs, expected six", "rank 3", id="three"),
    pytest.param("", "0 legs, expected six", "two points", id="none"),
    pytest.param("ab af cb cd ed efg", "'efg' is not a leg", "two points written together", id="three points"),
    pytest.param("ab af cb cd ed e", "'e' is not a leg", "two points written together", id="one point"),
    pytest.param("ab, af, cb, cd, ed, a?", "'a?' is not a leg", None, id="no name"),
    pytest.param("ab af cb cd ed [abcd]", "'[abcd]' is not a leg", "two points", id="a bracket"),
]


@pytest.mark.parametrize(("legs", "message", "hint"), FAULTS)
def test_faults(legs: str, message: str, hint: str | None) -> None:
    with pytest.raises(InputError) as fault:
        analyze_legs(legs)
    assert message in str(fault.value)
    assert hint is None or hint in (fault.value.hint or "")
    assert "error" in fault.value.render()


@pytest.mark.parametrize(
    "legs", [[("a", "b")] * 5, [("a", "a")] * 6, [("a", "b", "c")] * 6, ["ab"] * 7, [("", "a")] * 6, [("a b", "c")] * 6]
)
def test_faults_in_pairs(legs: Any) -> None:
    with pytest.raises(InputError):
        analyze_legs(legs)


@pytest.mark.parametrize(
    "order", ["1 2 3 4 5", "1 1 2 3 4 5", "1 2 3 4 5 7", "ab af cb cd ed ab", "ab af cb cd ed gh", "x"]
)
def test_faults_of_an_order(order: str) -> None:
    with pytest.raises(InputError):
        analyze_legs("ab af cb cd ed ef", order=order)


def test_groups_are_the_published_ones() -> None:
    assert Counter(analyze_legs(LEGS[i]).group for i in REGULAR) == Counter(c["group"] for c in CLASSES if c["regular"])
    assert {rule.group for rule in INCIDENCES} == {"b", "c", "d", "e", "g"}
    assert issubclass(LimitReached, gc.GcrulesError)


@pytest.mark.parametrize("class_id", REGULAR)
def test_the_condition_does_not_depend_on_how_legs_are_written(class_id: str) -> None:
    """Turning single legs changes signs at most: kind, cofactor and planes stay."""
    rng = random.Random(class_id)
    legs = LEGS[class_id].split()
    first = analyze_legs(legs).condition
    cofactor = gc.straighten(first.cofactor)
    for _ in range(6):
        turned = analyze_legs([leg[::-1] if rng.random() < 0.5 else leg for leg in legs]).condition
        assert turned.kind == first.kind
        assert gc.straighten(turned.cofactor) in (cofactor, -cofactor)
        assert {frozenset(e.points) for e in turned.entities} == {frozenset(e.points) for e in first.entities}
