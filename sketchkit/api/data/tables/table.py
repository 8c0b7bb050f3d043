"""Table: cells in rows and columns, read from a file and written into one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from os import PathLike

from sketchkit.api.data.faults import unreadable
from sketchkit.api.data.lists.value_list import Writes
from sketchkit.api.data.saving import save_text
from sketchkit.api.data.sources import read_text
from sketchkit.api.data.tables.cleaning import Cleaning
from sketchkit.api.data.tables.options import Options, ending_of, read_options, saved_kind
from sketchkit.api.data.tables.table_row import TableRow
from sketchkit.core.errors import SketchError
from sketchkit.data.columns import ColumnKind, Missing
from sketchkit.data.delimited import read_csv, read_tsv, write_csv, write_html, write_tsv
from sketchkit.data.malformed import MalformedError


class Table(Cleaning):
    """Cells in rows and columns.

    Parameters
    ----------
    source : str, or rows, optional
        The name of a file, as for `loadTable()`; or rows of another table, or dictionaries of
        the cells of each row.
    options : str, optional
        Those of `loadTable()`.

    Notes
    -----
    A column is its number, from 0, or its title. `for row in table` goes through the rows;
    `table[0]` is the first of them.

    Examples
    --------
    >>> table = Table()
    >>> table.addColumn("name")
    >>> table.addColumn("age", Table.INT)
    >>> row = table.addRow(["Ida", 12])
    >>> row = table.addRow(["Ben", 9])
    >>> table.sort("age")
    >>> for row in table.rows():
    ...     println(row.getString("name"), row.getInt("age"))
    Ben 9
    Ida 12
    >>> table.findRow("Ida", "name").getInt("age")
    12
    """

    STRING = int(ColumnKind.STRING)
    INT = int(ColumnKind.INT)
    LONG = int(ColumnKind.LONG)
    FLOAT = int(ColumnKind.FLOAT)
    DOUBLE = int(ColumnKind.DOUBLE)
    CATEGORY = int(ColumnKind.CATEGORY)

    def __init__(
        self,
        source: str | Iterable[TableRow | Mapping[str, object]] | None = None,
        options: str | None = None,
    ) -> None:
        self._columns = []
        self._count = 0
        self._has_titles = False
        self._missing = Missing()
        self._source = "This table"
        if isinstance(source, str | PathLike):
            self._load("Table", str(source), options)
        elif source is not None:
            for row in source:
                self._take(row)

    @classmethod
    def read(cls, caller: str, filename: str, options: str | None) -> Table:
        """Return the table that a file holds; `caller` is the function for messages."""
        table = cls()
        table._load(caller, filename, options)
        return table

    @staticmethod
    def extensionOptions(loading: bool, filename: str, options: str | None = None) -> str | None:
        """Return the options that a file's name and other options come to."""
        kind = ending_of(filename)
        return ",".join(filter(None, [kind, options])) or None

    def typedParse(self, input: str, options: str | None = None) -> Table:
        """Return the table that a file holds, whose columns are as the rows of this one say.

        Each row of this one is the title and the type of a column.
        """
        return Table._typed(self, "typedParse", input, options)

    def copy(self) -> Table:
        """Return another table of the same cells."""
        twin = Table()
        twin._has_titles = self._has_titles
        twin._count = self._count
        twin._missing = Missing(**vars(self._missing))
        twin._source = self._source
        twin._columns = [
            type(c)(list(c.cells), c.kind, c.title, list(c.categories)) for c in self._columns
        ]
        return twin

    def save(self, file: str | PathLike[str], options: str | None = None) -> bool:
        """Write the table into a file: CSV, TSV or HTML, as its name ends or the option says."""
        save_text("save", file, self._written(saved_kind(str(file), options)))
        return True

    def write(self, writer: Writes) -> None:
        """Write the table, with tabs between cells, to what `createWriter()` has made."""
        writer.write(self._written("tsv"))

    def print(self) -> None:
        """Print the table with tabs between cells."""
        print(self._written("tsv"), end="")

    def _written(self, kind: str) -> str:
        titles = self.getColumnTitles()
        if kind == "html":
            return write_html(titles, self._all_texts())
        rows = [*([titles] if titles else []), *self._all_texts()]
        return write_csv(rows) if kind == "csv" else write_tsv(rows)

    def _load(self, caller: str, filename: str, options: str | None) -> None:
        given = read_options(caller, filename, options)
        if given.dictionary:
            types = Table.read(caller, given.dictionary, "tsv")
            self._take_types(types)
        self._source = filename
        text = read_text(caller, filename, given.encoding)
        try:
            rows = read_tsv(text) if given.kind == "tsv" else read_csv(text)
        except MalformedError as error:
            raise unreadable(filename, error) from None
        self._fill(rows, given)

    def _fill(self, rows: list[list[str]], given: Options) -> None:
        if given.has_header and rows:
            self.setColumnTitles(rows.pop(0))
        self._resize(len(rows))
        self._widen(max(map(len, rows), default=0))
        for place, row in enumerate(rows):
            for column, cell in zip(self._columns, row, strict=False):
                column.put(place, cell, self._missing)

    @staticmethod
    def _typed(types: Table, caller: str, filename: str, options: str | None) -> Table:
        table = Table()
        table._take_types(types)
        table._load(caller, filename, options)
        return table

    def _take_types(self, types: Table) -> None:
        has_titles = types.hasColumnTitles()
        self.setColumnTitles(types.getStringColumn("title" if has_titles else 0))
        if types.getColumnCount() > 1:
            names = types.getStringColumn("type" if has_titles else 1)
            self.setColumnTypes([name or "string" for name in names])

    def _take(self, row: TableRow | Mapping[str, object]) -> None:
        if isinstance(row, TableRow):
            if not self._columns:
                self.setColumnTypes(row.getColumnTypes())
                self.setColumnTitles(row.getColumnTitles())
            self.addRow(row)
        elif isinstance(row, Mapping):
            for title in row:
                self.checkColumnIndex(str(title))
            place = self.addRow()._row
            for title, value in row.items():
                self._columns[self.getColumnIndex(str(title))].put(place, value, self._missing)
        else:
            raise SketchError("Table() takes a file's name, rows or dictionaries.", got=repr(row))

    def __repr__(self) -> str:
        return f"Table of {_counted(self._count, 'row')}, {_counted(len(self._columns), 'column')}"


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"
