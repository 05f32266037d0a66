r"""Where expressions live: the rank, the points in tableau order, those at infinity, and what is assumed of them."""

from __future__ import annotations

from dataclasses import field

from gcrules.algebra.expr import Expr
from gcrules.algebra.letters import marked
from gcrules.algebra.metric import Infinity
from gcrules.algebra.names import NAME, NAMES_HINT
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError, Span

__all__ = ["MAX_NAMES", "RANKS", "Assumption", "SourcePlace", "Space", "Written", "shortened"]

RANKS = range(2, 9)
MAX_NAMES = 500

_SHOWN = 40  # characters of a word in a message


def shortened(word: str) -> str:
    return str(word) if len(word) <= _SHOWN else f"{word[:_SHOWN]}…"


@dataclass(frozen=True, slots=True)
class SourcePlace:
    """Where something stands: `span` of the text `source`, which came from the file `filename`."""

    span: Span
    source: str
    filename: str


@dataclass(frozen=True, slots=True)
class Written:
    """What is assumed or claimed, with polars in it as such (`polars`).

    `kind` is that of an `Assumption`, or "equal" of both sides of an equation; "on" of a point, and "touches" of a line
    or a plane, are said of the conic or quadric of a `letter`.
    """

    kind: str
    args: tuple[Expr, ...]
    letter: str = ""


@dataclass(frozen=True, slots=True)
class Assumption:
    """What is assumed of points: `kind` is collinear, coplanar, concurrent, incident, or zero (args[0] vanishes).

    `text` is the assumption as it was written, `place` where it was written, for messages, in which it has a `role`.
    Words that assumptions are made of say more of the positions that count: the expressions of `also` vanish at them,
    and those of `exists` do not. What is proved without that holds for them all the more. This is a part of what is
    `written`, where letters for conics or quadrics are declared.
    """

    kind: str
    args: tuple[Expr, ...]
    text: str
    place: SourcePlace | None = field(default=None, compare=False, repr=False)
    role: str = field(default="assumption", compare=False, repr=False)
    also: tuple[Expr, ...] = field(default=(), compare=False, repr=False)
    exists: tuple[Expr, ...] = field(default=(), compare=False, repr=False)
    written: tuple[Written, ...] = field(default=(), compare=False, repr=False)

    def __str__(self) -> str:
        return self.text


@dataclass(frozen=True, slots=True)
class Space:
    """`points` are declared in tableau order; `ideal` are the points at infinity; `given` holds what is assumed.

    `infinity` are those points at infinity by which right angles and lengths are known.
    Raises InputError for a rank outside 2 to 8 and for names that cannot name a point.
    """

    rank: int = 4
    points: tuple[str, ...] = ()
    ideal: tuple[str, ...] = ()
    given: tuple[Assumption, ...] = ()
    infinity: Infinity | None = None

    def __post_init__(self) -> None:
        if self.rank not in RANKS:
            raise InputError(f"rank {self.rank} is outside the supported ranks {RANKS[0]} to {RANKS[-1]}")
        for n in (*self.points, *self.ideal):
            if not NAME.fullmatch(n) and not marked(n):
                raise InputError(f"{shortened(n)!r} cannot name a point", hint=NAMES_HINT)
        if len(self.declared()) > MAX_NAMES:
            raise InputError(f"more than {MAX_NAMES} declared names")

    def declared(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys((*self.points, *self.ideal)))
