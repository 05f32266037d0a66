"""How normal forms and factoring grow with the points, beside Macaulay2 and sympy: measures, and draws docs/speed.md.

    python benchmarks/scale.py --measure              measure, write results/scale.json, draw
    python benchmarks/scale.py --measure factoring    only that part again; the other stays (or: forms)
    python benchmarks/scale.py                        from results/scale.json: the pictures and tables of the page

Every measurement is made in a process of its own, by the processor time that it takes there after its start, so that
neither loading the interpreter nor other work on the machine counts.
"""

from __future__ import annotations

import argparse
import json
import platform
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from datetime import date
from importlib import metadata
from pathlib import Path
from typing import Any

import factoring
from curve import curve, factoring_curve
from measurement import short
from products import Monomial, products

HERE = Path(__file__).resolve().parent
RESULTS = HERE / "results" / "scale.json"
CURVE = HERE.parent / "docs" / "assets" / "speed.svg"
FACTORING_CURVE = CURVE.with_name("speed-factoring.svg")
SCRIPTS = HERE.parent / "build"
PAGE = HERE.parent / "docs" / "speed.md"
TABLE = re.compile(r"(<!-- (forms|factoring) measured:.*?-->\n).*?(<!-- end -->)", re.DOTALL)

FORMS = 20
"""Products of brackets that are brought into normal form, one after the other."""

SIZES = {3: (6, 7, 8, 9, 10, 11, 12, 13, 14, 15), 4: (8, 9, 10, 11, 12, 13, 14, 15, 16)}
"""Rank: numbers of points."""

LIMIT = 300
"""Seconds of processor time after which Macaulay2 is stopped; it is not tried with more points then."""

ROUNDS = 3
"""How often each is measured, if it takes less than ten seconds; the best time counts."""

Form = dict[Monomial, int]


# --- gcrules -------------------------------------------------------------------------------------------------------

WORKER = """
import json, sys, time
from gcrules.algebra.straightening.straighten import straighten_terms
products = [tuple(map(tuple, m)) for m in json.load(sys.stdin)]
start = time.process_time()
forms = [straighten_terms({m: 1}) for m in products]
print(json.dumps([time.process_time() - start, [list(f.items()) for f in forms]]))
"""


def by_gcrules(monomials: Sequence[Monomial]) -> tuple[float, list[Form]]:
    """Seconds for the normal forms in a fresh process, where nothing is known yet, and the forms."""
    done = subprocess.run(
        [sys.executable, "-c", WORKER], input=json.dumps(monomials), capture_output=True, text=True, check=True
    )
    seconds, forms = json.loads(done.stdout)
    return seconds, [{tuple(map(tuple, m)): c for m, c in form} for form in forms]


# --- Macaulay2 -----------------------------------------------------------------------------------------------------

# Its variables are p_(0,1,2,3), … in the order in which its basis has the standard tableaux as normal forms.
SCRIPT = """
start = cpuTime();
I = Grassmannian({rank} - 1, {points} - 1, CoefficientRing => QQ);
G = gb I;
ready = cpuTime();
R = ring I;
p = hashTable apply(gens R, x -> (toList (baseName x)#1 => x));
L = apply({products}, m -> product apply(m, row -> p#row));
before = cpuTime();
N = apply(L, f -> f % G);
after = cpuTime();
print toString {{ready - start, after - before}};
rows = apply(gens R, x -> toList (baseName x)#1);
factors = powers -> apply(select(#powers, i -> powers#i > 0), i -> {{rows#i, powers#i}});
scan(N, f -> print toString apply(listForm f, t -> {{t#1, factors t#0}}));
"""


def macaulay2() -> str | None:
    """The version of Macaulay2; None if it is not installed."""
    if shutil.which("M2") is None:
        return None
    done = subprocess.run(["M2", "--version"], capture_output=True, text=True, check=False)
    return done.stdout.strip() or None


def by_macaulay2(
    rank: int, monomials: Sequence[Monomial], limit: int = LIMIT
) -> tuple[float, float, list[Form]] | None:
    """Seconds for the Gröbner basis of the Plücker ideal, then for the normal forms, and the forms.

    None if the limit was reached.
    """
    points = 1 + max(i for m in monomials for row in m for i in row)
    script = SCRIPT.format(rank=rank, points=points, products=_braces(monomials))
    SCRIPTS.mkdir(exist_ok=True)
    path = SCRIPTS / f"scale-{rank}-{points}.m2"
    path.write_text(script, encoding="utf-8")
    done = subprocess.run(
        ["M2", "--script", path],
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)),
    )
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return None
    done.check_returncode()
    first, *rest = done.stdout.splitlines()
    basis, forms = map(float, re.findall(r"[\d.e-]+", first))
    return basis, forms, [_read(line) for line in rest]


def _braces(value: Any) -> str:
    return f"{{{','.join(map(_braces, value))}}}" if isinstance(value, Sequence) else str(value)


def _read(line: str) -> Form:
    found: Form = {}
    for coefficient, factors in json.loads(line.replace("{", "[").replace("}", "]")):
        found[tuple(sorted(tuple(row) for row, power in factors for _ in range(power)))] = coefficient
    return found


# --- measuring -----------------------------------------------------------------------------------------------------


def measured(rank: int, points: int, peer: bool, limit: int = LIMIT) -> dict[str, Any]:
    """One line of the results. Raises AssertionError if the normal forms differ."""
    monomials = products(rank, points, FORMS)
    ours, forms = min((by_gcrules(monomials) for _ in range(ROUNDS)), key=lambda found: found[0])
    line: dict[str, Any] = {
        "rank": rank,
        "points": points,
        "brackets": len(monomials[0]),
        "terms": max(map(len, forms)),
        "gcrules": round(ours, 5),
    }
    for _ in range(ROUNDS if peer else 0):
        start = time.monotonic()
        theirs = by_macaulay2(rank, monomials, limit)
        if theirs is None:
            line |= {"macaulay2": None}
            break
        basis, reduction, other = theirs
        assert other == forms, f"Macaulay2 has other normal forms for {points} points of rank {rank}"
        before = line.setdefault("macaulay2", {"basis": basis, "forms": reduction})
        line["macaulay2"] = {
            "basis": round(min(basis, before["basis"]), 5),
            "forms": round(min(reduction, before["forms"]), 5),
        }
        if time.monotonic() - start > 10:
            break
    return line


def measure() -> dict[str, Any]:
    """All measurements, with the machine and the date."""
    version = macaulay2()
    found: list[dict[str, Any]] = []
    for rank, sizes in SIZES.items():
        peer = version is not None
        for points in sizes:
            found.append(measured(rank, points, peer))
            peer = peer and found[-1]["macaulay2"] is not None
            print(json.dumps(found[-1]), flush=True)
    stamped = stamp()
    stamped["versions"] |= {"Macaulay2": version}
    return stamped | {"forms": FORMS, "limit": LIMIT, "runs": found}


def stamp() -> dict[str, Any]:
    """The date, the machine and the versions that every part of the results has."""
    versions = {"Python": platform.python_version(), "NumPy": metadata.version("numpy")}
    return {
        "date": date.today().isoformat(),
        "machine": f"{processor()}, one core, {platform.system()}",
        "versions": versions,
    }


def processor() -> str:
    """The model of the processor, as far as the system tells."""
    info = Path("/proc/cpuinfo")
    model = re.search(r"^model name\s*:\s*(.+)$", info.read_text(), re.MULTILINE) if info.exists() else None
    return model[1] if model else platform.machine()


# --- showing -------------------------------------------------------------------------------------------------------


def page(text: str, results: dict[str, Any]) -> str:
    """The page with the numbers of the results put into it."""
    tables = {"forms": table, "factoring": factoring_table}
    return TABLE.sub(lambda found: f"{found[1]}\n{tables[found[2]](results)}\n{found[3]}", text)


def table(results: dict[str, Any]) -> str:
    """The results in Markdown, with machine, versions and date."""
    lines = [
        "| rank | points | brackets | terms, at most | gcrules | Macaulay2, basis included | basis at hand |",
        "|---:|---:|---:|---:|---:|---:|---:|",
    ]
    for run in results["runs"]:
        cells = [str(run["rank"]), str(run["points"]), str(run["brackets"]), f"{run['terms']:,}", short(run["gcrules"])]
        peer = run.get("macaulay2")
        stopped = f"over {results['limit']} s" if "macaulay2" in run else "not tried"
        cells += [short(peer["basis"] + peer["forms"]), short(peer["forms"])] if peer else [stopped, ""]
        lines.append(f"| {' | '.join(cells)} |")
    versions = ", ".join(f"{name} {version}" for name, version in results["versions"].items() if version)
    return "\n".join([*lines, "", f"Measured on {results['date']}: {results['machine']}; {versions}.", ""])


def factoring_table(results: dict[str, Any]) -> str:
    """The part on factoring, with the versions and the date; the machine if it is not that of the normal forms."""
    part = results["factoring"]
    where = "" if part["machine"] == results["machine"] else f": {part['machine']}"
    versions = ", ".join(f"{name} {version}" for name, version in part["versions"].items() if version)
    return "\n".join(
        [factoring.table(part), "", f"Measured on {part['date']}{where or ', the same machine'}; {versions}.", ""]
    )


def main(arguments: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description="Draw the curve of docs/speed.md, or measure it anew.")
    parser.add_argument(
        "--measure",
        nargs="?",
        const="all",
        choices=("all", "forms", "factoring"),
        help="measure first, all or a part; with Macaulay2 this takes a quarter of an hour",
    )
    part = parser.parse_args(arguments).measure
    if part:
        RESULTS.parent.mkdir(exist_ok=True)
        found = json.loads(RESULTS.read_text(encoding="utf-8")) if RESULTS.exists() else {}
        if part in ("all", "forms"):
            found |= measure()
        if part in ("all", "factoring"):
            found["factoring"] = stamp() | factoring.measure()
            found["factoring"]["versions"] |= factoring.peers()
        RESULTS.write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    results = json.loads(RESULTS.read_text(encoding="utf-8"))
    CURVE.write_text(curve(results).svg(), encoding="utf-8")
    FACTORING_CURVE.write_text(factoring_curve(results["factoring"]).svg(), encoding="utf-8")
    PAGE.write_text(page(PAGE.read_text(encoding="utf-8"), results), encoding="utf-8")


if __name__ == "__main__":
    main()
