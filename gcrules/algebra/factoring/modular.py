"""Residues modulo primes below 2³¹ in arrays of 64-bit integers: products, inverses and determinants, exact.

The first prime, 2³¹ − 1, is one less than a power of two, so that it needs no division.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.algebra.evaluate import join_table

__all__ = ["MODULUS", "PRIMES", "Ints", "determinants", "inverse", "minor", "reduced"]

Ints = NDArray[np.int64]

MODULUS = 2**31 - 1
PRIMES = (MODULUS, 2147483629, 2147483587, 2147483579, 2147483563, 2147483549)


def reduced(x: Ints, p: int = MODULUS) -> Ints:
    """Residues 0 … p − 1 of numbers from 0 up to the largest of 64 bits."""
    if p != MODULUS:
        return x % p
    x = (x & MODULUS) + (x >> 31)
    x = (x & MODULUS) + (x >> 31)
    return np.where(x >= MODULUS, x - MODULUS, x)


def minor(a: Ints, d: Ints, b: Ints, c: Ints, p: int = MODULUS) -> Ints:
    """a·d − b·c of residues."""
    return reduced(reduced(a * d, p) + (p - reduced(b * c, p)), p)


def inverse(x: Ints, p: int = MODULUS) -> Ints:
    """Inverses of residues, and 0 for 0; one power for all: products of neighbours are inverted first."""
    flat = x.ravel()
    found = _inverse(np.where(flat == 0, 1, flat), p)
    found[flat == 0] = 0
    return found.reshape(x.shape)


def _inverse(x: Ints, p: int) -> Ints:
    if len(x) < 2:
        return np.array([pow(int(v), -1, p) for v in x], dtype=np.int64)
    half = len(x) // 2
    first, second, rest = x[:half], x[half : 2 * half], x[2 * half :]
    inverted = _inverse(np.concatenate([reduced(first * second, p), rest]), p)
    pairs = inverted[:half]
    return np.concatenate([reduced(pairs * second, p), reduced(pairs * first, p), inverted[half:]])


def determinants(at: Ints, rows: Ints, p: int = MODULUS) -> Ints:
    """Brackets (row, point) at positions (sample, point, coordinate): an array (row, sample)."""
    columns = np.moveaxis(at.astype(np.uint64)[:, rows, :], (2, 3, 1), (0, 1, 2))  # (place, coordinate, row, sample)
    value: list[Any] = list(columns[0])
    for k in range(1, rows.shape[1]):
        value = [_signed_sum(value, columns[k], products, p) for products in join_table(rows.shape[1], k, 1)]
    return np.asarray(value[0]).astype(np.int64)


_AT_ONCE = 4  # products of two residues below 2³¹ whose sum has 64 bits


def _signed_sum(a: list[Any], b: Any, products: Sequence[tuple[int, int, int]], p: int) -> Any:
    square = np.uint64(p * p)
    terms = [a[i] * b[j] if sign > 0 else square - a[i] * b[j] for i, j, sign in products]
    parts = [reduced(reduce(add, terms[k : k + _AT_ONCE]), p) for k in range(0, len(terms), _AT_ONCE)]
    return parts[0] if len(parts) == 1 else reduced(reduce(add, parts), p)
