"""Polynomials of loci in answers: exactly, or with decimals where their numbers are long."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from textwrap import fill

from gcrules.core.english import counted, listed
from gcrules.poses.loci.form import PolynomialForm
from gcrules.views.detail import is_everything
from gcrules.views.text_tables import WIDTH

__all__ = ["SHOWN", "brief", "degree_text", "degrees_text", "formula", "number", "size_text"]

SHOWN = 40
"""Polynomials of more terms, and numbers of more signs, are not printed with the summary."""

_ROUNDED = 400  # terms of polynomials that are printed where decimals are asked for
_LONG = 20  # digits of coefficients that nobody reads
_DIGITS = 6  # of decimals in their place


def size_text(form: PolynomialForm) -> str:
    """How long a polynomial is."""
    return f"{counted(len(form.terms), 'term')}, coefficients of {counted(form.digits, 'digit')} at most"


def degree_text(form: PolynomialForm) -> str:
    """Its degree, and in what.

    >>> degree_text(PolynomialForm(("x", "y"), (((2, 1), 3), ((0, 0), 1))))
    'degree 3 in x and y'
    """
    return f"degree {form.degree} in {listed(form.variables)}"


def degrees_text(found: Mapping[str, int]) -> str:
    """The degrees of a locus in one line."""
    degrees = dict(found)
    total = degrees.pop("total")
    groups = [f"{degrees.pop(g)} in the {g}" for g in ("translation", "rotation") if g in degrees]
    each = ", ".join(f"{n} {d}" for n, d in degrees.items())
    return f"{total} in all, {' and '.join(groups)}; {each}"


def formula(name: str, form: PolynomialForm, digits: int | None = None) -> str:
    """What is printed of a polynomial: all of it if it is short, else how to get it. With decimals of so many digits,
    or by default where coefficients are long, up to a factor.
    """
    if len(form.terms) > (SHOWN if digits is None else _ROUNDED) and not is_everything():
        return f"{name} is long: --full, --export sympy (or maple, singular), --json or --latex prints it."
    shown = decimals(form, digits)
    if shown is None:
        return fill(f"{name} = {form}", WIDTH, subsequent_indent="    ", break_long_words=False)
    largest = Decimal(max(abs(c) for _, c in form.terms))
    text = f"{name} / {largest:.5g} = {shown}"
    exact = "Decimals are rounded; --export sympy (or maple, singular) and --json have the exact numbers."
    return fill(text, WIDTH, subsequent_indent="    ", break_long_words=False) + f"\n\n{exact}"


def decimals(form: PolynomialForm, digits: int | None) -> str | None:
    """With decimals, where they are asked for or the coefficients are long; else nothing."""
    if digits is None and (form.digits <= _LONG or is_everything()):
        return None
    return form.rounded(digits or _DIGITS)


def brief(form: PolynomialForm, digits: int | None = None) -> str:
    """A short polynomial, or the size of a long one."""
    if len(form.terms) > SHOWN // 4:
        return f"one of degree {form.degree} with {len(form.terms)} terms"
    shown = decimals(form, digits)
    return str(form) if shown is None else f"{shown}, up to a factor"


def number(c: Fraction) -> str:
    """A number; of a long one its size."""
    if len(str(c)) <= SHOWN:
        return str(c)
    return f"about {Decimal(c.numerator) / Decimal(c.denominator):.6g}"
