"""`checkers/check_map.py` shares no code with gcrules: it recomputes the cells of maps, and confirms nothing false."""

from __future__ import annotations

import gzip
import itertools
import json
import os
import random
import re
import subprocess
import sys
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from commands import invoke
from map_certificates import JUNK, leaves, put, run, signed
from places import EXAMPLES, ROOT, checker

import gcrules as gc
from gcrules.core.errors import FileError, InputError, LimitReached
from gcrules.poses.maps import cell_certificate
from gcrules.poses.maps.axes import read_axes

CHECK = checker("check_map")
FILES = [
    ROOT / "checkers" / f"{name}.py"
    for name in ("check_map", "map_slice", "map_polynomials", "map_turns", "map_cells", "map_joints", "map_actuators")
]
OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
FLAT = {"legs": "ad ae be bf cf cd", "points": {n: (k, k * k, 0) for k, n in enumerate("abc")}}
FLAT["points"] |= {n: (k, 5 - k * k, 0) for k, n in enumerate("def")}
MAPS: dict[str, tuple[Any, list[str], dict[str, Any]]] = {
    "shifts": (OCTAHEDRAL, ["x -300:300:7", "z -500:100:7"], {}),
    "in space": (OCTAHEDRAL, ["x -300:300:4", "y -300:300:4", "z -500:100:4"], {}),
    "turned shifts": (OCTAHEDRAL, ["x -300:300:4", "z -500:100:4"], {"at": "0 10 50; euler zyx 10 20 30 deg"}),
    "around": (OCTAHEDRAL, ["yaw -90:90:4 deg", "z -100:100:2"], {}),
    "vector": (OCTAHEDRAL, ["rx 10:60:3 deg", "ry 10:80:3 deg"], {"at": "0 0 50; rotvec 10 20 30 deg"}),
    "tilt": (OCTAHEDRAL, ["azimuth -60:60:3 deg", "tilt 0:60:3 deg"], {"at": "0 0 50"}),
    "euler": (OCTAHEDRAL, ["ZXZ2 -1:1:4 rad", "x 0:9:3"], {"at": "0 0 50; euler ZXZ 0.1 0.2 0.3 rad"}),
    "everywhere": (FLAT, ["x 1:2:3", "y 1:2:3"], {}),
}


@cache
def text(name: str) -> str:
    source, over, more = MAPS[name]
    measure = "margin" if any(axis.split()[0] not in ("x", "y", "z") for axis in over) else "value"
    return json.dumps(gc.singular_map(source, over, measure=measure, **more).certificate())


def data(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads(text(name))
    return found


def recounted(file: dict[str, Any]) -> dict[str, Any]:
    letters = "".join(itertools.chain.from_iterable(file["cells"]))
    file["claim"] = {w: letters.count(c) for c, w in CHECK.WORDS.items()}
    return signed(file)


@pytest.mark.parametrize("name", MAPS)
def test_cells_are_recomputed(name: str) -> None:
    words, left = CHECK.checked(data(name))
    claim = data(name)["claim"]
    assert left == claim["undecided"]
    assert words.startswith(f"recomputed: {claim['free']} cells free, {claim['crossed']} crossed, undecided: ")
    assert "recomputed, not proved in Coq" in words
    assert ("in whole numbers" in words) == (data(name)["factors"] is not None)


def test_the_guide_has_what_is_printed() -> None:
    found = gc.singular_map(OCTAHEDRAL, ["x -300:300:31", "z -500:100:41"], measure="value")
    guide = (ROOT / "docs" / "map.md").read_text(encoding="utf-8")
    words, _, digest = CHECK.checked(found.certificate())[0].partition("digest ")
    assert f"{words}digest " in guide
    assert len(digest) == 64


def test_everywhere_all_cells_are_crossed() -> None:
    assert data("everywhere")["cells"] == ["xx", "xx"]
    file = data("everywhere")
    file["cells"][0] = "xf"
    with pytest.raises(CHECK.Refused, match="is called free, and it is crossed"):
        CHECK.checked(recounted(file))


def test_the_programs_are_short_and_stand_alone() -> None:
    for file in FILES:
        words = file.read_text(encoding="utf-8")
        assert len(words.splitlines()) <= 400
        imported = re.findall(r"^(?:from|import) (\w+)", words, re.MULTILINE)
        beside = {path.stem for path in (ROOT / "checkers").glob("*.py")}
        assert {*imported} - beside <= sys.stdlib_module_names


def test_the_command_writes_what_the_program_reads(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    over = ["--over", "x -300:300:4", "--over", "z -500:100:4"]
    done = invoke("map", OCTAHEDRAL, *over, "--measure", "value", "--certificate", str(tmp_path / "a.json"))
    assert done.exit_code == 0
    assert run((tmp_path / "a.json").read_bytes(), tmp_path, monkeypatch) == 0
    found = gc.singular_map(OCTAHEDRAL, over[1::2], measure="value")
    found.save_certificate(str(tmp_path / "b.json.gz"))
    assert gzip.decompress((tmp_path / "b.json.gz").read_bytes()) == (tmp_path / "a.json").read_bytes()
    assert run((tmp_path / "b.json.gz").read_bytes(), tmp_path, monkeypatch) == 0
    with pytest.raises(FileError, match="not a name for a certificate"):
        found.save_certificate(str(tmp_path / "b.txt"))


def test_what_has_no_certificate_is_refused_plainly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    over = ["--over", "x 0:1:3", "--over", "y 0:1:3"]
    over += ["-o", str(tmp_path / "a.nc"), "--part", "1/2"]
    found = invoke("map", OCTAHEDRAL, *over, "--certificate", str(tmp_path / "a.json"))
    assert (found.exit_code, "--certificate is of a whole map" in found.stderr) == (2, True)
    singular = gc.singular_map(FLAT, ["yaw 0:9:3 deg", "y 1:2:3"], measure="value")
    with pytest.raises(InputError, match="was seen at random poses"):
        singular.certificate()
    monkeypatch.setattr(cell_certificate, "MAX_CELLS", 3)
    with pytest.raises(LimitReached, match="at most 3 cells"):
        singular.certificate()


def test_files_have_the_fields_of_the_published_schema() -> None:
    schema = json.loads((ROOT / "docs" / "assets" / "map-certificate.schema.json").read_text(encoding="utf-8"))
    for name in MAPS:
        file = data(name)
        for value, one in [(file, schema), *((file[k], schema["properties"][k]) for k in ("pose", "claim"))]:
            assert {*one["required"]} == value.keys() == one["properties"].keys()
        for key, one in (("axes", "axes"), ("factors", "factors")):
            for part in file[key] or ():
                assert part.keys() == schema["properties"][one]["items"]["properties"].keys()


# --- attacks -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["shifts", "around"])
def test_files_that_were_changed_are_refused(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As they stand every change is seen by the digest; with a new digest what is malformed is refused without a
    trace, and what is accepted is no false map.
    """
    file, rng = data(name), random.Random(1)
    places = [p for p in leaves(file) if p]
    for path in rng.sample(places, {"shifts": 50, "around": 20}[name]):
        for junk in rng.sample(JUNK, 4):
            new = put(file, path, junk)
            if new == file:
                continue
            assert run(json.dumps(new), tmp_path, monkeypatch) in (1, 2)
            if path[0] in ("made by", "title", "digest"):
                continue
            code = run(json.dumps(signed(new)), tmp_path, monkeypatch)
            said = capsys.readouterr().out
            assert "Traceback" not in said
            assert code in (1, 2) or is_true(new) or (code == 3 and "NOT decided here" in said), path


def rows(file: dict[str, Any], places: Any) -> Any:
    """The wrenches of a map without turns at places (N, 2) counted in nodes: (N, 6, 6), in floats."""
    points = {n: np.array([float(Fraction(c)) for c in p]) for n, p in file["points"].items()}
    shift = np.array([[float(Fraction(c)) for c in file["pose"]["translation"]]] * len(places))
    for k, a in enumerate(file["axes"]):
        start, stop = (float(Fraction(a[end])) for end in ("start", "stop"))
        shift[:, "xyz".index(a["name"])] = start + places[:, k] * (stop - start) / (a["number"] - 1)
    base, end = (np.array([points[leg[k]] for leg in file["legs"]]) for k in (0, 1))
    force = end[None] + shift[:, None] - base[None]
    return np.concatenate([force, np.cross(base[None], force)], axis=2)


def is_true(file: dict[str, Any]) -> bool:
    """Whether all free cells of a map of shifts of x and z have one sign at places at random, none of them 0; of other
    maps whether the points of the legs are as they were.
    """
    if file["factors"] is None:
        return bool(file["legs"] == data("around")["legs"] and file["points"] == data("around")["points"])
    rng = np.random.default_rng(7)
    for k, row in enumerate(file["cells"]):
        for j, letter in enumerate(row):
            values = np.linalg.det(rows(file, np.array([k, j]) + rng.random((20, 2))))
            if letter == "f" and (values.min() <= 0) == (values.max() >= 0):
                return False
    return True


def test_numbers_that_were_changed_a_little_make_no_false_map() -> None:
    """Dimensions, ranges and factors: what is still accepted agrees with determinants at random places."""
    file, rng, accepted = data("shifts"), random.Random(2), 0
    numbers = [p for p in leaves(file) if p and p[0] in ("points", "axes", "pose", "centre", "factors", "legs")]
    numbers = [p for p in numbers if isinstance(value_at(file, p), str) and p[-1] not in ("name", "unit")]
    for path in numbers:
        value = value_at(file, path)
        if path[0] == "legs":
            new = put(file, path, rng.choice("abcdef"))
        else:
            new = put(file, path, str(Fraction(value) + rng.choice([1, -1, 40, -250, Fraction(1, 7)])))
        try:
            CHECK.checked(signed(new))
        except CHECK.Refused:
            continue
        accepted += 1
        assert is_true(new), path
    assert accepted > 3


def value_at(file: Any, path: tuple[Any, ...]) -> Any:
    for key in path:
        file = file[key]
    return file


@pytest.mark.parametrize("name", ["shifts", "around"])
def test_another_status_of_a_cell_is_refused(name: str) -> None:
    """A free cell is not crossed, nor a crossed one free; one that is called undecided is told what it is."""
    file = data(name)
    texts = [p for p in leaves(file["cells"]) if isinstance(value_at(file["cells"], p), str)]
    for path, n in random.Random(3).choices(
        [(p, n) for p in texts for n in range(len(value_at(file["cells"], p)))], k=3
    ):
        row = value_at(file["cells"], path)
        for letter in "fxu":
            new = put(file, ("cells", *path), row[:n] + letter + row[n + 1 :])
            new["claim"] = dict.fromkeys(CHECK.WORDS.values(), 0)
            for _, one in CHECK.listed_cells(new["cells"], [a["number"] - 1 for a in file["axes"]], CHECK.WORDS):
                new["claim"][CHECK.WORDS[one]] += 1
            if letter == row[n]:
                CHECK.checked(signed(new))
            elif letter == "u":
                what = "1 are free and 0 crossed" if row[n] == "f" else "0 are free and 1 crossed"
                found, left = CHECK.checked(signed(new))
                assert left == 1
                assert what in found
            else:
                with pytest.raises(CHECK.Refused, match="is called"):
                    CHECK.checked(signed(new))


def test_cells_that_are_missing_or_larger_are_refused() -> None:
    file = data("shifts")
    for new in (
        put(file, ("cells",), file["cells"][:-1]),
        put(file, ("cells",), [*file["cells"], file["cells"][0]]),
        put(file, ("cells", 2), file["cells"][2][1:]),
        put(file, ("axes", 0, "number"), 6),
        put(file, ("axes", 0, "number"), 10**9),
        put(file, ("axes", 0, "number"), True),
        put(file, ("axes", 1, "stop"), "1000"),
        put(file, ("axes", 1, "start"), "100"),
        put(file, ("axes",), file["axes"][::-1]),
        put(file, ("axes",), file["axes"][:1]),
        put(file, ("axes", 1), file["axes"][0]),
    ):
        with pytest.raises(CHECK.Refused):
            CHECK.checked(signed(new))
    with pytest.raises(CHECK.Refused, match="the numbers claimed are not those of the cells"):
        CHECK.checked(signed(put(file, ("claim", "free"), file["claim"]["free"] + 1)))


@pytest.mark.parametrize(
    ("words", "code"),
    [
        ('{"format":', 2),
        ("[" * 100_000, 2),
        ("NaN", 2),
        ("1" * 5000, 2),
        ('{"format":"gcrules map certificate 1","format":"gcrules map certificate 1"}', 2),
        ('{"format":"gcrules map certificate 1"}', 2),
        ("null", 2),
        ("[]", 2),
        ("\udcff", 2),
    ],
)
def test_what_is_no_certificate_is_refused(
    words: str, code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(words.encode("utf-8", "surrogateescape"), tmp_path, monkeypatch) == code
    assert capsys.readouterr().out.startswith("refused: ")


def test_a_name_that_is_given_twice_and_numbers_that_are_none_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for old, new in (('"number": 7', '"number": 7, "number": 7'), ('"number": 7', '"number": NaN'), (": 7", ": 7.0")):
        assert old in text("shifts")
        assert run(text("shifts").replace(old, new, 1), tmp_path, monkeypatch) == 2
    packed = gzip.compress(text("shifts").encode())
    for damaged in (packed[:100], packed[:10] + b"\7" + packed[11:]):
        assert run(damaged, tmp_path, monkeypatch) == 2


def test_a_unit_says_nothing_else(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    said = text("shifts").replace('"mm"', '"mm in 9 cells, y 0..9 mm"')
    assert run(json.dumps(signed(json.loads(said))), tmp_path, monkeypatch) == 2


def test_names_that_the_output_cannot_show(tmp_path: Path) -> None:
    path = tmp_path / "cells.json"
    path.write_text(json.dumps(signed(json.loads(text("shifts").replace('"a"', '"\u03b1"')))), encoding="utf-8")
    run = [sys.executable, CHECK.__file__, path]
    done = subprocess.run(
        run, capture_output=True, text=True, env={**os.environ, "PYTHONIOENCODING": "ascii"}, check=False
    )
    assert (done.returncode, "\\u03b1" in done.stdout) == (0, True)


def test_cells_that_are_not_decided_here_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    """They are neither confirmed nor refused."""
    file = data("shifts")
    monkeypatch.setattr(CHECK, "cells_of", lambda one, shape, exact, say=None: {(0, 0): "u"})
    monkeypatch.setattr(CHECK, "listed_cells", lambda rows, shape, words: iter([((0, 0), "f"), ((0, 1), "f")]))
    file["claim"] = {"free": 2, "crossed": 0, "undecided": 0}
    words, left = CHECK.checked(signed(file))
    assert left == 1
    assert words.startswith(
        "recomputed: 1 cells free, 0 crossed, undecided: none\nNOT decided here: 1 cells that are called free"
    )


# --- what it relies on ---------------------------------------------------------------------------------------------


TURNS = [
    (["rx 10:60:3 deg", "rz -80:300:3 deg"], "0 0 50; rotvec 10 20 30 deg"),
    (["rx -3:3:4 rad", "ry -3:0.1:3 rad"], "0 0 50"),
    (["azimuth -160:160:3 deg", "tilt 0:160:3 deg", "torsion -40:70:3 deg"], "0 0 50"),
    (["ZXZ2 -60:260:4 deg", "ZXZ1 -60:80:3 deg"], "0 0 50; euler ZXZ 10 20 30 deg"),
    (["zxy2 -60:260:3 deg", "y -300:300:3"], "0 0 50; euler zxy 10 20 30 deg"),
]


@pytest.mark.parametrize(("over", "at"), TURNS)
def test_determinants_with_bounds_are_those_of_gcrules(over: list[str], at: str) -> None:
    """Up to one number; and what a box holds at places at random is within its bounds."""
    turns, found = checker("map_turns"), gc.singular_map(OCTAHEDRAL, over, at, measure="value")
    one = turns.Turned(CHECK.Slice(json.loads(json.dumps(found.certificate()))))
    values = found.values("superbracket")
    ratio = []
    for node in np.ndindex(*values.shape):
        matrix = one._rows(tuple(map(Fraction, node)), [0] * len(node))
        ratio.append(values[node] / np.linalg.det(np.array([[v.c for v in row] for row in matrix])))
    assert np.ptp(ratio) < 1e-9 * abs(ratio[0])
    rng = np.random.default_rng(1)
    for n in range(6):
        half = [Fraction(1, 2**n)] * len(over)
        middle = [Fraction(float(rng.uniform(0, c - 1))) for c in values.shape]
        box, t = one._rows(middle, half), rng.choice([-1, -0.5, 0.5, 1], len(over))
        there = one._rows([m + h * Fraction(x) for m, h, x in zip(middle, half, t, strict=True)], [0] * len(over))
        for value, point in zip(itertools.chain(*box), itertools.chain(*there), strict=True):
            assert abs(point.c - value.c - float(np.dot(value.a, t))) <= value.e


def test_nodes_at_quarter_turns_are_exact() -> None:
    turns = checker("map_turns")
    for over in (
        ["yaw -90:180:4 deg", "roll -90:0:2 deg"],
        ["ry -180:180:5 deg", "x 0:1:2"],
        ["tilt 0:90:2 deg", "x 0:1:2"],
    ):
        found = gc.singular_map(OCTAHEDRAL, over, measure="value")
        one, values = turns.Turned(CHECK.Slice(found.certificate())), found.values("superbracket")
        assert len(read_axes(over)) == values.ndim
        for node in np.ndindex(*values.shape):
            size = values[node] / np.abs(values).max()
            assert one._exact(tuple(map(Fraction, node))) == (0 if abs(size) < 1e-9 else -np.sign(size))


def test_a_double_zero_is_seen_by_the_factors() -> None:
    """A square has no change of sign; a file that hides the factors, or names others, is refused."""
    p, s = {(2, 0): 1, (1, 0): -1, (0, 0): Fraction(1, 4)}, (3, 1)
    one = CHECK.Polynomial(CHECK.in_whole_numbers(p))
    assert CHECK.cells_of(one, s, True) == {(0, 0): "x"}  # its zero is the middle of the first cell
    third = CHECK.Polynomial({(2, 0): 9, (1, 0): -6, (0, 0): 1})
    assert CHECK.cells_of(third, s, True) == {(0, 0): "u"}
    assert CHECK.cells_of(CHECK.Polynomial({(1, 0): 3, (0, 0): -1}), s, True) == {(0, 0): "x"}
