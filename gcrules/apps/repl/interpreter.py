r"""The interpreter: text in, answers out, no terminal.

>>> repl = Interpreter()
>>> for answer in repl.feed("let p = ab /\\ cde\np f\n:undo\n:context"):
...     print(answer.text)
p = ab ∧ cde, a point (step 1)
[acde] · bf − [bcde] · af
taken back: let p = ab /\ cde
rank        4
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from contextlib import contextmanager
from dataclasses import replace

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.parse_tree import read
from gcrules.algebra.language.relations import Claimed, parse_claim
from gcrules.algebra.language.rule_text import RuleText
from gcrules.algebra.language.statements import Claim, Script, Show, Statement, parse_script
from gcrules.algebra.language.syntax import Builder, Context
from gcrules.apps.repl.answers import Answer, answer_of, bound_text, fault_answer, result_of
from gcrules.apps.repl.commands import HANDLERS
from gcrules.apps.repl.reading import (
    InputPiece,
    Source,
    bare_command,
    first_word,
    is_blank,
    is_claim,
    pieces,
    split_command,
    spoken_command,
    statements,
    without_quotes,
    without_results,
)
from gcrules.apps.repl.request import Request
from gcrules.apps.repl.state import PromptState, Settings
from gcrules.apps.repl.tables import SHELL, STATEMENTS, command
from gcrules.core.alarm import paced
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.yaml_file import read_text
from gcrules.rules.script import Result, RuleResult, results

__all__ = ["Answers", "Interpreter"]

Answers = Generator[Answer, None, None]


class Interpreter:
    """A session: `state` and `settings` are frozen values that inputs replace, `over` tells whether it was left.

    A computation that is interrupted leaves the state as it was before it.
    """

    def __init__(self, state: PromptState | None = None, settings: Settings | None = None) -> None:
        self.state = state or PromptState()
        self.settings = settings or Settings()
        self.past: tuple[PromptState, ...] = ()
        self.over = False

    def feed(self, text: str, filename: str = "<input>", line: int = 1) -> Answers:
        """The answers to all inputs of a text, each as soon as it is found. Faults are answers too."""
        for piece in pieces(text.split("\n"), line):
            yield from self.answer(piece, filename)
            if self.over:
                return

    def answer(self, piece: InputPiece, filename: str = "<input>") -> Answers:
        """The answers to one input."""
        try:
            yield from paced(self._answers(piece, filename), self.settings.seconds, self.settings.gigabytes)
        except GcrulesError as fault:
            yield fault_answer(fault)

    def load(self, name: str) -> Answers:
        """The answers to a script."""
        try:
            yield from paced(self.script(name), self.settings.seconds, self.settings.gigabytes)
        except GcrulesError as fault:
            yield fault_answer(fault)

    def script(self, name: str) -> Answers:
        """Run a script. Raises GcrulesError at the first fault; what stands before it holds."""
        text = read_text(name)
        return self.run(Source(text, text, name), lines=True)

    def _answers(self, piece: InputPiece, filename: str) -> Answers:
        text = piece.text
        if is_blank(text):
            return
        called = self.called(piece, filename)
        source = Source.of(text, filename, piece.line)
        if called is not None:
            yield from self.command(piece, filename, *called)
        elif (word := first_word(text)) in STATEMENTS:
            yield from self.run(source)
        elif word in SHELL and not self._declared(word) and not self._can_be_read(source):
            begin = text.index(word) + piece.line - 1
            fault = InputError(f"`{word}` is a command of the shell", hint=f"in a shell: gcrules {text.strip()}")
            raise fault.located(source.text, filename, Span(begin, begin + len(word)))
        elif is_claim(text):
            yield from self.equation(source)
        else:
            yield from self.shown(self.expression(source), source)

    def called(self, piece: InputPiece, filename: str = "<input>") -> tuple[str, int] | None:
        """The command that an input calls, and where its argument begins; its colon may be left out where the input
        cannot be read otherwise.
        """
        text = piece.text
        written = split_command(text)
        if written is not None or first_word(text) in STATEMENTS:
            return written
        bare = bare_command(text)
        if bare and not self._declared(text):
            return bare, len(text)
        spoken = spoken_command(text)
        return spoken if spoken and not self._can_be_read(Source.of(text, filename, piece.line)) else None

    def _can_be_read(self, source: Source) -> bool:
        """Whether a text is an expression or an equation: with long names a word may be both that and a command."""
        try:
            if is_claim(source.parsed):
                self._claimed(source)
            else:
                self.expression(source)
        except GcrulesError:
            return False
        return True

    def _declared(self, text: str) -> bool:
        """Whether a word is the name of a point or of something that was named by `let`."""
        at = self.state.context
        return text.strip() in (*at.points, *at.ideal, *at.bound)

    def command(self, piece: InputPiece, filename: str, name: str, at: int) -> Answers:
        """The answers to a command, of which the argument begins at a place. Raises GcrulesError."""
        text = without_quotes(piece.text, at)
        source = replace(Source.of(text, filename, piece.line, skip=at), text="\n" * (piece.line - 1) + piece.text)
        try:
            called = command("help" if name == "?" else name)
        except InputError as fault:
            begin = piece.text.index(":") + piece.line - 1
            raise fault.located(source.text, filename, Span(begin, begin + 1 + len(name))) from None
        argument = text[at:].strip()
        if not called.takes and not is_blank(argument):
            span = Span(piece.line - 1 + at, piece.line - 1 + at + len(argument))
            raise InputError(f":{called.name} stands alone", span=span, source=source.text, filename=filename)
        yield from HANDLERS[called.name](self, Request(called, argument, source))

    # --- expressions and equations ---

    def expression(self, source: Source) -> Expr:
        """Read an expression. Raises SyntaxFault and StepError with place."""
        context = source.context(self.state.context, self.state.results)
        with source.placed():
            return read(
                source.parsed, "expression", source.filename, lambda tree: Builder(context).value(tree.children[0])
            )

    def equation(self, source: Source) -> Answers:
        """Decide an equation, or a relation."""
        claimed, context = self._claimed(source)
        with source.placed():
            label = " ".join(source.parsed.split())
            found = self._result(Claim(claimed, label, source.line, context), source, context)
        yield answer_of(found, self.settings, brief=False)

    def _claimed(self, source: Source) -> tuple[Claimed, Context]:
        context = source.context(self.state.context, self.state.results)
        with source.placed():
            return parse_claim(source.parsed, context, source.filename), context

    def shown(self, e: Expr, source: Source) -> Answers:
        """Expand an expression."""
        asked = Show(e, " ".join(source.parsed.split()), source.line, self.state.context)
        found = self._result(asked, source, self.state.context)
        self.remember(result_of(found))
        yield answer_of(found, self.settings, brief=False)

    def remember(self, e: Expr | None) -> None:
        """Let % stand for an expression."""
        if e is not None:
            self.state = self.state.with_result(e)

    # --- statements ---

    @contextmanager
    def step(self) -> Iterator[None]:
        """One step for `:undo`, if anything is declared or claimed in it."""
        before = self.state
        try:
            yield
        finally:
            if self.state.settled != before.settled:
                self.past = (*self.past, before)

    def run(self, source: Source, *, lines: bool = False) -> Answers:
        """Run the statements of a script one after the other; `lines` tells where each answer belongs."""
        with self.step():
            with source.placed():
                parts = statements(source)
            for part in parts:
                yield from self._statement(part, part.line if lines else None)

    def _statement(self, source: Source, line: int | None) -> Answers:
        before = self.state
        _check_results(source)
        context = source.context(before.context, before.results)
        with source.placed():
            self._check_rank(source)
            script = parse_script(source.parsed, source.filename, context)
            found = [self._result(s, source, script.context) for s in script.statements]
        after = replace(before, context=without_results(script.context))
        if all(r.verdict in ("proved", "shown") for r in found):
            names = (*before.context.points, *before.context.ideal)
            after = replace(after, statements=(*before.statements, source.written_out(before.results, names)))
        rules = tuple(r.check.rule for r in found if isinstance(r, RuleResult) and r.check.ok)
        after = replace(after, rules=(*before.rules, *rules))
        if first_word(source.parsed) == "rank":
            after = replace(after, ranked=True, results=())
        self.state = after
        for result in found:
            self.remember(result_of(result))
            yield answer_of(result, self.settings, brief=True, line=line)
        for name in after.context.bound:
            if name not in before.context.bound and line is None:
                yield Answer(bound_text(name, after.context, self.settings), binds=name)

    def _check_rank(self, source: Source) -> None:
        if first_word(source.parsed) == "rank" and self.state.statements:
            raise InputError(
                "`rank` must come before every other statement",
                span=Span(len(source.parsed) - len(source.parsed.lstrip()), len(source.parsed)),
                source=source.parsed,
                filename=source.filename,
                hint=":reset forgets the statements so far",
            )

    def _result(self, asked: Statement, source: Source, context: Context) -> Result:
        if isinstance(asked, RuleText):
            if any(r.id == asked.id for r in self.state.rules):
                raise InputError(
                    f"there is a rule {asked.id} already",
                    span=asked.span,
                    source=source.parsed,
                    filename=source.filename,
                    hint="choose another id, or :undo",
                )
            if self.state.ranked:
                asked = replace(asked, instances=tuple(i for i in asked.instances if i.rank == context.rank))
        script = Script((asked,), context, source.parsed, source.filename)
        (found,) = results(script, limit=self.settings.limit, rules=self.state.rules)
        return found


def _check_results(source: Source) -> None:
    """Assumptions and rules are shown as they were written, for as long as they hold; what % stands for changes."""
    word = first_word(source.parsed)
    if word in ("given", "rule") and source.used():
        raise InputError(
            f"% cannot stand in `{word}`",
            span=source.used()[0].place,
            source=source.text,
            filename=source.filename,
            hint="name the result first:  let p = %",
        )
