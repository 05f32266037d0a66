"""That no expression of joins and meets exists, for checkers/recompute.py, whose head says what it relies on."""

from collections import Counter
from functools import cache
from itertools import combinations, product
from math import factorial, prod

from recompute_polynomials import (
    PRIMES,
    SURE,
    NotSo,
    Polynomial,
    TooLarge,
    degrees_of,
    determinant,
    expect,
    prime_above,
    sign_of,
)

FAMILY = "product of brackets and one expression of joins and meets, with its multidegree,"

# --- no expression: every one enumerated ------------------------------------------------------------------------------


@cache
def table(rank, k, h):
    """For each coordinate of the join of steps k and h, or of their meet where the join is too large, the products."""
    everything, join = tuple(range(rank)), k + h < rank
    found = {s: [] for s in combinations(everything, k + h if join else k + h - rank)}
    for (i, s), (j, t) in product(enumerate(combinations(everything, k)), enumerate(combinations(everything, h))):
        if join and not {*s} & {*t}:
            found[tuple(sorted(s + t))].append((i, j, sign_of(s + t)))
        elif not join and {*s} | {*t} == {*everything}:
            first, rest = tuple(x for x in s if x not in t), tuple(x for x in s if x in t)
            found[rest].append((i, j, sign_of(first + rest) * sign_of(first + t)))
    return list(found.values())


def multiply(a, b, products, p):
    """Joins or meets at all positions."""
    return [[sum(x[i] * y[j] * s for i, j, s in row) % p for row in products] for x, y in zip(a, b)]


def spaces(degrees, rank):
    """How many ways there are to write the point that comes first joined with an extensor made of all the others."""
    names = sorted(degrees)

    @cache
    def trees(m):
        if sum(m) == 1:
            return 1
        total = 0
        for u in product(*(range(n + 1) for n in m)):
            v = tuple(a - b for a, b in zip(m, u))
            if u <= v and sum(u) % rank and sum(v) % rank:
                total += trees(u) * (trees(u) + 1) // 2 if u == v else trees(u) * trees(v)
        return total

    return trees((degrees[names[0]] - 1, *(degrees[x] for x in names[1:])))


class Extensors:
    """All extensors by their number of points: {points used: {values at positions: (points joined, kept apart)}}."""

    def __init__(self, poly, steps):
        self.poly, self.steps, self.d, self.p = poly, steps, poly.rank, poly.p
        self.positions = [poly.position() for _ in range(3)]
        self.target = [poly.value(at) for at in self.positions]
        expect(all(self.target), "the polynomial vanishes at a random position", NotSo)
        self.degrees = tuple(poly.degrees[x] for x in poly.points)
        apart = {x: set() for x in poly.points}
        for x, y in combinations(poly.points, 2):
            if poly.value(poly.merged([(x, y)])):
                apart[x].add(y)
                apart[y].add(x)
        self.levels = {1: {}}
        for n, x in enumerate(poly.points):
            unit = tuple(int(i == n) for i in range(len(poly.points)))
            self.add(1, unit, [at[x] for at in self.positions], frozenset([x]), frozenset(apart[x]))

    def add(self, n, used, values, joined, barred):
        if not all(map(any, values)):
            return
        inverse = pow(next(x for x in values[0] if x), -1, self.p)
        key = tuple(tuple(x * inverse % self.p for x in value) for value in values)
        same = self.levels[n].setdefault(used, {})
        before = same.get(key, (joined, barred))
        same[key] = joined & before[0], barred & before[1]  # what holds in whatever way it is written

    def level(self, n):
        if n not in self.levels:
            for k in range(1, n // 2 + 1):
                if k % self.d and (n - k) % self.d:
                    self.level(n - k)
            self.levels[n] = {}
            for k in range(1, n // 2 + 1):
                if k % self.d and (n - k) % self.d:
                    self.combine(n - k, k)
        return self.levels[n]

    def together(self, used, other):
        total = tuple(a + b for a, b in zip(used, other))
        return total if all(a <= b for a, b in zip(total, self.degrees)) else None

    def combine(self, n, k):
        a_step, b_step = n % self.d, k % self.d
        products, join = table(self.d, a_step, b_step), a_step + b_step < self.d
        for (used, some), (other, more) in product(self.level(n).items(), self.level(k).items()):
            total = self.together(used, other) if n != k or used <= other else None
            if total is None:
                continue
            self.steps.take(10 * len(some) * len(more))
            for (a, (joined, barred)), (b, (too, far)) in product(some.items(), more.items()):
                if not join:
                    self.add(n + k, total, multiply(a, b, products, self.p), frozenset(), frozenset())
                elif not (joined & far or barred & too):
                    self.add(n + k, total, multiply(a, b, products, self.p), joined | too, barred | far)

    def scalars(self):
        """Every expression, as its values at the positions."""
        n = sum(self.degrees)
        for a in range(n // 2, 0, -1):
            for b in [a] if 2 * a == n else range(min(a, n - a - 1), 0, -1):
                c = n - a - b
                if c <= b and a % self.d and b % self.d and (not c or c % self.d):
                    yield from self.cut(a, b, c)

    def cut(self, a, b, c):
        """Expressions cut into parts of so many points."""
        k = a % self.d
        coordinates = list(combinations(range(self.d), k)), list(combinations(range(self.d), self.d - k))
        pairs = [(i, j, sign_of(s + t)) for i, s in enumerate(coordinates[0]) for j, t in enumerate(coordinates[1])]
        pairs = [(i, j, s) for i, j, s in pairs if s]
        for used, others in list(self.others(b, c)):
            first = self.level(a).get(tuple(x - y for x, y in zip(self.degrees, used)), {})
            self.steps.take(len(first) * len(others))
            for x, y in product(first, others):
                yield lambda at, x=x, y=y: sum(x[at][i] * y[at][j] * s for i, j, s in pairs) % self.p

    def others(self, b, c):
        if not c:
            yield from self.level(b).items()
            return
        products = table(self.d, b % self.d, c % self.d)
        for (used, some), (other, more) in product(self.level(b).items(), self.level(c).items()):
            total = self.together(used, other)
            if total and (b != c or used <= other):
                self.steps.take(len(some) * len(more))
                yield total, [multiply(x, y, products, self.p) for x, y in product(some, more)]


def no_expression(absence, terms, rank, seed, steps):
    """No product of brackets and one expression of joins and meets, with each point as often as the polynomial."""
    bound = prod(factorial(n) for n in degrees_of(next(iter(terms), ())).values())
    whole = Polynomial(terms, rank, prime_above(bound), seed)
    common, rest = whole.without_common()
    rest = Polynomial(rest, rank, whole.p, seed)
    expect(rest.degrees, "it is a product of brackets", NotSo)
    found = rest.dividing(steps)
    expect(not found, f"the bracket of {found[:1]} may divide what the brackets leave", NotSo)
    insides = [
        sorted(Counter(dict(zip(common, n))).elements()) for n in product(*(range(k + 1) for k in common.values()))
    ]
    told = [(sorted(tuple(sorted(row)) for row in one["inside"]), one["space"]) for one in absence["searches"]]
    expect(sorted(insides) == sorted(inside for inside, _ in told), "not all brackets that divide, or others", NotSo)
    extensors = tests = 0
    for inside, space in told:
        poly = Polynomial({m + tuple(inside): c for m, c in rest.terms.items()}, rank, whole.p, seed)
        expect(spaces(poly.degrees, rank) == space, f"there are not {space} ways to write an expression", NotSo)
        built = Extensors(poly, steps)
        p, q, r = built.target
        for e in built.scalars():
            tests += 1
            one = e(0)
            if one and (one * q - e(1) * p) % poly.p == 0:
                same = (one * r - e(2) * p) % poly.p == 0
                expect(not same, "an expression agrees with the polynomial at all positions", NotSo)
        extensors += sum(len(some) for level in built.levels.values() for some in level.values())
    alone = sum(rest.degrees.values()) < 4 * rank
    expect(absence["irreducible"] is False or alone, "that it is irreducible is not computed here", TooLarge)
    ways = sum(space for _, space in told)
    return (
        f"no {'expression of joins and meets of its points' if absence['irreducible'] else FAMILY} equals it",
        f"there are {ways:,} ways to write one with its degrees; where no join has points that are apart, they come "
        f"down to {tests:,} of {extensors:,} different extensors, none of which agrees; certain",
    )


# --- no expression: every point once ----------------------------------------------------------------------------------


def shape(e):
    """An extensor, the same in whatever order its parts stand."""
    if isinstance(e, str):
        return e
    parts = [shape(part) for part in e[1:]]
    parts = [x for part in parts for x in (part[1] if part[0] == e[0] and isinstance(part, tuple) else [part])]
    return parts[0] if len(parts) == 1 else (e[0], sorted(parts, key=str))


def text(e):
    """An extensor as people read it."""
    sign = {"join": " v ", "meet": " ^ "}
    return e if isinstance(e, str) else f"({sign[e[0]].join(map(text, e[1]))})"


def no_product(absence, terms, rank, seed, steps):
    """No product of expressions of joins and meets, each point used once (White's algorithm)."""
    poly = Polynomial(terms, rank, PRIMES[1], seed)
    expect({*poly.degrees.values()} == {1}, "a point occurs twice", NotSo)
    p, number, seen, tests, meets = poly.p, len(poly.points), 0, 0, 0
    state, function = [([x], [x]) for x in poly.points], poly.value  # (points, what they join)

    def place(points):
        return {x: [poly.random.randrange(p) for _ in range(rank)] for x in points}

    def through(f, first, second, fresh):
        others = place(range(2 * rank - len(first) - len(second)))
        x, y = [others[i] for i in range(len(first) - len(fresh))], [*others.values()][len(first) - len(fresh) :]

        def value(at):
            met = [at[g] for g in fresh]
            inverse = pow(determinant([*met, *x, *y], p), -1, p)
            return f({**at, **dict(zip(first, met + x)), **dict(zip(second, met + y))}) * inverse % p

        return value

    while state:
        for (one, a), (other, b) in combinations(list(state), 2):
            if (one, a) in state and (other, b) in state:
                ats = [place(x for points, _ in state for x in points) for _ in range(SURE)]
                steps.take(SURE * len(terms))
                tests += 1
                if not any(function({**at, other[0]: at[one[0]]}) for at in ats):
                    seen += 1
                    one.extend(other)
                    a.extend(b)
                    state.remove((other, b))
        full = next((pair for pair in state if len(pair[0]) == rank), None)
        if full:
            state.remove(full)
            units = {x: [int(i == n) for i in range(rank)] for n, x in enumerate(full[0])}
            function = lambda at, f=function, units=units: f({**at, **units})  # noqa: E731
            continue
        for (one, a), (other, b) in combinations(state, 2):
            if len(one) + len(other) > rank:
                fresh = list(range(number, number + len(one) + len(other) - rank))
                left = [pair for pair in state if pair[0] not in (one, other)]
                meets, tests, ways = meets + 1, tests + 1, [through(function, one, other, fresh) for _ in range(2)]
                ats = [place([*fresh, *(x for points, _ in left for x in points)]) for _ in range(SURE)]
                steps.take(2 * SURE * len(terms))
                if all(ways[0](at) == ways[1](at) for at in ats):
                    seen, number, function = seen + 1, number + len(fresh), ways[0]
                    state = [*left, (fresh, [["meet", ["join", *a], ["join", *b]]])]
                    break
        else:
            break
    left = sorted((shape(["join", *a]) for _, a in state), key=str)
    expect(left, "it is a product of expressions", NotSo)
    shown = " ".join(map(text, left))
    expect(left == sorted(map(shape, absence["atoms"]), key=str), f"{shown} are left", NotSo)
    return (
        "no product of expressions of joins and meets, each point used once, equals it",
        f"left are {shown}, of which {meets} meets were tried; {poly.error(seen, tests)}",
    )
