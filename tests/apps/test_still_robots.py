"""Robots of mobility 0: the numbers at home are those of their limbs, and nothing else is answered, by whatever way."""

from __future__ import annotations

import json
import warnings
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from apps.studio_client import HOME
from commands import invoke
from places import DATA

if TYPE_CHECKING:
    from apps.studio_client import Page

FILES = sorted((DATA / "still").glob("*.yaml"))
STILL = "there is nothing to drive"


@pytest.mark.parametrize("file", FILES, ids=lambda f: f.stem)
def test_home_is_told(file: Path) -> None:
    checked = invoke("robot", "check", str(file))
    assert checked.exit_code == 0
    assert STILL in checked.output
    found = invoke("pose", str(file), "--json")
    assert found.exit_code == 0
    told = json.loads(found.output)
    assert told["verdict"] == "regular"
    assert any(STILL in note for note in told["notes"])
    assert told["jacobian"]["amplification"]["condition_number"] is None
    assert invoke("robot", "analyze", str(file)).exit_code == 0


def test_a_free_motion_at_home_alone_is_no_isotropy_of_0_elsewhere() -> None:
    said = {f.stem: " ".join(invoke("pose", str(f)).output.split()) for f in FILES}
    assert "condition number not defined, isotropy not defined" in said["perpendicular"]
    assert "condition number infinite, isotropy 0" in said["sarrus"]


@pytest.mark.parametrize("words", ["aspects FILE", "free FILE", "export FILE", "plan FILE --from z=0 --to z=0.1"])
def test_other_poses_are_refused(words: str) -> None:
    refused = invoke(*(str(FILES[0]) if word == "FILE" else word for word in words.split()))
    assert refused.exit_code == 2
    assert STILL in " ".join(refused.output.split())


def test_the_studio_opens_it(page: Page) -> None:
    source = {"kind": "file", "text": FILES[0].read_text("utf-8"), "name": FILES[0].name}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        page.ask("open", source=source)
        assert page.ask("pose", source=source, pose=HOME)["verdict"] == "regular"
    assert STILL in page.fault("aspects", source=source)["message"]
