"""A locus as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Mapping
from textwrap import fill

from gcrules.core.errors import LimitReached
from gcrules.poses.loci.form import PolynomialForm, joined
from gcrules.poses.loci.report import Locus, LocusFactor
from gcrules.poses.loci.variables import TRANSLATION
from gcrules.views.formulas.latex import latex_name
from gcrules.views.text_tables import WIDTH, table

__all__ = ["SHOWN", "account", "as_latex", "as_text", "counted", "degrees_text", "form_latex", "headline", "size_text"]

SHOWN = 40
"""Polynomials of more terms are not printed with the summary."""

_LINE = 4  # terms in a line of LaTeX


def as_text(found: Locus, *, unicode: bool = False) -> str:
    """The summary, and the polynomial P where it is short."""
    lines = [headline(found), "", *table(account(found, unicode=unicode))]
    if found.vanishes:
        return "\n".join(lines)
    if len(found.form.terms) > SHOWN:
        end = "P is long: --export sympy (or maple, singular), --json or --latex prints it."
    else:
        end = fill(f"P = {found.form}", WIDTH, subsequent_indent="    ", break_long_words=False)
    return "\n".join([*lines, "", end])


def headline(found: Locus) -> str:
    """What the polynomial says, in one sentence."""
    if not found.vanishes:
        return "A pose is singular exactly where the polynomial P is 0."
    what = "each of these poses is singular"
    if found.question.whole:
        what = "every pose is singular, so the robot is architecturally singular"
    return f"The polynomial of the singular poses is 0: {what}."


def account(found: Locus, *, unicode: bool = False) -> list[tuple[str, str]]:
    """What there is to say of it, names with what they say."""
    rows = [("variables", _variables(found)), *_fixed(found), ("centre", _centre(found))]
    if found.vanishes:
        return [*rows, _checked(found)]
    times = "·" if unicode else "*"
    coefficient = f"({found.coefficient}) {times} P" if found.coefficient != 1 else "P"
    norm = f" {times} ".join(f"({n})^3" for n in found.norms)
    return [
        *rows,
        ("identity", f"{norm + f' {times} ' if norm else ''}superbracket = {coefficient}"),
        ("P", size_text(found.form)),
        ("degrees", degrees_text(found.degrees)),
        ("factors", _factors(found)),
        _checked(found),
    ]


def counted(n: int, what: str) -> str:
    return f"{n} {what}{'s' * (n != 1)}"


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
    return [("fixed", ", ".join(parts))] if parts else []


def _centre(found: Locus) -> str:
    c = found.rig.centre
    return f"the platform turns about {', '.join(map(str, c)) if any(c) else 'the origin'}"


def size_text(form: PolynomialForm) -> str:
    """How long a polynomial is."""
    return f"{counted(len(form.terms), 'term')}, coefficients of {counted(form.digits, 'digit')} at most"


def degrees_text(found: Mapping[str, int]) -> str:
    """The degrees of a locus in one line."""
    degrees = dict(found)
    total = degrees.pop("total")
    groups = [f"{degrees.pop(g)} in the {g}" for g in ("translation", "rotation") if g in degrees]
    each = ", ".join(f"{n} {d}" for n, d in degrees.items())
    return f"{total} in all, {' and '.join(groups)}; {each}"


def _factors(found: Locus) -> str:
    try:
        factors = found.factors
    except LimitReached as fault:
        return f"not decided: {fault.message}; {fault.hint}"
    if len(factors) == 1 and factors[0].multiplicity == 1 and factors[0].kind == "condition":
        return "none: P is irreducible over the rationals"
    return "; ".join(map(_factor, factors))


def _factor(f: LocusFactor) -> str:
    long = f"one of degree {f.form.degree} with {len(f.form.terms)} terms"
    what = str(f.form) if len(f.form.terms) <= SHOWN // 4 else long
    meaning = {"norm": " (never 0: it divides the quaternion's |e|^2)", "bracket": f" (of the bracket {f.name})"}
    power = f", to the power {f.multiplicity}" if f.multiplicity > 1 else ""
    return f"{what}{meaning.get(f.kind, '')}{power}"


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
