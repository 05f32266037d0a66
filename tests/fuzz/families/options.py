"""Lists of options: every option of every command with good and bad values, in any sequence."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from random import Random
from typing import Any

from ..case import Case
from ..corpus import corpus
from ..grammar import Grammar, legs
from ..jail import Jail
from ..mutating import NUMBERS, mutated
from ..running import Outcome, run_command
from .family import Family
from .files import pose_words

__all__ = ["OPTIONS"]

_SLOW = {
    ("catalog", "check"),
    ("catalog", "docs"),
    ("catalog", "enumerate"),
    ("robot", "docs"),
    ("robot", "check"),
    ("robot", "list"),
}
_FILES = (
    "p.yaml",
    "r.yaml",
    "s.gca",
    "m.gca",
    "c.yaml",
    "t.csv",
    "empty",
    "no.yaml",
    "folder",
    "folder/x",
    "-",
    "",
    "/dev/null",
)
_NAMES = (
    "out.txt",
    "out",
    "o.svg",
    "o.pdf",
    "o.html",
    ".svg",
    "folder",
    "no/out.txt",
    "-",
    "",
    "o.json",
    "o.csv",
    "\udc80.txt",
    "ü.txt",
    "a b.txt",
    "o.png",
)
_IDS = (
    "3-rps",
    "delta",
    "gough-stewart",
    "3-3.3",
    "6-6",
    "mine-1",
    "four-planes",
    "exchange",
    "octahedral",
    "3-rp",
    "my-robot",
    "x/y",
    "..",
    "",
)

_SECONDS = 240.0  # the aspects of a robot of joints take a minute, which no limit of theirs has to end


def _values(rng: Random) -> dict[str, str]:
    """Values of options by their name; what is not named here gets any word."""
    number, file = rng.choice(NUMBERS), rng.choice(_FILES)
    g = Grammar(rng)
    return {
        "--rank": rng.choice(("2", "3", "4", "5", "8", "9", "0", number)),
        "--points": rng.choice(("a b c d e f", "left right", "a a", number, "A,B")),
        "--ideal": rng.choice(("a b", "i j k", "z", "", "a a")),
        "--given": rng.choice((g.assumptions(), "ideal i j", "x", "")),
        "--limit": rng.choice(("1", "10", "1000", "0", "-1", number)),
        "--seconds": rng.choice(("0", "0.1", "0.2", "-1", "x")),
        "--search": rng.choice(("0", "0.1", "-1", "x")),
        "--order": rng.choice(("2 1 3 4 6 5", "1 2 3 4 5 6", "1", "ab af cb cd ed ef", number)),
        "--propose": rng.choice(("plane abc", "auto", "x", "quit")),
        "--at": pose_words(rng),
        "--about": rng.choice(("origin", "centroid", "1,2,3", "x", number)),
        "--threshold": rng.choice(("1 deg", "5mm", "0.1 rad", "x", number)),
        "--accuracy": rng.choice(("1mm", "0.1", "0", "-1", number)),
        "--actuators": rng.choice(("q1=0.1", "x=1", "", "q1=5deg")),
        "--samples": rng.choice(("2", "5", "0", "x", number if len(number) < 4 else "7")),
        "--over": rng.choice(
            ("x -1:1:3", "y 0:1:2", "z 0:1:2", "x", "x,y", "rx -10:10:3 deg", "translation", "q2 1..2", number)
        ),
        "--certify": rng.choice(("x -1:1", "roll -5..5 deg", "x -1:1:3", "q1 0..1", number)),
        "--cone": rng.choice(("40 deg", "base 30 deg", "a 0.5 rad", "40", number)),
        "--tilt": rng.choice(("20 deg", "0.1 rad", "-3 deg", "x", number)),
        "--resume": rng.choice(("c.json", "p.yaml", "no.json", "")),
        "--held": rng.choice(("q1=1", "q2=0", "q9=1", "x", number)),
        "--fix": rng.choice(("x=0", "e1=0, e2=0", "q=1", "x=", number)),
        "--rotation": rng.choice(("quaternion", "rodrigues", "zyx", "x")),
        "--export": rng.choice(("sympy", "maple", "singular", "x")),
        "--limits": rng.choice(("leg lengths 1..3", "ab 1..3", "x", "legs 0..1e9")),
        "--measure": rng.choice(("value", "margin", "x")),
        "--rules": rng.choice(("m.gca", "expansion", "planes,four-planes", "no.gca", "x", "")),
        "--without": rng.choice(("four-planes", "x", "")),
        "--plugins": rng.choice(("plugins", "folder", "no", "p.yaml", "")),
        "--catalog": rng.choice(("c.yaml", "p.yaml", "no.yaml", "folder")),
        "--session": rng.choice(("kept.yaml", "p.yaml", "no/kept.yaml")),
        "--poses": rng.choice(("t.csv", "p.yaml", "no.csv")),
        "--eval": rng.choice((g.scalar(1), ":help", ":context", "let x = ab", "ab /\\")),
        "--port": "x",
        **dict.fromkeys(("--output", "--figure", "--csv", "--plot", "--out"), rng.choice(_NAMES)),
        "": rng.choice((number, file, "x")),
    }


def _argument(rng: Random, metavar: str) -> str:
    g = Grammar(rng)
    if "LHS" in metavar:
        return g.equation(1)
    if "EXPR" in metavar:
        return rng.choice((g.scalar(1), g.extensor(1, 1), "-", "-[abcd]", ""))
    if "LEGS" in metavar:
        return rng.choice((legs(rng), legs(rng), "p.yaml", "3-rps", "-", "r.yaml"))
    if metavar == "ID":
        return rng.choice(_IDS)
    if "gca" in metavar:
        return rng.choice(("s.gca", "m.gca", "p.yaml", "-", "no.gca"))
    return rng.choice(("p.yaml", "r.yaml", "p.yaml", rng.choice(_FILES), rng.choice(_IDS)))


@cache
def _commands() -> tuple[tuple[tuple[str, ...], Any], ...]:
    """All commands with the words that name them, as click knows them."""
    import click

    from gcrules.apps.cli import cli

    def below(group: click.Group, words: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], Any]]:
        ctx = click.Context(group)
        for name in group.list_commands(ctx):
            command = group.get_command(ctx, name)
            if isinstance(command, click.Group):
                yield from below(command, (*words, name))
            else:
                yield (*words, name), command

    return tuple(below(cli, ()))


def options(rng: Random) -> Case:
    known = _commands()
    weights = [
        0.002 if words in _SLOW else 0.1 if words in (("map",), ("rules", "check")) else 1.0 for words, _ in known
    ]
    words, command = rng.choices(known, weights)[0]
    values = _values(rng)
    argv: list[str] = []
    for p in command.params:
        if p.param_type_name == "argument":
            number = rng.choices((1, 0, 2), (20, 1, 1))[0]
            argv += [_argument(rng, p.metavar or p.name) for _ in range(number)]
    chosen = [p for p in command.params if p.param_type_name == "option"]
    for p in rng.sample(chosen, min(len(chosen), rng.choices((0, 1, 2, 3, 5), (2, 4, 4, 2, 1))[0])):
        name = rng.choice((*p.opts, *p.secondary_opts))
        group = [name] if p.is_flag else [name, values.get(max(p.opts, key=len), values[""])]
        at = rng.randint(0, len(argv))
        if rng.random() < 0.1 and not p.is_flag:
            group = [f"{name}={group[1]}"]
        argv[at:at] = group
    if words[0] in ("factor", "shorten") and "--seconds" not in argv:
        argv += ["--seconds", "0.1"]
    if words[0] in ("analyze", "report") or words == ("robot", "analyze"):
        argv += ["--search", "0"]
    if words == ("pose",) and rng.random() < 0.9:
        argv.append("--no-nearest")
    if rng.random() < 0.15:
        argv = _disturbed(rng, argv)
    if rng.random() < 0.03:
        argv.insert(0, "--help")
    line = tuple(_safe(w) for w in (*words, *argv))
    return Case(
        "options", line, _files(), rng.choice(("", "ab /\\ cde", "ab af cb cd ed ef")), _SECONDS, mixed=_mixed(line)
    )


def _disturbed(rng: Random, argv: list[str]) -> list[str]:
    """Words dropped, doubled, swapped, mistyped."""
    argv = argv or ["x"]
    at = rng.randrange(len(argv))
    kind = rng.choice(("drop", "double", "swap", "mistype", "option"))
    if kind == "drop":
        del argv[at]
    elif kind == "double":
        argv.insert(at, argv[at])
    elif kind == "swap":
        rng.shuffle(argv)
    elif kind == "mistype":
        argv[at] = mutated(rng, argv[at], most=1)
    else:
        argv.insert(at, rng.choice(("--", "--x", "--json=1", "-x", "--unknown-option", "-o", "--output=", "-h", "---")))
    return argv


def _safe(word: str) -> str:
    return word.replace("\0", "\x01")


def _mixed(argv: tuple[str, ...]) -> bool:
    """Whether answers and faults may stand beside each other."""
    return (
        "repl" in argv[:1]
        or "check" in argv[:2]
        or {"--manual", "--propose", "--session"} & {w.split("=")[0] for w in argv} != set()
    )


@cache
def _files() -> dict[str, str]:
    return {
        "p.yaml": corpus("platforms")[0],
        "r.yaml": next(r for r in corpus("robots") if r.startswith("title: 3-RPS")),
        "s.gca": "claim ab /\\ cd == [abcd]\nshow ab /\\ cde\n",
        "m.gca": next(iter(corpus("rules"))),
        "c.yaml": corpus("catalogs")[0],
        "t.csv": "x, y, z\n0, 0, 0\n0, 0, 10\n",
        "empty": "",
        "folder/x": "",
        "plugins/legs/rules.gca": "rule cross: ab /\\ cde => [acde] b - [bcde] a\n",
    }


def run(case: Case, jail: Jail) -> Outcome:
    """As any command line, but nothing is served."""
    if case.argv[:1] != ("studio",):
        return run_command(case, jail)
    from gcrules.apps.studio import serving

    serve = serving.serve
    serving.serve = lambda *args, **kwargs: None
    try:
        return run_command(case, jail)
    finally:
        serving.serve = serve


OPTIONS = Family("options", "options of every command, good and bad, in any sequence", options, run, share=2, few=15)
