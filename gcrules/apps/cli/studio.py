"""The command studio: the page that leads through an analysis."""

from __future__ import annotations

import click

from gcrules.apps.cli.files import read_stdin
from gcrules.apps.cli.naming import complete_source
from gcrules.apps.cli.sources import mode_option
from gcrules.apps.studio.needs import of_studio
from gcrules.apps.studio.protocol.requests import SourceJson
from gcrules.apps.studio.sources import source_of_word
from gcrules.apps.studio.subject import read_subject
from gcrules.rules.plugins import load_rules

__all__ = ["studio"]

_PLUGINS = "Let the rules of a folder of plugins take part on the bench (its rules.py files are run)."
_PORT = "The port, 8747 if not given; if it is taken, the next free one. 0 means any."


@click.command()
@click.argument("source", metavar="[FILE|ID|LEGS]", required=False, shell_complete=complete_source)
@mode_option
@click.option("--port", type=click.IntRange(0, 65535), default=None, metavar="N", help=_PORT)
@click.option("--plugins", "folders", multiple=True, metavar="DIR", help=_PLUGINS)
@click.option("--no-browser", is_flag=True, help="Print the address only.")
def studio(source: str | None, mode: str | None, port: int | None, folders: tuple[str, ...], no_browser: bool) -> None:
    """Open the studio: a page on your own machine that leads through an analysis.

    \b
    gcrules studio
    gcrules studio robot.yaml
    gcrules studio 3-rps
    gcrules studio "ab af cb cd ed ef" --port 9000 --no-browser
    gcrules studio --plugins mine

    What it is given is opened at once: a platform file or a robot file ("-" is standard input), the id of a class, of
    a robot or of an example, or six legs. The server listens on 127.0.0.1 only, and nothing leaves the machine. Ctrl-C
    closes it.
    """
    usual, serve = of_studio("serving:PORT"), of_studio("serving:serve")
    if source is None and mode is not None:
        raise click.UsageError("--mode is that of a robot: name one.")
    if folders:
        load_rules(folders=folders)  # a plugin that is wrong is told before a page is opened
    opened = None if source is None else _source(source, mode)
    serve(opened, folders=folders, port=usual if port is None else port, browser=not no_browser, say=click.echo)


def _source(word: str, mode: str | None) -> SourceJson:
    """What the word means: a file, an id, or legs. Faults show here, before a page is opened."""
    found = source_of_word(word, mode, read_stdin)
    if found["kind"] != "class":
        read_subject(found)
    return found
