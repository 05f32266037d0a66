"""What there is to say of a result, in pieces that text, HTML and the studio set each in their own way."""

from __future__ import annotations

from gcrules.core.dataclass import dataclass

__all__ = ["Block", "Facts", "Grid", "ResultAccount", "Sentences"]


@dataclass(frozen=True)
class Facts:
    """Names with what is said of each; a name that comes twice in a row is written once."""

    rows: tuple[tuple[str, str], ...]
    title: str = ""


@dataclass(frozen=True)
class Grid:
    """A table: the names of its columns, of which the first names a row, and the cells of its rows."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    title: str = ""


@dataclass(frozen=True)
class Sentences:
    """One after the other, `numbered` from 0 on where they are steps."""

    lines: tuple[str, ...]
    title: str = ""
    numbered: bool = False


Block = Facts | Grid | Sentences


@dataclass(frozen=True)
class ResultAccount:
    """The answer in a sentence or two, then what it consists of and how sure it is."""

    verdict: str
    blocks: tuple[Block, ...]
