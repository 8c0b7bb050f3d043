"""Tables as text: cells with commas (CSV) or tabs (TSV) between them, and as a page of HTML."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from html import escape

from sketchkit.data.malformed import malformed_at
from sketchkit.data.text_files import lines_of, unified

Cells = Sequence[str | None]

_PLAIN = re.compile(r'[^,"\n]*')
_NEEDS_QUOTES = re.compile(r'[",\r\n]|^ | $')


def read_csv(text: str) -> list[list[str]]:
    r"""Return the cells of each line of a text with commas.

    A cell in quotes may have commas, line ends and doubled quotes in it.

    Raises
    ------
    MalformedError
        If a quote stands where none can be, or is not closed.

    Examples
    --------
    >>> read_csv('a,"b, c"\n"say ""hi"" twice",')
    [['a', 'b, c'], ['say "hi" twice', '']]
    """
    text = unified(text)
    rows: list[list[str]] = []
    place = 0
    while place < len(text):
        row: list[str] = []
        rows.append(row)
        while True:
            cell, place = _cell(text, place)
            row.append(cell)
            if not text.startswith(",", place):
                break
            place += 1
        place += 1  # over the line's end
    return rows


def read_tsv(text: str) -> list[list[str]]:
    r"""Return the cells of each line of a text with tabs; quotes mean nothing there.

    Examples
    --------
    >>> read_tsv('a\t"b"\nc')
    [['a', '"b"'], ['c']]
    """
    return [line.split("\t") for line in lines_of(text)]


def write_csv(rows: Iterable[Cells]) -> str:
    """Return rows of cells as text with commas.

    Examples
    --------
    >>> print(write_csv([["a", 'a "b" c', None], ["1, 2", " x", ""]]), end="")
    a,"a ""b"" c",
    "1, 2"," x",
    """
    return "".join(f"{','.join(map(_csv_cell, row))}\n" for row in rows)


def write_tsv(rows: Iterable[Cells]) -> str:
    r"""Return rows of cells as text with tabs.

    Examples
    --------
    >>> write_tsv([["a", None], ["b", "c"]])
    'a\t\nb\tc\n'
    """
    return "".join("\t".join(cell or "" for cell in row) + "\n" for row in rows)


def write_html(titles: Cells | None, rows: Iterable[Cells]) -> str:
    """Return a page with a table, that shows in a browser.

    Examples
    --------
    >>> print(write_html(["name"], [["a < b"]]))
    <!DOCTYPE html>
    <html>
    <head>
      <meta charset="utf-8">
    </head>
    <body>
      <table>
        <tr><th>name</th></tr>
        <tr><td>a &lt; b</td></tr>
      </table>
    </body>
    </html>
    <BLANKLINE>
    """
    lines = [*_html_row("th", titles), *(line for row in rows for line in _html_row("td", row))]
    head = '<!DOCTYPE html>\n<html>\n<head>\n  <meta charset="utf-8">\n</head>\n<body>\n  <table>\n'
    return head + "".join(lines) + "  </table>\n</body>\n</html>\n"


def _html_row(tag: str, cells: Cells | None) -> Iterator[str]:
    if cells is not None:
        inner = "".join(f"<{tag}>{escape(cell or '')}</{tag}>" for cell in cells)
        yield f"    <tr>{inner}</tr>\n"


def _cell(text: str, start: int) -> tuple[str, int]:
    """Return the cell that begins at a place, and where it ends: before a comma or a line's end."""
    if text.startswith('"', start):
        return _quoted_cell(text, start)
    pieces: list[str] = []
    place = start
    while True:
        found = _PLAIN.match(text, place)
        assert found is not None
        pieces.append(found[0])
        place = found.end()
        if not text.startswith('"', place):
            return "".join(pieces), place
        if not text.startswith('""', place):
            problem = "A cell with quotes in it must stand in quotes itself, and those be doubled"
            raise malformed_at(text, place, problem)
        pieces.append('"')
        place += 2


def _quoted_cell(text: str, start: int) -> tuple[str, int]:
    """Return a cell in quotes. Single quotes within it count as they are."""
    pieces: list[str] = []
    place = start + 1
    while True:
        quote = text.find('"', place)
        if quote < 0:
            raise malformed_at(text, start, "A quote is opened and not closed")
        pieces.append(text[place:quote])
        following = text[quote + 1 : quote + 2]
        if following in ("", ",", "\n"):
            return "".join(pieces), quote + 1
        pieces.append('"')
        place = quote + (2 if following == '"' else 1)


def _csv_cell(cell: str | None) -> str:
    if cell and _NEEDS_QUOTES.search(cell):
        return '"' + cell.replace('"', '""') + '"'
    return cell or ""
