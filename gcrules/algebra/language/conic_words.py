r"""Letters for conics and quadrics in words: `polar(p, K)` is said of the conic K, `polar(p, Q)` of the quadric Q.

>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context, parse
>>> print(parse("[a polar(a, K)] - 2 conic(a, K)", context=parse_assumption("conic K", Context(3))).step)
0
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence

from gcrules.algebra.expr import Expr, points_of
from gcrules.algebra.language.parse_tree import Node, span_of
from gcrules.algebra.language.text import text
from gcrules.algebra.letter_forms import FORMS
from gcrules.algebra.letters import conics_of
from gcrules.algebra.space import Space
from gcrules.core.english import listed
from gcrules.core.errors import InputError

__all__ = ["called", "conic_behind", "known_on", "refuse_conic"]


def conic_behind(
    word: str,
    words: Collection[str],
    others: Collection[str],
    parts: Sequence[Node],
    letters: Collection[str],
    rank: int,
) -> tuple[list[Node], str]:
    """The arguments of a word without the letter for a conic or a quadric that stands last, and that letter, "" where
    there is none.

    Raises InputError where the word is not among `words`, which are said of the `letters` of this rank, and where there
    is no letter, not among `others`.
    """
    last = parts[-1]
    name = str(last.children[0]) if last.data == "word" else ""
    if name not in letters:
        if word not in others:
            raise InputError(f"{word}(…) is said of a letter, which stands last", span=span_of(last), hint=_LETTER)
        return list(parts), ""
    if word not in words:
        kind = FORMS[rank].word
        hint = f"words about {kind}s are {listed(list(words))}"
        raise InputError(f"{word}(…) says nothing of the {kind} {name}", span=span_of(last), hint=hint)
    return list(parts[:-1]), name


_LETTER = "declare it: `conic K` in the plane, `quadric Q` in space"


def called(e: Expr, made: Mapping[Expr, str], names: Iterable[str]) -> str:
    """The text of an expression, with names and words for what they stand for, where conics or quadrics are in it."""
    if e in made:
        return made[e]
    written = text(e, names=names)
    if conics_of(points_of(e)):
        for part, name in reversed(tuple(made.items())):
            long = text(part, names=names)
            written = written.replace(f"({long})", name).replace(long, name)
    return written


def known_on(
    point: Expr, conic: str, shown: Callable[[Expr], str], at: Space, made: Collection[Expr], tree: Node
) -> None:
    """Raises InputError where nothing says that a point is on a conic or a quadric: neither an assumption nor how it
    was made.
    """
    form = FORMS[at.rank].value(point, *FORMS[at.rank].own(conic))
    if form not in made and form not in {a.args[0] for a in at.given if a.kind == "zero"}:
        name = shown(point)
        hint = f"assume it before, `given incident({name}, {conic})`"
        raise InputError(f"nothing says that {name} is on {conic}", span=span_of(tree), hint=hint)


def refuse_conic(name: str, letters: Collection[str], rank: int) -> None:
    """Raises InputError for the letter of a conic or a quadric where a point must stand."""
    if name in letters:
        kind = FORMS[rank].word
        hint = f"{kind}s stand last in words about them: polar(p, {name}), incident(p, {name})"
        raise InputError(f"{name} is a {kind}, not a point or a line", hint=hint)
