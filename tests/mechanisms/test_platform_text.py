"""Platform files with other dimensions."""

from __future__ import annotations

import json
from fractions import Fraction

import pytest
import yaml
from hypothesis import assume, given
from hypothesis import strategies as st
from places import EXAMPLES

from gcrules.core.errors import FileError, InputError
from gcrules.mechanisms.description.platform_file import parse_platform
from gcrules.mechanisms.editing.platform_text import platform_text, with_dimensions

TEXT = (EXAMPLES / "octahedral.yaml").read_text(encoding="utf-8")
FORMS = {
    "as it is": TEXT,
    "JSON": json.dumps(yaml.safe_load(TEXT)),
    "in blocks": yaml.safe_dump(yaml.safe_load(TEXT), default_flow_style=False),
    "with limits": f'limits: "100..900 mm" # of all legs\n{TEXT}',
}
numbers = st.one_of(
    st.integers(-(10**6), 10**6).map(str),
    st.decimals(-1000, 1000, places=4).map(str),
    st.fractions(-9, 9, max_denominator=99).map(str),
    st.just(""),
)
places = st.dictionaries(st.sampled_from("abcdef"), st.tuples(numbers, numbers, numbers))


@pytest.mark.parametrize("text", FORMS.values(), ids=FORMS)
@given(points=places, limits=st.sampled_from([None, "", "200..800", "ab 1..5000 mm"]))
def test_only_what_is_asked_for_changes(text: str, points: dict[str, tuple[str, str, str]], limits: str | None) -> None:
    before = parse_platform(text)
    expected = {
        n: tuple(Fraction(new) if new else old for new, old in zip(points.get(n, ("", "", "")), at, strict=True))
        for n, at in before.points.items()
    }
    assume(all(expected[a] != expected[b] for a, b in before.legs))
    after = parse_platform(with_dimensions(text, "robot.yaml", points, limits))
    assert after.points == expected
    assert (after.legs, after.title, after.note, after.units) == (before.legs, before.title, before.note, before.units)
    assert after.limits == (before.limits if limits is None else limits)


def test_comments_stay() -> None:
    found = with_dimensions(FORMS["with limits"], "robot.yaml", {"b": ("", "0.5", "")}, "1..9000")
    assert [line for line in found.splitlines() if "#" in line][1:] == [li for li in TEXT.splitlines() if "#" in li]
    assert found.splitlines()[0] == 'limits: "1..9000" # of all legs'
    assert with_dimensions(with_dimensions(TEXT, "o", {}, "1..9000"), "o", {}, "") == TEXT


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ({"b": ("cat", "", "")}, "robot.yaml:12:7: expected a number, found 'cat'"),
        ({"b": ("1, 2", "", "")}, "robot.yaml:12:7: expected a number"),
        ({"b": ("1/0", "", "")}, "robot.yaml:12:7: division by zero"),
        ({"b": ("]", "", "")}, "expected a number"),
    ],
)
def test_faults_have_their_place(points: dict[str, tuple[str, str, str]], message: str) -> None:
    with pytest.raises(FileError) as fault:
        with_dimensions(TEXT, "robot.yaml", points)
    assert message in fault.value.render()


def test_points_and_limits_that_do_not_fit() -> None:
    with pytest.raises(InputError, match="there is no point 'bb'"):
        with_dimensions(TEXT, "robot.yaml", {"bb": ("1", "", "")})
    with pytest.raises(FileError, match=r"limits|expected|length"):
        with_dimensions(TEXT, "robot.yaml", {}, "from here to there")


def test_a_written_platform_is_read_again() -> None:
    p = parse_platform(TEXT)
    again = parse_platform(platform_text(p.title, p.note, p.units, p.legs, p.points, "300..600"))
    assert (again.legs, again.points, again.title, again.limits) == (p.legs, p.points, p.title, "300..600")
