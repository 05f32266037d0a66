"""The locus of a robot of joints as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from textwrap import fill

from gcrules.core.english import counted, listed
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.limb_report import LocusPart, RobotLocus, RobotLocusFactor
from gcrules.poses.loci.variables import TRANSLATION
from gcrules.poses.loci.working_modes import Sightings
from gcrules.views.results.locus import ROUNDED_TANGENTS, form_latex
from gcrules.views.results.polynomials import (
    SHOWN,
    degree_text,
    degrees_text,
    factor_text,
    formula,
    irreducible,
    multiple,
    size_text,
)
from gcrules.views.text_tables import WIDTH, table

__all__ = ["account", "as_latex", "as_text", "headline", "numbered", "part_rows"]

_HEAD = (
    "Each polynomial is the product of a factor of the condition over all {modes}. Every singular pose is a zero"
    " of one of them, unless a limb is singular by itself; a zero is singular in one of the working modes, unless"
    " its root is not real there{}."
)
_ALONE = (
    "Each polynomial is a factor of the condition. A pose is singular exactly where one of them is 0, unless a limb"
    " is singular by itself{}."
)
_KEPT = (
    "Each polynomial is a factor of the condition, in the coordinates and in roots whose signs are the working mode. A"
    " pose is singular in a mode exactly where one of them is 0, unless a limb is singular by itself{}."
)
_EXCEPT = ", except where other signs are stated"
_CHOSEN = ", or lines that were chosen for a limb depend on each other"


def as_text(found: RobotLocus, *, unicode: bool = False, digits: int | None = None) -> str:
    """The summary, and polynomials that are short; with decimals of so many `digits`."""
    lines = [fill(headline(found), WIDTH), "", *table(account(found, unicode=unicode))]
    for name, part in numbered(found):
        lines += ["", *table(part_rows(part, name, found, unicode=unicode, digits=digits))]
        lines += [""] if part.form.terms else []
        if part.form.terms:
            lines.append(formula(name, part.form, digits))
    return "\n".join(lines)


def headline(found: RobotLocus) -> str:
    """What the polynomials say."""
    head = _ALONE if not found.roots else _HEAD if found.multiplied else _KEPT
    some = any(part.roots and _others(part, found) for part in found.parts)
    modes = "signs of its roots, which tell working modes apart" if some else "working modes"
    degrees = [f"{name} has {degree_text(part.form)}" for name, part in numbered(found) if not part.vanishes]
    size = f" {listed(degrees)}." if degrees else ""
    said = head.format(_CHOSEN if found.chosen else "", modes=modes) + size
    return f"{said} The turn that is fixed is rounded (see below)." if found.question.rounded else said


def account(found: RobotLocus, *, unicode: bool = False) -> list[tuple[str, str]]:
    """What there is to say of all of them, names with what they say."""
    return list(_rows(found, unicode))


def numbered(found: RobotLocus) -> list[tuple[str, LocusPart]]:
    """The parts with the names of their polynomials."""
    return [("P" if len(found.parts) == 1 else f"P{k}", part) for k, part in enumerate(found.parts, 1)]


def _rows(found: RobotLocus, unicode: bool) -> Iterator[tuple[str, str]]:
    q = found.question
    shift = [n for n in q.free if n in TRANSLATION]
    turn = [n for n in q.free if n not in TRANSLATION]
    parts = [f"{', '.join(shift)}: shift of the centre"] if shift else []
    if turn:
        angles = ", ".join(n.removeprefix("t_") for n in turn)
        parts.append(f"{', '.join(turn)}: tangent{'s' * (len(turn) > 1)} of half of {angles} (infinite for 180 deg)")
    yield "variables", "; ".join(parts)
    if q.fixed:
        yield "fixed", ", ".join(f"{n} = {c}" for n, c in q.fixed.items())
    if q.rounded:
        yield "rounded", ROUNDED_TANGENTS
    yield "centre", f"the platform turns about {', '.join(map(str, found.centre))}"
    for root in found.roots:
        yield "root", f"{root.name} tells apart two places of {root.places}; {root.name}^2 = {_short(root.radicand)}"
        if root.sign and not found.multiplied:
            sign = (" · " if unicode else " * ").join(f"({_short(p)})" for p in root.sign)
            yield "", f"in home's mode its sign is that of {sign}"
    if found.roots and not found.multiplied:
        yield "modes", f"{2 ** len(found.roots)}, a sign for each root; home's are +{_EXCEPT * _signed(found)}"
    c = found.checked
    what = "products over the working modes" if found.multiplied else "polynomials in all working modes"
    again = f"; {what} at {c['norms']} poses, to 40 digits" if found.roots else ""
    yield "checked", f"places against the joints in {c['configurations']} configurations{again}"


_SIGNS = "signs of the roots, home's are +"


def _signed(found: RobotLocus) -> bool:
    """Whether a root has not the sign + all over home's mode."""
    return any(root.sign for root in found.roots)


def _short(form: PolynomialForm) -> str:
    if len(form.terms) <= SHOWN // 4 and form.digits <= SHOWN // 4:
        return str(form)
    return f"one of degree {form.degree} with {len(form.terms)} terms"


def part_rows(
    part: LocusPart, name: str, found: RobotLocus, *, unicode: bool = False, digits: int | None = None
) -> list[tuple[str, str]]:
    """What there is to say of one of them, whose polynomial has this name."""
    return list(_part(part, name, found, unicode, digits))


def _part(
    part: LocusPart, name: str, found: RobotLocus, unicode: bool, digits: int | None
) -> Iterator[tuple[str, str]]:
    times = "·" if unicode else "*"
    yield "factor", f"{part.expression} ({part.kind})" + (f": {part.statement}" if part.statement else "")
    if part.cofactor:
        yield "cofactor", part.cofactor
    if part.vanishes:
        yield name, f"0: it vanishes at each of these poses, in {'some' if found.multiplied else 'every'} working mode"
        return
    multiplied = found.multiplied and part.roots
    count = 2 ** len(part.roots)
    what = "factor / cofactor" if part.cofactor else "factor"
    product = f"product over {count} working modes of the {what}" if multiplied else what
    if multiplied and _others(part, found):
        product = f"product of the {what} over the {count} choices of signs"
    coefficient = multiple(part.coefficient, name, part.form, digits, times)
    below = f" {times} ".join(f"({_short(p)})^{n}" if n > 1 else f"({_short(p)})" for p, n in part.below)
    yield "identity", f"{product} = {coefficient}{f' / ({below})' if below else ''}"
    if found.roots:
        yield "roots", ", ".join(part.roots) or "none"
    yield name, size_text(part.form)
    yield "degrees", degrees_text(part.degrees)
    if part.found is None:
        yield "factors", f"not decided: {part.undecided[0]}; {part.undecided[1]}"
    elif not part.found:
        yield "factors", "none: it vanishes nowhere"
    else:
        single = len(part.found) == 1 and part.found[0].multiplicity == 1
        for f in part.found:
            yield (
                "factors" if f is part.found[0] else "",
                _factor(f, name if single else "", part.roots, _others(part, found), digits),
            )


def _others(part: LocusPart, found: RobotLocus) -> tuple[str, ...]:
    """The roots that are none of the part's: its polynomial is the same for both of their signs."""
    return tuple(root.name for root in found.roots if root.name not in part.roots)


def _factor(f: RobotLocusFactor, alone: str, roots: Sequence[str], others: Sequence[str], digits: int | None) -> str:
    """A factor, and in which modes its zeros are singular; `alone` is the polynomial's name if it has no others."""
    if f.kind == "norm":
        return factor_text(f.form, f.multiplicity, digits, " (never 0)")
    kept = " in these variables" * (f.seen is None and bool(roots))
    what = irreducible(alone, f.form, kept) if alone else factor_text(f.form, f.multiplicity, digits)
    return f"{what}; {_modes(f.seen, roots, others)}" if roots and f.seen is not None else what


def _modes(seen: Sightings, roots: Sequence[str], others: Sequence[str]) -> str:
    """In which modes zeros were met; the roots that are none of the part's had home's signs."""
    if not seen.zeros:
        return "it has no real zeros" if seen.every else "no real zeros were met near home"
    alone = seen.every and seen.zeros == 1
    of = f"its {seen.zeros} real zeros" if seen.every else f"{counted(seen.zeros, 'zero')} met near home"
    every = "its one real zero" if alone else f"all of {of}"
    if not seen.assembled:
        return f"at {every} the robot is not assembled" if alone else f"at none of {of} is the robot assembled"
    signs = f"signs of {listed(roots)}, home's are +; {listed(others)} as at home" if others else ""
    modes = f"{', '.join(seen.modes)} ({signs or _SIGNS})"
    where = every if seen.assembled == seen.zeros else f"{seen.assembled} of {of}"
    return f"at {where} the robot is singular, in the working mode{'s' * (len(seen.modes) > 1)} {modes}"


def as_latex(found: RobotLocus) -> str:
    """The polynomial without dollar signs, several as a product of their forms; long ones are `aligned`."""
    if len(found.parts) == 1:
        return form_latex(found.parts[0].form)
    rows = (f"P_{{{n}}} &= {_inner(part.form)}" for n, part in enumerate(found.parts, 1))
    return "\\begin{aligned}\n" + " \\\\\n".join(rows) + "\n\\end{aligned}"


def _inner(form: PolynomialForm) -> str:
    return form_latex(form)
