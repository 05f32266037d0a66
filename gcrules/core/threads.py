"""How many threads linear algebra has: one, for the matrices here are small, and threads cost more than they give.

On a platform on eight cables two threads took 12 seconds of processor time where one took 3.4.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, MutableMapping
from contextlib import contextmanager

__all__ = ["one_thread", "with_one_thread"]

_NAMES = ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS")


def with_one_thread(environment: MutableMapping[str, str]) -> list[str]:
    """Say so in an environment, in which NumPy is not loaded yet, unless the user said otherwise: the names added."""
    added = [name for name in _NAMES if name not in environment]
    environment.update(dict.fromkeys(added, "1"))
    return added


@contextmanager
def one_thread() -> Iterator[None]:
    """The same for the programs that are started meanwhile."""
    added = with_one_thread(os.environ)
    try:
        yield
    finally:
        for name in added:
            del os.environ[name]
