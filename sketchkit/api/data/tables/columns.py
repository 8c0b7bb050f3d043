"""The columns of a table: added, removed, given titles and types."""

from __future__ import annotations

from collections.abc import Sequence

from sketchkit.api.data.faults import whole
from sketchkit.api.data.tables.parts import Place, TableParts, kind_from
from sketchkit.data.columns import BLANK, Column, ColumnKind


class Columns(TableParts):
    """`addColumn()`, `getColumnCount()` and the like."""

    def addColumn(self, title: str | None = None, type: int | str = ColumnKind.STRING) -> None:
        """Add a column at the right; without a type it is one for text.

        Parameters
        ----------
        title : str, optional
            Its title.
        type : int or str, optional
            What it holds: `Table.STRING`, `INT`, `LONG`, `FLOAT`, `DOUBLE` or `CATEGORY`.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.addColumn("height", Table.FLOAT)
        >>> table.getColumnTitles()
        ['name', 'age', 'height']
        """
        self.insertColumn(len(self._columns), title, type)

    def insertColumn(
        self, index: int, title: str | None = None, type: int | str = ColumnKind.STRING
    ) -> None:
        """Add a column before the one at a place."""
        kind = kind_from(type)
        place = whole("insertColumn", index)
        if place != len(self._columns):
            place = self._column_place("insertColumn", place)
        self._has_titles |= title is not None
        self._columns.insert(place, Column([BLANK[kind]] * self._count, kind, title))

    def removeColumn(self, column: Place) -> None:
        """Remove a column, with all of its cells.

        Parameters
        ----------
        column : int or str
            The number, from 0, or the title.

        Raises
        ------
        SketchError
            If there is no such column.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.removeColumn("age")
        >>> table.getColumnTitles()
        ['name']
        """
        del self._columns[self._column_place("removeColumn", column)]

    def getColumnCount(self) -> int:
        """Return how many columns there are.

        Examples
        --------
        >>> loadTable("ages.csv", "header").getColumnCount()
        2
        """
        return len(self._columns)

    def setColumnCount(self, newCount: int) -> None:
        """Have so many columns: remove the last ones, or add some for text."""
        del self._columns[whole("setColumnCount", newCount) :]
        self._widen(newCount)

    def getColumnTitle(self, col: int) -> str | None:
        """Return the title of a column; None if it has none."""
        if not self._has_titles:
            return None
        return self._columns[self._column_place("getColumnTitle", col)].title

    def getColumnTitles(self) -> list[str | None] | None:
        """Return all titles; None if the table has none."""
        return [column.title for column in self._columns] if self._has_titles else None

    def hasColumnTitles(self) -> bool:
        """Return whether the columns have titles."""
        return self._has_titles

    def setColumnTitle(self, column: int, title: str | None) -> None:
        """Give a column a title; columns that are missing are added."""
        place = whole("setColumnTitle", column)
        self._widen(place + 1)
        self._has_titles = True
        self._columns[place].title = title

    def setColumnTitles(self, titles: Sequence[str | None] | None) -> None:
        """Give the columns titles; columns that are missing are added. None takes them all away."""
        self._has_titles = titles is not None
        self._widen(len(titles or ()))
        for place, column in enumerate(self._columns):
            column.title = titles[place] if titles and place < len(titles) else None

    def removeTitleRow(self) -> list[str | None]:
        """Make the first row the titles, and return it."""
        self._row_place("removeTitleRow", 0)
        titles = self._texts(0)
        for column in self._columns:
            del column.cells[0]
        self._count -= 1
        self.setColumnTitles(titles)
        return titles

    def getColumnIndex(self, columnName: str) -> int:
        """Return the number of a column, from 0."""
        return self._column_place("getColumnIndex", columnName)

    def checkColumnIndex(self, title: str) -> int:
        """Return the number of a column, which is added if there is none of that title."""
        if title not in self._titles():
            self.addColumn(title)
        return self.getColumnIndex(title)

    def getColumnType(self, column: Place) -> int:
        """Return what a column holds: `Table.STRING`, `Table.INT`, ..."""
        return int(self._columns[self._column_place("getColumnType", column)].kind)

    def getColumnTypes(self) -> list[int]:
        """Return what each column holds: `Table.STRING`, `Table.INT`, ..."""
        return [int(column.kind) for column in self._columns]

    def setColumnType(self, column: Place, columnType: int | str) -> None:
        """Have a column hold `Table.INT`, `Table.FLOAT`, ..., or "int", "float", ...

        What is in it is read as that; text that is no number becomes 0 or NaN.
        """
        kind = kind_from(columnType)
        if isinstance(column, str) and column not in self._titles():
            self.addColumn(column)
        self._columns[self._column_place("setColumnType", column)].convert(kind, self._missing)

    def setColumnTypes(self, types: Sequence[int | str]) -> None:
        """Have the columns hold what a list says; columns that are missing are added."""
        self._widen(len(types))
        for place, kind in enumerate(types):
            self.setColumnType(place, kind)

    def setTableType(self, type: int | str) -> None:
        """Have all columns hold the same."""
        for place in range(len(self._columns)):
            self.setColumnType(place, type)

    def _widen(self, count: int) -> None:
        while len(self._columns) < count:
            self._columns.append(Column([None] * self._count))
