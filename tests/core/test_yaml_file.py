"""YAML files: faults with their places, all at once, and nothing that YAML can do to a program."""

from __future__ import annotations

from contextlib import suppress
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gcrules.core.errors import FileError, GcrulesError
from gcrules.core.hints import near
from gcrules.core.yaml_file import MAX_BYTES, Document, read_text


def scalar(text: str) -> Document:
    return Document.parse(f"x: {text}\n", "f.yaml")


def faults(document: Document) -> str:
    with pytest.raises(FileError) as found:
        document.check()
    return str(found.value)


NOT_YAML = {
    "open bracket": ("a: [1, 2", "1:9", "flow sequence"),
    "tab": ("a:\n\tb: c", "2:1", "cannot start any token"),
    "two documents": ("a: 1\n---\nb: 2\n", "2:1", "second document"),
    "deep": ("[" * 60, "1:21", "nested more than 20 deep"),
    "zero byte": ("a: \0", "1:4", r"U\+0000"),
    "unknown alias": ("a: 1\nb: [*x\n", "3:1", "not YAML"),
}


@pytest.mark.parametrize(("text", "place", "words"), NOT_YAML.values(), ids=NOT_YAML)
def test_what_is_not_yaml(text: str, place: str, words: str) -> None:
    with pytest.raises(FileError, match=words) as found:
        Document.parse(text, "f.yaml")
    assert found.value.place == f"f.yaml:{place}"


@pytest.mark.parametrize("text", ["", "\n\n", "# only a comment\n"])
def test_an_empty_file(text: str) -> None:
    with pytest.raises(FileError, match="empty"):
        Document.parse(text)


FORBIDDEN = {
    "tag": ("a: !!python/object/apply:os.system [ls]\n", "1:4", "tags"),
    "plain tag": ("é: 1\nb: !!str 5\n", "2:4", "tags"),
    "anchor": ("a: &x [1]\n", "1:4", "anchors"),
    "alias": ("a: &x 1\nb: *x\n", "2:4", "aliases"),
}


@pytest.mark.parametrize(("text", "place", "words"), FORBIDDEN.values(), ids=FORBIDDEN)
def test_forbidden_constructs(text: str, place: str, words: str) -> None:
    shown = faults(Document.parse(text, "f.yaml"))
    assert f"f.yaml:{place}: {words}" in shown


def test_an_alias_bomb_is_no_burden() -> None:
    lines = ["a0: &a0 [x, x]"] + [f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]" for i in range(1, 40)]
    assert "more faults" in faults(Document.parse("\n".join(lines)))  # 9^39 values would come to no end


def test_all_faults_of_a_mapping_at_once() -> None:
    document = Document.parse("legz: 1\nname: x\nname: y\nlimbs: 2\n", "f.yaml")
    assert list(document.root.mapping({"legs"}, {"name"}, {"limbs": "later"})) == ["name"]
    with pytest.raises(GcrulesError) as found:
        document.check()
    assert found.value.render().splitlines()[::1] == [
        "error: f.yaml:1:1: unknown key 'legz'",
        "  legz: 1",
        "  ^^^^",
        "hint: did you mean legs?",
        "error: f.yaml:1:1: the key 'legs' is missing",
        "  legz: 1",
        "  ^^^^",
        "error: f.yaml:3:1: the key 'name' occurs twice (first in line 2)",
        "  name: y",
        "  ^^^^",
        "error: f.yaml:4:1: the key 'limbs' is reserved: later",
        "  limbs: 2",
        "  ^^^^^",
    ]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("3", 3), ("-0.25", Fraction(-1, 4)), ("+.5", Fraction(1, 2)), ("2.", 2), ("1e-3", Fraction(1, 1000)),
        ("1/3", Fraction(1, 3)), ('"-7/2"', Fraction(-7, 2)), ("0.1", Fraction(1, 10)),
    ],
)  # fmt: skip
def test_rational(text: str, value: Fraction) -> None:
    document = scalar(text)
    assert document.root.mapping({"x"})["x"].rational() == value
    document.check()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (".nan", "finite"), ("-.inf", "finite"), ("inf", "finite"), ("one", "expected a number"), ("1/0", "zero"),
        ("1e99", "too long"), ("1" * 80, "too long"), ("1_000", "expected a number"), ("0x10", "expected a number"),
        ("[1]", "expected a single value"), ("", "found nothing"), ("~", "found nothing"), ("1 2", "expected a number"),
    ],
)  # fmt: skip
def test_what_is_no_number(text: str, words: str) -> None:
    document = scalar(text)
    assert document.root.mapping({"x"})["x"].rational() is None
    assert words in faults(document)


@pytest.mark.parametrize(
    ("method", "text", "value", "words"),
    [
        ("integer", "12", 12, None),
        ("integer", "1.0", None, "whole number"),
        ("integer", '"1"', None, "whole number"),
        ("string", "no", "no", None),
        ("string", "6-6", "6-6", None),
        ("string", "2020-01-01", "2020-01-01", None),
        ("string", "null", None, "nothing"),
        ("string", '" "', None, "nothing"),
        ("string", "{a: b}", None, "a mapping"),
    ],
)
def test_scalars(method: str, text: str, value: object, words: str | None) -> None:
    document = scalar(text)
    assert getattr(document.root.mapping({"x"})["x"], method)() == value
    if words is None:
        document.check()
    else:
        assert words in faults(document)


def test_choice_and_sequence() -> None:
    document = Document.parse("unit: mn\nxs: [1, 2]\nys: 3\n", "f.yaml")
    top = document.root.mapping({"unit", "xs", "ys"})
    assert top["unit"].choice(["mm", "m"]) is None
    assert [n.integer() for n in top["xs"].sequence(2)] == [1, 2]
    assert top["xs"].sequence(3) == ()
    assert top["ys"].sequence() == ()
    shown = faults(document)
    for words in (
        "'mn' is not one of m, mm",
        "f.yaml:2:5: a list of 2, expected 3",
        "f.yaml:3:5: expected a list, found '3'",
    ):
        assert words in shown


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (None, "no such file"),
        (b"\xff\xfe\x00", "not a text file"),
        (b"a: 1\n" + b"\x80", r"not a text file in UTF-8 \(byte 6, line 2\)"),
        (b" " * (MAX_BYTES + 1), "larger than 1,000,000 bytes"),
        (b"\x7fELF\x02\x01\x01\x00", "U\\+007F"),
    ],
    ids=["missing", "utf-16", "byte", "large", "binary"],
)
def test_files_that_cannot_be_read(tmp_path: Path, data: bytes | None, words: str) -> None:
    path = tmp_path / "f.yaml"
    if data is not None:
        path.write_bytes(data)
    with pytest.raises(FileError, match=words) as found:
        Document.load(path)
    assert str(path) in str(found.value)


def test_a_directory_and_a_bad_name(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="directory"):
        read_text(tmp_path)
    with pytest.raises(FileError, match="cannot be read"):
        read_text("a\0b")


def test_byte_order_mark_and_windows_lines(tmp_path: Path) -> None:
    path = tmp_path / "f.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: 1\r\nb: x\r\n")
    document = Document.load(path)
    document.root.mapping({"a"})
    assert f"{path}:2:1: unknown key 'b'" in faults(document)


def test_places_count_characters() -> None:
    document = Document.parse("title: Größe 😀\nké: [é, 😀, x]\n", "f.yaml")
    node = document.root.entries()[1][1].sequence()[2]
    assert node.place == "f.yaml:2:12"


def test_near() -> None:
    assert near("legz", {"legs", "points"}) == "did you mean legs?"
    assert near("A", {"a", "b"}) == "did you mean a?"
    assert near("zzz", {"legs"}) is None


@given(st.text(max_size=60))
def test_any_text_ends_in_a_tree_or_a_fault(text: str) -> None:
    with suppress(GcrulesError):
        document = Document.parse(text)
        document.root.mapping({"a"}, {"b"})
        document.root.sequence()
        document.root.rational()
        assert faults(document)
