"""The public function that looks for theorems."""

from __future__ import annotations

from collections.abc import Iterable
from os import PathLike, fspath

from gcrules.algebra.discovery.discover import asked
from gcrules.algebra.discovery.discover import discover as _discover
from gcrules.algebra.discovery.limits import MAX_CANDIDATES, SECONDS
from gcrules.algebra.discovery.result import Discoveries
from gcrules.algebra.expand import MAX_TERMS
from gcrules.algebra.language.statements import parse_script
from gcrules.api.signatures import public
from gcrules.core.yaml_file import read_text

__all__ = ["Discoveries", "discover"]


@public
def discover(
    script: str | PathLike[str],
    *,
    relations: str | Iterable[str] = (),
    limit: int = MAX_TERMS,
    candidates: int = MAX_CANDIDATES,
    seconds: float = SECONDS,
) -> Discoveries:
    """All incidences of what a script draws that hold and are not trivial, each proved or said to be undecided.

    A script is the name of a `.gca` file or its text: points, points at infinity, assumptions, names by `let`; its
    claims are not looked at. `relations` are some of "equal", "incident", "collinear", "concurrent", "coplanar" and
    "on_conic", for letters of conics and quadrics "on_quadric", "touches", "polar" and "conjugate", all of them if none
    is named. A proof that takes more than `limit` terms leaves an incidence undecided; for `seconds` positions are
    looked for at which one that is proved fails. Raises InputError for assumptions that are not resolved and in ranks
    other than 3 and 4, LimitReached for more than `candidates` sets of points and lines.
    """
    written = fspath(script)
    named = not isinstance(script, str) or written.endswith(".gca")
    read = parse_script(read_text(written), written) if named else parse_script(written)
    return _discover(read.context, relations=asked(relations), limit=limit, most=candidates, seconds=seconds)
