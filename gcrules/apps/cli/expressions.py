"""Reading expressions that a command is given."""

from __future__ import annotations

from gcrules.algebra.expr import Expr
from gcrules.algebra.language.statements import parse_assumption
from gcrules.algebra.language.syntax import Context, parse
from gcrules.apps.cli.base import Space
from gcrules.apps.cli.files import read_stdin

__all__ = ["context_of", "given_text", "read_expression"]


def given_text(argument: str) -> str:
    """The argument itself, or standard input for "-"."""
    return read_stdin() if argument == "-" else argument


def context_of(space: Space, assumptions: tuple[str, ...] = ()) -> Context:
    """Where expressions are read: rank, points, points at infinity, and what is assumed of them."""
    at = Context(space.rank, space.points, space.ideal)
    for written in assumptions:
        at = parse_assumption(written, at)
    return at


def read_expression(argument: str, space: Space) -> Expr:
    """The expression of an argument, or of standard input for "-"."""
    return parse(given_text(argument), context=context_of(space))
