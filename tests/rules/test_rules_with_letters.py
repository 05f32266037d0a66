"""Rules with letters for lines, planes and hyperplanes; every answer is checked on the exact oracle too."""

from __future__ import annotations

import pytest
from faults import refused
from rules.test_rules import SPANNED, once, rule_of

import gcrules as gc
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.rules.rule_file import check_script

PENCIL = "line L rule pencil: (L a) /\\ (L b) => [L a b] L"
AXIS = "line L rule axis: [a b L][c d L] - [a c L][b d L] => -[a d L][b c L]"
BUNDLE = "rank 3 line L M N rule bundle: (L /\\ M) (L /\\ N) => (L /\\ M /\\ N) L"
HYPERPLANES = "rank 5 hyperplane H line L rule pierced: (a L) /\\ H => -a (L /\\ H) + [a H] L"


@pytest.mark.parametrize(
    ("rule", "rank", "text", "after"),
    [
        (SPANNED, 4, "pqr /\\ stu", "[pstu] * q r - p (q r /\\ stu)"),
        (SPANNED, 4, "(p (cde /\\ fgh)) /\\ stu", "[pstu] * (cde /\\ fgh) - p (cde /\\ fgh /\\ stu)"),
        (SPANNED, 4, "pq /\\ stu", None),
        (SPANNED, 4, "(p (qr + st)) /\\ (s (uv + tw))", None),
        (PENCIL, 4, "pqr /\\ pqs", "[pqrs] * p q"),
        (PENCIL, 4, "rpq /\\ psq", "-[rpqs] * p q"),
        (PENCIL, 4, "((cde /\\ fgh) r) /\\ ((cde /\\ fgh) s)", "[cde /\\ fgh, r, s] * (cde /\\ fgh)"),
        (PENCIL, 4, "pqr /\\ stu", None),
        (AXIS, 4, "[abpq][cdpq] - [acpq][bdpq]", "-[adpq][bcpq]"),
        (AXIS, 4, "[abpq][cdpq] - [acpq][bdps]", None),
        (HYPERPLANES, 5, "pqr /\\ abcd", "-p (qr /\\ abcd) + [pabcd] * qr"),
        (BUNDLE, 3, "(ab /\\ cd) (ab /\\ ef)", "(ab /\\ cd /\\ ef) * ab"),
    ],
)
def test_what_letters_stand_for(rule: str, rank: int, text: str, after: str | None) -> None:
    found = once(rule_of(rule), text, rank)
    if found is not None:
        assert gc.prove(parse(text, rank=rank), parse(found, rank=rank), rank=rank).proved
    assert (found is None) == (after is None)
    if after is not None and found is not None:
        assert gc.prove(parse(found, rank=rank), parse(after, rank=rank), rank=rank).proved


def test_letters_of_an_expression_stay_whole() -> None:
    done = gc.rewrite("(a M) /\\ (M b)", [rule_of(PENCIL)], letters="line M")
    assert done.steps
    assert done.after == parse("[M a b] M", context=parse_assumption("line M"))


def test_a_rule_with_letters_that_is_wrong_is_refuted() -> None:
    (found,) = check_script(parse_script(SPANNED.replace("] L -", "] L +")))
    assert (found.verdict, "not an identity" in found.reason) == ("refuted", True)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("line L M rule r: [L a b] => [M a b]", "unbound letter M"),
        ("screw S rule r: [S a b] => [a b S]", "S is a screw (step 2), and rules are about points, lines, planes"),
        ("rank 3 conic K rule r: conic(p, K) => 0", "K is a conic, and rules are about points, lines, planes"),
    ],
)
def test_faults_say_what_is_wrong(text: str, message: str) -> None:
    refused(text, message)
