r"""Analyses of robots as plain text."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator

from gcrules.algebra import expr as ex
from gcrules.algebra.language.text import text
from gcrules.core.english import in_parts, listed
from gcrules.mechanisms.conditions.common_factor import CommonFactor, Subset
from gcrules.mechanisms.conditions.factor_causes import KINDS, FactorCause
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.relations import AXES
from gcrules.mechanisms.lines.serial import LimbCondition, LimbSingularity
from gcrules.mechanisms.lines.wrenches import LimbWrenches, WrenchLine
from gcrules.views.detail import first, is_everything, naming_options
from gcrules.views.report.dimension_items import condition_beside, dimension_lines
from gcrules.views.report.parts import in_shell
from gcrules.views.report.stage_ids import TITLES
from gcrules.views.results.at_infinity import at_infinity
from gcrules.views.results.derivation import ascii_words
from gcrules.views.text_tables import line_width

__all__ = [
    "CONDITION",
    "FACTORS",
    "IN_FULL",
    "LIMBS",
    "LINES",
    "OF_LIMBS",
    "alike",
    "as_text",
    "factor_kind",
    "factor_words",
    "formula",
    "in_every_pose",
    "leading_sentences",
    "sections",
]

LIMBS = "Limbs: wrenches with the actuators locked"
LINES = "Equivalent structure"
CONDITION = "Condition of the lines"
FACTORS = "Its factors for this robot"
OF_LIMBS = "Singularities of the limbs by themselves (of codimension one)"
"""Titles of sections."""


def as_text(a: RobotAnalysis, *, unicode: bool = False) -> str:
    """Limbs, equivalent lines, condition, factors, singularities of limbs, certificate."""
    out = [*(line for sentence in in_shell(leading_sentences(a)) for line in _wrapped(sentence)), "", *_head(a)]
    for number, (title, lines) in enumerate(sections(a, unicode), 1):
        out += ["", f"{number}. {title}"]
        for line in lines:
            out += _wrapped(line, 3)
    return "\n".join(out)


def leading_sentences(a: RobotAnalysis) -> tuple[str, ...]:
    """What stands first: that the robot is singular in every pose, if it is or nearly so, then the condition, in parts
    where it is long.
    """
    return (*in_every_pose(a), *in_parts(condition_beside(a.dimensions, a.statement)))


def in_every_pose(a: RobotAnalysis) -> tuple[str, ...]:
    """That the robot is singular in every pose, if it is or nearly so."""
    always = a.dimensions.architecture.sentence if a.dimensions else ""
    return tuple(filter(None, [always]))


def sections(a: RobotAnalysis, unicode: bool) -> Iterator[tuple[str, list[str]]]:
    """The stages of an analysis: titles, and lines of text."""
    if a.structure.limbs:
        yield LIMBS, [_limb(limb) for limb in a.structure.limbs]
    if a.structure.limbs and any(limb.lines is None for limb in a.structure.limbs):
        none = ["not known: the file has no home configuration"]
        yield "Wrenches at home that are not such lines", [str(one) for one in a.wrenches] or none
    if a.structure.lines is not None:
        yield LINES, [_structure(a)]
    if a.condition is not None and a.lines is not None:
        names = a.lines.structure.names
        sides = ex.mul(a.condition.cofactor, a.lines.structure.superbracket), a.condition.right_side
        yield CONDITION, [" = ".join(text(e, unicode=unicode, names=names) for e in sides)]
        factors = [_part(part, names, unicode) for part in a.parts]
        if a.cofactors:
            left = ", ".join(text(e, unicode=unicode, names=names) for e in a.cofactors)
            factors.append(
                f"{left}: cofactor: where it vanishes, so does the expression, whether or not the robot is singular"
            )
        yield FACTORS, factors
    if (a.structure.over or a.structure.redundant) and a.lines is not None and a.structure.limbs:
        title = f"All {_NUMBERS[a.robot.family.plane]}-subsets of the limbs' lines"
        too_high = ["not compared: they are too many, or have a degree above 63 in the parameters of the family"]
        yield title, _common(a, a.common, unicode) if a.common else too_high
    if a.structure.limbs:
        yield OF_LIMBS, alike(map(_serial, a.limbs))
    if a.dimensions is not None:
        lines = dimension_lines(a.dimensions)
        yield TITLES["dimensions"], lines if unicode else [ascii_words(line) for line in lines]
    sure = [a.certificate]
    if a.published is not None:
        sure.append(f"published condition {a.published.condition}: {a.published.verdict}, {a.published.detail}")
    yield "Certificate", sure


IN_FULL = ", with --full"
"""What the command line says of lines that are left out."""

_NUMBERS = ("six", "three")
_SHOWN = 6  # cofactors that are shown in words


def _common(a: RobotAnalysis, c: CommonFactor, unicode: bool) -> list[str]:
    """What the subsets of the lines have in common, and the cofactors."""
    assert a.lines is not None
    names, redundant = a.lines.structure.names, a.structure.redundant > 0
    mixed = {line.ends for line in a.structure.lines or () if line.role == "both"}
    what = "lines" if redundant or any(not mixed.isdisjoint(one.lines) for one in c.listed) else "constraints"
    word = "cofactor" if c.degree or not redundant else "superbracket"
    together = (
        "the condition is the common factor of their superbrackets"
        if c.degree or not redundant
        else "their superbrackets have no factor in common, so that no single condition makes the robot singular"
    )
    count = "one of them is" if c.independent == 1 else f"{c.independent} of them are"
    out = [
        f"the limbs have {c.lines} different lines, with {c.subsets} such subset{'s' * (c.subsets > 1)}, and {count}"
        f" not zero in the whole family; {together}"
    ]
    if c.independent > 1:
        others = [one for one in c.listed if one.lines != c.chosen.lines]
        left = c.independent - (len(c.listed) - len(others))
        shown = first(others, _SHOWN)
        rows = [(_lines(one), _cofactor(one, word, names, unicode)) for one in shown]
        chosen = f"that were chosen, {_lines(c.chosen)}", _cofactor(c.chosen, word, names, unicode)
        alone = chosen[1] not in {words for _, words in rows}
        rows += [] if alone else [(f"those {chosen[0]}", chosen[1])]
        out += [f"with the {what} {line}" for line in alike(rows, ", or ")]
        if left > len(shown):
            out.append(f"and {left - len(shown)} more{'' if is_everything() else naming_options(IN_FULL)}")
        if alone:
            out.append(f"with the {what} {': '.join(chosen)}")
    return out


def _lines(one: Subset) -> str:
    return " ".join("".join(ends) for ends in one.lines)


def _cofactor(one: Subset, word: str, names: tuple[str, ...], unicode: bool) -> str:
    if not one.degree:
        return "no cofactor"
    these = f"the lines {listed([''.join(ends) for ends in one.lines])} "
    where = f"they {one.statement.removeprefix(these)}" if one.statement.startswith(these) else one.statement
    if isinstance(one.cofactor, ex.Superbracket):  # of the lines that were just named
        return f"zero where {where}"
    shown = f" {text(one.cofactor, unicode=unicode, names=names)}" if one.cofactor else ""
    return f"{word}{shown}" + (f", zero where {where}" if where else "")


def _serial(one: LimbSingularity) -> tuple[str, str]:
    """The limb, and what is said of it."""
    words = "; ".join(map(_place, one.conditions))
    if one.unexplained and not words:
        return one.limb, f"found at {one.unexplained} exact members, by none of the conditions that are tried"
    more = f" ({one.unexplained} members of another kind)" if one.unexplained else ""
    return one.limb, f"{words or 'none found'}{more}"


def alike(rows: Iterable[tuple[str, str]], mark: str = "") -> list[str]:
    """Lines of names and what is said of them; what is said of several, which `mark` keeps apart, stands once.

    >>> alike([("leg 1", "none found"), ("leg 2", "A = B"), ("leg 3", "none found")])
    ['leg 1 and leg 3: none found', 'leg 2: A = B']
    """
    names: dict[str, list[str]] = {}
    for name, words in rows:
        names.setdefault(words, []).append(name)
    return [f"{mark.join(own) if mark else listed(own)}: {words}" for words, own in names.items()]


def _place(c: LimbCondition) -> str:
    said = f"{c.expression} = 0: {c.statement}" if c.expression else c.statement
    return f"{said} ({listed(c.types)})" if c.types else said


def _head(a: RobotAnalysis) -> Iterator[str]:
    yield f"{a.robot.title} ({a.robot.id}){': ' + a.robot.chain if a.robot.limbs else ''}"
    if a.robot.limbs:
        s = a.structure
        more = f", actuators beyond the freedoms {s.redundant}" if s.redundant else ""
        numbers = f"mobility of the platform {s.mobility}, overconstraints {s.overconstraints}"
        yield f"{numbers}, idle freedoms {s.idle}{more}"
    for key, value in (("source", a.robot.source), ("note", a.robot.note)):
        if value:
            yield from _wrapped(f"{key}: {value}")


def _limb(limb: LimbWrenches) -> str:
    what = f"{limb.limb.name} ({limb.limb.chain}): {limb.kind}"
    if limb.lines is None:
        return f"{what}; no lines that can be named span it"
    return f"{what}: {', '.join(map(_line, limb.lines))}"


def _line(line: WrenchLine) -> str:
    word = "couple" if line.couple else "force"
    return f"{word} {''.join(line.ends)}{' (constraint)' if line.role == 'constraint' else ''}"


def _structure(a: RobotAnalysis) -> str:
    words = [f"the lines {' '.join(''.join(leg) for leg in a.structure.legs)}"]
    if a.structure.redundant:
        words[0] += ", chosen among those of all limbs"
    if a.structure.ideal:
        names = a.lines.structure.names if a.lines else ()
        words.append(f"at infinity {at_infinity(a.structure.ideal, a.condition, names, AXES)}")
    words += [f"{n} is {what}" for n, what in a.structure.named]
    return "; ".join(words)


def _part(part: FactorCause, names: tuple[str, ...], unicode: bool) -> str:
    shown = text(part.expression, unicode=unicode, names=names)
    if part.same is not None:
        return f"{shown}: {part.kind}, implies that {text(part.same, unicode=unicode, names=names)} is zero"
    if part.reason and part.kind != "never":
        return f"{shown}: zero where {part.statement}; {part.reason}" if part.statement else f"{shown}: {part.reason}"
    if part.kind == "never":
        return f"{shown}: never for this robot, {part.reason}"
    said = f" zero where {part.statement}" if part.statement else ""
    seen = f" (seen at {part.members - part.chosen} exact members)" if part.members else ""
    chosen = f"; at {part.chosen} others only the chosen lines depend on each other" if part.chosen else ""
    design = f"; {part.remark}" * part.of_design
    return f"{shown}: {factor_kind(part)},{said or ' ' + KINDS[part.kind]}{seen}{chosen}{design}"


def factor_kind(part: FactorCause) -> str:
    """The kind of a factor with its types of singularity: actuation (RO and II)."""
    return f"{part.kind} ({listed(part.types)})" if part.types else part.kind


def _wrapped(words: str, indent: int = 0) -> list[str]:
    first, rest = " " * indent, " " * (indent + 2 * (indent > 0 or words.startswith("- ")))
    return textwrap.wrap(
        words,
        line_width(),
        initial_indent=first,
        subsequent_indent=rest,
        break_long_words=False,
        break_on_hyphens=False,
    )


# --- LaTeX ---


def factor_words(part: FactorCause) -> str:
    """The kind of a factor and when it vanishes."""
    if part.same is not None:
        return f"{part.kind}; implies that {text(part.same, unicode=True)} is zero"
    said = f"zero where {part.statement}" if part.statement else KINDS[part.kind]
    return "; ".join(filter(None, (factor_kind(part), part.reason or said, part.remark)))


def formula(a: RobotAnalysis) -> str | None:
    """The expression of the condition as LaTeX, without dollar signs; None where there are no lines."""
    return a.condition.expression.latex() if a.condition else None
