"""Points placed one after the other, at random modulo a prime, where conditions leave them room."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import field

from gcrules.algebra import expr as ex
from gcrules.algebra.assumptions.construction import Construction, ConstructionStep, Within, coordinates, step_on
from gcrules.algebra.assumptions.incidences import Helper, IncidenceCondition
from gcrules.algebra.assumptions.nondegeneracy import assumed, fewest
from gcrules.algebra.evaluate import PRIME, Evaluator, random_points
from gcrules.algebra.expr import Expr, Point, join, points_of
from gcrules.algebra.space import Assumption, Space
from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap
from gcrules.core.seeds import DRAWN, drawn

__all__ = ["Aim", "Failure", "Placement", "parallel"]

_NAME_IT = "name the common point: given incident(p, X), incident(p, Y)"


@dataclass(frozen=True)
class Aim:
    """The points of a space with what is `given` there, the equations that are `wanted` to hold by it, `extensors` that
    must not vanish, and `meets` that should not; with `lines` also by way of lines that are known (`on_known_lines`)
    and of quadrics.
    """

    space: Space
    wanted: tuple[Expr, ...]
    extensors: tuple[Expr, ...] = ()
    meets: tuple[Expr, ...] = ()
    lines: bool = False


class Failure(Exception):
    """An order of construction that leads nowhere: at which assumption, and why."""

    def __init__(self, depth: int, cause: Assumption, why: str, hint: str | None = None, *, tried: bool = True) -> None:
        super().__init__(why)
        self.depth, self.cause, self.why, self.hint, self.tried = depth, cause, why, hint, tried


@dataclass
class Placement:
    """The points placed so far, with random coordinates modulo the prime."""

    aim: Aim
    helpers: Mapping[str, Helper]
    values: dict[str, tuple[int, ...]]
    steps: list[ConstructionStep] = field(default_factory=list)
    causes: list[tuple[IncidenceCondition, ...]] = field(default_factory=list)
    rng: random.Random = field(default_factory=lambda: drawn("construction"))

    def __post_init__(self) -> None:
        self.at = Evaluator(self.values, self.aim.space.rank, PRIME)
        self.settled = 0  # values that do not depend on the point that is being placed, the first that `at` knows

    def zero(self, e: Expr) -> bool:
        return not any(self.at.value(e))

    def place(self, depth: int, name: str, conditions: tuple[IncidenceCondition, ...]) -> None:
        rank, self.settled = self.aim.space.rank, len(self.at.known)
        usable = sorted((c for c in conditions if name in c.within), key=lambda c: (not c.exact, c.within[name].step))
        within: Within | None = None
        used: list[IncidenceCondition] = []
        for c in usable:
            if within is not None:
                self.put(step_on(within, rank, exact=used[0].exact))
                if self.zero(c.equation):
                    continue
            s = c.within[name]
            if self.zero(s):
                continue
            smaller = Within(name, s, (s,)) if within is None else self.smaller(within, c, used[0].exact)
            if smaller is not None:
                within = smaller
                used.append(c)
        if within is None:
            step, used = self.on_quadric(depth, name, conditions)
        else:
            step = step_on(within, rank, exact=used[0].exact)
        self.put(step)
        for c in conditions:
            if not self.zero(c.equation):
                why = (
                    f"it asks too much of the point {name}"
                    if name in c.within
                    else "it is not linear in a point that the others leave free, nor does it follow from them"
                )
                raise Failure(depth, c.cause, why, "leave out an assumption, or name more points")
        self.check(depth, step, used)
        self.steps.append(step)
        self.causes.append(tuple(used))

    def on_quadric(
        self, depth: int, name: str, conditions: tuple[IncidenceCondition, ...]
    ) -> tuple[ConstructionStep, list[IncidenceCondition]]:
        """The second point of a quadric on a line through one that is placed."""
        for c in conditions:
            for known in c.through[name].known if name in c.through else ():
                if self.values.keys() >= {*points_of(known)}:
                    other = f"{name}:1"
                    parts = c.through[name].parts(known, other)
                    polar = c.through[name].polar(known, Point(name))
                    within = ex.add(*parts, rank=self.aim.space.rank)
                    return ConstructionStep(name, within, parts, (other,), False, (polar,)), [c]
        raise Failure(depth, conditions[0].cause, f"nothing is left on which {name} could lie")

    def smaller(self, within: Within, c: IncidenceCondition, exact: bool) -> Within | None:
        """Where a point lies that satisfies one more condition, if that can be told and is not nothing."""
        rank, s = self.aim.space.rank, c.within[within.name]
        if exact or c.exact:
            return None
        candidates = [within.met(s, rank)]
        for extra in range(1, rank):
            candidates += within.met_inside(s, rank, extra)
        for found in candidates:
            if found is not None and not any(self.zero(e) for e in found.nonzero):
                step = step_on(found, rank)
                self.put(step)
                if any(self.values[found.name]) and self.zero(c.equation):
                    return found
        return None

    def put(self, step: ConstructionStep) -> None:
        """Place a point, or place it anew."""
        rank, at = self.aim.space.rank, self.at
        if step.fresh:
            points = {**self.values, **random_points(step.fresh, rank=rank, seed=("fresh", len(self.steps)))}
            at = Evaluator(points, rank, PRIME)
        value = coordinates(step, at, lambda: self.rng.randrange(DRAWN))
        while len(self.at.known) > self.settled:
            self.at.known.popitem()
        self.values[step.name] = tuple(value)

    def check(self, depth: int, step: ConstructionStep, used: list[IncidenceCondition]) -> None:
        """Points stay what they are: not zero, at infinity or not as declared, and different from the others."""
        space, value, cause = self.aim.space, self.values[step.name], used[-1].cause
        if not any(value):
            raise Failure(depth, cause, f"no place is left for the point {step.name}")
        if step.name in self.helpers:
            return
        if step.name in space.ideal and value[-1]:
            hint = f"leave out `ideal {step.name}`, or say on which line or plane at infinity it lies"
            raise Failure(depth, cause, f"the point {step.name} at infinity would have to be a finite point", hint)
        if step.name not in space.ideal and not value[-1]:
            hint = f"declare it with `ideal {step.name}`"
            raise Failure(depth, cause, f"the finite point {step.name} would have to lie at infinity", hint)
        at = self.helpers.get(step.within.name) if isinstance(step.within, Point) else None
        within = step.within if at is None or at.meet is None else at.meet
        if used[0].exact or isinstance(within, Point):
            return  # so it was asked for
        for other, there in self.values.items():
            if (
                other != step.name
                and ":" not in other
                and parallel(value, there)
                and not _always_on(within, other, space)
            ):
                hint = "say so with == if that is meant"
                why = f"{other} and {step.name} would be one point"
                raise Failure(depth, cause, why, hint)

    def construction(self, free: tuple[str, ...], given_nonzero: Sequence[Expr]) -> Construction:
        """What was placed, with the extensors that must not vanish for it. Raises Failure where one of them does."""
        aim, space = self.aim, self.aim.space
        cause = self.causes[-1][-1].cause if self.causes else space.given[-1]
        nonzero = assumed(self.steps, given_nonzero, free, space.ideal, self.helpers, space.rank)
        if nonzero is None:
            raise Failure(len(self.steps), cause, "the common point of the lines needs a name", _NAME_IT)
        for e in (*nonzero, *aim.extensors):
            if self.zero(e):
                raise Failure(len(self.steps), cause, f"{e} would be zero", _NAME_IT)
        extensors = (*aim.extensors, *(e for e in aim.meets if not self.zero(e)))
        steps, meets = (
            tuple(self.steps),
            FrozenMap((h.name, h.meet) for h in self.helpers.values() if h.meet is not None),
        )
        return Construction(
            space.rank, free, space.ideal, steps, fewest(nonzero), aim.wanted, space.points, extensors, meets
        )


def _always_on(within: Expr, name: str, space: Space) -> bool:
    r"""Whether an extensor of step 1 is a multiple of a point whatever is assumed, as ab /\ ac is of a."""
    if within.step > 1:
        return False
    e = join(within, Point(name), rank=space.rank)
    return Construction(space.rank, points_of(e), space.ideal).vanishes(e)


def parallel(a: Sequence[int], b: Sequence[int]) -> bool:
    """Whether two vectors are proportional modulo `PRIME`."""
    return all((a[i] * b[j] - a[j] * b[i]) % PRIME == 0 for i in range(len(a)) for j in range(i))
