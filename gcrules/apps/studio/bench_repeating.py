r"""The lines for the shell and for Python that give one answer of the bench, and nothing else.

>>> from gcrules.apps.repl.state import PromptState
>>> found = answer_lines(Question("factor", "[abcd][efgh]", PromptState()), Rules())
>>> print(found["shell"])
gcrules factor "[abcd][efgh]"
>>> print(found["python"])
import gcrules as gc
<BLANKLINE>
print(gc.factor("[abcd][efgh]"))
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import count

from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.words import METRICS
from gcrules.algebra.letters import LETTERS, declarations
from gcrules.apps.repl.reading import first_word
from gcrules.apps.repl.state import PromptState
from gcrules.apps.studio.bench_questions import Question
from gcrules.apps.studio.calls import Call, Option
from gcrules.apps.studio.protocol.answer_views import Repeated, RepeatedFile, RuleOwner
from gcrules.apps.studio.protocol.requests import RuleFile
from gcrules.apps.studio.rule_files import owners
from gcrules.apps.studio.rule_files_saved import saved, saved_catalogs
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap

__all__ = ["Rules", "answer_lines", "pasted", "prompt_lines"]

LONGEST = 20_000
"""Characters of a line that is given."""


@dataclass(frozen=True)
class Rules:
    """What holds from the start of the bench: `files` of rules and `catalogs` as lines name them, `folders` of plugins,
    and by its id who brought each rule and class.
    """

    files: tuple[RepeatedFile, ...] = ()
    folders: tuple[str, ...] = ()
    brought: Mapping[str, RuleOwner] = FrozenMap()
    catalogs: tuple[RepeatedFile, ...] = ()

    @classmethod
    def of(cls, files: Sequence[RuleFile], folders: Sequence[str] = ()) -> Rules:
        """Those of files that a page has opened, what is switched off in them left out."""
        brought = owners(files) if files else FrozenMap()
        return cls(tuple(saved(files)), tuple(folders), brought, tuple(saved_catalogs(files)))

    @property
    def of_files(self) -> list[Option]:
        names = tuple(file["name"] for file in self.files)
        return [Option("--rules", "", names)] if names else []

    @property
    def of_plugins(self) -> list[Option]:
        return [Option("--plugins", "plugins", self.folders)] if self.folders else []

    @property
    def options(self) -> list[Option]:
        """Those of the prompt."""
        return [*self.of_files, *self.of_plugins, *self.of_catalogs]

    @property
    def of_catalogs(self) -> list[Option]:
        names = tuple(file["name"] for file in self.catalogs)
        return [Option("--catalog", "catalogs", names)] if names else []


_CONTROLS = re.compile(r"[\x00-\x08\x0e-\x1f\x7f-\x9f]")
"""What a terminal may take for a key, where a line is pasted into it."""


def pasted(text: str) -> str:
    """A text without what a terminal may take for a key or for the end of a line; blanks of other kinds are spaces."""
    return _CONTROLS.sub("", re.sub(r"[^\S\n\t ]", " ", text))


def answer_lines(question: Question, rules: Rules, limit: int | None = None) -> Repeated | None:
    """The lines for one question, in `limit` terms where it was given up there; None where they would be too long."""
    question = replace(question, text=pasted(question.text))
    found = _LINES.get(question.function, _prompted)(question, rules)
    if limit is not None and question.function in _LIMITED:
        found = _called(question.function, question, [*_space(question), Option("--limit", "limit", limit)])
    return found if max(len(found["shell"]), len(found["python"])) <= LONGEST else None


# --- what is declared ----------------------------------------------------------------------------------------------


def _space(question: Question) -> list[Option]:
    """The rank, the points with long names, those at infinity and letters; what is assumed, where it is asked under it.

    By what right angles are known is an option of what reads expressions, and an assumption of what reads legs.
    """
    at = question.state.context
    known, of_legs = at.infinity, question.function in ("transversals", "analyze")
    ideal = tuple(n for n in at.ideal if known is None or n not in known.points)
    named = [("points", at.points), ("ideal", ideal)]
    if known is not None and not of_legs:
        named.append((known.kind, known.points))
    named.append(("letters", (", ".join(declarations(at.letters, at.rank, at.screws, at.conics)),)))
    rank = [Option("--rank", "rank", at.rank)] if at.rank != Context().rank else []
    names = [Option(f"--{word}", word, " ".join(names)) for word, names in named if any(names)]
    assumed = tuple(dict.fromkeys([str(known)] * (known is not None and of_legs) + [*map(str, at.given)]))
    given = [Option("--given", "given", assumed)] if assumed else []
    return [*rank, *names, *(given if question.function in _UNDER_ASSUMPTIONS else [])]


_NAMING = ("points", "ideal", *METRICS, *LETTERS)
_UNDER_ASSUMPTIONS = ("prove", "transversals", "rewrite", "analyze")
_LIMITED = ("expand", "straighten", "steps", "prove")


def _declared(state: PromptState, words: Sequence[str]) -> Iterator[str]:
    """What stands before a question: what the bench begins with, and its statements that begin so."""
    written = "\n".join(s for s in state.statements if first_word(s) in _NAMING)
    ranked = [s for s in state.statements if first_word(s) == "rank"]
    yield from ranked
    known = set(written.replace(",", " ").split())
    for word, names in (("points", state.context.points), ("ideal", state.context.ideal)):
        first = [n for n in names if n not in known]
        if first:
            yield f"{word} {' '.join(first)}"
    yield from (s for s in state.statements if first_word(s) in words and first_word(s) != "rank")


# --- calls ---------------------------------------------------------------------------------------------------------


def _called(function: str, question: Question, options: Sequence[Option]) -> Repeated:
    command, extra = ("straighten", [Option("--steps", "", True)]) if function == "steps" else (function, [])
    call = Call(command, "" if extra else function, (*options, *extra))
    return {"shell": call.shell(question.text), "python": call.direct(question.text), "files": []}


def _plain(question: Question, rules: Rules) -> Repeated:
    return _called(question.function, question, _space(question))


def _rewritten(question: Question, rules: Rules) -> Repeated:
    """By the rules of files, then by those of the text, which stand in a file of their own."""
    before = _with_own(question, rules)
    if not before.files:
        return _prompted(question, rules)
    space = _space(question)
    shell = Call("rewrite", "", (*before.of_files, *space)).shell(question.text)
    names = json.dumps([file["name"] for file in before.files])
    call = Call("", "rewrite", tuple(space))
    python = "" if question.state.context.given else call.direct(question.text, names)
    return {"shell": shell, "python": python, "files": list(before.files)}


def _with_own(question: Question, rules: Rules) -> Rules:
    """The rules of the text in a file of their own, with all that they may name."""
    if not any(first_word(s) == "rule" for s in question.state.statements):
        return rules
    lines = _declared(question.state, (*_NAMING, "given", "let", "rule"))
    taken = {file["name"] for file in rules.files}
    name = next(n for number in count() if (n := f"bench-rules{number or ''}.gca") not in taken)
    own: RepeatedFile = {"name": name, "text": "".join(f"{line}\n" for line in lines)}
    return replace(rules, files=(*rules.files, own))


def _analyzed(question: Question, rules: Rules) -> Repeated:
    before = _with_own(question, rules)
    space = [*before.of_catalogs, *_space(question)]
    shell = Call("analyze", "", (*before.of_files, *before.of_plugins, *space)).shell(question.text)
    if not before.files:
        python = Call("", "analyze", (*rules.of_plugins, *space)).direct(question.text)
        return {"shell": shell, "python": python, "files": list(before.catalogs)}
    named = {"files": [file["name"] for file in before.files], "folders": list(before.folders)}
    known = ", ".join(f"{word}={json.dumps(values, ensure_ascii=False)}" for word, values in named.items() if values)
    usual = f"folders={json.dumps(named['folders'], ensure_ascii=False)}" if before.folders else ""
    lines = [
        f"usual = gc.load_rules({usual})",
        f"own = [r for r in gc.load_rules({known}) if r not in usual]",
        "strategy = gc.Strategy((*own, *usual.strategy().rules))",
    ]
    python = Call("", "analyze", (*before.of_plugins, *space)).direct(question.text, "strategy=strategy", before=lines)
    return {"shell": shell, "python": python, "files": [*before.files, *before.catalogs]}


def _discovered(question: Question, rules: Rules) -> Repeated:
    """The script is what is declared, assumed and named."""
    lines = [*_declared(question.state, (*_NAMING, "given", "let"))]
    named = question.text.replace(",", " ").split()
    options = [Option("--relation", "relations", tuple(named))] if named else []
    words = " ".join(["gcrules discover -", *(word for option in options for word in option.words())])
    python = Call("", "discover", tuple(options)).direct("\n".join(lines))
    return {"shell": _given_to(words, lines), "python": python, "files": []}


# --- the prompt ----------------------------------------------------------------------------------------------------


def _prompted(question: Question, rules: Rules) -> Repeated:
    """What only the prompt takes: it is given what is declared, of which it says nothing, and the question."""
    asked = _ASKED.get(question.function, "{}").format(question.text)
    words = [*_NAMING, *(["given"] if question.function == "rule" else [])]
    if question.function == "rule" and any(re.search(rf"\b{n}\b", asked) for n in question.state.context.bound):
        words.append("let")
    lines = [*_declared(question.state, words), *asked.split("\n")]
    return {"shell": prompt_lines(lines), "python": _PYTHON.get(question.function, _none)(question), "files": []}


_ASKED = {"latex": ":latex {}", "rewrite": "rewrite {}"}
"""How the prompt is asked, where the text of the question does not say it."""


def prompt_lines(lines: Sequence[str], rules: Rules | None = None) -> str:
    """The prompt that is given these lines, ended by a word that is none of them: whatever they hold, the shell runs
    nothing of it.
    """
    before = rules or Rules()
    options = "".join(f" {word}" for option in before.options for word in option.words())
    return _given_to(f"gcrules repl{options}", lines)


def _given_to(command: str, lines: Sequence[str]) -> str:
    lines = [pasted(line) for whole in lines for line in whole.split("\n")]
    end = next(word for n in count() if (word := f"END{n or ''}") not in {line.strip() for line in lines})
    return "\n".join([f"{command} <<'{end}'", *lines, end])


def _parsed(question: Question, more: str = "") -> str:
    at = question.state.context
    names = [*at.points, *at.ideal]
    rank = [f"rank={at.rank}"] if at.rank != Context().rank else []
    points = [f"points={json.dumps(names)}"] if names else []
    asked = question.text.partition(" = ")[2] if question.function == "let" else question.text
    arguments = ", ".join([json.dumps(asked, ensure_ascii=False), *rank, *points])
    return f"import gcrules as gc\n\nprint(gc.parse({arguments}){more})"


def _none(question: Question) -> str:
    return ""


_PYTHON: Mapping[str, Callable[[Question], str]] = {
    "let": _parsed,
    "latex": lambda question: _parsed(question, ".latex()"),
}
"""What Python does of it."""

_LINES: Mapping[str, Callable[[Question, Rules], Repeated]] = {
    **dict.fromkeys(("expand", "straighten", "steps", "factor", "factors", "shorten", "prove", "transversals"), _plain),
    "rewrite": _rewritten,
    "analyze": _analyzed,
    "discover": _discovered,
}
"""What writes the lines of each question; the prompt takes all others."""
