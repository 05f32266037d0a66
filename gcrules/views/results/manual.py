"""Manual mode: the board of a session and the answer to a proposal, as text and as LaTeX."""

from __future__ import annotations

import re
from collections.abc import Iterator

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Sum
from gcrules.algebra.language.legs_text import legs_text
from gcrules.algebra.language.text import text as expression_text
from gcrules.conditions.manual.forms import form_text
from gcrules.conditions.manual.outcome import ProposalOutcome
from gcrules.conditions.manual.session import ManualSession
from gcrules.rules.condition import Entity
from gcrules.views.detail import is_everything
from gcrules.views.formulas import latex as formulas
from gcrules.views.formulas.latex_text import latex_words
from gcrules.views.results import condition as conditions

__all__ = ["as_latex", "as_text", "outcome", "outcome_latex"]

_MOST_TERMS, _SHOWN_TERMS = 12, 4
_ASCII = str.maketrans({"∧": "/\\", "∨": "\\/", "−": "-", "·": "*"})


def as_text(session: ManualSession, *, unicode: bool = False) -> str:
    """The form, its terms, the entities, the left-over points and the condition as lines of text."""
    return "\n".join(_lines(session, unicode))


def _lines(session: ManualSession, unicode: bool) -> Iterator[str]:
    board, names = session.board, session.structure.names

    def shown(e: Expr) -> str:
        return expression_text(e, unicode=unicode, names=names)

    yield f"legs       {legs_text(session.structure.legs)}"
    yield f"form       {form_text(board)}"
    terms = board.polynomial.to_expr()
    for n, term in enumerate(terms.terms if isinstance(terms, Sum) else (terms,), 1):
        yield f"  {n:>6}   {shown(term)}"
    collected = board.collected()
    if collected is not None:
        yield f"in front   {shown(collected)}"
    yield f"entities   {', '.join(map(_entity, board.starred)) or 'none'}"
    yield f"left over  {' '.join(session.left) or 'none'}"
    condition = session.confirmed
    if condition is None:
        yield "condition  none yet"
    else:
        factor = "" if condition.cofactor == ex.Number(1) else f"({shown(condition.cofactor)}) times "
        yield f"condition  {condition.kind}: {factor}superbracket = {shown(condition.right_side)}"
        yield f"           {condition.sentence}"


def _entity(entity: Entity) -> str:
    spaced = any(len(n.rstrip("*")) > 1 for n in entity.starred)
    return f"{entity.kind} {(' ' if spaced else '').join(entity.starred)}"


def as_latex(session: ManualSession) -> str:
    """The condition once it is confirmed, before that the form on the board; without dollar signs."""
    if session.confirmed is not None:
        return conditions.as_latex(session.confirmed)
    return formulas.latex(session.board.polynomial.to_expr())


def outcome(o: ProposalOutcome, *, unicode: bool = False, names: tuple[str, ...] = ()) -> str:
    """The answer, the words, the formulas and the coordinates as lines of text."""
    first, *rest = (_in_style(line, unicode) for line in o.words)
    lines = [f"{o.answer}: {first}", *(f"  {line}" for line in rest)]
    lines += [f"  {_in_style(f.name, unicode)}: {_shown(f.value, unicode, names)}" for f in o.formulas]
    lines += [f"  {n} = ({', '.join(map(str, c))})" for n, c in o.data.get("points", {}).items()]
    return "\n".join(lines)


def outcome_latex(o: ProposalOutcome) -> str:
    """The answer and the first of the words, without dollar signs."""
    return f"\\text{{{latex_words(f'{o.answer}: {o.words[0]}')}}}"


def _shown(e: Expr, unicode: bool, names: tuple[str, ...]) -> str:
    """The text of an expression; of a long sum the first terms."""
    if not isinstance(e, Sum) or len(e.terms) <= _MOST_TERMS or is_everything():
        return expression_text(e, unicode=unicode, names=names)
    first = expression_text(Sum(e.terms[:_SHOWN_TERMS]), unicode=unicode, names=names)
    return f"{first} + {'…' if unicode else '...'} ({len(e.terms)} terms)"


def _in_style(words: str, unicode: bool) -> str:
    return re.sub(r"(?<![\w)\]])-(?=\[)", "−", words) if unicode else words.translate(_ASCII)
