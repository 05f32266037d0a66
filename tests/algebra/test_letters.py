"""Letters that stand for lines, planes and hyperplanes, compared with coordinates modulo a prime.

A line is given here by six coordinates that satisfy the quadratic relation, a plane by its covector; what brackets and
meets of them are is computed without the engine.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import combinations, permutations
from random import Random

import pytest
from faults import refused

import gcrules as gc
from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.algebra.expand import expand
from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.language.statements import parse_assumption, parse_letters, parse_script
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.letters import letters_of, names_of, plain_name
from gcrules.algebra.whole_letters import in_letters
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.core.errors import GcrulesError, InputError, SyntaxFault
from gcrules.rules.factorization import factored
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.script import run_script

SPACE = parse_letters("line K L M N, plane P Q", Context(4))


def determinant(columns: Sequence[Sequence[int]]) -> int:
    """By its definition over permutations."""
    total = 0
    for order in permutations(range(len(columns))):
        sign = (-1) ** sum(a > b for a, b in combinations(order, 2))
        for column, row in zip(columns, order, strict=True):
            sign *= column[row]
        total += sign
    return total % PRIME


def positions(text: str, at: Context, seed: int = 0) -> dict[str, tuple[int, ...]]:
    rng, e = Random(f"{text}{seed}"), parse(text, context=at)
    return {n: tuple(rng.randrange(PRIME) for _ in range(at.rank)) for n in gc.algebra.expr.points_of(e)}


def plucker(a: Sequence[int], b: Sequence[int]) -> list[int]:
    return [(a[i] * b[j] - a[j] * b[i]) % PRIME for i, j in combinations(range(4), 2)]


def covector(points: Sequence[Sequence[int]]) -> list[int]:
    """The numbers h with [points x] = h · x."""
    d = len(points) + 1
    return [determinant([*points, [int(i == j) for j in range(d)]]) for i in range(d)]


def moment(p: Sequence[int], q: Sequence[int]) -> int:
    """The mutual moment of two lines from their six coordinates, in the order 12, 13, 14, 23, 24, 34."""
    return (p[0] * q[5] - p[1] * q[4] + p[2] * q[3] + p[3] * q[2] - p[4] * q[1] + p[5] * q[0]) % PRIME


def value(text: str, at: Context, points: dict[str, tuple[int, ...]]) -> list[int]:
    return [v % PRIME for v in Evaluator(points, at.rank, PRIME).value(parse(text, context=at))]


def test_brackets_and_meets_of_lines_and_planes_are_what_their_coordinates_say() -> None:
    at = positions("[K L] [a b c d] * [P a]", SPACE)
    line = {n: plucker(*(at[m] for m in names_of(n, 2))) for n in "KL"}
    plane = covector([at[n] for n in names_of("P", 3)])
    assert value("[K L]", SPACE, at) == value("K /\\ L", SPACE, at) == [moment(line["K"], line["L"])]
    assert value("[K a b]", SPACE, at) == [moment(line["K"], plucker(at["a"], at["b"]))]
    assert value("[P a]", SPACE, at) == [sum(h * x for h, x in zip(plane, at["a"], strict=True)) % PRIME]
    p, q, r, s, t, u = line["K"]
    assert (p * u - q * t + r * s) % PRIME == 0  # the quadratic relation
    met = value("K /\\ P", SPACE, at)
    assert sum(h * x for h, x in zip(plane, met, strict=True)) % PRIME == 0
    assert not any(v % PRIME for v in value("(K /\\ P) \\/ K", SPACE, at))


def test_in_the_plane_a_line_is_a_covector() -> None:
    plane = parse_letters("line L M, hyperplane N", Context(3))
    at = positions("[a L] [b M] [c N]", plane)
    h = {n: covector([at[m] for m in names_of(n, 2)]) for n in "LMN"}
    assert value("[a L]", plane, at) == [sum(x * y for x, y in zip(h["L"], at["a"], strict=True)) % PRIME]
    assert value("L /\\ M /\\ N", plane, at) == [determinant([h["L"], h["M"], h["N"]])]


EXPRESSIONS = [
    "(a L) /\\ M",
    "[(a L) /\\ M, b, N]",
    "L /\\ P",
    "P /\\ Q",
    "P /\\ Q /\\ abc",
    "[(P /\\ Q), L]",
    "(P /\\ L) \\/ (Q /\\ M)",
    "[(a L) /\\ M, b, (c N) /\\ K, d]",
    "[(a L) /\\ M, b c d] - 2 [a b c d] [L M]",
    "abc /\\ L",
]


@pytest.mark.parametrize("text", EXPRESSIONS)
def test_what_is_printed_has_whole_letters_is_equal_and_reads_back(text: str) -> None:
    p = expand(parse(text, context=SPACE))
    shown = str(p)
    assert not set("₁₂₃") & set(shown), shown
    at = positions(text, SPACE)
    assert value(shown, SPACE, at) == value(text, SPACE, at)
    assert str(parse(shown, context=SPACE)) == shown


def test_what_cannot_be_written_in_whole_letters_says_what_its_points_are() -> None:
    shown = gc.expand("[[K, L, M, ab, cd, ef]]", letters="line K L M").text()
    assert "# L = L₁ ∨ L₂" in shown or "L = L₁ ∨ L₂, " in shown
    p = expand(parse("[[K, L, M, ab, cd, ef]]", context=SPACE))
    at = positions("[[K, L, M, ab, cd, ef]]", SPACE)
    assert [v % PRIME for v in Evaluator(at, 4, PRIME).value(in_letters(p))] == value(
        "[[K, L, M, ab, cd, ef]]", SPACE, at
    )


def test_a_polynomial_that_depends_on_the_points_of_a_letter_is_left_as_it_is() -> None:
    one = gc.algebra.bracket.BracketPolynomial(
        4, (*names_of("L", 2), "a", "b", "c", "d"), {((0, 2, 3, 4), (1, 2, 3, 5)): 1}
    )
    assert in_letters(one) == one.to_expr()


CLAIMS = [
    ("line L M", "", "[L M] == 0", "refuted"),
    ("line L M", "incident(a, L), incident(a, M)", "[L M] == 0", "proved"),
    ("line L M", "[L M] == 0", "concurrent(L, M)", "proved"),
    ("line L, plane P", "incident(L, P), incident(a, L)", "[a P] == 0", "proved"),
    ("line L, plane P", "incident(a, L)", "[a P] == 0", "refuted"),
    ("line L M N", "", "[[L, M, N, ab, cd, ef]] == -[[M, L, N, ab, cd, ef]]", "proved"),
    ("plane P Q", "", "P /\\ Q == -(Q /\\ P)", "proved"),
    ("line L", "", "[L a b] [c d e f] == [L a b] [d c f e]", "proved"),
]


@pytest.mark.parametrize(("letters", "given", "claim", "verdict"), CLAIMS)
def test_claims_with_letters_are_decided(letters: str, given: str, claim: str, verdict: str) -> None:
    found = gc.prove(claim, letters=letters, given=given or ())
    assert found.verdict == verdict, found
    assert not any(set("₁₂₃") & set(e) for e in found.assumed), found.assumed


def test_a_counterexample_shows_coordinates_of_letters() -> None:
    found = gc.prove("[L M] == 0", letters="line L M")
    points = found.counterexample
    assert points is not None
    p, q = (plucker(*(points[n] for n in names_of(k, 2))) for k in "LM")
    assert moment(p, q) == found.values[0] % PRIME
    shown = found.text()
    assert "L = (" in shown
    assert "Plücker coordinates" in shown
    assert "L₁" not in shown
    other = gc.prove("[P a] == 0", letters="plane P")
    assert "coordinates of the plane" in other.text()


def test_what_a_choice_of_points_on_a_letter_can_avoid_is_not_assumed() -> None:
    found = gc.prove("[L M] == 0", letters="line L M", given="incident(a, L), incident(a, M)")
    assert found.assumed == ()


def test_scripts_declare_letters_and_assumptions_do() -> None:
    answer = run_script(parse_script('rank 3 line L M claim "meet": [(L ^ M) L] == 0 given line N show L ^ N'))
    assert [r.verdict for r in answer.results] == ["proved", "shown"]
    assert answer.text().splitlines()[1] == "line 1: L ^ N = L /\\ N"
    assert letters_of(["L₁", "P₂₃", "a"]) == {"L": 2, "P": 3}
    assert plain_name("P₂₃") == "P23"


FAULTS = [
    ("line a points a", "a is already a line (step 2)"),
    ("points a line a", "a is already declared"),
    ("given collinear(L, a, b) line L", "L is already a point in what stands before"),
    ("line L plane L", "L is already declared"),
    ("line L let L = ab", "L is already declared"),
    ("rank 3 plane P", "a plane is the whole space in rank 3"),
    ("rank 2 line L", "a line is the whole space in rank 2"),
    ("rank 2 hyperplane H", "a hyperplane is a point in rank 2"),
    ("line L show [.L a b][.c d e f]", "a dot marks a point, and L is a line (step 2)"),
    ("line L claim collinear(L, a, b)", "a line (step 2) where a point is expected"),
    ("line L M rule r: [L a b] => [M a b]", "unbound letter M: not on the left side of the rule"),
    ("rank 3 isotropic i j line L claim equal_distance(L, ab)", "where a line of two points is expected"),
]


@pytest.mark.parametrize(("text", "message"), FAULTS)
def test_faults_say_what_is_wrong(text: str, message: str) -> None:
    refused(text, message)


def test_only_letters_are_declared_where_letters_are_asked_for() -> None:
    for text in ("ideal i", "line L, ideal i", "collinear(a, b, c)"):
        with pytest.raises(InputError, match="declares more than letters"):
            parse_letters(text, Context(4))
    with pytest.raises(InputError, match="only expressions of points are shortened"):
        gc.shorten(parse("[L a b]", context=parse_assumption("line L")))


def test_formulas_set_letters_and_their_points() -> None:
    assert gc.expand("(a L1) ^ M'", letters="line L1 M'").latex() == "M' \\wedge L_{1}a"
    one = gc.algebra.bracket.BracketPolynomial(4, (*names_of("L", 2), "a", "b", "c"), {((0, 2, 3, 4),): 1})
    assert one.latex() == "[L_{1}abc]"


LEGS = [
    ("line L M", "Aa Ab Bc Bd L M", "two-planes-three-lines"),
    ("line L", "Aa Ab Ac Bd Be L", "three-tetrahedra"),
]


@pytest.mark.parametrize(("letters", "legs", "kind"), LEGS)
def test_legs_that_are_letters_need_no_points(letters: str, legs: str, kind: str) -> None:
    """The condition of a platform is the determinant of the lines' coordinates."""
    found = gc.analyze(legs, given=letters)
    s = found.structure
    lines = [parse(word, context=parse_letters(letters, Context(4))) for word in legs.split()]
    rng = Random(legs)
    names = sorted({*gc.algebra.expr.points_of(*lines), *s.names})
    at = {n: tuple(rng.randrange(PRIME) for _ in range(4)) for n in names}
    rows = [[v % PRIME for v in Evaluator(at, 4, PRIME).value(line)] for line in lines]
    assert found.condition.kind == kind
    value = Evaluator(at, 4, PRIME).value(found.condition.expression)[0]
    assert (found.condition.coefficient * value - determinant(rows)) % PRIME == 0
    assert "letters      L = L₁ " in found.text()


def test_transversals_and_the_prompt_take_letters_as_legs() -> None:
    found = gc.transversals("Aa Ab Bc Bd L M", given="line L M")
    assert "(AB /\\ L)(Aab /\\ Bcd /\\ M)" in str(found.condition.expression)
    answers = [a.text for a in Interpreter().feed("line L M\n:transversals Aa Ab Bc Bd L M\n:context")]
    assert "L and M" in answers[0]
    assert "letters     L, a line (step 2)" in answers[-1]


def test_a_factorization_is_sought_of_legs_that_are_letters() -> None:
    structure = read_legs("Aa Ab Ac Bd L M", given="line L M")
    found = factored([expand(structure.superbracket)], structure, RandomWitness(structure))
    assert found.condition is not None
    assert str(found.condition.expression) == "[Aabc](ABd /\\ AL /\\ M)"
    assert found.condition.certificate.method == "normal-form"
    structure = read_legs("Aa Ab Bc Bd L M", given="line L M")
    found = factored([expand(structure.superbracket)], structure, RandomWitness(structure))
    assert found.condition is None
    assert found.note.endswith("multidegree; with a cofactor it is sought where all letters are points")


LEG_FAULTS = [
    ("line L", "ab cd ef gh ij aL", "expected a line, found a plane (step 3)"),
    ("plane P", "ab cd ef gh ij P", "expected a line, found a plane (step 3)"),
    ("line L", "ab cd ef gh ij L + ab", "a leg"),
]


@pytest.mark.parametrize(("letters", "legs", "message"), LEG_FAULTS)
def test_letters_that_are_no_lines_are_no_legs(letters: str, legs: str, message: str) -> None:
    with pytest.raises(GcrulesError) as fault:
        gc.analyze(legs, given=letters)
    assert message in str(fault.value)


@pytest.mark.parametrize(("read", "text"), [(parse_assumption, "sphere K"), (parse_script, "rank 3\ncircle Q\n")])
def test_circles_and_spheres_have_no_letters(read: Callable[[str], object], text: str) -> None:
    with pytest.raises(
        SyntaxFault, match=r"expected (==|claim, .*line, plane, hyperplane, conic, quadric or screw)"
    ) as caught:
        read(text)
    assert (caught.value.hint or "").startswith("letters stand for lines, planes, screws, conics and quadrics")


def test_a_letter_is_no_corner_of_a_tetrahedron() -> None:
    found = gc.analyze("Aa Ab L Bc Bd Ce", given="line L, incident(A, L)")
    assert "tetrahedra ABCe and ABcd is flat" in str(found.condition.statement)
    assert "the line L, a and b lie in one plane" in str(found.condition.statement)


@pytest.mark.parametrize(
    ("letters", "claim", "given", "together"),
    [
        ("line L M", "[L M] == 0", "incident(a, L), incident(b, L), incident(a, M), incident(b, M)", (("L", "M"),)),
        ("line L M", "[L M] == 0", "incident(a, L), incident(a, M)", ()),
        ("line L M", r"a \/ M == 0", "incident(a, L), incident(b, L), incident(a, M), incident(b, M)", (("L", "M"),)),
        ("line L, plane P Q", r"L /\ Q == 0", r"incident(L, P), P /\ Q == 0", ()),
        ("line L M", "[L M] == 0", "incident(L, M)", ()),
    ],
)
def test_letters_that_coincide_without_being_said_to_are_named(
    letters: str, claim: str, given: str, together: tuple[tuple[str, str], ...]
) -> None:
    proof = gc.prove(claim, letters=letters, given=given)
    assert proof.proved
    assert proof.together == together
    assert ("coincide, which the assumptions do not say" in str(proof)) == bool(together)
