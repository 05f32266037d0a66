"""Isomorphisms of leg graphs: those of networkx, and the first of them."""

from __future__ import annotations

import random
from typing import Any

import networkx as nx
import pytest

from gcrules.algebra.language.legs_text import Structure
from gcrules.rules.catalog.file import load
from gcrules.rules.catalog.isomorphism import isomorphism

ENTRIES = load().entries


def graph(s: Structure, exchanged: bool = False) -> Any:
    other = {"base": "platform", "platform": "base", "": ""}
    made: Any = nx.Graph()
    for n in s.names:
        side = s.sides.get(n, "")
        made.add_node(n, side=other[side] if exchanged else side)
    made.add_edges_from(s.legs)
    return made


def matched(a: Structure, b: Structure) -> bool:
    """The oracle."""
    return any(
        nx.is_isomorphic(graph(a, e), graph(b), node_match=lambda x, y: bool(x["side"] == y["side"]))
        for e in (False, True)
    )


def relabelled(legs: tuple[tuple[str, str], ...], rng: random.Random) -> Structure:
    names = sorted({n for leg in legs for n in leg})
    new = dict(zip(names, rng.sample("abcdefghijklmnopqrst", len(names)), strict=True))
    turned = rng.random() < 0.5
    shuffled = [(new[q], new[p]) if turned else (new[p], new[q]) for p, q in legs]
    rng.shuffle(shuffled)
    return Structure(tuple(shuffled))


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda e: e.id)
def test_relabelled_classes_are_found(entry: Any) -> None:
    rng = random.Random(entry.id)
    for _ in range(4):
        other = relabelled(entry.legs, rng)
        found = isomorphism(entry.structure, other)
        assert found is not None
        assert len(set(found.values())) == len(found)
        image = {frozenset((found[p], found[q])) for p, q in entry.legs}
        assert image == {frozenset(leg) for leg in other.legs}


def test_different_classes_are_told_apart() -> None:
    rng = random.Random(0)
    for a in ENTRIES:
        for b in rng.sample(ENTRIES, 6):
            assert (isomorphism(a.structure, b.structure) is not None) == matched(a.structure, b.structure)


def test_the_choice_does_not_depend_on_the_sequence_of_legs() -> None:
    rng = random.Random(1)
    for entry in ENTRIES:
        other = relabelled(entry.legs, rng)
        again = list(other.legs)
        rng.shuffle(again)
        first = isomorphism(entry.structure, other)
        same = Structure(tuple(again), other.names)
        assert first is not None
        assert same.names == other.names
        assert isomorphism(entry.structure, same) == first
