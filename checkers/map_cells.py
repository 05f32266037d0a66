"""The letters of a map's cells in a certificate, read strictly, for `check_map.py`, which explains them."""

from __future__ import annotations

from certificate_bounds import Refused
from map_slice import MOST_CELLS, expect, whole


def listed_cells(rows, shape, words):
    """All letters of a file, by the lower nodes of cells; `words` are the letters that there are."""
    expect(
        isinstance(rows, str if len(shape) == 1 else list) and len(rows) == shape[0], "cells are missing, or too many"
    )
    for k, row in enumerate(rows):
        if len(shape) > 1:
            for place, letter in listed_cells(row, shape[1:], words):
                yield (k, *place), letter
        else:
            expect(row in words, f"a cell that is none of {', '.join(words)}")
            yield (k,), row


def counted(letters, claim, words):
    """How many cells are what, by the words of letters. Raises Refused where the claim says another number."""
    counts = dict.fromkeys(words.values(), 0)
    for _, letter in letters:
        counts[words[letter]] += 1
    expect(isinstance(claim, dict) and set(claim) == set(counts), "no claim")
    if any(whole(claim[n], 0, MOST_CELLS) != counts[n] for n in counts):
        raise Refused("the numbers claimed are not those of the cells")
    return counts


def named(axes, place):
    """A cell by its ranges."""
    ends = (f"{a.name} {a.start + k * a.step}..{a.start + (k + 1) * a.step} {a.unit}" for a, k in zip(axes, place))
    return ", ".join(words.strip() for words in ends)
