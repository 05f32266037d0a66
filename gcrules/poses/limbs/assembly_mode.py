r"""On which assembly mode a configuration lies: what is proved of the way to it from home.

Three questions: does the way keep to one branch of solutions (proved step by step, `gcrules.mechanisms.kinematics.
branch`); does the determinant of the wrenches change its sign on it (`determinants`); and is it proved that nothing on
it is singular. A way that crosses no singular configuration stays on home's assembly mode.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from math import floor
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.branch import Move, is_regular
from gcrules.mechanisms.kinematics.determinants import frames, has_sign, relative_sign
from gcrules.mechanisms.kinematics.linkage import Configuration, Linkage
from gcrules.mechanisms.kinematics.solve import Course, Solution, goal

__all__ = ["AssemblyMode", "assembly_mode"]

_NARROW = 1e-5  # of the way: how closely a crossing is located
_SHORTEST = 1 / 4096  # of the way: shorter stretches are not parted for a proof
_MOST = 96  # stretches that are looked at for one proof
_END = 0.999

Node = tuple[float, Configuration]


@dataclass(frozen=True)
class AssemblyMode:
    """What is known of the way from home, its places in parts of it from 0 to 1.

    The branch of solutions is proved but from `doubt` on. At the `crossings` the determinant of the wrenches changes
    its sign, `unknown` is where its sign cannot be followed. From home to `regular` it is proved that no configuration
    is singular; `ends_singular` tells that the last configuration is.
    """

    doubt: float | None = None
    crossings: tuple[float, ...] = ()
    unknown: float | None = None
    regular: float = 1.0
    ends_singular: bool = False
    at_home: bool = False

    @property
    def same(self) -> bool | None:
        """Whether the way stays on home's mode: True where that is proved, False where it crosses a singular
        configuration, None where it is not known.
        """
        if self.doubt is not None:
            return None
        if self.crossings:
            return False
        return True if self.regular >= 1 else None

    @property
    def text(self) -> str:
        """In words."""
        if self.at_home:
            return "that of home"
        if self.doubt is not None:
            return f"not known: from {_at_least(self.doubt)} of the way from home on its branch is not proved"
        if self.crossings:
            where = listed([_percent(c) for c in self.crossings])
            return (
                "the way from home crosses a singular configuration: the determinant of the wrenches changes its sign"
                f" at {where} of it"
            )
        if self.regular >= 1:
            return "that of home, proved: no configuration on the way from there is singular"
        if self.ends_singular and self.regular >= _END:
            return f"that of home, proved up to {_at_least(self.regular)} of the way from there; its end is singular"
        if self.unknown is not None:
            where = _percent(self.unknown)
            return f"not known: the sign of the determinant of the wrenches is lost at {where} of the way"
        return (
            "not known: the determinant of the wrenches has one sign at all steps from home, but that nothing between"
            f" them is singular is not proved at {_at_least(self.regular)} of the way"
        )

    @property
    def branch(self) -> str:
        """Of the branch of solutions, in words."""
        if self.at_home:
            return "home itself"
        if self.doubt is None:
            return "proved: one continuous solution leads here from home, and no other one comes near it"
        return f"not proved from {_at_least(self.doubt)} of the way from home on: this may be another solution"

    def to_json(self) -> dict[str, Any]:
        return {
            "branch_proved": self.doubt is None,
            "proved_to": 1.0 if self.doubt is None else self.doubt,
            "same_mode": self.same,
            "crossings": list(self.crossings),
            "regular_to": self.regular,
        }


def _percent(part: float) -> str:
    return f"{100 * part:.4g}%"


def _at_least(part: float) -> str:
    return f"{floor(1e4 * part) / 100:g}%"


def assembly_mode(m: Linkage, solution: Solution) -> AssemblyMode:
    """What is known of the way from home to a solution."""
    if not solution.steps:
        return AssemblyMode(at_home=True)
    way = _Way(m, solution)
    crossings, unknown = way.signs()
    regular = way.regular() if solution.doubt is None and not crossings else 0.0
    end = solution.parts[-1]
    return AssemblyMode(
        None if solution.doubt is None else float(solution.doubt / end),
        tuple(c / end for c in crossings),
        None if unknown is None else float(unknown / end),
        float(regular / end),
        not has_sign(way.frames(solution.configuration)),
    )


class _Way:
    """The steps to a solution, parted where that is needed."""

    def __init__(self, m: Linkage, solution: Solution) -> None:
        self.m, self.target = m, solution.target
        self.course = Course(m, solution.target)
        self.nodes = [(0.0, m.home), *zip(solution.parts, solution.way, strict=True)]
        self.end = solution.parts[-1]
        self.frames = cache(lambda c: frames(m, c, m.centre))

    def between(self, a: Node, b: Node) -> Node | None:
        """The configuration in the middle of a stretch; None where it is not reached."""
        checkpoint()
        part = (a[0] + b[0]) / 2
        try:
            return part, goal(self.course, Solution(a[1], self.target), a[0], part).configuration
        except InputError:
            return None

    def signs(self) -> tuple[tuple[float, ...], float | None]:
        """Where the determinant changes its sign, and the first place where that cannot be told."""
        crossings: list[float] = []
        unknown: float | None = None
        home, *others = self.nodes
        signed = [home, *(n for n in others if has_sign(self.frames(n[1])))]
        if not has_sign(self.frames(home[1])):
            return (), 0.0
        for a, b in pairwise(signed):
            for found, sure in self._changes(a, b):
                if sure:
                    crossings.append(float(found))
                elif unknown is None:
                    unknown = float(found)
        return tuple(crossings), unknown

    def _changes(self, a: Node, b: Node) -> Iterator[tuple[float, bool]]:
        sign = relative_sign(self.frames(a[1]), self.frames(b[1]))
        if sign == 1:
            return
        if b[0] - a[0] <= _NARROW * self.end:
            yield (a[0] + b[0]) / 2, sign == -1
            return
        middle = self.between(a, b)
        if middle is None:
            yield a[0], False
            return
        if sign == -1:
            first = relative_sign(self.frames(a[1]), self.frames(middle[1]))
            yield from self._changes(a, middle) if first != 1 else self._changes(middle, b)
        else:
            yield from self._changes(a, middle)
            yield from self._changes(middle, b)

    def regular(self) -> float:
        """How far from home it is proved that nothing is singular."""
        todo = list(pairwise(self.nodes))[::-1]
        for _ in range(_MOST):
            if not todo:
                return self.end
            a, b = todo.pop()
            if is_regular(self.m, self.target, Move.between(a[1], b[1]), (a[0], b[0])):
                continue
            middle = self.between(a, b) if b[0] - a[0] > _SHORTEST * self.end else None
            if middle is None:
                return a[0]
            todo += [(middle, b), (a, middle)]
        return todo[-1][0][0] if todo else self.end
