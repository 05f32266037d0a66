r"""Regions of lengths as text and as LaTeX: how many there are, with so many modes each, and what lies beside what."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gcrules.core.english import counted, listed
from gcrules.poses.length_regions.report import LengthRegion, LengthRegions
from gcrules.views.formulas.latex_text import latex_table, latex_words
from gcrules.views.text_tables import ASCII, table, wrapped

__all__ = ["as_latex", "as_text"]


def as_text(r: LengthRegions, *, unicode: bool = False) -> str:
    """The whole answer; without `unicode` in ASCII."""
    found = "\n".join(_lines(r))
    return found if unicode else found.translate(ASCII)


def _lines(r: LengthRegions) -> Iterator[str]:
    yield from wrapped(_verdict(r))
    yield ""
    rows = [("region", "modes", *r.names, "beside")]
    rows += [(s.name, str(s.modes), *map(_number, s.lengths), ", ".join(s.neighbours)) for s in r.regions]
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]) - 1)]
    for row in rows:
        head = "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=False))
        yield from wrapped(row[-1], f"{head}  ", " " * (len(head) + 2))
    yield ""
    yield from table([*_facts(r)])


def _verdict(r: LengthRegions) -> str:
    counts = listed([f"{n} with {modes} modes" for modes, n in r.counts.items()])
    if r.decided:
        return f"Proved: exactly {counted(r.most, 'region')}, {counts}."
    if r.slices:
        return (
            f"The {len(r.slices)} slices meet at most {r.most} regions (proved by drives between slices) and at least"
            f" {r.least} (with as many numbers of modes): {counts}. Not decided: those with equal numbers may be"
            " connected, and others may lie between the slices."
        )
    return f"Proved: at least {r.least} and at most {counted(r.most, 'region')}; of the most, {counts}."


def _facts(r: LengthRegions) -> Iterator[tuple[str, str]]:
    yield "lengths", ", ".join(f"{a.low:g} ≤ {a.name} ≤ {a.high:g}" for a in r.over)
    if r.held:
        yield "held", ", ".join(f"{n} = {_number(x)}" for n, x in r.held)
    if r.slices:
        yield "slices", f"at {r.over[0].name} = {', '.join(map(_number, r.slices))}"
        return
    if r.home:
        yield "home", f"the lengths at home lie in {r.home}"
    first, second = (a.name for a in r.over)
    if r.cusps:
        yield "cusps", f"{len(r.cusps)} of the singular curve, at ({first}, {second}) = {_places(r.cusps)}"
    yield "crossings", f"{len(r.crossings)} of the singular curve with itself" if r.crossings else "none"
    yield "exact", "by an exact polynomial of the singular lengths, cut at its critical lines; no sampling, no floats"


def _places(points: Sequence[Sequence[float]]) -> str:
    return ", ".join(f"({', '.join(_number(c, 4) for c in p)})" for p in points)


def _number(x: float, digits: int = 6) -> str:
    return f"{x:.{digits}g}"


def as_latex(r: LengthRegions) -> str:
    """A tabular of the regions; needs no package."""
    number = str(r.least) if r.decided else f"{r.least} to {r.most}"
    rows = [("regions", number)]
    rows += [(f"region {s.name}", latex_words(f"{s.modes} modes, {_witness(r, s)}")) for s in r.regions]
    return latex_table(rows)


def _witness(r: LengthRegions, s: LengthRegion) -> str:
    return ", ".join(f"{n} = {_number(x)}" for n, x in zip(r.names, s.lengths, strict=True))
