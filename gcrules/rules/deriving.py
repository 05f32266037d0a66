r"""The derivation of a condition: from the superbracket of the legs to coefficient · expression.

superbracket = the legs in the order chosen = its terms = what the entity rules make of them = coefficient · expression;
with a cofactor every expression is multiplied by it, from the first to the last.
"""

from __future__ import annotations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import ONE, Expr, Point
from gcrules.algebra.language.legs_text import Structure, leg_text
from gcrules.algebra.scalars import superbracket
from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.rules.condition import Condition
from gcrules.rules.condition_rule import ConditionClaim
from gcrules.rules.derivation import Derivation, Step
from gcrules.rules.factorization import BRACKETS_ONLY
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.rule import EntityRule, Rule
from gcrules.rules.strategy import FACTORIZATION

__all__ = ["derived", "derived_zero", "from_catalog", "from_claim", "terms_of"]


def derived(
    structure: Structure,
    form: SuperbracketForm,
    condition: Condition,
    claim: ConditionClaim | None,
    oracle: RandomWitness,
    *,
    own_order: bool = False,
) -> Derivation:
    """How the condition follows: from the claim if there is one, else from the catalog, else the terms of the form.

    The form is one of the structure's neutral legs; `own_order` tells that its order of legs was given by the user.
    """
    if claim is not None:
        return from_claim(structure, claim, condition, oracle, own_order=own_order)
    if condition.kind == "linear-complex":
        return terms_of(structure, form, own_order=own_order)
    if condition.kind in (FACTORIZATION, BRACKETS_ONLY):
        terms = terms_of(structure, form, condition.cofactor, own_order=own_order)
        if terms.after == condition.right_side:
            return terms
        return terms.then(FACTORIZATION, condition.right_side, _FACTORED.format(condition.certificate.detail))
    if structure.stand_ins:
        return _of_any_lines(structure, condition)
    rule = condition.certificate.data.get("rule")
    if rule:
        return _in_one_step(structure, condition, rule, condition.certificate.detail)
    return from_catalog(structure, condition)


_FACTORED = "brackets that divide, and one expression of joins and meets that equals the rest; {}"


def _of_any_lines(structure: Structure, condition: Condition) -> Derivation:
    """The identity of general lines with those that are built from points in their place."""
    built = ", ".join(str(line) for _, line in structure.stand_ins)
    why = f"the identity for any lines in the place of {built}; {condition.certificate.detail}"
    return _in_one_step(structure, condition, "any-lines", why)


def _in_one_step(structure: Structure, condition: Condition, rule: str, why: str) -> Derivation:
    """cofactor · superbracket = coefficient · expression, proved elsewhere."""
    before = ex.mul(condition.cofactor, structure.superbracket)
    step = Step(rule, before, condition.right_side, why, _assumed(condition.cofactor))
    return Derivation((step,), structure.space)


def from_catalog(structure: Structure, condition: Condition) -> Derivation:
    """cofactor · superbracket = coefficient · expression, an instance of an identity of the catalog."""
    return _in_one_step(structure, condition, "catalog", condition.certificate.detail)


def from_claim(
    structure: Structure, claim: ConditionClaim, condition: Condition, oracle: RandomWitness, *, own_order: bool = False
) -> Derivation:
    """What the rules recorded on the way to a claim."""
    found = terms_of(structure, claim.state.form, claim.cofactor, own_order=own_order)
    for rule, state in claim.state.trail:
        after, why = _recorded(rule, state, oracle)
        after = None if after is None else ex.mul(claim.cofactor, after)
        if after is not None and after != found.after:
            found = found.then(rule.id, after, why)
    if condition.right_side == found.after:
        return found
    rule, state = claim.state.trail[-1]
    reasons = [claim.sentence, "Its expansion equals the line above"]
    if rule.id != found.steps[-1].rule:
        reasons.insert(0, f"{_recorded(rule, state, oracle)[1]}.")
    return found.then(claim.kind, condition.right_side, " ".join(reasons))


def _recorded(rule: Rule, state: RecognitionState, oracle: RandomWitness) -> tuple[Expr | None, str]:
    """What the superbracket equals after a rule on the trail of a claim, if the rule rewrote it, and why."""
    if isinstance(rule, EntityRule):
        return rule.after(state, oracle), rule.why(state)
    return ex.signed(state.sign, state.rest.to_expr()), rule.sentence


def derived_zero(structure: Structure, typed: SuperbracketForm, shortest: SuperbracketForm) -> Derivation:
    """superbracket = 0, by the terms of one of the two forms if they vanish, else by their normal form.

    `typed` is a form of the legs as they are, `shortest` one of the neutral legs.
    """
    if typed.polynomial and not shortest.polynomial:
        return terms_of(structure, shortest)
    step = Step("superbracket", structure.superbracket, typed.polynomial.to_expr(), _why_terms(typed, structure))
    found = Derivation((step,), structure.space)
    why = "the normal form has no term" + (" at the points that satisfy the assumptions" if structure.given else "")
    return found.then("straightening", ex.ZERO, why) if typed.polynomial else found


def _assumed(cofactor: Expr) -> tuple[Expr, ...]:
    return () if cofactor == ONE else (cofactor,)


def terms_of(
    structure: Structure, form: SuperbracketForm, cofactor: Expr = ONE, *, own_order: bool = False
) -> Derivation:
    """cofactor · superbracket = cofactor · the form's polynomial, by way of the legs in the form's order.

    The form is one of the structure's neutral legs, or an expansion.
    """
    if not form.form or structure.stand_ins:
        before = ex.mul(cofactor, structure.superbracket)
        sign = form.sign * structure.sign if form.form else 1
        after = ex.mul(cofactor, ex.signed(sign, form.polynomial.to_expr()))
        step = Step("lines-written-out", before, after, _why_terms(form, structure), _assumed(cofactor))
        return Derivation((step,), structure.space)
    sign = form.sign * structure.sign
    legs = [structure.neutral[i] for i in form.order]
    ordered = ex.mul(ex.Number(sign), superbracket(*(ex.join(*map(Point, leg)) for leg in legs)))
    last = ex.mul(cofactor, structure.superbracket)
    steps = []
    if ordered != structure.superbracket:
        shown = ", ".join(map(leg_text, legs))
        rule, why = "shortest-form", f"the legs in an order that leaves few terms: {shown}"
        if own_order:
            rule, why = "reordering", f"the legs in the order given: {shown}"
        steps.append(Step(rule, last, ex.mul(cofactor, ordered), why, _assumed(cofactor)))
        last = steps[0].after
    rule = "superbracket" if form.form == 24 else "superbracket-16"
    terms = ex.mul(cofactor, ex.signed(sign, form.polynomial.to_expr()))
    assumed = () if steps else _assumed(cofactor)
    return Derivation((*steps, Step(rule, last, terms, _why_terms(form, structure), assumed)), structure.space)


def _why_terms(form: SuperbracketForm, structure: Structure) -> str:
    n = len(form.polynomial)
    left = f"{'1 term' if n == 1 else f'{n} terms'} left"
    if not form.form or structure.stand_ins:
        return f"the lines written out in brackets; like terms are collected: {left}"
    zero = "brackets with a repeated point are zero"
    if structure.dead:
        zero += ", and so are those that vanish under the assumptions"
    return f"the {form.form}-term form; {zero}, like terms are collected: {left}"
