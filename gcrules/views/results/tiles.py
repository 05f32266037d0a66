"""How far the tiles of a map are, and whether they are sound, as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.poses.stored_maps.verifying import MapVerified
from gcrules.poses.tiles.status import MapStatus
from gcrules.views.detail import first, naming_options
from gcrules.views.formulas.latex_text import latex_table, latex_words
from gcrules.views.text_tables import ASCII, table

__all__ = ["as_latex", "as_text", "verified_latex", "verified_text"]

_MOST = 12


def as_text(s: MapStatus, *, unicode: bool = False) -> str:
    """What is done, the rate and the time left."""
    return _shown(_status(s), unicode)


def as_latex(s: MapStatus) -> str:
    """The same as a tabular."""
    return _latex(_status(s))


def verified_text(v: MapVerified, *, unicode: bool = False) -> str:
    """What was looked at, and what is bad."""
    return _shown(_verified(v), unicode)


def verified_latex(v: MapVerified) -> str:
    """The same as a tabular."""
    return _latex(_verified(v))


def _shown(rows: Iterator[tuple[str, str]], unicode: bool) -> str:
    found = "\n".join(table([*rows]))
    return found if unicode else found.translate(ASCII)


def _latex(rows: Iterator[tuple[str, str]]) -> str:
    return latex_table([(latex_words(name), latex_words(value)) for name, value in rows])


def _status(s: MapStatus) -> Iterator[tuple[str, str]]:
    share = 100 * s.done // s.tiles
    yield "store", s.path
    yield "tiles", f"{s.done:,} of {s.tiles:,} are done ({share} %)"
    if s.complete:
        return
    if s.rate:
        yield "rate", f"{s.rate:.3g} tiles a second, for the latest ones"
    if s.left is not None:
        yield "left", f"{_duration(s.left)} at this rate"
    if s.last is not None:
        yield "last", f"a tile was done {_duration(s.last)} ago"


def _duration(seconds: float) -> str:
    """ "3 h 20 min"; seconds below two minutes."""
    if seconds < 120:
        return f"{seconds:.0f} s"
    minutes = round(seconds / 60)
    days, hours = minutes // 1440, minutes // 60 % 24
    if days:
        return f"{days} d {hours} h"
    return f"{hours} h {minutes % 60} min" if hours else f"{minutes} min"


def _verified(v: MapVerified) -> Iterator[tuple[str, str]]:
    yield "store", v.path
    yield "tiles", f"{v.done:,} of {v.tiles:,} are done; the digests of all of these were looked at"
    if v.again:
        rounded = f", {v.within_rounding} of them within rounding" if v.within_rounding else ""
        agree = len(v.again) - sum(b.tile in v.again for b in v.bad)
        yield "again", f"{len(v.again):,} were computed again: {agree:,} agree{rounded}"
    shown = first(v.bad, _MOST)
    for b in shown:
        yield "bad", f"tile {b.tile}: {b.why}"
    if len(v.bad) > len(shown):
        yield "bad", f"and {len(v.bad) - len(shown):,} more{naming_options(', which --full lists')}"
    yield "store is", "sound" if v.sound else f"not sound: {len(v.bad):,} bad tiles"
