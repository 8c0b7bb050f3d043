"""What is fetched from the internet: in a window only, where no picture depends on it."""

from __future__ import annotations

import re

from sketchkit.core.errors import SketchError, shown

PATIENCE = 10.0  # seconds without an answer

_is_allowed = False


def allow_network(is_allowed: bool) -> None:
    """Say whether the running sketch may read from the internet."""
    global _is_allowed
    _is_allowed = is_allowed


def is_address(filename: object) -> bool:
    """Return whether a name is an address in the internet.

    Examples
    --------
    >>> is_address("https://example.org/a.csv"), is_address("a.csv")
    (True, False)
    """
    return isinstance(filename, str) and bool(re.match("https?://", filename))


def fetch(caller: str, address: str) -> bytes:
    """Return what an address holds.

    Raises
    ------
    SketchError
        If there is no answer, or the sketch may not ask.
    """
    got = f"{caller}({shown(address)})"
    if not _is_allowed:
        raise SketchError(
            f"{caller}() does not read from the internet here: every run must give the same.",
            got=got,
            hint="Download the file into the sketch's data folder.",
        )
    from urllib.error import URLError  # 50 ms to import, and most sketches never ask
    from urllib.parse import urlsplit
    from urllib.request import Request, urlopen

    try:
        request = Request(address, headers={"User-Agent": "sketchkit"})
        with urlopen(request, timeout=PATIENCE) as answer:
            data: bytes = answer.read()
    except (OSError, ValueError) as error:
        reason = error.reason if isinstance(error, URLError) else error
        host = urlsplit(address).hostname or address
        raise SketchError(
            f"{caller}() got nothing from {host}: {reason}.",
            got=got,
            hint="Is there a network, and is the address right?",
        ) from None
    return data
