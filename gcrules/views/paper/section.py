"""A section for a paper: structure, theorem and proof, numbers, how sure it is; and an appendix of steps."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from gcrules.algebra.expr import ONE, Bracket, Expr, Meet, Point
from gcrules.algebra.screw_letters import Screw
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.gained_motion import factors
from gcrules.core.digests import beginning
from gcrules.core.english import listed
from gcrules.core.version import __version__
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.lines.wrenches import LimbWrenches, WrenchLine
from gcrules.rules.condition import Condition
from gcrules.rules.statement import Statement
from gcrules.views.formulas.latex_text import latex_words
from gcrules.views.formulas.suppositions import supposed
from gcrules.views.paper.bibliography import OWN_KEY, cited_in
from gcrules.views.paper.dimensions import dimensions, table
from gcrules.views.paper.formulas import breakable, displayed, equation, inline, itemized, named_words, sentence
from gcrules.views.paper.subject import Subject
from gcrules.views.report.stage_ids import TITLES
from gcrules.views.results.derivation import reasons
from gcrules.views.results.robot import (
    CONDITION,
    FACTORS,
    IN_FULL,
    LIMBS,
    LINES,
    alike,
    factor_words,
    in_every_pose,
    sections,
)

__all__ = ["appendix", "keys", "section", "slug"]

_ALGEBRA = ("White1983", "McMillanWhite1991", "SinguLab2008")
_SHORT = 8  # terms of a form that stands in the proof
_COUNTS = {3: "three", 6: "six", 10: "ten"}


def section(s: Subject, figures: Sequence[str], *, full: bool = False) -> str:
    """The section; `figures` are the pictures as LaTeX, with their captions. `full` refers to the appendix of steps."""
    title = latex_words(s.title)
    parts = [rf"\section[{{{title}}}]{{\gcheading {title}}}\label{{sec:{slug(s)}}}", *_structure(s, len(figures))]
    parts += [*figures, *_result(s), *_limits(s), *dimensions(s, slug(s)), *_numbers(s), _sure(s, full)]
    return "\n\n".join(filter(None, parts)) + "\n"


def slug(s: Subject) -> str:
    """A word for labels, made of the letters of the title."""
    return re.sub(r"[^a-z0-9]+", "-", s.title.lower()).strip("-") or "robot"


def keys(s: Subject) -> tuple[str, ...]:
    """The works that the section cites, gcrules left out."""
    return (*_ALGEBRA, *cited_in(s.source))


# --- structure -----------------------------------------------------------------------------------------------------


def _structure(s: Subject, figures: int) -> Iterator[str]:
    shown, *others = [f"Fig.~\\ref{{fig:{slug(s)}-{n}}}" for n in range(1, figures + 1)] or [""]
    shown = f" ({shown})" if shown else ""
    if s.robot and s.robot.robot.limbs:
        yield from _of_joints(s, s.robot, shown, f" ({listed(others)})" if others else "")
    else:
        assert s.lines is not None
        yield _of_legs(s.lines, shown) + _works(s)
    if s.lines is not None:
        yield _NOTATION


_NOUNS = ("robot", "platform", "wrist", "head")
_COMMON = ("Planar", "Spherical", "Robot")  # words of titles that are no names

_NOTATION = (
    r"A point is the column of its homogeneous coordinates, a bracket $[\cdots]$ the determinant of such columns;"
    r" points side by side, or $\vee$, denote the join, and $\wedge$ the meet of flats. The superbracket"
    rf" $[\![\cdots]\!]$ is the determinant of the Pl\"{{u}}cker coordinates of lines~\cite{{{','.join(_ALGEBRA)}}}."
)


def _of_legs(a: Analysis, shown: str) -> str:
    s = a.structure
    number = _COUNTS.get(len(s.legs), str(len(s.legs)))
    words = f"We consider two rigid bodies{shown} that are joined by {number} legs."
    if s.base and s.platform:
        words = f"We consider a parallel robot{shown} whose platform is joined to its base by {number} legs."
    shared = len({end for leg in s.legs for end in leg}) < 2 * len(s.legs)
    words += (
        f"{' Legs that share a joint share its name: they' if shared else ' They'} are {_lines_and_screws(s.lines)}."
    )
    if s.base and s.platform:
        words += f" The joints of the base are {_points(s.base)}, those of the platform {_points(s.platform)}."
    if s.ideal:
        words += f" At infinity {'lie' if len(s.ideal) > 1 else 'lies'} {_points(s.ideal)}."
    if a.match:
        words += f" This is class {latex_words(a.match.entry.id)} of the catalog of gcrules~\\cite{{{OWN_KEY}}}."
    return words


def _of_joints(s: Subject, a: RobotAnalysis, shown: str, lines_shown: str) -> Iterator[str]:
    t = a.structure
    words = f"We consider {_named(a.robot.title)}{shown}, with the limbs {latex_words(a.robot.chain)}."
    words += f" Its platform has mobility {t.mobility}"
    words += f", and there are {t.overconstraints} overconstraints" * (t.overconstraints > 0)
    words += f" and {t.redundant} actuators beyond the freedoms" * (t.redundant > 0)
    yield f"{words}.{_works(s)} With the actuators locked its limbs apply these wrenches:"
    yield itemized(map(_limb, t.limbs))
    if a.wrenches:
        yield "Wrenches at home that are not such lines:"
        yield itemized(latex_words(str(one)) for one in a.wrenches)
    if s.lines is not None:
        chosen = ", chosen among those of all limbs," * _chosen(a)
        words = f"So the lines{chosen} {_listed(s.lines.structure.lines)} stand for the robot{lines_shown}."
        if t.ideal:
            words += f" At infinity {'lie' if len(t.ideal) > 1 else 'lies'} {_points(t.ideal)}."
        named = [f"${breakable(Point(n))}$ is {named_words(what, s.names)}" for n, what in t.named]
        yield words + (f" Here {'; '.join(named)}." if named else "")


def _chosen(a: RobotAnalysis) -> bool:
    """Whether the lines are some of more wrenches, and may depend on each other where all of them hold the platform."""
    return a.structure.redundant > 0 or a.structure.over > 0


def _named(title: str) -> str:
    """A robot by its title within a sentence: "the planar 3-RPR robot", "the robot Tricept, 3-UPS + UP"."""
    first, _, rest = title.partition(" ")
    if not any(noun in title.lower() for noun in _NOUNS):
        return f"the robot {latex_words(title)}"
    return f"the {latex_words(f'{first.lower() if first in _COMMON else first} {rest}')}"


def _limb(limb: LimbWrenches) -> str:
    limb_named = f"{latex_words(limb.limb.name)} ({latex_words(limb.limb.chain)})"
    what = f"{limb_named}: {latex_words(limb.kind)}"
    if limb.lines is None:
        return f"{what}; no lines that can be named span it"
    lines = listed([_line(one) for one in limb.lines])
    return f"{limb_named}: {lines}" if limb.kind in ("force", "couple") else f"{what}, spanned by {lines}"


def _line(line: WrenchLine) -> str:
    ends = r"\gcbreak\,".join(breakable(Point(n)) for n in line.ends)
    ends = ends.replace(r"\gcbreak\,", "") if all(len(n) < 4 for n in line.ends) else ends
    return f"the {'couple' if line.couple else 'force'} ${ends}$" + " (constraint)" * (line.role == "constraint")


def _works(s: Subject) -> str:
    found = cited_in(s.source)
    return f" See~\\cite{{{','.join(found)}}}." if found else ""


def _lines_and_screws(legs: Sequence[Expr]) -> str:
    """ "the lines Aa and Bb and the screws S and T"."""
    lines, screws = ([e for e in legs if isinstance(e, Screw) == is_screw] for is_screw in (False, True))
    parts = [
        f"the {kind}{'s' * (len(some) > 1)} {_listed(some)}"
        for kind, some in (("line", lines), ("screw", screws))
        if some
    ]
    return " and ".join(parts)


def _listed(lines: Sequence[Expr]) -> str:
    return listed([inline(e) for e in lines])


def _points(names: Sequence[str]) -> str:
    return listed([f"${breakable(Point(n))}$" for n in names])


# --- theorem and proof ---------------------------------------------------------------------------------------------


def _result(s: Subject) -> Iterator[str]:
    lines = [n for n, _ in s.condition.lines] if s.condition else ()
    said = latex_words(s.whose) + sentence(_without_definitions(s), lines, s.names)
    if s.condition is None or s.lines is None:
        before = in_every_pose(s.robot) if s.robot else ()
        yield from map(latex_words, before)
        yield said
        return
    kind = "theorem" if s.proved else "observation"
    identity = equation(*s.sides, f"eq:{slug(s)}")
    assumed = supposed(s.lines.structure, inline, lambda words: named_words(words, s.names))
    lead = "The identity" if s.proved else "At all points tried, the identity"
    equal = "" if _says_nothing(s) else f"{lead}\n{identity}\nholds."
    within = "Suppose that the limbs apply the wrenches above." if s.robot and s.robot.robot.limbs else ""
    yield "\n".join(
        [
            rf"\begin{{{kind}}}[{{{latex_words(s.title)}}}]\label{{thm:{slug(s)}}}",
            " ".join(filter(None, [assumed, equal, within, said])),
            rf"\end{{{kind}}}",
        ]
    )
    yield "\n".join([r"\begin{proof}" + _heading(s), *_proof(s, s.lines), r"\end{proof}"])


def _without_definitions(s: Subject) -> Statement:
    """What is said, without what derived names are where the lines were introduced with it."""
    named = s.robot.structure.named if s.robot and s.lines is not None else ()
    pieces = s.meaning.pieces
    places = [n for n, piece in enumerate(pieces) if isinstance(piece, str) and piece.endswith(" Here ")]
    if not places or not any(str(pieces[places[-1] + 1]) == name for name, _ in named):
        return s.meaning
    last = str(pieces[places[-1]]).removesuffix(" Here ")
    return Statement((*pieces[: places[-1]], last))


def _heading(s: Subject) -> str:
    if not s.proved:
        return "[How sure this is]"
    if not (s.robot and s.robot.robot.limbs):
        return ""
    return "[On what this rests]" if _says_nothing(s) else "[Proof of the identity, and how sure the rest is]"


def _proof(s: Subject, a: Analysis) -> Iterator[str]:
    assert s.condition is not None
    number = _COUNTS.get(len(a.structure.legs), str(len(a.structure.legs)))
    when = "only if" if s.robot and _chosen(s.robot) else "exactly when"
    yield (
        f"With the actuators locked the platform can move to first order {when} the {number} lines are linearly"
        " dependent, that is, if the superbracket vanishes."
    )
    yield _certified(s, s.condition)
    terms = a.shortest.polynomial
    if a.shortest.form and s.condition.kind != "always-singular" and 0 < len(terms) <= _SHORT:
        whole = (terms * a.shortest.sign).to_expr()
        yield f"Expanded, the superbracket has {len(terms)} term{'s' * (len(terms) > 1)}:"
        yield displayed("", whole) + r"\noindent"
    yield from _vanishing(s.condition.expression)
    if s.condition.cofactor != ONE:
        yield (
            f"Where the cofactor {inline(s.condition.cofactor)} vanishes, both sides do, whether or not the robot is"
            " singular; there the identity decides nothing."
        )


def _says_nothing(s: Subject) -> bool:
    """Whether both sides of the identity are the superbracket itself."""
    left, right = s.sides
    return str(left) == str(right)


_OF_THE_LINES = {"the identity of the lines: holds": "holds", "the identity of the lines: ": "is "}
"""How the certificate of a robot begins, and how it goes on in a sentence about the numbered identity."""


def _certified(s: Subject, c: Condition) -> str:
    """How sure the identity is, and of a robot of joints what else was found."""
    if s.robot and s.robot.robot.limbs:
        detail = s.robot.certificate
        if not _says_nothing(s):
            number = rf"Identity~\eqref{{eq:{slug(s)}}} of the lines"
            for before, after in _OF_THE_LINES.items():
                if detail.startswith(before):
                    return f"{number} {after}{latex_words(detail.removeprefix(before))}."
        return f"{latex_words(detail[:1].upper() + detail[1:])}."
    if _says_nothing(s):
        return (
            r"Lines are dependent exactly when their Pl\"{u}cker coordinates lie in one hyperplane, that is, when they"
            " belong to one linear complex: exactly when a screw that is reciprocal to five of them, which there always"
            " is, is reciprocal to the sixth. The mutual moment of a line and a screw of pitch $h$ is proportional to"
            r" $h\cos w - r\sin w$."
        )
    detail = c.certificate.detail
    if detail.startswith("proved"):
        return f"Identity~\\eqref{{eq:{slug(s)}}} is {latex_words(detail)}."
    return f"Identity~\\eqref{{eq:{slug(s)}}} {'' if detail.startswith('holds') else 'is '}{latex_words(detail)}."


def _vanishing(e: Expr) -> Iterator[str]:
    """When the kinds of factors that occur vanish."""
    found = factors(e)
    if len(found) > 1:
        yield "The product vanishes exactly when one of its factors does."
    if any(isinstance(f, Bracket) for f in found):
        yield "A bracket vanishes exactly when its points do not span the whole space."
    if any(isinstance(f, Meet) for f in found):
        yield (
            "A meet of value $0$ says that the flats have a point in common, possibly at infinity, or that one of them"
            " is not determined."
        )


# --- what else is known --------------------------------------------------------------------------------------------

_TOLD = (
    LIMBS,
    LINES,
    CONDITION,
    FACTORS,
    "Wrenches at home that are not such lines",
    TITLES["dimensions"],
    "Certificate",
)


def _limits(s: Subject) -> Iterator[str]:
    """Factors of a robot's condition told apart, and the singularities of its limbs."""
    a = s.robot
    if a is None:
        return
    if len(a.parts) > 1 or any(p.kind in ("never", "choice", "limb") for p in a.parts):
        identity = s.condition is not None and s.lines is not None and not _says_nothing(s)
        which = "The factors of the right side are, for this robot:" if identity else "Factors that were found:"
        yield rf"\paragraph{{Factors.}} {which}"
        yield itemized(alike((inline(p.expression), named_words(factor_words(p), s.names)) for p in a.parts))
    if a.cofactors:
        yield f"Of the left side {listed([inline(e) for e in a.cofactors])} may vanish in poses that are not singular."
    for title, lines in sections(a, True):
        if title not in _TOLD:
            yield rf"\paragraph{{{latex_words(title)}.}}"
            yield itemized(named_words(line.removesuffix(IN_FULL), s.names) for line in lines)


def _numbers(s: Subject) -> Iterator[str]:
    report = s.numbers()
    if report is None:
        return
    caption = f"{latex_words(s.title)}: numbers in {s.pose}"
    yield table(caption, f"tab:{slug(s)}", report.latex())
    yield (
        f"Table~\\ref{{tab:{slug(s)}}} lists the numbers in {s.pose}; the margin $\\sigma$ is $0$ in singular poses."
    )


def _sure(s: Subject, full: bool) -> str:
    steps = f", the steps stand in Appendix~\\ref{{app:{slug(s)}}}" * full
    return (
        rf"\paragraph{{Reproducibility.}} Computed with gcrules, version {__version__}~\cite{{{OWN_KEY}}}{steps}. The"
        rf" SHA-256 digest of the analysis with its certificate begins with \texttt{{{beginning(s.digest)}}}."
        f"{_proved(s)}"
    )


def _proved(s: Subject) -> str:
    """Of the proofs that can be replayed without gcrules, the digest."""
    file = s.proofs
    if file is None:
        return ""
    return (
        rf" Its identities with their proofs, which \texttt{{-{{}}-certificate}} writes and a program checks that"
        rf" shares no code with gcrules, have a digest that begins with \texttt{{{beginning(file.digest)}}}."
    )


# --- the appendix --------------------------------------------------------------------------------------------------


def appendix(s: Subject) -> str:
    """Every single step of the derivation, and what else is known of a robot of joints."""
    return "\n\n".join(_steps(s)) + "\n"


def _steps(s: Subject) -> Iterator[str]:
    yield rf"\section{{Steps of the derivation}}\label{{app:{slug(s)}}}"
    if s.lines is not None:
        d = s.lines.unfolded()
        if d.steps:
            if str(s.lines.condition.expression) != str(s.condition and s.condition.expression):
                yield "The steps lead to the reading with the smallest cofactor."
            yield displayed("", d.before)
            words = reasons(d)
            for step in d.steps:
                if step.steps:
                    yield latex_words(f"{step.rule}: {step.why}")
                for single in step.steps or (step,):
                    yield f"{displayed('{}=', single.after)}\n\\noindent {latex_words(next(words))}"
                yield from (f"assuming that {inline(e)} is not $0$" for e in step.assumed)
