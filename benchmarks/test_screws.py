"""Limb Jacobians of many configurations at once, beside a loop over them, and beside a robotics library."""

from __future__ import annotations

from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy as np

from gcrules.screws import Limb, jacobian, joint, limb

MANY = 10_000  # configurations; the goal is as many limb Jacobians a second
RNG = np.random.default_rng(5)
ANGLES = RNG.uniform(-1.2, 1.2, (MANY, 6))
ANGLES[:, 2] += 2.5  # the length of the leg
BASES = RNG.normal(size=(3, 3))


def ups(q: Any, base: Any) -> Limb:
    """A UPS leg, its U joint at the base with axes along x and y, from the values of its joints (..., 6)."""
    a, b, length = q[..., 0], q[..., 1], q[..., 2]
    zero = np.zeros_like(a)
    second = np.stack([zero, np.cos(a), np.sin(a)], axis=-1)
    along = np.stack([np.sin(b), -np.sin(a) * np.cos(b), np.cos(a) * np.cos(b)], axis=-1)
    return limb(
        joint("U", point=base, first=(1.0, 0.0, 0.0), second=second),
        joint("P", direction=along, actuated=True),
        joint("S", point=base + length[..., None] * along),
    )


def rps(q: Any, base: Any) -> Limb:
    """An RPS leg with its R axis along x."""
    a, length = q[..., 0], q[..., 2]
    along = np.stack([np.zeros_like(a), -np.sin(a), np.cos(a)], axis=-1)
    return limb(
        joint("R", point=base, axis=(1.0, 0.0, 0.0)),
        joint("P", direction=along, actuated=True),
        joint("S", point=base + length[..., None] * along),
    )


def wrenches(leg: Limb) -> tuple[Any, Any]:
    return leg.actuations(), leg.constraints()


def one_by_one(q: Any, base: Any) -> tuple[Any, Any]:
    """The same for one leg after the other, with null spaces as numpy gives them."""
    found = []
    for a, b, length in q[:, :3]:
        along = np.array([np.sin(b), -np.sin(a) * np.cos(b), np.cos(a) * np.cos(b)])
        top = base + length * along
        axes = [np.array([1.0, 0, 0]), np.array([0, np.cos(a), np.sin(a)])]
        turns = [np.concatenate([np.cross(base, u), u]) for u in axes]  # (v; ω): rows to which wrenches are orthogonal
        turns += [np.concatenate([np.cross(top, u), u]) for u in np.eye(3)]
        slide = np.concatenate([along, np.zeros(3)])
        free = np.linalg.svd(np.array(turns))[2][5:]
        shadow = free.T @ (free @ slide)
        found.append(shadow / (shadow @ slide))
        assert len(np.linalg.svd(np.array([*turns, slide]))[2][6:]) == 0
    return np.array(found)[:, None], np.zeros((len(q), 0, 6))


def with_toolbox(toolbox: ModuleType, q: Any, base: Any) -> tuple[Any, Any]:
    """The row of the inverse Jacobian of the leg as a serial arm, with the moment moved to the origin."""
    arm = toolbox.ET.Rx() * toolbox.ET.Ry() * toolbox.ET.tz() * toolbox.ET.Rx() * toolbox.ET.Ry() * toolbox.ET.Rz()
    tops = ups(q, base).joints[-1].geometry["point"]
    found = np.empty((len(q), 1, 6))
    for i, (values, top) in enumerate(zip(q, tops, strict=True)):
        row = np.linalg.inv(arm.jacob0(values))[2]
        found[i, 0, :3], found[i, 0, 3:] = row[:3], row[3:] + np.cross(top, row[:3])
    return found, np.zeros((len(q), 0, 6))


def same(one: tuple[Any, Any], other: tuple[Any, Any]) -> bool:
    return all(a.shape == b.shape and np.allclose(a, b) for a, b in zip(one, other, strict=True))


def test_limb_jacobians(ratio: Callable[..., Any], peer: Callable[[str], Any]) -> None:
    toolbox = peer("roboticstoolbox")
    ratio(
        lambda: wrenches(ups(ANGLES, BASES[0])),
        {
            "one by one": lambda: one_by_one(ANGLES, BASES[0]),
            "roboticstoolbox": toolbox and (lambda: with_toolbox(toolbox, ANGLES, BASES[0])),
        },
        agree=same,
        within=1.0,
        at_least={"one by one": 5},
        others_rounds=2,
    )


def test_jacobians_of_a_robot(ratio: Callable[..., Any]) -> None:
    """3-RPS: three limbs with a constraint wrench each, hence 3,000 limb Jacobians, and their determinants."""
    shifted = [np.roll(ANGLES[:1000], n, axis=0) for n in range(3)]

    def together() -> Any:
        return jacobian([rps(q, base) for q, base in zip(shifted, BASES, strict=True)]).determinant()

    def one_by_one() -> Any:
        rows = zip(*shifted, strict=True)
        return [jacobian([rps(q, b) for q, b in zip(row, BASES, strict=True)]).determinant() for row in rows]

    def agree(a: Any, b: Any) -> bool:
        return bool(np.allclose(np.abs(a), np.abs(b)))

    ratio(together, {"one by one": one_by_one}, agree=agree, within=0.3, at_least={"one by one": 5}, others_rounds=1)
