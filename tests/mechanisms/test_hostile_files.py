"""Files that nobody means: an answer or a refusal (exit code 2 or 3) in every command, and no warning of numpy."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from places import ROOT

import gcrules as gc
from gcrules.apps.cli import cli
from gcrules.apps.studio.numbers import numbers
from gcrules.apps.studio.subject import read_subject
from gcrules.core.errors import InputError
from gcrules.core.floats import as_float, decimal
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.screws.margin import jacobian
from gcrules.views.drawing.solids import flat_normal, outline, patch

GEOMETRY = (ROOT / "examples" / "octahedral.yaml").read_text(encoding="utf-8")
ROBOT = (ROOT / "plugins" / "3-rps" / "robot.yaml").read_text(encoding="utf-8")
TABLE = (ROOT / "examples" / "path.csv").read_text(encoding="utf-8")
SCRIPT = (ROOT / "examples" / "plane.gca").read_text(encoding="utf-8")
RULES = (ROOT / "plugins" / "plucker" / "plucker.gca").read_text(encoding="utf-8")
CATALOG = (ROOT / "gcrules" / "catalog.yaml").read_text(encoding="utf-8")[:3_000]
NUMBER = re.compile(r"(?<![\w.])-?\d+(?![\w.])")


def run(*words: str) -> Result:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        done = CliRunner().invoke(cli, words)
    assert done.exception is None or isinstance(done.exception, SystemExit), (words, repr(done.exception))
    assert done.exit_code in (0, 1, 2, 3), done.output
    assert not re.search(r"\b(NaN|Infinity)\b", done.stdout)
    return done


# --- what is not text, no YAML, or another file ---------------------------------------------------------------------

WAYS: dict[str, Callable[[str], bytes]] = {
    "byte order mark": lambda t: b"\xef\xbb\xbf" + t.encode(),
    "CRLF": lambda t: t.replace("\n", "\r\n").encode(),
    "CR": lambda t: t.replace("\n", "\r").encode(),
    "NUL": lambda t: t.encode()[:50] + b"\0" + t.encode()[50:],
    "Latin-1": lambda t: t.encode() + b"\n# \xe9\xff",
    "UTF-16": lambda t: t.encode("utf-16"),
    "surrogate": lambda _: b"\xed\xa0\x80",
    "every byte": lambda _: bytes(range(256)) * 20,
    "empty": lambda _: b"",
    "blank": lambda _: b"\n \n",
    "null": lambda _: b"null\n",
    "a number": lambda _: b"3\n",
    "a list": lambda _: b"[1, 2]\n",
    "deep list": lambda _: b"[" * 5000 + b"]" * 5000,
    "deep mapping": lambda _: b"{a: " * 3000 + b"1" + b"}" * 3000,
    "aliases": lambda _: b"a: &a [x, x]\nb: &b [*a, *a]\nc: [*b, *b]\n",
    "tag": lambda _: b'!!python/object/apply:os.system ["true"]\n',
    "merge": lambda t: b"<<: {a: 1}\n" + t.encode(),
    "two documents": lambda t: t.encode() + b"\n---\n" + t.encode(),
    "every key twice": lambda t: t.encode() + t.encode(),
    "half": lambda t: t.encode()[: len(t) // 2],
    "tabs": lambda t: t.replace("  ", "\t").encode(),
    "escape": lambda t: t.encode() + b"\x1b[31m",
    "a megabyte and a half": lambda _: b"a" * 1_500_000,
    "5,000 digits": lambda t: t.replace("1", "1" * 5000, 1).encode(),
}
COMMANDS = {
    "analyze": (("analyze", "{}"), GEOMETRY),
    "pose": (("pose", "{}", "--no-nearest"), GEOMETRY),
    "path": (("path", str(ROOT / "examples" / "octahedral.yaml"), "--samples", "3", "--poses", "{}"), TABLE),
    "robot check": (("robot", "check", "{}"), ROBOT),
    "run": (("run", "{}"), SCRIPT),
    "rules check": (("rules", "check", "{}"), RULES),
    "catalog": (("analyze", "--catalog", "{}", "ab af cb cd ed ef"), CATALOG),
}


@pytest.mark.parametrize(("words", "text"), COMMANDS.values(), ids=COMMANDS.keys())
def test_no_such_text(words: tuple[str, ...], text: str, tmp_path: Path) -> None:
    file = tmp_path / ("f" + {SCRIPT: ".gca", RULES: ".gca", TABLE: ".csv"}.get(text, ".yaml"))
    for way in WAYS.values():
        file.write_bytes(way(text))
        run(*(w.format(file) for w in words))


@pytest.mark.parametrize(("words", "text"), COMMANDS.values(), ids=COMMANDS.keys())
def test_no_such_file(words: tuple[str, ...], text: str, tmp_path: Path) -> None:
    (tmp_path / "d.yaml").mkdir()
    names = (tmp_path / "d.yaml", tmp_path / "none.yaml", "/dev/null", "a\0b.yaml", "\ud800.yaml", "x" * 5000 + ".yaml")
    for name in map(str, names):
        done = run(*(w.format(name) for w in words))
        assert done.exit_code == 2 or (name == "/dev/null" and words[0] == "run")  # an empty script is one
        assert "error" in done.stderr.lower() or not done.exit_code


# --- numbers that are exact and no good ----------------------------------------------------------------------------

ROWS = re.compile(r"\[[^\[\]a-z]*\]")


def _far(row: str) -> str:
    return re.sub(r"(\d+)\]", lambda m: f"{int(m[1]) + 10**15}]", row)


def rows(change: Callable[[int, str], str]) -> str:
    """The geometry file with each row of coordinates changed."""
    count = iter(range(100))
    return ROWS.sub(lambda m: change(next(count), m[0]), GEOMETRY)


NUMBERS = {
    "large": NUMBER.sub(lambda m: m[0] + "e27", GEOMETRY),
    "small": NUMBER.sub(lambda m: m[0] + "e-28", GEOMETRY),
    "sixty digits": GEOMETRY.replace("[300,", "[" + "9" * 60 + ","),
    "large in one": GEOMETRY.replace("[300,", "[1e30,"),
    "small in one": GEOMETRY.replace("[300,", "[1e-30,"),
    "mixed": GEOMETRY.replace("[150,", "[1e29,").replace("[300,", "[1e-29,"),
    "far away": rows(lambda _, row: _far(row)),
    "platform far away": rows(lambda n, row: _far(row) if n > 2 else row),
    "base far away": rows(lambda n, row: _far(row) if n < 3 else row),
    "coincident": rows(lambda n, row: "[0, 0, 0]" if n in (0, 1) else row),
    "platform in one place": rows(lambda n, row: "[1, 2, 300]" if n > 2 else row),
    "on a line": rows(lambda n, row: f"[{n}, 0, 300]" if n > 2 else row),
    "nearly on a line": rows(lambda n, row: f"[{n}, 1e-{8 + n}, 300]" if n > 2 else row),
    "very nearly on a line": rows(lambda n, row: f"[{n}, 1e-{20 + n}, 300]" if n > 2 else row),
    "nearly in one place": rows(lambda n, row: f"[1e-{20 + n}, {n}e-22, 300]" if n > 2 else row),
    "in a plane": rows(lambda n, row: f"[{n * n}, {n}, 0]"),
    "a short leg": rows(lambda n, row: "[0, -300, 1e-25]" if n == 3 else row),
    **{
        f"{word} for a number": GEOMETRY.replace("[300,", f"[{word},")
        for word in [
            "1e400",
            "1e-400",
            ".nan",
            "-.inf",
            "nan",
            "null",
            "true",
            "2020-01-01",
            "'5'",
            "[1]",
            "{a:1}",
            "1/0",
        ]
    },
}
OF_NUMBERS = (
    ("analyze", "{}", "--json"),
    ("analyze", "{}", "--figure", "x.svg"),
    ("report", "{}", "-o", "x.html"),
    ("pose", "{}", "--json", "--no-nearest"),
    ("pose", "{}", "--no-nearest", "--latex"),
    ("pose", "{}", "--no-nearest", "--at", "1 2 3; euler zyx 10 20 30 deg"),
    ("path", "{}", "--poses", str(ROOT / "examples" / "path.csv"), "--samples", "3", "--json"),
    ("map", "{}", "--over", "x -100:1e30:3", "--over", "z -500:500:3", "--json"),
    ("map", "{}", "--over", "rx -90:90:3 deg", "--over", "z -500:500:3", "--json"),
    ("locus", "{}", "--over", "z", "--json"),
)


@pytest.mark.parametrize("text", NUMBERS.values(), ids=NUMBERS.keys())
def test_numbers_in_a_geometry_file(text: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "f.yaml").write_text(text, encoding="utf-8")
    for words in OF_NUMBERS:
        done = run(*(w.format("f.yaml") for w in words))
        assert done.exit_code == 0 or done.stderr.strip()


@pytest.mark.parametrize("old", ["[0, 0, 0]", "1", "2"])
@pytest.mark.parametrize("new", ["1e30", "1e-30", "[1e30, 0, 0]", "[0, 0, 1e-30]", "9" * 60, "[nan, 0, 0]"])
def test_numbers_in_a_robot_file(old: str, new: str, tmp_path: Path) -> None:
    (tmp_path / "f.yaml").write_text(ROBOT.replace(old, new, 3), encoding="utf-8")
    for words in (("robot", "check"), ("robot", "pose", "--no-nearest"), ("pose", "--no-nearest")):
        run(*words, str(tmp_path / "f.yaml"))


@pytest.mark.parametrize("value", ["1e300", "1e-300", "1e12", "-1e15", "nan", "inf", "1e400", "1/0", "9" * 59])
@pytest.mark.parametrize(
    "option",
    [
        ("--at", "0 0 {}"),
        ("--at", "0 0 0; rotation-vector {} 1 0 rad"),
        ("--at", "0 0 0; euler zyx {} 0 0 rad"),
        ("--at", "0 0 0; quaternion {} 0 0 1"),
        ("--about", "0,{},0"),
        ("--accuracy", "{}"),
        ("--threshold", "{}deg"),
        ("--threshold", "{}mm"),
    ],
    ids=" ".join,
)
def test_numbers_in_options(option: tuple[str, str], value: str) -> None:
    run("pose", str(ROOT / "examples" / "octahedral.yaml"), "--no-nearest", *(w.format(value) for w in option))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (GEOMETRY.replace("[300,", "[1e31,"), r"f\.yaml:\d+:\d+: this number is too long"),
        (GEOMETRY.replace("[300,", "[.nan,"), r"f\.yaml:\d+:\d+: expected a finite number"),
        (NUMBERS["sixty digits"], "large|thin|small|no length"),
        (
            NUMBERS["very nearly on a line"],
            r"f\.yaml: the joints .* lie on one line but for .*, expected 1e-09",
        ),
        (NUMBERS["platform far away"], "choose an origin near the robot|thin|small"),
    ],
)
def test_what_is_said(text: str, message: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("f.yaml").write_text(text, encoding="utf-8")
    done = run("pose", "f.yaml", "--no-nearest")
    assert done.exit_code == 2
    assert re.search(message, done.stderr), done.stderr


# --- the places where the numbers are mended -----------------------------------------------------------------------


def test_a_base_far_away() -> None:
    """The exact pose of a file is seen from the platform: a base at a great distance changes nothing of its shape."""
    near, far = (gc.analyze(parse_platform(t)).pose for t in (GEOMETRY, NUMBERS["base far away"]))
    assert near is not None
    assert far is not None
    assert 0 < far.margin < near.margin


@pytest.mark.parametrize("thin", [1e-3, 1e-5, 1e-7, 1e-9])
def test_extents_of_a_thin_platform(thin: float) -> None:
    """The measure of a thin platform does not jump where another decomposition takes over: it tends to a limit."""
    base = np.array([[3.0, 0, 0], [3, 0, 0], [-2, 3, 0], [-2, 3, 0], [-2, -3, 0], [-2, -3, 0]])
    b, d, f = (1, 2 * thin, 4), (1, -2 * thin, 4 + thin / 2), (-2, 0, 4)
    ends = np.array([b, d, b, f, f, d])
    sigma, same = (float(jacobian(base, e[None]).sigma[0]) for e in (ends, ends + 1e-12))
    assert np.isfinite(sigma)
    assert sigma == pytest.approx(same, rel=1e-2)


@pytest.mark.parametrize("ends", [np.zeros((6, 3)), np.arange(18.0).reshape(6, 3), np.full((6, 3), 1e18)])
def test_a_platform_that_floats_do_not_resolve(ends: np.ndarray) -> None:
    with pytest.raises(InputError, match="floats cannot tell"), np.errstate(all="ignore"):
        jacobian(np.ones((6, 3)), ends[None])


@pytest.mark.parametrize("size", [1e-30, 1e-12, 1e-6, 1.0, 1e6, 1e30])
@pytest.mark.parametrize(
    "corners",
    [
        [(0, 0, 0), (1, 0, 0), (0, 1, 0)],
        [(0, 0, 0), (0, 0, 1), (1e-4, 0, 0), (0, 1e-4, 0)],
        [(0, 0, 0)] * 3,
        [(0, 0, 0), (1, 1, 1), (2, 2, 2)],
        [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 1e-9)],
    ],
    ids=["triangle", "needle", "one place", "line", "square"],
)
def test_solids_do_not_depend_on_size(corners: list[tuple[float, float, float]], size: float) -> None:
    scaled = [(x * size, y * size, z * size) for x, y, z in corners]
    assert (flat_normal(scaled) is None) == (flat_normal(corners) is None)
    assert len(outline(scaled)) == len(outline(corners))
    assert (patch(scaled, 0.1 * size) is None) == (patch(corners, 0.1) is None)


@pytest.mark.parametrize("power", [0, 5, 300, 308, 309, 400, 5000, -300, -400, -5000])
def test_numbers_beyond_floats_are_shown(power: int) -> None:
    number = Fraction(10) ** power
    assert float(decimal(number).partition("e")[0]) in (1, 10, 100_000)
    assert decimal(-number) == f"-{decimal(number)}"
    assert as_float(-number) == -as_float(number)


@pytest.mark.parametrize("place", [1e9, 1e15, -1e12, 1e-300])
@pytest.mark.parametrize("turn", [[1.0, 0.0, 0.0, 0.0], [5.0, 5.0, 5.0, 4.9], [1e-2, 0.0, 0.0, 1e-2]])
@pytest.mark.parametrize("robot", ["3-rps", "gough-stewart", "3-rrr", "delta"])
def test_poses_in_the_studio(robot: str, place: float, turn: list[float]) -> None:
    subject = read_subject({"kind": "robot", "id": robot})
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            found = numbers(subject, {"translation": [place, 0.0, place], "quaternion": turn})
        except InputError:
            return
    assert found["verdict"] in ("regular", "close", "singular")
