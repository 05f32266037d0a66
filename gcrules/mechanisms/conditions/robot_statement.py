r"""What is said of a robot: its factors put together to one sentence."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gcrules.algebra.expr import Expr, Join, Point, points_of
from gcrules.algebra.language.text import text
from gcrules.mechanisms.conditions.common_factor import CommonFactor
from gcrules.mechanisms.conditions.factor_causes import ASIDE, FactorCause
from gcrules.mechanisms.lines.equivalent import FRAME, Equivalent
from gcrules.mechanisms.lines.serial import LimbSingularity
from gcrules.rules.condition import Condition
from gcrules.rules.statement import Statement, listing, say

__all__ = ["only_pulling", "robot_statement"]


def robot_statement(
    structure: Equivalent,
    common: CommonFactor | None,
    condition: Condition,
    cofactors: Sequence[Expr],
    parts: Sequence[FactorCause],
    serial: Sequence[LimbSingularity],
) -> Statement:
    """When and why the robot is singular, and what the derived names in it are."""
    aside = ["outside the singularities of its limbs"] * _some(serial)
    if _chosen(parts) and not structure.redundant:
        aside.append("where the lines that were chosen for a limb do not depend on each other")
    outside = " and ".join(aside)
    if structure.redundant:
        said = _redundant(structure, common, parts, f"{outside}, the" if outside else "the")
    else:
        said = _meaning(structure, condition, cofactors, parts, outside)
    return _with_derived(say("{}{}", said, only_pulling(structure)), structure, parts)


def _chosen(parts: Sequence[FactorCause]) -> bool:
    """Whether a factor vanishes, too, where only the chosen lines depend on each other."""
    return any(p.chosen for p in parts)


def only_pulling(structure: Equivalent) -> str:
    """What is to be said beside the rank where actuators only pull; nothing else."""
    if not any(limb.limb.cable for limb in structure.limbs):
        return ""
    if not structure.redundant:
        return " Its cables only pull, and are too few to balance each other: they need a load, such as its weight."
    return (
        " Its cables only pull: elsewhere they hold the platform where tensions that are all positive balance each"
        " other (wrench closure), which is reported for each pose."
    )


_MARKS: Mapping[str, str] = {
    "actuation": " (actuation singularity)",
    "constraint": " (constraint singularity)",
    "mixed": " (actuation or constraint singularity)",
}
"""What the statement says of kinds of factors. Where all are actuation singularities it says nothing."""


def _some(serial: Sequence[LimbSingularity]) -> bool:
    """Whether limbs are singular by themselves, be it known where or not."""
    return any(s.conditions or s.unexplained for s in serial)


def _meaning(
    structure: Equivalent,
    condition: Condition,
    cofactors: Sequence[Expr],
    parts: Sequence[FactorCause],
    outside: str,
) -> Statement:
    also = ""
    if any(line.limb == FRAME for line in structure.lines or ()):
        also = _CONSTRAINTS_TOO
    elif _may_lose_constraints(structure):
        also = _CONSTRAINTS_MAYBE
    live = _live(parts)
    if live and not cofactors and (any(p.meaning for p in live) or any(p.kind in ASIDE for p in parts)):
        mark = len({p.kind for p in live}) > 1 or live[0].kind == "constraint"
        moving, fixed = ([_clause(p, mark) for p in live if p.of_design is design] for design in (False, True))
        words = _WHEN[bool(moving), bool(fixed)]
        where = f"{outside}, the" if outside else "the"
        said = say(words, where=where, moving=listing(moving, ", or "), fixed=listing(fixed, ", or "))
    elif live:
        said = say("{}{}{}", f"{outside}: " * bool(outside), condition.whose, condition.meaning.of_forces)
    else:
        return say("No singular member of the family was found outside the singularities of its limbs.")
    return say("{}{}", said.capitalised, also)


def _live(parts: Sequence[FactorCause]) -> list[FactorCause]:
    return [p for p in parts if p.kind not in ASIDE and p.same is None]


def _clause(p: FactorCause, mark: bool) -> Statement:
    return say("{}{}", p.meaning or f"{text(p.expression, unicode=True)} = 0", _MARKS.get(p.kind, "") * mark)


_WHEN: Mapping[tuple[bool, bool], str] = {
    (True, False): "{where} robot is singular exactly when {moving}.",
    (True, True): (
        "{where} robot is singular exactly when {moving}. By its design it is singular in every pose if {fixed}; no"
        " motion changes that."
    ),
    (False, True): (
        "{where} robot is singular exactly when {fixed}, and then in every pose: that is a matter of its design, and no"
        " motion changes it."
    ),
}
"""Whether there are factors that change as the robot moves, and factors of the design -> the sentence."""

_CONSTRAINTS_TOO = (
    " This leaves out poses where the constraints of all limbs together lose rank: the robot is singular there as well,"
    " but that takes two conditions or more."
)
_CONSTRAINTS_MAYBE = (
    " This leaves out poses where the constraints of all limbs together lose rank, if there are any: the robot is"
    " singular there as well, but that takes two conditions or more, and such poses are not looked for."
)


def _may_lose_constraints(structure: Equivalent) -> bool:
    """Whether constraints that are there more than once may lose rank together; not where a limb alone has them all, as
    a limb never applies fewer of them, unless it has bodies of its own.
    """
    if not structure.over:
        return False
    independent = sum(limb.constraints for limb in structure.limbs) - structure.over
    whole = (limb.constraints >= independent and not limb.limb.subchains for limb in structure.limbs)
    return not any(whole)


def _redundant(
    structure: Equivalent, common: CommonFactor | None, parts: Sequence[FactorCause], where: str
) -> Statement:
    """Of a robot with more actuators than freedoms: where all wrenches together lose rank."""
    alone = next(
        (limb.limb.name for limb in structure.limbs if len(limb.lines or ()) == len(structure.lines or ())), ""
    )
    if alone:
        return say("{} robot is never singular: {} alone holds the platform.", where, alone).capitalised
    live, held = _live(parts), [p for p in parts if p.kind == "held" and p.meaning and not p.chosen]
    said = say("{} robot is singular exactly when {}", where, _dependent(structure))
    if live:
        apart = ", where the lines that were chosen for a limb do not depend on each other" if _chosen(live) else ""
        words = "{}. One condition suffices for that{}: {}; otherwise it takes two or more"
        said = say(words, said, apart, _either(live))
    elif common is not None:
        said = say("{}, which takes {} at once", said, _conditions(structure))
    said = say("{}: it has {}.", said, _actuators(structure))
    if held:
        said = say("{} Where {}, constraints are lost, and only the actuators hold the platform.", said, _either(held))
    return said.capitalised


def _conditions(structure: Equivalent) -> str:
    """How many conditions it takes for a matrix to lose rank where none suffices: as many as it has rows too many, and
    one, at most; more may be needed where constraints have to be lost too.
    """
    if structure.over:
        return "two conditions or more"
    most = structure.redundant + 1
    return "two conditions" if most == 2 else f"two to {_NUMBERS.get(most, most)} conditions"


_NUMBERS: Mapping[int, str] = {3: "three", 4: "four", 5: "five", 6: "six"}


def _either(parts: Sequence[FactorCause]) -> Statement:
    return listing([_clause(p, mark=False) for p in parts], ", or ")


def _actuators(structure: Equivalent) -> str:
    number = structure.mobility + structure.redundant
    what = "cables" if all(limb.limb.cable for limb in structure.limbs) else "actuators"
    return f"{number} {what} for {structure.mobility} freedoms"


def _dependent(structure: Equivalent) -> Statement:
    """When all wrenches together lose rank: in terms of lines where each limb has one."""
    plane = len(structure.lines or ()) == 3
    if all(len(limb.lines or ()) == 1 for limb in structure.limbs):
        lines = [Join(tuple(map(Point, line.ends))) for limb in structure.limbs for line in limb.lines or ()]
        how = "all meet in one point or are all parallel" if plane else "all belong to one linear complex"
        return say("the lines {} {}", listing(lines), how)
    if plane:
        return say("no wrench of any limb has a moment about one point of the plane, which may be at infinity")
    return say("all wrenches of its limbs belong to one linear complex")


def _with_derived(meaning: Statement, structure: Equivalent, parts: Sequence[FactorCause]) -> Statement:
    """With what the derived directions and points are that it names, or that stand in factors without a meaning."""
    points = meaning.points.union(*(points_of(p.expression) for p in _live(parts) if not p.meaning))
    named = [say("{} is {}", Point(n), what) for n, what in structure.named if n in points]
    return say("{} Here {}.", meaning, listing(named)) if named else meaning
