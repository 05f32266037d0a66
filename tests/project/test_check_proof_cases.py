"""Theorems in cases that leave something out, that assume more in one, or of which one is of another claim."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from project.proof_attacks import (
    AB,
    ABX,
    ABY,
    ADX,
    FACTORS,
    OF_FACTORS,
    SQUARE,
    WHERE_X,
    WHERE_Y,
    X_ON_AB,
    ZERO_TIMES,
    Changes,
    assumed,
    bracket,
    case,
    flat,
    in_cases,
    join,
    lemma,
    meet,
    number,
    on_line,
    placed,
    proved,
    refused,
    theorem,
)


def zero(e: Any, **more: Any) -> Changes:
    """That something vanishes, with no point placed."""
    return lemma(e, number(0), **more)


ABO = bracket(*"abo")


def b_on_a(index: int) -> Changes:
    return placed("b", "a", flat("a", [index, 1]))


WHERE_Y_TOO = case(ABX, ABX, ABY)
WHERE_NOT = case(ABX, ABX, nonzero=[ABY])
MEET = meet(join(*"abx"), join(*"aby"))
ABXY = bracket(*"abxy")


def apart(*cases: Changes, claim: Any = ABX, split: Any = ABY, **more: Any) -> Changes:
    """Where an expression vanishes, and where it does not."""
    return assumed("a b d x y", claim, given=[ABX], placed=[], cases=list(cases), split=split, **more)


def of_planes(*cases: Changes) -> Changes:
    """Two planes of space with two points in common, of which the meet is zero."""
    return {**in_cases(lemma(MEET, ["product", ABXY, AB], rank=4), *cases, claim=ABXY, given=MEET), "rank": 4}


ON_BOTH_PLANES = zero(ABXY, given=[MEET, ABXY], rank=4)


def of_all(*cases: Changes, given: Any = None, claim: Any = None) -> Changes:
    """[a b o] (a \\/ x) vanishes for all o."""
    product = ["product", ABO, join("a", "x")] if given is None else given
    shown = ["product", ABX, join("a", "x")] if claim is None else claim
    return assumed("a b d x", shown, given=[product], placed=[], any=["o"], cases=list(cases))


OF_ALL = lemma(["product", ABO, join("a", "x")], ["product", ABO, join("a", "x")], names="a b d x o")
IN_AB = zero(["product", ABX, join("a", "x")], given=[AB], names="a d x", any=["o"], placed=[b_on_a(0)])
IN_A = zero(["product", ABX, join("a", "x")], given=[join("a", "x")], names="a b d x", any=["o"])
TWICE = bracket("a", "o", "o")
HIDDEN = bracket("a", "b", meet(join("b", "o"), join("d", "x")))


AX, C, OF_NOTHING = join("a", "x"), join("c"), ["product", number(-1), number(0)]


def for_all(
    factor: Any, claim: Any = AX, names: str = "a x c y z", nonzero: Any = (C,), more: str = "", **of: Any
) -> Changes:
    """A claim by a factor that does not vanish for all points that the case adds."""
    case = lemma(["product", factor, AX], ["product", factor, ["sum", AX, OF_NOTHING]], names=names, **of)
    return assumed(f"a b x c {more}", claim, given=[AX], placed=[], nonzero=[*nonzero], cases=[case])


ATTACKS: dict[str, tuple[Changes, str]] = {
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
            given=[["product", ABX, ABO]],
            placed=[],
            any=["o"],
            cases=[
                lemma(["product", ABX, ABO], ["product", ABX, ABO], names="a b x o"),
                case(ABX, ABX, names="a b", any=["o"]),
            ],
        ),
        "zip()",
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
    # An expression vanishes or it does not.
    "a side that is missing": (apart(WHERE_Y_TOO), "zip()"),
    "a side too many": (apart(WHERE_Y_TOO, WHERE_NOT, WHERE_NOT), "zip()"),
    "both sides where it vanishes": (apart(WHERE_Y_TOO, WHERE_Y_TOO), "assumes more"),
    "both sides where it does not": (apart(WHERE_NOT, WHERE_NOT), "assumes more"),
    "the sides in the other sequence": (apart(WHERE_NOT, WHERE_Y_TOO), "assumes more"),
    "another expression where it vanishes": (apart(case(ABX, ABX, ADX), WHERE_NOT), "assumes more"),
    "another expression where it does not": (apart(WHERE_Y_TOO, case(ABX, ABX, nonzero=[ADX])), "assumes more"),
    "another expression": (apart(WHERE_Y_TOO, WHERE_NOT, split=ADX), "assumes more"),
    "a side that assumes more": (apart(case(ABX, ABX, ABY, ADX), WHERE_NOT), "assumes more"),
    "a side in which more does not vanish": (
        apart(WHERE_Y_TOO, case(ABX, ABX, nonzero=[ABY, ADX])),
        "assumes more",
    ),
    "a side of another claim": (apart(WHERE_Y_TOO, case(ADX, ABX, nonzero=[ABY])), "another claim"),
    "a side that says no more than what it assumes": (
        apart(case(ABY, ABX, ABY), WHERE_NOT),
        "another claim",
    ),
    "a first side of another claim": (
        apart(lemma(ABX, ABX), WHERE_NOT),
        "another claim",
    ),
    "a side at infinity": (apart(zero(ABY, given=[ABY], names="a b y x", ideal=3), WHERE_NOT), "at infinity"),
    "a side that is not proved": (
        apart(
            zero(ADX, given=[ABX, ADX], names="a b d x"),
            zero(ADX, given=[ABX], nonzero=[ADX], names="a b d x"),
            claim=ADX,
            split=ADX,
        ),
        "left",
    ),
    "a contradiction that is none": (
        apart(WHERE_Y_TOO, zero(ABY, given=[ABX], nonzero=[ABY])),
        "left",
    ),
    "what does not vanish for all points": (
        apart(
            zero(ABX, given=[ABX, ABO], names="a b x", any=["o"]),
            zero(ABX, given=[ABX], nonzero=[ABO], names="a b x", any=["o"]),
            split=ABO,
            any=["o"],
        ),
        "not zero for all",
    ),
    "a side inside a side, where what does not vanish does": (
        apart(WHERE_Y_TOO, apart(WHERE_Y_TOO, WHERE_NOT, split=ADX, nonzero=[ABY])),
        "assumes more",
    ),
    # Extensors, and brackets for all points.
    "a meet that may be zero as a line": (of_planes(ON_BOTH_PLANES), "zip()"),
    "a case of one point of a line": (
        of_planes(ON_BOTH_PLANES, zero(ABXY, given=[MEET, join("a")], rank=4)),
        "assumes more",
    ),
    "a bracket for all points that is one for a point": (
        of_all(OF_ALL, zero(join("a"), given=[join("a")], names="a b d x"), IN_A),
        "assumes more",
    ),
    "a bracket with a point for all that stands twice": (
        of_all(
            lemma(["product", TWICE, join("a", "d", "x")], ["product", TWICE, join("a", "d", "x")], names="a b d x o"),
            zero(join("a"), given=[join("a")], names="a b d x", any=["o"]),
            IN_A,
            given=["product", TWICE, join("a", "d", "x")],
        ),
        "assumes more",
    ),
    "a bracket with a meet of points for all": (
        of_all(
            lemma(["product", HIDDEN, join("a", "x")], ["product", HIDDEN, join("a", "x")], names="a b d x o"),
            zero(join("a", "b"), given=[join("a", "b")], names="a b d x", any=["o"]),
            IN_A,
            given=["product", HIDDEN, join("a", "x")],
        ),
        "assumes more",
    ),
    "a point for all points in the claim": (of_all(OF_ALL, IN_AB, IN_A, claim=["product", ABX, ABO]), "KeyError"),
    # What has a part that vanishes.
    "a part of a sum": (lemma(["sum", ABX, ADX], number(0), given=[ABX], names="a b d x"), "left"),
    "a part of a side": (lemma(["product", ABX, ADX], ADX, given=[ABX], names="a b d x"), "left"),
    "a part with another sign": (lemma(bracket(*"bax"), number(0), given=[ABX], names="a b x"), "left"),
    "a sum of which a part vanishes, as a factor": (
        in_cases(lemma(["join", ["sum", join("a", "x"), join("b", "x")], "y"], ABX), WHERE_X, given=join("a", "x")),
        "need not vanish",
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
}


@pytest.mark.parametrize(("attack", "reason"), ATTACKS.values(), ids=ATTACKS)
def test_nothing_false_is_proved_in_cases(attack: Changes, reason: str, tmp_path: Path) -> None:
    refused(tmp_path, attack, reason)


TRUE: dict[str, tuple[Changes, str]] = {
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
    "where an expression vanishes and where it does not": (
        apart(WHERE_Y_TOO, WHERE_NOT),
        "'attack' in the file: [a b x] == 0, where [a b x] == 0 (rank 3)",
    ),
    "where what does not vanish vanishes": (
        apart(
            zero(ADX, given=[ABX, ADX], names="a b d x"),
            case(["product", ABX, ADX], ABX, nonzero=[ADX], names="a b d"),
            claim=["product", ABX, ADX],
            split=ADX,
            nonzero=[ADX],
        ),
        "'attack' in the file: ([a b x] * [a d x]) == 0, where [a b x] == 0 and [a d x] != 0 (rank 3)",
    ),
    "a meet that is zero as a line": (
        of_planes(ON_BOTH_PLANES, zero(ABXY, given=[MEET, AB], rank=4, names="a x y", placed=[b_on_a(1)])),
        "'attack' in the file: [a b x y] == 0, where ((a \\/ b \\/ x) /\\ (a \\/ b \\/ y)) == 0 (rank 4)",
    ),
    "a bracket for all points": (
        of_all(OF_ALL, IN_AB, IN_A),
        "'attack' in the file: ([a b x] * (a \\/ x)) == 0, where ([a b o] * (a \\/ x)) == 0 (rank 3, for all o)",
    ),
    "a part that vanishes": (
        zero(["product", ADX, join(AB, "x")], given=[AB], names="a b d x"),
        "'attack' in the file: ([a d x] * ((a \\/ b) \\/ x)) == 0, where (a \\/ b) == 0 (rank 3)",
    ),
    "points that a case adds": (
        for_all(bracket(*"cyz")),
        "'attack' in the file: (a \\/ x) == 0, where (a \\/ x) == 0 and c != 0 (rank 3)",
    ),
}


@pytest.mark.parametrize(("true", "printed"), TRUE.values(), ids=TRUE)
def test_the_whole_claim_is_printed_of_what_is_proved_in_cases(true: Changes, printed: str, tmp_path: Path) -> None:
    proved(tmp_path, true, printed)
