"""What `:help` says; everything is read from the tables."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from gcrules.apps.repl.tables import COMMANDS, KEYS, OPERATIONS, STATEMENTS, SYMBOLS, WORDS
from gcrules.core.errors import InputError
from gcrules.core.hints import near

__all__ = ["TOPICS", "help_text"]

_MORE: Mapping[str, str] = {
    "rank": "rank 3 is the plane. Ranks go from 2 to 8.",
    "points": "Undeclared letters are always points side by side:  points left right top base",
    "given": (
        "given collinear(a, b, c), coplanar(a, b, d, e)\n"
        "given incident(p, abc), concurrent(ab, cd, ef)\n"
        "given [abcd] == 0\n"
        "given isotropic i j, concyclic(a, b, c, d)"
    ),
    "line": (
        "line L M\nIn brackets, meets, given and claim:  [a b L],  L ^ P,  given incident(a, L)\n"
        "L is the join of two points without names; `line` and `plane` before a name are reserved."
    ),
    "conic": (
        "conic K\nLast in words about conics:  polar(p, K),  pole(ab, K),  given incident(a, K), then tangent(a, K)\n"
        "K is the conic through five points without names, and no pair of lines."
    ),
    "quadric": (
        "quadric Q\nLast in words about quadrics:  polar(p, Q),  polar(ab, Q),  pole(abc, Q),  touches(ab, Q),\n"
        "given incident(a, Q), then tangent(a, Q) and second_on_quadric(p, a, Q)\n"
        "Q is any quadric of space, real or not, that is not a cone."
    ),
    "screw": (
        "screw S T\nIn brackets, meets and superbrackets, as lines:  S \\/ ab,  S /\\ T,  [[S, T, ab, cd, ef, gh]]\n"
        "S is a sum of two lines without names. S \\/ ab == 0 says that it is reciprocal to the line ab."
    ),
    "let": "let p = ab /\\ cde",
    "claim": (
        'claim "two forms": ab /\\ cd == [abcd]\nAn equation without `claim` is decided too, but not saved.\n'
        "claim dual([abcd] == 0)   its dual: points and hyperplanes change places, in what is given too"
    ),
    "show": "show ab /\\ cde\nAn expression without `show` is expanded too, but not saved.",
    "rule": (
        'rule meet "a line meets a plane": ab /\\ cde => [acde] b - [bcde] a\n'
        "rule gp: [R... a b][R... c d] => [R... a c][R... b d] - [R... a d][R... b c] if a < c\n"
        "A rule is proved before it is used; one that is refuted is not kept. Clauses: if, source, fires, silent."
    ),
    "analyze": (
        ":analyze ab af cb cd ed ef\n:analyze robot.yaml\n"
        "A leg is a joint of one body and a joint of the other. Afterwards % is the condition."
    ),
    "steps": ":steps [ade][bcf]       in rank 3\nWithout an expression: of the last result.",
    "save": (
        "What was refuted or not decided is left out, and so are expressions and equations without `show` or `claim`."
    ),
    "latex": ":latex ab /\\ cde       as it stands, not expanded\n:latex                 of the last result",
    "undo": "Takes back one input at a time: a statement, a file that was loaded, a reset.",
}


def help_text(topic: str) -> str:
    """The overview, or more about a topic. Raises InputError, with a suggestion, for an unknown topic."""
    name = topic.strip().lstrip(":").lower()
    if not name:
        return _overview()
    if name in TOPICS:
        return TOPICS[name]
    raise InputError(f"no help on {topic[:40]}", hint=near(name, TOPICS) or f"topics: {', '.join(TOPICS)}")


def _overview() -> str:
    return "\n".join(
        [
            "An expression is expanded, an equation LHS == RHS is proved or refuted; % is the last result.",
            "",
            *_table("Statements", STATEMENTS.values()),
            "",
            *_table("Commands", ((c.usage, c.help) for c in COMMANDS.values())),
            "",
            "More: :help expressions, words, keys, symbols, or the name of a statement or command",
        ]
    )


def _table(title: str, rows: Iterable[tuple[str, str]]) -> list[str]:
    rows = list(rows)
    width = max(len(left) for left, _ in rows)
    return [title, *(f"  {left:<{width}}  {right}" for left, right in rows)]


def _about(usage: str, line: str, name: str) -> str:
    return "\n".join([usage, f"  {line}", *(f"  {more}" for more in _MORE.get(name, "").splitlines())])


TOPICS: Mapping[str, str] = {
    "expressions": "\n".join(_table("Expressions, from the tightest operation to the loosest", OPERATIONS)),
    "words": "\n".join(
        [
            *_table("Words with arguments", WORDS.values()),
            "Metric ones need `isotropic i j` in the plane, or orthonormal directions: `orthonormal i j k` in space.",
        ]
    ),
    "keys": "\n".join(_table("Keys", KEYS)),
    "symbols": "\n".join(
        [*_table("Names that Tab turns into a sign", SYMBOLS.items()), "While typing, /\\ becomes ∧ and \\/ becomes ∨."]
    ),
    **{name: _about(usage, line, name) for name, (usage, line) in STATEMENTS.items()},
    **{c.name: _about(c.usage, c.help, c.name) for c in COMMANDS.values()},
}
