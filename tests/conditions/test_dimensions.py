"""What the numbers of a platform say beyond its names: each decision on two roads."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import pairwise
from random import Random
from typing import Any

import pytest
from commands import invoke
from places import EXAMPLES

import gcrules as gc
from gcrules.conditions.dimensions.architecture import balance, lines_at, singular_everywhere, whole
from gcrules.conditions.dimensions.bodies import body_facts
from gcrules.conditions.dimensions.dimensions import dimensions_of
from gcrules.conditions.dimensions.related import hand_of, relations
from gcrules.core.errors import InputError
from gcrules.core.linear_algebra import rank
from gcrules.mechanisms.description.platform_file import load_platform

Place = tuple[Any, Any, Any]

DRAW = Random(7)


def anywhere(number: int = 6, *, flat: bool = False) -> list[Place]:
    """Random whole places."""
    return [(DRAW.randint(-99, 99), DRAW.randint(-99, 99), 0 if flat else DRAW.randint(-99, 99)) for _ in range(number)]


def on_circle() -> list[Place]:
    """Six exact places of a circle."""
    found = []
    for s in map(Fraction, ("0", "1/2", "1/3", "2", "3", "-1")):
        found.append(((1 - s * s) / (1 + s * s), 2 * s / (1 + s * s), Fraction(0)))
    return found


def mapped(places: list[Place], a: int, b: int, c: int, d: int, *, weight: int = 0) -> list[Place]:
    """An affine image of plane places, with `weight` a projective one."""
    return [
        (Fraction(a * x + b * y + 1) / (9 + weight * x), Fraction(c * x + d * y) / (9 + weight * x), Fraction(5))
        for x, y, _ in (tuple(map(Fraction, p)) for p in places)
    ]


LINE = [(x, 0, 0) for x in (0, 1, 2, 5)]
PLANE = anywhere(flat=True)
SPACE = anywhere()
CASES = {
    "in general": (SPACE, anywhere(), False),
    "both plane": (PLANE, anywhere(flat=True), False),
    "similar, on no conic": (PLANE, mapped(PLANE, 3, -4, 4, 3), False),
    "affine, on no conic": (PLANE, mapped(PLANE, 3, 1, 2, 5), False),
    "similar in space": (SPACE, [(2 * x, 2 * y, 2 * z) for x, y, z in SPACE], False),
    "similar, on a circle": (on_circle(), mapped(on_circle(), 3, -4, 4, 3), True),
    "affine, on a circle": (on_circle(), mapped(on_circle(), 3, 1, 2, 5), True),
    "projective, on a conic": (on_circle(), mapped(on_circle(), 3, 1, 2, 5, weight=1), True),
    "projective, on no conic": (PLANE, mapped(PLANE, 3, 1, 2, 5, weight=2000), False),
    "four on lines, in one ratio": (LINE + SPACE[:2], [(3 * x, 7, 1) for x, _, _ in LINE] + SPACE[2:4], True),
    "four on lines, not so": (LINE + SPACE[:2], [(x, 7, 1) for x in (0, 3, 6, 16)] + SPACE[2:4], False),
    "four in one joint": ([(0, 0, 0)] * 4 + SPACE[:2], anywhere(), True),
    "all on a line": ([(x, 0, 0) for x in range(6)], anywhere(), True),
    "five on a line": ([(x, 0, 0) for x in range(5)] + [(3, 4, 5)], anywhere(), False),
}


@pytest.mark.parametrize("case", CASES)
def test_singular_in_every_pose(case: str) -> None:
    """The lattice beside exact ranks at random poses, and where a relation is known, beside it."""
    base, platform, expected = CASES[case]
    found = singular_everywhere(base, platform)
    assert found.everywhere is expected
    draw = Random(case)
    ranks = set()
    for _ in range(4):
        q, t = [draw.randint(1, 99) for _ in range(4)], [draw.randint(-99, 99) for _ in range(3)]
        ranks.add(rank(lines_at(*whole(base, platform), q, t)))
    assert (max(ranks) < 6) is expected
    if balance(base, platform):
        assert expected


def _platform(base: list[Place], platform: list[Place]) -> gc.Platform:
    points = dict(zip("ABCDEFabcdef", [*base, *platform], strict=True))
    return gc.Platform(legs=tuple(zip("ABCDEF", "abcdef", strict=True)), points=points, units="m", title="one")


def test_the_locus_says_the_same() -> None:
    """The expansion of the superbracket in all coordinates of the pose is another road."""
    for case in ("similar, on a circle", "four on lines, in one ratio"):
        platform = _platform(*CASES[case][:2])
        assert gc.locus(platform, over="x y z").vanishes
        assert gc.analyze(platform).dimensions.architecture.singular


def test_an_architecture_is_told_everywhere() -> None:
    platform = _platform(*CASES["similar, on a circle"][:2])
    a = gc.analyze(platform)
    assert a.dimensions is not None
    said = a.dimensions.architecture.sentence
    assert said.startswith("Architecturally singular: this robot is singular in every pose")
    assert "similar, with the joints of the base on a circle" in said
    assert "Whatever its dimensions, the robot is singular exactly when" in " ".join(a.text().split())
    assert said in " ".join(a.text().split())
    assert said.split(":", 1)[0] in gc.report(a, interactive=False)
    assert "Dimensions" in a.latex()
    assert said in gc.pose(platform, "x=1, roll=20deg", nearest=False).reason
    forces = [Fraction(share) for _, share in a.dimensions.architecture.stress]
    assert len(forces) == 6
    for q, t in (((3, 1, 4, 1), (5, 9, 2)), ((2, 7, 1, 8), (-2, 8, 1))):
        rows = lines_at(*whole(*CASES["similar, on a circle"][:2]), q, t)
        assert not any(sum(f * c for f, c in zip(forces, column, strict=True)) for column in zip(*rows, strict=True))


def test_nearly_so() -> None:
    base, platform, _ = CASES["similar, on a circle"]
    moved = [(x + Fraction(1, 10**6), y, z) if i == 2 else (x, y, z) for i, (x, y, z) in enumerate(platform)]
    found = dimensions_of(gc.analyze("Aa Bb Cc Dd Ee Ff").structure, _platform(base, moved).points)
    assert found is not None
    assert found.architecture.verdict == "nearly singular"
    similar = next(f for f in found.facts if f.kind == "similar")
    assert not similar.exact
    assert "nearly" in similar.sentence
    found = dimensions_of(gc.analyze("Aa Bb Cc Dd Ee Ff").structure, _platform(base, moved).points, 1e-9)
    assert found is not None
    assert found.architecture.verdict == "regular"
    with pytest.raises(InputError):
        dimensions_of(gc.analyze("Aa Bb Cc Dd Ee Ff").structure, _platform(base, moved).points, -1)


def test_facts_of_a_body() -> None:
    places = {"A": (0, 0, 0), "B": (2, 0, 0), "C": (4, 0, 0), "D": (1, 3, 0), "E": (1, 3, 0), "F": (0, 0, 1)}
    found = [(f.kind, "".join(f.members)) for f in body_facts(places, "base")]
    assert found == [("coincident", "DE"), ("collinear", "ABC")]
    lifted = {**places, "F": (7, 7, 0)}
    assert ("coplanar", "ABCDEF") in [(f.kind, "".join(f.members)) for f in body_facts(lifted, "base")]


def test_symmetry() -> None:
    base = [(2, 0, 0), (0, 2, 0), (-2, 0, 0), (0, -2, 0), (0, 0, 3), (0, 0, -5)]
    facts = dimensions_of(
        gc.analyze("Aa Bb Cc Dd Ee Ff").structure, _platform(base, [(3 * y, 3 * x, 2 * z) for x, y, z in base]).points
    )
    assert facts is not None
    turn = next(f for f in facts.facts if f.kind == "rotation")
    assert turn.order == 4
    assert turn.exact
    (cycle,) = turn.members
    legs = [word[0] for word in cycle.split("→")]
    assert all({a, b} not in ({"A", "C"}, {"B", "D"}) for a, b in pairwise(legs))


@pytest.mark.parametrize("tolerance", [0.0, 1e-5])
def test_a_mirror_is_exact_where_the_numbers_are(tolerance: float) -> None:
    """A joint that is off by less than floats tell ends a mirror that is to hold exactly, and no other one."""
    base = [(2, 1, 0), (-2, 1, 0), (3, -1, 0), (-3, -1, 0), (1, 4, 0), (-1, 4, 0)]
    for off, exact in ((Fraction(0), [True]), (Fraction(1, 10**40), [False] if tolerance else [])):
        moved = [(x + off, y, z) if i == 3 else (x, y, z) for i, (x, y, z) in enumerate(base)]
        facts = dimensions_of(
            gc.analyze("Aa Bb Cc Dd Ee Ff").structure,
            _platform(moved, [(y, x, 0) for x, y, _ in base]).points,
            tolerance,
        )
        assert facts is not None
        assert [f.exact for f in facts.facts if f.kind == "mirror"] == exact


def test_joints_that_coincide_are_one() -> None:
    loaded = load_platform(EXAMPLES / "platform-6-3.yaml")
    names = dict(zip("abcdef", "aabbcc", strict=True))
    points = {n: loaded.points[n] for n in "ABCDEF"} | {n: loaded.points[old] for n, old in names.items()}
    twelve = gc.Platform(legs=tuple(zip("ABCDEF", "abcdef", strict=True)), points=points)
    found = gc.analyze(twelve).dimensions
    assert found is not None
    assert found.own is not None
    assert found.own.condition.kind == gc.analyze(loaded).condition.kind == "four-planes"
    assert dict(found.own.names) == {"b": "a", "d": "c", "f": "e"}
    assert "four planes" in gc.analyze(twelve).text()
    assert gc.analyze(twelve, facts=False).dimensions is None


def test_given_beside_coordinates() -> None:
    file = str(EXAMPLES / "platform-6-3.yaml")
    a = gc.analyze(file, given="coplanar(A, B, C, D, E, F)")
    assert a.structure.given
    assert a.pose is not None
    assert gc.pose(a, "z=0.1, roll=5deg", nearest=False).verdict == "regular"
    for wrong, why in (
        ("collinear(A, B, C)", "miss one line by 0.286068 m"),
        ("coplanar(A, B, a, b)", "of base and platform"),
        ("[ABCD] == 1", "what should vanish is"),
    ):
        with pytest.raises(InputError) as fault:
            gc.analyze(file, given=wrong)
        assert why in fault.value.message or "cannot be resolved" in fault.value.message


def test_on_the_command_line() -> None:
    file = str(EXAMPLES / "platform-6-3.yaml")
    told = json.loads(invoke("analyze", file, "--json").stdout)["dimensions"]
    assert [f["kind"] for f in told["facts"]] == ["coplanar"]
    assert told["architecture"]["verdict"] == "regular"
    assert json.loads(invoke("analyze", file, "--no-facts", "--json").stdout)["dimensions"] is None
    assert invoke("analyze", file, "--given", "collinear(A, B, C)").exit_code == 2
    assert invoke("analyze", file, "--tolerance", "0.5").exit_code == 2


def test_a_body_that_is_nearly_plane_has_no_hand() -> None:
    """Bodies that miss a plane by less than the tolerance, to one side or the other, are similar and not mirrored."""
    base = [(0, 0, 0), (4, 0, 0), (5, 3, 0), (0, 3, 0), (1, 7, 0), (2, 2, 0)]
    up, down = ([(x, y, sign * Fraction(1, 10**7) * (i == 3)) for i, (x, y, _) in enumerate(base)] for sign in (1, -1))
    assert [f.kind for f in relations(up, down, ("Aa",) * 6, 1e-5)] == ["similar"]


def test_bodies_in_space_have_one() -> None:
    base = [(0, 0, 0), (4, 0, 0), (5, 3, 0), (0, 3, 2), (1, 7, 0), (2, 2, 5)]
    mirrored = [(x, y, -z) for x, y, z in base]
    assert [f.kind for f in relations(base, mirrored, ("Aa",) * 6, 1e-5)] == ["mirrored"]


def test_a_mirror_of_a_body_that_is_nearly_plane() -> None:
    """The mirror of a kite in its own plane is none of space, though one corner is off the plane by a little."""
    kite = [(0, 3, Fraction(1, 10**8)), (-1, 0, 0), (1, 0, 0), (0, -1, 0)]
    assert hand_of(kite, (0, 2, 1, 3), 1e-5) == -1
    assert hand_of([(1, 0, Fraction(1, 10**8)), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], (1, 2, 3, 0), 1e-5) == 1


def test_a_regular_pose_asks_for_no_facts(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_: object) -> None:
        raise AssertionError("facts were computed")

    monkeypatch.setattr("gcrules.poses.pose_report.architecture_at", refused)
    assert gc.pose(load_platform(EXAMPLES / "octahedral.yaml"), "z=1").verdict == "regular"


@pytest.mark.parametrize("body", ["base", "platform"])
def test_a_plane_body_is_not_searched_for_long(body: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_: object) -> None:
        raise AssertionError("a condition was sought")

    monkeypatch.setattr("gcrules.conditions.dimensions.own._analysed", refused)
    rounded = [(0, 0, 0), (4, 0, 0), (5, 3, 1), (0, 3, 2), (1, 7, 0), (2, 2, 5)]
    flat = [(0, 0, 1), (4, 0, 1), (5, 4, 1), (0, 3, 1), (1, 6, 1), (-2, 2, 1)]
    found = gc.analyze(_platform(*((flat, rounded) if body == "base" else (rounded, flat)))).dimensions
    assert found is not None
    assert "no class of the catalog" in found.note
