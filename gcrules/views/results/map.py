r"""A map as plain text, as LaTeX and as a picture: what was computed, what is singular, what is proved."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gcrules.core.deferred import deferred
from gcrules.core.english import as_sentence
from gcrules.mechanisms.kinematics.amplification import INDICES
from gcrules.poses.maps.report import SingularMap
from gcrules.views.detail import first, naming_options
from gcrules.views.formulas.latex_text import latex_quantity, latex_table, latex_words
from gcrules.views.results.polynomials import decimals, factor_text
from gcrules.views.text_tables import ASCII, table, wrapped

__all__ = ["account", "as_latex", "as_text", "picture_of"]

_MOST = 12

picture = deferred("gcrules.views.plots.map_plot:picture")  # matplotlib, an extra of the installation


def as_text(m: SingularMap, *, unicode: bool = False, digits: int | None = None) -> str:
    """The whole text; without `unicode` in ASCII; factors with decimals of so many `digits`."""
    found = "\n".join(_lines(m, digits))
    return found if unicode else found.translate(ASCII)


def _lines(m: SingularMap, digits: int | None) -> Iterator[str]:
    yield from wrapped(as_sentence(m.guarantee))
    yield ""
    rows = account(m, digits)
    before = ["", *(name for name, _ in rows)]
    yield from table([("" if name == last else name, value) for (name, value), last in zip(rows, before, strict=False)])
    if any(decimals(f.form, digits) is not None for f in m.factors or ()):
        yield from ("", f"Decimals are rounded{naming_options('; --full and --json have the exact numbers')}.")


def account(m: SingularMap, digits: int | None = None) -> list[tuple[str, str]]:
    """What there is to say of it besides its guarantee, names with what they say; the same name may stand several times
    in a row. Factors have decimals of so many `digits`.
    """
    g = m.grid
    rows = [("map", f"{' × '.join(f'{n:,}' for n in g.shape)} poses of {g.title or 'the robot'}")]
    for a in g.axes:
        span = f"{a.name} from {float(a.start):g} to {float(a.stop):g} {a.unit}".rstrip()
        rows.append(("over", f"{span}, every {float(a.step):.4g}: {a.meaning}"))
    rows.append(("rest", g.rest))
    if m.limits:
        rows.append(("limits", m.limits.text))
    if m.limits or m.summary.outside:
        reached = f"{_share(m.summary.allowed, m.summary.poses)} of the poses"
        others = f"; the others are {m.task.beyond}" if m.summary.allowed < m.summary.poses else ""
        rows.append(("reached", f"{reached}{others}"))
    if m.summary.margin is not None and m.summary.place is not None:
        at = ", ".join(f"{a.name} = {c:.6g}" for a, c in zip(g.axes, m.summary.place, strict=True))
        rows.append(("close", f"{_share(m.summary.close, m.summary.allowed)} of them (threshold {m.threshold.text})"))
        rows.append(("least", f"margin σ = {m.summary.margin:.4g} at the node {at}"))
    if m.summary.index:
        rows.append((m.task.measure.replace("_", " "), _index(m)))
    rows += list(_found(m, digits))
    return [*rows, *(("note", note) for note in m.notes)]


def _index(m: SingularMap) -> str:
    """ "isotropy of the actuators: from 0.1 at x = 2 to 0.9 at x = 0"."""
    index, unit = INDICES[m.task.measure], INDICES[m.task.measure].unit(m.grid.unit, m.grid.angles_driven)
    ends = []
    for value, place in m.summary.index:
        at = ", ".join(f"{a.name} = {c:.6g}" for a, c in zip(m.grid.axes, place, strict=True))
        shown = "infinite" if math.isinf(value) else f"{value:.4g} {unit}".rstrip()
        ends.append(f"{shown} at {at}")
    return f"{index.meaning}: from {ends[0]} to {ends[1]}"


def _found(m: SingularMap, digits: int | None) -> Iterator[tuple[str, str]]:
    if m.factors:
        shown = first(m.factors, _MOST)
        for k, f in enumerate(shown, 1):
            yield "factor", f"{k}. {factor_text(f.form, f.multiplicity, digits)}"
        if len(m.factors) > len(shown):
            yield "factor", f"and {len(m.factors) - len(shown)} more{naming_options(', which --full shows')}"
    if len(m.grid.axes) == 2:
        closed = sum(c.closed for c in m.curves)
        inside = sum(bool(c.allowed.any()) for c in m.curves)
        reached = f", {inside} of them within the limits somewhere" if m.limits and m.curves else ""
        listed = f"{len(m.curves)} ({closed} closed){reached}" if m.curves else "none"
        yield "curves", listed
        if m.factors is None and not m.everywhere:
            yield "accuracy", m.task.accuracy


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.3g} %" if whole else "none"


def as_latex(m: SingularMap) -> str:
    """A tabular of the axes and of what was found; needs no package."""
    rows = [("poses", " $\\times$ ".join(map(str, m.grid.shape)))]
    for a in m.grid.axes:
        ends = (latex_quantity(float(c), a.unit) for c in (a.start, a.stop))
        rows.append((latex_words(a.name), " to ".join(ends)))
    if m.summary.margin is not None:
        rows.append(("least margin $\\sigma$ at a node", latex_quantity(m.summary.margin)))
    if len(m.grid.axes) == 2:
        rows.append(("singular curves", str(len(m.curves))))
    return latex_table(rows)


def picture_of(m: SingularMap) -> str | None:
    """The map over two coordinates as SVG; None over three, and where matplotlib is missing."""
    if len(m.grid.axes) != 2:
        return None
    try:
        svg: bytes = picture(m, "svg")
    except ImportError:
        return None
    return svg.decode()
