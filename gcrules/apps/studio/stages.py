"""The guided steps: what each stage of an analysis did, why, and what came of it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.superbrackets.shortest import counts
from gcrules.apps.studio.formulas import pieces
from gcrules.apps.studio.gallery import GROUPS
from gcrules.apps.studio.items import fact, formula, sentence, table
from gcrules.apps.studio.limbs import limb_stages, part_items
from gcrules.apps.studio.protocol.study_views import Item, OrdersItem, Piece, StageView, StepView
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.theory import THEORY, WHY_OF_KINDS
from gcrules.conditions.analysis import Analysis
from gcrules.core.english import in_parts
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.rules.condition import Entity
from gcrules.views.drawing.figures import distinct_entities
from gcrules.views.drawing.scene_parts import entity_label
from gcrules.views.report.dimension_items import condition_beside, dimension_items
from gcrules.views.report.items import Formula, KeyValue
from gcrules.views.report.stage_ids import TITLES
from gcrules.views.report.stages import Recognised, in_every_pose, recognised, structure_items
from gcrules.views.results.robot import in_every_pose as robot_in_every_pose

__all__ = ["stage_views"]

_LONGEST_SUM = 200
"""Terms of a polynomial in a step of a derivation that are shown; a longer one is told by its length."""


def stage_views(subject: Subject) -> list[StageView]:
    """All stages in sequence; a robot of limbs begins with them and with its equivalent lines."""
    found: list[StageView] = []
    if subject.robot is not None:
        found += [stage(key, items) for key, items in limb_stages(subject.robot)]
    if subject.analysis is not None:
        kind = subject.analysis.condition.kind
        found += [stage(key, items, kind) for key, items in _stages(subject.analysis, subject.robot)]
    return found


def stage(key: str, items: Iterable[Item], kind: str = "") -> StageView:
    """A stage with the words that belong to it, where the condition is of that kind."""
    theory = THEORY[key]
    why = WHY_OF_KINDS.get((key, kind), theory.why)
    return {"id": key, "title": TITLES[key], "why": why, "more": list(theory.more), "items": list(items)}


def _stages(a: Analysis, robot: RobotAnalysis | None) -> Iterator[tuple[str, list[Item]]]:
    yield "structure", [_plain(i) for i in structure_items(a)]
    n = len(a.typed.polynomial)
    yield "superbracket", [sentence(f"{_terms(n)} left for the legs in the order typed."), table(a.typed.polynomial)]
    if a.shortest.form:
        yield "shortest", list(_shortest(a))
    found = recognised(a)
    if found is not None:
        yield from _entities(a, found)
    c = a.condition
    left = ex.mul(c.cofactor, a.structure.superbracket)
    parts = part_items(robot) if robot is not None else ()
    yield "condition", [formula(left, c.right_side), *_condition_words(a), *parts]
    others = [r.sentence for r in a.readings if r.statement not in ("", c.statement)]
    found_of = a.dimensions if robot is None else robot.dimensions
    dimensions = map(_plain, dimension_items(found_of) if found_of else ())
    if robot is None:
        stated = [*in_every_pose(a), _in_lines(condition_beside(a.dimensions, c.sentence))]
        yield "statement", [*map(sentence, stated), *(sentence(f"Also: {words}") for words in others), *dimensions]
    else:
        stated = [*robot_in_every_pose(robot), _in_lines(condition_beside(robot.dimensions, robot.statement))]
        yield "statement", [*map(sentence, stated), sentence(f"Of its lines: {c.sentence}"), *dimensions]
    certified = [fact(c.certificate.method, c.certificate.detail)]
    if robot is not None:
        certified.append(fact("the robot", robot.certificate))
        if robot.published is not None:
            p = robot.published
            certified.append(fact("published condition", f"{p.condition}: {p.verdict}, {p.detail}"))
    yield "check", [*certified, *_check(a), *map(sentence, a.notes)]


def _in_lines(words: str) -> str:
    """A long statement with each of its parts on a line of its own."""
    return "\n".join(in_parts(words))


def _plain(item: str | KeyValue | Formula) -> Item:
    if isinstance(item, KeyValue):
        return fact(item.key, item.value)
    return formula(item.left, item.right) if isinstance(item, Formula) else sentence(item)


def _terms(n: int) -> str:
    return "1 term is" if n == 1 else f"{n} terms are"


# --- the shortest form ---------------------------------------------------------------------------------------------


def _shortest(a: Analysis) -> Iterator[Item]:
    n = len(a.shortest.polynomial)
    yield sentence(f"{_terms(n)} left in the {a.shortest.form}-term form with the legs in the best order.")
    if not a.structure.dead:  # the search leaves out vanishing brackets, the tally does not
        yield _orders(a)
    yield table(a.shortest.polynomial, a.shortest.sign)
    if a.typed.polynomial != a.shortest.polynomial:
        yield sentence("Both sums are the same polynomial: they have the same normal form.")


def _orders(a: Analysis) -> OrdersItem:
    """How many of the orders, in both ways of writing, leave how many terms."""
    s = a.structure.lifted
    tally: Counter[int] = Counter()
    for numbers in counts(s.neutral, points=s.points, ideal=s.ideal).values():
        tally.update(numbers)
    return {
        "kind": "orders",
        "tried": tally.total(),
        "counts": [{"terms": t, "orders": tally[t]} for t in sorted(tally)],
        "best": ", ".join(a.structure.words[i] for i in a.shortest.order),
    }


# --- entities ------------------------------------------------------------------------------------------------------


def _entities(a: Analysis, found: Recognised) -> Iterator[tuple[str, list[Item]]]:
    """What was recognised in the terms, kind by kind, with the terms beside it."""
    superbracket = a.structure.superbracket
    rows = table(a.shortest.polynomial, a.shortest.sign)
    yield "tetrahedra", [*_shown(a, found.tetrahedra, "No bracket occurs in every term."), rows]
    yield "planes", [*_shown(a, found.planes, "No three points stay together in every term."), rows]
    items = _shown(a, found.lines, "No two further points stay together in every term.")
    if found.front is not None:
        items += [sentence("With the entities in front:"), formula(superbracket, found.front)]
    yield "lines", [*items, rows]
    if found.left:
        what = "the last plane" if found.left_planes else "lines"
        items = [sentence(f"Left over: {', '.join(found.left)}. They are taken as {what}.")]
        items += _shown(a, [*found.left_planes, *found.left_lines], "")
        yield "left-over", [*items, *(formula(superbracket, e) for e in found.dotted)]


def _shown(a: Analysis, entities: Sequence[Entity], none: str) -> list[Item]:
    """The entities by their ids, those that bear a name of their own (a line of joints) in words."""
    ids = {(e.kind, frozenset(e.points)): f"e{i}" for i, e in enumerate(distinct_entities(a))}
    known = [ids[k] for e in entities if (k := (e.kind, frozenset(e.points))) in ids]
    named = [e for e in entities if (e.kind, frozenset(e.points)) not in ids]
    items: list[Item] = [{"kind": "entities", "entities": list(dict.fromkeys(known))}] if known else []
    items += [sentence(f"The {e.kind} {entity_label(e.starred)}.") for e in named]
    return items or ([sentence(none)] if none else [])


# --- the condition and its proof -----------------------------------------------------------------------------------


def _condition_words(a: Analysis) -> Iterator[Item]:
    c = a.condition
    words = {
        "always-singular": "The superbracket is zero for all positions of the joints: no condition is left.",
        "linear-complex": "No incidence of fewer entities was found; the superbracket itself is the condition.",
    }
    if c.kind in words:
        yield sentence(words[c.kind])
    for name, line in c.lines:
        yield sentence(f"The line {name}:" if name else "The line:")
        yield formula(None, line)
    for e, meaning in a.assumed:
        yield fact("assumed not to vanish", f"{e} ({meaning})" if meaning else e)
    if a.group:
        yield fact("published group", f"{a.group}: {GROUPS[a.group].lower()}")


def _check(a: Analysis) -> Iterator[Item]:
    steps: list[StepView] = [
        {"rule": s.rule, "why": s.why, "before": _short(s.before), "after": _short(s.after)} for s in a.derivation
    ]
    yield sentence("Replayed at exact random points: every step holds.")
    yield {"kind": "steps", "steps": steps}


def _short(e: Expr) -> list[Piece]:
    if isinstance(e, ex.Sum) and len(e.terms) > _LONGEST_SUM:
        return [{"tex": rf"\text{{{len(e.terms)} terms}}", "points": [], "brackets": []}]
    return pieces(e)
