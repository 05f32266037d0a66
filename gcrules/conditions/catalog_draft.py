r"""Drafts of catalog entries: everything about a class that can be computed, in the form of a catalog file."""

from __future__ import annotations

from gcrules.algebra.language.legs_text import Leg, Structure, legs_text
from gcrules.algebra.superbrackets.shortest import counts
from gcrules.conditions.analysis import analyze
from gcrules.conditions.catalog_check import factors

__all__ = ["draft"]


def draft(entry_id: str, legs: tuple[Leg, ...]) -> str:
    """An entry as YAML: degrees, terms, factors, group, status, and the condition that the rules find.

    Where they find none the condition is the linear complex, to be replaced by a better reading with its statement.
    """
    structure = Structure(legs)
    found = analyze(structure).condition
    regular = found.kind != "always-singular"
    known = found.group is not None or not regular
    kind, expression = (found.kind, found.expression) if known else ("linear-complex", structure.superbracket)
    terms = {form: min(n) for form, n in counts(legs).items()}
    brackets = ["".join(f) for f in factors(structure)] if regular else []
    lines = [
        f"  - id: '{entry_id}'",
        f"    legs: {legs_text(legs)}",
        f"    degrees: {[list(side) for side in structure.degrees]}",
        f"    terms: {{24: {terms[24]}, 16: {terms[16]}}}",
        f"    factors: [{', '.join(brackets)}]",
        f"    group: {found.group or 'none'}",
        f"    status: {'added' if regular else 'always-singular'}",
        "    sources: []",
        "    condition:",
        f"      kind: {kind}",
        *([f"      coefficient: {found.coefficient}"] if known and found.coefficient != 1 else []),
        f"      expression: '{expression}'",
    ]
    return "\n".join(lines)
