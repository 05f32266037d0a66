"""What extensors are called, and the order of the names of points."""

from __future__ import annotations

import re
from collections.abc import Callable

__all__ = ["NAME", "NAMES_HINT", "point_key", "primed", "step_name"]

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*'*")
"""Of points, lines and planes."""
NAMES_HINT = "names begin with a letter and go on with letters, digits or _, then primes: left, S1, A'"

_IN_ORDER = str.maketrans("¹²³ᶜᵈ", "\u2071\u2072\u2073ᵈᵉ")  # before ⁴, and behind ᵇ, as points of letters are marked
_STEP_NAMES = {1: "a point", 2: "a line", 3: "a plane"}


def primed(name: str, taken: Callable[[str], bool]) -> str:
    """A name that is not taken: this one, with primes behind it.

    >>> primed("S", {"S", "S'"}.__contains__)
    "S''"
    """
    while taken(name):
        name += "'"
    return name


def step_name(step: int, rank: int = 4) -> str:
    """What an extensor of this step is called: "a scalar", "a line (step 2)", …

    >>> step_name(2), step_name(3, rank=3)
    ('a line (step 2)', 'the whole space (step 3)')
    """
    if step == 0:
        return "a scalar (step 0)"
    if step == rank:
        return f"the whole space (step {step})"
    return f"{_STEP_NAMES.get(step, 'an extensor')} (step {step})"


def point_key(name: str) -> tuple[str, int, int]:
    """Sort key of point names: letters first, then the numeric suffix, then primes.

    >>> sorted(["p10", "p2", "a'", "B", "a"], key=point_key)
    ['B', 'a', "a'", 'p2', 'p10']
    """
    stem = name.rstrip("'")
    letters = stem.rstrip("0123456789")
    digits = stem[len(letters) :]
    return letters.rstrip("_").translate(_IN_ORDER), int(digits) if digits else -1, len(name) - len(stem)
