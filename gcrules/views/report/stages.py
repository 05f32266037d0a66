r"""The stages of an analysis as a list of values that text, LaTeX and HTML are made from."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import ONE, Expr, points_of
from gcrules.algebra.language.legs_text import Structure, leg_text
from gcrules.algebra.language.text import text
from gcrules.algebra.scalars import bracket
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.pose_value import PoseValue
from gcrules.core.dataclass import dataclass
from gcrules.core.english import in_parts, listed
from gcrules.core.floats import decimal
from gcrules.rules.condition import Condition, Entity
from gcrules.rules.screw_words import has_screw
from gcrules.screws.verdict import CLOSE
from gcrules.views.formulas.suppositions import supposed
from gcrules.views.report.dimension_items import DIMENSIONS, condition_beside, dimension_items
from gcrules.views.report.items import Formula, Item, KeyValue
from gcrules.views.report.stage_ids import TITLES
from gcrules.views.results.at_infinity import at_infinity
from gcrules.views.results.polynomial import points_shown

__all__ = [
    "Recognised",
    "Stage",
    "in_every_pose",
    "leading_sentences",
    "recognised",
    "stages",
    "structure_items",
    "verdict_of",
]


@dataclass(frozen=True)
class Stage:
    """What is done there and why, and the results; `id` is a key of `TITLES`."""

    id: str
    why: str
    items: tuple[Item, ...]

    @property
    def title(self) -> str:
        """The heading."""
        return TITLES[self.id]


@dataclass(frozen=True)
class Recognised:
    """What was recognised in the terms of the shortest form: entities of each kind, then the points that are left, and
    the plane or the lines that they are taken as. `front` is the sum with the entities in front, None where there are
    none; `dotted` are the sums over the places of the points that are left.
    """

    tetrahedra: tuple[Entity, ...]
    planes: tuple[Entity, ...]
    lines: tuple[Entity, ...]
    front: Expr | None
    left: tuple[str, ...]
    left_planes: tuple[Entity, ...]
    left_lines: tuple[Entity, ...]
    dotted: tuple[Expr, ...]


def stages(a: Analysis) -> list[Stage]:
    """All stages in the sequence of the published procedure."""
    return [Stage(key, why, tuple(items)) for key, why, items in _stages(a)]


def leading_sentences(a: Analysis) -> tuple[str, ...]:
    """What stands first: what is assumed; that the robot is singular in every pose, if it is or nearly so; then the
    condition, in parts where it is long.
    """
    first, *rest = (*in_every_pose(a), *in_parts(condition_beside(a.dimensions, a.condition.sentence)))
    return (f"{supposed(a.structure)} {first}".lstrip(), *rest)


def in_every_pose(a: Analysis) -> tuple[str, ...]:
    """That the robot is singular in every pose, if it is or nearly so."""
    always = a.dimensions.architecture.sentence if a.dimensions else ""
    return tuple(filter(None, [always]))


def _stages(a: Analysis) -> Iterator[tuple[str, str, list[Item]]]:
    s = a.structure
    number = {3: "Three", 6: "Six"}.get(len(s.legs), str(len(s.legs)))
    why = f"{number} legs, each a line between a joint of the base and a joint of the platform."
    if not s.base:
        why = f"{number} legs, each a line between two joints."
    if s.stand_ins:
        why = f"{number} lines, each through two joints or built from points."
    if has_screw(*s.lines):
        why = f"{number} legs: lines, each through two joints or built from points, and screws."
    yield "structure", why, structure_items(a)
    of = "legs'" if has_screw(*s.lines) else "lines'"
    why = f"The determinant of the {number.lower()} {of} Plücker coordinates; "
    why += "the robot is singular exactly when it is zero."
    if a.match is None and not has_screw(*s.lines):
        bodies = f"two rigid bodies joined by {number.lower()} bars"
        why += f" In rigidity theory it is the pure condition of {bodies}."
    if s.dead:
        why += f" Under the assumptions {_brackets(s)} vanish{'es' * (len(s.dead) == 1)}."
    yield (
        "superbracket",
        why,
        [Formula(s.superbracket, a.typed.polynomial.to_expr()), _count(len(a.typed.polynomial))],
    )
    if a.shortest.form:
        order = ", ".join(s.words[i] for i in a.shortest.order)
        shown = f"{a.shortest.form}-term form, legs in the order {order}: {_count(len(a.shortest.polynomial))}."
        yield (
            "shortest",
            "Repeated points make brackets vanish; the number of terms left depends on the order of the legs and the "
            "form.",
            [shown, Formula(s.superbracket, (a.shortest.polynomial * a.shortest.sign).to_expr())],
        )
    found = recognised(a)
    if found is not None:
        yield from _entity_stages(a, found)
    elif a.condition.kind != "always-singular" and s.rank == 4:
        why = "Tetrahedra, planes and lines in the terms that make an incidence equal to the superbracket."
        yield "entities", why, ["none"]
    incidence = _INCIDENCE if a.condition.cofactor == ONE else _WITH_COFACTOR
    yield "condition", _WHY.get(a.condition.kind, incidence), _condition(a.condition, a)
    yield "statement", "", [*in_parts(a.condition.sentence)]
    yield "certificate", "", [a.condition.certificate.detail + ".", *_replay(a), *a.notes]
    if a.dimensions:
        yield "dimensions", DIMENSIONS, dimension_items(a.dimensions)
    if a.pose:
        yield "pose", "Numbers at the coordinates of the file.", _pose(a.pose)
    if a.readings:
        items: list[Item] = []
        for reading in a.readings:
            items += [f"{reading.kind}:", *_condition(reading, a), reading.sentence, f"({reading.certificate.detail})"]
        yield "readings", "Further identities for the same superbracket.", items


_INCIDENCE = "An incidence whose expansion equals the superbracket."
_WITH_COFACTOR = "An incidence whose expansion equals the cofactor times the superbracket."
_WHY = {
    "always-singular": "The superbracket is zero for all positions of the joints.",
    "linear-complex": "No incidence was found; the superbracket itself is the condition.",
    "bracket-factors": "Brackets that divide the superbracket; no incidence was found for what they leave.",
}


def _brackets(s: Structure) -> str:
    shown = [text(bracket(*map(ex.Point, names), rank=s.rank), names=s.names) for names in s.dead]
    return listed(shown) if len(shown) <= _MANY else f"{len(shown)} brackets"


_MANY = 6


def structure_items(a: Analysis) -> list[Item]:
    """The legs, the two bodies, the class, and what is in special position."""
    s = a.structure
    items: list[Item] = [KeyValue("legs", s.text())]
    lettered = points_shown(" ".join((*(n for leg in s.legs for n in leg), *points_of(*s.lines))))
    items += [KeyValue("letters", lettered)] if lettered else []
    if s.base:
        items += [KeyValue("base", " ".join(s.base)), KeyValue("platform", " ".join(s.platform))]
    without = [n for n in s.names if n not in s.sides and any(n in leg for leg in s.legs)]
    if without:
        odd = f"{' '.join(without)} (an odd cycle of legs: base and platform cannot be told apart)"
        items.append(KeyValue("no side", odd))
    turned = [leg_text(typed) for typed, right in zip(s.legs, s.oriented, strict=True) if typed != right]
    if turned:
        said = f"{', '.join(turned)} (read from the other end; the sign accounts for it)"
        items.append(KeyValue("turned round", said))
    items += _position(a)
    if a.match is None:
        return [*items, KeyValue("class", "none of the catalog")]
    mapping = ", ".join(f"{x}→{y}" for x, y in a.match.mapping.items())
    return [*items, KeyValue("class", a.match.entry.title), KeyValue("mapping", mapping)]


def _position(a: Analysis) -> list[Item]:
    """Where the points are in special position."""
    s = a.structure
    items: list[Item] = []
    if s.ideal:
        items.append(KeyValue("at infinity", at_infinity(s.ideal, a.condition, s.names)))
    couples = [word for word, leg in zip(s.words, s.legs, strict=True) if set(leg) <= set(s.ideal)]
    if couples:
        items.append(KeyValue("couples", f"{', '.join(couples)} (lines at infinity: constraint moments)"))
    if s.given:
        items.append(KeyValue("given", ", ".join(map(str, s.given))))
    if a.assumed:
        shown = ", ".join(f"{e} ({meaning})" if meaning else e for e, meaning in a.assumed)
        items.append(KeyValue("assumed", f"not to vanish: {shown}"))
    return items


def recognised(a: Analysis) -> Recognised | None:
    """What the conditions of an analysis were made of; None where no entities were looked for."""
    if a.claim is None:
        return None
    state = a.claim.state
    of = {kind: tuple(e for e in a.entities if e.kind == kind) for kind in ("tetrahedron", "plane", "line")}
    planes, lines = len(state.planes), len(state.lines)
    return Recognised(
        tetrahedra=of["tetrahedron"],
        planes=of["plane"][:planes],
        lines=of["line"][:lines],
        front=ex.signed(state.sign, state.collected()) if planes or lines else None,
        left=tuple(state.named(state.left)) if state.left else (),
        left_planes=of["plane"][planes:],
        left_lines=of["line"][lines:],
        dotted=tuple(step.after for step in a.derivation if step.rule.startswith("left-over")),
    )


def _entity_stages(a: Analysis, found: Recognised) -> Iterator[tuple[str, str, list[Item]]]:
    yield "tetrahedra", "Brackets common to all terms.", [_listed(found.tetrahedra)]
    why = "Triples of points that stay together in one bracket of every term; stars distinguish repeated points."
    yield "planes", why, [_listed(found.planes)]
    items: list[Item] = [_listed(found.lines)]
    if found.front is not None:
        items += ["with the entities in front:", Formula(a.structure.superbracket, found.front)]
    yield "lines", "Pairs of points that stay together in one bracket of every term.", items
    if found.left:
        what = " and ".join(f"the {e.kind} {_starred(e)}" for e in found.left_planes or found.left_lines)
        why = "The points that no plane and no line has taken make the last plane, or lines with P(x,y) + P(y,x) = 0."
        items = [f"{', '.join(found.left)}: taken as {what}"]
        yield "left-over", why, [*items, *(Formula(a.structure.superbracket, e) for e in found.dotted)]


def _listed(entities: Sequence[Entity]) -> str:
    return ", ".join(map(_starred, entities)) or "none"


def _condition(condition: Condition, a: Analysis) -> list[Item]:
    if condition.kind == "linear-complex":  # which is the superbracket itself
        return [Formula(None, a.structure.superbracket)]
    return [Formula(ex.mul(condition.cofactor, a.structure.superbracket), condition.right_side)]


def _replay(a: Analysis) -> list[Item]:
    rules = " → ".join(step.rule for step in a.derivation)
    found: list[Item] = [f"Derivation {rules}: replayed at exact random points, holds."]
    if a.condition.kind != "always-singular":
        found.append(f"Strategy, the rules that could run, in this order: {a.strategy}.")
    return found


def _starred(entity: Entity) -> str:
    spaced = any(len(n.rstrip("*")) > 1 for n in entity.starred)
    return (" " if spaced else "").join(entity.starred)


def verdict_of(pose: PoseValue) -> str:
    """The verdict as a sentence."""
    return _VERDICTS[pose.verdict] if pose.superbracket else "Singular: the superbracket is exactly zero here."


_VERDICTS = {
    "singular": "Singular: the superbracket is zero here within rounding.",
    "close": f"Warning: close to singular (margin below {CLOSE:.2g}).",
    "regular": "Regular: the six legs control the platform here.",
}


def _pose(pose: PoseValue) -> list[Item]:
    unit = f" {pose.unit}⁹" if pose.unit else ""
    items: list[Item] = [verdict_of(pose), KeyValue("superbracket", f"{decimal(pose.superbracket)}{unit}")]
    if pose.cofactor != 1:
        items.append(KeyValue("cofactor", f"{decimal(pose.cofactor)} (where it is 0 the condition says nothing)"))
        items.append(KeyValue("condition", f"{decimal(pose.condition)} (cofactor times superbracket)"))
    items.append(KeyValue("margin", f"{pose.margin:.4g} (dimensionless, 0 singular to 1)"))
    return items


def _count(n: int) -> str:
    return "1 term" if n == 1 else f"{n} terms"
