"""What the public functions take: one table of kinds of arguments (see `gcrules.core.arguments`)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.syntax import Context
from gcrules.conditions.analysis import Analysis
from gcrules.core.arguments import (
    ANYTHING,
    COUNT,
    DURATION,
    FILE,
    FLAG,
    NAMES,
    NUMBER,
    NUMBERS,
    ROW,
    TEXT,
    TEXTS,
    WHOLE,
    Kind,
    Unfit,
    checked,
    either,
    instance,
    listed,
    mapping,
    optional,
)
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.description.robot_spec import RobotText
from gcrules.rules.rule import RewriteRule
from gcrules.rules.strategy import Strategy
from gcrules.screws.pose import Pose

__all__ = ["SIGNATURES", "public"]

P = ParamSpec("P")
T = TypeVar("T")


def _axis(value: Any) -> Any:
    if type(value).__module__ != "gcrules.poses.maps.axes":  # it loads numpy
        raise Unfit
    return value


_EXPR = either("text or an expression", TEXT, instance("", Expr))
_SCALAR = either(
    "text, an expression or a polynomial in brackets",
    _EXPR,
    instance("", BracketPolynomial, ExtensorPolynomial),
)
_LEG = either("", TEXT, instance("", Expr), listed("", TEXT))
_LEGS = either('legs as text ("ab af cb cd ed ef") or as a sequence of pairs of names', TEXT, listed("", _LEG)).hinting(
    Platform="gc.analyze takes platforms; of their legs take platform.legs",
    Structure="take structure.legs",
    Robot="a robot described by joints has robot.analyze()",
    Path="gc.load_platform reads a geometry file",
)
_LINES = either(
    "legs as text or as a sequence of pairs of names, or a structure", _LEGS, instance("", Structure)
).hinting()
_ANALYZED = either(
    "legs as text or as a sequence of pairs of names, a platform or a structure",
    _LEGS,
    instance("", Structure, Platform),
)
_ORDER = either("an order of the legs as text or as a sequence", TEXT, listed("", either("", WHOLE, _LEG)))
_FILES = listed("names of files", FILE, alone=True)
_ROBOT = either("a platform, its analysis or the name of its geometry file", instance("", Platform, Analysis), FILE)
_AS_PLATFORM = "gcrules.mechanisms.description.as_platform.as_platform"
_OF_JOINTS = f"a robot described by joints has {{}}; {_AS_PLATFORM} makes a platform of six legs"
_ABOUT = either('"origin", "centroid" or a point of three numbers', TEXT, ROW)
_POSE = either("a pose: text, a Pose or three numbers", TEXT, instance("", Pose), NUMBERS)
_POSES = either("a pose, or several: text, a Pose, three numbers, or a sequence of these", _POSE, listed("", _POSE))
_PATH = either("the name of a table, or a sequence of poses", FILE, listed("", _POSE))
_AXES = listed(
    "a sequence of two or three coordinates with their ranges, as text", either("", TEXT, Kind("", _axis)), alone=True
)
_VARIABLES = either("names of variables as text or as a sequence of texts", TEXT, listed("", TEXT))
_VALUES = mapping("", ANYTHING)
_POINTS = mapping("a mapping from names of points to their coordinates", NUMBERS)
_LIMIT = NUMBER.hinting("a number, or None for no limit")
_RULES = listed(
    "names of rules, rules, or names of .gca files", either("", TEXT, instance("", RewriteRule), FILE), alone=True
)
_THRESHOLD = ANYTHING  # whoever reads it says what is missing: the unit
_ANALYSIS = instance("an analysis", Analysis, RobotAnalysis).hinting(
    Platform="gc.report(gc.analyze(platform))", Robot="gc.report(robot.analyze())", str="gc.report(gc.analyze(…))"
)
_VIEWED = either(
    "a platform, an analysis, a robot, or legs as text", _ANALYZED, instance("", Analysis, RobotText, RobotAnalysis)
)


def _robot(method: str) -> Kind:
    words = _OF_JOINTS.format(method) if method else _OF_JOINTS.partition("; ")[2]
    return _ROBOT.hinting(Robot=words, RobotAnalysis=words.replace("robot.", "analysis.robot."))


_SPACE = {"rank": optional(WHOLE), "points": NAMES, "ideal": NAMES}
_LIMITED = {**_SPACE, "limit": COUNT}

SIGNATURES: dict[str, dict[str, Kind]] = {
    "analyze": {
        "legs": _ANALYZED,
        "order": optional(_ORDER),
        "points": NAMES,
        "ideal": NAMES,
        "given": TEXTS,
        "rank": WHOLE,
        "catalogs": _FILES,
        "recheck": FLAG,
        "strategy": optional(instance("a strategy (gc.load_rules().strategy())", Strategy)),
        "search": DURATION,
    },
    "compiled": {"robot": _robot(""), "expression": optional(_EXPR), "about": _ABOUT, "engine": optional(TEXT)},
    "evaluate": {"e": _EXPR, "points": _POINTS, "rank": optional(WHOLE), "modulus": optional(COUNT)},
    "expand": {"e": _EXPR, **_LIMITED},
    "factor": {"e": _SCALAR, **_LIMITED, "all": FLAG, "cofactor": FLAG, "seconds": DURATION},
    "load_platform": {"path": FILE},
    "load_rules": {"files": _FILES, "folders": _FILES, "identities": FLAG},
    "locus": {
        "robot": _robot(""),
        "over": optional(_VARIABLES),
        "fix": optional(either("text or a mapping from variables to values", TEXT, _VALUES)),
        "at": optional(either("a pose as text, or a Pose", TEXT, instance("", Pose))),
        "rotation": TEXT,
        "about": _ABOUT,
        "limit": COUNT,
    },
    "parse": {
        "text": TEXT,
        "rank": WHOLE,
        "points": NAMES,
        "context": optional(instance("a context (gcrules.algebra.language.syntax.Context)", Context)),
    },
    "path": {"robot": _robot(""), "poses": _PATH, "samples": COUNT, "about": _ABOUT, "threshold": _THRESHOLD},
    "pose": {
        "robot": _robot("robot.pose(…)"),
        "at": optional(_POSES),
        "quaternion": optional(NUMBERS),
        "rotation_vector": optional(NUMBERS),
        "euler": optional(ANYTHING),
        "degrees": FLAG,
        "about": _ABOUT,
        "threshold": _THRESHOLD,
        "accuracy": ANYTHING,
        "nearest": FLAG,
    },
    "prove": {"claim": _EXPR, "right": optional(_EXPR), **_LIMITED, "given": TEXTS},
    "report": {"analysis": _ANALYSIS, "interactive": FLAG},
    "rewrite": {"e": _EXPR, "rules": _RULES, **_SPACE},
    "seeded": {"seed": WHOLE},
    "shorten": {"e": _SCALAR, **_LIMITED, "seconds": DURATION},
    "shortest": {"legs": _LEGS, "points": NAMES, "ideal": NAMES},
    "singular_map": {
        "robot": _robot(""),
        "over": _AXES,
        "at": optional(_POSE),
        "about": _ABOUT,
        "limits": optional(TEXT),
        "threshold": _THRESHOLD,
        "measure": TEXT,
        "work": optional(FILE),
        "restart": FLAG,
    },
    "straighten": {"e": _SCALAR, **_LIMITED},
    "superbracket": {"legs": _LEGS, "order": optional(_ORDER), "form": WHOLE, "points": NAMES, "ideal": NAMES},
    "transversals": {"legs": _LINES, "every": FLAG, "points": NAMES, "ideal": NAMES, "given": TEXTS},
    "view": {"robot": _VIEWED, "pose": ANYTHING},
    "within": {
        "seconds": optional(_LIMIT),
        "memory": optional(_LIMIT),
        "progress": optional(instance("a function of one text", Callable)),  # type: ignore[arg-type]
        "grace": DURATION,
    },
}
"""The arguments of each function of `gcrules.api.functions`."""


def public(function: Callable[P, T]) -> Callable[P, T]:
    """The function, whose arguments are checked as the table says."""
    return checked(f"gc.{function.__name__}", **SIGNATURES[function.__name__])(function)
