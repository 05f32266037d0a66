"""What the algebra says, against the exact oracle: equal expressions have equal values at random points."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from random import Random
from typing import Any

from ..case import Case
from ..grammar import LETTERS, UNUSUAL, Grammar, legs
from ..jail import Jail
from ..running import Outcome, run_call
from .family import Family

__all__ = ["IDENTITIES"]

_KINDS = {
    "expand": 5.0,
    "straighten": 5.0,
    "text": 3.0,
    "prove": 6.0,
    "given": 4.0,
    "rewrite": 0.5,
    "factor": 0.3,
    "shorten": 0.3,
    "analyze": 0.4,
}


def identity(rng: Random) -> Case:
    g = Grammar.drawn(rng)
    kind = rng.choices(list(_KINDS), list(_KINDS.values()))[0]
    ideal = rng.sample(g.names, rng.randint(1, 4 if len(g.names) > 4 else 1)) if rng.random() < 0.25 else []
    data: dict[str, Any] = {"kind": kind, "rank": g.rank, "ideal": ideal, "seed": rng.randrange(2**32)}
    match kind:
        case "prove":
            data["text"] = g.equation(rng.choice((0, 1, 1, 2)))
        case "given":
            data |= {"text": g.equation(rng.choice((0, 1))), "given": g.assumptions(), "ideal": []}
        case "analyze":
            data |= {"text": legs(rng, number=6), "ideal": []}
        case "factor" | "shorten":
            data |= {"text": g.scalar(1), "ideal": []}
        case "rewrite":
            data |= {"text": g.scalar(1), "ideal": [], "rules": rng.choice(("expansion", "exchange", "contract"))}
        case _:
            data["text"] = g.extensor(rng.choice((0, 0, 0, 1, 2)) % g.rank, rng.choice((1, 1, 2)))
    return Case("identities", data=data)


def run(case: Case, jail: Jail) -> Outcome:
    return run_call(case, jail, lambda: list(_CHECKS[case.data["kind"]](case.data)))


# --- what must hold ------------------------------------------------------------------------------------------------


def _context(data: Mapping[str, Any]) -> Any:
    from gcrules.algebra.language.syntax import Context

    return Context(data["rank"], (), tuple(data["ideal"]))


def _values(e: Any, points: Mapping[str, Any], rank: int) -> list[Any]:
    from gcrules.algebra.evaluate import PRIME, Evaluator

    return [v % PRIME for v in Evaluator(points, rank, PRIME).value(e)]


def _equal(left: Any, right: Any, data: Mapping[str, Any]) -> bool:
    """Whether two expressions have equal values at two random points; zero stands for any step."""
    from gcrules.algebra.evaluate import random_points

    names = (*LETTERS, *LETTERS.upper(), *UNUSUAL)
    for n in range(2):
        points = random_points(names, rank=data["rank"], ideal=data["ideal"], seed=data["seed"] + n)
        one, other = (_values(e, points, data["rank"]) for e in (left, right))
        if (any(one) or any(other)) and one != other:
            return False
    return True


def _expand(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc
    from gcrules.algebra.language.syntax import parse

    e = parse(data["text"], context=_context(data))
    found = gc.expand(e, rank=data["rank"], ideal=data["ideal"])
    if not _equal(e, found.to_expr(), data):
        yield "expand changes the value"
    if gc.expand(found.to_expr(), rank=data["rank"], ideal=data["ideal"]).to_expr() != found.to_expr():
        yield "expand of what was expanded is something else"


def _straighten(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc
    from gcrules.algebra.language.syntax import parse

    e = parse(data["text"], context=_context(data))
    found = gc.straighten(e, rank=data["rank"], ideal=data["ideal"])
    if not _equal(e, found.to_expr(), data):
        yield "straighten changes the value"
    if gc.straighten(found) != found:
        yield "straighten of a normal form is something else"


def _text(data: Mapping[str, Any]) -> Iterator[str]:
    from gcrules.algebra.language.syntax import parse
    from gcrules.algebra.language.text import text
    from gcrules.views.formulas.latex import latex

    at = _context(data)
    e = parse(data["text"], context=at)
    for unicode in (False, True):
        if parse(text(e, unicode=unicode), context=at) != e:
            yield f"text that is read back is something else: {text(e, unicode=unicode)}"
    if latex(e).count("{") != latex(e).count("}"):
        yield "unbalanced braces in LaTeX"


def _prove(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc
    from gcrules.algebra.language.syntax import parse_equation

    left, right = parse_equation(data["text"], context=_context(data))
    proof = gc.prove(data["text"], rank=data["rank"], ideal=data["ideal"])
    equal = _equal(left, right, data)
    if (proof.verdict == "proved" and not equal) or (proof.verdict == "refuted" and equal):
        yield f"{proof.verdict}, but the sides are {'' if equal else 'not '}equal at random points"
    if proof.verdict == "undecided":
        yield "undecided within the usual limits"
    yield from _counterexample(proof, left, right, data)


def _counterexample(proof: Any, left: Any, right: Any, data: Mapping[str, Any]) -> Iterator[str]:
    from gcrules.algebra.evaluate import Evaluator

    if proof.verdict != "refuted":
        return
    at = Evaluator(proof.counterexample, data["rank"])
    one, other = at.value(left), at.value(right)
    if one == other or (not any(one) and not any(other)):
        yield "the sides agree at the counterexample"
    for name, xyz in proof.counterexample.items():
        if not any(xyz):
            yield "a point of the counterexample is no point: all coordinates are zero"
        if name in data["ideal"] and xyz[-1]:
            yield "a point at infinity of the counterexample is finite"


def _given(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc
    from gcrules.algebra.language.statements import parse_assumption
    from gcrules.algebra.language.syntax import parse_equation

    at = parse_assumption(data["given"], _context(data))
    left, right = parse_equation(data["text"], context=at)
    proof = gc.prove(data["text"], rank=data["rank"], given=data["given"])
    yield from _counterexample(proof, left, right, {**data, "ideal": at.ideal})
    if proof.verdict == "refuted":
        for assumption in at.given:
            if not _holds(assumption, proof.counterexample, data["rank"]):
                yield f"the counterexample is against the assumption: {assumption.kind}"
    renamed = _renamed(data)
    other = gc.prove(renamed["text"], rank=data["rank"], given=renamed["given"])
    if {proof.verdict, other.verdict} == {"proved", "refuted"}:
        yield f"the verdict depends on the names: {proof.verdict}, and {other.verdict} where {renamed['names']}"


def _renamed(data: Mapping[str, Any]) -> dict[str, str]:
    """The same with the points' names exchanged."""
    names = sorted({w for w in _WORD.findall(data["text"] + data["given"]) if len(w) == 1})
    others = dict(zip(names, Random(data["seed"]).sample(names, len(names)), strict=True))
    found = {k: _WORD.sub(lambda m: others.get(m[0], m[0]), data[k]) for k in ("text", "given")}
    return found | {"names": str(others)}


_WORD = re.compile(r"collinear|coplanar|concurrent|incident|ideal|[a-n]")


def _holds(assumption: Any, points: Mapping[str, Any], rank: int) -> bool:
    """Whether exact points satisfy what is assumed: by ranks of matrices for points, by the oracle for equations."""
    from gcrules.algebra.evaluate import Evaluator

    def matrix_rank(rows: list[list[Any]]) -> int:
        from sympy import Matrix, Rational

        return int(Matrix([[Rational(str(c)) for c in row] for row in rows]).rank()) if rows else 0

    known = {n: points.get(n) for a in assumption.args for n in _names(a)}
    if any(v is None for v in known.values()):
        return True
    at = Evaluator(known, rank)
    values = [at.value(a) for a in assumption.args]
    match assumption.kind:
        case "zero":
            return not any(values[0])
        case "collinear":
            return matrix_rank(values) <= 2
        case "coplanar":
            return matrix_rank(values) <= 3
    return True


def _names(e: Any) -> tuple[str, ...]:
    from gcrules.algebra.expr import points_of

    return tuple(points_of(e))


def _rewrite(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc

    e = gc.parse(data["text"], rank=data["rank"])
    found = gc.rewrite(e, [data["rules"]], rank=data["rank"])
    if not _equal(e, found.after, data):
        yield "rewrite changes the value"


def _factor(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc
    from gcrules.algebra.language.syntax import parse

    e = parse(data["text"], context=_context(data))
    found = gc.factor(e, rank=data["rank"], seconds=0.3)
    whole = found.to_expr()
    if whole is not None and not _equal(e, whole, data):
        yield "factor changes the value"


def _shorten(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc
    from gcrules.algebra.language.syntax import parse

    e = parse(data["text"], context=_context(data))
    found = gc.shorten(e, rank=data["rank"], seconds=0.3)
    if not _equal(e, found.polynomial.to_expr(), data):
        yield "shorten changes the value"
    if found.terms > len(gc.expand(e, rank=data["rank"])):
        yield "shorten makes it longer"
    if found.lower > found.terms:
        yield "shorten has more terms excluded than it needs"


def _analyze(data: Mapping[str, Any]) -> Iterator[str]:
    import gcrules as gc

    found = gc.analyze(data["text"], search=0)
    for c in (found.condition, *found.readings):
        if c.kind == "always-singular":
            if not _equal(found.structure.superbracket, gc.parse("0"), {**data, "rank": 4}):
                yield "always singular, but the superbracket is not zero"
        elif not _equal(c.identity(found.structure.superbracket), gc.parse("0"), {**data, "rank": 4}):
            yield f"the identity of the condition does not hold: {c.kind}"


_CHECKS: Mapping[str, Callable[[Mapping[str, Any]], Iterator[str]]] = {
    "expand": _expand,
    "straighten": _straighten,
    "text": _text,
    "prove": _prove,
    "given": _given,
    "rewrite": _rewrite,
    "factor": _factor,
    "shorten": _shorten,
    "analyze": _analyze,
}

IDENTITIES = Family(
    "identities", "what the algebra says, against the exact oracle at random points", identity, run, share=2
)
