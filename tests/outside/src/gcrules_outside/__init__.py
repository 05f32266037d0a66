"""A plugin from outside: one incidence rule in Python, one identity in the language, a robot and a catalog."""

from pathlib import Path

from gcrules.rules.plugins import ConditionRule, Plugin, bracket, mul, points

FOLDER = Path(__file__).parent


def volumes(state):
    """The product of the tetrahedra, each six times a volume."""
    return mul(*(bracket(*points(state.named(row))) for row in state.tetrahedra))


PLUGIN = Plugin(
    rules=(
        ConditionRule(
            id="volumes",
            sentence="Three common brackets are six times the volumes of three tetrahedra.",
            fires=("Aa Ab Ac Bd Be Cf",),
            silent=("ab af cb cd ed ef",),
            degree=0,
            expression=volumes,
            statement="The robot is singular exactly when the product of the volumes of {tetrahedra} is 0.",
        ),
    ),
    rule_files=(FOLDER / "outside.gca",),
    robots=(FOLDER / "robots",),
    catalogs=(FOLDER / "catalog.yaml",),
)
