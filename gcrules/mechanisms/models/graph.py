"""A model as a graph of bodies, links that are fixed to each other being one, and joints; its base and its platform."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any

import networkx as nx
from networkx.algorithms.connectivity import local_node_connectivity

from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.mechanisms.models.model import Model, ModelJoint

__all__ = ["Ends", "Graph", "graph_of"]

_PLATFORMS = ("platform", "moving_platform", "mobile_platform", "end_effector")
_LISTED = 8


@dataclass(frozen=True)
class Ends:
    """The bodies between which limbs lead, named by one of their links, how many chains without a common link lead from
    one to the other, and why it is these two.
    """

    base: str
    platform: str
    chains: int
    why: str


@dataclass(frozen=True)
class Graph:
    """Bodies, named by their first link, and the joints between them. `body` tells of which body a link is."""

    model: Model
    body: dict[str, str]
    joints: tuple[ModelJoint, ...]
    base: str
    notes: tuple[str, ...] = ()

    @cached_property
    def net(self) -> nx.Graph[Any]:
        """Bodies and joints as nodes, so that two joints between the same bodies are two ways."""
        found: nx.Graph[Any] = nx.Graph()
        found.add_nodes_from(dict.fromkeys(self.body.values()))
        for j in self.joints:
            found.add_edge(self.body[j.parent], ("joint", j.name))
            found.add_edge(("joint", j.name), self.body[j.child])
        return found

    def ends(self, base: str | None = None, platform: str | None = None) -> Ends:
        """The base and the platform: those that are named, else the model's base, and the body that most chains hold to
        it. Raises InputError where there is no such body, where several are as good, and for unknown links.
        """
        start = self._body(base, "base") if base else self.base
        if platform is None:
            return self._most(start, named=base is not None)
        end = self._body(platform, "platform")
        if start == end:
            raise InputError(f"{platform} is the base itself, or fixed to it", hint=self._offers() or None)
        count = self.chains(start, end)
        if count < 2 and base is None:
            nearer = self._entry(end)
            if nearer not in (start, end) and self.chains(nearer, end) > 1:
                why = f"the nearest link on the way to {self.base} that several chains join to it"
                return Ends(nearer, end, self.chains(nearer, end), why)
        if count < 2:
            raise InputError(self._why_none(start, end), hint=self._offers() or None)
        return Ends(start, end, count, "as asked")

    def chains(self, start: str, end: str) -> int:
        """How many chains without a common link or joint lead from one body to another."""
        return int(local_node_connectivity(self.net, start, end))

    def between(self, start: str, end: str) -> frozenset[str]:
        """The names of the joints that lie on a way from one body to the other which comes by no body twice."""
        net = self.net.copy()
        net.add_edge(start, end)
        blocks: list[set[Any]] = [{*block} for block in nx.biconnected_components(net)]
        for block in blocks:
            if start in block and end in block:
                return frozenset(node[1] for node in block if isinstance(node, tuple))
        return frozenset()

    def _body(self, link: str, what: str) -> str:
        if link not in self.body:
            raise InputError(
                f"there is no link {link[:40]!r} to be the {what}",
                hint=near(link, self.body) or f"the links are {_several(self.body)}",
            )
        return self.body[link]

    def _most(self, start: str, *, named: bool) -> Ends:
        counts = {b: self.chains(start, b) for b in self._in_loops(start)}
        most = max(counts.values(), default=0)
        if most < 2:
            raise InputError(self._why_no_platform(start), hint=self._offers() or None)
        by_name = [b for b, n in counts.items() if n > 1 and self._is_platform(b)]
        best = by_name if len(by_name) == 1 else [b for b, n in counts.items() if n == most]
        why = "by its name" if len(by_name) == 1 else "the link with the most limbs"
        if len(best) > 1:
            listed = sorted(counts, key=lambda b: (-counts[b], -self._joints_at(b)))
            said = ", ".join(f"{b} ({counts[b]} chains)" for b in listed[:_LISTED])
            raise InputError(
                f"which link is the platform? As many chains join {start} to {_several(best)}",
                hint=f"name it: --platform {listed[0]}; there are {said}"
                + ("" if named else " (--base names the base)"),
            )
        return Ends(start, best[0], counts[best[0]], why)

    def _is_platform(self, body: str) -> bool:
        return any(b == body and link.lower() in _PLATFORMS for link, b in self.body.items())

    def _joints_at(self, body: str) -> int:
        return len(self.net[body])

    @cached_property
    def _blocks(self) -> list[set[Any]]:
        """What loops hold together, the largest first; a joint that is in no loop is left out."""
        found: list[set[Any]] = [{*block} for block in nx.biconnected_components(self.net)]
        return sorted((block for block in found if len(block) > 2), key=len, reverse=True)

    def _in_loops(self, start: str) -> list[str]:
        found = [b for block in self._blocks if start in block for b in _bodies(block) if b != start]
        return list(dict.fromkeys(found))

    def _entry(self, end: str) -> str:
        """The link by which one comes from the base into the loops of a body."""
        if not nx.has_path(self.net, self.base, end):
            return end
        way = nx.shortest_path(self.net, self.base, end)
        for block in self._blocks:
            if way[-2] in block:
                return str(next(node for node in way if node in block))
        return end

    def _why_none(self, start: str, end: str) -> str:
        if not nx.has_path(self.net, start, end):
            return f"no joints lead from {start} to {end}"
        if not self._blocks:
            return (
                f"{end} is not a platform with limbs: only one chain leads to it from {start}, and the"
                " model has no loops"
            )
        return f"{end} is not a platform with limbs: all ways from {start} to it go through one link or joint"

    def _why_no_platform(self, start: str) -> str:
        if not self._blocks:
            ends = [b for b in dict.fromkeys(self.body.values()) if self._joints_at(b) == 1 and b != self.base]
            shape = f"a tree with {len(ends)} ends" if len(ends) > 1 else "one open chain"
            return f"there is no platform with limbs: the links are {shape}, and no joint closes a loop"
        return f"there is no platform with limbs: {start} is a link of no loop"

    def _offers(self) -> str:
        """The mechanisms inside the model that are platforms with limbs, as options to be given."""
        found, loops = [], []
        for block in self._blocks:
            bodies = _bodies(block)
            start = min(bodies, key=lambda b: self._distance(b))
            counts = {b: self.chains(start, b) for b in bodies if b != start}
            most = max(counts.values())
            best = [b for b, n in counts.items() if n == most]
            if most > 2 and len(best) == 1:
                found.append(f"--platform {best[0]} (base {start}, {most} limbs)")
            else:
                loops.append(f"--base {start} --platform {max(best, key=self._joints_at)}")
        listed = [*found, *(f"{one} (a loop)" for one in loops)]
        if not listed:
            return ""
        more = f", and {len(listed) - _LISTED} more" if len(listed) > _LISTED else ""
        return f"parts of it have loops: {', '.join(listed[:_LISTED])}{more}"

    def _distance(self, body: str) -> int:
        try:
            return int(nx.shortest_path_length(self.net, self.base, body))
        except nx.NetworkXNoPath:
            return len(self.net)


def _bodies(block: Iterable[Any]) -> list[str]:
    return sorted(node for node in block if isinstance(node, str))


def _several(names: Iterable[str]) -> str:
    listed = list(dict.fromkeys(names))
    return ", ".join(listed[:_LISTED]) + (f" and {len(listed) - _LISTED} more" if len(listed) > _LISTED else "")


def graph_of(model: Model) -> Graph:
    """The graph of a model. Joints that leave all six freedoms hold nothing and are left out; where nothing but these
    joins the base to anything, the base is what they lead to.
    """
    notes = []
    fixed: nx.Graph[str] = nx.Graph()
    fixed.add_nodes_from(model.links)
    fixed.add_edges_from((j.parent, j.child) for j in model.joints if j.kind == "fixed")
    body: dict[str, str] = {}
    for links in nx.connected_components(fixed):
        first = _named(model, [link for link in model.links if link in links])
        body.update(dict.fromkeys(links, first))
    body = {link: body[link] for link in model.links}
    moving = [j for j in model.joints if j.kind != "fixed" and body[j.parent] != body[j.child]]
    free = [j for j in moving if j.kind == "free"]
    joints = tuple(j for j in moving if j.kind != "free")
    base = body[model.links[0]]
    if free and not any(base in (body[j.parent], body[j.child]) for j in joints):
        base = body[free[0].child] if body[free[0].parent] == base else body[free[0].parent]
        notes.append(f"the base floats freely (joint {free[0].name}): {base} is taken as the base")
    elif free:
        notes.append(f"a free joint holds nothing, and is left out: {_several(j.name for j in free)}")
    return Graph(model, body, joints, base, tuple(notes))


def _named(model: Model, links: Sequence[str]) -> str:
    """The link that a body is named after: the base; one that is called a platform; the first one of the file."""
    if model.links[0] in links:
        return model.links[0]
    return next((link for link in links if link.lower() in _PLATFORMS), links[0])
