r"""From text to parse trees: the grammar, how large a text may be, faults with the place where the grammar stops.

>>> read("ab", "expression", "<input>", lambda tree: str(tree.children[0].data))
'word'
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any, TypeVar

from gcrules.algebra.language.syntax_faults import call_hint, syntax_fault, words_of
from gcrules.core.budget import checkpoint
from gcrules.core.errors import GcrulesError, Span, StepError, SyntaxFault

if TYPE_CHECKING:
    from lark import Lark

_T = TypeVar("_T")
Node = Any  # a lark Tree or Token; lark loads when text is read

__all__ = ["MAX_TEXT", "Node", "digits", "read", "run_name", "span_of", "whole"]

MAX_TEXT = 100_000
MAX_NESTING = 100
MAX_DIGITS = 2_000

_EXPRESSIONS = ("expression", "equation", "claimed")
_CLAIMS = ("claimed", "script", "assumptions")  # in which relations such as collinear(a, b, c) may stand


def read(text: str, start: str, filename: str, build: Callable[[Node], _T]) -> _T:
    """What `build` makes of the parse tree of a text; faults are given the text's name and place."""
    try:
        _check_size(text)
        return build(_tree(text, start))
    except GcrulesError as fault:
        if isinstance(fault, (SyntaxFault, StepError)) and fault.span is not None and fault.source in (None, text):
            relations = () if start in _CLAIMS and not _inside(text, start) else _relations()
            fault.hint = call_hint(text, fault.span.start, relations) or fault.hint
        raise fault.located(text, filename) from None


def _inside(text: str, start: str) -> bool:
    """Whether a relation in a claim can only be a part of an expression."""
    return start == "claimed" and not text.lstrip().startswith(tuple(_relations()))


@cache
def _grammar(scripts: bool) -> Lark:
    """Two parsers, so that the words of statements (`if`, `show`, …) stay points side by side in lone expressions."""
    from lark import Lark

    source = files("gcrules").joinpath("grammar.lark").read_text(encoding="utf-8")
    return Lark(
        source,
        parser="lalr",
        start=[*(("script", "assumptions") if scripts else _EXPRESSIONS)],
        propagate_positions=True,
        maybe_placeholders=True,
        lexer_callbacks=dict.fromkeys(_FREQUENT, _token),
    )


@cache
def _relations() -> list[str]:
    return words_of(next(t.pattern.value for t in _grammar(False).terminals if t.name == "RELATION"))


_FREQUENT = ("WORD", "NUMBER", "LPAR", "LSQB")  # no long text is without one of these


def _token(token: Node) -> Node:
    checkpoint()
    return token


def _check_size(text: str) -> None:
    if len(text) > MAX_TEXT:
        raise SyntaxFault(f"the input has {len(text):,} characters; the limit is {MAX_TEXT:,}")
    depth = 0
    for match in re.finditer(r'#[^\n]*|"[^"\n]*"|[(\[]|[)\]]', text):
        depth += {"(": 1, "[": 1, ")": -1, "]": -1}.get(match[0], 0)
        if depth > MAX_NESTING:
            raise SyntaxFault(
                f"nested more than {MAX_NESTING} deep",
                span=Span(*match.span()),
                hint="name a part with `let` in a file",
            )


def _tree(text: str, start: str) -> Node:
    from lark.exceptions import UnexpectedInput

    grammar = _grammar(start not in _EXPRESSIONS)
    try:
        return grammar.parse(text, start=start)
    except UnexpectedInput as found:
        literals = {t.name: t.pattern.value for t in grammar.terminals}
        raise syntax_fault(found, text, literals, _relations() if start in _CLAIMS else ()) from None


def span_of(item: Node) -> Span:
    meta: Any = getattr(item, "meta", item)
    return Span(meta.start_pos or 0, meta.end_pos or 0)


def digits(token: Node) -> str:
    if len(token) > MAX_DIGITS:
        raise SyntaxFault(f"a number of {len(token):,} characters; the limit is {MAX_DIGITS:,}", span=span_of(token))
    return str(token)


def run_name(tree: Node) -> str:
    """The name R of a run R..."""
    return str(tree.children[0]).rstrip(".…")


def whole(token: Node, what: str) -> int:
    if "/" in token:
        raise SyntaxFault(f"{what} must be a whole number", span=span_of(token))
    return int(digits(token))
