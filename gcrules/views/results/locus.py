"""A locus as text and as LaTeX."""

from __future__ import annotations

from gcrules.core.english import as_sentence, listed
from gcrules.core.errors import LimitReached
from gcrules.poses.loci.form import PolynomialForm, joined
from gcrules.poses.loci.report import Locus, LocusFactor
from gcrules.poses.loci.variables import TRANSLATION
from gcrules.screws.pose import AT_ROUNDED, ROUNDED
from gcrules.views.formulas.latex import latex_name
from gcrules.views.results.polynomials import brief, degree_text, degrees_text, formula, number, size_text
from gcrules.views.text_tables import table, wrapped

__all__ = ["account", "as_latex", "as_text", "form_latex", "headline"]

_LINE = 4  # terms in a line of LaTeX


def as_text(found: Locus, *, unicode: bool = False, digits: int | None = None) -> str:
    """The summary, and the polynomial P where it is short; with decimals of so many `digits`."""
    lines = [*wrapped(headline(found)), "", *table(account(found, unicode=unicode, digits=digits))]
    return "\n".join(lines if found.vanishes else [*lines, "", formula("P", found.form, digits)])


def headline(found: Locus) -> str:
    """What the polynomial says, in one sentence."""
    if not found.vanishes:
        words = f"a pose is singular exactly where the polynomial P, of {degree_text(found.form)}, is 0{_zeros(found)}"
        return as_sentence(AT_ROUNDED * found.question.rounded + words)
    what = "each of these poses is singular"
    if found.question.whole:
        what = "every pose is singular, so the robot is architecturally singular"
    return f"The polynomial of the singular poses is 0: {what}."


def _zeros(found: Locus) -> str:
    """Where P is 0, if it has one variable."""
    if len(found.variables) > 1:
        return ""
    (name,) = found.variables
    zeros = listed([f"{zero:.7g}" for zero in found.form.real_zeros])
    unit = f" {found.rig.unit}" if found.rig.unit and name in TRANSLATION else ""
    return f": at {name} = {zeros}{unit}, rounded" if zeros else ", and it has no real zeros"


def account(found: Locus, *, unicode: bool = False, digits: int | None = None) -> list[tuple[str, str]]:
    """What there is to say of it, names with what they say."""
    rows = [("variables", _variables(found)), *_fixed(found), ("centre", _centre(found))]
    if found.vanishes:
        return [*rows, _checked(found)]
    times = "·" if unicode else "*"
    coefficient = f"({number(found.coefficient)}) {times} P" if found.coefficient != 1 else "P"
    norm = f" {times} ".join(f"({n})^3" for n in found.norms)
    return [
        *rows,
        ("identity", f"{norm + f' {times} ' if norm else ''}superbracket = {coefficient}"),
        ("P", size_text(found.form)),
        ("degrees", degrees_text(found.degrees)),
        ("factors", _factors(found, digits)),
        _checked(found),
    ]


def _variables(found: Locus) -> str:
    unit = f" in {found.rig.unit}" if found.rig.unit else ""
    shift = [n for n in found.variables if n in TRANSLATION]
    turn = [n for n in found.variables if n not in TRANSLATION]
    parts = [f"{', '.join(shift)}: the translation{unit}"] if shift else []
    parts += [f"{', '.join(turn)}: {found.question.meaning}"] if turn else []
    return "; ".join(parts)


def _fixed(found: Locus) -> list[tuple[str, str]]:
    q = found.question
    parts = [f"{n} = {c}" for n, c in q.fixed.items()]
    if q.turn is not None:
        parts.append(f"quaternion {' '.join(map(str, q.turn))}" if any(q.turn[1:]) else "no turn")
    rows = [("fixed", ", ".join(parts))] if parts else []
    return [*rows, ("rounded", ROUNDED)] if q.rounded else rows


def _centre(found: Locus) -> str:
    c = found.rig.centre
    return f"the platform turns about {', '.join(map(str, c)) if any(c) else 'the origin'}"


def _factors(found: Locus, digits: int | None) -> str:
    try:
        factors = found.factors
    except LimitReached as fault:
        return f"not decided: {fault.message}; {fault.hint}"
    if len(factors) == 1 and factors[0].multiplicity == 1 and factors[0].kind == "condition":
        return "none: P is irreducible over the rationals"
    return "; ".join(_factor(f, digits) for f in factors)


def _factor(f: LocusFactor, digits: int | None) -> str:
    meaning = {"norm": " (never 0: it divides the quaternion's |e|^2)", "bracket": f" (of the bracket {f.name})"}
    power = f", to the power {f.multiplicity}" if f.multiplicity > 1 else ""
    return f"{brief(f.form, digits)}{meaning.get(f.kind, '')}{power}"


def _checked(found: Locus) -> tuple[str, str]:
    c = found.checked
    return "checked", f"at {c['rational']} exact random poses and {c['modular']} modulo a prime, from the joints alone"


def as_latex(found: Locus) -> str:
    """The polynomial without dollar signs; a long one is `aligned`."""
    return form_latex(found.form)


def form_latex(form: PolynomialForm) -> str:
    """The same for any polynomial."""

    def factor(name: str, n: int) -> str:
        return latex_name(name) if n == 1 else f"{latex_name(name)}^{{{n}}}"

    terms = [
        (c, " ".join(factor(v, n) for v, n in zip(form.variables, e, strict=True) if n), r"\,") for e, c in form.terms
    ]
    if len(terms) <= _LINE:
        return joined(terms)
    lines = [joined(terms[k : k + _LINE], first=not k) for k in range(0, len(terms), _LINE)]
    return "\\begin{aligned}\n&" + " \\\\\n&".join(lines) + "\n\\end{aligned}"
