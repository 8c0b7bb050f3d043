"""Where data goes to: files beside the sketch, which appear whole or not at all."""

from __future__ import annotations

import gzip
from os import PathLike

from sketchkit.assets.output import write_file
from sketchkit.assets.paths import sketch_folder
from sketchkit.core.errors import SketchError, kind_of, shown


def save_bytes(caller: str, filename: str | PathLike[str], data: bytes) -> None:
    """Write a file; one whose name ends in .gz is packed.

    Parameters
    ----------
    caller : str
        The function that was called, for messages.
    filename : str
        Without a folder it means the sketch's; folders that are missing are made.
    data : bytes
        What it will hold.
    """
    if not isinstance(filename, str | PathLike):
        raise SketchError(
            f"{caller}() takes the name of a file.", got=f"{kind_of(filename)}: {shown(filename)}"
        )
    path = sketch_folder() / filename
    if path.suffix.lower() == ".gz":
        data = gzip.compress(data, mtime=0)  # the same at every run
    try:
        write_file(path, data)
    except OSError as error:
        raise SketchError(f"{filename} cannot be written: {error.strerror}.") from None


def save_text(caller: str, filename: str | PathLike[str], text: str) -> None:
    """Write a file of text, in UTF-8."""
    save_bytes(caller, filename, text.encode("utf-8", "surrogatepass"))
