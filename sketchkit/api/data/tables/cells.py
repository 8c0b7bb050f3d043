"""Single cells of a table, read and changed; and whole columns and rows of them, read."""

from __future__ import annotations

from sketchkit.api.data.faults import fraction, whole, wrong_kind
from sketchkit.api.data.tables.parts import Place, TableParts
from sketchkit.core.errors import SketchError
from sketchkit.data.columns import WHOLE, Column, ColumnKind
from sketchkit.data.java_numbers import double_text, float_text


class Cells(TableParts):
    """`getInt()`, `setString()` and the like. A column is its number, from 0, or its title."""

    def getString(self, row: int, column: Place) -> str | None:
        """Return a cell as text.

        Parameters
        ----------
        row : int
            Its row, counted from 0.
        column : int or str
            Its column: the number, from 0, or the title.

        Returns
        -------
        str or None
            None for a cell that was never set.

        Raises
        ------
        SketchError
            If there is no such row or column.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.getString(0, "name"), table.getString(0, 1)
        ('Ida', '12')
        """
        cells, place = self._cell("getString", row, column)
        return cells.text(place, self._missing)

    def getInt(self, row: int, column: Place) -> int:
        """Return a cell as a whole number; what stands behind the point is cut off.

        Parameters
        ----------
        row : int
            Its row, counted from 0.
        column : int or str
            Its column: the number, from 0, or the title.

        Returns
        -------
        int
            0 for text that is no number; `setMissingInt()` says what else.

        Raises
        ------
        SketchError
            If there is no such row or column.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.getInt(0, "age") + table.getInt(1, "age"), table.getInt(0, "name")
        (21, 0)
        """
        cells, place = self._cell("getInt", row, column)
        return cells.whole(place, self._missing)

    def getLong(self, row: int, column: Place) -> int:
        """Return a cell as a whole number of any size; 0 if it is none."""
        cells, place = self._cell("getLong", row, column)
        return cells.long(place, self._missing)

    def getFloat(self, row: int, column: Place) -> float:
        """Return a cell as a number.

        Parameters
        ----------
        row : int
            Its row, counted from 0.
        column : int or str
            Its column: the number, from 0, or the title.

        Returns
        -------
        float
            NaN for text that is no number; `setMissingFloat()` says what else.

        Raises
        ------
        SketchError
            If there is no such row or column.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.getFloat(1, "age") / 2
        4.5
        """
        cells, place = self._cell("getFloat", row, column)
        return cells.fraction(place, self._missing, self._missing.fraction)

    def getDouble(self, row: int, column: Place) -> float:
        """Return a cell as a number; NaN if it is none."""
        cells, place = self._cell("getDouble", row, column)
        return cells.fraction(place, self._missing, self._missing.double)

    def setString(self, row: int, column: Place, value: str | None) -> None:
        """Set a cell to a text; the table grows if it is too small.

        Parameters
        ----------
        row : int
            Its row, counted from 0. A row beyond the end adds rows.
        column : int or str
            The number, from 0, or the title. A title that no column has adds a column.
        value : str
            The text; None for a missing one.

        Examples
        --------
        >>> table = Table()
        >>> table.setString(0, "name", "Ida")
        >>> table.setString(1, "name", "Ben")
        >>> table.getRowCount(), table.getString(1, "name")
        (2, 'Ben')
        """
        if value is not None and not isinstance(value, str):
            hint = f"str({value!r}) makes text of it."
            raise wrong_kind("setString", "text", value, hint, place=column)
        if isinstance(column, str) and column not in self._titles():
            self._add_titled(column)
        cells, place = self._settable("setString", row, column)
        if cells.kind is not ColumnKind.STRING:
            raise self._wrong_column("text", column, cells)
        cells.cells[place] = value

    def setInt(self, row: int, column: Place, value: int) -> None:
        """Set a cell to a whole number: as text, if the column has text.

        Parameters
        ----------
        row : int
            Its row, counted from 0. A row beyond the end adds rows.
        column : int or str
            Its column: the number, from 0, or the title.
        value : int
            The number; a fraction is cut off.

        Raises
        ------
        SketchError
            If the column is one for fractions, or no column has the title.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.setInt(0, "age", 13)
        >>> table.getInt(0, "age"), table.getString(0, "age")
        (13, '13')
        """
        number = whole("setInt", value, place=column)
        cells, place = self._settable("setInt", row, column)
        if cells.kind is ColumnKind.STRING:
            cells.cells[place] = str(number)
        elif cells.kind in (ColumnKind.INT, ColumnKind.LONG, ColumnKind.CATEGORY):
            cells.cells[place] = number
        else:
            raise self._wrong_column("whole numbers", column, cells)

    setLong = setInt

    def setFloat(self, row: int, column: Place, value: float) -> None:
        """Set a cell to a number: as text, if the column has text.

        Parameters
        ----------
        row : int
            Its row, counted from 0. A row beyond the end adds rows.
        column : int or str
            Its column: the number, from 0, or the title.
        value : float
            The number; in text seven digits of it are kept. `setDouble()` keeps all.

        Raises
        ------
        SketchError
            If the column is one for whole numbers, or no column has the title.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.addColumn("height", Table.FLOAT)
        >>> table.setFloat(0, "height", 1.52)
        >>> table.getFloat(0, "height")
        1.52
        """
        self._set_fraction("setFloat", row, column, value)

    def setDouble(self, row: int, column: Place, value: float) -> None:
        """Set a cell to a number: as text, if the column has text."""
        self._set_fraction("setDouble", row, column, value)

    def getStringColumn(self, column: Place) -> list[str | None]:
        """Return a column as a list of texts.

        Parameters
        ----------
        column : int or str
            The number, from 0, or the title.

        Examples
        --------
        >>> table = loadTable("ages.csv", "header")
        >>> table.getStringColumn("name")
        ['Ida', 'Ben']
        """
        return [self.getString(row, column) for row in range(self._count)]

    def getIntColumn(self, column: Place) -> list[int]:
        """Return a column as a list of whole numbers."""
        return [self.getInt(row, column) for row in range(self._count)]

    def getLongColumn(self, column: Place) -> list[int]:
        """Return a column as a list of whole numbers of any size."""
        return [self.getLong(row, column) for row in range(self._count)]

    def getFloatColumn(self, column: Place) -> list[float]:
        """Return a column as a list of numbers."""
        return [self.getFloat(row, column) for row in range(self._count)]

    def getDoubleColumn(self, column: Place) -> list[float]:
        """Return a column as a list of numbers."""
        return [self.getDouble(row, column) for row in range(self._count)]

    def getStringRow(self, row: int) -> list[str | None]:
        """Return a row as a list of texts."""
        return [self.getString(row, column) for column in range(len(self._columns))]

    def getIntRow(self, row: int) -> list[int]:
        """Return a row as a list of whole numbers."""
        return [self.getInt(row, column) for column in range(len(self._columns))]

    def getLongRow(self, row: int) -> list[int]:
        """Return a row as a list of whole numbers of any size."""
        return [self.getLong(row, column) for column in range(len(self._columns))]

    def getFloatRow(self, row: int) -> list[float]:
        """Return a row as a list of numbers."""
        return [self.getFloat(row, column) for column in range(len(self._columns))]

    def getDoubleRow(self, row: int) -> list[float]:
        """Return a row as a list of numbers."""
        return [self.getDouble(row, column) for column in range(len(self._columns))]

    def setMissingString(self, value: str | None) -> None:
        """Say which text stands for a cell that is missing."""
        self._missing.text = value

    def setMissingInt(self, value: int) -> None:
        """Say what `getInt()` returns for what is no number."""
        self._missing.whole = value

    def setMissingLong(self, value: int) -> None:
        """Say what `getLong()` returns for what is no number."""
        self._missing.long = value

    def setMissingFloat(self, value: float) -> None:
        """Say what `getFloat()` returns for what is no number."""
        self._missing.fraction = value

    def setMissingDouble(self, value: float) -> None:
        """Say what `getDouble()` returns for what is no number."""
        self._missing.double = value

    def _set_fraction(self, name: str, row: int, column: Place, value: float) -> None:
        number = fraction(name, value, place=column)
        cells, place = self._settable(name, row, column)
        if cells.kind is ColumnKind.STRING:
            cells.cells[place] = float_text(number) if name == "setFloat" else double_text(number)
        elif cells.kind in (ColumnKind.FLOAT, ColumnKind.DOUBLE):
            cells.cells[place] = number
        else:
            raise self._wrong_column("numbers with a fraction", column, cells)

    def _settable(self, name: str, row: int, column: Place) -> tuple[Column, int]:
        is_title = isinstance(column, str)
        wanted = self._column_place(name, column) if is_title else whole(name, column)
        self._reach(whole(name, row), wanted)
        return self._columns[wanted], whole(name, row)

    def _add_titled(self, title: str) -> None:
        self._has_titles = True
        self._columns.append(Column([None] * self._count, title=title))

    def _wrong_column(self, what: str, column: Place, cells: Column) -> SketchError:
        kind = cells.kind
        setter = "setInt()" if kind in (*WHOLE, ColumnKind.CATEGORY) else "setFloat()"
        setter = "setString()" if kind is ColumnKind.STRING else setter
        return SketchError(
            f"Column {column!r} is a Table.{kind.name} and cannot hold {what}.",
            hint=f"Use {setter}, or setColumnType({column!r}, Table.STRING).",
        )
