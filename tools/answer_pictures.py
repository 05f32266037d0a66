"""The pictures of answers on the pages of the guide, as the commands that the pages show draw them.

``python tools/answer_pictures.py [NAME …]`` writes them, or some, into docs/assets (needs gcrules[maps]).
"""

from __future__ import annotations

import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

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


def main(names: list[str]) -> None:
    for name in names or PICTURES:
        draw(name, ROOT / "docs" / "assets" / name)


if __name__ == "__main__":
    main(sys.argv[1:])
