"""Closing loops that are open in the file: rates against differences, and what is closed is closed."""

from __future__ import annotations

import numpy as np
import pytest

from gcrules.mechanisms.models.closing import Loop, Tree, closed, gaps
from gcrules.mechanisms.models.model import AXES, ModelCoupling, ModelJoint

KINDS = [kind for kind in AXES if kind not in ("screw", "free")]


def chain(rng: np.random.Generator) -> list[ModelJoint]:
    """A joint of each kind, one behind the other from the base, beside another such chain."""
    found = []
    for side in "lr":
        link = "base"
        for n, kind in enumerate(AXES):
            axes = tuple(tuple(a / np.linalg.norm(a)) for a in rng.normal(size=(AXES[kind], 3)))
            found.append(ModelJoint(f"{side}{n}", kind, link, f"{side}{n}", tuple(rng.normal(size=3)), axes, pitch=0.3))
            link = f"{side}{n}"
    return found


def frame(rng: np.random.Generator) -> np.ndarray:
    found = np.eye(4)
    found[:3, :3] = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    found[:3, :3] *= np.linalg.det(found[:3, :3])
    found[:3, 3] = rng.normal(size=3)
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_rates_are_those_of_the_residuals(kind: str) -> None:
    """By differences; turns are compared where the loop is closed, as they are no coordinates elsewhere."""
    rng = np.random.default_rng(KINDS.index(kind))
    tree = Tree("base", chain(rng), [ModelCoupling("l1", "r1", -2.0)])
    amounts = rng.normal(size=len(tree.screws)) * 0.3
    motions, twists = tree.motions(amounts)
    ends = ("l8", "r7")
    one, axis = frame(rng), rng.normal(size=3)
    there = np.linalg.inv(motions[ends[1]]) @ motions[ends[0]]  # on the other link, at the same place here
    across = np.cross(axis, rng.normal(size=3)) if kind == "universal" else axis
    axes = (axis, there[:3, :3] @ across) if AXES[kind] else None
    loop = Loop("loop", kind, ends, (one, there @ one), axes)
    assert gaps(loop.carried(motions)) == pytest.approx((0, 0), abs=1e-9)
    own = []
    for name in ends:
        some = np.zeros_like(twists)
        some[tree.before[name]] = twists[tree.before[name]]
        own.append(some)
    rates = [r.T @ tree.parts for r in loop.carried(motions).rates((own[0], own[1]))]
    for k in range(len(amounts)):
        step = np.zeros(len(amounts))
        step[k] = 1e-6
        ahead, behind = (loop.carried(tree.motions(amounts + s)[0]).residual() for s in (step, -step))
        for part in (0, 1):
            assert np.allclose((ahead[part] - behind[part]) / 2e-6, rates[part][:, k], atol=1e-6)


@pytest.mark.parametrize("seed", range(8))
def test_a_polygon_with_an_open_corner_is_closed(seed: int) -> None:
    """Four bars in the plane, in whatever state: their ends meet, and the driven one stays where that is possible."""
    rng = np.random.default_rng(seed)
    lengths, angles = np.array([2.0, 3.0, 2.5]), rng.uniform(-0.6, 0.6, size=3) + np.array([1.2, 0.0, -1.2])
    corners = np.zeros((4, 3))
    for k in range(3):
        corners[k + 1] = corners[k] + lengths[k] * np.array((np.cos(angles[k]), np.sin(angles[k]), 0))
    axis = ((0.0, 0.0, 1.0),)
    links = ["base", "one", "two", "three"]
    joints = [ModelJoint(f"q{k}", "revolute", links[k], links[k + 1], tuple(corners[k]), axis) for k in range(3)]
    tree = Tree("base", joints, [])
    ends = np.eye(4), np.eye(4)
    ends[0][:3, 3], ends[1][:3, 3] = (4.0, 0.0, 0.0), corners[3]
    loop = Loop("loop", "ball", ("base", "three"), ends)
    found = closed(tree, [loop], 4.0, ("q0",))
    assert found is not None
    assert found[0] == 0.0
    assert gaps(loop.carried(tree.motions(found)[0]))[0] < 1e-8
    ends[0][:3, 3] = (40.0, 0.0, 0.0)
    assert closed(tree, [loop], 4.0, ("q0",)) is None
