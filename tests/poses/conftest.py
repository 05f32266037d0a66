"""What the tests of this room share."""

from __future__ import annotations

import pytest
from places import EXAMPLES
from poses.platforms import PLATFORMS

from gcrules.conditions.analysis import Analysis
from gcrules.mechanisms.description.platform_file import load_platform
from gcrules.mechanisms.platform_analysis import analyze_legs


@pytest.fixture(scope="session")
def robots() -> dict[str, Analysis]:
    """The platforms of examples/, and one that is singular where it stands."""
    return {n: analyze_legs(load_platform(EXAMPLES / f"{n}.yaml")) for n in (*PLATFORMS, "octahedral-singular")}


@pytest.fixture(scope="session")
def robot() -> str:
    """A file for commands."""
    return str(EXAMPLES / "octahedral.yaml")
