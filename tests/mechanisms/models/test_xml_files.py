"""XML that nobody means: a refusal with its place, in no time, and nothing is opened or expanded."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from mechanisms.models.model_files import fault, read

from gcrules.core.errors import FileError
from gcrules.mechanisms.models.reading import read_model
from gcrules.mechanisms.models.xml_files import MAX_DEPTH, MAX_ELEMENTS, parse_xml

BOMB = (
    '<!DOCTYPE robot [<!ENTITY a "aaaaaaaaaa">'
    + "".join(f'<!ENTITY a{k + 1} "{f"&a{k or str()};" * 10}">' for k in range(9))
    + ']><robot name="&a9;"/>'
)
HOSTILE = {
    "entity bomb": (BOMB, "document types"),
    "external entity": ('<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/passwd">]><robot>&x;</robot>', "document types"),
    "external DTD": ('<!DOCTYPE robot SYSTEM "http://nowhere.invalid/a.dtd"><robot/>', "document types"),
    "entity of no one": ('<robot name="&nobody;"/>', "undefined entity"),
    "empty": ("", "the file is empty"),
    "blank": ("  \n ", "the file is empty"),
    "no XML": ("title: a robot\n", "this is not XML"),
    "two roots": ("<robot/><robot/>", "this is not XML"),
    "unclosed": ("<robot><link name='a'>", "this is not XML"),
    "an attribute twice": ('<robot name="a" name="b"/>', "duplicate attribute"),
    "NUL": ("<robot>\0</robot>", "this is not XML"),
    "character reference to NUL": ("<robot name='&#0;'/>", "this is not XML"),
    "deep": ("<robot>" + "<a>" * MAX_DEPTH + "</a>" * MAX_DEPTH + "</robot>", "nested more than"),
    "many": ("<robot>" + "<a/>" * MAX_ELEMENTS + "</robot>", "more than 200,000 elements"),
    "another root": ("<html/>", "the root element is <html>"),
    "nothing in it": ("<robot/>", "there are no links"),
    "nothing in it, SDF": ("<sdf/>", "0 models"),
    "nothing in it, MJCF": ("<mujoco/>", "no joints"),
}


@pytest.mark.parametrize(("text", "says"), HOSTILE.values(), ids=HOSTILE)
def test_hostile_files_are_refused(tmp_path: Path, text: str, says: str) -> None:
    found = fault(tmp_path, text)
    assert says in found.render()
    assert found.place is not None
    assert str(tmp_path) in found.place


NO_FILES = {"latin.xml": "not a text file in UTF-8", "none.xml": "no such file", "": "directory"}


@pytest.mark.parametrize(("name", "says"), NO_FILES.items(), ids=["another encoding", "missing", "a folder"])
def test_files_that_cannot_be_read(tmp_path: Path, name: str, says: str) -> None:
    (tmp_path / "latin.xml").write_bytes(b"<?xml version='1.0' encoding='latin-1'?><robot name='\xe9'/>")
    with pytest.raises(FileError) as found:
        read_model(tmp_path / name)
    assert says in found.value.render()


def test_places_are_those_of_elements_and_attributes() -> None:
    first = '<?xml version="1.0"?>\n<robot name="ä">\n  <link\n'
    text = first + '    name = "é">é<joint  type=\'x="\' name="j"/></link></robot>'
    root = parse_xml(text, "r.xml")
    link = root.children[0]
    joint = link.children[0]
    assert (link.line, link.column, joint.line, joint.column) == (3, 3, 4, 17)
    assert root.error("m", "name").render() == 'error: r.xml:2:14: m\n  <robot name="ä">\n               ^'
    assert joint.error("m", "name").place == "r.xml:4:42"
    assert joint.error("m", "type").place == "r.xml:4:31"
    assert joint.error("m", "none").place == joint.error("m").place == "r.xml:4:17"


NUMBERS = ("inf", "-inf", "nan", "1e400", "1e10", "0x10", "1_0", "", "1 2", "1,5", "٣", "1" * 200, "--1", "1e", "½")


@pytest.mark.parametrize("text", NUMBERS)
def test_numbers_that_are_none(text: str) -> None:
    element = parse_xml(f'<a x="{text}"/>', "r.xml")
    with pytest.raises(FileError) as found:
        element.number("x", 0.0)
    assert found.value.place.startswith("r.xml:1:")


@pytest.mark.parametrize(
    ("text", "value"), [("-1.5e-3", -0.0015), (" +.5 ", 0.5), ("7", 7.0), ("1.", 1.0), ("-0", 0.0)]
)
def test_numbers(text: str, value: float) -> None:
    assert parse_xml(f'<a x="{text}"/>').number("x", 9.0) == value
    assert parse_xml("<a/>").number("x", 9.0) == 9.0


@pytest.mark.parametrize("name", ["urdf", "sdf", "mjcf"])
def test_whatever_is_changed_is_read_or_refused(tmp_path: Path, name: str) -> None:
    """Characters of a good file are lost, doubled and changed: a model, or a fault with its place."""
    good = SMALL[name]
    rng = random.Random(name)
    refused = accepted = 0
    for _ in range(150):
        text = good
        for _ in range(rng.randrange(1, 4)):
            k, n = rng.randrange(len(text)), rng.randrange(1, 12)
            part = text[k : k + n]
            text = (
                text[:k]
                + rng.choice(("", part * 2, "9", '"', "<", "-1", "1e999", " ", "0 0 0", part[::-1]))
                + text[k + n :]
            )
        try:
            read(tmp_path, text)
        except FileError as found:
            refused += bool(found.place and found.render())
        else:
            accepted += 1
    assert refused + accepted == 150
    assert refused > 0


SMALL = {
    "urdf": """<robot name="r">
  <link name="a"/><link name="b"/><link name="c"/>
  <joint name="p" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0 0 1" rpy="0 0.5 0"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="1"/></joint>
  <joint name="q" type="prismatic"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/><mimic joint="p"/></joint>
  <loop_joint name="l" type="spherical"><link1 link="c" xyz="0 0 0"/><link2 link="a" xyz="0 0 1"/></loop_joint>
</robot>""",
    "sdf": """<sdf version="1.9"><model name="r">
  <link name="a"/><link name="b"><pose relative_to="a">0 0 1 0 0.5 0</pose></link>
  <frame name="f" attached_to="b"/><link name="c"><pose relative_to="f">0 0 1 0 0 0</pose></link>
  <joint name="p" type="revolute"><parent>a</parent><child>b</child><axis><xyz>0 1 0</xyz></axis></joint>
  <joint name="q" type="universal"><parent>f</parent><child>c</child>
    <axis><xyz>0 1 0</xyz></axis><axis2><xyz expressed_in="a">1 0 0</xyz></axis2></joint>
  <joint name="s" type="ball"><parent>a</parent><child>c</child></joint>
</model></sdf>""",
    "mjcf": """<mujoco model="r"><compiler angle="radian"/><default><joint axis="0 1 0"/></default>
  <worldbody><body name="a" pos="0 0 1"><joint name="p" range="-1 1"/>
    <body name="b" euler="0 0.5 0"><joint name="q" type="slide" axis="0 0 1"/><site name="s" pos="0 0 0"/></body></body>
    <body name="c" pos="0 0 1"><joint name="u" type="ball"/></body></worldbody>
  <equality><connect body1="b" body2="c" anchor="0 0 0"/><joint joint1="q" joint2="p" polycoef="0 2 0 0 0"/></equality>
  <actuator><motor joint="p"/></actuator>
</mujoco>""",
}
