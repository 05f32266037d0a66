"""The terms of the field as gcrules uses them: for the glossary of the guide, and for the words of the studio.

>>> print(markdown().splitlines()[0])
# Glossary
"""

from __future__ import annotations

import unicodedata
from importlib.resources import files

import yaml

__all__ = ["EVERYDAY", "GLOSSARY", "anchor", "markdown"]

_FILE = files("gcrules.views").joinpath("glossary.yaml")

GLOSSARY = tuple({"term": e["term"], "forms": "", **e} for e in yaml.safe_load(_FILE.read_text(encoding="utf-8")))
"""In the order of the alphabet. `forms` are other words for the same, between bars; `page` is a page of the guide."""

EVERYDAY = ("join", "joins", "meet", "value", "ε")
"""Words for terms that mean something else in most sentences: they are explained only where they are put as terms."""


def anchor(term: str) -> str:
    """Where the entry stands on the page.

    >>> anchor("Plücker coordinates")
    'plucker-coordinates'
    """
    plain = unicodedata.normalize("NFKD", term.lower()).encode("ascii", "ignore").decode()
    return plain.replace("'", "").replace(" ", "-")


def markdown() -> str:
    """The page of the guide."""
    rows = [
        f'<a id="{anchor(e["term"])}"></a>**{e["term"][0].upper()}{e["term"][1:]}**. '
        f"{e['meaning']} ([{e['guide']}]({e['page']}))"
        for e in GLOSSARY
    ]
    start = (
        "The terms as gcrules uses them. Each page of the guide links here where it first uses one, and the "
        "[studio](studio.md#words) shows the same explanations."
    )
    return "\n\n".join(["# Glossary", start, *rows]) + "\n"
