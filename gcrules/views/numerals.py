r"""Numbers as pages show them: with a true minus sign, and powers of ten instead of exponents."""

from __future__ import annotations

import re
from fractions import Fraction

from gcrules.core.floats import decimal

__all__ = ["figure", "in_prose"]

_RAISED = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_WITH_EXPONENT = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e([+-]?)0*(\d{1,3})(?![\w])")
_MINUS = re.compile(r"(?<![\w.)\]+-])-(?=\d)")
_CODE = re.compile('(`[^`]*`|"[^"]*")')


def figure(value: Fraction | float, digits: int = 4) -> str:
    """A number of so many digits; from a million on, and below a thousandth, with a power of ten. The 3D view of
    reports writes its numbers so too.

    >>> figure(-308392.4), figure(-3.08392e23), figure(0.0), figure(2.5e-7)
    ('−308400', '−3.084 × 10²³', '0', '2.5 × 10⁻⁷')
    """
    exact = Fraction(value)
    rounded = decimal(exact, digits)
    plain = exact == 0 or Fraction(1, 1000) <= abs(exact) < 10**6
    return in_prose(f"{float(rounded):.12g}" if plain else rounded)


def in_prose(text: str) -> str:
    """A text with its numbers so; what stands between backticks or in quotation marks is code, and stays.

    >>> in_prose("loops open by less than 1e-12, z = -3.5e+04 (3-RPS, `x=-1e-3`)")
    'loops open by less than 10⁻¹², z = −3.5 × 10⁴ (3-RPS, `x=-1e-3`)'
    """
    return "".join(part if k % 2 else _typeset(part) for k, part in enumerate(_CODE.split(text)))


def _typeset(text: str) -> str:
    return _MINUS.sub("−", _WITH_EXPONENT.sub(_power, text))


def _power(found: re.Match[str]) -> str:
    mantissa, sign, exponent = found.groups()
    power = f"10{(sign.replace('+', '') + exponent).translate(_RAISED)}"
    return power if mantissa == "1" else f"{mantissa} × {power}"
