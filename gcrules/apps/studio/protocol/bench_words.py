"""Words of the language and what they mean, for the bench: those that the prompt helps with."""

from __future__ import annotations

from gcrules.algebra.language.letter_words import CONSTRUCTION_NAMES
from gcrules.apps.repl.tables import COMMANDS, OPERATIONS, QUESTIONS, RELATIONS, STATEMENTS, WORDS

__all__ = ["BENCH_COMMANDS", "BENCH_CONSTRUCTIONS", "BENCH_OPERATIONS", "BENCH_RELATIONS", "BENCH_WORDS"]

BENCH_COMMANDS = QUESTIONS
"""The commands of the prompt that work on the bench, where none of them opens a file."""

BENCH_WORDS = (
    *((word, usage, line) for word, (usage, line) in STATEMENTS.items()),
    *((word, usage, meaning) for word, (usage, meaning) in WORDS.items()),
    *((f":{name}", COMMANDS[name].usage, COMMANDS[name].help) for name in BENCH_COMMANDS),
)
"""Each with how it is written and what it is."""

BENCH_OPERATIONS = OPERATIONS
"""How an operation is written, and what it is; from the tightest to the loosest."""

BENCH_CONSTRUCTIONS = CONSTRUCTION_NAMES
"""The words of expressions that have arguments."""

BENCH_RELATIONS = RELATIONS
"""The words that may begin an assumption."""
