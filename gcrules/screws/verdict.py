r"""regular | close | singular: the one place where a margin becomes a word, nothing else decides it.

>>> decide(0.3), decide(0.00872), decide(0.00873), decide(3e-10), decide(1e-13)
('regular', 'close', 'regular', 'close', 'singular')
"""

from __future__ import annotations

from typing import Any

from gcrules.screws.threshold import DEFAULT, margin_of

__all__ = ["CLOSE", "FLOOR", "SOLVED", "VERDICTS", "decide", "rank"]

assert DEFAULT.angle is not None
CLOSE = margin_of(DEFAULT.angle)
"""Below this σ a pose is called close to singular: a leg's turn by half a degree may lead to a singular pose (an
example; choose your own for a real robot, `gcrules pose --threshold`)."""

FLOOR = 1e-12
"""At most this σ is 0 within rounding, where nothing better is known of the errors of the numbers (`noise` is)."""

SOLVED = 1e-9
"""At most this σ is 0 where joints are solved for: their loops are closed up to that part of the robot's size, and
neither a verdict nor a search for singular configurations can know more."""

VERDICTS = ("singular", "close", "regular")


def rank(sigma: Any, floor: Any = FLOOR, spread: Any = 0.0, close: float = CLOSE) -> Any:
    """The number in `VERDICTS` of a margin σ, or of each of an array.

    Singular up to `floor`, which is what rounding may do to σ; regular from `close` on, even if σ is wrong by `spread`.
    """
    return (sigma > floor) * (1 + (sigma - spread >= close))


def decide(sigma: float, floor: float = FLOOR, spread: float = 0.0, close: float = CLOSE) -> str:
    """The word for one σ, by `rank`."""
    return VERDICTS[rank(sigma, floor, spread, close)]
