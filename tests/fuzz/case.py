"""One input: what is typed, the files that are there, what is piped in; and how it is kept as YAML."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields
from typing import Any

import yaml

__all__ = ["Case", "from_yaml", "to_yaml"]


@dataclass(frozen=True)
class Case:
    """An input of a family. Texts may hold surrogates: bytes that are no UTF-8, as Python shows those of a file name.

    `seconds` is the time that the input itself allows; `mixed` says that answers and faults may stand beside each other
    (a prompt goes on after a fault). `data` is for families that are no command lines.
    """

    family: str
    argv: tuple[str, ...] = ()
    files: Mapping[str, str] = field(default_factory=dict)
    stdin: str = ""
    seconds: float = 0.0
    mixed: bool = False
    data: Any = None


_EMPTY = Case("")


def to_yaml(case: Case, **more: Any) -> str:
    """The case, what is empty left out, with more keys before it (the expected exit code, a remark)."""
    values = {k: v for k, v in asdict(case).items() if v != getattr(_EMPTY, k)}
    plain = {k: list(v) if isinstance(v, tuple) else v for k, v in values.items()}
    return yaml.safe_dump({**more, **plain}, sort_keys=False, allow_unicode=False, width=110)


def from_yaml(text: str) -> tuple[Case, dict[str, Any]]:
    """The case, and the other keys."""
    found = yaml.safe_load(text)
    known = {f.name for f in fields(Case)}
    values = {k: tuple(v) if k == "argv" else v for k, v in found.items() if k in known}
    return Case(**values), {k: v for k, v in found.items() if k not in known}
