"""The shell and Python lines of the studio repeat what it shows: they are run, and answer the same."""

from __future__ import annotations

import json
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from commands import Run

from gcrules.apps.studio.accounts import account_view
from gcrules.apps.studio.repeating import repeated

if TYPE_CHECKING:
    from apps.studio_client import Page

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

OCTAHEDRAL = {"kind": "example", "name": "octahedral"}
DELTA = {"kind": "robot", "id": "delta"}
THREE_RPS = {"kind": "robot", "id": "3-rps"}
FIVE_BARS = {"kind": "robot", "id": "5r"}
SHORT_LEGS = {"kind": "legs", "legs": "ab af  cb cd ed ef"}
HOME = {"translation": [0, 0, 0], "quaternion": [1, 0, 0, 0]}
MOVED = {"translation": [12.5, 0, -100 / 3], "quaternion": [0.98, 0.1, 0, -0.17]}
NEAR = {"translation": [0.05, 0, 0.1], "quaternion": [0.98, 0.1, 0, -0.17]}
"""For a shape of size one."""


def driven(*amounts: float) -> dict[str, Any]:
    return HOME | {"coordinates": list(amounts)}


POSED = [
    (OCTAHEDRAL, HOME),
    (OCTAHEDRAL, MOVED),
    (SHORT_LEGS, NEAR),
    ({"kind": "class", "id": "3-3.3"}, NEAR),
    (DELTA, driven(3.3, -2, 1.25)),
    (DELTA | {"mode": "-+-"}, driven(0, 0, 0)),
    (THREE_RPS, driven(0.05, 0.1, -0.02)),
]


class Repeat:
    """What the page gives for a method, run in a folder where the file lies that the lines name."""

    def __init__(self, page: Page, run: Run, folder: Path) -> None:
        self.page, self.run, self.folder = page, run, folder

    def lines(self, what: str, source: Any, **args: Any) -> dict[str, Any]:
        about = {"source": source} if source else {}
        found = dict(self.page.ask("repeat", what=what, args=about | args, **about))
        for file in found["files"]:
            (self.folder / file["name"]).write_text(file["text"], encoding="utf-8")
        return found

    def both(self, what: str, source: Any, **args: Any) -> tuple[dict[str, Any], Any]:
        """What the shell line answers as JSON, and what the Python lines print."""
        found = self.lines(what, source, **args)
        program, *words = shlex.split(found["shell"])
        assert program == "gcrules"
        answered = self.run(*words, "--json")
        assert answered.exit_code in (0, 1, 3), answered.output
        shown: list[Any] = []
        exec(found["python"], {"print": shown.append})
        return json.loads(answered.stdout), shown[0]


@pytest.fixture
def repeat(page: Page, run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Repeat:
    monkeypatch.chdir(tmp_path)
    return Repeat(page, run, tmp_path)


@pytest.mark.parametrize(("source", "pose"), POSED)
def test_a_pose(repeat: Repeat, source: Any, pose: Any) -> None:
    shown = repeat.page.ask("pose", source=source, pose=pose)
    shell, python = repeat.both("pose", source, pose=pose)
    margin = shell["margin"] if isinstance(shell["margin"], float) else shell["margin"]["value"]
    assert margin == pytest.approx(shown["margin"], rel=1e-9)
    assert python.margin == pytest.approx(shown["margin"], rel=1e-9)
    assert shell["verdict"] == shown["verdict"] == python.verdict


@pytest.mark.parametrize("source", [OCTAHEDRAL, SHORT_LEGS, DELTA, {"kind": "class", "id": "3-3.3"}])
def test_an_analysis(repeat: Repeat, source: Any) -> None:
    shell, python = repeat.both("open", source)
    study = repeat.page.ask("open", source=source)
    sentence = [
        i["text"] for s in study["stages"] for i in s["items"] if s["id"] == "statement" and i["kind"] == "text"
    ]
    assert sentence[0] in str(python).replace("\n", " ") or python.condition.statement == sentence[0]
    assert shell


@pytest.mark.parametrize(
    ("source", "start", "goal"),
    [(OCTAHEDRAL, HOME, {**HOME, "translation": [0, 0, -490]}), (THREE_RPS, None, driven(0.3, 0.1, 0.2))],
)
def test_a_path(repeat: Repeat, source: Any, start: Any, goal: Any) -> None:
    args = {"goal": goal} | ({"start": start} if start else {})
    shown = repeat.page.ask("path", source=source, **args)
    shell, python = repeat.both("path", source, **args)
    places = [p["parameter"] for p in shown["places"]]
    name = "zeros" if source is OCTAHEDRAL else "crossings"
    assert [z.parameter for z in getattr(python, name)] == pytest.approx(places, abs=1e-6)
    assert [z["parameter"] for z in shell[name]] == pytest.approx(places, abs=1e-6)


def test_a_way_around(repeat: Repeat) -> None:
    goal = {**HOME, "translation": [10, 0, -20]}
    shown = repeat.page.ask("path", source=OCTAHEDRAL, goal=goal, way="around")
    shell, python = repeat.both("path", OCTAHEDRAL, goal=goal, way="around")
    assert shell["outcome"] == python.outcome == shown["detour"]["outcome"]


@pytest.mark.parametrize(
    ("source", "over", "pose"),
    [
        (OCTAHEDRAL, ["x -90:90:5", "rz -20:20:5 deg"], MOVED),
        (DELTA, ["x -0.5:0.5:5", "y -0.5:0.5:5"], driven(3, 2, 1)),
        (DELTA, ["q1 -5:5:5 deg", "q2 -5:5:5 deg"], driven(3, 2, 1.5)),
    ],
)
def test_a_map(repeat: Repeat, source: Any, over: Any, pose: Any) -> None:
    shown = repeat.page.ask("map", source=source, over=over, pose=pose)
    shell, python = repeat.both("map", source, over=over, pose=pose)
    assert python.values("margin").ravel().tolist() == pytest.approx(
        [float("nan") if v is None else v for row in shown["margin"] for v in row], rel=1e-3, nan_ok=True
    )
    assert python.sentence == shown["statement"]
    assert shell


def test_noise_of_a_closed_loop_is_not_written(repeat: Repeat) -> None:
    """A turn of 1e-16 radians is none, and no zero has a sign."""
    level = driven(-0.07979095477305656, 0.19147721917954913, -0.27710147202083046)  # turned by roll alone
    line = repeat.lines("path", THREE_RPS, start=driven(0, 0, 0), goal=level)["shell"]
    assert line.count("pitch=0deg") == 2
    assert "=-0" not in line.replace("z=-0.", "")


@pytest.mark.parametrize(("source", "pose"), [(OCTAHEDRAL, MOVED), (FIVE_BARS, driven(0.05, -0.02))])
def test_free_poses_and_assembly_modes(repeat: Repeat, source: Any, pose: Any) -> None:
    shown = repeat.page.ask("free", source=source, pose=pose, shape="ball")
    shell, python = repeat.both("free", source, pose=pose, shape="ball")
    assert account_view(python)["verdict"] == shown["verdict"]
    assert shell
    shown = repeat.page.ask("assemblies", source=source, pose=pose)
    shell, python = repeat.both("assemblies", source, pose=pose)
    assert [m.margin for m in python.modes] == pytest.approx([m["margin"] for m in shown["modes"]], rel=1e-6)
    assert len(shell["modes"]) == len(shown["modes"])


@pytest.mark.parametrize(
    ("source", "over", "pose"),
    [(OCTAHEDRAL, ["x -20:20", "yaw -5:5 deg"], MOVED), (DELTA, ["x -0.1:0.1", "z -0.1:0.1"], driven(1, 1, 2))],
)
def test_whole_ranges(repeat: Repeat, source: Any, over: Any, pose: Any) -> None:
    args = {"over": over, "pose": pose, "boxes": 500}
    for what in ("boxes", "certify"):
        shown = repeat.page.ask(what, source=source, **args)
        shell, python = repeat.both(what, source, **args)
        assert account_view(python)["verdict"] == shown["verdict"], what
        assert shell


def test_the_bench(repeat: Repeat) -> None:
    run = [sys.executable, "-m", "gcrules"]
    for text, python, words in [
        (r"ab /\ cde", "expand", "[acde]"),
        ("[abcd] == -[bacd]", "prove", "proved"),
        ("let p = ab /\\ cde\np == p", "", "proved"),
    ]:
        found = repeat.lines("bench", None, text=text)
        first, *typed, end = found["shell"].splitlines()
        assert (first, end) == ("gcrules repl <<'END'", "END")
        answer = subprocess.run([*run, "repl"], input="\n".join(typed), capture_output=True, text=True, check=True)
        assert words in answer.stdout
        assert (python in found["python"]) if python else found["python"] == ""
        shown: list[Any] = []
        exec(found["python"], {"print": shown.append})
        assert not shown or words in str(shown[0]).lower() or words in str(shown[0])


def test_by_hand(repeat: Repeat) -> None:
    source = {"kind": "legs", "legs": "ab af cb cd ed ef"}
    found = repeat.lines("manual", source, commands=["plane abf", "plane cbd"])
    assert found["python"] == ""
    answered = repeat.run(*shlex.split(found["shell"])[1:])
    assert answered.exit_code in (0, 1), answered.output
    assert "confirmed" in answered.stdout


def test_a_file_keeps_its_name_and_its_mode(repeat: Repeat) -> None:
    text = repeat.page.ask("save", source=DELTA, pose=HOME, what="yaml")["data"]
    found = repeat.lines("pose", {"kind": "file", "text": text, "name": "my robot.yaml", "mode": "-+-"}, pose=HOME)
    assert found["shell"] == 'gcrules pose "my robot.yaml" --mode=-+-'
    assert found["files"] == [{"name": "my robot.yaml", "text": text}]


def test_what_is_no_such_question_is_refused(page: Page) -> None:
    fault = page.fault("repeat", source=DELTA, what="pose", args={"source": DELTA})
    assert "pose" in fault["message"]
    assert page.fault("repeat", source=DELTA, what="pose", args=[])["message"] == "args.args is not an object"


# --- lines that are pasted into a terminal ----------------------------------------------------------------------------

BAD = {
    "the end of the lines": "[abcd]\nEND\necho ran",
    "more ends": "[abcd]\nEND\nEND1\n END2 \necho ran",
    "another end of line": "[abcd]\rEND\recho ran",
    "an expansion": "[abcd] $(echo ran) `echo ran` ${HOME}",
    "the end of a paste": "[abcd]\x1b[201~\necho ran",
    "a line separator": "[abcd]\u2028END\u2028echo ran",
}


@pytest.mark.skipif(sys.platform == "win32", reason="needs a shell")
@pytest.mark.parametrize("text", BAD.values(), ids=BAD)
def test_the_shell_runs_nothing_of_what_stands_on_the_bench(text: str) -> None:
    shell = repeated(None, "bench", {"text": text})["shell"]
    assert not re.search(r"[\x00-\x08\x0b-\x1f\x7f]", shell)
    line, *body, end = shell.split("\n")
    assert line.endswith(f"<<'{end}'")
    assert end not in body
    ran = subprocess.run(["bash", "-c", f"gcrules() {{ cat; }}\n{shell}"], capture_output=True, text=True, check=True)
    assert ran.stdout.rstrip("\n").split("\n") == body


@pytest.mark.parametrize(
    ("text", "call"),
    [
        (":factor [abcd] [efgh]", 'gc.factor("[abcd] [efgh]")'),
        (":discover", ""),
        (":sh [abcd]", 'gc.shorten("[abcd]")'),
        (":prove [abcd] == -[bacd]", 'gc.prove("[abcd] == -[bacd]")'),
        (":transversals Aa Ab Bc Cd De Ef", 'gc.transversals("Aa Ab Bc Cd De Ef")'),
        ("[abcd] == -[bacd]", 'gc.prove("[abcd] == -[bacd]")'),
        (":steps [abcd]", ""),
        (":factor", ""),
        (":latex ab", ""),
        (":nothing ab", ""),
    ],
)
def test_a_question_alone_is_a_call_of_its_function(text: str, call: str) -> None:
    python = repeated(None, "bench", {"text": text})["python"]
    assert (call in python) if call else python == ""
    if call:
        subprocess.run([sys.executable, "-c", python], capture_output=True, check=True)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "rank 3\nconic K\nline L\ngiven touches(L, K)\nlet t = pole(L, K)\nlet p = polar(a, K)\n:discover",
            "nothing new",
        ),
        ("rank 3\nconic K\n:prove conic(a, K) == 0", "refuted"),
        ("quadric Q\nplane P\ngiven touches(P, Q)\n:prove incident(pole(P, Q), Q)", "proved"),
        ("line L\n:prove [L ab] == [ab L]", "proved"),
        ("line L M\n:transversals Aa Ab Bc Bd L M", "transversals"),
        ("screw S\n:expand S /\\ ab", "S"),
    ],
)
def test_letters_are_declared(repeat: Repeat, text: str, said: str) -> None:
    """The shell answers the same, and Python does not refuse it."""
    found = repeated(None, "bench", {"text": text})
    program, *lines = found["shell"].split(" <<'END'\n")
    words = shlex.split(program)[1:]
    answered = repeat.run(*words, input=lines[0].rpartition("END")[0]) if lines else repeat.run(*words)
    assert answered.exit_code in (0, 1), answered.output
    assert said in answered.stdout
    exec(found["python"], {"print": lambda _: None})


ACTUATED = [(OCTAHEDRAL, MOVED), ({"kind": "robot", "id": "octahedral"}, NEAR), (THREE_RPS, driven(0.05, 0.1, -0.02))]


@pytest.mark.parametrize(("source", "pose"), ACTUATED)
def test_the_table_of_the_actuators(repeat: Repeat, source: Any, pose: Any) -> None:
    rows = repeat.page.ask("pose", source=source, pose=pose)["actuators"]
    found = repeat.lines("actuators", source, pose=pose)
    shell = json.loads(repeat.run(*shlex.split(found["shell"])[1:]).stdout)
    assert [a["value"] for a in shell["actuators"]] == pytest.approx([r["value"] for r in rows], rel=1e-9)
    shown: list[Any] = []
    exec(found["python"], {"print": shown.append})
    values, amplification = shown
    assert list(values.values()) == pytest.approx([r["value"] for r in rows], rel=1e-9)
    assert [f"{speed:.4g}" for speed in amplification.speeds] == [r["speed"].split()[0] for r in rows]


@pytest.mark.parametrize(
    ("source", "pose", "over"),
    [
        (OCTAHEDRAL, MOVED, None),
        (OCTAHEDRAL, MOVED, ["x", "z"]),
        (THREE_RPS, driven(0.05, 0.1, -0.02), None),
        (THREE_RPS, driven(0, 0, 0), ["roll", "pitch"]),
    ],
)
def test_a_formula(repeat: Repeat, source: Any, pose: Any, over: Any) -> None:
    args = {"pose": pose} | ({"over": over} if over else {})
    shown = repeat.page.ask("locus", source=source, **args)
    shell, python = repeat.both("locus", source, **args)
    forms = [python.form] if source is OCTAHEDRAL else [part.form for part in python.parts]
    assert [str(form) for form in forms] == [part["polynomial"]["plain"] for part in shown["parts"]]
    assert shell["schema"] == 1
