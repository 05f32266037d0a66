"""What each guided step says: what is done and why, in plain words, and the theory behind it.

Keys of the bibliography stand in brackets at the end of a paragraph, as [SinguLab2008]; what is said without one is
elementary or derived in this project.
"""

from __future__ import annotations

from collections.abc import Mapping

from gcrules.core.dataclass import dataclass

__all__ = ["THEORY", "WHY_OF_KINDS", "Theory"]


@dataclass(frozen=True)
class Theory:
    """`why` is for a reader who sees the step for the first time, `more` for one who wants the theory."""

    why: str
    more: tuple[str, ...]


THEORY: Mapping[str, Theory] = {
    "limbs": Theory(
        "Each limb joins the base to the platform by a chain of joints. With its motors locked, a limb can still give "
        "way in some directions and resists in others; the forces and couples with which it resists are its wrenches. "
        "All limbs together must resist every motion of the platform, or the robot is singular.",
        (
            "A joint lets its two bodies move by a twist: a turn about a line, or a shift. A wrench (a force along a "
            "line, or a couple) is reciprocal to a twist if it does no work on it. The wrenches that a limb transmits "
            "with its actuators locked are those reciprocal to all the twists of its passive joints; those reciprocal "
            "to the actuated ones too are constraints, which the limb applies whether its motors hold or not. "
            "[McCarthy2000]",
            "A robot whose mobility is n has 6 − n independent constraints and n wrenches of its actuators; together "
            "they are the six rows of one matrix, whose determinant tells both kinds of singularity: actuation "
            "singularities, where the motors lose control, and constraint singularities, where the platform gains a "
            "freedom that it should not have. [JoshiTsai2002]",
        ),
    ),
    "equivalent": Theory(
        "A force acts along a line, and a couple acts along a line at infinity. So the six wrenches of the limbs can "
        "be drawn as six lines between points of the robot: an equivalent platform with six legs. What is true of its "
        "lines is true of the robot, and the same procedure serves both.",
        (
            "A limb that resists in several directions contributes several lines; which lines are drawn is a choice, "
            "as long as they span the same wrenches. Here they go through as few points as possible, since points "
            "that legs share make the condition short. That they are wrenches of the limb is checked exactly at random "
            "members of the whole family of such robots.",
            "The published example is the robot with four degrees of freedom and limbs PS, UPS and PRPS: a spherical "
            "joint that is held fast applies all forces through its centre, drawn as three legs that meet there. "
            "[SinguLab2008] [Gallardo2006]",
        ),
    ),
    "structure": Theory(
        "A platform on six legs is held by six forces, one along each leg. Whether they hold it depends only on the "
        "six lines on which the legs lie, so the robot is written down as six pairs of points: a leg from a joint of "
        "the base to a joint of the platform. Legs that meet in one joint share its letter.",
        (
            "The lengths of the legs and the shapes of base and platform do not matter at this stage; the shapes come "
            "in with the dimensions, and both with the pose. What matters is which legs share a joint. Up to "
            "exchanging base and platform there are 39 ways to join at most three legs at a joint, counted here; five "
            "of them are singular in every pose, and 34 are regular. The literature speaks of 35 classes; how they are "
            "counted was not read. [FaugereLazard1995] [SinguLab2008]",
        ),
    ),
    "superbracket": Theory(
        "The six lines, each written as six numbers (its Plücker coordinates), are the rows of a square matrix. The "
        "legs lose control of the platform exactly when the determinant of this matrix is zero. It is called the "
        "superbracket. Written out in brackets, where [abcd] is six times the volume of a tetrahedron with a sign, "
        "it becomes a sum of products of three volumes: algebra that can be read as geometry.",
        (
            "A point of space is a column (x, y, z, 1), and [abcd] is the determinant of four such columns: it is zero "
            "when the four points lie in one plane. A line through a and b is the join a ∨ b; its six coordinates are "
            "the 2×2 minors of the two columns. Nothing in this depends on the frame: a change of frame or of unit "
            "multiplies every bracket by the same number.",
            "For six lines with twelve different end points the superbracket is a sum of 24 terms of three brackets "
            "each. Every one of them is a standard tableau, so that these 24 terms are its normal form. A bracket "
            "with the same point twice is zero: every joint that legs share removes terms. [McMillanWhite1991] "
            "[White1983] [SinguLab2008]",
        ),
    ),
    "shortest": Theory(
        "The same determinant can be written in many ways: the order of its six rows changes nothing but the sign, "
        "yet it changes which terms survive. All 720 orders are tried, in two ways of writing the sum. The fewer "
        "terms are left, the more geometry shows.",
        (
            "Brackets are not independent: the same number can be written as different sums, because any five points "
            "of space satisfy a linear relation (a syzygy). So forms with different numbers of terms are equal, and "
            "that they are is proved by straightening, which brings every bracket polynomial to one normal form.",
            "The published procedure offers a search for a shorter form when more than four terms are left; here it is "
            "always made. Beside the 24-term form there is one of 16 terms, mentioned in the literature and derived "
            "again here. Two forms with equally few terms may show different entities. [SinguLab2008] [Downing2002]",
        ),
    ),
    "tetrahedra": Theory(
        "A bracket that occurs in every term can be taken out as a factor. If it is zero, the whole sum is: then four "
        "joints lie in one plane, and the tetrahedron that they span is flat. So each common bracket is already a "
        "singularity, seen without any further work.",
        (
            "A product is zero when one of its factors is, so a condition falls apart into the factors of the "
            "superbracket. A common bracket arises where three legs meet in one joint: the three legs span the bundle "
            "of all lines through it unless they lie in one plane, which is when the tetrahedron of the joint and the "
            "other ends of the three legs is flat. [SinguLab2008]",
        ),
    ),
    "planes": Theory(
        "Three points that stay together in one bracket of every term always act together: as the plane through them. "
        "A point that is needed in two such planes is distinguished by a star (a and a*).",
        (
            "A bracket [abcd] can be read as the plane abc met with the point d. If the plane abc stands in every "
            "term, each in a bracket of its own, then what the sum says of the points is said of planes, and meets of "
            "planes can be expected in the result. With two legs in one joint, the plane of the two legs is such a "
            "plane. [SinguLab2008]",
        ),
    ),
    "lines": Theory(
        "Two points that stay together in one bracket of every term act as the line through them.",
        (
            "A pair of points that exchange their places with a change of sign, P(a, b) + P(b, a) = 0, enters the sum "
            "only by their join: the sum depends on the line ab, not on where the points are on it. That is tested on "
            "the terms themselves. [SinguLab2008]",
        ),
    ),
    "left-over": Theory(
        "Every point occurs in the sum as often as legs meet in it. Some of these places are taken by the planes and "
        "lines found so far; the points of the others are left over. They make up the last plane, or lines, and it is "
        "tested which.",
        (
            "With three planes X, Y and Z known, three points x, y and z are left over, one for each bracket, in all "
            "orders and with alternating signs: [Xẋ][Yẏ][Zż], where the dots stand for the orders. Such a sum is what "
            "the meet X ∧ Y ∧ Z ∧ xyz of four planes expands to. With two planes and a line known, four points are "
            "left over, and are tried as two pairs with P(x, y) + P(y, x) = 0. [SinguLab2008] [White1991]",
        ),
    ),
    "condition": Theory(
        "The entities are put together into one expression: planes that meet, lines that meet planes. It is a "
        "guess only until it is multiplied out again: it counts when its expansion is the superbracket, term by term, "
        "with the right sign.",
        (
            "In Grassmann–Cayley algebra the join ∨ of points is the line or plane through them, the meet ∧ of planes "
            "and lines is what they have in common, and an expression that ends in a number is zero exactly when its "
            "last meet is incident: four planes through one point, two lines that cross. To write a bracket "
            "polynomial as such an expression is called Cayley factorization; for polynomials in which every point "
            "occurs once it can be decided. [White1991]",
            "The identity is cofactor · superbracket = coefficient · expression. In most cases the cofactor is 1. "
            "Where it is not, the expression is zero also where the cofactor is, without the robot being singular "
            "there; value and verdict therefore always come from the superbracket itself.",
        ),
    ),
    "statement": Theory(
        "The condition in words. It is said of points, lines and planes, whatever the frame and the unit: it can be "
        "checked with a pencil on a drawing, and it tells a designer what to avoid. What the dimensions say beyond it "
        "holds for the numbers of this robot only, in every pose.",
        (
            "A point in which planes meet may lie at infinity: then the planes are parallel to one direction. The "
            "statement includes this case, as the algebra does.",
            "Where the platform could turn, to first order, about two lines p and q if two of the legs were taken "
            "away, each of these two legs allows the two turns in one ratio only. If the ratios agree, the platform "
            "can make both turns at once in spite of all legs: then all six lines belong to one linear complex, of "
            "the pencil that p and q span.",
        ),
    ),
    "check": Theory(
        "An answer that cannot be checked is worth little. Every step from the six legs to the condition is listed, "
        "with the rule that made it; each was replayed with exact numbers by a part of the program that knows nothing "
        "of the rules.",
        (
            "“Proved” means that both sides have the same normal form of standard tableaux, which no other polynomial "
            "has. “Holds at exact random points” means that both sides agree, without rounding, where the points were "
            "drawn at random; the error probability is stated. A classical identity of the catalog is proved once, "
            "and used with other letters.",
        ),
    ),
}

WHY_OF_KINDS: Mapping[tuple[str, str], str] = {
    ("condition", "linear-complex"): "No expression of a few planes, lines and points was found for this structure. "
    "The superbracket itself is the condition: it vanishes exactly when the six lines are dependent, which is to say "
    "that they belong to one linear complex.",
    ("condition", "always-singular"): "There is no condition to look for: the superbracket vanishes wherever the "
    "joints are, so that the robot is singular in every pose.",
}
"""What the step says instead, for a kind of condition that it would not be true of."""
