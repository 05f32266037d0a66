r"""Limbs of a robot as they are written: joints from the base to the platform, those with an actuator starred.

>>> joints = read_joints("U(A1, u1, v1) P*(A1 B1) S(B1)")
>>> print(*joints)
U(A1, u1, v1) P*(A1 B1) S(B1)
>>> [j.kind for j in joints], [j.actuated for j in joints]
(['U', 'P', 'S'], [(), (0,), ()])
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction

from gcrules.core.errors import InputError, Span
from gcrules.core.hints import near
from gcrules.mechanisms.description.relations import Term, Values, combined, pair_or_name
from gcrules.screws import JOINTS, Field, Joint, Limb

__all__ = ["JointSpec", "LimbSpec", "cable_joints", "read_joints"]

_JOINT = re.compile(r"\s*,?\s*([0-9A-Za-z]+)\s*(\*\d?)?\s*\(([^()]*)\)\s*")
_NAMES = re.compile(r"[A-Za-z][\w']*(?:\s+[A-Za-z][\w']*)?")
_EXAMPLE = "a limb is written U(A1, u1, v1) P*(A1 B1) S(B1), with a star at what is actuated"
_NOWHERE = Span(0, 0)


@dataclass(frozen=True)
class JointSpec:
    """A joint as written: `args` are names, directions may be two points; `actuated` are places of its freedoms."""

    kind: str
    args: tuple[Term | Fraction, ...]
    actuated: tuple[int, ...] = ()
    text: str = ""
    place: Span = _NOWHERE

    @property
    def names(self) -> tuple[str, ...]:
        """All names, in the order in which they are written."""
        return tuple(dict.fromkeys(n for arg in self.args if isinstance(arg, tuple) for _, n in reversed(arg)))

    @property
    def points(self) -> tuple[str, ...]:
        """The names that stand where the joint has a point."""
        forms = JOINTS[self.kind].parts.values()
        return tuple(
            arg[0][1] for form, arg in zip(forms, self.args, strict=True) if form == "point" and isinstance(arg, tuple)
        )

    @property
    def directions(self) -> tuple[Term, ...]:
        """What stands where the joint has a direction."""
        forms = JOINTS[self.kind].parts.values()
        return tuple(
            arg for form, arg in zip(forms, self.args, strict=True) if form == "direction" and isinstance(arg, tuple)
        )

    def at(self, values: Values, field: Field) -> Joint:
        """The joint at a member. What makes no joint shows when its twists are computed."""
        kind = JOINTS[self.kind]
        geometry = (combined(a, values, field) if isinstance(a, tuple) else a for a in self.args)
        return Joint(kind, dict(zip(kind.parts, geometry, strict=True)), self.actuated)

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True)
class LimbSpec:
    """A limb; `through` are points that lines of its wrenches may go through beside those of its joints. A `cable` has
    the joints of a leg with ball ends, and only pulls.
    """

    name: str
    joints: tuple[JointSpec, ...]
    through: tuple[str, ...] = ()
    cable: bool = False

    @property
    def chain(self) -> str:
        """The symbols of its joints, those with an actuator starred: UP*S."""
        if self.cable:
            return "cable"
        return "".join(j.kind + "*" * bool(j.actuated) for j in self.joints)

    @property
    def freedoms(self) -> int:
        """How many twists it has."""
        return sum(len(JOINTS[j.kind].freedoms) for j in self.joints)

    @property
    def actuators(self) -> int:
        """How many of them are driven."""
        return sum(len(j.actuated) for j in self.joints)

    def at(self, values: Values, field: Field) -> Limb:
        """The limb at a member."""
        return Limb(tuple(j.at(values, field) for j in self.joints), self.name)


def cable_joints(base: str, end: str, *, plane: bool) -> str:
    """The joints of a cable between two points, as they are written of a limb."""
    first, last = (f"R({base}, z)", f"R({end}, z)") if plane else (f"S({base})", f"S({end})")
    return f"{first} P*({base} {end}) {last}"


def read_joints(text: str) -> tuple[JointSpec, ...]:
    """Read the joints of a limb. Raises InputError with its place in the text."""
    return tuple(_joints(text))


def _joints(text: str) -> Iterator[JointSpec]:
    at = 0
    while at < len(text):
        match = _JOINT.match(text, at)
        if not match:
            raise _fault(text, at, len(text), f"{text[at : at + 30].strip()!r} is no joint", _EXAMPLE)
        yield _joint(text, match)
        at = match.end()
    if not at:
        raise _fault(text, 0, 1, "there are no joints", _EXAMPLE)


def _joint(text: str, match: re.Match[str]) -> JointSpec:
    symbol, star, inside = match.groups()
    start, end = match.span(1)
    if symbol not in JOINTS:
        hint = near(symbol, JOINTS) or f"the kinds are {', '.join(JOINTS)}"
        raise _fault(text, start, end, f"{symbol[:20]!r} is no kind of joint", hint)
    kind = JOINTS[symbol]
    parts = [part.strip() for part in inside.split(",")] if inside.strip() else []
    if len(parts) != len(kind.parts):
        hint = f"write {symbol}({', '.join(kind.parts)})"
        message = f"a joint {symbol} takes {len(kind.parts)} parts, found {len(parts)}"
        raise _fault(text, start, match.end(3) + 1, message, hint)
    args: list[Term | Fraction] = []
    for (part, form), word in zip(kind.parts.items(), parts, strict=True):
        names = word.split()
        if form == "number":
            if not re.fullmatch(r"-?\d{1,9}(/[1-9]\d{0,8}|\.\d{1,9})?", word):
                raise _fault(text, match.start(3), match.end(3), f"the {part} {word[:20]!r} is no number")
            args.append(Fraction(word))
        elif not _NAMES.fullmatch(word) or (form == "point" and len(names) != 1):
            needed = "a point" if form == "point" else "a direction, or two points"
            raise _fault(
                text, match.start(3), match.end(3) + 1, f"the {part} of {symbol} is {needed}, found {word[:30]!r}"
            )
        else:
            args.append(pair_or_name(word))
    written = f"{symbol}{star or ''}({', '.join(parts)})"
    return JointSpec(symbol, tuple(args), _actuated(text, match), written, Span(start, match.end(3) + 1))


def _actuated(text: str, match: re.Match[str]) -> tuple[int, ...]:
    symbol, star, _ = match.groups()
    if not star:
        return ()
    drives = JOINTS[symbol].drives
    chosen = tuple(drives) if star == "*" and len(drives) == len(JOINTS[symbol].freedoms) else ()
    if star != "*":
        chosen = (int(star[1:]) - 1,)
    elif not chosen and len(drives) == 1:
        chosen = (drives[0],)
    if not chosen or not set(chosen) <= set(drives):
        raise _fault(
            text, *match.span(1), f"this freedom of a joint {symbol} cannot be actuated", "drive joints R, P, H, C or U"
        )
    return chosen


def _fault(text: str, start: int, end: int, message: str, hint: str | None = None) -> InputError:
    return InputError(message, span=Span(start, max(end, start + 1)), source=text, hint=hint)
