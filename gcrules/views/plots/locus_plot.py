r"""Pictures of a locus: over one variable the graph of the polynomial and its zeros, over two curves of its factors.

Angles are drawn instead of the tangents of their halves, so that half turns are at the ends. The curves lie between
places of opposite signs: what is smaller than the distance of these places is not seen.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.limb_report import RobotLocus
from gcrules.poses.loci.report import Locus
from gcrules.poses.loci.variables import TANGENTS, TRANSLATION
from gcrules.poses.maps.joining import joined
from gcrules.poses.maps.marching import marched
from gcrules.views.drawing.axis import Axis
from gcrules.views.drawing.drawing import XY, Circle, Drawing, Polygon, Run, Shape, Stroke, Text, text_width
from gcrules.views.drawing.palette import entity_role
from gcrules.views.plots.plot_parts import axis_below, keyed, marker, plane, signed
from gcrules.views.results import locus as of_legs
from gcrules.views.results import robot_locus as of_limbs
from gcrules.views.results.polynomials import brief

__all__ = ["picture"]

Floats = NDArray[np.float64]

_WIDTH, _LEFT, _RIGHT, _HEAD = 560.0, 64.0, 22.0, 66.0
_GRAPH, _BELOW = 190.0, 52.0
_PLACES = 160  # along each axis of a slice
_GRAPH_PLACES = 300
_ROOM = 0.15  # of the zeros' range, beside them
_AROUND = 2.0  # sizes of the robot, around the given pose
_SHOWN = 56  # letters of a factor in the key
_MARK = 8.0
_NEAR = 4.0  # on paper, of points of a curve


@dataclass(frozen=True)
class _Variable:
    """A variable from `low` to `high`; an `angle` is drawn in deg where the variable is the tangent of its half."""

    label: str
    low: float
    high: float
    angle: bool

    def parts(self, shown: Floats) -> tuple[Floats, Floats]:
        """Numbers whose quotient is the variable: sine and cosine of half the angle, or the number and 1."""
        half = np.radians(shown) / 2
        return (np.sin(half), np.cos(half)) if self.angle else (shown, np.ones_like(shown))


def picture(found: Locus | RobotLocus) -> Drawing:
    """Raises InputError for three variables or more, for roots that are variables, and where every pose is singular."""
    if found.vanishes:
        raise InputError("each of these poses is singular, so there is nothing to draw")
    free = found.question.free
    if len(free) > 2:
        hint = "name them: --over x,y, and give the others by --at or --fix; `gcrules map` draws surfaces"
        raise InputError(f"a picture is of one or two variables, not of {len(free)}", hint=hint)
    if isinstance(found, RobotLocus) and not found.multiplied:
        raise InputError("roots are variables of this polynomial", hint="--product multiplies over all working modes")
    shapes = [*_head(found)]
    more, bottom = _graph(found) if len(free) == 1 else _slice(found)
    shapes += more
    return Drawing(_WIDTH, bottom, tuple(shapes), f"{_title(found)}: singular poses over {' and '.join(free)}")


def _title(found: Locus | RobotLocus) -> str:
    return found.rig.title if isinstance(found, Locus) else found.robot.title


def _head(found: Locus | RobotLocus) -> Iterator[Shape]:
    """The robot, and what is fixed, long fractions as decimals."""
    rows: Any = of_legs.account(found) if isinstance(found, Locus) else of_limbs.account(found)
    yield Text((_LEFT, 20), (Run(_title(found)),), 14.0, "start")
    fixed = dict(rows).get("fixed", "")
    if fixed:
        short = re.sub(r"-?\d+/\d+", lambda m: m[0] if len(m[0]) < 9 else f"{float(Fraction(m[0])):.4g}", fixed)
        yield Text((_LEFT, 37), (Run(signed(f"fixed: {short}")),), 11.0, "start", "muted")


def _variable(found: Locus | RobotLocus, name: str) -> _Variable:
    if name in TRANSLATION:
        unit = found.rig.unit if isinstance(found, Locus) else found.robot.units
        reach = _AROUND * _size(found)
        return _Variable(f"{name} ({unit})" if unit else name, -reach, reach, False)
    if isinstance(found, RobotLocus):
        return _Variable(f"{name.removeprefix('t_')} (deg)", -180.0, 180.0, True)
    if name in TANGENTS:
        which = ("first", "second", "third")[TANGENTS.index(name)]
        return _Variable(f"{which} Euler angle of {found.question.rotation} (deg)", -180.0, 180.0, True)
    reach = 2.0 if name.startswith("c") else 1.0
    return _Variable(name, -reach, reach, False)


def _size(found: Locus | RobotLocus) -> float:
    """The root-mean-square distance of the joints from their centroid."""
    if isinstance(found, Locus):
        return found.rig.size
    sorts = found.robot.family.sorts
    places = np.array([[float(c) for c in p] for n, p in (found.robot.home or {}).items() if sorts[n] == "point"])
    return float(np.sqrt(((places - places.mean(axis=0)) ** 2).sum(axis=1).mean())) or 1.0


def _values(form: PolynomialForm, variables: Sequence[_Variable], shown: Sequence[Floats]) -> Floats:
    """The polynomial over its largest coefficient, times powers of cosines that are 0 at half turns only."""
    parts = [v.parts(at) for v, at in zip(variables, shown, strict=True)]
    degrees = [form.degree_in([name]) for name in form.variables]
    largest = max(abs(c) for _, c in form.terms)
    total: Floats = np.zeros(np.broadcast_shapes(*(at.shape for at in shown)))
    for exponents, c in form.terms:
        term: Any = c / largest
        for (above, below), n, d in zip(parts, exponents, degrees, strict=True):
            term = term * above**n * below ** (d - n)
        total = total + term
    return total


# --- one variable --------------------------------------------------------------------------------------------------


def _graph(found: Locus | RobotLocus) -> tuple[list[Shape], float]:
    """The graph of the polynomial, scaled, between and beside its zeros."""
    (name,) = found.question.free
    variable = _variable(found, name)
    zeros = [math.degrees(2 * math.atan(z)) if variable.angle else z for z in found.form.real_zeros]
    if zeros and not variable.angle:
        low, high = min(*zeros, 0.0), max(*zeros, 0.0)
        room = _ROOM * ((high - low) or variable.high)
        variable = _Variable(variable.label, low - room, high + room, False)
    x = Axis(variable.low, variable.high, _LEFT, _WIDTH - _RIGHT)
    at = np.unique([*np.linspace(x.low, x.high, _GRAPH_PLACES), *zeros])
    values = _values(found.form, [variable], [at])
    values = np.cbrt(values / np.abs(values).max())
    low, high = min(float(values.min()), -0.12), max(float(values.max()), 0.12)
    y = Axis(low, high, _HEAD + _GRAPH, _HEAD)
    shapes = [*_areas(x, y, at, values, zeros)]
    shapes += [Stroke((x.start, y(0)), (x.end, y(0)), "ink", 1.0)]
    line = [(x(float(a)), y(float(v))) for a, v in zip(at, values, strict=True)]
    shapes += [Stroke(p, q, "entity1", 1.8) for p, q in pairwise(line)]
    kinds = _kinds(found.form, variable, zeros)
    shapes += [marker(kind, (x(z), y(0))) for kind, z in zip(kinds, zeros, strict=True)]
    shapes += _zero_labels(zeros, x, y, variable.angle)
    shapes += axis_below(x, y.start, variable.label)
    shapes += [Polygon(((x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end)), stroke="ink")]
    key: list[tuple[Shape, str]] = [(_stroke("entity1"), "cube root of P, scaled")]
    what = "singular" if _sure(found) else "singular in some working mode, where its root is real"
    key += [(marker(k, (_MARK, -4)), f"{what}, P {_DOES[k]}") for k in dict.fromkeys(kinds)]
    if _given_in(found):
        shapes.append(_cross((x(0.0), y(0))))
        key.append((_cross((_MARK, -4)), "pose of the file"))
    return keyed(shapes, key, _LEFT, y.start + _BELOW)


_DOES = {"crosses": "changes its sign", "touches": "keeps its sign"}


def _sure(found: Locus | RobotLocus) -> bool:
    """Whether each zero is singular."""
    return isinstance(found, Locus) or not any(part.roots for part in found.parts)


def _areas(x: Axis, y: Axis, at: Floats, values: Floats, zeros: Sequence[float]) -> Iterator[Shape]:
    """Between graph and axis, in one colour above it and in another below."""
    for start, end in pairwise([x.low, *zeros, x.high]):
        inside = (at > start) & (at < end)
        if inside.any():
            some = [(x(float(a)), y(float(v))) for a, v in zip(at[inside], values[inside], strict=True)]
            outline = ((x(start), y(0)), *some, (x(end), y(0)))
            colour = "entity1" if values[inside].mean() > 0 else "entity2"
            yield Polygon(outline, fill=colour, fill_opacity=0.16)


def _kinds(form: PolynomialForm, variable: _Variable, zeros: Sequence[float]) -> list[str]:
    """Whether the polynomial changes its sign at each zero: from the signs between neighbours."""
    places = np.array([(a + b) / 2 for a, b in pairwise([variable.low, *zeros, variable.high])])
    signs = np.sign(_values(form, [variable], [places]))
    return ["crosses" if a * b < 0 else "touches" for a, b in pairwise(signs)]


def _zero_labels(zeros: Sequence[float], x: Axis, y: Axis, angle: bool) -> Iterator[Shape]:
    """The values of the zeros, in rows above each other where they are near."""
    ends: list[float] = []
    for z in zeros:
        text = Text((0, 0), (Run(signed(f"{z:.5g}{'°' * angle}")),), 11.0, "middle", "mark", halo=True)
        half = text_width(text) / 2 + 3
        middle = min(max(x(z), x.start + half), x.end - half)
        row = next((n for n, end in enumerate(ends) if middle - half > end), len(ends))
        ends[row : row + 1] = [middle + half]
        yield Text((middle, y(0) - 9 - 13 * row), text.runs, 11.0, "middle", "mark", halo=True)


# --- two variables -------------------------------------------------------------------------------------------------


def _slice(found: Locus | RobotLocus) -> tuple[list[Shape], float]:
    """The curves of each factor around the given pose."""
    first, second, forms, curves = _seen(found)
    wide = _WIDTH - _LEFT - _RIGHT
    equal = first.angle == second.angle and first.high == second.high
    side = min(wide, 420.0)
    left = _LEFT + (wide - side) / 2
    x = Axis(first.low, first.high, left, left + side)
    y = Axis(second.low, second.high, _HEAD + side * (1.0 if equal else 0.8), _HEAD)
    shapes = [*plane(x, y, first.label, second.label)]
    key: list[tuple[Shape, str]] = []
    for n, (words, own) in enumerate(zip(forms, curves, strict=True)):
        colour = entity_role(n)
        for curve in own:
            line = _thinned([(x(float(a)), y(float(b))) for a, b in curve])
            shapes += [Stroke(p, q, colour, 2.0) for p, q in pairwise(line)]
        key.append((_stroke(colour), f"{words}{'' if own else ' (no change of sign seen here)'}"))
    if _given_in(found):
        shapes.append(_cross((x(0.0), y(0.0))))
        key.append((_cross((_MARK, -4)), "pose of the file"))
    seen = f"curves from signs at {_PLACES + 1} by {_PLACES + 1} places"
    shapes.append(Text((x.end, y.end - 9), (Run(seen),), 9.5, "end", "muted"))
    return keyed(shapes, key, _LEFT, y.start + _BELOW)


def _seen(found: Locus | RobotLocus) -> tuple[_Variable, _Variable, list[str], list[list[Floats]]]:
    """The variables, words for each factor, and its curves; translations reach farther where nearby none is seen."""
    first, second = (_variable(found, n) for n in found.question.free)
    words, forms = zip(*_forms(found), strict=True)
    for times in (1, 2, 4):
        wide = [v if v.angle else replace(v, low=times * v.low, high=times * v.high) for v in (first, second)]
        curves = [_curves(form, (wide[0], wide[1])) for form in forms]
        if any(curves):
            return wide[0], wide[1], list(words), curves
    return first, second, list(words), curves


def _thinned(line: list[XY]) -> list[XY]:
    """Without points that are nearer to the one before than can be seen; the ends stay."""
    found = line[:1]
    for point in line[1:-1]:
        if math.dist(point, found[-1]) >= _NEAR:
            found.append(point)
    return [*found, line[-1]]


def _forms(found: Locus | RobotLocus) -> Iterator[tuple[str, PolynomialForm]]:
    """What is drawn, with words for the key: factors that may be 0, or what could not be split."""
    every = "" if _sure(found) else ", in some working mode"
    parts: Any = [("P", found)] if isinstance(found, Locus) else of_limbs.numbered(found)
    for name, part in parts:
        try:
            factors = [f for f in part.factors if f.kind != "norm"]
        except LimitReached:
            yield f"{name} = 0{every}", part.form
            continue
        for f in factors:
            told = brief(f.form)
            bracket = f"bracket {f.name}" if f.kind == "bracket" else ""
            long = f"factor of degree {f.form.degree} with {len(f.form.terms)} terms"
            yield f"{bracket or (told if told[:3] != 'one' and len(told) < _SHOWN else long)} = 0{every}", f.form


def _curves(form: PolynomialForm, variables: tuple[_Variable, _Variable]) -> list[Floats]:
    """Where the form changes its sign, (K, 2) in the numbers of the axes."""
    low = np.array([v.low for v in variables])
    step = np.array([v.high - v.low for v in variables]) / _PLACES

    def value(places: Floats) -> Floats:
        return _values(form, variables, list((low + places * step).T))

    nodes = [v.low + s * np.arange(_PLACES + 1) for v, s in zip(variables, step, strict=True)]
    values = _values(form, variables, [nodes[0][:, None], nodes[1][None, :]])
    return [low + curve * step for curve in joined(marched(values, value))]


# --- parts of both -------------------------------------------------------------------------------------------------


def _given_in(found: Locus | RobotLocus) -> bool:
    """Whether the pose of the file is the one where all free variables are 0, and is drawn."""
    q = found.question
    turned = isinstance(found, Locus) and found.question.turn is not None and any(found.question.turn[1:])
    quaternion = isinstance(found, Locus) and any(n.startswith("e") for n in (*q.free, *q.fixed))
    return not turned and not quaternion and not any(q.fixed.values())


def _stroke(colour: str) -> Shape:
    return Stroke((0.0, -4.0), (16.0, -4.0), colour, 2.0)


def _cross(at: XY) -> Shape:
    return Circle(at, 4.2, fill="paper", stroke="ink", width=1.6)
