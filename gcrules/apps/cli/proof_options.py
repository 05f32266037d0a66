"""Where the proofs of an answer are written: --certificate, --coq, --lean."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Any

import click

from gcrules.apps.cli.files import OutputFile, working
from gcrules.core.dataclass import dataclass
from gcrules.core.deferred import deferred
from gcrules.core.english import counted
from gcrules.core.files import write_file

__all__ = ["ProofOptions", "proof_options"]

_Command = Callable[..., Any]

proof_file = deferred("gcrules.mechanisms.proofs:proof_file")

_FORMATS = {
    "certificate": (".json", "Write the theorems with their proofs, which a program checks without gcrules."),
    "coq": (".v", "Write them as a script of Coq, which proves them without axioms."),
    "lean": (".lean", "Write them as text of Lean 4, which is not checked here."),
}
_EACH = {"certificate": '{"name":', "coq": "Print Assumptions ", "lean": "theorem "}
"""How a line begins, of which a file has one for each theorem."""


@dataclass(frozen=True)
class ProofOptions:
    """The files that were asked for, each None or its name."""

    certificate: str | None = None
    coq: str | None = None
    lean: str | None = None

    def write(self, answer: Any, verdict: str = "proved") -> None:
        """Write the proofs of an answer; one that is not proved has none, which is said. Raises InputError for an
        answer of which there is no proof to write.
        """
        wanted = {form: path for form in _FORMATS if (path := getattr(self, form))}
        if verdict != "proved":
            for path in wanted.values():
                click.echo(f"note: {path} is not written, since the answer is {verdict}", err=True)
            return
        if not wanted:
            return
        with working("writing the proofs"):
            proofs = proof_file(answer)
            texts = {"certificate": proofs.json_text, "coq": proofs.coq, "lean": proofs.lean}
            for form, path in wanted.items():
                text = texts[form]()
                write_file(path, text)
                number = text.count("\n" + _EACH[form])
                click.echo(f"{path}: {counted(number, 'theorem')}, digest {proofs.digest[:12]}", err=True)
        for one in proofs.left_out:
            click.echo(f"note: no proof is written of {one}", err=True)


def proof_options(command: _Command) -> _Command:
    """The command receives them as `proofs`."""

    @wraps(command)
    def with_proofs(**options: Any) -> Any:
        return command(proofs=ProofOptions(**{form: options.pop(form) for form in _FORMATS}), **options)

    for form, (suffix, words) in reversed(_FORMATS.items()):
        option = click.option(f"--{form}", form, type=OutputFile(), metavar=f"FILE{suffix}", help=words)
        with_proofs = option(with_proofs)
    return with_proofs
