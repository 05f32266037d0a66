"""Proof files that say something false, or that would make the checker print something that it has not checked."""

from __future__ import annotations

from pathlib import Path

import pytest
from project.proof_attacks import (
    ABX,
    ADX,
    ADY,
    ALMOST,
    BC,
    CROSSED,
    M_AND_X,
    M_ON_AB,
    NAN,
    ON_BOTH,
    PLANE,
    PLANES,
    TWO_ON_AB,
    X_ON_AB,
    Changes,
    assumed,
    bracket,
    flat,
    join,
    meet,
    number,
    on_line,
    placed,
    proved,
    refused,
    theorem,
    twice_c,
)

ATTACKS: dict[str, tuple[Changes, str]] = {
    # What is printed.
    "a definition that is a point": (
        theorem("pq a b c d", join("pq", "pq"), rank=4, definitions={"pq": ["sum", join("a", "b"), join("c", "d")]}),
        "not different",
    ),
    "a power with two exponents": (
        theorem("a b c", ["power", bracket(*"abc"), 2, 3], ["power", bracket(*"abc"), 2]),
        "no expression",
    ),
    "an assumption that is no expression": (
        assumed("a b", ABX, given=[ABX], placed=[X_ON_AB], nonzero=["1 != 0\nproved  'all': [a b c]"]),
        "KeyError",
    ),
    "what does not vanish, without what is given": (
        theorem("a b", join("a", "a"), nonzero=["1 != 0 (rank 3)\nproved  'all': [a b c]"]),
        "KeyError",
    ),
    "points that are no names, without what is given": (
        theorem("a b", join("a", "a"), any=["o)\nproved  'all': [a b c]"]),
        "KeyError",
    ),
    "an assumption that is no extensor": (
        assumed("a b c d", bracket(*"axy"), **TWO_ON_AB, nonzero=[join("a", "b", "c", "d")]),
        "beyond the rank",
    ),
    "not zero for all points": (
        assumed("a b", bracket(*"axy"), **TWO_ON_AB, any=["o"], nonzero=[join("a", "b", "o")]),
        "not zero for all",
    ),
    # Points of extensors.
    "fresh points at infinity": (
        assumed(
            "i j k l m a b c",
            bracket(*"xklm"),
            rank=4,
            ideal=5,
            given=[bracket(*"abcx")],
            nonzero=[PLANE],
            placed=[placed("x", PLANE, flat(PLANE, [0, 1]), fresh="ij")],
        ),
        "too early",
    ),
    "fresh points in one text": (
        assumed(
            "p q r a b c",
            join("x", "pq"),
            given=[bracket("b", "c", "pq"), join("a", "x"), bracket(*"bcx")],
            nonzero=[join("a", "b"), BC],
            placed=[
                on_line("pq", on=BC),
                {**placed("x", meet(join("a", "pq"), BC), flat("a", [1, 1]), flat(BC, [2, 1])), "fresh": "pqr"},
            ],
        ),
        "need not lie",
    ),
    "a fresh point twice in a join": (
        assumed(
            "a b c f g h",
            "x",
            given=[join("a", "x"), bracket(*"bcx")],
            nonzero=["a", BC],
            placed=[placed("x", meet(join("a", "f", "f"), BC), flat("a", [0, 1]), flat(BC, [1, 1]), fresh="fgh")],
        ),
        "may vanish",
    ),
    "a fresh point in the claim": (
        assumed(
            "a b c d e f g h",
            bracket(*"xfgh"),
            rank=4,
            given=[bracket(*"abcx"), bracket(*"adex")],
            nonzero=[PLANES],
            placed=[placed("x", PLANES, *ON_BOTH, fresh="fgh")],
        ),
        "not fresh",
    ),
    "fresh points of two steps": (
        assumed(
            "a b c d e f g h",
            join("x", "y"),
            rank=4,
            given=[bracket(*"abcx"), bracket(*"adex"), bracket(*"abcy"), bracket(*"adey")],
            nonzero=[PLANES],
            placed=[
                placed("x", PLANES, *ON_BOTH, fresh="fgh"),
                placed("y", PLANES, flat(ON_BOTH[0]["flat"], [2, 1]), flat(ON_BOTH[1]["flat"], [3, 1]), fresh="fgh"),
            ],
        ),
        "too early",
    ),
    "too few points on what joins fresh ones": (
        assumed(
            "a b c f",
            join("x", "b"),
            given=[join("a", "x"), bracket(*"bcx")],
            nonzero=["a", BC],
            placed=[placed("x", meet(join("a", "f"), BC), flat("a", [0, 1]), flat(BC, [1, 1]), fresh="f")],
        ),
        "may vanish",
    ),
    # Positions that are not reached.
    "a scalar that is no part of a join": (
        assumed(
            "a b c d",
            bracket(*"axy"),
            given=[ADX, ADY],
            nonzero=[join(bracket(*"abc"), "d")],
            placed=[on_line("x", on=join("a", "d")), on_line("y", 1, join("a", "d"))],
        ),
        "may vanish",
    ),
    "two points on one line of free points": (assumed("a b", bracket(*"axy"), **TWO_ON_AB), "may vanish"),
    "a line of free points at infinity": (assumed("a b", ABX, ideal=2, given=[ABX], placed=[X_ON_AB]), "may vanish"),
    "a line of a placed point": (
        assumed(
            "a b c",
            bracket(*"acy"),
            given=[join("a", "b", "x"), bracket(*"xcy")],
            placed=[X_ON_AB, on_line("y", 1, join("x", "c"))],
        ),
        "may vanish",
    ),
    "a line of another point": (
        assumed("a b c", bracket(*"acx"), given=[ABX], placed=[on_line("x", on=join("a", "c"))]),
        "need not lie",
    ),
    "an almost equal assumption": (
        assumed(
            "a b c d e",
            bracket("a", CROSSED, "x"),
            given=[ALMOST],
            nonzero=[join("a", CROSSED)],
            placed=[placed("x", join("a", CROSSED), flat(join("a", CROSSED), [0, 1.0]))],
        ),
        "need not lie",
    ),
    "an assumption times zero": (
        assumed("a b", ABX, given=[ABX], placed=[placed("x", join("a", "b"), flat(join("a", "b"), [0, 0]))]),
        "need not lie",
    ),
    "an assumption that says nothing": (
        assumed("a b", ABX, given=[join("a", "a")], placed=[X_ON_AB]),
        "need not lie",
    ),
    "a line that is a point": (
        assumed("a", join("a", "x"), given=[bracket("a", "a", "x")], placed=[on_line("x", on=join("a", "a"))]),
        "may vanish",
    ),
    "room for one more": (
        assumed(
            "a b c",
            bracket(*"abx"),
            given=[bracket(*"bcx"), bracket(*"bca")],
            nonzero=[BC],
            placed=[placed("x", "a", flat("a", [0, 1], [1, 1], room=BC))],
        ),
        "there is room",
    ),
    "a room that may vanish": (
        assumed(
            "a b c",
            ABX,
            given=[bracket(*"bcx"), bracket(*"bca")],
            placed=[placed("x", join("a", "b"), flat(join("a", "b"), [1, 1], [0, 1], room=BC))],
        ),
        "room that may vanish",
    ),
    "a point placed twice": (assumed("a b", ABX, given=[ABX], placed=[X_ON_AB, X_ON_AB]), "not different"),
    "a point on a later one": (
        assumed("a c", bracket(*"axc"), given=[bracket(*"axy")], placed=[on_line("x", on=join("a", "y"))], any=["y"]),
        "too early",
    ),
    "a claim on all points": (assumed("a b", join("a", "o"), given=[ABX], placed=[X_ON_AB], any=["o"]), "KeyError"),
    # Auxiliary points.
    "an auxiliary point that is a line": (
        assumed("a b c d", bracket(*"abx"), given=[], placed=[M_AND_X], meets=[["m", join("a", "b")]], rank=4),
        "that is none",
    ),
    "an auxiliary point in the claim": (
        assumed(
            "a b c d", bracket(*"amc"), given=[], placed=[M_ON_AB], meets=[["m", meet(join("a", "b"), join("c", "d"))]]
        ),
        "is named",
    ),
    "an auxiliary point of itself": (
        assumed("a b c d", ABX, given=[], placed=[M_AND_X], meets=[["m", meet(join("m", "b"), join("c", "d"))]]),
        "is named",
    ),
    "an auxiliary point that is a point of the claim": (
        assumed("a b x", ABX, given=[], placed=[], meets=[["x", meet(join("a", "b"), join("a", "b"))]]),
        "is named",
    ),
    "an auxiliary point as a fresh one": (
        assumed(
            "a b c g m",
            "x",
            given=[join("a", "x"), bracket(*"bcx")],
            nonzero=["a", BC],
            placed=[placed("x", meet(join("a", "m", "g"), BC), flat("a", [0, 1]), flat(BC, [1, 1]), fresh="mg")],
            meets=[["m", meet(join("a", "b"), join("b", "c"))]],
        ),
        "too early",
    ),
    "an auxiliary point on another line": (
        assumed(
            "a b c d", ABX, given=[], placed=[M_ON_AB], meets=[["m", meet(join("a", "c"), join("b", "d"))]], any=["x"]
        ),
        "need not lie",
    ),
    "an auxiliary point among those at infinity": (  # it is a finite one, and so is x
        assumed(
            "m i a",
            bracket("x", "i"),
            rank=2,
            ideal=2,
            given=[bracket("x", "a")],
            nonzero=["a"],
            placed=[placed("x", "m", flat("m", [0, -1]))],
            meets=[["m", "a"]],
        ),
        "is named",
    ),
    "an auxiliary point that is zero": (  # not what is said not to vanish, although its parts are the same
        assumed(
            "a b c f g",
            bracket("x", "c", "g"),
            given=[],
            nonzero=["c", twice_c("abf", "abf")],
            placed=[placed("m", "c", flat("c", [])), placed("x", "m", flat("m", []))],
            meets=[["m", twice_c("abf", "baf")]],
        ),
        "may vanish",
    ),
    "an auxiliary point for all points": (
        assumed("a b c", bracket(*"abc"), given=[bracket(*"abo")], placed=[M_ON_AB], meets=[["m", "o"]], any=["o"]),
        "not zero for all",
    ),
    "what does not vanish as it stands": (
        assumed("a b", ABX, given=[ABX], placed=[placed("x", join("a", "b"), flat(join("a", "b"), []))]),
        "need not lie",
    ),
    "another assumption, with a relation": (
        assumed(
            "a b c",
            ABX,
            given=[bracket(*"acx")],
            placed=[placed("x", join("a", "b"), flat(join("a", "b"), [0, 1, [[[0, 1, 2], [0, 1, 3], 1, [[1]]]]]))],
        ),
        "need not lie",
    ),
    # Expansions and relations.
    "unlike sides": (theorem("a b c", join(*"abc"), bracket(*"abc")), "unlike steps"),
    "an unlike sum": (theorem("a b", ["sum", "a", join("a", "b")], ["sum", join("a", "b"), "a"]), "unlike steps"),
    "a join beyond the rank": (theorem("a b c d", join(*"abcd")), "beyond the rank"),
    "a meet that is too small": (theorem("a b", meet("a", "b")), "too small"),
    "the sign of a meet": (theorem("a b c d", meet(join(*"ab"), join(*"cd")), meet(join(*"cd"), join(*"ab"))), "left"),
    "finite points at infinity": (theorem("i j k a", bracket("i", "j", "a"), ideal=3), "left"),
    "more points at infinity than there are": (theorem("a b c", bracket(*"abc"), ideal=4), "number of points"),
    "a negative number of them": (theorem("a b c", bracket(*"abc"), ideal=-1), "number of points"),
    "a definition of itself": (theorem("a", "#1", definitions=[["#1", ["sum", "#1", "#1"]]]), "RecursionError"),
    "relations with repeated points": (
        theorem("a b c", bracket(*"abc"), relations=[[[0, 1, 2], [0, 1, 2], 1, [[1]]]]),
        "left",
    ),
    "a relation of nothing": (
        theorem("a b c", bracket(*"abc"), relations=[[[0, 1, 2], [0, 1, 2], 0, [[1]]]]),
        "unlike",
    ),
    "points that are no numbers": (
        theorem(
            "a b c", bracket(*"abc"), relations=[[[NAN, 1, 2], [0, NAN, 2], 1, [[1, [0, 1, 2]], [-1, [NAN, 0, 1]]]]]
        ),
        "left",
    ),
    "points of negative numbers": (
        theorem("a b c", bracket(*"abc"), relations=[[[-1, 0, 1], [True, 2, 1.0], 1, [[1, [0, 1, 2]]]]]),
        "left",
    ),
    "another version": (theorem("a", "a", "a", name=None), "version"),
}


@pytest.mark.parametrize(("attack", "reason"), ATTACKS.values(), ids=ATTACKS)
def test_nothing_false_is_proved(attack: Changes, reason: str, tmp_path: Path) -> None:
    refused(tmp_path, attack, reason, **({"version": 2} if reason == "version" else {}))


TRUE: dict[str, tuple[Changes, str]] = {
    "the space": (
        theorem("a b c d", meet(join(*"ab"), join(*"ab"))),
        "'attack' in the file: ((a \\/ b) /\\ (a \\/ b)) == 0 (rank 3)",
    ),
    "points at infinity": (
        theorem("i j k", bracket(*"ijk"), ideal=3),
        "'attack' in the file: [i j k] == 0 (rank 3, i at infinity, j at infinity, k at infinity)",
    ),
    "for all points": (
        assumed("a b", ABX, given=[ABX, bracket(*"abo")], placed=[X_ON_AB], any=["o"]),
        "'attack' in the file: [a b x] == 0, where [a b x] == 0 and [a b o] == 0 (rank 3, for all o)",
    ),
    "numbers as they are read": (
        theorem("", number(0.1), number("\n3602879701896397/36028797018963968 ")),
        "'attack' in the file: 3602879701896397/36028797018963968 == 3602879701896397/36028797018963968 (rank 3)",
    ),
    "a name of two lines": (
        theorem("a", "a", "a", name="one'\nproved  'two"),
        "\"one'\\nproved  'two\" in the file: a == a (rank 3)",
    ),
}


@pytest.mark.parametrize(("true", "printed"), TRUE.values(), ids=TRUE)
def test_the_whole_claim_is_printed(true: Changes, printed: str, tmp_path: Path) -> None:
    proved(tmp_path, true, printed)
