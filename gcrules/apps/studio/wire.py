"""How the server and its workers speak: one frame after the other, each a length and a pickled value.

Both ends are processes of the same program, joined by a pipe that nobody else holds.
"""

from __future__ import annotations

import json
import pickle
import struct
from asyncio import StreamReader
from collections.abc import Callable, Mapping
from typing import Any, BinaryIO

from gcrules.apps.studio.protocol.messages import Told
from gcrules.apps.studio.protocol.requests import SourceJson

__all__ = ["GIVE_UP", "Job", "Tell", "framed", "key_of", "read", "read_frame"]

Job = tuple[str, Mapping[str, Any], Any]
"""Name of a method, its arguments, and the subject of their source, where the server knows it."""

GIVE_UP = None
"""Sent in place of a job: nobody waits for the answer to the last one any more. It is answered all the same."""

Tell = Callable[[Told], None]
"""Hears how far some work is, and the parts of its answer that are there."""


def key_of(source: SourceJson) -> str:
    """One text for each source."""
    return json.dumps(source, sort_keys=True)


_LENGTH = struct.Struct(">Q")


def framed(value: Any) -> bytes:
    """The bytes of one value."""
    data = pickle.dumps(value, protocol=pickle.HIGHEST_PROTOCOL)
    return _LENGTH.pack(len(data)) + data


def read(pipe: BinaryIO) -> Any:
    """The next value. Raises EOFError where the other end is gone."""
    return pickle.loads(_exactly(pipe, _LENGTH.unpack(_exactly(pipe, _LENGTH.size))[0]))


def _exactly(pipe: BinaryIO, size: int) -> bytes:
    data = pipe.read(size)
    if len(data) < size:
        raise EOFError
    return data


async def read_frame(pipe: StreamReader) -> Any:
    """The next value. Raises asyncio.IncompleteReadError where the other end is gone."""
    (size,) = _LENGTH.unpack(await pipe.readexactly(_LENGTH.size))
    return pickle.loads(await pipe.readexactly(size))
