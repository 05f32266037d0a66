"""What can be taken away: the report, the derivation, figures, data, the file of the robot."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable, Mapping, Sequence

from gcrules.apps.studio.numbers import numbers
from gcrules.apps.studio.posed import analysis_of, analysis_there, drawing_there, file_there
from gcrules.apps.studio.protocol.answer_views import Saved
from gcrules.apps.studio.protocol.report_requests import StateJson
from gcrules.apps.studio.protocol.requests import Format, PoseJson
from gcrules.apps.studio.standing import report_there
from gcrules.apps.studio.subject import Subject
from gcrules.core.errors import InputError
from gcrules.core.files import file_name
from gcrules.mechanisms.proofs import proof_file
from gcrules.poses.compiling.controller import controller_of
from gcrules.views.code.source_code import source_code
from gcrules.views.drawing.drawing_files import pdf_bytes

__all__ = ["saved"]

Bytes = Callable[[Subject, PoseJson, str | None], str | bytes]


def saved(
    subject: Subject,
    pose: PoseJson,
    what: Format,
    threshold: str | None,
    state: StateJson | None = None,
    folders: Sequence[str] = (),
) -> Saved:
    """A file in this format; a `state` goes into the report. Raises InputError where the subject has none."""
    mime, make = _MAKERS[what]
    if state is None:
        found = make(subject, pose, threshold)
    else:
        found = report_there(subject, pose, threshold, state, folders)
    binary = isinstance(found, bytes)
    data = base64.b64encode(found).decode() if isinstance(found, bytes) else found
    return {"name": file_name(subject.title, _ENDINGS.get(what, what)), "mime": mime, "data": data, "binary": binary}


# --- formats -------------------------------------------------------------------------------------------------------


def _html(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return report_there(subject, pose, threshold)


def _latex(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return subject.robot.latex() if subject.robot else analysis_there(subject, pose).latex()


def _svg(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return drawing_there(subject, pose).svg()


def _pdf(subject: Subject, pose: PoseJson, threshold: str | None) -> bytes:
    return pdf_bytes(drawing_there(subject, pose))


def _png(subject: Subject, pose: PoseJson, threshold: str | None) -> bytes:
    raise InputError("a PNG picture is taken of the view itself", hint="the page makes it; or take SVG, PDF")


def _json(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    found = (subject.robot or analysis_of(subject)).to_json()
    here = numbers(subject, pose, threshold)
    return json.dumps({**found, "studio_pose": here}, indent=2, ensure_ascii=False) + "\n"


def _yaml(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return file_there(subject, pose)


def _proof(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    """The theorems of the analysis; they are the same for every pose."""
    return proof_file(subject.robot or analysis_of(subject)).json_text()


def _coq(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
    return proof_file(subject.robot or analysis_of(subject)).coq()


def _code(language: str) -> Bytes:
    """Factors, margin and inverse kinematics for a controller, from home; they are the same for every pose."""

    def make(subject: Subject, pose: PoseJson, threshold: str | None) -> str:
        return source_code(controller_of(subject.mechanism), language)

    return make


_ENDINGS: Mapping[Format, str] = {"latex": "tex", "proof": "proof.json", "coq": "v"}
_MAKERS: Mapping[Format, tuple[str, Bytes]] = {
    "html": ("text/html", _html),
    "latex": ("application/x-tex", _latex),
    "svg": ("image/svg+xml", _svg),
    "pdf": ("application/pdf", _pdf),
    "png": ("image/png", _png),
    "json": ("application/json", _json),
    "yaml": ("application/yaml", _yaml),
    "proof": ("application/json", _proof),
    "coq": ("text/plain", _coq),
    "c": ("text/plain", _code("c")),
    "cpp": ("text/plain", _code("cpp")),
    "py": ("text/plain", _code("python")),
    "rs": ("text/plain", _code("rust")),
}
