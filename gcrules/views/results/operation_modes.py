"""The operation modes of a robot as text and as LaTeX."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from gcrules.core.english import counted, listed
from gcrules.core.linear_algebra import content
from gcrules.poses.operation_modes.limb_constraints import DEGREE, FRESH, Equation
from gcrules.poses.operation_modes.report import OperationMode, OperationModes, terms_of
from gcrules.views.detail import first, is_everything, naming_options
from gcrules.views.formulas.latex_text import latex_table, latex_words
from gcrules.views.results.result_account import Facts, ResultAccount
from gcrules.views.text_tables import table, wrapped

__all__ = ["account", "as_latex", "as_text"]

_NAMES = tuple(f"{c}{n}" for c in "xy" for n in range(4))
_SHOWN = 6
_LONG = 6  # terms


def as_text(found: OperationModes, *, unicode: bool = False) -> str:
    """A table for each mode, where they meet, and how sure all this is."""
    lines = wrapped(_verdict(found))
    for block in _blocks(found, unicode):
        lines += ["", *table(block.rows)]
    return "\n".join(lines if unicode else [line.translate(_ASCII) for line in lines])


def account(found: OperationModes) -> ResultAccount:
    """What there is to say of them."""
    return ResultAccount(_verdict(found), tuple(_blocks(found, True)))


def _verdict(found: OperationModes) -> str:
    alike: dict[str, list[str]] = {}
    for m in found.modes:
        alike.setdefault(f"of dimension {m.dimension}: {m.motion}", []).append(str(m.number))
    modes = [f"Mode{'s' * (len(n) > 1)} {listed(n)}, {words}." for words, n in alike.items()]
    count = counted(len(found.modes), "operation mode")
    return " ".join([f"{found.robot.title} ({found.robot.id}): {count}.", *modes, _others(found)])


def _others(found: OperationModes) -> str:
    """Whether these are all, as far as it is known."""
    if found.complete:
        parts = "" if found.proved else " Open: whether each is one mode by itself."
        return f"There is no other of dimension {found.least} or more.{parts}"
    return "There may be others." if found.complete is None else "There are others: random assemblies show them."


def _blocks(found: OperationModes, unicode: bool) -> Iterator[Facts]:
    for m in found.modes:
        yield Facts(tuple(_mode(m, unicode)))
    if found.transitions:
        yield Facts(tuple(_transitions(found)))
    yield Facts(tuple(("" if n else "how sure", sentence) for n, sentence in enumerate(_sure(found))))


_ASCII = str.maketrans({"ö": "oe", "…": "..."})


def _mode(m: OperationMode, unicode: bool) -> Iterator[tuple[str, str]]:
    yield f"mode {m.number}", f"{m.motion}; dimension {m.dimension}"
    short = first([e for e in m.equations if is_everything() or len(terms_of(e)) <= _LONG], _SHOWN)
    texts = [f"{_left(e, unicode)} = 0" for e in short]
    more = len(m.equations) - len(short)
    count = f"{'and ' if short else ''}{more}{' more' if short else ' of more terms'}"
    rest = f"{count}{naming_options(' (--full prints them)')}" if more else ""
    yield "equations", ", ".join([*texts, *([rest] if rest else [])]) or "none"
    yield (
        "home",
        {True: "in it", False: "not in it", None: "in its equations; not decided whether in its closure"}[m.home],
    )
    if m.witness is None:
        yield "a pose", "none with small numbers was found"
    elif not m.home:
        yield "a pose", _pose(m.witness)
    yield "met by", f"{'' if m.assembled else 'none of the '}random assemblies"
    if not m.proper:
        yield "open", "whether it is a part of a larger mode"
    if not m.irreducible:
        yield "open", "whether its orientations decompose further"


def _transitions(found: OperationModes) -> Iterator[tuple[str, str]]:
    apart = [t.modes for t in found.transitions if t.meet is False]
    for t in found.transitions:
        if t.meet and t.witness is not None:
            yield f"modes {t.modes[0]}, {t.modes[1]}", _meeting(t.witness)
    unknown = [t.modes for t in found.transitions if t.meet is None]
    if apart:
        yield "apart", f"{_pairs(apart)}: no orientation is in both"
    if unknown:
        yield "not found", f"a common pose of {_pairs(unknown)}"


def _pairs(pairs: Sequence[tuple[int, int]]) -> str:
    return "all pairs" if len(pairs) > 12 else ", ".join(f"{a} and {b}" for a, b in pairs)


def _meeting(pose: Sequence[Fraction]) -> str:
    return f"meet, as in {_pose(pose)}" if any(pose[1:]) else "meet at home"


def _pose(pose: Sequence[Fraction]) -> str:
    return f"x = ({', '.join(map(str, pose[:4]))}), y = ({', '.join(map(str, pose[4:]))})"


def _sure(found: OperationModes) -> Iterator[str]:
    a = found.assemblies
    yield (
        "poses are x + ε y with x0 y0 + x1 y1 + x2 y2 + x3 y3 = 0, home is x = (1, 0, 0, 0), y = 0; limits of poses"
        " that limbs reach count too"
    )
    yield (
        "the limbs' equations hold at random poses of each limb modulo a prime of 61 bits, and at"
        f" {FRESH} fresh exact ones"
    )
    if found.whole:
        yield (
            "elimination with cases: every irreducible set of real poses of dimension"
            f" {found.least} or more that they allow is in one of these modes"
        )
    else:
        names = listed([c.name for c in found.limbs if not c.enough])
        yield (
            f"{names}: no equations linear in y up to degree {DEGREE}; only poses in which two turns about parallel"
            " axes are coupled were decomposed, so there may be further modes"
        )
    if a.outside:
        yield (
            f"{a.outside} of {a.closed} random assemblies, closed from the joints in floats, are in none of these"
            " modes, so the list is not complete"
        )
    else:
        yield "random assemblies, closed from the joints in floats, are all in these modes (--json counts them)"


def _left(equation: Equation, unicode: bool = False, latex: bool = False) -> str:
    terms = terms_of(equation)
    divisor = content(c for c, _ in terms) * (1 if terms[0][0] > 0 else -1)
    text = ""
    for c, e in terms:
        number = c / divisor
        size = "" if abs(number) == 1 else str(abs(number))
        factors = [_power(n, k, latex) for n, k in zip(_NAMES, e, strict=True) if k]
        sign = ("-" if number < 0 else "") if not text else (" - " if number < 0 else " + ")
        text += sign + " ".join([size, *factors] if size else factors)
    return text.replace("-", "−") if unicode else text


def _power(name: str, n: int, latex: bool) -> str:
    base = f"{name[0]}_{name[1]}" if latex else name
    return base if n == 1 else f"{base}^{n}"


def as_latex(found: OperationModes) -> str:
    """A tabular: for each mode the motion, its dimension and its equations; needs no package."""
    rows = []
    for m in found.modes:
        rows.append((f"mode {m.number}", f"{latex_words(m.motion)}; dimension {m.dimension}"))
        rows += [("", f"${_left(e, latex=True)} = 0$") for e in m.equations]
    rows += [
        (f"modes {t.modes[0]}, {t.modes[1]}", latex_words(_meeting(t.witness)))
        for t in found.transitions
        if t.meet and t.witness
    ]
    return latex_table(rows)
