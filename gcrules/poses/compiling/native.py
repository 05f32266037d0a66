r"""A program as machine code: straight-line vector instructions, made by numba's compiler from the lines themselves.

Each line becomes one instruction on `WIDTH` poses, whose values stay in registers of the processor as long as these
last. Nothing is contracted or reordered, so every value is rounded as NumPy rounds it.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, lru_cache
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.poses.compiling.tape import BINARY, Program

__all__ = ["WIDTH", "native"]

Floats = NDArray[np.float64]

WIDTH = 8
"""Poses that one instruction works on: the longest vectors in use; where they are shorter, several take its place."""

_REAL = 8  # bytes
_INSTRUCTIONS = {"add": "fadd", "sub": "fsub", "mul": "fmul", "shift": "fadd", "scale": "fmul"}


def native(program: Program) -> Callable[[Floats, Floats, Floats], None]:
    """What runs a program that has lines: on two arrays of inputs, (n, k) and (n, m) of any strides, and one of values,
    (results, n), in which constant ones are left out.

    The machine code is made at the first call with inputs of this layout, in some tenths of a second.
    """

    @cache  # without it each chunk would look the whole program up
    def kernel(split: int, rows: bool) -> Any:
        return _kernel(program, split, rows)

    def run(first: Floats, second: Floats, out: Floats) -> None:
        n = out.shape[1]
        if n < WIDTH:
            last = np.minimum(np.arange(WIDTH), n - 1)
            values = np.empty((len(out), WIDTH))
            run(first[last], second[last], values)
            out[:] = values[:, :n]
            return
        first, second = (np.require(part, requirements="A") for part in (first, second))
        fit = out.flags.aligned and out.strides[1] == _REAL
        values = out if fit else np.empty(out.shape)
        rows = all(part.strides[1] == _REAL for part in (first, second) if part.size)
        places = (x for part in (first, second) for x in (part.ctypes.data, *part.strides))
        kernel(first.shape[1], rows)(n, *places, values.ctypes.data, values.strides[0])
        if values is not out:
            out[:] = values

    return run


@lru_cache(maxsize=64)
def _kernel(program: Program, split: int, rows: bool) -> Any:
    """The code for poses whose first `split` inputs are in the first array; `rows`: where rows are without gaps."""
    numba = import_module("numba")
    block = _block(program, split, rows)

    def kernel(
        n: int, a: int, a_row: int, a_column: int, b: int, b_row: int, b_column: int, out: int, out_row: int
    ) -> None:
        """Arrays are given by address and strides, in bytes. The last block overlaps the one before it."""
        for start in range(0, n - WIDTH, WIDTH):
            block(a + start * a_row, a_row, a_column, b + start * b_row, b_row, b_column, out + start * _REAL, out_row)
        start = n - WIDTH
        block(a + start * a_row, a_row, a_column, b + start * b_row, b_row, b_column, out + start * _REAL, out_row)

    return numba.njit(numba.types.void(*[numba.types.intp] * 9), nogil=True)(kernel)


def _block(program: Program, split: int, rows: bool) -> Any:
    """The function of the addresses that writes the values of `WIDTH` poses."""
    intrinsic = import_module("numba.extending").intrinsic
    void = import_module("numba").types.void

    def emit(_context: Any, builder: Any, _signature: Any, addresses: Any) -> Any:
        return _emit(builder, program, split, rows, addresses)

    def typed(
        _context: Any, a: Any, a_row: Any, a_column: Any, b: Any, b_row: Any, b_column: Any, out: Any, out_row: Any
    ) -> Any:
        return void(a, a_row, a_column, b, b_row, b_column, out, out_row), emit

    return intrinsic(typed)


def _emit(builder: Any, program: Program, split: int, rows: bool, addresses: Any) -> Any:
    ir = import_module("llvmlite.ir")
    real, word = ir.DoubleType(), ir.IntType(32)
    vector = ir.VectorType(real, WIDTH)
    a, a_row, a_column, b, b_row, b_column, out, out_row = addresses
    size = out.type
    starts = [
        [builder.add(at, builder.mul(ir.Constant(size, lane), row)) for lane in range(WIDTH)]
        for at, row in ((a, a_row), (b, b_row))
    ]

    def loaded(k: int) -> Any:
        part, k = (0, k) if k < split else (1, k - split)
        step = ir.Constant(size, _REAL) if rows else (a_column, b_column)[part]
        shift = builder.mul(ir.Constant(size, k), step)
        found = ir.Constant(vector, ir.Undefined)
        for lane, start in enumerate(starts[part]):
            place = builder.inttoptr(builder.add(start, shift), real.as_pointer())
            found = builder.insert_element(found, builder.load(place), ir.Constant(word, lane))
        return found

    def constant(c: Any) -> Any:
        return ir.Constant(vector, [float(c)] * WIDTH)

    values: list[Any] = []
    for line in program.lines:
        if line.op == "input":
            values.append(loaded(line.args[0]))
        elif line.op == "inv":
            values.append(builder.fdiv(constant(1), values[line.args[0]]))
        elif line.op == "sqrt":
            name, kind = f"llvm.sqrt.v{WIDTH}f64", ir.FunctionType(vector, [vector])
            root = builder.module.declare_intrinsic(name, (), kind)
            values.append(builder.call(root, [values[line.args[0]]]))
        else:
            x = values[line.args[0]]
            y = values[line.args[1]] if line.op in BINARY else constant(line.constant)
            values.append(getattr(builder, _INSTRUCTIONS[line.op])(x, y))
    for k, r in enumerate(program.results):
        if isinstance(r, int):
            place = builder.add(out, builder.mul(ir.Constant(size, k), out_row))
            builder.store(values[r], builder.inttoptr(place, vector.as_pointer()), align=_REAL)
    return ir.Constant(ir.IntType(8).as_pointer(), None)
