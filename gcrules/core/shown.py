"""Results know what they are, not how they look: every form of one is asked of the views.

`gcrules` names the function that finds a form (`gcrules.views.forms.shown`) when it is imported; no room below the
views knows one of them.
"""

from __future__ import annotations

from gcrules.core.deferred import resolved

TYPE_CHECKING = False  # the command line begins here, and hears no signals while typing is loaded
if TYPE_CHECKING:
    from typing import Any

__all__ = ["Shown", "show_by"]

_where = ""


def show_by(where: str) -> None:
    """Let the function `package.module:name`, called as f(value, form, **options), give the forms of all values: text,
    str, latex, formula, html, svg, or one that few have; None for a form that a value does not have.
    """
    global _where
    _where = where


def _view(value: object, form: str, **options: Any) -> Any:
    return resolved(_where)(value, form, **options)


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
