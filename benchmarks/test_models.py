"""Model files with twelve loops, closed or open in the file: read in this process, and from a cold one."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

LOOPS = 12


def ladder(lean: float) -> tuple[str, str, str]:
    """Parallelograms on top of each other, as URDF with its closures and as MJCF; one post of each leans."""
    urdf, loops, mjcf, equalities, end = '<robot name="ladder"><link name="n0"/>', [], "", "", ""
    hinge = (
        '<joint name="{0}" type="continuous"><parent link="{1}"/><child link="{2}"/><origin xyz="{3}" rpy="0 {4} 0"/>'
    )
    mass = '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>'
    for k in range(LOOPS):
        names = [f"{part}{k}" for part in "pqab"] + [f"n{k + 1}"]
        p, q, a, b, n = names
        urdf += "".join(f'<link name="{name}"/>' for name in names)
        for joint in (
            (f"j{p}", f"n{k}", p, "0 0 0", 0),
            (f"j{q}", f"n{k}", q, "1 0 0", lean),
            (f"j{n}", p, n, "0 0 1", 0),
        ):
            urdf += hinge.format(*joint) + '<axis xyz="0 1 0"/></joint>'
        for frame, link, at in ((a, q, "0 0 1"), (b, n, "1 0 0")):
            fixed = f'<joint name="j{frame}" type="fixed"><parent link="{link}"/><child link="{frame}"/>'
            urdf += f'{fixed}<origin xyz="{at}"/></joint>'
        loops.append(f"[{a}, {b}]")
        turn = '<joint axis="0 1 0"/>'
        post = f'<body name="{q}" pos="1 0 0" euler="0 {lean} 0">{turn}<site name="{a}" pos="0 0 1"/>{mass}</body>'
        rise = f'<body name="{p}"><joint axis="0 1 0"/>{mass}'
        mjcf += f'{post}{rise}<body name="{n}" pos="0 0 1"><joint axis="0 1 0"/><site name="{b}" pos="1 0 0"/>{mass}'
        equalities += f'<connect site1="{a}" site2="{b}"/>'
        end += "</body></body>"
    closures = f"closed_loop: [{', '.join(loops)}]\ntype: [{', '.join(['3d'] * LOOPS)}]\n"
    head = '<mujoco><compiler angle="radian"/><worldbody>'
    return urdf + "</robot>", closures, f"{head}{mjcf}{end}</worldbody><equality>{equalities}</equality></mujoco>"


@pytest.fixture(params=[0.0, 0.2], ids=["closed", "open"])
def files(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Path, Path, Path]:
    paths = tmp_path / "l.urdf", tmp_path / "l.yaml", tmp_path / "l.xml"
    for path, text in zip(paths, ladder(request.param), strict=True):
        path.write_text(text)
    return paths


def test_read(ratio: Callable[..., Any], peer: Callable[[str], Any], files: tuple[Path, Path, Path]) -> None:
    """Ours closes the loops; MuJoCo's reader compiles the model, and leaves open what is open."""
    from gcrules.mechanisms.models.reading import read_model

    urdf, closures, mjcf = files
    mujoco = peer("mujoco")
    others = {"MJCF": lambda: read_model(mjcf), "MuJoCo": mujoco and (lambda: mujoco.MjModel.from_xml_path(str(mjcf)))}
    ratio(lambda: read_model(urdf, closures), others, within=0.5, rounds=3)


def test_cold(ratio: Callable[..., Any], files: tuple[Path, Path, Path]) -> None:
    code = "import sys; from gcrules.mechanisms.models.reading import read_model; read_model(*sys.argv[1:])"
    ours = [sys.executable, "-c", code, str(files[0]), str(files[1])]
    others = {"NumPy alone": lambda: subprocess.run([sys.executable, "-c", "import numpy"], check=True)}
    ratio(lambda: subprocess.run(ours, check=True), others, within=1.0, rounds=3)
