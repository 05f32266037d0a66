r"""Runs a program on arrays of poses in chunks that stay in the cache: by NumPy, or by numba where it is installed.

Both do the same operations on the same numbers and contract none, so their values are equal to the last bit.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from importlib import import_module
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.compiling.tape import BINARY, Program, allocated, fused, inputs_first
from gcrules.errors import InputError

__all__ = ["ENGINES", "Run", "engine_named", "runner"]

Floats = NDArray[np.float64]
Run = Callable[[Floats, Floats, Floats], None]
"""run(first, second, out): the values for n poses whose inputs are the columns of two arrays, (n, k) and (n, m)."""

ENGINES = ("numpy", "numba")

CACHE = 1 << 20
"""Bytes that the registers of a chunk may take: a half of the second-level cache of an ordinary core."""

LANES = 144
"""Poses that numba works on at once, so that their registers stay in the nearest cache: a multiple of 16, for vectors,
and no power of two, which would put all registers in the same lines of the cache."""


def engine_named(name: str | None) -> str:
    """The engine to use; None takes numba where it is installed. Raises InputError for others and for a missing one."""
    if name is None:
        return "numba" if find_spec("numba") else "numpy"
    if name not in ENGINES:
        raise InputError(f"there is no engine {name!r}", hint=f"choose one of {', '.join(ENGINES)}")
    if not find_spec(name):
        raise InputError(f"{name} is not installed", hint="pip install gcrules[fast], or take the engine numpy")
    return name


def runner(program: Program, engine: str) -> Run:
    """What runs a program that has lines."""
    return _numba(program) if engine == "numba" else _numpy(program)


def _numpy(program: Program) -> Run:
    held, count = allocated(program.lines)
    size = int(np.clip(CACHE // (8 * count), 256, 16_384))
    ufuncs = {"add": np.add, "sub": np.subtract, "mul": np.multiply, "shift": np.add, "scale": np.multiply}
    constants = [np.array(float(line.constant)) for line in program.lines]
    one = np.array(1.0)

    def calls(registers: Floats) -> list[tuple[Any, Any, Any, Floats]]:
        """What to call on which arrays; None for an input, with its column."""
        found: list[tuple[Any, Any, Any, Floats]] = []
        for n, line in enumerate(program.lines):
            out = registers[held[n]]
            if line.op == "input":
                found.append((None, line.args[0], None, out))
                continue
            a = registers[held[line.args[0]]]
            if line.op == "inv":
                found.append((np.divide, one, a, out))
            else:
                other = registers[held[line.args[1]]] if line.op in BINARY else constants[n]
                found.append((ufuncs[line.op], a, other, out))
        return found

    def run(first: Floats, second: Floats, out: Floats) -> None:
        columns = [*first.T, *second.T]
        registers = np.empty((count, min(size, len(out))))
        whole = calls(registers)
        with np.errstate(all="ignore"):  # what is not finite is looked for in the values
            for start in range(0, len(out), size):
                stop = min(start + size, len(out))
                part = whole if stop - start == registers.shape[1] else calls(registers[:, : stop - start])
                for ufunc, a, b, to in part:
                    if ufunc is None:
                        to[:] = columns[a][start:stop]
                    else:
                        ufunc(a, b, to)
                out[start:stop] = part[-1][3]

    return run


_CODES = (
    *("add", "sub", "mul", "shift", "scale", "inv"),
    *("mul_add_mul", "mul_sub_mul", "add_mul", "sub_mul", "mul_sub", "add_scale", "sub_scale", "scale_sub"),
)


def _numba(program: Program) -> Run:
    lines = fused(inputs_first(program))
    held, count = allocated(lines)
    rest = [(n, line) for n, line in enumerate(lines) if line.op != "input"]
    code = np.zeros((len(rest), 6), dtype=np.int64)  # operation, register written, up to four operands
    for row, (n, line) in zip(code, rest, strict=True):
        row[: 2 + len(line.args)] = [_CODES.index(line.op), held[n], *(held[m] for m in line.args)]
    constants = np.array([float(line.constant) for _, line in rest])
    inputs = np.array(held[: program.inputs], dtype=np.int64)
    result = held[-1] if rest else held[program.lines[0].args[0]]  # of a program that is one input only
    kernel = _kernel()

    def run(first: Floats, second: Floats, out: Floats) -> None:
        kernel(code, constants, inputs, result, first, second, np.zeros((count, LANES)), out)

    return run


@lru_cache(maxsize=1)
def _kernel() -> Any:
    """The interpreter of the tape, compiled once for all programs."""
    numba = import_module("numba")
    integer, real = numba.types.int64, numba.types.float64
    poses = numba.types.Array(real, 2, "A", readonly=True)  # any strides, so that it is compiled once
    signature = numba.types.void(integer[:, ::1], real[::1], integer[::1], integer, poses, poses, real[:, ::1], real[:])
    # Without fastmath numba rounds each product and each sum, as NumPy does.
    return numba.njit(signature, nogil=True, error_model="numpy")(_interpret)


def _interpret(code: Any, constants: Any, inputs: Any, result: int, first: Any, second: Any, r: Any, out: Any) -> None:
    """The tape on blocks of poses; each line is one loop over the block, which the compiler makes vectors of."""
    n, lanes, width = len(out), r.shape[1], first.shape[1]
    for start in range(0, n, lanes):
        m = min(lanes, n - start)
        for k in range(len(inputs)):
            column = first[start : start + m, k] if k < width else second[start : start + m, k - width]
            row = r[inputs[k]]
            for i in range(m):
                row[i] = column[i]
        for at in range(len(code)):
            op, z, x, y, u, v = code[at]
            c = constants[at]
            if op == 0:
                for i in range(lanes):
                    r[z, i] = r[x, i] + r[y, i]
            elif op == 1:
                for i in range(lanes):
                    r[z, i] = r[x, i] - r[y, i]
            elif op == 2:
                for i in range(lanes):
                    r[z, i] = r[x, i] * r[y, i]
            elif op == 3:
                for i in range(lanes):
                    r[z, i] = r[x, i] + c
            elif op == 4:
                for i in range(lanes):
                    r[z, i] = r[x, i] * c
            elif op == 5:
                for i in range(lanes):
                    r[z, i] = 1.0 / r[x, i]
            elif op == 6:
                for i in range(lanes):
                    r[z, i] = r[x, i] * r[y, i] + r[u, i] * r[v, i]
            elif op == 7:
                for i in range(lanes):
                    r[z, i] = r[x, i] * r[y, i] - r[u, i] * r[v, i]
            elif op == 8:
                for i in range(lanes):
                    r[z, i] = r[x, i] + r[y, i] * r[u, i]
            elif op == 9:
                for i in range(lanes):
                    r[z, i] = r[x, i] - r[y, i] * r[u, i]
            elif op == 10:
                for i in range(lanes):
                    r[z, i] = r[y, i] * r[u, i] - r[x, i]
            elif op == 11:
                for i in range(lanes):
                    r[z, i] = r[x, i] + r[y, i] * c
            elif op == 12:
                for i in range(lanes):
                    r[z, i] = r[x, i] - r[y, i] * c
            else:
                for i in range(lanes):
                    r[z, i] = r[y, i] * c - r[x, i]
        for i in range(m):
            out[start + i] = r[result, i]
