"""The commands paper and cite: a section of a paper about a robot, and gcrules among its references."""

from __future__ import annotations

import click

from gcrules.apps.cli.analysis_options import AnalysisOptions, analysis_options
from gcrules.apps.cli.base import ExpressionCommand
from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.naming import complete_source
from gcrules.core.deferred import deferred

__all__ = ["cite", "paper"]

_save = deferred("gcrules.views.paper.paper:save")
_own_entry = deferred("gcrules.views.paper.bibliography:own_entry")


@click.command(cls=ExpressionCommand)
@click.argument("legs", nargs=-1, required=True, metavar="LEGS|FILE.yaml|ROBOT", shell_complete=complete_source)
@click.option("-o", "--output", "folder", required=True, metavar="DIR", help="The directory for the files.")
@click.option("--full", is_flag=True, help="Add an appendix with every single step of the derivation.")
@click.option("--force", is_flag=True, help="Overwrite files that gcrules did not write, or that were changed since.")
@time_limit(plus="search")
@analysis_options
def paper(legs: tuple[str, ...], folder: str, full: bool, force: bool, asked: AnalysisOptions) -> None:
    """Write the analysis as a section of a paper in LaTeX, with its figures and references.

    \b
    gcrules paper "ab af cb cd ed ef" -o paper
    gcrules paper platform.yaml -o paper --full
    gcrules paper delta -o paper
    gcrules paper "Aa Ab Bc Bd Ce Cf" --given "coplanar(A, B, a, b)" -o paper

    The files are section.tex, figure.tex (of a robot of joints figure-2.tex too), references.bib, with --full
    appendix.tex, and main.tex, which sets them all: pdflatex main, bibtex main, and pdflatex main twice. The section
    fits columns of any width. A file of one of these names that gcrules did not write, or that was changed since, is
    overwritten with --force only.
    """
    analysis = asked.analysis(legs)
    with working("writing"):
        paths = _save(analysis, folder, full=full, force=force)
    for path in paths:
        click.echo(path)


@click.command()
def cite() -> None:
    """Print gcrules of this version as a BibTeX entry.

    gcrules cite
    """
    click.echo(_own_entry())
