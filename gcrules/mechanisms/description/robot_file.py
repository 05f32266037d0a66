r"""Reading robot files: `robot.yaml`. Data only, no code runs; all faults of a file come out at once, with places.

title: 3-RPS robot
source: SinguLab2008            # optional: what of it was really read
note: example, invented         # optional
copies: 3                       # optional: % in a name stands for 1, 2, 3; what bears it is written once
points:                         # names, each with the one relation that makes it
  A%: free
  S%: in plane A% perpendicular to r%
directions:
  r%: free
limbs:                          # joints from the base to the platform, a star at what is actuated
  - name: leg %
    joints: R(A%, r%) P*(A% S%) S(S%)   # or chains between bodies: [base to hub: …, base to hub: …, hub to platform: …]
    # couplings: b = -1/2 a     # optional: joints that are geared to each other, R:a(…) and R:b(…)
platform: S1 S2 S3              # optional: the points that move with the platform
mobility: 3                     # expected, and checked
facts: []                       # optional: relations that follow, checked: "u1 perpendicular to v1"
home: {A1: [0, 0, 0]}           # optional: one configuration, checked against the relations
drawing: {A1: [0, 0, 0]}        # optional: another one, in which the robot is drawn; what it leaves out is as at home
units: mm                       # optional: of all lengths in the file, one of `gcrules.screws.pose.UNITS`
limits: q1 -30..30 deg, q2 0..1 # optional: what actuators reach from home, as --limits has it; lengths as in the file
condition: "…"                  # optional: a published condition in the language, compared
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from os import PathLike
from pathlib import Path

from gcrules.algebra.language.text import SHORT_NAME
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, GcrulesError, InputError
from gcrules.core.hints import near
from gcrules.core.yaml_file import Document, Node
from gcrules.mechanisms.conditions.checks import check_configuration, check_family, check_limbs
from gcrules.mechanisms.description.couplings import couplings
from gcrules.mechanisms.description.family import Definition, Family, circles, in_order
from gcrules.mechanisms.description.file_parts import (
    MAX_TEXT,
    read_drawing,
    read_facts,
    read_home,
    read_lines,
    read_platform,
)
from gcrules.mechanisms.description.limb_file import LimbSpec, cable_joints, read_limb
from gcrules.mechanisms.description.limits import limits_of_limbs
from gcrules.mechanisms.description.point_pairs import numbered
from gcrules.mechanisms.description.relations import AXES, RELATIONS, relation
from gcrules.mechanisms.description.units import read_units
from gcrules.mechanisms.robot import Robot
from gcrules.screws import JOINTS

__all__ = ["MAX_COPIES", "MAX_LIMBS", "Draft", "load_robot", "parse_draft", "parse_robot"]

_REQUIRED = ("title", "points", "mobility")
_OPTIONAL = (
    "source", "note", "copies", "space", "directions", "limbs", "lines", "platform", "facts", "home", "drawing",
    "units", "limits", "condition",
)  # fmt: skip
_OF_CHAINS = {True: ("couplings",), False: ()}  # keys of limbs with joints
_NAMED = re.compile(r"[0-9A-Za-z]+(?:\*\d?)?:([A-Za-z]\w*)\s*\(")  # joints that have names
MAX_COPIES = 12
MAX_NAMES = 120
MAX_LIMBS = 12
MAX_FREEDOMS = 12
MAX_SUBCHAINS = 8


def load_robot(path: str | PathLike[str], owner: str = "") -> Robot:
    """Read a robot file. Raises FileError with all its faults."""
    name = Path(path).parent.name if Path(path).name == "robot.yaml" else Path(path).stem
    return _Reader(Document.load(path), name, owner).robot()


def parse_robot(text: str, filename: str = "<input>", name: str = "robot") -> Robot:
    """Read the text of a robot file. Raises FileError likewise."""
    return _Reader(Document.parse(text, filename), name, "").robot()


@dataclass(frozen=True, eq=False)
class Draft:
    """What a file says that may be at fault still: the robot, where names and joints can be read, and all faults."""

    robot: Robot | None
    faults: tuple[GcrulesError, ...] = ()


def parse_draft(text: str, filename: str = "<input>", name: str = "robot") -> Draft:
    """Read the text of a robot file as far as it goes."""
    robot = None
    try:
        reader = _Reader(Document.parse(text, filename), name, "")
        robot, checked = reader.described()
        checked()
    except FileError as fault:
        return Draft(robot, tuple(getattr(fault, "faults", ()) or (fault,)))
    return Draft(robot)


class _Reader:
    """Reads one file; faults are recorded at their nodes, those that make further checks pointless are raised first."""

    def __init__(self, document: Document, name: str, owner: str) -> None:
        self.document = document
        self.name = name
        self.owner = owner
        self.places: dict[str, Node] = {}
        self.copies = 0
        self.faulty: list[Node] = []

    def robot(self) -> Robot:
        robot, checked = self.described()
        checked()
        return robot

    def _no_platform(self) -> None:
        """A platform on six legs has none of the keys that follow: one fault says what it is."""
        root = self.document.root
        keys = {key.text: key for key, _ in root.entries()} if root.kind == "mapping" else {}
        if "legs" in keys and not {"limbs", "lines"} & keys.keys():
            message = "these are the legs of a platform, and a robot described by its joints has limbs"
            raise self.document.error(keys["legs"].span, message, "gcrules analyze, pose, path, map … take this file")

    def described(self) -> tuple[Robot, Callable[[], None]]:
        """The robot as its file has it, and what checks it. Both raise FileError."""
        self._no_platform()
        top = self.document.root.mapping(_REQUIRED, _OPTIONAL)
        if "copies" in top:
            self.copies = top["copies"].integer() or 0
            if not 1 <= self.copies <= MAX_COPIES:
                top["copies"].fault(f"copies are 1 to {MAX_COPIES}")
                self.copies = 1
        plane = "space" in top and top["space"].choice(("plane", "space")) == "plane"
        definitions = [
            *(self._definitions(top["points"], "point") if "points" in top else ()),
            *(self._definitions(top["directions"], "direction") if "directions" in top else ()),
        ]
        family = self._family(definitions, plane)
        if "limbs" in top and "lines" in top:
            top["lines"].fault("a robot is given by its limbs or by lines, not by both")
        if "limbs" not in top and "lines" not in top:
            self.document.root.fault("the key 'limbs' is missing", "limbs of joints, or lines whose wrenches are known")
        limbs = list(self._limbs(top["limbs"], family)) if "limbs" in top else []
        lines, derived = read_lines(top["lines"], family, self.copies) if "lines" in top else ((), ())
        texts = {k: top[k].string() or "" for k in ("title", "source", "note", "condition") if k in top}
        mobility = top["mobility"].integer() if "mobility" in top else None
        facts = tuple(read_facts(top["facts"], family, self.copies)) if "facts" in top else ()
        home = read_home(top["home"], family) if "home" in top else None
        drawing = read_drawing(top["drawing"], family, home) if "drawing" in top else None
        platform = read_platform(top["platform"], family, self.copies) if "platform" in top else ()
        units = read_units(top)
        limits = self._limits(top["limits"], [limb for _, limb in limbs], units) if "limits" in top else ""
        self.document.check()
        robot = Robot(
            id=self.name,
            title=texts["title"],
            family=family,
            limbs=tuple(limb for _, limb in limbs),
            mobility=mobility or 0,
            lines=lines,
            derived=derived,
            platform=platform,
            home=home,
            drawing=drawing,
            limits=limits,
            units=units,
            condition=texts.get("condition", ""),
            source=texts.get("source", ""),
            note=texts.get("note", ""),
            facts=tuple(fact for _, fact in facts),
            filename=self.document.filename,
            owner=self.owner,
            text=self.document.source,
        )

        def checked() -> None:
            check_family(robot, self.places, facts)
            self.document.check()
            if limbs:
                check_limbs(robot, [node for node, _ in limbs], top["mobility"])
            if home is not None:
                check_configuration(robot, top["home"])
            if drawing is not None:
                self.document.check()
                check_configuration(robot, top["drawing"], drawing=True)
            self.document.check()

        return robot, checked

    # --- names ---

    def _definitions(self, node: Node, sort: str) -> Iterator[Definition]:
        for key, value in node.entries():
            text = value.string()
            if text is None:
                continue
            if "%" in text and "%" not in key.text:
                value.fault("% stands in the relation of a name without it")
                continue
            for name, written in numbered(key, self.copies, key.text, text):
                before = len(self.document.faults)
                if not SHORT_NAME.fullmatch(name) or len(name) > 12:
                    key.fault(f"{name[:20]!r} is not a name", "a letter, then digits or primes: A1, S', r12")
                elif name in AXES:
                    key.fault(f"{name} is a direction of the frame in every robot", "choose another name")
                elif name in self.places:
                    key.fault(f"{name} is defined twice ({self.places[name].place})")
                elif len(self.places) >= MAX_NAMES:
                    key.fault(f"more than {MAX_NAMES} names")
                    return
                else:
                    self.places[name] = value
                    yield from self._definition(name, sort, written, value)
                if len(self.document.faults) > before:
                    break  # the other copies have the same fault

    def _definition(self, name: str, sort: str, text: str, node: Node) -> Iterator[Definition]:
        if len(text) > MAX_TEXT:
            node.fault(f"a relation of more than {MAX_TEXT} characters")
            return
        try:
            yield Definition(name, sort, relation(sort, text), text)
        except InputError as fault:
            node.fault(fault.message, fault.hint)

    def _family(self, definitions: list[Definition], plane: bool) -> Family:
        sorts = {**dict.fromkeys(AXES, "direction"), **{d.name: d.sort for d in definitions}}
        good = [d for d in definitions if self._sound(d, sorts)]

        def cyclic(names: tuple[str, ...]) -> None:
            needs = {d.name: [n for n in d.relation.names if n in names] for d in good if d.name in names}
            told: list[Node] = []
            for circle in circles(needs):
                place = self.places[circle[0]]
                if place not in told:  # copies stand at one place
                    chain = ", ".join(f"{a} needs {b}" for a, b in pairwise((*circle, circle[0])))
                    place.fault(
                        f"{circle[0]} is defined in terms of itself: {chain}",
                        "let each relation use only names that can be made before it",
                    )
                told += [self.places[n] for n in circle]

        if len(good) < len(definitions):
            return Family(tuple(good), plane)
        return Family(in_order(good, cyclic), plane)

    def _sound(self, d: Definition, sorts: Mapping[str, str]) -> bool:
        """Whether all names of a relation are known and stand where their sort may stand."""
        node = self.places[d.name]
        unknown = [n for n in d.relation.names if n not in sorts]
        for name in unknown if node not in self.faulty else ():
            self.faulty.append(node)
            node.fault(f"{name} is not defined", near(name, sorts))
        if unknown:
            return False
        wanted = _wanted(d)
        for term, sort in zip(d.relation.args, wanted, strict=True):
            weight = sum((c for c, n in term if sorts[n] == "point"), Fraction(0))
            if weight != (sort == "point"):
                if node in self.faulty:
                    return False
                self.faulty.append(node)
                words = " ".join(n for _, n in reversed(term))
                node.fault(
                    f"{words} is not a {sort}: the numbers before its points add up to {weight}",
                    "1 makes a point, as in A + B - C; 0 makes a direction, as in B - A",
                )
                return False
        return True

    # --- limbs ---

    def _limbs(self, node: Node, family: Family) -> Iterator[tuple[Node, LimbSpec]]:
        seen: set[str] = set()
        items = node.sequence()
        named = set(_NAMED.findall(self.document.source))
        if node.kind == "sequence" and not items:
            node.fault("there are no limbs")
        for place, item in enumerate(items):
            cable = item.kind == "mapping" and any(key.text == "cable" for key, _ in item.entries())
            top = item.mapping(("cable",) if cable else ("joints",), ("name", "through", *_OF_CHAINS[not cable]))
            joints = top.get("cable" if cable else "joints")
            if joints is None:
                continue
            text = joints.string() or "" if joints.kind == "scalar" else " ".join(map(_chain, joints.sequence()))
            if joints.kind != "scalar" and len({part.kind for part in joints.sequence()}) > 1:
                joints.fault("a chain does not say between which bodies it leads", "write base to NAME: before it")
                continue
            name = top["name"].string() or "" if "name" in top else f"leg {'%' if '%' in text else place + 1}"
            through = top["through"].string() or "" if "through" in top else ""
            for own, written, points in numbered(joints, self.copies, name, text, through):
                limb = self._limb(own, written, points, joints, family, cable)
                if limb and "couplings" in top:
                    limb = self._coupled(limb, top["couplings"], named - {j.name for j in limb.joints})
                if limb and own in seen:
                    item.fault(f"two limbs are named {own!r}")
                elif limb and len(seen) >= MAX_LIMBS:
                    item.fault(f"more than {MAX_LIMBS} limbs")
                    return
                elif limb:
                    seen.add(own)
                    yield joints, limb
                else:
                    break  # the other copies have the same fault

    def _limb(self, name: str, text: str, through: str, node: Node, family: Family, cable: bool) -> LimbSpec | None:
        if cable:
            ends = text.split()
            if len(ends) != 2 or any(family.sorts.get(n) != "point" for n in ends):
                node.fault("a cable joins two points", "write cable: A1 B1, from the base to the platform")
                return None
            text = cable_joints(*ends, plane=family.plane)
        if len(text) > 4 * MAX_TEXT:
            node.fault(f"a limb of more than {4 * MAX_TEXT} characters")
            return None
        try:
            joints, subchains = read_limb(text)
        except InputError as fault:
            node.fault_inside(text, fault)
            return None
        good = True
        for joint in joints:
            forms = JOINTS[joint.kind].parts.values()
            for form, arg in zip(forms, joint.args, strict=True):
                for _, word in arg if isinstance(arg, tuple) else ():
                    sort = family.sorts.get(word)
                    needed = "point" if form == "point" or (isinstance(arg, tuple) and len(arg) > 1) else "direction"
                    if word not in self.places and word not in AXES:
                        message, hint = f"{word} is not defined", near(word, family.sorts)
                    elif sort is not None and sort != needed:
                        message, hint = f"{word} is a {sort}, and {joint} needs a {needed} there", None
                    else:
                        continue
                    good = False
                    node.fault_inside(text, InputError(message, span=joint.place, hint=hint))
        limb = LimbSpec(name, joints, tuple(through.split()), cable, subchains)
        for word in limb.through:
            if family.sorts.get(word) is None:
                node.fault(f"{word} is not defined", near(word, family.sorts))
        most = MAX_FREEDOMS * (MAX_SUBCHAINS if subchains else 1)
        if limb.freedoms > most or len(subchains) > MAX_SUBCHAINS:
            node.fault(f"{name} has {limb.freedoms} freedoms in {len(subchains)} chains; more than {most} are not read")
            return None
        return limb if good else None

    def _limits(self, node: Node, limbs: Sequence[LimbSpec], units: str) -> str:
        text = node.string() or ""
        if text and not self.document.faults:  # else limbs may be missing, and names of actuators with them
            try:
                limits_of_limbs(text, limbs, units)
            except InputError as fault:
                node.fault_inside(text, fault)
        return text

    def _coupled(self, limb: LimbSpec, node: Node, others: Collection[str]) -> LimbSpec | None:
        if node.kind == "scalar":
            text = node.string() or ""
        else:
            text = ", ".join(part.string() or "" for part in node.sequence())
        try:
            return replace(limb, couplings=couplings(text, limb.joints, limb.subchains, others))
        except InputError as fault:
            node.fault_inside(text, fault)
            return None


def _chain(node: Node) -> str:
    """A part of a limb as it stands in a list: joints, or `base to NAME: joints`, which YAML reads as a mapping."""
    if node.kind == "scalar":
        return node.string() or ""
    return " ".join(f"{key.text}: {value.string() or ''}" for key, value in node.entries())


def _wanted(d: Definition) -> tuple[str, ...]:
    """The sorts of a relation's arguments."""
    return (d.sort,) if d.relation.kind == "sum" else RELATIONS[d.sort][d.relation.kind].sorts
