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

from apps.studio_client import HOME
from apps.studio_client import OCTAHEDRAL as OCTAHEDRAL_CLASS

if TYPE_CHECKING:
    from apps.studio_client import Page
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


def test_answers_in_words_are_not_broken_into_lines() -> None:
    """The page breaks them to its width; the prompt to its own."""
    text = ":transversals Aa Ab Bc Cd De Ef\n:analyze aA bB cC dD eE fF"
    reading = next(iter(gc.transversals("Aa Ab Bc Cd De Ef").readings)).condition
    transversals, analysis = (r["text"].splitlines() for r in bench(text, None, None)["results"])
    assert any(reading.sentence in line for line in transversals)
    assert max(map(len, analysis)) > 200


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


def test_each_result_comes_as_a_part_before_the_whole(page: Page) -> None:
    text = "let p = AB /\\ abc\n[ABCd] == -[BACd]\n[abc"
    for args in ({"text": text, "source": OCTAHEDRAL_CLASS, "pose": HOME}, {"text": f"{text} "}):
        page.parts.clear()
        found = page.ask("bench", **args)
        assert found["fault"]["place"]["line"] == 3
        assert page.parts == [{"index": i, "result": result} for i, result in enumerate(found["results"])]
        assert bool(found["results"][0]["drawn"]) == ("pose" in args)
        page.parts.clear()
        assert page.ask("bench", **args) == found
        assert page.parts == []  # nothing is worked out again


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


# Each cyclic shift of the joints, each of the same legs: minutes of work.
LONG = "\n".join(
    f":shorten [[{', '.join(f'{a}{b}' for a, b in zip('ABCDEF', 'abcdef'[i:] + 'abcdef'[:i], strict=True))}]]"
    for i in range(6)
)


@pytest.mark.browser
def test_each_answer_is_there_before_the_last_one_and_stays_when_the_rest_is_stopped(desk: Desk) -> None:
    written(desk, f"[abcd] == -[bacd]\nlet p = ab /\\ cde\n{LONG}")
    desk.one("bench-stop").wait_for()
    desk.one("bench-result").nth(1).wait_for()
    assert desk.one("bench-run").is_enabled()
    desk.one("bench-stop").click()
    desk.one("bench-stop").wait_for(state="detached")
    results = desk.one("bench-result").all()
    assert [found.get_attribute("data-verdict") for found in results[:2]] == ["proved", "value"]
    words = "1 answer" if len(results) == 1 else f"{len(results)} answers"
    assert desk.text("bench-note") == f"Stopped with {words}. Evaluate starts over."
    assert desk.page.locator(".bench .earlier").count() == 0
    desk.run("text => gcrules.edit({bench: text})", f"[abcd] == -[bacd]\n[abcd]\n{LONG}")
    desk.page.wait_for_function(
        "() => document.querySelectorAll('[data-testid=bench-result]')[1]?.textContent.includes('[abcd]')"
    )
    desk.one("bench-stop").click()


@pytest.mark.browser
def test_a_proof_says_what_it_assumes(desk: Desk) -> None:
    written(desk, "rank 3\nisotropic i j\nequidistant(circumcentre(a, b, c), a, b)\nab == -ba")
    desk.one("bench-result").nth(1).wait_for()
    one, other = (found.inner_text() for found in desk.one("bench-result").all())
    assert "assumed not to vanish: [circumcentre(a, b, c), i, j] (circumcentre(a, b, c) is finite)" in one
    assert "both sides have the same normal form" in other


@pytest.mark.browser
def test_answers_to_the_text_before_are_marked_until_there_are_new_ones(desk: Desk) -> None:
    written(desk, f"[abcd]\n[abce]\n{LONG}")
    desk.one("bench-result").nth(1).wait_for()
    desk.one("bench-stop").click()
    desk.one("bench-stop").wait_for(state="detached")
    desk.page.locator(".cm-line").nth(1).click()
    desk.page.keyboard.press("End")
    # of one turn of the page's own: a key, and what is marked before anything is asked
    desk.run(
        """() => { const marked = () => [...document.querySelectorAll('.bench-answers')].map(
            box => box.parentElement.classList.contains('earlier'));
        window.marked = []; new MutationObserver(() => window.marked.push(marked().join())).observe(
            document.querySelector('.cm-content'), {subtree: true, childList: true, attributes: true}); }"""
    )
    desk.page.keyboard.type(" e")
    desk.page.wait_for_function("() => window.marked.some(found => found.startsWith('false,true'))")
    desk.page.wait_for_function("() => window.marked.at(-1).startsWith('false,false')")
    assert "e" in desk.one("bench-result").nth(1).inner_text()
    desk.one("bench-stop").click()


@pytest.mark.browser
def test_an_answer_stays_below_its_statement_while_the_next_line_is_begun(desk: Desk) -> None:
    written(desk, "[abcd]")
    desk.one("bench-result").first.wait_for()
    desk.run("window.answer = document.querySelector('.bench-answers').parentElement")
    desk.page.keyboard.press("Enter")
    assert desk.run("window.answer.isConnected && !window.answer.classList.contains('earlier')")
    assert desk.run("window.answer.previousElementSibling.textContent") == "[abcd]"


@pytest.mark.browser
def test_the_preview_of_legs_says_which_legs_it_is_of_while_they_are_changed(desk: Desk) -> None:
    legs = "ab af cb cd ed ef"
    preview = desk.one("legs-preview")
    desk.one("legs").fill(legs)
    preview.wait_for()
    assert f"Of {legs}" not in preview.inner_text()
    desk.one("legs").fill(f"{legs} e")
    desk.page.wait_for_function(
        "legs => document.querySelector('[data-testid=legs-preview]')?.innerText.includes(`Of ${legs}:`) "
        "|| document.querySelector('[data-testid=fault]')",
        arg=legs,
    )
    desk.one("fault").wait_for()
    assert preview.count() == 0
    assert desk.one("legs-open").is_disabled()
    desk.one("legs").fill("Aa Ab Ac Bd Be Cf")
    desk.page.wait_for_function(
        "() => document.querySelector('[data-testid=legs-preview]')?.innerText.includes('Aabc')"
    )
    assert "Of " not in preview.inner_text()
    assert desk.one("legs-open").is_enabled()


@pytest.mark.browser
@pytest.mark.parametrize("width", [390, 320])
def test_the_bench_fits_a_phone(sit_down: Callable[..., Desk], width: int) -> None:
    desk = sit_down(viewport={"width": width, "height": 760}).visit()
    written(desk, f":factor {OCTAHEDRAL}")
    desk.page.wait_for_function("() => document.body.innerText.includes('searched')")
    assert desk.run("document.documentElement.scrollWidth") <= width
