r"""Limbs of a robot as they are written: joints from the base to the platform, those with an actuator starred.

>>> joints = read_joints("U(A1, u1, v1) P*(A1 B1) S(B1)")
>>> print(*joints)
U(A1, u1, v1) P*(A1 B1) S(B1)
>>> [j.kind for j in joints], [j.actuated for j in joints]
(['U', 'P', 'S'], [(), (0,), ()])

A limb may have bodies of its own, between which chains of joints lead: then each chain names where it begins and ends.

>>> joints, chains = read_limb(
...     "base to hub: R*(A1, r1) 4S(B1, C1, d1) base to hub: R*(A2, r2) 4S(B2, C2, d2) hub to platform: R(E, z)"
... )
>>> [(c.start, c.end, c.joints) for c in chains]
[('base', 'hub', 2), ('base', 'hub', 2), ('hub', 'platform', 1)]
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, Span
from gcrules.core.frozen import FrozenMap
from gcrules.core.hints import near
from gcrules.mechanisms.description.relations import Term, Values, combined, pair_or_name
from gcrules.screws import JOINTS, Field, Joint, Limb

__all__ = [
    "BASE",
    "PLATFORM",
    "Coupling",
    "JointSpec",
    "LimbSpec",
    "Subchain",
    "cable_joints",
    "chain_heads",
    "joint_matches",
    "read_joints",
    "read_limb",
]

_JOINT = re.compile(r"\s*,?\s*([0-9A-Za-z]+)\s*(\*\d?)?(?::([A-Za-z]\w*))?\s*\(([^()]*)\)\s*")
_HEAD = re.compile(r"\s*([A-Za-z]\w*)\s+to\s+([A-Za-z]\w*)\s*:")
_NAMES = re.compile(r"[A-Za-z][\w']*(?:\s+[A-Za-z][\w']*)?")
_EXAMPLE = "a limb is written U(A1, u1, v1) P*(A1 B1) S(B1), with a star at what is actuated"
_NOWHERE = Span(0, 0)

BASE, PLATFORM = "base", "platform"


@dataclass(frozen=True)
class JointSpec:
    """A joint as written: `args` are names, directions may be two points; `actuated` are places of its freedoms. Its
    `name`, if it has one, is there for couplings.
    """

    kind: str
    args: tuple[Term | Fraction, ...]
    actuated: tuple[int, ...] = ()
    text: str = ""
    place: Span = _NOWHERE
    name: str = ""

    @property
    def symbol(self) -> str:
        """The kind, starred where it is driven."""
        return self.kind + "*" * bool(self.actuated)

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
class Subchain:
    """A chain of so many joints from one body of a limb to another; the `base` and the `platform` are such bodies."""

    start: str
    end: str
    joints: int


@dataclass(frozen=True)
class Coupling:
    """A joint of a limb that follows another one: the places of both among its joints, how much it moves for each unit
    of its leader (radians, or the file's unit of length), and the equation as written.
    """

    joint: int
    leader: int
    ratio: Fraction
    text: str


@dataclass(frozen=True)
class LimbSpec:
    """A limb; `through` are points that lines of its wrenches may go through beside those of its joints. A `cable` has
    the joints of a leg with ball ends, and only pulls. A limb with bodies of its own has `subchains`, each from a body
    that those before it reach, with its joints in their order; a plain chain has none. Joints of `couplings` follow
    others of their chain, which follow none.
    """

    name: str
    joints: tuple[JointSpec, ...]
    through: tuple[str, ...] = ()
    cable: bool = False
    subchains: tuple[Subchain, ...] = ()
    couplings: tuple[Coupling, ...] = ()

    @property
    def chain(self) -> str:
        """The symbols of its joints, those with an actuator starred and those that follow others marked: UP*S, R*R~S,
        (R*4S | R*4S) R.
        """
        if self.cable:
            return "cable"
        led = {c.joint for c in self.couplings}
        symbols = [j.symbol + "~" * (k in led) for k, j in enumerate(self.joints)]
        if not self.subchains:
            return "".join(symbols)
        between: dict[tuple[str, str], list[str]] = {}
        for own, joints in self.parts:
            between.setdefault((own.start, own.end), []).append("".join(symbols[: len(joints)]))
            del symbols[: len(joints)]
        return " ".join(several[0] if len(several) == 1 else f"({' | '.join(several)})" for several in between.values())

    @property
    def lines(self) -> tuple[str, ...]:
        """Its joints as written; of a limb with bodies of its own one line for each chain between two of them. What
        is coupled follows.
        """
        texts = [" ".join(j.text for j in joints) for _, joints in self.parts]
        coupled = [f"where {', '.join(c.text for c in self.couplings)}"] if self.couplings else []
        if not self.subchains:
            return (" ".join([*texts, *coupled]),)
        return (*(f"{c.start} to {c.end}: {t}" for c, t in zip(self.subchains, texts, strict=True)), *coupled)

    @property
    def parts(self) -> tuple[tuple[Subchain, tuple[JointSpec, ...]], ...]:
        """Its subchains with their joints; of a plain chain that from the base to the platform."""
        found, start = [], 0
        for own in self.subchains or (Subchain(BASE, PLATFORM, len(self.joints)),):
            found.append((own, self.joints[start : start + own.joints]))
            start += own.joints
        return tuple(found)

    def ways(self, start: str = BASE, before: tuple[str, ...] = ()) -> Iterator[tuple[JointSpec, ...]]:
        """The joints of each way from a body to the platform, along its subchains, by no body twice."""
        for own, joints in self.parts:
            if own.start == start and own.end not in before:
                further = self.ways(own.end, (*before, start)) if own.end != PLATFORM else [()]
                yield from ((*joints, *rest) for rest in further)

    @cached_property
    def shares(self) -> tuple[tuple[int, ...], ...]:
        """For each joint with which sign it counts in the platform's motion, and then in each loop of the limb: the
        motion of a body by a later subchain, less that by the first one that reaches it. None of a plain chain.
        """
        if not self.subchains:
            return ()
        count = len(self.subchains)
        reached = {BASE: [0] * count}
        loops: list[list[int]] = []
        for k, own in enumerate(self.subchains):
            way = [n + (i == k) for i, n in enumerate(reached[own.start])]
            if own.end in reached:
                loops.append([a - b for a, b in zip(way, reached[own.end], strict=True)])
            else:
                reached[own.end] = way
        each = zip(reached[PLATFORM], *loops, strict=True)
        return tuple(n for n, own in zip(each, self.subchains, strict=True) for _ in range(own.joints))

    @property
    def loops(self) -> int:
        """The number of loops of its own."""
        return len(self.shares[0]) - 1 if self.subchains else 0

    @cached_property
    def coordinates(self) -> tuple[tuple[int, ...], ...]:
        """For each joint the places of its freedoms among those of the limb; a joint that follows has its leader's."""
        leaders = {c.joint: c.leader for c in self.couplings}
        own: list[tuple[int, ...]] = []
        count = 0
        for k, j in enumerate(self.joints):
            end = count if k in leaders else count + len(JOINTS[j.kind].freedoms)
            own.append(tuple(range(count, end)))
            count = end
        return tuple(own[leaders.get(k, k)] for k in range(len(own)))

    @cached_property
    def ratios(self) -> Mapping[int, Fraction]:
        """Of each joint that follows how much it moves for each unit of its leader."""
        return FrozenMap({c.joint: c.ratio for c in self.couplings})

    @property
    def freedoms(self) -> int:
        """How many twists it has."""
        return len({k for own in self.coordinates for k in own})

    @property
    def actuators(self) -> int:
        """How many of them are driven."""
        return sum(len(j.actuated) for j in self.joints)

    def at(self, values: Values, field: Field) -> Limb:
        """The limb at a member."""
        return Limb(tuple(j.at(values, field) for j in self.joints), self.name, self.shares, self.coupled)

    @property
    def coupled(self) -> tuple[tuple[int, int, Fraction], ...]:
        """The couplings as a `Limb` takes them."""
        return tuple((c.joint, c.leader, c.ratio) for c in self.couplings)

    def chains_at(self, values: Values, field: Field) -> Iterator[Limb]:
        """Its `parts` at a member, each as a limb by itself."""
        start = 0
        for _, joints in self.parts:
            own = range(start, start + len(joints))
            coupled = tuple((k - start, led - start, ratio) for k, led, ratio in self.coupled if k in own)
            yield Limb(tuple(j.at(values, field) for j in joints), couplings=coupled)
            start += len(joints)


def cable_joints(base: str, end: str, *, plane: bool) -> str:
    """The joints of a cable between two points, as they are written of a limb."""
    first, last = (f"R({base}, z)", f"R({end}, z)") if plane else (f"S({base})", f"S({end})")
    return f"{first} P*({base} {end}) {last}"


def read_joints(text: str) -> tuple[JointSpec, ...]:
    """Read the joints of a limb. Raises InputError with its place in the text."""
    return tuple(_joints(text))


def read_limb(text: str) -> tuple[tuple[JointSpec, ...], tuple[Subchain, ...]]:
    """Read a limb: its joints and, where it has bodies of its own, its subchains. Raises InputError with its place."""
    heads = chain_heads(text)
    if not heads:
        plain = read_joints(text)
        _named_once(text, plain)
        return plain, ()
    if text[: heads[0].start()].strip():
        message = f"the joints before '{heads[0][0].strip()}' belong to no chain"
        raise _fault(text, 0, heads[0].start(), message, "write base to NAME: before them")
    joints: list[JointSpec] = []
    chains: list[Subchain] = []
    reached = {BASE}
    for head, following in zip(heads, [*heads[1:], None], strict=True):
        own = tuple(_joints(text, head.end(), following.start() if following else len(text)))
        start, end = head.groups()
        if start not in reached:
            hint = near(start, reached) or f"reached before it: {', '.join(sorted(reached))}"
            raise _fault(text, *head.span(1), f"no chain before this one leads to {start}", hint)
        if end in (start, BASE) or start == PLATFORM:
            raise _fault(text, *head.span(2), f"no chain leads from {start} to {end}", "chains start from the base")
        joints += own
        chains.append(Subchain(start, end, len(own)))
        reached.add(end)
    if PLATFORM not in reached:
        raise _fault(text, *heads[-1].span(2), "no chain leads to the platform", "the last one: … to platform: …")
    _named_once(text, joints)
    ends = Counter(b for c in chains for b in (c.start, c.end))
    for head in heads:
        if head[2] != PLATFORM and ends[head[2]] < 2:
            raise _fault(
                text, *head.span(2), f"nothing else is joined to {head[2]}", near(head[2], reached - {head[2]})
            )
    return tuple(joints), tuple(chains)


def _named_once(text: str, joints: Sequence[JointSpec]) -> None:
    seen: set[str] = set()
    for j in joints:
        if j.name in seen:
            raise _fault(text, j.place.start, j.place.end, f"two joints of the limb are named {j.name}")
        seen |= {j.name} - {""}


def _joints(text: str, at: int = 0, end: int | None = None) -> Iterator[JointSpec]:
    for match in joint_matches(text, at, end):
        yield _joint(text, match)


def chain_heads(text: str) -> list[re.Match[str]]:
    """Where chains between bodies begin, `base to hub:`; the groups are both bodies."""
    return list(_HEAD.finditer(text))


def joint_matches(text: str, at: int = 0, end: int | None = None) -> Iterator[re.Match[str]]:
    """Joints as they are written, whatever their kind; the groups are kind, star, name and what the parentheses hold.
    Raises InputError for what is no joint, and where there are none.
    """
    first, end = at, len(text) if end is None else end
    while text[at:end].strip():
        match = _JOINT.match(text, at, end)
        if not match:
            raise _fault(text, at, end, f"{text[at:end][:30].strip()!r} is not a joint", _EXAMPLE)
        yield match
        at = match.end()
    if at == first:
        raise _fault(text, max(0, first - 1), max(1, first), "there are no joints", _EXAMPLE)


def _joint(text: str, match: re.Match[str]) -> JointSpec:
    symbol, star, name, inside = match.groups()
    start, end = match.span(1)
    if symbol not in JOINTS:
        hint = near(symbol, JOINTS) or f"the kinds are {', '.join(JOINTS)}"
        raise _fault(text, start, end, f"{symbol[:20]!r} is not a kind of joint", hint)
    kind = JOINTS[symbol]
    parts = [part.strip() for part in inside.split(",")] if inside.strip() else []
    if len(parts) != len(kind.parts):
        hint = f"write {symbol}({', '.join(kind.parts)})"
        message = f"a joint {symbol} takes {len(kind.parts)} parts, found {len(parts)}"
        raise _fault(text, start, match.end(4) + 1, message, hint)
    args: list[Term | Fraction] = []
    for (part, form), word in zip(kind.parts.items(), parts, strict=True):
        names = word.split()
        if form == "number":
            if not re.fullmatch(r"-?\d{1,9}(/[1-9]\d{0,8}|\.\d{1,9})?", word):
                raise _fault(text, match.start(4), match.end(4), f"the {part} {word[:20]!r} is not a number")
            args.append(Fraction(word))
        elif not _NAMES.fullmatch(word) or (form == "point" and len(names) != 1):
            needed = "a point" if form == "point" else "a direction, or two points"
            raise _fault(
                text, match.start(4), match.end(4) + 1, f"the {part} of {symbol} is {needed}, found {word[:30]!r}"
            )
        else:
            args.append(pair_or_name(word))
    written = f"{symbol}{star or ''}{':' * bool(name)}{name or ''}({', '.join(parts)})"
    return JointSpec(symbol, tuple(args), _actuated(text, match), written, Span(start, match.end(4) + 1), name or "")


def _actuated(text: str, match: re.Match[str]) -> tuple[int, ...]:
    symbol, star = match.group(1, 2)
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
