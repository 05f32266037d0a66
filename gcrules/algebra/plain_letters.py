r"""Data for other programs in which the points of letters have names that the language reads: K1 and K2 for K₁ and K₂.

A reading may name points of a letter alone, and nobody can write their names. In data they are points as others are,
and the key `letters` says what each letter is: after `let K = K1 \/ K2` every text of the data can be read.

>>> in_plain_letters({"expression": "[abc K₁](K /\\ L)"}, ["K₁", "K₂", "L₁", "L₂", "L1", "a", "b", "c"])
{'expression': '[abc K1](K /\\ L)', 'letters': {'K': 'K1 \\/ K2', 'L': "L1' \\/ L2"}}
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from gcrules.algebra.expr import points_of
from gcrules.algebra.letters import letter_of, letters_of, names_of, plain_name
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
    letters = letters_of(names)
    if not letters:
        return data
    taken = {*letters, *(n for n in names if letter_of(n) is None)}
    plain: dict[str, str] = {}
    for point in (n for name, step in letters.items() for n in names_of(name, step)):
        chosen = plain_name(point)
        while chosen in taken:
            chosen += "'"
        taken.add(chosen)
        plain[point] = chosen
    marked = re.compile("|".join(rf"(?<![\w']){re.escape(n)}(?![₀-₉])" for n in sorted(plain, key=len, reverse=True)))
    said = {name: " \\/ ".join(plain[n] for n in names_of(name, step)) for name, step in letters.items()}
    return {**_renamed(data, marked, plain), "letters": said}


def _renamed(value: Any, marked: re.Pattern[str], plain: Mapping[str, str]) -> Any:
    if isinstance(value, str):
        return marked.sub(lambda found: plain[found[0]], value)
    if isinstance(value, Mapping):
        return {_renamed(k, marked, plain): _renamed(v, marked, plain) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [_renamed(v, marked, plain) for v in value]
    return value
