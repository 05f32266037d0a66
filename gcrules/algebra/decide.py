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

from gcrules.algebra.combinations import given_part
from gcrules.algebra.duality import Dual, dual_of
from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expr import ZERO, Expr, points_of
from gcrules.algebra.language.relations import Claimed, parse_claim
from gcrules.algebra.language.statements import parse_assumption
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.text import text
from gcrules.algebra.letters import conics_of, declarations, letter_of, letters_of, named_letter
from gcrules.algebra.prove import Proof, difference_of, prove
from gcrules.algebra.reciprocal import Reciprocal, reciprocal
from gcrules.algebra.screw_letters import screw_of, screws_of
from gcrules.algebra.seated import Seated, in_words, seated
from gcrules.algebra.space import Space, Written
from gcrules.core.english import listed
from gcrules.core.errors import GcrulesError, InputError

__all__ = ["about_points", "decide"]

_VERDICTS = ("refuted", "undecided", "proved")
_SUMMED = "both sides differ by a sum of multiples of what is given, which vanishes"
_UNSAID = "both sides are equal where something does not vanish that cannot be said without the corners of {}"


def decide(claimed: Claimed, at: Space, *, limit: int = MAX_TERMS) -> Proof:
    """The verdict on what is claimed in a space, with what is given there: refuted if one of its equations is.

    What the claim's words make is assumed not to vanish, and told as such where the claim is proved. A claim about
    hyperplanes alone that stays undecided is proved as the dual of one about points, if that is; one of which tangents
    are given is so at once. Raises StepError and InputError as `prove` does, and InputError where a word makes
    what exists nowhere.
    """
    conics = conics_of(_names(claimed, at))
    touching = any(w.kind == "touches" for a in at.given for w in a.written)
    if touching and (of_points := _by_points(claimed, at, limit)) is not None:
        return of_points
    if conics:
        found = _about_conics(claimed, at, limit)
    else:
        placed = reciprocal(claimed, at)
        found = _of_screws(placed, limit) if placed else _decided(claimed, at, limit)
    if found.verdict == "undecided" and not touching:
        return _by_points(claimed, at, limit) or found
    return found


def _by_points(claimed: Claimed, at: Space, limit: int) -> Proof | None:
    """The proof of a claim about hyperplanes alone as the dual of one about points; None where that is not proved."""
    other = about_points(claimed, at)
    if other is None:
        return None
    names = sorted(_names(claimed, at))
    conics = conics_of(names)
    try:
        of_points = (_about_conics if conics else _decided)(*other, limit)
    except InputError:
        return None  # what is to be said of that, the claim itself says in its own words
    if not of_points.proved:
        return None
    written = claimed.relation or _written(claimed)
    given = tuple(dict.fromkeys(a.text for a in at.given))
    letters = declarations(letters_of(names), at.rank, screws_of(names), conics)
    return replace(of_points, relation=written, dual=Dual(letters, given, (written,)))


def _of_screws(placed: Reciprocal, limit: int) -> Proof:
    """The verdict on a claim about screws that are written as reciprocal to what is given."""
    try:
        return _decided(placed.claimed, placed.space, limit, placed)
    except InputError as raised:
        raise placed.fault(raised) from None


def _names(claimed: Claimed, at: Space) -> tuple[str, ...]:
    return points_of(*(e for pair in claimed.equations for e in pair), *(e for a in at.given for e in a.args))


def _written(claimed: Claimed) -> str:
    return " and ".join(f"{text(left)} == {text(right)}" for left, right in claimed.equations)


def about_points(claimed: Claimed, at: Space) -> tuple[Claimed, Space] | None:
    """The claim about points that a claim about hyperplanes is the dual of, with what is given; None for other claims,
    and where there is no such claim in the language.
    """
    special = at.ideal or claimed.dual or any(a.also for a in at.given)
    said = (*claimed.says(), *(w for a in at.given for w in a.written or (Written(a.kind, a.args),)))
    names = points_of(*(e for w in said for e in w.args))
    steps = letters_of(names)
    alone = all(letter_of(n) or screw_of(n) for n in names) and set(steps.values()) == {at.rank - 1}
    if not alone or special:
        return None
    try:
        other = dual_of(claimed.says(), at.given, at.rank)
        space = Context(at.rank)
        for one in (*other.letters, *other.given):
            space = parse_assumption(one, space)
        claims = [parse_claim(one, space) for one in other.claims]
    except GcrulesError:
        return None
    nonzero = tuple(e for one in claims for e in one.nonzero)
    made = (*nonzero, *(e for a in space.given for e in a.exists))  # a letter is never zero, as a point is not
    required = tuple(dict.fromkeys(r for one in claims for r in one.required))
    if any(not r.letter for r in (*claimed.required, *required)) or any(named_letter(e) is None for e in made):
        return None
    equations = tuple(pair for one in claims for pair in one.equations)
    return Claimed(equations, claimed.relation, required, nonzero), space


def _about_conics(claimed: Claimed, at: Space, limit: int) -> Proof:
    """The verdict on a claim about conics or quadrics: with points that are given on them in place of their own."""
    placed, letters = seated(claimed, at), conics_of(_names(claimed, at))
    with in_words(placed, letters, at.given):
        found = _decided(placed.claimed, placed.space, limit, placed)
    if found.counterexample is not None:
        places = {n: found.counterexample[p] for n, p in placed.places.items() if p in found.counterexample}
        return replace(found, counterexample={**found.counterexample, **places})
    if not found.proved:
        return found
    spoken = dict(zip(found.assumed, found.meanings or [""] * len(found.assumed), strict=True))
    told = placed.assumed(spoken, found.kinds)
    if told is None:
        return replace(
            found,
            verdict="undecided",
            method="random-points",
            reason=_UNSAID.format(listed(letters)),
            assumed=(),
            meanings=(),
            kinds=(),
        )
    told = {**told, **{r.text: r.meaning for r in claimed.required}}
    kinds = found.kinds if placed.alone is None else ()
    return replace(found, assumed=tuple(told), meanings=tuple(told.values()), kinds=kinds)


def _said(proof: Proof, placed: Seated) -> Proof:
    """The proof of one equation with its conditions in words about conics."""
    told = dict(filter(None, map(placed.spoken, proof.conditions)))
    return replace(proof, assumed=tuple(told), meanings=tuple(told.values()))


def _decided(claimed: Claimed, at: Space, limit: int, placed: Seated | Reciprocal | None = None) -> Proof:
    """The verdict on the claim as it is; of one that is `placed`, with conditions in words where it is about conics, as
    that of the claim that was made where it is about screws.
    """
    for r in claimed.required:
        if vanishes(r.expr, rank=at.rank, ideal=at.ideal, samples=2):
            raise InputError(f"{r.text} vanishes at all positions")
    nonzero = (*claimed.nonzero, *(r.expr for r in claimed.required))
    generic = isinstance(placed, Seated) and placed.generic
    parts: list[Proof] = []
    for number, (left, right) in enumerate(claimed.equations):
        summed = _summed(left, right, at, limit) if generic else None
        parts.append(
            summed
            or prove(
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
        if parts[-1].verdict == "undecided":
            parts[-1] = _summed(left, right, at, limit) or parts[-1]
        if isinstance(placed, Reciprocal):
            parts[-1] = placed.told(parts[-1], number)
        elif placed is not None:
            parts[-1] = _said(parts[-1], placed)
        if parts[-1].verdict == "refuted":
            break
    found = _told(_together(parts), claimed, at)
    return replace(found, dual=claimed.dual, relation=claimed.relation, parts=tuple(parts) if len(parts) > 1 else ())


def _summed(left: Expr, right: Expr, at: Space, limit: int) -> Proof | None:
    """The proof that both sides differ by numbers times what is given, without conditions; None where they do not."""
    difference = difference_of(left, right, at.rank)
    part = given_part(difference, at)
    if part is None or part == ZERO:
        return None
    found = prove(difference, part, points=at.points, ideal=at.ideal, rank=at.rank, limit=limit)
    return replace(found, left=left, right=right, given=at.given, reason=_SUMMED) if found.proved else None


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
