"""The pictures of docs/map.md; `python tools/map_pictures.py` writes them into docs/assets (needs gcrules[maps])."""

from __future__ import annotations

from pathlib import Path

import gcrules as gc

ROOT = Path(__file__).resolve().parent.parent

PICTURES = {
    "map-curves.svg": ("octahedral", ["x -300:300:121", "z -500:100:121"], {"limits": "leg lengths 120..560"}),
    "map-turns.svg": ("octahedral", ["rx -60:60:121 deg", "rz -180:180:121 deg"], {"at": "0 0 -100"}),
    "map-3-rps.svg": ("3-rps", ["roll -60:60:121 deg", "pitch -60:60:121 deg"], {}),
    "map-surface.png": ("platform-6-6", ["x -2:2:61", "y -2:2:61", "z -2:1:61"], {"measure": "value"}),
}
"""Name: example or id of a robot, coordinates, options."""


def main() -> None:
    for name, (robot, over, options) in PICTURES.items():
        file = ROOT / "examples" / f"{robot}.yaml"
        found = gc.singular_map(file if file.exists() else robot, over, **options)  # type: ignore[arg-type]
        found.save(str(ROOT / "docs" / "assets" / name))


if __name__ == "__main__":
    main()
