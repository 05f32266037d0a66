"""Proposing the condition: any expression, or the incidence that follows from the entities."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.evaluate import evaluate, random_rational_points, vanishes
from gcrules.algebra.expand import expand
from gcrules.algebra.expr import ONE, Expr, Number, Power, Product, mul, sub
from gcrules.algebra.language.text import text
from gcrules.algebra.straightening.straighten import straighten
from gcrules.conditions.manual.automatic import oracle_of
from gcrules.conditions.manual.board import Board
from gcrules.conditions.manual.evidence import Evidence, relation, separating
from gcrules.conditions.manual.follow import follow
from gcrules.conditions.manual.known import named_condition
from gcrules.conditions.manual.outcome import NamedValue, ProposalOutcome, confirmed, refused
from gcrules.conditions.manual.words import CommandWords
from gcrules.core.errors import EngineFault, LimitReached
from gcrules.rules.catalog.file import load
from gcrules.rules.claims import best_first, certify, describe
from gcrules.rules.condition import Condition

__all__ = ["propose_condition"]

_COFACTOR = re.compile(r"(?<![\w'])cofactor(?![\w'])")
_TRIES = 40


def propose_condition(board: Board, words: CommandWords) -> tuple[Board, ProposalOutcome]:
    """condition, condition EXPR, condition EXPR cofactor EXPR"""
    if not words.text:
        return _from_entities(board)
    match = _COFACTOR.search(words.text)
    first = words.part(0, match.start()) if match else words
    expression = first.expression(board.structure, "the expression")
    cofactor: Expr = ONE
    if match:
        cofactor = words.part(match.end(), len(words.text)).expression(board.structure, "the cofactor")
    return _judge(board, expression, cofactor)


# --- from the entities ---------------------------------------------------------------------------------------------


def _from_entities(board: Board) -> tuple[Board, ProposalOutcome]:
    structure = board.structure
    found = follow(board)
    if found.claims:
        oracle = oracle_of(structure)
        first = [c for c in found.claims if c.kind == found.claims[0].kind]  # as a strategy takes the first rule
        claim = best_first(first, structure, oracle)[0]
        condition = certify(describe(claim, structure, oracle, load(()).statements), structure)
        said: tuple[str, ...] = (f"{condition.kind}: {claim.sentence}", condition.sentence)
        said = (*said, f"{condition.certificate.detail}.")
        return replace(board, condition=condition), confirmed("incidence", *said, formulas=_identity(condition))
    if found.wrong:
        _, outcome = _judge(board, found.wrong[0], ONE)
        said = ("the incidence of these entities is not the superbracket", *outcome.words)
        return board, replace(outcome, reason="no-incidence", words=said)
    missing = tuple(f"for {rule}: {what}" for rule, what in found.missing)
    said = ("entities are missing", *missing) if missing else ("no incidence rule has these entities",)
    listed = [{"rule": rule, "what": what} for rule, what in found.missing]
    return board, refused("missing", *said, missing=listed)


def _identity(condition: Condition) -> tuple[NamedValue, ...]:
    left = [NamedValue("cofactor", condition.cofactor)] if condition.cofactor != ONE else []
    name = "cofactor · superbracket" if left else "superbracket"
    return (*left, NamedValue(name, condition.right_side))


# --- any expression ------------------------------------------------------------------------------------------------


def _judge(board: Board, e: Expr, cofactor: Expr) -> tuple[Board, ProposalOutcome]:
    """Whether cofactor · superbracket = c · expression for some number c. Raises LimitReached."""
    structure = board.structure
    for what, x in (("expression", e), ("cofactor", cofactor)):
        if vanishes(x, ideal=structure.ideal) and not _normal(x, board):
            return board, refused("zero", f"the {what} is zero for all positions of the points")
    c = _coefficient(board, e, cofactor)
    return (board, _disproved(board, e, cofactor)) if c is None else _proved(board, e, cofactor, c)


def _coefficient(board: Board, e: Expr, cofactor: Expr) -> Fraction | None:
    """The number c with cofactor · superbracket = c · expression, proved by the normal form. Raises LimitReached."""
    c = _ratio(board, e, cofactor)
    if c is None:
        return None
    superbracket = board.structure.superbracket
    identity = sub(mul(Number(c.denominator), cofactor, superbracket), mul(Number(c.numerator), e))
    return None if _normal(identity, board) else c


def _normal(e: Expr, board: Board) -> BracketPolynomial:
    s = board.structure
    found = straighten(e, points=s.points, ideal=s.ideal, rank=4)
    assert isinstance(found, BracketPolynomial)
    return found


def _ratio(board: Board, e: Expr, cofactor: Expr) -> Fraction | None:
    """The only number that c can be, read off at exact points and tried on the oracle; None if there is none."""
    s = board.structure
    for seed in range(_TRIES):
        points = random_rational_points(s.names, ideal=s.ideal, seed=seed, size=3 + seed)
        right = Fraction(evaluate(e, points))
        left = Fraction(evaluate(mul(cofactor, s.superbracket), points))
        if right and left:
            c = left / right
            identity = sub(mul(cofactor, s.superbracket), mul(Number(c), e))
            return c if vanishes(identity, ideal=s.ideal) else None
        if right or left:
            return None
    return None


def _proved(board: Board, e: Expr, cofactor: Expr, c: Fraction) -> tuple[Board, ProposalOutcome]:
    (inside, bare), (outside, factor) = _number(e), _number(cofactor)
    whole = c * inside / outside
    condition = named_condition(board, bare, mul(Number(whole.denominator), factor), whole.numerator)
    said = [f"{condition.kind}: {_equation(cofactor, c)}", condition.sentence, f"{condition.certificate.detail}."]
    if factor != ONE and condition.kind != "expression":
        said.insert(2, "Where the cofactor is zero the expression says nothing.")
    new = replace(board, condition=condition)
    return new, confirmed("proved", *said, formulas=_identity(condition), coefficient=c)


def _number(e: Expr) -> tuple[Fraction, Expr]:
    """The number in front of an expression, and the rest."""
    if isinstance(e, Number):
        return Fraction(e.value), ONE
    if isinstance(e, Product) and isinstance(e.factors[0], Number):
        return Fraction(e.factors[0].value), mul(*e.factors[1:])
    return Fraction(1), e


def _equation(cofactor: Expr, c: Fraction) -> str:
    left = "the superbracket" if cofactor == ONE else "the cofactor times the superbracket"
    factor = "" if c == 1 else "minus " if c == -1 else f"{c} times "
    return f"{left} is {factor}the expression"


def _disproved(board: Board, e: Expr, cofactor: Expr) -> ProposalOutcome:
    """Degrees that differ, how one divides the other, and exact points."""
    structure = board.structure
    wanted = Counter(n for leg in structure.legs for n in leg)
    factor = _degrees(cofactor, board)
    wanted.update(factor or {})
    said = [
        f"the expression is not a constant times the {'' if cofactor == ONE else 'cofactor times the '}superbracket"
    ]
    data: dict[str, Any] = {}
    try:
        degrees: Mapping[str, int] | None = _degrees(e, board)
    except LimitReached:  # the points alone have to tell
        degrees = wanted
    if degrees is None or factor is None:
        whose = "its" if degrees is None else "the cofactor's"
        said.append(f"{whose} terms have different degrees in the points")
        degrees = None
    elif degrees is not wanted:
        unlike = [n for n in structure.names if degrees.get(n, 0) != wanted[n]]
        if unlike:
            listed = ", ".join(f"{n}: {degrees.get(n, 0)} instead of {wanted[n]}" for n in unlike)
            said.append(f"wrong degree in {listed}")
            data["degrees"] = {n: (degrees.get(n, 0), wanted[n]) for n in unlike}
        how = relation(structure, e, cofactor, sum(degrees.values()))
        data["relation"] = how
        said += _related(board, how, degrees, wanted, e, cofactor)
    seen = separating(structure, e, cofactor)
    if seen is None and degrees is not None and "degrees" not in data:
        raise EngineFault(f"no points tell {e} from the superbracket of {structure.superbracket}")
    if seen is not None:
        said += _seen(seen, cofactor)
        values = {"superbracket": seen.superbracket, "expression": seen.expression, "cofactor": seen.cofactor}
        data |= {"evidence": seen.kind, "points": seen.points, **values}
    return refused("different" if degrees is not None and "degrees" not in data else "degrees", *said, **data)


def _degrees(e: Expr, board: Board) -> dict[str, int] | None:
    """Degrees in the points; None if they are unlike even in the normal form, where terms of sum zero are gone."""
    s = board.structure
    found = expand(e, points=s.points, ideal=s.ideal, rank=4)
    assert isinstance(found, BracketPolynomial)
    degrees = found.degrees()
    return _normal(e, board).degrees() if degrees is None else degrees


def _related(
    board: Board, how: str, degrees: Mapping[str, int], wanted: Counter[str], e: Expr, cofactor: Expr
) -> list[str]:
    """What to say of one dividing the other (found at exact random points). With a cofactor it is the product with the
    superbracket that divides or is divided, which tells nothing about singular poses.
    """
    whole = "the superbracket" if cofactor == ONE else "cofactor times superbracket"
    if how == "factor" and not any(degrees.values()):  # a number
        return []
    if how == "factor" and cofactor != ONE:
        return [f"it divides {whole}"]
    if how == "factor":
        divides = "it divides the superbracket: wherever it is zero the robot is singular"
        return _power(board, degrees, wanted, e) or [f"{divides}; the other factors may vanish elsewhere"]
    if how == "shares":
        return [f"it has a factor in common with {whole}"]
    if how != "multiple":
        return []
    if cofactor != ONE:
        return [f"{whole} divides it: it has a factor too many, which the cofactor lacks"]
    more = {n: degrees.get(n, 0) - wanted[n] for n in board.structure.names}
    names = tuple(n for n, d in more.items() if d)
    if len(names) == 4 and all(more[n] == 1 for n in names):
        return [f"the superbracket divides it; the cofactor [{board.label(board.row(names))}] may be what is missing"]
    return ["the superbracket divides it: it has a factor too many, which a cofactor could make up for"]


def _power(board: Board, degrees: Mapping[str, int], wanted: Counter[str], e: Expr) -> list[str]:
    """What to say where the superbracket is a constant times the square or the cube of the expression, proved."""
    names, bare = board.structure.names, _number(e)[1]
    for k, power in ((2, "square"), (3, "cube")):
        if any(k * degrees.get(n, 0) != wanted[n] for n in names):
            continue
        try:
            c = _coefficient(board, Power(bare, k), ONE)
        except LimitReached:  # then it is only known to divide
            continue
        if c is not None:
            same = f"the superbracket is a constant times its {power}: the robot is singular exactly when it is zero"
            return [f"{same}; propose: condition {text(Power(bare, k), names=names)}"]
    return []


def _seen(seen: Evidence, cofactor: Expr) -> list[str]:
    factor = "" if cofactor == ONE else f" and the cofactor {seen.cofactor}"
    if seen.kind == "singular":
        return [f"at the following points the robot is singular, but the expression is {seen.expression}{factor}"]
    if seen.kind == "regular":
        return [f"at the following points the expression is zero, but the superbracket is {seen.superbracket}{factor}"]
    assert seen.other is not None
    return [f"at the following points the ratio is {seen.ratio}, elsewhere it is {seen.other.ratio}"]
