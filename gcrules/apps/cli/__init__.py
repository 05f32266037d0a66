"""The command line: `gcrules COMMAND …`; one module for each family of commands, loaded when it is used."""

from __future__ import annotations

import io
import os
import traceback

import click

from gcrules.apps.cli.base import COMPLETING, LazyGroup, colour_choice
from gcrules.core import interrupts
from gcrules.core.errors import printable
from gcrules.core.version import __version__

__all__ = ["answered", "cli"]

INTERNAL_FAULT = 70

COMMANDS = {
    "analyze": ("gcrules.apps.cli.legs:analyze", "Tell when and why a robot with six legs is singular."),
    "pose": ("gcrules.apps.cli.pose:pose", "Tell how close a robot is to a singularity in a pose."),
    "path": ("gcrules.apps.cli.path:path", "Find every singular pose on a path of a robot."),
    "plan": ("gcrules.apps.cli.plan:plan", "Find a way without a singularity, or prove that there is none."),
    "aspects": ("gcrules.apps.cli.aspects:aspects", "Find which poses are connected without a singularity."),
    "certify": ("gcrules.apps.cli.certify:certify", "Prove that a whole range has no singular pose, or find one."),
    "free": ("gcrules.apps.cli.free:free", "Find the largest region around a pose that is proved free."),
    "regions": (
        "gcrules.apps.cli.regions:regions",
        "Find the regions into which singular lengths divide a robot's leg lengths.",
    ),
    "modes": ("gcrules.apps.cli.modes:modes", "Find all poses that a robot can take with its actuators held."),
    "locus": ("gcrules.apps.cli.locus:locus", "Compute the polynomial whose zeros are a robot's singular poses."),
    "map": (
        "gcrules.apps.cli.map:map_",
        "Map the singular poses over two or three coordinates; prove whole ranges of up to six.",
    ),
    "export": ("gcrules.apps.cli.export:export", "Write the condition as source code for a controller."),
    "report": ("gcrules.apps.cli.legs:report", "Write the analysis as a self-contained HTML page."),
    "paper": ("gcrules.apps.cli.paper:paper", "Write the analysis as a section of a paper in LaTeX."),
    "cite": ("gcrules.apps.cli.paper:cite", "Print how to cite gcrules, as BibTeX."),
    "studio": ("gcrules.apps.cli.studio:studio", "Open a page that leads through an analysis, in the browser."),
    "prove": ("gcrules.apps.cli.algebra:prove", 'Decide an identity "LHS == RHS".'),
    "expand": ("gcrules.apps.cli.algebra:expand", "Expand an expression into brackets."),
    "straighten": (
        "gcrules.apps.cli.algebra:straighten",
        "Bring an expression into its normal form of standard tableaux.",
    ),
    "factor": ("gcrules.apps.cli.factor:factor", "Decide whether a scalar is one expression of joins and meets."),
    "factors": ("gcrules.apps.cli.factors:factors", "Find the irreducible factors of a scalar, each with a form."),
    "transversals": (
        "gcrules.apps.cli.transversals:transversals",
        "Compare the turns about two lines that meet four legs.",
    ),
    "shorten": ("gcrules.apps.cli.shorten:shorten", "Find the shortest bracket polynomial that equals a scalar."),
    "discover": ("gcrules.apps.cli.discover:discover", "Find the theorems of a construction, and prove them."),
    "run": ("gcrules.apps.cli.scripts:run", "Run a script of statements and report every claim."),
    "rewrite": ("gcrules.apps.cli.scripts:rewrite", "Rewrite an expression by rules, step by step."),
    "repl": ("gcrules.apps.cli.repl:repl", "Type expressions and statements, and get an answer to each."),
    "rules": ("gcrules.apps.cli.rules:rules", "List, show and check rules."),
    "robot": ("gcrules.apps.cli.robot:robot", "List, show, check or analyse robots described by their joints."),
    "catalog": ("gcrules.apps.cli.catalog:catalog", "List, show, check or enumerate the classes of platforms."),
    "checkers": ("gcrules.apps.cli.checkers:checkers", "Write the programs that check proofs and certificates."),
    "completion": ("gcrules.apps.cli.completion:completion", "Print the script that completes commands in a shell."),
}


@click.group(
    cls=LazyGroup,
    table=COMMANDS,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
    epilog="Exit codes: 0 done or proved, 1 the answer is no, 2 the input is at fault, 3 not decided within a limit;"
    " 130 interrupted, 143 terminated. Output files are written with code 0 or 1, by certify also with 3.",
)
@click.version_option(__version__, message="gcrules %(version)s")
@click.pass_context
def cli(ctx: click.Context) -> None:
    """Tells when, and why, a parallel robot is singular.

    \b
    gcrules analyze "ab af cb cd ed ef"
    gcrules prove "ab /\\ cd == [abcd]"
    """
    ctx.color = colour_choice()


def answered() -> int:
    """The exit code of the command line, whose answer is printed. A fault of gcrules itself shows its traceback and has
    code 70, unlike any answer.
    """
    try:
        return int(cli.main(prog_name="gcrules", standalone_mode=False) or 0)
    except click.ClickException as fault:
        shown = io.StringIO()
        fault.show(shown)
        click.echo(printable(shown.getvalue()), err=True, nl=False)  # it quotes words of the command line
        return fault.exit_code
    except KeyboardInterrupt:
        raise
    except BaseException as fault:
        if isinstance(fault, SystemExit) and COMPLETING in os.environ:  # click's own, after what a shell completes
            return int(fault.code or 0)
        if interrupts.pending() is None:
            traceback.print_exception(fault)
            click.echo(
                "This is a fault of gcrules, not of your input; please report it with the lines above.", err=True
            )
        return INTERNAL_FAULT
