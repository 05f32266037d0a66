r"""Couplings of joints, as a robot file writes them: what gears, belts or cables inside a limb keep in one ratio.

>>> from gcrules.mechanisms.description.limb_file import read_limb
>>> joints, _ = read_limb("R:a(A, z) R*:b(B, z) R:c(C, z)")
>>> [(c.joint, c.leader, str(c.ratio)) for c in couplings("b = -2 a, c = a", joints)]  # b is driven: it leads
[(0, 1, '-1/2'), (2, 1, '-1/2')]
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from fractions import Fraction

from gcrules.core.english import listed
from gcrules.core.errors import InputError, Span
from gcrules.core.hints import near
from gcrules.mechanisms.description.limb_file import Coupling, JointSpec, Subchain
from gcrules.screws import JOINTS

__all__ = ["couplings"]

_EQUATION = re.compile(
    r"\s*([A-Za-z]\w*)\s*=\s*([+-])?\s*(\d{1,9}(?:/[1-9]\d{0,8}|\.\d{1,9})?)?\s*\*?\s*([A-Za-z]\w*)\s*"
)
_EXAMPLE = "write elbow = -1/2 shoulder, with names that joints have: R:elbow(B1, u1)"


def couplings(
    text: str, joints: Sequence[JointSpec], subchains: Sequence[Subchain] = (), others: Collection[str] = ()
) -> tuple[Coupling, ...]:
    """The couplings of a limb, each of a joint to one that follows none: of joints that are coupled the driven one, or
    the first. `others` are names of joints of other limbs. Raises InputError with its place in the text.
    """
    names = {j.name: k for k, j in enumerate(joints) if j.name}
    chain = [n for n, own in enumerate(subchains) for _ in range(own.joints)] or [0] * len(joints)
    groups = {k: {k: Fraction(1)} for k in range(len(joints))}  # amounts in the group of each joint, up to a number
    said: dict[int, list[str]] = {k: [] for k in groups}
    for match in _equations(text):
        pair = [_joint(text, match, group, names, joints, others) for group in (1, 4)]
        first, second = pair
        ratio = Fraction(match[3] or 1) * (-1 if match[2] == "-" else 1)
        if not ratio:
            raise _fault(text, match.span(3), "a ratio of 0 would hold the joint still", "leave the joint out")
        if first in groups[second]:
            raise _fault(text, match.span(), f"{match[1]} and {match[4]} are already coupled", "leave one of them out")
        if chain[first] != chain[second]:
            raise _fault(
                text,
                match.span(),
                f"{match[1]} and {match[4]} are joints of different chains between bodies of the limb",
                "joints of one chain can be coupled; what lies between two bodies has to be one chain",
            )
        driven = [k for k in (*groups[first], *groups[second]) if joints[k].actuated]
        if len(driven) > 1:
            both = " and ".join(joints[k].text for k in driven)
            raise _fault(text, match.span(), f"{both} are both driven, though they move as one", "leave out a star")
        scale = ratio * groups[second][second] / groups[first][first]
        merged = groups[second] | {k: c * scale for k, c in groups[first].items()}
        told = [*said[first], *said[second], " ".join(match[0].split())]
        for k in merged:
            groups[k], said[k] = merged, told
    return tuple(_led(groups, said, joints))


def _led(
    groups: dict[int, dict[int, Fraction]], said: dict[int, list[str]], joints: Sequence[JointSpec]
) -> Iterator[Coupling]:
    for k, group in groups.items():
        leader = next((n for n in sorted(group) if joints[n].actuated), min(group))
        if k != leader:
            ratio = group[k] / group[leader]
            size = "" if abs(ratio) == 1 else f"{abs(ratio)} "
            text = f"{joints[k].name} = {'-' * (ratio < 0)}{size}{joints[leader].name}"
            yield Coupling(k, leader, ratio, said[k][0] if len(said[k]) == 1 else text)


def _equations(text: str) -> Iterator[re.Match[str]]:
    at = 0
    for part in text.split(","):
        match = _EQUATION.fullmatch(text, at, at + len(part))
        if not match:
            span = (at, at + len(part))
            raise _fault(text, span, f"{part.strip()[:40]!r} is not a coupling", _EXAMPLE)
        yield match
        at += len(part) + 1


def _joint(
    text: str,
    match: re.Match[str],
    group: int,
    names: dict[str, int],
    joints: Sequence[JointSpec],
    others: Collection[str],
) -> int:
    name, span = match[group], match.span(group)
    if name not in names and name in others:
        raise _fault(
            text,
            span,
            f"{name} is a joint of another limb, and only joints of one chain are coupled",
            "limbs are distinguished only by what each does to the platform; put the coupled joints into one chain, or"
            " star both and let the drive keep the ratio",
        )
    if name not in names:
        raise _fault(
            text,
            span,
            f"no joint of this limb is named {name}",
            near(name, names) or (f"its named joints are {listed(list(names))}" if names else _EXAMPLE),
        )
    joint = joints[names[name]]
    if len(JOINTS[joint.kind].freedoms) != 1:
        raise _fault(
            text,
            span,
            f"{joint} has several freedoms, and only joints with one can be coupled",
            "write it as joints R and P",
        )
    return names[name]


def _fault(text: str, span: tuple[int, int], message: str, hint: str | None = None) -> InputError:
    start, end = span
    return InputError(message, span=Span(start, max(end, start + 1)), source=text, hint=hint)
