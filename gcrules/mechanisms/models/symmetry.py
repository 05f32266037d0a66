"""The symmetry of a model at home: a turn about an axis, and a mirror, that map its joints to each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.mechanisms.kinematics.rigid_motions import Floats, rotations
from gcrules.mechanisms.models.motions import Motion
from gcrules.mechanisms.models.projecting import Relation
from gcrules.mechanisms.models.rigid_relations import Layout

__all__ = ["Symmetry", "symmetries_of"]

_FOLDS = range(12, 1, -1)
_FRAME = "xyz"
_SEEN = 1e-6  # of a component that gives an axis its sense


@dataclass(frozen=True, eq=False)
class Symmetry:
    """A turn or a mirror that maps each joint to a joint, as relations between them, and in words."""

    relations: tuple[Relation, ...]
    text: str


def symmetries_of(own: Layout, tolerance: float) -> tuple[Symmetry, ...]:
    """The turn of the highest order about an axis through the middle, and a mirror: they make all that there are with
    this axis.
    """
    if len(own.shape.places) < 2:
        return ()
    found = []
    centre = own.shape.places[sorted(own.points) or slice(None)].mean(axis=0)
    centre = np.where(np.abs(centre) < tolerance, 0.0, centre)
    axes = _axes(own, centre)
    axis = None
    for name, a in axes:
        for fold in _FOLDS:
            made = _symmetry(own, rotations(a * (2 * np.pi / fold)), centre, tolerance)
            if made:
                found.append(Symmetry(made, f"turns by {360 / fold:.4g}° about {name}"))
                axis = a
                break
        if axis is not None:
            break
    for name, normal in _normals(own, centre, axis, tolerance):
        made = _symmetry(own, np.eye(3) - 2 * np.outer(normal, normal), centre, tolerance)
        if made:
            found.append(Symmetry(made, f"a mirror perpendicular to {name}"))
            break
    return tuple(found)


def _axes(own: Layout, centre: Floats) -> Iterator[tuple[str, Floats]]:
    """Along the frame, and through what the places are spread out around."""
    yield from zip("zxy", np.eye(3)[[2, 0, 1]], strict=True)
    away = own.shape.places - centre
    values, vectors = np.linalg.eigh(away.T @ away)
    for k in (0, 2):
        if abs(values[k] - values[1]) > 1e-3 * values[2] and np.abs(vectors[:, k]).max() < 1 - 1e-9:
            axis = vectors[:, k] * np.sign(vectors[np.argmax(np.abs(vectors[:, k]) > _SEEN), k])
            yield f"({', '.join(f'{c:.4g}' for c in axis)})", axis


def _normals(own: Layout, centre: Floats, axis: Floats | None, tolerance: float) -> Iterator[tuple[str, Floats]]:
    """Along the frame, and halfway between the first place off the axis and others at its height and distance."""
    for name, n in zip(_FRAME, np.eye(3), strict=True):
        if axis is None or abs(float(axis @ n)) < tolerance:
            yield name, n
    if axis is None:
        return
    away = own.shape.places - centre
    across = away - np.outer(away @ axis, axis)
    radii = np.linalg.norm(across, axis=1)
    first = int(np.argmax(radii > 0.05 * radii.max()))
    for k in range(len(radii)):
        between = across[k] - across[first]
        size = float(np.linalg.norm(between))
        level = abs(float((away[k] - away[first]) @ axis)) < tolerance and abs(radii[k] - radii[first]) < tolerance
        if level and size > 10 * tolerance:
            yield f"({', '.join(f'{c:.4g}' for c in between / size)})", between / size


def _symmetry(own: Layout, turn: Floats, centre: Floats, tolerance: float) -> tuple[Relation, ...]:
    """A motion as relations between the joints, () where it does not map each to one of its kind."""
    shift = centre - turn @ centre
    motions = own.motions
    places = np.array([own.shape.places[k] if k >= 0 else np.full(3, np.nan) for k in own.place])
    axes = np.array([m.axis for m in motions])
    there, along = places @ turn.T + shift, axes @ turn.T
    apart = there[:, None] - places[None]
    lines = np.array([m.has_line and own.is_line(k) for k, m in enumerate(motions)])
    across = np.where(lines[None, :, None], np.cross(apart, axes[None]), apart)
    far = np.linalg.norm(across, axis=2)
    far = np.where(np.isnan(far), 0.0, far)
    turned = np.linalg.norm(np.cross(along[:, None], axes[None]), axis=2)
    near = (far < tolerance) & (turned < tolerance)
    if not near.any(axis=1).all():
        return ()
    sense = float(np.linalg.det(turn))
    base, platform = own.ends
    images = _images(motions, near, {base: base, platform: platform}, sense)
    images = images or _images(motions, near, {base: platform, platform: base}, sense)
    if images is None:
        return ()
    found: dict[tuple[object, ...], Relation] = {}
    for k, other in enumerate(images):
        p, q = own.place[k], own.place[other]
        a, b = own.direction[other], own.direction[k]
        if p >= 0:
            line = (a,) if lines[other] else ()
            found["image", p, q, line] = Relation("image", (p, q), line, (turn, shift, 1.0))
        if a >= 0:
            sign = float(np.sign(own.axis(a) @ turn @ own.axis(b)))
            found["turned", a, b] = Relation("turned", (), (a, b), (turn, shift, sign))
    return tuple(found.values())


def _images(motions: Sequence[Motion], near: np.ndarray, ends: dict[str, str], sense: float) -> list[int] | None:
    """Of each motion the one to which it goes, so that bodies go to bodies, base and platform as `ends` says; None
    where that is not seen. What is driven goes to what is driven, but where base and platform change places.
    """
    bodies = dict(ends)
    stay = all(a == b for a, b in ends.items())
    found: list[int] = []
    for k, m in enumerate(motions):
        for other in map(int, np.flatnonzero(near[k])):
            o = motions[other]
            same = m.kind == o.kind and (not stay or (m.driven, m.place) == (o.driven, o.place))
            if not same or other in found or abs(m.pitch - sense * o.pitch) > 1e-9:
                continue
            for pairs in (((m.start, o.start), (m.end, o.end)), ((m.start, o.end), (m.end, o.start))):
                if all(bodies.get(a, b) == b and (a in bodies or b not in bodies.values()) for a, b in pairs):
                    bodies.update(pairs)
                    found.append(other)
                    break
            if len(found) > k:
                break
        else:
            return None
    return found
