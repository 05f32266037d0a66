"""Theorems with their proofs, as `algebra/proofs/` writes them; `project/test_check_proof.py` has them checked."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from places import ROOT

import gcrules as gc
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import points_of
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import Context, parse, parse_equation
from gcrules.algebra.proofs.proof_file import LeftOut, ProofFile
from gcrules.algebra.proofs.proving import theorem
from gcrules.algebra.proofs.relations import relations
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.algebra.proofs.written import Written
from gcrules.algebra.spelling import normal
from gcrules.core.errors import EngineFault, LimitReached
from gcrules.mechanisms.proofs import proof_file
from gcrules.rules.script import run_script

ORDER = {n: i for i, n in enumerate("abcdef")}
EXCHANGE = "[abc][ade] - [abd][ace] == -[abe][acd]"


def proved(equation: str, rank: int = 4, given: str = "") -> Theorem:
    assumptions = parse_assumption(given, Context(rank=rank)).given if given else ()
    return theorem("claim", *parse_equation(equation, rank=rank), rank=rank, given=assumptions)


def test_what_is_not_zero_has_no_relations() -> None:
    assert relations(expand(parse("[abc][ade] - [abd][ace]", rank=3)).terms) is None
    assert relations({}) == ()


def test_brackets_that_divide_make_no_proof_longer() -> None:
    times = "[p1 p5 p9] [p2 p6 a] [b p3 p7] [p4 p8 p1] [p5 p2 c]"
    found = proved(f"{times} ([abc][ade] - [abd][ace]) == -{times} [abe][acd]", 3)
    assert found.size == proved(EXCHANGE, 3).size
    assert all(list(m) == sorted(m) for r in found.relations for m in r.multiplier), "as scripts of Coq read them"


def test_a_proof_that_is_too_long_is_refused() -> None:
    terms = expand(parse("[abc][def] - [dbc][aef] - [adc][bef] - [abd][cef]", rank=3)).terms
    with pytest.raises(LimitReached, match="the proof takes more than 0 exchanges"):
        relations(terms, limit=0)


def test_sides_that_are_not_equal_are_a_fault_and_not_left_out() -> None:
    """Whoever asks for a proof has said that they are."""
    with pytest.raises(EngineFault, match="the sides are not equal"):
        proved("[abc] == [acb]", 3)
    claimed = replace(gc.prove("[abc] == [bca]", rank=3), right=parse("[acb]", rank=3))
    with pytest.raises(EngineFault, match="the sides are not equal"):
        gc.proof_file(claimed)


def test_points_under_assumptions_say_why_they_are_where_they_are() -> None:
    found = proved("[acd] == 0", 3, "[abc] == 0, [abd] == 0")
    assert {p.name for p in found.placed}.isdisjoint(found.order)
    assert all(flat.because for p in found.placed for flat in p.flats)
    assert [str(e) for e in found.nonzero] == ["ab"]


def test_points_that_are_said_to_be_equal_say_why() -> None:
    (point,) = proved("[abp] == 0", 3, r"2 p == ab /\ cd").placed
    assert point.equal is not None
    assert (point.name, str(point.within), point.flats) == ("p", r"1/2 * (ab /\ cd)", ())
    assert (point.equal.index, point.equal.number, point.equal.relations) == (0, Fraction(1, 2), ())


CASES = [
    ("[abc][abd] == 0", 3, "[abc]**2 [abd]**3 == 0", ["[abc]", "[abd]"]),
    ("[abd][ace] == 0", 3, "[abe][acd] == [abc][aed]", ["[abd]", "[ace]"]),
    ("[abcf][abde] == 0", 4, "[abcd][abef] == [abce][abdf]", ["[abcf]", "[abde]"]),
    ("[bdf][bcf] == 0", 3, "[dbf][cbf] == [eca][bde], incident(e, ca), collinear(a, d, f)", ["[bcf]", "[bdf]"]),
    ("[abd] == 0", 3, "collinear(c, d, e), incident(a, be), [bed][bac] == -[bea][bdc]", ["[abc]", "[bde]"]),
]


@pytest.mark.parametrize(("claim", "rank", "given", "factors"), CASES)
def test_each_factor_of_what_vanishes_is_a_case(claim: str, rank: int, given: str, factors: list[str]) -> None:
    found = proved(claim, rank, given)
    product_is_given, *cases = found.cases
    assert (found.relations, found.placed) == ((), ())
    assert {*product_is_given.given} <= {*found.given}
    assert sorted(str(normal(case.given[-1], ORDER, rank).expr) for case in cases) == factors
    assert all(case.given[:-1] == found.given for case in cases)
    assert all((case.left, case.right) == (found.left, found.right) for case in cases)


def test_parts_that_occur_again_are_written_once() -> None:
    meet = parse(r"ab /\ cde")
    written = Written([meet, parse(r"(ab /\ cde) f")])
    assert written.of(parse(r"(ab /\ cde) f")) == ["join", "#1", "f"]
    assert written.of(meet) == "#1"
    assert written.definitions == [["#1", ["meet", ["join", "a", "b"], ["join", "c", "d", "e"]]]]


def test_the_digest_is_that_of_the_theorems() -> None:
    one = proved(EXCHANGE, 3)
    file, other = ProofFile("a", (one,)), ProofFile("b", (one,), (LeftOut("more", "it was not asked for"),))
    assert file.digest == other.digest != ProofFile("a", (one, one)).digest
    assert json.loads(other.json_text()) == other.to_json()


SCHEMA = json.loads((ROOT / "docs" / "assets" / "proof.schema.json").read_text(encoding="utf-8"))


def check_fields(value: Any, schema: dict[str, Any]) -> None:
    """Objects have the fields that the schema names, down to the last of them."""
    schema = SCHEMA["$defs"][schema["$ref"].rpartition("/")[2]] if "$ref" in schema else schema
    if isinstance(value, dict):
        assert {*schema["required"]} <= value.keys() <= schema["properties"].keys()
        for key, one in value.items():
            check_fields(one, schema["properties"][key])
    elif isinstance(value, list):
        first = schema.get("prefixItems", [])
        for n, one in enumerate(value):
            check_fields(one, first[n] if n < len(first) else schema.get("items", {}))


PLANES = r"abe /\ acd /\ bdf == 0"


def nested(t: Theorem) -> Iterator[Theorem]:
    """A theorem and all of its cases."""
    yield t
    for case in t.cases:
        yield from nested(case)


def test_what_vanishes_or_not_is_a_case_each() -> None:
    split, *_ = [t for t in nested(proved("[abde][abdf] == 0", 4, PLANES)) if t.split is not None]
    vanishing, other = split.cases
    assert (vanishing.given, vanishing.nonzero) == ((*split.given, split.split), split.nonzero)
    assert (other.given, other.nonzero) == (split.given, (*split.nonzero, split.split))


@pytest.mark.parametrize(
    ("equation", "given", "factors"),
    [
        ("[abdf] == 0", r"abf /\ adf == 0", ["[abdf]", "af"]),
        ("[abde][abce] == 0", "concurrent(ab, ac, de)", ["ade"]),
        ("[abce][abdf] == 0", "concurrent(bf, ae, ab)", ["abe", "abf"]),
    ],
)
def test_meets_that_are_zero_are_taken_apart(equation: str, given: str, factors: list[str]) -> None:
    """What stands for all points is no part of a case."""
    found = proved(equation, 4, given)
    assert sorted(str(normal(case.given[-1], ORDER, 4).expr) for case in found.cases[1:]) == factors
    assert all({*points_of(case.given[-1])} <= {*"abcdef"} for case in found.cases[1:])


def test_files_have_the_fields_of_the_published_schema() -> None:
    conic = "[abc][ade][bdf][cef] == [abd][ace][bcf][def]"
    placed = proved("[abq] [cdf] == 0", 3, f"{conic}, incident(q, ab)")
    theorems = proved(EXCHANGE, 3), placed, proved("[abde][abdf] == 0", 4, PLANES)
    file = ProofFile("two", theorems, (LeftOut("more", "it was not asked for"),))
    check_fields(file.to_json(), SCHEMA)
    assert {*SCHEMA["$defs"]["theorem"]["properties"]} == {
        key for t in (placed, *nested(theorems[2])) for key in t.to_json()
    }


def test_absences_have_the_fields_of_the_published_schema() -> None:
    answers = gc.factor("[[Aa,Bb,Cc,Dd,Ee,Ff]]"), gc.factor("[[Aa,Ab,Ba,Bb,Cc,Dd]]"), gc.shorten("[abcd][efgh]")
    for answer in (*answers, gc.shorten("[[Aa,Ab,Ba,Cc,Dd,Ee]]"), gc.shorten("[[Aa,Bb,Cc,Dd,Ee,Ff]]")):
        file = gc.proof_file(answer)
        (absence,) = file.to_json()["absences"]
        check_fields(absence, SCHEMA["$defs"]["absence"])
        assert json.loads(file.json_text()) == file.to_json()
        assert file.digest == ProofFile("a", file.theorems).digest


def test_what_a_script_says_without_a_proof_is_named() -> None:
    script = parse_script("rank 3 claim [abc] == [bca] claim [abc] == [acb] rule wrong: [abc] => [acb]")
    file = proof_file(run_script(script))
    assert [t.name for t in file.theorems] == ["line 1: [abc] == [bca]"]
    assert [one.reason for one in file.left_out] == ["it is refuted"] * 2
    assert file.left_out[1].name == "line 1: rule wrong"
