"""The platforms of examples/ that the tests of poses go through."""

from __future__ import annotations

__all__ = ["PLATFORMS"]

PLATFORMS = ("octahedral", "platform-6-3", "platform-6-4", "platform-6-6", "four-dof")
