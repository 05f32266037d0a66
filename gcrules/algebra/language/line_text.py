r"""Reading lines as the user writes them: two joints (ab, S1A1, left top), or an expression of step 2 (abc /\ def).

>>> [words for words, _ in split_lines(r"ab abc /\ def  S1A1")]
['ab', 'abc /\\ def', 'S1A1']
>>> read_line("S1A1"), str(read_line("abc^def"))
(('S1', 'A1'), 'abc /\\ def')
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence

from gcrules.algebra.expr import Expr, Join, Meet, Point, points_of, subexpressions
from gcrules.algebra.language.syntax import Context, parse
from gcrules.algebra.language.text import SHORT_NAME
from gcrules.algebra.letters import letters_of, names_of
from gcrules.algebra.names import step_name
from gcrules.algebra.screw_letters import Screw, screws_of
from gcrules.core.errors import InputError, Span, StepError
from gcrules.core.frozen import FrozenMap

__all__ = ["Leg", "different", "read_line", "split_lines"]

Leg = tuple[str, str]
_NONE: Mapping[str, int] = FrozenMap()

_SHORT_LEG = re.compile(f"({SHORT_NAME.pattern}) *({SHORT_NAME.pattern})")
_OPERATOR = re.compile(r"/\\|\\/|[\^∧∨]")
_NESTED = r"\((?:[^()]|\([^()]*\))*\)"
_PART = rf"(?:{_NESTED}|[^\s(/\\^∧∨])+"
_LINE = re.compile(rf"{_PART}(?:\s*(?:/\\|\\/|[\^∧∨])\s*{_PART})*|\S+")
_HINT = "a leg is two points written together: ab, S1A1; longer names need --points"
_BUILT = "a line is two points, or built from points by joins and meets: abc /\\ def"


def split_lines(text: str) -> Iterator[tuple[str, Span]]:
    """The lines of a text, with their places: set apart by commas, else by spaces that stand beside no operator."""
    pattern = re.compile(r"[^,;]+") if re.search(r"[,;]", text) else _LINE
    for match in pattern.finditer(text):
        word = match[0].strip()
        if word:
            start = match.start() + len(match[0]) - len(match[0].lstrip())
            yield word, Span(start, start + len(word))


def read_line(
    text: str,
    points: Sequence[str] = (),
    rank: int = 4,
    built: bool = True,
    letters: Mapping[str, int] = _NONE,
    screws: Collection[str] = (),
) -> Leg | Expr:
    """The two ends of a leg, or (if `built` allows it) the expression of a line that is built from points.

    A letter for a line is a leg whose ends are the points that it is the join of, one of `screws` a leg as it is.
    Raises InputError and StepError for anything else.
    """
    if letters.get(text) == 2 and text not in screws:
        first, second = names_of(text, 2)
        return first, second
    if letters:
        return _with_letters(text, built, Context(rank, tuple(points), letters=letters, screws=tuple(screws)))
    short = _SHORT_LEG.fullmatch(text)
    if short and not any(len(n) > 1 and not SHORT_NAME.fullmatch(n) for n in points):
        return different(short[1], short[2])
    if not _OPERATOR.search(text):
        return _two_points(text, points)
    if not built:
        raise InputError("expected two points", hint="lines that are built from points are for `gcrules analyze`")
    found = parse(text, context=Context(rank, tuple(points)))
    if found.step != 2:
        raise InputError(f"expected a line, found {step_name(found.step, rank)}", hint=_BUILT)
    if not all(isinstance(e, (Point, Join, Meet)) for e in subexpressions(found)):
        raise InputError("a sum or a multiple of lines need not be a line", hint=_BUILT)
    match found:
        case Join(args=(Point(name=a), Point(name=b))):
            return different(a, b)
    return found


def _with_letters(text: str, built: bool, at: Context) -> Leg | Expr:
    """A leg where letters are declared, which it may be built from."""
    found = parse(text, context=at)
    if found.step != 2:
        raise InputError(f"expected a line, found {step_name(found.step, at.rank)}", hint=_BUILT)
    if not letters_of(points_of(found)) and not screws_of(points_of(found)):
        return read_line(text, at.points, at.rank, built)
    if not built and not isinstance(found, Screw):
        raise InputError("expected two points, or a letter", hint="lines that are built are for `gcrules analyze`")
    if not all(isinstance(e, (Point, Join, Meet, Screw)) for e in subexpressions(found)):
        raise InputError("a sum or a multiple of lines need not be a line", hint=_BUILT)
    return found


def _two_points(text: str, points: Sequence[str]) -> Leg:
    try:
        found = parse(text, context=Context(8, tuple(points)))
    except StepError:
        raise InputError("expected two points", hint=_HINT) from None
    names = tuple(a.name for a in (found.args if isinstance(found, Join) else (found,)) if isinstance(a, Point))
    if len(names) != 2 or found.step != 2:
        raise InputError(f"expected two points, found {found.step if len(names) == found.step else text!r}", hint=_HINT)
    return different(*names)


def different(a: str, b: str) -> Leg:
    """The two ends of a leg. Raises InputError where they are one point."""
    if a == b:
        raise InputError(f"both ends are {a}", hint="a leg joins two different points")
    return a, b
