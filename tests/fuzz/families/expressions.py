"""Expressions, equations and assumptions, well-typed or mistyped, for the commands of the algebra."""

from __future__ import annotations

from random import Random

from ..case import Case
from ..grammar import LETTERS, WORDS, Grammar
from ..mutating import mutated
from .family import Family

__all__ = ["EXPRESSIONS", "HOSTILE", "space_words"]

_COMMANDS = {"expand": 10.0, "straighten": 8.0, "prove": 10.0, "rewrite": 2.0, "factor": 0.6, "shorten": 0.6}


def expression(rng: Random) -> Case:
    g = Grammar.drawn(rng)
    command = rng.choices(list(_COMMANDS), list(_COMMANDS.values()))[0]
    depth = rng.choices((0, 1, 2, 3), (2, 6, 3, 0.3))[0]
    if command in ("factor", "shorten"):
        depth = min(depth, 1)
    if rng.random() < 0.005:
        text = rng.choice(HOSTILE)(rng)
    elif command == "prove":
        text = g.equation(depth)
    elif command in ("factor", "shorten") and rng.random() < 0.9:
        text = g.scalar(depth)
    else:
        text = g.extensor(rng.choices((0, 1, 2, 3), (6, 2, 1, 1))[0] if g.rank > 3 else rng.choice((0, 1)), depth)
    if rng.random() < 0.35:
        text = mutated(rng, text, WORDS)
    argv, seconds = [command], 0.0
    stdin = ""
    if rng.random() < 0.1:
        stdin, text = text, "-"
    argv.append(text.replace("\0", "\x01"))
    argv += space_words(rng, g)
    if (command == "prove" and rng.random() < 0.4) or (command == "rewrite" and rng.random() < 0.2):
        given = g.assumptions()
        argv += ["--given", (mutated(rng, given, WORDS) if rng.random() < 0.3 else given).replace("\0", "")]
    if command == "rewrite":
        argv += [
            "--rules",
            rng.choice(("expansion", "expansion", "exchange", "contract", "sort", "planes", "expansion,cross")),
        ]
    if command in ("factor", "shorten"):
        seconds = rng.choice((0.0, 0.05, 0.2))
        argv += ["--seconds", f"{seconds:g}"]
        if command == "factor" and rng.random() < 0.2:
            argv.append(rng.choice(("--full", "--cofactor")))
    if command == "straighten" and rng.random() < 0.2:
        argv.append("--steps")
    if command != "rewrite" and rng.random() < 0.3:
        argv += ["--limit", str(rng.choice((1, 2, 10, 100, 1000, 20_000)))]
    argv += rng.choice(((), (), (), ("--json",), ("--json",), ("--latex",), ("--ascii",), ("--unicode",)))
    if rng.random() < 0.05:
        argv += ["-o", "out.txt"]
    return Case("expressions", tuple(argv), {}, stdin, seconds)


def space_words(rng: Random, g: Grammar) -> list[str]:
    """Options that declare rank, points and points at infinity; sometimes others than the expression needs."""
    argv: list[str] = []
    rank = g.rank if rng.random() < 0.97 else rng.choice((-1, 0, 1, 2, 3, 4, 5, 8, 9, 100))
    if rank != 4 or rng.random() < 0.1:
        argv += ["--rank", str(rank)]
    if rng.random() < 0.15:
        argv += ["--points", rng.choice((" ", ", ")).join(rng.sample(g.names, rng.randint(1, len(g.names))))]
    if rng.random() < 0.15:
        argv += ["--ideal", " ".join(rng.sample(g.names, rng.randint(1, min(4, len(g.names)))))]
    return argv


def _powers(rng: Random) -> str:
    return " ".join(f"[{''.join(rng.sample(LETTERS, 4))}]**{rng.randint(2, 64)}" for _ in range(rng.randint(1, 40)))


def _repeated(rng: Random) -> str:
    part = rng.choice(("[abcd]", "(ab /\\ cd)", "[abcd]**64 ", "([abcd] + [abce])", "2 ", "[(ab /\\ cde), f, g, h]"))
    return part * rng.choice((10, 100, 1000, 5000))


def _summed(rng: Random) -> str:
    n = rng.choice((10, 100, 500))
    return " + ".join(
        "".join(f"[{''.join(rng.sample(LETTERS, 4))}]" for _ in range(rng.randint(1, 3))) for _ in range(n)
    )


def _nested(rng: Random) -> str:
    form = rng.choice(("({})", "-{}", "[({})a, b, c, d]", "({}**2)", "({} + [abcd])", "(({}) a /\\ bcd)"))
    inner = "[abcd]"
    for _ in range(rng.choice((10, 45, 99, 101, 500))):
        inner = form.replace("{}", inner)
        if len(inner) > 20_000:
            break
    return inner


def _product_of_sums(rng: Random) -> str:
    factors = [
        Grammar(rng, 4, tuple(LETTERS[:12])).sum([f"[{''.join(rng.sample(LETTERS, 4))}]" for _ in range(4)])
        for _ in range(9)
    ]
    return "".join(f"({f})" for f in factors)


HOSTILE = (_powers, _repeated, _summed, _nested, _product_of_sums)
"""Makers of long texts and of short ones that stand for much."""

EXPRESSIONS = Family(
    "expressions",
    "expressions, equations and assumptions for the commands of the algebra",
    expression,
    share=2,
    few=100,
)
