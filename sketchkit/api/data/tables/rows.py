"""The rows of a table: added, removed, sorted."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import overload

from sketchkit.api.data.faults import whole, wrong_kind
from sketchkit.api.data.tables.parts import Place, TableParts
from sketchkit.api.data.tables.table_row import TableRow
from sketchkit.core.errors import SketchError, shown
from sketchkit.data.columns import BLANK, ColumnKind
from sketchkit.data.ordering import sort_in_place

RowSource = TableRow | Sequence[object]


class Rows(TableParts):
    """`addRow()`, `rows()`, `sort()` and the like."""

    def getRowCount(self) -> int:
        """Return how many rows there are; a line of titles is none of them.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> for i in range(table.getRowCount()):
        ...     println(table.getString(i, "name"))
        Ida
        Ben
        """
        return self._count

    def setRowCount(self, newCount: int) -> None:
        """Have so many rows: remove the last ones, or add blank ones."""
        self._resize(max(whole("setRowCount", newCount), 0))

    def lastRowIndex(self) -> int:
        """Return the number of the last row; -1 if there are none."""
        return self._count - 1

    def getRow(self, row: int) -> TableRow:
        """Return a row.

        Parameters
        ----------
        row : int
            Its number, from 0.

        Raises
        ------
        SketchError
            If there is no such row.

        Examples
        --------
        >>> row = loadTable("ages.csv", "header").getRow(1)
        >>> row.getString("name"), row.getInt("age")
        ('Ben', 9)
        """
        return TableRow(self, self._row_place("getRow", row))

    def rows(self, indices: Iterable[int] | None = None) -> list[TableRow]:
        """Return a list of all rows, or of some.

        Parameters
        ----------
        indices : list of int, optional
            The numbers of those rows, from 0.

        Notes
        -----
        `for row in table` goes through all rows, too.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> for row in table.rows():
        ...     println(row.getString("name"), row.getInt("age"))
        Ida 12
        Ben 9
        """
        places = range(self._count) if indices is None else indices
        return [self.getRow(place) for place in places]

    def addRow(self, source: RowSource | None = None) -> TableRow:
        """Add a row at the end, and return it.

        Parameters
        ----------
        source : TableRow or list, optional
            A row to copy, or a list of values; without it the row is blank.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> row = table.addRow()
        >>> row.setString("name", "Cleo")
        >>> row.setInt("age", 30)
        >>> table.addRow(["Dora", 7]).getInt("age")
        7
        >>> table.getStringColumn("name")
        ['Ida', 'Ben', 'Cleo', 'Dora']
        """
        if source is None:
            self._resize(self._count + 1)
            return TableRow(self, self._count - 1)
        return self.setRow(self._count, source)

    def addRows(self, source: Iterable[TableRow]) -> None:
        """Add the rows of another table."""
        for row in list(source):
            self.addRow(row)

    def setRow(self, row: int, source: RowSource) -> TableRow:
        """Have a row hold what another one, or a list, holds; and return it."""
        is_list = isinstance(source, Sequence) and not isinstance(source, str)
        if not is_list and not isinstance(source, TableRow):
            raise SketchError(
                "A row is made from another row, or from a list of its values.", got=shown(source)
            )
        values = list(source) if isinstance(source, Sequence) else source.texts()
        place = whole("setRow", row)
        self._reach(place, max(len(values) - 1, 0))
        for column, value in zip(self._columns, values, strict=False):
            column.put(place, value, self._missing)
        return TableRow(self, place)

    def insertRow(self, insert: int, columnData: RowSource) -> None:
        """Add a row before the one at a place."""
        place = whole("insertRow", insert)
        if place != self._count:
            self._row_place("insertRow", place)
        for column in self._columns:
            column.cells.insert(place, BLANK[column.kind])
        self._count += 1
        self.setRow(place, columnData)

    def removeRow(self, row: int) -> None:
        """Remove a row; those behind it move up.

        Parameters
        ----------
        row : int
            Its number, from 0.

        Raises
        ------
        SketchError
            If there is no such row.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.removeRow(0)
        >>> table.getString(0, "name")
        'Ben'
        """
        place = self._row_place("removeRow", row)
        for column in self._columns:
            del column.cells[place]
        self._count -= 1

    def clearRows(self) -> None:
        """Remove all rows; the columns stay.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.clearRows()
        >>> table.getRowCount(), table.getColumnCount()
        (0, 2)
        """
        self._resize(0)

    def sort(self, column: Place) -> None:
        """Sort the rows by a column: text by the alphabet, numbers with the smallest first.

        Parameters
        ----------
        column : int or str
            The number, from 0, or the title.

        See Also
        --------
        sortReverse

        Notes
        -----
        Text that consists of digits is still text, and "12" comes before "9": give the column a
        type with `setColumnType()`.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.setColumnType("age", Table.INT)
        >>> table.sort("age")
        >>> table.getStringColumn("name")
        ['Ben', 'Ida']
        """
        self._sort("sort", column)

    def sortReverse(self, column: Place) -> None:
        """Sort the rows by a column, the other way around."""
        self._sort("sortReverse", column)

    def _sort(self, name: str, column: Place) -> None:
        key = self._columns[self._column_place(name, column)]
        if key.kind is ColumnKind.STRING:
            ranks: list[object] = [str(cell or "").lower() for cell in key.cells]
        else:
            ranks = list(key.cells)
        order = list(range(self._count))
        sort_in_place(order, ranks.__getitem__, reverse=name == "sortReverse")
        for each in self._columns:
            each.cells = [each.cells[row] for row in order]

    def __iter__(self) -> Iterator[TableRow]:
        return iter(self.rows())

    @overload
    def __getitem__(self, row: int) -> TableRow: ...
    @overload
    def __getitem__(self, row: slice) -> list[TableRow]: ...
    def __getitem__(self, row: int | slice) -> TableRow | list[TableRow]:
        if isinstance(row, slice):
            return self.rows()[row]
        if isinstance(row, str):
            hint = f"getStringColumn({row!r}) gives a column."
            raise wrong_kind("getRow", "the number of a row", row, hint)
        place = whole("getRow", row)
        return self.getRow(place + self._count if -self._count <= place < 0 else place)

    def __len__(self) -> int:
        return self._count

    def __bool__(self) -> bool:
        return True  # there is a table, even if it has no rows
