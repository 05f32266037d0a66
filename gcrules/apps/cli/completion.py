"""`gcrules completion`."""

from __future__ import annotations

import click
from click.shell_completion import get_completion_class

from gcrules.apps.cli.base import COMPLETING

__all__ = ["completion"]

SHELLS = ("bash", "zsh", "fish")


@click.command(short_help="Print the script that completes commands in a shell.")
@click.argument("shell", type=click.Choice(SHELLS))
@click.pass_context
def completion(ctx: click.Context, shell: str) -> None:
    """Print the script that completes commands and options of gcrules in a shell.

    \b
    bash   eval "$(gcrules completion bash)"          in ~/.bashrc
    zsh    eval "$(gcrules completion zsh)"           in ~/.zshrc
    fish   gcrules completion fish > ~/.config/fish/completions/gcrules.fish
    """
    found = get_completion_class(shell)
    assert found is not None
    script = found(ctx.find_root().command, {}, "gcrules", COMPLETING)
    click.echo(script.source_template % script.source_vars())
