"""Robot files: their faults and places, relations, joints, the schema for editors."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from commands import invoke
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanisms.shipped_robots import GIVEN_BY_LINES, GOOD
from places import EXAMPLES

import gcrules as gc
from gcrules.algebra.evaluate import PRIME
from gcrules.core.errors import GcrulesError, InputError
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.limb_file import read_joints
from gcrules.mechanisms.description.relations import RELATIONS, relation
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.description.skeleton import skeleton
from gcrules.mechanisms.lines.singular import interpolated, roots
from gcrules.mechanisms.load import read_robot
from gcrules.rules.plugin import shipped_folder
from gcrules.screws import JOINTS, RESIDUES

IDS = tuple(one.id for one in robots())


def told(text: str) -> str:
    with pytest.raises(GcrulesError) as caught:
        parse_robot(text, "robot.yaml")
    assert caught.value.exit_code == 2
    return caught.value.render()


FAULTS: dict[str, tuple[str, str, str]] = {
    # what is replaced, by what, what is said and where
    "unknown joint": ("P*(A% S%)", "Q*(A% S%)", "robot.yaml:10:23: 'Q' is not a kind of joint"),
    "near joint": ("P*(A% S%)", "p*(A% S%)", "did you mean P"),
    "no actuated joint": ("P*", "P", "robot.yaml:10:13: no joint is actuated"),
    "too few actuators": (
        "  - name: leg %\n    joints: R(A%, r%) P*(A% S%) S(S%)",
        "  - joints: R(A1, r1) P*(A1 S1) S(S1)\n  - joints: R(A2, r2) P(A2 S2) S(S2)\n"
        "  - joints: R(A3, r3) P(A3 S3) S(S3)",
        "too few actuators: 1 for a platform of mobility 3",
    ),
    "limb of mobility 7": ("S(S%)", "S(S%) R(A%, x) R(A%, y)", "leg 1 has mobility 7"),
    "wrong mobility": ("mobility: 3", "mobility: 4", "robot.yaml:11:11: the platform has mobility 3, not 4"),
    "coincident points": ("  S%: in", "  T1: A1\n  S%: in", "A1 and T1 are in one place"),
    "zero direction": (
        "  r%: free",
        "  r%: free\n  w: r1 - r1",
        "the direction w is zero, whatever the coordinates are",
    ),
    "zero product": ("  r%: free", "  r%: free\n  w: perpendicular to r1, r1", "the direction w is zero"),
    "no plane": (
        "  S%: in",
        "  T1: in plane A1 along r1, r1\n  S%: in",
        "there is no plane on which T1 could lie",
    ),
    "no line": ("  S%: in", "  T1: on line A1 A1\n  S%: in", "there is no line on which T1 could lie"),
    "contradiction": ("mobility: 3", 'mobility: 3\nfacts: ["r1 parallel to r2"]', "does not follow from the relations"),
    "cycle": ("  r%: free", "  r%: perpendicular to A% S%", "is defined in terms of itself"),
    "self": ("  r%: free", "  r%: free\n  w: parallel to w", "w is defined in terms of itself"),
    "unknown name": ("A%: free", "A%: free\n  B1: A1 + Q7 - A2", "Q7 is not defined"),
    "unknown in joint": ("S(S%)", "S(T%)", "robot.yaml:10:33: T1 is not defined"),
    "direction for point": ("R(A%, r%)", "R(r%, r%)", "r1 is a direction, and R(r1, r1) needs a point there"),
    "point for direction": ("R(A%, r%)", "R(A%, A%)", "A1 is a point, and R(A1, A1) needs a direction there"),
    "wrong number of parts": ("R(A%, r%)", "R(A%)", "a joint R takes 2 parts, found 1"),
    "no such drive": ("S(S%)", "S*(S%)", "this freedom of a joint S cannot be actuated"),
    "weights": ("A%: free", "A%: free\n  B1: A1 + A2", "A1 is not a point"),
    "no relation": ("A%: free", "A%: free\n  B1: near A1", "'near A1' is not a relation for a point"),
    "axis as a name": ("A%: free", "A%: free\n  x: free", "x is a direction of the frame"),
    "bad name": ("A%: free", "A%: free\n  foot: free", "'foot' is not a name"),
    "twice": ("  r%: free", "  r%: free\n  A1: free", "A1 is defined twice"),
    "copies missing": ("copies: 3\n", "", "there is no key copies"),
    "copies missing for the platform": ("copies: 3\n", "platform: S%\n", "robot.yaml:2:11: % stands for the numbers"),
    "many copies": ("copies: 3", "copies: 99", "copies are 1 to 12"),
    "parallel axes": ("R(A%, r%)", "U(A%, r%, r%)", "the two axes of a joint U are parallel"),
    "tag": (
        "title: three",
        "title: !!python/object:os.system three",
        "tags (tag:yaml.org,2002:python/object:os.system)",
    ),
    "anchor": ("title: three", "title: &a three", "anchors (&a) are not read"),
    "unknown key": ("mobility", "code: import os\nmobility", "unknown key 'code'"),
    "no limbs": ("limbs:\n  - name: leg %\n    joints: R(A%, r%) P*(A% S%) S(S%)\n", "", "the key 'limbs' is missing"),
    "empty limbs": ("limbs:\n  - name: leg %\n    joints: R(A%, r%) P*(A% S%) S(S%)\n", "limbs: []\n", "no limbs"),
    "same limb": ("name: leg %", "name: leg", "two limbs are named 'leg'"),
    "long relation": ("A%: free", "A%: free\n  B1: A1" + " " * 400 + "+ x", "more than 300 characters"),
    "home missing": ("mobility: 3", "mobility: 3\nhome: {A1: [0, 0, 0]}", "home gives no coordinates for"),
    "home numbers": ("mobility: 3", "mobility: 3\nhome: {A1: [0, 0, 0, 0]}", "a list of 4, expected 3"),
    "home unknown": ("mobility: 3", "mobility: 3\nhome: {Q1: [0, 0, 0]}", "Q1 is not defined"),
    "platform": ("mobility: 3", "mobility: 3\nplatform: r1", "r1 is not a point"),
    "division by zero": ("A%: free", "A%: free\n  B1: A1 + 1/0 x", "division by zero"),
    "lines and limbs": ("mobility: 3", "mobility: 3\nlines: A1S1", "by its limbs or by lines, not by both"),
    "planar": ("copies: 3", "copies: 3\nspace: plane", "S1 does not lie in the plane z = 0 of a planar robot"),
}


LINES = """title: six lines
copies: 6
points: {A%: free, B%: free}
mobility: 6
lines: """

PAIRS = {
    "one text": "A1B1 A2B2 A3B3 A4B4 A5B5 A6B6",
    "a list": "[A1B1, A2 B2, [A3, B3], A4B4, A5 B5, [A6, B6]]",
    "copies": "A%B%",
    "copies in a list": "[A% B%]",
    "copies of two names": "[[A%, B%]]",
}

FAULTY_PAIRS = {
    "three names": ("[A1B1C1, A2B2]", "5:9", "the line 'A1B1C1' does not name two points"),
    "unknown": ("[A1B1, A2C2]", "5:15", "C2 is not defined"),
    "one point": ("A1A1", "5:8", "the line A1A1 goes from a point to itself"),
    "too few": ("[A1B1]", "5:8", "1 line, expected 6"),
    "none": ("[]", "5:8", "there are no lines"),
    "a single name": ("[[A1]]", "5:9", "a list of 1, expected 2"),
}


@pytest.mark.parametrize("written", PAIRS.values(), ids=PAIRS)
def test_lines_are_written_like_legs(written: str) -> None:
    assert parse_robot(LINES + written).lines == tuple((f"A{n}", f"B{n}") for n in range(1, 7))


@pytest.mark.parametrize(("written", "place", "said"), FAULTY_PAIRS.values(), ids=FAULTY_PAIRS)
def test_faults_of_lines(written: str, place: str, said: str) -> None:
    found = told(LINES + written)
    assert said in found
    assert f":{place}: " in found


@pytest.mark.parametrize(("old", "new", "said"), FAULTS.values(), ids=FAULTS)
def test_faults_have_a_message_and_a_place(old: str, new: str, said: str) -> None:
    assert old in GOOD
    found = told(GOOD.replace(old, new))
    assert said in found
    assert "robot.yaml:" in found


def test_all_faults_come_out_at_once() -> None:
    found = told(GOOD.replace("S(S%)", "S(T%)").replace("A%: free", "A%: free\n  B1: near A1\n  foot: free"))
    assert found.count("error:") == 3


def test_home_that_violates_a_relation() -> None:
    home = "home: {A1: [1,0,0], A2: [-1,2,0], A3: [-1,-2,0], r1: [0,1,0], r2: [2,1,0], r3: [2,-1,0],"
    good = f"{GOOD}{home} S1: [1/2,0,2], S2: [-1/2,1,2], S3: [-1/2,-1,2]}}\n"
    assert parse_robot(good).home
    assert "at home S1 is not as its relation says" in told(good.replace("S1: [1/2,0,2]", "S1: [1/2,1,2]"))
    assert "home violates" not in told(good.replace("r1: [0,1,0]", "r1: [0,0,0]"))
    assert "S2 is in the same place as another point" in told(good.replace("S2: [-1/2,1,2]", "S2: [-1,2,0]"))


def test_large_files_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "robot.yaml"
    path.write_bytes(b"#" * 10_000_000)
    with pytest.raises(InputError, match="larger than"):
        read_robot(path)


def test_bombs_are_refused() -> None:
    bomb = "a: &a [x, x]\n" + "\n".join(f"{b}: &{b} [*{a}, *{a}]" for a, b in zip("abcdefgh", "bcdefghi", strict=True))
    assert "aliases" in told(bomb)


@settings(max_examples=60)
@given(st.text(alphabet="RPUS*(),:%A1r xy\n-+/free", max_size=60), st.sampled_from(["joints", "A%", "r%", "mobility"]))
def test_any_text_is_read_or_refused_with_a_place(junk: str, key: str) -> None:
    text = re.sub(rf"({re.escape(key)}:).*", lambda m: f"{m[1]} {json.dumps(junk)}", GOOD, count=1)
    try:  # anything but a refusal is a fault of gcrules
        parse_robot(text)
    except GcrulesError as refusal:
        faults: tuple[GcrulesError, ...] = getattr(refusal, "faults", (refusal,))
        for fault in faults:
            assert fault.source == text
            assert fault.span is not None, fault
            assert 0 <= fault.span.start <= fault.span.end <= len(text)
            assert re.fullmatch(r".+:\d+:\d+", fault.place or "")


# --- relations and joints --------------------------------------------------------------------------------------------

WRITTEN = {
    "point": ["free", "on line A B", "on line A along u", "in plane A B C", "in plane A along u, v", "B + C - A",
              "A + u", "in plane A perpendicular to u", "in plane A normal to B C", "1/2 A + 1/2 B"],
    "direction": ["free", "along A B", "parallel to u", "perpendicular to u", "perpendicular to u, v", "in span u, A B",
                  "u + 2 v", "B - A", "mirror of u in plane perpendicular to v", "mirror of u in plane normal to A B"],
}  # fmt: skip


@pytest.mark.parametrize(("sort", "text"), [(s, t) for s, ts in WRITTEN.items() for t in ts])
def test_values_satisfy_their_relation_and_others_do_not(sort: str, text: str) -> None:
    rng = random.Random(text)
    values = {n: tuple(rng.randrange(PRIME) for _ in range(3)) for n in "ABCuv"}
    found = relation(sort, text)
    parameters = [rng.randrange(PRIME) for _ in range(found.parameters(sort))]
    own = found.value(sort, RESIDUES, values, parameters)
    assert not any(found.residual(sort, RESIDUES, values, own))
    other = tuple(rng.randrange(PRIME) for _ in range(3))
    assert any(found.residual(sort, RESIDUES, values, other)) == (text != "free")


def test_every_form_of_relation_is_tested() -> None:
    kinds = {relation(sort, text).kind for sort, texts in WRITTEN.items() for text in texts}
    assert kinds == {kind for forms in RELATIONS.values() for kind in forms} | {"sum"}


@pytest.mark.parametrize(
    ("text", "actuated"),
    [("R*(A, u)", (0,)), ("U*(A, u, v)", (0, 1)), ("U*2(A, u, v)", (1,)), ("C*1(A, u)", (0,)), ("E*(A, u)", (2,))],
)
def test_stars_mark_what_is_driven(text: str, actuated: tuple[int, ...]) -> None:
    assert read_joints(text)[0].actuated == actuated
    assert str(read_joints(text)[0]) == text


def test_roots_are_roots() -> None:
    rng = random.Random(5)
    for _ in range(20):
        wanted = {rng.randrange(PRIME) for _ in range(4)}

        def value(t: int, wanted: set[int] = wanted) -> int:
            product = t * t + 1  # no roots: the prime is 3 mod 4
            for root in wanted:
                product = product * (t - root) % PRIME
            return product

        assert set(roots(interpolated(value) or [])) == wanted
    assert roots([]) == roots([5]) == ()


# --- the schema for editors ------------------------------------------------------------------------------------------

SCHEMA = json.loads((Path(gc.__file__).parent / "mechanisms" / "description" / "robot.schema.json").read_text("utf-8"))


def fits(value: Any, schema: Any) -> bool:
    """Whether a value fits a schema, as far as the keywords go that this schema uses."""
    if "$ref" in schema:
        return fits(value, SCHEMA["$defs"][schema["$ref"].rsplit("/", 1)[1]])
    kinds = {"object": dict, "array": list, "string": str, "integer": int, "number": (int, float)}
    if "type" in schema and not isinstance(value, kinds[schema["type"]]):
        return False
    tests = [
        "enum" not in schema or value in schema["enum"],
        "anyOf" not in schema or any(fits(value, s) for s in schema["anyOf"]),
        "oneOf" not in schema or sum(fits(value, s) for s in schema["oneOf"]) == 1,
        "not" not in schema or not fits(value, schema["not"]),
        "minimum" not in schema or value >= schema["minimum"],
        "maximum" not in schema or value <= schema["maximum"],
        "minItems" not in schema or len(value) >= schema["minItems"],
        "maxItems" not in schema or len(value) <= schema["maxItems"],
        "pattern" not in schema or re.search(schema["pattern"], value) is not None,
        all(key in value for key in schema.get("required", ())),
    ]
    if isinstance(value, dict):
        known = schema.get("properties", {})
        more = schema.get("additionalProperties", True)
        tests += [fits(v, known[k]) for k, v in value.items() if k in known]
        tests += [more is not False and (more is True or fits(v, more)) for k, v in value.items() if k not in known]
        tests += [fits(k, schema["propertyNames"]) for k in value if "propertyNames" in schema]
    if isinstance(value, list) and "items" in schema:
        tests += [fits(v, schema["items"]) for v in value]
    return all(tests)


def texts() -> Sequence[tuple[str, str]]:
    folder = shipped_folder()
    assert folder is not None
    return [*((n, (folder / n / "robot.yaml").read_text("utf-8")) for n in IDS), ("new", skeleton("new")),
            ("lines", GIVEN_BY_LINES), ("limits", f"{skeleton('new')}limits: q1 -30..30 deg, q2 0..\n")]  # fmt: skip


@pytest.mark.parametrize(("name", "text"), texts(), ids=[name for name, _ in texts()])
def test_files_fit_the_schema(name: str, text: str) -> None:
    import yaml

    assert fits(yaml.safe_load(text), SCHEMA)


def test_the_schema_knows_ranges() -> None:
    limits = SCHEMA["properties"]["limits"]
    assert fits("legs 1..2, q1 ..3 deg", limits)
    assert not fits("q1 1..2, q2 3", limits)


@pytest.mark.parametrize(
    "case",
    [
        "unknown joint",
        "unknown key",
        "many copies",
        "axis as a name",
        "home numbers",
        "no limbs",
        "lines and limbs",
        "bad name",
    ],
)
def test_the_schema_refuses_faults(case: str) -> None:
    import yaml

    old, new, _ = FAULTS[case]
    assert not fits(yaml.safe_load(GOOD.replace(old, new)), SCHEMA)


def test_the_schema_knows_all_joints() -> None:
    assert all(re.search(SCHEMA["$defs"]["joints"]["pattern"], f"{symbol}(A)") for symbol in JOINTS)


def test_a_platform_is_told_in_one_fault() -> None:
    run = invoke("robot", "check", str(EXAMPLES / "octahedral.yaml"))
    assert run.exit_code == 2
    assert run.stderr.count("error: ") == 1
    assert "octahedral.yaml:5:1: these are the legs of a platform" in run.stderr
