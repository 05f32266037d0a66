"""`gcrules robot docs`: write a page for each robot, or tell whether the pages are stale."""

from __future__ import annotations

import click

from gcrules.apps.cli.files import working
from gcrules.apps.cli.limits import time_limit
from gcrules.apps.cli.only import check_known, only_option, only_words
from gcrules.apps.cli.output import Output, json_option
from gcrules.apps.cli.page_files import renew
from gcrules.core.deferred import deferred
from gcrules.mechanisms.description.discovery import robots
from gcrules.mechanisms.load import read_robot
from gcrules.views.pages.robot_index import FIGURES, HEAD

__all__ = ["docs"]

robot_pages = deferred("gcrules.views.pages.robot_pages:robot_pages")  # loads numpy and drawing


@click.command()
@click.option("--check", is_flag=True, help="Write nothing; exit code 1 if a page is stale.")
@only_option("robot")
@click.option("--out", default="docs/robots", show_default=True, metavar="DIR", help="The folder of the pages.")
@click.option("--plugins", "folders", multiple=True, metavar="DIR", help="Add a folder of plugins.")
@time_limit(None)
@json_option
@click.pass_context
def docs(
    ctx: click.Context, check: bool, only: tuple[str, ...], out: str, folders: tuple[str, ...], as_json: bool
) -> None:
    """Write a page for each robot, with drawings, and a gallery.

    A page shows the joints and wrenches of a robot, its equivalent structure, the condition, and singular
    configurations.

    \b
    gcrules robot docs
    gcrules robot docs --check
    gcrules robot docs --only 3-rps
    gcrules robot docs --out build/robots --plugins mine
    """
    known = robots(folders)
    check_known(only, [one.id for one in known], "robot", "gcrules robot list")
    with working("computing the pages"):
        pages = robot_pages([read_robot(one.path) for one in known], only)
    command = f"gcrules robot docs{only_words(only)}"
    done = renew(pages, out, head=HEAD, figures=FIGURES, command=command, check=check, complete=not only)
    Output(json=as_json).show(done)
    ctx.exit(1 if check and done.stale else 0)
