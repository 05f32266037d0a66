r"""Aspects as text and as LaTeX: how many there are, each set with its signs, and which assembly modes share one."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.core.english import counted, listed
from gcrules.poses.aspects.report import Aspects, AspectSet
from gcrules.views.formulas.latex_text import latex_quantity, latex_table, latex_words
from gcrules.views.results.plan import waypoint_text
from gcrules.views.results.result_account import Facts, Grid, ResultAccount
from gcrules.views.text_tables import ASCII, table, wrapped

__all__ = ["account", "as_latex", "as_text", "changes"]


def as_text(r: Aspects, *, unicode: bool = False) -> str:
    """The whole answer; without `unicode` in ASCII."""
    found = "\n".join(_lines(r))
    return found if unicode else found.translate(ASCII)


def account(r: Aspects) -> ResultAccount:
    """What there is to say of them."""
    return ResultAccount(_verdict(r), (_table(r), Facts(tuple(_facts(r)))))


def _table(r: Aspects) -> Grid:
    rows = ((s.name, _signs(s), str(len(s.poses)), _numbers(s.modes), _witness(s)) for s in r.sets)
    return Grid(("set", "signs", "poses", "modes" * bool(r.modes), "a pose of it"), tuple(rows))


def _lines(r: Aspects) -> Iterator[str]:
    yield from wrapped(_verdict(r))
    yield ""
    grid = _table(r)
    rows = [grid.head, *grid.rows]
    widths = [max(len(row[k]) for row in rows) for k in range(4)]
    for row in rows:
        head = "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=False) if width)
        yield from wrapped(row[4], f"{head}  ", " " * (len(head) + 2))
    yield ""
    yield from table([*_facts(r)])


def _verdict(r: Aspects) -> str:
    poses = counted(len(r.poses), "pose")
    least = counted(r.least, "aspect")
    if r.decided:
        return f"Proved: the {poses} examined lie in {'exactly ' * (r.least > 1)}{least}."
    return (
        f"The {poses} examined lie in at least {least} (proved by signs) and at most {r.most} (proved by ways). Not"
        f" decided: {_open(r)}."
    )


def _open(r: Aspects) -> str:
    """Which sets may be connected."""
    patterns = dict.fromkeys(s.pattern for s in r.sets)
    same = [[s.name for s in r.sets if s.pattern == p] for p in patterns]
    return "; ".join(f"{listed(names)} may be connected" for names in same if len(names) > 1)


def _signs(s: AspectSet) -> str:
    return s.pattern.replace("-", "−")


def _numbers(numbers: tuple[int, ...]) -> str:
    return ", ".join(map(str, numbers))


def _witness(s: AspectSet) -> str:
    return f"{waypoint_text(s.witness)} (σ = {s.margin:.4g})"


def _facts(r: Aspects) -> Iterator[tuple[str, str]]:
    expressions = [s.expression for s in r.sets[0].signs]
    yield "signs", f"of {', '.join(expressions)}" if expressions else "the robot has no number with a sign"
    if r.modes is not None:
        yield "modes", f"assembly modes for the actuators at home, {r.modes.completeness.text}"
    yield from (("change", words) for words in changes(r))
    if r.cuspidal:
        yield "cuspidal", "yes: it changes its assembly mode without a singularity"
    elif r.modes is not None:
        yield "cuspidal", "not shown by these modes; for other actuators' values there may be such a change"
    for reason in dict.fromkeys(one.reason for one in r.left_out):
        yield "left out", f"{listed([one.pose for one in r.left_out if one.reason == reason])}: {reason}"
    sure = "everywhere" if r.proved else "at the samples of each path"
    ways = "one way" if len(r.joins) == 1 else f"{len(r.joins)} ways"
    yield "ways", f"{ways} proved as by `gcrules path`; σ ≥ {r.asked:.4g} {sure}"
    yield "sought", f"{r.search.states:,} states, seed {r.search.seed}, in {r.search.region}"
    if r.search.limits:
        yield "limits", r.search.limits
    yield "beside", "aspects that none of these poses lies in are not counted"
    for note in r.notes:
        yield "note", note


def changes(r: Aspects) -> Iterator[str]:
    """Which assembly modes share an aspect."""
    for s in r.changes:
        names = listed([str(n) for n in s.modes])
        yield f"modes {names} share {s.name}: the robot changes between them without a singularity, proved"
    own = [s.pattern for s in r.sets if s.modes]
    if len(own) > 1 and len(set(own)) == len(own):
        yield "others share no aspect, proved by signs" if r.changes else "no modes share an aspect, proved by signs"


def as_latex(r: Aspects) -> str:
    """A tabular of the sets; needs no package."""
    number = str(r.least) if r.decided else f"{r.least} to {r.most}"
    rows = [("aspects", number)]
    rows += [
        (
            f"set {s.name}, signs ${s.pattern}$" if s.pattern else f"set {s.name}",
            f"{len(s.poses)} poses{f', modes {_numbers(s.modes)}' if s.modes else ''}, $\\sigma$ ="
            f" {latex_quantity(s.margin)} at {latex_words(waypoint_text(s.witness))}",
        )
        for s in r.sets
    ]
    return latex_table(rows)
