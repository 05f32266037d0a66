"""That no polynomial with fewer terms exists, for checkers/recompute.py, whose head says what it relies on."""

from collections import Counter
from fractions import Fraction
from itertools import combinations
from math import ceil, comb, factorial, prod

from recompute_polynomials import (
    PRIMES,
    SURE,
    Brackets,
    NotSo,
    Polynomial,
    TooLarge,
    degrees_of,
    expect,
    prime_above,
    sign_of,
)


def monomials(degrees, rank, rows=None):
    """All products of brackets (of some of them) that use the points so often."""
    left, beginning = dict(sorted(degrees.items())), {}
    for row in combinations(left, rank) if rows is None else sorted(rows):
        beginning.setdefault(row[0], []).append(row)

    def complete(before):
        first = next((x for x, n in left.items() if n), None)
        if first is None:
            yield ()
            return
        for row in beginning.get(first, []):
            if row >= before and all(left[x] for x in row):
                left.update((x, left[x] - 1) for x in row)
                for rest in complete(row):
                    yield (row, *rest)
                left.update((x, left[x] + 1) for x in row)

    return complete(())


def in_span(vectors, target, p):
    """Whether the target is a combination of the vectors modulo p."""
    vectors, target = list(vectors), list(target)
    while vectors:
        one = vectors.pop()
        at = next((i for i, x in enumerate(one) if x), None)
        if at is not None:
            inverse = pow(one[at], -1, p)
            vectors = [[(a - v[at] * inverse * b) % p for a, b in zip(v, one)] for v in vectors]
            target = [(a - target[at] * inverse * b) % p for a, b in zip(target, one)]
    return not any(target)


def spanning(k, vectors, target, chosen, steps, p):
    """Sets of k vectors, with those chosen, that may span the target: [(name, reduced values)] are left to choose."""
    steps.take(len(vectors))
    at = next((i for i, x in enumerate(target) if x), None)
    if at is None:
        yield chosen
        return
    if k > 2:
        for i, (name, one) in enumerate(vectors):
            pivot = next((j for j, x in enumerate(one) if x), None)
            if pivot is not None:  # else it is a combination of those chosen
                a, rest = one[pivot], vectors[i + 1 :]
                less = [(n, [(x * a - v[pivot] * y) % p for x, y in zip(v, one)]) for n, v in rest]
                aim = [(x * a - target[pivot] * y) % p for x, y in zip(target, one)]
                yield from spanning(k - 1, less, aim, (*chosen, name), steps, p)
        return
    groups = {}
    for name, v in vectors:
        rest = [(x * target[at] - v[at] * y) % p for i, (x, y) in enumerate(zip(v, target)) if i != at]
        first = next((x for x in rest if x), None)
        if first is None:
            yield (*chosen, name)
        elif k == 2:  # the target is a combination of two that differ by a factor now
            inverse = pow(first, -1, p)
            groups.setdefault(tuple(x * inverse % p for x in rest), []).append(name)
    for names in groups.values():
        steps.take(comb(len(names), 2))
        yield from ((*chosen, *pair) for pair in combinations(names, 2))


def none_spans(least, values, target, steps, p):
    """That fewer than so many vectors do not span a target; {name: values}, of which few positions sort out most."""
    for k in range(1, least):
        short = [(name, v[: k + 2]) for name, v in values.items()]
        for found in spanning(k, short, target[: k + 2], (), steps, p):
            made = in_span([values[name] for name in found], target, p)
            expect(not made, f"{len(found)} bracket monomials add up to it: {found}", NotSo)
            expect(len(found) == k, "at special positions not all sets are seen", TooLarge)


def values_of(names, poly, positions):
    brackets = [Brackets(at, poly.p) for at in positions]
    return {m: [at.monomial(m) for at in brackets] for m in names}


def by_value(one, poly, steps):
    expect(one["least"] == 1 and poly.value(poly.position()), "it may be zero", NotSo)
    return "it is not zero; certain"


def by_brackets(one, poly, steps):
    """No single product of brackets: those that divide do not suffice."""
    found = poly.dividing(steps)
    expect(sorted(found) == sorted(map(tuple, one["brackets"])), f"other brackets divide: {found}", NotSo)
    expect(one["least"] == 2, "brackets that divide prove that two terms are needed", NotSo)
    positions = [poly.position() for _ in range(2 + SURE)]
    some = [m for m in monomials(poly.degrees, poly.rank, found) if not steps.take()]
    none_spans(2, values_of(some, poly, positions), [poly.value(at) for at in positions], steps, poly.p)
    every = comb(len(poly.points), poly.rank)
    return f"{len(found)} of {every:,} brackets may divide it, and none of {len(some)} products of these is it; certain"


def listed(one, poly, steps):
    found = [m for m in monomials(poly.degrees, poly.rank) if not steps.take(100)]
    expect(len(found) == one["monomials"], f"there are {len(found):,} bracket monomials", NotSo)
    return found


def by_enumeration(one, poly, steps):
    """No set of fewer monomials."""
    k, most = one["least"] - 1, prod(map(factorial, poly.degrees.values()))
    poly.modulo(prime_above(k**k * most**k))
    found = listed(one, poly, steps)
    steps.expect(comb(len(found), k - 1))
    positions = [poly.position() for _ in range(k + 2 + SURE)]
    none_spans(one["least"], values_of(found, poly, positions), [poly.value(at) for at in positions], steps, poly.p)
    return f"none of the sets of {k} of {len(found):,} bracket monomials has it in its span; certain"


def by_merging(one, poly, steps):
    """Weights of mergings, and orbits under symmetries."""
    found, moves, most = listed(one, poly, steps), [], prod(map(factorial, poly.degrees.values()))
    poly.modulo(max(PRIMES[1], prime_above(2 * most * sum(map(abs, poly.terms.values())))))  # no number vanishes there
    for sign, moved in one["symmetries"]:
        move = {**{x: x for x in poly.points}, **dict(moved)}
        expect(sorted(move.values()) == poly.points and sign in (1, -1), "what permutes no points", NotSo)
        for at in [poly.position() for _ in range(SURE)]:
            image = poly.value({x: at[y] for x, y in move.items()})
            expect((image - sign * poly.value(at)) % poly.p == 0, f"{moved} is no symmetry", NotSo)
        moves.append((sign, move))
    orbit, cancels, sizes = {}, set(), []
    for start in found:
        if start not in orbit:
            orbit[start], todo = (len(sizes), 1), [start]
            sizes.append(0)
            while todo:
                m = todo.pop()
                number, before = orbit[m]
                sizes[number] += 1
                steps.take(len(moves))
                for sign, move in moves:
                    rows = [tuple(move[x] for x in row) for row in m]
                    image, turned = tuple(sorted(tuple(sorted(row)) for row in rows)), prod(map(sign_of, rows))
                    if image not in orbit:
                        orbit[image] = number, before * sign * turned
                        todo.append(image)
                    elif orbit[image][1] != before * sign * turned:
                        cancels.add(number)
    load, total = [Fraction(0)] * len(sizes), Fraction(0)
    for weight, least, blocks in one["mergings"]:
        weight, alive = Fraction(weight), found
        expect(weight >= 0, "a weight below 0", NotSo)
        if blocks:
            inside = [x for b in blocks for x in b]
            expect({*inside} <= {*poly.points} and len({*inside}) == len(inside), "blocks that overlap", NotSo)
            alive = [m for m in found if not any(len({*row} & {*b}) > 1 for row in m for b in blocks)]
            head = {x: b[0] for b in blocks for x in b}
            at = [poly.merged(blocks) for _ in range(least + 1 + SURE)]
            target = [poly.value(x) for x in at]
            expect(target[0] and least > 0, f"merging {blocks} may leave nothing", NotSo)
            most = prod(factorial(n) for n in Counter(head.get(x, x) for x in poly.degrees.elements()).values())
            expect((least * most) ** least < poly.p, "the numbers are too large for this program", TooLarge)
            none_spans(least, values_of(alive, poly, at), target, steps, poly.p)
        else:
            expect(least == 1, "not more than one need be in an orbit that does not cancel", NotSo)
            alive = [m for m in found if orbit[m][0] not in cancels]
        total += weight * least
        for number, n in Counter(orbit[m][0] for m in alive).items():
            load[number] += weight * Fraction(n, sizes[number])
    expect(max(load) <= 1, "the weights in an orbit add up to more than 1", NotSo)
    expect(ceil(total) == one["least"], f"the weights prove that {ceil(total)} are needed", NotSo)
    return (
        f"{len(one['mergings'])} mergings, {len(found):,} bracket monomials in {len(sizes):,} orbits of {len(moves)}"
        f" symmetries that generate them: at least {total}; {poly.error(len(moves), len(moves))}"
    )


REASONS = {"value": by_value, "brackets": by_brackets, "enumeration": by_enumeration, "merging": by_merging}


def no_shorter(absence, terms, rank, seed, steps):
    """No polynomial in brackets with fewer terms; what uses the points differently is independent."""
    parts = {}
    for m, c in terms.items():
        parts.setdefault(tuple(sorted(degrees_of(m).items())), {})[m] = c
    expect(len(parts) == len(absence["parts"]), f"it has {len(parts)} parts", NotSo)
    expect(
        sum(one["least"] for one in absence["parts"]) == absence["least"], "the parts add up to another number", NotSo
    )
    said = []
    for one in absence["parts"]:
        degrees = tuple(sorted(map(tuple, one["degrees"])))
        expect(degrees in parts, f"it has no other part with the degrees {degrees}", NotSo)
        poly = Polynomial(parts.pop(degrees), rank, PRIMES[0], seed)
        said.append(f"{one['least']}, since {REASONS[one['reason']](one, poly, steps)}")
    needed = "1 term is" if absence["least"] == 1 else f"{absence['least']} terms are"
    return f"at least {needed} needed", " and ".join(said)
