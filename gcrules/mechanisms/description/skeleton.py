"""The commented robot file with which a new robot begins."""

from __future__ import annotations

import re

from gcrules.core.errors import InputError

__all__ = ["skeleton"]

_ID = re.compile(r"[a-z0-9][a-z0-9-]{0,39}")

_TEXT = """\
# A robot for gcrules; docs/robots.md describes the format. Check it with: gcrules robot check FILE
# yaml-language-server: $schema=robot.schema.json
title: {id}
# source: a key of the list of references, and what of it was really read
note: an example to begin with, a 3-RPS robot
copies: 3 # % stands for 1, 2 and 3 in names, relations and limbs

# Each point and direction has one relation that makes it from others; together they say which robots are meant.
#   free · on line A B · on line A along u · in plane A B C · in plane A along u, v · in plane A perpendicular to n
#   sums: B1 + A2 - A1, 1/2 A + 1/2 B, S1 + x
points:
  A%: free
  S%: in plane A% perpendicular to r%
#   free · along A B · parallel to u · perpendicular to u · perpendicular to u, v · in span u, v · sums: u + 2 v
#   mirror of u in plane perpendicular to n
#   x, y and z are the directions of the frame. Lengths of directions do not matter.
directions:
  r%: free

# Joints from the base to the platform, a star at what is actuated; two points stand for a direction.
#   R(point, axis) · P(direction) · H(point, axis, pitch) · C(point, axis) · U(point, first, second) · S(point)
#   E(point, normal) · Pa(bars, axis) · 4S(first, second, bars)
#   Joints may bear names, R*:a(A1, u) R:b(B1, u); then the limb may say "couplings: b = -2 a", for gears and belts.
limbs:
  - name: leg %
    joints: R(A%, r%) P*(A% S%) S(S%)

platform: S% # optional: the points that move with the platform
mobility: 3 # of the platform; checked

# facts: ["S% in plane A% perpendicular to r%"] # what follows from the relations; checked
# units: mm # of all lengths in the file: m, dm, cm, mm, um, in, ft
# limits: actuators -0.5..0.5 # what actuators reach from home; q1, q2, ... for single ones, angles with deg or rad
# condition: "..." # a published condition in the language of gcrules; compared
# One configuration, checked against the relations; what they determine may be left out.
home:
  A1: [2, 0, 0]
  A2: [-1, 2, 0]
  A3: [-1, -2, 0]
  r1: [0, 1, 0]
  r2: [2, 1, 0]
  r3: [2, -1, 0]
  S1: [1, 0, 2]
  S2: [-1/2, 1, 2]
  S3: [-1/2, -1, 2]
"""


def skeleton(robot_id: str) -> str:
    """The text of a file that passes `gcrules robot check`. Raises InputError for what is no id."""
    if not _ID.fullmatch(robot_id):
        raise InputError(
            f"{robot_id[:40]!r} is not an id for a robot", hint="lower-case letters, digits and hyphens: my-robot"
        )
    return _TEXT.format(id=robot_id)
