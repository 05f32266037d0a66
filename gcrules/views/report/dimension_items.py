"""What the dimensions of a platform say, as items of a stage: facts, its architecture, its own condition."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gcrules.algebra.expr import ONE
from gcrules.algebra.language.text import text
from gcrules.conditions.dimensions.facts import Dimensions, Fact, OwnCondition
from gcrules.core.english import listed
from gcrules.views.detail import first
from gcrules.views.report.items import Formula, Item, KeyValue

__all__ = [
    "DIMENSIONS",
    "DIMENSIONS_OF_ROBOT",
    "condition_beside",
    "dimension_items",
    "dimension_lines",
    "kept_factors",
    "main_facts",
]

DIMENSIONS_OF_ROBOT = "What home says of the bodies beyond the relations of the family; it holds in every pose."
DIMENSIONS = "What the coordinates say beyond the names of the joints; it holds in every pose."

_MANY = 12  # facts that are shown, of a body with many joints on planes


def condition_beside(found: Dimensions | None, condition: str) -> str:
    """The condition of the structure, as it stands beside what the dimensions say."""
    return found.architecture.beside(condition) if found else condition


def dimension_items(d: Dimensions) -> list[Item]:
    """All of it, the architecture first where there is something to say of it."""
    return list(_items(d))


def dimension_lines(d: Dimensions, what: str = DIMENSIONS_OF_ROBOT) -> list[str]:
    """All of it as lines of text, after a sentence on `what` it is, that of robots of joints if no other."""
    words = (f"{item.key}: {item.value}" if isinstance(item, KeyValue) else str(item) for item in _items(d))
    return [what, *words]


def main_facts(d: Dimensions) -> tuple[Sequence[Fact], int]:
    """The facts that are shown, of several mirrors one, and how many mirrors there are."""
    mirrors = [fact for fact in d.facts if fact.kind == "mirror"]
    return first([*(fact for fact in d.facts if fact.kind != "mirror"), *mirrors[:1]], _MANY), len(mirrors)


def _items(d: Dimensions) -> Iterator[Item]:
    if d.architecture.sentence:
        yield d.architecture.sentence
    if d.architecture.stress:
        forces = ", ".join(f"{leg} {share}" for leg, share in d.architecture.stress)
        yield KeyValue("forces", f"{forces} (for each unit of length of the leg, in every pose)")
    yield KeyValue("certificate", f"{d.architecture.sure}.")
    shown, mirrors = main_facts(d)
    several = f"{mirrors} mirrors take the base to itself and the platform too; one of them: " * (mirrors > 1)
    for fact in shown:
        yield KeyValue("fact", f"{several * (fact.kind == 'mirror')}{fact.sentence}")
    left_out = len(d.facts) - max(mirrors - 1, 0) - len(shown)
    if left_out:
        yield f"and {left_out} more"
    if not shown:
        yield "No fact of the bodies was found."
    if any(not fact.exact for fact in d.facts):
        yield KeyValue("tolerance", f"{d.tolerance:g} of the size; no proof rests on what holds nearly")
    if d.note:
        yield KeyValue("condition", d.note)
    if d.own is not None:
        yield from _own(d.own)


def _own(own: OwnCondition) -> Iterator[Item]:
    under = [*(f"{a} = {b}" for a, b in own.names), *own.given]
    if under:
        yield f"With {listed(under)}: {own.condition.statement}"
        yield KeyValue("legs", own.legs)
        yield Formula(None, own.condition.expression)
        if own.condition.cofactor != ONE:
            yield KeyValue("cofactor", f"{text(own.condition.cofactor)} (where it is 0 the condition says nothing)")
        same = f"compared with the legs at {own.poses} exact random poses of this robot"
        yield KeyValue("proof", f"{own.condition.certificate.detail}; {same}")
    yield from kept_factors(own)


def kept_factors(own: OwnCondition) -> Iterator[str]:
    """Which factors keep a value other than 0, and which are left; nothing where that is not known."""
    if own.fixed and own.free:
        what, keeps = ("factor", "keeps") if len(own.fixed) == 1 else ("factors", "keep")
        free = own.free[0] if len(own.free) == 1 else f"one of {listed(own.free)}"
        yield (
            f"The {what} {listed(own.fixed)} {keeps} a value other than 0 in every pose; what can still vanish is"
            f" {free}."
        )
