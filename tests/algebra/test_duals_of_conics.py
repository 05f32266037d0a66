"""Duals of claims about letters for conics and quadrics, evaluated as they are printed.

In the plane a conic has its matrix, and points and lines change places with their coordinates: the conic of the
tangents has the adjugate. In space the corners of the tetrahedron on the quadric become the planes of the dual's.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import zip_longest
from random import Random

import pytest
from algebra.conic_texts import drawn_frame, drawn_line, drawn_point, placed
from algebra.quadric_figures import Vector, combined, dot, plane, plane_through, point
from faults import refused
from places import checker

import gcrules as gc
from gcrules.algebra.duality import Dual
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.language.relations import parse_claim
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.letters import conic_points, names_of
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.rules.script import run_script

CHECK = checker("check_proof")


def dual_of(claim: str, rank: int, *said: str) -> Dual:
    """The dual as it is printed, with what is declared and given before."""
    at = Context(rank)
    for one in filter(None, said):
        at = parse_assumption(one, at)
    found = parse_claim(f"dual({claim})", at).dual
    assert found is not None
    return found


PLANE: list[tuple[Mapping[str, str], str, str, str]] = [
    (
        dict.fromkeys("abcdef", "on"),
        "on_conic(a, b, c, d, e, f, K)",
        "[(ab /\\ de), (bc /\\ ef), (cd /\\ fa)] == 0",
        "",
    ),
    (dict.fromkeys("abcdef", "on"), "on_conic(a, b, c, d, e, f, K)", "concurrent(ad, be, cf)", "refuted"),
    ({"a": "on", "b": "on", "p": "ab"}, "on_conic(a, b, K), incident(p, ab)", "incident(pole(ab, K), polar(p, K))", ""),
    ({"a": "on", "p": "point"}, "incident(a, K)", "on_conic(second_on_conic(p, a, K), a, K)", ""),
    ({"a": "on", "p": "point"}, "incident(a, K)", "incident(second_on_conic(p, a, K), p \\/ a)", ""),
    ({"a": "on", "p": "point"}, "incident(a, K)", "incident(second_on_conic(p, a, K), tangent(a, K))", "refuted"),
    ({"a": "point", "b": "point"}, "", "[a polar(b, K)] == [b polar(a, K)]", ""),
    ({"a": "point", "b": "point"}, "", "conic(a, K) == conic(b, K)", "refuted"),
    ({"a": "point", "b": "point"}, "", "[a polar(b, K)]**2 == 4 conic(a, K) conic(b, K)", "refuted"),
    ({"a": "on"}, "incident(a, K)", "conic(a, K) == 0", ""),
    ({"L": "tangent"}, "touches(L, K)", "incident(pole(L, K), K)", ""),
    ({"L": "line"}, "", "incident(pole(L, K), L)", "refuted"),
    ({"L": "line", "M": "line"}, "", "incident(L /\\ M, pole(L, K) \\/ pole(M, K))", "refuted"),
    ({"L": "line", "M": "line"}, "", "incident(pole((L /\\ M) \\/ pole(L, K), K), L)", ""),
    ({"L": "tangent", "M": "tangent"}, "touches(L, K), touches(M, K)", "touches(polar(L /\\ M, K), K)", "refuted"),
    (
        {"a": "on", "b": "point", "c": "ab"},
        "incident(a, K), collinear(a, b, c)",
        "concurrent(polar(a, K), polar(b, K), polar(c, K))",
        "",
    ),
    (
        {"a": "on", "b": "on", "c": "on"},
        "on_conic(a, b, c, K)",
        "concurrent(a \\/ (tangent(b, K) /\\ tangent(c, K)), b \\/ (tangent(c, K) /\\ tangent(a, K)),"
        " c \\/ (tangent(a, K) /\\ tangent(b, K)))",
        "",
    ),
]
"""Where things are, what is given of them, what is claimed, and "refuted" where that is not so."""

PLANE_IDS = [f"{given} ⊢ {claim}" for _, given, claim, _ in PLANE]


def letters_of(where: Mapping[str, str]) -> str:
    return ", ".join(["conic K", *(f"line {n}" for n in where if n.isupper())])


def proved_dual(where: Mapping[str, str], given: str, claim: str) -> tuple[gc.Proof, Dual]:
    proof = gc.prove(f"dual({claim})", rank=3, letters=letters_of(where), given=given or ())
    assert proof.dual is not None
    return proof, proof.dual


@pytest.mark.parametrize(("where", "given", "claim", "verdict"), PLANE, ids=PLANE_IDS)
def test_duals_in_the_plane_hold_as_they_are_printed(
    where: Mapping[str, str], given: str, claim: str, verdict: str
) -> None:
    proof, dual = proved_dual(where, given, claim)
    assert proof.verdict == (verdict or "proved")
    for seed in range(4):
        at = placed(where, rng := Random(f"{claim}{seed}"), drawn_frame(rng))
        assert all(at.dual().holds(one) for one in dual.given)
        assert at.holds(claim) == all(at.dual().holds(one) for one in dual.claims) == proof.proved


RANDOM = 40


@pytest.mark.parametrize("seed", range(RANDOM))
def test_duals_of_scalars_are_these_up_to_one_factor_of_the_conic(seed: int) -> None:
    rng = Random(f"duals {seed}")
    names, on = "abc", "ab"[: rng.randrange(3)]
    claim = f"[{drawn_point(rng, names, on, 2)}, {drawn_line(rng, names, on, 2)}] == 0"
    (printed,) = dual_of(claim, 3, "conic K", *(f"incident({n}, K)" for n in on)).claims
    frame, values = drawn_frame(rng), []
    for _ in range(3):
        there = placed({n: "on" if n in on else "point" for n in names}, rng, frame)
        values.append([there.scalar(claim[:-5]), there.dual().scalar(printed.removesuffix(" == 0"))])
    (one, other), *rest = values
    assert all((one * w - other * v) % PRIME == 0 for v, w in rest)
    assert bool(one) == bool(other)


@pytest.mark.parametrize(("where", "given", "claim", "verdict"), PLANE, ids=PLANE_IDS)
def test_the_dual_of_a_dual_says_what_the_claim_does(
    where: Mapping[str, str], given: str, claim: str, verdict: str
) -> None:
    dual = dual_of(claim, 3, letters_of(where), given)
    for seed in range(4):
        at = placed(where, rng := Random(f"{claim}{seed}"), drawn_frame(rng))
        found = []
        for one in dual.claims:
            again = dual_of(one, 3, *dual.letters, *dual.given)
            assert all(at.holds(other) for other in again.given)
            found += [at.holds(other) for other in again.claims]
        assert all(found) == at.holds(claim)


@pytest.mark.parametrize(("where", "given", "claim", "verdict"), PLANE, ids=PLANE_IDS)
def test_printed_duals_are_decided_alike_where_they_are_decided(
    where: Mapping[str, str], given: str, claim: str, verdict: str
) -> None:
    proof, dual = proved_dual(where, given, claim)
    found = {gc.prove(one, rank=3, letters=", ".join(dual.letters), given=dual.given).verdict for one in dual.claims}
    assert found <= {proof.verdict, "undecided"}


# --- in space --------------------------------------------------------------------------------------------------------

SPACE: list[tuple[Mapping[str, str], str, str]] = [
    ({"a": "point", "b": "point", "c": "ab"}, "collinear(a, b, c)", "incident(polar(ab, Q), polar(c, Q))"),
    ({"a": "point", "b": "point", "c": "point"}, "", "incident(polar(ab, Q), polar(c, Q))"),
    ({"a": "on", "p": "point"}, "incident(a, Q)", "on_quadric(second_on_quadric(p, a, Q), a, Q)"),
    ({"a": "on", "p": "point"}, "incident(a, Q)", "collinear(second_on_quadric(p, a, Q), p, a)"),
    ({"a": "on", "p": "point"}, "incident(a, Q)", "incident(second_on_quadric(p, a, Q), tangent(a, Q))"),
    ({"P": "tangent"}, "touches(P, Q)", "incident(pole(P, Q), Q)"),
    ({"P": "plane"}, "", "touches(P, Q)"),
    ({"L": "touching"}, "touches(L, Q)", "touches(polar(L, Q), Q)"),
    ({"L": "line"}, "", "touches(polar(L, Q), Q)"),
    ({"L": "line"}, "", "[L polar(polar(L, Q), Q)] == 0"),
    ({"a": "on", "b": "on"}, "on_quadric(a, b, Q)", "concurrent(polar(ab, Q), tangent(a, Q) /\\ tangent(b, Q))"),
    ({"a": "point", "b": "point"}, "", "[a polar(b, Q)] == [b polar(a, Q)]"),
    ({"a": "point", "b": "point"}, "", "quadric(a, Q) polar(b, Q) == quadric(b, Q) polar(a, Q)"),
    ({"P": "plane", "R": "plane"}, "", "incident(pole(P, Q) \\/ pole(R, Q), polar(P /\\ R, Q))"),
    ({"P": "plane", "R": "plane", "a": "point"}, "", "collinear(pole(P, Q), pole(R, Q), a)"),
    (dict.fromkeys("abcd", "point"), "", "[[ab, polar(ab, Q), cd, polar(cd, Q), ac, polar(ac, Q)]] == 0"),
]
TOUCHING: tuple[Mapping[str, str], str, str]
TOUCHING = ({"a": "on", "b": "beside a"}, "touches(ab, Q)", "touches(polar(ab, Q), Q)")
"""Its dual says in other words that a meet of planes touches, and is not proved as it is printed."""

SPACE_IDS = [f"{given} ⊢ {claim}" for _, given, claim in SPACE]
_DECLARED = {"tangent": "plane", "plane": "plane", "touching": "line", "line": "line"}


@dataclass
class Space:
    """The corners of a tetrahedron on a quadric, and points, or points that letters are the joins of."""

    rng: Random
    where: Mapping[str, str]
    corners: list[Vector] = field(default_factory=list)
    things: dict[str, list[Vector]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.corners = self.corners or [self._anywhere() for _ in range(4)]
        for name, how in self.where.items():
            self.things[name] = self._thing(how)

    def _anywhere(self) -> Vector:
        return tuple(self.rng.randrange(1, PRIME) for _ in range(4))

    def _on(self, s: int, t: int) -> Vector:
        e = self.corners
        return combined(1, combined(s * t, e[0], 1, e[1]), 1, combined(s, e[2], t, e[3]))

    def _thing(self, how: str) -> list[Vector]:
        s, t, u, v = (self.rng.randrange(1, PRIME) for _ in range(4))
        if how in ("on", "tangent", "touching"):
            at, one, other = self._on(s, t), self._on(s, u), self._on(v, t)
            return {"on": [at], "tangent": [at, one, other], "touching": [at, combined(u, one, v, other)]}[how]
        if how.startswith("beside"):
            (p,) = self.things[how[-1]]
            plane = self._polar(p)
            q, r = self._anywhere(), self._anywhere()
            return [combined(dot(plane, r), q, -dot(plane, q), r)]
        if how in ("point", "line", "plane"):
            return [self._anywhere() for _ in range(("point", "line", "plane").index(how) + 1)]
        (p,), (q,) = (self.things[n] for n in how)
        return [combined(s, p, t, q)]

    def _faces(self) -> list[Vector]:
        """The dual basis of the corners."""
        found = []
        for i, corner in enumerate(self.corners):
            plane = plane_through(*self.corners[:i], *self.corners[i + 1 :])
            found.append(combined(pow(dot(plane, corner), -1, PRIME), plane, 0, plane))
        return found

    def _polar(self, p: Vector) -> Vector:
        """Of y1 y2 - y3 y4, where the faces give the coordinates."""
        f = self._faces()
        y = [dot(face, p) for face in f]
        return combined(1, combined(y[1], f[0], y[0], f[1]), -1, combined(y[3], f[2], y[2], f[3]))

    def dual(self) -> dict[str, Vector]:
        """The points of the dual: its corners are the dual basis, a point is a plane and a plane a point with the same
        coordinates, and a line the meet of the planes of two points.
        """
        found = dict(zip(conic_points("Q", 4), self._faces(), strict=True))
        for name, points in self.things.items():
            values = [self._through(points) for _ in range(4 - len(points))]
            if len(points) == 1:  # as large as the point is
                scale = points[0][0] * pow(plane_through(*values)[0], -1, PRIME)
                values[0] = combined(scale, values[0], 0, values[0])
            found |= dict(zip(named(name, 4 - len(points)), values, strict=True))
        return found

    def _through(self, points: Sequence[Vector]) -> Vector:
        """A plane through points."""
        return plane_through(*points, *(self._anywhere() for _ in range(3 - len(points))))

    def points(self) -> dict[str, Vector]:
        found = dict(zip(conic_points("Q", 4), self.corners, strict=True))
        for name, points in self.things.items():
            found |= dict(zip(named(name, len(points)), points, strict=True))
        return found


def named(name: str, step: int) -> tuple[str, ...]:
    return (name,) if step == 1 else names_of(name, step)


def declared_in(where: Mapping[str, str]) -> str:
    return ", ".join(["quadric Q", *(f"{_DECLARED[how]} {n}" for n, how in where.items() if how in _DECLARED)])


def holds(text: str, at: Context, points: Mapping[str, Vector]) -> bool:
    evaluate = Evaluator(points, 4, PRIME)
    return all(
        not any((x - y) % PRIME for x, y in zip_longest(*map(evaluate.value, pair), fillvalue=0))
        for pair in parse_claim(text, at).equations
    )


@pytest.mark.parametrize(("where", "given", "claim"), [*SPACE, TOUCHING], ids=[*SPACE_IDS, "touching"])
def test_duals_in_space_hold_as_they_are_printed(where: Mapping[str, str], given: str, claim: str) -> None:
    declared = declared_in(where)
    proof = gc.prove(f"dual({claim})", letters=declared, given=given or ())
    dual, at = proof.dual, parse_assumption(", ".join(filter(None, [declared, given])), Context(4))
    assert dual is not None
    lettered = parse_assumption(", ".join(dual.letters), Context(4))
    parse_assumption(", ".join(dual.given) or "quadric Q", lettered)
    for seed in range(3):
        there = Space(Random(f"{claim}{seed}"), where)
        points = there.dual()
        assert all(holds(one, lettered, points) for one in dual.given)
        assert all(holds(one, lettered, points) for one in dual.claims) == proof.proved
        assert holds(claim, at, there.points()) == proof.proved


@pytest.mark.parametrize(("where", "given", "claim"), SPACE, ids=SPACE_IDS)
def test_printed_duals_in_space_are_decided_alike_where_they_are_decided(
    where: Mapping[str, str], given: str, claim: str
) -> None:
    proof = gc.prove(f"dual({claim})", letters=declared_in(where), given=given or ())
    dual = proof.dual
    assert dual is not None
    found = {gc.prove(one, letters=", ".join(dual.letters), given=dual.given).verdict for one in dual.claims}
    assert found <= {proof.verdict, "undecided"}


def test_a_line_that_touches_is_said_to_touch_again_in_the_dual_of_the_dual() -> None:
    _, given, claim = TOUCHING
    dual = dual_of(claim, 4, "quadric Q", given)
    assert dual.given == ("concurrent(a /\\ b, polar(a /\\ b, Q))",)
    assert dual_of(dual.claims[0], 4, *dual.letters, *dual.given).given == (given,)


@pytest.mark.parametrize("seed", range(RANDOM))
def test_duals_of_scalars_in_space_are_these_up_to_one_factor_of_the_quadric(seed: int) -> None:
    rng = Random(f"space {seed}")
    on = tuple("ab"[: rng.randrange(3)])
    scalar = f"[{point(rng, 'abcd', on, 2)[0]}, {plane(rng, 'abcd', on, 2)[0]}]"
    dual = dual_of(f"{scalar} == 0", 4, "quadric Q", *(f"incident({n}, Q)" for n in on))
    (printed,) = dual.claims
    where = {n: "on" if n in on else "point" for n in "abcd"}
    at = parse_assumption(", ".join(["quadric Q", *(f"incident({n}, Q)" for n in on)]), Context(4))
    lettered = parse_assumption(", ".join(dual.letters), Context(4))
    corners, values = Space(rng, {}).corners, []
    for _ in range(3):
        there = Space(rng, where, corners)
        sides = ((f"{scalar} == 0", at, there.points()), (printed, lettered, there.dual()))
        values.append([Evaluator(p, 4, PRIME).value(parse_claim(t, c).equations[0][0])[0] for t, c, p in sides])
    (one, other), *rest = values
    assert all((one * w - other * v) % PRIME == 0 for v, w in rest)
    assert bool(one % PRIME) == bool(other % PRIME)


# --- tangents alone ---------------------------------------------------------------------------------------------------

BRIANCHON = "concurrent((a /\\ b) \\/ (d /\\ e), (b /\\ c) \\/ (e /\\ f), (c /\\ d) \\/ (f /\\ a))"


def test_a_claim_about_tangents_alone_is_proved_as_the_dual_of_one_about_points() -> None:
    given = ", ".join(f"touches({n}, K)" for n in "abcdef")
    letters = "conic K, line a b c d e f"
    found = gc.prove(BRIANCHON, rank=3, letters=letters, given=given)
    assert (found.verdict, found.assumed) == ("proved", ())
    assert found.dual is not None
    assert found.dual.letters == ("line a b c d e f", "conic K")
    (theorem,) = json.loads(gc.proof_file(found).json_text())["theorems"]
    assert theorem["name"].startswith("what the claim is the dual of")
    CHECK.check(theorem)
    false = gc.prove(BRIANCHON, rank=3, letters=letters, given=given.removesuffix(", touches(f, K)"))
    assert (false.verdict, false.dual) == ("refuted", None)


def test_the_proof_file_of_a_dual_is_that_of_what_it_is_the_dual_of() -> None:
    for rank, letters, given, claim in (
        (3, "conic K", "on_conic(a, b, K), incident(p, ab)", "incident(pole(ab, K), polar(p, K))"),
        (4, "quadric Q", "incident(c, Q)", "touches(tangent(c, Q), Q)"),
    ):
        proof = gc.prove(f"dual({claim})", rank=rank, letters=letters, given=given)
        (one,) = json.loads(gc.proof_file(proof).json_text())["theorems"]
        assert one["name"] == "what the claim is the dual of"
        CHECK.check(one)


def test_names_that_are_bound_keep_their_words() -> None:
    script = (
        "rank 3 conic K given on_conic(a, b, K) let t = tangent(a, K) /\\ tangent(b, K)"
        " claim dual(incident(t, pole(ab, K)))"
    )
    (result,) = run_script(parse_script(script)).claims
    assert result.proof is not None
    assert result.proof.proved
    assert result.proof.dual is not None
    assert result.proof.dual.claims == ("incident(pole(a, K) \\/ pole(b, K), polar(a /\\ b, K))",)


def test_the_prompt_decides_duals_of_conics() -> None:
    lines = "rank 3\nconic K\ngiven incident(a, K)\ndual(incident(a, polar(a, K)))\ndual(incident(b, K))"
    answers = [a.text.splitlines() for a in Interpreter().feed(lines)]
    decided = [(some[0].split(":")[0], some[3].strip()) for some in answers if "dual" in some[0]]
    assert decided == [
        ("proved", "the dual: incident(a, pole(a, K)) where touches(a, K)"),
        ("refuted", "the dual: touches(b, K) where touches(a, K)"),
    ]


def test_tangents_alone_are_said_to_be_decided_by_the_dual() -> None:
    """The claim is the dual itself, which is not told again."""
    touching = ", ".join(f"touches({n}, K)" for n in "abc")
    found = gc.prove("concurrent(a, b, c)", rank=3, letters="conic K, line a b c", given=touching)
    assert found.verdict == "refuted"
    found = gc.prove("incident(pole(a, K), a)", rank=3, letters="conic K, line a b c", given=touching)
    assert found.proved
    assert "the dual:" not in found.text()


def test_points_that_nobody_can_name_are_in_no_hint() -> None:
    given = "touches(A, Q), touches(B, Q), incident(pole(A, Q), B)"
    with pytest.raises(gc.InputError, match="cannot be resolved") as fault:
        gc.prove("touches(A /\\ B, Q)", letters="quadric Q, plane A B", given=given)
    assert fault.value.hint == "the points t_AQ and t_BQ are taken to differ, and their line not to be on Q"


FAULTS = [
    (
        "rank 3 conic K claim dual(conic(p, K) == [abc])",
        "duality multiplies 1/2[p, polar(p, K)] and [abc] by different factors",
    ),
    (
        "rank 3 conic K claim dual(pole(ab, K) == polar(a, K) /\\ polar(b, K))",
        "duality multiplies pole(ab, K) and polar(a, K)",
    ),
    ("rank 3 conic K claim dual(incident(a, polar(p, K)) ", "expected"),
    ("rank 3 conic K claim dual(incident(p, tangent(a, b, c, d, e)))", "the dual of a construction has no word"),
    ("quadric Q ideal i claim dual(incident(i, Q))", "i is a point at infinity"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_what_has_no_dual_is_refused(text: str, message: str) -> None:
    refused(text, message)
