"""The bench as a workbench: questions, scripts, theorems, completion."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

import gcrules as gc
from gcrules.algebra.language.statements import parse_script
from gcrules.apps.studio.bench import bench
from gcrules.apps.studio.bench_text import completed, scripted
from gcrules.apps.studio.protocol.bench_words import BENCH_COMMANDS
from gcrules.core.errors import GcrulesError
from gcrules.mechanisms.description.discovery import theorems

pytest.importorskip("starlette", reason="needs the extra gcrules[studio]")

if TYPE_CHECKING:
    from studio_page import Desk

OCTAHEDRAL = "[[ab, af, cb, cd, ed, ef]]"


# --- questions -----------------------------------------------------------------------------------------------------


def test_each_question_is_answered_as_by_its_function() -> None:
    text = "\n".join(f":{name} {OCTAHEDRAL}" for name in ("expand", "straighten", "factor", "shorten"))
    found = bench(text, None, None)
    assert found["fault"] is None
    shown = [r["text"].partition("\n")[0] for r in found["results"]]
    for formula in shown:
        assert gc.prove(f"{OCTAHEDRAL} == {formula}").verdict == "proved"
    assert [r["command"] for r in found["results"]] == ["expand", "straighten", "factor", "shorten"]
    assert all(r["pieces"] for r in found["results"])
    assert shown[2] == "abc ∧ aef ∧ bdf ∧ cde"
    assert len(gc.shorten(OCTAHEDRAL).polynomial) == shown[3].count("[") // 3


def test_the_last_result_goes_on() -> None:
    found = bench("rank 3\n:factor [abd][ace] - [abe][acd]\n:straighten\n:prove % == [abc][ade]", None, None)
    assert [r["verdict"] for r in found["results"]] == ["value", "value", "proved"]


def test_transversals_of_legs() -> None:
    found = bench(":transversals Aa Ab Bc Cd De Ef", None, None)
    (result,) = found["results"]
    reading: Any = gc.transversals("Aa Ab Bc Cd De Ef").condition
    assert result["text"].startswith("transversals:")
    assert " ".join(result["text"].split()).count(" ".join(reading.sentence.split())) == 1


@pytest.mark.parametrize(
    "line", [":load /etc/passwd", ":save x", ":analyze /etc/passwd", ":analyze ab", ":quit", ":lo x", ":nothing"]
)
def test_no_question_opens_a_file_or_ends_the_session(line: str) -> None:
    found = bench(f"[abcd]\n{line}", None, None)
    assert len(found["results"]) == 1
    assert found["fault"] is not None
    assert found["fault"]["place"]["line"] == 2


def test_legs_that_look_like_a_file_are_legs(tmp_path: Path) -> None:
    secret = tmp_path / "secret.yaml"
    secret.write_text("a secret", encoding="utf-8")
    found = bench(f":transversals {secret}", None, None)
    assert found["fault"] is not None
    assert "a secret" not in str(found)


def test_faults_have_their_place_in_the_whole_text() -> None:
    fault = bench("[abcd]\n\n:factor ab", None, None)["fault"]
    assert fault is not None
    assert "only scalars are factored" in fault["message"]
    assert (fault["place"]["line"], fault["place"]["column"]) == (3, 9)


# --- scripts -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", theorems().values(), ids=theorems())
def test_theorems_are_saved_as_they_are(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert scripted(text, None)["text"] == text


def test_what_is_written_becomes_a_script_that_says_the_same() -> None:
    text = "# two lines\nlet p = ab /\\ cde\n\np \\/ cdf\n# below\n[abcd] == -[bacd]\n:factor p \\/ cdf\n"
    script = scripted(text, None)["text"]
    assert script.splitlines() == [
        "# two lines",
        "let p = ab /\\ cde",
        "",
        "show p \\/ cdf",
        "# below",
        "claim [abcd] == -[bacd]",
        "# :factor p \\/ cdf",
    ]
    assert len(parse_script(script, "x").statements) == 2


def test_a_text_with_a_fault_is_not_saved() -> None:
    with pytest.raises(GcrulesError):
        scripted("[abc", None)


# --- completion ----------------------------------------------------------------------------------------------------


def test_completion_offers_what_works_here() -> None:
    def offered(text: str) -> list[str]:
        return [option["text"] for option in completed(text, None)["options"]]

    assert offered(":st") == [":straighten", ":steps"]
    assert offered(":lo") == []
    assert offered(":analyze /") == offered(":load /") == offered(":transversals /e") == []
    assert offered("points left right\nle") == ["let", "left"]
    assert offered("let plane = abc\n[d, pl") == ["plane"]
    assert offered("ab \\we") == ["∧"]
    assert {w[1:] for w in offered(":")} == {*BENCH_COMMANDS}


# --- the page ------------------------------------------------------------------------------------------------------

BENCH = "gcrules.bench$.value"


def written(desk: Desk, text: str) -> Desk:
    desk.one("panel-bench").click()
    desk.run("text => gcrules.edit({bench: text})", text)
    desk.page.locator(".cm-content").click()
    desk.page.keyboard.press("Control+End")
    return desk


@pytest.mark.browser
def test_buttons_ask_of_the_statement_under_the_cursor(desk: Desk) -> None:
    written(desk, f"let S = {OCTAHEDRAL}\n{OCTAHEDRAL}")
    desk.one("bench-factor").click()
    assert desk.run(BENCH).splitlines()[-1] == f":factor {OCTAHEDRAL}"
    desk.page.wait_for_function("() => document.body.innerText.includes('searched')")
    desk.one("bench-straighten").click()  # of what was asked before
    assert desk.run(BENCH).splitlines()[-1] == f":straighten {OCTAHEDRAL}"
    desk.one("bench-transversals").click()
    assert desk.run(BENCH).splitlines()[-1] == ":transversals ab af cb cd ed ef"
    desk.one("bench-declare").select_option("given")
    assert desk.run(BENCH).splitlines()[1] == "given collinear(a, b, c)"  # behind the name, which it may need
    desk.page.keyboard.type("coplanar(a, b, c, d)")  # what is to be changed is selected
    assert desk.run(BENCH).splitlines()[1] == "given coplanar(a, b, c, d)"
    desk.one("bench-declare").select_option("rank")
    assert desk.run(BENCH).splitlines()[0] == "rank 3"
    desk.one("bench-factor").click()  # a declaration is nothing to factor
    assert "Put the cursor on an expression" in desk.text("bench-note")


@pytest.mark.browser
def test_a_theorem_is_opened_and_saved(desk: Desk, tmp_path: Path) -> None:
    desk.one("panel-bench").click()
    desk.page.wait_for_function("() => window.gcrules.gallery.value !== null")
    desk.one("bench-examples").select_option(label="Pappus' theorem")
    desk.page.locator("[data-testid=bench-result][data-verdict=proved]").wait_for()
    with desk.page.expect_download() as download:
        desk.one("bench-save").click()
    path = tmp_path / download.value.suggested_filename
    download.value.save_as(path)
    assert path.read_text(encoding="utf-8") == theorems()["pappus"].read_text(encoding="utf-8")
    other = theorems()["pascal"]
    desk.one("bench-file").set_input_files(str(other))
    desk.page.wait_for_function("() => window.gcrules.bench$.value.startsWith('# Pascal')")
    desk.one("undo").click()
    assert desk.run(BENCH).startswith("# Pappus")


@pytest.mark.browser
def test_completion_and_help_on_words(desk: Desk) -> None:
    written(desk, "points left right\n")
    desk.page.keyboard.type(":strai")
    desk.page.locator(".cm-tooltip-autocomplete li").first.wait_for()
    desk.page.wait_for_timeout(200)  # a key that comes at once is not taken for a choice
    desk.page.keyboard.press("Enter")
    assert desk.run(BENCH).endswith(":straighten")
    desk.page.locator(".cm-line").first.hover(position={"x": 12, "y": 8})
    desk.page.locator(".bench-tip").wait_for()
    assert "long names" in desk.page.locator(".bench-tip").inner_text()


@pytest.mark.browser
@pytest.mark.parametrize("width", [390, 320])
def test_the_bench_fits_a_phone(sit_down: Callable[..., Desk], width: int) -> None:
    desk = sit_down(viewport={"width": width, "height": 760}).visit()
    written(desk, f":factor {OCTAHEDRAL}")
    desk.page.wait_for_function("() => document.body.innerText.includes('searched')")
    assert desk.run("document.documentElement.scrollWidth") <= width
