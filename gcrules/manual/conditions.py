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
from gcrules.algebra.expr import Expr, Number, Product, mul, sub
from gcrules.algebra.straighten import straighten
from gcrules.catalog_file import load
from gcrules.condition import ONE, Condition
from gcrules.errors import EngineFault, LimitReached
from gcrules.manual.automatic import oracle_of
from gcrules.manual.board import Board
from gcrules.manual.evidence import Evidence, relation, separating
from gcrules.manual.follow import follow
from gcrules.manual.known import named_condition
from gcrules.manual.outcome import Formula, Outcome, confirmed, refused
from gcrules.manual.words import Words
from gcrules.rules.conditions import best_first, certify, describe

__all__ = ["propose_condition"]

_COFACTOR = re.compile(r"(?<![\w'])cofactor(?![\w'])")
_TRIES = 40


def propose_condition(board: Board, words: Words) -> tuple[Board, Outcome]:
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


def _from_entities(board: Board) -> tuple[Board, Outcome]:
    structure = board.structure
    found = follow(board)
    if found.claims:
        oracle = oracle_of(structure)
        first = [c for c in found.claims if c.kind == found.claims[0].kind]  # as a strategy takes the first rule
        claim = best_first(first, structure, oracle)[0]
        condition = certify(describe(claim, structure, oracle, load(()).statements), structure)
        said: tuple[str, ...] = (f"{condition.kind}: {claim.sentence}", condition.statement)
        said = (*said, f"{condition.certificate.detail}.")
        return replace(board, condition=condition), confirmed("incidence", *said, formulas=_identity(condition, board))
    if found.wrong:
        _, outcome = _judge(board, found.wrong[0], ONE)
        said = ("the incidence of these entities is not the superbracket", *outcome.words)
        return board, replace(outcome, reason="no-incidence", words=said)
    missing = tuple(f"for {rule}: {what}" for rule, what in found.missing)
    said = ("entities are missing", *missing) if missing else ("no incidence rule has these entities",)
    listed = [{"rule": rule, "what": what} for rule, what in found.missing]
    return board, refused("missing", *said, missing=listed)


def _identity(condition: Condition, board: Board) -> tuple[Formula, ...]:
    left = [Formula("cofactor", condition.cofactor)] if condition.cofactor != ONE else []
    name = "cofactor · superbracket" if left else "superbracket"
    return (*left, Formula(name, condition.right_side))


# --- any expression ------------------------------------------------------------------------------------------------


def _judge(board: Board, e: Expr, cofactor: Expr) -> tuple[Board, Outcome]:
    """Whether cofactor · superbracket = c · expression for some number c. Raises LimitReached."""
    structure = board.structure
    for what, x in (("expression", e), ("cofactor", cofactor)):
        if vanishes(x, ideal=structure.ideal) and not _normal(x, board):
            return board, refused("zero", f"the {what} is zero for all positions of the points")
    c = _ratio(board, e, cofactor)
    if c is not None:
        identity = sub(mul(Number(c.denominator), cofactor, structure.superbracket), mul(Number(c.numerator), e))
        if not _normal(identity, board):
            return _proved(board, e, cofactor, c)
    return board, _disproved(board, e, cofactor)


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


def _proved(board: Board, e: Expr, cofactor: Expr, c: Fraction) -> tuple[Board, Outcome]:
    (inside, bare), (outside, factor) = _number(e), _number(cofactor)
    whole = c * inside / outside
    condition = named_condition(board, bare, mul(Number(whole.denominator), factor), whole.numerator)
    said = [f"{condition.kind}: {_equation(cofactor, c)}", condition.statement, f"{condition.certificate.detail}."]
    if factor != ONE and condition.kind != "expression":
        said.insert(2, "Where the cofactor is zero the expression says nothing.")
    new = replace(board, condition=condition)
    return new, confirmed("proved", *said, formulas=_identity(condition, board), coefficient=c)


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


def _disproved(board: Board, e: Expr, cofactor: Expr) -> Outcome:
    """Degrees that differ, how one divides the other, and exact points."""
    structure = board.structure
    wanted = Counter(n for leg in structure.legs for n in leg)
    wanted.update(_degrees(cofactor, board) or {})
    said = [f"the expression is no constant times the {'' if cofactor == ONE else 'cofactor times the '}superbracket"]
    data: dict[str, Any] = {}
    try:
        degrees: Mapping[str, int] | None = _degrees(e, board)
    except LimitReached:  # the points alone have to tell
        degrees = wanted
    if degrees is None:
        said.append("its terms have unlike degrees in the points")
    elif degrees is not wanted:
        unlike = [n for n in structure.names if degrees.get(n, 0) != wanted[n]]
        if unlike:
            listed = ", ".join(f"{n}: {degrees.get(n, 0)} instead of {wanted[n]}" for n in unlike)
            said.append(f"wrong degree in {listed}")
            data["degrees"] = {n: (degrees.get(n, 0), wanted[n]) for n in unlike}
        how = relation(structure, e, cofactor, sum(degrees.values()))
        data["relation"] = how
        said += _related(board, how, degrees, wanted, cofactor)
    seen = separating(structure, e, cofactor)
    if seen is None and degrees is not None and "degrees" not in data:
        raise EngineFault(f"no points tell {e} from the superbracket of {structure.superbracket}")
    if seen is not None:
        said += _seen(seen, cofactor)
        values = {"superbracket": seen.superbracket, "expression": seen.expression, "cofactor": seen.cofactor}
        data |= {"evidence": seen.kind, "points": seen.points, **values}
    return refused("different" if degrees is not None and "degrees" not in data else "degrees", *said, **data)


def _degrees(e: Expr, board: Board) -> dict[str, int] | None:
    s = board.structure
    found = expand(e, points=s.points, ideal=s.ideal, rank=4)
    assert isinstance(found, BracketPolynomial)
    return found.degrees()


def _related(board: Board, how: str, degrees: Mapping[str, int], wanted: Counter[str], cofactor: Expr) -> list[str]:
    """What to say of one dividing the other (found at exact random points)."""
    if how == "factor":
        return ["it is a factor only: wherever it is zero the robot is singular, but not the other way round"]
    if how == "shares":
        return ["it has a factor in common with the superbracket"]
    if how != "multiple":
        return []
    more = {n: degrees.get(n, 0) - wanted[n] for n in board.structure.names}
    names = tuple(n for n, d in more.items() if d)
    if cofactor == ONE and len(names) == 4 and all(more[n] == 1 for n in names):
        return [f"the superbracket divides it; the cofactor [{board.label(board.row(names))}] may be what is missing"]
    return ["the superbracket divides it: it has a factor too many, which a cofactor could make up for"]


def _seen(seen: Evidence, cofactor: Expr) -> list[str]:
    factor = "" if cofactor == ONE else f" and the cofactor {seen.cofactor}"
    if seen.kind == "singular":
        return [f"at the following points the robot is singular, but the expression is {seen.expression}{factor}"]
    if seen.kind == "regular":
        return [f"at the following points the expression is zero, but the superbracket is {seen.superbracket}{factor}"]
    assert seen.other is not None
    return [f"at the following points the ratio is {seen.ratio}, elsewhere it is {seen.other.ratio}"]
