"""Where to add what: an example of each row of the table in docs/architecture.md is added, and works."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import click
import numpy as np
import pytest
from commands import invoke
from mechanisms.shipped_robots import GOOD
from places import EXAMPLES, ROOT

import gcrules as gc
from gcrules.api import signatures
from gcrules.apps.cli import COMMANDS
from gcrules.apps.repl.commands import HANDLERS
from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.tables import COMMANDS as PROMPT
from gcrules.apps.repl.tables import Command
from gcrules.apps.studio.answers import ANSWERS, answer
from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.core.arguments import TEXT
from gcrules.core.errors import InputError
from gcrules.core.frozen import FrozenMap
from gcrules.core.shown import Shown
from gcrules.mechanisms.conditions.checks import home_values
from gcrules.mechanisms.editing.edits import EDITS, Edit, edited
from gcrules.mechanisms.editing.reading import read_sheet
from gcrules.mechanisms.editing.writing import rewritten
from gcrules.mechanisms.limbs import Limbs
from gcrules.mechanisms.models.model import Model, ModelJoint
from gcrules.mechanisms.models.reading import READERS, read_model
from gcrules.poses import pose as methods
from gcrules.poses.stored_maps.kinds import KINDS
from gcrules.poses.tiles.running import run
from gcrules.poses.tiles.store import TileStore
from gcrules.poses.tiles.task import TiledArray
from gcrules.screws import JOINTS
from gcrules.screws.joints import JointKind
from gcrules.screws.screw import prismatic_of, revolute_of
from gcrules.views import forms
from gcrules.views.code.languages import LANGUAGES
from gcrules.views.forms import FORMS, Forms
from gcrules.views.models.model_text import MODEL_FORMATS
from gcrules.views.plots.map_files import MAP_FORMATS
from gcrules.views.plots.map_formats import MapFormat
from gcrules.views.robots.robot_drawing import draw_robot

HERE = __name__  # tables name functions as "module:function"
Add = Callable[[Mapping[str, Any], str, Any], None]


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, HERE, sys.modules.get(HERE) or _Module())


class _Module:
    """This module, where pytest has not made it known by its name."""

    def __getattr__(self, name: str) -> Any:
        return globals()[name]


@pytest.fixture
def add(monkeypatch: pytest.MonkeyPatch) -> Add:
    """Add a row to a table, for the time of a test."""

    def row(table: Mapping[str, Any], key: str, value: Any) -> None:
        monkeypatch.setitem(table._items if isinstance(table, FrozenMap) else table, key, value)

    return row


SHOWN_BY = {
    "a rule": "test_a_rule",
    "a class of platforms, another reading": "test_a_class_of_platforms",
    "a robot": "test_a_robot",
    "a joint": "test_a_joint",
    "a form of a result": "test_a_form_of_a_result",
    "a kind of answer": "test_a_kind_of_answer",
    "a language of exported code": "test_a_language_of_exported_code",
    "a format of model files": "test_a_format_of_model_files",
    "a kind of task in tiles": "test_a_kind_of_task_in_tiles",
    "a file format of a map": "test_a_file_format_of_a_map",
    "a kind of mechanism": "test_a_kind_of_mechanism",
    "a command": "test_a_command",
    "a command of the prompt": "test_a_command_of_the_prompt",
    "a change of a robot's limbs": "test_a_change_of_limbs",
    "a method of the studio": "test_a_method_of_the_studio",
    "an argument of a public function": "test_an_argument_of_a_public_function",
}


def test_every_row_of_the_page_is_shown() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    table = page.partition("## Where to add")[2].partition("\n## ")[0]
    rows = re.findall(r"^\| (.+?) \|", table, flags=re.MULTILINE)[1:]
    assert rows == list(SHOWN_BY)
    assert set(SHOWN_BY.values()) <= set(globals())


def test_every_table_of_methods_is_named_in_the_row_of_mechanisms() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    row = re.search(r"^\| a kind of mechanism \|.*$", page, flags=re.MULTILINE)
    assert row is not None
    table = re.compile(r"^_?[A-Z_]+: Methods\[", flags=re.MULTILINE)
    tables = [p for p in (ROOT / "gcrules").rglob("*.py") if table.search(p.read_text(encoding="utf-8"))]
    assert tables
    assert [p.name for p in tables if p.name not in row[0]] == []


# --- files -----------------------------------------------------------------------------------------------------------

LEGS = "Aa Ab Ac Bd Be Cf"


def test_a_rule(tmp_path: Path) -> None:
    path = tmp_path / "mine.gca"
    path.write_text("rule volume: ab /\\ cd => [abcd]\n", encoding="utf-8")
    assert str(gc.rewrite("pq /\\ rs", [str(path)]).after) == "[pqrs]"
    path.write_text("rule volume: ab /\\ cd => -[abcd]\n", encoding="utf-8")
    with pytest.raises(InputError, match="the rule volume is not an identity"):
        gc.rewrite("pq /\\ rs", [str(path)])


CLASS = """
classes:
  - id: three-volumes
    legs: Aa Ab Ac Bd Be Cf
    condition: {kind: three-tetrahedra, expression: '[Aabc][ABde][ABCf]', statement: 'Three volumes.'}
"""


def test_a_class_of_platforms(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    path = tmp_path / "mine" / "catalog.yaml"
    path.write_text(CLASS, encoding="utf-8")
    for found in (gc.analyze(LEGS, catalogs=[path]), gc.analyze("three-volumes", plugins=[tmp_path])):
        assert "Three volumes." in {r.statement for r in (found.condition, *found.readings)}


def test_a_robot(tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "robot.yaml").write_text(GOOD, encoding="utf-8")
    found = gc.analyze("mine", plugins=[tmp_path])
    assert (found.robot.title, found.condition.kind) == ("three legs", "four-planes")
    assert "mine" in invoke("robot", "list", "--plugins", str(tmp_path)).output


# --- rows of tables --------------------------------------------------------------------------------------------------


SLIDING_HINGE = JointKind(
    symbol="RP",
    name="sliding hinge",
    parts=FrozenMap({"point": "point", "axis": "direction", "along": "direction"}),
    freedoms=("turn about the axis", "slide along the direction"),
    drives=(0, 1),
    rows=lambda field, g: (revolute_of(field, g["point"], g["axis"]), prismatic_of(g["along"])),
)


def test_a_joint(add: Add) -> None:
    """A hinge that carries a slide: one row, and robots with it are analysed, moved and drawn like those that have two
    joints instead.
    """
    add(JOINTS, "RP", SLIDING_HINGE)
    text = (ROOT / "plugins" / "3-rps" / "robot.yaml").read_text(encoding="utf-8")
    before, after = (gc.analyze(gc.load(t)) for t in (text, text.replace("R(A%, r%) P*(A% S%)", "RP*2(A%, r%, A% S%)")))
    assert [j.kind for j in after.robot.limbs[0].joints] == ["RP", "S"]
    assert after.condition.expression == before.condition.expression
    poses = [gc.pose(a, "z=0.2, roll=5deg, pitch=0deg", nearest=False) for a in (before, after)]
    assert poses[0].margin == pytest.approx(poses[1].margin)
    assert [*poses[0].actuator_values.values()] == pytest.approx([*poses[1].actuator_values.values()])
    drawn = [draw_robot(a, home_values(a.robot)).svg() for a in (before, after)]
    assert ["sliding hinge" in svg for svg in drawn] == [False, True]


@dataclass(frozen=True)
class Volume(Shown):
    """A result of our own."""

    value: int

    def to_json(self) -> dict[str, int]:
        return {"value": self.value}


def volume_text(volume: Volume, *, unicode: bool = False) -> str:
    return f"a volume of {volume.value}{' m³' if unicode else ' m^3'}"


def volume_latex(volume: Volume) -> str:
    return f"V = {volume.value}"


VOLUME = Forms(text=f"{HERE}:volume_text", latex=f"{HERE}:volume_latex")


def test_a_form_of_a_result(add: Add) -> None:
    name = f"{Volume.__module__}.{Volume.__qualname__}"
    forms._forms.cache_clear()
    add(FORMS, name, replace(VOLUME, others={"svg": f"{HERE}:volume_latex"}))
    found = Volume(6)
    assert (str(found), found.text(), found.latex()) == ("a volume of 6 m³", "a volume of 6 m^3", "V = 6")
    assert (found._repr_latex_(), found._repr_svg_()) == ("$\\displaystyle V = 6$", "V = 6")
    forms._forms.cache_clear()


@click.command()
@click.argument("number", type=int)
def volume_command(number: int) -> None:
    """Show a volume."""
    click.echo(Volume(number).text())


def test_a_kind_of_answer(add: Add) -> None:
    """A value, its function with its arguments, how it is shown, its command."""
    add(FORMS, f"{Volume.__module__}.{Volume.__qualname__}", VOLUME)
    add(signatures.SIGNATURES, "volume", {"expression": TEXT})

    def volume(expression: str) -> Volume:
        return Volume(
            int(gc.evaluate(expression, {"a": (0, 0, 0, 1), "b": (1, 0, 0, 1), "c": (0, 1, 0, 1), "d": (0, 0, 6, 1)}))
        )

    public = signatures.public(volume)
    add(COMMANDS, "volume", (f"{HERE}:volume_command", "Show a volume."))
    assert abs(public("[abcd]").value) == 6
    with pytest.raises(InputError, match=r"gc.volume: `expression`"):
        public(1)
    assert invoke("volume", "6").output == "a volume of 6 m^3\n"


def test_an_argument_of_a_public_function(add: Add) -> None:
    add(signatures.SIGNATURES, "named", {"name": TEXT})

    def named(name: str) -> str:
        return name

    with pytest.raises(InputError, match=r"gc.named: `name` must be text, got 1"):
        signatures.public(named)(1)


def test_a_command(add: Add) -> None:
    add(COMMANDS, "volume", (f"{HERE}:volume_command", "Show a volume."))
    assert "Show a volume." in invoke("--help").output
    assert invoke("volume", "7").output == "a volume of 7 m^3\n"
    assert invoke("volume", "x").exit_code == 2


def write_shape(m: gc.SingularMap, path: str) -> None:
    Path(path).write_text(f"{m.values('margin').shape}", encoding="utf-8")


@dataclass(frozen=True)
class Squares:
    """A `TileTask`: the squares of numbers, three in a tile."""

    stage = None

    number: int
    manifest = property(lambda self: {"squares": self.number})
    recipe = property(lambda self: {"kind": "squares", "number": self.number})
    attrs: ClassVar[dict[str, Any]] = {"title": "squares"}
    coordinates: ClassVar[tuple[Any, ...]] = ()
    grid = property(lambda self: (-(-self.number // 3),))
    arrays = property(lambda self: (TiledArray("square", ("n",), (self.number,), (3,), "int64"),))

    def compute(self, tile: int) -> dict[str, Any]:
        return {"square": np.arange(3 * tile, min(3 * tile + 3, self.number)) ** 2}


def test_a_kind_of_task_in_tiles(add: Add, tmp_path: Path) -> None:
    pytest.importorskip("zarr")
    add(KINDS, "squares", lambda recipe: Squares(recipe["number"]))
    store = TileStore.open(tmp_path / "squares.zarr", Squares(8))
    run(Squares(8), store)
    found = gc.verify_map(tmp_path / "squares.zarr", "all")
    assert found.sound
    assert found.complete


def test_a_file_format_of_a_map(add: Add, tmp_path: Path) -> None:
    add(MAP_FORMATS, ".txt", MapFormat(write_shape))
    found = gc.singular_map(EXAMPLES / "octahedral.yaml", ["x -1:1:2", "y -1:1:2"])
    found.save(tmp_path / "map.txt")
    assert re.fullmatch(r"\(\d+, \d+\)", (tmp_path / "map.txt").read_text(encoding="utf-8"))


def test_a_language_of_exported_code(add: Add) -> None:
    """Here with a template that is there already."""
    add(LANGUAGES, "octave", replace(LANGUAGES["python"], title="Octave", comment="% {line}", root="sqrt({x})"))
    text = gc.export("3-rpr", "octave")
    assert text.startswith("% 3-rpr: when is it singular?")
    assert " = sqrt(v" in text


def test_a_format_of_model_files(add: Add, tmp_path: Path) -> None:
    """Here one whose root is <pair>: two links, and a hinge between them."""
    hinge = ModelJoint("hinge", "revolute", "one", "two", (0.0, 0.0, 0.0), ((0.0, 0.0, 1.0),))
    add(READERS, "pair", lambda root: Model(root.needed("name"), "pair", "", ("one", "two"), (hinge,)))
    file = tmp_path / "pair.xml"
    file.write_text('<pair name="tongs"/>')
    assert read_model(file).name == "tongs"
    add(MODEL_FORMATS, "names", lambda model: " ".join(j.name for j in model.joints if j.closing))
    assert gc.export_model("3-rps", "names") == "leg_2_S leg_3_S"


class Renamed(Limbs):
    """A mechanism of another kind."""


def test_a_kind_of_mechanism(add: Add, monkeypatch: pytest.MonkeyPatch) -> None:
    made = Renamed.of(gc.load("3-rps"))
    monkeypatch.setattr(methods, "mechanism", lambda source, **options: made)
    for table in (methods._POSE, methods._SINGULAR):
        add(table, Renamed, table[Limbs])
    assert gc.pose("3-rps", "z=0.1, roll=0deg, pitch=0deg", nearest=False).verdict == "regular"
    assert gc.singular("3-rps", "z=0.1, roll=0deg, pitch=0deg") is None


def test_a_command_of_the_prompt(add: Add) -> None:
    add(PROMPT, "twice", Command("twice", ":twice EXPR", "two times a scalar", "expression"))
    add(HANDLERS, "twice", lambda repl, request: repl.shown(2 * repl.expression(request.source), request.source))
    (found,) = Interpreter().feed(":twice [bacd]")
    assert (found.text, found.verdict) == ("−2[abcd]", "shown")
    assert "two times a scalar" in next(iter(Interpreter().feed(":help"))).text


def test_a_change_of_limbs(add: Add) -> None:
    add(EDITS, "limb loud", lambda sheet, edit: replace(sheet, title=sheet.title.upper()))
    text = (ROOT / "plugins" / "3-rps" / "robot.yaml").read_text(encoding="utf-8")
    placed = read_sheet(text)
    after = rewritten(text, placed, edited(placed.sheet, Edit("limb loud")))
    assert [line for line in after.splitlines() if line not in text.splitlines()] == ['title: "3-RPS ROBOT"']


def test_a_method_of_the_studio(add: Add) -> None:
    assert set(ANSWERS) == {name for name, method in METHODS.items() if method.where != "session"}
    add(METHODS, "volume", METHODS["gallery"])
    add(ANSWERS, "volume", ("builtins:dict", lambda found, subject, args: found(volume=args["number"])))
    assert METHODS["volume"].seconds > 0
    assert answer("volume", None, {"number": 6}) == {"volume": 6}
