"""The checker of certificates: what it proves, and that certificates that were changed are refused."""

from __future__ import annotations

import copy
import importlib.util
import json
import random
import sys
from functools import cache
from typing import Any

import pytest
from places import ROOT

import gcrules as gc

QUESTIONS: dict[str, tuple[str, list[str], dict[str, Any]]] = {
    "6-pus": ("6-pus", ["x -0.2:0.2", "roll -5:5 deg"], {"limits": "actuators -2..2"}),
    "six legs": (str(ROOT / "examples" / "octahedral.yaml"), ["x -50:50", "roll -5:5 deg"], {"cone": "60 deg"}),
    "6-rus": ("6-rus", ["z -0.05:0.05", "yaw -3:3 deg"], {"limits": "actuators -30..30 deg", "tilt": "5 deg"}),
    "singular": ("reachy-mini-head", ["yaw 0:95 deg"], {}),
}


@cache
def checker() -> Any:
    sys.path.insert(0, str(ROOT / "tools"))
    spec = importlib.util.spec_from_file_location("check_certificate", ROOT / "tools" / "check_certificate.py")
    assert spec is not None
    assert spec.loader is not None
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


@cache
def certificate(name: str) -> str:
    source, over, more = QUESTIONS[name]
    return json.dumps(gc.certify(source, over, time=30.0, **more).to_json())


@pytest.mark.parametrize("name", QUESTIONS)
def test_what_is_claimed_is_proved_again(name: str) -> None:
    assert "proved" in checker().checked(json.loads(certificate(name)))


def test_the_checker_imports_nothing_of_gcrules() -> None:
    for name in ("check_certificate.py", "certificate_intervals.py"):
        text = (ROOT / "tools" / name).read_text()
        assert "import gcrules" not in text
        assert "from gcrules" not in text
        assert len(text.splitlines()) <= 400


def changed(data: dict[str, Any], rng: random.Random) -> dict[str, Any]:
    """A certificate that says what is not so."""
    new = copy.deepcopy(data)
    match rng.randrange(6):
        case 0:
            new["tree"] = new["tree"][: rng.randrange(len(new["tree"]))]
        case 1:
            new["tree"] += "f"
        case 2:
            new["claim"]["margin at least"] = new["claim"]["smallest margin seen"] * 1.2
            new["bounds"] = [1.0] * len(new["bounds"])
        case 3:
            new["claim"]["shares"]["outside"] += 0.1
        case 4:
            places = [k for k, sign in enumerate(new["tree"]) if sign == "f"]
            k = rng.choice(places)
            new["tree"] = new["tree"][:k] + "o" + new["tree"][k + 1 :]
        case _:
            new["geometry"]["rods"] = new["geometry"]["rods"][:5]
    return new


@pytest.mark.parametrize("name", ["6-pus", "six legs"])
def test_what_was_changed_is_refused(name: str) -> None:
    rng, data = random.Random(7), json.loads(certificate(name))
    for _ in range(8):
        with pytest.raises((checker().Refused, KeyError, IndexError)):
            checker().checked(changed(data, rng))


def test_a_singular_pose_needs_both_signs_within_the_range() -> None:
    data = json.loads(certificate("singular"))
    bad = data["singular pose"]
    for ends in ([bad["opposite signs at"][0]] * 2, [[9.0], [0.0]]):
        with pytest.raises(checker().Refused):
            checker().checked({**data, "singular pose": {**bad, "opposite signs at": ends}})


def test_robots_without_a_checker_are_told() -> None:
    found = gc.certify("delta", ["x -0.1:0.1"], time=10.0).to_json()
    with pytest.raises(checker().Refused, match="no independent checker yet"):
        checker().checked(found)
