"""What `loadTable()` and `saveTable()` can be told: `"header, tsv"`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import PurePath

from sketchkit.core.errors import SketchError, nearest

LOADED = ("csv", "tsv")
SAVED = ("csv", "tsv", "html")
WORDS = ("header", *LOADED, "dictionary=FILE", "encoding=NAME")
SPREADSHEETS = ("ods", "bin", "xls", "xlsx")  # what is often tried


@dataclass(frozen=True)
class Options:
    """How a table is read.

    Attributes
    ----------
    kind : str
        "csv" or "tsv": what stands between cells.
    has_header : bool
        Whether the first line has titles.
    encoding : str or None
        How its text is encoded, if it is not UTF-8.
    dictionary : str or None
        A file with the title and the type of each column.
    """

    kind: str
    has_header: bool = False
    encoding: str | None = None
    dictionary: str | None = None


def ending_of(filename: str) -> str:
    """Return how a file's name ends, without the point, and .gz aside."""
    name = filename.partition("?")[0].lower().removesuffix(".gz")
    return PurePath(name).suffix.removeprefix(".")


def read_options(caller: str, filename: str, options: str | None) -> Options:
    """Return how to read a table.

    Raises
    ------
    SketchError
        If an option is not known, or nothing says what kind of file it is.

    Examples
    --------
    >>> read_options("loadTable", "ages.csv", "header").has_header
    True
    """
    ending = ending_of(filename)
    kind = ending if ending in LOADED else None
    has_header = False
    named: dict[str, str] = {}
    for option in filter(None, map(str.strip, (options or "").split(","))):
        name, sign, value = option.partition("=")
        if option in LOADED:
            kind = option
        elif option == "header":
            has_header = True
        elif sign and name in ("encoding", "dictionary"):
            named[name] = value
        else:
            raise _unknown(caller, option)
    if kind is None:
        raise SketchError(
            f"{caller}() cannot tell what stands between the cells of {filename}.",
            hint="Save it as CSV from your spreadsheet."
            if ending in SPREADSHEETS
            else 'Write "csv" for commas, or "tsv" for tabs, as second argument.',
        )
    return Options(kind, has_header, named.get("encoding"), named.get("dictionary"))


def saved_kind(filename: str, options: str | None) -> str:
    """Return what kind of file to write.

    Raises
    ------
    SketchError
        If it is none that can be written.
    """
    given = [option.strip() for option in (options or "").split(",") if option.strip()]
    kind = given[-1] if given else ending_of(filename)
    if kind in SAVED:
        return kind
    raise SketchError(
        'A table is saved as "csv", "tsv" or "html": by the end of the name, or as an option.',
        got=repr(given[-1] if given else filename),
    )


def _unknown(caller: str, option: str) -> SketchError:
    close = nearest(option, WORDS)
    return SketchError(
        f"{caller}() knows the options {', '.join(WORDS)}.",
        got=repr(option),
        hint=f"Do you mean {close!r}?" if close else None,
    )
