r"""Which identities of catalogs are proved: those that are shipped by their digests, all others here and now.

`catalog.sha256` holds the digest of every identity and sentence of the shipped catalog; `gcrules catalog check` proves
the identities and compares the digests. What has no digest there comes from outside, be it a catalog of the user's own
or a shipped one that was changed: it is proved by normal forms before it becomes an answer (once, see
`core.proof_memory`), or the answer says who claims it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from importlib.resources import files
from shlex import quote

from gcrules.algebra.evaluate import vanishes
from gcrules.algebra.expr import ZERO, sub
from gcrules.algebra.prove import Proof, prove
from gcrules.core.dataclass import dataclass
from gcrules.core.digests import beginning
from gcrules.core.errors import FileError
from gcrules.core.proof_memory import digest_of, remember, remembered
from gcrules.rules.catalog.entries import CatalogIdentity, Entry

__all__ = ["DIGESTS", "ProofStatus", "counterexample", "digests", "is_shipped", "is_shipped_sentence", "proof_status"]

DIGESTS = "catalog.sha256"


@dataclass(frozen=True)
class ProofStatus:
    """How an identity of a class stands: `verdict` is shipped | proved | unproved, `detail` in words."""

    verdict: str
    detail: str
    digest: str


def proof_status(entry: Entry, reading: CatalogIdentity) -> ProofStatus:
    """Look the proof of an identity up, or prove it. Raises FileError, with the place and exact points, where it is
    false or says nothing.
    """
    if is_shipped(entry, reading):
        digest = _digest(entry, reading)
        return ProofStatus("shipped", f"proved by gcrules catalog check (digest {beginning(digest)})", digest)
    digest = _identity_digest(entry, reading)
    proved = ProofStatus("proved", "proved: both sides have the same normal form of standard tableaux", digest)
    if remembered(digest):
        return proved
    what = f"the reading {reading.expression_text} of class {entry.id}"
    hint = f"`gcrules catalog check --catalog {quote(entry.owner)}` says all that is wrong in it"
    if vanishes(reading.cofactor):
        raise FileError(f"{what} says nothing: its cofactor is zero", filename=reading.place or entry.place, hint=hint)
    left, right = entry.sides(reading)
    found = prove(sub(left, right), ZERO)
    if found.verdict == "refuted":
        why = f"{what} is not an identity: it fails at {counterexample(found)}"
        raise FileError(why, filename=reading.place or entry.place, hint=hint)
    if not found.proved:
        return ProofStatus("unproved", found.reason, digest)
    remember(digest)
    return proved


def counterexample(proof: Proof) -> str:
    """The points of a refutation in words; their weights may be what refutes."""
    points = proof.counterexample or {}
    finite = all(c[-1] == 1 for c in points.values())
    shown = ", ".join(f"{n} = ({', '.join(map(str, c[:-1] if finite else c))})" for n, c in points.items())
    return shown if finite else f"{shown} (homogeneous coordinates)"


def is_shipped(entry: Entry, reading: CatalogIdentity) -> bool:
    """Whether an identity with its sentence is one that was shipped and proved."""
    return _digest(entry, reading) in _shipped_digests()


def _sentence_digest(kind: str, sentence: str) -> str:
    return digest_of("sentence", kind, sentence)


def is_shipped_sentence(kind: str, sentence: str) -> bool:
    """Whether the sentence of a kind of conditions is the shipped one."""
    return _sentence_digest(kind, sentence) in _shipped_digests()


def digests(statements: Mapping[str, str], entries: Iterable[Entry]) -> str:
    """The text of `catalog.sha256` for sentences and classes: one digest a line, and of what it is."""
    return "".join(f"{digest}  {what}\n" for digest, what in _digests(statements, entries))


def _digests(statements: Mapping[str, str], entries: Iterable[Entry]) -> Iterator[tuple[str, str]]:
    for kind, sentence in statements.items():
        yield _sentence_digest(kind, sentence), f"the sentence of {kind}"
    for entry in entries:
        for number, reading in enumerate((entry.condition, *entry.readings)):
            yield _digest(entry, reading), f"class {entry.id}, {f'reading {number}' if number else 'condition'}"


@cache
def _shipped_digests() -> frozenset[str]:
    text = files("gcrules").joinpath(DIGESTS).read_text(encoding="utf-8")
    return frozenset(line.split()[0] for line in text.splitlines() if line.strip())


def _identity_digest(entry: Entry, reading: CatalogIdentity) -> str:
    legs = " ".join("-".join(leg) for leg in entry.legs)
    return digest_of("identity", legs, reading.cofactor_text, str(reading.coefficient), reading.expression_text)


def _digest(entry: Entry, reading: CatalogIdentity) -> str:
    lines = "; ".join(f"{n}: {line}" for n, line in reading.line_texts)
    return digest_of(_identity_digest(entry, reading), reading.kind, reading.statement or "", lines)
