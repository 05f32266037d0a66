r"""The dimensions of a robot in a section: where its joints are, and what holds of its bodies in every pose."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from gcrules.algebra.expr import ONE, Point
from gcrules.conditions.dimensions.facts import KINDS, Dimensions, Fact, OwnCondition
from gcrules.core.english import listed
from gcrules.views.formulas.latex_text import latex_quantity, latex_ruled, latex_words
from gcrules.views.paper.formulas import breakable, displayed, inline, named_words, sentence
from gcrules.views.paper.subject import Subject
from gcrules.views.report.dimension_items import kept_factors, main_facts

__all__ = ["dimensions", "table"]


def dimensions(s: Subject, slug: str) -> Iterator[str]:
    """What there is to say of them: a table of the joints, one of the facts, and what follows; nothing without."""
    d = s.robot.dimensions if s.robot else s.lines.dimensions if s.lines else None
    home = s.coordinates
    if home:
        caption = f"{latex_words(s.title)}: {_placed(s)} in {s.pose}"
        yield table(caption, f"tab:{slug}-joints", latex_ruled("lrrr", *_coordinates(s)))
    if not home and d is None:
        return
    yield r"\paragraph{Dimensions.}"
    placed = f"Table~\\ref{{tab:{slug}-joints}} lists the {_placed(s)} in {s.pose}."
    yield " ".join([placed] * bool(home) + [*(_architecture(d, s) if d else ())])
    if d is None:
        return
    facts, mirrors = main_facts(d)
    if facts:
        exact = all(fact.exact for fact in facts)
        caption = f"{latex_words(s.title)}: what holds of the bodies{', exactly,' * exact} in every pose"
        head = ("body", "what holds", *("deviation",) * (not exact))
        ruled = latex_ruled(rf"lp{{{0.74 if exact else 0.52}\linewidth}}{'l' * (not exact)}", (head, _facts(facts, s)))
        yield table(caption, f"tab:{slug}-bodies", ruled)
        yield " ".join(_told_of_facts(d, facts, mirrors, slug))
    if d.note:
        yield f"{named_words(d.note[:1].upper() + d.note[1:], s.names)}."
    if d.own is not None:
        yield from _own(d.own, s)


def table(caption: str, label: str, tabular: str) -> str:
    """A table that floats, with its caption above it."""
    lines = [rf"\centering\caption{{{caption}}}\label{{{label}}}", r"\smallskip\small", rf"\gctable{{{tabular}}}"]
    return "\n".join([r"\begin{table}[t]", *lines, r"\end{table}"])


def _placed(s: Subject) -> str:
    return f"joints{' and directions' * bool(s.ideal & {*s.coordinates})}"


def _coordinates(s: Subject) -> Iterator[tuple[Sequence[str], list[tuple[str, ...]]]]:
    """The points, and below them the directions, which have no unit."""
    unit = f" ({latex_words(s.unit)})" if s.unit else ""
    home = s.coordinates
    for kind, shown, names in (
        ("point", unit, [n for n in home if n not in s.ideal]),
        ("direction", "", [n for n in home if n in s.ideal]),
    ):
        if names:
            head = (kind, *(f"${axis}${shown}" for axis in "xyz"))
            yield head, [(_name(n), *map(latex_quantity, home[n])) for n in names]


def _architecture(d: Dimensions, s: Subject) -> Iterator[str]:
    """Whether every pose is singular, and how sure that is."""
    a = d.architecture
    how = f"{a.sure[:1].upper()}{a.sure[1:]}."
    if a.verdict == "regular":
        how = f"Not every pose is singular: {a.sure.removeprefix('proved: ')}."
    elif a.verdict == "open":
        how = f"It is not decided whether every pose is singular: {a.sure}."
    elif not a.singular:
        how = ""  # their sentence says it
    yield from (named_words(words, s.names) for words in (a.sentence, how) if words)
    if a.stress:
        forces = listed([f"{latex_words(leg)} {latex_words(share)}" for leg, share in a.stress])
        yield f"In every pose these forces in the legs balance, for each unit of length of the leg: {forces}."


def _told_of_facts(d: Dimensions, shown: Sequence[Fact], mirrors: int, slug: str) -> Iterator[str]:
    """What stands in the table of facts, and what does not."""
    yield f"Table~\\ref{{tab:{slug}-bodies}} lists what the dimensions say beyond the names of the joints."
    total = len(d.facts) - max(mirrors - 1, 0)
    if mirrors > 1 and shown[-1].kind == "mirror":
        yield f"Of the {mirrors} mirrors that take the base to itself and the platform too it names one."
    if total > len(shown):
        yield f"Of {total} such facts it has the first {len(shown)}."
    if any(not fact.exact for fact in shown):
        yield (
            "The deviation is a distance as a part of the size of the bodies, of lengths as a part of the first of"
            " them, and of directions the sine of an angle."
        )
    if any(not fact.exact for fact in d.facts):
        yield f"No proof rests on what holds nearly, within ${_power(d.tolerance)}$ of the size."


def _power(part: float) -> str:
    """A small number with two digits."""
    return latex_quantity(float(f"{part:.2g}")).strip("$")


def _own(own: OwnCondition, s: Subject) -> Iterator[str]:
    """The condition of this robot, and the factors that keep a value other than 0."""
    under = [*(f"{_name(a)} = {_name(b)}" for a, b in own.names), *map(latex_words, own.given)]
    if under:
        c = own.condition
        yield f"With {listed(under)}: {sentence(c.meaning, [n for n, _ in c.lines], s.names)}"
        yield displayed("", c.expression) + r"\noindent"
        if c.cofactor != ONE:
            yield f"The cofactor is {inline(c.cofactor)}; where it vanishes the condition says nothing."
        yield (
            f"{latex_words(c.certificate.detail[:1].upper() + c.certificate.detail[1:])}; compared with the legs at"
            f" {own.poses} exact random poses of this robot."
        )
    yield from (named_words(words, s.names) for words in kept_factors(own))


# --- a fact as a row -----------------------------------------------------------------------------------------------


_SIGNS: Mapping[str, tuple[str, str]] = {
    "coincident": (" = ", r" \approx "),
    "same axis": (" = ", r" \approx "),
    "lengths": (" = ", r" \approx "),
    "parallel": (r" \parallel ", r" \parallel "),
}
"""The sign that mathematics has for facts whose members are names, exact and nearly."""


def _facts(facts: Sequence[Fact], s: Subject) -> Iterator[tuple[str, ...]]:
    """Whose each is, what holds, and by how much it is missed, where one is."""
    exact = all(fact.exact for fact in facts)
    for fact in facts:
        row = fact.body or "both", rf"\gccell {_said(fact, s.names)}\strut"
        yield row if exact else (*row, "$0$" if fact.exact else rf"$\leq {_power(fact.deviation)}$")


def _said(fact: Fact, names: Sequence[str]) -> str:
    members = [_member(m, names) for m in fact.members]
    if fact.kind in _SIGNS and all(m.startswith("$") for m in members):
        bare = [m.strip("$") for m in members]
        return f"${_SIGNS[fact.kind][not fact.exact].join(f'|{m}|' if fact.kind == 'lengths' else m for m in bare)}$"
    before, after = KINDS[fact.kind].replace(" of the {body}", "").split("{members}")
    said = listed(members) if fact.body else ", ".join(members)
    return f"{before.format(order=fact.order, body=fact.body)}{said}{after}"


def _member(member: str, names: Sequence[str]) -> str:
    """A name, or several side by side, as mathematics; cycles of legs as words."""
    one = "|".join(map(re.escape, sorted(names, key=len, reverse=True)))
    if names and re.fullmatch(f"(?:{one})+", member):
        return f"${''.join(breakable(Point(n)) for n in re.findall(one, member))}$"
    return latex_words(member)


def _name(name: str) -> str:
    return f"${breakable(Point(name))}$"
