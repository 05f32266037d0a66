"""The search for the nearest singular configuration: all ways side by side, beside one after the other."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from gcrules.mechanisms.kinematics.solve import free_coordinates
from gcrules.mechanisms.mechanism import mechanism
from gcrules.poses.limbs.nearest import directions_around
from gcrules.poses.limbs.rays import Bundle


@pytest.mark.parametrize("name", ["3-rps", "3-rpr", "delta"])
def test_ways_side_by_side(ratio: Callable[..., Any], name: str) -> None:
    m = mechanism(name).linkage  # type: ignore[attr-defined]
    bundle = Bundle(m, free_coordinates(m))
    every = directions_around(len(bundle.names))

    def together() -> Any:
        return bundle.ends(every, 1.0).distance

    def alone() -> Any:
        return np.concatenate([bundle.ends(one[None], 1.0).distance for one in every])

    def agree(one: Any, other: Any) -> bool:
        return bool(np.allclose(one, other, rtol=1e-6))

    ratio(together, {"one by one": alone}, agree=agree, at_least={"one by one": 3}, rounds=2, others_rounds=1)
