r"""Arrays of poses: translations (N, 3) and rotations (N, 3, 3), from what a user gives."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.errors import InputError
from gcrules.core.floats import as_float
from gcrules.screws.pose import SILENT, UNIT_TOLERANCE, Pose
from gcrules.screws.rotations import MANY, check_sequence, too_many_turns

__all__ = [
    "Floats",
    "finite_rows",
    "from_poses",
    "from_vectors",
    "matrices",
    "normalised_note",
    "pose_rows",
    "read_arrays",
    "real_numbers",
]

Floats = NDArray[np.float64]


def from_poses(poses: Sequence[Pose]) -> tuple[Floats, Floats]:
    """Poses as arrays (N, 3) and (N, 3, 3)."""
    return _translations(poses), matrices(np.array([p.unit_quaternion for p in poses]).reshape(-1, 4))


def pose_rows(poses: Sequence[Pose]) -> tuple[Floats, Floats]:
    """Translations (N, 3) and quaternions (N, 4), of the lengths that they have, each number the nearest float."""
    return _translations(poses), np.array([[float(c) for c in p.quaternion] for p in poses]).reshape(-1, 4)


def _translations(poses: Sequence[Pose]) -> Floats:
    return np.array([[as_float(c) for c in p.translation] for p in poses]).reshape(-1, 3)


def read_arrays(
    translations: Any = None,
    *,
    quaternions: Any = None,
    rotation_vectors: Any = None,
    euler: tuple[str, Any] | None = None,
    degrees: bool = False,
) -> tuple[Floats, Floats]:
    """Numbers as arrays: translations (N, 3) and one kind of turns, (N, 4) or (N, 3); one row stands for all.

    Quaternions are (w, x, y, z), of length 1 within `UNIT_TOLERANCE`, and are normalised. Raises InputError for wrong
    shapes, two kinds of turns, NaN and infinity, naming the first row at fault.
    """
    if sum(x is not None for x in (quaternions, rotation_vectors, euler)) > 1:
        raise InputError("several kinds of turns", hint="give quaternions, rotation vectors or Euler angles")
    shift = np.zeros((1, 3)) if translations is None else finite_rows(translations, 3, "translations")
    if quaternions is not None:
        turns = finite_rows(quaternions, 4, "quaternions")
        sizes = _lengths(turns)
        off = np.abs(sizes - 1) > UNIT_TOLERANCE
        if off.any():
            n = int(np.argmax(off))
            raise InputError(f"quaternion {n} has length {sizes[n]:.6g}, expected 1 (within {UNIT_TOLERANCE:g})")
    elif rotation_vectors is not None:
        vectors = _angles(rotation_vectors, "rotation vectors")
        turns = from_vectors(np.radians(vectors) if degrees else vectors)
    elif euler is not None:
        angles = _angles(euler[1], "Euler angles")
        turns = _from_euler(euler[0], np.radians(angles) if degrees else angles)
    else:
        turns = np.array([[1.0, 0.0, 0.0, 0.0]])
    if len(shift) != len(turns) and 1 not in (len(shift), len(turns)):
        raise InputError(f"{len(shift)} translations but {len(turns)} turns")
    number = max(len(shift), len(turns)) if len(shift) and len(turns) else 0
    if number == 0:
        raise InputError("there are no poses")
    return np.broadcast_to(shift, (number, 3)), np.broadcast_to(matrices(turns), (number, 3, 3))


def normalised_note(quaternions: Any) -> tuple[str, ...]:
    """Says how many quaternions of an array that `read_arrays` takes were normalised, if any."""
    off = np.abs(_lengths(finite_rows(quaternions, 4, "quaternions")) - 1)
    count = int((off > SILENT).sum())
    return (f"quaternions normalised: {count}, off from length 1 by up to {off.max():.2g}",) if count else ()


def matrices(quaternions: Floats) -> Floats:
    """Rotation matrices (N, 3, 3) of quaternions (N, 4) of any length but 0."""
    w, x, y, z = (quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def real_numbers(given: Any, what: str, hint: str) -> NDArray[Any]:
    """An array of real numbers of any kind. Raises InputError for others: truth values, complex and masked numbers,
    text, rows of unequal length.
    """
    try:
        found = np.asarray(given)
        if found.dtype.kind not in "iuf":
            if found.dtype.kind != "O":
                raise TypeError
            found = found.astype(np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{what} are not numbers of one shape", hint=hint) from None
    if hasattr(given, "mask") and np.ma.getmaskarray(given).any():  # numpy.ma takes a while to load
        raise InputError(f"{what}: some numbers are masked, so that they have no value", hint="leave these poses out")
    return found


def finite_rows(given: Any, width: int, what: str) -> Floats:
    """An array (N, width) of finite numbers; a single row stands for one. Raises InputError for others."""
    found = real_numbers(given, what, f"give an array of shape (N, {width})").astype(np.float64, copy=False)
    if found.ndim == 1 and found.shape[0] == width:
        found = found[None, :]
    if found.ndim != 2 or found.shape[1] != width:
        raise InputError(f"{what} of shape {found.shape}, expected (N, {width})")
    if not np.isfinite(found).all():
        n = int(np.argmax(~np.isfinite(found).all(axis=1)))
        raise InputError(f"{what}: row {n} is not finite: {found[n].tolist()}")
    return found


def _lengths(rows: Floats) -> Floats:
    """Of quaternions; infinite where a square is too large for floats."""
    with np.errstate(over="ignore"):
        return np.asarray(np.linalg.norm(rows, axis=1))


def _angles(given: Any, what: str) -> Floats:
    found = finite_rows(given, 3, what)
    if np.abs(found).max(initial=0.0) > MANY:
        raise too_many_turns()
    return found


def from_vectors(vectors: Floats) -> Floats:
    angle = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.concatenate([np.cos(angle / 2), np.sinc(angle / (2 * np.pi)) / 2 * vectors], axis=1)


def _from_euler(sequence: str, angles: Floats) -> Floats:
    check_sequence(sequence)
    order = range(3) if sequence.islower() else range(2, -1, -1)
    found = np.broadcast_to([1.0, 0.0, 0.0, 0.0], (len(angles), 4))
    for k in order:
        half = angles[:, k] / 2
        turn = np.zeros((len(angles), 4))
        turn[:, 0], turn[:, 1 + "xyz".index(sequence[k].lower())] = np.cos(half), np.sin(half)
        found = _product(turn, found)
    return found


def _product(p: Floats, q: Floats) -> Floats:
    u, v = p[:, 1:], q[:, 1:]
    scalar = p[:, :1] * q[:, :1] - (u * v).sum(axis=1, keepdims=True)
    return np.concatenate([scalar, p[:, :1] * v + q[:, :1] * u + np.cross(u, v)], axis=1)
