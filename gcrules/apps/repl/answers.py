"""Answers as text, in the form that the settings ask for."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.expr import Expr, common_rank
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import text
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import letter_name, marked
from gcrules.algebra.names import step_name
from gcrules.algebra.whole_letters import in_letters
from gcrules.apps.repl.reading import as_typed
from gcrules.apps.repl.state import PromptState, Settings
from gcrules.core.budget import MORE_MEMORY
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, LimitReached
from gcrules.rules.script import ClaimResult, Result, RewriteResult, ShowResult
from gcrules.views.formulas.latex import latex
from gcrules.views.results.polynomial import points_shown

__all__ = [
    "Answer",
    "answer_of",
    "bound_text",
    "context_text",
    "fault_answer",
    "polynomial_text",
    "result_of",
    "value_text",
    "worst",
    "wrapped",
]

Polynomial = BracketPolynomial | ExtensorPolynomial

_CODES = {"proved": 0, "refuted": 1, "undecided": 3}
_ELSEWHERE = (
    ("--limit (in Python limit=...)", ":limit N"),
    ("--seconds (in Python within(seconds=...))", ":seconds S"),
    ("--seconds (in Python seconds=...)", ":seconds S"),
    (MORE_MEMORY, "give it more memory with :memory G"),
    ("raise the limit with --candidates (in Python candidates=...)", "gcrules discover takes a higher limit"),
    ("leave out --steps", "use :straighten"),
)


@dataclass(frozen=True, slots=True)
class Answer:
    """What is printed. `verdict` is proved, refuted, undecided, shown, done, or fault.

    `wraps` tells whether long lines are formulas, which may be broken to the width of a terminal; `applied` names the
    rules that led to it, in their order. `binds` is the name that was given to something, `sentences` are those with
    which an analysis opens, and a `way` is that of rules: of several steps, or of none.
    """

    text: str
    verdict: str = "done"
    fault: GcrulesError | None = None
    wraps: bool = True
    applied: tuple[str, ...] = ()
    binds: str = ""
    sentences: tuple[str, ...] = ()
    way: bool = False

    @property
    def code(self) -> int:
        """The exit code that the answer calls for."""
        return self.fault.exit_code if self.fault is not None else _CODES.get(self.verdict, 0)


_SEVERITY = (0, 3, 1, 2)


def worst(codes: Iterable[int]) -> int:
    """One exit code for several answers: the input is at fault, else no, else not decided."""
    return max(codes, key=_SEVERITY.index, default=0)


def fault_answer(fault: GcrulesError) -> Answer:
    """The message with its place; a limit that was reached leaves the question undecided."""
    return Answer(_here(fault.render()), "undecided" if isinstance(fault, LimitReached) else "fault", fault)


def answer_of(result: Result, settings: Settings, *, brief: bool, line: int | None = None) -> Answer:
    """The answer to a claim, show, rule or rewrite; `brief` for statements, whose label stands for the formula."""
    shown = _latex(result) if settings.latex else None
    if shown is None and isinstance(result, RewriteResult) and result.rewriting is not None and line is None:
        shown = result.rewriting.text(unicode=settings.unicode)
    if shown is None and not brief:
        shown = _in_full(result, settings)
    if shown is None:
        shown = result.text(unicode=settings.unicode).removeprefix(f"line {result.line}: ")
    hinted = any(words in _here(shown) for words in (":limit", ":seconds", ":memory"))
    if isinstance(result, ShowResult | ClaimResult) and result.verdict == "undecided" and not hinted:
        shown += "\nhint: :limit N allows more terms"
    words = _here(as_typed(shown if line is None else f"line {line}: {shown}"))
    way = result.rewriting if isinstance(result, RewriteResult) else None
    applied = dict.fromkeys(step.rule for step in way.steps) if way else ()
    return Answer(words, result.verdict, applied=tuple(applied), way=way is not None and len(way.steps) != 1)


def _in_full(result: Result, settings: Settings) -> str | None:
    if isinstance(result, ClaimResult) and result.proof is not None:
        return result.proof.text(unicode=settings.unicode)
    if isinstance(result, ShowResult) and result.polynomial is not None:
        return value_text(
            in_letters(result.polynomial, short=settings.short), settings, (*result.names, *result.polynomial.points)
        )
    return None


def _latex(result: Result) -> str | None:
    match result:
        case ClaimResult(proof=proof) if proof is not None:
            return f"{proof.latex()}\n% {proof.verdict}: {proof.reason}"
        case ShowResult(polynomial=polynomial) if polynomial is not None:
            return latex(in_letters(polynomial))
        case RewriteResult(rewriting=rewriting) if rewriting is not None:
            return f"\\begin{{align*}}\n{rewriting.latex()}\n\\end{{align*}}"
    return None


def result_of(result: Result) -> Expr | None:
    """What % stands for after a result."""
    match result:
        case ShowResult(polynomial=polynomial) if polynomial is not None:
            return in_letters(polynomial)
        case RewriteResult(rewriting=rewriting) if rewriting is not None:
            return rewriting.after
    return None


def value_text(e: Expr, settings: Settings, names: tuple[str, ...]) -> str:
    """An expression as the settings ask for it; `names` are the declared points."""
    if settings.latex:
        return latex(e)
    shown = text(e, unicode=settings.unicode, names=[n for n in names if not marked(n)])
    return "  # ".join([shown, *filter(None, [points_shown(shown, common_rank(None, e))])])


def polynomial_text(p: Polynomial, settings: Settings, context: Context) -> str:
    """A polynomial as the settings ask for it."""
    return value_text(in_letters(p, short=settings.short), settings, (*context.points, *p.points))


def bound_text(name: str, context: Context, settings: Settings) -> str:
    """A name with what it stands for: "p = ab ∧ cde, a point (step 1)"."""
    e = context.bound[name]
    names = (*context.points, *context.ideal)
    return f"{name} = {value_text(e, settings, names)}" + (
        "" if settings.latex else f", {step_name(e.step, context.rank)}"
    )


def context_text(state: PromptState, settings: Settings) -> str:
    """What is declared, named and assumed, a line for each."""
    at = state.context
    facts = {
        "rank": [str(at.rank)],
        "points": [" ".join(at.points)] if at.points else [],
        "ideal": [" ".join(at.ideal)] if at.ideal else [],
        "metric": [str(at.infinity)] if at.infinity else [],
        "letters": [f"{n}, {letter_name(n, step, at.screws, at.rank)}" for n, step in at.letters.items()]
        + [f"{name}, a {FORMS[at.rank].word}" for name in at.conics],
        "given": list(dict.fromkeys(map(str, at.given))),
        "let": [bound_text(n, at, settings) for n in at.bound],
        "rules": [", ".join(r.id for r in state.rules)] if state.rules else [],
        "%": [value_text(e, settings, at.points) for e in state.results[:1]],
    }
    return "\n".join(f"{key if i == 0 else '':<10}  {v}" for key, vs in facts.items() for i, v in enumerate(vs))


def wrapped(shown: str, width: int) -> str:
    """Lines that are too long broken before the signs of sums; a single term may be wider.

    >>> print(wrapped("x = [abcd] + [abce] - [abcf]", 20))
    x = [abcd] + [abce]
      - [abcf]
    """
    return "\n".join(part for line in shown.split("\n") for part in _wrapped_line(line, width))


def _wrapped_line(line: str, width: int) -> Iterator[str]:
    if len(line) <= width:
        yield line
        return
    held, *terms = re.split(r" (?=[-+−] )", line)
    indent = " " * (len(line) - len(line.lstrip()) + 2)
    for term in terms:
        if len(held) + 1 + len(term) > width:
            yield held
            held = indent + term
        else:
            held += " " + term
    yield held


def _here(shown: str) -> str:
    """With advice in the words of the session."""
    for words, here in _ELSEWHERE:
        shown = shown.replace(words, here)
    return shown
