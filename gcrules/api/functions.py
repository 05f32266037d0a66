"""The public functions, which take text or expressions; `import gcrules` forwards to this module."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import AbstractContextManager
from os import PathLike
from typing import Any

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.decide import decide
from gcrules.algebra.evaluate import evaluate as _evaluate
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.expand import expand as _expand
from gcrules.algebra.expr import Expr, common_rank
from gcrules.algebra.factoring.limits import MAX_EXTENSORS, SECONDS
from gcrules.algebra.factoring.result import Factorization
from gcrules.algebra.language.legs_text import Structure, read_legs, read_order
from gcrules.algebra.language.relations import parse_claim, parse_sides
from gcrules.algebra.language.statements import parse_assumption
from gcrules.algebra.language.syntax import Context
from gcrules.algebra.language.syntax import parse as _parse
from gcrules.algebra.language.text import Names
from gcrules.algebra.prove import Proof
from gcrules.algebra.shortening.limits import MAX_MONOMIALS
from gcrules.algebra.shortening.limits import SECONDS as SECONDS_TO_SHORTEN
from gcrules.algebra.shortening.result import Shortening
from gcrules.algebra.straightening.straighten import straighten as _straighten
from gcrules.algebra.superbrackets.shortest import SuperbracketForm, shortest_forms, superbracket_form
from gcrules.api.reading import expression_of, where
from gcrules.api.signatures import public
from gcrules.conditions.analysis import Analysis
from gcrules.conditions.superbracket_forms import built
from gcrules.conditions.transversals import Transversals
from gcrules.conditions.transversals import transversals as _transversals
from gcrules.core import budget
from gcrules.core.deferred import deferred
from gcrules.core.errors import GcrulesError, InputError, LimitReached, StepError, SyntaxFault
from gcrules.core.seeds import repeated
from gcrules.mechanisms.analyze import analyze as _analyze
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.load import Folders, Source
from gcrules.mechanisms.load import load as _load
from gcrules.mechanisms.robot import Robot
from gcrules.poses.questions import Questions
from gcrules.rules.condition import Condition
from gcrules.rules.library import Library
from gcrules.rules.plugin import Plugin
from gcrules.rules.plugins import load_rules as _load_rules
from gcrules.rules.strategy import Strategy
from gcrules.screws.threshold import DEFAULT

__all__ = [
    "Analysis",
    "BracketPolynomial",
    "Condition",
    "Expr",
    "ExtensorPolynomial",
    "Factorization",
    "GcrulesError",
    "InputError",
    "Library",
    "LimitReached",
    "Platform",
    "Plugin",
    "Proof",
    "Robot",
    "RobotAnalysis",
    "Shortening",
    "StepError",
    "Strategy",
    "Structure",
    "SyntaxFault",
    "Transversals",
    "analyze",
    "evaluate",
    "expand",
    "factor",
    "load",
    "load_rules",
    "paper",
    "parse",
    "prove",
    "report",
    "seeded",
    "shorten",
    "shortest",
    "straighten",
    "superbracket",
    "transversals",
    "within",
]

_in_mode = deferred("gcrules.poses.modes.choose:in_mode")
_paper = deferred("gcrules.views.paper.paper:save")
_report = deferred("gcrules.views.report.report:report")
decided = deferred("gcrules.algebra.factoring.factorize:factor")
shortened = deferred("gcrules.algebra.shortening.shorten:shorten")

analyze = public(_analyze)
load_rules = public(_load_rules)
parse = public(_parse)
transversals = public(_transversals)


@public
def expand(
    e: str | Expr,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    isotropic: Names = (),
    orthonormal: Names = (),
    letters: str = "",
    limit: int = MAX_TERMS,
) -> BracketPolynomial | ExtensorPolynomial:
    """Expand an expression into brackets (step 0) or Σ (bracket polynomial) · extensor (any other step).

    `rank` is that of the expression (4 for text that is read); `points` declares long names and the tableau order,
    `ideal` the points at infinity, as sequences or as text ("left right"). Words such as midpoint(a, b) need points
    at infinity that are `isotropic`, or `orthonormal` directions; `letters` may stand for lines and planes: "line L M,
    plane P". Raises SyntaxFault or StepError for text that does not make sense or another rank, LimitReached beyond
    `limit` terms.
    """
    at = where(rank, points, ideal, isotropic, orthonormal, letters)
    return _expand(expression_of(e, at), points=at.points, ideal=at.ideal, rank=rank, limit=limit)


@public
def straighten(
    e: str | Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    isotropic: Names = (),
    orthonormal: Names = (),
    letters: str = "",
    limit: int = MAX_TERMS,
) -> BracketPolynomial | ExtensorPolynomial:
    """The normal form of standard tableaux; arguments and errors as for `expand`."""
    if isinstance(e, (BracketPolynomial, ExtensorPolynomial)):
        return _straighten(e, limit=limit)
    at = where(rank, points, ideal, isotropic, orthonormal, letters)
    return _straighten(expression_of(e, at), points=at.points, ideal=at.ideal, rank=rank, limit=limit)


@public
def factor(
    e: str | Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    isotropic: Names = (),
    orthonormal: Names = (),
    letters: str = "",
    all: bool = False,
    cofactor: bool = False,
    limit: int = MAX_EXTENSORS,
    seconds: float = SECONDS,
) -> Factorization:
    """Decide whether a scalar is coefficient · Π brackets · ONE expression of joins and meets, letters whole.

    The answer has `exists`, `expression` (None where the family that it names holds none) and `certificate`. `all` asks
    for every expression instead of the simplest, `cofactor` for one that equals a multiple of the scalar where there is
    none. Beyond `limit` extensors or `seconds` the answer is undecided (`exists` is None) and has the known factors as
    `parts`. Raises InputError for zero and for what is not homogeneous, LimitReached where the scalar may be zero.
    """
    at = where(rank, points, ideal, isotropic, orthonormal, letters)
    answer: Factorization = decided(
        e if isinstance(e, (BracketPolynomial, ExtensorPolynomial)) else expression_of(e, at),
        points=at.points,
        ideal=at.ideal,
        rank=rank,
        limit=limit,
        seconds=seconds,
        every=all,
        cofactor=cofactor,
    )
    return answer


@public
def shorten(
    e: str | Expr | BracketPolynomial | ExtensorPolynomial,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    isotropic: Names = (),
    orthonormal: Names = (),
    letters: str = "",
    limit: int = MAX_MONOMIALS,
    seconds: float = SECONDS_TO_SHORTEN,
) -> Shortening:
    """The bracket polynomial with the fewest terms that was found for a scalar, any rational coefficients allowed.

    The answer has `polynomial` (equal to the scalar, proved by normal forms), `terms`, `lower` (no bracket polynomial
    with fewer terms equals it; `bound` says why) and `minimal` (whether these agree). After `seconds` what was found is
    the answer. With more bracket monomials of the multidegree than the `limit` it is `undecided` whether a shorter one
    exists. Raises InputError for extensors and for letters, LimitReached where there is no normal form in the time.
    """
    at = where(rank, points, ideal, isotropic, orthonormal, letters)
    answer: Shortening = shortened(
        e if isinstance(e, (BracketPolynomial, ExtensorPolynomial)) else expression_of(e, at),
        points=at.points,
        ideal=at.ideal,
        rank=rank,
        limit=limit,
        seconds=seconds,
    )
    return answer


@public
def prove(
    claim: str | Expr,
    right: str | Expr | None = None,
    *,
    rank: int | None = None,
    points: Names = (),
    ideal: Names = (),
    isotropic: Names = (),
    orthonormal: Names = (),
    letters: str = "",
    given: str | Iterable[str] = (),
    limit: int = MAX_TERMS,
) -> Proof:
    """Decide "LHS == RHS" (one text or two expressions) or a relation: proved, refuted with exact points, or undecided.

    `given` holds assumptions, as one text or several: "collinear(a, b, c), incident(p, X)", any relation of the
    language, "LHS == RHS", "ideal i j", "isotropic i j". Only positions that satisfy them count, and `assumed` of the
    proof lists what else was assumed not to vanish. Raises InputError for assumptions that are not resolved.
    """
    written_in = common_rank(rank, *(e for e in (claim, right) if isinstance(e, Expr)))
    at = where(written_in, points, ideal, isotropic, orthonormal, letters)
    for written in [given] if isinstance(given, str) else given:
        at = parse_assumption(written, at)
    if right is None:
        if isinstance(claim, Expr):
            raise InputError("one expression is not a claim", hint='gc.prove(left, right), or "LHS == RHS" as text')
        return decide(parse_claim(claim, at), at, limit=limit)
    return decide(parse_sides(claim, right, at), at, limit=limit)


@public
def evaluate(e: str | Expr, points: dict[str, Any], *, rank: int | None = None, modulus: int | None = None) -> Any:
    """The value of an expression at points given by homogeneous coordinates (exact numbers, or arrays of floats)."""
    return _evaluate(expression_of(e, Context(rank or 4, tuple(points))), points, modulus=modulus)


@public
def load(
    source: Source,
    *,
    plugins: Folders = (),
    points: Names = (),
    ideal: Names = (),
    letters: str = "",
    mode: str | None = None,
) -> Structure | Platform | Robot | Analysis | RobotAnalysis:
    """What a source says: a `Structure` of legs, a `Platform` with coordinates, or a `Robot` of joints.

    A source is legs ("ab af cb cd ed ef", or a sequence of pairs of names, read with `points`, `ideal`, `letters`), the
    name or text of a geometry file or robot file, the id of a robot (shipped, or of `plugins`, folders of your own), of
    a class of the catalog or of an example, a mapping with the data of a file, or what was loaded or analysed before,
    which is given back. `analyze`, `report`, `view`, `pose`, `singular`, `path`, `assembly_modes`, `working_modes`,
    `locus`, `compiled` and `singular_map` take the same. With a `mode` the home of a robot or platform is in that mode:
    "+-+", one of its `working_modes`, "assembly 3", one of its `assembly_modes` at home, or "operation 2", one of its
    `operation_modes`. Raises InputError for what is none of these, FileError with all faults of a file.
    """
    found = _load(source, plugins=plugins, points=points, ideal=ideal, letters=letters)
    if letters and not isinstance(found, Structure):
        raise InputError("letters are for legs without coordinates")
    chosen: Structure | Platform | Robot | Analysis | RobotAnalysis = found if mode is None else _in_mode(found, mode)
    return chosen


@public
def paper(
    source: Source,
    folder: str | PathLike[str],
    *,
    full: bool = False,
    force: bool = False,
    letters: str = "",
    plugins: Folders = (),
) -> tuple[str, ...]:
    """Write a source's analysis as a section of a paper in LaTeX, with figures and references, into a folder.

    `full` adds every step; `letters` is as for `analyze`. Returns the names of the files, of which all appear or none.
    Raises FileError where that is not possible, or would replace a file that is not as gcrules wrote it; `force`
    replaces it.
    """
    return tuple(_paper(_analyze(source, letters=letters, plugins=plugins), folder, full=full, force=force))


@public
def report(
    source: Source,
    *,
    interactive: bool = True,
    path: str | PathLike[str] | Sequence[Any] | None = None,
    over: Sequence[Any] | None = None,
    certify: Sequence[Any] | None = None,
    at: Any = None,
    limits: str | None = None,
    within: str | None = None,
    cone: str | None = None,
    tilt: str | None = None,
    margin: float = 0.0,
    resume: str | PathLike[str] | None = None,
    about: str | Sequence[Any] = "centroid",
    threshold: Any = DEFAULT.text,
    modes: bool = False,
    aspects: bool = False,
    plan: Sequence[Any] | None = None,
    free: str | None = None,
    letters: str = "",
    plugins: Folders = (),
) -> str:
    """The HTML page of a source's analysis; of a platform with coordinates also the robot in its pose and the numbers
    there, of a robot with limbs these too.

    `source` and `letters` are what `load` takes. `interactive` adds the 3D viewer (about 700 kB), in which the platform
    can be moved.
    `path`, poses or the name of a table as `gcrules.path` takes them, adds the singular places on that path; `over`,
    coordinates with their ranges as `gcrules.singular_map` takes them with `at` and `limits`, adds the map over them;
    ranges without a number of nodes, as `gcrules.box_map` takes them with `margin` too, that of whole boxes.
    `certify`, ranges as `gcrules.certify` takes them with `at`, `limits`, `cone`, `tilt` and `margin`, adds the
    certificate, which goes on from the file `resume` if there is one.
    `modes` adds the assembly modes (`gcrules.assembly_modes`, `at` a pose), of a robot of joints its working and
    operation modes too; `aspects` its aspects (`gcrules.aspects`); `plan`, a start and a goal or a start alone, a way
    without a singularity (`gcrules.plan`); `free`, "box" or "ball", the largest one that is proved free of singular
    poses (`gcrules.free_region`), `at` the pose. `limits` and `within` are those of aspects and plan, `about` that of
    all, `threshold` that of path, map and modes. Raises InputError where there is no such path, map or pose.
    """
    asked = Questions(
        path=path,
        over=over,
        certify=certify,
        at=at,
        limits=limits,
        within=within,
        cone=cone,
        tilt=tilt,
        margin=margin,
        resume=resume,
        about=about,
        threshold=threshold,
        modes=modes,
        aspects=aspects,
        plan=plan,
        free=free,
    )
    asked.check()
    found = _analyze(source, letters=letters, plugins=plugins)
    return str(_report(found, interactive=interactive, answers=asked.answers(found), about=about))


@public
def superbracket(
    legs: str | Iterable[str | Sequence[str]],
    *,
    order: str | Sequence[int | str] | None = None,
    form: int = 24,
    points: Names = (),
    ideal: Names = (),
    letters: str = "",
) -> SuperbracketForm:
    """The superbracket of six legs as a bracket polynomial, in the 24-term or 16-term form."""
    structure = read_legs(legs, points=points, ideal=ideal, letters=letters)
    chosen = range(6) if order is None else read_order(order, structure)
    lines = structure.lifted
    return built(superbracket_form(lines.legs, chosen, form, points=lines.points, ideal=lines.ideal), structure)


@public
def shortest(
    legs: str | Iterable[str | Sequence[str]], *, points: Names = (), ideal: Names = (), letters: str = ""
) -> SuperbracketForm:
    """The shortest superbracket over all 720 orders and both forms."""
    structure = read_legs(legs, points=points, ideal=ideal, letters=letters)
    lines = structure.lifted
    return built(shortest_forms(lines.legs, points=lines.points, ideal=lines.ideal)[0], structure)


@public
def seeded(seed: int) -> AbstractContextManager[None]:
    """Inside `with gcrules.seeded(7):` exact random checks take the same points in every run, and answers say so.

    Without it nobody can foresee the points, which is what makes an answer that rests on them sure.
    """
    return repeated(seed)


within = public(budget.within)
