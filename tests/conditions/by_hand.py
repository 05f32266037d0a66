"""Sessions by hand, played."""

from __future__ import annotations

from typing import Any

import pytest
from platform_classes import REGULAR

from gcrules.conditions.manual import ManualSession

__all__ = ["EACH", "fits", "legs_of", "played"]

EACH = pytest.mark.parametrize("facts", REGULAR, ids=[c["id"] for c in REGULAR])


def legs_of(facts: dict[str, Any]) -> str:
    return " ".join(facts["legs"])


def played(legs: str, *commands: str, **options: Any) -> ManualSession:
    session = ManualSession.start(legs, **options)
    for command in commands:
        session = session.do(command)
    return session


def fits(brackets: list[set[int]], rows: list[set[int]]) -> bool:
    """Whether each row can have a bracket of its own, by trying all."""
    if not rows:
        return True
    return any(
        rows[0] <= b and fits([x for j, x in enumerate(brackets) if j != i], rows[1:]) for i, b in enumerate(brackets)
    )
