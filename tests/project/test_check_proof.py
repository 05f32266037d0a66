"""`checkers/check_proof.py`, which shares no code with gcrules: it proves what gcrules proves, and nothing false."""

from __future__ import annotations

import json
import random
import subprocess
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from copy import copy
from fractions import Fraction
from functools import cache, reduce
from itertools import combinations
from math import lcm
from pathlib import Path
from typing import Any

import pytest
from places import EXAMPLES, ROOT, checker
from rules.metric_positions import METRIC

import gcrules as gc
from gcrules.algebra.language.statements import parse_script
from gcrules.mechanisms.proofs import proof_file
from gcrules.rules.catalog.file import load
from gcrules.rules.script import run_script

CHECKER = ROOT / "checkers" / "check_proof.py"
CHECK = checker("check_proof")
MINUTES = ("double-six", "feuerbach")  # are written and checked by make proofs
THEOREMS = sorted(path for path in (EXAMPLES / "theorems").glob("*.gca") if path.stem not in MINUTES)


def checked(file: gc.ProofFile) -> list[str]:
    """The claims as the checker reads them, from the text of the file."""
    return [CHECK.check(theorem) for theorem in json.loads(file.json_text())["theorems"]]


def test_it_is_one_short_file_of_the_standard_library() -> None:
    text = CHECKER.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 400
    imported = {line.split()[1] for line in text.splitlines() if line.startswith(("import ", "from "))}
    assert imported <= set(sys.stdlib_module_names)


def test_it_is_told_one_file() -> None:
    done = subprocess.run([sys.executable, CHECKER], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "python checkers/check_proof.py FILE.json" in done.stderr


def test_all_readings_of_all_classes() -> None:
    catalog = load()
    file = proof_file(catalog)
    assert [one.name for one in file.left_out] == ["6-6, condition: linear-complex"]  # by definition
    assert len(checked(file)) + 1 == sum(1 + len(entry.readings) for entry in catalog.entries)


@pytest.mark.parametrize("path", THEOREMS, ids=lambda path: path.stem)
def test_the_theorems_of_the_examples(path: Path) -> None:
    found = run_script(parse_script(path.read_text(encoding="utf-8"), path.name))
    file = proof_file(found)
    assert not file.left_out
    claims = checked(file)
    assert len(claims) == len(file.theorems)


@pytest.mark.parametrize("name", ["3-rps", "delta", "h4", "4-ruu", "agile-eye", "3-rrr", "reachy-mini-head"])
def test_the_condition_of_a_robot(name: str) -> None:
    file = gc.proof_file(gc.analyze(name))
    *definitions, lines = file.left_out
    assert {one.reason for one in definitions} <= {"it holds by definition of the superbracket"}
    assert lines.name == "that these lines stand for the joints"
    assert checked(file)


ANSWERS: dict[str, Callable[[], Any]] = {
    "factors": lambda: gc.factor("[abfc][acde][bdef] + [abfd][acbe][cdef]"),
    "no factors": lambda: gc.factor("[[Aa,Ab,Bc,Bd,Ca,Dc]]", cofactor=True),
    "shortest": lambda: gc.shorten("[abc][def] - [abd][cef] + [abe][cdf]", rank=3),
    "transversals": lambda: gc.transversals("Aa Ab Bc Cd De Ef"),
    "ideal": lambda: gc.prove("[ijk] == 0", rank=3, ideal="i j k"),
    "halves": lambda: gc.prove("1/2 [abc] d + 1/2 [abc] d == [dbc] a + [adc] b + [abd] c", rank=3),
    "powers": lambda: gc.prove("[abcd]**3 == [abcd] [bacd] [badc] * -1"),
    "common brackets": lambda: gc.prove("[abf][cdg] ([abc][ade] - [abd][ace]) == -[cdg][abf][abe][acd]", rank=3),
    "kinds": lambda: gc.prove("[acd] == 0", rank=3, given="collinear(a, b, c), collinear(a, b, d)"),
    "cases": lambda: gc.prove("[abc][abd] == 0", rank=3, given="[abc]**2 [abd]**3 == 0"),
    "cases in cases": lambda: gc.prove("[abc][abd][cde] == 0", rank=3, given="[abc][ade] == 0, [abd][ace] == 0"),
    "a factor that does not vanish": lambda: gc.prove("[abd] == 0", rank=3, given=NO_KIND),
    "a point that is a sum": lambda: gc.prove("[abq] == [abc]", rank=3, given="p == a + b, q == p + c"),
    "a point that is a meet": lambda: gc.prove(r"p ab == 0", rank=3, given=r"2 p == ab /\ cd"),
    "a point that is zero": lambda: gc.prove(
        "[pab] == 0", rank=3, given="p == [abc] d - 2 [abd] c, collinear(a, b, c)"
    ),
    "a line through a sum": lambda: gc.prove("[abd] == -2 [cbd]", rank=3, given="collinear(d, b, 2 c + a)"),
    "a plane that is a sum": lambda: gc.prove("[abcd] == [abce]", given="[abcd] == [abce]"),
    "a plane by two assumptions": lambda: gc.prove("[bcde] == 0", given=TOGETHER),
    "several equations": lambda: gc.prove("[acd] == 0", rank=3, given="[abd] == [abc], [abd] == 2 [abc]"),
    "equations of points": lambda: gc.prove("a == c", rank=3, given="a + b == c + d, 2 a - (b + c) == c - d"),
    "Ceva, converse": lambda: gc.prove(r"ad /\ be /\ cf == 0", rank=3, given=CEVA),
    "a square": lambda: gc.prove("[befa] == 0", given=IN_A_PLANE, ideal="a b"),
    "a tangent plane": lambda: gc.prove("touches(tangent(c, Q), Q)", letters="quadric Q", given="incident(c, Q)"),
    "a point of a screw": lambda: gc.prove("[abcd] == 0", letters="screw S", given=r"incident(c, S /\ abd)"),
    "a screw twice": lambda: gc.prove(SCREW_TWICE, letters="screw S", given=r"S \/ ab == 0"),
    "a line through a point of a screw": lambda: gc.prove(
        r"S \/ ad == 0", letters="screw S", given=r"S \/ ab == 0, incident(d, a \/ (S /\ abc))"
    ),
    "ten lines": lambda: gc.prove(TEN_LINES, rank=5),
    "a dual": lambda: gc.prove("dual([abc] [ade] == 0)", rank=3, given="collinear(a, b, c)"),
    "one point said twice": lambda: gc.prove("be == 0", rank=3, given="fb == 0, fe == 0"),
}
TOGETHER = "c == e + 2 d, coplanar(e, d, a, f + b), coplanar(a, d, c, e + b)"
CEVA = "incident(d, bc), incident(e, ca), incident(f, ab), [abd][bce][caf] == [adc][bea][cfb]"
IN_A_PLANE = r"concurrent(bd, bc), incident(b, dac), incident(f, dac), coplanar(a, f, e, eb /\ fda)"
SCREW_TWICE = r"(S /\ abc + S /\ abd) \/ (S /\ abe) == -1/2 (S /\ S)([abce] + [abde]) * ab"
TEN_LINES = "[[ab,ac,ad,ae,bc,bd,bf,cd,ce,de]] == -[[ba,ac,ad,ae,bc,bd,bf,cd,ce,de]]"
NO_KIND = "collinear(c, d, e), incident(a, be), [bed][bac] == -[bea][bdc]"


@pytest.mark.parametrize("name", ANSWERS)
def test_other_answers(name: str) -> None:
    assert checked(gc.proof_file(ANSWERS[name]()))


def test_the_claim_is_printed_as_it_is_read(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    proofs = gc.proof_file(ANSWERS["kinds"]())
    file.write_text(proofs.json_text(), encoding="utf-8")
    done = subprocess.run([sys.executable, CHECKER, file], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == [
        "proved, called 'claim' in the file:",
        r"  [a c d] == 0, where [a b c] == 0 and [a b d] == 0 and (a \/ b) != 0 (rank 3)",
        f"theorems proved: 1, digest {proofs.digest}",
    ]


def test_another_digest_is_refused(tmp_path: Path) -> None:
    file = tmp_path / "proof.json"
    text = gc.proof_file(ANSWERS["ideal"]()).json_text()
    file.write_text(text.replace('"digest": "', '"digest": "0'), encoding="utf-8")
    done = subprocess.run([sys.executable, CHECKER, file], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "it names another digest" in done.stderr


def test_the_formula_of_the_superbracket_changes_its_sign_with_the_ends_of_a_line() -> None:
    def polynomial(swap: dict[int, int]) -> dict[Any, int]:
        found: dict[Any, int] = {}
        for sign, rows in CHECK.superbracket_terms():
            signs, sorted_rows = zip(*(CHECK.in_order([swap.get(e, e) for e in row]) for row in rows), strict=True)
            key = tuple(sorted(sorted_rows))
            found[key] = found.get(key, 0) + sign * signs[0] * signs[1] * signs[2]
        return found

    for a in range(0, 12, 2):
        assert polynomial({a: a + 1, a + 1: a}) == {m: -c for m, c in polynomial({}).items()}


def test_a_field_that_is_there_twice_is_refused(tmp_path: Path) -> None:
    """Readers differ in which of the two they take: what one shows would not be what the other has checked."""
    file = tmp_path / "proof.json"
    text = gc.proof_file(ANSWERS["ideal"]()).json_text()
    file.write_text(text.replace('"ideal":', '"ideal":0,"ideal":', 1), encoding="utf-8")
    done = subprocess.run([sys.executable, CHECKER, file], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "a name twice" in done.stderr
    assert not done.stdout


@pytest.mark.parametrize(
    ("change", "code", "says"),
    [
        (lambda t: t["claim"].__setitem__(1, ["number", 5]), 1, "NOT PROVED, called 'claim' in the file"),
        (lambda t: t["relations"].pop(), 1, "NOT PROVED"),
        (lambda t: t["points"].append("e"), 2, "not different"),
        (lambda t: t.pop("ideal"), 2, "KeyError: 'ideal'"),
        (lambda t: t["claim"].pop(), 2, "no proof file"),
        (lambda t: t["claim"].__setitem__(0, ["eval", "a"]), 2, "'eval'"),
        (lambda t: t["claim"].__setitem__(0, ["join", "a", "nobody"]), 2, "nobody"),
    ],
)
def test_what_is_changed_is_refused(change: Any, code: int, says: str, tmp_path: Path) -> None:
    data = json.loads(gc.proof_file(gc.prove("[abc][ade] - [abd][ace] == -[abe][acd]", rank=3)).json_text())
    change(data["theorems"][0])
    file = tmp_path / "proof.json"
    file.write_text(json.dumps(data), encoding="utf-8")
    done = subprocess.run([sys.executable, CHECKER, file], capture_output=True, text=True, check=False)
    assert done.returncode == code, done
    assert says in done.stdout + done.stderr


# --- changed at random ------------------------------------------------------------------------------------------------

MUTANTS = 10_000
PRIME = 7
SEEDS = (
    lambda: gc.prove(r"ab /\ cde == [acde] b - [bcde] a"),
    lambda: gc.prove("[abc][ade] - [abd][ace] == -[abe][acd]", rank=3),
    lambda: gc.analyze("ab af cb cd ed ef"),
    lambda: gc.prove("[acd] == 0", rank=3, given="collinear(a, b, c), collinear(a, b, d)"),
    lambda: gc.prove("[abd][bce][caf] == -[adc][bea][cfb]", rank=3, given=MENELAUS),
    lambda: gc.prove(r"[bc' /\ b'c, ca' /\ c'a, ab' /\ a'b] == 0", rank=3, given=PAPPUS),
    lambda: gc.prove("[ijk] == 0", rank=3, ideal="i j k"),
    lambda: gc.prove("[pabc] == 0", given="incident(p, ab)"),
    lambda: gc.prove("[bde][bcd] == 0", rank=3, given="collinear(a, b, d), [bcd][abe] == [abd][bce]"),
    lambda: gc.prove("[abc][abd][cde] == 0", rank=3, given="[abc][ade] == 0, [abd][ace] == 0"),
    lambda: gc.prove("[pab] == 0", rank=3, given=r"p == ab /\ cd"),
    lambda: gc.prove(r"S \/ ac == 0", letters="screw S", given=r"S \/ ab == 0, collinear(a, b, c)"),
    lambda: gc.prove("[dab] == 0", rank=3, given="c == a + 2 b, incident(d - b, ac)"),
    lambda: gc.prove("[acp] == 2 [bcp]", rank=3, given="collinear(p, c, a - 2 b)"),
    lambda: gc.prove("[abc][aef] == [abd][aef]", rank=3, given="[abc] == [abd]"),
    lambda: gc.prove("[adef] == 0", given=THREE_LINES),
    lambda: gc.prove("[abce][abdf] == 0", given="concurrent(bf, ae, ab)"),
    lambda: gc.prove("[acd] == 0", rank=3, given="[abd] == [abc], [abd] == 2 [abc]"),
    lambda: gc.prove("[abcd] == 0", letters="screw S", given=r"incident(c, S /\ abd)"),
    lambda: gc.prove(TEN_LINES, rank=5),
)
THREE_LINES = r"concurrent(ab, bc, ef), aef /\ cdf /\ abd == 0"
MENELAUS = "incident(d, bc), incident(e, ca), incident(f, ab), collinear(d, e, f)"
PAPPUS = "collinear(a, b, c), collinear(a', b', c')"


REFUSED = (
    CHECK.NotProved,
    OSError,
    ValueError,
    TypeError,
    LookupError,
    AttributeError,
    ArithmeticError,
    RecursionError,
)
"""What the checker refuses a file by."""

STATEMENT = ("rank", "points", "ideal", "definitions", "claim", "any", "given", "nonzero")
"""What a theorem says; the rest is its proof."""


def places(value: Any) -> Iterator[tuple[Any, Any]]:
    """Every place in a tree of lists and mappings."""
    for key in value if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else ():
        yield value, key
        yield from places(value[key])


def mutated(theorem: dict[str, Any], rng: random.Random) -> dict[str, Any]:
    """A theorem with something changed, taken out, put in twice, or exchanged with something else in it."""
    found: dict[str, Any] = json.loads(json.dumps(theorem))
    for _ in range(rng.choice((1, 1, 2, 3))):
        spots = list(places(found))
        holder, key = rng.choice(spots)
        other, there = rng.choice(spots)
        value = holder[key]
        match rng.randrange(5):
            case 0 if isinstance(holder, list):
                del holder[key]
            case 1 if isinstance(holder, list):
                holder.insert(key, json.loads(json.dumps(value)))
            case 2:
                holder[key] = json.loads(json.dumps(other[there]))
            case 3 if isinstance(value, int):
                holder[key] = value + rng.choice((-1, 1, 2))
            case _ if value in theorem["points"]:
                holder[key] = rng.choice(theorem["points"])
    return found


class Coordinates:
    """Values of expressions as the format defines them, from coordinates modulo a prime; shares no code with others."""

    def __init__(self, theorem: Mapping[str, Any], points: Mapping[str, list[int]]) -> None:
        self.rank = theorem["rank"]
        self.definitions = dict(theorem["definitions"])
        self.points = points

    def elsewhere(self, names: Iterable[str], rng: random.Random) -> Coordinates:
        """Where some points are others."""
        at = copy(self)
        at.points = {**self.points, **{n: [rng.randrange(PRIME) for _ in range(self.rank)] for n in names}}
        return at

    def value(self, e: Any) -> tuple[int, dict[tuple[int, ...], int]]:
        """Step and Plücker coordinates."""
        if isinstance(e, str):
            if e in self.definitions:
                return self.value(self.definitions[e])
            return 1, {(i,): x for i, x in enumerate(self.points[e])}
        if e[0] == "number":
            number = Fraction(e[1])
            return 0, {(): number.numerator * pow(number.denominator, -1, PRIME) % PRIME}
        parts = [self.value(e[1])] * e[2] if e[0] == "power" else [self.value(part) for part in e[1:]]
        match e[0]:
            case "sum":
                step = next((s for s, v in parts if any(v.values())), parts[0][0])
                total: dict[tuple[int, ...], int] = {}
                for _, v in parts:
                    for k, x in v.items():
                        total[k] = (total.get(k, 0) + x) % PRIME
                return step, total
            case "bracket":
                return 0, {(): reduce(self.join, parts)[1].get(tuple(range(self.rank)), 0)}
            case "meet":
                return reduce(self.meet, parts)
            case "superbracket":
                pairs = list(combinations(range(self.rank), 2))
                return 0, {(): determinant([[v.get(p, 0) for p in pairs] for _, v in parts])}
        return reduce(self.join, parts)

    def join(self, a: Any, b: Any) -> tuple[int, dict[tuple[int, ...], int]]:
        out: dict[tuple[int, ...], int] = {}
        for r, x in a[1].items():
            for s, y in b[1].items():
                if not set(r) & set(s):
                    key = tuple(sorted(r + s))
                    out[key] = (out.get(key, 0) + parity(r + s) * x * y) % PRIME
        return a[0] + b[0], out

    def meet(self, a: Any, b: Any) -> tuple[int, dict[tuple[int, ...], int]]:
        """By complements: the meet is the join of the duals."""
        return self.rank - (2 * self.rank - a[0] - b[0]), self.dual(
            self.join((self.rank - a[0], self.dual(a[1], 1)), (self.rank - b[0], self.dual(b[1], 1)))[1], -1
        )

    def dual(self, v: Mapping[tuple[int, ...], int], side: int) -> dict[tuple[int, ...], int]:
        found = {}
        for r, x in v.items():
            rest = tuple(i for i in range(self.rank) if i not in r)
            found[rest] = x * parity(r + rest if side > 0 else rest + r) % PRIME
        return found


def parity(row: tuple[int, ...]) -> int:
    return -1 if sum(x > y for x, y in combinations(row, 2)) % 2 else 1


def determinant(rows: list[list[int]]) -> int:
    """By elimination modulo the prime."""
    rows, value = [list(r) for r in rows], 1
    for i in range(len(rows)):
        pivot = next((k for k in range(i, len(rows)) if rows[k][i] % PRIME), None)
        if pivot is None:
            return 0
        if pivot != i:
            rows[i], rows[pivot], value = rows[pivot], rows[i], -value
        value = value * rows[i][i] % PRIME
        inverse = pow(rows[i][i], -1, PRIME)
        for k in range(i + 1, len(rows)):
            factor = rows[k][i] * inverse
            rows[k] = [(x - factor * y) % PRIME for x, y in zip(rows[k], rows[i], strict=True)]
    return value % PRIME


def false_somewhere(theorem: Mapping[str, Any], rng: random.Random, tries: int = 1_500) -> bool:
    """Whether random points were found that satisfy what is assumed, at which the sides differ."""
    names = [*theorem["points"], *theorem.get("any", []), *(p["name"] for p in theorem.get("placed", []))]
    at_infinity = set(theorem["points"][: theorem["ideal"]])
    assumed = "given" in theorem
    for _ in range(tries if assumed else 6):
        points = {}
        for n in names:
            rank = theorem["rank"]
            points[n] = [rng.randrange(PRIME) for _ in range(rank - 1)] + [0 if n in at_infinity else 1]
            if assumed and len(points) > 2 and rng.random() < 0.5:  # on the line of two others, so that more hold
                a, b = rng.sample(sorted(points), 2)
                x, y = rng.randrange(PRIME), rng.randrange(PRIME)
                points[n] = [(x * p + y * q) % PRIME for p, q in zip(points[a], points[b], strict=True)]
        at = Coordinates(theorem, points)

        def zero(e: Any, at: Coordinates = at) -> bool:
            return not any(at.value(e)[1].values())

        if assumed and (not all(map(zero, theorem["given"])) or any(map(zero, theorem["nonzero"]))):
            continue
        others = [at.elsewhere(theorem.get("any", ()), rng) for _ in range(5)]
        if not all(zero(e, other) for e in theorem.get("given", ()) for other in others):
            continue
        (_, left), (_, right) = map(at.value, theorem["claim"])
        if any((left.get(k, 0) - right.get(k, 0)) % PRIME for k in {*left, *right}):
            return True
    return False


@cache
def seeds() -> list[dict[str, Any]]:
    return [t for make in SEEDS for t in json.loads(gc.proof_file(make()).json_text())["theorems"]]


def test_the_oracle_sees_what_is_false() -> None:
    rng = random.Random(1)
    for theorem in seeds():
        assert not false_somewhere(theorem, rng), theorem["name"]
        left = theorem["claim"][0]
        extensor = isinstance(left, str) or left[0] in ("join", "meet")
        wrong = {**theorem, "claim": [left, ["product", ["number", 2], left] if extensor else ["number", 5]]}
        assert false_somewhere(wrong, rng, 15_000), theorem["name"]


@pytest.mark.parametrize("part", range(10))
def test_none_of_many_changed_proofs_is_accepted_unless_it_is_true(part: int) -> None:
    accepted = 0
    for n in range(MUTANTS // 10):
        rng = random.Random(f"{part} {n}")
        true = rng.choice(seeds())
        theorem = mutated(true, rng)
        try:
            CHECK.check(theorem)
        except REFUSED:
            continue
        accepted += 1
        if all(theorem.get(key) == true.get(key) for key in STATEMENT):
            continue
        assert not false_somewhere(theorem, rng), theorem
    assert accepted  # a name that is changed everywhere, a relation that is given twice and taken away again


def false_cases() -> Iterator[dict[str, Any]]:
    """Theorems in cases of which the last is not what it should be, so that the claims are false."""
    for claim, given, rank in (
        ("[abc][abd] == 0", "[abc][abc][abd] == 0", 3),
        ("[abc][abe] == 0", "[abc][abe][abe] == 0", 3),
        ("[abce][abdf] == 0", "concurrent(bf, ae, ab)", 4),
    ):
        (true,) = json.loads(gc.proof_file(gc.prove(claim, rank=rank, given=given)).json_text())["theorems"]
        assert len(true["cases"]) == 3
        for kept in (1, 2):
            found = json.loads(json.dumps(true))
            holds = [found["cases"][kept]["given"][-1], ["number", 0]]
            for theorem in (found, *found["cases"][1:]):
                theorem["claim"] = holds
            found["cases"][kept]["relations"] = []
            yield found


def test_no_change_lets_a_false_claim_pass_by_its_cases() -> None:
    """Most changes leave the claim as it is, which is true for one case alone."""
    bases = list(false_cases())
    for theorem in bases:
        assert false_somewhere(theorem, random.Random(0), 15_000)
    read = 0
    for n in range(6_000):
        rng = random.Random(f"cases {n}")
        theorem = mutated(rng.choice(bases), rng)
        try:
            CHECK.check(theorem)
        except CHECK.NotProved:
            read += 1
        except REFUSED:
            continue
        else:
            assert not false_somewhere(theorem, rng, 4_000), theorem
    assert read > 1_000


def test_changed_proofs_about_a_conic_are_true_at_points_of_circles() -> None:
    """Auxiliary points, and assumptions that hold by relations: Simson's line, in circles that are built otherwise."""
    script = run_script(parse_script((EXAMPLES / "theorems" / "simson.gca").read_text(encoding="utf-8")))
    (true,) = json.loads(proof_file(script).json_text())["theorems"]
    CHECK.check(true)
    circles = [METRIC["simson"](random.Random(n)) for n in range(20)]
    places = [{n: [c % PRIME for c in v] for n, v in circle.items()} for circle in map(whole, circles)]
    changed = 0
    for n in range(3_000):
        theorem = mutated(true, random.Random(n))
        try:
            CHECK.check(theorem)
        except REFUSED:
            continue
        if all(theorem.get(key) == true.get(key) for key in STATEMENT):
            continue
        changed += 1
        for points in places:
            at = Coordinates(theorem, points)
            vanish = [not any(at.value(e)[1].values()) for e in theorem["given"]]
            live = [any(at.value(e)[1].values()) for e in theorem["nonzero"]]
            (_, left), (_, right) = map(at.value, theorem["claim"])
            equal = not any((left.get(k, 0) - right.get(k, 0)) % PRIME for k in {*left, *right})
            assert equal or not all((*vanish, *live)), theorem
    assert changed


def whole(circle: Mapping[str, tuple[Fraction, ...]]) -> dict[str, tuple[int, ...]]:
    """The same points with whole coordinates."""
    return {n: tuple(int(c * lcm(*(x.denominator for x in v))) for c in v) for n, v in circle.items()}
