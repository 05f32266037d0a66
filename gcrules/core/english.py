r"""Lists and numbers in sentences, and the words that agree with them."""

from __future__ import annotations

import re
from collections.abc import Sequence

__all__ = [
    "agreeing",
    "as_sentence",
    "counted",
    "in_parts",
    "lettered",
    "listed",
    "of_kind",
    "together",
    "with_article",
]


def listed(names: Sequence[str]) -> str:
    """ "ab, cd and ef", each name once."""
    names = list(dict.fromkeys(names))
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def counted(number: int, noun: str) -> str:
    """ "1 pose", "26,463 poses"; the plural is made with s."""
    return f"{number:,} {noun}{'s' * (number != 1)}"


def agreeing(names: Sequence[str], one: str, several: str) -> str:
    """A list with its verb: `one` is what is said of one of them, `several` of more.

    >>> agreeing(["leg 1"], "is", "are"), agreeing(["leg 1", "leg 2", "leg 3"], "is", "are")
    ('leg 1 is', 'leg 1, leg 2 and leg 3 are')
    """
    return f"{listed(names)} {one if len(dict.fromkeys(names)) == 1 else several}"


def as_sentence(words: str) -> str:
    """ "Proved, all of it." of "proved, all of it"; nothing of nothing."""
    return f"{words[:1].upper()}{words[1:]}." if words else ""


def in_parts(words: str) -> tuple[str, ...]:
    """A statement as it stands, or sentence by sentence where it is long.

    >>> in_parts("One. Two."), [len(part) for part in in_parts(f"{'So it is, ' * 30}yes. And so on.")]
    (('One. Two.',), [304, 10])
    """
    return tuple(_NEXT_SENTENCE.split(words)) if len(words) > _LONG else (words,)


_LONG = 280  # characters that are read in one go
_NEXT_SENTENCE = re.compile(r"(?<=[a-z0-9)]\.) (?=[A-Z])")


def lettered(n: int) -> str:
    """A, B, ..., Z, AA, AB, ..., counted from 0."""
    return ("" if n < 26 else lettered(n // 26 - 1)) + chr(ord("A") + n % 26)


def of_kind(kind: str, names: Sequence[str]) -> str:
    """ "the plane abc", "the planes abc and bcd"; nothing of nothing."""
    return f"the {kind}{'s' * (len(dict.fromkeys(names)) > 1)} {listed(names)}" if names else ""


def together(items: Sequence[str]) -> str:
    """ "the lines Aa and Bb and the direction i" of "line Aa", "line Bb", "direction i"."""
    kinds: dict[str, list[str]] = {}
    others = []
    for item in items:
        kind, _, name = item.partition(" ")
        if kind in ("line", "direction"):
            kinds.setdefault(kind, []).append(name)
        else:
            others.append(item)
    return listed([*(of_kind(kind, names) for kind, names in kinds.items()), *others])


def with_article(noun: str) -> str:
    """ "a leg", "an actuator"."""
    return f"{'an' if noun[:1].lower() in 'aeio' else 'a'} {noun}"
