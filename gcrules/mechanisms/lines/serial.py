r"""Singularities of the limbs themselves: where a limb's own twists depend on each other.

For a limb of rank r a determinant of r random combinations of its twists, in r random coordinates, is a polynomial
along a path of members. Where the limb loses rank it vanishes; so its roots, exact members modulo the prime, are tried,
and those with less rank show which simple conditions on the limb's points and directions hold. What is lost on sets of
codimension two or more is not met.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations, pairwise

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import GcrulesError
from gcrules.core.seeds import drawn
from gcrules.mechanisms.conditions.factor_causes import ENOUGH, paths, upstream
from gcrules.mechanisms.description.family import Family
from gcrules.mechanisms.description.limb_file import LimbSpec
from gcrules.mechanisms.description.relations import Term, Values, Vector, combined, name_of
from gcrules.mechanisms.lines.ranks import TYPES, ranks, types_of
from gcrules.mechanisms.lines.singular import PRIME, Mixing, interpolated, roots
from gcrules.screws import RESIDUES
from gcrules.screws.field import Row

__all__ = ["LimbSingularity", "limb_singularities"]

_PATHS = 24
_Said = tuple[str, str]  # an expression or "", and a sentence


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
    mixing = Mixing(drawn("combinations"), twists(family.member("limb")), usual)

    every = _conditions(family, limb)
    special = _without_those_that_hold(every, family.member("limb"))
    for _, path in zip(range(_PATHS), paths(family, _names(limb), "limb"), strict=False):
        try:
            polynomial = interpolated(mixing.along(lambda t, path=path: twists(path.member(t))))  # type: ignore[misc]
        except GcrulesError:  # a joint is none on the way
            continue
        for t in roots(polynomial or []):
            values = path.member(t)
            if _imaginary(limb, values) or RESIDUES.rank(twists(values)) == usual:
                continue
            met += 1
            first = next(_that_hold(special, values), None)
            if first is None:
                unexplained += 1
            else:
                here = {"RI", "RPM"}.intersection(types_of(ranks(family, [limb], values), elsewhere))
                found[first] = found.get(first, here) & here
    conditions = tuple(
        LimbCondition(*said, tuple(name for name in TYPES if name in found[said]))
        for said in dict.fromkeys(said for one in every for said, _ in one.tests)
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


@dataclass(frozen=True)
class _Conditions:
    """Conditions of one way through a limb, in words, each with what it is tested on: four points or directions, or
    two or three of the `terms` and of their products, by their words.
    """

    family: Family
    terms: dict[str, Term]
    tests: tuple[tuple[_Said, tuple[str, ...]], ...]

    def hold(self, values: Values) -> Iterator[_Said]:
        """Those that hold at a member, in their order."""
        points = self.family.homogeneous(values)
        vectors: dict[str, Vector] = {w: combined(t, values, RESIDUES) for w, t in self.terms.items()}
        crossed = {f"{a} × {b}": RESIDUES.cross(vectors[a], vectors[b]) for a, b in combinations(vectors, 2)}
        every, before, normal = {**vectors, **crossed}, ("", ""), (0, 0, 0)
        for said, names in self.tests:
            if len(names) == 3:
                a, b, c = names
                if (a, b) != before:
                    before, normal = (a, b), RESIDUES.cross(every[a], every[b])
                (u, v, w), (x, y, z) = normal, every[c]
                zero = (u * x + v * y + w * z) % PRIME == 0
            elif len(names) == 2:
                a, b = names
                zero = RESIDUES.dot(vectors[a], vectors[b]) == 0
            else:
                zero = not RESIDUES.determinant([points[n] for n in names])
            if zero:
                yield said


def _conditions(family: Family, limb: LimbSpec) -> tuple[_Conditions, ...]:
    """Conditions that may explain a singularity: flat brackets, right angles, directions parallel to one plane. Of a
    limb with bodies of its own those of each way through it, each of them once.
    """
    seen: set[_Said] = set()
    ways = [LimbSpec(limb.name, joints) for joints in limb.ways()] if limb.subchains else [limb]
    found = []
    for way in ways:
        terms = _terms(way)
        tests = {said: names for said, names in _tests(family, way, terms) if said not in seen}
        seen.update(tests)
        found.append(_Conditions(family, terms, tuple(tests.items())))
    return tuple(found)


def _tests(family: Family, limb: LimbSpec, terms: Iterable[str]) -> Iterator[tuple[_Said, tuple[str, ...]]]:
    for four in combinations([n for n in _names(limb) if n in family.sorts], 4):
        yield (f"[{''.join(four)}]", _sentence(family, four)), four
    pairs = list(combinations(terms, 2))
    for a, b in pairs:
        yield ("", f"{a} is perpendicular to {b}"), (a, b)
    for three in combinations([*terms, *(f"{a} × {b}" for a, b in pairs)], 3):
        yield ("", f"the directions {listed(three)} are parallel to one plane"), three


def _that_hold(conditions: Iterable[_Conditions], values: Values) -> Iterator[_Said]:
    """Those of all ways that hold at a member."""
    return (said for one in conditions for said in one.hold(values))


def _without_those_that_hold(conditions: Sequence[_Conditions], values: Values) -> list[_Conditions]:
    """What is left without those that hold at this member."""
    always = set(_that_hold(conditions, values))
    return [replace(one, tests=tuple(test for test in one.tests if test[0] not in always)) for one in conditions]


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
