"""What there is to say of a path, of any kind of mechanism: verdict, singular places, proof; and that as text."""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Sequence

from gcrules.core.dataclass import dataclass
from gcrules.views.detail import first, naming_options

__all__ = [
    "PathAccount",
    "PathPlace",
    "PathStretch",
    "account_lines",
    "in_ascii",
    "listed_verdicts",
    "verdicts_and_margins",
    "wrapped",
]

WIDTH = 100
_MOST = 40  # places that are explained; the JSON object holds all
_ASCII = str.maketrans({"σ": "sigma", "°": " deg", "∧": "/\\", "∨": "\\/", "…": "...", "⁻": "^-", "≤": "<="})


@dataclass(frozen=True)
class PathPlace:
    """A singular place at about this `parameter`, `exactly` that where it is a fraction: what happens there, its `pose`
    as text for `--at`, and sentences: why, what the platform gains, how `sure` it is.
    """

    parameter: float
    exactly: str
    kind: str
    pose: str
    causes: tuple[str, ...]
    motions: tuple[str, ...]
    sure: str = ""


@dataclass(frozen=True)
class PathStretch:
    """From one parameter to another every pose is singular, or it is not decided whether one is; `words` say which."""

    start: float
    end: float
    singular: bool
    words: str
    causes: tuple[str, ...] = ()
    motions: tuple[str, ...] = ()


@dataclass(frozen=True)
class PathAccount:
    """The verdict with its reason, what is singular or not decided, and `facts`, names with what they say, among them
    the proof.
    """

    verdict: str
    reason: str
    places: tuple[PathPlace, ...]
    stretches: tuple[PathStretch, ...]
    facts: tuple[tuple[str, str], ...]


def account_lines(a: PathAccount) -> Iterator[str]:
    """The account as lines of text; the reason tells the stretches that are not decided."""
    yield from wrapped(f"{a.verdict}: {a.reason}")
    singular = [s for s in a.stretches if s.singular]
    if a.places or singular:
        yield ""
        yield "Singular places"
    for s in singular:
        yield from wrapped(f"parameter {s.start} to {s.end}: {s.words}; half way:", "  ")
        yield from _sentences(*s.causes, *s.motions)
    shown = first(a.places, _MOST)
    for n, p in enumerate(shown, 1):
        yield from wrapped(f"{n}. at parameter {p.parameter:.6g}{p.exactly}: {p.kind}", "  ", " " * 5)
        yield from _sentences(f'pose "{p.pose}"', *p.causes, *p.motions, *filter(None, [p.sure]))
    if len(a.places) > len(shown):
        yield f"  and {len(a.places) - len(shown)} more{naming_options(', which --full shows')}"
    yield ""
    width = max(len(name) for name, _ in a.facts)
    for name, value in a.facts:
        yield from wrapped(value, f"{name:<{width}}  ", " " * (width + 2))


def _sentences(*listed: str) -> Iterator[str]:
    for one in listed:
        yield from wrapped(one, "     ", " " * 7)


def in_ascii(text: str) -> str:
    """The text without signs of mathematics."""
    return text.translate(_ASCII)


def listed_verdicts(verdicts: Sequence[str]) -> str:
    """ "180 regular, 20 close"."""
    return ", ".join(f"{verdicts.count(v)} {v}" for v in ("regular", "close", "singular") if v in verdicts)


def verdicts_and_margins(verdicts: Sequence[str], margins: Sequence[float]) -> str:
    """ "7 regular, 1 close, σ from 0.003 to 0.6".

    >>> verdicts_and_margins(["regular", "regular"], [0.5, 0.25])
    '2 regular, σ from 0.25 to 0.5'
    """
    ends = tuple(dict.fromkeys(f"{m:.4g}" for m in (min(margins), max(margins))))
    return f"{listed_verdicts(verdicts)}, σ {'= ' if len(ends) == 1 else 'from '}{' to '.join(ends)}"


def wrapped(text: str, first: str = "", rest: str | None = None) -> list[str]:
    """The text in lines, the first of them behind `first`, the others behind `rest`."""
    other = first + "  " if rest is None else rest
    return textwrap.wrap(
        text, WIDTH, initial_indent=first, subsequent_indent=other, break_long_words=False, break_on_hyphens=False
    )
