"""Derivations: folded and in single steps, replayed on the exact oracle, reproduced by their rules, rendered."""

from __future__ import annotations

import json
import random
import re
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from platform_classes import CLASSES

import gcrules as gc
from gcrules.algebra import expr as ex
from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import ONE, mul, neg, sub
from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.language.statements import parse_assumption
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.scalars import bracket
from gcrules.algebra.space import Space
from gcrules.algebra.straightening.straighten import next_syzygy, straighten, straighten_steps
from gcrules.algebra.superbrackets.shortest import superbracket_form
from gcrules.apps.cli.legs import analyze as analyze_command
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import LimitReached
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.rules.derivation import Derivation, Step
from gcrules.rules.deriving import derived_zero, from_catalog
from gcrules.rules.elementary import ELEMENTARY
from gcrules.rules.library import ENGINE
from gcrules.rules.plugins import load_rules
from gcrules.rules.rule import ConditionRule, Elementary
from gcrules.rules.strategy import Strategy
from gcrules.rules.unfold import MAX_STEPS, follows, unfold
from gcrules.views.formulas.latex_text import latex_words

LEGS = {c["id"]: " ".join(c["legs"]) for c in CLASSES}
REGULAR = [c["id"] for c in CLASSES if c["regular"]]
OCTAHEDRON = "ab af cb cd ed ef"
RULES = {rule.id: rule for rule in ELEMENTARY}


def turned(class_id: str) -> list[str]:
    """The legs of a class in another order, some written the other way round."""
    rng = random.Random(class_id)
    legs = LEGS[class_id].split()
    rng.shuffle(legs)
    return [leg[::-1] if rng.random() < 0.5 else leg for leg in legs]


CASES: dict[str, dict[str, Any]] = {
    **{class_id: {"legs": legs} for class_id, legs in LEGS.items()},
    **{f"{class_id} turned": {"legs": turned(class_id)} for class_id in LEGS},
    **{f"{class_id} in an order": {"legs": LEGS[class_id], "order": "6 4 2 1 3 5"} for class_id in ("6-3.2", "4-4.7")},
    "octahedron": {"legs": OCTAHEDRON},
    "points at infinity": {"legs": "Aa Ab Bc Bd Ce Cf", "ideal": "A B C"},
    "couples": {"legs": "Aa Bb Cc ij jk ki", "ideal": "i j k a b c"},
    "always singular, terms left": {"legs": "ab bc ca de ef fd"},
    "zero by syzygies": {"legs": "ab gh dc ec ba cf"},
    "outside the catalog": {"legs": "ab ac ad bc bd cd"},
    "long names": {
        "legs": "left a, left b, right c, right d, middle e, middle top",
        "points": "left right middle top",
    },
}


@pytest.fixture(scope="module", params=CASES, ids=lambda name: name.replace(" ", "-"))
def analysis(request: pytest.FixtureRequest) -> Analysis:
    return analyze_legs(**CASES[request.param])


# --- from the superbracket to the condition ------------------------------------------------------------------------


def test_folded(analysis: Analysis) -> None:
    d = analysis.derivation
    condition = analysis.condition
    assert d.check()
    assert d.before == mul(condition.cofactor, analysis.structure.superbracket)
    if condition.kind != "linear-complex":
        assert d.after == condition.right_side
    assert d.assumed == (() if condition.cofactor == ONE else (condition.cofactor,))
    known = {rule.id for rule in load_rules()}
    assert {step.rule for step in d} <= known


def test_full(analysis: Analysis) -> None:
    """Single steps from the same beginning to the same end, each of them what its rule makes."""
    d = analysis.derivation
    full = analysis.unfolded()
    singles = d.full(analysis.strategy.rules)
    assert [s.after for s in full] == [s.after for s in d]
    assert [s for step in full for s in step.steps or (step,)] == list(singles)
    assert full.check()
    assert singles.check()
    assert (singles.before, singles.after, singles.assumed) == (d.before, d.after, d.assumed)
    for step in singles:
        assert step.rule in {rule.id for rule in ENGINE}
        assert step.rule not in ("shortest-form", "straightening")
        assert follows(step, singles.space, ENGINE), step
        assert step.before != step.after
    assert "Not shown" not in " ".join(step.why for step in full)
    assert singles.full() == singles


def test_full_derivations_are_short_and_need_few_syzygies() -> None:
    lengths = {i: len(analyze_legs(LEGS[i]).derivation.full()) for i in REGULAR}
    assert max(lengths.values()) <= 30
    syzygies = {i: sum(s.rule == "van-der-waerden" for s in analyze_legs(LEGS[i]).derivation.full()) for i in REGULAR}
    assert {i for i, n in syzygies.items() if n} <= {"3-3.3"}


def test_a_superbracket_that_is_zero_by_syzygies_alone() -> None:
    structure = read_legs("ab gh dc ec ba cf")
    typed = superbracket_form(structure.legs)
    assert typed.polynomial
    d = derived_zero(structure, typed, typed)
    assert [s.rule for s in d] == ["superbracket", "straightening"]
    full = d.full()
    assert full.after == ex.ZERO
    assert full.check()
    assert any(s.rule == "van-der-waerden" for s in full)
    assert all(follows(s, full.space, ELEMENTARY) for s in full)


def test_a_tampered_derivation_fails() -> None:
    full = analyze_legs("Aa Ab Bc Bd Ce Cf").derivation
    for d in (full, full.full()):
        assert len(d) > 4
        for n, step in enumerate(d):
            for wrong in (
                replace(step, after=neg(step.after)),
                replace(step, before=mul(ex.Number(2), step.before)),
                replace(step, after=ex.add(step.after, parse("[ABCa][ABCb][abcd]"))),
            ):
                tampered = replace(d, steps=(*d.steps[:n], wrong, *d.steps[n + 1 :]))
                assert not wrong.check(d.space)
                assert not tampered.check()
        assert not replace(d, steps=(d.steps[0], *d.steps[2:])).check()
    nested = full.unfolded()
    step = nested.steps[-1]
    assert step.check(nested.space)
    assert not replace(step, steps=step.steps[1:]).check(nested.space)
    assert not replace(step, steps=(*step.steps[:2], *step.steps[3:])).check(nested.space)


def test_a_step_that_no_rule_makes_is_noticed() -> None:
    d = analyze_legs(OCTAHEDRON).derivation.full()
    for step in d:
        assert not follows(replace(step, rule="factoring-out"), d.space, ELEMENTARY)
        assert not follows(replace(step, rule="unknown"), d.space, ELEMENTARY)


# --- the catalog, cofactors ----------------------------------------------------------------------------------------


LOOKED_UP = load_rules().strategy(without=["transversals"])


def test_readings_of_the_catalog() -> None:
    """cofactor · superbracket = coefficient · expression is what the rule `catalog` makes."""
    kinds = set()
    for class_id in REGULAR:
        for legs in (LEGS[class_id], turned(class_id)):
            a = analyze_legs(legs, strategy=LOOKED_UP)
            for reading in (a.condition, *a.readings):
                if reading.certificate.method != "catalog-instance":
                    continue
                d = from_catalog(a.structure, reading)
                assert d.check()
                assert d.assumed == (reading.cofactor,)
                assert (d.before, d.after) == (mul(reading.cofactor, a.structure.superbracket), reading.right_side)
                assert all(follows(step, d.space, ELEMENTARY) for step in d)
                kinds.add(reading.kind)
    assert kinds >= {"transversals", "one-incidence"}


def test_a_claim_with_a_cofactor() -> None:
    """A rule of the user's own that multiplies by a bracket: the whole chain is multiplied, and the bracket assumed."""
    rule = ConditionRule(
        id="twice",
        sentence="One more tetrahedron.",
        degree=0,
        expression=lambda s: mul(parse("[ABde]"), *(bracket(*map(ex.Point, s.named(r))) for r in s.tetrahedra)),
        cofactor=lambda s: parse("[ABde]"),
        statement="{expression}",
    )
    rules = ENGINE.strategy(["tetrahedra"]).rules
    a = analyze_legs("Aa Ab Ac Bd Be Cf", strategy=Strategy((*rules, rule)))
    assert str(a.condition.cofactor) == "[ABde]"
    assert a.derivation.check()
    assert a.derivation.full().check()
    assert a.derivation.before == mul(parse("[ABde]"), a.structure.superbracket)
    assert a.derivation.assumed == (parse("[ABde]"),)
    assert a.to_json()["derivation"][0]["assumed"] == ["[ABde]"]


def test_rechecked() -> None:
    a = analyze_legs(LEGS["5-5.1"], recheck=True, strategy=LOOKED_UP)
    assert [s.rule for s in a.derivation] == ["catalog"]
    assert "normal form" in a.derivation.steps[0].why


# --- unfolding -----------------------------------------------------------------------------------------------------


def unfolded(before: str, after: str, rule: str = "claim", **options: Any) -> list[str]:
    step = Step(rule, parse(before), parse(after), "")
    steps = unfold(step, **options)
    assert replace(step, steps=steps).check()
    assert all(follows(s, Space(), ELEMENTARY) for s in steps)
    return [("-" if s.upward else "") + s.rule for s in steps]


@pytest.mark.parametrize(
    ("before", "after", "rules"),
    [
        ("[bacd]", "-[abcd]", ["sorting"]),
        ("-[abcd]", "[bacd]", ["-sorting"]),
        (r"ab /\ cd", "[abcd]", ["expansion"]),
        (r"cde /\ ab", r"ab /\ cde", ["expansion", "-sorting", "-expansion"]),
        ("[.a b c d][.e f g h]", "[abcd][efgh] + [bcde][afgh]", ["dots", "sorting"]),
        ("([abcd] - [abce])**2", "[abcd][abcd] - 2[abcd][abce] + [abce][abce]", ["multiplying-out", "sorting"]),
        ("[abch][defg]", "-[abcd][efgh] + [abce][dfgh] - [abcf][degh] + [abcg][defh]", ["van-der-waerden"]),
    ],
)
def test_unfold(before: str, after: str, rules: list[str]) -> None:
    found = unfolded(before, after)
    assert [r for r in found if r.lstrip("-") not in ("sorting", "vanishing")] == [
        r for r in rules if r.lstrip("-") not in ("sorting", "vanishing")
    ]


@pytest.mark.parametrize("e", [r"ab /\ cde", r"abc /\ def /\ ghi", r"(ab /\ cde) \/ f", "[ab /\\ cde, f, g, h]"])
def test_any_expression_meets_its_expansion(e: str) -> None:
    assert unfolded(e, str(gc.expand(e)))


def test_limits() -> None:
    step = analyze_legs(OCTAHEDRON).derivation.steps[-1]
    with pytest.raises(LimitReached, match="more than 3 single steps"):
        unfold(step, limit=3)
    with pytest.raises(LimitReached):
        unfold(Step("claim", parse("[abcd]"), parse("[abce]"), "false"))
    many = parse(" ".join(f"([a{i}bcd] + [e{i}bcd] + [f{i}bcd])" for i in range(8)))
    d = Derivation((Step("claim", many, gc.expand(many).to_expr(), "a long one"),))
    assert d.check()
    (left,) = d.full()
    assert left.why.startswith("a long one (Not shown in single steps: ")
    assert d.full().check()
    assert MAX_STEPS >= 100


def test_rules_of_others() -> None:
    """An identity of a plugin is applied one step at a time, if the derivation is told of it."""
    rule = next(r for r in load_rules() if r.id == "exchange")
    before = parse("[abcf][abde] + [efgl][efhk]")
    once = rule.rewrite(before, Space())  # type: ignore[attr-defined]
    assert once is not None
    step = Step(rule.id, before, once, "")
    assert unfold(step, rules=[rule]) == (step,)
    twice = rule.rewrite(once, Space())  # type: ignore[attr-defined]
    assert twice is not None
    steps = unfold(Step(rule.id, before, twice, ""), rules=[rule])
    assert [s.rule for s in steps] == [rule.id] * 2
    assert all(s.rule != rule.id for s in unfold(Step(rule.id, before, twice, "")))


def test_other_spaces() -> None:
    plane = parse("[ad][bc]", rank=2)
    d = Derivation((Step("claim", plane, parse("[ac][bd] - [ab][cd]", rank=2), ""),), Space(2))
    assert d.check()
    assert [s.rule for s in d.full()] == ["van-der-waerden", "sorting"]
    assert d.full().check()
    flat = parse_assumption("coplanar(a, b, c, d)", Context())
    zero = Step("given", parse("[abcd]"), ex.ZERO, "given")
    assert not zero.check()
    assert zero.check(Space(given=flat.given))
    infinite = Step("vanishing", parse("[ijkl][abcd] + [abce]"), parse("[abce]"), "")
    assert not infinite.check()
    assert infinite.check(ideal=tuple("ijkl"))
    assert infinite.check(Space(ideal=tuple("ijkl")))


# --- the elementary rules ------------------------------------------------------------------------------------------

FIRES = [pytest.param(r, case, id=f"{r.id}: {case}") for r in ELEMENTARY for case in r.fires]
SILENT = [pytest.param(r, case, id=f"{r.id}: {case}") for r in ELEMENTARY for case in r.silent]


def test_the_table() -> None:
    assert {r.id for r in ELEMENTARY} >= {
        "superbracket", "superbracket-16", "shortest-form", "reordering", "vanishing", "sorting", "expansion",
        "multiplying-out", "dots", "factoring-out", "van-der-waerden", "straightening", "catalog",
    }  # fmt: skip
    assert len(FIRES) > len(ELEMENTARY)
    assert len(SILENT) > len(ELEMENTARY)
    for rule in ELEMENTARY:
        assert rule.fires
        assert rule.silent
        assert ENGINE[rule.id] is rule
        assert rule.sentence.endswith(".")
    ways = [r.id for r in load_rules().strategy().rules if r in ELEMENTARY]
    assert ways == ["superbracket", "superbracket-16", "shortest-form", "catalog", "factorization"]
    bibliography = (Path(gc.__file__).parent / "references.bib").read_text(encoding="utf-8")
    assert all(r.source == "derived here" or f"{{{r.source}," in bibliography for r in ELEMENTARY)


@pytest.mark.parametrize(("rule", "case"), FIRES)
def test_fires(rule: Elementary, case: str) -> None:
    e = parse(case)
    after = rule.rewrite(e, Space())
    assert after is not None
    assert after != e
    assert vanishes(sub(e, after))
    assert straighten(sub(e, after)).to_expr() == ex.ZERO


@pytest.mark.parametrize(("rule", "case"), SILENT)
def test_stays_silent(rule: Elementary, case: str) -> None:
    assert rule.rewrite(parse(case), Space()) is None


def test_raw_superbrackets() -> None:
    """All 24 (16) terms stand there before anything is dropped."""
    e = parse("[[ab, af, cb, cd, ed, ef]]")
    for rule_id, terms in (("superbracket", 24), ("superbracket-16", 16)):
        raw = RULES[rule_id].rewrite(e, Space())
        assert isinstance(raw, ex.Sum)
        assert len(raw.terms) == terms
        assert vanishes(sub(e, raw))


def test_points_at_infinity_vanish() -> None:
    e, space = parse("[ijkl][abcd] + [ijka][bcdl]"), Space(ideal=tuple("ijkl"))
    assert RULES["vanishing"].rewrite(e, Space()) is None
    after = RULES["vanishing"].rewrite(e, space)
    assert str(after) == "[ijka][bcdl]"


@pytest.mark.parametrize("text", ["[afgl][behk][cdij]", "2[abch][defg] - [aceg][bdfh]", "[adgl][behk][cfij]"])
def test_syzygies_are_those_of_straightening(text: str) -> None:
    p = gc.expand(text)
    normal, steps = straighten_steps(p)
    found = []
    while (step := next_syzygy(p)) is not None:
        found.append(step[0])
        p = step[1]
    assert p == normal == straighten(gc.expand(text))
    assert tuple(found) == steps
    assert found


# --- rendering -----------------------------------------------------------------------------------------------------


def formulas(shown: str) -> list[str]:
    """The formulas of a derivation as text: the first line, and what follows each "  = " up to its reason."""
    found: list[str] = []
    inside = True
    for line in shown.splitlines():
        if line.startswith("  = "):
            found.append(line[4:])
            inside = True
        elif not found:
            found.append(line)
        elif inside and not line.startswith("      by ") and line:
            found[-1] += " " + line.strip()
        else:
            inside = False
    return found


def test_text(analysis: Analysis) -> None:
    """Every formula is text of the language again, and says what the step says."""
    names = analysis.structure.names
    for full in (False, True):
        d = analysis.derivation
        shown = d.text(full=full)
        assert shown.isascii()
        steps = d.full() if full else d
        found = formulas(shown)
        assert len(found) == len(steps) + 1
        for line, e in zip(found, (d.before, *(s.after for s in steps)), strict=True):
            assert parse(line, points=names) == e
        assert max(map(len, shown.splitlines())) <= 140
        assert len(re.findall(r"^ {6}by ", shown, flags=re.MULTILINE)) == len(steps)
        assert ("is not 0" in shown) == bool(d.assumed)


def test_text_in_unicode() -> None:
    shown = str(analyze_legs("Aa Ab Ac Bd Ce Df").derivation)
    assert "[Aabc](ABd ∧ ACe ∧ Df)" in shown
    assert "by tetrahedra: brackets common to all terms" in shown
    assert analyze_legs(OCTAHEDRON).text(full=True).rstrip().endswith("by expansion, read backwards")


COMMANDS = {
    "begin", "end", "wedge", "vee", "quad", "text", "dot", "mathit", "frac", ",", "\\", "!", "_", "{", "}", "neq",
    "textbackslash", "to", "cdot",
}  # fmt: skip


def check_latex(source: str, environment: str) -> None:
    """Known commands only, braces and environments balanced, one alignment mark to a row."""
    assert source.startswith(f"\\begin{{{environment}}}")
    assert source.endswith(f"\\end{{{environment}}}")
    depth = 0
    for token in re.findall(r"\\[A-Za-z]+|\\.|[{}]", source):
        if token[0] == "\\":
            assert token[1:] in COMMANDS, token
        else:
            depth += 1 if token == "{" else -1
            assert depth >= 0
    assert depth == 0
    rows = source.split("\n", 1)[1].rsplit("\n", 1)[0].split(" \\\\\n")
    for row in rows:
        assert row.count("&") == 1
        assert row.startswith("&")
    assert source.count("$") % 2 == 0


def test_latex(analysis: Analysis) -> None:
    for full in (False, True):
        check_latex(analysis.derivation.latex(full=full), "aligned")
    document = analysis.latex(full=True)
    assert document.count("\\begin{document}") == 1
    assert document.count("{") - document.count("\\{") == document.count("}") - document.count("\\}")
    assert "Steps of the derivation" in document
    assert "amsmath" in document.partition("\\begin{document}")[0]
    assert analysis.derivation._repr_latex_().count("$") % 2 == 0


def test_words_in_latex() -> None:
    assert latex_words("50% of a_1 & {b} ∧ c − d") == "50\\% of a\\_1 \\& \\{b\\} $\\wedge$ c $-$ d"


def test_json(analysis: Analysis) -> None:
    """The steps as JSON give the derivation again."""
    names = analysis.structure.names

    def read(step: dict[str, Any]) -> Step:
        before, after = (parse(step[key], points=names) for key in ("before", "after"))
        assumed = tuple(parse(e, points=names) for e in step["assumed"])
        steps = tuple(map(read, step.get("steps", ())))
        return Step(step["rule"], before, after, step["why"], assumed, step["upward"], steps)

    folded = json.loads(json.dumps(analysis.to_json()))["derivation"]
    full = json.loads(json.dumps(analysis.to_json(full=True)))["derivation"]
    assert tuple(map(read, folded)) == analysis.derivation.steps
    assert tuple(map(read, full)) == analysis.unfolded().steps
    assert [{**step, "steps": None} for step in full] == [{**step, "steps": None} for step in folded]


# --- the command line and the report -------------------------------------------------------------------------------


def answer(*words: str) -> str:
    result = CliRunner().invoke(analyze_command, [OCTAHEDRON, *words])
    assert result.exit_code == 0
    return result.stdout


def test_the_command_line() -> None:
    short, full = answer("--ascii"), answer("--ascii", "--full")
    assert full.startswith(short.rstrip())
    assert "Derivation superbracket -> planes -> left-over-plane -> four-planes" in short
    assert "by sorting, read backwards" not in short
    assert full.count("read backwards") >= 5
    assert len(answer("--latex", "--full")) > len(answer("--latex"))
    folded, single = (json.loads(answer("--json", *flag))["derivation"] for flag in ((), ("--full",)))
    assert [s["rule"] for s in folded] == [s["rule"] for s in single]
    assert not any("steps" in s for s in folded)
    assert all(s["steps"] for s in single)


def test_the_report_folds_the_single_steps_away() -> None:
    page = gc.report(analyze_legs(OCTAHEDRON))
    assert page.count("<details>") == page.count("</details>") == 1
    assert "by expansion, read backwards" in page[page.index("<details>") :]


# --- LaTeX is compiled ----------------------------------------------------------------------------------------------

COMPILED = {
    "octahedral": OCTAHEDRON,
    "four-dof": "S1A1 S1B1 S1C1 S2A2 S3A3 S3B3",
    "one incidence": "Aa Ab Bc Cd De Ef",
    "two ratios": "Aa Ab Bc Bd Ce Df",
    "always singular": "Aa Ba Ca Db Eb Fb",
    "long names": "left_top right_a, left_top b, c b, c d, e d, e right_a",
}


@pytest.mark.needs("pdflatex", "tikz.sty")
@pytest.mark.parametrize("full", [False, True], ids=["folded", "full"])
@pytest.mark.parametrize("legs", COMPILED.values(), ids=COMPILED)
def test_latex_compiles_with_the_article_class(legs: str, full: bool, tmp_path: Path) -> None:
    long = "left_top right_a" if "," in legs else ""
    (tmp_path / "a.tex").write_text(analyze_legs(legs, points=long).latex(full=full), encoding="utf-8")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "a.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=120, check=False)
    log = (tmp_path / "a.log").read_text(encoding="utf-8", errors="replace")
    assert done.returncode == 0, log[-2000:]
    assert (tmp_path / "a.pdf").stat().st_size > 10_000
    assert not [w for w in re.findall(r"Overfull .hbox \(([0-9.]+)pt", log) if float(w) > (100 if long else 40)]
