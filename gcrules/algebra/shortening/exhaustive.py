r"""Every combination of k bracket monomials that a polynomial may be: a complete search modulo a prime.

P lies in the span of k monomials. All but two of them are chosen and eliminated, then P; the last two are
now proportional, so equal keys in one sorted list show all pairs. Symmetries of P leave few choices for the first
monomial, its stabilizer few for the second, and so on; what has been tried takes no part any more.

What the search does not find does not exist. Let c₀ P = Σ cᵢ Mᵢ with k independent monomials, k as small as possible,
and whole coprime numbers c₀, …, cₖ. Where c₀ is not 0 modulo p, the relation holds modulo p at every position, and is
found; the positions can only let too much pass. So if nothing is found modulo several primes, all of them divide c₀.
But c₀ divides a minor of the matrix that holds the coefficients of the Mᵢ in the coordinates of the points. These are
at most B = `coefficient_bound`, so by Hadamard's inequality the minor is at most k^(k/2) B^k, and as many primes are
taken as have a larger product. (k ≤ 2 needs no bound: different monomials have no constant ratio modulo p either.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import prod

import numpy as np

from gcrules.algebra.factoring.modular import MODULUS, Ints, inverse, minor, reduced
from gcrules.algebra.shortening.monomials import Monomials
from gcrules.algebra.shortening.symmetry import Action
from gcrules.core.budget import Count

__all__ = ["Unlucky", "certain", "combinations_of", "spans"]

_BLOCK = 1 << 16
_PAIRS_OF_A_GROUP = 8


class Unlucky(Exception):
    """Residues that vanish by accident: other positions are needed. Hardly ever seen."""


def certain(monomials: Monomials, terms: int, primes: Sequence[int] = (MODULUS,)) -> bool:
    """Whether searches for so many terms that find nothing modulo each of these primes prove that there is nothing."""
    return terms <= 2 or terms**terms * monomials.coefficient_bound() ** (2 * terms) < prod(primes) ** 2


def combinations_of(
    terms: int, value: Ints, target: Ints, action: Action, elements: Ints, work: Count, p: int = MODULUS
) -> Iterator[tuple[int, ...]]:
    """The places of all sets of so many monomials, up to symmetry, in whose span the polynomial may lie.

    `value` holds the monomials' values modulo p (monomial, position), `target` those of the polynomial, at more than
    `terms` + 1 positions. It must be known that fewer terms do not suffice. Raises LimitReached and Unlucky.
    """
    if terms == 1:
        same = (minor(value[:, 1:], target[:1], value[:, :1], target[None, 1:], p) == 0).all(axis=1)
        yield from ((int(i),) for i in np.flatnonzero(same))
        return
    search = _Search(value, target, action, work, p)
    for found in search.choose(terms, np.arange(len(value)), value, target, (), elements):
        if spans(value[list(found)], target, p):
            yield found


def spans(vectors: Ints, target: Ints, p: int = MODULUS) -> bool:
    """Whether the target is a combination of independent vectors modulo p."""
    rows, rest = vectors.copy(), target.copy()
    for i in range(len(rows)):
        pivots = np.flatnonzero(rows[i])
        if not len(pivots):
            return False
        at = int(pivots[0])
        pivot = rows[i].copy()
        rest = minor(rest, pivot[at], rest[at], pivot, p)
        rows[i + 1 :] = minor(rows[i + 1 :], pivot[at], rows[i + 1 :, at : at + 1], pivot[None], p)
    return not rest.any()


class _Search:
    def __init__(self, value: Ints, target: Ints, action: Action, work: Count, p: int) -> None:
        self.value = value
        self.target = target
        self.action = action
        self.work = work
        self.p = p

    def choose(
        self, terms: int, alive: Ints, value: Ints, target: Ints, chosen: tuple[int, ...], elements: Ints
    ) -> Iterator[tuple[int, ...]]:
        """Choose from the monomials `alive`, whose values and the target's are reduced by those chosen before."""
        if not target[0]:
            raise Unlucky
        if terms == 2:
            self.work.spend(len(alive))
            yield from self._pairs(alive, value[None], target[None], chosen, [()])
            return
        labels = self.action.labels(elements)[alive]
        while len(alive):
            names, first, size = np.unique(labels, return_index=True, return_counts=True)
            tried = np.argsort(-size, kind="stable")[: 1 if terms > 3 else max(1, _BLOCK // len(alive))]
            places = first[tried]
            if (value[places].any(axis=1) & (value[places, 0] == 0)).any():
                raise Unlucky
            places = places[value[places, 0] != 0]  # the others depend on those chosen before
            if terms == 3 and len(places):
                yield from self._last(alive, value, target, chosen, places)
            for place in places.tolist() if terms > 3 else ():
                one = value[place]
                self.work.spend(value.size)
                yield from self.choose(
                    terms - 1,
                    alive,
                    minor(value[:, 1:], one[0], value[:, :1], one[None, 1:], self.p),
                    minor(target[1:], one[0], target[0], one[1:], self.p),
                    (*chosen, int(alive[place])),
                    self.action.stabilizer(elements, int(alive[place])),
                )
            live = ~np.isin(labels, names[tried])  # what was tried takes no part any more
            alive, value, labels = alive[live], value[live], labels[live]

    def _last(
        self, alive: Ints, value: Ints, target: Ints, chosen: tuple[int, ...], places: Ints
    ) -> Iterator[tuple[int, ...]]:
        """Pairs for each of several choices of the third monomial from the end, all at once."""
        self.work.spend(len(places) * len(alive))
        one = value[places]
        rest = minor(value[None, :, 1:4], one[:, None, :1], value[None, :, :1], one[:, None, 1:4], self.p)
        aim = minor(target[None, 1:4], one[:, :1], target[:1], one[:, 1:4], self.p)
        if not aim[:, 0].all():
            raise Unlucky
        yield from self._pairs(alive, rest, aim, chosen, [(int(alive[p]),) for p in places])

    def _pairs(
        self, alive: Ints, value: Ints, target: Ints, chosen: tuple[int, ...], more: list[tuple[int, ...]]
    ) -> Iterator[tuple[int, ...]]:
        """Pairs of monomials in whose span the target lies: `value` is (choice, monomial, position), `target` (choice,
        position); three positions are looked at.
        """
        x = minor(value[..., 1], target[:, :1], value[..., 0], target[:, 1:2], self.p)
        y = minor(value[..., 2], target[:, :1], value[..., 0], target[:, 2:3], self.p)
        key = reduced(y * inverse(x, self.p), self.p)
        nothing = (x == 0) & (y == 0)
        key = np.where(nothing, -1 - np.arange(key.shape[1]), key)
        ordered = np.sort(key, axis=1)
        for n in np.flatnonzero((ordered[:, 1:] == ordered[:, :-1]).any(axis=1)):
            yield from self._groups(alive, value[n], x[n], key[n], (*chosen, *more[n]))
        for n, i in zip(*np.nonzero(nothing), strict=True):
            self._expect_dependent((*chosen, *more[n]), int(alive[i]))

    def _groups(
        self, alive: Ints, value: Ints, x: Ints, key: Ints, chosen: tuple[int, ...]
    ) -> Iterator[tuple[int, ...]]:
        """Pairs with one key that are not proportional already before the target is eliminated."""
        order = np.argsort(key, kind="stable")
        starts = np.flatnonzero(np.concatenate([[True], key[order][1:] != key[order][:-1]]))
        ends = np.append(starts[1:], len(order))
        own = np.where(value[:, 0] == 0, -1, reduced(value[:, 1] * inverse(value[:, 0], self.p), self.p))
        for low, high in zip(starts.tolist(), ends.tolist(), strict=True):
            if high - low < 2:
                continue
            group = order[low:high].tolist()
            found = 0
            for n, i in enumerate(group):
                for j in group[n + 1 :]:
                    if (own[i] != own[j] or not x[i]) and found < _PAIRS_OF_A_GROUP:
                        found += 1
                        yield tuple(sorted((*chosen, int(alive[i]), int(alive[j]))))

    def _expect_dependent(self, chosen: tuple[int, ...], place: int) -> None:
        """A monomial that vanishes with the target and the chosen ones at three positions must do so at all."""
        if place not in chosen and not spans(self.value[list(chosen)], self.value[place], self.p):
            raise Unlucky
