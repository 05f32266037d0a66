"""What can be typed: the words that begin statements, the commands, the signs with a name. Help and completion read
the same tables.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from gcrules.algebra.discovery.limits import RELATIONS as DISCOVERED
from gcrules.algebra.language.letter_words import CONSTRUCTIONS_OF_LETTERS, RELATIONS_OF_LETTERS
from gcrules.algebra.language.relation_words import INCIDENCES, RELATION_NAMES
from gcrules.algebra.language.relation_words import RELATIONS as METRIC_RELATIONS
from gcrules.algebra.language.words import CONSTRUCTIONS, METRICS, Word
from gcrules.algebra.letters import LETTERS
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.hints import near

__all__ = [
    "COMMANDS",
    "KEYS",
    "OPERATIONS",
    "QUESTIONS",
    "RELATIONS",
    "RULE_WORDS",
    "SHELL",
    "STATEMENTS",
    "SYMBOLS",
    "WORDS",
    "Command",
    "command",
    "meant",
]

SHELL = (
    "aspects", "catalog", "certify", "checkers", "cite", "completion", "export", "free", "locus", "map", "modes",
    "paper", "path", "plan", "pose", "regions", "repl", "report", "robot", "run", "studio",
)  # fmt: skip
"""Commands of the shell that the prompt does not have."""

STATEMENTS: Mapping[str, tuple[str, str]] = {
    "rank": ("rank N", "the rank, before everything else; 4 if left out"),
    "points": ("points NAMES", "long names, and the tableau order"),
    "ideal": ("ideal NAMES", "points at infinity"),
    "isotropic": ("isotropic i j", "in the plane: points at infinity on all circles, for metric words"),
    "orthonormal": ("orthonormal i j k", "in space: directions at right angles, for metric words; in the plane two"),
    "line": ("line NAMES", "letters that stand for lines, each with Plücker coordinates of its own"),
    "plane": ("plane NAMES", "letters that stand for planes"),
    "hyperplane": ("hyperplane NAMES", "letters that stand for hyperplanes, of one step less than the rank"),
    "conic": ("conic NAMES", "in the plane: letters that stand for conics, of which words speak: polar(p, K)"),
    "quadric": ("quadric NAMES", "in space: letters that stand for quadrics, of which words speak: polar(p, Q)"),
    "screw": ("screw NAMES", "in space: letters that stand for screws, wrenches and twists of any pitch"),
    "given": ("given collinear(a, b, c), …", "what is assumed: relations of points, lines and planes, LHS == RHS too"),
    "let": ("let NAME = EXPR", "a name for an expression"),
    "claim": ('claim ["label":] LHS == RHS', "an equation, or a relation, to prove and to save"),
    "show": ("show EXPR", "an expression to expand, and to save"),
    "rule": ('rule ID ["sentence"]: LHS => RHS [if …]', "a rule to prove and to rewrite by"),
    "rewrite": ("rewrite EXPR", "an expression rewritten by the rules so far"),
}
"""How each statement is written and what it is."""

RULE_WORDS = ("if", "source", "fires", "silent")
RELATIONS = (*RELATION_NAMES, "ideal", *METRICS, *LETTERS)


def _words() -> Iterator[Word]:
    """Each word as often as it has a meaning, first without letters for conics and quadrics."""
    for words in (CONSTRUCTIONS, METRIC_RELATIONS):
        yield from words.values()
    for some in (CONSTRUCTIONS_OF_LETTERS, RELATIONS_OF_LETTERS):
        for words in some.values():
            yield from (w for w in words.values() if w.name not in INCIDENCES)


def _described(words: Iterable[Word]) -> Iterator[tuple[str, tuple[str, str]]]:
    found: dict[str, list[Word]] = {}
    for w in words:
        found.setdefault(w.name, []).append(w)
    for name, (first, *others) in found.items():
        yield name, (first.usage, "; ".join((first.meaning, *(f"{w.usage}: {w.meaning}" for w in others))))


WORDS: Mapping[str, tuple[str, str]] = dict(_described(_words()))
"""How each word with arguments is written and what it is, but for the relations of incidence."""


@dataclass(frozen=True, slots=True)
class Command:
    """`takes` says what stands behind the command: an expression, an equation, legs, a file, one of `words`, …"""

    name: str
    usage: str
    help: str
    takes: str = ""
    words: tuple[str, ...] = ()


_SWITCH = ("on", "off")

QUESTIONS = (
    "expand",
    "straighten",
    "steps",
    "factor",
    "factors",
    "shorten",
    "transversals",
    "prove",
    "discover",
    "analyze",
    "latex",
)
"""The commands that ask something of algebra; the others are about the session."""

COMMANDS: Mapping[str, Command] = {
    c.name: c
    for c in (
        Command("help", ":help [TOPIC]", "this list, or more about a statement, a command or a topic", "topic"),
        Command("analyze", ":analyze LEGS", "when and why a robot with six legs is singular", "legs"),
        Command("expand", ":expand [EXPR]", "expand into brackets, as an expression alone does", "expression"),
        Command("straighten", ":straighten [EXPR]", "the normal form of standard tableaux", "expression"),
        Command("steps", ":steps [EXPR]", "straighten a scalar, every single syzygy shown", "expression"),
        Command("factor", ":factor [EXPR]", "one expression of joins and meets that equals a scalar", "expression"),
        Command("factors", ":factors [EXPR]", "the irreducible factors of a scalar, each with a form", "expression"),
        Command("shorten", ":shorten [EXPR]", "the bracket polynomial of a scalar with the fewest terms", "expression"),
        Command("transversals", ":transversals LEGS", "compare the turns about two lines that meet four legs", "legs"),
        Command("prove", ":prove LHS == RHS", "decide an equation or a relation, as one alone does", "equation"),
        Command(
            "discover",
            ":discover [RELATION]",
            "what holds of the points so far, and is not trivial",
            "words",
            DISCOVERED,
        ),
        Command("latex", ":latex [EXPR|on|off]", "LaTeX of an expression, or of all answers", "latex", _SWITCH),
        Command("unicode", ":unicode [on|off]", "Unicode mathematics in answers and while typing", "switch", _SWITCH),
        Command("limit", ":limit [N]", "give up beyond this many terms", "number"),
        Command("seconds", ":seconds [S]", "give up on an input after this time", "number"),
        Command("memory", ":memory [G]", "give up on an input that takes more gigabytes", "number"),
        Command("context", ":context", "what is declared and assumed"),
        Command("rules", ":rules [ID]", "the rules so far", "rule"),
        Command("load", ":load FILE.gca", "run a script; what it declares holds from here on", "file"),
        Command("save", ":save FILE.gca", "write the statements so far as a script", "file"),
        Command("undo", ":undo", "take back the last input that declared or claimed something"),
        Command("reset", ":reset", "forget everything that is declared, assumed and claimed"),
        Command("quit", ":quit", "leave, as Ctrl-D does"),
    )
}

SYMBOLS: Mapping[str, str] = {
    "\\wedge": "∧",
    "\\meet": "∧",
    "\\vee": "∨",
    "\\join": "∨",
    "\\cdot": "·",
    "\\times": "×",
    "\\minus": "−",
    "\\dot": "\u0307",
    "\\dots": "…",
}
"""What Tab makes of a name; `\\dot` puts a dot above the letter before it."""

OPERATIONS: tuple[tuple[str, str], ...] = (
    ("abc", "points side by side: their join"),
    ("a \\/ bc", "join: ∨ \\vee"),
    ("ab /\\ cde", "meet: ∧ ^ \\wedge"),
    ("2 [abcd] * (ab /\\ cd)", "product; a space or nothing between scalars"),
    ("[abcd]**2", "power"),
    ("[abcd], [(ab /\\ cde), f, gh]", "bracket: the determinant of points, or of extensors"),
    ("[[ab, cd, ef, gh, ij, kl]]", "superbracket of six lines"),
    ("[.a d e f][.b g h i]", "dotted points: the signed sum over all ways to share them out"),
    ("midpoint(a, b), foot(c, ab), …", "points, lines and planes that words make; more with :help words"),
    ("LHS == RHS, collinear(a, b, c), …", "an equation or a relation, proved or refuted"),
    ("%, %%, …", "the last result, the one before it, …"),
)

KEYS: tuple[tuple[str, str], ...] = (
    ("Enter", "answer; the next line where something is open (Enter on an empty line answers anyway)"),
    ("Alt-Enter", "the next line"),
    ("Tab", "complete a word, a command, a file; \\wedge becomes ∧"),
    ("Up, Down, Ctrl-R", "earlier inputs"),
    ("Right", "take the suggestion shown in grey"),
    ("Ctrl-C", "stop the computation, or clear the line; what is declared stays"),
    ("Ctrl-X Ctrl-E", "edit the input in $EDITOR"),
    ("Ctrl-D", "leave"),
)


def meant(begun: str, names: Iterable[str] = COMMANDS) -> list[str]:
    """The names that a word may stand for: its own, else those that begin so."""
    names = list(names)
    return [begun] if begun in names else [n for n in names if n.startswith(begun)]


def command(name: str) -> Command:
    """The command of this name or of the one name that begins so. Raises InputError, with a suggestion."""
    found = meant(name) if name else []
    if len(found) == 1:
        return COMMANDS[found[0]]
    if found:
        raise InputError(f"several commands begin like this: {', '.join(f':{n}' for n in found)}")
    hint = near(name, COMMANDS)
    hint = _with_colons(hint) if hint else ":help lists the commands"
    raise InputError(f"there is no command :{name[:40]}", hint=hint)


def _with_colons(hint: str) -> str:
    """ "did you mean load?" with the names as they are typed."""
    return " ".join(f":{w}" if w.rstrip("?") in COMMANDS else w for w in hint.split())
