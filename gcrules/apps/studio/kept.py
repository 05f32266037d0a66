"""Answers that are needed twice, for a panel of the page and for its report, are computed once."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import update_wrapper
from typing import Concatenate, ParamSpec, TypeVar

from gcrules.apps.studio.subject import Subject

__all__ = ["kept"]

P = ParamSpec("P")
R = TypeVar("R")

_MOST = 3  # of each kind; a fine surface takes some megabytes


def kept(compute: Callable[Concatenate[Subject, P], R]) -> Callable[Concatenate[Subject, P], R]:
    """The function with its last results, which are frozen values; its arguments are what JSON holds."""
    known: dict[str, R] = {}

    def recalled(subject: Subject, /, *args: P.args, **kwargs: P.kwargs) -> R:
        key = json.dumps([subject.source, args, kwargs], sort_keys=True)
        found = known.pop(key) if key in known else compute(subject, *args, **kwargs)
        known[key] = found  # the latest stand last
        while len(known) > _MOST:
            known.pop(next(iter(known)))
        return found

    return update_wrapper(recalled, compute)
