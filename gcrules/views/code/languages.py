"""How each language spells the lines of a program; the rest of a file stands in its template."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from gcrules.core.dataclass import dataclass
from gcrules.core.frozen import FrozenMap

__all__ = ["LANGUAGES", "Language"]


@dataclass(frozen=True)
class Language:
    """The `suffix` of files, how they are tested, and templates for `str.format`: a `comment` of a {line}, the
    declaration of {n} as {value}, the coordinate number {k} of a pose and that of an angle, 1/{x}, √{x}, the angle with
    sine {y} and cosine {x}, the assignment of {value} to the place {k} of {what}, an array of {items}, and a text.
    Where loops are closed by steps, `solved` fills {into} with what is called {what}, and `made` {size} numbers {into}.
    """

    title: str
    suffix: str
    tested: str
    comment: str
    declare: str
    angle: str
    root: str
    arctangent: str
    assign: str
    array: str
    solved: str
    made: str
    inverse: str = "1.0 / {x}"
    coordinate: str = "pose[{k}]"
    quoted: Callable[[str], str] = '"{}"'.format

    loops: str = ""

    @property
    def template(self) -> str:
        """The name of the file that holds the rest."""
        return f"controller{self.suffix}.template"

    @property
    def loop_template(self) -> str:
        """The name of the file that holds how loops are closed."""
        return f"loops{self.loops or self.suffix}.template"


def _braces(title: str, suffix: str, tested: str, space: str, solved: str) -> Language:
    """C, or what is like it."""
    return Language(
        title=title,
        suffix=suffix,
        tested=tested,
        comment="// {line}",
        declare="    const double {n} = {value};",
        angle=f"{space}remainder(pose[{{k}}], TURN)",
        root=f"{space}sqrt({{x}})",
        arctangent=f"{space}atan2({{y}}, {{x}})",
        assign="    {what}[{k}] = {value};",
        array="{{{items}}}",
        solved=f"    {{what}}_at({solved});",
        made=f"    double {{into}}[{{size}}];\n    {{what}}_at({'pose.data()' if space else 'pose'}, {{into}});",
        loops=".c",
    )


LANGUAGES: Mapping[str, Language] = FrozenMap(
    {
        "c": _braces("C99", ".c", "cc -std=c99 -DGCRULES_TEST FILE.c -lm -o test && ./test", "", "pose, {into}"),
        "cpp": _braces(
            "C++17",
            ".cpp",
            "c++ -std=c++17 -DGCRULES_TEST FILE.cpp -o test && ./test",
            "std::",
            "pose.data(), {into}.data()",
        ),
        "python": Language(
            title="Python 3",
            suffix=".py",
            tested="python FILE.py",
            comment="# {line}",
            declare="    {n} = {value}",
            angle="_angle(pose[{k}])",
            root="_root({x})",
            arctangent="atan2({y}, {x})",
            assign="    {what}[{k}] = {value}",
            array="({items},)",
            solved="    {into} = _{what}_at(pose)",
            made="    {into} = _{what}_at(pose)",
            inverse="_inverse({x})",
        ),
        "rust": Language(
            title="Rust 2021",
            suffix=".rs",
            tested="rustc --edition 2021 --test FILE.rs -o test && ./test",
            comment="// {line}",
            declare="    let {n} = {value};",
            angle="remainder(pose[{k}])",
            root="{x}.sqrt()",
            arctangent="{y}.atan2({x})",
            assign="    {what}[{k}] = {value};",
            array="[{items}]",
            solved="    let {into} = {what}_at(pose);",
            made="    let {into} = {what}_at(pose);",
        ),
    }
)
