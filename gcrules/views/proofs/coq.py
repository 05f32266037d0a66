r"""Theorems as a script of Coq (Rocq), which replays their proofs down to coordinates: coqc FILE.v.

The script starts with `GrassmannCayley.v`: extensors by coordinates over any commutative ring, formal polynomials in
brackets, and the proof that what is replayed with them holds. A theorem is then a statement on points, and a
computation. Under assumptions (`coq_assumed`) `Assumptions.v` follows it, by which points are placed over a field. In
ranks other than 3 and 4 there is `Ranks.v`, which defines extensors of any rank.

>>> from gcrules.algebra.language.syntax import parse_equation
>>> from gcrules.algebra.proofs.proof_file import ProofFile
>>> from gcrules.algebra.proofs.proving import theorem
>>> text = script(ProofFile("Example", (theorem("a line meets a plane", *parse_equation("ab /\\ cde == cde /\\ ab")),)))
>>> print(text[text.index("Theorem a_line"):text.index("Proof.", text.index("Theorem a_line"))].strip())
Theorem a_line_meets_a_plane : forall a b c d e : vector space,
  ((a ∨ b) ∧ (c ∨ d ∨ e))
  = ((c ∨ d ∨ e) ∧ (a ∨ b)).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from importlib.resources import files
from math import lcm
from typing import Any

from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.core.errors import InputError
from gcrules.views.proofs.coq_cases import Proof, cases_proof
from gcrules.views.proofs.coq_expressions import RESERVED, SPACES, Expressions, derived, geometry, multiple
from gcrules.views.proofs.coq_relations import denominator, named_rows, written_relations

__all__ = ["script", "without_script"]

_NAMED = re.compile(  # the fields of a record among them
    r"^(?: *(?:Definition|Fixpoint|Lemma|Theorem|Variable|Hypothesis|Record|Inductive|Section|Notation) "
    r"|  (?=\w+ : ))(\w+)",
    re.MULTILINE,
)


def script(file: ProofFile) -> str:
    """A script that states and proves the theorems of a file; a comment names those that it cannot state. Raises
    InputError where there is no other.
    """
    left_out = without_script(file)
    written = [t for t in file.theorems if not _why_not(t)]
    if not written:
        why = "; ".join(f"{name}: {reason}" for name, reason in left_out.items())
        raise InputError(f"no theorem can be written for Coq: {why}")
    others = sorted({t.rank for t in written}.difference(SPACES))
    parts = {"GrassmannCayley.v": True, "Ranks.v": others, "Assumptions.v": any(t.given for t in written)}
    library = files("gcrules.views.proofs")
    libraries = [library.joinpath(part).read_text(encoding="utf-8") for part, wanted in parts.items() if wanted]
    libraries += map(_of_rank, others)
    named = dict(zip(_names((t.name for t in written), libraries), written, strict=True))
    relations = [r for t in written for r in _relations(t)]
    return "\n".join(
        [
            f"(* {_comment(file.title)} *)\n",
            *(f"(* Not here: {_comment(f'{name}, {why}')}. *)" for name, why in left_out.items()),
            *libraries,
            "(* ---- brackets by the numbers of their points *)\n",
            *named_rows(relations),
            *(_assumed(name, t) if t.given else _theorem(name, t.to_json()) for name, t in named.items()),
            "\nEnd Commutative_ring.\n",
            *(f"Print Assumptions {name}." for name in named),
            "",
        ]
    )


def _of_rank(rank: int) -> str:
    name = geometry(rank)
    return (
        f"Definition {name} : geometry := of_rank {rank - 1} ltac:(discriminate).\n"
        f"Definition origin_of_{name} : vector {name} := origin {rank}.\n"
    )


def without_script(file: ProofFile) -> dict[str, str]:
    """The names of the theorems that no script has, with the reasons."""
    return {t.name: why for t in file.theorems if (why := _why_not(t))}


def _why_not(t: Theorem) -> str:
    if t.given and t.rank not in SPACES:
        return f"it holds under assumptions in rank {t.rank}, and scripts have those in ranks 3 and 4"
    if t.in_a_basis:
        return "its points are written in some of them that are a basis, and scripts have exchange relations alone"
    found = cases_proof(t) if t.given else ""
    return found if isinstance(found, str) else ""


def _relations(t: Theorem) -> Iterable[Any]:
    return _proof(t).relations if t.given else t.to_json()["relations"]


def _proof(t: Theorem) -> Proof:
    """The proof of a theorem under assumptions, which can be written."""
    found = cases_proof(t)
    assert not isinstance(found, str)
    return found


def _assumed(name: str, t: Theorem) -> str:
    proof = _proof(t)
    return f"\n{_note(t.name, proof.factor, proof.statement.renamed)}\n{proof.text(name)}"


def _note(name: str, factor: int, renamed: Mapping[str, str]) -> str:
    """What a theorem is called, and how it differs from how it was written."""
    scaled = f" Both sides are multiplied by {factor}, so that all numbers are whole." if factor > 1 else ""
    others = ", ".join(f"{new} is {_comment(old)}" for old, new in renamed.items())
    return f"(* {_comment(name)}.{scaled}{f' {others}.' if others else ''} *)"


def _comment(text: str) -> str:
    return text.replace("(*", "( *").replace("*)", "* )").replace('"', "''")


def _names(texts: Iterable[str], libraries: Iterable[str]) -> list[str]:
    """Names of Coq, each once and none of those in the libraries."""
    taken = RESERVED.union(*(_NAMED.findall(library) for library in libraries))
    names: list[str] = []
    for text in texts:
        name = re.sub(r"[^0-9a-z]+", "_", text.lower()).strip("_")
        name = name if re.match("[a-z]", name) else f"theorem_{name}".rstrip("_")
        number, unique = 1, name
        while unique in names or unique in taken:
            number += 1
            unique = f"{name}_{number}"
        names.append(unique)
    return names


def _theorem(name: str, t: dict[str, Any]) -> str:
    space = geometry(t["rank"])
    expressions = Expressions(name, t)
    (left, left_factor), (right, right_factor) = map(expressions.whole, t["claim"])
    both = lcm(left_factor, right_factor, denominator(t["relations"]))
    left, right = multiple(left, both // left_factor), multiple(right, both // right_factor)
    points = expressions.points
    at_infinity = "".join(f"  infinite {space} {p} ->\n" for p in points[: t["ideal"]])
    lets = "".join(f"  let {n} := {expressions.statement(e)} in\n" for n, e in expressions.definitions)
    relations = written_relations(name, t["relations"], both)
    listed, together = "; ".join(points), " ".join(points)
    variables = f"forall {together} : vector {space},\n" if points else "\n"
    at = f"(fun place => nth place [{listed}] {points[0]})" if points else f"(fun _ => origin_of_{space})"
    renamed = {old: new for old, new in zip(t["points"], points, strict=True) if old != new}
    return "\n".join(
        [
            f"\n{_note(t['name'], both, renamed)}",
            *(f"Definition {derived(name, n)} := {expressions.data(e)}." for n, e in expressions.definitions),
            f"Definition {derived(name, 'left')} := {expressions.data(left)}.",
            f"Definition {derived(name, 'right')} := {expressions.data(right)}.",
            *relations,
            "",
            f"Theorem {name} : {variables}{at_infinity}{lets}  {expressions.side(left)}",
            f"  = {expressions.statement(right)}.",
            "Proof.",
            f"  {f'intros {together}. ' if points else ''}intros.",
            f"  refine (replay_sound {space} {at} {t['ideal']} {len(points)}",
            f"    {derived(name, 'left')} {derived(name, 'right')} {derived(name, 'relations')} _ _).",
            "  - let n := fresh in let below := fresh in intros n below;",
            f"    do {t['ideal']} (destruct n as [|n]; [assumption|]); lia.",
            "  - vm_cast_no_check (eq_refl true).",
            "Qed.",
        ]
    )
