"""Hostile input ends in the answer or the clear error that is expected, in bounded time and memory."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from gcrules.algebra import expand, space
from gcrules.algebra import expr as ex
from gcrules.algebra.language import parse_tree, syntax
from gcrules.algebra.scalars import MAX_DOTTED_TERMS, MAX_EXPONENT
from gcrules.algebra.straightening import straighten

LIMIT = parse_tree.MAX_TEXT - 4_000  # characters, just below the limit of the language
MANY = 40_000
MEGABYTE = 10**6

OK = ""
TEXT = "1,000,000 characters; the limit is 100,000"
NESTED = "nested more than 100 deep"
WORD = "a word of 96,00"
BITS = "a coefficient has more than 10000 bits"
PARTS = "names bound by `let`, and words, stand for more than 50,000 parts here"
NAMES = "more than 500 declared names"

# What is fed to the parser, as Python source so that a megabyte does not travel through a pipe; words of the fault.
EXPRESSIONS = {
    "20,000 open parentheses": ('"(" * 20_000', NESTED),
    "20,000 nested parentheses": ('"(" * 20_000 + "a" + ")" * 20_000', NESTED),
    "20,000 open brackets": ('"[" * 20_000', NESTED),
    "20,000 minus signs": ('"-" * 20_000 + "[abcd]"', OK),
    "brackets in brackets": ('nested("[({})a, b, c, d]", "[abcd]", 48)', OK),
    "superbrackets in superbrackets": ('nested("[[{} ab,cd,ef,gh,ij,kl]]", "[[ab,cd,ef,gh,ij,kl]]", 24)', OK),
    "every operation, nested": (
        r'nested("(-{}**2 c \\/ d /\\ ab * 2 + 1)", "[abcd]", 97)',
        "more than 100 operations inside each other",
    ),
    "powers of powers": ('nested("({}**64)", "[abcd]", 90)', OK),
    "powers of powers of numbers": ('nested("({}**64)", "3", 90)', BITS),
    "a megabyte of parentheses": (f'"(" * {MEGABYTE}', TEXT),
    "a megabyte of letters": (f'"a" * {MEGABYTE}', TEXT),
    "a megabyte of digits": (f'"1" * {MEGABYTE}', TEXT),
    "a megabyte of blanks": (f'" " * {MEGABYTE}', TEXT),
    "a megabyte of lines": (f'"\\n" * {MEGABYTE}', TEXT),
    "letters": (f'"a" * {LIMIT}', WORD),
    "digits": (f'"1" * {LIMIT}', "a number of 96,000 characters; the limit is 2,000"),
    "primes": (f'"a" + "\'" * {LIMIT}', WORD),
    "underscores": (f'"a_" * {LIMIT // 2}', WORD),
    "blanks": (f'" " * {LIMIT}', "the input is empty"),
    "dots": (f'"." * {LIMIT}', "unexpected '.'; expected a point"),
    "quotes": (f"'\"' * {LIMIT}", "unexpected character '\"'; expected an expression"),
    "hashes": (f'"#" * {LIMIT}', "the input ends too early"),
    "product": (f'"[abcd]" * {LIMIT // 6}', OK),
    "sum of numbers": (f'"+".join(["1"] * {LIMIT // 2})', OK),
    "sum": (f'"+".join(["[abcd]"] * {MANY // 7})', OK),
    "product of numbers": (f'"9 " * {MANY // 2}', BITS),
    "sum of fractions": (f'"+".join(f"1/{{n}}" for n in range(10_007, 10_007 + {MANY // 8}))', BITS),
    "product of fractions": (f'"*".join(f"1/{{n}}" for n in range(10_007, 10_007 + {MANY // 8}))', BITS),
    "fault at the end": (f'"+".join(["[abcd]"] * {MANY // 7}) + "+*"', "unexpected '*'; expected an expression"),
    "entries": (f'"[" + "a," * {MANY // 2} + "a]"', "a bracket of 20001 points, expected 4 in rank 4"),
    "dotted entries": (f'"[." + "a" * {LIMIT} + "]"', WORD),
    "lines of a superbracket": (f'"[[" + "ab," * {MANY // 4} + "ab]]"', "a superbracket of 10001 lines, expected 6"),
    "joins": (rf'"a\\/" * {MANY // 3} + "b"', "this join has step 5, beyond the rank 4"),
    "meets": (rf'"abc/\\" * {MANY // 5} + "abc"', "a meet with a scalar (step 0)"),
    "dotted brackets": (f'"[.a b c d]" * {MANY // 10}', OK),
    "nul": (f'"\\0" * {LIMIT}', "unexpected character '\\x00'"),
    "every byte": ('bytes(range(256)).decode("latin-1") * 350', "unexpected character '\\x00'"),
    "random bytes": ('random.Random(0).randbytes(90_000).decode("latin-1")', "unexpected character 'Í'"),
    "random bytes as UTF-8": (
        'random.Random(0).randbytes(90_000).decode("utf-8", "replace")',
        "unexpected character '\ufffd'",
    ),
    "random signs of the language": (
        '"".join(random.Random(1).choices("abAB1\'_.,+-*/^()[] \\\\\\n", k=90_000))',
        "unexpected ']'; expected the end",
    ),
    "surrogates": ('"\\ud800" * 1000', "unexpected character '\\ud800'"),
    "combining dots": (f'"a\\u0307" * {LIMIT // 2}', WORD),
    "combining dots alone": (f'"\\u0307" * {LIMIT}', "unexpected character '\u0307'"),
}
SCRIPTS = {
    "doubling sums": ('lets("{0}+{0}", 100)', PARTS),
    "doubling products": ('lets("{0}*{0}", 100)', PARTS),
    "doubling, not flat": ('lets("({0}+1)*({0}+2)", 100)', PARTS),
    "powers": ('lets("{0}**64", 100)', "with x97 written out this is more than 100 operations deep"),
    "deep": (r'lets("({0} e /\\ fgh)", 300)', "written out this is more than 100 operations deep"),
    "a long sum many times": (f'long_sum + "show " + "+".join(["x"] * {MANY // 4})', PARTS),
    "a long sum subtracted many times": (f'long_sum + "show " + "-".join(["x"] * {MANY // 4})', PARTS),
    "a long sum bound many times": (f'long_sum + "let y = " + "+".join(["x"] * {MANY // 4})', PARTS),
    "many names": ('"\\n".join(f"let x{i} = ab" for i in range(2_000))', NAMES),
    "many points": ('"points " + " ".join(f"pt{i}" for i in range(10_000))', NAMES),
    "many statements of points": ('"\\n".join(f"points pt{i}" for i in range(2_000))', NAMES),
    "many claims": ('"claim a==a\\n" * 4_000', OK),
    "long label": (f"'claim \"' + 'x' * {LIMIT} + '\": a == b'", OK),
    "nul": ('"\\0" * 1000', "unexpected character '\\x00'; expected claim, given, ideal"),
    "random bytes": ('random.Random(2).randbytes(90_000).decode("latin-1")', "unexpected 's'; expected claim"),
    "random words": (
        '" ".join(random.Random(3).choices('
        '["rank", "points", "ideal", "let", "claim", "show", "=", "==", "a", "[abcd]", "3", "+"], k=20_000))',
        "unexpected '='; expected a point",
    ),
}

# One process reads the cases; for each it forks a child with little memory, which prints the outcome.
READER = """
import json, os, random, resource, sys, traceback
from gcrules.algebra.language.statements import parse_script
from gcrules.algebra.language.syntax import parse
from gcrules.algebra.language.text import text
from gcrules.algebra.expr import points_of
from gcrules.core.errors import GcrulesError

def nested(form, inner, times):
    for _ in range(times):
        inner = form.replace("{}", inner)
    return inner

def lets(form, times):
    lines = ["let x0 = [abcd]"]
    return "\\n".join(lines + [f"let x{i + 1} = " + form.format(f"x{i}") for i in range(times)])

long_sum = "let x = " + "+".join(["[abcd]"] * 6_000) + "\\n"

def outcome(source, read):
    try:
        found = (parse if read == "expression" else parse_script)(eval(source))
        if read == "expression":
            hash(found), points_of(found), text(found), text(found, unicode=True)
        return "ok"
    except GcrulesError as fault:
        return [fault.exit_code, fault.message, len(str(fault)), len(fault.render().encode("utf-8", "replace"))]

parse("a"), parse_script("show a")  # the grammar is loaded once
resource.setrlimit(resource.RLIMIT_AS, (2**30, 2**30))
for line in sys.stdin:
    child = os.fork()
    if not child:
        resource.setrlimit(resource.RLIMIT_CPU, (120, 120))  # a net under what does not end, whatever else runs
        try:
            print(json.dumps(outcome(*json.loads(line))), flush=True)
            os._exit(0)
        except BaseException:
            traceback.print_exc()
            os._exit(1)
    if os.waitpid(child, 0)[1]:
        print(json.dumps("no answer"), flush=True)
"""

Read = Callable[[str, str], object]


@pytest.fixture(scope="module")
def read() -> Iterator[Read]:
    """`read(source, "expression" or "script")`: "ok" or [exit code, message, length of the text, of what is shown]."""
    with subprocess.Popen(
        [sys.executable, "-c", READER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        to, answers = process.stdin, process.stdout

        def ask(source: str, kind: str) -> object:
            to.write(json.dumps([source, kind]) + "\n")
            to.flush()
            return json.loads(answers.readline())

        yield ask
        to.close()


def check(outcome: object, words: str) -> None:
    if words == OK:
        assert outcome == "ok"
        return
    assert isinstance(outcome, list), outcome
    code, message, length, rendered = outcome
    assert words in message
    assert code == 2
    assert length < 1_000
    assert rendered < 2_000


def table(cases: dict[str, tuple[str, str]]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize(("source", "words"), cases.values(), ids=cases.keys())


@table(EXPRESSIONS)
def test_expression(read: Read, source: str, words: str) -> None:
    check(read(source, "expression"), words)


@table(SCRIPTS)
def test_script(read: Read, source: str, words: str) -> None:
    check(read(source, "script"), words)


def test_the_reader_notices_a_crash(read: Read) -> None:
    assert read("1/0", "expression") == "no answer"


# --- whole computations: an answer or a refusal, with little time and memory -----------------------------------------

# One process loads everything once; for each case it forks a child that has 2 GB and 40 s of the processor.
COMPUTER = """
import json, os, resource, sys, traceback
import numpy
import gcrules as gc
from gcrules.core.errors import GcrulesError
import gcrules.conditions.analysis, gcrules.algebra.factoring.factorize

BIG = "7" * 1000
forty = "".join(f"[p{i} p{19 - i} p{20 + i} p{39 - i}]" for i in range(10))
pair, rest = "[p0 p19 p20 p39][p1 p18 p21 p38]", forty[32:]
def row(i, *steps):
    return "[" + " ".join(f"p{(i + s) % 40}" for s in steps) + "]"

sum_of_forty = " + ".join(row(i, 0, 1, 7, 11) + row(i, 2, 3, 8, 13) for i in range(40))
line = "".join(f"[q{i} q{39 - i}]" for i in range(20))
sixteen = "[p0 p9 p11 p16][p1 p5 p10 p12][p2 p6 p8 p13][p3 p4 p7 p14]"

def straightened(text):
    return str(gc.straighten(text))

def told(found):
    if hasattr(found, "verdict"):
        return found.verdict
    if hasattr(found, "condition"):
        return found.condition.kind
    if hasattr(found, "exists"):
        return "found" if found.exists else "none"
    return f"{len(found)} terms"

def outcome(source):
    try:
        found = eval(source)
        return [0, told(found), len(str(found))]
    except GcrulesError as fault:
        return [fault.exit_code, fault.message, len(fault.render())]

resource.setrlimit(resource.RLIMIT_AS, (2**31, 2**31))
for given in sys.stdin:
    child = os.fork()
    if not child:
        resource.setrlimit(resource.RLIMIT_CPU, (40, 40))
        try:
            print(json.dumps(outcome(json.loads(given))), flush=True)
            os._exit(0)
        except BaseException:
            traceback.print_exc()
            os._exit(1)
    if os.waitpid(child, 0)[1]:
        print(json.dumps("no answer"), flush=True)
"""

ZERO = "the polynomial is zero"
UNEQUAL = "not homogeneous in the points"
HELD = "straightening holds more than 20,000 terms at a time"
SYZYGY = "[abcd][abef] - [abce][abdf] + [abcf][abde]"
DIGITS = "f'{BIG}[afgl][behk][cdij] - {BIG}1[abcd][efgh][ijkl]'"

# What is computed, the exit code that belongs to the outcome, and words of the answer or of the fault.
COMPUTATIONS = {
    "expand zero": ("gc.expand('0')", 0, "0 terms"),
    "straighten zero": (f"gc.straighten('{SYZYGY}')", 0, "0 terms"),
    "factor zero": (f"gc.factor('{SYZYGY}')", 2, ZERO),
    "cofactor of zero": ("gc.factor('[abca][efgh]', cofactor=True)", 2, ZERO),
    "prove zero": (f"gc.prove('{SYZYGY} == 0')", 0, "proved"),
    "prove zero to be zero": ("gc.prove('0 == 0')", 0, "proved"),
    "analyze six times one leg": ("gc.analyze('ab ab ab ab ab ab')", 0, "always-singular"),
    "expand unlike terms": ("gc.expand('[abcd][efgh] + [abce] + 7')", 0, "3 terms"),
    "straighten unlike terms": ("gc.straighten('[abcd][efgh] + [adef][bcgh] + [abce] + 7')", 0, "terms"),
    "factor unlike terms": ("gc.factor('[abcd] + [abce]')", 2, UNEQUAL),
    "factor unlike degrees": ("gc.factor('[abcd] + 1')", 2, UNEQUAL),
    "cofactor for unlike terms": ("gc.factor('[abcd] + [abce]', cofactor=True)", 2, UNEQUAL),
    "prove unlike terms": ("gc.prove('[abcd] + 1 == [abce]')", 0, "refuted"),
    "a number": ("gc.factor('7')", 0, "found"),
    "factor a line": ("gc.factor('ab')", 2, "only scalars are factored"),
    "expand 1,000 digits": (f"gc.expand({DIGITS})", 0, "2 terms"),
    "straighten 1,000 digits": (f"gc.straighten({DIGITS})", 0, "15 terms"),
    "factor 1,000 digits": ("gc.factor(f'{BIG} [abcd] (efg /\\ abh /\\ cd)')", 0, "found"),
    "factor 1,000 digits, none": (f"gc.factor({DIGITS})", 0, "none"),
    "prove with 1,000 digits": (f"gc.prove({DIGITS} + ' == 0')", 0, "refuted"),
    "analyze, 1,000 digits given": (
        "gc.analyze('ab cd ef gh ij kl', given=f'[abcd] == {BIG}[abce]')",
        0,
        "linear-complex",
    ),
    "more digits than are read": ("gc.expand('7' * 2_001 + '[abcd]')", 2, "the limit is 2,000"),
    "expand 40 points": ("gc.expand(forty)", 0, "1 terms"),
    "straighten 40 points": ("gc.straighten(forty, limit=20_000)", 3, HELD),
    "straighten 40 points on a line": ("gc.straighten(line, rank=2, limit=20_000)", 3, HELD),
    "straighten a sum over 40 points": ("gc.straighten(sum_of_forty)", 0, "terms"),
    "straighten its square": ("gc.straighten(f'({sum_of_forty})**2', limit=20_000)", 3, HELD),
    "expand a power of it": ("gc.expand(f'({sum_of_forty})**64', limit=20_000)", 3, "expansion"),
    "factor 40 points": ("gc.factor(forty)", 0, "found"),
    "prove of 40 points": ("gc.prove(f'{forty} == 2{forty}')", 0, "refuted"),
    "a syzygy among 40 points": ("gc.prove(f'{pair}{rest} == ({straightened(pair)}){rest}')", 0, "proved"),
    "analyze with 40 points declared": (
        "gc.analyze('ab cd ef gh ij kl', points=[f'p{i}' for i in range(28)] + list('abcdefghijkl'))",
        0,
        "linear-complex",
    ),
    "analyze 20 legs": ("gc.analyze(' '.join(f'p{2 * i}p{2 * i + 1}' for i in range(20)))", 2, "20 legs, expected six"),
    "straighten 16 points": ("gc.straighten(sixteen)", 0, "terms"),
    "rank 8": ("gc.straighten('[aybgcfde][ipjoknlm][qxrwsvtu]', rank=8)", 0, "terms"),
    "rank 8, worse": (
        "gc.straighten('[ahiknoqx][bglmprvw][cdefjstu]', rank=8, limit=5_000)",
        3,
        "more than 125,000 replacements",
    ),
}

Compute = Callable[[str], object]


@pytest.fixture(scope="module")
def compute() -> Iterator[Compute]:
    """`compute(source)`: [exit code, answer or message, length of what is shown], or "no answer"."""
    with subprocess.Popen(
        [sys.executable, "-c", COMPUTER],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        to, answers = process.stdin, process.stdout

        def ask(source: str) -> object:
            to.write(json.dumps(source) + "\n")
            to.flush()
            return json.loads(answers.readline())

        yield ask
        to.close()


@pytest.mark.parametrize(("source", "code", "words"), COMPUTATIONS.values(), ids=COMPUTATIONS.keys())
def test_computation(compute: Compute, source: str, code: int, words: str) -> None:
    found = compute(source)
    assert isinstance(found, list), found
    exit_code, answer, shown = found
    assert (exit_code, words in answer) == (code, True), answer
    assert exit_code == 0 or shown < 2_000


def test_the_computer_notices_too_much_memory(compute: Compute) -> None:
    assert compute("bytearray(2**32)") == "no answer"


@pytest.mark.parametrize(
    "limit",
    [
        parse_tree.MAX_TEXT,
        parse_tree.MAX_NESTING,
        syntax.MAX_DEPTH,
        syntax.MAX_NODES,
        parse_tree.MAX_DIGITS,
        syntax.MAX_WORD,
        space.MAX_NAMES,
        MAX_EXPONENT,
        ex.MAX_COEFFICIENT_BITS,
        MAX_DOTTED_TERMS,
        expand.MAX_TERMS,
        straighten.WORK_PER_TERM * expand.MAX_TERMS,
    ],
)
def test_the_limits_are_documented(root: Path, limit: int) -> None:
    limits = (root / "docs" / "language.md").read_text(encoding="utf-8").partition("## Limits")[2]
    assert f"| {limit:,} " in limits
