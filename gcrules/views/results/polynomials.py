"""Polynomials of loci in answers: exactly, or with decimals where their numbers are long."""

from __future__ import annotations

from collections.abc import Mapping
from decimal import Decimal
from fractions import Fraction
from textwrap import fill

from gcrules.core.english import counted, listed, with_article
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.zero_set import EMPTY, zero_set
from gcrules.views.detail import is_everything, naming_options
from gcrules.views.text_tables import WIDTH

__all__ = [
    "SHOWN",
    "brief",
    "degree_text",
    "degrees_text",
    "factor_text",
    "formula",
    "irreducible",
    "multiple",
    "number",
    "shortened",
    "size_text",
    "zeros_text",
]

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
    if _is_long(form, digits):
        printed = ": --full, --export sympy (or maple, singular), --json or --latex prints it"
        return f"{name} is long{naming_options(printed)}."
    shown = decimals(form, digits)
    if shown is None:
        return fill(f"{name} = {form}", WIDTH, subsequent_indent="    ", break_long_words=False)
    text = f"{_largest(name, form)} = {shown}"
    where = "; --export sympy (or maple, singular) and --json have the exact numbers"
    exact = f"Decimals are rounded{naming_options(where)}."
    return fill(text, WIDTH, subsequent_indent="    ", break_long_words=False) + f"\n\n{exact}"


def _is_long(form: PolynomialForm, digits: int | None) -> bool:
    return len(form.terms) > (SHOWN if digits is None else _ROUNDED) and not is_everything()


def _largest(name: str, form: PolynomialForm) -> str:
    """A polynomial over its largest coefficient."""
    return f"{name} / {Decimal(form.largest):.5g}"


def multiple(coefficient: Fraction, name: str, form: PolynomialForm, digits: int | None, times: str) -> str:
    """A multiple of a polynomial; where that is shown with decimals, of it over its largest coefficient.

    >>> multiple(Fraction(-1, 2), "P", PolynomialForm(("x",), (((2,), 400), ((0,), -3))), 3, "*")
    '(-200) * (P / 400)'
    """
    if decimals(form, digits) is not None:
        return f"({number(coefficient * form.largest, _LONG)}) {times} ({_largest(name, form)})"
    return f"({number(coefficient)}) {times} {name}" if coefficient != 1 else name


def decimals(form: PolynomialForm, digits: int | None) -> str | None:
    """With decimals, where they are asked for or the coefficients are long; else nothing."""
    if digits is None and (form.digits <= _LONG or is_everything()):
        return None
    return form.rounded(digits or _DIGITS)


def brief(form: PolynomialForm, digits: int | None = None) -> str:
    """A polynomial, or the size of a long one."""
    if _is_long(form, digits):
        return f"one of degree {form.degree} with {len(form.terms)} terms"
    shown = decimals(form, digits)
    return str(form) if shown is None else f"{shown}, up to a factor"


def factor_text(form: PolynomialForm, multiplicity: int, digits: int | None = None, meaning: str = "") -> str:
    """A factor with its `meaning`, its power, and what its zeros are."""
    power = f", to the power {multiplicity}" if multiplicity > 1 else ""
    zeros = zeros_text(form, digits)
    return f"{brief(form, digits)}{meaning}{power}{f': {zeros}' if zeros else ''}"


def irreducible(name: str, form: PolynomialForm, kept: str = "") -> str:
    """That a polynomial has no factors, and what its zeros are; `kept` limits over what."""
    zeros = zeros_text(form)
    return f"none: {f'{name}, {zeros},' if zeros else name} is irreducible over the rationals{kept}"


def zeros_text(form: PolynomialForm, digits: int | None = None) -> str:
    """What the zeros of a polynomial are, with an article; "" where they have no name.

    >>> zeros_text(PolynomialForm(("x", "y", "z"), (((0, 0, 1), 1), ((0, 0, 0), 350))))
    'a plane with the normal (0, 0, 1)'
    """
    found = zero_set(form)
    if found is None:
        return ""
    if found.kind == EMPTY:
        return "without real zeros"
    kind = with_article(found.kind)
    if not found.normal:
        return kind
    normal = [str(c) for c in found.normal]
    if decimals(form, digits) is not None:
        most = max(map(abs, found.normal))
        normal = [f"{c / most:.{digits or _DIGITS}g}" for c in found.normal]
    return f"{kind} with the normal ({', '.join(normal)})"


def shortened(c: Fraction) -> str:
    """A number that was given: of one that nobody reads its size."""
    return str(c) if is_everything() else number(c, _LONG)


def number(c: Fraction, most: int = SHOWN) -> str:
    """A number; of one with more signs its size."""
    if len(str(c)) <= most:
        return str(c)
    return f"about {Decimal(c.numerator) / Decimal(c.denominator):.6g}"
