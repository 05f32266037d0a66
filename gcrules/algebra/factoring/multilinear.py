r"""Cayley factorization of multilinear bracket polynomials (every point occurs once in every term).

The steps are those of White's algorithm as reviews give them (White1991; the paper was not read), the reasons derived
here. Let P be c times a product of scalar expressions of joins and meets, and join nodes and meet nodes of their trees
as in `trees`. Extensors of separate points are independent of each other: they take all values. Hence

* P vanishes where two points coincide if and only if they hang on one join node. (Along the path from one to the
  other some branch may be chosen so that the point does not lie in it.) So the *atomic extensors*, the classes of
  points in which P alternates, are the point sets of the join nodes: P alone determines them.
* P depends on two atomic extensors E and F with steps beyond d through E ∧ F only if and only if E and F are whole
  branches of one meet node. Then P(E, F, …) = P'(E ∧ F, …), and P' has the same tree with E ∧ F as a point set.

So the tree is unique, the order in which *primitive factors* E ∧ F are replaced does not matter, and P is no product of
expressions as soon as points are left but no primitive factor is. P' is never written out: with G = E ∧ F,
P'(G, …) = ± P(G ∨ X, G ∨ Y, …) / [G X Y] for any X and Y.

What is rejected is so for certain. What is accepted, is so at random positions modulo a prime, which nobody can foresee
(the seed depends on the polynomial and on the run): of what is false no more than the share D/p passes each position, D
the degree. Where points are united, and nothing else was accepted, that is proved by normal forms if it can be.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import combinations

import numpy as np

from gcrules.algebra.bracket import BracketPolynomial
from gcrules.algebra.factoring.coincidences import united
from gcrules.algebra.factoring.modular import MODULUS, Ints
from gcrules.algebra.factoring.residues import random_positions, values
from gcrules.algebra.factoring.tree_letters import Tree
from gcrules.algebra.straightening.straighten import is_zero
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import LimitReached
from gcrules.core.seeds import seed

__all__ = ["Multilinear", "factor_multilinear", "seems_zero"]

_SAMPLES = 3
_DEGREES = 4  # degrees that the two sides of a test have in the coordinates, for each point
_TERMS_TO_PROVE = 20_000
_Function = Callable[[Mapping[int, Ints]], Ints]


@dataclass(frozen=True)
class Multilinear:
    """What the algorithm found. `scalars` are the factors found, each as a pair of complementary extensors.

    `complete` says whether they make up the whole polynomial; else `atoms` are the atomic extensors that are left, no
    two of which make a primitive factor. `accepted` counts the primitive factors that were accepted at random
    positions, `rejected` those that were rejected, each for certain. `error` bounds the probability that something
    false was accepted; 0 where all is proved.
    """

    scalars: tuple[tuple[Tree, Tree], ...]
    complete: bool
    atoms: tuple[Tree, ...] = ()
    accepted: int = 0
    rejected: int = 0
    error: float = 0.0


@dataclass
class _State:
    """A polynomial in letters, each with what it belongs to: a point, or a letter of the meet of two extensors."""

    rank: int
    function: _Function
    classes: list[list[int]]
    meaning: dict[int, list[Tree]]  # first letter of a class -> the points and meets that it joins
    next_letter: int
    seed: int
    tests: int = 0

    def fresh(self) -> int:
        """A seed that was not used before."""
        self.tests += 1
        return self.seed + self.tests


def seems_zero(poly: BracketPolynomial) -> bool:
    """Whether a polynomial vanishes at random positions modulo the prime; False is certain."""
    at = random_positions(_SAMPLES, len(poly.points), poly.rank, MODULUS, ideal=poly.ideal)
    return not values(poly, at, MODULUS).any()


def factor_multilinear(poly: BracketPolynomial) -> Multilinear:
    """The expressions of joins and meets whose product a multilinear polynomial is, or as far as that goes.

    The polynomial must not be zero modulo the prime.
    """
    letters = list(range(len(poly.points)))

    def function(at: Mapping[int, Ints]) -> Ints:
        return values(poly, np.stack(np.broadcast_arrays(*(at[i] for i in letters)), axis=1), MODULUS)

    used = sorted({i for m in poly.terms for row in m for i in row})
    claim = seed("multilinear", tuple(poly.terms.items()))
    filler = random_positions(1, len(letters), poly.rank, MODULUS, ideal=poly.ideal, seed=claim)
    fixed = {i: filler[:, i] for i in letters if i not in used}
    state = _State(
        poly.rank,
        lambda at: function({**fixed, **at}),
        [[i] for i in used],
        {i: [poly.points[i]] for i in used},
        len(letters),
        claim,
    )
    united: list[tuple[int, int]] | None = None
    scalars: list[tuple[Tree, Tree]] = []
    accepted = rejected = 0
    while True:
        checkpoint()
        merged = _merge(state)
        united = merged if united is None else united
        for whole in [c for c in state.classes if len(c) == state.rank]:
            *first, last = state.meaning[whole[0]]
            scalars.append((_joined(first), last))
            _finish(state, whole)
        if not state.classes:
            return Multilinear(tuple(scalars), True, (), accepted, rejected, _error(state, len(used)))
        for E, F in combinations(state.classes, 2):
            if len(E) + len(F) > state.rank:
                if _contract(state, E, F):
                    accepted += 1
                    break
                rejected += 1
        else:
            atoms = tuple(_joined(state.meaning[c[0]]) for c in state.classes)
            sure = not accepted and all(_alternates(poly, i, j) for i, j in united)
            error = 0.0 if sure else _error(state, len(used))
            return Multilinear(tuple(scalars), False, atoms, accepted, rejected, error)


def _error(state: _State, letters: int) -> float:
    """No more likely is it that one of the tests so far was passed by what is false."""
    return float(state.tests * letters**2 * (_DEGREES * letters / MODULUS) ** _SAMPLES)


def _alternates(poly: BracketPolynomial, one: int, other: int) -> bool:
    """Whether a polynomial is proved to vanish where two points coincide; False where that is not known."""
    try:
        return is_zero(united(poly, one, other), limit=_TERMS_TO_PROVE)
    except LimitReached:
        return False


def _joined(parts: list[Tree]) -> Tree:
    tree, *others = parts
    for other in others:
        tree = ("join", tree, other)
    return tree


def _positions(state: _State, samples: int) -> dict[int, Ints]:
    letters = [i for c in state.classes for i in c]
    at = random_positions(samples, len(letters), state.rank, MODULUS, seed=state.fresh())
    return {i: at[:, n] for n, i in enumerate(letters)}


def _merge(state: _State) -> list[tuple[int, int]]:
    """Unite the classes in which the polynomial alternates; two letters are enough to tell, one of each class. Returns
    the pairs of letters that told so.
    """
    pairs = list(combinations(range(len(state.classes)), 2))
    if not pairs:
        return []
    at = _positions(state, len(pairs) * _SAMPLES)
    for n, (g, h) in enumerate(pairs):
        a, b = state.classes[g][0], state.classes[h][0]
        rows = slice(n * _SAMPLES, (n + 1) * _SAMPLES)
        at[b][rows] = at[a][rows]
    values_ = state.function(at).reshape(-1, _SAMPLES).tolist()
    home = list(range(len(state.classes)))
    told = []
    for (g, h), pair in zip(pairs, values_, strict=True):
        if not any(pair) and home[h] == h:
            home[h] = home[g]
            told.append((state.classes[g][0], state.classes[h][0]))
    classes: dict[int, list[int]] = {}
    meaning: dict[int, list[Tree]] = {}
    for g, c in enumerate(state.classes):
        classes.setdefault(home[g], []).extend(c)
        meaning.setdefault(classes[home[g]][0], []).extend(state.meaning[c[0]])
    state.classes, state.meaning = list(classes.values()), meaning
    return told


def _finish(state: _State, whole: list[int]) -> None:
    """Divide by the scalar that a class of d letters is."""
    inner = state.function
    unit = {i: np.eye(state.rank, dtype=np.int64)[[n]] for n, i in enumerate(whole)}
    state.function = lambda at: inner({**unit, **at})
    state.classes.remove(whole)


def _contract(state: _State, E: list[int], F: list[int]) -> bool:
    """Replace E ∧ F by new letters if the polynomial depends on E and F through it only."""
    step = len(E) + len(F) - state.rank
    new = list(range(state.next_letter, state.next_letter + step))
    inner, rank = state.function, state.rank

    def through() -> _Function:
        others = random_positions(1, 2 * rank - len(E) - len(F), rank, MODULUS, seed=state.fresh())
        X = {i: others[:, n] for n, i in enumerate(E[step:])}
        Y = {i: others[:, n + len(X)] for n, i in enumerate(F[step:])}

        def function(at: Mapping[int, Ints]) -> Ints:
            G = [at[i] for i in new]
            frame = np.stack(np.broadcast_arrays(*G, *X.values(), *Y.values()), axis=1)
            first = dict(zip(E, G, strict=False))
            second = dict(zip(F, G, strict=False))
            return inner({**at, **first, **X, **second, **Y}) * _inverses(_determinants(frame, rank)) % MODULUS

        return function

    one, other = through(), through()
    trial = _State(
        rank,
        one,
        [*(c for c in state.classes if c is not E and c is not F), new],
        {},
        state.next_letter + step,
        state.fresh() << 20,
    )
    at = _positions(trial, _SAMPLES)
    if not (one(at) == other(at)).all():
        return False
    meet = ("meet", _joined(state.meaning[E[0]]), _joined(state.meaning[F[0]]))
    state.meaning[new[0]] = [meet]
    state.function, state.classes, state.next_letter = one, trial.classes, trial.next_letter
    return True


def _determinants(frame: Ints, rank: int) -> Ints:
    bracket = BracketPolynomial(rank, tuple(f"p{i}" for i in range(rank)), {(tuple(range(rank)),): 1})
    return values(bracket, frame, MODULUS)


def _inverses(x: Ints) -> Ints:
    return np.array([pow(int(v), -1, MODULUS) for v in x], dtype=np.int64)
