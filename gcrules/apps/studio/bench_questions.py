r"""What each input of the bench asks, with nothing left to look up: names of `let` and results are written out.

>>> from gcrules.apps.repl.interpreter import Interpreter
>>> repl = Interpreter()
>>> _ = list(repl.feed("let p = ab /\\ cde\n[abcd]"))
>>> question = of_expression(repl, Source.of("p f"))
>>> question.function, question.text
('expand', '(ab /\\ cde) \\/ f')
>>> of_command(repl, Source.of(":straighten", skip=11), "straighten", "").text
'[abcd]'
"""

from __future__ import annotations

from dataclasses import replace

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.relations import Claimed, parse_claim
from gcrules.algebra.language.statements import Claim, Rewrite, Show, parse_script
from gcrules.algebra.language.text import text
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import Source, first_word, is_blank
from gcrules.apps.repl.state import PromptState
from gcrules.core.dataclass import dataclass
from gcrules.views.formulas.latex import latex

__all__ = ["Question", "of_command", "of_equation", "of_expression", "of_name", "of_statement"]


@dataclass(frozen=True)
class Question:
    """A `function` (a question of the prompt, "rewrite", or "let" and "rule", which the prompt alone takes) of a
    `text`, in the `state` before it. `tex` is that of an equation, in LaTeX.
    """

    function: str
    text: str
    state: PromptState
    tex: str = ""


def of_expression(repl: Interpreter, source: Source) -> Question:
    """An expression alone, which is expanded. Raises SyntaxFault and StepError with place, as all here do."""
    return _of(repl, "expand", repl.expression(source))


def of_equation(repl: Interpreter, source: Source) -> Question:
    """An equation alone, which is decided."""
    context = source.context(repl.state.context, repl.state.results)
    with source.placed():
        claimed = parse_claim(source.parsed, context)
    return _claimed(repl, claimed)


def of_name(repl: Interpreter, name: str, e: Expr) -> Question:
    """A name, which is given to an expression."""
    found = _of(repl, "let", e)
    return replace(found, text=f"let {name} = {found.text}")


def of_statement(repl: Interpreter, source: Source) -> Question | None:
    """A single statement; None for a declaration."""
    if first_word(source.parsed) == "rule":
        return Question("rule", source.parsed.strip(), repl.state)
    context = source.context(repl.state.context, repl.state.results)
    with source.placed():
        asked = next(iter(parse_script(source.parsed, source.filename, context).statements), None)
    match asked:
        case Claim():
            return _claimed(repl, asked.claimed)
        case Show():
            return _of(repl, "expand", asked.expr)
        case Rewrite():
            return _of(repl, "rewrite", asked.expr)
    return None


def of_command(repl: Interpreter, source: Source, name: str, argument: str) -> Question | None:
    """A question of the prompt, of the last result where nothing stands behind it; None where that is no question."""
    if name in ("transversals", "analyze", "discover"):
        return Question(name, argument.partition("#")[0].strip(), repl.state)
    if name == "prove":
        return None if is_blank(argument) else of_equation(repl, source)
    if name == "latex" and argument in ("on", "off"):
        return None
    if not is_blank(argument):
        return _of(repl, name, repl.expression(source))
    return _of(repl, name, repl.state.results[0]) if repl.state.results else None


def _of(repl: Interpreter, function: str, e: Expr) -> Question:
    return Question(function, _written(repl, e), repl.state)


def _claimed(repl: Interpreter, claimed: Claimed) -> Question:
    if claimed.relation:
        name = claimed.relation.partition("(")[0].strip()
        return Question("prove", f"{name}({', '.join(_written(repl, a) for a in claimed.args)})", repl.state)
    ((left, right),) = claimed.equations
    return Question(
        "prove", f"{_written(repl, left)} == {_written(repl, right)}", repl.state, f"{latex(left)} = {latex(right)}"
    )


def _written(repl: Interpreter, e: Expr) -> str:
    at = repl.state.context
    return text(e, names=(*at.points, *at.ideal))
