r"""The figures of an analysis: the graph of the legs, and the robot with the condition's entities.

What is drawn follows from the condition's entities and expression, never from its kind.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from gcrules.algebra.evaluate import evaluate
from gcrules.algebra.expr import Bracket, Expr, Join, Meet, Point, Superbracket, join
from gcrules.algebra.language.text import text
from gcrules.algebra.screw_letters import Screw
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import common_point, factors, free_motions, vanishing
from gcrules.conditions.pose_value import XYZ, line_points
from gcrules.core.english import listed, of_kind
from gcrules.core.errors import InputError
from gcrules.rules.condition import Condition, Entity, starred
from gcrules.views.drawing.drawing import Drawing, beside, scaled, without_text
from gcrules.views.drawing.graph import draw_graph
from gcrules.views.drawing.sample import sample_coordinates
from gcrules.views.drawing.scene import draw_platform

__all__ = [
    "distinct_entities",
    "free_name",
    "graph_figure",
    "incidence_in_words",
    "named_lines",
    "robot_figure",
    "sample_points",
    "shown_entities",
    "thumbnail",
]

Coordinates = Mapping[str, Sequence[int | Fraction]]


def graph_figure(a: Analysis, *, key: bool = True, bodies: bool = True) -> Drawing:
    """The schematic of the legs with the entities marked; `key` adds a legend. The `bodies` are told apart, unless the
    legs are lines that stand for the limbs of a robot, whose points belong to neither.

    Lines that are built from points are left out, and so are entities in other ranks than 4. Raises InputError where
    no leg is left.
    """
    s = a.structure
    if not s.joined:
        raise InputError("no leg joins two joints, so there is no graph of the legs to draw")
    entities = [e for part in _entities(a) for e in part] if s.rank == 4 else []
    return draw_graph(s.joined, s.base, s.platform, entities, key=key, bodies=bodies)


def robot_figure(a: Analysis, at: Coordinates | None = None, *, key: bool = True) -> Drawing:
    """The robot with the entities of the condition, in the pose given (x, y, z of each joint, exact), else in its own;
    a sample shape if it came without coordinates.

    The lines p and q of a transversal reading are drawn, and in a singular pose the point in which planes and lines
    meet, or else the axis of the motion that the platform gains. `key` adds a legend.
    """
    s = a.structure
    exact = at if at is not None else a.platform.points if a.platform else None
    points = (
        sample_points(a) if exact is None else {n: (float(x), float(y), float(z)) for n, (x, y, z) in exact.items()}
    )
    lines = [(*ends, name) for name, e in named_lines(a) if (ends := _line(e, points))]
    marks: list[tuple[XYZ, str]] = []
    if exact is not None:
        homogeneous = {n: (*map(Fraction, c), Fraction(1)) for n, c in exact.items()}
        marks = _common_points(a, homogeneous)
        lines += _axis(a, homogeneous, points)
    entities = distinct_entities(a)
    return draw_platform(s.oriented, points, s.base, s.platform, entities, lines, marks, key=key)


def thumbnail(a: Analysis, at: Coordinates | None = None) -> Drawing:
    """The graph and the robot side by side, small and without words."""
    small = [
        scaled(without_text(graph_figure(a, key=False)), 0.3),
        scaled(without_text(robot_figure(a, at, key=False)), 0.22),
    ]
    return beside(small, title=f"{small[0].title}; {small[1].title}")


def sample_points(a: Analysis) -> dict[str, XYZ]:
    """A sample shape for legs without dimensions."""
    return sample_coordinates(a.structure.oriented, a.structure.base, a.structure.platform)


def shown_entities(c: Condition) -> tuple[Entity, ...]:
    """The entities of a condition: those that it states, else the joins of points that its expression is made of (named
    lines stand for themselves), so that a kind of condition that is known only from a catalog is drawn as well.
    """
    if c.entities:
        return c.entities
    found = dict.fromkeys(_joins(c.expression, [e for _, e in c.lines]))
    return starred(sorted(found, key=lambda item: -len(item[1])))


_KINDS = {4: "tetrahedron", 3: "plane", 2: "line"}


def _joins(e: Expr, hidden: Sequence[Expr]) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Kind and points of the joins of points in an expression; what is hidden may be a part of a longer meet."""
    if str(e) in map(str, hidden) or isinstance(e, Superbracket | Screw):
        return
    names = tuple(str(c) for c in e.children if isinstance(c, Point))
    if isinstance(e, (Join, Bracket)) and len(names) == len(e.children) and len(names) in _KINDS:
        yield _KINDS[len(names)], names
        return
    children = list(e.children)
    for line in hidden if isinstance(e, Meet) else ():
        parts = set(map(str, line.children))
        if isinstance(line, Meet) and parts <= set(map(str, children)):
            children = [c for c in children if str(c) not in parts]
    for child in children:
        yield from _joins(child, hidden)
    if isinstance(e, Join) and len(names) == 2:  # a line that is joined with what is constructed
        yield "line", names


def named_lines(a: Analysis) -> list[tuple[str, Expr]]:
    """The lines to be drawn besides the entities: those that the statement names, and those that the expression
    constructs and meets with something.
    """
    c = a.condition
    named = [(name or "line", e) for name, e in c.lines]
    known = {str(e) for _, e in named}
    built = [
        part
        for factor in factors(c.expression)
        if isinstance(factor, Meet)
        for part in factor.children
        if part.step == 2 and not all(isinstance(x, Point) for x in part.children)
    ]
    taken = [*a.structure.names, *(name for name, _ in named)]
    for part in built:
        if str(part) not in known:
            known.add(str(part))
            named.append((free_name("rstuvw", taken), part))
            taken.append(named[-1][0])
    return named


def free_name(letters: str, taken: Iterable[str]) -> str:
    """The first letter that is no name yet; with primes if all are."""
    names = set(taken)
    primes = ""
    while True:
        for letter in letters:
            if letter + primes not in names:
                return letter + primes
        primes += "'"


def _entities(a: Analysis) -> tuple[list[Entity], list[Entity]]:
    """The entities without, and those with a name of their own (p, where it is a line of joints); the latter come last
    so that both figures have the same colours.
    """
    named = [tuple(map(str, e.children)) for _, e in a.condition.lines]
    parts: tuple[list[Entity], list[Entity]] = ([], [])
    different = {(e.kind, frozenset(e.points)): e for e in reversed(shown_entities(a.condition))}
    for e in reversed(different.values()):
        parts[e.kind == "line" and e.points in named].append(e)
    return parts


def distinct_entities(a: Analysis) -> list[Entity]:
    """The entities that are drawn in space, each once; the n-th has the n-th colour. Lines with a name are not among
    them (see `named_lines`): their colours follow.
    """
    return _entities(a)[0]


def _line(e: Expr, points: Mapping[str, XYZ]) -> tuple[XYZ, XYZ] | None:
    return line_points(evaluate(e, {n: (*p, 1.0) for n, p in points.items()}), *_ball(points))


def _ball(points: Mapping[str, XYZ]) -> tuple[XYZ, float]:
    n = len(points)
    centre = tuple(sum(c[i] for c in points.values()) / n for i in range(3))
    reach = max(abs(c[i] - centre[i]) for c in points.values() for i in range(3))
    return (centre[0], centre[1], centre[2]), reach


def _common_points(a: Analysis, at: Coordinates) -> list[tuple[XYZ, str]]:
    """Where the parts of a factor of the condition meet in this pose; nothing unless they do, in a finite point."""
    names = _mark_names(a, at)
    found = []
    for factor in vanishing(a.condition.expression, at):
        if str(factor) in names and (point := common_point(factor, at)):
            x, y, z = (float(c / point[3]) for c in point[:3])
            found.append(((x, y, z), f"common point {names[str(factor)]}"))
    return found


def incidence_in_words(a: Analysis, at: Coordinates) -> str:
    """What makes a pose (x, y, z of each joint, exact) singular, as the end of a sentence."""
    homogeneous = {n: (*map(Fraction, c), Fraction(1)) for n, c in at.items()}
    zero = vanishing(a.condition.expression, homogeneous)
    found = [_zero_in_words(a, f, homogeneous) for f in zero if isinstance(f, (Bracket, Meet))]
    if found:
        return f"{listed(found)}."
    motions = free_motions(a.structure.legs, homogeneous)
    if len(motions) != 1:
        return "the six legs belong to more than one linear complex."
    axis, pitch = motions[0].axis, motions[0].pitch
    if pitch is None:
        return f"the platform can be shifted in the direction {_tuple(axis)}; {_FREE}"
    points = {n: (float(x), float(y), float(z)) for n, (x, y, z) in at.items()}
    name = next((label.rpartition(" ")[2] for *_, label in _axis(a, homogeneous, points)), None)
    about = f"about the axis {name}" if name else f"about an axis in the direction {_tuple(axis)}"
    if not pitch:
        return f"the platform can turn {about}; {_FREE}"
    size = f"{float(pitch):.3g}".replace("-", "−")
    return f"the platform can make a screw motion {about} with pitch {size} (length for each radian); {_FREE}"


_FREE = "to first order this changes the length of no leg."


def _zero_in_words(a: Analysis, factor: Expr, at: Coordinates) -> str:
    names = a.structure.names
    if isinstance(factor, Bracket):
        return f"the tetrahedron {text(join(*factor.children), unicode=True, names=names)} is flat"
    lines = {str(e): name for name, e in named_lines(a)}
    parts = [
        of_kind(
            word, [lines.get(str(e)) or text(e, unicode=True, names=names) for e in factor.children if e.step == step]
        )
        for step, word in ((3, "plane"), (2, "line"), (1, "point"))
    ]
    together = listed([part for part in parts if part])
    point = common_point(factor, at)
    if point is None:
        return f"{together} have more than one point in common"
    if not point[3]:
        return f"{together} meet at infinity, in the direction {_tuple(point[:3])}"
    place = tuple(c / point[3] for c in point[:3])
    return f"{together} meet in the point {_mark_names(a, at)[str(factor)]} = {_tuple(place)}"


def _tuple(numbers: Sequence[Fraction]) -> str:
    return "(" + ", ".join(map(str, numbers)) + ")"


def _mark_names(a: Analysis, at: Coordinates) -> dict[str, str]:
    """Names for the points in which parts of the condition meet in a pose, by factor."""
    names: dict[str, str] = {}
    for factor in vanishing(a.condition.expression, at):
        point = common_point(factor, at)
        if point and point[3]:
            names[str(factor)] = free_name("MNOXYZ", [*a.structure.names, *names.values()])
    return names


def _axis(a: Analysis, at: Coordinates, points: Mapping[str, XYZ]) -> list[tuple[XYZ, XYZ, str]]:
    """The axis of the one motion that the platform gains in this pose, where no join or meet of entities shows why."""
    zero = vanishing(a.condition.expression, at)
    if not zero or any(isinstance(f, (Bracket, Meet)) for f in zero):
        return []
    motions = free_motions(a.structure.legs, at)
    if len(motions) != 1 or motions[0].foot is None:
        return []
    foot, axis = ([float(c) for c in v] for v in (motions[0].foot, motions[0].axis))
    names = [*a.structure.names, *(name for name, _ in named_lines(a))]
    middle, reach = _ball(points)
    size = sum(c * c for c in axis) ** 0.5
    along = sum((m - f) * c for m, f, c in zip(middle, foot, axis, strict=True)) / size
    ends = [tuple(f + (along + t * reach) * c / size for f, c in zip(foot, axis, strict=True)) for t in (-1, 1)]
    (x, y, z), (u, v, w) = ends
    return [((x, y, z), (u, v, w), f"axis of the motion {free_name('stuvw', names)}")]
