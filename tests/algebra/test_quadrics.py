"""Points that quadratic equations put on conics and quadrics."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from itertools import permutations
from pathlib import Path

import pytest
from algebra.under_assumptions import script_of
from commands import invoke
from places import checker

import gcrules as gc
from gcrules.algebra.assumptions.assumed import equations, kinds, resolve
from gcrules.algebra.assumptions.quadrics import quadric
from gcrules.algebra.assumptions.strategies import as_written, on_quadrics
from gcrules.algebra.evaluate import PRIME, evaluate
from gcrules.algebra.expr import Point, points_of
from gcrules.algebra.language.syntax import parse

# An equation, its rank, the point of which it is quadratic, and the others at which it vanishes always.
QUADRICS = [
    ("[abp][cdp] - 2 [acp][bdp]", 3, "p", "abcd"),
    ("[abc][ade][bdp][cep] - [abd][ace][bcp][dep]", 3, "p", "abcde"),
    ("[abi][abj][cij]**2 [dij]**2 - [cdi][cdj][aij]**2 [bij]**2", 3, "a", "ij"),
    ("[abcp][defp] - 2 [abdp][cefp]", 4, "p", "abcdef"),
    (r"[(pab /\ pcd), e, f]", 4, "p", "abcdef"),
    ("[ap][bp] - 2 [ac][bp][cp]", 2, "p", ""),
]


def coordinates(names: str, rank: int, seed: int) -> dict[str, tuple[int, ...]]:
    rng = random.Random(seed)
    return {n: tuple(rng.randint(-30, 30) for _ in range(rank)) for n in names}


@pytest.mark.parametrize(("text", "rank", "name", "known"), QUADRICS[:-1])
def test_the_equation_of_a_point(text: str, rank: int, name: str, known: str) -> None:
    """It is the scalar; its polar form is what a square has in the middle, and its points are on it."""
    e = parse(text, rank=rank)
    found = quadric(e, name, rank)
    assert found is not None
    assert "".join(sorted(map(str, found.known))) == known
    for seed in range(3):
        at = coordinates("".join(points_of(e)) + "xy", rank, seed)
        x, y = at["x"], at["y"]
        both = {**at, "z": tuple(a + b for a, b in zip(x, y, strict=True))}
        values = {n: evaluate(found.at(Point(n)), both) for n in "xyz"}
        assert values["x"] == evaluate(e, {**at, name: x})
        assert evaluate(found.polar(Point("x"), Point("y")), at) == values["z"] - values["x"] - values["y"]
        assert evaluate(found.polar(Point("x"), Point("x")), at) == 2 * values["x"]
        for n in known:
            assert evaluate(found.at(Point(n)), at) == 0


@pytest.mark.parametrize(("text", "rank", "name", "known"), QUADRICS[:-1])
def test_the_second_point_of_a_line(text: str, rank: int, name: str, known: str) -> None:
    """It is on the quadric, and on the line; from a point of the quadric comes this point itself."""
    e = parse(text, rank=rank)
    found = quadric(e, name, rank)
    assert found is not None
    for n in known:
        at = coordinates("".join(points_of(e)) + "r", rank, 5)
        parts = found.parts(Point(n), "r")

        def second() -> tuple[int, ...]:
            return tuple(map(sum, zip(*(evaluate(part, at) for part in parts), strict=True)))  # noqa: B023

        p = second()
        assert any(p)
        assert evaluate(e, {**at, name: p}) == 0
        polar = evaluate(found.polar(Point(n), Point("r")), {**at, "r": p})
        at["r"] = p
        assert polar
        assert second() == tuple(-polar * c for c in p)


@pytest.mark.parametrize(
    ("text", "rank", "name"),
    [
        ("[abp]", 3, "p"),
        ("[abp][acp][bcp]", 3, "p"),
        ("[abp][cdp] - [abc][adp]", 3, "p"),
        ("[abp]**2 - [cdp]**2", 3, "p"),
        ("[abp]**2 - 2 [acp]**2", 3, "p"),
        ("[ijp]**2 [aij]**2 [abi]**2 - [cip]**2 [aij]**2 [bij]**2", 3, "p"),
        ("abp", 4, "p"),
        ("[abc]", 3, "p"),
    ],
)
def test_what_tells_no_point_of_a_quadric(text: str, rank: int, name: str) -> None:
    """Another degree, no point that is known, only a double point, or no scalar."""
    assert quadric(parse(text, rank=rank), name, rank) is None


CONIC = "[abc][ade][bdf][cef] == [abd][ace][bcf][def]"
CHASLES = ", ".join(f"[ab{p}][cd{p}] == 2 [ac{p}][bd{p}]" for p in "pqrs")
CIRCLE = "[abc][adi][bdj][cij] == [abd][aci][bcj][dij]"


def equal(a: str, b: str, c: str, d: str) -> str:
    """That ab and cd are of equal length; i and j are the isotropic points."""
    return f"[{a}{b}i][{a}{b}j][{c}ij]**2 [{d}ij]**2 == [{c}{d}i][{c}{d}j][{a}ij]**2 [{b}ij]**2"


CLAIMS = {
    "Pascal": ("", CONIC, r"[ab /\ de, bc /\ ef, cd /\ fa] == 0", r"[ab /\ de, bc /\ ef, cd /\ fb] == 0"),
    "Chasles: six of the points are on a conic": (
        "",
        CHASLES,
        "[abp][adq][bcq][cdp] == [abq][adp][bcp][cdq]",
        "[abc][apq][bdp][cdq] == [abd][acp][bpq][cdq]",
    ),
    "Chasles: four points are seen alike from two": (
        "",
        CHASLES,
        "[apq][ars][bpr][bqs] == [apr][aqs][bpq][brs]",
        "[apq][ars][bpr][bqs] == 2 [apr][aqs][bpq][brs]",
    ),
    "angles in a circle": (
        "i j",
        CIRCLE,
        "[aci][bcj][adj][bdi] == [acj][bci][adi][bdj]",
        "[aci][bcj][adj][bdi] == -[acj][bci][adi][bdj]",
    ),
    "two lengths": ("i j", equal("a", "b", "c", "d"), equal("c", "d", "a", "b"), equal("a", "c", "b", "d")),
    "three lengths": (
        "i j",
        f"{equal('a', 'b', 'c', 'd')}, {equal('e', 'f', 'c', 'd')}",
        equal("a", "b", "e", "f"),
        equal("a", "e", "b", "f"),
    ),
}


@pytest.mark.parametrize("name", CLAIMS)
def test_theorems_and_their_siblings(name: str) -> None:
    ideal, given, true, false = CLAIMS[name]
    proof = gc.prove(true, rank=3, ideal=ideal, given=given)
    assert proof.proved
    refuted = gc.prove(false, rank=3, ideal=ideal, given=given)
    assert refuted.verdict == "refuted"
    points = refuted.counterexample
    assert points is not None
    at = script_of(f"rank 3 {f'ideal {ideal}' if ideal else ''} given {given}")
    assert all(evaluate(e, points) == 0 for a in at.given for e in equations(a, 3))
    assert all((points[n][-1] == 0) == (n in ideal.split()) for n in points)


@pytest.mark.parametrize("given", [CHASLES, CLAIMS["two lengths"][1], CLAIMS["three lengths"][1]])
def test_only_this_way_leads_there(given: str) -> None:
    """These were refused; what must not vanish tells all positions that are left out: the others are reached."""
    ideal = "ideal i j " if "i" in given else ""
    at = script_of(f"rank 3 {ideal}given {given}")
    assert not any(c.through for f in as_written(at.given, 3) for c in f.conditions)
    assert on_quadrics(at.given, 3) is not None
    c = resolve(at)
    curved = [s for s in c.steps if not s.exact and s.fresh]
    assert curved
    points = c.random_points("quadrics")
    assert all(evaluate(e, points, modulus=PRIME) == 0 for e in c.equations)
    for step in curved:
        (polar,) = step.nonzero
        (other,) = step.fresh
        value = sum_of(step.parts, {**points, other: points[step.name]})
        factor = -evaluate(polar, points, modulus=PRIME) % PRIME
        assert factor
        assert value == tuple(factor * x % PRIME for x in points[step.name])


def sum_of(parts: object, points: dict[str, tuple[int, ...]]) -> tuple[int, ...]:
    values = [evaluate(part, points, modulus=PRIME) for part in parts]  # type: ignore[attr-defined]
    return tuple(sum(cs) % PRIME for cs in zip(*values, strict=True))


def test_a_circle_by_its_centre_is_all_of_it() -> None:
    """Exact points of the circle x² + y² = 25 around the origin, in complex coordinates, are positions of the kind."""
    at = script_of(f"rank 3 ideal i j given {equal('a', 'b', 'c', 'd')}")
    assert len(kinds(at)) == 1
    points = {"i": (1, 0, 0), "j": (0, 1, 0), "b": (0, 0, 1), "d": (1, 2, 1)}
    # With x and y along i and j the square of a length is xy: from d to (6, 7) it is 25.
    for x in (5, 1, 25, -5):
        some = {**points, "c": (6, 7, 1), "a": (x, Fraction(25, x), 1)}
        assert all(evaluate(e, some) == 0 for a in at.given for e in equations(a, 3))
        assert all(evaluate(e, some) for e in resolve(at).nonzero)


AXES: dict[int, dict[str, tuple[int, ...]]] = {
    3: {"i": (1, 0, 0), "j": (0, 1, 0)},
    4: {"i": (1, 0, 0, 0), "j": (0, 1, 0, 0), "k": (0, 0, 1, 0)},
}
DIFFERENCES: dict[int, list[tuple[int, ...]]] = {
    3: [(3, 4), (-4, 3), (5, 0), (0, -5)],
    4: [(2, 3, 6), (-6, 2, 3), (7, 0, 0), (3, -6, -2)],
}


@pytest.mark.parametrize("rank", [3, 4])
def test_lengths_by_directions_at_right_angles(rank: int) -> None:
    """The fourth corner of a parallelogram is known; equal lengths that nothing constructed are reached."""
    words = " ".join(AXES[rank])
    at = script_of(f"rank {rank} orthonormal {words} given equal_distance(ab, cd)")
    assert len(kinds(at)) == 1
    c = resolve(at)
    rng = random.Random(rank)
    for one, other in permutations(DIFFERENCES[rank], 2):
        starts = [[rng.randint(-9, 9) for _ in one] for _ in "ac"]
        ends = [[x + u for x, u in zip(p, by, strict=True)] for p, by in zip(starts, (one, other), strict=True)]
        points = {n: (*p, 1) for n, p in zip("acbd", starts + ends, strict=True)} | AXES[rank]
        assert all(evaluate(e, points) == 0 for e in c.equations)
        assert all(evaluate(e, points) for e in c.nonzero)


@pytest.mark.parametrize("rank", [3, 4])
def test_a_quadrangle_with_two_equal_sides(rank: int) -> None:
    """The midpoints of the other two and of the diagonals are the corners of a rhombus."""
    given = {"rank": rank, "orthonormal": " ".join(AXES[rank]), "given": "equal_distance(ab, cd)"}
    halves = [rf"midpoint({p}, {q}) \/ midpoint({r}, {s})" for p, q, r, s in ("acbd", "bcad", "abcd")]
    assert gc.prove(f"perpendicular({halves[0]}, {halves[1]})", **given).proved
    refuted = gc.prove(f"perpendicular({halves[0]}, {halves[2]})", **given)
    assert refuted.verdict == "refuted"
    assert refuted.counterexample is not None
    at = script_of(f"rank {rank} orthonormal {given['orthonormal']} given equal_distance(ab, cd)")
    assert all(evaluate(e, refuted.counterexample) == 0 for a in at.given for e in equations(a, rank))


def test_the_claim_is_a_sum_of_multiples_in_its_proof_file(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    done = invoke("prove", CLAIMS["three lengths"][2], "--rank", "3", "--ideal", "i j", "--given",
                  CLAIMS["three lengths"][1], "--certificate", str(file))  # fmt: skip
    assert done.exit_code == 0
    (theorem,) = json.loads(file.read_text(encoding="utf-8"))["theorems"]
    assert len(theorem["cases"]) == 1
    assert "where" in checker("check_proof").check(theorem)


def test_what_is_still_refused() -> None:
    """A quadratic equation of which no point is known."""
    done = invoke("prove", "[bcd] == 0", "--rank", "3", "--given", "[abc]**2 == 2 [abd]**2")
    assert done.exit_code == 2
    assert "cannot be resolved" in done.stderr
