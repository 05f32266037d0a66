r"""A region that is free of singular poses, as text and as LaTeX: its ranges, and where the proof ended."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, floor, log10

from gcrules.poses.regions.report import FreeRegion
from gcrules.views.formulas.latex_text import latex_table, latex_words
from gcrules.views.results.result_account import Facts, Grid, ResultAccount
from gcrules.views.text_tables import ASCII, table, wrapped

__all__ = ["account", "as_latex", "as_text", "facts", "ranges"]


def as_text(r: FreeRegion, *, unicode: bool = False) -> str:
    """The whole answer; without `unicode` in ASCII."""
    found = "\n".join(_lines(r))
    return found if unicode else found.translate(ASCII)


def account(r: FreeRegion) -> ResultAccount:
    """What there is to say of it."""
    grid = Grid(("coordinate", "from", "to", "unit"), tuple(ranges(r)))
    return ResultAccount(_verdict(r), (grid, Facts(tuple(facts(r)))))


def ranges(r: FreeRegion) -> Iterator[tuple[str, str, str, str]]:
    """Name, least and largest value, and unit of each coordinate that may change."""
    for name, angle, (low, high) in zip(r.names, r.angles, r.ranges.values(), strict=True):
        if high > low:
            yield name, _inside(low, angle), _inside(high, angle, -1), _unit(r, angle)


def _lines(r: FreeRegion) -> Iterator[str]:
    yield from wrapped(f"{_verdict(r).removesuffix('.')}:")
    for name, low, high, unit in ranges(r):
        yield f"  {low} ≤ {name} ≤ {high} {unit}".rstrip()
    yield ""
    yield from table([*facts(r)])


def _verdict(r: FreeRegion) -> str:
    what = "configuration" if r.driven else "pose"
    words = f"Proved: no {what} of this {r.shape} around {r.pose} is singular"
    if r.driven:
        words += ", and each value of the actuators in it has exactly one on the branch of its middle"
    widths = [w for w in r.weights if w]
    if r.shape == "ball" and len(widths) > 1:
        words += ". Its half axes are half of these ranges"
    return f"{words}."


def facts(r: FreeRegion) -> Iterator[tuple[str, str]]:
    """What is fixed, where the proof ended, and how it was made."""
    others = [n for n, w in zip(r.names, r.weights, strict=True) if not w]
    if others:
        fixed = zip(r.names, r.angles, r.centre, strict=True)
        yield "fixed", ", ".join(f"{n} = {_number(c, a)} {_unit(r, a)}".rstrip() for n, a, c in fixed if n in others)
    if r.tried is None:
        yield "larger", "not tried: it is as large as angles and the robot's size allow"
    else:
        where = ", ".join(
            f"{n}={_number(v, a)}{'deg' if a else ''}"
            for (n, v), a, w in zip(r.worst.items(), r.angles, r.weights, strict=True)
            if w
        )
        times = r.tried / r.scale
        if r.margin > 0:
            words = f"{times:.4g} times as large was not proved with this many boxes: at {where} the margin is"
            yield "larger", f"{words} {r.margin:.3g}"
        else:
            yield "larger", f"{times:.4g} times as large is not free: at {where} the robot is singular, or past that"
    yield "proof", f"{r.boxes:,} boxes cover it, in each of which nothing is singular"
    for note in r.notes:
        yield "note", note


def _number(value: float, angle: bool) -> str:
    return f"{degrees(value) if angle else value:.6g}"


def _inside(value: float, angle: bool, side: int = 1) -> str:
    """An end of a range with few digits, rounded to the inside: the low one up, the high one, on the side −1, down."""
    shown = degrees(value) if angle else value
    digits = f"{shown:.6g}"
    if (float(digits) - shown) * side < 0:
        step = 10.0 ** (floor(log10(abs(shown))) - 5)
        digits = f"{shown + side * step:.6g}"
    return digits


def _unit(r: FreeRegion, angle: bool) -> str:
    return "deg" if angle else r.unit


def as_latex(r: FreeRegion) -> str:
    """A tabular of the ranges; needs no package."""
    rows = [("free of singular poses, proved", f"{r.shape} around {latex_words(r.pose)}")]
    for name, low, high, unit in ranges(r):
        rows.append((f"${name}$", f"${low}$ to ${high}$ {latex_words(unit)}".rstrip()))
    return latex_table(rows)
