"""The text of a robot file from limbs with names for their points and directions; those alike are written once."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.yaml_text import quoted
from gcrules.mechanisms.kinematics.rigid_motions import Floats
from gcrules.mechanisms.models.chains_between import Chain
from gcrules.mechanisms.models.family_found import Known, Named, Naming
from gcrules.mechanisms.models.merging import Part, Ratios
from gcrules.screws import JOINTS

__all__ = ["Drawn", "robot_text"]

_DIGITS = 12


@dataclass(frozen=True, eq=False)
class Drawn:
    """A limb: its chains, with the joints of each."""

    chains: tuple[tuple[Chain, tuple[Part, ...]], ...]

    @property
    def parts(self) -> tuple[Part, ...]:
        return tuple(p for _, parts in self.chains for p in parts)


class _Writing:
    def __init__(self, limbs: Sequence[Drawn], naming: Naming, coupled: Ratios, ends: tuple[str, str]) -> None:
        self.limbs = limbs
        self.naming = naming
        self.coupled = coupled
        self.ends = ends
        self.number: dict[int, str] = {}
        self.marks = [self._signature(k) for k in range(len(limbs))]
        counts = {mark: self.marks.count(mark) for mark in self.marks}
        most = max(counts.values())
        self.alike = [k for k, mark in enumerate(self.marks) if counts[mark] == most and mark == self._first(counts)]
        self.copies = len(self.alike) if len(self.alike) > 1 else 0
        alike = self.alike if self.copies else []
        self.order = [*alike, *(k for k in range(len(limbs)) if k not in alike)]
        self.number = {k: str(n) for n, k in enumerate(self.order, start=1)}
        self.written = [self.order[0], *self.order[len(alike) :]] if self.copies else self.order

    def _first(self, counts: Mapping[object, int]) -> object:
        return max(counts, key=lambda mark: counts[mark])

    def _signature(self, k: int) -> object:
        own = [(d.text("%"), self._relation(d, k, "%")) for d in self.naming.known if d.limb == k]
        return tuple(own), self._joints(k, "%"), self._couplings(k)

    def name(self, d: Known, k: int, number: str) -> str:
        """The name of something in what is said of limb k, whose number is written so."""
        if d.limb < 0:
            return d.stem
        return d.stem + (number if d.limb == k else self.number.get(d.limb, f"!{d.limb}"))

    def _relation(self, d: Known, k: int, number: str) -> str:
        words: list[str] = []
        for word in d.relation:
            if isinstance(word, Known):
                if words and not words[-1].endswith(" "):  # two points that follow each other
                    words.append(" ")
                words.append(self.name(word, k, number))
            else:
                words.append(word)
        return "".join(words)

    def _named(self, named: Named, k: int, number: str) -> str:
        return " ".join(self.name(d, k, number) for d in named)

    def _joints(self, k: int, number: str) -> tuple[str, ...]:
        """The chains of a limb, each as its joints; with the bodies before them where there are several."""
        chains = self.limbs[k].chains
        tied = {*self.coupled, *(leader for leader, _ in self.coupled.values())}
        bodies = self._bodies(k)
        found = []
        for chain, parts in chains:
            words = []
            for p in parts:
                name = f":{_word(p.joints[0])}" if p.joints[0] in tied and not p.merged else ""
                args = [self._named(self.naming.slots[s], k, number) for s in p.slots]
                if p.kind == "H":
                    args.append(str(Fraction(round(p.pitch, 9)).limit_denominator(10**8)))
                words.append(f"{p.kind}{p.driven}{name}({', '.join(args)})")
            head = f"{bodies[chain.start]} to {bodies[chain.end]}: " if len(chains) > 1 else ""
            found.append(head + " ".join(words))
        return tuple(found)

    def _bodies(self, k: int) -> dict[str, str]:
        found = {self.ends[0]: "base", self.ends[1]: "platform"}
        inner = [b for chain, _ in self.limbs[k].chains for b in (chain.start, chain.end)]
        for body in dict.fromkeys(inner):
            if body not in found:
                number = len(found) - 1
                found[body] = "hub" if len(set(inner) - set(self.ends)) == 1 else f"body{number}"
        return found

    def _couplings(self, k: int) -> tuple[str, ...]:
        """What follows what in a limb; ratios are those about the axes as they are written."""
        parts = {p.joints[0]: p for p in self.limbs[k].parts if not p.merged}
        found = []
        for joint, (leader, ratio) in self.coupled.items():
            if joint in parts and leader in parts:
                signs = [self._sign(parts[name]) for name in (joint, leader)]
                own = Fraction(ratio).limit_denominator(10**4) if _near(ratio) else Fraction(round(ratio, 9))
                own *= int(signs[0] * signs[1])
                number = "" if own == 1 else "-" if own == -1 else f"{own} "
                found.append(f"{_word(joint)} = {number}{_word(leader)}")
        return tuple(found)

    def _sign(self, part: Part) -> float:
        named = self.naming.slots[part.slots[-1]]
        way = named[0].values[0] if len(named) == 1 else named[1].values[0] - named[0].values[0]
        return float(np.sign(way @ part.axis))

    def _limits(self, limits: Mapping[str, tuple[float, float]]) -> str:
        """Those of joints, along the axes of the model, as limits of actuators, about the axes as they are written."""
        found: dict[str, str] = {}
        for k in self.order:
            for p in self.limbs[k].parts:
                for place in range(len(JOINTS[p.kind].drives) if p.driven else 0):
                    name = f"q{len(found) + 1}"
                    found[name] = ""
                    if place == 0 and not p.merged and p.joints[0] in limits:
                        low, high = sorted(self._sign(p) * end for end in limits[p.joints[0]])
                        found[name] = f"{low:.12g}..{high:.12g}{'' if p.kind == 'P' else ' rad'}"
        if len({*found.values()}) == 1 and len(found) > 1:
            return f"actuators {found['q1']}" if found["q1"] else ""
        return ", ".join(f"{name} {reach}" for name, reach in found.items() if reach)

    def lines(
        self,
        title: str,
        note: str,
        mobility: int,
        platform: Sequence[Known],
        limits: Mapping[str, tuple[float, float]],
    ) -> Iterator[str]:
        yield f"title: {quoted(title)}"
        yield f"note: {quoted(note)}"
        if self.naming.plane:
            yield "space: plane"
        if self.copies:
            yield f"copies: {self.copies}"
        for sort in ("point", "direction"):
            known = [d for d in self.naming.known if d.sort == sort and (d.limb < 0 or d.limb in self.written)]
            if known:
                yield f"{sort}s:"
            for d in known:
                k, number = d.limb, self._label(d.limb)
                yield f"  {d.text(number)}: {self._relation(d, k, number)}"
        yield "limbs:"
        for k in self.written:
            number = self._label(k)
            yield f"  - name: leg {number}"
            joints = self._joints(k, number)
            if len(joints) == 1:
                yield f"    joints: {joints[0]}"
            else:
                yield "    joints:"
                yield from (f"      - {chain}" for chain in joints)
            if couplings := self._couplings(k):
                yield f"    couplings: {', '.join(couplings)}"
        if platform:
            names = dict.fromkeys(d.text(self._label(d.limb)) for d in platform if d.limb < 0 or d.limb in self.written)
            yield f"platform: {' '.join(names)}"
        yield f"mobility: {mobility}"
        if reach := self._limits(limits):
            yield f"limits: {reach}"
        home = [d for d in self.naming.known if d.parameters]
        if home:
            yield "home:"
        for d in sorted(home, key=lambda d: (d.sort == "direction", d.stem, int(self.number.get(d.limb, 0)))):
            values = d.values[0]
            vector = values * d.length if d.length else values
            numbers = _direction(values) if d.sort == "direction" and not d.length else _point(vector, self.naming.size)
            yield f"  {d.text(self.number.get(d.limb, ''))}: [{', '.join(numbers)}]"

    def _label(self, k: int) -> str:
        return "%" if self.copies and k in self.alike else self.number.get(k, "")


def robot_text(
    limbs: Sequence[Drawn], naming: Naming, coupled: Ratios, ends: tuple[str, str],
    *, title: str, note: str, mobility: int, limits: Mapping[str, tuple[float, float]],
) -> tuple[str, tuple[int, ...]]:  # fmt: skip
    """The text of the file, and the limbs in the sequence in which it has them."""
    writing = _Writing(limbs, naming, coupled, ends)
    platform = []
    for limb in limbs:
        for chain, parts in limb.chains:
            last = [s for s in parts[-1].slots if s.sort == "point"]
            if chain.end == ends[1] and last and parts[-1].kind != "4S":
                platform += [naming.slots[s][0] for s in last]
    lines = writing.lines(title, note, mobility, list(dict.fromkeys(platform)), limits)
    return "\n".join(lines) + "\n", tuple(writing.order)


def _near(ratio: float) -> bool:
    return abs(float(Fraction(ratio).limit_denominator(10**4)) - ratio) < 1e-9


def _word(name: str) -> str:
    found = re.sub(r"\W+", "_", name, flags=re.ASCII).strip("_")
    return found if found[:1].isalpha() else f"j{found}"


def _point(values: Floats, size: float) -> tuple[str, ...]:
    digits = max(0, _DIGITS - int(np.ceil(np.log10(max(size, 1e-9)))))
    return tuple(_decimal(float(v), min(digits, 15)) for v in values)


def _decimal(value: float, digits: int) -> str:
    text = f"{value:.{digits}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text in ("-0", "") else text


def _direction(values: Floats) -> tuple[str, ...]:
    """Small whole numbers if these give the direction, else its unit vector."""
    scaled = values / np.abs(values).max()
    for times in range(1, 13):
        whole = scaled * times
        if np.abs(whole - whole.round()).max() < 1e-11 * times:
            return tuple(str(int(c)) for c in whole.round())
    return tuple(_decimal(float(v), _DIGITS) for v in values)
