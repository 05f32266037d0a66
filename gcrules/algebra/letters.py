r"""Letters that stand for lines, planes and hyperplanes: each is the join of points that have no name of their own.

A line L is L₁ ∨ L₂, a plane P of space P₁₃ ∨ P₂₃ ∨ P₃₃: of a letter of step k the i-th point is marked by i, and by k
behind it where k is not 2. So every line is reached, and only lines are: the Plücker coordinates of a join satisfy the
quadratic relation. Nobody can write the names of these points, and where all of them stand side by side the letter is
printed. A conic K of the plane is the one through five points K¹, …, K⁵ without names, of a quadric Q of space a
tetrahedron with the corners Q¹, …, Q⁴ is on it (`quadric_forms`), and a screw of space is a sum of two lines
(`screw_letters`).

>>> str(letter("L", 2)), grouped(("a", *names_of("L", 2), "b"))
('L', ('a', 'L', 'b'))
>>> conic_points("K"), conic_of("K³")
(('K¹', 'K²', 'K³', 'K⁴', 'K⁵'), 'K')
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from gcrules.algebra.expr import Expr, Join, Point
from gcrules.algebra.names import NAME, step_name
from gcrules.algebra.screw_letters import SCREW_MARKS, Screw, screw, screw_of
from gcrules.core.english import with_article
from gcrules.core.errors import GcrulesError, InputError

__all__ = [
    "CONIC",
    "LETTERS",
    "QUADRIC",
    "SCREW",
    "conic_of",
    "conic_points",
    "conics_of",
    "declarations",
    "grouped",
    "letter",
    "letter_name",
    "letter_of",
    "letter_step",
    "letters_of",
    "marked",
    "marks_in",
    "named_letter",
    "names_of",
    "plain_name",
    "split_letters",
    "wholes",
    "without_marks",
]

CONIC, QUADRIC, SCREW = "conic", "quadric", "screw"
LETTERS = ("line", "plane", "hyperplane", CONIC, QUADRIC, SCREW)
"""The words that declare letters of other steps than that of a point, of conics and of quadrics."""

_WORDS = {2: "line", 3: "plane"}
_PLANE, _SPACE = 3, 4
_OWN_POINTS = {_PLANE: 5, _SPACE: 4}
_OF_RANK = {
    CONIC: (_PLANE, 0, "a conic is a curve of the plane"),
    QUADRIC: (_SPACE, 0, "a quadric is a surface of space"),
    SCREW: (_SPACE, 2, "a screw is a wrench or a twist of space"),
}
"""Letters of one rank: this rank, their step, and what they are."""

_TO_MARKS = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_RAISED = "¹²³⁴⁵"
_FROM_MARKS = {
    ord(mark): str(i) for i, mark in (*enumerate("₀₁₂₃₄₅₆₇₈₉"), *enumerate(_RAISED, 1), *enumerate(SCREW_MARKS, 1))
}
_MARKS = "₁₂₃₄₅₆₇₈₉"


def letter_step(kind: str, rank: int) -> int:
    """The step of a line, a plane, a hyperplane or a screw, 0 for a conic or a quadric. Raises InputError where a rank
    has no room for it.
    """
    if kind in _OF_RANK:
        own, step, what = _OF_RANK[kind]
        if rank != own:
            hint = f"`rank {own}` in a file, --rank {own} in the shell"
            raise InputError(f"{what} (rank {own}); this is rank {rank}", hint=hint)
        return step
    step = rank - 1 if kind == "hyperplane" else LETTERS.index(kind) + 2
    if not 2 <= step < rank:
        what = {rank: "the whole space", 1: "a point"}.get(step, "more than the whole space")
        hint = f"`rank {max(step, 2) + 1}` in a file, --rank {max(step, 2) + 1} in the shell"
        raise InputError(f"{with_article(kind)} is {what} in rank {rank}", hint=hint)
    return step


def names_of(name: str, step: int) -> tuple[str, ...]:
    """The names of the points that a letter is the join of.

    >>> names_of("L", 2), names_of("P", 3)
    (('L₁', 'L₂'), ('P₁₃', 'P₂₃', 'P₃₃'))
    """
    behind = "" if step == 2 else str(step)
    return tuple(name + f"{i}{behind}".translate(_TO_MARKS) for i in range(1, step + 1))


def letter(name: str, step: int, screws: Collection[str] = ()) -> Expr:
    """What a letter stands for, which may be one of the `screws`."""
    return screw(name) if name in screws else Join(tuple(map(Point, names_of(name, step))))


def letter_name(name: str, step: int, screws: Collection[str], rank: int) -> str:
    """What a letter is called: "a line (step 2)", "a screw (step 2)"."""
    return "a screw (step 2)" if name in screws else step_name(step, rank)


def letter_of(point: str) -> tuple[str, int, int] | None:
    """The letter that a point belongs to, the number of the point and the step of the letter; None for other points."""
    name = point.rstrip(_MARKS)
    if name == point or not NAME.fullmatch(name):
        return None
    digits = point[len(name) :].translate(_FROM_MARKS)
    return name, int(digits[0]), int(digits[1:] or 2)


def conic_points(name: str, rank: int = _PLANE) -> tuple[str, ...]:
    """The names of the points through which the conic of a letter runs, or of the corners of a tetrahedron on the
    quadric.
    """
    return tuple(name + mark for mark in _RAISED[: _OWN_POINTS[rank]])


def conic_of(point: str) -> str | None:
    """The letter of the conic or quadric to which a point belongs; None for other points."""
    name = point[:-1]
    return name if point[-1:] in _RAISED and NAME.fullmatch(name) else None


def conics_of(names: Iterable[str]) -> tuple[str, ...]:
    """The letters of conics or quadrics to which some of the points belong."""
    return tuple(dict.fromkeys(name for n in names if (name := conic_of(n)) is not None))


def marks_in(shown: str) -> bool:
    """Whether a text shows points of conics or quadrics."""
    return any(mark in shown for mark in _RAISED)


def without_marks(fault: GcrulesError) -> None:
    """Leave out of an error about an assumption what shows points of letters, which nobody can write, with its advice:
    why it is so, and then what was made of the assumption that is written in its place.
    """
    for part in ("; in the one", ": "):
        if any(mark in f"{fault.message}{fault.hint}" for mark in (*_RAISED, *_MARKS)):
            fault.message, fault.hint = fault.message.partition(part)[0], None
    if any(mark in fault.message for mark in (*_RAISED, *_MARKS)) and fault.span is not None and fault.source:
        written = fault.source[fault.span.start : fault.span.end]
        fault.message = f"the assumption {written} cannot be resolved"


def marked(point: str) -> bool:
    """Whether a point belongs to a letter, so that nobody can write its name."""
    return letter_of(point) is not None or conic_of(point) is not None or screw_of(point) is not None


def plain_name(point: str) -> str:
    """The name of a point with the marks of a letter as digits: for what knows no others.

    >>> plain_name("P₁₃"), plain_name("K²"), plain_name("a")
    ('P13', 'K2', 'a')
    """
    return point.translate(_FROM_MARKS)


def grouped(names: Sequence[str]) -> tuple[str, ...]:
    """Points side by side with letters in place of all their points, where these stand in their order."""
    if not any(n[-1:] in _MARKS for n in names):
        return tuple(names)
    found, at = [], 0
    while at < len(names):
        of = letter_of(names[at])
        whole = of is not None and tuple(names[at : at + of[2]]) == names_of(of[0], of[2])
        found.append(of[0] if of is not None and whole else names[at])
        at += of[2] if of is not None and whole else 1
    return tuple(found)


def wholes(args: Sequence[Expr]) -> tuple[Expr, ...]:
    """What is joined, with each letter as one where all its points stand side by side in their order."""
    found: list[Expr] = []
    at = 0
    while at < len(args):
        first = args[at]
        of = letter_of(first.name) if isinstance(first, Point) else None
        run = args[at : at + of[2]] if of is not None else ()
        if of is not None and tuple(a.name for a in run if isinstance(a, Point)) == names_of(of[0], of[2]):
            found.append(letter(of[0], of[2]))
        else:
            found.append(first)
            run = (first,)
        at += len(run)
    return tuple(found)


def letters_of(names: Iterable[str]) -> Mapping[str, int]:
    """The letters to which some of the points belong, each with its step."""
    found = (of for n in names if (of := letter_of(n)) is not None)
    return {name: step for name, _, step in found}


def named_letter(e: Expr) -> str | None:
    """The name of an expression that is a letter."""
    if isinstance(e, Screw):
        return e.name
    points = tuple(a.name for a in e.args if isinstance(a, Point)) if isinstance(e, Join) else ()
    if not isinstance(e, Join) or len(points) != len(e.args):
        return None
    found = grouped(points)
    return found[0] if len(found) == 1 else None


def declarations(
    steps: Mapping[str, int], rank: int, screws: Collection[str] = (), conics: Collection[str] = ()
) -> tuple[str, ...]:
    """The texts that declare letters, each with its step, those of `screws` apart, and those of conics or quadrics.
    Raises InputError for steps that have no word.

    >>> declarations({"L": 2, "P": 3, "M": 2}, 4), declarations({"L": 2, "S": 2}, 4, ["S"])
    (('line L M', 'plane P'), ('line L', 'screw S'))
    """
    found = []
    for step in sorted({k for n, k in steps.items() if n not in screws}):
        names = " ".join(n for n, k in steps.items() if k == step and n not in screws)
        if step > 3 and step != rank - 1:
            raise InputError(f"{names}: there are no letters that are {step_name(step, rank)} in rank {rank}")
        found.append(f"{_WORDS.get(step, 'hyperplane')} {names}")
    last = {SCREW: screws, CONIC if rank == _PLANE else QUADRIC: conics}
    return (*found, *(f"{word} {' '.join(names)}" for word, names in last.items() if names))


def split_letters(rows: Iterable[Sequence[str]]) -> Iterator[str]:
    """The letters of which points stand alone in a row, each once."""
    seen: dict[str, None] = {}
    for row in rows:
        seen.update((of[0], None) for n in grouped(row) if (of := letter_of(n)) is not None)
    yield from seen
