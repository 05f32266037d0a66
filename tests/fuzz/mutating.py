"""Mutations of texts: of characters, of words, of lines, of numbers; what people mistype and what breaks readers."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from fractions import Fraction
from random import Random

__all__ = ["NUMBERS", "mutated", "mutated_numbers", "one_of", "scaled"]

NUMBERS = (
    *("0", "-0", "1", "-1", "2", "1/2", "-3/7", "0.1", "1e-3", "100", "650", "3.14159265358979", "1e6", "1e-9", "1e12"),
    *("1e-30", "1e30", "1e100", "1e-160", "1e160", "1e-308", "1e308", "5e-324", "1e309", "-1e309", "1e400", "1e999999"),
    *(".inf", "-.inf", ".nan", "nan", "inf", "Infinity", "NaN", "1/0", "0/0", "0/1", "1/-2", "1//2", "1 /2"),
    *("9" * 30, "1" + "0" * 310, "1/" + "9" * 40, "0." + "0" * 40 + "1", "123456789012345678901/3", "7" * 2100),
    *(
        "0x10",
        "0o17",
        "0b1",
        "010",
        "1_000",
        "1,5",
        "1.2.3",
        "--1",
        "+1",
        "1.",
        ".5",
        "1e",
        "e5",
        "½",
        "٣",
        "१",
        "1:30",
    ),
    *("true", "null", "~", "", "[]", "{}", "[1]", "a", "'1'", '"1/3"', "sqrt(3)", "2*pi", "(1)", "1 mm", "1mm", "- 1"),
)

_LIKELY = (
    *("0", "1", "-1", "2", "1/2", "-1/3", "0.1", "100", "650", "1e-3", "1e6", "-1e6", "1e-9", "1e12", "1e20", "1e-20"),
    *("1e30", "-1e30", "1e-30", "1e25", "-1e15", "3.14159265358979", "1/1000000007", "123456789/987654321"),
)
"""Numbers that are read; the others mostly are not."""

_CHARACTERS = (
    *"abzAZ019 ',.:;-+*/\\^()[]{}<>=!?#%&|@$~`\"_\n\t\r",
    *("\0", "\x07", "\x1b", "\x7f", "\x85", "\xa0", "\u2028", "\u202e", "\u200b", "\ufeff", "\u0307", "\U0001d538"),
    *("∧", "∨", "−", "·", "×", "…", "ȧ", "é", "ß", "İ", "ſ", "²", "½", "\udc80", "\udcff", "字", "🤖"),
)
_WORD = re.compile(r"\w+|\s+|[^\w\s]")
_NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e-?\d+)?(?:/\d+)?(?![\w.])")


def one_of(rng: Random, table: Sequence[tuple[float, Callable[[], str]]]) -> str:
    """The text of one of several makers, by weight."""
    weights = [w for w, _ in table]
    return rng.choices([make for _, make in table], weights)[0]()


def mutated(rng: Random, text: str, words: Sequence[str] = (), *, most: int = 3) -> str:
    """A text with one to `most` mutations; `words` may come in."""
    for _ in range(rng.randint(1, most)):
        text = rng.choices(_MUTATIONS, _WEIGHTS)[0](rng, text, words)
    return text[:200_000]


def mutated_numbers(rng: Random, text: str, *, most: int = 2) -> str:
    """A text in which one to `most` numbers are others."""
    for _ in range(rng.randint(1, most)):
        text = _number(rng, text, ())
    return text


def scaled(rng: Random, text: str) -> str:
    """A text in which all points [x, y, z] are nearer or farther by one factor: relations between them hold on."""
    factor = Fraction(10) ** rng.choice((-26, -20, -12, -6, -2, 2, 6, 9, 12, 16, 20, 26))

    def point(found: re.Match[str]) -> str:
        numbers = (Fraction(found[i].strip()) * factor for i in (1, 2, 3))
        return f"[{', '.join(map(_written, numbers))}]"

    return _POINT.sub(point, text)


def _written(number: Fraction) -> str:
    """As short as it can be; exact where that is short."""
    return str(number) if len(str(number)) < 20 else f"{float(number):.12e}"


_POINT = re.compile(r"\[(-?[\d./]+), *(-?[\d./]+), *(-?[\d./]+)\]")


def _place(rng: Random, parts: Sequence[str]) -> int:
    return rng.randrange(len(parts)) if parts else 0


def _character(rng: Random, text: str, words: Sequence[str]) -> str:
    at = rng.randint(0, len(text))
    return text[:at] + rng.choice(_CHARACTERS) * rng.choice((1, 1, 1, 2, 40)) + text[at + rng.randint(0, 1) :]


def _without_character(rng: Random, text: str, words: Sequence[str]) -> str:
    at = rng.randint(0, max(0, len(text) - 1))
    return text[:at] + text[at + rng.choice((1, 1, 1, 2, 5)) :]


def _with_words(change: Callable[[Random, list[str], Sequence[str]], None]) -> Callable[..., str]:
    def mutate(rng: Random, text: str, words: Sequence[str]) -> str:
        parts = _WORD.findall(text) or [""]
        change(rng, parts, words)
        return "".join(parts)

    return mutate


def _drop(rng: Random, parts: list[str], words: Sequence[str]) -> None:
    at = _place(rng, parts)
    del parts[at : at + rng.choice((1, 1, 2, 3))]


def _double(rng: Random, parts: list[str], words: Sequence[str]) -> None:
    at = _place(rng, parts)
    end = at + rng.choice((1, 1, 2, 5))
    parts[end:end] = parts[at:end] * rng.choice((1, 1, 1, 2, 8))


def _swap(rng: Random, parts: list[str], words: Sequence[str]) -> None:
    i, j = _place(rng, parts), _place(rng, parts)
    parts[i], parts[j] = parts[j], parts[i]


def _replace(rng: Random, parts: list[str], words: Sequence[str]) -> None:
    parts[_place(rng, parts)] = rng.choice(words) if words and rng.random() < 0.7 else rng.choice(parts)


def _insert(rng: Random, parts: list[str], words: Sequence[str]) -> None:
    parts.insert(_place(rng, parts), rng.choice(words) if words and rng.random() < 0.7 else rng.choice(parts))


def _with_lines(change: Callable[[Random, list[str]], None]) -> Callable[..., str]:
    def mutate(rng: Random, text: str, words: Sequence[str]) -> str:
        lines = text.split("\n")
        change(rng, lines)
        return "\n".join(lines)

    return mutate


def _drop_line(rng: Random, lines: list[str]) -> None:
    del lines[_place(rng, lines)]


def _double_line(rng: Random, lines: list[str]) -> None:
    lines.insert(_place(rng, lines), rng.choice(lines))


def _swap_lines(rng: Random, lines: list[str]) -> None:
    i, j = _place(rng, lines), _place(rng, lines)
    lines[i], lines[j] = lines[j], lines[i]


def _indent(rng: Random, lines: list[str]) -> None:
    at = _place(rng, lines)
    lines[at] = rng.choice((" ", "  ", "\t", "    ")) + lines[at] if rng.random() < 0.6 else lines[at].lstrip()


def _truncate(rng: Random, text: str, words: Sequence[str]) -> str:
    return text[: rng.randint(0, len(text))]


def _number(rng: Random, text: str, words: Sequence[str]) -> str:
    found = list(_NUMBER.finditer(text))
    if not found:
        return text
    at = rng.choice(found)
    new = rng.choices((rng.choice(_LIKELY), rng.choice(NUMBERS), str(rng.randint(-9, 9))), (4, 3, 3))[0]
    return text[: at.start()] + new + text[at.end() :]


def _bytes(rng: Random, text: str, words: Sequence[str]) -> str:
    return rng.choice(
        ("\ufeff" + text, text.replace("\n", "\r\n"), text.replace("\n", "\r"), text + "\0", "\udcff" + text)
    )


_MUTATIONS = (
    *(_character, _without_character, _truncate, _number, _bytes),
    *map(_with_words, (_drop, _double, _swap, _replace, _insert)),
    *map(_with_lines, (_drop_line, _double_line, _swap_lines, _indent)),
)
_WEIGHTS = (3, 3, 0.5, 4, 0.3, 3, 2, 2, 5, 3, 2, 1, 1, 1)
