r"""Which numbers of a pose stay free, and what the others are.

>>> q = question("x, z", None, None, "quaternion", "mm")
>>> q.free, dict(q.fixed), [str(c) for c in q.turn]
(('x', 'z'), {'y': Fraction(0, 1)}, ['1', '0', '0', '0'])
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near, run_together
from gcrules.poses.numbers.pose_arguments import read_one
from gcrules.screws.pose import Pose, exact, read_number
from gcrules.screws.pose_text import Amount, WrittenTurn, written_turn
from gcrules.screws.rotations import Quaternion, check_sequence, is_rounded, product

__all__ = ["ROTATIONS", "Question", "half_tangents", "images", "question", "read_fixed", "read_free"]

TRANSLATION = ("x", "y", "z")
ROTATIONS = {"quaternion": ("e0", "e1", "e2", "e3"), "rodrigues": ("c1", "c2", "c3")}
TANGENTS = ("t1", "t2", "t3")
_DENOMINATORS = 10**6  # of half-angle tangents of angles that are given
MEANINGS = {
    "quaternion": "the quaternion of the turn, cosine first, of any length",
    "rodrigues": "(e1, e2, e3)/e0, the axis of the turn times the tangent of half its angle (infinite for half turns)",
}


@dataclass(frozen=True)
class Question:
    """The variables that are `free` and the values of the `fixed` ones. `rotation` is quaternion | rodrigues | a
    sequence of Euler angles (tangents of their halves); `turn` is the quaternion where its variables are not asked for.
    `written` is how the pose says the turn that `turn`, or values of `fixed`, are taken from; tangents are `rounded`
    there that are not exactly those of its angles.
    """

    rotation: str
    free: tuple[str, ...]
    fixed: Mapping[str, Fraction]
    turn: Quaternion | None
    written: WrittenTurn | None = None
    rounded: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "fixed", FrozenMap(self.fixed))

    @property
    def whole(self) -> bool:
        """Whether every pose is meant, not a slice of them."""
        return not self.fixed and self.turn is None

    @property
    def turn_is_rounded(self) -> bool:
        """Whether the turn, or the part of it that is not free, was rounded."""
        fixed = (c for n, c in self.fixed.items() if n not in TRANSLATION)
        return bool(self.rounded) or is_rounded((*(self.turn or ()), *fixed))

    @property
    def meaning(self) -> str:
        """What the variables of the turn are."""
        angles = f"tangents of half the Euler angles {self.rotation} (infinite for 180 deg)"
        return MEANINGS.get(self.rotation, angles)


def question(
    over: str | Sequence[str] | None,
    fix: str | Mapping[str, Any] | None,
    at: str | Pose | None,
    rotation: str,
    unit: str,
) -> Question:
    """What is asked for. `over` names the free variables (or translation, rotation, all), `fix` gives values to others,
    the rest is taken from the pose `at`.

    Raises InputError for unknown names, names given twice, and where nothing is left free.
    """
    turning = _turning(rotation)
    names = (*TRANSLATION, *turning)
    fixed = read_fixed(fix, names)
    groups = {"translation": TRANSLATION, "rotation": turning, "all": names}
    free = [n for n in names if n not in fixed] if over is None else read_free(over, names, groups)
    both = [n for n in free if n in fixed]
    if both:
        raise InputError(f"{', '.join(both)} cannot be free and fixed")
    if not free:
        raise InputError("no variable is left free", hint=f"the variables are {', '.join(names)}")
    rest = [n for n in names if n not in free and n not in fixed]
    if at is not None and not rest:
        raise InputError(
            "every variable is free or fixed, so nothing is taken from the pose",
            hint="name the free ones: --over translation, or --over x,y",
        )
    pose = Pose() if at is None else read_one(at, unit)
    written = written_turn(at, unit) if isinstance(at, str) else None
    fixed |= {n: c for n, c in zip(TRANSLATION, pose.translation, strict=True) if n in rest}
    if all(n in rest for n in turning):
        return Question(rotation, tuple(free), fixed, pose.quaternion, written)
    taken = [n for n in turning if n in rest]
    rounded: tuple[str, ...] = ()
    if taken and written is not None and (angles := written.in_kind(rotation)):
        tangents, rounded = half_tangents({n: a for n, a in zip(turning, angles, strict=True) if n in taken})
        fixed |= tangents
    elif taken:
        fixed |= _parameters(pose, rotation, turning, taken)
    if rotation == "quaternion" and not any(fixed.get(n, 1) for n in turning):
        raise InputError("e0, e1, e2 and e3 are all 0, which is not a turn", hint="no turn at all is e0=1")
    return Question(rotation, tuple(free), fixed, None, written if taken else None, rounded)


def _turning(rotation: str) -> tuple[str, ...]:
    if rotation in ROTATIONS:
        return ROTATIONS[rotation]
    try:
        check_sequence(rotation)
    except InputError:
        known = (*ROTATIONS, "zyx", "ZYX", "xyz", "zxz")
        raise InputError(
            f"there is no rotation {rotation[:20]!r}",
            hint=near(rotation, known) or "write quaternion, rodrigues, or a sequence of Euler angles such as zyx",
        ) from None
    return TANGENTS


def _known(name: str, names: Sequence[str]) -> str:
    if name not in names:
        apart = run_together(name, names)
        known = f"the variables are {', '.join(names)}"
        hint = f'separate them: "{", ".join(apart)}"; {known}' if apart else near(name, names) or known
        raise InputError(f"{name[:40]!r} is not a variable of a pose", hint=hint)
    return name


def read_free(over: str | Sequence[str], names: Sequence[str], groups: Mapping[str, Sequence[str]]) -> list[str]:
    """The free variables, in the order of all names; `groups` are names of several. Raises InputError."""
    words = re.split(r"[\s,]+", over.strip()) if isinstance(over, str) else list(over)
    found = [n for word in words for n in groups.get(word, (word,)) if word]
    for n in found:
        _known(n, [*names, *groups])
    twice = next((n for i, n in enumerate(found) if n in found[:i]), None)
    if twice is not None:
        raise InputError(f"the variable {twice} is named twice")
    return [n for n in names if n in found]


def read_fixed(fix: str | Mapping[str, Any] | None, names: Sequence[str]) -> dict[str, Fraction]:
    """The values that variables are given. Raises InputError."""
    if isinstance(fix, str):
        parts = [part.split("=") for part in re.split(r"[,;]", fix) if part.strip()]
        wrong = next(("=".join(part) for part in parts if len(part) != 2), None)
        if wrong is not None:
            raise InputError(f"{wrong.strip()[:40]!r} fixes nothing", hint='write "x=0, e1=1/2"')
        found: dict[str, Fraction] = {}
        for name, value in parts:
            if name.strip() in found:
                raise InputError(f"the variable {name.strip()} is fixed twice")
            found[_known(name.strip(), names)] = read_number(value.strip())
        return found
    return {_known(str(n), names): exact(value, f"the value of {n}") for n, value in (fix or {}).items()}


def _parameters(pose: Pose, rotation: str, turning: Sequence[str], taken: Sequence[str]) -> dict[str, Fraction]:
    """The values that the turn of a pose gives to those of its variables that are taken from it."""
    w, *v = pose.quaternion
    if rotation == "quaternion":
        values: Sequence[Fraction] = pose.quaternion
    elif rotation == "rodrigues":
        if not w:
            raise InputError("a half turn has no Rodrigues parameters", hint="use --rotation quaternion")
        values = [c / w for c in v]
    elif any(v):
        missing = ", ".join(f"{n}=…" for n in taken)
        raise InputError(
            f"half-angle tangents of {rotation} are not taken from a turn that is given otherwise",
            hint=f'give the angles, --at "0 0 0; euler {rotation} 10 20 30 deg", or the tangents: --fix "{missing}"',
        )
    else:
        values = [Fraction(0)] * 3
    return {n: c for n, c in zip(turning, values, strict=True) if n in taken}


def half_tangents(angles: Mapping[str, Amount]) -> tuple[dict[str, Fraction], tuple[str, ...]]:
    """The tangents of half the angles by their names, and the names of those that are rounded: all but quarter turns,
    to fractions with denominators up to a million. Raises InputError for half a turn.
    """
    tangents = {n: _half_tangent(a, n) for n, a in angles.items()}
    return tangents, tuple(n for n, a in angles.items() if not _is_quarter(a))


def _half_tangent(angle: Amount, name: str) -> Fraction:
    if _is_quarter(angle) and angle.number % 360 != 180:
        return Fraction((0, 1, 0, -1)[int(angle.number // 90) % 4])
    half = float(angle) / 2
    if abs(math.cos(half)) < 1e-9:
        raise InputError(f"half a turn has no half-angle tangent {name}", hint="take a smaller angle")
    return Fraction(math.tan(half)).limit_denominator(_DENOMINATORS)


def _is_quarter(angle: Amount) -> bool:
    return not angle.number or (angle.degrees and not angle.number % 90)


def images(q: Question, ring: Any) -> tuple[tuple[Any, ...], tuple[Any, ...], tuple[Any, ...]]:
    """x, y, z and e0, e1, e2, e3 as polynomials in the free variables, and what their norm |e|² is a product of."""
    free = dict(zip(q.free, ring.gens, strict=True))

    def value(name: str) -> Any:
        return free[name] if name in free else ring.ground_new(_rational(ring, q.fixed[name]))

    one, zero = ring.one, ring.zero
    shift = tuple(map(value, TRANSLATION))
    if q.turn is not None:
        turn = tuple(ring.ground_new(_rational(ring, c)) for c in q.turn)
    elif q.rotation in ROTATIONS:
        turn = tuple(map(value, ROTATIONS[q.rotation]))
        turn = turn if len(turn) == 4 else (one, *turn)
    else:
        tangents = tuple(map(value, TANGENTS))
        parts = [
            (one, *(t if axis == letter else zero for axis in "xyz"))
            for letter, t in zip(q.rotation.lower(), tangents, strict=True)
        ]
        if q.rotation.isupper():
            parts.reverse()
        turn = product(parts[2], product(parts[1], parts[0]))
        return shift, turn, tuple(1 + t**2 for t in tangents)
    return shift, turn, (sum(c**2 for c in turn),)


def _rational(ring: Any, c: Fraction) -> Any:
    return ring.domain(c.numerator, c.denominator)
