"""What was discovered, as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.algebra.discovery.result import Discoveries, Discovery, KindOfPositions
from gcrules.algebra.letter_forms import FORMS
from gcrules.core.english import listed
from gcrules.views.formulas.latex_text import latex_words

__all__ = ["as_latex", "as_text"]


def as_text(found: Discoveries, *, unicode: bool = False) -> str:
    """How much was looked at, each discovery with its verdict, and for which positions they are proved."""
    lines = [_counted(found), *(line for d in found.found for line in _told(d, found.kinds))]
    return "\n".join([*lines, *_conditions(found)] if found.found else lines)


def _counted(found: Discoveries) -> str:
    number = len(found.found)
    what = f"{number} {'discovery' if number == 1 else 'discoveries'}" if number else "nothing new"
    among = [_number(len(found.points), "point")] if found.points or not found.flats else []
    among += [f"the lines and planes {', '.join(found.flats)}"] if found.flats else []
    if found.conics:
        word = FORMS[found.rank].word
        among.append(f"the {word}{'s' if len(found.conics) > 1 else ''} {', '.join(found.conics)}")
    return f"{what} among {listed(among)} ({found.candidates:,} candidates, {found.trivial} trivial incidences)"


def _number(n: int, what: str) -> str:
    return f"{n} {what}{'' if n == 1 else 's'}"


def _told(d: Discovery, kinds: tuple[KindOfPositions, ...]) -> Iterator[str]:
    yield f"{d.verdict}: {d.claim}"
    if len(set(d.verdicts)) > 1:
        for kind, verdict in zip(kinds, d.verdicts, strict=True):
            yield f"  where {_where(kind)}: {verdict}"
    if d.reason:
        yield f"  {d.reason}"
    if d.fails:
        yield f"  fails at some positions where {', or '.join(f'{e} == 0' for e in d.fails)}"


def _where(kind: KindOfPositions) -> str:
    return " and ".join(f"{e} == 0" for e in kind.where)


def _conditions(found: Discoveries) -> Iterator[str]:
    """What is assumed not to vanish, for each kind of positions."""
    several = len(found.kinds) > 1
    if several:
        yield "the assumptions allow several kinds of positions"
    for kind in found.kinds:
        meanings = kind.meanings or [""] * len(kind.assumed)
        shown = [f"{e} ({m})" if m else e for e, m in zip(kind.assumed, meanings, strict=True)]
        told = [f"assumed not to vanish: {', '.join(shown)}"] if shown else []
        told += [f"{a} and {b} coincide there, which the assumptions do not say" for a, b in kind.together]
        told += [f"left out, since they vanish: {', '.join(kind.vanishing)}"] if kind.vanishing else []
        if several:
            yield f"  where {_where(kind)}{': ' if told else ''}{'; '.join(told)}"
        else:
            yield from told


def as_latex(found: Discoveries) -> str:
    """One row for each discovery in an `aligned` environment (package amsmath), without dollar signs."""
    rows = " \\\\\n".join(_row(d) for d in found.found) or "&\\text{nothing new}"
    return f"\\begin{{aligned}}\n{rows}\n\\end{{aligned}}"


def _row(d: Discovery) -> str:
    return f"&\\text{{{latex_words(d.claim)}}} && \\text{{{d.verdict}}}"
