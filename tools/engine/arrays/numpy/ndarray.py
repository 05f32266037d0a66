"""Arrays over lists: shapes, views, indices, elementwise operations and reductions, as NumPy defines them.

An array is a place in a list: an offset, and for each axis a length and a step. Whole numbers are Python's, of any
size, but those of the type uint64, which wrap as they do there.
"""

from __future__ import annotations

import math
import operator
from builtins import all as all_of
from builtins import any as any_of

_WRAP = 2**64 - 1
_RANKS = {"b": 0, "i": 1, "u": 2, "f": 3, "O": 4}


class dtype:
    """A type of elements; called, it converts one number."""

    def __init__(self, name, kind, convert):
        self.name, self.kind, self._convert = name, kind, convert

    def __call__(self, value=0):
        return self._convert(value)

    def __eq__(self, other):
        return self.name == of_type(other).name

    def __hash__(self):
        return hash(self.name)

    def __repr__(self):
        return f"dtype({self.name!r})"

    __class_getitem__ = classmethod(lambda cls, _: cls)


def _unsigned(value):
    return int(value) & _WRAP


bool_ = dtype("bool", "b", bool)
int64 = dtype("int64", "i", int)
uint64 = dtype("uint64", "u", _unsigned)
float64 = dtype("float64", "f", float)
object_ = dtype("object", "O", lambda value: value)
_BUILTIN = {bool: bool_, int: int64, float: float64, object: object_}
_BY_KIND = {t.kind: t for t in (bool_, int64, uint64, float64, object_)}


def of_type(kind):
    return _BUILTIN.get(kind, kind) if isinstance(kind, type) else kind


def _kind_of(value):
    if isinstance(value, bool):
        return "b"
    return "i" if isinstance(value, int) else "f" if isinstance(value, float) else "O"


def positions(shape, strides, offset=0):
    """Where the elements lie, in order."""
    found = [offset]
    for n, step in zip(shape, strides, strict=True):
        if n == 1:
            continue
        if step:
            found = [p + k for p in found for k in range(0, n * step, step)] if n else []
        else:
            found = [p for p in found for _ in range(n)]
    return found


def steps(shape):
    found, step = [], 1
    for n in reversed(shape):
        found.append(step)
        step *= n
    return tuple(reversed(found))


def broadcast_shape(*shapes):
    width = max(map(len, shapes), default=0)
    padded = [(1,) * (width - len(s)) + tuple(s) for s in shapes]
    found = []
    for lengths in zip(*padded, strict=True):
        different = set(lengths) - {1}
        if len(different) > 1:
            raise ValueError(f"shapes {shapes} cannot be broadcast together")
        found.append(different.pop() if different else 1)
    return tuple(found)


class ndarray:
    __slots__ = ("_data", "_offset", "_strides", "dtype", "shape")
    __hash__ = None
    __class_getitem__ = classmethod(lambda cls, _: cls)

    def __init__(self, data, shape, kind, offset=0, strides=None):
        self._data, self.shape, self.dtype, self._offset = data, tuple(shape), kind, offset
        self._strides = steps(self.shape) if strides is None else strides

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        raise ModuleNotFoundError(f"arrays of the engine in the guide's pages have no {name}", name="numpy")

    # --- what it is ------------------------------------------------------------------------------------------------

    @property
    def size(self):
        return math.prod(self.shape)

    @property
    def ndim(self):
        return len(self.shape)

    @property
    def _whole(self):
        return self._strides == steps(self.shape)

    def _places(self):
        return (
            range(self._offset, self._offset + self.size)
            if self._whole
            else positions(self.shape, self._strides, self._offset)
        )

    def values(self):
        """The elements in order, as a new list."""
        if self._whole:
            return self._data[self._offset : self._offset + self.size]
        data = self._data
        return [data[p] for p in self._places()]

    def __len__(self):
        if not self.shape:
            raise TypeError("an array without axes has no length")
        return self.shape[0]

    def __iter__(self):
        return (self[i] for i in range(len(self)))

    def __bool__(self):
        (value,) = self.values()
        return bool(value)

    def __int__(self):
        (value,) = self.values()
        return int(value)

    def __float__(self):
        (value,) = self.values()
        return float(value)

    __index__ = __int__

    def __repr__(self):
        return f"array({self.tolist()!r})"

    def tolist(self):
        def nested(values, shape):
            if not shape:
                return values[0]
            if len(shape) == 1:
                return values
            n = math.prod(shape[1:])
            return [nested(values[i * n : (i + 1) * n], shape[1:]) for i in range(shape[0])]

        return nested(self.values(), self.shape)

    # --- other forms -----------------------------------------------------------------------------------------------

    def astype(self, kind, copy=True):
        kind = of_type(kind)
        values = self.values()
        return ndarray(values if kind.kind == self.dtype.kind else [kind(v) for v in values], self.shape, kind)

    def view(self, kind):
        kind = of_type(kind)
        if kind.kind == self.dtype.kind:
            return self.astype(kind)
        if {kind.kind, self.dtype.kind} != {"i", "u"}:
            raise missing(f"a view of {self.dtype.kind} as {kind.kind}")
        return ndarray([_signed(v) if kind.kind == "i" else v & _WRAP for v in self.values()], self.shape, kind)

    def copy(self):
        return ndarray(self.values(), self.shape, self.dtype)

    def reshape(self, *shape):
        shape = shape[0] if len(shape) == 1 and not isinstance(shape[0], int) else shape
        known = math.prod(n for n in shape if n != -1)
        shape = tuple(self.size // known if n == -1 and known else max(n, 0) for n in shape)
        if math.prod(shape) != self.size:
            raise ValueError(f"an array of {self.size} elements has not the shape {shape}")
        if self._whole:
            return ndarray(self._data, shape, self.dtype, self._offset)
        return ndarray(self.values(), shape, self.dtype)

    def ravel(self):
        return self.reshape(-1)

    def transposed(self, axes):
        return ndarray(
            self._data, [self.shape[a] for a in axes], self.dtype, self._offset, tuple(self._strides[a] for a in axes)
        )

    @property
    def T(self):
        return self.transposed(range(self.ndim - 1, -1, -1))

    def spread(self, shape):
        """The same, broadcast to a shape."""
        extra = len(shape) - self.ndim
        strides = tuple(
            0 if i < extra or self.shape[i - extra] != n else self._strides[i - extra] for i, n in enumerate(shape)
        )
        if broadcast_shape(self.shape, shape) != tuple(shape):
            raise ValueError(f"the shape {self.shape} cannot be broadcast to {shape}")
        return ndarray(self._data, shape, self.dtype, self._offset, strides)

    # --- indices ---------------------------------------------------------------------------------------------------

    def _chosen(self, key):
        """The part that an index names: a view, or a shape with the places of its elements."""
        key = list(key) if isinstance(key, tuple) else [key]
        key = [array(list(k)) if isinstance(k, list | tuple) else k for k in key]
        key = [p for k in key for p in (nonzero(k) if isinstance(k, ndarray) and k.dtype.kind == "b" else (k,))]
        taken = sum(k is not None and k is not Ellipsis for k in key)
        rest = [slice(None)] * (self.ndim - taken)
        if any_of(k is Ellipsis for k in key):
            at = next(i for i, k in enumerate(key) if k is Ellipsis)
            key[at : at + 1] = rest
        else:
            key += rest
        by_array = any_of(isinstance(k, ndarray) for k in key)
        offset, shape, strides, given, where, axis = self._offset, [], [], [], [], 0
        for k in key:
            if k is None:
                shape.append(1)
                strides.append(0)
                continue
            n, step = self.shape[axis], self._strides[axis]
            axis += 1
            if isinstance(k, slice):
                start, _, by = k.indices(n)
                offset += start * step
                shape.append(len(range(n)[k]))
                strides.append(step * by)
            elif isinstance(k, ndarray):
                given.append((k, n, step))
                where.append(len(shape))
            else:
                i = operator.index(k)
                if not -n <= i < n:
                    raise IndexError(f"{i} is not a place in an axis of length {n}")
                offset += i % n * step
                if by_array:
                    where.append(len(shape))
        if not given:
            return ndarray(self._data, shape, self.dtype, offset, tuple(strides))
        common = broadcast_shape(*(k.shape for k, _, _ in given))
        moves = [0] * math.prod(common)
        for k, n, step in given:
            places = k.spread(common).values()
            if places and not -n <= min(places) <= max(places) < n:
                raise IndexError(f"a place is not in an axis of length {n}")
            moves = [m + i % n * step for m, i in zip(moves, places, strict=True)]
        at = where[0] if len(set(where)) == 1 else 0
        before, after = positions(shape[:at], strides[:at], offset), positions(shape[at:], strides[at:])
        return (*shape[:at], *common, *shape[at:]), [b + m + a for b in before for m in moves for a in after]

    def __getitem__(self, key):
        found = self._chosen(key)
        if isinstance(found, ndarray):
            return found if found.shape or key is Ellipsis else found._data[found._offset]
        shape, places = found
        data = self._data
        return ndarray([data[p] for p in places], shape, self.dtype)

    def __setitem__(self, key, value):
        found = self._chosen(key)
        shape, places = (found.shape, found._places()) if isinstance(found, ndarray) else found
        convert = self.dtype
        if isinstance(value, ndarray | list | tuple):
            value = asarray(value)
            while value.ndim > len(shape) and value.shape[0] == 1:
                value = value[0]
            new = value.spread(shape).values()
            if value.dtype.kind != convert.kind:
                new = [convert(v) for v in new]
        else:
            new = [convert(value)] * len(places)
        data = self._data
        for p, v in zip(places, new, strict=True):
            data[p] = v

    # --- reductions ------------------------------------------------------------------------------------------------

    def along(self, axis, function, kind=None):
        """A function of the list of elements along axes."""
        kind = self.dtype if kind is None else kind
        if axis is None:
            return function(self.values())
        axes = sorted(a % self.ndim for a in ((axis,) if isinstance(axis, int) else axis))
        kept = [a for a in range(self.ndim) if a not in axes]
        shape = [self.shape[a] for a in kept]
        n = math.prod(self.shape[a] for a in axes)
        values = self.transposed([*kept, *axes]).values()
        return ndarray([function(values[i * n : (i + 1) * n]) for i in range(math.prod(shape))], shape, kind)

    def sum(self, axis=None, dtype=None):
        kind = of_type(dtype) or (int64 if self.dtype.kind == "b" else self.dtype)
        return self.along(axis, lambda values: kind(sum(values)), kind)

    def mean(self, axis=None):
        return self.along(axis, lambda values: float(sum(values) / len(values)), float64)

    def any(self, axis=None):
        return self.along(axis, lambda values: any_of(values), bool_)

    def all(self, axis=None):
        return self.along(axis, lambda values: all_of(values), bool_)

    def max(self, axis=None):
        return self.along(axis, max)

    def min(self, axis=None):
        return self.along(axis, min)

    def argmax(self, axis=None):
        return self.along(axis, lambda values: values.index(max(values)), int64)

    def argmin(self, axis=None):
        return self.along(axis, lambda values: values.index(min(values)), int64)

    def sort(self, axis=-1):
        moved = self.transposed([*(a for a in range(self.ndim) if a != axis % self.ndim), axis % self.ndim])
        places, n = list(moved._places()), moved.shape[-1]
        for i in range(0, len(places), n or 1):
            own = places[i : i + n]
            for p, v in zip(own, sorted([self._data[p] for p in own]), strict=True):
                self._data[p] = v

    def tobytes(self):
        raise missing("the bytes of an array")

    def __matmul__(self, other):
        if self.ndim == 1 or other.ndim == 1:
            return (self * other.T).sum(axis=-1) if other.ndim == 1 else (self[None, :] @ other)[0]
        rows, columns, n = self.shape[0], other.T.values(), self.shape[1]
        if n != other.shape[0] or self.ndim != 2 or other.ndim != 2:
            raise ValueError(f"shapes {self.shape} and {other.shape} do not fit")
        own = self.values()
        right = [columns[j * n : (j + 1) * n] for j in range(other.shape[1])]
        kind = widest(self.dtype, other.dtype)
        left = [own[i * n : (i + 1) * n] for i in range(rows)]
        products = [sum(map(operator.mul, a, b)) for a in left for b in right]
        return ndarray([v & _WRAP for v in products] if kind is uint64 else products, (rows, len(right)), kind)

    def __invert__(self):
        flip = operator.not_ if self.dtype.kind == "b" else operator.invert
        return self._of(flip)

    def __neg__(self):
        return self._of(operator.neg)

    def _of(self, function):
        values = map(function, self.values())
        return ndarray([v & _WRAP for v in values] if self.dtype is uint64 else list(values), self.shape, self.dtype)

    def __abs__(self):
        return ndarray([abs(v) for v in self.values()], self.shape, self.dtype)


def widest(a, b):
    """The kind of a result of two kinds."""
    return _BY_KIND[max(a.kind, b.kind, key=_RANKS.__getitem__)]


def missing(words):
    """What is raised for what NumPy has and this has not."""
    return ModuleNotFoundError(f"arrays of this engine do without {words}", name="numpy")


def _signed(value):
    return value - 2**64 if value >= 2**63 else value


def elementwise(function, a, b, kind=None):
    """A function of two numbers, of all elements of arrays that are broadcast together."""
    if not isinstance(a, ndarray):
        a = asarray(a)
    if not isinstance(b, ndarray):
        b = asarray(b)
    shape = a.shape if a.shape == b.shape else broadcast_shape(a.shape, b.shape)
    if not b.shape:
        other = b.values()[0]
        values = [function(v, other) for v in a.spread(shape).values()]
    else:
        values = list(map(function, a.spread(shape).values(), b.spread(shape).values()))
    if kind is None:
        kind = widest(a.dtype, b.dtype)
        if kind is uint64:
            values = [v & _WRAP for v in values]
        elif kind is bool_ and function in _NUMERIC:
            kind, values = int64, [int(v) for v in values]
    found = ndarray(values, shape, kind)
    return found if shape else found.values()[0]


_NUMERIC = {operator.add, operator.sub, operator.mul}
_OPERATORS = (*_NUMERIC, operator.mod, operator.floordiv, operator.pow, operator.and_, operator.or_, operator.xor)
_COMPARED = (operator.eq, operator.ne, operator.lt, operator.le, operator.gt, operator.ge)


def _define():
    def both(function, kind):
        def forward(self, other):
            return elementwise(function, self, other, kind)

        def backward(self, other):
            return elementwise(function, other, self, kind)

        def inside(self, other):
            self[...] = elementwise(function, self, other, kind)
            return self

        return forward, backward, inside

    named = [(f, f.__name__.strip("_"), None) for f in (*_OPERATORS, operator.lshift, operator.rshift)]
    for function, name, kind in (*named, (operator.truediv, "truediv", float64)):
        forward, backward, inside = both(function, kind)
        setattr(ndarray, f"__{name}__", forward)
        setattr(ndarray, f"__r{name}__", backward)
        setattr(ndarray, f"__i{name}__", inside)
    for function in _COMPARED:
        setattr(ndarray, f"__{function.__name__}__", both(function, bool_)[0])
    ndarray.__divmod__ = lambda self, other: (self // other, self % other)


_define()


def array(value, dtype=None, copy=True):
    """An array of nested sequences of numbers or arrays."""
    kind = of_type(dtype)
    if isinstance(value, ndarray):
        return value.copy() if kind is None or kind.kind == value.dtype.kind else value.astype(kind)
    shape, values = _flat(value)
    if kind is None:
        kinds = {_kind_of(v) for v in values}
        kind = _BY_KIND[max(kinds, key=_RANKS.__getitem__)] if kinds else float64
    return ndarray([kind(v) for v in values], shape, kind)


def _flat(value):
    if isinstance(value, ndarray):
        return value.shape, value.values()
    if not isinstance(value, list | tuple | range):
        return (), [value]
    parts = [_flat(v) for v in value]
    if len({shape for shape, _ in parts}) > 1:
        raise ValueError("the parts of an array have different shapes")
    inner = parts[0][0] if parts else ()
    return (len(parts), *inner), [v for _, values in parts for v in values]


def asarray(value, dtype=None):
    return value if isinstance(value, ndarray) and dtype is None else array(value, dtype)


def nonzero(a):
    """The places of the elements that are not 0, one array for each axis."""
    flat = [i for i, v in enumerate(a.values()) if v]
    found = []
    for n, step in zip(a.shape, steps(a.shape), strict=True):
        found.append(ndarray([i // step % n for i in flat], (len(flat),), int64))
    return tuple(found)
