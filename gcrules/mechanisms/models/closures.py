"""A second file beside a URDF one, which says which frames of its tree coincide, which joints are driven, and which are
balls or universal joints: the form of collections of models with closed loops.

>>> text = "closed_loop: [[tip_A, tip_B]]\\ntype: [3d]\\nname_mot: [q1]\\njoint_name: [ball]\\njoint_type: [SPHERICAL]"
>>> found = parse_closures(text)
>>> [(loop.first, loop.second, loop.kind) for loop in found.loops], list(found.motors), list(found.kinds.values())
([('tip_A', 'tip_B', 'ball')], ['q1'], ['SPHERICAL'])

Source: the keys are those of the files robot.yaml of Gepetto's example-parallel-robots, which its loader reads.
"""

from __future__ import annotations

from collections.abc import Mapping
from os import PathLike

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError
from gcrules.core.frozen import FrozenMap
from gcrules.core.yaml_file import Document, Node

__all__ = ["JOINT_TYPES", "NO_CLOSURES", "Closures", "Loop", "YamlPlace", "load_closures", "parse_closures"]

_LOOPS = {"3d": "ball", "6d": "fixed"}
JOINT_TYPES = ("SPHERICAL", "FIXED", *(f"UJOINT_{a}{b}" for a in "XYZ" for b in "XYZ" if a != b))


@dataclass(frozen=True, eq=False)
class YamlPlace:
    """A node as the origin of what it says."""

    node: Node

    @property
    def line(self) -> int:
        return self.node.span.line_column(self.node.document.source)[0]

    @property
    def column(self) -> int:
        return self.node.span.line_column(self.node.document.source)[1]

    def error(self, message: str, attribute: str | None = None, hint: str | None = None) -> FileError:
        return self.node.document.error(self.node.span, message, hint)


@dataclass(frozen=True, eq=False)
class Loop:
    """Two frames that coincide, with `fixed` turned alike too, with `ball` not."""

    first: str
    second: str
    kind: str
    place: YamlPlace


@dataclass(frozen=True, eq=False)
class Closures:
    """Loops, the names of driven joints, and the joints that are of another type than the tree says."""

    loops: tuple[Loop, ...] = ()
    motors: Mapping[str, YamlPlace] = FrozenMap()
    kinds: Mapping[str, str] = FrozenMap()
    places: Mapping[str, YamlPlace] = FrozenMap()  # where the names of `kinds` stand


NO_CLOSURES = Closures()


def load_closures(path: str | PathLike[str]) -> Closures:
    """Read a file. Raises FileError with all its faults."""
    return _read(Document.load(path))


def parse_closures(text: str, filename: str = "<input>") -> Closures:
    """Read a text. Raises FileError likewise."""
    return _read(Document.parse(text, filename))


def _read(document: Document) -> Closures:
    keys = ("closed_loop", "type", "name_mot", "joint_name", "joint_type")
    top = document.root.mapping(optional=keys)
    pairs = top["closed_loop"].sequence() if "closed_loop" in top else ()
    types = top["type"].sequence(len(pairs)) if "type" in top else ()
    loops = []
    for k, pair in enumerate(pairs):
        names = [n.string() or "" for n in pair.sequence(2)]
        kind = _LOOPS.get(((types[k].string() or "") if types else "6d").lower())
        if kind is None:
            types[k].fault(
                f"{types[k].text[:20]!r} is not a type of loop", "write 3d for a point, 6d for a whole frame"
            )
        if len(names) == 2:
            loops.append(Loop(names[0], names[1], kind or "fixed", YamlPlace(pair)))
    motors = {n.string() or "": YamlPlace(n) for n in (top["name_mot"].sequence() if "name_mot" in top else ())}
    joints = top["joint_name"].sequence() if "joint_name" in top else ()
    if joints and "joint_type" not in top:
        document.root.fault("the key 'joint_type' is missing")
    sorts = top["joint_type"].sequence(len(joints)) if "joint_type" in top else ()
    kinds, places = {}, {}
    for name, sort in zip(joints, sorts, strict=False):
        word = sort.choice(JOINT_TYPES)
        kinds[name.text], places[name.text] = word or "FIXED", YamlPlace(name)
    document.check()
    return Closures(tuple(loops), FrozenMap(motors), FrozenMap(kinds), FrozenMap(places))
