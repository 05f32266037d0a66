"""How much memory there is, how much of it this process uses, and how much it may use."""

from __future__ import annotations

import os
from math import inf

from gcrules.core.errors import InputError

__all__ = ["GIGABYTE", "memory_in_use", "memory_limit"]

GIGABYTE = 2**30
VARIABLE = "GCRULES_MEMORY"
_SHARE = 0.75  # of what this process uses and what is free
_PAGE = os.sysconf("SC_PAGE_SIZE") if hasattr(os, "sysconf") else 4096
_CONTAINERS = ("/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes")


def memory_in_use() -> int:
    """Bytes of this process that are in memory; 0 where the system does not tell."""
    try:
        with open("/proc/self/statm", "rb") as file:
            return int(file.read().split()[1]) * _PAGE
    except (OSError, ValueError, IndexError):
        return 0


def memory_limit(gigabytes: float | None = None) -> int | None:
    """Bytes that a command may use: so many gigabytes, else GCRULES_MEMORY of them, else three quarters of what the
    machine or container has left; None (no limit) where infinity is asked for, the variable is 0, or the system does
    not tell.

    Raises InputError where the variable is no number.
    """
    if gigabytes is not None:
        most = gigabytes * GIGABYTE
        return int(most) if most < inf else None
    asked = os.environ.get(VARIABLE, "").strip()
    if not asked:
        return _share()
    try:
        gigabytes = float(asked)
    except ValueError:
        gigabytes = -1.0
    if not 0 <= gigabytes < inf:
        raise InputError(f"{VARIABLE} is {asked!r}, expected a number of gigabytes", hint="0 means no limit")
    return int(gigabytes * GIGABYTE) or None


def _share() -> int | None:
    sizes = [size for size in (_free(), _of_container()) if size]
    return int(_SHARE * min(sizes)) if sizes else None


def _free() -> int:
    """What is free on the machine, with what this process has; 0 if unknown."""
    try:
        with open("/proc/meminfo", encoding="ascii") as file:
            for line in file:
                if line.startswith("MemAvailable:"):
                    return int(line.split()[1]) * 1024 + memory_in_use()
    except (OSError, ValueError, IndexError):
        pass
    return 0


def _of_container() -> int:
    """What a container may use; 0 if it may use all, or if there is none."""
    for name in _CONTAINERS:
        try:
            with open(name, encoding="ascii") as file:
                return int(file.read())  # "max" is no number
        except (OSError, ValueError):
            continue
    return 0
