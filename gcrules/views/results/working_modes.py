"""The working modes of a robot, as text and as LaTeX."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gcrules.core.english import listed
from gcrules.poses.modes.working import WorkingMode, WorkingModes
from gcrules.views.formulas.latex_text import latex_table, latex_words
from gcrules.views.results.path_account import verdicts_and_margins
from gcrules.views.results.result_account import Grid, ResultAccount, Sentences
from gcrules.views.text_tables import ASCII, wrapped

__all__ = ["account", "amounts", "as_latex", "as_text", "ways"]


def as_text(w: WorkingModes, *, unicode: bool = False) -> str:
    """All modes that are listed; without `unicode` in ASCII."""
    found = "\n".join(_lines(w))
    return found if unicode else found.translate(ASCII)


def account(w: WorkingModes) -> ResultAccount:
    """What there is to say of them."""
    rows = _table(w)
    faults = tuple(f"{mode.name}: {mode.fault}" for mode in w.modes if mode.fault)
    return ResultAccount(
        _verdict(w),
        (
            Sentences(tuple(ways(w)), _WAYS),
            Grid(tuple(rows[0]), tuple(map(tuple, rows[1:]))),
            *([Sentences(faults)] if faults else []),
            Sentences(tuple(_sure(w))),
        ),
    )


def _verdict(w: WorkingModes) -> str:
    met = [mode.pose for mode in w.modes if mode.pose is not None]
    numbers = verdicts_and_margins([p.verdict for p in met], [p.margin for p in met])
    some = "of those listed " * (len(w) + w.missing < w.number)
    return f"{w.title} ({w.robot}): {_counted(w)}, at {w.target}; {some}{numbers}. {_UNPROVED}"


_UNPROVED = "That there are no others is not proved."
_WAYS = "Ways of each limb to hold the platform where it is at home"


def _lines(w: WorkingModes) -> Iterator[str]:
    yield from wrapped(_verdict(w))
    yield ""
    yield _WAYS
    for words in ways(w):
        yield from wrapped(words, "  ", "    ")
    yield ""
    rows = _table(w)
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    for row in rows:
        yield ("  " + "  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True))).rstrip()
    for mode in w.modes:
        if mode.fault:
            yield from wrapped(f"{mode.name}: {mode.fault}", "  ", "    ")
    yield ""
    for words in _sure(w):
        yield from wrapped(words)


def _sure(w: WorkingModes) -> Iterator[str]:
    yield (
        f"Drives are from the home of the file. The ways were found from {w.starts} random places of the joints of each"
        " limb."
    )
    if len(w) + w.missing < w.number:
        yield "Listed are home's mode and those that differ from it in one limb."


def _counted(w: WorkingModes) -> str:
    words = "one working mode" if w.number == 1 else f"{w.number:,} working modes"
    if not w.missing:
        return words
    left = "1 of them leaves" if w.missing == 1 else f"{w.missing:,} of them leave"
    return f"{words}, but {left} the family that the file describes"


def ways(w: WorkingModes) -> Iterator[str]:
    """How many ways the limbs have, those alike together: "arm 1, arm 2 and arm 3: 2 ways each"."""
    alike: dict[str, list[str]] = {}
    for limb in w.limbs:
        if limb.moving:
            words = "can move with the platform at rest, so that its ways have no number"
        elif limb.ways == 1:
            words = "1 way"
        else:
            words = f"{limb.ways} ways"
        alike.setdefault(words, []).append(limb.limb)
    for words, limbs in alike.items():
        yield f"{listed(limbs)}: {words}{' each' if len(limbs) > 1 and words[0].isdigit() else ''}"


def _table(w: WorkingModes) -> list[list[str]]:
    rows = [["mode", "verdict", "margin", "signs", *(a.name for a in w.actuators)]]
    rows += [_row(w, mode) for mode in w.modes]
    if not any(row[3] for row in rows[1:]):
        rows = [[*row[:3], *row[4:]] for row in rows]
    return rows


def _row(w: WorkingModes, mode: WorkingMode) -> list[str]:
    if mode.pose is None:
        return [mode.name, "not followed", "", "", *("" for _ in w.actuators)]
    return [mode.name, mode.pose.verdict, f"{mode.pose.margin:.4g}", mode.signs.replace("-", "−"), *amounts(w, mode)]


def amounts(w: WorkingModes, mode: WorkingMode) -> list[str]:
    """The amounts of the actuators, from the home of the file."""
    drives = mode.drives
    return [
        f"{round(math.degrees(drives[a.name]), 2) + 0.0:.4g}°" if a.angle else f"{drives[a.name]:.4g}"
        for a in w.actuators
    ]


def as_latex(w: WorkingModes) -> str:
    """A tabular: verdict and margin of each mode; needs no package."""
    rows = [("robot", latex_words(f"{w.title}, {_counted(w)}"))]
    for mode in w.modes:
        numbers = "not followed" if mode.pose is None else f"{mode.pose.verdict}, margin {mode.pose.margin:.4g}"
        rows.append((latex_words(mode.name), numbers))
    return latex_table(rows)
