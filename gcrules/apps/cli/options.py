"""Options that several commands have: the space, limits, what robots turn about."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import wraps
from typing import Any

import click

from gcrules.algebra.language.words import METRICS
from gcrules.apps.cli.limits import Seconds
from gcrules.apps.cli.naming import offering
from gcrules.apps.cli.output import decorated
from gcrules.core.dataclass import dataclass
from gcrules.core.errors import InputError

__all__ = [
    "SpaceOptions",
    "about_option",
    "catalog_option",
    "digits_option",
    "given_option",
    "length_option",
    "limit_option",
    "nearest_option",
    "search_option",
    "space_options",
]

_Command = Callable[..., Any]

catalog_option = click.option("--catalog", "catalogs", multiple=True, metavar="FILE", help="Add a catalog of your own.")


given_option = click.option(
    "--given",
    "assumptions",
    multiple=True,
    metavar="ASSUMPTIONS",
    help='Assume them: "collinear(a, b, c), incident(p, X)", other relations, "LHS == RHS", "ideal i j".',
)


@dataclass(frozen=True)
class SpaceOptions:
    """The rank, the declared points and the points at infinity; `metric` are those by which right angles are known,
    `letters` the text that declares lines and planes.
    """

    rank: int
    points: tuple[str, ...]
    ideal: tuple[str, ...]
    metric: tuple[tuple[str, tuple[str, ...]], ...] = ()
    letters: str = ""


def space_options(*, rank: bool = True, metric: bool = False) -> Callable[[_Command], _Command]:
    """--rank, --points, --ideal, --letters; the command receives them as `space`.

    With `metric` also --isotropic and --orthonormal, which the metric words of expressions need.
    """

    def decorate(command: _Command) -> _Command:
        @wraps(command)
        def with_space(**options: Any) -> Any:
            points, ideal, *found = (_names(options.pop(key, "")) for key in ("points", "ideal", *METRICS))
            known = tuple((kind, names) for kind, names in zip(METRICS, found, strict=True) if names)
            written = options.pop("letters", "")
            return command(space=SpaceOptions(options.pop("rank", 4), points, ideal, known, written), **options)

        decorators = [
            *(
                [click.option("--rank", type=int, default=4, show_default=True, metavar="N", help="The rank, 2 to 8.")]
                if rank
                else []
            ),
            click.option(
                "--points",
                default="",
                metavar="NAMES",
                help='Names of points in tableau order; declares names of several letters: "left right top base".',
            ),
            click.option("--ideal", default="", metavar="NAMES", help='Points at infinity: "i j k".'),
            *(click.option(f"--{k}", default="", metavar="NAMES", help=h) for k, h in _METRIC.items() if metric),
            click.option(
                "--letters",
                default="",
                metavar="LETTERS",
                help='What letters stand for lines, planes, screws, conics and quadrics: "line L M, plane P".',
            ),
        ]
        return decorated(with_space, decorators)

    return decorate


_METRIC = {
    "isotropic": 'The isotropic points of the plane, for words such as midpoint(a, b): "i j".',
    "orthonormal": 'Directions at right angles and of one length, for such words: "i j k", in the plane "i j".',
}


def _names(text: str) -> tuple[str, ...]:
    names = tuple(re.findall(r"[^\s,]+", text))
    twice = next((n for i, n in enumerate(names) if n in names[:i]), None)
    if twice is not None:
        raise InputError(f"the point {twice} is declared twice")
    return names


def limit_option(default: int, words: str) -> Callable[[_Command], _Command]:
    """--limit N."""
    return click.option(
        "--limit", type=click.IntRange(min=1), default=default, show_default=True, metavar="N", help=words
    )


def search_option(default: float) -> Callable[[_Command], _Command]:
    """--search S."""
    return click.option(
        "--search",
        type=Seconds(),
        default=default,
        show_default=True,
        metavar="S",
        help="Seek a factorization for this many seconds where no rule finds a condition.",
    )


nearest_option = click.option(
    "--nearest/--no-nearest",
    default=True,
    show_default=True,
    help="Seek the nearest singular poses, for a second or two.",
)
length_option = click.option(
    "--length",
    metavar="LENGTH",
    help="Characteristic length of the actuators' condition number; the robot's size by default.",
)
digits_option = click.option(
    "--digits",
    type=click.IntRange(1, 15),
    metavar="N",
    help="Print decimals of N digits, up to a factor; by default 6 where coefficients have more than 20 digits.",
)
about_option = click.option(
    "--about",
    default="centroid",
    show_default=True,
    metavar="CENTRE",
    shell_complete=offering("centroid", "origin"),
    help="What the platform turns about: centroid (of its joints), origin (of the file), or x,y,z.",
)
