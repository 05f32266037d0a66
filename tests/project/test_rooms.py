"""The house: every module stands in a room, imports go down only, and nowhere in a circle.

import-linter holds the layers (`make check`); here is what it does not see: names of functions that are imported when
they are called (`core.deferred`, tables of commands and views), and where imports may stand.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import networkx as nx
import pytest
from places import ROOT

ROOMS = ("core", "algebra", "screws", "rules", "conditions", "mechanisms", "poses", "views", "api", "apps")
PACKAGE = ROOT / "gcrules"
MODULES = sorted(p for p in PACKAGE.rglob("*.py"))

LATE = (
    *("lark", "yaml", "networkx", "mpmath", "numpy", "sympy"),  # which take long to load
    *("h5netcdf", "h5py", "matplotlib", "numba", "skimage", "trimesh", "xarray", "zarr"),  # extras of the
    "distributed",  # installation
    *("fcntl", "threading"),  # which few systems have; which few programs need
)
"""What may be imported inside a function."""


def name_of(path: Path) -> str:
    parts = path.relative_to(ROOT).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


NAMES = {name_of(p) for p in MODULES}


def module_named(dotted: str) -> str | None:
    """The longest beginning that names a module."""
    parts = dotted.split(".")
    return next((m for n in range(len(parts), 0, -1) if (m := ".".join(parts[:n])) in NAMES), None)


@cache
def walked(path: Path) -> tuple[ast.AST, ...]:
    """The parts of a module that tell what it imports, read once: imports and texts that may name modules."""
    parts = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
    return tuple(node for node in parts if isinstance(node, (ast.Import, ast.ImportFrom, ast.Constant)))


def imports(path: Path) -> Iterator[str]:
    """The modules of gcrules that a module imports, those inside functions and under TYPE_CHECKING among them."""
    for node in walked(path):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.split(".")[0] == "gcrules":
            for alias in node.names:
                found = module_named(f"{node.module}.{alias.name}")
                if found:
                    yield found
        elif isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name.split(".")[0] == "gcrules" and (found := module_named(alias.name)):
                    yield found


def deferred(path: Path) -> Iterator[str]:
    """The modules of gcrules that are named as "package.module:function"."""
    for node in walked(path):
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            match = re.fullmatch(r"(gcrules(?:\.\w+)+):\w+", node.value)
            if match:
                assert match[1] in NAMES, f"{path}: {node.value}"
                yield match[1]


def floor(module: str) -> int:
    """The height of a module's room; the package itself and its command stand above all."""
    parts = module.split(".")
    return ROOMS.index(parts[1]) if len(parts) > 1 and parts[1] in ROOMS else len(ROOMS)


def test_every_module_stands_in_a_room() -> None:
    assert {p.name for p in PACKAGE.iterdir() if p.is_dir() and p.name != "__pycache__"} == set(ROOMS)
    assert {p.name for p in PACKAGE.glob("*.py")} == {"__init__.py", "__main__.py"}


def test_imports_go_down() -> None:
    for path in MODULES:
        own = name_of(path)
        for module in (*imports(path), *deferred(path)):
            if own != "gcrules" and module != "gcrules":
                assert floor(module) <= floor(own), f"{own} imports {module}"


def test_there_is_no_circle() -> None:
    graph: nx.DiGraph[str] = nx.DiGraph()
    for path in MODULES:
        own = name_of(path)
        graph.add_edges_from((own, m) for m in imports(path) if m != own)
        if own not in ("gcrules", "gcrules.core.shown"):
            graph.add_edges_from((own, m) for m in deferred(path) if m != own)
    assert [sorted(c) for c in nx.strongly_connected_components(graph) if len(c) > 1] == []


def test_the_folders_of_poses_are_in_no_circle() -> None:
    graph: nx.DiGraph[str] = nx.DiGraph()
    for path in (PACKAGE / "poses").rglob("*.py"):
        own, *others = (".".join(m.split(".")[:3]) for m in (name_of(path), *imports(path), *deferred(path)))
        graph.add_edges_from((own, m) for m in others if m != own and m.startswith("gcrules.poses."))
    assert len(graph) > 10
    assert [sorted(c) for c in nx.strongly_connected_components(graph) if len(c) > 1] == []


@pytest.mark.parametrize("room", [*ROOMS, ""])
def test_only_large_libraries_are_imported_inside_functions(room: str) -> None:
    folder = PACKAGE / room
    for path in folder.rglob("*.py") if room else folder.glob("*.py"):
        for function in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(function, (ast.FunctionDef, ast.AsyncFunctionDef)):
                continue
            for node in ast.walk(function):
                if isinstance(node, ast.ImportFrom):
                    names = [node.module or ""]
                elif isinstance(node, ast.Import):
                    names = [a.name for a in node.names]
                else:
                    continue
                for name in names:
                    assert name.split(".")[0] in LATE, f"{path}:{node.lineno}: {name}"


def test_modules_are_small() -> None:
    lines = sorted(len(p.read_text(encoding="utf-8").splitlines()) for p in MODULES if p.stat().st_size)
    assert lines[len(lines) // 2] <= 130
    assert lines[-1] <= 400, [name_of(p) for p in MODULES if len(p.read_text(encoding="utf-8").splitlines()) > 400]
