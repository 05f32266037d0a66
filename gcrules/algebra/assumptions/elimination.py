"""The order in which points are constructed: every condition is solved for the last of its points.

Orders are found from the end: a point can come last if all conditions that it occurs in can be solved for it. In
general position a point of rank d takes part in at most d − 1 of them; what is more must follow from the others.
"""

from __future__ import annotations

from collections.abc import Container, Iterator, Sequence

from gcrules.algebra.assumptions.incidences import IncidenceCondition
from gcrules.core.budget import checkpoint

__all__ = ["MAX_WORK", "Turn", "orders"]

MAX_WORK = 200_000  # conditions of points that are looked at

Turn = tuple[str, tuple[IncidenceCondition, ...]]
_Last = tuple[Turn, frozenset[int], int]  # with what it asks for beyond what there is room for


def orders(
    conditions: Sequence[IncidenceCondition],
    points: Sequence[str],
    late: Sequence[str],
    rank: int,
    barren: Container[Turn] = (),
) -> Iterator[Iterator[list[Turn]]]:
    """Orders of construction: the constructed points, each with its conditions. They come in groups, first those of
    which no point takes part in more than there is room for, then those with one condition too many, and so on.

    `points` are in tableau order; the later ones are constructed rather than the earlier ones, those of `late` (points
    at infinity, say) only where nothing else will do. Orders with a turn of `barren` are left out, a set that may
    grow meanwhile.
    """
    search = _Search(conditions, points, late, rank, barren)
    most = sum(rank for _ in conditions)
    for excess in range(most + 1):
        yield (found[::-1] for found in search.ends(frozenset(range(len(conditions))), excess))
        if search.work > MAX_WORK:
            return


class _Search:
    def __init__(
        self,
        conditions: Sequence[IncidenceCondition],
        points: Sequence[str],
        late: Sequence[str],
        rank: int,
        barren: Container[Turn],
    ) -> None:
        self.conditions = conditions
        self.barren = barren
        self.rank = rank
        self.work = 0
        self.dead: set[tuple[frozenset[int], int]] = set()
        self.last: dict[frozenset[int], tuple[int, list[_Last]]] = {}
        self.holding = {n: frozenset(i for i, c in enumerate(conditions) if n in c.names) for n in points}
        place = {n: i for i, n in enumerate(points)}
        self.preference = {n: (n in late, -i) for n, i in place.items()}

    def ends(self, remaining: frozenset[int], excess: int) -> Iterator[list[Turn]]:
        """The turns, last point first, that ask for exactly `excess` more than there is room for."""
        if not remaining:
            if not excess:
                yield []
            return
        if self.work > MAX_WORK or (remaining, excess) in self.dead:
            return
        fruitful = False
        checkpoint()
        if remaining not in self.last:
            self.last[remaining] = self._last(remaining)
        work, turns = self.last[remaining]
        self.work += work
        for turn, at, over in turns:
            if over > excess or turn in self.barren:
                continue
            for rest in self.ends(remaining - at, excess - over):
                fruitful = True
                yield [turn, *rest]
                if turn in self.barren:
                    break
        if not fruitful:
            self.dead.add((remaining, excess))

    def _last(self, remaining: frozenset[int]) -> tuple[int, list[_Last]]:
        """The turns that can come last where these conditions remain, the preferred ones first; and how many conditions
        of points were looked at.
        """
        work = 0
        found = []
        for name in {n for i in remaining for n in self.conditions[i].names}:
            checkpoint()
            at = remaining & self.holding[name]
            work += len(at)
            turn = tuple(self.conditions[i] for i in sorted(at))
            asked, over = self._asked(name, turn)
            if asked:
                late, place = self.preference[name]
                found.append(((late, asked, place), ((name, turn), at, over)))
        return work, [last for _, last in sorted(found, key=lambda item: item[0])]

    def _asked(self, name: str, turn: tuple[IncidenceCondition, ...]) -> tuple[int, int]:
        """How many linear conditions are solved for a point, and how much that is beyond general position.

        Those of one assumption count once: most often they follow from each other.
        """
        asked: dict[str, int] = {}
        over = 0
        curved = [c for c in turn if name in c.through]
        for c in turn:
            if [c] == curved == list(turn):
                asked[c.cause.text] = 1
            elif name in c.within:
                codimension = 1 if c.exact else self.rank - c.within[name].step
                asked[c.cause.text] = max(asked.get(c.cause.text, 0), codimension)
            else:
                over += 1
        total = sum(asked.values())
        return total, over + max(0, total - (self.rank - 1))
