r"""Exact numbers as floats and as decimals, also where a float cannot hold them.

>>> as_float(Fraction(1, 3)), as_float(Fraction(10**400)), as_float(-Fraction(10**400))
(0.3333333333333333, inf, -inf)
>>> decimal(Fraction(-2, 3)), decimal(Fraction(10**400, 3)), decimal(Fraction(1, 10**400))
('-0.666667', '3.33333e+399', '1e-400')
"""

from __future__ import annotations

import math
from decimal import Context, Decimal
from fractions import Fraction

__all__ = ["as_float", "decimal"]

_WIDE = Context(prec=30, Emax=999_999, Emin=-999_999)


def as_float(number: Fraction | int) -> float:
    """The nearest float; infinite where none is as large."""
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf


def decimal(number: Fraction | int, digits: int = 6) -> str:
    """With so many digits, as `format(…, "g")` writes a float, for any size."""
    found = as_float(number)
    if math.isfinite(found) and (found or not number):
        return f"{found:.{digits}g}"
    exact = Fraction(number)
    quotient = _WIDE.divide(Decimal(exact.numerator), Decimal(exact.denominator))
    mantissa, _, exponent = f"{quotient:.{digits - 1}e}".partition("e")
    return f"{mantissa.rstrip('0').rstrip('.')}e{exponent}"
