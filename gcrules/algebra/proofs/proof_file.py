"""A proof file: theorems with their proofs, which a program that shares no code with gcrules checks."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from hashlib import sha256
from typing import Any

from gcrules.algebra.proofs.theorem import Theorem
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.core.version import __version__

__all__ = ["FORMAT", "VERSION", "Absence", "LeftOut", "ProofFile"]

FORMAT = "gcrules proof"
VERSION = 1


@dataclass(frozen=True)
class LeftOut:
    """Something that the answer says and the file does not prove, and why not."""

    name: str
    reason: str

    def __str__(self) -> str:
        return f"{self.name}: {self.reason}"


@dataclass(frozen=True)
class Absence:
    """That something does not exist, which is no identity: another program recomputes it from what is `stated`.

    `claim` is in words, and about the right side of `theorem`; `kind` says what was enumerated.
    """

    name: str
    claim: str
    kind: str
    theorem: str
    stated: Mapping[str, Any]

    def to_json(self) -> dict[str, Any]:
        """The absence as `proof.schema.json` describes it."""
        return {"claim": self.claim, "theorem": self.theorem, "kind": self.kind, **self.stated}


@dataclass(frozen=True)
class ProofFile(Shown):
    """The theorems of one answer; `title` says whose they are, `left_out` what of it is not proved in the file, and
    `absences` what is not proved but can be recomputed.
    """

    title: str
    theorems: tuple[Theorem, ...]
    left_out: tuple[LeftOut, ...] = ()
    absences: tuple[Absence, ...] = ()

    @cached_property
    def _lines(self) -> tuple[str, ...]:
        """The theorems with their proofs, each as one line of JSON."""
        return _lines(self.theorems)

    @cached_property
    def digest(self) -> str:
        """The SHA-256 digest of the theorems with their proofs, which reports and papers name. It does not cover the
        absences, which are about these theorems.
        """
        return sha256(f"[{','.join(self._lines)}]".encode()).hexdigest()

    def to_json(self) -> dict[str, Any]:
        """The file as `proof.schema.json` describes it."""
        theorems, absences = ([one.to_json() for one in some] for some in (self.theorems, self.absences))
        return {**self._head(), "theorems": theorems, "absences": absences}

    def json_text(self) -> str:
        """The file: one theorem or absence to a line."""
        lists = {"theorems": self._lines, "absences": _lines(self.absences)}
        shown = (f' "{name}": [{_indented(lines)}]' for name, lines in lists.items())
        return ",\n".join([json.dumps(self._head(), indent=1)[:-2], *shown]) + "\n}\n"

    def _head(self) -> dict[str, Any]:
        return {
            "format": FORMAT,
            "version": VERSION,
            "title": self.title,
            "gcrules": __version__,
            "digest": self.digest,
            "left_out": [{"name": one.name, "reason": one.reason} for one in self.left_out],
        }

    def coq(self) -> str:
        """A script of Coq that proves the same theorems without axioms."""
        return str(self._show("coq"))

    def lean(self) -> str:
        """The polynomials that the theorems expand to, as text of Lean 4, which is not checked here."""
        return str(self._show("lean"))


def _lines(some: Iterable[Theorem | Absence]) -> tuple[str, ...]:
    return tuple(json.dumps(one.to_json(), separators=(",", ":"), ensure_ascii=False) for one in some)


def _indented(lines: Sequence[str]) -> str:
    return "\n" + ",\n".join(lines) + "\n " if lines else ""
