"""The commands about six legs: analyze, report."""

from __future__ import annotations

import os
from typing import Any

import click

from gcrules.algebra.language.legs_text import Structure
from gcrules.apps.cli.analysis_options import AnalysisOptions, analysis_options
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import OutputFile, figure_option, working
from gcrules.apps.cli.limits import beside, limited, time_limit
from gcrules.apps.cli.manual_options import ManualOptions, manual_options
from gcrules.apps.cli.naming import complete_source
from gcrules.apps.cli.output import Output, output_options
from gcrules.apps.cli.proof_options import ProofOptions, proof_options
from gcrules.apps.cli.question_options import question_options
from gcrules.conditions.analysis import Analysis
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.errors import InputError
from gcrules.core.files import write_file
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.poses.questions import Questions

__all__ = ["analyze", "report"]

run_manual = deferred("gcrules.apps.cli.manual:run_manual")
rendered = deferred("gcrules.views.report.report:report")
save = deferred("gcrules.views.drawing.drawing_files:save")
figure_of = deferred("gcrules.views.figure:figure")

_LEGS = "LEGS|FILE.yaml|ROBOT"


@click.command(cls=ExpressionCommand)
@click.argument("legs", nargs=-1, metavar=_LEGS, shell_complete=complete_source)
@manual_options
@figure_option
@time_limit(itself=True)
@analysis_options
@proof_options
@output_options()
def analyze(
    legs: tuple[str, ...],
    manual: ManualOptions,
    figure: str | None,
    seconds: float,
    asked: AnalysisOptions,
    proofs: ProofOptions,
    out: Output,
) -> None:
    """Tell when and why a robot with six legs is singular: every stage, the proved condition, a sentence.

    \b
    gcrules analyze "ab af cb cd ed ef"
    gcrules analyze S1A1 S1B1 S1C1 S2A2 S3A3 S3B3 --json
    gcrules analyze platform.yaml --figure platform.svg
    gcrules analyze 3-rps

    A leg is a joint of one body and a joint of the other, in this sequence throughout; joints that legs share bear
    one name. "-" reads legs or a geometry file from standard input. A robot that is described by its joints, an id or a
    robot file, is answered as by `gcrules robot analyze`.

    \b
    gcrules analyze "Aa Ab Bc Bd Ce Cf" --given "coplanar(A, B, a, b)"
    gcrules analyze "Aa Bb Cc ij jk ki" --ideal "i j k"
    gcrules analyze "ab, cd, ef, ag, ch, bdf /\\ egh"
    gcrules analyze "ab cd ef" --rank 3

    Any six lines do: with --given the points are in special position, those of --ideal are at infinity (a line at
    infinity is a couple), and a line may be the meet of two planes. --rank 3 takes three lines of the plane, --rank N
    the N (N - 1) / 2 lines of two rigid bodies joined by so many bars.

    With --manual you propose the entities and the condition, and each is confirmed or refused with the reason; commands
    come from a prompt, from standard input, or from --propose. Then the exit code is 1 if anything was refused.
    """
    if manual.requested:
        _check_manual(legs, figure or out.latex or asked.beside_order_and_names, manual)
        run_manual(_six_legs(legs, asked) if legs else None, asked.order, manual, asked.space, out, seconds)
    if not legs:
        raise click.UsageError(f"Missing argument '{_LEGS}...'.")
    with limited(seconds, beside(asked.search)):
        analysis = asked.analysis(legs)
        if figure:
            save(figure_of(analysis), figure)
        out.show(_InFull(analysis) if out.full and isinstance(analysis, Analysis) else analysis)
        proofs.write(analysis)


@click.command(cls=ExpressionCommand)
@click.argument("legs", nargs=-1, required=True, metavar=_LEGS, shell_complete=complete_source)
@click.option("-o", "--output", "path", type=OutputFile(), default="-", metavar="FILE.html", help="Write to a file.")
@time_limit(plus="search")
@analysis_options
@click.option("--3d/--no-3d", "interactive", default=True, help="Leave the 3D viewer out, for a small file.")
@question_options
def report(legs: tuple[str, ...], path: str, asked: AnalysisOptions, interactive: bool, questions: Questions) -> None:
    """Write the analysis as a self-contained HTML page: formulas, figures, and for a geometry file the numbers.

    \b
    gcrules report "ab af cb cd ed ef" -o octahedron.html
    gcrules report platform.yaml -o platform.html
    gcrules report 3-rps -o 3-rps.html
    gcrules report 3-rps --path home --path "z=0.2, roll=20deg, pitch=10deg" -o 3-rps.html
    gcrules report delta --over "x -0.8:0.8:41" --over "y -0.8:0.8:41" --at "z=0.2" -o delta.html
    gcrules report delta --over "x -0.8:0.8" --over "y -0.8:0.8" --over "z -0.5:0.5" --margin 0.1 -o delta.html

    It takes the same lines as `gcrules analyze`: with --given, --ideal and --rank too; and robots that are described by
    their joints, as `gcrules robot analyze` does: an id, or a robot file. In the page the robot is seen in 3D, and its
    platform can be moved; the page loads nothing, and works from a file. --no-3d leaves that out. --path and
    --over add the singular poses on a path and in a map, with what is proved of them, as `gcrules path`,
    `gcrules map` and, of ranges without a number of nodes, `gcrules map boxes` find them.

    \b
    gcrules report reachy-mini-head --certify "roll -40..40 deg" --certify "yaw -65..65 deg" -o head.html

    --certify adds whether a whole range is free of singular poses, as `gcrules certify` answers it, with its file.

    \b
    gcrules report platform.yaml --modes --aspects --free box -o platform.html
    gcrules report 3-rps --plan home --plan "z=0.2, roll=20deg, pitch=10deg" -o 3-rps.html

    --modes, --aspects, --plan and --free add where the robot can go, with what is proved of it, as `gcrules modes`,
    `gcrules aspects`, `gcrules plan` and `gcrules free` find it.
    """
    _check_page(path)
    analysis = asked.analysis(legs)
    with working("computing"):
        answers = questions.answers(analysis)
    write_file(path, rendered(analysis, interactive=interactive, answers=answers, about=questions.about))


def _six_legs(words: tuple[str, ...], asked: AnalysisOptions) -> Structure | Platform:
    """The legs for manual mode. Raises InputError for robots of joints."""
    loaded = asked.loaded(words)
    if not isinstance(loaded, (Structure, Platform)):
        raise InputError(
            "manual mode is for legs, and this is a robot of joints", hint="`gcrules robot analyze` takes it"
        )
    return loaded


_OTHER_FORMATS = {
    **{f".{e}": "print the page from a browser for a PDF" for e in ("pdf", "ps", "eps")},
    **{f".{e}": f"`gcrules analyze … --figure FILE.{e}` draws a figure" for e in ("svg",)},
    **{f".{e}": "take the picture of the page in a browser" for e in ("png", "jpg", "jpeg", "gif", "webp")},
    **{f".{e}": "`gcrules analyze … --json` prints the data" for e in ("json", "yaml", "yml", "csv", "xml", "toml")},
    **{f".{e}": "`gcrules analyze … --latex` prints LaTeX" for e in ("tex", "latex")},
    **{f".{e}": "`gcrules analyze …` prints text" for e in ("md", "txt", "rst", "doc", "docx", "odt", "rtf")},
    **{f".{e}": "a file of this kind would not open" for e in ("zip", "gz", "ipynb", "py", "gca", "xls", "xlsx")},
}
"""Endings of files that are no pages, and what makes such a file, or comes near it."""


def _check_page(path: str) -> None:
    """Raises InputError for a name that is known to stand for another format than HTML."""
    ending = os.path.splitext(path)[1].lower()
    if ending in _OTHER_FORMATS:
        page = os.path.splitext(path)[0] + ".html"
        raise InputError(
            f"a report is a page in HTML, and {path} is the name of another kind of file",
            hint=f"write {page}; {_OTHER_FORMATS[ending]}",
        )


@dataclass(frozen=True)
class _InFull:
    """An analysis shown with every single step of its derivation."""

    analysis: Analysis

    def to_json(self) -> dict[str, Any]:
        return self.analysis.to_json(full=True)

    def text(self, *, unicode: bool = False) -> str:
        return self.analysis.text(unicode=unicode, full=True)

    def latex(self) -> str:
        return self.analysis.latex(full=True)


def _check_manual(legs: tuple[str, ...], others: object, manual: ManualOptions) -> None:
    """Raises UsageError for what does not go with manual mode."""
    if others:
        raise click.UsageError("Manual mode goes with --order, --points, --ideal and --json, no other options.")
    if "-" in legs and not manual.proposals:
        raise click.UsageError("In manual mode standard input holds the commands, not the legs.")
