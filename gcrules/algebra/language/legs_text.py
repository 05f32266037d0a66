r"""Reading legs: from text or pairs of names to a structure.

>>> s = read_legs("ab af cb cd ed ef")
>>> s.base, s.platform
(('a', 'c', 'e'), ('b', 'd', 'f'))
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.line_text import Leg, read_line, split_lines
from gcrules.algebra.language.statements import parse_assumption, parse_letters
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import Names, split_names
from gcrules.algebra.language.text import text as as_text
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conics_of, letters_of
from gcrules.algebra.screw_letters import screws_of
from gcrules.algebra.structure import NoLine, Structure, leg_text, legs_text
from gcrules.core.errors import GcrulesError, InputError, Span

__all__ = ["Leg", "Structure", "leg_text", "legs_text", "read_legs", "read_order"]

_FILE = "the file of a platform or of a robot is read by gc.load"


def read_legs(
    legs: str | Iterable[str | Sequence[str] | Expr],
    *,
    points: Names = (),
    ideal: Names = (),
    given: str | Iterable[str] = (),
    letters: str = "",
    rank: int = 4,
    built: bool = False,
) -> Structure:
    """Six legs from text ("ab af cb cd ed ef", "S1A1, S2A2, …", "left top, right top, …") or pairs of names.

    With `built` a leg may be a line built from points, in text or as an expression: "abc /\\ def". `given` holds
    what is assumed, as `gcrules.prove` takes it; a letter that `letters` or `given` declares by "line L" is a leg by
    itself; points that only help to say it are declared in `points`. In another `rank` there are n (n − 1) / 2 lines.
    Raises InputError (with its place in the text) for anything else.
    """
    points = split_names(points)
    at = Context(rank, points, split_names(ideal))
    at = parse_letters(letters, at) if letters else at
    for written in filter(str.strip, [given] if isinstance(given, str) else given):
        at = parse_assumption(written, at)
    if at.conics:
        raise _of_conics(legs if isinstance(legs, str) else "", at)
    of_screw = next((a for a in at.given if screws_of(points_of(*a.args))), None)
    if of_screw is not None:
        what = f"{of_screw} is said of a screw, and what is assumed of legs is said of their points"
        raise InputError(what, hint="`prove` takes it, with a claim about the screw")
    reading = Context(rank, points, letters=at.letters, screws=at.screws)
    if isinstance(legs, str):
        found = tuple(_read_text(legs, reading, built))
        source: str | None = legs
    else:
        found = tuple(_read_item(item, reading, built) for item in legs)
        source = None
    try:
        structure = _with_stand_ins(found, at)
        if structure.given or structure.stand_ins:
            structure.construction  # noqa: B018  faults show here, where the text is known
        return structure
    except NoLine as wrong:
        if source is not None:
            raise wrong.located(source, span=list(split_lines(source))[wrong.number][1]) from None
        raise
    except GcrulesError as wrong:
        if source is not None and wrong.source is None:
            raise wrong.located(source, span=Span(0, len(source))) from None
        raise


def _of_conics(legs: str, at: Context) -> InputError:
    """That legs are not conics or quadrics, and what is assumed of them is not said of such."""
    word = FORMS[at.rank].word
    for text, span in split_lines(legs):
        if text in at.conics:
            return InputError(f"{text} is a {word}, not a leg", span=span, source=legs)
    what = f"{at.conics[0]} is a {word}, and what is assumed of legs is said of their points"
    hint = FORMS[at.rank].by_points
    place = next((a.place for a in at.given if conics_of(points_of(*a.args)) and a.place is not None), None)
    if place is None:
        return InputError(what, hint=hint)
    return InputError(what, hint=hint, span=place.span, source=place.source, filename=place.filename)


def _with_stand_ins(found: Sequence[Leg | Expr], at: Context) -> Structure:
    """Lines that are no pairs of joints get two points whose names the user has not used."""
    used = {n for line in found for n in (points_of(line) if isinstance(line, Expr) else line)}
    used |= {*at.declared(), *(n for a in at.given for n in points_of(*a.args))}
    letters = [c for c in "uvwxyzqrst" if not any(n.startswith(c) for n in used)]
    first, second = letters[:2] if len(letters) > 1 else ("u_stands_in_", "v_stands_in_")
    legs, stand_ins = [], []
    for number, line in enumerate(found, 1):
        if isinstance(line, Expr):
            stand_ins.append(((f"{first}{number}", f"{second}{number}"), line))
            legs.append(stand_ins[-1][0])
        else:
            legs.append(line)
    return Structure(tuple(legs), at.points, at.ideal, at.given, at.rank, tuple(stand_ins))


def _read_text(text: str, at: Context, built: bool = True) -> Iterator[Leg | Expr]:
    for word, span in split_lines(text):
        try:
            yield _line(re.sub(r"(?<=[\w'])\s*[-–]\s*(?=\w)", " ", word), at, built)
        except GcrulesError as fault:
            hint = _FILE if re.search(r"\.ya?ml\s*$", text, re.IGNORECASE) else fault.hint
            inner = InputError(f"{word!r} is not a leg: {fault.message}", hint=hint)
            raise inner.located(text, span=span) from None


def _read_item(item: str | Sequence[str] | Expr, at: Context, built: bool) -> Leg | Expr:
    """A leg from a pair, a text or an expression."""
    if isinstance(item, Expr):
        return _line(as_text(item, names=at.points), at, built)
    if isinstance(item, str):
        return _line(item, at, built)
    pair: Any = item  # whatever a caller's list holds
    if not isinstance(pair, Sequence) or len(pair) != 2 or not all(isinstance(n, str) for n in pair):
        raise InputError(f"{item!r} is not a leg; expected two points")
    return _line(" ".join(pair), replace(at, points=(*at.points, *pair)))


def _line(word: str, at: Context, built: bool = True) -> Leg | Expr:
    return read_line(word, at.points, at.rank, built, at.letters, at.screws)


def _reading(structure: Structure) -> Context:
    """What the legs are read with: the points and the letters among them."""
    letters = letters_of(n for leg in structure.legs for n in leg)
    screws = screws_of(structure.names)
    return Context(points=structure.points, letters={**letters, **dict.fromkeys(screws, 2)}, screws=screws)


def read_order(text: str | Sequence[int | str], structure: Structure) -> tuple[int, ...]:
    """An order of the legs: numbers "2 1 3 4 6 5" counted from 1, or the legs themselves "af ab cb cd ed ef".

    Integers in a sequence are positions counted from 0. Raises InputError unless every leg occurs once.
    """
    words: Iterable[int | str | Leg | Expr] = text
    if isinstance(text, str):
        numbers = re.fullmatch(r"[\d\s,]+", text)
        words = re.findall(r"\d+", text) if numbers else _read_text(text, _reading(structure))
    places: dict[Leg | Expr, int] = {line: i for i, line in enumerate(structure.lines)}
    places |= {end: i for i, (a, b) in enumerate(structure.legs) for end in ((a, b), (b, a))}
    order = []
    for word in words:
        if isinstance(word, int):
            order.append(word)
        elif isinstance(word, str) and word.isdigit():
            order.append(int(word) - 1)
        else:
            leg = _line(word, _reading(structure)) if isinstance(word, str) else word
            if leg not in places:
                raise InputError(f"{leg if isinstance(leg, Expr) else leg_text(leg)} is not one of the legs")
            order.append(places[leg])
    if sorted(order) != list(range(len(structure.legs))):
        raise InputError("an order names each of the six legs once", hint='for example --order "2 1 3 4 5 6"')
    return tuple(order)
