"""The project as a whole: versions, what an import loads, what a wheel carries, what no file may mention."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tomllib
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest
import yaml

import gcrules

SHIPPED = {
    "gcrules": "gcrules",
    "checkers": "gcrules/_checkers",
    "plugins": "gcrules/_plugins",
    "examples": "gcrules/_examples",
}
LOADED_WHEN_USED = {"sympy", "scipy", "networkx", "matplotlib", "colorama", "rich"}


def files_of(root: Path, *patterns: str) -> list[Path]:
    """The files that git tracks or would add, relative to the root; skips the test outside a checkout."""
    command = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *patterns]
    try:
        listing = subprocess.run(command, cwd=root, capture_output=True, check=True).stdout
    except (FileNotFoundError, subprocess.CalledProcessError):
        pytest.skip("needs git and a git checkout")
    names = [Path(name) for name in listing.decode().split("\0") if name]
    return sorted(name for name in names if (root / name).is_file())


def test_one_version(root: Path) -> None:
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    citation = yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))
    assert project["dynamic"] == ["version"]  # of gcrules itself, see [tool.hatch.version]
    assert gcrules.__version__ == str(citation["version"])
    assert citation["license"] == project["license"].partition(" AND ")[0]


def test_the_citation_is_whole(root: Path) -> None:
    """What the format asks for; the date comes with a release (tools/release_check.py)."""
    citation = yaml.safe_load((root / "CITATION.cff").read_text(encoding="utf-8"))
    assert citation["cff-version"] == "1.2.0"
    assert {"message", "title", "authors"} <= citation.keys()
    assert [author["name"] for author in citation["authors"]] == ["The gcrules developers"]
    released = f"## [{citation['version']}]" in (root / "CHANGELOG.md").read_text(encoding="utf-8")
    assert ("date-released" in citation) is released


def test_the_licence_names_all_that_is_brought_along(root: Path) -> None:
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    own, *others = project["license"].split(" AND ")
    assert own == "BSD-3-Clause"
    texts = [(root / name).read_text(encoding="utf-8") for name in project["license-files"] if name != "LICENSE"]
    brought = re.findall(r"^(?:@[\w-]+/)?[a-z][\w.-]* \d[\d.]* \(([\w.-]+)\)$", "\n".join(texts), re.MULTILINE)
    assert len(brought) > 15
    assert set(brought) == set(others)
    bundled = {p.relative_to(root).as_posix() for p in (root / "gcrules").rglob("LICENSES.txt")}
    assert bundled <= set(project["license-files"])


def test_requirements_are_bounded(root: Path) -> None:
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"].values()
    requirements = [*project["dependencies"], *(requirement for extra in extras for requirement in extra)]
    assert requirements
    unbounded = [r for r in requirements if not r.startswith("gcrules[") and not re.search(r">=[\d.]+,<[\d.]+$", r)]
    assert unbounded == []


def test_import_loads_no_heavy_library() -> None:
    code = "import sys; before = set(sys.modules); import gcrules; print(*sorted(set(sys.modules) - before))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = {name.partition(".")[0] for name in done.stdout.split()}
    assert "gcrules" in loaded
    assert loaded & LOADED_WHEN_USED == set()


def test_the_analysis_of_six_legs_loads_no_numbers_and_no_pages() -> None:
    """From Python as from the shell: reports, robots of joints and NumPy are loaded when they are asked for."""
    code = "import sys, gcrules; gcrules.analyze('ab af cb cd ed ef'); print(*sys.modules)"
    loaded = set(
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    )
    assert "gcrules.conditions.analysis" in loaded
    assert not loaded & {"numpy", "sympy", "matplotlib", "gcrules.views.report.report"}


def test_the_core_imports_nothing_above_it(root: Path) -> None:
    """Errors are part of the core, though they stand beside it."""
    modules = sorted((root / "gcrules" / "core").glob("*.py"))
    assert len(modules) > 5
    imported = re.compile(r"^\s*(?:from|import)\s+(gcrules[\w.]*)", re.MULTILINE)
    found = {name for path in modules for name in imported.findall(path.read_text(encoding="utf-8"))}
    assert "gcrules.core.errors" in found
    assert {n for n in found if n != "gcrules.core.errors" and not re.match(r"gcrules\.core\b", n)} == set()


def test_no_file_mentions_a_machine(root: Path) -> None:
    """Paths of the machine that a file was written on mean nothing to anybody else."""
    machine_path = re.compile(rf"(^|[^A-Za-z0-9_.])/({'|'.join(('work', 'farm'))})/", re.MULTILINE)
    assert machine_path.search("see /{}/x".format("work"))
    files = files_of(root)
    assert Path("pyproject.toml") in files
    found = [
        f"{name}:{text.count(chr(10), 0, match.start()) + 1}"
        for name in files
        for text in [(root / name).read_text(encoding="utf-8", errors="replace")]
        for match in machine_path.finditer(text)
    ]
    assert found == []


@pytest.fixture(scope="module")
def wheel(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel, built from the checkout without a network."""
    pytest.importorskip("hatchling", reason="needs hatchling to build the wheel (pip install -e '.[dev]')")
    out = tmp_path_factory.mktemp("wheel")
    pip(root, "wheel", "--no-deps", "--no-build-isolation", "--no-index", "--wheel-dir", str(out), ".")
    (built,) = out.glob("gcrules-*.whl")
    return built


def pip(cwd: Path, *arguments: str) -> None:
    command = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check", *arguments]
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def expected_files(root: Path) -> set[str]:
    """Where the wheel has to carry each file of the package, the plugins and the examples."""
    return {
        (Path(target) / name.relative_to(folder)).as_posix()
        for folder, target in SHIPPED.items()
        for name in files_of(root, folder)
    }


def test_wheel_carries_every_file(root: Path, wheel: Path) -> None:
    names = {name for name in zipfile.ZipFile(wheel).namelist() if name.startswith("gcrules/")}
    expected = expected_files(root)
    assert "gcrules/py.typed" in expected
    assert names == expected


def test_wheel_carries_the_licences(wheel: Path) -> None:
    names = zipfile.ZipFile(wheel).namelist()
    assert {n.partition("/licenses/")[2] for n in names if "/licenses/" in n} == {
        "LICENSE",
        "gcrules/apps/studio/static/LICENSES.txt",
        "gcrules/views/static/LICENSES.txt",
    }


def test_installed_wheel_finds_its_files(root: Path, wheel: Path, tmp_path: Path) -> None:
    target = tmp_path / "installed"
    pip(tmp_path, "install", "--no-deps", "--no-index", "--target", str(target), str(wheel))
    code = (
        "import json, gcrules; from importlib.resources import files; from pathlib import Path; "
        "top = Path(str(files('gcrules'))); "
        "print(json.dumps([gcrules.__file__, gcrules.__version__, "
        "[p.relative_to(top.parent).as_posix() for p in top.rglob('*') if p.is_file()]]))"
    )
    done = subprocess.run(
        [sys.executable, "-B", "-c", code],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(target)},
        capture_output=True,
        text=True,
        check=True,
    )
    where, version, found = json.loads(done.stdout)
    assert Path(where).is_relative_to(target)
    assert version == gcrules.__version__
    assert {name for name in found if not name.endswith(".pyc")} == expected_files(root)


def test_installed_wheel_writes_the_checkers(wheel: Path, tmp_path: Path) -> None:
    """Where there is no checkout the programs come with gcrules, and need nothing of it."""
    target = tmp_path / "installed"
    pip(tmp_path, "install", "--no-deps", "--no-index", "--target", str(target), str(wheel))
    environment = os.environ | {"PYTHONPATH": str(target)}
    code = "from gcrules.apps.main import main; raise SystemExit(main())"
    for words in (["checkers"], ["factor", "[[Aa, Ab, Bc, Cd, De, Ef]]", "--certificate", "proof.json"]):
        command = [sys.executable, "-B", "-c", code, *words]
        done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == words.count("factor"), done.stderr
    for program in ("check_proof.py", "recompute.py"):
        command = [sys.executable, "-S", f"checkers/{program}", "proof.json"]
        assert subprocess.run(command, cwd=tmp_path, capture_output=True, check=False).returncode == 0


@pytest.mark.browser
def test_browser_runs_scripts(run_browser: Callable[..., str], tmp_path: Path) -> None:
    page = tmp_path / "page.html"
    page.write_text("<p id=x></p><script>x.textContent = [1, 2, 3].map(i => i * i).join('-')</script>")
    assert '<p id="x">1-4-9</p>' in run_browser(page)
