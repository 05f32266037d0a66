"""Exchange relations with their multipliers as Coq reads them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from math import lcm
from typing import Any

from gcrules.views.proofs.coq_expressions import derived

__all__ = ["denominator", "named_rows", "relation_texts", "written_relations"]

_TOGETHER = 100  # relations in one definition


def named_rows(relations: Iterable[Any]) -> list[str]:
    """Definitions of all brackets that occur."""
    rows = sorted({tuple(row) for relation in relations for row in _rows(relation)})
    return [f"Definition {_row(row)} : list nat := [{'; '.join(map(str, row))}]." for row in rows]


def denominator(relations: Iterable[Any]) -> int:
    """The least number by which all coefficients are whole."""
    return lcm(*(Fraction(c).denominator for _, _, _, multiplier in relations for c, *_ in multiplier))


def relation_texts(relations: Iterable[Any], factor: int = 1) -> list[str]:
    """The relations times a factor."""
    written = []
    for first, second, count, multiplier in relations:
        parts = [f"times_brackets ({Fraction(c) * factor}) [{'; '.join(map(_row, rows))}]" for c, *rows in multiplier]
        written.append(f"exchange_of {_row(first)} {_row(second)} {count} [{'; '.join(parts)}]")
    return written


def written_relations(name: str, relations: Sequence[Any], factor: int) -> list[str]:
    """The relations times a factor, as definitions of which the last has the name of them all."""
    written = relation_texts(relations, factor)
    blocks = [written[i : i + _TOGETHER] for i in range(0, len(written), _TOGETHER)]
    lines = []
    for i, block in enumerate(blocks):
        separated = ";\n  ".join(block)
        lines.append(f"Definition {derived(name, f'relations_{i}')} : list relation := [\n  {separated}].")
    joined = " ++ ".join([*(derived(name, f"relations_{i}") for i in range(len(blocks))), "[]"])
    return [*lines, f"Definition {derived(name, 'relations')} : list relation := {joined}."]


def _row(row: Sequence[int]) -> str:
    return derived("row", "_".join(map(str, row)))


def _rows(relation: Any) -> Iterable[Sequence[int]]:
    first, second, _, multiplier = relation
    yield from (first, second)
    for _, *rows in multiplier:
        yield from rows
