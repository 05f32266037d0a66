r"""How the poses of a robot are connected: which can be reached from which without a singularity.

Poses are drawn, and the assembly modes for the actuators' values at home are solved for. Poses in which the condition's
factors have different signs are in different aspects. Those of equal signs are joined by a search for ways between them
(`gcrules.poses.plans.roadmap`), and each way is proved by the exact path check. Sets that are left with equal signs may
or may not be connected.

>>> found = aspects("3-rpr", within="x -1..1, y -1..1, yaw -180..180 deg", poses=8)
>>> found.least, found.most, [s.pattern for s in found.sets]
(2, 2, ['-', '+'])
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gcrules.core.budget import checkpoint
from gcrules.core.budget import report as report_progress
from gcrules.core.english import lettered
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.solve import check_moves, free_coordinates
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.aspects.joining import Joiner
from gcrules.poses.aspects.report import Aspects, AspectSet, LeftOut
from gcrules.poses.everywhere import check_architecture
from gcrules.poses.methods import Methods, legs_within, method
from gcrules.poses.modes.modes import modes_of
from gcrules.poses.modes.report import AssemblyMode, AssemblyModes
from gcrules.poses.plans.domain import Domain, Place, search_in
from gcrules.poses.plans.leg_domain import LegDomain, leg_space
from gcrules.poses.plans.leg_space import row_of
from gcrules.poses.plans.limb_domain import LimbDomain, limb_space
from gcrules.poses.plans.plan import asked_margin, check_search
from gcrules.poses.signs.of_limbs import DETERMINANT
from gcrules.poses.signs.sign import SEEN, ConditionSign, signs_of
from gcrules.screws.pose import Pose
from gcrules.screws.pose_text import HOME

__all__ = ["POSES", "STATES", "aspects", "aspects_of"]

POSES = 40
STATES = 3000
_DRAWN = 64  # at once
_ROUNDS = 60  # of draws, until it is given up to find as many poses as were asked for
_SPREAD = 0.5  # sizes, and rad: of half the poses around home
_SINGULAR = "singular, or too close to it"
_BESIDE = "outside the region or the limits"


def aspects(
    source: Source,
    *,
    margin: float | None = None,
    limits: str | None = None,
    within: str | None = None,
    poses: int = POSES,
    modes: bool = True,
    states: int = STATES,
    seed: int = 0,
    about: str | Sequence[Any] = "centroid",
    plugins: Folders = (),
) -> Aspects:
    """In how many singularity-free parts (aspects) the poses of a robot lie, and which assembly modes share one.

    `source` and `about` are those of `pose`, `margin`, `limits` and `within` those of `plan`: poses and ways keep to
    them. So many `poses` are looked at beside home and, with `modes`, the assembly modes for the actuators' values at
    home. Of a robot of joints they are the configurations to which the straight ways from home lead. The search for
    ways ends at so many `states`; it is the same one for the same `seed`.

    Raises InputError for what is asked for wrongly, and where no pose keeps to it.
    """
    found = mechanism(source, about=about, plugins=plugins)
    return aspects_of(found, margin, limits, within, poses, states, seed, modes=modes)


def aspects_of(
    found: Mechanism,
    margin: float | None = None,
    limits: str | None = None,
    within: str | None = None,
    poses: int = POSES,
    states: int = STATES,
    seed: int = 0,
    *,
    modes: bool = True,
) -> Aspects:
    """The aspects of a mechanism; arguments and errors as for `aspects`."""
    asked = asked_margin(margin)
    check_search(states, seed)
    if not 1 <= poses <= states:
        raise InputError(f"{poses} poses, expected 1 to the number of states, {states:,}")
    every = modes_of(found) if modes else None
    domain = method(_DOMAIN, found, "the aspects")(asked, limits, within, every)
    random = np.random.default_rng(seed)
    starts = _Starts.of(domain, every)
    starts.draw(random, poses)
    if not starts.places:
        raise InputError("no pose was found that satisfies what is asked for", hint="widen --within, or ask for less")
    if len(starts.places) > states:
        raise InputError(f"{len(starts.places)} poses are more than the {states:,} states of the search")
    joiner = Joiner(domain, starts.places, starts.without_spare_signs())
    joiner.join(random, states)
    return _answer(domain, starts, joiner, every, seed)


class _Starts:
    """The poses that are looked at: `places`, their signs, and the numbers of the assembly modes among them."""

    def __init__(self, domain: Domain) -> None:
        self.domain = domain
        self.places: list[Place] = []
        self.signs: list[tuple[ConditionSign, ...]] = []
        self.modes: dict[int, int] = {}
        self.left_out: list[LeftOut] = []
        self.notes: tuple[str, ...] = ()

    @classmethod
    def of(cls, domain: Domain, modes: AssemblyModes | None) -> _Starts:
        """Home, and the assembly modes."""
        found = cls(domain)
        if reason := found._take(domain.home()):
            found.left_out.append(LeftOut(HOME, reason))
        for mode in _listed(modes):
            if mode.given:
                if found.places:
                    found.modes[0] = mode.number
                continue
            place = domain.place_of(mode)
            reason = place if isinstance(place, str) else found._take(place)
            if reason:
                found.left_out.append(LeftOut(f"mode {mode.number}", reason))
            else:
                found.modes[len(found.places) - 1] = mode.number
        return found

    def without_spare_signs(self) -> list[str]:
        """The patterns of the signs, of which the determinant is left out where the others tell as much."""
        number = len(set(map(signs_of, self.signs)))
        if len({signs_of(s for s in own if s.proved) for own in self.signs}) < number:
            self.notes = (SEEN,)
        short = [tuple(s for s in own if s.expression != DETERMINANT) for own in self.signs]
        if short[0] and len(set(map(signs_of, short))) == number:
            self.signs = short
        return [signs_of(own) for own in self.signs]

    def draw(self, random: Any, number: int) -> None:
        """So many more poses at random, if they are met."""
        home = self.domain.home().row
        least = len(self.places) + number
        for _ in range(_ROUNDS):
            checkpoint()
            report_progress(f"{len(self.places)} poses")
            drawn = self.domain.space.drawn(random, _DRAWN, np.stack([home, home]), _SPREAD)
            for place in self.domain.places(random.permutation(drawn)):
                if len(self.places) == least:
                    return
                self._take(place)

    def _take(self, place: Place) -> str:
        """Look at this pose too; why not, if it does not keep to what is asked for."""
        space, row = self.domain.space, place.row[None]
        if not space.good(row)[0]:
            inside = space.region.holds(space.coordinates(row))[0]
            inside = inside and (space.limits is None or bool(space.limits.allow(space.reach(row))[0]))
            return _SINGULAR if inside else _BESIDE
        signs = self.domain.signs(place)
        if not all(s.sign for s in signs):
            return _SINGULAR
        self.places.append(place)
        self.signs.append(signs)
        return ""


def _answer(domain: Domain, starts: _Starts, joiner: Joiner, modes: AssemblyModes | None, seed: int) -> Aspects:
    rows = np.stack([p.row for p in starts.places])
    margins = domain.space.margins(rows)
    sets = []
    for n, part in enumerate(joiner.sets()):
        best = max(part, key=lambda k: float(margins[k]))
        sets.append(
            AspectSet(
                name=lettered(n),
                signs=starts.signs[best],
                poses=tuple(part),
                modes=tuple(sorted(starts.modes[k] for k in part if k in starts.modes)),
                witness=starts.places[best].pose,
                margin=float(margins[best]),
            )
        )
    return Aspects(
        title=domain.m.title,
        unit=domain.m.unit,
        asked=domain.asked,
        proved=all(j.proved for j in joiner.joins),
        poses=tuple(p.pose for p in starts.places),
        sets=tuple(sets),
        joins=tuple(joiner.joins),
        modes=modes,
        left_out=tuple(starts.left_out),
        search=search_in(domain, joiner.states, seed),
        notes=(*domain.notes, *starts.notes),
    )


def _of_legs(
    m: SixLegs, asked: float, limits: str | None, within: str | None, modes: AssemblyModes | None
) -> LegDomain:
    check_architecture(m)
    rows = np.stack([row_of(p) for p in (Pose(), *(mode.pose for mode in _listed(modes)))])
    return LegDomain(m, asked, leg_space(m, rows, asked, limits, within))


def _of_limbs(m: Limbs, asked: float, limits: str | None, within: str | None, modes: AssemblyModes | None) -> Domain:
    if (legs := legs_within(m, limits)) is not None:
        return _of_legs(legs, asked, limits, within, modes)
    check_moves(m.linkage)
    names = free_coordinates(m.linkage)
    bare = LimbDomain(m, asked, limb_space(m, names, (), asked, limits, within))
    reached = [place.pose for mode in _listed(modes) if isinstance(place := bare.place_of(mode), Place)]
    poses = [pose for pose in reached if isinstance(pose, Mapping)]
    return LimbDomain(m, asked, limb_space(m, names, poses, asked, limits, within))


def _listed(modes: AssemblyModes | None) -> Sequence[AssemblyMode]:
    return modes.modes if modes is not None else ()


_DOMAIN: Methods[Domain] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""What ways are sought in, for each kind of mechanism: a region around home and its assembly modes."""
