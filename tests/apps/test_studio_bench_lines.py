"""Each answer of the bench has lines for the shell and for Python; they are run, and give that answer."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from gcrules.apps.studio.bench import bench

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs a shell")

OCTAHEDRAL = "[[ab, af, cb, cd, ed, ef]]"
PIERCE = 'rule pierce "line and plane meet in a point": ab /\\ cde => [acde] b - [bcde] a'
TURN = 'rule turn "two lines meet in a scalar": ab /\\ cd => [abcd]'
LAST = """rule exchange_last "three-term relation":
  [R... a d][R... b c] => [R... a c][R... b d] - [R... a b][R... c d]  if a < b, b < c, c < d
  fires [abcf][abde]"""


def opened(name: str, text: str, *off: str) -> dict[str, Any]:
    return {"name": name, "text": text, "off": list(off)}


SPACE = rf"""let p = ab /\ cde
p \/ cdf
[abcd] == -[bacd]
claim "wrong": [abcd] == [bacd]
show p \/ cdf
:expand {OCTAHEDRAL}
:straighten [afgl][behk][cdij]
:steps [adbc][aefg]
:factor [abce][abdf][cdef] - [abcf][acde][bdef]
:shorten {OCTAHEDRAL}
:latex p f
:transversals Aa Ab Bc Bd Cc De
:analyze Aa Ab Ac Ba Bd Ce
:straighten
-p \/ cdf
rewrite p"""
PLANE = r"""rank 3
given collinear(a, b, c)
let x = bc /\ b'c'
[abd] == 0
[abc] == 0
:factor [abd][ace] - [abe][acd]
[x a d]
given left == right"""
LONG = r"""points left right
ideal i j
let p = left right /\ i j k
p k left
[left right i k] == -[right left i k]
given coplanar(left, right, k, l)
claim [left right k l] == 0
rewrite [left right i k]"""
LETTERS = r"""line L M
plane P
screw S
[L a b] == [a L b]
L /\ P
[L P /\ abc]
:factor [[Aa, Ab, Ac, Bd, L, M]]
:factors [[Aa, Ab, Bc, Bd, L, M]]
:expand [a L /\ P, b c d]
:transversals Aa Ab Bc Bd L M
:analyze Aa Ab Ac Bd L M"""
RULES = rf"""let q = gh
{PIERCE}
rewrite ab /\ cde
{TURN}
rewrite (ab /\ cd) * (q /\ cd)
:analyze ab af cb cd ed ef"""
MINE = [opened("my rules.gca", f"{PIERCE}\nrule wrong: ab /\\ cde => [acde] b + [bcde] a\n{TURN}", "turn")]
OPENED = r"""rewrite ab /\ cde
rewrite ab /\ cd
rewrite [abcf][abde]
:analyze Aa Ab Ac Bd Ce Df"""
TEXTS: dict[str, tuple[str, list[Any]]] = {
    "space": (SPACE, []),
    "plane": (PLANE, []),
    "long names": (LONG, []),
    "letters": (LETTERS, []),
    "rules of the text": (RULES, []),
    "rules of a file": (OPENED, MINE),
    "rules of both": (f"{LAST}\n{OPENED}", [*MINE, opened("my-rules.gca", TURN)]),
}


def ran(shell: str, folder: Path) -> str:
    paths = [str(Path(sys.executable).parent), os.environ["PATH"]]
    settings = {"PATH": os.pathsep.join(paths), "PYTHONIOENCODING": "utf-8", "LC_ALL": "C.UTF-8", "COLUMNS": "100"}
    done = subprocess.run(
        ["bash", "-c", shell], cwd=folder, env=os.environ | settings, capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode in (0, 1, 3), (shell, done.stderr)
    return done.stdout.rstrip()


def printed(python: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Any:
    shown: list[Any] = []
    with monkeypatch.context() as there:
        there.chdir(folder)
        exec(python, {"print": shown.append})
    return shown[0]


def plain(text: str) -> str:
    """An answer without blanks, without the points of a counterexample, and without that the assumptions of the text
    are not used.
    """
    text = re.sub(r"(?m)^ +[a-zA-Z'_0-9]+ = \(.*\)\n?|^ +(left|right) side = .*|^ +assumptions  not used.*", "", text)
    text = re.sub(r" \(shown with --\w+\)", "", text)
    for sign, word in (("∧", "/\\"), ("∨", "\\/"), ("−", "-"), (" · ", " * ")):
        text = text.replace(sign, word)
    return "".join(text.split())


def same(one: str, answer: str, statement: str) -> bool:
    """Whether a line gives an answer; that of a statement repeats what was written."""
    if statement.startswith("claim"):
        return one.partition(":")[0] == answer.partition(":")[0]
    return one == (answer.partition("=")[2] if statement.startswith("show") else answer)


@pytest.mark.parametrize("name", TEXTS)
def test_the_lines_give_the_answer(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text, files = TEXTS[name]
    found = bench(text, None, None, files)
    assert found["results"]
    for result in found["results"]:
        repeat = result["repeat"]
        assert repeat is not None
        for file in repeat["files"]:
            (tmp_path / file["name"]).write_text(file["text"], encoding="utf-8")
        statement = text[result["start"] : result["end"]]
        assert same(plain(ran(repeat["shell"], tmp_path)), plain(result["text"]), statement), repeat["shell"]
        if repeat["python"]:
            shown = printed(repeat["python"], tmp_path, monkeypatch)
            given = plain(str(shown))
            if statement.startswith("claim"):
                given = given.partition(":")[0]
            assert given in plain(result["text"]) + plain(result["tex"]), repeat["python"]


# --- lines that are pasted into a terminal -------------------------------------------------------------------------

BAD = {
    "an expansion in a name": 'rule r "$(echo ran) `echo ran`": ab /\\ cde => [acde] b - [bcde] a',
    "the end of a paste": 'rule r "\x1b[201~": ab /\\ cde => [acde] b - [bcde] a',
    "the end of the lines": 'rule r "x":\nab /\\ cde =>\n[acde] b - [bcde] a # \n  source "\x1bEND"',
    "an end behind a key": "let p = ab # \x1b\n  # \x1bEND\n[abcd] # $(echo ran)",
    "legs with a key": ":analyze ab af cb cd ed ef # \x1b[201~ $(echo ran)",
    "legs over a line": ":transversals Aa Ab Bc Bd\u2028Cc De # `echo ran`",
    "a claim with a label": 'claim "$(echo ran)\x9b": [abcd] == -[bacd]',
}


@pytest.mark.parametrize("text", BAD.values(), ids=BAD)
def test_the_shell_runs_nothing_of_an_answer(text: str, tmp_path: Path) -> None:
    found = bench(text, None, None)
    assert found["results"] or found["fault"]
    for result in found["results"]:
        assert result["repeat"] is not None
        for line in (result["repeat"]["shell"], result["repeat"]["python"]):
            assert not re.search(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028]", line)
        heard = ran(f"gcrules() {{ cat > given; }}\n{result['repeat']['shell']}", tmp_path)
        assert heard == ""
