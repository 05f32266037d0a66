"""That something does not exist, with what was enumerated, so that another program can enumerate it again.

>>> from gcrules.algebra.factoring.factorize import factor
>>> from gcrules.algebra.language.syntax import parse
>>> found = no_expression(factor(parse("[[Aa, Ab, Bc, Bd, Ca, Dc]]")), "expansion")
>>> found.stated["searches"]
[{'inside': [], 'space': 6195825}]
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from functools import cache
from itertools import product
from math import prod
from typing import Any

from gcrules.algebra.expr import Bracket, points_of
from gcrules.algebra.factoring.products import sub_multisets
from gcrules.algebra.factoring.result import Factorization
from gcrules.algebra.letters import letters_of
from gcrules.algebra.proofs.proof_file import Absence, LeftOut
from gcrules.algebra.proofs.written import Written
from gcrules.algebra.shortening.result import Shortening, TermBound
from gcrules.core.english import counted

__all__ = ["no_expression", "no_shorter", "ways"]

_WAYS = 1_000_000  # pairs of multidegrees by which the expressions of a space are counted
_MULTILINEAR = "multilinear-algorithm"
_REASONS = {
    "normal-form": "value",
    "bracket-factors": "brackets",
    "exhaustive-search": "enumeration",
    "merging": "merging",
}


def no_expression(found: Factorization, theorem: str) -> Absence | LeftOut:
    """That a factorization found no expression. `theorem` has what the brackets leave on its right side."""
    name = "that no expression of the family equals it"
    searched = f"a search says so, {found.family.searched()}; {found.certificate.detail}"
    if found.ideal:
        return LeftOut(name, f"{searched}; with points at infinity it is not recomputed")
    if letters_of(found.points):
        return LeftOut(name, f"{searched}; with letters for lines and planes it is not recomputed")
    if found.certificate.method == _MULTILINEAR:
        claim = "no product of expressions of joins and meets, each point used once, equals it"
        written = Written(found.atoms)
        return Absence(name, claim, "no product", theorem, {"atoms": [written.of(e) for e in found.atoms]})
    if found.parts or found.remainder is None:
        return LeftOut(name, f"{searched}; of several irreducible factors it is not recomputed")
    degrees = Counter(found.remainder.degrees() or {})
    rows = Counter(tuple(sorted(map(str, points_of(f)))) for f in found.factors if isinstance(f, Bracket))
    searches = []
    for inside in sub_multisets(rows):
        space = ways(degrees + Counter(x for row in inside for x in row), found.rank)
        if space is None:
            return LeftOut(name, f"{searched}; it is too large to be recomputed")
        searches.append({"inside": [list(row) for row in inside], "space": space})
    irreducible = degrees.total() < 4 * found.rank
    claim = (
        "no expression of joins and meets of its points equals it"
        if irreducible
        else "no product of brackets and one expression of joins and meets, with its multidegree, equals it"
    )
    return Absence(name, claim, "no expression", theorem, {"irreducible": irreducible, "searches": searches})


def ways(degrees: Mapping[str, int], rank: int) -> int | None:
    """The ways to write an expression as its first point joined with an extensor, made of all the other points by joins
    and meets without a scalar inside; None where it takes too long to count them.
    """
    names = sorted(degrees)
    whole = (degrees[names[0]] - 1, *(degrees[x] for x in names[1:]))
    if prod((n + 1) * (n + 2) // 2 for n in whole) > _WAYS:
        return None

    @cache
    def trees(used: Sequence[int]) -> int:
        if sum(used) == 1:
            return 1
        total = 0
        for one in product(*(range(n + 1) for n in used)):
            other = tuple(n - k for n, k in zip(used, one, strict=True))
            if one > other or not sum(one) % rank or not sum(other) % rank:
                continue
            a = trees(one)
            total += a * (a + 1) // 2 if one == other else a * trees(other)
        return total

    return trees(whole)


def no_shorter(found: Shortening, theorem: str) -> Absence | LeftOut:
    """That no bracket polynomial with fewer than `lower` terms equals what was shortened."""
    needed = f"at least {counted(found.lower, 'term')} {'is' if found.lower == 1 else 'are'} needed"
    if found.polynomial.ideal:
        return LeftOut(
            f"that {needed}",
            f"{found.bound.detail}; this is not an identity, and not recomputed with points at infinity",
        )
    stated = {"least": found.lower, "parts": [_part(bound) for bound in found.bounds]}
    return Absence(f"that {needed}", needed, "no shorter polynomial", theorem, stated)


def _part(bound: TermBound) -> dict[str, Any]:
    reason = _REASONS[bound.method]
    stated: dict[str, Any] = {"degrees": sorted(map(list, bound.degrees)), "least": bound.least, "reason": reason}
    if reason == "brackets":
        stated["brackets"] = [list(row) for row in sorted(tuple(sorted(row)) for row in bound.brackets)]
    if reason in ("enumeration", "merging"):
        stated["monomials"] = bound.monomials
    if reason == "merging":
        stated["symmetries"] = [[sign, [list(pair) for pair in moved]] for sign, moved in bound.symmetries]
        stated["mergings"] = [[str(m.weight), m.least, [list(b) for b in m.blocks]] for m in bound.mergings]
    return stated
