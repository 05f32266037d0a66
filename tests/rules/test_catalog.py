"""The catalog: everything it says is proved, planted faults are found, files of the user's own read with care."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from platform_classes import CLASSES

from gcrules.algebra.evaluate import evaluate, random_rational_points
from gcrules.algebra.language.legs_text import Structure, read_legs
from gcrules.algebra.language.syntax import parse
from gcrules.conditions.catalog_check import check_entry, enumerate_classes, source_keys
from gcrules.core.errors import FileError
from gcrules.mechanisms.platform_analysis import analyze_legs
from gcrules.rules.catalog.catalog import Catalog
from gcrules.rules.catalog.entries import Entry
from gcrules.rules.catalog.file import load, load_file

IDS = [c["id"] for c in CLASSES]


@pytest.fixture(scope="module")
def catalog() -> Catalog:
    return load()


def test_everything_holds(catalog: Catalog) -> None:
    results = [check_entry(e) for e in catalog.entries]
    assert [r.id for r in results] == [e.id for e in catalog.entries]
    assert len(results) == 39
    assert [r for r in results if not r.ok] == []
    assert all(r.proved == 1 + len(catalog[r.id].readings) for r in results)
    assert sum(r.proved for r in results) > 39


@pytest.mark.parametrize("facts", CLASSES, ids=IDS)
def test_the_facts(catalog: Catalog, facts: dict[str, Any]) -> None:
    entry = catalog[facts["id"]]
    assert ["".join(leg) for leg in entry.legs] == facts["legs"]
    assert dict(entry.terms) == {24: facts["terms24"], 16: facts["terms16"]}
    assert sorted("".join(f) for f in entry.factors) == sorted(facts["factors"])
    assert entry.group == facts["group"]
    assert (entry.status == "always-singular") == (not facts["regular"])
    assert (entry.status == "inferred") == (facts["group"] is not None)
    assert set(entry.sources) <= source_keys()


def test_the_catalog_is_the_data(catalog: Catalog) -> None:
    assert sorted(e.id for e in catalog.entries) == sorted(IDS)
    with pytest.raises(KeyError):
        catalog["7-7"]


def test_enumeration(catalog: Catalog) -> None:
    found = enumerate_classes()
    assert len(found) == len(set(found)) == 39
    matches = [catalog.match(Structure(legs)) for legs in found]
    assert sorted(m.entry.id for m in matches if m) == sorted(IDS)


@pytest.mark.parametrize("facts", CLASSES, ids=IDS)
@pytest.mark.parametrize("exchanged", [False, True], ids=["as given", "bodies exchanged"])
def test_the_mapping_is_an_isomorphism(catalog: Catalog, facts: dict[str, Any], exchanged: bool) -> None:
    joints = sorted({n for leg in facts["legs"] for n in leg})
    label = {n: f"p{(7 * i + 3) % 13}" for i, n in enumerate(joints)}
    legs = [(label[a], label[b])[:: -1 if exchanged else 1] for a, b in reversed(facts["legs"])]
    structure = read_legs(legs)
    match = catalog.match(structure)
    assert match is not None
    assert match.entry.id == facts["id"]
    assert set(match.mapping) == set(joints)
    assert set(match.mapping.values()) == set(structure.names)
    images = {frozenset((match.mapping[a], match.mapping[b])) for a, b in match.entry.legs}
    assert images == {frozenset(leg) for leg in structure.legs}
    points = random_rational_points(structure.names, seed=1)
    own = {n: points[image] for n, image in match.mapping.items()}
    assert evaluate(structure.superbracket, points) == match.sign(structure) * evaluate(
        match.entry.structure.superbracket, own
    )


@pytest.mark.parametrize("legs", ["ab ac ad bc bd cd", "ab ab ac ad bc bd", "ab bc ca de ef fd"])
def test_no_match(catalog: Catalog, legs: str) -> None:
    assert catalog.match(read_legs(legs)) is None


# --- planted faults ------------------------------------------------------------------------------------------------


def with_condition(entry: Entry, **changes: Any) -> Entry:
    return replace(entry, condition=replace(entry.condition, **changes))


PLANTED = [
    pytest.param("3-3.3", lambda e: with_condition(e, coefficient=-e.condition.coefficient), "refuted: 1 *", id="sign"),
    pytest.param("6-3.1", lambda e: with_condition(e, coefficient=2), "refuted: 1 *", id="coefficient"),
    pytest.param("3-3.3", lambda e: with_condition(e, expression_text="[ABCa][Aabc][Bbca]"), "fails at A = (",
                 id="no identity"),
    pytest.param("3-3.3", lambda e: with_condition(e, coefficient=0), "refuted", id="coefficient zero"),
    pytest.param("3-3.3", lambda e: with_condition(e, expression_text="0", cofactor_text="0"), "identically zero",
                 id="0 = 0"),
    pytest.param("5-5.1", lambda e: with_condition(e, expression_text="[AaAb]", cofactor_text=r"ABC /\ ABC /\ AD"),
                 "identically zero", id="a cofactor that vanishes"),
    pytest.param("5-5.1", lambda e: with_condition(e, cofactor_text="1"), "refuted", id="cofactor left out"),
    pytest.param("6-4.1", lambda e: replace(e, factors=()), "factors [], computed", id="factor missing"),
    pytest.param("6-4.1", lambda e: replace(e, factors=(("A", "a", "b", "d"),)), "computed", id="wrong factor"),
    pytest.param("6-4.1", lambda e: replace(e, group="g"), "group g, but the rules find d", id="group"),
    pytest.param("6-6", lambda e: replace(e, group="c"), "group c, but the rules find none", id="group of none"),
    pytest.param("6-4.1", lambda e: replace(e, terms={24: 2, 16: 3}), "terms", id="terms"),
    pytest.param("6-4.1", lambda e: replace(e, degrees=((3, 2, 1), (1,) * 6)), "degrees", id="degrees"),
    pytest.param("6-4.1", lambda e: replace(e, sources=("Nobody1999",)), "Nobody1999 is not in", id="source"),
    pytest.param("6-4.1", lambda e: replace(e, status="always-singular"), "status always-singular", id="status"),
    pytest.param("6-2", lambda e: replace(e, status="added"), "status added", id="status of a singular class"),
]  # fmt: skip


@pytest.mark.parametrize(("class_id", "spoil", "fault"), PLANTED)
def test_planted_faults(catalog: Catalog, class_id: str, spoil: Any, fault: str) -> None:
    result = check_entry(spoil(catalog[class_id]))
    assert not result.ok
    assert any(fault in f for f in result.faults), result.faults
    assert result.to_json()["faults"] == list(result.faults)


@pytest.mark.parametrize("class_id", ["4-4.7", "5-4.4", "5-5.1"])
def test_a_planted_reading(catalog: Catalog, class_id: str) -> None:
    entry = catalog[class_id]
    for n, reading in enumerate(entry.readings):
        wrong = replace(reading, coefficient=-reading.coefficient)
        readings = (*entry.readings[:n], wrong, *entry.readings[n + 1 :])
        result = check_entry(replace(entry, readings=readings))
        assert result.proved == len(entry.readings)
        assert len(result.faults) == 1
        assert "fails at A = (" in result.faults[0]


# --- files of the user's own ---------------------------------------------------------------------------------------

OWN = r"""
statements:
  four-planes: 'Four planes through one point: {planes}.'
classes:
  - id: mine
    legs: ab ac ad bc bd cd
    degrees: [[], []]
    terms: {24: 1, 16: 1}
    factors: [abcd]
    group: g
    status: added
    sources: []
    condition: {kind: three-tetrahedra, expression: '[abcd]**3'}
    readings:
      - {kind: one-incidence, expression: '2[abcd]**3 (ab /\ cd)', cofactor: '2[abcd]', statement: 'Flat {abcd}.'}
      - {kind: one-incidence, expression: '1/12 [abcd]**3', coefficient: 12, statement: 'Twelve times {abcd}.'}
"""


@pytest.fixture
def own(tmp_path: Path) -> Any:
    def write(text: str, name: str = "own.yaml") -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_own_catalog(own: Any) -> None:
    path = own(OWN)
    assert [r.faults for r in map(check_entry, load_file(path).entries)] == [()]
    a = analyze_legs("qp rp sp rq sq sr", catalogs=[path])
    assert a.match is not None
    assert (a.match.entry.id, a.match.entry.owner) == ("mine", str(path))
    assert a.match.entry.place == f"{path}:5:9"
    statements = [r.statement for r in a.readings]
    assert any(s.startswith("Flat ") for s in statements)
    assert any(s.startswith("Twelve times ") for s in statements)
    octahedron = analyze_legs("ab af cb cd ed ef", catalogs=[path])
    assert octahedron.condition.statement == "Four planes through one point: abc, aef, bdf and cde."
    assert analyze_legs("qp rp sp rq sq sr").match is None


def test_shipped_classes_come_first(own: Any) -> None:
    text = OWN.replace("ab ac ad bc bd cd", "ab af cb cd ed ef").replace("[abcd]", "[abcf]")
    path = own(text[: text.index("    readings")])
    matches = load([path]).matches(read_legs("ab af cb cd ed ef"))
    assert [m.entry.id for m in matches] == ["3-3.3", "mine"]


def test_clash(own: Any) -> None:
    path = own(OWN.replace("id: mine", "id: '6-6'"))
    with pytest.raises(FileError, match="class 6-6 is also defined in") as fault:
        load([path])
    assert "gcrules/catalog.yaml:" in str(fault.value)
    assert f"{path}:5:9" in str(fault.value)
    again = own(OWN, "second.yaml")
    with pytest.raises(FileError, match="class mine is also defined in"):
        load([own(OWN), again])


def test_a_reading_that_is_no_identity(own: Any) -> None:
    for bad in ("coefficient: 12", "cofactor: '2[abcd]'"):
        path = own(OWN.replace(bad, "coefficient: 5"))
        with pytest.raises(FileError, match="is not an identity"):
            analyze_legs("qp rp sp rq sq sr", catalogs=[path])
        assert any(not r.ok for r in map(check_entry, load_file(path).entries))
    vanishing = r"{kind: one-incidence, expression: '0', cofactor: 'abc /\ abc /\ ad', statement: 'Never.'}"
    path = own(OWN + f"      - {vanishing}\n")
    with pytest.raises(FileError, match="says nothing: its cofactor is zero"):
        analyze_legs("qp rp sp rq sq sr", catalogs=[path])


FAULTY = r"""
statements:
  four-planes: 'x {nonsense}'
  five-planes: 'x'
  linear-complex: '{'
classes:
  - id: one
    legs: ab ac ad bc bd cc
    degrees: [[1]]
    terms: {24: few}
    factors: [a?]
    group: z
    status: known
    sources: []
    condition: {kind: guess, expression: '[abcd'}
  - id: two
    legs: ab ac ad bc bd cd
    degrees: [[], []]
    terms: {24: 1, 16: 1}
    factors: []
    group: none
    status: added
    sources: []
    condition: {kind: one-incidence, expression: '[abcx]', cofactor: 'ab'}
    readings:
      - {kind: four-planes, expression: '[abcd]**3', statement: '{abx}', lines: {p: abc, q: 'a x'}}
  - id: two
    wrong: 1
"""

EXPECTED = [
    ":3:16: {nonsense} cannot be filled in",
    ":4:3: 'five-planes' is not a kind",
    ":5:19: not a sentence to fill in",
    ":8:11: 'cc' is not a leg",
    ":10:17: ",
    ":11:15: 'a?' is not made of points",
    ":12:12: ",
    ":13:13: ",
    ":15:23: ",
    ":15:42: ",
    ":24:16: a reading needs a statement",
    ":24:50: x is not among the points",
    ":24:70: an expression of step 2",
    ":26:65: {abx} is not made of points of the class",
    ":26:85: an expression of step 3",
    ":26:93: x is not among the points",
    ":27:5: ",
]


def test_all_faults_at_once(own: Any) -> None:
    path = own(FAULTY)
    with pytest.raises(FileError) as fault:
        load_file(path)
    shown = fault.value.render()
    missing = [e for e in EXPECTED if f"{path}{e}" not in shown]
    assert missing == [], shown


@pytest.mark.parametrize("text", ["", "[]", "classes: 3", "classes:\n  - 1\n", "other: 1\nclasses: []", "\x00"])
def test_what_is_no_catalog(own: Any, text: str) -> None:
    path = own(text)
    with pytest.raises(FileError) as fault:
        load_file(path)
    assert str(path) in fault.value.render()


def test_no_such_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="no such file"):
        load([tmp_path / "none.yaml"])


def test_readings_are_parsed_as_written(catalog: Catalog) -> None:
    for entry in catalog.entries:
        joints = {n for leg in entry.legs for n in leg}
        for reading in (entry.condition, *entry.readings):
            assert reading.expression == parse(reading.expression_text)
            assert reading.expression.step == reading.cofactor.step == 0
            assert all(line.step == 2 for _, line in reading.lines)
            assert reading.coefficient in (1, -1)
            assert joints


def test_what_can_be_computed_is_not_typed(catalog: Catalog, tmp_path: Path) -> None:
    """The drafts of all classes, read back, agree with the catalog in everything that is computed."""
    from gcrules.conditions.catalog_check import FOUND
    from gcrules.conditions.catalog_draft import draft

    path = tmp_path / "draft.yaml"
    path.write_text("\n".join(["classes:", *(draft(e.id, e.legs) for e in catalog.entries)]), encoding="utf-8")
    drafted = load_file(path).entries
    assert len(drafted) == len(catalog.entries)
    for new, old in zip(drafted, catalog.entries, strict=True):
        for field in ("id", "legs", "degrees", "terms", "group"):
            assert getattr(new, field) == getattr(old, field), (old.id, field)
        assert sorted(map(sorted, new.factors)) == sorted(map(sorted, old.factors))
        assert (new.status == "always-singular") == (old.status == "always-singular")
        if old.condition.kind in FOUND:
            assert new.condition == old.condition
