"""Compiled conditions: exactly the superbracket in exact arithmetic, within rounding in floats, the same by engine."""

from __future__ import annotations

import pickle
import subprocess
import sys
import tracemalloc
from collections.abc import Callable
from dataclasses import FrozenInstanceError, dataclass
from fractions import Fraction
from functools import partial
from importlib.util import find_spec
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from places import EXAMPLES
from poses.platforms import PLATFORMS

import gcrules as gc
from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.superbrackets.shortest import superbracket_form
from gcrules.core.errors import EngineFault, InputError
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.poses.compiling import compiled as module
from gcrules.poses.compiling import engines
from gcrules.poses.compiling.compiled import CompiledCondition, compiled
from gcrules.poses.compiling.native import native
from gcrules.poses.compiling.scalars import Graph, Scalar
from gcrules.poses.compiling.tape import Operation, Program, allocated, lower
from gcrules.poses.compiling.tracing import Joints, trace
from gcrules.poses.compiling.vectors import of_expression, of_legs, of_polynomial
from gcrules.poses.numbers.arrays import matrices
from gcrules.poses.numbers.cubic import superbracket_at
from gcrules.screws.rotations import rotation

F = Fraction
small = st.integers(-6, 6)
needs_numba = pytest.mark.skipif(find_spec("numba") is None, reason="numba is not installed")


@pytest.fixture(scope="module")
def values(robots: dict[str, Any]) -> dict[str, CompiledCondition]:
    return {n: compiled(a, about="origin", engine="numpy") for n, a in robots.items() if n in PLATFORMS}


def poses(number: int, seed: int = 0, size: float = 100) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Translations, matrices and quaternions of the same turns."""
    rng = np.random.default_rng(seed)
    q = rng.normal(size=(number, 4))
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    return rng.normal(size=(number, 3)) * size, matrices(q), q


# --- the graph and the tape ----------------------------------------------------------------------------------------


@st.composite
def graphs(draw: st.DrawFn) -> tuple[Graph, Any]:
    """A random polynomial, given by the operations that make it."""
    graph = Graph(4)
    values: list[Any] = [*graph.inputs, 0, 1, F(2, 3)]
    for _ in range(draw(st.integers(1, 25))):
        a, b = (values[draw(st.integers(max(0, len(values) - 8), len(values) - 1))] for _ in range(2))
        kind = draw(st.sampled_from(("add", "sub", "mul", "neg", "add", "sub")))
        values.append({"add": a + b, "sub": a - b, "mul": a * b, "neg": -a}[kind])
    return graph, values[-1]


def direct(graph: Graph, value: Any, inputs: list[Any]) -> Any:
    """The value of a node by going down the graph."""
    if not isinstance(value, Scalar):
        return value
    op, a, b = graph.nodes[value.node]
    one = inputs[a] if op == "input" else direct(graph, Scalar(graph, 1, a), inputs)
    two = direct(graph, Scalar(graph, 1, int(b)), inputs) if op in ("add", "sub", "mul") else b
    found = {"input": one, "add": one + two, "shift": one + two, "sub": one - two}.get(op, one * two)
    return value.sign * found


@settings(max_examples=80, deadline=None)
@given(graphs(), st.lists(small, min_size=4, max_size=4))
def test_programs_compute_what_was_traced(traced: tuple[Graph, Any], inputs: list[int]) -> None:
    graph, value = traced
    program = lower(graph, value)
    assert program.exact(inputs) == (direct(graph, value, inputs),)
    assert len(set(program.lines)) == len(program.lines)  # nothing twice
    used = {n for line in program.lines for n in line.operands}
    assert used == set(range(len(program.lines) - 1))  # nothing in vain
    held, count = allocated(program)
    registers: list[Any] = [None] * count
    for n, line in enumerate(program.lines):
        assert held[n] not in {held[m] for m in line.operands}
        assert all(registers[held[m]] == m for m in line.operands)  # no operand was overwritten
        registers[held[n]] = n


def test_maps_of_few_poses_do_not_wait_for_machine_code() -> None:
    assert engines.engine_for(10_000) == "numpy"
    assert engines.engine_for(10_000_000) == engines.engine_named(None)
    source = (
        "import sys, gcrules as gc\n"
        "found = gc.singular_map(sys.argv[1], ['x -9:9:5', 'y -9:9:5'])\n"
        "print(found.to_json()['schema'], 'numba' in sys.modules)"
    )
    command = [sys.executable, "-c", source, str(EXAMPLES / "octahedral.yaml")]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()[-1] == "False"


@needs_numba
@settings(max_examples=10, deadline=None)
@given(graphs(), st.integers(0, 2**32 - 1))
def test_machine_code_gives_the_same_bits(traced: tuple[Graph, Any], seed: int) -> None:
    program = lower(*traced)
    if not program.lines:
        return
    data = np.random.default_rng(seed).normal(size=(61, 4))
    found = []
    for run in (engines._numpy(program), native(program)):
        out = np.empty((1, 61))
        with np.errstate(all="ignore"):
            run(data[:, :1], data[:, 1:], out)
        found.append(out[0])
    one, other = found
    assert np.array_equal(one, other, equal_nan=True)


@needs_numba
def test_every_operation_has_its_instruction() -> None:
    lines = [Operation("input", (k,)) for k in range(4)]
    lines += [
        Operation("mul", (0, 1)),
        Operation("scale", (2,), F(3)),
        Operation("inv", (3,)),
        Operation("shift", (4,), F(-1, 2)),
    ]
    lines += [Operation("add", (5, 6)), Operation("sub", (7, 8))]
    data = np.array([[2.0, 3, 4, 8], [1, -2, 0.5, 2]])
    for k in range(1, len(lines) + 1):
        program = Program(4, tuple(lines[:k]), tuple(range(k)))
        out = np.empty((k, 2))
        native(program)(data, np.empty((2, 0)), out)
        assert out.T.tolist() == [list(program.exact(row)) for row in data.tolist()]


@needs_numba
@pytest.mark.parametrize("layout", ["rows", "columns", "gaps", "backwards", "one row", "not aligned"])
def test_machine_code_takes_any_memory(layout: str) -> None:
    """Every number of poses about the width of a vector, and nothing written beside the values."""
    program = Program(
        3, (*(Operation("input", (k,)) for k in range(3)), Operation("sub", (0, 1)), Operation("mul", (2, 3))), (4, 3)
    )
    run = native(program)
    for n in (1, 2, 7, 8, 9, 15, 16, 17, 24, 25):
        x = np.random.default_rng(n).normal(size=(n, 3))
        packed = np.frombuffer(b"." + x.tobytes(), dtype=np.float64, offset=1).reshape(n, 3)
        given_x = {
            "rows": x,
            "columns": np.asfortranarray(x),
            "gaps": np.repeat(np.repeat(x, 2, axis=0), 3, axis=1)[::2, ::3],
            "backwards": x[::-1].copy()[::-1],
            "one row": np.broadcast_to(x[0], (n, 3)),
            "not aligned": packed,
        }[layout]
        whole = np.full((4, 2 * n + 2), 7.0)
        for out in (whole[1:3, 1 : n + 1], whole[1:3, 1:-1:2], whole[2:0:-1, 1 : n + 1], whole[::2, :n]):
            whole[:] = 7
            run(given_x[:, :1], given_x[:, 1:], out)
            less = given_x[:, 0] - given_x[:, 1]
            assert np.array_equal(out, [given_x[:, 2] * less, less])
            assert (whole == 7).sum() == whole.size - 2 * n


# --- exact: the program is the superbracket ------------------------------------------------------------------------


@st.composite
def mechanisms(draw: st.DrawFn) -> tuple[Any, Joints]:
    """Six legs between few joints, which often share them; or, half the time, among any joints (odd cycles)."""
    if draw(st.booleans()):
        joints = st.sampled_from("abcdef")
        legs = [draw(st.tuples(joints, joints).filter(lambda leg: leg[0] != leg[1])) for _ in range(6)]
        structure = read_legs(legs)
        return structure, Joints({}, structure.names, {})
    base, ends = st.sampled_from("ABCDEF"[: draw(st.integers(2, 6))]), st.sampled_from("abcdef")
    structure = read_legs([draw(st.tuples(base, ends)) for _ in range(6)])
    place = st.tuples(*[st.fractions(-5, 5, max_denominator=3)] * 3)
    fixed = {n: draw(place) for n in structure.names if n.isupper()}
    arms = {n: draw(place) for n in structure.names if n.islower()}
    return structure, Joints(fixed, tuple(arms), arms, draw(place))


def roads(structure: Any) -> list[Any]:
    form = superbracket_form(structure.legs, range(6), 16, points=structure.points)
    return [
        ("legs", lambda places: of_legs(structure.legs, places)),
        ("form", lambda places: of_polynomial(form.polynomial, places)),
        ("written", lambda places: of_expression(structure.superbracket, places)),
    ]


@settings(max_examples=30, deadline=None)
@given(mechanisms(), st.data())
def test_programs_are_exactly_the_superbracket(made: tuple[Any, Joints], data: st.DataObject) -> None:
    structure, joints = made
    shift = data.draw(st.tuples(small, small, small))
    q = data.draw(st.tuples(st.integers(1, 5), small, small, small))
    places = data.draw(st.lists(st.tuples(small, small, small), min_size=6, max_size=6))
    turn = rotation(tuple(map(F, q)))
    for kind in joints.kinds:
        if kind == "joints":
            moved = dict(zip(joints.moving, places, strict=False))
            inputs = [c for n in joints.moving for c in moved[n]]
        else:
            moved = {
                n: tuple(
                    sum(r * c for r, c in zip(row, joints.arms[n], strict=True)) + c + t
                    for row, c, t in zip(turn, joints.centre, shift, strict=True)
                )
                for n in joints.moving
            }
            inputs = [*shift, *(q if kind == "quaternions" else [c for row in turn for c in row])]
        points = {n: (*p, 1) for n, p in {**joints.fixed, **moved}.items()}
        expected = superbracket_at(structure.legs, points)
        for road in roads(structure):
            _, program = trace(joints, kind, [road], structure.superbracket)
            assert program.exact(list(map(F, inputs))) == (expected,)


def test_a_wrong_road_is_found_out() -> None:
    structure = read_legs("ab af cb cd ed ef")
    joints = Joints({}, structure.names, {})
    with pytest.raises(EngineFault, match="disagree"):
        trace(joints, "joints", [("", lambda p: 2 * of_legs(structure.legs, p))], structure.superbracket)


@pytest.mark.parametrize(
    "text",
    [
        "[abcd][cdef] - 3[abce]**2",
        r"(ab /\ cd)(acd /\ e) + 1/2 [acef] [bdac]",
        r"abc /\ def /\ abd /\ cef",
        r"[(ab /\ cde) c d f]",
        "[[ab, cd, ef, ac, bd, ae]]",
        "7",
        "[abca] + 0",
    ],
)
def test_any_scalar(robots: dict[str, Any], text: str) -> None:
    points = random_rational_points("abcdef", seed=3)
    analysis = robots["octahedral"]
    found = compiled(gc.analyze(analysis.structure), text, engine="numpy")
    joints = {n: np.array([points[n][:3]], dtype=float) for n in found.joints}
    assert found.at_joints(joints)[0] == float(evaluate(gc.parse(text), points))
    at_rest = evaluate(gc.parse(text), analysis.platform.homogeneous())
    assert compiled(analysis, text, engine="numpy")()[0] == pytest.approx(float(at_rest), rel=1e-12)


# --- floats --------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Sized:
    """A number and the sum of the absolute values of all that it was summed from."""

    value: Any
    size: Any

    def __add__(self, other: Any) -> Sized:
        o = other if isinstance(other, Sized) else Sized(other, abs(other))
        return Sized(self.value + o.value, self.size + o.size)

    def __sub__(self, other: Sized) -> Sized:
        return Sized(self.value - other.value, self.size + other.size)

    def __mul__(self, other: Any) -> Sized:
        o = other if isinstance(other, Sized) else Sized(other, abs(other))
        return Sized(self.value * o.value, self.size * o.size)


@pytest.mark.parametrize("name", PLATFORMS)
def test_floats_are_exact_within_rounding(robots: dict[str, Any], values: dict[str, Any], name: str) -> None:
    value, platform = values[name], robots[name].platform
    shifts, turns, _ = poses(40, seed=5)
    found = value(shifts, turns)
    program = value.programs["matrices"]
    for shift, turn, number in zip(shifts, turns, found, strict=True):
        inputs = [F(c) for c in (*shift, *turn.ravel())]  # floats are rational numbers: no rounding on the way in
        moved = {
            n: tuple(
                sum((r * c for r, c in zip(inputs[3 + 3 * k : 6 + 3 * k], platform.points[n], strict=True)), inputs[k])
                for k in range(3)
            )
            for n in value.joints
        }
        points = {n: (*p, F(1)) for n, p in {**platform.points, **moved}.items()}
        exact = superbracket_at(robots[name].structure.legs, points)
        (sized,) = program.exact([Sized(c, abs(c)) for c in inputs])
        assert sized.value == exact
        assert abs(F(float(number)) - exact) <= sized.size * 40 * F(1, 2**53)  # at most 40 roundings on a path


@pytest.mark.parametrize("name", PLATFORMS)
def test_poses_may_be_given_in_three_ways(robots: dict[str, Any], values: dict[str, Any], name: str) -> None:
    value, analysis = values[name], robots[name]
    reach = max(float(abs(c)) for p in analysis.platform.points.values() for c in p)
    shifts, turns, q = poses(300, size=reach)
    found = value(shifts, turns)
    size = np.abs(found).max()
    assert np.allclose(value(shifts, quaternions=q), found, rtol=0, atol=1e-12 * size)
    at = {n: np.array([float(c) for c in analysis.platform.points[n]]) for n in value.joints}
    joints = {n: turns @ p + shifts for n, p in at.items()}
    assert np.allclose(value.at_joints(joints), found, rtol=0, atol=1e-12 * size)
    assert np.array_equal(value.at_joints(np.stack([joints[n] for n in value.joints], axis=1)), value.at_joints(joints))
    assert np.allclose(
        gc.pose(analysis, shifts, quaternion=q, about="origin", nearest=False).value, found, rtol=0, atol=1e-12 * size
    )


@pytest.mark.parametrize("about", ["centroid", (1, "2.5", -3)])
def test_the_centre_is_that_of_pose(robots: dict[str, Any], about: Any) -> None:
    value = compiled(robots["octahedral"], about=about)
    shifts, _, q = poses(20)
    expected = gc.pose(robots["octahedral"], shifts, quaternion=q, about=about, nearest=False).value
    assert np.allclose(value(shifts, quaternions=q), expected, rtol=1e-9)


def test_memory_and_chunks_do_not_matter(values: dict[str, Any], monkeypatch: pytest.MonkeyPatch) -> None:
    value = values["octahedral"]
    shifts, turns, _ = poses(1300)
    expected = value(shifts, turns)
    assert turns.strides[0] == 8  # an array of columns
    monkeypatch.setattr(module, "STEP", 512)
    monkeypatch.setattr(engines, "CACHE", 1)
    rows = np.ascontiguousarray(turns)
    out = np.empty(2600)[::2]
    for given_turns in (turns, rows, np.asfortranarray(rows), np.repeat(rows, 2, axis=0)[::2], rows[::-1][::-1]):
        assert np.array_equal(value(shifts, given_turns), expected)
        assert value(shifts, given_turns, out=out) is out
        assert np.array_equal(out, expected)
    assert np.array_equal(value(shifts, turns)[::-1], value(shifts[::-1], turns[::-1]))


def test_kinds_of_numbers(values: dict[str, Any]) -> None:
    value = values["platform-6-6"]
    whole = np.arange(30).reshape(10, 3) % 7
    expected = value(whole.astype(float))
    for shifts in (whole, whole.tolist(), whole.astype(np.int8), whole.astype(np.float32), whole.astype(object)):
        assert np.array_equal(value(shifts), expected)
    assert np.array_equal(value([F(1, 2)] * 3), value([[0.5, 0.5, 0.5]]))


def test_one_row_stands_for_all(values: dict[str, Any]) -> None:
    value = values["octahedral"]
    shifts, turns, q = poses(5)
    assert np.array_equal(value(shifts), value(shifts, np.repeat(np.eye(3)[None], 5, axis=0)))
    assert np.array_equal(value(shifts[0], turns), value(shifts[:1].repeat(5, axis=0), turns))
    assert np.array_equal(value(shifts, quaternions=q[2]), value(shifts, quaternions=q[2:3].repeat(5, axis=0)))
    assert value().shape == value((1, 2, 3)).shape == (1,)


def test_no_poses(values: dict[str, Any]) -> None:
    value = values["octahedral"]
    assert value([]).shape == value(np.empty((0, 3)), np.empty((0, 3, 3))).shape == (0,)
    assert value(quaternions=[]).shape == value.at_joints(np.empty((0, 3, 3))).shape == (0,)


def test_memory(values: dict[str, Any]) -> None:
    shifts = np.zeros((400_000, 3), dtype=np.float32)
    out = np.empty(400_000)
    tracemalloc.start()
    try:
        values["platform-6-6"](shifts, out=out)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 16e6  # bytes, however many poses there are


# --- engines -------------------------------------------------------------------------------------------------------


@needs_numba
@pytest.mark.parametrize("name", PLATFORMS)
def test_engines_agree_to_the_last_bit(robots: dict[str, Any], values: dict[str, Any], name: str) -> None:
    fast = compiled(robots[name], engine="numba", about="origin")
    shifts, turns, q = poses(1000)
    assert np.array_equal(fast(shifts, turns), values[name](shifts, turns))
    assert np.array_equal(fast(shifts), values[name](shifts))  # one read-only row for all turns
    assert np.array_equal(fast(shifts, quaternions=q), values[name](shifts, quaternions=q))
    with pytest.raises(InputError, match="pose 3 is not finite"):
        fast(np.where(np.arange(1000)[:, None] == 3, np.nan, shifts), turns)


@pytest.mark.parametrize(("there", "chosen"), [(True, "numba"), (False, "numpy")])
def test_the_engine_is_chosen(monkeypatch: pytest.MonkeyPatch, there: bool, chosen: str) -> None:
    monkeypatch.setattr(engines, "find_spec", lambda name: there or name != "numba" or None)
    assert engines.engine_named(None) == chosen
    if not there:
        with pytest.raises(InputError, match="numba is not installed"):
            engines.engine_named("numba")
    with pytest.raises(InputError, match="no engine 'fortran'"):
        engines.engine_named("fortran")


# --- the value -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "operations", "road"),
    [
        ("octahedral", 86, "shortest bracket form"),
        ("platform-6-3", 99, "shortest bracket form"),
        ("platform-6-4", 180, "-(AB /\\ Ce)(Aab /\\ Bcd /\\ Df) + (AB /\\ Df)(Aab /\\ Bcd /\\ Ce)"),
        ("platform-6-6", 325, "six legs"),
    ],
)
def test_operations(values: dict[str, Any], name: str, operations: int, road: str) -> None:
    """What the speed rests on; fewer are welcome."""
    assert values[name].programs["matrices"].operations == operations
    assert values[name].roads["matrices"] == road
    assert f"{operations} operations" in repr(values[name])


def test_it_is_a_frozen_value(robots: dict[str, Any], values: dict[str, Any]) -> None:
    value = values["octahedral"]
    again = compiled(robots["octahedral"], about="origin", engine="numpy")
    assert value == again
    assert hash(value) == hash(again)
    assert pickle.loads(pickle.dumps(value)) == value
    with pytest.raises(FrozenInstanceError):
        value.engine = "numba"
    assert gc.compiled(robots["octahedral"].platform, about="origin", engine="numpy") == value


def test_always_singular() -> None:
    platform = parse_platform("""
        legs: [Aa, Ab, Ac, Ad, Be, Cf]
        points: {A: [0, 0, 0], B: [1, 0, 0], C: [0, 1, 0],
          a: [0, 0, 1], b: [1, 0, 1], c: [0, 1, 1], d: [1, 1, 1], e: [2, 0, 1], f: [0, 3, 1]}
    """)
    value = compiled(platform, engine="numpy")
    assert value.programs["matrices"] == Program(12, (), (F(0),))
    assert value([[1, 2, 3], [4, 5, 6]]).tolist() == [0, 0]
    with pytest.raises(InputError, match="not finite"):
        value([[1, 2, np.nan]])


def test_legs_without_coordinates() -> None:
    """Odd cycles: no side moves, so all joints are given."""
    structure = read_legs("ab bc ca de ef fd")
    value = compiled(gc.analyze(structure), engine="numpy")
    assert value.joints == tuple("abcdef")
    points = np.random.default_rng(1).integers(-9, 10, size=(50, 6, 3))
    expected = [
        superbracket_at(structure.legs, {n: (*map(F, p.tolist()), F(1)) for n, p in zip("abcdef", at, strict=True)})
        for at in points
    ]
    assert value.at_joints(points).tolist() == [float(e) for e in expected]
    with pytest.raises(InputError, match="no coordinates"):
        value([[0, 0, 0]])


# --- faults --------------------------------------------------------------------------------------------------------

NAN = float("nan")
EYES = np.eye(3)[None].repeat(4, axis=0)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (([1, 2],), r"translations of shape \(2,\)"),
        ((np.zeros((4, 4)),), "translations of shape"),
        ((np.zeros((2, 2, 3)),), "translations of shape"),
        ((None, np.zeros((4, 9))), "rotations of shape"),
        ((np.zeros((3, 3)), EYES), "3 translations but 4 turns"),
        (([[1, 2], [3]],), "not numbers of one shape"),
        ((["x y z"],), "not numbers"),
        (([[1, 2, 3j]],), "not numbers"),
        (([[True, False, True]],), "not numbers"),
        (([[None, 1, 2]],), "pose 0 is not finite|not numbers"),
        ((np.ma.masked_array(np.zeros((2, 3)), mask=np.eye(2, 3)),), "masked"),
        (([[0, 0, 0], [0, NAN, 0]],), "pose 1 is not finite"),
        (([[0, float("-inf"), 0]],), "pose 0 is not finite"),
        (([[1e200, 1e200, 1e200]],), "pose 0 is beyond the range of floats"),
    ],
)
def test_wrong_arrays(values: dict[str, Any], arguments: tuple[Any, ...], says: str) -> None:
    with pytest.raises(InputError, match=says):
        values["octahedral"](*arguments)


@pytest.mark.parametrize("bad", [NAN, float("inf"), float("-inf")])
@pytest.mark.parametrize("kind", ["matrices", "quaternions", "joints"])
def test_no_bad_number_is_overlooked(values: dict[str, Any], kind: str, bad: float) -> None:
    """Not even where the value does not depend on it: here the platform is flat, and lies in its own xy-plane."""
    flat = parse_platform("""
        legs: [Aa, Bb, Cc, Da, Eb, Fc]
        points: {A: [0, 0, -1], B: [1, 0, -1], C: [0, 1, -1], D: [2, 1, -1], E: [1, 2, -1], F: [-1, 1, -1],
          a: [0, 1, 0], b: [1, 0, 0], c: [1, 1, 0]}
    """)
    for value in (compiled(flat, engine="numpy"), compiled(flat, "[abcA]", engine="numpy"), values["octahedral"]):
        for k in range(value.programs[kind].inputs):
            row = [0.0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1] if kind == "matrices" else [0.0, 0, 0, 1, 0, 0, 0]
            row = [1.0] * 9 if kind == "joints" else row
            row[k] = bad
            turn = {"rotations": np.reshape(row[3:], (-1, 3))} if kind == "matrices" else {"quaternions": row[3:]}
            call = (
                partial(value.at_joints, [np.reshape(row, (-1, 3))])
                if kind == "joints"
                else partial(value, row[:3], **turn)
            )
            with pytest.raises(InputError):
                call()


@pytest.mark.parametrize(
    ("call", "says"),
    [
        (lambda v: v(None, EYES, quaternions=[1, 0, 0, 0]), "rotations and quaternions"),
        (lambda v: v(quaternions=[[1, 0, 0, 0], [2, 0, 0, 0]]), "quaternion 1 has length 2"),
        (lambda v: v(quaternions=[0, 0, 0, 0]), "quaternion 0 has length 0"),
        (lambda v: v(quaternions=[[1, 0, 0]]), "quaternions of shape"),
        (lambda v: v.at_joints(np.zeros((2, 4, 3))), r"joints of shape \(2, 4, 3\)"),
        (lambda v: v.at_joints({"b": [0, 0, 0]}), "coordinates of b"),
        (lambda v: v.at_joints({}), "no joint"),
        (lambda v: v.at_joints({"b": [0, 0], "d": [0, 0, 0], "f": [0, 0, 0]}), "joint b: coordinates of shape"),
        (lambda v: v.at_joints({"b": np.zeros((2, 3)), "d": np.zeros((3, 3)), "f": [0, 0, 0]}), "2 b but 3 d"),
        (lambda v: v([0, 0, 0], out=np.empty(2)), "out is not an array"),
        (lambda v: v([0, 0, 0], out=np.empty(1, dtype=np.float32)), "out is not an array"),
        (lambda v: v([0, 0, 0], out=[0.0]), "out is not an array"),
        (lambda v: v([0, 0, 0], out=np.broadcast_to(np.zeros(1), (1,))), "written"),
        (lambda v: v(*[x := np.zeros((4, 3))], out=x[:, 0]), "memory"),
    ],
)
def test_wrong_calls(values: dict[str, Any], call: Callable[[Any], Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        call(values["octahedral"])


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"expression": "abc"}, "only scalars"),
        ({"expression": "[abcg]"}, "g are not joints"),
        ({"expression": gc.parse("[abc]", context=Context(3))}, "only scalars"),
        ({"about": "the moon"}, "not a centre"),
        ({"about": (1, 2)}, "3 numbers"),
        ({"about": (1, 2, NAN)}, "finite"),
        ({"engine": "abacus"}, "no engine"),
    ],
)
def test_wrong_questions(robots: dict[str, Any], arguments: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        compiled(robots["octahedral"], **arguments)


def test_joints_at_infinity_are_refused() -> None:
    with pytest.raises(InputError, match="finite joints"):
        compiled(gc.analyze("ab af cb cd ed ef", ideal="b"))
