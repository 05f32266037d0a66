"""What a family of inputs is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from random import Random

from ..case import Case
from ..jail import Jail
from ..running import Outcome, run_command

__all__ = ["Family"]


@dataclass(frozen=True)
class Family:
    """`make` draws an input, `run` runs it; `share` is its part of the time of a short campaign, `few` inputs are tried
    by every run of the tests.
    """

    name: str
    words: str
    make: Callable[[Random], Case]
    run: Callable[[Case, Jail], Outcome] = run_command
    share: float = 1.0
    few: int = 40

    def case(self, seed: int, index: int) -> Case:
        """The input of this number: the same wherever and whenever it is drawn."""
        return self.make(Random(f"{self.name}/{seed}/{index}"))
