"""What the server tells the page of a locus: its polynomials, as formulas to copy."""

from __future__ import annotations

from typing import TypedDict

from gcrules.apps.studio.protocol.study_views import FactItem

__all__ = ["LocusAnswer", "LocusFactorView", "LocusPartView", "PolynomialView", "RootView"]


class PolynomialView(TypedDict):
    degree: int
    terms: int
    plain: str
    latex: str
    python: str
    """A function of its variables, for numbers, arrays and symbols; of roots it takes the signs, in home's mode 1."""


class LocusFactorView(TypedDict):
    polynomial: PolynomialView
    multiplicity: int
    never: bool
    """It is 0 in no pose."""
    zeros: str
    """What its zeros are, "a plane with the normal (0, 0, 1)"; "" where they have no name."""


class LocusPartView(TypedDict):
    """The polynomial of the condition, or of one of its factors: `statement` says which."""

    name: str
    statement: str
    polynomial: PolynomialView
    factors: list[LocusFactorView]
    undecided: str
    """Why its factors are not known; "" where they are."""


class RootView(TypedDict):
    """A root that is a variable of the polynomials: its `square`, and whose `sign` it has in home's mode ("" where it
    is positive there).
    """

    name: str
    places: str
    square: PolynomialView
    sign: str


class LocusAnswer(TypedDict):
    variables: list[str]
    statement: str
    """What the zeros are."""
    notes: list[str]
    """How the pose was rounded."""
    parts: list[LocusPartView]
    roots: list[RootView]
    facts: list[FactItem]
