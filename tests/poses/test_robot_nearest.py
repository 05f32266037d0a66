"""The nearest singular configuration of a robot of joints.

The second road asks the exact condition of the file, and not the wrenches: its factors change their sign at what was
found, none does inside the box that is proved; and for lines in the plane, written out anew, nothing nearer is found.
"""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner
from mechanisms.shipped_robots import analysis

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.mechanisms.kinematics.linkage import begun_at, linkage
from gcrules.mechanisms.kinematics.margin import margin
from gcrules.mechanisms.kinematics.solve import free_coordinates, solve
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.poses.limbs.factors import factors
from gcrules.poses.limbs.nearest import NearestSingular, nearest_singular

FOUND = ("3-rpr", "3-rps", "3-rrr", "3-rrr-spherical", "orthoglide", "6-rus", "4-ruu", "tricept")
EXACT = {"orthoglide": math.sqrt(8 / 3)}
"""All three changes: rods of length 2√2 along (a, t, t), (t, a, t), (t, t, a) lie in a plane where a = t."""


@pytest.fixture(scope="module")
def found() -> dict[str, NearestSingular]:
    made = {name: nearest_singular(linkage(analysis(name).robot)) for name in FOUND}
    return {name: n for name, n in made.items() if n is not None}


def live(name: str, changes: Any) -> np.ndarray:
    """The factors of the condition after changes of the free coordinates."""
    m = linkage(analysis(name).robot)
    here = solve(m, Target(free_coordinates(m), np.asarray(changes, dtype=float))).configuration
    return np.array([f.value for f in factors(analysis(name), here.values) if f.live])


@pytest.mark.parametrize("name", FOUND)
def test_it_is_singular_and_a_factor_changes_its_sign_there(found: dict[str, NearestSingular], name: str) -> None:
    n = found[name]
    m = linkage(analysis(name).robot)
    assert n.solution is not None
    assert n.changes is not None
    assert margin(m, n.solution.configuration).sigma < 1e-7
    weights = np.array([m.size if c in ("x", "y", "z") else 1.0 for c in n.names])
    assert np.linalg.norm(n.changes / weights) == pytest.approx(n.distance, rel=1e-9)
    before, after = (live(name, (1 + s) * n.changes) for s in (-1e-4, 1e-4))
    assert (before * after < 0).any() or name == "tricept"  # two factors vanish at once there


def test_nothing_nearer_by_formulas(found: dict[str, NearestSingular]) -> None:
    """Planar 3-RPR: three lines are concurrent or parallel; the distance over the zeros by Newton's method for its
    stationary points, from many places.
    """
    n = found["3-rpr"]
    m = linkage(analysis("3-rpr").robot)
    fixed, moving = (np.array([m.home.values[f"{c}{k}"][:2] for k in (1, 2, 3)]) for c in "AB")
    centre = m.centre[:2]

    def value(u: np.ndarray) -> np.ndarray:
        """The determinant of the three lines at u (N, 3): shifts by parts of the size, and the turn."""
        c, s = np.cos(u[:, 2]), np.sin(u[:, 2])
        turn = np.stack([np.stack([c, -s], -1), np.stack([s, c], -1)], -2)
        at = np.einsum("nij,kj->nki", turn, moving - centre) + centre + m.size * u[:, None, :2]
        d = at - fixed
        moments = fixed[:, 0] * d[..., 1] - fixed[:, 1] * d[..., 0]
        return np.linalg.det(np.concatenate([d, moments[..., None]], axis=-1))

    def slope(u: np.ndarray) -> np.ndarray:
        h = 1e-6
        return np.stack([(value(u + h * e) - value(u - h * e)) / (2 * h) for e in np.eye(3)], axis=1)

    u = np.random.default_rng(4).uniform(-1, 1, size=(4000, 3))
    for _ in range(200):  # onto the tangent plane's foot, half of the way
        g = slope(u)
        foot = ((u * g).sum(1) - value(u))[:, None] * g / (g * g).sum(1)[:, None]
        u = (u + foot) / 2
    true = np.abs(value(u)) < 1e-9
    distance = np.linalg.norm(u[true], axis=1)
    assert len(distance) > 100
    assert distance.min() == pytest.approx(n.distance, rel=1e-5)


@pytest.mark.parametrize("name", FOUND)
def test_the_proved_box_is_free(found: dict[str, NearestSingular], name: str) -> None:
    n = found[name]
    assert n.free < n.distance
    if not n.free:
        return
    m = linkage(analysis(name).robot)
    weights = np.array([m.size if c in ("x", "y", "z") else 1.0 for c in n.names])
    home = live(name, np.zeros(len(weights)))
    rng = np.random.default_rng(2)
    for _ in range(6):
        corner = n.free * np.where(rng.random(len(weights)) < 0.5, -1, 1) * np.maximum(rng.random(len(weights)), 0.8)
        assert (home * live(name, corner * weights) > 0).all()


@pytest.mark.parametrize("name", EXACT)
def test_where_it_is_known(found: dict[str, NearestSingular], name: str) -> None:
    assert np.abs(found[name].changes) == pytest.approx(EXACT[name], rel=1e-6)


def test_it_begins_where_the_robot_is() -> None:
    """From half-way towards what was found from home it is half as far, in the same direction."""
    m = linkage(analysis("3-rpr").robot)
    home = nearest_singular(m)
    assert home is not None
    assert home.changes is not None
    half = solve(m, Target(home.names, home.changes / 2))
    there = nearest_singular(begun_at(m, half.configuration))
    assert there is not None
    assert there.changes is not None
    assert there.distance == pytest.approx(home.distance / 2, rel=1e-5)
    assert np.allclose(there.changes, home.changes / 2, atol=1e-3)


def test_the_answer_tells_it() -> None:
    here = gc.pose("3-rpr", "x=0, y=0, yaw=5deg")
    n = here.nearest
    assert n.branch_proved
    assert n.margin < 1e-7
    assert n.stopped == 0
    assert n.causes == ("The lines A1B1, A2B2 and A3B3 meet in a point or are parallel (actuation singularity).",)
    assert n.coordinates["yaw"] - math.radians(5) == pytest.approx(n.changes["yaw"], abs=1e-9)
    there = gc.pose("3-rpr", {c: n.coordinates[c] for c in ("x", "y", "yaw")}, nearest=False)
    assert there.verdict == "singular"
    assert there.nearest is None
    assert there.actuator_values == pytest.approx(n.actuators, abs=1e-9)
    assert "Nearest singular configuration" in here.text()
    assert "proved: on this branch no configuration is singular while" in " ".join(here.text().split())
    assert "nearest singular configuration" in here.latex()
    assert gc.pose("3-rpr", nearest=False).to_json()["nearest"] is None
    assert gc.pose("3-rpr", [{"x": 0, "y": 0, "yaw": 0}])[0].nearest is None


def test_bounds_are_rounded_down() -> None:
    n = gc.pose("3-rpr").nearest
    words = " ".join(gc.pose("3-rpr").text().split()).partition("on this branch")[2]
    shown = float(words.split("less than ")[1].split()[0])
    assert shown <= n.free["x"] < shown * 1.01


@pytest.mark.parametrize("command", [("pose",), ("robot", "pose")])
def test_the_commands(command: tuple[str, ...]) -> None:
    run = CliRunner()
    told = json.loads(run.invoke(cli, [*command, "3-rpr", "--json"]).stdout)
    assert told["nearest"]["distance"] == pytest.approx(0.30438, abs=1e-4)
    left = json.loads(run.invoke(cli, [*command, "3-rpr", "--no-nearest", "--json"]).stdout)
    assert left["nearest"] is None
    assert {k: v for k, v in told.items() if k != "nearest"} == {k: v for k, v in left.items() if k != "nearest"}
