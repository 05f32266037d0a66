"""A session in manual mode: proposals from a prompt, from standard input or from options."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Mapping

import click

from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.apps.cli.files import read_stdin
from gcrules.apps.cli.limits import limited
from gcrules.apps.cli.manual_options import ManualOptions
from gcrules.apps.cli.options import SpaceOptions
from gcrules.apps.cli.output import Output
from gcrules.conditions.manual import MOVES, PROPOSALS, ManualSession, analysis_of, load_session, save_session
from gcrules.conditions.manual.forms import orders_text
from gcrules.conditions.manual.words import CommandWords, relocated
from gcrules.core import interrupts
from gcrules.core.budget import waiting
from gcrules.core.errors import GcrulesError, InputError, Span
from gcrules.core.hints import near
from gcrules.mechanisms.description.platform_file import Platform

__all__ = ["run_manual"]

HELP = """\
order 2 1 3 4 6 5        write the superbracket with the legs in this order (numbers or legs)
form 16, form 24         take the other form; shortest takes the shortest, orders counts terms over all orders
tetrahedron Aabc         a bracket common to all terms
plane Aab                three points together in one bracket of every term, or the three left over
line AB                  two points together in one bracket of every term
pair C c, lines Cc Dd    left-over points as lines: P(x,y) + P(y,x) = 0
condition                the incidence that follows from the entities
condition E cofactor C   any expression: C times superbracket = constant times E
hint, auto               the next step of the automatic procedure, all its steps
undo, redo               go back and forth
show, left, history      the board, the left-over points, what was proposed
statement, analysis      the condition in words, all stages
save FILE, quit          write a session file (--session FILE resumes it), end
"""


def run_manual(
    found: Platform | Structure | None,
    order: str | None,
    manual: ManualOptions,
    space: SpaceOptions,
    out: Output,
    seconds: float,
) -> None:
    """A session on legs (or on those of the session file), to its end. The exit code is 1 if anything was refused.

    Each command may take so many `seconds`.
    """
    if out.path and not out.json:
        raise click.UsageError("In manual mode --output goes with --json; `save FILE` keeps a session.")
    with limited(seconds):
        session = _opened(found, order, manual.path, space)
        console = _Console(session, out, manual.path, seconds)
        if not out.json:
            console.say(session.text(unicode=out.unicode))
    if manual.proposals:
        for command in manual.proposals:
            if not console.script(command, "<input>"):
                break
    elif not sys.stdin.isatty():
        console.script(read_stdin(), "<stdin>")
    else:
        console.interactive()
    if out.json:
        out.write(json.dumps(console.session.to_json(), indent=2))
    click.get_current_context().exit(1 if console.refused else 0)


def _opened(
    found: Platform | Structure | None, order: str | None, path: str | None, space: SpaceOptions
) -> ManualSession:
    structure = None if found is None else _structure(found, space)
    if path is None or not os.path.exists(path):
        if structure is None:
            what = "there is no such session file" if path else "legs are missing"
            raise InputError(what, filename=path or "<input>", hint="give the legs, and the session starts with them")
        session = ManualSession.start(structure, order=order)
        if path is not None:  # now, so that a path that cannot be written is noticed before any work
            save_session(session, path)
        return session
    session = load_session(path)
    if structure is not None and structure.legs != session.structure.legs:
        raise InputError("this session is about other legs", filename=path, hint="leave the legs out to resume it")
    if order is not None:
        raise InputError("this session has begun with its own order", filename=path, hint=f"propose: order {order}")
    return session


def _structure(found: Platform | Structure, space: SpaceOptions) -> Structure:
    if isinstance(found, Structure):
        if found.stand_ins:
            raise InputError("manual mode takes legs between joints, and no lines that are built from points")
        return found
    for warning in found.warnings:
        click.echo(f"warning: {warning}", err=True)
    long_names = (n for n in found.points if not SHORT_NAME.fullmatch(n))
    return read_legs(found.legs, points=tuple(dict.fromkeys((*space.points, *long_names))), ideal=space.ideal)


class _Done(Exception):
    """The user wants to end."""


class _Console:
    """Takes commands, prints answers, saves after each change; `refused` counts refusals."""

    def __init__(self, session: ManualSession, out: Output, path: str | None, seconds: float) -> None:
        self.seconds = seconds
        self.session = session
        self.out = out
        self.path = path
        self.refused = 0
        self.views: Mapping[str, Callable[[], str]] = {
            "show": lambda: self.session.text(unicode=self.out.unicode),
            "left": lambda: f"left over: {' '.join(self.session.left) or 'none'}",
            "hint": lambda: str(self.session.hint()),
            "suggest": lambda: str(self.session.hint()),
            "orders": lambda: "\n".join(orders_text(self.session.structure)),
            "history": self._history,
            "statement": lambda: self.session.statement,
            "analysis": lambda: analysis_of(self.session).text(unicode=self.out.unicode),
            "help": lambda: HELP.rstrip("\n"),
        }

    # --- where commands come from ----------------------------------------------------------------------------------

    def script(self, source: str, filename: str) -> bool:
        """The lines of a text; the first fault ends it, with its place there. False where the user wants to end."""
        start = 0
        for line in source.splitlines(keepends=True):
            try:
                if line.strip() and not line.lstrip().startswith("#"):
                    self.say(f"> {line.strip()}")
                with limited(self.seconds):
                    self.take(line.rstrip("\r\n"))
            except _Done:
                return False
            except GcrulesError as fault:
                if fault.filename == "<input>":  # files report their own places
                    span = fault.span or Span(0, max(1, len(line.rstrip())))
                    fault.span = span
                    relocated(fault, source, start, filename)
                raise
            start += len(line)
        return True

    def interactive(self) -> None:
        """A prompt until Ctrl-D or quit; faults are shown and it goes on."""
        self.say("help lists the commands; Ctrl-D ends")
        while True:
            try:
                self._prompted()
            except (EOFError, _Done):
                break
            except KeyboardInterrupt:
                interrupts.go_on()
                click.echo("\ninterrupted; the session is as it was (Ctrl-D ends)", err=self.out.json)
        self.say("")
        if self.path:
            self.say(f"the session is in {self.path}")

    def _prompted(self) -> None:
        """One line; a fault is shown."""
        try:
            line = input("" if self.out.json else "> ")
            with limited(self.seconds):
                self.take(line)
        except GcrulesError as fault:
            click.echo(fault.render(), err=True)

    # --- what they do ----------------------------------------------------------------------------------------------

    def take(self, line: str) -> None:
        """One command. Raises GcrulesError, and _Done for quit."""
        verb, _, argument = line.strip().partition(" ")
        if not verb or verb.startswith("#"):
            return
        words = CommandWords(argument.strip(), line, len(line) - len(argument.lstrip()) if argument else len(line))
        if verb in self.views:
            words.nothing(verb)
            self.say(self.views[verb]())
        elif verb == "save":
            if not words.text:
                raise words.fault("save needs the name of a file")
            save_session(self.session, words.text)
            self.say(f"saved in {words.text}")
        elif verb in ("quit", "exit"):
            words.nothing(verb)
            raise _Done
        elif verb in PROPOSALS or verb in MOVES:
            self._do(verb, line)
        else:
            known = (*PROPOSALS, *MOVES, *self.views, "save", "quit")
            at = line.index(verb)
            hint = near(verb, known) or "help lists the commands"
            raise InputError(f"there is no command {verb}", source=line, span=Span(at, at + len(verb)), hint=hint)

    def _do(self, verb: str, line: str) -> None:
        before = self.session
        self.session = before.do(line)
        if self.path:
            save_session(self.session, self.path)
        if verb == "undo":
            self.say(f"undone: {self.session.undone[0][0].command}")
            return
        for record in self.session.history[len(before.history) :]:
            if verb in ("auto", "redo"):
                self.say(f"{verb}: {record.command}")
            self.say(record.outcome.text(unicode=self.out.unicode, names=self.session.structure.names))
            self.refused += record.outcome.refused and verb != "redo"

    def _history(self) -> str:
        lines = [f"{n:>3}  {r.outcome.answer:<9}  {r.command}" for n, r in enumerate(self.session.history, 1)]
        return "\n".join(lines) or "nothing was proposed yet"

    def say(self, text: str) -> None:
        if not self.out.json:
            with waiting():
                click.echo(text)
