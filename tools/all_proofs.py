#!/usr/bin/env python3
"""Write the proofs of the catalog, of all robots and of the theorems in the examples, and have others check them.

`make proofs` runs it: checkers/check_proof.py checks every file, checkers/recompute.py the absences of all classes
(that no expression of joins and meets exists, and no shorter polynomial), and Coq, where it is installed, all theorems.
Exit code 1 where a check fails.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from shutil import which

import gcrules as gc
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.core.errors import InputError
from gcrules.mechanisms.load import known_ids
from gcrules.mechanisms.proofs import proof_file
from gcrules.rules.catalog.file import load
from gcrules.rules.script import run_script
from gcrules.views.proofs.coq import without_script

ROOT = Path(__file__).resolve().parent.parent
CHECKER, RECOMPUTED = (ROOT / "checkers" / name for name in ("check_proof.py", "recompute.py"))


def proofs() -> Iterator[tuple[str, ProofFile]]:
    """Each group with its file."""
    yield "catalog", proof_file(load())
    for entry in load().entries:
        if entry.status == "always-singular":
            continue
        shortest, factored = gc.shorten(entry.structure.superbracket), gc.factor(entry.structure.superbracket)
        yield "absences", replace(proof_file(shortest), title=f"{entry.id}, shortest")
        if not factored.exists:
            yield "absences", replace(proof_file(factored), title=f"{entry.id}, factored")
    for name in known_ids("robot"):
        try:
            yield "robots", proof_file(gc.analyze(name))
        except InputError as fault:
            print(f"robots: {fault.message}")
    for path in sorted((ROOT / "examples" / "theorems").glob("*.gca")):
        found = run_script(parse_script(path.read_text(encoding="utf-8"), path.name))
        try:
            file = replace(proof_file(found), title=path.stem)
            yield "metric" if any(t.ideal for t in file.theorems) else "theorems", file
        except InputError as fault:
            print(f"{path.name}: {fault.message}")


def together(group: str, files: list[ProofFile]) -> ProofFile:
    """The theorems of a group in one file."""
    theorems = (replace(t, name=f"{file.title}: {t.name}") for file in files for t in file.theorems)
    absences = (replace(one, theorem=f"{file.title}: {one.theorem}") for file in files for one in file.absences)
    return ProofFile(group, tuple(theorems), tuple(one for file in files for one in file.left_out), tuple(absences))


def checked(path: Path) -> bool:
    """Whether the checker proves all theorems of a file."""
    done = subprocess.run([sys.executable, CHECKER, path], capture_output=True, text=True, check=False)
    print(f"{path.name}: {(done.stdout.splitlines() or [''])[-1]}{done.stderr}".rstrip())
    return done.returncode == 0


def recomputed(path: Path) -> bool:
    """Whether another program computes all absences of a file again."""
    done = subprocess.run([sys.executable, RECOMPUTED, path], capture_output=True, text=True, check=False)
    again = done.stdout.count("\nrecomputed, ") + done.stdout.startswith("recomputed, ")
    print(f"{path.name}: {again} of {done.stdout.count(', called ')} absences recomputed{done.stderr}")
    return done.returncode == 0


def compiled(path: Path) -> bool:
    """Whether Coq proves all theorems of a script, without axioms."""
    done = subprocess.run(["coqc", path.name], cwd=path.parent, capture_output=True, text=True, check=False)
    wanted = path.read_text(encoding="utf-8").count("\nPrint Assumptions ")
    closed = done.stdout.count("Closed under the global context")
    print(f"{path.name}: {closed} of {wanted} theorems proved by Coq, without axioms{done.stderr[:1000]}")
    return done.returncode == 0 and closed == wanted


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    groups: dict[str, list[ProofFile]] = {}
    for group, file in proofs():
        groups.setdefault(group, []).append(file)
    written, scripts = [], []
    for group, files in groups.items():
        file = together(group, files)
        written.append(asked.folder / f"{group}.json")
        written[-1].write_text(file.json_text(), encoding="utf-8")
        for why, number in Counter(one.reason for one in file.left_out).items():
            print(f"{group}: {number} not written: {why}")
        for why, number in Counter(without_script(file).values()).items():
            print(f"{group}: {number} of {len(file.theorems)} not for Coq: {why}")
        try:
            script = file.coq()
        except InputError as fault:
            print(f"{group}: {fault.message}")
            continue
        scripts.append(asked.folder / f"{group}.v")
        scripts[-1].write_text(script, encoding="utf-8")
    with ThreadPoolExecutor(2) as pool:
        fine = all(pool.map(checked, written))
        fine &= all(pool.map(recomputed, (path for path in written if path.stem == "absences")))
        if which("coqc"):
            return 0 if all(pool.map(compiled, scripts)) and fine else 1
    print("Coq is not installed, so the scripts are not checked")
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
