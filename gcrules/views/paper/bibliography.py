"""The works that a section cites, as BibTeX, and how gcrules itself is cited."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files

from gcrules.core.version import __version__

__all__ = ["OWN_KEY", "cited_in", "own_entry", "references"]

OWN_KEY = "gcrules"
_TITLE = "{gcrules}: {Grassmann--Cayley} algebra for the singularities of parallel robots"
_FIELD = re.compile(r"(\w+)\s*=\s*\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}")
_ENTRY = re.compile(r"^@(\w+)\{(\w+),(.*?)\}\}$", re.MULTILINE | re.DOTALL)
_OWN_NOTES = ("note",)  # what was consulted is of no interest in a paper


def own_entry() -> str:
    """gcrules of this version as a BibTeX entry."""
    fields = {"author": "{The gcrules developers}", "title": _TITLE, "note": f"Version {__version__}"}
    return _written("misc", OWN_KEY, fields)


def references(keys: Iterable[str]) -> str:
    """BibTeX entries of these works, gcrules last; keys that are none of the bibliography are left out."""
    known = _works()
    return "\n\n".join([*(_written(known[k][0], k, known[k][1]) for k in keys if k in known), own_entry()]) + "\n"


def cited_in(words: str) -> tuple[str, ...]:
    """The keys of the bibliography that stand in the source of a robot."""
    return tuple(dict.fromkeys(w for w in re.findall(r"\w+", words) if w in _works()))


@cache
def _works() -> Mapping[str, tuple[str, Mapping[str, str]]]:
    """Key: kind and fields."""
    source = files("gcrules").joinpath("references.bib").read_text(encoding="utf-8")
    found = {}
    for kind, key, body in _ENTRY.findall(source):
        fields = {name: value for name, value in _FIELD.findall(body + "}") if name not in _OWN_NOTES}
        if eprint := fields.pop("eprint", ""):
            fields["note"] = f"arXiv:{eprint}"
        found[key] = kind, fields
    return found


def _written(kind: str, key: str, fields: Mapping[str, str]) -> str:
    body = ",\n".join(f"  {name} = {{{' '.join(value.split())}}}" for name, value in fields.items())
    return f"@{kind}{{{key},\n{body}\n}}"
