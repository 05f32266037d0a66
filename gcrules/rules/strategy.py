r"""Strategies: which rules run, and in what order; and the recognition that follows one."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.space import Space
from gcrules.algebra.superbrackets.shortest import SuperbracketForm
from gcrules.core.arguments import TEXT, instance, listed, read
from gcrules.core.budget import checkpoint
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, LimitReached
from gcrules.rules.condition_rule import ConditionClaim, claims
from gcrules.rules.entities import TETRAHEDRA
from gcrules.rules.identity import Identity, rewritten
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.rule import SHIPPED, ConditionRule, EntityRule, Rule, StructureRule

__all__ = ["CATALOG", "FACTORIZATION", "FORMS", "MAX_TERMS", "SHORTEST", "Strategy", "of_plugins", "recognise"]

MAX_TERMS = 8
"""Entities are looked for in forms with no more terms than this."""


CATALOG = "catalog"
FACTORIZATION = "factorization"
SHORTEST = "shortest-form"
FORMS = {"superbracket": 24, "superbracket-16": 16}
"""Rules that an analysis asks for by name, and the number of terms of both forms of the superbracket."""


_IDS = listed("names of rules", TEXT, alone=True, ordered=False)
_RULES = listed("a sequence of rules", instance("", Rule))


@dataclass(frozen=True)
class Strategy:
    """Rules in the order in which they run; equal strategies have the same rules in the same order.

    Identities rewrite the forms in which nothing was recognised. An incidence rule runs only if all the entity rules
    that it uses are there too.
    """

    rules: tuple[Rule, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "rules", read(_RULES, self.rules, "gc.Strategy: `rules`"))

    @property
    def ids(self) -> tuple[str, ...]:
        return tuple(r.id for r in self.rules)

    @property
    def forms(self) -> tuple[int, ...]:
        """The forms of the superbracket that are looked at; both where a strategy says nothing about them."""
        return tuple(terms for name, terms in FORMS.items() if name in self.ids) or tuple(FORMS.values())

    @property
    def identities(self) -> tuple[Identity, ...]:
        return tuple(r for r in self.rules if isinstance(r, Identity))

    @property
    def incidences(self) -> tuple[ConditionRule, ...]:
        """Those whose entity rules are all there."""
        known = {r.id for r in self.rules if isinstance(r, EntityRule)}
        return tuple(
            r for r in self.rules if isinstance(r, ConditionRule) and all(rule.id in known for rule, _ in r.uses)
        )

    @property
    def structural(self) -> tuple[StructureRule, ...]:
        return tuple(r for r in self.rules if isinstance(r, StructureRule))

    def without(self, ids: Iterable[str]) -> Strategy:
        """The strategy less the rules named. Raises InputError for an id that is not in it."""
        left_out = set(read(_IDS, ids, "the rules to leave out"))
        for name in left_out - set(self.ids):
            raise InputError(f"the rule {name} is not in the strategy", hint=f"it has {', '.join(self.ids)}")
        if left_out.issuperset(FORMS):
            raise InputError("an analysis needs one form of the superbracket", hint="leave out one of them at most")
        return Strategy(tuple(r for r in self.rules if r.id not in left_out))

    def to_json(self) -> list[str]:
        return list(self.ids)

    def __str__(self) -> str:
        return ", ".join(self.ids)


def recognise(
    forms: Sequence[SuperbracketForm], structure: Structure, oracle: RandomWitness, strategy: Strategy
) -> list[ConditionClaim]:
    """All claims that hold for the first incidence rule of the strategy that finds any.

    Rewritten forms are tried where the forms given show nothing.
    """
    short = [RecognitionState.start(form, structure) for form in forms if len(form.polynomial) <= MAX_TERMS]
    return _first(short, oracle, strategy) or _first(_rewritten(forms, structure, strategy), oracle, strategy)


def of_plugins(
    forms: Sequence[SuperbracketForm], structure: Structure, oracle: RandomWitness, strategy: Strategy, found: str
) -> list[list[ConditionClaim]]:
    """The claims of each incidence rule that a plugin brought, the rule that `found` the condition left out."""
    brought = [r for r in strategy.incidences if r.owner != SHIPPED and r.id != found]
    short = (
        [RecognitionState.start(form, structure) for form in forms if len(form.polynomial) <= MAX_TERMS]
        if brought
        else []
    )
    states = _with_tetrahedra(short, strategy)
    return [list(claims(incidence, states, oracle)) for incidence in brought]


def _with_tetrahedra(states: Sequence[RecognitionState], strategy: Strategy) -> list[RecognitionState]:
    if any(r.id == TETRAHEDRA.id for r in strategy.rules):
        return [s for state in states for s in TETRAHEDRA.applied(state)]
    return list(states)


def _first(states: Sequence[RecognitionState], oracle: RandomWitness, strategy: Strategy) -> list[ConditionClaim]:
    states = _with_tetrahedra(states, strategy)
    for incidence in strategy.incidences:
        checkpoint()
        found = list(claims(incidence, states, oracle))
        if found:
            return found
    return []


def _rewritten(forms: Sequence[SuperbracketForm], structure: Structure, strategy: Strategy) -> list[RecognitionState]:
    """The states after each identity in turn."""
    found = []
    space = Space(4, structure.points, structure.ideal)
    for form in forms if strategy.identities else ():
        state = RecognitionState.start(form, structure)
        for identity in strategy.identities:
            try:
                rest = rewritten(state.rest, identity, space)
            except LimitReached:
                continue
            if rest != state.rest and len(rest) <= MAX_TERMS:
                state = replace(state, rest=rest, homes=((),) * len(rest)).after(identity, state)
                found.append(state)
    return found
