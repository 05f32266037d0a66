"""Scripts and rule files, what is typed at the prompt, and sessions by hand."""

from __future__ import annotations

from random import Random

from ..case import Case
from ..corpus import corpus
from ..grammar import WORDS, Grammar, legs, script
from ..mutating import mutated
from .family import Family

__all__ = ["MANUAL", "PROMPT", "RULES", "SCRIPTS"]


def _script_text(rng: Random) -> str:
    known = corpus("scripts")
    text = rng.choice(known) if rng.random() < 0.15 else script(rng)
    return mutated(rng, text, WORDS) if rng.random() < 0.5 else text


def _form(rng: Random) -> list[str]:
    return list(rng.choice(((), (), ("--json",), ("--ascii",), ("--unicode",))))


def scripts(rng: Random) -> Case:
    text = _script_text(rng)
    limit = ["--limit", str(rng.choice((1, 20, 1000)))] if rng.random() < 0.2 else []
    kind = rng.choices(("file", "stdin", "repl", "load", "two"), (8, 1, 1, 1, 0.5))[0]
    match kind:
        case "stdin":
            return Case("scripts", ("run", "-", *limit, *_form(rng)), stdin=text)
        case "repl":
            return Case("scripts", ("repl", "s.gca", *limit), {"s.gca": text}, mixed=True)
        case "load":
            return Case("scripts", ("repl", "-e", ":load s.gca", "-e", ":context"), {"s.gca": text}, mixed=True)
        case "two":
            files = {"s.gca": text, "t.gca": _script_text(rng)}
            return Case("scripts", ("run", "s.gca", "t.gca", *limit, *_form(rng)), files)
    return Case("scripts", ("run", "s.gca", *limit, *_form(rng)), {"s.gca": text})


def rules(rng: Random) -> Case:
    """Files of rules: checked, listed, shown, and used by other commands."""
    if rng.random() < 0.2:  # all of them hold, and to prove them takes long
        text = rng.choice(corpus("rules")).replace("rule ", "rule my_")
    else:
        g = Grammar.drawn(rng)
        text = (f"rank {g.rank}\n" if rng.random() < 0.5 else "") + "\n".join(
            g.rule() for _ in range(rng.randint(1, 3))
        )
    if rng.random() < 0.6:
        text = mutated(rng, text, WORDS)
    kind = rng.choices(("check", "list", "show", "rewrite", "analyze"), (8, 1, 1, 3, 1))[0]
    argv = {
        "check": ("rules", "check", "m.gca"),
        "list": ("rules", "list", "--rules", "m.gca"),
        "show": ("rules", "show", rng.choice(("r1", "exchange", "four-planes")), "--rules", "m.gca"),
        "rewrite": ("rewrite", Grammar(rng).scalar(1), "--rules", "m.gca"),
        "analyze": ("analyze", legs(rng, number=6), "--search", "0", "--rules", "m.gca"),
    }[kind]
    return Case("rules", (*argv, *_form(rng)), {"m.gca": text}, mixed=kind == "check")


_COLON = (
    *(":help", ":help let", ":help wedge", ":context", ":rules", ":rules r1", ":undo", ":reset", ":quit", ":latex on"),
    *(":latex off", ":latex", ":unicode off", ":unicode", ":limit 5", ":limit 0", ":limit", ":limit x", ":steps"),
    *(
        ":straighten",
        ":expand",
        ":load s.gca",
        ":load",
        ":load nothing.gca",
        ":save kept.gca",
        ":save",
        ":save no/t.gca",
    ),
    *("?", ":", ":x", ":l", ":re", "help", "quit", "%", "%%", "%%%%%", "let q = %", "given % == 0", ": help", ":HELP"),
)


def prompt(rng: Random) -> Case:
    """Inputs of the prompt, piped in or as options."""
    g = Grammar.drawn(rng)
    lines = [f"rank {g.rank}"] if g.rank != 4 else []
    for _ in range(rng.randint(1, 6)):
        kind = rng.choices(("colon", "expression", "equation", "script", "argument", "legs"), (4, 4, 2, 2, 2, 0.4))[0]
        match kind:
            case "colon":
                line = rng.choice(_COLON)
            case "expression":
                line = g.extensor(rng.randint(0, min(2, g.rank - 1)), rng.choice((0, 1, 2)))
            case "equation":
                line = g.equation(1)
            case "script":
                line = script(rng)
            case "argument":
                line = f":{rng.choice(('expand', 'straighten', 'steps', 'latex', 'prove'))} {g.extensor(0, 1)}"
            case _:
                line = f":analyze {legs(rng)}"
        lines.append(mutated(rng, line, WORDS, most=2) if rng.random() < 0.3 else line)
    echo = ("--echo",) if rng.random() < 0.2 else ()
    files = {"s.gca": script(rng)}
    if rng.random() < 0.3:
        evals = tuple(w for line in lines for w in ("-e", line.replace("\0", "")))
        return Case("prompt", ("repl", *echo, *evals), files, mixed=True)
    return Case("prompt", ("repl", *echo), files, "\n".join(lines), mixed=True)


_PROPOSALS = (
    *("order 2 1 3 4 6 5", "order 1 2", "order ab cd", "order", "form 16", "form 24", "form 8", "shortest", "orders"),
    *("plane abc", "plane abd", "plane Aab", "plane", "plane a", "line ab", "line AB", "tetrahedron Aabc", "pair c d"),
    *(
        "lines Cc Dd",
        "lines",
        "pair C c",
        "condition",
        "condition 0",
        "condition [abcd]",
        "hint",
        "auto",
        "undo",
        "redo",
    ),
    *(
        "show",
        "left",
        "history",
        "statement",
        "analysis",
        "help",
        "save kept.yaml",
        "save",
        "save no/t.yaml",
        "quit",
        "x",
    ),
    *("condition abc /\\ aef /\\ bdf /\\ cef", "condition [abce] cofactor [abcd]", "condition E cofactor C", "suggest"),
)


def _session(rng: Random) -> str:
    """A session file: the known one, or one of other legs whose answers may not be those that are found."""
    if rng.random() < 0.3:
        return rng.choice(corpus("sessions"))
    reasons = ("together", "apart", "identity", "rule", "x")
    done = []
    for _ in range(rng.randint(0, 4)):
        answer, reason = rng.choice(("confirmed", "refused")), rng.choice(reasons)
        done.append(f"  - {{do: '{rng.choice(_PROPOSALS)}', answer: {answer}, reason: {reason}}}")
    pairs = [f"[{rng.choice('aceg')}, {rng.choice('bdfh')}]" for _ in range(6)]
    lines = ["gcrules: session", "version: 1", f"legs: [{', '.join(pairs)}]"]
    lines.append(rng.choice(("", "order: [1, 2, 3, 4, 5, 6]", "order: [2, 1]")))
    lines.append(rng.choice(("", "form: 24", "form: 16")))
    return "\n".join([*lines, *(["history:", *done] if done else ["history: []"]), ""])


def manual(rng: Random) -> Case:
    """Proposals and session files."""
    lines = [rng.choice(_PROPOSALS) for _ in range(rng.randint(0, 6))]
    lines = [mutated(rng, line, WORDS, most=1) if rng.random() < 0.2 else line for line in lines]
    form = ("--json",) if rng.random() < 0.3 else ()
    kind = rng.choices(("stdin", "propose", "session"), (3, 2, 4))[0]
    if kind == "session":
        text = _session(rng)
        if rng.random() < 0.6:
            text = mutated(
                rng, text, [*WORDS, *_PROPOSALS, "do", "answer", "confirmed", "refused", "undone", "version"]
            )
        argv = ("analyze", "--session", "session.yaml", *form)
        return Case("manual", argv, {"session.yaml": text}, "\n".join(lines), mixed=True)
    argv = ("analyze", legs(rng), *form)
    if kind == "stdin":
        return Case("manual", (*argv, "--manual"), stdin="\n".join(lines), mixed=True)
    words = tuple(w for line in lines or ["show"] for w in ("--propose", line.replace("\0", "")))
    return Case("manual", (*argv, *words), mixed=True)


SCRIPTS = Family("scripts", "scripts (.gca), for run and the prompt", scripts, share=1.5)
RULES = Family("rules", "rule files: checked, listed, shown and used", rules, few=20)
PROMPT = Family("prompt", "what is typed at the prompt", prompt)
MANUAL = Family("manual", "proposals and session files of the manual mode", manual)
