"""Factorizations with letters for lines, planes and hyperplanes, beside an enumeration of all expressions."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, product
from random import Random

import pytest
from click.testing import CliRunner

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.factoring.result import Factorization
from gcrules.algebra.language.statements import parse_letters
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.letters import letter_of, names_of
from gcrules.algebra.scalars import bracket
from gcrules.apps.cli import cli
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.core.errors import InputError

P = 2_147_483_629

Vector = dict[tuple[int, ...], int]
"""An extensor: its coordinates at sets of basis vectors, those that are not 0."""


def sign_of(row: Sequence[int]) -> int:
    """Of the permutation that sorts a row; 0 where a number stands twice."""
    if len(set(row)) < len(row):
        return 0
    return -1 if sum(a > b for a, b in combinations(row, 2)) % 2 else 1


def joined(a: Vector, b: Vector) -> Vector:
    found: Counter[tuple[int, ...]] = Counter()
    for (i, x), (j, y) in product(a.items(), b.items()):
        found[tuple(sorted((*i, *j)))] += sign_of((*i, *j)) * x * y
    return {i: x % P for i, x in found.items() if x % P}


def met(a: Vector, b: Vector, rank: int) -> Vector:
    """Σ ± [A₁ B] A₂ over all ways to share A out."""
    found: Counter[tuple[int, ...]] = Counter()
    for (i, x), (j, y) in product(a.items(), b.items()):
        first, common = tuple(k for k in i if k not in j), tuple(k for k in i if k in j)
        if len(first) + len(j) == rank:
            found[common] += sign_of((*first, *common)) * sign_of((*first, *j)) * x * y
    return {i: x % P for i, x in found.items() if x % P}


def step_of(a: Vector) -> int:
    return len(next(iter(a)))


def combined(a: Vector, b: Vector, rank: int) -> Vector:
    """The join, or where the steps are too many the meet."""
    return joined(a, b) if step_of(a) + step_of(b) <= rank else met(a, b, rank)


def value(e: Expr, at: Mapping[str, Vector], rank: int) -> Vector:
    """An expression at positions."""
    match e:
        case ex.Number(value=number):
            return {(): int(number) % P}
        case ex.Point(name=name):
            return at[name]
        case ex.Sum(terms=terms):
            total: Counter[tuple[int, ...]] = Counter()
            for term in terms:
                total.update(value(term, at, rank))
            return {i: x % P for i, x in total.items() if x % P}
        case ex.Bracket(args=args) | ex.Join(args=args) | ex.Product(factors=args):
            found: Vector = {(): 1}
            for arg in args:
                found = joined(found, scalar(value(arg, at, rank), rank))
            return scalar(found, rank) if isinstance(e, ex.Bracket) else found
        case ex.Meet(args=args):
            first, *others = (value(arg, at, rank) for arg in args)
            for other in others:
                first = met(first, other, rank)
            return first
    raise AssertionError(e)


def scalar(a: Vector, rank: int) -> Vector:
    """A multiple of the whole space as a number."""
    return dict(zip([()], a.values(), strict=True)) if a and step_of(a) == rank else a


def number(e: Expr, at: Mapping[str, Vector], rank: int) -> int:
    return next(iter(value(e, at, rank).values()), 0)


def drawn(rng: Random, names: Sequence[str], rank: int) -> dict[str, Vector]:
    return {n: {(i,): rng.randrange(1, P) for i in range(rank)} for n in names}


def atoms(names: Sequence[str]) -> Iterator[tuple[str, ...]]:
    """Points, and letters as the points that they join."""
    seen: dict[tuple[str, ...], None] = {}
    for n in names:
        of = letter_of(n)
        seen[(n,) if of is None else names_of(of[0], of[2])] = None
    yield from seen


def one_expression(poly: gc.BracketPolynomial, seed: int) -> bool:
    """Whether an expression of joins and meets with whole letters, without a scalar inside, has the polynomial's values
    at three positions, up to a factor: by making all of them.
    """
    rank, rng = poly.rank, Random(seed)
    degrees = dict(poly.degrees() or {})
    at = [drawn(rng, tuple(degrees), rank) for _ in range(3)]
    wanted = [number(poly.to_expr(), position, rank) for position in at]
    letters = list(atoms(tuple(degrees)))
    whole = tuple(degrees[some[0]] for some in letters)
    known: dict[tuple[int, ...], list[tuple[Vector, ...]]] = {}
    for used in sorted(product(*(range(n + 1) for n in whole)), key=sum):
        found: list[tuple[Vector, ...]] = []
        if sum(used) == 1:
            some = letters[used.index(1)]
            found = [tuple(value(ex.join(*map(ex.Point, some), rank=rank), position, rank) for position in at)]
        for one in known if sum(used) > 1 else ():
            other = tuple(n - k for n, k in zip(used, one, strict=True))
            if other in known and one <= other:
                for a, b in product(known[one], known[other]):
                    made = tuple(combined(x, y, rank) for x, y in zip(a, b, strict=True))
                    if all(made):
                        found.append(made)
        scalars = [f for f in found if step_of(f[0]) in (0, rank)]
        if used == whole:
            values = [[next(iter(x.values())) for x in f] for f in scalars]
            return any(all((v[k] * wanted[0] - v[0] * wanted[k]) % P == 0 for k in (1, 2)) for v in values)
        known[used] = [f for f in found if step_of(f[0]) not in (0, rank)]
    return False


def holds(found: Factorization, seed: int) -> bool:
    """Whether the factorization has the values of the input at two positions."""
    assert found.input is not None
    whole = found.whole()
    for n in range(2):
        at = drawn(Random(f"{seed} {n}"), found.points, found.rank)
        one, other = number(found.input, at, found.rank), number(whole, at, found.rank)
        if not one or ((one - other) % P and (one + other) % P):
            return False
    return True


def whole_letters(e: Expr) -> bool:
    """Whether the text of an expression shows no point of a letter."""
    return not any("₁" <= c <= "₉" for c in str(e))


FOUND = [
    ("line L M N", 4, "[L /\\ abc, M /\\ abd, N]"),
    ("line L M", 4, "[L /\\ abc, M /\\ ade, f, M /\\ bcd] [L /\\ def, M, a]"),
    ("line L", 4, "[L /\\ abc, L /\\ ade, b, f]"),
    ("line L, plane P Q", 4, "[P /\\ Q, L /\\ abc, a]"),
    ("plane P Q R", 4, "[P /\\ Q /\\ R, P /\\ ab, c, a]"),
    ("line l m n", 3, "[l /\\ m, n /\\ ab, c] [l a]"),
    ("hyperplane h k", 3, "[h /\\ k, h /\\ ab, a]"),
    ("hyperplane H K, line L", 5, "[H /\\ K, L]"),
]


@pytest.mark.parametrize(("letters", "rank", "text"), FOUND)
def test_what_is_an_expression_is_found(letters: str, rank: int, text: str) -> None:
    e = parse(text, context=parse_letters(letters, Context(rank)))
    found = gc.factor(gc.expand(e))
    assert found.exists
    assert found.proved
    assert whole_letters(found.whole())
    assert holds(found, 1)


def random_polynomial(rng: Random, letters: str, names: str, degrees: Mapping[str, int]) -> gc.BracketPolynomial:
    """A sum of two products of brackets, each filled with the letters and points in random order."""
    steps = {n: 2 if n in letters.split("line ")[-1] else 1 for n in names}
    terms: list[str] = []
    while len(terms) < 2:
        pool = [n for n in names for _ in range(degrees[n])]
        rng.shuffle(pool)
        rows: list[list[str]] = [[]]
        for n in pool:
            if sum(steps[m] for m in rows[-1]) == 4:
                rows.append([])
            rows[-1].append(n)
        if all(sum(steps[m] for m in row) == 4 and len(set(row)) == len(row) for row in rows):
            terms.append("".join(f"[{' '.join(row)}]" for row in rows))
    found = gc.expand(f"{terms[0]} {rng.choice(['+', '-', '+ 2', '- 2'])}{terms[1]}", letters=letters)
    assert isinstance(found, gc.BracketPolynomial)
    return found


SHAPES = [
    ("line L M", "LMabcd", dict.fromkeys("LMabcd", 1)),
    ("line L M", "LMabc", {"L": 1, "M": 1, "a": 2, "b": 1, "c": 1}),
    ("line L", "Labc", {"L": 2, "a": 2, "b": 1, "c": 1}),
    ("line L M", "LMab", {"L": 2, "M": 1, "a": 1, "b": 1}),
]


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize(("letters", "names", "degrees"), SHAPES)
def test_the_verdict_is_that_of_an_enumeration(letters: str, names: str, degrees: Mapping[str, int], seed: int) -> None:
    poly = random_polynomial(Random(f"{names} {seed}"), letters, names, degrees)
    if not gc.straighten(poly):
        return
    found = gc.factor(poly)
    assert found.exists is not None
    assert holds(found, seed)
    if not found.factors and not found.parts and not isinstance(found.expression, ex.Product):
        assert one_expression(poly, seed) is found.exists


def planted(rng: Random, letters: Sequence[tuple[str, int]]) -> Expr | None:
    """An expression in which each letter or point is used once more for each time that it stands there; None where what
    is combined at random is zero, or a scalar before its end.
    """
    pool = [ex.join(*map(ex.Point, names_of(n, k)), rank=4) if k > 1 else ex.Point(n) for n, k in letters]
    while len(pool) > 1:
        one, other = (pool.pop(rng.randrange(len(pool))) for _ in range(2))
        steps = one.step + other.step
        if steps == 4:
            return None if pool else bracket(one, other, rank=4)
        pool.append(ex.join(one, other, rank=4) if steps < 4 else ex.meet(one, other, rank=4))
        if not pool[-1].step:
            return None
    return None


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("word", ["LLMab", "PLMa", "LLabcd", "LLMMabcd", "PPQLa", "PQLLab", "PPLabcd"])
def test_what_is_planted_is_found(word: str, seed: int) -> None:
    rng = Random(f"{word} {seed}")
    letters = [(n, 3 if n in "PQ" else 2 if n in "LM" else 1) for n in word]
    for _ in range(500):
        e = planted(rng, letters)
        poly = None if e is None else gc.expand(ex.mul(e))
        if isinstance(poly, gc.BracketPolynomial) and gc.straighten(poly):
            break
    found = gc.factor(poly)
    assert found.exists
    assert found.proved
    assert whole_letters(found.whole())
    assert holds(found, seed)


LEGS = [
    ("Aa Ab Ac Bd {} {}", True),
    ("Aa Ab Bc Bd {} {}", False),
    ("Aa Ab Bc {} {} {}", False),
    ("Aa Ab Ac {} {} {}", True),
    ("Aa Ab Ba Bc Cb {}", False),
]


@pytest.mark.parametrize(("legs", "exists"), LEGS)
def test_legs_that_are_letters_have_the_verdict_of_pairs_of_points(legs: str, exists: bool) -> None:
    """A line that shares no joint is a pair of points used nowhere else."""
    number = legs.count("{}")
    pairs = ["ef", "gh", "ij"][:number]
    of_points = gc.factor(f"[[{legs.format(*pairs).replace(' ', ', ')}]]")
    names = ["L", "M", "N"][:number]
    letters = f"line {' '.join(names)}"
    of_letters = gc.factor(gc.expand(f"[[{legs.format(*names).replace(' ', ', ')}]]", letters=letters))
    assert of_points.exists is of_letters.exists is exists
    assert holds(of_letters, 7)


def test_the_family_names_the_letters() -> None:
    found = gc.factor("[[Aa, Ab, Bc, Bd, L, M]]", letters="line L M")
    assert found.exists is False
    assert "one expression of joins and meets with L and M whole, all with" in found.family.name
    assert "no other expression of joins and meets with L and M whole equals it" in found.certificate.detail


def test_all_forms_are_whole() -> None:
    found = gc.factor("[[Aa, Ab, Ac, Bd, L, M]]", letters="line L M", all=True)
    assert len(found.alternatives) == 2
    for form in (found, *found.alternatives):
        assert whole_letters(form.expression)


def test_data_name_the_points_of_letters() -> None:
    found = gc.factor("[[Aa, Ab, Bc, L, M, N]] [a b L]", letters="line L M N").to_json()
    assert found["letters"]["L"] == "L1 \\/ L2"
    assert "₁" not in json.dumps(found, ensure_ascii=False)
    assert found["factors"] == ["[Lab]"]


def test_irreducible_factors_with_letters() -> None:
    found = gc.factors("[[Aa, Ab, Bc, Bd, L, M]] [L a b]", letters="line L M")
    assert [f.form for f in found.factors] == ["bracket", "transversals"]
    assert found.complete
    assert str(found.factors[0].expression) == "[Lab]"
    assert found.factors[1].degrees["L"] == 1
    assert whole_letters(found.to_expr())
    none = gc.factors("[[Aa, Ab, Bc, L, M, N]]", letters="line L M N")
    (factor,) = none.factors
    assert factor.form == "undecided"
    assert factor.excluded[0].startswith("one expression: ")
    assert "a cofactor: it is sought where all letters are points" in factor.undecided


def test_cofactors_are_sought_of_points() -> None:
    found = gc.factor("[[Aa, Ab, Bc, Bd, L, M]]", letters="line L M", cofactor=True)
    assert found.undecided == ("a cofactor: it is sought where all letters are points",)


def test_a_limit_leaves_letters_whole() -> None:
    found = gc.factor("[[Aa, Ab, Ac, Bd, L, M]]", letters="line L M", limit=3)
    assert found.exists is None
    assert "ABd" in found.text() or "L" in found.text()
    assert found.text().count("₁") == 0


@pytest.mark.parametrize("exists", [True, False])
def test_the_proof_file_is_about_letters(exists: bool) -> None:
    legs = "Aa, Ab, Ac, Bd, L, M" if exists else "Aa, Ab, Bc, Bd, L, M"
    file = gc.proof_file(gc.factor(f"[[{legs}]]", letters="line L M"))
    assert [t.name for t in file.theorems] == ["factorization" if exists else "expansion"]
    assert any("of the family" in left.name for left in file.left_out) is not exists


def test_the_command_and_the_prompt_take_letters() -> None:
    done = CliRunner().invoke(cli, ["factor", "--letters", "line L M", "[[Aa,Ab,Ac,Bd,L,M]]", "--ascii"])
    assert done.exit_code == 0
    assert done.stdout.startswith("[Aabc](ABd /\\ AL /\\ M)\n")
    answers = [a.text for a in Interpreter().feed("line L M\n:factor [[Aa,Ab,Ac,Bd,L,M]]\n:factors [L a b]")]
    assert answers[-2].startswith("[Aabc](ABd ∧ AL ∧ M)\n")
    assert answers[-1].startswith("[Lab]\n")


def test_shortest_forms_are_of_points() -> None:
    with pytest.raises(InputError, match="only expressions of points are shortened, and L is a line"):
        gc.shorten("[L a b]", letters="line L")


def test_absences_of_factors_are_about_whole_letters() -> None:
    (one,) = gc.factors("[[Aa, Ab, Bc, Cd, De, L]]", letters="line L").factors
    assert any("no other expression of joins and meets with L whole equals it" in words for words in one.excluded)
