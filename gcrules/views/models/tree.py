"""The tree of links of a model as model files write it: a link has its frame at its joint, turned as the base is."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.core.errors import InputError
from gcrules.mechanisms.models.model import Model, ModelJoint, Vector

__all__ = ["LinkTree"]

_TREE = ("fixed", "revolute", "prismatic", "ball", "free")
_CLOSING = ("fixed", "ball")


class LinkTree:
    """Joints of the tree below each link, joints that close loops, the places of frames, and what belongs to each link.

    Raises InputError for joints with several freedoms, which stand as several in files of models.
    """

    def __init__(self, model: Model) -> None:
        self.model = model
        self.base = model.links[0]
        self.below: dict[str, list[ModelJoint]] = {name: [] for name in model.links}
        self.closing: list[ModelJoint] = []
        self.places: dict[str, Vector] = {self.base: (0.0, 0.0, 0.0)}
        self.points: dict[str, list[Vector]] = {name: [] for name in model.links}
        for j in model.joints:
            if j.kind not in (_CLOSING if j.closing else _TREE):
                role = " and closes a loop" if j.closing else ""
                raise InputError(f"joint {j.name} is {j.kind}{role}: such joints are not written")
            (self.closing if j.closing else self.below[j.parent]).append(j)
            if not j.closing:
                self.places[j.child] = j.at
            for link in (j.parent, j.child):
                if j.at not in self.points[link]:
                    self.points[link].append(j.at)
        every = [p for points in self.points.values() for p in points]
        spans = [max(c) - min(c) for c in zip(*every, strict=True)] if every else [0.0]
        self.size = sum(s * s for s in spans) ** 0.5 or 1.0
        reached = set(self.order())
        for name in model.links:
            if name not in reached:
                raise InputError(f"link {name} hangs on no joint of the tree")

    def order(self) -> Iterator[str]:
        """All links, parents first."""
        waiting = [self.base]
        while waiting:
            name = waiting.pop()
            yield name
            waiting += [j.child for j in reversed(self.below[name])]

    def offset(self, link: str, at: Vector) -> Vector:
        """A place in the frame of a link."""
        x, y, z = (self._clean(a - b) for a, b in zip(at, self.places[link], strict=True))
        return x, y, z

    def _clean(self, value: float) -> float:
        return 0.0 if abs(value) < 1e-14 * self.size else value

    def centre(self, link: str) -> Vector:
        """The mean of the joints of a link, in its frame."""
        points = [self.offset(link, p) for p in self.points[link]] or [(0.0, 0.0, 0.0)]
        x, y, z = (sum(c) / len(points) for c in zip(*points, strict=True))
        return x, y, z

    def rods(self, link: str) -> Iterator[tuple[Vector, Vector]]:
        """Pairs of places of a link, in its frame, between which a rod shows it."""
        points = [self.offset(link, p) for p in self.points[link]]
        if len(points) == 2:
            yield points[0], points[1]
        elif len(points) > 2:
            yield from zip(points, [*points[1:], points[0]], strict=True)
