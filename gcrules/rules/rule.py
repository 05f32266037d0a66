r"""Rules: what every rule says about itself, and the four families.

Rewriting rules turn an expression into an equal one: identities written in the language, and the elementary steps.
Entity rules find entities in a bracket form; incidence rules turn entities into a claim, which is proved before it is
used. Structure rules read conditions from the legs and their common joints alone.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from string import Formatter
from typing import Any, ClassVar

from gcrules.algebra.expr import ONE, Expr
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.space import Space
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import EngineFault, InputError
from gcrules.rules.condition import Condition
from gcrules.rules.fields import FIELDS, RESULTS, expression_or_none, is_text
from gcrules.rules.foreign import Guarded, PluginFault, foreign, is_foreign, place_of
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.statement import Statement

__all__ = ["SHIPPED", "ConditionRule", "Elementary", "EntityRule", "RewriteRule", "Rule", "StructureRule", "reductions"]

SHIPPED = "gcrules"
_PARTS = {"tetrahedra", "planes", "lines", "expression"}
_ID = re.compile(r"[A-Za-z][A-Za-z0-9_-]*")


@dataclass(frozen=True, kw_only=True)
class Rule:
    """`id` in lower case with hyphens; `sentence` says what the rule does; `source` is a key of the bibliography.

    `fires` and `silent` are cases (legs for rules of recognition, followed by `ideal` and the points at infinity where
    there are any; expressions for rewriting rules) on which the rule
    fires and on which it stays silent; they are its tests and stand in its documentation. `owner` is who brought the
    rule: gcrules, a package, or a file with line; `outside` is one that did not come with gcrules. Raises InputError
    for an id that is none.
    """

    id: str
    sentence: str
    source: str = "derived here"
    fires: tuple[str, ...] = ()
    silent: tuple[str, ...] = ()
    owner: str = SHIPPED
    outside: bool = False

    family: ClassVar[str] = ""

    @property
    def named_outside(self) -> str:
        """The rule and who brought it, "" where it came with gcrules."""
        if not self.outside:
            return ""
        return f"your own rule {self.id}" if self.owner == SHIPPED else f"{self.owner}, rule {self.id}"

    def __post_init__(self) -> None:
        if not is_text(self.id) or not _ID.fullmatch(self.id):
            raise InputError(f"{self.id!r} cannot be the id of a rule", hint="letters, digits, - and _")
        for name, (holds, kind) in FIELDS.items():
            if hasattr(self, name) and not holds(getattr(self, name)):
                raise InputError(f"{name} of the rule {self.id} is {getattr(self, name)!r:.100}, expected {kind}")
        for (owner, name), check in RESULTS.items():
            if owner == self.family and callable(function := getattr(self, name, None)):
                object.__setattr__(self, name, self._guarded(function, check))

    def _guarded(self, function: Callable[..., Any], check: Callable[[Any], Any]) -> Callable[..., Any]:
        """The function of a plugin, called as such."""
        own = function.function if isinstance(function, Guarded) else function
        if not is_foreign(own):
            return own
        return Guarded(own, check, f"{self.blame}the rule {self.id} fails", place_of(own, self.owner))

    @property
    def blame(self) -> str:
        """Who brought the rule, for messages about it."""
        return "" if self.owner == SHIPPED else f"{self.owner}: "

    def fault(self, wrong: str) -> PluginFault | EngineFault:
        """What to raise where the rule did something `wrong`: the fault is its owner's, or the engine's own."""
        return PluginFault(f"{self.blame}{wrong}", filename=self.owner) if self.foreign else EngineFault(wrong)

    @property
    def foreign(self) -> bool:
        """Whether it runs code that is not the engine's."""
        functions = (getattr(self, name, None) for owner, name in RESULTS if owner == self.family)
        return self.owner != SHIPPED or is_foreign(type(self)) or any(isinstance(f, Guarded) for f in functions)


@dataclass(frozen=True, kw_only=True)
class RewriteRule(Rule):
    """A rule that replaces an expression by an equal one."""

    family: ClassVar[str] = "rewriting"

    def rewrite(self, e: Expr, space: Space) -> Expr | None:
        """The expression after one application of the rule, or None where it stays silent."""
        raise NotImplementedError


def reductions(e: Expr, rules: Sequence[RewriteRule], space: Space) -> Iterator[tuple[RewriteRule, Expr]]:
    """The first rule that fires, with what it makes, and so on from there until all stay silent. It may never end."""
    while True:
        fired = ((rule, after) for rule in rules if (after := _rewritten(rule, e, space)) is not None)
        found = next(fired, None)
        if found is None:
            return
        yield found
        _, e = found


def _rewritten(rule: RewriteRule, e: Expr, space: Space) -> Expr | None:
    if not is_foreign(type(rule)):
        return rule.rewrite(e, space)
    with foreign(f"{rule.blame}the rule {rule.id} fails", rule.owner):  # a kind of rule that a plugin has made
        return expression_or_none(rule.rewrite(e, space))


@dataclass(frozen=True, kw_only=True)
class Elementary(RewriteRule):
    """A step of the algebra itself, given by a function: expansion, sorting, a van der Waerden syzygy, …"""

    apply: Callable[[Expr, Space], Expr | None]

    def rewrite(self, e: Expr, space: Space) -> Expr | None:
        return self.apply(e, space)


@dataclass(frozen=True, kw_only=True)
class EntityRule(Rule):
    """One step of recognition.

    `find(state, number)` yields the states that a state may lead to with that many entities more, most telling first
    (none where the rule stays silent); `after` gives what the superbracket equals then (None where the step rewrites
    nothing), `why` the reason in words.
    """

    family: ClassVar[str] = "entities"

    find: Callable[[RecognitionState, int], Iterator[RecognitionState]]
    after: Callable[[RecognitionState, RandomWitness], Expr | None]
    why: Callable[[RecognitionState], str]

    def applied(self, state: RecognitionState, number: int = 1) -> Iterator[RecognitionState]:
        """The states that the rule leads to, each with the rule on its trail."""
        for found in self.find(state, number):
            yield found.after(self, found)


def _no_cofactor(_: RecognitionState) -> Expr:
    return ONE


@dataclass(frozen=True, kw_only=True)
class ConditionRule(Rule):
    """A kind of condition, named by the rule's id: the entities it needs and the expression it makes of them.

    `uses` lists entity rules with numbers of entities, applied one after the other to a rest of `degree` brackets (any
    if None). The claim is cofactor · superbracket = c · expression for some integer c; no claim is made where
    `expression` gives None. `pencils` gives the lines p and q about which the platform could turn without the two
    lines among the left-over points, for kinds that compare these turns. `statement` is the sentence, for kinds that
    the catalog has none for: a text filled in with {tetrahedra}, {planes}, {lines} and {expression}, or a function of
    the state that gives a `Statement`; `group` is the letter of the group in the published procedure.
    """

    family: ClassVar[str] = "incidence"

    degree: int | None = None
    uses: tuple[tuple[EntityRule, int], ...] = ()
    expression: Callable[[RecognitionState], Expr | None]
    cofactor: Callable[[RecognitionState], Expr] = _no_cofactor
    pencils: Callable[[RecognitionState], tuple[Expr, Expr]] | None = None
    statement: str | Callable[[RecognitionState], Statement] = ""
    group: str | None = None

    def __post_init__(self) -> None:
        Rule.__post_init__(self)
        if isinstance(self.statement, str):
            unknown = {name for _, name, _, _ in Formatter().parse(self.statement) if name} - _PARTS
            if unknown:
                hint = f"it is filled with {', '.join(f'{{{p}}}' for p in sorted(_PARTS))}"
                raise InputError(f"{{{min(unknown)}}} cannot be filled into the statement of {self.id}", hint=hint)

    def meaning(self, state: RecognitionState) -> str | Statement:
        """What it says of a state, or a text to fill in."""
        return self.statement if isinstance(self.statement, str) else self.statement(state)

    def reached(self, state: RecognitionState) -> Iterator[RecognitionState]:
        """The states that the rules it uses lead to, one after the other."""
        if self.degree is None or state.degree == self.degree:
            yield from _reach(self.uses, state)


def _reach(uses: tuple[tuple[EntityRule, int], ...], state: RecognitionState) -> Iterator[RecognitionState]:
    if not uses:
        yield state
        return
    (rule, number), *rest = uses
    for found in rule.applied(state, number):
        yield from _reach(tuple(rest), found)


@dataclass(frozen=True, kw_only=True)
class StructureRule(Rule):
    """A rule that reads conditions from the legs and their common joints alone, not from a bracket form.

    `find` gives conditions that hold on the exact oracle and are not yet proved, the most telling first; none where
    the rule stays silent. A `last_resort` runs only where no condition without a cofactor was found before.
    """

    family: ClassVar[str] = "structure"

    find: Callable[[Structure, RandomWitness], list[Condition]]
    last_resort: bool = False
