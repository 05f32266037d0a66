"""Points that are equal to an expression, and those on lines through sums, in proof files written by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from project.proof_attacks import (
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
    twice_c,
)

ABX = bracket(*"abx")
BC = join("b", "c")
A_AND_B = ["sum", "a", "b"]
LINES = ["sum", join("a", "b"), join("c", "d")]
DIAGONAL = join("d", twice_c("abe", "abe"))


def equal(name: str, to: Any, *why: Any) -> Changes:
    return {**placed(name, to), "equal": list(why)}


def difference(name: str, to: Any) -> list[Any]:
    return ["sum", name, ["product", number(-1), to]]


ATTACKS: dict[str, tuple[Changes, str]] = {
    "a point that is equal to another sum": (
        assumed(
            "a b",
            ABX,
            given=[difference("x", ["sum", "c", "b"])],
            placed=[equal("c", "a", 0, 0), equal("x", A_AND_B, 0, 1)],
        ),
        "need not equal",
    ),
    "a multiple of what a point is equal to": (
        assumed(
            "a b",
            "x",
            ["product", number(2), A_AND_B],
            given=[difference("x", A_AND_B)],
            placed=[equal("x", ["product", number(2), A_AND_B], 0, 1)],
        ),
        "need not equal",
    ),
    "a point that lies on what it is not equal to": (
        assumed("a b", "x", "a", given=[join("a", "x")], nonzero=["a"], placed=[equal("x", "a", 0, 1)]),
        "need not equal",
    ),
    "a point that is equal to something as it stands": (
        assumed("a b", "x", "a", given=[difference("x", "a")], placed=[equal("x", "a")]),
        "need not equal",
    ),
    "a point that is equal to a line": (
        assumed("a b", "x", "a", given=[difference("x", "a")], placed=[equal("x", join("a", "b"), 0, 1)]),
        "need not equal",
    ),
    "a point that is equal to a later one": (
        assumed("a", "x", "a", given=[difference("x", "y")], placed=[equal("x", "y", 0, 1), equal("y", "a", 0, 0)]),
        "too early",
    ),
    "a point that is equal to itself": (
        assumed("a", "x", "a", given=[difference("x", "x")], placed=[equal("x", "x", 0, 1)]),
        "too early",
    ),
    "a point that is equal to nothing": (  # a scalar that is zero times e is no sum of the scalar and e
        assumed(
            "a b e",
            "x",
            "e",
            rank=4,
            given=["x"],
            placed=[equal("x", join(meet(join("a", "b"), join("a", "b")), "e"), 0, 1)],
        ),
        "left",
    ),
    "a line of free points after one that is equal to their sum": (
        assumed(
            "a b",
            join("a", "b"),
            given=[difference("x", A_AND_B), bracket("x", "a", "y")],
            placed=[equal("x", A_AND_B, 0, 1), on_line("y", 1, join("x", "a"))],
        ),
        "may vanish",
    ),
    "a line through a point that is equal to a sum, on another line": (
        assumed(
            "a b c",
            bracket(*"acy"),
            given=[difference("x", A_AND_B), bracket(*"xyc")],
            nonzero=[join("a", "c")],
            placed=[equal("x", A_AND_B, 0, 1), placed("y", join("a", "c"), flat(join("a", "c"), [1, -1]))],
        ),
        "need not lie",
    ),
    "a line through a point of a line, on another line": (
        assumed(
            "a b c",
            bracket(*"acy"),
            given=[ABX, bracket(*"xyc")],
            nonzero=[join("a", "c")],
            placed=[on_line("x"), placed("y", join("a", "c"), flat(join("a", "c"), [1, -1]))],
        ),
        "need not lie",
    ),
    "a point that is written out before it is placed": (
        assumed(
            "a b c",
            bracket(*"acy"),
            given=[difference("x", A_AND_B), bracket(*"xyc")],
            nonzero=[join("a", "c"), join(A_AND_B, "c")],
            placed=[placed("y", join(A_AND_B, "c"), flat(join(A_AND_B, "c"), [1, -1])), equal("x", A_AND_B, 0, 1)],
        ),
        "need not lie",
    ),
    "a point on a sum of lines": (  # which is no line
        assumed(
            "a b c d f g h",
            "x",
            rank=4,
            given=[join(LINES, "x")],
            nonzero=[LINES],
            placed=[placed("x", LINES, flat(LINES, [0, 1]), fresh="fgh")],
        ),
        "not made by joins and meets",
    ),
    "a line through a sum with another sign": (
        assumed(
            "a b c d e",
            bracket("x", "c", "d"),
            given=[join(DIAGONAL, "x")],
            nonzero=[DIAGONAL],
            placed=[placed("x", join("d", twice_c("abe", "bae")), flat(DIAGONAL, [0, 1]))],
        ),
        "need not lie",
    ),
    "a line through a sum that may vanish": (
        assumed(
            "a b c d e",
            bracket("x", "c", "d"),
            given=[join(DIAGONAL, "x")],
            nonzero=[join("d", ["sum", "c", "a"])],
            placed=[placed("x", DIAGONAL, flat(DIAGONAL, [0, 1]))],
        ),
        "may vanish",
    ),
    "a fresh point in a sum": (
        assumed(
            "a b c f g",
            join("x", "b"),
            given=[join("a", "x"), bracket(*"bcx")],
            nonzero=["a", BC],
            placed=[
                placed(
                    "x",
                    meet(join(["sum", "a", ["product", number(0), "f"]], "g"), BC),
                    flat("a", [0, 1]),
                    flat(BC, [1, 1]),
                    fresh="fg",
                )
            ],
        ),
        "may vanish",
    ),
}


@pytest.mark.parametrize(("attack", "reason"), ATTACKS.values(), ids=ATTACKS)
def test_nothing_false_is_proved(attack: Changes, reason: str, tmp_path: Path) -> None:
    refused(tmp_path, attack, reason)


TRUE: dict[str, tuple[Changes, str]] = {
    "a point on a line through a sum": (
        assumed(
            "a b c d e",
            bracket("x", "c", "d"),
            given=[join(DIAGONAL, "x")],
            nonzero=[join(twice_c("bae", "bae"), "d")],
            placed=[placed("x", DIAGONAL, flat(DIAGONAL, [0, 1]))],
        ),
        "'attack' in the file: [x c d] == 0, where ((d \\/ (([a b e] * c) + ([a b e] * c))) \\/ x) == 0 "
        "and ((([b a e] * c) + ([b a e] * c)) \\/ d) != 0 (rank 3)",
    ),
    "a line through a point that is equal to a sum": (
        assumed(
            "a b c",
            bracket("c", "y", A_AND_B),
            given=[difference("x", A_AND_B), bracket(*"xyc")],
            nonzero=[join(A_AND_B, "c")],
            placed=[equal("x", A_AND_B, 0, 1), placed("y", join(A_AND_B, "c"), flat(join(A_AND_B, "c"), [1, -1]))],
        ),
        "'attack' in the file: [c y (a + b)] == 0, where (x + (-1 * (a + b))) == 0 and [x y c] == 0 "
        "and ((a + b) \\/ c) != 0 (rank 3)",
    ),
    "a point that is equal to an expression": (
        assumed("a b", ABX, given=[difference("x", A_AND_B)], placed=[equal("x", A_AND_B, 0, 1)]),
        "'attack' in the file: [a b x] == 0, where (x + (-1 * (a + b))) == 0 (rank 3)",
    ),
}


@pytest.mark.parametrize(("true", "printed"), TRUE.values(), ids=TRUE)
def test_what_is_true_is_proved(true: Changes, printed: str, tmp_path: Path) -> None:
    proved(tmp_path, true, printed)
