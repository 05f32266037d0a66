"""Geometry files, robot files, catalogs and tables of poses: valid ones with other numbers, and broken ones."""

from __future__ import annotations

from functools import cache, lru_cache
from random import Random
from typing import Any
from unittest.mock import patch

from ..case import Case
from ..corpus import corpus
from ..grammar import LETTERS, legs
from ..jail import Jail
from ..mutating import NUMBERS, mutated, mutated_numbers, scaled
from ..running import Outcome, run_command
from .family import Family

__all__ = ["CATALOGS", "GEOMETRY", "ROBOTS", "TABLES", "pose_words"]

_YAML = (
    *(
        "- ",
        ": ",
        "? ",
        "| ",
        "> ",
        "&a ",
        "*a",
        "!!python/object:os.system ",
        "!!str ",
        "!!float ",
        "!!binary ",
        "<<: ",
        "---",
    ),
    *(
        "...",
        "%YAML 1.1",
        "null",
        "~",
        "true",
        "no",
        "[",
        "]",
        "{",
        "}",
        "[]",
        "{}",
        "''",
        '""',
        "#",
        "0",
        ".inf",
        "1e9",
    ),
    *(
        "legs",
        "points",
        "units",
        "title",
        "note",
        "source",
        "limbs",
        "joints",
        "platform",
        "mobility",
        "home",
        "copies",
    ),
    *("directions", "name", "space", "plane", "lines", "free", "classes", "id", "condition", "kind", "expression"),
)
_ROBOT_WORDS = (
    *("P*", "R*", "P", "R", "S", "U", "C", "H", "A%", "S%", "%", "free", "on line A% along d%", "in plane A%", "along"),
    *(
        "perpendicular to r%",
        "parallel to",
        "x",
        "y",
        "z",
        "A1",
        "S1",
        "copies: 3",
        "copies: 0",
        "copies: 99",
        "centroid",
    ),
    *(
        "mobility: 6",
        "mobility: -1",
        "platform: S1",
        "condition",
        "P*(z)",
        "R(A%, r%)",
        "S(S%)",
        "U(A%, u%, v%)",
        "space: plane",
    ),
)


def _broken(rng: Random, text: str, words: tuple[str, ...]) -> str:
    """Other numbers, or mistyped, or both; sometimes as it was."""
    kind = rng.choices(("numbers", "mutated", "both", "scaled", "none"), (5, 4, 1, 2, 1))[0]
    if kind == "scaled":
        text = scaled(rng, text)
    if kind in ("numbers", "both"):
        text = mutated_numbers(rng, text)
    if kind in ("mutated", "both"):
        text = mutated(rng, text, (*_YAML, *words))
    return text


def _platform(rng: Random) -> str:
    if rng.random() < 0.5:
        return _broken(rng, rng.choice(corpus("platforms")), ())
    if rng.random() < 0.3:  # special positions: a small grid, so that much coincides
        lines = legs(rng, number=6)
        size = rng.choice((0, 1, 2, 10))
        names = sorted({c for c in lines if c.isalpha()})
        points = [f"  {n}: [{', '.join(str(rng.randint(-size, size)) for _ in range(3))}]" for n in names]
    else:
        names = list(LETTERS[: rng.randint(4, 12)])
        lines = " ".join("".join(rng.sample(names, 2)) for _ in range(6))
        scale = rng.choice(("", "", "e-3", "e3", "e8", "e-8", "e12", "e-12", "e20", "e-20", "e30", "e-30", "e31"))
        points = [f"  {n}: [{', '.join(f'{rng.uniform(-2, 2):.3f}{scale}' for _ in range(3))}]" for n in names]
    return "\n".join([f"legs: {lines}", "points:", *points, ""])


def pose_words(rng: Random) -> str:
    """A pose as --at takes it."""

    def number() -> str:
        return (
            rng.choice(NUMBERS)
            if rng.random() < 0.12
            else rng.choice(("0", "0.1", "-2", "10", "1/3", "45", "90", "180"))
        )

    shift = " ".join(number() for _ in range(rng.choices((3, 2, 4, 0), (20, 1, 1, 1))[0]))
    turn = rng.choice(
        (
            "",
            "",
            f"; euler {rng.choice(('zyx', 'xyz', 'XYZ', 'zxz', 'abc', 'zz'))} {number()} {number()} {number()} deg",
            f"; quaternion {number()} {number()} {number()} {number()}",
            f"; rotation-vector {number()} {number()} {number()} {rng.choice(('deg', 'rad', ''))}",
        )
    )
    found = shift + rng.choice(("", "", " mm")) + turn
    return (mutated(rng, found, (), most=1) if rng.random() < 0.1 else found).replace("\0", "")


def _form(rng: Random, *, latex: bool = False) -> tuple[str, ...]:
    return rng.choice(((), (), ("--json",), ("--ascii",), ("--latex",) if latex else ()))


def geometry(rng: Random) -> Case:
    text = _platform(rng)
    about = (
        ("--about", rng.choice(("origin", "centroid", "0,0,0", "1,2,3", "1e308,0,0", "x", "1,2")))
        if rng.random() < 0.2
        else ()
    )
    at = ("--at", pose_words(rng)) if rng.random() < 0.6 else ()
    threshold = (
        ("--threshold", rng.choice(("1 deg", "0 deg", "5mm", "1e-300 rad", "-1 deg", "1", "deg")))
        if rng.random() < 0.1
        else ()
    )
    kind = rng.choices(
        ("pose", "analyze", "path", "locus", "modes", "map", "figure", "report", "nearest", "plot"),
        (9, 6, 3, 2, 1, 0.3, 0.5, 0.3, 0.2, 0.2),
    )[0]
    name = "g.yaml"
    argv: tuple[str, ...]
    match kind:
        case "analyze":
            argv = ("analyze", name, "--search", "0", *_form(rng, latex=True))
        case "path":
            poses = tuple(w for _ in range(rng.choices((2, 3, 1), (9, 3, 1))[0]) for w in ("--at", pose_words(rng)))
            csv = ("--csv", "-") if rng.random() < 0.1 else ()
            argv = (
                "path",
                name,
                *poses,
                "--samples",
                rng.choice(("2", "5", "20", "0", "-1", "1000")),
                *about,
                *threshold,
                *csv,
            )
            argv += () if csv else _form(rng)
        case "modes":
            lengths = rng.choice(("1 1 1 1 1 1", "1,2,3", "ab=2", "ab=-1", "ab=1e300", "0 0 0 0 0 0", "x"))
            held = ("--actuators", lengths) if rng.random() < 0.3 else at
            argv = ("modes", name, *held, *about, *threshold, *_form(rng, latex=True))
        case "locus":
            over = rng.choice(("x", "x,y", "z", "e1", "translation", "e0,e1", "q", ""))
            argv = ("locus", name, "--over", over, *at, *about, *_form(rng, latex=True))
        case "map":
            ranges = (
                f"{c} {rng.choice(('-1:1:3', '0:1:4', '-100:100:5', '0:0:2', '1:0:3', '0:1:1', '-1e9:1e9:3'))}"
                for c in rng.sample(("x", "y", "z"), rng.choice((2, 2, 3)))
            )
            argv = (
                "map",
                name,
                *(w for r in ranges for w in ("--over", r)),
                *at,
                "--measure",
                rng.choice(("value", "margin")),
            )
            argv += ("-o", rng.choice(("m.json", "m.svg", "m.stl", "m.png"))) if rng.random() < 0.3 else _form(rng)
        case "figure":
            argv = ("analyze", name, "--search", "0", "--figure", rng.choice(("f.svg", "f.pdf")))
        case "report":
            argv = ("report", name, "--search", "0", "-o", "r.html", *rng.choice(((), ("--no-3d",))))
        case "plot":
            plot = rng.choice(("p.svg", "p.pdf"))
            argv = ("path", name, "--at", pose_words(rng), "--at", "0 0 0", "--samples", "9", "--plot", plot)
        case "nearest":
            argv = ("pose", name, *at, *about)
        case _:
            argv = ("pose", name, "--no-nearest", *at, *about, *threshold, *_form(rng, latex=True))
    seconds = 30.0 if kind == "nearest" else 0.0
    if rng.random() < 0.05:
        return Case("geometry", tuple("-" if w == name else w for w in argv), {}, text, seconds)
    return Case("geometry", argv, {name: text}, "", seconds)


def robots(rng: Random) -> Case:
    text = _broken(rng, rng.choice(corpus("robots")), _ROBOT_WORDS)
    kind = rng.choices(("show", "pose", "analyze", "check", "as", "report", "search"), (8, 4, 1.2, 0.4, 0.6, 0.1, 0.2))[
        0
    ]
    at = (
        (
            "--at",
            rng.choice(
                ("z=0.1", "x=0, y=0", "z=0.2, roll=5deg", "yaw=1e9", "0 0 1", "z=nan", "q=1", "z=1/3, pitch=-5deg")
            ),
        )
        if rng.random() < 0.4
        else ()
    )
    actuators = (
        ("--actuators", rng.choice(("q1=0.1", "q1=5deg", "q1=1e300", "q9=0", "q1=0.1, q2=0.2", "")))
        if rng.random() < 0.2
        else ()
    )
    name = "robot.yaml"
    argv: tuple[str, ...]
    match kind:
        case "pose":
            argv = ("robot", "pose", name, *at, *actuators, *_form(rng, latex=True))
        case "analyze":
            argv = ("robot", "analyze", name, "--search", "0", *_form(rng, latex=True))
        case "check":
            argv = ("robot", "check", name)
        case "as":
            argv = rng.choice(
                (
                    ("locus", name, "--over", "x"),
                    ("path", name, "--at", "0 0 0", "--at", "0 0 1", "--samples", "3"),
                    ("analyze", name, "--search", "0"),
                    ("pose", name),
                )
            )
        case "report":
            argv = ("report", name, "--search", "0", "-o", "r.html")
        case "search":
            argv = ("robot", "pose", name, "--at", "z=0.2", "--search")
        case _:
            argv = ("robot", "show", name)
    return Case("robots", argv, {name: text}, seconds=20.0 if kind == "check" else 5.0, mixed=kind == "check")


_SOME = ("x", "y", "z", "roll", "pitch", "yaw", "rx", "q1", "q2", "q3")
_RANGES = ("-0.2:0.2:4", "-1:1:5", "0:1e-9:3", "-1e9:1e9:3", "-300:300:3", "5:6:2", "1:0:4", "0:nan:3", "-2:2:1")


def workspaces(rng: Random) -> Case:
    """Robots of joints along paths and over maps; half of their files are whole."""
    text = rng.choice(corpus("robots"))
    text = _broken(rng, text, _ROBOT_WORDS) if rng.random() < 0.5 else text
    argv = _map_words(rng) if rng.random() < 0.6 else _path_words(rng)
    return Case("workspaces", (*argv, *_form(rng)), {"robot.yaml": text}, seconds=10.0)


def _map_words(rng: Random) -> tuple[str, ...]:
    axes = rng.sample(_SOME, rng.choice((2, 2, 2, 2, 3, 1)))
    if rng.random() < 0.7:
        axes = [a for a in axes if a[0] != "q"] if rng.random() < 0.7 else [f"q{k + 1}" for k in range(len(axes))]
    ranges = (f"{a} {rng.choice(_RANGES[: rng.choice((2, 9))])}{_unit(rng, a)}" for a in axes)
    over = tuple(w for text in ranges for w in ("--over", text))
    at = rng.choice((None, None, "z=0.1", "yaw=5deg", "q3=0.1", "0 0 1", "x=nan"))
    limits = rng.choice((None, None, "q1 -5..5 deg", "actuators -1..1", "q1 ..0.2", "legs 1..2"))
    given = (("--at", at) if at else ()) + (("--limits", limits) if limits else ())
    more = rng.choice(((), ("-o", "m.svg"), ("-o", "m.ply"), ("--measure", "value")))
    return ("map", "robot.yaml", *over, *given, *more)


def _path_words(rng: Random) -> tuple[str, ...]:
    end = rng.choice(("z=0.1", "x=0.1, y=0.1, z=0.2", "z=0.2, roll=5deg, pitch=-5deg", "yaw=40deg, x=0, y=0", "z=9"))
    return ("path", "robot.yaml", "--at", "home", "--at", end, "--samples", rng.choice(("2", "5", "0")))


def _unit(rng: Random, axis: str) -> str:
    usual = " deg" if axis in ("roll", "pitch", "yaw", "rx") else rng.choice(("", " deg")) if axis[0] == "q" else ""
    return usual if rng.random() < 0.95 else rng.choice((" deg", "", " mm"))


def catalogs(rng: Random) -> Case:
    text = rng.choice(corpus("catalogs"))
    words = (
        "mine-1",
        "readings",
        "statement",
        "cofactor",
        "coefficient",
        "{planes}",
        "{Aab}",
        "{0}",
        "{x!r}",
        "four-planes",
        "lines",
        "3-3.3",
    )
    text = _broken(rng, text, words) if rng.random() < 0.95 else text
    kind = rng.choices(("show", "list", "analyze", "check"), (6, 2, 2, 0.02))[0]
    argv = {
        "show": ("catalog", "show", rng.choice(("mine-1", "mine-2", "mine-3", "3-3.3")), "--catalog", "c.yaml"),
        "list": ("catalog", "list", "--catalog", "c.yaml"),
        "check": ("catalog", "check", "--catalog", "c.yaml"),
        "analyze": (
            "analyze",
            rng.choice(("ab bc ca de fg hi", "Aa Ab Ac Bd Be Cg", "Aa Ab Ac Bd Be Cf")),
            "--search",
            "0",
            "--catalog",
            "c.yaml",
        ),
    }[kind]
    return Case("catalogs", (*argv, *_form(rng)), {"c.yaml": text}, seconds=30.0 if kind == "check" else 0.0)


def tables(rng: Random) -> Case:
    """Tables of poses."""
    text = rng.choices(corpus("tables"), (4, 4, 2, 2, 1))[0]
    words = (
        ",",
        ";",
        "\t",
        "x",
        "y [mm]",
        "qw",
        "qx",
        "qy",
        "qz",
        "rx [deg]",
        "zyx1 [rad]",
        "[m]",
        '"',
        "#",
        "xyz1",
        " ",
        "nan",
    )
    text = _broken(rng, text, words) if rng.random() < 0.97 else text
    argv = ("path", "g.yaml", "--poses", "t.csv", "--samples", rng.choice(("2", "5", "20")), *_form(rng))
    return Case("tables", argv, {"g.yaml": corpus("platforms")[0], "t.csv": text})


@cache
def _analyzed() -> Any:
    from gcrules.mechanisms.analyze import analyze_legs

    return lru_cache(maxsize=8)(analyze_legs)


def run_table(case: Case, jail: Jail) -> Outcome:
    """The platform is nearly always the same one, and is analysed once."""
    from gcrules.mechanisms import six_legs

    analyzed = _analyzed()
    with patch.object(six_legs, "analyze_legs", analyzed):
        return run_command(case, jail)


GEOMETRY = Family("geometry", "geometry files, with poses, paths, maps, figures and reports", geometry, share=3, few=25)
ROBOTS = Family("robots", "robot files: shown, analysed, checked, posed", robots, share=3, few=25)
WORKSPACES = Family("workspaces", "robots of joints along paths and over maps", workspaces, few=8)
CATALOGS = Family("catalogs", "catalog files", catalogs)
TABLES = Family("tables", "tables of poses", tables, run_table, few=10)
