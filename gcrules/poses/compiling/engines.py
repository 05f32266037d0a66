r"""Runs a program on arrays of poses: by NumPy in chunks that stay in the cache, or as machine code made by numba.

Both do the same operations on the same numbers and contract none, so their values are equal to the last bit.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib.util import find_spec
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcrules.core.errors import InputError
from gcrules.poses.compiling.native import native
from gcrules.poses.compiling.tape import BINARY, Program, allocated

__all__ = ["ENGINES", "STEP", "Run", "engine_for", "engine_named", "runner"]

Floats = NDArray[np.float64]
Run = Callable[[Floats, Floats, Floats], None]
"""run(first, second, out): the values (results, n) for n poses whose inputs are the columns of two arrays, (n, k) and
(n, m).
"""

ENGINES = ("numpy", "numba")

STEP = 65_536
"""Poses that one call of an engine works on, after which the program can be interrupted."""

CACHE = 1 << 20
"""Bytes that the registers of a chunk may take: a half of the second-level cache of an ordinary core."""


_MANY = 1_000_000


def engine_named(name: str | None) -> str:
    """The engine to use; None takes numba where it is installed. Raises InputError for others and for a missing one."""
    if name is None:
        return "numba" if find_spec("numba") else "numpy"
    if name not in ENGINES:
        raise InputError(f"there is no engine {name!r}", hint=f"choose one of {', '.join(ENGINES)}")
    if not find_spec(name):
        raise InputError(f"{name} is not installed", hint='pip install "gcrules[fast]", or take the engine numpy')
    return name


def engine_for(poses: int) -> str:
    """The engine that has the values at so many poses first: numba takes a second to load and to compile."""
    return "numpy" if poses < _MANY else engine_named(None)


def runner(program: Program, engine: str) -> Run:
    """What runs a program."""
    fixed = {k: float(r) for k, r in enumerate(program.results) if not isinstance(r, int)}
    if not program.lines:
        return lambda _first, _second, out: _fill(out, fixed)
    call = native(program) if engine == "numba" else _numpy(program)
    if not fixed:
        return call

    def run(first: Floats, second: Floats, out: Floats) -> None:
        call(first, second, out)
        _fill(out, fixed)

    return run


def _fill(out: Floats, fixed: Mapping[int, float]) -> None:
    for k, value in fixed.items():
        out[k] = value


def _numpy(program: Program) -> Run:
    held, count = allocated(program)
    size = int(np.clip(CACHE // (8 * count), 256, 16_384))
    ufuncs = {"add": np.add, "sub": np.subtract, "mul": np.multiply, "shift": np.add, "scale": np.multiply}
    functions = {"sqrt": np.sqrt, "cos": np.cos, "sin": np.sin}
    constants = [np.array(float(line.constant)) for line in program.lines]
    one = np.array(1.0)
    kept = [(k, held[r]) for k, r in enumerate(program.results) if isinstance(r, int)]

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
            elif line.op in functions:
                found.append((functions[line.op], a, None, out))
            else:
                other = registers[held[line.args[1]]] if line.op in BINARY else constants[n]
                found.append((ufuncs[line.op], a, other, out))
        return found

    def run(first: Floats, second: Floats, out: Floats) -> None:
        columns = [*first.T, *second.T]
        number = out.shape[1]
        registers = np.empty((count, min(size, number)))
        whole = calls(registers)
        with np.errstate(all="ignore"):  # what is not finite is looked for in the values
            for start in range(0, number, size):
                stop = min(start + size, number)
                part = whole if stop - start == registers.shape[1] else calls(registers[:, : stop - start])
                for ufunc, a, b, to in part:
                    if ufunc is None:
                        to[:] = columns[a][start:stop]
                    elif b is None:
                        ufunc(a, to)
                    else:
                        ufunc(a, b, to)
                for k, register in kept:
                    out[k, start:stop] = registers[register, : stop - start]

    return run
