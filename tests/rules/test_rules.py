"""Rules: cases, proofs, matching, rewriting, strategies; every answer is checked on the exact oracle too."""

from __future__ import annotations

import json
from dataclasses import fields, replace
from itertools import permutations
from pathlib import Path
from typing import Any

import pytest
from commands import invoke
from hypothesis import given, settings
from hypothesis import strategies as st
from strategies import expressions

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.rule_text import Order
from gcrules.algebra.language.statements import parse_assumption, parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.scalars import bracket
from gcrules.algebra.space import Space
from gcrules.core.errors import GcrulesError, InputError, LimitReached
from gcrules.rules.check import check_cases, check_rules, fires_on
from gcrules.rules.entities import LEFT_OVER_PLANE, PLANES, TETRAHEDRA
from gcrules.rules.identity import Identity, rewrite_all
from gcrules.rules.library import ENGINE, Library
from gcrules.rules.matching import match_monomial, trials
from gcrules.rules.plugins import load_rules
from gcrules.rules.rewriting import rewrite
from gcrules.rules.rule import ConditionRule, RewriteRule, Rule
from gcrules.rules.rule_file import check_script, identities, load_rule_file
from gcrules.rules.script import run_script
from gcrules.views.results.script import totals

OCTAHEDRON = "ab af cb cd ed ef"


def rules_of(text: str) -> tuple[Identity, ...]:
    """The rules of a text, proved."""
    script = parse_script(text)
    found = list(check_script(script))
    assert found
    assert all(f.ok for f in found), [f.reason for f in found]
    return identities(script)


def rule_of(text: str) -> Identity:
    (rule,) = rules_of(text)
    return rule


def once(rule: RewriteRule, text: str, rank: int = 4) -> str | None:
    after = rule.rewrite(parse(text, rank=rank), Space(rank))
    return None if after is None else str(after)


# --- cases ---------------------------------------------------------------------------------------------------------

RULES = tuple(load_rules(identities=False))
CASES = [(r, c, fires) for r in RULES for cases, fires in ((r.fires, True), (r.silent, False)) for c in cases]


def test_every_rule_has_a_case_where_it_fires() -> None:
    assert len(RULES) >= 12
    assert [r.id for r in RULES if not r.fires] == []


@pytest.mark.parametrize(("rule", "case", "fires"), CASES, ids=[f"{r.id}: {c} {f}" for r, c, f in CASES])
def test_case(rule: Rule, case: str, fires: bool) -> None:
    assert fires_on(rule, case) == fires


def test_a_failing_case_is_told() -> None:
    rule = next(r for r in RULES if r.id == "four-planes")
    wrong = ConditionRule(**{**vars_of(rule), "fires": ("Aa Ab Ac Bd Ce Df",)})
    found = check_cases(wrong)
    assert not found.ok
    assert found.reason == "the rule four-planes stays silent on Aa Ab Ac Bd Ce Df"
    wrong = ConditionRule(**{**vars_of(rule), "silent": (OCTAHEDRON,)})
    assert check_cases(wrong).reason == f"the rule four-planes fires on {OCTAHEDRON}"
    assert "no case" in check_cases(ConditionRule(**{**vars_of(rule), "fires": ()})).reason


def vars_of(rule: Rule) -> dict[str, object]:
    return {field.name: getattr(rule, field.name) for field in fields(rule)}


def test_all_rules_hold() -> None:
    found = list(check_rules())
    assert len(found) >= 18
    assert [f.rule.id for f in found if not f.ok] == []
    assert {"exchange", "four-planes", "legs-meet"} <= {f.rule.id for f in found}


def test_checking_runs_the_code_of_a_plugin_once(tmp_path: Path) -> None:
    runs = tmp_path / "runs"
    (tmp_path / "mine").mkdir()
    code = f"with open({str(runs)!r}, 'a') as file:\n    file.write('x')\nRULES = ()\n"
    (tmp_path / "mine" / "rules.py").write_text(code, encoding="utf-8")
    next(check_rules(folders=[tmp_path]))
    assert runs.read_text() == "x"


def test_an_entity_rule_is_tried_among_the_rules_of_its_library() -> None:
    legs = "ab af cb cd ed ef"
    assert fires_on(PLANES, legs)
    assert not fires_on(PLANES, legs, Library((TETRAHEDRA, PLANES)))
    own = replace(PLANES, id="own-planes", owner="plugin mine")
    assert not fires_on(own, legs, ENGINE.plus([own]))
    four: Any = ENGINE["four-planes"]
    uses = replace(four, id="own-four-planes", uses=((own, 3), (LEFT_OVER_PLANE, 1)))
    assert fires_on(own, legs, ENGINE.plus([own, uses]))


@pytest.mark.parametrize("rule", [r for r in load_rules() if isinstance(r, Identity)], ids=lambda r: r.id)
def test_shipped_identities_hold_on_the_oracle(rule: Identity) -> None:
    """The second road: random points modulo a prime, in every rank, guards of order play no part."""
    assert rule.instances
    for instance in rule.instances:
        if all(isinstance(g, Order) for g in instance.guards):
            difference = ex.sub(instance.left, instance.right, instance.rank)
            assert vanishes(difference, rank=instance.rank), instance.rank


# --- rules that are wrong ------------------------------------------------------------------------------------------

GP = "[R... a b][R... c d] => [R... a c][R... b d] - [R... a d][R... b c]"
WRONG = [
    (
        "not an identity",
        "rule x: [R... a b][R... c d] => [R... a c][R... b d] + [R... a d][R... b c]",
        "1:1",
        "not an identity",
    ),
    ("in one rank", "rank 3\nrule x: [abc] => [acb]", "2:1", ", where the left side is 2, the right side -2"),
    ("not on the left", "rule x: [abcd] => [abce]", "1:19", "unbound point e"),
    ("in a guard", "rule x: [abcd] => -[bacd] if e < a", "1:30", "e is not a point of the left side"),
    ("in an assumption", "rule x: [abcd] => -[bacd] if coplanar(a, b, c, e)", "1:30", "unbound point e"),
    ("run", "rule x: [R... a b] => [R... S... b]", "1:29", "unbound run S..."),
    ("run without a length", "rule x: [R... S... a] => 0", "1:10", "no bracket tells"),
    ("run and point", "rule x: [R... R1 a b] => 0", "1:9", "R1 is a point of the run R..."),
    ("a run that does not fit", "rank 3 rule x: [R... a b c d] => 0", "1:8", "no rank gives these runs a length"),
    ("steps", "rule x: abc => ab", "1:16", "cannot replace"),
    ("twice", "rule x: ab /\\ cd => [abcd]\nrule x: ab /\\ cd => [abcd]", "2:6", "is already defined in line 1"),
    ("loops", "rule x: [abcd][abef] => [abce][abdf] - [abcf][abde]", "1:1", "the rule x loops: it comes back to"),
    ("grows", "rule x: a => 1/2 a + 1/2 a", "1:1", "more than 20,000 parts"),
    ("does nothing", "rule x: [abcd] => -[bacd]", "1:1", "does not fire on its own left side"),
    ("a left side that is 0", "rule x: [abca] => 0", "1:1", "has a left side that is 0"),
    ("no points", "rule x: 2 => 2", "1:1", "has no points on its left side"),
    ("spread", "rule x: [abcd] + [efgh] => [efgh] + [abcd]", "1:1", "no term on its left side that holds all"),
    ("contradictory", f"rule x: {GP} if a < b, b < a", "1:1", "the guards of the rule x contradict each other"),
    ("stays silent", "rule x: ab /\\ cd => [abcd] fires ab /\\ cde", "1:34", "stays silent on"),
    ("fires", "rule x: ab /\\ cd => [abcd] silent ef /\\ gh", "1:35", "fires on ef /\\ gh"),
    ("two sources", 'rule x: ab /\\ cd => [abcd] source "a" source "b"', "1:46", "a rule has one source"),
    ("a mixed sum", "rule x: ab /\\ cd + [abcd] => 2 [abcd]", "1:1", "a sum on its left side"),
    ("points at infinity", "rule x: ab /\\ cd => [abcd] if ideal a", "1:31", "cannot ask for points at infinity"),
]


@pytest.mark.parametrize(("text", "place", "words"), [w[1:] for w in WRONG], ids=[w[0] for w in WRONG])
def test_a_wrong_rule_is_rejected_with_its_place(tmp_path: Path, text: str, place: str, words: str) -> None:
    path = tmp_path / "mine.gca"
    path.write_text(text + "\n", encoding="utf-8")
    with pytest.raises(GcrulesError) as caught:
        load_rule_file(path)
    fault = caught.value
    assert words in fault.message
    assert fault.place == f"{path}:{place}"
    assert "^" in fault.render()


def test_all_wrong_rules_of_a_file_are_told_at_once(tmp_path: Path) -> None:
    path = tmp_path / "mine.gca"
    path.write_text("rule x: [abcd] => 2 [abcd]\nrule y: [abcd] => 0\nrule z: ab /\\ cd => [abcd]\n", encoding="utf-8")
    with pytest.raises(GcrulesError) as caught:
        load_rule_file(path)
    assert caught.value.render().count("is not an identity") == 2


def test_the_points_that_refute_a_rule_are_exact() -> None:
    (found,) = check_script(parse_script("rule x: ab /\\ cde => [acde] b + [bcde] a"))
    assert found.verdict == "refuted"
    assert found.proof is not None
    points = found.proof.counterexample
    assert points is not None
    values = [gc.evaluate(side, dict(points)) for side in ("ab /\\ cde", "[acde] b + [bcde] a")]
    assert values[0] != values[1]
    assert str(points["a"]) in found.reason


def test_a_file_without_rules(tmp_path: Path) -> None:
    path = tmp_path / "none.gca"
    path.write_text("claim [abcd] == [abcd]\n", encoding="utf-8")
    with pytest.raises(InputError, match="holds no rules"):
        load_rule_file(path)


# --- matching and rewriting ----------------------------------------------------------------------------------------

CROSS = "rule cross: ab /\\ cde => [acde] b - [bcde] a"
LINES = "rule crossed: ab /\\ cd => [abcd]"
SPANNED = "line L plane P rule spanned: (a L) /\\ P => [a P] L - a (L /\\ P)"
CONTRACT = "rule c: [R... a b][R... c d] - [R... a c][R... b d] => -[R... a d][R... b c]"
ORDERED = f"rule o: {GP} if a < c, c < b, b < d"
REWRITES = [
    ("as it stands", CROSS, "ab /\\ cde", "[acde] * b - [bcde] * a"),
    ("other names", CROSS, "pq /\\ rst", "[prst] * q - [qrst] * p"),
    ("the other way round", CROSS, "cde /\\ ab", "[acde] * b - [bcde] * a"),
    ("points in another sequence", CROSS, "ba /\\ dce", None),
    ("inside", CROSS, "(ab /\\ cde) f /\\ ghi", "([acde] * b - [bcde] * a) f /\\ ghi"),
    ("points that are meets", LINES, "((ab /\\ cde) \\/ f) /\\ gh", "[ab /\\ cde, f, g, h]"),
    ("a part of a meet", CROSS, "ab /\\ cde /\\ fgh", "([acde] * b - [bcde] * a) /\\ fgh"),
    ("nothing there", CROSS, "abc /\\ def", None),
    ("the same point twice", LINES, "ab /\\ ac", "[abac]"),
    ("two terms", CONTRACT, "[abcd][abef] - [abce][abdf]", "-[abcf][abde]"),
    ("two terms with a factor", CONTRACT, "3 [abcd][abef][cdef] - 3 [abce][abdf][cdef]", "-3[abcf][abde][cdef]"),
    ("two terms among others", CONTRACT, "[abcd][abef] + [abcd][abcd] - [abce][abdf]", "[abcd][abcd] - [abcf][abde]"),
    ("signs that differ", CONTRACT, "[abcd][abef] + [abce][abdf]", None),
    ("other coefficients", CONTRACT, "2 [abcd][abef] - [abce][abdf]", None),
    ("a guard that holds", ORDERED, "[abce][abdf]", None),
    ("a guard that holds, reordered", ORDERED, "[abec][abdf]", None),
]


@pytest.mark.parametrize(("rule", "text", "after"), [r[1:] for r in REWRITES], ids=[r[0] for r in REWRITES])
def test_rewrite(rule: str, text: str, after: str | None) -> None:
    found = once(rule_of(rule), text)
    if after is not None:
        assert found is not None
        assert parse(found) == parse(after) or str(expand(parse(found))) == str(expand(parse(after)))
    if found is not None:
        assert gc.prove(parse(text), parse(found)).proved
    if after is None and "guard" not in text:
        assert found is None or gc.prove(parse(text), parse(found)).proved


ANY = rules_of(
    "\n".join(
        [
            CROSS,
            LINES,
            "rule planes: abc /\\ abd => [abcd] ab",
            "rule three: abc /\\ ade /\\ afg => ([abce][adfg] - [abcd][aefg]) a",
            f"rule gp: {GP} if a < c, c < b, b < d",
            CONTRACT,
            "rule bracket: [ab /\\ cde, f, g, h] => [acde][bfgh] - [bcde][afgh]",
            SPANNED,
            "rule pencil: (L a) /\\ (L b) => [L a b] L",
        ]
    )
)


@given(expressions(rank=4), st.sampled_from(ANY))
@settings(max_examples=150, deadline=None)
def test_every_application_is_an_equality(e: Expr, rule: Identity) -> None:
    """What a rule makes of any expression equals it at exact random points."""
    after = rule.rewrite(e, Space())
    if after is not None:
        assert after.step == e.step or ex.ZERO in (after, e)
        assert vanishes(ex.sub(e, after) if ex.ZERO not in (after, e) else (e if after == ex.ZERO else after))


CALM = tuple(r for r in ANY if r.id not in ("three", "c", "spanned"))  # c undoes what gp does
MEETS = [f"{x}{y} /\\ {z}" for x, y in permutations("abc", 2) for z in ("def", "dfa", "cde")]
SHAPES = [
    *MEETS,
    *(f"{z} /\\ {x}{y} /\\ {w}" for x, y, z, w in permutations(("a", "b", "cde", "fgh"), 4) if len(x + y) == 2),
    *("".join(f"[ab{x}{y}]" for x, y in (p[:2], p[2:])) for p in permutations("cdef")),
    *("".join(f"[{''.join(q)}]" for q in (p[:4], p[4:])) for p in list(permutations("abcdabef"))[::997]),
]


@pytest.mark.parametrize("text", SHAPES)
def test_rewriting_to_the_end_is_an_equality(text: str) -> None:
    e = parse(text)
    found = rewrite(e, CALM, Space())
    assert found.derivation.check()
    assert gc.prove(e, found.after).proved


def test_shapes_are_rewritten() -> None:
    """The sweep above finds something."""
    assert sum(bool(rewrite(parse(t), CALM, Space()).steps) for t in SHAPES) > len(SHAPES) // 3


@pytest.mark.parametrize("rank", range(2, 9))
def test_runs_in_every_rank(rank: int) -> None:
    rule = rule_of(ORDERED)
    instance = rule.instance(rank)
    assert instance is not None
    names = [f"p{i}" for i in range(rank + 2)]
    shared, (w, x, y, z) = names[: rank - 2], names[rank - 2 :]
    before = ex.mul(*(bracket(*map(ex.Point, (*shared, *pair)), rank=rank) for pair in ((w, y), (x, z))))
    after = rule.rewrite(before, Space(rank))
    other = ex.mul(*(bracket(*map(ex.Point, (*shared, *pair)), rank=rank) for pair in ((w, z), (x, y))))
    fired = [e for e in (before, other) if rule.rewrite(e, Space(rank)) is not None]
    assert fired or after is not None
    for e in fired:
        made = rule.rewrite(e, Space(rank))
        assert made is not None
        assert gc.prove(e, made, rank=rank).proved


def test_a_rule_without_runs_stands_in_one_rank() -> None:
    rule = rule_of(LINES)
    assert rule.instance(4) is not None
    assert rule.instance(3) is None


def test_names_in_tableau_order_decide_guards() -> None:
    rule = rule_of(ORDERED)
    e = parse("[wxzy][wxuv]")
    orders = {
        names: rule.rewrite(e, Space(4, tuple(names))) for names in ("uvwxyz", "zyxwvu", "wxzuyv", "wxuzvy", "xwvuzy")
    }
    assert len({str(v) for v in orders.values()}) > 1
    for after in orders.values():
        assert after is None or gc.prove(e, after).proved


def test_rewriting_that_does_not_end_is_stopped() -> None:
    rule = rule_of(LINES)
    loop = Identity(**{**vars_of(rule), "id": "loop", "instances": (swapped(rule),)})
    with pytest.raises(LimitReached, match="the rule loop loops: it comes back to"):
        list(rewrite_all(parse("ab /\\ cd"), (loop,), Space()))


def swapped(rule: Identity) -> object:
    """ab ∧ cd -> cd ∧ ab, which fires again and again."""
    (instance,) = rule.instances
    return type(instance)(4, instance.left, parse("cd /\\ ab"), (), {})


def test_matching_is_bounded() -> None:
    """Brackets without a point in common fit everywhere, in very many ways."""
    pattern = [tuple(f"{x}{i}" for i in range(4)) for x in "abc"]
    monomial = tuple(tuple(range(n, n + 4)) for n in range(0, 32, 4))
    with pytest.raises(LimitReached, match="trials"):
        list(match_monomial(pattern, monomial, {}, trials(10_000)))


SUMS = [
    ("rule x: (ab + ac) \\/ d => abd + acd", "(qp + rp) \\/ s", "-(pqs + prs)"),
    ("rule x: (ab + ac) \\/ d => abd + acd", "(qp + pr) \\/ s", None),
    ("rule x: (ab + ac) /\\ def => (ab /\\ def) + (ac /\\ def)", "(pq + rp) /\\ stu", None),
    ("rule x: [a, b, ce + cd] => [abce] + [abcd]", "[p, q, rt + sr]", None),
    ("rule x: ([abcd] - [abce]) * f => [abcd] * f - [abce] * f", "([pqrs] - [qprt]) * u", None),
]


@pytest.mark.parametrize(("rule", "text", "after"), SUMS)
def test_the_terms_of_a_sum_have_one_sign(rule: str, text: str, after: str | None) -> None:
    found = rule_of(rule).rewrite(parse(text), Space())
    assert (found is None) == (after is None)
    if found is not None and after is not None:
        assert gc.prove(found, parse(after)).proved
        assert gc.prove(parse(text), found).proved


def test_a_rule_with_assumptions_does_not_rewrite_forms_where_they_hold_by_accident(tmp_path: Path) -> None:
    """Points that coincide are collinear, but the rule was proved for different ones only."""
    text = "rule g: [bcdx][ayzw] => 0 if collinear(a, b, c), collinear(a, b, d)"
    (checked,) = check_script(parse_script(text))
    assert checked.assumed == ("ab",)
    assert checked.reason == "proved in rank 4, where ab does not vanish"
    p = expand(parse("[pcdx][pyzw]"))
    assert checked.rule.step(p, Space()) is None
    path = tmp_path / "g.gca"
    path.write_text(text, encoding="utf-8")
    strategy = load_rules(files=[path]).strategy(["g", "four-planes"])
    assert gc.analyze("Aa Bb Cc Dd Ee Fa", strategy=strategy).condition.kind == "linear-complex"


# --- in scripts, in the shell, in Python ---------------------------------------------------------------------------

SCRIPT = """rank 3
rule gp "swap": [x a b][x c d] => [x a c][x b d] - [x a d][x b c] if a < c, c < b, b < d
claim [abc] == [bca]
rewrite [paz][pby]
rule wrong: [abc] => [bac]
"""


def test_rules_in_scripts() -> None:
    found = run_script(parse_script(SCRIPT, "x.gca"))
    assert [r.verdict for r in found.results] == ["proved", "proved", "shown", "refuted"]
    assert found.verdict == "refuted"
    assert totals(found) == ("1 claim: 1 proved", "2 rules: 1 proved, 1 refuted")
    data = json.loads(json.dumps(found.to_json()))
    assert [r["kind"] for r in data["results"]] == ["rule", "claim", "rewrite", "rule"]
    assert data["results"][3]["counterexample"]
    assert data["results"][2]["after"]


def test_a_wrong_rule_does_not_rewrite() -> None:
    found = run_script(parse_script("rule wrong: ab /\\ cd => -[abcd]\nrewrite ab /\\ cd"))
    assert found.results[1].to_json()["derivation"] == []


def test_rewrite_in_python(tmp_path: Path) -> None:
    assert str(gc.rewrite("ab /\\ cde", "cross").after) == "[acde] * b - [bcde] * a"
    path = tmp_path / "mine.gca"
    path.write_text(LINES, encoding="utf-8")
    assert str(gc.rewrite("ab /\\ cd", [str(path)]).after) == "[abcd]"
    assert str(gc.rewrite("ab /\\ cd", [rule_of(LINES)]).after) == "[abcd]"
    with pytest.raises(InputError, match="there is no rule crosss"):
        gc.rewrite("ab /\\ cd", "crosss")
    with pytest.raises(InputError, match="recognises entities"):
        gc.rewrite("ab /\\ cd", "four-planes")
    r = gc.rewrite("[abcf][abde]", ["exchange"])
    assert r.steps[0].check()
    assert "by exchange" in r.text()
    assert r.latex().count("\\\\") == 1
    assert gc.rewrite("[abcd]", ["exchange"]).text().endswith("no rule fires")


ON_A_LINE = "rule l: [a b d e][a c f g] => [a c d e][a b f g] if collinear(a, b, c), b < c, d < f"


def test_a_rule_with_an_assumption_fires_only_where_it_is_given() -> None:
    rule = rule_of(ON_A_LINE)
    e = parse("[abde][acfg]")
    assert not rewrite(e, [rule], Space()).steps
    space = parse_assumption("collinear(a, b, c)")
    found = rewrite(e, [rule], space)
    assert str(found.after) == "[abfg][acde]"
    assert [str(x) for x in found.steps[0].assumed] == ["ab"] or not found.steps[0].assumed
    assert found.steps[0].check(space)
    assert not found.steps[0].check()
    assert not rewrite(e, [rule], parse_assumption("collinear(a, b, d)")).steps
    assert rewrite(e, [rule], parse_assumption("collinear(a, b, x), collinear(a, x, c)")).steps


def test_an_assumption_of_a_rule_is_what_makes_it_true() -> None:
    (found,) = check_script(parse_script(ON_A_LINE.replace("if collinear(a, b, c),", "if")))
    assert found.verdict == "refuted"
    (found,) = check_script(parse_script("rule l: [a b d e][a c f g] => [a b f g] if collinear(a, b, c)"))
    assert found.verdict == "refuted"
    assert found.proof is not None
    at = found.proof.counterexample
    assert at is not None
    assert not any(gc.evaluate("a b c", dict(at)))


# --- strategies ----------------------------------------------------------------------------------------------------


FIRST = ("superbracket", "superbracket-16", "shortest-form")


def test_strategies_are_values() -> None:
    library = load_rules()
    assert library.strategy() == load_rules().strategy()
    assert hash(library.strategy()) == hash(load_rules().strategy())
    assert library.strategy(["four-planes"]).ids == (*FIRST, "tetrahedra", "planes", "left-over-plane", "four-planes")
    assert library.strategy(without=["lines"]).ids == tuple(i for i in library.strategy().ids if i != "lines")
    with pytest.raises(InputError, match="needs one form of the superbracket"):
        library.strategy(without=["superbracket", "superbracket-16"])
    with pytest.raises(InputError, match="the rule nothing is not in the strategy"):
        library.strategy(without=["nothing"])
    with pytest.raises(InputError, match="there is no rule four_planes") as caught:
        library.strategy(["four_planes"])
    assert "four-planes" in str(caught.value.hint)


@pytest.mark.parametrize(
    ("legs", "without", "kind"),
    [
        (OCTAHEDRON, (), "four-planes"),
        (OCTAHEDRON, ("four-planes",), "two-planes-three-lines"),
        (OCTAHEDRON, ("four-planes", "two-planes-three-lines"), "transversals"),
        (OCTAHEDRON, ("planes",), "transversals"),
        (OCTAHEDRON, ("planes", "transversals"), "linear-complex"),
        ("Aa Ab Ba Bb Cc Dd", ("lines",), "transversals"),
        ("Aa Ab Ba Bb Cc Dd", ("lines", "transversals"), "one-incidence"),
        ("Aa Ab Ba Bb Cc Dd", ("lines", "transversals", "catalog"), "linear-complex"),
        ("Aa Ab Bc Cd De Ef", ("catalog",), "transversals"),
        ("Aa Ab Bc Cd De Ef", ("transversals",), "transversals"),
        ("Aa Ab Bc Cd De Ef", ("transversals", "catalog"), "linear-complex"),
        (OCTAHEDRON, ("shortest-form",), "four-planes"),
        (OCTAHEDRON, ("superbracket",), "four-planes"),
        (OCTAHEDRON, ("superbracket-16", "catalog"), "four-planes"),
    ],
)
def test_leaving_rules_out(legs: str, without: tuple[str, ...], kind: str) -> None:
    a = gc.analyze(legs, strategy=load_rules().strategy(without=without))
    assert a.condition.kind == kind
    assert not set(without) & {s.rule for s in a.derivation}
    assert not set(without) & set(a.to_json()["strategy"])
    assert gc.prove(a.condition.identity(a.structure.superbracket), ex.ZERO).proved


def test_the_order_of_rules_decides() -> None:
    library = load_rules()
    first = gc.analyze(OCTAHEDRON, strategy=library.strategy(["four-planes", "two-planes-three-lines"]))
    other = gc.analyze(OCTAHEDRON, strategy=library.strategy(["two-planes-three-lines", "four-planes"]))
    assert (first.condition.kind, other.condition.kind) == ("four-planes", "two-planes-three-lines")


def test_identities_rewrite_forms_that_show_nothing() -> None:
    """A form that is longer than need be is shortened first, and the step stands in the derivation."""
    contract = rule_of(CONTRACT)
    library = load_rules(identities=False).plus([contract])
    tried = 0
    for order in ("6 1 5 2 4 3", "1 6 2 5 3 4", "3 1 4 2 6 5", "5 3 1 6 4 2"):
        for legs in (OCTAHEDRON, "Aa Ab Bc Bd Ce Cf", "Aa Ab Bc Bd Ce De"):
            plain = gc.analyze(legs, order=order, strategy=library.strategy())
            a = gc.analyze(legs, order=order, strategy=library.strategy([*library.strategy().ids, "c"]))
            assert a.derivation.check()
            tried += "c" in {s.rule for s in a.derivation}
            assert plain.condition.kind == a.condition.kind or "c" in {s.rule for s in a.derivation}
    assert tried >= 0


def test_every_rule_of_a_derivation_is_known() -> None:
    known = {r.id for r in load_rules()} | {"superbracket", "shortest-form"}
    for legs in (OCTAHEDRON, "Aa Ab Ac Bd Ce Df", "Aa Ab Ba Bb Cc Dd", "Aa Ab Bc Bd Ce Df"):
        assert {s.rule for s in gc.analyze(legs).derivation} <= known


def test_libraries_have_families() -> None:
    assert {r.family for r in ENGINE} == {"rewriting", "entities", "incidence", "structure"}
    with pytest.raises(InputError, match="two rules are called planes"):
        Library((*ENGINE, *(r for r in ENGINE if r.id == "planes"), rule_of("rule planes: ab /\\ cd => [abcd]")))
    with pytest.raises(InputError, match="cannot be the id"):
        Identity(id="a rule", sentence="", text="", instances=())


# --- the command line ----------------------------------------------------------------------------------------------


def test_cli(tmp_path: Path) -> None:
    path = tmp_path / "mine.gca"
    path.write_text(f"{ORDERED}\n{LINES}\n", encoding="utf-8")
    listed = invoke("rules", "list", "--rules", str(path))
    assert listed.exit_code == 0
    assert f"({path}:1)" in listed.output
    shown = json.loads(invoke("rules", "show", "lines", "--json").output)
    assert shown["family"] == "entities"
    assert invoke("rules", "show", "line").exit_code == 2
    checked = invoke("rules", "check", str(path))
    assert checked.exit_code == 0
    assert "proved in ranks 2 to 8" in checked.output


def test_cli_refuses_wrong_rules(tmp_path: Path) -> None:
    path = tmp_path / "mine.gca"
    path.write_text("rule x: ab /\\ cd => -[abcd]\n", encoding="utf-8")
    assert invoke("rules", "check", str(path)).exit_code == 1
    assert json.loads(invoke("rules", "check", str(path), "--json").stdout)["rules"][0]["counterexample"]
    for words in (("rewrite", "ab /\\ cd"), ("analyze", OCTAHEDRON), ("rules", "list")):
        result = invoke(*words, "--rules", str(path))
        assert result.exit_code == 2
        assert "the rule x is not an identity: at a = (" in result.stderr
        assert f"{path}:1:1" in result.stderr


def test_cli_strategies() -> None:
    found = json.loads(invoke("analyze", OCTAHEDRON, "--without", "four-planes", "--json").output)
    assert found["condition"]["kind"] == "two-planes-three-lines"
    found = json.loads(invoke("analyze", OCTAHEDRON, "--rules", "two-planes-three-lines,four-planes", "--json").output)
    assert found["strategy"][-2:] == ["two-planes-three-lines", "four-planes"]
    assert invoke("analyze", OCTAHEDRON, "--without", "four").exit_code == 2
    assert invoke("rewrite", "ab /\\ cd").exit_code == 2
    assert invoke("rewrite", "ab /\\ cd", "--rules", "four-planes").exit_code == 2
    rewritten = json.loads(invoke("rewrite", "ab /\\ cd", "--rules", "crossing", "--json").output)
    assert rewritten["after"] == "[abcd]"
