"""What a text of the language is refused for, for tests with tables of faults."""

from __future__ import annotations

import pytest

from gcrules.algebra.language.statements import parse_script
from gcrules.core.errors import GcrulesError

__all__ = ["refused"]


def refused(text: str, message: str) -> None:
    """Assert that a script is refused with a message in which this stands, and with its place."""
    with pytest.raises(GcrulesError) as fault:
        parse_script(text)
    assert message in fault.value.message
    assert fault.value.span is not None
