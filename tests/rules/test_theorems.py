"""The theorems of examples/theorems by another road: at positions of vectors of fractions that are built otherwise.

Each position must satisfy all assumptions, none of what the proof assumed not to vanish may vanish there, and all
claims must hold.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations

import pytest
from places import EXAMPLES
from rules.metric_positions import METRIC
from rules.quadric_positions import QUADRICS
from rules.theorem_positions import POSITIONS, Position, cross, det, drawn, grid, vector

from gcrules.algebra.assumptions.assumed import equations
from gcrules.algebra.bracket import tableau_order
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.statements import Claim, Script, parse_script
from gcrules.algebra.language.syntax import Context, parse
from gcrules.rules.script import run_script

THEOREMS = sorted((EXAMPLES / "theorems").glob("*.gca"))
NAMES = [p.stem for p in THEOREMS]
PLACED = POSITIONS | METRIC | QUADRICS

# --- the theorems there ---------------------------------------------------------------------------------------------


def script_of(name: str) -> Script:
    (path,) = (p for p in THEOREMS if p.stem == name)
    return parse_script(path.read_text(encoding="utf-8"), str(path))


def claims_of(script: Script) -> list[Claim]:
    return [s for s in script.statements if isinstance(s, Claim)]


def value(e: Expr, points: Position, rank: int) -> tuple[Fraction, ...]:
    return tuple(Fraction(c) for c in Evaluator(points, rank).value(e))


def open_points(e: Expr, points: Position, rank: int) -> Iterator[Position]:
    """Points that stand for all points run through a basis."""
    others = [n for n in points_of(e) if n not in points]
    basis = [vector(*(int(i == j) for j in range(rank))) for i in range(rank)]
    for chosen in combinations(basis, len(others)):
        yield points | dict(zip(others, chosen, strict=True))


def test_every_theorem_has_a_position() -> None:
    assert sorted(PLACED) == sorted(NAMES)


def sides_of(claim: Claim) -> list[Expr]:
    return [side for equation in claim.claimed.equations for side in equation]


def holds_there(claim: Claim, assumed: Sequence[str], points: Position) -> bool:
    """Whether a claim was looked at: not where a finite point lies at infinity or what was assumed vanishes."""
    at = claim.context
    used = {n for a in at.given for e in a.args for n in points_of(e)} | {*points_of(*sides_of(claim))}
    assert used <= set(points)
    for e in (e for a in at.given for e in equations(a, at.rank)):
        assert all(not any(value(e, p, at.rank)) for p in open_points(e, points, at.rank)), str(e)
    if any((points[n][-1] == 0) != (n in at.ideal) for n in used):
        return False
    if not all(any(value(parse(text, context=at), points, at.rank)) for text in assumed):
        return False
    for left, right in claim.claimed.equations:
        values = value(left, points, at.rank), value(right, points, at.rank)
        assert values[0] == values[1] or not any((*values[0], *values[1]))
    return True


@pytest.mark.parametrize("name", NAMES)
def test_theorem_at_positions_built_otherwise(name: str) -> None:
    script = script_of(name)
    results = run_script(script).claims
    for claim, result in zip(claims_of(script), results, strict=True):
        assert result.proof is not None
        drawn_from = (PLACED[name](random.Random(f"{name} {seed}")) for seed in range(8))
        assert sum(holds_there(claim, result.proof.assumed, points) for points in drawn_from) > 4


@pytest.mark.parametrize("name", ["brianchon", "pascal", "quadrangle", "five-lines", "conic", "desargues", "miquel"])
def test_first_claims_are_not_zero_on_both_sides_everywhere(name: str) -> None:
    """The identities that say "exactly when": in general position neither side is zero."""
    script = script_of(name)
    claim = claims_of(script)[0]
    assert not claim.context.given
    rng = random.Random(name)
    points = {n: drawn(rng, claim.context.rank) for n in points_of(*sides_of(claim))}
    left, right = (value(side, points, claim.context.rank) for side in sides_of(claim))
    assert left == right
    assert any(left)


# --- what the scripts write out -------------------------------------------------------------------------------------


def test_a_conic_through_six_points_has_a_determinant_zero() -> None:
    """The bracket polynomial is the determinant of the six rows x², xy, xz, y², yz, z², up to its sign."""
    _, right = sides_of(claims_of(script_of("pascal"))[0])
    order = tableau_order(points_of(right), (), ())
    ratios = set()
    for seed in range(5):
        points = {n: drawn(random.Random(f"{n}{seed}"), 3) for n in order}
        rows = [tuple(v[i] * v[j] for i in range(3) for j in range(i, 3)) for v in points.values()]
        (polynomial,) = value(right, points, 3)
        ratios.add(polynomial / det(rows))
    assert len(ratios) == 1
    assert ratios <= {1, -1}


@pytest.mark.parametrize("name", ["five-lines", "false/five-lines"])
def test_determinants_of_moments(name: str) -> None:
    path = THEOREMS[0].parent / f"{name}.gca"
    script = parse_script(path.read_text(encoding="utf-8"))
    number = 5 if name == "five-lines" else 4
    points = {f"{n}{i}": drawn(random.Random(f"{n}{i}"), 4) for n in "ab" for i in range(1, number + 1)}
    lines = [(points[f"a{i}"], points[f"b{i}"]) for i in range(1, number + 1)]
    moments = [tuple(det([*k, *m]) for m in lines) for k in lines]
    assert value(script.context.bound["det"], points, 4) == (det(moments),)


def rank_of(rows: list[list[int]], modulus: int) -> int:
    rows, rank = [list(r) for r in rows], 0
    for j in range(len(rows[0])):
        at = next((i for i in range(rank, len(rows)) if rows[i][j] % modulus), None)
        if at is None:
            continue
        rows[rank], rows[at] = rows[at], rows[rank]
        inverse = pow(rows[rank][j], -1, modulus)
        for i in range(rank + 1, len(rows)):
            if rows[i][j] % modulus:
                factor = rows[i][j] * inverse
                rows[i] = [(x - factor * y) % modulus for x, y in zip(rows[i], rows[rank], strict=True)]
        rank += 1
    return rank


def test_of_sixteen_incidences_fifteen_force_the_last_and_fewer_force_none() -> None:
    """The gradients of the sixteen conditions [aa'bb'] = 0 at eight lines of a hyperboloid have one dependency, in
    which all take part: any fifteen are independent and span the last, any fourteen leave the other two free."""
    at = grid(random.Random(1))
    ones = [(at(i, 20), at(i, 30)) for i in range(4)]
    others = [(at(20, j), at(30, j)) for j in range(4)]
    gradients = []
    for i in range(4):
        for j in range(4):
            row = [0] * 64
            four = [*ones[i], *others[j]]
            for k in range(4):
                rest = cross(*(v for m, v in enumerate(four) if m != k))
                place = 8 * ([i, 4 + j][k // 2]) + 4 * (k % 2)
                row[place : place + 4] = [(-1) ** k * int(c) for c in rest]
            gradients.append(row)
    assert rank_of(gradients, PRIME) == 15
    assert all(rank_of([r for r in gradients if r is not g], PRIME) == 15 for g in gradients)
    for g, h in combinations(gradients, 2):
        assert rank_of([r for r in gradients if r is not g and r is not h], PRIME) == 14


EUCLID = 1_000_000_009
"""A prime modulo which -1 is a square: there the isotropic points (1, ±√-1, 0) of Euclid's plane have coordinates."""
ROOT = pow(11, (EUCLID - 1) // 4, EUCLID)


def in_euclids_plane(expression: str, **points: tuple[int, int]) -> list[int]:
    at = Context(rank=3, ideal=("i", "j"))
    places = {n: (x, y, 1) for n, (x, y) in points.items()} | {"i": (1, ROOT, 0), "j": (1, -ROOT, 0)}
    return [int(c) for c in Evaluator(places, 3, EUCLID).value(parse(expression, context=at))]


def test_the_points_of_the_butterfly_are_those_of_its_coordinates() -> None:
    """Where the script says by its words how q and d are made, the position solves for them."""
    space = parse_script("rank 3\nisotropic i j").context
    made = {
        "q": parse("reflection(p, m)", context=space),
        "d": parse("second_on_conic(m, c, p, q, a, b)", context=space),
    }
    for seed in range(8):
        points = METRIC["butterfly"](random.Random(f"butterfly {seed}"))
        for name, e in made.items():
            found = value(e, points, 3)
            assert any(found)
            assert not any(cross(vector(*found), points[name]))


def test_isotropic_points_make_right_angles_midpoints_and_circles() -> None:
    """What the scripts write with i and j: a perpendicular direction, a midpoint, four points on a circle."""
    assert ROOT * ROOT % EUCLID == EUCLID - 1
    x, y, w = in_euclids_plane("[abi] j + [abj] i", a=(2, 3), b=(7, 15))
    assert (w, (5 * x + 12 * y) % EUCLID) == (0, 0)
    assert (x, y) != (0, 0)
    x, y, w = in_euclids_plane("[bij] a + [aij] b", a=(2, 3), b=(7, 15))
    assert ((2 * x - 9 * w) % EUCLID, (2 * y - 18 * w) % EUCLID) == (0, 0)
    assert w
    circle = "[abc][adi][bdj][cij] - [abd][aci][bcj][dij]"
    of_radius_five = {"a": (3, 4), "b": (5, 0), "c": (-4, 3)}
    assert in_euclids_plane(circle, **of_radius_five, d=(0, -5)) == [0]
    assert in_euclids_plane(circle, **of_radius_five, d=(1, -5)) != [0]
