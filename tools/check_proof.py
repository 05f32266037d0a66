#!/usr/bin/env python3
r"""Check the theorems of a proof file of gcrules: python tools/check_proof.py FILE.json[.gz] [--show]

It needs Python alone and shares no code with gcrules. Of each theorem it prints the claim as it reads it, expands both
sides by the definitions, subtracts the relations that the file gives with their multipliers, and says yes only where
nothing is left. What it relies on, and nothing else:

* a bracket of rank d is the determinant of the homogeneous coordinates of d points: it changes its sign where two of
  them change places, vanishes where two are the same, and where all are at infinity (last coordinate 0);
* the join of points is their exterior product, a bracket that of full step;
* the meet of extensors A = a1 ... ak and B of step h is the sum over all splits of A into d - h points P and the
  others Q, in their order: sign [P B] Q, and A ^ B is (-1)^((d-k)(d-h)) B ^ A, which here is split where that gives
  fewer terms (the Grassmann-Cayley algebra of Doubilet, Rota and Stein);
* the superbracket of six lines is the determinant of their coordinates 12, 13, 14, 23, 24, 34: the formula in brackets
  that is used here is compared with it at all 46,656 choices of six basis lines, when it is first used; in the plane
  the superbracket of three lines is their meet;
* the exchange relation: [S][T] is the sum of all products in which the first k points of S change places with k of T;
* an extensor of step k is zero exactly if its brackets with any d - k further points are zero.

Exit codes: 0 all theorems are proved, 1 one is not (its name, and what is left), 2 the file is no proof file.
"""

from __future__ import annotations

import argparse
import gzip
import json
import sys
from fractions import Fraction
from functools import cache
from itertools import combinations, product
from math import comb

MOST = 5_000_000  # terms that an expansion may have


class Refused(Exception):
    """The file is no proof file."""


class NotProved(Exception):
    """A theorem does not follow from what the file gives."""


def expect(condition, what):
    if not condition:
        raise Refused(what)


# --- signs ------------------------------------------------------------------------------------------------------------


def in_order(points):
    """The sign of a bracket's rearrangement into increasing order, and that order; 0 where a point stands twice."""
    sign = 1
    for i, x in enumerate(points):
        for y in points[:i]:
            sign = 0 if x == y else -sign if x < y else sign
            if not sign:
                return 0, ()
    return sign, tuple(sorted(points))


@cache
def splits(length, first):
    """Sign, places of the first part, places of the rest, of every split."""
    found = []
    for chosen in combinations(range(length), first):
        rest = tuple(i for i in range(length) if i not in chosen)
        found.append((in_order(chosen + rest)[0], chosen, rest))
    return found


# --- polynomials: {monomial: coefficient}, a monomial being the sorted tuple of its brackets --------------------------


def plus(a, b, factor=1):
    total = dict(a)
    for m, c in b.items():
        value = total.get(m, 0) + factor * c
        if value:
            total[m] = value
        else:
            total.pop(m, None)
    return total


def times(a, b):
    expect(len(a) * len(b) <= MOST, "an expansion is too long for this checker")
    total = {}
    for m, c in a.items():
        for n, k in b.items():
            key = tuple(sorted(m + n))
            total[key] = total.get(key, 0) + c * k
    return {m: c for m, c in total.items() if c}


def bracket(points, ideal):
    """A bracket as a polynomial."""
    sign, row = in_order(points)
    return {(row,): sign} if sign and row[-1] >= ideal else {}


def exchanged(first, second, number, ideal):
    """[first][second] less the products in which the first `number` points of `first` change places."""
    difference = times(bracket(first, ideal), bracket(second, ideal))
    for chosen in combinations(range(len(second)), number):
        row = list(second)
        for x, i in zip(first[:number], chosen, strict=True):
            row[i] = x
        other = [second[i] for i in chosen] + first[number:]
        difference = plus(difference, times(bracket(row, ideal), bracket(other, ideal)), -1)
    return difference


# --- the superbracket of six lines ------------------------------------------------------------------------------------


# In the ends a b | c d | e f | g h | i j | k l of the lines (McMillan and White).
TERMS = """
-abcd efgi hjkl +abcd efhi gjkl +abcd efgj hikl -abcd efhj gikl +abce dfgh ijkl -abde cfgh ijkl
-abcf degh ijkl +abdf cegh ijkl -abce dghi fjkl +abde cghi fjkl +abcf dghi ejkl +abce dghj fikl
-abdf cghi ejkl -abde cghj fikl -abcf dghj eikl +abdf cghj eikl +abcg defi hjkl -abdg cefi hjkl
-abch defi gjkl -abcg defj hikl +abdh cefi gjkl +abdg cefj hikl +abch defj gikl -abdh cefj gikl
"""


@cache
def superbracket_terms():
    """The formula, once it has been compared with the determinant at all choices of basis lines."""
    words = TERMS.split()
    terms = [
        (-1 if first[0] == "-" else 1, [["abcdefghijkl".index(x) for x in row] for row in (first[1:], *others)])
        for first, *others in zip(words[::3], words[1::3], words[2::3], strict=True)
    ]
    lines = list(combinations(range(4), 2))
    for choice in product(range(6), repeat=6):
        ends = [e for line in choice for e in lines[line]]
        value = 0
        for sign, rows in terms:
            for row in rows:
                sign *= in_order([ends[e] for e in row])[0]
                if not sign:
                    break
            value += sign
        if value != in_order(choice)[0]:
            raise AssertionError(f"the formula of the superbracket is wrong at {choice}")
    return terms


# --- expressions ------------------------------------------------------------------------------------------------------


class Reader:
    """Reads expressions and expands them: {points of an extensor: polynomial}, () for a scalar."""

    def __init__(self, theorem):
        self.rank = theorem["rank"]
        self.points = theorem["points"]
        self.ideal = theorem["ideal"]
        expect(isinstance(self.rank, int) and 2 <= self.rank <= 12, "the rank is no number from 2 to 12")
        expect(isinstance(self.points, list) and all(isinstance(p, str) for p in self.points), "points are not names")
        expect(len(set(self.points)) == len(self.points), "a point is named twice")
        expect(isinstance(self.ideal, int) and 0 <= self.ideal <= len(self.points), "`ideal` is no number of points")
        self.known = {p: (1, {(i,): {(): 1}}) for i, p in enumerate(self.points)}
        self.shown = {}
        for name, e in theorem["definitions"]:
            expect(isinstance(name, str) and name not in self.known, f"{name} is defined twice")
            self.known[name] = self.read(e)
            self.shown[name] = self.text(e)

    def read(self, e):
        """Step and value."""
        if isinstance(e, str):
            expect(e in self.known, f"{e} is not defined")
            return self.known[e]
        expect(isinstance(e, list) and len(e) > 1 and e[0] in OPERATIONS, f"no expression: {e!r}"[:200])
        if e[0] == "number":
            value = number(e[1])
            return 0, {(): {(): value}} if value else {}
        if e[0] == "power":
            expect(len(e) == 3 and isinstance(e[2], int) and 2 <= e[2] <= 64, "a power needs an exponent from 2 to 64")
            return self.product([self.read(e[1])] * e[2])
        return getattr(self, e[0])([self.read(part) for part in e[1:]])

    def sum(self, parts):
        steps = {step for step, value in parts if value}
        expect(len(steps) < 2, "a sum of unlike steps")
        total = {}
        for _, value in parts:
            for row, p in value.items():
                total[row] = plus(total.get(row, {}), p)
        return max(step for step, _ in parts), {row: p for row, p in total.items() if p}

    def product(self, parts):
        expect(sum(step > 0 for step, _ in parts) < 2, "a product of two extensors")
        return self.join(parts)

    def join(self, parts):
        step, value = parts[0]
        for further, other in parts[1:]:
            step += further
            expect(step <= self.rank, "a join beyond the rank")
            joined = {}
            for r, p in value.items():
                for s, q in other.items():
                    sign, row = in_order(r + s)
                    if sign:
                        joined[row] = plus(joined.get(row, {}), times(p, q), sign)
            value = {row: p for row, p in joined.items() if p}
        return step, value

    def bracket(self, parts):
        step, value = self.join(parts)
        expect(step == self.rank, "a bracket that is not full")
        total = {}
        for row, p in value.items():
            total = plus(total, times(p, bracket(row, self.ideal)))
        return 0, {(): total} if total else {}

    def meet(self, parts):
        step, value = parts[0]
        for further, other in parts[1:]:
            expect(step + further >= self.rank, "a meet of extensors that are too small")
            met = {}
            for r, p in value.items():
                for s, q in other.items():
                    split, whole, outer = r, s, 1
                    if comb(len(s), self.rank - len(r)) < comb(len(r), self.rank - len(s)):
                        split, whole, outer = s, r, (-1) ** ((self.rank - len(r)) * (self.rank - len(s)))
                    for sign, first, rest in splits(len(split), self.rank - len(whole)):
                        closed = bracket([split[i] for i in first] + list(whole), self.ideal)
                        row = tuple(split[i] for i in rest)
                        met[row] = plus(met.get(row, {}), times(times(p, q), closed), outer * sign)
            step += further - self.rank
            value = {row: p for row, p in met.items() if p}
        return step, value

    def superbracket(self, parts):
        expect(all(step == 2 for step, _ in parts), "a superbracket of what is no line")
        expect(len(parts) == self.rank * (self.rank - 1) // 2, "a superbracket of too many or too few lines")
        if self.rank == 2:
            return self.bracket(parts)
        if self.rank == 3:  # in the plane the determinant of three lines is their meet
            return self.meet(parts)
        expect(self.rank == 4, "a superbracket of rank 5 or more, which this checker does not know")
        total = {}
        for choice in product(*(value.items() for _, value in parts)):
            ends = [x for row, _ in choice for x in row]
            coefficient = {(): 1}
            for _, p in choice:
                coefficient = times(coefficient, p)
            for sign, rows in superbracket_terms():
                term = {(): sign}
                for row in rows:
                    term = times(term, bracket([ends[e] for e in row], self.ideal))
                total = plus(total, times(coefficient, term))
        return 0, {(): total} if total else {}

    def text(self, e):
        """What an expression says."""
        if isinstance(e, str):
            return self.shown.get(e, e)
        parts = [str(part) if isinstance(part, int) else self.text(part) for part in e[1:]] if e[0] != "number" else []
        match e[0]:
            case "number":
                return str(e[1])
            case "bracket":
                return f"[{' '.join(parts)}]"
            case "superbracket":
                return f"[[{', '.join(parts)}]]"
        return f"({OPERATIONS[e[0]].join(parts)})"


OPERATIONS = {
    "number": "",
    "bracket": "",
    "superbracket": "",
    "join": " v ",
    "meet": " ^ ",
    "sum": " + ",
    "product": " * ",
    "power": "**",
}


def number(value):
    try:
        expect(isinstance(value, (int, str)) and not isinstance(value, bool), f"no number: {value!r}")
        return Fraction(value)
    except (ValueError, ZeroDivisionError) as fault:
        raise Refused(f"no number: {value!r}") from fault


# --- theorems ---------------------------------------------------------------------------------------------------------


def difference(reader, claim):
    """Both sides' difference as one polynomial; extensors are closed by further points."""
    (left, a), (right, b) = map(reader.read, claim)
    expect(left == right or not a or not b, "the sides are of unlike steps")
    step = left if a else right
    n = len(reader.points)
    closing = tuple(range(n, n + reader.rank - step)) if step else None
    total = {}
    for value, factor in ((a, 1), (b, -1)):
        for row, p in value.items():
            total = plus(total, p if closing is None else times(p, bracket(row + closing, reader.ideal)), factor)
    return total


def check(theorem):
    """The claim as text. Raises NotProved where something is left."""
    expect(isinstance(theorem, dict), "a theorem is no object")
    missing = {"name", "rank", "points", "ideal", "definitions", "claim", "relations"} - set(theorem)
    expect(not missing, f"a theorem without {', '.join(sorted(missing))}")
    reader = Reader(theorem)
    expect(len(theorem["claim"]) == 2, "a claim has two sides")
    text = " == ".join(map(reader.text, theorem["claim"]))
    left = difference(reader, theorem["claim"])
    for first, second, count, multiplier in theorem["relations"]:
        expect(len(first) == len(second) == reader.rank and 0 < count <= reader.rank, "a relation of unlike brackets")
        relation = exchanged(first, second, count, reader.ideal)
        for coefficient, *rows in multiplier:
            rest = {(): number(coefficient)}
            for row in rows:
                expect(len(row) == reader.rank, "a bracket that is not full")
                rest = times(rest, bracket(row, reader.ideal))
            left = plus(left, times(rest, relation), -1)
    if left:
        raise NotProved(f"{len(left)} terms are left of {text}"[:2000])
    return text


def read(path):
    try:
        with (gzip.open if path.endswith(".gz") else open)(path, "rt", encoding="utf-8") as file:
            data = json.load(file)
    except (OSError, ValueError, RecursionError) as fault:
        raise Refused(f"{path}: {fault}") from fault
    expect(isinstance(data, dict) and data.get("format") == "gcrules proof", f"{path}: not a proof file of gcrules")
    expect(data.get("version") == 1, f"{path}: a version of the format that this checker does not know")
    expect(isinstance(data.get("theorems"), list) and data["theorems"], f"{path}: no theorems")
    return data


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Check the theorems of a proof file of gcrules.")
    parser.add_argument("file")
    parser.add_argument("--show", action="store_true", help="print each claim in full")
    asked = parser.parse_args(arguments)
    try:
        theorems = read(asked.file)["theorems"]
        for theorem in theorems:
            name = theorem.get("name") if isinstance(theorem, dict) else None
            try:
                claim = check(theorem)
            except NotProved as fault:
                print(f"NOT PROVED  {name}: {fault}")
                return 1
            except (TypeError, ValueError, KeyError, IndexError, RecursionError, AttributeError) as fault:
                raise Refused(f"{name}: malformed ({fault})") from fault
            print(f"proved  {name}: {claim if asked.show or len(claim) <= 160 else claim[:157] + '...'}")
    except Refused as fault:
        print(f"{asked.file}: {fault}" if asked.file not in str(fault) else fault, file=sys.stderr)
        return 2
    print(f"{len(theorems)} theorem{'s' if len(theorems) > 1 else ''} proved")
    return 0


if __name__ == "__main__":
    sys.exit(main())
