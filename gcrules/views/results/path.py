r"""A path's report as plain text and as LaTeX: the verdict, the singular places with causes, what is proved and how."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Iterator, Sequence

from gcrules.poses.numbers.motion import Dependence
from gcrules.poses.paths.report import PathReport, Zero
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import degrees, turn_of
from gcrules.views.formulas.latex_text import latex_quantity, latex_table

__all__ = ["as_latex", "as_text", "in_ascii", "listed_verdicts", "wrapped"]

WIDTH = 100
_MOST = 40  # places that are explained; the JSON object and the table hold all
_ASCII = str.maketrans({"σ": "sigma", "°": " deg", "∧": "/\\", "∨": "\\/", "…": "...", "⁻": "^-", "≤": "<="})

KINDS = {
    "crosses": "crosses: the superbracket changes its sign",
    "touches": "touches: the superbracket keeps its sign",
    "starts": "the path starts here",
    "ends": "the path ends here",
}


def as_text(r: PathReport, *, unicode: bool = False) -> str:
    """The whole report; without `unicode` in ASCII."""
    found = "\n".join(_lines(r))
    return found if unicode else in_ascii(found)


def in_ascii(text: str) -> str:
    """The text without signs of mathematics."""
    return text.translate(_ASCII)


def _lines(r: PathReport) -> Iterator[str]:
    yield from wrapped(f"{r.verdict}: {r.reason}")
    if r.zeros or r.stretches:
        yield ""
        yield "Singular places"
    for s in r.stretches:
        yield from wrapped(f"parameter {s.start} to {s.end}: every pose is singular; half way:", "  ")
        for cause in s.causes:
            yield from wrapped(cause, "     ", " " * 7)
        if s.dependence:
            yield from _gained(s.dependence, r.rig.unit)
    for n, z in enumerate(r.zeros[:_MOST], 1):
        yield from _zero(n, z, r.rig.unit)
    if len(r.zeros) > _MOST:
        yield f"  and {len(r.zeros) - _MOST} more, which --json and --csv show"
    yield ""
    rows = [
        ("path", f"{_count(len(r.poses), 'pose')}; the parameter is 0 at the first, 1 at the second, and so on"),
        ("between", "the centre moves on a straight line, the platform turns about one axis, the shorter way"),
        ("centre", _centre(r)),
        *_least(r),
        ("values", f"at {_count(len(r), 'sample')}: {listed_verdicts(r.numbers.verdict.tolist())}"),
        ("proof", _proof(r)),
        *(("note", note) for note in r.notes),
    ]
    width = max(len(name) for name, _ in rows)
    for name, value in rows:
        yield from wrapped(value, f"{name:<{width}}  ", " " * (width + 2))


def _zero(number: int, z: Zero, unit: str) -> Iterator[str]:
    times = f", a zero of multiplicity {z.multiplicity}" if z.multiplicity > 1 else ""
    exactly = f" = {z.lower}" if z.exact and z.lower.denominator > 1 and len(str(z.lower)) < 12 else ""
    yield from wrapped(f"{number}. at parameter {z.parameter:.6g}{exactly}: {KINDS[z.kind]}{times}", "  ", " " * 5)
    yield from wrapped(f"pose {_pose(z.pose)}", "     ", " " * 7)
    for cause in z.causes:
        yield from wrapped(cause, "     ", " " * 7)
    if z.dependence:
        yield from _gained(z.dependence, unit)


def _gained(d: Dependence, unit: str) -> Iterator[str]:
    for m in d.motions:
        yield from wrapped(f"Gained motion: the platform can {m.text(unit)}.", "     ", " " * 7)
    yield from wrapped(f"Dependent legs: {', '.join(d.legs)}; they span {d.within.name}.", "     ", " " * 7)


def _least(r: PathReport) -> Iterator[tuple[str, str]]:
    if r.zeros or r.stretches:
        return
    at = f"σ = {r.least.margin:.4g} at parameter {r.least.parameter:.4g} (0 singular, at most 1)"
    turn = degrees(turn_of(r.least.bound))
    yield "closest", at
    yield "free of", f"singular poses, proved: σ ≥ {r.least.bound:.4g} on the whole path, any leg's turn by {turn}"


def _proof(r: PathReport) -> str:
    listed = sorted({d for d in r.degrees if d >= 0})
    if not listed:
        return "along every segment the superbracket is the zero polynomial, exactly"
    shown = f"{listed[0]}" if len(listed) == 1 else f"{listed[0]} to {listed[-1]}"
    return (
        f"along each segment the superbracket is a polynomial of degree {shown}, up to a positive factor; it is exact, "
        "and all its real zeros were isolated in integer arithmetic (Descartes' rule), multiple ones too"
    )


def listed_verdicts(verdicts: Sequence[str]) -> str:
    """ "180 regular, 20 close"."""
    return ", ".join(f"{verdicts.count(v)} {v}" for v in ("regular", "close", "singular") if v in verdicts)


def _centre(r: PathReport) -> str:
    if not any(r.rig.centre):
        return "the origin"
    return "(" + ", ".join(f"{float(c):.6g}" for c in r.rig.centre) + f") {r.rig.unit}".rstrip()


def _count(number: int, word: str) -> str:
    return f"{number:,} {word}{'s' * (number != 1)}"


def _pose(p: Pose) -> str:
    """Text for --at, to six digits."""
    shift = _numbers([float(c) for c in p.translation])
    turn = _numbers([math.degrees(c) for c in p.rotation_vector]) if p.angle > 1e-12 else ""
    return f'"{shift}; rotvec {turn} deg"' if turn else f'"{shift}"'


def _numbers(values: Sequence[float]) -> str:
    least = 1e-12 * max(map(abs, values))
    return " ".join("0" if abs(x) <= least else f"{x:.6g}" for x in values)


def wrapped(text: str, first: str = "", rest: str | None = None) -> list[str]:
    """The text in lines, the first of them behind `first`, the others behind `rest`."""
    other = first + "  " if rest is None else rest
    return textwrap.wrap(
        text, WIDTH, initial_indent=first, subsequent_indent=other, break_long_words=False, break_on_hyphens=False
    )


def as_latex(r: PathReport) -> str:
    """A tabular: the verdict, each singular place, or the proved least margin; needs no package."""
    rows = [("verdict", r.verdict)]
    for z in r.zeros:
        times = f", multiplicity {z.multiplicity}" if z.multiplicity > 1 else ""
        rows.append(("singular at parameter", f"{latex_quantity(z.parameter)} ({z.kind}{times})"))
    rows += [("singular from, to", f"{latex_quantity(s.start)}, {latex_quantity(s.end)}") for s in r.stretches]
    if not r.zeros and not r.stretches:
        rows.append(("least margin $\\sigma$, proved", latex_quantity(r.least.bound)))
    return latex_table(rows)
