"""What is told of any result, for the page: its sentence, and its facts."""

from __future__ import annotations

from typing import Any

from gcrules.apps.studio.items import fact
from gcrules.apps.studio.protocol.study_views import AccountView
from gcrules.views.forms import shown
from gcrules.views.numerals import in_prose
from gcrules.views.results.result_account import Facts, ResultAccount, Sentences
from gcrules.views.results.robot_pose import signed

__all__ = ["account_view"]


def account_view(found: Any) -> AccountView:
    """The sentence, and the facts with the sentences between them."""
    told: ResultAccount = shown(found, "account")
    rows: list[tuple[str, str]] = []
    for block in told.blocks:
        if isinstance(block, Facts):
            rows += block.rows
        elif isinstance(block, Sentences):
            rows += [(name, words) for name, _, words in (line.partition(": ") for line in block.lines)]
    return {"verdict": in_prose(told.verdict), "facts": [fact(name, signed(words)) for name, words in rows]}
