r"""The rules that are known: those of the engine, of plugins and of files; clashes of ids name both owners."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from gcrules.core.arguments import TEXT, TEXTS, checked, instance, listed, optional, read
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError
from gcrules.core.hints import near
from gcrules.rules.condition_rule import INCIDENCES
from gcrules.rules.couples import FORCES_AND_COUPLES
from gcrules.rules.elementary import ELEMENTARY
from gcrules.rules.entities import ENTITY_RULES, TETRAHEDRA
from gcrules.rules.rule import SHIPPED, ConditionRule, Rule
from gcrules.rules.strategy import CATALOG, FACTORIZATION, FORMS, SHORTEST, Strategy
from gcrules.rules.transversals import TRANSVERSALS

__all__ = ["ENGINE", "Library"]

_IDS = listed("names of rules", TEXT, alone=True, ordered=False)
_RULES = listed("a sequence of rules", instance("", Rule))


@dataclass(frozen=True)
class Library:
    """Rules with different ids, in the order in which a strategy runs them. Raises InputError where ids clash."""

    rules: tuple[Rule, ...]

    def __post_init__(self) -> None:
        object.__setattr__(self, "rules", read(_RULES, self.rules, "gc.Library: `rules`"))
        known: dict[str, Rule] = {}
        for rule in self.rules:
            other = known.setdefault(rule.id, rule)
            if other is not rule:
                raise InputError(
                    f"two rules are called {rule.id}: one of {other.owner}, one of {rule.owner}",
                    hint="rename one of them, or load only one",
                )

    def __iter__(self) -> Iterator[Rule]:
        return iter(self.rules)

    def __getitem__(self, rule_id: str) -> Rule:
        """Raises InputError, with a suggestion, for an id that is not there."""
        rule_id = read(TEXT, rule_id, "the name of a rule")
        for rule in self.rules:
            if rule.id == rule_id:
                return rule
        hint = near(rule_id, [r.id for r in self.rules])
        raise InputError(f"there is no rule {rule_id}", hint=hint or "gcrules rules list shows them")

    @checked("library.plus", rules=_RULES)
    def plus(self, rules: Iterable[Rule]) -> Library:
        """The library with more rules behind its own; those that nobody brought are the user's. Raises InputError where
        ids clash.
        """
        known = {id(r) for r in self.rules}
        own = (replace(r, outside=True) if r.owner == SHIPPED and id(r) not in known else r for r in rules)
        return Library((*self.rules, *own))

    @checked("library.strategy", ids=optional(TEXTS), without=_IDS)
    def strategy(self, ids: Iterable[str] | None = None, without: Iterable[str] = ()) -> Strategy:
        """The rules named, in that order, each incidence rule bringing the entity rules that it uses.

        By default all rules of recognition, then the identities of the catalog, last factorization; identities run only
        when they are named. The forms of the superbracket and the search for the shortest order always come first.
        Raises InputError for rules that are not there, and where no form of the superbracket is left.
        """
        first = sorted((r for r in self.rules if r.id in _FIRST), key=lambda r: _FIRST.index(r.id))
        last = [self[i] for i in (CATALOG, FACTORIZATION) if i in {r.id for r in self.rules}]
        if ids is None:
            recognising = [r for r in self.rules if r.family != "rewriting"]
            return Strategy((*first, *recognising, *last)).without(without)
        named = [self[i] for i in dict.fromkeys(ids)]
        used = {rule.id for r in named if isinstance(r, ConditionRule) for rule, _ in r.uses}
        if any(isinstance(r, ConditionRule) for r in named):
            used.add(TETRAHEDRA.id)
        brought = [r for r in self.rules if r.id in used and r not in named]
        return Strategy(tuple(dict.fromkeys((*first, *brought, *named)))).without(without)


_FIRST = (*FORMS, SHORTEST)
ENGINE = Library((*ENTITY_RULES, *INCIDENCES, FORCES_AND_COUPLES, TRANSVERSALS, *ELEMENTARY))
