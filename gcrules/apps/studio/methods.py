"""Everything that a page can ask for: the shape of its arguments, where it is worked out, and for how long.

What answers it stands in `answers`; the engine is not loaded here, so that the server is there at once.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal, get_args

from gcrules.apps.studio.answer_views import Format
from gcrules.apps.studio.checking import Check, choice, listed, mapped, number, one_of, record, text, tuple_of
from gcrules.core.errors import InputError

__all__ = ["LONGEST", "METHODS", "SOURCE", "Method"]

LONGEST = 1_000_000
"""Characters of a message; files are sent in one."""


@dataclass(frozen=True)
class Method:
    """It works in the server itself, in turn (`numbers`), or in a `worker` process, which is ended after so many
    `seconds`, and when the page gives up.
    """

    args: Check
    where: Literal["numbers", "worker"] = "worker"
    seconds: float = 60.0


# --- shapes of arguments -------------------------------------------------------------------------------------------

_name = text(200)
_coordinate = number(-1e12, 1e12)
_kind = {"kind": choice("class", "legs", "example", "robot", "file")}
_vector = tuple_of(_coordinate, _coordinate, _coordinate)
_unit = number(-10, 10)
_point = text(40)

SOURCE = one_of(
    "kind",
    {
        "class": record({**_kind, "id": _name}),
        "legs": record({**_kind, "legs": text(4_000)}),
        "example": record({**_kind, "name": _name}),
        "robot": record({**_kind, "id": _name}),
        "file": record({**_kind, "text": text(400_000), "name": _name}),
    },
)


def _turn(value: Any, where: str) -> Any:
    found = tuple_of(_unit, _unit, _unit, _unit)(value, where)
    if not 1e-6 < sum(c * c for c in found) < 100:
        raise InputError(f"{where} has no length", hint="a turn is a quaternion, scalar first")
    return found


_pose = record({"translation": _vector, "quaternion": _turn}, {"coordinates": listed(_coordinate, 24)})
_threshold = {"threshold": text(40)}
_drawing = record(
    {
        "title": text(200, empty=True),
        "points": mapped(_point, _vector, 40),
        "base": listed(_point, 40),
        "platform": listed(_point, 40),
        "legs": listed(tuple_of(_point, _point), 24),
    }
)
_nothing = record({})


METHODS: Mapping[str, Method] = {
    "gallery": Method(_nothing),
    "open": Method(record({"source": SOURCE}), seconds=120),
    "pose": Method(record({"source": SOURCE, "pose": _pose}, _threshold), where="numbers"),
    "along": Method(record({"source": SOURCE, "poses": listed(_pose, 2_000, 1)}, _threshold)),
    "nearest": Method(record({"source": SOURCE, "pose": _pose}, _threshold), seconds=120),
    "manual": Method(record({"source": SOURCE, "commands": listed(text(500), 200)})),
    "bench": Method(record({"text": text(20_000, empty=True)}, {"source": SOURCE, "pose": _pose}), seconds=30),
    "compose": Method(record({"drawing": _drawing})),
    "save": Method(record({"source": SOURCE, "pose": _pose, "what": choice(*get_args(Format))}, _threshold)),
}
