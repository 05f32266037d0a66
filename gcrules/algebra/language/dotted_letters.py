"""Letters in brackets in which some points have a dot above."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from gcrules.algebra.letters import names_of
from gcrules.algebra.names import step_name
from gcrules.core.errors import Span, SyntaxFault

__all__ = ["beside_dots"]


def beside_dots(
    name: str, dot: bool, letters: Mapping[str, int], screws: Collection[str], span: Span
) -> list[tuple[str, bool]]:
    """A point with its dot, or the points that a letter joins, which has none. Raises SyntaxFault for a screw."""
    hint = "write the meet, or the sum that the dots stand for"
    if name in screws:
        raise SyntaxFault(f"a dotted bracket can only hold points, and {name} is a screw", span=span, hint=hint)
    step = letters.get(name)
    if step is None:
        return [(name, dot)]
    if dot:
        raise SyntaxFault(f"a dot marks a point, and {name} is {step_name(step)}", span=span, hint=hint)
    return [(n, False) for n in names_of(name, step)]
