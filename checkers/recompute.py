#!/usr/bin/env python3
r"""Compute the absences of a proof file of gcrules again: python checkers/recompute.py FILE.json [--most N]

An absence says that something does not exist: no expression of joins and meets, no shorter polynomial. This program
takes the polynomial from the right side of the theorem that the absence names (checkers/check_proof.py proves that it
equals the left one), and enumerates slowly what the file says. It needs Python alone and shares no code with gcrules.
Nothing of this is proved in Coq. Values are taken at positions modulo a prime p. All it relies on:

* Polynomials are different if their values are at one position, so P is not 0 modulo p if one value is not. A bracket
  that divides P is a factor of its values wherever it vanishes. Polynomials in coordinates factor in one way only,
  factors of bracket polynomials are such, and brackets are irreducible.
* If E = c P then E(x) P(y) = E(y) P(x). At basis vectors an expression E with different points is 0, 1 or -1, so no
  coefficient of one that uses points m times exceeds the product of all m!; c divides them where P has coprime ones. As
  p is larger, c is not 0 modulo p, no part of E vanishes where P does not, and none is lost by leaving out extensors
  that vanish, or all but one of those that agree, up to one factor, at all positions.
* A join vanishes where two of its points coincide, so two points where P does not then vanish are in no join.
* An expression that is no product has no scalar inside. A tree of n points has an edge with n/2 on both sides, or a
  node of three branches with less than n/2 each; cut there, it is A v B, A v (B v C) or A v (B ^ C), up to its sign.
* Every point once (N. White): if P is a product of expressions, points on one join are those in which P alternates,
  and P has a meet of two whole extensors E and F if it depends on E ^ F only; E ^ F may then be replaced by new points.
* k bracket monomials with k least, c P = sum c_i M_i with whole coprime numbers: c divides a minor of their
  coefficients, which are at most B, the product of all m!. By Hadamard it is at most k^(k/2) B^k. As p is larger, the
  equation holds modulo p too.
* Merging points takes P to what the monomials without two merged points in one bracket add up to; so do its images by
  symmetries. On the average over them x(O) of the k monomials are in an orbit O, of which a merging leaves a part s(O):
  sum s(O) x(O) >= m if m are needed after merging. So k >= sum y m for weights y >= 0 with sum y s(O) <= 1 for each O.
  If a symmetry takes a monomial to itself with another sign than P, the average of P's images has none of its orbit.
  A symmetry modulo p is one, as p is larger than any coefficient of the difference, at most 2 B times those of P.

Every line says whether it is certain, or what was seen at random positions only, with the probability of an error.
Exit codes: 0 all absences are as stated, 1 one is not, 2 the file states none, or is no proof file, 3 one is too large.
"""

import json
import re
import sys

from recompute_expressions import no_expression, no_product
from recompute_polynomials import NotSo, Steps, TooLarge, expect, read
from recompute_terms import no_shorter

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]*'*(:[0-9]+)?")
KINDS = {"no expression": no_expression, "no product": no_product, "no shorter polynomial": no_shorter}


def recomputed(absence, theorems, most):
    """What an absence says, as it was recomputed here."""
    (theorem,) = [one for one in theorems if one["name"] == absence["theorem"]]
    expect(theorem["ideal"] == 0 and "given" not in theorem, "points at infinity, or assumptions", TooLarge)
    steps, rank, points = Steps(most), theorem["rank"], [*theorem["points"]]
    expect(all(map(NAME.fullmatch, points)), "points whose names are none")
    terms = read(theorem["claim"][1], points, dict(theorem["definitions"]), rank, steps)
    claim, how = KINDS[absence["kind"]](absence, terms, rank, json.dumps(absence), steps)
    expect(absence["claim"] == claim, f"what is computed is another claim: {claim}", NotSo)
    return f"{claim}: {how}\n  of {text(terms)} (rank {rank})"


def text(terms):
    """A polynomial in brackets as people read it."""
    signed = [(f"{'+' if c > 0 else ''}{c}", m) for m, c in terms.items()]
    return " ".join(" ".join([number, *(f"[{' '.join(row)}]" for row in m)]) for number, m in signed)


def once(pairs):
    """An object whose names all differ; fractions are text, so that floats, NaN and Infinity come here as well."""
    expect(not isinstance(pairs, str) and len(dict(pairs)) == len(pairs), f"a name twice, or no number: {pairs}"[:200])
    return dict(pairs)


def main(path, most):
    code = 0
    try:
        with open(path, encoding="utf-8") as file:
            data = json.load(file, object_pairs_hook=once, parse_float=once, parse_constant=once)
        expect((data["format"], data["version"]) == ("gcrules proof", 1), "of no known version")
        expect(data.get("absences"), "it states no absence")
        for absence in data["absences"]:
            called = f"called {absence['claim']!r} in the file, of the right side of {absence['theorem']!r}"
            try:
                print(f"recomputed, {called}:\n  {recomputed(absence, data['theorems'], most)}", flush=True)
            except NotSo as fault:
                print(f"NOT SO, {called}:\n  {fault}"[:2000])
                code = 1
            except TooLarge as fault:
                print(f"NOT RECOMPUTED, {called}:\n  {fault}")
                code = code or 3
        print("All this is about the right sides; that the left ones equal them is what check_proof.py checks.")
    except (OSError, ValueError, TypeError, LookupError, AttributeError, ArithmeticError, RecursionError) as fault:
        print(f"{path}: no proof file with absences: {type(fault).__name__}: {fault}", file=sys.stderr)
        return 2
    return code


if __name__ == "__main__":
    asked = sys.argv[1:]
    if len(asked) not in (1, 3) or asked[1:2] not in ([], ["--most"]) or not all(n.isdecimal() for n in asked[2:]):
        sys.exit((print(__doc__, file=sys.stderr), 2)[1])
    sys.exit(main(asked[0], int(asked[2]) if asked[2:] else 20_000_000))
