"""The terms of the field as gcrules uses them: for the glossary of the guide, and for the words of the studio.

>>> print(markdown().splitlines()[0])
# Glossary
"""

from __future__ import annotations

import unicodedata

__all__ = ["EVERYDAY", "GLOSSARY", "anchor", "markdown"]

GLOSSARY = (
    {
        "term": "actuator",
        "forms": "actuators|actuated",
        "meaning": "A joint that is driven. Its amount, an angle or a length, counts from home.",
        "guide": "Robots in motion",
        "page": "robot-numbers.md",
    },
    {
        "term": "aspect",
        "forms": "aspects",
        "meaning": (
            "A part of the poses of a robot within which it can go from any pose to any other without a singular "
            "pose in between."
        ),
        "guide": "Which poses are connected",
        "page": "aspects.md",
    },
    {
        "term": "assembly mode",
        "forms": "assembly modes",
        "meaning": (
            "One of the poses that the platform can take while its actuators are held: a real solution of the "
            "direct kinematics."
        ),
        "guide": "Assembly modes",
        "page": "modes.md",
    },
    {
        "term": "bracket",
        "forms": "brackets",
        "meaning": "The determinant [abcd] of four points. It is zero exactly when they lie in one plane.",
        "guide": "Bracket",
        "page": "course/bracket.md",
    },
    {
        "term": "certificate",
        "forms": "certificates",
        "meaning": (
            "How an answer was shown, so that it can be checked again. That of a whole range of poses is a file: "
            "the proof that none is singular, or a singular one."
        ),
        "guide": "Certificates",
        "page": "certify.md",
    },
    {
        "term": "codimension",
        "forms": "",
        "meaning": "How many equations have to hold at once: in codimension one a single one is enough.",
        "guide": "What the answer means",
        "page": "robots.md#what-the-answer-means",
    },
    {
        "term": "cofactor",
        "forms": "cofactors",
        "meaning": (
            "A factor by which the superbracket is multiplied in an identity. The identity decides nothing at "
            "poses where the cofactor is zero."
        ),
        "guide": "Where the cofactor comes from",
        "page": "transversals.md#where-the-cofactor-comes-from",
    },
    {
        "term": "couple",
        "forms": "couples",
        "meaning": "A pure moment, without a force. Its line lies at infinity.",
        "guide": "Joints at infinity and couples",
        "page": "lines.md#joints-at-infinity-and-couples",
    },
    {
        "term": "equivalent lines",
        "forms": "equivalent structure|equivalent line",
        "meaning": (
            "Six lines that stand for everything the limbs can apply to the platform while the actuators are locked."
        ),
        "guide": "From limbs to lines",
        "page": "procedure/four-dof.md#from-limbs-to-lines",
    },
    {
        "term": "extensor",
        "forms": "extensors",
        "meaning": "Points written side by side: the point, line or plane that they span, with a weight and a sign.",
        "guide": "Extensors",
        "page": "course/extensor.md",
    },
    {
        "term": "family",
        "forms": "families",
        "meaning": (
            "All configurations and all dimensions that keep the relations of a robot's file. In a factorization: the "
            "kinds of expressions that were searched."
        ),
        "guide": "A robot file",
        "page": "robots.md#points-and-directions",
    },
    {
        "term": "gained motion",
        "forms": "",
        "meaning": (
            "A motion that the platform can make at a singular pose, to first order, although its actuators are locked."
        ),
        "guide": "At a singular pose",
        "page": "pose.md#at-a-singular-pose",
    },
    {
        "term": "group of conditions",
        "forms": "group b|group c|group d|group e|group g",
        "meaning": (
            "One of the sorts of condition in the published procedure, with its letter. The classes of the "
            "catalog are arranged by them."
        ),
        "guide": "The classes of six-legged platforms",
        "page": "catalog/README.md",
    },
    {
        "term": "idle freedom",
        "forms": "idle freedoms",
        "meaning": (
            "A motion inside the limbs that leaves the platform at rest, such as a rod that turns about its own axis."
        ),
        "guide": "What the answer means",
        "page": "robots.md#what-the-answer-means",
    },
    {
        "term": "join",
        "forms": "joins",
        "meaning": (
            "The smallest space that holds two others: of two points the line, of a line and a point the plane "
            "through them."
        ),
        "guide": "Join",
        "page": "course/join.md",
    },
    {
        "term": "Krawczyk's operator",
        "forms": "",
        "meaning": "Newton's method with bounds for all errors: it proves that a box holds exactly one solution.",
        "guide": "How it is solved",
        "page": "robot-numbers.md#how-it-is-solved",
    },
    {
        "term": "left-over points",
        "forms": "left-over point",
        "meaning": (
            "Points of the terms that no plane, line or tetrahedron takes up. They are shared out over the "
            "brackets in all ways, with signs."
        ),
        "guide": "Left-over points",
        "page": "procedure/octahedral.md#7-left-over-points",
    },
    {
        "term": "limb",
        "forms": "limbs",
        "meaning": "A chain of joints and links from the base to the platform.",
        "guide": "Robots and their joints",
        "page": "robots.md",
    },
    {
        "term": "line variety",
        "forms": "line varieties",
        "meaning": (
            "All the lines that depend on given ones: those through a point, in a plane, of a regulus, a "
            "congruence or a linear complex."
        ),
        "guide": "At a singular pose",
        "page": "pose.md#at-a-singular-pose",
    },
    {
        "term": "locus",
        "forms": "",
        "meaning": "The set of all singular poses: where one polynomial in the numbers of a pose is zero.",
        "guide": "The locus as a polynomial",
        "page": "locus.md",
    },
    {
        "term": "margin",
        "forms": "σ|margins",
        "meaning": (
            "The number σ from 0 at a singular pose to at most 1, the same in every frame and unit. It says how "
            "well the legs or limbs hold the platform."
        ),
        "guide": "The measure",
        "page": "pose.md#the-measure",
    },
    {
        "term": "meet",
        "forms": "",
        "meaning": (
            "The space that two others have in common, as an extensor: of a line and a plane the point, of two "
            "planes the line."
        ),
        "guide": "Meet",
        "page": "course/meet.md",
    },
    {
        "term": "member",
        "forms": "members",
        "meaning": (
            "One configuration of a family, with its dimensions. Random members are exact: their coordinates are "
            "fractions, or residues modulo a prime."
        ),
        "guide": "A robot file",
        "page": "robots.md#points-and-directions",
    },
    {
        "term": "operation mode",
        "forms": "operation modes",
        "meaning": "One of the sets of poses that the limbs leave to the platform while no actuator is locked.",
        "guide": "Operation modes",
        "page": "operation-modes.md",
    },
    {
        "term": "over-constrained",
        "forms": "overconstraint|overconstraints|overconstrained",
        "meaning": "Some constraints of the limbs depend on others, as when two limbs forbid the same motion.",
        "guide": "Mobility",
        "page": "screws.md#mobility",
    },
    {
        "term": "Plücker coordinates",
        "forms": "",
        "meaning": "Six numbers that say where a line is, up to a common factor.",
        "guide": "Coordinates of a line",
        "page": "course/extensor.md#coordinates-of-a-line",
    },
    {
        "term": "reading",
        "forms": "readings",
        "meaning": (
            "The same condition stated with other entities, or a number that says how nearly its entities satisfy"
            " it at a pose."
        ),
        "guide": "Other readings",
        "page": "procedure/octahedral.md#11-other-readings",
    },
    {
        "term": "replayed",
        "forms": "replay|replays",
        "meaning": (
            "Done again step by step, to see that it still holds: a derivation at exact random points, a saved "
            "session by its commands. This checks, and does not prove."
        ),
        "guide": "How sure an answer is",
        "page": "conventions.md#how-sure-an-answer-is",
    },
    {
        "term": "shortest form",
        "forms": "",
        "meaning": "The superbracket written with the fewest terms over all orders of the six legs.",
        "guide": "Shortest form",
        "page": "procedure/octahedral.md#3-shortest-form",
    },
    {
        "term": "singular pose",
        "forms": "singular poses|singular configuration|singularity|singularities",
        "meaning": (
            "A pose in which the six lines depend on each other: the platform can move, to first order at least, "
            "although the actuators are locked."
        ),
        "guide": "Superbracket",
        "page": "course/superbracket.md",
    },
    {
        "term": "softest motion",
        "forms": "",
        "meaning": (
            "The motion of the platform that its legs or limbs resist least. At a singular pose it is the gained "
            "motion."
        ),
        "guide": "At a singular pose",
        "page": "pose.md#at-a-singular-pose",
    },
    {
        "term": "standard tableau",
        "forms": "standard tableaux",
        "meaning": (
            "A product of brackets, written as rows, whose rows increase from left to right while its columns do "
            "not decrease from top to bottom. Every bracket polynomial is a sum of standard tableaux in exactly "
            "one way."
        ),
        "guide": "Tableaux",
        "page": "course/straightening.md#tableaux",
    },
    {
        "term": "straightening",
        "forms": "normal form",
        "meaning": (
            "Rewriting a polynomial in brackets into its one normal form of standard tableaux, by which equality "
            "is decided."
        ),
        "guide": "Syzygies and straightening",
        "page": "course/straightening.md",
    },
    {
        "term": "superbracket",
        "forms": "superbrackets",
        "meaning": (
            "The determinant of six lines, written in brackets of their points. The robot is singular exactly "
            "when it is zero."
        ),
        "guide": "Superbracket",
        "page": "course/superbracket.md",
    },
    {
        "term": "tetrahedron",
        "forms": "tetrahedra",
        "meaning": (
            "Four points, as a bracket: it is flat exactly when the bracket is zero. If all terms have the "
            "bracket in common, the robot is singular where it is flat."
        ),
        "guide": "Tetrahedra",
        "page": "procedure/octahedral.md#4-tetrahedra",
    },
    {
        "term": "threshold",
        "forms": "ε",
        "meaning": (
            "What counts as close: how far a leg may turn, or how far the platform may shift. A pose is called "
            "close where σ does not exclude a singular pose that near."
        ),
        "guide": "What the numbers mean",
        "page": "pose.md#what-the-numbers-mean",
    },
    {
        "term": "twist",
        "forms": "twists",
        "meaning": "A motion at an instant: a turn about an axis together with a shift along it.",
        "guide": "Screws",
        "page": "screws.md",
    },
    {
        "term": "value",
        "forms": "",
        "meaning": (
            "The superbracket divided by its scale: without unit, with its sign, zero at a singular pose. Robots "
            "without equivalent lines have σ in its place."
        ),
        "guide": "The studio",
        "page": "studio.md#in-space",
    },
    {
        "term": "working mode",
        "forms": "working modes",
        "meaning": (
            "One of the ways in which the limbs can hold the platform in the same place, such as elbows in or out."
        ),
        "guide": "Working modes",
        "page": "working-modes.md",
    },
    {
        "term": "wrench",
        "forms": "wrenches",
        "meaning": "What a limb applies to the platform: a force along a line together with a moment about it.",
        "guide": "Screws",
        "page": "screws.md",
    },
)
"""In the order of the alphabet. `forms` are other words for the same, between bars; `page` is a page of the guide."""

EVERYDAY = ("join", "joins", "meet", "value", "ε")
"""Words for terms that mean something else in most sentences: they are explained only where they are put as terms."""


def anchor(term: str) -> str:
    """Where the entry stands on the page.

    >>> anchor("Plücker coordinates")
    'plucker-coordinates'
    """
    plain = unicodedata.normalize("NFKD", term.lower()).encode("ascii", "ignore").decode()
    return plain.replace("'", "").replace(" ", "-")


def markdown() -> str:
    """The page of the guide."""
    rows = [
        f'<a id="{anchor(e["term"])}"></a>**{e["term"][0].upper()}{e["term"][1:]}**. '
        f"{e['meaning']} ([{e['guide']}]({e['page']}))"
        for e in GLOSSARY
    ]
    start = (
        "The terms as gcrules uses them. Each page of the guide links here where it first uses one, and the "
        "[studio](studio.md#words) shows the same explanations."
    )
    return "\n\n".join(["# Glossary", start, *rows]) + "\n"
