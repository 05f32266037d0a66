"""Legs and other lines: analysed, compared, drawn and reported, under assumptions and in other ranks."""

from __future__ import annotations

from random import Random

from ..case import Case
from ..grammar import LETTERS, WORDS, Grammar, legs
from ..mutating import mutated
from .family import Family

__all__ = ["STRUCTURES"]


def structure(rng: Random) -> Case:
    text = legs(rng)
    if rng.random() < 0.2:
        text = mutated(rng, text, (*WORDS, "aa", "AB", "ab ab", "ab, cd", "a-b"), most=2)
    text = text.replace("\0", "")
    command = rng.choices(("analyze", "transversals", "report"), (8, 1, 0.5))[0]
    argv = [command, text]
    if rng.random() < 0.1:
        argv = [command, "-"]
    rank = 4
    if rng.random() < 0.15 and command != "transversals":
        rank = rng.choice((2, 3, 3, 3, 5))
        argv += ["--rank", str(rank)]
        if argv[1] != "-":
            argv[1] = legs(rng, number=rank * (rank - 1) // 2)
    if rng.random() < 0.25:
        g = Grammar(rng, rank, tuple(LETTERS[:8]))
        argv += [
            "--given",
            g.assumptions()
            if rng.random() < 0.8
            else rng.choice(("ideal i j", "[abcd] == 2", "a", "collinear(A, B, C)")),
        ]
    if rng.random() < 0.15:
        argv += ["--ideal", " ".join(rng.sample(LETTERS + "ABC", rng.randint(1, 4)))]
    if command != "transversals":
        argv += ["--search", "0"]
        if rng.random() < 0.2:
            argv += ["--order", rng.choice(("2 1 3 4 6 5", "6 5 4 3 2 1", "1 2 3", "1 1 1 1 1 1", "ab cd", ""))]
        argv += rng.choice(((), (), (), ("--recheck",)))
    if command == "analyze":
        argv += rng.choice(
            (
                (),
                (),
                (),
                ("--full",),
                ("--figure", "f.svg"),
                ("--without", "four-planes"),
                ("--rules", "planes,four-planes"),
            )
        )
    if command == "report":
        argv += rng.choice(((), ("-o", "r.html"), ("--no-3d",)))
    else:
        argv += rng.choice(((), (), ("--json",), ("--json",), ("--latex",), ("--ascii",), ("-o", "out.txt")))
    return Case("structures", tuple(argv), {}, text if argv[1] == "-" else "", 5.0)


STRUCTURES = Family(
    "structures", "legs and other lines, under assumptions and in other ranks", structure, share=1.5, few=25
)
