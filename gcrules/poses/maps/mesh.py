r"""A surface as triangles, and the files that hold one: PLY (Stanford) and GLB (binary glTF 2.0).

Places and normals are in the axes' coordinates; in files x, y and z come first and in this order, however the axes were
given, so that no surface is mirrored. In a GLB the z axis of a map of lengths points up, and lengths are in metres, as
glTF wants it; coordinates in mixed units are left as they are.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.budget import checkpoint
from gcrules.core.frozen import HoldsArrays
from gcrules.views.drawing.palette import LIGHT

__all__ = ["SHEETS", "Mesh", "glb", "ply"]

Floats = NDArray[np.float64]
Integers = NDArray[np.int32]

SHEETS = ("entity2", "entity1", "entity3", "entity4", "entity5", "entity6")
"""The colours of sheets, in order."""

_METRES = {"m": 1.0, "dm": 0.1, "cm": 0.01, "mm": 0.001, "um": 1e-6, "in": 0.0254, "ft": 0.3048}


@dataclass(frozen=True, eq=False)
class Mesh(HoldsArrays):
    """`vertices` and unit `normals` (V, 3), `faces` (F, 3); `sheet` (V,) is the factor that is 0 there; `allowed` (V,)
    says which vertices keep to the limits of leg lengths; `accurate` which were brought onto the zero set.

    Normals point to where the sheet's factor (or the superbracket) is positive, and so do the faces.
    """

    vertices: Floats
    normals: Floats
    faces: Integers
    sheet: NDArray[np.uint8]
    allowed: NDArray[np.bool_]
    accurate: NDArray[np.bool_]
    names: tuple[str, ...]
    units: tuple[str, ...]
    about: Mapping[str, Any]

    @property
    def sheets(self) -> int:
        return int(self.sheet.max()) + 1 if len(self.sheet) else 0

    def colours(self) -> NDArray[np.uint8]:
        """Red, green, blue of each vertex; paler where the legs do not reach."""
        table = np.array([[int(LIGHT[role][k : k + 2], 16) for k in (1, 3, 5)] for role in SHEETS])
        found = table[self.sheet % len(SHEETS)]
        return np.where(self.allowed[:, None], found, (found + 2 * 225) // 3).astype(np.uint8)

    def __repr__(self) -> str:
        return f"<Mesh of {len(self.faces):,} triangles in {self.sheets} sheets>"


def _in_order(m: Mesh) -> Mesh:
    """With the coordinates in the order x, y, z, turns last."""
    order = sorted(range(3), key=lambda k: (m.names[k] not in "xyz", m.names[k] if m.names[k] in "xyz" else ""))
    odd = order in ([0, 2, 1], [1, 0, 2], [2, 1, 0])  # that turns triangles round
    return replace(
        m,
        vertices=m.vertices[:, order],
        normals=m.normals[:, order],
        faces=np.ascontiguousarray(m.faces[:, ::-1]) if odd else m.faces,
        names=tuple(m.names[k] for k in order),
        units=tuple(m.units[k] for k in order),
    )


def ply(m: Mesh) -> bytes:
    """The mesh as binary PLY, with normals, colours, sheets and limits for each vertex."""
    m = _in_order(m)
    axes = ", ".join(f"{p} = {n}{f' [{u}]' if u else ''}" for p, n, u in zip("xyz", m.names, m.units, strict=True))
    comments = [axes, *(f"{k}: {v}" for k, v in m.about.items())]
    header = [
        "ply",
        "format binary_little_endian 1.0",
        *(f"comment {' '.join(c.split())}" for c in comments),
        f"element vertex {len(m.vertices)}",
        *(f"property double {c}" for c in "xyz"),
        *(f"property float n{c}" for c in "xyz"),
        *(f"property uchar {c}" for c in ("red", "green", "blue", "sheet", "allowed")),
        f"element face {len(m.faces)}",
        "property list uchar int vertex_indices",
        "end_header",
        "",
    ]
    vertex = np.empty(
        len(m.vertices), dtype=[("at", "<f8", 3), ("normal", "<f4", 3), ("colour", "u1", 3), ("s", "u1"), ("a", "u1")]
    )
    vertex["at"], vertex["normal"], vertex["colour"] = m.vertices, m.normals, m.colours()
    vertex["s"], vertex["a"] = m.sheet, m.allowed
    face = np.empty(len(m.faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
    face["n"], face["v"] = 3, m.faces
    text = "\n".join(header).encode("ascii", "backslashreplace")
    return text + vertex.tobytes() + face.tobytes()


def glb(m: Mesh) -> bytes:
    """The mesh as binary glTF 2.0: one primitive for each sheet, with normals and colours."""
    m = _in_order(m)
    lengths = set(m.units) <= set(_METRES) and len(set(m.units)) == 1 and set(m.names) <= set("xyz")
    scale = _METRES[m.units[0]] if lengths else 1.0
    middle = (m.vertices.min(axis=0) + m.vertices.max(axis=0)) / 2 if len(m.vertices) else np.zeros(3)
    colours = np.concatenate([m.colours(), np.full((len(m.vertices), 1), 255, np.uint8)], axis=1)
    blob = bytearray()
    views: list[dict[str, Any]] = []
    accessors: list[dict[str, Any]] = []

    def add(data: NDArray[Any], kind: str, component: int, target: int, **extra: Any) -> int:
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": data.nbytes, "target": target})
        blob.extend(data.tobytes())
        accessors.append(
            {"bufferView": len(views) - 1, "componentType": component, "count": len(data), "type": kind, **extra}
        )
        return len(accessors) - 1

    primitives = []
    for sheet in range(m.sheets):
        checkpoint()
        used = np.flatnonzero(m.sheet == sheet)
        if not len(used):
            continue
        number = np.zeros(len(m.vertices), dtype=np.uint32)
        number[used] = np.arange(len(used))
        faces = number[m.faces[m.sheet[m.faces[:, 0]] == sheet]].astype("<u4").reshape(-1)
        places = (m.vertices[used] - middle).astype("<f4")
        limits = {"min": places.min(axis=0).tolist(), "max": places.max(axis=0).tolist()}
        primitives.append(
            {
                "attributes": {
                    "POSITION": add(places, "VEC3", 5126, 34962, **limits),
                    "NORMAL": add(m.normals[used].astype("<f4"), "VEC3", 5126, 34962),
                    "COLOR_0": add(colours[used], "VEC4", 5121, 34962, normalized=True),
                },
                "indices": add(faces, "SCALAR", 5125, 34963),
                "material": 0,
            }
        )
    half = 0.5**0.5
    # From the middle of the surface back to its place, then z up → y up; scale, rotation, translation in this order.
    x, y, z = (middle * scale).tolist()
    document: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": str(m.about.get("source", "gcrules")), "extras": dict(m.about)},
        "scene": 0,
        "scenes": [{"nodes": [0] if primitives else []}],
        "nodes": [
            {
                "name": "singular surface",
                "scale": [scale] * 3,
                "rotation": [-half, 0, 0, half],
                "translation": [x, z, -y],
                "extras": {"axes": list(m.names), "units": list(m.units)},
            }
        ],
        "materials": [
            {
                "name": "singular",
                "doubleSided": True,
                "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0, "roughnessFactor": 0.7},
            }
        ],
    }
    if primitives:
        document["nodes"][0]["mesh"] = 0
        document["meshes"] = [{"name": "singular surface", "primitives": primitives}]
        document["accessors"], document["bufferViews"] = accessors, views
        document["buffers"] = [{"byteLength": len(blob)}]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    parts = struct.pack("<II", len(text), 0x4E4F534A) + text
    if blob:
        blob += b"\0" * (-len(blob) % 4)
        parts += struct.pack("<II", len(blob), 0x004E4942) + bytes(blob)
    return struct.pack("<III", 0x46546C67, 2, 12 + len(parts)) + parts
