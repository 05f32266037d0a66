r"""File names for the pages of classes, whatever their ids are, that are good on every file system."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable

__all__ = ["page_names"]

_LONGEST = 60
_RESERVED = {"readme", "index", "con", "prn", "aux", "nul", *(f"{p}{i}" for p in ("com", "lpt") for i in range(10))}


def page_names(ids: Iterable[str]) -> dict[str, str]:
    """For each id the stem of its files: letters and digits of ASCII, `-`, `_` and `.`, different for different ids
    even where case is ignored. An id that is a good name already keeps it, whatever the others are.
    """
    found: dict[str, str] = {}
    taken = set(_RESERVED)
    ids = list(dict.fromkeys(ids))
    for good in (True, False):
        for class_id in (i for i in ids if i not in found):
            stem = _stem(class_id)
            if good and (stem != class_id or stem.casefold() in taken):
                continue
            name, number = stem, 2
            while name.casefold() in taken or name.partition(".")[0].casefold() in _RESERVED:
                name, number = f"{stem.replace('.', '-')}-{number}", number + 1
            taken.add(name.casefold())
            found[class_id] = name
    return {i: found[i] for i in ids}


def _stem(class_id: str) -> str:
    plain = "".join(c for c in unicodedata.normalize("NFKD", class_id) if not unicodedata.combining(c))
    cut = re.sub(r"-{2,}", "-", re.sub(r"[^A-Za-z0-9._-]", "-", re.sub(r"\.{2,}", "-", plain)))[:_LONGEST]
    return cut.strip("-._") or "class"
