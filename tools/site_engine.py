"""Gather the engine that runs in the guide's pages: Pyodide, gcrules and the packages of Python that it loads.

``python tools/site_engine.py FOLDER`` fills the folder. Pyodide comes from the npm package that
tools/engine/package.json names, the packages from the environment that runs this; all of it is compiled ahead,
so that a page need not. Needs Node; nothing is fetched.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
import zipfile
from importlib import metadata
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HERE = ROOT / "tools" / "engine"
PYODIDE = HERE / "node_modules" / "pyodide"
FILES = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip")
PACKAGES = ("click", "lark", "PyYAML")
"""What the engine loads. NumPy is not among them: no registry has a build of it that a page could load. What exact
algebra uses of it is in engine/arrays.
"""
STUDIO = (ROOT / "gcrules/apps/studio/static", ROOT / "gcrules/views/static")
ROOT_ELEMENT = '<div id="studio"'
LEFT_OUT = ("gcrules/apps/studio/static/", "gcrules/apps/notebook/", "gcrules/_checkers/")


def gather(folder: Path) -> None:
    """Fill the folder anew. Raises OSError where Pyodide is not installed or Node fails."""
    if not PYODIDE.is_dir():
        raise OSError(f"{PYODIDE.relative_to(ROOT)} is missing: run npm ci in {HERE.relative_to(ROOT)}")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in FILES:
        shutil.copyfile(PYODIDE / name, folder / name)
    lock = json.loads((PYODIDE / "pyodide-lock.json").read_text(encoding="utf-8"))
    (folder / "pyodide-lock.json").write_text(json.dumps({**lock, "packages": {}}) + "\n", encoding="utf-8")
    with tempfile.TemporaryDirectory() as place:
        modules = Path(place)
        _unpack_gcrules(modules)
        shutil.copytree(HERE / "arrays", modules, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
        licences = [_unpack(name, modules) for name in PACKAGES]
        version = json.loads((PYODIDE / "package.json").read_text(encoding="utf-8"))["version"]
        (folder / "LICENSES.txt").write_text(_licences(version, lock["info"]["python"], licences), encoding="utf-8")
        node = ["node", "compile.mjs", str(modules), str((folder / "gcrules.zip").resolve())]
        if subprocess.run(node, cwd=HERE, check=False).returncode:
            raise OSError("Node could not compile the modules")


def tried(folder: Path, sessions: list[list[str]]) -> list[list[tuple[int, str]]]:
    """What the engine in a folder gives for examples of Python, page by page: exit codes, and what is printed. Raises
    OSError where Node fails.
    """
    asked = [[session[: n + 1] for n in range(len(session))] for session in sessions]
    with tempfile.TemporaryDirectory() as place:
        questions, answers = Path(place, "asked.json"), Path(place, "answers.json")
        questions.write_text(json.dumps(asked), encoding="utf-8")
        node = ["node", "sessions.mjs", str(folder.resolve()), str(questions), str(answers)]
        if subprocess.run(node, cwd=HERE, check=False).returncode:
            raise OSError("Node could not try the examples of Python")
        found = json.loads(answers.read_text(encoding="utf-8"))
    return [[(code, printed) for code, printed in page] for page in found]


def write_studio(folder: Path, worker: str) -> None:
    """The page of the studio as a folder of files, which asks the engine of a worker in place of a server."""
    for source in STUDIO:
        shutil.copytree(source, folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns("LICENSES.txt"))
    texts = [(source / "LICENSES.txt").read_text(encoding="utf-8") for source in STUDIO]
    (folder / "LICENSES.txt").write_text("\n".join(texts), encoding="utf-8")
    page = folder / "index.html"
    text = page.read_text(encoding="utf-8")
    page.write_text(text.replace(ROOT_ELEMENT, f'{ROOT_ELEMENT} data-engine="{worker}"'), encoding="utf-8")


def _unpack_gcrules(target: Path) -> None:
    """The modules, plugins and examples, where a wheel has them."""
    with tempfile.TemporaryDirectory() as place:
        build = [sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", place]
        subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
        (wheel,) = Path(place).glob("*.whl")
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(target, [n for n in archive.namelist() if not n.startswith(LEFT_OUT)])


def _unpack(name: str, target: Path) -> str:
    """The modules of an installed package, without what is compiled for this machine, and its licence."""
    found = metadata.distribution(name)
    licence = ""
    for path in found.files or ():
        if path.suffix in (".py", ".lark") and not path.parts[0].startswith((".", "_yaml")):
            place = target / path
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(Path(str(path.locate())), place)
        elif "licenses" in path.parts:
            licence += Path(str(path.locate())).read_text(encoding="utf-8")
    terms = found.metadata.json.get("license_expression") or found.metadata.json["license"]
    if not licence:
        raise OSError(f"{name} comes without the text of its licence")
    return f"{name} {found.version} ({terms})\n\n{licence.strip()}\n"


def _licences(pyodide: str, python: str, others: list[str]) -> str:
    own = (ROOT / "LICENSE").read_text(encoding="utf-8").strip()
    parts = [
        "What runs in the pages of this guide, and its licences.\n",
        f"gcrules (BSD-3-Clause)\n\n{own}\n",
        f"Pyodide {pyodide} (MPL-2.0)\n\nThe files pyodide.* are those of the npm package pyodide {pyodide}, "
        "unchanged. Their source and the licence, the Mozilla Public License 2.0, are at "
        "https://github.com/pyodide/pyodide and https://www.mozilla.org/MPL/2.0/.\n",
        f"Python {python} (PSF-2.0)\n\nPyodide contains CPython and its standard library (python_stdlib.zip). "
        "Copyright (c) 2001 Python Software Foundation; all rights reserved. The licence is at "
        "https://docs.python.org/3/license.html.\n",
        *others,
    ]
    return f"\n{'-' * 78}\n\n".join(parts)


if __name__ == "__main__":
    try:
        gather(Path(sys.argv[1]))
    except OSError as fault:
        sys.exit(f"site_engine: {fault}")
