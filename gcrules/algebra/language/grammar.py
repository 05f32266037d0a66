r"""The parsers of the language: from the tables that stand beside the grammar, or made from it where it has changed.

Making the tables takes longer than reading all that a command reads. `python tools/grammar_tables.py` writes them; they
count only with this grammar and this version of the parser generator.
"""

from __future__ import annotations

import pickle
from collections.abc import Mapping
from functools import cache
from hashlib import sha256
from importlib.resources import files
from io import BytesIO
from typing import TYPE_CHECKING, Any

from gcrules.core.budget import checkpoint
from gcrules.core.frozen import FrozenMap

if TYPE_CHECKING:
    from lark import Lark

__all__ = ["STARTS", "TABLES", "built", "parser", "seen", "tables"]

STARTS: Mapping[str, tuple[str, ...]] = FrozenMap(
    {"expressions": ("expression", "equation"), "scripts": ("script", "assumptions")}
)
"""Two parsers, so that the words of statements (`if`, `show`, …) stay points side by side in lone expressions."""

TABLES = "grammar.tables"
_FREQUENT = ("WORD", "NUMBER", "LPAR", "LSQB")  # no long text is without one of these


def _source() -> str:
    return files("gcrules").joinpath("grammar.lark").read_text(encoding="utf-8")


def _digest(source: str) -> str:
    """Of all that the tables depend on."""
    import lark

    return sha256(f"{lark.__version__} {STARTS} {source}".encode()).hexdigest()


def built(which: str) -> Lark:
    """The parser made from the grammar."""
    from lark import Lark

    return Lark(
        _source(),
        parser="lalr",
        start=list(STARTS[which]),
        propagate_positions=True,
        maybe_placeholders=True,
        lexer_callbacks=dict.fromkeys(_FREQUENT, seen),
    )


def seen(token: Any) -> Any:
    """A token that was read. The tables name this function."""
    checkpoint()
    return token


@cache
def parser(which: str) -> Lark:
    """The parser for one of the `STARTS`."""
    from lark import Lark

    digest, _, kept = files("gcrules").joinpath(TABLES).read_bytes().partition(b"\n")
    if digest.decode() != _digest(_source()):
        return built(which)
    return Lark.load(BytesIO(pickle.loads(kept)[which]))


def tables() -> bytes:
    """What the file of the tables holds: a line with the digest, then the tables of each parser."""
    kept = {}
    for which in STARTS:
        written = BytesIO()
        built(which).save(written)
        kept[which] = written.getvalue()
    return _digest(_source()).encode() + b"\n" + pickle.dumps(kept)
