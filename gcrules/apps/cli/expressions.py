"""Reading expressions that a command is given."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.statements import parse_assumption, parse_letters
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.language.words import with_infinity
from gcrules.apps.cli.files import read_stdin, working
from gcrules.apps.cli.options import SpaceOptions
from gcrules.core.errors import InputError, Span

__all__ = ["argument_text", "context_of", "read_expression", "searched"]

_Answer = TypeVar("_Answer")


def argument_text(argument: str) -> str:
    """The argument itself, or standard input for "-"."""
    return read_stdin() if argument == "-" else argument


def context_of(space: SpaceOptions, assumptions: tuple[str, ...] = ()) -> Context:
    """Where expressions are read: rank, points, points at infinity, and what is assumed of them."""
    at = Context(space.rank, space.points, space.ideal)
    for kind, names in space.metric:
        at = with_infinity(at, kind, names)
    if space.letters:
        at = parse_letters(space.letters, at)
    for written in assumptions:
        at = parse_assumption(written, at)
    return at


def read_expression(argument: str, space: SpaceOptions) -> tuple[Expr, Context]:
    """The expression of an argument, or of standard input for "-", and where it was read."""
    at = context_of(space)
    return parse(argument_text(argument), context=at), at


def searched(
    task: str,
    search: Callable[..., _Answer],
    argument: str,
    space: SpaceOptions,
    limit: int,
    seconds: float,
    **options: bool,
) -> _Answer:
    """The answer of a search about an expression; how it goes is shown. Its faults are placed at the expression."""
    at, text = context_of(space), argument_text(argument)
    e = parse(text, context=at)
    with working(task):
        try:
            return search(
                e,
                points=at.points,
                ideal=at.ideal,
                rank=at.rank,
                limit=limit,
                seconds=seconds,
                **options,
            )
        except InputError as fault:
            raise fault.located(text, span=Span(len(text) - len(text.lstrip()), len(text.rstrip()))) from None
