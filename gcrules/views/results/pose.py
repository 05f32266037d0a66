r"""A pose's report as plain text and as LaTeX: the verdict with its reason, then short tables."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from gcrules.conditions.gained_motion import factors
from gcrules.core.floats import decimal
from gcrules.poses.numbers.nearest_pose import NearestPose
from gcrules.poses.numbers.report import PoseReport
from gcrules.screws.pose import Pose
from gcrules.screws.threshold import degrees, safe
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.results.amplification import (
    above_rounding,
    amplification_lines,
    conditioning,
    conditioning_rows,
    jacobian_numbers,
    transmission_lines,
)
from gcrules.views.text_tables import ASCII, columns, table, wrapped

__all__ = ["as_latex", "as_text", "motions", "reading_rows", "rows"]


def as_text(r: PoseReport, *, unicode: bool = False) -> str:
    """The whole report; without `unicode` in ASCII."""
    lines = list(_lines(r))
    found = "\n".join(lines)
    return found if unicode else found.translate(ASCII)


def _lines(r: PoseReport) -> Iterator[str]:
    u = r.rig.unit
    yield from wrapped(f"{r.verdict}: {r.reason}")
    for sentence in r.causes:
        yield from wrapped(sentence, "  ")
    yield ""
    yield from table(list(rows(r)))
    yield from amplification_lines(r.jacobian.amplification, u)
    yield from transmission_lines(r.jacobian.amplification, u)
    if r.readings:
        yield ""
        yield "Readings of the condition"
        yield from _readings(r)
    if r.nearest:
        yield ""
        yield "Nearest singular pose"
        yield from _nearest(r)
    yield ""
    for sentence in motions(r):
        yield from wrapped(sentence)


def rows(r: PoseReport) -> Iterator[tuple[str, str]]:
    """The pose and its numbers, names with what they say."""
    u = r.rig.unit
    yield "pose", f"{_pose(r.pose)}, about {_about(r)}"
    yield "margin", f"σ = {r.margin:.4g} (0 singular, at most 1; the same in every frame and unit)"
    yield from _meaning(r)
    yield "superbracket", f"{decimal(r.superbracket)}{f' {u}⁹' if u else ''}"
    yield "Jacobian", jacobian_numbers(r.jacobian, u)
    yield "actuators", conditioning(r.jacobian.amplification, u)
    exact = f"coordinates taken as exact; rounding moves σ by at most {r.noise:.2g}"
    known = f"joints known up to {_length(r.accuracy, u)} move σ by at most {r.noise:.2g}"
    yield "accuracy", known if _inexact(r) else exact
    yield from (("note", note) for note in r.notes)


def _meaning(r: PoseReport) -> Iterator[tuple[str, str]]:
    if r.verdict == "singular":
        return
    yield (
        "error gain",
        f"errors of the leg lengths reach the platform's joints up to {1 / r.margin:.3g} times as large (root mean "
        "squares)",
    )
    yield (
        "proved",
        f"no pose is singular while every leg turns by less than {safe(r.turn)} relative to the platform, nor "
        f"after a translation by less than {safe(r.shift, r.rig.unit, 4)}{_as_given(r)}",
    )


def _as_given(r: PoseReport) -> str:
    return ", for the joints' places as given" if _inexact(r) else ""


def _inexact(r: PoseReport) -> bool:
    return r.accuracy > 1e-9 * r.jacobian.length


def _readings(r: PoseReport) -> Iterator[str]:
    for part, readings in reading_rows(r).items():
        yield f"  {part}"
        yield from columns(readings, "    ")


def reading_rows(r: PoseReport) -> dict[str, list[tuple[str, str, str]]]:
    """Of each part of the condition its readings: name, value, and what it means where it comes first."""
    explained = set()
    found: dict[str, list[tuple[str, str, str]]] = {}
    for x in r.readings:
        value = f"not valid here: {x.why}" if x.value is None else f"{_small(x.value)} {x.unit}".rstrip()
        meaning = "" if (x.name, x.meaning) in explained or x.value is None else x.meaning
        explained.add((x.name, x.meaning))
        found.setdefault(x.part.replace("/\\", "∧").replace("\\/", "∨"), []).append((x.name, value, meaning))
    return found


def _nearest(r: PoseReport) -> Iterator[str]:
    u = r.rig.unit
    found = []
    several = len(factors(r.condition.expression)) > 1
    for n in r.nearest:
        turned = n.kind == "rotation"
        least = safe(n.lower) if turned else safe(n.lower, u, 4)
        if n.never:
            found.append((n.kind, "none", f"proved: a {n.kind} alone leads to no singular pose"))
        elif n.pose is None:
            found.append((n.kind, "none found", f"proved: none below {least}"))
        else:
            found.append((n.kind, degrees(n.distance) if turned else _length(n.distance, u), _status(n, least)))
            if n.distance:
                found.append(("", "", f"at {_pose(n.pose)}"))
            if several and n.distance:
                found += [("", "", cause) for cause in n.causes]
    yield from columns(found, "  ")
    if any(n.kind == "combined" and n.pose for n in r.nearest) and r.verdict != "singular":
        yield from wrapped(
            f"combined: root of |shift|² + (ρ·angle)², ρ = {_length(r.jacobian.length, u)}, of the centroid of the"
            " legs' ends",
            "  ",
        )


def _status(n: NearestPose, lower: str) -> str:
    if n.distance == 0:
        return "the pose itself"
    if n.certified:
        return "proved nearest"
    return f"best found; proved: none below {lower}"


def motions(r: PoseReport) -> Iterator[str]:
    """What the platform can do or nearly do with its legs held, and which legs depend on each other, in sentences."""
    u = r.rig.unit
    d = r.dependence
    if r.verdict == "close":
        yield f"Nearly dependent legs, forces in the ratio {_shares(r, r.stress)}."
    if d is None:
        yield (
            f"Softest motion: the platform can {r.softest.text(u)}. The legs' lengths then "
            f"change only {r.margin:.3g} times as fast as the platform's joints move (root mean squares)."
        )
        return
    for m in d.motions:
        yield f"Gained motion: the platform can {m.text(u)}; to first order no leg changes its length."
    if d.stress is not None:
        yield f"Dependent legs: their forces balance in the ratio {_shares(r, d.stress)}."
    else:
        yield f"Dependent legs: {', '.join(d.legs)}, in {len(d.motions)} independent ways."
    yield f"Line variety: the dependent legs span {d.within.name}; all six span {d.all_legs.name}."


def _shares(r: PoseReport, stress: Sequence[float]) -> str:
    return ", ".join(f"{leg} {share:.3g}" for leg, share in zip(r.rig.names, stress, strict=True) if share)


def _about(r: PoseReport) -> str:
    if not any(r.rig.centre):
        return "the origin"
    return "(" + ", ".join(f"{float(c):.6g}" for c in r.rig.centre) + ")"


def _pose(p: Pose) -> str:
    """Text for --at, to five digits."""
    least = 1e-9 * max(1e-300, *(abs(float(c)) for c in p.translation))
    shift = " ".join(_digits(float(c), least) for c in p.translation)
    if not p.angle:
        return f'"{shift}"'
    turn = " ".join(_digits(math.degrees(c), 1e-9) for c in p.rotation_vector)
    return f'"{shift}; rotvec {turn} deg"'


def _digits(x: float, least: float) -> str:
    return "0" if abs(x) < least else f"{x:.5g}"


def _length(x: float, unit: str) -> str:
    return f"{x:.4g} {unit}".rstrip()


def _number(x: float) -> str:
    return f"{x:.4g}" if math.isfinite(x) else "infinite"


def _small(x: float) -> str:
    return "0" if abs(x) < 1e-12 else f"{x:.4g}"


def as_latex(r: PoseReport) -> str:
    """A tabular of the numbers; needs no package."""
    u = r.rig.unit
    rows = [
        ("verdict", r.verdict),
        ("margin $\\sigma$", latex_quantity(r.margin)),
        ("superbracket", latex_quantity(r.superbracket, u, 9)),
        ("smallest singular value", latex_quantity(above_rounding(r.jacobian.smallest_singular_value))),
        ("condition number", latex_quantity(r.jacobian.condition_number)),
        ("characteristic length", latex_quantity(r.jacobian.length, u)),
        *conditioning_rows(r.jacobian.amplification, u),
    ]
    for n in r.nearest:
        name = f"nearest singular pose, {n.kind}"
        if n.pose is None:
            rows.append((name, "none" if n.never else "none found"))
        elif n.kind == "rotation":
            rows.append((name, latex_quantity(math.degrees(n.distance), "deg")))
        else:
            rows.append((name, latex_quantity(n.distance, u)))
    return latex_table(rows)
