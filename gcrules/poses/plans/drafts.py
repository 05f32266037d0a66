"""Ways through states that are tried to be proved: shorter, smoother, and with few digits."""

from __future__ import annotations

from collections.abc import Iterator

from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.poses.plans.domain import Domain
from gcrules.poses.plans.report import Waypoint
from gcrules.poses.plans.roadmap import shortened
from gcrules.poses.plans.smoothing import rounded_corners

__all__ = ["as_waypoints", "drafts"]


def drafts(domain: Domain, start: Waypoint, goal: Waypoint, rows: Floats) -> Iterator[list[Waypoint]]:
    """Ways from start to goal through the states on a way (N, width): shorter ones with few digits, the smoothest
    first, and at last the way itself.
    """
    short = shortened(domain.space, rows)
    smooth = rounded_corners(domain.space, short)
    for each in [smooth, short] if len(smooth) > len(short) else [short]:
        yield as_waypoints(domain, start, goal, each, rounded=True)
    yield as_waypoints(domain, start, goal, rows, rounded=False)


def as_waypoints(domain: Domain, start: Waypoint, goal: Waypoint, rows: Floats, *, rounded: bool) -> list[Waypoint]:
    """The way from start to goal through the states between them; rounded it can be written with few digits."""
    between = (domain.waypoint(row, rounded=rounded) for row in rows[1:-1])
    return domain.continued([start, *between, goal])
