"""The widget in a real JupyterLab: what is moved in the page is read in Python, and the other way round."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from places import EXAMPLES

pytest.importorskip("playwright", reason="needs the extra gcrules[dev]")

pytestmark = pytest.mark.browser

PROGRAM = os.environ.get("GCRULES_JUPYTERLAB") or shutil.which("jupyter-lab")
CELLS = (
    "import gcrules as gc\nshown = gc.view('robot.yaml')\nshown",
    "print(shown.pose['translation'], shown.verdict)",
    "shown.pose = 'z=25'",
)
RUN = """async n => {
  const panel = jupyterapp.shell.currentWidget;
  await panel.sessionContext.ready;
  panel.content.activeCellIndex = n;
  await jupyterapp.commands.execute("notebook:run-cell");
  return panel.content.widgets[n].model.outputs.toJSON().map(output => output.text ?? ""); }"""
"""The outputs of a cell that is run."""


def notebook() -> dict[str, Any]:
    cells: list[dict[str, Any]] = [
        {"cell_type": "code", "id": f"c{n}", "metadata": {}, "execution_count": None, "outputs": [], "source": code}
        for n, code in enumerate(CELLS)
    ]
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    return {"cells": cells, "metadata": {"kernelspec": kernel}, "nbformat": 4, "nbformat_minor": 5}


@pytest.fixture
def address(tmp_path: Path) -> Iterator[str]:
    """Of the notebook in a JupyterLab that knows no other settings, files and kernels than its own."""
    if PROGRAM is None:
        pytest.skip("needs jupyter-lab, not found; `make lab` installs it in an environment of its own")
    shutil.copy(EXAMPLES / "octahedral.yaml", tmp_path / "robot.yaml")
    (tmp_path / "robot.ipynb").write_text(json.dumps(notebook()), encoding="utf-8")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    own = {
        name: str(tmp_path / "own")
        for name in ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR")
    }
    command = [
        PROGRAM,
        "--no-browser",
        "--allow-root",
        "--ip=127.0.0.1",
        f"--port={port}",
        "--IdentityProvider.token=known",
        f"--ServerApp.root_dir={tmp_path}",
        "--LabApp.expose_app_in_browser=True",
        f"--LabApp.workspaces_dir={tmp_path / 'own'}",
        f"--LabApp.user_settings_dir={tmp_path / 'own'}",
    ]
    quiet = subprocess.DEVNULL
    with subprocess.Popen(command, cwd=tmp_path, env=os.environ | own, stdout=quiet, stderr=quiet) as server:
        try:
            until(lambda: listens(port))
            yield f"http://127.0.0.1:{port}/lab/tree/robot.ipynb?token=known"
        finally:
            server.terminate()


def listens(port: int) -> bool:
    with socket.socket() as line:
        return line.connect_ex(("127.0.0.1", port)) == 0


def until(ready: Callable[[], bool], seconds: float = 120) -> None:
    end = time.monotonic() + seconds
    while not ready():
        assert time.monotonic() < end
        time.sleep(0.1)


def test_the_pose_goes_both_ways(chromium: Any, address: str) -> None:
    page = chromium.new_page(viewport={"width": 1200, "height": 1000})
    page.set_default_timeout(120_000)
    page.goto(address)
    page.wait_for_function("() => window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel")
    page.evaluate(RUN, 0)
    names, numbers = (page.locator(f".jp-OutputArea .gcx-numbers {tag}") for tag in ("dt", "dd"))
    numbers.first.wait_for()
    for name, number in zip(names.all(), numbers.all(), strict=True):
        left, right = name.bounding_box(), number.bounding_box()
        assert right["x"] >= left["x"] + left["width"], "they stand side by side"
        assert abs(left["y"] - right["y"]) < 8
    slider = page.get_by_label("shift along z").first
    slider.evaluate("""e => { e.value = "12";
        for (const kind of ["input", "change"]) e.dispatchEvent(new Event(kind, {bubbles: true})); }""")
    until(lambda: page.evaluate(RUN, 1) == ["[0.0, 0.0, 12.0] regular\n"])
    margin = numbers.last.inner_text()
    page.evaluate(RUN, 2)
    until(lambda: slider.input_value() == "25")
    assert numbers.last.inner_text() != margin
    page.close()
