"""What the tests of this room share."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest
from places import EXAMPLES
from poses.platforms import PLATFORMS

from gcrules.conditions.analysis import Analysis
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.poses.compiling.compiled import compiled
from gcrules.poses.maps import planned


@pytest.fixture(scope="session")
def robots() -> dict[str, Analysis]:
    """The platforms of examples/, and one that is singular where it stands."""
    return {n: analyze_legs(load_platform(EXAMPLES / f"{n}.yaml")) for n in (*PLATFORMS, "octahedral-singular")}


@pytest.fixture(scope="session")
def robot() -> str:
    """A file for commands."""
    return str(EXAMPLES / "octahedral.yaml")


@pytest.fixture(scope="module")
def compiled_once() -> Iterator[None]:
    """Conditions are compiled once for each robot and centre, which is what most small maps wait for."""
    known: dict[Any, Any] = {}

    def made(a: Analysis, *, about: Any) -> Any:
        key = a.structure.legs, a.platform and a.platform.points, about
        return known.setdefault(key, known.get(key) or compiled(a, about=about, engine="numpy"))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(planned, "compiled", made)
        yield
