r"""Manual mode: the user proposes forms, entities and a condition; each is confirmed or refused with the reason.

A `ManualSession` is a frozen value; each proposal gives a new one. `session.outcome` is the last answer, a
`ProposalOutcome` with `answer` (confirmed, refused, or possible for a trial that stands unproved), `reason` (a key of
`REASONS`), `words`, `formulas` and `data`; `session.board` is what stands (the form, the entities, the condition),
`session.history` all proposals with their answers.

>>> from gcrules.conditions.manual import ManualSession
>>> s = ManualSession.start("Aa Ab Ac Bd Ce Df").shortest().tetrahedron("Aabd")
>>> s.outcome.answer, s.outcome.reason, s.outcome.data["dividing"]
('refused', 'no-factor', (('A', 'a', 'b', 'c'),))
>>> s = s.tetrahedron("Aabc").plane("ABd").plane("ACe")
>>> s.left, str(s.hint().command)
(('D', 'f'), 'pair D f')
>>> print(s.pair("D f").condition().confirmed.expression)
[Aabc](ABd /\ ACe /\ Df)

The same proposals as text are the commands of the prompt, `session.do("plane ABd")`; `PROPOSALS` is their table.

| method | command | confirmed when |
|---|---|---|
| `order("2 1 3 4 6 5")`, `form(16)`, `shortest()` | the same | always; entities of another form are given up |
| `tetrahedron("Aabc")` | `tetrahedron Aabc` | the bracket stands in every term |
| `plane("Aab")` | `plane Aab` | every term has a bracket of its own with the three points, or they are left over |
| `line("AB")` | `line AB` | the same for two points |
| `pair("C c")`, `lines("Cc Dd")` | the same | P(x,y) + P(y,x) = 0 for left-over points, or by trial |
| `condition("abc /\\ …", "[ACac]")` | `condition abc /\ … cofactor [ACac]` | cofactor · superbracket = c · expression |
| `condition()` | `condition` | an incidence rule makes the condition of the entities |
| `undo()`, `redo()`, `auto()` | the same | |

What makes no sense (unknown points, wrong numbers of them, a repeated proposal) raises InputError with its place.
`hint()` is the next step of the automatic procedure, `to_json()` the whole session. `save_session` and `load_session`
write and replay a file, `analysis_of` gives all stages once a condition is confirmed.
"""

from gcrules.conditions.manual.analysis import analysis_of
from gcrules.conditions.manual.file import load_session, save_session
from gcrules.conditions.manual.outcome import REASONS, Hint, NamedValue, ProposalOutcome
from gcrules.conditions.manual.session import MOVES, PROPOSALS, ManualSession, Record

__all__ = [
    "MOVES",
    "PROPOSALS",
    "REASONS",
    "Hint",
    "ManualSession",
    "NamedValue",
    "ProposalOutcome",
    "Record",
    "analysis_of",
    "load_session",
    "save_session",
]
