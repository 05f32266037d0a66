r"""Claims decided: equations as `prove` does, relations by all their equations, words where what they make exists.

>>> from gcrules.algebra.language.relations import parse_claim
>>> from gcrules.algebra.language.statements import parse_assumption
>>> from gcrules.algebra.language.syntax import Context
>>> at = parse_assumption("isotropic i j", Context(rank=3))
>>> found = decide(parse_claim("perpendicular(a \\/ orthocentre(a, b, c), bc)", at), at)
>>> found.verdict, found.meanings
('proved', ('the point exists',))
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.language.relations import Claimed
from gcrules.algebra.prove import Proof, prove
from gcrules.algebra.space import Space
from gcrules.core.english import listed
from gcrules.core.errors import InputError

__all__ = ["decide"]

_VERDICTS = ("refuted", "undecided", "proved")


def decide(claimed: Claimed, at: Space, *, limit: int = MAX_TERMS) -> Proof:
    """The verdict on what is claimed in a space, with what is given there: refuted if one of its equations is.

    What the claim's words make is assumed not to vanish, and told as such where the claim is proved. Raises StepError
    and InputError as `prove` does, and InputError where a word makes what exists nowhere.
    """
    for r in claimed.required:
        if vanishes(r.expr, rank=at.rank, ideal=at.ideal, samples=2):
            raise InputError(f"{r.text} vanishes at all positions")
    nonzero = (*claimed.nonzero, *(r.expr for r in claimed.required))
    parts = []
    for left, right in claimed.equations:
        parts.append(
            prove(
                left,
                right,
                points=at.points,
                ideal=at.ideal,
                rank=at.rank,
                given=at.given,
                nonzero=nonzero,
                limit=limit,
            )
        )
        if parts[-1].verdict == "refuted":
            break
    found = _told(_together(parts), claimed, at)
    return replace(found, dual=claimed.dual, relation=claimed.relation, parts=tuple(parts) if len(parts) > 1 else ())


def _together(parts: Sequence[Proof]) -> Proof:
    """The proof that decides, with what is assumed for any of them if all are proved."""
    worst = min(parts, key=lambda p: _VERDICTS.index(p.verdict))
    if not worst.proved or len(parts) == 1:
        return worst
    assumed = {e: m for p in parts for e, m in zip(p.assumed, p.meanings or [""] * len(p.assumed), strict=True)}
    pairs = tuple(dict.fromkeys(pair for p in parts for pair in p.together))
    alike = len({tuple(k.where for k in p.kinds) for p in parts}) == 1
    kinds = tuple(
        replace(
            some[0],
            assumed=tuple(dict.fromkeys(e for k in some for e in k.assumed)),
            together=tuple(dict.fromkeys(pair for k in some for pair in k.together)),
        )
        for some in zip(*(p.kinds for p in parts), strict=alike)
    )
    return replace(
        worst,
        assumed=tuple(assumed),
        meanings=tuple(assumed.values()),
        together=pairs,
        kinds=kinds if alike else (),
    )


def _told(proof: Proof, claimed: Claimed, at: Space) -> Proof:
    """In the words of the claim: what must exist, that it is a relation, and what points at infinity are real."""
    reason = proof.reason
    if claimed.relation:
        reason = reason.replace("the sides differ", "it does not hold", 1).replace(
            "both sides", "both sides of its " + ("equation" if len(claimed.equations) == 1 else "equations"), 1
        )
    if proof.verdict == "refuted" and at.infinity is not None and at.infinity.kind == "isotropic":
        names = listed(at.infinity.points)
        reason += f"; {names} are real here, a linear map takes them to the isotropic points and the others along"
    if not proof.proved or not claimed.required:
        return replace(proof, reason=reason)
    assumed = dict(zip(proof.assumed, proof.meanings or [""] * len(proof.assumed), strict=True))
    assumed |= {r.text: r.meaning for r in claimed.required}
    return replace(proof, reason=reason, assumed=tuple(assumed), meanings=tuple(assumed.values()))
