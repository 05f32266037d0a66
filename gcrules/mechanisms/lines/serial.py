r"""Singularities of the limbs themselves: where a limb's own twists depend on each other.

For a limb of rank r a determinant of r random combinations of its twists, in r random coordinates, is a polynomial
along a path of members. Where the limb loses rank it vanishes; so its roots, exact members modulo the prime, are tried,
and those with less rank show which simple conditions on the limb's points and directions hold. What is lost on sets of
codimension two or more is not met.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

from gcrules.core.english import listed
from gcrules.core.errors import GcrulesError
from gcrules.core.seeds import drawn
from gcrules.mechanisms.conditions.factor_causes import ENOUGH, paths, upstream
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import Term, Values, Vector, combined, name_of
from gcrules.mechanisms.lines.ranks import TYPES, ranks, types_of
from gcrules.mechanisms.lines.singular import PRIME, interpolated, roots
from gcrules.screws import RESIDUES
from gcrules.screws.field import Row

__all__ = ["LimbSingularity", "limb_singularities"]

_PATHS = 24


@dataclass(frozen=True)
class LimbCondition:
    """Where a limb's twists drop rank: an `expression` that vanishes there, "" where it is no bracket of points, the
    sentence, and the types of singularity (keys of `TYPES`) of the limb by itself: an actuator (RI) or passive joints
    (RPM) move with the platform at rest.
    """

    expression: str
    statement: str
    types: tuple[str, ...]

    def to_json(self) -> dict[str, object]:
        return {"expression": self.expression or None, "statement": self.statement, "types": list(self.types)}


@dataclass(frozen=True)
class LimbSingularity:
    """The conditions under which a limb's twists drop rank. `members` is the number of those on which they were seen,
    `unexplained` of those where none of the conditions tried holds; both end at `ENOUGH`, as how many are met is
    chance.
    """

    limb: str
    conditions: tuple[LimbCondition, ...]
    members: int
    unexplained: int = 0

    def to_json(self) -> dict[str, object]:
        return {
            "limb": self.limb,
            "conditions": [c.to_json() for c in self.conditions],
            "members": self.members,
            "unexplained": self.unexplained,
        }


def limb_singularities(family: Family, limbs: Sequence[LimbSpec]) -> tuple[LimbSingularity, ...]:
    """Of all limbs. Of limbs that are alike but for the numbers in their names the first is searched, and the others
    take its conditions with their own names.
    """
    found: list[LimbSingularity] = []
    known: dict[str, tuple[LimbSpec, LimbSingularity]] = {}
    for limb in limbs:
        key = _alike(family, limb)
        if key not in known:
            known[key] = limb, _of(family, limb)
        found.append(_renamed(*known[key], limb))
    return tuple(found)


def _names(limb: LimbSpec) -> tuple[str, ...]:
    return tuple(dict.fromkeys(n for j in limb.joints for n in j.names))


def _alike(family: Family, limb: LimbSpec) -> str:
    """The same text for limbs that differ in names only: all names by their first place."""
    places: dict[str, str] = {}

    def place(match: re.Match[str]) -> str:
        return places.setdefault(match[0], f"<{len(places)}>")

    needed = upstream(family, _names(limb))
    texts = [f"{limb.shares}{limb.coupled}", *(f"{j.kind}{j.actuated}({j.args})" for j in limb.joints)]
    texts += [f"{d.name} {d.sort} {d.relation}" for d in family.definitions if d.name in needed]
    pattern = "|".join(sorted(map(re.escape, needed), key=len, reverse=True))
    return re.sub(rf"(?<=')(?:{pattern})(?=')|\b(?:{pattern})(?= (?:point|direction) )", place, "; ".join(texts))


def _renamed(first: LimbSpec, found: LimbSingularity, limb: LimbSpec) -> LimbSingularity:
    new = dict(zip(_names(first), _names(limb), strict=True))
    conditions = tuple(
        LimbCondition(_told(c.expression, new), _told(c.statement, new), c.types) for c in found.conditions
    )
    return LimbSingularity(limb.name, conditions, found.members, found.unexplained)


def _told(sentence: str, new: dict[str, str]) -> str:
    """A sentence with other names; in its words names stand alone or joined (A1B1)."""
    one = "|".join(sorted(map(re.escape, new), key=len, reverse=True))
    return re.sub(rf"\b(?:{one})+(?![\w'])", lambda m: re.sub(one, lambda n: new[n[0]], m[0]), sentence)


def _of(family: Family, limb: LimbSpec) -> LimbSingularity:
    found: dict[tuple[str, str], set[str]] = {}
    met = unexplained = 0

    def twists(values: Values) -> tuple[Row, ...]:
        return tuple(limb.at(values, RESIDUES).rows(RESIDUES))

    elsewhere = ranks(family, [limb], family.member("limb"))
    usual = elsewhere.limbs[0][0]
    rng = drawn("combinations")
    left = [[rng.randrange(PRIME) for _ in range(limb.freedoms)] for _ in range(usual)]
    width = 6 * len(limb.shares[0]) if limb.shares else 6
    right = [[rng.randrange(PRIME) for _ in range(width)] for _ in range(usual)]

    def determinant(values: Values) -> int:
        mixed = [RESIDUES.combination(numbers, twists(values)) for numbers in left]
        return int(RESIDUES.determinant([[RESIDUES.dot(row, numbers) for numbers in right] for row in mixed]))

    generic = {said for said, zero in _tried(family, limb, family.member("limb")) if zero}
    for _, path in zip(range(_PATHS), paths(family, _names(limb), "limb"), strict=False):
        try:
            polynomial = interpolated(lambda t, path=path: determinant(path.member(t)))  # type: ignore[misc]
        except GcrulesError:  # a joint is none on the way
            continue
        for t in roots(polynomial or []):
            values = path.member(t)
            if _imaginary(limb, values) or RESIDUES.rank(twists(values)) == usual:
                continue
            met += 1
            told = (said for said, zero in _tried(family, limb, values) if zero and said not in generic)
            first = next(told, None)
            if first is None:
                unexplained += 1
            else:
                here = {"RI", "RPM"}.intersection(types_of(ranks(family, [limb], values), elsewhere))
                found[first] = found.get(first, here) & here
    conditions = tuple(
        LimbCondition(*said, tuple(name for name in TYPES if name in found[said]))
        for said in dict.fromkeys(said for said, _ in _tried(family, limb, family.member("limb")))
        if said in found
    )
    return LimbSingularity(limb.name, conditions, min(ENOUGH, met), min(ENOUGH, unexplained))


def _terms(limb: LimbSpec) -> dict[str, Term]:
    """The limb's directions and the lines between neighbouring points, by their words."""
    terms = [d for j in limb.joints for d in j.directions]
    points = list(dict.fromkeys(p for j in limb.joints for p in j.points))
    one = {p: next(a for j in limb.joints for a in j.args if isinstance(a, tuple) and a[0][1] == p) for p in points}
    terms += [((one[b][0][0], b), (-one[a][0][0], a)) for a, b in pairwise(points)]
    return {name_of(t): t for t in terms}


def _tried(family: Family, limb: LimbSpec, values: Values) -> Iterator[tuple[tuple[str, str], bool]]:
    """Conditions in words, and whether they hold: flat brackets, right angles, directions parallel to one plane. Of a
    limb with bodies of its own those of each way through it.
    """
    if limb.subchains:
        for joints in limb.ways():
            yield from _tried(family, LimbSpec(limb.name, joints), values)
        return
    points = family.homogeneous(values)
    for four in combinations([n for n in _names(limb) if n in points], 4):
        flat = not RESIDUES.determinant([points[n] for n in four])
        yield (f"[{''.join(four)}]", _sentence(family, four)), flat
    vectors: dict[str, Vector] = {w: combined(t, values, RESIDUES) for w, t in _terms(limb).items()}
    for a, b in combinations(vectors, 2):
        yield ("", f"{a} is perpendicular to {b}"), RESIDUES.dot(vectors[a], vectors[b]) == 0
    crossed = {f"{a} × {b}": RESIDUES.cross(vectors[a], vectors[b]) for a, b in combinations(vectors, 2)}
    for three in combinations({**vectors, **crossed}.items(), 3):
        names, (u, v, w) = [n for n, _ in three], [x for _, x in three]
        flat = RESIDUES.dot(RESIDUES.cross(u, v), w) == 0
        yield ("", f"the directions {listed(names)} are parallel to one plane"), flat


def _imaginary(limb: LimbSpec, values: Values) -> bool:
    """Whether a direction has length zero, as residues may have and real directions have not."""
    vectors = [combined(t, values, RESIDUES) for t in _terms(limb).values()]
    for j in limb.joints:
        if j.kind == "U":
            u, v = (combined(t, values, RESIDUES) for t in j.directions)
            vectors.append(RESIDUES.cross(u, v))
    return any(RESIDUES.dot(v, v) == 0 for v in vectors)


def _sentence(family: Family, four: Sequence[str]) -> str:
    finite = [n for n in four if family.sorts[n] == "point"]
    directions = [n for n in four if n not in finite]
    match len(directions):
        case 0:
            return f"the points {listed(finite)} lie in one plane"
        case 1 if family.level(finite, directions[0]):
            return f"the points {listed(finite)} are on a line"
        case 1:
            return f"the plane {''.join(finite)} contains the direction {directions[0]}"
        case 2:
            return f"the line {''.join(finite)} is parallel to the plane of the directions {listed(directions)}"
    return f"the directions {listed(directions)} are parallel to one plane"
