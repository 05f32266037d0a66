r"""Points of exact random checks, which nobody who makes a claim can foresee, and how sure what holds there is.

That an identity holds at random points says something about the identity only if the points were not known to whoever
wrote it down. There are three kinds of draws:

* Draws that *decide*: True stands on them. Their seed is the keyed hash of what is claimed, with a fresh secret of this
  run as the key, and they are computed modulo `PRIME`, which is drawn afresh in every run too: coefficients that are
  multiples of a prime that is known beforehand vanish modulo it.
* Draws that only *reject*: the searches of factoring and shortening. Nobody can foresee these points either, but arrays
  need primes of at most 31 bits, which are fixed. A residue that is not 0 rejects for certain; what they let pass is
  proved, or tested by draws of the first kind.
* Draws that only *search* or *illustrate*: small whole coordinates of counterexamples, poses that are drawn, directions
  from which a search starts. What they lead to is checked afterwards, exactly, so they may be the same in every run,
  and are, so that pages and pictures are too.

    >>> seed("a claim") == seed("a claim"), seed("a claim") == seed("another")
    (True, False)
    >>> with repeated(7):
    ...     first = seed("a claim")
    >>> with repeated(7):
    ...     first == seed("a claim"), remark()
    (True, ' (points chosen with the seed 7: anyone who knows it can predict them)')
    >>> PRIME.bit_length(), PRIME % 4
    (61, 3)
"""

from __future__ import annotations

import os
import random
import secrets
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache, update_wrapper
from hashlib import blake2b
from math import floor, log10
from typing import Any, Generic, ParamSpec, TypeVar, cast

__all__ = ["DRAWN", "PRIME", "bound", "drawn", "error_below", "remark", "remembered", "repeated", "seed"]

P = ParamSpec("P")
T = TypeVar("T")

DRAWN = 1 << 60
"""Coordinates of deciding draws are the whole numbers below it, all alike likely."""

_PRIMES = 10**16  # fewer than there are of the form 4n + 3 between 2⁶⁰ and 2⁶¹ (1.3 · 10¹⁶)
_LEAST = 1e-300  # what is shown of smaller chances
_WITNESSES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)  # of compositeness of every number below 3.3 · 10²⁴

_secret = [secrets.token_bytes(32)]
_chosen: ContextVar[int | None] = ContextVar("gcrules seed", default=None)


def _renew() -> None:
    """A process that was forked has a secret of its own."""
    _secret[0] = secrets.token_bytes(32)


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_renew)


def _is_prime(n: int) -> bool:
    """For odd numbers of at most 80 bits, certain."""
    if any(n % p == 0 for p in _WITNESSES):
        return n in _WITNESSES
    odd = n - 1
    twos = (odd & -odd).bit_length() - 1
    odd >>= twos
    for witness in _WITNESSES:
        x = pow(witness, odd, n)
        if x in (1, n - 1):
            continue
        for _ in range(twos - 1):
            x = x * x % n
            if x == n - 1:
                break
        else:
            return False
    return True


def _fresh_prime() -> int:
    """A prime p = 4n + 3 between 2⁶⁰ and 2⁶¹, all alike likely."""
    while True:
        n = DRAWN | secrets.randbits(58) << 2 | 3
        if _is_prime(n):
            return n


PRIME = _fresh_prime()
"""The modulus of exact random checks in this run, p = 4n + 3, so that square roots are powers."""


def seed(*claim: object) -> int:
    """A seed of 128 bits for looking at a claim: its texts, numbers and tuples of these, in order.

    The same in one run for the same claim; different and unforeseeable in every other run, unless `repeated`.
    """
    chosen = _chosen.get()
    key = _secret[0] if chosen is None else blake2b(str(chosen).encode(), digest_size=32).digest()
    return int.from_bytes(blake2b(repr(claim).encode(errors="replace"), digest_size=16, key=key).digest(), "big")


def drawn(*claim: object) -> random.Random:
    """The deciding draws for a claim."""
    return random.Random(seed(*claim))


@contextmanager
def repeated(chosen: int | None) -> Iterator[None]:
    """Take the points of checks from a seed of the user's, so that a run can be repeated; None changes nothing.

    The coordinates are then the same whole numbers in every run. The prime modulo which they are computed stays fresh.
    """
    token = _chosen.set(_chosen.get() if chosen is None else chosen)
    try:
        yield
    finally:
        _chosen.reset(token)


def remark() -> str:
    """What a certificate has to add where the user chose the seed; "" otherwise."""
    chosen = _chosen.get()
    return "" if chosen is None else f" (points chosen with the seed {chosen}: anyone who knows it can predict them)"


class _NotKept(Exception):
    """Carries an answer past the memory."""

    def __init__(self, answer: object) -> None:
        super().__init__()
        self.answer = answer


class _Remembered(Generic[P, T]):
    def __init__(self, function: Callable[P, T], most: int, keep: Callable[[Any], bool]) -> None:
        update_wrapper(self, function)

        @lru_cache(maxsize=most)
        def kept(_: int | None, args: Any, options: Any) -> T:
            answer = function(*args, **dict(options))
            if not keep(answer):
                raise _NotKept(answer)
            return answer

        self._kept = kept
        self.cache_clear = kept.cache_clear

    def __call__(self, *args: P.args, **options: P.kwargs) -> T:
        try:
            return self._kept(_chosen.get(), args, tuple(options.items()))
        except _NotKept as passed:
            return cast("T", passed.answer)


def remembered(
    most: int, *, keep: Callable[[Any], bool] = lambda _: True
) -> Callable[[Callable[P, T]], _Remembered[P, T]]:
    """Keep the last answers of a function, as `lru_cache` does, each for the seed with which it was drawn: what was
    found with a seed of the user's is no answer for those who chose none. Arguments are hashable. Answers that are not
    to `keep`, such as those for which time was too short, are computed again the next time.
    """
    return lambda function: _Remembered(function, most, keep)


def bound(degree: int, bits: int, samples: int) -> float:
    """The chance, at most, that a false identity passes, whoever wrote it down.

    `degree` is its degree in all drawn numbers together, `bits` the size of a number which no coefficient (of the
    identity without denominators) exceeds. If the prime divides not all coefficients, the identity is zero at one
    sample with probability at most degree / `DRAWN` (Schwartz 1980, Zippel 1979). At most bits / 60 primes of this
    size divide all of them, and they are some out of 10¹⁶. Samples with small coordinates count for nothing.
    """
    if degree >= DRAWN:
        return 1.0
    return min(1.0, (degree / DRAWN) ** samples + (bits // 60) / _PRIMES)


def error_below(degree: int, bits: int, samples: int) -> str:
    """`bound` in words, up to the next power of ten, with the `remark` on a chosen seed.

    >>> error_below(12, 20, 2), error_below(12, 70, 2)
    ('error below 1e-33', 'error below 1e-15')
    """
    power = floor(log10(max(bound(degree, bits, samples), _LEAST))) + 1
    return f"error below {f'1e{power}' if power < 0 else '1'}{remark()}"
