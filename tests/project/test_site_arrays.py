"""The arrays of the engine in the guide's pages give what NumPy gives, for all that gcrules' algebra asks of it."""

from __future__ import annotations

import importlib.util
import os
import random
import subprocess
import sys
from collections.abc import Callable
from types import ModuleType
from typing import Any

import numpy
import pytest
from places import ROOT

FOLDER = ROOT / "tools" / "engine" / "arrays" / "numpy"


def _load() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "arrays_of_pages", FOLDER / "__init__.py", submodule_search_locations=[str(FOLDER)]
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["arrays_of_pages"] = module
    spec.loader.exec_module(module)
    return module


ours = _load()
_WRAPPING = 0x9E3779B97F4A7C15
_Make = Callable[[Any, Any], Any]


def _filled(np: Any, a: Any) -> Any:
    a = np.array(a)
    a[1] = 7
    a[:, 0] = a[:, 1]
    a[0, 1:] += np.array([10, 20])
    a[[0, 2], [1, 1]] = -1
    a[np.array([True, False, True]), 2] = 5
    a[...] = a * 2
    return a


def _rows(np: Any, a: Any) -> Any:
    out = np.empty((3, 4))
    for row, value in zip(np.array(a), out, strict=True):
        value[...] = 0
        value += np.arange(4) * row[0]
    return out


CASES: dict[str, _Make] = {
    "shape": lambda np, a: np.array(a).reshape(-1, 1, 3).shape,
    "transposed": lambda np, a: np.array(a).T.reshape(-1, 9),
    "slices": lambda np, a: np.array(a)[::-1, 1:],
    "new axes": lambda np, a: np.array(a)[:, None, :] * np.array(a)[None, :, :],
    "ellipsis": lambda np, a: np.array(a)[..., 0],
    "places": lambda np, a: np.array(a)[[2, 0]],
    "negative places": lambda np, a: np.array(a)[np.array([-1, 0]), 1],
    "places in a tuple": lambda np, a: np.array(a)[1, (2, 0)],
    "two lists of places": lambda np, a: np.array(a)[np.array([[0], [1]]), np.array([2, 0])],
    "places between slices": lambda np, a: np.arange(24).reshape(2, 3, 4)[:, np.array([2, 0]), 1:],
    "places apart": lambda np, a: np.arange(24).reshape(2, 3, 4)[np.array([0, 1]), :, np.array([3, 2])],
    "a place and places": lambda np, a: np.arange(24).reshape(2, 3, 4)[np.array([1, 0]), 0, np.arange(2)],
    "choice": lambda np, a: np.array(a)[np.array(a) > 2],
    "choice of rows": lambda np, a: np.array(a)[(np.array(a) > 2).any(axis=1), 1:],
    "filled": _filled,
    "rows are views": _rows,
    "sums": lambda np, a: np.array(a).sum(axis=0),
    "sums of several axes": lambda np, a: np.arange(24).reshape(2, 3, 4).sum(axis=(1, 2)),
    "all": lambda np, a: (np.array(a) > 0).all(axis=1),
    "argmax": lambda np, a: (np.array(a) != 0).argmax(axis=0),
    "product of matrices": lambda np, a: np.array(a).T @ np.array(a),
    "comparison": lambda np, a: np.array(a)[:, :1] <= np.array(a),
    "not": lambda np, a: ~(np.array(a) > 2),
    "bits": lambda np, a: ((np.array(a) & 3) | 8) ^ (np.array(a) >> 1),
    "remainders": lambda np, a: (np.array(a) - 5) % 3,
    "quotients": lambda np, a: (np.array(a) - 5) // 3,
    "divmod": lambda np, a: [x.tolist() for x in np.divmod(np.array(a), 3)],
    "halves": lambda np, a: np.rint(np.array(a) / 2),
    "wrapping": lambda np, a: np.array(a).astype(np.uint64) * np.uint64(_WRAPPING) + np.uint64(3),
    "bytes of negatives": lambda np, a: (-np.array(a)).astype(np.int64).view(np.uint64) % np.uint64(1000),
    "where": lambda np, a: np.where(np.array(a) > 2, np.array(a) - 2, np.array(a)),
    "minimum": lambda np, a: np.minimum(np.array(a), np.array(a)[0]),
    "concatenated": lambda np, a: np.concatenate([np.array(a), np.array(a)[:1]]),
    "concatenated sideways": lambda np, a: np.concatenate([np.array(a), np.array(a)], axis=1),
    "stacked": lambda np, a: np.stack([np.array(a), np.array(a) + 1], axis=1),
    "split": lambda np, a: [x.tolist() for x in np.array_split(np.arange(10), 3)],
    "moved axes": lambda np, a: np.moveaxis(np.arange(24).reshape(2, 3, 4), (2, 0), (0, 1)),
    "broadcast": lambda np, a: [x.tolist() for x in np.broadcast_arrays(np.array(a), np.arange(3))],
    "broadcast shapes": lambda np, a: np.broadcast_shapes((3, 1), (4,)),
    "repeated": lambda np, a: np.repeat(np.arange(3), np.array([2, 0, 1])),
    "identity": lambda np, a: np.eye(3, dtype=np.int64)[[1]],
    "found": lambda np, a: [x.tolist() for x in np.nonzero(np.array(a) > 2)],
    "found flat": lambda np, a: np.flatnonzero(np.array(a)),
    "counted": lambda np, a: np.count_nonzero(np.array(a)),
    "running sums": lambda np, a: np.cumsum(np.array(a)[0]),
    "running sums of rows": lambda np, a: np.cumsum(np.array(a), axis=1),
    "differences": lambda np, a: np.diff([*np.array(a)[0].tolist(), 99]),
    "sorted": lambda np, a: np.sort(np.array(a), axis=1),
    "sorted down": lambda np, a: np.sort(np.array(a), axis=0),
    "order": lambda np, a: np.argsort(np.array([3, 1, 3, 0, 1]), kind="stable"),
    "order by two": lambda np, a: np.lexsort((np.array([1, 0, 1, 0]), np.array([2, 2, 1, 2]))),
    "search": lambda np, a: np.searchsorted(np.array([1, 3, 3, 7]), np.array([0, 3, 8])),
    "search behind": lambda np, a: np.searchsorted(np.array([1, 3, 3, 7]), 3, side="right"),
    "different": lambda np, a: [
        x.tolist()
        for x in np.unique(np.array([3, 1, 3, 2]), return_index=True, return_inverse=True, return_counts=True)
    ],
    "among": lambda np, a: np.isin(np.array(a)[0], np.array([1, 2])),
    "sums of parts": lambda np, a: np.add.reduceat(np.arange(7), np.array([0, 2, 3])),
    "sums of parts of rows": lambda np, a: np.add.reduceat(np.array(a), np.array([0, 2])),
    "truths are numbers in sums": lambda np, a: ((np.array(a) > 1) + 1, (np.array(a) > 1).sum())[0],
    "power": lambda np, a: np.int64(3) ** np.arange(4),
    "mean": lambda np, a: np.array(a).mean(axis=0),
    "epsilon": lambda np, a: [np.finfo(float).eps, np.finfo(np.float64).max, np.finfo(float).tiny],
    "empty": lambda np, a: np.zeros((0, 5), dtype=np.int64).any(axis=1),
}


def _plain(value: Any) -> Any:
    return value.tolist() if hasattr(value, "tolist") else value


@pytest.mark.parametrize("name", CASES)
def test_same_as_numpy(name: str) -> None:
    rng = random.Random(name)
    for _ in range(5):
        a = [[rng.randrange(6) for _ in range(3)] for _ in range(3)]
        assert _plain(CASES[name](ours, a)) == _plain(CASES[name](numpy, a))


def test_places_once_more_add_up() -> None:
    for np in (ours, numpy):
        a = np.array([15, 15])
        np.bitwise_and.at(a, np.array([0, 0, 1]), np.array([3, 6, 8]))
        assert a.tolist() == [2, 8]


@pytest.mark.parametrize("shape", [(3, 3), (6, 3), (2, 5), (6, 6), (1, 4)])
@pytest.mark.parametrize("rank", [1, 2, 6])
def test_singular_values(shape: tuple[int, int], rank: int) -> None:
    rng = numpy.random.default_rng(rank)
    a = rng.normal(size=(shape[0], rank)) @ rng.normal(size=(rank, shape[1]))
    found = ours.linalg.svd(ours.array(a.tolist()), compute_uv=False).tolist()
    wanted = numpy.linalg.svd(a, compute_uv=False)
    assert found == pytest.approx(wanted.tolist(), rel=1e-12, abs=1e-14 * float(wanted[0]))


def test_singular_values_of_nothing() -> None:
    assert ours.linalg.svd(ours.zeros((4, 3)), compute_uv=False).tolist() == [0, 0, 0]


@pytest.mark.parametrize("values", [[1, 2**63, 2**64 - 1], [0, 3, 5]])
def test_whole_numbers_without_a_sign_wrap_as_in_numpy(values: list[int]) -> None:
    def found(np: Any) -> list[Any]:
        a = np.array(values, dtype=np.uint64)
        square = np.array([values, values[::-1]], dtype=np.uint64)
        where = np.where(a > 2, np.array([1, 2, 3]), 0.5)
        return [x.tolist() for x in (-a, ~a, square @ a, a.view(np.int64), a.view(np.int64).view(np.uint64), where)]

    assert found(ours) == found(numpy)


def test_the_stand_in_is_for_browsers_only() -> None:
    found = subprocess.run(
        [sys.executable, "-c", "import numpy"],
        env=os.environ | {"PYTHONPATH": str(FOLDER.parent)},
        capture_output=True,
        text=True,
    )
    assert found.returncode == 1
    assert "these arrays are for the engine in the guide's pages" in found.stderr


def test_random_numbers_lie_where_they_should() -> None:
    found = ours.random.default_rng(3).integers(2, 5, (4, 5))
    assert found.shape == (4, 5)
    assert {v for row in found.tolist() for v in row} == {2, 3, 4}


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: ours.array([1, 2])[2],
        lambda: ours.array([1, 2])[ours.array([2])],
        lambda: ours.array([[1, 2]]) + ours.array([1, 2, 3]),
        lambda: ours.arange(6).reshape(4, 2),
        lambda: ours.array([[1], [1, 2]]),
    ],
)
def test_what_does_not_fit_is_refused(wrong: Callable[[], Any]) -> None:
    with pytest.raises((IndexError, ValueError)):
        wrong()


@pytest.mark.parametrize(
    "ask",
    [
        lambda: ours.linalg.norm,
        lambda: ours.array([1]).tobytes(),
        lambda: ours.array([1]).flatten(),
        lambda: ours.linalg.svd(ours.eye(2)),
        lambda: ours.argsort(ours.eye(2)),
        lambda: ours.unique(ours.eye(2), axis=1),
        lambda: ours.array([1.5]).view(ours.int64),
    ],
)
def test_what_is_not_there_is_numpy_missing(ask: Callable[[], Any]) -> None:
    with pytest.raises(ModuleNotFoundError) as fault:
        ask()
    assert fault.value.name == "numpy"
