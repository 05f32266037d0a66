"""Operation modes: what is known of robots, the limbs' equations against their joints, and where modes meet."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from places import EXAMPLES

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.core.errors import InputError, LimitReached
from gcrules.core.linear_algebra import echelon, rank
from gcrules.poses.operation_modes.limb_constraints import STUDY, gradient, limb_constraints, value
from gcrules.poses.operation_modes.orientations import forms_ring, pieces
from gcrules.poses.operation_modes.report import OperationModes
from gcrules.poses.operation_modes.study import coupled, motions, pose

SCHOENFLIES = "Schönflies motion with the direction z"
OUR_OWN = str(EXAMPLES / "published")

MOTIONS: dict[str, tuple[str, ...]] = {
    "delta": ("pure translations",),
    "orthoglide": ("pure translations",),
    "3-crr": ("pure translations",),
    "3-rrr": ("planar motion at right angles to z",),
    "3-ups-s": ("pure turns about the point (0, 0, 3)",),
    "agile-eye": ("pure turns about the point (0, 0, 0)",),
    "4-upu": (SCHOENFLIES, f"{SCHOENFLIES}, the platform upside down"),
    "quadrupteron": (SCHOENFLIES,),
    "3-uru": ("pure translations", "general motion: all orientations; each fixes the shift"),
    "tricept": (
        "turns that keep the platform's direction y at right angles to x, and shifts of one freedom in each of them",
    ),
    "5-rpur": (
        "turns that keep the platform's direction x at right angles to z, and shifts of three freedoms in each of them",
    ),
    "exechon": (
        "turns that keep the platform's direction y at right angles to x, and shifts of one freedom in each of them",
    ),
    "gough-stewart": ("general motion: all orientations, and shifts of three freedoms in each of them",),
}
"""Robots whose limbs have whole equations, and the motions of their modes, derived by hand from the joints."""


@pytest.mark.parametrize("name", MOTIONS)
def test_modes_of_shipped_robots(name: str) -> None:
    found = gc.operation_modes(name)
    assert tuple(m.motion for m in found.modes) == MOTIONS[name]
    assert found.whole
    assert found.proved
    assert found.complete
    assert found.assemblies.closed > 20
    assert all(m.enough for m in found.modes)
    assert found.modes[0].home
    assert not any(m.home for m in found.modes[1:])
    assert all(m.dimension == m.turning + m.shifting == gc.load(name).mobility for m in found.modes[:1])


def test_the_snu_robot_has_seven_real_modes_of_three_freedoms() -> None:
    """Translations, planar and spherical motions among them; home, where the robot is singular, is in two of them."""
    found = gc.operation_modes(f"{OUR_OWN}/snu-3-upu.yaml")
    kinds = Counter(m.motion.split(" about")[0].split(" at")[0] for m in found.modes)
    assert kinds == {
        "pure translations": 1,
        "pure translations after a half-turn": 1,
        "planar motion": 2,
        "pure turns": 1,
        "turns": 1,
        "half-turns": 1,
    }
    assert [m.dimension for m in found.modes] == [3] * 7
    assert sum(bool(m.home) for m in found.modes) == 2
    assert found.proved
    assert found.complete
    _meets_are_singular(found)


def test_equilateral_triangles_give_the_3_rps_two_modes() -> None:
    """x0 = 0, and x n = 0 with the normal n of the triangles: x3 = 0 in a frame whose third axis is n."""
    found = gc.operation_modes(f"{OUR_OWN}/equilateral-3-rps.yaml")
    first, second = found.modes
    normal = {(0, 1, 0, 0): 1, (0, 0, 1, 0): 1, (0, 0, 0, 1): 1}
    assert (dict(first.equations[0][4]), dict(second.equations[0][4])) == (normal, {(1, 0, 0, 0): 1})
    assert (first.home, second.home) == (True, False)
    assert found.proved
    assert found.complete
    _meets_are_singular(found)


def test_other_triangles_give_it_one() -> None:
    (mode,) = gc.operation_modes("3-rps").modes
    seven = {(1, 0, 0, 1): Fraction(1), (0, 1, 1, 0): Fraction(-1, 7)}
    assert dict(mode.equations[0][4]) == seven
    assert mode.irreducible


def test_tangential_axes_give_the_3_upu_five() -> None:
    found = gc.operation_modes(f"{OUR_OWN}/tsai-3-upu.yaml")
    assert [m.dimension for m in found.modes] == [3] * 5
    assert found.proved
    assert found.complete
    assert sum(bool(m.home) for m in found.modes) == 1
    _meets_are_singular(found)


def _meets_are_singular(found: OperationModes) -> None:
    """Where two modes meet the limbs' equations depend on each other, and all equations of both modes hold."""
    modes = {m.number: m for m in found.modes}
    equations = [STUDY, *(e for limb in found.limbs for e in limb.equations)]
    met = [t for t in found.transitions if t.meet]
    assert met
    for t in met:
        assert t.witness is not None
        every = [*equations, *(e for n in t.modes for e in modes[n].equations)]
        assert not any(value(e, t.witness) for e in every)
        assert any(t.witness[:4])
        tangent = 7 - rank([gradient(e, t.witness) for e in equations])
        assert tangent > max(modes[n].dimension for n in t.modes)


@pytest.mark.parametrize("name", ["3-cpu", "3-upu", "exechon", "4-upu", "2-upr-rpu"])
def test_witnesses_are_poses_that_the_limbs_allow(name: str) -> None:
    found = gc.operation_modes(name)
    for m in found.modes:
        assert m.witness is not None
        assert any(m.witness[:4])
        every = [STUDY, *m.equations, *(e for limb in found.limbs for e in limb.equations)]
        assert not any(value(e, m.witness) for e in every)
        assert (m.witness == (1, *[0] * 7)) == bool(m.home)


def test_eight_orientations_of_the_3_cpu() -> None:
    """Three quadrics in the space of orientations meet in eight points, as Bézout counts them."""
    found = gc.operation_modes("3-cpu")
    assert len(found.modes) == 8
    assert all((m.turning, m.shifting) == (0, 3) for m in found.modes)
    assert {t.meet for t in found.transitions} == {False}


def test_parts_of_limbs_say_that_they_are_parts() -> None:
    ruu, puu = gc.operation_modes("4-ruu"), gc.operation_modes("3-puu")
    assert [m.motion for m in ruu.modes] == [SCHOENFLIES, f"{SCHOENFLIES}, the platform upside down"]
    assert (ruu.whole, ruu.complete, ruu.modes[0].proper, ruu.modes[1].proper) == (False, False, True, False)
    assert (puu.whole, puu.complete, puu.modes[0].motion) == (False, False, "pure translations")
    said = [" ".join(one.text().split()) for one in (ruu, puu)]
    assert "there may be further modes" in said[0]
    assert all("so the list is not complete" in words for words in said)


SMALL = 11
"""A prime modulo which -1 and -3 are no squares, so that zeros of sums of squares are as few as among real numbers."""


@pytest.mark.parametrize("name", ["3-cpu", "4-upu", "exechon", "2-upr-rpu", f"{OUR_OWN}/snu-3-upu.yaml"])
def test_all_poses_modulo_a_small_prime_are_in_modes(name: str) -> None:
    """Brute force: every orientation modulo the prime, and every shift that the limbs' equations leave there."""
    found = gc.operation_modes(name)
    equations = [STUDY, *(e for limb in found.limbs for e in limb.equations)]
    modes = [m.equations for m in found.modes]
    met: Counter[int] = Counter()
    for x in product(range(SMALL), repeat=4):
        if next((c for c in x if c), None) != 1:
            continue
        rows = [_residues(e, x) for e in equations]
        solved, pivots = echelon(rows, SMALL)
        if 4 in pivots:
            continue
        free = [n for n in range(4) if n not in pivots]
        own_rows = [[_residues(e, x) for e in own] for own in modes]
        for amounts in product(range(SMALL), repeat=len(free)):
            y = dict(zip(free, amounts, strict=True))
            for row, column in zip(solved, pivots, strict=True):
                y[column] = -(row[4] + sum(row[n] * y[n] for n in free)) % SMALL
            at = (*(y[n] for n in range(4)), 1)
            inside = [n for n, own in enumerate(own_rows) if not any(_dot(row, at) % SMALL for row in own)]
            assert inside, (x, at)
            met.update(inside)
    assert met.keys() == set(range(len(modes)))


def _residues(equation: Any, x: tuple[int, ...]) -> list[int]:
    found = []
    for form in equation:
        total = 0
        for e, c in form.items():
            term = c.numerator * pow(c.denominator, -1, SMALL)
            for base, n in zip(x, e, strict=True):
                term *= base**n
            total += term
        found.append(total % SMALL)
    return found


def _dot(a: Sequence[int], b: Sequence[int]) -> int:
    return sum(p * q for p, q in zip(a, b, strict=True))


LIMBS = ["3-rps", "3-upu", "tricept", "exechon", "delta", "orthoglide", "gallardo-4dof", "3-crr"]


@pytest.mark.parametrize("name", LIMBS)
def test_equations_hold_at_poses_of_the_limb(name: str) -> None:
    robot: Any = gc.load(name)
    for limb in robot.limbs[:2]:
        moves = motions(limb, robot.values_at())
        found = limb_constraints(limb.name, moves)
        assert found.enough
        for k in range(1, 4):
            at = pose(moves, [Fraction(n + k, 2 + n * k) for n in range(1 + max(m.place for m in moves))])
            assert not any(value(e, at) for e in (STUDY, *found.equations))


def test_the_3_rps_keeps_its_balls_in_planes() -> None:
    """Its one equation is the plane of the leg, (R S + t - A) r = 0 times |x|², up to a factor and Study's own."""
    robot: Any = gc.load("3-rps")
    at, limb = robot.values_at(), robot.limbs[0]
    (equation,) = limb_constraints(limb.name, motions(limb, at)).equations
    assert not value(equation, (1, 0, 0, 0, 0, 0, 0, 0))
    S, r, A = (at[n] for n in ("S1", "r1", "A1"))
    for t in ((1, 0, 0), (0, 2, 0), (3, 0, 5), (1, 1, 1)):
        inside = sum((s + d - a) * n for s, d, a, n in zip(S, t, A, r, strict=True)) == 0
        assert (value(equation, (1, 0, 0, 0, 0, *(Fraction(d, 2) for d in t))) == 0) == inside


def test_coupled_turns_keep_or_reverse_a_direction() -> None:
    robot: Any = gc.load("4-ruu")
    moves = motions(robot.limbs[0], robot.values_at())
    dimensions = [limb_constraints("leg", own).dimension for own in coupled(moves)]
    assert dimensions.count(4) >= 2


def test_sums_of_squares_have_few_real_zeros() -> None:
    x0, x1, x2, x3 = forms_ring().gens
    assert {p.text for p in pieces([(x1**2 + 2 * x2**2) * x3])} == {"x3 = 0", "x1 = 0, x2 = 0"}
    assert pieces([x0**2 + x1**2 + x2**2 + x3**2]) == []
    assert [p.dimension for p in pieces([x0 * x1 - x2 * x3])] == [2]


@pytest.mark.parametrize(
    ("source", "kind", "words"),
    [
        ("h4", InputError, "bodies of its own"),
        ("gantry-tau", InputError, "bodies of its own"),
        ("capaman", LimitReached, "no equations linear in y0"),
        ("ab af cb cd ed ef", InputError, "robots of joints"),
    ],
)
def test_what_is_not_taken_apart_is_refused(source: str, kind: type[gc.GcrulesError], words: str) -> None:
    with pytest.raises(kind, match=words) as fault:
        gc.operation_modes(source)
    assert fault.value.hint


def test_the_command() -> None:
    runner = CliRunner()
    text = runner.invoke(cli, ["modes", "delta", "--operation"])
    assert text.exit_code == 0
    assert "pure translations; dimension 3" in text.output
    found = json.loads(runner.invoke(cli, ["modes", "4-upu", "--operation", "--json"]).output)
    assert (found["schema"], found["complete"], [m["dimension"] for m in found["modes"]]) == (1, True, [4, 4])
    assert found["modes"][1]["witness"] == ["0", "1", "0", "0", "0", "0", "0", "0"]
    latex = runner.invoke(cli, ["modes", "4-upu", "--operation", "--latex"])
    assert latex.exit_code == 0
    assert "$x_1 = 0$" in latex.output
    assert 'Sch\\"{o}nflies' in latex.output
    assert runner.invoke(cli, ["modes", "h4", "--operation"]).exit_code == 2
    assert runner.invoke(cli, ["modes", "capaman", "--operation"]).exit_code == 3


# --- coupled joints ------------------------------------------------------------------------------------------------

BARS = "joints: P*(d%) R(A%, e%) Pa(A% B%, n%) R(B%, e%)"
GEARS = """joints: P*(d%) R(A%, e%) R:near(A%, n%) R:far(B%, n%) R(B%, e%)
    couplings: far = {}"""


def test_hinges_geared_one_to_one_are_a_parallelogram(root: Path) -> None:
    text = (root / "plugins" / "orthoglide" / "robot.yaml").read_text(encoding="utf-8")
    geared = gc.operation_modes(gc.load(text.replace(BARS, GEARS.format("-near"))))
    barred = gc.operation_modes("orthoglide")
    assert [m.equations for m in geared.modes] == [m.equations for m in barred.modes]
    assert geared.assemblies.outside == 0
    assert geared.assemblies.closed > 30


def test_other_ratios_are_refused() -> None:
    arm = """
title: an arm whose second link turns twice as fast
space: plane
points: {A: free, B: free, C: free}
limbs: [{name: arm, joints: "R*:a(A, z) R:b(B, z)", couplings: "b = -2 a"}]
platform: C
mobility: 1
home: {A: [0, 0], B: [3, 4], C: [6, 0]}
"""
    with pytest.raises(gc.InputError, match="follows another joint by the ratio -2"):
        gc.operation_modes(gc.load(arm))
