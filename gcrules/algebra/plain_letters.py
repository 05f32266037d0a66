r"""Data for other programs in which the points of letters have names that the language reads: K1 and K2 for K₁ and K₂.

A reading may name points of a letter alone, and nobody can write their names. In data they are points as others are,
and the key `letters` says what each letter is: after `let K = K1 \/ K2` every text of the data can be read.

>>> in_plain_letters({"expression": "[abc K₁](K /\\ L)"}, ["K₁", "K₂", "L₁", "L₂", "L1", "a", "b", "c"])
{'expression': '[abc K1](K /\\ L)', 'letters': {'K': 'K1 \\/ K2', 'L': "L1' \\/ L2"}}
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from gcrules.algebra.expr import points_of
from gcrules.algebra.letters import letters_of, marked, names_of, plain_name
from gcrules.algebra.names import primed
from gcrules.algebra.screw_letters import screw_points, screws_of
from gcrules.algebra.structure import Structure

__all__ = ["in_plain_letters", "names_in"]


def names_in(structure: Structure) -> tuple[str, ...]:
    """The points of legs, those of lines that are built, and those of what is assumed."""
    built = (line for _, line in structure.stand_ins)
    given = (e for a in structure.given for e in a.args)
    return tuple(dict.fromkeys((*structure.names, *points_of(*built, *given))))


def in_plain_letters(data: dict[str, Any], names: Iterable[str]) -> dict[str, Any]:
    """The data with plain names for the points of the letters that are among the names, and the key `letters`; as they
    are where there are none. A name that is taken already gets a prime.
    """
    names = tuple(names)
    screws = screws_of(names)
    letters = {name: names_of(name, step) for name, step in letters_of(names).items()}
    letters |= {name: screw_points(name) for name in screws}
    if not letters:
        return data
    taken = {*letters, *(n for n in names if not marked(n))}
    plain: dict[str, str] = {}
    for point in (n for points in letters.values() for n in points):
        chosen = primed(plain_name(point), taken.__contains__)
        taken.add(chosen)
        plain[point] = chosen
    some = re.compile("|".join(rf"(?<![\w']){re.escape(n)}(?![₀-₉])" for n in sorted(plain, key=len, reverse=True)))
    said = {name: _joined([plain[n] for n in points], name in screws) for name, points in letters.items()}
    return {**_renamed(data, some, plain), "letters": said}


def _joined(points: Sequence[str], screw: bool) -> str:
    """The join of points, or for a screw the sum of two lines."""
    return " + ".join(_joined(points[i : i + 2], False) for i in (0, 2)) if screw else " \\/ ".join(points)


def _renamed(value: Any, some: re.Pattern[str], plain: Mapping[str, str]) -> Any:
    if isinstance(value, str):
        return some.sub(lambda found: plain[found[0]], value)
    if isinstance(value, Mapping):
        return {_renamed(k, some, plain): _renamed(v, some, plain) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [_renamed(v, some, plain) for v in value]
    return value
