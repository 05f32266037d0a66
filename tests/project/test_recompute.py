"""`checkers/recompute.py` shares no code with gcrules: it confirms what gcrules does not find, and nothing false."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from places import ROOT, checker

import gcrules as gc
from gcrules.algebra.proofs.absence import ways
from gcrules.algebra.proofs.proof_file import LeftOut
from gcrules.rules.catalog.file import load

PROGRAM = ROOT / "checkers" / "recompute.py"
RECOMPUTE = checker("recompute")
FILES = sorted((ROOT / "checkers").glob("recompute*.py"))
MOST = 20_000_000

Data = dict[str, Any]


def data(answer: Any) -> Data:
    found: Data = json.loads(gc.proof_file(answer).json_text())
    return found


def recomputed(file: Data, most: int = MOST) -> list[str]:
    assert file["absences"]
    return [RECOMPUTE.recomputed(one, file["theorems"], most) for one in file["absences"]]


def run(file: Data, folder: Path, *options: str) -> subprocess.CompletedProcess[str]:
    path = folder / "proof.json"
    path.write_text(json.dumps(file), encoding="utf-8")
    return subprocess.run([sys.executable, PROGRAM, path, *options], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_it_is_short_and_of_the_standard_library(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 300
    imported = {line.split()[1] for line in text.splitlines() if line.startswith(("import ", "from "))}
    assert imported <= {*sys.stdlib_module_names, *(one.stem for one in FILES)}


def superbracket(class_id: str) -> Any:
    return load()[class_id].structure.superbracket


ANSWERS: dict[str, tuple[Callable[[], Any], str]] = {
    "every expression": (
        lambda: gc.factor(superbracket("6-5")),
        "no expression of joins and meets of its points equals it: there are 41,164,200 ways to write one",
    ),
    "brackets left inside": (
        lambda: gc.factor(superbracket("4-4.4")),
        "they come down to 128 of 114 different extensors",
    ),
    "products were not tested": (
        lambda: gc.factor("[abc][ade][bdf][cef] + 2*[abd][ace][bcf][def]", rank=3),
        "no product of brackets and one expression of joins and meets, with its multidegree, equals it: there are",
    ),
    "each point once": (lambda: gc.factor(superbracket("6-6")), "left are (A v a) (B v b) (C v c)"),
    "each point once, with meets": (
        lambda: gc.factor(r"[[Aa, Bb, Cc, Dd, Ee, (pqr /\ stu)]]"),
        "((p v q v r) ^ (s v t v u)), of which 11 meets were tried",
    ),
    "not zero": (lambda: gc.shorten("[abc][def]", rank=3), "at least 1 term is needed: 1, since it is not zero"),
    "brackets": (lambda: gc.shorten(superbracket("6-4.1")), "1 of 210 brackets may divide it"),
    "sets of monomials": (lambda: gc.shorten(superbracket("4-4.5")), "none of the sets of 2 of 107"),
    "merging": (lambda: gc.shorten(superbracket("5-5.1")), "at least 426/77"),
    "parts": (lambda: gc.shorten("[abc][def] + [abg][dgh]", rank=3), "at least 2 terms are needed: 1, since"),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_what_is_not_there(name: str) -> None:
    answer, says = ANSWERS[name]
    (told,) = recomputed(data(answer()))
    assert says in told
    assert "; certain" in told or "; error below 1e-1" in told


def test_all_terms_of_the_general_platform_are_needed(tmp_path: Path) -> None:
    done = run(data(gc.shorten(superbracket("6-6"))), tmp_path)
    assert done.returncode == 0, done
    assert "recomputed, called 'at least 16 terms are needed' in the file" in done.stdout
    assert "at least 241/16; error below 1e-1" in done.stdout


# --- what there is is not absent --------------------------------------------------------------------------------------


def stated(equation: str, rank: int, **absence: Any) -> Data:
    """A file that states something of the right side of an equation."""
    file = data(gc.prove(equation, rank=rank))
    return {**file, "absences": [{"claim": "it is not there", "theorem": "claim", **absence}]}


FOUR_PLANES = "abc /\\ aef /\\ bdf /\\ cde == [abfc][acde][bdef] + [abfd][acbe][cdef]"
INSIDE = "[abc]*(ab /\\ cd /\\ ef) == [abc]*([acd][bef] - [bcd][aef])"


@pytest.mark.parametrize(
    ("equation", "rank", "insides"),
    [
        (FOUR_PLANES, 4, [[]]),
        ("ab /\\ cd /\\ ef == [acd][bef] - [bcd][aef]", 3, [[]]),
        (INSIDE, 3, [[], [["a", "b", "c"]]]),
    ],
)
def test_an_expression_that_exists_is_found(equation: str, rank: int, insides: list[list[list[str]]]) -> None:
    terms = gc.expand(equation.split("==")[1], rank=rank).degrees() or {}
    rest = dict(terms)
    if len(insides) > 1:
        rest = {x: n - (x in "abc") for x, n in terms.items() if n > (x in "abc")}
    searches = [
        {"inside": inside, "space": ways({x: rest.get(x, 0) + sum(x in row for row in inside) for x in terms}, rank)}
        for inside in insides
    ]
    file = stated(equation, rank, kind="no expression", irreducible=True, searches=searches)
    with pytest.raises(RECOMPUTE.NotSo):
        recomputed(file)


def test_a_product_of_brackets_is_an_expression() -> None:
    searches = [{"inside": [], "space": 0}, {"inside": [["a", "b", "c"]], "space": 2}]
    file = stated("[abc] == [abc]", 3, kind="no expression", irreducible=True, searches=searches)
    with pytest.raises(RECOMPUTE.NotSo, match="it is a product of brackets"):
        recomputed(file)


def test_a_product_that_exists_is_found() -> None:
    file = stated(
        "[(abc /\\ def) g h] == [bcgh][adef] - [acgh][bdef] + [abgh][cdef]", 4, kind="no product", atoms=["a"]
    )
    with pytest.raises(RECOMPUTE.NotSo, match="it is a product of expressions"):
        recomputed(file)


SHORTER = "[abf][cde] == [abc][def] - [abd][cef] + [abe][cdf]"
DEGREES = [[x, 1] for x in "abcdef"]


@pytest.mark.parametrize(
    ("least", "reason"),
    [
        (2, {"reason": "enumeration", "monomials": 10}),
        (3, {"reason": "enumeration", "monomials": 10}),
        (2, {"reason": "brackets", "brackets": []}),
        (2, {"reason": "brackets", "brackets": [["a", "b", "f"], ["c", "d", "e"]]}),
        (2, {"reason": "merging", "monomials": 10, "symmetries": [], "mergings": [["2", 1, []]]}),
        (2, {"reason": "merging", "monomials": 10, "symmetries": [], "mergings": [["1", 2, [["a", "c"]]]]}),
        (2, {"reason": "value"}),
    ],
)
def test_a_shorter_polynomial_that_exists_is_found(least: int, reason: Data) -> None:
    part = {"degrees": DEGREES, "least": least, **reason}
    file = stated(SHORTER, 3, kind="no shorter polynomial", least=least, parts=[part])
    with pytest.raises(RECOMPUTE.NotSo):
        recomputed(file)


PRIME = 2**127 - 1
MONOMIALS = {"reason": "merging", "monomials": 10, "symmetries": []}
ONE_TERM = "[abf][cde] == [abf][cde]"


def merged(least: int, blocks: list[list[str]], degrees: Any = DEGREES, **more: Any) -> Data:
    part = {"degrees": degrees, "least": least, **MONOMIALS, "mergings": [["1", least, blocks]], **more}
    needed = "at least 1 term is needed" if least == 1 else f"at least {least} terms are needed"
    return {"kind": "no shorter polynomial", "claim": needed, "least": least, "parts": [part]}


FALSE: dict[str, tuple[Data, str]] = {
    "points merged, and then not": (stated(ONE_TERM, 3, **merged(3, [[*"ab"], ["a"], ["b"]])), "blocks that overlap"),
    "blocks with a common point": (stated(ONE_TERM, 3, **merged(2, [["b", "a"], ["b", "f"]])), "blocks that overlap"),
    "a block of another point": (stated(ONE_TERM, 3, **merged(2, [["a", "z"]])), "blocks that overlap"),
    "zero has a term": (
        stated(
            "0 == [abc][ade] - [abd][ace] + [abe][acd]",
            3,
            **merged(1, [], [["a", 2], ["b", 1], ["c", 1], ["d", 1], ["e", 1]], monomials=3),
        ),
        "vanishes at a random position",
    ),
    "the number zero has a term": (stated("[aab] == 0", 3, **merged(1, [], [], monomials=1)), "it has 0 parts"),
    "a multiple of the prime": (
        stated(
            f"{PRIME}*[abc][def] == {PRIME}*[abc][def]",
            3,
            kind="no product",
            claim="no product of expressions of joins and meets, each point used once, equals it",
            atoms=[["join", *"abcdef"]],
        ),
        "it is a product of expressions",
    ),
    "more terms in words": (
        stated("[abc] == [abc]", 3, **{**merged(1, [], [[x, 1] for x in "abc"], monomials=1), "claim": "2 are needed"}),
        "another claim: at least 1 term is needed",
    ),
}


@pytest.mark.parametrize(("file", "says"), FALSE.values(), ids=FALSE)
def test_what_is_false_is_not_confirmed(file: Data, says: str, tmp_path: Path) -> None:
    done = run(file, tmp_path)
    assert done.returncode == 1, done
    assert says in done.stdout
    assert "recomputed, called" not in done.stdout


@pytest.mark.parametrize("name", ["x", "a"])
def test_a_definition_is_no_point(name: str, tmp_path: Path) -> None:
    """[xbc] - [abc], where x is another name of a, is zero."""
    file = data(gc.prove("[xbc] - [abc] == [xbc] - [abc]", rank=3))
    (theorem,) = file["theorems"]
    theorem["definitions"].append([name, "c" if name == "a" else "a"])
    theorem["points"] = ["a", "b", "c"]
    parts = [{"degrees": [["b", 1], ["c", 1], [x, 1]], "least": 1, "reason": "value"} for x in "xa"]
    absence = {"kind": "no shorter polynomial", "claim": "at least 2 terms are needed", "theorem": "claim"}
    done = run({**file, "absences": [{**absence, "least": 2, "parts": parts}]}, tmp_path)
    assert done.returncode == 2
    assert "no bracket of points" in done.stderr


def test_the_polynomial_is_printed(tmp_path: Path) -> None:
    file = data(gc.shorten("1/2*[abc][def] - 3*[abd][cef]", rank=3))
    done = run(file, tmp_path)
    assert done.returncode == 0, done
    assert "\n  of +1/2 [a b c] [d e f] -3 [a b d] [c e f] (rank 3)\n" in done.stdout
    (theorem,) = file["theorems"]
    named = {**theorem, "points": [*theorem["points"], "x]\nrecomputed"]}
    done = run({**file, "theorems": [named]}, tmp_path)
    assert done.returncode == 2
    assert "names are none" in done.stderr


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ('"least": 1', '"least": 1.0'),
        ('"least": 1', '"least": NaN'),
        ('"least": 1', '"least": 2, "least": 1'),
        ('"rank": 3', '"rank": 4, "rank": 3'),
    ],
)
def test_numbers_are_whole_and_names_occur_once(before: str, after: str, tmp_path: Path) -> None:
    text = json.dumps(data(gc.shorten("[abc][def]", rank=3)))
    assert before in text
    path = tmp_path / "proof.json"
    path.write_text(text.replace(before, after), encoding="utf-8")
    done = subprocess.run([sys.executable, PROGRAM, path], capture_output=True, text=True, check=False)
    assert done.returncode == 2, done
    assert "a name twice, or no number" in done.stderr


# --- changed ----------------------------------------------------------------------------------------------------------

CHANGES: list[tuple[str, str, Callable[[Data], object]]] = [
    ("brackets left inside", "brackets that divide", lambda a: a["searches"].pop()),
    ("brackets left inside", "ways to write", lambda a: a["searches"][0].update(space=a["searches"][0]["space"] + 1)),
    ("every expression", "other", lambda a: a["searches"][0].update(inside=[["A", "B", "C", "D"]])),
    ("each point once", "are left", lambda a: a["atoms"].pop()),
    ("each point once", "are left", lambda a: a["atoms"].__setitem__(0, ["join", "A", "b"])),
    ("brackets", "other brackets divide", lambda a: a["parts"][0].update(brackets=[])),
    ("brackets", "two terms", lambda a: (a.update(least=3), a["parts"][0].update(least=3))),
    ("sets of monomials", "there are 107 bracket monomials", lambda a: a["parts"][0].update(monomials=108)),
    ("sets of monomials", "add up to it", lambda a: (a.update(least=4), a["parts"][0].update(least=4))),
    ("sets of monomials", "another number", lambda a: a.update(least=4)),
    ("merging", "there are 770 bracket monomials", lambda a: a["parts"][0].update(monomials=769)),
    ("merging", "add up to more than 1", lambda a: a["parts"][0]["mergings"][0].__setitem__(0, "1")),
    ("merging", "is no symmetry", lambda a: a["parts"][0]["symmetries"][0].__setitem__(1, [["A", "B"], ["B", "A"]])),
    ("merging", "is no symmetry", lambda a: [one.__setitem__(0, -one[0]) for one in a["parts"][0]["symmetries"]]),
    ("merging", "add up to more than 1", lambda a: a["parts"][0].update(symmetries=[])),
    ("merging", "prove that", lambda a: a["parts"][0]["mergings"].pop()),
    ("merging", "bracket monomials add up", lambda a: [m.__setitem__(1, m[1] + 1) for m in a["parts"][0]["mergings"]]),
    ("parts", "it has 2 parts", lambda a: a["parts"].pop()),
]


@pytest.mark.parametrize(("name", "says", "change"), CHANGES)
def test_what_is_changed_is_refused(name: str, says: str, change: Callable[[Data], object], tmp_path: Path) -> None:
    file = data(ANSWERS[name][0]())
    change(file["absences"][0])
    done = run(file, tmp_path)
    assert done.returncode == 1, done
    assert "NOT SO, called" in done.stdout
    assert says in done.stdout


def test_what_is_too_large_is_not_confirmed(tmp_path: Path) -> None:
    done = run(data(gc.shorten(superbracket("5-5.1"))), tmp_path, "--most", "1000")
    assert done.returncode == 3
    assert "NOT RECOMPUTED" in done.stdout
    assert "it takes more than 1,000 steps" in done.stdout


def test_a_file_without_absences_is_none(tmp_path: Path) -> None:
    done = run(data(gc.prove("[abc] == [bca]", rank=3)), tmp_path)
    assert done.returncode == 2
    assert "it states no absence" in done.stderr
    for options in ([], [tmp_path / "proof.json", "--most", "many"]):
        assert subprocess.run([sys.executable, PROGRAM, *options], capture_output=True, check=False).returncode == 2


# --- what is not stated -----------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("answer", "says"),
    [
        (lambda: gc.factor("[[Aa,Ab,Bc,Cd,De,Ef]]", ideal="A"), "with points at infinity it is not recomputed"),
        (
            lambda: gc.shorten("[aij][bck] - [aik][bcj]", rank=3, ideal="i j k"),
            "not recomputed with points at infinity",
        ),
        (lambda: gc.factor("[[Aa,Ab,Bc,Bd,Ca,Dc]]", cofactor=True), "a search says so, which is not recomputed"),
    ],
)
def test_what_is_not_stated_is_left_out(answer: Callable[[], Any], says: str) -> None:
    assert any(says in one.reason for one in gc.proof_file(answer()).left_out)


def test_an_absence_without_its_theorem_is_left_out() -> None:
    found = gc.factor("[[Aa,Ab,Bc,Cd,De,Ef]]")
    assert gc.proof_file(found).left_out == ()
    assert not any(isinstance(one, LeftOut) for one in gc.proof_file(found).absences)
