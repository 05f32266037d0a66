r"""Factors of a robot's condition told apart: what drops rank where each of them vanishes.

The superbracket of the equivalent structure is a polynomial along a path of members; its roots modulo the prime are
singular members, exact. There the ranks of the constraints, of all wrenches and of the limbs are taken from the joint
screws, and it is seen which factors vanish.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import field
from fractions import Fraction
from itertools import combinations_with_replacement, count, islice

from gcrules.algebra.evaluate import Evaluator
from gcrules.algebra.expr import ONE, Expr, points_of
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError
from gcrules.mechanisms.description.family import Family, Path
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import Term, Values, combined, name_of
from gcrules.mechanisms.lines.derived import with_derived
from gcrules.mechanisms.lines.equivalent import Equivalent
from gcrules.mechanisms.lines.ranks import TYPES, Ranks, ranks, types_of
from gcrules.mechanisms.lines.singular import PRIME, interpolated, roots
from gcrules.rules.statement import NOTHING, Statement
from gcrules.screws import RATIONALS, RESIDUES, Field
from gcrules.screws.field import Row

__all__ = [
    "ASIDE",
    "ENOUGH",
    "KINDS",
    "FactorCause",
    "Poll",
    "Votes",
    "at_member",
    "causes_left",
    "constant",
    "paths",
    "superbracket_at",
    "tell_apart",
    "upstream",
]

KINDS: Mapping[str, str] = {
    "actuation": "the platform can move although the actuators are locked",
    "constraint": "the platform gains a freedom that its limbs should not allow",
    "mixed": "at some of these members the constraints lose rank, at others only all wrenches together do",
    "limb": "it vanishes only where a limb is singular by itself and the lines do not stand for its wrenches",
    "held": "the constraints lose rank, but actuators beyond the freedoms hold the platform",
    "choice": "it belongs to the chosen lines: the wrenches of the limbs keep their rank there",
    "never": "it cannot vanish for this robot",
    "not met": "no exact member was found at which it vanishes",
}
"""What the kinds of factors mean."""

ASIDE = ("never", "choice", "limb", "held")
"""Kinds of factors that are no singularities of the robot."""

ENOUGH = 3  # singular members of each kind; more are not counted, as how many there are on a path is chance
_MOST_PATHS = 48
_NEVER_SEEDS = (21, 22, 23)


@dataclass(frozen=True)
class FactorCause:
    """A factor of the condition: `kind` is a key of `KINDS`, `members` the number of exact singular members on which
    that was seen (not counted beyond `ENOUGH`), `reason` says why a factor never vanishes, `meaning` when it does.
    `same` is another factor of this robot that vanishes wherever this one does; `chosen` the number of those members at
    which a factor that counts vanishes although the wrenches keep their rank, since the chosen lines depend on each
    other. It is divided by the cofactor `over`, where it vanishes whether or not the robot is singular. One `of_design`
    keeps its value in every pose. `types` are the types of singularity (keys of `TYPES`) at all singular members.
    """

    expression: Expr
    kind: str
    members: int = 0
    reason: str = ""
    meaning: Statement = NOTHING
    same: Expr | None = None
    chosen: int = 0
    over: Expr = ONE
    of_design: bool = False
    types: tuple[str, ...] = ()

    @property
    def statement(self) -> str:
        """The meaning in words, "" where the factor has none."""
        return str(self.meaning)

    @property
    def remark(self) -> str:
        """What else there is to say of a factor that does not change as the robot moves."""
        return "a matter of the design, which no motion changes" if self.of_design else ""


@dataclass
class Votes:
    """Votes for the kind of a factor, and the types of singularity of those that are singular."""

    kinds: Counter[str] = field(default_factory=Counter)
    types: list[tuple[str, ...]] = field(default_factory=list)

    def cast(self, kind: str, types: tuple[str, ...]) -> None:
        """One more member."""
        self.kinds[kind] += 1
        if kind not in ASIDE or kind == "held":
            self.types.append(types)

    @property
    def common_types(self) -> tuple[str, ...]:
        """The types that all singular members have."""
        return tuple(name for name in TYPES if self.types and all(name in types for types in self.types))


@dataclass
class Poll:
    """Votes for each factor where it `alone` vanishes, where others vanish with it (`shared`), and where points that
    are different in the family coincide (`merged`); and how many singular members were met.
    """

    alone: dict[Expr, Votes] = field(default_factory=dict)
    shared: dict[Expr, Votes] = field(default_factory=dict)
    merged: dict[Expr, Votes] = field(default_factory=dict)
    met: int = 0
    unexplained: int = 0

    @classmethod
    def of(cls, factors: Sequence[Expr]) -> Poll:
        """No votes yet."""
        alone, shared, merged = ({e: Votes() for e in factors} for _ in range(3))
        return cls(alone, shared, merged)

    def best(self, e: Expr) -> Votes:
        """The votes that count for a factor. Those of merged points count only where there are no others."""
        return next((v for v in (self.alone[e], self.shared[e]) if v.kinds), self.merged[e])


def at_member(family: Family, structure: Equivalent, values: Values, field: Field = RESIDUES) -> Evaluator:
    """Values of expressions in the structure's points at a member, modulo the prime or rational; in the plane points
    are (x, y, w).
    """
    points: Mapping[str, Row] = structure.points(family, values, field)
    if family.plane:
        points = {n: (p[0], p[1], p[3]) for n, p in points.items()}
    return Evaluator(points, 3 if family.plane else 4, PRIME if field is RESIDUES else None)


def constant(
    family: Family, structure: Equivalent, e: Expr, over: Expr, members: Sequence[Evaluator]
) -> Fraction | None:
    """The number c with e = c · over in the whole family, or None where there is none.

    It holds at all `members`, which are modulo the prime; its value is read off at members with rational coordinates,
    for a residue does not tell which fraction it stands for, and must agree with those.
    """
    (p, q), *others = [(one.value(e)[0], one.value(over)[0]) for one in members]
    if not p or not q or any((p * s - q * r) % PRIME for r, s in others):
        return None
    drawn = (family.member(("constant", n), RATIONALS) for n in count())
    exact = (at_member(family, structure, values, RATIONALS) for values in drawn)
    values = ((Fraction(one.value(e)[0]), one.value(over)[0]) for one in exact)
    found = set(islice((r / s for r, s in values if s), 3))
    c = found.pop()
    return c if not found and (c.numerator * q - c.denominator * p) % PRIME == 0 else None


def superbracket_at(family: Family, structure: Equivalent, superbracket: Expr) -> Callable[[Values], int]:
    """The value of the superbracket at members."""

    def value(values: Values) -> int:
        return int(at_member(family, structure, values).value(superbracket)[0])

    return value


def paths(family: Family, names: Sequence[str], seed: object = 0) -> Iterator[Path]:
    """Paths of members, each moving one name on which these names depend, all in turn."""
    needed = upstream(family, names)
    moving = [n for n in family.parametrized if n in needed]
    for n in range(max(_MOST_PATHS, len(moving))):
        if moving:
            yield family.path((seed, n), moving[n % len(moving)])


def upstream(family: Family, names: Sequence[str]) -> set[str]:
    """These names and all that they are made from."""
    needed = set(names)
    for d in reversed(family.definitions):
        if d.name in needed:
            needed.update(d.relation.names)
    return needed


def tell_apart(
    family: Family,
    limbs: Sequence[LimbSpec],
    structure: Equivalent,
    superbracket: Expr,
    factors: Sequence[Expr],
    several: Collection[Expr] = (),
) -> tuple[tuple[FactorCause, ...], Poll]:
    """The kind of each factor, and how many singular members were met. `several` are factors that are known to vanish
    for more than one reason: because of them all paths are searched.
    """
    parts: dict[Expr, FactorCause] = {}
    for e in factors:
        reason = never(family, limbs, structure, e)
        if reason:
            parts[e] = FactorCause(e, "never", reason=reason)
    open_factors = [e for e in dict.fromkeys(factors) if e not in parts]
    names = [*points_of(superbracket), *structure.names]
    generic = ranks(family, limbs, family.member("generic"))
    poll = Poll.of(open_factors)
    value = superbracket_at(family, structure, superbracket)
    for path in paths(family, names):
        checkpoint()
        polynomial = interpolated(lambda t, path=path: value(path.member(t)))  # type: ignore[misc]
        for t in roots(polynomial or []):
            _vote(family, limbs, structure, path.member(t), generic, poll)
        if poll.alone and not several and all(_enough(votes.kinds) for votes in poll.alone.values()):
            break
    for e in open_factors:
        votes = poll.best(e)
        kinds, kind = votes.kinds, _kind(votes.kinds)
        choice = max(poll.alone[e].kinds["choice"], poll.shared[e].kinds["choice"])
        chosen = 0 if kind in ASIDE and kind != "held" else min(ENOUGH, choice)
        others = sum(kinds.values()) - (kinds["choice"] if chosen else 0)
        parts[e] = FactorCause(e, kind, min(ENOUGH, others) + chosen, chosen=chosen, types=votes.common_types)
    poll.met = min(poll.met, sum(p.members for p in parts.values()))
    return tuple(parts[e] for e in dict.fromkeys(factors)), poll


def _enough(votes: Counter[str]) -> bool:
    return votes["actuation"] + votes["constraint"] >= ENOUGH


def causes_left(
    family: Family,
    limbs: Sequence[LimbSpec],
    structure: Equivalent,
    superbracket: Expr,
    factors: Sequence[Expr],
    several: Collection[Expr] = (),
) -> tuple[tuple[FactorCause, ...], Poll]:
    """The factors of a robot that is given by lines: whose wrenches they are is not known."""
    reason = "the robot is given by its lines: actuation and constraint are not distinguished"
    return tuple(FactorCause(e, "mixed", reason=reason) for e in dict.fromkeys(factors)), Poll()


def _vote(
    family: Family, limbs: Sequence[LimbSpec], structure: Equivalent, values: Values, generic: Ranks, poll: Poll
) -> None:
    at = at_member(family, structure, values)
    zero = [e for e in poll.alone if not at.value(e)[0]]
    poll.met += 1
    if not zero:
        poll.unexplained += 1
    try:
        here = ranks(family, limbs, values)
    except GcrulesError:  # a joint is none at this member
        return
    if here.limbs != generic.limbs:
        kind = "limb"
    elif here.wrenches == generic.wrenches:
        if _imaginary(limbs, structure, values):
            return
        kind = "choice" if here.constraints == generic.constraints else "held"
    else:
        kind = "constraint" if here.constraints < generic.constraints else "actuation"
    if family.merged(values):
        counted = poll.merged
    else:
        counted = poll.alone if len(zero) == 1 else poll.shared
    for e in zero:
        counted[e].cast(kind, types_of(here, generic))


def _imaginary(limbs: Sequence[LimbSpec], structure: Equivalent, values: Values) -> bool:
    """Whether a direction has length zero, as residues may have and real directions have not."""
    vectors = [combined(t, values, RESIDUES) for limb in limbs for j in limb.joints for t in j.directions]
    rows = with_derived(structure.derived, values, RESIDUES)
    vectors += [(x, y, z) for x, y, z, w in rows.values() if not w]
    vectors += [values[n] for n in structure.ideal if n in values]
    return any(RESIDUES.dot(v, v) == 0 for v in vectors)


def _kind(votes: Counter[str]) -> str:
    singular = {k for k in ("actuation", "constraint") if votes[k]}
    if len(singular) == 2:
        return "mixed"
    if singular:
        return singular.pop()
    return next((k for k in ("held", "choice", "limb") if votes[k]), "not met")


def never(family: Family, limbs: Sequence[LimbSpec], structure: Equivalent, e: Expr) -> str:
    """Why a factor cannot vanish: it is one number on all members, or that times squared lengths that are not zero.

    Found at exact random members, error below 1e-15; "" where no reason is found, which proves nothing.
    """
    at = [family.member(seed) for seed in _NEVER_SEEDS]
    members = [at_member(family, structure, m) for m in at]
    numbers = [int(one.value(e)[0]) for one in members]
    if all(n == numbers[0] for n in numbers) and numbers[0]:
        c = constant(family, structure, e, ONE, members)
        return f"it is {c} in every configuration" if c is not None else ""
    if not all(numbers):
        return ""
    terms: list[Term] = list(dict.fromkeys(d for limb in limbs for j in limb.joints for d in j.directions))
    lengths = {name_of(t): [_square(combined(t, m, RESIDUES)) for m in at] for t in terms}
    for u, v in (j.directions for limb in limbs for j in limb.joints if j.kind == "U"):
        lengths[f"{name_of(u)} × {name_of(v)}"] = [
            _square(RESIDUES.cross(combined(u, m, RESIDUES), combined(v, m, RESIDUES))) for m in at
        ]
    for size in (1, 2):
        for some in combinations_with_replacement(lengths, size):
            rest = [n * pow(_product(lengths[w][i] for w in some), -1, PRIME) % PRIME for i, n in enumerate(numbers)]
            if rest[0] == rest[1] == rest[2]:
                return f"up to a number it is the product of squared lengths of {' and '.join(some)}"
    return ""


def _square(v: tuple[int, int, int]) -> int:
    return int(RESIDUES.dot(v, v)) or 1


def _product(numbers: Iterator[int]) -> int:
    found = 1
    for n in numbers:
        found = found * n % PRIME
    return found
