"""--brief and --full: how much of an answer is printed."""

from __future__ import annotations

import json
import re

import click
import pytest
from commands import assert_refused, invoke
from places import EXAMPLES

from gcrules.apps.cli import cli
from gcrules.apps.studio import answers
from gcrules.apps.studio.bench import bench
from gcrules.views.detail import everything, first, is_everything, naming_options, opening

THREE_PLANES = "[abfc][acde][bdef] + [abfd][acbe][cdef]"
LONG = "[Aabc][ABde][ABCf] + [Aabd][ABce][ABCf] + [Aabe][ABcd][ABCf]"
SQUARE = ("--over", "x -0.1:0.1:5", "--over", "y -0.1:0.1:5")

ANSWERS = [
    ("analyze", "ab af cb cd ed ef"),
    ("analyze", "delta"),
    ("pose", "octahedral", "--no-nearest"),
    ("pose", str(EXAMPLES / "octahedral.yaml"), "--no-nearest"),
    ("path", "3-rpr", "--at", "home", "--at", "x=0.1, y=0, yaw=0deg"),
    ("plan", "3-rpr", "--from", "home", "--to", "x=0.1, y=0, yaw=0deg"),
    ("map", "3-rpr", *SQUARE),
    ("map", str(EXAMPLES / "octahedral.yaml"), "--over", "x -10:10:5", "--over", "y -10:10:5"),
    ("map", "boxes", "3-rpr", "--over", "x -0.1:0.1", "--boxes", "3", "--tiles", "1"),
    ("certify", "3-rpr", "--over", "x -0.1..0.1"),
    ("locus", "3-rpr"),
    ("modes", "3-rpr"),
    ("factor", THREE_PLANES),
    ("shorten", THREE_PLANES),
    ("transversals", "Aa Ab Bc Bd Ce Df"),
    ("prove", r"ab /\ cd == [abcd]"),
    ("expand", r"ab /\ cde"),
]


@pytest.mark.parametrize("arguments", ANSWERS, ids=" ".join)
def test_brief_is_how_the_answer_opens(arguments: tuple[str, ...]) -> None:
    whole = invoke(*arguments, "--seed", "1") if _seeded(arguments) else invoke(*arguments)
    brief = invoke(*arguments, "--brief", "--seed", "1") if _seeded(arguments) else invoke(*arguments, "--brief")
    assert brief.exit_code == whole.exit_code
    assert whole.stdout.startswith(brief.stdout.rstrip("\n"))
    assert 1 <= len(brief.stdout.splitlines()) <= 4
    if arguments[0] not in ("prove", "expand"):
        assert len(brief.stdout) < len(whole.stdout)


def _seeded(arguments: tuple[str, ...]) -> bool:
    command = cli.get_command(click.Context(cli), arguments[0])
    return command is not None and any(p.name == "seed" for p in command.params) and arguments[1] != "boxes"


def test_brief_of_scripts_counts_them() -> None:
    done = invoke("run", str(EXAMPLES / "theorems" / "pappus.gca"), "--brief")
    assert len(done.stdout.splitlines()) == 1
    assert "proved" in done.stdout


BRIEF = {  # what answers: numbers, and how sure they are
    ("modes", "3-rps"): "8 regular, σ from 0.5739 to 0.6086, 8 certified; complete: 40 of 40 paths ended",
    ("modes", "3-rrr", "--working"): "8 regular, σ from 0.01935 to 0.3628. That there are no others is not proved.",
    ("modes", "3-upu", "--operation"): "Mode 1, of dimension 3: pure translations.",
    ("certify", "3-rpr", "--over", "x -0.1..0.1"): "(proved; smallest margin σ ≥ ",
    ("map", "boxes", "3-rpr", "--over", "x -0.1:0.1", "--tiles", "1"): "the least margin seen, in the middles of boxes",
    ("plan", "3-rpr", "--from", "home", "--to", "x=0.1, y=0, yaw=0deg"): "the margin σ is at least",
    ("shorten", LONG): "2 terms of 3, proved minimal",
    ("factor", "[[Aa,Ab,Bc,Bd,Ce,Df]]"): "none exists in the family (exhaustive-search of 12 expressions",
    ("factor", "[[Aa,Ab,Ba,Bb,Cc,Dd]]", "--cofactor"): "with a cofactor: ACc ∧ ADd ∧ ab · input = [",
    ("catalog", "show", "6-3.2"): "when the four planes ABC, Aab, Bcd and Cef meet in a point",
    ("catalog", "enumerate"): "39 classes, 39 of them in the catalog",
    ("rules", "show", "four-planes"): "Three planes X, Y, Z and a left-over plane W",
    ("rules", "check", "four-planes"): "1 rule: 1 hold, 0 wrong",
}


@pytest.mark.parametrize("arguments", BRIEF, ids=" ".join)
def test_brief_has_the_numbers_that_answer(arguments: tuple[str, ...]) -> None:
    said = invoke(*arguments, "--brief", "--unicode").stdout
    assert BRIEF[arguments] in " ".join(said.split())
    assert len(said.splitlines()) <= 3


@pytest.mark.parametrize("what", ["catalog", "rules", "robot"])
def test_lists_are_ids_or_all_there_is(what: str) -> None:
    brief, normal, full = (invoke(what, "list", *flag) for flag in (("--brief",), (), ("--full",)))
    ids = brief.stdout.splitlines()
    assert len(ids) == len(set(ids)) > 20
    assert all(" " not in one for one in ids)
    assert all(one in normal.stdout for one in ids)
    shown = invoke(what, "show", ids[1]).stdout
    assert shown in full.stdout
    assert len(full.stdout) > len(normal.stdout) > len(brief.stdout)


@pytest.mark.parametrize("other", ["--json", "--latex", "--full"])
def test_brief_is_text(other: str) -> None:
    assert_refused(invoke("pose", "3-rpr", "--brief", other), 2, "--brief is for text")


def test_full_leaves_nothing_out() -> None:
    general = "Aa Bb Cc Dd Ee Ff"
    assert "more terms, with --full" in invoke("analyze", general).stdout
    whole = invoke("analyze", general, "--full").stdout
    assert "more terms" not in whole
    assert "Derivation" in whole
    assert "shown with --full" in invoke("factor", THREE_PLANES).stdout
    assert invoke("factor", THREE_PLANES, "--full").stdout.count("  also ") == 25


@pytest.mark.parametrize(
    "asked",
    [":analyze Aa Bb Cc Dd Ee Ff", f":factor {THREE_PLANES}", ":transversals Aa Ab Bc Bd Ce Df"],
)
def test_prompt_and_bench_name_no_options(asked: str) -> None:
    """Who reads their answers has none to give."""
    (found,) = bench(asked, None, None)["results"]
    shown = invoke("repl", "-e", asked).stdout
    for words in (found["text"], shown):
        assert len(words) > 80
        assert not re.search(r"(?<![\w-])--[a-z]", words)


def test_the_studio_names_no_options(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = ("gcrules.views.detail:naming_options", lambda show, subject, args: f"1 more{show(', with --full')}")
    monkeypatch.setattr(answers, "ANSWERS", {"open": asked})
    assert answers.answer("open", None, {}) == "1 more"
    assert naming_options("--full") == "--full"


def test_full_prints_long_polynomials() -> None:
    short, whole = invoke("locus", "3-rps"), invoke("locus", "3-rps", "--full")
    assert "P is long: --full" in short.stdout
    assert "is long" not in whole.stdout
    terms = json.loads(invoke("locus", "3-rps", "--json").stdout)["parts"][0]["polynomial"]["exponents"]
    said = " ".join(whole.stdout.partition("P = ")[2].partition("\n\n")[0].split())
    assert said.count(" + ") + said.count(" - ") + 1 == len(terms)


def test_everything_ends_where_it_was_wanted() -> None:
    assert list(first(range(9), 3)) == [0, 1, 2]
    with everything():
        assert is_everything()
        assert len(first(range(9), 3)) == 9
        with everything(False):
            assert not is_everything()
    assert not is_everything()


@pytest.mark.parametrize(
    ("text", "alone"),
    [
        ("One line.\n", "One line."),
        ("regular: the legs\n  turn.\n\nrobot  x\n", "regular: the legs\n  turn."),
        ("abc\n  family       products\n", "abc"),
        ("name   facts only\n", "name   facts only"),
        ("", ""),
    ],
)
def test_opening(text: str, alone: str) -> None:
    assert opening(text) == alone


def test_what_is_assumed_stands_before_the_answer() -> None:
    legs, given = "Aa Ab Bc Bd Ce Cf", "coplanar(A, B, a, b)"
    words = " ".join(invoke("analyze", legs, "--given", given, "--brief").stdout.split())
    assert words.startswith("Suppose that A, B, a and b lie in a plane. The robot is singular exactly when one of")
    assert "Suppose" not in invoke("analyze", legs, "--brief").stdout
