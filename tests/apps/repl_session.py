"""What is said to a session, and what it answers."""

from __future__ import annotations

from hypothesis import strategies as st

from gcrules.apps.repl.interpreter import Interpreter
from gcrules.apps.repl.tables import COMMANDS, RELATIONS, RULE_WORDS, STATEMENTS

__all__ = ["MEET", "TEXTS", "said"]
MEET = r"rule meet: ab /\ cde => [acde] b - [bcde] a"


def said(repl: Interpreter, text: str) -> list[str]:
    return [a.text for a in repl.feed(text)]


TEXTS = st.one_of(
    st.text(),
    st.text(alphabet='ab[]()/\\∧∨%:=+-*2"#., \nletclaimshowgivenrulerank'),
    st.lists(
        st.sampled_from(
            [
                *(*STATEMENTS, *RULE_WORDS, *RELATIONS),
                *(f":{c}" for c in COMMANDS if c not in ("save", "load")),
                *(
                    "%",
                    "%%",
                    "a",
                    "ab",
                    "[abcd]",
                    "/\\",
                    "+",
                    "==",
                    "=",
                    "=>",
                    "(",
                    ")",
                    "[",
                    ",",
                    "\n",
                    "3",
                    '"x"',
                    ":",
                    ".",
                ),
            ]
        ),
        max_size=12,
    ).map(" ".join),
)
