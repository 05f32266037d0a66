"""What any input must get: an exit code that means something, a clear error, nothing left over, one JSON document."""

from __future__ import annotations

import json
import re
from typing import Any, NoReturn

from .case import Case
from .running import Outcome

__all__ = ["Fault", "judged"]

CODES = (0, 1, 2, 3)
OUTPUTS = ("-o", "--output", "--out", "--figure", "--csv", "--plot", "--session")
_INTERPRETER = re.compile(
    r"object at 0x|NoneType|<class '|\[Errno|\bnumpy\.|\bnp\.float|takes \d+ positional|unhashable|"
    r"has no attribute|not subscriptable|unsupported operand|<function |codec can't"
)
_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f]")
_TAKES_VALUE = re.compile(r"--?[a-z][a-z-]*")

Fault = tuple[str, str]
"""What is wrong, in few words that are the same for all inputs with this cause; and the details."""


def judged(case: Case, found: Outcome) -> list[Fault]:
    """Everything that is wrong with an outcome."""
    return [
        *_ended(found),
        *_files(case, found),
        *((_kind(n), n) for n in found.noise if not _asked_for(case, n)),
        *_streams(case, found),
        *((w, w) for w in found.wrong),
    ]


def _asked_for(case: Case, noise: str) -> bool:
    """Whether the folder that was left is one that the input names: `save /x`, `catalog check --write`."""
    if not noise.endswith(" outside the folder"):
        return False
    if "--write" in case.argv and "/gcrules/.gcrules-" in noise:  # the digests of the shipped catalog, beside it
        return True
    folders = [part for part in noise.removesuffix(" outside the folder").split("/")[1:-1] if part]
    words = "\n".join((*case.argv, case.stdin))
    return "/" in words and all(part in words or part in ("tmp",) for part in folders)


def _kind(noise: str) -> str:
    return re.sub(r"\d+|/\S*", "…", noise)[:120]


def _ended(found: Outcome) -> list[Fault]:
    if found.frame:
        return [(found.frame, found.trace)]
    if found.code is not None and found.code not in CODES:
        return [(f"exit code {found.code}", found.stderr)]
    return []


def _files(case: Case, found: Outcome) -> list[Fault]:
    left = [n for n in found.left if not (_may_write(case, n) and (found.code in (0, 1) or case.mixed))]
    return [(f"files left with exit code {found.code}", ", ".join(left))] if left else []


def _may_write(case: Case, name: str) -> bool:
    """Whether the user named this file for the answer; what was read may be written only where an option says so."""
    bare = name.rstrip("/")
    if case.mixed and bare in case.stdin and name not in case.files:  # `save FILE` among other words
        return True
    for before, word in zip(("", *case.argv), case.argv, strict=False):
        option, _, value = word.partition("=")
        if (option in OUTPUTS and value == bare) or (before in OUTPUTS and word == bare) or word == f"-o{bare}":
            return True
        if name not in case.files and (word == bare or bare.startswith(f"{word}/") or (case.mixed and bare in word)):
            return True
    return False


def _streams(case: Case, found: Outcome) -> list[Fault]:
    out, err, code = found.stdout, found.stderr, found.code
    if found.frame or code not in CODES or not case.argv:
        return []
    faults: list[Fault] = []
    command = _command(case)
    if "Traceback" in err or "Exception ignored" in err:
        faults.append((f"traceback on standard error of {command}", err))
    if found_words := _INTERPRETER.search(err):
        faults.append((f"words of the interpreter in an error of {command}: {found_words[0]}", err))
    if _CONTROL.search(err):
        faults.append((f"control characters in an error of {command}", repr(err)))
    says = re.search(r"^(error|Error): ", err, re.M)
    if code == 2 and not says:
        faults.append((f"exit code 2 without an error: {command}", err or "nothing on standard error"))
    if code == 3 and not says and not out.strip() and not _redirected(case):
        faults.append((f"exit code 3 without a word: {command}", err))
    if code == 0 and says:
        faults.append((f"an error with exit code 0: {command}", err))
    if code in (2, 3) and says and out.strip() and not case.mixed:
        faults.append((f"an answer and an error: {command}", out[:300]))
    if _asks_json(case) and code in (0, 1, 3) and not (code == 3 and not out.strip()):
        try:
            json.loads(out, parse_constant=_no_number)
        except ValueError as wrong:
            faults.append((f"not one JSON document: {command}", f"{wrong}\n{out[:300]}"))
    return faults


def _no_number(word: str) -> NoReturn:
    raise ValueError(f"{word} is no JSON")


def _command(case: Case) -> str:
    words = [w for w in case.argv[:2] if re.fullmatch(r"[a-z]+", w)]
    groups = ("robot", "catalog", "rules")
    return " ".join(words[: 2 if words and words[0] in groups else 1]) or case.family


def _redirected(case: Case) -> bool:
    return any(w in ("-o", "--output") or w.startswith(("--output=", "-o")) for w in case.argv)


def _asks_json(case: Case) -> bool:
    """Whether --json is an option here for sure, and the answer goes to standard output."""
    argv: tuple[Any, ...] = case.argv
    if "--json" not in argv or "--" in argv or "-h" in argv or "--help" in argv or "--version" in argv:
        return False
    at = argv.index("--json")
    before = argv[at - 1] if at else ""
    flag = before in ("--full", "--brief", "--recheck", "--cofactor", "--steps", "--ascii", "--unicode")
    flag |= before == "--search" and _command(case) == "robot pose"  # elsewhere it takes seconds
    if _TAKES_VALUE.fullmatch(before) and not flag:
        return False
    return not _redirected(case)
