#!/usr/bin/env python3
r"""Check the theorems of a proof file of gcrules: python checkers/check_proof.py FILE.json

It needs Python alone and no code of gcrules, prints each claim as it reads it, expands both sides by the definitions,
subtracts multiples of the file's relations, and says yes only where nothing is left. It relies on:
* the join of points is their exterior product; that of d points in rank d, a bracket, is the determinant of homogeneous
  coordinates, which changes sign with each exchange and vanishes where all are at infinity (last coordinate 0);
* the meet of A = a1 ... ak and B of step h is the sum over all splits of A into d - h points P and the others Q, in
  their order: sign [P B] Q (the Grassmann-Cayley algebra of Doubilet, Rota and Stein);
* the superbracket of six lines is the determinant of their coordinates 12, 13, 14, 23, 24, 34: its formula in brackets,
  which changes sign with a line's ends, is compared with it at all choices of basis lines; in the plane it is a meet;
  in rank d > 4 it is the determinant of coordinates in d points, times the (d - 1)th power of their bracket;
* the exchange relation: [S][T] is the sum of all products in which the first k points of S change places with k of T;
* joins and meets of points, and of sums that are points or hyperplanes, are extensors; one of step k is zero exactly
  when its brackets with any d - k further points are zero.

Under assumptions (`given`: what vanishes, `nonzero`: what does not) both sides are claimed to be equal wherever these
hold. Points are placed one after the other: X is `equal` to W, since X - W is a multiple of something given, or lies on
an extensor W, not zero, the join of parts P, and is the sum of a scalar times P, or of P ^ R with a join R of fresh
finite points. So they are expanded, and every position is reached:
* X lies on F where F v X vanishes or is a multiple of something given, as it stands or with the points before expanded,
  or where all of F v X lies on an extensor that is not zero and has no room for it; on A ^ B where it lies on both, and
  on A v R where it lies on A; X may be auxiliary: an expression in others (`meets`), which the claim does not name;
* a part of a join, meet or bracket that is not zero is not zero; (S v R) ^ T is not zero for some R where T is not, and
  S joined with points of T up to the step that R leaves is not;
* where W joins free points that, as X, were not bound before, W may be zero: dependent positions of them and X are an
  irreducible variety in which those with W not zero are dense, and later points add linear spaces of one dimension;
* where W joins d free points, X is any point: they are a basis at a dense set of positions.
Or there are `cases`, theorems that assume no more, and claim the same or that something vanishes that does not: where
an expression, the `split`, vanishes and where it does not; or, behind one that says that a product equals what does,
where each factor vanishes that may and is not the difference of the sides (a bracket that does for all points that the
first adds, or of `any`: where the join of the others does). A join, meet, bracket or product does where a part does.
Exit codes: 0 all theorems are proved, 1 one is not (its name, and what is left), 2 the file is no proof file."""

import hashlib
import json
import re
import sys
from collections import Counter
from fractions import Fraction
from functools import cache, reduce
from itertools import combinations, product
from math import comb

TERMS = """-abcdefgihjkl abcdefhigjkl abcdefgjhikl -abcdefhjgikl abcedfghijkl -abdecfghijkl -abcfdeghijkl abdfceghijkl
-abcedghifjkl abdecghifjkl abcfdghiejkl abcedghjfikl -abdfcghiejkl -abdecghjfikl -abcfdghjeikl abdfcghjeikl
abcgdefihjkl -abdgcefihjkl -abchdefigjkl -abcgdefjhikl abdhcefigjkl abdgcefjhikl abchdefjgikl -abdhcefjgikl"""
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*'*([₁-₉]{0,2}|[¹²³⁴⁵ᵃᵇᶜᵈ])(:[0-9]+)?|#[0-9]+")
SIGN = {"join": r" \/ ", "meet": r" /\ ", "sum": " + ", "product": " * ", "power": "**"}
BRACKETS = {"bracket": "[{}]", "superbracket": "[[{}]]"}


class NotProved(Exception): ...  # a theorem does not follow from what the file gives


def expect(condition, what, fault=ValueError):
    if not condition:
        raise fault(what)


def in_order(points):  # the sign of a bracket's rearrangement into this order, 0 where a point stands twice; the order
    if len({*points}) < len(points):
        return 0, ()
    return (-1) ** sum(x > y for x, y in combinations(points, 2)), tuple(sorted(points))


@cache
def splits(length, first):  # sign, places of the first part, places of the rest, of every split
    chosen = ((c, tuple(i for i in range(length) if i not in c)) for c in combinations(range(length), first))
    return [(in_order(c + rest)[0], c, rest) for c, rest in chosen]


def plus(a, b, factor=1):  # of polynomials {monomial: coefficient}, a monomial having its brackets and scalars in order
    total = dict(a)
    for m, c in b.items():
        total[m] = total.get(m, 0) + factor * c
    return {m: c for m, c in total.items() if c}


def times(a, b):
    expect(len(a) * len(b) <= 5_000_000, "an expansion is too long for this checker")
    total = {}
    for (m, c), (n, k) in product(a.items(), b.items()):
        key = tuple(sorted(m + n))
        total[key] = total.get(key, 0) + c * k
    return {m: c for m, c in total.items() if c}


def collected(terms):  # the sum of rows times polynomials times numbers, as {row: polynomial}
    total = {}
    for row, p, factor in terms:
        total[row] = plus(total.get(row, {}), p, factor)
    return {row: p for row, p in total.items() if p}


@cache
def superbracket_terms():  # in the lines' ends a b | c d | ... (McMillan and White), compared with the determinant
    signed = ((-1 if term[0] == "-" else 1, [*map("abcdefghijkl".index, term[-12:])]) for term in TERMS.split())
    terms = [(sign, [ends[i : i + 4] for i in (0, 4, 8)]) for sign, ends in signed]
    lines = list(combinations(range(4), 2))
    for choice in product(range(6), repeat=6):
        ends = [e for line in choice for e in lines[line]]
        of = (reduce(lambda s, row: s and s * in_order([ends[e] for e in row])[0], rows, sign) for sign, rows in terms)
        expect(sum(of) == in_order(choice)[0], f"the formula of the superbracket is wrong at {choice}", AssertionError)
    return terms


class Reader:  # reads expressions and expands them: a step, and {points of an extensor: polynomial}, () for a scalar
    def __init__(self, theorem, placed=None):  # else all but auxiliary points are read as points of their own
        self.rank, self.ideal, self.placed, self.meets = theorem["rank"], theorem["ideal"], placed or {}, {}
        self.points, self.definitions = list(theorem["points"]), dict(theorem["definitions"])
        if placed is None:
            self.meets = dict(theorem.get("meets", ()))
            every = [*self.points, *theorem["any"], *(p["name"] for p in theorem["placed"])]
            self.points = [n for n in every if n not in self.meets]
        names = [*self.points, *self.definitions, *self.meets]
        expect(type(self.rank) is int and 2 <= self.rank <= 12, "the rank is no number from 2 to 12")
        expect(all(map(NAME.fullmatch, names)) and len({*names}) == len(names), "names that are none, or not different")
        expect(type(self.ideal) is int and 0 <= self.ideal <= len(theorem["points"]), "`ideal` is no number of points")
        self.known = {p: (1, {(i,): {(): 1}}) for i, p in enumerate(self.points)}

    def open(self, e):  # what a definition, or a join of one part, stands for
        known = e[1] if type(e) is list and e[0] == "join" and len(e) == 2 else self.definitions.get(str(e))
        return self.open(known) if known else e

    def names(self, e):
        e = self.open(e)
        parts = e[1:] if e[0] not in ("number", "power") else e[1:2] if e[0] == "power" else []
        return {e} if isinstance(e, str) else {n for part in parts for n in self.names(part)}

    def read(self, e):
        if isinstance(e, str):
            if e not in self.known:
                known = {**self.definitions, **self.meets}
                self.known[e] = self.read(known[e]) if e in known else self.placed[e](self)
            return self.known[e]
        if e[0] == "number":
            return 0, {(): {(): Fraction(e[1])}} if Fraction(e[1]) else {}
        fits = len(e) > 1 and e[0] in [*SIGN, *BRACKETS] and (e[0] != "power" or (len(e) == 3 and e[2] in range(2, 65)))
        expect(fits, f"no expression: {e}"[:200])
        parts = [self.read(e[1])] * e[2] if e[0] == "power" else [self.read(part) for part in e[1:]]
        if e[0] not in ("product", "power"):
            return getattr(self, e[0])(parts)
        expect(sum(step > 0 for step, _ in parts) < 2, "a product of two extensors")
        return self.join(parts)

    def sum(self, parts):
        steps = {step for step, value in parts if value}
        expect(len(steps) < 2, "a sum of unlike steps")
        return max(steps, default=parts[0][0]), collected((row, p, 1) for _, v in parts for row, p in v.items())

    def join(self, parts):
        step, value = parts[0]
        for further, other in parts[1:]:
            step += further
            expect(step <= self.rank, "a join beyond the rank")
            pairs = ((in_order(r + s), p, q) for (r, p), (s, q) in product(value.items(), other.items()))
            value = collected((row, times(p, q), sign) for (sign, row), p, q in pairs if sign)
        return step, value

    def row(self, points):  # a bracket as a polynomial
        sign, row = in_order(tuple(points))
        return {(row,): sign} if sign and row[-1] >= self.ideal else {}

    def bracket(self, parts):
        step, value = self.join(parts)
        expect(step == self.rank, "a bracket that is not full")
        return self.sum([(0, {(): times(p, self.row(row))}) for row, p in value.items()] or [(0, {})])

    def meet(self, parts):
        step, value = parts[0]
        for further, other in parts[1:]:
            expect(step + further >= self.rank, "a meet of extensors that are too small")
            value = collected(
                (tuple(r[i] for i in rest), times(times(p, q), self.row([r[i] for i in first] + list(s))), sign)
                for (r, p), (s, q) in product(value.items(), other.items())
                for sign, first, rest in splits(len(r), self.rank - len(s))
            )
            step += further - self.rank
        return step, value

    def superbracket(self, parts):
        expect([step for step, _ in parts] == [2] * comb(self.rank, 2), "a superbracket that is not full")
        if self.rank < 4:  # of one line its bracket; in the plane the determinant of three lines is their meet
            return self.bracket(parts) if self.rank == 2 else self.meet(parts)
        total = {}
        if self.rank > 4:  # the determinant in coordinates, with the ends of all lines as basis
            ends = sorted({x for _, line in parts for row in line for x in row})
            expect(len(ends) <= self.rank, "lines of rank 5 or more that are not written in a basis")
            pairs, rows = [*combinations(ends, 2)], {(): {(): 1}}
            for _, line in parts:
                of = (((*r, pairs.index(s)), times(p, q)) for (r, p), (s, q) in product(rows.items(), line.items()))
                rows = collected((in_order(r)[1], p, in_order(r)[0]) for r, p in of)
            total = reduce(times, [self.row(ends)] * (self.rank - 1), rows.get((*range(len(parts)),), {}))
        for choice in product(*(value.items() for _, value in parts)) if self.rank == 4 else ():
            ends = [x for row, _ in choice for x in row]
            for sign, rows in superbracket_terms():
                factors = (*(self.row(ends[e] for e in row) for row in rows), *(p for _, p in choice))
                total = plus(total, reduce(times, factors, {(): sign}))
        return 0, {(): total} if total else {}

    def closed(self, e):  # as one polynomial; an extensor of step k is closed by d - k further points
        step, value = self.read(e)
        further = tuple(range(len(self.points), len(self.points) + self.rank - step)) if step else ()
        return reduce(plus, (times(p, self.row(row + further)) if step else p for row, p in value.items()), {})

    def without(self, rest, relations):  # a polynomial minus multiples of exchange relations
        for first, second, count, multiplier in relations:
            expect(len(first) == len(second) == self.rank and 0 < count <= self.rank, "a relation of unlike brackets")
            relation = times(self.row(first), self.row(second))
            for chosen in combinations(range(self.rank), count):
                row = [first[chosen.index(i)] if i in chosen else x for i, x in enumerate(second)]
                other = [second[i] for i in chosen] + first[count:]
                relation = plus(relation, times(self.row(row), self.row(other)), -1)
            for coefficient, *rows in multiplier:
                expect(all(len(row) in (1, self.rank) for row in rows), "a bracket that is not full")
                factors = ({(tuple(row),): 1} if len(row) == 1 else self.row(row) for row in rows)
                for m, c in times(reduce(times, factors, {(): Fraction(coefficient)}), relation).items():
                    rest[m] = rest.get(m, 0) - c
        return rest

    def text(self, e):  # what it says
        e = self.open(e)
        if not isinstance(e, list) or e[0] == "number":
            return str(e if not isinstance(e, list) else Fraction(e[1]))
        return BRACKETS.get(e[0], "({})").format(SIGN.get(e[0], " ").join(map(self.text, e[1:])))

    def zero(self, e, given):  # whether it vanishes where expressions with these texts do
        e = self.open(e)
        inside = {"sum": all, "product": any, "join": any, "meet": any, "bracket": any}.get(e[0], lambda _: False)
        return self.text(e) in {*given, "0"} or inside(self.zero(part, given) for part in e[1:])

    def args(self, e, operation="join"):  # the parts of a join or meet as far as they are such; of anything else itself
        e = self.open(e)
        return [e] if isinstance(e, str) or e[0] != operation else [x for p in e[1:] for x in self.args(p, operation)]

    def plain(self, e, fresh=()):  # whether it is joins and meets of points, and of sums that are points or hyperplanes
        e = self.open(e)
        flat = e[0] in ("sum", "product") and self.read(e)[0] in (1, self.rank - 1) and not self.names(e) & {*fresh}
        return isinstance(e, str) or flat or (e[0] in ("join", "meet") and all(self.plain(p, fresh) for p in e[1:]))

    def key(self, e):  # the same for joins and for meets of the same parts in any sequence, and for multiples of sums
        e = self.open(self.meets.get(e, e) if isinstance(e, str) else e)
        if isinstance(e, list) and e[0] in ("join", "meet"):
            parts = self.args(e, e[0])
            return f"{e[0]}({' '.join(sorted(map(self.key, parts)))})" if len(parts) > 1 else self.key(parts[0])
        terms = sorted((row, m, Fraction(c)) for row, p in self.read(e)[1].items() for m, c in p.items())
        return str([(row, m, c / terms[0][2]) for row, m, c in terms])


class Positions:  # what assumptions say, and the points that are placed by them, checked one after the other
    def __init__(self, theorem):
        self.reader, self.written = (reader := Reader(theorem)), Reader(theorem)
        self.given = [e for e in theorem["given"] if reader.read(e)]
        self.alive = [part for e in theorem["nonzero"] if reader.read(e)[1] for part in self.parts(e)]
        self.scalars, self.places, seen, before = 0, self.written.placed, set(), {*theorem["points"]}
        placed = [(p["name"], [*p["fresh"]], reader.open(p["on"]), p) for p in theorem["placed"]]
        finite, meets = {*theorem["points"][reader.ideal :]} - {*reader.meets}, [*reader.meets.values()]
        known = [*theorem["claim"], *theorem["given"], *theorem["nonzero"], *meets, *theorem["points"][: reader.ideal]]
        used = Counter(n for e in (*known, *(on for _, _, on, _ in placed)) for n in reader.names(e))
        expect(not any(reader.names(e) & {*reader.meets} for e in known), "an auxiliary point is named")
        expect(all(reader.read(e)[0] == 1 for e in meets), "an auxiliary point that is none")
        expect(not any(reader.names(e) & {*theorem["any"]} for e in theorem["nonzero"] + meets), "not zero for all")
        for name, fresh, on, p in placed:
            self.fresh, own, points = fresh, reader.names(on), reader.args(on)
            expect(own <= before and {*fresh} <= finite - seen, f"{name} is placed too early")
            inside = Counter(n for part in points for n in reader.names(part))
            expect(all(used[f] == inside[f] < 2 for f in fresh) and len({*fresh}) == len(fresh), "not fresh")
            self.flats = {reader.key(flat["flat"]) for flat in p["flats"] if self.lies_on(name, flat)}
            same, difference = "equal" in p, ["sum", name, ["product", ["number", -1], on]]
            free, step = own <= finite and sorted(map(str, points)) == sorted(own), reader.read(on)[0]
            if not (basis := free and step == reader.rank):
                there = step == 1 and self.vanishes(difference, *p["equal"]) if same else self.lies(on)
                expect(there, f"{name} need not {'equal' if same else 'lie on'} {reader.text(on)}", NotProved)
                alive = same or (free and not own & seen) or self.not_zero(on)
                expect(alive, f"{name}: {reader.text(on)} may vanish", NotProved)
            seen, before = {*seen, name, *(() if basis else own), *fresh}, {*before, name}
            self.places[name] = self.place(on, [f for f in fresh if f not in own], same)
            self.written.known = {n: x for n, x in reader.known.items() if n in {*reader.points} - {*self.places}}

    def parts(self, e):  # an expression and the parts of it that are not zero where it is not
        e = self.reader.open(e)
        inside = e[1:] if isinstance(e, list) and e[0] in ("join", "bracket", "meet", "product") else []
        return [["join", *inside] if e[0] == "bracket" else e, *(x for part in inside for x in self.parts(part))]

    def vanishes(self, e, index=None, number=0, relations=()):  # as it stands, or with what is placed so far expanded
        known = ["number", 0] if index is None else self.given[index]
        rests = ((r, plus(r.closed(e), r.closed(known), -Fraction(number))) for r in (self.reader, self.written))
        return any(not any(r.without(rest, relations).values()) for r, rest in rests)

    def lies_on(self, name, flat):  # whether a flat joined with the point vanishes
        because, room, joined, r = flat["because"], flat["room"], ["join", flat["flat"], name], self.reader
        expect(r.plain(joined), "a flat that is not made by joins and meets")
        if room is None:
            return self.vanishes(joined, *because[0])
        points, others = r.args(room), [part for part in r.args(joined) if part not in r.args(room)]
        expect(all(isinstance(n, str) for n in points) and self.not_zero(room), "a room that may vanish")
        expect(len(points) < sum(r.read(part)[0] for part in r.args(joined)), "there is room")
        for part, why in zip(others, because, strict=True):
            how = "join" if r.read(part)[0] == 1 else "meet"
            expect(how == "join" or len(points) == r.rank - 1, "an extensor on what is no hyperplane")
            expect(self.vanishes([how, part, room], *why), "it is not there")
        return True

    def lies(self, e):
        met, joined = self.reader.args(e, "meet"), self.reader.args(e)
        kept = [part for part in joined if part not in self.fresh]
        on = (0 < len(kept) < len(joined) and self.lies(["join", *kept])) or (len(met) > 1 and all(map(self.lies, met)))
        return on or self.reader.key(e) in self.flats

    def not_zero(self, e):
        r = self.reader
        wanted, met = Counter(map(r.key, r.args(e))), r.args(e, "meet")
        if any(not wanted - Counter(map(r.key, r.args(part))) for part in self.alive):
            return True
        first, other = r.args(met[0]), ["meet", *met[1:]] if len(met) > 2 else met[-1]
        kept = [part for part in first if part not in self.fresh]
        loose = {*self.fresh}.intersection(part for part in first if isinstance(part, str))
        missing = r.rank - len(loose) - sum(r.read(part)[0] for part in kept)
        fits = len(met) > 1 and loose and len(first) == len(kept) + len(loose) and missing >= 0 and self.not_zero(other)
        ends = [part for part in r.args(other) if isinstance(part, str)]
        return fits and any(self.not_zero(["join", *kept, *some]) for some in combinations(ends, missing))

    def place(self, on, fresh, equal):  # how a point is written, for the reader of the claim
        terms = []
        expect(equal or self.reader.plain(on, self.fresh), "a point on what is not made by joins and meets")
        for part in [on] if equal else self.reader.args(on):
            step = self.reader.read(part)[0]
            new = [fresh.pop(0) for _ in range(self.reader.rank - step + 1 if step > 1 else 0)]
            scaled = not (new or equal or self.reader.names(part) & {*self.fresh})
            terms.append((["meet", part, ["join", *new]] if new else part, {((self.scalars,),) if scaled else (): 1}))
            self.scalars += 1
        return lambda r: r.sum([r.join([(0, {(): scalar}), r.read(e)]) for e, scalar in terms])


def split(theorem, claim, given, nonzero):  # checks all cases of what these texts say, and that they leave none out
    r, own = Reader(theorem["cases"][0]), Reader(theorem)
    anywhere, every = {*theorem["any"]}, ({*theorem["any"]} | {*r.points} - {*own.points}) - {*own.points[: own.ideal]}

    def for_all(f):  # of a bracket that vanishes for all of some points the join of the others, which does, too
        rest = ["join", *(p for p in f[1:] if not (isinstance(p, str) and p in every))]
        alone = f[0] == "bracket" and 1 < len(rest) < len(f) == len({*map(str, f)}) and not r.names(rest) & every
        return rest if alone else f

    if "split" in theorem:
        either = own.text(theorem["split"])
        ways = [([*given, either], nonzero), (given, [*nonzero, either])]
    else:
        (left, right), live = theorem["cases"][0]["claim"], [*nonzero, "({} + (-1 * {}))".format(*claim)]
        expect(r.zero(left, given), f"{r.text(left)} need not vanish", NotProved)
        factors = [r.text(for_all(f)) for f in r.args(right, "product") if f[0] != "number" or not Fraction(f[1])]
        ways = [(given, nonzero), *(([*given, f], nonzero) for f in dict.fromkeys(factors) if f not in live)]
    for n, (case, (zeros, alive)) in enumerate(zip(theorem["cases"], ways, strict=True)):
        says, zero, live = ([*map(Reader(case).text, case[key])] for key in ("claim", "given", "nonzero"))
        expect({*case["any"]} <= anywhere and case["rank"] == theorem["rank"], "a case of another space")
        expect({*case["points"][: case["ideal"]]} <= {*theorem["points"][: theorem["ideal"]]}, "a case at infinity")
        expect({*zero} <= {*zeros} and {*live} <= {*alive}, "a case that assumes more", NotProved)
        same = says == claim or (says[0] in alive and says[1] == "0") or (n == 0 and "split" not in theorem)
        expect(same, "a case of another claim", NotProved)
        check(case)


def check(theorem):  # the claim as text; raises NotProved where something is left
    reader = Reader(theorem, Positions(theorem).places if {"any", "given", "nonzero"} & {*theorem} else {})
    (step, a), (other, b) = map(reader.read, theorem["claim"])
    expect(step == other or not a or not b, "the sides are of unlike steps")
    claim, zero, live = ([*map(reader.text, theorem.get(key, ()))] for key in ("claim", "given", "nonzero"))
    text, rest = " == ".join(claim), plus(*map(reader.closed, theorem["claim"]), -1)
    if "cases" in theorem:
        split(theorem, claim, zero, live)
    elif claim[1] != "0" or not reader.zero(theorem["claim"][0], zero):
        left = sum(map(bool, reader.without(rest, theorem["relations"]).values()))
        expect(not left, f"{left} terms are left of {text}"[:2000], NotProved)
    where = [*(f"{e} == 0" for e in zero), *(f"{e} != 0" for e in live)]
    space = [f"rank {reader.rank}", *(f"{p} at infinity" for p in reader.points[: reader.ideal])]
    space += [f"for all {p}" for p in theorem.get("any", ())]
    return f"{text}{', where ' if where else ''}{' and '.join(where)} ({', '.join(space)})"


def main(path):
    try:
        with open(path, encoding="utf-8") as f:
            data = json.load(f, object_pairs_hook=lambda p: expect(len(dict(p)) == len(p), "a name twice") or dict(p))
        expect((data["format"], data["version"]) == ("gcrules proof", 1) and data["theorems"], "of no known version")
        for theorem in data["theorems"]:
            print(f"proved, called {theorem['name']!r} in the file:\n  {check(theorem)}")
        text = json.dumps(data["theorems"], separators=(",", ":"), ensure_ascii=False).encode()
        print(f"theorems proved: {len(data['theorems'])}, digest {(digest := hashlib.sha256(text).hexdigest())}")
        expect(data.get("digest", digest) == digest, "it names another digest")
    except NotProved as fault:
        print(f"NOT PROVED, called {theorem['name']!r} in the file:\n  {fault}")
        return 1
    except (OSError, ValueError, TypeError, LookupError, AttributeError, ArithmeticError, RecursionError) as fault:
        print(f"{path}: no proof file: {type(fault).__name__}: {fault}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else (print(__doc__, file=sys.stderr), 2)[1])
