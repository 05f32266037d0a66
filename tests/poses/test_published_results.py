"""The results of docs/validation.md by a second road: joints, rotations and determinants alone.

The page itself is run by tests/project/test_documents.py.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from random import Random

import numpy as np
import pytest
import sympy
import yaml
from places import EXAMPLES, ROOT

import gcrules as gc

PUBLISHED = EXAMPLES / "published"
F = Fraction
Point = tuple[Fraction, ...]


# --- the second road ------------------------------------------------------------------------------------------------


def joints(path: Path) -> tuple[list[tuple[str, str]], dict[str, Point]]:
    """Legs and points of a platform file, as they are written."""
    data = yaml.safe_load(path.read_text(encoding="utf-8"))
    return [(leg[0], leg[1]) for leg in data["legs"]], {
        n: tuple(map(F, map(str, p))) for n, p in data["points"].items()
    }


def cayley(c: Sequence[Fraction]) -> tuple[list[list[Fraction]], Fraction]:
    """n times the rotation with the Rodrigues parameters c, and n = 1 + |c|²."""
    x, y, z = c
    n = 1 + x * x + y * y + z * z
    return [
        [1 + x * x - y * y - z * z, 2 * (x * y - z), 2 * (x * z + y)],
        [2 * (x * y + z), 1 - x * x + y * y - z * z, 2 * (y * z - x)],
        [2 * (x * z - y), 2 * (y * z + x), 1 - x * x - y * y + z * z],
    ], n


def determinant(path: Path, shift: Sequence[Fraction], c: Sequence[Fraction]) -> Fraction:
    """The determinant of the six legs' lines, after a turn about the origin and a shift, by sympy's exact matrices."""
    legs, at = joints(path)
    turn, n = cayley(c)
    rows = []
    for a, b in legs:
        moved = [
            sum(r * p for r, p in zip(row, at[b], strict=True)) / n + s for row, s in zip(turn, shift, strict=True)
        ]
        along = [q - p for p, q in zip(at[a], moved, strict=True)]
        x, y, z = at[a]
        u, v, w = along
        rows.append([*along, y * w - z * v, z * u - x * w, x * v - y * u])
    return F(str(sympy.Matrix([[sympy.Rational(e.numerator, e.denominator) for e in row] for row in rows]).det()))


def degree(values: Callable[[Fraction], Fraction], most: int) -> int:
    """The degree of a polynomial whose degree is at most ``most + 2``, by differences."""
    row = [values(F(t)) for t in range(most + 4)]
    for d in range(most + 4):
        if not any(row):
            return d - 1
        row = [b - a for a, b in pairwise(row)]
    raise AssertionError(row)


def some(rng: Random, n: int = 3) -> list[Fraction]:
    return [F(rng.randint(-9, 9), rng.randint(2, 7)) for _ in range(n)]


# --- platforms ------------------------------------------------------------------------------------------------------


def test_hunts_turn_keeps_all_lengths() -> None:
    legs, at = joints(PUBLISHED / "hunt.yaml")
    axis = np.array(at["d"], float) - np.array(at["b"], float)
    for a, b in legs:
        speed = np.cross(axis, np.array(at[b], float) - np.array(at["b"], float))
        assert speed @ (np.array(at[b], float) - np.array(at[a], float)) == pytest.approx(0, abs=1e-9)
    assert determinant(PUBLISHED / "hunt.yaml", [F(0)] * 3, [F(0)] * 3) == 0


def test_fichters_quarter_turn_at_every_height() -> None:
    path = PUBLISHED / "mirrored-octahedral.yaml"
    for height in (F(0), F(3, 2), F(-7, 3)):
        for quarter in (1, -1):
            assert determinant(path, [F(0), F(0), height], [F(0), F(0), F(quarter)]) == 0
        assert determinant(path, [F(0), F(0), height], [F(0), F(0), F(1, 2)]) != 0


@pytest.mark.parametrize("name", ["platform-6-6", "platform-6-3"])
def test_positions_are_a_cubic_and_rodrigues_parameters_a_sextic(name: str) -> None:
    rng, path = Random(5), EXAMPLES / f"{name}.yaml"
    p, q, c, d = some(rng), some(rng), some(rng), some(rng)

    def shifted(t: Fraction) -> Fraction:
        return determinant(path, [a + t * b for a, b in zip(p, q, strict=True)], c)

    def turned(t: Fraction) -> Fraction:
        at = [a + t * b for a, b in zip(c, d, strict=True)]
        return determinant(path, p, at) * cayley(at)[1] ** 3

    assert (degree(shifted, 3), degree(turned, 6)) == (3, 6)


def test_similar_hexagons_in_circles_are_always_singular() -> None:
    rng = Random(7)
    assert all(determinant(PUBLISHED / "similar-hexagons.yaml", some(rng), some(rng)) == 0 for _ in range(12))


@pytest.mark.parametrize("seed", range(4))
def test_the_forces_of_similar_hexagons_in_circles_balance(seed: int) -> None:
    """With factors that depend on the base alone: those with which 1, x, y, x², xy and y² sum to 0 over its joints."""
    rng = Random(seed)
    halves = rng.sample([F(n, 5) for n in range(-15, 16)], 6)
    radius, middle = F(rng.randint(2, 9)), some(rng, 2)
    base = [
        (middle[0] + radius * (1 - t * t) / (1 + t * t), middle[1] + radius * 2 * t / (1 + t * t), F(0)) for t in halves
    ]
    functions = sympy.Matrix(
        [[sympy.Rational(f.numerator, f.denominator) for f in (F(1), x, y, x * x, x * y, y * y)] for x, y, _ in base]
    )
    (kernel,) = functions.T.nullspace()
    factors = [F(int(k.p), int(k.q)) for k in kernel]
    for _ in range(3):
        shift, (turn, n), ratio = some(rng), cayley(some(rng)), F(rng.randint(1, 9), 4)
        rows = []
        for a in base:
            moved = [
                s + ratio * sum(r * q for r, q in zip(row, a, strict=True)) / n
                for row, s in zip(turn, shift, strict=True)
            ]
            u, v, w = (q - p for p, q in zip(a, moved, strict=True))
            x, y, z = a
            rows.append([u, v, w, y * w - z * v, z * u - x * w, x * v - y * u])
        assert [sum(f * e for f, e in zip(factors, column, strict=True)) for column in zip(*rows, strict=True)] == [
            0
        ] * 6


# --- robots with limbs ----------------------------------------------------------------------------------------------


def home_of(name: str) -> dict[str, np.ndarray]:
    data = yaml.safe_load((PUBLISHED / f"{name}.yaml").read_text(encoding="utf-8"))
    return {n: np.array(p, float) for n, p in data["home"].items()}


@pytest.mark.parametrize(("name", "number"), [("snu-3-upu", 7), ("tsai-3-upu", 5)])
def test_limbs_upu_close_in_every_mode(name: str, number: int) -> None:
    """A limb UPU closes where the outer axes of its joints and its leg are parallel to one plane."""
    at = home_of(name)
    modes = gc.operation_modes(str(PUBLISHED / f"{name}.yaml")).modes
    assert len(modes) == number
    for mode in modes:
        if mode.home:
            continue
        pose = np.array([float(c) for c in mode.witness])
        x, y = pose[:4], pose[4:]
        turn, shift = moved(x, y)
        for k in "123":
            leg = turn @ at[f"B{k}"] + shift - at[f"A{k}"]
            assert np.linalg.det([at[f"u{k}"], turn @ at[f"u{k}"], leg]) == pytest.approx(0, abs=1e-9)


def moved(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Rotation and translation of the dual quaternion x + ε y, the translation as 2 y x̄ / |x|²."""
    n = x @ x
    w, (a, b, c) = x[0], x[1:]
    cross = np.array([[0, -c, b], [c, 0, -a], [-b, a, 0]])
    turn = np.eye(3) + 2 * (w * cross + cross @ cross) / n
    return turn, 2 * (x[0] * y[1:] - y[0] * x[1:] + np.cross(x[1:], y[1:])) / n


def test_couples_of_the_robot_of_seoul_are_parallel_at_home() -> None:
    at = home_of("snu-3-upu")
    couples = [np.cross(at[f"u{k}"], np.cross(at[f"u{k}"], at[f"B{k}"] - at[f"A{k}"])) for k in "123"]
    assert np.linalg.matrix_rank(couples) == 1  # of six freedoms one is taken: five are left


def test_the_positions_of_a_planar_3_rpr_robot_are_on_a_conic() -> None:
    data = yaml.safe_load((ROOT / "plugins" / "3-rpr" / "robot.yaml").read_text(encoding="utf-8"))
    at = {n: [F(str(c)) for c in p][:2] for n, p in data["home"].items()}

    def concurrent(t: Fraction) -> Fraction:
        rows = []
        for k in "123":
            (ax, ay), (bx, by) = at[f"A{k}"], (at[f"B{k}"][0] + 2 * t + 1, at[f"B{k}"][1] - 3 * t)
            rows.append([ay - by, bx - ax, ax * by - ay * bx])
        return F(str(sympy.Matrix([[sympy.Rational(str(e)) for e in row] for row in rows]).det()))

    assert degree(concurrent, 2) == 2


def turn(point: np.ndarray, axis: np.ndarray) -> np.ndarray:
    return np.concatenate([axis, np.cross(point, axis)])


def slide(direction: np.ndarray) -> np.ndarray:
    return np.concatenate([np.zeros(3), direction])


def constraints(limb: list[np.ndarray]) -> np.ndarray:
    """Rows that are reciprocal to all screws of a limb."""
    _, sizes, rows = np.linalg.svd(np.array(limb))
    return rows[int((sizes > 1e-9).sum()) :]


def freedoms_and_overconstraints(limbs: list[list[np.ndarray]]) -> tuple[int, int]:
    every = np.concatenate([constraints(limb) for limb in limbs])
    rank = int(np.linalg.matrix_rank(every, tol=1e-9))
    return 6 - rank, len(every) - rank


def shipped(name: str) -> dict[str, np.ndarray]:
    data = yaml.safe_load((ROOT / "plugins" / name / "robot.yaml").read_text(encoding="utf-8"))
    return {n: np.array(p, float) for n, p in data["home"].items()}


def test_four_limbs_ruu_apply_two_couples_too_many() -> None:
    at, z = shipped("4-ruu"), np.array([0.0, 0.0, 1.0])
    limbs = []
    for k in "1234":
        a, b, c = (at[f"{n}{k}"] for n in "ABC")
        inner = np.cross(z, c - b)
        limbs.append([turn(a, z), turn(b, z), turn(b, inner), turn(c, inner), turn(c, z)])
    assert freedoms_and_overconstraints(limbs) == (4, 2)


def test_exechon_has_three_freedoms_and_two_overconstraints() -> None:
    at = shipped("exechon")
    u, v, s = (at[n] for n in "uvs")
    limbs = [
        [turn(a, u), turn(a, v), slide(b - a), turn(b, v)] for a, b in [(at["A1"], at["B1"]), (at["A2"], at["B2"])]
    ]
    a, b = at["A3"], at["B3"]
    limbs.append([*(turn(a, axis) for axis in np.eye(3)), slide(b - a), turn(b, s)])
    assert freedoms_and_overconstraints(limbs) == (3, 2)
