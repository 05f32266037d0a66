r"""The stages of an analysis as a list that text, LaTeX and HTML are made from."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr, Sum
from gcrules.algebra.text import text
from gcrules.analysis import Analysis
from gcrules.condition import Condition, Entity
from gcrules.render.latex import latex, latex_lines

__all__ = ["Formula", "Item", "Stage", "as_latex", "as_text", "stages"]


@dataclass(frozen=True)
class Formula:
    """left = right, displayed; `left` may be None."""

    left: Expr | None
    right: Expr


Item = str | Formula


@dataclass(frozen=True)
class Stage:
    """A heading, what is done there and why, and the results."""

    title: str
    why: str
    items: tuple[Item, ...]


def stages(a: Analysis) -> list[Stage]:
    """All stages in the sequence of the published procedure."""
    return [Stage(title, why, tuple(items)) for title, why, items in _stages(a)]


def _stages(a: Analysis) -> Iterator[tuple[str, str, list[Item]]]:
    yield "Structure", "Six legs, each a line between a joint of the base and a joint of the platform.", _structure(a)
    yield (
        "Superbracket",
        "The determinant of the six lines' Plücker coordinates; the robot is singular exactly when it is zero.",
        [Formula(a.structure.superbracket, a.typed.polynomial.to_expr()), _count(len(a.typed.polynomial))],
    )
    order = ", ".join(_leg(a.structure.legs[i]) for i in a.shortest.order)
    shown = f"{a.shortest.form}-term form, legs in the order {order}: {_count(len(a.shortest.polynomial))}."
    sign = ex.mul(ex.Number(a.shortest.sign), a.structure.superbracket)
    yield (
        "Shortest form",
        "Repeated points make brackets vanish; the number of terms left depends on the order of the legs and the form.",
        [shown, Formula(sign, a.shortest.polynomial.to_expr())],
    )
    if a.claim is not None:
        yield from _entity_stages(a)
    yield "Condition", "An incidence whose expansion equals the superbracket.", _condition(a.condition, a)
    yield "Statement", "", [a.condition.statement]
    yield "Certificate", "", [a.condition.certificate.detail + ".", *_replay(a), *a.notes]
    if a.readings:
        items: list[Item] = []
        for reading in a.readings:
            items += [f"{reading.kind}:", *_condition(reading, a), reading.statement, f"({reading.certificate.detail})"]
        yield "Other readings", "Further identities for the same superbracket.", items


def _structure(a: Analysis) -> list[Item]:
    s = a.structure
    items: list[Item] = ["legs      " + " ".join(map(_leg, s.legs))]
    if s.base:
        items += ["base      " + " ".join(s.base), "platform  " + " ".join(s.platform)]
    without = [n for n in s.names if n not in s.sides]
    if without:
        items.append(
            "no side   " + " ".join(without) + " (an odd cycle of legs: base and platform cannot be told apart)"
        )
    turned = [_leg(typed) for typed, right in zip(s.legs, s.oriented, strict=True) if typed != right]
    if turned:
        items.append(f"turned    {', '.join(turned)} (written platform first; the sign accounts for it)")
    if a.match:
        entry = a.match.entry
        name = f", {entry.name}" if entry.name else ""
        mapping = ", ".join(f"{x}→{y}" for x, y in a.match.mapping.items())
        items += [f"class     {entry.id}{name}", f"mapping   {mapping}"]
    else:
        items.append("class     none of the catalog")
    return items


def _entity_stages(a: Analysis) -> Iterator[tuple[str, str, list[Item]]]:
    assert a.claim is not None
    state = a.claim.state
    entities = list(a.entities)
    found = {kind: [_starred(e) for e in entities if e.kind == kind] for kind in ("tetrahedron", "plane", "line")}
    planes, more_planes = found["plane"][: len(state.planes)], found["plane"][len(state.planes) :]
    lines, more_lines = found["line"][: len(state.lines)], found["line"][len(state.lines) :]
    yield "Tetrahedra", "Brackets common to all terms.", [", ".join(found["tetrahedron"]) or "none"]
    why = "Triples of points that stay together in one bracket of every term; stars tell repeated points apart."
    yield "Planes", why, [", ".join(planes) or "none"]
    items: list[Item] = [", ".join(lines) or "none"]
    if state.planes or state.lines:
        items += ["with the entities in front:", Formula(None, ex.mul(ex.Number(a.structure.sign), state.collected()))]
    yield "Lines", "Pairs of points that stay together in one bracket of every term.", items
    if state.left:
        left = ", ".join(state.named(state.left))
        what = f"as the plane {more_planes[0]}" if more_planes else f"as the line {' and the line '.join(more_lines)}"
        why = "The points that no plane and no line has taken make the last plane, or lines with P(x,y) + P(y,x) = 0."
        items = [f"{left}: taken {what}"]
        items += [Formula(None, step.after) for step in a.derivation if step.rule == "left-over"]
        yield "Left-over points", why, items


def _condition(condition: Condition, a: Analysis) -> list[Item]:
    left = ex.mul(condition.cofactor, a.structure.superbracket)
    if condition.kind == "always-singular":
        return [Formula(a.structure.superbracket, ex.ZERO)]
    return [Formula(left, condition.right_side)]


def _replay(a: Analysis) -> list[Item]:
    rules = " → ".join(step.rule for step in a.derivation)
    return [f"Derivation {rules}: replayed at exact random points, holds."]


def _starred(entity: Entity) -> str:
    spaced = any(len(n.rstrip("*")) > 1 for n in entity.starred)
    return (" " if spaced else "").join(entity.starred)


def _leg(leg: tuple[str, str]) -> str:
    return text(ex.join(*map(ex.Point, leg)))


def _count(n: int) -> str:
    return "1 term" if n == 1 else f"{n} terms"


# --- plain text ----------------------------------------------------------------------------------------------------

_WIDTH = 100


def as_text(a: Analysis, *, unicode: bool = False) -> str:
    """The stages as plain text; `unicode` writes ∧ ∨ and keeps arrows."""
    lines = []
    for n, stage in enumerate(stages(a), 1):
        lines += [f"{n}. {stage.title}"] + ([f"   {stage.why}"] if stage.why else [])
        for item in stage.items:
            lines += _text_item(item, a, unicode)
        lines.append("")
    out = "\n".join(lines).rstrip() + "\n"
    return out if unicode else out.replace("→", "->").replace("ü", "u").replace("–", "-")


def _text_item(item: Item, a: Analysis, unicode: bool) -> list[str]:
    if isinstance(item, str):
        return _wrapped(item.split(" ") if "  " in item else item.split(), "   ")
    names = a.structure.names
    terms = [text(t, unicode=unicode, names=names) for t in _terms(item.right)]
    pieces = terms[:1] + [f"− {t[1:]}" if t[0] == "−" else f"- {t[1:]}" if t[0] == "-" else f"+ {t}" for t in terms[1:]]
    left = [text(item.left, unicode=unicode, names=names), "="] if item.left is not None else []
    return _wrapped([*left, *pieces], "     ")


def _terms(e: Expr) -> tuple[Expr, ...]:
    return e.terms if isinstance(e, Sum) else (e,)


def _wrapped(words: list[str], indent: str) -> list[str]:
    lines = [indent]
    for word in words:
        if len(lines[-1]) + len(word) > _WIDTH and lines[-1].strip():
            lines.append(indent + "  ")
        lines[-1] += ("" if lines[-1].isspace() else " ") + word
    return lines


# --- LaTeX ---------------------------------------------------------------------------------------------------------


def as_latex(a: Analysis) -> str:
    """A document for the article class with amsmath."""
    body = []
    for stage in stages(a):
        body.append(f"\\section*{{{_escaped(stage.title)}}}")
        if stage.why:
            body.append(_escaped(stage.why) + "\\par")
        for item in stage.items:
            body.append(_escaped(item) + "\\par" if isinstance(item, str) else _latex_formula(item))
    preamble = [
        "\\documentclass{article}",
        "\\usepackage[T1]{fontenc}",
        "\\usepackage[utf8]{inputenc}",
        "\\usepackage{amsmath}",
        "\\allowdisplaybreaks",
        "\\setlength{\\parindent}{0pt}",
    ]
    return "\n".join([*preamble, "\\begin{document}", *body, "\\end{document}", ""])


def _latex_formula(item: Formula) -> str:
    lines = latex_lines(item.right)
    if item.left is not None:
        left = latex(item.left)
        lines = [f"{left} ={{}}& {lines[0].lstrip('&')}", *lines[1:]] if len(lines) == 1 else [f"&{left} = ", *lines]
    return "\\begin{align*}\n" + " \\\\\n".join(lines) + "\n\\end{align*}"


_LATEX = {
    "\\": "\\textbackslash{}",
    "{": "\\{",
    "}": "\\}",
    "_": "\\_",
    "^": "\\^{}",
    "&": "\\&",
    "#": "\\#",
    "%": "\\%",
    "$": "\\$",
    "→": "$\\to$",
    "∧": "$\\wedge$",
    "∨": "$\\vee$",
}


def _escaped(words: str) -> str:
    return "".join(_LATEX.get(c, c) for c in words)
