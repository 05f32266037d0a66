"""An analysis as plain text."""

from __future__ import annotations

from textwrap import indent

from gcrules.algebra.language.text import text, text_terms
from gcrules.conditions.analysis import Analysis
from gcrules.views.detail import is_everything, naming_options
from gcrules.views.report.items import Item, KeyValue
from gcrules.views.report.parts import in_shell
from gcrules.views.report.stages import leading_sentences, stages
from gcrules.views.results.derivation import as_text as derivation_text
from gcrules.views.results.derivation import ascii_words
from gcrules.views.text_tables import line_width

__all__ = ["as_text", "formula"]

_LONG = 1.2  # of a line
_MOST_TERMS, _FIRST = 12, 3  # of a superbracket, unless all is asked for


def as_text(a: Analysis, *, unicode: bool = False, full: bool = False) -> str:
    """The stages as plain text; `unicode` writes ∧ ∨ and keeps arrows, `full` adds the derivation step by step."""
    full = full or is_everything()
    lines = [line for sentence in in_shell(leading_sentences(a)) for line in _wrapped(sentence.split(), "")] + [""]
    for n, stage in enumerate(stages(a), 1):
        lines += [f"{n}. {stage.title}", *_why(stage.why)]
        most = _MOST_TERMS if stage.id in ("superbracket", "shortest") and not full else None
        for item in stage.items:
            lines += _text_item(item, a, unicode, most)
        lines.append("")
    if full:
        chain = derivation_text(a.unfolded(), unicode=unicode)
        lines += [f"{n + 1}. Derivation", "   Every single step.", indent(chain, "   ")]
    out = "\n".join(lines).rstrip() + "\n"
    return out if unicode else ascii_words(out)


def _why(words: str) -> list[str]:
    """The sentence below a heading, in one line unless it is long."""
    if len(words) > _LONG * line_width():
        return _wrapped(words.split(), "   ")
    return [f"   {words}"] if words else []


def _text_item(item: Item, a: Analysis, unicode: bool, most: int | None = None) -> list[str]:
    """An item; of a formula with more terms than `most` the first few."""
    if isinstance(item, KeyValue):
        return _wrapped([f"{item.key:<12}", *item.value.split()], "   ")
    if isinstance(item, str):
        return _wrapped(item.split(), "   ")
    names = a.structure.names
    left = [text(item.left, unicode=unicode, names=names), "="] if item.left is not None else []
    right = list(text_terms(item.right, unicode=unicode, names=names))
    if most is not None and len(right) > most:
        right = [*right[:_FIRST], f"+ … ({len(right) - _FIRST} more terms{naming_options(', with --full')})"]
    return _wrapped([*left, *right], "     ")


def _wrapped(words: list[str], indent: str) -> list[str]:
    lines = [indent]
    for word in words:
        if len(lines[-1]) + len(word) > line_width() and lines[-1].strip():
            lines.append(indent + "  ")
        lines[-1] += (" " if lines[-1].strip() else "") + word
    return lines


def formula(a: Analysis) -> str:
    """The expression of the condition as LaTeX, without dollar signs."""
    return a.condition.expression.latex()
