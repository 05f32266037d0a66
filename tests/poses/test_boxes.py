"""Maps of whole boxes: what is proved of them, against determinants and joints that share nothing with the models."""

from __future__ import annotations

import itertools
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.boxes.deciding import Boxes
from gcrules.poses.boxes.forms import box_forms
from gcrules.poses.boxes.report import BoxMap
from gcrules.poses.boxes.task import BoxTask, box_task
from gcrules.poses.boxes.taylor import models
from gcrules.poses.boxes.trees import leaves_of
from gcrules.poses.compiling.closed_forms import run
from gcrules.poses.compiling.scalars import Graph
from gcrules.poses.compiling.tape import lower

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")


def answer(*args: Any, **options: Any) -> BoxMap:
    found = gc.box_map(*args, **options)
    assert isinstance(found, BoxMap)
    return found


@cache
def planar() -> BoxMap:
    return answer("3-rpr", ["x -0.5:0.5", "yaw -60:80 deg"], limits="actuators -0.6..0.6", tiles=4, boxes=1023)


def legs_determinant(points: np.ndarray, base: np.ndarray) -> Any:
    """Of the Plücker coordinates of legs from base (6, 3) to platform points (6, 3)."""
    along = points - base
    return np.linalg.det(np.concatenate([along, np.cross(base, along)], axis=1))


class TestModels:
    def test_hold_values_at_random(self) -> None:
        graph = Graph(3)
        x, y, z = graph.inputs
        c, s = z.cosine_and_sine()
        program = lower(
            graph, (x * y + c) * (x - s), (x + 3).root(), (y * y + 2).inverse(), c * s * x, 2 - (-z * x) * y
        )
        rng = np.random.default_rng(1)
        middles, halves = rng.uniform(-1, 1, (200, 3)), rng.uniform(0, 0.5, (200, 3))
        found = models(program, middles, halves, (0, 1, 2))
        low, high = found.ranges()
        for corner in itertools.product((-1, 0, 1), repeat=3):
            values = run(program, "numpy", middles + np.array(corner) * halves)
            assert ((low <= values) & (values <= high)).all()
        for _ in range(20):
            values = run(program, "numpy", middles + rng.uniform(-1, 1, (200, 3)) * halves)
            assert ((low <= values) & (values <= high)).all()

    def test_are_of_second_order(self) -> None:
        """Halving a box makes what is left out eight times smaller."""
        graph = Graph(2)
        x, y = graph.inputs
        program = lower(graph, ((x * x + y * y + 1).root() + x * y).inverse())
        one, other = (models(program, np.array([[0.3, 0.7]]), np.full((1, 2), h), (0, 1)) for h in (0.02, 0.01))
        assert 7 < one.rest[0, 0] / other.rest[0, 0] < 9

    def test_roots_and_quotients_that_may_not_exist(self) -> None:
        graph = Graph(1)
        (x,) = graph.inputs
        program = lower(graph, x.root(), x.inverse())
        found = models(program, np.array([[0.1], [-1.0], [2.0]]), np.array([[0.2], [0.2], [0.2]]), (0,))
        assert found.exists.tolist() == [False, False, True]
        assert found.unreached.tolist() == [False, True, False]
        assert found.influence[0].tolist()[0] > 0

    def test_coordinates_that_are_not_free_stay(self) -> None:
        graph = Graph(2)
        x, y = graph.inputs
        found = models(lower(graph, x * y), np.array([[2.0, 3.0]]), np.array([[9.0, 0.5]]), (1,))
        low, high = found.ranges()
        assert (low[0, 0], high[0, 0]) == (pytest.approx(5), pytest.approx(7))


class TestTrees:
    def test_leaves_fill_the_tile(self) -> None:
        found = planar()
        for tile in range(found.task.number):
            leaves = found.leaves(tile)
            assert leaves.shares.sum() == 1
            volume = (2 * leaves.boxes.halves).prod(axis=1).sum()
            assert volume == pytest.approx((2 * found.task.box(tile).halves).prod())

    def test_zeros_at_the_end_are_nothing(self) -> None:
        whole = Boxes(np.zeros((1, 2)), np.ones((1, 2)))
        one, other = (leaves_of(np.array(c, np.uint8), whole) for c in ([1, 16, 18], [1, 16, 18, 0, 0]))
        assert one.status.tolist() == other.status.tolist() == [0, 2]


class TestLegs:
    """Against a determinant of Plücker coordinates that is written here."""

    def test_free_boxes_have_one_sign(self) -> None:
        over = ["x -300:300", "z -500:100", "roll -30:30 deg"]
        found = answer(OCTAHEDRAL, over, tiles=3, boxes=511)
        platform = mechanism(OCTAHEDRAL)
        rig = platform.six_legs().rig
        rng = np.random.default_rng(3)
        signs: dict[bool, set[float]] = {False: set(), True: set()}
        crossed = 0
        for tile in range(found.task.number):
            leaves = found.leaves(tile)
            for k in range(len(leaves.status)):
                m, h = leaves.boxes.middles[k], leaves.boxes.halves[k]
                seen = set()
                for e in (*itertools.product((-1, 1), repeat=3), *rng.uniform(-1, 1, (6, 3))):
                    x, z, roll = m + np.array(e) * h
                    turn = np.array([[1, 0, 0], [0, np.cos(roll), -np.sin(roll)], [0, np.sin(roll), np.cos(roll)]])
                    ends = rig.arms @ turn.T + rig.centre_of_turns + np.array([x, 0, z])
                    seen.add(float(np.sign(legs_determinant(ends, rig.base))))
                if leaves.status[k] == 0:
                    signs[bool(leaves.negative[k])] |= seen
                crossed += leaves.status[k] == 1
        assert [len(s) for s in signs.values()] == [1, 1]
        assert signs[False] != signs[True]
        assert crossed
        assert found.verdict == "singular"
        assert "Both signs" in found.text()

    def test_limits_of_lengths(self) -> None:
        over = ["x -300:300", "y -300:300", "z -500:200"]
        found = answer(OCTAHEDRAL, over, limits="leg lengths 250..420", tiles=2, boxes=1023)
        rig = mechanism(OCTAHEDRAL).six_legs().rig
        rng = np.random.default_rng(4)
        kinds = {"outside": 0, "inside": 0}
        for tile in range(found.task.number):
            leaves = found.leaves(tile)
            inside = found.task.decider.reached(leaves.boxes)[1]
            for k in range(len(leaves.status)):
                places = leaves.boxes.middles[k] + rng.uniform(-1, 1, (5, 3)) * leaves.boxes.halves[k]
                lengths = np.linalg.norm(rig.arms + rig.centre_of_turns + places[:, None] - rig.base, axis=2)
                kept = ((lengths >= 250) & (lengths <= 420)).all(axis=1)
                if leaves.status[k] == 3:
                    assert not kept.any()
                    kinds["outside"] += 1
                elif inside[k]:
                    assert kept.all()
                    kinds["inside"] += 1
        assert all(kinds.values())

    def test_at_a_pose_the_rest_is_that_pose(self) -> None:
        found = answer(OCTAHEDRAL, ["x -10:10"], at="0 20 30; euler ZYX 10 5 -5 deg", tiles=1, boxes=1)
        rest = found.to_json()["rest"]
        assert (rest["y"], rest["z"]) == (20, 30)
        assert [round(np.degrees(rest[n]), 9) for n in ("yaw", "pitch", "roll")] == [10, 5, -5]

    def test_a_margin_is_kept(self) -> None:
        over = ["x -200:200", "z -300:100", "yaw -20:20 deg"]
        found = answer(OCTAHEDRAL, over, margin=0.2, tiles=2, boxes=1023)
        assert found.summary.bound is not None
        assert found.summary.bound >= 0.2 - 1e-6
        rng = np.random.default_rng(5)
        places = []
        for lower_ends, upper_ends, status in found.boxes("free"):
            assert not status.any()
            for a, b in zip(lower_ends, upper_ends, strict=True):
                places += [a + (b - a) * rng.random(3), a, b]
        poses = gc.pose(
            OCTAHEDRAL, [[x, 0, z] for x, z, _ in places], euler=("zyx", [[t, 0, 0] for *_, t in places]), degrees=True
        )
        margins = np.asarray(poses.margin)
        assert len(margins) > 50
        assert margins.min() >= 0.2 - 1e-9

    def test_a_margin_of_joints_is_kept(self) -> None:
        """Limbs with one wrench, with two, and in the plane."""
        for robot, over, margin in (
            ("3-rpr", ["x -0.2:0.2", "y -0.2:0.2", "yaw -20:5 deg"], 0.1),
            ("3-rps", ["z -0.1:0.1", "roll -10:10 deg", "pitch -10:10 deg"], 0.05),
            ("delta", ["x -0.3:0.3", "y -0.3:0.3", "z -0.3:0.3"], 0.1),
        ):
            found = answer(robot, over, margin=margin, tiles=1, boxes=4095)
            assert found.summary.shares[0] > 0.5
            assert found.summary.bound >= margin
            ends = [(a, b) for low, high, _ in found.boxes("free") for a, b in zip(low, high, strict=True)][:200]
            units = np.array([np.pi / 180 if a.unit == "deg" else 1.0 for a in found.axes])
            places = np.concatenate([[a for a, _ in ends], [b for _, b in ends]]) * units
            value = gc.compiled(robot, coordinates=", ".join(a.name for a in found.axes))
            numbers = value.numbers(places, "margins")["margins"]
            assert np.nanmin(numbers) >= margin - 1e-9


class TestRobots:
    """Against the joints, whose loops are closed by Newton's method."""

    @pytest.mark.parametrize(
        ("robot", "over"),
        [
            ("3-rpr", ["x -0.5:0.5", "y -0.3:0.3", "yaw -60:60 deg"]),
            ("3-rps", ["z -0.4:0.4", "roll -40:40 deg", "pitch -40:40 deg"]),
            ("delta", ["x -0.8:0.8", "y -0.8:0.8", "z -0.5:0.5"]),
            ("agile-eye", ["roll -40:40 deg", "pitch -40:40 deg", "yaw -40:40 deg"]),
            ("4-rpr", ["x -0.4:0.4", "y -0.4:0.4", "yaw -50:50 deg"]),
        ],
    )
    def test_free_poses_are_regular_and_of_one_sign(self, robot: str, over: list[str]) -> None:
        found = answer(robot, over, tiles=2, boxes=255)
        rng = np.random.default_rng(6)
        places, negative = [], []
        for tile in range(found.task.number):
            leaves = found.leaves(tile)
            for k in np.flatnonzero(leaves.status == 0)[:12]:
                e = rng.uniform(-1, 1, (2, 3))
                places += list(leaves.boxes.middles[k] + e * leaves.boxes.halves[k])
                negative += [leaves.negative[k]] * 2
        value = gc.compiled(robot, coordinates=", ".join(a.name for a in found.axes))
        numbers = value.numbers(np.array(places), "margins, signs, proved")
        sure = numbers["proved"] & np.isfinite(numbers["margins"])
        assert sure.sum() > len(places) // 3
        assert numbers["margins"][sure].min() > 1e-6
        signs = numbers["signs"][sure]
        if robot != "4-rpr":
            assert ((signs < 0) == np.array(negative)[sure])[signs != 0].all()

    def test_limits_of_actuators(self) -> None:
        found = planar()
        value = gc.compiled("3-rpr")
        rng = np.random.default_rng(7)
        outside = 0
        for tile in range(found.task.number):
            leaves = found.leaves(tile)
            for status, inside, m, h in zip(
                leaves.status,
                found.task.decider.reached(leaves.boxes)[1],
                leaves.boxes.middles,
                leaves.boxes.halves,
                strict=True,
            ):
                x, yaw = (m + rng.uniform(-1, 1, (3, 2)) * h).T
                amounts = value.actuator_values(np.stack([x, np.zeros(3), yaw], axis=1))
                kept = (np.abs(amounts) <= 0.6).all(axis=1)
                assert not (status == 3 and kept.any())
                assert not (inside and not kept.all())
                outside += status == 3
        assert outside

    def test_a_singular_pose_lies_in_no_free_box(self) -> None:
        singular = gc.singular("3-rpr", "x=0, y=0, yaw=60deg")
        assert singular is not None
        yaw = np.degrees(singular.coordinates["yaw"])
        found = answer("3-rpr", ["x -0.1:0.1", "y -0.1:0.1", "yaw -60:80 deg"], tiles=2, boxes=4095)
        assert found.status([0, 0, yaw]) in ("crossed", "undecided")
        assert found.status([0, 0, 0]) == "free"

    def test_what_has_no_closed_form_is_said(self) -> None:
        with pytest.raises(InputError, match="have no closed form") as fault:
            gc.box_map("tricept", ["x -0.1:0.1", "y -0.1:0.1"])
        assert "gcrules free" in str(fault.value.hint)


class TestQuestions:
    @pytest.mark.parametrize(
        ("over", "words"),
        [
            (["x 1:-1"], "the range of x is reversed"),
            (["x 0:1:5"], "is not a range"),
            (["x 0:1", "x 0:1"], "given twice"),
            (["rx 0:1 deg"], "range over rx"),
            (["q1 0:1"], "range over q1"),
            (["yaw 0:400 deg"], "round more than once"),
            ([], "one to six coordinates"),
        ],
    )
    def test_faults(self, over: list[str], words: str) -> None:
        with pytest.raises(InputError, match=words):
            box_task(mechanism("3-rpr"), over)

    @pytest.mark.parametrize("given", [{"margin": 1.5}, {"tiles": 0}, {"boxes": 0}, {"margin": -0.1}])
    def test_numbers(self, given: dict[str, Any]) -> None:
        with pytest.raises(InputError):
            box_task(mechanism("3-rpr"), ["x 0:1"], **given)

    @pytest.mark.parametrize("limits", ["actuators 300..400 deg", "q1 -800..0 deg"])
    def test_limits_more_than_a_turn_away(self, limits: str) -> None:
        """No pose tells how often a drive has turned round."""
        with pytest.raises(InputError, match="of q1 are more than a turn from home"):
            box_task(mechanism("6-rus"), ["yaw -5:5 deg"], limits=limits)

    def test_six_legs_that_are_limbs_are_a_platform(self) -> None:
        """As in maps over nodes: limits are lengths of legs, which amounts from home are not."""
        over = ["x -1:1", "yaw -20:20 deg"]
        found = gc.box_map("gough-stewart", over, limits="leg lengths 3..9", boxes=15)
        assert found.task.question.limits is not None
        assert not found.task.question.limits.angles
        with pytest.raises(InputError, match="'actuators' is not a leg"):
            gc.box_map("gough-stewart", over, limits="actuators -1..1")

    def test_tiles_have_exact_ends(self) -> None:
        task: BoxTask = box_task(mechanism("3-rpr"), ["x 0:1"], tiles=3)
        assert [a.nodes.tolist() for a in task.question.axes] == [[0, float(Fraction(1, 3)), float(Fraction(2, 3)), 1]]
        assert task.grid == (3,)


class TestStores:
    def test_refined_and_extended_as_computed_at_once(self, tmp_path: Path) -> None:
        pytest.importorskip("zarr")
        over = ["x -0.4:0.4", "yaw -60:60 deg"]
        gc.box_map("3-rpr", over, tiles=4, boxes=63, work=tmp_path / "coarse.zarr")
        gc.refine_map(tmp_path / "coarse.zarr", tmp_path / "fine.zarr", 255)
        gc.box_map("3-rpr", over, tiles=4, boxes=255, work=tmp_path / "direct.zarr")
        assert files(tmp_path / "fine.zarr") == files(tmp_path / "direct.zarr")
        gc.refine_map(tmp_path / "fine.zarr", tmp_path / "wide.zarr", over=["x -0.6:0.4"])
        wide = [f"x -0.6:0.4:{6}", "yaw -60:60:5 deg"]
        gc.box_map("3-rpr", [gc_axis(w) for w in wide], boxes=255, work=tmp_path / "wide-direct.zarr")
        assert files(tmp_path / "wide.zarr") == files(tmp_path / "wide-direct.zarr")

    def test_ranges_that_cut_tiles_are_refused(self, tmp_path: Path) -> None:
        pytest.importorskip("zarr")
        gc.box_map("3-rpr", ["x -0.4:0.4"], tiles=4, boxes=3, work=tmp_path / "a.zarr")
        with pytest.raises(InputError, match="not of whole tiles"):
            gc.refine_map(tmp_path / "a.zarr", tmp_path / "b.zarr", over=["x -0.5:0.4"])
        with pytest.raises(InputError, match="fewer than"):
            gc.refine_map(tmp_path / "a.zarr", tmp_path / "b.zarr", 1)

    def test_is_verified_and_read_by_xarray(self, tmp_path: Path) -> None:
        xarray = pytest.importorskip("xarray")
        pytest.importorskip("zarr")
        found = answer("3-rpr", ["x -0.4:0.4", "yaw -60:60 deg"], tiles=3, boxes=63, work=tmp_path / "a.zarr")
        assert gc.verify_map(tmp_path / "a.zarr", "all").sound
        data = xarray.open_zarr(tmp_path / "a.zarr", consolidated=False)
        assert data.share.dims == ("x", "yaw", "status")
        assert data.share.mean(("x", "yaw")).values.tolist() == pytest.approx(list(found.summary.shares))
        assert found.to_xarray().share.equals(data.share.load())


def files(folder: Path) -> dict[str, bytes]:
    return {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}


def gc_axis(text: str) -> Any:
    from gcrules.poses.maps.axes import parse_axis

    return parse_axis(text)


class TestTruth:
    """What once was false."""

    def test_both_signs_apart_by_limits_are_free(self) -> None:
        found = answer("3-rpr", ["yaw 0:150 deg"], limits="q1 -0.26..9", tiles=4, boxes=4000)
        free, other, outside, crossed, undecided = found.summary.shares
        assert free
        assert other
        assert outside
        assert (crossed, undecided) == (0, 0)
        assert found.verdict == "free"
        assert "or poses that are not reached within the limits" in found.text().replace("\n", " ").replace("   ", " ")

    def test_a_singular_pose_beyond_the_limits_is_none(self) -> None:
        found = answer(
            "3-rpr", ["yaw 15.713425:18.213425 deg"], limits="q1 -0.257031..-0.244350", tiles=1, boxes=1
        )  # that at 17.7134 deg has q1 = -0.267
        assert found.summary.shares[3] == 0

    def test_where_reach_is_not_seen_nothing_is_crossed_or_inside(self) -> None:
        """The wrenches of these robots are told by the platform alone, whether their elbows reach or not."""
        far = ["x -4.0625:-3.75", "y -2.8125:-2.5", "z -2.1875:-1.875"]
        assert answer("3-uru", far, tiles=1, boxes=1).summary.shares[3] == 0
        found = answer("quadrupteron", ["x 1.5:2", "y -1.5:-1", "yaw 60:88 deg"], limits="actuators -5..5", tiles=1)
        assert not found.task.decider.reached(found.leaves(0).boxes)[1].any()

    def test_reach_is_seen(self) -> None:
        """Of robots whose links are placed by roots, or whose limbs stretch; and Newton's method agrees."""
        seen = {
            name: box_forms(m, free_coordinates(m.linkage)).reached
            for name in ("6-rus", "delta", "3-rps", "3-rpr", "gough-stewart", "3-uru", "quadrupteron")
            for m in (mechanism(name),)
            if isinstance(m, Limbs)
        }
        assert [name for name, known in seen.items() if not known] == ["3-uru", "quadrupteron"]

    def test_regular_matrices_have_a_sign_however_small(self) -> None:
        legs = str(EXAMPLES / "platform-6-6.yaml")
        found = answer(legs, ["z 1999:2000", "yaw -100:100 deg"], tiles=2, boxes=511)
        rig = mechanism(legs).six_legs().rig
        signs: set[int] = set()
        for tile in range(found.task.number):
            leaves = found.leaves(tile)
            for k in np.flatnonzero(leaves.status == 0):
                z, yaw = leaves.boxes.middles[k]
                c, s = np.cos(yaw), np.sin(yaw)
                turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
                ends = rig.arms @ turn.T + rig.centre_of_turns + np.array([0, 0, z])
                here, home = exact_sign(ends, rig.base), exact_sign(rig.arms + rig.centre_of_turns, rig.base)
                assert bool(leaves.negative[k]) == (here != home)
                signs.add(here)
        assert signs == {-1, 1}

    def test_bounds_are_not_rounded_up(self) -> None:
        bounds = 0
        for start in np.linspace(-0.4, 0.4, 12):
            found = answer("3-rpr", [f"x {start}:{start + 1e-9}"], margin=0.001, tiles=1, boxes=1)
            if found.summary.bound is None:
                continue
            true = gc.compiled("3-rpr").margins([[start + t * 1e-9, 0, 0] for t in np.linspace(0, 1, 5)])
            assert found.summary.bound <= true.min() + 1e-13
            bounds += 1
        assert bounds > 6


def exact_sign(ends: np.ndarray, base: np.ndarray) -> int:
    """Of the determinant in Fractions, of floats as the numbers that they are."""
    rows = []
    for p, b in zip(ends.tolist(), base.tolist(), strict=True):
        f = [Fraction(x) - Fraction(y) for x, y in zip(p, b, strict=True)]
        q = [Fraction(c) for c in b]
        rows.append([*f, q[1] * f[2] - q[2] * f[1], q[2] * f[0] - q[0] * f[2], q[0] * f[1] - q[1] * f[0]])
    sign = 1
    for k in range(6):
        pivot = next((r for r in range(k, 6) if rows[r][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            rows[k], rows[pivot], sign = rows[pivot], rows[k], -sign
        for r in range(k + 1, 6):
            factor = rows[r][k] / rows[k][k]
            rows[r] = [a - factor * c for a, c in zip(rows[r], rows[k], strict=True)]
        sign *= 1 if rows[k][k] > 0 else -1
    return sign
