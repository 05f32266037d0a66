r"""The derivation of a condition: from the superbracket of the legs to coefficient · expression.

superbracket = the legs in the order chosen = its terms = what the entity rules make of them = coefficient · expression;
with a cofactor every expression is multiplied by it, from the first to the last.
"""

from __future__ import annotations

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.shortest import SuperbracketForm
from gcrules.algebra.space import Space
from gcrules.condition import ONE, Condition
from gcrules.legs import Structure, leg_text
from gcrules.rules.derivation import Derivation, Step
from gcrules.rules.incidence import Claim
from gcrules.rules.oracle import Oracle
from gcrules.rules.rule import EntityRule, Rule
from gcrules.rules.state import State

__all__ = ["derived", "derived_zero", "from_catalog", "from_claim", "terms_of"]


def derived(
    structure: Structure,
    form: SuperbracketForm,
    condition: Condition,
    claim: Claim | None,
    oracle: Oracle,
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
    return from_catalog(structure, condition)


def from_claim(
    structure: Structure, claim: Claim, condition: Condition, oracle: Oracle, *, own_order: bool = False
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


def _recorded(rule: Rule, state: State, oracle: Oracle) -> tuple[Expr | None, str]:
    """What the superbracket equals after a rule on the trail of a claim, if the rule rewrote it, and why."""
    if isinstance(rule, EntityRule):
        return rule.after(state, oracle), rule.why(state)
    return ex.signed(state.sign, state.rest.to_expr()), rule.sentence


def from_catalog(structure: Structure, condition: Condition) -> Derivation:
    """cofactor · superbracket = coefficient · expression, an instance of an identity of the catalog."""
    before = ex.mul(condition.cofactor, structure.superbracket)
    why = condition.certificate.detail
    step = Step("catalog", before, condition.right_side, why, _assumed(condition.cofactor))
    return Derivation((step,), _space(structure))


def derived_zero(structure: Structure, typed: SuperbracketForm, shortest: SuperbracketForm) -> Derivation:
    """superbracket = 0, by the terms of one of the two forms if they vanish, else by their normal form.

    `typed` is a form of the legs as they are, `shortest` one of the neutral legs.
    """
    if typed.polynomial and not shortest.polynomial:
        return terms_of(structure, shortest)
    step = Step("superbracket", structure.superbracket, typed.polynomial.to_expr(), _why_terms(typed))
    found = Derivation((step,), _space(structure))
    return found.then("straightening", ex.ZERO, "the normal form has no term") if typed.polynomial else found


def _space(structure: Structure) -> Space:
    return Space(4, structure.names, structure.ideal)


def _assumed(cofactor: Expr) -> tuple[Expr, ...]:
    return () if cofactor == ONE else (cofactor,)


def terms_of(
    structure: Structure, form: SuperbracketForm, cofactor: Expr = ONE, *, own_order: bool = False
) -> Derivation:
    """cofactor · superbracket = cofactor · the form's polynomial, by way of the legs in the form's order.

    The form is one of the structure's neutral legs.
    """
    sign = form.sign * structure.sign
    legs = [structure.neutral[i] for i in form.order]
    ordered = ex.mul(ex.Number(sign), ex.superbracket(*(ex.join(*map(Point, leg)) for leg in legs)))
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
    return Derivation((*steps, Step(rule, last, terms, _why_terms(form), assumed)), _space(structure))


def _why_terms(form: SuperbracketForm) -> str:
    n = len(form.polynomial)
    return (
        f"the {form.form}-term form; brackets with a repeated point are zero, like terms are collected: "
        f"{'1 term' if n == 1 else f'{n} terms'} left"
    )
