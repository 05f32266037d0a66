"""Results know what they are, not how they look: every form of one is asked of the views.

`gcrules` hands in the function that finds a form (`gcrules.views.forms.shown`) when it is imported; no room below the
views names one of them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

__all__ = ["Shown", "show_by"]

View = Callable[..., Any]
_view: View


def show_by(view: View) -> None:
    """Let `view(value, form, **options)` give the forms of all values: text, latex, formula, html, svg; None for one
    that a value does not have.
    """
    global _view
    _view = view


class Shown:
    """A result. `text` is plain text, in ASCII or with the signs of mathematics; `latex` needs no dollar signs where it
    is a formula. Notebooks show the formula, or else what `_repr_html_` gives.
    """

    __slots__ = ()

    def text(self, *, unicode: bool = False, **options: Any) -> str:
        """Plain text; options are those of the result's view (`gcrules.views.forms`)."""
        return str(_view(self, "text", unicode=unicode, **options))

    def latex(self, **options: Any) -> str:
        """LaTeX: a formula without dollar signs, a table, or a document that compiles."""
        return str(_view(self, "latex", **options))

    def __str__(self) -> str:
        return str(_view(self, "str"))

    def _repr_latex_(self) -> str | None:
        formula = _view(self, "formula")
        return None if formula is None else f"$\\displaystyle {formula}$"

    def _repr_html_(self) -> str | None:
        html: str | None = _view(self, "html")
        return html

    def _repr_svg_(self) -> str | None:
        svg: str | None = _view(self, "svg")
        return svg

    def _show(self, form: str, **options: Any) -> Any:
        """A form that only this kind of result has."""
        return _view(self, form, **options)
