"""Assembly modes as plain text, LaTeX and pictures: how many, whether they are all, and each with its numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gcrules.core.errors import InputError
from gcrules.poses.limbs.report import RobotPose
from gcrules.poses.modes.report import AssemblyMode, AssemblyModes
from gcrules.screws.pose_text import ANGLES
from gcrules.views.drawing.drawing import Drawing, below, beside
from gcrules.views.formulas.latex_text import latex_quantity, latex_table
from gcrules.views.results.path_account import verdicts_and_margins
from gcrules.views.results.result_account import Block, Facts, Grid, ResultAccount, Sentences
from gcrules.views.robots.pose_picture import pose_picture
from gcrules.views.text_tables import ASCII, table, wrapped

__all__ = ["account", "as_latex", "as_text", "mode_picture", "mode_text", "picture", "svg"]

_SHOWN = ("x", "y", "z", "roll", "pitch", "yaw")
_DRAWN = 8  # modes in one row


def as_text(r: AssemblyModes, *, unicode: bool = False) -> str:
    """The whole answer; without `unicode` in ASCII."""
    found = "\n".join(_lines(r))
    return found if unicode else found.translate(ASCII)


def account(r: AssemblyModes) -> ResultAccount:
    """What there is to say of them."""
    blocks: list[Block] = [Facts(tuple(_facts(r)))]
    if r.modes:
        blocks += [_table(r), Sentences((_signs(r),))]
    return ResultAccount(_verdict(r), tuple(blocks))


def _lines(r: AssemblyModes) -> Iterator[str]:
    yield from wrapped(_verdict(r))
    yield ""
    yield from table([*_facts(r)])
    if r.modes:
        yield ""
        yield from _rows(_table(r))
        yield ""
        yield from wrapped(_signs(r))


def _verdict(r: AssemblyModes) -> str:
    isolated = "of isolated solutions " * bool(r.curves and r.completeness.complete)
    return "; ".join(filter(None, (r.verdict, _numbers(r), f"{isolated}{r.completeness.text}")))


def _numbers(r: AssemblyModes) -> str:
    """ "8 regular, σ from 0.57 to 0.61, 8 certified"; empty where there are no modes."""
    if not r.modes:
        return ""
    certified = sum(m.certificate.proved for m in r.modes)
    numbers = verdicts_and_margins([m.verdict for m in r.modes], [m.margin for m in r.modes])
    return f"{numbers}, {certified or 'none'} certified"


def _facts(r: AssemblyModes) -> Iterator[tuple[str, str]]:
    held = ", ".join(f"{n} = {_number(v)}" for n, v in r.actuators)
    yield "held", f"{r.asked}: {held}"
    if r.modes:
        yield "certified", _certified(r)
        yield "poses", f"from that of the file, about ({', '.join(map(_number, r.centre))})"
    yield from (("curve", _curve(r, k)) for k in range(len(r.curves)))
    yield from (("note", note) for note in r.notes)


def _signs(r: AssemblyModes) -> str:
    """What the signs are those of."""
    factors = [f.expression for f in r.modes[0].factors]
    return f"signs: of {', '.join(factors)}" if factors else "signs: the condition has no factors here"


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


def _table(r: AssemblyModes) -> Grid:
    rows = ((str(m.number), m.verdict, f"{m.margin:.4g}", m.signs.replace("-", "−"), mode_text(m)) for m in r.modes)
    return Grid(("mode", "verdict", "σ", "signs", "pose"), tuple(rows))


def _rows(grid: Grid) -> Iterator[str]:
    rows = [grid.head, *grid.rows]
    widths = [max(len(row[k]) for row in rows) for k in range(4)]
    for row in rows:
        yield "  ".join([*(f"{word:<{w}}" for word, w in zip(row, widths, strict=False)), row[4]]).rstrip()


def mode_text(m: AssemblyMode) -> str:
    """Its pose from that of the file, and what there is to remark."""
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
    drawn = [mode_picture(r, m) for m in r.modes]
    rows = [beside(drawn[k : k + _DRAWN]) for k in range(0, len(drawn), _DRAWN)]
    return below(rows, title=f"{r.title}: {r.verdict}")


def svg(r: AssemblyModes) -> str | None:
    """The picture as SVG; nothing where there is no mode."""
    return picture(r).svg() if r.modes else None


def mode_picture(r: AssemblyModes, m: AssemblyMode) -> Drawing:
    """The robot in one of the modes."""
    title = f"{r.title} in mode {m.number}: {m.verdict}, σ = {m.margin:.4g}"
    return pose_picture(r.mechanism, m.report if isinstance(m.report, RobotPose) else m.pose, title)
