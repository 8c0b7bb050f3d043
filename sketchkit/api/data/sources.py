"""Where data comes from: a file of the sketch, or an address in the internet."""

from __future__ import annotations

import gzip
import zlib

from sketchkit.assets.network import fetch, is_address
from sketchkit.assets.paths import find_file
from sketchkit.core.errors import SketchError
from sketchkit.core.notices import warn_once
from sketchkit.data.text_files import decoded


def read_bytes(caller: str, filename: str) -> bytes:
    """Return what a file holds; one whose name ends in .gz is unpacked.

    Parameters
    ----------
    caller : str
        The function that was called, for messages.
    filename : str
        In the sketch's `data` folder, or beside it; or an address, "https://...".

    Raises
    ------
    SketchError
        If there is no such file, or it cannot be read.
    """
    if is_address(filename):
        data = fetch(caller, filename)
    else:
        try:
            data = find_file(caller, filename).read_bytes()
        except OSError as error:
            raise SketchError(f"{filename} cannot be read: {error.strerror}.") from None
    if not str(filename).lower().endswith(".gz"):
        return data
    try:
        return gzip.decompress(data)
    except (OSError, EOFError, zlib.error):
        raise SketchError(f"{filename} is no file that gzip has packed.") from None


def read_text(caller: str, filename: str, encoding: str | None = None) -> str:
    """Return the text that a file holds: UTF-8, or in the given encoding.

    Text in anything else is read as Latin-1, and that is remarked on.
    """
    data = read_bytes(caller, filename)
    if encoding is not None:
        try:
            return data.decode(encoding).removeprefix("\ufeff")
        except (LookupError, UnicodeDecodeError):
            raise SketchError(f"{filename} is no text in the encoding {encoding!r}.") from None
    text, is_certain = decoded(data)
    if not is_certain:
        warn_once(
            f"{filename} is no text in UTF-8; it is read as Latin-1. If letters are wrong, save it"
            " as UTF-8 in your editor."
        )
    return text
