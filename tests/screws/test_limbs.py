"""Joints, the wrenches of limbs, and robots made of them, against tables worked out by hand."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from screws.random_screws import (
    LIMBS,
    O,
    Random,
    X,
    Y,
    Z,
    add,
    cross,
    dot,
    fields,
    leg_of,
    span,
    sub,
    times,
    up,
    upu,
)

from gcrules.screws import (
    FLOATS,
    JOINTS,
    Field,
    Limb,
    ScrewSystem,
    jacobian,
    joint,
    limb,
    mobility,
    product,
    revolute,
)

Vec = tuple[Any, ...]


# --- joints ---------------------------------------------------------------------------------------------------------

EXAMPLES: dict[str, tuple[dict[str, Any], list[Any]]] = {
    "R": ({"point": (1, 2, 3), "axis": Z}, [(0, 0, 1, 2, -1, 0)]),
    "P": ({"direction": (1, 2, 3)}, [(0, 0, 0, 1, 2, 3)]),
    "H": ({"point": X, "axis": Z, "pitch": Fraction(1, 2)}, [(0, 0, 1, 0, -1, Fraction(1, 2))]),
    "C": ({"point": X, "axis": Z}, [(0, 0, 1, 0, -1, 0), (0, 0, 0, 0, 0, 1)]),
    "U": ({"point": X, "first": Z, "second": Y}, [(0, 0, 1, 0, -1, 0), (0, 1, 0, 0, 0, 1)]),
    "S": ({"point": X}, [(1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 1), (0, 0, 1, 0, -1, 0)]),
    "E": ({"point": X, "normal": Z}, [(0, 0, 0, 1, 0, 0), (0, 0, 0, 0, 1, 0), (0, 0, 1, 0, -1, 0)]),
    "Pa": ({"bars": X, "axis": Z}, [(0, 0, 0, 0, 1, 0)]),
    "4S": (
        {"first": O, "second": Y, "bars": X},
        [(0, 0, 0, 0, 1, 0), (0, 0, 0, 0, 0, 1), (1, 0, 0, 0, 0, 0), (0, 1, 0, 0, 0, 0)],
    ),
}


@fields
@pytest.mark.parametrize("kind", JOINTS)
def test_twists_of_joints(kind: str, field: Field) -> None:
    geometry, expected = EXAMPLES[kind]
    made = joint(kind, **geometry)
    assert made.freedoms == len(made.kind.freedoms) == len(made.twists(field)) == len(expected)
    assert limb(made).system(field).dimension == len(expected)
    assert limb(made).system(field).same(span(expected, field))
    floats = joint(kind, **{k: np.array(v, dtype=float) for k, v in geometry.items()})
    assert floats.field == FLOATS
    assert limb(floats).system().same(span(expected, FLOATS))


def test_every_kind_of_joint_has_an_example() -> None:
    assert EXAMPLES.keys() == JOINTS.keys()


# The same motion, made of hinges and sliders.
@pytest.mark.parametrize("seed", range(5))
def test_joints_made_of_hinges_and_sliders(seed: int) -> None:
    r = Random(seed)
    p, (u, v, w) = r.vector(), r.vectors(3)
    same = [
        (joint("C", point=p, axis=u), [joint("P", direction=u), joint("R", point=add(p, u), axis=u)]),
        (joint("U", point=p, first=u, second=v), [joint("R", point=p, axis=u), joint("R", point=p, axis=v)]),
        (joint("S", point=p), [joint("R", point=p, axis=a) for a in (u, v, w)]),
        (joint("E", point=p, normal=u), [joint("R", point=q, axis=u) for q in (p, add(p, v), add(p, w))]),
        (joint("H", point=p, axis=u, pitch=0), [joint("R", point=p, axis=u)]),
        (joint("Pa", bars=u, axis=v), [joint("P", direction=cross(u, v))]),
    ]
    for one, others in same:
        assert limb(one).system() == limb(*others).system(), one
    rods = [ScrewSystem.span([revolute(q, u)]) for q in (p, add(p, v))]
    assert limb(joint("4S", first=p, second=add(p, v), bars=u)).system() == (rods[0] | rods[1]).reciprocal()


# --- the wrenches of limbs ------------------------------------------------------------------------------------------

Lines = tuple[Limb, list[Any], str]


@fields
@pytest.mark.parametrize("name", LIMBS)
def test_wrenches_of_limbs(name: str, field: Field) -> None:
    for seed in range(6):
        leg, lines, kind = LIMBS[name](Random((name, seed)))
        found = leg.locked_system(field)
        assert found.dimension == len(lines) == field.height(leg.locked(field))
        assert found.same(span(lines, field))
        assert found.classify().kind == kind
        assert found.classify().spanned_by_lines
        assert leg.constraint_system(field).dimension == 6 - leg.rank(field) == len(lines) - len(leg.actuated)
        # Actuations: product 1 with their own twist, 0 with all others; with the constraints they span the wrenches.
        rows = [*field.rows(leg.actuations(field)), *field.rows(leg.constraints(field))]
        assert span(rows, field).same(found)
        own = [field.row(leg.twists(field), i) for i in range(leg.freedoms)]
        for place, row in zip(leg.actuated, rows, strict=False):
            assert [product(row, t, field) for t in own] == pytest.approx([int(i == place) for i in range(len(own))])


@pytest.mark.parametrize("name", LIMBS)
def test_actuations_in_floats_are_the_exact_ones(name: str) -> None:
    leg, _, _ = LIMBS[name](Random(name))
    assert np.allclose(np.array(leg.actuations(), dtype=float).reshape(-1, 6), leg.actuations(FLOATS).reshape(-1, 6))


def test_actuations_are_orthogonal_to_constraints() -> None:
    leg, _, _ = upu(Random(3))
    (row,) = leg.actuations()
    assert [dot(row, c) for c in leg.constraints()] == [0]


def delta(r: Random) -> list[Limb]:
    limbs = []
    for _ in range(3):
        a, e, d = r.vector(), *r.vectors(2)
        arm = joint("R", point=r.vector(), axis=e, actuated=True)
        limbs.append(limb(arm, joint("4S", first=a, second=add(a, e), bars=d)))
    return limbs


def schoenflies(r: Random) -> list[Limb]:
    limbs = []
    for _ in range(4):
        a, b, c, x = r.vector(), r.vector(), r.vector(), r.vectors(2)[0]
        first = joint("R", point=a, axis=Z, actuated=True)
        limbs.append(
            limb(first, joint("U", point=b, first=Z, second=x), joint("U", point=c, first=x, second=Z))
        )  # fmt: skip
    return limbs


def spherical(r: Random) -> list[Limb]:
    o = r.vector()
    legs = [[joint("R", point=o, axis=a, actuated=i == 0) for i, a in enumerate(r.vectors(3))] for _ in range(3)]
    return [limb(*leg) for leg in legs]


def planar(r: Random) -> list[Limb]:
    n = r.vector()
    legs = [[joint("R", point=r.vector(), axis=n, actuated=i == 0) for i in range(3)] for _ in range(3)]
    return [limb(*leg) for leg in legs]


def exechon(r: Random) -> list[Limb]:
    v = (0, r.nonzero(), r.nonzero())
    legs = []
    for a in ((-1, 0, 0), (1, 0, 0)):
        b = add(times(r.nonzero(), cross(X, v)), (r.scalar(), 0, 0))
        legs.append(limb(joint("U", point=a, first=X, second=v), joint("P", direction=sub(b, a), actuated=True),
                         joint("R", point=b, axis=v)))  # fmt: skip
    a, b = r.vector(), r.vector()
    third = limb(joint("S", point=a), joint("P", direction=sub(b, a), actuated=True), joint("R", point=b, axis=X))
    return [*legs, third]


def four_dof(r: Random) -> list[Limb]:
    """PS, UPS, PRPS: the robot of SinguLab2008."""
    one = limb(joint("P", direction=r.vector(), actuated=True), joint("S", point=r.vector()))
    a, s = r.vector(), r.vector()
    three = limb(
        joint("P", direction=r.vector(), actuated=True),
        joint("R", point=a, axis=r.vector()),
        joint("P", direction=sub(s, a), actuated=True),
        joint("S", point=s),
    )
    return [one, leg_of("UPS", r), three]


def sarrus(r: Random) -> list[Limb]:
    legs = [limb(*(joint("R", point=r.vector(), axis=e, actuated=i == 0) for i in range(3))) for e in r.vectors(2)]
    return [legs[0], limb(*(joint("R", **j.geometry) for j in legs[1].joints))]


def serial(r: Random) -> list[Limb]:
    return [limb(*(joint("R", point=r.vector(), axis=r.vector(), actuated=True) for _ in range(5)))]


# limbs, freedom of the platform, over-constraints, idle freedoms
ROBOTS: dict[str, tuple[Callable[[Random], list[Limb]], int, int, int]] = {
    "6-UPS": (lambda r: [leg_of("UPS", r) for _ in range(6)], 6, 0, 0),
    "6-SPS": (lambda r: [leg_of("SPS", r) for _ in range(6)], 6, 0, 6),
    "3-RPS": (lambda r: [leg_of("RPS", r) for _ in range(3)], 3, 0, 0),
    "3-UPU": (lambda r: [upu(r)[0] for _ in range(3)], 3, 0, 0),
    "Delta": (delta, 3, 0, 0),
    "4-RUU": (schoenflies, 4, 2, 0),
    "3-RRR spherical": (spherical, 3, 6, 0),
    "3-RRR planar": (planar, 3, 6, 0),
    "Tricept": (lambda r: [up(r)[0], *(leg_of("UPS", r) for _ in range(3))], 3, 0, 0),
    "Exechon": (exechon, 3, 2, 0),
    "PS, UPS, PRPS": (four_dof, 4, 0, 0),
    "Sarrus": (sarrus, 1, 1, 0),
    "serial arm": (serial, 5, 0, 0),
}


@fields
@pytest.mark.parametrize("name", ROBOTS)
def test_mobility_of_robots(name: str, field: Field) -> None:
    make, freedom, overconstraints, idle = ROBOTS[name]
    for seed in range(3):
        limbs = make(Random((name, seed)))
        found = mobility(limbs, field)
        assert (found.freedom, found.overconstraints, found.idle) == (freedom, overconstraints, idle)
        assert found.grubler + found.overconstraints == found.freedom + found.idle
        assert found.regular
        assert found.actuators == found.freedom
        assert found.free.dimension == 0
        together = limbs[0].system(field)
        for other in limbs[1:]:
            together &= other.system(field)
        assert found.twists.same(together)
        # The Jacobian: rates of the actuators for a motion of the platform, and nothing for the constraints.
        j = jacobian(limbs, field)
        assert j.rank() == 6
        assert len(j.labels) == found.actuators + sum(6 - rank for rank in found.ranks)
        for twist in found.twists.basis:
            rates = [product(row, twist, field) for row in field.rows(j.matrix)]
            assert rates[found.actuators :] == pytest.approx([0] * (len(rates) - found.actuators), abs=1e-9)
            assert any(rates[: found.actuators])
        if len(j.labels) == 6:
            assert j.determinant() != 0


def test_three_tetrahedra_of_the_robot_with_four_freedoms() -> None:
    """The wrenches with locked actuators are those of DESIGN: bundle, force, planar pencil."""
    one, two, three = four_dof(Random(5))
    kinds = [leg.locked_system().classify().kind for leg in (one, two, three)]
    assert kinds == ["bundle", "force", "planar pencil"]
    s = three.joints[-1].geometry["point"]
    a, e = (three.joints[1].geometry[part] for part in ("point", "axis"))
    assert three.locked_system() == ScrewSystem.span([revolute(s, sub(s, a)), revolute(s, e)])


@pytest.mark.parametrize("name", ["6-UPS", "Tricept"])
def test_singular_when_locked(name: str) -> None:
    """All platform joints in the plane of the base: the locked robot can still move."""
    r = Random(name)
    flat = [(*r.vector()[:2], 0) for _ in range(12)]
    number = {"6-UPS": 6, "Tricept": 3}[name]
    limbs = [leg_of("UPS", r, base=flat[2 * i], top=flat[2 * i + 1]) for i in range(number)]
    if name == "Tricept":
        limbs.append(limb(joint("U", point=O, first=X, second=Y), joint("P", direction=X)))
    found = mobility(limbs)
    assert not found.regular
    assert found.free.dimension == 6 - jacobian(limbs).rank() > 0
    assert jacobian(limbs, FLOATS).rank() == jacobian(limbs).rank()
