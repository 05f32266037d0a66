"""Hostile input ends in an answer or a clear error, in bounded time and memory, never in a traceback."""

from __future__ import annotations

import json
import resource
import subprocess
import sys

import pytest

MEMORY = 2**30  # bytes of address space
SECONDS = 20
LIMIT = 240_000  # characters, just below the limit of the language
MEGABYTE = 10**6

# What is fed to the parser, as Python source so that a megabyte does not travel through the command line.
EXPRESSIONS = {
    "20,000 open parentheses": '"(" * 20_000',
    "20,000 nested parentheses": '"(" * 20_000 + "a" + ")" * 20_000',
    "20,000 open brackets": '"[" * 20_000',
    "20,000 minus signs": '"-" * 20_000 + "[abcd]"',
    "minus signs": f'"-" * {LIMIT} + "a"',
    "brackets in brackets": 'nested("[({})a, b, c, d]", "[abcd]", 48)',
    "superbrackets in superbrackets": 'nested("[[{} ab,cd,ef,gh,ij,kl]]", "[[ab,cd,ef,gh,ij,kl]]", 24)',
    "every operation, nested": r'nested("(-{}**2 c \\/ d /\\ ab * 2 + 1)", "[abcd]", 97)',
    "powers of powers": 'nested("({}**64)", "[abcd]", 90)',
    "powers of powers of numbers": 'nested("({}**64)", "3", 90)',
    "a megabyte of parentheses": f'"(" * {MEGABYTE}',
    "a megabyte of letters": f'"a" * {MEGABYTE}',
    "a megabyte of digits": f'"1" * {MEGABYTE}',
    "a megabyte of blanks": f'" " * {MEGABYTE}',
    "a megabyte of lines": f'"\\n" * {MEGABYTE}',
    "letters": f'"a" * {LIMIT}',
    "digits": f'"1" * {LIMIT}',
    "primes": f'"a" + "\'" * {LIMIT}',
    "underscores": f'"a_" * {LIMIT // 2}',
    "blanks": f'" " * {LIMIT}',
    "dots": f'"." * {LIMIT}',
    "quotes": f"'\"' * {LIMIT}",
    "hashes": f'"#" * {LIMIT}',
    "product": f'"[abcd]" * {LIMIT // 6}',
    "sum": f'"+".join(["[abcd]"] * {LIMIT // 7})',
    "sum of numbers": f'"+".join(["1"] * {LIMIT // 2})',
    "product of numbers": f'"9 " * {LIMIT // 2}',
    "sum of fractions": '"+".join(f"1/{n}" for n in range(10_007, 37_007))',
    "product of fractions": '"*".join(f"1/{n}" for n in range(10_007, 37_007))',
    "fault at the end": f'"+".join(["[abcd]"] * {LIMIT // 7}) + "+*"',
    "entries": f'"[" + "a," * {LIMIT // 2} + "a]"',
    "dotted entries": f'"[." + "a" * {LIMIT} + "]"',
    "lines of a superbracket": f'"[[" + "ab," * {LIMIT // 3} + "ab]]"',
    "joins": rf'"a\\/" * {LIMIT // 3} + "b"',
    "meets": rf'"abc/\\" * {LIMIT // 5} + "abc"',
    "dotted brackets": f'"[.a b c d]" * {LIMIT // 10}',
    "nul": '"\\0" * 100_000',
    "every byte": 'bytes(range(256)).decode("latin-1") * 900',
    "random bytes": 'random.Random(0).randbytes(200_000).decode("latin-1")',
    "random bytes as UTF-8": 'random.Random(0).randbytes(200_000).decode("utf-8", "replace")',
    "random signs of the language": '"".join(random.Random(1).choices("abAB1\'_.,+-*/^()[] \\\\\\n", k=200_000))',
    "surrogates": '"\\ud800" * 1000',
    "combining dots": f'"a\\u0307" * {LIMIT // 2}',
    "combining dots alone": f'"\\u0307" * {LIMIT}',
}
SCRIPTS = {
    "doubling sums": 'lets("{0}+{0}", 100)',
    "doubling products": 'lets("{0}*{0}", 100)',
    "doubling, not flat": 'lets("({0}+1)*({0}+2)", 100)',
    "powers": 'lets("{0}**64", 100)',
    "deep": r'lets("({0} e /\\ fgh) \\/ ijk /\\ lm", 300)',
    "a long sum many times": f'long_sum + "show " + "+".join(["x"] * {LIMIT // 4})',
    "a long sum subtracted many times": f'long_sum + "show " + "-".join(["x"] * {LIMIT // 4})',
    "a long sum bound many times": f'long_sum + "let y = " + "+".join(["x"] * {LIMIT // 4})',
    "many names": '"\\n".join(f"let x{i} = ab" for i in range(15_000))',
    "many points": '"points " + " ".join(f"pt{i}" for i in range(20_000))',
    "many statements of points": '"\\n".join(f"points pt{i}" for i in range(15_000))',
    "many claims": '"claim a==a\\n" * 20_000',
    "long label": f"'claim \"' + 'x' * {LIMIT} + '\": a == b'",
    "nul": '"\\0" * 1000',
    "random bytes": 'random.Random(2).randbytes(200_000).decode("latin-1")',
    "random words": '" ".join(random.Random(3).choices('
    '["rank", "points", "ideal", "let", "claim", "show", "=", "==", "a", "[abcd]", "3", "+"], k=40_000))',
}

CHILD = """
import json, random, sys
from gcrules.algebra.syntax import parse, parse_script
from gcrules.algebra.text import text
from gcrules.algebra.expr import points_of
from gcrules.errors import GcrulesError

def nested(form, inner, times):
    for _ in range(times):
        inner = form.replace("{}", inner)
    return inner

def lets(form, times):
    lines = ["let x0 = [abcd]"]
    return "\\n".join(lines + [f"let x{i + 1} = " + form.format(f"x{i}") for i in range(times)])

long_sum = "let x = " + "+".join(["[abcd]"] * 16_000) + "\\n"
sys.set_int_max_str_digits(0)
for source, read in json.load(sys.stdin):
    try:
        found = (parse if read == "expression" else parse_script)(eval(source))
        if read == "expression":
            hash(found), points_of(found), text(found), text(found, unicode=True)
        print(json.dumps("ok"))
    except GcrulesError as fault:
        print(json.dumps([fault.exit_code, len(str(fault)), len(fault.render().encode("utf-8", "replace"))]))
"""


def in_child(source: str, read: str) -> object:
    """The outcome in a process of its own with little memory and time: "ok" or [exit code, length of the message …]."""

    def limit() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    done = subprocess.run(
        [sys.executable, "-c", CHILD],
        input=json.dumps([[source, read]]),
        capture_output=True,
        text=True,
        timeout=SECONDS,
        preexec_fn=limit,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    return json.loads(done.stdout)


def check(outcome: object) -> None:
    if outcome != "ok":
        assert isinstance(outcome, list)
        code, message, rendered = outcome
        assert code == 2
        assert message < 1_000
        assert rendered < 2_000


def table(cases: dict[str, str]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("source", cases.values(), ids=cases.keys())


@table(EXPRESSIONS)
def test_expression(source: str) -> None:
    check(in_child(source, "expression"))


@table(SCRIPTS)
def test_script(source: str) -> None:
    check(in_child(source, "script"))


FAULTY = [
    "20,000 open parentheses",
    "20,000 nested parentheses",
    "a megabyte of letters",
    "a megabyte of digits",
    "nul",
]


@pytest.mark.parametrize("name", FAULTY)
def test_is_refused(name: str) -> None:
    assert in_child(EXPRESSIONS[name], "expression") != "ok"


def test_minus_signs_are_not_nesting() -> None:
    assert in_child(EXPRESSIONS["20,000 minus signs"], "expression") == "ok"
