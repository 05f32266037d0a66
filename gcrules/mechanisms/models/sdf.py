"""Reading SDF."""

from __future__ import annotations

from gcrules.mechanisms.models.model import Model
from gcrules.mechanisms.models.xml_files import Element

__all__ = ["read_sdf"]


def read_sdf(root: Element) -> Model:
    """The model of an element `<sdf>`."""
    raise root.error("models in SDF are not read yet")
