"""Arrays for the engine in the guide's pages, where NumPy itself cannot be loaded.

This is no NumPy: it has what gcrules' exact algebra uses of it, by the same names and with the same results, far more
slowly. Whatever else is asked for is reported as missing, so that gcrules says what it needs. The random numbers are
others.
"""

import math
import operator
import sys
from bisect import bisect_left, bisect_right
from itertools import pairwise

from . import linalg, random
from .ndarray import (
    array,
    asarray,
    bool_,
    broadcast_shape,
    dtype,
    elementwise,
    float64,
    int64,
    missing,
    ndarray,
    nonzero,
    object_,
    of_type,
    uint64,
    widest,
)

if __name__ == "numpy" and sys.platform != "emscripten":
    raise ImportError("these arrays are for the engine in the guide's pages; NumPy itself is another package")

__all__ = ["array", "bool_", "dtype", "float64", "int64", "linalg", "ndarray", "nonzero", "object_", "random", "uint64"]

int8 = int16 = int32 = intp = int64
uint8 = uint32 = uint64
integer = floating = int64
ascontiguousarray = asarray


pi = math.pi


class finfo:
    """Of floats."""

    def __init__(self, kind=float):
        self.eps, self.max, self.tiny = sys.float_info.epsilon, sys.float_info.max, sys.float_info.min


def __getattr__(name):
    if name.startswith("__"):
        raise AttributeError(name)
    raise ModuleNotFoundError(f"numpy.{name} is not among what the engine in the guide's pages has", name="numpy")


# --- new arrays ----------------------------------------------------------------------------------------------------


def full(shape, value, dtype=None):
    shape = (shape,) if isinstance(shape, int) else shape
    kind = of_type(dtype) or asarray(value).dtype
    return ndarray([kind(value)] * math.prod(shape), shape, kind)


def zeros(shape, dtype=float64):
    return full(shape, 0, dtype)


def ones(shape, dtype=float64):
    return full(shape, 1, dtype)


empty = zeros


def empty_like(a):
    return zeros(a.shape, a.dtype)


zeros_like = empty_like


def arange(*bounds):
    return array(range(*map(operator.index, bounds)), int64)


def eye(n, dtype=float64):
    return array([[int(i == j) for j in range(n)] for i in range(n)], dtype)


# --- shapes --------------------------------------------------------------------------------------------------------


def concatenate(parts, axis=0):
    parts = [asarray(p) for p in parts]
    axis %= parts[0].ndim
    order = [axis, *(a for a in range(parts[0].ndim) if a != axis)]
    moved = [p.transposed(order) for p in parts]
    if len({m.shape[1:] for m in moved}) > 1:
        raise ValueError("arrays of different shapes cannot be concatenated")
    kind = max((p.dtype for p in parts), key=lambda t: "biufO".index(t.kind))
    whole = ndarray([v for m in moved for v in m.values()], (sum(map(len, moved)), *moved[0].shape[1:]), kind)
    return whole.transposed([order.index(a) for a in range(whole.ndim)]).copy()


def stack(parts, axis=0):
    parts = [asarray(p) for p in parts]
    axis %= parts[0].ndim + 1
    return concatenate([p.reshape(*p.shape[:axis], 1, *p.shape[axis:]) for p in parts], axis)


def array_split(a, number):
    size, more = divmod(len(a), number)
    cuts = [0]
    for i in range(number):
        cuts.append(cuts[-1] + size + (i < more))
    return [a[low:high] for low, high in pairwise(cuts)]


def moveaxis(a, source, destination):
    source, destination = ([x] if isinstance(x, int) else list(x) for x in (source, destination))
    source, destination = [x % a.ndim for x in source], [x % a.ndim for x in destination]
    order = [x for x in range(a.ndim) if x not in source]
    for to, of in sorted(zip(destination, source, strict=True)):
        order.insert(to, of)
    return a.transposed(order)


def broadcast_shapes(*shapes):
    return broadcast_shape(*shapes)


def broadcast_arrays(*arrays):
    arrays = [asarray(a) for a in arrays]
    shape = broadcast_shape(*(a.shape for a in arrays))
    return [a.spread(shape) for a in arrays]


def repeat(a, counts):
    a = asarray(a)
    counts = [counts] * a.size if isinstance(counts, int) else counts.tolist()
    return array([v for v, n in zip(a.values(), counts, strict=True) for _ in range(n)], a.dtype)


def ndim(a):
    return asarray(a).ndim


# --- elements ------------------------------------------------------------------------------------------------------


class _Function:
    """A function of two numbers, elementwise; `at` applies it inside an array, again where a place occurs again."""

    def __init__(self, function):
        self.function = function

    def __call__(self, a, b, out=None):
        found = elementwise(self.function, a, b)
        if out is None:
            return found
        out[...] = found
        return out

    def reduceat(self, a, starts, dtype=None):
        """The function of all elements from each start to the next one, along the first axis."""
        ends = [*starts.tolist()[1:], len(a)]
        found = []
        for low, high in zip(starts.tolist(), ends, strict=True):
            total = a[low]
            for i in range(low + 1, high):
                total = self.function(total, a[i])
            found.append(total)
        return array(found, of_type(dtype) or a.dtype)

    def at(self, a, places, values):
        for place, value in zip(places.tolist(), values.tolist(), strict=True):
            a[place] = self.function(a[place], value)


add = _Function(operator.add)
multiply = _Function(operator.mul)
minimum = _Function(min)
maximum = _Function(max)
bitwise_and = _Function(operator.and_)


def rint(a, out=None):
    found = ndarray([float(round(v)) for v in a.values()], a.shape, float64)
    if out is None:
        return found
    out[...] = found
    return out


def abs(a):
    return a.__abs__()


def divmod(a, b):
    return a // b, a % b


def where(condition, a, b):
    a, b = asarray(a), asarray(b)
    shape = broadcast_shape(condition.shape, a.shape, b.shape)
    kind = widest(a.dtype, b.dtype)
    parts = (x.spread(shape).values() for x in (condition, a, b))
    return ndarray([x if c else y for c, x, y in zip(*parts, strict=True)], shape, kind)


def count_nonzero(a):
    return sum(map(bool, a.values()))


def flatnonzero(a):
    return nonzero(a.ravel())[0]


def cumsum(a, axis=None):
    if axis is not None and a.ndim > 1:
        rows = moveaxis(a, axis, -1)
        found = [cumsum(row) for row in rows.reshape(-1, rows.shape[-1])]
        return moveaxis(stack(found).reshape(*rows.shape), -1, axis)
    total, found = 0, []
    for v in a.values():
        total += v
        found.append(total)
    return array(found, int64 if a.dtype.kind in "bi" else a.dtype)


def append(a, more):
    return concatenate([asarray(a).ravel(), asarray(more).ravel()])


def isin(a, names):
    wanted = set(names.values())
    return ndarray([v in wanted for v in a.values()], a.shape, bool_)


def put_along_axis(a, places, values, axis):
    """Rows only: the last axis of two."""
    if a.ndim != 2 or axis not in (1, -1):
        raise __getattr__("put_along_axis along other axes")
    rows = array([[i] for i in range(len(a))], int64)
    a[rows, places] = values


def diff(a):
    values = asarray(a).values()
    return array([y - x for x, y in pairwise(values)], asarray(a).dtype)


# --- order ---------------------------------------------------------------------------------------------------------


def argsort(a, kind=None):
    if a.ndim != 1:
        raise missing("sorting along an axis")
    values = a.values()
    return array(sorted(range(len(values)), key=values.__getitem__), int64)


def lexsort(keys):
    rows = [k.values() for k in reversed(keys)]
    return array(sorted(range(len(rows[0])), key=lambda i: [row[i] for row in rows]), int64)


def sort(a, axis=-1):
    a = a.copy()
    a.sort(axis)
    return a


def searchsorted(a, values, side="left"):
    find = bisect_left if side == "left" else bisect_right
    own = a.values()
    if isinstance(values, ndarray):
        return ndarray([find(own, v) for v in values.values()], values.shape, int64)
    return find(own, values)


def unique(a, return_index=False, return_inverse=False, return_counts=False, axis=None):
    if axis not in (None, 0):
        raise missing("unique columns")
    values = a.values() if axis is None else list(map(tuple, a.tolist()))
    first, counts = {}, {}
    for i, v in enumerate(values):
        first.setdefault(v, i)
        counts[v] = counts.get(v, 0) + 1
    names = sorted(first)
    place = {v: i for i, v in enumerate(names)}
    found = [array(names, a.dtype)]
    if return_index:
        found.append(array([first[v] for v in names], int64))
    if return_inverse:
        found.append(ndarray([place[v] for v in values], a.shape if axis is None else (len(a),), int64))
    if return_counts:
        found.append(array([counts[v] for v in names], int64))
    return tuple(found) if len(found) > 1 else found[0]
