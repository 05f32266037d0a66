"""What files have in common that other programs check: exact numbers as texts, the platform, and a digest of all."""

from __future__ import annotations

import gzip
import hashlib
import json
from collections.abc import Iterable
from typing import Any, Protocol

from gcrules.core.errors import FileError
from gcrules.core.files import write_file
from gcrules.core.version import __version__
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.screws.pose import Pose

__all__ = ["Certified", "certificate_bytes", "platform_parts", "pose_parts", "signed", "texts", "write_certificate"]


class Certified(Protocol):
    """An answer that other programs check."""

    def certificate(self) -> dict[str, Any]: ...


def texts(numbers: Iterable[Any]) -> list[str]:
    """Exact numbers as texts."""
    return [str(c) for c in numbers]


def platform_parts(m: MovingPlatform) -> dict[str, Any]:
    """A platform on six legs: the base's point of each leg comes first."""
    return {
        "unit": m.unit,
        "legs": [list(leg) for leg in m.legs],
        "points": {n: texts(m.points[n]) for leg in m.legs for n in leg},
        "centre": texts(m.centre),
    }


def pose_parts(pose: Pose) -> dict[str, Any]:
    """An exact pose."""
    return {"translation": texts(pose.translation), "quaternion": texts(pose.quaternion)}


def signed(kind: str, title: str, **parts: Any) -> dict[str, Any]:
    """The object of a file of this format; `digest` is the SHA-256 of all else."""
    found = {"format": kind, "made by": f"gcrules {__version__}", "title": title, **parts}
    text = json.dumps(found, sort_keys=True, separators=(",", ":"))
    return {**found, "digest": hashlib.sha256(text.encode()).hexdigest()}


def write_certificate(answer: Certified, path: str) -> None:
    """Write the certificate of an answer, packed where the name ends in .gz. Raises FileError for a name of something
    else, and as its `certificate`.
    """
    if not path.lower().endswith((".json", ".json.gz")):
        raise FileError("not a name for a certificate", filename=path, hint="certificates end in .json or .json.gz")
    write_file(path, certificate_bytes(answer, packed=path.lower().endswith(".gz")), at_once=True)


def certificate_bytes(answer: Certified, *, packed: bool) -> bytes:
    """What such a file holds. Raises as the answer's `certificate`."""
    text = json.dumps(answer.certificate(), separators=(",", ":")).encode() + b"\n"
    return gzip.compress(text, mtime=0) if packed else text
