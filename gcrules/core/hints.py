r"""Advice on what was probably meant.

>>> run_together("xy", ("x", "y", "z")), run_together("xw", ("x", "y", "z"))
(('x', 'y'), None)
>>> number_with_unit("650 mm"), number_with_unit("mm")
(('650', 'mm'), None)
"""

from __future__ import annotations

import os
import re
from collections.abc import Collection
from difflib import get_close_matches
from itertools import islice

__all__ = ["files_like", "near", "number_with_unit", "run_together"]

_QUANTITY = re.compile(r"\s*([-+]?[0-9]*\.?[0-9]+(?:[eE][-+]?[0-9]+)?(?:/[0-9]+)?)\s*([A-Za-zµ°\"']+)\s*")
_MOST_FILES = 2000  # of a folder
_ALIKE = 0.7


def near(word: str, words: Collection[str]) -> str | None:
    """A hint that names the words like this one, or None: "did you mean legs?"."""
    found = get_close_matches(word, sorted(words), n=2, cutoff=0.5 if len(word) < 4 else 0.6)
    found = found or [w for w in sorted(words) if w.casefold() == word.casefold()][:2]
    return f"did you mean {' or '.join(found)}?" if found else None


def run_together(word: str, names: Collection[str]) -> tuple[str, ...] | None:
    """The names that a word is made of, two or more, each once, the longest first; None where there are no such."""
    found: list[str] = []
    rest = word
    while rest:
        name = max((n for n in names if rest.startswith(n) and n not in found), key=len, default=None)
        if name is None:
            return None
        found.append(name)
        rest = rest[len(name) :]
    return tuple(found) if len(found) > 1 else None


def number_with_unit(text: str) -> tuple[str, str] | None:
    """The number and the word behind it, as in "650 mm"; None for anything else."""
    found = _QUANTITY.fullmatch(text)
    return (found[1], found[2]) if found else None


def files_like(path: str) -> str | None:
    """A hint for a file that is not there: the names most like it in its folder, else in the folders inside; or that
    the folder is not there either.
    """
    folder, name = os.path.split(path)
    if folder and not os.path.isdir(folder):
        return f"there is no folder {folder}"
    here = _inside(folder)
    found = get_close_matches(name, [n for n, is_folder in here if not is_folder], n=2, cutoff=_ALIKE)
    if not found:
        folders = [n for n, is_folder in here if is_folder]
        inside = [(n, m) for n in folders for m, is_folder in _inside(os.path.join(folder, n)) if not is_folder]
        below = [os.path.join(n, m) for n, m in inside]
        names = get_close_matches(name, {os.path.basename(b) for b in below}, n=2, cutoff=_ALIKE)
        found = [next(b for b in below if os.path.basename(b) == n) for n in names]
    return f"did you mean {' or '.join(os.path.join(folder, n) for n in found)}?" if found else None


def _inside(folder: str) -> list[tuple[str, bool]]:
    """What is in a folder, and whether it is a folder itself; hidden files and what cannot be read are left out."""
    try:
        with os.scandir(folder or os.curdir) as entries:
            some = islice((e for e in entries if not e.name.startswith(".")), _MOST_FILES)
            return sorted((e.name, e.is_dir()) for e in some)
    except OSError:
        return []
