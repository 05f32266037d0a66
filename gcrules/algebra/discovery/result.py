"""What was discovered, as values."""

from __future__ import annotations

from dataclasses import field
from typing import Any

from gcrules.algebra.space import Assumption
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown

__all__ = ["Discoveries", "Discovery", "KindOfPositions"]


@dataclass(frozen=True)
class KindOfPositions:
    """One kind of positions that the assumptions allow: at which the scalars of `where` vanish. `assumed` must not
    vanish, in words where there are short ones (`meanings`); of those that were `tried`, positions where they vanish
    were found and looked at. `together` are points that are one, `vanishing` names that stand for zero there.
    """

    where: tuple[str, ...]
    assumed: tuple[str, ...]
    meanings: tuple[str, ...] = field(default=(), compare=False, repr=False)
    tried: tuple[str, ...] = ()
    together: tuple[tuple[str, str], ...] = ()
    vanishing: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """`{where, assumed, tried, together, vanishing}`."""
        return {
            "where": list(self.where),
            "assumed": list(self.assumed),
            "tried": list(self.tried),
            "together": list(map(list, self.together)),
            "vanishing": list(self.vanishing),
        }


@dataclass(frozen=True)
class Discovery:
    """An incidence: its `relation`, and the `claim` as scripts write it. `equations` are texts in the points of the
    script, where there are conics or quadrics in its names, that all vanish where it holds, `verdicts` those for the
    kinds of positions, in their order: proved, refuted or undecided (`reason`). It fails at some positions at which an
    extensor of `fails` vanishes, one that is assumed not to; of the others nothing is said. `names` occur in it,
    `defined` of them by `let`.
    """

    relation: str
    claim: str
    names: tuple[str, ...]
    defined: int
    equations: tuple[str, ...]
    verdicts: tuple[str, ...]
    fails: tuple[str, ...] = ()
    reason: str = ""

    @property
    def verdict(self) -> str:
        """Proved (for all kinds), partly proved (for some, and refuted for the others), or undecided."""
        if "undecided" in self.verdicts:
            return "undecided"
        return "partly proved" if "refuted" in self.verdicts else "proved"

    def to_json(self) -> dict[str, Any]:
        """`{relation, claim, names, defined, equations, verdict, verdicts, fails, reason}`."""
        return {
            "relation": self.relation,
            "claim": self.claim,
            "names": list(self.names),
            "defined": self.defined,
            "equations": list(self.equations),
            "verdict": self.verdict,
            "verdicts": list(self.verdicts),
            "fails": list(self.fails),
            "reason": self.reason,
        }


@dataclass(frozen=True)
class Discoveries(Shown):
    """What was `found` in a figure with these `points`, lines or planes (`flats`) and letters of `conics`, in space
    quadrics, the most telling first: those of most names bound by `let`, then the smallest. `candidates` are the sets
    that were looked at, at `samples` random positions of each of the `kinds`; `trivial` of those that hold were left
    out.
    """

    found: tuple[Discovery, ...]
    kinds: tuple[KindOfPositions, ...]
    points: tuple[str, ...]
    flats: tuple[str, ...]
    relations: tuple[str, ...]
    candidates: int
    trivial: int
    samples: int
    conics: tuple[str, ...] = ()
    rank: int = field(default=4, compare=False, repr=False)
    ideal: tuple[str, ...] = field(default=(), compare=False, repr=False)
    given: tuple[Assumption, ...] = field(default=(), compare=False, repr=False)

    @property
    def verdict(self) -> str:
        """undecided if one of them is, else proved."""
        return "undecided" if any(d.verdict == "undecided" for d in self.found) else "proved"

    def to_json(self) -> dict[str, Any]:
        """`{verdict, found [{relation, claim, …}], kinds [{where, …}], points, flats, conics, relations, candidates,
        trivial, samples}`.
        """
        return {
            "verdict": self.verdict,
            "found": [d.to_json() for d in self.found],
            "kinds": [k.to_json() for k in self.kinds],
            "points": list(self.points),
            "flats": list(self.flats),
            "conics": list(self.conics),
            "relations": list(self.relations),
            "candidates": self.candidates,
            "trivial": self.trivial,
            "samples": self.samples,
        }
