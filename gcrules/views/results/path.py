r"""A path's report as plain text and as LaTeX: the verdict, the singular places with causes, what is proved and how."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gcrules.core.english import counted
from gcrules.core.floats import rounded_down
from gcrules.poses.numbers.motion import Dependence
from gcrules.poses.paths.report import PathReport, Zero
from gcrules.poses.paths.zeros import Stretch
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import safe, turn_of
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.results.amplification import index_ranges
from gcrules.views.results.path_account import (
    PathAccount,
    PathPlace,
    PathStretch,
    account_lines,
    in_ascii,
    listed_verdicts,
)

__all__ = ["account", "as_latex", "as_text", "written_pose"]

KINDS = {
    "crosses": "crosses: the superbracket changes its sign",
    "touches": "touches: the superbracket keeps its sign",
    "starts": "the path starts here",
    "ends": "the path ends here",
}


def as_text(r: PathReport, *, unicode: bool = False) -> str:
    """The whole report; without `unicode` in ASCII."""
    found = "\n".join(account_lines(account(r)))
    return found if unicode else in_ascii(found)


def account(r: PathReport) -> PathAccount:
    """What there is to say of it."""
    facts = [
        ("path", f"{counted(len(r.poses), 'pose')}; the parameter is 0 at the first, 1 at the second, and so on"),
        ("between", "the centre moves on a straight line, the platform turns about one axis, the shorter way"),
        ("centre", _centre(r)),
        *_least(r),
        ("values", f"at {counted(len(r), 'sample')}: {listed_verdicts(r.numbers.verdict.tolist())}"),
        *index_ranges(r.numbers.amplifications, r.parameters, r.rig.unit),
        ("proof", _proof(r)),
        *(("note", note) for note in r.notes),
    ]
    return PathAccount(
        r.verdict,
        r.reason,
        tuple(_place(z, r.rig.unit) for z in r.zeros),
        tuple(_stretch(s, r.rig.unit) for s in r.stretches),
        tuple(facts),
    )


def _stretch(s: Stretch, unit: str) -> PathStretch:
    return PathStretch(s.start, s.end, True, "every pose is singular", s.causes, _gained(s.dependence, unit))


def _place(z: Zero, unit: str) -> PathPlace:
    times = f", a zero of multiplicity {z.multiplicity}" if z.multiplicity > 1 else ""
    exactly = f" = {z.lower}" if z.exact and z.lower.denominator > 1 and len(str(z.lower)) < 12 else ""
    kind = f"{KINDS[z.kind]}{times}"
    return PathPlace(z.parameter, exactly, kind, written_pose(z.pose), z.causes, _gained(z.dependence, unit))


def _gained(d: Dependence | None, unit: str) -> tuple[str, ...]:
    if d is None:
        return ()
    motions = [f"Gained motion: the platform can {m.text(unit)}." for m in d.motions]
    return (*motions, f"Dependent legs: {', '.join(d.legs)}; they span {d.within.name}.")


def _least(r: PathReport) -> Iterator[tuple[str, str]]:
    if r.zeros or r.stretches:
        return
    at = f"σ = {r.least.margin:.4g} at parameter {r.least.parameter:.4g} (0 singular, at most 1)"
    turn = safe(turn_of(r.least.bound))
    yield "closest", at
    yield (
        "proved",
        f"σ ≥ {rounded_down(r.least.bound)} on the whole path: no pose near it is singular while every leg turns by "
        f"less than {turn} relative to the platform",
    )


def _proof(r: PathReport) -> str:
    listed = sorted({d for d in r.degrees if d >= 0})
    if not listed:
        return "along every segment the superbracket is the zero polynomial, exactly"
    shown = f"{listed[0]}" if len(listed) == 1 else f"{listed[0]} to {listed[-1]}"
    return (
        f"along each segment the superbracket is a polynomial of degree {shown}, up to a positive factor; "
        "where floats, their rounding bounded, do not prove that it has no zero it is exact, and all its real zeros "
        "were isolated in integer arithmetic (Descartes' rule), multiple ones too"
    )


def _centre(r: PathReport) -> str:
    if not any(r.rig.centre):
        return "the origin"
    return "(" + ", ".join(f"{float(c):.6g}" for c in r.rig.centre) + f") {r.rig.unit}".rstrip()


def written_pose(p: Pose) -> str:
    """Text for --at, to six digits."""
    shift = _numbers([float(c) for c in p.translation])
    turn = _numbers([math.degrees(c) for c in p.rotation_vector]) if p.angle > 1e-12 else ""
    return f"{shift}; rotvec {turn} deg" if turn else shift


def _numbers(values: Sequence[float]) -> str:
    least = 1e-12 * max(map(abs, values))
    return " ".join("0" if abs(x) <= least else f"{x:.6g}" for x in values)


def as_latex(r: PathReport) -> str:
    """A tabular: the verdict, each singular place, or the proved least margin; needs no package."""
    rows = [("verdict", r.verdict)]
    for z in r.zeros:
        times = f", multiplicity {z.multiplicity}" if z.multiplicity > 1 else ""
        rows.append(("singular at parameter", f"{latex_quantity(z.parameter)} ({z.kind}{times})"))
    rows += [("singular from, to", f"{latex_quantity(s.start)}, {latex_quantity(s.end)}") for s in r.stretches]
    if not r.zeros and not r.stretches:
        rows.append(("least margin $\\sigma$, proved", latex_quantity(float(rounded_down(r.least.bound)))))
    return latex_table(rows)
