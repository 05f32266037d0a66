"""The section of a report about a certificate: what `gcrules certify` says, its picture, and the file in the page."""

from __future__ import annotations

import gzip
import json
import math
import re
import subprocess
import sys
from base64 import b64decode
from functools import cache
from html import unescape
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from certificate_trees import sign_at
from commands import invoke, refuse_report
from places import EXAMPLES, ROOT
from views.shown_sections import agrees, plain

import gcrules as gc
from gcrules.core.errors import FileError
from gcrules.poses.certificates.certificate import Certificate

OCTAHEDRAL = str(EXAMPLES / "octahedral.yaml")
BOXES = 32_768  # as the report has
HEAD = ["roll -40:40 deg", "pitch -40:40 deg", "yaw -65:65 deg"]
ASKED: dict[str, tuple[str, list[str], dict[str, Any]]] = {
    "free": (OCTAHEDRAL, ["x -50:50", "roll -10:10 deg"], {"cone": "60 deg", "tilt": "8 deg", "margin": 0.05}),
    "three coordinates": ("3-rpr", ["x -0.1:0.1", "y -0.1:0.1", "yaw -5:5 deg"], {"limits": "actuators -0.6..0.6"}),
    "singular": (OCTAHEDRAL, ["z -400:0", "roll -5:5 deg"], {"at": "10 0 0"}),
    "of joints": ("reachy-mini-head", ["yaw 0:95 deg"], {}),
    "below": (OCTAHEDRAL, ["z -300:0"], {"margin": 0.35}),
    "three legs": ("3-rps", ["z -0.2:0.2", "pitch -10:10 deg"], {"margin": 0.1}),
}


@cache
def certificate(name: str) -> Certificate:
    robot, over, options = ASKED[name]
    return gc.certify(robot, over, boxes=BOXES, **options)


@cache
def page(name: str) -> str:
    robot, over, options = ASKED[name]
    return gc.report(robot, interactive=False, certify=over, **options)


def section(text: str) -> str:
    return re.findall(r'<section class="motion.*?</section>', text, re.DOTALL)[-1]  # after the numbers at home


@pytest.mark.parametrize("name", ASKED)
def test_the_section_says_what_the_certificate_says(name: str) -> None:
    agrees(page(name), certificate(name))
    assert "<h2>A certificate over " in page(name)
    kind = {"singular": " singular", "of joints": " singular", "below": " singular"}.get(name, "")
    assert f'<section class="motion{kind}">' in page(name)


def carried(text: str) -> bytes:
    """The file that a page carries."""
    found = re.search(r'<a download="([a-z0-9.-]+\.json\.gz)" href="data:application/gzip;base64,([^"]+)"', text)
    assert found
    return b64decode(found[2])


@pytest.mark.parametrize("name", ASKED)
def test_the_page_carries_the_certificate(name: str) -> None:
    assert json.loads(gzip.decompress(carried(page(name)))) == json.loads(json.dumps(certificate(name).to_json()))
    assert "check_certificate.py FILE" in plain(page(name))


def test_the_file_of_a_page_is_proved_again(tmp_path: Path) -> None:
    """By the checker, which shares no code with gcrules."""
    path = tmp_path / "carried.json.gz"
    path.write_bytes(carried(page("free")))
    checker = ROOT / "checkers" / "check_certificate.py"
    done = subprocess.run([sys.executable, str(checker), str(path)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "proved" in done.stdout


# --- the picture ----------------------------------------------------------------------------------------------------


@cache
def limited() -> Certificate:
    """Three coordinates, with boxes of several kinds."""
    limits = "actuators -84..44 deg"
    return gc.certify("reachy-mini-head", HEAD, limits=limits, cone="40 deg", margin=0.03, boxes=2_000)


KINDS = {"f": "free", "g": "other", "o": "outside", "x": "crossed", "u": "undecided"}


@pytest.mark.parametrize("name", ["limited", "singular"])
def test_boxes_fill_the_range_and_are_what_the_tree_says(name: str) -> None:
    c = limited() if name == "limited" else certificate(name)
    leaves = c.leaves()
    assert leaves.shares.sum() == pytest.approx(1)
    volumes = np.prod(2 * leaves.boxes.halves, axis=1)
    assert volumes / volumes.sum() == pytest.approx(leaves.shares)
    of = {kind: float(leaves.shares[leaves.status == number].sum()) for number, kind in enumerate(gc_meanings())}
    free, other, outside, crossed, undecided = c.shares
    assert of == pytest.approx({"free": free + other, "crossed": crossed, "undecided": undecided, "outside": outside})
    for middle, status in zip(leaves.boxes.middles[::7] / c.task.units, leaves.status[::7], strict=True):
        kind = KINDS[sign_at(c, middle.tolist())]
        assert gc_meanings()[status] == ("free" if kind == "other" else kind)


def gc_meanings() -> tuple[str, ...]:
    return ("free", "crossed", "undecided", "outside")


def test_slices_show_what_the_tree_says_of_their_poses() -> None:
    """Of each panel the boxes fill it, and have the colours of what is proved at places in them."""
    pytest.importorskip("matplotlib")
    from matplotlib.colors import to_hex

    from gcrules.views.plots.box_drawing import COLOURS
    from gcrules.views.plots.certificate_plot import figure
    from gcrules.views.results.certificate_place import shown_place

    c, colours = limited(), {colour.lower(): name for name, colour in COLOURS.items()}
    at = [c + 1e-7 for c in shown_place(c).place]
    panels = figure(c).axes
    assert len(panels) == 3
    for (i, j), axes in zip([(0, 1), (0, 2), (1, 2)], panels, strict=True):
        area = 0.0
        for collection in axes.collections:
            name = colours[to_hex(collection.get_facecolor()[0])]
            for path in collection.get_paths():
                low, high = path.vertices.min(axis=0), path.vertices.max(axis=0)
                area += float(np.prod(high - low))
                place = list(at)
                place[i], place[j] = (low + high) / 2
                assert KINDS[sign_at(c, place)] == name
        whole = math.prod(float(c.axes[k].stop - c.axes[k].start) for k in (i, j))
        assert area == pytest.approx(whole)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("three coordinates", "Slices over each pair of x, y and yaw through the pose with the smallest margin"),
        ("free", "Boxes of poses of Octahedral platform (3-3) over x and roll: "),
        ("of joints", "Boxes of poses of Reachy Mini head (6-RUS) over yaw: 50 % in boxes that hold such a pose"),
    ],
)
def test_the_picture_is_told_in_words(name: str, words: str) -> None:
    pytest.importorskip("matplotlib")
    found = re.search(r'<svg role="img" aria-label="(.*?)"', section(page(name)))
    assert found
    assert unescape(found[1]).startswith(words)


def test_slices_go_through_what_is_not_decided() -> None:
    from gcrules.views.results.certificate_place import shown_place

    c = gc.certify("reachy-mini-head", HEAD, limits="actuators -84..44 deg", boxes=500)
    at = shown_place(c)
    assert (at.words, at.marked) == ("the middle of the largest box that is undecided", False)
    assert sign_at(c, list(at.place)) == "u"
    words = plain(
        gc.report("reachy-mini-head", interactive=False, certify=["roll -40:40 deg"], limits="q1 -84..44 deg")
    )
    assert "--resume FILE shows it in a report" not in words  # decided


def test_a_singular_pose_is_drawn() -> None:
    """On paper, and of a platform in 3D."""
    for name in ("singular", "of joints"):
        drawn = re.search(r'<figure class="card">(.*?)</figure>', section(page(name)), re.DOTALL)
        assert drawn
        found = certificate(name)
        assert found.bad is not None
        assert f"<span>{found.bad.at}</span>" in drawn[1]
        assert "<svg" in drawn[1]
        assert "data-step" not in drawn[1]
    robot, over, options = ASKED["singular"]
    live = section(gc.report(robot, certify=over, **options))
    assert 'data-step="0"' in live
    step = json.loads(re.findall(r'<script type="application/json">(.*?)</script>', live, re.DOTALL)[0])["steps"][0]
    shift, turn = step["pose"]["translation"], step["pose"]["quaternion"]
    assert gc.pose(OCTAHEDRAL, shift, quaternion=turn, nearest=False).margin < 1e-9


# --- asking for it --------------------------------------------------------------------------------------------------


def test_the_command_writes_the_same_page(tmp_path: Path) -> None:
    out = tmp_path / "page.html"
    words = ["--certify", "x -50:50", "--certify", "roll -10:10 deg", "--cone", "60 deg", "--tilt", "8 deg"]
    done = invoke("report", OCTAHEDRAL, "--no-3d", *words, "--margin", "0.05", "-o", str(out))
    assert done.exit_code == 0, done.output
    assert out.read_text(encoding="utf-8") == page("free")


def test_a_certificate_that_took_long_is_shown_from_its_file(tmp_path: Path) -> None:
    path, over = str(tmp_path / "left.json.gz"), ["x -0.1:0.1", "roll -5:5 deg"]
    first = gc.certify("6-pus", over, limits="actuators -2..2", boxes=1)
    first.save(path)
    shown = gc.report("6-pus", interactive=False, certify=over, limits="actuators -2..2", resume=path)
    assert json.loads(gzip.decompress(carried(shown)))["claim"]["verdict"] == "free"
    with pytest.raises(FileError, match="another question"):
        gc.report("6-pus", interactive=False, certify=over, resume=path)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--certify", "x 1:-1"], "--certify:1:1: the range of x is reversed"),
        (["--certify", "x -1:1:5"], "is not a range"),
        (["--certify", "rx -1:1 deg"], "whole boxes cannot range over rx"),
        (["--certify", "x -1:1", "--cone", "40"], "--cone:1:1: '40' is not a cone"),
        (["--certify", "x -1:1", "--margin", "1.5"], "not from 0 to 1"),
        (["--cone", "40 deg"], "cones of joints are those of a certificate, which is not asked for"),
        (["--tilt", "40 deg"], "a tilt is that of a certificate, which is not asked for"),
        (["--resume", "x.json"], "a file to go on from is that of a certificate, which is not asked for"),
        (["--limits", "legs 1..2"], "add --over, --certify, --aspects or --plan"),
        (["--certify", "x -1:1", "--resume", "nothing.json"], "nothing.json: cannot be read"),
    ],
)
def test_faults_of_the_command(options: list[str], message: str, tmp_path: Path) -> None:
    refuse_report(OCTAHEDRAL, options, message, tmp_path / "page.html")
