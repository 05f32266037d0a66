"""The commands about robots: robot list, show, check, analyze, pose, docs, export, import, new."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path

import click

from gcrules.apps.cli.analysis_options import robot_analysis
from gcrules.apps.cli.base import SEEDED, ExpressionCommand, seeded
from gcrules.apps.cli.facts_options import facts_options
from gcrules.apps.cli.files import OutputCommand, OutputFile, figure_option, working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import completing
from gcrules.apps.cli.options import length_option, nearest_option, search_option
from gcrules.apps.cli.output import IDS, Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options
from gcrules.apps.cli.robot_docs import docs
from gcrules.apps.cli.robot_export import export
from gcrules.apps.cli.robot_import import import_
from gcrules.apps.cli.sources import in_mode, mode_option, robot_named
from gcrules.core.budget import checkpoint
from gcrules.core.deferred import deferred
from gcrules.core.errors import FileError, GcrulesError, InputError, LimitReached
from gcrules.core.files import write_file
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.conditions.checks import notes
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.description.family import Definition
from gcrules.mechanisms.description.skeleton import skeleton
from gcrules.mechanisms.lines.derived import in_words
from gcrules.mechanisms.load import kind_of_id, read_robot
from gcrules.mechanisms.robot import Robot
from gcrules.rules.factorization import SECONDS
from gcrules.rules.plugin import ROBOT_FILE

__all__ = ["robot"]

_home_remark = deferred("gcrules.poses.limbs.remark:home_remark")  # numpy, for numbers only
_pose = deferred("gcrules.poses.pose:pose")
_singular = deferred("gcrules.poses.pose:singular")
_figure = deferred("gcrules.views.figure:figure")
_save = deferred("gcrules.views.drawing.drawing_files:save")

_OWNERS = {  # of an id: what it is, and the command that shows it
    "robot": ("a robot", "robot show"),
    "class": ("a class of the catalog", "catalog show"),
    "example": ("an example", "analyze"),
}

_plugins = click.option("--plugins", "folders", multiple=True, metavar="DIR", help="Add a folder of plugins.")
_name = click.argument("name", metavar="ID|FILE", shell_complete=completing("robot"))


@click.group()
def robot() -> None:
    """Robots described by their joints: when, and why, is one singular?

    \b
    gcrules robot list
    gcrules robot analyze 3-rps
    gcrules robot new my-robot
    gcrules robot check my-robot/robot.yaml

    A robot is a file of data, `robot.yaml`, in a folder that bears its id; docs/robots.md describes it. "-" reads the
    file from standard input.
    """


@robot.command("list", short_help="List all robots that are known.")
@_plugins
@output_options(latex=False, brief=IDS, full="Show each robot as `robot show` does.")
def list_command(folders: tuple[str, ...], out: Output) -> None:
    """List all robots that are known: id, mobility of the platform, title."""
    known = robots(folders)
    if out.brief:
        out.write("\n".join(one.id for one in known))
        return
    found = [(one, read_robot(one.path)) for one in known]
    if out.json:
        rows = [
            {"id": one.id, "title": r.title, "limbs": r.chain, "mobility": r.mobility, "owner": one.owner}
            for one, r in found
        ]
        out.write(json.dumps({"robots": rows}, indent=2))
        return
    if out.full:
        out.write("\n\n".join("\n".join(_shown(r)) for _, r in found))
        return
    width = max((len(one.id) for one, _ in found), default=0)
    owners = ("" if one.owner == "gcrules" else f" ({one.owner})" for one, _ in found)
    lines = [f"{one.id:<{width}}  {r.mobility}  {r.title}{o}" for (one, r), o in zip(found, owners, strict=True)]
    out.write("\n".join(lines))


@robot.command("show", short_help="Show what a robot's file says.")
@_name
@_plugins
def show_command(name: str, folders: tuple[str, ...]) -> None:
    """Show a robot: its points and directions with the relations that make them, and its limbs."""
    click.echo("\n".join(_shown(robot_named(name, folders))))


def _by_number(d: Definition) -> tuple[str, int]:
    digits = "".join(c for c in d.name if c.isdigit())
    return d.name.replace(digits, ""), int(digits or 0)


def _shown(r: Robot) -> Iterator[str]:
    yield f"{r.title} ({r.id}): {r.chain or 'given by its lines'}, mobility {r.mobility}"
    for key, value in (("source", r.source), ("note", r.note), ("file", r.filename)):
        if value:
            yield f"{key}: {os.path.relpath(value) if key == 'file' else value}"
    for sort in ("point", "direction"):
        made = [d for d in r.family.definitions if d.sort == sort]
        if made:
            yield f"{sort}s:"
        yield from (f"  {d.name}: {d.text}" for d in sorted(made, key=_by_number))
    if r.limbs:
        yield "limbs:"
        for limb in r.limbs:
            if limb.subchains:
                yield f"  {limb.name}:"
                yield from (f"    {line}" for line in limb.lines)
            else:
                yield from (f"  {limb.name}: {line}" for line in limb.lines)
    if r.lines:
        yield f"lines: {' '.join(''.join(line) for line in r.lines)}"
        yield from (f"  {d.name}: {in_words(r.derived, d.name)}" for d in r.derived if d.is_point)
    if r.limits:
        yield f"limits: {r.limits}"
    if r.platform:
        yield f"platform: {' '.join(r.platform)}"


@robot.command("check", short_help="Check robot files; all, if none is named.")
@click.argument("names", nargs=-1, metavar="[ID|FILE]...", shell_complete=completing("robot"))
@_plugins
@time_limit(None)
@click.pass_context
def check_command(ctx: click.Context, names: tuple[str, ...], folders: tuple[str, ...]) -> None:
    """Check robots (all, if none is named): their files, on random exact members, and the published condition.

    Exit code 0: all are sound. 1: a published condition is refuted. 2: a file is at fault. 3: a robot is not decided
    within the time; with --seconds those after it are left out, and counted.
    """
    code = 0
    chosen = names or [one.path for one in robots(folders)]
    for number, name in enumerate(chosen):
        try:
            checkpoint()
        except LimitReached as over:
            left = f"{len(chosen) - number} of {len(chosen)} robots are not checked"
            raise LimitReached(f"{over.message}: {left}", hint=over.hint) from None
        try:
            found = robot_named(name, folders)
            analysis = analyze_robot(found)
        except GcrulesError as fault:
            if fault.place is None:
                fault.filename = name
            click.echo(fault.render(), err=True)
            code = max(code, fault.exit_code)
            continue
        published = analysis.published
        said = f"; published condition {published.verdict}: {published.detail}" if published else ""
        if published and published.verdict == "refuted":
            code = max(code, 1)
        home = "home satisfies the relations" if found.home is not None else "no home"
        click.echo(
            f"{found.id}: mobility {analysis.structure.mobility}, {home},"
            f" {analysis.members} members and {analysis.met} singular members checked{said}"
        )
        if remark := _home_remark(analysis):
            click.echo(f"  warning: {remark}")
        for note in notes(found):
            click.echo(f"  note: {note}")
    ctx.exit(code)


@robot.command("analyze", short_help="Tell when and why a robot is singular.")
@_name
@mode_option
@_plugins
@search_option(SECONDS)
@facts_options
@figure_option
@time_limit(plus="search")
@proof_options
@output_options()
def analyze_command(
    name: str,
    mode: str | None,
    folders: tuple[str, ...],
    search: float,
    facts: bool,
    tolerance: float,
    figure: str | None,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Tell when and why a robot is singular: wrenches of its limbs, equivalent lines, condition, sentence.

    \b
    gcrules robot analyze 3-rps
    gcrules robot analyze my-robot/robot.yaml --json
    gcrules robot analyze delta --figure delta.svg
    """
    found = robot_analysis(_read(name, folders, mode), search, facts, tolerance)
    if figure:
        _save(_figure(found), figure)
    out.show(found)
    proofs.write(found)


@robot.command("pose", cls=ExpressionCommand, short_help="Tell how close it is to a singularity, and solve its joints.")
@_name
@mode_option
@_plugins
@click.option("--at", metavar="POSE", help='"z=0.2, roll=5deg, …" or "x y z; euler zyx a b c deg"; home by default.')
@click.option("--actuators", metavar="VALUES", help='Instead of a pose: "q1=0.1, q2=5deg", from home.')
@click.option(
    "--threshold", default="0.5 deg", show_default=True, metavar="ANGLE", help="Closer than this is close (deg, rad)."
)
@length_option
@nearest_option
@time_limit()
@click.option(
    "--search",
    is_flag=True,
    help="Find the first singular configuration on the way there from home, or prove that there is none.",
)
@output_options()
def pose_command(
    name: str,
    mode: str | None,
    folders: tuple[str, ...],
    at: str | None,
    actuators: str | None,
    threshold: str,
    nearest: bool,
    length: str | None,
    search: bool,
    out: Output,
) -> None:
    """Tell how close a robot is to a singularity in a configuration, and why; solve its joints for a pose.

    \b
    gcrules robot pose 3-rps
    gcrules robot pose 3-rps --at "z=0.2, roll=5deg, pitch=0deg"
    gcrules robot pose 3-rps --actuators "q1=0.1, q2=0.2" --json
    gcrules robot pose 3-rps --at "z=0, roll=60deg, pitch=0deg" --search

    Coordinates are x, y, z of the platform's centre and roll, pitch, yaw about the fixed axes (or rx, ry, rz, the
    rotation vector), as many as the platform has freedoms; the others follow. All are from home.
    """
    read = _read(name, folders, mode)
    with working("computing"):
        if not search:
            out.show(_pose(read, at, actuators=actuators, threshold=threshold, nearest=nearest, length=length))
            return
        found = _singular(read, at, actuators=actuators, threshold=threshold)
    if found is None:
        click.echo(f"no configuration on the way to {at or actuators} is singular, proved")
        raise click.exceptions.Exit(1)
    out.show(found)


def _read(name: str, folders: tuple[str, ...], mode: str | None) -> Robot:
    """The robot, with its home in a mode."""
    found = in_mode(robot_named(name, folders), mode)
    assert isinstance(found, Robot)
    return found


@robot.command("new", cls=OutputCommand, short_help="Write a robot file to begin with.")
@click.argument("robot_id", metavar="ID")
@click.option(
    "-o",
    "--output",
    "path",
    type=OutputFile(),
    metavar="FILE",
    help="Where to write it; ID/robot.yaml by default.",
)
def new_command(robot_id: str, path: str | None) -> None:
    """Write a commented robot file to begin with; it passes `gcrules robot check`."""
    text = skeleton(robot_id)
    if kind := kind_of_id(robot_id):
        what, command = _OWNERS[kind]
        raise InputError(
            f"{robot_id} is already the id of {what}",
            hint=f"choose another one; `gcrules {command} {robot_id}` shows what has it",
        )
    if path is None:
        folder = Path(robot_id)
        try:
            folder.mkdir(exist_ok=True)
        except OSError as fault:
            raise FileError(f"cannot be made: {fault.strerror}", filename=str(folder)) from None
        path = str(folder / ROBOT_FILE)
    if path != "-" and os.path.exists(path):
        raise FileError("there is already a file of this name", filename=path)
    write_file(path, text)
    if path != "-":
        click.echo(f"{path} is written; check it with: gcrules robot check {path}")


robot.add_command(docs)
robot.add_command(export)
robot.add_command(import_)
for _decides in SEEDED:
    if _decides in robot.commands:
        seeded(robot.commands[_decides])
