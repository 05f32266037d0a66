"""What is analysed, and how: the options of the commands that begin with an analysis."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

import click

from gcrules.apps.cli.facts_options import facts_options
from gcrules.apps.cli.files import working
from gcrules.apps.cli.options import SpaceOptions, catalog_option, given_option, search_option, space_options
from gcrules.apps.cli.output import decorated
from gcrules.apps.cli.rule_options import Choice, rules_options
from gcrules.apps.cli.sources import mode_option, read_source
from gcrules.conditions.analysis import Analysis
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.mechanisms.analyze import analyze, analyze_robot
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.description.platform_file import Platform
from gcrules.mechanisms.load import Loaded
from gcrules.mechanisms.robot import Robot
from gcrules.rules.factorization import SECONDS

__all__ = ["AnalysisOptions", "analysis_options", "robot_analysis"]

_home_remark = deferred("gcrules.poses.limbs.remark:home_remark")  # numpy

_Command = Callable[..., Any]
_SPACE = SpaceOptions(4, (), ())  # where no option says otherwise


def robot_analysis(robot: Robot, search: float, facts: bool, tolerance: float) -> RobotAnalysis:
    """The analysis of a robot of joints; what is to be noticed of its home goes to standard error."""
    with working("analysing"):
        found = analyze_robot(robot, search=search, facts=facts, tolerance=tolerance)
        remark = _home_remark(found)
    if remark:
        click.echo(f"warning: {remark}", err=True)
    return found


@dataclass(frozen=True)
class AnalysisOptions:
    """What a user has said of an analysis, beside its source."""

    mode: str | None
    order: str | None
    recheck: bool
    assumptions: tuple[str, ...]
    facts: bool
    tolerance: float
    search: float
    catalogs: tuple[str, ...]
    choice: Choice
    space: SpaceOptions

    @property
    def beside_order_and_names(self) -> bool:
        """Whether more was said than an order of the legs and names of points."""
        of_rules = self.choice.words or self.choice.without
        special = self.assumptions or self.space.rank != _SPACE.rank or self.space.letters or self.search != SECONDS
        return bool(self.mode or self.recheck or self.catalogs or of_rules or special)

    def loaded(self, words: tuple[str, ...]) -> Loaded:
        """What the words say."""
        return read_source(
            words,
            mode=self.mode,
            plugins=self.choice.folders,
            points=self.space.points,
            ideal=self.space.ideal,
            given=self.assumptions,
            rank=self.space.rank,
            letters=self.space.letters,
        )

    def analysis(self, words: tuple[str, ...]) -> Analysis | RobotAnalysis:
        """The analysis of what the words say; what is to be noticed goes to standard error. Raises UsageError for
        options that a robot of joints does not take.
        """
        loaded = self.loaded(words)
        return self._of_joints(loaded) if isinstance(loaded, Robot) else self._of_lines(loaded)

    def _of_joints(self, robot: Robot) -> RobotAnalysis:
        of_lines = self.order or self.recheck or self.assumptions or self.catalogs or self.space != _SPACE
        if of_lines or self.choice.words or self.choice.without:
            raise click.UsageError(
                "A robot of joints takes --mode, --search, --plugins, --no-facts, --tolerance and options of output"
                " only."
            )
        return robot_analysis(robot, self.search, self.facts, self.tolerance)

    def _of_lines(self, loaded: Loaded) -> Analysis | RobotAnalysis:
        space = self.space
        of_file: dict[str, Any] = (
            {
                "points": space.points,
                "ideal": space.ideal,
                "rank": space.rank,
                "given": self.assumptions,
                "letters": space.letters,
            }
            if isinstance(loaded, Platform)
            else {}
        )
        with working("analysing"):
            found = analyze(
                loaded,
                order=self.order,
                catalogs=self.catalogs,
                recheck=self.recheck,
                strategy=self.choice.strategy(),
                search=self.search,
                plugins=self.choice.folders,
                facts=self.facts,
                tolerance=self.tolerance,
                **of_file,
            )
        for warning in found.platform.warnings if isinstance(found, Analysis) and found.platform else ():
            click.echo(f"warning: {warning}", err=True)
        return found


_FIELDS = ("mode", "order", "recheck", "assumptions", "facts", "tolerance", "search", "catalogs", "choice", "space")


def analysis_options(command: _Command) -> _Command:
    """The options; the command receives them as `asked`. A limit of time that adds the seconds of --search stands above
    them.
    """

    @wraps(command)
    def with_asked(**options: Any) -> Any:
        return command(asked=AnalysisOptions(**{name: options.pop(name) for name in _FIELDS}), **options)

    decorators: list[Callable[[_Command], _Command]] = [
        mode_option,
        click.option("--order", metavar="LEGS", help='Keep this order of the legs: "2 1 3 4 6 5", or the legs.'),
        click.option("--recheck", is_flag=True, help="Prove instances of catalog identities from scratch."),
        given_option,
        facts_options,
        search_option(SECONDS),
        catalog_option,
        rules_options,
        space_options(),
    ]
    return decorated(with_asked, decorators)
