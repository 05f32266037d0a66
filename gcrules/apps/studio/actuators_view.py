"""The actuators at a pose, for the page: how long or how far they are, what they reach, and what they make of it."""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees

from gcrules.apps.studio.items import fact
from gcrules.apps.studio.protocol.answer_views import ActuatorView
from gcrules.apps.studio.protocol.study_views import FactItem
from gcrules.mechanisms.kinematics.wrenches import WrenchJacobian
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.views.results.actuators import reaches
from gcrules.views.results.amplification import amplification_rows, conditioning, jacobian_numbers

__all__ = ["actuator_views", "jacobian_facts"]


def actuator_views(m: Mechanism, values: Mapping[str, float], j: WrenchJacobian) -> list[ActuatorView]:
    """Of each leg its length, of each actuator its amount from home (radians where it turns)."""
    known, angles = reaches(m), dict(zip(j.actuators, j.drives.angles, strict=True))
    rows = {name: (speed, turn) for name, speed, turn in amplification_rows(j.amplification, m.unit)}
    return [
        {
            "name": name,
            "value": degrees(value) if angles[name] else value,
            "unit": "deg" if angles[name] else m.unit,
            "low": known.get(name, (None, None))[0],
            "high": known.get(name, (None, None))[1],
            "speed": rows.get(name, ("", ""))[0],
            "turn": rows.get(name, ("", ""))[1],
        }
        for name, value in values.items()
    ]


def jacobian_facts(j: WrenchJacobian, unit: str) -> list[FactItem]:
    """Its size, and how well it is conditioned, as `gcrules pose` says it."""
    return [
        fact("Jacobian", f"{len(j.labels)} wrenches, {jacobian_numbers(j, unit)}"),
        fact("actuators", conditioning(j.amplification, unit)),
    ]
