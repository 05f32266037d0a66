"""Where the proofs of an answer are written: --certificate, --coq, --lean."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import wraps
from operator import methodcaller
from typing import Any

import click

from gcrules.apps.cli.files import OutputFile, working
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.digests import beginning
from gcrules.core.english import counted
from gcrules.core.errors import InputError
from gcrules.core.files import write_file

__all__ = ["ProofOptions", "proof_options"]

_Command = Callable[..., Any]

proof_file = deferred("gcrules.mechanisms.proofs:proof_file")


@dataclass(frozen=True)
class _Format:
    """`suffix` of the file, `words` of the help; the `text` of a proof file, with one line for `each` theorem that
    begins so.
    """

    suffix: str
    words: str
    text: Callable[[Any], str]
    each: str


_FORMATS: dict[str, _Format] = {
    "certificate": _Format(
        ".json",
        "Write the theorems with their proofs, which check_proof.py of `gcrules checkers` checks without gcrules.",
        methodcaller("json_text"),
        '{"name":',
    ),
    "coq": _Format(
        ".v",
        "Write them as a script of Coq, which proves them without axioms.",
        methodcaller("coq"),
        "Print Assumptions ",
    ),
    "lean": _Format(
        ".lean",
        "Write the polynomials that they expand to as text of Lean 4, which is not checked here.",
        methodcaller("lean"),
        "theorem ",
    ),
}


@dataclass(frozen=True)
class ProofOptions:
    """The files that were asked for, by their formats."""

    files: Mapping[str, str]

    def write(self, answer: Any, verdict: str = "proved", what: str = "the answer") -> None:
        """Write the proofs of an answer; one that is not proved has none, which is said. Raises InputError for an
        answer of which there is no proof to write.
        """
        if verdict != "proved":
            for path in self.files.values():
                click.echo(f"note: {path} is not written, since {what} is {verdict}", err=True)
            return
        if not self.files:
            return
        with working("writing the proofs"):
            proofs = proof_file(answer)
            texts, missing = self._texts(proofs)
            for name, text in texts.items():
                write_file(self.files[name], text)
        for name, text in texts.items():
            number = counted(text.count(f"\n{_FORMATS[name].each}"), "theorem")
            of = f", digest {beginning(proofs.digest)}" if name == "certificate" else f" of {len(proofs.theorems)}"
            click.echo(f"{self.files[name]}: {number}{of}", err=True)
        if "certificate" in texts and click.get_current_context().params.get("as_latex"):
            click.echo(f"% proofs that a program checks: SHA-256 digest {proofs.digest}")
        for path, why in missing.items():
            click.echo(f"note: {path} is not written: {why}", err=True)
        for absence in proofs.absences if "certificate" in texts else ():
            path = self.files["certificate"]
            click.echo(f"note: without a proof, {path} states what was enumerated: {absence.name}", err=True)
            again = f"python checkers/recompute.py {path} computes this again without gcrules"
            click.echo(f"note: {again}; `gcrules checkers` writes the program", err=True)
        for one in proofs.left_out:
            click.echo(f"note: without a proof in the file: {one}", err=True)

    def _texts(self, proofs: Any) -> tuple[dict[str, str], dict[str, str]]:
        """The texts of the files, and why files cannot be written. Raises InputError where none can."""
        texts, missing = {}, {}
        for name, path in self.files.items():
            try:
                texts[name] = _FORMATS[name].text(proofs)
            except InputError as fault:
                missing[path] = fault.message
                if len(missing) == len(self.files):
                    raise
        return texts, missing


def proof_options(command: _Command) -> _Command:
    """The command receives them as `proofs`."""

    @wraps(command)
    def with_proofs(**options: Any) -> Any:
        asked = {name: options.pop(name) for name in _FORMATS}
        return command(proofs=ProofOptions({name: path for name, path in asked.items() if path}), **options)

    for name, one in reversed(_FORMATS.items()):
        option = click.option(
            f"--{name}", name, type=OutputFile(one.suffix, noun="proof"), metavar=f"FILE{one.suffix}", help=one.words
        )
        with_proofs = option(with_proofs)
    return with_proofs
