r"""Rules as they are written: `rule ID "sentence": LHS => RHS if …`, in every rank in which they make sense."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from gcrules.algebra import expr as ex
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.parse_tree import Node, run_name, span_of
from gcrules.algebra.language.relation_words import RELATIONS
from gcrules.algebra.language.relations import read_assumptions
from gcrules.algebra.language.syntax import Builder, Context
from gcrules.algebra.letters import letter_of
from gcrules.algebra.names import step_name
from gcrules.algebra.space import RANKS, Assumption, shortened
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import GcrulesError, InputError, Span, StepError
from gcrules.core.frozen import FrozenMap

__all__ = ["Case", "Instance", "Order", "RuleText", "instances"]


@dataclass(frozen=True, slots=True)
class Order:
    """A guard on two points: the first comes before the second in tableau order (`<`), or they differ (`!=`)."""

    left: str
    sign: str
    right: str

    def __str__(self) -> str:
        return f"{self.left} {self.sign} {self.right}"


@dataclass(frozen=True, slots=True)
class Instance:
    """A rule in one rank: left = right where the guards hold. `runs` gives the points that each run stands for."""

    rank: int
    left: Expr
    right: Expr
    guards: tuple[Order | Assumption, ...] = ()
    runs: Mapping[str, tuple[str, ...]] = FrozenMap()

    @property
    def given(self) -> tuple[Assumption, ...]:
        """The guards under which the two sides are equal; the others only choose where the rule is applied."""
        return tuple(g for g in self.guards if isinstance(g, Assumption))


@dataclass(frozen=True, slots=True)
class Case:
    """An expression on which a rule is to fire, or to stay silent."""

    expr: Expr
    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class RuleText:
    """`rule ID "sentence": LHS => RHS if …` as written: an instance for each rank in which it makes sense."""

    id: str
    sentence: str
    source: str
    text: str
    instances: tuple[Instance, ...]
    fires: tuple[Case, ...]
    silent: tuple[Case, ...]
    span: Span
    line: int
    context: Context


def instances(
    context: Context, any_rank: bool, left: Node, right: Node, guards: list[Node], source: Callable[[Node], str]
) -> Iterator[Instance]:
    """The rule in each rank in which its runs have a length; in the rank of the file where it has none, or letters."""
    trees = [left, right, *guards]
    runs = {run_name(t): t for tree in trees for t in _subtrees(tree, "run")}
    names = {n for tree in trees for t in _subtrees(tree, "word") for n, _ in Builder(context).split(t.children[0])}
    clash = next((n for n in sorted(names) for r in runs if n != r and n.rstrip("0123456789") == r), None)
    if clash:
        raise InputError(f"{clash} is a point of the run {clash.rstrip('0123456789')}... too", span=span_of(left))
    on_the_left = {run_name(t) for t in _subtrees(left, "run")}
    for name, tree in runs.items():
        if name not in on_the_left:
            raise InputError(f"unbound run {name}...: not on the left side of the rule", span=span_of(tree))
    faults: list[GcrulesError] = []
    found = False
    letters = {n: k for n, k in context.letters.items() if n in names}
    for rank in RANKS if runs and any_rank and not letters else [context.rank]:
        space = Context(rank, context.points, letters=letters)
        try:
            lengths = _lengths(trees, runs, Builder(space))
            if lengths is None:
                continue
            points = {name: tuple(f"{name}{i + 1}" for i in range(n)) for name, n in lengths.items()}
            yield _instance(space, points, left, right, guards, source)
            found = True
        except GcrulesError as fault:
            faults.append(fault)
    if not found:
        raise faults[-1] if faults else InputError("no rank gives these runs a length")


def _instance(
    space: Context,
    runs: Mapping[str, tuple[str, ...]],
    left: Node,
    right: Node,
    guards: list[Node],
    source: Callable[[Node], str],
) -> Instance:
    """A rule in one space, its runs of points written out."""
    builder = Builder(space, runs)
    before, after = builder.value(left), builder.value(right)
    if before.step != after.step and ex.ZERO not in (before, after):
        names = (step_name(after.step, space.rank), step_name(before.step, space.rank))
        raise StepError(f"{names[0]} cannot replace {names[1]}", span=span_of(right))
    bound = {*ex.points_of(before)}
    found: list[Order | Assumption] = []
    for tree in guards:
        if tree.data in ("before", "differ"):
            one, other = (str(t) for t in tree.children)
            for token in tree.children:
                if str(token) not in bound:
                    raise InputError(f"{shortened(token)} is not a point of the left side", span=span_of(token))
            found.append(Order(one, "<" if tree.data == "before" else "!=", other))
        elif tree.data == "at_infinity":
            raise InputError("a rule cannot ask for points at infinity", span=span_of(tree))
        elif tree.data == "relation" and (word := RELATIONS.get(str(tree.children[0]))) and word.metric:
            raise InputError(f"a rule cannot ask for {word.usage}: it knows no points at infinity", span=span_of(tree))
        else:
            for assumed in read_assumptions(tree, builder, source(tree)):
                _check_bound(assumed.args, bound, tree)
                found.append(assumed)
    _check_bound((after,), bound, right)
    return Instance(space.rank, before, after, tuple(found), FrozenMap(runs))


def _check_bound(exprs: tuple[Expr, ...], bound: set[str], tree: Node) -> None:
    unbound = [n for n in ex.points_of(*exprs) if n not in bound]
    loose = tuple(dict.fromkeys(of[0] if (of := letter_of(n)) is not None else n for n in unbound))
    if loose:
        what = "letter" if any(map(letter_of, unbound)) else "point"
        what += "s" * (len(loose) > 1)
        raise InputError(
            f"unbound {what} {', '.join(loose)}: not on the left side of the rule",
            span=span_of(tree),
            hint="every point and every letter of the right side and of the guards has to stand on the left",
        )


def _lengths(trees: list[Node], runs: Mapping[str, Node], builder: Builder) -> dict[str, int] | None:
    """The number of points in each run, so that every bracket is full; None where a length would be negative."""
    rows = []
    for bracket in (b for tree in trees for b in _subtrees(tree, "bracket")):
        parts = [
            p for child in bracket.children for p in (child.children if child.data == "juxtaposition" else [child])
        ]
        if all(p.data in ("word", "dotted_word", "run") for p in parts):
            points = sum(len(builder.split(p.children[0])) for p in parts if p.data != "run")
            rows.append(([run_name(p) for p in parts if p.data == "run"], builder.rank - points, bracket))
    known: dict[str, int] = {}
    for _ in runs:
        for names, room, _tree in rows:
            open_runs = [n for n in names if n not in known]
            if len(open_runs) == 1:
                known[open_runs[0]] = room - sum(known[n] for n in names if n in known)
    for name, tree in runs.items():
        if name not in known:
            raise InputError(f"no bracket tells how many points {name}... stands for", span=span_of(tree))
    if any(n < 0 for n in known.values()):
        return None
    for names, room, tree in rows:
        if names and sum(known[n] for n in names) != room:
            raise StepError(f"the runs of this bracket do not fill it in rank {builder.rank}", span=span_of(tree))
    return known


def _subtrees(tree: Node, kind: str) -> Iterator[Node]:
    if not hasattr(tree, "data"):
        return
    for t in tree.iter_subtrees_topdown():
        if t.data == kind:
            yield t
