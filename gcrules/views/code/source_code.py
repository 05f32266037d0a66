r"""A robot's condition as source code that needs nothing else, for the on-line check of a controller.

>>> from gcrules.poses.compiling.controller import controller
>>> print(source_code(controller("3-rpr"), "c").splitlines()[0])
// 3-rpr: when is it singular? Written by gcrules ...
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from importlib.resources import files
from math import isfinite
from string import Template

from gcrules.core.errors import InputError
from gcrules.core.version import __version__
from gcrules.poses.compiling.controller import Controller
from gcrules.poses.compiling.tape import BINARY, Program
from gcrules.views.code.languages import LANGUAGES, Language

__all__ = ["source_code"]

_SIGNS = {"add": "+", "sub": "-", "mul": "*", "shift": "+", "scale": "*"}
_WIDTH = 100


def source_code(robot: Controller, language: str) -> str:
    """The file in "c", "cpp", "python" or "rust": functions that give the actuators, the factors and the margin at a
    pose, and a test that compares them with numbers computed without them. Raises InputError for other languages, and
    where a number is beyond floats.
    """
    if language not in LANGUAGES:
        raise InputError(f"code is not written in {language[:40]!r}", hint=f"choose one of {', '.join(LANGUAGES)}")
    spelt = LANGUAGES[language]
    forms, name = robot.forms, _identifier(robot.name)
    assert forms.factors
    assert forms.wrenches
    assert forms.actuators
    return _template(spelt, bool(robot.factors)).substitute(
        name=name,
        NAME=name.upper(),
        header="\n".join(spelt.comment.format(line=line).rstrip() for line in _header(robot, spelt)),
        coordinates=str(len(robot.coordinates)),
        actuators=str(len(robot.actuators)),
        factors=str(len(robot.factors)),
        rows=str(len(forms.wrenches.results) // forms.columns),
        columns=str(forms.columns),
        actuator_lines="\n".join(_body(robot, forms.actuators, spelt, _amounts(robot, spelt))),
        factor_lines="\n".join(_body(robot, forms.factors, spelt, _values(forms.factors, spelt, "values"))),
        wrench_lines="\n".join(_body(robot, forms.wrenches, spelt, _values(forms.wrenches, spelt, "w"))),
        tests=str(len(robot.tests)),
        test_poses=_table(spelt, [t.pose for t in robot.tests]),
        test_actuators=_table(spelt, [t.actuators for t in robot.tests]),
        test_factors=_table(spelt, [t.factors for t in robot.tests]),
        test_margins=spelt.array.format(items=", ".join(_number(t.margin) for t in robot.tests)),
        label=spelt.quoted(name),
    )


_OF_FACTORS = " @factors"
"""Ends lines of templates that a robot without factors has not."""


def _template(spelt: Language, factors: bool) -> Template:
    every = files(__package__).joinpath("templates", spelt.template).read_text(encoding="utf-8").splitlines()
    kept = (line.removesuffix(_OF_FACTORS) for line in every if factors or not line.endswith(_OF_FACTORS))
    return Template("\n".join([*kept, ""]))


def _identifier(name: str) -> str:
    """In lower case, of letters, digits and underscores."""
    found = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")[:40].strip("_")
    return found if found[:1].isalpha() else f"robot_{found}".rstrip("_")


def _header(robot: Controller, spelt: Language) -> Iterator[str]:
    yield _safe(f"{robot.name}: when is it singular? Written by gcrules {__version__}.")
    if robot.title and robot.title != robot.name:
        yield _safe(robot.title)
    yield ""
    angles = [n for n, angle in zip(robot.coordinates, robot.angles, strict=True) if angle]
    shifts = [n for n in robot.coordinates if n not in angles]
    groups = [(shifts, f"in {robot.unit}" if robot.unit else "in the unit of the file"), (angles, "in rad")]
    words = " and ".join(f"{', '.join(names)} ({unit})" for names, unit in groups if names)
    yield from _wrapped(f"A pose is {words}, in this order; all are 0 at home.")
    yield from _wrapped(f"actuators: {robot.amounts}: {', '.join(robot.actuators)}.")
    if robot.factors:
        yield "factors: numbers that are 0 where the robot is singular, and change their sign there as a rule:"
    for k, factor in enumerate(robot.factors):
        why = factor.statement.rstrip(".")
        if why.startswith("The robot is singular exactly when "):
            why = why.removeprefix("The robot is singular exactly when ")
        yield from _wrapped(f"  {k}: {factor.kind}, {factor.expression}" + (f": {why}." if why else "."))
    yield "margin: sigma, from 0 (singular) to 1; it knows neither unit nor frame."
    if robot.cables:
        yield "Cables only pull: whether positive tensions balance each other (wrench closure) is not said here."
    if robot.mode:
        if len(robot.coordinates) < robot.forms.columns:
            yield "The platform's other coordinates follow from the loops, or stay 0."
        yield from _wrapped(f"Mode: {robot.mode}.")
        yield from _wrapped("Numbers are not numbers (nan) where it does not exist: the robot does not assemble there.")
        yield from _wrapped(
            "The closed forms agree with the joints, solved by Newton's method, in poses drawn at random, within 1e-9:"
            " a check by sampling, no proof. They say nothing of joint limits, nor of limbs that are singular by"
            " themselves."
        )
    yield from _wrapped(f"Test: {spelt.tested}")


def _wrapped(line: str) -> Iterator[str]:
    """Lines of comments: no control characters, and nothing that goes on behind the end of a line."""
    indent = " " * (len(line) - len(line.lstrip()) + 2)
    words, line = _safe(line).split(" "), ""
    for word in words:
        if line.strip() and len(line) + 1 + len(word) > _WIDTH:
            yield _ended(line)
            line = indent + word
        else:
            line = f"{line} {word}" if line else word
    yield _ended(line)


def _safe(line: str) -> str:
    return _ended("".join(c if c.isprintable() else " " for c in line).replace("??/", "?? /"))


def _ended(line: str) -> str:
    return f"{line} ." if line.endswith("\\") else line


def _body(robot: Controller, program: Program, spelt: Language, results: Iterator[str]) -> Iterator[str]:
    """The lines of a program, and what is made of its results."""
    for n, line in enumerate(program.lines):
        args = [f"v{k}" for k in line.operands]
        match line.op:
            case "input":
                k = line.args[0]
                value = (spelt.angle if robot.angles[k] else spelt.coordinate).format(k=k)
            case "inv":
                value = spelt.inverse.format(x=args[0])
            case "sqrt":
                value = spelt.root.format(x=args[0])
            case op:
                other = args[1] if op in BINARY else _number(line.constant)
                value = f"{args[0]} {_SIGNS[op]} {other}"
        yield spelt.declare.format(n=f"v{n}", value=value)
    yield from results


def _result(program: Program, k: int) -> str:
    r = program.results[k]
    return f"v{r}" if isinstance(r, int) else _number(r)


def _values(program: Program, spelt: Language, what: str) -> Iterator[str]:
    for k in range(len(program.results)):
        yield spelt.assign.format(what=what, k=k, value=_result(program, k))


def _amounts(robot: Controller, spelt: Language) -> Iterator[str]:
    program, k = robot.forms.actuators, 0
    assert program
    for place, turn in enumerate(robot.forms.turns):
        value = _result(program, k)
        if turn:
            value = spelt.arctangent.format(x=value, y=_result(program, k + 1))
        yield spelt.assign.format(what="values", k=place, value=value)
        k += 1 + turn


def _table(spelt: Language, rows: list[tuple[float, ...]]) -> str:
    lines = [spelt.array.format(items=", ".join(map(_number, row))) for row in rows]
    return spelt.array.format(items="\n    " + ",\n    ".join(lines))


def _number(x: float | Fraction) -> str:
    """As a literal of all these languages. Raises InputError where it is beyond floats."""
    try:
        found = float(x)
    except OverflowError:
        found = float("inf")
    if not isfinite(found):
        raise InputError("a number of this robot is too large for floats", hint="choose another unit")
    return repr(found)
