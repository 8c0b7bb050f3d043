"""Messages: what a tape consists of. Each is a head in JSON and the bytes that it refers to.

JSON, since reading it can call no code, whatever somebody has written there.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import BinaryIO

_SIZES = struct.Struct("<IQ")  # bytes of the head, bytes behind it
MOST_HEAD = 64 << 20  # bytes
MOST_BODY = 1 << 30


class TapeError(Exception):
    """A tape cannot be read, or says what no sketch can draw; the message is a sentence."""


@dataclass(frozen=True)
class Message:
    """One step of a tape.

    Attributes
    ----------
    kind : str
    value : object
        As JSON has it.
    body : bytes
        Arrays, one behind the other; `value` says where each begins.
    """

    kind: str
    value: object = None
    body: bytes = b""

    def __bytes__(self) -> bytes:
        head = json.dumps([self.kind, self.value], separators=(",", ":")).encode()
        return _SIZES.pack(len(head), len(self.body)) + head + self.body


def read_messages(file: BinaryIO, most_head: int = MOST_HEAD) -> Iterator[Message]:
    """Yield the messages of a tape; one that was cut off at the end is left out.

    Parameters
    ----------
    file : binary file
    most_head : int, bytes
        What the JSON of one message may be long.

    Raises
    ------
    TapeError
        If it is none.
    """
    while len(sizes := file.read(_SIZES.size)) == _SIZES.size:
        head_size, body_size = _SIZES.unpack(sizes)
        if head_size > most_head or body_size > MOST_BODY:
            raise TapeError("The recording has a part of impossible size.")
        head, body = file.read(head_size), file.read(body_size)
        if len(head) < head_size or len(body) < body_size:
            return
        yield _message(head, body)


def _message(head: bytes, body: bytes) -> Message:
    try:
        kind, value = json.loads(head)
    except (TypeError, ValueError, RecursionError):
        raise TapeError("The recording is damaged.") from None
    if not isinstance(kind, str):
        raise TapeError("The recording is damaged.")
    return Message(kind, value, body)
