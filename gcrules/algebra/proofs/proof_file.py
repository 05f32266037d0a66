"""A proof file: theorems with their proofs, which a program that shares no code with gcrules checks."""

from __future__ import annotations

import json
from hashlib import sha256
from typing import Any

from gcrules.algebra.proofs.theorem import Theorem
from gcrules.core.dataclass import dataclass
from gcrules.core.shown import Shown
from gcrules.core.version import __version__

__all__ = ["FORMAT", "VERSION", "LeftOut", "ProofFile"]

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
class ProofFile(Shown):
    """The theorems of one answer; `title` says whose they are, `left_out` what of it is not proved in the file."""

    title: str
    theorems: tuple[Theorem, ...]
    left_out: tuple[LeftOut, ...] = ()

    @property
    def digest(self) -> str:
        """The SHA-256 digest of the theorems with their proofs, which reports and papers name."""
        return sha256(_compact([t.to_json() for t in self.theorems]).encode()).hexdigest()

    def to_json(self) -> dict[str, Any]:
        """The file as `proof.schema.json` describes it."""
        return {
            "format": FORMAT,
            "version": VERSION,
            "title": self.title,
            "gcrules": __version__,
            "digest": self.digest,
            "left_out": [{"name": one.name, "reason": one.reason} for one in self.left_out],
            "theorems": [t.to_json() for t in self.theorems],
        }

    def json_text(self) -> str:
        """The file: one theorem to a line."""
        head = {key: value for key, value in self.to_json().items() if key != "theorems"}
        theorems = ",\n".join(_compact(t.to_json()) for t in self.theorems)
        return f'{json.dumps(head, indent=1)[:-2]},\n "theorems": [\n{theorems}\n ]\n}}\n'

    def coq(self) -> str:
        """A script of Coq that proves the same theorems without axioms."""
        return str(self._show("coq"))

    def lean(self) -> str:
        """The same as text of Lean 4, which is not checked here."""
        return str(self._show("lean"))


def _compact(value: Any) -> str:
    return json.dumps(value, separators=(",", ":"), ensure_ascii=False)
