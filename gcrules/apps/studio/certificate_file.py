"""Certificates of answers of the panels, as files that other programs check."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping
from typing import Any

from gcrules.apps.studio.protocol.methods import METHODS
from gcrules.apps.studio.protocol.where_views import CertificateFile
from gcrules.apps.studio.subject import Subject
from gcrules.apps.studio.values import value
from gcrules.core.errors import InputError
from gcrules.core.files import file_name
from gcrules.poses.certificate_files import Certified, certificate_bytes
from gcrules.poses.plans.report import Plan

__all__ = ["certificate_file"]

_CHECKS: Mapping[str, tuple[str, str]] = {
    "path": ("check_plan.py", "computes the signs again that no way can change"),
    "map": ("check_map.py", "decides every cell anew"),
    "free": ("check_free.py", "proves the region anew, box by box"),
    "boxes": ("check_boxes.py", "proves the boxes anew, one by one"),
}
"""Of each method the program that checks its answers, and what this does."""


def certificate_file(subject: Subject, what: str, args: Mapping[str, Any]) -> CertificateFile:
    """The certificate of what a method answers with these arguments. Raises InputError for what is no such argument and
    for answers that have none, LimitReached where no program can check them.
    """
    found = value(what, subject, METHODS[what].check(args, "args"))
    program, does = _CHECKS[what]
    packed = certificate_bytes(_certified(found.plan if what == "path" else found), packed=True)
    return {
        "file": {
            "name": file_name(f"{subject.title} {what}", "json.gz"),
            "mime": "application/gzip",
            "data": b64encode(packed).decode(),
            "binary": True,
        },
        "check": f"`python checkers/{program} FILE` {does}; `gcrules checkers` writes the program.",
    }


def _certified(found: Any) -> Certified:
    if found is None or (isinstance(found, Plan) and found.outcome != "none"):
        raise InputError("a way has no certificate", hint="only that there is none has one")
    certified: Certified = found
    return certified
