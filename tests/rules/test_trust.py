"""What comes from outside is proved before it becomes an answer."""

from __future__ import annotations

import json
import shlex
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from commands import invoke
from rules.attacks import ATTACKS, EACH_ATTACK, LEGS, MERSENNE

import gcrules as gc
from gcrules.algebra.expr import Expr, Point
from gcrules.algebra.language.legs_text import read_legs
from gcrules.algebra.parts import substitute
from gcrules.algebra.prove import Proof, prove
from gcrules.conditions.catalog_check import check_digests, check_entry
from gcrules.conditions.manual.file import load_session
from gcrules.conditions.manual.session import ManualSession
from gcrules.core import proof_memory
from gcrules.core.errors import FileError, InputError, LimitReached
from gcrules.mechanisms.analyze import analyze_robot
from gcrules.mechanisms.description.robot_file import parse_robot
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.rules import rule_file
from gcrules.rules.catalog import proof_status as catalog_proofs
from gcrules.rules.catalog.file import load, load_file
from gcrules.rules.plugins import load_rules
from gcrules.rules.rule import ConditionRule

STATEMENT = "Singular exactly when the attacker says so."


SEEN: dict[str, Expr] = {}  # the labels of the class that stand for those of the legs, where they differ


def entry(expression: Expr) -> str:
    """A catalog with one class and this condition."""
    seen = substitute(expression, dict(SEEN))
    condition = {"kind": "one-incidence", "expression": str(seen), "statement": STATEMENT}
    return f"classes:\n  - id: mine-1\n    legs: {LEGS}\n    condition: {json.dumps(condition)}\n"


@pytest.fixture
def own(tmp_path: Path) -> Any:
    def write(text: str, name: str = "mine.yaml") -> Path:
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    return write


# --- catalogs ------------------------------------------------------------------------------------------------------


@EACH_ATTACK
def test_a_false_entry_is_refused_with_place_and_points(own: Any, false: Expr) -> None:
    path = own(entry(false))
    done = invoke("analyze", "--catalog", str(path), LEGS)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert f"{path}:4:" in done.stderr
    assert "is not an identity: it fails at" in done.stderr
    assert f"gcrules catalog check --catalog {shlex.quote(str(path))}" in done.stderr
    with pytest.raises(FileError):
        gc.analyze(LEGS.replace("i", "z"), catalogs=[path])
    assert not any(check_entry(e).ok for e in load_file(path).entries)


@EACH_ATTACK
def test_a_false_entry_is_refused_without_a_proof_too(own: Any, false: Expr, monkeypatch: pytest.MonkeyPatch) -> None:
    _without_proofs(monkeypatch)
    with pytest.raises(FileError, match="is not an identity"):
        gc.analyze(LEGS, catalogs=[own(entry(false))])


def _without_proofs(monkeypatch: pytest.MonkeyPatch) -> None:
    """Normal forms that do not end within the limit."""

    def undecided(left: Expr, right: Expr, **_: Any) -> Proof:
        return Proof(left, right, "undecided", "random-points", "more than 10 terms")

    monkeypatch.setattr(catalog_proofs, "prove", undecided)


def test_a_true_entry_without_a_proof_says_who_claims_it(own: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    _without_proofs(monkeypatch)
    path = own(entry(read_legs(LEGS).superbracket))
    found = next(c for c in _conditions(path) if c.statement == STATEMENT)
    detail = found.certificate.detail
    assert found.certificate.method == "random-points"
    assert detail.startswith(
        f"claimed by {path}, class mine-1; unproved; holds at 3 exact random points, error below 1e-"
    )
    assert "more than 10 terms" in detail


def _conditions(path: Path) -> list[gc.Condition]:
    a = gc.analyze(LEGS, catalogs=[path])
    return [a.condition, *a.readings]


def test_a_true_entry_is_proved_and_its_words_are_marked(own: Any) -> None:
    path = own(entry(read_legs(LEGS).superbracket))
    a = gc.analyze(LEGS, catalogs=[path])
    found = next(c for c in (a.condition, *a.readings) if c.statement == STATEMENT)
    assert found.certificate.method == "catalog-instance"
    assert f"class mine-1 of {path}, proved: both sides have the same normal form" in found.certificate.detail
    marked = f"In the words of {path}, class mine-1: {STATEMENT}"
    assert found.sentence == marked
    assert found.to_json()["statement"] == STATEMENT
    assert found.to_json()["statement_source"] == f"{path}, class mine-1"
    assert a.condition is found
    assert a.match is not None
    assert {n: Point(m) for n, m in a.match.mapping.items() if n != m} == SEEN
    flat = " ".join(a.text().split())
    assert flat.count(f"{STATEMENT}") == flat.count("In the words of") > 0
    assert f"mine-1 (of {path})" in flat
    page = gc.report(a)
    assert page.count(STATEMENT) == page.count("In the words of") > 0
    tex = " ".join(a.latex().split())
    assert tex.count(STATEMENT) == tex.count("In the words of") > 0
    shown = invoke("catalog", "show", "mine-1", "--catalog", str(path)).stdout
    assert shown.count(STATEMENT) == shown.count("In the words of") == 1


REGULAR = "classes:\n  - id: mine-1\n    name: the best\n    legs: ab bc ca de fg hi\n"


def test_nothing_outside_makes_a_robot_singular_in_every_pose(own: Any) -> None:
    """The kind of a condition is a claim too."""
    own_words = REGULAR + "    status: always-singular\n    condition: {kind: always-singular, expression: '0'}\n"
    done = invoke("analyze", "--catalog", str(own(own_words)), LEGS)
    assert (done.exit_code, done.stdout) == (2, "")
    assert "is not an identity: it fails at" in done.stderr
    sb = "'[[ab, bc, ca, de, fg, hi]]'"
    further = f"    readings: [{{kind: always-singular, expression: {sb}, statement: So it is.}}]\n"
    done = invoke(
        "analyze",
        "--catalog",
        str(own(f"{REGULAR}    condition: {{kind: one-incidence, expression: {sb}, statement: So.}}\n{further}")),
        LEGS,
    )
    assert (done.exit_code, done.stdout) == (2, "")
    assert "what is always singular has the expression 0" in done.stderr


def test_a_class_from_outside_is_called_so(own: Any) -> None:
    sb = "'[[ab, bc, ca, de, fg, hi]]'"
    path = own(f"{REGULAR}    condition: {{kind: one-incidence, expression: {sb}, statement: So.}}\n")
    a = gc.analyze(LEGS, catalogs=[path])
    called = f"mine-1, the best (of {path})"
    assert called in " ".join(a.text().split())
    assert gc.report(a).count("the best") == gc.report(a).count(called) > 0
    shown = invoke("catalog", "show", "mine-1", "--catalog", str(path)).stdout
    assert called in shown
    assert "sources    none given" in shown
    assert "proof      none: this is what" in shown
    assert "proof" not in invoke("catalog", "show", "6-6").stdout


def test_points_of_a_refusal_are_told_with_their_weights(own: Any) -> None:
    """The sum is zero wherever the last coordinates are 1, so that the points shown have others."""
    more = "[bcde] - [acde] + [abde] - [abce] + [abcd]"
    path = own(entry(gc.parse(f"[[ab, bc, ca, de, fg, hi]] + {more}")))
    done = invoke("analyze", "--catalog", str(path), LEGS)
    assert done.exit_code == 2
    assert "(homogeneous coordinates)" in done.stderr


def test_sentences_of_kinds_are_marked(own: Any) -> None:
    path = own("statements: {four-planes: 'Never singular: {planes}.', linear-complex: 'Always.'}\nclasses: []\n")
    a = gc.analyze("ab af cb cd ed ef", catalogs=[path])
    assert a.condition.sentence.startswith(f"In the words of {path}: Never singular")
    assert a.readings[-1].sentence == f"In the words of {path}: Always."
    plain = gc.analyze("ab af cb cd ed ef")
    assert {c.statement_source for c in (plain.condition, *plain.readings)} == {""}


# --- the shipped catalog -------------------------------------------------------------------------------------------


def test_all_that_is_shipped_has_its_digest() -> None:
    shipped = load()
    assert check_digests(shipped) == ()
    assert dict(shipped.statement_sources) == {}
    for one in shipped.entries:
        for reading in (one.condition, *one.readings):
            assert catalog_proofs.proof_status(one, reading).verdict == "shipped"


LINES = ("Aa Ab Bc Bd Ce Df", "Aa Bb Bc Cd Ce Df")


@pytest.mark.parametrize("legs", LINES)
def test_an_instance_says_how_it_was_proved(legs: str) -> None:
    a = gc.analyze(legs)
    found = [c.certificate for c in (a.condition, *a.readings) if c.certificate.method == "catalog-instance"]
    for certificate in found:
        digest = certificate.to_json()["digest"]
        assert f"proved by gcrules catalog check (digest {digest[:16]}); holds at 2" in certificate.detail
        assert "error below 1e-33" in certificate.detail
    assert found or a.match is None or not a.match.entry.readings


def test_a_shipped_catalog_that_was_changed_is_proved_on_the_spot(monkeypatch: pytest.MonkeyPatch) -> None:
    legs = "Aa Ab Bc Bd Ce Df"
    monkeypatch.setattr(catalog_proofs, "_shipped_digests", frozenset)
    a = gc.analyze(legs)
    details = [c.certificate.detail for c in a.readings if c.certificate.method == "catalog-instance"]
    assert details
    assert all("of gcrules/catalog.yaml, proved: both sides" in d for d in details)
    marked = [c for c in (a.condition, *a.readings) if c.statement_source]
    assert {c.statement_source.partition(",")[0] for c in marked} == {"gcrules/catalog.yaml"}
    assert check_digests(load()) == ()


@pytest.mark.parametrize("change", ["coefficient", "expression_text", "statement", "cofactor_text"])
def test_each_change_of_a_shipped_entry_is_noticed(change: str) -> None:
    one = load()["6-4.2"]
    reading = one.readings[0]
    values: dict[str, Any] = {
        "coefficient": -reading.coefficient,
        "expression_text": f"{reading.expression_text} + [ABCa] [ABCb] [ABCc]",
        "statement": "Never.",
        "cofactor_text": f"2 ({reading.cofactor_text})",
    }
    changed = replace(reading, **{change: values[change]})
    assert catalog_proofs.is_shipped(one, reading)
    assert not catalog_proofs.is_shipped(one, changed)
    if change == "statement":
        assert catalog_proofs.proof_status(one, changed).verdict == "proved"
    else:
        with pytest.raises(FileError, match="is not an identity"):
            catalog_proofs.proof_status(one, changed)


# --- what is remembered --------------------------------------------------------------------------------------------


def test_a_proof_costs_once(own: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GCRULES_CACHE", str(tmp_path / "cache"))
    path = own(entry(read_legs(LEGS).superbracket))
    calls: list[Expr] = []

    def counted(left: Expr, right: Expr, **options: Any) -> Proof:
        calls.append(left)
        return prove(left, right, **options)

    monkeypatch.setattr(catalog_proofs, "prove", counted)
    (one,) = load_file(path).entries
    for _ in range(3):
        assert catalog_proofs.proof_status(one, one.condition).verdict == "proved"
    assert len(calls) == 1
    (note,) = (tmp_path / "cache" / "proofs").iterdir()
    for damage in ("", "proved by somebody\n", "\udcff\x00"):
        note.write_text(damage, encoding="utf-8", errors="surrogateescape")
        assert catalog_proofs.proof_status(one, one.condition).verdict == "proved"
    assert len(calls) == 4
    monkeypatch.setattr(proof_memory, "engine", lambda: "another engine")
    catalog_proofs.proof_status(one, one.condition)
    assert len(calls) == 5
    monkeypatch.setenv("GCRULES_CACHE", "off")
    catalog_proofs.proof_status(one, one.condition)
    assert len(calls) == 6
    monkeypatch.setenv("GCRULES_CACHE", str(path))  # a file, where nothing can be kept
    assert catalog_proofs.proof_status(one, one.condition).verdict == "proved"


def test_a_false_identity_is_not_remembered(own: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GCRULES_CACHE", str(tmp_path / "cache"))
    for false in ATTACKS.values():
        with pytest.raises(FileError):
            gc.analyze(LEGS, catalogs=[own(entry(false))])
    assert not (tmp_path / "cache").exists()


FOLDERS = {
    "named": ({"GCRULES_CACHE": "/there"}, "/there"),
    "xdg": ({"XDG_CACHE_HOME": "/xdg"}, "/xdg/gcrules"),
    "home": ({"HOME": "/me"}, "/me/.cache/gcrules"),
    "off": ({"GCRULES_CACHE": "off", "XDG_CACHE_HOME": "/xdg"}, None),
    "empty": ({"GCRULES_CACHE": ""}, None),
}


@pytest.mark.parametrize(("variables", "expected"), FOLDERS.values(), ids=FOLDERS)
def test_where_proofs_are_kept(
    variables: dict[str, str], expected: str | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("GCRULES_CACHE", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    assert proof_memory.folder() == (Path(expected) if expected else None)


# --- rules ---------------------------------------------------------------------------------------------------------


def test_a_false_rule_file_is_refused(own: Any) -> None:
    for false in ATTACKS.values():
        path = own(f'rule mine "The condition.": {read_legs(LEGS).superbracket} => {false}\n', "mine.gca")
        with pytest.raises(InputError, match="not an identity"):
            load_rules([path])
        assert invoke("rules", "check", str(path)).exit_code == 1
        folder = own(path.read_text(encoding="utf-8"), "packs/mine/mine.gca").parent.parent
        with pytest.raises(InputError, match="not an identity"):
            load_rules(folders=[folder])


PLUGIN = """
from gcrules.algebra.language.syntax import parse
from gcrules.rules.plugins import ConditionRule

RULES = (
    ConditionRule(
        id="mine",
        sentence="Mine.",
        fires=("{legs}",),
        expression=lambda s: parse({expression!r}),
        statement="The words of the plugin.",
    ),
)
"""


def _plugin(own: Any, expression: object) -> gc.Library:
    source = PLUGIN.format(legs=LEGS, expression=str(expression))
    return load_rules(folders=[own(source, "packs/mine/rules.py").parent.parent])


@EACH_ATTACK
def test_a_rule_of_a_plugin_makes_no_false_condition(own: Any, false: Expr) -> None:
    a = analyze_legs(LEGS, strategy=_plugin(own, false).strategy())
    assert "mine" not in {c.kind for c in (a.condition, *a.readings)}


def test_a_true_rule_of_a_plugin_is_proved_and_marked(own: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    strategy = _plugin(own, read_legs(LEGS).superbracket).strategy()
    a = analyze_legs(LEGS, strategy=strategy)
    found = next(c for c in (a.condition, *a.readings) if c.kind == "mine")
    assert found.certificate.method == "normal-form"
    assert found.sentence == "In the words of plugin mine, rule mine: The words of the plugin."

    def limited(*_: Any, **__: Any) -> bool:
        raise LimitReached("more than 10 terms")

    monkeypatch.setattr("gcrules.rules.claims.is_zero", limited)
    a = analyze_legs(LEGS, strategy=strategy)
    found = next(c for c in (a.condition, *a.readings) if c.kind == "mine")
    assert found.certificate.method == "random-points"
    assert found.certificate.detail.startswith("claimed by plugin mine, rule mine, unproved; holds at 3 exact random")


# --- by hand -------------------------------------------------------------------------------------------------------


@EACH_ATTACK
def test_a_false_condition_is_refused_by_hand_and_when_resumed(own: Any, false: Expr) -> None:
    session = ManualSession.start(read_legs(LEGS)).do(f"condition {false}")
    assert session.outcome is not None
    assert session.outcome.refused
    forged = {"do": f"condition {false}", "answer": "confirmed", "reason": "proved"}
    legs = json.dumps([leg.split("-") for leg in ("a-b", "b-c", "c-a", "d-e", "f-g", "h-i")])
    path = own(f"gcrules: session\nversion: 1\nlegs: {legs}\nhistory:\n  - {json.dumps(forged)}\n", "forged.yaml")
    with pytest.raises(FileError, match="is refused now"):
        load_session(path)


@EACH_ATTACK
def test_a_script_fails_at_a_false_claim(own: Any, false: Expr) -> None:
    path = own(f"prove {read_legs(LEGS).superbracket} == {false}\n", "claims.gca")
    assert invoke("run", str(path)).exit_code in (1, 2)


# --- robots --------------------------------------------------------------------------------------------------------


def test_a_published_condition_with_a_coefficient_that_can_be_foreseen(root: Path) -> None:
    path = next(p for p in root.glob("plugins/*/robot.yaml") if "\ncondition:" in p.read_text(encoding="utf-8"))
    text = path.read_text(encoding="utf-8")
    line = next(x for x in text.splitlines() if x.startswith("condition:"))
    condition = line.partition(":")[2].strip().strip("'\"")
    good = analyze_robot(parse_robot(text)).published
    assert good is not None
    assert good.verdict in ("proved", "holds")
    for number in (MERSENNE, MERSENNE * (2**31 - 1)):
        worse = f"condition: '({condition}) + {number} ({condition})**2'"
        found = analyze_robot(parse_robot(text.replace(line, worse))).published
        assert found is not None
        assert found.verdict == "refuted"


def test_a_seed_repeats_an_answer_which_says_so() -> None:
    one, other = (invoke("analyze", LEGS, "--seed", "7") for _ in range(2))
    assert one.exit_code == 0
    assert one.stdout == other.stdout
    assert "points chosen with the seed 7: anyone who knows it can predict them" in " ".join(one.stdout.split())
    assert "seed" not in invoke("analyze", LEGS).stdout


SEEDED = "analyze, prove, factor, locus, map, path, pose, robot check, robot analyze, rules check, catalog check, run"


@pytest.mark.parametrize("command", SEEDED.split(", "))
def test_commands_that_decide_by_points_take_a_seed(command: str) -> None:
    assert "--seed N" in invoke(*command.split(), "--help").stdout


@pytest.mark.parametrize("command", ["expand", "catalog list", "robot new", "studio"])
def test_others_take_none(command: str) -> None:
    assert "--seed" not in invoke(*command.split(), "--help").stdout


def test_a_rule_file_is_proved_once(own: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GCRULES_CACHE", str(tmp_path / "cache"))
    path = own("rule mine: [R... a b][R... c d] - [R... a c][R... b d] => -[R... a d][R... b c]\n", "mine.gca")
    calls: list[Any] = []
    real = rule_file._proof
    monkeypatch.setattr(rule_file, "_proof", lambda *args: calls.append(args) or real(*args))
    first = load_rules([path])
    proved = len(calls)
    assert proved > 1
    assert load_rules([path])["mine"] == first["mine"]
    assert len(calls) == proved
    assert invoke("rules", "check", str(path)).exit_code == 0  # from scratch
    assert len(calls) == 2 * proved
    path.write_text(path.read_text(encoding="utf-8").replace("=> -", "=> "), encoding="utf-8")
    with pytest.raises(InputError, match="not an identity"):
        load_rules([path])


def test_the_words_of_a_rule_made_in_python_are_marked() -> None:
    rule = ConditionRule(
        id="mine",
        sentence="Mine.",
        expression=lambda s: gc.parse(str(s.structure.superbracket)),
        statement="My own words.",
    )
    library = load_rules().plus([rule])
    assert library.plus([library["mine"]])["mine"] is library["mine"]
    a = analyze_legs(LEGS, strategy=library.strategy(["mine"]))
    assert a.condition.sentence == "In the words of your own rule mine: My own words."


# --- maps ----------------------------------------------------------------------------------------------------------


def test_tiles_of_a_map_that_were_changed_are_refused(root: Path, tmp_path: Path) -> None:
    np = pytest.importorskip("numpy")
    pytest.importorskip("zarr")
    over, work = ["x -300:300:9", "y -300:300:9"], tmp_path / "map.zarr"

    def computed(**options: Any) -> Any:
        return gc.singular_map(root / "examples/octahedral.yaml", over, work=work, **options)

    first = computed()
    assert computed().summary == first.summary
    for tile in range(first.store.number):
        arrays = first.store.get(tile)
        forged = {n: np.zeros_like(a) + 7 if a.dtype.kind == "f" else a for n, a in arrays.items()}
        first.store.unseal(tile)
        first.store.put(tile, forged)  # with digests of their own
    with pytest.raises(FileError, match="is not what is computed now"):
        computed()
    assert not gc.verify_map(work).sound
    assert computed(restart=True).summary == first.summary
