r"""Straightening without syzygies: the normal form from the coefficients at diagonal monomials.

Written out in coordinates x[p, c] (point p, row c of its column), a bracket with points p1 < p2 < … has the leading
monomial x[p1, 1] x[p2, 2] … in the lexicographic order x[1, 1] > x[1, 2] > … > x[2, 1] > …, so a standard tableau has
the product of x[T[r][c], c] over all its places, and different standard tableaux have different leading monomials.
The coefficients of a bracket polynomial at these *diagonal* monomials therefore determine its normal form through a
unitriangular system of integers. It is exact, needs no prime, and shares no code with the rewriting in `straighten`.
Nothing is multiplied out for it: a diagonal monomial says in which row of the coordinates each point is taken, so its
coefficient in a product of brackets is a product of signs; where a point occurs several times, a sum of such products.
Derived here; the idea is that of straightening by Capelli operators.
"""

from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise, permutations, product
from math import factorial, prod
from typing import TYPE_CHECKING, Any

from gcrules.algebra.bracket import BracketPolynomial, Monomial, Row, Terms
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.linear_algebra import permutation_sign

if TYPE_CHECKING:
    import numpy as np

__all__ = ["normal_form", "standard_tableaux"]

MAX_TABLEAUX = 50_000
MAX_WORDS = 1_000_000
_MAX_ARRANGEMENTS = 5_000
_KEPT = 2**26  # bytes of signs that are kept while a system is solved
_SAFE = 2**62  # whole numbers below do not overflow

_AHEAD = 256  # values that are looked at together for the next one that is not 0

_Content = tuple[int, ...]  # the points of a monomial with their multiplicities, increasing
_Word = tuple[int, ...]


def standard_tableaux(content: tuple[int, ...], rank: int) -> Iterator[Monomial]:
    """All standard tableaux with rows of length `rank` in which each point occurs as often as in `content`.

    >>> sum(1 for _ in standard_tableaux(tuple(range(12)), 4))
    462
    """
    rows = len(content) // rank
    letters = sorted(Counter(content).items())

    def fill(heights: tuple[int, ...], at: int, columns: tuple[Row, ...]) -> Iterator[Monomial]:
        if at == len(letters):
            yield tuple(zip(*columns, strict=True))
            return
        letter, count = letters[at]
        for places in _strips(heights, count, rows):
            grown = tuple(h + n for h, n in zip(heights, places, strict=True))
            longer = tuple((*c, *(letter,) * n) for c, n in zip(columns, places, strict=True))
            yield from fill(grown, at + 1, longer)

    if len(content) == rows * rank:
        yield from fill((0,) * rank, 0, ((),) * rank)


def _strips(heights: tuple[int, ...], count: int, rows: int) -> Iterator[tuple[int, ...]]:
    """Ways to put `count` equal points on top of columns of these heights: no two of them come into one row."""

    def place(column: int, left: int) -> Iterator[tuple[int, ...]]:
        if column == len(heights):
            if left == 0:
                yield ()
            return
        roof = rows if column == 0 else heights[column - 1]
        for n in range(min(left, roof - heights[column]), -1, -1):
            for rest in place(column + 1, left - n):
                yield (n, *rest)

    return place(0, count)


def normal_form(poly: BracketPolynomial) -> BracketPolynomial:
    """The normal form of a bracket polynomial; agrees with `straighten`.

    Monomials of unlike content are treated separately. Raises LimitReached where a content has more than 50,000
    standard tableaux, or its diagonal monomials are met in more than 10⁶ ways (a point in more than 5,000).
    """
    groups: dict[_Content, Terms] = {}
    for m, c in poly.terms.items():
        if not any(row[-1] < poly.ideal for row in m):
            groups.setdefault(tuple(sorted(i for row in m for i in row)), {})[m] = c
    normal: Terms = {}
    for content, terms in groups.items():
        normal |= _solve(content, poly.rank, terms)
    # With the points at infinity first in the order, a standard tableau that holds `rank` of them in one row is zero.
    return poly.with_terms({m: c for m, c in normal.items() if not any(row[-1] < poly.ideal for row in m)})


def _solve(content: _Content, rank: int, terms: Terms) -> Terms:
    """The normal form of terms with one content, from their values on standard tableaux, in triangular order."""
    if not content:
        return dict(terms)
    import numpy as np

    basis = _basis(content, rank)
    size = len(basis.tableaux)
    signs = _Signs(basis)
    given: list[Any] = list(terms.values())
    whole = all(isinstance(c, int) for c in given)
    bound = sum(map(abs, given)) * basis.ways  # no value exceeds it
    value: Any = np.zeros(size, dtype=np.int64 if whole and bound < _SAFE else object)
    for m, c in terms.items():
        value += signs.coefficients(m, 0).astype(value.dtype) * c
    found: Terms = {}
    at = 0
    while at < size:
        checkpoint()
        ahead = np.flatnonzero(value[at : at + _AHEAD])
        if not len(ahead):
            at += _AHEAD
            continue
        at += int(ahead[0])
        c = value[at] if value.dtype == object else int(value[at])
        found[basis.tableaux[at]] = c
        bound += abs(c) * basis.ways
        if bound >= _SAFE and value.dtype != object:
            value = value.astype(object)
        value[at:] -= signs.coefficients(basis.tableaux[at], at).astype(value.dtype) * c
        at += 1
    return found


@dataclass(frozen=True)
class _Basis:
    """The standard tableaux of a content, those with the largest diagonal monomials first, and the ways to meet them.

    A way ("word") says for each place of the content in which row of the coordinates its point is taken; a tableau
    has several if a point occurs several times. `words` holds them as columns, `starts` where each tableau's begin.
    """

    content: _Content
    rank: int
    tableaux: tuple[Monomial, ...]
    words: np.ndarray[Any, Any]
    starts: np.ndarray[Any, Any]
    ways: int  # the most that one tableau has


@lru_cache(maxsize=4)  # at most 50 MB each
def _basis(content: _Content, rank: int) -> _Basis:
    """The standard tableaux of a content in order, with what is needed to evaluate monomials on them."""
    import numpy as np

    found: list[tuple[_Word, Monomial]] = []
    for tableau in standard_tableaux(content, rank):
        checkpoint()
        places = sorted((p, c) for row in tableau for c, p in enumerate(row))
        found.append((tuple(c for _, c in places), tableau))
        if len(found) > MAX_TABLEAUX:
            raise LimitReached(f"more than {MAX_TABLEAUX:,} standard tableaux")
    found.sort()
    cuts = [0, *(i for i in range(1, len(content)) if content[i] != content[i - 1]), len(content)]
    parts = list(pairwise(cuts))
    words: list[_Word] = []
    starts: list[int] = []
    for diagonal, _ in found:
        checkpoint()
        starts.append(len(words))
        ways = [_arrangements(diagonal[i:j]) for i, j in parts]
        if len(words) + prod(map(len, ways)) > MAX_WORDS:
            raise LimitReached(f"the diagonal monomials are met in more than {MAX_WORDS:,} ways")
        words.extend(tuple(c for part in way for c in part) for way in product(*ways))
    columns = np.ascontiguousarray(np.array(words, dtype=np.uint8).T)
    most = max(np.diff([*starts, len(words)]).tolist())
    return _Basis(content, rank, tuple(t for _, t in found), columns, np.array(starts), most)


@lru_cache(maxsize=256)  # at most 1 MB each
def _arrangements(word: _Word) -> tuple[_Word, ...]:
    """All different words of these letters.

    >>> _arrangements((0, 0, 1))
    ((0, 0, 1), (0, 1, 0), (1, 0, 0))
    """
    if prod(map(factorial, Counter(word).values())) * _MAX_ARRANGEMENTS < factorial(len(word)):
        raise LimitReached(f"a point can be taken in more than {_MAX_ARRANGEMENTS:,} ways")

    def grow(left: Counter[int], size: int) -> Iterator[_Word]:
        if not size:
            yield ()
        for c in sorted(left):
            if left[c]:
                left[c] -= 1
                yield from ((c, *rest) for rest in grow(left, size - 1))
                left[c] += 1

    return tuple(grow(Counter(word), len(word)))


class _Signs:
    """Coefficients of bracket monomials at the diagonal monomials of a basis."""

    def __init__(self, basis: _Basis) -> None:
        self.basis = basis
        self.kept: dict[_Word, np.ndarray[Any, Any]] = {}
        self.several = basis.ways > 1

    def coefficients(self, monomial: Monomial, first: int) -> np.ndarray[Any, Any]:
        """At the diagonal monomials from number `first` on."""
        import numpy as np

        start = int(self.basis.starts[first])
        seen: Counter[int] = Counter()
        out: np.ndarray[Any, Any] | None = None
        for row in monomial:
            signs = self._row(tuple(bisect_left(self.basis.content, p) + seen[p] for p in row))[start:]
            out = signs if out is None else out * signs
            seen.update(row)
        assert out is not None
        return np.add.reduceat(out, self.basis.starts[first:] - start, dtype=np.int64) if self.several else out

    def _row(self, places: _Word) -> np.ndarray[Any, Any]:
        """For each word the sign of the permutation that it has at these places; 0 if it has none."""
        if places not in self.kept:
            words, rank = self.basis.words, self.basis.rank
            code = words[places[0]].astype(_code_type(rank))
            for place in places[1:]:
                code *= rank
                code += words[place]
            if len(self.kept) * words.shape[1] > _KEPT:
                self.kept.clear()
            self.kept[places] = _sign_table(rank)[code]
        return self.kept[places]


def _code_type(rank: int) -> type[np.integer[Any]]:
    import numpy as np

    return np.uint8 if rank <= 4 else np.uint32


@lru_cache
def _sign_table(rank: int) -> np.ndarray[Any, Any]:
    """The sign of each word of length `rank`, read as a number to the base `rank`: 0 if it is no permutation."""
    import numpy as np

    table = np.zeros(rank**rank, dtype=np.int8)
    for order in permutations(range(rank)):
        table[sum(c * rank ** (rank - 1 - i) for i, c in enumerate(order))] = permutation_sign(order)
    return table
