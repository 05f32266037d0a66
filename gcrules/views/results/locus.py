"""A locus as text and as LaTeX."""

from __future__ import annotations

from gcrules.core.english import as_sentence, listed
from gcrules.core.errors import LimitReached
from gcrules.poses.loci.form import PolynomialForm, joined
from gcrules.poses.loci.report import Locus, LocusFactor
from gcrules.poses.loci.variables import TRANSLATION
from gcrules.screws.pose import AT_ROUNDED, ROUNDED, Pose
from gcrules.screws.pose_text import WrittenTurn
from gcrules.screws.rotations import Quaternion
from gcrules.views.formulas.latex import latex_name
from gcrules.views.results.polynomials import (
    degree_text,
    degrees_text,
    factor_text,
    formula,
    irreducible,
    multiple,
    shortened,
    size_text,
)
from gcrules.views.text_tables import table, wrapped

__all__ = ["ROUNDED_TANGENTS", "account", "as_latex", "as_text", "form_latex", "headline"]

ROUNDED_TANGENTS = (
    "tangents of half the fixed angles are fractions with denominators up to a million, within 1e-12 of the exact ones:"
    " what is exact here holds for these fractions"
)

_LINE = 4  # terms in a line of LaTeX


def as_text(found: Locus, *, unicode: bool = False, digits: int | None = None) -> str:
    """The summary, and the polynomial P where it is short; with decimals of so many `digits`."""
    lines = [*wrapped(headline(found)), "", *table(account(found, unicode=unicode, digits=digits))]
    return "\n".join(lines if found.vanishes else [*lines, "", formula("P", found.form, digits)])


def headline(found: Locus) -> str:
    """What the polynomial says, in one sentence."""
    if not found.vanishes:
        words = f"a pose is singular exactly where the polynomial P, of {degree_text(found.form)}, is 0{_zeros(found)}"
        return as_sentence(AT_ROUNDED * found.question.turn_is_rounded + words)
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
    multiplied = multiple(found.coefficient, "P", found.form, digits, times)
    norm = f" {times} ".join(f"({n})^3" for n in found.norms)
    return [
        *rows,
        ("identity", f"{norm + f' {times} ' if norm else ''}superbracket = {multiplied}"),
        ("P", size_text(found.form)),
        ("degrees", degrees_text(found.degrees)),
        *_factors(found, digits),
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
    parts = [f"{n} = {shortened(c)}" for n, c in q.fixed.items()]
    if q.turn is not None:
        parts.append(_turn(q.turn, q.written) if any(q.turn[1:]) else "no turn")
    fixed = ", ".join(parts)
    if q.turn is None and q.written is not None:
        fixed += f"; from {q.written.words}" + f", {listed(q.rounded)} rounded" * bool(q.rounded)
    rows = [("fixed", fixed)] if parts else []
    if q.turn_is_rounded:
        rows.append(("rounded", ROUNDED_TANGENTS if q.rounded else ROUNDED))
    return rows


def _turn(turn: Quaternion, written: WrittenTurn | None) -> str:
    """A quaternion, of length 1 and rounded where its numbers are long, behind the words that it was given in."""
    numbers = list(map(str, turn))
    rounded = [shortened(c) for c in turn] != numbers
    if rounded:
        numbers = [f"{c:.6g}" for c in Pose(quaternion=turn).unit_quaternion]
    quaternion = f"quaternion {' '.join(numbers)}{', rounded' * rounded}"
    return f"{written.words} ({quaternion})" if written else quaternion


def _centre(found: Locus) -> str:
    c = found.rig.centre
    return f"the platform turns about {', '.join(map(str, c)) if any(c) else 'the origin'}"


def _factors(found: Locus, digits: int | None) -> list[tuple[str, str]]:
    try:
        factors = found.factors
    except LimitReached as fault:
        return [("factors", f"not decided: {fault.message}; {fault.hint}")]
    if len(factors) == 1 and factors[0].multiplicity == 1 and factors[0].kind == "condition":
        return [("factors", irreducible("P", found.form))]
    return [("" if k else "factors", _factor(f, digits)) for k, f in enumerate(factors)]


def _factor(f: LocusFactor, digits: int | None) -> str:
    meaning = {"norm": " (never 0: it divides the quaternion's |e|^2)", "bracket": f" (of the bracket {f.name})"}
    return factor_text(f.form, f.multiplicity, digits, meaning.get(f.kind, ""))


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
