r"""What an answer claims, with the proofs that a checker can replay.

>>> from gcrules.conditions.analysis import analyze
>>> found = proof_file(analyze("ab af cb cd ed ef"))
>>> [(t.name, t.size) for t in found.theorems]
[('condition: four-planes', 2), ('reading 1: four-planes', 2)]
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from gcrules.algebra.assumptions.incidences import equations
from gcrules.algebra.combinations import given_part
from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import Expr, Number, add, mul, points_of
from gcrules.algebra.factoring.forms import Factors
from gcrules.algebra.factoring.result import Factorization
from gcrules.algebra.proofs.absence import no_expression, no_shorter
from gcrules.algebra.proofs.combination import by_multiples
from gcrules.algebra.proofs.multiples import multipliers
from gcrules.algebra.proofs.proof_file import Absence, LeftOut, ProofFile
from gcrules.algebra.proofs.proving import theorem, theorems
from gcrules.algebra.proofs.screws import with_screws
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.algebra.prove import Proof, difference_of
from gcrules.algebra.screw_letters import screws_of
from gcrules.algebra.shortening.result import Shortening
from gcrules.algebra.space import Assumption, Space
from gcrules.algebra.structure import Structure
from gcrules.algebra.whole_letters import in_letters
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.transversals import Transversals
from gcrules.core.budget import checkpoint, report
from gcrules.core.dataclass import dataclass
from gcrules.core.english import counted
from gcrules.core.errors import EngineFault, InputError, LimitReached
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.condition import Condition
from gcrules.rules.script import ClaimResult, RuleResult, ScriptResult, ScriptResults

__all__ = ["proof_file", "proof_file_or_none"]

_RANDOM = "it was tested at random points only"
_BY_DEFINITION = "it holds by definition of the superbracket"
_WITH_FULL = "they are written where --full (in Python every=True) asks for them"


@dataclass(frozen=True)
class _Claim:
    """left == right, to be proved."""

    name: str
    left: Expr
    right: Expr
    rank: int
    ideal: tuple[str, ...] = ()
    given: tuple[Assumption, ...] = ()
    nonzero: tuple[Expr, ...] = ()


_Said = _Claim | Absence | LeftOut
"""What is to be proved, what is recomputed, and what neither is done with in a file."""


def proof_file(answer: Any) -> ProofFile:
    """The theorems of an answer, each with a proof that can be replayed without gcrules (`checkers/check_proof.py`).

    An answer is a proof, a factorization, a shortest form, a script's results, an analysis of legs or of a robot, a
    transversal condition, or a catalog. What does not exist is stated in `absences`, with what was enumerated, so that
    `checkers/recompute.py` can do so again; what else has no proof is `left_out`, with the reason.
    Raises InputError for any other kind of answer, and where nothing is left to prove.
    """
    for kind, claims in _KINDS.items():
        if isinstance(answer, kind):
            return _proved(*claims(answer))
    names = ", ".join(kind.__name__ for kind in _KINDS)
    raise InputError(f"no proofs can be written of a {type(answer).__name__}", hint=f"they are written of: {names}")


def proof_file_or_none(answer: Any) -> ProofFile | None:
    """The same; None where there is no proof to write."""
    try:
        return proof_file(answer)
    except (InputError, LimitReached):
        return None


def _proved(title: str, claims: Iterable[_Said]) -> ProofFile:
    written: list[Theorem] = []
    left_out: list[LeftOut] = []
    absences: list[Absence] = []
    for claim in claims:
        checkpoint()
        report(claim.name)
        if isinstance(claim, LeftOut):
            left_out.append(claim)
            continue
        if isinstance(claim, Absence):
            absences.append(claim)
            continue
        try:
            written += _written(claim)
        except (InputError, LimitReached) as fault:
            left_out.append(LeftOut(claim.name, fault.message))
    if not written:
        why = "; ".join(map(str, left_out)) or "it claims nothing"
        raise InputError(f"{title}: there is no proof to write: {why}")
    names = {t.name for t in written}
    alone = (LeftOut(one.name, f"'{one.theorem}' is not proved in the file") for one in absences)
    left_out += [out for out, one in zip(alone, absences, strict=True) if one.theorem not in names]
    return ProofFile(title, tuple(written), tuple(left_out), tuple(one for one in absences if one.theorem in names))


def _written(claim: _Claim) -> Sequence[Theorem]:
    """The theorems that a claim is: as it is proved in a file, or else as a sum of multiples of what is given."""
    try:
        return _proved_by_positions(claim)
    except (EngineFault, InputError, LimitReached) as fault:
        given = [e for a in claim.given for e in equations(a, claim.rank)]
        args = (given, claim.nonzero, claim.rank, claim.ideal)
        found = by_multiples(claim.name, claim.left, claim.right, *args) if given else None
        if found is not None:
            return (found,)
        if given and isinstance(fault, EngineFault):
            why = "it holds where something does not vanish that is not among its conditions"
            raise InputError(why) from None
        raise


def _proved_by_positions(claim: _Claim) -> Sequence[Theorem]:
    """The theorems that a claim is: with its points placed, as an identity that says more, or in cases."""
    given = () if claim.given and _everywhere(claim) else claim.given
    if any(screws_of(points_of(*a.args)) for a in given):
        return (with_screws(claim.name, claim.left, claim.right, given, ideal=claim.ideal),)
    found = partial(theorems, claim.name, claim.left, claim.right, ideal=claim.ideal, rank=claim.rank, given=given)
    try:
        return tuple(found(in_cases=False))
    except (InputError, LimitReached):
        stronger = _multiple_of_given(claim)
        return tuple(found()) if stronger is None else (stronger,)


def _multiple_of_given(claim: _Claim) -> Theorem | None:
    """The identity of which a claim under assumptions is a case: its sides differ by a multiple of something that is
    given, or by numbers times several such things. None where there is none, or no proof of it.
    """
    difference = difference_of(claim.left, claim.right, claim.rank)
    name = f"{claim.name}, up to a multiple of what is given"
    space = Space(claim.rank, (), tuple(claim.ideal), tuple(claim.given))
    zeros = (a.args[0] for a in claim.given if a.kind == "zero")
    for part in (*(partial(_times, difference, e, claim) for e in zeros), partial(given_part, difference, space)):
        try:
            if (found := part()) is not None:
                right = add(claim.right, found, rank=claim.rank)
                return theorem(name, claim.left, right, ideal=claim.ideal, rank=claim.rank)
        except (InputError, LimitReached):
            continue
    return None


def _times(difference: Expr, given: Expr, claim: _Claim) -> Expr | None:
    found = multipliers(difference, [given], claim.rank, claim.ideal)
    return None if found is None else mul(*found, given)


def _everywhere(claim: _Claim) -> bool:
    """Whether what is claimed under assumptions holds without them too."""
    return vanishes(difference_of(claim.left, claim.right, claim.rank), rank=claim.rank, ideal=claim.ideal)


# --- what each kind of answer claims ---------------------------------------------------------------------------------

_Claims = tuple[str, Iterable[_Said]]
"""Whose they are, and what the answer says."""


def _of_proof(proof: Proof) -> _Claims:
    name = "claim" if proof.dual is None else "what the claim is the dual of"
    return proof.relation or f"{proof.left} == {proof.right}", _equations(name, proof)


def _equations(name: str, proof: Proof) -> Iterator[_Claim | LeftOut]:
    """What is proved: of a relation that is several equations each of them."""
    if not proof.proved:
        yield LeftOut(name, f"it is {proof.verdict}")
        return
    for i, p in enumerate(proof.parts or (proof,), 1):
        own, nonzero = f"{name}, {i}" if proof.parts else name, (*p.conditions, *p.nonzero)
        yield _Claim(own, p.left, p.right, p.rank, p.ideal, p.given, nonzero)


def _of_factorization(found: Factorization) -> _Claims:
    return f"factors of {found.input}", _factored(found)


def _factored(found: Factorization) -> Iterator[_Said]:
    assert found.input is not None
    if found.exists and not found.proved:
        yield LeftOut("factorization", _RANDOM)
        return
    name = "factorization" if found.exists else "expansion"
    yield _Claim(name, found.input, found.whole(), found.rank, found.ideal)
    if found.exists is None:
        yield LeftOut("whether it is a product of expressions", f"it is undecided: {found.certificate.detail}")
    elif not found.exists:
        yield no_expression(found, name)
    for excluded in found.excluded:
        yield LeftOut(f"that there is {excluded}", "a search says so, which is not recomputed")
    if found.more:
        yield LeftOut(counted(found.more, "further expression"), _WITH_FULL)
    for i, form in enumerate((*found.alternatives, *found.rational), 1):
        yield _Claim(f"form {i}", mul(form.cofactor, found.input), form.product(), found.rank, found.ideal)


def _of_factors(found: Factors) -> _Claims:
    return f"irreducible factors of {found.input}", _irreducible(found)


def _irreducible(found: Factors) -> Iterator[_Said]:
    """The product, and the form of each factor; what does not exist, and irreducibility, are not proved here."""
    yield _Claim("factors", found.input, found.product(), found.rank, found.ideal)
    yield LeftOut("that the factors are irreducible", "it is decided on lines of positions, which is not replayed")
    for i, f in enumerate(found.factors, 1):
        if f.expression is None:
            yield LeftOut(f"a form of factor {i}", f"there is none: {f.form}")
        elif not f.proved:
            yield LeftOut(f"the form of factor {i}", _RANDOM)
        else:
            right = mul(Number(f.coefficient), f.expression)
            yield _Claim(f"factor {i}", mul(f.cofactor, in_letters(f.polynomial)), right, found.rank, found.ideal)


def _of_shortening(found: Shortening) -> _Claims:
    p = found.polynomial
    assert found.input is not None
    equal = _Claim("shortest form", found.input, p.to_expr(), p.rank, p.points[: p.ideal])
    bound = [no_shorter(found, equal.name)] if found.lower else []
    return f"shortest form of {found.input}", [equal, *bound]


def _of_script(found: ScriptResult) -> _Claims:
    return "a script", (claim for result in found.results for claim in _of_result(result))


def _of_scripts(found: ScriptResults) -> _Claims:
    """Claims of several files are told apart by the files' names."""
    named = (
        replace(claim, name=f"{file}, {claim.name}")
        for file, answer in zip(found.files, found.answers, strict=True)
        for result in answer.results
        for claim in _of_result(result)
    )
    return f"{len(found.files)} scripts", named


def _of_result(result: object) -> Iterator[_Claim | LeftOut]:
    if isinstance(result, ClaimResult) and result.proof is not None:
        yield from _equations(f"line {result.line}: {result.label}", result.proof)
    elif isinstance(result, RuleResult) and result.check.ok:
        for one in result.check.rule.instances:
            name = f"line {result.line}: {result.label} in rank {one.rank}"
            yield _Claim(name, one.left, one.right, one.rank, given=one.given)
    elif isinstance(result, ClaimResult | RuleResult):
        yield LeftOut(f"line {result.line}: {result.label}", f"it is {result.verdict}")


def _of_analysis(found: Analysis) -> _Claims:
    return found.structure.text(), _readings(found.structure, (found.condition, *found.readings))


def _of_transversals(found: Transversals) -> _Claims:
    more = [LeftOut(counted(found.more, "further reading"), _WITH_FULL)] if found.more else []
    return found.structure.text(), (*_readings(found.structure, [r.condition for r in found.readings]), *more)


def _readings(structure: Structure, conditions: Iterable[Condition]) -> Iterator[_Claim | LeftOut]:
    for i, c in enumerate(dict.fromkeys(conditions)):
        name = f"reading {i}: {c.kind}" if i else f"condition: {c.kind}"
        if c.certificate.method == "random-points":
            yield LeftOut(name, _RANDOM)
            continue
        left = mul(c.cofactor, structure.superbracket)
        if left == c.right_side:
            yield LeftOut(name, _BY_DEFINITION)
        else:
            yield _Claim(name, left, c.right_side, structure.rank, structure.ideal, structure.given)


def _of_robot(found: RobotAnalysis) -> _Claims:
    if found.lines is None:
        raise InputError(f"{found.robot.id}: its limbs apply wrenches that are not lines of its points")
    conditions = [c for c in (found.condition, found.lines.condition, *found.lines.readings) if c is not None]
    members = f"compared at {counted(found.members, 'exact random member')} of the robot's family"
    lines = LeftOut("that these lines stand for the joints", members)
    return found.robot.title, (*_readings(found.lines.structure, conditions), lines)


def _of_catalog(found: Catalog) -> _Claims:
    return "the catalog of classes", (one for entry in found.entries for one in _of_entry(entry))


def _of_entry(entry: Entry) -> Iterator[_Claim | LeftOut]:
    for i, c in enumerate((entry.condition, *entry.readings)):
        name = f"{entry.id}, reading {i}: {c.kind}" if i else f"{entry.id}, condition: {c.kind}"
        left, right = entry.sides(c)
        if left == right:
            yield LeftOut(name, _BY_DEFINITION)
        else:
            yield _Claim(name, left, right, entry.structure.rank)


_KINDS: dict[type, Callable[[Any], _Claims]] = {
    Proof: _of_proof,
    Factorization: _of_factorization,
    Factors: _of_factors,
    Shortening: _of_shortening,
    ScriptResult: _of_script,
    ScriptResults: _of_scripts,
    Analysis: _of_analysis,
    RobotAnalysis: _of_robot,
    Transversals: _of_transversals,
    Catalog: _of_catalog,
}
