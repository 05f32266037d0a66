"""Isomorphisms of the leg graphs of two structures: joints to joints, legs to legs, sides to sides."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.algebra.language.legs_text import Leg, Structure

__all__ = ["isomorphism"]

_EXCHANGED = {"base": "platform", "platform": "base", "": ""}


def isomorphism(a: Structure, b: Structure) -> dict[str, str] | None:
    """The joints of `b` that those of `a` go to, base to base or else base to platform; None if there is no such map.

    Of all isomorphisms the one under which the legs of `a`, as they follow each other, go to the first legs of `b` in
    the order of its points, so that the choice does not depend on how legs are written.
    """
    for exchanged in (False, True):
        sides = {n: _EXCHANGED[s] if exchanged else s for n, s in a.sides.items()}
        place = {n: i for i, n in enumerate(b.names)}
        legs = sorted(b.legs, key=lambda leg: sorted(map(place.__getitem__, leg)))
        found = next(_extended(a.legs, tuple(legs), sides, b.sides, {}), None)
        if found is not None:
            return {n: found[n] for n in a.names}
    return None


def _extended(
    legs: tuple[Leg, ...], free: tuple[Leg, ...], sides: dict[str, str], images: dict[str, str], known: dict[str, str]
) -> Iterator[dict[str, str]]:
    """All ways to send the legs to the `free` ones that agree with what is `known`, the first images first."""
    if not legs:
        yield known
        return
    p, q = legs[0]
    for i, (x, y) in enumerate(free):
        for r, s in ((x, y), (y, x)):
            if _goes(p, r, sides, images, known) and _goes(q, s, sides, images, known):
                yield from _extended(legs[1:], free[:i] + free[i + 1 :], sides, images, {**known, p: r, q: s})


def _goes(joint: str, image: str, sides: dict[str, str], images: dict[str, str], known: dict[str, str]) -> bool:
    """Whether a joint may go to another one: it does already, or both are new and on one side."""
    if joint in known:
        return known[joint] == image
    return image not in known.values() and sides.get(joint, "") == images.get(image, "")
