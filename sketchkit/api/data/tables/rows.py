"""The rows of a table: added, removed, found, sorted."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Sequence

from sketchkit.api.data.faults import whole
from sketchkit.api.data.tables.parts import Place, TableParts
from sketchkit.api.data.tables.table_row import TableRow
from sketchkit.core.errors import SketchError, shown
from sketchkit.data import strings
from sketchkit.data.columns import BLANK, ColumnKind
from sketchkit.data.ordering import sort_in_place

RowSource = TableRow | Sequence[object]


class Rows(TableParts):
    """`addRow()`, `findRow()`, `rows()` and the like."""

    def getRowCount(self) -> int:
        """Return how many rows there are."""
        return self._count

    def setRowCount(self, newCount: int) -> None:
        """Have so many rows: remove the last ones, or add blank ones."""
        self._resize(max(whole("setRowCount", newCount), 0))

    def lastRowIndex(self) -> int:
        """Return the number of the last row; -1 if there are none."""
        return self._count - 1

    def getRow(self, row: int) -> TableRow:
        """Return a row, counted from 0."""
        return TableRow(self, self._row_place("getRow", row))

    def rows(self, indices: Iterable[int] | None = None) -> list[TableRow]:
        """Return all rows, or those of the given numbers."""
        places = range(self._count) if indices is None else indices
        return [self.getRow(place) for place in places]

    def addRow(self, source: RowSource | None = None) -> TableRow:
        """Add a row, and return it: a blank one, a copy of one, or one of a list's values."""
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
        """Remove a row."""
        place = self._row_place("removeRow", row)
        for column in self._columns:
            del column.cells[place]
        self._count -= 1

    def clearRows(self) -> None:
        """Remove all rows; the columns stay."""
        self._resize(0)

    def findRowIndex(self, value: str | None, column: Place) -> int:
        """Return the number of the first row with a text in a column, or -1."""
        return next(self._places(column, lambda text: text == value), -1)

    def findRowIndices(self, value: str | None, column: Place) -> list[int]:
        """Return the numbers of all rows with a text in a column."""
        return list(self._places(column, lambda text: text == value))

    def findRow(self, value: str | None, column: Place) -> TableRow | None:
        """Return the first row with a text in a column; None if there is none."""
        place = self.findRowIndex(value, column)
        return None if place < 0 else TableRow(self, place)

    def findRows(self, value: str | None, column: Place) -> list[TableRow]:
        """Return all rows with a text in a column."""
        return self.rows(self.findRowIndices(value, column))

    def findRowIterator(self, value: str | None, column: Place) -> Iterator[TableRow]:
        """Return what `next()` takes those rows of, one after the other."""
        return iter(self.findRows(value, column))

    def matchRowIndex(self, regexp: str, column: Place) -> int:
        """Return the number of the first row whose text fits a regular expression, or -1."""
        return next(self._places(column, _fits(regexp)), -1)

    def matchRowIndices(self, regexp: str, column: Place) -> list[int]:
        """Return the numbers of all rows whose text fits a regular expression."""
        return list(self._places(column, _fits(regexp)))

    def matchRow(self, regexp: str, column: Place) -> TableRow | None:
        """Return the first row whose text fits a regular expression; None if there is none."""
        place = self.matchRowIndex(regexp, column)
        return None if place < 0 else TableRow(self, place)

    def matchRows(self, regexp: str, column: Place) -> list[TableRow]:
        """Return all rows whose text in a column fits a regular expression."""
        return self.rows(self.matchRowIndices(regexp, column))

    def matchRowIterator(self, value: str, column: Place) -> Iterator[TableRow]:
        """Return what `next()` takes those rows of, one after the other."""
        return iter(self.matchRows(value, column))

    def sort(self, column: Place) -> None:
        """Sort the rows by a column: text by the alphabet, numbers with the smallest first."""
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

    def _places(self, column: Place, is_wanted: Callable[[str | None], bool]) -> Iterator[int]:
        cells = self._columns[self._column_place("findRow", column)]
        return (row for row in range(self._count) if is_wanted(cells.text(row, self._missing)))

    def __iter__(self) -> Iterator[TableRow]:
        return iter(self.rows())

    def __len__(self) -> int:
        return self._count

    def __bool__(self) -> bool:
        return True  # there is a table, even if it has no rows


def _fits(regexp: str) -> Callable[[str | None], bool]:
    try:
        strings.match("", regexp)
    except (re.error, TypeError):
        raise SketchError("A row is matched by a regular expression.", got=shown(regexp)) from None
    return lambda text: text is not None and strings.match(text, regexp) is not None
