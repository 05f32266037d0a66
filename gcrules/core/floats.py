r"""Exact numbers as floats and as decimals, also where a float cannot hold them.

>>> as_float(Fraction(1, 3)), as_float(Fraction(10**400)), as_float(-Fraction(10**400))
(0.3333333333333333, inf, -inf)
>>> decimal(Fraction(-2, 3)), decimal(Fraction(10**400, 3)), decimal(Fraction(1, 10**400))
('-0.666667', '3.33333e+399', '1e-400')
"""

from __future__ import annotations

import math
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal
from fractions import Fraction
from numbers import Integral, Rational, Real
from typing import Any

from gcrules.core.arguments import described, is_truth
from gcrules.core.errors import InputError

__all__ = [
    "as_float",
    "decimal",
    "exact",
    "exact_float",
    "exact_number",
    "int_if_whole",
    "rounded_down",
    "rounded_up",
    "without_noise",
]

_WIDE = Context(prec=30, Emax=999_999, Emin=-999_999)


def as_float(number: Fraction | int) -> float:
    """The nearest float; infinite where none is as large."""
    try:
        return float(number)
    except OverflowError:
        return math.inf if number > 0 else -math.inf


NOISE = 1e-12
"""What an iteration in floats leaves of a number that is 0, in parts of what it is measured by."""


def without_noise(number: float, scale: float = 1.0) -> float:
    """The number, 0 where it is less than its accuracy.

    >>> without_noise(-3e-17), without_noise(3e-17, 1e-9)
    (0.0, 3e-17)
    """
    return 0.0 if abs(number) < NOISE * scale else float(number)


def rounded_down(number: float, digits: int = 4) -> str:
    """A bound from below of a number that is not negative, with so many digits: none of them is rounded up.

    >>> rounded_down(0.4298691), rounded_down(0.00364666), rounded_down(1.0), rounded_down(0.0)
    ('0.4298', '0.003646', '1', '0')
    """
    if not number > 0:
        return "0"
    short = Context(prec=digits, rounding=ROUND_FLOOR).create_decimal(Decimal(number))
    return f"{float(short):.{digits}g}"


def rounded_up(number: float, digits: int = 4) -> str:
    """A bound from above of a number that is not negative, with so many digits: none of them is rounded down.

    >>> rounded_up(0.4298611), rounded_up(2.41e-5, 2), rounded_up(1.0), rounded_up(0.0)
    ('0.4299', '2.5e-05', '1', '0')
    """
    if not number > 0:
        return "0"
    short = Context(prec=digits, rounding=ROUND_CEILING).create_decimal(Decimal(number))
    return f"{float(short):.{digits}g}"


def decimal(number: Fraction | int, digits: int = 6) -> str:
    """With so many digits, as `format(…, "g")` writes a float, for any size."""
    found = as_float(number)
    if math.isfinite(found) and (found or not number):
        return f"{found:.{digits}g}"
    exact = Fraction(number)
    quotient = _WIDE.divide(Decimal(exact.numerator), Decimal(exact.denominator))
    mantissa, _, exponent = f"{quotient:.{digits - 1}e}".partition("e")
    return f"{mantissa.rstrip('0').rstrip('.')}e{exponent}"


def int_if_whole(number: int | Fraction) -> int | Fraction:
    """The same number, which is an int if it is whole: quicker to compute with."""
    return number.numerator if number.denominator == 1 else number


def exact(value: Any, what: str = "this") -> Fraction:
    """A finite number as written: a float counts as the shortest decimal that it stands for (0.1 is 1/10).

    Raises InputError for NaN, infinity and what is no number.
    """
    if isinstance(value, (int, Fraction)) and not isinstance(value, bool):
        return Fraction(value)
    try:
        if is_truth(value) or not isinstance(value, (Real, Decimal, str)):
            raise TypeError
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{what} is {described(value)}, expected a number") from None
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise InputError(f"{what} is {number}, expected a finite number")
    return Fraction(repr(number))


def exact_float(value: Any, what: str = "this") -> float:
    """The same as a float. Raises InputError for numbers beyond floats too."""
    found = as_float(exact(value, what))
    if not math.isfinite(found):
        raise InputError(f"{what} is {decimal(exact(value))}, expected a number that floats can hold")
    return found


def exact_number(value: object) -> int | Fraction | None:
    """A rational number as Python's own; None for what is none, floats among them, which are not exact."""
    if isinstance(value, Integral):
        return int(value)
    return Fraction(value) if isinstance(value, Rational) else None
