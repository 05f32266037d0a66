"""Files of certificates, read strictly, and answers as exit codes, for `check_map.py` and the programs beside it."""

from __future__ import annotations

import argparse
import gzip
import hashlib
import io
import json
import math
import sys
import zlib

from certificate_bounds import Refused, once
from map_slice import Malformed, expect

BROKEN = (
    ArithmeticError,
    AttributeError,
    EOFError,
    LookupError,
    OSError,
    RecursionError,
    TypeError,
    ValueError,
    zlib.error,
)
MOST_BYTES = 100_000_000


def check_digest(data):
    text = json.dumps({k: v for k, v in data.items() if k != "digest"}, sort_keys=True, separators=(",", ":"))
    expect(data["digest"] == hashlib.sha256(text.encode()).hexdigest(), "it names another digest")


def read(name, of_joints=()):
    """The contents of a file; only the formats `of_joints` have numbers that are not whole. Raises Malformed."""
    with open(name, "rb") as file:
        data = file.read(MOST_BYTES + 1)
    if data[:2] == b"\x1f\x8b":
        data = gzip.GzipFile(fileobj=io.BytesIO(data)).read(MOST_BYTES + 1)
    expect(len(data) <= MOST_BYTES, f"more than {MOST_BYTES:,} bytes")
    try:
        found = json.loads(data, object_pairs_hook=once, parse_constant=once, parse_float=finite)
    except Refused:
        raise Malformed("a name twice, or a number that is none") from None
    expect(isinstance(found, dict), "no certificate")
    expect(found.get("format") in of_joints or not has_float(found), "a number is not whole")
    return found


def finite(text):
    """A number with decimals, which only the geometry of joints has."""
    number = float(text)
    expect(math.isfinite(number), "a number that is too large")
    return number


def has_float(value):
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return isinstance(value, float) or any(map(has_float, inner))


def answered(words, checked, of_joints=(), most=None):
    """The exit code of a program that is called with a file, whose answer it prints: `checked` gives it in words, with
    a number that is not 0 where a part is not decided. With `most` it takes --most N too.
    """
    parser = argparse.ArgumentParser(description=words)
    parser.add_argument("file", metavar="FILE.json[.gz]")
    if most:
        parser.add_argument("--most", type=int, default=most, metavar="N", help=f"boxes at most (default {most:,})")
    arguments = parser.parse_args()
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")
    more = (arguments.most,) if most else ()
    try:
        found, left = checked(read(arguments.file, of_joints), lambda text: print(text, file=sys.stderr), *more)
    except Malformed as fault:
        print(f"refused: {fault}")
        return 2
    except Refused as fault:
        print(f"refused: {fault}")
        return 1
    except BROKEN as fault:
        print(f"refused: no certificate ({type(fault).__name__}: {str(fault)[:200]})")
        return 2
    print(found)
    return 3 if left else 0
