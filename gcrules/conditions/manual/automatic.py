"""What the automatic procedure makes of the same legs: the forms it chooses, and the claims it finds in a form."""

from __future__ import annotations

from functools import cache, lru_cache

from gcrules.algebra.bracket import Row
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.superbrackets.shortest import SuperbracketForm, shortest_forms
from gcrules.conditions.analysis import Analysis, analyze
from gcrules.core.seeds import remembered
from gcrules.rules.claims import best_first
from gcrules.rules.condition_rule import ConditionClaim, claims
from gcrules.rules.entities import TETRAHEDRA
from gcrules.rules.plugins import load_rules
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.recognition_state import RecognitionState
from gcrules.rules.strategy import MAX_TERMS, Strategy

__all__ = ["automatic", "best_form", "claims_in", "form_showing", "oracle_of", "strategy"]


@cache
def strategy() -> Strategy:
    """The rules of recognition that are known without asking for more."""
    return load_rules(identities=False).strategy()


@remembered(32)
def automatic(structure: Structure) -> Analysis:
    """The automatic analysis, which the hints follow."""
    return analyze(structure, strategy=strategy())


@remembered(32)
def oracle_of(structure: Structure) -> RandomWitness:
    """The exact points on which claims about a structure are tested."""
    return RandomWitness(structure)


@remembered(64)
def claims_in(form: SuperbracketForm, structure: Structure) -> tuple[ConditionClaim, ...]:
    """All claims that hold in a form, those of the first incidence rule first and of each rule the most telling first.

    None are looked for in long forms.
    """
    if len(form.polynomial) > MAX_TERMS:
        return ()
    oracle = oracle_of(structure)
    states = list(TETRAHEDRA.applied(RecognitionState.start(form, structure)))
    found: list[ConditionClaim] = []
    for incidence in strategy().incidences:
        found += best_first(list(claims(incidence, states, oracle)), structure, oracle)
    return tuple(found)


def best_form(structure: Structure) -> SuperbracketForm:
    """The shortest form in which the automatic procedure found its condition, else the first of the shortest ones."""
    claim = automatic(structure).claim
    return claim.state.form if claim else _shortest(structure)[0]


def form_showing(structure: Structure, row: Row) -> SuperbracketForm | None:
    """A shortest form in which this bracket stands in every term."""
    return next((f for f in _shortest(structure) if all(row in m for m in f.polynomial.terms)), None)


@lru_cache(maxsize=32)
def _shortest(structure: Structure) -> tuple[SuperbracketForm, ...]:
    return shortest_forms(structure.neutral, points=structure.points, ideal=structure.ideal)
