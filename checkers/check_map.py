#!/usr/bin/env python3
r"""Recompute the cells of a map of gcrules: python checkers/check_map.py FILE.json[.gz]

It needs Python alone and shares no code with gcrules. From the file that `gcrules map ... --certificate FILE.json`
wrote it takes a platform on six legs and a grid of poses, and decides of each cell anew, slowly, whether all its poses
are regular (free), or one is singular (crossed). All cells between neighbouring nodes are there, with their boundaries,
so that they leave no gap. What it cannot decide is undecided.

A pose moves each point p of the platform to R (p - c) + c + t. It is singular where the determinant of the six rows
(f, m) is 0, f along a leg and m its moment about any point. Lengths of legs and their limits do not matter.

* Where no coordinate turns the platform, this determinant is expanded to a polynomial in whole numbers, counted in
  nodes, and factors that the file names are used if their product is that polynomial. A polynomial is between the least
  and the largest of its Bernstein coefficients: where these have one sign, it has no zero. Where it has both signs in
  a cell, or is 0 at a place, there is one. Nothing is rounded.
* Else a determinant with bounds decides, cut further where it has to be: `map_turns.py` says how. Where turns are
  quarter turns, values at nodes are exact.

Of a robot of joints it takes closed forms of the limbs, and decides which cells home's working mode reaches without a
singular pose, or does not reach: `map_joints.py` says how. Over the amounts of its actuators it closes the loops of the
joints, or holds the rods' lengths: `map_actuators.py` says how.

Exit codes: 0 all cells are as the file says, and none is undecided; 1 one is not; 2 the file is no certificate of a map
that is known here, or names another digest; 3 cells are undecided, by the file or here, the others are as it says.
All this is recomputed, not proved in Coq.
"""

from __future__ import annotations

import sys
from itertools import product

from certificate_bounds import Refused
from map_actuators import DRIVEN, checked_driven
from map_cells import counted, listed_cells, named
from map_files import answered, check_digest
from map_joints import FORMAT, checked_joints
from map_polynomials import Polynomial, in_whole_numbers, parts_of, superbracket
from map_slice import Slice, expect
from map_turns import Turned

WORDS = {"f": "free", "x": "crossed", "u": "undecided"}
DEPTH = {True: 14, False: 6}  # halvings of a cell, where the determinant is a polynomial and where not
PARTS = {True: 3_000, False: 600}  # of a cell at once
OF_JOINTS = {FORMAT: checked_joints, DRIVEN: checked_driven}


def status(one, cell, is_exact):
    """f where a function has no zero in a cell, x where it has one, u where neither is seen."""
    sizes, signs, boxes = (1,) * len(cell), set(), [cell]
    for depth in range(DEPTH[is_exact] + 1):
        places = {tuple(a + b for a, b in zip(box, d)) for box in boxes for d in product((0, 1), repeat=len(cell))}
        for place in sorted(places) if depth < 3 or is_exact else ():
            found = one.corner(depth, place)
            if found == 0:
                return "x"
            signs.add(found)
            if {1, -1} <= signs:
                return "x"
        left = []
        for box in boxes:
            found = one.sign(depth, box, sizes)
            if found:
                signs.add(found)
            else:
                left.append(box)
        if {1, -1} <= signs:
            return "x"
        if not left:
            return "f"
        boxes = [tuple(2 * a + b for a, b in zip(box, d)) for box in left for d in product((0, 1), repeat=len(cell))]
        if len(boxes) > PARTS[is_exact]:
            break
    return "u"


def cells_of(one, shape, is_exact, say=None):
    """The status of each cell for one function, by its lower node; free ones are left out."""
    found, waiting, count = {}, [((0,) * len(shape), shape)], 0
    while waiting:
        low, width = waiting.pop()
        count += 1
        if say and count % 2000 == 0:
            say(f"{count:,} blocks of cells looked at")
        if one.sign(0, low, width):
            continue
        k = width.index(max(width))
        if width[k] == 1:
            what = status(one, low, is_exact)
            if what != "f":
                found[low] = what
            continue
        half = width[k] // 2
        for start, size in ((0, half), (half, width[k] - half)):
            waiting.append(((*low[:k], low[k] + start, *low[k + 1 :]), (*width[:k], size, *width[k + 1 :])))
    return found


def checked(data, say=None):
    """What is proved, in words, and how many cells are left undecided, by the file or here. Raises Refused."""
    if data.get("format") in OF_JOINTS:
        return OF_JOINTS[data["format"]](data, say)
    s = Slice(data)
    check_digest(data)
    counts = counted(listed_cells(data["cells"], s.shape, WORDS), data["claim"], WORDS)
    if s.kind:
        expect(data["factors"] is None, "factors, on a slice that is no polynomial")
        things, how = [Turned(s)], "in floats, with bounds of all that they leave out"
    else:
        p, how = superbracket(s), "in whole numbers, nothing rounded"
        listed = [] if data["factors"] is None else data["factors"]
        if p:
            things = [Polynomial(in_whole_numbers(f)) for f in (parts_of(s, listed, p) if listed else [p])]
        else:
            expect(not listed, "factors of a superbracket that is 0")
            things = []
    found = {}
    for one in things:
        for place, what in cells_of(one, s.shape, not s.kind, say).items():
            found[place] = "x" if "x" in (what, found.get(place)) else what
    zero = not s.kind and not things
    more, unseen = {"f": 0, "x": 0, "u": 0}, dict.fromkeys(WORDS.values(), 0)
    for place, letter in listed_cells(data["cells"], s.shape, WORDS):
        what = "x" if zero else found.get(place, "f")
        if letter == "u":
            more[what] += 1
        elif what == "u":
            unseen[WORDS[letter]] += 1
        elif what != letter:
            raise Refused(f"the cell {named(s.axes, place)} is called {WORDS[letter]}, and it is {WORDS[what]}")
    left = counts["undecided"]
    seen = f" (of which {more['f']} are free and {more['x']} crossed, as is seen here)" if left else ""
    lines = [
        f"recomputed: {counts['free'] - unseen['free']:,} cells free, "
        + f"{counts['crossed'] - unseen['crossed']:,} crossed, undecided: {f'{left:,}{seen}' if left else 'none'}",
        *(
            f"NOT decided here: {n:,} cells that are called {word}; nothing speaks against it, and nothing for it"
            for word, n in unseen.items()
            if n
        ),
        "  free: no pose is singular; crossed: some pose is; the cells cover the slice",
        f"  {how}; recomputed, not proved in Coq; limits of legs are not considered",
        *(f"  {line}" for line in s.words()),
        f"digest {data['digest']}",
    ]
    return "\n".join(lines), left + sum(unseen.values())


def main():
    return answered("Recompute the cells of a map of gcrules.", checked, tuple(OF_JOINTS))


if __name__ == "__main__":
    sys.exit(main())
