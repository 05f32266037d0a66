r"""A robot's condition as source code that needs nothing else, for the on-line check of a controller.

>>> from gcrules.poses.compiling.controller import controller
>>> print(source_code(controller("3-rpr"), "c").splitlines()[0])
// 3-rpr: when is it singular? Written by gcrules ...
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from importlib.resources import files
from string import Template

from gcrules.core.errors import InputError
from gcrules.core.version import __version__
from gcrules.poses.compiling.closed_forms import ClosedForms
from gcrules.poses.compiling.controller import Controller
from gcrules.poses.compiling.loop_tables import LoopTables
from gcrules.poses.compiling.tape import BINARY, Program
from gcrules.views.code.languages import LANGUAGES, Language
from gcrules.views.code.tables import number, table, tables_of, written

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
    looped = isinstance(forms, LoopTables)
    head = "\n".join(spelt.comment.format(line=line).rstrip() for line in _header(robot, spelt))
    sizes = {
        "coordinates": len(robot.coordinates),
        "actuators": len(robot.actuators),
        "factors": len(robot.factors),
        "rows": forms.rows,
        "columns": forms.columns,
    }
    kinds = {"factors": bool(robot.factors), "loops": looped, "forms": not looped}
    numbers = {key: str(size) for key, size in sizes.items()}
    kernel = ""
    if isinstance(forms, LoopTables):
        tables = {key: written(spelt, value) for key, value in tables_of(forms).items()}
        kernel = _template(spelt.loop_template, kinds).substitute(numbers | tables).strip("\n")
    return _template(spelt.template, kinds).substitute(
        numbers,
        name=name,
        NAME=name.upper(),
        header=head,
        kernel=kernel,
        actuator_lines="\n".join(_actuator_lines(robot, spelt)),
        factor_lines="\n".join(_factor_lines(robot, spelt)),
        wrench_lines="\n".join(_wrench_lines(robot, spelt)),
        tests=str(len(robot.tests)),
        test_poses=table(spelt, [t.pose for t in robot.tests]),
        test_actuators=table(spelt, [t.actuators for t in robot.tests]),
        test_factors=table(spelt, [t.factors for t in robot.tests]),
        test_margins=spelt.array.format(items=", ".join(number(t.margin) for t in robot.tests)),
        label=spelt.quoted(name),
    )


def _template(file: str, kinds: Mapping[str, bool]) -> Template:
    """A template without the lines that end in a kind, " @factors" or another one, that a robot has not."""
    kept = []
    for line in files(__package__).joinpath("templates", file).read_text(encoding="utf-8").splitlines():
        kind = next((kind for kind in kinds if line.endswith(f" @{kind}")), "")
        if not kind or kinds[kind]:
            kept.append(line.removesuffix(f" @{kind}"))
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
    yield "margin: sigma, from 0 (singular) to 1; it is the same in every frame and unit."
    if robot.cables:
        yield "Cables only pull: whether positive tensions balance each other (wrench closure) is not said here."
    if robot.mode:
        if len(robot.coordinates) < (3 if robot.plane else 6):
            yield "The platform's other coordinates follow from the loops, or stay 0."
        yield from _wrapped(f"Mode: {robot.mode}.")
    if isinstance(robot.forms, LoopTables):
        yield from _wrapped(
            "The loops are closed by Newton's method, from home straight to the pose in steps of 0.1 (rad, or parts of"
            " the robot's size) at most; a step that fails is halved, down to a thousandth. Values are not numbers"
            " (nan) where this does not get there: the robot does not assemble, or the way leads through a singular"
            " pose. Nothing proves that the steps stay on one branch of solutions, as gcrules pose does; nothing is"
            " said of joint limits, nor of limbs that are singular by themselves."
        )
    elif robot.mode:
        yield from _wrapped("Values are not numbers (nan) where it does not exist: the robot does not assemble there.")
        yield from _wrapped(
            "The closed forms agree with the joints, solved by Newton's method, in poses drawn at random, within 1e-9:"
            " a check by sampling, not a proof. They say nothing of joint limits, nor of limbs that are singular by"
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


def _actuator_lines(robot: Controller, spelt: Language) -> Iterator[str]:
    if isinstance(robot.forms, LoopTables):
        yield spelt.solved.format(what="amounts", into="values")
    else:
        assert robot.forms.actuators
        yield from _inputs(robot, spelt, robot.forms.actuators)
        yield from _amounts(robot.forms, robot.forms.actuators, spelt)


def _factor_lines(robot: Controller, spelt: Language) -> Iterator[str]:
    program = robot.forms.factors
    if not program:
        return
    if isinstance(robot.forms, LoopTables):
        yield spelt.made.format(what="places", into="x", size=program.inputs)
        yield from _lines(program, spelt, "x[{k}]".format)
    else:
        yield from _inputs(robot, spelt, program)
    yield from _values(program, spelt, "values")


def _wrench_lines(robot: Controller, spelt: Language) -> Iterator[str]:
    if isinstance(robot.forms, LoopTables):
        yield spelt.solved.format(what="wrenches", into="w")
    else:
        assert robot.forms.wrenches
        yield from _inputs(robot, spelt, robot.forms.wrenches)
        yield from _values(robot.forms.wrenches, spelt, "w")


def _inputs(robot: Controller, spelt: Language, program: Program) -> Iterator[str]:
    """The lines of a program of the coordinates of a pose."""
    return _lines(program, spelt, lambda k: (spelt.angle if robot.angles[k] else spelt.coordinate).format(k=k))


def _lines(program: Program, spelt: Language, given: Callable[..., str]) -> Iterator[str]:
    """The lines of a program of what is `given`."""
    for n, line in enumerate(program.lines):
        args = [f"v{k}" for k in line.operands]
        match line.op:
            case "input":
                value = given(k=line.args[0])
            case "inv":
                value = spelt.inverse.format(x=args[0])
            case "sqrt":
                value = spelt.root.format(x=args[0])
            case op:
                other = args[1] if op in BINARY else number(line.constant)
                value = f"{args[0]} {_SIGNS[op]} {other}"
        yield spelt.declare.format(n=f"v{n}", value=value)


def _result(program: Program, k: int) -> str:
    r = program.results[k]
    return f"v{r}" if isinstance(r, int) else number(r)


def _values(program: Program, spelt: Language, what: str) -> Iterator[str]:
    for k in range(len(program.results)):
        yield spelt.assign.format(what=what, k=k, value=_result(program, k))


def _amounts(forms: ClosedForms, program: Program, spelt: Language) -> Iterator[str]:
    k = 0
    for place, turn in enumerate(forms.turns):
        value = _result(program, k)
        if turn:
            value = spelt.arctangent.format(x=value, y=_result(program, k + 1))
        yield spelt.assign.format(what="values", k=place, value=value)
        k += 1 + turn
