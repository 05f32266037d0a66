"""Try what a release would publish: the sdist, the wheel made of it, and both on every Python that is here.

``python tools/release_check.py FOLDER`` works in the folder. It checks that the tag of this commit, if there is one,
the version, the citation and the changelog agree; builds the sdist, and the wheel from the unpacked sdist, where there
is no git; installs the wheel in an environment for each Python with the lowest and the newest packages that it allows,
asks a few questions there, and looks for what the answers have to say. `--all` installs the extra `all` as well. What
could not be tried is listed; the exit code is 1 where something failed.
"""

from __future__ import annotations

import argparse
import re
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MINORS = (11, 12, 13, 14)
RESOLUTIONS = ("lowest", "newest")
UV = "uv>=0.5,<1"
EXPRESSION = "[abfc][acde][bdef] + [abfd][acbe][cdef]"
QUESTIONS: tuple[tuple[tuple[str, ...], str], ...] = (
    (("--version",), "gcrules {version}"),
    (("analyze", "ab af cb cd ed ef"), "the four planes abc, aef, bdf and cde meet in a point"),
    (("prove", "ab /\\ cd == [abcd]"), "proved"),
    (("factor", EXPRESSION), "abc"),
    (("robot", "analyze", "3-rps"), "The robot is singular exactly when"),
    (("robot", "pose", "3-rps", "--at", "z=0.2, roll=5deg, pitch=0deg"), "regular"),
    (("locus", "3-rpr", "--over", "x, y"), "A pose is singular exactly where one of them is 0"),
)
"""What is asked of an installation, and what its answer contains."""
EXTRAS = ("matplotlib", "numba", "starlette", "uvicorn", "websockets", "anywidget", "xarray", "trimesh", "distributed")
"""What the extra `all` brings, among others."""


@dataclass(frozen=True)
class Trial:
    """One installation: what was tried, and what was wrong, "" for nothing, None where it could not be tried; `what` is
    the sort of packages.
    """

    name: str
    fault: str | None
    remark: str = ""
    what: str = ""

    @property
    def line(self) -> str:
        state = "left out" if self.fault is None else "failed" if self.fault else "ok"
        return f"{self.name:28} {state:9} {self.fault or self.remark}".rstrip()


class Failed(Exception):
    """A program ended with an error; the message is what it printed last."""


def run(*command: str | Path, cwd: Path = ROOT) -> str:
    done = subprocess.run([*map(str, command)], cwd=cwd, capture_output=True, encoding="utf-8", check=False)
    if done.returncode:
        lines = (done.stderr or done.stdout).strip().splitlines()
        raise Failed(" ".join(lines[-4:])[-500:] or f"{command[0]} ended with code {done.returncode}")
    return done.stdout


# --- what is said of the release -------------------------------------------------------------------------------------


def version_of(tree: Path) -> str:
    """The version that a tree of the sources names."""
    text = (tree / "gcrules" / "core" / "version.py").read_text(encoding="utf-8")
    found = re.search(r'^__version__ = "([^"]+)"$', text, re.MULTILINE)
    if found is None:
        raise Failed("gcrules/core/version.py names no version")
    return found[1]


def tag_of(tree: Path) -> str | None:
    """The tag of the commit that is checked out, None where it has none, or there is no git."""
    try:
        return run("git", "describe", "--tags", "--exact-match", "--match", "v[0-9]*", cwd=tree).strip()
    except (Failed, FileNotFoundError):
        return None


def disagreements(tree: Path, tag: str | None) -> Iterator[str]:
    """Where version, tag, citation and changelog do not agree. Of a version without a tag the changelog may say that it
    is to come.
    """
    version = version_of(tree)
    if tag is not None and tag != f"v{version}":
        yield f"the tag is {tag}, the version {version}"
    citation = (tree / "CITATION.cff").read_text(encoding="utf-8")
    if f"\nversion: {version}\n" not in citation:
        yield f"CITATION.cff does not name the version {version}"
    if tag is not None and not re.search(r"^date-released: \d{4}-\d\d-\d\d$", citation, re.MULTILINE):
        yield "CITATION.cff has no date-released"
    changes = (tree / "CHANGELOG.md").read_text(encoding="utf-8")
    named = re.search(rf"^## \[{re.escape(version)}\] - \d{{4}}-\d\d-\d\d$", changes, re.MULTILINE)
    if not named and (tag is not None or f"\nBecomes {version}.\n" not in changes):
        yield f"CHANGELOG.md has no section of {version}"


# --- building and trying ----------------------------------------------------------------------------------------------


def build(folder: Path) -> tuple[Path, Path]:
    """The sdist of this tree, and the wheel of the unpacked sdist."""
    for old in folder.glob("gcrules-*"):
        shutil.rmtree(old) if old.is_dir() else old.unlink()
    hatchling = (sys.executable, "-m", "hatchling", "build", "--directory", folder, "--target")
    run(*hatchling, "sdist")
    (sdist,) = folder.glob("gcrules-*.tar.gz")
    with tarfile.open(sdist) as archive:
        archive.extractall(folder, filter="data")
    run(*hatchling, "wheel", cwd=folder / sdist.name.removesuffix(".tar.gz"))
    (wheel,) = folder.glob("gcrules-*.whl")
    return sdist, wheel


def interpreter(minor: int) -> Path | None:
    """A Python 3.minor that runs: of the path, of pyenv, or the one that runs this."""
    of_pyenv = sorted((Path.home() / ".pyenv" / "versions").glob(f"3.{minor}.*/bin/python3"), reverse=True)
    named = shutil.which(f"python3.{minor}")
    own = [Path(sys.executable)] if sys.version_info[:2] == (3, minor) else []
    for place in [*([Path(named)] if named else []), *of_pyenv, *own]:
        try:
            if run(place, "-c", "import sys, venv; print(sys.version_info[1])").strip() == str(minor):
                return place
        except (Failed, OSError):
            continue
    return None


def uv_in(folder: Path) -> Path | None:
    """uv, which finds the lowest packages; installed into the folder where it is not there. None where it is not to be
    had.
    """
    here = shutil.which("uv")
    if here:
        return Path(here)
    place = folder / "uv"
    if not (place / "bin" / "uv").is_file():
        try:
            run(sys.executable, "-m", "pip", "--disable-pip-version-check", "install", "--target", place, UV)
        except Failed:
            return None
    return place / "bin" / "uv"


def try_it(python: Path, uv: Path | None, resolution: str, what: str, place: Path, version: str) -> str:
    """Install and ask; the versions of some packages. Raises Failed."""
    shutil.rmtree(place, ignore_errors=True)
    if uv is None:
        run(python, "-m", "venv", place)
        run(place / "bin" / "python", "-m", "pip", "--disable-pip-version-check", "install", what)
    else:
        run(uv, "venv", "--quiet", "--python", python, place)
        install = (uv, "pip", "install", "--quiet", "--python", place / "bin" / "python", "--only-binary", ":all:")
        if resolution == "lowest":  # of what gcrules itself asks for
            run(*install, "--resolution", "lowest-direct", "-r", ROOT / "pyproject.toml")
            run(*install, "--no-deps", what)
        else:
            run(*install, what)
    for question, wanted in QUESTIONS:
        answer = run(place / "bin" / "gcrules", *question, cwd=place)
        if wanted.format(version=version) not in answer:
            raise Failed(f"gcrules {' '.join(question)} answers {answer[:200]!r}")
    shown = "import sys; from importlib.metadata import version; print(*(f'{n} {version(n)}' for n in sys.argv[1:]))"
    return run(place / "bin" / "python", "-c", shown, "numpy", "sympy", "networkx", "click").strip().replace("\n", " ")


def try_all(python: Path, uv: Path | None, wheel: Path, place: Path, version: str) -> str:
    """Install the extra `all`; every package of it loads. Raises Failed."""
    shown = try_it(python, uv, "newest", f"gcrules[all] @ {wheel.resolve().as_uri()}", place, version)
    run(place / "bin" / "python", "-c", f"import {', '.join(EXTRAS)}")
    run(place / "bin" / "gcrules", "studio", "--help")
    return shown


def trials(folder: Path, wheel: Path, everything: bool) -> Iterator[Trial]:
    """One installation after the other."""
    version = version_of(ROOT)
    uv = uv_in(folder)
    for minor in MINORS:
        python = interpreter(minor)
        for resolution in RESOLUTIONS:
            name = f"Python 3.{minor}, {resolution} packages"
            if python is None or (uv is None and resolution == "lowest"):
                yield Trial(name, None, "there is no such Python" if python is None else "needs uv", resolution)
                continue
            try:
                place = folder / f"env-{minor}-{resolution}"
                yield Trial(name, "", try_it(python, uv, resolution, str(wheel), place, version), resolution)
            except Failed as fault:
                yield Trial(name, str(fault), what=resolution)
            shutil.rmtree(place, ignore_errors=True)
    if everything:
        python = next(filter(None, map(interpreter, (13, 12, 11))), None)
        try:
            yield Trial("gcrules[all]", "", try_all(python or Path(sys.executable), uv, wheel, folder / "all", version))
        except Failed as fault:
            yield Trial("gcrules[all]", str(fault))
        shutil.rmtree(folder / "all", ignore_errors=True)


def untried_in(seen: Sequence[Trial]) -> list[str]:
    """The sorts of packages that no Python was tried with: a check that left them out has not checked."""
    return [what for what in RESOLUTIONS if all(t.fault is None for t in seen if t.what == what)]


def main(arguments: Sequence[str]) -> int:
    parser = argparse.ArgumentParser(description="Try what a release would publish.")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--all", action="store_true", help="install the extra `all` too")
    options = parser.parse_args(arguments)
    folder: Path = options.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    tag = tag_of(ROOT)
    found = list(disagreements(ROOT, tag))
    print(f"version {version_of(ROOT)}, {f'tag {tag}' if tag else 'no tag'}")
    print(*(f"failed: {fault}" for fault in found), sep="\n", end="\n" if found else "")
    sdist, wheel = build(folder)
    print(f"built {sdist.name} and, from it, {wheel.name}")
    seen = []
    for trial in trials(folder, wheel, options.all):
        print(trial.line, flush=True)
        seen.append(trial)
    untried = untried_in(seen)
    print(*(f"failed: {what} packages were tried on no Python" for what in untried), sep="\n", end="\n" * bool(untried))
    return int(bool(found or untried) or any(trial.fault for trial in seen))


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except Failed as failure:
        sys.exit(f"release_check: {failure}")
