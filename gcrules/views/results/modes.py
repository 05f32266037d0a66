"""Assembly modes as plain text, LaTeX and pictures: how many, whether they are all, and each with its numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction

from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.modes.report import AssemblyMode, AssemblyModes
from gcrules.screws.pose_text import ANGLES
from gcrules.screws.rotations import Vector
from gcrules.views.drawing.drawing import Drawing, below, beside, scaled, without_text
from gcrules.views.drawing.figures import robot_figure
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.robots.robot_drawing import robot_thumbnail
from gcrules.views.text_tables import ASCII, table, wrapped

__all__ = ["as_latex", "as_text", "picture", "svg"]

_SHOWN = ("x", "y", "z", "roll", "pitch", "yaw")
_DRAWN = 8  # modes in one row
_SCALE = 0.3


def as_text(r: AssemblyModes, *, unicode: bool = False) -> str:
    """The whole answer; without `unicode` in ASCII."""
    found = "\n".join(_lines(r))
    return found if unicode else found.translate(ASCII)


def _lines(r: AssemblyModes) -> Iterator[str]:
    isolated = "of isolated solutions " * bool(r.curves and r.completeness.complete)
    yield from wrapped(f"{r.verdict}; {isolated}{r.completeness.text}")
    yield ""
    held = ", ".join(f"{n} = {_number(v)}" for n, v in r.actuators)
    facts = [("held", f"{r.asked}: {held}")]
    if r.modes:
        facts.append(("certified", _certified(r)))
        facts.append(("poses", f"from that of the file, about ({', '.join(map(_number, r.centre))})"))
    facts += [("curve", _curve(r, k)) for k in range(len(r.curves))]
    facts += [("note", note) for note in r.notes]
    yield from table(facts)
    if r.modes:
        yield ""
        yield from _rows(r)
        factors = [f.expression for f in r.modes[0].factors]
        yield ""
        yield from wrapped(f"signs: of {', '.join(factors)}" if factors else "signs: the condition has no factors here")


def _certified(r: AssemblyModes) -> str:
    proved = [m for m in r.modes if m.certificate.proved]
    others = [m for m in r.modes if not m.certificate.proved]
    words = f"{len(proved)} of {len(r.modes)}"
    if proved:
        words += f": {proved[0].certificate.method}"
        off = [(m.certificate.turn, m.certificate.shift) for m in proved]
        if all(turn and shift for turn, shift in off):
            turn, shift = (max(v for v in column if v is not None) for column in zip(*off, strict=True))
            words += f", off by less than {_power(shift)}{f' {r.unit}' if r.unit else ''} and {_power(turn)} rad"
    for why in dict.fromkeys(m.certificate.method for m in others):
        numbers = [str(m.number) for m in others if m.certificate.method == why]
        words += f"; {', '.join(numbers)}: {why}"
    return words


def _power(bound: float) -> str:
    """The next power of ten above a positive bound: the digits depend on the machine."""
    return f"1e{math.floor(math.log10(bound)) + 1}"


def _curve(r: AssemblyModes, k: int) -> str:
    c = r.curves[k]
    ends = "comes back to where it begins" if c.closed else "was followed so far"
    given = ", through the given pose" if c.through_given else ""
    return (
        f"a curve of solutions{given}: the platform moves with its actuators held; {len(c.poses)} poses on it, which"
        f" {ends} (numerical, no proof)"
    )


def _rows(r: AssemblyModes) -> Iterator[str]:
    rows = [("mode", "verdict", "σ", "signs", "pose")]
    rows += [(str(m.number), m.verdict, f"{m.margin:.4g}", m.signs.replace("-", "−"), _place(m)) for m in r.modes]
    widths = [max(len(row[k]) for row in rows) for k in range(4)]
    for row in rows:
        yield "  ".join([*(f"{word:<{w}}" for word, w in zip(row, widths, strict=False)), row[4]]).rstrip()


def _place(m: AssemblyMode) -> str:
    words = ", ".join(f"{n}={_coordinate(n, m.coordinates[n])}" for n in _SHOWN if m.coordinates[n])
    remarks = [*["given"] * m.given, *[f"{m.multiplicity} paths end there"] * (m.multiplicity > 1)]
    return (words or "that of the file") + (f" ({', '.join(remarks)})" if remarks else "")


def _coordinate(name: str, value: float) -> str:
    return f"{math.degrees(value):.6g}deg" if name in ANGLES else f"{value:.6g}"


def _number(value: float) -> str:
    return f"{value:.6g}"


def as_latex(r: AssemblyModes) -> str:
    """A tabular: how many solutions, whether they are all, and the verdict and margin of each; needs no package."""
    rows = [("solutions", r.verdict), ("complete", "yes" if r.completeness.complete else "not known")]
    rows += [(f"mode {m.number}: {m.verdict}, $\\sigma$", latex_quantity(m.margin)) for m in r.modes]
    return latex_table(rows)


def picture(r: AssemblyModes) -> Drawing:
    """The robot in each mode, in rows, in their order. Raises InputError where there is none."""
    if not r.modes:
        raise InputError("there is no mode to be drawn")
    drawn = [_drawn(r, m) for m in r.modes]
    rows = [beside(drawn[k : k + _DRAWN]) for k in range(0, len(drawn), _DRAWN)]
    return below(rows, title=f"{r.title}: {r.verdict}")


def svg(r: AssemblyModes) -> str | None:
    """The picture as SVG; nothing where there is no mode."""
    return picture(r).svg() if r.modes else None


def _drawn(r: AssemblyModes, m: AssemblyMode) -> Drawing:
    analysis = r.mechanism.analysis
    if isinstance(analysis, RobotAnalysis) and isinstance(m.report, RobotPose):
        return robot_thumbnail(analysis, {n: _exact(p) for n, p in m.report.points.items()})
    assert isinstance(analysis, Analysis)
    rig = r.mechanism.six_legs().rig
    places = {n: p[:3] for n, p in rig.exact(m.pose).items()}
    return scaled(without_text(robot_figure(analysis, places, key=False)), _SCALE)


def _exact(place: tuple[float, ...]) -> Vector:
    x, y, z = map(Fraction, place)
    return x, y, z
