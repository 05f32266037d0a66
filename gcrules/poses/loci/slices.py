"""Over which coordinates a mechanism has a locus as a polynomial, as far as that is known before it is worked out.

>>> from gcrules.mechanisms.mechanism import mechanism
>>> slices(mechanism("3-rps")), slices(mechanism("8-cables"))
([('z', 'roll'), ('z', 'pitch'), ('roll', 'pitch')], [])
"""

from __future__ import annotations

from itertools import combinations

from gcrules.core.errors import InputError
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.loci.closed_form import why_none
from gcrules.poses.loci.limb_question import limb_question
from gcrules.poses.loci.variables import TRANSLATION
from gcrules.poses.methods import Methods, as_six_legs, method
from gcrules.screws.pose_text import SHIFTS, TURNS

__all__ = ["slices", "why_no_locus"]


def slices(m: Mechanism) -> list[tuple[str, str]]:
    """The pairs of coordinates that can be its variables: of platforms on six legs, of which the turn has no angles
    among them, shifts only; of robots of joints those that its other coordinates leave free. None where there is no
    locus.
    """
    return method(_SLICES, as_six_legs(m) or m, "the locus")()


def why_no_locus(m: Mechanism) -> str:
    """Why it has no polynomial whatever the coordinates; "" where one may be had."""
    return why_none(m) if isinstance(m, Limbs) and as_six_legs(m) is None else ""


def _asks(m: Limbs, pair: tuple[str, str]) -> bool:
    try:
        limb_question(m.linkage, pair, None, None, "quaternion")
    except InputError:
        return False
    return True


def _of_limbs(m: Limbs) -> list[tuple[str, str]]:
    return [] if why_none(m) else [pair for pair in combinations((*SHIFTS, *TURNS), 2) if _asks(m, pair)]


_SLICES: Methods[list[tuple[str, str]]] = {
    SixLegs: lambda m: list(combinations(TRANSLATION, 2)),
    Limbs: _of_limbs,
}
