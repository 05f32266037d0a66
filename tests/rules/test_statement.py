"""Statements as values: relation, flats and qualifiers, put into words last."""

import pickle
import random
import re

import pytest

from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.parts import substitute
from gcrules.conditions.analysis import analyze
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.catalog.file import load
from gcrules.rules.statement import NOTHING, Flat, listing, of_kind, say, together

A, B = Point("a"), Point("b")
ENTRIES = load().entries


def test_words_and_flats() -> None:
    said = say("the plane {} and {word}", parse("abc"), word="more")
    assert said.pieces == ("the plane ", Flat(parse("abc")), " and more")
    assert (str(said), said.flats, said.points) == ("the plane abc and more", (parse("abc"),), frozenset("abc"))


def test_nothing_is_said_by_nothing() -> None:
    assert not NOTHING
    assert (str(NOTHING), NOTHING.flats) == ("", ())
    assert say("") == NOTHING == listing(()) == of_kind("plane", ())


def test_the_same_said_in_other_pieces_is_equal() -> None:
    assert say("{} of {}", say("the {}", "line"), A) == say("the line of {}", A) == say("{}{}", "the line of ", A)
    assert hash(say("{}", A)) == hash(say("{}", say("{}", A)))
    assert pickle.loads(pickle.dumps(say("the legs {}", A))) == say("the legs {}", A)


@pytest.mark.parametrize(
    ("parts", "words"),
    [((), ""), (("a",), "a"), (("a", "b"), "a and b"), (("a", "b", "c"), "a, b and c"), (("a", "b", "a"), "a and b")],
)
def test_listing(parts: tuple[str, ...], words: str) -> None:
    assert str(listing(parts)) == str(listing(map(Point, parts))) == words


def test_kinds_together() -> None:
    items: list[tuple[str, Expr | str]] = [("line", parse("Aa")), ("", "p"), ("direction", Point("i")), ("line", A)]
    assert str(together(items)) == "the lines Aa and a, the direction i and p"


def test_constructed_flats_stand_in_parentheses() -> None:
    """A meet among words is read as one thing; a scalar, and a join of it, are written as they are."""
    for text, words in ((r"abc /\ def", r"(abc /\ def)"), (r"(abc /\ def) \/ g", r"(abc /\ def) \/ g")):
        assert str(say("{}", parse(text))) == words
    assert str(say("{} is zero", parse(r"ab /\ cd"))) == r"ab /\ cd is zero"


def test_legs_and_the_lines_of_forces() -> None:
    said = say("Without the legs {} the platform can turn; the legs {} then meet.", A, B)
    assert str(said) == "Without the legs a the platform can turn; the legs b then meet."
    assert str(said.of_forces) == "Without the wrenches along a the platform can turn; the lines b then meet."
    assert said.of_forces.flats == said.flats
    assert "legs" not in str(said.of_forces)


def test_capitalised() -> None:
    assert str(say("the line").capitalised) == "The line"
    assert say("{} meets", A).capitalised == say("{} meets", A)
    assert NOTHING.capitalised == NOTHING


def test_braces() -> None:
    assert str(say("{{{}}}", "a")) == "{a}"
    with pytest.raises(ValueError, match=r"'\{'"):
        say("{", "a")


# --- the sentences of the engine ------------------------------------------------------------------------------------


def renamed(structure: Structure, names: dict[str, str]) -> Structure:
    return Structure(tuple((names[a], names[b]) for a, b in structure.legs))


@pytest.mark.parametrize("entry", ENTRIES, ids=[e.id for e in ENTRIES])
def test_points_stand_in_flats_only(entry: Entry) -> None:
    """No sentence about a class has a point among its words, so that a map of its flats is all that renames it."""
    names = {n: f"{n}{7 + i}" for i, n in enumerate(entry.structure.names)}
    a = analyze(renamed(entry.structure, names), search=0)
    for c in (a.condition, *a.readings):
        words = " ".join(str(p) for p in c.meaning.pieces if not isinstance(p, Flat))
        assert not re.findall(rf"\b(?:{'|'.join(names.values())})", words), words
        assert c.meaning.points <= set(names.values())


@pytest.mark.parametrize("entry", random.Random(5).sample(ENTRIES, 12), ids=lambda e: e.id)
def test_renaming_the_flats_renames_the_structure(entry: Entry) -> None:
    """The sentence of a class with its flats renamed is the sentence of the renamed class."""
    names = {n: f"{n}'" for n in entry.structure.names}
    here, there = (analyze(s, search=0) for s in (entry.structure, renamed(entry.structure, names)))
    points: dict[str, Expr] = {n: Point(m) for n, m in names.items()}
    said = [c.meaning.with_flats(lambda e: substitute(e, points, rank=8)) for c in (here.condition, *here.readings)]
    assert list(map(str, said)) == [c.statement for c in (there.condition, *there.readings)]
