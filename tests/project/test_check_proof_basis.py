"""Points that are written in a basis of others, and differences closed by further points, in files written by hand."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path
from typing import Any

import pytest
from project.proof_attacks import ABX, ABY, Changes, assumed, bracket, flat, join, meet, number, placed, proved, refused

ABC, AB, CD = join("a", "b", "c"), join("a", "b"), join("c", "d")
EXCHANGE = [  # [abc][dpq] is the sum of [dbc][apq], [adc][bpq] and [abd][cpq]
    ["product", bracket(*"abc"), bracket(*"dpq")],
    [
        "sum",
        *(
            ["product", bracket(*one), bracket(*other)]
            for one, other in (("dbc", "apq"), ("adc", "bpq"), ("abd", "cpq"))
        ),
    ],
]
IN_ABC = [placed(name, ABC) for name in "dpq"]
ON_AB = flat(AB, [0, 1])


def free(names: str, *claim: Any, in_basis: list[Changes], **more: Any) -> Changes:
    return assumed(names, *claim, **{"given": [], "placed": in_basis, **more})


def lines(*exchanged: str) -> list[Any]:
    """The superbracket of all ten lines through two of five points of rank 5, some of which are others."""
    pairs = ["".join(pair) for pair in combinations("abcde", 2)]
    return ["superbracket", *(join(*(exchanged[i] if i < len(exchanged) else pair)) for i, pair in enumerate(pairs))]


def printed(first: str) -> str:
    rest = ["".join(pair) for pair in combinations("abcde", 2)][1:]
    each = [r"({} \/ {})".format(*ends) for ends in (first, *rest)]
    return f"[[{' '.join(each)}]]"


def difference(left: Any, right: Any) -> list[Any]:
    return ["sum", left, ["product", number(-1), right]]


def closed(by: str, **more: Any) -> Changes:
    """That ab equals cd, since their difference closed by a point vanishes."""
    claim = [AB, CD]
    zero = bracket(difference(*claim), by)
    lemma = assumed("a b c d", zero, zero, given=[zero], placed=[], **more)
    return assumed("a b c d", *claim, given=[zero], placed=[], cases=[lemma], **more)


ATTACKS: dict[str, tuple[Changes, str]] = {
    "a basis with a point at infinity": (  # where all three are the bracket is 0
        free("a b c d p q", *EXCHANGE, in_basis=IN_ABC, points=["a", "b", "c"], ideal=1),
        "need not lie on",
    ),
    "a basis of points on a line": (
        free("a b", ABX, in_basis=[placed("x", AB, ON_AB), placed("y", join("a", "b", "x"))], given=[ABX]),
        "need not lie on",
    ),
    "a basis in which a point stands twice": (
        free("a b c", ABX, in_basis=[placed("x", join("a", "b", "b"))]),
        "need not lie",
    ),
    "a basis that is a sum": (
        free("a b c", ABX, in_basis=[placed("x", join("a", "b", ["sum", "a", "c"]))]),
        "need not lie",
    ),
    "a basis of too few points": (free("a b c", ABX, in_basis=[placed("x", AB)]), "need not lie"),
    "a basis with itself": (free("a b", ABX, in_basis=[placed("x", join("a", "b", "x"))]), "too early"),
    "a basis with a point for all points": (
        free("a b", ABX, in_basis=[placed("x", join("a", "b", "o"))], any=["o"], given=[bracket("a", "b", "o")]),
        "too early",
    ),
    "a basis with an auxiliary point": (
        free("a b c d m", ABX, in_basis=[placed("x", join("a", "c", "m"))], meets=[["m", meet(AB, join("c", "d"))]]),
        "need not lie",
    ),
    "a point that is placed twice": (free("a b c", ABX, in_basis=[placed("x", ABC), placed("x", ABC)]), "names"),
    "a point in a basis that something is asked of": (  # it may be anywhere, which does not prove the claim
        free("a b c", ABX, in_basis=[placed("x", ABC)], given=[bracket("a", "c", "x")]),
        "terms are left",
    ),
    "two points on a line that may vanish": (  # that it is a part of a basis does not say that it is a line
        free(
            "a b c",
            bracket("c", "x", "y"),
            in_basis=[placed("d", ABC), placed("x", AB, ON_AB), placed("y", AB, flat(AB, [1, 1]))],
            given=[ABX, ABY],
        ),
        "may vanish",
    ),
    "another sign": (
        free("a b c", EXCHANGE[0], ["product", number(-1), EXCHANGE[1]], in_basis=IN_ABC),
        "terms are left",
    ),
    "lines in rank 5 that are written in no basis": (
        free("a b c d e f", lines("af"), ["product", number(-1), lines("fa")], in_basis=[], rank=5),
        "not written in a basis",
    ),
    "lines in rank 5 with the same sign": (
        free("a b c d e", lines("af"), lines("fa"), in_basis=[placed("f", join(*"abcde"))], rank=5),
        "terms are left",
    ),
    "lines in rank 5 that are exchanged": (
        free("a b c d e", lines("ac", "ab"), lines(), in_basis=[], rank=5),
        "terms are left",
    ),
    "nine lines in rank 5": (free("a b c d e", lines()[:-1], in_basis=[], rank=5), "not full"),
    # Differences that are closed by further points.
    "a difference closed by a point of the claim": (closed("a"), "zip()"),
    "a difference closed by a point at infinity": (
        closed("y", points=["y", "a", "b", "c", "d"], ideal=1),
        "zip()",
    ),
}


@pytest.mark.parametrize(("attack", "reason"), ATTACKS.values(), ids=ATTACKS)
def test_nothing_false_is_proved(attack: Changes, reason: str, tmp_path: Path) -> None:
    refused(tmp_path, attack, reason)


TRUE: dict[str, tuple[Changes, str]] = {
    "an exchange without a relation": (
        free("a b c", *EXCHANGE, in_basis=IN_ABC),
        "'attack' in the file: ([a b c] * [d p q]) == (([d b c] * [a p q]) + ([a d c] * [b p q]) "
        "+ ([a b d] * [c p q])) (rank 3)",
    ),
    "a dependent point beside a basis of the same points": (
        free("a b c", bracket("b", "a", "x"), in_basis=[placed("d", ABC), placed("x", AB, ON_AB)], given=[ABX]),
        "'attack' in the file: [b a x] == 0, where [a b x] == 0 (rank 3)",
    ),
    "ten lines": (
        free(
            "a b c d e",
            lines("af"),
            ["product", number(-1), lines("fa")],
            in_basis=[placed("f", join(*"abcde"))],
            rank=5,
        ),
        f"'attack' in the file: {printed('af')} == (-1 * {printed('fa')}) (rank 5)",
    ),
    "a difference closed by a further point": (
        assumed(
            "a b c d",
            AB,
            CD,
            given=[difference(AB, CD)],
            placed=[],
            cases=[
                assumed(
                    "a b c d y",
                    bracket(difference(AB, CD), "y"),
                    bracket(difference(AB, CD), "y"),
                    given=[difference(AB, CD)],
                    placed=[],
                )
            ],
        ),
        "'attack' in the file: (a \\/ b) == (c \\/ d), where ((a \\/ b) + (-1 * (c \\/ d))) == 0 (rank 3)",
    ),
}


@pytest.mark.parametrize(("true", "printed"), TRUE.values(), ids=TRUE)
def test_what_is_true_is_proved(true: Changes, printed: str, tmp_path: Path) -> None:
    proved(tmp_path, true, printed)
