r"""The first singular configuration on a straight course of coordinates or actuators from home, with what is proved.

The course is driven in steps. Where the determinant of all wrenches changes its sign something is singular, and the
place is narrowed down; between the steps it is proved that nothing is (`Way`). In stretches in which neither is shown,
as where the course touches a singular configuration or a limb is singular by itself, the least margin is sought: if it
is 0 the stretch is singular there, if not it stays undecided.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.configurations import Configurations
from gcrules.mechanisms.kinematics.determinants import relative_sign
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.loops import Course
from gcrules.mechanisms.kinematics.margin import limb_margins, margin
from gcrules.mechanisms.kinematics.solve import Solution, goal
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.poses.limbs.way import Stretch, Way
from gcrules.screws.verdict import SOLVED

__all__ = ["FirstSingular", "first_singular"]

_PIECES = 32  # of the course: how much of it counts where the robot does not assemble up to its end
_MOST = 60  # solutions for one place
_KNOWN = 4e-8  # of the determinant of unit wrenches: its sign is sure
_GOLDEN = (5**0.5 - 1) / 2


@dataclass(frozen=True, eq=False)
class FirstSingular:
    """The first singular configuration that is known, at a `part` of the course; None where there is none. Before the
    part `clear`, a little short of it, all is proved regular but for the `undecided` stretches, and on one branch but
    from the part `doubt` on.
    """

    solution: Solution | None
    part: float
    clear: float
    undecided: tuple[Stretch, ...] = ()
    doubt: float | None = None

    @property
    def proved(self) -> bool:
        """Whether nothing before `clear` is singular: nothing on the whole course, where there is no solution."""
        return not self.undecided and (self.doubt is None or self.doubt >= self.clear)


def first_singular(m: Linkage, wanted: Target) -> FirstSingular:
    """What is first on the course. Raises InputError where the robot does not assemble before something is singular.

    What is wanted has passed `check_target`.
    """
    way, doubt, fault = _driven(m, wanted)
    changes, _ = way.signs()
    undecided: list[Stretch] = []
    for stretch in _stretches(way, changes):
        checkpoint()
        inside = [c for c in changes if _meet(c, stretch)]
        try:
            part = _crossing(way, inside[0]) if inside else _least(way, stretch)
        except InputError:
            part = None
        if part is None:
            undecided.append(stretch)
            continue
        there = goal(way.course, Solution(m.home, wanted), 0.0, part)
        return FirstSingular(there, part, min(stretch[0], part), tuple(undecided), doubt)
    if fault is not None:
        raise fault
    return FirstSingular(None, 1.0, 1.0, tuple(undecided), doubt)


def _driven(m: Linkage, wanted: Target) -> tuple[Way, float | None, InputError | None]:
    """The way as far as the robot assembles, in pieces; where its branch is in doubt, and why it ends."""
    course, here, fault = Course(m, wanted), Solution(m.home, wanted), None
    for k in range(_PIECES):
        checkpoint()
        try:
            here = goal(course, here, k / _PIECES, (k + 1) / _PIECES)
        except InputError as found:
            if not here.way:
                raise
            fault = found
            break
    return Way(m, wanted, [(0.0, m.home), *zip(here.parts, here.way, strict=True)]), here.doubt, fault


def _stretches(way: Way, changes: tuple[Stretch, ...]) -> Iterator[Stretch]:
    """Where something may be singular, in order: what is not proved, and changes of sign outside of that."""
    left = way.unproved()
    alone = [c for c in changes if not any(_meet(c, one) for one in left)]
    yield from sorted([*left, *alone])


def _meet(one: Stretch, other: Stretch) -> bool:
    return one[0] <= other[1] and other[0] <= one[1]


def _singular(m: Linkage, c: Configuration) -> float:
    """The least of σ and of the limbs' own margins."""
    return min(margin(m, c).sigma, float(limb_margins(m, Configurations.of([c])).min()))


def _crossing(way: Way, at: Stretch) -> float | None:
    """Where the determinant is 0 in a short stretch at whose ends it has opposite signs; None where the robot is not
    singular there. It is linear between places that are near to each other, at last so near that it is just known.
    """
    first = way.frames(way.at(at[0]))

    def value(part: float) -> float:
        there = way.frames(way.at(part))
        return float(abs(there.determinant[0]) * relative_sign(first, there)[0])

    (a, b), part = at, sum(at) / 2
    for _ in range(2):
        at_a, at_b = value(a), value(b)
        if at_a * at_b >= 0:
            break
        part = a + (b - a) * at_a / (at_a - at_b)
        near = _KNOWN * (b - a) / abs(at_b - at_a)
        a, b = max(a, part - near), min(b, part + near)
    return part if _singular(way.m, way.at(part)) <= SOLVED else None


def _least(way: Way, stretch: Stretch) -> float | None:
    """Where the margin is 0 in a stretch, by golden section; None where it is not."""
    low, high = (max(0.0, stretch[0] - (stretch[1] - stretch[0])), min(way.end, stretch[1] * 2 - stretch[0]))
    ends = low, high

    def sigma(part: float) -> float:
        return _singular(way.m, way.at(part))

    part = _golden(sigma, low, high)
    return min((sigma(p), p) for p in (part, *ends))[1] if min(map(sigma, (part, *ends))) <= SOLVED else None


def _golden(value: Callable[[float], float], low: float, high: float) -> float:
    a, b = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    at_a, at_b = value(a), value(b)
    for _ in range(_MOST):
        checkpoint()
        if at_a < at_b:
            high, b, at_b = b, a, at_a
            a = high - _GOLDEN * (high - low)
            at_a = value(a)
        else:
            low, a, at_a = a, b, at_b
            b = low + _GOLDEN * (high - low)
            at_b = value(b)
    return a if at_a < at_b else b
