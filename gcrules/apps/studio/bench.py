r"""The expression bench: statements and expressions of the language, their results in formulas and in space.

>>> view = bench("let p = ab /\\ cde\n[abcd] [efgh] == [efgh] [abcd]\nab /\\", None, None)
>>> [(r["name"], r["verdict"], r["step"], r["start"], r["end"]) for r in view["results"]]
[('p', 'value', 1, 0, 17), (None, 'proved', None, 18, 48)]
>>> view["fault"]["place"]
{'start': 54, 'end': 54, 'line': 3, 'column': 6}
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, Literal

from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.apps.repl.answers import Answer, bound_text
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.reading import InputPiece as Input
from gcrules.apps.repl.reading import Source, first_word, is_claim, pieces, statements
from gcrules.apps.repl.state import PromptState, Settings
from gcrules.apps.repl.tables import STATEMENTS, meant
from gcrules.apps.studio.bench_questions import Question, of_command, of_equation, of_expression, of_name, of_statement
from gcrules.apps.studio.bench_repeating import Rules, answer_lines
from gcrules.apps.studio.catalog_files import CLASS, used_catalogs
from gcrules.apps.studio.faults import fault_view, units
from gcrules.apps.studio.formulas import pieces as in_pieces
from gcrules.apps.studio.parts import give, shaped
from gcrules.apps.studio.places import homogeneous_at
from gcrules.apps.studio.protocol.answer_views import AppliedRule, Bench, BenchPart, BenchResult, DrawnPlane, RuleOwner
from gcrules.apps.studio.protocol.bench_words import BENCH_COMMANDS
from gcrules.apps.studio.protocol.requests import HOME, PoseJson, RuleFile
from gcrules.apps.studio.protocol.study_views import FaultView
from gcrules.apps.studio.rule_files import usable
from gcrules.apps.studio.subject import Subject
from gcrules.core.budget import stage
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, LimitReached, Span
from gcrules.core.seeds import remembered
from gcrules.poses.numbers.extensors import coordinates, line_vectors, plane_equation
from gcrules.rules.plugins import load_rules
from gcrules.rules.rule import SHIPPED
from gcrules.views.formulas.latex import latex
from gcrules.views.scene_data import Constructed, NamedLineView, NamedPointView
from gcrules.views.text_tables import unbroken

__all__ = ["bench", "context_of"]

_MOST_PIECES = 2_000
_MOST_TERMS = 20_000
_SHOWN_LENGTH = 60
_FAR = 1e-9  # of the size of a homogeneous coordinate: what is nearer to 0 counts as at infinity
_VERDICTS: Mapping[str, Literal["value", "proved", "refuted", "undecided", "done"]] = {
    "proved": "proved",
    "refuted": "refuted",
    "undecided": "undecided",
    "shown": "value",
    "done": "done",
}


def bench(
    text: str,
    subject: Subject | None,
    pose: PoseJson | None,
    files: Sequence[RuleFile] = (),
    folders: Sequence[str] = (),
) -> Bench:
    """The results of all inputs of a text up to the first fault. Extensors of points of the subject are drawn at the
    pose. The rules of `files` hold from the start, an analysis takes in those of `folders` of plugins. Each result is
    given as a `BenchPart` first, unless all of them are remembered.
    """
    rules = tuple((f["name"], f["text"], tuple(f["off"])) for f in files)
    at = _places(subject, pose or HOME)

    def part(numbered: tuple[int, _Result]) -> BenchPart:
        return {"index": numbered[0], "result": _placed(numbered[1], at)}

    try:
        with shaped(part):
            found = _answered(text, context_of(subject), rules, tuple(folders))
    except _Unfinished as unfinished:
        found = unfinished.found
    return {"results": [_placed(one, at) for one in found.results], "fault": found.fault}


@dataclass(frozen=True)
class _Result:
    """A result, and the extensor that is drawn under a label, if there is one."""

    result: BenchResult
    shape: Expr | None = None
    label: str = ""


def _placed(one: _Result, at: Mapping[str, Any]) -> BenchResult:
    return {**one.result, "drawn": _drawn(one.shape, one.label, at) if one.shape is not None else None}


@dataclass(frozen=True)
class _Found:
    results: tuple[_Result, ...]
    fault: FaultView | None


class _Unfinished(Exception):
    """What was found when a limit was reached, which may not be so the next time."""

    def __init__(self, found: _Found) -> None:
        super().__init__()
        self.found = found


@remembered(16)
def _answered(
    text: str, context: Context, rules: tuple[tuple[str, str, tuple[str, ...]], ...], folders: tuple[str, ...]
) -> _Found:
    """All that does not depend on the pose: where the robot only moves it is not worked out again."""
    files: list[RuleFile] = [{"name": name, "text": body, "off": list(off)} for name, body, off in rules]
    settings = Settings(limit=_MOST_TERMS, files=False, plugins=folders, catalogs=used_catalogs(files))
    repl = Interpreter(PromptState(context, rules=usable(files) if files else ()), settings)
    before = Rules.of(files, folders)
    results: list[_Result] = []
    lines = text.split("\n")
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line) + 1)
    for given in pieces(lines):
        start = starts[given.line - 1]
        body = given.text.rstrip()
        place = Span(units(text[:start]), units(text[:start]) + units(body))
        try:
            with stage(f"line {given.line}, {_shortened(body)}"), unbroken():
                for result in _results(repl, given, place, before):
                    give((len(results), result))
                    results.append(result)
        except GcrulesError as fault:
            _in_text(fault, text, starts, Span(start, start + len(body)))
            found = _Found(tuple(results), fault_view(fault))
            if isinstance(fault, LimitReached):
                raise _Unfinished(found) from None
            return found
    return _Found(tuple(results), None)


def _shortened(text: str) -> str:
    """An input in one line, for words of progress."""
    line = " ".join(text.split())
    return line if len(line) <= _SHOWN_LENGTH else f"{line[:_SHOWN_LENGTH]} …"


def _places(subject: Subject | None, pose: PoseJson) -> Mapping[str, Any]:
    """Where the points are; nowhere in a pose that cannot be, in which formulas are as good as elsewhere, and where
    there is no NumPy.
    """
    if subject is None:
        return {}
    try:
        return homogeneous_at(subject, pose)
    except (InputError, ModuleNotFoundError):
        return {}


def context_of(subject: Subject | None) -> Context:
    """The points of the subject that have to be declared: long names, and points at infinity."""
    s = subject.structure if subject else None
    if s is None:
        return Context()
    return Context(s.rank, tuple(n for n in s.names if not SHORT_NAME.fullmatch(n)), s.ideal)


def _results(repl: Interpreter, given: Input, place: Span, before: Rules) -> Iterator[_Result]:
    called = repl.called(given, "<bench>")
    if called is not None:
        yield from _asked(repl, given, place, before, *called)
        return
    source = Source.of(given.text, "<bench>", given.line)
    if first_word(given.text) in STATEMENTS:
        for part in _statements(source):
            yield from _statement(repl, part, place, before)
    elif is_claim(given.text):
        question = of_equation(repl, source)
        for answer in repl.equation(source):
            yield _Result(_said(repl, place, before, answer, question))
    else:
        question, e = of_expression(repl, source), repl.expression(source)
        for answer in repl.shown(e, source):
            found = _said(repl, place, before, answer, question)
            yield _drawable(repl, {**found, "step": e.step}, e, str(e) if e.step else answer.text)


def _statements(source: Source) -> list[Source]:
    with source.placed():
        return statements(source)


def _statement(repl: Interpreter, part: Source, place: Span, before: Rules) -> Iterator[_Result]:
    """A single statement: names with what they stand for, or its answer."""
    known = set(repl.state.context.bound)
    question = of_statement(repl, part)
    answers = [a for a in repl.run(part) if not a.binds]
    context = repl.state.context
    for name in [n for n in context.bound if n not in known]:
        e = context.bound[name]
        said = Answer(bound_text(name, context, repl.settings), "shown")
        found = _said(repl, place, before, said, of_name(repl, name, e), e)
        yield _drawable(repl, {**found, "name": name, "step": e.step}, e, name)
    for answer in answers:
        yield _Result(_said(repl, place, before, answer, question))


def _drawable(repl: Interpreter, result: BenchResult, e: Expr, label: str) -> _Result:
    """With what is drawn of it, where the text is of space."""
    return _Result(result, e if repl.state.context.rank == 4 else None, label)


def _asked(repl: Interpreter, given: Input, place: Span, before: Rules, name: str, at: int) -> Iterator[_Result]:
    """What a command of the prompt answers, if it asks something of algebra; files and a session are none here."""
    source = Source.of(given.text, "<bench>", given.line, skip=at)
    if not set(meant(name)) <= {*BENCH_COMMANDS}:
        span = Span(given.line - 1, given.line - 1 + len(given.text))
        known = ", ".join(f":{n}" for n in BENCH_COMMANDS)
        hint = f"write {known}; or statements (let, points, claim, show …), expressions and equations"
        raise InputError("this command of the prompt does not work here", span=span, source=source.text, hint=hint)
    asked = next(iter(meant(name)), name)
    whole = len(meant(name)) == 1
    question = of_command(repl, source, asked, given.text[at:].strip()) if whole else None
    for answer in repl.command(given, "<bench>", name, at):
        yield _Result({**_said(repl, place, before, answer, question), "command": asked})


def _said(
    repl: Interpreter, place: Span, before: Rules, answer: Answer, question: Question | None, e: Expr | None = None
) -> BenchResult:
    """An answer, with the expression that it gives: `e`, or else the result that there was not before the question."""
    if e is None and question is not None and repl.state.results is not question.state.results:
        e = repl.state.results[0]
    shown = in_pieces(e) if e is not None and answer.verdict == "shown" else []
    proved = question.tex if question and answer.verdict == "proved" and not question.state.context.given else ""
    limit = repl.settings.limit if answer.verdict == "undecided" else None
    return {
        "start": place.start,
        "end": place.end,
        "name": None,
        "command": None,
        "verdict": _VERDICTS.get(answer.verdict, "done"),
        "text": answer.text,
        "sentences": list(answer.sentences),
        "way": answer.way,
        "tex": latex(e) if e is not None and 0 < len(shown) <= _MOST_PIECES else proved,
        "pieces": shown[:_MOST_PIECES],
        "terms": len(shown),
        "step": None,
        "drawn": None,
        "applied": _applied(repl, before, answer),
        "repeat": answer_lines(question, before, limit) if question else None,
    }


def _applied(repl: Interpreter, before: Rules, answer: Answer) -> list[AppliedRule]:
    """The rules behind an answer, with who brought them."""
    if not answer.applied:
        return []
    brought = {r.id: r for r in load_rules(folders=repl.settings.plugins, identities=False)}
    sentences = {r.id: r.sentence for r in (*brought.values(), *repl.state.rules)}
    known = [name for name in answer.applied if CLASS not in name or name in before.brought]

    def owner(name: str) -> RuleOwner:
        if name in before.brought:
            return before.brought[name]
        if name not in brought or any(r.id == name for r in repl.state.rules):
            return {"kind": "text", "name": "", "line": None}
        if brought[name].owner == SHIPPED:
            return {"kind": "gcrules", "name": "", "line": None}
        return {"kind": "plugin", "name": brought[name].owner, "line": None}

    return [
        {"id": name.rpartition(CLASS)[2], "sentence": sentences.get(name, ""), "owner": owner(name)} for name in known
    ]


def _in_text(fault: GcrulesError, text: str, starts: list[int], whole: Span) -> None:
    """The place of a fault in the whole text, which the interpreter reads input by input; that of the `whole` input
    where there is none.
    """
    if fault.span is None or fault.source is None:
        fault.span, fault.source = whole, text
        return
    line, column = fault.span.line_column(fault.source)
    start = min(starts[min(line, len(starts)) - 1] + column - 1, len(text))
    fault.span = Span(start, min(start + fault.span.end - fault.span.start, len(text)))
    fault.source = text


# --- in space ------------------------------------------------------------------------------------------------------


def _drawn(e: Expr, label: str, at: Mapping[str, Any]) -> Constructed | DrawnPlane | None:
    """A point, line or plane through points of the subject; None for anything else, and at infinity."""
    if e.step not in _SHOWN or not points_of(e) or not set(points_of(e)) <= set(at):
        return None
    found = coordinates(e, at)
    size = float(abs(found).max())
    return _SHOWN[e.step](found / size, label) if size else None


def _point(found: Any, label: str) -> NamedPointView | None:
    *xyz, w = map(float, found[0])
    if abs(w) <= _FAR:
        return None
    return {"kind": "point", "label": label, "at": [c / w for c in xyz], "entities": []}


def _line(found: Any, label: str) -> NamedLineView | None:
    import numpy as np

    (d,), (m,) = line_vectors(found)
    size = float(np.linalg.norm(d))
    if size <= _FAR:
        return None
    foot = np.cross(d, m) / size**2
    return {"kind": "line", "label": label, "at": foot.tolist(), "direction": (d / size).tolist(), "entities": []}


def _plane(found: Any, label: str) -> DrawnPlane | None:
    import numpy as np

    *normal, d = plane_equation(found)[0]
    size = float(np.linalg.norm(normal))
    if size <= _FAR:
        return None
    return {"kind": "plane", "label": label, "normal": [float(c) / size for c in normal], "offset": -float(d) / size}


_SHOWN: Mapping[int, Callable[[Any, str], Constructed | DrawnPlane | None]] = {1: _point, 2: _line, 3: _plane}
"""What draws an extensor of each step."""
