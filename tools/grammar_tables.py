"""Write the tables of the parsers beside the grammar: to be run when `gcrules/grammar.lark` has changed."""

from __future__ import annotations

from pathlib import Path

from gcrules.algebra.language.grammar import TABLES, tables

if __name__ == "__main__":
    (Path(__file__).resolve().parent.parent / "gcrules" / TABLES).write_bytes(tables())
