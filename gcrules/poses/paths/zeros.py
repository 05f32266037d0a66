r"""The singular places of a path of several segments, in order and told apart: crossing, touching, whole stretches."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.poses.numbers.motion import Dependence
from gcrules.poses.paths.roots import Root, roots, sign_after, sign_before

__all__ = ["SingularPlace", "Stretch", "places", "stretches"]

Polynomial = Sequence[int]


@dataclass(frozen=True)
class SingularPlace:
    """A singular place: its parameter lies between `lower` and `upper` (is exactly that if they are equal), a whole
    part for the segment and the rest for the place in it.

    `kind` is crosses (the superbracket changes its sign) | touches (it does not) | starts | ends (the path does so).
    `multiplicity` is that of the zero of the segment's polynomial; where two segments meet, the smaller one of the two.
    """

    lower: Fraction
    upper: Fraction
    multiplicity: int
    kind: str

    @property
    def middle(self) -> Fraction:
        return (self.lower + self.upper) / 2


@dataclass(frozen=True)
class Stretch:
    """From parameter `start` to `end` every pose is singular; `causes` and `dependence` (what the legs have in common
    and which motion is gained) are those half way.
    """

    start: int
    end: int
    causes: tuple[str, ...] = ()
    dependence: Dependence | None = None

    def to_json(self) -> dict[str, Any]:
        return {
            "start": self.start,
            "end": self.end,
            "causes": list(self.causes),
            "singularity": self.dependence.to_json() if self.dependence else None,
        }


def stretches(path: Sequence[Polynomial]) -> tuple[Stretch, ...]:
    """The segments whose polynomial is zero, neighbours joined."""
    found: list[Stretch] = []
    for k, p in enumerate(path):
        checkpoint()
        if not p:
            joined = bool(found) and found[-1].end == k
            found[-1:] = [Stretch(found[-1].start, k + 1)] if joined else [*found[-1:], Stretch(k, k + 1)]
    return tuple(found)


def places(path: Sequence[Polynomial]) -> tuple[SingularPlace, ...]:
    """All singular places in order, but for those in or at the ends of a stretch."""
    zeros = [roots(p) if len(p) > 1 else () for p in path]  # a constant has none, or is 0
    found: list[SingularPlace] = []
    for k, p in enumerate(path):
        checkpoint()
        if k and p and path[k - 1]:
            found += _between(k, (path[k - 1], zeros[k - 1]), (p, zeros[k]))
        elif not k:
            found += [
                SingularPlace(Fraction(0), Fraction(0), r.multiplicity, "starts") for r in zeros[k] if not r.upper
            ]
        found += _inside(k, zeros[k])
    last = len(path)
    found += [SingularPlace(Fraction(last), Fraction(last), r.multiplicity, "ends") for r in zeros[-1] if r.lower == 1]
    return tuple(found)


def _inside(k: int, zeros: Sequence[Root]) -> Iterator[SingularPlace]:
    for r in zeros:
        if r.upper > 0 and r.lower < 1:
            yield SingularPlace(
                k + r.lower, k + r.upper, r.multiplicity, "crosses" if r.multiplicity % 2 else "touches"
            )


def _between(
    k: int, before: tuple[Polynomial, Sequence[Root]], after: tuple[Polynomial, Sequence[Root]]
) -> Iterator[SingularPlace]:
    """The place where two segments meet, if it is singular: both polynomials vanish there."""
    ends = [r.multiplicity for r in before[1] if r.lower == 1]
    starts = [r.multiplicity for r in after[1] if not r.upper]
    if ends and starts:
        kind = "crosses" if sign_before(before[0]) != sign_after(after[0]) else "touches"
        yield SingularPlace(Fraction(k), Fraction(k), min(ends[0], starts[0]), kind)
