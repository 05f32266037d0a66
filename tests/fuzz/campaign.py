"""Many inputs: drawn, run and judged by workers; what is wrong is told once for each cause, with a small input.

Each input runs in the process of a worker, which is ended from outside only where it does not end by itself.
"""

from __future__ import annotations

import importlib
import multiprocessing
import os
import pkgutil
import sys
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from time import monotonic
from typing import Any

from .case import Case, to_yaml
from .families import FAMILIES, Family
from .jail import Jail, jailed
from .judging import Fault, judged
from .running import GRACE, limit_memory
from .shrinking import shrunk

__all__ = ["Found", "Result", "campaign", "load_everything", "tried"]

_WALL = 120.0  # seconds without a new input, times the load of the machine, after which a worker is ended
_FRESH = 5_000  # inputs after which a worker is replaced, so that what it remembers does not grow


@dataclass(frozen=True)
class Found:
    """A cause of faults: where it was met first, and the input made small."""

    family: str
    index: int
    name: str
    details: str
    case: Case
    code: int | None

    def text(self) -> str:
        head = f"## {self.name}\n{self.family} {self.index}, exit code {self.code}\n"
        return f"{head}{self.details[-1500:]}\n---\n{to_yaml(self.case)}"


@dataclass
class Result:
    """What came of the inputs of one family."""

    family: str
    seed: int
    inputs: int = 0
    found: dict[str, Found] = field(default_factory=dict)
    times: Counter[str] = field(default_factory=Counter)
    codes: Counter[Any] = field(default_factory=Counter)
    slowest: tuple[float, int] = (0.0, -1)
    seconds: float = 0.0

    def text(self) -> str:
        codes = ", ".join(f"{c}: {n}" for c, n in sorted(self.codes.items(), key=lambda p: str(p[0])))
        lines = [
            f"{self.family:<12} {self.inputs:>8,} inputs in {self.seconds:,.0f} s, seed {self.seed}; "
            f"exit codes {codes}; slowest {self.slowest[0]:.1f} s (input {self.slowest[1]}); "
            f"{len(self.found)} causes of faults"
        ]
        lines += [f"    {self.times[name]:>6} x {f.name}   (first: input {f.index})" for name, f in self.found.items()]
        return "\n".join(lines)


def load_everything() -> None:
    """Import all of gcrules, and read what is read once: no input pays for it, and none is interrupted amid it."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    sys.dont_write_bytecode = True
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        import gcrules

        for module in pkgutil.walk_packages(gcrules.__path__, "gcrules."):
            if not module.name.endswith("__main__") and "_plugins" not in module.name:
                importlib.import_module(module.name)
        for name in (
            "numba",
            "matplotlib.backends.backend_agg",
            "matplotlib.backends.backend_pdf",
            "sympy",
            "skimage.measure",
        ):
            try:
                importlib.import_module(name)
            except ImportError:
                continue
        gcrules.analyze("ab af cb cd ed ef", search=0)  # reads the catalog, rules and plugins, and makes the parser
        gcrules.load_rules()
        gcrules.load("3-rps")


def tried(family: Family, case: Case, jail: Jail) -> tuple[list[Fault], Any]:
    """What is wrong with an input, and the outcome itself."""
    found = family.run(case, jail)
    return judged(case, found), found


def campaign(
    family: Family,
    *,
    seed: int,
    count: int | None = None,
    seconds: float | None = None,
    start: int = 0,
    workers: int = 1,
    known: frozenset[str] = frozenset(),
    tell: Callable[[Found], None] = lambda found: None,
) -> Result:
    """Run inputs `start`, `start` + 1, … of a family: `count` of them, or for so many `seconds`."""
    result = Result(family.name, seed)
    began = monotonic()
    until = None if seconds is None else began + seconds
    last = sys.maxsize if count is None else start + count
    fork = multiprocessing.get_context("fork")
    lanes: dict[Connection, _Lane] = {}

    def begin(first: int, stride: int) -> None:
        ours, theirs = fork.Pipe(duplex=False)
        at = fork.Value("q", first, lock=False)
        end = min(last, first + _FRESH * stride)
        process = fork.Process(
            target=_work, args=(family.name, seed, first, end, stride, until, at, theirs, known), daemon=True
        )
        process.start()
        theirs.close()
        lanes[ours] = _Lane(process, at, stride, end, first, monotonic())

    for worker in range(workers):
        if start + worker < last:
            begin(start + worker, workers)
    while lanes:
        try:
            ready = wait(list(lanes), timeout=2.0)
        except KeyboardInterrupt:  # what was tried so far counts
            break
        for pipe in ready:
            assert isinstance(pipe, Connection)
            lane = lanes[pipe]
            try:
                message = pipe.recv()
            except EOFError:
                message = None
            if message is not None:
                _take(result, message, tell)
            else:
                lane.process.join()
                del lanes[pipe]
                if lane.process.exitcode > 0:
                    raise RuntimeError("the campaign itself is at fault; its traceback stands above")
                if lane.process.exitcode:
                    _died(result, family, seed, lane, f"the process ended by signal {-lane.process.exitcode}", tell)
                    begin(lane.at.value + lane.stride, lane.stride)
                elif lane.end < last and (until is None or monotonic() < until):
                    begin(lane.end, lane.stride)
        for pipe, lane in list(lanes.items()):
            if lane.at.value != lane.seen:
                lane.seen, lane.since = lane.at.value, monotonic()
            elif monotonic() - lane.since > _WALL + 3 * (family.case(seed, lane.seen).seconds + GRACE):
                lane.process.kill()
                lane.process.join()
                del lanes[pipe]
                _died(result, family, seed, lane, "no end, not even by a signal", tell)
                begin(lane.seen + lane.stride, lane.stride)
    for lane in lanes.values():
        lane.process.kill()
    result.seconds = monotonic() - began
    return result


@dataclass
class _Lane:
    process: Any
    at: Any
    stride: int
    end: int
    seen: int
    since: float


def _died(result: Result, family: Family, seed: int, lane: _Lane, how: str, tell: Callable[[Found], None]) -> None:
    index = lane.at.value
    result.inputs += 1
    result.times[how] += 1
    if how not in result.found:
        result.found[how] = Found(family.name, index, how, "", family.case(seed, index), None)
        tell(result.found[how])


def _take(result: Result, message: Any, tell: Callable[[Found], None]) -> None:
    kind, value = message
    if kind == "found":
        result.times[value.name] += 1
        if value.name not in result.found:
            result.found[value.name] = value
            tell(value)
    elif kind == "again":
        result.times[value] += 1
    else:
        inputs, codes, slowest = value
        result.inputs += inputs
        result.codes.update(codes)
        result.slowest = max(result.slowest, slowest)


def _work(
    name: str,
    seed: int,
    first: int,
    end: int,
    stride: int,
    until: float | None,
    at: Any,
    pipe: Connection,
    known: frozenset[str],
) -> None:
    """Inputs `first`, `first` + `stride`, … below `end`, in this process."""
    limit_memory()
    family = FAMILIES[name]
    seen: set[str] = set(known)
    codes: Counter[Any] = Counter()
    inputs, slowest = 0, (0.0, -1)
    with jailed() as jail:
        for index in _indices(first, end, stride, until):
            at.value = index
            case = family.case(seed, index)
            faults, outcome = tried(family, case, jail)
            inputs += 1
            codes[outcome.code] += 1
            slowest = max(slowest, (outcome.seconds, index))
            for cause, details in faults:
                if cause in seen:
                    pipe.send(("again", cause))
                    continue
                seen.add(cause)
                small = case if "hang" in cause else shrunk(case, _shows(family, cause, jail))
                pipe.send(("found", Found(name, index, cause, details, small, outcome.code)))
            if inputs % 100 == 0:
                pipe.send(("count", (100, codes, slowest)))
                codes = Counter()
        pipe.send(("count", (inputs % 100, codes, slowest)))
    pipe.close()


def _indices(first: int, end: int, stride: int, until: float | None) -> Iterator[int]:
    for index in range(first, end, stride):
        if until is not None and monotonic() > until:
            return
        yield index


def _shows(family: Family, cause: str, jail: Jail) -> Callable[[Case], bool]:
    def shows(case: Case) -> bool:
        return any(name == cause for name, _ in tried(family, case, jail)[0])

    return shows
