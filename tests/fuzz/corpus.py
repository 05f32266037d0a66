"""Texts that mutations begin with: the project's own examples, and small ones made for this."""

from __future__ import annotations

from functools import cache
from pathlib import Path

__all__ = ["ROOT", "corpus"]

ROOT = Path(__file__).resolve().parents[2]

_PATTERNS = {
    "scripts": ("examples/*.gca", "examples/theorems/*.gca", "examples/theorems/false/*.gca"),
    "rules": ("plugins/*/*.gca",),
    "platforms": ("examples/*.yaml",),
    "robots": ("plugins/*/robot.yaml", "tests/data/robots/*.yaml"),
    "tables": ("examples/*.csv",),
}

_SESSION = """\
gcrules: session
version: 1
legs: [[a, b], [a, f], [c, b], [c, d], [e, d], [e, f]]
order: [1, 2, 3, 4, 5, 6]
form: 24
history:
  - {do: 'plane abc', answer: confirmed, reason: together}
  - {do: 'plane abd', answer: refused, reason: apart}
undone: []
"""
_PLATFORM = """\
units: mm
legs: [ab, af, cb, cd, ed, ef]
points:
  a: [0, -300, 0]
  c: [300, 200, 0]
  e: [-300, 200, 0]
  b: [150, -100, 350]
  d: [0, 150, 400]
  f: [-100, -150, 350]
"""
_CATALOG = """\
statements:
  four-planes: 'It is singular when {planes} meet.'
classes:
  - id: mine-1
    name: a class of mine
    legs: ab bc ca de fg hi
    condition:
      kind: linear-complex
      expression: '[[ab, bc, ca, de, fg, hi]]'
    sources: [somewhere]
    note: example
  - id: mine-2
    legs: Aa Ab Ac Bd Be Cg
    condition:
      kind: three-tetrahedra
      expression: '[Aabc][ABde][ABCg]'
      cofactor: '1'
      coefficient: 1
    readings:
      - kind: one-incidence
        expression: '[Aabc][ABde][ABCg]'
        statement: 'The tetrahedron {Aabc} is flat.'
        lines: {p: AB}
"""
_TABLES = (
    "x, y, z\n0, 0, 0\n0, 0, -10\n",
    "x [mm]; y [mm]; z [mm]\n0; 0; 0\n1,5; 0; -200\n",
    "x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n0,0,10,0.9,0.1,0,0\n",
    "x\ty\tz\trx [deg]\try [deg]\trz [deg]\n0\t0\t0\t0\t0\t0\n0\t0\t9\t10\t0\t0\n",
)
_MADE = {
    "tables": _TABLES,
    "sessions": (_SESSION,),
    "platforms": (_PLATFORM, _PLATFORM.replace("units: mm\n", "")),
    "catalogs": (_CATALOG,),
}


@cache
def corpus(name: str) -> tuple[str, ...]:
    """The texts of a kind, always in the same sequence."""
    paths = [path for pattern in _PATTERNS.get(name, ()) for path in sorted(ROOT.glob(pattern))]
    return (*_MADE.get(name, ()), *(path.read_text(encoding="utf-8") for path in paths))
