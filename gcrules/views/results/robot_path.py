r"""A path of a robot of joints as plain text and as LaTeX: verdict, crossings with causes, what is proved and how."""

from __future__ import annotations

import math
from collections.abc import Iterator

from gcrules.core.english import agreeing, as_sentence
from gcrules.core.floats import rounded_down
from gcrules.poses.limbs.path_report import Crossing, RobotPath
from gcrules.screws.pose_text import ANGLES
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

__all__ = ["account", "as_latex", "as_text"]


def as_text(r: RobotPath, *, unicode: bool = False) -> str:
    """The whole report; without `unicode` in ASCII."""
    found = "\n".join(account_lines(account(r)))
    return found if unicode else in_ascii(found)


def account(r: RobotPath) -> PathAccount:
    """What there is to say of it."""
    facts = [
        ("path", f"{len(r.texts)} poses; the parameter is 0 at the first, 1 at the second, and so on"),
        ("between", f"{agreeing(r.names, 'grows', 'grow')} evenly"),
        *_closest(r),
        ("values", f"at {len(r):,} samples: {listed_verdicts(r.verdicts.tolist())}"),
        *index_ranges(r.amplifications, r.parameters, r.unit),
        ("branch", _branch(r)),
        ("proof", _PROOF + (_NO_SIGNS if r.redundant else _SIGNS)),
        *(("note", note) for note in r.notes),
    ]
    places = tuple(_crossing(r, c) for c in r.crossings)
    undecided = tuple(PathStretch(a, b, False, "it is not decided whether a pose is singular") for a, b in r.undecided)
    return PathAccount(r.verdict, r.reason, places, undecided, tuple(facts))


def _closest(r: RobotPath) -> Iterator[tuple[str, str]]:
    if r.crossings:
        return
    met = f"σ = {r.least.margin:.4g} at parameter {r.least.parameter:.4g}"
    yield "closest", f"{met}, the least of the samples"
    if r.least.bound > 0:
        yield "bound", f"σ ≥ {rounded_down(r.least.bound)} everywhere on the path, proved: {_TURNED}"


_PROOF = (
    "step by step: in a tube around each the loops have exactly one solution (Krawczyk's operator), and with the"
    " actuators locked none that moves"
)
_TURNED = "in each step no limb's wrenches turn further, seen from the platform"
_SIGNS = "; the crossings lie where the determinant of all wrenches changes its sign"
_NO_SIGNS = "; with more actuators than freedoms no determinant changes its sign: what is not proved stays undecided"


def _branch(r: RobotPath) -> str:
    if r.branch_doubt is None:
        return "proved: one continuous solution leads along the path from home, and no other one comes near it"
    return f"not proved from parameter {r.branch_doubt:.4g} on: this may be another solution"


def _crossing(r: RobotPath, c: Crossing) -> PathPlace:
    return PathPlace(
        c.parameter,
        "",
        "crosses: the determinant of all wrenches changes its sign",
        _place(r, c),
        tuple(map(as_sentence, c.causes)),
        (f"Gained motion: the platform can {c.motion.text(r.unit)}.",),
        f"proved: an odd number of singular places lies between parameter {c.first:.7g} and {c.last:.7g}",
    )


def _place(r: RobotPath, c: Crossing) -> str:
    """Text for --at, to six digits."""
    return ", ".join(
        f"{n}={math.degrees(v):.6g}deg" if n in ANGLES else f"{n}={v:.6g}{r.unit}"
        for n, v in zip(r.names, c.coordinates, strict=True)
    )


def as_latex(r: RobotPath) -> str:
    """A tabular: the verdict, each singular place, or the least margin; needs no package."""
    rows = [("verdict", r.verdict)]
    rows += [("singular at parameter", latex_quantity(c.parameter)) for c in r.crossings]
    rows += [("not decided from, to", f"{latex_quantity(a)}, {latex_quantity(b)}") for a, b in r.undecided]
    if not r.crossings:
        rows.append(("least margin $\\sigma$ of the samples", latex_quantity(r.least.margin)))
        if r.least.bound > 0:
            rows.append(("least margin $\\sigma$, proved", latex_quantity(float(rounded_down(r.least.bound)))))
    return latex_table(rows)
