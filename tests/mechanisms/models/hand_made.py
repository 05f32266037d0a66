"""Models made by hand: what tests of their import share."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gcrules.mechanisms.models.model import Model, ModelJoint

__all__ = ["X", "Y", "Z", "around", "chain_of", "delta", "hexapod", "model", "perturbed"]

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def model(joints: list[ModelJoint], actuated: tuple[str, ...] = (), **more: object) -> Model:
    links = tuple(dict.fromkeys(link for j in joints for link in (j.parent, j.child)))
    links = ("base", *(link for link in links if link != "base"))
    return replace(Model("hand", "urdf", "hand.urdf", links, tuple(joints), actuated), **more)


def around(k: int, radius: float, height: float, *, of: int = 3, turn: float = 0.0) -> tuple[float, float, float]:
    angle = 2 * np.pi * k / of + turn
    return float(radius * np.cos(angle)), float(radius * np.sin(angle)), height


def delta(noise: float = 0.0, elbow: str = "ball") -> Model:
    """Motors, arms, and two rods with ball ends to each of them, at the elbow a ball, a cross or three turns; or with
    crosses at both ends.
    """
    rng = np.random.default_rng(0)
    joints = []
    for k in range(3):
        c, s = float(np.cos(2 * np.pi * k / 3)), float(np.sin(2 * np.pi * k / 3))
        side = np.array([-s, c, 0.0])
        axis = side + noise * rng.normal(size=3)
        axis /= np.linalg.norm(axis)
        at = tuple(map(float, 0.2 * np.array([c, s, 0])))
        joints.append(
            ModelJoint(f"motor{k}", "revolute", "base", f"arm{k}", at, (tuple(map(float, axis)),), (-1.0, 0.5))
        )
        for n, off in enumerate((-0.04, 0.04)):
            top = 0.4 * np.array([c, s, 0]) + off * side + noise * 0.5 * rng.normal(size=3)
            end = 0.06 * np.array([c, s, 0]) + off * side + [0, 0, -0.5] + noise * 0.5 * rng.normal(size=3)
            up, down = tuple(map(float, top)), tuple(map(float, end))
            across = (float(side[0]), float(side[1]), 0.0)
            swing = np.cross(side, [-0.34 * c, -0.34 * s, -0.5])
            turn = (float(swing[0]), float(swing[1]), float(swing[2]))
            kinds: dict[str, list[tuple[tuple[float, float, float], ...]]]
            kinds = {"ball": [()], "cross": [(across, X)], "crosses": [(across, turn)], "turns": [(Z,), (X,), (Y,)]}
            axes = kinds[elbow]
            kind = {0: "ball", 1: "revolute", 2: "universal"}[len(axes[0])]
            ends = (f"arm{k}", f"rod{k}{n}")
            joints += chain_of([(f"e{m}", kind, up, a) for m, a in enumerate(axes)], ends, f"elbow{k}{n}")
            ends = (f"rod{k}{n}", "plate")
            wrist = ("universal", (turn, across)) if elbow == "crosses" else ("ball", ())
            joints.append(ModelJoint(f"wrist{k}{n}", wrist[0], *ends, down, wrist[1], closing=k + n > 0))
    return model(joints, tuple(f"motor{k}" for k in range(3)))


def chain_of(joints: list[tuple[str, str, object, object]], ends: tuple[str, str], name: str) -> list[ModelJoint]:
    """Joints (name, kind, place, axes) one after the other."""
    links = [ends[0], *(f"{name}_{k}" for k in range(1, len(joints))), ends[1]]
    return [
        ModelJoint(f"{name}_{n}", kind, links[k], links[k + 1], at, axes)
        for k, (n, kind, at, axes) in enumerate(joints)
    ]


def hexapod(kinds: str = "three turns", stretch: float = 1.0) -> Model:
    """Six arms with rods, whose ball joints are three turns, or a cross and a ball."""
    joints = []
    for k in range(6):
        foot = around(k, 0.3, 0.0, of=6, turn=0.2 * (-1) ** k)
        axis = around(k, 1.0, 0.0, of=6, turn=np.pi / 2)
        elbow = tuple(float(c) for c in np.array(foot) + 0.1 * np.array(around(k, 0.0, 1.0)) + [0.0, 0.0, 0.02 * k])
        tip = around(k, 0.15, 0.5 * stretch, of=6, turn=-0.3 * (-1) ** k)
        ends = [("elbow", "universal", elbow, (axis, Z))]
        if kinds == "three turns":
            ends += [(f"tip{n}", "revolute", tip, (a,)) for n, a in enumerate((X, Y, Z))]
        else:
            ends += [("tip", "ball", tip, ())]
        joints += chain_of([("motor", "revolute", foot, (axis,)), *ends], ("base", "top"), f"leg{k}")
    return model(joints, tuple(f"leg{k}_motor" for k in range(6)))


def perturbed(own: Model, amount: float, seed: int = 0) -> Model:
    """With errors in all places, in parts of the size, and in all axes."""
    rng = np.random.default_rng(seed)
    places = np.array([j.at for j in own.joints])
    size = float(np.linalg.norm(places.max(axis=0) - places.min(axis=0))) or 1.0

    def off(v: tuple[float, float, float], by: float, *, unit: bool) -> tuple[float, float, float]:
        found = np.array(v) + by * rng.uniform(-1, 1, 3)
        x, y, z = (float(c) for c in (found / np.linalg.norm(found) if unit else found))
        return x, y, z

    joints = (
        replace(j, at=off(j.at, amount * size, unit=False), axes=tuple(off(a, amount, unit=True) for a in j.axes))
        for j in own.joints
    )
    return replace(own, joints=tuple(joints))
