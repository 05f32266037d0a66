"""Zeros of polynomials in an interval: those of another road, however near each other."""

from __future__ import annotations

import math
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from gcrules.poses.paths.roots import WIDTH, integers, roots, sign_after, sign_before, value

F = Fraction
small = st.integers(-6, 6)


# --- zeros of polynomials -------------------------------------------------------------------------------------------


def product(*factors: list[int]) -> list[int]:
    found = [1]
    for f in factors:
        found = [
            sum(found[i] * f[n - i] for i in range(len(found)) if 0 <= n - i < len(f))
            for n in range(len(found) + len(f) - 1)
        ]
    return found


@pytest.mark.parametrize(
    ("p", "expected"),
    [
        ([5], []),
        ([1, 0, 1], []),
        ([-1, 2], [(F(1, 2), 1)]),
        ([0, 1], [(F(0), 1)]),
        ([-1, 1], [(F(1), 1)]),
        ([0, 0, 1, -1], [(F(0), 2), (F(1), 1)]),
        (product([-1, 3], [-1, 3], [-1, 3]), [(F(1, 3), 3)]),
        (product([-1, 2], [-1, 2], [1, 0, 1]), [(F(1, 2), 2)]),
        (product([-3, 7], [-3, 7], [-1, 2]), [(F(3, 7), 2), (F(1, 2), 1)]),
        (product([-1, 4], [-3, 4], [-1, 2]), [(F(1, 4), 1), (F(1, 2), 1), (F(3, 4), 1)]),
        (product([1, 2], [-3, 2]), []),
        ([-1, 0, 2], [(math.sqrt(0.5), 1)]),
        (product([-1, 0, 2], [-1, 0, 2]), [(math.sqrt(0.5), 2)]),
    ],
    ids=str,
)
def test_zeros_that_are_known(p: list[int], expected: list[tuple[Any, int]]) -> None:
    found = roots(p)
    assert [r.multiplicity for r in found] == [m for _, m in expected]
    for r, (place, _) in zip(found, expected, strict=True):
        assert r.upper - r.lower <= WIDTH
        assert r.lower == place == r.upper if isinstance(place, Fraction) else abs(float(r.middle) - place) < 1e-15


def test_zeros_that_are_very_near_each_other() -> None:
    tiny = 10**30
    found = roots(product([-tiny // 2, tiny], [-tiny // 2 - 1, tiny], [-tiny // 2 - 1, tiny]))
    assert [r.multiplicity for r in found] == [1, 2]
    assert found[0].upper <= found[1].lower
    assert found[0].lower <= F(1, 2) <= found[0].upper
    assert found[1].lower <= F(1, 2) + F(1, tiny) <= found[1].upper


def test_the_zero_polynomial_is_refused() -> None:
    with pytest.raises(ValueError, match="zero polynomial"):
        roots([0, 0])


def sturm(p: list[int]) -> int:
    """How many different zeros a polynomial has in (0, 1], by the changes of sign in Sturm's chain."""
    chain = [[F(c) for c in p], [n * F(c) for n, c in enumerate(p)][1:]]
    while any(chain[-1]):
        rest, divisor = list(chain[-2]), chain[-1]
        while len(rest) >= len(divisor):
            lead = rest.pop() / divisor[-1]
            for k, c in enumerate(divisor[:-1]):
                rest[len(rest) - len(divisor) + 1 + k] -= lead * c
        while rest and not rest[-1]:
            rest.pop()
        chain.append([-c for c in rest])
    at = ([q[0] for q in chain[:-1]], [sum(q) for q in chain[:-1]])
    below, above = (sum(a * b < 0 for a, b in pairwise([v for v in some if v])) for some in at)
    return below - above


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.lists(small, min_size=2, max_size=4), st.integers(1, 3)), min_size=1, max_size=3))
def test_zeros_are_those_of_another_road(factors: list[tuple[list[int], int]]) -> None:
    p = integers(product(*(f for f, times in factors for _ in range(times))))
    assume(len(p) > 1 and p[0])  # Sturm's chain tells nothing at a multiple zero
    found = roots(p)
    assume(all(r.multiplicity == 1 for r in found if r.lower in (0, 1)))
    assert len(found) == sturm(p)
    assert all(a.upper <= b.lower for a, b in pairwise(found))
    for r in found:
        slopes, order = p, 0
        while r.exact and not value(slopes, r.lower):
            slopes, order = [n * c for n, c in enumerate(slopes)][1:], order + 1
        assert order == r.multiplicity if r.exact else r.upper - r.lower <= WIDTH
        if not r.exact:
            below, above = value(p, r.lower), value(p, r.upper)
            assert (below * above < 0) == (r.multiplicity % 2 == 1)


@settings(max_examples=40, deadline=None)
@given(st.lists(small, min_size=1, max_size=6).filter(any))
def test_signs_at_the_ends(p: list[int]) -> None:
    tiny = F(1, 10**9)
    p = integers(p)
    for sign, x in ((sign_after(p), tiny), (sign_before(p), 1 - tiny)):
        assert sign == np.sign(float(sum(c * x**n for n, c in enumerate(p))))
