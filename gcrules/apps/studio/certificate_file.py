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
from gcrules.poses.certificate_files import certificate_bytes
from gcrules.views.results.checkers import certified, check_of, kind_of

__all__ = ["certificate_file"]


def certificate_file(subject: Subject, what: str, args: Mapping[str, Any]) -> CertificateFile:
    """The certificate of what a method answers with these arguments. Raises InputError for what is no such argument and
    for answers that have none, LimitReached where no program can check them.
    """
    found = value(what, subject, METHODS[what].check(args, "args"))
    answer = found.plan if what == "path" else found
    if not certified(answer):
        raise InputError("a way has no certificate", hint="only that there is none has one")
    packed = certificate_bytes(answer, packed=True)
    return {
        "file": {
            "name": file_name(f"{subject.title} {kind_of(answer)}", "json.gz"),
            "mime": "application/gzip",
            "data": b64encode(packed).decode(),
            "binary": True,
        },
        "check": check_of(answer),
    }
