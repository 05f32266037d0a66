"""Robots by an independent road: ranks and determinants of the joint screws of random members."""

from __future__ import annotations

import random
from collections.abc import Sequence
from typing import Any

import pytest
from mechanisms.bodies import chains, equations
from mechanisms.shipped_robots import AS_MANY, OTHERS, analysis, robot, singular_members
from places import DATA

from gcrules.algebra.evaluate import PRIME, Evaluator
from gcrules.core.errors import GcrulesError
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.relations import Values
from gcrules.screws import RESIDUES

IDS = tuple(one.id for one in robots())
FILES = DATA / "robots"
ROAD = (*AS_MANY, *OTHERS)
MEMBERS = 200
PATHS = 9
Row = tuple[Any, ...]


# --- the independent road: ranks and determinants of the joint screws ------------------------------------------------


def locked(name: str, values: Values) -> list[Row]:
    """All wrenches with the actuators locked, of the joint screws alone; in the plane with those that keep it there."""
    r = robot(name)
    rows = [row for limb in r.limbs for row in limb.at(values, RESIDUES).locked(RESIDUES)]
    return [*rows, *((0,) * i + (1,) + (0,) * (5 - i) for i in ((2, 3, 4) if r.family.plane else ()))]


def passive_ranks(name: str, values: Values) -> list[int]:
    """Of each chain between two bodies."""
    return [6 - len(chain.locked(RESIDUES)) for *_, chain in chains(robot(name), values, RESIDUES)]


def at(name: str, values: Values) -> Evaluator:
    a = analysis(name)
    points = a.structure.points(robot(name).family, values)
    if robot(name).family.plane:
        points = {n: (p[0], p[1], p[3]) for n, p in points.items()}
    return Evaluator(points, 3 if robot(name).family.plane else 4, PRIME)


def of_the_condition(name: str, values: Values) -> tuple[int, int]:
    """cofactor and coefficient · expression at a member."""
    c = analysis(name).condition
    assert c is not None
    value = at(name, values).value
    return value(c.cofactor)[0], c.coefficient * value(c.expression)[0] % PRIME


def excepted(name: str, values: Values) -> bool:
    """Whether a cofactor of the six lines that were chosen vanishes at a member: they depend, the robot's need not.

    One that has no expression in points vanishes where points coincide (exechon: A1 and A2), or where factors of the
    condition do that are said to come from the choice of lines.
    """
    a = analysis(name)
    if a.common and a.common.chosen.cofactor is None:
        chosen = [p.expression for p in a.parts if p.kind == "choice"]
        assert chosen or "coincide" in a.common.chosen.statement
        if robot(name).family.merged(values) or any(not at(name, values).value(e)[0] for e in chosen):
            return True
    points = a.structure.points(robot(name).family, values)
    for limb, own in zip(robot(name).limbs, a.structure.limbs, strict=True):
        rows = [line.row(points) for line in own.lines or ()]
        if RESIDUES.rank(rows) < min(len(rows), len(limb.at(values, RESIDUES).locked(RESIDUES))):
            return True  # lines that were chosen for one limb depend on each other, its wrenches do not
    return any(not at(name, values).value(c)[0] for c in a.cofactors)


def isotropic(name: str, values: Values) -> bool:
    """Whether a direction is perpendicular to itself, which happens modulo a prime only: v × w may be along v there."""
    directions = (values[d.name] for d in robot(name).family.definitions if d.sort == "direction")
    return any(not RESIDUES.dot(d, d) for d in directions)


def jacobian_determinant(name: str, values: Values) -> int:
    """det of the bases of the limbs' wrench systems (from the screws), times for each limb the determinant that leads
    from this basis to the lines: the reduced echelon form shows it in its columns of leading ones.
    """
    a, r = analysis(name), robot(name)
    points = a.structure.points(r.family, values)
    rows: list[Row] = []
    change = 1
    for limb in r.limbs:
        screws: Any = limb.at(values, RESIDUES).locked(RESIDUES)
        if r.family.plane:
            screws = [[row[0], row[1], row[5]] for row in RESIDUES.basis(screws)]
        basis, pivots = planar_part(limb, values) if r.family.plane else RESIDUES.echelon(screws)
        lines = [line.row(points) for line in a.structure.lines or () if line.limb == limb.name]
        assert len(lines) == len(basis)
        change = change * RESIDUES.determinant([[line[p] for p in pivots] for line in lines]) % PRIME
        rows += basis
    if r.family.plane:
        rows = [(row[0], row[1], row[5]) for row in rows]
    return int(RESIDUES.determinant(rows)) * change % PRIME


def planar_part(limb: Any, values: Values) -> tuple[Sequence[Row], tuple[int, ...]]:
    """The wrench in the plane of a planar limb with one actuator."""
    screws = limb.at(values, RESIDUES).locked(RESIDUES)
    flat = [(row[0], row[1], 0, 0, 0, row[5]) for row in screws]
    return RESIDUES.echelon(flat)


@pytest.mark.parametrize("name", ROAD)
def test_joint_screws_against_the_condition(name: str) -> None:
    a, r = analysis(name), robot(name)
    exact = not a.structure.over
    ratios = set()
    for seed in range(MEMBERS if name in IDS else MEMBERS // 5):
        values = r.family.member(("road", seed))
        cofactor, right = of_the_condition(name, values)
        assert cofactor
        assert right
        if exact:
            ratios.add(jacobian_determinant(name, values) * cofactor * pow(right, -1, PRIME) % PRIME)
        else:
            every = locked(name, values)
            assert RESIDUES.rank(every) == 6
            points = a.structure.points(r.family, values)
            assert RESIDUES.rank([*every, *(line.row(points) for line in a.structure.lines or ())]) == 6
            assert RESIDUES.rank([line.row(points) for line in a.structure.lines or ()]) == 6
    assert not exact or ratios in ({1}, {PRIME - 1})


def stacked(name: str, values: Values) -> int:
    """A determinant that vanishes where the platform can move with locked actuators, and where passive twists depend.

    Unknown are the twists of all bodies and the rates of all passive freedoms. Where there are more equations than
    unknowns, fixed random combinations of them are taken.
    """
    every, driven, _ = equations(robot(name), values, RESIDUES)
    rows = [[c for k, c in enumerate(row) if k not in driven] for row in every]
    size = len(rows[0])
    if len(rows) > size:
        rng = random.Random("combinations")
        mixed = [[rng.randrange(PRIME) for _ in rows] for _ in range(size)]
        rows = [[sum(m * row[c] for m, row in zip(ms, rows, strict=True)) % PRIME for c in range(size)] for ms in mixed]
    return int(RESIDUES.determinant(rows))


@pytest.mark.parametrize("name", ROAD)
def test_rank_drops_where_claimed_and_nowhere_else(name: str) -> None:
    """Members at which a cofactor vanishes, of the condition or of the lines that were chosen, are excepted."""
    r = robot(name)
    full = 6
    usual = passive_ranks(name, r.family.member("usual"))
    seen = 0

    def both(values: Values) -> None:
        nonlocal seen
        try:
            lost = RESIDUES.rank(locked(name, values)) < full
            here = passive_ranks(name, values)
        except GcrulesError:  # a joint is none there
            return
        cofactor, right = of_the_condition(name, values)
        if here != usual or not cofactor or excepted(name, values) or isotropic(name, values):
            return
        assert lost == (right == 0)
        seen += lost

    for values in singular_members(name, lambda v: stacked(name, v), PATHS, "screws"):
        both(values)
    for values in singular_members(name, lambda v: of_the_condition(name, v)[1], PATHS, "lines"):
        both(values)
    assert seen >= 2


@pytest.mark.parametrize("name", ROAD)
def test_factors_vanish_where_they_say(name: str) -> None:
    """Where a factor vanishes rank drops, that of the constraints where it says so; one that never does has no root."""
    a, r = analysis(name), robot(name)
    usual = passive_ranks(name, r.family.member("usual"))
    for part in a.parts:
        value = lambda v, part=part: at(name, v).value(part.expression)[0]  # noqa: E731
        found = list(singular_members(name, value, 3, part.kind))
        if part.kind == "never":
            assert not found
            continue
        for values in found[:4]:
            try:
                held = [row for limb in r.limbs for row in limb.at(values, RESIDUES).constraints(RESIDUES)]
                here = passive_ranks(name, values)
            except GcrulesError:
                continue
            if here != usual or r.family.merged(values) or excepted(name, values):
                continue
            lost = 6 - a.structure.mobility - (RESIDUES.rank(held) if held else 0)
            assert part.kind == "mixed" or (lost > 0) == (part.kind == "constraint")
            assert RESIDUES.rank(locked(name, values)) < 6
