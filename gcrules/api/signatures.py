"""What the public functions take: one table of kinds of arguments (see `gcrules.core.arguments`)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from gcrules.algebra.bracket import BracketPolynomial, ExtensorPolynomial
from gcrules.algebra.expr import Expr
from gcrules.algebra.language.legs_text import Structure
from gcrules.algebra.language.syntax import Context
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
    ArgumentKind,
    Unfit,
    checked,
    either,
    instance,
    listed,
    mapping,
    optional,
    row,
)
from gcrules.mechanisms.load import LOADED
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
    Robot="gc.analyze takes robots",
    Path="gc.load reads a file",
)
_LINES = either(
    "legs as text or as a sequence of pairs of names, or a structure", _LEGS, instance("", Structure)
).hinting()
_SOURCE = either(
    "a source: legs, a file, an id, data, or what gc.load and gc.analyze give",
    TEXT,
    instance("", *LOADED),
    FILE,
    mapping("", ANYTHING),
    listed("", _LEG),
).hinting()
_FOLDERS = listed("names of folders", FILE, alone=True)
_PART = either('a part of a job array as text ("3/100") or as two whole numbers', TEXT, row("", WHOLE, WHOLE))
_ORDER = either("an order of the legs as text or as a sequence", TEXT, listed("", either("", WHOLE, _LEG)))
_FILES = listed("names of files", FILE, alone=True)
_ABOUT = either('"origin", "centroid" or a point of three numbers', TEXT, ROW)
_NAMED = mapping("", ANYTHING)
_POSE = either(
    "a pose: text, a mapping from coordinates to numbers, a Pose or three numbers",
    TEXT,
    instance("", Pose),
    _NAMED,
    NUMBERS,
)
_POSES = either(
    "a pose, or several: text, a mapping from coordinates to numbers, a Pose, three numbers, or a sequence of these",
    _POSE,
    listed("", optional(_POSE)),
)
_ACTUATORS = either("amounts of the actuators: text, a mapping or numbers", TEXT, _NAMED, ROW)
_PATH = either("the name of a table, or a sequence of poses", FILE, listed("", _POSE))
_ENDS = listed("a sequence of one pose or two", _POSE)
_AXES = listed(
    "a sequence of coordinates with their ranges, as text",
    either("", TEXT, ArgumentKind("", _axis)),
    alone=True,
)
_VARIABLES = either("names of variables as text or as a sequence of texts", TEXT, listed("", TEXT))
_VALUES = mapping("", ANYTHING)
_POINTS = mapping("a mapping from names of points to their coordinates", NUMBERS)
_LIMIT = NUMBER.hinting("a number, or None for no limit")
_RULES = listed(
    "names of rules, rules, or names of .gca files", either("", TEXT, instance("", RewriteRule), FILE), alone=True
)
_THRESHOLD = ANYTHING  # whoever reads it says what is missing: the unit

_SPACE = {
    "rank": optional(WHOLE),
    "points": NAMES,
    "ideal": NAMES,
    "isotropic": NAMES,
    "orthonormal": NAMES,
    "letters": TEXT,
}
_LIMITED = {**_SPACE, "limit": COUNT}

SIGNATURES: dict[str, dict[str, ArgumentKind]] = {
    "analyze": {
        "source": _SOURCE,
        "order": optional(_ORDER),
        "points": NAMES,
        "ideal": NAMES,
        "given": TEXTS,
        "letters": TEXT,
        "rank": WHOLE,
        "catalogs": _FILES,
        "recheck": FLAG,
        "strategy": optional(instance("a strategy (gc.load_rules().strategy())", Strategy)),
        "search": DURATION,
        "plugins": _FOLDERS,
        "facts": FLAG,
        "tolerance": NUMBER,
    },
    "assembly_modes": {
        "source": _SOURCE,
        "at": optional(_POSE),
        "actuators": optional(_ACTUATORS),
        "degrees": FLAG,
        "about": _ABOUT,
        "threshold": _THRESHOLD,
        "plugins": _FOLDERS,
    },
    "certify": {
        "source": _SOURCE,
        "over": _AXES,
        "at": optional(_POSE),
        "about": _ABOUT,
        "limits": optional(TEXT),
        "cone": optional(TEXT),
        "tilt": optional(TEXT),
        "margin": NUMBER,
        "time": optional(DURATION),
        "boxes": optional(WHOLE),
        "target": either("a share as text or a number", TEXT, NUMBER),
        "resume": optional(FILE),
    },
    "box_map": {
        "source": _SOURCE,
        "over": _AXES,
        "at": optional(_POSE),
        "about": _ABOUT,
        "limits": optional(TEXT),
        "margin": NUMBER,
        "tiles": optional(WHOLE),
        "boxes": optional(WHOLE),
        "work": optional(FILE),
        "restart": FLAG,
        "workers": WHOLE,
        "part": optional(_PART),
        "scheduler": optional(TEXT),
    },
    "compiled": {
        "source": _SOURCE,
        "expression": optional(_EXPR),
        "coordinates": optional(_VARIABLES),
        "about": _ABOUT,
        "engine": optional(TEXT),
    },
    "discover": {
        "script": either("the name of a .gca file, or its text", TEXT, FILE),
        "relations": TEXTS,
        "limit": COUNT,
        "candidates": COUNT,
        "seconds": DURATION,
    },
    "evaluate": {"e": _EXPR, "points": _POINTS, "rank": optional(WHOLE), "modulus": optional(COUNT)},
    "expand": {"e": _EXPR, **_LIMITED},
    "export": {"source": _SOURCE, "language": TEXT, "coordinates": optional(_VARIABLES), "about": _ABOUT},
    "export_model": {"source": _SOURCE, "format": TEXT, "unit": TEXT},
    "factor": {"e": _SCALAR, **_LIMITED, "all": FLAG, "cofactor": FLAG, "seconds": DURATION},
    "factors": {"e": _SCALAR, **_LIMITED, "seconds": DURATION},
    "load": {
        "source": _SOURCE,
        "plugins": _FOLDERS,
        "points": NAMES,
        "ideal": NAMES,
        "letters": TEXT,
        "mode": optional(TEXT),
    },
    "load_rules": {"files": _FILES, "folders": _FILES, "identities": FLAG},
    "locus": {
        "source": _SOURCE,
        "over": optional(_VARIABLES),
        "fix": optional(either("text or a mapping from variables to values", TEXT, _VALUES)),
        "at": optional(_POSE),
        "rotation": TEXT,
        "about": _ABOUT,
        "limit": COUNT,
        "product": optional(FLAG),
    },
    "map_status": {"store": FILE},
    "refine_map": {
        "store": FILE,
        "output": FILE,
        "boxes": optional(WHOLE),
        "over": optional(TEXTS),
        "workers": WHOLE,
        "scheduler": optional(TEXT),
    },
    "merge_maps": {"stores": listed("names of stores", FILE), "output": FILE},
    "operation_modes": {"source": _SOURCE, "plugins": _FOLDERS},
    "free_region": {
        "source": _SOURCE,
        "at": optional(_POSE),
        "over": optional(TEXT),
        "ball": FLAG,
        "boxes": optional(COUNT),
        "about": _ABOUT,
        "plugins": _FOLDERS,
    },
    "length_regions": {
        "source": _SOURCE,
        "over": optional(TEXT),
        "held": optional(TEXT),
        "slices": COUNT,
        "plugins": _FOLDERS,
    },
    "parse": {
        "text": TEXT,
        "rank": WHOLE,
        "points": NAMES,
        "context": optional(instance("a context (gcrules.algebra.language.syntax.Context)", Context)),
    },
    "path": {"source": _SOURCE, "poses": _PATH, "samples": COUNT, "about": _ABOUT, "threshold": _THRESHOLD},
    "aspects": {
        "source": _SOURCE,
        "margin": optional(NUMBER),
        "limits": optional(TEXT),
        "within": optional(TEXT),
        "poses": COUNT,
        "modes": FLAG,
        "states": COUNT,
        "seed": WHOLE,
        "about": _ABOUT,
        "plugins": _FOLDERS,
    },
    "plan": {
        "source": _SOURCE,
        "start": _POSE,
        "goal": optional(_POSE),
        "margin": optional(NUMBER),
        "limits": optional(TEXT),
        "within": optional(TEXT),
        "states": COUNT,
        "seed": WHOLE,
        "about": _ABOUT,
        "plugins": _FOLDERS,
    },
    "pose": {
        "source": _SOURCE,
        "at": optional(_POSES),
        "actuators": optional(_ACTUATORS),
        "quaternion": optional(NUMBERS),
        "rotation_vector": optional(NUMBERS),
        "euler": optional(ANYTHING),
        "degrees": FLAG,
        "about": _ABOUT,
        "threshold": _THRESHOLD,
        "accuracy": ANYTHING,
        "nearest": optional(FLAG),
        "length": ANYTHING,
        "plugins": _FOLDERS,
    },
    "paper": {
        "source": _SOURCE,
        "folder": FILE,
        "full": FLAG,
        "force": FLAG,
        "letters": TEXT,
        "plugins": _FOLDERS,
    },
    "proof_file": {"answer": ANYTHING},
    "prove": {"claim": _EXPR, "right": optional(_EXPR), **_LIMITED, "given": TEXTS},
    "report": {
        "source": _SOURCE,
        "interactive": FLAG,
        "path": optional(_PATH),
        "over": optional(_AXES),
        "certify": optional(_AXES),
        "at": optional(_POSE),
        "limits": optional(TEXT),
        "within": optional(TEXT),
        "cone": optional(TEXT),
        "tilt": optional(TEXT),
        "margin": NUMBER,
        "resume": optional(FILE),
        "about": _ABOUT,
        "threshold": _THRESHOLD,
        "modes": FLAG,
        "aspects": FLAG,
        "plan": optional(_ENDS),
        "free": optional(TEXT),
        "letters": TEXT,
        "plugins": _FOLDERS,
    },
    "rewrite": {"e": _EXPR, "rules": _RULES, **_SPACE},
    "seeded": {"seed": WHOLE},
    "shorten": {"e": _SCALAR, **_LIMITED, "seconds": DURATION},
    "shortest": {"legs": _LEGS, "points": NAMES, "ideal": NAMES, "letters": TEXT},
    "singular": {
        "source": _SOURCE,
        "towards": optional(_POSE),
        "actuators": optional(_ACTUATORS),
        "degrees": FLAG,
        "about": _ABOUT,
        "threshold": _THRESHOLD,
        "plugins": _FOLDERS,
    },
    "singular_map": {
        "source": _SOURCE,
        "over": _AXES,
        "at": optional(_POSE),
        "about": _ABOUT,
        "limits": optional(TEXT),
        "threshold": _THRESHOLD,
        "measure": TEXT,
        "work": optional(FILE),
        "restart": FLAG,
        "workers": WHOLE,
        "part": optional(_PART),
        "scheduler": optional(TEXT),
    },
    "straighten": {"e": _SCALAR, **_LIMITED},
    "studio": {
        "source": _SOURCE,
        "pose": ANYTHING,
        "mode": optional(TEXT),
        "browser": FLAG,
        "plugins": _FOLDERS,
    },
    "superbracket": {
        "legs": _LEGS,
        "order": optional(_ORDER),
        "form": WHOLE,
        "points": NAMES,
        "ideal": NAMES,
        "letters": TEXT,
    },
    "transversals": {
        "legs": _LINES,
        "every": FLAG,
        "points": NAMES,
        "ideal": NAMES,
        "given": TEXTS,
        "letters": TEXT,
    },
    "view": {"source": _SOURCE, "pose": ANYTHING, "plugins": _FOLDERS},
    "working_modes": {
        "source": _SOURCE,
        "at": optional(_POSE),
        "about": _ABOUT,
        "threshold": _THRESHOLD,
        "plugins": _FOLDERS,
    },
    "verify_map": {"store": FILE, "tiles": either('a whole number, or "all"', WHOLE, TEXT)},
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
