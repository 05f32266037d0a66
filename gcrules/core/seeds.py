r"""Seeds of exact random checks, which nobody who makes a claim can foresee.

That an identity holds at random points says something about the identity only if the points were not known to whoever
wrote it down. A seed is therefore the keyed hash of what is claimed, with a fresh secret of this run as the key. The
chance that a false claim passes is then the one of the Schwartz–Zippel lemma, whoever made the claim.

    >>> seed("a claim") == seed("a claim"), seed("a claim") == seed("another")
    (True, False)
    >>> with repeated(7):
    ...     first = seed("a claim")
    >>> with repeated(7):
    ...     first == seed("a claim"), remark()
    (True, ' (points chosen with the seed 7: who knows it can foresee them)')
"""

from __future__ import annotations

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from hashlib import blake2b

__all__ = ["remark", "repeated", "seed"]

_SECRET = secrets.token_bytes(32)
_chosen: ContextVar[int | None] = ContextVar("gcrules seed", default=None)


def seed(*claim: object) -> int:
    """A seed of 128 bits for looking at a claim: its texts, numbers and tuples of these, in order.

    The same in one run for the same claim; different and unforeseeable in every other run, unless `repeated`.
    """
    chosen = _chosen.get()
    key = _SECRET if chosen is None else blake2b(str(chosen).encode(), digest_size=32).digest()
    return int.from_bytes(blake2b(repr(claim).encode(), digest_size=16, key=key).digest(), "big")


@contextmanager
def repeated(chosen: int | None) -> Iterator[None]:
    """Take the points of checks from a seed of the user's, so that a run can be repeated; None changes nothing."""
    token = _chosen.set(_chosen.get() if chosen is None else chosen)
    try:
        yield
    finally:
        _chosen.reset(token)


def remark() -> str:
    """What a certificate has to add where the user chose the seed; "" otherwise."""
    chosen = _chosen.get()
    return "" if chosen is None else f" (points chosen with the seed {chosen}: who knows it can foresee them)"
