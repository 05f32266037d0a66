"""The proofs of an analysis as a section of its report: how many theorems, their digest, and the file itself."""

from __future__ import annotations

from html import escape

from gcrules.conditions.analysis import Analysis
from gcrules.core.digests import beginning
from gcrules.core.english import counted
from gcrules.core.files import file_name
from gcrules.mechanisms.conditions.robot_analysis import RobotAnalysis
from gcrules.mechanisms.proofs import proof_file_or_none
from gcrules.views.report.carried_files import carried_html

__all__ = ["proof_html"]

_MOST = 200_000
"""Bytes of a proof file that a page carries."""


def proof_html(a: Analysis | RobotAnalysis) -> str:
    """Empty where nothing is proved of which a file can be written."""
    file = proof_file_or_none(a)
    if file is None:
        return ""
    name, data = file_name(file.title, "proof.json"), file.json_text().encode()
    link = carried_html(name, "application/json", data, most=_MOST)
    without = "".join(f"<p>Not proved there: {escape(str(one))}.</p>" for one in file.left_out)
    return (
        f"<h2>Proofs that others check</h2><p>{counted(len(file.theorems), 'theorem')} in a proof file, SHA-256 digest"
        f" <code>{beginning(file.digest)}</code>…; <code>python checkers/check_proof.py FILE</code> checks them without"
        f" gcrules, with the program that <code>gcrules checkers</code> writes.</p>{without}<p>{link}</p>"
    )
