r"""From a robot to the polynomial of its singular poses: of six legs here, of joints in `limb_locus`.

>>> from gcrules.mechanisms.description.platform_file import parse_platform
>>> robot = parse_platform('''
... legs: [ab, af, cb, cd, ed, ef]
... points: {a: [0, -3, 0], c: [3, 2, 0], e: [-3, 2, 0], b: [1, -1, 4], d: [0, 1, 4], f: [-1, -1, 4]}
... ''')
>>> found = locus(robot, over="z")
>>> print(found.form, found.coefficient)
z^3 + 12*z^2 + 48*z + 64 -2640
>>> [(str(f.form), f.multiplicity) for f in found.factors]
[('z + 4', 3)]
>>> locus(robot)
<Locus of degree 9 in x, y, z, e0, e1, e2, e3: 408 terms>
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from gcrules.algebra.evaluate import evaluate
from gcrules.core.budget import checkpoint
from gcrules.core.errors import EngineFault
from gcrules.core.frozen import FrozenMap
from gcrules.core.seeds import DRAWN, PRIME, drawn
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.load import Source
from gcrules.mechanisms.mechanism import Mechanism, mechanism
from gcrules.mechanisms.moving_platform import MovingPlatform
from gcrules.mechanisms.six_legs import SixLegs
from gcrules.poses.loci.expansion import Terms, expansion
from gcrules.poses.loci.factors import MAX_TERMS, primitive
from gcrules.poses.loci.form import PolynomialForm
from gcrules.poses.loci.known import rational_ring
from gcrules.poses.loci.limb_locus import limb_locus
from gcrules.poses.loci.limb_report import RobotLocus
from gcrules.poses.loci.report import Locus
from gcrules.poses.loci.variables import images, question
from gcrules.poses.methods import Methods, has_six_legs, method
from gcrules.poses.numbers.cubic import superbracket_at, translation_polynomial
from gcrules.screws.pose import Pose
from gcrules.screws.rotations import Quaternion, Vector
from gcrules.screws.rotations import rotation as matrix

__all__ = ["locus", "locus_of"]

CHECKS = 3  # poses of each kind


def locus(
    source: Source,
    over: str | Sequence[str] | None = None,
    *,
    fix: str | Mapping[str, Any] | None = None,
    at: str | Pose | None = None,
    rotation: str = "quaternion",
    about: str | Sequence[Any] = "centroid",
    limit: int = MAX_TERMS,
    product: bool | None = None,
) -> Locus | RobotLocus:
    """The polynomial whose zeros are the robot's singular poses, exact, with degrees and factors (a `Locus`).

    `source` and `about` are those of `pose`. For platforms on six legs the variables are x, y, z, the translation, and
    those of the `rotation`: "quaternion" (e0, e1, e2, e3, of any length), "rodrigues" (c1, c2, c3 = e1/e0, e2/e0,
    e3/e0), or a sequence of Euler angles such as "zyx" (t1, t2, t3, tangents of the half angles). `over` names those
    that stay free ("x, y", or "translation", "rotation", "all"), `fix` gives values to others ("x=0, e1=1/2", or a
    mapping), and the rest is taken from the pose `at`, text or a `Pose`; without `over` all that is not fixed is free.
    Polynomials of up to `limit` terms are searched for factors where no proof decides. Raises InputError for unknown
    variables, where nothing is free, and for degenerate robots.

    Of other robots of joints it is a `RobotLocus`: a polynomial for each factor of the condition. Its variables are
    coordinates that determine the pose, x, y, z and t_roll, t_pitch, t_yaw, the tangents of half the angles ("yaw"
    names t_yaw too); `at` gives others by their names ("z=1/2, yaw=30deg"), and those that are not named are 0. With
    the `product` it is multiplied over all working modes; without, the roots that tell the modes apart are variables
    too; by default (None) products are left out that may be long. Raises InputError where the loops cannot be
    eliminated, with what to use instead, and LimitReached where that makes too large polynomials.
    """
    return locus_of(mechanism(source, about=about), over, fix, at, rotation, limit, product)


def locus_of(
    m: Mechanism,
    over: str | Sequence[str] | None,
    fix: str | Mapping[str, Any] | None,
    at: Any,
    rotation: str = "quaternion",
    limit: int = MAX_TERMS,
    product: bool | None = None,
) -> Locus | RobotLocus:
    """That of a mechanism; of a robot of joints `at` may be a mapping, too. Raises as `locus`."""
    if has_six_legs(m):
        return _locus(m.six_legs(), over, fix, at, rotation, limit, product)
    return method(_METHODS, m, "the locus")(over, fix, at, rotation, limit, product)


def _locus(
    m: SixLegs,
    over: str | Sequence[str] | None,
    fix: str | Mapping[str, Any] | None,
    at: str | Pose | None,
    rotation: str,
    limit: int,
    _product: bool | None = None,
) -> Locus:
    """That of a platform on six legs, whose poses need no roots."""
    moving = m.rig
    asked = question(over, fix, at, rotation, moving.unit)
    ring = rational_ring(asked.free)
    shift, turn, norms = images(asked, ring)
    if asked.turn is None:
        p = _substituted(expansion(moving), shift, turn, ring)
    else:  # a polynomial in the translation as it is
        p, norms = _substituted(_translations(moving, asked.turn), shift, turn, ring), ()
    coefficient, form = Fraction(0), PolynomialForm(asked.free, ())
    parts = [primitive(n) for n in norms]
    if p:
        c, whole = primitive(p)
        coefficient, form = _fraction(c), PolynomialForm.of(whole)
        for c, _ in parts:
            coefficient /= _fraction(c) ** 3
    found = Locus(
        rig=moving,
        condition=m.analysis.condition,
        question=asked,
        form=form,
        coefficient=coefficient,
        norms=tuple(PolynomialForm.of(n) for _, n in parts if not n.is_ground),
        checked=FrozenMap({"rational": CHECKS, "modular": CHECKS}),
        limit=limit,
    )
    _check(found, shift, turn)
    return found


_METHODS: Methods[Locus | RobotLocus] = {SixLegs: _locus, Limbs: limb_locus}


def _fraction(c: Any) -> Fraction:
    return Fraction(int(c.numerator), int(c.denominator))


def _translations(moving: MovingPlatform, turn: Quaternion) -> Terms:
    """The superbracket at a fixed turn, written as `expansion` does."""
    points = {n: (*p, Fraction(1)) for n, p in _joints(moving, (Fraction(0),) * 3, turn).items()}
    cubic = translation_polynomial(moving.structure.legs, points, moving.structure.platform, Fraction(1))
    return {(*e, 0, 0, 0, 0): c for e, c in cubic.coefficients.items()}


def _substituted(terms: Terms, shift: Sequence[Any], turn: Sequence[Any], ring: Any) -> Any:
    """The polynomial in the free variables, grouped by the powers of the turn."""
    powers = [[ring.one] for _ in range(7)]
    for row, x in zip(powers, (*shift, *turn), strict=True):
        for _ in range(6):
            checkpoint()
            row.append(row[-1] * x)
    groups: dict[tuple[int, ...], Any] = {}
    for e, c in terms.items():
        checkpoint()
        at = powers[0][e[0]] * powers[1][e[1]] * powers[2][e[2]] * ring.domain(c.numerator, c.denominator)
        groups[e[3:]] = groups.get(e[3:], ring.zero) + at
    total = ring.zero
    for e, group in groups.items():
        checkpoint()
        for row, n in zip(powers[3:], e, strict=True):
            group = group * row[n]
        total += group
    return total


def _check(found: Locus, shift: Sequence[Any], turn: Sequence[Any]) -> None:
    """Two roads: superbrackets at poses, computed from the joints alone. Raises EngineFault where one differs."""
    rng = drawn("locus", str(found.coefficient), len(found.variables))
    for k in range(2 * CHECKS):
        checkpoint()
        modular = k >= CHECKS
        values = [
            Fraction(rng.randrange(DRAWN)) if modular else Fraction(rng.randint(1, 10**9), rng.randint(1, 9))
            for _ in found.variables
        ]
        at = list(zip(shift[0].ring.gens, values, strict=True))
        t, q = ([_fraction(x.evaluate(at)) for x in part] for part in (shift, turn))
        left = Fraction(1)
        for n in found.norms:
            left *= n(values) ** 3
        right = found.coefficient * found.form(values)
        if modular:
            same = (_residue(left) * _modular(found.rig, t, q) - _residue(right)) % PRIME == 0
        else:
            same = left * _rational(found.rig, t, q) == right
        if not same:
            raise EngineFault("the polynomial of the singular poses disagrees with the superbracket at a pose")


def _joints(r: MovingPlatform, t: Sequence[Fraction], q: Sequence[Fraction]) -> dict[str, Vector]:
    w, x, y, z = q
    turn = matrix((w, x, y, z))
    found = {}
    for n, p in r.points.items():
        if r.structure.sides[n] == "platform":
            arm = [c - m for c, m in zip(p, r.centre, strict=True)]
            a, b, c = (
                sum((e * c for e, c in zip(row, arm, strict=True)), m + s)
                for row, m, s in zip(turn, r.centre, t, strict=True)
            )
            p = a, b, c
        found[n] = p
    return found


def _rational(r: MovingPlatform, t: Sequence[Fraction], q: Sequence[Fraction]) -> Fraction:
    return superbracket_at(r.structure.legs, {n: (*p, Fraction(1)) for n, p in _joints(r, t, q).items()})


def _modular(r: MovingPlatform, t: Sequence[Fraction], q: Sequence[Fraction]) -> int:
    points = {n: (*map(_residue, p), 1) for n, p in _joints(r, t, q).items()}
    return int(evaluate(r.structure.superbracket, points, modulus=PRIME))


def _residue(c: Fraction) -> int:
    return c.numerator * pow(c.denominator, -1, PRIME) % PRIME
