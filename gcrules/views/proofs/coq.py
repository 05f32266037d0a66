r"""Theorems as a script of Coq (Rocq), which replays their proofs down to coordinates: coqc FILE.v.

The script starts with `GrassmannCayley.v`: extensors by coordinates over any commutative ring, formal polynomials in
brackets, and the proof that what is replayed with them holds. A theorem is then a statement on points, and a
computation.

>>> from gcrules.algebra.language.syntax import parse_equation
>>> from gcrules.algebra.proofs.proof_file import ProofFile
>>> from gcrules.algebra.proofs.theorem import theorem
>>> text = script(ProofFile("Example", (theorem("a line meets a plane", *parse_equation("ab /\\ cde == cde /\\ ab")),)))
>>> print(text[text.index("Theorem a_line"):text.index("Proof.", text.index("Theorem a_line"))].strip())
Theorem a_line_meets_a_plane : forall a b c d e : vector space,
  ((a ∨ b) ∧ (c ∨ d ∨ e))
  = ((c ∨ d ∨ e) ∧ (a ∨ b)).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from fractions import Fraction
from importlib.resources import files
from math import lcm
from typing import Any

from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.core.errors import InputError

__all__ = ["script", "without_script"]

_SPACES = {3: "plane", 4: "space"}
_TOGETHER = 100  # relations in one definition
_RESERVED = frozenset(  # words of Coq, and names that statements use
    re.findall(
        r"\w+",
        "as at cofix else end exists exists2 fix for forall fun if IF in let match mod return then using where with "
        "Prop Set SProp Type bracket infinite number place plane power space superbracket vector",
    )
)
_SIGNS = {"join": " ∨ ", "meet": " ∧ ", "sum": " + ", "product": " · "}
_CONSTRUCTORS = {"join": "Join", "meet": "Meet", "sum": "Sum", "product": "Join"}


def script(file: ProofFile) -> str:
    """A script that states and proves the theorems of a file; a comment names those that it cannot state. Raises
    InputError where there is no other.
    """
    left_out = without_script(file)
    data = [t.to_json() for t in file.theorems if not _why_not(t)]
    if not data:
        why = "; ".join(f"{name}: {reason}" for name, reason in left_out.items())
        raise InputError(f"no theorem can be written for Coq: {why}")
    named = dict(zip(_names(t["name"] for t in data), data, strict=True))
    rows = sorted({tuple(row) for t in data for row in _rows(t)})
    library = files("gcrules.views.proofs").joinpath("GrassmannCayley.v").read_text(encoding="utf-8")
    return "\n".join(
        [
            f"(* {_comment(file.title)} *)\n",
            *(f"(* Not here: {_comment(f'{name}, {why}')}. *)" for name, why in left_out.items()),
            library,
            "(* ---- brackets by the numbers of their points *)\n",
            *(f"Definition {_row(row)} : list nat := [{'; '.join(map(str, row))}]." for row in rows),
            *(_theorem(name, t) for name, t in named.items()),
            "\nEnd Commutative_ring.\n",
            *(f"Print Assumptions {name}." for name in named),
            "",
        ]
    )


def without_script(file: ProofFile) -> dict[str, str]:
    """The names of the theorems that no script has, with the reasons."""
    return {t.name: why for t in file.theorems if (why := _why_not(t))}


def _why_not(t: Theorem) -> str:
    if t.rank not in _SPACES:
        return f"it is in rank {t.rank}, and scripts are written in ranks 3 and 4"
    return "it holds under assumptions" if t.given else ""


def _comment(text: str) -> str:
    return text.replace("(*", "( *").replace("*)", "* )").replace('"', "''")


def _names(texts: Iterable[str]) -> list[str]:
    """Names of Coq, each once."""
    names: list[str] = []
    for text in texts:
        name = re.sub(r"[^0-9a-z]+", "_", text.lower()).strip("_")
        name = name if re.match("[a-z]", name) else f"theorem_{name}".rstrip("_")
        number, unique = 1, name
        while unique in names or unique in _RESERVED:
            number += 1
            unique = f"{name}_{number}"
        names.append(unique)
    return names


def _row(row: Sequence[int]) -> str:
    return "row_" + "_".join(map(str, row))


def _rows(t: dict[str, Any]) -> Iterable[Sequence[int]]:
    for first, second, _, multiplier in t["relations"]:
        yield from (first, second)
        for _, *rows in multiplier:
            yield from rows


def _theorem(name: str, t: dict[str, Any]) -> str:
    space = _SPACES[t["rank"]]
    expressions = _Expressions(name, t)
    (left, left_factor), (right, right_factor) = map(expressions.whole, t["claim"])
    coefficients = [Fraction(c) for _, _, _, multiplier in t["relations"] for c, *_ in multiplier]
    both = lcm(left_factor, right_factor)
    both = lcm(both, *(c.denominator for c in coefficients)) if coefficients else both
    left, right = _multiple(left, both // left_factor), _multiple(right, both // right_factor)
    points = expressions.points
    at_infinity = "".join(f"  infinite {space} {p} ->\n" for p in points[: t["ideal"]])
    lets = "".join(f"  let {n} := {expressions.statement(e)} in\n" for n, e in expressions.definitions)
    relations = _relations(name, t, both)
    listed = "; ".join(points)
    variables = f"forall {' '.join(points)} : vector {space},\n" if points else "\n"
    at = f"(fun place => nth place [{listed}] {points[0]})" if points else f"(fun _ => origin_of_{space})"
    scaled = f" Both sides are multiplied by {both}, so that all numbers are whole." if both > 1 else ""
    renamed = [f"{new} is {_comment(old)}" for old, new in zip(t["points"], points, strict=True) if old != new]
    note = f" {', '.join(renamed)}." if renamed else ""
    return "\n".join(
        [
            f"\n(* {_comment(t['name'])}.{scaled}{note} *)",
            *(f"Definition {name}_{n} := {expressions.data(e)}." for n, e in expressions.definitions),
            f"Definition {name}_left := {expressions.data(left)}.",
            f"Definition {name}_right := {expressions.data(right)}.",
            *relations,
            "",
            f"Theorem {name} : {variables}{at_infinity}{lets}  {expressions.statement(left)}",
            f"  = {expressions.statement(right)}.",
            "Proof.",
            "  intros.",
            f"  refine (replay_sound {space} {at} {t['ideal']} {len(points)}",
            f"    {name}_left {name}_right {name}_relations _ _).",
            "  - let n := fresh in let below := fresh in intros n below;",
            f"    do {t['ideal']} (destruct n as [|n]; [assumption|]); lia.",
            "  - vm_cast_no_check (eq_refl true).",
            "Qed.",
        ]
    )


def _relations(name: str, t: dict[str, Any], factor: int) -> list[str]:
    written = []
    for first, second, count, multiplier in t["relations"]:
        parts = [f"times_brackets ({Fraction(c) * factor}) [{'; '.join(map(_row, rows))}]" for c, *rows in multiplier]
        written.append(f"exchange_of {_row(first)} {_row(second)} {count} [{'; '.join(parts)}]")
    blocks = [written[i : i + _TOGETHER] for i in range(0, len(written), _TOGETHER)]
    lines = []
    for i, block in enumerate(blocks):
        separated = ";\n  ".join(block)
        lines.append(f"Definition {name}_relations_{i} : list relation := [\n  {separated}].")
    joined = " ++ ".join([*(f"{name}_relations_{i}" for i in range(len(blocks))), "[]"])
    return [*lines, f"Definition {name}_relations : list relation := {joined}."]


def _multiple(e: Any, factor: int) -> Any:
    return e if factor == 1 else ["product", ["number", factor], e]


class _Expressions:
    """The expressions of a theorem with whole numbers, as statements and as data."""

    def __init__(self, name: str, t: dict[str, Any]) -> None:
        self.name = name
        self.rank: int = t["rank"]
        self.points = _point_names(t["points"])
        self.place = {p: i for i, p in enumerate(t["points"])}
        self.factors: dict[str, int] = {}
        self.definitions: list[tuple[str, Any]] = []
        for n, e in t["definitions"]:
            found, factor = self.whole(e)
            self.factors[n] = factor
            self.definitions.append((_defined(n), found))

    def whole(self, e: Any) -> tuple[Any, int]:
        """A multiple of an expression, and by what it is multiplied, so that all its numbers are whole."""
        if isinstance(e, str):
            return e, self.factors.get(e, 1)
        kind, *parts = e
        if kind == "number":
            value = Fraction(parts[0])
            return ["number", value.numerator], value.denominator
        if kind == "power":
            base, factor = self.whole(parts[0])
            return ["power", base, parts[1]], factor ** parts[1]
        found = [self.whole(part) for part in parts]
        if kind == "sum":
            common = lcm(*(factor for _, factor in found))
            return ["sum", *(_multiple(part, common // factor) for part, factor in found)], common
        factor = 1
        for _, further in found:
            factor *= further
        return [kind, *(part for part, _ in found)], factor

    def statement(self, e: Any) -> str:
        """An expression on points."""
        if isinstance(e, str):
            return self.points[self.place[e]] if e in self.place else _defined(e)
        kind, *parts = e
        if kind == "number":
            return f"(number {_SPACES[self.rank]} ({parts[0]}))"
        if kind == "power":
            return f"(power {self.statement(parts[0])} {parts[1]})"
        written = [self.statement(part) for part in parts]
        if kind == "bracket":
            return f"(bracket ({_SIGNS['join'].join(written)}))"
        if kind == "superbracket" and self.rank == 4:
            return f"(superbracket {' '.join(written)})"
        return f"({_SIGNS['meet' if kind == 'superbracket' else kind].join(written)})"

    def data(self, e: Any) -> str:
        """An expression as it is computed with."""
        if isinstance(e, str):
            return f"(Point {self.place[e]})" if e in self.place else f"{self.name}_{_defined(e)}"
        kind, *parts = e
        if kind == "number":
            return f"(Number ({parts[0]}))"
        if kind == "power":
            return f"(Power {self.data(parts[0])} {parts[1]})"
        written = [self.data(part) for part in parts]
        if kind == "bracket":
            return f"(Bracket {_nested('Join', written)})"
        if kind == "superbracket" and self.rank == 4:
            return f"(Superbracket {' '.join(written)})"
        return _nested("Meet" if kind == "superbracket" else _CONSTRUCTORS[kind], written)


def _nested(constructor: str, parts: Sequence[str]) -> str:
    found = parts[0]
    for part in parts[1:]:
        found = f"({constructor} {found} {part})"
    return found


def _defined(name: str) -> str:
    return name.replace("#", "part_")


def _point_names(points: Sequence[str]) -> list[str]:
    taken: list[str] = []
    for i, p in enumerate(points):
        fits = re.fullmatch(r"[A-Za-z][A-Za-z0-9_']*", p) and p not in _RESERVED and not p.startswith("part_")
        name = p if fits else f"point_{i}"
        while name in taken or (name != p and name in points):
            name += "_"
        taken.append(name)
    return taken
