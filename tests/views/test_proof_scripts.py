"""Theorems as scripts of Coq and Lean; Coq replays them where it is there."""

import re
import subprocess
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from places import EXAMPLES

import gcrules as gc
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse_equation
from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.algebra.proofs.proving import theorem
from gcrules.algebra.proofs.theorem import Theorem
from gcrules.core.errors import InputError
from gcrules.mechanisms.proofs import proof_file
from gcrules.rules.script import run_script
from gcrules.views.proofs import coq, lean

OCTAHEDRON = r"[[ab,af,cb,cd,ed,ef]] == (ace /\ abf /\ cbd /\ edf)"


def coq_script(theorems: Sequence[Theorem], title: str) -> str:
    return coq.script(ProofFile(title, tuple(theorems)))


def proved(name: str, equation: str, rank: int = 4, ideal: tuple[str, ...] = ()) -> Theorem:
    return theorem(name, *parse_equation(equation, rank=rank), rank=rank, ideal=ideal)


def theorems() -> list[Theorem]:
    (steiner,) = of_example(EXAMPLES / "theorems" / "steiner.gca")  # up to a multiple of what is given
    return [
        proved("octahedral", OCTAHEDRON),
        proved("a line in a plane", r"ab /\ cde == [acde] * b - [bcde] * a"),
        proved("with halves", r"(1/2) * [abc] * [ade] == (1/2) * [abd] * [ace] - (1/2) * [abe] * [acd]", rank=3),
        proved("at infinity", r"ij /\ kab == [ikab] * j - [jkab] * i", ideal=("i", "j")),
        replace(steiner, name="steiner"),
    ]


def assumed(claim: str, given: str, name: str, **options: Any) -> Theorem:
    (found,) = gc.proof_file(gc.prove(claim, given=given, **options)).theorems
    return replace(found, name=name)


def on_one_line() -> Theorem:
    return assumed("[acd] == 0", "collinear(a, b, c), collinear(a, b, d)", "on one line", rank=3)


def of_example(path: Path) -> tuple[Theorem, ...]:
    return proof_file(run_script(parse_script(path.read_text(encoding="utf-8"), path.name))).theorems


def example(name: str) -> list[Theorem]:
    """The theorems of a file in examples/theorems that hold under assumptions."""
    found = of_example(EXAMPLES / "theorems" / f"{name}.gca")
    return [replace(t, name=f"{name} {n}") for n, t in enumerate(found) if t.given]


def without_proofs_of_coordinates(script: str) -> str:
    """A script that takes what its library says of coordinates for granted, so that Coq reads it in little time."""
    start, end = script.index("(* ---- determinants *)"), script.index("(* ---- brackets by the numbers")
    placing, field = script.index("Section Placing."), script.index("(* ---- a field *)")
    parts = [script[start:placing], script[placing:field], script[field:end]]
    for i in (0, 2):
        parts[i] = re.sub(r"Proof\..*?Qed\.", "Admitted.", parts[i], flags=re.DOTALL)
    return "".join([script[:start], *parts, script[end:]])


def statement(script: str, name: str) -> str:
    return re.search(rf"Theorem {name} : (.*?)Proof\.", script, re.DOTALL)[1]


def run(script: str, folder: Path) -> subprocess.CompletedProcess[str]:
    file = folder / "theorems.v"
    file.write_text(script, encoding="utf-8")
    return subprocess.run(["coqc", file.name], cwd=folder, capture_output=True, text=True, check=False)


def replayed(theorems: Sequence[Theorem], title: str, folder: Path) -> None:
    """Sees that Coq accepts the script of some theorems."""
    script = without_proofs_of_coordinates(coq_script(theorems, title))
    done = run(script[: script.index("Print Assumptions")], folder)
    assert done.returncode == 0, done.stderr


def refused(script: str, theorem: str, folder: Path) -> None:
    """Sees that Coq refuses a script behind the beginning of a theorem."""
    done = run(script, folder)
    assert done.returncode != 0
    line = int(re.search(r'File "./theorems.v", line ([0-9]+)', done.stderr)[1])
    assert line > script[: script.index(theorem)].count("\n"), done.stderr


def refused_otherwise(
    theorems: Sequence[Theorem], title: str, theorem: str, said: str, instead: str, folder: Path
) -> None:
    """Sees that Coq refuses a theorem that says something else in one place."""
    script = without_proofs_of_coordinates(coq_script(theorems, title))
    start = script.index(theorem)
    assert said in script[start:]
    refused(script[:start] + script[start:].replace(said, instead, 1), theorem, folder)


def test_statements_are_read_as_they_were_written() -> None:
    script = coq_script(theorems(), "Five theorems")
    assert script.startswith("(* Five theorems *)")
    assert "superbracket (a ∨ b) (a ∨ f) (c ∨ b) (c ∨ d) (e ∨ d) (e ∨ f)" in statement(script, "octahedral")
    assert "infinite space i ->\n  infinite space j ->" in statement(script, "at_infinity")
    assert "multiplied by 2" in script
    assert "/" not in statement(script, "with_halves")
    assert "Axiom" not in script
    assert "Admitted" not in script


def test_names_that_coq_cannot_have_are_others() -> None:
    script = coq_script([proved("forall", "[abcd] == [cdab]"), proved("forall", "[abcd] == [cdab]")], "(* x *)")
    assert "Theorem forall_2 :" in script
    assert "Theorem forall_3 :" in script
    assert script.startswith("(* ( * x * ) *)")


def in_other_ranks() -> list[Theorem]:
    return [
        proved("on a line", "[ab] * [cd] - [ac] * [bd] + [ad] * [bc] == 0", rank=2),
        proved("one line", "[[ab]] == [ab]", rank=2),
        *of_example(EXAMPLES / "theorems" / "relations-5.gca"),
        proved("a meet", r"abc /\ defg == [adefg] bc - [bdefg] ac + [cdefg] ab", rank=5),
        proved("at infinity", "[ijklm] == 0", rank=5, ideal=tuple("ijklm")),
        proved("in rank six", r"ab /\ cdefg == [acdefg] * b - [bcdefg] * a", rank=6),
    ]


def test_other_ranks_have_extensors_of_their_own() -> None:
    script = coq_script(in_other_ranks(), "Other ranks")
    assert "Definition rank_5 : geometry := of_rank 4 ltac:(discriminate).\n" in script
    assert script.count(" : geometry := of_rank ") == 3
    assert "(bracket (a ∨ b))" in statement(script, "one_line")
    assert "infinite rank_5 i ->" in statement(script, "at_infinity")
    assert "lifted" not in coq_script(theorems(), "In the plane and in space")


def test_theorems_under_assumptions_in_other_ranks_are_refused() -> None:
    (found,) = gc.proof_file(gc.prove("[ab] == 0", given="[ac] == 0, [bc] == 0", rank=2)).theorems
    with pytest.raises(InputError, match="under assumptions in rank 2"):
        coq_script([found], "On a line")


def test_names_of_the_library_are_not_those_of_theorems() -> None:
    names = ["super", "rank", "term", "replay_sound"]
    script = coq_script([proved(n, "[abcd] == [cdab]") for n in names], "Names")
    assert [f"Theorem {n}_2 :" in script for n in names] == [True] * 4


def alike() -> list[Theorem]:
    """Theorems called like what belongs to others, like points, and like what scripts use."""
    names = ["a", "a left", "a relations", "a relations 0", "row 0 1 2 3", "row", "nat", "list", "by", "eq", "part 1"]
    plain = [proved(n, "[abcd] == [cdab]") for n in names]
    return [*plain, *(replace(on_one_line(), name=n) for n in ("a case 0", "a case 0 left", "d"))]


def test_names_of_theorems_are_not_those_of_what_belongs_to_others() -> None:
    script = coq_script(alike(), "Names that are alike")
    names = re.findall(r"^(?:Definition|Theorem) (\w+)", script, re.MULTILINE)
    assert len(set(names)) == len(names)
    assert {"a", "a_left", "a__left", "a_left__left", "a_case_0_left", "a_case_0__case_0__left"} <= {*names}
    assert {"nat", "list", "by"}.isdisjoint(names)


def test_assumptions_are_hypotheses_of_the_theorem() -> None:
    script = coq_script([on_one_line()], "On one line")
    assert statement(script, "on_one_line").split("\n") == [
        "forall a b c d : vector plane,",
        "  (bracket (a ∨ b ∨ c)) = number plane 0 ->",
        "  (bracket (a ∨ b ∨ d)) = number plane 0 ->",
        "  (a ∨ b) <> number plane 0 ->",
        "  (bracket (a ∨ c ∨ d))",
        "  = (number plane (0)).",
        "",
    ]
    assert "Axiom" not in script
    assert "Admitted" not in script
    assert "Hypothesis decided" not in coq_script(theorems(), "Without assumptions")


def test_dependent_points_are_placed_in_all_ways() -> None:
    (pappus,) = example("pappus")
    script = coq_script([pappus], "Pappus")
    assert script.count("refine (replay_placed plane (fun place => nth place [a; c;") == 3
    assert script.count("refine (replay_placed ") == 9
    assert " <> " not in statement(script, pappus.name.replace(" ", "_"))


def test_theorems_of_the_examples_have_scripts() -> None:
    for path in sorted((EXAMPLES / "theorems").glob("*.gca")):
        if path.stem not in ("double-six", "feuerbach"):  # which take minutes, and are not in a script
            assert coq.without_script(ProofFile(path.stem, of_example(path))) == {}


def test_auxiliary_points_are_meets_that_the_proof_names_and_the_theorem_does_not() -> None:
    script = coq_script(example("simson"), "Simson")
    assert statement(script, "simson_0").startswith("forall i j c d a b : vector plane,\n  infinite plane i ->\n")
    proof = script[script.index("Theorem simson_0") :]
    assert proof.count("destruct (plane_is_point _ ") == 3
    assert proof.count("follows_sound plane h_at 2 9") > 3
    assert re.search(r"\(Number \(0\)\) \[\] h_ideal", proof), "a point lies on a side of its own hexagon"
    assert "[exchange_of row__" in proof, "the equation of the conic up to exchange relations"


def test_lean_has_the_relations_as_hypotheses() -> None:
    exchange = proved("exchange", "[abc] * [ade] - [abd] * [ace] + [abe] * [acd] == 0", rank=3)
    text = lean.script(ProofFile("Exchange", (exchange,)))
    assert "not checked" in text
    assert "linear_combination" in text
    assert text.count("theorem ") == 1


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_without_axioms(tmp_path: Path) -> None:
    done = run(coq_script(theorems(), "Five theorems"), tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("Closed under the global context") == 5


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_whose_names_are_alike(tmp_path: Path) -> None:
    replayed(alike(), "Names that are alike", tmp_path)


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_in_other_ranks_without_axioms(tmp_path: Path) -> None:
    script = coq_script(found := in_other_ranks(), "Other ranks")
    done = run(script, tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("Closed under the global context") == len(found) == 8


@pytest.mark.needs("coqc")
def test_coq_refuses_a_claim_in_rank_5_with_another_sign(tmp_path: Path) -> None:
    script = coq_script([proved("a meet", r"abc /\ defg == [adefg] bc - [bdefg] ac + [cdefg] ab", rank=5)], "A meet")
    start, end = script.index("(* ---- determinants *)"), script.index("(* ---- brackets by the numbers")
    script = script[:start] + re.sub(r"Proof\..*?Qed\.", "Admitted.", script[start:end], flags=re.DOTALL) + script[end:]
    assert run(script, tmp_path).returncode == 0
    wrong = script.replace("(number rank_5 (-1))", "(number rank_5 (1))").replace("(Number (-1))", "(Number (1))")
    assert wrong != script
    done = run(wrong, tmp_path)
    assert done.returncode != 0
    assert int(re.search(r'File "./theorems.v", line ([0-9]+)', done.stderr)[1]) > script[
        : script.index("Theorem a_meet")
    ].count("\n")


@pytest.mark.needs("coqc")
def test_coq_refuses_a_claim_with_another_sign(tmp_path: Path) -> None:
    script = coq_script([proved("octahedral", OCTAHEDRON)], "Octahedron")
    sides = re.search(r"Definition octahedral__right := (.*)\.\n", script)[1]
    wrong = script.replace(sides, f"(Join (Number (-1)) {sides})").replace("\n  = ((", "\n  = ((number space (-1)) · (")
    done = run(wrong, tmp_path)
    assert done.returncode != 0
    assert "theorems.v" in done.stderr
    assert "Closed" not in done.stdout


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_under_assumptions_without_axioms(tmp_path: Path) -> None:
    names = ["pappus", "midpoints", "desargues-space", "desargues-space-converse", "pencil", "pencil-converse"]
    on_conics = ["simson", "circumcentre", "involution"]
    found = [on_one_line(), *(t for name in (*names, *on_conics) for t in example(name))]
    done = run(coq_script(found, "Under assumptions"), tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.count("Closed under the global context") == len(found) == 11


def in_cases() -> list[Theorem]:
    """With factors that occur again, cases in cases, a factor that does not vanish, and in space."""
    line = "collinear(c, d, e), incident(a, be), [bed][bac] == -[bea][bdc]"
    squares = assumed("[abc][abd] == 0", "[abc]**2 [abd]**3 == 0", "squares", rank=3)
    product, first, second = squares.cases
    return [
        squares,
        replace(squares, name="one factor", nonzero=second.given[-1:], cases=(product, first)),
        assumed("[abc][abd][cde] == 0", "[abc][ade] == 0, [abd][ace] == 0", "twice", rank=3),
        assumed("[bde][bcd] == 0", "collinear(a, b, d), [bcd][abe] == [abd][bce]", "a factor", rank=3),
        assumed("[abd] == 0", line, "three lines", rank=3),
        assumed("[acde] == 0", "[abde][bcde] == 0, coplanar(a, b, c, d)", "in space"),
        assumed("[abdf] == 0", r"abf /\ adf == 0", "planes"),
        assumed("[abcf] == 0", r"acd /\ bcf /\ def == 0, [abef][acde] == 0", "three planes"),
    ]


def test_cases_are_theorems_of_their_own() -> None:
    script = coq_script(in_cases(), "In cases")
    assert "Theorem squares__part_0 :" in script
    assert "Theorem twice__part_2__part_2 :" in script
    assert "Theorem squares__part_3 :" not in script
    assert script.count("exfalso. exact (h_nonzero_0 h_") == 4
    assert " as [h_split|h_split]." in script


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_whose_meets_stand_in_two_sequences(tmp_path: Path) -> None:
    """That these are the same up to a number takes exchanges of points, and of those that close an extensor."""
    on_a_line = r"collinear(a, b, x), incident(y, (x \/ de) /\ (x \/ gh))"
    meets = [
        assumed("[efd] == 0", r"incident(e, fd /\ ab)", "in the plane", rank=3),
        assumed(r"collinear(x, y, de /\ (x \/ gh))", on_a_line, "in space"),
    ]
    replayed(meets, "Meets", tmp_path)


MEETING = r"f \/ (be /\ dac) == 0, [fbed] + [fbda] + 2 [fedc] == 0"


def with_sums() -> list[Theorem]:
    """Points that are said to be equal to an expression, and those on lines and planes through sums."""
    return [
        assumed("[pab] == 0", r"p == ab /\ cd", "a meet", rank=3),
        assumed("[apq] == 0", "p == [abc] d - 2 [abd] c, q == p + a", "sums", rank=3),
        assumed("p == a + b", "p == a + b, incident(q, cp)", "the point itself", rank=3),
        assumed("[abcq] == 0", "incident(p, ab), q == p - c", "in space"),
        assumed("[abd] == -2 [cbd]", "collinear(d, b, 2 c + a)", "a line through a sum", rank=3),
        assumed("[abcp] == 3 [abdp]", "coplanar(p, a, b, c - 3 d)", "a plane through a sum"),
        assumed("[abc] == [abd]", "[abc] == [abd]", "a line that is a sum", rank=3),
        assumed("[abcd] == [abce]", "[abcd] == [abce]", "a plane that is a sum"),
        assumed("[abef] == 0", MEETING, "a meet with a sum"),
    ]


def of_screws() -> list[Theorem]:
    """Screws that are reciprocal to a line, to a screw, and two of them; one claim is of the second degree."""
    letters = {"letters": "screw S T"}
    return [
        assumed(r"collinear(a, b, S /\ abc)", r"S \/ ab == 0", "a line", **letters),
        assumed(r"T \/ ac == 0", r"S \/ T == 0, T \/ ab == 0, collinear(a, b, c)", "points on the line", **letters),
        assumed("[[S, T, ab, ac, ad, bc]] == 0", r"S \/ ab == 0, T \/ ab == 0", "two screws", **letters),
        assumed(r"S /\ T == 0", r"T \/ S == 0", "screws of each other", **letters),
        assumed(r"coplanar(a, b, S /\ acd, S /\ abe)", r"S \/ ab == 0", "twice", **letters),
    ]


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_about_screws(tmp_path: Path) -> None:
    replayed(of_screws(), "Screws", tmp_path)


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [
        ("(bracket (a ∨ b ∨ ", "(bracket (a ∨ c ∨ "),
        ("(a ∨ b) <> number space 0 ->", "(a ∨ c) <> number space 0 ->"),
        ("= (number space (0))", "= (a ∨ b ∨ c)"),
    ],
    ids=["another line", "what may vanish is another", "another claim"],
)
def test_coq_refuses_a_theorem_about_another_screw(said: str, instead: str, tmp_path: Path) -> None:
    refused_otherwise(of_screws()[:1], "Screws", "Theorem a_line :", said, instead, tmp_path)


def test_a_point_that_is_equal_to_an_expression_is_written_as_that() -> None:
    script = coq_script(with_sums()[:1], "A meet")
    assert "(p + ((number plane (-1)) · ((a ∨ b) ∧ (c ∨ d)))) = number plane 0 ->" in script
    assert "refine (equal_to plane _ _ h_1 _ _ _)." in script


def with_fractions() -> list[Theorem]:
    """Points that are placed by a half or a third of something, on which the claim depends in unlike degrees."""
    middles = "x == 1/2 b + 1/2 c, y == 1/2 a + 1/2 c"
    return [
        assumed("[apc] == 1/2 [abc]", "p == 1/2 a + 1/2 b", "the middle", rank=3),
        assumed("[pab] == 0", r"2 p == ab /\ cd", "half a meet", rank=3),
        assumed(r"[axg] == 0", f"{middles}, g == 1/3 a + 1/3 b + 1/3 c", "a third", rank=3),
        assumed(r"ax /\ by /\ cz == 0", f"{middles}, z == 1/2 a + 1/2 b", "three medians", rank=3),
        assumed("[pcde] == 1/2 [acde] + 1/2 [bcde]", "p == 1/2 a + 1/2 b", "in space"),
    ]


def test_numbers_by_which_a_proof_divides_are_said_not_to_vanish() -> None:
    script = coq_script(with_fractions(), "Fractions")
    assert statement(script, "the_middle").split("\n")[1:3] == [
        "  (a + b + ((number plane (-2)) · p)) = number plane 0 ->",
        "  (number plane (2)) <> number plane 0 ->",
    ]
    assert "(number plane (6)) <> number plane 0 ->" in statement(script, "a_third")
    assert " <> " not in statement(coq_script(with_sums()[:1], "A meet"), "a_meet")


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_with_fractions(tmp_path: Path) -> None:
    replayed(with_fractions(), "Fractions", tmp_path)


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [
        ("(number plane (-2)) · p", "(number plane (-3)) · p"),
        ("(number plane (2)) <> number plane 0 ->", "(number plane (1)) <> number plane 0 ->"),
        ("((number plane (2)) · (bracket (a ∨ p ∨ c)))", "(bracket (a ∨ p ∨ c))"),
    ],
    ids=["a third of it", "in a field where 2 may vanish", "another claim"],
)
def test_coq_refuses_a_theorem_with_another_fraction(said: str, instead: str, tmp_path: Path) -> None:
    refused_otherwise(with_fractions()[:1], "Fractions", "Theorem the_middle :", said, instead, tmp_path)


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_with_sums(tmp_path: Path) -> None:
    replayed(with_sums(), "Sums", tmp_path)


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [("(number plane (-1)) · ((a", "(number plane (1)) · ((b"), ("= (number plane (0))", "= (number plane (1))")],
    ids=["another assumption", "another claim"],
)
def test_coq_refuses_a_point_that_is_equal_to_another_expression(said: str, instead: str, tmp_path: Path) -> None:
    script = without_proofs_of_coordinates(coq_script(with_sums()[:1], "A meet"))
    start, end = script.index("Theorem a_meet"), script.index("Proof.", script.index("Theorem a_meet"))
    assert said in script[start:end]
    refused(script[:start] + script[start:end].replace(said, instead) + script[end:], "Theorem a_meet", tmp_path)


def for_all_points() -> list[Theorem]:
    """Of which an assumption holds for all points: a factor that names them, two of these, and none that is used."""
    planes = "incident(bd, fec), incident(g, fec), incident(fd, bac), incident(e, bac)"
    return [
        assumed("[abce][abdf] == 0", "concurrent(bf, ae, ab)", "all"),
        assumed("[acde][abde] == 0", "concurrent(ab, ac, de)", "not zero"),
        assumed("[fbac][eadb] == 0", "concurrent(bg, ca, be)", "another line"),
        assumed("[gfab][fcge] == 0", f"{planes}, concurrent(bf, de, fa)", "with planes"),
    ]


ON_BF = "(forall any1 : vector space, (((a ∨ b) ∧ (a ∨ e ∨ any1)) ∨ b ∨ f)"


def test_what_holds_for_all_points_is_a_hypothesis_for_all_points() -> None:
    script = coq_script(for_all_points(), "For all points")
    said = statement(script, "all").split("\n")
    assert said[0] == "forall a b c d e f : vector space,"
    assert "  (forall any1 : vector space, (((a ∨ b) ∧ (a ∨ e ∨ any1)) ∨ b ∨ f) = number space 0) ->" in said
    assert said[-3:-1] == ["  ((bracket (a ∨ b ∨ c ∨ e)) · (bracket (a ∨ b ∨ d ∨ f)))", "  = (number space (0))."]
    assert "for_all_sound space h_at 0 6 1" in script


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_on_what_holds_for_all_points(tmp_path: Path) -> None:
    replayed(for_all_points(), "For all points", tmp_path)


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [
        (
            "(forall any1 : vector space, (((a ∨ b) ∧ (a ∨ e ∨ any1)) ∨ b ∨ f)",
            ON_BF.replace("a ∨ e", "c ∨ d").replace("b ∨ f", "c ∨ d"),
        ),
        (ON_BF, "((((a ∨ b) ∧ (a ∨ e ∨ d)) ∨ b ∨ f)"),
        ("((bracket (a ∨ b ∨ c ∨ e)) · (bracket (a ∨ b ∨ d ∨ f)))\n", "(bracket (a ∨ b ∨ c ∨ e))\n"),
    ],
    ids=["another assumption", "for one point", "another claim"],
)
def test_coq_refuses_a_theorem_on_what_holds_for_fewer_points(said: str, instead: str, tmp_path: Path) -> None:
    refused_otherwise(for_all_points()[:1], "For all points", "Theorem all :", said, instead, tmp_path)


def test_cases_of_several_equations_have_no_script() -> None:
    given = "[dbf][cbf] == [eca][bde], incident(e, ca), collinear(a, d, f)"
    found = ProofFile("Sum", (assumed("[bcf][bdf] == 0", given, "sum", rank=3),))
    assert coq.without_script(found) == {"sum": "it is proved in cases that come of several equations"}


@pytest.mark.needs("coqc")
def test_coq_replays_theorems_in_cases(tmp_path: Path) -> None:
    replayed(in_cases(), "In cases", tmp_path)


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [
        (
            "(bracket (a ∨ b ∨ d)) 3)) = number plane 0 ->",
            "(bracket (a ∨ c ∨ d)) 3)) = number plane 0 ->",
        ),
        ("((bracket (a ∨ b ∨ c)) · (bracket (a ∨ b ∨ d)))\n", "(bracket (a ∨ b ∨ c))\n"),
    ],
    ids=["another assumption", "another claim"],
)
def test_coq_refuses_a_theorem_in_cases_that_are_of_another(said: str, instead: str, tmp_path: Path) -> None:
    refused_otherwise(in_cases()[:1], "In cases", "Theorem squares :", said, instead, tmp_path)


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [
        ("", ""),
        ("(number plane (-1)) · (bracket (i ∨ j ∨ d))", "(number plane (1)) · (bracket (i ∨ j ∨ d))"),
        ("\n  (j ∨ ((j ∨ c) ∧ (a ∨ b))) <> number plane 0 ->", "\n  (j ∨ c) <> number plane 0 ->"),
        ("((bracket (b ∨ c ∨ j)) · i)", "((number plane (-1)) · (bracket (b ∨ c ∨ j)) · i)"),
    ],
    ids=["as it is", "another sign in what is given", "what may vanish is another", "another sign in the claim"],
)
def test_coq_refuses_a_theorem_on_a_circle_with_another_sign(said: str, instead: str, tmp_path: Path) -> None:
    script = without_proofs_of_coordinates(coq_script(example("simson"), "Simson"))
    start, end = script.index("Theorem simson_0"), script.index("Proof.", script.index("Theorem simson_0"))
    assert said in script[start:end]
    done = run(script[:start] + script[start:end].replace(said, instead) + script[end:] if said else script, tmp_path)
    if not said:
        assert done.returncode == 0, done.stderr
        return
    assert done.returncode != 0
    line = int(re.search(r'File "./theorems.v", line ([0-9]+)', done.stderr)[1])
    assert line > script[:start].count("\n"), done.stderr


@pytest.mark.needs("coqc")
@pytest.mark.parametrize(
    ("said", "instead"),
    [
        ("", ""),
        ("(bracket (a ∨ b ∨ c)) = number plane 0 ->", "number plane 0 = number plane 0 ->"),
        ("(bracket (a ∨ b ∨ d)) = number plane 0 ->", "(bracket (a ∨ b ∨ c)) = number plane 0 ->"),
        ("(a ∨ b) <> number plane 0 ->", "(a ∨ c) <> number plane 0 ->"),
        ("= (number plane (0)).", "= (number plane (1))."),
    ],
    ids=["as it is", "an assumption less", "another assumption", "what may vanish is another", "another claim"],
)
def test_coq_refuses_a_theorem_of_which_an_assumption_or_the_claim_is_another(
    said: str, instead: str, tmp_path: Path
) -> None:
    script = without_proofs_of_coordinates(coq_script([on_one_line()], "On one line"))
    assert said in script
    done = run(script.replace(f"  {said}\n", f"  {instead}\n") if said else script, tmp_path)
    if not said:
        assert done.returncode == 0, done.stderr
        return
    assert done.returncode != 0
    line = int(re.search(r'File "./theorems.v", line ([0-9]+)', done.stderr)[1])
    assert line > script[: script.index("Theorem on_one_line")].count("\n"), done.stderr
