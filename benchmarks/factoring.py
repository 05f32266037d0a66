"""How factoring grows with the points, beside sympy in coordinates: the second part of results/scale.json."""

from __future__ import annotations

import importlib.util
import json
import signal
import subprocess
import sys
from collections.abc import Sequence
from importlib import metadata
from string import ascii_lowercase
from typing import Any

from measurement import short
from products import PLANTED, products

__all__ = ["bracketed", "by_gcrules", "by_sympy", "measure", "peers", "table"]

NUMBER = 5
"""Products of brackets that are factored, one after the other."""

SIZES = {3: tuple(range(6, 17)), 4: tuple(range(6, 17))}
"""Rank: numbers of points of the products."""

LIMIT = 20
"""Seconds of processor time in `factor` after which sympy is stopped; more points of that rank are not tried then."""

ROUNDS = 3
"""How often each is measured, if it takes less than a second; the best time counts."""

WORKER = """
import json, sys, time
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.factoring.factorize import factor
rank, expressions = json.load(sys.stdin)
forms = [straighten(parse(e, rank=rank)) for e in expressions]
start = time.process_time()
found = [factor(form) for form in forms]
print(json.dumps([time.process_time() - start, max(len(f.terms) for f in forms), [f.exists for f in found]]))
"""

# Points are (x, y, …, 1), as one would set them up; multiplying out is not counted.
PEER = """
import json, math, resource, sys, time
import sympy
from gcrules.algebra.straightening.straighten import straighten
from gcrules.algebra.language.syntax import parse
rank, expressions, allowed = json.load(sys.stdin)

def bracket(points):
    return sympy.Matrix([[*sympy.symbols(f"{p}1:{rank}"), 1] for p in points]).det(method="berkowitz")

def coordinates(expression):
    form = straighten(parse(expression, rank=rank))
    return sympy.expand(sum(
        int(c) * sympy.prod([bracket([form.points[i] for i in row]) for row in m]) for m, c in form.terms.items()))

seconds = 0
terms = 0
found = []
for expression in expressions:
    value = coordinates(expression)
    start = time.process_time()
    limit = math.ceil(start + max(0, allowed - seconds))
    resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))
    product = sympy.factor(value)
    seconds += time.process_time() - start
    resource.setrlimit(resource.RLIMIT_CPU, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    terms = max(terms, len(value.args))
    found.append(sum(power for base, power in product.as_powers_dict().items() if base.free_symbols))
print(json.dumps([seconds, terms, [int(n) for n in found]]))
"""


def by_gcrules(rank: int, expressions: Sequence[str]) -> tuple[float, int, list[bool]]:
    """Seconds to factor the expressions from their normal forms, the most terms of one, and which were factored."""
    found: tuple[float, int, list[bool]] = _run(WORKER, [rank, expressions])
    return found


def by_sympy(rank: int, expressions: Sequence[str], limit: int = LIMIT) -> tuple[float, int, list[int]] | None:
    """Seconds to factor the multiplied out polynomials in coordinates, the most terms, and how many factors each has.

    None if the limit was reached.
    """
    found: tuple[float, int, list[int]] | None = _run(PEER, [rank, expressions, limit])
    return found


def _run(script: str, given: Sequence[Any]) -> Any:
    done = subprocess.run(
        [sys.executable, "-c", script], input=json.dumps(given), capture_output=True, text=True, check=False
    )
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return None
    done.check_returncode()
    return json.loads(done.stdout)


def bracketed(rank: int, points: int, number: int = NUMBER) -> list[str]:
    """The random products as text."""
    rows = products(rank, points, number)
    return ["".join(f"[{''.join(ascii_lowercase[i] for i in row)}]" for row in m) for m in rows]


def peers() -> dict[str, str]:
    """SymPy's version, if it is installed."""
    return {"SymPy": metadata.version("sympy")} if importlib.util.find_spec("sympy") else {}


def measure() -> dict[str, Any]:
    """All measurements of products and of planted expressions. Raises AssertionError for one that was not factored."""
    peer = bool(peers())
    works = [("products", rank, n, bracketed(rank, n)) for rank, sizes in SIZES.items() for n in sizes]
    works += [("expression", rank, len(set(e) & set(ascii_lowercase)), [e]) for rank, e in PLANTED]
    runs: list[dict[str, Any]] = []
    stopped: set[tuple[str, int]] = set()
    for kind, rank, points, expressions in works:
        seconds, terms, found = min(by_gcrules(rank, expressions) for _ in range(ROUNDS))
        assert all(found), f"not factored: {expressions}"
        run = {"kind": kind, "rank": rank, "points": points, "terms": terms, "gcrules": round(seconds, 5)}
        if kind == "expression":
            run["expression"] = expressions[0]
        if peer and (kind, rank) not in stopped:
            run |= _peer(rank, expressions, kind)
            if run["sympy"] is None:
                stopped.add((kind, rank))
        print(json.dumps(run), flush=True)
        runs.append(run)
    return {"number": NUMBER, "limit": LIMIT, "runs": runs}


def _peer(rank: int, expressions: Sequence[str], kind: str) -> dict[str, Any]:
    best: dict[str, Any] = {}
    for _ in range(ROUNDS):
        theirs = by_sympy(rank, expressions)
        if theirs is None:
            return {"sympy": None}
        seconds, terms, factors = theirs
        expected = [e.count("[") if kind == "products" else 1 for e in expressions]
        assert factors == expected, f"sympy finds {factors} factors of {expressions}"
        best = {"sympy": round(min(seconds, best.get("sympy", seconds)), 5), "monomials": terms}
        if seconds > 1:
            break
    return best


def table(results: dict[str, Any]) -> str:
    """The results in Markdown."""
    lines = [
        "| rank | points | factored | terms, at most | gcrules | monomials, at most | sympy |",
        "|---:|---:|:---|---:|---:|---:|---:|",
    ]
    for run in results["runs"]:
        work = f"`{run['expression']}`" if "expression" in run else f"{results['number']} products"
        cells = [str(run["rank"]), str(run["points"]), work, f"{run['terms']:,}", short(run["gcrules"])]
        if run.get("sympy"):
            cells += [f"{run['monomials']:,}", short(run["sympy"])]
        else:
            cells += ["", f"stopped after {results['limit']} s" if "sympy" in run else "not tried"]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)
