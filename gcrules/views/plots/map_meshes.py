r"""Surfaces of maps as files: PLY (Stanford) and GLB (binary glTF 2.0).

Places and normals are in the axes' coordinates; in files x, y and z come first and in this order, however the axes were
given, so that no surface is mirrored. In a GLB the z axis of a map of lengths points up, and lengths are in metres, as
glTF wants it; coordinates in mixed units are left as they are.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.poses.maps.mesh import Mesh
from gcrules.screws.pose import METRES
from gcrules.views.drawing.palette import LIGHT

__all__ = ["SHEETS", "glb", "ply", "sheet_colours"]

SHEETS = ("entity2", "entity1", "entity3", "entity4", "entity5", "entity6")
"""The colours of sheets, in order."""


def sheet_colours() -> NDArray[np.uint8]:
    """Red, green, blue of each of `SHEETS`."""
    return np.array([list(bytes.fromhex(LIGHT[role][1:])) for role in SHEETS], dtype=np.uint8)


def _colours(m: Mesh) -> NDArray[np.uint8]:
    """Red, green, blue of each vertex; paler where the legs do not reach."""
    plain = sheet_colours().astype(int)[m.sheet % len(SHEETS)]
    return np.where(m.allowed[:, None], plain, (plain + 2 * 225) // 3).astype(np.uint8)


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
    vertex["at"], vertex["normal"], vertex["colour"] = m.vertices, m.normals, _colours(m)
    vertex["s"], vertex["a"] = m.sheet, m.allowed
    face = np.empty(len(m.faces), dtype=[("n", "u1"), ("v", "<i4", 3)])
    face["n"], face["v"] = 3, m.faces
    text = "\n".join(header).encode("ascii", "backslashreplace")
    return text + vertex.tobytes() + face.tobytes()


def glb(m: Mesh) -> bytes:
    """The mesh as binary glTF 2.0: one mesh for each sheet, with normals and colours, by trimesh."""
    import trimesh
    from trimesh.exchange.gltf import export_glb

    m = _in_order(m)
    lengths = set(m.units) <= set(METRES) and len(set(m.units)) == 1 and set(m.names) <= set("xyz")
    scale = METRES[m.units[0]] if lengths else 1.0
    middle = (m.vertices.min(axis=0) + m.vertices.max(axis=0)) / 2 if len(m.vertices) else np.zeros(3)
    place = np.zeros((4, 4))
    place[[0, 1, 2, 3], [0, 2, 1, 3]] = scale, scale, -scale, 1  # z up → y up
    place[:3, 3] = place[:3, :3] @ middle  # places are single precision: near the middle they are exact
    scene = trimesh.Scene(metadata={"axes": list(m.names), "units": list(m.units)})
    material = trimesh.visual.material.PBRMaterial(
        name="singular", doubleSided=True, baseColorFactor=[255, 255, 255, 255], metallicFactor=0.0, roughnessFactor=0.7
    )
    colours = np.column_stack([_colours(m), np.full(len(m.vertices), 255, np.uint8)])
    for sheet in range(m.sheets):
        used, faces = np.unique(m.faces[m.sheet[m.faces[:, 0]] == sheet], return_inverse=True)
        if not len(used):
            continue
        part = trimesh.Trimesh(
            m.vertices[used] - middle, faces.reshape(-1, 3), vertex_normals=m.normals[used], process=False
        )
        part.visual = trimesh.visual.TextureVisuals(material=material)
        part.visual.vertex_attributes["color"] = colours[used]
        scene.add_geometry(part, geom_name=f"sheet {sheet + 1}", transform=place)

    def described(tree: dict[str, Any]) -> None:
        tree["asset"] = {"version": "2.0", "generator": str(m.about.get("source", "gcrules")), "extras": dict(m.about)}

    return bytes(export_glb(scene, include_normals=True, tree_postprocessor=described))
