"""What the studio needs beyond gcrules itself: the packages of the extra `studio`."""

from __future__ import annotations

from typing import Any

from gcrules.core.deferred import resolved
from gcrules.core.errors import InputError

__all__ = ["of_studio"]

_PACKAGES = ("starlette", "uvicorn", "websockets")


def of_studio(where: str) -> Any:
    """A name of a module of the studio, "window:StudioWindow". Raises InputError where a package that it needs is
    missing, with what installs it.
    """
    try:
        return resolved(f"gcrules.apps.studio.{where}")
    except ImportError as missing:
        if (missing.name or "").split(".")[0] not in _PACKAGES:
            raise
        raise InputError(
            f"the studio needs {missing.name}, which is not installed", hint='pip install "gcrules[studio]"'
        ) from missing
