"""What floats prove of a path is what the exact polynomials say, and rounding stays within its bound."""

from __future__ import annotations

import pickle
from collections.abc import Sequence
from fractions import Fraction
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from places import EXAMPLES
from poses.platforms import PLATFORMS

import gcrules as gc
from gcrules.conditions.analysis import Analysis
from gcrules.core.errors import InputError
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.moving_platform import MovingPlatform, rig
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.poses.paths import polynomials as of_path
from gcrules.poses.paths.float_proofs import FloatProofs
from gcrules.poses.paths.forms import forms, superbracket
from gcrules.poses.paths.polynomials import NO_ZERO, degree_along, polynomials
from gcrules.poses.paths.roots import roots
from gcrules.poses.paths.segment import Segment
from gcrules.poses.paths.segments import Segments, segments
from gcrules.poses.paths.zeros import places, stretches
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import parse_pose

F = Fraction
LOW = "0 0 -350"  # of the octahedral platform: singular, and so is all of its plane
OUT = "1000 2000 0"


def rig_of(a: Analysis, about: Any = "centroid") -> MovingPlatform:
    assert a.platform is not None
    return rig(a.structure, a.platform, about)


def parsed(moving: MovingPlatform, poses: Sequence[str]) -> tuple[Pose, ...]:
    return tuple(parse_pose(p, moving.unit) for p in poses)


def exact(s: Segment, *, powers: bool) -> list[F]:
    """The coefficients that `FloatProofs` finds, exactly, of quaternions as they are."""
    found = forms(s.rig)
    ratio = found.unit / found.fine

    def pair(a: F, b: F) -> list[F]:
        return [a, b - a] if powers else [a, b]

    turns = np.array([pair(*c) for c in zip(s.q0, s.q1, strict=True)], object)[:, :, None]
    shifts = [pair(a / found.fine, b / found.fine) for a, b in zip(s.t0, s.t1, strict=True)]
    one = [F(1), F(0)] if powers else [F(1), F(1)]
    whole = superbracket(found.whole, turns, np.array([one, *shifts], object)[:, :, None])
    return [c / ratio**9 for c in whole[:, 0]]


def proofs(way: Segments) -> FloatProofs:
    return FloatProofs(forms(way.rig), way.motions, *way.changes)


def agree(way: Segments) -> int:
    """Both roads have the same zeros, stretches and degrees; how many segments floats have left over."""
    found, degrees = polynomials(way)
    whole = [s.polynomial for s in way]
    assert degrees == tuple(len(p) - 1 for p in whole)
    assert places(found) == places(whole)
    assert stretches(found) == stretches(whole)
    for one, other in zip(found, whole, strict=True):
        assert one == other or (one is NO_ZERO and other and not roots(other))
    return sum(one is not NO_ZERO for one in found)


# --- both roads -----------------------------------------------------------------------------------------------------

thirds = st.integers(-3, 3).map(lambda c: F(c, 3))
shifts = st.tuples(*[st.one_of(st.just(F(0)), thirds, st.fractions(-2, 2, max_denominator=99))] * 3)
turned = st.tuples(st.just(F(9)), *[st.one_of(st.just(F(0)), st.integers(-4, 4).map(F))] * 3)
lengths = st.sampled_from([F(1), F(-1), F(1, 3), F(7)])
anywhere = st.builds(lambda t, q, n: Pose(t, tuple(n * c for c in q)), shifts, turned, lengths)


@settings(max_examples=40, deadline=None)
@given(
    name=st.sampled_from(PLATFORMS),
    poses=st.lists(anywhere, min_size=2, max_size=8),
    about=st.sampled_from(["origin", "centroid", "1,-2,1/3"]),
    size=st.sampled_from([F(1), F(1, 1000), F(10**6)]),
)
def test_floats_prove_what_is_true(
    robots: dict[str, Analysis], name: str, poses: list[Pose], about: str, size: F
) -> None:
    moving = rig_of(robots[name], about)
    scale = size * F(str(round(moving.size, 3)))
    listed = [Pose(tuple(c * scale for c in p.translation), p.quaternion) for p in poses]
    agree(segments(moving, listed))


@pytest.mark.parametrize(
    ("poses", "left"),
    [
        (["0 0 0", LOW, "0 0 0"], 2),  # touches where two segments meet
        (["0 0 0", LOW, "0 0 -352"], 2),
        ([LOW, "0 0 0", "10 0 0"], 1),
        (["0 0 0", "0 0 -100", "0 0 -100", "0 0 -100", "5 0 0"], 0),  # stands still
        ([LOW, LOW, LOW], 2),
        ([LOW, "50 20 -350", "0 0 -350; euler zyx 10 0 0 deg"], 2),
        (["0 0 0", "0 0 -349.999", "0 0 0"], 0),
        (["0 0 0", "0 0 -349.9999999999999999999999", "0 0 0"], 2),  # nearer than floats can tell
        (["0 0 0", "0 0 -700", "0 0 -1100"], 1),
        (["0 0 0", "0 0 1e-14", "0 0 1e-14; rotvec 1e-12 0 0 deg"], 1),  # of unknown degree
        ([OUT, "1000 2000 5", "1000.5 2000 5; euler zyx 10 0 0 deg"], 0),
        (["1e12 0 0", "1e12 2e12 1", "1e12 2e12 2; euler zyx 10 20 0 deg"], 2),
        (["5 0 0", "5 2 0; euler zyx 1 2 3 deg", "7 2 0; euler zyx 2 2 3 deg", "7 2 0; euler zyx 2 2 3 deg"], 0),
    ],
    ids=lambda v: " → ".join(v) if isinstance(v, list) else "",
)
def test_special_paths(
    robots: dict[str, Analysis], poses: list[str], left: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(of_path, "_MANY", 1)
    moving = rig_of(robots["octahedral"])
    assert agree(segments(moving, parsed(moving, poses))) == left


def wave(n: int, low: float) -> list[Pose]:
    """A smooth path of n poses, that of octahedral.yaml is singular far below."""
    t = np.linspace(0, 6, n)
    rows = np.stack([60 * np.sin(t), 60 * np.cos(1.3 * t) - 60, low * (1 - np.cos(t))], axis=1).round(6)
    turns = np.stack([10 * np.sin(0.9 * t), 8 * np.sin(1.1 * t), 15 * np.sin(0.8 * t)], axis=1).round(6)
    return [
        parse_pose(f"{x} {y} {z}; euler zyx {a} {b} {c} deg")
        for (x, y, z), (a, b, c) in zip(rows.tolist(), turns.tolist(), strict=True)
    ]


def test_few_polynomials_are_needed(robots: dict[str, Analysis], monkeypatch: pytest.MonkeyPatch) -> None:
    """As many as there are crossings, and none without; flat paths have a smaller degree, which is known, too."""
    exactly, made = Segment.polynomial.func, []  # type: ignore[attr-defined]

    def counted(s: Segment) -> Any:
        made.append(s)
        return exactly(s)

    monkeypatch.setattr(Segment, "polynomial", property(counted))
    safe = gc.path(robots["octahedral"], wave(300, -50), samples=1)
    assert (safe.zeros, set(safe.degrees), made) == ((), {9}, [])
    through = gc.path(robots["octahedral"], wave(300, -250), samples=1)
    assert 0 < len(through.zeros) == len(made)
    assert pickle.loads(pickle.dumps(through)) == through
    made.clear()
    for name, most in (("octahedral", 8), ("platform-6-6", 8)):
        level = [Pose((p.translation[0] / 1000, p.translation[1] / 1000, F(0)), p.quaternion) for p in wave(150, 0)]
        assert set(gc.path(robots[name], level, samples=1).degrees) == {most}
    assert not made


def test_the_degree_along_coordinates(robots: dict[str, Analysis]) -> None:
    """The bases of these platforms are level, so that z is a factor of all terms of degree 3."""
    everything, level = (True,) * 7, (True, False, False, True, *[True] * 3)
    for name, straight in (("octahedral", 1), ("platform-6-6", 2)):
        moving = rig_of(robots[name])
        found = [degree_along(moving, (*everything, *axes)) for axes in product((False, True), repeat=3)]
        assert found == [0, 3, 2, 3, 2, 3, 2, 3]
        assert degree_along(moving, (*level, True, False, False)) == straight
    tilted = rig_of(analyze_legs(load_platform(EXAMPLES / "dietmaier.yaml")))
    assert degree_along(tilted, (*everything, True, True, False)) == 3


# --- the forms, and their rounding ----------------------------------------------------------------------------------


@settings(max_examples=20, deadline=None)
@given(name=st.sampled_from(PLATFORMS), a=anywhere, b=anywhere, about=st.sampled_from(["origin", "1,-2,1/3"]))
def test_the_forms_are_the_superbracket(robots: dict[str, Analysis], name: str, a: Pose, b: Pose, about: str) -> None:
    (s,) = segments(rig_of(robots[name], about), [a, b])
    found, right = exact(s, powers=True), [*s.polynomial, *[0] * (10 - len(s.polynomial))]
    ratios = {x / y for x, y in zip(found, right, strict=True) if y}
    assert len(ratios) <= 1
    assert not any(x for x, y in zip(found, right, strict=True) if not y)


near = st.builds(  # poses around singular ones, where everything cancels, nearer and nearer, and far away
    lambda p, power, t, turn: Pose(
        tuple(c + F(d) * F(10) ** power for c, d in zip(p, t, strict=True)),
        (F(1), *(F(float(c) * 10.0**power / 400) for c in turn)),
    ),
    st.sampled_from([(F(0), F(0), F(-350)), (F(50), F(20), F(-350)), (F(10**9), F(-(10**9)), F(1)), (F(1, 3),) * 3]),
    st.integers(-16, 2),
    st.tuples(*[st.floats(-1, 1, allow_subnormal=False)] * 3),
    st.tuples(*[st.floats(-1, 1, allow_subnormal=False)] * 3),
)


@settings(max_examples=60, deadline=None)
@given(
    name=st.sampled_from(["octahedral", "octahedral-singular", "platform-6-6", "four-dof"]),
    a=near,
    b=near,
    length=st.sampled_from([F(1), F(3, 7), F(10**9)]),
    powers=st.booleans(),
)
def test_rounding_stays_within_its_bound(
    robots: dict[str, Analysis], name: str, a: Pose, b: Pose, length: F, powers: bool
) -> None:
    moving = rig_of(robots[name])
    if name in ("platform-6-6", "four-dof"):
        a, b = (Pose(tuple(c / 400 for c in p.translation), p.quaternion) for p in (a, b))
    b = Pose(b.translation, tuple(length * c for c in b.quaternion))
    way = segments(moving, [a, b])
    ((values, errors),) = proofs(way).coefficients(np.array([0]), powers=powers)
    size = F(2.0 ** np.frexp(np.abs(way.motions.q0[0]).max())[1])
    right = [c / size**6 for c in exact(way[0], powers=powers)]
    assert len(values) == len(right) == 10
    for value, error, truth in zip(values[:, 0].tolist(), errors[:, 0].tolist(), right, strict=True):
        assert abs(F(value) - truth) <= F(error)


def test_the_bound_is_not_much_too_large(robots: dict[str, Analysis]) -> None:
    """Far from singular poses it is as small as rounding makes it; what is too large for it proves nothing."""
    moving = rig_of(robots["octahedral"])
    way = segments(moving, wave(50, -50))
    ((values, errors),) = proofs(way).coefficients(np.arange(49), powers=False)
    assert (errors < 1e-9 * np.abs(values)).all()
    for pose in (Pose((F(10) ** 17, F(0), F(0))), Pose(quaternion=(F(10) ** 20, F(1), F(0), F(0)))):
        ((_, errors),) = proofs(segments(moving, [pose, Pose((F(0), F(0), F(1)))])).coefficients(
            np.array([0]), powers=False
        )
        assert np.isinf(errors).all()


# --- segments in floats ---------------------------------------------------------------------------------------------


@settings(max_examples=40, deadline=None)
@given(a=anywhere, b=anywhere)
def test_motions_are_the_segments_in_floats(robots: dict[str, Analysis], a: Pose, b: Pose) -> None:
    way = segments(rig_of(robots["octahedral"]), [a, b, a])
    assert [s.t0 for s in way] == [a.translation, b.translation]
    assert way[0:2] == (way[0], way[-1])
    turns, shifted = way.changes
    for k, s in enumerate(way):
        m = way.motions
        for found, right in ((m.t0, s.t0), (m.t1, s.t1), (m.q0, s.q0)):
            assert found[k].tolist() == [float(c) for c in right]
        assert np.allclose(m.q1[k], [float(c) for c in s.q1], rtol=16 * 2.0**-53, atol=0)
        assert (turns[k], shifted[k].tolist()) == (s.q0 != s.q1, [x != y for x, y in zip(s.t0, s.t1, strict=True)])


def test_turns_are_compared_exactly(robots: dict[str, Analysis]) -> None:
    """Floats do not tell these quaternions, or half turns, apart."""
    moving = rig_of(robots["octahedral"])
    tiny = F(1, 10**30)
    same, other = Pose(quaternion=(F(3), F(0), F(0), F(1))), Pose(quaternion=(F(3), F(0), F(0), F(1) + tiny))
    assert [segments(moving, [same, p]).changes[0].tolist() for p in (same, other)] == [[False], [True]]
    assert agree(segments(moving, [same, other, same])) == 2  # their degree is not known in floats
    half = Pose(quaternion=(F(-1), F(0), F(0), F(3)))
    with pytest.raises(InputError, match="by exactly 180°"):
        segments(moving, [same, half])
    assert len(segments(moving, [other, half])) == 1
    short, long = (Pose(quaternion=(n, n / 7, F(0), F(0))) for n in (F(1, 10**120), F(10**120)))
    assert np.allclose(segments(moving, [same, short, same, long]).motions.q1[1], [3e-120 / np.sqrt(10), 0, 0, 0], 1)
