r"""What a class of legs has of aspects at least, in words of Markdown."""

from __future__ import annotations

from gcrules.algebra.language.text import text
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.aspects import LeastAspects, least_aspects
from gcrules.core.english import listed
from gcrules.views.pages.markdown import inline

__all__ = ["aspects_section"]

_GUIDE = "[guide](../aspects.md#classes)"
_OPEN = f"Whether there are more is open. `gcrules aspects` looks at a platform with coordinates ({_GUIDE})."


def aspects_section(a: Analysis) -> list[str]:
    """The section of a page; nothing where nothing is known."""
    found = least_aspects(a)
    if found is None:
        return []
    poses = "The regular poses of a generic platform of this class lie in at least"
    head = f"{poses} {found.number} aspects, parts within which poses are connected without a singularity."
    return ["## Aspects", "", f"{head} {_why(a, found)} {_OPEN}", ""]


def _why(a: Analysis, found: LeastAspects) -> str:
    names = [inline(text(f, unicode=True, names=a.structure.names)) for f in found.factors]
    if len(names) == 1:
        return "The superbracket has degree 3 in the translation of the platform, so it has both signs far away."
    if found.line is None:
        return (
            f"The brackets {listed(names)} have degree 1 in the translation of the platform, with independent"
            f" gradients: in a generic orientation they take all {found.number} patterns of signs, each in a convex set"
            " of translations."
        )
    one, two = (names[found.degrees.index(d)] for d in (1, 2))
    line = "".join(found.line)
    return (
        f"In the translation of the platform {one} has degree 1 and {two} degree 2. The leading form of the latter"
        f" vanishes along {line} and changes its sign there; reversing a translation keeps it and changes the sign"
        " of the former. So far away all 4 patterns of signs occur."
    )
