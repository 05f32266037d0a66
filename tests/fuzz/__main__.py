"""`python -m tests.fuzz`: run a campaign, or one input again."""

from __future__ import annotations

import argparse
import os
import signal
import sys

from .campaign import Found, campaign, load_everything, tried
from .case import from_yaml, to_yaml
from .families import FAMILIES, Family
from .jail import jailed
from .record import commit_now, recorded

_NIGHTLY = 100_000
_SECONDS = 1  # that a command may take where its options do not say so: limits are tried all the same


def main() -> int:
    """Exit code 0: nothing found; 1: something is wrong."""
    parser = argparse.ArgumentParser(prog="python -m tests.fuzz", description=__doc__)
    parser.add_argument("--list", action="store_true", help="list the families")
    parser.add_argument(
        "--family", action="append", metavar="NAME", choices=FAMILIES, help="this family only; repeatable"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the inputs (default 0)")
    parser.add_argument("--start", type=int, default=0, metavar="N", help="the first input")
    parser.add_argument("--count", type=int, metavar="N", help="inputs of each family")
    parser.add_argument("--seconds", type=float, metavar="S", help="for all families together, by their shares")
    parser.add_argument("--nightly", action="store_true", help=f"{_NIGHTLY:,} inputs of each family")
    parser.add_argument("--workers", type=int, default=1, metavar="N")
    parser.add_argument("--replay", metavar="FILE|FAMILY:INDEX", help="run one input again and show all of it")
    parser.add_argument(
        "--known", action="append", default=[], metavar="CAUSE", help="do not make inputs with this cause small"
    )
    parser.add_argument("--findings", metavar="FILE", help="append what is found to this file")
    parser.add_argument("--record", action="store_true", help="write what was tried into tests/fuzz/RECORD.md")
    asked = parser.parse_args()
    if asked.list:
        for family in FAMILIES.values():
            print(f"{family.name:<12} {family.words}")
        return 0
    os.environ.setdefault("GCRULES_SECONDS", str(_SECONDS))
    signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background too: it ends a family early
    load_everything()
    if asked.replay:
        return _replay(asked.replay, asked.seed)
    families = [FAMILIES[name] for name in asked.family or FAMILIES]
    wrong, commit = 0, commit_now()
    for family, seconds in _shared(families, asked.seconds):
        result = campaign(
            family,
            seed=asked.seed,
            start=asked.start,
            count=_NIGHTLY if asked.nightly else asked.count or (None if seconds else 1_000),
            seconds=seconds,
            workers=asked.workers,
            known=frozenset(asked.known),
            tell=lambda found: _tell(found, asked.findings),
        )
        print(result.text(), flush=True)
        wrong += len(result.found)
        if asked.record:
            recorded(result, commit, asked.start)
    return 1 if wrong else 0


def _shared(families: list[Family], seconds: float | None) -> list[tuple[Family, float | None]]:
    total = sum(f.share for f in families)
    return [(f, None if seconds is None else seconds * f.share / total) for f in families]


def _tell(found: Found, path: str | None) -> None:
    print(f"FOUND {found.family} {found.index}: {found.name}", flush=True)
    if path:
        with open(path, "a", encoding="utf-8", errors="backslashreplace") as file:
            file.write(found.text() + "\n")


def _replay(what: str, seed: int) -> int:
    name, _, index = what.partition(":")
    if name in FAMILIES and index.isdigit():
        case = FAMILIES[name].case(seed, int(index))
    else:
        with open(what, encoding="utf-8") as file:
            case, _ = from_yaml(file.read())
    with jailed() as jail:
        faults, outcome = tried(FAMILIES[case.family], case, jail)
    print(to_yaml(case))
    print(f"exit code {outcome.code}, {outcome.seconds:.2f} s, left {outcome.left}, noise {outcome.noise}")
    for title, text in (("stdout", outcome.stdout), ("stderr", outcome.stderr), ("trace", outcome.trace)):
        if text:
            print(f"--- {title}\n{text[:4000].encode('utf-8', 'backslashreplace').decode()}")
    for cause, details in faults:
        print(f"WRONG: {cause}\n{details[:2000].encode('utf-8', 'backslashreplace').decode()}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
