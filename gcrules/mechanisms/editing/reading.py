"""The text of a robot file as a sheet, and where in the text each of its rows stands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import FileError, GcrulesError, Span
from gcrules.core.frozen import FrozenMap
from gcrules.core.yaml_file import Document, Node
from gcrules.mechanisms.description.limb_file import chain_heads, joint_matches
from gcrules.mechanisms.description.robot_file import MAX_COPIES
from gcrules.mechanisms.editing.sheet import ChainRow, JointRow, LimbRow, NameRow, Place, Sheet

__all__ = ["Path", "PlacedSheet", "read_sheet"]

Path = tuple[str | int, ...]
"""A row: ("limb", 0), ("joint", 0, chain, place), ("name", "A%"), ("home", "A1"), ("drawing", "A1"), ("mobility",) …"""

_OF_LIMB = {"name", "joints", "cable", "through", "couplings"}
_READ = ("title", "copies", "space", "points", "directions", "limbs", "platform", "mobility", "home", "drawing")


@dataclass(frozen=True)
class PlacedSheet:
    """`keys` are the first characters of the keys of the file; none where it is not written in lines."""

    sheet: Sheet
    places: Mapping[Path, Span] = field(default_factory=FrozenMap)
    keys: Mapping[str, int] = field(default_factory=FrozenMap)

    def row_at(self, fault: GcrulesError) -> Path | None:
        """The row that a fault is in, the smallest one."""
        if fault.span is None:
            return None
        at = fault.span.start
        around = [(s.end - s.start, path) for path, s in self.places.items() if s.start <= at < max(s.end, s.start + 1)]
        joints = [entry for entry in around if entry[1][0] != "joint" or fault.span.end <= self.places[entry[1]].end]
        return min(joints, key=lambda entry: entry[0])[1] if joints else None


def read_sheet(text: str, filename: str = "<input>") -> PlacedSheet:
    """Read the text of a robot file, whether or not it is sound. Raises FileError for one that is no such table."""
    document = Document.parse(text, filename)
    if document.root.kind != "mapping":
        raise document.error(document.root.span, "a robot file begins with keys", "title: My robot")
    reader = _Reader(document)
    sheet = reader.sheet()
    block = not text.lstrip("\ufeff \t\r\n").startswith("{")
    keys = {k.text: k.span.start for k, _ in reader.top} if block else {}
    return PlacedSheet(sheet, FrozenMap(reader.places), FrozenMap(keys))


class _Reader:
    def __init__(self, document: Document) -> None:
        self.document = document
        self.top = document.root.entries()
        self.values = {key.text: value for key, value in self.top}
        self.places: dict[Path, Span] = {}

    def sheet(self) -> Sheet:
        if "lines" in self.values:
            message = "this robot is given by its lines, and has no limbs"
            raise self._fault(self.values["lines"], message, "robots of joints have the key limbs")
        limbs = self.values.get("limbs")
        if limbs is None or limbs.kind != "sequence":
            raise self._fault(limbs or self.document.root, "there is no list of limbs", "limbs: [{joints: …}]")
        for key, value in self.top:
            self.places[(key.text,)] = _both(key, value)
        copies = self._text("copies")
        return Sheet(
            title=self._text("title"),
            names=tuple(row for sort in ("point", "direction") for row in self._names(sort)),
            limbs=tuple(self._limb(place, item) for place, item in enumerate(limbs.children)),
            mobility=self._text("mobility"),
            copies=min(int(copies), MAX_COPIES) if copies.isdecimal() and len(copies) < 9 else 0,
            platform=" ".join(_texts(self.values["platform"])) if "platform" in self.values else "",
            plane=self._text("space") == "plane",
            home=FrozenMap(self._configuration("home")),
            drawing=FrozenMap(self._configuration("drawing")),
            others=FrozenMap((key.text, _value(value)) for key, value in self.top if key.text not in _READ),
        )

    def _fault(self, node: Node, message: str, hint: str) -> FileError:
        return self.document.error(node.span, message, hint)

    def _text(self, key: str) -> str:
        return self.values[key].text if key in self.values else ""

    def _pairs(self, key: str) -> list[tuple[Node, Node]]:
        node = self.values.get(key)
        if node is None or node.is_nothing:
            return []
        if node.kind != "mapping":
            raise self._fault(node, f"{key} are names with what they are", f"{key}: {{A1: …}}")
        return node.entries()

    def _names(self, sort: str) -> Iterator[NameRow]:
        for key, value in self._pairs(f"{sort}s"):
            self.places["name", key.text] = _both(key, value)
            yield NameRow(key.text, sort, value.text)

    def _configuration(self, where: str) -> Iterator[tuple[str, Place]]:
        for key, value in self._pairs(where):
            self.places[where, key.text] = _both(key, value)
            x, y, z, *_ = (*(part.text for part in value.children), "", "", "")
            yield key.text, (x or "0", y or "0", z)

    def _limb(self, place: int, item: Node) -> LimbRow:
        parts = {key.text: value for key, value in item.entries()} if item.kind == "mapping" else {}
        if parts.keys().isdisjoint(("joints", "cable")) or not parts.keys() <= _OF_LIMB:
            raise self._fault(item, "this limb is not a list of joints", "- joints: R(A1, r1) P*(A1 S1) S(S1)")
        ends = [value.children[-1].span if value.children else value.span for value in parts.values()]
        self.places["limb", place] = Span(item.span.start, max((s.end for s in ends), default=item.span.end))
        joints, cable = parts.get("joints"), parts.get("cable")
        written = [text for node in (joints, cable) if node is not None for text in _texts(node)]
        number = "%" if any("%" in text for text in written) else place + 1
        return LimbRow(
            name=parts["name"].text if "name" in parts else f"leg {number}",
            chains=tuple(self._chains(place, joints)) if joints is not None else (),
            cable=cable.text if cable is not None else "",
            through=parts["through"].text if "through" in parts else "",
            couplings=", ".join(_texts(parts["couplings"])) if "couplings" in parts else "",
        )

    def _chains(self, limb: int, node: Node) -> Iterator[ChainRow]:
        """Chains as they stand in one text, in a list of texts, or in a list of bodies with joints."""
        count = 0
        plain: list[JointRow] = []
        for head, part in _parts(node):
            text = part.text
            heads = chain_heads(text)
            starts = [(m.start(), m.end(), f"{m[1]} to {m[2]}") for m in heads]
            if head or not heads or text[: heads[0].start()].strip():
                starts.insert(0, (0, 0, head))
            for (_, start, own), end in zip(starts, [*(s for s, _, _ in starts[1:]), len(text)], strict=True):
                rows = tuple(self._joints(part, start, end, ("joint", limb, count), len(plain)))
                if own:
                    yield ChainRow(rows, own)
                    count += 1
                else:
                    plain += rows
        if plain:
            yield ChainRow(tuple(plain))

    def _joints(self, node: Node, start: int, end: int, path: Path, before: int) -> Iterator[JointRow]:
        at = node.span.start + int(node.quoted)
        as_written = self.document.source[at : at + len(node.text)] == node.text
        try:
            for place, match in enumerate(joint_matches(node.text, start, end), before):
                kind, star, name, inside = match.groups()
                span = Span(at + match.start(1), at + match.end(4) + 1) if as_written else node.span
                self.places[(*path, place)] = span
                yield JointRow(kind, tuple(p.strip() for p in inside.split(",")), star or "", name or "")
        except GcrulesError as fault:
            own = fault.span if as_written and fault.span else None
            span = Span(at + own.start, at + own.end) if own else node.span
            raise self.document.error(span, fault.message, fault.hint) from None


def _both(key: Node, value: Node) -> Span:
    return Span(key.span.start, max(key.span.end, value.span.end))


def _parts(node: Node) -> Iterator[tuple[str, Node]]:
    """Each text of joints, with the bodies that stand before it as a key."""
    for part in (node,) if node.kind == "scalar" else node.children:
        if part.kind == "mapping":
            for key, value in part.entries():
                yield key.text, value
        else:
            yield "", part


def _texts(node: Node) -> list[str]:
    """All texts of a node, those of mappings too."""
    return [node.text] if node.kind == "scalar" else [t for child in node.children for t in _texts(child)]


def _value(node: Node) -> str | tuple[str, ...]:
    return node.text if node.kind == "scalar" else tuple(_texts(node))
