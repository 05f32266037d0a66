"""From where robots are seen: limbs apart, parallelograms open, a robot around a point on its base."""

from __future__ import annotations

from functools import cache
from itertools import combinations
from math import dist

import pytest

from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.load import read_robot
from gcrules.views.drawing.bsp import dot, minus
from gcrules.views.drawing.solids import center, outline
from gcrules.views.drawing.viewpoint import View, choose_view
from gcrules.views.robots.drawn_limb import DrawnLimb, unit_vector
from gcrules.views.robots.joint_chain import upright
from gcrules.views.robots.scene import Scene, scene

KNOWN = ["delta", "4-ruu", "exechon", "tricept", "3-rrr-spherical", "agile-eye", "orthoglide"]
ROUND = ["3-rrr-spherical", "agile-eye"]


@cache
def drawn(name: str) -> Scene:
    a = analyze_robot(read_robot(name))
    return scene(a, home_values(a.robot))


def links(s: Scene, c: DrawnLimb) -> list[tuple[tuple[float, float], tuple[float, float]]]:
    found = [(s.frame.place(one.start), s.frame.place(one.end)) for one in c.strokes if one.look in ("link", "bar")]
    return [(p, q) for p, q in found if dist(p, q) > 1e-6]


def crossing(one: DrawnLimb, other: DrawnLimb, s: Scene) -> bool:
    def side(p: tuple[float, float], q: tuple[float, float], r: tuple[float, float]) -> float:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return any(
        side(a, b, c) * side(a, b, d) < -1e-6 and side(c, d, a) * side(c, d, b) < -1e-6
        for a, b in links(s, one)
        for c, d in links(s, other)
    )


@pytest.mark.parametrize("name", ["delta", "4-ruu", "exechon", "tricept", "orthoglide"])
def test_limbs_of_known_robots_do_not_cross(name: str) -> None:
    s = drawn(name)
    assert [(p.limb.name, q.limb.name) for p, q in combinations(s.chains, 2) if crossing(p, q, s)] == []


@pytest.mark.parametrize("name", KNOWN)
def test_base_and_platform_are_apart(name: str) -> None:
    """Neither body is seen edge on, and their middles stand apart."""
    s = drawn(name)
    middles = [s.frame.place(center(body)) for body in (s.base, s.plate)]
    assert dist(*middles) > 30 or name == "orthoglide"
    for body in (s.base, s.plate):
        flat = [s.frame.place(p) for p in body]
        assert max(x for x, _ in flat) - min(x for x, _ in flat) > 20
        assert max(y for _, y in flat) - min(y for _, y in flat) > 5


def test_the_parallelograms_of_the_delta_are_open() -> None:
    s = drawn("delta")
    for c in s.chains:
        assert len(c.normals) == 1
        assert abs(dot(c.normals[0], s.frame.view.eye)) > 0.2


@pytest.mark.parametrize("name", ROUND)
def test_a_robot_around_a_point_stands_on_its_base(name: str) -> None:
    """Base below, platform above the point through which all axes pass; each link on a sphere inside the one before."""
    s = drawn(name)
    up = upright(s.chains)
    for c in s.chains:
        assert c.around is not None
        assert dot(minus(c.foot, c.around), up) < 0 < dot(minus(c.head, c.around), up)
        radii = [dist(p.at, c.around) for p in c.places]
        assert radii == sorted(radii, reverse=True)
        assert all(abs(dot(unit_vector(minus(p.at, c.around)), p.axes[0]) - 1) < 1e-9 for p in c.places)
    assert s.frame.place(center(s.base))[1] > s.frame.place(center(s.plate))[1]


def test_names_of_coinciding_axes_stand_at_their_joints() -> None:
    """At the home of the Agile Eye u3, v1 and w2 are one line."""
    s = drawn("agile-eye")
    places = [p.at for c in s.chains for p in c.places]
    assert min(dist(p, q) for p, q in combinations(places, 2)) > 0.1


def test_upright_is_z_for_all_others() -> None:
    assert upright(drawn("delta").chains) == (0.0, 0.0, 1.0)
    assert upright(()) == (0.0, 0.0, 1.0)


@pytest.mark.parametrize("up", [(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.6, 0.0, 0.8), (0.0, -1.0, 0.0)])
def test_views_are_right_handed_with_the_given_direction_upright(up: tuple[float, float, float]) -> None:
    for azimuth, elevation in ((0, 20), (130, 36)):
        view = View.at(azimuth, elevation, up)
        for v in (view.eye, view.right, view.up):
            assert dot(v, v) == pytest.approx(1)
        assert view.flat(up)[0] == pytest.approx(0)
        assert view.flat(up)[1] < 0


def test_links_that_cross_are_turned_apart() -> None:
    """Two upright posts, one behind the other for some viewpoints, are seen side by side."""
    posts = [[((0.0, y, 0.0), (0.0, y, 1.0))] for y in (0.0, 1.0)]
    points = {f"{k}{n}": p for k, own in enumerate(posts) for a in own for n, p in enumerate(a)}
    view, cost = choose_view(points, (), limbs=posts)
    (x, _), (u, _) = view.flat((0.0, 0.0, 0.0)), view.flat((0.0, 1.0, 0.0))
    assert abs(x - u) > 0.4
    assert cost < 1


def test_a_thick_body_is_drawn_as_a_solid() -> None:
    cube = [(float(x), float(y), float(z)) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    faces = outline(cube)
    assert sorted(len(face) for face, _ in faces) == [4] * 6
    assert all(all(edges) for _, edges in faces)


def test_only_a_limb_that_guides_is_a_tube() -> None:
    tubes = {c.limb.name: [one.look for one in c.strokes].count("tube") for c in drawn("tricept").chains}
    assert tubes == {"the central leg": 1, "leg 1": 0, "leg 2": 0, "leg 3": 0}


def test_a_carriage_stands_where_its_rods_begin() -> None:
    s = drawn("gantry-tau")
    carriages = [p for c in s.chains for p in c.places if p.kind == "carriage"]
    assert len(carriages) == 3
    pins = [p.at for c in s.chains for p in c.places if p.kind in ("pin", "S")]
    assert all(min(dist(one.at, p) for p in pins) < 0.2 for one in carriages)
