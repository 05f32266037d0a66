"""What is known of a mechanism over whole boxes of poses: programs of its coordinates."""

from __future__ import annotations

import numpy as np

from gcrules.core.dataclass import dataclass
from gcrules.core.english import listed
from gcrules.core.errors import InputError
from gcrules.mechanisms.kinematics.targets import Target
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.mechanism import Mechanism
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.compiling.closed_forms import ClosedForms
from gcrules.poses.compiling.leg_programs import (
    balanced_leg_lines,
    leg_lengths,
    leg_wrenches,
    plain_leg_wrenches,
)
from gcrules.poses.compiling.limb_programs import wrench_forms
from gcrules.poses.compiling.limb_wrenches import BalancedLines
from gcrules.poses.compiling.roads import check_finite
from gcrules.poses.compiling.scalars import Graph
from gcrules.poses.compiling.tape import Program
from gcrules.poses.compiling.turns import turned_by
from gcrules.poses.methods import Methods, method

__all__ = ["BoxForms", "box_forms"]


@dataclass(frozen=True)
class BoxForms:
    """Programs of a mechanism's coordinates, angles in rad.

    `forms` are those of the margin and of the actuators. `wrenches` has the entries of a matrix with the rank of the
    platform's wrenches, row by row, and then roots that have to exist; `lines` are the same wrenches, of any length, in
    the balance in which margins are measured. `reached` says that a pose is reached wherever the roots exist.
    """

    forms: ClosedForms
    wrenches: Program
    lines: BalancedLines
    reached: bool

    @property
    def columns(self) -> int:
        """How many columns the matrices have."""
        return self.forms.columns

    @property
    def entries(self) -> int:
        """How many of the values of `wrenches` are those of the matrix."""
        return sum(self.lines.groups) * self.columns


def box_forms(m: Mechanism, names: tuple[str, ...]) -> BoxForms:
    """The programs of a mechanism; raises InputError where its wrenches have no closed form."""
    return method(_FORMS, m, "a map of whole boxes")(names)


def _of_legs(m: SixLegs, _: tuple[str, ...]) -> BoxForms:
    check_finite(m.analysis.structure)
    graph = Graph(6)
    lengths = leg_lengths(m, graph, turned_by)
    forms = ClosedForms(None, leg_wrenches(m, graph, turned_by), lengths, 6, (False,) * 6)
    wrenches, lines = plain_leg_wrenches(m, graph, turned_by), balanced_leg_lines(m, graph, turned_by)
    return BoxForms(forms, wrenches, lines, reached=True)


def _of_limbs(m: Limbs, names: tuple[str, ...]) -> BoxForms:
    found = wrench_forms(m, Target(names, np.zeros(len(names)), text="home"), turned_by)
    if found is None:
        raise InputError(
            f"the wrenches of {m.robot.id} have no closed form in {listed(names)} that is known here",
            hint="a map over nodes (with a number in each range), gcrules free and gcrules path do without one",
        )
    return BoxForms(found.checked, found.plain, found.lines, found.reached)


_FORMS: Methods[BoxForms] = {SixLegs: _of_legs, Limbs: _of_limbs}
"""The method for each kind of mechanism."""
