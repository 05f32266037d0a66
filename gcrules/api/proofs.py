"""The public functions about proofs that others check."""

from __future__ import annotations

from typing import Any

from gcrules.algebra.proofs.proof_file import ProofFile
from gcrules.api.signatures import public
from gcrules.mechanisms.proofs import proof_file as _proof_file

__all__ = ["ProofFile", "proof_file"]


@public
def proof_file(answer: Any) -> ProofFile:
    """The theorems of an answer, each with a proof that can be replayed without gcrules.

    An answer is what `prove`, `factor`, `factors`, `shorten`, `transversals` or `analyze` give. The file has
    `theorems`, `absences` (what does not exist, with what was enumerated; this is recomputed, not proved), `left_out`
    (what else the answer says, with the reason) and a `digest`; `json_text()` is what programs check and recompute that
    `gcrules checkers` writes, `coq()` a script that Coq checks, `lean()` the polynomials that the theorems expand to as
    text of Lean 4, which is not checked. Raises InputError for any other kind of answer, and where nothing is left to
    prove.
    """
    return _proof_file(answer)
