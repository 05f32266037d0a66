"""The time that a command may take, one option for all that compute; and the memory of those that may take much."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from math import inf, isnan
from typing import Any

import click
from click.core import ParameterSource

from gcrules.core.alarm import limited

__all__ = ["AROUND", "SECONDS", "Gigabytes", "Seconds", "beside", "limited", "memory_option", "time_limit"]

SECONDS = 60.0
VARIABLE = "GCRULES_SECONDS"
AROUND = 10.0
"""Seconds for reading, and for finishing what was found, around a search that has a limit of its own."""

_Command = Callable[..., Any]


class _Amount(click.ParamType):  # type: ignore[type-arg, unused-ignore]
    """A number of something, 0 or more; inf is no limit."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        try:
            found = float(value)
        except ValueError:
            self.fail(f"{value!r} is not a number of {self.name}.", param, ctx)
        if isnan(found) or found < 0:
            self.fail(f"{value!r} is not a number of {self.name}, 0 or more.", param, ctx)
        return found


class Seconds(_Amount):
    """A number of seconds, 0 or more; inf is no limit."""

    name = "seconds"


class Gigabytes(_Amount):
    """A number of gigabytes, 0 or more; inf is no limit."""

    name = "gigabytes"


def beside(search: float) -> float:
    """The seconds that a search has on top of --seconds: its own, unless the user said how long all may take."""
    said = click.get_current_context().get_parameter_source("seconds")
    return 0.0 if said is ParameterSource.COMMANDLINE else search


def time_limit(
    default: float | None = SECONDS, words: str = "", *, plus: str | None = None, itself: bool = False
) -> Callable[[_Command], _Command]:
    """--seconds S: LimitReached where the command takes longer; a default of None is no limit unless one is given.

    The seconds of the option `plus`, those of a search, come on top of the default. A command that sees to it `itself`
    receives the `seconds`, and surrounds with `limited` what takes time.
    """

    def decorate(command: _Command) -> _Command:
        @wraps(command)
        def within_its_time(**options: Any) -> Any:
            if itself:
                return command(**options)
            with limited(options.pop("seconds"), beside(options[plus]) if plus else 0.0):
                return command(**options)

        option = click.option(
            "--seconds",
            type=Seconds(),
            default=inf if default is None else default,
            show_default="no limit" if default is None else True,
            envvar=None if default is None or words else VARIABLE,
            show_envvar=True,
            metavar="S",
            help=words or "Give up after this time.",
        )
        return option(within_its_time)

    return decorate


def memory_option(command: _Command) -> _Command:
    """--memory G: the `gigabytes` that a command may use, for `limited`; None where it is not given."""
    option = click.option(
        "--memory",
        "gigabytes",
        type=Gigabytes(),
        metavar="G",
        help="Give up beyond this many gigabytes; GCRULES_MEMORY, or three quarters of what is free, if left out.",
    )
    return option(command)
