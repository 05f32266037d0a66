"""The pictures of answers on the pages of the guide, as the commands that the pages show draw them.

``python tools/answer_pictures.py [NAME …]`` writes them, or some, into docs/assets (needs gcrules[maps]);
``python tools/answer_pictures.py --check [NAME …]`` fails (exit code 1) where they are no longer what is drawn.
"""

from __future__ import annotations

import re
import shlex
import subprocess
import sys
import tempfile
from math import isclose
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ASSETS = ROOT / "docs" / "assets"

PICTURES = {
    "aspects-octahedral.svg": ("aspects examples/octahedral.yaml", "--picture"),
    "map-curves.svg": (
        'map examples/octahedral.yaml --over "x -300:300:121" --over "z -500:100:121" --limits "leg lengths 120..560"',
        "-o",
    ),
    "map-turns.svg": (
        'map examples/octahedral.yaml --over "rx -60:60:121 deg" --over "rz -180:180:121 deg" --at "0 0 -100"',
        "-o",
    ),
    "map-3-rps.svg": ('map 3-rps --over "roll -60:60:121 deg" --over "pitch -60:60:121 deg"', "-o"),
    "map-surface.png": (
        'map examples/platform-6-6.yaml --over "x -2:2:61" --over "y -2:2:61" --over "z -2:1:61" --measure value',
        "-o",
    ),
    "modes-octahedral.svg": ("modes examples/octahedral.yaml", "--picture"),
    "free-octahedral.svg": ('free examples/octahedral.yaml --over "x 100, z 150, rz 30 deg"', "--picture"),
    "locus-four-dof.svg": ("locus examples/four-dof.yaml --over t1,t2 --rotation zyx", "--picture"),
    "locus-octahedral.svg": ("locus examples/octahedral.yaml --over z", "--picture"),
    "path-octahedral.svg": (
        'path examples/octahedral.yaml --at "0 0 0" --at "0 0 -400; euler zyx 90 0 0 deg"',
        "--plot",
    ),
    "path-3-rps.svg": (
        'path 3-rps --at home --at "z=0.2, roll=20deg, pitch=10deg" --at "z=-0.3, roll=0deg, pitch=60deg"',
        "--plot",
    ),
    "plan-octahedral.svg": (
        'plan examples/octahedral.yaml --from "-36.9 75 87.5; rotvec 85.27 -39.32 115.91 deg"'
        ' --to "215.1 70.5 125.5; rotvec 2.3 -27.94 46.06 deg" --margin 0.02',
        "--plot",
    ),
    "rotary-hexapod.svg": ("analyze examples/models/rotary-hexapod.xml", "--figure"),
    "tutorial-hexapod.svg": ("analyze examples/tutorial/hexapod.yaml", "--figure"),
    "tutorial-hexapod-path.svg": ('path examples/tutorial/hexapod.yaml --at "0 0 0" --at "yaw=100deg"', "--plot"),
    "tutorial-hexapod-map.svg": (
        'map examples/tutorial/hexapod.yaml --over "x -120:120:25" --over "yaw -100:100:41 deg"',
        "-o",
    ),
    "tutorial-tripod.svg": ("robot analyze examples/tutorial/tripod.yaml", "--figure"),
    "tutorial-tripod-path.svg": (
        'path examples/tutorial/tripod.yaml --at home --at "roll=80deg, z=0, pitch=0deg"',
        "--plot",
    ),
    "tutorial-tripod-modes.svg": ("modes examples/tutorial/tripod.yaml", "--picture"),
}
"""Name: arguments of `gcrules`, and the option that names the file."""


def draw(name: str, file: Path) -> None:
    """Draw one of them.

    Raises:
        subprocess.CalledProcessError: the command fails.
    """
    arguments, option = PICTURES[name]
    command = [str(Path(sys.executable).parent / "gcrules"), *shlex.split(arguments), option, str(file)]
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL)


LONG = ("map-3-rps.svg",)
"""Those that take longer than all others together."""

_NUMBER = re.compile(r"-?\d+\.?\d*(?:e-?\d+)?")
_ID = re.compile(r'(?<=id=")[^"]+|(?<=#)\w+(?=[")])')
_RASTER = re.compile(r'(?<=;base64,)[^"]+')
_OFF = 0.15  # points by which a number of a picture may differ from one machine to another
_SHADE = 0.01  # of all shades, by which pixels may on the average


def same(one: Path, other: Path) -> bool:
    """Whether two files show the same picture, up to what machines round differently."""
    return (_same_pixels if one.suffix == ".png" else _same_shapes)(one, other)


def _same_shapes(one: Path, other: Path) -> bool:
    """Two SVG files: the same shapes and words, with nearly the same numbers."""
    texts = [_with_own_ids(path.read_text(encoding="utf-8")) for path in (one, other)]
    if _NUMBER.sub("0", texts[0]) != _NUMBER.sub("0", texts[1]):
        return False
    pairs = zip(*(map(float, _NUMBER.findall(text)) for text in texts), strict=True)
    return all(isclose(x, y, abs_tol=_OFF) for x, y in pairs)


def _with_own_ids(svg: str) -> str:
    """The text with names that say only which of them is meant, and without the pixels of pictures in it."""
    names: dict[str, str] = {}
    plain = _RASTER.sub("", re.sub(r"\s+", " ", svg))
    return _ID.sub(lambda m: m[0] if _is_colour(m[0]) else names.setdefault(m[0], f"name{len(names)}"), plain)


def _is_colour(word: str) -> bool:
    return bool(re.fullmatch(r"[0-9a-fA-F]{6}", word))


def _same_pixels(one: Path, other: Path) -> bool:
    from matplotlib.image import imread

    pixels, others = imread(one), imread(other)
    return pixels.shape == others.shape and abs(pixels - others).mean() < _SHADE


def stale(names: list[str]) -> list[str]:
    """Those pictures that are not what their commands draw now."""
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            draw(name, Path(folder) / name)
        return [name for name in names if not same(Path(folder) / name, ASSETS / name)]


def main(arguments: list[str]) -> int:
    names = [name for name in arguments if name != "--check"] or list(PICTURES)
    if "--check" in arguments:
        found = stale(names)
        for name in found:
            print(f"docs/assets/{name} is stale (python tools/answer_pictures.py {name})")
        return 1 if found else 0
    for name in names:
        draw(name, ASSETS / name)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
