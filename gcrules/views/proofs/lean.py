r"""Theorems as text of Lean 4 with Mathlib: brackets are unknown elements of a ring, exchange relations hypotheses.

A theorem says that what both sides' difference expands to, as a polynomial in brackets, is zero where the exchange
relations hold; `linear_combination` multiplies it out. What brackets, joins and meets are is not stated: see `coq`.

>>> from gcrules.algebra.language.syntax import parse_equation
>>> from gcrules.algebra.proofs.proof_file import ProofFile
>>> from gcrules.algebra.proofs.proving import theorem
>>> equation = "[abc] * [ade] - [abd] * [ace] + [abe] * [acd] == 0"
>>> text = script(ProofFile("Example", (theorem("exchange", *parse_equation(equation, rank=3)),)))
>>> print(text[text.index("    (h1"):].strip())
(h1 : b_0_1_4 * b_0_2_3 - b_0_1_3 * b_0_2_4 + b_0_1_2 * b_0_3_4 = 0)
    : b_0_1_4 * b_0_2_3 - b_0_1_3 * b_0_2_4 + b_0_1_2 * b_0_3_4 = 0 := by
  linear_combination (1) * h1
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from gcrules.algebra.bracket import Coefficient, Monomial, Row
from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.algebra.proofs.relations import Relation
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.algebra.straightening.syzygies import exchange
from gcrules.core.errors import InputError

__all__ = ["script"]


def script(file: ProofFile) -> str:
    """The theorems of a file as text of Lean, which nobody has checked before it is compiled; a comment names those
    under assumptions and those written in a basis, which are left out. Raises InputError where there are no others.
    """
    theorems = [t for t in file.theorems if not t.given and not t.in_a_basis]
    left_out = {
        t.name: "it holds under assumptions" if t.given else "its points are written in a basis"
        for t in file.theorems
        if t not in theorems
    }
    if not theorems:
        why = "; ".join(f"{name}: {reason}" for name, reason in left_out.items())
        raise InputError(f"no theorem can be written for Lean: {why}")
    head = (
        f"/- {_comment(file.title)}\n\n"
        "Written for Lean 4 with Mathlib; not checked here. Brackets are unknown elements of a field: b_0_1_2_3 is\n"
        "the bracket of the points 0, 1, 2, 3. The exchange relations that a proof names are its hypotheses. -/\n\n"
        "import Mathlib\n"
    )
    head += "".join(f"-- Not here, since {why}: {' '.join(name.split())}\n" for name, why in left_out.items())
    return head + "".join(_theorem(number, t) for number, t in enumerate(theorems, start=1))


def _comment(text: str) -> str:
    return text.replace("/-", "/ -").replace("-/", "- /")


def _theorem(number: int, t: Theorem) -> str:
    claim: dict[Monomial, Coefficient] = defaultdict(int)
    hypotheses = []
    for i, r in enumerate(t.relations, start=1):
        terms: dict[Monomial, Coefficient] = dict(_terms(r, t.ideal))
        hypotheses.append(f"    (h{i} : {_polynomial(terms)} = 0)")
        for m, c in r.multiplier.items():
            for pair, sign in terms.items():
                claim[tuple(sorted((*m, *pair)))] += c * sign
    rows = sorted({row for r in t.relations for row in _rows(r, t.ideal)})
    over = f" ({' '.join(map(_row, rows))} : K)" if rows else ""
    combination = " + ".join(f"({_polynomial(r.multiplier)}) * h{i}" for i, r in enumerate(t.relations, start=1))
    points = ", ".join(f"{i} is {p}" for i, p in enumerate(t.order))
    return "\n".join(
        [
            f"\n/-- {_comment(t.name)}: {_comment(f'{t.left} == {t.right}')}, expanded. Points: {points}; larger",
            "numbers are further points, which close extensors. -/",
            f"theorem theorem_{number} {{K : Type*}} [Field K] [CharZero K]{over}",
            *hypotheses,
            f"    : {_polynomial(claim)} = 0 := by",
            f"  linear_combination {combination}" if combination else "  ring",
            "",
        ]
    )


def _terms(r: Relation, ideal: int) -> Iterator[tuple[Monomial, int]]:
    """[first][second] less what it is exchanged for."""
    yield tuple(sorted((r.first, r.second))), 1
    for sign, pair in exchange(r.first, r.second, r.number):
        if all(row[-1] >= ideal for row in pair):
            yield pair, -sign


def _rows(r: Relation, ideal: int) -> Iterable[Row]:
    yield from (row for pair, _ in _terms(r, ideal) for row in pair)
    yield from (row for m in r.multiplier for row in m)


def _row(row: Row) -> str:
    return "b_" + "_".join(map(str, row))


def _polynomial(terms: Mapping[Monomial, Coefficient]) -> str:
    written = ""
    for m, c in terms.items():
        if not c:
            continue
        size = abs(Fraction(c))
        factors = [*([str(size)] if size != 1 or not m else []), *map(_row, m)]
        written += f"{' - ' if c < 0 else ' + ' if written else ''}{' * '.join(factors)}"
    return written.strip() or "0"
