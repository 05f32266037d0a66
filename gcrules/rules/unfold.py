r"""Steps of a derivation as chains of single steps.

Both sides of a step are taken down by the elementary rules until they meet; the chain goes down the one side and up
the other: before = … = where they meet = … = after.

>>> from gcrules.algebra.language.syntax import parse
>>> step = Step("example", parse("[abde] * c + [bcde] * a"), parse(r"ac /\ bde"), "")
>>> for s in unfold(step):
...     print(s.after, f"({'up by' if s.upward else 'by'} {s.rule})")
[bcde] * a + [abde] * c (by sorting)
[abde] * c - [cbde] * a (up by sorting)
ac /\ bde (up by expansion)
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import pairwise

from gcrules.algebra.expr import Expr, Sum, mul
from gcrules.algebra.space import Space
from gcrules.core.budget import Count
from gcrules.core.errors import LimitReached
from gcrules.rules.elementary import ELEMENTARY
from gcrules.rules.instance import structures_in
from gcrules.rules.random_witness import RandomWitness
from gcrules.rules.rule import RewriteRule, Rule, StructureRule, reductions
from gcrules.rules.step import Step

__all__ = ["MAX_STEPS", "MAX_TERMS", "follows", "unfold"]

MAX_STEPS = 120
MAX_TERMS = 250
MAX_WORK = 2_000  # terms of all expressions that are passed while single steps are sought
"""Longer chains, and longer sums, are no help to a reader."""

_FOLDED = frozenset({"shortest-form", "straightening"})
"""Elementary rules that are more than one step."""

_TAKEN = frozenset({"catalog", "factorization", "forces-and-couples", "any-lines", "lines-written-out", "transversals"})
"""Rules whose proof stands elsewhere."""

_DOWN = ("vanishing", "dots", "sorting", "multiplying-out", "expansion", "superbracket")
_TACTICS: Mapping[str, tuple[tuple[str, ...], ...]] = {
    "shortest-form": (("reordering",),),
    "superbracket-16": (("superbracket-16", *_DOWN),),
    "tetrahedra": (("factoring-out", "sorting"),),
}
"""What is tried for the steps of a rule, each until all stay silent, before the rest of the road down."""

_LAST = "van-der-waerden"

_RULES: dict[str, RewriteRule] = {rule.id: rule for rule in ELEMENTARY}
_HINT = "the step holds as a whole"

_Trace = list[tuple[str, Expr]]  # the expressions passed, each with the rule that made it ("" for the first)


def unfold(
    step: Step, space: Space | None = None, rules: Iterable[Rule] = (), *, limit: int = MAX_STEPS
) -> tuple[Step, ...]:
    """The single steps that lead from `before` to `after`; the step itself if it is one.

    `rules` are known beside the elementary ones. Raises LimitReached beyond `limit` steps, `MAX_TERMS` terms, or
    `MAX_WORK` terms of all expressions together.
    """
    space = space or Space()
    known = _RULES | {r.id: r for r in rules if isinstance(r, RewriteRule)}
    if step.rule in _TAKEN or (step.rule not in _FOLDED and follows(step, space, known.values())):
        return (step,)
    work = Count(MAX_WORK, "this", "terms on the way", _HINT)
    own = [(step.rule,)] if step.rule in known and step.rule not in _RULES else []
    for tactic in (*own, *_TACTICS.get(step.rule, ()), _DOWN, (*_DOWN, _LAST)):
        chosen = [known[i] for i in tactic]
        down, up = (_trace(e, chosen, space, limit, work) for e in (step.before, step.after))
        met = _meeting(down, up)
        if met is not None:
            chain = _chain(down[: met[0] + 1], up[: met[1] + 1], known)
            if len(chain) > limit:
                raise LimitReached(f"it takes more than {limit} single steps", hint=_HINT)
            return chain
    raise LimitReached("no single steps were found", hint=_HINT)


def follows(step: Step, space: Space, rules: Iterable[Rule]) -> bool:
    """Whether the named rule makes `after` from `before` (the other way round in an upward step)."""
    source, target = (step.after, step.before) if step.upward else (step.before, step.after)
    rule = next((r for r in rules if r.id == step.rule), None)
    if isinstance(rule, StructureRule):
        return (source, target) in _read(rule, source, space)
    return isinstance(rule, RewriteRule) and rule.rewrite(source, space) == target


def _read(rule: StructureRule, e: Expr, space: Space) -> Iterator[tuple[Expr, Expr]]:
    """cofactor · superbracket and coefficient · expression, for the conditions of the legs in an expression."""
    for structure in structures_in(e, space):
        for c in rule.find(structure, RandomWitness(structure)):
            yield mul(c.cofactor, structure.superbracket), c.right_side


def _trace(e: Expr, rules: Sequence[RewriteRule], space: Space, limit: int, work: Count) -> _Trace:
    """The expression and what it becomes, step by step, by the first rule that fires, until all stay silent."""
    found = [("", e)]
    for rule, after in reductions(e, rules, space):
        found.append((rule.id, after))
        if len(found) > limit:
            raise LimitReached(f"it takes more than {limit} single steps", hint=_HINT)
        work.spend(len(after.terms) if isinstance(after, Sum) else 1)
        if isinstance(after, Sum) and len(after.terms) > MAX_TERMS:
            raise LimitReached(f"its single steps have more than {MAX_TERMS} terms", hint=_HINT)
    return found


def _meeting(down: _Trace, up: _Trace) -> tuple[int, int] | None:
    """Where two traces meet first, counted from both beginnings."""
    at: dict[Expr, int] = {}
    for i, (_, e) in enumerate(down):
        at.setdefault(e, i)
    return min(((at[e], j) for j, (_, e) in enumerate(up) if e in at), key=sum, default=None)


def _chain(down: _Trace, up: _Trace, known: Mapping[str, RewriteRule]) -> tuple[Step, ...]:
    """Down the first trace and up the second."""
    steps = [Step(rule, e, after, known[rule].sentence) for (_, e), (rule, after) in pairwise(down)]
    for (_, after), (rule, e) in reversed(list(pairwise(up))):
        steps.append(Step(rule, e, after, known[rule].sentence, upward=True))
    return tuple(steps)
