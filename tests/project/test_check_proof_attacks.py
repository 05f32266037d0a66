"""Proof files that say something false, or that would make the checker print something that it has not checked."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from project.forged import (
    Changes,
    assumed,
    bracket,
    flat,
    join,
    meet,
    number,
    on_line,
    placed,
    refused,
    run,
    theorem,
    twice_c,
)

ABX, ABY, ADX, ADY = (bracket(*names) for names in ("abx", "aby", "adx", "ady"))
X_ON_AB = on_line("x")
Y_ON_AB = on_line("y", 1)
TWO_ON_AB: Changes = {"given": [ABX, ABY], "placed": [X_ON_AB, Y_ON_AB]}
BC, PLANES = join("b", "c"), meet(join("a", "b", "c"), join("a", "d", "e"))
PLANE = meet(join("a", "b", "c"))
ON_BOTH = [flat(join("a", "b", "c"), [0, 1]), flat(join("a", "d", "e"), [1, 1])]
CROSSED = meet(join("b", "c"), join("d", "e"))
ALMOST = [
    "sum",
    ["product", bracket("b", "d", "e"), bracket("a", "c", "x")],
    ["product", number(f"-{2**60 + 1}/{2**60}"), bracket("c", "d", "e"), bracket("a", "b", "x")],
]
NAN = float("nan")
AB = join("a", "b")
M_ON_AB = placed("m", AB, flat(AB, []))
M_AND_X = placed("x", join("m", "c"), flat(join("m", "c"), []))

FACTORS = ["product", ABX, ABY]  # that ABX vanishes does not follow


def in_cases(*cases: Changes, claim: Any = ABX, given: Any = FACTORS, **more: Any) -> Changes:
    return assumed("a b x y", claim, given=[given], placed=[], cases=list(cases), **more)


def case(claim: Any = ABX, *given: Any, names: str = "a b y", place: Any = X_ON_AB, **more: Any) -> Changes:
    """That something vanishes by the first of what is given, since one point is placed by it."""
    return assumed(names, claim, given=[*given], placed=[place], **more)


def lemma(left: Any, right: Any, given: Any = (), placed: Any = (), names: str = "a b x y", **more: Any) -> Changes:
    return assumed(names, left, right, given=[*given], placed=[*placed], **more)


AX, C, OF_NOTHING = join("a", "x"), join("c"), ["product", number(-1), number(0)]


def for_all(
    factor: Any, claim: Any = AX, names: str = "a x c y z", nonzero: Any = (C,), more: str = "", **of: Any
) -> Changes:
    """A claim by a factor that does not vanish for all points that the case adds."""
    case = lemma(["product", factor, AX], ["product", factor, ["sum", AX, OF_NOTHING]], names=names, **of)
    return assumed(f"a b x c {more}", claim, given=[AX], placed=[], nonzero=[*nonzero], cases=[case])


OF_FACTORS = lemma(FACTORS, FACTORS)
WHERE_X = case(ABX, ABX, FACTORS)
WHERE_Y = case(ABX, ABX, ABY, FACTORS)
ZERO_TIMES = ["product", number(0), ABX]
SQUARE = ["product", ABX, *FACTORS[1:]]

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
    # Cases.
    "a case that is missing": (in_cases(OF_FACTORS, WHERE_X), "zip()"),
    "a case too many": (in_cases(OF_FACTORS, WHERE_X, WHERE_X, WHERE_X), "assumes more"),
    "no cases": (in_cases(), "IndexError"),
    "a case that assumes more": (in_cases(OF_FACTORS, WHERE_X, WHERE_Y), "assumes more"),
    "a case of the other factor": (in_cases(OF_FACTORS, WHERE_X, WHERE_X), "assumes more"),
    "a case in which more does not vanish": (
        in_cases(OF_FACTORS, {**WHERE_X, "nonzero": ["a"]}, WHERE_X),
        "assumes more",
    ),
    "a case that is not proved": (
        in_cases(OF_FACTORS, WHERE_X, case(ABX, ABY, FACTORS, names="a b x", place=on_line("y"))),
        "left",
    ),
    "a case of another claim": (
        in_cases(OF_FACTORS, WHERE_X, case(ABY, ABY, FACTORS, names="a b x", place=on_line("y"))),
        "another claim",
    ),
    "a case in which a point is another": (
        in_cases(OF_FACTORS, WHERE_X, {**WHERE_X, "definitions": [["y", "x"]], "points": ["a", "b"]}),
        "assumes more",
    ),
    "a case at infinity": (
        in_cases(OF_FACTORS, WHERE_X, case(ABX, FACTORS, names="y a b", ideal=1)),
        "a case at infinity",
    ),
    "a case for all points": (
        in_cases(OF_FACTORS, WHERE_X, {**WHERE_X, "points": ["a", "b"], "any": ["y"]}),
        "another space",
    ),
    "a factor for all points": (
        assumed(
            "a b x",
            ABX,
            given=[["product", ABX, bracket(*"abo")]],
            placed=[],
            any=["o"],
            cases=[lemma(["product", ABX, bracket(*"abo")], ["product", ABX, bracket(*"abo")], names="a b x o")],
        ),
        "another space",
    ),
    "a case of another rank": (in_cases(OF_FACTORS, WHERE_X, {**WHERE_X, "rank": 4}), "another space"),
    "a case without assumptions": (in_cases(OF_FACTORS, WHERE_X, theorem("a b x y", ABX)), "KeyError"),
    "a product that is not given": (in_cases(lemma(ABX, ABX), WHERE_X), "need not vanish"),
    "a product of which a term is not given": (
        in_cases(lemma(["sum", FACTORS, ABX], ["sum", FACTORS, ABX]), WHERE_X),
        "need not vanish",
    ),
    "a sum that is not given": (
        in_cases(lemma(["sum", FACTORS, ABX], ABX, given=[FACTORS]), WHERE_X, given=["sum", FACTORS, ABY]),
        "need not vanish",
    ),
    "another product": (in_cases(lemma(FACTORS, ABX), WHERE_X), "left"),
    "a product that is equal where more vanishes": (
        in_cases(lemma(FACTORS, ABX, [ABX], [X_ON_AB], "a b y"), WHERE_X),
        "assumes more",
    ),
    "a product that is equal where more does not vanish": (
        in_cases(lemma(FACTORS, FACTORS, nonzero=[ABY]), WHERE_X),
        "assumes more",
    ),
    "a product that is zero": (in_cases(lemma(number(0), ZERO_TIMES), WHERE_X), "assumes more"),
    "a product that is zero, in its own case": (
        in_cases(lemma(number(0), ZERO_TIMES), case(ABX, FACTORS, number(0)), WHERE_X),
        "need not lie",
    ),
    "a contradiction to what may vanish": (
        in_cases(OF_FACTORS, case(ABY, ABY, FACTORS, names="a b x", place=on_line("y")), nonzero=[ABX]),
        "another claim",
    ),
    "an assumption of cases that is no expression": (
        in_cases(OF_FACTORS, WHERE_X, WHERE_X, nonzero=["1 != 0"]),
        "KeyError",
    ),
    # Points that a case adds.
    "a bracket that vanishes for all added points": (for_all(bracket(*"cyz"), nonzero=()), "zip()"),
    "a bracket with an added point twice": (for_all(bracket(*"cyy")), "zip()"),
    "a bracket with one added point under two names": (
        for_all(bracket("c", "#1", "y"), definitions=[["#1", "y"]], names="a x c y"),
        "zip()",
    ),
    "a bracket with a point that is not added": (for_all(bracket(*"cyz"), more="y"), "zip()"),
    "a bracket of added points alone": (for_all(bracket(*"ycz"), names="a x y z c", nonzero=(), more="d"), "zip()"),
    "an added point in the rest": (
        for_all(bracket(meet(join("y", "c"), join("a", "x")), "y", "z"), nonzero=(C,)),
        "zip()",
    ),
    "an added point at infinity": (for_all(bracket(*"cyz"), names="y a x c z", ideal=1), "a case at infinity"),
    "an added point for all points": (for_all(bracket(*"cyz"), names="a x c y", any=["z"]), "another space"),
    "the difference of other sides": (for_all(bracket(*"cyz"), claim=join("a", "b")), "zip()"),
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
    "cases": (
        in_cases(
            lemma(SQUARE, SQUARE),
            case(FACTORS, ABX, SQUARE),
            case(FACTORS, ABY, SQUARE, names="a b x", place=on_line("y")),
            claim=FACTORS,
            given=SQUARE,
        ),
        "'attack' in the file: ([a b x] * [a b y]) == 0, where ([a b x] * [a b x] * [a b y]) == 0 (rank 3)",
    ),
    "a factor that does not vanish": (
        in_cases(OF_FACTORS, case(ABX, ABX, FACTORS, nonzero=[ABY]), nonzero=[ABY]),
        "'attack' in the file: [a b x] == 0, where ([a b x] * [a b y]) == 0 and [a b y] != 0 (rank 3)",
    ),
    "a case that is none": (
        in_cases(
            lemma(SQUARE, SQUARE),
            case(ABX, ABX, SQUARE, nonzero=[["sum", ABY]]),
            case(["sum", ABY], ABY, SQUARE, names="a b x", place=on_line("y")),
            given=SQUARE,
            nonzero=[["sum", ABY]],
        ),
        "'attack' in the file: [a b x] == 0, where ([a b x] * [a b x] * [a b y]) == 0 and ([a b y]) != 0 (rank 3)",
    ),
    "a sum of products of what is given": (
        in_cases(
            lemma(["sum", FACTORS, ["product", number(2), ABX, ABY]], ["product", number(3), ABX, ABY]),
            case(FACTORS, ABX),
            case(FACTORS, ABY, ABX, names="a b x", place=on_line("y")),
            claim=FACTORS,
            given=ABX,
        ),
        "'attack' in the file: ([a b x] * [a b y]) == 0, where [a b x] == 0 (rank 3)",
    ),
    "points that a case adds": (
        for_all(bracket(*"cyz")),
        "'attack' in the file: (a \\/ x) == 0, where (a \\/ x) == 0 and (c) != 0 (rank 3)",
    ),
    "a name of two lines": (
        theorem("a", "a", "a", name="one'\nproved  'two"),
        "\"one'\\nproved  'two\" in the file: a == a (rank 3)",
    ),
}


@pytest.mark.parametrize(("true", "printed"), TRUE.values(), ids=TRUE)
def test_the_whole_claim_is_printed(true: Changes, printed: str, tmp_path: Path) -> None:
    done = run(tmp_path, true)
    claim, end = done.stdout.replace(":\n  ", ": ").splitlines()
    assert claim == f"proved, called {printed}"
    assert end.startswith("theorems proved: 1, digest ")
